"""How a picture is printed: its text, theme and legend; and pictures that turn."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from functools import partial
from typing import TYPE_CHECKING

from arrangement.console.progress import watched
from arrangement.console.writing import write_bytes_atomically
from arrangement.errors import InputError
from arrangement.numbers.exact import shown

from .output import (
    LEGENDS,
    MOVIES,
    THEMES,
    TIKZ,
    check_choice,
    ending,
    font_settings,
    movie_bytes,
    own_settings,
    picture_bytes,
    points,
)

if TYPE_CHECKING:
    from .scene.scene import Scene

#: Text of SVG; the first one is the default.
_LETTERS = ("outlines", "text")
#: Pictures of a full turn.
_FRAMES = 36


@dataclass(frozen=True)
class Printing:
    """The options of all pictures, as `Drawings.write` explains them; None if not given."""

    font: str | None
    font_size: object
    theme: str | None
    legend: str | None
    text: str | None
    fragment: bool
    columns: int | None
    frames: int | None

    def check(self, kind: str, name: str, suffix: str) -> None:
        """Refuse what does not go with a view, model or page, or with a kind of file."""
        given = {name for name, x in asdict(self).items() if x is not None and x is not False}
        for names, fits, what in (
            (
                {"font_size", "theme", "legend"},
                kind == "view",
                "a font size, legend or theme is for pictures",
            ),
            (
                {"font"},
                kind == "view" and suffix not in TIKZ,
                "a font is for pictures other than TikZ, which TeX sets in its own",
            ),
            ({"fragment"}, suffix in TIKZ, "a fragment is TikZ, .tex"),
            ({"text"}, suffix == ".svg", "text or outlines is a choice of .svg"),
            ({"frames"}, suffix in MOVIES, "frames are for .gif and .mp4"),
            ({"columns"}, "," in name, "columns are for several views, such as sphere,dual"),
        ):
            if given & names and not fits:
                raise InputError(f"{what}, and the file name ends in {suffix}")
        for name, known in (("theme", THEMES), ("legend", LEGENDS), ("text", _LETTERS)):
            if name in given:
                check_choice(name, getattr(self, name), known)

    @property
    def scale(self) -> float:
        """How large text and lines are, in units of the usual size."""
        from .scene.scene import FONT

        return 1.0 if self.font_size is None else points(self.font_size, "the font size") / FONT

    def picture_width(self, width: float) -> float:
        """Return the width of the picture itself at its usual size, on a sheet of a width."""
        from .scene.layout import picture_width

        return picture_width(width, self.legend or LEGENDS[0]) / self.scale

    @contextmanager
    def explained(self, width: float) -> Iterator[None]:
        """Explain why a picture is too narrow, where its own width is not that of the sheet."""
        from .scene.scene import NarrowError

        try:
            yield
        except NarrowError as error:
            if self.picture_width(width) == width:
                raise
            why = [f"1/{self.scale:.3g} of it for the font size"] * (self.scale != 1)
            why += ["without the legend at the right"] * (self.legend == "right")
            counted = f"{width:.4g}, counted as {', '.join(why)}"
            raise InputError(f"{error} (the width given is {counted})") from None

    def finished(self, scene: Scene) -> Scene:
        """Return the sheet with a picture, its legend and its captions, in the theme."""
        from .path_artist import finished

        return finished(scene, self.legend or LEGENDS[0], self.theme or THEMES[0], self.scale)


def write_movie(
    path: str | os.PathLike[str], make: Callable[..., Scene], printing: Printing
) -> None:
    """Write the pictures that `make` returns for angles ``azimuth`` all around, one after another.

    Raises:
        InputError: no such number of pictures, or no ffmpeg for ``.mp4``.
        MissingExtraError: matplotlib is absent.
    """
    from .path_artist import figure

    count = _FRAMES if printing.frames is None else printing.frames
    if not isinstance(count, int) or not 2 <= count <= 720:
        raise InputError(f"a turn has {shown(count)} frames; give 2 to 720")
    frames = []
    for k in watched(range(count), "pictures"):
        with own_settings(font_settings(printing.font)):
            sheet = make(azimuth=360 * k / count)
            drawn = partial(figure, sheet)
            frames.append(picture_bytes(".png", drawn, dpi=150, font=printing.font))
    write_bytes_atomically(path, movie_bytes(ending(path, MOVIES), frames))
