"""The figures of the second lecture's slides: one each, with letters of 18 points or more."""

from itertools import pairwise

from _disc import disc
from _plane import BLUE, GREEN, GREY, ORANGE, arrow, label, line, panels, save

from equilibrium import read_grasp
from equilibrium.pictures import write_drawing

BIG = {"fontsize": 20}
LOOK = {"legend": "none", "font_size": 20, "width": 174}
LIMIT = 2.6
SQUEEZED = read_grasp("paper-three-contacts-preload-1")


def cells(axes, preload):
    """Fill the cells of the motions without rotation by how many of three contacts press."""
    for left, right in pairwise(sorted({-2.2, -preload, 0.0, preload, 2.2})):
        for low, high in pairwise(sorted({-2.2, 0.0, preload, 2.2})):
            x, y = (left + right) / 2, (low + high) / 2
            pressing = (x <= preload) + (-x <= preload) + (y <= preload)
            shade = ("#ffffff", "#fdf0c0", "#b9dfd3", "#7fb9d8")[pressing]
            axes.fill([left, right, right, left], [low, low, high, high], shade, lw=0)
    line(axes, (-2.2, 0), (2.2, 0), lw=2)
    line(axes, (0, -2.2), (0, 2.2), lw=2)
    dashed = {"color": ORANGE, "lw": 2.5, "ls": (0, (5, 2))}
    for x in {preload, -preload}:
        line(axes, (x, -2.2), (x, 2.2), **dashed)
    line(axes, (-2.2, preload), (2.2, preload), **dashed)


def preload():
    figure, axes = panels([(-2.3, 2.3, -2.3, 2.7)] * 2, scale=24)
    for part, size, text in zip(axes, (0, 1), ("preload 0", "preload 1"), strict=True):
        cells(part, float(size))
        label(part, 0, 2.5, text, **BIG)
    return figure


def farkas():
    figure, (axes,) = panels([(-0.5, 2.9, -0.5, 2.8)], scale=48)
    arrow(axes, (-0.3, 0), (LIMIT + 0.35, 0), GREY, lw=1)
    arrow(axes, (0, -0.3), (0, LIMIT + 0.35), GREY, lw=1)
    for corners, colour in (
        ([(1, -0.3), (LIMIT, -0.3), (LIMIT, LIMIT), (1, LIMIT)], BLUE),
        ([(-0.3, 1), (LIMIT, 1), (LIMIT, LIMIT), (-0.3, LIMIT)], GREEN),
        ([(-0.3, -0.3), (1.3, -0.3), (-0.3, 1.3)], ORANGE),
    ):
        axes.fill(*zip(*corners, strict=True), color=colour, alpha=0.2, lw=0, zorder=1)
    line(axes, (1, -0.3), (1, LIMIT), color=BLUE, lw=2)
    line(axes, (-0.3, 1), (LIMIT, 1), color=GREEN, lw=2)
    line(axes, (1.3, -0.3), (-0.3, 1.3), color=ORANGE, lw=2)
    label(axes, 1.75, 2.35, "$x \\geq 1$", BLUE, **BIG)
    label(axes, 1.95, 1.25, "$y \\geq 1$", GREEN, **BIG)
    label(axes, 0.62, -0.2, "$x + y \\leq 1$", ORANGE, **BIG)
    return figure


def cases():
    figure, axes = panels([(-1.8, 1.8, -1.65, 1.95)] * 2, scale=34)
    for part, x in zip(axes, (-1, 1), strict=True):
        sign = "\\geq" if x < 0 else "\\leq"
        disc(part, (0.15 * x, 0.3), f"$x {sign} 0$: moves along $({x}, 2, 0)$")
    return figure


for make in (preload, farkas, cases):
    save(f"lecture-2-{make.__name__}.svg", make)
write_drawing(
    read_grasp("offset-three-contacts"), "lecture-2-state.svg", "grasp",
    wrench=("3/4", "1/2", "3/2"), outline=[(-1, -1), (1, -1), (1, 1), (-1, 1)], **LOOK,
)  # fmt: skip
write_drawing(read_grasp("unchecked-cell"), "lecture-2-cell.svg", "grasp", wrench=(2, 0, 2), **LOOK)
write_drawing(SQUEEZED, "lecture-2-lets-go.svg", "grasp", wrench=(0, 1, 0), **LOOK)
write_drawing(read_grasp("interrupted-push"), "lecture-2-again.svg", "resist", **LOOK)
