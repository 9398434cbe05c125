"""A contact with its normal and tangent; a force, its line of action and its lever arm."""

from _plane import BLUE, GREEN, GREY, ORANGE, arrow, body, dot, label, line, panels, save


def make():
    figure, (left, right) = panels(
        [(-2.0, 1.9, -1.6, 1.75), (-1.9, 2.4, -1.6, 1.75)],
        scale=20,
        titles=["contact frame and friction cone", "torque is force times lever arm"],
    )
    corners = [(-1, -1), (1, -1), (1, 0.4), (0.2, 1.1), (-1, 1.1)]
    for axes in (left, right):
        body(axes, corners)
        dot(axes, 0, 0)
        label(axes, 0.13, -0.17, "$O$")

    # A cone of friction coefficient 1/2 at the contact (-1, 0).
    cone = [(-1, 0), (0.35, 0.675), (0.35, -0.675)]
    left.fill(*zip(*cone, strict=True), color=BLUE, alpha=0.14, lw=0, zorder=2)
    for end in cone[1:]:
        line(left, cone[0], end, color=BLUE, lw=0.7, ls=(0, (4, 2)))
    arrow(left, (-1, 0), (0.85, 0), BLUE)
    arrow(left, (-1, 0), (0, 0.85), ORANGE)
    dot(left, -1, 0)
    label(left, -0.28, -0.16, "$n$", BLUE)
    label(left, -1.15, 0.75, "$t$", ORANGE)
    label(left, -1.17, -0.12, "$p$")
    left.fill([-1.05, -1.75, -1.75, -1.05], [0.0, 0.16, -0.16, 0.0], color=GREY, lw=0, zorder=1)
    label(left, -1.6, -0.32, "finger", GREY, fontsize=7)
    label(left, 0.66, -0.52, "slope $\\mu$", BLUE, fontsize=7)
    arrow(left, (1.15, -1.35), (0.45, 0), "black", lw=0.9)
    arrow(left, (1.15, -1.35), (0, 0.45), "black", lw=0.9)
    label(left, 1.72, -1.35, "$x$")
    label(left, 1.15, -0.78, "$y$")

    # A force at a contact on the slanted side, and the distance of its line from the origin.
    point, force = (0.6, 0.75), (-0.15, -0.95)
    line(right, (0.726, 1.548), (0.255, -1.435), color=GREY, lw=0.7, ls=(0, (4, 2)))
    arrow(right, (point[0] - force[0], point[1] - force[1]), force, GREEN)
    dot(right, *point)
    label(right, 0.44, 0.68, "$p$")
    label(right, 0.9, 1.3, "$f$", GREEN)
    size = force[0] ** 2 + force[1] ** 2
    torque = point[0] * force[1] - point[1] * force[0]
    foot = (torque * force[1] / size, -torque * force[0] / size)
    line(right, (0, 0), foot, lw=1.0)
    label(right, 0.24, 0.12, "$\\ell$")
    label(right, 1.62, 0.1, "$|p \\times f| = \\ell\\,|f|$", fontsize=8)
    label(right, 0.78, -1.35, "line of action", GREY, fontsize=7)
    return figure


save("contact-wrench.svg", make)
