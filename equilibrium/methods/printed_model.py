"""The paper as printed, with all its deviations from the full model at once, as a method."""

from __future__ import annotations

from arrangement.numbers.exact import RationalVector
from equilibrium.decide.as_printed import OPTIONS, solve_as_printed
from equilibrium.methods.method import Method, Outcome
from equilibrium.model.grasp import Grasp


def _decide(grasp: Grasp, wrench: RationalVector) -> Outcome:
    return solve_as_printed(grasp, wrench, OPTIONS).stable, "all deviations of the text at once"


PRINTED = Method("printed", "the paper as printed", "the paper as printed", _decide)
