"""One registry of drawings for each package, and what both do with it: draw, write files.

A view is one function in one file of a package of pictures, and one line in its registry. Its
options are its keyword-only parameters (`arrangement.console.options.signature`): a view brings its
kinds of options, as its line says what it can show. No module here knows any view.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from arrangement.console.options.signature import Option, Syntax, options_of, summary
from arrangement.console.options.values import rational_argument
from arrangement.console.plugins import named
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
    check_renamed,
    ending,
    millimetres,
    own_settings,
    svg_text,
)
from .printing import Printing, write_movie

if TYPE_CHECKING:
    from .path_artist import Drawing
    from .scene.scene import Scene

#: Kinds of options that views of both packages have; other kinds are where the views are.
Vector: TypeAlias = Annotated[Sequence[object], Syntax(rational_argument, ("X", "Y", "Z"), 3)]
Exact: TypeAlias = Annotated[object, Syntax(rational_argument, "Q")]
Corner: TypeAlias = Annotated[Iterable[Any], Syntax(lambda text: text.split(","), "X,Y")]
_LENGTH = Syntax(metavar="LENGTH")
#: On paper: a number, or a text such as ``"8pt"``.
Length: TypeAlias = Annotated[object, _LENGTH]
LegendPlace: TypeAlias = Annotated[str | None, Syntax(metavar="PLACE")]
TextKind: TypeAlias = Annotated[str | None, Syntax(metavar="KIND")]

#: What can be drawn: pictures, models for printers, interactive pages.
KINDS = ("view", "model", "page")
#: Options that are lengths, in millimetres.
LENGTHS = {"width", "size"}
#: The width of a sheet with panels, in millimetres.
WHOLE = 180.0


def _anything(_: Any) -> bool:
    return True


@dataclass(frozen=True)
class ViewEntry:
    """A line of a registry.

    Attributes:
        place: of the function, ``module:function`` below the package.
        shows: whether it can show a subject.
    """

    place: str
    shows: Callable[[Any], bool] = _anything


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
        views: of pictures, by name: ``f(subject, **options) -> Figure``; the first one is the
            default.
        models: likewise, ``f(subject, suffix, **options) -> bytes``.
        pages: likewise, ``f(subject, **options) -> str``.
    """

    package: str
    views: Mapping[str, ViewEntry]
    models: Mapping[str, ViewEntry]
    pages: Mapping[str, ViewEntry]

    def entries(self, kind: str) -> Mapping[str, ViewEntry]:
        """Return the views, models or pages by name."""
        known: Mapping[str, ViewEntry] = getattr(self, f"{kind}s")
        return known

    def function(self, kind: str, name: str) -> Any:
        """Return the function of a view, model or page."""
        return named(f"{self.package}.{self.entries(kind)[name].place}")

    def summary(self, kind: str, name: str) -> str:
        """Return what a view, model or page is: the first paragraph of the docstring."""
        return summary(self.function(kind, name))

    def options(self, kind: str, name: str) -> dict[str, Option]:
        """Return the options of a view, model or page by name; of panels those of all."""
        found: dict[str, Option] = {}
        for part in name.split(",") if kind == "view" else [name]:
            found |= options_of(self.function(kind, part), keywords=True)
        found |= {key: replace(found[key], syntax=_LENGTH) for key in LENGTHS & found.keys()}
        if "," in name and "width" in found:
            found["width"] = replace(found["width"], default=WHOLE)
        return found

    def fitting(self, subject: Any) -> Drawings:
        """Return what can be drawn of a subject."""
        kinds: dict[str, Any] = {
            f"{kind}s": {
                name: view for name, view in self.entries(kind).items() if view.shows(subject)
            }
            for kind in KINDS
        }
        return replace(self, **kinds)

    @_within_floats()
    def write(
        self,
        subject: Any,
        path: str | os.PathLike[str],
        view: str | None = None,
        model: str | None = None,
        *,
        font: str | None = None,
        font_size: Length = None,
        theme: str | None = None,
        legend: LegendPlace = None,
        text: TextKind = None,
        fragment: bool = False,
        columns: int | None = None,
        frames: int | None = None,
        **options: Any,
    ) -> dict[str, Any]:
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
            font_size: size of the larger text, such as 8pt (default: 7pt); lines follow.
            font: of .svg, .pdf, .png: an installed font (default: DejaVu Sans).
            theme: light (default), dark, mono; mono is black on white with hatchings.
            legend: below (default), right, none.
            text: in .svg: outlines (default), which look the same everywhere, or text, which can
                be edited.
            fragment: in .tex: no document, for ``\\input``.
            columns: of panels (default: 2).
            frames: of a full turn in .gif, .mp4 (default: 36); without labels of regions, unless
                these are asked for.
            options: those of the function of the view, model or page. The width of a view and the
                size of a model are in millimetres, or texts with a unit: ``"8.4cm"``, ``"252pt"``.

        Returns:
            What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": name}``; of a
            picture with "notes", a list of what it cannot show, if there is anything.

        Raises:
            InputError: unknown suffix, view, model or option, what the view refuses, no place to
                write.
            MissingExtraError: matplotlib is absent.
            TypeError: an option has another name now.
        """
        kind, name = self.target(path, view, model)
        self._check_options(kind, name, options)
        for length in LENGTHS & options.keys():
            options[length] = millimetres(options[length], f"the {length}")
        printing = Printing(font, font_size, theme, legend, text, fragment, columns, frames)
        suffix = Path(path).suffix.lower()
        printing.check(kind, name, suffix)
        if kind == "view":
            notes = self._write_picture(subject, path, name, printing, options)
            return {kind: name, **({"notes": notes} if notes else {})}
        if kind == "page":
            write_text_atomically(path, self.function(kind, name)(subject, **options))
        else:
            write_bytes_atomically(path, self.function(kind, name)(subject, suffix, **options))
        return {kind: name}

    def _write_picture(
        self,
        subject: Any,
        path: str | os.PathLike[str],
        name: str,
        printing: Printing,
        options: dict[str, Any],
    ) -> list[str]:
        """Write a picture, or one that turns; return what it cannot show."""
        from .path_artist import write_scene

        known = self.options("view", name)
        width = options.get("width", known["width"].default)
        options["width"] = printing.picture_width(width)

        notes: dict[str, None] = {}

        def scene(**azimuth: float) -> Scene:
            with printing.explained(width):
                made = self._scene(subject, name, printing.columns, {**options, **azimuth})
            notes.update(dict.fromkeys(made.legend.notes))
            return printing.finished(made)

        if Path(path).suffix.lower() not in MOVIES:
            letters, fragment = printing.text == "text", printing.fragment
            write_scene(path, scene, letters=letters, font=printing.font, fragment=fragment)
        elif "azimuth" in known:
            if "labels" in known:
                options.setdefault("labels", "none")
            write_movie(path, scene, printing)
        else:
            able = [view for view in self.views if "azimuth" in self.options("view", view)]
            raise InputError(f"the view {name} does not turn; there are {', '.join(able)}")
        return list(notes)

    def _scene(
        self, subject: Any, name: str, columns: int | None, options: dict[str, Any]
    ) -> Scene:
        """Return the scene of a view, or of several as panels of a sheet."""
        from .scene.layout import APART, composed

        names = name.split(",")
        if len(names) == 1:
            return self.function("view", name).scene(subject, **options)  # type: ignore[no-any-return]
        count = 2 if columns is None else columns
        shares = max(1, min(count, len(names)))
        options["width"] = (options["width"] + APART) / shares - APART
        parts = []
        for part in names:
            own = self.options("view", part).keys() & options.keys()
            view = self.function("view", part)
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
            made: Drawing = self.function("view", name)(subject, **options)
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
        known = self.entries(kind)
        for part in name.split(",") if kind == "view" else [name]:
            if part not in known:
                raise refusal(f"the {kind} is {shown(part)}", part, known)

    def target(
        self, path: str | os.PathLike[str], view: str | None = None, model: str | None = None
    ) -> tuple[str, str]:
        """Return what a path asks for: "view", "model" or "page", and the name of it.

        Raises:
            InputError: unknown suffix or name, no such folder, or a name that does not go with the
                suffix.
        """
        models, pages = MODELS if self.models else (), PAGES if self.pages else ()
        kinds = {"view": (*PICTURES, *TIKZ, *MOVIES), "model": models, "page": pages}
        suffix = ending(path, sorted(end for suffixes in kinds.values() for end in suffixes))
        kind = next(kind for kind, suffixes in kinds.items() if suffix in suffixes)
        known, name = self.entries(kind), view
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
