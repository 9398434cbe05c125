"""States that rigid motion allows against all choices of states, over the number of contacts."""

from math import comb

from matplotlib.figure import Figure

from arrangement.drawing.output import save_figure
from equilibrium.grasps.inputs import random_grasp
from equilibrium.plane.states.contact_states import contact_states

BLACK, BLUE, VERMILION = "black", "#0072b2", "#d55e00"


def with_preload(m):
    """The largest number of faces of m tangential planes and m normal planes off the origin."""
    points = comb(2 * m, 3) - comb(m, 3) + 1
    lines = comb(m, 2) * (m + 2) + (comb(2 * m, 2) - comb(m, 2)) * (2 * m - 1)
    facets = m * (2 * m - 2 + sum(1 + j for j in range(m - 1, 2 * m - 1)))
    facets += m * (2 * m + comb(2 * m - 1, 2))
    regions = m * m - m + 2 + sum(1 + j + comb(j, 2) for j in range(m, 2 * m))
    return points + lines + facets + regions


def without_preload(m):
    """The same for planes that all pass through the origin."""
    return 16 * m * m - 8 * m + 3


def make():
    contacts = range(3, 13)
    figure = Figure(figsize=(3.9, 2.9))
    axes = figure.add_axes((0.13, 0.14, 0.84, 0.83))
    draw = axes.semilogy
    draw(contacts, [4**m for m in contacts], "--", color=BLACK, lw=1, label="all choices, $4^m$")
    for loaded, colour, mark, bound, name in (
        (True, VERMILION, "s", with_preload, "preload: at most, about $9.3\\,m^3$"),
        (False, BLUE, "o", without_preload, "no preload: at most $16m^2-8m+3$"),
    ):
        draw(contacts, [bound(m) for m in contacts], color=colour, lw=1.2, label=name)
        found = [(m, random_grasp(m, seed, preload=loaded)) for m in contacts for seed in (1, 2)]
        counts = [len(contact_states(grasp)) for _, grasp in found]
        style = {"color": colour, "ms": 3.5, "mfc": "white", "mew": 0.8}
        draw([m for m, _ in found], counts, mark, label="random grasps", **style)
    axes.legend(fontsize=6, frameon=False, loc="upper left")
    axes.set_xlabel("contacts m", size=7)
    axes.set_ylabel("states", size=7, labelpad=1)
    axes.set_xticks(contacts)
    axes.tick_params(labelsize=7)
    axes.minorticks_off()
    axes.grid(color="#dddddd", lw=0.4)
    axes.set_axisbelow(True)
    return figure


save_figure("state-counts.svg", make)
