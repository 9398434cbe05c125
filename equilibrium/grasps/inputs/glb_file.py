"""The triangles of GLB files, and how many triangles a mesh may have.

Of a scene the meshes of triangles are read, each where its nodes put it. Materials, textures,
animations and what is in other files are ignored or refused, never opened.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError
from arrangement.library.files.json_files import parse_json
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.numbers.float_filter import Floats
from equilibrium.model.errors import GraspError

Facets: TypeAlias = NDArray[np.intp]
#: Points (V, 3), and the numbers of those of each facet (F, 3).
Triangles: TypeAlias = tuple[Floats, Facets]

#: What a facet and a point take until the contacts are found, measured.
_BYTES_OF_FACET, _BYTES_OF_POINT = 350, 100
_GLB_JSON = 0x4E4F534A
_GLB_BINARY = 0x004E4942
_GLB_TRIANGLES = 4
_GLB_INDICES = {5121: "<u1", 5123: "<u2", 5125: "<u4"}
_GLB_FLOAT = 5126


def check_size(facets: int, points: int = 0) -> None:
    """Refuse a mesh that takes more memory than the budget has."""
    budget.check_cost(
        f"a mesh of {facets:,} facets",
        "give a coarser mesh",
        bytes=_BYTES_OF_FACET * facets + _BYTES_OF_POINT * points,
    )


def read_glb(content: bytes) -> Triangles:
    """Return the triangles of the scene of a file."""
    chunks = dict(_chunks(content))
    if content[:8] != b"glTF\2\0\0\0" or _GLB_JSON not in chunks:
        raise GraspError("a GLB file has the header of version 2 and a chunk of JSON")
    budget.check_size(len(chunks[_GLB_JSON]), "bytes of a file", "the JSON of the GLB file")
    scene = parse_json(
        chunks[_GLB_JSON].decode("utf-8", errors="replace"), "its JSON", floats=float
    )
    try:
        return _GlbScene(scene, chunks.get(_GLB_BINARY, b"")).triangles()
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise GraspError("its JSON is not that of a glTF scene") from None


def _chunks(content: bytes) -> Iterator[tuple[int, bytes]]:
    place = 12
    while place + 8 <= len(content):
        length, kind = struct.unpack_from("<II", content, place)
        if place + 8 + length > len(content):
            raise GraspError("it ends before the bytes that its chunks promise")
        yield kind, content[place + 8 : place + 8 + length]
        place += 8 + length


class _GlbScene:
    """The scene of a glTF document, all of whose numbers are in one block of bytes."""

    def __init__(self, document: dict[str, Any], data: bytes) -> None:
        self.document, self.data = document, data

    def item(self, kind: str, number: Any) -> Any:
        """Return an entry of a list of the document."""
        entries = self.document.get(kind, [])
        if type(number) is not int or not 0 <= number < len(entries):
            raise GraspError(f"its {kind} have no number {shown(number)}")
        return entries[number]

    def triangles(self) -> Triangles:
        """Return the triangles of the nodes of the scene, each mesh where its nodes put it."""
        if not self.document.get("scenes"):
            raise GraspError("it has no scene")
        roots = self.item("scenes", self.document.get("scene", 0)).get("nodes", [])
        waiting = [(node, np.eye(4)) for node in roots]
        placed: list[tuple[Any, Floats]] = []
        seen: set[int] = set()
        facets = 0
        while waiting:
            number, outer = waiting.pop()
            node = self.item("nodes", number)
            if number in seen:
                raise GraspError(f"node {number} of its scene has two places")
            seen.add(number)
            transform = outer @ _placement(node)
            waiting += [(child, transform) for child in node.get("children", [])]
            for part in self.item("meshes", node["mesh"])["primitives"] if "mesh" in node else ():
                placed.append((part, transform))
                facets += self.size(part)
                check_size(facets)
        parts = [self.part(part, transform) for part, transform in placed]
        starts = np.cumsum([0, *(len(points) for points, _ in parts)])
        joined = [corners + start for (_, corners), start in zip(parts, starts, strict=False)]
        empty = np.empty((0, 3))
        return (
            np.concatenate([empty, *(points for points, _ in parts)]),
            np.concatenate([empty.astype(np.intp), *joined]),
        )

    def size(self, part: dict[str, Any]) -> int:
        """Return the number of points or facets of a part that its accessors state."""
        accessors = (part.get("indices"), part["attributes"]["POSITION"])
        return max(
            int(self.item("accessors", number)["count"]) // 3
            for number in accessors
            if number is not None
        )

    def part(self, part: dict[str, Any], transform: Floats) -> Triangles:
        """Return the points of a part of a mesh, moved, and its facets."""
        if part.get("mode", _GLB_TRIANGLES) != _GLB_TRIANGLES:
            raise GraspError("its meshes are not of single triangles (mode 4)")
        place = part["attributes"]["POSITION"]
        points = self.numbers(place, {_GLB_FLOAT: "<f4"}, "VEC3", 3).astype(np.float64)
        indices = part.get("indices")
        if indices is None:
            corners = np.arange(len(points))
        else:
            corners = self.numbers(indices, _GLB_INDICES, "SCALAR", 1).astype(np.intp).ravel()
        if len(corners) % 3 or (len(corners) and corners.max() >= len(points)):
            raise GraspError(
                f"a facet names a vertex that is not there; there are {len(points)}, from 0"
            )
        facets = corners.reshape(-1, 3)
        if np.linalg.det(transform[:3, :3]) < 0:
            facets = facets[:, ::-1]
        return points @ transform[:3, :3].T + transform[:3, 3], facets

    def numbers(self, number: Any, kinds: dict[int, str], form: str, width: int) -> NDArray[Any]:
        """Return the (count, width) numbers of an accessor, which are in the file in full."""
        accessor = self.item("accessors", number)
        kind = kinds.get(accessor["componentType"])
        if "sparse" in accessor or "bufferView" not in accessor:
            raise GraspError(f"accessor {number} has no data of its own; write it in full")
        if kind is None or accessor["type"] != form:
            raise GraspError(f"accessor {number} is not of the type of points or of facets")
        view = self.item("bufferViews", accessor["bufferView"])
        if view["buffer"] != 0 or "uri" in self.item("buffers", 0):
            raise GraspError("its numbers are in another file, which is not opened")
        dtype = np.dtype(kind)
        step = view.get("byteStride", width * dtype.itemsize)
        begin, start = view.get("byteOffset", 0), accessor.get("byteOffset", 0)
        count, length = accessor["count"], view["byteLength"]
        if any(type(k) is not int or k < 0 for k in (step, begin, start, count, length)):
            raise GraspError(f"accessor {number} has sizes that are not whole numbers")
        needed = start + (count - 1) * step + width * dtype.itemsize if count else 0
        if needed > length or begin + length > len(self.data) or step < dtype.itemsize:
            raise GraspError(
                f"accessor {number} has {count} entries, more than there are bytes for"
            )
        return np.ndarray((count, width), dtype, self.data, begin + start, (step, dtype.itemsize))


def _placement(node: dict[str, Any]) -> Floats:
    """Return the transform of a node: its matrix, or scale, rotation and translation."""
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    found = np.eye(4)
    x, y, z, w = np.array(node.get("rotation", (0, 0, 0, 1)), float)
    turned = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    found[:3, :3] = turned * np.array(node.get("scale", (1, 1, 1)), float)
    found[:3, 3] = np.array(node.get("translation", (0, 0, 0)), float)
    return found
