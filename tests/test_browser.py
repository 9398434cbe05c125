"""Where there is no browser, the suite still runs, and says what it left out."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = "apt-get install chromium chromium-driver"
SUITE = (
    "-m pytest -q -p no:cacheprovider"
    " tests/test_check_site.py::test_a_page_that_holds_all_it_needs_is_right"
    " tests/test_layers.py::test_counts_work_with_the_enumerators_out_of_reach"
)
CAMPAIGN = pytest.mark.campaign


@pytest.mark.parametrize(
    ("choice", "present", "command", "code", "said"),
    [
        pytest.param(None, False, SUITE, 0, ["1 passed, 1 deselected", PACKAGES], marks=CAMPAIGN),
        pytest.param("1", False, SUITE, 1, ["1 passed, 1 error", PACKAGES], marks=CAMPAIGN),
        (None, True, f"{SUITE} --collect-only", 0, ["2 tests collected"]),
        ("0", True, f"{SUITE} --collect-only", 0, ["1/2 tests collected", "BROWSER_TESTS=0"]),
        (None, False, "tests/check_site.py none", 0, [PACKAGES]),
        ("0", True, "tests/check_site.py none", 0, ["BROWSER_TESTS=0"]),
        ("1", False, "tests/check_site.py none", 1, [PACKAGES]),
        (None, True, "tests/check_site.py none", 1, ["there are no pages"]),
    ],
)
def test_what_is_left_out_is_said_and_what_is_demanded_must_be_there(
    choice, present, command, code, said, tmp_path
):
    """The path of programs has one folder, with or without a browser in it."""
    for name in ("chromium", "chromedriver") if present else ():
        (tmp_path / name).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / name).chmod(0o755)
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PYTEST_", "BROWSER_"))}
    environment |= {"PATH": str(tmp_path)} | ({"BROWSER_TESTS": choice} if choice else {})
    done = subprocess.run(
        [sys.executable, *command.split()], cwd=ROOT, env=environment, capture_output=True,
        text=True, timeout=120, check=False,
    )  # fmt: skip
    printed = done.stdout + done.stderr
    assert done.returncode == code, printed
    assert all(text in printed for text in said), printed
    assert ("left out" in printed) <= (PACKAGES in said or choice == "0")
