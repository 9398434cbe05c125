"""One registry of drawings for each package, and what both do with it: write files, take options.

A view is one function in one file of a package of pictures, and one line in its registry. Its
options are its keyword-only parameters, with their annotations and what the docstring says of them.
No module here knows any view.
"""

from __future__ import annotations

import inspect
import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement.console.plugins import named
from arrangement.console.progress import watched
from arrangement.console.writing import write_bytes_atomically, write_text_atomically
from arrangement.errors import InputError, MissingExtraError, refusal
from arrangement.numbers.exact import shown

from .output import (
    LEGENDS,
    MODELS,
    MOVIES,
    PAGES,
    PICTURES,
    THEMES,
    TIKZ,
    check_choice,
    check_renamed,
    ending,
    font_settings,
    millimetres,
    movie_bytes,
    own_settings,
    picture_bytes,
    points,
    svg_text,
)

if TYPE_CHECKING:
    from .path_artist import Drawing
    from .scene.scene import Scene

#: The kinds of options, for signatures; `command` says how each is written on a command line.
Vector: TypeAlias = Sequence[object]
Exact: TypeAlias = object
Wrench: TypeAlias = Iterable[Any]
Corner: TypeAlias = Iterable[Any]
Equation: TypeAlias = Iterable[Any]
#: Of regions: a word, or some regions, by sign vector or number, with or without texts.
Labels: TypeAlias = str | Mapping[Any, str] | Iterable[Any]
#: Names of axes, or True for those that suit.
AxisNames: TypeAlias = str | bool


@dataclass(frozen=True)
class Option:
    """A keyword-only parameter of a view.

    Attributes:
        kind: the annotation without ``| None`` and without `Iterable`.
        many: whether it takes several values.
        default: if it is a number.
        text: from the section ``Args`` of the docstring.
    """

    name: str
    kind: str
    many: bool
    required: bool
    default: float
    text: str


@contextmanager
def _within_floats() -> Iterator[None]:
    """Refuse numbers that have no place on paper."""
    try:
        yield
    except OverflowError:
        raise InputError(
            "a number of the input is too large for a picture (about 1.8e308 at most); change the "
            "units"
        ) from None


@dataclass(frozen=True)
class Drawings:
    """What a package can draw.

    Attributes:
        package: where the modules are.
        views: of pictures: name -> ``module:function``, ``f(subject, **options) -> Figure``; the
            first one is the default.
        models: likewise, ``f(subject, suffix, **options) -> bytes``.
        pages: likewise, ``f(subject, **options) -> str``.
    """

    package: str
    views: Mapping[str, str]
    models: Mapping[str, str]
    pages: Mapping[str, str]

    @_within_floats()
    def write(
        self,
        subject: Any,
        path: str | os.PathLike[str],
        view: str | None = None,
        model: str | None = None,
        *,
        font_size: object = None,
        font: str | None = None,
        text: str | None = None,
        fragment: bool = False,
        theme: str | None = None,
        legend: str | None = None,
        columns: int | None = None,
        frames: int | None = None,
        **options: Any,
    ) -> dict[str, str]:
        """Draw into a file, whole or not at all.

        Args:
            subject: an arrangement, or a grasp, that the view can show; see its function.
            path: ``.svg``, ``.pdf``, ``.png`` or ``.tex`` (TikZ) for a picture; ``.gif`` or
                ``.mp4`` (with ffmpeg) for one that turns; ``.stl``, ``.glb`` or ``.obj`` for a
                model. STL and OBJ are in millimetres, GLB is in metres as its standard demands;
                ``.html`` for an interactive page.
            view: of a picture, a page or a model; if omitted, the first one. Several pictures,
                such as ``"sphere,dual"``, are panels of one sheet with one legend, by default
                180 mm wide; each takes the options that it has.
            model: the same for a model alone.
            font_size: text size of the larger labels, in points; if omitted, 7. All other
                text and the lines keep their proportions to it; the width stays.
            font: of the text of a picture, by the name of an installed family, "Times New Roman";
                if omitted, "DejaVu Sans", which comes with matplotlib. TeX sets TikZ in its own.
            text: in SVG "outlines", which look the same everywhere, or "text", which can be found
                and edited, in the fonts that the reader has.
            fragment: TikZ for ``\\input`` instead of a document.
            theme: of a picture: "light", if omitted; "dark"; or "mono", black on white with
                hatchings.
            legend: of a picture: "below", if omitted; "right"; or "none".
            columns: of panels; 2, if omitted.
            frames: how many pictures make a full turn; 36, if omitted. They have no
                labels of regions unless these are asked for.
            options: those of the function of the view, model or page. The width of a view and the
                size of a model are in millimetres, or texts with a unit: ``"8.4cm"``, ``"252pt"``.

        Returns:
            What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": name}``.

        Raises:
            InputError: unknown suffix, view, model or option, what the view refuses, no place to
                write.
            MissingExtraError: matplotlib is absent.
            TypeError: an option has another name now.
        """
        kind, name = self.target(path, view, model)
        known = self.options(kind, name)
        self._check_options(kind, name, options)
        for length in LENGTHS & options.keys():
            options[length] = millimetres(options[length], f"the {length}")
        suffix = Path(path).suffix.lower()
        printing = {"font_size": font_size, "theme": theme, "legend": legend, "text": text}
        printing |= {"fragment": fragment, "frames": frames, "columns": columns, "font": font}
        _check_form(kind, suffix, printing, name)
        if kind == "view":
            from .path_artist import finished, write_scene
            from .scene.layout import picture_width
            from .scene.scene import FONT, NarrowError

            scale = 1.0 if font_size is None else points(font_size, "the font size") / FONT
            width = options.get("width", known["width"].default)
            place = legend or LEGENDS[0]
            options["width"] = picture_width(width, place) / scale

            def scene(**azimuth: float) -> Scene:
                try:
                    made = self._scene(subject, name, columns, {**options, **azimuth})
                except NarrowError as error:
                    if options["width"] == width:
                        raise
                    why = [f"1/{scale:.3g} of it for the font size"] * (scale != 1)
                    why += ["without the legend at the right"] * (place == "right")
                    counted = f"{width:.4g}, counted as {', '.join(why)}"
                    raise InputError(f"{error} (the width given is {counted})") from None
                return finished(made, place, theme or THEMES[0], scale)

            if suffix not in MOVIES:
                write_scene(path, scene, letters=text == "text", font=font, fragment=fragment)
            elif "azimuth" in known:
                if "labels" in known:
                    options.setdefault("labels", "none")
                write_movie(path, scene, FRAMES if frames is None else frames, font)
            else:
                able = [view for view in self.views if "azimuth" in self.options("view", view)]
                raise InputError(f"the view {name} does not turn; there are {', '.join(able)}")
        elif kind == "page":
            write_text_atomically(path, self._named(kind, name)(subject, **options))
        else:
            write_bytes_atomically(path, self._named(kind, name)(subject, suffix, **options))
        return {kind: name}

    def _scene(
        self, subject: Any, name: str, columns: int | None, options: dict[str, Any]
    ) -> Scene:
        """Return the scene of a view, or of several as panels of a sheet."""
        from .scene.layout import APART, composed

        names = name.split(",")
        if len(names) == 1:
            return self._named("view", name).scene(subject, **options)  # type: ignore[no-any-return]
        count = 2 if columns is None else columns
        shares = max(1, min(count, len(names)))
        options["width"] = (options["width"] + APART) / shares - APART
        parts = []
        for part in names:
            own = self.options("view", part).keys() & options.keys()
            view = self._named("view", part)
            parts.append(view.scene(subject, **{key: options[key] for key in own}))
        return composed(parts, count)

    @_within_floats()
    def draw(self, subject: Any, view: str | None = None, **options: Any) -> Drawing:
        """Draw a view, or several as panels, as a figure of matplotlib; by default the first view.

        Args:
            subject: as in `write`.
            view: its name; or names separated by commas, for panels side by side.
            options: those of its function; ``ax`` to draw into axes, a figure or a subfigure.

        Raises:
            InputError: an unknown view or option, or what the view refuses.
            MissingExtraError: matplotlib is absent.
            TypeError: an option has another name now.
        """
        name = next(iter(self.views)) if view is None else view
        own = {option: value for option, value in options.items() if option != "ax"}
        self._check_options("view", name, own)
        if "," not in name:
            made: Drawing = self._named("view", name)(subject, **options)
            return made
        from .figure import drawing

        if len(own) < len(options):
            raise InputError("ax takes one view; draw each of several into axes of its own")
        return drawing(self._scene(subject, name, None, {"width": WHOLE, **own}))

    def svg(self, subject: Any, view: str, **options: Any) -> str | None:
        """Return a picture as SVG text; None without matplotlib, or when `write` would refuse."""
        return svg_text(_within_floats()(lambda: self.draw(subject, view, **options)))

    def tikz(self, subject: Any, view: str, **options: Any) -> str | None:
        """Return a picture as TikZ for a document; None as `svg`."""
        from .path_artist import finished
        from .tikz.tikz import tikz

        try:
            self._check_options("view", view, options)
            with own_settings(), _within_floats():
                made = self._scene(subject, view, None, options)
                return tikz(finished(made, LEGENDS[0], THEMES[0]), fragment=True)
        except (InputError, MissingExtraError):
            return None

    def _check_options(self, kind: str, name: str, options: Iterable[str]) -> None:
        """Refuse a name that is unknown, and options that it lacks or needs."""
        self._check_name(kind, name)
        found = self.options(kind, name)
        check_renamed(options, found)
        for option in options:
            if option not in found:
                raise refusal(
                    f"the {kind} {name} has no option {shown(option)}", option, found, "it has"
                )
        for needed in found.values():
            if needed.required and needed.name not in options:
                raise InputError(f"the {kind} {name} needs {needed.name}; give at least one")

    def _check_name(self, kind: str, name: str) -> None:
        known = getattr(self, f"{kind}s")
        for part in name.split(",") if kind == "view" else [name]:
            if part not in known:
                raise refusal(f"the {kind} is {shown(part)}", part, known)

    def _named(self, kind: str, name: str) -> Any:
        return named(f"{self.package}.{getattr(self, f'{kind}s')[name]}")

    def target(
        self, path: str | os.PathLike[str], view: str | None = None, model: str | None = None
    ) -> tuple[str, str]:
        """Return what a path asks for: "view", "model" or "page", and the name of it.

        Raises:
            InputError: unknown suffix or name, no such folder, or a name that does not go with the
                suffix.
        """
        models = MODELS if self.models else ()
        kinds = {"view": (*PICTURES, *TIKZ, *MOVIES), "model": models, "page": PAGES}
        suffix = ending(path, sorted(end for suffixes in kinds.values() for end in suffixes))
        kind = next(kind for kind, suffixes in kinds.items() if suffix in suffixes)
        known, name = getattr(self, f"{kind}s"), view
        if kind == "model":
            if view in self.views and view not in known:
                there = ", ".join(known)
                raise InputError(f"the view {view} has no model; there are models of {there}")
            if view is not None and model not in (None, view):
                raise InputError(f"the view is {view} and the model {model}; name one")
            name = view or model
        elif model is not None:
            raise InputError(
                f"a model was named and the file name ends in {suffix}; a model needs one of "
                f"{', '.join(models)}"
            )
        name = next(iter(known)) if name is None else name
        self._check_name(kind, name)
        return kind, name

    def summary(self, kind: str, name: str) -> str:
        """Return what a view, model or page is: the first line of the docstring."""
        return (self._named(kind, name).__doc__ or "").partition("\n")[0]

    def options(self, kind: str, name: str) -> dict[str, Option]:
        """Return the options of a view, model or page by name; of panels those of all."""
        parts = name.split(",") if kind == "view" else [name]
        found = {k: x for part in parts for k, x in _options(self._named(kind, part)).items()}
        if len(parts) > 1 and "width" in found:
            found["width"] = replace(found["width"], default=WHOLE)
        return found


def write_movie(
    path: str | os.PathLike[str], make: Callable[..., Scene], count: int, font: str | None = None
) -> None:
    """Write the pictures that `make` returns for angles ``azimuth`` all around, one after another.

    Raises:
        InputError: no such number of pictures, or no ffmpeg for ``.mp4``.
        MissingExtraError: matplotlib is absent.
    """
    from .path_artist import figure

    if not isinstance(count, int) or not 2 <= count <= 720:
        raise InputError(f"a turn has {shown(count)} frames; give 2 to 720")
    frames = []
    for k in watched(range(count), "pictures"):
        with own_settings(font_settings(font)):
            sheet = make(azimuth=360 * k / count)
            frames.append(picture_bytes(".png", partial(figure, sheet), dpi=150, font=font))
    write_bytes_atomically(path, movie_bytes(ending(path, MOVIES), frames))


#: Options that are lengths, in millimetres.
LENGTHS = {"width", "size"}
LETTERS = ("outlines", "text")
#: Pictures of a full turn, and the width of a sheet with panels, in millimetres.
FRAMES, WHOLE = 36, 180.0


def _check_form(kind: str, suffix: str, printing: Mapping[str, Any], name: str = "") -> None:
    """Refuse what does not go with a kind of file."""
    given = {name for name, x in printing.items() if x is not None and x is not False}
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
    for name, known in (("theme", THEMES), ("legend", LEGENDS), ("text", LETTERS)):
        if name in given:
            check_choice(name, printing[name], known)


@cache
def _options(view: Callable[..., Any]) -> dict[str, Option]:
    texts = _explained(inspect.getdoc(view) or "")
    options = {}
    for name, parameter in inspect.signature(view).parameters.items():
        if parameter.kind is not parameter.KEYWORD_ONLY:
            continue
        kind = parameter.annotation.split(" | ")[0]
        if many := kind.startswith("Iterable["):
            kind = kind.removeprefix("Iterable[").removesuffix("]")
        needed = parameter.default is parameter.empty
        number = parameter.default if isinstance(parameter.default, float) else math.nan
        options[name] = Option(name, kind, many, needed, number, texts.get(name, ""))
    return options


def _explained(docstring: str) -> dict[str, str]:
    """Return the explanations of arguments in a docstring."""
    texts: dict[str, str] = {}
    names: list[str] = []
    for line in docstring.partition("Args:\n")[2].partition("\n\n")[0].splitlines():
        if line.startswith("    ") and not line.startswith("     "):
            head, _, line = line.partition(":")
            names = head.strip().split(", ")
        for name in names:
            texts[name] = f"{texts.get(name, '')} {line.strip()}".strip()
    return texts
