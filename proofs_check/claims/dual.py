"""Claims on the dual polyhedron: its graph, its bounds, its faces as a minimum cycle basis."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import lru_cache, partial

import networkx as nx

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.enumeration.paper_steps import published_enumeration
from arrangement.library.census.chirotopes import Signs
from arrangement.numbers.float_filter import Booleans
from proofs_check.instances.arrangements import (
    TYPES,
    census_cases,
    mixed_cases,
    smallest_arrangements,
    types_and_samples,
)
from proofs_check.routes.dual_graph import (
    DualGraph,
    distances,
    from_covectors,
    from_signs,
    is_sphere,
    is_three_connected,
    minimum_cycle_lengths,
)
from proofs_check.routes.many_types import cycle_bases_are_faces, f_vectors
from proofs_check.statements.statement import Case

from .stated import stated


def _edge_and_face_bounds(signs: Signs, n: int) -> Booleans:
    faces, edges, vertices = f_vectors(signs, n).T
    below: Booleans = (edges <= 3 * vertices - 6) & (faces <= 2 * vertices - 4)
    return below


def _bipartite_bounds(signs: Signs, n: int) -> Booleans:
    faces, edges, vertices = f_vectors(signs, n).T
    simple = (signs != 0).all(axis=1)
    most = ((edges == 2 * vertices - 4) == simple) & ((faces == vertices - 2) == simple)
    holds: Booleans = (edges <= 2 * vertices - 4) & (faces <= vertices - 2) & most
    return holds


@lru_cache(maxsize=256)
def _faces_graph(planes: Arrangement) -> DualGraph:
    return from_signs(*([face.signs for face in planes.faces(k)] for k in (3, 2, 1)))


_covector_graph = lru_cache(maxsize=256)(from_covectors)


def _vef(f: tuple[int, ...]) -> tuple[int, int, int]:
    """Regions, facets and lines: vertices, edges and faces of the dual."""
    return (f[3], f[2], f[1])


def _rank_three(rng: random.Random) -> Iterator[Case]:
    yield from census_cases(TYPES)
    yield from mixed_cases(rng, range(3, 13), per_count=4, rank=3)


def _planar_by_networkx(planes: Arrangement) -> tuple[bool, bool]:
    faces = _faces_graph(planes)
    numbers = {vertex: k for k, vertex in enumerate(faces.vertices)}
    graph = nx.Graph([[numbers[vertex] for vertex in edge] for edge in faces.edges])
    graph.add_nodes_from(numbers.values())
    planar, _ = nx.check_planarity(graph)
    return bool(planar), len(graph) > 3 and all(
        _biconnected_without(graph, vertex) for vertex in list(graph)
    )


def _biconnected_without(graph: nx.Graph, vertex: int) -> bool:
    near = list(graph[vertex])
    graph.remove_node(vertex)
    try:
        return bool(nx.is_biconnected(graph))
    finally:
        graph.add_edges_from((vertex, other) for other in near)


def _planar_by_sphere(planes: Arrangement) -> tuple[bool, bool]:
    """In rank 1 and 2 the graph is an edge or a cycle, which is planar."""
    graph = _covector_graph(planes)
    cycle_or_edge = all(len(near) <= 2 for near in graph.neighbours.values())
    return is_sphere(graph) or cycle_or_edge, is_three_connected(graph)


def _hamming(graph: DualGraph) -> tuple[int, int, bool]:
    """Facets; pairs of regions that differ in one sign; whether distances are Hamming distances."""
    below = {
        signs: sum(1 << k for k, sign in enumerate(signs) if sign < 0) for signs in graph.vertices
    }
    regions, most = set(below.values()), max(below.values()).bit_length()
    pairs = sum(region ^ 1 << k in regions for region in regions for k in range(most)) // 2
    isometric = all(
        length == (here ^ below[end]).bit_count()
        for start, here in below.items()
        for end, length in distances(graph, start).items()
    )
    return len(graph.edges), pairs, isometric


def _published_cycles(planes: Arrangement) -> tuple[tuple[int, ...], bool]:
    """Lengths in the basis that Step 3 finds, and whether its cycles are the face boundaries."""
    steps = published_enumeration(planes, merge=True)
    lines = sorted(steps.lines)
    true = sorted(face.signs for face in planes.faces(1))
    return tuple(sorted(map(len, steps.cycles[:-1]))), bool(lines) and lines == true


def _horton_cycles(planes: Arrangement) -> tuple[tuple[int, ...], bool]:
    """Return the same from covectors and Horton's algorithm.

    The basis consists of faces exactly when its total length is that of all faces but a longest
    one, its size is F - 1, and the faces have the cycle space as their span.
    """
    graph = _covector_graph(planes)
    lengths = minimum_cycle_lengths(graph)
    faces = sorted(map(len, graph.faces))
    return tuple(sorted(lengths)), len(faces) > 1 and lengths == tuple(faces[:-1])


def _has_rank_3(planes: Arrangement) -> bool:
    return planes.rank == 3


#: True of most planes; the smallest counterexample to the rest is looked for.
def _smallest() -> Iterator[Case]:
    return smallest_arrangements(range(1, 4), 1)


_saved = partial(stated, search=_smallest)
#: On V, E and F of the dual.
_of_vef = partial(
    stated,
    enumeration=lambda planes: _vef(planes.faces().f_vector),
    theorem=lambda planes: _vef(counts.f_vector(planes)),
)

CLAIMS = (
    _of_vef(
        "euler",
        search=_smallest,
        judge=lambda planes, vef: vef[0] - vef[1] + vef[2] == 2,
        cases=types_and_samples(10, per_count=4),
        covers=_has_rank_3,
    ),
    _of_vef(
        "dual-edge-and-face-bounds",
        search=_smallest,
        judge=lambda planes, vef: vef[1] <= 3 * vef[0] - 6 and vef[2] <= 2 * vef[0] - 4,
        many_types=_edge_and_face_bounds,
        cases=types_and_samples(10, per_count=4),
        covers=lambda planes: planes.rank >= 2,
    ),
    _of_vef(
        "dual-bipartite-bounds",
        judge=lambda planes, vef: (
            vef[1] <= 2 * vef[0] - 4
            and vef[2] <= vef[0] - 2
            and (vef[1] == 2 * vef[0] - 4) == planes.is_simple == (vef[2] == vef[0] - 2)
        ),
        many_types=_bipartite_bounds,
        cases=_rank_three,
    ),
    _saved(
        "dual-planar-3-connected",
        networkx=_planar_by_networkx,
        covectors=_planar_by_sphere,
        judge=lambda planes, value: value == (True, True),
        cases=types_and_samples(6),
        covers=_has_rank_3,
    ),
    _saved(
        "hamming-edges",
        faces=lambda planes: _hamming(_faces_graph(planes)),
        covectors=lambda planes: _hamming(_covector_graph(planes)),
        judge=lambda planes, value: value[0] == value[1] and value[2],
        cases=types_and_samples(6),
        covers=lambda planes: len(planes.distinct) == len(planes),
    ),
    _saved(
        "cycle-basis-faces",
        steps=_published_cycles,
        covectors=_horton_cycles,
        judge=lambda planes, value: value[1],
        many_types=cycle_bases_are_faces,
        cases=types_and_samples(6, counts=range(3, 7)),
        covers=_has_rank_3,
    ),
)
