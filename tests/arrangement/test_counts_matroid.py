"""Circuits, bases, duals, minors and modular chains, against ranks, graphs and roots."""

from itertools import combinations, pairwise

import networkx as nx
import pytest
import sympy
from hypothesis import assume, given, strategies as st

from arrangement import Arrangement, InputError, counts, families

from . import oracle
from .oracle import T
from .strategies import arrangements

CENTRAL = arrangements(dimensions=(1, 4), planes=(0, 6), central=True)


@given(CENTRAL)
def test_bases_have_the_full_rank(planes):
    sets = combinations(range(len(planes)), planes.rank)
    full = [s for s in sets if oracle.rank([planes.normals[i] for i in s]) == planes.rank]
    assert counts.bases(planes) == tuple(full)


@given(CENTRAL)
def test_circuits_are_the_signs_of_smallest_dependencies(planes):
    found = set()
    for size in range(1, len(planes) + 1):
        for chosen in combinations(range(len(planes)), size):
            rows = sympy.Matrix([planes.normals[i] for i in chosen])
            kernel = rows.T.nullspace()
            if len(kernel) == 1 and all(kernel[0]):
                vector = [0] * len(planes)
                for plane, value in zip(chosen, kernel[0], strict=True):
                    vector[plane] = int(sympy.sign(value))
                found |= {tuple(vector), tuple(-x for x in vector)}
    assert counts.circuits(planes) == found


@given(CENTRAL)
def test_the_dual_has_the_circuits_as_cocircuits(planes):
    dual = counts.dual_chirotope(planes)
    m = len(planes)
    corank = m - planes.rank
    assume(corank)
    found = set()
    for chosen in combinations(range(m), corank - 1):
        vector = [0] * m
        for plane in set(range(m)) - set(chosen):
            passed = sum(other > plane for other in chosen)
            vector[plane] = (-1) ** passed * dual[tuple(sorted((*chosen, plane)))]
        if any(vector):
            found |= {tuple(vector), tuple(-x for x in vector)}
    assert found == counts.circuits(planes)


@given(arrangements(dimensions=(1, 3), planes=(1, 5)))
def test_circuits_and_cocircuits_are_orthogonal(planes):
    for circuit in counts.circuits(planes):
        for cocircuit in counts.cocircuits(planes):
            products = {a * b for a, b in zip(circuit, cocircuit, strict=True)} - {0}
            assert products in (set(), {1, -1})


def graphs(draw_edges: set[int], n: int) -> nx.Graph:
    graph = nx.empty_graph(n)
    graph.add_edges_from(
        pair for i, pair in enumerate(combinations(range(n), 2)) if i in draw_edges
    )
    return graph


@given(st.sets(st.integers(0, 14)))
def test_graphs_are_supersolvable_when_chordal(edges):
    graph = graphs(edges, 6)
    chain = counts.modular_chain(families.graphical(graph))
    assert (chain is not None) == nx.is_chordal(graph)


@given(CENTRAL)
def test_a_modular_chain_is_modular_and_gives_the_roots(planes):
    chain = counts.modular_chain(planes)
    exponents = counts.exponents(planes)
    assert (chain is None) == (exponents is None)
    if chain is None or exponents is None:
        return
    assert [flat.rank for flat in chain] == list(range(planes.rank + 1))
    product = T ** (planes.dimension - planes.rank) * sympy.prod(T - e for e in exponents)
    assert counts.characteristic_polynomial(planes) == sympy.Poly(product, T, domain=sympy.ZZ)
    lattice = counts.intersection_lattice(planes)
    for low, high in pairwise(chain):
        assert set(low.planes) < set(high.planes)
    for flat in chain:
        for level in lattice.flats:
            for other in level:
                join = oracle.rank([planes.normals[i] for i in {*flat.planes, *other.planes}])
                common = [planes.normals[i] for i in set(flat.planes) & set(other.planes)]
                assert flat.rank + other.rank == join + oracle.rank(common)


def is_supersolvable(planes: Arrangement) -> bool:
    """By definition: some chain of flats that are modular beside every flat."""
    flats = [
        (frozenset(flat.planes), flat.rank)
        for level in counts.intersection_lattice(planes).flats
        for flat in level
    ]

    def rank(chosen: frozenset[int]) -> int:
        return oracle.rank([planes.normals[i] for i in chosen])

    modular = [
        (one, k)
        for one, k in flats
        if all(k + j == rank(one | two) + rank(one & two) for two, j in flats)
    ]
    ends = {one for one, k in modular if k == 0}
    for level in range(1, planes.rank + 1):
        ends = {one for one, k in modular if k == level and any(low < one for low in ends)}
    return bool(ends)


@pytest.mark.campaign
@given(CENTRAL)
def test_no_chain_is_missed(planes):
    assert (counts.modular_chain(planes) is not None) == is_supersolvable(planes)


def test_known_chains():
    """Reflection arrangements of types A and B are supersolvable, D4 is not though chi factors."""
    assert sorted(counts.exponents(families.braid(5)) or ()) == [1, 2, 3, 4]
    assert sorted(counts.exponents(families.type_b(4)) or ()) == [1, 3, 5, 7]
    assert counts.exponents(families.type_d(4)) is None
    assert counts.exponents(Arrangement([], dimension=3)) == ()
    with pytest.raises(InputError, match="cone"):
        counts.modular_chain(families.shi(3))
    with pytest.raises(InputError, match="cone"):
        counts.dual_chirotope(families.shi(3))
