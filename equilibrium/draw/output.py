"""Pictures of grasps as files: the suffix decides the format. Slow imports wait until needed."""

from __future__ import annotations

import importlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from arrangement.draw.notebook import svg_text
from arrangement.draw.output import PAGES, PICTURES, save_figure
from arrangement.draw.views import check_options
from arrangement.exact import shown
from arrangement.io.writing import write_text_atomically
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

#: Name -> module of this package and function, ``f(grasp, **options) -> Figure``.
VIEWS = {
    "grasp": ("grasp", "draw_grasp"),
    "resist": ("resist", "draw_resist"),
    "slice": ("slices", "draw_slice"),
    "polar": ("polar", "draw_polar"),
    "compare": ("compare", "draw_compare"),
    "methods": ("methods", "draw_methods"),
}


def write_drawing(
    grasp: Grasp, path: str | os.PathLike[str], view: str | None = None, **options: Any
) -> dict[str, str]:
    """Draw a grasp into a file, whole or not at all.

    Args:
        grasp: contacts.
        path: ``.svg``, ``.pdf`` or ``.png`` for a picture; ``.html`` for the interactive page of
            the resisted forces.
        view: of a picture, one of `VIEWS`; "grasp" if left out.
        options: those of the view's or page's function.

    Returns:
        What was written: ``{"view": name}`` or ``{"page": "resist"}``.

    Raises:
        InputError: unknown suffix, view or option, what a view refuses, no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in PICTURES + PAGES:
        known = ", ".join(sorted(PICTURES + PAGES))
        raise GraspError(f"the file name ends in {shown(suffix)}; known are {known}")
    if suffix in PAGES:
        if view not in (None, "resist"):
            raise GraspError(f"a page shows the view resist, not {shown(view)}; leave the view out")
        make_page = _function("page", "resist_page")
        check_options("the page", make_page, options)
        write_text_atomically(path, make_page(grasp, **options))
        return {"page": "resist"}
    name = "grasp" if view is None else view
    if name not in VIEWS:
        raise GraspError(f"the view is {shown(name)}; known are {', '.join(VIEWS)}")
    draw = _function(*VIEWS[name])
    check_options(name, draw, options)
    if name == "methods" and not options.get("wrenches"):
        raise GraspError("the view methods compares verdicts on wrenches; give at least one")
    save_figure(path, lambda: draw(grasp, **options))
    return {"view": name}


def grasp_svg(grasp: Grasp) -> str | None:
    """Return the view grasp as SVG text; None without matplotlib."""
    return svg_text(lambda: _function(*VIEWS["grasp"])(grasp))


def _function(module: str, name: str) -> Callable[..., Any]:
    found: Callable[..., Any] = getattr(importlib.import_module(f"equilibrium.draw.{module}"), name)
    return found
