from . import pictures as pictures
from .certificate.document import Certificate as Certificate
from .certificate.report import Report as Report
from .decide.many_grasps.check import CheckedGrasps as CheckedGrasps, check_grasps as check_grasps
from .decide.solver import solve as solve, solve_many as solve_many
from .decide.verdict import Verdict as Verdict
from .grasps import inputs as inputs
from .grasps.files import read_certificate as read_certificate, verify as verify
from .grasps.inputs.documents import read_assembly as read_assembly, read_grasp as read_grasp
from .methods.compare import compare as compare
from .methods.grasp_wrench_space import GraspWrenchSpace as GraspWrenchSpace
from .model.assembly import Assembly as Assembly, BodyContact as BodyContact, RigidBody as RigidBody
from .model.contact import Contact as Contact
from .model.errors import (
    CertificateError as CertificateError,
    EquilibriumError as EquilibriumError,
    GraspError as GraspError,
    TimeLimitError as TimeLimitError,
)
from .model.grasp import Grasp as Grasp
from .model.labels import Units as Units
from .model.outline import (
    Circle as Circle,
    Mesh as Mesh,
    Polygon as Polygon,
    Segments as Segments,
    Sphere as Sphere,
)
from .model.solution import Solution as Solution
from .model.unit_normal import UnitNormal as UnitNormal, unit_normal as unit_normal
from .modes import ContactModes as ContactModes
from .plane.states.equilibrium import Equilibrium as Equilibrium
from .wrench_sets.parameter import (
    ResistedValues as ResistedValues,
    resisted_values as resisted_values,
)
from .wrench_sets.resisted_set import ResistedSet as ResistedSet
from .wrench_sets.sufficient_friction import (
    SufficientFriction as SufficientFriction,
    sufficient_friction as sufficient_friction,
)

__version__: str
