"""The verified checker beside the one in Python: one answer for each document, or exit code 1.

Documents are the solver's certificates, and trees of other shapes, for questions in which
degenerate cases are common, of grasps in the plane and in space and of assemblies; mutants of each
are changed in one place, in their numbers, nodes, keys or bytes. Also compared: what both read of
contacts and wrench.

    python tests/formal_agreement.py PROGRAM [--documents 400] [--mutants 4] [--seed 0]
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import count, islice
from pathlib import Path
from random import Random
from typing import Any

# Run as a script, this file finds its own folder only.
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from arrangement import InputError
from arrangement.numbers.exact import to_text
from equilibrium import Assembly, Contact, Grasp, Solution, read_certificate, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import certificate, resisted_certificate
from equilibrium.certificate.reading import read_case
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.model.contact import VALUES
from proofs_check.instances.grasps import textbook_questions
from tests.equilibrium.degenerate import question
from tests.equilibrium.mutations import mutants
from tests.equilibrium.random_assemblies import random_question
from tests.equilibrium.trees import TooLarge, refutation

ANSWERS = ("accepted", "refused", "malformed")
#: Trees for one question beside the solver's, and the most nodes of one.
SHAPES, NODES = 3, 60
#: Files that one run of the program looks at.
BATCH = 500
#: Numbers in forms that are read, and others that are not.
NUMBERS = [
    *("0", "1", "-1", "1/3", "-7/2", "+2", "6/4", "0.25", "-.5", "3.", "1/1000", "-1/1000"),
    *(
        "",
        "-",
        "1/0",
        "1/-2",
        "1e3",
        "-1.5E-2",
        ".5e+1",
        "1e",
        "1e10000",
        "1/2e3",
        "e1",
        " 1",
        "1.2/3",
        "--1",
        "x",
        "\u0663",
        "0x1",
        "1_0",
        "1/2/3",
    ),
    *(0, 2, -3, 10**40, 0.5, True, None, "9" * 100_001),
]
#: Changes after which a number is one.
NEAR = {"digit", "sign", "plus 1/7", "times 2", "zero", "tiny", "plus 1", "minus 1"}
#: Bytes of one character in UTF-8, and five that are none.
LETTERS = [
    b"\xf0\x9f\x98\x80",
    b"\xc0\x80",
    b"\xe0\x80\xaf",
    b"\xed\xa0\x80",
    b"\xf4\x90\x80\x80",
    b"\xe2\x82",
]


def documents(seed: int) -> Iterator[dict[str, Any]]:
    """Yield certificates of both kinds forever; all are valid."""
    for k in count(1000 * seed):
        yield from spatial_documents(k)
        yield from assembly_documents(k)
        asked = question(k)
        verdict = solve(asked.grasp, asked.wrench)
        yield verdict.certificate.to_dict()
        yield solve(_pulling(asked.grasp, k), asked.wrench).certificate.to_dict()
        for shape in range(0 if verdict.stable else SHAPES):
            try:
                tree = refutation(asked.grasp, asked.wrench, shape, NODES)
            except TooLarge:
                continue
            yield certificate("not resisted", asked.grasp, asked.wrench, tree=tree).to_dict()


def _pulling(contacts: Iterable[Contact], seed: int) -> Grasp:
    """Return contacts with random adhesion."""
    source = Random(f"adhesion {seed}")
    pulls = (Fraction(source.randint(0, 6), source.randint(1, 3)) for _ in iter(int, 1))
    return Grasp(replace(c, adhesion=pull) for c, pull in zip(contacts, pulls, strict=False))


def spatial_documents(seed: int) -> Iterator[dict[str, Any]]:
    """Yield certificates of grasps in space; those with enclosures are left out."""
    source = Random(f"space {seed}")
    contacts = [_turned(c, source) for c in random_grasp(2 + seed % 3, seed, dimension=3)]
    wrench = [Fraction(source.randint(-8, 8), 4) for _ in range(6)]
    for grasp in (Grasp(contacts), _pulling(contacts, seed)):
        verdict = solve(grasp, wrench)
        if verdict.stable is not None and "enclosure" not in verdict.certificate.text:
            yield verdict.certificate.to_dict()
    # Equilibria in the plane z = 0, as rational ones are rare otherwise.
    asked = question(seed)
    flat = solve(asked.grasp, asked.wrench)
    if flat.stable:
        (x, y, turn), zero = flat.solution.motion, Fraction(0)
        (f, g, torque), forces = asked.wrench, flat.solution.forces
        yield resisted_certificate(
            asked.grasp.in_space(),
            (f, g, zero, zero, zero, torque),
            Solution((x, y, zero, zero, zero, turn), tuple((*pair, zero) for pair in forces)),
        ).to_dict()


def assembly_documents(seed: int) -> Iterator[dict[str, Any]]:
    """Yield certificates of a random assembly, and of one from a textbook."""
    textbook = textbook_questions()[-1 - seed % len(textbook_questions())]
    asked_of = (random_question(seed, 3 + seed % 5), (textbook.document, textbook.wrench))
    for document, wrench in asked_of:
        assembly = Assembly.from_dict(document)
        pulling = _pulling((joint.contact for joint in assembly.contacts), seed)
        pairs = zip(assembly.contacts, pulling, strict=True)
        pulled = replace(assembly, contacts=tuple(replace(j, contact=c) for j, c in pairs))
        for verdict in (solve(assembly, wrench), solve(pulled, wrench)):
            if verdict.decided:
                yield verdict.proof


def _turned(contact: Contact, source: Random) -> Contact:
    """Return a contact with its tangent turned by the angle of the triangle 3, 4, 5, or not."""
    one, other = contact.tangents
    a, b = source.choice([(1, 0), (Fraction(3, 5), Fraction(4, 5))])
    tangent = tuple(a * x + b * y for x, y in zip(one, other, strict=True))
    return replace(contact, tangent=tangent)


def mutant(document: dict[str, Any], source: Random) -> bytes:
    """Return a certificate that is changed in one place."""
    if source.random() < 0.1:
        return _broken_text(json.dumps(document).encode(), source)
    near, seed, first = source.random() < 0.7, source.randrange(10**9), source.randrange(10**6)
    found = mutants(document, 99, seed, first)
    changed = next(copied for _, change, copied in found if not near or change in NEAR)
    return json.dumps(changed).encode()


def forms() -> Iterator[bytes]:
    """Yield certificates of unusual form, readable and not: numbers, keys, text, depth, size."""
    contact = {"point": ["0", "-1"], "normal": ["0", "1"], "friction": "1/2"}
    leaf = {"virtual_motion": ["0", "1", "0"], "multipliers": {"0": ["0/3"]}}
    grasp = {"schema_version": 1, "contacts": [contact]}
    plain = {"schema_version": 4, "certificate": "not resisted", "grasp": grasp}
    plain |= {"wrench": ["0", 1, "+0.0"], "tree": leaf}

    def of_contact(key: str, value: Any) -> dict[str, Any]:
        return {"grasp": {**grasp, "contacts": [{**contact, key: value}]}}

    changes: list[dict[str, Any]] = [{}]
    for number in NUMBERS:
        changes += [{"wrench": ["0", number, "0"]}, {"tree": [number, "1", "0"]}]
        changes += [
            of_contact(key, number) for key in ("friction", "preload", "stiffness", "adhesion")
        ]
        changes.append(of_contact("normal", [number, "4/5"]))
    for key in ("00", "+0", "0.", "1", "-1", " 0", "", "\u0660", "0" * 12):
        changes.append({"tree": {**leaf, "multipliers": {key: ["1"]}}})
    for units in ({}, {"length": "m"}, {"length": "m", "force": "\u03bcN"}, [], None):
        changes.append({"grasp": {**grasp, "units": units}})
    for description in ("", "x" * 10_000, '\ud800 \U0001f600 \\ " \t', 3, None):
        changes.append({"grasp": {**grasp, "description": description}})
    changes += [{"schema_version": version} for version in (1, 2, 3, 5, "3", 3.0, True, 10**30)]
    changes.append({"certificate": "unstable"})
    yield from (json.dumps({**plain, **change}).encode() for change in changes)

    resting = {key: plain[key] for key in ("schema_version", "grasp")}
    resting |= {"certificate": "resisted", "wrench": ["0"] * 3, "motion": ["0"] * 3}
    for number in range(3):
        yield json.dumps({**resting, "forces": [["0", "0"]] * number}).encode()

    yield from assembly_forms()

    text, tree = json.dumps(plain), json.dumps(leaf)
    yield text.replace('"tree"', '"\\u0074ree"').encode()
    yield text.replace('"tree"', '"tree":0,"tree"').encode()
    yield text.replace(" ", "\r\n\t ").encode()
    for broken in ("NaN", "01", "-", "1.", "'0'", "0,", "[0]]", "/**/0", "\f0", '"\t"', "tru"):
        yield text.replace("1, ", broken + ", ", 1).encode()
    yield from (text.encode(name) for name in ("utf-8-sig", "utf-16", "utf-32"))
    described = json.dumps({**plain, "grasp": {**grasp, "description": "D"}}).encode()
    yield from (described.replace(b"D", letter) for letter in LETTERS)
    for depth in (1, 299, 300, 301, 900, 100_000):
        start = '{"orthants": [' + f"{tree}, " * 7 + '{"edge": [0, 1], "children": [' * (depth - 1)
        end = f", {tree}]}}" * (depth - 1) + "]}"
        yield text.replace(tree, start + tree + end).encode()
        yield text.replace(tree, "[" * depth + "]" * depth).encode()


def assembly_forms() -> Iterator[bytes]:
    """Yield certificates of assemblies of unusual form: names, bodies, parts, wrenches, leaves."""
    contact = {"point": ["0", "0"], "normal": ["0", "1"], "friction": "1/2"}
    joints = [{"body_a": "a", "body_b": None, **contact}, {"body_a": "b", "body_b": "a", **contact}]
    leaf = {"virtual_motion": {"a": ["0", "1", "0"], "b": ["0", "1", "0"]}}
    assembly = {"bodies": ["a", "b"], "contacts": joints}
    plain = {"schema_version": 4, "certificate": "not resisted", "assembly": assembly}
    plain |= {"wrench": {"a": ["0", "1", "0"], "b": ["0", "0", "0"]}, "tree": leaf}

    def of_joint(**change: Any) -> dict[str, Any]:
        return {"assembly": {**assembly, "contacts": [joints[0], {**joints[1], **change}]}}

    changes: list[dict[str, Any]] = [{}]
    for bodies in (["a", "a"], ["a"], [], ["a", "b", "c"], ["a", {"name": "b"}], [1, 2], "ab"):
        changes.append({"assembly": {**assembly, "bodies": bodies}})
    for name in ("", " b", "b\n", "b" * 40, "b" * 41, "\u03bc", "\u0085", 3, None):
        named = {"bodies": ["a", name], "contacts": joints[:1]}
        wrench = {"a": ["0", "1", "0"], str(name): ["0", "0", "0"]}
        changes.append({"assembly": named, "wrench": wrench, "tree": {"virtual_motion": {}}})
    changes += [of_joint(body_b=name) for name in ("b", "c", None, 1)]
    changes += [of_joint(body_a=name) for name in (None, "c", "a")]
    changes += [of_joint(adhesion=x) for x in ("0", "1/2", "-1")]
    changes += [of_joint(tangent=["1", "0"]), of_joint(normal=["0", "0", "1"])]
    keys = {"schema_version": 2, "description": 3, "units": {}, "wrench": {}, "outline": {}}
    changes += [{"assembly": {**assembly, key: value}} for key, value in keys.items()]
    for wrench in ({"a": ["0"] * 3}, {"a": ["0"] * 3, "c": ["0"] * 3}, ["0"] * 6):
        changes.append({"wrench": wrench})
    zero = ["0", "0", "0"]
    trees: list[Any] = [["0", "1", "0"], {"virtual_motion": {"c": zero}}, {"orthants": [leaf] * 8}]
    for row in (["1"], ["0", "0"], ["0", "0", "0"], "0"):
        trees.append({**leaf, "multipliers": {"0": row}})
    part = {"part": ["b"], "contacts": [1], "tree": ["0", "1", "0"]}
    trees += [part, {**part, "part": ["b", "b"]}, {**part, "part": ["c"]}, {**part, "part": []}]
    trees += [{**part, "contacts": places} for places in ([0], [1, 1], [], [2], [0, 1])]
    trees += [{**part, "part": ["a"], "contacts": [1, 0]}, {**part, "part": ["b", "a"]}]
    trees += [{**part, "part": ["a", "b"], "contacts": [0], "tree": tree} for tree in ([], zero)]
    trees.append({"contact": 0, "attachment": {"detached": leaf, "attached": leaf}})
    changes += [{"tree": tree} for tree in trees]
    beside = {**assembly, "contacts": [joints[0], {**joints[1], "body_a": "a", "body_b": "b"}]}
    changes += [{"assembly": beside, "tree": {**part, "part": ["a"], "contacts": [0, 1]}}]
    pulled = {"wrench": {"a": zero, "b": ["0", "1", "0"]}}
    changes += [{**pulled, "tree": {**part, "contacts": places}} for places in ([1], [1, 1])]
    # A load beyond the left one of two contacts, which has number 0 in the tree of the part.
    feet = [{"body_a": "b", "body_b": None, **contact, "point": [x, "0"]} for x in ("-1", "1")]
    tips = {"detached": ["0", "-1", "1"], "attached": ["0", "1", "1"]}
    for places in ([1, 2], [2, 1]):
        split = {**part, "contacts": places, "tree": {"contact": 0, "attachment": tips}}
        standing = {**assembly, "contacts": [joints[0], *feet]}
        wrench = {"a": zero, "b": ["0", "-1", "2"]}
        changes.append({"assembly": standing, "wrench": wrench, "tree": split})
    changes.append({"pyramid": 4})
    yield from (json.dumps({**plain, **change}).encode() for change in changes)
    resting = {key: plain[key] for key in ("schema_version", "assembly")}
    resting |= {"certificate": "resisted", "wrench": {"a": zero, "b": zero}}
    for forces in ([["0", "0"]] * 2, [["0", "0"]], [["0", "0", "0"]] * 2):
        motion = {"a": zero, "b": zero}
        yield json.dumps({**resting, "motion": motion, "forces": forces}).encode()
    yield json.dumps({**resting, "motion": {"a": zero}, "forces": [["0", "0"]] * 2}).encode()


def _broken_text(text: bytes, source: Random) -> bytes:
    at = source.randrange(len(text))
    return source.choice(
        [
            text[:at],
            text[:at] + text[at + 1 :],
            text[:at] + source.choice([b",", b'"', b"0", b"\\", b"\xff", b"//", b"\\u0041", b"\n"])
            + text[at:],
            b"\xef\xbb\xbf" + text,
            text + text,
        ]
    )  # fmt: skip


#: What was answered to texts of files.
_answers: dict[bytes, tuple[str, Any]] = {}


def python_answer(path: Path) -> tuple[str, Any]:
    """Return the answer of the Python checker, and the question where the document has a form."""
    text = path.read_bytes()
    if text not in _answers:
        _answers[text] = _new_answer(path)
    return _answers[text]


def _new_answer(path: Path) -> tuple[str, Any]:
    try:
        document = read_certificate(path)
        report = check(document)
        rows, wrench = asked(document)
    except InputError:
        return "malformed", None
    content = {"contacts": [list(map(to_text, row)) for row in rows]}
    return ("accepted" if report else "refused"), {**content, "wrench": list(map(to_text, wrench))}


def asked(document: dict[str, Any]) -> tuple[list[list[Fraction]], list[Fraction]]:
    """Return the numbers of contacts and load; contacts of an assembly begin with their bodies."""
    _, case = read_case(document)
    if "assembly" in document:
        assembly = case.subject
        place = {name: Fraction(k) for k, name in enumerate(assembly.names)}
        rows = [
            [place[name] for name in (c.body_a, c.body_b) if name is not None] + _values(c.contact)
            for c in assembly.contacts
        ]
        return rows, list(case.load)
    return [_values(c) for c in case.subject], list(case.load)


def _values(contact: Contact) -> list[Fraction]:
    given = (*contact.point, *contact.normal, *contact.tangent * (contact.dimension == 3))
    return [*given, *(getattr(contact, name) for name in VALUES)]


def program_answers(program: Path, paths: list[Path], *options: str) -> list[str]:
    """Return the lines that the verified checker prints, one for each file."""
    lines: list[str] = []
    for start in range(0, len(paths), BATCH):
        batch = paths[start : start + BATCH]
        done = subprocess.run([program, *options, *batch], capture_output=True, text=True)
        lines += done.stdout.splitlines()
        if done.stderr or done.returncode not in (0, 1, 2):
            raise RuntimeError(f"{program}: exit code {done.returncode}: {done.stderr}")
    return lines


@cache
def texts(number: int, changed: int, seed: int) -> list[tuple[bytes, bool]]:
    """Return documents, each with mutants of it, and unusual forms; and which are documents."""
    source, found = Random(f"formal {seed}"), []
    for document in islice(documents(seed), number):
        found.append((json.dumps(document).encode(), True))
        found += [(mutant(document, source), False) for _ in range(changed)]
    return [*found, *((text, False) for text in forms())]


def compare(program: Path, number: int, changed: int, seed: int, folder: Path) -> int:
    """Compare all answers; print what differs and what was counted; return the differences."""
    paths, valid = [], set()
    for i, (text, unchanged) in enumerate(texts(number, changed, seed)):
        paths.append(folder / f"{i}.json")
        paths[-1].write_bytes(text)
        if unchanged:
            valid.add(paths[-1])
    lines, questions = (program_answers(program, paths, *o) for o in ((), ("--question",)))
    counted: Counter[tuple[bool, str]] = Counter()
    differences = 0
    for path, line, asked in zip(paths, lines, questions, strict=True):
        answer, content = python_answer(path)
        counted[path in valid, answer] += 1
        proved = line.partition(":")[0]
        same = content is None or asked == json.dumps(content, separators=(",", ":"))
        if proved != answer or not same or (path in valid and answer != "accepted"):
            differences += 1
            print(f"{path.name}: Python: {answer}, proved: {line}, same question: {same}")
            print(path.read_bytes()[:2000].decode(errors="replace"))
    for kind, name in ((True, "documents"), (False, "mutants and unusual forms")):
        print(name + ":", ", ".join(f"{counted[kind, answer]} {answer}" for answer in ANSWERS))
    missing = [answer for answer in ANSWERS if changed and not counted[False, answer]]
    if missing:
        print(f"no mutant is {' or '.join(missing)}")
    print(f"{differences} disagreements of the Python checker and the verified one")
    return differences + len(missing)


def main() -> int:
    """Compare the two checkers on generated documents."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--documents", type=int, default=400)
    parser.add_argument("--mutants", type=int, default=4)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        program = given.program.resolve()
        found = compare(program, given.documents, given.mutants, given.seed, Path(folder))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
