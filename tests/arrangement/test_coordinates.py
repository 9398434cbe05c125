"""Coordinates of pictures: what a linear map shows, and that it changes no sign vector."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

from arrangement import Arrangement, read_arrangement
from arrangement.console.progress import shown
from arrangement.library.families import (
    catalan,
    coxeter,
    linial,
    near_pencil,
    shi,
    simplicial,
    type_b,
)
from arrangement.pictures.coordinates import CHOICES, even_map, in_coordinates, symmetry
from arrangement.pictures.graph import planar_graph

from .strategies import arrangements

CENTRAL = arrangements(dimensions=(3, 3), planes=(1, 6), central=True)
SKEW = np.array([[3, 1, -1], [0, 2, 1], [1, 0, 5]])


def unit_normals(planes: Arrangement) -> Any:
    rows = np.array(planes.normals, float)
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def cosines(planes: Arrangement) -> list[float]:
    units = unit_normals(planes)
    pairs = np.triu_indices(len(units), 1)
    return sorted(np.round(np.abs(units @ units.T)[pairs], 3) + 0.0)


def skewed(planes: Arrangement) -> Arrangement:
    """Return the same arrangement in other coordinates."""
    return Arrangement((np.array(planes.normals) @ SKEW).tolist())


@given(CENTRAL, st.sampled_from(CHOICES), st.tuples(*[st.integers(-4, 4)] * 3))
def test_no_choice_changes_a_sign_vector(planes, choice, point):
    moved, seen, _ = in_coordinates(choice, planes, point)
    assert {face.signs for face in planes.faces()} == {face.signs for face in moved.faces()}
    assert seen is not None
    assert moved.signs_at(seen) == planes.signs_at(point)


@pytest.mark.parametrize(
    ("planes", "order", "angles"),
    [
        (read_arrangement("braid-a3"), 24, {0.0: 3, 0.5: 12}),
        (read_arrangement("four-generic-planes"), 24, {0.333: 6}),
        (read_arrangement("three-generic-planes"), 24, {0.0: 3}),
        (skewed(type_b(3)), 24, {0.0: 12, 0.5: 12, 0.707: 12}),
        (skewed(read_arrangement("cube-diagonals")), 24, {0.333: 6}),
        (skewed(near_pencil(4)), 12, {0.0: 3, 0.5: 3}),
        (skewed(simplicial(7, 1)), 24, None),
    ],
)
def test_symmetric_arrangements_get_the_angles_of_their_group(planes, order, angles):
    """24: the rotations of the cube, one of each pair A, -A; 12: those of a hexagon with mirrors.

    A map g of the group permutes the lines, so the angles of any coordinates of the same planes
    come out the same.
    """
    found = symmetry(planes)
    assert found is not None
    assert len(found.group) == order
    moved, *_ = in_coordinates("symmetric", planes)
    again, *_ = in_coordinates("symmetric", skewed(planes))
    assert cosines(moved) == pytest.approx(cosines(again), abs=0.003)
    if angles is not None:
        wanted = sorted(x for x, number in angles.items() for _ in range(number))
        assert cosines(moved) == pytest.approx(wanted, abs=0.003)


def test_what_is_symmetric_or_has_no_symmetry_stays_as_it_is():
    for name in ("cube-diagonals", "reflection-b3", "near-pencil"):
        planes = read_arrangement(name)
        assert in_coordinates(None, planes)[:2] == (planes, None)
    assert symmetry(Arrangement([[1, t, t**3] for t in (0, 1, 3, 7, 12, 20)])) is None
    affine = Arrangement([[1, 0, 0], [1, 1, 0], [1, 1, 1]], [0, 0, 1])
    assert in_coordinates("symmetric", affine)[0] is affine


def test_planes_of_motions_keep_their_coordinates_unless_asked():
    planes = read_arrangement("paper-three-contacts")
    assert planes.axes == ("x", "y", "r")
    assert in_coordinates(None, planes)[0] is planes
    assert in_coordinates("symmetric", planes)[0] != planes
    assert in_coordinates(None, Arrangement(planes.normals))[0] != planes


def test_too_many_planes_are_drawn_as_given_and_that_is_said(capsys):
    planes = Arrangement([[1, t, t * t] for t in range(61)])
    with shown():
        assert in_coordinates("symmetric", planes)[0] is planes
    assert "no symmetry is looked for beyond 60 planes" in capsys.readouterr().err


def test_the_graph_of_a3_has_a_hexagon_outside_and_its_mirrors():
    """The places are kept by a turn of 60 degrees combined with exchanging alternate vertices."""
    graph = planar_graph(read_arrangement("braid-a3"))
    assert len(graph.outer) == 6
    turn = np.exp(2j * np.pi / 3)
    places = graph.places @ np.array([1, 1j])
    gaps = np.abs((turn * places)[:, None] - places[None]).min(axis=1)
    assert gaps.max() < 1e-6


def spread(rows: Any) -> float:
    """Return the least mean square of unit normals in any direction; 1/3 at most."""
    units = rows / np.linalg.norm(rows, axis=1, keepdims=True)
    return float(np.linalg.eigvalsh(units.T @ units / len(units))[0])


@pytest.mark.parametrize("name", ["braid-a3", "nine-generic-planes", "coordinate-planes"])
def test_the_even_map_spreads_the_normals(name):
    rows = unit_normals(read_arrangement(name))
    even = even_map(rows)
    assert np.linalg.det(even) == pytest.approx(1)
    assert spread(rows @ even.T) > 0.3
    assert spread(rows @ even.T) >= spread(rows) - 1e-12


@pytest.mark.parametrize("make", [coxeter, shi, catalan, linial])
@pytest.mark.parametrize(
    ("type", "step"), [("A2", 60), ("B2", 45), ("C2", 45), ("G2", 30), ("A3", 0), ("B3", 0)]
)
def test_planes_of_roots_have_the_angles_of_the_roots(make, type, step):
    given = make(type)
    moved, *_ = in_coordinates(None, given)
    assert moved.f_vector == given.f_vector
    assert in_coordinates("given", given)[0] == given
    units = np.array([[float(x) for x in plane[:-1]] for plane in moved.integer_planes])
    units /= np.linalg.norm(units, axis=1)[:, None]
    angles = np.degrees(np.arccos(np.clip(units @ units.T, -1, 1)))
    known = np.arange(0, 181, step) if step else np.array([0, 45, 60, 90, 120, 135, 180])
    if make is not coxeter or step:
        assert np.abs(angles[..., None] - known).min(axis=-1).max() < 0.1


@pytest.mark.parametrize("offsets", [(0, 0, 1), (1, 2, 1)])
def test_lines_with_other_offsets_keep_their_coordinates(offsets):
    lines = Arrangement([[1, 0], [0, 1], [1, 1]], offsets)
    assert in_coordinates(None, lines)[0] == lines
