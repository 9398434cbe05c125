from . import methods as methods, wrench_sets as wrench_sets
from .certificate.checker import Report as Report, check as check
from .certificate.document import Certificate as Certificate
from .decide.solver import Solver as Solver, solve as solve
from .decide.verdict import Verdict as Verdict
from .grasps import inputs as inputs
from .grasps.files import (
    read_certificate as read_certificate,
    read_grasp as read_grasp,
    verify as verify,
    write_certificate as write_certificate,
)
from .methods.printed_model import (
    LiteralVerdict as LiteralVerdict,
    solve_literal as solve_literal,
)
from .model.contact import Contact as Contact
from .model.errors import (
    CertificateError as CertificateError,
    EquilibriumError as EquilibriumError,
    GraspError as GraspError,
    TimeLimitError as TimeLimitError,
)
from .model.grasp import Grasp as Grasp
from .model.labels import Units as Units
from .model.outline import Circle as Circle, Mesh as Mesh, Polygon as Polygon
from .model.solution import Solution as Solution
from .model.unit_normal import UnitNormal as UnitNormal, unit_normal as unit_normal
from .modes import ContactModes as ContactModes, Mode as Mode
from .plane.states.contact_states import contact_states as contact_states
from .plane.states.equilibrium import Equilibrium as Equilibrium
from .wrench_sets import (
    check_loads as check_loads,
    least_friction as least_friction,
    margin as margin,
    resisted_magnitudes as resisted_magnitudes,
    resisted_region as resisted_region,
    resisted_set as resisted_set,
    smallest_unresisted_wrench as smallest_unresisted_wrench,
)

__version__: str
