"""Eleven regions are seven regions and four pieces of a line."""

from itertools import pairwise

from _plane import BLUE, ORANGE, dot, label, line, panels, save

# Four lines y = slope x + height; the last one is taken out.
LINES = [(0.15, -0.35), (1.6, 0.75), (-1.3, 0.55)]
LAST = (-0.45, 0.3)
END = 1.55


def ends(slope, height):
    return [(x, slope * x + height) for x in (-9, 9)]


def crossing(one, other):
    x = (other[1] - one[1]) / (one[0] - other[0])
    return x, one[0] * x + one[1]


def regions(lines, axes, wanted):
    """Write a number into each region: at the point of a grid that is farthest from all lines."""
    steps = [k / 50 - END for k in range(1, 155)]
    best = {}
    for x in steps:
        for y in steps:
            signs = tuple(y > a * x + b for a, b in lines)
            room = min(abs(y - a * x - b) / (1 + a * a) ** 0.5 for a, b in lines)
            room = min(room, END - abs(x), END - abs(y))
            if room > best.get(signs, (0,))[0]:
                best[signs] = (room, x, y)
    assert len(best) == wanted, "the picture shows every region"
    order = sorted(best.values(), key=lambda place: (-round(place[2], 1), place[1]))
    for number, (_, x, y) in enumerate(order, 1):
        label(axes, x, y, str(number), BLUE, fontsize=7)


def make():
    window = (-END, END, -END, END)
    titles = ["4 lines, 11 regions", "one taken out: 7 regions", "seen on it: 3 points, 4 pieces"]
    figure, (whole, without, on) = panels([window] * 3, scale=16, titles=titles)
    for axes in (whole, without):
        for each in LINES:
            line(axes, *ends(*each))
    line(whole, *ends(*LAST), color=ORANGE, lw=1.4)
    regions([*LINES, LAST], whole, 11)
    regions(LINES, without, 7)
    line(on, *ends(*LAST), color=ORANGE, lw=1.4)
    crossings = sorted(crossing(LAST, each) for each in LINES)
    for x, y in crossings:
        dot(on, x, y, size=14)
    cuts = [-END, *(x for x, _ in crossings), END]
    for number, (left, right) in enumerate(pairwise(cuts), 1):
        x = (left + right) / 2
        label(on, x, LAST[0] * x + LAST[1] + 0.17, str(number), BLUE, fontsize=7)
    return figure


save("deletion-restriction.svg", make)
