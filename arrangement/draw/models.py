"""Models to hold, as the bytes of STL, GLB and OBJ files."""

from __future__ import annotations

from arrangement.dual import dual_polyhedron
from arrangement.dual.mesh import content
from arrangement.planes import Arrangement

from .output import millimetres


def dual_model(arrangement: Arrangement, suffix: str, *, size: object = 60) -> bytes:
    """Return the dual polyhedron as a file; see `DualPolyhedron.export`.

    Args:
        arrangement: central, in R^3, of rank 3.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        size: the largest side of the bounding box, in millimetres.
    """
    return content(dual_polyhedron(arrangement), suffix, millimetres(size, "size"))
