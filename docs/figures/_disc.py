"""The disc with three fingers of the slides, moved along a virtual motion."""

from math import cos, pi, sin

from _plane import BLUE, GREY, ORANGE, arrow, dot, label

_TURNS = [2 * pi * k / 120 for k in range(121)]


def disc(axes, shift, text):
    """Draw the disc, a load upwards, and where a shift takes the disc; write a text above."""
    for (x, y), style in (((0, 0), {"color": "black"}), (shift, {"color": BLUE, "ls": ":"})):
        axes.plot([x + cos(a) for a in _TURNS], [y + sin(a) for a in _TURNS], lw=2.5, **style)
    for x, y in ((-1, 0), (0, -1), (1, 0)):
        arrow(axes, (1.55 * x, 1.55 * y), (-0.5 * x, -0.5 * y), GREY, lw=2)
        dot(axes, x, y, size=60)
    arrow(axes, (0, 0), (0, 0.75), ORANGE, lw=3.5)
    label(axes, 0.24, 0.45, "$w$", ORANGE, fontsize=22)
    label(axes, 0, 1.75, text, BLUE, fontsize=22)
