"""The plugin of this suite that fails tests without an executed assertion."""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SUITE = """
import pytest
from hypothesis import given, strategies as st


@pytest.fixture
def checked():
    assert True


def check(number):
    assert number < 5


@given(st.integers(0, 3))
def test_empty_property(number):
    if number > 3:
        check(number)


@pytest.mark.parametrize("number", [1, 2])
def test_empty_for_1(number):
    if number > 1:
        check(number)


def test_empty_but_for_its_fixture(checked):
    pass


def test_skipped():
    pytest.skip()


def test_raises():
    with pytest.raises(KeyError):
        {}[1]


def test_warns():
    with pytest.warns(UserWarning):
        __import__("warnings").warn("once")


class TestMethods:
    @given(st.integers(0, 4))
    def test_property(self, number):
        check(number)

    def test_failure(self):
        check(6)


def documented():
    '''
    >>> documented()
    '''
"""


def test_tests_without_assertion_fail(tmp_path):
    (tmp_path / "pytest.ini").write_text("[pytest]\nenable_assertion_pass_hook = true\n")
    (tmp_path / "test_inner.py").write_text(SUITE)
    options = ["-p", "tests.assertions", "--doctest-modules", "-rf", "--tb=line", tmp_path]
    command = [sys.executable, "-m", "pytest", *options]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert re.findall(r"(?m)^FAILED .*::(\S+)", run.stdout) == [
        "test_empty_property",
        "test_empty_for_1[1]",
        "test_empty_but_for_its_fixture",
        "test_failure",
    ]
    assert run.stdout.count("\npassed without an executed assertion") == 3
    assert "4 failed, 5 passed, 1 skipped" in run.stdout
