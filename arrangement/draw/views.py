"""The views of an arrangement by name; each lives in a module of its own, loaded when called."""

from __future__ import annotations

import importlib
import inspect
from collections.abc import Callable, Mapping
from typing import Any

from arrangement.errors import InputError
from arrangement.exact import shown

#: Views as pictures: name -> module of this package and function, ``f(arrangement, **options)``.
PICTURE_VIEWS = {
    "planes": ("planes", "draw_planes"),
    "sphere": ("sphere", "draw_sphere"),
    "stereographic": ("stereographic", "draw_stereographic"),
    "gnomonic": ("gnomonic", "draw_gnomonic"),
    "dual": ("dual", "draw_dual"),
    "graph": ("graph", "draw_graph"),
    "lattice": ("lattice", "draw_lattice"),
}


#: Models as files: name -> module and function, ``f(arrangement, suffix, **options) -> bytes``.
MODEL_VIEWS = {
    "dual": ("models", "dual_model"),
    "cells": ("models", "cells_model"),
}


def view_function(
    view: str, known: Mapping[str, tuple[str, str]], kind: str = "view"
) -> Callable[..., Any]:
    """Return the function of a view or model.

    Raises:
        InputError: no such view.
    """
    if view not in known:
        raise InputError(f"the {kind} is {shown(view)}; known are {', '.join(known)}")
    module, name = known[view]
    function: Callable[..., Any] = getattr(
        importlib.import_module(f"arrangement.draw.{module}"), name
    )
    return function


def check_options(view: str, function: Callable[..., Any], options: Mapping[str, Any]) -> None:
    """Refuse options that a view does not have."""
    parameters = inspect.signature(function).parameters.values()
    names = [p.name for p in parameters if p.kind is p.KEYWORD_ONLY]
    unknown = sorted(set(options) - set(names))
    if unknown:
        has = ", ".join(names) or "none"
        raise InputError(f"{view} has no option {shown(unknown[0])}; it has {has}")
