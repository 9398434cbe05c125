"""Forces at torque 0 that the cones of three fingers balance with a total normal force of 1."""

from _plane import BLUE, GREY, ORANGE, dot, label, line, panels, save

from equilibrium import read_grasp
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace


def panel(axes, friction):
    space = GraspWrenchSpace(read_grasp("paper-three-contacts").with_friction(friction))
    corners = [tuple(map(float, corner)) for corner in space.slice()]
    line(axes, (-1.3, 0), (1.3, 0), color=GREY, lw=0.6)
    line(axes, (0, -1.3), (0, 0.8), color=GREY, lw=0.6)
    axes.fill(*zip(*corners, strict=True), facecolor=BLUE, alpha=0.16, lw=0, zorder=2)
    axes.fill(*zip(*corners, strict=True), facecolor="none", edgecolor=BLUE, lw=1.4, zorder=4)
    for x, y in corners:
        dot(axes, x, y, BLUE, size=12)
    dot(axes, 0, 0, ORANGE, size=26)
    label(axes, 1.24, 0.12, "$f_x$")
    label(axes, 0.16, 0.76, "$f_y$")


def make():
    window = (-1.35, 1.35, -1.35, 0.85)
    titles = ["friction 1/2: force closure", "no friction: no force closure"]
    figure, (left, right) = panels([window] * 2, scale=22, titles=titles)
    panel(left, "1/2")
    panel(right, 0)
    for x, y, text in (
        (0.32, 0.55, "(0, 1/2)"),
        (1.04, -0.85, "(3/4, −3/4)"),
        (0.3, -1.12, "(0, −1)"),
    ):
        label(left, x, y, text, fontsize=7)
    return figure


save("force-closure.svg", make)
