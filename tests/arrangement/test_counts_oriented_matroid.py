"""Chirotope, cocircuits, covectors, topes: against brute force and the axioms."""

from itertools import combinations

import pytest
from hypothesis import given

from arrangement import Arrangement, InputError, counts

from . import oracle
from .strategies import arrangements

Signs = tuple[int, ...]


@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_covectors_are_the_sign_vectors_that_occur(planes):
    expected = oracle.sign_vectors(planes)
    assert counts.covectors(planes) == expected
    assert counts.topes(planes) == {signs for signs in expected if 0 not in signs}


@pytest.mark.campaign
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


def test_known_chirotope_of_the_alternating_matroid():
    # all Vandermonde determinants with increasing nodes are positive
    moment = Arrangement([[1, t, t * t] for t in range(6)])
    assert set(counts.chirotope(moment).values()) == {1}


def test_chirotope_of_big_entries_is_exact():
    huge = 10**30
    near = Arrangement([[1, 0, 0], [0, 1, 0], [huge, huge + 1, 1], [huge, huge + 1, 0]])
    assert counts.chirotope(near) == {(0, 1, 2): 1, (0, 1, 3): 0, (0, 2, 3): -1, (1, 2, 3): 1}


def test_chirotope_refuses_affine_planes():
    with pytest.raises(InputError, match="cone"):
        counts.chirotope(Arrangement([[1, 0]], [1]))
