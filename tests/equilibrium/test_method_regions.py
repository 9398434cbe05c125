"""The regions of the methods hold exactly the wrenches that the methods accept one by one."""

from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import example, given, settings, strategies as st

from arrangement.numbers.exact import RationalVector
from equilibrium import Contact, Grasp, GraspError, read_grasp
from equilibrium.methods.compare import ask
from equilibrium.methods.friction_cones.grasp_wrench_space import GraspWrenchSpace
from equilibrium.methods.registry import METHODS, WITH_REGION, method_named
from equilibrium.wrench_sets import Region

from .strategies import grasps

HALF, STEP = Fraction(1, 2), Fraction(1, 7)


def accepts(method: str, grasp: Grasp, wrench: tuple[Fraction, ...]) -> bool | None:
    """The verdict on one wrench, by the linear programs of the methods."""
    if not method.startswith("wrench-space"):
        return ask(method, grasp, wrench)
    norm = "L1" if method.endswith("L1") else "Linf"
    least = GraspWrenchSpace(grasp, norm).verdict(wrench).least_force
    return least is not None and least <= 1


def probes(region: Region) -> list[RationalVector]:
    """Points of the plane near which the answer changes: corners, middles, and close by."""
    corners = [p for piece in region.polygons for p in piece.polyhedron.points][:5]
    corners += [(Fraction(0), Fraction(0))]
    middles = [tuple((x + y) / 2 for x, y in zip(p, q, strict=True)) for p, q in pairwise(corners)]
    steps = [(0, 0), (STEP, 0), (-STEP, STEP), (0, -STEP)]
    near = [(p[0] + a, p[1] + b) for p in corners for a, b in steps]
    return [*near, *middles]


@pytest.mark.campaign
@pytest.mark.parametrize("method", WITH_REGION)
@settings(max_examples=12)
@given(grasp=grasps(), torque=st.sampled_from([0, 0, HALF, -1]))
@example(grasp=read_grasp("paper-three-contacts-preload-1"), torque=0)
@example(grasp=read_grasp("offset-three-contacts").with_preload(1), torque=1)
@example(
    grasp=Grasp(
        [
            Contact((0, 0), (1, 0), 1, 1, 1),
            Contact((0, 0), (-1, 0), 0),
            Contact((1, 0), (0, 1), HALF, 1, 2),
        ]
    ),
    torque=0,
)
def test_region_and_single_verdicts_agree(method, grasp, torque):
    region = METHODS[method].region(grasp, origin=(0, 0, torque))
    for x, y in probes(region):
        load = (x, y, Fraction(torque))
        assert region.contains((x, y)) is accepts(method, grasp, load), load


@pytest.mark.parametrize("norm", ["L1", "Linf"])
def test_wrench_space_region_has_the_corners_of_its_slice(norm):
    grasp = read_grasp("paper-three-contacts")
    (piece,) = METHODS[f"wrench-space-{norm}"].region(grasp).polygons
    corners = GraspWrenchSpace(grasp, "L1" if norm == "L1" else "Linf").slice()
    assert set(piece.polyhedron.points) == set(corners)


def test_unknown_methods_and_too_many_contacts_are_refused():
    with pytest.raises(GraspError, match="known are complete"):
        method_named("guess")
    with pytest.raises(GraspError, match="at most 8"):
        METHODS["frictionless-slip"].region(Grasp([Contact((0, 0), (1, 0), 0)] * 9))
    with pytest.raises(GraspError, match="no region"):
        METHODS["strong"].region(Grasp())
