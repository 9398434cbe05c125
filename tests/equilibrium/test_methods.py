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
THREE, FOUR = read_grasp("paper-three-contacts"), read_grasp("paper-four-contacts")
LOADED = THREE.with_preload(1)
#: On the edge of the cones, as the paper says.
REST = {"rest_friction": (-HALF, 0, HALF)}


def wrench_space(grasp, wrench):
    return GraspWrenchSpace(grasp).verdict(wrench)


@pytest.mark.parametrize(
    ("method", "grasp", "wrenches", "options", "accepts"),
    [
        # Section VI: contact forces exist for all forces in the plane, preload or not.
        (wrench_space, THREE, [(0, 1, 0), (1, 1, 0), (-3, 7, 0), (0, -5, 0)], {}, True),
        (wrench_space, Grasp(), [(0, 0, 0)], {}, True),
        (wrench_space, Grasp(), [(0, 0, 1)], {}, False),
        # Section III: the pushed object drags the side contacts out of their cones.
        *(
            (linear_compliance, THREE, [(0, -1, 0)], {"tangential_stiffness": k}, False)
            for k in ("1/1000", 1, 1000)
        ),
        # Section VI: better than linear compliance, and still too conservative.
        (
            frictionless_slip,
            THREE,
            [(0, -1, 0), (0, -100, 0), (3, -1, 0), (-7, 0, 0)],
            {},
            True,
        ),
        # The refusal of the preloaded grasp needs that a pressed contact is not detached.
        (frictionless_slip, LOADED, [(0, 1, 0)], {**REST, "gap": False}, True),
        # Without friction at rest soft tangential springs hold.
        (frictionless_slip, LOADED, [(0, 1, 0)], {}, False),
        (frictionless_slip, LOADED, [(0, 1, 0)], {"tangential_stiffness": HALF}, True),
        # Section III: without dissipation an arbitrary wrench is resisted, with friction above 1.
        *(
            (cones, FOUR.with_friction(mu), [(0, 2, 0), (0, -200, 0), (5, 3, -1)], {}, True)
            for mu in (2, "101/100")
        ),
        # Springs that cannot let go refuse all loads.
        (cones, FOUR.with_friction(2), [(0, 2, 0)], {"printed": True}, False),
        (cones, FOUR, [(0, 0, 3)], {}, True),
        (cones, FOUR, [(0, 0, 3)], {"printed": True}, False),
    ],
)
def test_known_verdicts(method, grasp, wrenches, options, accepts):
    for wrench in wrenches:
        assert method(grasp, wrench, **options).accepts is accepts


def square(friction=0):
    """Eight frictionless fingers, two on each side of a square: form closure."""
    places = [((side, s * HALF), (-side, 0)) for side in (1, -1) for s in (1, -1)]
    places += [((s * HALF, side), (0, -side)) for side in (1, -1) for s in (1, -1)]
    return Grasp(Contact(point, normal, friction) for point, normal in places)


class TestGraspWrenchSpace:
    def test_preload_and_stiffness_change_nothing(self):
        assert GraspWrenchSpace(THREE.with_preload(1)).polytope == GraspWrenchSpace(THREE).polytope

    def test_slice_of_the_figure(self):
        # Upwards the side contacts give 1/2 with total normal force 1; downwards contact 2 gives 1.
        corners = GraspWrenchSpace(THREE).slice()
        assert max(v for _, v in corners) == HALF
        assert min(v for _, v in corners) == -1
        assert {u for u, v in corners if v == 0} == {-1, 1}

    def test_least_force_up_is_two_and_down_is_one(self):
        space = GraspWrenchSpace(THREE)
        assert space.verdict((0, 1, 0)).least_force == 2
        assert space.verdict((0, -1, 0)).least_force == 1
        assert GraspWrenchSpace(THREE, "Linf").verdict((0, 1, 0)).least_force == 1

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

    @pytest.mark.parametrize("options", [{"norm": "L2"}, {"length": 0}, {"length": 0.5}])
    def test_bad_options_are_refused(self, options):
        with pytest.raises(ValueError, match=r"norm|length"):
            GraspWrenchSpace(THREE, **options)

    def test_a_slice_needs_a_plane(self):
        with pytest.raises(GraspError, match="parallel"):
            GraspWrenchSpace(THREE).slice(first=(1, 0, 0), second=(2, 0, 0))


def test_form_closure():
    for grasp in (THREE, FOUR):
        assert form_closure(grasp).accepts is None
        assert form_closure(grasp, friction=True).accepts
    assert form_closure(square()).accepts
    # Markenscoff, Ni, Papadimitriou 1990: four are needed.
    assert form_closure(Grasp(square().contacts[:3])).accepts is None


def test_linear_compliance_tells_motion_and_what_leaves_its_cone():
    verdict = linear_compliance(THREE, (0, -1, 0))
    # Springs of stiffness 1 in parallel, two tangential and one normal: a third each.
    assert (verdict.outside, verdict.motion) == ((0, 2), (0, Fraction(-1, 3), 0))
    assert balancing_friction(LOADED) == REST["rest_friction"]
    verdict = linear_compliance(LOADED, (0, 0, 0), **REST)
    assert verdict.motion == (0, 0, 0)
    assert verdict.forces == ((1, -HALF), (1, 0), (1, HALF))
    # One contact cannot balance a torque.
    verdict = linear_compliance(Grasp([Contact((0, 0), (0, 1), 1)]), (0, 0, 1))
    assert (verdict.accepts, verdict.motion) == (False, None)


def test_frictionless_slip_tries_all_states():
    assert frictionless_slip(THREE, (0, -2, 0)).forces == ((0, 0), (2, 0), (0, 0))
    for factor in ("1/100", 1, 100):
        verdict = frictionless_slip(LOADED, (0, 1, 0), tangential_stiffness=factor, **REST)
        assert (verdict.accepts, verdict.tried) == (False, 27)
    with pytest.raises(GraspError, match="too many"):
        frictionless_slip(Grasp([Contact((0, 0), (1, 0), 1)] * 13), (0, 0, 0))


@pytest.mark.parametrize("friction", [HALF, 1])
def test_cones_alone_need_friction_above_one(friction):
    # A turn loads two opposite contacts with c each, whose normal forces have the torque -2 c
    # and whose friction has at most 2 mu c: nothing is left against (0, w, 0).
    verdict = cones(FOUR.with_friction(friction), (0, 2, 0))
    # All sign choices of two pairs of parallel planes.
    assert (verdict.accepts, verdict.tried) == (False, 4)


class TestWeakStrong:
    def test_without_springs_every_load_is_balanced(self):
        for wrench in ((0, 2, 0), (0, -200, 0), (5, 3, -1)):
            assert weak_strong(FOUR, wrench).weak

    def test_three_contacts(self):
        up, down = weak_strong(THREE, (0, 1, 0)), weak_strong(THREE, (0, -1, 0))
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

    def test_mass_must_be_positive(self):
        with pytest.raises(GraspError, match="mass"):
            weak_strong(THREE, (0, 1, 0), mass=0)
