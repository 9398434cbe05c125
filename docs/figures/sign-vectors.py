"""Three lines and their 19 faces, each with its sign vector."""

from _plane import BLUE, ORANGE, arrow, dot, label, line, panels, save

from arrangement import Arrangement

LINES = Arrangement([[0, 1], [-4, -3], [4, -3]], [0, -12, -12])
CORNERS = [(-3, 0), (3, 0), (0, 4)]
REGIONS = [(0, "5/4"), (0, "-7/5"), ("17/5", 3), ("-17/5", 3), (0, "53/10"), (-5, "-6/5"),
           (5, "-6/5")]  # fmt: skip
EDGES = [(0, 0), ("3/2", 2), ("-3/2", 2), (-5, 0), (5, 0), ("-9/8", "11/2"), ("9/8", "11/2"),
         ("-31/8", "-7/6"), ("31/8", "-7/6")]  # fmt: skip


def signs(point):
    return "".join("−0+"[s + 1] for s in LINES.signs_at(point))


def number(value):
    top, _, bottom = str(value).partition("/")
    return int(top) / int(bottom or 1)


def make():
    figure, (axes,) = panels([(-6.4, 6.4, -2.3, 6.5)], scale=11)
    line(axes, (-6.2, 0), (6.2, 0))
    line(axes, (-4.6, -32 / 15), (1.75, 19 / 3))
    line(axes, (4.6, -32 / 15), (-1.75, 19 / 3))
    for name, at, normal in (("1", (-6.2, 0), (0, 0.8)), ("2", (-1.75, 19 / 3), (-0.64, -0.48)),
                             ("3", (1.75, 19 / 3), (0.64, -0.48))):  # fmt: skip
        arrow(axes, at, normal, "black", lw=0.8)
        label(axes, at[0] + 1.35 * normal[0], at[1] + 1.35 * normal[1], name, fontsize=7)
    box = {"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none"}
    for places, colour, size in ((REGIONS, "black", 9), (EDGES, BLUE, 7.5)):
        for point in places:
            x, y = map(number, point)
            label(axes, x, y, signs(point), colour, fontsize=size, bbox=box)
    for x, y in CORNERS:
        dot(axes, x, y, ORANGE, 16)
        label(axes, x + (0.75 if x >= 0 else -0.75), y + 0.45, signs((x, y)), ORANGE, fontsize=7.5)
    return figure


save("sign-vectors.svg", make)
