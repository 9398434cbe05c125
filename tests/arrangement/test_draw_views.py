"""Flat drawings, dual, graph, lattice: what is drawn is what is counted; labels stay apart."""

from __future__ import annotations

import math
from collections import Counter
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from arrangement import Arrangement
from arrangement.cli import main
from arrangement.counts import f_vector, whitney_numbers
from arrangement.drawing.colours import PALETTE
from arrangement.drawing.output import own_settings
from arrangement.drawing.scene.labels import covering, keep_off, spread
from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.scene import Label, Path as Drawn
from arrangement.duals.inscribed import representative_hull
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import draw_counts, draw_dual, draw_gnomonic, draw_stereographic
from arrangement.pictures.diagrams.lattice import layered_orders
from arrangement.pictures.duals.graph import planar_graph
from arrangement.pictures.duals.solids import dual_solid
from arrangement.pictures.parts.essential import fits
from arrangement.pictures.sphere.projections import CompressedChart, stereographic
from arrangement.pictures.views import DRAWINGS
from tests.drawn import elements, offences, paths, scene

NAMES = [
    "coordinate-planes",
    "braid-a3",
    "reflection-b3",
    "five-generic-planes",
    "near-pencil",
    "pencil",
    "coincident-planes",
    "paper-three-contacts",
    "paper-four-contacts",
]
RANK_THREE = [name for name in NAMES if name not in ("pencil", "coincident-planes")][:-1]
VIEW = (5, 3, 4)
#: Affine planes, in other spaces, and many.
OTHERS = ["shi-a2-affine", "parallel-planes-affine", "braid-a3-in-r4", "nine-generic-planes"]


# Numbers of elements.


CASES = [
    (view, name)
    for view in [*DRAWINGS.views, "half", "whole"]
    for name in [*NAMES, *OTHERS]
    if fits({"half": "sphere", "whole": "sphere"}.get(view, view), read_arrangement(name))
    if view not in ("half", "sphere", "gnomonic", "stereographic") or name != "braid-a3-in-r4"
]


@pytest.mark.parametrize(("view", "name"), CASES)
def test_elements_drawn_are_those_counted(view: str, name: str) -> None:
    """Of a half, the limb is one more plane; in a dual, a ray is a face, half of them seen."""
    planes = read_arrangement(name)
    rays, facets, regions = (0, 0, *f_vector(planes))[-3:]
    options: dict[str, Any] = {}
    expected: dict[str, int] = {
        "planes": {"facet": facets},
        "cells": {"cell": regions},
        "lines": {"region": regions, "line": len(planes.distinct)},
        "whole": {"region": regions, "arc": facets},
        "dual": {"vertex": regions, "edge": facets, "face": rays // 2 if planes.rank > 2 else 1},
        "graph": {"vertex": regions, "edge": facets},
        "lattice": {"flat": sum(whitney_numbers(planes).second)},
    }.get(view, {})
    if not expected:
        options = {"direction": VIEW}
        *_, arcs, seen = f_vector(Arrangement([*planes.normals, VIEW]))
        expected = {"region": seen // 2, "front and limb": arcs}
    if view in ("half", "whole"):
        options["whole"] = view == "whole"
    made = scene(DRAWINGS, "stereographic" if view in ("half", "whole") else view, name, **options)
    names = [item.name for item in made.items]
    found = Counter(one.partition("-")[0] for one in (set(names) if view == "cells" else names))
    found["front and limb"] = 2 * found["front"] + found["limb"]
    assert {kind: found[kind] for kind in expected} == expected
    if view == "sphere":
        assert found["back"] == len(planes.distinct)
    if view == "lattice":
        written = " ".join(item.text for item in made.items if isinstance(item, Label))
        for number in whitney_numbers(planes).first:
            assert f"\u03a3\u03bc = {number}".replace("-", "\u2212") in written


def test_one_plane_and_none_have_pictures() -> None:
    """The dual of one plane is a segment; empty space is one region."""
    found = elements(draw_dual.scene(Arrangement([[1, 2, 2], [-1, -2, -2]])))
    assert (found["vertex"], found["edge"], found["face"]) == (2, 1, 0)
    for draw in (draw_stereographic, draw_gnomonic):
        assert elements(draw.scene(Arrangement([], dimension=3)))["region"] == 1


def test_marks_of_the_counts_are_zaslavskys_numbers_and_lie_on_the_printed_curves() -> None:
    with own_settings():
        made = draw_counts.scene(largest=8)
    items = {item.name: item for item in made.items if isinstance(item, Drawn) and item.name}
    middle = {name: np.reshape(item.points, (-1, 2)).mean(axis=0) for name, item in items.items()}
    for name in ("states", "facets", "regions"):
        for m in range(3, 9):
            place = items[f"printed-{name}"].points[m - 3]
            assert middle[f"generic-{name}-{m}"] == pytest.approx(place, abs=0.3)
    per_region = (middle["family-pencil-8"][1] - middle["family-pencil-4"][1]) / 8
    for family, rise in {"pencil": 2, "near-pencil": 4}.items():
        ups = np.diff([middle[f"family-{family}-{m}"][1] for m in range(3, 9)])
        assert ups == pytest.approx(rise * per_region)
    above = middle["family-reflection-6"][1] - middle["family-near-pencil-6"][1]
    assert above == pytest.approx(4 * per_region, abs=0.3)


# Where things are.


def test_sign_vectors_stand_in_their_regions() -> None:
    """The place of each label, taken back to the sphere, has the signs that the label says."""
    planes, direction = read_arrangement("braid-a3"), (4, 3, 4)
    figure = draw_stereographic(
        planes, direction=direction, whole=True, labels="numbers", coordinates="given"
    )
    axes, regions = figure.axes[0], planes.regions()
    limb = next(path for path in paths(figure) if path.name == "limb")
    ahead = np.array(direction) / math.sqrt(41)
    right = np.array([-3.0, 4.0, 0.0]) / 5
    frame = np.array([right, np.cross(ahead, right), ahead])
    leaders = {tuple(np.round(path.points, 2)) for path in paths(figure)
               if path.name == "leader" and path.kind == "circle"}  # fmt: skip
    checked = 0
    for text in axes.texts:
        u = (np.array(text.get_position()) - limb.points) / limb.radius
        if text.get_style() == "italic" or not text.get_text().isdigit():
            continue
        place = np.array([2 * u[0], 2 * u[1], 1 - u @ u]) @ frame
        heights = np.array(planes.normals, dtype=float) @ place
        signs = regions[int(text.get_text()) - 1].signs
        checked += all(h * s > 0 for h, s in zip(heights, signs, strict=True))
    assert checked >= len(regions) - 1 - len(leaders) > 12


@settings(max_examples=40, deadline=None)
@given(
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
    st.floats(0.05, 3.1),
)
def test_stereographic_arcs_are_arcs_of_the_true_circles(
    normal: tuple[int, ...], other: tuple[int, ...], angle: float
) -> None:
    """Every joint is the image of a point of the great circle, and lies on the image circle."""
    n = np.array(normal) / np.linalg.norm(normal)
    start = np.cross(n, other)
    assume(np.linalg.norm(start) > 1e-9 and abs(n[2]) > 0.05)
    start /= np.linalg.norm(start)
    curve = stereographic(n, start, angle)
    end = math.cos(angle) * start + math.sin(angle) * np.cross(n, start)
    for joint, point in ((curve[0], start), (curve[-1], end)):
        assert np.allclose(joint * (1 + point[2]), point[:2], atol=1e-7)
    t = np.linspace(0, 1, 9)[:, None, None]
    p, q, r, s = (curve[k : len(curve) - 1 + (k == 3) or None : 3] for k in range(4))
    flat = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * s
    radius = np.linalg.norm(flat.reshape(-1, 2) - n[:2] / n[2], axis=1)
    assert np.allclose(radius * abs(n[2]), 1, atol=1e-5)


def test_chart_is_to_scale_inside_and_takes_infinity_to_the_rim() -> None:
    chart = CompressedChart(2.0)
    near = chart.project(np.array([[0.3, 0.4, 0.5]]))[0]
    assert np.allclose(near, np.array([0.6, 0.8]) * chart.inner / 2)
    far = chart.project(np.array([[0.6, 0.8, 0.0], [0.6, 0.8, 1e-9]]))
    assert np.allclose(far, [[0.6, 0.8]] * 2)
    seam = chart.project(np.array([[2.0, 0.0, 1 + 1e-9], [2.0, 0.0, 1 - 1e-9]]))
    assert np.allclose(seam, [[chart.inner, 0.0]] * 2)


def test_a_plane_at_infinity_is_named() -> None:
    planes = read_arrangement("coordinate-planes")
    texts = [text.get_text() for text in draw_gnomonic(planes, direction=(0, 0, 1)).axes[0].texts]
    assert any("line at infinity, plane 3;" in text for text in texts)
    texts = [text.get_text() for text in draw_gnomonic(planes, direction=(1, 1, 1)).axes[0].texts]
    assert not any("line at infinity, plane" in text for text in texts)


def test_gnomonic_lines_are_straight_between_two_ends_named_alike() -> None:
    figure = draw_gnomonic(read_arrangement("five-generic-planes"))
    for path in paths(figure):
        if path.name.startswith("front"):
            a, *_, d = path.points
            for b in path.points[1:-1]:
                assert abs(np.linalg.det([d - a, b - a])) < 1e-6
    names = [text.get_text() for text in figure.axes[0].texts if text.get_style() == "italic"]
    assert all(names.count(str(k)) == 2 for k in range(1, 6))


@pytest.mark.parametrize("name", RANK_THREE)
def test_each_zone_has_two_edges_on_the_outline_and_hides_half_of_the_others(name: str) -> None:
    """A circle meets the limb in two points, if no vertex lies on it."""
    planes = read_arrangement(name)
    solid = dual_solid(planes, (101, 37, 53), np.eye(3))
    _, _, facets, regions = f_vector(planes)
    circles = len(planes.distinct)
    assert sum(solid.edge_hidden) == (facets - 2 * circles) // 2
    assert sum(solid.vertex_hidden) == (regions - 2 * circles) // 2


def test_hull_legend_counts_the_edges_that_differ() -> None:
    planes = read_arrangement("five-generic-planes")
    found = representative_hull(dual_polyhedron(planes))
    texts = [text.get_text() for text in draw_dual(planes, hull=True).axes[0].texts]
    shared = found.hull.true_edges & found.adjacencies
    only = found.hull.true_edges - found.adjacencies
    assert found.missing
    assert f"hull and adjacency: {len(shared)}" in texts
    assert f"hull only: {len(only)}" in texts
    assert f"adjacency only: {len(found.adjacencies - found.hull.true_edges)}" in texts


def test_evening_out_makes_room_for_labels() -> None:
    """The narrow regions of the moment curve hold hardly any."""
    plain, even = (
        scene(DRAWINGS, "stereographic", "nine-generic-planes", whole=False, coordinates=x)
        for x in ("given", "even")
    )
    labels = [sum(isinstance(i, Label) for i in made.items) for made in (plain, even)]
    assert labels[1] > labels[0] + 5
    assert offences(laid_out(even)) == []


# The planar drawing.


@pytest.mark.parametrize("name", RANK_THREE)
def test_faces_of_a_planar_drawing_are_convex_and_fill_the_outer_one(name: str) -> None:
    """Then no edges cross: regions of one orientation that fill a region once do not overlap."""
    dual = dual_polyhedron(read_arrangement(name))
    graph = planar_graph(dual.arrangement)
    places = [tuple(map(Fraction, place)) for place in graph.places.tolist()]
    outer, inner, total = [], [], Fraction(0)
    for cycle in dual.faces:
        corners = [places[k] for k in cycle]
        turns, twice = set(), Fraction(0)
        for (ax, ay), (bx, by), (cx, cy) in zip(
            corners, corners[1:] + corners[:1], corners[2:] + corners[:2], strict=True
        ):
            turns.add((bx - ax) * (cy - by) > (by - ay) * (cx - bx))
            twice += ax * by - ay * bx
        assert len(turns) == 1
        (outer if set(cycle) == set(graph.outer) else inner).append(turns.pop())
        total += twice
    assert len(outer) == 1
    assert set(inner) == {not outer[0]}
    assert total == 0
    assert len(graph.edges) == len(dual.edges)


# Labels.


@pytest.mark.parametrize("options", [{}, {"width": 88.0}, {"largest": 30}, {"largest": 4}])
def test_labels_of_the_counts_do_not_collide(options: dict[str, Any]) -> None:
    with own_settings():
        assert offences(laid_out(draw_counts.scene(**options))) == []


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(0, 6.28), min_size=1, max_size=12))
def test_spread_angles_keep_their_cyclic_order_and_distance(angles: list[float]) -> None:
    placed = spread(angles, 0.2)
    order = sorted(range(len(angles)), key=lambda k: angles[k])
    gaps = [placed[b] - placed[a] for a, b in pairwise(order)]
    assert all(gap > 0.19 for gap in gaps)
    assert placed[order[-1]] - placed[order[0]] < 2 * math.pi


def test_segments_that_meet_a_box() -> None:
    lines = np.array([[[0, 0], [10, 10]], [[0, 10], [4, 10]], [[5, -9], [5, 20]], [[0, 4], [3, 0]]])
    boxes = np.array([[4, 4, 6, 6], [7, 0, 9, 4]], dtype=float)
    met = [covering(keep_off([line]), boxes).tolist() for line in lines.astype(float)]
    assert met == [[True, False], [False, False], [True, False], [False, False]]
    disc = keep_off([], discs=np.array([[8.0, 8.0]]), radius=2.0)
    assert covering(disc, boxes).tolist() == [True, False]


def test_layers_are_ordered_without_crossings_where_that_is_possible() -> None:
    covers = [[[3], [2], [1], [0]], [[], [], [], []]]
    for fixed in (0, 1):
        low, high = layered_orders([4, 4], covers, fixed)
        assert [covers[0][node][0] for node in low] == high
    assert low == [0, 1, 2, 3]


def test_the_palette_gets_darker_so_that_it_is_readable_in_grey() -> None:
    greys = [
        sum(w * int(c[i : i + 2], 16) for w, i in ((0.2126, 1), (0.7152, 3), (0.0722, 5)))
        for c in PALETTE
    ]
    assert all(a - b > 8 for a, b in pairwise(greys))


# Files and bad input.


def test_extra_options_reach_their_views(tmp_path: Path) -> None:
    target = str(tmp_path / "a.svg")
    assert main(["draw", "braid-a3", "-o", target, "--view", "stereographic", "--no-whole"]) == 0
    assert "limb-" in Path(target).read_text()
    assert main(["draw", "braid-a3", "-o", target, "--view", "dual", "--hull"]) == 0
    assert main(["draw", "braid-a3", "-o", target, "--view", "lattice", "--no-moebius"]) == 0
    assert (
        main(["draw", "braid-a3", "-o", target, "--view", "gnomonic", "--coordinates", "even"]) == 0
    )
    assert main(["draw", "braid-a3", "-o", target, "--view", "lattice", "--hull"]) == 2
    assert main(["draw", "braid-a3", "-o", target, "--coordinates", "cartesian"]) == 2
