"""Contacts on meshes: where they are, which normals they get, and what is refused."""

import json
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import trimesh

from arrangement.numbers.exact import dot
from equilibrium import GraspError, Mesh
from equilibrium.cli import main
from equilibrium.grasps.inputs import on_mesh
from equilibrium.grasps.inputs.mesh import KINDS, Surface


@pytest.fixture
def cube(tmp_path: Path) -> Path:
    return written(trimesh.creation.box((2, 2, 2)), tmp_path / "cube.stl")


def written(mesh: trimesh.Trimesh, path: Path) -> Path:
    mesh.export(path)
    return path


def bare(points: np.ndarray, facets: np.ndarray) -> trimesh.Trimesh:
    return trimesh.Trimesh(points, facets, process=False)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_file_gives_the_same_contacts(tmp_path, kind):
    path = written(trimesh.creation.box((2, 2, 2)), tmp_path / f"cube{kind}")
    found = on_mesh(path, "1/2", at=[(1, "1/5", 0), ("1/3", -1, "1/4")])
    assert found.exact
    assert [c.point for c in found.grasp] == [
        (1, Fraction(1, 5), 0),
        (Fraction(1, 3), -1, Fraction(1, 4)),
    ]
    assert [c.normal for c in found.grasp] == [(-1, 0, 0), (0, 1, 0)]
    assert isinstance(found.grasp.outline, Mesh)
    assert {abs(x) for p in found.grasp.outline.vertices for x in p} == {1}


def test_a_point_beside_the_surface_is_moved_and_the_change_told(cube):
    found = on_mesh(cube, 1, at=[("1/2", "1.03", "1/4")])
    assert found.grasp.contacts[0].point == (Fraction(1, 2), 1, Fraction(1, 4))
    assert found.point_errors == (Fraction(3, 100),)


def test_a_normal_of_rational_length_is_exact_and_others_are_rounded(tmp_path):
    # a roof whose sides have the slope 3:4, and gables that lean by 1:1
    points = np.array(
        [[-4, -6, 0], [4, -6, 0], [4, 6, 0], [-4, 6, 0], [0, -3, 3], [0, 3, 3]], float
    )
    facets = np.array(
        [[0, 3, 2], [0, 2, 1], [0, 1, 4], [2, 3, 5], [1, 2, 5], [1, 5, 4], [3, 0, 4], [3, 4, 5]]
    )
    path = written(bare(points, facets), tmp_path / "roof.obj")
    found = on_mesh(path, 1, at=[(2, 0, "3/2"), (0, "-9/2", "3/2")])
    assert found.grasp.contacts[0].normal == (Fraction(-3, 5), 0, Fraction(-4, 5))
    assert found.angle_errors[0] == 0
    assert 0 < found.angle_errors[1] < Fraction(1, 10**6)
    normal = found.grasp.contacts[1].normal
    assert dot(normal, normal) == 1
    assert float(normal[1]) == pytest.approx(0.5**0.5)


def test_a_surface_turned_inside_out_has_the_same_normals(tmp_path, cube):
    box = trimesh.creation.box((2, 2, 2))
    turned = written(bare(box.vertices, box.faces[:, ::-1]), tmp_path / "turned.ply")
    at = [(1, "1/5", 0), (0, "1/4", -1)]
    assert on_mesh(turned, 1, at=at).grasp == on_mesh(cube, 1, at=at).grasp


def test_facets_without_area_are_left_out(tmp_path, cube):
    # a point in the middle of an edge makes one facet of no area, between its two neighbours
    points = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]], float)
    facets = np.array([[0, 2, 4], [4, 2, 1], [0, 1, 3], [0, 4, 1], [0, 3, 2], [1, 2, 3], [4, 4, 1]])
    path = written(bare(points, facets), tmp_path / "flat.ply")
    surface = Surface.read(path)
    assert len(surface.facets) == 5
    assert on_mesh(path, 1, at=[(1, 0, "1/3")]).grasp.contacts[0].normal == (0, 1, 0)


@pytest.mark.parametrize(
    ("at", "word"),
    [([(1, 1, 0)], "sharp edge"), ([(1, 2, 0)], "farther|more than"), ([(1, 0)], "give three")],
)
def test_points_that_are_no_places_are_refused(cube, at, word):
    with pytest.raises(GraspError, match=word):
        on_mesh(cube, 1, at=at)


def test_an_edge_has_a_smooth_normal(cube):
    found = on_mesh(cube, 1, at=[(1, 1, 1)], smooth=True)
    assert all(x < 0 for x in found.grasp.contacts[0].normal)


def test_smooth_normals_of_a_ball_point_to_its_centre(tmp_path):
    path = written(trimesh.creation.icosphere(subdivisions=3), tmp_path / "ball.glb")
    plain, smooth = (on_mesh(path, 1, random=5, seed=3, smooth=s) for s in (False, True))

    def errors(found):
        return [
            1 + float(dot(c.normal, c.point)) / float(dot(c.point, c.point)) ** 0.5
            for c in found.grasp
        ]

    assert max(errors(smooth)) < 1e-3
    assert sum(errors(smooth)) < sum(errors(plain)) / 4


def test_random_places_are_the_same_for_a_seed_and_face_the_direction(tmp_path):
    path = written(trimesh.creation.icosphere(subdivisions=2), tmp_path / "ball.stl")
    first, again, other = (
        on_mesh(path, 1, random=6, seed=s, facing=(0, 0, 1)).grasp for s in (1, 1, 2)
    )
    assert first == again != other
    assert all(c.normal[2] < Fraction(-7, 10) and c.point[2] > Fraction(6, 10) for c in first)


def broken(tmp_path: Path) -> dict[str, Path]:
    box = trimesh.creation.box((2, 2, 2))
    facets = box.faces.copy()
    facets[0] = facets[0][::-1]
    text = tmp_path / "text.stl"
    text.write_text("hello\n")
    damaged = tmp_path / "damaged.glb"
    damaged.write_bytes(b"glTF" + bytes(range(40)))
    return {
        "not watertight: 3 of its 18 edges": written(
            bare(box.vertices, box.faces[1:]), tmp_path / "open.stl"
        ),
        "not oriented alike": written(bare(box.vertices, facets), tmp_path / "mixed.ply"),
        "no facets|no mesh": text,
        "no mesh that can be read": damaged,
        "no such file": tmp_path / "missing.stl",
        "of no kind": tmp_path / "cube.step",
    }


def test_what_is_no_closed_surface_is_refused(tmp_path):
    for message, path in broken(tmp_path).items():
        with pytest.raises(GraspError, match=message):
            on_mesh(path, 1, random=1)


def test_nothing_asked_for_and_directions_that_nothing_faces(cube):
    with pytest.raises(GraspError, match="no contacts"):
        on_mesh(cube, 1)
    with pytest.raises(GraspError, match="add --random"):
        on_mesh(cube, 1, at=[(1, 0, 0)], facing=(1, 0, 0))
    with pytest.raises(GraspError, match="no facet faces"):
        on_mesh(cube, 1, random=1, facing=(1, 1, 1))


def test_the_command(cube, capsys):
    call = ["make", "mesh", str(cube), "--friction", "1/2", "--at"]
    assert main([*call, "1", "1/5", "0", "1/3", "1.01", "0", "--units", "mm", "N"]) == 0
    printed = capsys.readouterr()
    document = json.loads(printed.out)
    assert len(document["contacts"]) == 2
    assert document["units"] == {"length": "mm", "force": "N"}
    assert printed.err == "rounded: points by 0.01, normals by 0 radians\n"
    with pytest.raises(SystemExit, match="2"):
        main([*call, "1", "2"])
    assert "three for each point" in capsys.readouterr().err
