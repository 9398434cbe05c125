"""A curve that separates a ray from its opposite crosses every half plane between the two."""

from math import cos, pi, sin

from _plane import BLUE, GREY, ORANGE, dot, label, line, panels, save

K = 3
TURN = pi / 12


def panel(axes, radius, colour, title, size):
    for j in range(2 * K):
        angle = TURN + j * pi / K
        line(axes, (0, 0), (1.5 * cos(angle), 1.5 * sin(angle)), lw=0.9)
    angles = [2 * pi * n / 360 for n in range(361)]
    curve = [(radius(a) * cos(a), radius(a) * sin(a)) for a in angles]
    axes.fill(*zip(*curve, strict=True), color=colour, alpha=0.12, lw=0, zorder=2)
    axes.plot(*zip(*curve, strict=True), color=colour, lw=1.6, zorder=4)
    for j in range(2 * K):
        angle = TURN + j * pi / K
        dot(axes, radius(angle) * cos(angle), radius(angle) * sin(angle), colour, size=16)
    dot(axes, 0, 0, size=16)
    label(axes, 0.02, -0.16 - 0.002 * size, "$r$", fontsize=size)
    label(axes, 1.3, -1.3, "$-r$ far out", GREY, fontsize=size - 1, ha="right")
    if size > 8:
        label(axes, 0, 1.52, title, fontsize=size)
    else:
        axes.set_title(title, size=size, pad=3)


def make(size=8, scale=20):
    top = 1.35 + (0.3 if size > 8 else 0)
    window = (-1.35, 1.35, -1.4, top)
    figure, (left, right) = panels([window] * 2, scale=scale, titles=["", ""])
    panel(left, lambda a: 0.45, BLUE, "the face of r: 2k crossings", size)
    panel(
        right,
        lambda a: 0.85 + 0.25 * sin(2 * a) - 0.13 * cos(5 * a),
        ORANGE,
        "another cycle: at least 2k",
        size,
    )
    return figure


save("half-planes.svg", make)
save("half-planes-slide.svg", lambda: make(20, 44))
