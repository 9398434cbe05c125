"""Command lines with something wrong: exit code 2, one line that says what, and no file."""

from __future__ import annotations

import json
import shlex

import pytest

from equilibrium.cli.program import main as equilibrium
from equilibrium.grasps.files import read_grasp
from proofs_check.cli.program import main as proofs_check

THREE, PRELOADED = "paper-three-contacts", "paper-three-contacts-preload-1"
CONTACT = {"point": ["0", "0"], "normal": ["1", "0"], "friction": "1"}
FLOATS = {
    "schema_version": 1,
    "points": [[-0.1, 0], [0.30000000000000004, 1e-3]],
    "normals": [[2.5, 0], [-0.7, 0.7]],
    "friction": [0.3, 0.5],
}
HEADER = "x,y,normal_x,normal_y,friction"


def grasp(contact: dict) -> str:
    return json.dumps({"schema_version": 1, "contacts": [CONTACT | contact]})


def claims(body: str) -> str:
    return "from proofs_check import claim\n" + body


#: The text of a file, and what is said of it.
CONTACTS = [
    ({"friction": "__import__('os').system('true')"}, "not an exact number"),
    ({"friction": "1e999999999"}, "exponent"),
    ({"friction": 0.5}, "0.5"),
    ({"friction": float("nan")}, "NaN"),
    ({"friction": None}, "friction"),
    ({"friction": True}, "friction"),
    ({"friction": "1" * 100_001}, "friction"),
    ({"mass": "1"}, "mass"),
    ({"stiffness": "0"}, "stiffness"),
    ({"normal": ["1", "1"]}, "unit"),
    ({"normal": ["3", "1e-9"]}, "--round-normals"),
]
CONVERTED = [
    ({"points": [[0, 0]]}, "2 normals for 1 points"),
    ({"points": [[0, 0, 0], [1, 1, 1]]}, "three, in space"),
    ({"points": [[[0], 0], [1, 1]]}, "expected a number"),
    ({"points": [[float("nan"), 0], [1, 1]]}, "NaN"),
    ({"normals": [[0, 0], [1, 1]]}, "normals[0]"),
    *(({"friction": x}, "expected a number") for x in (None, True, [[0.1], 1], {"0.1": 1})),
    ({"friction": [0.1]}, "1 values for 2 contacts"),
    ({"friction": -0.1}, "friction"),
    ({"friction": "__import__('os')"}, "not an exact number"),
    ({"stiffness": [1, 2, 3]}, "stiffness"),
    ({"points": [[0.0], [1.0]]}, "coordinates"),
    ({"mass": 1}, "mass"),
    ({"schema_version": 2}, "schema_version"),
]
#: Tables, for `make floats` and for `make csv`.
BOTH_TABLES = [
    (f"{HEADER}\n0,0,1,0,nan\n", "line 2: "),
    (f"{HEADER}\n0,0,1,0,-1\n", "line 2: friction"),
    (f"{HEADER}\n0,0,1,0,1\n0,0,0,0,1\n", "line 3: direction"),
    ("x,y\n", "missing"),
]
FLOAT_TABLES = [
    *BOTH_TABLES,
    *((f"{HEADER}\n0,0,1,0,{x}\n", "line 2: ") for x in ("inf", "1e999", "1_0")),
]
TABLES = [
    *BOTH_TABLES,
    ("", "first line"),
    (f"{HEADER},colour\n", "colour"),
    (f"{HEADER},x\n", "twice"),
    ("x,y,nx,ny,mu,friction\n", "friction appears twice"),
    (f"{HEADER},z\n", "in space; normal_z is missing"),
    (f"{HEADER},nz\n", "in space; z is missing"),
    (f"# remark\n\n{HEADER}\n0,0,1,0\n", "line 4 has 4 entries"),
    (f"{HEADER}\n0,0,1,0,1e99999\n", "line 2: "),
    (f'{HEADER}\n0,0,1,0,"1\n', "line"),
    (f"{HEADER}\n0,0,1,0,__import__('os')\n", "not an exact number"),
    (f"{HEADER},stiffness\n0,0,1,0,1,0\n", "stiffness"),
]
CLAIMS = [
    ("x = 1\n", "has no claims"),
    ("x = 1\ndef f(:\n", "mine.py, line 3: SyntaxError: invalid syntax: def f(:"),
    ("\n1 / 0\n", "ZeroDivisionError: division by zero (mine.py, line 3: 1 / 0)"),
    ('@claim("s", formula="a^")\ndef f(p): return True\n', "the formula 'a^'"),
    ('@claim("s", of=[])\ndef f(p): return True\n', "the list of instances is empty"),
    (
        '@claim("s", of=[[1]], routes=[len])\ndef f(p, n): return n / 0\n',
        "f raised ZeroDivisionError: division by zero (mine.py, line 3",
    ),
    ('@claim("")\ndef f(p): return True\n', "in words"),
    ('@claim("s", of="cubes")\ndef f(p): return True\n', "no domain is called 'cubes'; there are"),
    ('@claim("s", census=9)\ndef f(p): return True\n', "census is 9"),
    ('@claim("s", samples=-1)\ndef f(p): return True\n', "samples is -1"),
    ('@claim("s", planes=(2, 5))\ndef f(p): return True\n', "at least 3"),
    ('@claim("s", planes=[3])\ndef f(p): return True\n', "smallest and a largest"),
    ('@claim("s", expected="yes")\ndef f(p): return True\n', "expected is 'yes'"),
    ('@claim("s")\ndef f(p): return None\n', "returned None"),
    ('@claim("s", when=lambda p: 1 / 0)\ndef f(p): return True\n', "`when` of f raised ZeroD"),
    ('@claim("s", id="a b")\ndef f(p): return True\n', "'a b' is not an id"),
    (
        '@claim("s", id="x")\ndef f(p): return True\n@claim("t", id="x")\ndef g(p): return 1\n',
        "have the id 'x'",
    ),
]
RECORDS = [
    '{"schema_version": 1, "results": [{}]}',
    '{"schema_version": 1, "results": 3}',
    '{"schema_version": 1, "results": [1.5]}',
    '{"schema_version": 2, "results": []}',
    '{"results": []}',
    "[]",
    "x",
]
PRINTED = [
    ("24,braid-a3", "line 2: a row needs"),
    ("24,braid-a3,region", "quantity is 'region'"),
    ("two,braid-a3,regions", "write integers"),
    ("1 2,braid-a3,regions", "one number"),
    ("t=3,braid-a3,t-vector", "write t2=3"),
    ("7,lines seven,types", "write lines n=7"),
    ("7,near-pencil n=7,regions", "write near-pencil parameter=value"),
    ("7,no-such-name,regions", "cannot read"),
    ('"7,braid-a3,regions', "line 2"),
]
OLD = '{"schema_version": 1, "certificate": "unstable", "regions": ""}'
DEEP = '{"schema_version": 1, "certificate": ' + "[" * 10**6 + "]" * 10**6 + "}"
LONG = read_grasp(THREE).to_dict()
LONG["contacts"][0]["point"][1] = "1/" + "7" * 1001
LECTURE = "from proofs_check import exercise\n"
ONE = '@exercise("One?", id="one")\ndef {}(answer): return answer == 1\n'
UP = "--wrench 0 1 0"
#: A program, its arguments, what is said, and the files that stand beside the caller.
CASES = [
    (equilibrium, words, said, {})
    for words, said in (
        ("", "required"),
        (f"solve {THREE}", "--wrench"),
        (f"solve {THREE} {UP} --force 0 1", "--force"),
        (f"solve {THREE} {UP} --at 0 1", "--at"),
        (f"solve {THREE} --at 0 1", "--wrench --force"),
        (f"solve {THREE} --wrench 0 1", "expected 3"),
        (f"solve {THREE} --wrench 0 1 1e99999", "1e99999"),
        (f"solve {THREE} --wrench 0 1 nan", "nan"),
        (f"solve no-such-grasp {UP}", "no-such-grasp"),
        (f"solve {THREE} {UP} --literal everything", "everything"),
        (f"solve {THREE} --preload -1 {UP}", "preload"),
        (f"solve {THREE} {UP} --literal signs --certificate x", "no certificate"),
        (f"solve {THREE} {UP} --certificate no/x.json", "no"),
        *(
            (f"solve {THREE} {UP} --digits {digits}", "1 to 1000")
            for digits in ("0", "-1", "1001", "1" * 5000, "six", "²")
        ),
        ("verify no-such-file.json", "no-such-file.json"),
        (f"verify {THREE}", THREE),
        (f"limit {THREE} --direction 0 0 0", "zero"),
        (f"limit {THREE} --direction 0 1", "expected 3"),
        (f"limit {THREE} --direction 0 1e99999 0", "1e99999"),
        (f"limit {THREE}", "--direction"),
        ("limit no-such-grasp --direction 0 1 0", "no-such-grasp"),
        (f"region {THREE} --second 2 0 0", "parallel"),
        (f"map {THREE} --directions 0", "directions"),
        (f"margin {THREE} {UP} --width 0", "width"),
        (f"compare no-such-grasp {UP}", "no-such-grasp"),
        ("compare two-opposed-fingers --wrench 0 1 1 0 0 0 --cone pyramid:7", "7"),
        (f"compare {THREE} {UP} --cone pyramid:8", "pyramid"),
        ("wrench-space box-held-by-four --torque 1", "torque"),
        ("wrench-space box-held-by-four --cone pyramid:6", "takes too long"),
        ("modes box-3-walls --time-limit 1/1000000", "the modes of 12 contacts"),
        *((f"make {form} none.{end}", "none") for form, end in (("csv", "csv"), ("floats", "csv"))),
        ("make floats none.json", "none.json"),
        *(
            (f"draw {THREE} -o a.svg {options}", said)
            for options, said in (
                ("--view mood", "mood"),
                ("--view resist --piece 1", "piece"),
                (f"--view polar {UP}", "wrench"),
                ("--piece 2", "nothing is solved"),
                ("--wrench 0 -1 0 --piece 7", "piece"),
                ("--outline 0,0 1,1", "outline"),
                ("--outline 0,0 1,1 2,x", "outline[2][1]"),
                ("--width 5", "width"),
                ("--view resist --extent 0", "extent"),
                ("--view polar --directions 0", "directions"),
                ("--view compare --methods guess", "known are complete"),
                ("--view slice --preload -1", "preload"),
                ("--view methods", "wrench"),
                (f"--view resist {UP} --wrench 0 2 0", "wrench"),
                (f"--view methods {UP} --extent 1", "extent"),
                ("--view proof", "wrench"),
                ("--view proof --wrench 0 -1 0", "the view grasp"),
                (f"--view proof {UP} --turn 0", "turn"),
                ("--view wrench-set --extent 0", "above 0"),
                ("--direction 1 2 3", "in space"),
            )
        ),
        (f"draw {THREE} -o a.gif", "known are .glb, .html, .obj, .pdf, .png, .stl, .svg"),
        (f"draw {THREE} -o none/a.svg", "none"),
        ("draw wedge --view resist -o a.svg", "known are"),
        ("draw wedge --tolerance 1 -o a.svg", "tolerance"),
        ("draw wedge --outline 0,0 1,1 0,1 -o a.svg", "outline"),
        ("draw wedge --wrench 0,0,-1,0,0,0 --piece 2 -o a.svg", "piece"),
        (f"draw wedge {UP} -o a.svg", "wrench"),
        ("draw single-contact --view wrench-set -o a.stl", "a view needs one of"),
    )
]
CASES += [
    (equilibrium, words, said, {"a.json": text})
    for words, said, text in (
        *(("solve a.json --wrench 0 0 0 --json", x, grasp(change)) for change, x in CONTACTS),
        *(("make floats a.json", x, json.dumps(FLOATS | change)) for change, x in CONVERTED),
        ("make floats a.json --tolerance -1", "tolerance", json.dumps(FLOATS)),
        ("verify a.json", "this is an old certificate", OLD),
        *((words, "nested", DEEP) for words in ("verify a.json", "solve a.json --wrench 0 0 0")),
        *(
            (f"{c} a.json --weight 1", f"1001 digits; {c} takes at most 1000", json.dumps(LONG))
            for c in ("margin", "compare")
        ),
    )
]
CASES += [
    (equilibrium, f"make {form} a.csv", said, {"a.csv": text})
    for form, tables in (("floats", FLOAT_TABLES), ("csv", TABLES))
    for text, said in tables
]
CASES += [
    (equilibrium, "make csv a.csv", "UTF-8", {"a.csv": b"x,y\xff"}),
    (equilibrium, "make csv a.csv", "bytes of a file", {"a.csv": b"0" * (4 * 2**20 + 1)}),
    (
        equilibrium,
        "make csv a.csv --outline 0,0 1,1",
        "outline",
        {"a.csv": f"{HEADER}\n-1,0,1,0,0.5\n"},
    ),
]
SWEEP = "sweep step-1-square-bound"
SIZE = "--planes 3..4 --samples 9 --store s.sqlite"
CASES += [
    (proofs_check, words, said, {})
    for words, said in (
        *((f"{c} table-three", "no claim has the id 'table-three'") for c in ("run", "show")),
        (f"show {'x' * 5000}", "no id is near"),
        ("run nowhere.py", "cannot read nowhere.py"),
        (f"sweep nothing {SIZE}", "no claim has the id 'nothing'"),
        (f"sweep table-three-contacts {SIZE}", "not of random instances"),
        (f"sweep nowhere.py {SIZE}", "cannot read nowhere.py"),
        (f"{SWEEP} {SIZE} --samples 0", "samples is 0"),
        (f"{SWEEP} {SIZE} --jobs 0", "jobs is 0"),
        (f"{SWEEP} {SIZE} --chunk 0", "chunk is 0"),
        (f"{SWEEP} {SIZE} --planes 4..3", "smaller number stands first"),
        (f"{SWEEP} {SIZE} --planes 3-4", "'3-4' is not a range"),
        (f"{SWEEP} {SIZE} --shard 3/2", "'3/2' is not a shard"),
        (f"{SWEEP} {SIZE} --store nowhere/s.sqlite", "cannot open nowhere/s.sqlite"),
        (f"{SWEEP} {SIZE} --store ''", "it is empty"),
        (f"{SWEEP} {SIZE} --store :memory:", "no file"),
        ("sweep euler --types 3..5 --samples 3 --store s.sqlite", "samples"),
        ("sweep euler --types 8..10 --store s.sqlite", "10"),
        ("status nowhere.sqlite", "there is no store nowhere.sqlite"),
        ("merge out.sqlite nowhere.sqlite", "there is no store nowhere.sqlite"),
        ("report nowhere.json", "cannot read"),
        ("report nowhere.json --output r.pdf", "a report ends with .json"),
        ("new nowhere/mine", "nowhere"),
    )
]
CASES += [(proofs_check, "run mine.py", said, {"mine.py": claims(body)}) for body, said in CLAIMS]
CASES += [(proofs_check, "report r.json", "", {"r.json": text}) for text in RECORDS]
CASES += [
    (proofs_check, "table t.csv", said, {"t.csv": f"printed,arrangement,quantity\n{row}\n"})
    for row, said in PRINTED
]
CASES += [
    (proofs_check, words, said, files)
    for words, said, files in (
        ("table t.csv", "no column quantity", {"t.csv": "arrangement,printed\n"}),
        ("new mine", "is there already", {"mine.py": ""}),
        ("run euler mine.py", "ids and files", {"mine.py": claims(CLAIMS[8][0].replace("9", "3"))}),
        (
            f"sweep mine.py {SIZE}",
            "is about a list of instances",
            {"mine.py": claims('@claim("s", of=[1, 2])\ndef f(k): return k < 3\n')},
        ),
        ("grade q.py", "has no exercises", {"q.py": "x = 1"}),
        (
            "grade q.py",
            "two exercises with one id",
            {"q.py": LECTURE + ONE.format("a") + ONE.format("b")},
        ),
        *(
            ("grade q.py a.json", "", {"q.py": LECTURE + ONE.format("a"), "a.json": text})
            for text in ("[]", '{"schema_version": 1, "answers": []}', "print(1)")
        ),
    )
]


@pytest.mark.parametrize(
    ("program", "words", "said", "files"),
    CASES,
    ids=[f"{k}-{words[:50]}" for k, (_, words, *_) in enumerate(CASES)],
)
def test_a_mistake_is_one_line_and_leaves_no_file(
    program, words, said, files, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    for name, text in files.items():
        (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    before = sorted(tmp_path.iterdir())
    try:
        code = program(shlex.split(words))
    except SystemExit as stop:
        code = stop.code
    out, err = capsys.readouterr()
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert err.startswith("error: ")
    assert said in err
    assert len(err) < 700
    assert [path for path in sorted(tmp_path.iterdir()) if path.name != "__pycache__"] == before
