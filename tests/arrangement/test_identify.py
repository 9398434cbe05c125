"""Types distinguished by chirotopes: codes, extensions and proofs without coordinates."""

import itertools
import json
from collections import Counter
from hashlib import sha256
from random import Random

import numpy as np
import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement import Arrangement, InputError, families
from arrangement.library.census import (
    PUBLISHED,
    catalogue,
    census,
    final_polynomials,
    finschi_fukuda,
    identify,
)
from arrangement.library.census.chirotopes import (
    canonical,
    chirotope_of,
    extended,
    extensions,
    triples,
)
from arrangement.library.census.final_polynomials import (
    OrderedProducts,
    final_document,
    proved_no_coordinates,
    proves_no_coordinates,
)
from tests.census import __main__ as workshop, generate
from tests.census.proofs import _comparisons, final_polynomial


def chirotopes(planes: int) -> np.ndarray:
    return chirotope_of(np.array([a.normals for a in census(planes)], dtype=np.int64))


def pseudoline_types(planes: int) -> int:
    """Types of oriented matroids with one element more than the census's, by extension alone."""
    larger = [extended(row, extensions(row, planes), planes) for row in chirotopes(planes)]
    return len(np.unique(canonical(np.concatenate(larger), planes + 1).codes, axis=0))


@pytest.mark.parametrize("planes", [3, 4, 5, 6])
def test_extensions_give_the_published_numbers(planes):
    assert pseudoline_types(planes) == PUBLISHED[planes + 1]


@pytest.mark.slow
def test_eight_pseudolines_have_the_published_number_of_types():
    assert pseudoline_types(7) == PUBLISHED[8]


@pytest.mark.parametrize("planes", [*range(3, 8), pytest.param(8, marks=pytest.mark.slow)])
def test_codes_tell_the_types_of_the_census_apart(planes):
    assert len(np.unique(canonical(chirotopes(planes), planes).codes, axis=0)) == PUBLISHED[planes]


entries = st.integers(-4, 4)
normals = st.tuples(entries, entries, entries).filter(any)


@given(st.lists(normals, min_size=3, max_size=7))
def test_identified_type_has_the_same_tope_graph(rows):
    arrangement = Arrangement(rows)
    found = identify(arrangement)
    assert found.planes == len(arrangement.distinct)
    assert found.f_vector == arrangement.faces().f_vector
    if found.rank < 3:
        assert found.type == 1
        return
    theirs = census(found.planes)[found.type - 1]
    moved = [[s * x for x in rows[k]] for k, s in zip(found.order, found.sides, strict=True)]
    one, other = (chirotope_of(np.array(x, dtype=np.int64)) for x in (moved, [*theirs.normals]))
    assert (one == other).all() or (one == -other).all()
    firsts = [rows[members[0]] for members in arrangement.distinct]
    assert generate.canonical_form(Arrangement(firsts)) == generate.canonical_form(theirs)
    points = sum(found.t_vector.values())
    assert 2 * points == theirs.faces().f_vector[1]


@given(st.data())
def test_relabelling_sides_and_linear_maps_keep_the_type(data):
    planes = data.draw(st.integers(3, 9))
    number = data.draw(st.integers(1, PUBLISHED[planes]))
    order = data.draw(st.permutations(range(planes)))
    sides = data.draw(st.lists(st.sampled_from([1, -1]), min_size=planes, max_size=planes))
    shear = np.array([[1, *data.draw(st.tuples(entries, entries))], [0, 1, 2], [0, 0, 1]])
    rows = np.array(census(planes)[number - 1].normals)[order] * np.array(sides)[:, None] @ shear
    assert identify(Arrangement(rows.tolist())).type == number


def automorphisms_by_force(arrangement: Arrangement) -> int:
    n = len(arrangement)
    signs = dict(zip(map(tuple, triples(n).tolist()), chirotope_of(
        np.array(arrangement.normals, dtype=np.int64)), strict=True))  # fmt: skip
    count = 0
    for order in itertools.permutations(range(n)):
        images = []
        for i, j, k in signs:
            a, b, c = order[i], order[j], order[k]
            odd = (a > b) + (a > c) + (b > c)
            images.append((-1) ** odd * signs[tuple(sorted((a, b, c)))])
        for sides in itertools.product((1, -1), repeat=n - 1):
            t = (1, *sides)
            turned = [t[i] * t[j] * t[k] * x for (i, j, k), x in zip(signs, images, strict=True)]
            plain = list(signs.values())
            count += turned == plain or turned == [-x for x in plain]
    return count


@pytest.mark.parametrize("planes", [3, 4, 5])
def test_automorphism_orders_agree_with_relabellings(planes):
    for arrangement in census(planes):
        assert identify(arrangement).automorphisms == automorphisms_by_force(arrangement)


@pytest.mark.parametrize(
    ("arrangement", "name"),
    [
        (families.braid(4), "braid A3"),
        (families.near_pencil(7), "near-pencil"),
        (families.coordinate(3), "coordinate planes"),
        (families.simplicial(7, 1), "A(7, 1)"),
    ],
)
def test_usual_names(arrangement, name):
    assert name in identify(arrangement).names


def test_the_nine_mirrors_of_the_cube_have_their_name():
    found = identify(families.type_b(3))
    assert found.names == ("reflection B3", "A(9, 1)")
    assert (found.automorphisms, found.t_vector) == (24, {2: 6, 3: 4, 4: 3})


def test_what_has_no_type_is_refused():
    with pytest.raises(InputError):
        identify(Arrangement([], dimension=3))


#: OEIS A241600, lines of the affine plane, from one line on.
AFFINE = {1: 1, 2: 2, 3: 4, 4: 9, 5: 47, 6: 791, 7: 37_830}
#: OEIS A090338, those in general position.
AFFINE_SIMPLE = {1: 1, 2: 1, 3: 1, 4: 1, 5: 6, 6: 43, 7: 922, 8: 38_609}


@pytest.mark.parametrize(
    ("m", "simple"),
    [
        *((m, False) for m in range(1, 7)),
        *((m, True) for m in range(1, 8)),
        pytest.param(7, False, marks=pytest.mark.slow),
        pytest.param(8, True, marks=pytest.mark.slow),
    ],
)
def test_affine_lines_have_published_numbers_of_classes(m, simple):
    assert catalogue.line_count(m, simple=simple) == (AFFINE_SIMPLE if simple else AFFINE)[m]


def moved(lines: Arrangement) -> Arrangement:
    """The lines elsewhere, none of them through the origin but by chance."""
    offsets = [7001 * int(a) + 7919 * int(b) for a, b in lines.normals]
    pairs = zip(lines.offsets, offsets, strict=True)
    return Arrangement(lines.normals, [x + y for x, y in pairs])


@pytest.mark.parametrize("m", range(1, 6))
def test_each_class_of_affine_lines_is_listed_once(m):
    listed = [moved(lines) for lines in catalogue.lines(m)]
    labels = {identify(lines).label for lines in listed}
    assert len(labels) == len(listed) == AFFINE[m]
    assert all(len(lines.distinct) == m and lines.dimension == 2 for lines in listed)
    plain = {identify(lines).label for lines in listed if lines.is_simple}
    assert plain == {identify(moved(lines)).label for lines in catalogue.lines(m, simple=True)}
    source = Random(m)
    drawn = set()
    for _ in range((0, 10, 30, 100, 25, 10)[m]):
        rows = [[source.randint(-2, 2) for _ in range(3)] for _ in range(m)]
        if all(any(row[:2]) for row in rows):
            lines = Arrangement([row[:2] for row in rows], [row[2] for row in rows])
            if len(lines.distinct) == m and not lines.is_central:
                drawn.add(identify(lines).label)
    assert drawn <= labels
    assert m > 3 or len(drawn) == len(labels)


@pytest.mark.parametrize("m", [2, 3, 4])
def test_automorphisms_of_affine_lines_are_those_of_their_regions(m):
    for lines in map(moved, catalogue.lines(m)):
        known = identify(lines).automorphisms
        regions = {region.signs for region in lines.regions()}
        kept = sum(
            {tuple(s * signs[k] for s, k in zip(sides, order, strict=True)) for signs in regions}
            == regions
            for order in itertools.permutations(range(m))
            for sides in itertools.product((1, -1), repeat=m)
        )
        assert known == (None if lines.rank == 1 else kept)


def test_number_of_affine_lines_is_checked():
    with pytest.raises(InputError, match="1 to 8 lines of the plane"):
        catalogue.line_count(9)


def test_affine_lines_are_identified_by_cone_and_infinity(run):
    square = Arrangement([[1, 0], [1, 0], [0, 1], [0, 1], [0, 2]], [0, 1, 0, 1, 2])
    found = identify(square)
    assert (found.planes, found.rank, found.t_vector) == (4, 2, {2: 4})
    assert found.f_vector == square.faces().f_vector == (4, 12, 9)
    assert found.automorphisms == 8  # of a square, where two opposite sides may change places
    assert found.order.count(len(square)) == 1
    moved = Arrangement([[2, 3], [1, 1], [2, 3], [1, 1]], [0, 5, 1, 3])
    assert identify(moved).label == found.label
    assert found.label.endswith("at infinity")
    parallel = identify(Arrangement([[1, 0]] * 3, [1, 2, 3]))
    assert (parallel.label, parallel.automorphisms) == ("3 parallel", None)
    assert "at infinity" in run("identify shi-a2-affine")
    high = identify(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1]))
    assert (high.label, high.infinity, high.is_simple, high.rank) == ("", None, True, 3)


def pappus(ninth: int) -> dict[tuple[int, int, int], int]:
    """The signs of Pappus's nine points, with the ninth collinear triple given a sign."""
    first, second = [(1, 0, 0), (1, 1, 0), (1, 3, 0)], [(1, 0, 1), (1, 2, 1), (1, 5, 1)]
    crossings = [
        np.cross(np.cross(first[i], second[j]), np.cross(first[j], second[i]))
        for i, j in ((0, 1), (0, 2), (1, 2))
    ]
    signs = chirotope_of(np.array([*first, *second, *crossings], dtype=np.int64)).tolist()
    found = dict(zip(map(tuple, triples(9).tolist()), signs, strict=True))
    assert found[6, 7, 8] == 0
    return found | {(6, 7, 8): ninth}


def test_pappus_realizable_and_non_pappus_not():
    assert final_polynomial(pappus(0), 9) is None
    for sign in (1, -1):
        proof = final_polynomial(pappus(sign), 9)
        assert proof is not None
        assert proves_no_coordinates(pappus(sign), proof)
        assert not proves_no_coordinates(pappus(0), proof)


def test_a_changed_proof_is_refused():
    signs = pappus(1)
    proof = final_polynomial(signs, 9)
    assert proof is not None
    for k, comparison in enumerate(proof):
        for changed in (
            comparison._replace(times=comparison.times + 1),
            comparison._replace(smaller=comparison.larger, larger=comparison.smaller),
            comparison._replace(relation=(*comparison.relation[:4], comparison.relation[0])),
        ):
            assert not proves_no_coordinates(signs, (*proof[:k], changed, *proof[k + 1 :]))
    assert not proves_no_coordinates(signs, proof[:-1])
    assert not proves_no_coordinates(signs, ())
    assert not proves_no_coordinates(signs, [OrderedProducts((0, 1, 2, 3, 4), 0, 3, 1)])


def test_forged_proofs_are_refused_though_their_products_cancel():
    """One comparison of each does not follow from the signs, or none is strict."""
    # Points in convex position: the three terms of a relation with a first are +, -, +.
    convex = dict.fromkeys(map(tuple, triples(6).tolist()), 1)
    one = (0, 1, 2, 3, 4)
    strict = [
        OrderedProducts((a, *rest), smaller, 1, 1)
        for a in (0, 5)
        for rest in itertools.combinations([x for x in range(6) if x != a], 4)
        for smaller in (0, 2)
    ]
    changes = []
    for (a, b, c, d, e), smaller, _, _ in strict:
        last, first = ((a, b, c), (a, d, e)), ((a, b, e), (a, c, d))
        sides = ((a, b, d), (a, c, e)), last if smaller == 0 else first
        counted = [Counter(tuple(sorted(x)) for x in side) for side in sides]
        changes.append([counted[0][x] - counted[1][x] for x in convex])
    found = [x for x in sympy.Matrix(changes).T.nullspace() if sum(x)]
    weights = list(found[0] * sympy.ilcm(*(x.q for x in found[0])) * sympy.sign(sum(found[0])))
    # Points 0 to 3 on a line: products that are all 0 say nothing.
    line = {x: int(x[2] == 4) for x in itertools.combinations(range(5), 3)}
    zeros = [OrderedProducts((4, 0, 1, 2, 3), 2, 1, 1)]
    zeros += [OrderedProducts((a, 1 - a, 2, 4, 3), 2 - 2 * a, 2 * a, 1) for a in (0, 1)]
    negative = [
        comparison._replace(times=int(x)) for comparison, x in zip(strict, weights, strict=True)
    ]
    for signs, proof in (
        (convex, negative),
        (convex, [OrderedProducts(one, 0, 1, 1), OrderedProducts(one, 1, 0, 1)]),
        (convex | {(0, 3, 4): 0}, [OrderedProducts(one, 1, 2, 1), OrderedProducts(one, 1, 2, -1)]),
        (convex | {(0, 1, 3): -1}, [OrderedProducts(one, 0, 1, 1), OrderedProducts(one, 1, 0, 1)]),
        *((convex, [OrderedProducts(one, *sides, 1)]) for sides in ((0, 3), (0, -1), (0, 0))),
        (convex, [OrderedProducts(one, 0, 1, 0)]),
        (convex, [OrderedProducts((0, *x), 0, 1, 1) for x in ((2, 1, 3, 4), (4, 1, 3, 2))]),
        (line, zeros),
    ):
        assert not proves_no_coordinates(signs, proof)


def test_verified_program_gets_signs_and_proof(monkeypatch):
    proof = [OrderedProducts((0, 1, 2, 3, 4), 2, 1, 7)]
    document = {"schema_version": 1, "certificate": "no coordinates"}
    document |= {"proof": [[0, 1, 2, 3, 4, 2, 1, 7]]}
    for signs, text, elements in (([1], "+", 3), ([0, -1] * 5, "0-" * 5, 5)):
        due = document | {"signs": text, "elements": elements}
        assert final_document(signs, proof) == due
        for said in (("accepted", "no coordinates"), ("accepted", "no weights"), ("refused", "")):

            def ask(*arguments, text, due=due, said=said):
                assert arguments == ("-",)
                assert json.loads(text) == due
                return said

            monkeypatch.setattr(final_polynomials, "ask_proved", ask)
            assert proved_no_coordinates(signs, proof) == (said[1] == "no coordinates")


def test_three_sign_comparisons_prove_nonrealizable():
    signs = {x: -1 if x == (1, 3, 4) else 1 for x in itertools.combinations(range(5), 3)}
    proof = [
        OrderedProducts((a, *(x for x in range(5) if x != a)), smaller, 3 - smaller, times)
        for a, smaller, times in ((0, 2, 1), (1, 1, 1), (2, 2, 1), (0, 2, 0))
    ]
    assert proves_no_coordinates(signs, proof)
    assert final_polynomial(signs, 5)


def test_comparisons_are_those_that_signs_of_vectors_force():
    """By all small numbers whose sum is 0, as that of the three products."""
    source, sums = (
        np.random.default_rng(0),
        np.array([(x, y, -x - y) for x in range(-3, 4) for y in range(-3, 4)]),
    )
    for _ in range(20):
        vectors, due = source.integers(-2, 3, (5, 3)), set()
        for a in range(5):
            b, c, d, e = (x for x in range(5) if x != a)
            left = np.linalg.det(vectors[[[a, b, c], [a, b, d], [a, b, e]]]).round()
            right = np.linalg.det(vectors[[[a, d, e], [a, c, e], [a, c, d]]]).round()
            parts = left * right * (1, -1, 1)
            assert not parts.sum()
            like = abs(sums[(np.sign(sums) == np.sign(parts)).all(axis=1)])
            for i, j in itertools.permutations(range(3), 2):
                strict = (like[:, i] < like[:, j]).all()
                if parts[i] and (strict or (i < j and (like[:, i] == like[:, j]).all())):
                    due.add((OrderedProducts((a, b, c, d, e), i, j, 1), strict))
        names = map(tuple, triples(5).tolist())
        signs = dict(zip(names, chirotope_of(vectors).tolist(), strict=True))
        assert set(_comparisons(signs, 5)) == due


@pytest.mark.parametrize("planes", [5, 6, 7])
def test_no_type_with_coordinates_has_a_proof_that_it_has_none(planes):
    rows = map(tuple, triples(planes).tolist())
    keys = list(rows)
    for signs in chirotopes(planes)[::7]:
        assert final_polynomial(dict(zip(keys, signs.tolist(), strict=True)), planes) is None


#: SHA-256 of the catalogue's representatives in its order, one a line ([FinschiFukuda2002]).
CATALOGUE = {
    3: "a318c24216defe20",
    4: "ab7334dea02112c7",
    5: "11484f072570b9be",
    6: "39e054da2dd9165f",
    7: "293ff9b24a9e62fa",
    8: "108e8cd473436728",
}


@pytest.mark.parametrize("planes", [3, 4, 5, 6, 7, pytest.param(8, marks=pytest.mark.slow)])
def test_representatives_match_finschi_and_fukuda(planes):
    found = finschi_fukuda.texts(finschi_fukuda.representatives(chirotopes(planes), planes))
    numbers = [finschi_fukuda.number(planes, place) for place in range(PUBLISHED[planes])]
    listed = [text for _, text in sorted(zip(numbers, found, strict=True))]
    assert sha256("\n".join(listed).encode()).hexdigest().startswith(CATALOGUE[planes])
    assert workshop.numbers(planes).tolist() == numbers


def test_numbers_of_nine_planes_rise_with_their_representatives():
    numbers = [finschi_fukuda.number(9, place) for place in range(PUBLISHED[9])]
    assert len(set(numbers)) == len(numbers)
    assert 1 <= min(numbers) < max(numbers) <= 461_053
    chosen = np.sort(np.random.default_rng(0).choice(len(numbers), 300, replace=False))
    words = finschi_fukuda.representatives(catalogue.chirotopes(9, chosen), 9)
    listed = sorted(range(300), key=lambda k: words[k].tolist())
    assert listed == sorted(range(300), key=lambda k: numbers[chosen[k]])


def test_four_triple_points_have_printed_representative():
    found = identify(families.braid(4))
    assert (found.finschi_fukuda, found.chirotope) == (13, "0++++++0+++++++0+0--")


def test_the_command_prints_the_type(run, tmp_path):
    found = run.json("identify braid-a3")
    assert (found["type"], found["automorphisms"], found["f_vector"]) == (3, 24, [1, 14, 36, 24])
    ten = tmp_path / "ten.json"
    ten.write_text(json.dumps(families.generic(10).to_dict()))
    assert "not in the catalogue" in run("identify", ten)


def test_identify_says_simple_and_simplicial_each_in_a_row(run):
    rows = dict(line.split(maxsplit=1) for line in run("identify braid-a3").splitlines())
    assert (rows["simple"], rows["simplicial"]) == ("no", "yes")
