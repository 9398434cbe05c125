"""The motions of one region decided exactly, by splits on the states of contacts.

Each part (a region, with the states of some contacts fixed) is decided by a linear program. Its
variables are the virtual motion and, for contacts with a state, the multipliers of spring and
slip. Either it finds numbers that close the part, or its own multipliers are a motion with forces
that balance the load, and obey the law at all contacts with a state (Farkas). If they obey it at
the others too, this is an equilibrium; if not, a contact where they do not gets a state. So the
splits end.
"""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from arrangement import linprog
from arrangement.exact import IntegerVector, RationalVector, dot, primitive

from .integer_contacts import IntegerContacts, product
from .state_equilibrium import Solution

#: A node of a proof, as certificates write it.
Node: TypeAlias = Any
States: TypeAlias = dict[int, str]

_ZERO = Fraction(0)
#: The directions of slip that a state allows.
_SIGNS = {"slip+": (1,), "slip-": (-1,), "stick": (1, -1), "attached": (1, -1), "detached": ()}
#: Largest entries of rounded multipliers that are tried.
_SIZES = (1, 2, 3, 4, 5, 7, 10, 20, 50, 100, 1000, 10**4, 10**6)


class TooManyParts(Exception):
    """The splits have not ended within the number or the time allowed."""


@dataclass(frozen=True)
class _Cut:
    """One linear upper bound of the work at a generator.

    Attributes:
        generator: its number.
        signs: of the friction of each contact without a state that counts.
    """

    generator: int
    signs: dict[int, int]


class StateSplits:
    """The decision for one region.

    Args:
        generators: of the region: four, or the seven of the half space.
        limit: of the number of programs.
        deadline: on the clock `time.monotonic`.
    """

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        generators: Sequence[IntegerVector],
        limit: float,
        deadline: float = math.inf,
    ) -> None:
        self.deadline = deadline
        self.contacts, self.wrench, self.generators = contacts, wrench, generators
        self.left = limit
        rows = np.array(generators, dtype=object)
        self.weight = [int(g[0]) for g in generators]
        self.spring = product(rows, contacts.spring.T)
        self.slip = product(rows[:, 1:], contacts.tangent.T)
        self.along, self.across = contacts.balance
        unit = contacts.common_unit
        self.load = [[w * unit * g for w in wrench] for g in self.weight]
        low, high = self.spring.min(axis=0, initial=0), self.spring.max(axis=0, initial=0)
        self.kept = [int(i) for i in np.flatnonzero(high > 0)]
        self.mixed = set(np.flatnonzero((low < 0) & (high > 0)).tolist())
        one, other = (self.slip > 0).all(axis=0), (self.slip < 0).all(axis=0)
        self.known = (one.astype(int) - other.astype(int)).tolist()
        #: Whether contacts without a state have a multiplier of their spring.
        self.whole = len(generators) > 4

    def decide(self) -> Node | Solution:
        """Return a proof that the region holds no equilibrium, or one that it holds.

        Raises:
            TooManyParts: the limit is reached.
        """
        return self._decide({})

    def _decide(self, states: States) -> Node | Solution:
        self.left -= 1
        if self.left < 0 or time.monotonic() > self.deadline:
            raise TooManyParts
        found = _PartProgram(self, states).solve()
        if not isinstance(found, Solution):
            return found
        contact = self._worst(found, states)
        if contact is None:
            return found
        names = ("stick", "slip+", "slip-")
        if contact in states:
            return self._children(states, contact, "slip", names)
        if contact in self.mixed or not self._slides(contact):
            return self._children(states, contact, "attachment", ("attached", "detached"))
        slip = self._children({**states, contact: "attached"}, contact, "slip", names)
        if isinstance(slip, Solution):
            return slip
        detached = self._decide({**states, contact: "detached"})
        if isinstance(detached, Solution):
            return detached
        return {"contact": contact, "attachment": {"detached": detached, "attached": slip}}

    def _children(
        self, states: States, contact: int, kind: str, names: tuple[str, ...]
    ) -> Node | Solution:
        parts = {}
        for name in names:
            part = self._decide({**states, contact: name})
            if isinstance(part, Solution):
                return part
            parts[name] = part
        return {"contact": contact, kind: parts}

    def _slides(self, i: int) -> bool:
        """Whether the direction of slip matters and is not known."""
        return self.known[i] == 0 and bool(self.contacts.friction[i])

    def _worst(self, found: Solution, states: States) -> int | None:
        """Return the contact at which forces violate the law most, or None."""
        worst, most = None, _ZERO
        for i in self.kept:
            if states.get(i) in ("detached", "stick", "slip+", "slip-"):
                continue
            c = self.contacts.grasp.contacts[i]
            moved = dot(c.normal_wrench, found.motion)
            slipped = dot(c.tangential_wrench, found.motion)
            normal, rub = found.forces[i]
            excess = normal - max(_ZERO, c.preload - c.stiffness * moved)
            limit = c.friction * normal
            wrong = abs(excess) * 4
            if slipped:
                wrong += abs(limit + rub if slipped > 0 else limit - rub)
            if wrong > most:
                worst, most = i, wrong
        return worst


class _PartProgram:
    """The linear program of one part; the works are concave, and bounds are added as they show.

    Variables: the virtual motion, alpha of each contact with one, h of each with one, and the
    least work t for each unit of d_0.
    """

    def __init__(self, splits: StateSplits, states: States) -> None:
        self.splits, self.states = splits, states
        whole = splits.whole
        self.springs = [i for i in splits.kept if i in states or (whole and i in splits.mixed)]
        # A detached contact matters only where its spring could still push.
        self.slips = [i for i in self.springs if states.get(i) in ("stick", "slip+", "slip-")]
        self.free = [i for i in splits.kept if i not in self.springs]
        self.alpha = {i: 3 + n for n, i in enumerate(self.springs)}
        self.h = {i: 3 + len(self.springs) + n for n, i in enumerate(self.slips)}
        self.size = 4 + len(self.springs) + len(self.slips)
        #: The motion and the work are bounded.
        self.box = [self._row({k: sign}, 1) for k in range(3) for sign in (1, -1)]
        self.box.append(self._row({self.size - 1: -1}, 1))
        self.limits: list[tuple[int, int]] = []
        self.bounds: list[list[Any]] = []
        for i in self.springs:
            for sign in self._signs(i):
                # alpha <= a - sign mu b, in units in which rows are whole.
                arm = splits.along[i] - sign * splits.across[i]
                unit = splits.contacts.common_unit // splits.contacts.spring_unit[i]
                row = {k: arm[k] for k in range(3)} | {self.alpha[i]: -unit}
                self.bounds.append(self._row(row))
                self.limits.append((i, sign))
        for i in self.springs:
            if states.get(i) in (None, "detached"):
                self.bounds.append(self._row({self.alpha[i]: 1}))
        for i in self.slips:
            if states[i] != "stick":
                self.bounds.append(self._row({self.h[i]: -1 if states[i] == "slip+" else 1}))

    def _signs(self, i: int) -> tuple[int, ...]:
        signs = _SIGNS[self.states.get(i, "attached")]
        known = self.splits.known[i]
        # A known direction helps where the state leaves it open, as the checker allows.
        return (known,) if known and self.states.get(i) in (None, "attached") else signs

    def _row(self, entries: dict[int, Any], constant: int = 0) -> list[Any]:
        row: list[Any] = [0] * self.size + [constant]
        for column, x in entries.items():
            row[column] = x
        return row

    def _cut(self, motion: Sequence[Any], j: int) -> _Cut:
        """Return the bound at a generator that is exact at a virtual motion."""
        splits, signs = self.splits, {}
        for i in self.free:
            if splits.spring[j, i] > 0:
                across = dot(motion, splits.across[i])
                sign = splits.known[i] or (1 if across >= 0 else -1)
                if i not in splits.mixed or dot(motion, splits.along[i]) < sign * across:
                    signs[i] = sign
        return _Cut(j, signs)

    def _cut_row(self, cut: _Cut) -> list[Any]:
        splits, j = self.splits, cut.generator
        work = list(splits.load[j])
        for i, sign in cut.signs.items():
            arm = splits.along[i] - sign * splits.across[i]
            work = [x + splits.spring[j, i] * y for x, y in zip(work, arm, strict=True)]
        unit = splits.contacts.common_unit
        entries: dict[int, Any] = dict(enumerate(work))
        for i in self.springs:
            entries[self.alpha[i]] = splits.spring[j, i] * (unit // splits.contacts.spring_unit[i])
        for i in self.slips:
            entries[self.h[i]] = splits.slip[j, i] * (unit // splits.contacts.wrench_unit[i])
        entries[self.size - 1] = -splits.weight[j]
        return self._row(entries)

    def solve(self) -> Node | Solution:
        """Return the leaf that closes the part, or what balances the load in it."""
        cuts: list[_Cut] = []
        rows: list[list[Any]] = []
        point: Sequence[Fraction] = [*self.splits.wrench, *[_ZERO] * (self.size - 3)]
        while True:
            found = [self._cut(point[:3], j) for j in range(len(self.splits.generators))]
            made = [self._cut_row(cut) for cut in found]
            broken = [j for j, row in enumerate(made) if not cuts or dot(row[:-1], point) < 0]
            if not broken:
                return self._leaf(point[:-1])
            cuts += [found[j] for j in broken]
            rows += [made[j] for j in broken]
            objective = [0] * (self.size - 1) + [-1]
            answer = linprog.minimize(objective, [*self.box, *self.bounds, *rows])
            assert isinstance(answer, linprog.Optimal)
            point = answer.point
            if point[-1] == 0:
                y = answer.inequality_multipliers[len(self.box) :]
                return self._balanced(cuts, y[len(self.bounds) :], y[: len(self.limits)])

    def _leaf(self, numbers: Sequence[Fraction]) -> Node:
        """Return the leaf, with the smallest integers found that still close the part."""
        largest = max(map(abs, numbers[:3])) or max(map(abs, numbers)) or Fraction(1)
        rounded = ([round(x * size / largest) for x in numbers] for size in _SIZES)
        tried = next(filter(self._closes, itertools.chain(rounded, [primitive(numbers)])))
        motion = [str(x) for x in tried[:3]]
        given = {}
        for i, column in self.alpha.items():
            alpha, h = tried[column], tried[self.h[i]] if i in self.h else 0
            # A detached contact without multipliers has these.
            if alpha or h or self.states.get(i) != "detached":
                given[str(i)] = [str(alpha), *([str(h)] if h else [])]
        return {"virtual_motion": motion, "multipliers": given} if given else motion

    def _closes(self, numbers: Sequence[int]) -> bool:
        """Return whether a virtual motion, alphas and hs close the part."""
        if any(dot(row[:-2], numbers) < 0 for row in self.bounds):
            return False
        rows = (self._cut_row(self._cut(numbers[:3], j)) for j in range(len(self.splits.weight)))
        works = (dot(row[:-2], numbers) for row in rows)
        return all(x > 0 if g else x >= 0 for x, g in zip(works, self.splits.weight, strict=True))

    def _balanced(
        self, cuts: list[_Cut], weights: RationalVector, pushes: RationalVector
    ) -> Solution:
        """Return the motion and the forces that the multipliers of the program show."""
        splits, contacts = self.splits, self.splits.contacts
        motion = [_ZERO] * 3
        forces = [[_ZERO, _ZERO] for _ in range(len(contacts))]
        for cut, weight in zip(cuts, weights, strict=True):
            if weight:
                ends = splits.generators[cut.generator][1:]
                motion = [x + weight * g for x, g in zip(motion, ends, strict=True)]
                for i, sign in cut.signs.items():
                    spring = Fraction(splits.spring[cut.generator, i], contacts.spring_unit[i])
                    force = weight * spring
                    forces[i][0] += force
                    forces[i][1] -= sign * force * contacts.grasp.contacts[i].friction
        for (i, sign), push in zip(self.limits, pushes, strict=True):
            # The rows of the bounds are those of a spring force of one over the spring's unit.
            force = push / contacts.spring_unit[i]
            forces[i][0] += force
            forces[i][1] -= sign * force * contacts.grasp.contacts[i].friction
        return Solution(tuple(motion), tuple((n, t) for n, t in forces))
