"""Light cutsets of a plane graph: what the search for Rivin weights adds to its program."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence
from typing import TypeAlias

import networkx as nx

from .certificates import Edge, PolyhedralGraph

Side: TypeAlias = frozenset[int]


class DualDistances:
    """Light cutsets of a plane graph, as short cycles of its dual.

    A minimal cutset of a plane graph is a cycle of its dual graph. A cycle through the dual of
    edge uv is no vertex star exactly if it leaves out another edge at u and another one at v. So
    the lightest cutset through uv is a shortest path between the two faces of uv, with uv and
    these two edges closed, for every choice of the two.
    """

    def __init__(self, graph: PolyhedralGraph) -> None:
        self.graph = graph
        self.index = {edge: e for e, edge in enumerate(graph.edges)}
        _, embedding = nx.check_planarity(graph.to_networkx())
        face_of: dict[Edge, int] = {}
        seen: set[Edge] = set()
        for half_edge in embedding.edges:
            if half_edge not in seen:
                face = embedding.traverse_face(*half_edge, mark_half_edges=seen)
                steps = zip(face, face[1:] + face[:1], strict=True)
                face_of.update(dict.fromkeys(steps, len(face_of)))
        self.sides = [(face_of[u, v], face_of[v, u]) for u, v in graph.edges]
        self.across: dict[int, list[tuple[int, int]]] = {}
        for e, (left, right) in enumerate(self.sides):
            self.across.setdefault(left, []).append((e, right))
            self.across.setdefault(right, []).append((e, left))

    def light_cuts(self, weights: Sequence[float], bound: float) -> Iterator[Side]:
        """Yield cutsets of condition 3 that weigh less than the bound (weights >= 0)."""
        lengths = [max(float(w), 0.0) for w in weights]
        for e, (u, v) in enumerate(self.graph.edges):
            for at_u in self._others(u, v):
                for at_v in self._others(v, u):
                    path = self._path(e, {e, at_u, at_v}, lengths, bound - lengths[e])
                    if path:
                        yield self._side(u, {e, *path})

    def _others(self, u: int, v: int) -> list[int]:
        return [self.index[min(u, x), max(u, x)] for x in self.graph.neighbours[u] if x != v]

    def _path(self, e: int, closed: set[int], lengths: list[float], bound: float) -> list[int]:
        """Return the edges crossed by a shortest way round edge e, if shorter than the bound."""
        start, goal = self.sides[e]
        queue: list[tuple[float, int, int, int]] = [(0.0, start, -1, -1)]
        reached: dict[int, tuple[int, int]] = {}
        while queue:
            distance, face, crossed, before = heapq.heappop(queue)
            if face in reached:
                continue
            reached[face] = (crossed, before)
            if face == goal:
                return self._trace(reached, goal)
            for edge, beyond in self.across[face]:
                if edge not in closed and beyond not in reached:
                    total = distance + lengths[edge]
                    if total < bound:
                        heapq.heappush(queue, (total, beyond, edge, face))
        return []

    def _trace(self, reached: dict[int, tuple[int, int]], face: int) -> list[int]:
        path = []
        while reached[face][0] >= 0:
            crossed, face = reached[face]
            path.append(crossed)
        return path

    def _side(self, start: int, cut: set[int]) -> Side:
        """Return the vertices that `start` reaches without crossing the cutset, or the others.

        The side without vertex 0 stands for both.
        """
        part, stack = {start}, [start]
        while stack:
            u = stack.pop()
            for v in self.graph.neighbours[u]:
                if v not in part and self.index[min(u, v), max(u, v)] not in cut:
                    part.add(v)
                    stack.append(v)
        return frozenset(range(self.graph.vertex_count)) - part if 0 in part else frozenset(part)
