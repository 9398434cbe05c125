"""The great circles on the sphere, as a picture: regions coloured, hidden halves dashed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.planes import Arrangement

from .colours import DrawnRegion, Painter, painter, side_keys
from .globe import Floats, Globe
from .output import require_matplotlib

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_sphere(
    arrangement: Arrangement,
    *,
    direction: Sequence[object] | None = None,
    colour: str | Painter = "sides",
    width: float = 88.0,
) -> Figure:
    """Draw the great circles of central planes in R^3 as seen from a direction.

    A number at the limb names a circle: k for the k-th plane, counted from 1. Sign vectors stand
    where they fit. Every visible region and every arc, cut at the limb, is an element of its own
    with a name (``region-3``, ``front-7``, ``back-9``).

    Args:
        arrangement: central, in R^3, any rank.
        direction: exact, towards the viewer; left out, one in which no circle is edge-on.
        colour: "sides" (by number of sides), "signs" (by number of minus signs), "none", or a
            function from a `DrawnRegion` to a colour.
        width: of the figure, in millimetres.

    Raises:
        InputError: another space, planes off the origin, too many circles, unknown colouring.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    paint = painter(colour)
    globe = Globe(arrangement, direction)
    from matplotlib.figure import Figure

    height = width * (1.1 if colour == "sides" else 1.0)
    figure = Figure(figsize=(width / 25.4, height / 25.4))
    axes = figure.add_axes((0.0, 1 - width / height, 1.0, width / height))
    axes.set(xlim=(-1.17, 1.17), ylim=(-1.17, 1.17), aspect="equal")
    axes.set_axis_off()
    drawn = _regions(axes, globe, paint, width / 25.4 * 72 / 2.34)
    _arcs(axes, globe)
    _names(axes, globe)
    if colour == "sides":
        _legend(figure, drawn)
    return figure


def _curve(points: Floats, **style: Any) -> Any:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    codes = [Path.MOVETO] + [Path.CURVE4] * (len(points) - 1)
    return PathPatch(Path(points, codes), **style)


def _regions(axes: Any, globe: Globe, paint: Painter, scale: float) -> list[DrawnRegion]:
    """Fill the visible regions and write their sign vectors; `scale` is points per unit."""
    whole, drawn = globe.whole, []
    degrees = whole.incidence.region_degree.tolist()
    sides = {whole.region_signs(r): degrees[r] for r in range(whole.region_count)}
    for piece in range(globe.cut.region_count):
        *signs, front = globe.cut.region_signs(piece)
        if front < 0:
            continue
        region = DrawnRegion(tuple(signs), sides[tuple(signs)])
        outline = globe.outline(piece)
        fill = _curve(outline, facecolor=paint(region), edgecolor="none", gid=f"region-{piece}")
        axes.add_patch(fill)
        _signs(axes, region, outline, scale)
        drawn.append(region)
    return drawn


def _signs(axes: Any, region: DrawnRegion, outline: Floats, scale: float) -> None:
    """Write a sign vector into its region, in the largest size that fits, or not at all."""
    from matplotlib.path import Path

    t = np.linspace(0, 1, 24, endpoint=False)[:, None, None]
    p, q, r, end = outline[:-1:3], outline[1::3], outline[2::3], outline[3::3]
    curve = (1 - t) ** 3 * p + 3 * t * (1 - t) ** 2 * q + 3 * t**2 * (1 - t) * r + t**3 * end
    edge = curve.transpose(1, 0, 2).reshape(-1, 2)
    low, high = edge.min(axis=0), edge.max(axis=0)
    grid = np.stack(np.meshgrid(*np.linspace(low, high, 25).T), axis=-1).reshape(-1, 2)
    grid = grid[Path(edge).contains_points(grid)]
    text = "".join("+" if sign > 0 else "−" for sign in region.signs)
    for rows in (1, 2, 3):
        length = math.ceil(len(text) / rows)
        for size in (7.0, 6.0, 5.0):
            box = np.array([0.98 * length, 1.05 * rows]) * size / scale
            room = (np.abs(grid[:, None] - edge) / box).max(axis=2).min(axis=1, initial=9.0)
            if text and len(grid) and room.max() > 0.56:
                x, y = grid[int(np.argmax(np.round(room, 6)))]
                lines = ["\u200a".join(text[k : k + length]) for k in range(0, len(text), length)]
                axes.text(x, y, "\n".join(lines), size=size, ha="center", va="center_baseline",
                          linespacing=0.9, zorder=4)  # fmt: skip
                return


def _arcs(axes: Any, globe: Globe) -> None:
    circles = globe.cut.incidence.arc_circle.tolist()
    is_plane = len(globe.cut.arrangement.distinct[globe.limb]) > 1
    for arc, circle in enumerate(circles):
        if circle == globe.limb:
            style: dict[str, Any] = {"lw": 1.4 if is_plane else 0.6, "zorder": 3}
            name = "limb"
        elif globe.cut.arc_signs(arc)[-1] > 0:
            style, name = {"lw": 1.0, "zorder": 3}, "front"
        else:
            style = {"lw": 0.45, "ls": (0, (3, 3)), "zorder": 2, "alpha": 0.45}
            name = "back"
        axes.add_patch(_curve(globe.arc(arc), fill=False, ec="black", gid=f"{name}-{arc}", **style))


def _names(axes: Any, globe: Globe) -> None:
    """Write the numbers of the planes outside the limb, pushed apart along it."""
    wanted: list[tuple[float, float, str]] = []
    for circle, members in enumerate(globe.cut.arrangement.distinct):
        text = ",".join(str(k + 1) for k in members if k < len(globe.whole.arrangement))
        if not text:
            continue
        x, y, _ = globe.normals[circle]
        angle = 0.25 if circle == globe.limb else math.atan2(x, -y)
        both = [angle % (2 * math.pi), (angle + math.pi) % (2 * math.pi)]
        gap = [min((abs(_turn(a - b)) for b, _, _ in wanted), default=4.0) for a in both]
        best = both[0] if gap[0] >= gap[1] - 1e-9 else both[1]
        wanted.append((best, best, text))
    placed = _apart([angle for angle, _, _ in wanted])
    for (angle, _, text), at in zip(wanted, placed, strict=True):
        ends = np.array([[math.cos(angle), math.sin(angle)], [math.cos(at), math.sin(at)]])
        ends *= [[1.0], [1.055]]
        axes.plot(*ends.T, color="black", lw=0.4)
        axes.text(1.1 * math.cos(at), 1.1 * math.sin(at), text, ha="center", va="center")


def _turn(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def _apart(angles: list[float], least: float = 0.11) -> list[float]:
    placed = list(angles)
    for _ in range(200):
        for i in range(len(placed)):
            for j in range(i):
                gap = _turn(placed[i] - placed[j])
                if abs(gap) < least:
                    push = (least - abs(gap)) / 2 * (1 if gap >= 0 else -1)
                    placed[i] += push
                    placed[j] -= push
    return placed


def _legend(figure: Any, drawn: list[DrawnRegion]) -> None:
    keys = side_keys(drawn)
    if keys:
        figure.legend(handles=keys, loc="lower center", ncols=min(4, len(keys)), frameon=False,
                      fontsize=7, handlelength=1.2, handleheight=1.0)  # fmt: skip
