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
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain
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


class _Condition(NamedTuple):
    """An expression, and `unit` times it in integers and without symbols."""

    terms: _Terms
    row: dict[Any, int]
    unit: int


class _ContactConditions(NamedTuple):
    """The law of one contact in one state; unknown forces are symbols, too.

    Attributes:
        wrench: of its forces, an expression for each coordinate.
    """

    normal: _Terms
    tangential: _Terms
    unknowns: tuple[Any, ...]
    least: tuple[_Condition, ...]
    equal: tuple[_Condition, ...]
    wrench: tuple[_Terms, ...]


@dataclass(frozen=True)
class LinearQuestion:
    """What a program is about; all that changes with the magnitude t has its slope beside it.

    Attributes:
        rows: the contacts.
        load, load_slope: the wrench at t = 0, and what each unit of t adds.
        preload_slope: what each unit of t adds to every preload.
        shares: the part of that of each contact; none for all of it.
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
    shares: tuple[Fraction, ...] = ()
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
            spring = {-1: _exact(contact.preload), self.rows.n: _exact(self.slope_of(i))}
            found["spring", i] = _sum(spring, along, -_exact(contact.stiffness))
            found["slip", i] = across
            if self.chords:
                found["chord", i] = _expression(self.chords[i])
        return found

    @cached_property
    def sides(self) -> list[_Condition]:
        """That t is at least 0, and the region."""
        return [self.condition(x) for x in ({self.rows.n: _ONE}, *map(_expression, self.region))]

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
    def _conditions(self) -> dict[tuple[int, str], _ContactConditions]:
        return {}

    def conditions(self, i: int, state: str) -> _ContactConditions:
        """Return the law of a contact in a state."""
        if (i, state) not in self._conditions:
            self._conditions[i, state] = self._contact(i, state)
        return self._conditions[i, state]

    def _contact(self, i: int, state: str) -> _ContactConditions:
        normal, tangential, unknowns = self._forces(i, state)
        equal: list[_Terms] = [{("slip", i): _ONE}] if state == "stick" else []
        contact = self.rows[i]
        wrench: list[_Terms] = [{} for _ in range(self.rows.n)]
        for terms, unit in (
            (normal, contact.normal_wrench),
            (tangential, contact.tangential_wrenches[0]),
        ):
            for j, x in _sparse(unit).items():
                _add(wrench[j], terms, x)
        least = self._bounds(i, state, normal, tangential)
        conditions = tuple(map(self.condition, least)), tuple(map(self.condition, equal))
        return _ContactConditions(normal, tangential, unknowns, *conditions, tuple(wrench))

    def _forces(self, i: int, state: str) -> tuple[_Terms, _Terms, tuple[Any, ...]]:
        """Return the normal and the tangential force, and which of them are unknowns."""
        if state == "detached":
            return {}, {}, ()
        sign, (low, high) = self.sign(i, state), self.coefficients(i)
        normal, friction = ("normal", i), ("friction", i)
        presses = state in ("loose", "undecided")
        pressed = {normal if presses else ("spring", i): _ONE}
        if high == 0 or (sign and low == high):
            return pressed, _times(pressed, -sign * _exact(low)), (normal,) * presses
        return pressed, {friction: _ONE}, (*(normal,) * presses, friction)

    def _bounds(self, i: int, state: str, normal: _Terms, tangential: _Terms) -> list[_Terms]:
        """Return what is at least 0 at a contact in a state."""
        least: list[_Terms] = []
        sign, (low, high) = self.sign(i, state), map(_exact, self.coefficients(i))
        if self.max_displacement is not None and state != "loose":
            for j in range(2):
                most = {-1: _exact(self.max_displacement)}
                least += _between({("displacement", i, j): _ONE}, most)
        if state == "detached":
            return [*least, {("spring", i): -_ONE}]
        least.append(normal)
        if state == "undecided":
            least.append(_sum(normal, {("spring", i): _ONE}, -1))
            if self.chords:
                least.append(_sum({("chord", i): _ONE}, normal, -1))
        if ("friction", i) in tangential:
            limit = None if high is None else _times(normal, high)
            if sign:
                least.append(_sum(_times(tangential, -sign), normal, -low))
                least += [] if limit is None else [_sum(limit, tangential, sign)]
            elif limit is not None:
                least += _between(tangential, limit)
        if state in _SIGNS:
            least.append({("slip", i): sign * _ONE})
        return least

    def expanded(self, terms: _Terms) -> _Terms:
        """Return an expression in unknowns, without symbols."""
        found: _Terms = {}
        for key, x in terms.items():
            _add(found, self.symbols.get(key) or {key: _ONE}, x)
        return found

    def condition(self, terms: _Terms) -> _Condition:
        """Return an expression that is 0 or at least 0 with its integers."""
        found = self.expanded(terms)
        unit = math.lcm(*(int(x.denominator) for x in found.values()))
        row = {j: int(x.numerator) * (unit // int(x.denominator)) for j, x in found.items()}
        return _Condition(terms, row, unit)

    def is_chosen(self, i: int) -> bool:
        """Return whether the preload or the friction of a contact is not its own."""
        return self.chosen is None or i in self.chosen

    def slope_of(self, i: int) -> Fraction:
        """Return what each unit of t adds to the preload of a contact."""
        if not self.is_chosen(i):
            return _ZERO
        return self.preload_slope * self.shares[i] if self.shares else self.preload_slope

    def at(self, t: Fraction) -> LinearQuestion:
        """Return the question of one magnitude, which does not change with t."""
        load = tuple(x + t * y for x, y in zip(self.load, self.load_slope, strict=True))
        contacts = tuple(
            c._replace(preload=c.preload + t * self.slope_of(i)) for i, c in enumerate(self.rows)
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
        n = self._t = question.rows.n
        contacts = [question.conditions(i, state) for i, state in enumerate(states)]
        #: The columns of unknown forces.
        self._columns = {
            force: n + 1 + k
            for k, force in enumerate(chain.from_iterable(c.unknowns for c in contacts))
        }
        self.size = n + 1 + len(self._columns)
        self._magnitude = [int(j == n) for j in range(self.size)]
        self._normal = [contact.normal for contact in contacts]
        self._tangential = [contact.tangential for contact in contacts]
        balance = list(map(dict, question.balance))
        for contact in contacts:
            for line, terms in zip(balance, contact.wrench, strict=True):
                _add(line, terms)
        self._least = [*question.sides, *chain.from_iterable(c.least for c in contacts)]
        self._equal = [
            *chain.from_iterable(c.equal for c in contacts),
            *(question.condition(line) for line in balance),
        ]
        rows = ([self._row(x.row) for x in every] for every in (self._least, self._equal))
        self._rows = next(rows), next(rows)
        self._program = Program(self.size, *self._rows, deadline)

    def _row(self, terms: Mapping[Any, int]) -> tuple[int, ...]:
        """Return an expression without symbols, in integers, as a row, constant last."""
        row = [0] * (self.size + 1)
        for key, x in terms.items():
            row[key if isinstance(key, int) else self._columns[key]] = x
        return tuple(row)

    def _exact_row(self, terms: _Terms) -> RationalVector:
        """Return a positive multiple of an expression as a row."""
        return tuple(map(Fraction, self._whole_row(terms)[0]))

    def _whole_row(self, terms: _Terms) -> tuple[tuple[int, ...], int]:
        condition = self.question.condition(terms)
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
        pairs = enumerate(zip(self._normal, self._tangential, strict=True))
        forces = [
            (self._exact_row(normal), self._exact_row(rubbed))
            for i, (normal, rubbed) in pairs
            if rubbed and question.coefficients(i)[1] is None
        ]
        least, equal = ([tuple(map(Fraction, row)) for row in rows] for rows in self._rows)
        return any_friction_does(self.size, least, equal, forces, self._deadline)

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

    def magnitudes(self) -> Interval | None:
        """Return the least and the largest magnitude of a solution; None if there is none."""
        low = self._program.least(self._magnitude)
        if low is None:
            return None
        high = self._program.least([-x for x in self._magnitude])
        return low, None if high is None else -high

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
        conditions = *self._least, *self._equal
        factors = *found.inequality_multipliers, *found.equality_multipliers
        for condition, factor in zip(conditions, factors, strict=True):
            if factor:
                _add(left, condition.terms, _exact(factor) * condition.unit)
        multipliers, displacements = (
            {
                i: tuple(_fraction(-left.get((name, i, *more), 0)) for name, *more in names)
                for i in range(len(self.states))
            }
            for names in _MULTIPLIERS
        )
        n = self.question.rows.n
        pairs = zip(found.equality_multipliers[-n:], self._equal[-n:], strict=True)
        motion = tuple(-x * balance.unit for x, balance in pairs)
        return FarkasLeaf(motion, multipliers, displacements)

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
        equal = [other._carried(x.terms, self) for x in other._equal]
        for mine, theirs in ((self._normal, other._normal), (self._tangential, other._tangential)):
            for one, terms in zip(mine, theirs, strict=True):
                equal.append(_sum(one, other._carried(terms, self), -1))
        if not all(self._least_of(_times(terms, sign)) == 0 for terms in equal for sign in (1, -1)):
            return False
        # The first condition is that of t.
        lows = (self._least_of(other._carried(x.terms, self)) for x in other._least[1:])
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

    @staticmethod
    def _carried(terms: _Terms, into: ContactProgram) -> _Terms:
        """Return an expression in the unknowns of another program."""
        found: _Terms = {}
        for key, x in terms.items():
            is_friction = isinstance(key, tuple) and key[0] == "friction"
            _add(found, into._tangential[key[1]] if is_friction else {key: _ONE}, x)
        return found

    def _least_of(self, terms: _Terms) -> Fraction | None:
        """Return the least value of an expression; None if there is none."""
        row, unit = self._whole_row(terms)
        least = self._program.least(row[:-1])
        return None if least is None else (least + row[-1]) / unit

    def _value(self, terms: _Terms, point: RationalVector) -> Fraction:
        """Return an expression at a point, whose last number is 1."""
        places = (
            (key if isinstance(key, int) else self._columns[key], x)
            for key, x in self.question.expanded(terms).items()
        )
        return _fraction(sum(x * _exact(point[j]) for j, x in places))

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


def _between(terms: _Terms, most: _Terms) -> list[_Terms]:
    """Return what is at least 0 where the size of an expression is at most another one."""
    return [_sum(most, terms, sign) for sign in (1, -1)]


def _times(terms: _Terms, factor: Any) -> _Terms:
    return {j: factor * x for j, x in terms.items()}
