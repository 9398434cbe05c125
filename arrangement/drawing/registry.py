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
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement.console.plugins import named
from arrangement.console.writing import write_bytes_atomically, write_text_atomically
from arrangement.errors import InputError, refusal
from arrangement.numbers.exact import shown

from .output import (
    LEGENDS,
    MODELS,
    PAGES,
    PICTURES,
    THEMES,
    TIKZ,
    ending,
    millimetres,
    own_settings,
    picture_bytes,
    points,
    svg_text,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .scene.scene import Scene

#: The kinds of options, for signatures; `command` tells how each is written on a command line.
Vector: TypeAlias = Sequence[object]
Exact: TypeAlias = object
Wrench: TypeAlias = Iterable[Any]
Corner: TypeAlias = Iterable[Any]
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
        text: str | None = None,
        fragment: bool = False,
        theme: str | None = None,
        legend: str | None = None,
        **options: Any,
    ) -> dict[str, str]:
        """Draw into a file, whole or not at all.

        Args:
            subject: an arrangement, or a grasp, that the view can show; see its function.
            path: ``.svg``, ``.pdf``, ``.png`` or ``.tex`` (TikZ) for a picture; ``.stl``, ``.glb``
                or ``.obj`` for a model. STL and OBJ are in millimetres, GLB is in metres as its
                standard demands; ``.html`` for an interactive page.
            view: of a picture or a page; if omitted, the first one.
            model: if omitted, the first one.
            font_size: of the larger letters of a picture, in points; if omitted, 7. All other
                letters and the lines keep their proportions to it; the width stays.
            text: in SVG "outlines", which look the same everywhere, or "text", which can be found
                and edited, in the fonts that the reader has.
            fragment: TikZ for ``\\input`` instead of a document.
            theme: of a picture: "light", if omitted; "dark"; or "mono", black on white with
                hatchings.
            legend: of a picture: "below", if omitted; "right"; or "none".
            options: those of the function of the view, model or page. The width of a view and the
                size of a model are in millimetres, or texts with a unit: ``"8.4cm"``, ``"252pt"``;
                the size of a view is its width.

        Returns:
            What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": name}``.

        Raises:
            InputError: unknown suffix, view, model or option, what the view refuses, no place to
                write.
            MissingExtraError: matplotlib is absent.
        """
        kind, name = self.target(path, view, model)
        known = self.options(kind, name)
        if "size" in options and "size" not in known and "width" in known:
            if "width" in options:
                raise InputError("a picture has one size, its width, and both are given; give one")
            options["width"] = options.pop("size")
        draw = self._function(kind, name, options)
        for length in LENGTHS & options.keys():
            options[length] = millimetres(options[length], f"the {length}")
        suffix = Path(path).suffix.lower()
        printing = {"font_size": font_size, "theme": theme, "legend": legend, "text": text}
        _check_form(kind, suffix, {**printing, "fragment": fragment})
        if kind == "view":
            from .scene.layout import laid_out, picture_width
            from .scene.scene import FONT, NarrowError
            from .themes import themed

            scale = 1.0 if font_size is None else points(font_size, "the font size") / FONT
            width = options.get("width", known["width"].default)
            place = legend or LEGENDS[0]
            options["width"] = picture_width(width, place) / scale

            def scene() -> Scene:
                try:
                    made: Scene = draw.scene(subject, **options)
                except NarrowError as error:
                    if options["width"] == width:
                        raise
                    why = [f"1/{scale:.3g} of it for the font size"] * (scale != 1)
                    why += ["without the legend at the right"] * (place == "right")
                    counted = f"{width:.4g}, counted as {', '.join(why)}"
                    raise InputError(f"{error} (the width given is {counted})") from None
                return themed(laid_out(made, place).scaled(scale), theme or THEMES[0])

            write_scene(path, scene, letters=text == "text", fragment=fragment)
        elif kind == "page":
            write_text_atomically(path, draw(subject, **options))
        else:
            write_bytes_atomically(path, draw(subject, suffix, **options))
        return {kind: name}

    @_within_floats()
    def draw(self, subject: Any, view: str | None = None, **options: Any) -> Figure:
        """Draw a view as a figure of matplotlib; the first one if none is named.

        Args:
            subject: as in `write`.
            view: its name.
            options: those of its function; ``ax`` to draw into axes, a figure or a subfigure.

        Raises:
            InputError: an unknown view or option, or what the view refuses.
            MissingExtraError: matplotlib is absent.
        """
        name = next(iter(self.views)) if view is None else view
        own = {option: value for option, value in options.items() if option != "ax"}
        made: Figure = self._function("view", name, own)(subject, **options)
        return made

    def svg(self, subject: Any, view: str, **options: Any) -> str | None:
        """Return a picture as SVG text; None without matplotlib, or when `write` would refuse."""
        draw = _within_floats()(lambda: self._function("view", view, options)(subject, **options))
        return svg_text(draw)

    def _function(self, kind: str, name: str, options: Mapping[str, Any]) -> Any:
        """Return the function behind a name, if it has these options.

        Raises:
            InputError: an unknown name or option.
        """
        known = getattr(self, f"{kind}s")
        if name not in known:
            raise refusal(f"the {kind} is {shown(name)}", name, known)
        found = self.options(kind, name)
        for option in options:
            if option not in found:
                raise refusal(
                    f"the {kind} {name} has no option {shown(option)}", option, found, "it has"
                )
        for needed in found.values():
            if needed.required and needed.name not in options:
                raise InputError(f"the {kind} {name} needs {needed.name}; give at least one")
        return self._named(kind, name)

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
        kinds = {"view": (*PICTURES, *TIKZ), "model": models, "page": PAGES}
        suffix = ending(path, sorted(end for suffixes in kinds.values() for end in suffixes))
        kind = next(kind for kind, suffixes in kinds.items() if suffix in suffixes)
        name, other = (model, view) if kind == "model" else (view, model)
        if other is not None:
            wrong = "view" if kind == "model" else "model"
            raise InputError(
                f"a {wrong} was named and the file name ends in {suffix}; a {wrong} needs one of "
                f"{', '.join(kinds[wrong])}"
            )
        known = getattr(self, f"{kind}s")
        name = next(iter(known)) if name is None else name
        if name not in known:
            raise refusal(f"the {kind} is {shown(name)}", name, known)
        return kind, name

    def options(self, kind: str, name: str) -> dict[str, Option]:
        """Return the options of a view, model or page by name."""
        return _options(self._named(kind, name))


def write_scene(
    path: str | os.PathLike[str],
    make: Callable[[], Scene],
    *,
    letters: bool = False,
    fragment: bool = False,
) -> None:
    """Write the scene that `make` returns, as it is, in the format of the suffix.

    Raises:
        InputError: the suffix is not one of a picture, or there is no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = ending(path, (*PICTURES, *TIKZ))
    if suffix in TIKZ:
        from .tikz.tikz import tikz

        with own_settings():
            write_text_atomically(path, tikz(make(), fragment=fragment))
    else:
        from .figure import figure

        content = picture_bytes(suffix, lambda: figure(make()), letters=letters)
        write_bytes_atomically(path, content)


#: Options that are lengths, in millimetres.
LENGTHS = {"width", "size"}
LETTERS = ("outlines", "text")


def _check_form(kind: str, suffix: str, printing: Mapping[str, Any]) -> None:
    """Refuse what does not go with a kind of file."""
    given = {name for name, x in printing.items() if x is not None and x is not False}
    for names, fits, what in (
        (
            {"font_size", "theme", "legend"},
            kind == "view",
            "a font size, legend or theme is for pictures",
        ),
        ({"fragment"}, suffix in TIKZ, "a fragment is TikZ, .tex"),
        ({"text"}, suffix == ".svg", "text or outlines is a choice of .svg"),
    ):
        if given & names and not fits:
            raise InputError(f"{what}, and the file name ends in {suffix}")
    for name, known in (("theme", THEMES), ("legend", LEGENDS), ("text", LETTERS)):
        if name in given and printing[name] not in known:
            raise refusal(f"the {name} is {shown(printing[name])}", printing[name], known)


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
