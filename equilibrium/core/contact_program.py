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

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.programs import Infeasible, Program
from equilibrium.core.contact_rows import any_friction_does
from equilibrium.model.effort import Effort
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Solution

#: The states of all contacts.
Node = tuple[str, ...]
#: A linear expression: coefficients by columns of unknowns, -1 for the constant, and symbols.
_Terms: TypeAlias = dict[Any, Any]
#: The symbols whose multipliers stand together in a leaf.
_MULTIPLIERS = (("spring",), ("slip",)), (("displacement", 0), ("displacement", 1))
_ZERO, _ONE = Fraction(0), 1
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
        region: rows, constant last, that are at least 0 at the motions in question.
        background: wrench of further contacts, whose states are known, as a row for each number.
        signs: of the slips that these motions allow each contact, 0 for both; none if unknown.
        chords: rows that normal forces are at most at these motions; none if unknown.
    """

    rows: ContactRows
    load: RationalVector
    load_slope: RationalVector
    preload_slope: Fraction = Fraction(0)
    frictions: Interval | None = None
    max_displacement: Fraction | None = None
    chosen: frozenset[int] | None = None
    region: tuple[RationalVector, ...] = ()
    background: tuple[RationalVector, ...] = ()
    signs: tuple[int, ...] = ()
    chords: tuple[RationalVector, ...] = ()

    @cached_property
    def symbols(self) -> dict[Any, _Terms]:
        """The spring, the slip and the displacements of each contact, in motion, t and 1."""
        found: dict[Any, _Terms] = {}
        for i, contact in enumerate(self.rows):
            wrenches = contact.normal_wrench, *contact.tangential_wrenches
            along, across = map(_sparse, wrenches)
            found["displacement", i, 0], found["displacement", i, 1] = along, across
            slope = self.preload_slope if self.is_chosen(i) else _ZERO
            spring = {-1: _exact(contact.preload), self.rows.n: _exact(slope)}
            found["spring", i] = _sum(spring, along, -_exact(contact.stiffness))
            found["slip", i] = across
            if self.chords:
                found["chord", i] = _expression(self.chords[i])
        return found

    @cached_property
    def sides(self) -> list[_Terms]:
        """The region as expressions that are at least 0."""
        return list(map(_expression, self.region))

    @cached_property
    def balance(self) -> list[_Terms]:
        """The balance without the forces of the contacts."""
        lines = []
        for j, load in enumerate(self.rows.total_load(self.load)):
            line = {-1: _exact(load), self.rows.n: _exact(self.load_slope[j])}
            if self.background:
                _add(line, _expression(self.background[j]))
            lines.append(line)
        return lines

    @cached_property
    def wrenches(self) -> list[list[list[Any]]]:
        """The wrenches of unit forces of each contact."""
        rows = ((c.normal_wrench, *c.tangential_wrenches) for c in self.rows)
        return [[list(map(_exact, row)) for row in wrenches] for wrenches in rows]

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

    def sign(self, i: int, state: str) -> int:
        """Return the sign of the slip of a contact in a state; 0 where it may be any."""
        return _SIGNS.get(state) or (
            self.signs[i] if self.signs and state in ("undecided", "attached") else 0
        )

    def is_open(self, i: int, state: str) -> bool:
        """Return whether a contact is not decided."""
        if state == "attached":
            return not (self.is_smooth(i) or self.sign(i, state))
        return state == "undecided"


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


class FarkasLeaf(NamedTuple):
    """Why a program has no solution: see `equilibrium.certificate.states`.

    Attributes:
        motion: virtual.
        multipliers: of the spring and the slip of each contact.
        displacements: the same of its bounded displacements.
    """

    motion: RationalVector
    multipliers: dict[int, RationalVector]
    displacements: dict[int, RationalVector]


class ContactProgram:
    """The program of one node.

    Conditions are written with symbols, the spring ``q - k N . d``, the slip ``T . d`` and the
    displacements of each contact. What Farkas' multipliers leave of a symbol is the multiplier of
    a leaf.

    Args:
        deadline: looked at before each pivot.
    """

    def __init__(
        self, question: LinearQuestion, states: Node, deadline: Effort | None = None
    ) -> None:
        self.question, self.states, self._deadline = question, states, deadline
        n = question.rows.n
        forces: list[tuple[int | None, int | None]] = []
        size = n + 1
        for i, state in enumerate(states):
            presses = state in ("loose", "undecided")
            least, most = question.coefficients(i)
            slides = question.sign(i, state) and least == most
            rubs = not (state == "detached" or most == 0 or slides)
            forces.append((size if presses else None, size + presses if rubs else None))
            size += presses + rubs
        self.size, self._t = size, n
        self._magnitude = [int(j == n) for j in range(size)]
        #: The columns of tangential forces that are unknowns.
        self._rubbing = {j: i for i, (_, j) in enumerate(forces) if j is not None}
        self._symbols = question.symbols
        self._equal: list[_Terms] = []
        self._least: list[_Terms] = [{n: _ONE}, *question.sides]
        self._normal: list[_Terms] = []
        self._tangential: list[_Terms] = []
        for i, (state, (pressing, rubbing)) in enumerate(zip(states, forces, strict=True)):
            self._add_contact(i, state, pressing, rubbing)
        for j, line in enumerate(question.balance):
            total = dict(line)
            for i, (normal, *tangents) in enumerate(question.wrenches):
                _add(total, self._normal[i], normal[j])
                for tangent in tangents:
                    _add(total, self._tangential[i], tangent[j])
            self._equal.append(total)
        rows = [self._row(terms) for terms in (*self._least, *self._equal)]
        #: The rows of all are so many times the expressions.
        self._units = [unit for _, unit in rows]
        count = len(self._least)
        self._rows = [row for row, _ in rows[:count]], [row for row, _ in rows[count:]]
        self._program = Program(self.size, *self._rows, deadline)

    def _add_contact(self, i: int, state: str, pressing: int | None, rubbing: int | None) -> None:
        question = self.question
        spring: _Terms = {("spring", i): _ONE}
        normal = spring if pressing is None else {pressing: _ONE}
        tangential: _Terms = {} if rubbing is None else {rubbing: _ONE}
        low, high = map(_exact, question.coefficients(i))
        sign = question.sign(i, state)
        if question.max_displacement is not None and state != "loose":
            for j in range(2):
                most = {-1: _exact(question.max_displacement)}
                self._bounded({("displacement", i, j): _ONE}, most)
        if state == "detached":
            self._least.append(_times(spring, -1))
            normal = tangential = {}
        else:
            self._least.append(normal)
            if state == "undecided":
                self._least.append(_sum(normal, spring, -1))
                if question.chords:
                    self._least.append(_sum({("chord", i): _ONE}, normal, -1))
            if rubbing is None:
                tangential = _times(normal, -sign * low)
            elif sign:
                self._least.append(_sum(_times(tangential, -sign), normal, -low))
                if high is not None:
                    self._least.append(_sum(_times(normal, high), tangential, sign))
            elif high is not None:
                self._bounded(tangential, _times(normal, high))
            if state in _SIGNS:
                self._least.append({("slip", i): sign * _ONE})
            elif state == "stick":
                self._equal.append({("slip", i): _ONE})
        self._normal.append(normal)
        self._tangential.append(tangential)

    def _bounded(self, terms: _Terms, most: _Terms) -> None:
        """Add that the size of an expression is at most another one."""
        self._least += [_sum(most, terms, sign) for sign in (1, -1)]

    def _expanded(self, terms: _Terms) -> _Terms:
        """Return an expression without symbols."""
        found: _Terms = {}
        for key, x in terms.items():
            if isinstance(key, int):
                found[key] = found[key] + x if key in found else x
            else:
                _add(found, self._symbols[key], x)
        return found

    def _row(self, terms: _Terms) -> tuple[tuple[Any, ...], int]:
        """Return a row of integers, constant last, and how many times the expression it is."""
        found = self._expanded(terms)
        unit = math.lcm(*(int(x.denominator) for x in found.values()))
        row = [0] * (self.size + 1)
        for j, x in found.items():
            row[j] = int(x.numerator) * (unit // int(x.denominator))
        return tuple(row), unit

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
            (self._row(normal)[0], self._row(rubbed)[0])
            for i, (normal, rubbed) in pairs
            if rubbed and question.coefficients(i)[1] is None
        ]
        return any_friction_does(self.size, *self._rows, forces, self._deadline)

    def some_end(self) -> End | None:
        """Return a solution; None if there is none."""
        point = self._point()
        return None if point is None else self._end(point[self._t])

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
        forces = tuple(tuple(self._value(terms, point) for terms in pair) for pair in pairs)
        return Solution(point[: self.question.rows.n], forces)

    def leaf(self) -> FarkasLeaf | None:
        """Return the virtual motion and multipliers that show that there is no solution, if so."""
        found = self._program.point()
        if not isinstance(found, Infeasible):
            return None
        left: _Terms = {}
        every, units = (*self._least, *self._equal), self._units
        factors = *found.inequality_multipliers, *found.equality_multipliers
        for terms, factor, unit in zip(every, factors, units, strict=True):
            if factor:
                _add(left, terms, _exact(factor) * unit)
        multipliers, displacements = (
            {
                i: tuple(_fraction(-left.get((name, i, *more), 0)) for name, *more in names)
                for i in range(len(self.states))
            }
            for names in _MULTIPLIERS
        )
        n = self.question.rows.n
        pairs = zip(found.equality_multipliers[-n:], units[-n:], strict=True)
        return FarkasLeaf(tuple(-x * unit for x, unit in pairs), multipliers, displacements)

    def _point(self) -> RationalVector | None:
        """Return the unknowns that the last program ended with, and 1 as the last number."""
        found = self._program.point()
        return None if isinstance(found, Infeasible) else (*found, Fraction(1))

    def _end(self, t: Fraction) -> End:
        """Return how far each contact is from the law, and in which state it is, at a solution."""
        point, question = self._point(), self.question
        assert point is not None
        violations, states = [], []
        pairs = zip(question.rows, self._normal, self._tangential, strict=True)
        for i, (contact, normal, tangential) in enumerate(pairs):
            terms = normal, tangential, {("slip", i): _ONE}, {("spring", i): _ONE}
            pressed, rubbed, slip, spring = (self._value(x, point) for x in terms)
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

        Both are of one question whose load and preloads do not change with t.
        """
        equal = [other._carried(terms, self) for terms in other._equal]
        for mine, theirs in ((self._normal, other._normal), (self._tangential, other._tangential)):
            for one, terms in zip(mine, theirs, strict=True):
                equal.append(_sum(one, other._carried(terms, self), -1))
        if not all(self._least_of(_times(terms, sign)) == 0 for terms in equal for sign in (1, -1)):
            return False
        # The first condition is that of t.
        lows = (self._least_of(other._carried(terms, self)) for terms in other._least[1:])
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
        if not (friction := _exact(self.question.coefficients(i)[0])):
            return False
        most, rubbed = _times(self._normal[i], friction), self._tangential[i]
        return any(self._always_zero(_sum(most, rubbed, sign)) for sign in (1, -1))

    def _always_zero(self, terms: _Terms) -> bool:
        """Return whether an expression that is at least 0 is 0 in all solutions."""
        point = self._point()
        assert point is not None
        return not self._value(terms, point) and self._least_of(_times(terms, -1)) == 0

    def _carried(self, terms: _Terms, into: ContactProgram) -> _Terms:
        """Return an expression in the unknowns of another program."""
        found: _Terms = {}
        for j, x in terms.items():
            i = self._rubbing.get(j)
            _add(found, {j: _ONE} if i is None else into._tangential[i], x)
        return found

    def _least_of(self, terms: _Terms) -> Fraction | None:
        """Return the least value of an expression; None if there is none."""
        row, unit = self._row(terms)
        least = self._program.least(row[:-1])
        return None if least is None else (least + row[-1]) / unit

    def _value(self, terms: _Terms, point: RationalVector) -> Fraction:
        """Return an expression at a point, whose last number is 1."""
        return _fraction(sum(x * _exact(point[j]) for j, x in self._expanded(terms).items()))

    def split(self, violations: Sequence[Fraction]) -> list[Node]:
        """Return the node with the open contact furthest from the law decided, likeliest last."""
        is_open = self.question.is_open
        open_ = [i for i, state in enumerate(self.states) if is_open(i, state)]
        # Of contacts that miss nothing those go first of which less is known.
        i = max(open_, key=lambda i: (violations[i], self.states[i] == "undecided", -i))
        first = self.states[i] == "undecided"
        parts = ("detached", "attached") if first else ("slip-", "slip+", "stick")
        return [(*self.states[:i], part, *self.states[i + 1 :]) for part in parts]


def _exact(x: Fraction | int | None) -> Any:
    """Return a number of FLINT, whose products take a tenth of the time; None stays."""
    from flint import fmpq

    return None if x is None else fmpq(x.numerator, x.denominator)


def _fraction(x: Any) -> Fraction:
    return Fraction(int(x.numerator), int(x.denominator))


def _sparse(row: Sequence[Fraction]) -> _Terms:
    """Return the entries of a row that are not 0: a contact of many bodies moves two."""
    return {j: _exact(x) for j, x in enumerate(row) if x}


def _expression(row: RationalVector) -> _Terms:
    """Return a row, constant last."""
    return {-1: _exact(row[-1]), **_sparse(row[:-1])}


def _add(terms: _Terms, others: _Terms, factor: Any = 1) -> None:
    if factor:
        for j, x in others.items():
            if x:
                more = factor * x
                terms[j] = terms[j] + more if j in terms else more


def _sum(terms: _Terms, others: _Terms, factor: Any = 1) -> _Terms:
    found = dict(terms)
    _add(found, others, factor)
    return found


def _times(terms: _Terms, factor: Any) -> _Terms:
    return {j: factor * x for j, x in terms.items()}
