"""Chirotope, cocircuits, covectors, topes: against brute force and the axioms."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given, settings

from arrangement import Arrangement, InputError, counts

from . import oracle
from .strategies import arrangements

Signs = tuple[int, ...]


@settings(max_examples=40, deadline=None)
@given(arrangements(dimensions=(1, 4), planes=(0, 5)))
def test_covectors_are_the_sign_vectors_that_occur(planes: Arrangement) -> None:
    assert counts.covectors(planes) == oracle.sign_vectors(planes)


@settings(max_examples=30, deadline=None)
@given(arrangements(dimensions=(1, 4), planes=(0, 7)))
def test_covectors_and_topes_are_the_faces_and_regions(planes: Arrangement) -> None:
    assert counts.covectors(planes) == {face.signs for face in planes.faces()}
    assert counts.topes(planes) == {face.signs for face in planes.regions()}
    assert len(counts.topes(planes)) == counts.region_count(planes)


@pytest.mark.campaign
@settings(max_examples=40, deadline=None)
@given(arrangements(dimensions=(1, 4), planes=(0, 6), central=True))
def test_cocircuits_are_the_nonzero_covectors_of_least_support(planes: Arrangement) -> None:
    nonzero = [x for x in oracle.sign_vectors(planes) if any(x)]

    def support(signs: Signs) -> frozenset[int]:
        return frozenset(i for i, sign in enumerate(signs) if sign)

    least = {x for x in nonzero if not any(support(y) < support(x) for y in nonzero)}
    assert counts.cocircuits(planes) == least


@settings(max_examples=40, deadline=None)
@given(arrangements(dimensions=(1, 4), planes=(1, 6), central=True))
def test_chirotope_is_nonzero_exactly_on_bases(planes: Arrangement) -> None:
    chi = counts.chirotope(planes)
    assert set(chi) == set(combinations(range(len(planes)), planes.rank))
    for chosen, value in chi.items():
        independent = oracle.rank([planes.normals[i] for i in chosen]) == planes.rank
        assert (value != 0) == independent


@settings(max_examples=30, deadline=None)
@given(arrangements(dimensions=(3, 3), planes=(5, 6), central=True))
def test_three_term_grassmann_pluecker_relations(planes: Arrangement) -> None:
    # {a: x y, x z, w y ...}: the three products cannot all have one sign pattern that sums to
    # nonzero; Bjoerner et al., Oriented Matroids, theorem 3.6.2
    chi = dict(counts.chirotope(planes))
    if planes.rank < 3:
        return

    def at(*indices: int) -> int:
        swaps = sum(a > b for a, b in combinations(indices, 2))
        return (-1) ** swaps * chi[tuple(sorted(indices))]

    for a, *four in combinations(range(len(planes)), 5):
        w, x, y, z = four
        products = {
            at(a, w, x) * at(a, y, z),
            -at(a, w, y) * at(a, x, z),
            at(a, w, z) * at(a, x, y),
        }
        assert products == {0} or {-1, 1} <= products


def test_known_chirotope_of_the_alternating_matroid() -> None:
    # all Vandermonde determinants with increasing nodes are positive
    moment = Arrangement([[1, t, t * t] for t in range(6)])
    assert set(counts.chirotope(moment).values()) == {1}


def test_chirotope_of_big_entries_is_exact() -> None:
    huge = 10**30
    near = Arrangement([[1, 0, 0], [0, 1, 0], [huge, huge + 1, 1], [huge, huge + 1, 0]])
    assert counts.chirotope(near) == {(0, 1, 2): 1, (0, 1, 3): 0, (0, 2, 3): -1, (1, 2, 3): 1}


def test_chirotope_refuses_affine_planes() -> None:
    with pytest.raises(InputError, match="cone"):
        counts.chirotope(Arrangement([[1, 0]], [1]))


def test_no_planes_have_one_covector() -> None:
    assert counts.covectors(Arrangement([], dimension=3)) == {()}
