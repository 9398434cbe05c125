"""The least point of a projected polyhedron: known values, and its optimality condition."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given, settings, strategies as st

from arrangement.numbers.linear.programs import Infeasible, Optimal, feasible_point, minimize
from equilibrium.plane.states.min_norm_point import least_point

PLANE = [(1, 0, 0), (0, 1, 0)]


def rows(*entries):
    return [tuple(map(Fraction, row)) for row in entries]


def test_half_plane_gives_the_foot_of_the_perpendicular():
    assert least_point(2, rows((1, 1, -2)), [], rows(*PLANE)) == (1, 1)


def test_cone_of_rays_away_from_the_origin():
    # x >= 1, y >= 2: unbounded, least at the corner.
    assert least_point(2, rows((1, 0, -1), (0, 1, -2)), [], rows(*PLANE)) == (1, 2)


def test_origin_inside_gives_the_origin():
    assert least_point(2, rows((1, 0, 3), (-1, 0, 3)), [], rows(*PLANE)) == (0, 0)


def test_projection_forgets_the_other_coordinates():
    # x + z = 3, 0 <= z <= 1, seen from x alone.
    equal, least = rows((1, 1, -3)), rows((0, 1, 0), (0, -1, 1))
    assert least_point(2, least, equal, rows((1, 0, 0))) == (2,)


row = st.tuples(*[st.integers(-3, 3)] * 3, st.integers(-4, 4))


@settings(max_examples=60)
@given(st.lists(row, max_size=6), st.lists(row, max_size=1))
def test_no_point_lies_beyond_the_supporting_plane(inequalities, equalities):
    least, equal = rows(*inequalities), rows(*equalities)
    if isinstance(feasible_point(3, least, equal), Infeasible):
        return
    image = rows((1, 0, 0, 0), (0, 1, 0, 0))
    x, y = least_point(3, least, equal, image)
    # x is least exactly when it is attained and <x, v> >= <x, x> for every v.
    reached = [*equal, *rows((1, 0, 0, -x), (0, 1, 0, -y))]
    assert not isinstance(feasible_point(3, least, reached), Infeasible)
    answer = minimize((x, y, 0), least, equal)
    assert isinstance(answer, Optimal)
    assert answer.value == x * x + y * y
