"""Cones of motions in which every contact obeys linear conditions, decided exactly.

In a cell no spring force and no slip of a touching contact changes sign; a slip may vanish on some
faces. With the states chosen on these faces, forces are linear in the motion, and a linear program
decides: either a virtual motion closes the part, or its multipliers are an equilibrium (Farkas).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement import linprog
from arrangement.exact import IntegerVector, RationalVector, primitive, to_text

from .integer_contacts import IntegerContacts, Whole
from .leaf_test import product
from .state_equilibrium import Solution

Node = Any
_SLIDING = {"slip+": 1, "slip-": -1}


class LinearCell:
    """One cell of one question."""

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        generators: Sequence[IntegerVector],
    ) -> None:
        self.contacts, self.wrench, self.generators = contacts, wrench, generators
        rows = np.array(generators, dtype=object)
        self.weight = [g[0] for g in generators]
        self.spring = np.where((force := product(rows, contacts.spring.T)) > 0, force, 0)
        self.slip = product(rows[:, 1:], contacts.tangent.T)
        self.along, self.across = contacts.balance
        unit = contacts.common_unit
        self.load = np.array([[w * unit * g for w in wrench] for g in self.weight], dtype=object)

    def decide(self) -> Node | Solution:
        """Return a proof that the cell holds no equilibrium, or one that it holds."""
        return self._decide([0, 1, 2, 3], {})

    def _decide(self, face: list[int], states: dict[int, str]) -> Node | Solution:
        """Decide the motions of a face, to which the states have led."""
        kept = [i for i in range(len(self.contacts)) if self.spring[face, i].any()]
        kept = [i for i in kept if states.get(i) != "detached"]
        direction = {i: self._direction(i, states) for i in kept}
        outcome = self._program(face, direction)
        if not isinstance(outcome, Solution):
            return self._leaf(outcome, face, states)
        loose = [i for i in kept if direction[i] == 0 and self.slip[face, i].any()]
        loose = [i for i in loose if i not in states and self.contacts.friction[i]]
        if not loose:
            return outcome
        # The contact whose slip and force disagree most splits what was possible too much.
        contact = max(loose, key=lambda i: self._wrong(outcome, i))
        still = [j for j in face if not self.slip[j, contact]]
        apart = [j for j in face if not self.spring[j, contact]]
        free, bound = ("slip+", "slip-")[:: 1 if (self.slip[:, contact] > 0).any() else -1]
        parts: dict[str, Node] = {}
        for name, part in (("stick", still), (bound, still), ("detached", apart), (free, face)):
            decided = self._decide(part, {**states, contact: name})
            if isinstance(decided, Solution):
                return decided
            parts[name] = decided
        detached = parts.pop("detached")
        slip = {"contact": contact, "slip": {k: parts[k] for k in ("stick", "slip+", "slip-")}}
        return {"contact": contact, "attachment": {"detached": detached, "attached": slip}}

    def _direction(self, i: int, states: dict[int, str]) -> int:
        """Return the known direction of slip, or 0."""
        if i in states:
            return _SLIDING.get(states[i], 0)
        slip = self.slip[:, i]
        return int((slip > 0).all()) - int((slip < 0).all())

    def _wrong(self, outcome: Solution, i: int) -> Fraction:
        normal, rub = outcome.forces[i]
        slip = sum(
            (t * x for t, x in zip(self.contacts.grasp.contacts[i].tangential_wrench, outcome.motion, strict=True)),
            Fraction(0),
        )
        limit = self.contacts.grasp.contacts[i].friction * normal
        return abs(slip) * (limit + rub if slip > 0 else limit - rub)

    def _row(self, j: int, signs: dict[int, int]) -> list[int]:
        """Return the sum of all wrenches at a generator, with directions of friction."""
        row = self.load[j]
        for i, sign in signs.items():
            if self.spring[j, i]:
                row = row + self.spring[j, i] * (self.along[i] - sign * self.across[i])
        return [Fraction(x) for x in row]  # type: ignore[misc]

    def _program(self, face: list[int], direction: dict[int, int]) -> RationalVector | Solution:
        """Return a virtual motion that works on a face, or the equilibrium that prevents it.

        The works are concave in the virtual motion; the directions of friction that are worst are
        added as they show.
        """
        box = [[*(s * (k == n) for k in range(3)), 0, 1] for n in range(3) for s in (1, -1)]
        found: list[tuple[int, dict[int, int]]] = []
        rows: list[list[Any]] = []
        motion: RationalVector = self.wrench
        best = None
        while True:
            across = {i: sum(x * t for x, t in zip(motion, self.across[i], strict=True)) for i in direction}
            signs = {i: known or (1 if across[i] >= 0 else -1) for i, known in direction.items()}
            added = False
            for j in face:
                row = self._row(j, signs)
                value = sum(x * y for x, y in zip(row, motion, strict=True))
                if best is None or value < best * self.weight[j]:
                    if (j, signs) in found:
                        continue
                    found.append((j, signs))
                    rows.append([*row, -self.weight[j], 0])
                    added = True
            if best is not None and not added:
                if best > 0:
                    return motion
                return self._equilibrium(found, multipliers)
            answer = linprog.minimize([0, 0, 0, -1], [*box, *rows, [0, 0, 0, -1, 1]])
            assert isinstance(answer, linprog.Optimal)
            motion, best = answer.point[:3], answer.point[3]
            multipliers = answer.inequality_multipliers[len(box) : -1]
            if best == 0:
                return self._equilibrium(found, multipliers)

    def _equilibrium(
        self, found: list[tuple[int, dict[int, int]]], multipliers: RationalVector
    ) -> Solution:
        """Return the motion and the forces that a combination of the generators shows."""
        contacts = self.contacts
        motion = [Fraction(0)] * 3
        forces = [[Fraction(0), Fraction(0)] for _ in range(len(contacts))]
        for (j, signs), weight in zip(found, multipliers, strict=True):
            if weight:
                motion = [x + weight * g for x, g in zip(motion, self.generators[j][1:], strict=True)]
                for i, sign in signs.items():
                    normal = weight * Fraction(self.spring[j, i], contacts.spring_unit[i])
                    forces[i][0] += normal
                    forces[i][1] -= sign * normal * contacts.grasp.contacts[i].friction
        return Solution(tuple(motion), tuple((n, t) for n, t in forces))

    def _leaf(self, motion: RationalVector, face: list[int], states: dict[int, str]) -> Node:
        """Return the leaf of a virtual motion that works on the face; multipliers do the rest."""
        for size in (1, 2, 3, 5, 7, 10, 30, 100, 1000, 10**4, 10**6, 0):
            largest = max(map(abs, motion), default=Fraction(0)) or Fraction(1)
            tried = tuple(Fraction(round(x * size / largest)) for x in motion) if size else motion
            if not size and any(tried):
                tried = tuple(map(Fraction, primitive(tried)))
            for height in range(0, 200, 4):
                works = self._works(tried, states, 2**height if height else 0)
                if all(works[j][1] for j in face) and not all(ok for _, ok in works):
                    continue
                break
            if all(ok for _, ok in works):
                return self._written(tried, states, 2**height if height else 0)
        raise AssertionError("a virtual motion of the program does not close its face")

    def _multiplier(self, motion: RationalVector, i: int, state: str, height: int) -> tuple[Fraction, Fraction]:
        """Return alpha and h of a contact with a state."""
        c = self.contacts.grasp.contacts[i]
        if state == "detached":
            return Fraction(height), Fraction(0)
        a = sum((x * n for x, n in zip(motion, c.normal_wrench, strict=True)), Fraction(0))
        b = c.friction * sum((x * t for x, t in zip(motion, c.tangential_wrench, strict=True)), Fraction(0))
        alpha = a - (abs(b) if state == "stick" else _SLIDING[state] * b)
        up = 1 if (self.slip[:, i] > 0).any() else -1
        return alpha, Fraction(0 if _SLIDING.get(state) == up else height * up)

    def _works(self, motion: RationalVector, states: dict[int, str], height: int) -> list[tuple[Fraction, bool]]:
        works = []
        for j, weight in enumerate(self.weight):
            total = sum((x * w for x, w in zip(motion, self.wrench, strict=True)), Fraction(0)) * weight
            for i, c in enumerate(self.contacts.grasp):
                e = Fraction(self.spring[j, i], self.contacts.spring_unit[i])
                s = Fraction(self.slip[j, i], self.contacts.wrench_unit[i])
                if i in states:
                    alpha, h = self._multiplier(motion, i, states[i], height)
                    total += alpha * e + h * s
                elif e:
                    a = sum((x * n for x, n in zip(motion, c.normal_wrench, strict=True)), Fraction(0))
                    b = c.friction * sum(
                        (x * t for x, t in zip(motion, c.tangential_wrench, strict=True)), Fraction(0)
                    )
                    known = self._direction(i, states)
                    total += e * (a - (known * b if known else abs(b)))
            works.append((total, total > 0 if weight else total >= 0))
        return works

    def _written(self, motion: RationalVector, states: dict[int, str], height: int) -> Node:
        written = [to_text(x) for x in motion]
        given = {}
        for i, state in sorted(states.items()):
            alpha, h = self._multiplier(motion, i, state, height)
            if h or (state == "detached" and alpha):
                given[str(i)] = [to_text(alpha), to_text(h)] if h else [to_text(alpha)]
        return {"virtual_motion": written, "multipliers": given} if given else written
