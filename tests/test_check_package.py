"""The check of the packages finds what would be wrong with them."""

import os
import shlex
import subprocess
import sys
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from tests import browser as browsers
from tests.browser import Browser
from tests.check_package import FILES, complaints, untried, wrong_files, wrong_tags
from tests.check_site import check_page
from tests.package_commands import PROGRAMS, Command

WHEEL = {
    "arrangement/__init__.py",
    "arrangement/py.typed",
    "equilibrium/grasps/instances/contacts/a.json",
}
ARCHIVE = WHEEL | FILES | {"tests/test_a.py", "docs/index.rst", "PKG-INFO", ".gitignore"}
TRACKED = WHEEL | FILES | {"tests/test_a.py", "docs/index.rst", ".ci/run"}


def test_whole_packages_are_right():
    assert wrong_files(ARCHIVE, WHEEL, TRACKED) == []
    assert wrong_files(ARCHIVE, WHEEL, set()) == []


@pytest.mark.parametrize(
    ("tags", "heading", "wrong"),
    [
        ([], "unreleased", []),
        (["v0.1.0"], "2026-12-01", []),
        (
            ["v0.1.0"],
            "unreleased",
            ["the changelog dates the release 'unreleased'; expected a day"],
        ),
        (["v0.2.0", "talk"], "2026-12-01", ["the tag is v0.2.0; the version is 0.1.0"]),
    ],
)
def test_a_wrong_tag_is_found(tags, heading, wrong):
    changelog = f"# Changelog\n\n## [0.1.0] - {heading}\n\n- First.\n"
    assert wrong_tags(tags, "0.1.0", changelog) == wrong


RUBBISH = (
    "docs/_build/html/index.html",
    "docs/_generated/first-page.svg",
    "docs/api/names/equilibrium.Grasp.rst",
    "report/verdicts.html",
    "arrangement/__pycache__/planes.cpython-311.pyc",
    "tests/.hypothesis/examples/x",
    ".venv/bin/python",
    "sweep.sqlite",
)
#: What is in the archive and the wheel, and what is said. What makes shipped data is not rubbish.
WRONG = [
    *((ARCHIVE | {path}, WHEEL, f"rubbish in the source archive: {path}") for path in RUBBISH),
    *(
        (ARCHIVE - {path}, WHEEL, f"not in the source archive: {path}")
        for path in ("Makefile", "docs/index.rst", "equilibrium/grasps/instances/contacts/a.json")
    ),
    *((ARCHIVE, WHEEL - {x}, f"in the source archive, not in the wheel: {x}") for x in WHEEL),
    *(
        (ARCHIVE, WHEEL | {path}, f"in the wheel, not in the source archive: {path}")
        for path in ("tests/test_a.py",)
    ),
]


@pytest.mark.parametrize(("archive", "wheel", "said"), sorted(WRONG, key=lambda row: row[2]))
def test_a_wrong_file_is_found(archive, wheel, said):
    found = wrong_files(archive, wheel, TRACKED)
    assert said in found
    assert {line.rpartition(": ")[2] for line in found} == {said.rpartition(": ")[2]}


def test_every_command_of_the_programs_is_tried():
    listed = subprocess.run([sys.executable, "-c", PROGRAMS], capture_output=True, check=True)
    programs = [line.split() for line in listed.stdout.decode().splitlines()]
    assert ["equilibrium", "make", "csv"] in programs
    assert untried(programs) == []
    assert untried([*programs, ["arrangement", "planted"]]) == [
        "no command here tries arrangement planted"
    ]
    assert untried([]) != []


PICTURE = Command("arrangement draw braid-a3 -o no.svg", 2, "(the extra figures)")


@pytest.mark.parametrize(
    ("code", "said", "leaves", "complaint"),
    [
        (1, "Traceback (most recent call last)\n(the extra figures)", None, "a traceback"),
        (0, "(the extra figures)", None, "exit code 0, not 2"),
        (2, "error: no module named matplotlib", None, "does not say '(the extra figures)"),
        (2, "(the extra figures)", "no.svg", "leaves a file"),
    ],
)
def test_a_wrong_refusal_is_found(tmp_path, code, said, leaves, complaint):
    right = CompletedProcess([], 2, "", "error: matplotlib is missing (the extra figures)\n")
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


DOT = "data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw=="


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site").mkdir()
    return tmp_path / "site"


def check(browser: Browser, site: Path, body: str) -> list[str]:
    page = site / "page.html"
    page.write_text(
        f'<!DOCTYPE html><link rel="icon" href="data:,"><title>t</title>{body}', encoding="utf-8"
    )
    return check_page(browser, page, site)


def test_a_page_that_holds_all_it_needs_is_right(browser, site):
    (site / "own.js").write_text("document.title = 'own';", encoding="utf-8")
    body = f'<img src="{DOT}"><script src="own.js"></script>'
    assert check(browser, site, body) == []


@pytest.mark.parametrize(
    ("body", "complaint"),
    [
        ('<img src="http://127.0.0.1:9/x.png">', "request to http://127.0.0.1:9/x.png"),
        ('<script src="https://127.0.0.1:9/x.js"></script>', "request to https://127.0.0.1:9/x.js"),
        ("<script>fetch('http://127.0.0.1:9/').catch(() => 0)</script>", "request to http:"),
        ("<script>new WebSocket('ws://127.0.0.1:9/')</script>", "request to ws:"),
        ('<img src="../beside.png">', "request to file:"),
        ('<img src="absent.png">', "a picture is missing: absent.png"),
        ("<script>throw new Error('broken')</script>", "console:"),
        ("<script>console.warn('odd')</script>", "console:"),
        (r'<span class="math">\(x^2\)</span>', "mathematics is not typeset"),
    ],
)
def test_each_defect_is_found(body, complaint, browser, site):
    assert any(text.startswith(complaint) for text in check(browser, site, body))


ROOT = Path(__file__).resolve().parent.parent
PACKAGES = "apt-get install chromium chromium-driver"


@pytest.mark.parametrize(
    ("choice", "present", "said"),
    [
        ("", True, None),
        ("", False, PACKAGES),
        ("0", True, "BROWSER_TESTS=0"),
        ("0", False, "BROWSER_TESTS=0"),
        ("1", True, None),
        ("1", False, None),
    ],
)
def test_choice_and_browser_decide_what_is_left_out(choice, present, said, monkeypatch):
    monkeypatch.setenv("BROWSER_TESTS", choice)
    monkeypatch.setattr(browsers, "programs", lambda: ("a", "b") if present else None)
    reason = browsers.left_out()
    assert (said in reason) if said else reason is None


SUITE = (
    "-m pytest -q -p no:cacheprovider -m 'slow or not slow'"
    " tests/test_check_package.py::test_a_page_that_holds_all_it_needs_is_right"
    " tests/test_layers.py::test_counts_work_with_the_enumerators_out_of_reach"
)
SLOW = pytest.mark.slow


@pytest.mark.parametrize(
    ("choice", "present", "command", "code", "said"),
    [
        pytest.param(None, False, SUITE, 0, ["1 passed, 1 deselected", PACKAGES], marks=SLOW),
        pytest.param("1", False, SUITE, 1, ["1 passed, 1 error", PACKAGES], marks=SLOW),
        (None, False, "tests/check_site.py none", 0, [PACKAGES]),
        ("0", True, "tests/check_site.py none", 0, ["BROWSER_TESTS=0"]),
        ("1", False, "tests/check_site.py none", 1, [PACKAGES]),
        (None, True, "tests/check_site.py none", 1, ["there are no pages"]),
    ],
)
def test_omissions_reported_and_demands_checked(choice, present, command, code, said, tmp_path):
    """The path of programs has one folder, with or without a browser in it."""
    for name in ("chromium", "chromedriver") if present else ():
        (tmp_path / name).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / name).chmod(0o755)
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST_", "BROWSER_"))}
    environment |= {"PATH": str(tmp_path)} | ({"BROWSER_TESTS": choice} if choice else {})
    done = subprocess.run(
        [sys.executable, *shlex.split(command)], cwd=ROOT, env=environment, capture_output=True,
        text=True, timeout=120, check=False,
    )  # fmt: skip
    printed = done.stdout + done.stderr
    assert done.returncode == code, printed
    assert all(text in printed for text in said), printed
    assert ("left out" in printed) <= (PACKAGES in said or choice == "0")
