"""The intersection lattice and its Moebius function."""

from collections import Counter
from itertools import combinations, pairwise

import networkx as nx
import pytest
import sympy
from hypothesis import assume, given, strategies as st

from arrangement import Arrangement, InputError, counts, families
from arrangement.counts import lattice as flats

from . import oracle
from .oracle import T
from .strategies import arrangements


def closure_by_ranks(planes: Arrangement, chosen: tuple[int, ...]) -> tuple[int, ...] | None:
    """Return all planes through the intersection of some, from ranks alone; None if empty."""
    augmented = [(*n, b) for n, b in zip(planes.normals, planes.offsets, strict=True)]
    rows = [augmented[i] for i in chosen]
    size = oracle.rank(rows)
    if oracle.rank([row[:-1] for row in rows]) < size:
        return None
    return tuple(i for i, row in enumerate(augmented) if oracle.rank([*rows, row]) == size)


@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_flats_are_the_closed_sets_with_common_points(planes):
    expected = set()
    for size in range(len(planes) + 1):
        for chosen in combinations(range(len(planes)), size):
            closed = closure_by_ranks(planes, chosen)
            if closed is not None:
                expected.add((closed, oracle.rank([planes.normals[i] for i in closed])))
    lattice = counts.intersection_lattice(planes)
    found = [(flat.planes, flat.rank) for level in lattice.flats for flat in level]
    assert len(found) == len(set(found))
    assert set(found) == expected


@given(arrangements(dimensions=(1, 4), planes=(0, 7)))
def test_moebius_sums_to_zero_below_every_flat(planes):
    values = counts.moebius(planes)
    for flat in values:
        below = sum(value for other, value in values.items() if {*other.planes} <= {*flat.planes})
        assert below == (1 if flat.rank == 0 else 0)
        assert (-1) ** flat.rank * values[flat] > 0  # Rota's sign theorem


@given(arrangements(dimensions=(1, 4), planes=(0, 7)))
def test_covers_are_the_next_larger_flats(planes):
    lattice = counts.intersection_lattice(planes)
    for rank, (level, covers) in enumerate(zip(lattice.flats, lattice.covers, strict=True)):
        above = lattice.flats[rank + 1] if rank + 1 < len(lattice.flats) else ()
        for flat, found in zip(level, covers, strict=True):
            expected = {g.planes for g in above if {*flat.planes} <= {*g.planes}}
            assert {above[i].planes for i in found} == expected
            assert len(found) == len(expected)
            assert min(found, default=0) >= 0
            assert flat.dimension == planes.dimension - rank


@given(arrangements(dimensions=(1, 4), planes=(1, 6)), st.data())
def test_closure_is_the_smallest_flat(planes, data):
    chosen = tuple(data.draw(st.sets(st.integers(0, len(planes) - 1), max_size=4)))
    flat = counts.intersection_lattice(planes).closure(chosen)
    assert (flat and flat.planes) == (closure_by_ranks(planes, chosen) if chosen else ())


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_planes_through_the_flats_of_rank_2_are_counted(planes):
    distinct = Arrangement(
        [row[:-1] for row in planes.distinct_planes],
        [row[-1] for row in planes.distinct_planes],
        dimension=planes.dimension,
    )
    pairs = combinations(range(len(distinct)), 2)
    through = {closure_by_ranks(distinct, pair) for pair in pairs} - {None}
    assert counts.t_vector(planes) == dict(Counter(map(len, through)))


@pytest.mark.parametrize("plane", [-1, 2, True])
def test_closure_refuses_planes_that_do_not_exist(plane):
    lattice = counts.intersection_lattice(Arrangement([[1, 0], [0, 1]]))
    with pytest.raises(InputError, match="does not exist"):
        lattice.closure([plane])


def test_whitney_numbers_of_both_kinds_of_the_partition_lattice():
    # Stirling numbers of the first and second kind, OEIS A008275 and A008277
    rows = [[(k == i) - (k == j) for k in range(6)] for i, j in combinations(range(6), 2)]
    numbers = counts.whitney_numbers(Arrangement(rows))
    assert numbers.first == (1, -15, 85, -225, 274, -120)
    assert numbers.second == (1, 15, 65, 90, 31, 1)


@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_covectors_are_the_sign_vectors_that_occur(planes):
    central = planes if planes.is_central else counts.cone(planes)
    expected = oracle.sign_vectors(central)
    assert counts.covectors(planes) == expected
    assert counts.topes(planes) == {signs for signs in expected if 0 not in signs}
    if central is not planes:
        faces = {signs[:-1] for signs in expected if signs[-1] > 0}
        assert faces == oracle.sign_vectors(planes)


@pytest.mark.slow
@given(arrangements(dimensions=(1, 4), planes=(0, 6), central=True))
def test_cocircuits_are_the_nonzero_covectors_of_least_support(planes):
    nonzero = [x for x in oracle.sign_vectors(planes) if any(x)]

    def support(signs):
        return frozenset(i for i, sign in enumerate(signs) if sign)

    least = {x for x in nonzero if not any(support(y) < support(x) for y in nonzero)}
    assert counts.cocircuits(planes) == least


@given(arrangements(dimensions=(1, 4), planes=(1, 6), central=True))
def test_chirotope_is_nonzero_exactly_on_bases(planes):
    chi = counts.chirotope(planes)
    assert set(chi) == set(combinations(range(len(planes)), planes.rank))
    for chosen, value in chi.items():
        independent = oracle.rank([planes.normals[i] for i in chosen]) == planes.rank
        assert (value != 0) == independent
    assert counts.bases(planes) == tuple(chosen for chosen, value in chi.items() if value)


def test_chirotope_of_big_entries_is_exact():
    huge = 10**30
    near = Arrangement([[1, 0, 0], [0, 1, 0], [huge, huge + 1, 1], [huge, huge + 1, 0]])
    assert counts.chirotope(near) == {(0, 1, 2): 1, (0, 1, 3): 0, (0, 2, 3): -1, (1, 2, 3): 1}


def test_chirotopes_are_written_in_the_order_of_their_kind():
    planes = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [1, 3, 2]])
    chi = counts.chirotope(planes)
    for order, words in (
        ((), "123 124 134 234 125 135 235 145 245 345"),
        (("reverse-lexicographic",), "123 124 134 234 125 135 235 145 245 345"),
        (("lexicographic",), "123 124 125 134 135 145 234 235 245 345"),
    ):
        signs = [chi[tuple(int(x) - 1 for x in word)] for word in words.split()]
        assert chi[0, 3, 4] != chi[1, 2, 4]
        assert counts.chirotope_string(planes, *order) == "".join("0+-"[x] for x in signs)
    with pytest.raises(InputError, match="the order is 'random'; expected one of rev"):
        counts.chirotope_string(planes, "random")


@given(arrangements(dimensions=(1, 3), planes=(0, 5), central=False))
def test_of_affine_planes_there_are_those_of_the_cone(planes):
    cone = counts.cone(planes) if any(planes.offsets) else planes
    for name in ("chirotope", "dual_chirotope", "chirotope_string", "bases"):
        assert getattr(counts, name)(planes) == getattr(counts, name)(cone)
    for name in ("circuits", "cocircuits", "covectors", "topes"):
        assert getattr(counts, name)(planes) == getattr(counts, name)(cone)
        assert getattr(planes, name)() == getattr(counts, name)(planes)


def test_determinants_are_foreseen(monkeypatch):
    """Of r of m normals, r^3 steps each."""
    asked = []
    monkeypatch.setattr(
        flats.budget, "check_cost", lambda what, *_, **takes: asked.append((what, takes))
    )
    for planes, number, order in (
        (families.generic(6, 3), 20, 3),
        (Arrangement([], dimension=2), 1, 1),
    ):
        del asked[:]
        counts.chirotope(planes)
        (takes,) = [takes for what, takes in asked if "determinants" in what]
        assert takes == {
            "steps": pytest.approx(1e7 * number * order**3 * 4e-7),
            "bytes": number * 200,
        }


CENTRAL = arrangements(dimensions=(1, 4), planes=(0, 6), central=True)


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
    exponents = counts.supersolvable_exponents(planes)
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


@pytest.mark.slow
@given(CENTRAL)
def test_no_chain_is_missed(planes):
    assert (counts.modular_chain(planes) is not None) == is_supersolvable(planes)


def test_known_chains():
    """Reflection arrangements of types A and B are supersolvable, D4 is not though chi factors."""
    assert sorted(counts.supersolvable_exponents(families.braid(5)) or ()) == [1, 2, 3, 4]
    assert sorted(counts.supersolvable_exponents(families.type_b(4)) or ()) == [1, 3, 5, 7]
    for free in (families.type_d(4), families.coxeter("F4")):
        assert counts.supersolvable_exponents(free) is None
    assert counts.supersolvable_exponents(Arrangement([], dimension=3)) == ()
    with pytest.raises(InputError, match="cone"):
        counts.modular_chain(families.shi(3))


def foreseen(planes, monkeypatch):
    """Return the seconds and bytes that are foreseen before the lattice and before each rank."""
    asked = []
    with monkeypatch.context() as patch:
        patch.setattr(
            flats.budget, "check_cost", lambda *what, **takes: asked.append((*what, takes))
        )
        lattice = counts.intersection_lattice(planes)
    asked = [takes for what, *_, takes in asked if "flats" in what]
    return asked, [len(level) for level in lattice.masks]


@pytest.mark.parametrize(
    ("planes", "bits"),
    [
        (Arrangement([[1, k, k**2, k**3, k**4] for k in range(-3, 4)]), 7),
        (families.braid(5), 1),
        (Arrangement([[1, k, k**2, k**3 * sympy.sqrt(2)] for k in range(-3, 4)]), 1000),
        (families.braid(3), 1),
    ],
    ids=str,
)
def test_what_flats_take_is_foreseen_from_those_that_are_known(planes, bits, monkeypatch):
    """Time for each flat with a plane beside it; bytes for their vectors, of a rank and the next.

    In general position all ranks are known from the second, else only the next one.
    """
    (before, *asked), found = foreseen(planes, monkeypatch)
    m, top = len(planes), planes.rank
    assert before == {"bytes": 200 * 2**top}

    def expected(rank):
        seconds, most, vectors = 0, 0, 0
        for k in range(rank, top - 1) if rank else (0,):
            pairs = found[k] * (m - k)
            kept = found[k + 1] * (m - k - 1) if k + 2 < top else 0
            seconds += pairs / 2 + kept * (2 + 0.06 * bits)
            before, vectors = vectors, kept * (160 + (top - k) * (k + 1) * bits / 4)
            most = max(most, before + vectors + 20 * pairs)
        return {"steps": pytest.approx(1e7 * seconds * 1e-6), "bytes": pytest.approx(most)}

    assert asked == [expected(rank) for rank in range(top - 1)]


def tutte_by_subsets(planes: Arrangement) -> sympy.Poly:
    """The definition as it stands, over all sets of planes with a common point."""
    x, y = sympy.symbols("x y")
    augmented = [(*n, b) for n, b in zip(planes.normals, planes.offsets, strict=True)]
    found = sympy.Poly(0, x, y)
    for size in range(len(planes) + 1):
        for chosen in combinations(augmented, size):
            order = oracle.rank(list(chosen))
            if oracle.rank([row[:-1] for row in chosen]) == order:
                term = (x - 1) ** (planes.rank - order) * (y - 1) ** (size - order)
                found += sympy.Poly(term, x, y)
    return found


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_tutte_polynomial_is_its_sum_over_subsets_and_gives_chi(planes):
    found = counts.tutte_polynomial(planes)
    assert found == tutte_by_subsets(planes)
    assert found.eval((2, 0)) == counts.region_count(planes) == len(planes.regions())
    assert found.eval((0, 0)) == counts.bounded_region_count(planes, relative=True)
    chi = (
        (-1) ** planes.rank
        * T ** (planes.dimension - planes.rank)
        * found.as_expr().subs(
            dict(zip(sympy.symbols("x y"), (1 - T, 0), strict=True)), simultaneous=True
        )
    )
    assert sympy.Poly(chi, T) == counts.characteristic_polynomial(planes)


@pytest.mark.parametrize("graph", [nx.complete_graph(4), nx.cycle_graph(5), nx.petersen_graph()])
def test_tutte_polynomial_of_a_graph_is_that_of_networkx(graph):
    """K4: 24 acyclic orientations and 16 spanning trees (Cayley)."""
    if len(graph) == 10:
        graph = graph.subgraph(range(8))
    found = counts.tutte_polynomial(families.graphical(graph))
    assert sympy.expand(found.as_expr() - nx.tutte_polynomial(graph)) == 0
    if len(graph) == 4:
        assert (found.eval((2, 0)), found.eval((1, 1))) == (24, 16)


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_sets_without_broken_circuits_are_as_many_as_whitney_numbers_say(planes):
    found = counts.nbc_sets(planes)
    signed = tuple((-1) ** k * len(sets) for k, sets in enumerate(found))
    assert signed == counts.first_whitney_numbers(planes)
    every = {chosen for sets in found for chosen in sets}
    firsts = planes.firsts
    for size in range(len(firsts) + 1):
        for chosen in combinations(firsts, size):
            flat = [closure_by_ranks(planes, chosen[k:]) for k in range(size)]
            independent = (
                None not in flat and oracle.rank([planes.integer_planes[i] for i in chosen]) == size
            )
            unbroken = independent and all(
                planes.class_of[chosen[k]] == min(planes.class_of[i] for i in flat[k])
                for k in range(size)
            )
            assert (chosen in every) == unbroken


def test_tutte_polynomial_beyond_the_limits_is_refused():
    with pytest.raises(InputError, match="the Tutte polynomial of 63 planes of rank 6"):
        counts.tutte_polynomial(families.resonance(6))
    with pytest.raises(InputError, match="sets without broken circuits"):
        counts.nbc_sets(families.resonance(6))
