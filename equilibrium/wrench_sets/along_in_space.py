"""The magnitudes along a direction that a grasp in space resists, and what is proved of its loads.

Their set need not be an interval, and in space its ends are algebraic numbers of no small degree.
So verdicts are asked for at sampled magnitudes, and where they change the change is enclosed
between two proofs: floats show where, and what they leave is bisected. What lies between samples of
the same verdict is not looked at.

The load enters a tree in one place: the works of its leaves, ``lambda . w + sum alpha q``. So a
tree refutes every load for which all of them are above 0, an open convex set. And where two exact
equilibria have contacts that do the same, all between them are equilibria too: springs and cones
are convex, and a slip in one direction has one friction force.
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from operator import itemgetter
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import (
    RationalVector,
    dot,
    rational,
    shown,
    simplest_between,
    to_text,
)
from arrangement.numbers.linear.intervals import is_long, where_positive
from equilibrium.certificate.leaves import spatial_leaves
from equilibrium.core.contact_law import spring_force
from equilibrium.core.contact_rows import sum_row
from equilibrium.decide import NOT_RESISTED, RESISTED, UNDECIDED
from equilibrium.decide.assemblies.ends import Giving, given_at
from equilibrium.decide.nearby import WithinError
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.contact import Contact
from equilibrium.model.displacement import read_displacement
from equilibrium.model.errors import EquilibriumError, GraspError
from equilibrium.model.grasp import Grasp

#: The works of the leaves of a tree: of each a virtual motion, and what the preloads add.
Works: TypeAlias = tuple[tuple[RationalVector, Fraction], ...]
#: Magnitudes, without the ends; None where it is unbounded.
Ends: TypeAlias = tuple[Fraction | None, Fraction | None]
#: This many nodes show in floats where a boundary is.
_BOUNDARY_NODES = 800


@dataclass(frozen=True)
class Border:
    """A change of the verdict between two magnitudes.

    Attributes:
        resisted, refused: the two magnitudes, both proved; either may be the larger one.
        undecided: magnitudes between them that were tried and left open, increasing.
        exact: whether all that is between them is proved not to be resisted, so that the boundary
            is `resisted` itself.
    """

    resisted: Fraction
    refused: Fraction
    undecided: tuple[Fraction, ...] = ()
    exact: bool = False

    def __post_init__(self) -> None:
        """Refuse ends that contradict each other.

        Raises:
            EquilibriumError: one magnitude is both resisted and not, which is an internal error.
        """
        if self.resisted == self.refused:
            raise EquilibriumError(
                f"{to_text(self.refused)} is proved to be resisted and not to be. This is an "
                "internal error; please report it"
            )

    @property
    def ends(self) -> tuple[Fraction, Fraction]:
        """Both ends, the smaller one first."""
        return min(self.resisted, self.refused), max(self.resisted, self.refused)

    @property
    def width(self) -> Fraction:
        """The distance of the ends."""
        return abs(self.resisted - self.refused)

    def shrunk(self, t: Fraction, answer: str) -> Border:
        """Return the bracket with what is known now of one magnitude.

        An end is replaced by a magnitude between the ends alone: of others nothing follows for
        this change of the verdict.
        """
        low, high = self.ends
        if not low < t < high:
            return self
        if answer == UNDECIDED:
            return replace(self, undecided=tuple(sorted({*self.undecided, t})))
        ends = (t, self.refused) if answer == RESISTED else (self.resisted, t)
        left = tuple(x for x in self.undecided if min(ends) < x < max(ends))
        return Border(*ends, left)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "resisted": to_text(self.resisted),
            "not_resisted": to_text(self.refused),
            "undecided": list(map(to_text, self.undecided)),
            "exact": self.exact,
        }


class KnownLoads:
    """What is proved of the loads of one grasp.

    Args:
        nodes: of the tree of each verdict, at most.
        max_displacement: see `equilibrium.solve`; all motions between two that count do, too.

    Attributes:
        trees: the works of the leaves of each proof of a "no".
    """

    def __init__(self, grasp: Grasp, nodes: int, max_displacement: Fraction | None = None) -> None:
        self.grasp, self.nodes, self.max_displacement = grasp, nodes, max_displacement
        self.solver = Solver(grasp, max_displacement)
        self.trees: list[Works] = []
        #: Without preload and adhesion all multiples of a load have its verdict: the law scales.
        self.scales = max_displacement is None and not any(c.preload or c.adhesion for c in grasp)
        self._verdicts: dict[RationalVector, Verdict] = {}

    def solve(self, wrench: RationalVector, nodes: int | None = None, tree: Any = None) -> Verdict:
        """Decide one load, and remember the answer and its proof.

        Args:
            nodes: of the tree, where they are fewer than otherwise.
            tree: that is open, to be closed.
        """
        if (known := self._verdicts.get(wrench)) is not None:
            return known
        if tree is not None:
            verdict = self.solver.close(wrench, tree, self.nodes)
        else:
            verdict = self.solver.solve(wrench, nodes=self.nodes if nodes is None else nodes)
        if verdict.verdict == NOT_RESISTED:
            self.trees.append(tuple((x.motion, x.least) for x in spatial_leaves(verdict.proof)))
        if verdict.decided or (nodes is None and tree is None):
            self._verdicts[wrench] = verdict
        return verdict


class KnownMagnitudes:
    """What is proved of the loads ``base + t along``, t >= 0."""

    def __init__(self, known: KnownLoads, along: RationalVector, base: RationalVector) -> None:
        self.known, self.along, self.base = known, along, base
        self.scales = known.scales and not any(base)
        self.refuted = [
            interval for tree in known.trees if (interval := self._range(tree)) is not None
        ]
        #: Magnitudes of exact equilibria, increasing, each with the motion.
        self.equilibria: list[tuple[Fraction, RationalVector]] = []

    def load(self, t: Fraction) -> RationalVector:
        """Return the load of a magnitude."""
        return sum_row(self.base, self.along, t)

    def reach(self, refused: Fraction, resisted: Fraction, near: float) -> Any:
        """Return how near resisted loads come to one that is not; see `Solver.reach`."""
        ends = self.load(refused), self.load(resisted)
        return self.known.solver.reach(*ends, _BOUNDARY_NODES, near)

    def verdict(self, t: Fraction, **how: Any) -> str:
        """Return what follows from earlier proofs, or decide; see `KnownLoads.solve`."""
        if t and self.scales:
            t = Fraction(1)
        if self.refuting(t) is not None:
            return NOT_RESISTED
        k = bisect(self.equilibria, t, key=itemgetter(0))
        neighbours = [motion for _, motion in self.equilibria[max(0, k - 1) : k + 1]]
        if len(neighbours) == 2 and blends(self.known.grasp, *neighbours):
            return RESISTED
        verdict = self.known.solve(self.load(t), **how)
        if verdict.verdict == NOT_RESISTED and (around := self._range(self.known.trees[-1])):
            self.refuted.append(around)
        if verdict.solution is not None and verdict.solution.box is None:
            self.equilibria.insert(k, (t, verdict.solution.motion))
        return verdict.verdict

    def refuting(self, t: Fraction) -> Ends | None:
        """Return the magnitudes that a tree refutes together with this one, if one does."""
        for low, high in self.refuted:
            if (low is None or low < t) and (high is None or t < high):
                return low, high
        return None

    def refutes_between(self, low: Fraction, high: Fraction | None) -> bool:
        """Return whether all magnitudes between two are refuted, without these themselves.

        Args:
            high: None for all above the first.
        """
        if self.scales and not low:
            return self.verdict(Fraction(1)) == NOT_RESISTED
        reached = low
        for start, end in sorted(self.refuted, key=lambda x: (x[0] is not None, x[0] or 0)):
            # They are open: the end of one is refuted by another one only.
            if start is not None and (start > reached or start == reached != low):
                return False
            if end is None or (high is not None and end >= high):
                return True
            reached = max(reached, end)
        return False

    def _range(self, works: Works) -> Ends | None:
        """Return for which magnitudes all works are above 0; None if for none.

        Of a proof in the plane, which has no such leaves, nothing is known.
        """
        rows = [(dot(motion, self.along), dot(motion, self.base) + rest) for motion, rest in works]
        if not rows or any(not slope and start <= 0 for slope, start in rows):
            return None
        closed = where_positive(rows)
        return closed if closed and is_long(closed) else None


def blends(grasp: Grasp, one: RationalVector, other: RationalVector) -> bool:
    """Return whether all motions between those of two equilibria are of equilibria, too.

    They are if each contact is on one side of its spring, and slips in one direction or not.
    """
    return all(_same(contact, one, other) for contact in grasp)


def _same(contact: Contact, one: RationalVector, other: RationalVector) -> bool:
    springs = [spring_force(contact, motion) for motion in (one, other)]
    if max(springs) <= 0:
        return True
    a, b = (dot(row, one) for row in contact.tangential_wrenches)
    c, d = (dot(row, other) for row in contact.tangential_wrenches)
    one_way = a * d == b * c and a * c + b * d >= 0 and any((a, b)) == any((c, d))
    return min(springs) >= 0 and one_way


#: Powers of two of the sampled magnitudes, times the largest preload or adhesion, or 1.
_POWERS = range(-6, 9)
#: The ends of what stays undecided are found to a share of one over this.
_SHARP = 4
#: From the edge that floats give, a "no" is tried at one over this of how far before it a load is
#: resisted; each next one is as many times further.
_BEYOND_EDGE = 16
#: Once there is one, the edge is searched for to one over this of that distance.
_EDGE_SHARE = 64
#: Simple magnitudes are up to this many times as far.
_SIMPLE_FACTOR = Fraction(9, 8)
#: A bracket is wide if it is more than one over this of its larger end.
_WIDE = 100
#: After this many steps that leave an end of a bracket where it is one looks close to it.
_STAYS = 4
#: A bracket this many times narrower than its relative width at the samples is left as it is.
_FLOOR = 10**6
#: Of the tree of a verdict.
_NODES = 400
#: Least width of a bracket: verdicts take longer numbers with each halving.
_LEAST_WIDTH = Fraction(1, 2**100)
#: Of converted data: about how many boundaries other roundings are asked, at which share before
#: them, and with how many steps.
_ASKED = 2
#: A contact is close to slipping or lifting off within this share.
_CLOSE = Fraction(1, 1000)
_NEAR = Fraction(1, 1000)
_STEPS = 50_000_000


class Nearby(NamedTuple):
    """The verdict a little before a boundary, for converted data.

    Attributes:
        rounding: what is known for all data within the error.
    """

    t: Fraction
    rounding: WithinError

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        names = ("verdict", "answer", "proved")
        return {"t": to_text(self.t), **{name: getattr(self.rounding, name) for name in names}}


@dataclass(frozen=True)
class SpatialMagnitudes:
    """What is known of the magnitudes t >= 0 with ``base + t direction`` resisted.

    Attributes:
        samples: magnitudes and their verdicts, increasing.
        borders: each change of the verdict between neighbouring samples that are decided.
        grasp, max_displacement: what it is about.
        zero_only: whether it is proved that 0 is resisted and no t above it.
    """

    grasp: Grasp
    direction: RationalVector
    base: RationalVector
    samples: tuple[tuple[Fraction, str], ...]
    borders: tuple[Border, ...]
    max_displacement: Fraction | None = None
    zero_only: bool = False

    @property
    def verdict(self) -> str:
        """Whether any sample is resisted; "undecided" if none is and some are open."""
        verdicts = {verdict for _, verdict in self.samples}
        if RESISTED in verdicts:
            return RESISTED
        return UNDECIDED if UNDECIDED in verdicts else NOT_RESISTED

    @property
    def gaps(self) -> tuple[tuple[Border, Border], ...]:
        """Neighbouring boundaries between which the wrench is not resisted, though it is beyond."""
        pairs = pairwise(self.borders)
        return tuple((a, b) for a, b in pairs if a.resisted < a.refused and b.refused < b.resisted)

    def within_error(self) -> tuple[Nearby, ...] | None:
        """Return verdicts a little before the first boundaries, with what other roundings answer.

        None if the data are exact or there is no boundary. Brackets are finer than the error of
        converted data, so that verdicts at their ends would all depend on the rounding.
        """
        if self.grasp.data_error is None or not self.borders:
            return None
        solver, nearby = Solver(self.grasp, self.max_displacement), []
        for border in self.borders[:_ASKED]:
            way = -1 if border.resisted < border.refused else 1
            t = border.resisted * (1 + way * _NEAR)
            verdict = solver.solve(sum_row(self.base, self.direction, t), steps=_STEPS)
            nearby.append(Nearby(t, verdict.within_error()))
        return tuple(nearby)

    def what_gives(self) -> tuple[Giving | None, ...]:
        """Return for each boundary which contacts are about to slip or lift off there.

        A boundary is a bracket, so this is read off one equilibrium, at its resisted end: a contact
        slips if it is within 1/1000 of its friction limit, and lifts off if it has less than 1/1000
        of the largest normal force. None where no equilibrium is found, and at 0.
        """
        solver = Solver(self.grasp, self.max_displacement)
        ends = [border.resisted for border in self.borders]
        loads = [sum_row(self.base, self.direction, t) for t in ends]
        return tuple(
            _read_off(self.grasp, solver.solve(load, nodes=_NODES)) if t else None
            for t, load in zip(ends, loads, strict=True)
        )

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {
            "direction": list(map(to_text, self.direction)),
            "base": list(map(to_text, self.base)),
            "verdict": self.verdict,
            "zero_only": self.zero_only,
            "borders": [border.to_dict() for border in self.borders],
            "samples": [{"t": to_text(t), "verdict": verdict} for t, verdict in self.samples],
        }


def spatial_magnitudes(
    grasp: Grasp,
    direction: Iterable[Any],
    base: Iterable[Any] = (0,) * 6,
    *,
    width: Any = Fraction(1, 10**6),
    nodes: int = _NODES,
    loads: KnownLoads | None = None,
    every: int = 1,
    max_displacement: Any = None,
) -> SpatialMagnitudes:
    """Bracket the magnitudes that a grasp in space resists along a direction.

    Args:
        width: of a bracket, relative to its larger end; where the verdict changes at 0, a millionth
            of this share of the sample beyond.
        nodes: of the tree of each verdict, at most.
        loads: what is known of the grasp already, which grows; with its own number of nodes.
        every: which of the sampled magnitudes are taken: each, every other, ...
        max_displacement: see `equilibrium.solve`; without `loads`.

    Raises:
        GraspError: the direction is zero, or a width below 2^-100.

    >>> from equilibrium import read_grasp
    >>> fingers = read_grasp("two-opposed-fingers")
    >>> spatial_magnitudes(fingers, [0, 1, 0, 0, 0, 0]).borders[0].resisted
    Fraction(1, 1)
    """
    along, start = (grasp.read_wrench(w) for w in (direction, base))
    if not any(along):
        raise GraspError("the direction is zero; give one that is not")
    share = rational(width, "width")
    if share < _LEAST_WIDTH:
        raise GraspError(f"width is {shown(share)}; it must be at least 2^-100")
    loads = loads or KnownLoads(grasp, nodes, read_displacement(max_displacement))
    known = KnownMagnitudes(loads, along, start)
    unit = max((max(c.preload, c.adhesion) for c in grasp), default=Fraction(0)) or Fraction(1)
    tried = [Fraction(0), *(unit * Fraction(2) ** k for k in _POWERS[::every])]
    verdicts = {k: known.verdict(tried[k]) for k in _ends_first(len(tried))}
    samples = [(t, verdicts[k]) for k, t in enumerate(tried)]
    decided = [(t, answer) for t, answer in samples if answer != UNDECIDED]
    borders = []
    for (low, answer), (high, next_answer) in pairwise(decided):
        if answer != next_answer:
            border = Border(low, high) if answer == RESISTED else Border(high, low)
            border = _bracket(known, _closer(known, border, share), share)
            borders.append(replace(border, exact=known.refutes_between(*border.ends)))
    alone = verdicts[0] == RESISTED and known.refutes_between(Fraction(0), None)
    results = tuple(samples), tuple(borders), loads.max_displacement, alone
    return SpatialMagnitudes(grasp, along, start, *results)


def _read_off(grasp: Grasp, verdict: Verdict) -> Giving | None:
    """Return which contacts are close to slipping or lifting off in an equilibrium."""
    if verdict.solution is None:
        return None
    forces = verdict.solution.forces
    least = _CLOSE * max((normal for normal, *_ in forces), default=Fraction(0))
    limits = [(1 - _CLOSE) * c.friction * force[0] for c, force in zip(grasp, forces, strict=True)]
    slips = [
        bool(limit) and dot(rubbed, rubbed) >= limit**2
        for limit, (_, *rubbed) in zip(limits, forces, strict=True)
    ]
    given = given_at(grasp.groups, [normal <= least for normal, *_ in forces], slips)
    return replace(given, tips=()) or None


def _ends_first(count: int) -> list[int]:
    """Return all indices: both ends, then the middles of what they leave."""
    order, parts = [0, count - 1], [(0, count - 1)]
    for low, high in parts:
        middle = (low + high) // 2
        if low < middle:
            order.append(middle)
            parts += [(low, middle), (middle, high)]
    return order


def _closer(known: KnownMagnitudes, border: Border, width: Fraction) -> Border:
    """Return a bracket with ends near the boundary, and the magnitudes that were left open.

    Floats show up to where loads may be resisted. Before that edge equilibria are looked for,
    without trees; the tree of the floats is closed a little beyond it.

    The search before the edge ends: an equilibrium makes `far`, which stays above half of what is
    enough, smaller by a 64th at least; between two of them `near` grows past 3/4 of it in three
    steps.
    """
    held, refused = border.resisted, border.refused
    gap, widest = abs(refused - held), width * border.ends[1]
    if known.scales or gap <= widest:
        return border
    share, tree, stuck = known.reach(refused, held, float(widest / gap))
    # Floats may show it a little beyond either end.
    edge = refused + Fraction(min(max(share, 0.0), 1.0)) * (held - refused)
    way = (refused - held) / gap
    enough = max(width * max(held, edge), widest / _FLOOR)
    # How far before the edge there is an equilibrium, and none was found; how far that began.
    far, near, begun, asked = abs(edge - held), Fraction(0), Fraction(0), enough / 3
    while far - near > max(enough / 2, far / _SHARP):
        t = simplest_between(*sorted((edge - way * asked, edge - way * asked * _SIMPLE_FACTOR)))
        answer = known.verdict(t, nodes=0)
        border = border.shrunk(t, answer)
        if answer == NOT_RESISTED:
            edge = t
            break
        if answer == RESISTED:
            far = abs(edge - t)
            # From so much nearer more is found.
            near = near if far * _SHARP > begun else Fraction(0)
        else:
            near, begun = abs(edge - t), far
        asked = max(far / _SHARP, (near + far) / 2 if near >= far / _SHARP else Fraction(0))
    beyond = max(enough / 4, far / _BEYOND_EDGE)
    for how in ({"tree": tree}, {}, {}):
        if abs(border.refused - edge) <= 2 * beyond:
            break
        t = simplest_between(*sorted((edge + way * beyond, edge + way * beyond * 3 / 2)))
        if known.verdict(t, **how) == NOT_RESISTED:
            border = border.shrunk(t, NOT_RESISTED)
            border = _to_the_edge(known, border, max(enough / 4, far / _EDGE_SHARE))
            break
        beyond *= _BEYOND_EDGE
    if stuck and border.width > border.ends[1] / _WIDE:
        # The edge is none: what stayed open without a tree is asked again.
        return replace(border, undecided=())
    return border


def _bracket(known: KnownMagnitudes, border: Border, width: Fraction) -> Border:
    """Return a narrow bracket inside a wider one.

    This ends. A verdict takes a third off one of the parts that end the bracket, and the part is
    more than a quarter of it, or, near an end that stays, half of what is enough. What stays open
    takes a third off this part; near an end that stays it is asked once.
    """
    # Where the verdict changes at 0 no width is small beside the larger end.
    floor = width * border.ends[1] / _FLOOR
    stays = [0, 0]
    while border.width > (enough := max(width * border.ends[1], floor)):
        low, high = border.ends
        inner = [low, *border.undecided, high]
        parts = [inner[:2], inner[-2:]]
        start, end = max(parts, key=lambda part: part[1] - part[0])
        if border.undecided and end - start <= max(enough, border.width / _SHARP):
            break
        third = (end - start) / 3
        t = simplest_between(start + third, end - third)
        # An end that stays may be the boundary itself.
        if stays[0] == _STAYS:
            t = simplest_between(low + enough / 2, low + enough)
        elif stays[1] == _STAYS:
            t = simplest_between(high - enough, high - enough / 2)
        answer = known.verdict(t)
        border = border.shrunk(t, answer)
        if answer == NOT_RESISTED:
            border = _to_the_edge(known, border, enough / 4)
        pairs = zip(stays, (low, high), border.ends, strict=True)
        stays = [0 if old != new else count + 1 for count, old, new in pairs]
    return border


def _to_the_edge(known: KnownMagnitudes, border: Border, near: Fraction) -> Border:
    """Move the refused end to the edge of what its tree refutes, as near as is asked for."""
    low, high = known.refuting(border.refused) or (None, None)
    # The other end is resisted, so the tree ends before it.
    edge, way = (low, 1) if border.resisted < border.refused else (high, -1)
    if edge is None or abs(border.refused - edge) <= near:
        return border
    t = simplest_between(*sorted((edge + way * near / 2, edge + way * near)))
    return border.shrunk(t, NOT_RESISTED)
