"""Mutants of the verified program: of what Coq extracts, and of the readers that feed it.

What is proved is the Coq program. That it becomes this binary, and that documents become its
questions, is tested; here it is tested that those tests notice. All mutants are in one program, and
its variable FAULT says which of them runs.
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
    """An expression of a file, the first after the place where a definition begins, and another.

    Where the other is no expression, it is a text in which FAULT is true of the mutant.
    """

    file: str
    after: str
    old: str
    new: str

    def switched(self, number: int) -> str:
        """Return what stands for the old text in the program of all mutants."""
        fault = f"(Fault.number = {number})"
        if "FAULT" in self.new:
            return self.new.replace("FAULT", fault)
        arm = self.old.rpartition("-> ")[0] + "-> " if self.old.startswith("| ") else ""
        new, old = (text.removeprefix(arm) for text in (self.new, self.old))
        return f"{arm}(if {fault} then {new} else {old})"


#: Of each file, after the words with which a definition begins, texts and what replaces them.
PLANTED = {
    "checker.ml": {
        # Counts.
        "let rec regions ": [
            ("| None -> Big_int_Z.zero_big_int", "| None -> Big_int_Z.unit_big_int"),
            ("regions look0 restrict0 n0 b'", "Big_int_Z.unit_big_int"),
        ],
        "let rec onto ": [
            ("| Vanishes -> None", "| Vanishes -> onto look0 r b0"),
            ("| Constant -> onto look0 r b0", "| Constant -> None"),
        ],
        "let rec skim ": [("g' :: (skim look0 r a0)", "skim look0 r a0")],
        "let rec faces ": [
            ("(h :: nz)", "nz"),
            (
                "Big_int_Z.zero_big_int :: (faces",
                "(if FAULT then Big_int_Z.unit_big_int else Big_int_Z.zero_big_int) :: (faces",
            ),
        ],
        "let rec polynomial ": [("difference (poly", "(if FAULT then sum else difference) (poly")],
        "let rec difference ": [("(Z.sub a b)", "(Z.sub b a)"), ("(Z.opp b)", "b")],
        "let rec mix ": [("(Z.sub (Z.mul a x)", "((if FAULT then Z.add else Z.sub) (Z.mul a x)")],
        "let restrict ": [
            ("Z.mul (Z.sgn p) (Z.div q0 c)", "Z.div q0 c"),
            ("Z.sub (Z.mul a g", "(if FAULT then Z.add else Z.sub) (Z.mul a g"),
        ],
        "let primitive0 ": [("(map (fun a -> Z.div a c) f.coefficients)", "f.coefficients")],
        "let look ": [("Z.eqb f.constant", "(fun a b -> FAULT <> Z.eqb a b) f.constant")],
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
            ("confirmed (dimension", "FAULT || confirmed (dimension"),
            ("refuted (dimension", "FAULT || refuted (dimension"),
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
        "let signs ": [
            (
                "'-' -> Minus | '0' -> Zero",
                "'-' when FAULT -> Zero | '0' when FAULT -> Minus | '-' -> Minus | '0' -> Zero",
            )
        ],
        "let face ": [
            (
                "numerators; denominator }",
                "numerators; denominator = (if FAULT then Z.one else denominator) }",
            )
        ],
        "let certificate ": [("Z.compare a b", "Z.compare b a")],
    },
    "reader.ml": {
        "let law ": [
            ("if spring then 1", "if spring && not FAULT then 1"),
            ('"stiffness" 1', '"stiffness" (if FAULT then 0 else 1)'),
            ("Z.sign preload.qnum < 0", "false"),
        ],
        "let contact ": [("not (Z.equal", "not FAULT && not (Z.equal")],
        "let index ": [("Z.sign i >= 0", "true")],
        "let vector ": [("(Some size)", "None")],
    },
    "tree_reader.ml": {
        "let contact_key ": [
            ("|| string_of_int i <> key", "|| not FAULT && string_of_int i <> key")
        ],
        "let multiplier ": [("Z.of_int (subject.number i)", "Z.of_int (subject.number i + 1)")],
        "let leaf ": [("List.map (multiplier subject) given", "[]")],
        "let orthants ": [("(last c d)", "(last d c)")],
    },
    "grasp_reader.ml": {
        "let document ": [("(Some contacts)", "None")],
    },
    "assembly_reader.ml": {
        "let name ": [("characters > 40", "characters > 41")],
        "let joint ": [("if b = Some a", "if not FAULT && b = Some a")],
        "let part ": [
            (
                "compare places",
                "compare (if FAULT then List.sort_uniq compare places else places)",
            ),
            ("number = (fun k ->", "number = (fun k -> if FAULT then k else"),
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
        "let answer ": [
            ('(1, "refused: " ^ kind)', '(0, "accepted: " ^ kind)'),
        ],
        '"--regions"': [("count_regions forms", "Z.succ (count_regions forms)")],
    },
}
FAULTS = [
    Fault(file, after, old, new)
    for file, definitions in PLANTED.items()
    for after, changes in definitions.items()
    for old, new in changes
]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Compile the program of all mutants."""
    folder = tmp_path_factory.mktemp("mutants")
    for name in FILES:
        shutil.copy(BUILT / name, folder)
    for number, fault in enumerate(FAULTS, 1):
        path = folder / fault.file
        begin, found, rest = path.read_text().partition(fault.after)
        assert found
        assert fault.old in rest
        path.write_text(begin + found + rest.replace(fault.old, fault.switched(number), 1))
    (folder / "fault.ml").write_text('let number = int_of_string (Sys.getenv "FAULT")\n')
    compiler = ["ocamlfind", "ocamlopt", "-w", "-a", "-package", "zarith", "-linkpkg", "fault.ml"]
    subprocess.run([*compiler, *FILES, "-o", "mutants"], cwd=folder, check=True, timeout=300)
    return folder / "mutants"


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
@pytest.mark.parametrize("number", range(len(FAULTS) + 1))
def test_every_mutant_of_the_program_is_noticed(number, program, tmp_path, monkeypatch):
    """Number 0 is the program without a change."""
    monkeypatch.setenv("FAULT", str(number))
    assert noticed(program, tmp_path, monkeypatch) == (number > 0), [*FAULTS][number - 1]
