"""All faces of every dimension: known values, brute force, and laws."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import combinations
from typing import Any

import pytest
import sympy
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
    "coordinate hyperplanes of R^6": (
        Arrangement([[int(i == j) for j in range(6)] for i in range(6)]),
        tuple(math.comb(6, k) * 2**k for k in range(7)),
    ),
}


@pytest.mark.parametrize(("planes", "expected"), KNOWN.values(), ids=KNOWN.keys())
def test_known_f_vectors(planes: Arrangement, expected: tuple[int, ...]) -> None:
    assert planes.f_vector == expected
    assert tuple(len(planes.faces(k)) for k in range(planes.dimension + 1)) == expected


@pytest.mark.parametrize("m", [3, 4, 5, 6, 7, 8, 9, 12])
def test_generic_central_planes_of_space(m: int) -> None:
    """m great circles in general position: m(m-1) points, twice as many arcs, and Euler."""
    planes = Arrangement(moment_curve(m, 3))
    assert planes.f_vector == (1, m * (m - 1), 2 * m * (m - 1), m * m - m + 2)


@pytest.mark.parametrize(("m", "d"), [(4, 2), (6, 3), (6, 4), (6, 5)])
def test_generic_affine_planes_attain_the_bound(m: int, d: int) -> None:
    planes = Arrangement([row[:-1] for row in moment_curve(m, d + 1, 1)], [t**d for t in range(m)])
    assert planes.is_simple
    assert planes.f_vector == tuple(bound(m, d, k) for k in range(d + 1))


def bound(n: int, d: int, k: int) -> int:
    """The right-hand side of [HaasHeger2018], Eq. 11 (Fukuda, Saito, Tamura, Tokuyama 1991)."""
    return math.comb(n, d - k) * sum(math.comb(n - d + k, i) for i in range(k + 1))


@settings(max_examples=120, deadline=None)
@given(arrangements(dimensions=(1, 3), planes=(0, 5)))
def test_sign_vectors_are_those_of_brute_force(planes: Arrangement) -> None:
    assert sign_vectors(planes) == oracle.sign_vectors(planes)


@settings(max_examples=25, deadline=None)
@given(arrangements(dimensions=(4, 5), planes=(0, 5)))
def test_sign_vectors_are_those_of_brute_force_in_higher_dimensions(planes: Arrangement) -> None:
    assert sign_vectors(planes) == oracle.sign_vectors(planes)


@pytest.mark.campaign
@settings(max_examples=100, deadline=None)
@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_every_face_is_where_it_says(planes: Arrangement) -> None:
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


@settings(max_examples=100, deadline=None)
@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_counts_agree_with_zaslavskys_theorem(planes: Arrangement) -> None:
    """`counts` works by ranks alone and enumerates nothing."""
    assert planes.f_vector == counts.f_vector(planes)


@settings(max_examples=100, deadline=None)
@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_euler_relation(planes: Arrangement) -> None:
    """The faces part R^d into open cells, so their alternating sum is (-1)^d."""
    alternating = sum((-1) ** k * f for k, f in enumerate(planes.f_vector))
    assert alternating == (-1) ** planes.dimension


@settings(max_examples=100, deadline=None)
@given(arrangements(dimensions=(1, 5), planes=(0, 7)))
def test_zaslavskys_bound(planes: Arrangement) -> None:
    n, d = len(planes.distinct), planes.dimension
    for k, f in enumerate(planes.f_vector):
        assert f <= (bound(n, d, k) if n >= d - k else 0)


@settings(max_examples=80, deadline=None)
@given(arrangements(dimensions=(1, 5), planes=(0, 6), central=True))
def test_central_arrangements_are_symmetric_and_closed_under_composition(
    planes: Arrangement,
) -> None:
    faces = sign_vectors(planes)
    assert {tuple(-s for s in signs) for signs in faces} == faces
    some = sorted(faces)[::7]
    for one in some:
        for other in some:
            assert tuple(a or b for a, b in zip(one, other, strict=True)) in faces


@settings(max_examples=60, deadline=None)
@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_permutation_sign_change_and_scaling(data: st.DataObject, planes: Arrangement) -> None:
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


@settings(max_examples=60, deadline=None)
@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_affine_change_of_coordinates(data: st.DataObject, planes: Arrangement) -> None:
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


@settings(max_examples=80, deadline=None)
@given(st.data(), arrangements(dimensions=(1, 4), planes=(1, 6)))
def test_deletion_and_restriction(data: st.DataObject, planes: Arrangement) -> None:
    """Forgetting a plane projects the sign vectors; those that vanish on it live in the plane."""
    i = data.draw(st.integers(0, len(planes) - 1))
    d, signs = planes.dimension, sign_vectors(planes)
    others = [j for j in range(len(planes)) if j != i]
    deleted = Arrangement(
        [planes.normals[j] for j in others], [planes.offsets[j] for j in others], dimension=d
    )
    assert sign_vectors(deleted) == {s[:i] + s[i + 1 :] for s in signs}
    inside = {s[:i] + s[i + 1 :] for s in signs if s[i] == 0}
    if d > 1:
        assert restricted_sign_vectors(planes, i) == inside
    if not any(planes.class_of[j] == planes.class_of[i] for j in others):
        regions = len(deleted.regions()) + sum(
            face.dimension == d - 1 for face in planes.faces() if face.signs[i] == 0
        )
        assert len(planes.regions()) == regions


def restricted_sign_vectors(planes: Arrangement, i: int) -> SignVectors:
    """Sign vectors, over the other planes, of the arrangement that they cut in plane i."""
    normal, offset = planes.normals[i], planes.offsets[i]
    size = sum(x * x for x in normal)
    origin = [x * offset / size for x in normal]
    kernel = sympy.Matrix([[sympy.Rational(x.numerator, x.denominator) for x in normal]])
    basis = [[Fraction(int(x.p), int(x.q)) for x in vector] for vector in kernel.nullspace()]
    rows: list[Any] = []
    signs: dict[int, int] = {}
    for j in (j for j in range(len(planes)) if j != i):
        here = planes.normals[j]
        row = [sum(a * b for a, b in zip(here, vector, strict=True)) for vector in basis]
        constant = planes.offsets[j] - sum(a * x for a, x in zip(here, origin, strict=True))
        if any(row):
            rows.append((row, constant))
        else:  # parallel to plane i, or equal to it: one sign all over
            signs[j] = (constant < 0) - (constant > 0)
    cut = Arrangement([r for r, _ in rows], [c for _, c in rows], dimension=planes.dimension - 1)
    found = set()
    for face in cut.faces():
        moving = iter(face.signs)
        found.add(
            tuple(signs[j] if j in signs else next(moving) for j in range(len(planes)) if j != i)
        )
    return found


HUGE = 10**30


@pytest.mark.parametrize(
    ("last", "expected"),
    [((1, 1, 2 * HUGE), (0, 1, 6, 6)), ((1, 1, 2 * HUGE + 1), (1, 6, 12, 8))],
)
def test_a_difference_of_one_in_thirty_digits_counts(
    last: tuple[int, int, int], expected: tuple[int, ...]
) -> None:
    assert Arrangement([(1, 0, HUGE), (0, 1, HUGE), last]).f_vector == expected


@pytest.mark.parametrize(
    ("last", "expected"),
    [((1, 1, "2"), (1, 6, 6)), ((1, 1, f"2.{'0' * 29}1"), (3, 9, 7))],
)
def test_lines_that_miss_a_point_by_little(
    last: tuple[int, int, str], expected: tuple[int, ...]
) -> None:
    lines = [(1, 0, "1"), (0, 1, "1"), last]
    assert Arrangement([line[:2] for line in lines], [b for *_, b in lines]).f_vector == expected


@settings(max_examples=20, deadline=None)
@given(
    arrangements(dimensions=(3, 3), planes=(3, 8), central=True),
    st.integers(HUGE // 10, HUGE),
    st.integers(HUGE // 10, HUGE),
)
def test_thirty_digit_entries_by_a_shear(planes: Arrangement, s: int, t: int) -> None:
    """A shear keeps all sign vectors and makes the entries large."""
    sheared = [(a, b + s * a, c + t * b) for a, b, c in planes.normals]
    assert sign_vectors(Arrangement(sheared)) == sign_vectors(planes)


def test_faces_come_lowest_dimension_first_and_regions_last() -> None:
    planes = Arrangement(moment_curve(4, 3))
    dimensions = [face.dimension for face in planes.iter_faces()]
    assert dimensions == sorted(dimensions)
    assert planes.regions() == planes.faces()[-len(planes.regions()) :]
    assert tuple(planes.iter_faces(1)) == planes.faces(1)
