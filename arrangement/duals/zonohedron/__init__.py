"""The dual of an arrangement of central planes: a zonohedron, a polygon or a segment.

The dual has a vertex for each region, an edge for each facet and, in rank 3, a polygon for each
ray of the arrangement. With the segments ``[-g_i, g_i]`` along the normals as generators it is
the zonotope ``sum_i [-g_i, g_i]``, whose vertex for the region of sign vector s is
``sum_i s_i g_i`` ([Ziegler1995], section 7.3). So it is convex by construction.

Rooms: `generators`, `polyhedron` (rank 3), `flat` (ranks 2 and 1), `incidence` (what the enumerator
hands over), `validate` (the exact check), `mesh` (trimesh, files).
"""

from .flat import (
    DualPolygon as DualPolygon,
    DualSegment as DualSegment,
    dual_polygon as dual_polygon,
    dual_segment as dual_segment,
)
from .polyhedron import (
    DualPolyhedron as DualPolyhedron,
    dual_polyhedron as dual_polyhedron,
    dual_zonotope as dual_zonotope,
)
