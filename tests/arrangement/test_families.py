"""Families of arrangements against the counts that the literature gives for them."""

import inspect
import math
from collections import Counter
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from itertools import combinations, product
from random import Random
from typing import Any

import networkx as nx
import numpy as np
import pytest
import sympy
from sympy.functions.combinatorial.numbers import stirling

from arrangement import Arrangement, InputError, counts, families
from arrangement.library.families.simplicial import printed_vectors
from arrangement.library.published import published_counts

T = sympy.Symbol("t")


def roots(*values: int) -> sympy.Expr:
    return sympy.prod([T - value for value in values])


def linial_chi(n: int) -> sympy.Expr:
    total = sum(math.comb(n, k) * (T - k) ** (n - 1) for k in range(n + 1))
    return T * sympy.Rational(1, 2**n) * sympy.expand(total)


# characteristic polynomials as printed in the sources that the docstrings name
POLYNOMIALS: dict[str, tuple[Callable[[int], Arrangement], Callable[[int], Any], range]] = {
    "coordinate": (families.coordinate, lambda n: (T - 1) ** n, range(1, 6)),
    "pencil": (families.pencil, lambda m: T * roots(1, m - 1), range(1, 8)),
    "near-pencil": (families.near_pencil, lambda m: roots(1, 1, m - 2), range(3, 9)),
    "braid": (families.braid, lambda n: roots(*range(n)), range(1, 7)),
    "B": (families.type_b, lambda n: roots(*range(1, 2 * n, 2)), range(1, 6)),
    "D": (families.type_d, lambda n: roots(n - 1, *range(1, 2 * n - 2, 2)), range(2, 6)),
    "Shi": (families.shi, lambda n: T * (T - n) ** (n - 1), range(1, 6)),
    "Ish": (families.ish, lambda n: T * (T - n) ** (n - 1), range(1, 6)),
    "Catalan": (families.catalan, lambda n: T * roots(*range(n + 1, 2 * n)), range(1, 6)),
    "Linial": (families.linial, linial_chi, range(1, 6)),
    "Ish B": (families.ish_b, lambda n: (T - 2 * n) ** n, range(1, 5)),
    "cross-polytope": (
        partial(families.separations, "cross-polytope"),
        lambda n: (T - 1) ** n + (T - 1) * (T - 2) ** n,
        range(1, 6),
    ),
    "between D and B": (
        lambda k: families.signed_graphical(
            ",".join(["1-2,1-3,2-3,1+2,1+3,2+3", *map(str, range(1, k + 1))])
        ),
        lambda k: roots(1, 3, 2 + k),
        range(4),
    ),
}


@pytest.mark.parametrize(
    ("name", "n"), [(name, n) for name, (_, _, sizes) in POLYNOMIALS.items() for n in sizes]
)
def test_characteristic_polynomials(name, n):
    family, chi, _ = POLYNOMIALS[name]
    assert counts.characteristic_polynomial(family(n)) == sympy.Poly(chi(n), T, domain=sympy.ZZ)


#: More are beyond `make verify`; the claim large-regions-in-print has those of minutes, too.
LARGE = [entry for entry in published_counts() if 10**6 < entry.regions < 10**9]


@pytest.mark.slow
@pytest.mark.parametrize("entry", LARGE, ids=lambda entry: entry.label)
def test_region_counts_in_print(entry):
    assert counts.region_count(entry.planes()) == entry.regions


EXPONENTS = {"A4": (1, 2, 3, 4), "B3": (1, 3, 5), "C4": (1, 3, 5, 7), "D5": (1, 3, 4, 5, 7)}
EXPONENTS |= {"E6": (1, 4, 5, 7, 8, 11), "F4": (1, 5, 7, 11), "G2": (1, 5)}


@pytest.mark.slow
# Orlik and Solomon (1980) for mirrors; Athanasiadis (2004) for Shi and Catalan planes
@pytest.mark.parametrize("type", EXPONENTS)
def test_polynomials_of_types(type):
    chi = counts.characteristic_polynomial
    exponents = EXPONENTS[type]
    assert chi(families.coxeter(type)).as_expr().equals(roots(*exponents))
    for m in (1, 2):
        h = m * (max(exponents) + 1)
        if len(exponents) < 5:
            assert chi(families.shi(type, m)).as_expr().equals(roots(*[h] * len(exponents)))
            assert (
                chi(families.catalan(type, m)).as_expr().equals(roots(*(h + e for e in exponents)))
            )


@pytest.mark.parametrize(
    "graph",
    [
        nx.path_graph(5),
        nx.cycle_graph(6),
        nx.complete_graph(5),
        nx.petersen_graph().subgraph(range(8)),
        nx.complete_bipartite_graph(3, 3),
        nx.disjoint_union(nx.cycle_graph(3), nx.path_graph(2)),
        nx.empty_graph(3),
        nx.Graph([("c", "a"), ("a", "b")]),
    ],
    ids=str,
)
def test_graphical_arrangements_have_the_chromatic_polynomial(graph):
    chromatic = nx.chromatic_polynomial(graph)
    symbols = list(chromatic.free_symbols)
    expected = sympy.Poly(chromatic.subs(symbols[0], T) if symbols else chromatic, T)
    planes = families.graphical(graph)
    assert counts.characteristic_polynomial(planes).as_expr() == expected.as_expr()


CONNECTED = [g for g in nx.graph_atlas_g()[2:] if len(g) <= 5 and nx.is_connected(g)]


@pytest.mark.slow
@pytest.mark.parametrize("graph", CONNECTED, ids=lambda graph: str(graph.edges))
def test_bigraphical_planes_have_their_tutte_polynomial(graph):
    # Hopkins and Perkinson (2016): (-2)^(n-1) t T(1 - t/2, 1)
    x, y = sympy.symbols("x y")
    tutte = sympy.sympify(nx.tutte_polynomial(graph)).subs({y: 1}).subs({x: 1 - T / 2})
    expected = sympy.Poly((-2) ** (len(graph) - 1) * T * tutte, T)
    planes = families.bigraphical(graph)
    assert counts.characteristic_polynomial(planes).as_expr() == expected.as_expr()
    for fewer in (families.shi(graph), families.semiorder(graph)):
        assert counts.region_count(fewer) <= counts.region_count(planes)


@pytest.mark.parametrize("m", [1, 2])
def test_deformations_of_graphs(m):
    complete = nx.complete_graph(4)
    assert families.shi(complete, m) == families.shi(4, m)
    assert families.catalan(complete, m) == families.catalan(4, m)
    tree = "1-3,2-3,3-4"
    assert counts.region_count(families.shi(tree, m)) == (2 * m + 1) ** 3
    assert counts.region_count(families.catalan(tree, m)) == (2 * m + 2) ** 3
    cycle = families.shi("1-2,2-3,3-4,1-4", m)
    assert counts.by_points(cycle) == counts.characteristic_polynomial(cycle)


def test_text_is_a_graph():
    graph = nx.empty_graph(3)
    graph.add_edges_from([(0, 2), (1, 2)])
    assert families.braid(5) == families.graphical(nx.complete_graph(5))
    assert families.graphical("1-3, 3-2") == families.graphical(graph)
    assert families.graphical("2-4").dimension == 4
    assert families.linial("3-1") == families.linial("1-3")


@pytest.mark.parametrize("sign", [1, -1])
def test_switching_a_vertex_keeps_the_polynomial(sign):
    graph = nx.MultiGraph(nx.wheel_graph(5))
    nx.set_edge_attributes(graph, sign, "sign")
    switched = graph.copy()
    for tail, head, key in graph.edges(2, keys=True):
        switched[tail][head][key]["sign"] = -sign
    chi = [
        counts.characteristic_polynomial(families.signed_graphical(g)) for g in (graph, switched)
    ]
    assert chi[0] == chi[1]
    if sign == 1:  # balanced: the same as without signs
        assert chi[0] == counts.characteristic_polynomial(families.graphical(nx.wheel_graph(5)))


def test_separations():
    assert families.separations("cube", 3) == families.threshold_functions(3)
    sixteen_cells = [families.separations(name, 4) for name in ("demicube", "cross-polytope")]
    assert len({counts.whitney_numbers(planes) for planes in sixteen_cells}) == 1
    permutations = families.separations("permutohedron", 4)
    assert len(permutations.regions()) == counts.region_count(permutations) == 2894


@pytest.mark.parametrize("n", range(1, 7))
def test_bisectors_and_lines_of_generic_points_have_published_numbers(n):
    """Regions of bisectors: permutations with n, n - 1 or n - 2 cycles (Good, Tideman 1977)."""
    source = Random(n)
    points = [(source.randint(-999, 999), Fraction(source.randint(-999, 999), 7)) for _ in range(n)]
    orders = families.bisectors(points)
    cycles = sum(int(stirling(n, k, kind=1)) for k in range(max(1, n - 2), n + 1))
    assert counts.region_count(orders) == len(orders.regions()) == cycles
    for region in orders.regions():
        far = [sum((a - b) ** 2 for a, b in zip(p, region.witness, strict=True)) for p in points]
        nearer = [1 if far[i] < far[j] else -1 for i, j in combinations(range(n), 2)]
        assert region.signs == tuple(nearer)
    lines = families.lines_through(points)
    assert len(lines) == math.comb(n, 2)
    expected = (n - 1) * (n**3 - 5 * n**2 + 18 * n - 8) // 8
    assert counts.region_count(lines) == (expected if n > 2 else n)


def test_points_may_be_text_and_lines_through_several_come_once():
    grid = list(product(range(3), repeat=2))
    text = ";".join(f"{x}, {y}" for x, y in grid)
    assert families.lines_through(text) == families.lines_through(grid)
    assert len(families.lines_through(grid)) == 20  # OEIS A018808
    assert families.bisectors("0,0;1/2,1") == families.bisectors([(0, 0), ("1/2", 1)])
    plane = families.lines_through([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
    assert plane.integer_planes == ((0, 0, 1, 0),)


def test_graphs_may_be_pairs_of_vertices():
    pairs = [(3, 1), (2, 3)]
    assert families.graphical(pairs) == families.graphical("1-3,2-3")
    assert families.shi(pairs, 2) == families.shi("1-3,2-3", 2)
    assert families.graphical([("b", "a"), (1, "a")]).dimension == 3
    assert len(families.bigraphical([(0, 1)])) == 2


def test_discriminantal_planes_can_be_the_braid_arrangement():
    for n in (4, 5):
        braid = counts.essentialization(families.braid(n))
        assert counts.f_vector(families.discriminantal(n, n - 1)) == counts.f_vector(braid)


def test_parallel_edges_are_coincident_planes():
    planes = families.graphical(nx.MultiGraph([(0, 1), (0, 1), (1, 2)]))
    assert planes.distinct == ((0, 1), (2,))


#: Rational entries, irrational ones, and regular polygons, A(m, 1).
ENTRIES = [(6, 1), (7, 1), (8, 1), (9, 1), (10, 2), (10, 3), (11, 1), (12, 1), (12, 2), (12, 3)]
ENTRIES += [(13, 1), (13, 2), (13, 3), (10, 1), (13, 4), (14, 1), (15, 5), (16, 1), (17, 1)]
ENTRIES += [(18, 4), (31, 1), (35, 1)]


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_catalogue_entries_have_printed_vectors(entry):
    """Vertices by the number of planes through them, planes by the number of vertices on them."""
    planes = families.simplicial(*entry)
    vertices = [flat.planes for flat in counts.intersection_lattice(planes).flats[2]]
    on_planes = Counter(plane for vertex in vertices for plane in vertex)
    found = (Counter(map(len, vertices)), Counter(on_planes.values()))
    assert found == printed_vectors(*entry)
    assert len(planes) == len(planes.distinct) == entry[0]
    assert planes.is_simplicial
    assert counts.f_vector(planes) == planes.faces().f_vector
    if entry[1] == 1 and entry[0] in (6, 8, 9, 10, 13, 14, 17):
        assert counts.t_vector(families.regular(entry[0])) == found[0]


def test_entries_with_the_same_vectors_are_different():
    def meets(entry):
        flats = counts.intersection_lattice(families.simplicial(*entry)).flats[2]
        vertices = Counter(plane for flat in flats for plane in flat.planes)
        return Counter(tuple(sorted(vertices[p] for p in flat.planes)) for flat in flats)

    assert printed_vectors(19, 4) == printed_vectors(19, 5)
    assert meets((19, 4)) != meets((19, 5))


def test_mirrors_of_the_icosahedron_and_of_the_600_cell():
    assert families.h3().faces().f_vector == counts.f_vector(families.h3()) == (1, 62, 180, 120)
    assert families.coxeter("H4") == families.h4()
    assert families.h4().faces().f_vector == (1, 2640, 17040, 28800, 14400)

    chi = counts.characteristic_polynomial(families.h4())
    assert chi.as_expr().factor() == roots(1, 11, 19, 29)


def test_mirrors_of_polygons_and_bounded_regions_of_shi_planes():
    for n in range(3, 7):
        assert families.coxeter(f"I2({n})").faces().f_vector == (1, 2 * n, 2 * n)
        shi = families.shi(n - 1)
        assert counts.bounded_region_count(shi, relative=True) == (n - 2) ** (n - 2)
        assert counts.bounded_region_count(shi) == 0  # all contain (1, ..., 1)


@pytest.mark.parametrize(("m", "d"), [(0, 1), (4, 1), (5, 2), (7, 3), (7, 4), (3, 5)])
def test_generic_planes_are_in_general_position(m, d):
    assert families.generic(m, d).is_simple
    assert families.generic(m, d, affine=True).is_simple


@pytest.mark.parametrize("make", [families.random_integer, families.random_degenerate])
def test_random_planes_depend_on_the_seed_alone(make):
    assert make(8, seed=1, affine=True) == make(8, seed=1, affine=True)
    assert make(8, seed=1) != make(8, seed=2)


@pytest.mark.parametrize(("d", "bits"), [(1, 5), (2, 20), (3, 4), (3, 20), (5, 12)])
def test_sphere_normals_are_exactly_unit_up_to_scale(d, bits):
    planes = families.random_sphere(20, d, bits=bits, seed=9)
    assert planes == families.random_sphere(20, d, bits=bits, seed=9)
    for plane in planes.integer_planes:
        square = sum(x * x for x in plane)
        assert math.isqrt(square) ** 2 == square


def test_sphere_normals_are_spread_evenly():
    # in every octant about 1/8 of the points: 4000 draws, five standard deviations
    planes = families.random_sphere(4000, seed=0)
    octants = Counter(tuple(x > 0 for x in plane[:3]) for plane in planes.integer_planes)
    spread = 5 * math.sqrt(4000 * 7 / 64)
    assert len(octants) == 8
    assert all(abs(n - 500) < spread for n in octants.values())
    # Archimedes: each coordinate is even on [-1, 1]; so |x| < 1/2 for half of the points
    for k in range(3):
        central = sum(4 * p[k] ** 2 < sum(x * x for x in p) for p in planes.integer_planes)
        assert abs(central - 2000) < 5 * math.sqrt(1000)


@pytest.mark.parametrize(
    ("family", "offsets"),
    [
        (families.shi, (0, 1)),
        (families.catalan, (-1, 0, 1)),
        (families.linial, (1,)),
        (families.semiorder, (-1, 1)),
    ],
)
def test_sides_of_the_deformations_are_those_of_their_definition(family, offsets):
    x = [Fraction(5, 2), Fraction(3, 2), Fraction(0), Fraction(-1, 3)]
    differences = [a - b for a, b in combinations(x, 2)]
    expected = [(d > b) - (d < b) for d in differences for b in offsets]
    assert list(family(4).signs_at(x)) == expected


def test_resonance_planes_are_the_nonempty_subset_sums():
    rows = {plane[:-1] for plane in families.resonance(4).integer_planes}
    subsets = [s for size in range(1, 5) for s in combinations(range(4), size)]
    assert rows == {tuple(int(i in s) for i in range(4)) for s in subsets}


REFUSED: list[tuple[Callable[..., object], tuple[Any, ...], str]] = [
    *(
        (families.coxeter, (name,), "there are A1, A2")
        for name in ("E9", "A0", "B1", "F5", "e6", "", "H5", "I2", "I2(2)", "I2(x)")
    ),
    *((families.regular, (planes,), "no regular arrangement") for planes in (7, 11, 15)),
    (families.regular, (5,), "must be at least"),
    (families.regular, ("9",), "give an integer"),
    *((families.braid, (size,), "give an integer") for size in (2.0, "3", True, None)),
    (families.braid, (0,), "must be at least"),
    (families.type_d, (1,), "must be at least"),
    (families.near_pencil, (2,), "must be at least"),
    (families.pencil, (3, 1), "must be at least"),
    (families.generic, (-1,), "must be at least"),
    (partial(families.random_integer, bound=0), (3,), "must be at least"),
    (families.shi, (0,), "must be at least"),
    (families.ish_b, (0,), "must be at least"),
    (families.separations, ("cube", 0), "must be at least"),
    (families.discriminantal, (2, 3), "must be at least"),
    (families.separations, ("simplex", 3), "there are cube, demicube"),
    (families.simplicial, (5, 1), r"A\(6, 1\)"),
    (families.graphical, (nx.DiGraph([(0, 1)]),), "directed"),
    (families.graphical, (nx.Graph([(0, 0)]),), "loop"),
    (families.graphical, (nx.Graph(),), "no vertices"),
    (families.graphical, ("1-1",), "loop at 1"),
    (families.graphical, ([(1, 1)],), "loop at 1"),
    (families.graphical, ([],), "no vertices"),
    *((families.graphical, ([edge],), r"graph\[0\] is ") for edge in (1, (1, 2, 3), ([1], [2]))),
    (families.bisectors, ([],), "give points of one space"),
    (families.bisectors, ([(0, 0), (1, 2, 3)],), "give points of one space"),
    (families.bisectors, ([(0, 0), (1, 2), (0, 0)],), r"points\[2\] is points\[0\] again"),
    (families.lines_through, ("0,0;1",), "give points of one space"),
    (families.lines_through, ("0,0;x,1",), "points"),
    (families.graphical, ("1+2",), "negative edges"),
    *(
        (families.graphical, (text,), "write its edges as")
        for text in ("1-2;2-3", "0-1", "1-2000", "")
    ),
    (families.signed_graphical, (nx.Graph([(0, 1, {"sign": 2})]),), "the sign 2; give 1 or -1"),
]


@pytest.mark.parametrize(("family", "given", "message"), REFUSED)
def test_members_that_do_not_exist_are_refused(family, given, message):
    with pytest.raises(InputError, match=message):
        family(*given)


ODD = ["abc", b"x", 1.5, float("nan"), None, (1, 2), [(0, 1)], {}, -1, -(10**30), 10**30, True]
ODD += [Fraction(1, 2), 1j, np.array([1, 2]), nx.DiGraph([(0, 1)]), "x" * 5000, "24-cell", int]
GOOD = {"corners": 5, "type": "A3", "graph": "1-2,2-3", "polytope": "cube", "n": 3, "m": 4}
GOOD |= {"points": "0,0;1,0;0,1", "d": 3, "planes": 10, "number": 1}


@pytest.mark.parametrize("name", families.FAMILIES)
def test_arguments_of_wrong_types_are_refused_in_one_line(name):
    made = families.FAMILIES[name]
    parameters = inspect.signature(made).parameters.values()
    due = {p.name: GOOD[p.name] for p in parameters if p.default is inspect.Parameter.empty}
    messages = []
    for p, odd in product(parameters, ODD):
        try:
            made(**{**due, p.name: odd})
        except InputError as error:
            messages.append(str(error))
    assert all(len(text) < 400 and "\n" not in text for text in messages)


def test_numpy_integers_are_integers():
    assert families.generic(np.int64(4), np.int64(2)) == families.generic(4, 2)
