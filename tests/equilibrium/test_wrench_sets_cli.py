import json
import re
from fractions import Fraction
from pathlib import Path

import pytest

from arrangement.console import progress
from equilibrium.cli.program import main
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.inputs import random_grasp

THREE = "paper-three-contacts-preload-1"


def answer(capsys, *argv):
    code = main([*argv, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_limit_prints_the_agreed_document(capsys):
    assert answer(capsys, "limit", THREE, "--direction", "0", "1", "0") == (
        0,
        {"intervals": [["0", "1"]]},
    )
    assert answer(capsys, "limit", THREE, "--direction", "0", "-1/2", "0") == (
        0,
        {"intervals": [["0", None]]},
    )


def test_limit_of_nothing_exits_with_one(capsys):
    arguments = ("--direction", "0", "1", "0", "--base", "0", "1", "0", "--preload", "0")
    assert answer(capsys, "limit", THREE, *arguments) == (1, {"intervals": []})


def test_limit_in_any_direction(capsys):
    code, found = answer(capsys, "limit", THREE, "--any-direction")
    assert code == 0
    assert found["size_squared"] == "4/9"
    assert found["wrench"] == ["2/9", "4/9", "-4/9"]
    assert answer(capsys, "solve", THREE, "--wrench", *found["beyond"])[0] == 1
    code, found = answer(capsys, "limit", THREE, "--any-direction", "--preload", "0")
    assert (code, found["size_squared"]) == (1, "0")
    code, found = answer(capsys, "limit", "interrupted-push", "--any-direction", "--length", "2")
    assert (code, found["length"]) == (0, "2")


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["wedge", "--any-direction"], "no proof says that a whole ball"),
        ([THREE, "--any-direction", "--length", "0"], "must be above 0"),
        ([THREE, "--direction", "0", "1", "0", "--length", "2"], "--length goes with"),
        ([THREE, "--any-direction", "--at", "0", "1"], "--at goes with"),
        ([THREE, "--any-direction", "--weight", "1"], "not allowed with"),
    ],
)
def test_limit_in_any_direction_says_what_is_wrong(capsys, arguments, reason):
    try:
        code = main(["limit", *arguments])
    except SystemExit as stopped:
        code = stopped.code
    assert code == 2
    assert reason in capsys.readouterr().err


def test_region_as_json(capsys):
    code, region = answer(capsys, "region", "paper-three-contacts")
    assert code == 0
    assert region["plane"]["spans"] == [["1", "0", "0"], ["0", "1", "0"]]
    assert region["outline"]["border"] == [{"start": None, "end": None, "direction": ["-1", "0"]}]
    assert {"states", "points", "rays", "lines"} <= set(region["polygons"][0])


def test_the_figure_has_three_parts(capsys):
    """[HaasHeger2018], the three-part figure: the upper ends of the parts at w_x = 0."""
    code, data = answer(capsys, "figure", "paper-three-contacts")
    assert code == 0
    assert set(data) == {"grasp_wrench_space", "no_preload", "preload_1"}
    # Normal forces that sum to 1: contacts 1 and 3 hold w_y = 1/2 with friction 1/2, contact 2
    # holds w_y = -1.
    corners = data["grasp_wrench_space"]["corners"]
    assert ["0", "1/2"] in corners
    assert ["0", "-1"] in corners
    ends = [s[end] for s in data["preload_1"]["outline"]["border"] for end in ("start", "end")]
    assert ["0", "1"] in ends


def test_margin_and_its_remedies(capsys):
    code, found = answer(capsys, "margin", THREE, "--wrench", "0", "2", "0")
    assert code == 1
    assert found["nearest"] == "1/2"
    assert found["preload"]["least"] == "2"
    assert found["friction"]["high"] == "1"


def test_map_says_where_it_errs(capsys, tmp_path):
    code, found = answer(capsys, "map", THREE, "--directions", "4")
    assert (code, found["disagreements"]) == (0, 0)
    _, gaps = answer(capsys, "gaps", "--seed", "29", "--tries", "12")
    assert main(["gaps", "--tries", "12"]) == 0
    assert capsys.readouterr().out.strip()
    path = tmp_path / "gap.json"
    path.write_text(json.dumps(gaps["gaps"][0]["grasp"]))
    code, found = answer(capsys, "map", str(path), "--directions", "4")
    assert code == 1
    assert found["disagreements"] > 0


WITH_UNITS = {
    "limit": ("--direction", "0", "-1", "0"),
    "region": (),
    "polyhedra": (),
    "margin": ("--wrench", "0", "1", "0"),
    "map": ("--directions", "4"),
    "figure": (),
    "compare": ("--wrench", "0", "1", "0"),
    "wrench-space": (),
    "solve": ("--wrench", "0", "1", "0"),
}


#: How forces and torques are marked.
MARKED = {
    "margin": [r"uniform preload in \[1, no end\) kgf"],
    "wrench-space": ["resisted forces at torque 0 kgf furlong:", r"volume +\S+ kgf\^3"],
}


@pytest.fixture
def labelled(tmp_path):
    """The three contacts, once more with units."""
    path = tmp_path / "grasp.json"
    document = read_grasp(THREE).with_units("furlong", "kgf").to_dict()
    path.write_text(json.dumps(document))
    return str(path)


@pytest.mark.parametrize("command", WITH_UNITS)
def test_outputs_carry_the_units_and_nothing_is_converted(capsys, labelled, command):
    main([command, THREE, *WITH_UNITS[command]])
    plain = capsys.readouterr().out
    main([command, labelled, *WITH_UNITS[command]])
    out = capsys.readouterr().out
    assert all(re.search(words, out) for words in MARKED.get(command, ()))
    first, *rest = out.splitlines()
    assert first == "lengths in furlong, forces in kgf, torques in kgf furlong"
    without = [re.sub(r" kgf( furlong|\^[23])?| furlong", "", line) for line in rest]
    assert without == plain.splitlines()
    assert "kgf" not in plain
    _, document = answer(capsys, command, labelled, *WITH_UNITS[command])
    _, bare = answer(capsys, command, THREE, *WITH_UNITS[command])
    holder, other = (x.get("grasp", x) for x in (document, bare))
    assert holder.pop("units") == {"length": "furlong", "force": "kgf"}
    assert document == bare
    assert "units" not in other


def test_polyhedra_hold_the_known_wrenches(capsys):
    _, document = answer(capsys, "polyhedra", THREE)

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
    code, region = answer(capsys, "region", "opposed-contacts", "--preload", "1." + "1" * 4400)
    assert code == 0
    assert max(len(x) for border in region["outline"]["border"] for x in border["direction"]) > 4300


LONG = WITH_UNITS | {"solve": ("--wrench", "-1", "0", "0")}
del LONG["wrench-space"]  # answers at once
ALONE = {"gaps": ("--tries", "2"), "survey": ("--number", "2")}


def arguments(command: str, tmp_path: Path) -> list[str]:
    if command in ALONE:
        return [command, *ALONE[command], "--json"]
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps(random_grasp(3, seed=1).to_dict()))
    return [command, str(path), *LONG[command], "--json"]


@pytest.mark.parametrize("command", [*LONG, *ALONE])
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
