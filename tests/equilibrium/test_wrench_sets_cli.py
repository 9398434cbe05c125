import json
import re
import sys
from fractions import Fraction
from pathlib import Path

import pytest

from arrangement.console import progress
from equilibrium import Assembly, solve
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import random_grasp, read_any
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.model.labels import AS_ROUNDED

THREE = "paper-three-contacts-preload-1"


def answer(capsys, *argv):
    code = main([*argv, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_magnitudes_print_the_agreed_document(capsys):
    assert answer(capsys, "resisted", THREE, "--wrench", "0", "1", "0") == (
        0,
        {
            "intervals": [["0", "1"]],
            "gives": [[None, {"slips": [], "lifts_off": [2], "tips": [], "unloaded": []}]],
        },
    )
    assert answer(capsys, "resisted", THREE, "--wrench", "0", "-1/2", "0") == (
        0,
        {"intervals": [["0", None]], "gives": [[None, None]]},
    )


def test_no_magnitude_exits_with_one(capsys):
    arguments = ("--wrench", "0", "1", "0", "--base", "0", "1", "0", "--preload", "0")
    assert answer(capsys, "resisted", THREE, *arguments) == (1, {"intervals": [], "gives": []})


def test_smallest_unresisted_wrench(capsys):
    code, found = answer(capsys, "resisted", THREE, "--smallest")
    assert code == 0
    assert found["size_squared"] == "4/9"
    assert found["wrench"] == ["2/9", "4/9", "-4/9"]
    assert answer(capsys, "solve", THREE, "--wrench", *found["beyond"])[0] == 1
    code, found = answer(capsys, "resisted", THREE, "--smallest", "--preload", "0")
    assert (code, found["size_squared"]) == (1, "0")
    code, found = answer(
        capsys, "resisted", "interrupted-push", "--smallest", "--torque-length", "2"
    )
    assert (code, found["length"]) == (0, "2")


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["wedge", "--smallest"], "no proof for a whole ball"),
        ([THREE, "--smallest", "--torque-length", "0"], "must be above 0"),
        ([THREE, "--wrench", "0", "1", "0", "--torque-length", "2"], "--torque-length goes with"),
        ([THREE, "--smallest", "--at", "0", "1"], "--at goes with"),
        ([THREE, "--smallest", "--weight", "1"], "not allowed with"),
        ([THREE, "--slice", "fx", "x"], "'x'; expected one of fx, fy, tau, or three numbers"),
        ([THREE, "--slice", "1,0", "fy"], "three numbers such as 1,0,0"),
        ([THREE, "--slice", "fx", "fx"], "not parallel"),
        ([THREE, "--margin"], "--margin goes with a load"),
        ([THREE, "--rays", "3"], "--rays goes with --search, not with the whole set"),
        (
            [THREE, "--search", "--max-displacement", "1"],
            "--max-displacement does not go with --search",
        ),
        ([THREE, "--at", "0", "1"], "--at goes with"),
    ],
)
def test_options_of_other_forms_are_refused(capsys, arguments, reason):
    try:
        code = main(["resisted", *arguments])
    except SystemExit as stopped:
        code = stopped.code
    assert code == 2
    assert reason in capsys.readouterr().err


def test_slice_as_json(capsys):
    code, region = answer(capsys, "resisted", "paper-three-contacts", "--slice", "fx", "fy")
    assert code == 0
    assert region["plane"]["spans"] == [["1", "0", "0"], ["0", "1", "0"]]
    assert region["outline"]["border"] == [{"start": None, "end": None, "direction": ["-1", "0"]}]
    assert {"states", "points", "rays", "lines"} <= set(region["polygons"][0])


def test_the_data_of_a_slice_have_three_parts(capsys, tmp_path):
    """[HaasHeger2018], the three-part figure: the upper ends of the parts at w_x = 0."""
    path = tmp_path / "slice.json"
    words = ["paper-three-contacts", "--view", "slice", "-o", str(path)]
    assert answer(capsys, "draw", *words) == (0, {"output": str(path), "view": "slice"})
    data = json.loads(path.read_text())
    assert set(data) == {"grasp_wrench_space", "no_preload", "preload_1"}
    # Normal forces that sum to 1: contacts 1 and 3 hold w_y = 1/2 with friction 1/2, contact 2
    # holds w_y = -1.
    corners = data["grasp_wrench_space"]["corners"]
    assert ["0", "1/2"] in corners
    assert ["0", "-1"] in corners
    ends = [s[end] for s in data["preload_1"]["outline"]["border"] for end in ("start", "end")]
    assert ["0", "1"] in ends


def test_margin_and_its_remedies(capsys):
    code, found = answer(capsys, "resisted", THREE, "--wrench", "0", "2", "0", "--margin")
    assert code == 1
    assert found["nearest"] == "1/2"
    assert found["preload"]["least"] == "2"
    assert found["friction"]["high"] == "1"


LADDER = "x,y,angle,mu\n0,0,90,1\n4,3,180,0\n"


@pytest.mark.parametrize("bodies", [False, True])
def test_margin_leaves_smooth_contacts_smooth_unless_named(tmp_path, capsys, bodies):
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
        assert main([*asked, *(["--contacts", *contacts] if contacts else [])]) == 0
        assert line in capsys.readouterr().out
    assert answer(capsys, *asked)[1]["friction"]["contacts"] == [1]
    assert main([*asked, "--contacts", "3"]) == 2
    assert "contacts are [3]; expected numbers of contacts from 1 to 2" in capsys.readouterr().err


def test_friction_that_is_never_enough_is_called_so(capsys):
    assert main(["resisted", "paper-three-contacts", "--wrench", "0", "1", "0", "--margin"]) == 1
    assert "least uniform friction: none is enough\n" in capsys.readouterr().out


def test_margin_in_space_is_refused(capsys):
    asked = ["resisted", "two-opposed-fingers", "--wrench", *"010000", "--margin"]
    assert main(asked) == 2
    assert "--margin is for grasps in the plane and assemblies" in capsys.readouterr().err


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
def test_sets_of_rounded_data_are_called_so(table, code, of_load, of_margin, tmp_path, capsys):
    path = tmp_path / "rounded.csv"
    path.write_text(table)
    asked = ["resisted", str(path), "--weight", "1"]
    for option, lines in (([], of_load), (["--margin"], of_margin)):
        assert main([*asked, *option]) == code
        text = capsys.readouterr().out
        assert all(line in text for line in lines), text
        found, document = answer(capsys, *asked, *option)
        assert (found, document["as_rounded"]) == (code, True)


def test_verdicts_in_space_are_printed_for_all_magnitudes_tried(capsys, tmp_path):
    path = tmp_path / "pads.csv"
    path.write_text("x,y,z,nx,ny,nz,mu,q,pad\n-1,0,0,1,0,0,0.5,1,0.5\n1,0,0,-1,0,0,0.5,1,0.5\n")
    assert main(["resisted", str(path), "--wrench", *["0", "0", "-1", "0", "0", "0"]]) == 0
    first, *_, last = capsys.readouterr().out.splitlines()
    _, beyond = first.split(": resisted at each from 0 to 1, ")
    assert "undecided at" in beyond
    assert "resisted at" not in beyond.replace("not resisted at", "")
    assert last.startswith("other t, between these and beyond, are not covered")
    assert main(["info", str(path), "--force-closure"]) == 0
    assert "the hull of 2 contacts (10 points) with 4 edges each" in capsys.readouterr().out


def test_slice_by_names_is_the_one_by_vectors(capsys):
    by_names = answer(capsys, "resisted", THREE, "--slice", "fy", "tau", "--origin", "1", "0", "0")
    vectors = ("--slice", "0,1,0", "0,0,1", "--origin", "1,0,0")
    assert by_names == answer(capsys, "resisted", THREE, *vectors)
    code, region = answer(capsys, "resisted", THREE, "--slice", "-1, 0, 1/2", "fy")
    assert (code, region["plane"]["spans"][0]) == (0, ["-1", "0", "1/2"])


def test_search_says_where_it_errs(capsys):
    code, found = answer(capsys, "resisted", THREE, "--search", "--rays", "4")
    assert (code, found["disagreements"]) == (0, 0)
    code, found = answer(capsys, "resisted", "interrupted-resistance", "--search", "--rays", "4")
    assert code == 1
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


def with_grasp(words: str, grasp: str) -> list[str]:
    """Return a command line, with the grasp after the command."""
    command, *options = words.split()
    return [command, grasp, *options]


@pytest.fixture
def labelled(tmp_path):
    """The three contacts, once more with units."""
    path = tmp_path / "grasp.json"
    document = read_grasp(THREE).with_units("furlong", "kgf").to_dict()
    path.write_text(json.dumps(document))
    return str(path)


@pytest.mark.parametrize("command", sorted(WITH_UNITS))
def test_outputs_carry_the_units_and_nothing_is_converted(capsys, labelled, command):
    main(with_grasp(command, THREE))
    plain = capsys.readouterr().out
    main(with_grasp(command, labelled))
    out = capsys.readouterr().out
    assert all(re.search(words, out) for words in MARKED.get(command, ()))
    first, *rest = out.splitlines()
    assert first == "lengths in furlong, forces in kgf, torques in kgf furlong"
    # Whether motions are too large is known only where they have a unit.
    known = [line for line in rest if not line.startswith("beyond small motions")]
    without = [re.sub(r" kgf( furlong|\^[23])?| furlong| \(kgf\)", "", line) for line in known]
    # The columns of a table are as wide as its heads.
    assert [x.split() for x in without] == [x.split() for x in plain.splitlines()]
    assert "kgf" not in plain
    _, document = answer(capsys, *with_grasp(command, labelled))
    _, bare = answer(capsys, *with_grasp(command, THREE))
    holder, other = (x.get("grasp", x) for x in (document, bare))
    assert holder.pop("units") == {"length": "furlong", "force": "kgf"}
    assert "warnings" not in bare
    document.pop("warnings", None)
    assert document == bare
    assert "units" not in other


def test_polyhedra_hold_the_known_wrenches(capsys):
    _, document = answer(capsys, "resisted", THREE)

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


def test_borders_with_thousands_of_digits_are_written(capsys):
    words = ("opposed-contacts", "--slice", "fx", "fy", "--preload", "1." + "1" * 4400)
    code, region = answer(capsys, "resisted", *words)
    assert code == 0
    assert max(len(x) for border in region["outline"]["border"] for x in border["direction"]) > 4300


# These answer at once.
LONG = WITH_UNITS - {"info", "info --force-closure", "solve --wrench 0 1 0"} | {
    "solve --wrench -1 0 0"
}


def arguments(command: str, tmp_path: Path) -> list[str]:
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps(random_grasp(3, seed=1).to_dict()))
    return [*with_grasp(command, str(path)), "--json"]


@pytest.mark.parametrize("command", sorted(LONG))
def test_the_line_is_on_stderr_of_a_terminal_only(command, tmp_path, capsys, monkeypatch):
    words = arguments(command, tmp_path)
    main(words)
    piped = capsys.readouterr()
    assert piped.err == ""
    monkeypatch.setattr(progress, "on_terminal", lambda: True)
    monkeypatch.setattr(progress, "_PATIENCE", 0.0)
    main(words)
    seen = capsys.readouterr()
    assert seen.out == piped.out
    assert "left" in seen.err
    assert seen.err.endswith("\r\x1b[K")


def test_caveat_of_rounded_data_is_no_extra_line(tmp_path, capsys):
    flat, ball = tmp_path / "flat.csv", tmp_path / "ball.csv"
    flat.write_text(SOFT)
    ball.write_text("x,y,z,nx,ny,nz,mu,q\n-1,0,0,1,1,0,0.5,1\n1,0,0,-1,1,0,0.5,1\n")
    for asked in ([flat, "--wrench=0,0,0", "--margin"], [ball, "--wrench=0,0,0,0,0,1"]):
        main(["resisted", *map(str, asked)])
        lines = capsys.readouterr().out.splitlines()
        assert AS_ROUNDED not in lines
        assert sum(x.startswith("resisted") and x.endswith(AS_ROUNDED) for x in lines) >= 1
        assert answer(capsys, "resisted", *map(str, asked))[1]["as_rounded"] is True


def test_reprs_of_verdicts_on_rounded_data_say_so(tmp_path):
    path = tmp_path / "rounded.csv"
    path.write_text(GROOVE)
    grasp = read_any(path).grasp
    bodies = Assembly.of_grasp(grasp)
    for verdict in (solve(grasp, (0, -1, 0)), solve(bodies, {"object": (0, -1, 0)})):
        assert "Verdict: not resisted for the data as rounded, " in repr(verdict)


TABLE = "x,y,nx,ny,friction,preload\n-1,0,1,0,{f},1\n1,0,-1,0,{f},1\n"


def refused(capsys, *argv) -> str:
    with pytest.raises(SystemExit) as stopped:
        sys.exit(main([*argv]))
    assert stopped.value.code == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    return err


def test_numbers_of_contacts_may_have_commas(tmp_path, capsys):
    path = tmp_path / "two.csv"
    path.write_text(TABLE.format(f="1/4"))
    words = ["resisted", str(path), "--wrench", "0", "-1", "0", "--friction"]
    plain = answer(capsys, *words, "1", "2")
    assert plain[0] == 0
    assert answer(capsys, *words, "1,2") == answer(capsys, *words, "1, 2") == plain


@pytest.mark.parametrize("value", ["0.3", "all", "t"])
def test_friction_that_is_no_contact_is_explained(value, capsys):
    err = refused(capsys, "resisted", THREE, "--friction", value, "--wrench", "0", "1", "0")
    assert f"'{value}' is not the number of a contact; write numbers from 1 on" in err


def test_missing_values_and_lost_numbers_are_named(capsys):
    assert "expected 2 arguments: X Y" in refused(capsys, "resisted", THREE, "--best-direction")
    assert "; write --wrench F_X F_Y TAU" in refused(capsys, "solve", THREE, "0,-1,0")
    err = refused(capsys, "solve", THREE, "--wrench", "0,5", "-1", "0")
    assert "(decimals have a point)" in err
    assert "(views with it: slice)" in refused(
        capsys, "draw", THREE, "--slice", "fx", "fy", "-o", "a.svg"
    )
    words = refused(capsys, "make", "arch", "--stones", "5")
    assert "write 'equilibrium make arch --voussoirs N -o ARCH.json'" in words


def test_table_is_not_a_certificate(tmp_path, capsys):
    path = tmp_path / "two.csv"
    path.write_text(TABLE.format(f="1/4"))
    assert "--certificate CERT.json` writes" in refused(capsys, "verify", str(path))


@pytest.mark.parametrize("command", ["solve", "resisted", "info", "draw"])
@pytest.mark.parametrize("ending", ["csv", "json"])
def test_letter_in_the_data_is_referred_to_its_option(command, ending, tmp_path, capsys):
    path = tmp_path / f"letter.{ending}"
    path.write_text(TABLE.format(f="2*t"))
    if ending == "json":
        entry = {"point": [0, 0], "normal": [1, 0], "friction": "t"}
        path.write_text(json.dumps({"schema_version": 1, "contacts": [entry]}))
    options = {"info": [], "draw": ["-o", str(tmp_path / "a.svg")]}
    words = options.get(command, ["--wrench", "0", "-1", "0"])
    assert "`resisted --parameter t=0..1`" in refused(capsys, command, str(path), *words)
    path = tmp_path / "unit.csv"
    path.write_text(TABLE.format(f="1 N"))
    assert "--parameter" not in refused(capsys, command, str(path), *words)
