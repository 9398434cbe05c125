"""Contacts and grasps of an object in the plane or in space, exact and frozen.

Conventions (all in one object frame, counter-clockwise positive): the normal n points INTO the
object; a force f at the point p has the wrench ``(f, p x f)``. In the plane the tangent is n turned
by +90 degrees, ``t = (-n_y, n_x)``, ``a x b = a_x b_y - a_y b_x``, and a small motion
``d = (x, y, r)`` moves the contact point by ``N . d`` along the normal and ``T . d`` along the
tangent. In space a motion is ``d = (v, omega)``, and a contact has two tangents, t and ``n x t``;
t is given, or is the x axis turned by the smallest rotation that takes the z axis to n (no turn
where n is opposite to it).
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

# Its facade is loaded when a grasp is asked for its planes; the checker never does.
import arrangement
from arrangement.exact import (
    RationalVector,
    dot,
    number_text,
    rational,
    rational_vector,
    shown,
    to_text,
    vector_text,
)
from arrangement.io.files import check_keys, check_list
from arrangement.io.writing import write_text_atomically
from arrangement.linear import cross
from arrangement.plugins import InlinePage, display, inline_page
from arrangement.short_repr import Shown

from .errors import GraspError
from .outline import Circle, Mesh, Outline, Polygon, coordinates, read_outline
from .units import Units

if TYPE_CHECKING:
    from arrangement import Arrangement


@dataclass(frozen=True)
class Contact(Shown):
    """One frictional contact with a unilateral normal spring.

    Args:
        point: contact point p (length), two coordinates in the plane or three in space.
        normal: exactly unit, rational, pointing into the object; see `unit_normal`.
        friction: Coulomb coefficient, at least 0.
        stiffness: of the normal spring (force per length), above 0.
        preload: spring force at d = 0, at least 0.
        tangent: in space it may be chosen, exactly unit and at a right angle to the normal: the
            edges of friction pyramids and the planes of slip states start from it. In the plane
            it follows from the normal, whatever is given.

    Raises:
        GraspError: a normal that is not unit, or a number out of range.
        InputError: a float, or text that is not a number.

    >>> Contact(["-1", 0], [1, 0], "1/2").tangential_wrench
    (Fraction(0, 1), Fraction(1, 1), Fraction(-1, 1))
    """

    point: RationalVector
    normal: RationalVector
    friction: Fraction
    stiffness: Fraction = Fraction(1)
    preload: Fraction = Fraction(0)
    tangent: RationalVector = ()

    def __init__(
        self,
        point: Iterable[Any],
        normal: Iterable[Any],
        friction: Any,
        stiffness: Any = 1,
        preload: Any = 0,
        tangent: Iterable[Any] | None = None,
    ) -> None:
        place, inward = coordinates(point, "point"), _unit(normal)
        if len(place) != len(inward):
            raise GraspError(
                f"point has {len(place)} coordinates and normal has {len(inward)}; give two for "
                "both, in the plane, or three, in space"
            )
        values = {
            "point": place,
            "normal": inward,
            "friction": rational(friction, "friction"),
            "stiffness": rational(stiffness, "stiffness"),
            "preload": rational(preload, "preload"),
            "tangent": _tangent(inward)
            if tangent is None or len(inward) == 2
            else _checked_tangent(inward, tangent),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)
        for name in ("friction", "preload"):
            if getattr(self, name) < 0:
                raise GraspError(f"{name} is {shown(getattr(self, name))}; it must be at least 0")
        if self.stiffness <= 0:
            raise GraspError(f"stiffness is {shown(self.stiffness)}; it must be above 0")

    def __repr__(self) -> str:
        values = ", ".join(f"{name} {number_text(getattr(self, name))}" for name in VALUES)
        return (
            f"<Contact: at {vector_text(self.point)}, normal {vector_text(self.normal)}, {values}>"
        )

    @property
    def dimension(self) -> int:
        """Two in the plane, three in space."""
        return len(self.point)

    @property
    def tangents(self) -> tuple[RationalVector, ...]:
        """The tangent, in space with ``n x t``: a right-handed frame with the normal last."""
        if self.dimension == 2:
            return (self.tangent,)
        return self.tangent, cross(self.normal, self.tangent)

    @cached_property
    def normal_wrench(self) -> RationalVector:
        """N, the wrench of a unit force along the normal."""
        return _wrench(self.point, self.normal)

    @cached_property
    def tangential_wrench(self) -> RationalVector:
        """T, the wrench of a unit force along the tangent, in the plane.

        Raises:
            GraspError: a contact in space; see `tangential_wrenches`.
        """
        if self.dimension != 2:
            raise GraspError(_IN_SPACE)
        return self.tangential_wrenches[0]

    @cached_property
    def tangential_wrenches(self) -> tuple[RationalVector, ...]:
        """The wrenches of unit forces along `tangents`."""
        return tuple(_wrench(self.point, tangent) for tangent in self.tangents)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form of the contact; every number is a string."""
        names = ["point", "normal"]
        if self.tangent != _tangent(self.normal):
            names.append("tangent")
        vectors = {name: list(map(to_text, getattr(self, name))) for name in names}
        return vectors | {name: to_text(getattr(self, name)) for name in VALUES}


#: What a contact has besides its place.
VALUES = ("friction", "stiffness", "preload")
_REQUIRED, _OPTIONAL = ("point", "normal", "friction"), ("stiffness", "preload", "tangent")

#: The coordinates of the space of motions, in the plane and in space.
MOTIONS = ("x", "y", "r")
SPATIAL_MOTIONS = ("x", "y", "z", "r_x", "r_y", "r_z")
_FORCES = {2: "f_x, f_y and tau", 3: "f_x, f_y, f_z, tau_x, tau_y and tau_z"}
_PLACES = {2: "the plane", 3: "space"}
_IN_SPACE = (
    "this grasp is in space (three coordinates), and what was asked is known for grasps in the "
    "plane only; `equilibrium solve`, `verify`, `limit`, `margin`, `compare`, `modes` and some "
    "views of `draw` take both"
)


@dataclass(frozen=True)
class Grasp:
    """Finitely many contacts on one rigid object, all in the plane or all in space.

    None is allowed too, and is a grasp in the plane.

    Attributes:
        contacts: in the order given.
        units: what the numbers are measured in, if stated; a label that no comparison looks at.
        outline: the shape of the object, if stated; pictures show it as it is given, and no
            comparison or decision looks at it.
    """

    contacts: tuple[Contact, ...]
    units: Units | None = field(default=None, compare=False)
    outline: Outline | None = field(default=None, compare=False)

    def __init__(
        self,
        contacts: Iterable[Contact] = (),
        units: Units | None = None,
        outline: Outline | None = None,
    ) -> None:
        listed = tuple(contacts)
        for i, contact in enumerate(listed):
            if not isinstance(contact, Contact):
                raise GraspError(f"contacts[{i}] is {contact!r}; give Contact values")
        if units is not None and not isinstance(units, Units):
            raise GraspError(f"units is {shown(units)}; give a Units value or omit it")
        if outline is not None and not isinstance(outline, (Polygon, Circle, Mesh)):
            raise GraspError(
                f"outline is {shown(outline)}; give a Polygon, a Circle, a Mesh or omit it"
            )
        dimensions = [*(c.dimension for c in listed), *([outline.dimension] if outline else [])]
        for i, dimension in enumerate(dimensions):
            if dimension != dimensions[0]:
                name = f"contacts[{i}]" if i < len(listed) else "the outline"
                raise GraspError(
                    f"{name} is in {_PLACES[dimension]}, and contacts[0] in "
                    f"{_PLACES[dimensions[0]]}; a grasp has two coordinates everywhere, or three"
                )
        object.__setattr__(self, "contacts", listed)
        object.__setattr__(self, "units", units)
        object.__setattr__(self, "outline", outline)

    @cached_property
    def _hash(self) -> int:
        return hash(self.contacts)

    def __hash__(self) -> int:
        """Return the hash of the contacts, computed once: results are kept by grasp."""
        return self._hash

    def __repr__(self) -> str:
        number = f"{len(self)} contact" if len(self) == 1 else f"{len(self)} contacts"
        return f"<Grasp: {number}>"

    def __len__(self) -> int:
        return len(self.contacts)

    def __iter__(self) -> Iterator[Contact]:
        return iter(self.contacts)

    @property
    def dimension(self) -> int:
        """Two for a grasp in the plane, three in space."""
        return self.contacts[0].dimension if self.contacts else 2

    def require_plane(self) -> None:
        """Refuse a grasp in space, where a function knows the plane only.

        Raises:
            GraspError: the grasp is in space.
        """
        if self.dimension != 2:
            raise GraspError(_IN_SPACE)

    def in_space(self) -> Grasp:
        """Return a planar grasp in the plane z = 0 of space, with the same tangents.

        It resists ``(f_x, f_y, 0, 0, 0, tau)`` exactly when the planar grasp resists
        ``(f_x, f_y, tau)``. An outline is left out.
        """
        zero = Fraction(0)
        return Grasp(
            (
                Contact(
                    (*c.point, zero),
                    (*c.normal, zero),
                    c.friction,
                    c.stiffness,
                    c.preload,
                    (*c.tangent, zero),
                )
                for c in self
            ),
            self.units,
        )

    def tangential_arrangement(self) -> Arrangement:
        """Return the m planes ``T . d = 0`` in the space of motions d."""
        return arrangement.Arrangement(
            [c.tangential_wrench for c in self], dimension=3, axes=MOTIONS
        )

    def motion_arrangement(self) -> Arrangement:
        """Return the m planes ``T . d = 0``, then the m planes ``stiffness N . d = preload``."""
        normals = [tuple(c.stiffness * x for x in c.normal_wrench) for c in self]
        return arrangement.Arrangement(
            [c.tangential_wrench for c in self] + normals,
            [Fraction(0)] * len(self) + [c.preload for c in self],
            dimension=3,
            axes=MOTIONS,
        )

    def with_preload(self, preload: Any) -> Grasp:
        """Return the same grasp with one preload at every contact."""
        return self._with_each(preload=preload)

    def with_friction(self, friction: Any) -> Grasp:
        """Return the same grasp with one friction coefficient at every contact."""
        return self._with_each(friction=friction)

    def _with_each(self, **values: Any) -> Grasp:
        return replace(self, contacts=tuple(replace(contact, **values) for contact in self))

    def with_units(self, length: str, force: str) -> Grasp:
        """Return the same grasp with its units stated; no number changes."""
        return replace(self, units=Units(length, force))

    def with_outline(self, outline: Outline | None) -> Grasp:
        """Return the same grasp with the shape of its object stated, or with none."""
        return replace(self, outline=outline)

    def lab(self) -> InlinePage:
        """Return a page in which contacts and load are dragged; a notebook shows it in a cell.

        The command `equilibrium lab` writes the page to a file.

        Raises:
            InputError: more than 8 contacts, or contacts in space.
        """
        return inline_page("grasp-lab", self)

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the picture, where matplotlib is installed."""
        return display("grasp-svg", self) if self.dimension == 2 else None

    def to_dict(self) -> dict[str, Any]:
        """Return the file form (see `read_grasp`)."""
        labels = {"units": self.units, "outline": self.outline}
        stated = {name: label.to_dict() for name, label in labels.items() if label is not None}
        return {"schema_version": 1, **stated, "contacts": [c.to_dict() for c in self]}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the grasp as a JSON file, whole or not at all; `read_grasp` reads it back.

        Raises:
            InputError: the place cannot be written.
        """
        write_text_atomically(path, json.dumps(self.to_dict(), indent=1) + "\n")

    @classmethod
    def from_dict(cls, document: Mapping[str, Any]) -> Grasp:
        """Return the grasp of a document with exactly the keys of `to_dict`.

        In a contact, stiffness (1) and preload (0) may be omitted; in the grasp, units and
        outline.

        Raises:
            InputError: unknown or missing keys, an unknown schema version, wrong types.
        """
        optional = ("description", "units", "outline")
        check_keys(document, ("schema_version", "contacts"), optional, "the grasp")
        version = document["schema_version"]
        if type(version) is not int or version != 1:
            raise GraspError(f"schema_version is {version!r}; this version reads 1")
        contacts = check_list(document["contacts"], "contacts")
        units = Units.from_dict(document["units"]) if "units" in document else None
        outline = read_outline(document["outline"]) if "outline" in document else None
        return cls([_contact(entry, i) for i, entry in enumerate(contacts)], units, outline)


def read_wrench(values: Iterable[Any], dimension: int = 2) -> RationalVector:
    """Return an applied wrench as rationals: ``(f_x, f_y, tau)``, or six numbers in space."""
    wrench = rational_vector(values, "wrench")
    if len(wrench) != (3 if dimension == 2 else 6):
        entries = "1 entry" if len(wrench) == 1 else f"{len(wrench)} entries"
        raise GraspError(
            f"wrench has {entries}; a grasp in {_PLACES[dimension]} takes "
            f"{3 if dimension == 2 else 6}: {_FORCES[dimension]}"
        )
    return wrench


def wrench_of(
    force: Iterable[Any], point: Iterable[Any] | None = None, dimension: int = 2
) -> RationalVector:
    """Return the wrench of a force at a point, the origin if none is given."""
    along = coordinates(force, "force", dimension)
    place = coordinates([0] * dimension if point is None else point, "point", dimension)
    return _wrench(place, along)


def _contact(entry: Any, index: int) -> Contact:
    """Return one contact of a document; errors say which."""
    name = f"contacts[{index}]"
    check_keys(entry, _REQUIRED, _OPTIONAL, name)
    try:
        for key in ("point", "normal", "tangent"):
            check_list(entry.get(key, []), key)
        if "tangent" in entry and len(entry["normal"]) == 2:
            raise GraspError("in the plane the tangent follows from the normal; leave it out")
        return Contact(**entry)
    except ValueError as error:
        raise GraspError(f"{name}: {error}") from None


def _unit(values: Iterable[Any], name: str = "normal") -> RationalVector:
    """Return an exactly unit vector, or say how to get one."""
    vector = coordinates(values, name)
    if sum(x * x for x in vector) != 1:
        written = ", ".join(to_text(x)[:40] for x in vector)
        raise GraspError(
            f"{name} is ({written}), whose squared length is not exactly 1; "
            "unit_normal(direction, tolerance) returns an exactly unit rational vector, and the "
            "commands take --round-normals"
        )
    return vector


def _tangent(normal: RationalVector) -> RationalVector:
    """Return the tangent of a contact that states none."""
    if len(normal) == 2:
        return (-normal[1], normal[0])
    x, y, z = normal
    if z == -1:
        return (Fraction(1), Fraction(0), Fraction(0))
    return (1 - x * x / (1 + z), -x * y / (1 + z), -x)


def _checked_tangent(normal: RationalVector, values: Iterable[Any]) -> RationalVector:
    """Return a stated tangent."""
    tangent = _unit(values, "tangent")
    if len(tangent) != len(normal) or dot(tangent, normal):
        raise GraspError(
            f"tangent is {vector_text(tangent)}, which is not at a right angle to the normal "
            f"{vector_text(normal)}"
        )
    return tangent


def _wrench(point: RationalVector, force: RationalVector) -> RationalVector:
    """Return the wrench of a force at a point."""
    if len(point) == 3:
        return (*force, *cross(point, force))
    return (force[0], force[1], point[0] * force[1] - point[1] * force[0])
