"""The load passes where the normals of smooth contacts meet, within the error of the data.

A body on smooth contacts stands under its weight only if the weight passes through the point where
their normals meet, in space through a line that all of them meet, and the like between bodies. No
open set of data has that, so rounded data miss it by a little. Here contacts are moved within the
error, so that it holds exactly, as follows.

1. With a tiny friction at the smooth contacts the load is resisted, at a motion d.
2. Turns of the normals and shifts of the points along the surface, the least ones, add what is
   missing to the balance. The turns are rounded.
3. A shift s along a tangent t changes the row N of a contact by s P with ``P = (0, t x n)``. Where
   ``P . d = 0`` it leaves all forces as they are. So motion and shifts with an exact balance are a
   solution of linear equations. As many shifts are taken as there are motions that no contact
   resists: those on which they do the most work.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import difference, gauss_jordan
from equilibrium.core.contact_law import ContactState, LinearQuestion, State, fraction, spring_force
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contact_rows import sum_row
from equilibrium.core.contacts import nearest
from equilibrium.model.contact import Contact
from equilibrium.model.labels import DataError
from equilibrium.model.rows import ContactRow
from equilibrium.model.subject import Subject, contacts_of, known_error, rows_of, with_contacts
from equilibrium.model.unit_normal import unit_normal

from . import NOT_RESISTED, RESISTED
from .nearby import Decide

if TYPE_CHECKING:
    from .verdict import Verdict

#: The tiny friction, in units of the errors.
_FRICTION = 16
#: Motions that contacts resist by a smaller share are those that none does.
_FELT = 1e-4


def meeting(verdict: Verdict, decide: Decide) -> Subject | None:
    """Return what resists the load of a no within the error of the data, if a search finds it."""
    subject, error = verdict.subject, known_error(verdict.subject)
    contacts = contacts_of(subject)
    smooth = [i for i, contact in enumerate(contacts) if not contact.friction]
    if verdict.verdict != NOT_RESISTED or not smooth or not error.length:
        return None
    if len(contacts) < len(rows_of(subject)):
        return None  # the points of a pad do not move one by one
    size = max(max(x) - min(x) for x in zip(*(c.point for c in contacts), strict=True))
    tiny = _FRICTION * max(error.angle, error.length / (size or 1))
    rubbed = (replace(c, friction=c.friction or tiny) for c in contacts)
    near = decide(with_contacts(subject, rubbed), verdict.load)
    if near is None or near.verdict != RESISTED:
        return None
    case = _Case(verdict.load, near.solution, smooth, error, size)
    try:
        return _moved(subject, case)
    except (np.linalg.LinAlgError, OverflowError):
        return None


class _Case(NamedTuple):
    """What is looked for.

    Attributes:
        near: the equilibrium with a tiny friction.
        smooth: places of the smooth contacts.
        size: of the grasp.
    """

    load: RationalVector
    near: Any
    smooth: Sequence[int]
    error: DataError
    size: Fraction


def _moved(subject: Subject, case: _Case) -> Subject | None:
    contacts, error = list(contacts_of(subject)), case.error
    balance = _Balance(subject, case)
    if error.angle:
        fine = min(error.angle, error.length / (64 * case.size or 1))
        for i, angles in balance.turns().items():
            aim = _along(contacts[i], contacts[i].normal, angles)
            contacts[i] = _with(contacts[i], contacts[i].point, unit_normal(aim, fine).normal)
        balance = _Balance(with_contacts(subject, contacts), case)
    shifts = balance.shifts()
    for i, lengths in (shifts or {}).items():
        old = contacts[i]
        contacts[i] = _with(old, _along(old, old.point, lengths), old.normal)
    pairs = zip(contacts, contacts_of(subject), strict=True)
    if shifts is None or any(_far(new, old, error) for new, old in pairs):
        return None
    return with_contacts(subject, contacts)


def _along(contact: Contact, start: RationalVector, lengths: Sequence[Fraction]) -> RationalVector:
    """Return a vector and multiples of the tangents of a contact together."""
    axes = zip(start, *contact.tangents, strict=True)
    return tuple(x + dot(lengths, across) for x, *across in axes)


def _with(contact: Contact, point: Any, normal: Any) -> Contact:
    # Tangents of a smooth contact have no meaning: they follow the normal.
    return replace(contact, point=point, normal=normal, tangent=None)  # type: ignore[arg-type]


def _far(new: Contact, old: Contact, error: DataError) -> bool:
    """Return whether a contact is beyond the error of another one."""
    moved = max(abs(x - y) for x, y in zip(new.point, old.point, strict=True))
    turned = sum((x - y) ** 2 for x, y in zip(new.normal, old.normal, strict=True))
    return moved > error.length or turned > error.angle**2


class _Column(NamedTuple):
    """One unknown besides the motion: what a unit of it adds to the balance, and its size.

    Attributes:
        contact, tangent, kind: of which contact, along which of its tangents, and whether it is a
            "shift", a "turn" or a "friction".
    """

    contact: int
    tangent: int
    kind: str
    wrench: RationalVector
    size: Fraction


class _Balance:
    """The balance of a load as linear equations, for the states of an equilibrium near."""

    def __init__(self, subject: Subject, case: _Case) -> None:
        self.rows, self.case = rows_of(subject), case
        self.motion = [nearest(x) for x in case.near.motion]
        self.pressed = {i: f[0] for i, f in enumerate(case.near.forces) if f[0] > 0}
        states = tuple(self._state(i) for i in range(len(self.rows)))
        self.program = ContactProgram(LinearQuestion(self.rows, case.load), states)
        self.shifts_of, self.turns_of = list[_Column](), list[_Column]()
        shifted = [self._shifted(subject, k) for k in range(self.rows.tangents)]
        for i in (i for i in self.pressed if i in case.smooth):
            row, pressed = self.rows[i], self.pressed[i]
            for k, tangent in enumerate(row.tangential_wrenches):
                column = difference(shifted[k][i].normal_wrench, row.normal_wrench)
                self.shifts_of.append(_Column(i, k, "shift", column, case.error.length * pressed))
                self.turns_of.append(_Column(i, k, "turn", tangent, case.error.angle * pressed))
        self.frictions = [
            _Column(i, k, "friction", self.rows[i].tangential_wrenches[k], self.pressed[i])
            for _, i, k in self.program.unknowns
        ]

    def _shifted(self, subject: Subject, k: int) -> Sequence[ContactRow]:
        """Return the rows of contacts whose points are one further along a tangent."""
        moved = (
            _with(c, sum_row(c.point, c.tangents[k], 1), c.normal) for c in contacts_of(subject)
        )
        return rows_of(with_contacts(subject, moved)).contacts

    def _state(self, i: int) -> State:
        """Return what a contact does: in space, and where it sticks, friction is not known."""
        tangents = self.rows[i].tangential_wrenches
        slips = [dot(tangent, self.case.near.motion) for tangent in tangents]
        if i not in self.pressed:
            return "detached"
        if i in self.case.smooth:
            return ContactState("attached", share=(0,) * len(slips))
        if any(slips) and len(slips) == 1:
            return "slip+" if slips[0] > 0 else "slip-"
        return ContactState.of("stick", len(slips))

    def _chosen(self) -> list[_Column]:
        """Return frictions, and as many shifts as there are motions that no contact resists."""
        shifts, felt = self.shifts_of, [self.rows[i].normal_wrench for i in self.pressed]
        felt += [column.wrench for column in self.frictions]
        arms = np.where(self.rows.turns, 1 / nearest(self.case.size or Fraction(1)), 1.0)
        _, sizes, axes = np.linalg.svd(np.array(felt, float) * arms)
        rank = np.count_nonzero(sizes > _FELT * sizes.max(initial=0.0))
        table = [[nearest(x * column.size) for x in column.wrench] for column in shifts]
        works = np.array(table).reshape(len(shifts), self.rows.n) * arms @ axes[rank:].T
        best_shifts = []
        for _ in range(min(works.shape)):
            # The one that does the most; of the others, what they do on further motions.
            lengths = np.linalg.norm(works, axis=1)
            best = int(lengths.argmax())
            if not lengths[best] > 0:
                break
            best_shifts.append(shifts[best])
            way = works[best] / lengths[best]
            works = works - np.outer(works @ way, way)
            works[best] = 0.0
        return [*self.frictions, *best_shifts]

    def _equations(self, chosen: Sequence[_Column]) -> list[list[Fraction]]:
        """Return equations for the motion and columns, what they are equal to last."""
        n, none = self.rows.n, [Fraction(0)] * (len(chosen) + 1)
        rows = [list(map(fraction, row)) for row in self.program.equations]
        more = chosen[len(self.program.unknowns) :]
        # The balance is last.
        added = [[Fraction(0)] * len(more) for _ in range(len(rows) - n)]
        added += [[column.wrench[j] for column in more] for j in range(n)]
        still = ([*column.wrench, *none] for column in more if column.kind == "shift")
        return [[*row[:-1], *x, -row[-1]] for row, x in zip(rows, added, strict=True)] + [*still]

    def _sizes(self, chosen: Sequence[_Column]) -> list[Fraction]:
        """Return typical sizes of the unknowns: in these units the least ones are taken."""
        soft = max((row.stiffness for row in self.rows), default=Fraction(1)) or 1
        force = max([*self.pressed.values(), *map(abs, self.case.load)])
        step = max([*map(abs, self.case.near.motion), force / soft])
        return [step] * self.rows.n + [column.size for column in chosen]

    def turns(self) -> dict[int, list[Fraction]]:
        """Return angles along the tangents by contact, from floats."""
        chosen = [*self._chosen(), *self.turns_of]
        rows = self._equations(chosen)
        table = np.array([[nearest(x) for x in row] for row in rows])
        sizes: Floats = np.array([nearest(x) for x in self._sizes(chosen)])
        start = np.array([*self.motion, *[0.0] * len(chosen)])
        matrix, right = table[:, :-1] * sizes, table[:, -1] - table[:, :-1] @ start
        weights = 1 / np.maximum(np.abs(table).max(axis=1), 1e-300)
        change = np.linalg.lstsq(matrix * weights[:, None], right * weights, rcond=1e-13)[0] * sizes
        return self._by_contact(chosen, "turn", [Fraction(x) for x in start + change])

    def shifts(self) -> dict[int, list[Fraction]] | None:
        """Return lengths along the tangents with an exact balance, by contact; None without."""
        chosen = self._chosen()
        rows = self._equations(chosen)
        start = [Fraction(x) for x in self.motion] + [Fraction(0)] * len(chosen)
        values = _least(rows, start, self._sizes(chosen))
        return None if values is None else self._by_contact(chosen, "shift", values)

    def _by_contact(
        self, chosen: Sequence[_Column], kind: str, values: Sequence[Fraction]
    ) -> dict[int, list[Fraction]]:
        """Return what forces along columns are for each unit of the normal force.

        Args:
            values: of the motion and the columns.
        """
        n, by_contact = self.rows.n, dict[int, list[Fraction]]()
        for column, x in zip(chosen, values[n:], strict=True):
            row = self.rows[column.contact]
            # Adhesion pulls along the row that changes, too.
            pressed = spring_force(row, values[:n]) - row.adhesion
            if column.kind == kind and x and pressed:
                shares = by_contact.setdefault(column.contact, [Fraction(0)] * self.rows.tangents)
                shares[column.tangent] = x / pressed
        return by_contact


def _least(
    rows: Sequence[Sequence[Fraction]], start: Sequence[Fraction], sizes: Sequence[Fraction]
) -> list[Fraction] | None:
    """Return the solution of equations that is nearest to a start, in given units; if any."""
    scaled = [[x * size for x, size in zip(row, sizes, strict=False)] for row in rows]
    rest = [row[-1] - dot(row[:-1], start) for row in rows]
    square = [
        [dot(one, other) for other in scaled] + [x] for one, x in zip(scaled, rest, strict=True)
    ]
    reduced, pivots, scale = gauss_jordan(square)
    if len(rows) in pivots:
        return None
    factors = [Fraction(0)] * len(rows)
    for row, pivot in zip(reduced, pivots, strict=False):
        factors[pivot] = Fraction(row[-1], scale)
    columns = zip(*scaled, strict=True)
    changes = (size * dot(column, factors) for size, column in zip(sizes, columns, strict=True))
    return [x + change for x, change in zip(start, changes, strict=True)]
