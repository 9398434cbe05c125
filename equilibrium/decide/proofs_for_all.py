"""Search for proofs of a verdict for all grasps within bounds.

Their form is in `equilibrium.certificate.robust`. Linear programs in floats, each for other holding
contacts, choose a motion on which no holding contact slips, and forces with the most room in the
friction cones. The exact test is the checker's.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations, islice
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.errors import extra
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.certificate.document import Certificate, certificate
from equilibrium.certificate.robust import Holding, virtual_motion_problem
from equilibrium.certificate.uncertain import Bounds, root
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.float_law import FloatLaw
from equilibrium.model.contact import Contact, radius_squared
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution
from equilibrium.model.subject import Subject, points_of, rows_of, texts
from equilibrium.plane.states.equilibrium import equilibrium_of

from . import RESISTED

if TYPE_CHECKING:
    from .verdict import Verdict

NO_DEADLINE = Deadline()
#: Choices of holding contacts that are tried.
MAX_HOLDING_CHOICES = 16
#: Contacts of an equilibrium without slip that is looked for by an exact program.
MAX_STANDING_CONTACTS = 40
#: Directions of friction that are distinguished in space.
_FRICTION_DIRECTIONS = 16
#: How much more normal forces than friction change with the balance, for the same wrench.
_NORMAL_WEIGHTS = (1.0, 4.0, 0.25)
#: Rounds of the energy, which grows with itself.
_MAX_ENERGY_ROUNDS = 30
#: Floats are enlarged by this factor, so that rounding does not spoil the proof.
_ENLARGED = 1 + 1e-6


def proof_for_all(
    verdict: Verdict, bounds: Bounds, deadline: Deadline = NO_DEADLINE
) -> Certificate | None:
    """Return a proof that a verdict holds for all grasps within bounds, if one is found.

    That of a yes is about springs: there is none where a contact has stiffness 0.
    """
    subject, load, bounds = verdict.subject, verdict.load, _of_points(verdict.subject, bounds)
    if verdict.verdict == RESISTED:
        if not all(contact.stiffness for contact in points_of(subject)):
            return None
        parts = next(_held(subject, load, bounds, deadline), None)
    else:
        parts = _pulled(subject, load, bounds)
    return None if parts is None else _certificate(verdict, bounds, parts)


def standing_proof(verdict: Verdict, bounds: Bounds, weakest: Verdict) -> Certificate | None:
    """Return a proof that an equilibrium of a yes within bounds is one of all grasps there, if so.

    In the plane it is looked for where no contact slips. It may have no room in friction cones.
    """
    subject, load, at = verdict.subject, verdict.load, weakest.solution
    bounds, many = _of_points(subject, bounds), len(points_of(subject))
    if at is None or at.box is not None or many > MAX_STANDING_CONTACTS:
        return None
    if isinstance(subject, Grasp) and subject.dimension == 2:
        states: Any = tuple("stick" if x.startswith("slip") else x for x in weakest.states)
        question = LinearQuestion(ContactRows.of_grasp(weakest.grasp), load)
        standing = equilibrium_of(question, states)
        if standing is None:
            return None
        at = Solution(standing.motion, standing.forces)
    zeros = (Fraction(0),) * len(load)
    correction = [[zeros] * len(force) for force in at.forces]
    held = Holding(subject, load, bounds, at.motion, at.forces, correction)
    if held.problem(zeros, Fraction(0)):
        return None
    return _certificate(verdict, bounds, _parts(held, zeros, Fraction(0)))


def _of_points(subject: Subject, bounds: Bounds) -> Bounds:
    """Return bounds of the points of pads, each on its own, when the pads are within bounds.

    A pad that turns moves a point at its edge by its radius times the angle, at most.
    """
    parts = subject.parts if isinstance(subject, Grasp) else ()
    radius = root(max(map(radius_squared, parts), default=Fraction(0)))
    return replace(bounds, length=bounds.length + radius * bounds.angle) if radius else bounds


def _certificate(verdict: Verdict, bounds: Bounds, parts: dict[str, Any]) -> Certificate:
    question = verdict.verdict, verdict.subject, verdict.load
    return certificate(*question, bounds=bounds.to_dict(), **texts(parts))


def _parts(held: Holding, reach: RationalVector, energy: Fraction) -> dict[str, Any]:
    parts = {name: getattr(held, name) for name in ("motion", "forces", "correction")}
    return {**parts, "reach": reach, "energy": energy}


def _held(
    subject: Subject, load: RationalVector, bounds: Bounds, deadline: Deadline
) -> Iterator[dict[str, Any]]:
    """Yield proofs of a yes, as parts of a document."""
    rows = _FloatSubject(subject, load, bounds)
    for holding in islice(_choices(points_of(subject)), MAX_HOLDING_CHOICES):
        if deadline.passed:
            return
        choice = _forces(rows, holding)
        if choice is None:
            continue
        for weight in _NORMAL_WEIGHTS:
            parts = _corrected(rows, holding, *choice, weight)
            if parts is not None:
                yield parts


def _choices(contacts: Sequence[Contact]) -> Iterator[list[int]]:
    """Yield choices of holding contacts: those of some normals, all of them first."""
    sides: dict[RationalVector, list[int]] = {}
    for i, contact in enumerate(contacts):
        sides.setdefault(contact.normal, []).append(i)
    for count in range(len(sides), -1, -1):
        for chosen in combinations(sides.values(), count):
            yield sorted(i for side in chosen for i in side)


class _FloatSubject(FloatLaw):
    """A grasp, or an assembly, in floats: lengths in units of its size, forces of the largest."""

    def __init__(self, subject: Subject, load: RationalVector, bounds: Bounds) -> None:
        self.subject, self.wrench, self.bounds = subject, load, bounds
        rows = rows_of(subject)
        contacts = FloatContacts(rows)
        self.m, self.d = m, d = len(rows), 1 + rows.tangents
        points = np.array(rows.points, float).reshape(m, d)
        arm = float(np.ptp(points, axis=0).max()) if m else 0.0
        self.units = contacts.arms(1 / (arm or 1.0))
        self.load = np.array(rows.total_load(load), float) * self.units
        self.force = float(np.abs(np.append(self.load, contacts.preload)).max()) or 1.0
        self.load = self.load / self.force
        self.stiff = (float(contacts.stiffness.mean()) if m else 1.0) or 1.0
        super().__init__(*contacts.in_units(self.units, self.force, self.force / self.stiff))
        #: With the least friction within bounds.
        self.least = self.friction * (1 - float(bounds.friction))
        around = np.arange(_FRICTION_DIRECTIONS if self.d == 3 else 2)
        turn = 2 * np.pi * around / len(around)
        #: Friction forces of length 1.
        self.around = np.stack([np.cos(turn), np.sin(turn)], axis=1)[:, : self.d - 1]


def _forces(rows: _FloatSubject, holding: Sequence[int]) -> tuple[Floats, Floats] | None:
    """Return the motion and (m, d) forces with the most room in the friction cones.

    They are in the units of rows.

    The variables are the motion, friction and ``a = q' - c_n`` of holding contacts, sizes of a and
    of what loose contacts add, and the room. The root of their squares is bounded by their sum.
    """
    n, h, d = len(rows.load), len(holding), rows.d
    loose = [i for i in range(rows.m) if i not in holding]
    parts = (n, h * (d - 1), h, h, len(loose), 1)
    ends = np.cumsum(parts)
    motion, friction, away, sizes, adds, room = (
        slice(end - part, end) for end, part in zip(ends, parts, strict=True)
    )
    spent, width = slice(sizes.start, adds.stop), int(ends[-1])
    balance, right = np.zeros((n, width)), -rows.load - rows.preload[holding] @ rows.normal[holding]
    equal, least, limits = [], [], []

    def row(*entries: tuple[slice | int, Any]) -> Floats:
        line = np.zeros(width)
        for place, value in entries:
            line[place] += value
        return line

    for a, i in enumerate(holding):
        normal, mu, (preload, *yields) = rows.normal[i], rows.least[i], rows.spring[i]
        rubs = slice(friction.start + a * (d - 1), friction.start + (a + 1) * (d - 1))
        balance[:, motion] += np.outer(normal, yields)
        balance[:, away.start + a] -= normal
        balance[:, rubs] += rows.tangents[i].T
        if mu:
            equal += [row((motion, tangent)) for tangent in rows.tangents[i]]
        else:
            equal += [row((k, 1)) for k in range(rubs.start, rubs.stop)]
        size = mu or 1.0
        half = [(away.start + a, size / 2), (spent, size / 2), (room, size)]
        for way in rows.around:
            least.append(row((rubs, way), (motion, -size * np.array(yields)), *half))
            limits.append(size * preload)
        for sign in (1, -1):
            least.append(row((away.start + a, sign), (sizes.start + a, -1)))
            limits.append(0.0)
    for a, i in enumerate(loose):
        preload, *yields = rows.spring[i]
        for way in rows.around:
            slip = rows.least[i] * rows.stiffness[i] * (way @ rows.tangents[i])
            least.append(row((motion, yields + slip), (adds.start + a, -1)))
            limits.append(-preload)
    best = _optimum(
        row((room, -1)),
        np.array(least) if least else None,
        limits or None,
        np.vstack([balance, *equal]),
        [*right, *[0.0] * len(equal)],
        bounds=[(None, None)] * sizes.start + [(0, None)] * (spent.stop - spent.start) + [(0, 10)],
    )
    if best is None:
        return None
    forces = np.zeros((rows.m, d))
    place = best[motion]
    forces[holding, 0] = rows.spring_forces(place)[holding] - best[away]
    forces[holding, 1:] = best[friction].reshape(h, d - 1)
    return place, forces


def _corrected(
    rows: _FloatSubject, holding: Sequence[int], motion: Floats, forces: Floats, weight: float
) -> dict[str, Any] | None:
    """Return a proof with a motion and forces, if there is one."""
    m, n, d = rows.m, len(rows.load), rows.d
    columns = np.zeros((m, d, n))
    columns[holding, 0] = weight * rows.normal[holding]
    columns[holding, 1:] = rows.tangents[holding] * (rows.least[holding] > 0)[:, None, None]
    matrix = columns.reshape(-1, n).T
    correction = np.linalg.pinv(matrix, rcond=1e-9).reshape(m, d, n)
    correction[:, 0] *= weight
    held = Holding(
        rows.subject,
        rows.wrench,
        rows.bounds,
        _dyadic(motion * rows.force / rows.stiff * rows.units),
        [_dyadic(row) for row in forces * rows.force],
        [[_dyadic(row) for row in block] for block in correction * rows.units],
    )
    rests, gains = (np.array(x, float) for x in held.balance())
    least = 1e-12 * rows.force / rows.units
    try:
        reach = np.linalg.solve(np.eye(n) - gains, rests * _ENLARGED + least)
    except np.linalg.LinAlgError:
        return None
    if not (np.isfinite(reach).all() and reach.min() > 0):
        return None
    limits = tuple(_short(x * _ENLARGED) for x in reach)
    # The least energy that counts: that of a small share of the largest force.
    energy = _short(1e-20 * rows.force**2 / rows.stiff)
    for _ in range(_MAX_ENERGY_ROUNDS):
        needed, problem = held.energy(limits, energy)
        if problem:
            return None
        if needed < energy:
            break
        energy = _short(float(needed) * _ENLARGED)
    if held.problem(limits, energy):
        return None
    return _parts(held, limits, energy)


def _pulled(subject: Subject, load: RationalVector, bounds: Bounds) -> dict[str, Any] | None:
    """Return a proof of a no: one virtual motion."""
    rows = _FloatSubject(subject, load, bounds)
    n, more = len(load), 1 + float(bounds.friction)
    shares = np.tile(more * rows.around[:, None], (1, rows.m, 1))
    works = np.vstack([*map(rows.unit_wrenches, shares), rows.load])
    room = np.linalg.norm(works, axis=1)
    limits = [(-1, 1)] * n + [(0, None)]
    cost = np.append(np.zeros(n), -1.0)
    best = _optimum(cost, np.column_stack([-works, room]), np.zeros(len(works)), bounds=limits)
    if best is None:
        return None
    virtual = _dyadic(best[:n] * rows.units)
    is_wrong = virtual_motion_problem(subject, load, bounds, virtual)
    return None if is_wrong else {"virtual_motion": virtual}


def _optimum(*program: Any, **bounds: Any) -> Floats | None:
    """Return the optimum of a linear program in floats; None if there is none."""
    with extra("search"):
        from scipy.optimize import linprog  # slow to load, and few verdicts need it

    optimum: Floats | None = linprog(*program, **bounds).x
    return optimum


def _dyadic(row: Floats) -> RationalVector:
    """Return a vector with short numbers near a given one, each with an error of its own size."""
    return tuple(map(_short, row.tolist()))


def _short(x: float) -> Fraction:
    if not x:
        return Fraction(0)
    unit = Fraction(2) ** (math.frexp(x)[1] - 40)
    return round(Fraction(x) / unit) * unit
