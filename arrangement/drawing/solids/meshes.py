"""Closed surfaces as the bytes of STL, OBJ and GLB files. The same parts give the same bytes.

Lengths come in millimetres. STL and OBJ carry no unit: their numbers are millimetres, and their
first line says so. GLB is in metres with y upward, as its standard demands; it has colours and
keeps every part as a node of its own.

trimesh's exporters cut polygons to triangles in OBJ, state no unit, and keep colours of GLB as 8
bits of linear light, so that dark ones change; 85 lines here write what they lose.
"""

from __future__ import annotations

import json
import math
import re
import struct
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from arrangement.errors import ArrangementError, InputError
from arrangement.numbers.exact import shown
from arrangement.numbers.linear.rank import cycle_edges

from .sight import unit

Floats = npt.NDArray[np.float64]
Triangles = npt.NDArray[np.int64]
_COLOUR = re.compile("#[0-9a-fA-F]{6}(?:[0-9a-fA-F]{2})?")
KINDS = (".glb", ".obj", ".stl")
#: Coordinates are multiples of a power of two, of which the largest one has at most this many: then
#: single precision holds them exactly.
_STEPS = 1 << 20


@dataclass(frozen=True)
class ClosedSurface:
    """A closed surface of plane, convex faces, oriented outward.

    Attributes:
        name: of the part in the file.
        points: (P, 3) in millimetres.
        faces: cycles of points, counter-clockwise seen from outside.
        colours: one for each face, as ``#rrggbb``, or ``#rrggbbaa`` to shine through in GLB.
        shift: by how much the part is moved out of its place, in millimetres.
        notes: goes to the extras of the node in GLB.
    """

    name: str
    points: Floats
    faces: tuple[tuple[int, ...], ...]
    colours: tuple[str, ...]
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    notes: dict[str, Any] = field(default_factory=dict)


def model_bytes(parts: Sequence[ClosedSurface], kind: str, title: str) -> bytes:
    """Return a model file.

    Args:
        parts: closed surfaces.
        kind: ``.stl`` (binary, one closed shell for each part), ``.obj`` (true polygons, one
            object for each part) or ``.glb`` (one node for each part, colours).
        title: what the file shows, in ASCII.

    Raises:
        InputError: an unknown kind, a colour that is not of the form ``#rrggbb``.
        ArrangementError: a part that is not a solid any more in single precision.
    """
    if kind not in _WRITERS:
        raise InputError(f"the file name ends in {shown(kind)}; expected one of {', '.join(KINDS)}")
    for colour in {colour for part in parts for colour in part.colours}:
        if not (isinstance(colour, str) and _COLOUR.fullmatch(colour)):
            raise InputError(f"the colour is {shown(colour)}; models take the form #rrggbb")
    extent = max(float(np.abs(part.points + part.shift).max()) for part in parts)
    writer = _WRITERS[kind]
    step = 2.0 ** math.ceil(math.log2(extent / _STEPS))
    return writer([_weld_points(part, step) for part in parts], title)


def triangles(faces: Sequence[tuple[int, ...]]) -> Triangles:
    """Cut convex faces into fans; the orientation is kept."""
    rows = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]
    return np.array(rows, dtype=np.int64).reshape(-1, 3)


def _weld_points(part: ClosedSurface, step: float) -> ClosedSurface:
    """Round coordinates to multiples of `step`, and join the points that this makes equal."""
    grid = np.round(part.points / step).astype(np.int64)
    first: dict[tuple[int, ...], int] = {}
    join = [first.setdefault(tuple(row), k) for k, row in enumerate(grid.tolist())]
    faces, colours = [], []
    for face, colour in zip(part.faces, part.colours, strict=True):
        cycle = [join[i] for i in face]
        kept = tuple(a for a, b in cycle_edges(cycle) if a != b)
        if len(set(kept)) > 2:
            faces.append(kept)
            colours.append(colour)
    used = sorted({i for face in faces for i in face})
    number = {old: new for new, old in enumerate(used)}
    renumbered = tuple(tuple(number[i] for i in face) for face in faces)
    points = (grid[used] * step).astype(np.float64)
    if not _is_closed(renumbered) or volume(points, renumbered) <= 0:
        raise ArrangementError(
            f"the part {part.name} is too thin for a model: rounded to single precision it is not "
            "a solid any more"
        )
    shift = np.round(np.array(part.shift) / step) * step
    return ClosedSurface(
        part.name,
        points,
        renumbered,
        tuple(colours),
        (float(shift[0]), float(shift[1]), float(shift[2])),
        part.notes,
    )


def volume(points: Floats, faces: Sequence[tuple[int, ...]]) -> float:
    """Return the volume inside a closed surface."""
    a, b, c = (points[column] for column in triangles(faces).T)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


def _is_closed(faces: Sequence[tuple[int, ...]]) -> bool:
    """Return whether every directed edge occurs once, and its reverse too."""
    edges = [e for f in faces for e in cycle_edges(f)]
    known = set(edges)
    return bool(faces) and len(known) == len(edges) and all((b, a) in known for a, b in edges)


def _stl(parts: Sequence[ClosedSurface], title: str) -> bytes:
    corners = np.concatenate([(p.points + p.shift)[triangles(p.faces)] for p in parts])
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rows = np.zeros(len(corners), dtype=[("xyz", "<f4", (4, 3)), ("attribute", "<u2")])
    rows["xyz"][:, 0], rows["xyz"][:, 1:] = unit(normals), corners
    header = f"{title}; unit: millimetre".encode("ascii")[:80].ljust(80)
    return header + struct.pack("<I", len(rows)) + rows.tobytes()


def _obj(parts: Sequence[ClosedSurface], title: str) -> bytes:
    lines, start = [f"# {title}; unit: millimetre"], 1
    for part in parts:
        lines.append(f"o {part.name}")
        points = (part.points + part.shift).tolist()
        lines += ["v " + " ".join(repr(x) for x in point) for point in points]
        lines += ["f " + " ".join(str(start + i) for i in face) for face in part.faces]
        start += len(points)
    return ("\n".join(lines) + "\n").encode("ascii")


def _glb(parts: Sequence[ClosedSurface], title: str) -> bytes:
    """Return header, JSON chunk and binary chunk; each part has one list of triangles a colour."""
    binary, views, accessors = bytearray(), list[dict[str, Any]](), list[dict[str, Any]]()
    colours = list(dict.fromkeys(colour for part in parts for colour in part.colours))

    def accessor(array: Any, target: int, kind: int, shape: str, **more: Any) -> int:
        content = array.tobytes()
        place = {"buffer": 0, "byteOffset": len(binary), "byteLength": len(content)}
        views.append({**place, "target": target})
        binary.extend(content)
        fields = {"bufferView": len(views) - 1, "componentType": kind, "count": len(array)}
        accessors.append({**fields, "type": shape, **more})
        return len(accessors) - 1

    meshes, nodes = list[dict[str, Any]](), list[dict[str, Any]]()
    for part in parts:
        points = (part.points / 1000).astype("<f4")
        ends = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
        position = accessor(points, 34962, 5126, "VEC3", **ends)
        primitives = []
        for colour in dict.fromkeys(part.colours):
            faces = [f for f, c in zip(part.faces, part.colours, strict=True) if c == colour]
            corners = triangles(faces).astype("<u4").reshape(-1)
            attributes = {"attributes": {"POSITION": position}}
            indices = accessor(corners, 34963, 5125, "SCALAR")
            primitives.append({**attributes, "indices": indices, "material": colours.index(colour)})
        node: dict[str, Any] = {"name": part.name, "mesh": len(meshes)}
        node |= {"translation": [x / 1000 for x in part.shift]} if any(part.shift) else {}
        nodes.append(node | ({"extras": part.notes} if part.notes else {}))
        meshes.append({"name": part.name, "primitives": primitives})
    # The root turns z, upward in the space of the planes, into y.
    root = {"name": title, "rotation": [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]}
    document = {
        "asset": {
            "version": "2.0",
            "generator": "slipstates",
            "extras": {"title": title, "unit": "metre"},
        },
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{**root, "children": list(range(1, len(nodes) + 1))}, *nodes],
        "meshes": meshes,
        "materials": list(map(_material, colours)),
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode("ascii")
    text, body = text + b" " * (-len(text) % 4), bytes(binary) + b"\0" * (-len(binary) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(body))
    chunks = ((b"JSON", text), (b"BIN\0", body))
    return head + b"".join(struct.pack("<I4s", len(x), kind) + x for kind, x in chunks)


def _material(colour: str) -> dict[str, Any]:
    channels = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    opacity = int(colour[7:] or "ff", 16) / 255
    look = {"metallicFactor": 0.0, "roughnessFactor": 0.8}
    base = {"baseColorFactor": [*map(_linear, channels), opacity], **look}
    through = {"alphaMode": "BLEND", "doubleSided": True} if opacity < 1 else {}
    return {"name": colour, "pbrMetallicRoughness": base, **through}


def _linear(channel: float) -> float:
    """Return a channel of an sRGB colour as the light that glTF counts in."""
    light = channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4
    return round(light, 6)


_WRITERS = {".glb": _glb, ".obj": _obj, ".stl": _stl}
