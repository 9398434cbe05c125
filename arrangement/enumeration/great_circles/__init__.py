"""The great-circle engine: central arrangements in R^3 at scale, always exact."""

from .arrangement import SphereArrangement, sphere_arrangement
from .incidence import Incidence

__all__ = ["Incidence", "SphereArrangement", "sphere_arrangement"]
