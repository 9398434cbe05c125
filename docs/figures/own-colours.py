"""Great circles whose regions are coloured by a rule of one's own, and a note on the picture."""

from arrangement import read_arrangement
from arrangement.pictures import DrawnRegion, draw_sphere, save_figure


def colour(region: DrawnRegion) -> str:
    """Mark the regions that lie on the same side of the first two planes."""
    return "#f0c987" if region.signs[0] == region.signs[1] else "#ffffff"


def make():
    planes = read_arrangement("braid-a3")
    figure = draw_sphere(planes, colour=colour, width=88)
    figure.text(0.01, 0.99, "dark: on one side\nof planes 1 and 2", va="top", fontsize=7)
    return figure


save_figure("own-colours.svg", make)
