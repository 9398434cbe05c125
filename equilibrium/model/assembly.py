"""Assemblies: several rigid bodies in the plane, in contact with each other and with the ground.

All points, normals and torques are in one world frame with one origin. The motion d in R^(3b) has
three numbers (x, y, r) for each body. A contact has N and T of `equilibrium.model.contact` in the
numbers of body_a, into which the normal points, and their negatives in those of body_b; the ground
is fixed and has no numbers. So the forces on the two bodies are opposite, and N . d and T . d are
the displacement of one body relative to the other.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

from arrangement.console.number_form import counted
from arrangement.console.plugins import method_code
from arrangement.console.writing import write_text_atomically
from arrangement.hints import HintsMixin
from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import RationalVector, rational, rational_vector, shown, to_text

from .contact import VALUES, Contact, contact_of
from .errors import GraspError
from .grasp import (
    ContactValuesMixin,
    Grasp,
    ask_contacts,
    check_version,
    read_labels,
    wrench_of,
)
from .labels import DataError, Units
from .outline import Outline, centroid, coordinates, read_outline
from .rows import TURNS, ContactRow, ContactRows

#: How many numbers a body has.
SIZE = 3
_MAX_NAME = 40
_ZERO = (Fraction(0),) * SIZE
#: A wrench for each body.
Wrenches = dict[str, RationalVector]


@dataclass(frozen=True)
class RigidBody(HintsMixin):
    """One rigid body.

    Attributes:
        name: by which contacts and wrenches refer to it.
        outline: a `Polygon`, a `Circle` or `Segments`, for pictures; no decision looks at it.
        weight: downwards, for `Assembly.weights`; no decision looks at it.
        centre: where the weight acts; None: in the centroid of the outline.
    """

    name: str
    outline: Outline | None = field(default=None, compare=False)
    weight: Fraction = field(default=Fraction(0), compare=False)
    centre: RationalVector | None = field(default=None, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "weight", rational(self.weight, "the weight"))
        if self.centre is not None:
            where = f"the centre of {self.name}"
            object.__setattr__(self, "centre", coordinates(self.centre, where, 2))
        if not isinstance(self.name, str) or not 0 < len(self.name) <= _MAX_NAME:
            raise GraspError(
                f"the name of a body is {shown(self.name)}; expected 1 to {_MAX_NAME} characters"
            )
        if not self.name.isprintable() or self.name != self.name.strip():
            raise GraspError(
                f"the name of a body is {shown(self.name)}; expected no control characters and "
                "no spaces at the ends"
            )
        if self.outline is not None:
            _check_plane(self.outline, f"the outline of {self.name}")
        if self.weight and self.centre is None:
            _ = self.middle  # is there one?

    @property
    def middle(self) -> RationalVector:
        """The centre, where the weight acts; by default the centroid of the outline.

        Raises:
            GraspError: there is neither.
        """
        if self.centre is not None:
            return self.centre
        if self.outline is None:
            raise GraspError(f"{self.name} has neither centre nor outline; expected one of them")
        try:
            return centroid(self.outline)
        except GraspError as error:
            raise GraspError(f"{self.name}: {error}") from None

    @property
    def weight_wrench(self) -> RationalVector:
        """The wrench of the weight."""
        if not self.weight:
            return _ZERO
        return wrench_of((0, -self.weight), self.middle)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form."""
        known: dict[str, Any] = {"name": self.name}
        if self.outline is not None:
            known["outline"] = self.outline.to_dict()
        if self.weight:
            known["weight"] = to_text(self.weight)
        if self.centre is not None:
            known["centre"] = list(map(to_text, self.centre))
        return known

    @classmethod
    def from_dict(cls, entry: Any, where: str = "the body") -> RigidBody:
        """Return the body of a name, or of an object with a name and maybe more."""
        if not isinstance(entry, Mapping):
            return cls(entry)
        check_keys(entry, ("name",), ("outline", "weight", "centre"), where)
        outline = read_outline(entry["outline"]) if "outline" in entry else None
        centre = check_list(entry["centre"], f"{where}: centre", 2) if "centre" in entry else None
        return cls(entry["name"], outline, entry.get("weight", 0), centre)  # type: ignore[arg-type]


def _check_plane(outline: Any, name: str) -> None:
    if not isinstance(outline, Outline) or outline.dimension != 2:
        raise GraspError(
            f"{name} is {shown(outline)}; expected a Polygon, a Circle or Segments in the plane"
        )


@dataclass(frozen=True)
class BodyContact(HintsMixin):
    """One contact between two bodies, or of a body with the ground.

    Attributes:
        body_a: the body into which the normal points.
        body_b: the other body; None for the ground.
        contact: point, normal, friction, stiffness and preload, in the world frame.
    """

    body_a: str
    body_b: str | None
    contact: Contact

    def __post_init__(self) -> None:
        for name in (self.body_a, *([] if self.body_b is None else [self.body_b])):
            if not isinstance(name, str):
                raise GraspError(f"a body of a contact is {shown(name)}; expected a name")
        if not isinstance(self.contact, Contact) or self.contact.dimension != 2:
            raise GraspError(
                f"the contact between bodies is {shown(self.contact)}; expected a Contact in the "
                "plane"
            )
        if self.contact.share != 1:
            raise GraspError(
                f"share is {shown(self.contact.share)}; pads are of one body, so it must be 1 "
                "between bodies"
            )
        if self.body_a == self.body_b:
            raise GraspError(
                f"body_a and body_b are both {shown(self.body_a)}; expected two bodies, or None "
                "(null) for the ground as body_b"
            )

    @property
    def pair(self) -> str:
        """The two bodies in words."""
        return f"{self.body_a} on {self.body_b or 'the ground'}"

    @property
    def reversed(self) -> BodyContact:
        """The same contact with the bodies exchanged and the normal turned round.

        Raises:
            GraspError: body_b is the ground, which has no numbers.
        """
        if self.body_b is None:
            raise GraspError("body_b is the ground; expected a body to exchange with body_a")
        c = self.contact
        turned = replace(c, normal=tuple(-x for x in c.normal))
        return BodyContact(self.body_b, self.body_a, turned)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form."""
        return {"body_a": self.body_a, "body_b": self.body_b, **self.contact.to_dict()}

    @classmethod
    def from_dict(cls, entry: Any, index: int) -> BodyContact:
        """Return the contact of a file form."""
        where = f"contacts[{index}]"
        if not isinstance(entry, Mapping):
            raise GraspError(f"{where} is {shown(entry)}; expected an object")
        rest = {key: x for key, x in entry.items() if key not in ("body_a", "body_b")}
        for key in ("body_a", "body_b"):
            if key not in entry:
                raise GraspError(
                    f'{where} has no key "{key}"; expected a body, or null for the ground as body_b'
                )
            if not isinstance(entry[key], str) and (key == "body_a" or entry[key] is not None):
                raise GraspError(f"{where}: {key} is {shown(entry[key])}; expected a body's name")
        try:
            return cls(entry["body_a"], entry["body_b"], contact_of(rest, index))
        except GraspError as error:
            text = str(error)
            raise GraspError(text if text.startswith(where) else f"{where}: {text}") from None


@dataclass(frozen=True)
class Assembly(ContactValuesMixin):
    """Finitely many rigid bodies in the plane, and the contacts among them and with the ground.

    Args:
        bodies: names or `RigidBody` values, each name once.
        contacts: `BodyContact` values; none need touch a body.
        units: what the numbers are measured in, if stated.
        data_error: of the data that were rounded to these contacts, if any; no comparison looks at
            it.
        ground: the shapes of the ground, as outlines, for pictures; no comparison looks at them.

    Raises:
        GraspError: a name twice, or a contact of a body that is not one of them.

    >>> floor = Contact([0, 0], [0, 1], "1/2")
    >>> Assembly(["block"], [BodyContact("block", None, floor)])
    <Assembly: 1 body, 1 contact>
    """

    bodies: tuple[RigidBody, ...]
    contacts: tuple[BodyContact, ...]
    units: Units | None = field(default=None, compare=False)
    data_error: DataError | None = field(default=None, compare=False)
    ground: tuple[Outline, ...] = field(default=(), compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = {
        "along": "ResistedSet(assembly).along(wrenches)",
        "compare": "compare(assembly, wrenches)",
        "margin": "ResistedSet(assembly).margin(wrenches)",
        "modes": "ContactModes.of_grasp(assembly)",
        "solve": "solve(assembly, wrenches)",
    }

    def __init__(
        self,
        bodies: Iterable[str | RigidBody],
        contacts: Iterable[BodyContact] = (),
        units: Units | None = None,
        data_error: DataError | None = None,
        ground: Iterable[Outline] = (),
    ) -> None:
        listed = tuple(
            body if isinstance(body, RigidBody) else RigidBody(body)
            for body in entries(bodies, "bodies", "names")
        )
        touching = tuple(entries(contacts, "contacts", "BodyContact values"))
        known: set[str] = set()
        for body in listed:
            if body.name in known:
                raise GraspError(f"the body {body.name} is there twice; expected each name once")
            known.add(body.name)
        for i, contact in enumerate(touching):
            if not isinstance(contact, BodyContact):
                raise GraspError(f"contacts[{i}] is {shown(contact)}; expected BodyContact values")
            for name in (contact.body_a, contact.body_b):
                if name is not None and name not in known:
                    raise GraspError(
                        f"contacts[{i}] is with {shown(name)}; expected one of the bodies "
                        f"{', '.join(known) or '(there are none)'}, or null for the ground"
                    )
        if units is not None and not isinstance(units, Units):
            raise GraspError(f"units is {shown(units)}; expected a Units value or None")
        object.__setattr__(self, "bodies", listed)
        object.__setattr__(self, "contacts", touching)
        object.__setattr__(self, "units", units)
        object.__setattr__(self, "data_error", data_error)
        object.__setattr__(self, "ground", tuple(entries(ground, "ground", "outlines")))
        for i, outline in enumerate(self.ground):
            _check_plane(outline, f"ground[{i}]")

    def __repr__(self) -> str:
        bodies = counted(len(self.bodies), "body", "bodies")
        return f"<Assembly: {bodies}, {counted(len(self.contacts), 'contact')}>"

    def __len__(self) -> int:
        return len(self.contacts)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the bodies."""
        return tuple(body.name for body in self.bodies)

    @cached_property
    def rows(self) -> ContactRows:
        """N and T of each contact in R^(3b), with three numbers a body in the order of `bodies`."""
        names, rows = self.names, []
        for c in self.contacts:

            def lifted(wrench: RationalVector, c: BodyContact = c) -> RationalVector:
                parts = {c.body_a: wrench, c.body_b: tuple(-x for x in wrench)}
                return tuple(x for name in names for x in parts.get(name, _ZERO))

            contact = c.contact
            tangents = tuple(map(lifted, contact.tangential_wrenches))
            values = (getattr(contact, name) for name in VALUES)
            rows.append(ContactRow(lifted(contact.normal_wrench), tangents, *values))
        points = tuple(c.contact.point for c in self.contacts)
        return ContactRows(tuple(rows), points, TURNS[2] * len(names), 1)

    @property
    def weights(self) -> Wrenches:
        """The wrench of the weight of each body."""
        return {body.name: body.weight_wrench for body in self.bodies}

    @classmethod
    def from_polygons(cls, polygons: Mapping[str, Any], friction: Any, **options: Any) -> Assembly:
        """Return the bodies of polygons that touch, with a contact wherever they do.

        Args:
            polygons: the corners of each body, by name.
            friction: of all contacts.
            options: ground, stiffness, preload, density, angle_tolerance; see
                `equilibrium.grasps.inputs.touching`.

        Raises:
            GraspError: polygons overlap, or an edge in touch has no exact unit normal.

        >>> block = [[0, 0], [2, 0], [2, 1], [0, 1]]
        >>> floor = [[-5, -1], [5, -1], [5, 0], [-5, 0]]
        >>> made = Assembly.from_polygons({"block": block}, "1/2", ground=[floor], density=1)
        >>> made, [str(x) for x in made.weights["block"]]
        (<Assembly: 1 body, 2 contacts>, ['0', '-2', '-2'])
        """
        made: Assembly = method_code("Assembly.from_polygons")(polygons, friction, **options)
        return made

    @classmethod
    def of_grasp(cls, grasp: Grasp, name: str = "object") -> Assembly:
        """Return the one body of a grasp in the plane, whose contacts are all with the ground.

        Raises:
            GraspError: the grasp is in space.
        """
        grasp.require_plane()
        outline: Any = grasp.outline
        return cls(
            [RigidBody(name, outline)],
            [BodyContact(name, None, c) for c in grasp],
            grasp.units,
            grasp.data_error,
        )

    @staticmethod
    def _changed(entry: BodyContact, change: Callable[[Contact], Contact]) -> BodyContact:
        return replace(entry, contact=change(entry.contact))

    def to_dict(self, wrenches: Any = None) -> dict[str, Any]:
        """Return the file form, with wrenches on the bodies if given; every number is a string."""
        document = self._labels() | {
            "bodies": [body.to_dict() for body in self.bodies],
            "contacts": [contact.to_dict() for contact in self.contacts],
        }
        if self.ground:
            document["ground"] = [outline.to_dict() for outline in self.ground]
        if wrenches is not None:
            read = self.read_wrenches(wrenches)
            document["wrench"] = {name: list(map(to_text, w)) for name, w in read.items()}
        return document

    def save(self, path: str | os.PathLike[str], wrenches: Any = None) -> None:
        """Write a JSON file, whole or not at all; `read_assembly` reads it back.

        Args:
            wrenches: for each body, written along.

        Raises:
            InputError: the place cannot be written.
        """
        document = self.to_dict(wrenches)
        write_text_atomically(path, json.dumps(document, indent=1) + "\n")

    @classmethod
    def from_dict(cls, document: Mapping[str, Any]) -> Assembly:
        """Return the assembly of a document with the keys of `to_dict`.

        A ``wrench`` for each body may stand there, see `wrenches_of`; in a contact stiffness (1)
        and preload (0) may be omitted.

        Raises:
            InputError: unknown or missing keys, an unknown schema version, wrong types.
        """
        optional = ("schema_version", "description", "units", "data_error", "wrench", "ground")
        check_keys(document, ("bodies", "contacts"), optional, "the assembly")
        check_version(document)
        listed = check_list(document["bodies"], "bodies")
        bodies = [RigidBody.from_dict(entry, f"bodies[{i}]") for i, entry in enumerate(listed)]
        rows = check_list(document["contacts"], "contacts")
        ask_contacts(len(bodies) + len(rows))
        contacts = [BodyContact.from_dict(entry, i) for i, entry in enumerate(rows)]
        labels = read_labels(document)
        ground = map(read_outline, check_list(document.get("ground", []), "ground"))
        return cls(bodies, contacts, ground=ground, **labels)

    def read_wrenches(self, wrenches: Any) -> Wrenches:
        """Return a wrench for each body, zero where none is given.

        Args:
            wrenches: by the names of bodies, ``(f_x, f_y, tau)`` with the torque about the one
                origin of the world frame.

        Raises:
            GraspError: a name that is no body, or not three numbers.
        """
        if not isinstance(wrenches, Mapping):
            raise GraspError(
                f"the wrenches are {shown(wrenches)}; expected a mapping such as "
                '{"block": [0, -1, 0]}'
            )
        names = self.names
        by_name: Wrenches = dict.fromkeys(names, _ZERO)
        for name, wrench in wrenches.items():
            if name not in by_name:
                raise GraspError(
                    f"there is a wrench on {shown(name)}; expected one of the bodies "
                    f"{', '.join(names) or '(there are none)'}"
                )
            by_name[name] = rational_vector(wrench, f"the wrench on {name}")
            if len(by_name[name]) != SIZE:
                raise GraspError(
                    f"the wrench on {name} has {counted(len(by_name[name]), 'entry', 'entries')}; "
                    "expected three: f_x, f_y and tau"
                )
        return by_name


def wrenches_of(document: Mapping[str, Any]) -> Mapping[str, Any] | None:
    """Return the wrenches of the document of an assembly: those that stand there, else its weights.

    None if there are neither.

    Raises:
        InputError: they are not an object.
    """
    if "wrench" not in document:
        assembly = Assembly.from_dict(document)
        return assembly.weights if any(body.weight for body in assembly.bodies) else None
    wrenches = check_keys(document["wrench"], (), document["wrench"], "wrench")
    return {name: check_list(row, f"wrench.{name}", SIZE) for name, row in wrenches.items()}
