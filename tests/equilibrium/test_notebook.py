"""What notebooks show: verdicts as a picture with a table of forces, a grasp as its picture."""

import base64
import sys
from fractions import Fraction
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given

from arrangement.numbers.exact import to_text
from equilibrium import Contact, Grasp, Report, Units, read_grasp, solve, unit_normal
from equilibrium.grasps.textbook import wedge
from equilibrium.model.outline import Circle, Polygon
from equilibrium.pictures.notebook import MOST_PIECES, verdict_table

from .strategies import grasps, wrenches


def shown(grasp: Grasp, wrench: Any) -> str:
    return solve(grasp, wrench)._repr_html_()


@given(grasp=grasps(), wrench=wrenches)
def test_tables_hold_every_state_and_exact_force(grasp, wrench):
    verdict = solve(grasp, wrench)
    page = ET.fromstring(verdict_table(verdict))
    pieces = verdict.equilibria[:MOST_PIECES]
    expected = [
        [str(i), state, *map(to_text, pair)]
        for piece in pieces
        for i, (state, pair) in enumerate(zip(piece.states, piece.forces, strict=True), 1)
    ]
    rows = [[cell.text for cell in row] for row in page.iter("tr")]
    assert [row for row in rows if row[0] != "contact"] == expected
    assert ("no equilibrium" in "".join(page.itertext())) is not verdict.stable


def test_units_are_escaped():
    grasp = read_grasp("paper-three-contacts").with_units("<b>mm", "N&")
    assert grasp.units == Units("<b>mm", "N&")
    page = shown(grasp, (0, -1, 0))
    assert "&lt;b&gt;mm" in page
    assert "<b>mm" not in page


@pytest.mark.parametrize("size", [30, 500, 5000])
def test_long_numbers_rounded_with_a_sign(size):
    force = Fraction(10**size, 3)
    page = shown(Grasp([Contact((0, 0), (0, 1), 1)]), (0, -force, 0))
    assert "≈" in page
    titles = [cell.get("title") or "" for cell in ET.fromstring(page).iter("span")]
    assert titles
    assert all(to_text(force).startswith(title.strip("-…")[:20]) for title in titles)


def test_a_grasp_shows_its_picture(monkeypatch):
    grasp = read_grasp("paper-four-contacts-preload-1")
    picture = grasp._repr_svg_()
    assert picture is not None
    assert ET.fromstring(picture).tag.endswith("svg")
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert grasp._repr_svg_() is None


def named(picture: str | None) -> set[str]:
    """Return the names of the elements of a picture."""
    assert picture is not None
    return {item.get("id", "").partition("-")[0] for item in ET.fromstring(picture).iter()}


@pytest.mark.parametrize(
    ("name", "wrench", "forces"),
    [
        ("paper-four-contacts-preload-1", (0, 1, 0), True),
        ("paper-four-contacts", (0, -1, 0), False),
        ("two-opposed-fingers", (0, 0, -1, 0, 0, 0), True),
    ],
)
def test_verdict_shows_the_grasp_with_its_forces(name, wrench, forces, monkeypatch):
    verdict = solve(read_grasp(name), wrench)
    picture = verdict._repr_svg_()
    assert {"wrench", "cone"} <= named(picture)
    assert ("force" in named(picture)) is forces is verdict.stable
    (image,) = ET.fromstring(verdict._repr_html_()).iter("img")
    data = image.get("src", "").removeprefix("data:image/svg+xml;base64,")
    assert base64.b64decode(data).decode() == picture
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert verdict._repr_svg_() is None
    assert verdict._repr_html_() == f"<div>{verdict_table(verdict)}</div>"


def test_verdict_on_an_assembly_shows_its_bodies():
    assert {"body", "force", "wrench"} <= named(solve(*wedge())._repr_svg_())


def test_what_has_no_picture_still_has_a_table():
    """Numbers beyond floats in space, and more contacts than a picture holds."""
    far = Grasp([Contact((0, 0, 0), (0, 0, 1), 1)])
    many = Grasp([Contact((x, 0), (0, 1), 0) for x in range(201)])
    for grasp, wrench in ((far, (0, 0, -(10**400), 0, 0, 0)), (many, (0, 1, 0))):
        verdict = solve(grasp, wrench)
        assert verdict._repr_svg_() is None
        assert "resisted" in verdict._repr_html_()


@pytest.mark.parametrize(
    ("value", "cells"),
    [
        (Units("mm", "N"), ["mm", "N"]),
        (unit_normal((3, 4)), ["(3/5, 4/5)", "0"]),
        (Circle((0, 1), "1/2"), ["(0, 1)", "1/2"]),
        (Polygon([(0, 0), (1, 0), (0, 1)]), ["((0, 0), (1, 0), (0, 1))"]),
        (
            Report("resisted", "the force of contact 1", 0),
            ["resisted", "the force of contact 1", "0", "no"],
        ),
    ],
    ids=lambda value: type(value).__name__,
)
def test_small_values_show_a_table(value, cells):
    assert [cell.text for cell in ET.fromstring(value._repr_html_()).iter("td")] == cells
    assert len(repr(value)) < 110
