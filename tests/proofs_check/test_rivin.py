"""The second check of certificates on inscribed polyhedra refuses what is wrong."""

from fractions import Fraction

import pytest

from arrangement.arrangement import Arrangement
from proofs_check.routes import rivin
from proofs_check.routes.dual_graph import DualGraph, from_covectors

CUBE = from_covectors(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
DODECAHEDRON = from_covectors(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]))


def prism() -> DualGraph:
    """The hexagonal prism: the dual of three planes through a line and one across."""
    return from_covectors(Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1]]))


def upright(edge: frozenset[tuple[int, ...]]) -> bool:
    a, b = edge
    return a[3] != b[3]


@pytest.mark.parametrize("change", [Fraction(1, 10**30), Fraction(-1, 3), Fraction(1, 6)])
def test_one_changed_weight_is_refused(change):
    for edge in CUBE.edges:
        weights = dict.fromkeys(CUBE.edges, Fraction(1, 3))
        weights[edge] += change
        assert not rivin.weights_fit(CUBE, weights)


def test_a_cycle_that_weighs_too_little_is_refused():
    graph = prism()
    fine = {e: Fraction(1, 5) if upright(e) else Fraction(2, 5) for e in graph.edges}
    assert rivin.weights_fit(graph, fine)
    light = {e: Fraction(1, 6) if upright(e) else Fraction(5, 12) for e in graph.edges}
    assert not rivin.weights_fit(graph, light)


def test_an_independent_set_needs_more_than_half_of_the_vertices():
    parity = {v: list(v).count(-1) % 2 for v in DODECAHEDRON.vertices}
    sets = [frozenset(v for v, p in parity.items() if p == k) for k in (0, 1)]
    assert sorted(map(len, sets)) == [6, 8]
    assert [rivin.is_large_independent_set(DODECAHEDRON, s) for s in sets] == [
        len(s) == 8 for s in sets
    ]
    assert not rivin.is_large_independent_set(DODECAHEDRON, DODECAHEDRON.vertices)
    assert not rivin.is_large_independent_set(CUBE, frozenset(list(CUBE.vertices)[:5]))


def test_multipliers_of_unequal_classes_fit():
    """+1 at the eight vertices and -1 at the six cancel at every edge and leave -8 + 6."""
    parity = {v: list(v).count(-1) % 2 for v in DODECAHEDRON.vertices}
    large = max((0, 1), key=lambda k: list(parity.values()).count(k))
    y = {v: Fraction(1 if p == large else -1) for v, p in parity.items()}
    assert rivin.multipliers_fit(DODECAHEDRON, y, {}, {}, [])
    assert not rivin.multipliers_fit(DODECAHEDRON, {v: -x for v, x in y.items()}, {}, {}, [])
    for v in y:
        assert not rivin.multipliers_fit(
            DODECAHEDRON, {**y, v: y[v] + Fraction(1, 10**9)}, {}, {}, []
        )


def test_a_cut_of_one_vertex_is_refused():
    one = frozenset(list(CUBE.vertices)[:1])
    zero = dict.fromkeys(CUBE.vertices, Fraction(0))
    zero[next(iter(one))] = Fraction(-1)
    assert not rivin.multipliers_fit(CUBE, zero, {}, {}, [(one, Fraction(1))])
