"""Resisted wrenches of a grasp in space, in a plane of two of their six coordinates."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from arrangement.draw.colours import BLACK, GREY, VERMILION
from arrangement.draw.items import Floats
from arrangement.draw.legend import Legend
from arrangement.draw.measuring import POINTS
from arrangement.draw.scene import Scene
from arrangement.exact import shown
from arrangement.progress import watched
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal
from equilibrium.spatial_verdict import RESISTED
from equilibrium.wrench_sets.known_loads import KnownLoads
from equilibrium.wrench_sets.spatial import SpatialMagnitudes, spatial_magnitudes

from .keys import symbol
from .style import SHADE, nice

NAMES = ("fx", "fy", "fz", "tx", "ty", "tz")
_LABELS = ("$f_x$", "$f_y$", "$f_z$", "τ_x", "τ_y", "τ_z")
#: Relative width of the brackets, and nodes of each tree: finer ones cannot be seen.
_WIDTH, _NODES, _EVERY = Fraction(1, 40), 20, 2
_MARGIN = 22.0
_HELD, _REFUTED = "#5f93bd", "#f6e3d3"


def slice_in_space(grasp: Grasp, axes: str, directions: int, width: float) -> Scene:
    """Return the picture; see `equilibrium.draw.slices.draw_slice`."""
    chosen = axes.split(",")
    if len(set(chosen)) != 2 or not set(chosen) <= set(NAMES):
        raise GraspError(f"the axes are {shown(axes)}; give two of {', '.join(NAMES)}, as in fx,fz")
    if not 3 <= directions <= 360:
        raise GraspError(f"directions is {directions}; give 3 to 360")
    first, second = map(NAMES.index, chosen)
    spokes, loads = [], KnownLoads(grasp, _NODES)
    for k in watched(range(directions), "directions"):
        angle = 2 * math.pi * k / directions
        way = unit_normal((math.cos(angle), math.sin(angle)), Fraction(1, 100)).normal
        load = [Fraction(0)] * 6
        load[first], load[second] = way
        known = spatial_magnitudes(grasp, load, width=_WIDTH, loads=loads, every=_EVERY)
        spokes.append((np.array([float(x) for x in way]), known))
    rows = [
        [(float(v[first]), float(v[second]), float(rest)) for v, rest in tree]
        for tree in loads.trees
    ]
    return _drawn(spokes, rows, (_LABELS[first], _LABELS[second]), width)


def _drawn(
    spokes: list[tuple[Floats, SpatialMagnitudes]],
    trees: list[list[tuple[float, float, float]]],
    names: tuple[str, str],
    width: float,
) -> Scene:
    # Of a border at 0 only the width of its bracket is seen, which says nothing about the scale.
    borders = [b for _, m in spokes for b in m.borders if b.resisted > 0]
    ends = [float(max(b.resisted, b.refused)) for b in borders]
    reach = 1.25 * min(4 * float(np.median(ends)), max(ends)) if ends else 1.0
    scene = Scene(width, width)
    middle, scale = np.full(2, width * POINTS / 2), (width * POINTS / 2 - _MARGIN) / reach
    refuted = _refuted(scene, middle, scale, reach, trees)
    _axes(scene, middle, scale, reach, names)
    rim = []
    for i, (way, known) in enumerate(spokes):
        held, start = known.samples[0][1] == RESISTED, 0.0
        stops = [(float(b.resisted), float(b.refused), bool(b.undecided)) for b in known.borders]
        for resisted, refused, open_ in [*stops, (reach, reach, False)]:
            near, far = sorted((min(resisted, reach), min(refused, reach)))
            wide = 3.0 if open_ else 1.0
            if held:
                part = [middle + x * scale * way for x in (start, near)]
                scene.line(part, ec=_HELD, lw=2.0, zorder=3, gid=f"spoke-{i}", role="region")
            if far > near:
                part = [middle + x * scale * way for x in (near, far)]
                scene.line(part, ec=VERMILION, lw=wide, zorder=4, gid=f"open-{i}", role="line")
            if near < reach:
                scene.mark(middle + near * scale * way, "o", 2.2, color=BLACK, zorder=5)
            held, start = not held, far
        if stops and known.samples[0][1] == RESISTED:
            rim.append(middle + min(stops[0][0], reach) * scale * way)
        else:
            rim.append(middle + (reach if known.samples[0][1] == RESISTED else 0) * scale * way)
    scene.polygon(rim, fc=SHADE, ec="none", zorder=0.5, gid="region-1", role="region")
    _explain(scene.legend, spokes, bool(ends), refuted)
    return scene


def _clipped(polygon: Floats, rows: list[tuple[float, float, float]]) -> Floats:
    """Return the part of a convex polygon where all ``a x + b y + c`` are at least 0."""
    for a, b, c in rows:
        values = polygon @ (a, b) + c
        corners = []
        for k in range(len(polygon)):
            here, last = values[k], values[k - 1]
            if here * last < 0:
                corners.append((polygon[k] * last - polygon[k - 1] * here) / (last - here))
            if here >= 0:
                corners.append(polygon[k])
        if len(corners) < 3:
            return np.zeros((0, 2))
        polygon = np.array(corners)
    return polygon


def _axes(scene: Scene, middle: Floats, scale: float, reach: float, names: tuple[str, str]) -> None:
    for way in (np.array([1.0, 0.0]), np.array([0.0, 1.0])):
        axis = [middle - reach * scale * way, middle + reach * scale * way]
        scene.line(axis, ec=GREY, lw=0.4, zorder=1, role="axis")
    step = nice(0.5 * reach)
    for k in (-2, -1, 1, 2):
        for way, anchor in ((np.array([1.0, 0.0]), (0.5, 1.0)), (np.array([0.0, 1.0]), (1.0, 0.5))):
            if abs(k * float(step)) < reach:
                at = middle + k * float(step) * scale * way - 3 * way[::-1]
                text = f"{float(k * step):g}".replace("-", "−")
                scene.write(at, text, 5.5, anchor=anchor, color=GREY)
    for name, out in zip(names, ((1, 0), (0, 1)), strict=True):
        scene.write(middle + (reach * scale + 9) * np.array(out), name)


def _refuted(
    scene: Scene,
    middle: Floats,
    scale: float,
    reach: float,
    trees: list[list[tuple[float, float, float]]],
) -> bool:
    """Paint what each tree refutes; return whether any of it is in view."""
    window = reach * np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    parts = [part for tree in trees if len(part := _clipped(window, tree)) > 2]
    for k, part in enumerate(parts):
        corners = list(middle + scale * part)
        scene.polygon(
            corners, fc=_REFUTED, ec="none", zorder=0.4, gid=f"refuted-{k}", role="region"
        )
    return bool(parts)


def _explain(
    legend: Legend, spokes: list[tuple[Floats, SpatialMagnitudes]], ends: bool, refuted: bool
) -> None:
    """Say what is drawn, if there are borders beyond 0 or not."""
    legend.key(symbol(_HELD), "proved to be resisted at the samples, from 0 to the border")
    if refuted:
        legend.key(symbol(_REFUTED), "proved not to be resisted (white: left open here)")
    if ends:
        legend.key(symbol("missed"), "between the two proofs (thick: tried, undecided)")
    elif all(known.borders for _, known in spokes):
        legend.line("nothing is resisted in these directions, 0 aside")
    legend.line(f"{len(spokes)} directions; the shade between them is a guide, no proof")
