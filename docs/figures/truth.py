"""Pictures of the lesson on the paper's claims: small grasps on which something goes wrong."""

from fractions import Fraction

from _plane import BLUE, GREY, arrow, body, dot, label, panels, save

from arrangement import read_arrangement
from arrangement.pictures import write_drawing as draw_planes
from equilibrium import read_grasp, solve
from equilibrium.pictures import write_drawing as draw_grasp

TENTHS = [
    [(-5, -10), (10, -10), (10, 10), (-5, 10), (-5, 4), (0, 4), (0, -4), (-5, -4)],
    [(-20, -10), (10, -10), (10, 10), (0, 10), (0, -5), (-10, -5), (-10, 10), (-20, 10)],
    [(0, 6), (0, -5), (-10, -5), (-10, -16), (10, -16), (10, 6)],
    [(0, -8), (10, -8), (10, 10), (-17, 10), (-17, 0), (-5, 0), (-5, 4), (0, 4)],
]
NOTCHED, SLOTTED, STEPPED, ANGLED = (
    [(Fraction(x, 10), Fraction(y, 10)) for x, y in corners] for corners in TENTHS
)

#: Picture: grasp, wrench, which equilibrium, outline of the object.
GRASPS = {
    "torque": ("paper-four-contacts", (0, 0, 3), 1, None),
    "stick": ("all-contacts-stick", (0, 0, 0), 1, NOTCHED),
    "lets-go": ("one-contact-lets-go", (-1, 0, 0), 1, SLOTTED),
    "first": ("several-equilibria", (-1, 0, 0), 1, STEPPED),
    "second": ("several-equilibria", (-1, 0, 0), 2, STEPPED),
}


def along():
    """The answer of the printed algorithm on a grasp that has no equilibrium."""
    grasp = read_grasp("friction-along-slip")
    (found,) = solve(grasp, (0, 0, 1), as_printed=["cell-check", "detachment"]).equilibria
    figure, (axes,) = panels([(-2.1, 1.5, -1.2, 1.3)], scale=22)
    body(axes, [(float(x), float(y)) for x, y in ANGLED])
    x, y, r = (float(value) for value in found.motion)
    for number, (contact, force) in enumerate(zip(grasp, found.forces, strict=True), 1):
        p, n, t = ([float(v) for v in w] for w in (contact.point, contact.normal, contact.tangent))
        cone = [[p[k] + 0.4 * (n[k] + s * t[k]) for k in (0, 1)] for s in (1, -1)]
        axes.fill(*zip(p, *cone, strict=True), color=BLUE, alpha=0.16, lw=0, zorder=2)
        push, pull = (0.6 * float(c) for c in force)
        arrow(axes, p, [push * n[k] + pull * t[k] for k in (0, 1)], BLUE)
        moved = (x - r * p[1], y + r * p[0])
        arrow(axes, p, [0.5 * v for v in moved], GREY, lw=0.9)
        dot(axes, *p)
        label(axes, p[0] - 0.17 * n[0] + 0.12 * n[1], p[1] - 0.17 * n[1] + 0.12 * n[0], str(number))
    return figure


for picture, (name, wrench, piece, outline) in GRASPS.items():
    options = {"wrench": wrench, "equilibrium": piece, "outline": outline}
    draw_grasp(read_grasp(name), f"truth-{picture}.svg", "grasp", **options)
draw_planes(read_arrangement("paper-four-contacts"), "truth-coincident.svg", "sphere")
save("truth-along.svg", along)
