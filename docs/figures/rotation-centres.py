"""Where the centre of a rotation lies decides how each contact slips."""

from _plane import BLUE, GREEN, GREY, ORANGE, arrow, body, dot, label, line, panels, save

CORNERS = [(-1.3, -1.0), (1.5, -1.0), (0.1, 1.2)]


def contacts():
    """Yield the middle of each side and the unit normal that points inward."""
    for k, (x, y) in enumerate(CORNERS):
        u, v = CORNERS[(k + 1) % 3]
        length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
        yield ((x + u) / 2, (y + v) / 2), ((y - v) / length, (u - x) / length)


def one_contact(axes):
    body(axes, [(-1, -1), (1, -1), (1, 1), (-1, 1)])
    line(axes, (-1, -1.9), (-1, 1.9), color=ORANGE, ls=(0, (4, 2)))
    label(axes, -1.42, 1.7, "tangent line", ORANGE, fontsize=7)
    p = (-1, 0.3)
    dot(axes, *p)
    label(axes, -0.83, 0.45, "$p$")
    arrow(axes, p, (0.6, 0), BLUE)
    label(axes, -0.5, 0.12, "$n$", BLUE)
    for centre, name, place in (
        ((-1, -1.5), "$c$: sticks", (-0.42, -1.5)),
        ((-2.3, -0.6), "$c'$: slip+", (-2.25, -0.85)),
        ((0.45, -0.4), "$c''$: slip−", (0.45, -0.65)),
    ):
        line(axes, centre, p, color=GREY, lw=0.6, ls=(0, (1, 2)))
        speed = (-(p[1] - centre[1]), p[0] - centre[0])
        size = (speed[0] ** 2 + speed[1] ** 2) ** 0.5
        arrow(axes, p, (0.85 * speed[0] / size, 0.85 * speed[1] / size), GREEN, lw=1.1)
        dot(axes, *centre, GREEN, 14)
        label(axes, *place, name, GREEN, fontsize=7)


def three_contacts(axes):
    body(axes, CORNERS)
    for k, (p, n) in enumerate(contacts()):
        t = (-n[1], n[0])
        ends = [(p[0] + s * t[0], p[1] + s * t[1]) for s in (-4, 4)]
        line(axes, *ends, color=ORANGE, ls=(0, (4, 2)))
        dot(axes, *p)
        arrow(axes, p, (0.33 * n[0], 0.33 * n[1]), BLUE, lw=1.1)
        label(axes, p[0] - 0.18 * n[0], p[1] - 0.18 * n[1], str(k + 1), fontsize=7)
    for x, y in [(0.1, -0.25), (0.1, -1.55), (1.5, 0.5), (-1.35, 0.5), (0.1, 1.65),
                 (-2.0, -1.3), (2.15, -1.3)]:  # fmt: skip
        signs = (n[0] * (p[0] - x) + n[1] * (p[1] - y) for p, n in contacts())
        label(axes, x, y, "".join("+" if s > 0 else "−" for s in signs), fontsize=9)


def make():
    figure, (left, right) = panels(
        [(-2.75, 1.2, -1.9, 1.9), (-2.5, 2.6, -1.9, 1.9)],
        scale=19,
        titles=["turning counter-clockwise about a centre", "one cell for each way to slip"],
    )
    one_contact(left)
    three_contacts(right)
    return figure


save("rotation-centres.svg", make)
