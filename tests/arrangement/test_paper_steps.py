"""The published enumeration does what its text says, and how that differs from the truth."""

from collections import Counter

import networkx as nx
import pytest
import sympy
from hypothesis import given, settings, strategies as st
from sympy.polys.matrices import DomainMatrix

from arrangement import Arrangement, InputError
from arrangement.enumeration.paper_steps import _cycles, published_enumeration

from .strategies import arrangements


def generic(m: int) -> Arrangement:
    return Arrangement([[1, t, t * t] for t in range(m)], dimension=3)


def true_states(planes: Arrangement) -> set[tuple[int, ...]]:
    return {face.signs for face in planes.faces()}


FOUR_CONTACTS = Arrangement([(0, 1, -1), (0, 1, -1), (0, -1, -1), (0, -1, -1)])


@pytest.mark.parametrize(("m", "states"), [(2, 10), (3, 26), (4, 50), (5, 82), (6, 122), (7, 170)])
def test_the_published_table_of_counts(m, states):
    """[HaasHeger2018], the table with the number of slip states for 2 to 9 contacts."""
    assert len(published_enumeration(generic(m)).states) == states


def test_two_planes_list_their_line_twice():
    found = published_enumeration(generic(2))
    assert found.lines == ((0, 0), (0, 0))
    assert (len(found.states), len(found.distinct_states)) == (10, 9)
    assert set(found.distinct_states) == true_states(generic(2))


def test_one_plane_has_an_edge_and_no_cycle():
    found = published_enumeration(generic(1))
    assert (found.regions, found.facets, found.lines) == (((1,), (-1,)), ((0,),), ())


def test_coincident_planes_leave_no_edges():
    found = published_enumeration(FOUR_CONTACTS)
    assert len(found.regions) == 4
    assert found.facets == found.lines == found.cycles == ()
    assert len(true_states(FOUR_CONTACTS)) == 9


def test_doubled_generic_plane_disconnects_the_graph():
    """The cube loses the four edges of one direction: two squares, and their sum is both."""
    planes = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-2, 0, 0]])
    found = published_enumeration(planes)
    assert [len(cycle) for cycle in found.cycles] == [4, 4, 8]
    assert Counter(found.lines[:2]) == Counter({(1, 0, 0, -1): 1, (-1, 0, 0, 1): 1})
    assert found.lines[2] in found.lines[:2]
    missing = true_states(planes) - set(found.states)
    assert missing == {signs for signs in true_states(planes) if signs[0] == 0}


@given(arrangements(dimensions=(3, 3), planes=(0, 6), central=True))
def test_merged_published_steps_miss_only_the_origin(planes):
    found = published_enumeration(planes, merge=True)
    truth = true_states(planes)
    if planes.rank == 3:
        assert len(found.states) == len(found.distinct_states)
        truth -= {(0,) * len(planes)}
    elif planes.rank == 2:
        assert len(found.states) == len(found.distinct_states) + 1
    assert set(found.states) == truth
    dimensions = {face.signs: face.dimension for face in planes.faces()}
    for part, dimension in ((found.regions, 3), (found.facets, 2), (found.lines, 1)):
        assert all(dimensions[signs] == dimension for signs in part)


@given(arrangements(dimensions=(3, 3), planes=(0, 6), central=True))
def test_edges_never_cross_coincident_planes(planes):
    found = published_enumeration(planes)
    assert set(found.regions) == {face.signs for face in planes.regions()}
    for _, _, crossed in found.graph.edges(data="planes"):
        assert len(crossed) == 1
        assert planes.distinct[planes.class_of[crossed[0]]] == crossed


@given(arrangements(dimensions=(3, 3), planes=(0, 6), central=True))
def test_cycles_are_closed_and_sum_to_nothing(planes):
    found = published_enumeration(planes, merge=True)
    total = Counter(edge for cycle in found.cycles for edge in cycle)
    assert all(times % 2 == 0 for times in total.values())
    for cycle in found.cycles:
        degrees = Counter(node for edge in cycle for node in edge)
        assert set(degrees.values()) == {2}
        assert all(found.graph.has_edge(*edge) for edge in cycle)
    assert [found.graph.nodes[k]["signs"] for k in found.graph] == list(found.regions)


@pytest.mark.parametrize(
    "planes", [Arrangement([[1, 0]]), Arrangement([[1, 0, 0]], [1]), Arrangement([[1, 0, 0, 0]])]
)
def test_only_central_planes_of_space_are_meant(planes):
    with pytest.raises(InputError, match="R\\^3"):
        published_enumeration(planes)


@given(arrangements(dimensions=(3, 3), planes=(0, 6), central=True))
def test_of_distinct_planes_all_faces_but_the_origin_are_listed(planes):
    """What a literal reading of the paper takes from here, without running the steps."""
    normals = [plane[:-1] for plane in planes.integer_planes]
    first = Arrangement([normals[members[0]] for members in planes.distinct], dimension=3)
    listed = {signs for signs in published_enumeration(first).states if any(signs)}
    assert listed == {signs for signs in true_states(first) if any(signs)}


@given(st.sets(st.tuples(st.integers(0, 8), st.integers(0, 8)), max_size=24))
@settings(max_examples=60)
def test_cycles_of_any_graph_are_a_minimum_basis_as_by_networkx(pairs):
    graph = nx.Graph([(a, b) for a, b in pairs if a != b])
    *basis, last = _cycles(graph) or ((),)
    assert sorted(map(len, basis)) == sorted(map(len, nx.minimum_cycle_basis(graph)))
    edges, total = sorted(map(tuple, map(sorted, graph.edges))), set()
    bits = [[sympy.GF(2)(int(edge in cycle)) for edge in edges] for cycle in basis]
    if basis:
        assert DomainMatrix(bits, (len(basis), len(edges)), sympy.GF(2)).rank() == len(basis)
    for cycle in basis:
        assert all(degree == 2 for _, degree in nx.Graph(cycle).degree)
        total ^= set(cycle)
    assert total == set(last)
