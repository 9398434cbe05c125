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
from collections.abc import Iterator, Sequence
from itertools import islice, pairwise
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError, OutOfReachError
from arrangement.library.files.json_files import parse_json, read_bytes
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.numbers.float_filter import Floats
from equilibrium.model.errors import GraspError

Facets: TypeAlias = NDArray[np.intp]
#: The coordinates of points and the numbers of those of each facet, in the order of a file.
_Buffers: TypeAlias = "tuple[array[float] | Floats, array[int] | Facets]"

#: What a facet and a point take until the contacts are found, measured.
_BYTES_OF_FACET, _BYTES_OF_POINT = 350, 100
#: A line, and the header of a PLY file.
_LONGEST = 2**20
#: Products of four coordinates are floats.
FARTHEST = 1e60
_BINARY_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
_STL_VECTOR = r" (\S+) (\S+) (\S+)"
#: A facet of an ASCII STL file, 21 words.
_STL_FACET = re.compile(
    f"facet normal{_STL_VECTOR} outer loop{3 * (' vertex' + _STL_VECTOR)} endloop endfacet",
    re.ASCII | re.IGNORECASE,
)
_PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I"}
_PLY_TYPES |= {"int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I"}
_PLY_TYPES |= {"float": "f", "float32": "f", "double": "d", "float64": "d"}
_TYPE = "|".join(_PLY_TYPES)
#: A line of the header: an element and its number, or a property of it, perhaps a list.
_PLY_LINE = re.compile(
    rf"element (\S+) ([0-9]{{1,18}})|property (?:list ({_TYPE}) )?({_TYPE}) (\S+)"
)
#: The order of the bytes of numbers; empty where they are words.
_PLY_FORMATS = {
    "format ascii 1.0": "",
    "format binary_little_endian 1.0": "<",
    "format binary_big_endian 1.0": ">",
}
#: The numbers of a GLB file: how many an entry has, and their types by what glTF calls them.
_GLB_TYPES = {"VEC3": (3, {5126: "<f4"}), "SCALAR": (1, {5121: "<u1", 5123: "<u2", 5125: "<u4"})}
_GLB_TRIANGLES = 4
_NUMBER = re.compile(
    r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?|[+-]?(nan|inf)", re.ASCII | re.IGNORECASE
)
_INTEGER = re.compile("[+-]?[0-9]{1,18}")


def read_triangles(path: Path) -> tuple[Floats, Facets]:
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
            coordinates, corners = read(content)
        points = np.asarray(coordinates, np.float64).reshape(-1, 3)
        facets = np.asarray(corners, np.intp).reshape(-1, 3)
        _check_size(len(facets), len(points))
        low, high = facets.min(initial=0), facets.max(initial=-1)
        if low < 0 or high >= len(points):
            raise GraspError(
                f"a facet names vertex {low or high}; there are {len(points)}, counted from 0"
            )
    except OutOfReachError:
        raise
    except InputError as error:
        raise GraspError(f"{path} is not a mesh that can be read: {error}") from None
    if not len(facets):
        raise GraspError(f"{path} has no facets; give a mesh with a closed surface")
    if not (np.abs(points) <= FARTHEST).all():
        raise GraspError(f"{path} has coordinates that are not numbers, or beyond 1e60")
    return points, facets


def _check_size(facets: int, points: int = 0) -> None:
    """Refuse a mesh that takes more memory than the budget has."""
    budget.check_cost(
        f"a mesh of {facets:,} facets",
        "give a coarser mesh",
        bytes=_BYTES_OF_FACET * facets + _BYTES_OF_POINT * points,
    )


def _add_facet(facets: array[int], corners: Sequence[int]) -> None:
    """Add a polygon, cut into a fan."""
    if len(corners) < 3:
        raise GraspError(f"a facet has {len(corners)} corners; expected three or more")
    if len(corners) > 3:  # triangles are no longer than their text
        _check_size(len(facets) // 3 + len(corners))
    for a, b in pairwise(corners[1:]):
        facets.extend((corners[0], a, b))


def _stl(content: bytes) -> _Buffers:
    number = int.from_bytes(content[80:84], "little")
    if len(content) == 84 + number * _BINARY_STL.itemsize:
        corners = np.frombuffer(content, _BINARY_STL, number, 84)["corners"].astype(np.float64)
        return corners, np.arange(3 * number)
    coordinates, facet = array("d"), list[str]()
    begun = ended = 0
    for words in _lines(content):
        first = words[0].lower() if words else ""
        begun, ended = begun + (first == "solid"), ended + (first == "endsolid")
        if not ended <= begun <= ended + 1:
            break
        facet += [] if first in ("solid", "endsolid") else words
        while len(facet) >= 21:
            match = _STL_FACET.fullmatch(" ".join(facet[:21]))
            if not match:
                raise GraspError("a facet is not: facet normal, outer loop, three vertices, ...")
            coordinates.extend(_numbers(match.groups())[3:])
            del facet[:21]
    if not begun == ended > 0 or facet:
        raise GraspError(
            "it is neither a binary STL file as long as its number of facets requires, nor an "
            "ASCII one from solid to endsolid"
        )
    return coordinates, np.arange(len(coordinates) // 3)


def _obj(content: bytes) -> _Buffers:
    coordinates, facets = array("d"), array("q")
    # a backslash at the end continues a line
    whole = re.sub(rb"#.*|\\\r?\n", b" ", content)
    for number, (kind, *words) in enumerate((words or [""] for words in _lines(whole)), 1):
        try:
            if kind == "f":
                _add_facet(facets, [_obj_index(word, len(coordinates) // 3) for word in words])
            elif kind == "v":
                # after x y z may come a weight, or a colour, or both
                if len(words) not in (3, 4, 6, 7):
                    raise GraspError(f"a vertex has {len(words)} numbers; expected x y z")
                coordinates.extend(_numbers(words)[:3])
        except GraspError as error:
            raise GraspError(f"line {number}: {error}") from None
    return coordinates, facets


def _obj_index(word: str, points: int) -> int:
    """Return the number of a vertex, from 0; in the file from 1, or from the end if negative."""
    match = re.fullmatch(r"(-?[0-9]{1,18})(/[-0-9]*){0,2}", word)
    number = int(match[1]) if match else 0
    if not number:
        raise GraspError(
            f"a corner of a facet is {shown(word)}; expected a number such as 3 or 3/1/2"
        )
    index = number - 1 if number > 0 else points + number
    if index < 0:
        raise GraspError(f"a facet names vertex {index}; expected 0 or more")
    return index


def _ply(content: bytes) -> _Buffers:
    header, end, body = content.partition(b"end_header")
    endian, elements = _ply_header(_text(header, "the header") if end else "")
    body = body.removeprefix(b"\r").removeprefix(b"\n")
    units: Iterator[Any] = iter(body) if endian else (x for words in _lines(body) for x in words)

    def take(kind: str, number: float) -> Sequence[Any]:
        """Return the next numbers of a kind, from bytes or from words."""
        if 0 <= number <= len(body):
            form = f"{endian}{int(number)}{kind}"
            size = struct.calcsize(form) if endian else int(number)
            taken: Any = (bytes if endian else list)(islice(units, size))
            if len(taken) == size:
                return struct.unpack(form, taken) if endian else _numbers(taken, kind)
        raise GraspError("it ends before the numbers that its counts promise")

    coordinates, facets = array("d"), array("q")
    for name, count, properties in elements:
        kinds = {key: kind for kind, length, key in properties}
        corners = next((key for key in ("vertex_indices", "vertex_index") if key in kinds), "")
        lengths = {key: length for _, length, key in properties}
        if name == "vertex" and any(lengths.get(axis, "list") for axis in "xyz"):
            raise GraspError("its vertices have no x, y and z")
        if name == "face" and kinds.get(corners) in ("f", "d"):
            raise GraspError("its facets have floats for vertices; expected whole numbers")
        for _ in range(count if properties else 0):
            row = {
                key: take(kind, take(length, 1)[0] if length else 1)
                for kind, length, key in properties
            }
            if name == "vertex":
                coordinates.extend((*row["x"], *row["y"], *row["z"]))
            elif name == "face" and corners:
                _add_facet(facets, row[corners])
    if next(units, None) is not None:
        raise GraspError("it goes on after the last element of its header")
    return coordinates, facets


def _ply_header(text: str) -> tuple[str, list[tuple[str, int, list[tuple[str, str, str]]]]]:
    """Return the order of bytes, and name, number and properties of each element.

    Of a property there are the type, that of its length if it is a list, else "", and the name.
    """
    first, form, *lines = *(" ".join(line.split()) for line in text.splitlines()), "", ""
    if first != "ply" or form not in _PLY_FORMATS:
        raise GraspError("a PLY file begins with ply, its format and a header up to end_header")
    elements: list[tuple[str, int, list[tuple[str, str, str]]]] = []
    for line in lines:
        match = _PLY_LINE.fullmatch(line)
        if match and match[1]:
            elements.append((match[1], int(match[2]), []))
        elif match and elements:
            elements[-1][2].append((_PLY_TYPES[match[4]], _PLY_TYPES.get(match[3], ""), match[5]))
        elif line.partition(" ")[0] not in ("", "comment", "obj_info"):
            raise GraspError(f"a line of its header is {shown(line)}")
    return _PLY_FORMATS[form], elements


def _text(content: bytes, what: str) -> str:
    """Return a text whose words, each with 50 bytes more, fit into memory.

    Bytes that are not UTF-8, as in names, are not numbers.
    """
    if len(content) > _LONGEST:
        raise GraspError(f"{what} of it has {len(content):,} bytes; expected at most {_LONGEST:,}")
    return content.decode("utf-8", errors="replace")


def _lines(content: bytes) -> Iterator[list[str]]:
    return (_text(line, "a line").split() for line in io.BytesIO(content))


def _numbers(words: Sequence[str], kind: str = "d") -> list[Any]:
    """Return numbers of a kind of `struct`."""
    read, form, what = (
        (float, _NUMBER, "a number") if kind in "fd" else (int, _INTEGER, "a whole number")
    )
    for word in words:
        if not form.fullmatch(word):
            raise GraspError(f"{shown(word)} is not {what}")
    return [read(word) for word in words]


def _glb(content: bytes) -> _Buffers:
    chunks, place = dict[bytes, bytes](), 12
    while place + 8 <= len(content):
        length, kind = struct.unpack_from("<I4s", content, place)
        place += 8 + length
        if place > len(content):
            raise GraspError("it ends before the bytes that its chunks promise")
        chunks[kind] = content[place - length : place]
    if content[:8] != b"glTF\2\0\0\0" or b"JSON" not in chunks:
        raise GraspError("a GLB file has the header of version 2 and a chunk of JSON")
    budget.check_size(len(chunks[b"JSON"]), "bytes of a file", "the JSON of the GLB file")
    text = chunks[b"JSON"].decode("utf-8", errors="replace")
    scene = _GlbScene(parse_json(text, "its JSON", floats=float), chunks.get(b"BIN\0", b""))
    try:
        return scene.triangles()
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise GraspError("its JSON is not that of a glTF scene") from None


class _GlbScene(NamedTuple):
    """The scene of a glTF document, all of whose numbers are in one block of bytes."""

    document: dict[str, Any]
    data: bytes

    def item(self, kind: str, number: Any) -> Any:
        """Return an entry of a list of the document."""
        entries = self.document.get(kind, [])
        if type(number) is not int or not 0 <= number < len(entries):
            raise GraspError(f"its {kind} have no number {shown(number)}")
        return entries[number]

    def triangles(self) -> tuple[Floats, Facets]:
        """Return the triangles of the nodes of the scene, each mesh where its nodes put it."""
        if not self.document.get("scenes"):
            raise GraspError("it has no scene")
        roots = self.item("scenes", self.document.get("scene", 0)).get("nodes", [])
        waiting = [(node, np.eye(4)) for node in roots]
        seen: set[int] = set()
        points: list[Floats] = [np.empty((0, 3))]
        facets: list[Facets] = [np.empty((0, 3), np.intp)]
        start = count = 0
        while waiting:
            number, outer = waiting.pop()
            node = self.item("nodes", number)
            if number in seen:
                raise GraspError(f"node {number} of its scene has two places")
            seen.add(number)
            transform = outer @ _placement(node)
            waiting += [(child, transform) for child in node.get("children", [])]
            for part in self.item("meshes", node["mesh"])["primitives"] if "mesh" in node else ():
                own, corners = self.part(part)
                count += max(len(own), len(corners)) // 3
                _check_size(count)
                turn = -1 if np.linalg.det(transform[:3, :3]) < 0 else 1
                points.append(own.astype(np.float64) @ transform[:3, :3].T + transform[:3, 3])
                facets.append(start + corners.astype(np.intp).reshape(-1, 3)[:, ::turn])
                start += len(own)
        return np.concatenate(points), np.concatenate(facets)

    def part(self, part: dict[str, Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the points of a part of a mesh and the corners of its triangles, as stored."""
        if part.get("mode", _GLB_TRIANGLES) != _GLB_TRIANGLES:
            raise GraspError("its meshes are not of single triangles (mode 4)")
        points = self.numbers(part["attributes"]["POSITION"], "VEC3")
        indices = part.get("indices")
        corners = np.arange(len(points)) if indices is None else self.numbers(indices, "SCALAR")
        if len(corners) % 3 or (len(corners) and corners.max() >= len(points)):
            raise GraspError(
                f"a facet names a vertex that is not there; there are {len(points)}, from 0"
            )
        return points, corners

    def numbers(self, number: Any, form: str) -> NDArray[Any]:
        """Return the numbers of an accessor, which are in the file in full, an entry a row."""
        accessor = self.item("accessors", number)
        width, kinds = _GLB_TYPES[form]
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
    *axis, w = np.array(node.get("rotation", (0, 0, 0, 1)), float).reshape(4)
    across = np.cross(axis, np.eye(3))
    turned = np.eye(3) + 2 * (w * across + np.cross(axis, across)).T
    transform[:3, :3] = turned * np.array(node.get("scale", (1, 1, 1)), float)
    transform[:3, 3] = np.array(node.get("translation", (0, 0, 0)), float)
    return transform


#: How each kind of file is read.
READERS = {".glb": _glb, ".obj": _obj, ".ply": _ply, ".stl": _stl}
