"""The registry of functions that lower packages call in higher ones, and names that load lazily.

An entry is a text ``package.module:function``, which is imported when it is called. A package that
is not installed has no entries.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from opcode import opname
from types import FrameType, ModuleType
from typing import Any

from arrangement.hints import missing_attribute

#: For each kind of entry its names, each with the place of a function.
_ADDED: Mapping[str, Mapping[str, str]] = {
    # Keys by which the kind of a document is recognised, and functions from a document to an
    # `Arrangement`.
    "documents": {"contacts": "equilibrium.grasps.files:tangential_arrangement"},
    # Functions from a text to an `Arrangement`, or to None where it is not such a table.
    "tables": {"contacts": "equilibrium.grasps.inputs.csv_file:tangential_arrangement"},
    # Functions that return the parser of a program.
    "programs": {
        "arrangement": "arrangement.cli:_parser",
        "equilibrium": "equilibrium.cli.program:_parser",
        "proofs-check": "proofs_check.cli.program:_parser",
    },
    # Functions that return built-in documents by name.
    "instances": {
        "arrangement": "arrangement.library.instances:paths",
        "equilibrium": "equilibrium.grasps.instances:paths",
        "bodies": "equilibrium.grasps.instances:bodies",
    },
}

#: Methods such as "Grasp.draw" whose code is in a higher package, with the place of that code.
_ATTACHED: dict[str, str] = {}


def attach(places: Mapping[str, str]) -> None:
    """Register methods whose code is in a higher package.

    Args:
        places: for each ``Class.method`` what it calls, as ``package.module:name``.
    """
    _ATTACHED.update(places)


def method_code(method: str) -> Any:
    """Return the function that is registered for a method."""
    return import_object(_ATTACHED[method])


def registry_entries(kind: str) -> dict[str, str]:
    """Return the entries of a kind, of the packages that are installed."""
    return {key: place for key, place in _ADDED[kind].items() if find_spec(place.split(".")[0])}


def import_object(place: str) -> Any:
    """Import and return an object by its place, such as ``package.module:function``."""
    module, _, name = place.partition(":")
    return getattr(import_module(module), name)


def to_importer(error: AttributeError, caller: FrameType) -> AttributeError | ImportError:
    """Return an error about a name of a module; to an import Python would leave out its hint."""
    imports = opname[caller.f_code.co_code[caller.f_lasti]] == "IMPORT_FROM"
    return ImportError(str(error), name=error.name) if imports else error


def lazy_names(
    package: str, file: str, synonyms: Mapping[str, str] | None = None
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return ``__getattr__`` and ``__dir__`` of a package whose names load when first used.

    The names are those of ``__init__.pyi`` beside the file. They are also ``__all__``, but not for
    `pydoc`: ``help`` shows the docstring of the package alone, not thousands of lines.

    Args:
        synonyms: other words for the names, each with what to write here.
    """
    try:
        from lazy_loader import attach_stub
    except ModuleNotFoundError as error:
        absent = error

        def unavailable(name: str) -> Any:
            raise absent

        return unavailable, list
    get_known, names, known = attach_stub(package, file)

    def get(name: str) -> Any:
        if name in known:
            value = get_known(name)
            if isinstance(value, ModuleType) and "__getattr__" not in vars(value):
                vars(value)["__getattr__"] = partial(_refuse, value)
            return value
        caller = sys._getframe(1)
        if name == "__all__" and caller.f_globals.get("__name__") != "pydoc":
            return names()
        error = missing_attribute(sys.modules[package], name, synonyms or {})
        raise to_importer(error, caller)

    return get, names


def _refuse(module: ModuleType, name: str) -> Any:
    raise to_importer(missing_attribute(module, name, {}), sys._getframe(1))


class InlinePage:
    """A self-contained HTML page that a notebook shows in a frame of its cell."""

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_html_(self) -> str:
        from html import escape

        return (
            f'<iframe srcdoc="{escape(self.text)}" sandbox="allow-scripts allow-downloads" '
            'style="width: 100%; height: 48rem; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<InlinePage of {len(self.text)} characters, which a notebook shows>"
