"""The figures of the first lecture's slides: one each, with letters of 18 points or more."""

from _disc import disc
from _plane import BLUE, GREEN, GREY, ORANGE, arrow, body, dot, label, line, panels, save

from arrangement import read_arrangement
from arrangement.pictures import write_drawing
from equilibrium import read_grasp
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
from equilibrium.pictures import write_drawing as write_grasp

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
BIG = {"fontsize": 20}
LOOK = {"legend": "none", "font_size": 20, "width": 174}
FREE, SQUEEZED = read_grasp("paper-three-contacts"), read_grasp("paper-three-contacts-preload-1")


def moment():
    figure, (axes,) = panels([(-0.5, 2.9, -0.5, 2.5)], scale=48)
    arrow(axes, (-0.3, 0), (3, 0), GREY, lw=1.0)
    arrow(axes, (0, -0.3), (0, 2.6), GREY, lw=1.0)
    arrow(axes, (0, 0), (1.7, 0.8), BLUE, lw=2.5)
    arrow(axes, (1.7, 0.8), (-0.5, 1.2), ORANGE, lw=3)
    dot(axes, 1.7, 0.8, size=60)
    label(axes, 1.0, 0.2, "$p$", BLUE, **BIG)
    label(axes, 1.75, 1.6, "$f$", ORANGE, **BIG)
    label(axes, 2.65, -0.22, "$x$", GREY, **BIG)
    label(axes, -0.22, 2.3, "$y$", GREY, **BIG)
    return figure


def cone():
    figure, (axes,) = panels([(-1.7, 1.9, -1.5, 1.5)], scale=44)
    body(axes, [(-1, -1.2), (1.8, -1.2), (1.8, 1.2), (-1, 1.2)])
    axes.fill([-1, 1.4, 1.4], [0, 1.2, -1.2], color=ORANGE, alpha=0.2, lw=0, zorder=2)
    for y in (1.2, -1.2):
        line(axes, (-1, 0), (1.4, y), color=ORANGE, lw=1.5)
    arrow(axes, (-1, 0), (1.5, 0), GREY, lw=2)
    arrow(axes, (-1, 0), (1.5, 0.45), GREEN, lw=3)
    arrow(axes, (-1, 0), (0.6, 0.9), BLUE, lw=3)
    dot(axes, -1, 0, size=60)
    label(axes, 0.75, -0.2, "normal", GREY, **BIG)
    label(axes, 0.95, 0.55, "possible", GREEN, **BIG)
    label(axes, 0.35, 1.0, "impossible", BLUE, **BIG)
    return figure


def balanced():
    space = GraspWrenchSpace(FREE)
    corners = [tuple(map(float, corner)) for corner in space.slice()]
    figure, (axes,) = panels([(-1.4, 1.5, -1.4, 0.95)], scale=55)
    line(axes, (-1.3, 0), (1.3, 0), color=GREY, lw=1)
    line(axes, (0, -1.3), (0, 0.85), color=GREY, lw=1)
    axes.fill(*zip(*corners, strict=True), facecolor=BLUE, alpha=0.2, lw=0, zorder=2)
    axes.fill(*zip(*corners, strict=True), facecolor="none", edgecolor=BLUE, lw=2.5, zorder=4)
    dot(axes, 0, 0, ORANGE, size=120)
    label(axes, 1.3, 0.14, "$f_x$", **BIG)
    label(axes, 0.2, 0.8, "$f_y$", **BIG)
    return figure


def slips():
    figure, (axes,) = panels([(-2.7, 1.5, -2, 2)], scale=38)
    body(axes, SQUARE)
    line(axes, (-1, -1.9), (-1, 1.9), color=ORANGE, ls=(0, (4, 2)), lw=2)
    p = (-1, 0.3)
    dot(axes, *p, size=60)
    for centre, name, place in (
        ((-1, -1.5), "sticks", (-0.45, -1.5)),
        ((-2.3, -0.6), "slip+", (-2.2, -0.9)),
        ((0.45, -0.4), "slip−", (0.45, -0.7)),
    ):
        line(axes, centre, p, color=GREY, lw=1, ls=(0, (1, 2)))
        speed = (-(p[1] - centre[1]), p[0] - centre[0])
        size = (speed[0] ** 2 + speed[1] ** 2) ** 0.5
        arrow(axes, p, (speed[0] / size, speed[1] / size), GREEN, lw=2.5)
        dot(axes, *centre, GREEN, 60)
        label(axes, *place, name, GREEN, **BIG)
    return figure


def crossing():
    figure, (axes,) = panels([(-2.1, 1.7, -1.7, 1.5)], scale=42)
    body(axes, [(-1, -0.4), (-0.4, -1), (1, -1), (1, 1), (-1, 1)])
    for contact, other in (((-1, 0.3), (-1, -1.6)), ((0.3, -1), (-1.6, -1))):
        away = tuple(2 * a - b for a, b in zip(contact, other, strict=True))
        line(axes, other, away, color=ORANGE, ls=(0, (4, 2)), lw=2)
        dot(axes, *contact, size=60)
        speed = (-(contact[1] + 1), contact[0] + 1)
        arrow(axes, contact, [0.5 * x for x in speed], GREEN, lw=2.5)
    dot(axes, -1, -1, GREEN, 90)
    label(axes, -1.5, -1.35, "centre", GREEN, **BIG)
    return figure


def pull():
    figure, (axes,) = panels([(-1.7, 1.7, -1.7, 1.95)], scale=42)
    disc(axes, (0, 0.3), "moves up, no finger resists")
    return figure


for make in (moment, cone, balanced, slips, crossing, pull):
    save(f"lecture-1-{make.__name__}.svg", make)
write_grasp(FREE, "lecture-1-question.svg", "grasp", wrench=(0, 1, 0), **LOOK)
write_grasp(SQUEEZED, "lecture-1-holds.svg", "grasp", wrench=(0, 1, 0), **LOOK)
write_grasp(SQUEEZED, "lecture-1-set.svg", "resist", **LOOK)
planes = FREE.tangential_arrangement()
write_drawing(planes, "lecture-1-planes.svg", "planes", labels="none", **LOOK)
write_drawing(planes, "lecture-1-states.svg", "stereographic", labels="signs", **LOOK)
nine = read_arrangement("nine-generic-planes")
write_drawing(nine, "lecture-1-nine.svg", "sphere", labels="none", **LOOK)
