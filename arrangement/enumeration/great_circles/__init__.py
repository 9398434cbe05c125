"""The great-circle engine: central arrangements in R^3 at scale, always exact."""

from arrangement.enumeration.great_circles.arrangement import (
    SphereArrangement as SphereArrangement,
    list_faces as list_faces,
    sphere_arrangement as sphere_arrangement,
)
from arrangement.enumeration.great_circles.incidence import Incidence as Incidence
