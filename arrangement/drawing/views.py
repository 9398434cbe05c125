"""What a view is: a function, its options, what its help says, and the files that it writes.

A view is one function in a package of pictures, and one line in the table of the package
(`Drawings`). It returns a scene; `picture` makes it a function that returns a figure. Its options
are its keyword-only parameters, its help is its docstring (`console.options.signature`). The
command ``draw`` is made from the table (`drawing.command`). No module here knows any view.
"""

from __future__ import annotations

import functools
import inspect
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, fields, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ParamSpec, Protocol, TypeAlias, overload

from arrangement.console.options.signature import Option, Syntax, options_of
from arrangement.console.options.values import rational_argument
from arrangement.console.progress import watched
from arrangement.console.writing import write_bytes_atomically, write_text_atomically
from arrangement.drawing.layout import APART, lay_out, panel_sheet, picture_width
from arrangement.drawing.output import (
    DPIS,
    LEGENDS,
    MODELS,
    MOVIES,
    PAGES,
    PICTURES,
    THEMES,
    TIKZ,
    check_choice,
    ending,
    font_settings,
    movie_bytes,
    own_settings,
    picture_bytes,
    svg_text,
)
from arrangement.drawing.scene import (
    FONT,
    SHEET,
    NarrowError,
    Scene,
    checked_width,
    millimetres,
    points,
    require_matplotlib,
)
from arrangement.errors import InputError, MissingExtraError, refusal
from arrangement.hints import described, hints_on_arguments, summary, unknown_arguments
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.synonyms import by_word

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .path_artist import Drawing, Room

P = ParamSpec("P")

#: Kinds of options that views of both packages have; other kinds are where the views are.
Vector: TypeAlias = Annotated[Sequence[object], Syntax(rational_argument, ("X", "Y", "Z"), 3)]
Exact: TypeAlias = Annotated[object, Syntax(rational_argument, "Q")]
Corner: TypeAlias = Annotated[Iterable[Any], Syntax(lambda text: text.split(","), "X,Y")]
_LENGTH = Syntax(metavar="LENGTH")
#: On paper: a number, or a text such as ``"8pt"``.
Length: TypeAlias = Annotated[object, _LENGTH]
LegendPlace: TypeAlias = Annotated[str | None, Syntax(metavar="PLACE")]
TextKind: TypeAlias = Annotated[str | None, Syntax(metavar="KIND")]

#: Other words for options, each with its name.
OPTION_SYNONYMS = by_word("""
    axes -> slice
    base -> bottom
    highlight colors dashes line_color line_colors linestyle linestyles style -> colours
    direction elev elevation view_direction viewpoint -> camera
    directions -> rays
    piece -> equilibrium
    plane -> section
    turn -> rotation
    rotate azim -> azimuth
    figsize height figure_width -> width
    cmap color fill palette region_colors region_colours shade shading -> colour
    label label_regions region_labels -> labels
    label_lines line_labels line_names -> names
    bbox bounds limits range xlim xrange ylim -> window
    force forces load -> wrench
""")
#: In Python other functions, and values, are written.
_IN_PYTHON = by_word("""
    cmap colormap palette -> colour='gold,#0072b2' (there are no colour maps)
    suptitle title -> figure = draw(...); figure.suptitle(TITLE); figure.savefig(FILE)
""")


#: What can be drawn: pictures, models for printers, interactive pages.
KINDS = ("view", "model", "page")
#: Options that are lengths, in millimetres.
LENGTHS = {"width", "size"}
#: Text of SVG; the first one is the default.
LETTERS = ("outlines", "text")
#: The width of a sheet with panels, in millimetres.
WHOLE = 180.0


#: What holds for every view: said once, and added to the docstrings.
_WIDTH = "    width: width of the figure, in millimetres.\n"
_AX = """    ax: axes, a figure or subfigure of matplotlib to draw into. The picture takes the room
        that is there and has no legend; each element is an artist with its name as ``gid``.
"""
_ABSENT = "    MissingExtraError: matplotlib is absent.\n"


class DrawingView(Protocol[P]):
    """A view as a function: it returns the figure in which it has drawn."""

    scene: Callable[..., Scene]

    @overload
    def __call__(self, *args: P.args, **options: P.kwargs) -> Drawing: ...
    @overload
    def __call__(self, subject: Any, /, *, ax: Room, **options: Any) -> Figure: ...


def picture(least: float = 40.0) -> Callable[[Callable[P, Scene]], DrawingView[P]]:
    """Return a decorator: a view draws its scene, with its legend, as a matplotlib figure.

    The scene stays within reach, for other writers: ``draw_sphere.scene``. Every view has a width,
    which is checked here.

    Args:
        least: the least width, in millimetres.
    """

    def decorate(view: Callable[P, Scene]) -> DrawingView[P]:
        @hints_on_arguments(OPTION_SYNONYMS)
        @functools.wraps(view)
        def scene(*args: P.args, **options: P.kwargs) -> Scene:
            if "width" in options:
                options["width"] = checked_width(options["width"], least)
            return view(*args, **options)

        @functools.wraps(view)
        def draw(*args: Any, ax: Room | None = None, **options: Any) -> Figure:
            if ax is None:
                return drawing(scene(*args, **options))
            require_matplotlib()
            from .path_artist import into

            return into(
                ax, lambda width: lay_out(scene(*args, **{"width": width, **options}), "none")
            )

        text = inspect.cleandoc(view.__doc__ or "")  # Python 3.13 takes the indent away itself
        if "    width:" not in text:
            text = text.replace("\nRaises:", f"{_WIDTH}\nRaises:")
        text = text.replace("\nRaises:", f"{_AX}\nRaises:")
        draw.__doc__ = f"{text}\n{_ABSENT}"
        draw.__annotations__ = {**view.__annotations__, "return": "Drawing"}
        draw.scene = scene  # type: ignore[attr-defined]
        made: Any = draw
        return made  # type: ignore[no-any-return]

    return decorate


def drawing(scene: Scene) -> Drawing:
    """Return a picture with its legend as a figure.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    from .path_artist import Drawing

    return Drawing(scene)


@dataclass(frozen=True)
class Printing:
    """How a picture is printed; these options have all pictures.

    Args:
        font: an installed font, or serif, sans, mono (default: sans); in .svg, .pdf, .png.
        font_size: size of the larger text, such as 8pt (default: 7pt); line widths scale with it.
        theme: light (default), dark, mono; mono is black on white with hatching.
        legend: below (default), right, none.
        text: letters in .svg: outlines (default), which look the same everywhere, or text, which
            can be edited.
        dpi: dots per inch of .png (default: 300).
        transparent: omit the background of .svg, .pdf, .png.
        fragment: write .tex without a document, for ``\\input``.
        columns: number of columns of panels (default: 2).
        frames: number of frames of .gif, .mp4, for a full turn or the range of a letter (default:
            36); regions have no labels, unless labels are set.
    """

    font: str | None = None
    font_size: Length = None
    theme: str | None = None
    legend: LegendPlace = None
    text: TextKind = None
    dpi: int | None = None
    transparent: bool = False
    fragment: bool = False
    columns: int | None = None
    frames: int | None = None

    def check(self, kind: str, name: str, suffix: str) -> None:
        """Refuse what does not go with a view, model or page, or with a kind of file."""
        names_set = {name for name, x in asdict(self).items() if x is not None and x is not False}
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
            ({"dpi"}, suffix == ".png", "dots per inch are a choice of .png"),
            (
                {"transparent"},
                kind == "view" and suffix in PICTURES,
                "a transparent background is for .svg, .pdf and .png",
            ),
            ({"text"}, suffix == ".svg", "text or outlines is a choice of .svg"),
            ({"frames"}, suffix in MOVIES, "frames are for .gif and .mp4"),
            ({"columns"}, "," in name, "columns are for several views, such as sphere,dual"),
        ):
            if names_set & names and not fits:
                raise InputError(f"{what}, and the file name ends in {suffix}")
        for name, known in (("theme", THEMES), ("legend", LEGENDS), ("text", LETTERS)):
            if name in names_set:
                check_choice(name, getattr(self, name), known)
        if self.dpi is not None and self.dpi not in DPIS:
            raise InputError(f"dpi is {shown(self.dpi)}; expected {DPIS[0]} to {DPIS[-1]}")

    @property
    def scale(self) -> float:
        """How large text and lines are, in units of the usual size."""
        return 1.0 if self.font_size is None else points(self.font_size, "the font size") / FONT

    def picture_width(self, width: float) -> float:
        """Return the width of the picture itself at its usual size, on a sheet of a width."""
        return picture_width(width, self.legend or LEGENDS[0]) / self.scale

    @contextmanager
    def explain_narrow(self, width: float) -> Iterator[None]:
        """Explain why a picture is too narrow, where its own width is not that of the sheet."""
        try:
            yield
        except NarrowError as error:
            if self.picture_width(width) == width:
                raise
            why = [f"1/{self.scale:.3g} of it for the font size"] * (self.scale != 1)
            why += ["without the legend at the right"] * (self.legend == "right")
            counted = f"{width:.4g}, counted as {', '.join(why)}"
            raise InputError(f"{error} (the width given is {counted})") from None

    def finish(self, scene: Scene) -> Scene:
        """Return the sheet with a picture, its legend and its captions, in the theme."""
        from .path_artist import finish

        made = finish(scene, self.legend or LEGENDS[0], self.theme or THEMES[0], self.scale)
        if self.transparent:
            made.items = [item for item in made.items if item.name != SHEET]
        return made

    def write_movie(
        self,
        path: str | os.PathLike[str],
        make: Callable[..., Scene],
        changes: Callable[[int], Iterable[Mapping[str, Any]]],
    ) -> None:
        """Write the pictures that `make` returns with options that change.

        Args:
            changes: the options of each picture, from the number of pictures.

        Raises:
            InputError: no such number of pictures, or no ffmpeg for ``.mp4``.
            MissingExtraError: matplotlib is absent.
        """
        from .path_artist import figure

        count = 36 if self.frames is None else self.frames
        if not isinstance(count, int) or not 2 <= count <= 720:
            raise InputError(f"frames is {shown(count)}; give 2 to 720")
        frames = []
        for options in watched(list(changes(count)), "pictures"):
            with own_settings(font_settings(self.font)):
                drawn = functools.partial(figure, make(**options))
                frames.append(picture_bytes(".png", drawn, dpi=150, font=self.font))
        write_bytes_atomically(path, movie_bytes(ending(path, MOVIES), frames))


PRINTING = {field.name for field in fields(Printing)}


@dataclass(frozen=True)
class ViewEntry:
    """A line of the table of a package.

    Attributes:
        place: of the function, ``module:function`` below the package.
        shows: whether it can show a subject.
        in_panels: options that it has by default as one of several panels.
        changes: the options of each picture of a movie, from the subject and the number of
            pictures; None: it turns, if it has an azimuth.
    """

    place: str
    shows: Callable[[Any], bool] = lambda _: True
    in_panels: Mapping[str, Any] = field(default_factory=dict)
    changes: Callable[[Any, int], Iterable[Mapping[str, Any]]] | None = None


def able_to_show(views: Mapping[str, ViewEntry], subject: Any) -> dict[str, ViewEntry]:
    """Return the views, models or pages that can show a subject."""
    return {name: view for name, view in views.items() if view.shows(subject)}


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
        select: returns those of them that suit a subject, the best one first.
    """

    package: str
    views: Mapping[str, ViewEntry]
    models: Mapping[str, ViewEntry]
    pages: Mapping[str, ViewEntry]
    select: Callable[[Mapping[str, ViewEntry], Any], Mapping[str, ViewEntry]] = able_to_show

    def entries(self, kind: str) -> Mapping[str, ViewEntry]:
        """Return the views, models or pages by name."""
        known: Mapping[str, ViewEntry] = getattr(self, f"{kind}s")
        return known

    def function(self, kind: str, name: str) -> Any:
        """Return the function of a view, model or page."""
        module, _, function = self.entries(kind)[name].place.partition(":")
        return getattr(import_module(f"{self.package}.{module}"), function)

    def summary(self, kind: str, name: str) -> str:
        """Return what a view, model or page is: the first paragraph of the docstring."""
        return summary(self.function(kind, name))

    def options(self, kind: str, name: str) -> dict[str, Option]:
        """Return the options of a view, model or page by name; of panels those of all."""
        options: dict[str, Option] = {}
        for part in name.split(",") if kind == "view" else [name]:
            options |= options_of(self.function(kind, part), keywords=True)
        options |= {key: replace(options[key], syntax=_LENGTH) for key in LENGTHS & options.keys()}
        if "," in name and "width" in options:
            options["width"] = replace(options["width"], default=WHOLE)
        return options

    def of(self, subject: Any) -> Drawings:
        """Return what suits a subject, the best view, model and page first."""
        views, models, pages = (self.select(self.entries(kind), subject) for kind in KINDS)
        return replace(self, views=views, models=models, pages=pages)

    @_within_floats()
    def write(
        self,
        subject: Any,
        path: str | os.PathLike[str],
        view: str | None = None,
        model: str | None = None,
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
            options: those of `Printing`, and of the function of the view, model or page. The width
                of a view and the size of a model are in millimetres, or texts with a unit:
                ``"8.4cm"``, ``"252pt"``.

        Returns:
            What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": name}``; of a
            picture with "notes", a list of what it cannot show, if there is anything.

        Raises:
            InputError: unknown suffix, view, model or option, what the view refuses, no place to
                write.
            MissingExtraError: matplotlib is absent.
        """
        kind, name = self.target(path, view, model)
        printing = Printing(**{key: options.pop(key) for key in PRINTING & options.keys()})
        self._check_options(kind, name, options)
        for length in LENGTHS & options.keys():
            options[length] = millimetres(options[length], f"the {length}")
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

        def scene(**changed: Any) -> Scene:
            with printing.explain_narrow(width):
                made = self._scene(subject, name, printing.columns, {**options, **changed})
            notes.update(dict.fromkeys(made.legend.notes))
            return printing.finish(made)

        if Path(path).suffix.lower() not in MOVIES:
            letters, fragment = printing.text == "text", printing.fragment
            write_scene(
                path,
                scene,
                letters=letters,
                font=printing.font,
                fragment=fragment,
                dpi=printing.dpi,
                transparent=printing.transparent,
            )
        elif name in self.views and (changes := self.views[name].changes):
            printing.write_movie(path, scene, functools.partial(changes, subject))
        elif "azimuth" in known:
            if "labels" in known:
                options.setdefault("labels", "none")
            printing.write_movie(
                path, scene, lambda count: ({"azimuth": 360 * k / count} for k in range(count))
            )
        else:
            able = [view for view in self.views if "azimuth" in self.options("view", view)]
            raise InputError(f"the view {name} does not turn; there are {', '.join(able)}")
        return list(notes)

    def _scene(
        self, subject: Any, name: str, columns: int | None, options: dict[str, Any]
    ) -> Scene:
        """Return the scene of a view, or of several as panels of a sheet."""
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
            chosen = {key: options[key] for key in own}
            parts.append(view.scene(subject, **{**self.views[part].in_panels, **chosen}))
        return panel_sheet(parts, count)

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
        """
        is_file = isinstance(view, str) and bool(Path(view).suffix)
        if view is not None and not is_file:
            self._check_name("view", view)
        drawings = self if view in self.views else self.of(subject)
        name = next(iter(drawings.views)) if view is None or is_file else view
        own = {option: value for option, value in options.items() if option != "ax"}
        if is_file:
            raise drawings._file_error(str(view), name, options)
        drawings._check_options("view", name, own)
        if "," not in name:
            made: Drawing = self.function("view", name)(subject, **options)
            return made
        if len(own) < len(options):
            raise InputError("ax takes one view; draw each of several into axes of its own")
        return drawing(self._scene(subject, name, None, {"width": WHOLE, **own}))

    def svg(self, subject: Any, view: str | None = None, **options: Any) -> str | None:
        """Return a picture as SVG text; None without matplotlib, or when `write` would refuse."""
        return svg_text(_within_floats()(lambda: self.draw(subject, view, **options)))

    def tikz(self, subject: Any, view: str, **options: Any) -> str | None:
        """Return a picture as TikZ for a document; None as `svg`."""
        from arrangement.drawing.tikz import tikz

        try:
            self._check_options("view", view, options)
            with own_settings(), _within_floats():
                made = self._scene(subject, view, None, options)
                return tikz(Printing().finish(made), fragment=True)
        except (InputError, MissingExtraError):
            return None

    def _check_options(self, kind: str, name: str, options: Iterable[str]) -> None:
        """Refuse a name that is unknown, and options that it lacks or needs."""
        self._check_name(kind, name)
        known = self.options(kind, name)
        if unknown := [option for option in options if option not in known]:
            synonyms = OPTION_SYNONYMS | budget.by_caller(_IN_PYTHON, {})
            lacks = unknown_arguments(unknown, known, synonyms)
            having = {
                other: [
                    x for x in self.entries(other) if self.options(other, x).keys() >= {*unknown}
                ]
                for other in (kind, *KINDS)
            }
            other = next(filter(having.get, having), "") * (";" not in lacks)
            others = (
                f" ({other}s with it: {', '.join(having[other])})"
                if other and ";" not in lacks
                else ""
            )
            has = described({word: option.text for word, option in known.items()})
            raise InputError(f"the {kind} {name} has no option {lacks}{others}. It has{has}")
        for needed in known.values():
            if needed.required and needed.name not in options:
                raise InputError(f"the {kind} {name} needs {needed.name}; give at least one")

    def _file_error(self, file: str, view: str, options: Mapping[str, Any]) -> InputError:
        """Return the error for a file name in place of a view, and for options that it lacks."""
        texts = [f"{option}={value!r}" for option, value in options.items()]
        use = f"write draw({', '.join(texts)}).write({file!r})"
        if Path(file).suffix.lower() not in (*PICTURES, *TIKZ):
            use = f"write {self.package}.write_drawing({', '.join(['...', repr(file), *texts])})"
        try:
            self._check_options("view", view, [option for option in options if option != "ax"])
        except InputError as error:
            use += f"; but {error}"
        return InputError(f"the view is {shown(file)}; {use}")

    def _check_name(self, kind: str, name: object) -> None:
        known = self.entries(kind)
        if not isinstance(name, str):
            raise refusal(f"the {kind} is {shown(name)}", name, known)
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


def compose(
    figures: Iterable[Figure], columns: int = 2, titles: Sequence[str] | None = None
) -> Drawing:
    """Set figures beside each other, row by row, as panels of one figure with one legend.

    Panels keep their sizes; two of 88 mm fill a page of 180 mm. What all legends say is said once;
    what belongs to one panel, such as its captions, stands below it. Names of elements begin with
    the panel, as in ``panel-2-region-3``.

    Args:
        figures: that a view of either package has drawn.
        columns: how many panels stand side by side.
        titles: above the panels; if omitted, (a), (b), ...; empty texts for none.

    Raises:
        InputError: there are none, or others; bad columns or titles.
        MissingExtraError: matplotlib is absent.
    """
    scenes = [getattr(figure, "scene", None) for figure in figures]
    if not scenes or not all(isinstance(scene, Scene) for scene in scenes):
        raise InputError("compose takes figures that a view has drawn, without ax; give some")
    return drawing(panel_sheet([scene for scene in scenes if scene], columns, titles))
