"""Numbers of others: types of the census, regions of named arrangements, contact modes of boxes."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import combinations
from random import Random

import networkx as nx

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.library.census import PUBLISHED, PUBLISHED_SIMPLE, census
from arrangement.library.families.simplicial import printed_vectors, simplicial, simplicial_entries
from arrangement.library.published import PublishedCount, published_counts
from arrangement.numbers.exact import RationalVector, primitive
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.modes import ContactModes
from proofs_check.routes.contact_modes import mode_counts
from proofs_check.routes.dual_graph import DualGraph, Edge, Signs as RegionSigns, from_covectors
from proofs_check.statements.statement import Case

from .stated import stated


def _census_planes(m: int) -> Iterator[Arrangement]:
    """Yield new arrangements of the census that have rank 3 and m distinct planes."""
    for entry in census(m):
        fresh = Arrangement(entry.normals)
        if fresh.rank == 3 and len(fresh.distinct) == m:
            yield fresh


def _by_codes(m: int) -> tuple[int, int]:
    """All and simple types, distinguished by the smallest code of the dual map on the sphere."""
    codes = {}
    for planes in _census_planes(m):
        graph = from_covectors(planes)
        codes[_code(graph)] = all(len(face) == 4 for face in graph.faces)
    return len(codes), sum(codes.values())


def _by_isomorphism(m: int) -> tuple[int, int]:
    """Return the same, by tests for isomorphic graphs (networkx) among graphs of equal hash."""
    kept: dict[str, list[tuple[nx.Graph, bool]]] = {}
    for planes in _census_planes(m):
        graph = nx.Graph([tuple(edge) for edge in _adjacent(planes)])
        nx.set_node_attributes(graph, dict(graph.degree), "degree")
        text = nx.weisfeiler_lehman_graph_hash(graph, node_attr="degree", iterations=4)
        group = kept.setdefault(text, [])
        if not any(nx.is_isomorphic(graph, other) for other, _ in group):
            group.append((graph, planes.is_simple))
    kinds = [simple for group in kept.values() for _, simple in group]
    return len(kinds), sum(kinds)


def _adjacent(planes: Arrangement) -> Iterator[tuple[RegionSigns, RegionSigns]]:
    regions = [face.signs for face in planes.faces(3)]
    for one, other in combinations(regions, 2):
        if sum(a != b for a, b in zip(one, other, strict=True)) == 1:
            yield one, other


#: A vertex, an edge and a face of a map, each on the boundary of the next.
Flag = tuple[RegionSigns, Edge, int]


def _code(graph: DualGraph) -> tuple[int, ...]:
    """Return a text of a 3-connected planar graph: equal exactly for isomorphic ones.

    Such a graph has one embedding in the sphere up to reflection (Whitney). A flag has three
    neighbours, each with another vertex, edge or face. From one flag on, flags are numbered breadth
    first, and the numbers of all neighbours written down. The smallest text over all starts at
    vertices of the rarest kind is the code.
    """
    flags = _flags(graph)
    index = {flag: k for k, flag in enumerate(flags)}
    near = [[index[other] for other in others] for others in flags.values()]
    kinds = {v: _kind(graph, v) for v in graph.vertices}
    number = Counter(kinds.values())
    rarest = min(number, key=lambda kind: (number[kind], kind))
    return min(_walk(near, k) for (v, _, _), k in index.items() if kinds[v] == rarest)


def _kind(graph: DualGraph, vertex: RegionSigns) -> tuple[int, ...]:
    """Return the sizes of the faces around a vertex."""
    return tuple(sorted(len(f) for f in graph.faces if any(vertex in edge for edge in f)))


def _flags(graph: DualGraph) -> dict[Flag, tuple[Flag, Flag, Flag]]:
    """Return every flag with its three neighbours."""
    faces_of: dict[Edge, set[int]] = {edge: set() for edge in graph.edges}
    for k, face in enumerate(graph.faces):
        for edge in face:
            faces_of[edge].add(k)
    near_flags = {}
    for k, face in enumerate(graph.faces):
        for edge in face:
            (next_face,) = faces_of[edge] - {k}
            for v in edge:
                (vertex,) = edge - {v}
                (next_edge,) = (e for e in face if v in e and e != edge)
                near_flags[v, edge, k] = (
                    (vertex, edge, k),
                    (v, next_edge, k),
                    (v, edge, next_face),
                )
    return near_flags


def _walk(near: list[list[int]], start: int) -> tuple[int, ...]:
    """Return the code from one flag: for every flag in order the numbers of its neighbours."""
    number, queue = {start: 0}, [start]
    code: list[int] = []
    for here in queue:
        for there in near[here]:
            if there not in number:
                number[there] = len(number)
                queue.append(there)
            code.append(number[there])
    return tuple(code)


#: More regions take longer than a second.
_MOST_COUNTED = 10**6
#: More planes take longer than minutes.
_LARGEST = 256
_MOST_REGIONS = 2000
#: More regions are not enumerated: they take gigabytes.
_MOST_ENUMERATED = 3 * 10**6


@cache
def _entries() -> Mapping[Arrangement, PublishedCount]:
    """Return the entries by their planes; equal planes of two families have the same number."""
    made = ((entry.planes(), entry) for entry in published_counts())
    return {planes: entry for planes, entry in made if len(planes) <= _LARGEST}


def _in_print(planes: Arrangement) -> int:
    return _entries()[planes].regions


def _enumerate_regions(planes: Arrangement) -> int:
    return NotImplemented if _in_print(planes) > _MOST_ENUMERATED else len(planes.regions())


def _entries_with(least: int, most: float) -> Callable[[Random], Iterator[Case]]:
    """Return what yields the entries whose number is above `least` and at most `most`."""
    return lambda _: (
        Case(f"{entry.label}: {entry.source}", planes, planes.to_dict())
        for planes, entry in _entries().items()
        if least < entry.regions <= most
    )


#: The vectors t and r: how many vertices lie on k planes, and how many planes have k vertices.
_Vectors = tuple[dict[int, int], dict[int, int]]


@cache
def _catalogue() -> Mapping[Arrangement, tuple[int, int]]:
    return {simplicial(*entry): entry for entry in simplicial_entries()}


def _vectors(vertices: Iterable[Sequence[int]]) -> _Vectors:
    listed = list(vertices)
    on_planes = Counter(plane for vertex in listed for plane in vertex)
    return dict(Counter(map(len, listed))), dict(Counter(on_planes.values()))


def _by_lattice(planes: Arrangement) -> _Vectors:
    return _vectors(flat.planes for flat in counts.intersection_lattice(planes).flats[2])


def _by_great_circles(planes: Arrangement) -> _Vectors:
    incidence = planes.sphere().incidence
    if 3 * incidence.region_count != 2 * incidence.arc_count:
        return {}, {}  # not simplicial
    return _vectors(incidence.circles_at(v).tolist() for v in range(incidence.vertex_count // 2))


#: Walls at a box -> contacting-separating modes.
_BY_WALLS = {1: 10, 2: 46, 3: 136, 4: 10, 5: 2, 6: 1}


@dataclass(frozen=True)
class _Touching:
    """Rigid contacts, and how many modes are said to be."""

    modes: ContactModes
    said: int


def _wrenches_turned(
    pair: tuple[RationalVector, ...], x: int, y: int
) -> tuple[RationalVector, ...]:
    """Return tangents turned by the angle of (x, y), of another length."""
    first, second = pair
    return (
        tuple(x * a + y * b for a, b in zip(first, second, strict=True)),
        tuple(x * b - y * a for a, b in zip(first, second, strict=True)),
    )


def _turned_modes(turns: Callable[[int], tuple[int, int]]) -> ContactModes:
    box = read_grasp("box-1-wall")
    rows = [_wrenches_turned(c.tangential_wrenches, *turns(i)) for i, c in enumerate(box)]
    straight = ContactModes.of_grasp(box)
    turned = tuple(tuple(primitive(row) for row in pair) for pair in rows)
    return ContactModes(straight.normals, turned, straight.n)


def _modes_case(label: str, modes: ContactModes, expected: int) -> Case:
    document = {"normals": modes.normals, "tangents": modes.tangents}
    return Case(label, _Touching(modes, expected), document)


def _walls(rng: Random) -> Iterator[Case]:
    for walls, expected in _BY_WALLS.items():
        modes = ContactModes.of_grasp(read_grasp(f"box-{walls}-wall{'s' * (walls > 1)}"))
        yield _modes_case(counted(walls, "wall"), modes, expected)


def _tangents(rng: Random) -> Iterator[Case]:
    apart = ((5, 2), (7, 1), (3, 1), (13, 8))
    for text, expected, turns in (
        ("along the edges", 196, lambda i: (1, 0)),
        ("turned by 45 degrees", 340, lambda i: (1, 1)),
        ("turned by the angle of 3-4-5", 404, lambda i: (4, 3)),
        ("turned differently at each contact", 468, lambda i: apart[i]),
    ):
        yield _modes_case(text, _turned_modes(turns), expected)


def _modes_counted(place: int) -> Callable[[_Touching], int]:
    return lambda t: mode_counts(t.modes.normals, t.modes.tangents, t.modes.n)[place]


_in_print_claim = partial(stated, judge=lambda planes, regions: regions == _in_print(planes))
_modes_claim = partial(stated, judge=lambda t, number: number == t.said)

CLAIMS = (
    stated(
        "census-types",
        codes=_by_codes,
        isomorphism=_by_isomorphism,
        judge=lambda m, numbers: (
            numbers == (PUBLISHED[m], PUBLISHED_SIMPLE[m]) and len(census(m)) == numbers[0]
        ),
        cases=lambda _: (Case(f"m = {m}", m, {"planes_count": m}) for m in range(3, 8)),
    ),
    stated(
        "simplicial-catalogue",
        lattice=_by_lattice,
        circles=_by_great_circles,
        judge=lambda planes, vectors: vectors == printed_vectors(*_catalogue()[planes]),
        cases=lambda _: (
            Case(f"A{entry}", planes, planes.to_dict()) for planes, entry in _catalogue().items()
        ),
    ),
    _in_print_claim(
        "regions-in-print",
        chi=counts.region_count,
        enumeration=_enumerate_regions,
        cases=_entries_with(0, _MOST_COUNTED),
    ),
    _in_print_claim(
        "small-regions-in-print",
        chi=counts.region_count,
        enumeration=_enumerate_regions,
        cases=_entries_with(0, _MOST_REGIONS),
    ),
    _in_print_claim(
        "large-regions-in-print",
        chi=counts.region_count,
        enumeration=_enumerate_regions,
        cases=_entries_with(_MOST_COUNTED, math.inf),
    ),
    _modes_claim(
        "contacting-modes-of-a-box",
        faces=lambda t: len(t.modes.contacting_separating),
        generators=_modes_counted(0),
        cases=_walls,
    ),
    _modes_claim(
        "sliding-modes-depend-on-tangents",
        faces=lambda t: t.modes.sliding_sticking_count,
        theorem=_modes_counted(1),
        cases=_tangents,
    ),
)
