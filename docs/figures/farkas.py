"""Three half-planes without a common point, and two with one: what a Farkas combination says."""

from _plane import BLUE, GREEN, GREY, ORANGE, arrow, label, line, panels, save

LIMIT = 2.6


def half_plane(axes, corners, colour):
    axes.fill(*zip(*corners, strict=True), color=colour, alpha=0.18, lw=0, zorder=1)


def make():
    window = (-0.45, LIMIT + 0.2, -0.45, LIMIT + 0.2)
    figure, (axes,) = panels([window], scale=24)
    arrow(axes, (-0.3, 0), (LIMIT + 0.35, 0), GREY, lw=0.8)
    arrow(axes, (0, -0.3), (0, LIMIT + 0.35), GREY, lw=0.8)
    label(axes, LIMIT + 0.1, -0.15, "$x$", GREY)
    label(axes, -0.15, LIMIT + 0.1, "$y$", GREY)
    half_plane(axes, [(1, -0.3), (LIMIT, -0.3), (LIMIT, LIMIT), (1, LIMIT)], BLUE)
    half_plane(axes, [(-0.3, 1), (LIMIT, 1), (LIMIT, LIMIT), (-0.3, LIMIT)], GREEN)
    half_plane(axes, [(-0.3, -0.3), (1.3, -0.3), (-0.3, 1.3)], ORANGE)
    line(axes, (1, -0.3), (1, LIMIT), color=BLUE, lw=1.2)
    line(axes, (-0.3, 1), (LIMIT, 1), color=GREEN, lw=1.2)
    line(axes, (1.3, -0.3), (-0.3, 1.3), color=ORANGE, lw=1.2)
    arrow(axes, (1, 2.2), (0.4, 0), BLUE)
    arrow(axes, (2.2, 1), (0, 0.4), GREEN)
    arrow(axes, (0.5, 0.5), (-0.3, -0.3), ORANGE)
    label(axes, 1.75, 2.42, "$x - 1 \\geq 0$", BLUE)
    label(axes, 1.62, 1.18, "$y - 1 \\geq 0$", GREEN)
    label(axes, 0.52, -0.16, "$1 - x - y \\geq 0$", ORANGE)
    return figure


save("farkas.svg", make)
