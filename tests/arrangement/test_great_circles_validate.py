"""`validate` finds what is wrong and names it: known-bad structures, one fault each."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from arrangement import Arrangement, ArrangementError
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from tests.arrangement.test_great_circles import B3, GENERIC, NEAR_PENCIL, PENCIL


def broken(normals: list[tuple[int, ...]], field: str, change) -> SphereArrangement:
    """Return an arrangement with one array of its incidence changed."""
    good = sphere_arrangement(Arrangement(normals))
    array = getattr(good.incidence, field).copy()
    change(array)
    return with_parts(good, replace(good.incidence, **{field: array}), good.rays.copy())


def with_parts(good, incidence, rays) -> SphereArrangement:
    found = SphereArrangement(good.arrangement, incidence, good._crossings, good.circle_normals)
    found.__dict__["rays"] = rays
    return found


def swap(array):
    array[[0, 5]] = array[[5, 0]]


def repeat(array):
    array[3] = array[4]


def raise_last(array):
    array[-1] = array[0]


@pytest.mark.parametrize("normals", [B3, GENERIC, NEAR_PENCIL])
@pytest.mark.parametrize(
    ("field", "change", "named"),
    [
        ("next", repeat, "follows exactly one other"),
        ("next", swap, "leads on from its end"),
        ("origin", raise_last, "leads on from its end"),
        ("region", raise_last, "stays in one region"),
        ("leader", swap, "leader lies on its region"),
    ],
)
def test_a_fault_in_the_topology_is_named(normals, field, change, named):
    with pytest.raises(ArrangementError, match=named):
        broken(normals, field, change).validate()


def test_two_regions_with_one_name_are_found():
    def merge(region):
        region[region == region.max()] = 1

    with pytest.raises(ArrangementError, match=r"leader lies on its region: region \d+"):
        broken(B3, "region", merge).validate()


def test_a_wrong_number_of_regions_is_found():
    good = sphere_arrangement(Arrangement(PENCIL))
    incidence = good.incidence
    region = np.where(incidence.region == len(incidence.leader) - 1, 0, incidence.region)
    fewer = replace(incidence, region=region.astype(np.int32), leader=incidence.leader[:-1].copy())
    with pytest.raises(ArrangementError, match="one boundary cycle"):
        with_parts(good, fewer, good.rays.copy()).validate()


def test_two_vertices_with_one_name_are_found():
    good = sphere_arrangement(Arrangement(GENERIC))
    origin = good.incidence.origin.copy()
    origin[origin == 1] = 0
    with pytest.raises(ArrangementError, match="each vertex has arcs"):
        with_parts(good, replace(good.incidence, origin=origin), good.rays.copy()).validate()


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (lambda rays: np.negative(rays, out=rays), "first ray of a line is positive"),
        (lambda rays: rays.__setitem__(0, (1, 0, 0)), "antipodal rays are opposite"),
        (lambda rays: rays.__setitem__(slice(None), 3 * abs(rays)), "antipodal rays"),
    ],
)
def test_a_wrong_ray_is_named(change, named):
    good = sphere_arrangement(Arrangement(GENERIC))
    rays = good.rays.copy()
    change(rays)
    with pytest.raises(ArrangementError, match=named):
        with_parts(good, good.incidence, rays).validate()


def test_exchanged_rays_leave_their_circles():
    good = sphere_arrangement(Arrangement(GENERIC))
    rays, lines = good.rays.copy(), good.vertex_count // 2
    for first in (0, lines):
        rays[[first, first + 1]] = rays[[first + 1, first]]
    with pytest.raises(ArrangementError, match="on its circle: arc"):
        with_parts(good, good.incidence, rays).validate()


def test_equal_rays_are_found():
    good = sphere_arrangement(Arrangement(GENERIC))
    rays, lines = good.rays.copy(), good.vertex_count // 2
    for first in (0, lines):
        rays[first + 1] = 2 * rays[first]
    with pytest.raises(ArrangementError, match="all rays are different"):
        with_parts(good, good.incidence, rays).validate()


def test_the_incidence_of_another_arrangement_does_not_fit():
    """Same numbers of faces, other geometry: the topology passes and the geometry fails."""
    left = sphere_arrangement(Arrangement(GENERIC))
    mirrored = [(x, -z, y) for x, y, z in reversed(GENERIC)]
    right = sphere_arrangement(Arrangement(mirrored))
    assert left.vertex_count == right.vertex_count
    with pytest.raises(ArrangementError, match="arc"):
        with_parts(right, left.incidence, right.rays.copy()).validate()
