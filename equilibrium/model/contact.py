"""One frictional contact of an object in the plane or in space, exact and frozen.

Conventions (all in one object frame, counter-clockwise positive): the normal n points INTO the
object; a force f at the point p has the wrench ``(f, p x f)``. In the plane the tangent is n turned
by +90 degrees, ``t = (-n_y, n_x)``, ``a x b = a_x b_y - a_y b_x``, and a small motion
``d = (x, y, r)`` moves the contact point by ``N . d`` along the normal and ``T . d`` along the
tangent. In space a motion is ``d = (v, omega)``, and a contact has two tangents, t and ``n x t``;
t is given, or is the x axis rotated by the smallest rotation that takes the z axis to n (no turn
where n is opposite to it).

A pad is several points that are one contact to whoever counts contacts: a flat patch that presses
with one preload, of which each point has a share. The law knows points alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache, cached_property, partial
from typing import Any, ClassVar

from arrangement.console.number_form import ReprMixin
from arrangement.hints import hints_on_assignment
from arrangement.library.files.json_files import check_all, check_keys, check_list
from arrangement.numbers import budget
from arrangement.numbers.exact import (
    RationalVector,
    dot,
    exact_root,
    number_text,
    rational,
    shown,
    to_text,
    vector_text,
)
from arrangement.numbers.linear.rank import cross, difference
from arrangement.synonyms import by_word
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import coordinates
from equilibrium.model.unit_normal import unit_normal

#: How many numbers a wrench or a motion of one body has, in the plane and in space.
WRENCH_SIZES = {2: 3, 3: 6}
#: What a contact has besides its place.
VALUES = ("friction", "stiffness", "preload", "adhesion")
_REQUIRED = ("point", "normal", "friction")
_OPTIONAL = ("stiffness", "preload", "adhesion", "tangent", "share", "thread")

#: Why a grasp in space is refused by what knows the plane only.
IN_SPACE = (
    "this takes planar grasps; this one is spatial (three coordinates). Use `equilibrium solve`, "
    "`verify`, `info`, `resisted` with a load, or a view of `draw` for grasps in space"
)


@hints_on_assignment
@dataclass(frozen=True)
class Contact(ReprMixin):
    """One frictional contact with a unilateral normal spring.

    Args:
        point: contact point p (length), two coordinates in the plane or three in space.
        normal: exactly unit, rational, pointing into the object; see `unit_normal`.
        friction: Coulomb coefficient, at least 0.
        stiffness: of the normal spring (force per length), at least 0; if omitted, 1, for a point
            of a pad its share of 1. With 0, in the plane, the contact presses with its preload
            wherever the object moves, as a force-controlled finger does.
        preload: spring force at d = 0, at least 0.
        tangent: in space it may be chosen, exactly unit and at a right angle to the normal: the
            edges of friction pyramids and the planes of slip states start from it. In the plane
            it follows from the normal, whatever is given.
        stiffness_given: whether the stiffness is one of the data, not the default; no comparison
            looks at it.
        share: of the preload of a pad, for one of its points: neighbours whose shares add up to 1
            are one contact, see `Grasp.groups`. The law is about points, so no comparison looks at
            it. 1, for a contact of its own.
        adhesion: constant force that pulls the object against the normal, at least 0, such as
            that of a suction cup. The force on the object is ``(c_n - adhesion) n + c_t``: spring
            and friction cone are about c_n alone.
        thread: the other end, if the contact is a thread or cable: it pulls the point along the
            normal towards that end, the preload is its tension at d = 0, and a detached one is
            slack. Pictures show it, and no comparison looks at it.

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
    stiffness_given: bool = field(default=False, compare=False)
    share: Fraction = field(default=Fraction(1), compare=False)
    adhesion: Fraction = Fraction(0)
    thread: RationalVector = field(default=(), compare=False)

    _synonyms: ClassVar[Mapping[str, str]] = by_word("""
        angle n -> normal
        cof friction_coefficient mu -> friction
        force normal_force -> preload
        k -> stiffness
        location position -> point
    """)

    def __init__(
        self,
        point: Iterable[Any],
        normal: Iterable[Any],
        friction: Any,
        stiffness: Any = None,
        preload: Any = 0,
        tangent: Iterable[Any] | None = None,
        stiffness_given: bool | None = None,
        share: Any = 1,
        adhesion: Any = 0,
        thread: Iterable[Any] = (),
    ) -> None:
        place, inward = coordinates(point, "point"), _unit(normal)
        if len(place) != len(inward):
            raise GraspError(
                f"point has {len(place)} coordinates and normal has {len(inward)}; give two for "
                "both, in the plane, or three, in space"
            )
        part, end = rational(share, "share"), tuple(thread)
        spring = part if stiffness is None else rational(stiffness, "stiffness")
        if stiffness_given is None:
            stiffness_given = stiffness is not None
        values = {
            "point": place,
            "normal": inward,
            "friction": rational(friction, "friction"),
            "stiffness": spring,
            "preload": rational(preload, "preload"),
            "tangent": _tangent(inward, None if len(inward) == 2 else tangent),
            # Copies with another stiffness repeat the mark of the contact that they come from.
            "stiffness_given": stiffness_given or spring != part,
            "share": part,
            "adhesion": rational(adhesion, "adhesion"),
            "thread": coordinates(end, "thread", len(inward)) if end else (),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)
        if not 0 < part <= 1:
            raise GraspError(f"share is {shown(part)}; it must be above 0 and at most 1")
        for name in ("friction", "preload", "adhesion"):
            if getattr(self, name) < 0:
                raise GraspError(f"{name} is {shown(getattr(self, name))}; it must be at least 0")
        if self.stiffness < 0 or (self.dimension == 3 and not self.stiffness):
            rule = "at least 0" if self.dimension == 2 else "above 0 in space"
            raise GraspError(f"stiffness is {shown(self.stiffness)}; it must be {rule}")

    def __repr__(self) -> str:
        return f"<Contact: {self.words}>"

    @property
    def words(self) -> str:
        """Place, normal and values, in short numbers."""
        values = ", ".join(f"{name} {number_text(getattr(self, name))}" for name in self.stated)
        return f"at {vector_text(self.point)}, normal {vector_text(self.normal)}, {values}"

    @property
    def stated(self) -> tuple[str, ...]:
        """The names of its values; few contacts have adhesion."""
        return VALUES if self.adhesion else VALUES[:-1]

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

    def force(self, shares: Sequence[Fraction]) -> RationalVector:
        """Return the force with these components: along the normal, then the tangents."""
        frame = zip(self.normal, *self.tangents, strict=True)
        return tuple(Fraction(dot(shares, axis)) for axis in frame)

    def total_force(self, shares: Sequence[Fraction]) -> RationalVector:
        """Return what the contact does to the object in all: these forces, and its adhesion."""
        normal, *friction = shares
        return self.force((normal - self.adhesion, *friction))

    @cached_property
    def normal_wrench(self) -> RationalVector:
        """N, the wrench of a unit force along the normal."""
        return wrench_at(self.point, self.normal)

    @cached_property
    def tangential_wrench(self) -> RationalVector:
        """T, the wrench of a unit force along the tangent, in the plane.

        Raises:
            GraspError: a contact in space; see `tangential_wrenches`.
        """
        if self.dimension != 2:
            raise GraspError(IN_SPACE)
        return self.tangential_wrenches[0]

    @cached_property
    def tangential_wrenches(self) -> tuple[RationalVector, ...]:
        """The wrenches of unit forces along `tangents`."""
        return tuple(wrench_at(self.point, tangent) for tangent in self.tangents)

    def to_dict(self) -> dict[str, Any]:
        """Return the file form of the contact; every number is a string.

        A stiffness that was not given is left out, so that what reads it knows.
        """
        names = ["point", "normal"]
        if self.tangent != _tangent(self.normal):
            names.append("tangent")
        names += ["thread"] if self.thread else []
        vectors = {name: list(map(to_text, getattr(self, name))) for name in names}
        left_out = () if self.stiffness_given else ("stiffness",)
        stated = (name for name in self.stated if name not in left_out)
        values = {name: to_text(getattr(self, name)) for name in stated}
        if self.share != 1:
            values["share"] = to_text(self.share)
        return vectors | values


def adhesion_wrench(contacts: Iterable[Any], size: int) -> RationalVector:
    """Return ``-sum adhesion N``, the constant part of what contacts do, of so many numbers.

    Args:
        contacts: with `adhesion` and `normal_wrench`.
    """
    total = (Fraction(0),) * size
    for contact in contacts:
        if contact.adhesion:
            pairs = zip(total, contact.normal_wrench, strict=True)
            total = tuple(x - contact.adhesion * n for x, n in pairs)
    return total


def check_contacts(entries: Any) -> None:
    """Refuse a contact of a document that has other keys, or lacks some."""
    check_all(
        *(
            partial(check_keys, entry, _REQUIRED, _OPTIONAL, f"contacts[{i}]")
            for i, entry in enumerate(check_list(entries, "contacts"))
        )
    )


def contact_of(entry: Any, index: int) -> Contact:
    """Return one contact of a document; errors say which."""
    name = f"contacts[{index}]"
    check_keys(entry, _REQUIRED, _OPTIONAL, name)
    try:
        for key in ("point", "normal", "tangent", "thread"):
            check_list(entry.get(key, []), key)
        rational(entry.get("stiffness", 1), "stiffness")  # null does not mean the default
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
            + budget.by_caller(
                "unit_normal(direction, tolerance) returns an exactly unit rational vector",
                "--round-normals takes the nearest exact unit vector",
            )
        )
    return vector


def _tangent(normal: RationalVector, stated: Iterable[Any] | None = None) -> RationalVector:
    """Return the tangent of a contact: that which is stated, or by default."""
    if stated is not None:
        tangent = _unit(stated, "tangent")
        if len(tangent) != len(normal) or dot(tangent, normal):
            raise GraspError(
                f"tangent is {vector_text(tangent)}, which is not at a right angle to the normal "
                f"{vector_text(normal)}"
            )
        return tangent
    if len(normal) == 2:
        return (-normal[1], normal[0])
    x, y, z = normal
    if z == -1:
        return (Fraction(1), Fraction(0), Fraction(0))
    return (1 - x * x / (1 + z), -x * y / (1 + z), -x)


def wrench_at(point: RationalVector, force: RationalVector) -> RationalVector:
    """Return the wrench of a force at a point."""
    if len(point) == 3:
        return (*force, *cross(point, force))
    return (force[0], force[1], point[0] * force[1] - point[1] * force[0])


#: What the points of a pad have in common, and of what each has a share.
_COMMON = ("normal", "tangent", "friction")
_SHARED = VALUES[1:]


def groups_of(contacts: Sequence[Any]) -> tuple[range, ...]:
    """Return the points of each contact: one, or neighbours whose shares add up to 1.

    Raises:
        GraspError: shares that do not add up to 1, or points that are not one flat pad.
    """
    groups, start, total = [], 0, Fraction(0)
    for i, contact in enumerate(contacts):
        total += contact.share
        if total == 1:
            groups.append(range(start, i + 1))
            start, total = i + 1, Fraction(0)
        elif total > 1:
            break
    if start < len(contacts):
        raise GraspError(
            f"the shares of the points of a pad, from contacts[{start}] on, are "
            f"{', '.join(to_text(c.share) for c in contacts[start : start + 5])}; expected "
            "neighbours whose shares add up to 1. Leave share out for a contact of its own"
        )
    for group in groups:
        first = contacts[group.start]
        for i in group[1:]:
            away = difference(contacts[i].point, first.point)
            other = [x for x in _COMMON if getattr(contacts[i], x) != getattr(first, x)]
            if other or dot(away, first.normal):
                raise GraspError(
                    f"contacts[{i}] and contacts[{group.start}] are points of one pad; expected "
                    f"the same {other[0] if other else 'height along the normal'}"
                )
    return tuple(groups)


def joined(points: Sequence[Contact]) -> Contact:
    """Return the contact that stands for the points of a pad: in its middle, with their sums."""
    if len(points) == 1:
        return points[0]
    columns = zip(*(c.point for c in points), strict=True)
    middle = tuple(Fraction(dot([c.share for c in points], column)) for column in columns)
    whole: dict[str, Any] = {
        name: sum((getattr(c, name) for c in points), Fraction(0)) for name in _SHARED
    }
    return replace(points[0], point=middle, share=Fraction(1), **whole)


def spread(points: Sequence[Contact], moved: Contact) -> tuple[Contact, ...]:
    """Return the points of a pad after its contact (see `joined`) has moved and turned, as a body.

    Args:
        moved: with what the whole pad has; each point gets its share.
    """
    if len(points) == 1:
        return (moved,)
    old = joined(points)
    middle = tuple(x + y for x, y in zip(old.normal, moved.normal, strict=True))
    points_after = []
    for c in points:
        away = difference(c.point, old.point)
        # The smallest rotation that takes the old normal to the new one.
        turn = dot(moved.normal, away) / (1 + dot(old.normal, moved.normal))
        place = (p + a - turn * m for p, a, m in zip(moved.point, away, middle, strict=True))
        own: dict[str, Any] = {}
        for name in _SHARED:  # as large a part of the new value as it had of the old one
            whole = getattr(old, name)
            own[name] = getattr(moved, name) * (getattr(c, name) / whole if whole else c.share)
        points_after.append(replace(moved, point=tuple(place), share=c.share, **own))
    return tuple(points_after)


def radius_squared(points: Sequence[Contact]) -> Fraction:
    """Return the square of the largest distance of a point from the middle of its pad."""
    middle = joined(points).point
    aways = (difference(c.point, middle) for c in points)
    return max((Fraction(dot(away, away)) for away in aways), default=Fraction(0))


def radius_text(points: Sequence[Contact]) -> str:
    """Return the radius of a pad, exactly where it is rational."""
    square = radius_squared(points)
    root = exact_root(square)
    return f"{math.sqrt(square):.6g}" if root is None else number_text(root)


def contact_words(points: Sequence[Contact]) -> str:
    """Return place, normal and values of a contact, of a pad with its radius."""
    if len(points) == 1:
        return points[0].words
    return f"{joined(points).words}, pad of radius {radius_text(points)}"


def contact_entry(points: Sequence[Contact]) -> dict[str, Any]:
    """Return the JSON form of a contact; that of a pad has its sums, and its points."""
    whole = joined(points).to_dict()
    if len(points) > 1:
        whole["points"] = [point.to_dict() for point in points]
    return whole


#: Largest tangent of the angle between an edge and where a regular polygon has it.
_TOLERANCE = "1/1000"
_MOST = 64


def pyramid_words(count: int | None, before: str = "") -> str:
    """Return what an answer for pyramids in place of round cones has to say; else nothing."""
    return "" if count is None else f"{before}friction pyramids of {count} edges"


def pyramid_edges(count: int, dimension: int = 3) -> tuple[RationalVector, ...]:
    """Return unit vectors along the edges, in the frame of the two tangents of a contact.

    They go counter-clockwise from the first tangent by even angles, up to a thousandth: rational
    unit vectors are rarely regular. Opposite edges are exactly opposite.

    Args:
        dimension: of the grasp, 3.

    Raises:
        GraspError: the number is odd, below 4 or above 64, or the grasp is in the plane.

    >>> [[str(x) for x in edge] for edge in pyramid_edges(4)]
    [['1', '0'], ['0', '1'], ['-1', '0'], ['0', '-1']]
    """
    if type(count) is not int or count % 2 or not 4 <= count <= _MOST:
        raise GraspError(
            f"a pyramid of {shown(count)} edges; give an even number from 4 to {_MOST}, so that "
            "opposite slips have opposite friction"
        )
    if dimension == 2:
        raise GraspError(
            "in the plane the friction cone has two edges, and a pyramid is for grasps in space; "
            "omit it"
        )
    return _edges(count)


@cache
def _edges(count: int) -> tuple[RationalVector, ...]:
    half = []
    for k in range(count // 2):
        angle = 2 * math.pi * k / count
        direction = (0.0, 1.0) if 4 * k == count else (math.cos(angle), math.sin(angle))
        half.append(unit_normal(direction, _TOLERANCE).normal)
    return (*half, *(tuple(-x for x in edge) for edge in half))
