"""A point and an arrow that are added to a picture of lines, in the coordinates of the lines."""

from arrangement import Arrangement
from arrangement.pictures import save_figure


def make():
    lines = Arrangement([[1, 0], [0, 1], [1, 1], [1, -2]], [0, 0, 0, 1])
    figure = lines.draw("lines")
    axes = figure.axes[0]
    axes.plot([0], [0], "o", color="#c2410c")
    look = {"arrowstyle": "->", "color": "#c2410c"}
    axes.annotate("three lines meet", (0, 0), (0.12, 0.17), arrowprops=look, fontsize=7)
    return figure


save_figure("point-and-arrow.svg", make)
