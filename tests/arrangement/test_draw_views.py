"""Flat drawings, dual, graph, lattice: what is drawn is what is counted; labels stay apart."""

import math
import re
import sys
from collections import Counter
from fractions import Fraction
from itertools import combinations, groupby, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from matplotlib.image import imread

import arrangement
from arrangement import Arrangement, InputError, read_arrangement
from arrangement.console import progress
from arrangement.counts import bounded_region_count, f_vector, whitney_numbers
from arrangement.drawing.colours import CHECKERS, PALETTE, DrawnRegion, colouring, plane_colour
from arrangement.drawing.labels import HAIR, spread_angles
from arrangement.drawing.layout import lay_out
from arrangement.drawing.output import own_settings, picture_bytes
from arrangement.drawing.path_artist import figure
from arrangement.drawing.scene import Label, Path as Drawn, Scene, area, curve_points
from arrangement.duals.inscribed.hull import representative_hull
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.library.families import coxeter, random_integer, simplicial
from arrangement.numbers.exact import sign_text
from arrangement.pictures import (
    charts,
    draw_counts,
    draw_dual,
    draw_gnomonic,
    draw_lines,
    draw_sphere,
    draw_stereographic,
    save_figure,
    write_drawing,
)
from arrangement.pictures.charts import compress
from arrangement.pictures.coordinates import orbits
from arrangement.pictures.dual import dual_solid
from arrangement.pictures.globe import Globe, stereographic
from arrangement.pictures.graph import planar_graph
from arrangement.pictures.lattice import layered_orders
from arrangement.pictures.lines import LinesChart
from arrangement.pictures.views import DRAWINGS
from tests.drawn import elements, offences, paths, scene

from .strategies import arrangements

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

PACKAGE = Path(arrangement.__file__).parent


# Numbers of elements.


CASES = [
    (view, name)
    for view in [*DRAWINGS.views, "half", "whole"]
    for name in [*NAMES, *OTHERS]
    # As nine planes, as the coordinates, as the braid arrangement.
    if name not in ("five-generic-planes", "paper-three-contacts", "reflection-b3", "near-pencil")
    if DRAWINGS.views["sphere" if view in ("half", "whole") else view].shows(read_arrangement(name))
    if view not in ("half", "sphere", "gnomonic", "stereographic") or name != "braid-a3-in-r4"
]


@pytest.mark.parametrize(("view", "name"), CASES)
def test_elements_drawn_are_those_counted(view, name):
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
        "poset": {"vertex": regions, "edge": facets},
        "lattice": {"flat": sum(whitney_numbers(planes).second)},
    }.get(view, {})
    if not expected:
        options = {"camera": VIEW}
        *_, arcs, seen = f_vector(Arrangement([*planes.normals, VIEW]))
        expected = {"region": seen // 2, "front and limb": arcs}
    if view in ("half", "whole"):
        options["whole"] = view == "whole"
    made = scene(DRAWINGS, "stereographic" if view in ("half", "whole") else view, name, **options)
    names = [item.name for item in made.items]
    found = Counter(one.partition("-")[0] for one in (set(names) if view == "cells" else names))
    found["front and limb"] = 2 * found["front"] + found["limb"]
    if view == "gnomonic":  # which leaves out what is far away
        del expected["front and limb"]
        [left_out] = re.findall(r"(\d+) region", str(made.legend.captions)) or [0]
        found["region"] += int(left_out)
    assert {kind: found[kind] for kind in expected} == expected
    if view == "sphere":
        assert found["back"] == len(planes.distinct)
    if view == "lattice":
        written = " ".join(item.text for item in made.items if isinstance(item, Label))
        for number in whitney_numbers(planes).first:
            assert f"\u03a3\u03bc = {number}".replace("-", "\u2212") in written


def test_one_plane_and_none_have_pictures():
    """The dual of one plane is a segment; empty space is one region."""
    found = elements(draw_dual.scene(Arrangement([[1, 2, 2], [-1, -2, -2]])))
    assert (found["vertex"], found["edge"], found["face"]) == (2, 1, 0)
    for draw in (draw_stereographic, draw_gnomonic):
        assert elements(draw.scene(Arrangement([], dimension=3)))["region"] == 1


def test_count_marks_lie_on_the_printed_curves():
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


@pytest.mark.parametrize("name", ["braid-a3", "four-generic-planes", "reflection-b3"])
def test_both_halves_are_in_their_frame_and_the_outer_region_is_beneath(name):
    planes, direction = read_arrangement(name), (4, 3, 5)
    made = draw_stereographic.scene(planes, camera=direction, whole=True, coordinates="given")
    frame = next(item.points for item in made.items if item.role == "border")
    curves = [x.points for x in made.items if x.name.startswith("arc-")]
    drawn = np.concatenate(list(map(curve_points, curves)))
    assert (drawn.min(axis=0) > frame.min(axis=0)).all()
    assert (drawn.max(axis=0) < frame.max(axis=0)).all()
    assert np.ptp(drawn, axis=0).max() > 0.6 * np.ptp(frame)
    regions = [x for x in made.items if x.name.startswith("region-")]
    outside = made.numbers[sign_text(planes.signs_at([-x for x in direction]))]
    assert regions[0].name == f"region-{outside}"
    assert np.array_equal(regions[0].points, frame)


@pytest.mark.parametrize("far", [10**9, 10**12, 10**15])
@pytest.mark.parametrize(
    ("draw", "options"),
    [
        (draw_sphere, {}),
        (draw_stereographic, {}),
        (draw_stereographic, {"whole": True}),
        (draw_stereographic, {"whole": False}),
    ],
)
def test_a_circle_nearly_on_the_limb_is_named_where_it_meets_it(draw, options, far, tmp_path):
    """Both circles meet the limb at the right and at the left; one is 1 / far from it."""
    planes = Arrangement([[0, 0, 1], [1, 0, 0]])
    options = {"camera": (1, 0, far), "coordinates": "given", "labels": "none", **options}
    made = draw.scene(planes, **options)
    save_figure(tmp_path / "o.svg", lambda: figure(made))
    assert (tmp_path / "o.svg").stat().st_size
    places = {item.text: item.place for item in made.items if isinstance(item, Label)}
    assert places.keys() == {"1", "2"}
    drawn = [item.name for item in made.items]
    whole = options.get("whole", False)
    for k in "12":
        kind = "arc" if whole else "front"
        assert any(name.startswith(f"{kind}-{k}-") for name in drawn)
        assert whole or places[k][1] == pytest.approx(made.height - made.width / 2, abs=2)


def test_sign_vectors_stand_in_their_regions():
    """The place of each label, taken back to the sphere, has the signs that the label says."""
    planes, direction = read_arrangement("braid-a3"), (4, 3, 4)
    figure = draw_stereographic(
        planes, camera=direction, whole=True, labels="numbers", coordinates="given"
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


@given(
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
    st.tuples(*[st.integers(-5, 5)] * 3).filter(any),
    st.floats(0.05, 3.1),
)
def test_stereographic_arcs_are_arcs_of_the_true_circles(normal, other, angle):
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


def test_evenness_is_measured_to_scale_inside_and_up_to_infinity():
    near = compress(np.array([[0.3, 0.4, 0.5]]), 2.0, 0.7)[0]
    assert np.allclose(near, np.array([0.6, 0.8]) * 0.7 / 2)
    far = compress(np.array([[0.6, 0.8, 0.0], [0.6, 0.8, 1e-9]]), 2.0)
    assert np.allclose(far, [[0.6, 0.8]] * 2)
    seam = compress(np.array([[2.0, 0.0, 1 + 1e-9], [2.0, 0.0, 1 - 1e-9]]), 2.0)
    assert np.allclose(seam, [[0.7, 0.0]] * 2)


def test_a_plane_at_infinity_is_named():
    planes = read_arrangement("coordinate-planes")
    for ahead, named in (((0, 0, 1), True), ((1, 1, 1), False)):
        made = draw_gnomonic.scene(planes, camera=ahead)
        assert any("farther out: line 3" in text for text in made.legend.captions) == named


def test_gnomonic_lines_straight_with_named_ends():
    figure = draw_gnomonic(read_arrangement("five-generic-planes"))
    for path in paths(figure):
        if path.name.startswith("front"):
            a, *_, d = path.points
            for b in path.points[1:-1]:
                assert abs(np.linalg.det([d - a, b - a])) < 1e-6
    names = [text.get_text() for text in figure.axes[0].texts if text.get_style() == "italic"]
    assert all(names.count(str(k)) == 2 for k in range(1, 6))


@pytest.mark.parametrize("name", RANK_THREE)
def test_each_zone_has_two_edges_on_the_outline(name):
    """A circle meets the limb in two points, if no vertex lies on it."""
    planes = read_arrangement(name)
    solid = dual_solid(planes, (101, 37, 53), np.eye(3))
    _, _, facets, regions = f_vector(planes)
    circles = len(planes.distinct)
    assert sum(solid.edge_hidden) == (facets - 2 * circles) // 2
    assert sum(solid.vertex_hidden) == (regions - 2 * circles) // 2


def test_hull_legend_counts_the_edges_that_differ():
    planes = read_arrangement("five-generic-planes")
    found = representative_hull(dual_polyhedron(planes))
    texts = [text.get_text() for text in draw_dual(planes, hull=True).axes[0].texts]
    shared = found.hull.true_edges & found.adjacencies
    only = found.hull.true_edges - found.adjacencies
    assert found.missing
    assert f"hull and adjacency: {len(shared)}" in texts
    assert f"hull only: {len(only)}" in texts
    assert f"adjacency only: {len(found.adjacencies - found.hull.true_edges)}" in texts


def test_evening_out_makes_room_for_labels():
    """The narrow regions of the moment curve hold hardly any."""
    plain, even = (
        scene(DRAWINGS, "stereographic", "nine-generic-planes", whole=False, coordinates=x)
        for x in ("given", "even")
    )
    labels = [sum(isinstance(i, Label) for i in made.items) for made in (plain, even)]
    assert labels[1] > labels[0] + 5
    assert offences(lay_out(even)) == []


# The planar drawing.


@pytest.mark.parametrize("name", RANK_THREE)
def test_planar_drawing_has_convex_faces(name):
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
def test_labels_of_the_counts_do_not_collide(options):
    with own_settings():
        assert offences(lay_out(draw_counts.scene(**options))) == []


@given(st.lists(st.floats(0, 6.28), min_size=1, max_size=12))
def test_spread_angles_keep_their_cyclic_order_and_distance(angles):
    placed = spread_angles(angles, 0.2)
    order = sorted(range(len(angles)), key=lambda k: angles[k])
    gaps = [placed[b] - placed[a] for a, b in pairwise(order)]
    assert all(gap > 0.19 for gap in gaps)
    assert placed[order[-1]] - placed[order[0]] < 2 * math.pi


def test_layers_ordered_without_crossings():
    covers = [[[3], [2], [1], [0]], [[], [], [], []]]
    for fixed in (0, 1):
        low, high = layered_orders([4, 4], covers, fixed)
        assert [covers[0][node][0] for node in low] == high
    assert low == [0, 1, 2, 3]


def test_the_palette_gets_darker_so_that_it_is_readable_in_grey():
    greys = [
        sum(w * int(c[i : i + 2], 16) for w, i in ((0.2126, 1), (0.7152, 3), (0.0722, 5)))
        for c in PALETTE
    ]
    assert all(a - b > 8 for a, b in pairwise(greys))


def test_thirty_six_planes_have_colours_that_differ():
    colours = [plane_colour(label) for label in range(36)]
    channels = [np.array([int(c[k : k + 2], 16) for k in (1, 3, 5)]) for c in colours]
    assert min(np.linalg.norm(a - b) for a, b in combinations(channels, 2)) > 20
    assert plane_colour(36) == colours[0]


# Files and bad input.


FEW = ["four-generic-planes", "braid-a3", "reflection-b3", "pencil", "coincident-planes"]


def test_colouring_by_a_function_of_the_region():
    planes = read_arrangement("coordinate-planes")
    figure = draw_sphere(planes, colour=lambda region: "red" if region.signs[0] > 0 else "blue")
    fills = {x.style["fc"] for x in paths(figure) if x.role == "region"}
    assert fills == {"red", "blue"}


@pytest.mark.parametrize("name", [*FEW, "coordinate-planes", "nine-generic-planes"])
def test_neighbours_differ_by_parity(name):
    planes = read_arrangement(name)
    regions = [DrawnRegion(face.signs, 0) for face in planes.regions()]
    pairs = neighbours(planes)
    found = colouring("parity", regions, pairs, planes.firsts)
    fills = {region.signs: found.paint(region) for region in regions}
    assert pairs
    assert all(fills[regions[a].signs] != fills[regions[b].signs] for a, b in pairs)
    alike = {fills[signs] == fills[tuple(-s for s in signs)] for signs in fills}
    assert alike == {len(planes.distinct) % 2 == 0}
    assert len(set(fills.values())) == 2
    for signs, fill in fills.items():
        assert fill == CHECKERS[sum(signs[k] < 0 for k in planes.firsts) % 2]


def neighbours(planes: Arrangement) -> list[tuple[int, int]]:
    """Return the pairs of regions that differ on one class of planes, from sign vectors alone."""
    signs = [face.signs for face in planes.regions()]
    first = [members[0] for members in planes.distinct]
    return [
        (a, b)
        for a, b in combinations(range(len(signs)), 2)
        if sum(signs[a][k] != signs[b][k] for k in first) == 1
    ]


def test_sides_colour_only_where_they_tell_neighbours_apart():
    def legend(name):
        return {text.get_text() for text in draw_sphere(read_arrangement(name)).axes[0].texts}

    assert {"3 sides", "4 sides"} <= legend("cube-diagonals")
    assert "odd number of minus signs" in legend("five-generic-planes")


@pytest.mark.parametrize("name", ["braid-a3", "pencil", "four-generic-planes"])
def test_region_numbers_explained_by_the_table(name):
    planes = read_arrangement(name)
    texts = [t.get_text() for t in draw_sphere(planes, labels="numbers").axes[0].texts]
    rows = [re.fullmatch(r"[\s\u2007]*(\d+) ([+\u2212\u200a]+)", text) for text in texts]
    table = {int(row[1]): row[2].replace("\u200a", "") for row in rows if row}
    regions = planes.regions()
    for number, signs in table.items():
        assert signs == "".join("+" if s > 0 else "\u2212" for s in regions[number - 1].signs)
    written = {int(text) for text in texts if text.isdigit() and int(text) > len(planes)}
    assert written <= set(table)
    assert len(table) > len(regions) / 2


@pytest.mark.parametrize(
    ("name", "labels", "rows"),
    [("braid-a3", "numbers", 24), ("reflection-b3", None, 0), ("reflection-b3", "numbers", 48)],
)
def test_a_long_table_stands_below_where_it_is_asked_for(name, labels, rows):
    assert len(scene(DRAWINGS, "dual", name, labels=labels).legend.table) == rows


def test_labels_can_be_left_out_and_bad_ones_are_refused():
    planes = read_arrangement("braid-a3")
    texts = [t.get_text() for t in draw_sphere(planes, labels="none", colour="none").axes[0].texts]
    assert sorted(texts) == ["1", "2", "3", "4", "5", "6"]


def test_motions_have_axes_and_other_spaces_when_asked():
    def named(name, **options):
        figure = draw_sphere(read_arrangement(name), **options)
        return {t.get_text() for t in figure.axes[0].texts} & {"x", "y", "z", "r"}

    assert named("paper-three-contacts") == {"x", "y", "r"}
    assert named("paper-three-contacts", axes="none") == set()
    assert named("braid-a3") == set()
    assert named("braid-a3", axes="x,y,z") == {"x", "y", "z"}


@pytest.mark.parametrize("name", ["braid-a3", "four-generic-planes", "coincident-planes"])
def test_arrows_point_to_the_positive_side_of_each_plane(name):
    """Both ends of an arrow, taken back to the sphere; a leader line is not an arrow."""
    planes = read_arrangement(name)
    scene = draw_sphere.scene(planes, camera=VIEW, sides=True, coordinates="given")
    ball = next(item for item in scene.items if item.role == "ball")
    ahead = np.array(VIEW) / np.linalg.norm(VIEW)
    right = np.array([-VIEW[1], VIEW[0], 0.0]) / np.hypot(*VIEW[:2])
    frame = np.array([right, np.cross(ahead, right), ahead])
    heads = [i for i in scene.items if i.name.startswith("side") and i.kind == "polygon"]
    assert len(heads) == len(planes.distinct)
    for head in heads:
        u = (head.points[3] - np.array(ball.centre)) / ball.radius
        tip = np.array([*u, np.sqrt(1 - u @ u)]) @ frame
        plane = int(head.name.split("-")[1]) - 1
        assert plane in planes.firsts
        assert np.array(planes.normals[plane], dtype=float) @ tip > 0


def test_a_ball_is_lit_at_its_focus_and_darkest_at_the_rim(tmp_path):
    scene = Scene(40, 40)
    centre, radius = scene.width / 2, 50.0
    scene.ball((centre, centre), radius, "#ffffff", "#404040")
    save_figure(tmp_path / "a.png", lambda: figure(scene))
    shades = imread(tmp_path / "a.png")[..., 0]
    row, column = np.unravel_index(np.argmin(shades), shades.shape)
    pixels = len(shades) / scene.height
    out = math.hypot(column / pixels - centre, scene.height - row / pixels - centre)
    assert abs(out - radius) < 1
    left, up = (centre - x * radius for x in (0.35, 0.4))
    at = int(up * pixels), int(left * pixels)
    assert shades[at] > 0.99


@pytest.mark.parametrize("view", ["sphere", "dual", "lattice"])
def test_width_and_size_of_letters_hold(view, tmp_path):
    """With letters twice as large the lines are twice as wide, on the same width of paper."""
    planes, found = read_arrangement("coordinate-planes"), []
    for size, width in (("7pt", "200mm"), (14, "20cm")):
        write_drawing(planes, tmp_path / "a.svg", view, width=width, font_size=size, text="text")
        text = (tmp_path / "a.svg").read_text(encoding="utf-8")
        paper = float(re.search(r'width="([\d.]+)pt"', text)[1])
        assert abs(paper - 200 * 72 / 25.4) < 0.01
        letters = {float(x) for x in re.findall(r"font(?:-size)?: ?[^;]*?([\d.]+)px", text)}
        lines = {float(x) for x in re.findall(r"stroke-width: ([\d.]+)", text)}
        found.append((max(letters), max(lines)))
    assert found[1] == pytest.approx([2 * x for x in found[0]])


def test_letters_of_an_svg_can_be_kept_as_text(tmp_path):
    """Those with a halo too."""
    scene = Scene(40, 20)
    scene.text((40, 30), "halo", halo=(2, "white"))
    scene.text((40, 10), "plain")
    content = picture_bytes(".svg", lambda: figure(scene), letters=True).decode()
    assert re.findall(r"<text[^>]*>(\w+)</text>", content) == ["halo", "plain"]
    assert "<text" not in picture_bytes(".svg", lambda: figure(scene)).decode()


LESSON = Arrangement([[0, 1], [-4, -3], [4, -3]], [0, -12, -12])
LINES = {
    "generic": read_arrangement("generic-lines-affine"),
    "shi": read_arrangement("shi-a2-affine"),
    "lesson": LESSON,
    "none": Arrangement([], dimension=2),
    "one": Arrangement([[1, 2]], [3]),
    "coincident": Arrangement([[1, 2], [2, 4], [-1, -2], [1, 0]], [3, 6, -3, 0]),
    "parallel": Arrangement([[1, 2]] * 4, [0, 1, 5, 6]),
    "two parallel": Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0]),
    "central": Arrangement([[1, 0], [0, 1], [1, 1], [1, -1], [2, 1]]),
    "one point": Arrangement([[1, 0], [0, 1], [1, 1]], [1, 1, 2]),
    "nearly parallel": Arrangement([[1, 0], [0, 1], [1, 1], [1000, 1001]], [0, 0, 1, 7]),
    "huge": Arrangement([[1, 0], [0, 1], [10**30, 1]], [0, 10**40, 1]),
}


def scene_of(planes: Arrangement, **options: Any) -> Scene:
    found: Scene = lay_out(draw_lines.scene(planes, **options))
    return found


def written(scene: Scene) -> list[str]:
    return [item.text.replace(HAIR, "") for item in scene.items if isinstance(item, Label)]


@pytest.mark.parametrize("name", LINES)
@pytest.mark.parametrize("projective", [False, True])
def test_regions_and_lines_are_those_that_are_counted(name, projective):
    planes = LINES[name]
    found = elements(scene_of(planes, projective=projective, faces="all", sides=True))
    vertices, edges, regions = f_vector(planes)
    assert (found["region"], found["vertex"]) == (regions, vertices)
    assert found["front"] + found["line"] == (edges if projective else len(planes.distinct))


def bounded(planes: Arrangement) -> int:
    """Count the bounded regions by Zaslavsky's second theorem; below rank 2 all are unbounded."""
    return bounded_region_count(planes) if planes.rank == 2 else 0


@given(arrangements(dimensions=(2, 2), planes=(0, 6)))
def test_regions_fill_the_window_with_right_signs(planes):
    chart = LinesChart(planes)
    assert len(chart.bounded) == bounded(planes)
    assert (len(chart.vertices), len(chart.edges), len(chart.regions)) == f_vector(planes)
    cone = chart.globe.whole.arrangement
    total = 0.0
    for region, signs in chart.regions.items():
        outline = chart.outline(region)
        if not len(outline):
            continue  # beyond a window that leaves out far crossings
        total += area(outline)
        middle = [Fraction(float(x)) for x in outline.mean(axis=0)]
        assert cone.signs_at([*middle, 1]) == signs
    width, height = chart.half
    assert total == pytest.approx(float(4 * width * height))
    for vertex in () if chart.left_out else chart.vertices:
        assert (np.abs(chart.vertex(vertex)) < [float(x) for x in chart.half]).all()


def nearly_parallel() -> Arrangement:
    """Return the sides of a decagon, lines that are nearly parallel to them, and one more."""
    turns = [k * math.pi / 5 for k in range(10)]
    rows = [[round(r * math.cos(t)), round(r * math.sin(t))] for r in (99, 995) for t in turns]
    return Arrangement([*rows, [3, 1]], [100] * 10 + [800] * 10 + [1])


def test_far_crossings_are_left_out_where_most_regions_would_vanish(capsys):
    lines = nearly_parallel()
    with progress.shown():
        drawn = scene_of(lines)
    said = capsys.readouterr().err
    assert re.search(r"the window leaves out \d+ of \d+ crossings, .*--window .*\n", said)
    chart = LinesChart(lines)
    outlines = [chart.outline(r) for r, signs in chart.regions.items() if signs in chart.bounded]
    sizes = [np.ptp(outline, axis=0).max() for outline in outlines if len(outline)]
    seen = sum(size >= float(max(chart.half)) / 40 for size in sizes)
    assert 2 * seen >= len(chart.bounded)
    widths = {item.style["lw"] for item in drawn.items if item.name.startswith("line-")}
    few = {item.style["lw"] for item in scene_of(LESSON).items if item.name == "line-1"}
    assert max(widths) < min(few)


def test_all_nineteen_faces_of_three_lines_have_their_labels():
    for projective in (False, True):
        found = written(scene_of(LESSON, faces="all", projective=projective))
        signs = ["".join("−0+"[s + 1] for s in face.signs) for face in LESSON.faces()]
        assert len(signs) == 19
        assert sorted(text for text in found if text in signs) == sorted(signs)


@pytest.mark.parametrize("normal", [(0, 1), (1, 0), (1, 1), (-1, 2), (-3, -1), (5, -7)])
@pytest.mark.parametrize("view", [draw_lines, draw_gnomonic])
def test_rim_numbers_have_the_order_of_their_lines(normal, view):
    a, b = normal
    rows, offsets = [normal, normal, normal, (-b, a)], [-1, 0, 1, 0]
    if view is draw_lines:
        scene = view.scene(Arrangement(rows, offsets), projective=True, labels="none")
    else:
        cone = Arrangement([(*row, -c) for row, c in zip(rows, offsets, strict=True)])
        scene = view.scene(cone, camera=(0, 0, 1), labels="none", coordinates="given")
    numbers = [item for item in scene.items if isinstance(item, Label) and item.text in "123"]
    middle = np.array(np.mean([item.place for item in numbers], axis=0))
    for side in (1, -1):
        along = side * np.array([-b, a])
        here = [x for x in numbers if np.subtract(x.place, middle) @ along > 0]
        assert [x.text for x in sorted(here, key=lambda x: np.dot(normal, x.place))] == [
            "1",
            "2",
            "3",
        ]


def test_parallel_classes_have_dots_at_infinity():
    found = elements(scene_of(LINES["shi"], projective=True))
    assert found["infinity"] == 6
    assert "infinity" not in elements(scene_of(LESSON, projective=True))


@pytest.mark.parametrize("projective", [False, True])
def test_arrows_point_to_the_positive_sides(projective):
    """The tip of an arrow is where its line alone has the sign +."""
    for k in range(3):
        normal, offset = LESSON.normals[k], LESSON.offsets[k]
        one, turned = (
            scene_of(Arrangement([[s * x for x in normal]], [s * offset]), sides=True,
                     projective=projective)
            for s in (1, -1)
        )  # fmt: skip
        for sheet in (one, turned):
            arrow = [i for i in sheet.items if i.name == "side-1"][-1]
            plus = next(i for i in sheet.items if isinstance(i, Label) and i.text == "+")
            minus = next(i for i in sheet.items if isinstance(i, Label) and i.text == "−")
            line = next(i for i in sheet.items if i.name.startswith(("line", "front")))
            way = np.array(plus.place) - np.array(minus.place)
            tip = arrow.points.mean(axis=0)
            start = line.points[0]
            ends = line.points[-1] - start
            normal_on_paper = np.array([-ends[1], ends[0]])
            assert ((tip - start) @ normal_on_paper) * (way @ normal_on_paper) > 0


def test_the_legend_counts_bounded_and_unbounded_regions():
    found = written(scene_of(LINES["shi"]))
    assert {"4 bounded regions", "12 unbounded"} <= set(found)


def test_labels_without_room_are_counted_on_stderr(capsys):
    with progress.shown():
        found = written(scene_of(LINES["shi"], faces="all", width=40))
    assert re.search(r"^no room for \d+ of the labels of ", capsys.readouterr().err, re.MULTILINE)
    assert not any("no room" in text for text in found)


def test_projective_legend_has_the_region_colours():
    """Parts that meet across the rim are one region, with the sides of both."""
    planes = read_arrangement("shi-a2-affine")
    made = draw_lines.scene(planes, projective=True, colour="sides")
    assert [text for _, _, text in made.legend.keys[:2]] == ["3 sides", "4 sides"]


def test_a_window_shows_what_meets_it():
    """The first window of the lines x = 0, y = 0, x + y = 1 is met by the third one alone."""
    lines = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
    made = scene_of(lines, window=[("1/4", "1/4"), (1, "1/2")])
    assert elements(made) - Counter({"": 99}) == {"region": 2, "line": 1}
    assert "5 regions outside the window" in written(made)
    across = scene_of(lines, window=[(-1, -1), (1, 1)], faces="all")
    assert elements(across) - Counter({"": 99}) == {"region": 5, "line": 3, "vertex": 3}
    for wrong in ({"window": [(0, 0)]}, {"window": [(0, 0), (0, 1)]}, {"projective": True}):
        with pytest.raises(InputError, match="window"):
            scene_of(lines, **{"window": [(0, 0), (1, 1)], **wrong})


@pytest.mark.parametrize(
    ("planes", "sizes"),
    [
        (read_arrangement("cube-diagonals"), [6, 8]),
        # The same in other coordinates, in which the first region is of the larger orbit.
        (Arrangement([[1, -1, 0], [-1, -1, 0], [-1, 1, -2], [3, -1, 2]]), [6, 8]),
        (read_arrangement("braid-a3"), [24]),
        (coxeter("H3"), [120]),
        (random_integer(5, 3, seed=1), [2] * 11),
    ],
)
@pytest.mark.parametrize("view", ["sphere", "graph"])
def test_orbits_are_those_of_the_symmetries(planes, sizes, view):
    made = DRAWINGS.draw(planes, view, colour="orbits").scene
    keys = [key.text for key in made.legend.keys if "orbit" in key.text]
    assert keys == [f"orbit of {size}" for size in sizes]
    signs = [face.signs for face in planes.regions()]
    found = Counter(orbits(planes, signs))
    assert [found[k] for k in range(len(found))] == sizes


def test_own_colours_come_in_the_order_of_the_legend():
    def fills(colour):
        made = DRAWINGS.draw(read_arrangement("cube-diagonals"), colour=colour).scene
        drawn = {x.style["fc"] for x in made.items if x.name.startswith("region")}
        keys = {key.symbol[0].style["fc"]: key.text for key in made.legend.keys}
        assert drawn == keys.keys()
        return keys

    assert fills("sides:gold,#00aaff") == {"#ffd700": "3 sides", "#00aaff": "4 sides"}
    assert fills(["gold", "#00aaff"]) == fills("gold,#00aaff") == fills("sides:gold,#00aaff")
    assert fills("orbits:gold,white") == {"#ffd700": "orbit of 6", "#ffffff": "orbit of 8"}
    alone = DRAWINGS.draw(read_arrangement("cube-diagonals"), colour="gold").scene
    assert {x.style["fc"] for x in alone.items if x.name.startswith("region")} == {"#ffd700"}
    assert not [key for key in alone.legend.keys if "minus" in key.text]
    for colour, said in (("sides:gelb", "is not a colour"), ("site:red", "did you mean sides")):
        with pytest.raises(InputError, match=said):
            fills(colour)


def test_some_regions_have_colours_by_sign_vector():
    planes = read_arrangement("coordinate-planes")
    made = DRAWINGS.draw(planes, colour="+++=gold,+-+=#0af").scene
    fills = Counter(x.style["fc"] for x in made.items if x.name.startswith("region"))
    assert fills.keys() == {"#ffd700", "#00aaff", "#ffffff"}
    for colour, text in (("++=gold", "'\\+\\+' is given"), ("+++=gelb", "is not a colour")):
        with pytest.raises(InputError, match=text):
            DRAWINGS.draw(planes, colour=colour)


@pytest.mark.parametrize(
    ("labels", "texts"),
    [
        ("++++++=A,3=B", {"A", "B"}),
        ({"++++++": "A", 3: "B"}, {"A", "B"}),
        ("1,3", {"1", "3"}),
        ([1, (1, 1, -1, 1, -1, -1)], {"1", "3"}),
    ],
)
def test_some_regions_only_have_labels(labels, texts):
    planes = read_arrangement("braid-a3")
    assert [planes.regions()[k].signs for k in (0, 2)] == [(1,) * 6, (1, -1, 1, -1, -1, -1)]
    made = DRAWINGS.draw(planes, "graph", labels=labels).scene
    assert {x.text for x in made.items if isinstance(x, Label)} - {*"123456"} == texts - {*"123456"}
    for wrong in ("25", "+-", "+-+-+-=A", "sing"):
        with pytest.raises(
            InputError, match=r"(there is no region|did you mean).* such as 1=a,2=b"
        ):
            DRAWINGS.draw(planes, labels=wrong)


def test_dual_names_front_vertices_or_reports_omissions(capsys):
    with progress.shown():
        made = DRAWINGS.draw(
            read_arrangement("nine-generic-planes"), "dual", labels="numbers"
        ).scene
    front = {x.name.split("-")[1] for x in made.items
             if x.name.startswith("vertex") and x.order == 5}  # fmt: skip
    assert not made.legend.captions
    left = set(re.findall(r"\d+", capsys.readouterr().err.partition("no room")[2]))
    written = {x.text for x in made.items if isinstance(x, Label) and x.place[0] > made.width / 2}
    assert left < front
    assert front - left <= written


@pytest.mark.parametrize("planes", [coxeter("H3"), simplicial(13, 2), random_integer(9, 3, seed=2)])
def test_a_gnomonic_chart_shows_lines_where_the_planes_meet_it(planes):
    """Each piece lies on the line of its plane; regions fill the disc and have these signs."""
    ahead = (1, 2, 4)
    made = draw_gnomonic.scene(planes, camera=ahead, coordinates="given", labels="none")
    (rim,) = (item for item in made.items if item.name == "border")
    units = np.array([[float(x) for x in plane[:3]] for plane in planes.integer_planes])
    units /= np.linalg.norm(units, axis=1)[:, None]
    globe = charts._upright(Globe(planes, ahead)).axes
    reach = charts._cut(Globe(planes, ahead)).reach
    places = {}
    for item in made.items:
        flat = (getattr(item, "points", np.zeros((1, 2))) - rim.points) / rim.radius * reach
        if item.name.startswith(("front", "region")):
            places[item.name] = np.column_stack([flat, np.ones(len(flat))]) @ globe
    whole = 0.0
    signs = {f"region-{k}": face.signs for k, face in enumerate(planes.regions(), 1)}
    for name, points in places.items():
        heights = points @ units.T
        if name.startswith("front"):
            assert np.abs(heights).max(axis=0).min() < 1e-6
        else:
            assert tuple(np.sign(heights.mean(axis=0)).astype(int)) == signs[name]
            whole += area((points @ globe.T)[::3, :2])
    assert whole == pytest.approx(np.pi * reach**2, rel=2e-3)


def test_a_call_of_draw_enters_each_package_once_and_25_files():
    """Before the first line of the view, `drawing` and `pictures` are entered once each."""
    read_arrangement("braid-a3").draw("sphere")  # imports what is imported when it is used
    planes, walk = read_arrangement("braid-a3"), []

    def record(frame: Any, event: str, _: Any) -> None:
        place = Path(frame.f_code.co_filename)
        if event == "call" and place.is_relative_to(PACKAGE):
            walk.append((place.relative_to(PACKAGE), frame.f_code.co_name))

    sys.setprofile(record)
    try:
        planes.draw("sphere")
    finally:
        sys.setprofile(None)
    assert len({path for path, _ in walk}) <= 25
    before = [path for path, _ in walk[: walk.index((Path("pictures/globe.py"), "draw_sphere"))]]
    packages = [path.parts[0] for path in before if path.parts[0] in ("drawing", "pictures")]
    assert [package for package, _ in groupby(packages)] == ["drawing", "pictures"]
