"""The other methods on the paper's two grasps: what the paper says of each, and known values."""

from fractions import Fraction

import pytest

from equilibrium.grasps.files import read_grasp
from equilibrium.methods.contact_laws.frictionless_slip import frictionless_slip
from equilibrium.methods.contact_laws.linear_compliance import linear_compliance
from equilibrium.methods.contact_laws.springs import balancing_friction
from equilibrium.methods.friction_cones.cones import cones
from equilibrium.methods.friction_cones.form_closure import form_closure
from equilibrium.methods.friction_cones.grasp_wrench_space import GraspWrenchSpace
from equilibrium.methods.friction_cones.weak_strong import weak_strong
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

HALF = Fraction(1, 2)
PLANE = [(0, 1, 0), (1, 1, 0), (-3, 7, 0), (0, -5, 0)]


@pytest.fixture
def three():
    return read_grasp("paper-three-contacts")


@pytest.fixture
def four():
    return read_grasp("paper-four-contacts")


def square(friction=0):
    """Eight frictionless fingers, two on each side of a square: form closure."""
    places = [((side, s * HALF), (-side, 0)) for side in (1, -1) for s in (1, -1)]
    places += [((s * HALF, side), (0, -side)) for side in (1, -1) for s in (1, -1)]
    return Grasp(Contact(point, normal, friction) for point, normal in places)


class TestGraspWrenchSpace:
    """Section VI: contact forces exist for all forces in the plane, preload or not."""

    @pytest.mark.parametrize("wrench", PLANE)
    def test_resists_arbitrary_forces_without_preload(self, three, wrench):
        assert GraspWrenchSpace(three).verdict(wrench).accepts

    def test_preload_and_stiffness_change_nothing(self, three):
        assert GraspWrenchSpace(three.with_preload(1)).polytope == GraspWrenchSpace(three).polytope

    def test_slice_of_the_figure(self, three):
        # Upwards the side contacts give 1/2 with total normal force 1; downwards contact 2 gives 1.
        corners = GraspWrenchSpace(three).slice()
        assert max(v for _, v in corners) == HALF
        assert min(v for _, v in corners) == -1
        assert {u for u, v in corners if v == 0} == {-1, 1}

    def test_least_force_up_is_two_and_down_is_one(self, three):
        space = GraspWrenchSpace(three)
        assert space.verdict((0, 1, 0)).least_force == 2
        assert space.verdict((0, -1, 0)).least_force == 1
        assert GraspWrenchSpace(three, "Linf").verdict((0, 1, 0)).least_force == 1

    def test_volume_of_a_double_pyramid(self):
        # Cone edges of contacts at (+-1, 0), friction 1: (1, 1, -1), (1, -1, 1) and (-1, -1, -1),
        # (-1, 1, 1), a regular tetrahedron of edge 2 sqrt 2: volume 8/3, inscribed radius 1/sqrt 3.
        squeeze = read_grasp("opposed-contacts")
        space = GraspWrenchSpace(squeeze)
        assert space.volume == Fraction(8, 3)
        assert space.epsilon_squared == Fraction(1, 3)
        assert GraspWrenchSpace(squeeze, length=2).volume == Fraction(4, 3)

    def test_two_frictionless_fingers_have_no_force_closure(self):
        space = GraspWrenchSpace(read_grasp("frictionless-opposed-contacts"))
        assert not space.force_closure
        assert (space.volume, space.epsilon_squared) == (0, 0)
        assert space.polytope.dimension == 1
        assert space.slice() == ((-1, 0), (1, 0))

    def test_no_contacts(self):
        space = GraspWrenchSpace(Grasp())
        assert space.verdict((0, 0, 0)).accepts
        assert not space.verdict((0, 0, 1)).accepts

    @pytest.mark.parametrize("options", [{"norm": "L2"}, {"length": 0}, {"length": 0.5}])
    def test_bad_options_are_refused(self, three, options):
        with pytest.raises(ValueError, match=r"norm|length"):
            GraspWrenchSpace(three, **options)

    def test_a_slice_needs_a_plane(self, three):
        with pytest.raises(GraspError, match="parallel"):
            GraspWrenchSpace(three).slice(first=(1, 0, 0), second=(2, 0, 0))


class TestFormClosure:
    def test_the_papers_grasps_have_none(self, three, four):
        for grasp in (three, four):
            assert form_closure(grasp).accepts is None
            assert form_closure(grasp, friction=True).accepts

    def test_eight_fingers_round_a_square(self):
        assert form_closure(square()).accepts

    def test_three_contacts_never_suffice_in_the_plane(self, three):
        # Markenscoff, Ni, Papadimitriou 1990: four are needed.
        assert form_closure(Grasp(square().contacts[:3])).accepts is None


class TestLinearCompliance:
    """Section III: the pushed object drags the side contacts out of their cones."""

    def test_wrongly_refuses_a_push_onto_a_contact(self, three):
        verdict = linear_compliance(three, (0, -1, 0))
        assert not verdict.accepts
        assert verdict.outside == (0, 2)
        # Springs of stiffness 1 in parallel, two tangential and one normal: a third each.
        assert verdict.motion == (0, Fraction(-1, 3), 0)

    def test_refuses_whatever_the_tangential_stiffness(self, three):
        for factor in ("1/1000", 1, 1000):
            assert not linear_compliance(three, (0, -1, 0), tangential_stiffness=factor).accepts

    def test_preloaded_grasp_at_rest(self, three):
        loaded = three.with_preload(1)
        verdict = linear_compliance(loaded, (0, 0, 0), rest_friction=balancing_friction(loaded))
        assert verdict.motion == (0, 0, 0)
        assert verdict.forces == ((1, -HALF), (1, 0), (1, HALF))

    def test_one_contact_cannot_balance_a_torque(self):
        verdict = linear_compliance(Grasp([Contact((0, 0), (0, 1), 1)]), (0, 0, 1))
        assert (verdict.accepts, verdict.motion) == (False, None)


class TestFrictionlessSlip:
    """Section VI: better than linear compliance, and still too conservative."""

    @pytest.mark.parametrize("wrench", [(0, -1, 0), (0, -100, 0), (3, -1, 0), (-7, 0, 0)])
    def test_accepts_forces_that_do_not_pull_out(self, three, wrench):
        assert frictionless_slip(three, wrench).accepts

    def test_side_contacts_carry_nothing_under_a_push(self, three):
        verdict = frictionless_slip(three, (0, -2, 0))
        assert verdict.forces == ((0, 0), (2, 0), (0, 0))

    def test_no_choice_of_states_holds_the_preloaded_grasp(self, three):
        loaded = three.with_preload(1)
        rest = balancing_friction(loaded)
        assert rest == (-HALF, 0, HALF)  # the paper: on the edge of the cones
        for factor in ("1/100", 1, 100):
            verdict = frictionless_slip(
                loaded, (0, 1, 0), rest_friction=rest, tangential_stiffness=factor
            )
            assert not verdict.accepts
            assert verdict.tried == 27

    def test_the_refusal_needs_that_a_pressed_contact_is_not_detached(self, three):
        loaded = three.with_preload(1)
        rest = balancing_friction(loaded)
        assert frictionless_slip(loaded, (0, 1, 0), rest_friction=rest, gap=False).accepts

    def test_without_friction_at_rest_soft_tangential_springs_hold(self, three):
        loaded = three.with_preload(1)
        assert not frictionless_slip(loaded, (0, 1, 0)).accepts
        assert frictionless_slip(loaded, (0, 1, 0), tangential_stiffness=HALF).accepts

    def test_many_contacts_are_refused(self):
        with pytest.raises(GraspError, match="too many"):
            frictionless_slip(Grasp([Contact((0, 0), (1, 0), 1)] * 13), (0, 0, 0))


class TestCones:
    """Section III: without dissipation an arbitrary wrench is resisted (four-contact grasp)."""

    @pytest.mark.parametrize("wrench", [(0, 2, 0), (0, -200, 0), (5, 3, -1)])
    def test_accepts_everything_with_friction_above_one(self, four, wrench):
        assert cones(four.with_friction(2), wrench).accepts
        assert cones(four.with_friction("101/100"), wrench).accepts

    @pytest.mark.parametrize("friction", [HALF, 1])
    def test_the_statement_fails_up_to_friction_one(self, four, friction):
        # A turn loads two opposite contacts with c each, whose normal forces have the torque -2 c
        # and whose friction has at most 2 mu c: nothing is left against (0, w, 0).
        verdict = cones(four.with_friction(friction), (0, 2, 0))
        assert not verdict.accepts
        # All sign choices of two pairs of parallel planes.
        assert verdict.tried == 4

    def test_springs_that_cannot_let_go_refuse_all_loads_on_the_four_contacts(self, four):
        assert not cones(four.with_friction(2), (0, 2, 0), printed=True).accepts
        assert cones(four, (0, 0, 3)).accepts
        assert not cones(four, (0, 0, 3), printed=True).accepts

    def test_cones_alone_balance_every_load_on_the_four_contacts(self, four):
        # Eqs. 1 to 3, without springs.
        for wrench in ((0, 2, 0), (0, -200, 0), (5, 3, -1)):
            assert weak_strong(four, wrench).weak


class TestWeakStrong:
    def test_three_contacts(self, three):
        up, down = weak_strong(three, (0, 1, 0)), weak_strong(three, (0, -1, 0))
        assert (up.weak, up.strong, up.frictionless) == (True, False, False)
        assert (down.weak, down.strong, down.frictionless) == (True, True, True)
        assert up.acceleration == (0, 1, 0)  # nothing presses, so nothing brakes

    def test_block_on_a_slope_is_strong_but_not_frictionless(self):
        # Slope 3/4: friction 1 holds the block however it starts; friction 1/2 does not.
        feet = [(Fraction(x) * 4 / 5, Fraction(x) * 3 / 5) for x in (-1, 1)]
        normal = (Fraction(-3, 5), Fraction(4, 5))
        gravity = (0, -1, 0)
        rough, smooth = (Grasp(Contact(p, normal, mu) for p in feet) for mu in (1, HALF))
        held, sliding = weak_strong(rough, gravity), weak_strong(smooth, gravity)
        assert (held.weak, held.strong, held.frictionless) == (True, True, False)
        assert not sliding.weak

    def test_mass_must_be_positive(self, three):
        with pytest.raises(GraspError, match="mass"):
            weak_strong(three, (0, 1, 0), mass=0)
