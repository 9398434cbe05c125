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
#: Points (V, 3), and the numbers of those of each facet (F, 3).
Triangles: TypeAlias = tuple[Floats, Facets]

#: What a facet and a point take until the contacts are found, measured.
_BYTES_OF_FACET, _BYTES_OF_POINT = 350, 100
#: A line, and the header of a PLY file.
_LONGEST = 2**20
#: Products of four coordinates are floats.
FARTHEST = 1e60
_BINARY_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
#: The words of a facet of an ASCII STL file; empty where a number is.
_STL_FACET = ["facet", "normal", *3 * [""], "outer", "loop", *3 * ["vertex", "", "", ""]]
_STL_FACET += ["endloop", "endfacet"]
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
    if not (np.abs(points) <= FARTHEST).all():
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
            words = [a for a, b in zip(used, _STL_FACET, strict=True) if not b]
            corners.extend(_numbers(words, float)[3:])
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
                mesh.points.extend(_numbers(words, float)[:3])
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
    index = number - 1 if number > 0 else points + number
    if index < 0:
        raise GraspError(f"a facet names vertex {index}; expected 0 or more")
    return index


class _PlyProperty(NamedTuple):
    """A property of an element: its type, and of a list the type of its lengths, else ""."""

    name: str
    kind: str
    length: str


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
        size = struct.calcsize(self.endian + kind) if self.endian else 1  # of a word at least
        if 0 <= number <= (len(self.content) - self.place) // size:
            if self.endian:
                self.place += number * size
                form = f"{self.endian}{number}{kind}"
                return struct.unpack_from(form, self.content, self.place - number * size)
            words = list(islice(self.words, number))
            if len(words) == number:
                return _numbers(words, float if kind in "fd" else int)
        raise GraspError("it ends before the numbers that its counts promise")

    def at_end(self) -> bool:
        return self.place == len(self.content) if self.endian else next(self.words, None) is None

    def row(self, properties: Iterable[_PlyProperty]) -> dict[str, Sequence[Any]]:
        """Return the values of the next of the elements by property."""
        return {
            p.name: self.take(p.kind, int(self.take(p.length, 1)[0]) if p.length else 1)
            for p in properties
        }


def _ply(content: bytes) -> Triangles:
    header, end, rest = content.partition(b"end_header")
    text = _text(_short(header, "the header"))
    first, form, *lines = *(" ".join(line.split()) for line in text.splitlines()), "", ""
    if not end or first != "ply" or form not in _PLY_FORMATS:
        raise GraspError("a PLY file begins with ply, its format and a header up to end_header")
    body = _PlyBody(rest.removeprefix(b"\r").removeprefix(b"\n"), _PLY_FORMATS[form])
    mesh = _Builder()
    for name, number, properties in _ply_elements(lines):
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


def _ply_elements(lines: Iterable[str]) -> list[tuple[str, int, list[_PlyProperty]]]:
    """Return name, number and properties of each element of a header."""
    elements: list[tuple[str, int, list[_PlyProperty]]] = []
    for line in lines:
        match = _PLY_LINE.fullmatch(line)
        if match and match[1]:
            elements.append((match[1], int(match[2]), []))
        elif match and elements:
            length, kind = _PLY_TYPES.get(match[3], ""), _PLY_TYPES[match[4]]
            elements[-1][2].append(_PlyProperty(match[5], kind, length))
        elif line.partition(" ")[0] not in ("", "comment", "obj_info"):
            raise GraspError(f"a line of its header is {shown(line)}")
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


def _numbers(words: Sequence[str], kind: type[float]) -> list[Any]:
    form, what = (_INTEGER, "a whole number") if kind is int else (_NUMBER, "a number")
    for word in words:
        if not form.fullmatch(word):
            raise GraspError(f"{shown(word)} is not {what}")
    return [kind(word) for word in words]


def _glb(content: bytes) -> Triangles:
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
                check_size(count)
                turn = -1 if np.linalg.det(transform[:3, :3]) < 0 else 1
                points.append(own.astype(np.float64) @ transform[:3, :3].T + transform[:3, 3])
                facets.append(start + corners.astype(np.intp).reshape(-1, 3)[:, ::turn])
                start += len(own)
        return np.concatenate(points), np.concatenate(facets)

    def part(self, part: dict[str, Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the points of a part of a mesh and the corners of its triangles, as stored."""
        if part.get("mode", _GLB_TRIANGLES) != _GLB_TRIANGLES:
            raise GraspError("its meshes are not of single triangles (mode 4)")
        points = self.numbers(part["attributes"]["POSITION"], {_GLB_FLOAT: "<f4"}, "VEC3", 3)
        indices = part.get("indices")
        corners = np.arange(len(points))
        if indices is not None:
            corners = self.numbers(indices, _GLB_INDICES, "SCALAR", 1)[:, 0]
        if len(corners) % 3 or (len(corners) and corners.max() >= len(points)):
            raise GraspError(
                f"a facet names a vertex that is not there; there are {len(points)}, from 0"
            )
        return points, corners

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
