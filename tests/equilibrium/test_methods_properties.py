"""Properties of the other methods, and oracles that share no code with them."""

from itertools import product

import numpy as np
from hypothesis import assume, given, strategies as st
from scipy.optimize import linprog

from arrangement.numbers.exact import dot
from equilibrium.core.contact_rows import friction_edges
from equilibrium.decide.solver import solve
from equilibrium.methods.cones import cones
from equilibrium.methods.force_closure import force_closure
from equilibrium.methods.form_closure import form_closure
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace, _hull
from equilibrium.methods.springs import frictionless_slip, linear_compliance
from equilibrium.methods.weak_strong import mass_matrix, weak_strong
from proofs_check.routes.oracle import Systems, project

from .oracle import asked
from .strategies import (
    directions,
    form_closures,
    loads as wrenches,
    pinches,
    resisted,
    small,
    wide_grasps as grasps,
)

points = st.lists(st.tuples(small, small, small), min_size=1, max_size=14)


def balances(grasp, forces, wrench):
    return all(
        sum(
            n * c.normal_wrench[k] + t * c.tangential_wrench[k]
            for c, (n, t) in zip(grasp, forces, strict=True)
        )
        + wrench[k]
        == 0
        for k in range(3)
    )


def in_cones(grasp, forces):
    return all(n >= 0 and abs(t) <= c.friction * n for c, (n, t) in zip(grasp, forces, strict=True))


class TestHull:
    @given(points)
    def test_every_facet_supports_and_every_vertex_is_extreme(self, cloud):
        hull = _hull(cloud)
        assert set(hull.points) <= set(cloud)
        for row in hull.inequalities:
            assert min(dot(row, (*p, 1)) for p in cloud) == 0
        rank = np.linalg.matrix_rank(np.array(cloud) - np.array(cloud[0]))
        assert hull.dimension == rank
        # An extreme point is not a convex combination of the other points (scipy as oracle).
        for p in set(cloud):
            others = [q for q in set(cloud) if q != p]
            rows = np.vstack([np.array(others, dtype=float).reshape(-1, 3).T, np.ones(len(others))])
            inside = others and linprog(np.zeros(len(others)), A_eq=rows, b_eq=[*p, 1]).status == 0
            assert (p in hull.points) == (not inside)


class TestWrenchSpace:
    @given(grasps(), wrenches)
    def test_membership_by_program_is_membership_in_the_hull(self, grasp, wrench):
        for norm in ("L1", "Linf"):
            space = GraspWrenchSpace(grasp, norm)
            verdict = space.verdict(wrench)
            inside = space.polytope.contains([-x for x in wrench])
            assert inside == (verdict.accepts and verdict.least_force <= 1)
            assert inside == space.resisted.contains(wrench)
            if verdict.accepts:
                assert balances(grasp, verdict.forces, wrench)
                assert in_cones(grasp, verdict.forces)
                total = [n for n, _ in verdict.forces]
                assert verdict.least_force == (sum(total) if norm == "L1" else max(total))
            else:
                motion = verdict.separating_motion
                assert dot(motion, wrench) == 1
                assert all(dot(motion, e) >= 0 for c in grasp for e in friction_edges(c))

    @given(grasps())
    def test_hull_is_the_brute_force_sum(self, grasp):
        corners = [
            [tuple(map(sum, zip(*choice, strict=True)))]
            for choice in product(*[((0, 0, 0), *friction_edges(c)) for c in grasp])
        ]
        assert GraspWrenchSpace(grasp, "Linf").polytope == _hull(p for (p,) in corners)

    @given(grasps())
    def test_force_closure_has_four_equal_tests(self, grasp):
        expected = force_closure(grasp).accepts
        assert GraspWrenchSpace(grasp).surrounds_origin == expected
        assert GraspWrenchSpace(grasp, "Linf").surrounds_origin == expected
        assert (form_closure(grasp, friction=True).accepts is True) == expected
        units = [tuple(s * (i == k) for i in range(3)) for k in range(3) for s in (1, -1)]
        space = GraspWrenchSpace(grasp)
        assert all(space.verdict(w).accepts for w in units) == expected


class TestFormClosure:
    @given(form_closures())
    def test_form_closure_has_its_proof(self, grasp):
        found = form_closure(grasp)
        normals = [c.normal_wrench for c in grasp]
        assert found.accepts
        assert min(found.multipliers) >= 1
        total = [
            sum(x * w[k] for x, w in zip(found.multipliers, normals, strict=True)) for k in range(3)
        ]
        assert total == [0, 0, 0]
        assert np.linalg.matrix_rank(np.array(normals, dtype=float)) == 3

    @given(grasps(most=6, friction=st.just(0)))
    def test_each_answer_has_its_proof(self, grasp):
        found = form_closure(grasp)
        normals = [c.normal_wrench for c in grasp]
        if found.accepts:
            assert min(found.multipliers) >= 1
        else:
            assert any(found.free_motion)
            assert all(dot(w, found.free_motion) >= 0 for w in normals)

    @given(form_closures(), wrenches)
    def test_form_closure_holds_every_wrench_in_the_full_model(self, grasp, wrench):
        # A turn or shift presses some spring, so d . F(d) grows without bound: a zero exists.
        assert form_closure(grasp).accepts
        assert solve(grasp, wrench).stable


class TestOrderOfTheMethods:
    @given(grasps(most=3), wrenches)
    def test_each_weaker_method_accepts_too(self, grasp, wrench):
        ours = solve(grasp, wrench).stable
        compliance = linear_compliance(grasp, wrench).accepts
        slip = frictionless_slip(grasp, wrench).accepts
        loose = cones(grasp, wrench).accepts
        load = weak_strong(grasp, wrench)
        assert compliance <= slip <= loose
        assert ours <= loose <= load.weak
        assert load.frictionless <= load.strong <= load.weak
        assert load.weak == GraspWrenchSpace(grasp).verdict(wrench).accepts
        assert cones(grasp, wrench, printed=True).accepts <= loose

    @given(grasps(most=3, friction=st.just(0)), wrenches)
    def test_without_friction_the_spring_models_agree(self, grasp, wrench):
        ours = solve(grasp, wrench).stable
        assert frictionless_slip(grasp, wrench).accepts == ours
        assert cones(grasp, wrench).accepts == ours

    @given(resisted(grasps(most=3)))
    def test_accepted_forces_balance_inside_the_cones(self, question):
        grasp, wrench = question
        verdicts = [f(grasp, wrench) for f in (linear_compliance, frictionless_slip, cones)]
        assert verdicts[-1].accepts
        for verdict in filter(None, verdicts):
            assert balances(grasp, verdict.forces, wrench)
            assert in_cones(grasp, verdict.forces)


def cones_by_brute_force(grasp, wrench):
    """Try all 2^m sets of attached contacts; what slips may have any friction inside its cone."""
    systems, m = Systems(asked(grasp, wrench)), len(grasp)
    for states in product(("detached", "stick"), repeat=m):
        equal, least = systems.rows(states)
        apart = [row for row, state in zip(equal, states, strict=False) if state == "detached"]
        if project([*apart, *equal[m:]], least, keep=-1) is not None:
            return True
    return False


@given(grasps(most=3), wrenches)
def test_cones_agree_with_brute_force(grasp, wrench):
    assert cones(grasp, wrench).accepts == cones_by_brute_force(grasp, wrench)


class TestStrongStability:
    @given(pinches(), directions, st.integers(1, 3), st.tuples(small, small))
    def test_a_start_obeys_the_energy_balance(self, grasp, wrench, inertia, centre):
        found = weak_strong(grasp, wrench, inertia=inertia, centre=centre)
        assert found.weak
        a = found.acceleration
        assume(a is not None)
        assert any(a)
        assert all(dot(c.normal_wrench, a) >= 0 for c in grasp)
        matrix = mass_matrix(1, inertia, centre)
        kinetic = dot(a, [dot(row, a) for row in matrix])
        assert 0 < kinetic <= dot(wrench, a)  # friction only brakes
