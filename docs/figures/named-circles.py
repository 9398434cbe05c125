"""Great circles with names, colours and dashes."""

from arrangement import read_arrangement
from arrangement.pictures import draw_sphere, save_figure


def make():
    look = {"ℓ": "crimson", "m": "royalblue:dashed", 6: ":dotted"}
    return draw_sphere(read_arrangement("braid-a3"), names="1=ℓ,2=m", colours=look, labels="none")


save_figure("named-circles.svg", make)
