"""Orders of the nodes of a layered graph with few crossings, by barycentres."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

Covers: TypeAlias = Sequence[Sequence[Sequence[int]]]

#: More edges than this between two layers are not counted for crossings.
_COUNTED = 2500


def layered_orders(
    sizes: Sequence[int], covers: Covers, fixed: int = 0, sweeps: int = 16
) -> list[list[int]]:
    """Return an order of the nodes of every layer.

    Args:
        sizes: the number of nodes of each layer.
        covers: for each layer and each node, its neighbours in the next layer.
        fixed: so many layers, the first ones, keep their order.
        sweeps: how often layers are sorted by the means of their neighbours, up and down in turn;
            the order with the fewest crossings is kept (K. Sugiyama, S. Tagawa, M. Toda, IEEE
            Trans. SMC 11 (1981)).
    """
    below = [_reversed(covers[k], sizes[k + 1]) for k in range(len(sizes) - 1)]
    orders = [list(range(size)) for size in sizes]
    best, fewest = orders, _crossings(orders, covers)
    for sweep in range(sweeps):
        orders = [list(order) for order in orders]
        if sweep % 2:
            for k in range(len(sizes) - 2, fixed - 1, -1):
                orders[k] = _sorted(orders[k], orders[k + 1], covers[k])
        else:
            for k in range(max(1, fixed), len(sizes)):
                orders[k] = _sorted(orders[k], orders[k - 1], below[k - 1])
        count = _crossings(orders, covers)
        if count < fewest:
            best, fewest = orders, count
    return best


def _reversed(covers: Sequence[Sequence[int]], size: int) -> list[list[int]]:
    found: list[list[int]] = [[] for _ in range(size)]
    for node, above in enumerate(covers):
        for cover in above:
            found[cover].append(node)
    return found


def _sorted(
    order: Sequence[int], beside: Sequence[int], neighbours: Sequence[Sequence[int]]
) -> list[int]:
    """Return a layer in the order of the mean places of its neighbours in the layer beside it."""
    place = {node: (k + 0.5) / len(beside) for k, node in enumerate(beside)}
    own = {node: (k + 0.5) / len(order) for k, node in enumerate(order)}

    def mean(node: int) -> float:
        around = [place[other] for other in neighbours[node]]
        return round(sum(around) / len(around), 9) if around else own[node]

    return sorted(order, key=lambda node: (mean(node), own[node]))


def _crossings(orders: Sequence[Sequence[int]], covers: Covers) -> int:
    """Return the number of pairs of edges that cross between neighbouring layers."""
    total = 0
    for k in range(len(orders) - 1):
        low = {node: i for i, node in enumerate(orders[k])}
        high = {node: i for i, node in enumerate(orders[k + 1])}
        edges = [(low[u], high[v]) for u, above in enumerate(covers[k]) for v in above]
        if len(edges) <= _COUNTED:
            a, b = np.array(edges).reshape(-1, 2).T
            total += int(((a[:, None] < a) & (b[:, None] > b)).sum())
    return total
