"""Slip loads of physics engines over the exact ones, as measured for howto/physics-engines.rst."""

import csv
from pathlib import Path

from matplotlib.figure import Figure

from arrangement.drawing.output import save_figure

MEASURED = Path(__file__).parents[1] / "howto" / "slip-loads.csv"
#: Engine and setting of each panel.
PANELS = [
    ("mujoco", "elliptic, impratio 100"),
    ("mujoco", "pyramidal, impratio 1"),
    ("pymunk", "50 iterations"),
    ("drake", "Sap"),
]
STARTS = {"together": ("o", "#0072b2"), "preload first": ("x", "#d55e00")}


def make():
    with MEASURED.open(encoding="utf-8") as file:
        ends = [r for r in csv.DictReader(file) if r["exact"] != "never"]
    rows = [r for r in ends if r["slip"] not in ("none", "not settled")]
    line = [f(float(r["exact"]) for r in rows) for f in (min, max)]
    figure = Figure(figsize=(5, 8.4), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True, sharey=True).flat
    for axes, (engine, setting) in zip(panels, PANELS, strict=True):
        axes.loglog(line, line, color="black", lw=0.8)
        for start, (sign, colour) in STARTS.items():
            kind = (engine, setting, start)
            own = [r for r in rows if (r["engine"], r["setting"], r["start"]) == kind]
            places = [[float(r[key]) for r in own] for key in ("exact", "slip")]
            axes.plot(*places, sign, color=colour, ms=3.5, mew=0.8, fillstyle="none", label=start)
        axes.set_title(f"{engine}, {setting}", fontsize=9)
        axes.set_aspect("equal")
    panels[0].legend(fontsize=8, frameon=False)
    figure.supxlabel("exact slip load", fontsize=9)
    figure.supylabel("slip load of the engine", fontsize=9)
    return figure


save_figure("slip-loads.svg", make)
