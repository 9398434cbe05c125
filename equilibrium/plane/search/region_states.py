"""The motions of one region decided exactly, by splits on the states of contacts.

On a region some contacts have one state, or slip in one direction. The others get a state where the
exact program finds a solution that they violate, until the program is the law, or has no solution:
then its Farkas multipliers are a leaf. So the splits end.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.core.contact_law import LinearQuestion, exact, fraction
from equilibrium.core.contact_program import ContactProgram, Node as States, Values
from equilibrium.core.contacts import IntegerContacts, product
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Leaf, Solution

#: A node of a proof, as certificates write it.
Node: TypeAlias = Any


class TooManyParts(Exception):
    """The splits have not ended within the number allowed."""


class StateSplits:
    """The decision for one region.

    Args:
        generators: of the region: four, or the seven of the half space.
        limit: of the number of programs.
        effort: that is left.
    """

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        generators: Sequence[IntegerVector],
        limit: float,
        effort: Effort | None = None,
    ) -> None:
        self.left, self.effort, self.contacts = limit, effort or Effort(), contacts
        matrix = np.array(generators, dtype=object)
        springs = product(matrix, contacts.spring.T)
        slips = product(matrix[:, 1:], contacts.tangent.T)
        signs = (slips > 0).all(axis=0).astype(int) - (slips < 0).all(axis=0).astype(int)
        bounds = product(matrix, contacts.bounds[0].T)
        apart, touching = np.all(springs <= 0, axis=0), np.all(springs >= 0, axis=0)
        rubs = (signs == 0) & np.array([c.friction > 0 for c in contacts.rows], dtype=bool)
        decided = apart | (touching & ~rubs)
        # Some motions of the region are too large.
        decided[np.flatnonzero((bounds < 0).any(axis=0)) // 4] = False
        #: The contacts that the region does not decide; states are those of these.
        self.open = np.flatnonzero(~decided).tolist()
        self.root: States = tuple(
            "detached" if apart[i] else "attached" if touching[i] else "undecided"
            for i in self.open
        )
        self._known: States = tuple(np.where(apart, "detached", "attached").tolist())
        weights, scale = _weights(generators)
        chords = [
            _chord(springs[:, i].tolist(), weights, scale * contacts.spring_unit[i])
            for i in (self.open if weights else ())
        ]
        # What the decided contacts give.
        pressing = np.flatnonzero(decided & ~apart)
        arms = np.where(signs[:, None] > 0, *contacts.edges) * contacts.shares[:, None]
        spring_rows = product(arms[pressing].T, contacts.spring[pressing])
        spring_rows = spring_rows / Fraction(contacts.common_unit)
        rows = contacts.rows
        self._all = LinearQuestion(rows, wrench, signs=tuple(signs.tolist()))
        self.question = LinearQuestion(
            replace(rows, contacts=tuple(rows[i] for i in self.open)),
            wrench,
            max_displacement=contacts.max_displacement,
            region=tuple(tuple(map(Fraction, (*row[1:], row[0]))) for row in weights),
            background=tuple((*row[1:], row[0]) for row in spring_rows.tolist()),
            signs=tuple(self._all.signs[i] for i in self.open),
            chords=tuple(chords),
        )

    def decide(self) -> Node | Solution:
        """Return a proof that the region holds no equilibrium, or one that it holds.

        Raises:
            TooManyParts: the limit is reached.
            TimeoutError: no effort is left.
        """
        return self._decide(self.root)

    def _decide(self, states: States) -> Node | Solution:
        self.left -= 1
        if self.left < 0:
            raise TooManyParts
        program = ContactProgram(self.question, states, self.effort)
        end = program.some_end()
        if end is None:
            return self._leaf(program)
        if end.is_lawful or program.is_complete:
            return self._completed(program)
        nodes = program.split(end.violations)
        i = next(k for k, (x, y) in enumerate(zip(states, nodes[0], strict=True)) if x != y)
        parts = self._parts(i, reversed(nodes))
        if isinstance(parts, Solution):
            return parts
        kind = "attachment" if "attached" in parts else "slip"
        node = {"contact": self.open[i], kind: parts}
        if kind == "attachment" or self.root[i] != "attached":
            return node
        # In a certificate a contact is attached before it slips.
        detached = self._decide((*states[:i], "detached", *states[i + 1 :]))
        if isinstance(detached, Solution):
            return detached
        return {"contact": self.open[i], "attachment": {"detached": detached, "attached": node}}

    def _parts(self, i: int, nodes: Iterator[States]) -> dict[str, Node] | Solution:
        parts = {}
        for states in nodes:
            part = self._decide(states)
            if isinstance(part, Solution):
                return part
            parts[states[i]] = part
        return parts

    def _completed(self, program: ContactProgram) -> Solution:
        """Return the equilibrium of a program with the forces of all contacts."""
        solution = program.solution()
        assert solution is not None
        forces = dict(zip(self.open, solution.forces, strict=True))
        at = Values(self._all.symbols, range(len(solution.motion)), solution.motion)
        for i, state in enumerate(self._known):
            if i not in forces:
                law = self._all.conditions(i, state)
                forces[i] = tuple(map(at.fraction, law.forces))
        return Solution(solution.motion, tuple(forces[i] for i in range(len(self._known))))

    def _leaf(self, program: ContactProgram) -> Leaf:
        """Return a leaf, without the multipliers that follow from the region."""
        leaf = program.leaf()
        assert leaf is not None
        rows: dict[int, Sequence[Fraction]] = {}
        for i, numbers in leaf.multipliers.items():
            state = program.states[i]
            if state != self.root[i]:
                rows[i] = numbers
            elif (
                state == "undecided"
                and numbers[0] > 0
                and (least := min(numbers[0], self._factor(i, leaf.motion))) > 0
            ):
                rows[i] = (least, Fraction(0))
        moved = {i: row for i, row in leaf.displacements.items() if any(row)}
        used = {i: x for i, x in rows.items() if any(x)}
        return Leaf(leaf.motion, used, moved).at(self.open).primitive()

    def _factor(self, i: int, motion: RationalVector) -> Fraction:
        """Return the least work of a unit normal force of a contact on a virtual motion."""
        wrenches = self.question.unit_wrenches(i, "undecided")
        return min(fraction(dot(wrench, list(map(exact, motion)))) for wrench in wrenches)


def _chord(springs: Sequence[int], weights: Sequence[IntegerVector], unit: int) -> RationalVector:
    """Return the row with the force of a spring at the generators, where it is no pull."""
    pressed = [max(x, 0) for x in springs]
    constant, *row = (Fraction(dot(pressed, x), unit) for x in zip(*weights, strict=True))
    return *row, constant


def _weights(generators: Sequence[IntegerVector]) -> tuple[list[IntegerVector], int]:
    """Return what has the weights of the generators in a motion, times a number above 0.

    Nothing for those of the half space, which are too many.
    """
    n = len(generators[0])
    if len(generators) > n:
        return [], 1
    units = [[*g, *(int(k == j) for k in range(n))] for j, g in enumerate(generators)]
    reduced, _, scale = gauss_jordan(units)
    sign = 1 if scale > 0 else -1
    columns = zip(*(row[n:] for row in reduced), strict=True)
    return [tuple(sign * int(x) for x in column) for column in columns], sign * int(scale)
