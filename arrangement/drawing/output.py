"""Write figures as files: format by suffix, embedded fonts, reproducible bytes.

matplotlib, Pillow and ffmpeg are imported or searched for when a picture is written.
"""

from __future__ import annotations

import base64
import io
import os
from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager
from difflib import get_close_matches
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.console.writing import write_bytes_atomically
from arrangement.drawing.scene import DPI, require_matplotlib
from arrangement.errors import InputError, MissingExtraError, refusal
from arrangement.numbers.exact import shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PICTURES = (".pdf", ".png", ".svg")
TIKZ = (".tex", ".tikz")
MOVIES = (".gif", ".mp4")
MODELS = (".glb", ".obj", ".stl")
PAGES = (".html",)
#: The first one is the default.
LEGENDS = ("below", "right", "none")
THEMES = ("light", "dark", "mono")
#: Dots per inch of PNG that may be asked for.
DPIS = range(20, 2401)


#: What makes files repeat: fixed identifiers, no dates, letters as outlines.
_STYLE = {"svg.hashsalt": "arrangement", "svg.fonttype": "path", "font.size": 7.0}
_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
    ".png": {"Software": None},
}


def check_choice(name: str, value: object, known: tuple[str, ...]) -> None:
    """Refuse what is not one of the known words."""
    if value not in known:
        raise refusal(f"the {name} is {shown(value)}", value, known)


def ending(path: str | os.PathLike[str], known: Iterable[str]) -> str:
    """Return the suffix of a file that can be written, in lower case.

    Raises:
        InputError: it is none of those known, or there is no such folder.
    """
    place, ends = Path(path), ", ".join(known)
    suffix = place.suffix.lower()
    if place.is_dir():
        raise InputError(f"{shown(str(path))} is a folder; name a file")
    if not suffix:
        raise InputError(f"the file name {shown(str(path))} has no ending; expected one of {ends}")
    if suffix not in ends.split(", "):
        raise InputError(f"the file name ends in {shown(suffix)}; expected one of {ends}")
    if not place.parent.is_dir():
        raise InputError(f"there is no folder {shown(str(place.parent))}; make it first")
    return suffix


def save_figure(path: str | os.PathLike[str], make: Callable[[], Figure]) -> None:
    """Write the figure that `make` returns, in the format of the suffix; the same bytes each time.

    Raises:
        InputError: the suffix is not one of a picture, or there is no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = ending(path, PICTURES)
    write_bytes_atomically(path, picture_bytes(suffix, make))


def picture_bytes(
    suffix: str,
    make: Callable[[], Figure],
    letters: bool = False,
    dpi: int | None = None,
    font: str | None = None,
    transparent: bool = False,
) -> bytes:
    """Return the figure that `make` returns as a file.

    Args:
        letters: of SVG, text instead of outlines.
        dpi: dots per inch of PNG; `DPI` if omitted.
        transparent: without a background.
    """
    stream = io.BytesIO()
    with own_settings(font_settings(font) | ({"svg.fonttype": "none"} if letters else {})):
        make().savefig(
            stream,
            format=suffix[1:],
            dpi=DPI if dpi is None else dpi,
            metadata=_METADATA[suffix],
            transparent=transparent,
        )
    return stream.getvalue()


#: Kinds of fonts, each with one that comes with matplotlib.
_GENERIC_FONTS = {"serif": "dejavu serif", "sans-serif": "dejavu sans", "sans": "dejavu sans"}
_GENERIC_FONTS |= {"monospace": "dejavu sans mono", "mono": "dejavu sans mono"}


def font_settings(font: str | None) -> dict[str, Any]:
    """Return the settings for an installed font; what it lacks is drawn in the default one.

    Raises:
        InputError: no such font is installed.
        MissingExtraError: matplotlib is absent.
    """
    if font is None:
        return {}
    require_matplotlib()
    from matplotlib.font_manager import fontManager

    names = {name.lower(): name for name in sorted(fontManager.get_font_names(), reverse=True)}
    asked = str(font).strip().lower()
    asked = _GENERIC_FONTS.get(asked, asked)
    name = names.get(asked)
    if name is None:
        near = [n for n in names if asked and asked in n] or get_close_matches(asked, names, 5, 0.5)
        like = "installed are" if near else f"{len(names)} others are installed, such as"
        listed = ", ".join(names[n] for n in (near or sorted(names))[:5])
        raise InputError(f"the font is {shown(font)}, which is not installed; {like} {listed}")
    styles = {"rm": "", "it": ":italic", "bf": ":bold", "bfit": ":italic:bold"}
    styles |= {"cal": ":italic", "sf": "", "tt": ""}
    return {
        "font.family": [name, "DejaVu Sans"],
        "axes.formatter.use_mathtext": True,
        "mathtext.fontset": "custom",
        **{f"mathtext.{key}": f"{name}{style}" for key, style in styles.items()},
    }


def movie_bytes(suffix: str, pictures: Iterable[bytes]) -> bytes:
    """Return pictures in PNG as one GIF, or MP4, that shows them in four seconds.

    Raises:
        InputError: MP4 is asked for and there is no ffmpeg.
    """
    from PIL import Image

    frames = [Image.open(io.BytesIO(picture)).convert("RGB") for picture in pictures]
    # All frames have one size, which MP4 wants even.
    size = max(f.width for f in frames) + 1 & ~1, max(f.height for f in frames) + 1 & ~1
    for k, frame in enumerate(frames):
        frames[k] = Image.new("RGB", size, frame.getpixel((0, 0)))
        frames[k].paste(frame, ((size[0] - frame.width) // 2, 0))
    if suffix == ".gif":
        stream, first = io.BytesIO(), frames[0].quantize(64)
        rest = [frame.quantize(palette=first) for frame in frames]
        pause = round(4000 / len(frames))
        rest[0].save(stream, "GIF", save_all=True, append_images=rest[1:], duration=pause, loop=0)
        return stream.getvalue()
    import shutil
    import subprocess
    import tempfile

    program = shutil.which("ffmpeg")
    if program is None:
        raise InputError("MP4 needs ffmpeg, which is not installed; .gif needs nothing more")
    with tempfile.TemporaryDirectory() as folder:
        raw = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}"]
        words = [program, "-v", "error", *raw, "-r", f"{len(frames) / 4:g}", "-i", "-"]
        target = Path(folder) / "turn.mp4"
        words += ["-pix_fmt", "yuv420p", "-fflags", "+bitexact", "-flags", "+bitexact", str(target)]
        data = b"".join(frame.tobytes() for frame in frames)
        done = subprocess.run(words, input=data, capture_output=True, check=False)
        if done.returncode:
            raise InputError(f"ffmpeg refused the pictures: {shown(done.stderr.decode()[-200:])}")
        return target.read_bytes()


def own_settings(more: Mapping[str, Any] | None = None) -> AbstractContextManager[None]:
    """Return a context in which matplotlib has the settings of our pictures, not the user's."""
    mpl = require_matplotlib()
    # Whoever asks for the backend loads all of pyplot; figures of their own need none.
    plain = {key: value for key, value in mpl.rcParamsDefault.items() if key != "backend"}
    settings: AbstractContextManager[None] = mpl.rc_context({**plain, **_STYLE, **(more or {})})
    return settings


def svg_text(make: Callable[[], Figure]) -> str | None:
    """Return a figure as SVG text; None without matplotlib, or when `make` refuses."""
    try:
        return picture_bytes(".svg", make).decode("utf-8")
    except (InputError, MissingExtraError):
        return None


def image(svg: str | None, alt: str) -> str:
    """Return a picture as an element of HTML that needs nothing else; empty without one."""
    if svg is None:
        return ""
    data = base64.b64encode(svg.encode("utf-8")).decode("ascii")
    return f'<img alt="{escape(alt)}" src="data:image/svg+xml;base64,{data}"/>'
