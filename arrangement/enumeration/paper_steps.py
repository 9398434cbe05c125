"""The enumeration of slip states as published, for comparison only.

[HaasHeger2018] describes it in the section "Slip state enumeration": Algorithm 1 builds the
regions plane by plane, Step 2 joins regions that differ in one sign, Step 3 takes a minimum cycle
basis of that graph and its symmetric sum for the faces of the dual polyhedron. Use
`Arrangement.faces` for the true list; this module keeps what the text says, its limits included:

* The origin, where every contact sticks, is listed only when some line lies in all planes.
* In rank 2 the graph is one cycle. It is its own symmetric sum, so its state is listed twice: two
  planes give 10 states, 9 of them different (the published table has 10).
* One plane gives one edge and no cycle. The last face is the empty sum, from which no state can
  be read, so its two regions and one facet are all.
* Coincident planes change sign together. No edge of Step 2 crosses them, and the states on them
  are missing, unless they are merged first.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, reduce
from itertools import combinations
from operator import xor
from typing import TYPE_CHECKING, TypeAlias

from arrangement.console.number_form import ReprMixin
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, sign
from arrangement.numbers.linear.programs import some_point
from arrangement.planes.planes import Planes

if TYPE_CHECKING:
    import networkx as nx

SignVector: TypeAlias = tuple[int, ...]
#: A set of edges (j, k) with j < k, indices of regions, in increasing order.
Cycle: TypeAlias = tuple[tuple[int, int], ...]


@dataclass(frozen=True, repr=False)
class PublishedEnumeration(ReprMixin):
    """What Steps 1 to 3 as published give for one arrangement.

    Sign vectors run over the input planes, in input order.

    Attributes:
        regions: Step 1, one sign vector for each region.
        facets: Step 2, one sign vector for each edge of the graph.
        lines: Step 3, one sign vector for each cycle, repeats kept.
        cycles: the minimum cycle basis, then its symmetric sum, as edges between region indices.
        graph: the graph of Step 2 (networkx, frozen), on region indices, with node attribute
            "signs" and edge attribute "planes" (the input planes that the edge crosses).
    """

    regions: tuple[SignVector, ...]
    facets: tuple[SignVector, ...]
    lines: tuple[SignVector, ...]
    cycles: tuple[Cycle, ...]
    graph: nx.Graph = field(repr=False, compare=False)

    @property
    def states(self) -> tuple[SignVector, ...]:
        """Regions, facets and lines one after the other, counted as the paper counts."""
        return self.regions + self.facets + self.lines

    @cached_property
    def distinct_states(self) -> tuple[SignVector, ...]:
        """The states without repeats, in order of first appearance."""
        return tuple(dict.fromkeys(self.states))


def published_enumeration(arrangement: Planes, merge: bool = False) -> PublishedEnumeration:
    """Run Steps 1 to 3 of the published enumeration, each decision exact.

    Args:
        arrangement: central, in R^3 (the space of planar motions).
        merge: replace coincident planes by one before Step 1; their signs are filled in
            afterwards. Without it the text is followed to the letter.

    Raises:
        InputError: an affine arrangement, or a dimension other than three.

    Complexity: with V regions and E edges, Step 1 solves at most V small linear programs for each
    plane; Step 2 compares all pairs of regions; Step 3 searches a shortest cycle E - V + 1 times
    from at most V regions. That is the sixth power of the number of planes at worst; measured, the
    time of all steps grows less than the fifth.

    Source: [HaasHeger2018], "Slip state enumeration", Steps 1 to 3 and Algorithm 1.

    >>> from arrangement import Arrangement
    >>> two = published_enumeration(Arrangement([[1, 0, 0], [0, 1, 0]]))
    >>> len(two.states), len(two.distinct_states)
    (10, 9)
    """
    if arrangement.dimension != 3 or not arrangement.is_central:
        raise InputError(
            f"{arrangement!r}: the published enumeration is stated for planes through the origin "
            "of R^3; use Arrangement.faces() otherwise"
        )
    planes = [plane[:-1] for plane in arrangement.integer_planes]
    ask_steps(len(planes))
    classes = arrangement.distinct if merge else tuple((i,) for i in range(len(planes)))
    regions = _regions([planes[members[0]] for members in classes])
    graph = _graph(regions)
    cycles = _cycles(graph)
    lines = [_line(regions, graph, cycle) for cycle in cycles]
    facets = [_on_planes(regions[k], {plane}) for k, _, plane in graph.edges(data="plane")]

    def filled(signs: SignVector) -> SignVector:
        return arrangement.over_planes(signs) if merge else signs

    return PublishedEnumeration(
        regions=tuple(filled(signs) for signs in regions),
        facets=tuple(filled(signs) for signs in facets),
        lines=tuple(filled(signs) for signs in lines),
        cycles=cycles,
        graph=_describe(graph, [filled(signs) for signs in regions], classes),
    )


def ask_steps(planes: int) -> None:
    """Refuse the steps for this many planes where they would take long."""
    budget.check_cost(
        f"the published enumeration of {planes} planes",
        "list their faces",
        steps=15 * planes**5,
    )


def _regions(planes: list[IntegerVector]) -> list[SignVector]:
    """Step 1, Algorithm 1: split every region by one plane after the other."""
    regions: dict[SignVector, RationalVector] = {(): (Fraction(0),) * 3}
    for i, plane in enumerate(planes):
        split: dict[SignVector, RationalVector] = {}
        for signs, inside in regions.items():
            side = sign(dot(plane, inside))
            for s in (1, -1):
                point = inside if s == side else _point_inside((*signs, s), planes[: i + 1])
                if point is not None:
                    split[*signs, s] = point
        regions = split
    return list(regions)


def _point_inside(signs: SignVector, planes: list[IntegerVector]) -> RationalVector | None:
    """Return a point strictly on the given sides of central planes in R^3, or None.

    A cone ``s_i n_i . x > 0`` is nonempty exactly when ``s_i n_i . x >= 1`` can be solved.
    """
    rows = [[*(s * x for x in plane), -1] for s, plane in zip(signs, planes, strict=False)]
    return some_point(3, rows)


def _graph(regions: list[SignVector]) -> nx.Graph:
    """Step 2: join every two regions that differ in a single sign."""
    import networkx as nx

    graph = nx.Graph()
    graph.add_nodes_from(range(len(regions)))
    for (j, one), (k, other) in combinations(enumerate(regions), 2):
        differing = [i for i, (a, b) in enumerate(zip(one, other, strict=True)) if a != b]
        if len(differing) == 1:
            graph.add_edge(j, k, plane=differing[0])
    return graph


def _cycles(graph: nx.Graph) -> tuple[Cycle, ...]:
    """Step 3, first half: a minimum cycle basis, and the symmetric sum of its cycles."""
    edges = [(min(edge), max(edge)) for edge in graph.edges]
    basis = _minimum_cycle_basis(graph, edges)
    if not basis:
        return ()
    return tuple(
        tuple(sorted(edge for k, edge in enumerate(edges) if cycle >> k & 1))
        for cycle in (*basis, reduce(xor, basis))
    )


def _minimum_cycle_basis(graph: nx.Graph, edges: list[tuple[int, int]]) -> list[int]:
    """Return the cycles of a minimum basis as numbers with a bit for each edge.

    Each cycle is a shortest one of those that meet a set of edges, its witness, an odd number of
    times; the later witnesses are made to meet it an even number of times. The first witnesses are
    the edges outside of a spanning forest.

    Source: J. de Pina, Applications of shortest path methods (PhD thesis, Amsterdam 1995); see
    [MehlhornMichail2005].
    """
    import networkx as nx

    near: dict[int, list[tuple[int, int]]] = {v: [] for v in graph}
    for k, (u, v) in enumerate(edges):
        near[u].append((v, 1 << k))
        near[v].append((u, 1 << k))
    forest = {(min(e), max(e)) for e in nx.minimum_spanning_edges(graph, data=False)}
    witnesses = [1 << k for k, edge in enumerate(edges) if edge not in forest]
    basis = []
    while witnesses:
        witness = witnesses.pop()
        # An odd cycle passes through an edge of the witness.
        starts = {u for k, (u, _) in enumerate(edges) if witness >> k & 1}
        cycle = _shortest_odd_cycle(near, witness, starts)
        basis.append(cycle)
        witnesses = [x ^ witness if (x & cycle).bit_count() % 2 else x for x in witnesses]
    return basis


def _shortest_odd_cycle(
    near: dict[int, list[tuple[int, int]]], witness: int, starts: set[int]
) -> int:
    """Return a shortest cycle through one of some vertices with an odd number of witness edges.

    Breadth first from a vertex to itself, where each vertex stands twice: reached by an even, and
    by an odd number of edges of the witness.
    """
    best, length = 0, math.inf
    for start in starts:
        ways, level, steps = {(start, False): 0}, [(start, False)], 0
        while level and (start, True) not in ways and steps + 1 < length:
            steps += 1
            ahead = []
            for here, odd in level:
                for there, bit in near[here]:
                    place = (there, odd != bool(bit & witness))
                    if place not in ways:
                        ways[place] = ways[here, odd] ^ bit
                        ahead.append(place)
            level = ahead
        if (start, True) in ways:
            best, length = ways[start, True], steps
    return best


def _line(regions: list[SignVector], graph: nx.Graph, cycle: Cycle) -> SignVector:
    """Step 3, second half: start at a region of the cycle, let every crossed plane stick."""
    return _on_planes(regions[cycle[0][0]], {graph.edges[edge]["plane"] for edge in cycle})


def _on_planes(signs: SignVector, zero: set[int]) -> SignVector:
    return tuple(0 if i in zero else s for i, s in enumerate(signs))


def _describe(
    graph: nx.Graph, signs: list[SignVector], classes: tuple[tuple[int, ...], ...]
) -> nx.Graph:
    """Return a frozen copy of the graph with the attributes that readers expect."""
    import networkx as nx

    described = nx.Graph()
    described.add_nodes_from((k, {"signs": vector}) for k, vector in enumerate(signs))
    described.add_edges_from(
        (j, k, {"planes": classes[plane]}) for j, k, plane in graph.edges(data="plane")
    )
    return nx.freeze(described)
