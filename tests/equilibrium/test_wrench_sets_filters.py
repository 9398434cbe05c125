"""What the quick tests leave out of the resisted sets is exactly nothing."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement.numbers.exact import dot, primitive
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import from_conditions
from arrangement.numbers.linear.rank import cross
from arrangement.numbers.linear.separation import possibly_meeting, sides, surely_outside
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.plane.states.contact_states import contact_states
from equilibrium.wrench_sets import outline, space
from equilibrium.wrench_sets.images import StateImages
from equilibrium.wrench_sets.outline import outline_of
from equilibrium.wrench_sets.plane import FORCES, resisted_region
from equilibrium.wrench_sets.space import resisted_set

from .strategies import loads as wrenches, wide_grasps as grasps

entries = st.integers(-3, 3)
conditions = st.lists(st.tuples(entries, entries, entries).filter(any), max_size=5)
polygons = conditions.map(lambda rows: from_conditions(rows, [], 2)).filter(
    lambda shape: shape is not None
)
frames = st.sampled_from(
    [FORCES, ((1, 0, 0), (0, 0, 1)), ((1, 2, -1), (0, 1, Fraction(1, 2))), ((0, 2, 1), (2, 1, 0))]
)


@given(grasps(most=4), frames, wrenches)
def test_a_plane_cuts_every_state_as_if_all_its_wrenches_were_there(grasp, spans, origin):
    spans = [tuple(map(Fraction, span)) for span in spans]
    origin = tuple(map(Fraction, origin))
    normal = cross(*spans)
    plane = primitive((*normal, -dot(normal, origin)))
    images = StateImages(grasp)
    for states in contact_states(grasp):
        whole, reaching = images.resisted_with(states), images.resisted_with(states, plane)
        expected = None if whole is None else whole.cut(origin, spans)
        assert (None if reaching is None else reaching.cut(origin, spans)) == expected


@given(st.lists(polygons, min_size=1, max_size=6))
def test_a_shape_that_is_surely_outside_is_not_within(shapes):
    outside = surely_outside(shapes)
    for i, one in enumerate(shapes):
        for j, other in enumerate(shapes):
            if outside[i, j]:
                assert not other.within(one)
    assert not outside.diagonal().any()


@given(st.lists(polygons.filter(lambda shape: shape.dimension == 2), min_size=1, max_size=5))
def test_edges_that_do_not_meet_a_polygon_have_no_point_in_it(shapes):
    edges, lines = [], []
    for shape in shapes:
        for row in shape.inequalities:
            edges.append(outline._tight(row, shape))
            lines.append((row, shape))
    if not edges:
        return
    meeting = possibly_meeting(edges, shapes)
    above, below = sides([row for row, _ in lines], shapes)
    for i, (row, shape) in enumerate(lines):
        for j, other in enumerate(shapes):
            common = from_conditions([*shape.inequalities, *other.inequalities], [row], 2)
            if common is not None:
                assert meeting[i, j]
                assert not above[i, j]
                assert not below[i, j]


@given(st.lists(polygons, max_size=7))
def test_the_outline_is_the_same_without_the_quick_tests(shapes):
    found = outline_of(shapes)
    with pytest.MonkeyPatch.context() as patch:
        nothing = lambda rows, solid: np.zeros((2, len(rows), len(solid)), dtype=bool)  # noqa: E731
        patch.setattr(outline, "sides", nothing)
        patch.setattr(
            outline,
            "possibly_meeting",
            lambda edges, solid: np.ones((len(edges), len(solid)), dtype=bool),
        )
        assert outline_of(shapes) == found


def test_the_quick_tests_leave_little_open():
    region = resisted_region(random_grasp(6, seed=1))
    shapes = [piece.polyhedron for piece in region.polygons if piece.polyhedron.dimension == 2]
    edges = [outline._tight(row, p) for p in shapes for row in p.inequalities]
    assert possibly_meeting(edges, shapes).mean() < 0.4
    assert surely_outside(shapes).mean() > 0.8


@settings(max_examples=15)
@given(grasps(most=4))
def test_the_polyhedra_are_the_same_without_the_quick_test(grasp):
    found = resisted_set(grasp)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(space, "surely_outside", lambda s: np.zeros((len(s), len(s)), dtype=np.bool_))
        assert resisted_set(grasp) == found


@settings(max_examples=80)
@given(st.lists(st.tuples(entries, entries, entries, entries).filter(any), max_size=7))
def test_a_cone_without_a_finite_point_is_given_up_and_no_other(rows):
    """With the condition in the list instead, the generators are the same or all infinite."""
    whole = generators([(0, 0, 0, 1), *rows], [], 4)
    found = generators(rows, [], 4, finite=True)
    if found == ((), ()) != whole:
        assert not any(ray[-1] for ray in whole[0])
        assert not any(line[-1] for line in whole[1])
    else:
        assert found == whole
        assert all(dot(row, ray) >= 0 for row in rows for ray in found[0])
