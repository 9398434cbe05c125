"""The dual graph: both builders agree, and the graph functions agree with networkx."""

from random import Random

import networkx as nx
import pytest
from hypothesis import given, settings, strategies as st

from arrangement.arrangement import Arrangement
from proofs_check.instances.arrangements import mixed_cases, random_arrangement
from proofs_check.routes.dual_graph import (
    DualGraph,
    from_covectors,
    from_signs,
    is_sphere,
    is_three_connected,
    minimum_cycle_lengths,
)


def from_faces(planes: Arrangement) -> DualGraph:
    return from_signs(*([face.signs for face in planes.faces(k)] for k in (3, 2, 1)))


SMALL = [case.subject for case in mixed_cases(Random(5), range(1, 6), per_count=3)]


def as_networkx(graph: DualGraph) -> nx.Graph:
    found = nx.Graph()
    found.add_nodes_from(graph.vertices)
    found.add_edges_from(tuple(edge) for edge in graph.edges)
    return found


@pytest.mark.parametrize("planes", SMALL, ids=repr)
def test_both_builders_agree(planes):
    one, other = from_faces(planes), from_covectors(planes)
    assert one.vertices == other.vertices
    assert one.edges == other.edges
    assert sorted(map(sorted, (map(sorted, f) for f in one.faces))) == sorted(
        map(sorted, (map(sorted, f) for f in other.faces))
    )


@pytest.mark.parametrize("planes", SMALL, ids=repr)
def test_graph_functions_agree_with_networkx(planes):
    graph = from_faces(planes)
    peer = as_networkx(graph)
    connected = len(peer) > 3 and nx.node_connectivity(peer) >= 3
    assert is_three_connected(graph) == connected
    lengths = sorted(map(len, nx.minimum_cycle_basis(peer)))
    assert list(minimum_cycle_lengths(graph)) == lengths


@given(st.integers(1, 8), st.sets(st.tuples(st.integers(0, 7), st.integers(0, 7)), max_size=24))
@settings(max_examples=60)
def test_three_connectedness_of_any_graph_agrees_with_networkx(count, pairs):
    kept = {frozenset([(a,), (b,)]) for a, b in pairs if a != b and max(a, b) < count}
    graph = DualGraph(frozenset((v,) for v in range(count)), frozenset(kept), ())
    expected = count > 3 and nx.node_connectivity(as_networkx(graph)) >= 3
    assert is_three_connected(graph) == expected


@pytest.mark.parametrize("planes", SMALL, ids=repr)
def test_the_faces_close_to_a_sphere_exactly_in_rank_three(planes):
    assert is_sphere(from_faces(planes)) == (planes.rank == 3)


def test_a_sphere_with_a_face_left_out_is_none():
    graph = from_faces(random_arrangement(Random(1), 4))
    assert is_sphere(graph)
    assert not is_sphere(DualGraph(graph.vertices, graph.edges, graph.faces[1:]))
