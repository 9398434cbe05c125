"""Scenes as matplotlib figures: the one writer behind SVG, PDF and PNG; it knows no view."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ParamSpec

from .output import require_matplotlib
from .scene import DPI, Item, Label, Mark, Path, Scene

if TYPE_CHECKING:
    from matplotlib.figure import Figure

P = ParamSpec("P")
_HATCH = {"hatch.linewidth": 0.35}


def picture(view: Callable[P, Scene]) -> Callable[P, Figure]:
    """Return a view as a function that draws its scene as a matplotlib figure.

    The view itself stays within reach, for other writers: ``inspect.unwrap(draw_sphere)``.
    """

    @functools.wraps(view)
    def draw(*args: P.args, **options: P.kwargs) -> Figure:
        return figure(view(*args, **options))

    draw.__annotations__ = {**view.__annotations__, "return": "Figure"}
    return draw


def figure(scene: Scene) -> Figure:
    """Return a scene as a figure with one coordinate system, that of the scene.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    mpl = require_matplotlib()
    from matplotlib.figure import Figure

    width, height = scene.paper
    made = Figure(figsize=(width / 25.4, height / 25.4), dpi=DPI)
    axes: Any = made.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0, scene.width), ylim=(0, scene.height))
    axes.set_axis_off()
    with mpl.rc_context(_HATCH):
        for item in scene.items:
            _draw(axes, item)
    return made


def _draw(axes: Any, item: Item) -> None:
    style: dict[str, Any] = dict(item.style)
    if item.order is not None:
        style["zorder"] = item.order
    if item.name:
        style["gid"] = item.name
    if isinstance(item, Label):
        _write(axes, item, style)
        return
    if isinstance(item, Mark):
        (artist,) = axes.plot(
            *([x] for x in item.place), item.sign, ms=item.size, ls="none", clip_on=False, **style
        )
    elif isinstance(item, Path):
        artist = axes.add_artist(_patch(item, style))
    _clip(axes, artist, item)


def _patch(item: Path, style: dict[str, Any]) -> Any:
    from matplotlib import patches, path

    if item.kind == "circle":
        x, y = item.points.tolist()
        return patches.Circle((x, y), item.radius, **style)
    if item.kind == "polygon":
        return patches.Polygon(item.points, closed=True, **style)
    if item.kind == "line":
        return patches.PathPatch(path.Path(item.points), fill=False, **style)
    codes = [path.Path.MOVETO] + [path.Path.CURVE4] * (len(item.points) - 1)
    return patches.PathPatch(path.Path(item.points, codes), **style)


def _write(axes: Any, item: Label, style: dict[str, Any]) -> None:
    from matplotlib.patheffects import withStroke

    halo, plate = style.pop("halo", None), style.pop("plate", None)
    if halo is not None:
        style["path_effects"] = [withStroke(linewidth=halo[0], foreground=halo[1])]
    if plate is not None:
        style["bbox"] = plate
    axes.text(
        *item.place, item.text, size=item.size, ha=item.ha, va=item.va, rotation=item.rotation,
        linespacing=1.0, **style,
    )  # fmt: skip


def _clip(axes: Any, artist: Any, item: Item) -> None:
    from matplotlib.patches import Circle, Rectangle

    if item.clip is None:
        return
    if len(item.clip) == 2:
        (x, y), radius = item.clip
        shape: Any = Circle((x, y), radius, transform=axes.transData)
    else:
        left, low, right, high = item.clip
        shape = Rectangle((left, low), right - left, high - low, transform=axes.transData)
    artist.set_clip_path(shape)
