"""The faces of a dual from its graph alone, in two ways that know nothing of the incidence.

A 3-connected planar graph has one embedding in the sphere, up to reflection (Whitney), so both
ways must give the faces that the incidence gives.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

import networkx as nx

Cycle = tuple[int, ...]


def faces_by_embedding(graph: nx.Graph) -> tuple[Cycle, ...]:
    """Return all faces of a planar embedding, each a cycle of nodes, consistently oriented."""
    planar, embedding = nx.check_planarity(graph)
    assert planar
    seen: set[tuple[int, int]] = set()
    return tuple(
        tuple(embedding.traverse_face(u, v, mark_half_edges=seen))
        for u, v in embedding.edges
        if (u, v) not in seen
    )


def faces_by_minimum_cycle_basis(graph: nx.Graph) -> tuple[Cycle, ...]:
    """Return the cycles of a minimum cycle basis, and their symmetric sum as the last face.

    For the dual of rank 3 every minimum cycle basis has F - 1 faces, and the sum is the last.
    Source: [HaasHeger2018], section IV.B, step 3.
    """
    basis = [walk(graph.subgraph(cycle).edges) for cycle in nx.minimum_cycle_basis(graph)]
    uses = Counter(
        frozenset(edge)
        for cycle in basis
        for edge in zip(cycle, cycle[1:] + cycle[:1], strict=True)
    )
    return (*basis, walk(tuple(edge) for edge, times in uses.items() if times % 2))


def walk(edges: Iterable[tuple[int, int]]) -> Cycle:
    """Return the nodes of a set of edges that form one cycle, in cyclic order."""
    graph = nx.Graph(list(edges))
    assert all(degree == 2 for _, degree in graph.degree)
    assert nx.is_connected(graph)
    return tuple(u for u, _ in nx.find_cycle(graph))


def same_faces(left: Iterable[Sequence[int]], right: Iterable[Sequence[int]]) -> bool:
    """Whether two lists hold the same cycles, up to order, starting points and orientation."""
    return Counter(map(_canonical_cycle, left)) == Counter(map(_canonical_cycle, right))


def _canonical_cycle(cycle: Sequence[int]) -> Cycle:
    """Return the rotation or reflection of a cycle that comes first in dictionary order."""
    start = cycle.index(min(cycle))
    forward = (*cycle[start:], *cycle[:start])
    backward = (forward[0], *reversed(forward[1:]))
    return min(forward, backward)
