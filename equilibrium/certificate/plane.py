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
   these multipliers, and they obey:

   * ``alpha >= 0`` where it is undecided or detached: there e may be below 0, without a force;
   * ``alpha <= kappa`` unless it is detached;
   * ``h <= 0`` in slip+, ``h >= 0`` in slip-, any h in stick, else h = 0: so ``h s <= 0``.

   Without multipliers it does at least

   * 0, if it is detached or all e <= 0, as it has no force;
   * ``kappa e``, if it is decided otherwise or all e >= 0;
   * ``min(0, kappa) max(0, e)`` for the rest, which is concave in g: between generators it is not
     below its interpolation.
4. *Sum.* The load does ``lambda . w g_0``. The leaf holds if load and least works together are at
   least 0 at each generator, and above 0 where ``g_0 > 0``. Each motion of the region is a sum of
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

from .law import displacement_work, frame, short
from .reading import Leaf

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


class PlanarQuestion:
    """Grasp and wrench in integers."""

    dimension = 2

    def __init__(
        self, grasp: Grasp, wrench: RationalVector, max_displacement: Fraction | None = None
    ) -> None:
        self.max_displacement = max_displacement
        laws: list[tuple[RationalVector, ...]] = []
        self.frames = [frame(contact) for contact in grasp]
        for contact, (normal, tangent) in zip(grasp, self.frames, strict=True):
            spring = (contact.preload, *(-contact.stiffness * x for x in normal))
            rubbing = tuple(contact.friction * x for x in tangent)
            laws.append((spring, (Fraction(0), *tangent), (*normal, *rubbing)))
        scales = [tuple(map(_denominator, law)) for law in laws]
        self.unit = math.lcm(_denominator(wrench), *(math.lcm(e * f, s) for e, s, f in scales))
        self.wrench = _times(wrench, self.unit)
        self.contacts = []
        for (spring, slip, force), (e, s, _) in zip(laws, scales, strict=True):
            forces, per_e, per_s = _times(force, self.unit // e), self.unit // e, self.unit // s
            rows = _times(spring, e), _times(slip, s), forces[:3], forces[3:]
            self.contacts.append(PlanarContact(*rows, per_e, per_s))

    def half_space(self) -> list[Generator]:
        """Return the generators of all motions: e_0, then +-e_1, +-e_2, +-e_3."""
        return [self._unit_vector(*axis) for axis in [(0, 1), *product((1, 2, 3), (1, -1))]]

    def _unit_vector(self, axis: int, sign: int) -> Generator:
        rows = [contact.spring for contact in self.contacts], [c.slip for c in self.contacts]
        springs, slips = (tuple(sign * row[axis] for row in one) for one in rows)
        return Generator(tuple(sign * (j == axis) for j in range(4)), springs, slips)


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


def planar_leaf_problem(
    question: PlanarQuestion,
    leaf: Leaf,
    region: Sequence[Generator],
    states: Mapping[int, Any],
    path: str,
) -> str:
    """Return the inequality of a leaf that fails, or nothing."""
    problem, taken = displacement_work(question.max_displacement, leaf.displacements)
    if problem:
        return f"{path}: {problem}"
    scale = _denominator(leaf.motion)
    virtual, unit = _times(leaf.motion, scale), scale * question.unit
    load = dot(question.wrench, virtual)
    work: list[Any] = [load * generator.vector[0] for generator in region]
    if leaf.displacements:
        bounded = _work_of_bounds(question, leaf, taken, region)
        work = [w + unit * x for w, x in zip(work, bounded, strict=True)]
    springs = zip(*(generator.springs for generator in region), strict=True)
    slips = zip(*(generator.slips for generator in region), strict=True)
    for i, (contact, e, s) in enumerate(zip(question.contacts, springs, slips, strict=True)):
        state, multipliers = states.get(i), leaf.multipliers.get(i)
        if multipliers is None and has_no_force(state, e):
            continue
        kappa = work_factor(dot(virtual, contact.normal), dot(virtual, contact.rubbing), state, s)
        if multipliers is None:
            least = least_work(kappa, state, e)
        else:
            per_e, per_s = scale * contact.per_e, scale * contact.per_s
            alpha, h = multipliers[0] * per_e, multipliers[1] * per_s
            if broken := _broken_bound(state, alpha, h, kappa):
                numbers = (*map(short, multipliers), short(Fraction(kappa, per_e)))
                named = "alpha = {}, h = {}, kappa = {}".format(*numbers)
                return f"{path}: contact {i + 1}, {state or 'undecided'}: {named}: {broken}"
            least = [alpha * x + h * y for x, y in zip(e, s, strict=True)]
        work = [w + x for w, x in zip(work, least, strict=True)]
    for total, (vector, *_) in zip(work, region, strict=True):
        if total < 0 or (total == 0 and vector[0]):
            place, short_work = ", ".join(map(short, vector)), short(Fraction(total) / unit)
            due = f"{short_work}, and must be {'above' if vector[0] else 'at least'} 0"
            return f"{path}: at generator ({place}) the work of load and contacts is {due}"
    return ""


def has_no_force(state: Any, e: Sequence[Number]) -> bool:
    """Return whether a contact has no force in a region, by its state or its springs there."""
    return state == "detached" or (state is None and max(e) <= 0)


def work_factor(a: Number, mu_b: Number, state: Any, s: Sequence[Number]) -> Number:
    """Return kappa of step 2."""
    is_open = state in (None, "attached")
    if state == "slip+" or (is_open and min(s) > 0):
        return a - mu_b
    if state == "slip-" or (is_open and max(s) < 0):
        return a + mu_b
    return a - max(mu_b, -mu_b)


def least_work(kappa: Number, state: Any, e: Sequence[Number]) -> list[Number]:
    """Return the least work of a contact with a force, at each generator, without multipliers."""
    if state or min(e) >= 0:
        return [kappa * x for x in e]
    return [kappa * x if kappa < 0 < x else 0 for x in e]


def _broken_bound(state: Any, alpha: Fraction, h: Fraction, kappa: Fraction | int) -> str:
    """Return which condition of step 3 the multipliers of a contact break, or nothing."""
    if alpha < 0 and state in (None, "detached"):
        return "alpha must be at least 0"
    if alpha > kappa and state != "detached":
        return "alpha must be at most kappa"
    if (h > 0 and state not in ("stick", "slip-")) or (h < 0 and state not in ("stick", "slip+")):
        return "h has the wrong sign"
    return ""


def _work_of_bounds(
    question: PlanarQuestion, leaf: Leaf, taken: Fraction, region: Sequence[Generator]
) -> list[Fraction]:
    """Return minus what bounded displacements take from the sum, at each generator."""
    total = [Fraction(0)] * 3
    for i, numbers in leaf.displacements.items():
        for number, row in zip(numbers, question.frames[i], strict=True):
            total = [x + number * y for x, y in zip(total, row, strict=True)]
    vectors = (generator.vector for generator in region)
    return [dot(total, d) - taken * g_0 for g_0, *d in vectors]


def _denominator(row: RationalVector) -> int:
    return math.lcm(*(x.denominator for x in row))


def _times(row: RationalVector, scale: int) -> IntegerVector:
    return tuple(x.numerator * (scale // x.denominator) for x in row)
