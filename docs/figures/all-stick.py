"""Nothing moves: each contact pushes with its preload, and friction is somewhere in a segment."""

from _plane import BLUE, GREEN, ORANGE, arrow, body, dot, label, line, panels, save

from equilibrium import read_grasp, solve

NOTCHED = [(-0.5, -1), (1, -1), (1, 1), (-0.5, 1), (-0.5, 0.4), (0, 0.4), (0, -0.4), (-0.5, -0.4)]
COLOURS = (BLUE, ORANGE, GREEN)
SIZE = 0.75


def make():
    grasp = read_grasp("all-contacts-stick")
    (found,) = solve(grasp, (0, 0, 0)).equilibria
    windows = [(-1.0, 1.4, -1.35, 1.35), (-0.2, 2.0, -1.0, 1.3)]
    titles = ["each push is the preload", "the forces close"]
    figure, (left, right) = panels(windows, scale=22, titles=titles)
    body(left, NOTCHED)
    at = (0.25, -0.4)
    for number, (contact, force) in enumerate(zip(grasp, found.forces, strict=True)):
        p, n, t = ([float(v) for v in w] for w in (contact.point, contact.normal, contact.tangent))
        q, mu = float(contact.preload), float(contact.friction)
        colour = COLOURS[number]
        base = [p[k] + SIZE * q * n[k] for k in (0, 1)]
        ends = [[base[k] + s * SIZE * mu * q * t[k] for k in (0, 1)] for s in (1, -1)]
        left.fill(*zip(p, *ends, strict=True), color=colour, alpha=0.14, lw=0, zorder=2)
        line(left, *ends, color=colour, lw=1.1)
        push, drag = (float(c) for c in force)
        total = [push * n[k] + drag * t[k] for k in (0, 1)]
        arrow(left, p, [SIZE * v for v in total], colour)
        dot(left, *p)
        label(left, p[0] - 0.17 * n[0] - 0.02, p[1] - 0.17 * n[1], str(number + 1))
        arrow(right, at, [1.3 * v for v in total], colour)
        middle = [at[k] + 0.65 * total[k] for k in (0, 1)]
        label(right, middle[0] + (0.16 if number else 0), middle[1] - 0.17, str(number + 1), colour)
        at = tuple(at[k] + 1.3 * total[k] for k in (0, 1))
    return figure


save("all-stick.svg", make)
