"""Where there is no browser, the suite still runs, and says what it left out."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PAGE_TEST = "tests/test_check_site.py::test_a_page_that_holds_all_it_needs_is_right"
OTHER_TEST = "tests/test_layers.py::test_counts_work_with_the_enumerators_out_of_reach"
PACKAGES = "apt-get install chromium chromium-driver"


def run(
    folder: Path, choice: str | None, *command: str, present: bool = False
) -> subprocess.CompletedProcess[str]:
    """Run Python where the path of programs has one folder, with or without a browser in it."""
    for name in ("chromium", "chromedriver") if present else ():
        (folder / name).write_text("#!/bin/sh\nexit 1\n")
        (folder / name).chmod(0o755)
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST_", "BROWSER_"))}
    environment["PATH"] = str(folder)
    if choice is not None:
        environment["BROWSER_TESTS"] = choice
    return subprocess.run(
        [sys.executable, *command],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def pytest_run(folder: Path, choice: str | None, *options: str, present: bool = False) -> str:
    base = ("-m", "pytest", "-q", "-p", "no:cacheprovider", PAGE_TEST, OTHER_TEST)
    return run(folder, choice, *base, *options, present=present).stdout


@pytest.mark.campaign
def test_without_a_browser_the_page_tests_are_left_out_and_the_run_says_so(tmp_path: Path) -> None:
    said = pytest_run(tmp_path, None)
    assert "1 passed, 1 deselected" in said, said
    assert len([line for line in said.splitlines() if PACKAGES in line]) == 1, said


def test_with_a_browser_the_page_tests_are_collected(tmp_path: Path) -> None:
    said = pytest_run(tmp_path, None, "--collect-only", present=True)
    assert "2 tests collected" in said, said
    assert "left out" not in said


@pytest.mark.campaign
def test_a_browser_that_is_demanded_and_missing_is_a_failure(tmp_path: Path) -> None:
    said = pytest_run(tmp_path, "1")
    assert "1 passed, 1 error" in said, said
    assert PACKAGES in said
    assert "left out" not in said


def test_the_page_tests_can_be_left_out_on_purpose(tmp_path: Path) -> None:
    said = pytest_run(tmp_path, "0", "--collect-only", present=True)
    assert "1/2 tests collected (1 deselected)" in said, said
    assert "BROWSER_TESTS=0" in said


@pytest.mark.parametrize(
    ("choice", "present", "code", "said"),
    [
        (None, False, 0, PACKAGES),
        ("0", True, 0, "BROWSER_TESTS=0"),
        ("1", False, 1, PACKAGES),
        (None, True, 1, "there are no pages"),
    ],
)
def test_the_check_of_the_site_follows_the_same_rule(
    choice: str | None, present: bool, code: int, said: str, tmp_path: Path
) -> None:
    result = run(tmp_path, choice, "tests/check_site.py", str(tmp_path / "none"), present=present)
    assert result.returncode == code, result.stderr
    assert said in result.stdout + result.stderr
