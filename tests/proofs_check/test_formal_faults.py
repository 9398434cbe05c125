"""Faults planted in the verified program: in what Coq extracts, and in the readers that feed it.

What is proved is the Coq program. That it becomes this binary, and that documents become its
questions, is tested; here it is tested that those tests notice.
"""

import contextlib
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest

from arrangement.planes import proved
from tests import formal_agreement
from tests.arrangement import test_proved as counts

BUILT = Path(__file__).resolve().parents[2] / "proofs_check" / "formal" / "_build"
SCRIPT = (BUILT.parent / "build.sh").read_text(encoding="utf-8")
#: The sources in the order in which build.sh compiles them.
FILES = [w for w in SCRIPT.partition("-linkpkg")[2].split() if w.endswith((".ml", ".mli"))]


class Fault(NamedTuple):
    """One text of one file, replaced after the place where a definition begins."""

    file: str
    after: str
    old: str
    new: str


#: Of each file, after the words with which a definition begins, texts and what replaces them.
PLANTED = {
    "checker.ml": {
        # Counts.
        "let rec regions ": [
            ("| None -> Big_int_Z.zero", "| None -> Big_int_Z.unit"),
            ("regions look0 restrict0 n0 b'", "Big_int_Z.unit_big_int"),
        ],
        "let rec onto ": [
            ("| Vanishes -> None", "| Vanishes -> onto look0 r b0"),
            ("| Constant -> onto look0 r b0", "| Constant -> None"),
        ],
        "let rec skim ": [("| Plane -> g' :: (skim", "| Plane -> (skim")],
        "let rec faces ": [
            ("(h :: nz) a0", "nz a0"),
            ("Big_int_Z.zero_big_int :: (faces", "Big_int_Z.unit_big_int :: (faces"),
        ],
        "let rec polynomial ": [("difference (poly", "sum (poly")],
        "let rec difference ": [("(Z.sub a b)", "(Z.sub b a)"), ("(Z.opp b)", "b")],
        "let rec mix ": [("(Z.sub (Z.mul a x)", "(Z.add (Z.mul a x)")],
        "let restrict ": [
            ("Z.mul (Z.sgn p) (Z.div q0 c)", "Z.div q0 c"),
            ("Z.sub (Z.mul a g.constant)", "Z.add (Z.mul a g.constant)"),
        ],
        "let primitive0 ": [("(map (fun a -> Z.div a c) f.coefficients)", "f.coefficients")],
        "let look ": [("then Vanishes else Constant", "then Constant else Vanishes")],
        # Lists with witnesses.
        "let sign_at ": [("| Lt -> Minus", "| Lt -> Plus")],
        "let rec product ": [("(Z.mul b y)", "(Z.mul b b)")],
        "let rec shown ": [("(same_sign (sign_at w f) a)", "true")],
        "let rec confirmed0 ": [
            ("Z.eqb left Big_int_Z.zero_big_int", "true"),
            ("Z.ltb last c", "Z.leb last c"),
        ],
        "let complete_faces ": [("fold_right Z.add", "fold_right Z.sub")],
        # Grasps.
        "let check ": [
            ("confirmed (dimension", "true || confirmed (dimension"),
            ("refuted (dimension", "true || refuted (dimension"),
            ("at_one_place part between", "true"),
        ],
    },
    "planes_reader.ml": {
        "let cleared ": [("(Z.divexact common q.qden)", "Z.one")],
        "let plane ": [("Z.neg b", "b"), ("Z.sign a = 0", "Z.sign a = 7")],
        "let planes ": [
            ("List.length normal <> dimension", "false"),
            ("(Some count)", "None"),
            ("most_coordinates + 1", "most_coordinates + 2"),
        ],
        "let signs ": [("'-' -> Minus | '0' -> Zero", "'-' -> Zero | '0' -> Minus")],
        "let face ": [("numerators; denominator }", "numerators; denominator = Z.one }")],
        "let certificate ": [("Z.compare a b", "Z.compare b a")],
    },
    "reader.ml": {
        "let law ": [
            ("if spring then 1", "if spring then 0"),
            ('"stiffness" 1', '"stiffness" 0'),
            ("Z.sign preload.qnum < 0", "false"),
        ],
        "let contact ": [("not (Z.equal", "false && not (Z.equal")],
        "let index ": [("Z.sign i >= 0", "true")],
        "let vector ": [("(Some size)", "None")],
    },
    "tree_reader.ml": {
        "let contact_key ": [("|| string_of_int i <> key", "")],
        "let multiplier ": [("Z.of_int (subject.number i)", "Z.of_int (subject.number i + 1)")],
        "let leaf ": [("else [] in\n  Leaf", "else [] in\n  let others = [] in\n  Leaf")],
        "let orthants ": [("(last c d)", "(last d c)")],
    },
    "grasp_reader.ml": {
        "let document ": [("(Some contacts)", "None")],
    },
    "assembly_reader.ml": {
        "let name ": [("characters > 40", "characters > 41")],
        "let joint ": [("if b = Some a", "if false && b = Some a")],
        "let part ": [
            ("compare places", "compare (List.sort_uniq compare places)"),
            ("number = (fun k -> rank (List.nth places k) crossing)", "number = Fun.id"),
        ],
        "let document ": [("(Some (List.length joints))", "None")],
    },
    "json.ml": {
        "let deepest ": [("1000", "500")],
        "let utf_8 ": [("b >= 0xA0", "b >= 0x80"), ("(a <> 0xED || b < 0xA0)", "true")],
    },
    "main.ml": {
        "let planes ": [("Z.neg f.constant", "f.constant")],
        "let work ": [("complete_faces forms faces", "complete_regions forms faces")],
        "let answer ": [('(1, "refused: "', '(0, "accepted: "')],
        '"--regions"': [("count_regions forms", "Z.succ (count_regions forms)")],
    },
}
FAULTS = [
    Fault(file, after, old, new)
    for file, definitions in PLANTED.items()
    for after, changes in definitions.items()
    for old, new in changes
]


def program_with(fault: Fault, folder: Path) -> Path:
    """Compile the changed file and those after it, which may build on it."""
    at = FILES.index(fault.file)
    before = [name.replace(".ml", ".cmx") for name in FILES[:at] if name.endswith(".ml")]
    for path in BUILT.glob("*.*"):
        if path.suffix in (".ml", ".mli", ".cmi", ".cmx", ".o"):
            shutil.copy(path, folder)
    path = folder / fault.file
    begin, found, rest = path.read_text().partition(fault.after)
    assert found
    assert fault.old in rest
    path.write_text(begin + found + rest.replace(fault.old, fault.new, 1))
    target = folder / "proved-checker"
    compiler = ["ocamlfind", "ocamlopt", "-w", "-a", "-package", "zarith", "-linkpkg"]
    words = [*compiler, *before, *FILES[at:], "-o", target]
    subprocess.run(words, cwd=folder, check=True, timeout=300)
    return target


def noticed(program: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Whether one of the comparisons fails: of counts, of forgeries, of documents, of grasps."""
    monkeypatch.setattr(counts, "PROGRAM", str(program))
    monkeypatch.setattr(proved, "program", lambda: str(program))
    checks = [
        lambda: counts.check_agreement("faults", 40, folder),
        lambda: counts.test_what_is_no_document_of_planes_is_malformed(folder),
        lambda: counts.check_forgeries("faults", 140, folder),
    ]
    for check in checks:
        try:
            check()
        except (AssertionError, IndexError, ValueError):
            return True
    with contextlib.redirect_stdout(None):
        try:
            return formal_agreement.compare(program, 40, 4, 0, folder) > 0
        except RuntimeError:  # the program ends with an exception of its own
            return True


@pytest.mark.slow
@pytest.mark.skipif(not (BUILT / "checker.ml").exists(), reason="`make formal` has not been run")
@pytest.mark.parametrize(
    "fault", FAULTS, ids=lambda fault: f"{fault.file} {fault.after}{fault.new}"
)
def test_a_fault_of_the_program_is_noticed(fault, tmp_path, monkeypatch):
    assert noticed(program_with(fault, tmp_path), tmp_path, monkeypatch)
