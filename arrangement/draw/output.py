"""Pictures as files: the suffix decides the format. No slow import happens here before it must."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any

from arrangement.errors import InputError, MissingExtraError
from arrangement.exact import shown
from arrangement.planes import Arrangement
from arrangement.writing import write_bytes_atomically

VIEWS = ("sphere",)
PICTURES = (".pdf", ".png", ".svg")
MODELS = (".glb", ".obj", ".stl")

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
    view: str = "sphere",
    **options: Any,
) -> None:
    """Draw an arrangement into a file, whole or not at all.

    Args:
        arrangement: central, in R^3.
        path: ``.svg``, ``.pdf`` or ``.png`` for a picture; ``.stl``, ``.glb`` or ``.obj`` for a
            model of the dual polyhedron, for which view and options do not count.
        view: one of `VIEWS`.
        options: those of the view's function.

    Raises:
        InputError: unknown suffix or view, planes that the view cannot show, no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in PICTURES + MODELS:
        known = ", ".join(sorted(PICTURES + MODELS))
        raise InputError(f"the file name ends in {shown(suffix)}; known are {known}")
    if view not in VIEWS:
        raise InputError(f"the view is {shown(view)}; known are {', '.join(VIEWS)}")
    if suffix in MODELS:
        from arrangement.dual import dual_polyhedron

        dual_polyhedron(arrangement).export(path)
        return
    mpl = require_matplotlib()
    from .sphere import draw_sphere

    with mpl.rc_context({**mpl.rcParamsDefault, **_STYLE}):
        buffer = io.BytesIO()
        draw_sphere(arrangement, **options).savefig(
            buffer, format=suffix[1:], dpi=300, metadata=_METADATA[suffix]
        )
    write_bytes_atomically(path, buffer.getvalue())
