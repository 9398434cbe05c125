"""A pytest plugin: a test that passes without an executed assertion fails.

Assertions are `assert` in files that pytest rewrites, `pytest.raises` and `pytest.warns`; those of
fixtures do not count. pytest calls one function at each passed assertion when its option
`enable_assertion_pass_hook` is set. This plugin puts its counter there: the hook itself would
format the values of every assertion, which takes half the time of some tests.
"""

import sys
from collections.abc import Callable, Generator
from typing import Any

import pytest
from _pytest.assertion import rewrite

_executed = 0


def _count() -> bool:
    global _executed
    # pytest rewrites its plugins, too: Hypothesis.
    _executed += "-packages" not in sys._getframe(1).f_code.co_filename
    return False  # no hook is to be called


def _counted(function: Callable[..., Any]) -> Callable[..., Any]:
    def counted(*args: Any, **options: Any) -> Any:
        _count()
        return function(*args, **options)

    return counted


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call() -> Generator[None, object, object]:
    """Fail a test that passed, if no assertion was executed meanwhile."""
    before = _executed
    result = yield
    if _executed == before:
        pytest.fail("passed without an executed assertion", pytrace=False)
    return result


rewrite._check_if_assertion_pass_impl = _count
# Files compiled without the option are not to be found in the cache.
rewrite.PYC_TAIL = "-counted" + rewrite.PYC_TAIL
pytest.raises = _counted(pytest.raises)  # type: ignore[assignment]
pytest.warns = _counted(pytest.warns)  # type: ignore[assignment]
