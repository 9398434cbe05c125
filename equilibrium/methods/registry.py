"""The one table of methods. A new one is a file of its own and its name here."""

from __future__ import annotations

from arrangement.errors import refusal
from arrangement.numbers.exact import shown
from equilibrium.model.errors import GraspError

from .contact_laws.complete import COMPLETE
from .contact_laws.frictionless_slip import FRICTIONLESS_SLIP
from .contact_laws.linear_compliance import LINEAR_COMPLIANCE
from .contact_laws.printed_model import PRINTED
from .friction_cones.cones import CONES
from .friction_cones.form_closure import FORM_CLOSURE
from .friction_cones.grasp_wrench_space import WRENCH_SPACE, WRENCH_SPACE_L1, WRENCH_SPACE_LINF
from .friction_cones.weak_strong import FRICTIONLESS, STRONG, WEAK
from .method import Method

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
    )
}
#: The keys of the methods that have a verdict on a single wrench, in the plane and in space, and of
#: those with a region.
DECIDING = tuple(key for key, method in METHODS.items() if method.decide is not None)
DECIDING_IN_SPACE = tuple(
    key for key, method in METHODS.items() if method.decide_in_space is not None
)
WITH_REGION = tuple(key for key, method in METHODS.items() if method.find_region is not None)


def method_named(key: str) -> Method:
    """Return a method by its key.

    Raises:
        GraspError: a key that is not in the table.

    >>> from equilibrium.grasps.files import read_grasp
    >>> method_named("weak").region(read_grasp("paper-three-contacts")).unlimited[0].whole
    True
    """
    if key not in METHODS:
        raise GraspError(str(refusal(f"method is {shown(key)}", key, METHODS)))
    return METHODS[key]
