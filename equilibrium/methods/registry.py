"""The one table of methods. A new one is a file of its own and its name here."""

from __future__ import annotations

from arrangement.errors import refusal
from arrangement.numbers.exact import RationalVector, shown
from equilibrium.decide.as_printed import OPTIONS, solve_as_printed
from equilibrium.decide.solver import solve
from equilibrium.methods.cones import CONES
from equilibrium.methods.form_closure import FORM_CLOSURE
from equilibrium.methods.grasp_robustness import PCR, PGR
from equilibrium.methods.grasp_wrench_space import (
    WRENCH_SPACE,
    WRENCH_SPACE_L1,
    WRENCH_SPACE_LINF,
)
from equilibrium.methods.method import Method, Outcome
from equilibrium.methods.springs import FRICTIONLESS_SLIP, LINEAR_COMPLIANCE
from equilibrium.methods.weak_strong import FRICTIONLESS, STRONG, WEAK
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.contact import pyramid_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.labels import equilibria_words
from equilibrium.wrench_sets.slice import resisted_region


def _decide(grasp: Grasp, wrench: RationalVector, pyramid: int | None = None) -> Outcome:
    found = solve(grasp, wrench, pyramid=pyramid)
    if not found.decided:
        return None, f"undecided: {found.reason}"
    if grasp.dimension == 3:
        return found.stable, f"{pyramid_words(pyramid) or 'round cones'}, proved"
    if not found.lists_all():
        return True, "an equilibrium was found"
    return found.stable, equilibria_words(found.equilibria)


def _decide_assembly(assembly: Assembly, wrenches: Wrenches) -> Outcome:
    found = solve(assembly, wrenches)
    return (found.stable if found.decided else None), found.reason or "an equilibrium was found"


COMPLETE = Method(
    "complete",
    "full model (springs, cones, dissipation, detachment)",
    "full model",
    _decide,
    resisted_region,
    decide_in_space=_decide,
    decide_assembly=_decide_assembly,
)


def _decide_as_printed(grasp: Grasp, wrench: RationalVector) -> Outcome:
    return solve_as_printed(grasp, wrench, OPTIONS).stable, "all deviations of the text at once"


PRINTED = Method("printed", "the paper as printed", "the paper as printed", _decide_as_printed)

#: By key. The first one is the measure of the others.
METHODS: dict[str, Method] = {
    method.key: method
    for method in (
        COMPLETE,
        PRINTED,
        CONES,
        WRENCH_SPACE,
        WRENCH_SPACE_L1,
        WRENCH_SPACE_LINF,
        FORM_CLOSURE,
        WEAK,
        STRONG,
        FRICTIONLESS,
        LINEAR_COMPLIANCE,
        FRICTIONLESS_SLIP,
        PCR,
        PGR,
    )
}
#: The keys of the methods that have a verdict on a single wrench in the plane, in space and on an
#: assembly, and of those with a region.
DECIDING = tuple(key for key, method in METHODS.items() if method.decide is not None)
DECIDING_IN_SPACE = tuple(
    key for key, method in METHODS.items() if method.decide_in_space is not None
)
DECIDING_ASSEMBLIES = tuple(
    key for key, method in METHODS.items() if method.decide_assembly is not None
)
WITH_REGION = tuple(key for key, method in METHODS.items() if method.find_region is not None)


def method_named(key: str) -> Method:
    """Return a method by its key.

    Raises:
        GraspError: a key that is not in the table.

    >>> from equilibrium import read_grasp
    >>> method_named("weak").region(read_grasp("paper-three-contacts")).unlimited[0].whole
    True
    """
    if key not in METHODS:
        raise GraspError(str(refusal(f"method is {shown(key)}", key, METHODS)))
    return METHODS[key]
