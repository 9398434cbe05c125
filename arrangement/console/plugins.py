"""What lies above a module and is looked up by name: kinds of files, instances, notebook pages.

Nothing is imported before it is used, and a package that is absent adds nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any

#: What packages add: for each kind the names, and where the function behind each is.
_ADDED: Mapping[str, Mapping[str, str]] = {
    # Keys by which the kind of a document is recognised, and functions from a document to an
    # `Arrangement`.
    "documents": {"contacts": "equilibrium.grasps.files:tangential_arrangement"},
    # Functions from a text to an `Arrangement`, or to None where it is not such a table.
    "tables": {"contacts": "equilibrium.grasps.inputs.csv_file:tangential_arrangement"},
    # Functions that return built-in documents by name.
    "instances": {
        "arrangement": "arrangement.library.instances:paths",
        "equilibrium": "equilibrium.grasps.instances:paths",
        "bodies": "equilibrium.grasps.instances:bodies",
    },
}


def added(kind: str) -> dict[str, str]:
    """Return what the packages that are there add of a kind: names, for `named`."""
    return {key: place for key, place in _ADDED[kind].items() if find_spec(place.split(".")[0])}


def named(place: str) -> Any:
    """Return what a text such as ``package.module:function`` names."""
    module, _, name = place.partition(":")
    return getattr(import_module(module), name)


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
