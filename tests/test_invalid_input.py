"""Command lines with something wrong: exit code 2, one line that says what, and no file."""

import itertools
import json
import shlex

import pytest

from arrangement import Arrangement, families
from arrangement.cli import main as arrangement
from arrangement.numbers import deadline
from equilibrium import read_grasp
from equilibrium.cli.program import main as equilibrium
from proofs_check.cli.program import main as proofs_check
from proofs_check.instances.families import MOST_MEMBERS

GOLDEN = {
    "schema_version": 1,
    "planes": [[["0", "1"], "1"]],
    "field": {"minimal_polynomial": ["-1", "-1", "1"], "interval": ["1", "2"]},
}
COMPLEX = {"minimal_polynomial": ["1", "0", "1"], "interval": ["0", "1"]}
#: Files that stand beside the caller.
FILES = {
    "prose.sage": "x y\n",
    "prose.m2": "x y\n",
    "prose.csv": "x y\n",
    "prose.dot": "x y\n",
    "prose.json": "x y\n",
    "vast.txt": f"1 0 | 1\n0 1 | {'7' * 4300}\n1 1 | 0\n",
    "tiny.txt": f"1 0 | 1\n0 1 | 1/{'7' * 4300}\n1 1 | 0\n",
    "escape.json": '{"schema_version": 1, "\\u001b[31m": 1, "planes": []}',
    "h3.json": json.dumps(families.h3().to_dict()),
    "generic.json": json.dumps(families.generic(41).to_dict()),
    "resonance.json": json.dumps(families.resonance(7).to_dict()),
    "four.json": json.dumps(
        Arrangement([[int(i == j) for j in range(4)] for i in range(4)]).to_dict()
    ),
    "affine.json": json.dumps(
        Arrangement([[1, k, k * k] for k in range(15)], [k**3 for k in range(15)]).to_dict()
    ),
    "complex.json": json.dumps(GOLDEN | {"field": COMPLEX}),
    "endless.json": json.dumps(GOLDEN | {"field": {"minimal_polynomial": ["-2", "0", "1"]}}),
    "long.json": json.dumps(GOLDEN | {"planes": [[["1", "2", "3"], "1"]]}),
    "float.json": json.dumps(GOLDEN | {"planes": [[["1", 0.5], "1"]]}),
    "none.json": json.dumps(GOLDEN | {"field": None}),
}
#: What is in no format.
NONE = {f"none-{k}": text for k, text in enumerate(["abc\n", "a", '"abc"', "[1]", "", "+++\nx\n"])}
FILES |= NONE
#: Arguments of `arrangement`, and what is said.
ARRANGEMENT = [
    ("", "required"),
    ("count", "required"),
    ("conut pencil", "  arrangement count pencil "),
    ("count pencil extra", "unexpected argument 'extra'"),
    ("count pencil --js", "--js"),
    ("--speet=1", "no option '--speet'"),
    ("draw pencil --width '' -o a.svg", "argument --width: it is empty"),
    ("draw coordinate-planes --view planes --radius 50mm -o a.svg", "'50mm' has a unit"),
    (f"faces pencil --dimension {'9' * 5000}", "not a whole number of up to 18 digits"),
    ("count no/such/file", "no/such/file"),
    ("faces no/such/file --json", "no/such/file"),
    ("faces three-generic-planes --dimension 4", "dimension"),
    ("faces three-generic-planes --dimension -1", "dimension"),
    ("faces pencil --dimension one", "one"),
    ("faces pencil --dimension 1.5", "1.5"),
    ("count escape.json", "unknown key"),
    ("count prose.sage", "there is no line such as H.<x,y>"),
    ("count prose.m2", "there is no arrangement {...}"),
    ("count prose.csv", "is a text that begins with 'x y'. It is in none of"),
    ("count prose.dot", "only written"),
    ("count prose.json", "not valid JSON"),
    ("count complex.json", "embedding"),
    ("count endless.json", "interval"),
    ("count long.json", "1 to 2"),
    ("count float.json", "float"),
    ("count none.json", "expected a JSON object"),
    ("make shi --type E9", "the type is 'E9'; there are A1"),
    ("make shi --type A2 --m 0", "m is 0; it must be at least 1"),
    ("count resonance.json --time-limit 1/2", "first Whitney numbers 1 are final; give more"),
    ("count shi-a2-affine --primes 5,4", "4 is not a prime"),
    ("count shi-a2-affine --primes 2,3", "2 is a prime of bad reduction"),
    ("count shi-a2-affine --primes 5", "give at least 2"),
    ("count shi-a2-affine --primes five", "expected primes such as 5,7,11"),
    ("count shi-a2-affine --primes 5 --forecast", "not allowed with"),
    ("count shi-a2-affine --time-limit 0 --jobs 2", "'0' is not above 0; give a number of seconds"),
    ("count shi-a2-affine --shard 1/2", "need --store"),
    ("list --classes 10", "expected 3 to 9"),
    ("list --verified", "give --classes M"),
    ("list --families --verified", "give --classes M"),
    ("list --families --classes 4", "give one"),
    ("list braid-a3 --classes 4", "give one"),
    ("count 'x = 0' 'y = 0'", "one argument: 'x = 0; y = 0'"),
    ("convert braid-a3", "--to"),
    ("convert braid-a3 -o no.xyz", "'.xyz'; expected one of"),
    ("convert braid-a3 -o no.txt --to xyz", "xyz"),
    ("convert braid-a3 -o no.txt --to christ", "christ"),
    ("convert h3.json -o no.m2", "this format holds rational ones"),
    ("convert braid-a3 --from dot --to json", "dot"),
    *(
        (f"convert {name} --from {form} --number 1 --to json", "")
        for form in ("chirotope", "christ", "polymake", "oscar", "json", "sage")
        for name in NONE
    ),
    ("draw pencil -o a.svg --view shadow", "expected one of sphere, planes"),
    ("draw pencil -o a.svg --colour mood", "mood"),
    ("draw pencil -o a.svg --with 90", "  --width 90"),
    ("draw pencil -o a.svg --theme drak", "did you mean dark?"),
    ("draw pencil -o a.svg --theme blue", "expected one of light, dark, mono"),
    ("draw pencil -o a.stl --theme dark", "theme is for pictures"),
    ("draw parallel-planes-affine --view sphere -o a.svg", "planes, cells, lines, graph"),
    ("draw parallel-planes-affine --view dual -o a.svg", "planes, cells, lines, graph"),
    ("draw parallel-planes-affine --view stereographic -o a.svg", "planes, cells"),
    ("draw generic-lines-affine --view gnomonic -o a.svg", "planes, cells, lines, graph"),
    ("draw braid-a3 --view section -o a.svg", "section shows central planes of rank 4"),
    ("draw shi-a2-affine --view poset --bottom 17 -o a.svg", "there is no region '17'"),
    (
        "draw braid-a3 --view lines -o a.svg",
        "sphere, planes, cells, stereographic, gnomonic, dual, graph, poset",
    ),
    ("draw braid-a3 --view lattice --hull -o a.svg", "hull"),
    ("draw braid-a3 --coordinates cartesian -o a.svg", "cartesian"),
    ("draw pencil -o none/a.svg", "there is no folder"),
    (
        "draw pencil -o a",
        "no ending; expected one of .gif, .glb, .html, .mp4, .obj, .pdf, .png, .stl, .svg, .tex",
    ),
    ("draw pencil -o .", "is a folder"),
    ("draw pencil -o a.bmp", "ends in '.bmp'"),
    ("draw pencil -o a.svg --width 8furlong", "the width is '8furlong'"),
    ("draw pencil -o a.svg --width -3cm", "the width is '-3cm'"),
    ("draw pencil -o a.svg --font-size 0", "the font size is '0'"),
    ("draw pencil -o a.svg --width 45 --font-size 10pt", "counted as 1/1.43 of it"),
    ("draw pencil -o a.stl --font-size 8", "for pictures"),
    ("draw pencil -o a.pdf --text text", "a choice of .svg"),
    ("draw pencil -o a.svg --text tex", "did you mean text"),
    ("draw pencil -o a.svg --fragment", "a fragment is TikZ"),
    ("draw coordinate-planes -o a.svg --view planes --body torus", "expected one of ball, cube"),
    ("draw coordinate-planes -o a.svg --view planes --lift=++", "2 signs"),
    ("draw coordinate-planes -o a.svg --view planes --lift=+0+", "one + or -"),
    ("draw coordinate-planes -o a.svg --view planes --lift=+++ --lift=+++", "twice"),
    ("draw coincident-planes -o a.svg --view planes --lift=+-+-", "no region"),
    ("draw coordinate-planes -o a.svg --view planes --camera 0 0 0", "not all 0"),
    ("draw coordinate-planes -o a.svg --view sphere --camera 0 0 0", "not all 0"),
    ("draw coordinate-planes -o a.svg --view planes --radius 0", "positive"),
    ("draw coordinate-planes -o a.svg --view planes --centre 5 5 5 --lift=---", "outside the body"),
    ("draw coordinate-planes -o a.svg --view planes --width -3", "width"),
    ("draw coordinate-planes -o a.svg --view planes --colour mood", "or one of planes"),
    ("draw coordinate-planes -o a.svg --view planes --explode 2", "has no option"),
    ("draw coordinate-planes -o a.svg --view planes --model cells", "a model needs"),
    ("draw four.json -o a.svg --view planes", "of rank 4 in R^4"),
    ("draw generic.json -o a.svg --view planes --coordinates given", "at most 40"),
    ("draw coordinate-planes -o a.svg --labels letters", "or one of signs, numbers, none"),
    ("draw braid-a3 -o a.svg --axes x,y", "three names"),
    ("draw coordinate-planes -o a.svg --legend belw", "did you mean below"),
    ("draw coordinate-planes -o a.html --legend below", "legend or theme is for pictures"),
    (
        "draw coordinate-planes -o a.svg --legend right --width 45",
        "without the legend at the right",
    ),
    ("draw generic-lines-affine -o a.svg --faces edges", "expected one of regions, all"),
    ("draw generic-lines-affine -o a.svg --labels sign", "did you mean signs"),
    ("draw generic-lines-affine -o a.svg --faces all --labels numbers", "numbers are for regions"),
    ("draw generic-lines-affine -o a.svg --colour mood", "colour"),
    ("draw generic-lines-affine -o a.svg --width 10", "width"),
    ("draw coordinate-planes -o a.svg --view stereographic --colour mood", "or one of sides"),
    (
        "draw coordinate-planes -o a.svg --view stereographic --whole --camera 1 1 0",
        "lies on circle 3",
    ),
    ("draw coordinate-planes -o a.svg --view gnomonic --width 10", "at least 40 millimetres"),
    ("draw pencil -o a.svg --view dual --hull", "rank 2"),
    ("draw generic.json -o a.svg --view lattice", "at most 500"),
    ("draw parallel-planes-affine -o a.svg --view cells --explode 0.5", "factor from 1 to 3"),
    ("draw generic.json -o a.svg --view cells --coordinates given", "at most"),
    ("draw affine.json -o a.html", "at most"),
    *((f"draw {name}.txt -o a.html", "too large for a picture") for name in ("vast", "tiny")),
    ("draw parallel-planes-affine -o a.html --explode 0.5", "factor from 1 to 3"),
    ("draw four.json -o a.svg --view cells", "lattice"),
    *(
        (f"draw coordinate-planes -o a.glb --model cells {option}", said)
        for option, said in (
            ("--body torus", "expected one of"),
            ("--explode 0.5", "factor"),
            ("--size 0", "size"),
            ("--size -3", "size"),
            ("--colour mood", "colour"),
            ("--lift=+++", "lift"),
            ("--view planes", "the view planes has no model"),
        )
    ),
    ("draw braid-a3 -o a.stl --model shadow", "expected one of dual, cells"),
    ("draw shi-a2-affine -o a.stl --model dual", "affine, of rank"),
    ("draw braid-a3 --view spere -o a.svg", "did you mean sphere"),
    ("draw braid-a3 --view lattice --widht 60 -o a.svg", "\n  --width "),
    ("draw braid-a3 --colour side -o a.svg", "did you mean sides"),
]
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
    ({"friction": -0.5}, "friction is -1/2"),
    ({"friction": float("nan")}, "NaN"),
    ({"friction": None}, "friction"),
    ({"friction": True}, "friction"),
    ({"friction": "1" * 100_001}, "friction"),
    ({"mass": "1"}, "mass"),
    ({"stiffness": "-1"}, "stiffness"),
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
#: Files that hold no grasp.
NO_GRASPS = [
    ("a.xlsx", "PK", "'a.xlsx' is a spreadsheet or another zip archive; save it as CSV"),
    ("a.yaml", "contacts:", "'a.yaml' is YAML; write the same keys and lists as JSON"),
    ("a.csv", "id,x,y,nx,ny,mu\n", "the column 'id' is unknown; leave it out, or name it one"),
    (
        "a.json",
        '{"schema_version": 1, "contacts": [], "load": ["0", "-1", "0"]}',
        "A load is the key wrench of a file, such as [0, -1, 0], or an option: --wrench F_X",
    ),
    (
        "a.json",
        '{"contacts": [{"pos": [0, 0], "n": [0, 1], "share_of": 1}], "mu": 1, "about": 2}',
        "the unknown keys 'mu', 'about'; known keys are schema_version, contacts, description, "
        "units, outline, data_error. Friction, stiffness and preload are keys of each contact; "
        "contacts[0] has the unknown key 'share_of', and lacks \"friction\"; known keys are",
    ),
    (
        "a.json",
        '[{"point": ["0", "0"], "normal": ["0", "1"], "friction": "mu"}]',
        "One letter, such as t, is for `resisted --parameter t=0..1`",
    ),
    ("a.json", "{}", 'add "schema_version": 1, and the key "contacts"'),
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
    (f"{HEADER},z\n", "the column normal_z is missing"),
    (f"{HEADER},nz\n", "the column z is missing"),
    (f"# remark\n\n{HEADER}\n0,0,1,0\n", "line 4 has 4 entries"),
    (f"{HEADER}\n0,0,1,0,1e99999\n", "line 2: "),
    (f'{HEADER}\n0,0,1,0,"1\n', "line"),
    (f"{HEADER}\n0,0,1,0,__import__('os')\n", "not an exact number"),
    (f"{HEADER},stiffness\n0,0,1,0,1,-1\n", "stiffness"),
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
    ('@claim("s", classes=9)\ndef f(p): return True\n', "classes is 3..9"),
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
#: Domains that are none.
NO_FAMILIES = [
    ("catalana(n=2..3)", "did you mean catalan?"),
    ("catalan(k=2..3)", "it has type, m"),
    ("catalan()", "catalan(n=2..6)"),
    ("simplicial", "needs planes and number: simplicial(planes=2..6, number=2..6)"),
    ("simplicial(planes=9)", "needs number: simplicial(planes=9, number=2..6)"),
    ("random-integer(m=3, seed=0..10000)", f"more than {MOST_MEMBERS:,} values"),
    ("random-integer(m=3..103, seed=0..100)", f"give 1 to {MOST_MEMBERS:,}"),
    ("catalan(n=3..2)", "0 members"),
    ("catalan(2)", "not a parameter"),
    ("catalan(n=2, n=3)", "not a parameter"),
    ("(n=2)", "write one as"),
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
    ("24,braid-a3", "line 2 of t.csv: a row needs"),
    ("24,braid-a3,region", "'region' is not a quantity"),
    ("two,braid-a3,regions", "write integers"),
    ("1 2,braid-a3,regions", "one number"),
    ("t=3,braid-a3,t-vector", "write t2=3"),
    ("7,lines seven,types", "write lines n=7"),
    ("7,near-pencil n=7,regions", "no parameter 'n'; it has m, d"),
    ("7,no-such-name,regions", "cannot read"),
    ('"7,braid-a3,regions', "line 2"),
]
#: What is changed of an exercise of the arrangement lab, and of the slip lab.
LINES = {"name": "N", "task": "T", "start": "1|3|1,0,0", "goal": {"counts": {"regions": 4}}}
SLIPS = {"name": "N", "task": "T", "start": "1||0,1,0", "goal": {"resisted": True}}
EXERCISES = [
    *(
        (arrangement, LINES | change, said)
        for change, said in (
            ({"start": "2|3|1,0,0"}, "exercise 1: start: '2|3|1,0,0' is not what a link"),
            ({"start": "1|3|1,0"}, "exercise 1: start: plane '1,0' needs three numbers"),
            ({"start": "1|3|0,0,0"}, "zero"),
            ({"goal": {"colour": 3}}, "must be an object with one of: counts, meet, closes"),
            ({"goal": {"counts": {"colour": 3}}}, "colour"),
            ({"goal": {"meet": [[1, 2]]}}, "three plane numbers"),
            ({"goal": {"closes": {"meet": [[1, 2, 3]]}}}, '"then"'),
            ({"fixed": ["21"]}, "\"fixed\" has '21'"),
        )
    ),
    *(
        (equilibrium, SLIPS | change, said)
        for change, said in (
            ({"goal": {"wins": True}}, "one of: resisted"),
            ({"goal": {"resisted": "yes"}}, "goal resisted: 'yes' must be true or false"),
            ({"goal": {"equilibria": 0}}, "integer above 0"),
            ({"goal": {"gap": False}}, "must be true"),
            ({"goal": {"states": ["slips"]}}, "list of detached"),
            ({"goal": {"method": {"name": "mine", "says": True}}}, "expected one of printed"),
            ({"goal": {"method": "printed"}}, '"name" and "says"'),
            ({"start": "2|"}, "exercise 1: start: '2|'"),
            ({"start": "1|1,2|0,0,0"}, "seven numbers"),
            ({"start": "1|0,0,1,1,1,1,0|0,0,0"}, "normal"),
            ({"fixed": ["colour"]}, "'colour'"),
            ({"fixed": "points"}, "fixed is 'points'; expected a list"),
            ({"name": ""}, '"name" must be a text'),
            ({"extra": 1}, "unknown key 'extra'"),
        )
    ),
]
#: Claims in one line that are none.
TRIED = [
    ("__import__('os').system('touch x') == 0", "is not in the language"),
    ("f_vector.__class__ == 1", "is not in the language"),
    ("(lambda: 1)() == 1", "is not in the language"),
    ("[x for x in f_vector] == m", "is not in the language"),
    ("f'{m}' == m", "is not in the language"),
    ("f_vector[0:2] == m", "is not in the language"),
    ("max(m, key=len) == 1", "'key' is not a quantity"),
    ("True", "is not in the language"),
    ("1.5 > m", "is not in the language"),
    ("p_vectr > 3", "did you mean p_vector"),
    ("chi > 3", "chi(t)"),
    ("m >", "cannot be read"),
    ("m > 1 " + "and m > 1 " * 60, "at most 500"),
    ("(" * 240 + "m" + ")" * 240 + "> 1", "cannot be read"),
    ("9 ** 9 ** 9 > m", "exponent"),
    ("2 ** 4000 * 2 ** 4000 > m", "4096 bits"),
    ("1" * 400 + " * m ** 9999 > 1", "exponent"),
    ("comb(10 ** 9, 3) > m", "comb takes integers"),
    ("m / 0 > 1", "m / 0 divides by 0"),
    ("p_vector[77] > 1", "write .get(key, 0)"),
    ("f_vector.get(1, 1) > 1", "asks a vector for keys; expected one of p_vector"),
    ("f_vector + 1 > 1", "is a vector; expected a number"),
    ("chi(1, 2) > 1", "has 2 arguments; expected 1"),
    ("regions", "is a number; expected a comparison"),
    ("-" * 400 + "m < 0", "402 operations inside each other; expected at most 250"),
    ("m > 1 and regions", "expected a truth value on each side"),
]
OLD = '{"schema_version": 1, "certificate": "unstable", "regions": ""}'
DEEP = '{"schema_version": 1, "certificate": ' + "[" * 10**6 + "]" * 10**6 + "}"
LONG = read_grasp(THREE).to_dict()
LONG["contacts"][0]["point"][1] = "1/" + "7" * 1001
LECTURE = "from proofs_check import exercise\n"
ONE = '@exercise("One?", id="one")\ndef {}(answer): return answer == 1\n'
UP, SPATIAL = "--wrench 0 1 0", "--wrench 0 3/5 4/5 0 0 0"
#: A program, its arguments, what is said, and the files that stand beside the caller.
CASES = [
    (equilibrium, words, said, {})
    for words, said in (
        ("", "required"),
        (f"solve {THREE}", "--wrench"),
        (f"solve {THREE} {UP} --force 0 1", "--force"),
        (f"solve {THREE} {UP} --at 0 1", "--at"),
        (f"solve {THREE} --at 0 1", "--at goes with"),
        (f"solve {THREE} --wrench 0 1", "expected 3"),
        (f"solve {THREE} --wrench 0 1 1e99999", "1e99999"),
        (f"solve {THREE} --wrench 0 1 nan", "nan"),
        (f"solve no-such-grasp {UP}", "no-such-grasp"),
        (f"solve {THREE} {UP} --as-printed everything", "everything"),
        (f"solve {THREE} --preload -1 {UP}", "preload"),
        (
            f"solve {THREE} {UP} --as-printed signs --certificate x",
            "--certificate goes with the verdict of the full model, not with --as-printed",
        ),
        (f"solve {THREE} {UP} --certificate no/x.json", "no"),
        *(
            (f"solve {THREE} {UP} --digits {digits}", "1 to 1000")
            for digits in ("0", "-1", "1001", "1" * 5000, "six", "²")
        ),
        ("verify no-such-file.json", "no-such-file.json"),
        (f"verify {THREE}", THREE),
        (f"resisted {THREE} --wrench 0 0 0", "zero"),
        (f"resisted {THREE} --wrench 0 1", "expected 3"),
        (f"resisted {THREE} --wrench 0 1e99999 0", "1e99999"),
        ("resisted no-such-grasp --wrench 0 1 0", "no-such-grasp"),
        (f"resisted {THREE} --slice fx 2,0,0", "parallel"),
        (f"resisted {THREE} --search --rays 0", "rays"),
        (f"resisted {THREE} --search --tolerance 1e-9999", "at least 2^-200 of max_magnitude"),
        (f"resisted {THREE} {UP} --margin --tolerance 0", "tolerance"),
        (f"solve no-such-grasp {UP} --methods", "no-such-grasp"),
        ("solve two-opposed-fingers --methods --wrench 0 1 1 0 0 0 --cone pyramid:7", "7"),
        (f"solve {THREE} {UP} --methods --cone pyramid:8", "pyramid"),
        ("info box-held-by-four --force-closure --torque 1", "torque"),
        ("info box-held-by-four --force-closure --cone pyramid:6", "takes too long"),
        ("info box-3-walls --modes --time-limit 1/2", "the modes of 12 contacts"),
        *((f"make {form} none.{end}", "none") for form, end in (("csv", "csv"), ("floats", "csv"))),
        ("make floats none.json", "none.json"),
        (f"draw {THREE} -o a.stl --size 1e-4000", "give a number above 0 in mm"),
        (f"draw {THREE} -o a.xml --model scene --wrench 1e-4000 0 0", "smaller than 10^-9"),
        ("info ladder --count", "--count goes with --modes"),
        ("info ladder --modes --norm L1", "--norm goes with --force-closure"),
        ("info ladder --modes --at 0 1", "--at goes with --force or --weight"),
        ("info ladder --force-closure --at 0 1", "--at goes with --force or --weight"),
        ("info ladder --modes --preload 1", "--preload does not go with --modes"),
        (
            "solve ladder --weight 1 --methods --robust friction=1%",
            "--robust goes with the verdict of the full model, not with --methods",
        ),
        ("solve ladder --weight 1 --methods mosek", "there is no method 'mosek'"),
        ("solve wedge --weight 1 --methods printed", "no method 'printed' for one wrench of such"),
        (
            "solve ladder --weight 1 --as-printed signs --max-displacement 1",
            "--max-displacement goes with the verdict of the full model, not with --as-printed",
        ),
        ("resisted wedge --smallest", "no proof for a whole ball"),
        (f"resisted {PRELOADED} --smallest --torque-length 0", "must be above 0"),
        (f"resisted {PRELOADED} --wrench 0 1 0 --torque-length 2", "--torque-length goes with"),
        (f"resisted {PRELOADED} --smallest --at 0 1", "--at goes with"),
        (f"resisted {PRELOADED} --smallest --weight 1", "not allowed with"),
        (
            f"resisted {PRELOADED} --slice fx x",
            "'x'; expected one of fx, fy, tau, or three numbers",
        ),
        (f"resisted {PRELOADED} --slice 1,0 fy", "three numbers such as 1,0,0"),
        (f"resisted {PRELOADED} --slice fx fx", "not parallel"),
        (f"resisted {PRELOADED} --margin", "--margin goes with a load"),
        (f"resisted {PRELOADED} --rays 3", "--rays goes with --search, not with the whole set"),
        (
            f"resisted {PRELOADED} --search --max-displacement 1",
            "--max-displacement does not go with --search",
        ),
        (f"resisted {PRELOADED} --at 0 1", "--at goes with"),
        (
            "resisted two-opposed-fingers --wrench 0 1 0 0 0 0 --margin",
            "--margin is for grasps in the plane and assemblies",
        ),
        *(
            (
                f"resisted {PRELOADED} {UP} --friction {x}",
                f"'{x}' is not the number of a contact; write numbers from 1 on",
            )
            for x in ("0.3", "all", "t")
        ),
        (
            f"resisted {PRELOADED} --best-direction",
            "expected 2 arguments:\n  --best-direction X Y ",
        ),
        (f"solve {PRELOADED} --wrench 0,5 -1 0", "(decimals have a point)"),
        (f"draw {PRELOADED} --slice fx fy -o a.svg", "(views with it: slice)"),
        ("make arch --stones 5", "  --voussoirs "),
        ("info box-on-a-box-1-wall", "expected a grasp with contacts"),
        ("resisted ladder --along a 0 0 1", "--along is for an assembly"),
        ("solve ladder --on a 0 0 1", "--on is for an assembly"),
        ("solve ladder", "there is no wrench"),
        *(
            (f"draw {THREE} -o a.svg {options}", said)
            for options, said in (
                ("--font-size 1e-4000", "the font size is '1e-4000'; give a number above 0"),
                ("--view mood", "mood"),
                ("--view resist --equilibrium 1", "equilibrium"),
                (f"--view polar {UP}", "wrench"),
                ("--equilibrium 2", "nothing is solved"),
                ("--wrench 0 -1 0 --equilibrium 7", "number 7"),
                ("--outline 0,0 1,1", "outline"),
                ("--outline 0,0 1,1 2,x", "entry 2 of corner 3 of the outline"),
                ("--width 5", "width"),
                ("--with 90", "\n  --width "),
                ("--view slices", "did you mean slice"),
                ("--view resist --extend 3", "\n  --extent "),
                ("--view resist --extent 0", "extent"),
                ("--view polar --rays 0", "rays"),
                ("--view compare --methods guess", "expected one of complete"),
                ("--view slice --preload -1", "preload"),
                ("--view methods", "wrench"),
                (f"--view resist {UP} --wrench 0 2 0", "wrench"),
                (f"--view methods {UP} --extent 1", "extent"),
                ("--view proof", "wrench"),
                ("--view proof --wrench 0 -1 0", "the view grasp"),
                (f"--view proof {UP} --rotation 0", "rotation"),
                ("--view wrench-set --extent 0", "above 0"),
                ("--camera 1 2 3", "in space"),
            )
        ),
        (f"draw {THREE} -o a.html --wrench 0 {'9' * 5000} 0", "too large for a picture"),
        *(
            (f"resisted two-opposed-fingers {form}", "in space")
            for form in ("", "--slice fx fy", "--search", "--smallest")
        ),
        (f"solve two-opposed-fingers {SPATIAL} --cone pyramid:5", "even number"),
        (f"solve {THREE} {UP} --max-displacement -1", "max_displacement"),
        *(
            (f"solve {THREE} {UP} --robust {bound}", bound.partition("=")[0])
            for bound in (
                *("degrees", "degrees=x", "degrees=90", "degrees=-1", "degrees=nan", "degrees="),
                *("length=1e99", "friction=120%", "friction=%", "mass=1"),
            )
        ),
        (f"solve {THREE} {UP} --robust degrees=1 degrees=2", "give each once"),
        ("lab -o lab.html --exercises none.json", "cannot read"),
        (
            f"draw {THREE} -o a.bmp",
            "expected one of .gif, .glb, .html, .mp4, .obj, .pdf, .png, .stl, .svg",
        ),
        (f"draw {THREE} -o none/a.svg", "none"),
        ("draw wedge --view resist -o a.svg", "expected one of"),
        ("draw wedge --tolerance 1 -o a.svg", "tolerance"),
        ("draw wedge --outline 0,0 1,1 0,1 -o a.svg", "outline"),
        ("draw wedge --wrench 0,0,-1,0,0,0 --equilibrium 2 -o a.svg", "equilibrium"),
        (f"draw wedge {UP} -o a.svg", "wrench"),
        ("draw single-contact --view wrench-set -o a.stl", "have no volume"),
    )
]
CASES += [
    (equilibrium, words, said, {"a.json": text})
    for words, said, text in (
        *(("solve a.json --wrench 0 0 0 --json", x, grasp(change)) for change, x in CONTACTS),
        *(("make floats a.json", x, json.dumps(FLOATS | change)) for change, x in CONVERTED),
        ("make floats a.json --tolerance -1", "tolerance", json.dumps(FLOATS)),
        ("verify a.json", "this is an old certificate", OLD),
        *(
            (
                "verify a.json",
                "GRASP --wrench F_X F_Y TAU --certificate CERT.json` writes a certificate",
                text,
            )
            for text in (
                *("resisted: 1 family", "x,y,nx,ny,mu\n", "", '{"verdict": "resisted"}', "[]"),
                f"{HEADER},preload\n-1,0,1,0,1/4,1\n1,0,-1,0,1/4,1\n",
            )
        ),
        *((words, "nested", DEEP) for words in ("verify a.json", "solve a.json --wrench 0 0 0")),
        *(
            (f"{c} a.json --weight 1 {more}", f"{m}: 1,001 digits of a number", json.dumps(LONG))
            for c, more, m in (
                ("resisted", "--margin", "margin"),
                ("solve", "--methods", "compare"),
            )
        ),
    )
]
CASES += [
    (equilibrium, f"solve {name} --weight 1", said, {name: text}) for name, text, said in NO_GRASPS
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
ELEMENTS = "--elements 3..4 --samples 9"
SIZE = f"{ELEMENTS} --store s.sqlite"
CASES += [
    (proofs_check, words, said, {})
    for words, said in (
        *((f"{c} table-three", "no claim has the id 'table-three'") for c in ("run", "list")),
        (f"list {'x' * 5000}", "no id is near"),
        ("run nowhere.py", "cannot read nowhere.py"),
        (f"sweep nothing {SIZE}", "no claim has the id 'nothing'"),
        (f"sweep table-three-contacts {SIZE}", "not of random instances"),
        (f"sweep nowhere.py {SIZE}", "cannot read nowhere.py"),
        (f"{SWEEP} --elements 3..4 --store s.sqlite --samples 0", "samples is 0"),
        (f"{SWEEP} {SIZE} --jobs 0", "jobs is 0"),
        (f"{SWEEP} {SIZE} --chunk 0", "chunk is 0"),
        (f"{SWEEP} --samples 9 --store s.sqlite --elements 4..3", "smaller number first"),
        (f"{SWEEP} --samples 9 --store s.sqlite --elements 3-4", "'3-4' is not a range"),
        (f"{SWEEP} {SIZE} --shard 3/2", "'3/2' is not a shard"),
        (
            f"{SWEEP} {ELEMENTS} --store nowhere/s.sqlite",
            "cannot open nowhere/s.sqlite",
        ),
        (f"{SWEEP} {ELEMENTS} --store ''", "it is empty"),
        (f"{SWEEP} {ELEMENTS} --store :memory:", "not a file"),
        ("sweep euler --classes 3..5 --samples 3 --store s.sqlite", "samples"),
        ("sweep euler --classes 8..10 --store s.sqlite", "10"),
        ("sweep --store nowhere.sqlite --status", "there is no store nowhere.sqlite"),
        ("sweep --store out.sqlite --merge nowhere.sqlite", "there is no store nowhere.sqlite"),
        ("fit regions", "--of 'generic(m=2..9)'"),
        ("fit regions --of 'generic(m=2..4, d=2..3)'", "one parameter that varies"),
        ("fit regions --of 'coxeter(type=A3,B3)'", "over integers"),
        ("fit f_vector --of 'generic(m=2..4)'", "f_vector[1]"),
        ("fit 'regions == 2' --of 'generic(m=2..4)'", "not a number"),
        ("fit 'p_vector[3]' --of 'pencil(m=2..4)'", "write .get(key, 0)"),
        ("fit regions --of simple", "no family is"),
        ("list lemma-4", "the nearest are printed-detachment, printed-preload"),
        ("try 'regions <= m**d'", "write rank, or the number: 2 with --of lines"),
        ("try 'regions <= nothing'", "m (planes), rank, regions"),
        *(
            (f"try 'regions > 0' --of {name}", f"{name}(d=2) for lines")
            for name in ("affine", "simple-affine")
        ),
        *((f"try 'm > 0' --of {shlex.quote(of)}", said) for of, said in NO_FAMILIES),
        ("report nowhere.json", "cannot read"),
        ("try 'm > 1' --of grasp", "planes"),
        ("try 'm > 1' --of nothing", "there are central"),
        ("report nowhere.json --output r.doc", "a report ends with .json"),
        ("new nowhere/mine", "nowhere"),
    )
]
CASES += [(proofs_check, "run mine.py", said, {"mine.py": claims(body)}) for body, said in CLAIMS]
CASES += [(proofs_check, "report r.json", "", {"r.json": text}) for text in RECORDS]
CASES += [
    (proofs_check, "run t.csv", said, {"t.csv": f"printed,arrangement,quantity\n{row}\n"})
    for row, said in PRINTED
]
CASES += [
    (proofs_check, words, said, files)
    for words, said, files in (
        ("run t.csv", "no column quantity", {"t.csv": "arrangement,printed\n"}),
        ("new mine", "is there already", {"mine.py": ""}),
        ("run euler mine.py", "ids and files", {"mine.py": claims(CLAIMS[8][0].replace("9", "3"))}),
        (
            f"sweep mine.py {SIZE}",
            "is about a list of instances",
            {"mine.py": claims('@claim("s", of=[1, 2])\ndef f(k): return k < 3\n')},
        ),
        ("grade a.csv", "exercises are a Python file", {"a.csv": "student,a\n"}),
        ("grade q.py", "has no exercises", {"q.py": "x = 1"}),
        ("run --verified own.py", "--verified is for the claims of the paper", {"own.py": ""}),
        ("run fukuda-bound --classes 3..5", "--classes is for claims of FILE.py", {}),
        ("run --samples 9", "those of the paper have fixed cases", {}),
        ("run euler --save made", "--save is for claims of FILE.py", {}),
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


CASES += [
    (program, "lab -o lab.html --exercises own.json", said, {"own.json": json.dumps(own)})
    for program, said, own in (
        *((p, why, {"schema_version": 1, "exercises": [one]}) for p, one, why in EXERCISES),
        (equilibrium, "JSON object", []),
        (equilibrium, "exercises", {"schema_version": 1}),
    )
]
CASES += [
    (proofs_check, f"try {shlex.quote(words)} --classes 3..3 --samples 2", said, {})
    for words, said in TRIED
]
CASES += [
    (arrangement, words, said, {name: text for name, text in FILES.items() if name in words})
    for words, said in ARRANGEMENT
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
    # Each look at the clock takes a second.
    monkeypatch.setattr(deadline, "clock", itertools.count().__next__)
    for name, text in files.items():
        (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    before = sorted(tmp_path.iterdir())
    try:
        code = program(shlex.split(words))
    except SystemExit as stop:
        code = stop.code
    out, err = capsys.readouterr()
    head, *commands = err.splitlines()
    assert (code, out) == (2, "")
    assert head.endswith(":") or not commands
    assert all(line.startswith("  ") for line in commands)
    assert head.startswith("error: ")
    assert said in err
    assert "\x1b" not in err
    assert len(head) < 700
    assert [path for path in sorted(tmp_path.iterdir()) if path.name != "__pycache__"] == before
