"""The great-circle engine: central arrangements in R^3 at scale, always exact."""

from .arrangement import SphereArrangement, sphere_arrangement
from .incidence import Incidence
from .listing import list_faces

__all__ = ["Incidence", "SphereArrangement", "list_faces", "sphere_arrangement"]
