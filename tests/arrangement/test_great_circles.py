"""Great circles: known planes, another engine, every rank, and faults that `validate` names."""

from collections.abc import Callable
from dataclasses import replace
from itertools import chain, pairwise
from typing import Any

import numpy as np
import pytest

from arrangement import Arrangement, ArrangementError, InputError
from arrangement.counts import f_vector
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.rank import determinant

Normals = list[tuple[int, ...]]
Arrays = dict[str, Any]

COORDINATES = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
B3 = [*COORDINATES, (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)]
A3 = [(1, -1, 0), (1, 0, -1), (0, 1, -1), *COORDINATES]  # braid arrangement of four letters
GENERIC = [(1, t, t * t) for t in range(-3, 4)]  # moment curve: any three are independent
PENCIL = [(1, t, 0) for t in range(5)]
NEAR_PENCIL = [*PENCIL, (0, 0, 1)]
COINCIDENT = [(1, 0, 0), (0, 1, 0), (-2, 0, 0), (0, 0, 1), (0, 3, 0), (1, 1, 1), (-1, -1, -1)]


def sphere(normals: list[tuple[int, ...]]) -> SphereArrangement:
    made = sphere_arrangement(Arrangement(normals, dimension=3))
    made.validate()
    return made


def test_boundaries_of_all_regions_have_each_half_edge_once():
    incidence = sphere(NEAR_PENCIL).incidence
    around = [incidence.boundary(region).tolist() for region in range(incidence.region_count)]
    assert sorted(chain(*around)) == list(range(2 * incidence.arc_count))
    for region, (degree, cycle) in enumerate(zip(incidence.region_degree, around, strict=True)):
        assert len(cycle) == degree
        assert {*incidence.region[cycle]} == {region}


def test_crossings_of_a_circle_are_its_vertices_in_order():
    made = sphere(B3)
    for circle, normal in enumerate(made.circle_normals):
        around = made.incidence.crossings(circle).tolist()
        on = [v for v in range(made.vertex_count) if not dot(normal, made.ray(v))]
        assert sorted(around) == on
        for v, w in pairwise([*around, around[0]]):
            assert determinant([normal, made.ray(v), made.ray(w)]) > 0


@pytest.mark.parametrize("normal", [*COORDINATES, (1, 1, 0), (0, 1, 1), (1, 0, 2)])
def test_one_plane_has_one_closed_arc_without_vertices(normal):
    made = sphere([normal, tuple(-2 * x for x in normal)])
    assert made.incidence.origin.tolist() == [-1, -1]
    assert made.incidence.boundary(0).tolist() == [0]
    assert [made.region_signs(r) for r in range(2)] == [(1, -1), (-1, 1)]
    assert made.arrangement.signs_at(made.arc_witness(0)) == (0, 0)
    assert made.arc_witness(0) != (0, 0, 0)


@pytest.mark.parametrize("normals", [B3, COINCIDENT, PENCIL, PENCIL[:2], [(0, 0, -2)]])
def test_points_of_faces_have_their_signs_in_every_rank(normals):
    planes = Arrangement(normals)
    faces = planes.faces(engine="great-circles")
    assert faces.f_vector == f_vector(planes)
    assert len({*map(bytes, faces.signs)}) == len(faces)
    assert (np.sign(faces.points[:, :3] @ np.array(normals).T) == faces.signs).all()


@pytest.mark.parametrize("normals", [GENERIC[:4], PENCIL])
def test_witnesses_of_one_arc_or_region_are_inside_it(normals):
    made = sphere(normals)
    planes = made.arrangement
    arcs = [planes.signs_at(made.arc_witness(arc)) for arc in range(made.incidence.arc_count)]
    regions = [made.region_signs(region) for region in range(made.incidence.region_count)]
    assert sorted(arcs) == sorted(face.signs for face in planes.faces(2))
    assert sorted(regions) == sorted(face.signs for face in planes.faces(3))


def test_other_dimensions_and_affine_planes_are_refused():
    with pytest.raises(InputError, match=r"R\^4.*R\^3"):
        sphere_arrangement(Arrangement([(1, 0, 0, 0)]))
    with pytest.raises(InputError, match="plane 1 misses the origin"):
        sphere_arrangement(Arrangement(COORDINATES, [0, 2, 0]))


def test_the_arrays_cannot_be_changed():
    made = sphere(B3)
    with pytest.raises(ValueError, match="read-only"):
        made.incidence.next[0] = 1
    with pytest.raises(ValueError, match="read-only"):
        made.rays[0] = 0


def faulty(normals: Normals, change: Callable[[Arrays], object]) -> SphereArrangement:
    """Return an arrangement whose arrays a function has changed."""
    good = sphere_arrangement(Arrangement(normals))
    arrays = {name: getattr(good.incidence, name).copy() for name in ARRAYS}
    rays = good.rays.copy()
    change(arrays | {"rays": rays})
    return with_parts(good, replace(good.incidence, **arrays), rays)


def with_parts(good, incidence, rays) -> SphereArrangement:
    found = SphereArrangement(good.arrangement, incidence, good._crossings, good.circle_normals)
    found.__dict__["rays"] = rays
    return found


def put(name: str, places: Any, others: Any) -> Callable[[Arrays], object]:
    """Return a function that gives some entries of an array the values of others."""
    return lambda arrays: arrays[name].__setitem__(places, arrays[name][others])


def same(name: str, one: int, other: int) -> Callable[[Arrays], object]:
    """Return a function that gives what has one number another one."""
    return lambda arrays: arrays[name].__setitem__(arrays[name] == one, other)


def rays(places: list[int], others: list[int], factor: int = 1) -> Callable[[Arrays], object]:
    """Return a function that gives some lines the rays of others."""

    def change(arrays: Arrays) -> None:
        half = len(arrays["rays"]) // 2
        for first in (0, half):
            at, there = ([first + k for k in x] for x in (places, others))
            arrays["rays"][at] = factor * arrays["rays"][there]

    return change


ARRAYS = ("next", "origin", "region", "leader")
FAULTS: list[tuple[Normals, Callable[[Arrays], object], str]] = [
    *(
        (normals, change, named)
        for normals in (B3, GENERIC, NEAR_PENCIL)
        for change, named in (
            (put("next", 3, 4), "follows exactly one other"),
            (put("next", [0, 5], [5, 0]), "leads on from its end"),
            (put("origin", -1, 0), "leads on from its end"),
            (put("region", -1, 0), "stays in one region"),
            (put("leader", [0, 5], [5, 0]), "leader lies on its region"),
        )
    ),
    (B3, same("region", 47, 1), r"leader lies on its region: region \d+"),
    (GENERIC, same("origin", 1, 0), "each vertex has arcs"),
    (GENERIC, lambda arrays: np.negative(arrays["rays"], out=arrays["rays"]), "first ray of a li"),
    (GENERIC, lambda arrays: arrays["rays"].__setitem__(0, (1, 0, 0)), "antipodal rays are oppos"),
    (GENERIC, lambda arrays: np.abs(arrays["rays"], out=arrays["rays"]), "antipodal rays"),
    (GENERIC, rays([0, 1], [1, 0]), "on its circle: arc"),
    (GENERIC, rays([1], [0], 2), "all rays are different"),
]


@pytest.mark.parametrize(("normals", "change", "named"), FAULTS)
def test_a_fault_is_named(normals, change, named):
    with pytest.raises(ArrangementError, match=named):
        faulty(normals, change).validate()


def test_a_wrong_number_of_regions_is_found():
    good = sphere_arrangement(Arrangement(PENCIL))
    incidence = good.incidence
    region = np.where(incidence.region == len(incidence.leader) - 1, 0, incidence.region)
    fewer = replace(incidence, region=region.astype(np.int32), leader=incidence.leader[:-1].copy())
    with pytest.raises(ArrangementError, match="one boundary cycle"):
        with_parts(good, fewer, good.rays.copy()).validate()


def test_the_incidence_of_another_arrangement_does_not_fit():
    """Same numbers of faces, other geometry: the topology passes and the geometry fails."""
    left = sphere_arrangement(Arrangement(GENERIC))
    mirrored = [(x, -z, y) for x, y, z in reversed(GENERIC)]
    right = sphere_arrangement(Arrangement(mirrored))
    assert left.vertex_count == right.vertex_count
    with pytest.raises(ArrangementError, match="arc"):
        with_parts(right, left.incidence, right.rays.copy()).validate()
