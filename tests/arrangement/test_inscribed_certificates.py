"""Certificates about inscribability: any change is refused, and so is what would prove too much."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import networkx as nx
import pytest

from arrangement import Arrangement, ArrangementError, inscribability
from arrangement.duals.inscribed import (
    FarkasCertificate,
    IndependentSetCertificate,
    WeightCertificate,
    decide,
)
from arrangement.library.families import generic

from .test_dual import A3
from .test_inscribed import polyhedral, rhombic_dodecahedron, truncated_cube


def test_equal_weights_with_a_light_cutset_are_refused() -> None:
    """Every vertex of the cut cube has sum 1; the edges at the triangle weigh 1, not more."""
    graph = polyhedral(truncated_cube())
    certificate = WeightCertificate(graph, (Fraction(1, 3),) * len(graph.edges))
    with pytest.raises(ArrangementError, match="cutset"):
        certificate.verify()


def test_any_changed_weight_is_refused() -> None:
    certificate = inscribability(Arrangement(A3)).certificate
    assert isinstance(certificate, WeightCertificate)
    for e, weight in enumerate(certificate.weights):
        for other in (weight + Fraction(1, 10**30), -weight, Fraction(0), Fraction(1, 2)):
            weights = (*certificate.weights[:e], other, *certificate.weights[e + 1 :])
            with pytest.raises(ArrangementError):
                replace(certificate, weights=weights).verify()
    with pytest.raises(ArrangementError, match="each edge"):
        replace(certificate, weights=certificate.weights[1:]).verify()


def test_weights_of_exactly_0_or_a_half_are_refused_where_all_else_holds() -> None:
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


def test_any_changed_multiplier_is_refused() -> None:
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


def test_a_negative_multiplier_is_refused_even_if_the_sum_is_right() -> None:
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


def test_cutsets_must_be_minimal_and_no_vertex_stars() -> None:
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


def test_independent_sets_are_checked() -> None:
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
