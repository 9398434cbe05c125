"""Pictures as files: the suffix decides the format. No slow import happens here before it must."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError, MissingExtraError
from arrangement.exact import shown
from arrangement.io.writing import write_bytes_atomically, write_text_atomically

from .views import MODEL_VIEWS, PICTURE_VIEWS, check_options, view_function

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURES = (".pdf", ".png", ".svg")
MODELS = (".glb", ".obj", ".stl")
PAGES = (".html",)

#: What makes files repeat: fixed identifiers, no dates, letters as outlines.
_STYLE = {"svg.hashsalt": "arrangement", "svg.fonttype": "path", "font.size": 7.0}
_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
    ".png": {"Software": None},
}


def require_matplotlib() -> Any:
    """Return matplotlib, or say which extra installs it."""
    try:
        import matplotlib as mpl
    except ImportError:
        raise MissingExtraError(
            "pictures need matplotlib: install the extra with pip install 'slipstates[figures]'"
        ) from None
    return mpl


def write_drawing(
    arrangement: Arrangement,
    path: str | os.PathLike[str],
    view: str | None = None,
    model: str | None = None,
    **options: Any,
) -> dict[str, str]:
    """Draw an arrangement into a file, whole or not at all.

    Args:
        arrangement: one that the view or model can show; see its function.
        path: ``.svg``, ``.pdf`` or ``.png`` for a picture; ``.stl``, ``.glb`` or ``.obj`` for a
            model. STL and OBJ are in millimetres, GLB is in metres as its standard demands;
            ``.html`` for the interactive page, see `page.arrangement_page`.
        view: of a picture, one of `views.PICTURE_VIEWS`; "sphere" if left out.
        model: one of `views.MODEL_VIEWS`; "dual" if left out.
        options: those of the function of the view, model or page.

    Returns:
        What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": "arrangement"}``.

    Raises:
        InputError: unknown suffix, view, model or option, planes that it cannot show, no place to
            write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in PICTURES + MODELS + PAGES:
        known = ", ".join(sorted(PICTURES + MODELS + PAGES))
        raise InputError(f"the file name ends in {shown(suffix)}; known are {known}")
    if suffix in MODELS:
        _refuse_other("view", view, suffix, PICTURES)
        name = model or "dual"
        build = view_function(name, MODEL_VIEWS, "model")
        check_options(name, build, options)
        write_bytes_atomically(path, build(arrangement, suffix, **options))
        return {"model": name}
    _refuse_other("model", model, suffix, MODELS)
    if suffix in PAGES:
        from .page import arrangement_page

        _refuse_other("view", view, suffix, PICTURES)
        check_options("the page", arrangement_page, options)
        write_text_atomically(path, arrangement_page(arrangement, **options))
        return {"page": "arrangement"}
    name = view or "sphere"
    draw = view_function(name, PICTURE_VIEWS)
    check_options(name, draw, options)
    save_figure(path, lambda: draw(arrangement, **options))
    return {"view": name}


def _refuse_other(kind: str, value: str | None, suffix: str, known: tuple[str, ...]) -> None:
    if value is not None:
        raise InputError(
            f"a {kind} was named and the file name ends in {suffix}; a {kind} needs one of "
            f"{', '.join(known)}"
        )


def millimetres(value: object, name: str) -> float:
    """Return a length for paper or print as a float, or refuse what is not positive and finite."""
    length = float(value) if isinstance(value, (int, float, Fraction)) else math.nan
    if not 0 < length < 10_000:
        raise InputError(f"{name} is {shown(value)}; give millimetres, more than 0, below 10000")
    return length


def save_figure(path: str | os.PathLike[str], make: Callable[[], Figure]) -> None:
    """Write the figure that `make` returns, in the format of the suffix; the same bytes each time.

    Raises:
        InputError: the suffix is not one of a picture, or there is no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix, buffer = Path(path).suffix.lower(), io.BytesIO()
    if suffix not in PICTURES:
        raise InputError(f"the file name ends in {shown(suffix)}; known are {', '.join(PICTURES)}")
    save_picture(buffer, suffix, make)
    write_bytes_atomically(path, buffer.getvalue())


def save_picture(stream: io.BytesIO, suffix: str, make: Callable[[], Figure]) -> None:
    """Write the figure that `make` returns to a stream, as `save_figure` does."""
    mpl = require_matplotlib()
    with mpl.rc_context({**mpl.rcParamsDefault, **_STYLE}):
        make().savefig(stream, format=suffix[1:], dpi=300, metadata=_METADATA[suffix])
