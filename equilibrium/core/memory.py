"""Trees that are not closed yet, and what closed ones of other loads are worth for the next.

The load enters a tree in the works of its leaves alone. So the trees of other loads are followed
where most of their leaves refute this load; elsewhere the search goes on, and splits as they do.
A leaf holds in other states than those it was found in, too: a part that one of those known closes
needs no program.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from arrangement.numbers.exact import dot
from arrangement.numbers.float_filter import Floats
from equilibrium.model.solution import Leaf

from .cones import Node, OpenSplit
from .leaves import Leaves
from .relaxation import Programs

#: Leaves that are kept by their states, and for parts that none was found in.
_MAX_LEAVES = 20_000
#: The same, times the contacts of each: numbers of arrays.
_MAX_LEAF_CONTACTS = 80_000
#: Leaves that arrays have room for at first.
_FIRST_ROOM = 64
#: Leaves that are compared with the slips of a part, the latest ones.
_MAX_COMPARED_LEAVES = 500
#: Leaves that floats propose for a part, of which none may hold.
_MAX_PROPOSED_LEAVES = 3
#: Equilibria that are kept, besides the last.
_MAX_OTHER_EQUILIBRIA = 999
#: States without directions.
_PLAIN_STATES = ("undecided", "detached", "attached", "stick")
#: A split is followed where open leaves are at most those that refute the load, over this.
_CLOSED_PER_OPEN = 2
#: A search ends when this many parts stay open.
_MAX_HOLES = 8
#: Nodes with two slips in sectors too narrow to split may be one in so many, and some more. On some
#: boundaries there are as many as pairs of sectors; no search seen to succeed had as many.
_NODES_PER_PAIR = 8
_FREE_PAIRS = 10


class OpenTree:
    """A tree that is not closed yet.

    Attributes:
        waiting: open nodes, and their places.
        splits: by states.
        nodes, leaves, holes: how many were tried, closed and left open.
        pairs: tried nodes where two contacts slip in sectors too narrow to split.
    """

    def __init__(self, root: Node) -> None:
        self.top: list[Any] = [None]
        self.waiting: list[tuple[Node, list[Any], int]] = [(root, self.top, 0)]
        self.splits: dict[Node, OpenSplit] = {}
        self.nodes, self.leaves, self.holes, self.pairs = 0, 0, 0, 0

    @property
    def hopeless(self) -> bool:
        """Whether too many parts are open, or too narrow to split, for the search to go on."""
        return self.holes >= _MAX_HOLES or self.pairs >= _FREE_PAIRS + self.nodes // _NODES_PER_PAIR


class _Known:
    """Leaves in floats, which show at once those that may close a part.

    A set of leaves is an integer whose bits are their numbers.
    """

    def __init__(self, leaves: Leaves) -> None:
        self._cones = leaves.cones
        rows = leaves.contacts.rows
        self.leaves: list[Leaf] = []
        #: The works of a load are ``motion . w + rest``.
        self._motion, self._rest = np.empty((_FIRST_ROOM, rows.n)), np.empty(_FIRST_ROOM)
        #: Of each contact ``a - alpha``, its error, ``b`` and h, as leaves have them.
        self._slips: list[list[tuple[float, float, list[float], list[float]]]] = []
        #: By contact and slip, which of them do not hold there, and which do, as far as compared.
        self._fitting: dict[tuple[int, Any], list[int]] = {}
        self._friction = leaves.contacts.friction.tolist()
        #: By state and contact, which of them hold there.
        self._holding = {state: [0] * len(rows) for state in _PLAIN_STATES}
        #: The last load, which of the first leaves refute it, and how many were tried.
        self._refuted: tuple[Floats, int, int] = np.zeros(0), 0, 0

    def add(self, leaf: Leaf, leaves: Leaves) -> None:
        """Add one."""
        n, about = len(self.leaves), leaves.in_floats(leaf)
        if n == len(self._rest):
            for name in ("_motion", "_rest"):
                old = getattr(self, name)
                setattr(self, name, np.concatenate([old, old]))
        self.leaves.append(leaf)
        self._motion[n], self._rest[n] = about.motion, about.work
        numbers = about.lifted, about.error, about.slip, about.h
        self._slips.append(list(zip(*(x.tolist() for x in numbers), strict=True)))
        inside, least = about.room >= -about.error, about.alpha >= 0
        moved = ~about.h.any(axis=1)
        holds = inside & least & moved, least & moved, inside & moved, inside
        for holding, row in zip(self._holding.values(), holds, strict=True):
            for i in np.flatnonzero(row).tolist():
                holding[i] |= 1 << n

    def closing(self, states: Node, load: Floats) -> Iterator[Leaf]:
        """Yield leaves that may close a part, for a load."""
        left, slips = self._refuting(load), []
        for i, state in enumerate(states):
            if isinstance(state, str):
                left &= self._holding[state][i]
            else:
                fitting = self._fitting.setdefault((i, state), [0, 0])
                left &= ~fitting[False]
                slips.append((i, state, fitting))
        compared = proposed = 0
        while left and compared < _MAX_COMPARED_LEAVES and proposed < _MAX_PROPOSED_LEAVES:
            k = left.bit_length() - 1
            left ^= 1 << k
            compared += 1
            if all(self._fits(k, *slip) for slip in slips):
                proposed += 1
                yield self.leaves[k]

    def _refuting(self, load: Floats) -> int:
        """Return which leaves refute a load, about."""
        last, refuting, tried = self._refuted
        if last is not load:
            refuting, tried = 0, 0
        n = len(self.leaves)
        if tried < n:
            refutes = self._motion[tried:n] @ load + self._rest[tried:n] > 0
            packed = np.packbits(refutes, bitorder="little").tobytes()
            refuting |= int.from_bytes(packed, "little") << tried
            self._refuted = load, refuting, n
        return refuting

    def _fits(self, k: int, i: int, state: Any, fitting: list[int]) -> bool:
        """Return whether a leaf holds, about, where a contact slips."""
        if fitting[True] >> k & 1:
            return True
        inside, size, b, h = self._slips[k][i]
        fits = inside - self._friction[i] * self._cones.largest(state, b) >= -size
        fits = fits and all(dot(h, end) <= 0 for end in self._cones.ends(state))
        fitting[fits] |= 1 << k
        return fits


class Memory:
    """Splits and leaves of trees that were closed, by the states of their nodes.

    Attributes:
        programs: of the grasp, once there are some.
    """

    def __init__(self) -> None:
        self.programs: Programs | None = None
        self._splits: dict[Node, OpenSplit] = {}
        self._leaves: dict[Node, Leaf] = {}
        self._known: _Known | None = None
        #: Loads and motions of equilibria, in floats.
        self._held: list[tuple[Floats, Floats]] = []

    def hold(self, load: Floats, motion: Floats) -> None:
        """Remember an equilibrium."""
        self._held = [*self._held[-_MAX_OTHER_EQUILIBRIA:], (load, motion)]

    def near(self, load: Floats, arms: Floats, size: float) -> Floats | None:
        """Return the motion of the equilibrium whose load is nearest, up to a distance."""
        far = [float(np.abs((held - load) * arms).max()) for held, _ in self._held]
        least = min(far, default=size)
        return self._held[far.index(least)][1] if least < size else None

    def add(self, leaf: Leaf, leaves: Leaves) -> None:
        """Remember a leaf, of a tree that may stay open."""
        known = self._known
        if known is None or len(known.leaves) >= min(
            _MAX_LEAVES, _MAX_LEAF_CONTACTS // len(leaves.each)
        ):
            known = self._known = _Known(leaves)
        known.add(leaf, leaves)

    def keep(self, splits: dict[Node, OpenSplit], leaves: dict[Node, Leaf]) -> None:
        """Remember a tree."""
        if len(self._leaves) + len(leaves) > _MAX_LEAVES:
            self._splits, self._leaves = {}, {}
        self._splits |= splits
        self._leaves |= leaves

    def at(self, states: Node, leaves: Leaves) -> OpenSplit | Any | None:
        """Return a leaf that closes a node, else a split that promises to."""
        leaf = self._leaves.get(states)
        if leaf is not None and leaves.refutes(leaf):
            return leaf
        for leaf in self._known.closing(states, leaves.floats) if self._known else ():
            if leaves.holds(states, leaf):
                return leaf
        return self.split(states) if self.promises(states, leaves) else None

    def split(self, states: Node) -> OpenSplit | None:
        """Return a new split of a node as there was; trees that split alike share leaves."""
        split = self._splits.get(states)
        return split and split.again()

    def promises(self, states: Node, leaves: Leaves) -> bool:
        """Return whether most leaves that are remembered below a node refute the load."""
        closed, still = self._ends(states, leaves)
        return closed > 0 and still <= closed // _CLOSED_PER_OPEN

    def _ends(self, states: Node, leaves: Leaves) -> tuple[int, int]:
        """Return how many ends of what is remembered below a node refute the load, or do not."""
        ends = leaves.ends.get(states)
        if ends is None:
            leaf, split = self._leaves.get(states), self._splits.get(states)
            ends = 0, 1
            if leaf is not None and leaves.refutes(leaf):
                ends = 1, 0
            elif split is not None:
                closed, still = zip(
                    *(self._ends(part, leaves) for part in split.parts), strict=True
                )
                ends = sum(closed), sum(still)
            leaves.ends[states] = ends
        return ends
