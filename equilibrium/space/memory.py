"""Trees that are not closed yet, and what closed ones of other loads are worth for the next.

The load enters a tree in the works of its leaves alone. So the tree of another load is followed:
where a leaf does not refute this load, the search goes on from there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from .cones import Node, OpenSplit, State
from .leaves import ExactLeaf, Leaves

#: So many leaves are kept.
_MOST = 20_000
#: A tree is followed where at most one leaf in this many, and so many others, are open.
_SHARE, _OTHERS = 4, 4
#: So many parts stay open before a search ends.
_HOLES = 8
#: Nodes with two slips in sectors too narrow to split may be one in this many, and so many others.
#: On some borders there are as many as pairs of sectors; no search seen to succeed had as many.
_NODES, _PAIRS = 8, 10


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
        return self.holes >= _HOLES or self.pairs >= _PAIRS + self.nodes // _NODES


class Memory:
    """Splits and leaves of trees that were closed, by the states of their nodes."""

    def __init__(self) -> None:
        self._splits: dict[Node, OpenSplit] = {}
        self._leaves: dict[Node, ExactLeaf] = {}

    def keep(self, splits: dict[Node, OpenSplit], leaves: dict[Node, ExactLeaf]) -> None:
        """Remember a tree."""
        if len(self._leaves) + len(leaves) > _MOST:
            self._splits, self._leaves = {}, {}
        self._splits |= splits
        self._leaves |= leaves

    def at(self, states: Node, leaves: Leaves) -> OpenSplit | Any | None:
        """Return the leaf of a node if it refutes the load, a new split as there was, or None."""
        leaf = self._leaves.get(states)
        if leaf is not None and leaves.refutes(leaf):
            return leaf.node
        split = self._splits.get(states)
        return split and split.again()

    def promises(self, root: Node, leaves: Leaves) -> bool:
        """Return whether most leaves of the tree that is remembered refute the load."""
        closed, still = 0, 0
        for node in self._ends(root, leaves):
            closed, still = closed + (node is not None), still + (node is None)
        return closed > 0 and still <= _OTHERS + (closed + still) // _SHARE

    def _ends(self, root: Node, leaves: Leaves) -> Iterator[Any | None]:
        """Yield a leaf or None for each end of the tree that is remembered."""
        waiting: list[Sequence[State]] = [root]
        while waiting:
            found = self.at(tuple(waiting.pop()), leaves)
            if isinstance(found, OpenSplit):
                waiting += found.parts
            else:
                yield found
