"""What the sketches of planar grasps share: axes in true proportion, arrows, labels, colours."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from arrangement.pictures import save_figure

BLUE, ORANGE, GREEN, GREY, PALE = "#0072b2", "#d55e00", "#00735a", "#767676", "#eeeae2"
MM = 1 / 25.4


def save(name: str, make: Callable[[], Any]) -> None:
    """Write a figure into the folder that the build makes, the same bytes each time."""
    save_figure(name, make)


def panels(
    windows: Sequence[tuple[float, float, float, float]],
    *,
    scale: float,
    titles: Iterable[str] = (),
) -> tuple[Any, list[Any]]:
    """Return a figure and its axes, one for each window (left, right, bottom, top).

    `scale` is millimetres for a unit of length, the same in all panels.
    """
    from matplotlib.figure import Figure

    gap, head = 6.0, 5.0 if titles else 0.0
    widths = [(right - left) * scale for left, right, _, _ in windows]
    heights = [(top - bottom) * scale for _, _, bottom, top in windows]
    total, high = sum(widths) + gap * (len(windows) - 1), max(heights)
    figure = Figure(figsize=(total * MM, (high + head) * MM))
    found, at = [], 0.0
    for (left, right, bottom, top), width, height in zip(windows, widths, heights, strict=True):
        low = (high - height) / 2
        box = (at / total, low / (high + head), width / total, height / (high + head))
        axes = figure.add_axes(box)
        axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
        axes.set_axis_off()
        found.append(axes)
        at += width + gap
    for axes, title in zip(found, titles, strict=False):
        axes.set_title(title, fontsize=8, pad=3)
    return figure, found


def arrow(
    axes: Any, start: Sequence[float], vector: Sequence[float], colour: str, **more: Any
) -> None:
    """Draw an arrow."""
    end = (start[0] + vector[0], start[1] + vector[1])
    style = {
        "arrowstyle": "-|>,head_width=0.22,head_length=0.5",
        "lw": 1.4,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    axes.annotate(
        "", xy=end, xytext=tuple(start), zorder=6, arrowprops={**style, "color": colour, **more}
    )


def label(axes: Any, x: float, y: float, text: str, colour: str = "black", **more: Any) -> None:
    """Write a text in the middle of a point."""
    style = {"ha": "center", "va": "center", "fontsize": 8, "zorder": 8}
    axes.text(x, y, text, color=colour, **{**style, **more})


def body(axes: Any, corners: Sequence[Sequence[float]]) -> None:
    """Fill the object."""
    from matplotlib.patches import Polygon

    axes.add_patch(
        Polygon(corners, closed=True, facecolor=PALE, edgecolor="black", lw=1.0, zorder=1)
    )


def dot(axes: Any, x: float, y: float, colour: str = "black", size: float = 9) -> None:
    """Draw a point."""
    axes.scatter([x], [y], s=size, color=colour, zorder=7, linewidths=0)


def line(axes: Any, start: Sequence[float], end: Sequence[float], **more: Any) -> None:
    """Draw a straight line."""
    style = {"color": "black", "lw": 0.8, "zorder": 3}
    axes.plot([start[0], end[0]], [start[1], end[1]], **{**style, **more})
