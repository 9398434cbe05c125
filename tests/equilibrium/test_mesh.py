"""Contacts on meshes: where they are, which normals they get, and what is refused."""

import json
import re
import struct
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import trimesh

from arrangement.errors import InputError, OutOfReachError
from arrangement.numbers.budget import limit
from arrangement.numbers.exact import dot
from equilibrium import GraspError, Mesh
from equilibrium.grasps.inputs import on_mesh
from equilibrium.grasps.inputs.mesh import Surface
from equilibrium.grasps.inputs.mesh_files import READERS, read_triangles


@pytest.fixture
def cube(tmp_path: Path) -> Path:
    return written(trimesh.creation.box((2, 2, 2)), tmp_path / "cube.stl")


def written(mesh: trimesh.Trimesh, path: Path) -> Path:
    mesh.export(path)
    return path


def bare(points: np.ndarray, facets: np.ndarray) -> trimesh.Trimesh:
    return trimesh.Trimesh(points, facets, process=False)


@pytest.mark.parametrize("kind", READERS)
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


def test_only_irrational_normals_are_rounded(tmp_path):
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


def test_random_places_repeat_and_face_the_direction(tmp_path):
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
        "no facets|not a mesh": text,
        "not a mesh that can be read": damaged,
        "No such file": tmp_path / "missing.stl",
        "of no kind": tmp_path / "cube.step",
    }


def test_what_is_no_closed_surface_is_refused(tmp_path):
    for message, path in broken(tmp_path).items():
        with pytest.raises(InputError, match=message):
            on_mesh(path, 1, random=1)


CORNERS = "v 0 0 0{0}\nv 1 0 0{0}\nv 0 1 0{0}\nv 0 0 1{0}\n"
FACETS = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


@pytest.mark.parametrize(
    "text",
    [
        CORNERS.format("") + FACETS,
        "mtllib /dev/zero\nusemtl none\n" + CORNERS.format("") + FACETS,
        CORNERS.format(" 1") + FACETS,
        CORNERS.format(" 0.5 0 1") + FACETS,
        CORNERS.format("") + "f -4 -2 -3 # a comment\nf 1/1/1 \\\n2//2 4/7\nf 1 4 3\nf 2 3 4\n",
    ],
    ids=["plain", "mtllib", "weights", "colours", "indices"],
)
def test_obj_gives_its_geometry(tmp_path, text):
    path = tmp_path / "a.obj"
    path.write_text(text)
    surface = Surface.read(path)
    assert surface.points.tolist() == [[0, 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0]]
    assert len(surface.facets) == 4


def ply(vertex: str, facet: str) -> str:
    return (
        "ply\nformat ascii 1.0\ncomment TextureFile /dev/zero\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\n"
        f"end_header\n0 0 0\n1 0 0\n{vertex}\n{facet}\n"
    )


STL = "solid\nfacet normal {}\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 {}\nendloop\n{}\n"
REFUSED = {
    "two.obj": ("v 0 0\nf 1 1 1\n", "line 1: a vertex has 2 numbers"),
    "five.obj": ("v 0 0 0 0 0\n", "a vertex has 5 numbers"),
    "far.obj": (CORNERS.format("") + "f 1 2 5\n", "names vertex 4; there are 4"),
    "back.obj": (CORNERS.format("") + "f 1 2 -5\n", "names vertex -1"),
    "zero.obj": (CORNERS.format("") + "f 0 1 2\n", "a corner of a facet is '0'"),
    "huge.obj": (CORNERS.format("").replace("1", "1e200") + FACETS, "beyond 1e60"),
    "line.obj": ("f" + " 1" * 2**20, "a line of it has 2,097,153 bytes"),
    "normal.stl": (STL.format("a b c", 0, "endfacet\nendsolid"), "'a' is not a number"),
    "vertex.stl": (STL.format("0 0 1", "?", "endfacet\nendsolid"), "'?' is not a number"),
    "end.stl": (STL.format("0 0 1", 0, "endfacet"), "neither a binary STL"),
    "part.stl": (STL.format("0 0 1", 0, "endsolid"), "neither a binary STL"),
    "far.ply": (ply("0 1 0", "3 0 1 3"), "names vertex 3; there are 3"),
    "negative.ply": (ply("0 1 0", "3 0 1 -1"), "names vertex -1"),
    "short.ply": (ply("0 1", "3 0 1 2"), "a facet has 0 corners"),
    "long.ply": (ply("0 1 0", "3 0 1 2 2"), "goes on"),
    "count.ply": (ply("0 1 0", "3 0 1 2").replace("face 1", f"face {10**17}"), "ends before"),
    "list.ply": (ply("0 1 0", f"{10**17} 0 1 2"), "ends before"),
    "nan.ply": (ply("0 1 0", "nan 0 1 2").replace("uchar", "float"), "ends before"),
    "floats.ply": (ply("0 1 0", "3 0 1 2").replace("uchar int", "uchar float"), "floats for"),
    "lists.ply": (
        ply("0 1 0", "3 0 1 2").replace("float x", "list uchar float x"),
        "no x, y and z",
    ),
    "twice.ply": (
        ply("0 1 0 1 7", "3 0 1 2").replace(
            "element face", "property list uchar float x\nelement face"
        ),
        "no x, y and z",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_damaged_text_is_refused(tmp_path, name):
    text, message = REFUSED[name]
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(InputError, match=re.escape(message)):
        Surface.read(path)


def glb(document: dict, data: bytes = b"") -> bytes:
    """Return a scene of one mesh, of three points and one facet."""
    base = {
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0},
            {"componentType": 5121, "count": 3, "type": "SCALAR", "bufferView": 1},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteLength": 3, "byteOffset": 36},
        ],
        "buffers": [{"byteLength": 39}],
    }
    text = json.dumps(base | document).encode()
    chunks = ((text, b"JSON"), (data or bytes(36) + bytes([0, 1, 2]), b"BIN\0"))
    body = b"".join(struct.pack("<I", len(chunk)) + kind + chunk for chunk, kind in chunks)
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def accessor(**changes: object) -> dict:
    first = {"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0}
    second = {"componentType": 5121, "count": 3, "type": "SCALAR", "bufferView": 1}
    return {"accessors": [{k: v for k, v in (first | changes).items() if v is not None}, second]}


GLB = {
    "count": (accessor(count=8 * 10**8), "accessor 0 has 800000000 entries, more than there are"),
    "no data": (accessor(bufferView=None), "accessor 0 has no data of its own"),
    "sparse": (accessor(sparse={}), "accessor 0 has no data of its own"),
    "bytes": (accessor(count=4), "accessor 0 has 4 entries"),
    "kind": (accessor(componentType=5122), "not of the type"),
    "cycle": ({"nodes": [{"mesh": 0, "children": [0]}]}, "two places"),
    "twice": ({"nodes": [{"children": [1, 1]}, {"mesh": 0}]}, "two places"),
    "file": ({"buffers": [{"uri": "/dev/zero", "byteLength": 39}]}, "in another file"),
    "strip": ({"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}]}, "mode 4"),
    "scene": ({"scenes": 7}, "not that of a glTF scene"),
    "no scene": ({"scenes": []}, "no scene"),
    "node": ({"scenes": [{"nodes": [7]}]}, "its nodes have no number 7"),
    "many": (
        accessor(count=3) | {"meshes": [{"primitives": 9 * [{"attributes": {"POSITION": 1}}]}]},
        "not of the type",
    ),
}


@pytest.mark.parametrize("name", GLB)
def test_damaged_glb_is_refused(tmp_path, name):
    document, message = GLB[name]
    path = tmp_path / "a.glb"
    path.write_bytes(glb(document))
    with pytest.raises(InputError, match=message):
        Surface.read(path)


def test_glb_vertex_out_of_range_is_refused(tmp_path):
    path = tmp_path / "a.glb"
    path.write_bytes(glb({}, bytes(36) + bytes([0, 1, 3])))
    with pytest.raises(InputError, match="names a vertex that is not there"):
        Surface.read(path)


def test_facets_of_repeated_glb_meshes_are_forecast(tmp_path):
    many = 300_000
    part = {"attributes": {"POSITION": 0}, "indices": 1}
    document = accessor() | {"meshes": [{"primitives": 9 * [part]}]}
    document["accessors"][1]["count"] = many
    views = [
        {"buffer": 0, "byteLength": 36},
        {"buffer": 0, "byteLength": many, "byteOffset": 36},
    ]
    path = tmp_path / "a.glb"
    path.write_bytes(glb(document | {"bufferViews": views}, bytes(36 + many)))
    with limit(1 / 2), pytest.raises(OutOfReachError, match="00,000 facets: this would take"):
        Surface.read(path)


def test_glb_textures_are_not_decoded(tmp_path):
    box = trimesh.creation.box((2, 2, 2))
    path = tmp_path / "a.glb"
    written(box, path)
    content = path.read_bytes()
    length = int.from_bytes(content[12:16], "little")
    document = json.loads(content[20 : 20 + length])
    document |= {"images": [{"uri": "/dev/zero"}], "textures": [{"source": 0}]}
    path.write_bytes(glb(document, content[28 + length :]))
    assert len(Surface.read(path).facets) == 12


def test_glb_scene_of_moved_meshes_agrees_with_trimesh(tmp_path):
    chance = np.random.default_rng(1)
    scene = trimesh.Scene()
    parent = None
    for k in range(4):
        place = trimesh.transformations.random_rotation_matrix(chance.random(3))
        place[:3, :3] *= [1, -1, 2] if k % 2 else 1
        place[:3, 3] = 10 * k
        parent = scene.add_geometry(
            trimesh.creation.box((1, 2, 3)), transform=place, parent_node_name=parent
        )
    path = tmp_path / "a.glb"
    scene.export(path)
    points, facets = read_triangles(path)
    expected = trimesh.util.concatenate(
        [
            scene.geometry[name].copy().apply_transform(place)
            for place, name in map(scene.graph.get, scene.graph.nodes_geometry)
        ]
    )
    found = trimesh.Trimesh(points, facets, process=False)
    assert found.volume == pytest.approx(expected.volume)
    assert sorted(map(tuple, found.triangles_center.round(4))) == sorted(
        map(tuple, expected.triangles_center.round(4))
    )


def test_ply_of_either_byte_order_and_mixed_polygons_is_read(tmp_path):
    pyramid = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1)]
    faces = [(0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    for order, sign in (("little", "<"), ("big", ">")):
        header = (
            f"ply\nformat binary_{order}_endian 1.0\nelement vertex 5\nproperty double x\n"
            "property double y\nproperty double z\nproperty uchar red\nelement face 5\n"
            "property list uchar ushort vertex_indices\nproperty float quality\nend_header\n"
        )
        body = b"".join(struct.pack(f"{sign}3dB", *p, 7) for p in pyramid)
        body += b"".join(struct.pack(f"{sign}B{len(f)}Hf", len(f), *f, 0.5) for f in faces)
        path = tmp_path / "a.ply"
        path.write_bytes(header.encode() + body)
        surface = Surface.read(path)
        assert (len(surface.points), len(surface.facets)) == (5, 6)


@pytest.mark.parametrize("kind", READERS)
def test_file_beyond_the_limit_is_refused(tmp_path, kind):
    path = tmp_path / f"a{kind}"
    with path.open("wb") as stream:
        stream.truncate(2**30)
    with pytest.raises(OutOfReachError, match="bytes of a mesh"):
        Surface.read(path)


def test_facets_are_forecast(tmp_path):
    path = tmp_path / "a.stl"
    number = 330_000
    path.write_bytes(bytes(80) + number.to_bytes(4, "little") + bytes(50 * number))
    with limit(1 / 2), pytest.raises(OutOfReachError, match="330,000 facets"):
        Surface.read(path)


def test_nothing_asked_for_and_directions_that_nothing_faces(cube):
    with pytest.raises(GraspError, match="no contacts"):
        on_mesh(cube, 1)
    with pytest.raises(GraspError, match="add --random"):
        on_mesh(cube, 1, at=[(1, 0, 0)], facing=(1, 0, 0))
    with pytest.raises(GraspError, match="no facet faces"):
        on_mesh(cube, 1, random=1, facing=(1, 1, 1))


def test_points_beyond_floats_are_refused_directions_are_not(cube):
    with pytest.raises(GraspError, match="point 2 is beyond 1e60"):
        on_mesh(cube, 1, at=[(1, 0, 0), ("1e4000", 0, 0)])
    far = on_mesh(cube, 1, random=1, facing=("1e4000", 0, 0))
    assert far.grasp == on_mesh(cube, 1, random=1, facing=(1, 0, 0)).grasp


def test_the_command(cube, run, refused):
    call = ["make", "mesh", str(cube), "--friction", "1/2", "--at"]
    units = ["--units", "mm", "N"]
    document = json.loads(run(*call, "1", "1/5", "0", "1/3", "1.01", "0", *units))
    assert len(document["contacts"]) == 2
    assert document["units"] == {"length": "mm", "force": "N"}
    assert run.err == "rounded: points by 0.01, normals by 0 radians\n"
    again = run(*call, "1", "1/5", "0", "--at", "1/3", "1.01", "0", *units)
    assert json.loads(again) == document
    assert "three for each point" in refused(*call, "1", "2")
