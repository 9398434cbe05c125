"""Files with random damage: read, or refused as input; no output, no warning, little memory."""

import json
import random
import signal
from collections.abc import Callable
from pathlib import Path

import pytest
import trimesh
from trimesh.exchange.ply import export_ply
from trimesh.exchange.stl import export_stl_ascii

from arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.table import read_arrangement
from equilibrium import read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.grasps.files import read_certificate
from equilibrium.grasps.inputs import on_mesh, read_shapes
from equilibrium.grasps.inputs.documents import read_any
from equilibrium.grasps.inputs.floats import read_float_data
from equilibrium.grasps.inputs.polygon import read_polygon

resource = pytest.importorskip("resource")

#: What a reader may allocate, and the seconds after which it hangs, on slow machines too.
MEMORY, PATIENCE = 500 * 2**20, 60
WORDS = b"0 -1 1 2 7 255 65536 4294967295 9999999999999 1e308 1e999 nan inf -0 1/0 1/3 x {} [] null"
Read = Callable[[Path], object]


def box() -> trimesh.Trimesh:
    return trimesh.creation.box((2, 2, 2))


def on_box(path: Path) -> object:
    return on_mesh(path, "1/2", at=[(1, "1/5", 0)], random=1)


def of_table(path: Path) -> object:
    return read_shapes(path, friction="1/2")


def as_bytes(value: object) -> bytes:
    return json.dumps(value, indent=1).encode()


def files() -> dict[str, tuple[str, bytes, Read]]:
    """Return the ending, the content and the reader of each kind of file."""
    grasp = read_grasp("paper-three-contacts")
    lines = ["x,y,normal_x,normal_y,friction", "-1,0,1,0,1/2", "1,0,-3,0.5,0.25", "# none", ""]
    places = [{"edge": 0, "at": "1/2", "friction": "1/2"}, {"point": ["2", "1"], "friction": "1"}]
    polygon = {"schema_version": 1, "polygon": [["0", "0"], ["2", "0"], ["2", "2"]]}
    floats = {"points": [[-1.0, 0], [1, 1e-3]], "normals": [[1, 0], [-1, 0.1]], "friction": 0.3}
    disc = {"name": "a", "circle": {"centre": [0, "1"], "radius": 1}, "weight": "2"}
    block = {"polygon": [[1, 0], [2, 0], [2, 2], [1, 2]]}
    walls = [{"segments": [[["-4", "0"], ["4", 0]]]}, block]
    thread = {"body_a": "a", "body_b": None, "point": [0, 2], "to": [0, 3]}
    shapes = {"schema_version": 1, "bodies": [disc], "friction": "0.5", "ground": walls}
    shapes |= {"threads": [thread], "gap": 1e-3}
    proof = solve(grasp, [0, "-1/100", 0]).certificate
    glb = box().export(file_type="glb")
    assert isinstance(glb, bytes)
    return {
        "stl": ("stl", box().export(file_type="stl"), on_box),
        "ascii stl": ("stl", export_stl_ascii(box()).encode(), on_box),
        "obj": ("obj", box().export(file_type="obj").encode(), on_box),
        "ply": ("ply", export_ply(box()), on_box),
        "ascii ply": ("ply", export_ply(box(), encoding="ascii"), on_box),
        "glb": ("glb", glb, on_box),
        "grasp": ("json", as_bytes(grasp.to_dict()), read_any),
        "csv": ("csv", "\n".join(lines).encode(), read_any),
        "floats": ("json", as_bytes({"schema_version": 1} | floats), read_float_data),
        "float csv": ("csv", "\n".join(lines).encode(), read_float_data),
        "shapes": ("json", as_bytes(shapes), read_shapes),
        "shapes csv": ("csv", b"body,x,y,radius,x2,y2\na,0,1,1,,\n,-4,0,,4,0\n", of_table),
        "polygon": ("json", as_bytes(polygon | {"places": places}), read_polygon),
        "certificate": ("json", proof.text.encode(), lambda path: check(read_certificate(path))),
        "planes": ("json", as_bytes(Arrangement([[1, 2], [0, 1]]).to_dict()), read_arrangement),
        "matrix": ("txt", b"1 0 1\n0 1 2\n1/2 1 0\n", read_arrangement),
    }


def damaged(content: bytes, chance: random.Random) -> bytes:
    """Return a file with one to three changes of bytes, words or lines."""
    for _ in range(chance.randint(1, 3)):
        at = chance.randrange(len(content) + 1)
        other = chance.randrange(len(content) + 1)
        piece = content[min(at, other) : max(at, other)]
        lines, words = content.split(b"\n"), content.split(b" ")
        match chance.randrange(8):
            case 0:
                content = content[:at]
            case 1:
                content = content[:at] + bytes([chance.randrange(256)]) + content[at + 1 :]
            case 2:
                content = content[:at] + chance.randbytes(4) + content[at + 4 :]
            case 3:
                content = content[:at] + b"\xff\xff\xff\xff" + content[at + 4 :]
            case 4:
                content = content[:at] + piece[:200] + content[at:]
            case 5:
                lines.insert(chance.randrange(len(lines)), lines.pop(chance.randrange(len(lines))))
                content = b"\n".join(lines)
            case 6:
                del lines[chance.randrange(len(lines))]
                content = b"\n".join(lines)
            case 7:
                words[chance.randrange(len(words))] = chance.choice(WORDS.split())
                content = b" ".join(words)
    return content


def damage_shows(kind: str, number: int, seed: int, path: Path) -> list[str]:
    """Return what went wrong for some damaged files of a kind."""
    ending, content, read = files()[kind]
    chance = random.Random(f"{kind} {seed}")
    target = path / f"damaged.{ending}"
    target.write_bytes(content)
    read(target)
    wrong = []
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    limits = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY, limits[1]))
    try:
        for k in range(number):
            target.write_bytes(damaged(content, chance))
            signal.alarm(PATIENCE)
            try:
                read(target)
            except InputError as error:
                if len(str(error)) > 500 or "\n" in str(error):
                    wrong.append(f"{kind} {seed} {k}: {str(error)[:600]}")
            except Exception as error:
                wrong.append(f"{kind} {seed} {k}: {error!r}"[:600])
    finally:
        signal.alarm(0)
        resource.setrlimit(resource.RLIMIT_AS, limits)
    return wrong


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="measures memory on Linux")
@pytest.mark.parametrize("kind", files())
def test_damaged_file_is_read_or_refused(kind, tmp_path, capfd):
    assert damage_shows(kind, 15, 1, tmp_path) == []
    assert "".join(capfd.readouterr()) == ""


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="measures memory on Linux")
@pytest.mark.parametrize("kind", files())
def test_damaged_files_are_read_or_refused(kind, tmp_path, capfd):
    assert damage_shows(kind, 150, 2, tmp_path) == []
    assert "".join(capfd.readouterr()) == ""
