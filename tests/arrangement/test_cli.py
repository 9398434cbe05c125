"""The command `arrangement`: its JSON contract, its exit codes, its manners."""

import io
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement, read_arrangement
from arrangement.counts import essentialization
from arrangement.errors import InputError


def command(*arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "arrangement", *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
        **options,
    )


def test_count_in_json(run):
    out = run("count coincident-planes --json")
    assert run.err == ""
    assert json.loads(out) == {
        "planes": 4,
        "distinct_planes": 2,
        "rank": 2,
        "f_vector": [0, 1, 4, 4],
        "states": 9,
        "engine": "great-circles",
        "first_whitney_numbers": [1, -2, 1],
        "regions": 4,
        "bounded_regions": 0,
        "relatively_bounded_regions": 0,
    }
    assert out.count("\n") == 1


def test_faces_in_json_are_one_object_a_line(run):
    faces = [json.loads(line) for line in run("faces shi-a2-affine --json").splitlines()]
    assert len(faces) == 6 + 21 + 16
    planes = Arrangement(
        [[1, 0], [1, 0], [0, 1], [0, 1], [1, 1], [1, 1]], offsets=[0, 1, 0, 1, 0, 1]
    )
    for face in faces:
        assert set(face) == {"signs", "dimension", "witness"}
        assert all(type(text) is str for text in face["witness"])
        assert list(planes.signs_at(face["witness"])) == face["signs"]


def test_faces_of_one_dimension(run):
    out = run("faces three-generic-planes --dimension 1 --json")
    assert [json.loads(line)["dimension"] for line in out.splitlines()] == [1] * 6
    out = run("faces three-generic-planes --dimension 3")
    assert sorted(line.split()[0] for line in out.splitlines()) == sorted(
        a + b + c for a in "+-" for b in "+-" for c in "+-"
    )


def test_standard_input_is_read():
    text = '{"schema_version": 1, "planes": [["1", "0"], ["0", "1"]], "offsets": [0, "1/2"]}'
    done = command("count", "-", "--json", input=text)
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["f_vector"] == [1, 4, 4]


def test_a_closed_pipe_ends_quietly():
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
def test_a_full_disk_is_said_without_traceback():
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


def test_faces_appear_while_they_are_written(monkeypatch, run):
    """Lines go out one by one, not as one block at the end."""
    writes: list[str] = []

    class Recorder(io.StringIO):
        def write(self, text):
            writes.append(text)
            return len(text)

    monkeypatch.setattr(sys, "stdout", Recorder())
    run("faces three-generic-planes --json")
    assert sum(text.startswith("{") for text in writes) == 27


def test_what_takes_too_long_is_left_out_with_its_reason(run, tmp_path):
    run("make coxeter --type E8 -o", tmp_path / "e8.json")
    counted = run.json("count", tmp_path / "e8.json")
    assert (counted["regions"], counted["f_vector"]) == (696729600, None)
    assert counted["engine"].endswith("696,729,600 regions; --limit 42 allows it")


def test_a_name_that_is_none_is_answered(refused):
    assert "did you mean the built-in braid-a3" in refused("count A3")
    for name, answer in (
        ("braid:3", "did you mean the built-in braid-a3? `list` prints names, `arrangement list "),
        ("regular polygon 7", "; `list` prints names, `arrangement list --families` what `arrang"),
    ):
        with pytest.raises(InputError) as error:
            read_arrangement(name)
        assert answer in str(error.value)
    assert "write" not in refused("count polygon.json")


def test_regions_bounded_in_the_span_of_the_normals_are_counted(run, tmp_path):
    path = tmp_path / "linial.json"
    run("make linial --type 4 -o", path)
    bounded = len(essentialization(read_arrangement(path)).bounded_regions())
    assert list(run.json("count", path).values())[-3:] == [36, 0, bounded]
    assert (
        "bounded regions     0 (every region contains a line, as the normals span 3 of 4 "
        f"dimensions)\nrelatively bounded  {bounded} (in the span of the normals)\n"
        in run("count", path)
    )


def test_members_of_all_families_can_be_made_and_read(run):
    listed = run.json("list --families")["names"]
    described = {entry["name"]: entry["description"] for entry in listed}
    values = {"n": 4, "m": 4, "d": 3, "corners": 5, "type": "B3", "planes": 9, "number": 1}
    values |= {"graph": "1-2,2-3", "polytope": "demicube", "points": "0,0;1,0;0,2"}
    for name, text in described.items():
        usage = text.split(":")[0].replace("[", "").replace("]", "").split()
        options = [word for word in usage if word.startswith("--")]
        given = [word for o in options if o[2:] in values for word in (o, values[o[2:]])]
        document = json.loads(run("make", name, *given))
        assert run.err == ""
        assert len(read_arrangement(document)) > 0
        assert document["description"].startswith(name)
