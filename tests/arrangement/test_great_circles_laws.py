"""Laws of great-circle arrangements: what a change of the input does to the output."""

from __future__ import annotations

from collections import Counter

import numpy as np
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from tests.arrangement.strategies import NONZERO_RATIONALS, arrangements, invertible_matrices

CENTRAL = arrangements(dimensions=(3, 3), planes=(0, 9), central=True)
LAW = settings(max_examples=60, deadline=None)


def region_signs(made: SphereArrangement) -> set[tuple[int, ...]]:
    return {made.region_signs(region) for region in range(made.region_count)}


def counts(made: SphereArrangement) -> tuple[int, int, int]:
    return made.vertex_count, made.arc_count, made.region_count


def shape(made: SphereArrangement) -> tuple[Counter[int], Counter[int]]:
    """How many regions have how many arcs, and how many vertices have how many circles."""
    incidence = made.incidence
    return Counter(incidence.region_degree.tolist()), Counter(np.diff(incidence.line_offsets))


@given(CENTRAL)
@LAW
def test_construction_is_valid_and_euler_holds(planes):
    made = sphere_arrangement(planes)
    made.validate()
    if made.rank >= 2:
        assert made.vertex_count - made.arc_count + made.region_count == 2


@given(CENTRAL, st.randoms(use_true_random=False))
@LAW
def test_permuting_planes_permutes_signs(planes, generator):
    places = list(range(len(planes)))
    generator.shuffle(places)
    normals = [planes.normals[i] for i in places]
    made = sphere_arrangement(Arrangement(normals, dimension=3))
    expected = {tuple(s[i] for i in places) for s in region_signs(sphere_arrangement(planes))}
    assert region_signs(made) == expected


@given(CENTRAL, st.data())
@LAW
def test_scaling_a_normal_by_a_negative_number_flips_its_sign_only(planes, data):
    size = len(planes)
    factors = data.draw(st.lists(NONZERO_RATIONALS, min_size=size, max_size=size))
    normals = [
        [factor * x for x in normal] for factor, normal in zip(factors, planes.normals, strict=True)
    ]
    made, before = (
        sphere_arrangement(Arrangement(n, dimension=3)) for n in (normals, planes.normals)
    )
    flips = [1 if factor > 0 else -1 for factor in factors]
    flipped = {
        tuple(f * s for f, s in zip(flips, signs, strict=True)) for signs in region_signs(before)
    }
    assert region_signs(made) == flipped
    assert shape(made) == shape(before)


@given(CENTRAL, invertible_matrices(3))
@LAW
def test_a_rational_change_of_basis_keeps_all_sign_vectors(planes, matrix):
    """Signs of ``(n M) . x`` at x are those of ``n . (M x)``: the same set of sign vectors."""
    normals = [
        [sum(n[k] * matrix[k][j] for k in range(3)) for j in range(3)] for n in planes.normals
    ]
    made, before = (
        sphere_arrangement(Arrangement(n, dimension=3)) for n in (normals, planes.normals)
    )
    made.validate()
    assert region_signs(made) == region_signs(before)
    assert counts(made) == counts(before)
    assert shape(made) == shape(before)


@given(CENTRAL)
@LAW
def test_sign_vectors_come_in_antipodal_pairs_and_are_different(planes):
    made = sphere_arrangement(planes)
    signs = region_signs(made)
    assert len(signs) == made.region_count
    assert {tuple(-s for s in row) for row in signs} == signs


@given(CENTRAL)
@LAW
def test_every_pair_of_circles_meets_in_one_pair_of_vertices(planes):
    incidence = sphere_arrangement(planes).incidence
    meetings: Counter[tuple[int, int]] = Counter()
    for vertex in range(incidence.vertex_count):
        circles = sorted(incidence.circles_at(vertex).tolist())
        meetings.update((a, b) for k, a in enumerate(circles) for b in circles[k + 1 :])
    count = incidence.circle_count
    assert set(meetings) == {(a, b) for a in range(count) for b in range(a + 1, count)}
    assert set(meetings.values()) <= {2}


@given(CENTRAL, st.lists(st.integers(-2, 2), min_size=3, max_size=3).filter(any))
@LAW
def test_adding_a_plane_adds_as_many_regions_as_its_circle_has_arcs(planes, normal):
    """Deletion and restriction: the new circle is cut into arcs, and each splits one region."""
    before = sphere_arrangement(planes)
    made = sphere_arrangement(Arrangement([*planes.normals, normal], dimension=3))
    if made.circle_count == before.circle_count:
        assert counts(made) == counts(before)
    else:
        arcs = len(made.incidence.arcs_of_circle(made.circle_count - 1))
        assert made.region_count == before.region_count + arcs
