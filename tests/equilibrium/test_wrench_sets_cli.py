import json
import re
from fractions import Fraction

import pytest

from arrangement.console import progress
from equilibrium import Assembly, solve
from equilibrium.grasps.inputs import random_grasp, read_any
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.model.labels import AS_ROUNDED

THREE = "paper-three-contacts-preload-1"


def test_magnitudes_print_the_agreed_document(run):
    lifts = {"slips": [], "lifts_off": [2], "tips": [], "unloaded": []}
    for wrench, end, gives in (("0 1 0", "1", lifts), ("0 -1/2 0", None, None)):
        document = {"intervals": [["0", end]], "gives": [[None, gives]]}
        assert run.json(f"resisted {THREE} --wrench {wrench}") == document


def test_no_magnitude_exits_with_one(run):
    asked = "resisted {} --wrench 0 1 0 --base 0 1 0 --preload 0"
    assert run.json(asked, THREE, code=1) == {"intervals": [], "gives": []}


def test_smallest_unresisted_wrench(run):
    found = run.json("resisted {} --smallest", THREE)
    assert found["size_squared"] == "4/9"
    assert found["wrench"] == ["2/9", "4/9", "-4/9"]
    run("solve", THREE, "--wrench", *found["beyond"], code=1)
    assert run.json("resisted {} --smallest --preload 0", THREE, code=1)["size_squared"] == "0"
    found = run.json("resisted interrupted-push --smallest --torque-length 2")
    assert found["length"] == "2"


def test_slice_as_json(run):
    region = run.json("resisted paper-three-contacts --slice fx fy")
    assert region["plane"]["spans"] == [["1", "0", "0"], ["0", "1", "0"]]
    assert region["outline"]["border"] == [{"start": None, "end": None, "direction": ["-1", "0"]}]
    assert {"states", "points", "rays", "lines"} <= set(region["polygons"][0])


def test_the_data_of_a_slice_have_three_parts(run, tmp_path):
    """[HaasHeger2018], the three-part figure: the upper ends of the parts at w_x = 0."""
    path = tmp_path / "slice.json"
    made = run.json("draw paper-three-contacts --view slice -o", path)
    assert made == {"output": str(path), "view": "slice"}
    data = json.loads(path.read_text())
    assert set(data) == {"grasp_wrench_space", "no_preload", "preload_1"}
    # Normal forces that sum to 1: contacts 1 and 3 hold w_y = 1/2 with friction 1/2, contact 2
    # holds w_y = -1.
    corners = data["grasp_wrench_space"]["corners"]
    assert ["0", "1/2"] in corners
    assert ["0", "-1"] in corners
    ends = [s[end] for s in data["preload_1"]["outline"]["border"] for end in ("start", "end")]
    assert ["0", "1"] in ends


def test_margin_and_its_remedies(run):
    found = run.json("resisted {} --wrench 0 2 0 --margin", THREE, code=1)
    assert found["nearest"] == "1/2"
    assert found["preload"]["least"] == "2"
    assert found["friction"]["high"] == "1"


LADDER = "x,y,angle,mu\n0,0,90,1\n4,3,180,0\n"


@pytest.mark.parametrize("bodies", [False, True])
def test_margin_leaves_smooth_contacts_smooth_unless_named(tmp_path, run, refused, bodies):
    path, load = tmp_path / "ladder.csv", ["--weight", "1", "--at", "2", "0"]
    path.write_text(LADDER)
    if bodies:
        document = Assembly.of_grasp(read_any(path).grasp).to_dict({"object": [0, -1, -2]})
        path, load = tmp_path / "ladder.json", []
        path.write_text(json.dumps(document))
    asked = ["resisted", str(path), *load, "--margin"]
    for contacts, line in [
        ([], "least uniform friction with contact 2 smooth: 0.66667 "),
        (["1", "2"], "least friction of contacts 1, 2: 0.5 "),
        (["2"], "least friction of contact 2: 0\n"),
    ]:
        assert line in run(*asked, *(["--contacts", *contacts] if contacts else []))
    assert run.json(*asked)["friction"]["contacts"] == [1]
    error = refused(*asked, "--contacts", "3")
    assert "contacts are [3]; expected numbers of contacts from 1 to 2" in error


def test_friction_that_is_never_enough_is_called_so(run):
    printed = run("resisted paper-three-contacts --wrench 0 1 0 --margin", code=1)
    assert "least uniform friction: none is enough\n" in printed


#: A contact of constant force, and a groove whose smooth contacts meet nearly below the load.
SOFT = "x,y,nx,ny,mu,q,stiffness\n0,0,1,1,0.5,1,0\n"
GROOVE = """x,y,nx,ny,mu
-0.573576436,-0.819152044,0.573576436,0.819152044,0
0.882947593,-0.469471563,-0.882947593,0.469471563,0
"""
FINGERS = "x,y,nx,ny,mu,q\n-1,0,1,1,0.5,1\n1,0,-1,1,0.5,1\n"


@pytest.mark.parametrize(
    ("table", "code", "of_load", "of_margin"),
    [
        (
            FINGERS,
            0,
            [f"resisted for t in [0, oo), {AS_ROUNDED}", "resisted from 0 on"],
            [f"by a factor in [0, oo), {AS_ROUNDED}", "preload in [0, oo), for the data as"],
        ),
        (
            SOFT,
            1,
            [f"resisted for no t, {AS_ROUNDED}", "resisted for no t"],
            [
                f"by no factor, {AS_ROUNDED}",
                "resisted with no uniform preload, for the data as rounded",
                "none is enough, for the data as rounded",
            ],
        ),
        (
            GROOVE,
            3,
            [
                "depends on the rounding: resisted for t in [0, oo), for other data within the",
                "for the data as rounded: resisted at 0 only\n",
            ],
            ["depends on the rounding: resisted when scaled by a factor in [0, oo), for other"],
        ),
    ],
)
def test_sets_of_rounded_data_are_called_so(table, code, of_load, of_margin, tmp_path, run):
    path = tmp_path / "rounded.csv"
    path.write_text(table)
    asked = ["resisted", str(path), "--weight", "1"]
    for option, lines in (([], of_load), (["--margin"], of_margin)):
        text = run(*asked, *option, code=code)
        assert all(line in text for line in lines), text
        assert run.json(*asked, *option, code=code)["as_rounded"] is True


def test_verdicts_in_space_are_printed_for_all_magnitudes_tried(run, tmp_path):
    path = tmp_path / "pads.csv"
    path.write_text("x,y,z,nx,ny,nz,mu,q,pad\n-1,0,0,1,0,0,0.5,1,0.5\n1,0,0,-1,0,0,0.5,1,0.5\n")
    first, *_, last = run("resisted {} --wrench 0 0 -1 0 0 0", path).splitlines()
    _, beyond = first.split(": resisted at each from 0 to 1, ")
    assert "undecided at" in beyond
    assert "resisted at" not in beyond.replace("not resisted at", "")
    assert last.startswith("other t, between these and beyond, are not covered")
    printed = run("info {} --force-closure", path)
    assert "the hull of 2 contacts (10 points) with 4 edges each" in printed


def test_slice_by_names_is_the_one_by_vectors(run):
    by_names = run.json("resisted {} --slice fy tau --origin 1 0 0", THREE)
    assert by_names == run.json("resisted {} --slice 0,1,0 0,0,1 --origin 1,0,0", THREE)
    region = run.json("resisted {} --slice {} fy", THREE, "-1, 0, 1/2")
    assert region["plane"]["spans"][0] == ["-1", "0", "1/2"]


def test_search_says_where_it_errs(run):
    assert run.json("resisted {} --search --rays 4", THREE)["disagreements"] == 0
    found = run.json("resisted interrupted-resistance --search --rays 4", code=1)
    assert found["disagreements"] > 0


WITH_UNITS = {
    "resisted --wrench 0 -1 0",
    "resisted --slice fx fy",
    "resisted",
    "resisted --wrench 0 1 0 --margin --tolerance 1/4",
    "resisted --search --rays 4",
    "solve --wrench 0 1 0 --methods",
    "info",
    "info --force-closure",
    "solve --wrench 0 1 0",
}


#: How forces and torques are marked.
MARKED = {
    "resisted --wrench 0 1 0 --margin --tolerance 1/4": [r"uniform preload in \[1, oo\) kgf"],
    "info --force-closure": ["resisted forces at torque 0 kgf furlong:", r"volume +\S+ kgf\^3"],
}


def with_grasp(words: str) -> str:
    """Return a command line with the place of the grasp, which is after the command."""
    return words.replace(" ", " {} ", 1) if " " in words else f"{words} {{}}"


@pytest.fixture
def labelled(tmp_path):
    """The three contacts, once more with units."""
    path = tmp_path / "grasp.json"
    document = read_grasp(THREE).with_units("furlong", "kgf").to_dict()
    path.write_text(json.dumps(document))
    return str(path)


@pytest.mark.parametrize("command", sorted(WITH_UNITS))
def test_outputs_carry_the_units_and_nothing_is_converted(run, labelled, command):
    plain, out = (run(with_grasp(command), grasp) for grasp in (THREE, labelled))
    assert all(re.search(words, out) for words in MARKED.get(command, ()))
    first, *rest = out.splitlines()
    assert first == "lengths in furlong, forces in kgf, torques in kgf furlong"
    # Whether motions are too large is known only where they have a unit.
    known = [line for line in rest if not line.startswith("beyond small motions")]
    without = [re.sub(r" kgf( furlong|\^[23])?| furlong| \(kgf\)", "", line) for line in known]
    # The columns of a table are as wide as its heads.
    assert [x.split() for x in without] == [x.split() for x in plain.splitlines()]
    assert "kgf" not in plain
    document, bare = (run.json(with_grasp(command), grasp) for grasp in (labelled, THREE))
    holder, other = (x.get("grasp", x) for x in (document, bare))
    assert holder.pop("units") == {"length": "furlong", "force": "kgf"}
    assert "warnings" not in bare
    document.pop("warnings", None)
    assert document == bare
    assert "units" not in other


def test_polyhedra_hold_the_known_wrenches(run):
    document = run.json("resisted", THREE)

    def holds(wrench):
        point = [*map(Fraction, wrench), 1]
        return any(
            all(_dot(row, point) >= 0 for row in piece["inequalities"])
            and all(_dot(row, point) == 0 for row in piece["equalities"])
            for piece in document["polyhedra"]
        )

    assert holds((0, 1, 0))
    assert not holds((0, "11/10", 0))


def _dot(row, point):
    return sum(Fraction(a) * b for a, b in zip(row, point, strict=True))


def test_borders_with_thousands_of_digits_are_written(run):
    region = run.json("resisted opposed-contacts --slice fx fy --preload", "1." + "1" * 4400)
    assert max(len(x) for border in region["outline"]["border"] for x in border["direction"]) > 4300


# These answer at once.
LONG = WITH_UNITS - {"info", "info --force-closure", "solve --wrench 0 1 0"} | {
    "solve --wrench -1 0 0"
}


@pytest.mark.parametrize("command", sorted(LONG))
def test_the_line_is_on_stderr_of_a_terminal_only(command, tmp_path, run, monkeypatch):
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps(random_grasp(3, seed=1).to_dict()))
    piped = run.json(with_grasp(command), path, code=None)
    assert run.err == ""
    monkeypatch.setattr(progress, "on_terminal", lambda: True)
    monkeypatch.setattr(progress, "_PATIENCE", 0.0)
    assert run.json(with_grasp(command), path, code=None) == piped
    assert "left" in run.err
    assert run.err.endswith("\r\x1b[K")


def test_caveat_of_rounded_data_is_no_extra_line(tmp_path, run):
    flat, ball = tmp_path / "flat.csv", tmp_path / "ball.csv"
    flat.write_text(SOFT)
    ball.write_text("x,y,z,nx,ny,nz,mu,q\n-1,0,0,1,1,0,0.5,1\n1,0,0,-1,1,0,0.5,1\n")
    for asked in ([flat, "--wrench=0,0,0", "--margin"], [ball, "--wrench=0,0,0,0,0,1"]):
        lines = run("resisted", *asked, code=None).splitlines()
        assert AS_ROUNDED not in lines
        assert sum(x.startswith("resisted") and x.endswith(AS_ROUNDED) for x in lines) >= 1
        assert run.json("resisted", *asked, code=None)["as_rounded"] is True


def test_reprs_of_verdicts_on_rounded_data_say_so(tmp_path):
    path = tmp_path / "rounded.csv"
    path.write_text(GROOVE)
    grasp = read_any(path).grasp
    bodies = Assembly.of_grasp(grasp)
    for verdict in (solve(grasp, (0, -1, 0)), solve(bodies, {"object": (0, -1, 0)})):
        assert "Verdict: not resisted for the data as rounded, " in repr(verdict)


TABLE = "x,y,nx,ny,friction,preload\n-1,0,1,0,{f},1\n1,0,-1,0,{f},1\n"


def test_numbers_of_contacts_may_have_commas(tmp_path, run):
    path = tmp_path / "two.csv"
    path.write_text(TABLE.format(f="1/4"))
    words = ["resisted", str(path), "--wrench", "0", "-1", "0", "--friction"]
    plain = run.json(*words, "1", "2")
    assert run.json(*words, "1,2") == run.json(*words, "1, 2") == plain


@pytest.mark.parametrize("command", ["solve", "resisted", "info", "draw"])
@pytest.mark.parametrize("ending", ["csv", "json"])
def test_letter_in_the_data_is_referred_to_its_option(command, ending, tmp_path, refused):
    path = tmp_path / f"letter.{ending}"
    path.write_text(TABLE.format(f="2*t"))
    if ending == "json":
        entry = {"point": [0, 0], "normal": [1, 0], "friction": "t"}
        path.write_text(json.dumps({"schema_version": 1, "contacts": [entry]}))
    options = {"info": [], "draw": ["-o", str(tmp_path / "a.svg")]}
    words = options.get(command, ["--wrench", "0", "-1", "0"])
    assert "`resisted --parameter t=0..1`" in refused(command, str(path), *words)
    path = tmp_path / "unit.csv"
    path.write_text(TABLE.format(f="1 N"))
    assert "--parameter" not in refused(command, str(path), *words)
