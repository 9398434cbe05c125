"""Exact linear programs about contacts, with some of the contact states still open.

With all contacts decided a program is the law itself, see `equilibrium.core.contact_law`; else a
relaxation: it has every solution.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.programs import Infeasible, Program
from arrangement.numbers.linear.rank import gauss_jordan
from equilibrium.core.contact_rows import any_friction_does
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Leaf, Solution

from .contact_law import (
    Condition,
    LinearQuestion,
    Terms,
    add,
    added,
    exact,
    fraction,
    times,
)

#: The states of all contacts, most by their names.
Node = tuple[Any, ...]
#: Whether a contact touches is split before how it slips, by this factor of what is missed.
_LIFT_WEIGHT = 3


class End(NamedTuple):
    """A solution of a program.

    Attributes:
        t: its magnitude, the least or the largest one; None where that is unbounded.
        violations: how far each contact is from the law: the change of force that it would take.
        states: of the contacts at its motion.
    """

    t: Fraction | None
    violations: list[Fraction]
    states: Node

    @property
    def is_lawful(self) -> bool:
        """Whether it is an equilibrium."""
        return self.t is not None and not any(self.violations)


class Values(dict[Any, Any]):
    """The numbers of unknowns at a point, and of symbols when they are looked up, times a unit.

    The unit is a common denominator, as reduced fractions would take several times as long.
    """

    def __init__(self, symbols: Mapping[Any, Terms], keys: Iterable[Any], point: Any) -> None:
        is_rational = all(isinstance(x, (Fraction, int)) for x in point)
        self.unit = math.lcm(*(x.denominator for x in point)) if is_rational else 1
        super().__init__(zip(keys, (exact(x * self.unit) for x in point), strict=True))
        self[-1], self._symbols = exact(Fraction(self.unit)), symbols

    def __missing__(self, key: Any) -> Any:
        self[key] = number = self.of(self._symbols[key])
        return number

    def of(self, terms: Terms) -> Any:
        """Return the number of an expression times the unit."""
        total = 0
        for key, x in terms.items():
            total += x * self[key]
        return total

    def fraction(self, terms: Terms) -> Fraction:
        """Return the number of an expression of rational numbers."""
        number = self.of(terms)
        return Fraction(int(number.numerator), int(number.denominator) * self.unit)


class ContactProgram:
    """The program of one node.

    Args:
        deadline: looked at before each pivot.
    """

    def __init__(
        self, question: LinearQuestion, states: Node, deadline: Effort | None = None
    ) -> None:
        self.question, self.states, self._deadline = question, states, deadline
        n = question.rows.n
        contacts = [question.conditions(i, state) for i, state in enumerate(states)]
        #: The columns of unknown forces.
        first = n + (question.load_slope is not None)
        unknowns = chain.from_iterable(c.unknowns for c in contacts)
        self._columns = {force: k for k, force in enumerate(unknowns, first)}
        self.size = first + len(self._columns)
        self._magnitude = [int(j == n < first) for j in range(self.size)]
        self.forces = [contact.forces for contact in contacts]
        balance = list(map(dict, question.balance))
        for contact in contacts:
            for force, arm in contact.arms:
                for j, x in arm.items():
                    balance[j][force] = x
        self._least = [*question.sides, *chain.from_iterable(c.least for c in contacts)]
        self._equal = [
            *chain.from_iterable(c.equal for c in contacts),
            *(Condition(question, line) for line in balance),
        ]

    @cached_property
    def inequalities(self) -> list[tuple[int, ...]]:
        """The rows that are at least 0 at a solution."""
        return [self._row(x.row) for x in self._least]

    @cached_property
    def equalities(self) -> list[tuple[int, ...]]:
        """The rows that are 0 at a solution, those of the balance last."""
        return [self._row(x.row) for x in self._equal]

    @cached_property
    def _reduced(self) -> Any:
        return gauss_jordan(self.equalities)

    @property
    def freedom(self) -> int | None:
        """How many unknowns the equations leave open; None if they contradict each other."""
        _, pivots, _ = self._reduced
        return None if self.size in pivots else self.size - len(pivots)

    def admitted(self, point: Sequence[Fraction] | None) -> Solution | None:
        """Return the motion and the forces of a solution of the equations, if it is one of all."""
        at = None if point is None else self.values(point)
        if at is None or any(at.of(x.terms) < 0 for x in self._least):
            return None
        return self.at(at)

    def completed(self, near: Sequence[Fraction]) -> list[Fraction] | None:
        """Return the solution of the equations that has these numbers where they leave any.

        None if they contradict each other.

        Args:
            near: of the motion, and of `unknowns`; 0 for those that are left out.
        """
        rows, pivots, scale = self._reduced
        if self.size in pivots:
            return None
        point = [*near, *[Fraction(0)] * (self.size - len(near))]
        free = [k for k in range(self.size) if k not in pivots]
        for row, pivot in zip(rows, pivots, strict=False):
            rest = row[-1] + sum(row[k] * point[k] for k in free)
            point[pivot] = Fraction(-rest) / scale
        return point

    @property
    def unknowns(self) -> list[Any]:
        """The forces that are columns after the motion and t, as ("friction", contact, tangent)."""
        return list(self._columns)

    @property
    def equations(self) -> list[tuple[Any, ...]]:
        """The equalities, not in integers."""
        return [self._row(self.question.expanded(x.terms)) for x in self._equal]

    @property
    def units(self) -> list[int]:
        """What the equalities are multiplied by, to have integers."""
        return [x.unit for x in self._equal]

    @cached_property
    def _program(self) -> Program:
        return Program(self.size, self.inequalities, self.equalities, self._deadline)

    def _row(self, terms: Mapping[Any, Any]) -> tuple[Any, ...]:
        """Return an expression without symbols as a row, constant last."""
        row = [0] * (self.size + 1)
        for key, x in terms.items():
            row[key if isinstance(key, int) else self._columns[key]] = x
        return tuple(row)

    def _exact_row(self, terms: Terms) -> RationalVector:
        """Return a positive multiple of an expression as a row."""
        return tuple(map(Fraction, self._whole_row(terms)[0]))

    def _whole_row(self, terms: Terms) -> tuple[tuple[int, ...], int]:
        condition = Condition(self.question, terms)
        return self._row(condition.row), condition.unit

    @property
    def is_complete(self) -> bool:
        """Whether no contact is open: the program is the law."""
        return not any(self.question.is_open(i, state) for i, state in enumerate(self.states))

    @property
    def feasible(self) -> bool:
        """Whether there is a solution; with any friction, one with some coefficient."""
        question = self.question
        if question.frictions is None or question.frictions[1] is not None:
            return self._program.feasible
        forces = [
            (self._exact_row(normal), self._exact_row(rubbed))
            for i, (normal, rubbed) in enumerate(self.forces)
            if rubbed and question.coefficients(i)[1] is None
        ]
        both = self.inequalities, self.equalities
        least, equal = ([tuple(map(Fraction, row)) for row in rows] for rows in both)
        return any_friction_does(self.size, least, equal, forces, self._deadline)

    def some_end(self) -> End | None:
        """Return a solution; None if there is none."""
        point = self._point()
        n, has_t = self.question.rows.n, self.question.load_slope is not None
        return None if point is None else self._end(point[n] if has_t else Fraction(0))

    def start(self) -> End | None:
        """Return the solution of the least magnitude; None if there is none."""
        low = self._program.least(self._magnitude)
        return None if low is None else self._end(low)

    def ends(self) -> list[End]:
        """Return the solutions of the least and the largest magnitude; none if there are none."""
        start = self.start()
        if start is None:
            return []
        high = self._program.least([-x for x in self._magnitude])
        unbounded = End(None, [Fraction(0)] * len(self.states), self.states)
        return [start, unbounded if high is None else self._end(-high)]

    def magnitudes(self) -> Interval | None:
        """Return the least and the largest magnitude of a solution; None if there is none."""
        low = self._program.least(self._magnitude)
        if low is None:
            return None
        high = self._program.least([-x for x in self._magnitude])
        return low, None if high is None else -high

    def solution(self) -> Solution | None:
        """Return the solution that the last program ended with; None if there is none."""
        return None if (point := self._point()) is None else self.at(self.values(point))

    def at(self, values: Values) -> Solution:
        """Return the motion and the forces of a solution."""
        motion = (values.fraction({j: 1}) for j in range(self.question.rows.n))
        forces = (tuple(map(values.fraction, terms)) for terms in self.forces)
        return Solution(tuple(motion), tuple(forces))

    def holds(self, solution: Solution) -> bool:
        """Return whether motion and forces are a solution of a program without t."""
        numbers: dict[Any, Fraction] = {}
        for i, (normal, *frictions) in enumerate(solution.forces):
            numbers["normal", i] = normal
            numbers |= {("friction", i, j): x for j, x in enumerate(frictions)}
        point = (*solution.motion, *(numbers[force] for force in self._columns))
        at = self.values(point)
        return (
            not any(at.of(x.terms) for x in self._equal)
            and all(at.of(x.terms) >= 0 for x in self._least)
            and self.at(at).forces == solution.forces
        )

    def leaf(self) -> Leaf | None:
        """Return the virtual motion and Farkas multipliers, of springs, slips and displacements.

        None if there is a solution.
        """
        proof = self._program.point()
        if not isinstance(proof, Infeasible):
            return None
        left: Terms = {}
        conditions = *self._least, *self._equal
        factors = *proof.inequality_multipliers, *proof.equality_multipliers
        for condition, factor in zip(conditions, factors, strict=True):
            if factor:
                add(left, condition.terms, exact(factor) * condition.unit)
        n, tangents = self.question.rows.n, range(self.question.rows.tangents)
        multipliers, displacements = (
            {
                i: tuple(fraction(-left.get((name, i, *j), 0)) for name, *j in names)
                for i in range(len(self.states))
            }
            for names in (
                [("spring",), *(("slip", j) for j in tangents)],
                [("displacement", j) for j in range(1 + len(tangents))],
            )
        )
        pairs = zip(proof.equality_multipliers[-n:], self._equal[-n:], strict=True)
        motion = tuple(-x * balance.unit for x, balance in pairs)
        return Leaf(motion, multipliers, displacements)

    def _point(self) -> RationalVector | None:
        """Return the unknowns that the last program ended with."""
        result = self._program.point()
        return None if isinstance(result, Infeasible) else result

    def values(self, point: Sequence[Any]) -> Values:
        """Return the numbers of expressions at a point."""
        keys = (*range(self.size - len(self._columns)), *self._columns)
        return Values(self.question.symbols, keys, point)

    def _end(self, t: Fraction) -> End:
        """Return how far each contact is from the law, and in which state it is, at a solution."""
        point, question = self._point(), self.question
        assert point is not None
        at = self.values(point)
        violations, states = [], []
        for i, (contact, forces) in enumerate(zip(question.rows, self.forces, strict=True)):
            terms = *forces, {("slip", i, 0): 1}, {("spring", i): 1}
            pressed, rubbed, slip, spring = map(at.fraction, terms)
            least, most = question.coefficients(i)
            opposed = -rubbed if slip > 0 else rubbed
            missed = max(Fraction(0), least * pressed - opposed) if slip else Fraction(0)
            if slip and most is not None:
                missed = max(missed, opposed - most * pressed)
            # Without a spring no motion changes a force, and what is missed is all there is.
            rub = min(contact.stiffness * abs(slip), missed) if contact.stiffness else missed
            lift = pressed - max(spring, Fraction(0))
            # Half-planes of any friction have an edge that belongs to no cone.
            edge = abs(rubbed) if most is None and not pressed else 0
            violations.append(rub + _LIFT_WEIGHT * lift + edge)
            slips = "slip+" if slip > 0 else "slip-" if slip < 0 else "stick"
            slips = "attached" if question.is_smooth(i) or question.sign(i, "attached") else slips
            states.append(slips if spring > 0 else "detached")
        return End(t, violations, tuple(states))

    def within(self, other: ContactProgram) -> bool:
        """Return whether all solutions are solutions of another complete program, too.

        Both are of one question, without t.
        """
        equal = [other._carried(x.terms, self) for x in other._equal]
        for mine, theirs in zip(chain(*self.forces), chain(*other.forces), strict=True):
            equal.append(added(mine, other._carried(theirs, self), -1))
        if any(low != 0 or high != 0 for low, high in map(self.range_of, equal)):
            return False
        lows = (self._least_of(other._carried(x.terms, self)) for x in other._least)
        return all(low is not None and low >= 0 for low in lows)

    @property
    def has_one_solution(self) -> bool:
        """Whether all solutions have the same forces."""
        ends = map(self.range_of, chain(*self.forces))
        return all(low is not None and low == high for low, high in ends)

    def is_unloaded(self, i: int) -> bool:
        """Return whether a contact has no force in any solution, of which there are some."""
        return self._always_zero(self.forces[i][0])

    def is_at_limit(self, i: int) -> bool:
        """Return whether a contact with friction is at its limit in all solutions.

        Their set is convex, so they are all at one of its two limits then.
        """
        if not (friction := exact(self.question.coefficients(i)[0])):
            return False
        normal, rubbed = self.forces[i]
        most = times(normal, friction)
        return any(self._always_zero(added(most, rubbed, sign)) for sign in (1, -1))

    def _always_zero(self, terms: Terms) -> bool:
        """Return whether an expression that is at least 0 is 0 in all solutions."""
        point = self._point()
        assert point is not None
        return not self.values(point).of(terms) and self._least_of(times(terms, -1)) == 0

    @staticmethod
    def _carried(terms: Terms, into: ContactProgram) -> Terms:
        """Return an expression in the unknowns of another program."""
        total: Terms = {}
        for key, x in terms.items():
            is_friction = isinstance(key, tuple) and key[0] == "friction"
            add(total, into.forces[key[1]][1 + key[2]] if is_friction else {key: 1}, x)
        return total

    def range_of(self, terms: Terms) -> Interval:
        """Return the least and the largest value of an expression; None where it has none."""
        high = self._least_of(times(terms, -1))
        return self._least_of(terms), None if high is None else -high

    def _least_of(self, terms: Terms) -> Fraction | None:
        """Return the least value of an expression; None if there is none."""
        row, unit = self._whole_row(terms)
        least = self._program.least(row[:-1])
        return None if least is None else (least + row[-1]) / unit

    def split(self, violations: Sequence[Fraction]) -> list[Node]:
        """Return the node with the open contact furthest from the law decided, likeliest last."""
        is_open = self.question.is_open
        open_ = [i for i, state in enumerate(self.states) if is_open(i, state)]
        # Of contacts that miss nothing those go first of which less is known.
        i = max(open_, key=lambda i: (violations[i], self.states[i] == "undecided", -i))
        first = self.states[i] == "undecided"
        parts = ("detached", "attached") if first else ("slip-", "slip+", "stick")
        return [(*self.states[:i], part, *self.states[i + 1 :]) for part in parts]
