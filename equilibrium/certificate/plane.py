"""Why a leaf in the plane proves that nothing balances the load: the trusted rule, in four steps.

A leaf stands for a region of motions and for states of contacts. It has a virtual motion lambda.

1. *Region.* It is the cone of integer generators ``g = (g_0, d)`` with ``g_0 >= 0``, and has the
   motions ``d / g_0``. What follows is computed at each generator. A contact with unit wrenches N
   and T, friction mu, stiffness k and preload q has the spring ``e = q g_0 - k N . d`` and the slip
   ``s = T . d``; its normal force is ``max(0, e)``. States are closed conditions: e <= 0 if it is
   detached, e >= 0 if it is attached, and then s = 0 in stick, s >= 0 in slip+, s <= 0 in slip-.
2. *Factor.* With ``a = lambda . N`` and ``b = lambda . T`` the work of a contact on lambda is at
   least kappa times its normal force, by all friction that its slip allows:

   * ``kappa = a - mu b`` in slip+, and if all s > 0 while it is undecided or attached;
   * ``kappa = a + mu b`` in slip-, and if all s < 0 while it is undecided or attached;
   * ``kappa = a - mu |b|`` otherwise.

3. *Least work.* At each generator the contact does at least ``alpha e + h s``, if the leaf gives
   these multipliers, and they obey the rule of `equilibrium.certificate.states` with this kappa.
   Without multipliers it does at least

   * 0, if it is detached or all e <= 0, as it has no force;
   * ``kappa e``, if it is decided otherwise or all e >= 0;
   * ``min(0, kappa) max(0, e)`` for the rest, which is concave in g: between generators it is not
     below its interpolation.
4. *Sum.* The load, with all adhesion, is a constant wrench w and does ``lambda . w g_0``. The leaf
   holds if load and least works together are at least 0 at each generator, and above 0 where
   ``g_0 > 0``. Each motion of the region is a sum of
   generators, some with ``g_0 > 0``, so there load and contacts do work on lambda together. Forces
   that balance do none.

Where only displacements of contact points up to D count, a leaf may give numbers u, v of contacts.
Each takes ``(|u| D + |v| D) g_0 - u N . d - v T . d`` from the sum, which is at least 0 there: see
`equilibrium.certificate.law.displacement_work`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from equilibrium.model.grasp import Grasp

from .law import applied, displacement_work, law_rows, short
from .reading import FORMS, Leaf, Place
from .states import broken_multipliers

Number: TypeAlias = Fraction | int


class PlanarContact(NamedTuple):
    """A contact in integers, for work in units of 1 / `PlanarQuestion.unit`.

    ``spring . g`` and ``slip . g`` are positive multiples of e and s. In that unit kappa e is
    ``lambda . (normal -+ rubbing) spring . g``, and ``alpha e + h s`` is
    ``alpha per_e spring . g + h per_s slip . g``.
    """

    spring: IntegerVector
    slip: IntegerVector
    normal: IntegerVector
    rubbing: IntegerVector
    per_e: int
    per_s: int


class Generator(NamedTuple):
    """A generator of a region, with ``spring . g`` and ``slip . g`` of each contact."""

    vector: IntegerVector
    springs: IntegerVector
    slips: IntegerVector


class LeafWork(NamedTuple):
    """What load and contacts do on the virtual motion of a leaf.

    Attributes:
        broken: the condition on multipliers that fails, or nothing.
        total: at least that, at each generator, over `unit`.
        factors: kappa of each contact and its unit; None where it has no force.
    """

    broken: str
    total: Sequence[Any]
    unit: int
    factors: Sequence[tuple[Number, int] | None]


class PlanarQuestion:
    """Grasp and wrench in integers."""

    form = FORMS[2]
    edges: Sequence[RationalVector] = ()

    def __init__(
        self, grasp: Grasp, wrench: RationalVector, max_displacement: Fraction | None = None
    ) -> None:
        self.max_displacement = max_displacement
        laws: list[tuple[RationalVector, ...]] = []
        self.rows = law_rows(grasp)
        for row in self.rows:
            normal, tangent = row.wrenches
            spring = (row.preload, *(-row.stiffness * x for x in normal))
            rubbing = tuple(row.friction * x for x in tangent)
            laws.append((spring, (Fraction(0), *tangent), (*normal, *rubbing)))
        scales = [tuple(map(_denominator, law)) for law in laws]
        load = applied(self.rows, wrench)
        self.unit = math.lcm(_denominator(load), *(math.lcm(e * f, s) for e, s, f in scales))
        self.load = _times(load, self.unit)
        self.contacts = []
        for (spring, slip, force), (e, s, _) in zip(laws, scales, strict=True):
            forces, per_e, per_s = _times(force, self.unit // e), self.unit // e, self.unit // s
            rows = _times(spring, e), _times(slip, s), forces[:3], forces[3:]
            self.contacts.append(PlanarContact(*rows, per_e, per_s))

    @property
    def root(self) -> list[Generator]:
        """The generators of all motions: e_0, then +-e_1, +-e_2, +-e_3."""
        axes = [(0, 1), *product((1, 2, 3), (1, -1))]
        return [self.generator(tuple(sign * (j == k) for j in range(4))) for k, sign in axes]

    def generator(self, vector: IntegerVector) -> Generator:
        """Return a generator with what each contact does there."""
        rows = zip(*((c.spring, c.slip) for c in self.contacts), strict=True)
        along = [tuple(dot(row, vector) for row in one) for one in rows] or [(), ()]
        return Generator(vector, *along)

    def leaf_problem(self, leaf: Leaf, place: Place) -> str:
        """Return the inequality of a leaf that fails, or nothing."""
        path, region = place.path, place.region
        problem, taken = displacement_work(self.max_displacement, leaf.displacements)
        if problem:
            return f"{path}: {problem}"
        found = self.leaf_work(leaf, taken, region, place.states)
        if found.broken:
            return f"{path}: {found.broken}"
        for total, (vector, *_) in zip(found.total, region, strict=True):
            if total < 0 or (total == 0 and vector[0]):
                where, work = ", ".join(map(short, vector)), short(Fraction(total) / found.unit)
                due = f"{work}, and must be {'above' if vector[0] else 'at least'} 0"
                return f"{path}: at generator ({where}) the work of load and contacts is {due}"
        return ""

    def leaf_work(
        self, leaf: Leaf, taken: Fraction, region: Sequence[Generator], states: Mapping[int, Any]
    ) -> LeafWork:
        """Return what load and contacts do on the virtual motion of a leaf.

        Args:
            taken: what bounded displacements take, for ``d_0 = 1``.
        """
        scale = _denominator(leaf.motion)
        virtual, unit = _times(leaf.motion, scale), scale * self.unit
        load = dot(self.load, virtual)
        work: list[Any] = [load * generator.vector[0] for generator in region]
        if leaf.displacements:
            bounded = self._work_of_bounds(leaf, taken, region)
            work = [w + unit * x for w, x in zip(work, bounded, strict=True)]
        factors: list[tuple[Number, int] | None] = [None] * len(self.contacts)
        springs = zip(*(generator.springs for generator in region), strict=True)
        slips = zip(*(generator.slips for generator in region), strict=True)
        for i, (contact, e, s) in enumerate(zip(self.contacts, springs, slips, strict=True)):
            state, multipliers = states.get(i, "undecided"), leaf.multipliers.get(i)
            is_idle = state == "detached" or (state == "undecided" and max(e) <= 0)
            if multipliers is None and is_idle:
                continue
            kappa = _kappa(dot(virtual, contact.normal), dot(virtual, contact.rubbing), state, s)
            per_e, per_s = scale * contact.per_e, scale * contact.per_s
            if not is_idle:
                factors[i] = kappa, per_e
            if multipliers is None:
                least = _least_work(kappa, state, e)
            else:
                alpha, h = multipliers[0] * per_e, multipliers[1] * per_s
                if broken := broken_multipliers(state, alpha, (h,), is_below=alpha <= kappa):
                    numbers = (*map(short, multipliers), short(Fraction(kappa, per_e)))
                    named = "alpha = {}, h = {}, kappa = {}".format(*numbers)
                    return LeafWork(f"contact {i + 1}, {state}: {named}: {broken}", (), 1, ())
                least = [alpha * x + h * y for x, y in zip(e, s, strict=True)]
            work = [w + x for w, x in zip(work, least, strict=True)]
        return LeafWork("", work, unit, factors)

    def _work_of_bounds(
        self, leaf: Leaf, taken: Fraction, region: Sequence[Generator]
    ) -> list[Fraction]:
        """Return minus what bounded displacements take from the sum, at each generator."""
        total = [Fraction(0)] * 3
        for i, numbers in leaf.displacements.items():
            for number, row in zip(numbers, self.rows[i].wrenches, strict=True):
                total = [x + number * y for x, y in zip(total, row, strict=True)]
        vectors = (generator.vector for generator in region)
        return [dot(total, d) - taken * g_0 for g_0, *d in vectors]


def orthants(half_space: Sequence[Generator]) -> list[list[Generator]]:
    """Return the eight cones of e_0 and +-e_1, +-e_2, +-e_3, which cover the half space."""
    corners = product(half_space[1:3], half_space[3:5], half_space[5:7])
    return [[half_space[0], *corner] for corner in corners]


def cut_edge(region: Sequence[Generator], j: int, k: int, p: int, q: int) -> list[list[Generator]]:
    """Return the two cones that a point ``p g_j + q g_k`` of an edge cuts a cone into."""
    pairs = zip(region[j], region[k], strict=True)
    sums = [[p * x + q * y for x, y in zip(*pair, strict=True)] for pair in pairs]
    common = math.gcd(*sums[0])
    middle = Generator(*(tuple(x // common for x in row) for row in sums))
    return [[*region[:old], middle, *region[old + 1 :]] for old in (j, k)]


def _kappa(a: Number, mu_b: Number, state: Any, s: Sequence[Number]) -> Number:
    """Return kappa of step 2."""
    is_open = state in ("undecided", "attached")
    if state == "slip+" or (is_open and min(s) > 0):
        return a - mu_b
    if state == "slip-" or (is_open and max(s) < 0):
        return a + mu_b
    return a - max(mu_b, -mu_b)


def _least_work(kappa: Number, state: Any, e: Sequence[Number]) -> list[Number]:
    """Return the least work of a contact with a force, at each generator, without multipliers."""
    if state != "undecided" or min(e) >= 0:
        return [kappa * x for x in e]
    return [kappa * x if kappa < 0 < x else 0 for x in e]


def _denominator(row: RationalVector) -> int:
    return math.lcm(*(x.denominator for x in row))


def _times(row: RationalVector, scale: int) -> IntegerVector:
    return tuple(x.numerator * (scale // x.denominator) for x in row)
