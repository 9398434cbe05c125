"""Command lines with something wrong: exit code 2, one line that says what, and no file."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest

from arrangement import Arrangement, families
from arrangement.cli import main
from equilibrium.cli.program import main as grasp_main

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
    ("conut pencil", "there is no 'conut'; known are "),
    ("count pencil extra", "no place for 'extra'"),
    ("count pencil --js", "--js"),
    ("--speet=1", "there is no option '--speet'"),
    ("draw pencil --width '' -o a.svg", "argument --width: it is empty"),
    ("draw coordinate-planes --view planes --radius 50mm -o a.svg", "'50mm' has a unit"),
    (f"faces pencil --dimension {'9' * 5000}", "no whole number of up to 18 digits"),
    ("count no/such/file", "no/such/file"),
    ("faces no/such/file --json", "no/such/file"),
    ("faces three-generic-planes --dimension 4", "dimension"),
    ("faces three-generic-planes --dimension -1", "dimension"),
    ("faces pencil --dimension one", "one"),
    ("faces pencil --dimension 1.5", "1.5"),
    ("count escape.json", "unknown key"),
    ("count prose.sage", "there is no line such as H.<x,y>"),
    ("count prose.m2", "there is no arrangement {...}"),
    ("count prose.csv", "not an exact number"),
    ("count prose.dot", "only written"),
    ("count prose.json", "not valid JSON"),
    ("count complex.json", "embedding"),
    ("count endless.json", "interval"),
    ("count long.json", "1 to 2"),
    ("count float.json", "float"),
    ("count none.json", "expected a JSON object"),
    ("bounds --largest 3", "from 4 to 30"),
    ("bounds --largest 31", "from 4 to 30"),
    ("bounds -o x.html", ".html"),
    ("make shi --type E9", "the type is 'E9'; there are A1"),
    ("make coxeter --type H5", "as mirrors H3, H4 and I2(m)"),
    ("make shi --type A2 --m 0", "m is 0; it must be at least 1"),
    ("make resonance --n 0", "n is 0; it must be at least 1"),
    ("make catalan --type '1-2;2-3'", "write its edges as 1-2,2-3"),
    ("make separations --polytope simplex --n 3", "there are cube, demicube"),
    ("polynomial resonance.json --time-limit 1e-6", "first Whitney numbers 1 are final; give more"),
    ("polynomial shi-a2-affine --primes 5,4", "4 is no prime"),
    ("polynomial shi-a2-affine --primes 2,3", "2 is a prime of bad reduction"),
    ("polynomial shi-a2-affine --primes 5", "give at least 2"),
    ("polynomial shi-a2-affine --primes five", "write 5,7,11"),
    ("polynomial shi-a2-affine --primes 5 --forecast", "not allowed with"),
    ("polynomial shi-a2-affine --time-limit 0 --jobs 2", "positive number"),
    ("polynomial shi-a2-affine --shard 1/2", "need --store"),
    ("identify shi-a2-affine", "cone"),
    ("census show 10", "give"),
    ("census check --sample 5000", "give"),
    ("convert braid-a3", "--to"),
    ("convert braid-a3 -o no.xyz", "'.xyz'; known are"),
    ("convert braid-a3 -o no.txt --to xyz", "xyz"),
    ("convert braid-a3 -o no.txt --to christ", "christ"),
    ("convert h3.json -o no.m2", "this format holds rational ones"),
    ("import dot braid-a3", "dot"),
    *(
        (f"import {form} {name} --number 1", "")
        for form in ("chirotope", "christ", "polymake", "oscar", "json", "sage")
        for name in NONE
    ),
    ("draw pencil -o a.svg --view shadow", "known are sphere, planes"),
    ("draw pencil -o a.svg --colour mood", "mood"),
    ("draw pencil -o a.svg --with 90", "did you mean --width"),
    ("draw pencil -o a.svg --theme drak", "did you mean dark?"),
    ("draw pencil -o a.svg --theme blue", "known are light, dark, mono"),
    ("draw pencil -o a.stl --theme dark", "theme is for pictures"),
    ("draw parallel-planes-affine --view sphere -o a.svg", "planes, cells, lines, lattice"),
    ("draw parallel-planes-affine --view dual -o a.svg", "planes, cells, lines, lattice"),
    ("draw parallel-planes-affine --view stereographic -o a.svg", "planes, cells"),
    ("draw generic-lines-affine --view gnomonic -o a.svg", "planes, cells, lines, lattice"),
    ("draw shi-a2-affine --view graph -o a.svg", "planes, cells, lines, lattice"),
    (
        "draw braid-a3 --view lines -o a.svg",
        "sphere, planes, cells, stereographic, gnomonic, dual, graph, latt",
    ),
    ("draw braid-a3 --view lattice --hull -o a.svg", "hull"),
    ("draw braid-a3 --coordinates cartesian -o a.svg", "cartesian"),
    ("draw pencil -o none/a.svg", "there is no folder"),
    (
        "draw pencil -o a",
        "has no ending; known are .glb, .html, .obj, .pdf, .png, .stl, .svg, .tex",
    ),
    ("draw pencil -o .", "is a folder"),
    ("draw pencil -o a.gif", "ends in '.gif'"),
    ("draw pencil -o a.svg --width 8furlong", "the width is '8furlong'"),
    ("draw pencil -o a.svg --width -3cm", "the width is '-3cm'"),
    ("draw pencil -o a.svg --font-size 0", "the font size is '0'"),
    ("draw pencil -o a.svg --width 45 --font-size 10pt", "counted as 1/1.43 of it"),
    ("draw pencil -o a.stl --font-size 8", "for pictures"),
    ("draw pencil -o a.pdf --text text", "a choice of .svg"),
    ("draw pencil -o a.svg --text tex", "did you mean text"),
    ("draw pencil -o a.svg --fragment", "a fragment is TikZ"),
    ("draw coordinate-planes -o a.svg --view planes --body torus", "known are ball, cube"),
    ("draw coordinate-planes -o a.svg --view planes --lift=++", "2 signs"),
    ("draw coordinate-planes -o a.svg --view planes --lift=+0+", "one + or -"),
    ("draw coordinate-planes -o a.svg --view planes --lift=+++ --lift=+++", "twice"),
    ("draw coincident-planes -o a.svg --view planes --lift=+-+-", "no region"),
    ("draw coordinate-planes -o a.svg --view planes --direction 0 0 0", "not all 0"),
    ("draw coordinate-planes -o a.svg --view sphere --direction 0 0 0", "not all 0"),
    ("draw coordinate-planes -o a.svg --view planes --radius 0", "positive"),
    ("draw coordinate-planes -o a.svg --view planes --centre 5 5 5 --lift=---", "outside the body"),
    ("draw coordinate-planes -o a.svg --view planes --width -3", "width"),
    ("draw coordinate-planes -o a.svg --view planes --colour mood", "known are planes"),
    ("draw coordinate-planes -o a.svg --view planes --explode 2", "has no option"),
    ("draw coordinate-planes -o a.svg --view planes --model cells", "a model needs"),
    ("draw four.json -o a.svg --view planes", "of rank 4 in R^4"),
    ("draw generic.json -o a.svg --view planes --coordinates given", "at most 40"),
    ("draw coordinate-planes -o a.svg --labels letters", "known are signs, numbers, none"),
    ("draw coordinate-planes -o a.svg --antipodes equal", "known are same, opposite"),
    ("draw pencil -o a.svg --colour sides --antipodes same", "antipodes goes with"),
    ("draw braid-a3 -o a.svg --axes x,y", "three names"),
    ("draw coordinate-planes -o a.svg --legend belw", "did you mean below"),
    ("draw coordinate-planes -o a.html --legend below", "legend or theme is for pictures"),
    (
        "draw coordinate-planes -o a.svg --legend right --width 45",
        "without the legend at the right",
    ),
    ("draw generic-lines-affine -o a.svg --faces edges", "known are regions, all"),
    ("draw generic-lines-affine -o a.svg --labels sign", "did you mean signs"),
    ("draw generic-lines-affine -o a.svg --faces all --labels numbers", "numbers are for regions"),
    ("draw generic-lines-affine -o a.svg --colour mood", "colour"),
    ("draw generic-lines-affine -o a.svg --width 10", "width"),
    ("draw coordinate-planes -o a.svg --view stereographic --colour mood", "known are sides"),
    (
        "draw coordinate-planes -o a.svg --view stereographic --whole --direction 1 1 0",
        "lies on plane 3",
    ),
    ("draw coordinate-planes -o a.svg --view gnomonic --width 10", "at least 40 millimetres"),
    ("draw pencil -o a.svg --view dual --hull", "rank 2"),
    ("draw generic.json -o a.svg --view lattice", "at most 500"),
    ("draw parallel-planes-affine -o a.svg --view cells --explode 0.5", "factor from 1 to 3"),
    ("draw generic.json -o a.svg --view cells --coordinates given", "at most"),
    ("draw affine.json -o a.html", "at most"),
    ("draw parallel-planes-affine -o a.html --explode 0.5", "factor from 1 to 3"),
    ("draw four.json -o a.svg --view cells", "lattice"),
    *(
        (f"draw coordinate-planes -o a.glb --model cells {option}", said)
        for option, said in (
            ("--body torus", "known are"),
            ("--explode 0.5", "factor"),
            ("--size 0", "size"),
            ("--size -3", "size"),
            ("--colour mood", "colour"),
            ("--lift=+++", "lift"),
            ("--view planes", "a view needs one of .pdf"),
        )
    ),
    ("draw braid-a3 -o a.stl --model shadow", "known are dual, cells"),
    ("draw shi-a2-affine -o a.stl --model dual", "affine, of rank"),
]
#: Arguments of `equilibrium`.
GRASPS = [
    ("draw paper-three-contacts -o a.svg --with 90", "did you mean --width"),
    (
        f"draw paper-three-contacts --wrench 0 {'9' * 5000} 0 -o a.html",
        "a number of the input is too large for a picture",
    ),
]


@pytest.mark.parametrize(
    ("program", "words", "said"),
    [(main, *row) for row in ARRANGEMENT] + [(grasp_main, *row) for row in GRASPS],
    ids=lambda value: value[:60] if isinstance(value, str) else "",
)
def test_a_mistake_is_one_line_and_leaves_no_file(
    program: object, words: str, said: str, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    for name, text in FILES.items():
        if name in words:
            (tmp_path / name).write_text(text, encoding="utf-8")
    before = sorted(tmp_path.rglob("*"))
    monkeypatch.chdir(tmp_path)
    try:
        code = program(shlex.split(words))  # type: ignore[operator]
    except SystemExit as stop:
        code = stop.code
    out, err = capsys.readouterr()
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert said in err
    assert err.count("\n") == 1
    assert "\x1b" not in err
    assert len(err) < 600
    assert sorted(tmp_path.rglob("*")) == before
