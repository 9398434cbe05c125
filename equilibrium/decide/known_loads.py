"""What is proved of the loads of a grasp in space, of magnitudes along a direction, and brackets.

The load enters a tree in one place: the works of its leaves, ``lambda . w + sum alpha q``. So a
tree refutes every load for which all of them are above 0, an open convex set. And where two exact
equilibria have contacts that do the same, all between them are equilibria too: springs and cones
are convex, and a slip in one direction has one friction force.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeAlias

from arrangement.numbers.exact import RationalVector, dot, to_text
from arrangement.numbers.linear.intervals import is_long, where_positive
from equilibrium.certificate.leaves import spatial_leaves
from equilibrium.core.contact_law import spring_force
from equilibrium.core.contact_rows import sum_row
from equilibrium.decide import NOT_RESISTED, RESISTED, UNDECIDED
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.contact import Contact
from equilibrium.model.errors import EquilibriumError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Solution

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
        self.refuted = [found for tree in known.trees if (found := self._range(tree)) is not None]
        self.held: list[tuple[Fraction, Fraction]] = []
        self._equilibria: list[tuple[Fraction, Solution]] = []

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
        if any(low <= t <= high for low, high in self.held):
            return RESISTED
        verdict = self.known.solve(self.load(t), **how)
        if verdict.verdict == NOT_RESISTED and (around := self._range(self.known.trees[-1])):
            self.refuted.append(around)
        if verdict.solution is not None and verdict.solution.box is None:
            self._hold(t, verdict.solution)
        return verdict.verdict

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


def blends(grasp: Grasp, one: Solution, other: Solution) -> bool:
    """Return whether all that is between two equilibria is one, as each contact does the same."""
    return all(
        _same(contact, [(x.motion, x.forces[i]) for x in (one, other)])
        for i, contact in enumerate(grasp)
    )


def _same(contact: Contact, pair: Sequence[tuple[RationalVector, RationalVector]]) -> bool:
    """Return whether a contact is on one side of its spring, and slips in one direction or not."""
    springs = [spring_force(contact, motion) for motion, _ in pair]
    if max(springs) <= 0:
        return True
    (a, b), (c, d) = (
        tuple(dot(row, motion) for row in contact.tangential_wrenches) for motion, _ in pair
    )
    one_way = a * d == b * c and a * c + b * d >= 0 and any((a, b)) == any((c, d))
    return min(springs) >= 0 and one_way
