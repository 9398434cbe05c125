"""Why a leaf proves that nothing balances the load: the one rule of the checker, in four steps.

A leaf stands for a region of motions in R^n and for states of contacts. It has a virtual motion
lambda, and multipliers alpha, h of some contacts (Farkas multipliers of the rows of the law).

1. *Region.* It is the cone of integer generators ``g = (g_0, d)`` with ``g_0 >= 0``, and has the
   motions ``d / g_0``; in a tree that distinguishes states alone these are all motions, and the
   generators e_0, +-e_1, ..., +-e_n. A contact with unit wrenches N and T (two T in space),
   friction mu, stiffness k and preload q has the spring ``e = q g_0 - k N . d`` and the slip
   ``s = T . d``; its normal force is ``max(0, e)``. States are closed conditions: e <= 0 if it is
   detached, e >= 0 if it is attached, and then s = 0 in stick, s >= 0 in slip+, s <= 0 in slip-,
   and s between the ends of a sector or of a part of a pyramid.
2. *Factor.* With ``a = lambda . N`` and ``b = T lambda`` the work of a contact on lambda is at
   least kappa times its normal force, by all friction that its slip allows. Kappa is a less mu
   times the greatest product of b with the unit vectors in which the contact may slip: that is |b|
   where all are possible; b in slip+ and -b in slip-, also where all s > 0, or all s < 0, while it
   is undecided or attached; in the sector from u to v it is |b| if b is in the sector, else it is
   at an end, ``u . b / |u|`` or ``v . b / |v|``; in a pyramid it is at an edge. Roots are compared
   by their squares.
3. *Least work.* The contact does at least ``alpha e + h s`` for every motion, if

   * ``alpha >= 0`` where it is undecided or detached;
   * ``alpha <= kappa`` unless it is detached;
   * h = 0 but where it sticks, and where it slips with ``h . u <= 0`` for the ends u of the
     directions.

   A contact without multipliers that is not detached does at each generator at least

   * ``kappa e``, if all e >= 0;
   * ``min(0, kappa) max(0, e)`` otherwise, which is concave in g: between generators it is not
     below its interpolation. Of all motions that is of use for ``kappa >= 0`` alone, as 0.
4. *Sum.* The load, with all adhesion, is a constant wrench w and does ``lambda . w g_0``. The leaf
   holds if load and least works together are at least 0 at each generator, and above 0 where ``g_0
   > 0``. Each motion of the region is a sum of generators, some with ``g_0 > 0``, so there load and
   contacts do work on lambda together. Forces that balance do none. For all motions that says: what
   depends on d cancels, and the rest is above 0.

Steps 2 and 3 of one contact are in `contact_rule`.

Where only displacements of contact points up to D count, a leaf may give numbers u of contacts, for
the normal and each tangent. They take ``|u| D g_0 - u N . d`` and the same for tangents from the
sum, which is at least 0 there: see `equilibrium.certificate.law.displacement_work`.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain, product
from typing import Any, NamedTuple

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, integers_over, quotient
from equilibrium.model.solution import Leaf
from equilibrium.model.subject import Subject

from .contact_rule import (
    State,
    broken_multipliers,
    greatest_product,
    state_text,
    with_sign,
    within_room,
)
from .law import LawRow, applied, displacement_work, rows_of, short
from .reading import Place, TreeForm, form_of


class Generator(NamedTuple):
    """A generator of a region in the plane, with multiples of e and s of each contact there."""

    vector: IntegerVector
    springs: IntegerVector
    slips: IntegerVector


class LeafWork(NamedTuple):
    """What load and contacts do on the virtual motion of a leaf.

    Attributes:
        broken: the condition on multipliers that fails, or nothing.
        total: at least that at each generator, over `unit`; of all motions the sum's n + 1
            coefficients.
        factors: kappa of each contact and its unit; None where it has no force, or an irrational
            factor.
    """

    broken: str
    total: Sequence[Any]
    unit: int
    factors: Sequence[tuple[Any, int] | None]


class _IntegerContact(NamedTuple):
    """A contact; rows are homogeneous, of n + 1 numbers.

    Attributes:
        wrenches: (0, N), then (0, T) of each tangent, over `unit`.
        spring: (q, -k N), over `spring_unit`.
        signs: numbers with the signs of e among all motions.
    """

    wrenches: tuple[IntegerVector, ...]
    unit: int
    spring: IntegerVector
    spring_unit: int
    signs: IntegerVector
    friction: Fraction


class TreeQuestion:
    """Contacts and load of a tree, in integers.

    Args:
        rows: of the contacts, in R^n.
        form: of the tree.
        edges: of friction pyramids; none for cones, in space round ones.
        max_displacement: how far contact points may move, if bounded.
    """

    def __init__(
        self,
        rows: Sequence[LawRow],
        load: RationalVector,
        form: TreeForm,
        edges: Sequence[RationalVector] = (),
        max_displacement: Fraction | None = None,
    ) -> None:
        self.form, self.edges, self.max_displacement = form, edges, max_displacement
        self._round = form.tangents == 2 and not edges
        self.contacts: list[_IntegerContact] = []
        load = applied(rows, load)
        units = [_denominator(load)]
        for row in rows:
            spring = (row.preload, *(-row.stiffness * x for x in row.wrenches[0]))
            unit, spring_unit = _denominator(chain(*row.wrenches)), _denominator(spring)
            wrenches = tuple((0, *integers_over(wrench, unit)) for wrench in row.wrenches)
            spring_row = integers_over(spring, spring_unit)
            # Without stiffness, which is for contacts in the plane, no motion changes a spring.
            signs = (1, -1) if any(spring_row[1:]) else spring_row[:1]
            contact = _IntegerContact(wrenches, unit, spring_row, spring_unit, signs, row.friction)
            self.contacts.append(contact)
            units.append(unit * spring_unit * row.friction.denominator)
        #: Of sums, for a virtual motion in integers.
        self.unit = math.lcm(*units)
        self.load = integers_over(load, self.unit)

    @classmethod
    def of(
        cls,
        subject: Subject,
        load: RationalVector,
        edges: Sequence[RationalVector] = (),
        max_displacement: Fraction | None = None,
    ) -> TreeQuestion:
        """Return the question of a tree about a grasp or an assembly."""
        return cls(rows_of(subject), load, form_of(subject), edges, max_displacement)

    @property
    def root(self) -> list[Generator]:
        """The generators of all motions: e_0, then +-e_1, +-e_2, ...; none in a tree of states."""
        if "orthants" not in self.form.splits:
            return []
        size = self.form.size + 1
        axes = [(0, 1), *product(range(1, size), (1, -1))]
        return [self.generator(tuple(sign * (j == k) for j in range(size))) for k, sign in axes]

    def generator(self, vector: IntegerVector) -> Generator:
        """Return a generator with what each contact does there."""
        springs = tuple(dot(contact.spring, vector) for contact in self.contacts)
        slips = tuple(dot(contact.wrenches[1], vector) for contact in self.contacts)
        return Generator(vector, springs, slips)

    def leaf_problem(self, leaf: Leaf, place: Place) -> str:
        """Return the inequality of a leaf that fails, or nothing."""
        work = self.leaf_work(leaf, place.region, place.states)
        if work.broken:
            return f"{place.path}: {work.broken}"
        if not place.region:
            constant, *rest = work.total
            if any(rest):
                more = " and of the displacements" * bool(leaf.displacements)
                return f"{place.path}: the sum of -alpha k N + h T{more} is not 0"
            is_above = constant > 0
            return "" if is_above else f"{place.path}: the work of load and contacts is not above 0"
        for total, (vector, *_) in zip(work.total, place.region, strict=True):
            if total < 0 or (total == 0 and vector[0]):
                where, done = ", ".join(map(short, vector)), short(quotient(total, work.unit))
                due = f"{done}, and must be {'above' if vector[0] else 'at least'} 0"
                return (
                    f"{place.path}: at generator ({where}) the work of load and contacts is {due}"
                )
        return ""

    def leaf_work(
        self, leaf: Leaf, region: Sequence[Generator], states: Mapping[int, State]
    ) -> LeafWork:
        """Return what load and contacts do on the virtual motion of a leaf.

        Args:
            region: its generators; none for all motions.
        """
        problem, taken = displacement_work(self.max_displacement, leaf.displacements)
        if problem:
            return LeafWork(problem, (), 1, ())
        vectors = (leaf.motion, *leaf.multipliers.values(), *leaf.displacements.values())
        scale = _denominator((taken, *chain(*vectors)))
        motion = (0, *integers_over(leaf.motion, scale))
        # Rows in (g_0, d) by their factors: what is linear. The rest, at each generator.
        constant = dot(self.load, motion[1:]) - int(taken * scale) * self.unit
        terms: list[tuple[Any, IntegerVector]] = [(constant, (1, *[0] * self.form.size))]
        concave: list[Any] = [0] * len(region)
        for i, numbers in leaf.displacements.items():
            terms += self._pushes(self.contacts[i], integers_over(numbers, scale))
        factors: list[tuple[Any, int] | None] = [None] * len(self.contacts)
        none = (0,) * (self.form.tangents + 1)
        for i, contact in enumerate(self.contacts):
            state, multipliers = states.get(i, "undecided"), leaf.multipliers.get(i)
            # Most trees have no regions, whose lists would take a tenth of the time.
            springs = [g.springs[i] for g in region] if region else contact.signs
            slips = [g.slips[i] for g in region] if region else ()
            is_idle = state == "detached" or (state == "undecided" and all(e <= 0 for e in springs))
            if is_idle and not multipliers:
                continue
            alpha, *h = integers_over(multipliers, scale) if multipliers else none
            # A detached contact does no work, whatever its factor is.
            is_below = state == "detached"
            if not is_below:
                a, *b = [dot(row, motion) for row in contact.wrenches]
                mu = contact.friction
                if self._round:
                    is_below = within_room(a - alpha * contact.unit, b, mu, state)
                else:
                    unit_of_kappa = contact.unit * mu.denominator
                    most = greatest_product(b, with_sign(state, slips), self.edges)
                    kappa = a * mu.denominator - mu.numerator * most
                    is_below = alpha * unit_of_kappa <= kappa
                    factors[i] = None if is_idle else (kappa, scale * unit_of_kappa)
            is_pressed = not multipliers and all(e >= 0 for e in springs)
            if multipliers or not (region or is_pressed):
                if broken := broken_multipliers(state, alpha, h, is_below=is_below):
                    values = _numbers(multipliers or none, factors[i])
                    words = f"contact {i + 1}, {state_text(state)}: {values}: {broken}"
                    return LeafWork(words, (), 1, ())
                if multipliers:
                    terms.append((alpha * (self.unit // contact.spring_unit), contact.spring))
                    terms += self._pushes(contact, (0, *h)) if any(h) else ()
                continue
            kappa *= self.unit // (unit_of_kappa * contact.spring_unit)
            if is_pressed:
                terms.append((kappa, contact.spring))
            elif kappa < 0:
                concave = [x + kappa * max(0, e) for x, e in zip(concave, springs, strict=True)]
        sizes, rows = zip(*terms, strict=True)
        linear = [dot(sizes, column) for column in zip(*rows, strict=True)]
        total = [x + dot(linear, g.vector) for x, g in zip(concave, region, strict=True)]
        return LeafWork("", total or linear, scale * self.unit, factors)

    def _pushes(
        self, contact: _IntegerContact, factors: Sequence[int]
    ) -> Iterator[tuple[int, IntegerVector]]:
        """Yield the wrenches of a contact with factors other than 0, in the unit of sums."""
        per_wrench = self.unit // contact.unit
        for factor, row in zip(factors, contact.wrenches, strict=True):
            if factor:
                yield factor * per_wrench, row


def _numbers(multipliers: Sequence[Fraction | int], kappa: tuple[Any, int] | None) -> str:
    """Return the multipliers of a contact for a message, and its factor where it is rational."""
    alpha, *h = map(short, multipliers)
    words = f"alpha = {alpha}, h = {h[0] if len(h) == 1 else '(' + ', '.join(h) + ')'}"
    return f"{words}, kappa = {short(quotient(*kappa))}" if kappa else words


def _denominator(row: Iterable[Fraction | int]) -> int:
    return math.lcm(*[x.denominator for x in row])
