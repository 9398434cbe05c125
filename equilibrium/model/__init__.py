"""Contacts and grasps, exact: what a question is made of."""

from .contact import Contact
from .errors import CertificateError, EquilibriumError, GraspError
from .grasp import Grasp, read_wrench
from .outline import Circle, Mesh, Polygon
from .unit_normal import UnitNormal, unit_normal
from .units import Units

__all__ = [
    "CertificateError",
    "Circle",
    "Contact",
    "EquilibriumError",
    "Grasp",
    "GraspError",
    "Mesh",
    "Polygon",
    "UnitNormal",
    "Units",
    "read_wrench",
    "unit_normal",
]
