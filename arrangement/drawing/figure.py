"""Scenes as matplotlib figures: the one writer behind SVG, PDF and PNG; it knows no view."""

from __future__ import annotations

import functools
import inspect
import operator
from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import groupby
from typing import TYPE_CHECKING, Any, ParamSpec, Protocol, TypeAlias, overload

import numpy as np

from .output import require_matplotlib
from .scene.items import SHADES, Ball, Item, Label, Mark, Path
from .scene.layout import laid_out
from .scene.scene import DPI, NarrowError, Scene, checked_width

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure

    Place: TypeAlias = Axes | Figure | SubFigure

P = ParamSpec("P")
#: In millimetres: in narrower axes letters and lines are smaller.
_NARROW = 70.0
#: Size of the image of a ball.
_PIXELS = 256


#: What holds for every view: said once, and added to the docstrings.
_WIDTH = "    width: of the figure, in millimetres.\n"
_AX = """    ax: axes, a figure or subfigure of matplotlib to draw into. The picture takes the room
        that is there and has no legend; each element is an artist with its name as ``gid``.
"""
_ABSENT = "    MissingExtraError: matplotlib is absent.\n"


class DrawingView(Protocol[P]):
    """A view as a function: it returns the figure in which it has drawn."""

    scene: Callable[..., Scene]

    @overload
    def __call__(self, *args: P.args, **options: P.kwargs) -> Figure: ...
    @overload
    def __call__(self, subject: Any, /, *, ax: Place, **options: Any) -> Figure: ...


def picture(least: float = 40.0) -> Callable[[Callable[P, Scene]], DrawingView[P]]:
    """Return a decorator: a view draws its scene, with its legend, as a matplotlib figure.

    The scene stays within reach, for other writers: ``draw_sphere.scene``. Every view has a width,
    which is checked here.

    Args:
        least: the least width, in millimetres.
    """

    def decorate(view: Callable[P, Scene]) -> DrawingView[P]:
        @functools.wraps(view)
        def scene(*args: P.args, **options: P.kwargs) -> Scene:
            if "width" in options:
                options["width"] = checked_width(options["width"], least)
            return view(*args, **options)

        @functools.wraps(view)
        def draw(*args: Any, ax: Place | None = None, **options: Any) -> Figure:
            if ax is None:
                return figure(laid_out(scene(*args, **options)))
            return into(
                ax, lambda width: laid_out(scene(*args, **{"width": width, **options}), "none")
            )

        told = inspect.cleandoc(view.__doc__ or "")  # Python 3.13 takes the indent away itself
        if "    width:" not in told:
            told = told.replace("\nRaises:", f"{_WIDTH}\nRaises:")
        told = told.replace("\nRaises:", f"{_AX}\nRaises:")
        draw.__doc__ = f"{told}\n{_ABSENT}"
        draw.__annotations__ = {**view.__annotations__, "return": "Figure"}
        draw.scene = scene  # type: ignore[attr-defined]
        made: Any = draw
        return made  # type: ignore[no-any-return]

    return decorate


def figure(scene: Scene) -> Figure:
    """Return a scene as a figure with one coordinate system, that of the scene.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    from matplotlib.figure import Figure

    from .path_artist import Paths

    width, height = scene.paper
    made = Figure(figsize=(width / 25.4, height / 25.4), dpi=DPI)
    axes: Any = made.add_axes((0.0, 0.0, 1.0, 1.0))
    _set_up(axes, scene)
    for k, items in _runs(scene):
        paths = []
        for item in items:
            if isinstance(item, Path):
                paths.append(item)
            else:
                _draw(axes, item, {**item.style, "zorder": k})
        axes.add_artist(Paths(paths)).set_zorder(k)
    return made


def into(place: Place, make: Callable[[float], Scene]) -> Figure:
    """Draw into axes, or into new ones that fill a figure; every element is an artist of its own.

    Args:
        place: where to; what is there stays.
        make: returns the scene for a width in millimetres. It is asked for one as wide as the
            axes, or narrower where that one would be too high, but for none that is too narrow
            for its letters: these, and lines, are made smaller then.

    Returns:
        The figure of the axes.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    from matplotlib.figure import FigureBase

    from .path_artist import patch

    axes: Any = place.add_axes((0.0, 0.0, 1.0, 1.0)) if isinstance(place, FigureBase) else place
    owner = axes.figure
    while hasattr(owner, "_parent"):  # of a subfigure, whose size is its own
        owner = owner._parent
    box = axes.get_window_extent()
    room = [25.4 * length / owner.dpi for length in (box.width, box.height)]
    width, scene = max(room[0], _NARROW), None
    while scene is None:
        try:
            scene = make(width)
        except NarrowError:
            width *= 1.2
    for _ in range(3):
        if scene.paper[1] > room[1]:
            width = max(width * room[1] / scene.paper[1], _NARROW)
            with suppress(NarrowError):
                scene = make(width)
    scene = scene.scaled(min(1.0, *map(operator.truediv, room, scene.paper)))
    _set_up(axes, scene)
    for k, items in _runs(scene):
        for item in items:
            if isinstance(item, Path):
                axes.add_patch(patch(item, axes)).set_zorder(k)
            else:
                _draw(axes, item, {**item.style, "zorder": k})
    axes.set_aspect("equal")  # an image has changed it
    return owner  # type: ignore[no-any-return]


def _set_up(axes: Any, scene: Scene) -> None:
    axes.set(xlim=(0, scene.width), ylim=(0, scene.height))
    axes.set_axis_off()


def _runs(scene: Scene) -> Iterator[tuple[int, Iterator[Item]]]:
    """Yield runs of items of one kind, from below, with their heights."""
    runs = groupby(sorted(scene.items, key=lambda item: item.height), key=type)
    for k, (_, items) in enumerate(runs):
        yield k, items


def _draw(axes: Any, item: Item, style: dict[str, Any]) -> None:
    if item.name:
        style["gid"] = item.name
    if isinstance(item, Label):
        _write(axes, item, style)
    elif isinstance(item, Mark):
        axes.plot(
            *([x] for x in item.place), item.sign, ms=item.size, ls="none", clip_on=False, **style
        )
    elif isinstance(item, Ball):
        _shade(axes, item, style)


def _shade(axes: Any, item: Ball, style: dict[str, Any]) -> None:
    """Add a ball as a small image under its disc; neighbouring pixels differ by one shade."""
    from matplotlib.colors import to_rgba
    from matplotlib.patches import Circle

    middle = (np.arange(_PIXELS) + 0.5) / _PIXELS * 2 - 1
    x, y = np.meshgrid(middle, middle)
    fx, fy = item.focus
    # The circle of size t has its centre at (1 - t) focus: |p - (1 - t) f| = t.
    px, py, rest = x - fx, y - fy, 1 - fx * fx - fy * fy
    along = px * fx + py * fy
    size = (along + np.sqrt(along**2 + rest * (px**2 + py**2))) / rest
    sizes, shares = np.array(SHADES).T
    share = np.interp(size, sizes, shares)[..., None]
    near, far = (np.array(to_rgba(colour)) for colour in (item.near, item.far))
    (cx, cy), r = item.centre, item.radius
    image = axes.imshow(
        near + share * (far - near),
        extent=(cx - r, cx + r, cy - r, cy + r),
        origin="lower",
        aspect="auto",
        interpolation="none",
        **style,
    )
    image.set_clip_path(Circle(item.centre, r, transform=axes.transData))


def _write(axes: Any, item: Label, style: dict[str, Any]) -> None:
    from matplotlib.patheffects import Normal, Stroke

    halo, plate = style.pop("halo", None), style.pop("plate", None)
    if plate is not None:
        style["bbox"] = plate
    place = {"size": item.size, "ha": item.ha, "va": item.va, "rotation": item.rotation}
    effects: list[Any] = [] if halo is None else [Stroke(linewidth=halo[0], foreground=halo[1])]
    if effects and require_matplotlib().rcParams["svg.fonttype"] == "none":
        # What has an effect becomes outlines; the letters on it stay letters.
        axes.text(*item.place, item.text, **place, linespacing=1.0, path_effects=effects, **style)
        effects = []
    effects = [*effects, Normal()] if effects else effects
    axes.text(*item.place, item.text, **place, linespacing=1.0, path_effects=effects, **style)
