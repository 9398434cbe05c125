"""Great circles: known arrangements, every rank, coincident planes, input order, bad input."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest

from arrangement import Arrangement, InputError
from arrangement.enumeration.choose import enumerate_faces
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.enumeration.great_circles.signs import unpack

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


@pytest.mark.parametrize(
    ("normals", "vertices", "arcs", "regions"),
    [
        pytest.param(COORDINATES, 6, 12, 8, id="octants"),
        # Coxeter arrangements: the order of the group is the number of regions [Humphreys1990]
        pytest.param(A3, 14, 36, 24, id="A3, 4! regions"),
        pytest.param(B3, 26, 72, 48, id="B3, 2^3 3! regions; CGAL 5.5 one by one gives fewer"),
        # m(m-1) rays, 2m(m-1) facets, m^2-m+2 regions in general position
        pytest.param(GENERIC, 42, 84, 44, id="seven generic planes"),
        pytest.param(NEAR_PENCIL, 12, 30, 20, id="near-pencil: 4(m-1) regions"),
        pytest.param(COINCIDENT, 12, 24, 14, id="four generic planes, three repeated"),
        pytest.param(PENCIL, 2, 10, 10, id="rank 2: lunes"),
        pytest.param([(2, -3, 5)], 0, 1, 2, id="rank 1"),
        pytest.param([(0, 0, -1), (0, 0, 3)], 0, 1, 2, id="rank 1, coincident"),
        pytest.param([], 0, 0, 1, id="rank 0"),
    ],
)
def test_known_numbers_of_faces(normals, vertices, arcs, regions):
    made = sphere(normals)
    assert (made.vertex_count, made.arc_count, made.region_count) == (vertices, arcs, regions)
    assert made.rank == Arrangement(normals, dimension=3).rank


def test_b3_has_48_triangles_and_vertices_of_2_3_and_4_circles():
    incidence = sphere(B3).incidence
    assert (incidence.region_degree == 3).all()
    through = sorted(len(incidence.circles_at(vertex)) for vertex in range(26))
    assert through == [2] * 12 + [3] * 8 + [4] * 6


@pytest.mark.parametrize("normals", [COORDINATES, A3, B3, GENERIC, NEAR_PENCIL, COINCIDENT])
def test_each_circle_lists_its_crossings_counterclockwise(normals):
    made = sphere(normals)
    for circle, normal in enumerate(made.circle_normals):
        vertices = made.incidence.crossings(circle).tolist()
        half = len(vertices) // 2
        assert [made.incidence.vertex_antipode(v) for v in vertices] == [
            *vertices[half:],
            *vertices[:half],
        ]
        rays = [made.ray(vertex) for vertex in vertices]
        for ray, following in zip(rays, [*rays[1:], rays[0]], strict=True):
            assert np.dot(normal, ray) == 0
            assert np.linalg.det([normal, ray, following]) > 0.5  # an integer
        assert len(made.incidence.arcs_of_circle(circle)) == len(vertices)


@pytest.mark.parametrize("normals", [COORDINATES, B3, GENERIC, NEAR_PENCIL, COINCIDENT, PENCIL])
def test_neighbouring_regions_differ_in_one_class_of_coincident_planes(normals):
    made = sphere(normals)
    classes = [set(members) for members in made.arrangement.distinct]
    for region in range(made.region_count):
        signs = made.region_signs(region)
        neighbours = made.incidence.neighbours(region).tolist()
        assert len(neighbours) == made.incidence.region_degree[region]
        for neighbour in neighbours:
            pairs = enumerate(zip(signs, made.region_signs(neighbour), strict=True))
            assert {i for i, (here, there) in pairs if here != there} in classes


@pytest.mark.parametrize("normals", [COORDINATES, B3, NEAR_PENCIL, PENCIL, [(1, 2, 3)]])
def test_antipodal_regions_have_opposite_signs(normals):
    made = sphere(normals)
    for region, antipode in enumerate(made.incidence.region_antipode.tolist()):
        opposite = tuple(-sign for sign in made.region_signs(region))
        assert made.region_signs(antipode) == opposite


@pytest.mark.parametrize("normals", [A3, B3, GENERIC, COINCIDENT, PENCIL, [(0, 2, -1)], []])
def test_packed_signs_equal_signs_of_exact_witnesses(normals):
    made = sphere(normals)
    planes = len(normals)
    positive = made.packed_region_signs
    regions = unpack(positive, ~positive, planes).tolist()
    assert regions == [list(made.region_signs(r)) for r in range(made.region_count)]
    arcs = unpack(*made.packed_arc_signs, planes).tolist()
    assert arcs == [list(made.arc_signs(a)) for a in range(made.arc_count)]
    vertices = unpack(*made.packed_vertex_signs, planes).tolist()
    assert vertices == [list(made.vertex_signs(v)) for v in range(made.vertex_count)]


def test_packed_signs_of_a_hundred_planes_cross_word_boundaries():
    generator = np.random.default_rng(7)
    normals = generator.integers(-20, 21, (100, 3)).tolist()
    made = sphere(normals)
    bits = np.unpackbits(made.packed_region_signs, axis=1, count=100)
    assert made.packed_region_signs.shape == (made.region_count, 13)
    for region in generator.integers(0, made.region_count, 50).tolist():
        values = np.array(normals) @ np.array(made.region_witness(region))
        assert (values != 0).all()
        assert ((values > 0) == bits[region]).all()


def test_sign_vectors_follow_the_input_order_and_orientation():
    normals = [(0, 0, -1), (1, 0, 0), (0, 0, 2), (0, -1, 0)]
    made = sphere(normals)
    point = (5, 7, 11)
    region = [r for r in range(8) if made.region_signs(r) == (-1, 1, 1, -1)]
    assert len(region) == 1
    assert made.arrangement.signs_at(point) == made.region_signs(region[0])


def test_boundaries_of_all_regions_are_those_of_each():
    incidence = sphere(NEAR_PENCIL).incidence
    offsets, cycles = incidence.boundaries()
    for region, (begin, end) in enumerate(pairwise(offsets)):
        assert cycles[begin:end].tolist() == incidence.boundary(region).tolist()
    assert sorted(cycles.tolist()) == list(range(2 * incidence.arc_count))


def test_circles_leave_a_vertex_counterclockwise():
    made = sphere(B3)
    for vertex in range(made.vertex_count):
        ray = made.ray(vertex)
        tangents = [
            np.cross(made.circle_normals[i], ray) for i in made.incidence.circles_at(vertex)
        ]
        for here, there in combinations(tangents, 2):
            assert np.dot(ray, np.cross(here, there)) > 0


def test_a_pencil_has_two_vertices_and_one_line():
    made = sphere(PENCIL)
    assert [made.ray(v) for v in range(2)] == [(0, 0, 1), (0, 0, -1)]
    assert enumerate_faces(made.arrangement, "great-circles").f_vector == (0, 1, 10, 10)


def test_one_plane_has_one_closed_arc_without_vertices():
    made = sphere([(1, 1, 0), (-2, -2, 0)])
    assert made.incidence.origin.tolist() == [-1, -1]
    assert made.incidence.boundary(0).tolist() == [0]
    assert made.incidence.neighbours(0).tolist() == [1]
    assert [made.region_signs(r) for r in range(2)] == [(1, -1), (-1, 1)]
    assert made.arc_signs(0) == (0, 0)
    assert made.arc_witness(0) != (0, 0, 0)


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
