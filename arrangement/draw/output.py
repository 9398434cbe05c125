"""Pictures as files: the suffix decides the format. No slow import happens here before it must."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.errors import InputError, MissingExtraError
from arrangement.exact import shown
from arrangement.io.writing import write_bytes_atomically

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
    # Whoever asks for the backend loads all of pyplot; figures of their own need none.
    plain = {key: value for key, value in mpl.rcParamsDefault.items() if key != "backend"}
    with mpl.rc_context({**plain, **_STYLE}):
        make().savefig(stream, format=suffix[1:], dpi=300, metadata=_METADATA[suffix])


def svg_text(make: Callable[[], Figure]) -> str | None:
    """Return a figure as SVG text; None without matplotlib, or when `make` refuses."""
    stream = io.BytesIO()
    try:
        save_picture(stream, ".svg", make)
    except (InputError, MissingExtraError):
        return None
    return stream.getvalue().decode("utf-8")
