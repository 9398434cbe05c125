"""How the verified checker is found and called; a script stands in for it here."""

import json
from pathlib import Path

import pytest

from arrangement.errors import InputError
from arrangement.planes import proved
from arrangement.planes.proved import PROGRAM
from equilibrium import CertificateError, read_grasp, solve, verify
from equilibrium.grasps.files import verify_proved


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the only folder in which programs are looked for."""
    monkeypatch.setattr(proved.sys, "executable", str(tmp_path / "python"))
    monkeypatch.setenv("PATH", str(tmp_path))
    return tmp_path


def program(folder: Path, line: str, code: int) -> None:
    path = folder / PROGRAM
    path.write_text(f"#!/bin/sh\necho '{line}'\nexit {code}\n", encoding="utf-8")
    path.chmod(0o755)


def test_without_the_program_the_error_says_how_to_build_it(folder):
    with pytest.raises(CertificateError, match=r"not built.*make formal"):
        verify_proved("certificate.json")


@pytest.mark.parametrize("kind", ["resisted", "not resisted"])
def test_answers(folder, kind):
    program(folder, f"accepted: {kind}", 0)
    assert verify_proved("certificate.json") == (True, kind)
    program(folder, f"refused: {kind}", 1)
    assert verify_proved("certificate.json") == (False, kind)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("malformed: a number is a float", 2),
        ("accepted: resisted", 1),
        ("refused: resisted", 0),
        ("", 0),
        ("accepted: resisted", 137),
    ],
)
def test_no_other_answer_is_taken(folder, line, code):
    program(folder, line, code)
    with pytest.raises(CertificateError, match="cannot read"):
        verify_proved("certificate.json")


def test_a_certificate_of_planes_is_none_of_a_grasp(folder):
    program(folder, "accepted: all faces", 0)
    with pytest.raises(CertificateError, match="all faces, not of a grasp"):
        verify_proved("certificate.json")


@pytest.mark.skipif(proved.program() is None, reason="`make formal` has not built it")
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"enclosure": {}}, "Krawczyk"),
        ({"pyramid": 4}, "friction pyramids"),
        ({"max_displacement": "1"}, "a largest displacement"),
        ({"bounds": {}}, "bounds of grasps"),
        ({"tree": {"plane": [], "tree": []}}, "planar along two axes"),
        ({"tree": {"contact": 0, "faces": []}}, "friction pyramids"),
        ({"tree": {"contact": 0, "directions": []}}, "children"),
    ],
)
def test_outside_the_spatial_theorems_refused_by_name(tmp_path, change, words):
    path = tmp_path / "certificate.json"
    document = solve(read_grasp("two-opposed-fingers"), (0, 0, -3, 0, 0, 0)).certificate.to_dict()
    path.write_text(json.dumps(document))
    assert verify_proved(path) == (True, "not resisted")
    path.write_text(json.dumps({**document, **change}))
    with pytest.raises(CertificateError, match=f"cannot read.*{words}"):
        verify_proved(path)
    if words == "children":
        with pytest.raises(InputError, match="children"):
            verify(path)


def test_a_path_is_no_option(folder):
    (folder / PROGRAM).write_text('#!/bin/sh\necho "malformed: <$*>"\nexit 2\n')
    (folder / PROGRAM).chmod(0o755)
    with pytest.raises(CertificateError, match=r"<\./--question>"):
        verify_proved("--question")
    with pytest.raises(CertificateError, match="<->"):
        verify_proved("-")


def test_the_command_says_which_checker_spoke(folder, run, refused):
    path, asked = str(folder / "certificate.json"), ["--wrench", "1", "0", "0", "--grasp"]
    solve(read_grasp("single-contact"), (1, 0, 0)).certificate.save(path)
    program(folder, "accepted: not resisted", 0)
    answer, *question = run("verify --verified", path).splitlines()
    assert answer == "valid: not resisted (by the verified checker)"
    assert question[0] == "wrench (1, 0, 0)"
    run("verify --verified", path, *asked, "single-contact")
    printed = run("verify --verified", path, *asked, "opposed-contacts", code=1)
    assert "it is about another grasp" in printed
    assert "wrench (" not in run("verify --verified -")
    refused("verify --verified -", *asked, "single-contact")
    program(folder, "refused: resisted", 1)
    found = run.json("verify --verified", path, code=1)
    said = ("valid", "certificate", "checker", "compared")
    assert [found[key] for key in said] == [False, "resisted", "proved", False]
    program(folder, "malformed: a number is a float", 2)
    assert "a number is a float" in refused("verify --verified", path)
