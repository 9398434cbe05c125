"""Flat drawings, dual, graph, lattice: what is drawn is what is counted; labels stay apart."""

from __future__ import annotations

import math
from collections import Counter
from fractions import Fraction
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from arrangement import Arrangement, InputError
from arrangement.cli import main
from arrangement.counts import f_vector, region_count, whitney_numbers
from arrangement.drawing.colours import PALETTE
from arrangement.drawing.figure import figure
from arrangement.drawing.output import own_settings
from arrangement.drawing.scene.items import Path as Drawn
from arrangement.drawing.scene.labels import covering, keep_off, spread
from arrangement.drawing.scene.layers import layered_orders
from arrangement.drawing.scene.scene import Scene
from arrangement.duals.inscribed import representative_hull
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import (
    draw_counts,
    draw_dual,
    draw_gnomonic,
    draw_graph,
    draw_lattice,
    draw_stereographic,
)
from arrangement.pictures.duals.graph import PlanarGraph, planar_graph
from arrangement.pictures.duals.solids import dual_solid
from arrangement.pictures.duals.tutte import tutte_places
from arrangement.pictures.sphere.projections import CompressedChart, stereographic
from tests.drawn import paths

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
SPHERICAL = {
    "stereographic": draw_stereographic,
    "gnomonic": draw_gnomonic,
    "dual": draw_dual,
}


def elements(figure: Any) -> dict[str, int]:
    """Count the named elements of a figure by the part of the name before the first dash."""
    others = (artist.get_gid() or "" for artist in figure.axes[0].get_children())
    names = [*(path.name for path in paths(figure)), *others]
    return Counter(name.split("-")[0] for name in names)


def texts(figure: Any) -> list[Any]:
    """Return all texts that are seen; ticks beyond the axes are not."""
    found = []
    for axes in figure.axes:
        found += [*axes.texts, axes.title, axes._left_title, axes.xaxis.label, axes.yaxis.label]
        found += axes.get_legend().get_texts() if axes.get_legend() else []
        for axis in (axes.xaxis, axes.yaxis) if axes.axison else ():
            low, high = sorted(axis.get_view_interval())
            labels = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
            found += [label for at, label in labels if low <= at <= high]
    return [text for text in found if text.get_text().strip()]


def overlaps(figure: Any) -> list[str]:
    """Name the texts that leave the figure, and the pairs that cover each other."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    renderer: Any = canvas.get_renderer()
    page = figure.bbox
    boxes = [(t.get_text(), t.get_window_extent(renderer)) for t in texts(figure)]
    found = [
        text for text, b in boxes if b.x0 < 0 or b.y0 < 0 or b.x1 > page.width or b.y1 > page.height
    ]
    for (s, a), (t, b) in combinations(boxes, 2):
        if a.x0 < b.x1 and b.x0 < a.x1 and a.y0 < b.y1 and b.y0 < a.y1:
            found.append(f"{s!r} and {t!r}")
    return found


# Numbers of elements.


@pytest.mark.parametrize("name", NAMES)
def test_whole_stereographic_picture_has_every_region_and_facet(name: str) -> None:
    planes = read_arrangement(name)
    found = elements(draw_stereographic(planes, whole=True))
    assert found["region"] == region_count(planes)
    assert found["arc"] == f_vector(planes)[2]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("draw", [draw_stereographic, draw_gnomonic])
def test_half_pictures_have_half_of_what_is_counted_with_the_limb(name: str, draw: Any) -> None:
    planes = read_arrangement(name)
    options = {"whole": False} if draw is draw_stereographic else {}
    found = elements(draw(planes, direction=VIEW, **options))
    _, _, arcs, regions = f_vector(Arrangement([*planes.normals, VIEW]))
    assert found["region"] == regions // 2
    assert 2 * found["front"] + found["limb"] == arcs


@pytest.mark.parametrize("name", RANK_THREE)
def test_dual_picture_has_the_faces_of_the_dual(name: str) -> None:
    """A ray, a facet and a region are a face, an edge and a vertex; half of the faces are seen."""
    planes = read_arrangement(name)
    _, rays, facets, regions = f_vector(planes)
    figure = draw_dual(planes)
    names = [path.name for path in paths(figure)]
    assert sum(x.startswith("vertex") for x in names) == regions
    assert sum(x.startswith("edge") for x in names) == facets
    assert sum(x.startswith("face") for x in names) == rays // 2


@pytest.mark.parametrize("name", ["pencil", "paper-four-contacts"])
def test_dual_of_a_pencil_is_a_polygon(name: str) -> None:
    planes = read_arrangement(name)
    found = elements(draw_dual(planes))
    corners = 2 * len(planes.distinct)
    assert (found["vertex"], found["edge"], found["face"]) == (corners, corners, 1)


def test_dual_of_one_plane_is_a_segment() -> None:
    found = elements(draw_dual(Arrangement([[1, 2, 2], [-1, -2, -2]])))
    assert (found["vertex"], found["edge"], found.get("face", 0)) == (2, 1, 0)


@pytest.mark.parametrize("name", NAMES)
def test_graph_has_a_vertex_for_each_region_and_an_edge_for_each_facet(name: str) -> None:
    planes = read_arrangement(name)
    found = elements(draw_graph(planes))
    assert found["vertex"] == region_count(planes)
    assert found["edge"] == f_vector(planes)[2]


@pytest.mark.parametrize("name", [*NAMES, "shi-a2-affine", "braid-a3-in-r4", "nine-generic-planes"])
def test_lattice_has_the_flats_that_the_whitney_numbers_count(name: str) -> None:
    planes = read_arrangement(name)
    figure = draw_lattice(planes)
    assert elements(figure)["flat"] == sum(whitney_numbers(planes).second)
    written = " ".join(text.get_text() for text in figure.axes[0].texts)
    for number in whitney_numbers(planes).first:
        assert f"\u03a3\u03bc = {number}".replace("-", "\u2212") in written


def test_marks_of_the_counts_are_zaslavskys_numbers_and_lie_on_the_printed_curves() -> None:
    with own_settings():
        scene = draw_counts.scene(largest=8)
    items = {item.name: item for item in scene.items if isinstance(item, Drawn) and item.name}
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
    planes = read_arrangement("nine-generic-planes")
    plain, even = (
        draw_stereographic(planes, whole=False, coordinates=x).axes[0] for x in ("given", "even")
    )
    assert len(even.texts) > len(plain.texts) + 5
    assert overlaps(even.figure) == []


# The planar drawing.


def crossing_edges(graph: PlanarGraph) -> list[tuple[int, int]]:
    """Return pairs of edges that meet elsewhere than in a common end; exact on the floats."""
    places = [tuple(map(Fraction, place)) for place in graph.places.tolist()]

    def side(a: int, b: int, c: int) -> int:
        (px, py), (qx, qy), (rx, ry) = places[a], places[b], places[c]
        value = (qx - px) * (ry - py) - (qy - py) * (rx - px)
        return (value > 0) - (value < 0)

    found = []
    for (i, (a, b, _)), (j, (c, d, _)) in combinations(enumerate(graph.edges), 2):
        common = {a, b} & {c, d}
        if common:
            (shared,) = common
            p, q = ({a, b} | {c, d}) - common
            (sx, sy), (px, py), (qx, qy) = places[shared], places[p], places[q]
            ahead = (px - sx) * (qx - sx) + (py - sy) * (qy - sy) > 0
            if side(shared, p, q) == 0 and ahead:
                found.append((i, j))
        elif not any(side(*three) for three in ((a, b, c), (a, b, d), (c, d, a))):
            (low, high), (start, end) = (
                sorted((places[u], places[v])) for u, v in ((a, b), (c, d))
            )
            if low <= end and start <= high:
                found.append((i, j))
        elif side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0:
            found.append((i, j))
    return found


@pytest.mark.parametrize("name", NAMES)
def test_no_edges_of_the_graph_cross(name: str) -> None:
    graph = planar_graph(read_arrangement(name))
    assert len(set(map(tuple, graph.places.tolist()))) == len(graph.places)
    assert crossing_edges(graph) == []


def test_the_check_for_crossings_finds_them() -> None:
    graph = planar_graph(read_arrangement("coordinate-planes"))
    inner = [v for v in range(8) if v not in graph.outer]
    places = graph.places.copy()
    places[inner[:2]] = places[inner[1::-1]]
    assert crossing_edges(PlanarGraph(places, graph.signs, graph.edges, graph.outer))


@pytest.mark.parametrize("name", ["coordinate-planes", "five-generic-planes", "braid-a3"])
def test_unweighted_places_are_the_rational_solution_of_tuttes_equations(name: str) -> None:
    """Solved again in rationals, from the graph alone, with the outer polygon as drawn."""
    import sympy

    dual = dual_polyhedron(read_arrangement(name))
    outer = max(dual.faces, key=len)
    places = tutte_places(len(dual.signs), dual.faces, outer, rounds=0)
    network = dual.graph()
    inner = [v for v in network if v not in outer]
    matrix = sympy.zeros(len(inner))
    right = sympy.zeros(len(inner), 2)
    for i, v in enumerate(inner):
        matrix[i, i] = network.degree[v]
        for u in network[v]:
            if u in outer:
                for k in range(2):
                    right[i, k] += sympy.Rational(Fraction(places[u][k]))
            else:
                matrix[i, inner.index(u)] = -1
    solution = matrix.to_DM().to_field().lu_solve(right.to_DM().to_field()).to_Matrix()
    assert np.allclose(np.array(solution, dtype=float), places[inner], atol=1e-8)


def test_all_faces_of_a_planar_drawing_are_convex() -> None:
    dual = dual_polyhedron(read_arrangement("nine-generic-planes"))
    graph = planar_graph(dual.arrangement)
    places = [tuple(map(Fraction, place)) for place in graph.places.tolist()]
    for cycle in dual.faces:
        turns = set()
        for k, b in enumerate(cycle):
            following = cycle[(k + 1) % len(cycle)]
            (ax, ay), (bx, by), (cx, cy) = places[cycle[k - 1]], places[b], places[following]
            turns.add((bx - ax) * (cy - by) - (by - ay) * (cx - bx) > 0)
        assert len(turns) == 1


# Labels.


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("draw", "options"),
    [
        (draw_stereographic, {"whole": False}),
        (draw_stereographic, {"whole": True}),
        (draw_stereographic, {"colour": "signs", "width": 60.0}),
        (draw_gnomonic, {"direction": (0, 0, 1)}),
        (draw_gnomonic, {"direction": (1, 0, 1), "colour": "none"}),
        (draw_dual, {"hull": True}),
        (draw_dual, {"width": 88.0}),
        (draw_dual, {"coordinates": "even", "colour": "signs"}),
        (draw_graph, {"colour": "signs"}),
        (draw_graph, {"width": 50.0}),
        (draw_lattice, {"width": 180.0, "moebius": False}),
    ],
)
def test_labels_do_not_collide_with_other_options(draw: Any, options: dict[str, Any]) -> None:
    assert overlaps(draw(read_arrangement("reflection-b3"), **options)) == []


@pytest.mark.parametrize("options", [{}, {"width": 88.0}, {"largest": 30}, {"largest": 4}])
def test_labels_of_the_counts_do_not_collide(options: dict[str, Any]) -> None:
    assert overlaps(draw_counts(**options)) == []


def test_the_check_for_collisions_finds_them() -> None:
    scene = Scene(40, 20)
    assert scene.write((30, 30), "one")
    assert not scene.write((33, 30), "two")
    assert overlaps(figure(scene)) == []
    scene.text((33, 30), "two")
    scene.text((0, 5), "three", ha="right")
    assert len(overlaps(figure(scene))) == 2


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


@pytest.mark.parametrize("view", ["stereographic", "gnomonic", "dual", "graph"])
@pytest.mark.parametrize("name", ["parallel-planes-affine", "generic-lines-affine"])
def test_planes_that_a_view_cannot_show_leave_no_file(
    view: str, name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["draw", name, "-o", str(tmp_path / "a.svg"), "--view", view]) == 2
    assert "error:" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_bad_options_are_refused() -> None:
    planes = read_arrangement("coordinate-planes")
    with pytest.raises(InputError, match="known are sides"):
        draw_stereographic(planes, colour="mood")
    with pytest.raises(InputError, match="lies on plane 3"):
        draw_stereographic(planes, direction=(1, 1, 0), whole=True)
    with pytest.raises(InputError, match="at least 40 millimetres"):
        draw_gnomonic(planes, width=10.0)
    with pytest.raises(InputError, match="rank 2"):
        draw_dual(read_arrangement("pencil"), hull=True)
    with pytest.raises(InputError, match="from 4 to 30"):
        draw_counts(largest=3)
    with pytest.raises(InputError, match="at most 500"):
        draw_lattice(Arrangement([[1, t, t * t] for t in range(40)]))


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


@pytest.mark.parametrize("draw", [draw_stereographic, draw_gnomonic])
def test_empty_space_is_one_region(draw: Any) -> None:
    assert elements(draw(Arrangement([], dimension=3)))["region"] == 1
