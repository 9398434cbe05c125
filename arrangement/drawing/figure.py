"""Scenes as matplotlib figures: the one writer behind SVG, PDF and PNG; it knows no view."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from itertools import groupby
from typing import TYPE_CHECKING, Any, ParamSpec

import numpy as np

from .output import require_matplotlib
from .scene.items import SHADES, Ball, Item, Label, Mark, Path
from .scene.layout import laid_out
from .scene.scene import DPI, Scene, checked_width

if TYPE_CHECKING:
    from matplotlib.figure import Figure

P = ParamSpec("P")
#: Size of the image of a ball.
_PIXELS = 256


#: What holds for every view: said once, and added to the docstrings.
_WIDTH = "    width: of the figure, in millimetres.\n"
_ABSENT = "    MissingExtraError: matplotlib is absent.\n"


def picture(least: float = 40.0) -> Callable[[Callable[P, Scene]], Callable[P, Figure]]:
    """Return a decorator: a view draws its scene, with its legend, as a matplotlib figure.

    The scene stays within reach, for other writers: ``draw_sphere.scene``. Every view has a width,
    which is checked here.

    Args:
        least: the least width, in millimetres.
    """

    def decorate(view: Callable[P, Scene]) -> Callable[P, Figure]:
        @functools.wraps(view)
        def scene(*args: P.args, **options: P.kwargs) -> Scene:
            if "width" in options:
                options["width"] = checked_width(options["width"], least)
            return view(*args, **options)

        @functools.wraps(view)
        def draw(*args: P.args, **options: P.kwargs) -> Figure:
            return figure(laid_out(scene(*args, **options)))

        told = inspect.cleandoc(view.__doc__ or "")  # Python 3.13 takes the indent away itself
        if "    width:" not in told:
            told = told.replace("\nRaises:", f"{_WIDTH}\nRaises:")
        draw.__doc__ = f"{told}\n{_ABSENT}"
        draw.__annotations__ = {**view.__annotations__, "return": "Figure"}
        draw.scene = scene  # type: ignore[attr-defined]
        return draw

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
    axes.set(xlim=(0, scene.width), ylim=(0, scene.height))
    axes.set_axis_off()
    runs = groupby(sorted(scene.items, key=lambda item: item.height), key=type)
    for k, (_, items) in enumerate(runs):
        paths = []
        for item in items:
            if isinstance(item, Path):
                paths.append(item)
            else:
                _draw(axes, item, {**item.style, "zorder": k})
        axes.add_artist(Paths(paths)).set_zorder(k)
    return made


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
