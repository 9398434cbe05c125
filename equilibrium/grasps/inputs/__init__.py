"""Ways to a grasp: touching shapes, a polygon, a circle, a mesh, float data, a CSV file, at random.

Everything that had to be rounded is rounded here, once, on purpose, and the error is reported
exactly; the grasp that comes out is exact.
"""

from arrangement.numbers.exact import simplest_between as simplest_between

from .conversion import (
    ContactIncidence as ContactIncidence,
    Conversion as Conversion,
    snapped as snapped,
)
from .csv_file import read_bodies as read_bodies, read_csv as read_csv
from .documents import read_any as read_any
from .floats import from_float_data as from_float_data, read_float_data as read_float_data
from .mesh import on_mesh as on_mesh
from .polygon import (
    OnEdge as OnEdge,
    from_polygon as from_polygon,
    on_circle as on_circle,
    read_polygon as read_polygon,
)
from .random import (
    random_grasp as random_grasp,
    random_wrench as random_wrench,
    star_outline as star_outline,
)
from .shapes import read_shapes as read_shapes
