"""The faces of the dual from its graph alone, in two ways that know nothing of the incidence.

A 3-connected planar graph has one embedding in the sphere, up to reflection (Whitney), so both
ways must give the faces that the incidence gives.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Literal, TypeAlias

import networkx as nx

from arrangement.errors import ArrangementError, InputError, MissingExtraError

Cycle: TypeAlias = tuple[int, ...]
Backend: TypeAlias = Literal["networkx", "igraph"]


def faces_by_embedding(graph: nx.Graph) -> tuple[Cycle, ...]:
    """Return all faces of a planar embedding, each a cycle of nodes, consistently oriented.

    Raises:
        InputError: the graph is not planar.

    Complexity: linear in the graph (left-right planarity test).
    """
    planar, embedding = nx.check_planarity(graph)
    if not planar:
        raise InputError("the graph is not planar; only the dual of rank 3 or less has faces")
    seen: set[tuple[int, int]] = set()
    return tuple(
        tuple(embedding.traverse_face(u, v, mark_half_edges=seen))
        for u, v in embedding.edges
        if (u, v) not in seen
    )


def faces_by_minimum_cycle_basis(
    graph: nx.Graph, backend: Backend = "networkx"
) -> tuple[Cycle, ...]:
    """Return the cycles of a minimum cycle basis, and their symmetric sum as the last face.

    For the dual of rank 3 every minimum cycle basis has F - 1 faces, and the sum is the last.
    The cycles have no consistent orientation.

    Args:
        graph: the graph of a dual polyhedron.
        backend: ``"networkx"`` (the published route) or ``"igraph"`` (faster; needs the extra).

    Raises:
        MissingExtraError: igraph is not installed.
        ArrangementError: the cycles or their sum are no single cycles (not so in rank 3).

    Complexity: measured growth about m^5.7 in the number of planes (networkx).
    Source: [HaasHeger2018], section IV.B, step 3; [MehlhornMichail2005].
    """
    if backend not in _BASES:
        raise InputError(f"backend is {backend!r}; choose one of {', '.join(_BASES)}")
    basis = _BASES[backend](graph)
    uses = Counter(edge for cycle in basis for edge in _edges(cycle))
    last = [edge for edge, times in uses.items() if times % 2]
    return (*basis, _walk(last))


def same_faces(left: Iterable[Sequence[int]], right: Iterable[Sequence[int]]) -> bool:
    """Whether two lists hold the same cycles, up to order, starting points and orientation."""
    return Counter(map(_canonical_cycle, left)) == Counter(map(_canonical_cycle, right))


def _canonical_cycle(cycle: Sequence[int]) -> Cycle:
    """Return the rotation or reflection of a cycle that comes first in dictionary order."""
    start = cycle.index(min(cycle))
    forward = (*cycle[start:], *cycle[:start])
    backward = (forward[0], *reversed(forward[1:]))
    return min(forward, backward)


def _networkx_basis(graph: nx.Graph) -> list[Cycle]:
    cycles = nx.minimum_cycle_basis(graph)
    return [_walk(list(graph.subgraph(cycle).edges)) for cycle in cycles]


def _igraph_basis(graph: nx.Graph) -> list[Cycle]:
    try:
        import igraph
    except ImportError:
        raise MissingExtraError(
            "igraph is not installed; pip install 'slipstates[igraph]', or use the backend networkx"
        ) from None
    nodes = list(graph)
    place = {node: i for i, node in enumerate(nodes)}
    edges = list(graph.edges)
    copy = igraph.Graph(len(nodes), [(place[u], place[v]) for u, v in edges])
    return [_walk([edges[i] for i in cycle]) for cycle in copy.minimum_cycle_basis()]


_BASES: dict[str, Callable[[nx.Graph], list[Cycle]]] = {
    "networkx": _networkx_basis,
    "igraph": _igraph_basis,
}


def _edges(cycle: Cycle) -> list[tuple[int, int]]:
    """Return the edges of a cycle, smaller node first."""
    pairs = zip(cycle, cycle[1:] + cycle[:1], strict=True)
    return [(min(pair), max(pair)) for pair in pairs]


def _walk(edges: list[Any]) -> Cycle:
    """Return the nodes of a set of edges that form one cycle, in cyclic order."""
    neighbours: dict[int, list[int]] = {}
    for u, v in edges:
        neighbours.setdefault(u, []).append(v)
        neighbours.setdefault(v, []).append(u)
    if not edges or any(len(around) != 2 for around in neighbours.values()):
        raise ArrangementError(f"{len(edges)} edges form no single cycle; is the rank 3?")
    cycle = [edges[0][0], edges[0][1]]
    while len(cycle) < len(neighbours):
        ahead = next(node for node in neighbours[cycle[-1]] if node != cycle[-2])
        if ahead == cycle[0]:
            raise ArrangementError("the edges form several cycles; is the rank 3?")
        cycle.append(ahead)
    return tuple(cycle)
