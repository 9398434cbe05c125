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
from arrangement.io.meshes import KINDS, Part, model_bytes, triangles
from arrangement.io.writing import write_bytes_atomically

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
    mesh = trimesh.Trimesh(points, triangles(dual.faces), process=False)
    if size is not None:
        mesh.units = "millimeters"
    return mesh


def export(dual: DualPolyhedron, path: str | os.PathLike[str], size: float) -> None:
    """Write a model file; see `DualPolyhedron.export`."""
    write_bytes_atomically(path, content(dual, Path(path).suffix.lower(), size))


def content(
    dual: DualPolyhedron, kind: str, size: float, colours: tuple[str, ...] | None = None
) -> bytes:
    """Return the bytes of a model file of the kind ``.stl``, ``.glb`` or ``.obj``.

    Args:
        dual: the polyhedron.
        kind: the suffix.
        size: the largest side of the bounding box, in millimetres.
        colours: one for each face, as ``#rrggbb``; only GLB keeps them.
    """
    if kind not in KINDS:
        raise InputError(f"the file name ends in {shown(kind)}; known are {', '.join(KINDS)}")
    v, e, f = dual.f_vector
    points = np.array(as_trimesh(dual, size, single=True).vertices)
    part = Part("dual", points, dual.faces, colours or (_GREY,) * f)
    return model_bytes([part], kind, f"dual polyhedron: {v} vertices, {e} edges, {f} faces")


_GREY = "#c8c8c8"
