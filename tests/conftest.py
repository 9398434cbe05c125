"""Settings for the whole suite."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from tests.browser import MISSING, Browser, programs, running, wanted

ROOT = Path(__file__).resolve().parent.parent

# The same examples on every run and every machine; speed is no verdict.
settings.register_profile(
    "ci",
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=[HealthCheck.too_slow],
)
# For a search with fresh examples: pytest --hypothesis-profile=search
settings.register_profile("search", max_examples=1000, deadline=None, print_blob=True)
settings.load_profile("ci")


@functools.cache
def _uses_sympy(path: Path) -> bool:
    return path.suffix == ".py" and "sympy" in path.read_text(encoding="utf-8")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what meets SymPy, so that it can run with each of SymPy's ground types."""
    for item in items:
        if _uses_sympy(item.path):
            item.add_marker(pytest.mark.ground_types)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Return a running headless Chromium; see `tests.browser` for where it must come from."""
    if not wanted():
        pytest.skip("BROWSER_TESTS=0 leaves the tests of pages out")
    if programs() is None:
        pytest.fail(MISSING, pytrace=False)
    with running() as found:
        yield found
