"""A proof that nothing balances the load: motions cut into regions, each with a virtual motion.

The search cuts the half space of homogeneous motions ``(d_0, d)``, d_0 >= 0, into simplicial cones
until a virtual motion closes each. It looks ahead in floating point to choose the edge to cut; a
leaf is written when it has passed an exact test. Regions that stay open are cut where springs and
slips vanish, and then decided exactly; so the search ends with a proof or with an equilibrium.
"""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, RationalVector, to_text
from arrangement.numbers.float_filter import Floats
from equilibrium.core.contacts import IntegerContacts
from equilibrium.core.continuation import motion_scale
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Leaf, Solution
from equilibrium.plane.search.region_states import Node, StateSplits, TooManyParts
from equilibrium.plane.search.state_equilibrium import find_equilibrium
from equilibrium.plane.search.virtual_motions import Regions, VirtualMotions, closed

EDGES = tuple(itertools.combinations(range(4), 2))
#: Generators of all homogeneous motions, and of the eight orthants in the order of certificates.
HALF_SPACE = (
    (1, 0, 0, 0),
    *(tuple(sign * (k == n) for k in range(4)) for n in (1, 2, 3) for sign in (1, -1)),
)
ORTHANTS = tuple(
    ((1, 0, 0, 0), (0, x, 0, 0), (0, 0, y, 0), (0, 0, 0, z))
    for x, y, z in itertools.product((1, -1), repeat=3)
)
#: Numbers of numpy arrays at once.
_MAX_ARRAY_NUMBERS = 3_000_000
#: A region cut out so often, and every fourth time from then on, is tried by states.
_CUTS_BEFORE_STATES = 12
#: A program guesses what closes a region after so many cuts again,
_CUTS_BETWEEN = 4
#: where no more than this part of its works is missing.
_NEAR = 0.01
#: and no more contacts than this are open, since its time grows as their third power.
_MAX_OPEN = 32
#: Up to so many contacts, and all with huge or tiny numbers, which floats cannot guide, are tried
#: by states as a whole.
_MAX_CONTACTS_WHOLE = 6
#: Cuts before that.
_CUTS_BEFORE_WHOLE = 40
#: Programs of it.
_MAX_PROGRAMS_WHOLE = 300
#: Cuts after which edges are cut where springs end, too: until then their middles do.
_CUTS_BEFORE_SPRING_ENDS = 12
#: What counts as 0, in units of the generators and of the load.
_TOLERANCE = 1e-9
#: Steps of a region that is cut, and for each contact.
_REGION_STEPS = 10_000
_REGION_STEPS_PER_CONTACT = 200


@dataclass(eq=False, slots=True)
class _OpenRegion:
    """An open region: its generators, where its node belongs, how often it was cut out."""

    generators: tuple[IntegerVector, ...]
    place: tuple[list[Any], int]
    depth: int = 0

    def close(self, node: Node) -> None:
        siblings, index = self.place
        siblings[index] = node


def _shortened(vector: IntegerVector) -> list[float]:
    """Return a vector in floating point; a very long one at another scale."""
    excess = max(0, max(map(int.bit_length, vector)) - 900)
    return [float(x >> excess) for x in vector]


def _simple(ratio: Floats, even: Any) -> tuple[Floats, Floats]:
    """Return small positive integers p, q with p / q near a ratio; 1, 1 where `even`."""
    ratio = np.where(even, 1.0, np.clip(ratio, 1e-15, 1e15))
    fine = np.rint(4 * ratio)
    common = np.gcd(fine.astype(np.int64), 4)
    between = (ratio > 1 / 3) & (ratio < 3)
    p = np.where(between, fine / common, np.maximum(np.rint(ratio), 1.0))
    q = np.where(between, 4 / common, np.maximum(np.rint(1 / ratio), 1.0))
    return p, q


class MotionRegions:
    """The search for one question.

    Args:
        effort: that is left.
        rounds: how often the numbers of a virtual motion are made finer before a region is cut.
        turn: how much wide angles count when an edge is chosen.
    """

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        effort: Effort | None = None,
        rounds: int = 6,
        turn: float = 1.0,
    ) -> None:
        self.contacts, self.wrench, self.effort = contacts, wrench, effort or Effort()
        self.rounds, self.turn = rounds, turn
        self.virtual = VirtualMotions(self.contacts, wrench)
        scale = motion_scale(self.contacts.floats, self.virtual.load)
        self.lengths = np.array([1.0, *(1 / scale)])
        self.batch = max(1, _MAX_ARRAY_NUMBERS // (50 * max(len(contacts), 30)))
        self.solution: Solution | None = None
        #: Rows of bounded displacements.
        self.rows = np.array([_shortened(row) for row in contacts.bounds[0].tolist()])
        self.rows = self.rows.reshape(-1, 4)
        self.rows /= np.abs(self.rows).max(axis=1, keepdims=True, initial=1e-300)

    def search(self) -> Node | Solution:
        """Return the tree, or an equilibrium.

        Raises:
            TimeoutError: no effort is left.
        """
        children: list[Node] = [None] * 8
        active = self._unclosed(
            [_OpenRegion(orthant, (children, n)) for n, orthant in enumerate(ORTHANTS)]
        )
        cuts, first = (
            0,
            _CUTS_BEFORE_WHOLE if len(self.contacts) <= _MAX_CONTACTS_WHOLE else math.inf,
        )
        if not self.contacts.floats.moderate:
            first, count = 0, len(self.contacts)
            budget.check_cost(
                f"exact programs for {count} contacts with huge or tiny numbers",
                "round them to the range from 1e-30 to 1e30",
                steps=30 * count**3,
            )
        while active:
            if cuts >= first:
                first = math.inf
                root: list[Node] = [None]
                if self._by_states(_OpenRegion(HALF_SPACE, (root, 0)), _MAX_PROGRAMS_WHOLE):
                    return root[0] if self.solution is None else self.solution
            active.sort(key=lambda region: region.depth)
            chosen, active = active[-self.batch :], active[: -self.batch]
            self.effort.check(
                len(chosen) * (_REGION_STEPS + _REGION_STEPS_PER_CONTACT * len(self.contacts))
            )
            whole = [region for region in chosen if not self._decided(region)]
            if self.solution is not None:
                return self.solution
            cuts += len(whole)
            active += self._unclosed(self._halves(whole))
        return {"orthants": children}

    def _decided(self, region: _OpenRegion) -> bool:
        """Try the states of contacts on a small region, now and then; return whether that ended."""
        if self.solution is not None:
            return True
        if region.depth < _CUTS_BEFORE_STATES or region.depth % _CUTS_BETWEEN:
            return False
        if region.depth == _CUTS_BEFORE_STATES:
            self._look_inside(region)
        loose = self._floats(self._scaled([region.generators])[0])
        count = int(loose.open.sum())
        if self.solution is not None or count > region.depth - _CUTS_BEFORE_STATES:
            return self.solution is not None
        return self._by_states(region, 10 * 2.0 ** (region.depth // 8))

    def half_space(self) -> Node | None:
        """Return the leaf that closes all motions at once, if one of the candidates does.

        The load then works, and no contact can work against it, whatever its spring does.
        """
        v, c = self.virtual, self.contacts
        columns, least, *_ = v.works
        load = v.load @ columns
        works = load > _TOLERANCE * np.abs(load).max()
        for row in np.flatnonzero(works & (least.min(axis=0, initial=1.0) > -_TOLERANCE)):
            motion = np.array(v.integers(v.candidates[row]), dtype=object)
            work = sum(int(x) * w for x, w in zip(motion, self.wrench, strict=True))
            if work > 0 and all((edge.dot(motion) >= 0).all() for edge in c.edges):
                return Leaf(tuple(motion.tolist()), {})
        return None

    def _scaled(self, regions: Sequence[Sequence[IntegerVector]]) -> tuple[Floats, Floats]:
        """Return generators of the length 1 (R, 4, 4), and their lengths."""
        generators = np.array([_shortened(g) for region in regions for g in region])
        generators = generators.reshape(-1, 4, 4)
        size = np.linalg.norm(generators * self.lengths, axis=-1)
        return generators / size[..., None], size

    def _floats(self, generators: Floats) -> Regions:
        data = self.contacts.floats, self.virtual.load, generators
        if not len(self.rows):
            none = np.zeros(len(generators), dtype=np.intp)
            return Regions(*data, np.zeros(generators.shape[:2]), none)
        # The row that most of the region breaks.
        values = generators @ self.rows.T
        least, most = values.min(axis=1), values.max(axis=1)
        share = np.where(least < -_TOLERANCE, -least / (most - least + 1e-300), 0.0)
        row = share.argmax(axis=1)
        beyond = np.take_along_axis(values, row[:, None, None], axis=2)[:, :, 0]
        beyond = np.where(share.max(axis=1)[:, None] > 0, beyond, 0.0)
        return Regions(*data, beyond, row)

    def _unclosed(self, regions: list[_OpenRegion]) -> list[_OpenRegion]:
        """Close what can be closed; return the others."""
        if not regions:
            return []
        generators, _ = self._scaled([r.generators for r in regions])
        done = {n for n, region in enumerate(regions) if self._outside(region)}
        floats = self._floats(generators)
        motions, values = self.virtual.best(floats, self.rounds)
        # Near the boundary floats cannot distinguish 0 from what is enough.
        hopeful = np.flatnonzero(values > -_TOLERANCE).tolist()
        factors = np.zeros(floats.open.shape)
        near = (values <= -_TOLERANCE) & (values > -_NEAR * floats.size)
        for n in np.flatnonzero(near & (floats.open.sum(axis=1) <= _MAX_OPEN)).tolist():
            if regions[n].depth > 0 and not regions[n].depth % _CUTS_BETWEEN and n not in done:
                guess = self.virtual.multiplied(floats, n)
                if guess is not None:
                    motions[n], factors[n] = guess
                    hopeful.append(n)
        exact = [self.virtual.integers(motions[n]) for n in hopeful]
        generators_of = [regions[n].generators for n in hopeful]
        rows = floats.row[hopeful].tolist() if len(self.rows) else []
        question = self.contacts, self.wrench, generators_of
        tested = closed(*question, exact, factors[hopeful], rows) if hopeful else []
        for place, (n, motion, multiplier) in enumerate(zip(hopeful, exact, tested, strict=True)):
            if multiplier is None:
                continue
            used = {rows[place]: multiplier} if multiplier else {}
            leaf = self.contacts.bound_leaf(motion, used)
            mixed = {int(i): (int(factors[n, i]), 0) for i in np.flatnonzero(factors[n])}
            regions[n].close(replace(leaf, multipliers=mixed))
            done.add(n)
        return [region for n, region in enumerate(regions) if n not in done]

    def _outside(self, region: _OpenRegion) -> bool:
        """Close a region outside one bounded displacement; return whether it is."""
        if not len(self.rows):
            return False
        rows, _ = self.contacts.bounds
        generators = np.array(region.generators, dtype=object)
        values = generators.dot(rows.T)
        least = (values < 0) | ((values == 0) & (generators[:, :1] == 0))
        for k in np.flatnonzero(least.all(axis=0))[:1]:
            region.close(self.contacts.bound_leaf((0, 0, 0), {int(k): 1}))
            return True
        return False

    def _halves(self, regions: list[_OpenRegion]) -> list[_OpenRegion]:
        """Cut each region at the edge that promises most: near the middle, or a spring."""
        if not regions:
            return []
        generators, size = self._scaled([r.generators for r in regions])
        floats = self._floats(generators)
        first, second = (list(ends) for ends in zip(*EDGES, strict=True))
        ratio = size[:, second] / size[:, first]
        left, right = _simple(np.exp2(np.rint(np.log2(ratio))), np.abs(np.log2(ratio)) < 1.5)
        if any(region.depth >= _CUTS_BEFORE_SPRING_ENDS for region in regions):
            crossing, there = self._springs_end(floats, first, second)
            crossing = np.where(crossing > 0, crossing * ratio, 1.0)
            more = _simple(crossing, np.zeros(1, dtype=bool))
            left, right = (np.concatenate(x, axis=1) for x in zip((left, right), more, strict=True))
            first, second = first * 2, second * 2
            possible = np.concatenate([np.ones_like(there), there], axis=1)
        else:
            possible = np.ones(left.shape, dtype=bool)
        middle = (left * size[:, first])[..., None] * generators[:, first]
        middle = middle + (right * size[:, second])[..., None] * generators[:, second]
        middle /= np.linalg.norm(middle * self.lengths, axis=-1, keepdims=True)
        choices = len(first)
        parts = np.repeat(generators[:, None], 2 * choices, axis=1).reshape(-1, choices, 2, 4, 4)
        for n, (j, k) in enumerate(zip(first, second, strict=True)):
            parts[:, n, 0, j] = middle[:, n]
            parts[:, n, 1, k] = middle[:, n]
        _, values = self.virtual.best(self._floats(parts.reshape(-1, 4, 4)))
        values = values.reshape(-1, choices, 2)
        missing = np.minimum(values, 0).sum(axis=2)
        cosine = np.sum(generators[:, first] * generators[:, second] * self.lengths**2, axis=-1)
        score = missing / (1e-9 - missing.min(axis=1, keepdims=True)) - self.turn * cosine
        score = np.where(possible, score + (values > 0).sum(axis=2), -np.inf)
        result = []
        for n, choice in enumerate(score.argmax(axis=1).tolist()):
            weights = int(left[n, choice]), int(right[n, choice])
            result += self._split(regions[n], first[choice], second[choice], *weights)
        return result

    def _springs_end(
        self, floats: Regions, first: list[int], second: list[int]
    ) -> tuple[Floats, Any]:
        """Return for each edge the weights' ratio where a spring ends, and whether one does."""
        one, two = floats.spring[:, first], floats.spring[:, second]
        strength = np.where(one * two < 0, np.minimum(np.abs(one), np.abs(two)), 0.0)
        chosen = strength.argmax(axis=2)[..., None]
        there = np.take_along_axis(strength, chosen, axis=2)[..., 0] > _TOLERANCE
        one, two = (np.abs(np.take_along_axis(x, chosen, axis=2)[..., 0]) for x in (one, two))
        return np.where(there, two / np.where(there, one, 1.0), 0.0), there

    def _split(self, region: _OpenRegion, j: int, k: int, p: int, q: int) -> list[_OpenRegion]:
        """Cut the edge between two generators; return the parts."""
        g = region.generators
        middle = [p * a + q * b for a, b in zip(g[j], g[k], strict=True)]
        common = math.gcd(*middle)
        vector = tuple(x // common for x in middle)
        children: list[Node] = [None, None]
        at = {} if p == q == 1 else {"at": [to_text(p), to_text(q)]}
        region.close({"edge": [j, k], **at, "children": children})
        return [
            _OpenRegion((*g[:n], vector, *g[n + 1 :]), (children, place), region.depth + 1)
            for place, n in enumerate((j, k))
        ]

    def _by_states(self, region: _OpenRegion, limit: float) -> bool:
        """Decide a region by the states of contacts; return whether that ended."""
        splits = StateSplits(self.contacts, self.wrench, region.generators, limit, self.effort)
        try:
            decided = splits.decide()
        except TooManyParts:
            return False
        if isinstance(decided, Solution):
            self.solution = decided
        else:
            region.close(decided)
        return True

    def _look_inside(self, region: _OpenRegion) -> None:
        """Look for an equilibrium near the middle of a region."""
        generators, _ = self._scaled([region.generators])
        middle = generators[0].sum(axis=0)
        if middle[0] > 0:
            self.solution = find_equilibrium(self.contacts, self.wrench, middle[1:] / middle[0])


#: Other searches that may find a smaller proof: rounds and turn, see `MotionRegions`.
_OTHER_SEARCHES = ((3, 1.0), (10, 1.0), (8, 0.5), (8, 2.0))
#: Up to so many contacts states alone are tried for a smaller proof.
_MAX_CONTACTS_STATES_ALONE = 12
#: Programs of that.
_MAX_PROGRAMS_STATES_ALONE = 100


def resistance(
    contacts: IntegerContacts,
    wrench: RationalVector,
    effort: Effort,
    shorten: bool = False,
) -> Solution | Node:
    """Return an equilibrium, or the tree that proves that there is none; always one of the two.

    Args:
        effort: that is left.
        shorten: try for a smaller tree, within the effort.

    Raises:
        TimeoutError: no effort is left.
    """
    regions = MotionRegions(contacts, wrench, effort)
    leaf = regions.half_space()
    if leaf is not None:
        return leaf
    outcome = find_equilibrium(contacts, wrench) or regions.search()
    if isinstance(outcome, Solution) or not shorten:
        return outcome
    return min((outcome, *_others(contacts, wrench, effort)), key=_length)


def _length(tree: Node) -> int:
    """Return about how long a tree is in a certificate."""
    return len(json.dumps(tree, default=lambda leaf: list(map(to_text, leaf.numbers))))


def _others(contacts: IntegerContacts, wrench: RationalVector, effort: Effort) -> list[Node]:
    """Return other proofs of the same, as many as the effort allows."""
    trees = []
    try:
        if len(contacts) <= _MAX_CONTACTS_STATES_ALONE:
            trees.append(
                StateSplits(
                    contacts, wrench, HALF_SPACE, _MAX_PROGRAMS_STATES_ALONE, effort
                ).decide()
            )
    except (TooManyParts, TimeoutError):
        pass
    try:
        for rounds, turn in _OTHER_SEARCHES:
            trees.append(MotionRegions(contacts, wrench, effort, rounds, turn).search())
    except TimeoutError:
        pass
    return trees
