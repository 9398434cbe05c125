"""Contacts and grasps, exact: what a question is made of."""

from .contact import Contact as Contact
from .errors import (
    CertificateError as CertificateError,
    EquilibriumError as EquilibriumError,
    GraspError as GraspError,
)
from .grasp import Grasp as Grasp, read_wrench as read_wrench
from .outline import Circle as Circle, Mesh as Mesh, Polygon as Polygon
from .unit_normal import UnitNormal as UnitNormal, unit_normal as unit_normal
from .units import Units as Units
