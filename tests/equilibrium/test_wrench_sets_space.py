from fractions import Fraction
from itertools import combinations, product

import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings, strategies as st

from arrangement.errors import InputError
from arrangement.numbers.exact import dot, from_floats, primitive
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import from_conditions, from_generators
from arrangement.numbers.linear.rank import cross, rank
from equilibrium import Contact, Grasp, ResistedSet, solve
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import from_float_data
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.model.errors import GraspError
from equilibrium.plane.states.contact_states import contact_states
from equilibrium.wrench_sets import outline, polyhedra
from equilibrium.wrench_sets.along_in_space import spatial_magnitudes
from equilibrium.wrench_sets.line import resisted_magnitudes
from equilibrium.wrench_sets.outline import outline_of
from equilibrium.wrench_sets.polyhedra import StateImages, magnitudes_in, states_with
from equilibrium.wrench_sets.separation import possibly_meeting, sides, surely_outside
from equilibrium.wrench_sets.slice import FORCES, resisted_region
from proofs_check.examples.gaps import gaps, small_grasps

from .oracle import intervals
from .strategies import directions, loads as wrenches, wide_grasps as grasps

entries = st.integers(-3, 3)
row4 = st.tuples(entries, entries, entries, entries).filter(any)
rows4 = st.lists(row4, max_size=7)
finite4 = rows4.map(lambda rows: [(*row[:3], abs(row[3])) for row in rows]).filter(
    lambda rows: any(row[3] for row in rows)
)
pointed4 = st.lists(row4, min_size=4, max_size=7).filter(lambda rows: rank(rows) == 4)


@given(rows4)
def test_lines_of_a_cone_are_what_rank_lacks(rows):
    assert len(generators(rows, [], 4)[1]) == 4 - (sympy.Matrix(rows).rank() if rows else 0)


@given(pointed4)
def test_rays_are_the_tight_solutions_of_rank_three(rows):
    """Oracle for pointed cones: every extreme ray is the null space of three of the rows."""
    rays, lines = generators(rows, [], 4)
    assert not lines
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


@given(finite4)
def test_no_condition_of_a_polyhedron_is_redundant(generating):
    shape = from_generators(generating, (), 3)
    for i, row in enumerate(shape.inequalities):
        others = [*shape.inequalities[:i], *shape.inequalities[i + 1 :]]
        answer = programs.minimize(row[:3], others, shape.equalities)
        assert isinstance(answer, programs.Unbounded) or answer.value + row[3] < 0


@given(grasps(), wrenches)
def test_membership_is_the_verdict_of_the_solver(grasp, wrench):
    assert bool(states_with(ResistedSet(grasp).polyhedra, wrench)) == solve(grasp, wrench).stable


@given(grasps(most=5), directions, wrenches)
def test_lines_through_the_polyhedra_are_the_intervals(grasp, direction, base):
    found = resisted_magnitudes(grasp, direction, base).intervals
    assert magnitudes_in(ResistedSet(grasp).polyhedra, base, direction) == found


@given(grasps(most=2), wrenches)
def test_states_that_no_motion_has_add_nothing(grasp, wrench):
    """Every one of the 4^m choices gives resisted wrenches only."""
    everything = product(("detached", "slip+", "slip-", "stick"), repeat=len(grasp))
    shapes = (StateImages(grasp).resisted_with(states) for states in everything)
    pieces = ResistedSet(grasp).polyhedra
    for shape in shapes:
        if shape is not None:
            assert all(states_with(pieces, point) for point in shape.points)
            assert not shape.contains(wrench) or states_with(pieces, wrench)


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


TINY = Fraction(1, 10**30)
THREE, FOUR = "paper-three-contacts", "paper-four-contacts"


def scaled(direction, t, base=(0, 0, 0)):
    return [b + t * u for b, u in zip(base, direction, strict=True)]


def test_a_grasp_whose_magnitudes_have_a_gap():
    grasp, direction = read_grasp("interrupted-push"), (-1, 0, 0)
    found = resisted_magnitudes(grasp, direction)
    assert found.intervals == ((0, 1), (2, None))
    assert found.to_dict() == {"intervals": [["0", "1"], ["2", None]]}
    for t, stable in [(0, 1), (1, 1), (1 + TINY, 0), (2 - TINY, 0), (2, 1), (1000, 1)]:
        assert solve(grasp, scaled(direction, t)).stable == bool(stable)


def test_gaps_of_the_example_file_are_right():
    assert not any(any(gaps(grasp)) for grasp in small_grasps(1, seed=0, count=3))
    grasp, (direction, intervals) = next(
        (grasp, gap) for grasp in small_grasps(3, seed=29, count=12) for gap in gaps(grasp)
    )
    ends = [end for part in intervals for end in part if end is not None]
    middle = (ends[1] + ends[2]) / 2 if len(ends) > 2 else ends[0] / 2
    assert not solve(grasp, scaled(direction, middle)).stable
    assert solve(grasp, scaled(direction, ends[-1])).stable


@given(st.one_of(*[grasps(most=2)] * 4, grasps(least=3)), directions, wrenches)
def test_all_states_by_brute_force(grasp, direction, base):
    found = resisted_magnitudes(grasp, direction, base).intervals
    assert found == intervals(grasp, direction, base)


@pytest.mark.parametrize("direction", [(0, 0, 0), (1, 0), (1, 0, 0, 0), (0.5, 0, 0), "100"])
def test_bad_directions_are_refused(direction):
    with pytest.raises((GraspError, InputError)):
        resisted_magnitudes(Grasp(), direction)


conditions = st.lists(st.tuples(entries, entries, entries).filter(any), max_size=5)
polygons = conditions.map(lambda rows: from_conditions(rows, [], 2)).filter(
    lambda shape: shape is not None
)
frames = st.sampled_from(
    [FORCES, ((1, 0, 0), (0, 0, 1)), ((1, 2, -1), (0, 1, Fraction(1, 2))), ((0, 2, 1), (2, 1, 0))]
)


@given(grasps(most=4), frames, wrenches)
def test_plane_cuts_every_state_like_all_wrenches(grasp, spans, origin):
    spans = [tuple(map(Fraction, span)) for span in spans]
    origin = tuple(map(Fraction, origin))
    normal = cross(*spans)
    plane = primitive((*normal, -dot(normal, origin)))
    images, listed = StateImages(grasp), contact_states(grasp)
    for states, may_reach in zip(listed, images.may_reach(listed, plane), strict=True):
        whole, reaching = images.resisted_with(states), images.resisted_with(states, plane)
        expected = None if whole is None else whole.cut(origin, spans)
        assert (None if reaching is None else reaching.cut(origin, spans)) == expected
        assert may_reach or expected is None


def test_states_that_miss_a_plane_known_from_ends():
    grasp, plane = random_grasp(6, 1).with_preload(1), (0, 0, 1, 0)
    images, listed = StateImages(grasp), contact_states(grasp)
    reaching = [images.resisted_with(states, plane) is not None for states in listed]
    assert images.may_reach(listed, plane).tolist() == reaching
    assert not all(reaching)


@given(st.lists(polygons, min_size=1, max_size=6))
def test_a_shape_that_is_surely_outside_is_not_within(shapes):
    outside = surely_outside(shapes)
    within = [[other.within(one) for other in shapes] for one in shapes]
    assert not (outside & within).any()
    assert not outside.diagonal().any()


@given(st.lists(polygons.filter(lambda shape: shape.dimension == 2), min_size=1, max_size=5))
def test_edges_that_do_not_meet_a_polygon_have_no_point_in_it(shapes):
    edges, lines = [], []
    for shape in shapes:
        for row in shape.inequalities:
            edges.append(outline.tight(row, shape))
            lines.append((row, shape))
    assume(edges)
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
    edges = [outline.tight(row, p) for p in shapes for row in p.inequalities]
    assert possibly_meeting(edges, shapes).mean() < 0.4
    assert surely_outside(shapes).mean() > 0.8


@given(grasps(most=4))
def test_the_polyhedra_are_the_same_without_the_quick_test(grasp):
    found = ResistedSet(grasp).polyhedra
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            polyhedra, "surely_outside", lambda s: np.zeros((len(s), len(s)), dtype=np.bool_)
        )
        assert ResistedSet(grasp).polyhedra == found


@settings(max_examples=40)
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


@pytest.mark.parametrize("seed", range(6))
def test_arrays_of_loads_are_answered_as_each_of_them(seed):
    """On small numbers many loads are on boundaries; contacts coincide or never touch."""
    source = np.random.default_rng(seed)
    m = 1 + seed % 5
    normals = np.array([(1, 0), (0, 1), (-1, 0), (0.6, 0.8)])[source.integers(4, size=m)]
    points = source.integers(-1, 2, size=(m, 2)).astype(float)
    loads = np.concatenate([source.integers(-2, 3, size=(20, 3)) / 2.0, np.zeros((1, 3))])
    loads[-2] = 1e-80, -1.0, 1e80
    found = check_loads(points, normals, 0.5 * (seed % 3), loads, preload=float(seed % 2))
    solver = Solver(found.grasp)
    assert found.proved.all()
    for load, resisted in zip(loads, found.resisted, strict=True):
        assert resisted == solver.solve(from_floats(load)).stable


def test_large_loads_of_every_direction_are_resisted_as_in_print():
    """Table III at preload 5: five times a load of preload 1."""
    every = [row for k in range(3) for row in (5.0 * np.eye(3)[k], -5.0 * np.eye(3)[k])]
    grasp = read_grasp("paper-four-contacts").with_preload(5)
    assert ResistedSet(grasp).check(every).resisted.all()
    assert ResistedSet(grasp).check([[0, 10.0, 0], [0, 10.5, 0]]).resisted.tolist() == [True, False]


ONE = ([[0.0, 0.0]], [[0.0, 1.0]], 0.5)


def check_loads(points, normals, friction, wrenches, **values):
    grasp = from_float_data(points, normals, friction, **values).grasp
    return ResistedSet(grasp).check(wrenches)


def test_loads_have_three_finite_numbers_each():
    for wrong in ([0.0, 1.0, 0.0], [[0.0, 1.0]], [[0.0, np.nan, 0.0]]):
        with pytest.raises(GraspError, match=r"give \(n, 3\) finite numbers"):
            check_loads(*ONE, wrong)


@pytest.mark.parametrize(
    ("loads", "message"),
    [
        (np.array([[1 + 2j, 0, 0]]), "an array of complex128; give real numbers"),
        (np.ma.array([[1.0, 2, 3]], mask=[[0, 1, 0]]), "masked entries"),
        ([np.ma.array([1.0, 2, 3], mask=[0, 1, 0])], "masked entries"),
        (np.array([["1/2", 0, 0]], object), r"an array of object; .* `ResistedSet.solve_many`"),
        ([[True, False, True]], "an array of bool"),
        ([[1, 2, 3], [1]], "rows of different lengths"),
        ([[2**53 + 1, 0, 0]], "9007199254740993, which floats round"),
        (np.array([[2**63 + 1, 0, 0]], np.uint64), "which floats round"),
        (5, "finite numbers"),
        ("abc", "give real numbers"),
    ],
)
def test_loads_that_are_no_floats_are_refused(loads, message):
    with pytest.raises(GraspError, match=message):
        check_loads(*ONE, loads)


def test_huge_loads_are_answered_without_a_warning(recwarn):
    loads = [[1e308, -1e308, 1e308], [0, -1e308, 0], [0, 1e-320, 0], [0, -1e-320, 0]]
    assert check_loads(*ONE, loads).resisted.tolist() == [False, True, False, True]
    assert not recwarn.list


@pytest.mark.parametrize(
    ("argument", "message"),
    [
        ({"points": np.array([[1j, 0]])}, r"points\[0\]\[0\] is 1j of type complex"),
        ({"points": 5}, "points is 5; give a sequence of points"),
        ({"points": [5]}, r"points\[0\] is 5; give a sequence"),
        ({"normals": None}, "normals is None; give a sequence of vectors"),
        ({"normals": np.ma.array([[1.0, 0]], mask=[[0, 1]])}, r"normals\[0\]\[1\] has masked"),
        ({"friction": np.array([1j])}, r"friction\[0\] is 1j"),
        ({"friction": [np.nan]}, r"friction\[0\] is nan; only finite"),
    ],
)
def test_data_that_are_no_real_numbers_are_refused(argument, message):
    given = {"points": ONE[0], "normals": ONE[1], "friction": 0.5, **argument}
    with pytest.raises(InputError, match=message):
        check_loads(wrenches=[[0.0, 0, 0]], **given)


def test_stiffness_within_the_tolerance_of_zero_is_refused():
    with pytest.raises(GraspError, match=r"stiffness\[1\] is ≈1e-8, which is 0 within the tol"):
        check_loads(2 * ONE[0], 2 * ONE[1], 0.5, [[0.0, 0, 0]], stiffness=[1, 1e-8])


def test_soft_springs_are_not_rounded_to_nothing():
    """The tolerance of a millionth is a share of numbers that are all small."""
    points, normals = [[1.0, 0.0], [-1.0, 0.0]], [[-1.0, 0.0], [1.0, 0.0]]
    found = check_loads(points, normals, 0.5, [[0.0, 1e-9, 0.0]], stiffness=1e-6, preload=1e-9)
    assert all(c.stiffness == Fraction(1, 10**6) for c in found.grasp)
    assert all(abs(c.preload * 10**9 - 1) < Fraction(1, 10**5) for c in found.grasp)
    assert found.resisted.all()
    with pytest.raises(GraspError, match=r"coordinate is .*, which is 0 within"):
        check_loads([[1e-7, 0.0]], [[1.0, 0.0]], 0.5, [[0.0, 0, 0]])
