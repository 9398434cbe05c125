from fractions import Fraction
from itertools import combinations, product

import sympy
from hypothesis import given, settings, strategies as st

from arrangement.numbers.exact import dot
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import from_conditions, from_generators
from equilibrium.decide.verdict import solve
from equilibrium.grasps.files import read_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.line import resisted_magnitudes
from equilibrium.wrench_sets.space import StateImages, resisted_set
from equilibrium.wrench_sets.spatial import spatial_magnitudes

from .strategies import directions, loads as wrenches, wide_grasps as grasps

entries = st.integers(-3, 3)
rows4 = st.lists(st.tuples(entries, entries, entries, entries).filter(any), max_size=7)


def test_a_cube_has_eight_vertices_and_six_faces():
    conditions = [(*(s * (i == j) for j in range(3)), 1) for i in range(3) for s in (1, -1)]
    cube = from_conditions([*conditions, (1, 1, 1, 3), (1, 0, 0, 5)], [], 3)
    assert sorted(cube.points) == sorted(product((-1, 1), repeat=3))
    assert sorted(cube.inequalities) == sorted(conditions)
    assert cube.bounded
    assert cube.dimension == 3


def test_contradicting_conditions_have_no_polyhedron():
    assert from_conditions([(1, -2), (-1, 1)], [], 1) is None
    assert from_conditions([(0, -1)], [], 1) is None


@given(rows4)
def test_rays_are_the_tight_solutions_of_rank_three(rows):
    """Oracle for pointed cones: every extreme ray is the null space of three of the rows."""
    rays, lines = generators(rows, [], 4)
    rank = sympy.Matrix(rows).rank() if rows else 0
    assert len(lines) == 4 - rank
    if rank < 4:
        return
    expected = set()
    for chosen in combinations(rows, 3):
        null = sympy.Matrix(chosen).nullspace()
        if len(null) == 1:
            scale = sympy.ilcm(*(x.q for x in null[0]))
            whole = [int(x * scale) for x in null[0]]
            divisor = int(sympy.igcd(*whole))
            for sign in (1, -1):
                ray = tuple(sign * x // divisor for x in whole)
                if all(dot(row, ray) >= 0 for row in rows):
                    expected.add(ray)
    assert set(rays) == expected


@given(rows4)
def test_polar_of_the_polar_is_the_cone(rows):
    rays, lines = generators(rows, [], 4)
    again = generators(*generators(rays, lines, 4), 4)
    assert again == (rays, lines)


@given(rows4.map(lambda rows: [(*row[:3], abs(row[3])) for row in rows]))
def test_no_condition_of_a_polyhedron_is_redundant(generating):
    shape = from_generators(generating, (), 3)
    if shape is None:
        return
    for i, row in enumerate(shape.inequalities):
        others = [*shape.inequalities[:i], *shape.inequalities[i + 1 :]]
        answer = programs.minimize(row[:3], others, shape.equalities)
        assert isinstance(answer, programs.Unbounded) or answer.value + row[3] < 0


@given(grasps(), wrenches)
def test_membership_is_the_verdict_of_the_solver(grasp, wrench):
    assert resisted_set(grasp).contains(wrench) == solve(grasp, wrench).stable


@settings(max_examples=15)
@given(grasps(), st.data())
def test_vertices_are_resisted_with_the_states_of_their_piece(grasp, data):
    pieces = resisted_set(grasp).pieces
    piece = data.draw(st.sampled_from(pieces)) if pieces else None
    for vertex in piece.polyhedron.points if piece else ():
        assert solve(grasp, vertex).stable
        assert piece.states in resisted_set(grasp).states_at(vertex)


@given(grasps(most=5), directions, wrenches)
def test_lines_through_the_polyhedra_are_the_intervals(grasp, direction, base):
    found = resisted_magnitudes(grasp, direction, base).intervals
    assert resisted_set(grasp).along(direction, base) == found


@settings(max_examples=20)
@given(grasps(most=2), wrenches)
def test_states_that_no_motion_has_add_nothing(grasp, wrench):
    """Every one of the 4^m choices gives resisted wrenches only."""
    everything = product(("detached", "slip+", "slip-", "stick"), repeat=len(grasp))
    shapes = (StateImages(grasp).resisted_with(states) for states in everything)
    whole = resisted_set(grasp)
    for shape in shapes:
        if shape is not None:
            assert all(whole.contains(point) for point in shape.points)
            assert not shape.contains(wrench) or whole.contains(wrench)


@settings(max_examples=20)
@given(grasps(preload=st.just(0)))
def test_without_preload_every_piece_is_a_cone(grasp):
    for piece in resisted_set(grasp).pieces:
        assert all(row[3] == 0 for row in piece.polyhedron.inequalities)
        assert piece.polyhedron.contains((0, 0, 0))


def test_many_contacts_that_stick_at_once():
    """The redundancy removal on the way must not lose a wrench: a ring of equal contacts.

    With no motion all contacts stick, each with normal force 1; so the wrenches of that state are
    a sum of segments, and its extent in y is 2 friction times the sum of |t_y|.
    """
    units = [(1, 0), (Fraction(3, 5), Fraction(4, 5)), (Fraction(-3, 5), Fraction(4, 5)), (0, 1)]
    ring = [(x, y) for x, y in units] + [(-x, -y) for x, y in units]
    grasp = Grasp(Contact((-x, -y), (x, y), Fraction(1, 2), 1, 1) for x, y in ring)
    shape = StateImages(grasp).resisted_with(("stick",) * len(grasp))
    heights = [point[1] for point in shape.points]
    assert max(heights) == Fraction(1, 2) * sum(abs(c.tangent[1]) for c in grasp)
    assert min(heights) == -max(heights)
    assert solve(grasp, max(shape.points, key=lambda p: p[1])).stable


def test_a_border_at_zero_is_not_chased_to_the_smallest_float():
    """The wedge gives no force off its plane: 0 is resisted, and nothing beyond."""
    found = spatial_magnitudes(read_grasp("wedge"), (0, Fraction(3, 5), Fraction(-4, 5), 0, 0, 0))
    (border,) = found.borders
    assert border.resisted == 0
    assert Fraction(1, 10**15) < border.refused < Fraction(1, 10**12)
