"""Proofs of a verdict for all grasps within bounds.

"Not resisted" has one "virtual_motion" on which the load and all adhesion do work above 0, and each
contact within the bounds none below 0, whatever its force in the friction cone is.

"Resisted" has contact forces that balance the load with room in each friction cone, for all grasps
within the bounds. Let ``e = max(0, q - k N . d)`` be the spring force at a motion d, c a motion
(the "motion" of the document), ``q' = q - k N . c`` and ``s = T . c`` there, ``v = N . (d - c)``
and ``x = T . (d - c)``. Let forces ``(c_n, c_t)`` balance the load w, and put ``a = q' - c_n``.
Contacts with forces are holding, the others loose. The load w is that of the document and the
adhesion of all contacts, which pulls along their normals and so is another one in each grasp.

On the motion ``d - c`` load and contacts do the work ``sum e v + r . x - c_n v - c_t . x``, with
friction forces ``r = -mu e u``, u along ``s + x``. As ``u . x >= |x| - 2 |s|``, a holding contact
with ``e > 0`` adds at most ``a v - k v^2 - (mu e - |c_t|) |x| + 2 mu e |s|``. As ``u . x >= -|s|``,
a loose one adds at most ``e (v + mu |s|)``, which is at most ``(q' + mu k |s|)^2 / 4k``, or 0 if
that bracket is below 0. Let B be the sum of the terms with s and of loose contacts, at most, and
``A > B + sum a^2 / 4k``.

Let K be the set of motions where ``sum k v^2 - a v <= A - sum a^2 / 4k`` (over holding contacts)
and all ``|x|`` of those with friction are at most a large bound. There ``|v - a / 2k| <=
sqrt(A / k)``, so ``e`` is at least ``(q' + c_n) / 2 - sqrt(k A)``. If mu times that is above
``|c_t|`` at each holding contact, the work is below 0 on the whole boundary of K. K is convex, and
compact up to motions that move no contact; the set of forces at d is convex and changes without a
jump outwards. So some d of K and a sum F of load and forces there have ``F . (z - d) <= 0`` for all
z of K (Fan's theorem). For ``z = c`` the work on ``d - c`` is not below 0 then. Hence d is inside
K, and F is 0: an equilibrium.

The forces differ between the grasps within the bounds: they are the "forces" f of the document, and
a "correction" R times a vector y. With G the matrix of the wrenches of a grasp, ``G R y = -(G f +
w)`` has a solution with ``|y| <= Y`` ("reach") if ``|G R - 1| Y + |G f + w| < Y`` in each entry. A
is the "energy". Where all contacts are on one line in space their wrenches do not span all; then
the points stay, all contacts hold, and y is among the wrenches of forces at the points.

If reach and energy are 0, motion and forces themselves are an equilibrium of all grasps within the
bounds: they balance the load in each, no contact slips, each normal force is that of its spring,
and no force leaves its friction cone. This needs no room.

``{"schema_version": 4, "certificate": "resisted", "grasp": ..., "wrench": ..., "bounds":
{"degrees": "1/2", ...}, "motion": c, "forces": [[c_n, c_t], ...], "correction": [rows of R for each
contact], "reach": Y, "energy": A}``, or "not resisted" with "virtual_motion" for the last five.

Of an assembly, with "assembly" in place of "grasp", all this is in R^(3b): vectors have three
numbers for each body, in the order of the bodies, and a contact is moved by the motion of body_a
relative to that of body_b.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import compress
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import RationalVector, dot, rational, rational_vector
from arrangement.numbers.linear.rank import null_space, unit_vectors
from equilibrium.model.contact import WRENCH_SIZES
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import Subject, points_of, seen_by

from .uncertain import LARGEST, Along, Bounds, Uncertain, root

#: Rows of a matrix.
Rows = Sequence[Sequence[Fraction]]
#: What proofs have besides the question and "bounds".
KEYS = {
    "resisted": ("motion", "forces", "correction", "reach", "energy"),
    "not resisted": ("virtual_motion",),
}


def robust_problem(document: Mapping[str, Any], subject: Subject, wrench: RationalVector) -> str:
    """Return what is wrong with a proof for all grasps within bounds, or nothing.

    Raises:
        InputError: this is not such a proof, whatever its numbers are.
    """
    bounds, n = read_bounds(document), len(wrench)
    if document["certificate"] == "not resisted":
        virtual = _vector(document["virtual_motion"], n, "virtual_motion")
        return virtual_motion_problem(subject, wrench, bounds, virtual)
    m, d = len(points_of(subject)), 3 if n == WRENCH_SIZES[3] and isinstance(subject, Grasp) else 2
    forces = check_list(document["forces"], "forces", m)
    correction = enumerate(check_list(document["correction"], "correction", m))
    holding = Holding(
        subject,
        wrench,
        bounds,
        _vector(document["motion"], n, "motion"),
        _rows(forces, d, "forces"),
        [_rows(check_list(x, f"correction[{i}]", d), n, f"correction[{i}]") for i, x in correction],
    )
    reach = _vector(document["reach"], n, "reach")
    return holding.problem(reach, rational(document["energy"], "energy"))


def virtual_motion_problem(
    subject: Subject, wrench: RationalVector, bounds: Bounds, virtual: RationalVector
) -> str:
    """Return why a virtual motion does not show that no grasp within bounds resists, or nothing."""
    work = Fraction(dot(virtual, wrench))
    for i, contact in enumerate(points_of(subject)):
        uncertain = Uncertain(contact, bounds)
        along = uncertain.along(seen_by(subject, i, virtual))
        work -= max(x * (along.normal + along.normal_error) for x in uncertain.ends("adhesion"))
        rubbing = uncertain.ends("friction")[1] * along.slip
        if along.normal - along.normal_error < rubbing:
            return f"virtual_motion: contact {i} may do work below 0 within the bounds"
    return "" if work > 0 else "virtual_motion: load and adhesion may do no work above 0"


class Holding:
    """Forces that hold a load at a motion, and their correction for grasps within bounds.

    Between bodies all is in R^(3b), and a contact is moved by the relative motion of its bodies.

    Args:
        forces: (m, d), normal and tangential at each contact.
        correction: (m, d, n), what is added to them for each unit of y.
    """

    def __init__(
        self,
        subject: Subject,
        wrench: RationalVector,
        bounds: Bounds,
        motion: RationalVector,
        forces: Sequence[RationalVector],
        correction: Sequence[Rows],
    ) -> None:
        self.subject, self.wrench, self.bounds = subject, wrench, bounds
        self.contacts = [Uncertain(contact, bounds) for contact in points_of(subject)]
        self.motion, self.forces, self.correction = motion, forces, correction
        pairs = zip(forces, correction, strict=True)
        self.holding = [any(force) or any(map(any, rows)) for force, rows in pairs]
        units = (tuple(map(Fraction, unit)) for unit in unit_vectors(len(wrench)))
        #: How far each unit motion moves each contact, and how far the motion does.
        self.alongs, self.moved = list(map(self._along, units)), self._along(motion)
        rows: list[tuple[Fraction, ...]] = []
        for column in compress(zip(*self.alongs, strict=True), self.holding):
            rows += zip(*((along.normal, *along.tangents) for along in column), strict=True)
        #: Orthogonal motions that move no point of a holding contact.
        self.unfelt: list[Sequence[Fraction]] = []
        for basic in null_space(rows, len(wrench)):
            self.unfelt.append(_across(basic, self.unfelt))

    def _along(self, motion: RationalVector) -> list[Along]:
        """Return how far a motion moves each contact."""
        pairs = enumerate(self.contacts)
        return [contact.along(seen_by(self.subject, i, motion)) for i, contact in pairs]

    def balance(self) -> tuple[list[Fraction], list[list[Fraction]]]:
        """Return at least ``|G f + w|`` and ``|G R - 1|`` of all grasps within the bounds."""
        changes = [c.ends("adhesion")[1] - c.contact.adhesion for c in self.contacts]
        pairs = zip(self.contacts, self.forces, strict=True)
        net = [(normal - c.contact.adhesion, *tangents) for c, (normal, *tangents) in pairs]
        columns: list[Rows] = [net]
        for k in range(len(self.wrench)):
            columns.append([[row[k] for row in rows] for rows in self.correction])
        rests, matrix = [], []
        for j, alongs in enumerate(self.alongs):
            (total, error), *sums = (_entry(alongs, column) for column in columns)
            error += dot(changes, [abs(along.normal) + along.normal_error for along in alongs])
            rests.append(abs(total + self.wrench[j]) + error)
            row = _across([x - (k == j) for k, (x, _) in enumerate(sums)], self.unfelt)
            matrix.append([abs(x) + error for x, (_, error) in zip(row, sums, strict=True)])
        return rests, matrix

    def energy(self, reach: RationalVector, energy: Fraction) -> tuple[Fraction, str]:
        """Return at least ``B + sum a^2 / 4k`` for a guess of A, and which contact has no room."""
        needed, problem = Fraction(0), ""
        for i, (contact, along) in enumerate(zip(self.contacts, self.moved, strict=True)):
            (least_friction, friction), (soft, stiff), (_, preload) = map(
                contact.ends, ("friction", "stiffness", "preload")
            )
            nominal = contact.contact
            spring = nominal.preload - nominal.stiffness * along.normal
            error = preload - nominal.preload + (stiff - nominal.stiffness) * abs(along.normal)
            error += stiff * along.normal_error
            if not self.holding[i]:
                top = max(spring + error + friction * stiff * along.slip, Fraction(0))
                needed += top * top / (4 * soft)
                continue
            changes = [dot([abs(x) for x in row], reach) for row in self.correction[i]]
            normal, *tangents = self.forces[i]
            away = abs(spring - normal) + error + changes[0]
            middle, radius = (spring + normal) / 2, (error + changes[0]) / 2
            radius += root(stiff * energy)
            needed += away * away / (4 * soft) + 2 * friction * (middle + radius) * along.slip
            rubbing = sum((abs(x) + y) ** 2 for x, y in zip(tangents, changes[1:], strict=True))
            least = middle - radius
            room = (least_friction * least) ** 2 - rubbing
            if least < 0 or room < 0 or (friction and energy and not room):
                problem = problem or f"forces[{i}]: no room in the friction cone for all grasps"
        return needed, problem

    def problem(self, reach: RationalVector, energy: Fraction) -> str:
        """Return why this is not a proof, or nothing."""
        for i, contact in enumerate(self.contacts):
            if not contact.contact.stiffness:
                return f"contact {i}: it has no spring, and the proof is about springs"
        if not any((*reach, energy)):
            # Then no contact slips, and each force is that of its spring.
            if any(self.balance()[0]):
                return "forces: they do not balance the load for all grasps within the bounds"
            needed, problem = self.energy(reach, energy)
            return problem or ("motion: it is no equilibrium for all grasps" if needed else "")
        if min(*reach, energy) <= 0:
            return "reach and energy are not above 0"
        if self.unfelt:
            if any(dot(null_motion, self.wrench) for null_motion in self.unfelt):
                return "wrench: no forces of holding contacts balance it"
            if self.bounds.length or not all(self.holding):
                return "forces: the wrenches of the holding contacts do not span all"
        for j, (rest, row) in enumerate(zip(*self.balance(), strict=True)):
            if dot(row, reach) + rest >= reach[j]:
                return f"reach[{j}]: the correction may be larger within the bounds"
        needed, problem = self.energy(reach, energy)
        return problem or ("" if needed < energy else "energy: it may be larger within the bounds")


def _entry(alongs: Sequence[Along], forces: Rows) -> tuple[Fraction, Fraction]:
    """Return one entry of the wrench of forces, and at least its change within the bounds.

    Args:
        alongs: of the motion that is 1 in this entry, and 0 in the others.
    """
    total = error = Fraction(0)
    for along, (normal, *tangents) in zip(alongs, forces, strict=True):
        total += normal * along.normal + dot(tangents, along.tangents)
        error += abs(normal) * along.normal_error + sum(map(abs, tangents)) * along.tangent_error
    return total, error


def _across(row: Sequence[Fraction], axes: Iterable[Sequence[Fraction]]) -> Sequence[Fraction]:
    """Return a vector without its shares of orthogonal axes."""
    for axis in axes:
        share = dot(row, axis) / dot(axis, axis)
        row = [x - share * y for x, y in zip(row, axis, strict=True)]
    return row


def read_bounds(document: Mapping[str, Any]) -> Bounds:
    """Return the bounds of a proof."""
    check_keys(document["bounds"], (), tuple(LARGEST), "bounds")
    return Bounds(**document["bounds"])


def check_form(document: Mapping[str, Any], kind: str, common: Sequence[str]) -> None:
    """Refuse a proof for all grasps within bounds that has other keys.

    Raises:
        CertificateError: it is one of an earlier form.
    """
    if "box" in document:
        raise CertificateError(
            "this is an old proof for all grasps within bounds (by cells of a box); make a new one "
            "with `equilibrium solve ... --robust ... --certificate OUT.json`"
        )
    check_keys(document, (*common, "bounds", *KEYS[kind]), (), "the certificate")


def _vector(value: Any, length: int, where: str) -> RationalVector:
    return rational_vector(check_list(value, where, length), where)


def _rows(rows: Iterable[Any], length: int, where: str) -> list[RationalVector]:
    return [_vector(row, length, f"{where}[{i}]") for i, row in enumerate(rows)]
