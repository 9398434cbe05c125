"""Files of many grasps, and ``equilibrium solve`` of them."""

import csv
import io
import json
import zipfile

import numpy as np
import pytest

from equilibrium.cli.program import main
from equilibrium.decide.many_grasps.tables import read_grasps

GRASPS = """# two jaws, and a third finger
grasp,x,y,nx,ny,mu,q
a,-1,0,1,0,1/2,1
"b, 2",-1,0,1,0,0.5,1
a,1,0,-1,0,0.5,1
"b, 2",1,0,-3,0,0.5,1
"b, 2",0,-1,0,1,0.5,0
"""
LOADS = "f_x;f_y;tau\n0;-0.9;0\n0;-1.1;0\n"
ANSWERS = [
    ["grasp", "load", "answer", "decided"],
    ["a", "1", "resisted", "screened"],
    ["a", "2", "not resisted", "screened"],
    ["b, 2", "1", "resisted", "exact"],
    ["b, 2", "2", "resisted", "screened"],
]
#: The same grasps.
ARRAYS = {
    "points": [[[-1, 0], [1, 0], [np.nan, np.nan]], [[-1, 0], [1, 0], [0, -1]]],
    "normals": [[[1, 0], [-1, 0], [0, 1]]] * 2,
    "friction": 0.5,
    "preload": [1, 1, 0],
}


@pytest.fixture(autouse=True)
def files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "grasps.csv").write_text(GRASPS)
    (tmp_path / "loads.csv").write_text(LOADS)
    np.savez("grasps.npz", **ARRAYS)
    return tmp_path


def solved(*words):
    return main(["solve", *map(str, words)])


def test_table_answered_on_stdout(capsys):
    assert solved("grasps.csv", "--wrenches", "loads.csv") == 1
    assert list(csv.reader(capsys.readouterr().out.splitlines())) == ANSWERS


def test_answers_written_as_csv_and_npz(files, capsys):
    for name in ("answers.csv", "answers.npz"):
        assert solved("grasps.csv", "--wrenches", "loads.csv", "-o", name) == 1
    with (files / "answers.csv").open() as lines:
        assert list(csv.reader(lines)) == ANSWERS
    with np.load("answers.npz") as answers:
        assert answers["grasp"].tolist() == ["a", "b, 2"]
        assert answers["resisted"].tolist() == [[True, False], [True, True]]
        assert answers["exact"].tolist() == [[False, False], [True, False]]
    assert "2 grasps, 2 loads each: 3 resisted, 3 screened, 1 exact" in capsys.readouterr().out


def test_one_load_for_all_grasps(capsys):
    assert solved("grasps.npz", "--force", 0, "-9/10", "--json") == 0
    document = json.loads(capsys.readouterr().out)
    assert document["grasps"] == ["1", "2"]
    assert document["resisted"] == [[True], [True]]
    assert solved("grasps.csv", "--weight", "1.1", "--preload", 2, "--json") == 0


def test_loads_of_each_grasp(files, capsys):
    rows = ["grasp,f_x,f_y,tau", '"b, 2",0,-1.1,0', "a,0,-0.9,0"]
    (files / "own.csv").write_text("\n".join(rows))
    assert solved("grasps.csv", "--wrenches", "own.csv", "--json") == 0
    assert json.loads(capsys.readouterr().out)["resisted"] == [[True], [True]]
    np.savez("own.npz", wrenches=np.array([[[0, -0.9, 0]], [[0, -1.1, 0]]]))
    assert solved("grasps.npz", "--wrenches", "own.npz") == 0
    np.savez("whole.npz", **ARRAYS, wrenches=np.array([[[0, -0.9, 0]], [[0, -1.1, 0]]]))
    assert solved("whole.npz") == 0


def test_first_grasp_may_have_one_contact(files):
    path = files / "few.csv"
    path.write_text("grasp,x,y,nx,ny,mu\na,-1,0,1,0,1/2\nb,1,0,-1,0,0\nb,0,1,0,-1,1\n")
    names, arrays = read_grasps(str(path))
    assert names == ["a", "b"]
    assert arrays["points"][1].tolist() == [[1, 0], [0, 1]]
    assert np.isnan(arrays["friction"]).tolist() == [[False, True], [False, False]]
    path.write_text("grasp,x,y,nx,ny,mu\n")
    names, arrays = read_grasps(str(path))
    assert (names, arrays["points"].shape) == ([], (0, 0, 2))


def test_grasps_in_space_read(files, capsys):
    lines = ["grasp,x,y,z,nx,ny,nz,friction,preload"]
    lines += [f"{g},0,0,{z},0,0,{-z},1/2,1" for g in "ab" for z in (1, -1)]
    (files / "space.csv").write_text("\n".join(lines))
    (files / "six.csv").write_text("f_x,f_y,f_z,tau_x,tau_y,tau_z\n0,0.5,0,0,0,0\n")
    assert solved("space.csv", "--wrenches", "six.csv", "--json") == 0
    assert json.loads(capsys.readouterr().out)["resisted"] == [[True], [True]]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["grasps.csv"], "the grasps have no loads"),
        (["grasps.csv", "--wrenches", "grasps.csv"], "the columns are grasp, x"),
        (["loads.csv", "--wrenches", "loads.csv"], "the first line must name the columns"),
        (["grasps.csv", "--weight", "1", "--shorten"], "many grasps does not take --shorten"),
        (["grasps.csv", "--weight", "1", "--as-printed", "signs"], "does not take --as-printed"),
        (["one.csv", "--weight", "1", "--jobs", "2"], "--jobs and --dask are for many grasps"),
        (["no.npz", "--weight", "1"], "No such file"),
        (["text.npz", "--weight", "1"], "text.npz is not an NPZ file of arrays"),
        (["objects.npz", "--weight", "1"], "objects.npz is not an NPZ file of arrays"),
        (["other.npz", "--weight", "1"], "other.npz has no array points"),
        (["more.npz", "--weight", "1"], "more.npz has the array 'extra'"),
        (["letters.csv", "--weight", "1"], "line 2: x is 'left'"),
        (["grasps.csv", "--wrenches", "half.csv"], "half.csv has 0 loads of the grasp 'b, 2'"),
        (["grasps.csv", "--wrenches", "third.csv"], "loads of 'c'; expected names of grasps"),
    ],
)
def test_bad_files_refused(words, message, files, capsys):
    (files / "one.csv").write_text("x,y,nx,ny,mu\n-1,0,1,0,0.5\n")
    (files / "text.npz").write_text("points")
    np.savez("objects.npz", points=np.array([{}]), normals=1, friction=1)
    np.savez("other.npz", normals=1, friction=1)
    np.savez("more.npz", **ARRAYS, extra=1)
    (files / "letters.csv").write_text("grasp,x,y,nx,ny,mu\na,left,0,1,0,0.5\n")
    (files / "half.csv").write_text("grasp,f_x,f_y,tau\na,0,0,0\n")
    (files / "third.csv").write_text('grasp,f_x,f_y,tau\na,0,0,0\n"b, 2",0,0,0\nc,0,0,0\n')
    assert solved(*words) == 2
    assert message in capsys.readouterr().err.splitlines()[-1]


@pytest.mark.parametrize("count", [10**13, 10**30])
def test_array_larger_than_its_file_refused(files, count, capsys):
    header = io.BytesIO()
    shape = {"descr": "<f8", "fortran_order": False, "shape": (count, 2, 2)}
    np.lib.format.write_array_header_1_0(header, shape)
    with zipfile.ZipFile("large.npz", "w") as archive:
        archive.writestr("points.npy", header.getvalue())
    assert solved("large.npz", "--weight", "1") == 2
    assert "an array claims more than is in the file" in capsys.readouterr().err
