"""Dual polyhedra as triangle meshes and model files. Here, and only here, they become floats."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from arrangement.errors import ArrangementError, InputError
from arrangement.exact import shown
from arrangement.writing import write_bytes_atomically

if TYPE_CHECKING:
    from .polyhedron import DualPolyhedron

Floats = npt.NDArray[np.float64]


def coordinates(dual: DualPolyhedron, size: float | None) -> Floats:
    """Return the vertices as floats, (V, 3); with a size, the largest side of the box is `size`.

    Scaling is by a ratio of integers, correctly rounded for numbers of any length.
    """
    if size is not None and not (
        isinstance(size, (int, float)) and math.isfinite(size) and size > 0
    ):
        raise InputError(f"size is {shown(size)}; give a positive number of millimetres")
    columns = list(zip(*dual.integer_vertices, strict=True))
    if size is None:
        d = dual.generators.denominator
        return np.array([[x / d for x in v] for v in dual.integer_vertices])
    largest = max(max(column) - min(column) for column in columns)
    return np.array([[x / largest for x in v] for v in dual.integer_vertices]) * float(size)


def as_trimesh(dual: DualPolyhedron, size: float | None, single: bool = False) -> Any:
    """Return the mesh; see `DualPolyhedron.to_trimesh`. `single` tests in single precision."""
    import trimesh

    points = coordinates(dual, size)
    stored = points.astype(np.float32) if single else points
    if len(np.unique(stored, axis=0)) < len(stored):
        raise ArrangementError(
            "two vertices become one when rounded; give `lengths` that make the edges more equal"
        )
    mesh = trimesh.Trimesh(points, _triangles(dual), process=False)
    if size is not None:
        mesh.units = "millimeters"
    return mesh


def _triangles(dual: DualPolyhedron) -> npt.NDArray[np.int64]:
    """Cut every face into a fan; the orientation is kept."""
    return np.array(
        [
            (cycle[0], cycle[k], cycle[k + 1])
            for cycle in dual.faces
            for k in range(1, len(cycle) - 1)
        ],
        dtype=np.int64,
    )


def export(dual: DualPolyhedron, path: str | os.PathLike[str], size: float) -> None:
    """Write a model file; see `DualPolyhedron.export`."""
    write_bytes_atomically(path, content(dual, Path(path).suffix.lower(), size))


def content(dual: DualPolyhedron, kind: str, size: float) -> bytes:
    """Return the bytes of a model file of the kind ``.stl``, ``.glb`` or ``.obj``."""
    if kind not in _WRITERS:
        raise InputError(
            f"the file name ends in {shown(kind)}; known are {', '.join(sorted(_WRITERS))}"
        )
    return _WRITERS[kind](dual, size)


def _stl(dual: DualPolyhedron, size: float) -> bytes:
    content: bytes = as_trimesh(dual, size, single=True).export(file_type="stl")
    return content


def _glb(dual: DualPolyhedron, size: float) -> bytes:
    """GLB: glTF counts in metres."""
    mesh = as_trimesh(dual, size, single=True)
    mesh.apply_scale(0.001)
    mesh.units = "meters"
    content: bytes = mesh.export(file_type="glb")
    return content


def _obj(dual: DualPolyhedron, size: float) -> bytes:
    """OBJ with the true polygons as faces; vertex numbers start at 1."""
    points = as_trimesh(dual, size).vertices
    v, e, f = dual.f_vector
    lines = [f"# dual polyhedron: {v} vertices, {e} edges, {f} faces; unit: millimetre"]
    lines += ["v " + " ".join(repr(float(x)) for x in point) for point in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in cycle) for cycle in dual.faces]
    return ("\n".join(lines) + "\n").encode("ascii")


_WRITERS = {".stl": _stl, ".glb": _glb, ".obj": _obj}
