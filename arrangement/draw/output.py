"""Pictures as files: the suffix decides the format. No slow import happens here before it must."""

from __future__ import annotations

import io
import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.errors import InputError, MissingExtraError
from arrangement.exact import shown
from arrangement.planes import Arrangement
from arrangement.writing import write_bytes_atomically

from .views import PICTURE_VIEWS, check_options, view_function

if TYPE_CHECKING:
    from matplotlib.figure import Figure

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
        arrangement: one that the view can show; see its function.
        path: ``.svg``, ``.pdf`` or ``.png`` for a picture; ``.stl``, ``.glb`` or ``.obj`` for a
            model of the dual polyhedron, for which view and options do not count.
        view: one of `views.PICTURE_VIEWS`.
        options: those of the view's function.

    Raises:
        InputError: unknown suffix, view or option, planes that the view cannot show, no place to
            write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = Path(path).suffix.lower()
    if suffix not in PICTURES + MODELS:
        known = ", ".join(sorted(PICTURES + MODELS))
        raise InputError(f"the file name ends in {shown(suffix)}; known are {known}")
    function = view_function(view, PICTURE_VIEWS)
    if suffix in MODELS:
        from arrangement.dual import dual_polyhedron

        dual_polyhedron(arrangement).export(path)
        return
    check_options(view, function, options)
    save_figure(path, lambda: function(arrangement, **options))


def save_figure(path: str | os.PathLike[str], make: Callable[[], Figure]) -> None:
    """Write the figure that `make` returns, in the format of the suffix; the same bytes each time.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    suffix = Path(path).suffix.lower()
    mpl = require_matplotlib()
    with mpl.rc_context({**mpl.rcParamsDefault, **_STYLE}):
        buffer = io.BytesIO()
        make().savefig(buffer, format=suffix[1:], dpi=300, metadata=_METADATA[suffix])
    write_bytes_atomically(path, buffer.getvalue())
