"""Files of many grasps, and ``equilibrium solve`` of them."""

import csv
import io
import re
import zipfile

import numpy as np
import pytest

from arrangement.console import terminal
from equilibrium import GraspError, read_grasp
from equilibrium.cli import program
from equilibrium.decide.many_grasps.arrays import near_floats
from equilibrium.decide.many_grasps.tables import read_grasps
from equilibrium.grasps.inputs import from_float_data
from equilibrium.model.labels import AS_ROUNDED
from tests.archives import HEADERS, mutants

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
    ["grasp", "load", "answer", "decided", "f_x", "f_y", "tau"],
    ["a", "1", "resisted", "screened", "0", "-9/10", "0"],
    ["a", "2", "not resisted", "screened", "0", "-11/10", "0"],
    ["b, 2", "1", "resisted", "exact", "0", "-9/10", "0"],
    ["b, 2", "2", "resisted", "screened", "0", "-11/10", "0"],
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


def test_table_answered_on_stdout(run):
    printed = run("solve grasps.csv --wrenches loads.csv", code=1)
    assert list(csv.reader(printed.splitlines())) == ANSWERS


def test_arrays_of_one_grasp_need_no_axis_of_grasps(files, run):
    one = {name: array[:1] for name, array in ARRAYS.items() if name in ("points", "normals")}
    np.savez("first.npz", **ARRAYS | one)
    np.savez("one.npz", **ARRAYS | {name: array[0] for name, array in one.items()})
    printed = run("solve first.npz --weight 1", code=None)
    assert run("solve one.npz --weight 1", code=None) == printed


def test_arrays_of_one_grasp_are_made_exact(files, run, capsys):
    data = {"points": [[-1, 0.1], [1, 0.1]], "normals": [[0.3, 1], [-3, 0]]}
    np.savez("one.npz", **data, friction=np.float32(0.3))
    for command in ("resisted one.npz", "info one.npz", "draw one.npz -o one.svg"):
        assert program.main(command.split()) == 2
        line = re.findall(r"`equilibrium (make floats .+?)`", capsys.readouterr().err)[0]
    run(line)
    grasp, direct = read_grasp("one.json"), from_float_data(**data, friction=0.3).grasp
    assert grasp == direct
    assert grasp.data_error.angle > 0
    np.savez("none.npz", **data)
    for command in ("make floats none.npz", "solve none.npz --weight 1"):
        assert program.main(command.split()) == 2
        line = re.findall(r"such as numpy[.](savez\(.*\))", capsys.readouterr().err)[0]
    eval(line, {"savez": np.savez, "numpy": np})  # noqa: S307
    assert program.main(["make", "floats", "none.npz"]) == 0
    assert program.main(["make", "floats", "grasps.npz"]) == 2
    assert "points of shape (2, 3, 2); expected (m, 2)" in capsys.readouterr().err
    with pytest.raises(GraspError, match=r"equilibrium make floats one.npz .*read_float_data"):
        read_grasp("one.npz")


def test_answers_written_as_csv_and_npz(files, run):
    for name in ("answers.csv", "answers.npz"):
        printed = run("solve grasps.csv --wrenches loads.csv -o", name, code=1)
        assert "2 grasps, 2 loads each: 3 resisted, 3 screened, 1 exact" in printed
    with (files / "answers.csv").open() as lines:
        assert list(csv.reader(lines)) == ANSWERS
    with np.load("answers.npz") as answers:
        assert answers["grasp"].tolist() == ["a", "b, 2"]
        assert answers["resisted"].tolist() == [[True, False], [True, True]]
        assert answers["exact"].tolist() == [[False, False], [True, False]]


def test_one_load_for_all_grasps(run):
    document = run.json("solve grasps.npz --force 0 -9/10")
    assert document["grasps"] == ["1", "2"]
    assert document["resisted"] == [[True], [True]]
    run("solve grasps.csv --weight 1.1 --preload 2 --json")


def test_loads_of_each_grasp(files, run):
    rows = ["grasp,f_x,f_y,tau", '"b, 2",0,-1.1,0', "a,0,-0.9,0"]
    (files / "own.csv").write_text("\n".join(rows))
    assert run.json("solve grasps.csv --wrenches own.csv")["resisted"] == [[True], [True]]
    np.savez("own.npz", wrenches=np.array([[[0, -0.9, 0]], [[0, -1.1, 0]]]))
    run("solve grasps.npz --wrenches own.npz")
    np.savez("whole.npz", **ARRAYS, wrenches=np.array([[[0, -0.9, 0]], [[0, -1.1, 0]]]))
    run("solve whole.npz")


def test_first_grasp_may_have_one_contact(files, run):
    path = files / "few.csv"
    path.write_text("grasp,x,y,nx,ny,mu\na,-1,0,1,0,1/2\nb,1,0,-1,0,0\nb,0,1,0,-1,1\n")
    many = read_grasps(str(path))
    assert many.names == ["a", "b"]
    assert [len(grasp) for grasp in many.source] == [1, 2]
    (points, _, friction, *_), rounded = near_floats(many.source, [[(0, 0, 0)]] * 2)
    assert points[1].tolist() == [[1, 0], [0, 1]]
    assert np.isnan(friction).tolist() == [[False, True], [False, False]]
    assert not rounded
    path.write_text("grasp,x,y,nx,ny,mu\n")
    assert read_grasps(str(path)).names == []
    run("solve {} --weight 1", path)


#: Grasps at their limit of friction, alone and as a line of loads: 2 mu q in all.
LIMITS = [
    ("0.3", "5", "0 3 0"),
    ("1/3", "3", "0 2 0"),
    ("0.1", "0.7", "0 0.14 0"),
    ("1/7", "0.1", "0 1/35 0"),
    ("3/10", "1e-3", "0 6e-4 0"),
]


@pytest.mark.parametrize("column", ["", "angle", "adhesion", "pad"])
def test_table_answers_as_each_grasp_alone(column, files, run):
    """Whatever floats make of the numbers: at the limit resisted, a little beyond it not."""
    header = {"angle": "x,y,angle,mu,q"}.get(column, "x,y,nx,ny,mu,q")
    more = {"adhesion": [",adhesion", ",0.3", ",0.3"], "pad": [",pad", ",1/3", ",0"]}
    ends = more.get(column, ["", "", ""])
    ways = ("0", "180") if column == "angle" else ("1,0", "-1,0")
    rows, loads, answers = [f"grasp,{header}{ends[0]}"], ["grasp,f_x,f_y,tau"], []
    for k, (mu, q, load) in enumerate(LIMITS):
        own = [f"{x},1,{way},{mu},{q}" for x, way in zip((-4, 4), ways, strict=True)]
        own = [line + end for line, end in zip(own, ends[1:], strict=True)]
        rows += [f"g{k},{line}" for line in own]
        (files / "alone.csv").write_text("\n".join([f"{header}{ends[0]}", *own]))
        beyond = f"{load.split()[1]}00000000000000000001" if "." in load else "3"
        for force in (load.split()[1], beyond, "0")[: 1 + k % 3]:
            loads.append(f"g{k},0,{force},0")
            printed = run("solve alone.csv --wrench 0 {} 0", force, code=None)
            answers.append([f"g{k}", printed.partition(":")[0].split("\n")[0]])
    (files / "all.csv").write_text("\n".join(rows))
    (files / "own.csv").write_text("\n".join(loads))
    printed = run("solve all.csv --wrenches own.csv", code=1)
    lines = list(csv.reader(printed.splitlines()))[1:]
    assert [[name, answer] for name, _, answer, *_ in lines] == answers
    assert {"resisted", "not resisted"} == {answer for _, answer in answers}
    assert [line[1] for line in lines] == list("112123112")


def test_typed_numbers_are_exact_for_arrays(files, run):
    """Floats of a file are binary fractions, and what is typed is what is written."""
    jaws = {"points": [[[-1, 0], [1, 0]]], "normals": [[[1, 0], [-1, 0]]], "friction": 0.5}
    np.savez("jaws.npz", **jaws, preload=1)
    (files / "third.csv").write_text("f_x,f_y,tau\n0,1/3,0\n0,0.33333333333333333334,0\n")
    printed = run("solve jaws.npz --preload 1/3 --wrenches third.csv", code=1)
    answers = [line.split(",")[2] for line in printed.splitlines()[1:]]
    assert answers == ["resisted", "not resisted"]
    run("solve jaws.npz --preload 1/3 --wrench 0 1/3 0")
    run("solve jaws.npz --wrench 0 1.00000000000000000001 0", code=1)
    for size in ("1e-400", "1e400"):
        run(f"solve jaws.npz --preload {size} --wrench 0 {size} 0")
        (files / "far.csv").write_text(f"grasp,x,y,nx,ny,mu,q\na,0,0,{size},0,0.5,{size}\n")
        run(f"solve far.csv --wrench -{size} 0 0")
        run(f"solve far.csv --wrench -{size} {size} 0", code=1)


def test_rounded_normals_are_said(files, run):
    (files / "tilted.csv").write_text("grasp,x,y,nx,ny,mu,q\na,-1,0,1,1,1,1\na,1,0,-1,0,1,1\n")
    assert run.json("solve tilted.csv --wrench 0 -1 0", code=None)["as_rounded"]
    assert f"normals were rounded; answers are {AS_ROUNDED}" in run.err


def test_grasps_in_space_read(files, run):
    lines = ["grasp,x,y,z,nx,ny,nz,friction,preload"]
    lines += [f"{g},0,0,{z},0,0,{-z},1/2,1" for g in "ab" for z in (1, -1)]
    (files / "space.csv").write_text("\n".join(lines))
    (files / "six.csv").write_text("f_x,f_y,f_z,tau_x,tau_y,tau_z\n0,0.5,0,0,0,0\n")
    assert run.json("solve space.csv --wrenches six.csv")["resisted"] == [[True], [True]]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("grasps.csv", "the grasps have no loads"),
        ("grasps.csv --wrenches grasps.csv", "the columns are grasp, x"),
        ("loads.csv --wrenches loads.csv", "the column x is missing"),
        ("grasps.csv --weight 1 --shorten", "--shorten is for one body, not for a file"),
        ("grasps.csv --weight 1 --as-printed signs", "--as-printed is for one body"),
        ("one.csv --weight 1 --jobs 2", "--jobs is for a file of many grasps, not"),
        ("no.npz --weight 1", "No such file"),
        ("text.npz --weight 1", "text.npz is not an NPZ file of arrays"),
        ("objects.npz --weight 1", "objects.npz is not an NPZ file of arrays"),
        ("bare.npz --weight 1", "bare.npz is not an NPZ file of arrays"),
        ("other.npz --weight 1", "other.npz has no array points"),
        ("more.npz --weight 1", "more.npz has unknown arrays 'extra'"),
        ("letters.csv --weight 1", "line 2: x is 'left'"),
        ("grasps.csv --wrenches half.csv", "half.csv has no loads of the grasp 'b, 2'"),
        ("grasps.csv --wrench 0 0 1 0 0 0", "wrench has 6 entries"),
        ("bodies.csv --weight 1", "the columns 'body_a', 'body_b' are unknown"),
        ("grasps.csv --wrenches third.csv", "loads of 'c'; expected names of grasps"),
    ],
)
def test_bad_files_refused(words, message, files, refused):
    (files / "one.csv").write_text("x,y,nx,ny,mu\n-1,0,1,0,0.5\n")
    (files / "text.npz").write_text("points")
    (files / "bodies.csv").write_text("grasp,body_a,body_b,x,y,nx,ny,mu\n")
    np.savez("objects.npz", points=np.array([{}]), normals=1, friction=1)
    with zipfile.ZipFile("bare.npz", "w") as archive:
        for name in ("points", "normals", "friction"):
            archive.writestr(name, "1")
    np.savez("other.npz", normals=1, friction=1)
    np.savez("more.npz", **ARRAYS, extra=1)
    (files / "letters.csv").write_text("grasp,x,y,nx,ny,mu\na,left,0,1,0,0.5\n")
    (files / "half.csv").write_text("grasp,f_x,f_y,tau\na,0,0,0\n")
    (files / "third.csv").write_text('grasp,f_x,f_y,tau\na,0,0,0\n"b, 2",0,0,0\nc,0,0,0\n')
    assert message in refused(f"solve {words}")


@pytest.mark.parametrize("count", [10**13, 10**30])
def test_array_larger_than_its_file_refused(files, count, refused):
    header = io.BytesIO()
    shape = {"descr": "<f8", "fortran_order": False, "shape": (count, 2, 2)}
    np.lib.format.write_array_header_1_0(header, shape)
    with zipfile.ZipFile("large.npz", "w") as archive:
        archive.writestr("points.npy", header.getvalue())
    assert "an array claims more than is in the file" in refused("solve large.npz --weight 1")


@pytest.mark.parametrize("count", [20, pytest.param(2000, marks=pytest.mark.slow)])
def test_damaged_archives_are_bad_input(count, files, capsys):
    np.savez_compressed("whole.npz", **ARRAYS)
    kinds, parser = len(HEADERS) + 4, program._parser()
    for number, content in enumerate(mutants((files / "whole.npz").read_bytes(), count, 1)):
        (files / "damaged.npz").write_bytes(content)
        code = terminal.run(parser, ["solve", "damaged.npz", "--weight", "1"])
        assert code == 2 or (number >= kinds and code in (0, 1)), number
        if code == 2:
            message = capsys.readouterr().err
            assert message.startswith("error: ")
            assert message.count("\n") == 1
