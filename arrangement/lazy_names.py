"""The names of a package are loaded when first used, by lazy_loader from its ``__init__.pyi``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NoReturn

Attached = tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]


def attach_stub(package: str, file: str) -> Attached:
    """As in lazy_loader; where that is missing, the first use of a name says so, no import.

    A console script imports its package before anything can catch a fault, and Python's exit code
    for a fault is that of a "no".
    """
    try:
        import lazy_loader
    except ImportError as error:
        missing = error

        def absent(name: str) -> NoReturn:
            raise missing

        return absent, list, []
    attached: Attached = lazy_loader.attach_stub(package, file)
    return attached
