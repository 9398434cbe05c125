"""The law of a contact, by its state, as exact linear conditions: once for every solver.

Unknowns are the motion, forces at contacts whose state leaves them open, and a magnitude t: the
load is ``w + t w'``, and each preload ``q + t q'``. The law of a contact, by its state:

* loose: a force in the friction cone, without a spring;
* undecided: ``c_n >= q - k N . d``, in the cone;
* detached: no force, ``q - k N . d <= 0``;
* attached: ``c_n = q - k N . d``, in the cone;
* stick: attached, and ``T . d = 0``;
* slip+, slip-: attached, T . d >= 0 or <= 0, and the friction is the opposite end of the cone.

This is a complementarity problem: of ``c_n >= 0`` and ``c_n >= q - k N . d`` one is an equation,
and so is, where a contact slips, that friction is at its limit. The attached contacts are its
active set. Friction has one tangent or two. With two, or with cones that are no interval, a state
says itself which conditions slip and friction obey, see `ContactState`.

Conditions are written with symbols, the spring ``q - k N . d``, the slip ``T . d`` and the
displacements of each contact: what Farkas multipliers of a program leave of a symbol is the
multiplier of a leaf, and those of the balance are its virtual motion, on which the load does more
virtual work than the contacts can take. The checker of certificates has a law of its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from arrangement.numbers.linear.intervals import Interval
from arrangement.numbers.linear.rank import unit_vectors
from equilibrium.model.contact import Contact
from equilibrium.model.rows import ContactRow, ContactRows

#: Whether a combination of numbers is 0, or at least 0; and its factors.
Side: TypeAlias = tuple[bool, Sequence[Any]]
#: A linear expression: coefficients by columns of unknowns, -1 for the constant, and symbols.
Terms: TypeAlias = dict[Any, Any]
_SIGNS = {"slip+": 1, "slip-": -1}


def spring_row(contact: Contact | ContactRow) -> RationalVector:
    """Return ``(q, -k N)``: the force of a spring at a homogeneous motion ``(d_0, d)``."""
    return (contact.preload, *(-contact.stiffness * x for x in contact.normal_wrench))


def spring_force(contact: Contact | ContactRow, motion: Sequence[Fraction]) -> Fraction:
    """Return ``q - k N . d``: the normal force of a contact that touches; below 0 it does not."""
    force: Fraction = contact.preload - contact.stiffness * dot(contact.normal_wrench, motion)
    return force


def states_of(
    rows: Iterable[Contact | ContactRow], motion: Sequence[Any], forces: Iterable[Sequence[Any]]
) -> tuple[str, ...]:
    """Return the state of each contact in an equilibrium; along two tangents "slip" has no sign."""
    states = []
    for row, (normal, *_) in zip(rows, forces, strict=True):
        slips = [dot(tangent, motion) for tangent in row.tangential_wrenches]
        sign = ("-", "+")[slips[0] > 0] if len(slips) == 1 else ""
        states.append("detached" if not normal else f"slip{sign}" if any(slips) else "stick")
    return tuple(states)


class ContactState(NamedTuple):
    """What a contact does, in conditions.

    Attributes:
        spring: "loose", "undecided", "detached" or "attached".
        slip: conditions on the slip along each tangent.
        friction: conditions on the normal force and the friction along each tangent.
        share: of the friction limit along each tangent, in place of unknown friction.
    """

    spring: str
    slip: tuple[Side, ...] = ()
    friction: tuple[Side, ...] = ()
    share: Sequence[Any] | None = None

    @classmethod
    def of(
        cls,
        name: str,
        tangents: int,
        friction: tuple[Side, ...] = (),
        share: Sequence[Any] | None = None,
    ) -> ContactState:
        """Return the state of a name that is about all slips, with conditions on friction."""
        if name in ("loose", "undecided", "detached"):
            return cls(name, (), () if name == "detached" else friction, share)
        units = unit_vectors(tangents) if name == "stick" else []
        return cls("attached", tuple((True, unit) for unit in units), friction, share)


#: A state by its name, or in conditions.
State: TypeAlias = "str | ContactState"


class Condition:
    """An expression that is 0, or at least 0; and `unit` times it in integers, without symbols."""

    def __init__(self, question: LinearQuestion, terms: Terms) -> None:
        self._question, self.terms = question, terms

    @property
    def row(self) -> dict[Any, int]:
        """The integers by columns and unknown forces."""
        return self._whole[0]

    @property
    def unit(self) -> int:
        """What the integers are divided by."""
        return self._whole[1]

    @cached_property
    def _whole(self) -> tuple[dict[Any, int], int]:
        expanded = self._question.expanded(self.terms)
        unit = math.lcm(*[int(x.denominator) for x in expanded.values()])
        row = {j: int(x.numerator) * (unit // int(x.denominator)) for j, x in expanded.items()}
        return row, unit


class ContactConditions(NamedTuple):
    """The law of one contact in one state; unknown forces are symbols, too.

    Attributes:
        forces: the normal force, and friction along each tangent.
        unknowns: those forces that are no expressions in the motion.
        arms: of each force that is a symbol or unknown its wrench for a force of 1.
    """

    forces: Sequence[Terms]
    unknowns: Sequence[Any]
    least: Sequence[Condition]
    equal: Sequence[Condition]
    arms: Sequence[tuple[Any, Terms]]


@dataclass(frozen=True)
class LinearQuestion:
    """What a program is about; all that changes with the magnitude t has its slope beside it.

    Attributes:
        rows: the contacts.
        load, load_slope: the wrench at t = 0, and what each unit of t adds; None if there is no t.
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
        keeps_normal: whether normal forces of springs are unknowns with an equation each, too:
            programs in floats solve long sparse rows sooner than short dense ones.
    """

    rows: ContactRows
    load: RationalVector
    load_slope: RationalVector | None = None
    preload_slope: Fraction = Fraction(0)
    shares: tuple[Fraction, ...] = ()
    frictions: Interval | None = None
    max_displacement: Fraction | None = None
    chosen: frozenset[int] | None = None
    region: tuple[RationalVector, ...] = ()
    background: tuple[RationalVector, ...] = ()
    signs: tuple[int, ...] = ()
    chords: tuple[RationalVector, ...] = ()
    keeps_normal: bool = False
    #: Conditions by contact and state, as far as they were asked for.
    _known: dict[tuple[int, State], ContactConditions] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    @cached_property
    def _frames(self) -> list[list[Terms]]:
        """The movements of each contact point along its normal and its tangents."""
        return [
            [sparse(x) for x in (contact.normal_wrench, *contact.tangential_wrenches)]
            for contact in self.rows
        ]

    @cached_property
    def symbols(self) -> dict[Any, Terms]:
        """The spring, the slip and the displacements of each contact, in motion, t and 1."""
        symbols: dict[Any, Terms] = {}
        for i, (contact, moves) in enumerate(zip(self.rows, self._frames, strict=True)):
            for j, terms in enumerate(moves):
                symbols["displacement", i, j] = terms
                if j:
                    symbols["slip", i, j - 1] = terms
            symbols["spring", i] = spring = self._of_t(contact.preload, self.slope_of(i))
            add(spring, moves[0], -exact(contact.stiffness))
            if self.chords:
                symbols["chord", i] = expression(self.chords[i])
        return symbols

    def _of_t(self, constant: Any, slope: Any) -> Terms:
        """Return what has a value at t = 0, and a slope."""
        terms = {-1: exact(constant)} if constant else {}
        return {**terms, self.rows.n: exact(slope)} if slope else terms

    @cached_property
    def sides(self) -> list[Condition]:
        """That t is at least 0, and the region."""
        magnitude = [] if self.load_slope is None else [{self.rows.n: 1}]
        return [Condition(self, x) for x in (*magnitude, *map(expression, self.region))]

    @cached_property
    def balance(self) -> list[Terms]:
        """The balance without the forces of the contacts."""
        slopes = self.load_slope or (0,) * self.rows.n
        pairs = zip(self.rows.total_load(self.load), slopes, strict=True)
        lines = [self._of_t(*pair) for pair in pairs]
        for line, row in zip(lines, self.background, strict=False):
            add(line, expression(row))
        return lines

    def conditions(self, i: int, state: State) -> ContactConditions:
        """Return the law of a contact in a state."""
        if (i, state) not in self._known:
            self._known[i, state] = self.law(i, state)
        return self._known[i, state]

    def motion_rows(self, i: int, state: State) -> list[tuple[IntegerVector, bool]]:
        """Return the conditions of a state on the motion alone, without t.

        Returns:
            Rows, constant last, that are at least 0; or, if that is said beside them, 0.
        """
        law = self.conditions(i, state)
        return [
            (tuple(x.row.get(j, 0) for j in (*range(self.rows.n), -1)), is_zero)
            for is_zero, conditions in ((False, law.least), (True, law.equal))
            for x in conditions
            if not any(force in x.row for force in law.unknowns)
        ]

    def unit_wrenches(self, i: int, state: str) -> list[tuple[Any, ...]]:
        """Return the extreme wrenches of a normal force of 1 in a state; along one tangent.

        Those of contacts that may slip either way have friction at both of its limits.
        """
        ends: list[State] = [state]
        if not self.sign(i, state):
            ends = [ContactState.of(state, 1, share=(x,)) for x in (-1, 1)]
        arms = (arm for end in ends for _, arm in self.conditions(i, end).arms)
        return [tuple(arm.get(j, 0) for j in range(self.rows.n)) for arm in arms]

    def law(self, i: int, state: State) -> ContactConditions:
        """Return the same, which is not kept: of states that seldom return."""
        frame = self._frames[i]
        given = state if isinstance(state, ContactState) else self._state(i, state)
        least: list[Terms] = []
        equal: list[Terms] = []
        unknowns: list[Any] = []
        arms: list[tuple[Any, Terms]] = []
        spring: Any = ("spring", i)
        if self.max_displacement is not None and given.spring != "loose":
            most = {-1: exact(self.max_displacement)}
            for j in range(len(frame)):
                least += [{**most, ("displacement", i, j): sign} for sign in (1, -1)]
        if given.spring == "detached":
            least.append({spring: -1})
            forces: list[Terms] = [{}] * len(frame)
        else:
            is_spring = given.spring == "attached"
            unknowns = [] if is_spring and not self.keeps_normal else [("normal", i)]
            pressed = unknowns[0] if unknowns else spring
            if is_spring and unknowns:
                equal.append({pressed: 1, spring: -1})
            forces, arm = [{pressed: 1}], frame[0]
            least.append(forces[0])
            if given.spring == "undecided":
                least.append({pressed: 1, spring: -1})
                if self.chords:
                    least.append({("chord", i): 1, pressed: -1})
            if given.share is None:
                rubs: list[Any] = [("friction", i, j) for j in range(len(frame) - 1)]
                unknowns += rubs
                forces += [{rub: 1} for rub in rubs]
                arms += zip(rubs, frame[1:], strict=True)
            else:
                limit = exact(self.coefficients(i)[0])
                for share, tangent in zip(given.share, frame[1:], strict=True):
                    rubbed = limit * exact(share)
                    forces.append({pressed: rubbed} if rubbed else {})
                    arm = added(arm, tangent, rubbed)
            arms.append((pressed, arm))
        slips: list[Terms] = [{("slip", i, j): 1} for j in range(len(frame) - 1)]
        for of, sides in ((forces, given.friction), (slips, given.slip)):
            for is_zero, factors in sides:
                (equal if is_zero else least).append(combination(of, factors))
        at_least, zero = ([Condition(self, x) for x in every] for every in (least, equal))
        return ContactConditions(forces, unknowns, at_least, zero, arms)

    def _state(self, i: int, name: str) -> ContactState:
        """Return the conditions of a state with a name; along one tangent, or without friction."""
        sign, (low, high), tangents = self.sign(i, name), self.coefficients(i), self.rows.tangents
        friction: list[Side] = []
        share = (-sign,) * tangents if high == 0 or (sign and low == high) else None
        if share is None and sign:
            friction.append((False, (-low, -sign)))
        if share is None and high is not None:
            friction += [(False, (high, x)) for x in ((sign,) if sign else (1, -1))]
        if name in _SIGNS:
            return ContactState("attached", ((False, (sign,)),), tuple(friction), share)
        return ContactState.of(name, tangents, tuple(friction), share)

    def expanded(self, terms: Terms) -> Terms:
        """Return an expression in unknowns, without symbols."""
        total: Terms = {}
        for key, x in terms.items():
            for j, y in self.symbols.get(key, {key: 1}).items():
                more = x * y
                total[j] = total[j] + more if j in total else more
        return total

    def is_chosen(self, i: int) -> bool:
        """Return whether the preload or the friction of a contact is not its own."""
        return self.chosen is None or i in self.chosen

    def slope_of(self, i: int) -> Fraction:
        """Return what each unit of t adds to the preload of a contact."""
        if not self.is_chosen(i):
            return Fraction(0)
        return self.preload_slope * self.shares[i] if self.shares else self.preload_slope

    def at(self, t: Fraction) -> LinearQuestion:
        """Return the question of one magnitude, which does not change with t."""
        slopes = self.load_slope or (Fraction(0),) * len(self.load)
        load = tuple(x + t * y for x, y in zip(self.load, slopes, strict=True))
        contacts = tuple(
            c._replace(preload=c.preload + t * self.slope_of(i)) for i, c in enumerate(self.rows)
        )
        return replace(
            self,
            rows=replace(self.rows, contacts=contacts),
            load=load,
            load_slope=None,
            preload_slope=Fraction(0),
        )

    def with_load(self, load: RationalVector) -> LinearQuestion:
        """Return the question of another load, with what is known of the contacts."""
        other = replace(self, load=load)
        for name in ("_frames", "symbols", "_known"):
            other.__dict__[name] = getattr(self, name)
        return other

    @cached_property
    def at_rest(self) -> LinearQuestion:
        """The question about d = 0 alone, where springs have their preloads.

        Exact programs are many times faster without stiffness.
        """
        contacts = tuple(c._replace(stiffness=Fraction(0)) for c in self.rows)
        return replace(self, rows=replace(self.rows, contacts=contacts))

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


def exact(x: Any) -> Any:
    """Return a fraction as a number of FLINT, whose products take a tenth of the time.

    What is no fraction, as a function of a letter, stays.
    """
    return _flint_rational()(x.numerator, x.denominator) if type(x) is Fraction else x


@cache
def _flint_rational() -> Any:
    from flint import fmpq  # slow to load

    return fmpq


def fraction(x: Any) -> Fraction:
    """Return a number of FLINT as a fraction."""
    return Fraction(int(x.numerator), int(x.denominator))


def sparse(row: Sequence[Any]) -> Terms:
    """Return the entries of a row that are not 0: a contact of many bodies moves two."""
    return {j: exact(x) for j, x in enumerate(row) if x}


def expression(row: RationalVector) -> Terms:
    """Return a row, constant last."""
    return {-1: exact(row[-1]), **sparse(row[:-1])}


def add(terms: Terms, others: Terms, factor: Any = 1) -> None:
    """Add a multiple of an expression to another one."""
    if factor:
        for j, x in others.items():
            if x:
                more = factor * x
                terms[j] = terms[j] + more if j in terms else more


def added(terms: Terms, others: Terms, factor: Any = 1) -> Terms:
    """Return the sum of an expression and a multiple of another one."""
    total = dict(terms)
    add(total, others, factor)
    return total


def times(terms: Terms, factor: Any) -> Terms:
    """Return a multiple of an expression."""
    return {j: factor * x for j, x in terms.items()}


def combination(of: Sequence[Terms], factors: Iterable[Any]) -> Terms:
    """Return the sum of expressions times factors."""
    total: Terms = {}
    for terms, factor in zip(of, factors, strict=True):
        if factor:
            add(total, terms, exact(factor))
    return total
