"""Exact numbers near given ones, and the record of what the rounding cost."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain, islice
from typing import Any, NamedTuple

from arrangement.library.files.json_files import check_list
from arrangement.numbers.arguments import is_listed
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    from_float,
    number_text,
    rational,
    rational_vector,
    shown,
    simplest_between,
    to_text,
    vector_text,
)
from arrangement.synonyms import by_word
from equilibrium.certificate.uncertain import root
from equilibrium.model.contact import VALUES, Contact, joined, radius_squared, radius_text
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Outline
from equilibrium.model.unit_normal import UnitNormal, unit_normal

DEFAULT_TOLERANCE = Fraction(1, 10**6)


class ContactIncidence(NamedTuple):
    """Something that contacts have in common, exactly.

    Attributes:
        kind: "parallel" (normals, also opposite ones), "square" (normals at right angles, in
            space), "line" (one line has the normals), "level"
            (points on one line, in space a plane, at right angles to their normals), "point" (the
            points are equal), "meet" (normals meet in a point), "round" (they meet in the centre of
            a circle, in space a sphere, on which the points are).
        contacts: their numbers, from 0.
        at: the point in which normals meet.
        radius: of the circle or sphere.
    """

    kind: str
    contacts: tuple[int, ...]
    at: RationalVector = ()
    radius: Fraction = Fraction(0)

    def __str__(self) -> str:
        surface = "sphere" if len(self.at) == 3 else "circle"
        what = {
            "parallel": "parallel normals",
            "square": "normals at right angles",
            "line": "normals on one line",
            "level": "points at one level along parallel normals",
            "point": "one point",
            "meet": f"normals meet in {vector_text(self.at)}",
            "round": f"on a {surface} of radius {number_text(self.radius)}, normals meet in its "
            f"centre {vector_text(self.at)}",
        }[self.kind]
        return f"contacts {', '.join(str(i + 1) for i in self.contacts)}: {what}"


@dataclass(frozen=True)
class Conversion:
    """An exact grasp and how far it is from what was given.

    Attributes:
        grasp: the result.
        point_errors: for each contact the largest change of a coordinate (length).
        angle_errors: for each contact the tangent of the angle from the given normal to the one
            used (radians, counter-clockwise); see `unit_normal`.
        value_error: the largest change of a friction coefficient, stiffness, preload or adhesion.
        kept: what contacts have in common within the error of the data, and so exactly.
        remarks: what stands for contacts with a pad, and the wrench of adhesion, in words.
    """

    grasp: Grasp
    point_errors: RationalVector
    angle_errors: RationalVector
    value_error: Fraction = Fraction(0)
    kept: tuple[ContactIncidence, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def exact(self) -> bool:
        """Whether nothing was rounded."""
        return not (any(self.point_errors) or any(self.angle_errors) or self.value_error)

    def of_points(self, points: Grasp, groups: Sequence[Sequence[Any]]) -> Conversion:
        """Return the conversion with the points of each contact in its place, which turn with it.

        Args:
            groups: for each contact its points.
        """
        grasp = replace(self.grasp, contacts=points.contacts)
        lengths, angles, left = [], [], iter(points)
        for length, angle, group in zip(
            self.point_errors, self.angle_errors, groups, strict=bool(self.point_errors)
        ):
            part = list(islice(left, len(group)))
            lengths += [length + root(radius_squared(part)) * abs(angle)] * len(part)
            angles += [angle] * len(part)
        return replace(self, grasp=grasp, point_errors=tuple(lengths), angle_errors=tuple(angles))

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form: the grasp file, and the errors as strings of rationals."""
        return {
            "grasp": self.grasp.to_dict(),
            "point_errors": [to_text(x) for x in self.point_errors],
            "angle_errors": [to_text(x) for x in self.angle_errors],
            "value_error": to_text(self.value_error),
            "kept": [str(incidence) for incidence in self.kept],
            **({"remarks": list(self.remarks)} if self.remarks else {}),
        }


def snapped(value: Any, tolerance: Any = DEFAULT_TOLERANCE) -> tuple[Fraction, Fraction]:
    """Return the simplest rational within a tolerance of a number, and the change made.

    Args:
        value: a float or anything exact.
        tolerance: at least 0; 0 keeps the binary value of a float.

    >>> snapped(0.1)
    (Fraction(1, 10), Fraction(-1, 180143985094819840))
    """
    exact, bound = from_float(value, "value"), from_float(tolerance, "tolerance")
    if bound < 0:
        raise GraspError(f"tolerance is {shown(tolerance)}; it must be at least 0")
    simplest = simplest_between(exact - bound, exact + bound)
    return simplest, simplest - exact


def assembled(
    points: Sequence[RationalVector],
    point_errors: Iterable[Fraction],
    normals: Sequence[UnitNormal],
    values: Sequence[dict[str, Any]],
    value_error: Fraction = Fraction(0),
    outline: Outline | None = None,
) -> Conversion:
    """Put contacts together from points and unit normals, both with errors, and values."""
    contacts = [
        Contact(point, normal.normal, **value)
        for point, normal, value in zip(points, normals, values, strict=True)
    ]
    return Conversion(
        Grasp(contacts, outline=outline),
        tuple(point_errors),
        tuple(normal.angle_error for normal in normals),
        value_error,
    )


#: The radius of a flat patch, which a contact may have in a file besides its values.
PAD = "pad"
#: Usual names of what contacts have, in tables and in lists of contacts, in small letters.
USUAL = by_word("""
    normal_angle normal_direction theta -> angle
    mu µ μ cof friction_coefficient friction_coeff coefficient_of_friction -> friction
    k normal_stiffness spring_constant -> stiffness
    q force normal_force f_n fn -> preload
""")
_OTHER_NAMES = USUAL | by_word("location p pos position -> point\nn -> normal")
#: Points of a pad as shares of its radius along the tangents, with shares of stiffness, preload and
#: adhesion: while all touch, force and moment are those of an evenly pressed segment, or disc.
#: Friction of a disc holds 2/3 of mu q r about the normal, these points 1/2 of it.
_PADS: dict[int, dict[tuple[int, ...], str]] = {
    2: {(0,): "2/3", (1,): "1/6", (-1,): "1/6"},
    3: {(0, 0): "1/2", (1, 0): "1/8", (-1, 0): "1/8", (0, 1): "1/8", (0, -1): "1/8"},
}


def with_usual_names(entry: Any, name: str) -> Any:
    """Return an entry of a list of contacts with the names of a grasp document, if it is one."""
    if not isinstance(entry, Mapping):
        return entry
    renamed = dict(entry)
    for other in entry:
        usual = _OTHER_NAMES.get(str(other).lower(), other)
        if usual != other and usual in renamed:
            raise GraspError(f"{name} has {other} and {usual}; keep one")
        value = renamed.pop(other)
        if isinstance(value, Mapping) and [*value] in (["x", "y"], ["x", "y", "z"]):
            value = [*value.values()]
        renamed[usual] = value
    return renamed


def contact_entries(document: Mapping[str, Any]) -> tuple[list[Any], list[Any]]:
    """Return a list of contacts as a grasp document has it, and apart their pads, 0 of no pad.

    Usual names are read, too. Lists of engines have ``position``, ``normal`` and ``force``: the
    normal force, or a vector of which the share along the normal is the preload. ``angle`` in
    degrees stands for a normal in the plane. Anything else is left for whoever reads it.
    """
    entries, pads = [], []
    for i, listed in enumerate(check_list(document["contacts"], "contacts")):
        name = f"contacts[{i}]"
        entry = with_usual_names(listed, name)
        fields = entry if isinstance(entry, dict) else {}
        if "angle" in fields:
            if "normal" in fields:
                raise GraspError(f"{name} has angle and normal; keep one")
            direction = direction_of(rational(fields.pop("angle"), f"{name}: angle"))
            fields["normal"] = list(map(to_text, direction))
        if is_listed(fields.get("preload")) and is_listed(fields.get("normal")):
            fields["preload"] = to_text(_along(fields["preload"], fields["normal"], name))
        entries.append(entry)
        pads.append(fields.pop(PAD, 0))
    return entries, pads


def _along(force: Any, normal: Any, name: str) -> Fraction:
    """Return the component of a force along a normal of any length."""
    push, along = (
        rational_vector(x, f"{name}: {kind}", from_float)
        for x, kind in ((force, "force"), (normal, "normal"))
    )
    if len(push) != len(along) or not any(along):
        raise GraspError(
            f"{name}: force has {len(push)} numbers and normal {len(along)}; expected the same "
            "number of them, and a normal other than zero"
        )
    work, square = dot(push, along), dot(along, along)
    return Fraction(work) if square == 1 else Fraction(float(work) / math.sqrt(square))


def direction_of(degrees: Fraction) -> tuple[Fraction, Fraction]:
    """Return cosine and sine, exact for multiples of 90 and to 16 digits else."""
    quarters, rest = divmod(degrees, 90)
    x, y = (Fraction(f(math.radians(rest))) for f in (math.cos, math.sin))
    return ((x, y), (-y, x), (-x, -y), (y, -x))[int(quarters) % 4]


def completed(conversion: Conversion, pads: Sequence[Any]) -> Conversion:
    """Return contacts with the pads that a file gives them, and what is to be said of them.

    A pad is a flat patch of a radius: points along the tangents share stiffness, preload and
    adhesion, as in `_PADS`.

    Args:
        pads: for each contact the radius, 0 of no pad.

    Raises:
        GraspError: a number that is not at least 0.
    """
    radii: list[Fraction] = []
    for i, pad in enumerate(pads, 1):
        radii.append(from_float(pad, f"pad of contact {i}"))
        if radii[-1] < 0:
            raise GraspError(
                f"pad of contact {i} is {shown(radii[-1])}; expected a number that is at least 0"
            )
    if any(radii):
        parts = [
            [*_pad(contact, radius)] if radius else [contact]
            for contact, radius in zip(conversion.grasp, radii, strict=True)
        ]
        conversion = conversion.of_points(Grasp(chain.from_iterable(parts)), parts)
    return replace(conversion, remarks=_remarks(conversion.grasp))


def _remarks(grasp: Grasp) -> tuple[str, ...]:
    """Return what stands for each pad of a grasp, and what adhesion does, in words."""
    remarks = []
    for k, points in enumerate(grasp.parts, 1):
        if len(points) > 1:
            whole = joined(points)
            assumed = "" if whole.stiffness_given else " (assumed)"
            remarks.append(
                f"contact {k}: {len(points)} points stand for an evenly pressed flat pad of "
                f"radius {radius_text(points)}, with shares of stiffness "
                f"{number_text(whole.stiffness)}{assumed} and of the preload; each point has "
                "friction of its own"
            )
    if pulling := [str(k) for k, c in enumerate(map(joined, grasp.parts), 1) if c.adhesion]:
        whose = f"contact{'s' * (len(pulling) > 1)} {', '.join(pulling)}"
        remarks.append(f"adhesion pulls against the normal of {whose}, besides every load")
    return tuple(remarks)


def _pad(contact: Contact, radius: Fraction) -> Iterator[Contact]:
    if contact.share != 1:
        raise GraspError("a contact has pad and share, which one of its points has; keep one")
    for along, share in _PADS[contact.dimension].items():
        point = contact.point
        for step, tangent in zip(along, contact.tangents, strict=True):
            point = tuple(x + step * radius * t for x, t in zip(point, tangent, strict=True))
        part = Fraction(share)
        shared = {name: part * getattr(contact, name) for name in VALUES[1:]}
        yield replace(contact, point=point, share=part, **shared)


def contact_values(
    number: int,
    friction: Any,
    stiffness: Any,
    preload: Any,
    adhesion: Any = 0,
    read: Callable[[Any, str], Any] = rational,
) -> list[dict[str, Any]]:
    """Return the values of each contact by name, from one for all or a sequence of each kind.

    Args:
        stiffness: None where it is not given.
    """
    known = stiffness is not None
    kinds = zip(VALUES, (friction, stiffness if known else 1, preload, adhesion), strict=True)
    columns = [[read(x, y) for x, y in _for_each(value, number, name)] for name, value in kinds]
    rows = (dict(zip(VALUES, row, strict=True)) for row in zip(*columns, strict=True))
    return [{**row, "stiffness_given": known} for row in rows]


def value_columns(contacts: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Return the columns of values of entries of a document; friction, and what some entry has."""
    defaults = {"stiffness": 1, "preload": 0, "adhesion": 0}
    return {
        name: [entry.get(name, defaults.get(name)) for entry in contacts]
        for name in VALUES
        if name == "friction" or any(name in entry for entry in contacts)
    }


def _for_each(value: Any, number: int, name: str) -> list[tuple[Any, str]]:
    """Return one value for each contact, and its name, from one for all or a sequence of them."""
    if not is_listed(value):
        return [(value, name)] * number
    listed = list(value)
    if len(listed) != number:
        raise GraspError(f"{name} has {len(listed)} values for {number} contacts")
    return [(x, f"{name}[{i}]") for i, x in enumerate(listed)]


def unit_normals(directions: Iterable[Any], tolerance: Any) -> list[UnitNormal]:
    """Return exactly unit vectors; errors name the contact."""
    normals = []
    for i, direction in enumerate(directions):
        try:
            normals.append(unit_normal(direction, tolerance))
        except ValueError as error:
            raise GraspError(f"normals[{i}]: {error}") from None
    return normals
