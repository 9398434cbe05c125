"""Foot, between, near, one plane more: the four lemmas by which regions are counted."""

from _plane import BLUE, GREEN, GREY, MM, ORANGE, arrow, dot, label, line, save

from arrangement import Arrangement

# Three lines a x + b y = c, and h; rows of the arrangement.
LINES = [((-3, 20), -7), ((-16, 10), 7), ((13, 10), 6)]
H = ((9, 20), 6)
END = 1.55
WINDOW = [(-END, -END), (END, -END), (END, END), (-END, END)]


def value(form, point):
    (a, b), c = form
    return a * point[0] + b * point[1] - c


def on(form, x):
    """The point of a line above or below x."""
    (a, b), c = form
    return x, (c - a * x) / b


def crossing(one, other):
    ((a, b), c), ((d, e), f) = one, other
    det = a * e - b * d
    return (c * e - b * f) / det, (a * f - c * d) / det


def part(forms, signs):
    """The corners of a region, as far as the window shows it."""
    corners = WINDOW
    for form, sign in zip(forms, signs, strict=True):
        kept = []
        for p, q in zip((corners[-1], *corners), corners, strict=False):
            before, after = sign * value(form, p), sign * value(form, q)
            if before * after < 0:
                share = before / (before - after)
                kept.append(tuple(a + share * (b - a) for a, b in zip(p, q, strict=True)))
            kept += [q] if after >= 0 else []
        corners = kept
    return corners


def fill(axes, corners, colour, alpha=0.16):
    axes.fill(*zip(*corners, strict=True), color=colour, alpha=alpha, lw=0, zorder=1)


def sketch(axes, title, *, faint=False):
    axes.set(xlim=(-END, END), ylim=(-END, END), aspect="equal")
    axes.set_axis_off()
    axes.set_title(title, fontsize=8, pad=3)
    for form in LINES:
        line(axes, on(form, -9), on(form, 9), color=GREY if faint else "black")
    line(axes, on(H, -9), on(H, 9), color=ORANGE, lw=1.4)
    label(axes, -1.42, on(H, -1.42)[1] - 0.14, "$h$", ORANGE)


def foot(axes):
    sketch(axes, "Foot", faint=True)
    for form in LINES:
        x, y = crossing(H, form)
        line(axes, (x, -9), (x, 9), color=BLUE, lw=0.9, linestyle=(0, (4, 2)))
        dot(axes, x, y, BLUE, size=12)
    x = (0.75, 1.2)
    below = on(H, x[0])
    arrow(axes, x, (0, below[1] - x[1]), GREEN)
    dot(axes, *x, GREEN, size=14)
    dot(axes, *below, GREEN, size=14)
    label(axes, x[0] + 0.14, x[1], "$x$", GREEN)
    label(axes, below[0] - 0.22, below[1] - 0.13, "foot", GREEN, fontsize=7)


def between(axes):
    sketch(axes, "Between")
    x, y = (-0.04, 0.5), (0.12, -0.1)
    fill(axes, part(LINES, [1 if value(f, x) > 0 else -1 for f in LINES]), BLUE)
    above, below = value(H, x), value(H, y)
    share = above / (above - below)
    z = tuple(p + share * (q - p) for p, q in zip(x, y, strict=True))
    line(axes, x, y, color=GREEN, lw=1.2)
    for point, name in ((x, "$x$"), (y, "$y$"), (z, "$z$")):
        dot(axes, *point, GREEN, size=14)
        label(axes, point[0] + 0.14, point[1] + 0.02, name, GREEN)


def near(axes):
    sketch(axes, "Near")
    z = on(H, 0.04)
    fill(axes, part(LINES, [1 if value(f, z) > 0 else -1 for f in LINES]), BLUE)
    for length in (0.27, -0.27):
        arrow(axes, z, (0, length), GREEN)
    dot(axes, *z, GREEN, size=14)
    label(axes, z[0] + 0.15, z[1] + 0.04, "$z$", GREEN)


def one_more(axes):
    sketch(axes, "One plane more")
    planes = Arrangement([f[0] for f in LINES], [f[1] for f in LINES])
    number = 0
    for region in planes.regions():
        corners = part(LINES, region.signs)
        sides = {value(H, corner) > 0 for corner in corners}
        if len(sides) == 2:
            fill(axes, corners, ORANGE)
        for side in (1, -1) if len(sides) == 2 else (0,):
            shown = corners if not side else part([*LINES, H], [*region.signs, side])
            x, y = (sum(p[k] for p in shown) / len(shown) for k in (0, 1))
            number += 1
            label(axes, x, y, str(number), ORANGE if side else BLUE, fontsize=7)
    whole = [*LINES, H]
    assert number == len(Arrangement([f[0] for f in whole], [f[1] for f in whole]).regions())


def make():
    from matplotlib.figure import Figure

    side, gap, head = 42.0, 6.0, 6.0
    width, height = 2 * side + gap, 2 * (side + head) + gap
    figure = Figure(figsize=(width * MM, height * MM))
    for k, draw in enumerate((foot, between, near, one_more)):
        column, row = k % 2, 1 - k // 2
        low = row * (side + head + gap)
        left = column * (side + gap)
        draw(figure.add_axes((left / width, low / height, side / width, side / height)))
    return figure


save("four-lemmas.svg", make)
