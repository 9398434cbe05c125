"""The command `arrangement`: its JSON contract, its exit codes, its manners."""

from __future__ import annotations

import io
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement, __version__, read_arrangement
from arrangement.cli import main
from arrangement.counts import essentialization

Capture = pytest.CaptureFixture[str]


def call(capsys: Capture, *arguments: str) -> tuple[int, str, str]:
    code = main(arguments)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def command(*arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "arrangement", *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
        **options,
    )


def test_count_in_json(capsys: Capture) -> None:
    code, out, err = call(capsys, "count", "coincident-planes", "--json")
    assert (code, err) == (0, "")
    assert json.loads(out) == {
        "planes": 4,
        "distinct_planes": 2,
        "rank": 2,
        "f_vector": [0, 1, 4, 4],
        "states": 9,
        "engine": "great-circles",
    }
    assert out.count("\n") == 1


def test_count_for_people(capsys: Capture) -> None:
    code, out, _ = call(capsys, "count", "three-generic-planes")
    assert code == 0
    assert [line.split()[-1] for line in out.splitlines()] == [*"333", "1", "6", "12", "8", "27"]


def test_faces_in_json_are_one_object_a_line(capsys: Capture) -> None:
    code, out, _ = call(capsys, "faces", "shi-a2-affine", "--json")
    faces = [json.loads(line) for line in out.splitlines()]
    assert code == 0
    assert len(faces) == 6 + 21 + 16
    planes = Arrangement(
        [[1, 0], [1, 0], [0, 1], [0, 1], [1, 1], [1, 1]], offsets=[0, 1, 0, 1, 0, 1]
    )
    for face in faces:
        assert set(face) == {"signs", "dimension", "witness"}
        assert all(type(text) is str for text in face["witness"])
        assert list(planes.signs_at(face["witness"])) == face["signs"]


def test_faces_of_one_dimension(capsys: Capture) -> None:
    code, out, _ = call(capsys, "faces", "three-generic-planes", "--dimension", "1", "--json")
    assert code == 0
    assert [json.loads(line)["dimension"] for line in out.splitlines()] == [1] * 6
    code, out, _ = call(capsys, "faces", "three-generic-planes", "--dimension", "3")
    assert code == 0
    assert sorted(line.split()[0] for line in out.splitlines()) == sorted(
        a + b + c for a in "+-" for b in "+-" for c in "+-"
    )


def test_list_names_the_built_in_documents(capsys: Capture) -> None:
    code, out, _ = call(capsys, "list", "--json")
    assert code == 0
    entries = json.loads(out)["names"]
    names = [entry["name"] for entry in entries]
    assert names == sorted(names)
    assert "reflection-b3" in names
    code, out, _ = call(capsys, "list")
    assert [line.split()[0] for line in out.splitlines()] == names


@pytest.mark.parametrize(
    "arguments",
    [
        ("count", "no/such/file"),
        ("faces", "three-generic-planes", "--dimension", "4"),
        ("faces", "three-generic-planes", "--dimension", "-1"),
        ("faces", "no/such/file", "--json"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys: Capture, arguments: tuple[str, ...]) -> None:
    code, out, err = call(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.startswith("error: ")
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        (),
        ("count",),
        ("conut", "pencil"),
        ("count", "pencil", "extra"),
        ("count", "pencil", "--js"),
        ("faces", "pencil", "--dimension", "one"),
        ("faces", "pencil", "--dimension", "1.5"),
    ],
)
def test_wrong_usage_is_exit_code_2(capsys: Capture, arguments: tuple[str, ...]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    captured = capsys.readouterr()
    assert (caught.value.code, captured.out) == (2, "")
    assert "error: " in captured.err


def test_standard_input_is_read() -> None:
    text = '{"schema_version": 1, "planes": [["1", "0"], ["0", "1"]], "offsets": [0, "1/2"]}'
    done = command("count", "-", "--json", input=text)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["f_vector"] == [1, 4, 4]


def test_code_in_a_file_is_never_run(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    code = f"__import__('pathlib').Path({str(victim)!r}).touch()"
    path = tmp_path / "file.json"
    path.write_text(json.dumps({"schema_version": 1, "planes": [[code]]}), encoding="utf-8")
    done = command("count", str(path))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("error: ")
    assert not victim.exists()


def test_control_characters_of_a_file_do_not_reach_the_terminal(tmp_path: Path) -> None:
    path = tmp_path / "file.json"
    path.write_text('{"schema_version": 1, "\\u001b[31m": 1, "planes": []}', encoding="utf-8")
    done = command("count", str(path))
    assert done.returncode == 2
    assert "\x1b" not in done.stderr


def test_a_closed_pipe_ends_quietly() -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "arrangement", "faces", "nine-generic-planes", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == ""
        assert process.wait(timeout=60) in (0, 141)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs /dev/full")
def test_a_full_disk_is_said_without_traceback() -> None:
    with Path("/dev/full").open("w", encoding="utf-8") as full:
        done = subprocess.run(
            [sys.executable, "-m", "arrangement", "count", "pencil"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr.startswith("error: cannot write")
    assert "Traceback" not in done.stderr


def test_version_and_help() -> None:
    assert command("--version").stdout == f"arrangement {__version__}\n"
    for arguments in (("--help",), ("count", "--help"), ("faces", "--help")):
        done = command(*arguments)
        assert done.returncode == 0
        assert "usage: arrangement" in done.stdout


def test_no_numerical_library_is_loaded_for_help() -> None:
    code = (
        "import sys\n"
        "from arrangement.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit: pass\n"
        "heavy = {'numpy', 'scipy', 'sympy', 'networkx', 'trimesh', 'matplotlib'}\n"
        "sys.exit(', '.join(heavy & set(sys.modules)))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=60
    )
    assert done.stderr.strip() == ""


def test_faces_appear_while_they_are_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines go out one by one, not as one block at the end."""
    writes: list[str] = []

    class Recorder(io.StringIO):
        def write(self, text: str) -> int:
            writes.append(text)
            return len(text)

    monkeypatch.setattr(sys, "stdout", Recorder())
    assert main(["faces", "three-generic-planes", "--json"]) == 0
    assert sum(text.startswith("{") for text in writes) == 27


def test_a_grasp_stands_for_its_tangential_planes(capsys: Capture, tmp_path: Path) -> None:
    """The four-contact grasp of [HaasHeger2018]: contacts 1, 2 and 3, 4 share their planes."""
    contacts = [
        {"point": [x, y], "normal": [str(-x), "0"], "friction": "1/2"}
        for x, y in ((-1, 1), (-1, -1), (1, -1), (1, 1))
    ]
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps({"schema_version": 1, "contacts": contacts}), encoding="utf-8")
    code, out, _ = call(capsys, "count", str(path), "--json")
    assert code == 0
    counts = json.loads(out)
    assert (counts["planes"], counts["distinct_planes"], counts["rank"]) == (4, 2, 2)
    assert (counts["f_vector"], counts["states"]) == ([0, 1, 4, 4], 9)


def test_bounds_are_met_by_generic_planes_from_three_on(capsys: Capture, tmp_path: Path) -> None:
    picture = tmp_path / "bounds.svg"
    assert main(["bounds", "--largest", "6", "--json", "-o", str(picture)]) == 0
    table = json.loads(capsys.readouterr().out)["counts"]
    assert [row["m"] for row in table] == [1, 2, 3, 4, 5, 6]
    for row in table[2:]:
        assert row["regions"] == row["printed_regions"] <= row["bound"]
        assert row["states"] == row["printed_states"]
    assert (table[1]["states"], table[1]["printed_states"]) == (9, 11)
    assert picture.read_text().startswith("<?xml")
    assert main(["bounds", "--largest", "4"]) == 0
    assert "m 4  rays 12  facets 24  regions 14  states 51" in capsys.readouterr().out


@pytest.mark.parametrize("words", [["--largest", "3"], ["--largest", "31"], ["-o", "x.html"]])
def test_bounds_out_of_range_are_refused(
    capsys: Capture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["bounds", *words]) == 2
    printed = capsys.readouterr()
    assert (printed.out, printed.err.count("\n")) == ("", 1)
    assert not list(tmp_path.iterdir())


def test_polynomial_of_a_family_member(capsys: Capture, tmp_path: Path) -> None:
    path = str(tmp_path / "shi.json")
    assert call(capsys, "make", "shi", "--type", "D4", "-o", path) == (0, "", "")
    code, out, err = call(capsys, "polynomial", path)
    assert (code, err) == (0, "")
    rows = dict(line.split("  ", 1) for line in out.splitlines()[1:])
    assert {name: value.strip() for name, value in rows.items()} == {
        "factors": "(t - 6)**4",
        "regions": "2401",
        "bounded regions": "625",
        "relatively bounded": "625",
    }
    code, out, _ = call(capsys, "polynomial", path, "--json")
    assert json.loads(out) == {
        "first_whitney_numbers": [1, -24, 216, -864, 1296],
        "regions": 2401,
        "bounded_regions": 625,
        "relatively_bounded_regions": 625,
    }


def test_regions_bounded_in_the_span_of_the_normals_are_counted(
    capsys: Capture, tmp_path: Path
) -> None:
    path = str(tmp_path / "linial.json")
    call(capsys, "make", "linial", "--type", "4", "-o", path)
    bounded = len(essentialization(read_arrangement(path)).bounded_regions())
    code, out, _ = call(capsys, "polynomial", path, "--json")
    assert (code, *list(json.loads(out).values())[1:]) == (0, 36, 0, bounded)
    assert (
        f"bounded regions     0\nrelatively bounded  {bounded}\n"
        in call(capsys, "polynomial", path)[1]
    )


def test_a_time_limit_is_an_error_with_what_is_known(capsys: Capture, tmp_path: Path) -> None:
    path = str(tmp_path / "resonance.json")
    call(capsys, "make", "resonance", "--n", "7", "-o", path)
    code, out, err = call(capsys, "polynomial", path, "--time-limit", "1e-6")
    assert (code, out) == (2, "")
    assert "first Whitney numbers 1 are final; give more time" in err


def test_members_of_all_families_can_be_made_and_read(capsys: Capture) -> None:
    _, out, _ = call(capsys, "list", "--families", "--json")
    described = {entry["name"]: entry["description"] for entry in json.loads(out)["names"]}
    values = {"n": "3", "m": "4", "d": "3", "type": "B3", "planes": "9", "number": "1"}
    values |= {"graph": "1-2,2-3", "polytope": "demicube"}
    for name, text in described.items():
        usage = text.split(":")[0].replace("[", "").replace("]", "").split()
        options = [word for word in usage if word.startswith("--")]
        given = [word for o in options if o[2:] in values for word in (o, values[o[2:]])]
        code, out, err = call(capsys, "make", name, *given)
        assert (code, err) == (0, "")
        planes = read_arrangement(json.loads(out))
        assert len(planes) > 0
        assert json.loads(out)["description"].startswith(name)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("shi", "--type", "E9"), "the type is 'E9'; there are A1"),
        (("coxeter", "--type", "H5"), "as mirrors H3, H4 and I2(m)"),
        (("shi", "--type", "A2", "--m", "0"), "m is 0; it must be at least 1"),
        (("resonance", "--n", "0"), "n is 0; it must be at least 1"),
        (("catalan", "--type", "1-2;2-3"), "write its edges as 1-2,2-3"),
        (("separations", "--polytope", "simplex", "--n", "3"), "there are cube, demicube"),
    ],
)
def test_members_that_do_not_exist(capsys: Capture, words: list[str], message: str) -> None:
    code, out, err = call(capsys, "make", *words)
    assert (code, out) == (2, "")
    assert message in err
