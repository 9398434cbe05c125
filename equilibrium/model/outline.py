"""The shape of the object, if it is stated: pictures show it, and no decision looks at it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar, TypeAlias

from arrangement.console.number_form import JsonMixin, ReprMixin
from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, rational, rational_vector, shown, to_text
from arrangement.numbers.linear.rank import cycle_edges
from arrangement.synonyms import by_word

from .errors import GraspError


@dataclass(frozen=True, repr=False)
class Polygon(ReprMixin):
    """An object with straight edges.

    Args:
        corners: at least three points in order, in either orientation (length).
    """

    dimension: ClassVar = 2
    corners: tuple[RationalVector, ...]

    def __init__(self, corners: Iterable[Iterable[Any]]) -> None:
        places = tuple(
            coordinates(corner, f"corner {i + 1} of the outline", 2)
            for i, corner in enumerate(corners)
        )
        if len(places) < 3:
            raise GraspError(f"the outline has {len(places)} corners; give at least three")
        object.__setattr__(self, "corners", places)

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return self.corners

    def to_dict(self) -> list[list[str]]:
        """Return the file form: the corners."""
        return [[to_text(x) for x in corner] for corner in self.corners]


@dataclass(frozen=True, repr=False)
class Circle(JsonMixin):
    """A round object.

    Args:
        centre: point (length).
        radius: above 0 (length).
    """

    json_fields = ("centre", "radius")

    dimension: ClassVar = 2
    centre: RationalVector
    radius: Fraction

    def __init__(self, centre: Iterable[Any], radius: Any) -> None:
        place = coordinates(centre, "the centre of the outline", self.dimension)
        object.__setattr__(self, "centre", place)
        object.__setattr__(self, "radius", rational(radius, "the radius of the outline"))
        if self.radius <= 0:
            raise GraspError(f"the radius of the outline is {self.radius}; it must be above 0")

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return tuple(tuple(x + side * self.radius for x in self.centre) for side in (-1, 1))


class Sphere(Circle):
    """A round object in space.

    Args:
        centre: point (length).
        radius: above 0 (length).
    """

    dimension: ClassVar = 3


@dataclass(frozen=True, repr=False)
class Segments(JsonMixin):
    """Thin straight walls, of a body or of the ground.

    Args:
        segments: at least one, each with two different ends (length).
    """

    json_fields = ("segments",)

    dimension: ClassVar = 2
    segments: tuple[tuple[RationalVector, RationalVector], ...]

    def __init__(self, segments: Iterable[Iterable[Iterable[Any]]]) -> None:
        listed = []
        for i, ends in enumerate(segments):
            pair = tuple(coordinates(end, f"segments[{i}]", 2) for end in ends)
            if len(pair) != 2 or pair[0] == pair[1]:
                raise GraspError(f"segments[{i}] has no two ends that differ; give two points")
            listed.append(pair)
        if not listed:
            raise GraspError("there are no segments; give at least one")
        object.__setattr__(self, "segments", tuple(listed))

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return tuple(end for ends in self.segments for end in ends)


@dataclass(frozen=True, repr=False)
class Mesh(JsonMixin):
    """An object in space with flat faces.

    Args:
        vertices: points (length), which `equilibrium.inputs.on_mesh` reads from a file.
        faces: at least three numbers of vertices each, counter-clockwise seen from outside.
    """

    _synonyms: ClassVar[Mapping[str, str]] = by_word("""
        from_file from_stl load read -> inputs.on_mesh(path, friction, at=points).grasp.outline
    """)
    json_fields = ("vertices", "faces")

    dimension: ClassVar = 3
    vertices: tuple[RationalVector, ...]
    faces: tuple[tuple[int, ...], ...]

    def __init__(self, vertices: Iterable[Iterable[Any]], faces: Iterable[Iterable[int]]) -> None:
        points = tuple(coordinates(p, f"outline.vertices[{i}]", 3) for i, p in enumerate(vertices))
        listed = tuple(map(tuple, faces))
        for i, face in enumerate(listed):
            if len(face) < 3 or any(type(k) is not int or not 0 <= k < len(points) for k in face):
                raise GraspError(
                    f"outline.faces[{i}] is {shown(list(face))}; give at least three numbers of "
                    f"vertices, from 0 to {len(points) - 1}"
                )
        object.__setattr__(self, "vertices", points)
        object.__setattr__(self, "faces", listed)

    @property
    def extremes(self) -> tuple[RationalVector, ...]:
        """Points whose bounding box is that of the object."""
        return self.vertices


def centroid(outline: Outline) -> RationalVector:
    """Return the centroid of the area of a polygon or circle.

    Raises:
        GraspError: there is no area.

    >>> [str(x) for x in centroid(Polygon([[0, 0], [3, 0], [0, 3]]))]
    ['1', '1']
    """
    if isinstance(outline, Circle):
        return outline.centre
    corners = outline.corners if isinstance(outline, Polygon) else ()
    pairs = list(cycle_edges(corners))
    parts: list[Any] = [a[0] * b[1] - a[1] * b[0] for a, b in pairs]
    if not sum(parts):
        raise GraspError("the outline has no area; expected a polygon with one, or a centre")
    sums = (
        sum((a[j] + b[j]) * part for (a, b), part in zip(pairs, parts, strict=True))
        for j in range(2)
    )
    return tuple(total / (3 * sum(parts)) for total in sums)


#: A `Circle` may be a `Sphere`.
Outline: TypeAlias = Polygon | Circle | Segments | Mesh


def read_outline(form: Any) -> Outline:
    """Return the outline of a file form.

    A list of corners is a polygon; an object with centre and radius is a circle or sphere, one with
    segments is thin walls, one with vertices and faces a mesh.

    Raises:
        InputError: another form, or a number out of range.
    """
    if isinstance(form, (list, tuple)):
        return Polygon(check_list(corner, f"outline[{i}]", 2) for i, corner in enumerate(form))
    if isinstance(form, Mapping) and "vertices" in form:
        check_keys(form, ("vertices", "faces"), (), "outline")
        vertices, faces = (
            [
                check_list(row, f"outline.{key}[{i}]")
                for i, row in enumerate(check_list(form[key], key))
            ]
            for key in ("vertices", "faces")
        )
        return Mesh(vertices, faces)
    if isinstance(form, Mapping) and "segments" in form:
        check_keys(form, ("segments",), (), "outline")
        return read_segments(form["segments"], "outline.segments")
    check_keys(form, ("centre", "radius"), (), "outline")
    return read_round(form, "outline")


def read_segments(form: Any, name: str) -> Segments:
    """Return thin walls from a list of pairs of points."""
    pairs = [check_list(x, f"{name}[{i}]", 2) for i, x in enumerate(check_list(form, name))]
    return Segments([[check_list(end, name, 2) for end in pair] for pair in pairs])


def read_round(form: Mapping[str, Any], name: str) -> Circle:
    """Return a circle, or a sphere where the centre has three coordinates."""
    centre = check_list(form["centre"], f"{name}.centre")
    return (Sphere if len(centre) == 3 else Circle)(centre, form["radius"])


def coordinates(values: Iterable[Any], name: str, dimension: int | None = None) -> RationalVector:
    """Return the rational coordinates of a vector in the plane or in space, or in one of them."""
    place = rational_vector(values, name)
    if len(place) not in ((2, 3) if dimension is None else (dimension,)):
        due = {None: "two, or three in space", 2: "two", 3: "three"}[dimension]
        raise GraspError(f"{name} has {len(place)} coordinates; give {due}")
    return place
