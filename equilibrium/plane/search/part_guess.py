"""The program of one part in floating point: a leaf, tested exactly, or the contact to split.

A leaf is written only when its integers pass the exact test, and any contact may be split. So
nothing rests on floats; where they are inconclusive, the exact program decides.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.float_dictionary import FloatDictionary
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Solution

from .part_program import Cut, Node, PartProgram

#: The work of a part, relative to the largest, up to which it cannot be closed.
_WORK_TOLERANCE = 1e-9
#: Relative violations of the law that count as none.
_LAW_TOLERANCE = 1e-6
#: How often cuts are added.
_MAX_CUT_ROUNDS = 30
#: The bound of what is free, in units of the works.
_FREE_BOUND = 1e4
#: Steps of a guess, about, besides those of its numbers.
_GUESS_STEPS = 30_000
#: What is left at boundaries, in units of the works.
_BOUNDARY_ROOM = 1 / 16


def decide(part: PartProgram, effort: Effort) -> Node | int | Solution:
    """Return the leaf that closes a part, or the contact to split.

    Where no contact violates the law, this is what `PartProgram.solve` returns.
    """
    if not part.region.contacts.floats.moderate:
        return part.solve(effort)
    effort.check(_GUESS_STEPS + 10 * part.size * len(part.region.known))
    guess = PartGuess(part, part.cuts)
    for numbers in guess.leaves():
        for tried in guess.hopeful(list(part.roundings(numbers.tolist()))):
            if part.closes(tried):
                return part.written(tried)
    part.binding = guess.binding
    return part.solve(effort) if guess.contact is None else guess.contact


class PartGuess:
    """The program of one part, see `PartProgram`, in floating point.

    Attributes:
        contact: one that violates the law where the forces balance, if any.
        binding: the bounds that show that balance.
    """

    contact: int | None = None
    _room = 0.0

    def __init__(self, part: PartProgram, cuts: Sequence[Cut]) -> None:
        self.part, self.region = part, part.region
        self.floats = part.region.floats
        self.binding: list[Cut] = []
        self._scale = self._columns()
        self._own = rows = self._own_rows()
        first = [0, 2, 4]
        bound = np.abs(rows[:, 3:-2]) > 0
        first += [len(rows) - 1 - int(column[::-1].argmax()) for column in bound.T]
        self._cuts = list(cuts) or self._cuts_at(self.floats.load)
        made = self._cut_rows(self._cuts)
        top = np.zeros((1, rows.shape[1]))
        top[0, -2:] = -1.0, float(np.abs(made).sum(axis=1).max(initial=1.0))
        self._largest = top[0, -1]
        self._first_cut = len(rows) + 1
        self._sizes = np.empty(0)
        self._program = FloatDictionary(self._scaled(np.concatenate([rows, top, made])))
        self._program.enter([*first, len(rows)])

    def _columns(self) -> Floats:
        """Return the unit of each variable: where works are about 1."""
        part, floats = self.part, self.floats
        scale = np.ones(part.size)
        for columns, values in ((part.alpha, floats.spring), (part.h, floats.slip)):
            chosen = np.abs(values[:, list(columns)]).max(axis=0, initial=0.0)
            scale[list(columns.values())] = 1 / np.where(chosen > 0, chosen, 1.0)
        for k, column in part.pins.items():
            scale[column] = 1 / np.abs(floats.beyond[k]).max()
        scale[-1] = 1 / floats.weight.max()
        return scale

    def _own_rows(self) -> Floats:
        """Return the rows that are not bounds of the work; of what is free at first, two more."""
        part, n = self.part, self.part.size
        rows = np.zeros((6 + len(part.bounds) + 2 * len(part.sticks), n + 1))
        for k in range(3):
            rows[2 * k : 2 * k + 2, k] = 1, -1
            rows[2 * k : 2 * k + 2, -1] = 1
        for row, exact in zip(rows[6:], part.bounds, strict=False):
            largest = max(map(abs, exact))
            row[:] = [x / largest for x in exact]
        rows[:, :-1] *= self._scale
        for k, i in enumerate(part.sticks):
            pair = rows[6 + len(part.bounds) + 2 * k :][:2]
            pair[:, part.h[i]], pair[:, -1] = (1, -1), _FREE_BOUND
        return rows

    def _scaled(self, rows: Floats) -> Floats:
        """Return further rows of the program with a largest coefficient of 1."""
        sizes = np.abs(rows[:, :-1]).max(axis=1)
        sizes = np.where(sizes > 0, sizes, 1.0)
        self._sizes = np.append(self._sizes, sizes)
        return rows / sizes[:, None]

    def _cuts_at(self, motion: Floats) -> list[Cut]:
        c = self.floats.contacts
        return self.part.cuts_at(c.normal @ motion, c.pull @ motion)

    def _cut_rows(self, cuts: Sequence[Cut]) -> Floats:
        """Return bounds of the work as rows in these units."""
        part, floats, c = self.part, self.floats, self.floats.contacts
        at = [cut.generator for cut in cuts]
        signs = np.array([cut.signs for cut in cuts]).reshape(len(cuts), len(part.region.known))
        spring = floats.spring[at]
        rows = np.zeros((len(cuts), part.size + 1))
        rows[:, :3] = (spring * (signs != 0)) @ c.normal - (spring * signs) @ c.pull
        rows[:, :3] += floats.weight[at, None] * floats.load
        rows[:, list(part.alpha.values())] = spring[:, list(part.alpha)]
        rows[:, list(part.h.values())] = floats.slip[at][:, list(part.h)]
        for k, column in part.pins.items():
            rows[:, column] = -floats.beyond[k][at]
        rows[:, -2] = -floats.weight[at]
        rows[:, :-1] *= self._scale
        rows[floats.weight[at] == 0, -2] = -self._room
        return rows

    def leaves(self) -> Iterator[Floats]:
        """Yield multipliers that seem to close the part, without the last variable.

        The second ones leave room where the first are on a boundary, which roundings would cross.
        Where there are none, forces balance, or floats are inconclusive.
        """
        if self._solved():
            yield (self._program.point * self._scale)[:-1]
            self._room = _BOUNDARY_ROOM
            limits = self._own[6 : 6 + len(self.part.limits)]
            limits[:, -2] = -self._room
            more = np.concatenate([limits, self._cut_rows(self._cuts)])
            self._program.add(self._scaled(more))
            if self._solved():
                yield (self._program.point * self._scale)[:-1]

    def hopeful(self, tried: list[Sequence[int]]) -> list[Sequence[int]]:
        """Leave out integer multipliers with a work that is surely below 0 at a generator."""
        part, floats, c = self.part, self.floats, self.floats.contacts
        if part.pins:
            return tried
        numbers = np.array(tried, dtype=float)[:, None]
        along, across = numbers[..., :3] @ c.normal.T, numbers[..., :3] @ c.pull.T
        signs = part.friction_signs(along, across)
        pressed = floats.spring * part.region.presses
        terms = np.concatenate(
            [
                pressed * np.where(signs, along - signs * across, 0.0),
                floats.spring[:, list(part.alpha)] * numbers[..., list(part.alpha.values())],
                floats.slip[:, list(part.h)] * numbers[..., list(part.h.values())],
                floats.weight[:, None] * floats.load * numbers[..., :3],
            ],
            axis=2,
        )
        good = terms.sum(axis=2) >= -_WORK_TOLERANCE * np.abs(terms).sum(axis=2)
        return [tried[k] for k in np.flatnonzero(good.all(axis=1)).tolist()]

    def _solved(self) -> bool:
        """Solve with as many bounds as matter; return whether the work can be above 0."""
        for _ in range(_MAX_CUT_ROUNDS):
            if not self._program.raise_last():
                return False
            point = self._program.point
            if point[-1] <= _WORK_TOLERANCE * self._largest:
                if not self._room:
                    self.contact = self._violated()
                return False
            found = self._cuts_at(point[:3])
            rows = self._cut_rows(found)
            broken = np.flatnonzero(
                rows[:, :-1] @ point < -_WORK_TOLERANCE * np.abs(rows).max(axis=1)
            )
            if not len(broken):
                return True
            self._cuts += [found[j] for j in broken]
            self._program.add(self._scaled(rows[broken]))
        return False

    def _violated(self) -> int | None:
        """Return the contact that surely violates the law most where forces balance, if any."""
        part, floats, c = self.part, self.floats, self.floats.contacts
        y = self._program.multipliers() / self._sizes * self._scale[-1]
        weights, pushes = y[self._first_cut :], y[6 : 6 + len(part.limits)]
        self.binding = [
            cut for cut, w in zip(self._cuts, weights, strict=True) if w > _WORK_TOLERANCE
        ]
        at = [cut.generator for cut in self._cuts]
        signs = np.array([cut.signs for cut in self._cuts])
        given = weights[:, None] * floats.spring[at]
        motion = (weights @ floats.generators[at])[1:]
        normal, rub = (given * (signs != 0)).sum(axis=0), -(given * signs).sum(axis=0) * c.friction
        for (i, sign), exact, push in zip(part.limits, part.bounds, pushes, strict=False):
            force = push * (abs(exact[part.alpha[i]]) / max(map(abs, exact)))
            normal[i] += force
            rub[i] -= sign * force * c.friction[i]
        slip = c.tangent @ motion
        slip[np.abs(slip) <= _LAW_TOLERANCE * (1e-3 + np.abs(motion).max())] = 0.0
        force = c.preload + c.spring[:, 1:] @ motion
        wrong = part.violations(force, slip, normal, rub, c.friction)
        worst = int(wrong.argmax())
        return worst if wrong[worst] > _LAW_TOLERANCE * (1.0 + np.abs(normal).max()) else None
