"""Ways to a grasp: from a polygon, a circle, a mesh, float data, a CSV file, or at random.

Everything that had to be rounded is rounded here, once, on purpose, and the error is reported
exactly; the grasp that comes out is exact.
"""

from .conversion import ContactIncidence, Conversion, simplest_between, snapped
from .csv_file import read_csv
from .documents import read_any
from .floats import from_float_data, read_float_data
from .mesh import on_mesh
from .polygon import OnEdge, from_polygon, on_circle, read_polygon
from .random import random_grasp, random_wrench, star_outline

__all__ = [
    "ContactIncidence",
    "Conversion",
    "OnEdge",
    "from_float_data",
    "from_polygon",
    "on_circle",
    "on_mesh",
    "random_grasp",
    "random_wrench",
    "read_any",
    "read_csv",
    "read_float_data",
    "read_polygon",
    "simplest_between",
    "snapped",
    "star_outline",
]
