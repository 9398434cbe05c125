"""Surfaces of unions of polytopes against boxes counted cube by cube; orders of painting."""

from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st

from arrangement.drawing.solids.depth_tree import back_to_front, depth_tree
from arrangement.drawing.solids.surface import Patch, surface
from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.linear.polyhedron import Polyhedron, from_conditions, from_generators

CORNER = st.tuples(*[st.integers(0, 3)] * 3)
#: Low and high corners; flat ones among them.
BOXES = st.lists(st.tuples(CORNER, CORNER), min_size=1, max_size=4)


def box(low: IntegerVector, high: IntegerVector) -> Polyhedron:
    rows, flat = [], []
    for k in range(3):
        unit = [int(j == k) for j in range(3)]
        if low[k] == high[k]:
            flat.append((*unit, -low[k]))
        else:
            rows += [(*unit, -low[k]), (*(-x for x in unit), high[k])]
    found = from_conditions(rows, flat, 3)
    assert found is not None
    return found


def boxes(corners: list[tuple[IntegerVector, IntegerVector]]) -> list[Polyhedron]:
    pairs = (tuple(zip(*map(sorted, zip(*pair, strict=True)), strict=True)) for pair in corners)
    return [box(low, high) for low, high in pairs]


def corners_of(patch: Patch) -> np.ndarray:
    return np.array([[x / p[3] for x in p[:3]] for p in patch.corners])


def area(patch: Patch) -> float:
    steps = corners_of(patch)[1:] - corners_of(patch)[0]
    return float(np.linalg.norm(np.cross(steps[:-1], steps[1:]).sum(axis=0))) / 2


@given(BOXES)
def test_area_and_volume_are_those_of_the_unit_cubes(corners):
    solids = [shape for shape in boxes(corners) if shape.dimension == 3]
    assume(solids)
    filled = {
        cube
        for cube in product(range(3), repeat=3)
        if any(s.contains([2 * x + 1 for x in cube]) for s in map(doubled, solids))
    }
    steps = [tuple(s * int(j == k) for j in range(3)) for k in range(3) for s in (1, -1)]
    bare = sum(
        tuple(a + b for a, b in zip(cube, step, strict=True)) not in filled
        for cube in filled
        for step in steps
    )
    patches = surface(solids)
    assert np.isclose(sum(map(area, patches)), bare)
    volume = 0.0
    for patch in patches:
        normal = np.array(patch.row[:3]) / np.linalg.norm(patch.row[:3])
        volume += area(patch) * float(normal @ corners_of(patch)[0]) / 3
    assert np.isclose(volume, len(filled))


def doubled(shape: Polyhedron) -> Polyhedron:
    rows = [(*row[:3], 2 * row[3]) for row in shape.inequalities]
    found = from_conditions(rows, (), 3)
    assert found is not None
    return found


@given(BOXES)
def test_edges_are_where_the_surface_bends(corners):
    """An edge is drawn from either side, so lines have twice a whole length."""
    patches = surface([shape for shape in boxes(corners) if shape.dimension == 3])
    lines: dict[tuple[float, ...], float] = {}
    for patch in patches:
        for edge in patch.edges:
            low, high = sorted(tuple(x / c[3] for x in c[:3]) for c in edge)
            axis = int(np.argmax(np.subtract(high, low)))
            line = (axis, *(x for k, x in enumerate(low) if k != axis))
            lines[line] = lines.get(line, 0.0) + high[axis] - low[axis]
    for total in lines.values():
        assert np.isclose(total / 2, round(total / 2))


@given(BOXES)
def test_flat_parts_stay_as_far_as_they_stick_out(corners):
    shapes = boxes(corners)
    patches = surface(shapes)
    larger = [shape for shape in shapes if shape.dimension == 3]
    for patch in patches:
        if patch.sheet:
            inside = corners_of(patch).mean(axis=0)
            assert not any(
                all(np.array(row[:3]) @ inside + row[3] > 1e-9 for row in shape.inequalities)
                for shape in larger
            )
    for shape in shapes:
        if shape.dimension == 0 and not any(
            s.contains(shape.points[0]) for s in shapes if s.dimension
        ):
            assert any(len(patch.corners) == 1 for patch in patches)


POINTS = st.lists(st.tuples(*[st.integers(-4, 4)] * 3), min_size=4, max_size=6)


@pytest.mark.slow
@given(st.lists(POINTS, min_size=1, max_size=3), st.tuples(*[st.integers(-5, 5)] * 3))
def test_nothing_is_hidden_by_what_is_painted_before_it(clouds, direction):
    """Along random lines of sight, patches come in the order of their depths."""
    assume(any(direction))
    hulls = [from_generators([(*p, 1) for p in cloud], (), 3) for cloud in clouds]
    tree = depth_tree(surface([hull for hull in hulls if hull is not None]))
    order = [patch for node in back_to_front(tree, direction) for patch in node.patches]
    assert sum(len(node.patches) for node in tree) == len(order)
    ahead = np.array(direction) / np.linalg.norm(direction)
    samples = np.random.default_rng(5).uniform(-4, 4, (40, 3))
    for start in samples:
        depths = [d for patch in order if (d := depth(patch, start, ahead)) is not None]
        assert all(a < b + 1e-7 for a, b in pairwise(depths))


def depth(patch: Patch, start: np.ndarray, ahead: np.ndarray) -> float | None:
    """Return where a line of sight meets a patch well inside, if it does."""
    normal = np.array(patch.row[:3], dtype=float)
    if len(patch.corners) < 3 or abs(normal @ ahead) < 1e-9:
        return None
    t = -(normal @ start + patch.row[3]) / (normal @ ahead)
    at, corners = start + t * ahead, corners_of(patch)
    sides = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(sides, at - corners) @ normal
    return float(t) if (turns > 1e-6).all() or (turns < -1e-6).all() else None


def test_facets_run_counter_clockwise_seen_from_outside():
    shape = box((0, 0, 0), (1, 2, 3))
    places = np.array([[float(x) for x in p] for p in shape.points])
    for cycle, row in zip(shape.cycles, shape.inequalities, strict=True):
        a, b, c = places[list(cycle[:3])]
        assert np.cross(b - a, c - a) @ np.array(row[:3]) < 0
    assert len(shape.cycles) == 6
