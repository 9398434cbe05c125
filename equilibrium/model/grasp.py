"""Contacts and grasps of a planar object, exact and frozen.

Conventions (all in one object frame, counter-clockwise positive): the normal n points INTO the
object; the tangent is n turned by +90 degrees, ``t = (-n_y, n_x)``; a force f at the point p has
the wrench ``(f, p x f)`` with ``a x b = a_x b_y - a_y b_x``. A small motion ``d = (x, y, r)`` moves
the contact point by ``N . d`` along the normal and ``T . d`` along the tangent.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

# Its facade is loaded when a grasp is asked for its planes; the checker never does.
import arrangement
from arrangement.exact import (
    RationalVector,
    number_text,
    rational,
    rational_vector,
    shown,
    to_text,
    vector_text,
)
from arrangement.io.files import check_keys, check_list
from arrangement.io.writing import write_text_atomically
from arrangement.plugins import display
from arrangement.short_repr import Shown

from .errors import GraspError
from .outline import Circle, Outline, Polygon, pair, read_outline
from .units import Units

if TYPE_CHECKING:
    from arrangement import Arrangement


@dataclass(frozen=True)
class Contact(Shown):
    """One frictional contact with a unilateral normal spring.

    Args:
        point: contact point p (length).
        normal: exactly unit, rational, pointing into the object; see `unit_normal`.
        friction: Coulomb coefficient, at least 0.
        stiffness: of the normal spring (force per length), above 0.
        preload: spring force at d = 0, at least 0.

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

    def __init__(
        self,
        point: Iterable[Any],
        normal: Iterable[Any],
        friction: Any,
        stiffness: Any = 1,
        preload: Any = 0,
    ) -> None:
        values = {
            "point": pair(point, "point"),
            "normal": _unit(normal),
            "friction": rational(friction, "friction"),
            "stiffness": rational(stiffness, "stiffness"),
            "preload": rational(preload, "preload"),
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
    def tangent(self) -> RationalVector:
        """The normal turned by +90 degrees."""
        return (-self.normal[1], self.normal[0])

    @cached_property
    def normal_wrench(self) -> RationalVector:
        """N, the wrench of a unit force along the normal."""
        return _wrench(self.point, self.normal)

    @cached_property
    def tangential_wrench(self) -> RationalVector:
        """T, the wrench of a unit force along the tangent."""
        return _wrench(self.point, self.tangent)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form of the contact; every number is a string."""
        pairs = {name: list(map(to_text, getattr(self, name))) for name in _REQUIRED[:2]}
        return pairs | {name: to_text(getattr(self, name)) for name in VALUES}


_REQUIRED = tuple(f.name for f in fields(Contact) if f.default is MISSING)
_OPTIONAL = tuple(f.name for f in fields(Contact) if f.default is not MISSING)
#: What a contact has besides its place: friction, stiffness and preload.
VALUES = (*_REQUIRED[2:], *_OPTIONAL)


#: The coordinates of the space of motions.
MOTIONS = ("x", "y", "r")


@dataclass(frozen=True)
class Grasp:
    """Finitely many contacts on one rigid planar object; none is allowed too.

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
        if outline is not None and not isinstance(outline, (Polygon, Circle)):
            raise GraspError(f"outline is {shown(outline)}; give a Polygon, a Circle or omit it")
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

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the picture, where matplotlib is installed."""
        return display("grasp-svg", self)

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


def read_wrench(values: Iterable[Any]) -> RationalVector:
    """Return an applied wrench ``(f_x, f_y, tau)`` as three rationals."""
    wrench = rational_vector(values, "wrench")
    if len(wrench) != 3:
        raise GraspError(f"wrench has {len(wrench)} entries; give f_x, f_y and tau")
    return wrench


def _contact(entry: Any, index: int) -> Contact:
    """Return one contact of a document; errors say which."""
    name = f"contacts[{index}]"
    check_keys(entry, _REQUIRED, _OPTIONAL, name)
    try:
        for key in ("point", "normal"):
            check_list(entry[key], key)
        return Contact(**entry)
    except ValueError as error:
        raise GraspError(f"{name}: {error}") from None


def _unit(values: Iterable[Any]) -> RationalVector:
    """Return an exactly unit normal, or say how to get one."""
    normal = pair(values, "normal")
    square = normal[0] ** 2 + normal[1] ** 2
    if square != 1:
        written = ", ".join(to_text(x)[:40] for x in normal)
        raise GraspError(
            f"normal is ({written}), whose squared length is not exactly 1; "
            "unit_normal(direction, tolerance) returns an exactly unit rational vector, and the "
            "commands take --round-normals"
        )
    return normal


def _wrench(point: RationalVector, force: RationalVector) -> RationalVector:
    """Return the wrench of a force at a point."""
    return (force[0], force[1], point[0] * force[1] - point[1] * force[0])
