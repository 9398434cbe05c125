"""The regions of the methods hold exactly the wrenches that the methods accept one by one."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import example, given, settings

from equilibrium import Contact, Grasp, GraspError, read_grasp
from equilibrium.others.compare import ask
from equilibrium.others.grasp_wrench_space import GraspWrenchSpace
from equilibrium.others.regions import FORCES, METHODS, method_region

from .strategies import grasps, wrenches

HALF = Fraction(1, 2)


def accepts(method: str, grasp: Grasp, wrench: tuple[Fraction, ...]) -> bool | None:
    """The verdict on one wrench, by the linear programs of the methods."""
    if not method.startswith("wrench-space"):
        return ask(method, grasp, wrench)
    norm = "L1" if method.endswith("L1") else "Linf"
    least = GraspWrenchSpace(grasp, norm).verdict(wrench).least_force
    return least is not None and least <= 1


@pytest.mark.parametrize("method", METHODS)
@settings(max_examples=40)
@given(grasp=grasps(), wrench=wrenches)
@example(
    grasp=Grasp([Contact((0, 0), (1, 0), 1, 1, 1), Contact((0, 0), (-1, 0), 0)]),
    wrench=(0, HALF, 0),
)
def test_region_and_single_verdicts_agree(
    method: str, grasp: Grasp, wrench: tuple[Fraction, ...]
) -> None:
    load = tuple(Fraction(x) for x in wrench)
    region = method_region(method, grasp, FORCES, (0, 0, load[2]))
    assert region.contains(load[:2]) is accepts(method, grasp, load)


@pytest.mark.parametrize("norm", ["L1", "Linf"])
def test_wrench_space_region_has_the_corners_of_its_slice(norm: str) -> None:
    grasp = read_grasp("paper-three-contacts")
    (piece,) = method_region(f"wrench-space-{norm}", grasp).polygons
    corners = GraspWrenchSpace(grasp, "L1" if norm == "L1" else "Linf").slice()
    assert set(piece.polyhedron.points) == set(corners)


def test_unknown_methods_and_too_many_contacts_are_refused() -> None:
    with pytest.raises(GraspError, match="known are complete"):
        method_region("guess", Grasp([]))
    with pytest.raises(GraspError, match="at most 6"):
        method_region("frictionless-slip", Grasp([Contact((0, 0), (1, 0), 0)] * 7))
