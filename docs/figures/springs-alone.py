"""Two methods with springs that answer wrongly, each beside the full model."""

from _plane import BLUE, GREY, ORANGE, arrow, body, dot, label, panels, save

from equilibrium import read_grasp, solve
from equilibrium.methods.cones import cones
from equilibrium.methods.springs import linear_compliance

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
TALL = [(-1, -1.6), (1, -1.6), (1, 1.6), (-1, 1.6)]


def shown(axes, corners, grasp, wrench, forces, size, moved=()):
    """Draw the object, its cones, the applied force, the contact forces, and marked slips."""
    body(axes, corners)
    for number, contact in enumerate(grasp, 1):
        p, n, t = ([float(x) for x in v] for v in (contact.point, contact.normal, contact.tangent))
        mu = float(contact.friction)
        length = 0.55 / (1 + mu * mu) ** 0.5
        ends = [[p[k] + length * (n[k] + s * mu * t[k]) for k in (0, 1)] for s in (1, -1)]
        axes.fill(*zip(p, *ends, strict=True), color=BLUE, alpha=0.16, lw=0, zorder=2)
        dot(axes, *p)
        low = 0.14 if p[1] < -0.5 else 0
        label(axes, p[0] - 0.22 * n[0], p[1] - 0.22 * n[1] - low, str(number), fontsize=7)
        if forces is None or not any(forces[number - 1]):
            continue
        push, pull = (size * float(x) for x in forces[number - 1])
        arrow(axes, p, [push * n[k] + pull * t[k] for k in (0, 1)], BLUE)
    arrow(axes, (0, 0.95), [size * float(x) for x in wrench[:2]], ORANGE)
    label(axes, 0.16, 0.85, "$w$", ORANGE)
    for point, step in moved:
        arrow(axes, point, step, GREY, lw=0.9)


def linear():
    grasp, wrench = read_grasp("paper-three-contacts"), (0, -1, 0)
    window = (-1.5, 1.5, -1.4, 1.2)
    titles = ["linear springs: not resisted", "full model: resisted"]
    figure, (left, right) = panels([window, window], scale=18, titles=titles)
    shown(left, SQUARE, grasp, wrench, linear_compliance(grasp, wrench).forces, 0.9)
    (found,) = solve(grasp, wrench).equilibria
    shown(right, SQUARE, grasp, wrench, found.forces, 0.9)
    return figure


def twisted():
    grasp, wrench = read_grasp("paper-four-contacts").with_friction(2), (0, -1, 0)
    window = (-1.6, 1.8, -1.8, 1.75)
    titles = ["cones alone: resisted", "full model: not resisted"]
    figure, (left, right) = panels([window, window], scale=18, titles=titles)
    found = cones(grasp, wrench)
    x, y, r = (float(v) for v in found.motion)
    moved = []
    for i in (0, 2):
        px, py = (float(v) for v in list(grasp)[i].point)
        out = 0.12 if px > 0 else -0.12
        moved.append(((px + out, py), (0.7 * (x - r * py), 0.7 * (y + r * px))))
    shown(left, TALL, grasp, wrench, found.forces, 0.9, moved)
    shown(right, TALL, grasp, wrench, None, 0.9)
    return figure


save("springs-alone-linear.svg", linear)
save("springs-alone-twist.svg", twisted)
