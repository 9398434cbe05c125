"""The characteristic polynomial by points over finite fields."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from sympy import sqrt

from arrangement import Arrangement, InputError, counts
from arrangement.library import families

from . import oracle
from .strategies import arrangements


@pytest.mark.parametrize(
    "planes",
    [
        families.shi(3),
        families.shi("A3"),
        families.type_b(3),
        families.resonance(4),
        families.linial(4),
        families.threshold_functions(3),
        families.coxeter("F4"),
        families.random_degenerate(9, 3, seed=5, affine=True),
        Arrangement([], dimension=2),
        Arrangement([[1, 0], [-2, 0]]),
        families.h3(),
        families.simplicial(15, 5),
        Arrangement([[sqrt(2), 1], [1, sqrt(2)], [1, 0]], [0, sqrt(2), 5]),
    ],
    ids=str,
)
def test_points_over_finite_fields_give_the_polynomial(planes: Arrangement) -> None:
    assert counts.by_points(planes) == counts.characteristic_polynomial(planes)


@settings(max_examples=60, deadline=None)
@given(arrangements(dimensions=(1, 3), planes=(0, 6)))
def test_points_of_random_planes(planes: Arrangement) -> None:
    assert counts.by_points(planes) == oracle.by_subsets(planes)
    for prime in (2, 3, 5):
        assert counts.points_off(planes, prime) == oracle.points_by_hand(planes, prime)


def test_primes_of_bad_reduction_are_refused() -> None:
    planes = Arrangement([[1, 0], [0, 1], [1, 1], [1, -1]])
    with pytest.raises(InputError, match=r"bad reduction: modulo 2 the planes \[2, 3\]"):
        counts.by_points(planes, [2, 5])
    with pytest.raises(InputError, match="4 is no prime"):
        counts.by_points(planes, [3, 4])
    with pytest.raises(InputError, match="give at least 2"):
        counts.by_points(planes, [3, 3])
    with pytest.raises(InputError, match="too large for words"):
        counts.points_off(planes, 2**61 - 1)
    assert counts.by_points(planes, [3, 5]) == counts.characteristic_polynomial(planes)
    with pytest.raises(InputError, match="no image modulo 7"):
        counts.by_points(families.h3(), [7, 11, 19])
    with pytest.raises(InputError, match="bad reduction: modulo 2"):
        counts.by_points(families.simplicial(17, 8), [2, 7, 17])
