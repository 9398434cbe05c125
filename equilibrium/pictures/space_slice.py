"""Resisted wrenches of a grasp in space, in a plane of two of their six coordinates."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.progress import watched
from arrangement.drawing.colours import BLACK, VERMILION
from arrangement.drawing.scene import Floats, Legend, Scene
from arrangement.numbers.exact import shown
from arrangement.pictures.names import stroke
from equilibrium.decide import NOT_RESISTED, RESISTED, UNDECIDED
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal
from equilibrium.wrench_sets.along_in_space import KnownLoads, SpatialMagnitudes, spatial_magnitudes

from .panel import SQUARE, ZERO, Window, clipped, row_of_panels
from .style import SHADE, symbol

NAMES = ("fx", "fy", "fz", "tx", "ty", "tz")
_LABELS = ("$f_x$", "$f_y$", "$f_z$", r"$\tau_x$", r"$\tau_y$", r"$\tau_z$")
#: Relative width of the brackets, and nodes of each tree: finer ones cannot be seen.
_WIDTH, _NODES, _EVERY = Fraction(1, 40), 20, 2
#: Nodes for directions that end undecided.
_MORE_NODES = 400
_HELD, _REFUTED = "#5f93bd", "#f6e3d3"


def slice_in_space(grasp: Grasp, axes: Iterable[str], rays: int, width: float) -> Scene:
    """Return the picture; see `equilibrium.pictures.forces.draw_slice`."""
    chosen = (axes if isinstance(axes, str) else ",".join(axes)).split(",")
    if len(set(chosen)) != 2 or not set(chosen) <= set(NAMES):
        raise GraspError(
            f"the slice is {shown(' '.join(chosen))}; give two of {', '.join(NAMES)}, as in fx fz"
        )
    if not 3 <= rays <= 360:
        raise GraspError(f"the number of rays is {rays}; give 3 to 360")
    first, second = map(NAMES.index, chosen)
    spokes, quick, patient = [], KnownLoads(grasp, _NODES), KnownLoads(grasp, _MORE_NODES)
    patient.trees, patient.solver = quick.trees, quick.solver
    for k in watched(range(rays), "rays"):
        angle = 2 * math.pi * k / rays
        direction = unit_normal((math.cos(angle), math.sin(angle)), Fraction(1, 100)).normal
        load = [Fraction(0)] * 6
        load[first], load[second] = direction
        # Without preload there is one load to ask, and an answer in any case.
        for loads in [patient] if quick.scales else [quick, patient]:
            known = spatial_magnitudes(grasp, load, width=_WIDTH, loads=loads, every=_EVERY)
            if known.samples[-1][1] != UNDECIDED:
                break
        spokes.append((np.array(direction, float), known))
    rows = [
        [(float(v[first]), float(v[second]), float(rest)) for v, rest in tree]
        for tree in filter(None, quick.trees)
    ]
    return _drawn(grasp, spokes, rows, (_LABELS[first], _LABELS[second]), width)


def _drawn(
    grasp: Grasp,
    spokes: list[tuple[Floats, SpatialMagnitudes]],
    trees: list[list[tuple[float, float, float]]],
    names: tuple[str, str],
    width: float,
) -> Scene:
    # Of a boundary at 0 only the width of its bracket is seen, which says nothing about the scale.
    ends = [float(max(b.resisted, b.refused)) for _, m in spokes for b in m.borders if b.resisted]
    # Where a direction ends undecided, all that is proved is to be seen.
    ends += [t for _, m in spokes if m.samples[-1][1] == UNDECIDED and (t := _proved(m))]
    proved = ends or [t for _, m in spokes if (t := _proved(m))] or [0.8]
    reach = 1.25 * min(4 * float(np.median(proved)), max(proved))
    window = Window(ZERO, Fraction(reach))
    scene, (panel,) = row_of_panels(1, window, width, grasp, names=names)
    refuted = 0
    for tree in trees:
        part = SQUARE
        for a, b, c in tree:
            part = clipped(part, reach * np.array([a, b]), -c)
        if len(part) > 2:
            corners, name = panel.at(part), f"refuted-{refuted}"
            scene.polygon(corners, fc=_REFUTED, ec="none", zorder=0.4, gid=name, role="region")
            refuted += 1
    rim = []
    for i, (direction, known) in enumerate(spokes):
        end, within = 0.0, True
        for start, stop, held, tried in _stretches(known):
            part = panel.at(np.minimum([start, stop], reach)[:, None] / reach * direction)
            if held:
                scene.line(part, ec=_HELD, lw=2.0, zorder=3, gid=f"spoke-{i + 1}", role="region")
                end = min(stop, reach) / reach if within else end
                continue
            wide = 3.0 if tried else 1.0
            scene.line(part, ec=VERMILION, lw=wide, zorder=4, gid=f"open-{i + 1}", role="line")
            within = False
            if start < reach and stop < math.inf:
                scene.mark(part[0], "o", 2.2, color=BLACK, zorder=5)
        rim.append(panel.at(end * direction))
    if np.ptp(rim, axis=0).any():
        scene.polygon(rim, fc=SHADE, ec="none", zorder=0.5, gid="region-1", role="region")
    _explain(scene.legend, spokes, bool(ends), bool(refuted))
    return scene


def _stretches(known: SpatialMagnitudes) -> Iterator[tuple[float, float, bool, bool]]:
    """Yield what is seen of a direction: its ends, whether it is resisted, and open tries.

    What lies between two that are refused is left out; the last one is unbounded.
    """
    verdicts: dict[Any, str] = dict(known.samples)
    for border in known.borders:
        verdicts |= {border.resisted: RESISTED, border.refused: NOT_RESISTED}
        verdicts |= dict.fromkeys(border.undecided, UNDECIDED)
    since, start, before, tried = 0.0, 0.0, verdicts.pop(Fraction(0)), False
    for end, verdict in [*sorted(verdicts.items()), (math.inf, "")]:
        if verdict == UNDECIDED:
            tried = True
            continue
        if tried or before != RESISTED or verdict == NOT_RESISTED:
            if since < start:
                yield since, start, True, False
            if tried or (verdict and verdict != before):
                yield start, float(end), False, tried
            since = float(end)
        if verdict:  # beyond the largest that was tried nothing is known
            start, before, tried = float(end), verdict, False
    if since < start:
        yield since, start, True, False


def _proved(known: SpatialMagnitudes) -> float:
    """Return the largest magnitude that is proved to be resisted, of those tried."""
    return float(max((t for t, verdict in known.samples if verdict == RESISTED), default=0))


def _explain(
    legend: Legend, spokes: list[tuple[Floats, SpatialMagnitudes]], ends: bool, refuted: bool
) -> None:
    """Describe what is drawn, with or without boundaries beyond 0."""
    legend.key(stroke(ec=_HELD, lw=2.0), "proved to be resisted at the samples")
    if refuted:
        legend.key(symbol(_REFUTED), "proved not to be resisted (white: left open here)")
    open_ends = any(known.samples[-1][1] == UNDECIDED for _, known in spokes)
    if ends or open_ends:
        legend.key(symbol("missed"), "open between two proofs; thick: tried and undecided")
    elif all(known.zero_only for _, known in spokes):
        legend.line("only 0 is resisted in these directions")
    legend.line(f"{len(spokes)} directions; the shading between them is not proved")
    tried = [known.samples[-1][0] for _, known in spokes if known.samples[-1][1] == RESISTED]
    if tried:
        part = "" if len(tried) == len(spokes) else f", in {len(tried)} of them"
        legend.line(f"unbounded as far as tested ({float(max(tried)):g}){part}")
