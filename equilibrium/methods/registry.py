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
from equilibrium.methods.method import BODIES, PLANE, SPACE, Method, Outcome
from equilibrium.methods.springs import FRICTIONLESS_SLIP, LINEAR_COMPLIANCE
from equilibrium.methods.weak_strong import FRICTIONLESS, STRONG, WEAK
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.contact import pyramid_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.labels import equilibria_words
from equilibrium.wrench_sets.slice import resisted_region


def _decide(
    subject: Grasp | Assembly, load: RationalVector | Wrenches, pyramid: int | None = None
) -> Outcome:
    verdict = solve(subject, load, pyramid=pyramid)
    if isinstance(subject, Assembly):
        reason = verdict.reason or "an equilibrium was found"
        return (verdict.stable if verdict.decided else None), reason
    if not verdict.decided:
        return None, f"undecided: {verdict.reason}"
    if subject.dimension == 3:
        return verdict.stable, f"{pyramid_words(pyramid) or 'round cones'}, proved"
    if not verdict.lists_all():
        return True, "an equilibrium was found"
    return verdict.stable, equilibria_words(verdict.equilibria)


COMPLETE = Method(
    "complete",
    "full model (springs, cones, dissipation, detachment)",
    "full model",
    _decide,
    resisted_region,
    (PLANE, SPACE, BODIES),
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
DECIDING, DECIDING_IN_SPACE, DECIDING_ASSEMBLIES = (
    tuple(key for key, method in METHODS.items() if method.decide and kind in method.kinds)
    for kind in (PLANE, SPACE, BODIES)
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
