"""The least point of a projected polyhedron: known values, and its optimality condition."""

from fractions import Fraction

from hypothesis import given, strategies as st

from arrangement.numbers.linear.programs import Infeasible, Optimal, feasible_point, minimize
from equilibrium.plane.states.min_norm_point import least_point


def rows(*entries):
    return [tuple(map(Fraction, row)) for row in entries]


row = st.tuples(*[st.integers(-3, 3)] * 3, st.integers(-4, 4))


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
