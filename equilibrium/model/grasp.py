"""Grasps: contacts on one rigid object; `equilibrium.model.contact` has the conventions."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Self

# Its facade is loaded when a grasp is asked for its planes; the checker never does.
import arrangement
from arrangement.console.number_form import counted
from arrangement.console.plugins import method_code
from arrangement.console.writing import write_text_atomically
from arrangement.errors import missing_item
from arrangement.hints import HintsMixin, hints_on_assignment
from arrangement.library.files.json_files import check_all, check_keys, check_list
from arrangement.numbers import budget
from arrangement.numbers.arguments import entries, whole
from arrangement.numbers.exact import RationalVector, dot, rational, rational_vector, shown
from arrangement.numbers.linear.rank import cross
from arrangement.synonyms import PAGES, PICTURES, by_word

from .contact import (
    IN_SPACE,
    WRENCH_SIZES,
    Contact,
    adhesion_wrench,
    check_contacts,
    contact_of,
    groups_of,
    joined,
    spread,
    wrench_at,
)
from .drawable import DrawableGrasp
from .errors import GraspError
from .labels import DataError, Units
from .outline import Circle, Mesh, Outline, Polygon, coordinates, read_outline
from .synonyms import NAMES

if TYPE_CHECKING:
    from arrangement import Arrangement


#: The coordinates of the space of motions in the plane.
MOTIONS = ("x", "y", "r")
_FORCES = {2: "f_x, f_y and tau", 3: "f_x, f_y, f_z, tau_x, tau_y and tau_z"}
#: Keys that documents do not have, with what to write.
_OTHER_KEYS = {
    **dict.fromkeys(
        ("load", "loads", "force", "forces", "wrench", "wrenches", "weight", "gravity"),
        "A load is the key wrench of a file, such as [0, -1, 0], or an option: --wrench F_X F_Y "
        "TAU, --force F_X F_Y or --weight W",
    ),
    **dict.fromkeys(
        ("friction", "mu", "preload", "stiffness"),
        "Friction, stiffness and preload are keys of each contact",
    ),
}
_PLACES = {2: "the plane", 3: "space"}
#: What documents state besides contacts, and how it is read.
_LABELS: Mapping[str, Callable[[Any], Any]] = {
    "units": Units.from_dict,
    "outline": read_outline,
    "data_error": DataError.from_dict,
}


def ask_contacts(count: int) -> None:
    """Refuse more contacts than any question can be answered for."""
    budget.check_cost(f"{count:,} contacts", "leave out contacts", steps=5000 * count)


class ContactValuesMixin(HintsMixin):
    """Contacts by their numbers, and copies with other values of some of them."""

    contacts: tuple[Any, ...]

    @property
    def groups(self) -> tuple[range, ...]:
        """Where the points of each contact are among `contacts`: one, of a pad several."""
        return tuple(range(i, i + 1) for i in range(len(self.contacts)))

    @property
    def contact_numbers(self) -> range:
        """The numbers of the contacts, from 1; a pad has one."""
        return range(1, len(self.groups) + 1)

    def points_of(self, numbers: Iterable[int]) -> frozenset[int]:
        """Return the places in `contacts` of the points of contacts by their numbers, from 1.

        Raises:
            GraspError: no such contact.
        """
        chosen = chosen_contacts(numbers, len(self.groups))
        return frozenset(i for k in chosen for i in self.groups[k - 1])

    def with_preload(self, preload: Any, contacts: Iterable[int] | None = None) -> Self:
        """Return the same bodies with one preload at every contact, which a pad shares out.

        Args:
            contacts: numbers, from 1, of those that get it; the others keep their own.

        Raises:
            GraspError: no such contact.
        """
        return self._with_each("preload", preload, contacts)

    def with_friction(self, friction: Any, contacts: Iterable[int] | None = None) -> Self:
        """Return the same bodies with one friction coefficient at every contact.

        Args:
            contacts: numbers, from 1, of those that get it; the others keep their own.

        Raises:
            GraspError: no such contact.
        """
        return self._with_each("friction", friction, contacts)

    def with_adhesion(self, adhesion: Any) -> Self:
        """Return the same bodies with one adhesion at every contact, which a pad shares out."""
        return self._with_each("adhesion", adhesion)

    def _with_each(self, name: str, value: Any, contacts: Iterable[int] | None = None) -> Self:
        whole = rational(value, name)
        chosen = self.points_of(self.contact_numbers if contacts is None else contacts)

        def changed(point: Contact) -> Contact:
            own: dict[str, Any] = {name: whole if name == "friction" else point.share * whole}
            return replace(point, **own)

        pairs = enumerate(self.contacts)
        entries = tuple(self._changed(c, changed) if i in chosen else c for i, c in pairs)
        return replace(self, contacts=entries)  # type: ignore[type-var]

    def _labels(self) -> dict[str, Any]:
        """Return the beginning of the file form."""
        labels = ((name, getattr(self, name, None)) for name in _LABELS)
        stated = {name: label.to_dict() for name, label in labels if label is not None}
        return {"schema_version": 1, **stated}

    @staticmethod
    def _changed(entry: Any, change: Callable[[Contact], Contact]) -> Any:
        """Return an entry of `contacts` with its contact changed."""
        return change(entry)


@hints_on_assignment
@dataclass(frozen=True)
class Grasp(ContactValuesMixin, DrawableGrasp):
    """Finitely many contacts on one rigid object, all in the plane or all in space.

    None is allowed too, and is a grasp in the plane.

    Attributes:
        contacts: `Contact` values (`equilibrium.inputs.from_float_data` takes arrays), in the order
            given; a pad is several of them, its points, see `groups`.
        units: what the numbers are measured in, if stated; a label that no comparison looks at.
        outline: the shape of the object, if stated; pictures show it as it is given, and no
            comparison or decision looks at it.
        data_error: of the data that were rounded to this grasp, if any; no comparison looks at it.
    """

    contacts: tuple[Contact, ...]
    units: Units | None = field(default=None, compare=False)
    outline: Outline | None = field(default=None, compare=False)
    data_error: DataError | None = field(default=None, compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = {
        **NAMES,
        **PICTURES,
        **PAGES,
        **by_word("""
            from_arrays from_floats -> inputs.from_float_data(points, normals, friction).grasp
            from_numpy from_points -> inputs.from_float_data(points, normals, friction).grasp
            from_dataframe from_pandas -> inputs.from_float_data(points, normals, friction).grasp
            from_mesh from_stl -> inputs.on_mesh(path, friction, at=points).grasp
            from_polygon -> inputs.from_polygon(vertices, places, friction).grasp
            max_force max_load max_wrench maximum_load -> ResistedSet(grasp).along(wrench).intervals
            min_friction minimum_friction -> sufficient_friction(grasp, contacts, wrench)
            min_preload minimum_preload -> ResistedSet(grasp).margin(wrench).preloads
            plot_region plot_resisted plot_resisted_region plot_resisted_set -> draw('resist')
            from_csv from_file from_json load read -> read_grasp(path)
            export to_csv -> save(path)
            add add_contact append -> Grasp([*grasp.contacts, contact])
            grasp_quality metric quality -> GraspWrenchSpace(grasp).epsilon
            is_force_closure -> GraspWrenchSpace(grasp).force_closure
            is_stable resists -> solve(grasp, wrench).stable
            modes -> ContactModes.of_grasp(grasp)
            n_contacts -> len(grasp)
            planes -> tangential_arrangement() or motion_arrangement()
            resisted -> ResistedSet(grasp).along(wrench)
            resisted_set -> ResistedSet(grasp)
            to_dataframe to_pandas -> pandas.DataFrame([c.to_dict() for c in grasp])
            wrench_space -> GraspWrenchSpace(grasp)
        """),
    }
    _main: ClassVar[Mapping[str, str]] = {
        "describe": "contacts dimension units outline",
        "change": "with_friction with_preload with_adhesion",
        "show and save": "draw lab save to_dict tangential_arrangement motion_arrangement",
    }

    def __init__(
        self,
        contacts: Iterable[Contact] = (),
        units: Units | None = None,
        outline: Outline | None = None,
        data_error: DataError | None = None,
    ) -> None:
        if isinstance(contacts, (str, os.PathLike)):
            raise GraspError(f"contacts is {shown(contacts)}; write read_grasp({contacts!r})")
        listed = entries(contacts, "contacts", "Contact values, [first, second]")
        for i, contact in enumerate(listed):
            if not isinstance(contact, Contact):
                raise GraspError(
                    f"contacts[{i}] is {shown(contact)}; write Contact(point, normal, friction) "
                    "for each, or for arrays equilibrium.inputs.from_float_data(points, normals, "
                    "friction).grasp"
                )
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
        groups_of(listed)
        object.__setattr__(self, "contacts", listed)
        object.__setattr__(self, "units", units)
        object.__setattr__(self, "outline", outline)
        object.__setattr__(self, "data_error", data_error)

    @cached_property
    def _hash(self) -> int:
        return hash(self.contacts)

    def __hash__(self) -> int:
        """Return the hash of the contacts, computed once: results are kept by grasp."""
        return self._hash

    def __repr__(self) -> str:
        return f"<Grasp: {self.size_words}>"

    def __len__(self) -> int:
        return len(self.contacts)

    def __iter__(self) -> Iterator[Contact]:
        return iter(self.contacts)

    def __getitem__(self, index: int) -> Contact:
        """Return a contact, or a point of a pad, by its place in `contacts` from 0."""
        try:
            return self.contacts[index]
        except (IndexError, TypeError):
            raise missing_item("contact", index, len(self)) from None

    @cached_property
    def groups(self) -> tuple[range, ...]:
        """Where the points of each contact are among `contacts`: one, of a pad several.

        A pad is one contact wherever contacts are counted or numbered.

        >>> halves = [Contact([x, 0], [0, 1], 1, share="1/2") for x in (0, 1)]
        >>> Grasp([*halves, Contact([0, 1], [0, -1], 1)]).groups
        (range(0, 2), range(2, 3))
        """
        return groups_of(self.contacts)

    @cached_property
    def parts(self) -> tuple[tuple[Contact, ...], ...]:
        """The points of each contact, by `groups`."""
        return tuple(self.contacts[group.start : group.stop] for group in self.groups)

    @property
    def has_pads(self) -> bool:
        """Whether some contact is a pad, of several points."""
        return len(self.groups) < len(self.contacts)

    @property
    def size_words(self) -> str:
        """The number of contacts in words; with pads, that of points, too."""
        points = f" ({counted(len(self), 'point')})" if self.has_pads else ""
        return counted(len(self.groups), "contact") + points

    @cached_property
    def point_names(self) -> tuple[str, ...]:
        """The names of `contacts`: "contact 1", or of the points of a pad "contact 1, point 2"."""
        return tuple(
            f"contact {k}" + (f", point {j}" if len(group) > 1 else "")
            for k, group in enumerate(self.groups, 1)
            for j in range(1, len(group) + 1)
        )

    def joined(self) -> Grasp:
        """Return the grasp with each pad as one contact in its middle."""
        if not self.has_pads:
            return self
        return replace(self, contacts=tuple(map(joined, self.parts)))

    def without_pads(self) -> Grasp:
        """Return the grasp with each point of a pad as a contact of its own."""
        one = Fraction(1)
        return replace(self, contacts=tuple(replace(contact, share=one) for contact in self))

    def spread(self, moved: Iterable[Contact]) -> Grasp:
        """Return the grasp after its contacts, as `joined` has them, have changed.

        Args:
            moved: one contact for each of `groups`; points of a pad move and turn with it.
        """
        pairs = zip(self.parts, moved, strict=True)
        return Grasp(c for points, contact in pairs for c in spread(points, contact))

    @property
    def dimension(self) -> int:
        """Two for a grasp in the plane, three in space."""
        return self.contacts[0].dimension if self.contacts else 2

    @property
    def wrench_size(self) -> int:
        """How many numbers a wrench on it has: three in the plane, six in space."""
        return WRENCH_SIZES[self.dimension]

    @cached_property
    def adhesion_wrench(self) -> RationalVector:
        """The wrench of all adhesion, ``-sum adhesion N``; it acts besides every load."""
        return adhesion_wrench(self, self.wrench_size)

    def total_load(self, wrench: Iterable[Fraction]) -> RationalVector:
        """Return a wrench and that of the adhesion together: what springs and friction balance."""
        return tuple(x + y for x, y in zip(wrench, self.adhesion_wrench, strict=True))

    def read_wrench(self, values: Iterable[Any]) -> RationalVector:
        """Return an applied wrench as rationals: ``(f_x, f_y, tau)``, or six numbers in space.

        Raises:
            GraspError: it has another length.
        """
        return read_wrench(values, self.dimension)

    def require_plane(self) -> None:
        """Refuse a grasp in space, where a function knows the plane only.

        Raises:
            GraspError: the grasp is in space.
        """
        if self.dimension != 2:
            raise GraspError(IN_SPACE)

    def in_space(self) -> Grasp:
        """Return a planar grasp in the plane z = 0 of space, with the same tangents.

        It resists ``(f_x, f_y, 0, 0, 0, tau)`` exactly when the planar grasp resists
        ``(f_x, f_y, tau)``. An outline is left out.
        """
        zero = Fraction(0)

        def lifted(c: Contact) -> Contact:
            vectors = (*c.point, zero), (*c.normal, zero), (*c.tangent, zero)
            return replace(c, point=vectors[0], normal=vectors[1], tangent=vectors[2], thread=())

        return Grasp(map(lifted, self), self.units)

    def tangential_arrangement(self) -> Arrangement:
        """Return the m planes ``T . d = 0`` in the space of motions d."""
        return arrangement.Arrangement(
            [c.tangential_wrench for c in self], dimension=3, axes=MOTIONS
        )

    def motion_arrangement(self) -> Arrangement:
        """Return the m planes ``T . d = 0``, then the m planes ``stiffness N . d = preload``.

        For a contact of constant force (stiffness 0), whose force no motion changes, the second
        plane is the first one again.
        """
        pairs = [
            (tuple(c.stiffness * x for x in c.normal_wrench), c.preload)
            if c.stiffness
            else (c.tangential_wrench, Fraction(0))
            for c in self
        ]
        return arrangement.Arrangement(
            [c.tangential_wrench for c in self] + [normal for normal, _ in pairs],
            [Fraction(0)] * len(self) + [offset for _, offset in pairs],
            dimension=3,
            axes=MOTIONS,
        )

    def with_units(self, length: str, force: str) -> Grasp:
        """Return the same grasp with its units stated; no number changes."""
        return replace(self, units=Units(length, force))

    def with_outline(self, outline: Outline | None) -> Grasp:
        """Return the same grasp with the shape of its object stated, or with none."""
        return replace(self, outline=outline)

    def lab(self) -> Any:
        """Return a page to drag contacts in a notebook; `equilibrium lab` writes it to a file.

        With anywidget (the extra notebook) its attributes `grasp` and `wrench` are what it shows.

        Raises:
            InputError: more than 8 contacts, or contacts in space.
        """
        return method_code("Grasp.lab")(self)

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the picture, where matplotlib is installed."""
        text: str | None = method_code("Grasp._repr_svg_")(self)
        return text

    def to_dict(self) -> dict[str, Any]:
        """Return the file form (see `read_grasp`)."""
        return self._labels() | {"contacts": [c.to_dict() for c in self]}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file, whole or not at all, which `read_grasp` reads: ``.json``, or ``.csv``.

        Raises:
            InputError: another ending, a grasp with more than a table holds, or a place that cannot
                be written.
        """
        ending = Path(os.fsdecode(path)).suffix.lower()
        if ending not in (".json", ".csv"):
            raise GraspError(f"the file name ends in {shown(ending)}; expected .json or .csv")
        if ending == ".csv":
            text: str = method_code("Grasp.save")(self)
        else:
            text = json.dumps(self.to_dict(), indent=1) + "\n"
        write_text_atomically(path, text)

    @classmethod
    def from_dict(cls, document: Mapping[str, Any]) -> Grasp:
        """Return the grasp of a document with exactly the keys of `to_dict`.

        In a contact, stiffness (1), preload (0), adhesion (0) and share (1) may be omitted; in the
        grasp, units, outline and data_error.

        Raises:
            InputError: unknown or missing keys, an unknown schema version, wrong types.
        """
        if isinstance(document, Mapping) and "bodies" in document:
            raise GraspError(
                "the document is an assembly of several bodies; expected a grasp. `read_assembly` "
                "reads it, and `equilibrium solve`, `resisted`, `info` and `draw` take it"
            )
        optional = ("description", "units", "outline", "data_error")
        required = ("schema_version", "contacts")
        listed = document.get("contacts", []) if isinstance(document, Mapping) else []
        check_all(
            lambda: check_keys(document, required, optional, "the grasp", _OTHER_KEYS),
            lambda: check_contacts(listed),
        )
        check_version(document)
        contacts = check_list(document["contacts"], "contacts")
        ask_contacts(len(contacts))
        labels = read_labels(document)
        made: list[Contact] = []
        check_all(*(lambda e=e, i=i: made.append(contact_of(e, i)) for i, e in enumerate(contacts)))
        return cls(made, **labels)


def check_version(document: Mapping[str, Any]) -> None:
    """Refuse another version of the schema; there is one."""
    version = document.get("schema_version", 1)
    if type(version) is not int or version != 1:
        raise GraspError(f"schema_version is {shown(version)}; this version reads 1")


def read_labels(document: Mapping[str, Any]) -> dict[str, Any]:
    """Return what a document states besides contacts, by the names of arguments."""
    return {name: read(document[name]) for name, read in _LABELS.items() if name in document}


def read_wrench(values: Iterable[Any], dimension: int = 2) -> RationalVector:
    """Return an applied wrench as rationals: ``(f_x, f_y, tau)``, or six numbers in space."""
    wrench = rational_vector(values, "wrench")
    if len(wrench) != WRENCH_SIZES[dimension]:
        entries = counted(len(wrench), "entry", "entries")
        raise GraspError(
            f"wrench has {entries}; a grasp in {_PLACES[dimension]} takes "
            f"{WRENCH_SIZES[dimension]}: {_FORCES[dimension]}"
            + " (decimals have a point)"
            * (WRENCH_SIZES[dimension] < len(wrench))
        )
    return wrench


def wrench_of(
    force: Iterable[Any], point: Iterable[Any] | None = None, dimension: int = 2
) -> RationalVector:
    """Return the wrench of a force at a point, the origin if none is given."""
    along = coordinates(force, "force", dimension)
    place = coordinates([0] * dimension if point is None else point, "point", dimension)
    return wrench_at(place, along)


def in_plane(
    grasp: Grasp, wrench: RationalVector, axes: Sequence[RationalVector]
) -> tuple[Grasp, RationalVector]:
    """Return the planar grasp and wrench, in coordinates along two axes of space.

    Args:
        axes: at a right angle to one another, of length 1.

    Raises:
        GraspError: the axes are not, or a contact or the load is not in one plane along them.
    """
    u, v = axes
    if (dot(u, u), dot(v, v), dot(u, v)) != (1, 1, 0):
        raise GraspError("the axes of the plane are not of length 1 and at a right angle")
    normal = cross(u, v)
    heights = {dot(normal, contact.point) for contact in grasp}
    if len(heights) > 1 or any(dot(normal, contact.normal) for contact in grasp):
        raise GraspError("the contacts do not lie in one plane along the axes")
    height = heights.pop() if heights else Fraction(0)
    # The load about the point of the plane that is next to the origin.
    force = wrench[:3]
    moved = wrench_at(tuple(height * x for x in normal), force)
    torque = tuple(x - y for x, y in zip(wrench[3:], moved[3:], strict=True))
    if dot(normal, force) or dot(torque, u) or dot(torque, v):
        raise GraspError("the load does not lie in the plane of the contacts")
    flat = Grasp(
        replace(
            c,
            point=(dot(u, c.point), dot(v, c.point)),
            normal=(dot(u, c.normal), dot(v, c.normal)),
            tangent=(),
            share=Fraction(1),
            thread=(),
        )
        for c in grasp
    )
    return flat, (dot(u, force), dot(v, force), dot(normal, torque))


def chosen_contacts(numbers: Iterable[int], count: int) -> tuple[int, ...]:
    """Return the numbers, from 1, of some of a number of contacts, increasing.

    Raises:
        GraspError: no such contact.
        InputError: what is no sequence of integers.
    """
    listed = entries(numbers, "contacts", "numbers of contacts")
    chosen = tuple(sorted({whole(k, f"contacts[{i}]") for i, k in enumerate(listed)}))
    if not {*chosen} <= {*range(1, count + 1)}:
        raise GraspError(
            f"contacts are {shown(list(chosen))}; expected numbers of contacts from 1 to {count}"
        )
    return chosen
