from . import inputs as inputs, limits as limits, others as others
from .cells import contact_states as contact_states
from .certificate import Certificate as Certificate
from .checker import Report as Report, check as check
from .errors import (
    CertificateError as CertificateError,
    EquilibriumError as EquilibriumError,
    GraspError as GraspError,
)
from .files import (
    read_certificate as read_certificate,
    read_grasp as read_grasp,
    verify as verify,
    write_certificate as write_certificate,
)
from .grasp import Contact as Contact, Grasp as Grasp
from .literal import LiteralVerdict as LiteralVerdict, solve_literal as solve_literal
from .measures import Units as Units
from .passive import Solution as Solution, Verdict as Verdict, solve as solve
from .pieces import Equilibrium as Equilibrium
from .units import UnitNormal as UnitNormal, unit_normal as unit_normal

__version__: str
