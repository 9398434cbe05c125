"""The cells of the motion arrangement in the slice without rotation, without and with preload."""

from itertools import pairwise

from matplotlib.figure import Figure

from arrangement.drawing.output import save_figure
from equilibrium import read_grasp

FILLS = ("#ffffff", "#fdf0c0", "#b9dfd3", "#7fb9d8")
LIMIT = 2.2


def states(grasp, motion):
    """One character for each contact: detached, or the sign of its slip; and how many press."""
    text, pressing = "", 0
    for contact in grasp:
        gap = sum(n * x for n, x in zip(contact.normal_wrench, motion, strict=True))
        slip = sum(t * x for t, x in zip(contact.tangential_wrench, motion, strict=True))
        detached = contact.stiffness * gap > contact.preload
        text += "○" if detached else "+" if slip > 0 else "−"
        pressing += not detached
    return text, pressing


def panel(axes, name, title):
    grasp = read_grasp(name)
    q = float(next(iter(grasp)).preload)
    columns = sorted({-LIMIT, -q, 0.0, q, LIMIT})
    rows = sorted({-LIMIT, 0.0, q, LIMIT})
    for left, right in pairwise(columns):
        for low, high in pairwise(rows):
            middle = (left + right) / 2, (low + high) / 2
            text, pressing = states(grasp, (*middle, 0))
            axes.fill([left, right, right, left], [low, low, high, high], FILLS[pressing], lw=0)
            axes.text(*middle, text, size=7, ha="center", va="center")
    axes.axhline(0, color="black", lw=1.1)
    axes.axvline(0, color="black", lw=1.1)
    for line, place in ((axes.axvline, q), (axes.axvline, -q), (axes.axhline, q)):
        line(place, color="#d55e00", lw=1.1, ls=(0, (5, 2)))
    if q:
        axes.plot(0, 0.5, "o", color="black", ms=4, zorder=5)
    axes.set(xlim=(-LIMIT, LIMIT), ylim=(-LIMIT, LIMIT), aspect="equal")
    axes.set_xticks([-1, 0, 1] if q else [0])
    axes.set_yticks([0, 1] if q else [0])
    axes.tick_params(labelsize=7, length=2)
    axes.set_xlabel("x", size=7, labelpad=1)
    axes.set_ylabel("y", size=7, labelpad=1, rotation=0, y=0.84 if q else 0.6)
    axes.set_title(title, size=7)


def make():
    figure = Figure(figsize=(5.6, 2.9))
    left, right = figure.subplots(1, 2)
    panel(left, "paper-three-contacts", "no preload")
    panel(right, "paper-three-contacts-preload-1", "preload 1")
    figure.subplots_adjust(0.05, 0.1, 0.99, 0.93, wspace=0.12)
    return figure


save_figure("motion-slice.svg", make)
