"""The check of the packages finds what would be wrong with them."""

import subprocess
import sys
from subprocess import CompletedProcess

import pytest

from tests.check_package import FILES, complaints, untried, wrong_files
from tests.package_commands import PROGRAMS, Command

WHEEL = {
    "arrangement/__init__.py",
    "arrangement/py.typed",
    "equilibrium/grasps/instances/contacts/a.json",
}
WORKSHOP = "arrangement/library/census/workshop/build.py"
ARCHIVE = WHEEL | FILES | {"tests/test_a.py", "docs/index.rst", "PKG-INFO", ".gitignore", WORKSHOP}
TRACKED = WHEEL | FILES | {"tests/test_a.py", "docs/index.rst", ".ci/run"}


def test_whole_packages_are_right():
    assert wrong_files(ARCHIVE, WHEEL, TRACKED) == []
    assert wrong_files(ARCHIVE, WHEEL, set()) == []


@pytest.mark.parametrize(
    "path",
    [
        "docs/_build/html/index.html",
        "docs/_generated/first-page.svg",
        "docs/reference/arrangement/arrangement.rst",
        "report/verdicts.html",
        "arrangement/__pycache__/planes.cpython-311.pyc",
        "tests/.hypothesis/examples/x",
        ".venv/bin/python",
        "sweep.sqlite",
    ],
)
def test_rubbish_in_the_source_archive_is_found(path):
    assert f"rubbish in the source archive: {path}" in wrong_files(ARCHIVE | {path}, WHEEL, TRACKED)


@pytest.mark.parametrize(
    "path", ["Makefile", "docs/index.rst", "equilibrium/grasps/instances/contacts/a.json"]
)
def test_a_file_that_the_source_archive_lacks_is_found(path):
    assert f"not in the source archive: {path}" in wrong_files(ARCHIVE - {path}, WHEEL, TRACKED)


@pytest.mark.parametrize("path", sorted(WHEEL))
def test_a_file_that_the_wheel_lacks_is_found(path):
    assert wrong_files(ARCHIVE, WHEEL - {path}, TRACKED) == [
        f"in the source archive, not in the wheel: {path}"
    ]


@pytest.mark.parametrize("path", ["tests/test_a.py", WORKSHOP])
def test_a_file_that_only_the_wheel_has_is_found(path):
    """What makes shipped data stays in the source archive."""
    assert wrong_files(ARCHIVE, WHEEL | {path}, TRACKED) == [
        f"in the wheel, not in the source archive: {path}"
    ]


def test_every_command_of_the_programs_is_tried():
    listed = subprocess.run([sys.executable, "-c", PROGRAMS], capture_output=True, check=True)
    programs = [line.split() for line in listed.stdout.decode().splitlines()]
    assert ["equilibrium", "make", "csv"] in programs
    assert untried(programs) == []
    assert untried([*programs, ["arrangement", "planted"]]) == [
        "no command here tries arrangement planted"
    ]
    assert untried([]) != []


PICTURE = Command("arrangement draw braid-a3 -o no.svg", 2, "slipstates[figures]")


@pytest.mark.parametrize(
    ("code", "said", "leaves", "complaint"),
    [
        (1, "Traceback (most recent call last)\nslipstates[figures]", None, "a traceback"),
        (0, "slipstates[figures]", None, "exit code 0, not 2"),
        (2, "error: no module named matplotlib", None, "does not say 'slipstates[figures]'"),
        (2, "slipstates[figures]", "no.svg", "leaves a file"),
    ],
)
def test_a_wrong_refusal_is_found(tmp_path, code, said, leaves, complaint):
    right = CompletedProcess([], 2, "", "error: pip install 'slipstates[figures]'\n")
    assert complaints(PICTURE, right, tmp_path) == []
    if leaves:
        (tmp_path / leaves).touch()
    found = complaints(PICTURE, CompletedProcess([], code, "", said), tmp_path)
    assert any(complaint in text for text in found)


def test_an_absent_or_empty_file_is_found(tmp_path):
    command = Command("arrangement draw braid-a3 -o dual.stl", 0, writes="dual.stl")
    done = CompletedProcess([], 0, "", "")
    assert complaints(command, done, tmp_path) != []
    (tmp_path / "dual.stl").touch()
    assert complaints(command, done, tmp_path) != []
    (tmp_path / "dual.stl").write_bytes(b"solid")
    assert complaints(command, done, tmp_path) == []
