"""All faces of every dimension: known values, brute force, and laws."""

import math
from itertools import combinations

import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, counts

from . import oracle
from .strategies import (
    NONZERO_RATIONALS,
    RATIONALS,
    arrangements,
    invertible_matrices,
    product,
)

SignVectors = set[tuple[int, ...]]


def sign_vectors(planes: Arrangement) -> SignVectors:
    return {face.signs for face in planes.faces()}


def moment_curve(m: int, d: int, first: int = 0) -> list[list[int]]:
    return [[t**k for k in range(d)] for t in range(first, first + m)]


def differences(n: int) -> list[list[int]]:
    return [[(k == i) - (k == j) for k in range(n)] for i, j in combinations(range(n), 2)]


def type_b(n: int) -> list[list[int]]:
    sums = [[(k == i) + (k == j) for k in range(n)] for i, j in combinations(range(n), 2)]
    return [[int(k == i) for k in range(n)] for i in range(n)] + differences(n) + sums


KNOWN: dict[str, tuple[Arrangement, tuple[int, ...]]] = {
    "no plane in R^1": (Arrangement([], dimension=1), (0, 1)),
    "no plane in R^3": (Arrangement([], dimension=3), (0, 0, 0, 1)),
    "one plane": (Arrangement([[1, 0, 0]]), (0, 0, 1, 2)),
    # [HaasHeger2018] counts 10 for two contacts; only 9 sign vectors differ
    "two planes": (Arrangement([[1, 0, 0], [0, 1, 0]]), (0, 1, 4, 4)),
    "three generic planes": (Arrangement([[1, 0, 0], [0, 1, 0], [1, 2, 3]]), (1, 6, 12, 8)),
    # tangential planes of the four-contact grasp of [HaasHeger2018]: two classes
    "four contacts": (
        Arrangement([[0, 1, -1], [0, 1, -1], [0, -1, -1], [0, -1, -1]]),
        (0, 1, 4, 4),
    ),
    "three points of the line": (Arrangement([[1], [1], [2]], [0, 1, 1]), (3, 4)),
    "parallel planes": (Arrangement([[0, 0, 1], [0, 0, -1]], [0, 1]), (0, 0, 2, 3)),
    # Steiner 1826: n lines in general position cut the plane into 1 + n + C(n, 2) parts
    "four generic lines": (
        Arrangement([[1, 0], [0, 1], [1, 1], [1, -1]], [1, 1, 3, 5]),
        (6, 16, 11),
    ),
    # Steiner: four planes in general position cut space into 15 parts
    "four generic affine planes": (
        Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1]),
        (4, 18, 28, 15),
    ),
    # all planes through one point off the origin: affine in form, central in kind
    "central off the origin": (
        Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [1, 1, 1]),
        (1, 6, 12, 8),
    ),
    # ordered set partitions of 4 and 5 things by blocks: k! S(n, k)
    "braid A3": (Arrangement(differences(4)), (0, 1, 14, 36, 24)),
    "braid A4": (Arrangement(differences(5)), (0, 1, 30, 150, 240, 120)),
    # faces of the barycentric subdivision of the cube; 147 in all (OEIS A080253)
    "reflections B3": (Arrangement(type_b(3)), (1, 26, 72, 48)),
    "reflections B4": (Arrangement(type_b(4)), (1, 80, 464, 768, 384)),
    # Shi: (n + 1)^(n - 1) regions for n = 3, and six vertices by hand
    "Shi A2": (
        Arrangement([[1, 0], [1, 0], [0, 1], [0, 1], [1, 1], [1, 1]], [0, 1, 0, 1, 0, 1]),
        (6, 21, 16),
    ),
    # three planes in each direction: 3 vertices, 4 pieces on every axis line
    "grid of cubes": (
        Arrangement([[1, 0, 0]] * 3 + [[0, 1, 0]] * 3 + [[0, 0, 1]] * 3, [0, 1, 2] * 3),
        (27, 3 * 9 * 4, 3 * 3 * 16, 64),
    ),
    "coordinate hyperplanes of R^6": (
        Arrangement([[int(i == j) for j in range(6)] for i in range(6)]),
        tuple(math.comb(6, k) * 2**k for k in range(7)),
    ),
}


@pytest.mark.parametrize(("planes", "expected"), KNOWN.values(), ids=KNOWN.keys())
def test_known_f_vectors(planes, expected):
    assert planes.f_vector == expected
    assert tuple(len(planes.faces(k)) for k in range(planes.dimension + 1)) == expected


@settings(max_examples=140)
@given(
    arrangements(dimensions=(1, 3), planes=(0, 5)) | arrangements(dimensions=(4, 5), planes=(0, 5))
)
def test_sign_vectors_are_those_of_brute_force(planes):
    assert sign_vectors(planes) == oracle.sign_vectors(planes)


@pytest.mark.campaign
@settings(max_examples=100)
@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_every_face_is_where_it_says(planes):
    """No sign vector twice, the witness has these signs, the dimension is d minus a rank."""
    faces = planes.faces()
    assert len({face.signs for face in faces}) == len(faces)
    for face in faces:
        values = [
            sum(a * x for a, x in zip(normal, face.witness, strict=True)) - offset
            for normal, offset in zip(planes.normals, planes.offsets, strict=True)
        ]
        assert face.signs == tuple((value > 0) - (value < 0) for value in values)
        on = [n for n, s in zip(planes.normals, face.signs, strict=True) if s == 0]
        assert face.dimension == planes.dimension - oracle.rank(on)


@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_permutation_sign_change_and_scaling(data, planes):
    m = len(planes)
    order = data.draw(st.permutations(range(m)))
    factors = [data.draw(NONZERO_RATIONALS) for _ in range(m)]
    changed = Arrangement(
        [[f * x for x in planes.normals[i]] for i, f in zip(order, factors, strict=True)],
        [f * planes.offsets[i] for i, f in zip(order, factors, strict=True)],
    )
    turns = [1 if f > 0 else -1 for f in factors]
    expected = {
        tuple(turn * signs[i] for turn, i in zip(turns, order, strict=True))
        for signs in sign_vectors(planes)
    }
    assert sign_vectors(changed) == expected
    assert changed.f_vector == planes.f_vector


@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_affine_change_of_coordinates(data, planes):
    """With x = M y + t the planes of y have normals n M and offsets b - n . t."""
    d = planes.dimension
    matrix = data.draw(invertible_matrices(d))
    shift = data.draw(st.lists(RATIONALS, min_size=d, max_size=d))
    normals = product([list(n) for n in planes.normals], matrix)
    offsets = [
        b - sum(a * t for a, t in zip(n, shift, strict=True))
        for n, b in zip(planes.normals, planes.offsets, strict=True)
    ]
    changed = Arrangement(normals, offsets)
    assert {(f.signs, f.dimension) for f in changed.faces()} == {
        (f.signs, f.dimension) for f in planes.faces()
    }


@settings(max_examples=80)
@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_deletion_and_restriction(data, planes):
    """Forgetting a plane projects the sign vectors; those that vanish on it live in the plane."""
    i = data.draw(st.integers(0, len(planes) - 1))
    d, signs = planes.dimension, sign_vectors(planes)
    others = [j for j in range(len(planes)) if j != i]
    deleted = Arrangement(
        [planes.normals[j] for j in others], [planes.offsets[j] for j in others], dimension=d
    )
    assert sign_vectors(deleted) == {s[:i] + s[i + 1 :] for s in signs}
    inside = {s for s in signs if s[i] == 0}
    if d > 1:  # planes that are parallel to plane i have one sign all over it
        crossing = [j for j in others if oracle.rank([planes.normals[i], planes.normals[j]]) == 2]
        cut = {tuple(s[j] for j in crossing) for s in inside}
        assert sign_vectors(counts.restriction(planes, i)) == cut
        assert len(cut) == len(inside)
    if not any(planes.class_of[j] == planes.class_of[i] for j in others):
        regions = len(deleted.regions()) + sum(
            face.dimension == d - 1 for face in planes.faces() if face.signs[i] == 0
        )
        assert len(planes.regions()) == regions


HUGE = 10**30


@pytest.mark.parametrize(
    ("last", "expected"),
    [((1, 1, 2 * HUGE), (0, 1, 6, 6)), ((1, 1, 2 * HUGE + 1), (1, 6, 12, 8))],
)
def test_a_difference_of_one_in_thirty_digits_counts(last, expected):
    assert Arrangement([(1, 0, HUGE), (0, 1, HUGE), last]).f_vector == expected


def test_faces_come_lowest_dimension_first_and_regions_last():
    planes = Arrangement(moment_curve(4, 3))
    dimensions = [face.dimension for face in planes.iter_faces()]
    assert dimensions == sorted(dimensions)
    assert planes.regions() == planes.faces()[-len(planes.regions()) :]
    assert tuple(planes.iter_faces(1)) == planes.faces(1)
