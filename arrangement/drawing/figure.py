"""A scene as a figure of matplotlib.

A `Patch` for each path, with its own transforms and callbacks, takes most of the time of a picture.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from itertools import groupby
from typing import TYPE_CHECKING, Any, ParamSpec

import numpy as np

from .output import require_matplotlib
from .scene.items import SHADES, Ball, Box, Item, Label, Mark, Path, Place
from .scene.layout import laid_out
from .scene.measuring import DPI
from .scene.scene import Scene

if TYPE_CHECKING:
    from matplotlib.figure import Figure


try:
    from matplotlib.artist import Artist
    from matplotlib.colors import to_rgba
    from matplotlib.path import Path as Outline
    from matplotlib.transforms import Affine2D, Bbox, TransformedPath
except ImportError:
    require_matplotlib()  # says which extra brings it
    raise

_HATCH_WIDTH = 0.35


class Paths(Artist):
    """Paths, painted in their order; each is a group with its name, as a patch would be.

    Attributes:
        items: the paths.
    """

    def __init__(self, items: Iterable[Path]) -> None:
        super().__init__()
        self.items = tuple(items)

    def draw(self, renderer: Any) -> None:
        """Draw all paths, each cut to its clip, or to the sheet."""
        assert self.axes is not None
        affine = Affine2D(self.axes.transData.get_matrix())
        sheet = self.axes.bbox.frozen()
        styles: dict[tuple[str, ...], tuple[Any, tuple[float, ...] | None]] = {}
        for item in self.items:
            renderer.open_group("patch", item.name or None)
            # Thousands of paths have few styles.
            style = (str(item.kind == "line"), repr(item.style), repr(item.clip))
            if style not in styles:
                context = renderer.new_gc()
                styles[style] = (context, _set_up(context, item))
                context.set_clip_rectangle(sheet)
                if item.clip is not None:
                    _cut(context, item.clip, affine)
            context, face = styles[style]
            renderer.draw_path(context, _outline(item), affine, face)
            renderer.close_group("patch")
        for context, _ in styles.values():
            context.restore()


def _set_up(context: Any, item: Path) -> tuple[float, ...] | None:
    """Give the style of a path to a graphics context; return the colour inside, if any."""
    style = item.style
    alpha, filled = style.get("alpha"), item.kind != "line" and style.get("fill", True)
    edge = to_rgba(style.get("ec", "none" if filled else "black"), alpha)
    width = style.get("lw", 1.0) if edge[3] else 0
    context.set_alpha(alpha)
    context.set_foreground(edge, isRGBA=True)
    context.set_linewidth(width)
    context.set_capstyle(style.get("capstyle", "butt"))
    context.set_joinstyle(style.get("joinstyle", "miter"))
    if width and isinstance(dashes := style.get("ls"), tuple):
        context.set_dashes(dashes[0] * width, [x * width for x in dashes[1]])
    if hatch := style.get("hatch"):
        context.set_hatch(hatch)
        context.set_hatch_color(edge if edge[3] else "black")
        context.set_hatch_linewidth(_HATCH_WIDTH)
    face = to_rgba(style.get("fc", "none"), alpha) if filled else None
    # With a face that lets all through, renderers leave out the hatches.
    return face if face and face[3] else None


def _outline(item: Path) -> Outline:
    points = item.points
    if item.kind == "circle":
        x, y = points.tolist()
        return Outline.circle((x, y), item.radius)
    if item.kind == "polygon":
        return Outline(np.concatenate([points, points[:1]]), closed=True)
    if item.kind == "line":
        return Outline(points)
    return Outline(points, [Outline.MOVETO] + [Outline.CURVE4] * (len(points) - 1))


def _cut(context: Any, clip: Box | tuple[Place, float], affine: Affine2D) -> None:
    if len(clip) == 2:
        (x, y), radius = clip
        context.set_clip_path(TransformedPath(Outline.circle((x, y), radius), affine))
    else:
        left, low, right, high = clip
        context.set_clip_rectangle(Bbox([[left, low], [right, high]]).transformed(affine))


P = ParamSpec("P")
#: Size of the image of a ball.
_PIXELS = 256


def picture(view: Callable[P, Scene]) -> Callable[P, Figure]:
    """Return a view as a function that draws its scene, with its legend, as a matplotlib figure.

    The view itself stays within reach, for other writers: ``draw_sphere.scene``.
    """

    @functools.wraps(view)
    def draw(*args: P.args, **options: P.kwargs) -> Figure:
        return figure(laid_out(view(*args, **options)))

    draw.__annotations__ = {**view.__annotations__, "return": "Figure"}
    draw.scene = view  # type: ignore[attr-defined]
    return draw


def figure(scene: Scene) -> Figure:
    """Return a scene as a figure with one coordinate system, that of the scene.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    from matplotlib.figure import Figure

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
