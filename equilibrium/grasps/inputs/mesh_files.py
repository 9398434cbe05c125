"""The triangles of STL, OBJ, PLY and GLB files, strictly read: geometry, and no second file.

Counts and sizes that a file states are compared with what is in it before anything is made of
them. Materials, textures, colours, normals and animations are ignored; nothing that is only named
is opened. The readers of trimesh accept damaged text, round the numbers of PLY text to single
precision, read no binary PLY files of mixed polygons, place the meshes of a GLB scene with other
last digits, and differ between its versions.
"""

from __future__ import annotations

import io
import re
import struct
from array import array
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, pairwise
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError, OutOfReachError
from arrangement.library.files.json_files import parse_json, read_bytes
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.numbers.float_filter import Floats
from equilibrium.model.errors import GraspError

Facets: TypeAlias = NDArray[np.intp]
#: Points (V, 3), and the numbers of those of each facet (F, 3).
Triangles: TypeAlias = tuple[Floats, Facets]

#: What a facet and a point take until the contacts are found, measured.
_BYTES_OF_FACET, _BYTES_OF_POINT = 350, 100
#: A line, and the header of a PLY file.
_LONGEST = 2**20
#: Products of four coordinates are floats.
_FARTHEST = 1e60
_BINARY_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
#: The words of a facet of an ASCII STL file; empty where a number is.
_STL_FACET = ["facet", "normal", *3 * [""], "outer", "loop", *3 * ["vertex", "", "", ""]]
_STL_FACET += ["endloop", "endfacet"]
_PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I"}
_PLY_TYPES |= {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I"}
_PLY_TYPES |= {"float": "f", "float32": "f", "double": "d", "float64": "d"}
#: The order of the bytes of numbers; empty where they are words.
_PLY_FORMATS = {
    "format ascii 1.0": "",
    "format binary_little_endian 1.0": "<",
    "format binary_big_endian 1.0": ">",
}
_GLB_JSON = 0x4E4F534A
_GLB_BINARY = 0x004E4942
_GLB_TRIANGLES = 4
_GLB_INDICES = {5121: "<u1", 5123: "<u2", 5125: "<u4"}
_GLB_FLOAT = 5126
_NUMBER = re.compile(
    r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?|[+-]?(nan|inf)", re.ASCII | re.IGNORECASE
)
_INTEGER = re.compile("[+-]?[0-9]{1,18}")


def read_triangles(path: Path) -> Triangles:
    """Return points (V, 3) and facets (F, 3) of a file; polygons are cut into fans.

    Raises:
        InputError: a file that cannot be read, is too large, or breaks its format.
    """
    read = READERS.get(path.suffix.lower())
    if read is None:
        raise GraspError(
            f"{path} is of no kind that is read here; give one of {', '.join(READERS)}"
        )
    content = read_bytes(path, str(path), "bytes of a mesh")
    try:
        with np.errstate(invalid="ignore", over="ignore"):  # what is not a number is refused below
            points, facets = read(content)
    except OutOfReachError:
        raise
    except InputError as error:
        raise GraspError(f"{path} is not a mesh that can be read: {error}") from None
    check_size(len(facets), len(points))
    if not len(facets):
        raise GraspError(f"{path} has no facets; give a mesh with a closed surface")
    if not (np.abs(points) <= _FARTHEST).all():
        raise GraspError(f"{path} has coordinates that are not numbers, or beyond 1e60")
    if facets.min() < 0 or facets.max() >= len(points):
        worst = facets.min() if facets.min() < 0 else facets.max()
        raise GraspError(
            f"{path} is not a mesh that can be read: a facet names vertex {worst}; there are "
            f"{len(points)}, counted from 0"
        )
    return points, facets


def check_size(facets: int, points: int = 0) -> None:
    """Refuse a mesh that takes more memory than the budget has."""
    budget.check_cost(
        f"a mesh of {facets:,} facets",
        "give a coarser mesh",
        bytes=_BYTES_OF_FACET * facets + _BYTES_OF_POINT * points,
    )


class _Builder:
    """Points and facets in the order of a file, as numbers of eight bytes."""

    def __init__(self) -> None:
        self.points, self.facets = array("d"), array("q")

    def add_facet(self, corners: Sequence[int]) -> None:
        """Add a polygon, cut into a fan."""
        if len(corners) < 3:
            raise GraspError(f"a facet has {len(corners)} corners; expected three or more")
        if len(corners) > 3:  # triangles are no longer than their text
            check_size(len(self.facets) // 3 + len(corners))
        for a, b in pairwise(corners[1:]):
            self.facets.extend((corners[0], a, b))

    def triangles(self) -> Triangles:
        points = np.frombuffer(self.points, np.float64).reshape(-1, 3)
        return points, np.frombuffer(self.facets, np.int64).astype(np.intp).reshape(-1, 3)


def _stl(content: bytes) -> Triangles:
    number = int.from_bytes(content[80:84], "little")
    if len(content) == 84 + number * _BINARY_STL.itemsize:
        facets = np.frombuffer(content, _BINARY_STL, number, 84)
        corners = facets["corners"].astype(np.float64).reshape(-1, 3)
    else:
        corners = np.frombuffer(_ascii_stl(content), np.float64).reshape(-1, 3)
    return corners, np.arange(len(corners)).reshape(-1, 3)


def _ascii_stl(content: bytes) -> array[float]:
    """Return the coordinates of the corners of an ASCII STL file, facet by facet."""
    corners = array("d")
    begun = ended = 0
    facet: list[str] = []
    for words in _lines(content):
        first = words[0].lower() if words else ""
        begun, ended = begun + (first == "solid"), ended + (first == "endsolid")
        facet += [] if first in ("solid", "endsolid") else words
        if not ended <= begun <= ended + 1:
            break
        while len(facet) >= len(_STL_FACET):
            used, facet = facet[: len(_STL_FACET)], facet[len(_STL_FACET) :]
            if any(b not in (a.lower(), "") for a, b in zip(used, _STL_FACET, strict=True)):
                raise GraspError("a facet is not: facet normal, outer loop, three vertices, ...")
            numbers = _floats([a for a, b in zip(used, _STL_FACET, strict=True) if not b])
            corners.extend(numbers[3:])
    if not begun == ended > 0 or facet:
        raise GraspError(
            "it is neither a binary STL file as long as its number of facets requires, nor an "
            "ASCII one from solid to endsolid"
        )
    return corners


def _obj(content: bytes) -> Triangles:
    mesh = _Builder()
    # a backslash at the end continues a line
    whole = re.sub(rb"#.*|\\\r?\n", b" ", content)
    for number, (kind, *words) in enumerate((words or [""] for words in _lines(whole)), 1):
        try:
            if kind == "f":
                mesh.add_facet([_obj_index(word, len(mesh.points) // 3) for word in words])
            elif kind == "v":
                # after x y z may come a weight, or a colour, or both
                if len(words) not in (3, 4, 6, 7):
                    raise GraspError(f"a vertex has {len(words)} numbers; expected x y z")
                mesh.points.extend(_floats(words)[:3])
        except InputError as error:
            if isinstance(error, OutOfReachError):
                raise
            raise GraspError(f"line {number}: {error}") from None
    return mesh.triangles()


def _obj_index(word: str, points: int) -> int:
    """Return the number of a vertex, from 0; in the file from 1, or from the end if negative."""
    match = re.fullmatch(r"(-?[0-9]{1,18})(/[-0-9]*){0,2}", word)
    number = int(match[1]) if match else 0
    if not number:
        raise GraspError(
            f"a corner of a facet is {shown(word)}; expected a number such as 3 or 3/1/2"
        )
    return number - 1 if number > 0 else _not_negative(points + number)


def _not_negative(number: int) -> int:
    if number < 0:
        raise GraspError(f"a facet names vertex {number}; expected 0 or more")
    return number


class _PlyProperty:
    """A property of an element: its type, and for lists the type of their lengths."""

    def __init__(self, words: Sequence[str]) -> None:
        *kinds, self.name = words or [""]
        self.is_list = kinds[:1] == ["list"]
        kinds = kinds[self.is_list :]
        if len(kinds) != 1 + self.is_list or any(kind not in _PLY_TYPES for kind in kinds):
            raise GraspError(f"a property in its header is {shown(' '.join(words))}")
        self.length, self.kind = _PLY_TYPES[kinds[0]], _PLY_TYPES[kinds[-1]]


class _PlyBody:
    """What follows the header, taken from its beginning to its end.

    Args:
        endian: of the bytes; empty where numbers are words.
    """

    def __init__(self, content: bytes, endian: str) -> None:
        self.content, self.endian, self.place = content, endian, 0
        self.words = (word for words in _lines(b"" if endian else content) for word in words)

    def take(self, kind: str, number: int) -> Sequence[Any]:
        """Return the next numbers of a kind."""
        # a word takes a byte or more, too
        if 0 <= number <= len(self.content) - self.place:
            size = struct.calcsize(self.endian + kind)
            if not self.endian:
                words = list(islice(self.words, number))
                if len(words) == number:
                    return _floats(words) if kind in "fd" else _integers(words)
            elif self.place + number * size <= len(self.content):
                self.place += number * size
                form = f"{self.endian}{number}{kind}"
                return struct.unpack_from(form, self.content, self.place - number * size)
        raise GraspError("it ends before the numbers that its counts promise")

    def at_end(self) -> bool:
        return self.place == len(self.content) if self.endian else next(self.words, None) is None

    def row(self, properties: Iterable[_PlyProperty]) -> dict[str, Sequence[Any]]:
        """Return the values of the next of the elements by property."""
        return {
            p.name: self.take(p.kind, int(self.take(p.length, 1)[0]) if p.is_list else 1)
            for p in properties
        }


def _ply(content: bytes) -> Triangles:
    header, end, rest = content.partition(b"end_header")
    lines = [line.split() for line in _text(_short(header, "the header")).splitlines()]
    form = " ".join(lines[1]) if len(lines) > 1 else ""
    if not end or lines[:1] != [["ply"]] or form not in _PLY_FORMATS:
        raise GraspError("a PLY file begins with ply, its format and a header up to end_header")
    body = _PlyBody(rest.removeprefix(b"\r").removeprefix(b"\n"), _PLY_FORMATS[form])
    mesh = _Builder()
    for name, number, properties in _ply_elements(lines[2:]):
        names = {p.name for p in properties}
        corners = next((x for x in ("vertex_indices", "vertex_index") if x in names), "")
        if name == "vertex" and not {"x", "y", "z"} <= names:
            raise GraspError("its vertices have no x, y and z")
        for _ in range(number if properties else 0):
            row = body.row(properties)
            if name == "vertex":
                mesh.points.extend((row["x"][0], row["y"][0], row["z"][0]))
            elif name == "face" and corners:
                mesh.add_facet(row[corners])
    if not body.at_end():
        raise GraspError("it goes on after the last element of its header")
    return mesh.triangles()


def _ply_elements(lines: Iterable[list[str]]) -> list[tuple[str, int, list[_PlyProperty]]]:
    """Return name, number and properties of each element of a header."""
    elements: list[tuple[str, int, list[_PlyProperty]]] = []
    for words in lines:
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "element" and len(words) == 3 and re.fullmatch("[0-9]{1,18}", words[2]):
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and elements:
            elements[-1][2].append(_PlyProperty(words[1:]))
        else:
            raise GraspError(f"a line of its header is {shown(' '.join(words))}")
    return elements


def _text(content: bytes) -> str:
    """Return a text; bytes that are not UTF-8, as in names, are not numbers."""
    return content.decode("utf-8", errors="replace")


def _lines(content: bytes) -> Iterator[list[str]]:
    for line in io.BytesIO(content):
        yield _text(_short(line, "a line")).split()


def _short(content: bytes, what: str) -> bytes:
    """Return bytes whose words fit into memory, each with 50 bytes more."""
    if len(content) > _LONGEST:
        raise GraspError(f"{what} of it has {len(content):,} bytes; expected at most {_LONGEST:,}")
    return content


def _floats(words: Sequence[str]) -> list[float]:
    for word in words:
        if not _NUMBER.fullmatch(word):
            raise GraspError(f"{shown(word)} is not a number")
    return [float(word) for word in words]


def _integers(words: Sequence[str]) -> list[int]:
    for word in words:
        if not _INTEGER.fullmatch(word):
            raise GraspError(f"{shown(word)} is not a whole number")
    return [int(word) for word in words]


def _glb(content: bytes) -> Triangles:
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
    transform = np.eye(4)
    x, y, z, w = np.array(node.get("rotation", (0, 0, 0, 1)), float)
    turned = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    transform[:3, :3] = turned * np.array(node.get("scale", (1, 1, 1)), float)
    transform[:3, 3] = np.array(node.get("translation", (0, 0, 0)), float)
    return transform


#: How each kind of file is read.
READERS = {".glb": _glb, ".obj": _obj, ".ply": _ply, ".stl": _stl}
