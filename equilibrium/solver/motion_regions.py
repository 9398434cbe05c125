"""A proof that nothing balances the load: motions cut into regions, each with a virtual motion.

The search cuts the half space of homogeneous motions ``(d_0, d)``, d_0 >= 0, into simplicial cones
until a virtual motion closes each. It looks ahead in floating point to choose the edge to cut; a
leaf is written when it has passed an exact test. Regions that stay open are cut where springs and
slips vanish, and then decided exactly; so the search ends with a proof or with an equilibrium.
"""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from arrangement.exact import IntegerVector, RationalVector
from equilibrium.model.errors import TimeLimitError
from equilibrium.model.grasp import Grasp

from .continuation import Continuation, motion_scale
from .integer_contacts import Floats, IntegerContacts, integer_contacts
from .leaf_test import closed, product
from .linear_cells import LinearCell, Node
from .state_equilibrium import Solution, exact_equilibrium
from .virtual_motions import Regions, VirtualMotions

EDGES = tuple(itertools.combinations(range(4), 2))
_SIGNS = tuple(itertools.product((1, -1), repeat=3))
#: Numbers of numpy arrays at once.
_NUMBERS = 3_000_000
_ROUNDS = 6
#: Cuts at about the middle of an edge before a region is cut where contacts change.
_PATIENCE = 40


@dataclass(eq=False, slots=True)
class _Region:
    """An open region: its generators, where its node belongs, how often it was cut out."""

    generators: tuple[IntegerVector, ...]
    place: tuple[list[Any], int]
    depth: int = 0

    def close(self, node: Node) -> None:
        siblings, index = self.place
        siblings[index] = node


class MotionRegions:
    """The search for one question."""

    def __init__(self, grasp: Grasp, wrench: RationalVector, deadline: float = math.inf) -> None:
        self.contacts: IntegerContacts = integer_contacts(grasp)
        self.wrench, self.deadline = wrench, deadline
        self.virtual = VirtualMotions(self.contacts, wrench)
        scale = motion_scale(self.contacts.floats, self.virtual.load)
        self.lengths = np.array([1.0, *(1 / scale)])
        self.batch = max(1, _NUMBERS // (50 * max(len(grasp), 30)))
        self.solution: Solution | None = None

    def search(self) -> Node | Solution:
        """Return the tree, or an equilibrium.

        Raises:
            TimeLimitError: the deadline has passed.
        """
        whole = self._half_space()
        if whole is not None:
            return whole
        children: list[Node] = [None] * 8
        axes = np.eye(4, dtype=int).tolist()
        orthants = [
            _Region(
                (tuple(axes[0]), *(tuple(s * x for x in a) for s, a in zip(signs, axes[1:], strict=True))),
                (children, n),
            )
            for n, signs in enumerate(_SIGNS)
        ]
        active = self._unclosed(orthants)
        while active:
            if time.monotonic() > self.deadline:
                raise TimeLimitError(
                    f"the time limit has passed with {len(active)} regions of motions open; "
                    "give more time, or none"
                )
            chosen, active = active[-self.batch :], active[: -self.batch]
            tired = [r for r in chosen if r.depth >= _PATIENCE]
            active += self._unclosed(self._halves([r for r in chosen if r.depth < _PATIENCE]))
            for region in tired:
                active += self._unclosed(self._cut(region))
                if self.solution is not None:
                    return self.solution
        return {"orthants": children}

    def _half_space(self) -> Node | None:
        """Return the leaf that closes all motions at once, if there is one."""
        c, v = self.contacts.floats, self.virtual
        load, least, _, _ = v.works
        good = (load > 1e-9) & (least.min(axis=0, initial=1.0) >= -1e-9)
        for row in np.flatnonzero(good):
            motion = v.integers(v.candidates[row])
            if self._half_space_holds(motion):
                return [str(x) for x in motion]
        del c
        return None

    def _half_space_holds(self, motion: Sequence[int]) -> bool:
        c = self.contacts
        chosen = np.array(motion, dtype=object)
        across = abs(c.tangent.dot(chosen) * c.friction)
        least = c.normal.dot(chosen) * c.friction_unit - across
        return bool((least >= 0).all()) and sum(x * w for x, w in zip(motion, self.wrench, strict=True)) > 0

    def _scaled(self, regions: Sequence[Sequence[IntegerVector]]) -> tuple[Floats, Floats]:
        """Return generators of the length 1 (R, 4, 4), and their lengths."""
        generators = np.array(regions, dtype=float).reshape(-1, 4, 4)
        size = np.linalg.norm(generators * self.lengths, axis=-1)
        return generators / size[..., None], size

    def _floats(self, generators: Floats) -> Regions:
        c = self.contacts.floats
        return Regions(generators[..., 0], generators @ c.spring.T, generators[..., 1:] @ c.tangent.T)

    def _unclosed(self, regions: list[_Region]) -> list[_Region]:
        """Close what can be closed; return the others."""
        if not regions:
            return []
        generators, _ = self._scaled([r.generators for r in regions])
        motions, values = self.virtual.best(self._floats(generators), _ROUNDS)
        hopeful = np.flatnonzero(values > 0).tolist()
        exact = [self.virtual.integers(motions[n]) for n in hopeful]
        tested = closed(
            self.contacts, self.wrench, [regions[n].generators for n in hopeful], exact
        ) if hopeful else []
        done = set()
        for n, motion, good in zip(hopeful, exact, tested, strict=True):
            if good:
                regions[n].close([str(x) for x in motion])
                done.add(n)
        return [region for n, region in enumerate(regions) if n not in done]

    def _halves(self, regions: list[_Region]) -> list[_Region]:
        """Cut each region at about the middle of the edge that promises most."""
        if not regions:
            return []
        generators, size = self._scaled([r.generators for r in regions])
        first, second = (list(ends) for ends in zip(*EDGES, strict=True))
        steps = np.rint(np.log2(size[:, second] / size[:, first]))
        steps = np.where(np.abs(steps) <= 1, 0, steps).astype(int)
        left = size[:, first] * 2.0 ** np.maximum(steps, 0)
        right = size[:, second] * 2.0 ** np.maximum(-steps, 0)
        middle = left[..., None] * generators[:, first] + right[..., None] * generators[:, second]
        middle /= np.linalg.norm(middle * self.lengths, axis=-1, keepdims=True)
        parts = np.repeat(generators[:, None], 12, axis=1).reshape(-1, 6, 2, 4, 4)
        for n, (j, k) in enumerate(EDGES):
            parts[:, n, 0, j] = middle[:, n]
            parts[:, n, 1, k] = middle[:, n]
        _, values = self.virtual.best(self._floats(parts.reshape(-1, 4, 4)))
        values = values.reshape(-1, 6, 2)
        missing = np.minimum(values, 0).sum(axis=2)
        cosine = np.sum(generators[:, first] * generators[:, second] * self.lengths**2, axis=-1)
        score = missing / (1e-9 - missing.min(axis=1, keepdims=True)) - cosine + (values > 0).sum(axis=2)
        result = []
        for region, choice, step in zip(regions, score.argmax(axis=1).tolist(), steps.tolist(), strict=True):
            shift = step[choice]
            result += self._split(region, *EDGES[choice], 2 ** max(shift, 0), 2 ** max(-shift, 0))
        return result

    def _split(self, region: _Region, j: int, k: int, p: int, q: int) -> list[_Region]:
        """Cut the edge between two generators; return the parts."""
        g = region.generators
        middle = [p * a + q * b for a, b in zip(g[j], g[k], strict=True)]
        common = math.gcd(*middle)
        vector = tuple(x // common for x in middle)
        children: list[Node] = [None, None]
        at = {} if p == q == 1 else {"at": [str(p), str(q)]}
        region.close({"edge": [j, k], **at, "children": children})
        return [
            _Region((*g[:n], vector, *g[n + 1 :]), (children, place), region.depth + 1)
            for place, n in enumerate((j, k))
        ]

    def _cut(self, region: _Region) -> list[_Region]:
        """Cut a region where a spring or a slip vanishes; or decide it, where none does inside."""
        self._try_there(region)
        if self.solution is not None:
            return []
        rows = np.array(region.generators, dtype=object)
        spring = product(rows, self.contacts.spring.T)
        slip = product(rows[:, 1:], self.contacts.tangent.T)
        slip = slip[:, (spring > 0).any(axis=0) & (self.contacts.friction > 0)]
        for values in (spring, slip):
            changing = np.flatnonzero((values > 0).any(axis=0) & (values < 0).any(axis=0))
            if len(changing):
                j, k, p, q = self._crossing(rows, values[:, changing])
                return self._split(region, j, k, p, q)
        decided = LinearCell(self.contacts, self.wrench, region.generators).decide()
        if isinstance(decided, Solution):
            self.solution = decided
        else:
            region.close(decided)
        return []

    def _crossing(self, rows: Any, values: Any) -> tuple[int, int, int, int]:
        """Return where a value vanishes on the longest edge where one does."""
        generators, _ = self._scaled([rows])
        scaled = generators[0] * self.lengths
        best, found = -math.inf, (0, 0, 1, 1)
        for j, k in EDGES:
            crossing = np.flatnonzero(values[j] * values[k] < 0)
            if len(crossing):
                length = 1 - float(scaled[j] @ scaled[k])
                if length > best:
                    i = crossing[0]
                    p, q = abs(values[k, i]), abs(values[j, i])
                    common = math.gcd(p, q)
                    best, found = length, (j, k, p // common, q // common)
        return found

    def _try_there(self, region: _Region) -> None:
        """Look for an equilibrium near the middle of a region."""
        generators, _ = self._scaled([region.generators])
        middle = generators[0].sum(axis=0)
        if not middle[0] > 0:
            return
        search = Continuation(self.contacts.floats, self.wrench)
        with np.errstate(all="ignore"):
            for motion, eps in search.path(middle[1:] / middle[0], 1e-3):
                guess = search.guess(motion, eps)
                self.solution = exact_equilibrium(self.contacts, self.wrench, guess)
                if self.solution is not None:
                    return
