"""Trees that are not closed yet, and what closed ones of other loads are worth for the next.

The load enters a tree in the works of its leaves alone. So the trees of other loads are followed
where most of their leaves refute this load; elsewhere the search goes on, and splits as they do.
"""

from __future__ import annotations

from typing import Any

from .cones import Node, OpenSplit
from .leaves import ExactLeaf, Leaves

#: So many leaves are kept.
_MOST = 20_000
#: A split is followed where open leaves are at most those that refute the load, over this.
_SHARE = 2
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
        """Return the leaf of a node if it refutes the load, else a split that promises to."""
        leaf = self._leaves.get(states)
        if leaf is not None and leaves.refutes(leaf):
            return leaf.node
        return self.split(states) if self.promises(states, leaves) else None

    def split(self, states: Node) -> OpenSplit | None:
        """Return a new split of a node as there was; trees that split alike share leaves."""
        found = self._splits.get(states)
        return found and found.again()

    def promises(self, states: Node, leaves: Leaves) -> bool:
        """Return whether most leaves that are remembered below a node refute the load."""
        closed, still = self._ends(states, leaves)
        return closed > 0 and still <= closed // _SHARE

    def _ends(self, states: Node, leaves: Leaves) -> tuple[int, int]:
        """Return how many ends of what is remembered below a node refute the load, or do not."""
        found = leaves.ends.get(states)
        if found is None:
            leaf, split = self._leaves.get(states), self._splits.get(states)
            found = 0, 1
            if leaf is not None and leaves.refutes(leaf):
                found = 1, 0
            elif split is not None:
                closed, still = zip(
                    *(self._ends(part, leaves) for part in split.parts), strict=True
                )
                found = sum(closed), sum(still)
            leaves.ends[states] = found
        return found
