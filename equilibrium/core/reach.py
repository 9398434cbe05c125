"""How near the loads that are resisted come to one that is not, as far as relaxations show.

The load is an unknown of the relaxations, between two given ones. The node that reaches furthest is
split, again and again, so where relaxations come close to the law the border is near. In floats:
what is found is where to ask, and a tree whose open nodes a proof there has to close.
"""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Any, NamedTuple

from arrangement.numbers.float_filter import Floats

from .cones import Node
from .memory import OpenTree
from .tree import SETTINGS, SpatialSearch


class Reach(NamedTuple):
    """A boundary in floats.

    Attributes:
        share: of the way from the load that is not resisted to the other one.
        tree: the nodes that were split; the open ones reach less far.
        stuck: whether the node that reaches furthest is split no further.
    """

    share: float
    tree: OpenTree
    stuck: bool


def reach(search: SpatialSearch, change: Floats, nodes: int, near: float) -> Reach:
    """Return how near resisted loads come to that of a search.

    Args:
        change: of the load to one that is resisted.
        nodes: whose programs are solved, at most.
        near: the search ends where it is as near to the load that is resisted.
    """
    relaxation, tree = search.relaxation, OpenTree(search.root)
    nearest: list[tuple[float, int, Any, Any]] = []
    closed = []
    count = 0

    def ask(states: Node, parent: list[Any], position: int) -> None:
        nonlocal count
        count += 1
        search.count_program()
        first = relaxation.first(states, change)
        place = states, parent, position
        if first is None:
            closed.append(place)
        else:
            heappush(nearest, (first[0], count, first[1], place))

    stuck = False
    ask(*tree.waiting.pop())
    while nearest and count < nodes and nearest[0][0] < 1 - near:
        _, _, point, (states, parent, position) = nearest[0]
        values = relaxation.violations(states, point)
        split = None
        if values.max(initial=0.0) > SETTINGS.law_tolerance:
            split = search.splits.of_worst_contact(states, values, point)
            split = split or search.splits.of_any_contact(states, point)
        if split is None:
            stuck = True
            break
        heappop(nearest)
        tree.splits[states], parent[position] = split, split.node
        for k, part in enumerate(split.parts):
            ask(part, split.children, k)
    tree.waiting = [*closed, *(place for *_, place in nearest)]
    if not nearest:
        return Reach(1.0, tree, stuck)
    share, _, point, _ = nearest[0]
    # There may be an equilibrium near.
    search.memory.hold(
        search.equilibria.smooth.load + share * change, point.motion * relaxation.scale
    )
    return Reach(share, tree, stuck)
