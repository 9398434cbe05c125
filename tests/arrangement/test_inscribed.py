"""Inscribability: known graphs, an oracle with all cutsets, changed certificates refused."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.spatial import ConvexHull

from arrangement import Arrangement, ArrangementError, InputError, dual_polyhedron, inscribability
from arrangement.duals.inscribed import (
    FarkasCertificate,
    IndependentSetCertificate,
    PolyhedralGraph,
    WeightCertificate,
    decide,
)
from arrangement.library.families import generic, near_pencil, simplicial, type_b
from arrangement.numbers.linear.programs import Optimal, minimize

from .test_dual import A3, CUBE_DIAGONALS, SQUARE_AXES, rank_three, rank_three_only


def polyhedral(graph: nx.Graph) -> PolyhedralGraph:
    relabelled = nx.convert_node_labels_to_integers(graph)
    return PolyhedralGraph.of(len(relabelled), relabelled.edges)


def truncated_cube() -> nx.Graph:
    """The cube with one corner cut off: vertex 0 becomes a triangle."""
    graph = nx.convert_node_labels_to_integers(nx.hypercube_graph(3))
    around = list(graph[0])
    graph.remove_node(0)
    corners = ["a", "b", "c"]
    graph.add_edges_from(combinations(corners, 2))
    graph.add_edges_from(zip(corners, around, strict=True))
    return graph


def kleetope(graph: nx.Graph) -> nx.Graph:
    """A pyramid on every face of a triangulated sphere."""
    planar, embedding = nx.check_planarity(graph)
    assert planar
    seen: set[Any] = set()
    faces = [embedding.traverse_face(u, v, seen) for u, v in embedding.edges if (u, v) not in seen]
    result = graph.copy()
    result.add_edges_from((("face", k), v) for k, face in enumerate(faces) for v in face)
    return result


def rhombic_dodecahedron() -> nx.Graph:
    return dual_polyhedron(Arrangement(CUBE_DIAGONALS)).graph()


# Yes: regular and Archimedean solids and pyramids have a circumsphere.
# No: Steinitz' examples (Gruenbaum, Convex polytopes, section 13.5) by an independent set with more
# than half of the vertices. The cut cube: the 7 old vertices are 3 + 4, so the three edges at
# the new triangle weigh 4 - 3 = 1, not more.
KNOWN = {
    "tetrahedron": (nx.tetrahedral_graph(), True),
    "octahedron": (nx.octahedral_graph(), True),
    "cube": (nx.hypercube_graph(3), True),
    "dodecahedron": (nx.dodecahedral_graph(), True),
    "icosahedron": (nx.icosahedral_graph(), True),
    "truncated tetrahedron": (nx.truncated_tetrahedron_graph(), True),
    "triangular prism": (nx.circular_ladder_graph(3), True),
    "pyramid": (nx.wheel_graph(6), True),
    "triakis octahedron": (kleetope(nx.octahedral_graph()), False),
    "pentakis dodecahedron's relative": (kleetope(nx.icosahedral_graph()), False),
    "rhombic dodecahedron": (rhombic_dodecahedron(), False),
    "cube with a corner cut": (truncated_cube(), False),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_graphs(name):
    graph, expected = KNOWN[name]
    certificate = decide(polyhedral(graph))
    certificate.verify()
    assert certificate.inscribable is expected


def all_cutsets(graph: PolyhedralGraph) -> Iterator[set[int]]:
    """Yield one side of every minimal cutset that is no vertex star, by listing all sets."""
    network = graph.to_networkx()
    others = range(1, graph.vertex_count)
    for size in range(2, graph.vertex_count - 1):
        for chosen in combinations(others, size):
            rest = set(network) - set(chosen)
            if nx.is_connected(network.subgraph(chosen)) and nx.is_connected(
                network.subgraph(rest)
            ):
                yield set(chosen)


def largest_margin(graph: PolyhedralGraph) -> Fraction:
    """Maximise t in Rivin's conditions with slack t, exactly, with all cutsets written out."""
    edges = graph.edges
    rows: list[list[Any]] = [[0] * len(edges) + [-1, 1]]
    for e in range(len(edges)):
        unit = [int(k == e) for k in range(len(edges))]
        rows += [[*unit, -1, 0], [*(-x for x in unit), -1, Fraction(1, 2)]]
    rows += [[*(int((u in s) != (v in s)) for u, v in edges), -1, -1] for s in all_cutsets(graph)]
    sums = [[*(int(v in edge) for edge in edges), 0, -1] for v in range(graph.vertex_count)]
    answer = minimize([0] * len(edges) + [-1], rows, sums)
    return -answer.value if isinstance(answer, Optimal) else Fraction(-1)


@st.composite
def polyhedral_graphs(draw: st.DrawFn) -> PolyhedralGraph:
    """Draw a small polyhedral graph: a triangulated sphere or its dual, some edges left out."""
    seed = draw(st.integers(0, 10**6))
    source = np.random.default_rng(seed)
    directions = source.normal(size=(draw(st.integers(4, 7)), 3))
    simplices = ConvexHull(directions / np.linalg.norm(directions, axis=1)[:, None]).simplices
    graph = nx.Graph([pair for s in simplices.tolist() for pair in combinations(s, 2)])
    if draw(st.booleans()) and len(simplices) <= 8:
        pairs = combinations(range(len(simplices)), 2)
        graph = nx.Graph([(i, j) for i, j in pairs if len({*simplices[i]} & {*simplices[j]}) == 2])
    for edge in draw(st.lists(st.sampled_from(sorted(graph.edges)), max_size=6)):
        smaller = graph.copy()
        smaller.remove_edges_from([edge])
        if nx.node_connectivity(smaller) >= 3:
            graph = smaller
    return polyhedral(graph)


@given(polyhedral_graphs())
def test_answers_agree_with_all_cutsets_written_out(graph):
    assert decide(graph).inscribable == (largest_margin(graph) > 0)


@settings(max_examples=12)
@given(rank_three)
def test_every_answer_about_an_arrangement_verifies(planes):
    answer = inscribability(rank_three_only(planes))
    answer.verify()
    assert bool(answer) is answer.inscribable


def test_three_four_and_five_generic_planes():
    kinds = [inscribability(generic(m)).certificate.kind for m in (3, 4, 5)]
    assert kinds == ["weights", "parity", "Farkas"]


def test_six_planes_in_general_position_may_pass_or_not():
    passing = Arrangement([*SQUARE_AXES, [1, -1, 1], [-1, 3, -2], [-2, 1, 1]])
    assert passing.is_simple
    assert generic(6).is_simple
    for planes, expected in ((passing, True), (generic(6), False)):
        answer = inscribability(planes)
        answer.verify()
        assert answer.inscribable is expected


SIMPLICIAL = {
    "A3": Arrangement(A3),
    "B3": type_b(3),
    **{f"near-pencil {m}": near_pencil(m) for m in range(4, 9)},
    **{f"A{entry}": simplicial(*entry) for entry in ((6, 1), (7, 1), (8, 1), (10, 2), (13, 3))},
}


@pytest.mark.parametrize("name", SIMPLICIAL)
def test_equal_weights_inscribe_every_simplicial_arrangement(name):
    """Three edges at each vertex and no cutset of three edges but the stars: 1/3 everywhere.

    Three regions' borders that close up around more than one ray would be a triangle of arcs, and
    a circle that enters it must leave it through a side.
    """
    answer = inscribability(SIMPLICIAL[name])
    answer.verify()
    graph = answer.certificate.graph
    WeightCertificate(graph, (Fraction(1, 3),) * len(graph.edges)).verify()


@pytest.mark.parametrize(
    "graph",
    [
        nx.complete_graph(5),
        nx.complete_bipartite_graph(3, 3),
        nx.cycle_graph(5),
        nx.path_graph(3),
        nx.complete_bipartite_graph(2, 5),
        nx.disjoint_union(nx.complete_graph(4), nx.complete_graph(4)),
    ],
)
def test_graphs_of_no_polyhedron_are_refused(graph):
    with pytest.raises(ArrangementError):
        decide(polyhedral(graph))


def test_graphs_must_be_simple():
    for edges in ([(0, 0)], [(0, 1), (1, 0)], [(0, 7)], [(-1, 0)]):
        with pytest.raises(InputError):
            PolyhedralGraph.of(4, edges)


def test_an_answer_about_other_regions_is_refused():
    answer = inscribability(Arrangement(A3))
    other = inscribability(type_b(3))
    doubled = (answer.points[1], *answer.points[1:])
    exchanged = (answer.points[1], answer.points[0], *answer.points[2:])
    on_a_plane = ((Fraction(1), Fraction(1), Fraction(0)), *answer.points[1:])
    for wrong in (
        replace(answer, points=answer.points[1:]),
        replace(answer, points=doubled),
        replace(answer, points=exchanged),
        replace(answer, points=on_a_plane),
        replace(answer, certificate=other.certificate),
        replace(answer, arrangement=type_b(3)),
    ):
        with pytest.raises(ArrangementError):
            wrong.verify()


def test_equal_weights_with_a_light_cutset_are_refused():
    """Every vertex of the cut cube has sum 1; the edges at the triangle weigh 1, not more."""
    graph = polyhedral(truncated_cube())
    certificate = WeightCertificate(graph, (Fraction(1, 3),) * len(graph.edges))
    with pytest.raises(ArrangementError, match="cutset"):
        certificate.verify()


def test_any_changed_weight_is_refused():
    certificate = inscribability(Arrangement(A3)).certificate
    assert isinstance(certificate, WeightCertificate)
    for e, weight in enumerate(certificate.weights):
        for other in (weight + Fraction(1, 10**30), -weight, Fraction(0), Fraction(1, 2)):
            weights = (*certificate.weights[:e], other, *certificate.weights[e + 1 :])
            with pytest.raises(ArrangementError):
                replace(certificate, weights=weights).verify()
    with pytest.raises(ArrangementError, match="each edge"):
        replace(certificate, weights=certificate.weights[1:]).verify()


def test_weights_of_exactly_0_or_a_half_are_refused_where_all_else_holds():
    """A diagonal of the cube that weighs nothing; halves on two edges of the tetrahedron."""
    cube = nx.convert_node_labels_to_integers(nx.hypercube_graph(3))
    for graph, changed, weight, others in (
        (cube, {(0, 3)}, Fraction(0), Fraction(1, 3)),
        (nx.tetrahedral_graph(), {(0, 1), (2, 3)}, Fraction(1, 2), Fraction(1, 4)),
    ):
        graph.add_edges_from(changed)
        whole = polyhedral(graph)
        weights = tuple(weight if edge in changed else others for edge in whole.edges)
        with pytest.raises(ArrangementError, match=f"the weight {weight} of edge .* is not inside"):
            WeightCertificate(whole, weights).verify()


def farkas() -> FarkasCertificate:
    certificate = inscribability(generic(5)).certificate
    assert isinstance(certificate, FarkasCertificate)
    return certificate


def test_any_changed_multiplier_is_refused():
    certificate = farkas()
    tiny = Fraction(1, 10**30)
    y = certificate.vertex_multipliers
    changed = [
        replace(certificate, vertex_multipliers=(*y[:v], y[v] + tiny, *y[v + 1 :]))
        for v in range(len(y))
    ]
    edge = certificate.graph.edges[0]
    changed += [
        replace(certificate, lower_multipliers={edge: tiny}),
        replace(certificate, upper_multipliers={edge: tiny}),
        replace(certificate, lower_multipliers={(0, 0): tiny}),
        replace(certificate, vertex_multipliers=y[1:]),
        replace(certificate, vertex_multipliers=(Fraction(0),) * len(y), cuts=()),
        replace(certificate, cuts=()),
    ]
    for k, (side, c) in enumerate(certificate.cuts):
        others = [*certificate.cuts[:k], *certificate.cuts[k + 1 :]]
        everything = frozenset(range(certificate.graph.vertex_count))
        apart = frozenset({min(side), *sorted(everything - side)[:1]})
        for pair in (
            (side, c + tiny),
            (side, -c),
            (frozenset({min(side)}), c),
            (everything, c),
            (side | {10**6}, c),
            (apart, c),
        ):
            changed.append(replace(certificate, cuts=(*others, pair)))
    for wrong in changed:
        with pytest.raises(ArrangementError):
            wrong.verify()
    certificate.verify()


def test_a_negative_multiplier_is_refused_even_if_the_sum_is_right():
    """-1 at both ends of an edge, +1 for the edge, would prove anything."""
    graph = polyhedral(nx.tetrahedral_graph())
    ones = (Fraction(1),) * 4
    minus = dict.fromkeys(graph.edges, Fraction(-2))
    with pytest.raises(ArrangementError, match="negative"):
        FarkasCertificate(graph, ones, minus, {}, ()).verify()
    with pytest.raises(ArrangementError, match="contradicts nothing"):
        FarkasCertificate(
            graph, tuple(-y for y in ones), dict.fromkeys(graph.edges, Fraction(2)), {}, ()
        ).verify()


def test_cutsets_must_be_minimal_and_no_vertex_stars():
    """The star of a vertex, taken as a cutset, would refute every graph."""
    tetrahedron = polyhedral(nx.tetrahedral_graph())
    minus = (Fraction(-1), Fraction(0), Fraction(0), Fraction(0))
    for star in (frozenset({0}), frozenset({1, 2, 3})):
        with pytest.raises(ArrangementError, match="single vertex"):
            FarkasCertificate(tetrahedron, minus, {}, {}, ((star, Fraction(1)),)).verify()
    graph = polyhedral(rhombic_dodecahedron())
    larger, smaller = sorted(nx.bipartite.sets(graph.to_networkx()), key=len, reverse=True)
    balance = {v: Fraction(1 if v in larger else -1) for v in larger | smaller}
    FarkasCertificate(graph, tuple(balance[v] for v in range(14)), {}, {}, ()).verify()
    apart = frozenset(sorted(larger)[:2])
    for v in apart:
        balance[v] -= 1
    wrong = FarkasCertificate(
        graph, tuple(balance[v] for v in range(14)), {}, {}, ((apart, Fraction(1)),)
    )
    with pytest.raises(ArrangementError, match="not minimal"):
        wrong.verify()


def test_independent_sets_are_checked():
    graph = polyhedral(rhombic_dodecahedron())
    certificate = decide(graph)
    assert isinstance(certificate, IndependentSetCertificate)
    assert len(certificate.vertices) == 8
    others = frozenset(range(14)) - certificate.vertices
    for wrong in (
        others,
        certificate.vertices | {min(others)},
        frozenset(sorted(certificate.vertices)[:7]),
        certificate.vertices | {14},
    ):
        with pytest.raises(ArrangementError):
            replace(certificate, vertices=wrong).verify()
