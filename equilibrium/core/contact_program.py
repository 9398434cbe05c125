"""The law of contacts as one exact linear program, with some of the contact states still open.

Unknowns are the motion, forces at contacts whose state leaves them open, and a magnitude t: the
load is ``w + t w'``, and each preload ``q + t q'``. The law of a contact, by its state:

* loose: a force in the friction cone, without a spring;
* undecided: ``c_n >= q - k N . d``, in the cone;
* detached: no force, ``q - k N . d <= 0``;
* attached: ``c_n = q - k N . d``, in the cone;
* stick: attached, and ``T . d = 0``;
* slip+, slip-: attached, T . d >= 0 or <= 0, and the friction is the opposite end of the cone.

With all contacts decided this is the law itself, else a relaxation: it has every solution.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.programs import Infeasible, Program
from equilibrium.core.contact_rows import any_friction_does
from equilibrium.model.effort import Effort
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution

#: The states of all contacts.
Node = tuple[str, ...]
#: A linear expression in the unknowns: coefficients by columns.
_Terms = dict[int, Fraction]
_SIGNS = {"slip+": 1, "slip-": -1}
#: Whether a contact touches is split before how it slips, by this factor of what is missed.
_LIFT_WEIGHT = 3


@dataclass(frozen=True)
class LinearQuestion:
    """What a program is about; all that changes with the magnitude t has its slope beside it.

    Attributes:
        rows: the contacts.
        load, load_slope: the wrench at t = 0, and what each unit of t adds.
        preload_slope: what each unit of t adds to every preload.
        frictions: the least and the largest coefficient, in place of those of the contacts, which
            may differ between contacts; the largest may be None, for any.
        chosen: places in `rows` of the contacts that `preload_slope` and `frictions` are about;
            None for all.
        max_displacement: how far contact points may move, if bounded.
    """

    rows: ContactRows
    load: RationalVector
    load_slope: RationalVector
    preload_slope: Fraction = Fraction(0)
    frictions: Interval | None = None
    max_displacement: Fraction | None = None
    chosen: frozenset[int] | None = None

    def is_chosen(self, i: int) -> bool:
        """Return whether the preload or the friction of a contact is not its own."""
        return self.chosen is None or i in self.chosen

    def at(self, t: Fraction) -> LinearQuestion:
        """Return the question of one magnitude, which does not change with t."""
        load = tuple(x + t * y for x, y in zip(self.load, self.load_slope, strict=True))
        contacts = tuple(
            c._replace(preload=c.preload + t * self.preload_slope) if self.is_chosen(i) else c
            for i, c in enumerate(self.rows)
        )
        still = (Fraction(0),) * len(load)
        return replace(
            self,
            rows=replace(self.rows, contacts=contacts),
            load=load,
            load_slope=still,
            preload_slope=Fraction(0),
        )

    def coefficients(self, i: int) -> tuple[Fraction, Fraction | None]:
        """Return the least and the largest friction coefficient of a contact."""
        if self.frictions is None or not self.is_chosen(i):
            return self.rows[i].friction, self.rows[i].friction
        return self.frictions[0] or Fraction(0), self.frictions[1]

    def is_smooth(self, i: int) -> bool:
        """Return whether a contact has no friction."""
        return self.coefficients(i)[1] == 0

    def is_open(self, i: int, state: str) -> bool:
        """Return whether a contact is not decided."""
        return state == "undecided" or (state == "attached" and not self.is_smooth(i))


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
        forces: list[tuple[int | None, int | None]] = []
        size = n
        for i, state in enumerate(states):
            presses = state in ("loose", "undecided")
            least, most = question.coefficients(i)
            rubs = not (state == "detached" or most == 0 or (state in _SIGNS and least == most))
            forces.append((size if presses else None, size + presses if rubs else None))
            size += presses + rubs
        self.size, self._t = size + 1, size
        self._magnitude = [Fraction(0)] * size + [Fraction(1)]
        #: The columns of tangential forces that are unknowns.
        self._rubbing = {j: i for i, (_, j) in enumerate(forces) if j is not None}
        self._equal: list[RationalVector] = []
        self._least: list[RationalVector] = [self._row({self._t: Fraction(1)})]
        self._normal: list[_Terms] = []
        self._tangential: list[_Terms] = []
        self._slips: list[_Terms] = []
        self._springs: list[_Terms] = []
        for i, (state, (pressing, rubbing)) in enumerate(zip(states, forces, strict=True)):
            self._add_contact(i, state, pressing, rubbing)
        load = question.rows.total_load(question.load)
        for j in range(n):
            line: _Terms = {-1: load[j], self._t: question.load_slope[j]}
            for i, contact in enumerate(question.rows):
                _add(line, self._normal[i], contact.normal_wrench[j])
                _add(line, self._tangential[i], contact.tangential_wrenches[0][j])
            self._equal.append(self._row(line))
        self._program = Program(self.size, self._least, self._equal, deadline)

    def _add_contact(self, i: int, state: str, pressing: int | None, rubbing: int | None) -> None:
        question, one = self.question, Fraction(1)
        contact = question.rows[i]
        slip, along = _sparse(contact.tangential_wrenches[0]), _sparse(contact.normal_wrench)
        spring = _times(along, -contact.stiffness)
        slope = question.preload_slope if question.is_chosen(i) else Fraction(0)
        _add(spring, {-1: contact.preload, self._t: slope})
        normal = spring if pressing is None else {pressing: one}
        tangential: _Terms = {} if rubbing is None else {rubbing: one}
        low, high = question.coefficients(i)
        sign = _SIGNS.get(state, 0)
        if question.max_displacement is not None and state != "loose":
            for row in (along, slip):
                self._bounded(row, {-1: question.max_displacement})
        if state == "detached":
            self._at_least(_times(spring, -1))
            normal = tangential = {}
        else:
            self._at_least(normal)
            if state == "undecided":
                self._at_least(_sum(normal, spring, -1))
            if rubbing is None:
                tangential = _times(normal, -sign * low)
            elif sign:
                self._at_least(_sum(_times(tangential, -sign), normal, -low))
                if high is not None:
                    self._at_least(_sum(_times(normal, high), tangential, sign))
            elif high is not None:
                self._bounded(tangential, _times(normal, high))
            if sign:
                self._at_least(_times(slip, sign))
            elif state == "stick":
                self._equal.append(self._row(slip))
        self._normal.append(normal)
        self._tangential.append(tangential)
        self._slips.append(slip)
        self._springs.append(spring)

    def _bounded(self, terms: _Terms, most: _Terms) -> None:
        """Add that the size of an expression is at most another one."""
        for sign in (1, -1):
            self._at_least(_sum(most, terms, sign))

    def _at_least(self, terms: _Terms) -> None:
        self._least.append(self._row(terms))

    def _row(self, terms: _Terms) -> RationalVector:
        row = [Fraction(0)] * (self.size + 1)
        for j, x in terms.items():
            row[j] = x
        return tuple(row)

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
        pairs = enumerate(zip(self._normal, self._tangential, strict=True))
        forces = [
            (self._row(normal), self._row(rubbed))
            for i, (normal, rubbed) in pairs
            if rubbed and question.coefficients(i)[1] is None
        ]
        return any_friction_does(self.size, self._least, self._equal, forces, self._deadline)

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

    def solution(self) -> Solution | None:
        """Return the solution that the last program ended with; None if there is none."""
        if (point := self._point()) is None:
            return None
        pairs = zip(self._normal, self._tangential, strict=True)
        forces = tuple(tuple(_value(terms, point) for terms in pair) for pair in pairs)
        return Solution(point[: self.question.rows.n], forces)

    def _point(self) -> RationalVector | None:
        """Return the unknowns that the last program ended with, and 1 as the last number."""
        found = self._program.point()
        return None if isinstance(found, Infeasible) else (*found, Fraction(1))

    def _end(self, t: Fraction) -> End:
        """Return how far each contact is from the law, and in which state it is, at a solution."""
        point, question = self._point(), self.question
        assert point is not None
        violations, states = [], []
        terms = zip(self._normal, self._tangential, self._slips, self._springs, strict=True)
        for i, (contact, values) in enumerate(zip(question.rows, terms, strict=True)):
            pressed, rubbed, slip, spring = (_value(one, point) for one in values)
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
            slips = "attached" if question.is_smooth(i) else slips
            states.append(slips if spring > 0 else "detached")
        return End(t, violations, tuple(states))

    def within(self, other: ContactProgram) -> bool:
        """Return whether all solutions are solutions of another complete program, too.

        Both are of one question whose load and preloads do not change with t.
        """
        equal = [other._terms(row, self) for row in other._equal]
        for mine, theirs in ((self._normal, other._normal), (self._tangential, other._tangential)):
            for one, terms in zip(mine, theirs, strict=True):
                equal.append(_sum(one, other._carried(terms, self), -1))
        if not all(self._least_of(_times(terms, sign)) == 0 for terms in equal for sign in (1, -1)):
            return False
        # The first condition is that of t.
        lows = (self._least_of(other._terms(row, self)) for row in other._least[1:])
        return all(low is not None and low >= 0 for low in lows)

    @property
    def has_one_solution(self) -> bool:
        """Whether all solutions have the same forces."""
        forces = (*self._normal, *self._tangential)
        ends = ((self._least_of(terms), self._least_of(_times(terms, -1))) for terms in forces)
        return all(low is not None and high == -low for low, high in ends)

    def is_unloaded(self, i: int) -> bool:
        """Return whether a contact has no force in any solution, of which there are some."""
        return self._always_zero(self._normal[i])

    def is_at_limit(self, i: int) -> bool:
        """Return whether a contact with friction is at its limit in all solutions.

        Their set is convex, so they are all at one of its two limits then.
        """
        if not (friction := self.question.coefficients(i)[0]):
            return False
        most, rubbed = _times(self._normal[i], friction), self._tangential[i]
        return any(self._always_zero(_sum(most, rubbed, sign)) for sign in (1, -1))

    def _always_zero(self, terms: _Terms) -> bool:
        """Return whether an expression that is at least 0 is 0 in all solutions."""
        point = self._point()
        assert point is not None
        return not _value(terms, point) and self._least_of(_times(terms, -1)) == 0

    def _terms(self, row: RationalVector, into: ContactProgram) -> _Terms:
        """Return a row as an expression in the unknowns of another program."""
        return self._carried({j if j < self.size else -1: x for j, x in enumerate(row) if x}, into)

    def _carried(self, terms: _Terms, into: ContactProgram) -> _Terms:
        """Return an expression in the unknowns of another program."""
        found: _Terms = {}
        for j, x in terms.items():
            i = self._rubbing.get(j)
            _add(found, {j: Fraction(1)} if i is None else into._tangential[i], x)
        return found

    def _least_of(self, terms: _Terms) -> Fraction | None:
        """Return the least value of an expression; None if there is none."""
        least = self._program.least(self._row({j: x for j, x in terms.items() if j >= 0})[:-1])
        return None if least is None else least + terms.get(-1, Fraction(0))

    def split(self, violations: Sequence[Fraction]) -> list[Node]:
        """Return the node with the open contact furthest from the law decided, likeliest last."""
        is_open = self.question.is_open
        open_ = [i for i, state in enumerate(self.states) if is_open(i, state)]
        # Of contacts that miss nothing those go first of which less is known.
        i = max(open_, key=lambda i: (violations[i], self.states[i] == "undecided", -i))
        first = self.states[i] == "undecided"
        parts = ("detached", "attached") if first else ("slip-", "slip+", "stick")
        return [(*self.states[:i], part, *self.states[i + 1 :]) for part in parts]


def _sparse(row: RationalVector) -> _Terms:
    """Return the entries of a row that are not 0: a contact of many bodies moves two."""
    return {j: x for j, x in enumerate(row) if x}


def _add(terms: _Terms, others: _Terms, factor: Fraction | int = 1) -> None:
    if factor:
        for j, x in others.items():
            if x:
                more = x if factor == 1 else factor * x
                terms[j] = terms[j] + more if j in terms else more


def _sum(terms: _Terms, others: _Terms, factor: Fraction | int = 1) -> _Terms:
    found = dict(terms)
    _add(found, others, factor)
    return found


def _times(terms: _Terms, factor: Fraction | int) -> _Terms:
    return {j: -x if factor == -1 else factor * x for j, x in terms.items()}


def _value(terms: _Terms, point: Sequence[Fraction]) -> Fraction:
    return sum((x * point[j] for j, x in terms.items()), Fraction(0))
