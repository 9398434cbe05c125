"""The complete model: springs, cones, dissipation, detachment. The measure of the others."""

from __future__ import annotations

from arrangement.numbers.exact import RationalVector
from equilibrium.decide.spatial_verdict import solve_in_space
from equilibrium.decide.verdict import Solver
from equilibrium.methods.method import Method, Outcome
from equilibrium.model.contact import pyramid_words
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.plane import resisted_region


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    found = Solver(grasp).solve(wrench)
    if not found.lists_all():
        return True, "an equilibrium was found"
    return found.stable, f"{len(found.equilibria)} maximal pieces of solutions"


def _decide_in_space(grasp: Grasp, wrench: RationalVector, pyramid: int | None) -> Outcome:
    found = solve_in_space(grasp, wrench, pyramid=pyramid)
    if not found.decided:
        return None, f"undecided: {found.reason}"
    return found.stable, f"{pyramid_words(pyramid) or 'round cones'}, proved"


COMPLETE = Method(
    "complete",
    "complete model (springs, cones, dissipation, detachment)",
    "complete model",
    _decide,
    resisted_region,
    decide_in_space=_decide_in_space,
)
