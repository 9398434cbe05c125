"""The cone over an affine arrangement, one dimension down: points on a line, lines in the plane."""

from _plane import BLUE, GREY, ORANGE, dot, label, line, panels, save

POINTS = (-0.9, 0.2, 1.1)
LEFT, RIGHT, HIGH = -2.2, 2.2, 1.75


def make():
    figure, (axes,) = panels([(LEFT, RIGHT, -HIGH, HIGH)], scale=24)
    for x in POINTS:
        line(axes, (-HIGH * x, -HIGH), (HIGH * x, HIGH), lw=0.9)
    line(axes, (LEFT, 0), (RIGHT, 0), color=GREY, ls=(0, (5, 2)), lw=1.1)
    line(axes, (LEFT, 1), (RIGHT, 1), color=ORANGE, lw=1.8)
    for x in POINTS:
        dot(axes, x, 1, ORANGE, size=22)
    for number, x in enumerate((-1.75, -0.36, 0.65, 1.75), 1):
        label(axes, x, 1.17, str(number), ORANGE)
        scale = 0.62 if number in (1, 4) else 0.9
        label(axes, -scale * x, -scale, f"−{number}", BLUE)
    dot(axes, 0, 0, size=14)
    label(axes, RIGHT - 0.05, 0.87, "height 1", ORANGE, ha="right", fontsize=7)
    label(axes, RIGHT - 0.05, -0.12, "height 0, the added plane", GREY, ha="right", fontsize=7)
    return figure


save("cone-over-lines.svg", make)
