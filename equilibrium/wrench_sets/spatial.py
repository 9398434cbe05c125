"""What a grasp in space resists: loads that are known, and magnitudes along a direction.

The load enters a tree in one place: the works of its leaves, ``lambda . w + sum alpha q``. So a
tree refutes every load for which all of them are above 0, an open convex set. And where two exact
equilibria have contacts that do the same, all between them are equilibria too: springs and cones
are convex, and a slip in one direction has one friction force.

The set of resisted magnitudes need not be an interval, and in space its ends are algebraic numbers
of no small degree. So verdicts are asked for at sampled magnitudes, and where they change the
change is enclosed by bisection between two proofs. What lies between samples of the same verdict is
not looked at.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeAlias

from arrangement.numbers.exact import RationalVector, dot, to_text
from equilibrium.certificate.leaves import spatial_leaves
from equilibrium.decide import NOT_RESISTED, RESISTED, UNDECIDED
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.grasps.inputs.conversion import simplest_between
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.model.solution import Solution

#: The works of the leaves of a tree: of each a virtual motion, and what the preloads add.
Works: TypeAlias = tuple[tuple[RationalVector, Fraction], ...]
#: Magnitudes, without the ends; None where there is no end.
Ends: TypeAlias = tuple[Fraction | None, Fraction | None]


class KnownLoads:
    """What is proved of the loads of one grasp.

    Args:
        nodes: of the tree of each verdict, at most.
        within: the range in which equilibria count; all between two of them are in it, too.

    Attributes:
        trees: the works of the leaves of each proof of a "no".
    """

    def __init__(self, grasp: Grasp, nodes: int, within: Range = NO_RANGE) -> None:
        self.grasp, self.nodes, self.within = grasp, nodes, within
        self.solver = Solver(grasp, **within.bounds)
        self.trees: list[Works] = []
        #: Without preload all multiples of a load have its verdict: the law scales.
        self.scales = within == NO_RANGE and not any(contact.preload for contact in grasp)
        self._verdicts: dict[RationalVector, Verdict] = {}

    def ask(self, wrench: RationalVector) -> Verdict:
        """Decide one load, and remember the answer and its proof."""
        if (known := self._verdicts.get(wrench)) is not None:
            return known
        found = self.solver.solve(wrench, nodes=self.nodes)
        if found.verdict == NOT_RESISTED:
            self.trees.append(tuple((x.motion, x.least) for x in spatial_leaves(found.proof)))
        self._verdicts[wrench] = found
        return found


class KnownMagnitudes:
    """What is proved of the loads ``base + t along``, t >= 0."""

    def __init__(self, known: KnownLoads, along: RationalVector, base: RationalVector) -> None:
        self.known, self.along, self.base = known, along, base
        self.scales = known.scales and not any(base)
        self.refuted = [found for tree in known.trees if (found := self._range(tree)) is not None]
        self.held: list[tuple[Fraction, Fraction]] = []
        self._equilibria: list[tuple[Fraction, Solution]] = []

    def verdict(self, t: Fraction) -> str:
        """Return what follows from earlier proofs, or decide."""
        if t and self.scales:
            t = Fraction(1)
        if self.refuting(t) is not None:
            return NOT_RESISTED
        if any(low <= t <= high for low, high in self.held):
            return RESISTED
        wrench = tuple(b + t * x for b, x in zip(self.base, self.along, strict=True))
        found = self.known.ask(wrench)
        if found.verdict == NOT_RESISTED and (around := self._range(self.known.trees[-1])):
            self.refuted.append(around)
        if found.solution is not None and found.solution.box is None:
            self._hold(t, found.solution)
        return found.verdict

    def _hold(self, t: Fraction, solution: Solution) -> None:
        """Remember an equilibrium, and what lies between it and its neighbours."""
        new = (t, solution)
        self._equilibria = sorted([*self._equilibria, new], key=lambda x: x[0])
        k = self._equilibria.index(new)
        for low, high in pairwise(self._equilibria[max(0, k - 1) : k + 2]):
            if blends(self.known.grasp, low[1], high[1]):
                self.held.append((low[0], high[0]))

    def refuting(self, t: Fraction) -> Ends | None:
        """Return the magnitudes that a tree refutes together with this one, if one does."""
        return next(
            (
                (low, high)
                for low, high in self.refuted
                if (low is None or low < t) and (high is None or t < high)
            ),
            None,
        )

    def _range(self, works: Works) -> Ends | None:
        """Return for which magnitudes all works are above 0; None if for none.

        Of a proof in the plane, which has no such leaves, nothing is known.
        """
        if not works:
            return None
        low: Fraction | None = None
        high: Fraction | None = None
        for motion, rest in works:
            start, slope = dot(motion, self.base) + rest, dot(motion, self.along)
            if not slope:
                if start <= 0:
                    return None
                continue
            end = Fraction(-start) / slope
            if slope > 0:
                low = end if low is None else max(low, end)
            else:
                high = end if high is None else min(high, end)
        return None if low is not None and high is not None and low >= high else (low, high)


def blends(grasp: Grasp, one: Solution, other: Solution) -> bool:
    """Return whether all that is between two equilibria is one, as each contact does the same."""
    return all(
        _same(contact, [(x.motion, x.forces[i]) for x in (one, other)])
        for i, contact in enumerate(grasp)
    )


def _same(contact: Contact, both: Sequence[tuple[RationalVector, RationalVector]]) -> bool:
    """Return whether a contact is on one side of its spring, and slips in one direction or not."""
    springs = [
        contact.preload - contact.stiffness * dot(contact.normal_wrench, motion)
        for motion, _ in both
    ]
    if max(springs) <= 0:
        return True
    (a, b), (c, d) = (
        tuple(dot(row, motion) for row in contact.tangential_wrenches) for motion, _ in both
    )
    one_way = a * d == b * c and a * c + b * d >= 0 and any((a, b)) == any((c, d))
    return min(springs) >= 0 and one_way


#: Powers of two of the sampled magnitudes, times the largest preload or 1.
_POWERS = range(-6, 9)
#: The ends of what stays undecided are found to a share of one over this.
_SHARP = 4
#: After so many steps that leave an end of a bracket where it is one looks close to it.
_STAYS = 4
#: A bracket this many times narrower than its relative width at the samples is left as it is.
_FLOOR = 10**6
#: Of the tree of a verdict.
_NODES = 400


@dataclass(frozen=True)
class Border:
    """A change of the verdict between two magnitudes.

    Attributes:
        resisted, refused: the two magnitudes, both proved; either may be the larger one.
        undecided: magnitudes between them that were tried and left open.
    """

    resisted: Fraction
    refused: Fraction
    undecided: tuple[Fraction, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "resisted": to_text(self.resisted),
            "not_resisted": to_text(self.refused),
            "undecided": list(map(to_text, self.undecided)),
        }


@dataclass(frozen=True)
class SpatialMagnitudes:
    """What is known of the magnitudes t >= 0 with ``base + t direction`` resisted.

    Attributes:
        samples: magnitudes and their verdicts, increasing.
        borders: each change of the verdict between neighbouring samples that are decided.
    """

    direction: RationalVector
    base: RationalVector
    samples: tuple[tuple[Fraction, str], ...]
    borders: tuple[Border, ...]

    @property
    def verdict(self) -> str:
        """Whether any sample is resisted; "undecided" if none is and some are open."""
        verdicts = {verdict for _, verdict in self.samples}
        if RESISTED in verdicts:
            return RESISTED
        return UNDECIDED if UNDECIDED in verdicts else NOT_RESISTED

    @property
    def gaps(self) -> tuple[tuple[Border, Border], ...]:
        """Neighbouring borders between which the wrench is not resisted, though it is beyond."""
        pairs = pairwise(self.borders)
        return tuple((a, b) for a, b in pairs if a.resisted < a.refused and b.refused < b.resisted)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        return {
            "direction": list(map(to_text, self.direction)),
            "base": list(map(to_text, self.base)),
            "verdict": self.verdict,
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
    largest_turn: Any = None,
    largest_force: Any = None,
) -> SpatialMagnitudes:
    """Bracket the magnitudes that a grasp in space resists along a direction.

    Args:
        width: of a bracket, relative to its larger end; where the verdict changes at 0, a millionth
            of this share of the sample beyond.
        nodes: of the tree of each verdict, at most.
        loads: what is known of the grasp already, which grows; with its own number of nodes.
        every: which of the sampled magnitudes are taken: each, every other, ...
        largest_turn, largest_force: see `equilibrium.solve`; without `loads`.

    Raises:
        GraspError: the direction is zero.

    >>> from equilibrium.grasps.files import read_grasp
    >>> fingers = read_grasp("two-opposed-fingers")
    >>> spatial_magnitudes(fingers, [0, 1, 0, 0, 0, 0]).borders[0].resisted
    Fraction(1, 1)
    """
    along, start = (read_wrench(w, grasp.dimension) for w in (direction, base))
    if not any(along):
        raise GraspError("the direction is zero; give one that is not")

    within = Range.of(largest_turn, largest_force)
    known = KnownMagnitudes(loads or KnownLoads(grasp, nodes, within), along, start)
    unit = max((c.preload for c in grasp), default=Fraction(0)) or Fraction(1)
    tried = [Fraction(0), *(unit * Fraction(2) ** k for k in _POWERS[::every])]
    found = {k: known.verdict(tried[k]) for k in _ends_first(len(tried))}
    samples = [(t, found[k]) for k, t in enumerate(tried)]
    decided = [(t, answer) for t, answer in samples if answer != UNDECIDED]
    borders = tuple(
        _bracket(known, first, second, Fraction(width))
        for first, second in pairwise(decided)
        if first[1] != second[1]
    )
    return SpatialMagnitudes(along, start, tuple(samples), borders)


def _ends_first(count: int) -> list[int]:
    """Return all indices: both ends, then the middles of what they leave."""
    found, parts = [0, count - 1], [(0, count - 1)]
    for low, high in parts:
        middle = (low + high) // 2
        if low < middle:
            found.append(middle)
            parts += [(low, middle), (middle, high)]
    return found


def _bracket(
    known: KnownMagnitudes,
    first: tuple[Fraction, str],
    second: tuple[Fraction, str],
    width: Fraction,
) -> Border:
    """Return a narrow bracket between two magnitudes of different verdicts."""
    low, high = first[0], second[0]
    undecided: list[Fraction] = []
    # Where the verdict changes at 0 no width is small beside the larger end.
    floor = width * high / _FLOOR
    stays = [0, 0]
    while high - low > (enough := max(width * high, floor)):
        inner = [low, *undecided, high]
        parts = [inner[:2], inner[-2:]]
        start, end = max(parts, key=lambda part: part[1] - part[0])
        if undecided and end - start <= max(enough, (high - low) / _SHARP):
            break
        third = (end - start) / 3
        t = simplest_between(start + third, end - third)
        # An end that stays may be the border itself.
        if stays[0] == _STAYS:
            t = simplest_between(low + enough / 2, low + enough)
        elif stays[1] == _STAYS:
            t = simplest_between(high - enough, high - enough / 2)
        answer, ends = known.verdict(t), (low, high)
        if answer == UNDECIDED:
            undecided = sorted([*undecided, t])
        elif answer == first[1]:
            low = t
        else:
            high = t
        if answer == NOT_RESISTED:
            low, high = _to_the_edge(known, t, low, high, enough / 4)
        undecided = [t for t in undecided if low < t < high]
        pairs = zip(stays, ends, (low, high), strict=True)
        stays = [0 if old != new else count + 1 for count, old, new in pairs]
    ends = (low, high) if first[1] == RESISTED else (high, low)
    return Border(*ends, tuple(undecided))


def _to_the_edge(
    known: KnownMagnitudes, t: Fraction, low: Fraction, high: Fraction, near: Fraction
) -> tuple[Fraction, Fraction]:
    """Move the refused end to the edge of what the tree refutes, as near as is asked for."""
    around = known.refuting(t)
    if around is None:
        return low, high
    # The other end is resisted, so the tree ends before it.
    start, end = around
    if t == high and start is not None and high - start > near:
        high = simplest_between(start + near / 2, start + near)
    if t == low and end is not None and end - low > near:
        low = simplest_between(end - near, end - near / 2)
    return low, high
