"""The paths of a scene as one artist of matplotlib, which is imported with this module.

A `Patch` for each path, with its own transforms and callbacks, takes most of the time of a picture.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from .output import require_matplotlib
from .scene.items import Box, Path, Place

try:
    from matplotlib.artist import Artist
    from matplotlib.colors import to_rgba
    from matplotlib.patches import Circle, PathPatch, Rectangle
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


def patch(item: Path, axes: Any) -> PathPatch:
    """Return a path as an artist of its own, for who wants to change it."""
    style = dict(item.style)
    filled = item.kind != "line" and style.pop("fill", True)
    style.setdefault("ec", "none" if filled else "black")
    made = PathPatch(_outline(item), fill=filled, gid=item.name or None, **style)
    made.set_transform(axes.transData)
    if item.clip is not None and len(item.clip) == 2:
        (x, y), radius = item.clip
        made.set_clip_path(Circle((x, y), radius, transform=axes.transData))
    elif item.clip is not None:
        left, low, right, high = item.clip
        box = Rectangle((left, low), right - left, high - low, transform=axes.transData)
        made.set_clip_path(box)
    return made
