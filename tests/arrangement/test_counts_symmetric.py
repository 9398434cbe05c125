"""Whitney numbers by orbits of flats against the lattice, enumeration, subsets, points, print."""

import itertools
import math
import random
from collections.abc import Iterator

import networkx as nx
import numpy as np
import pytest
import sympy
from hypothesis import given
from sympy.combinatorics import Permutation, PermutationGroup
from sympy.functions.combinatorial.numbers import stirling

from arrangement import Arrangement, InputError, NumberField, counts, families
from arrangement.counts.configuration import configuration
from arrangement.counts.modular import ModularVectors, _inverses
from arrangement.counts.orbits import automorphisms, symmetric
from arrangement.counts.orbits.automorphisms import Automorphisms, _connected_order
from arrangement.counts.orbits.symmetric import Images, moduli_above
from arrangement.errors import OutOfTimeError
from arrangement.numbers import deadline
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.packing import pack, unpack

from . import oracle
from .strategies import arrangements


def symmetries(planes: Arrangement) -> list[list[int]]:
    """Generators found by search, as permutations of the planes (all of them distinct)."""
    found = Automorphisms(configuration(planes)).generators()
    return [image[: len(planes)].tolist() for image in found]


def group(planes: Arrangement) -> PermutationGroup:
    """The group of the symmetries found."""
    return PermutationGroup(
        [Permutation(range(len(planes))), *map(Permutation, symmetries(planes))]
    )


def by_lattice(planes: Arrangement) -> tuple[int, ...]:
    unsigned = counts.intersection_lattice(planes).whitney_row(0)
    return tuple((-1) ** k * value for k, value in enumerate(unsigned))


def random_planes(seed: int, number: int) -> Iterator[Arrangement]:
    """Planes of every dimension to 6: tiny and huge entries, central and affine, some repeated."""
    source = random.Random(seed)
    for _ in range(number):
        d, bound = source.randint(1, 6), source.choice((1, 1, 1, 2, 9, 10**4, 10**20))
        m, affine = source.randint(0, 10), source.random() < 0.5
        planes = families.random_integer(m, d, bound=bound, seed=source.getrandbits(30))
        if affine:
            offsets = [source.randint(-bound, bound) for _ in range(m)]
            planes = Arrangement(planes.normals, offsets, dimension=d)
        if m and source.random() < 0.3:
            again = [source.randrange(m) for _ in range(2)]
            rows = [*planes.integer_planes, *(planes.integer_planes[i] for i in again)]
            planes = Arrangement([row[:-1] for row in rows], [row[-1] for row in rows])
        yield planes


def agree(planes: Arrangement) -> None:
    numbers = by_lattice(planes)
    assert counts.first_whitney_numbers(planes) == numbers
    assert counts.first_whitney_numbers(planes, symmetry=[]) == numbers
    if 0 < len(planes.distinct) == len(planes):
        found = symmetries(planes)
        assert counts.first_whitney_numbers(planes, symmetry=found) == numbers


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_classes_agree_with_all_other_routes(seed):
    for planes in random_planes(seed, 35):
        agree(planes)
        chi = counts.characteristic_polynomial(planes, symmetry=[])
        assert abs(chi.eval(-1)) == planes.faces().f_vector[-1]
        if len(planes) <= 7:
            assert chi == oracle.by_subsets(planes)
        entries = [abs(x) for plane in planes.integer_planes for x in plane]
        if len(planes) <= 7 and planes.dimension <= 3 and max(entries, default=0) <= 9:
            assert chi == counts.by_points(planes)


@given(arrangements(dimensions=(1, 5), planes=(0, 6)))
def test_classes_count_the_regions_that_enumeration_finds(planes):
    chi = counts.characteristic_polynomial(planes, symmetry=[])
    assert abs(chi.eval(-1)) == planes.faces().f_vector[-1]
    assert chi == oracle.by_subsets(planes)


@pytest.mark.parametrize(
    "planes",
    [
        families.resonance(4),
        families.threshold_functions(3),
        families.coxeter("F4"),
        families.coxeter("D5"),
        families.shi("B3", 2),
        families.catalan("G2"),
        families.semiorder(5),
        families.linial("B3"),
        families.graphical(nx.petersen_graph().subgraph(range(8))),
        families.generic(9, 6),
    ],
    ids=str,
)
def test_symmetric_planes_agree_with_the_lattice(planes):
    agree(planes)


@pytest.mark.parametrize(
    "some",
    [
        [families.resonance(3), families.shi("A2"), families.random_degenerate(7, 3, seed=4)],
        pytest.param(
            [
                families.resonance(4),
                families.coxeter("D4"),
                families.shi("A3"),
                families.threshold(5),
                families.graphical(nx.petersen_graph().subgraph(range(7))),
                *random_planes(3, 12),
            ],
            marks=pytest.mark.slow,
        ),
    ],
    ids=["few", "many"],
)
def test_flats_and_faces_by_classes(some, monkeypatch):
    monkeypatch.setattr(symmetric, "_PLANES_IN_AN_ORBIT", 0)
    for planes in filter(len, some):
        found = symmetric.flats_and_faces(planes, configuration(planes), faces=True)
        assert found is not None
        lattice = counts.intersection_lattice(planes)
        assert found[0] == tuple(map(len, lattice.masks))
        assert found[1] == tuple(map(sum, lattice.whitney_matrix))


def test_numbers_beyond_one_prime_are_told_from_their_residues():
    planes = families.braid(14)
    numbers = symmetric.first_numbers(planes, configuration(planes), None, Deadline())
    assert numbers == tuple((-1) ** k * stirling(14, 14 - k, kind=1) for k in range(14))
    assert max(map(abs, numbers)) > 1 << 34


@pytest.mark.slow
def test_faces_beyond_one_prime_are_told_from_their_residues():
    planes = families.braid(12)
    faces = tuple(math.factorial(12 - k) * stirling(12, 12 - k) for k in range(12))
    assert symmetric.flats_and_faces(planes, configuration(planes), faces=True)[1] == faces
    assert max(faces) > 1 << 32


def test_a_prime_that_divides_a_moebius_value_is_replaced(monkeypatch):
    def with_13(bound, below=1 << 31):
        return [*moduli_above(bound), *([13] if below == 1 << 31 else [])]

    # two triples of planes through a line: mu is -13 at the common line of the first seven
    seven = [[1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [1, 2, 5], [1, -3, 7]]
    planes = Arrangement([*([*row, 0] for row in seven), [0, 0, 0, 1]])
    assert counts.first_whitney_numbers(Arrangement(seven))[-1] == -13
    monkeypatch.setattr(symmetric, "_PLANES_IN_AN_ORBIT", 0)
    expected = symmetric.flats_and_faces(planes, configuration(planes), faces=True)
    monkeypatch.setattr(symmetric, "moduli_above", with_13)
    assert symmetric.flats_and_faces(planes, configuration(planes), faces=True) == expected


@pytest.mark.slow
def test_rays_of_e7_are_parabolic_cosets():
    # D6, A6, A1 A5, A1 A2 A3, A4 A2, D5 A1, E6 (Humphreys, sections 1.15 and 2.11)
    orders = (23040, 5040, 2 * 720, 2 * 6 * 24, 120 * 6, 1920 * 2, 51840)
    faces = counts.f_vector(families.coxeter("E7"))
    assert faces[0] == 1
    assert faces[1] == sum(2903040 // order for order in orders)
    assert faces[6:] == (7 * 2903040 // 2, 2903040)
    assert sum((-1) ** k * number for k, number in enumerate(faces)) == -1


def test_few_symmetries_leave_flats_to_the_lattice():
    planes = families.random_integer(9, 5, seed=1)
    assert symmetric.flats_and_faces(planes, configuration(planes), faces=True) is None
    assert counts.f_vector(planes) == planes.faces().f_vector


# of lines, so without -1; B_n: signed permutations; E8: half the order of the Weyl group
@pytest.mark.parametrize(
    ("planes", "order"),
    [
        (families.resonance(4), math.factorial(5)),
        (families.braid(5), math.factorial(5)),
        (families.type_b(2), 4),
        (families.type_b(4), 2**3 * math.factorial(4)),
        (families.threshold_functions(4), 2**4 * math.factorial(5)),
        (families.coxeter("E6"), 51840),
        (families.coxeter("E8"), 696729600 // 2),
        (families.coordinate(4), 24),
        (families.shi("A2"), 6),
        (families.random_integer(9, 5, seed=1), 1),
    ],
    ids=str,
)
def test_the_whole_group_is_found(planes, order):
    assert group(planes).order() == order


def test_found_automorphisms_permute_the_flats():
    planes = families.shi("B3")
    flats = {flat.planes for level in counts.intersection_lattice(planes).flats for flat in level}
    found = symmetries(planes)
    assert found
    for image in found:
        assert {tuple(sorted(image[i] for i in flat)) for flat in flats} == flats


def test_given_symmetries_are_checked():
    planes = families.braid(4)
    swapped = [planes.integer_planes.index((*e, 0)) for e in _swapped_coordinates(planes)]
    assert counts.first_whitney_numbers(planes, symmetry=[swapped]) == (1, -6, 11, -6)
    with pytest.raises(
        InputError, match=r"symmetry\[0\] takes .* to .*, which is not an automorphism"
    ):
        counts.first_whitney_numbers(planes, symmetry=[[1, 0, 2, 3, 4, 5]])
    for wrong in ([0, 0, 2, 3, 4, 5], [0, 1], ["a", 1, 2, 3, 4, 5]):
        with pytest.raises(InputError, match="each once"):
            counts.first_whitney_numbers(planes, symmetry=[wrong])
    twice = Arrangement([[1, 0], [2, 0], [0, 1], [0, 1]])
    with pytest.raises(InputError, match="keeps them together"):
        counts.first_whitney_numbers(twice, symmetry=[[0, 2, 1, 3]])
    assert counts.first_whitney_numbers(twice, symmetry=[[2, 3, 1, 0]]) == (1, -2, 1)
    assert counts.first_whitney_numbers(Arrangement([], dimension=2), symmetry=[]) == (1,)
    for generic in (families.generic(7, 5), families.coordinate(5)):
        swapped = [1, 0, *range(2, len(generic) - 1), 2]
        with pytest.raises(InputError, match=r"each once|not an automorphism"):
            counts.first_whitney_numbers(generic, symmetry=[swapped])


def _swapped_coordinates(planes: Arrangement) -> list[tuple[int, ...]]:
    """The normals of a braid arrangement with the first and the last coordinate exchanged."""
    rows = [(row[3], row[1], row[2], row[0]) for row in planes.integer_planes]
    return [row if next(x for x in row if x) > 0 else tuple(-x for x in row) for row in rows]


def test_an_affine_symmetry_must_keep_infinity():
    # three lines of a triangle and infinity: four planes of the cone in general position
    triangle = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
    assert group(triangle).order() == 6
    line_and_parallels = Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0])
    with pytest.raises(InputError, match="not an automorphism"):
        counts.first_whitney_numbers(line_and_parallels, symmetry=[[2, 1, 0]])


@pytest.mark.parametrize("planes", [families.braid(4), families.shi("A2")], ids=str)
def test_what_is_completed_is_an_automorphism(planes):
    search = Automorphisms(configuration(planes))
    found, fixed = 0, search._fixed
    for chosen in itertools.permutations(range(len(planes)), len(search._base) - fixed):
        for signs in itertools.product((1, -1), repeat=len(chosen)):
            path = [(plane, 1) for plane in search._base[:fixed]]
            path += zip(chosen, signs, strict=True)
            image = search._complete(path, search._key(path))
            if image is not None:
                search.check_permutations([image])
                found += 1
    assert found


def test_inconsistent_triangle_signs_have_no_vectors():
    ones = np.ones((3, 3), dtype=np.int64)
    one_pair, one_vector = ones.copy(), ones.copy()
    one_pair[0, 1] = one_pair[1, 0] = -1
    one_vector[0, 1:] = one_vector[1:, 0] = -1
    assert not automorphisms._equal_up_to_signs(one_pair, ones)
    assert automorphisms._equal_up_to_signs(one_vector, ones)


@pytest.mark.parametrize(
    ("planes", "number"),
    [
        (families.braid(5), 1),
        (families.type_b(3), 2),
        (families.random_integer(9, 5, seed=1), 9),
        (Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]), 1),
        (Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0]), 2),
    ],
    ids=str,
)
def test_orbits_of_planes(planes, number):
    search = Automorphisms(configuration(planes))
    assert search.orbits(search.generators()) == number
    assert len(search.generators(0)) == 0


@pytest.mark.parametrize("steps", [1, 3, 20])
def test_a_search_takes_the_steps_that_it_may(steps):
    search = Automorphisms(configuration(families.coxeter("E6")))
    search.generators(steps)
    assert search._steps_left == 0


def test_the_search_for_symmetries_is_foreseen(monkeypatch):
    asked = []
    monkeypatch.setattr(
        automorphisms.budget, "check_cost", lambda what, *_, **takes: asked.append((what, takes))
    )
    config = configuration(families.braid(4))
    del asked[:]
    Automorphisms(config)
    (takes,) = [takes for what, takes in asked if "symmetries of 6 planes" in what]
    assert takes == {"steps": pytest.approx(1e7 * (2e-7 * 36 + 2e-6 * 9) * 3), "bytes": 60 * 36}


def test_small_primes_that_lose_minors_are_noticed(monkeypatch):
    def small_ones(self):
        primes = itertools.count(2)
        while True:
            chosen: list[int] = []
            while math.prod(chosen) <= self.hadamard_bound:
                chosen.append(next(p for p in primes if all(p % k for k in range(2, p))))
            yield chosen

    monkeypatch.setattr(ModularVectors, "_prime_sets", small_ones)
    for planes in random_planes(2, 60):
        assert counts.first_whitney_numbers(planes, symmetry=[]) == by_lattice(planes)


def modular_vectors(bits: int, rank: int, count: int, seed: int = 1) -> ModularVectors:
    """Return random vectors with entries of that many bits, the last one the sum of two others."""
    source = random.Random(seed)
    rows = [[source.getrandbits(bits) + 1 for _ in range(rank)] for _ in range(count - 1)]
    rows.append([x + y for x, y in zip(*rows[1:3], strict=True)])
    return ModularVectors([tuple(row) for row in rows], rank)


@pytest.mark.parametrize("rank", [3, 5])
def test_primes_fit_words_and_exceed_the_bound_of_minors(rank):
    for bits in (1, 5, 9, 10, 11, 20, 40):
        vectors = modular_vectors(bits, rank, rank + 3)
        minors = [
            abs(sympy.Matrix(x).det()) for x in itertools.combinations(vectors._vectors, rank)
        ]
        assert max(minors) <= vectors.hadamard_bound
        if vectors.hadamard_bound < 2**20:
            assert next(vectors._prime_sets()) == [sympy.nextprime(vectors.hadamard_bound)]
        for primes in itertools.islice(vectors._prime_sets(), 2):
            assert math.prod(primes) > vectors.hadamard_bound
            assert rank * max(primes) ** 2 < 2**63
        assert rank * max(primes) ** 2 > 2**62


def test_the_bound_over_a_field_is_that_of_norms():
    g = NumberField([-1, -1, 1], [1, 2]).root
    assert ModularVectors([(100, 1), (0, 100), (1, g)], 2).hadamard_bound >= 10001 * 100**2


@pytest.mark.parametrize("size", [1, 300, 10**6, 10**12, "sqrt 5"])
@pytest.mark.parametrize("rank", [1, 2])
def test_covers_are_the_flats_above_also_in_other_coordinates(rank: int, size: int | str):
    """Small vectors, and the same ones times a matrix; the flats by ranks in floats."""
    small = np.array([x for x in itertools.product((0, 1, -1), repeat=4) if x > (0,) * 4])[::2]
    g = NumberField([-1, -1, 1], [1, 2]).root if size == "sqrt 5" else size
    matrix = np.array([[1, g, 2, g], [0, 1, g, 3], [0, 0, 1, g], [0, 0, 0, 1]], dtype=object)
    vectors = ModularVectors([tuple(row) for row in small.astype(object) @ matrix], 4)
    bases = np.array([*itertools.combinations(range(len(small)), rank)])[:: 4**rank]

    def inside(*rows: int) -> list[bool]:
        return [np.linalg.matrix_rank(small[[*rows, k]]) == len(rows) for k in range(len(small))]

    members = np.array([inside(*base) for base in bases])
    found, due = vectors.covers(bases, members), []
    for i, (base, has) in enumerate(zip(bases, members, strict=True)):
        above = {tuple(np.flatnonzero(inside(*base, k) & ~has)) for k in np.flatnonzero(~has)}
        due += [(i, planes) for planes in above]
    for covers, listed in (
        (found, due),
        (found.without(2), [row for row in due if 2 not in row[1]]),
    ):
        rows = [[] for _ in covers.below]
        for cover, member in zip(covers.cover, covers.member, strict=True):
            rows[cover].append(member)
        planes = [tuple(sorted(row)) for row in rows]
        assert sorted(zip(covers.below.tolist(), planes, strict=True)) == sorted(listed)
        assert covers.added.tolist() == list(map(len, planes))
        assert covers.plane.tolist() == [row[0] for row in planes]


@pytest.mark.parametrize("bits", [53, 54])
def test_quotients_are_minors_at_the_double_bound(bits: int):
    rank, prime = 3, sympy.prevprime(math.isqrt(2**bits // 3))
    vectors = modular_vectors(60, rank, 500)
    rows = np.array(vectors._vectors, dtype=object)
    (images,) = vectors._quotients(np.array([[0, k] for k in range(3, 40)]), prime)
    for k, image in enumerate(images.astype(object), 3):
        minors = rows @ np.cross(rows[0], rows[k])
        assert not ((minors * image[1] - minors[1] * image) % prime).any()


def test_inverses_of_any_number_of_residues():
    for count in (0, 1, 2, 31, 32, 33, 63, 64, 65, 131):
        values = np.arange(1, count + 1)
        found = _inverses(values, 1009)
        assert len(found) == count
        assert (found * values % 1009 == 1).all()


def test_labels_leave_room_for_the_index_of_a_vector():
    vectors = modular_vectors(60, 4, 40)
    members = np.eye(1, 40, dtype=np.bool_)
    for prime in (sympy.nextprime(1.2 * 2**28), sympy.nextprime(2**27)):
        labels = vectors._labels(np.array([[0]]), members, [prime])
        assert labels.max() < 2 ** (63 - vectors.index_bits)
        assert len(set(labels[0, 1:].tolist())) == 39


def test_a_time_limit_leaves_what_is_known(monkeypatch):
    monkeypatch.setattr(deadline, "clock", iter(range(1000)).__next__)
    planes = families.random_integer(40, 7, bound=1, seed=3)
    with pytest.raises(OutOfTimeError, match=r"^time limit of 4.5 s: .* are final") as caught:
        counts.characteristic_polynomial(planes, time_limit=4.5)
    assert caught.value.known == (1, -38, 698)
    with pytest.raises(InputError, match="positive number"):
        counts.characteristic_polynomial(planes, time_limit=0)


@pytest.mark.parametrize("planes", [families.braid(5), families.resonance(4)], ids=str)
def test_sets_of_one_plane_have_an_image_for_each_orbit(planes):
    search = Automorphisms(configuration(planes))
    generators = search.generators()
    low = Images(generators).low(np.eye(len(planes), dtype=np.bool_))
    assert len(np.unique(low, axis=0)) == search.orbits(generators) < len(planes)


def test_sets_of_several_words_go_down_in_portions(monkeypatch):
    monkeypatch.setattr(symmetric, "_BATCH", 1)
    turn = np.roll(np.arange(70), 1)
    low = unpack(Images(np.array([turn])).low(np.eye(70, dtype=np.bool_)), 70)
    assert (low.sum(axis=1) == 1).all()


@pytest.mark.parametrize("seed", range(3))
def test_orbit_of_flats_has_few_images_in_any_order(seed):
    normals = list(families.braid(7).normals)
    random.Random(seed).shuffle(normals)
    planes = Arrangement(normals)
    images_of = Images(np.array(symmetries(planes)))
    for rank in range(1, 6):
        masks = counts.intersection_lattice(planes).masks[rank]
        sets = np.array([[mask >> i & 1 for i in range(len(planes))] for mask in masks], np.bool_)
        orbits = sympy.functions.combinatorial.numbers.nT(7, 7 - rank)
        assert orbits <= len(np.unique(images_of.low(sets), axis=0)) <= 2 * orbits


def test_low_images_are_images():
    planes = families.resonance(4)
    generators = np.array(symmetries(planes))
    elements = group(planes).elements
    sets = np.random.default_rng(0).integers(0, 2, (150, len(planes))).astype(np.bool_)
    low = unpack(Images(generators).low(sets), len(planes))
    for before, after in zip(sets, low, strict=True):
        orbit = {frozenset(g(i) for i in np.flatnonzero(before)) for g in elements}
        assert frozenset(np.flatnonzero(after)) in orbit
    assert np.array_equal(unpack(pack(sets), len(planes)), sets)


def test_each_vector_of_a_base_is_next_to_an_earlier_one():
    products = np.eye(5, dtype=np.int64)
    for i, j in ((0, 1), (0, 3), (0, 4), (2, 3)):
        products[i, j] = products[j, i] = 2
    for first in range(5):
        order = _connected_order(products, first)
        assert sorted(order) == list(range(5))
        assert all(products[order[k], order[:k]].any() for k in range(1, 5))
