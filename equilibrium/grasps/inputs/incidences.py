"""How numbers of data are rounded: to the simplest within the error, or to others within it.

Some things rounding must not break: normals that are parallel or meet, circles, equal numbers.
Whether a grasp resists a load may hang on them: a frictionless disc turns under any torque, because
all normals meet in its centre. Rounded one by one they miss it by a little, and the linear model
may turn so far that the springs hold any torque. So incidences that hold within the error of the
data are found first, in floats; then the numbers that they leave free are rounded, and the others
follow exactly: a contact on a line along its normal through b, at the height h along the normal n,
has the point ``b + n (h - n . b)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain
from random import Random
from typing import Any

import numpy as np

from arrangement.numbers.exact import (
    RationalVector,
    dot,
    from_float,
    from_floats,
    rational_vector,
    shown,
    simplest_between,
    to_text,
)
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import cross, difference
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.labels import DataError
from equilibrium.model.outline import Outline
from equilibrium.model.subject import Subject, contacts_of, known_error, with_contacts
from equilibrium.model.unit_normal import UnitNormal, angle_error, unit_normal

from .conversion import ContactIncidence, Conversion, assembled, unit_normals

#: Normals that meet farther away than this many times the size of the grasp count as parallel.
_FAR = 100
#: With larger coordinates nothing is looked for.
_LARGEST = 10**100
#: Lines that are tried as the first of those that meet in a point.
_TRIED = 64


@dataclass(frozen=True)
class Rounding:
    """How numbers are rounded.

    Attributes:
        snap: largest change of a coordinate that nothing is known of; 0 leaves them.
        error: within which incidences are kept, a length.
        angle: the same for directions (tangents).
        seed: None takes the simplest numbers, others random ones within the error.
        keep: whether incidences are kept.
        key: of the random numbers.
        found_within: how well incidences hold, as a share of the errors.
    """

    snap: Fraction
    error: Fraction
    angle: Fraction
    seed: int | None = None
    keep: bool = True
    key: str = ""
    found_within: float = 0.5

    def number(self, low: Fraction, high: Fraction, key: str, bound: Fraction) -> Fraction:
        """Return a number within a bound of all from low to high, the same for each key."""
        if self.seed is not None:
            middle = (low + high) / 2 + self._share(key) * bound * 3 / 8
            low, high, bound = middle, middle, bound / 16
        return simplest_between(high - bound, low + bound)

    def normal(
        self,
        direction: RationalVector,
        aim: RationalVector,
        key: str,
        far: float = 0.0,
        square: Sequence[RationalVector] = (),
    ) -> UnitNormal:
        """Return a unit normal along an aim, finer where an incidence is far away.

        Its error is that from the direction given. In space it is at right angles to one unit
        vector or two.
        """
        bound = min(self.angle, self.error / (8 * Fraction(far))) if far else self.angle
        if self.seed is not None:
            size = max(map(abs, aim)) * bound / 2
            aim = tuple(x + self._share(f"{key} {j}") * size for j, x in enumerate(aim))
            bound /= 4
        if len(square) == 2:
            along = cross(*square)
            unit = along if dot(along, aim) > 0 else tuple(-x for x in along)
        elif square:
            axes = Contact([0, 0, 0], square[0], 0).tangents
            shares = unit_normal([dot(axis, aim) for axis in axes], bound).normal
            unit = tuple(dot(shares, column) for column in zip(*axes, strict=True))
        else:
            unit = unit_normal(aim, bound).normal
        return UnitNormal(unit, angle_error(direction, unit))

    def _share(self, key: str) -> Fraction:
        return Fraction(Random(f"{self.seed} {self.key} {key}").randint(-16, 16), 16)


def rounding(snap: Any, error: Any, angle: Any, as_given: bool) -> Rounding:
    """Return how numbers are rounded, from what a user gives."""
    names = ("tolerance", "tolerance", "angle_tolerance")
    limits = list(zip(names, (snap, error, angle), strict=True))
    bounds = [from_float(x, name) for name, x in limits]
    for (name, x), bound in zip(limits, bounds, strict=True):
        if bound < 0:
            raise GraspError(f"{name} is {shown(x)}; it must be at least 0")
    return Rounding(bounds[0], bounds[1], bounds[2], keep=not as_given)


def equal_numbers(values: Sequence[Fraction], bound: Fraction, how: Rounding) -> list[Fraction]:
    """Return numbers near the given ones; those of equal size within a bound stay equal in size."""
    numbers = list(values)
    order = sorted(range(len(values)), key=lambda i: abs(values[i])) if bound else []
    start = 0
    while start < len(order):
        low, end = abs(values[order[start]]), start + 1
        while how.keep and end < len(order) and abs(values[order[end]]) - low <= bound:
            end += 1
        key = to_text(round(low / bound)) if how.keep else f"number {order[start]}"
        size = how.number(low, abs(values[order[end - 1]]), key, bound)
        for i in order[start:end]:
            numbers[i] = -size if values[i] < 0 else size
        start = end
    return numbers


def rounded_contacts(
    points: Sequence[RationalVector], directions: Sequence[RationalVector], how: Rounding
) -> tuple[list[RationalVector], list[UnitNormal], tuple[ContactIncidence, ...]]:
    """Return points and exactly unit normals near the given ones, with the incidences kept."""
    flat = equal_numbers([x for point in points for x in point], how.snap, how)
    n = len(points[0]) if points else 2
    places = [tuple(flat[n * i : n * i + n]) for i in range(len(points))]
    plain = max(map(abs, flat), default=0) < _LARGEST
    if not (how.keep and how.error and plain and len(points) > 1):
        return places, [how.normal(d, d, str(i)) for i, d in enumerate(directions)], ()
    work = _Work(points, places, directions, how)
    pairs = zip(chain(*points), chain(*work.places), strict=True)
    if how.snap > how.error / 100 and max(abs(x - y) for x, y in pairs) > how.error:
        return rounded_contacts(points, directions, replace(how, snap=how.snap / 8))
    return work.places, work.normals, tuple(work.kept)


def converted(
    points: Sequence[RationalVector],
    directions: Iterable[Any],
    values: Sequence[dict[str, Any]],
    how: Rounding,
    value_error: Fraction = Fraction(0),
    value_bound: Fraction = Fraction(0),
    outline: Outline | None = None,
    point_errors: Sequence[Fraction] = (),
) -> Conversion:
    """Return contacts with rounded normals, and points where `how` asks for it or as they follow.

    Args:
        directions: normals of any length.
        value_error, value_bound: made, and the largest.
        point_errors: changes of the points already made, if any.
    """
    wanted = [
        rational_vector(direction, f"normals[{i}]", from_float)
        for i, direction in enumerate(directions)
    ]
    normals = unit_normals(wanted, how.angle)
    check_number(len(normals), len(points))
    sizes = {len(vector) for vector in (*points, *wanted)}
    exact = not how.snap and not any(normal.angle_error for normal in normals)
    kept: tuple[ContactIncidence, ...] = ()
    moved = list(points)
    if not exact and len(sizes) == 1:
        moved, normals, kept = rounded_contacts(points, wanted, how)
    before = point_errors or [Fraction(0)] * len(points)
    errors = [
        error + max(map(abs, difference(new, old)))
        for new, old, error in zip(moved, points, before, strict=True)
    ]
    conversion = assembled(moved, errors, normals, values, value_error, outline)
    if not conversion.exact:
        # Incidences may have moved numbers by more than the rounding alone does.
        length = max(how.error if how.keep else how.snap, *conversion.point_errors)
        angle = max(how.angle, *map(abs, conversion.angle_errors))
        error = DataError(length, angle, value_bound, not how.keep)
        conversion = replace(
            conversion, grasp=replace(conversion.grasp, data_error=error), kept=kept
        )
    return conversion


def check_number(normals: int, points: int) -> None:
    """Refuse normals that are not as many as the points."""
    if normals != points:
        raise GraspError(f"{normals} normals for {points} points; give one for each")


def other_rounding(subject: Subject, seed: int) -> Subject:
    """Return another grasp, or assembly, within the error of the data of a converted one.

    Incidences of the contacts stay, unless their data were taken as given; so do numbers that are 0
    among friction, stiffness, preload and adhesion. A pad is one contact: its points move with it.

    Raises:
        GraspError: it has no `data_error`.
    """
    error, contacts = known_error(subject), contacts_of(subject)
    points, normals = [c.point for c in contacts], [c.normal for c in contacts]
    # What holds exactly is found again within the error of floats.
    size = max((abs(x) for point in points for x in point), default=Fraction(0))
    least = size / 10**12
    how = Rounding(
        error.length,
        max(error.length, least),
        error.angle or Fraction(1, 10**12),
        seed,
        not error.as_given,
        found_within=float(min(Fraction(1, 1000), least / error.length)) if error.length else 0.5,
    )
    places, units, _ = rounded_contacts(points, normals, how)
    columns = {}
    for name in VALUES:
        column = [getattr(contact, name) for contact in contacts]
        near = equal_numbers(column, error.value, replace(how, key=name))
        columns[name] = [max(x, y / 2) if y else y for x, y in zip(near, column, strict=True)]
    changed = (
        Contact(
            places[i],
            units[i].normal,
            **{name: column[i] for name, column in columns.items()},
            stiffness_given=contact.stiffness_given,
        )
        for i, contact in enumerate(contacts)
    )
    return with_contacts(subject, changed)


class _Work:
    """Contacts whose incidences are found, then settled one after the other.

    First the normals are rounded, then points move as far as incidences demand.

    Attributes:
        leader, turn: of each contact, the one whose normal it has, and after how many quarter turns
            (in space half turns).
        line: the first contact on the line of its normal.
        base: a point on each line that is settled.
        height: of each point that is settled, along its normal.
    """

    def __init__(
        self,
        points: Sequence[RationalVector],
        places: list[RationalVector],
        directions: Sequence[RationalVector],
        how: Rounding,
    ) -> None:
        self.points, self.places, self.directions, self.how = points, places, directions, how
        self.m, self.n = len(points), len(points[0])
        self.at = np.array(points, float)
        along = np.array([[x / max(map(abs, d)) for x in d] for d in directions], float)
        self.along = along / np.linalg.norm(along, axis=1)[:, None]
        self.size = float(np.ptp(self.at, axis=0).max())
        self.error, self.angle = (how.found_within * float(x) for x in (how.error, how.angle))
        self.kept: list[ContactIncidence] = []
        self.base: dict[int, RationalVector] = {}
        self.height: dict[int, Fraction] = {}
        classes = self._parallel()
        lines = [line for members in classes for line in self._lines(members)]
        self.line = {i: line[0] for line in lines for i in line}
        self.lines = {line[0]: line for line in lines}
        # How many lines that meet are not an accident.
        self.least = 3 if self.n == 2 else 2
        clusters = [*self._equal_points(), *self._meeting(list(self.lines))]
        self.normals = self._normals(clusters)
        for members, centre in clusters:
            self._meet(members, centre)
        for line in lines:
            if len(line) > 1:
                self.base.setdefault(line[0], self.places[line[0]])
                self.kept.append(ContactIncidence("line", tuple(line)))
        for members in classes:
            if len(members) > 1:
                self.kept.append(ContactIncidence("parallel", tuple(members)))
                self._levels(members)
        for i, (place, normal) in enumerate(zip(self.places, self.normals, strict=True)):
            base = self.base.get(self.line[i], place)
            rest = self.height.get(i, dot(normal.normal, place)) - dot(normal.normal, base)
            self.places[i] = tuple(b + rest * x for b, x in zip(base, normal.normal, strict=True))

    def _parallel(self) -> list[list[int]]:
        """Return the classes of parallel normals; square ones in the plane share numbers."""
        self.leader, self.turn = list(range(self.m)), [0] * self.m
        groups: dict[tuple[int, int], list[int]] = {}
        leaders: list[int] = []
        for i, turned in enumerate(self.along):
            for turn in range(4 if self.n == 2 else 2):
                away = np.abs(self.along[leaders] - turned).max(axis=1, initial=0.0)
                if leaders and away.min() <= self.angle:
                    self.leader[i], self.turn[i] = leaders[int(away.argmin())], turn
                    break
                turned = np.array([turned[1], -turned[0]]) if self.n == 2 else -turned
            else:
                leaders.append(i)
            axis = self.turn[i] % 2 if self.n == 2 else 0
            groups.setdefault((self.leader[i], axis), []).append(i)
        return list(groups.values())

    def _lines(self, left: list[int]) -> Iterator[list[int]]:
        """Yield the contacts of a parallel class by the line along their normals."""
        while left:
            away, along = self.at[left] - self.at[left[0]], self.along[left[0]]
            miss = np.linalg.norm(away - (away @ along)[:, None] * along, axis=1)
            line = [i for i, x in zip(left, miss, strict=True) if x <= self.error]
            yield line
            left = [i for i in left if i not in line]

    def _equal_points(self) -> Iterator[tuple[list[int], Floats]]:
        """Yield contacts at one point with different normals."""
        left = list(range(self.m))
        while left:
            away = np.abs(self.at[left] - self.at[left[0]]).max(axis=1)
            same = [i for i, x in zip(left, away, strict=True) if x <= self.error]
            if len({self.line[i] for i in same}) > 1:
                yield same, self.at[left[0]]
            left = [i for i in left if i not in same]

    def _meeting(self, lines: list[int]) -> Iterator[tuple[list[int], Floats]]:
        """Yield contacts whose lines meet in a point, the most lines first, with the point."""
        at, along = self.at[lines], self.along[lines]
        meeting: dict[tuple[int, ...], Floats] = {}
        for i in range(min(len(lines), _TRIED)):
            cosine = along @ along[i]
            square = 1 - cosine**2
            square[square < 1e-8] = np.nan
            s = np.einsum("ij,ij->i", at - at[i], along[i] - cosine[:, None] * along) / square
            s[np.abs(s) > _FAR * self.size] = np.nan
            away = (at[i] + s[:, None] * along[i])[:, None] - at[None]
            depth = np.einsum("cki,ki->ck", away, along)
            miss = np.linalg.norm(away - depth[..., None] * along, axis=-1)
            near = miss <= np.maximum(self.error, self.angle * np.abs(depth))
            for j in np.flatnonzero(near.sum(axis=1) >= self.least):
                chosen = tuple(np.flatnonzero(near[j]).tolist())
                if chosen not in meeting:
                    # The point of least squares of the distances.
                    part = along[list(chosen)]
                    square = np.eye(self.n) - part[:, :, None] * part[:, None, :]
                    right = np.einsum("kij,kj->i", square, at[list(chosen)])
                    meeting[chosen] = np.linalg.lstsq(square.sum(axis=0), right, rcond=None)[0]
        for chosen in sorted(meeting, key=len, reverse=True):
            yield [i for k in chosen for i in self.lines[lines[k]]], meeting[chosen]

    def _normals(self, clusters: list[tuple[list[int], Floats]]) -> list[UnitNormal]:
        shared = [leader for i, leader in enumerate(self.leader) if i != leader]
        far, aim = dict.fromkeys(shared, self.size), dict(enumerate(self.directions))
        for members, centre in clusters:
            for i in members:
                away = centre - self.at[i]
                depth, leader = float(away @ self.along[i]), self.leader[i]
                far[leader] = max(far.get(leader, 0.0), float(np.linalg.norm(away)))
                miss = float(np.linalg.norm(away - depth * self.along[i]))
                if miss > self.error and leader == i and aim[i] is self.directions[i]:
                    aim[i] = tuple(Fraction(x) for x in (away if depth > 0 else -away).tolist())
        normals: list[UnitNormal] = []
        for i, direction in enumerate(self.directions):
            leader = self.leader[i]
            if leader == i:
                square = self._square(i, normals) if self.n == 3 else []
                key = f"normal {i}"
                normals.append(self.how.normal(direction, aim[i], key, far.get(i, 0.0), square))
                continue
            normal = normals[leader].normal
            for _ in range(self.turn[i]):
                normal = (-normal[1], normal[0]) if self.n == 2 else tuple(-x for x in normal)
            normals.append(UnitNormal(normal, angle_error(direction, normal)))
        return normals

    def _square(self, i: int, normals: list[UnitNormal]) -> list[RationalVector]:
        """Return up to two of the normals found, at right angles to the next within the error."""
        near: list[RationalVector] = []
        for j, (normal, _) in enumerate(normals):
            right = self.leader[j] == j and abs(self.along[j] @ self.along[i]) <= self.angle
            if right and len(near) < 2 and not any(dot(normal, other) for other in near):
                near.append(normal)
                self.kept.append(ContactIncidence("square", (j, i)))
        return near

    def _meet(self, members: list[int], near: Floats) -> None:
        """Let the normals of contacts meet in a point near a given one, as far as they are free."""
        wanted = from_floats(near.tolist())
        key, bound = f"centre {members[0]}", self.how.error / 4
        centre: RationalVector = tuple(
            self.how.number(x, x, f"{key} {j}", bound) for j, x in enumerate(wanted)
        )
        settled = list({self.line[i]: i for i in members if self.line[i] in self.base}.values())
        if settled:
            normal, base = self.normals[settled[0]].normal, self.base[self.line[settled[0]]]
            height = dot(normal, difference(centre, base))
            others = [i for i in settled if any(self._miss(i, base))]
            if others and self.n == 2:
                x, y = self.normals[others[0]].normal
                across, apart = (-y, x), difference(self.base[self.line[others[0]]], base)
                if not dot(across, normal):
                    return
                height = dot(across, apart) / dot(across, normal)
            elif len(settled) > 1 and not others:
                height = Fraction(0)
            centre = tuple(b + height * x for b, x in zip(base, normal, strict=True))
        if not _within(centre, wanted, self.how.error):
            return
        kept = [i for i in members if self._close(i, centre)]
        lines = {self.line[i] for i in kept}
        point = all(_within(self.points[i], centre, self.how.error) for i in kept)
        known = any(set(kept) <= set(old.contacts) and old.at == centre for old in self.kept)
        if known or len(lines) < (2 if point else self.least):
            return
        for line in lines:
            self.base.setdefault(line, centre)
        self._round(kept, centre)

    def _round(self, members: list[int], centre: RationalVector) -> None:
        """Give equal distances to points at equal distances from the centre."""
        bound = self.how.error / 2
        radii = [dot(self.normals[i].normal, difference(centre, self.points[i])) for i in members]
        even = [x if abs(x) > bound else Fraction(0) for x in radii]
        even = [y and x for x, y in zip(equal_numbers(even, bound, self.how), even, strict=True)]
        for radius in dict.fromkeys(map(abs, even)):
            group = {i: x for i, x in zip(members, even, strict=True) if abs(x) == radius}
            if len(group) == 1 or group.keys() & self.height.keys():
                continue
            for i, x in group.items():
                self.height[i] = dot(self.normals[i].normal, centre) - x
            kind, on = "round" if radius else "point", tuple(sorted(group))
            self.kept.append(ContactIncidence(kind, on, centre, radius))
            if len(group) == len(members):
                return
        self.kept.append(ContactIncidence("meet", tuple(sorted(members)), centre))

    def _miss(self, i: int, point: RationalVector, base: RationalVector = ()) -> RationalVector:
        """Return how a point misses the line of a contact, settled or through its own point."""
        away = difference(point, base or self.base[self.line[i]])
        normal = self.normals[i].normal
        height = dot(away, normal)
        return tuple(a - height * x for a, x in zip(away, normal, strict=True))

    def _close(self, i: int, centre: RationalVector) -> bool:
        """Return whether the line of a contact passes a point, or may be moved there."""
        if self.line[i] in self.base:
            return not any(self._miss(i, centre))
        misses = (self._miss(i, centre, self.points[j]) for j in self.lines[self.line[i]])
        return all(max(map(abs, miss)) <= self.how.error for miss in misses)

    def _levels(self, members: list[int]) -> None:
        """Give equal heights to parallel contacts whose heights are equal within the error."""
        first = self.normals[members[0]].normal
        heights = {i: dot(first, self.points[i]) for i in members}
        left = sorted(members, key=lambda i: heights[i])
        while left:
            group = [i for i in left if heights[i] - heights[left[0]] <= self.how.error / 2]
            left = left[len(group) :]
            if len(group) == 1:
                continue
            known = next((i for i in group if i in self.height), None)
            height = dot(first, self.places[group[0]])
            if known is not None:
                height = self.height[known] * dot(first, self.normals[known].normal)
            for i in group:
                self.height.setdefault(i, height * dot(first, self.normals[i].normal))
            if all(self.height[i] == height * dot(first, self.normals[i].normal) for i in group):
                self.kept.append(ContactIncidence("level", tuple(sorted(group))))


def _within(left: RationalVector, right: RationalVector, bound: Fraction) -> bool:
    return bool(max(map(abs, difference(left, right))) <= bound)
