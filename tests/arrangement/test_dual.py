"""The dual polyhedron: known polyhedra, properties, broken polyhedra, meshes and model files."""

from collections import Counter
from copy import copy
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
import trimesh
from hypothesis import assume, given, strategies as st
from scipy.spatial import ConvexHull

from arrangement import Arrangement, ArrangementError, InputError, counts, families
from arrangement.duals import zonohedron
from arrangement.duals.schlegel import schlegel_diagram
from arrangement.duals.zonohedron import DualPolyhedron, dual_polyhedron, dual_zonotope, zonotope

from .strategies import arrangements

SQUARE_AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
CUBE_DIAGONALS = [[1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, 1, 1]]
A3 = [[1, 1, 0], [1, -1, 0], [1, 0, 1], [1, 0, -1], [0, 1, 1], [0, 1, -1]]
DEGENERATE = [[1, 0, 0], [-2, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1]]

# Zonohedra with names; counts from H. S. M. Coxeter, Regular polytopes, sections 2.7 and 2.8.
KNOWN = {
    "cube": (SQUARE_AXES, (8, 12, 6), {4: 6}),
    "rhombic dodecahedron": (CUBE_DIAGONALS, (14, 24, 12), {4: 12}),
    "truncated octahedron": (A3, (24, 36, 14), {4: 6, 6: 8}),
    "great rhombicuboctahedron": (A3 + SQUARE_AXES, (48, 72, 26), {4: 12, 6: 8, 8: 6}),
    "hexagonal prism": ([*SQUARE_AXES, [1, 1, 0]], (12, 18, 8), {4: 6, 6: 2}),
}

rank_three = arrangements(dimensions=(3, 3), planes=(3, 7), central=True)


def rank_three_only(planes: Arrangement) -> Arrangement:
    assume(planes.rank == 3)
    return planes


@pytest.mark.parametrize("name", KNOWN)
def test_known_zonohedra(name):
    normals, f_vector, sizes = KNOWN[name]
    dual = dual_polyhedron(Arrangement(normals))
    dual.validate()
    assert dual.f_vector == f_vector
    assert Counter(map(len, dual.faces)) == sizes


@given(rank_three)
def test_vertices_and_faces_agree_in_any_dimension(planes):
    dual = dual_polyhedron(rank_three_only(planes))
    dual.validate()
    assert (1, *reversed(dual.f_vector)) == counts.f_vector(planes)
    regions = {face.signs for face in planes.regions()}
    assert {tuple(row) for row in dual.signs.tolist()} == regions
    assert len(dual.signs) == len(regions)
    normals = planes.normals
    for signs, vertex in zip(dual.signs.tolist(), dual.vertices, strict=True):
        total = [sum(s * n[k] for s, n in zip(signs, normals, strict=True)) for k in range(3)]
        assert list(vertex) == total
    expected = {
        frozenset(r for r in regions if all(t in (0, s) for s, t in zip(r, ray.signs, strict=True)))
        for ray in planes.faces(1)
    }
    found = {frozenset(tuple(dual.signs[v].tolist()) for v in cycle) for cycle in dual.faces}
    assert found == expected


@given(rank_three, st.data())
def test_lengths_change_the_shape_and_not_the_combinatorics(planes, data):
    positive = st.fractions(Fraction(1, 4), 3, max_denominator=5)
    size = len(rank_three_only(planes))
    lengths = data.draw(st.lists(positive, min_size=size, max_size=size))
    plain, scaled = dual_polyhedron(planes), dual_polyhedron(planes, lengths)
    scaled.validate()
    assert scaled.faces == plain.faces
    for signs, vertex in zip(scaled.signs.tolist(), scaled.vertices, strict=True):
        for k in range(3):
            terms = zip(signs, lengths, planes.normals, strict=True)
            assert vertex[k] == sum(s * length * n[k] for s, length, n in terms)


def test_dual_enumerates_nothing_for_its_planes(monkeypatch):
    calls = []
    monkeypatch.setattr(zonohedron, "sphere_arrangement", calls.append)
    dual = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    assert dual.arrangement.is_simple
    assert dual.volume == 8
    assert not calls


def test_long_near_degenerate_normals_stay_exact():
    huge = 10**30
    planes = Arrangement([[huge, 1, 0], [huge, 2, 1], [0, 1, 7], [3, 3, huge], [1, 2, 3]])
    dual = dual_polyhedron(planes)
    dual.validate()
    assert (1, *reversed(dual.f_vector)) == counts.f_vector(planes)


def changed(dual: DualPolyhedron, **parts: object) -> DualPolyhedron:
    """Return a polyhedron with other parts in place of those that are computed."""
    other = copy(dual)
    vars(other).update(parts)
    return other


def broken(dual: DualPolyhedron) -> dict[str, DualPolyhedron]:
    """Return polyhedra with one thing wrong each."""
    first, *others = dual.faces
    turned = (first[1], first[0], *first[2:])
    (x, y, z), *rest = dual.integer_vertices
    signs = dual.signs.copy()
    signs[0, 0] *= -1
    classes = dual.edge_classes.copy()
    classes[0] = (classes[0] + 1) % len(dual.arrangement.distinct)
    normals = dual.face_normals
    return {
        "face missing": changed(dual, faces=tuple(others)),
        "face reversed": changed(dual, faces=(first[::-1], *others)),
        "all faces reversed": changed(dual, faces=tuple(cycle[::-1] for cycle in dual.faces)),
        "corners exchanged": changed(dual, faces=(turned, *others)),
        "face twice": changed(dual, faces=(*dual.faces, first)),
        "vertex moved": changed(dual, integer_vertices=((x + 1, y, z), *rest)),
        "all vertices shifted": changed(
            dual, integer_vertices=tuple((a + 1, b, c) for a, b, c in dual.integer_vertices)
        ),
        "vertices exchanged": changed(dual, integer_vertices=(rest[0], (x, y, z), *rest[1:])),
        "sign changed": changed(dual, signs=signs),
        "edge class changed": changed(dual, edge_classes=classes),
        "edge missing": changed(dual, edges=dual.edges[1:], edge_classes=dual.edge_classes[1:]),
        "edge twice": changed(
            dual,
            edges=np.vstack([dual.edges, dual.edges[:1]]),
            edge_classes=np.append(dual.edge_classes, dual.edge_classes[0]),
        ),
        "normals exchanged": changed(dual, face_normals=(normals[1], normals[0], *normals[2:])),
        "normal inward": changed(dual, face_normals=(tuple(-c for c in normals[0]), *normals[1:])),
    }


@pytest.mark.parametrize("fault", broken(dual_polyhedron(Arrangement(A3))))
def test_validate_refuses_a_broken_polyhedron(fault):
    dual = dual_polyhedron(Arrangement(A3))
    with pytest.raises(ArrangementError):
        broken(dual)[fault].validate()


def test_rank_two_is_a_polygon_in_cyclic_order():
    planes = Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 2, 0]])
    polygon = dual_zonotope(planes)
    assert polygon.dimension == 2
    points = [vertex[:2] for vertex in polygon.vertices]
    assert set(points) == {(3, 3), (1, 3), (-3, -1), (-3, -3), (-1, -3), (3, 1)}
    turns = set()
    for k in range(6):
        (ax, ay), (bx, by), (cx, cy) = (points[(k + j) % 6] for j in range(3))
        turns.add((bx - ax) * (cy - by) > (by - ay) * (cx - bx))
    assert len(turns) == 1


def test_rank_one_is_a_segment():
    planes = Arrangement([[1, 2], [-2, -4]])
    segment = dual_zonotope(planes, [1, 2])
    assert segment.vertices == ((3, 6), (-3, -6))
    assert segment.signs == ((1, -1), (-1, 1))


@pytest.mark.parametrize(
    ("planes", "message"),
    [
        (Arrangement([[1, 0, 0], [0, 1, 0]]), "polygon"),
        (Arrangement([[1, 0, 0]]), "segment"),
        (Arrangement([], dimension=3), "point"),
        (Arrangement(SQUARE_AXES, [0, 0, 1]), "origin"),
        (Arrangement([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]), "essentialization"),
        (Arrangement([[int(i == j) for j in range(4)] for i in range(4)]), "dimension 4"),
    ],
)
def test_what_has_no_dual_polyhedron_is_told_why(planes, message):
    with pytest.raises(InputError, match=message):
        dual_polyhedron(planes)


@pytest.mark.parametrize("lengths", [[1, 1], [1, 0, 1], [1, 1, -2], [1, 1, 0.5]])
def test_bad_lengths_are_refused(lengths):
    with pytest.raises(InputError, match="length"):
        dual_polyhedron(Arrangement(SQUARE_AXES), lengths)


@given(rank_three)
def test_mesh_is_closed_oriented_and_of_euler_number_two(planes):
    mesh = dual_polyhedron(rank_three_only(planes)).to_trimesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert mesh.volume > 0


@pytest.mark.parametrize("suffix", [".stl", ".glb", ".obj"])
@pytest.mark.parametrize("normals", [A3, DEGENERATE], ids=["A3", "degenerate"])
def test_model_files_come_back_closed_and_of_the_stated_size(normals, suffix, tmp_path):
    path = tmp_path / f"model{suffix}"
    dual = dual_polyhedron(Arrangement(normals))
    dual.export(path, size=40)
    mesh: Any = trimesh.load(path, force="mesh")
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert mesh.volume > 0
    assert len(mesh.vertices) == len(dual.vertices)
    largest = 0.040 if suffix == ".glb" else 40
    assert max(mesh.extents) == pytest.approx(largest, rel=1e-6)
    assert list(tmp_path.iterdir()) == [path]


def test_obj_keeps_whole_polygons(tmp_path):
    dual_polyhedron(Arrangement(A3)).export(tmp_path / "a3.obj")
    lines = (tmp_path / "a3.obj").read_text().splitlines()
    assert Counter(len(line.split()) - 1 for line in lines if line.startswith("f ")) == {4: 6, 6: 8}


def test_vertices_that_rounding_would_join_are_refused():
    thin = dual_polyhedron(Arrangement(SQUARE_AXES), [1, 1, Fraction(1, 10**400)])
    thin.validate()
    with pytest.raises(ArrangementError, match="two vertices become one"):
        thin.to_trimesh(10)


@given(arrangements(dimensions=(2, 4), planes=(1, 6)), st.data())
def test_volume_is_that_of_the_convex_hull(planes, data):
    rows = [*planes.normals]
    assume(rows and planes.rank == planes.dimension)
    lengths = [data.draw(st.sampled_from([1, Fraction(1, 2), 3])) for _ in rows]
    body = zonotope([[x * length for x in row] for row, length in zip(rows, lengths, strict=True)])
    hull = ConvexHull([[float(x) for x in vertex] for vertex in body.vertices])
    assert float(body.volume) == pytest.approx(hull.volume)
    assert len(hull.vertices) == len(body.vertices) == len(Arrangement(rows).regions())


def test_volume_of_graphs_counts_spanning_trees():
    """In the lattice of its edges a graph's zonotope has a cell for each tree (Stanley 1991)."""
    for n in (3, 4, 5):
        edges = counts.essentialization(families.braid(n))
        assert edges.dual().volume == 2 ** (n - 1) * n ** (n - 2)  # Cayley
        trees = counts.tutte_polynomial(families.braid(n)).eval((1, 1))
        assert trees == n ** (n - 2)
    assert families.braid(4).essentialization().dual().volume == 8 * 16
    assert families.braid(3).dual().volume == 0  # a hexagon in space


@pytest.mark.parametrize(
    ("planes", "vertices"),
    [
        (families.coordinate(4), 16),
        (families.braid(5), 120),
        (families.coxeter("D4"), 192),
        (families.coordinate(5), 32),
    ],
)
def test_dual_of_high_rank_has_a_vertex_for_each_region(planes, vertices):
    dual = planes.dual()
    assert len(set(dual.vertices)) == len(dual.signs) == vertices == planes.region_count()
    assert dual.dimension == planes.rank
    inside = {region.signs: region.witness for region in planes.regions()}
    for signs, vertex in zip(dual.signs, dual.vertices, strict=True):
        columns = zip(*planes.normals, strict=True)
        assert vertex == tuple(sum(s * x for s, x in zip(signs, c, strict=True)) for c in columns)
        top = planes.region_at(inside[signs]).witness
        heights = [sum(a * b for a, b in zip(top, v, strict=True)) for v in dual.vertices]
        assert heights.count(max(heights)) == 1
        assert dual.vertices[heights.index(max(heights))] == vertex


def test_zonotope_keeps_lengths_and_multiplicities_that_the_dual_forgets():
    vectors = [[2, 0], [1, 0], [0, "1/2"]]
    kept, forgotten = zonotope(vectors), Arrangement(vectors).dual()
    assert {tuple(map(abs, v)) for v in kept.vertices} == {(3, Fraction(1, 2))}
    assert {tuple(map(abs, v)) for v in forgotten.vertices} == {(2, 1)}
    assert (kept.volume, forgotten.volume) == (6, 8)
    assert zonotope([[0, 0, 4]]).vertices[0] == (0, 0, 4)
    assert zonotope([[1, 0, 0], [0, 3, 0], [0, 0, "1/3"]]).volume == 8
    for wrong in ([[0, 0]], [], [[1, 0], [1]], [[0.5]], [[sympy.sqrt(2)]]):
        with pytest.raises(InputError):
            zonotope(wrong)
    with pytest.raises(InputError, match="of dimension 4; use dual_zonotope"):
        dual_polyhedron(families.coordinate(4))
    with pytest.raises(InputError, match="a polyhedron; use dual_zonotope"):
        schlegel_diagram(families.coordinate(3))


@pytest.mark.parametrize("d", [2, 3])
def test_vertices_beyond_machine_integers_are_exact(d):
    large = 2**62
    body = zonotope([[large, *(int(i == j) for j in range(d - 1))] for i in range(d)])
    assert max(body.vertices)[0] == d * large
    assert {vertex[0] // large for vertex in body.vertices} == set(range(-d, d + 1, 2))
