"""The great-circle engine: central arrangements in R^3 at scale, always exact."""

from .arrangement import (
    SphereArrangement as SphereArrangement,
    list_faces as list_faces,
    sphere_arrangement as sphere_arrangement,
)
from .incidence import Incidence as Incidence
