"""The smallest wrench that is not resisted, by rays, by the surface of the set and by hand."""

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product

import pytest
from hypothesis import given, strategies as st

from arrangement.drawing.solids.surface import surface
from arrangement.errors import InputError
from arrangement.numbers.exact import dot, primitive
from arrangement.numbers.linear.polyhedron import from_conditions
from arrangement.numbers.linear.rank import cross
from equilibrium import Contact, Grasp, ResistedSet, solve
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.methods.form_closure import form_closure
from equilibrium.model.errors import GraspError
from equilibrium.wrench_sets import any_direction

from .strategies import loads, turned, wide_grasps

THREE, FOUR = "paper-three-contacts-preload-1", "paper-four-contacts-preload-1"
AXES = [tuple(side * (i == j) for j in range(3)) for i in range(3) for side in (1, -1)]
DIRECTIONS = [*AXES, (1, 2, -1), (-2, 1, 3), (3, -1, Fraction(1, 4))]
#: Half the side of the box in which the second route looks.
HALF = 3
grasps = wide_grasps(most=3, preload=st.integers(1, 2))
lengths = st.sampled_from([Fraction(1, 3), 1, 2])


def square(wrench, length=1):
    return wrench[0] ** 2 + wrench[1] ** 2 + (wrench[2] / Fraction(length)) ** 2


def first_unresisted(whole, direction, base, length):
    """Return the squared size of the last of the resisted magnitudes from 0 on; None: unbounded."""
    parts = whole.along(direction, base).intervals
    if not parts or parts[0][0] > 0:
        return 0
    return None if parts[0][1] is None else parts[0][1] ** 2 * square(direction, length)


def agrees_with_rays_and_verdicts(grasp, base=(0, 0, 0), length=1):
    """Every ray ends at that size at the earliest, and just beyond the boundary one has ended."""
    whole = grasp if isinstance(grasp, ResistedSet) else ResistedSet(grasp)
    found = whole.smallest_outside(base, length)
    directions = DIRECTIONS if not found.size_squared else [*DIRECTIONS, found.beyond]
    ends = [first_unresisted(whole, d, base, length) for d in directions]
    known = [end for end in ends if end is not None]
    if found.size_squared is None:
        assert not known
        assert found.size is found.wrench is found.beyond is None
        return found
    assert all(found.size_squared <= end for end in known)
    assert found.size_squared == square(found.wrench, length)
    assert found.size**2 <= found.size_squared < (found.size + Fraction(1, 2**40)) ** 2
    away = [x - y for x, y in zip(found.beyond, found.wrench, strict=True)]
    assert square(away, length) * 10**6 <= (found.size_squared or 1)
    refused = whole.solve([x + y for x, y in zip(base, found.beyond, strict=True)])
    assert not refused.stable
    assert refused.verify()
    if found.size_squared:
        inside = [x + y * Fraction(999, 1000) for x, y in zip(base, found.wrench, strict=True)]
        assert whole.solve(inside).stable
        assert square(found.beyond, length) >= found.size_squared
    return found


def by_surface(grasp, base, length):
    """Return the squared size by the surface of the set in a box; None if it ends nowhere there.

    The set is moved to the base and its torques are divided. Its parts on the walls are where the
    box cuts it.
    """
    scales = (1, 1, Fraction(length))
    walls = [(*axis, HALF) for axis in AXES]
    solids = []
    for piece in ResistedSet(grasp).polyhedra:
        rows = [
            primitive(
                [
                    *(a * s for a, s in zip(row[:3], scales, strict=True)),
                    Fraction(dot(row, (*base, 1))),
                ]
            )
            for row in piece.polyhedron.inequalities
        ]
        shape = None if piece.polyhedron.equalities else from_conditions([*rows, *walls], [], 3)
        if shape is not None and shape.dimension == 3:
            solids.append(shape)
    if not any(shape.contains((0, 0, 0)) for shape in solids):
        return 0
    outward = {tuple([-x for x in wall]) for wall in walls}
    patches = [patch for patch in surface(solids) if patch.row not in outward]
    return min((nearest_of_polygon(patch.corners) for patch in patches), default=None)


def nearest_of_polygon(corners):
    """Return the squared distance of a convex polygon in space from the origin."""
    points = [tuple(Fraction(x, p[3]) for x in p[:3]) for p in corners]
    found = [dot(p, p) for p in points]
    normal = cross(*([y - x for x, y in zip(points[0], p, strict=True)] for p in points[1:3]))
    turns = []
    for p, q in pairwise([*points, points[0]]):
        step = [y - x for x, y in zip(p, q, strict=True)]
        share = Fraction(-dot(p, step)) / dot(step, step)
        if 0 < share < 1:
            found.append(dot(p, p) - share**2 * dot(step, step))
        turns.append(dot(cross(step, [-x for x in p]), normal))
    if min(turns) >= 0 or max(turns) <= 0:
        found.append(Fraction(dot(points[0], normal)) ** 2 / dot(normal, normal))
    return min(found)


def agrees_with_the_surface(grasp, base=(0, 0, 0), length=1):
    found = ResistedSet(grasp).smallest_outside(base, length).size_squared
    expected = by_surface(grasp, base, length)
    if expected is not None and expected <= HALF**2:
        assert found == expected
    else:
        assert found is None or found > HALF**2


@given(grasps, loads, lengths)
def test_no_ray_ends_earlier_and_one_ends_there(grasp, base, length):
    agrees_with_rays_and_verdicts(grasp, base, length)


@given(grasps, loads, lengths)
def test_it_is_the_least_distance_to_the_surface_of_the_set(grasp, base, length):
    agrees_with_the_surface(grasp, base, length)


def test_random_grasp_agrees_with_the_surface():
    agrees_with_the_surface(random_grasp(4, 2, preload=True))


@pytest.mark.parametrize("base", list(product((-9, 1, 7), (-8, 2, 9), (-9, 0, 8))))
def test_nearest_point_of_facet_on_nearest_edge(base):
    """Where the foot of the plane is outside, no segment between two corners comes nearer."""
    rows = [(1, 2, 0), (-1, -1, 1), (1, -1, 0), (-1, 0, -2), (0, -1, 1), (-1, 1, 1), (2, 1, -1)]
    solid = from_conditions([(*row, 3) for row in rows], [], 3)
    sizes = any_direction._Sizes(tuple(map(Fraction, base)), Fraction(1))
    for row in solid.inequalities:
        part = any_direction._facet(row, solid, [], sizes)
        foot = sizes.foot(row)
        corners = any_direction._generators(part.cone)
        assert part.nearest == (foot if solid.contains(foot) else sizes.nearest(corners))


@pytest.mark.slow
@pytest.mark.parametrize(("contacts", "seeds"), [(2, 10), (3, 5), (4, 2), (5, 1)])
def test_random_grasps_agree_with_rays_and_surface(contacts, seeds):
    for seed in range(seeds):
        grasp = random_grasp(contacts, seed, preload=True)
        length = Fraction(1 + seed % 3, 2)
        agrees_with_rays_and_verdicts(grasp, length=length)
        agrees_with_the_surface(grasp, length=length)


@pytest.mark.slow
@given(wide_grasps(most=5, preload=st.integers(0, 2)), loads, lengths)
def test_awkward_grasps_agree_with_rays_and_with_the_surface(grasp, base, length):
    agrees_with_rays_and_verdicts(grasp, base, length)
    agrees_with_the_surface(grasp, base, length)


@pytest.mark.parametrize("preload", [1, 2, Fraction(1, 3)])
def test_four_fingers_that_squeeze_sideways_slip_when_pulled_up(preload):
    """Friction 1/2 at four contacts holds twice the preload, and all else needs more."""
    found = ResistedSet(read_grasp(FOUR).with_preload(preload)).smallest_outside()
    assert found.size == 2 * preload
    assert found.wrench in [(0, 2 * preload, 0), (0, -2 * preload, 0)]


@pytest.mark.parametrize("length", [1, 2, 100, Fraction(1, 50)])
def test_two_fingers_that_squeeze_hold_until_one_of_them_slips(length):
    """At (+-1, 0), preload 1, friction 1/2: normal forces 1 -+ f_x / 2, whatever f_y and tau are.

    The tangential ones are (f_y +- tau) / 2, so the boundary is +-f_x / 2 +- f_y +- tau = 1: a long
    length makes a torque the smallest wrench, a short one a force.
    """
    ends = [((-1, 0), (1, 0)), ((1, 0), (-1, 0))]
    fingers = Grasp(Contact(p, n, Fraction(1, 2), 1, 1) for p, n in ends)
    found = agrees_with_rays_and_verdicts(fingers, length=length)
    assert found.size_squared == 1 / (Fraction(5, 4) + Fraction(length) ** 2)


def test_frictionless_table_fails_when_pushed_sideways():
    """Two frictionless legs under a weight hold no push along the table, however small."""
    legs = Grasp(Contact((x, 0), (0, 1), 0) for x in (-1, 1))
    found = agrees_with_rays_and_verdicts(legs, base=(0, -2, 0))
    assert found.size_squared == 0


def test_table_holds_until_a_leg_slips_or_lifts():
    """The legs at (+-1, 0) with friction 1 hold f and t under a weight 2 if both push down enough.

    They slip when |f_x| >= |f_y|, and one lifts when |tau| >= |f_y|; with f = (a, -2 + b, t) the
    planes a = 2 - b and t = 2 - b are at distance sqrt(2).
    """
    legs = Grasp(Contact((x, 0), (0, 1), 1) for x in (-1, 1))
    found = agrees_with_rays_and_verdicts(legs, base=(0, -2, 0))
    assert found.size_squared == 2


def test_without_preload_it_is_zero_or_there_is_none():
    assert agrees_with_rays_and_verdicts(read_grasp("paper-three-contacts")).size_squared == 0
    around = [((1, 0), (-1, 0)), ((0, 1), (0, -1)), ((-1, 0), (1, 0))]
    closed = Grasp(Contact(p, n, 0) for p, n in [*around, ((-1, -1), (0, 1)), ((1, -1), (0, 1))])
    assert form_closure(closed).accepts
    assert agrees_with_rays_and_verdicts(closed).size_squared is None


#: The nearest point is on an edge of two facets.
SKEW = [
    ((Fraction(-3, 2), Fraction(-3, 2)), (5, -12), Fraction(7, 10), 2, Fraction(1, 2)),
    ((2, 2), (-5, 12), 1, 2, 1),
    ((-1, -3), (-5, 12), Fraction(1, 3), 1, 1),
]


def test_search_behind_a_facet_ends():
    unit = [(p, tuple(Fraction(x, 13) for x in n), *rest) for p, n, *rest in SKEW]
    agrees_with_rays_and_verdicts(Grasp(Contact(*given) for given in unit))


def test_generic_point_is_in_no_plane_at_the_point():
    corners = [(0, 0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 0)]
    wrong = from_conditions([(-2, 1, 0, 0), (1, 0, 0, 0)], [], 3)
    point = any_direction._generic((Fraction(0),) * 3, corners, [wrong])
    # With weights 1, k, k^2 it is (k, k^2, 0) / (1 + k), and k = 2 is in the plane 2 x = y.
    assert point == (Fraction(1, 2), Fraction(1, 2), 0)
    above = from_conditions([(-1, 1, 0, 0)], [], 3)
    point = any_direction._generic((Fraction(0),) * 3, corners, [above])
    assert point == (Fraction(2, 3), Fraction(4, 3), 0)


def test_of_no_contacts_nothing_but_zero_is_resisted():
    found = agrees_with_rays_and_verdicts(Grasp())
    assert (found.size_squared, found.wrench) == (0, (0, 0, 0))


def test_a_load_that_is_not_resisted_is_the_answer_itself():
    found = agrees_with_rays_and_verdicts(read_grasp(THREE), base=(0, 2, 0))
    assert (found.size_squared, found.beyond) == (0, (0, 0, 0))


def test_a_bound_on_displacements_counts():
    """A push t sideways is shared by four springs of stiffness 1: all move by t / 4."""
    found = agrees_with_rays_and_verdicts(ResistedSet(read_grasp(FOUR), max_displacement="1/10"))
    assert found.size == Fraction(2, 5)
    assert found.wrench in [(Fraction(2, 5), 0, 0), (Fraction(-2, 5), 0, 0)]


@given(grasps, st.sampled_from([2, Fraction(1, 3)]))
def test_it_grows_with_all_preloads(grasp, factor):
    larger = Grasp(replace(c, preload=factor * c.preload) for c in grasp)
    one, other = (ResistedSet(g).smallest_outside().size_squared for g in (grasp, larger))
    assert other == (None if one is None else factor**2 * one)


@given(grasps)
def test_invariant_under_rotation_and_length_units(grasp):
    found = ResistedSet(grasp).smallest_outside().size_squared
    contact, *_ = turned(Fraction(3, 5), Fraction(4, 5))
    assert ResistedSet(Grasp(map(contact, grasp))).smallest_outside().size_squared == found
    twice = Grasp(replace(c, point=tuple(2 * x for x in c.point)) for c in grasp)
    assert ResistedSet(twice).smallest_outside(torque_length=2).size_squared == found


def test_numbers_beyond_floats_are_no_obstacle():
    for power in (400, -400):
        unit = Fraction(10) ** power
        found = ResistedSet(read_grasp(FOUR).with_preload(unit)).smallest_outside()
        assert found.size == 2 * unit
        assert not solve(read_grasp(FOUR).with_preload(unit), found.beyond).stable


def test_bad_input_is_refused_with_a_reason():
    grasp = read_grasp(THREE)
    for length in (0, -1):
        with pytest.raises(GraspError, match=r"torque_length is .*; it must be above 0"):
            ResistedSet(grasp).smallest_outside(torque_length=length)
    with pytest.raises(InputError):
        ResistedSet(grasp).smallest_outside(torque_length=0.5)
    with pytest.raises(GraspError, match="takes 3"):
        ResistedSet(grasp).smallest_outside(base=(0, 1))
    with pytest.raises(GraspError, match="no proof for a whole ball"):
        ResistedSet(read_grasp("wedge")).smallest_outside()
