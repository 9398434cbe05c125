"""All diagonals of a regular heptagon, inside of it."""

from arrangement import families
from arrangement.pictures import draw_lines, save_figure


def make():
    heptagon = families.polygon(7)
    return draw_lines(families.diagonals(7), inside=heptagon, labels="none", width=88)


save_figure("chords.svg", make)
