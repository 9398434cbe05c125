"""The grasp as a picture: object, contacts, friction cones, preload, wrench, forces, motion."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.draw.output import require_matplotlib
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.verdict import solve

from .body import Floats, sampled
from .legend import Legend
from .scene import ARC, CONE, FORCE, Scene, displaced, scene_of
from .shapes import Labels, arrow, curve_patch, mark, turning_arrow, wedge
from .style import (
    BLACK,
    BLUE,
    CONE_EDGE,
    CONE_FILL,
    FONT,
    GREY,
    PALE,
    VERMILION,
    bare,
    new_figure,
    nice,
    number,
    points,
    rounded,
    vector,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw_grasp(
    grasp: Grasp,
    *,
    wrench: Iterable[Any] | None = None,
    outline: Iterable[Iterable[Any]] | None = None,
    piece: int = 1,
    width: float = 88.0,
) -> Figure:
    """Draw contacts with friction cones and preloads; with a wrench, the equilibrium too.

    Forces are those on the object; all arrows of forces have one scale, which the bar states. The
    mark of a contact tells by shape its state at the motion drawn. The virtual motion is drawn as
    the displaced outline (of a grasp without outline, as arrows at the contacts), to first order,
    by a factor that is stated. The outline is dashed and only indicative (see `body`) unless a
    polygon is given; where no simple curve passes through the contacts, dashed lines join them.
    Where the origin of the frame is far from the contacts, the wrench is carried to their middle.

    Args:
        grasp: contacts; none, coincident ones and coordinates of any size are possible.
        wrench: applied force x, force y and torque about the origin; left out, none acts and
            nothing is solved.
        outline: corners of the object, exact; left out, an indicative curve.
        piece: which of the equilibria found (see `solve`), from 1.
        width: of the figure, in millimetres.

    Raises:
        GraspError: a bad outline, or no such piece.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    if wrench is None and piece != 1:
        raise GraspError("without a wrench nothing is solved; give one with the piece")
    verdict = None if wrench is None else solve(grasp, read_wrench(wrench))
    return _drawn(scene_of(grasp, verdict, outline, piece), width)


def _content(scene: Scene) -> Floats:
    """Return points whose box holds all that is drawn but labels."""
    held = [np.array([scene.origin])]
    if scene.curve is not None:
        held.append(sampled(scene.curve))
        if scene.step is not None:
            held.append(displaced(scene, held[-1]))
    for i, (p, n) in enumerate(zip(scene.places, scene.normals, strict=True)):
        t = np.array([-n[1], n[0]])
        angle = math.atan(rounded(list(scene.grasp)[i].friction))
        side, ahead = max(CONE * math.sin(angle), 0.1) * t, CONE * math.cos(angle) * n
        held.append(np.array([p, p + CONE * n, p - max(scene.preloads[i], 0.1) * n]))
        held.append(np.array([p + ahead - side, p + ahead + side]))
        arm = scene.arms[i]
        held.append(np.array([p if arm is None else p + arm]))
    if scene.load is not None:
        held.append(np.array([scene.origin + scene.load]))
    if scene.applied is not None and scene.applied[2]:
        held.append(scene.origin + ARC * 1.3 * np.array([[1, 1], [-1, -1]]))
    if not scene.places:
        held.append(np.array([[-1.0, -1.0], [1.0, 1.0]]))
    return np.concatenate(held)


def _drawn(scene: Scene, width: float) -> Figure:
    held = _content(scene)
    low, high = held.min(axis=0), held.max(axis=0)
    legend = Legend(width, scaled=bool(scene.reference))
    _describe(scene, legend)
    margin = 6.0
    per_unit = min((width - 2 * margin) / (high[0] - low[0]), 0.95 * width / (high[1] - low[1]))
    height = per_unit * (high[1] - low[1]) + 2 * margin
    figure = new_figure(width, height + legend.height)
    share = height / (height + legend.height)
    axes = figure.add_axes((0.0, 1 - share, 1.0, share))
    middle = (low + high) / 2
    half = np.array([width, height]) / 2 / per_unit
    bare(axes, tuple(middle - half), tuple(middle + half))
    unit = 1 / points(per_unit)
    _paint(axes, scene, unit)
    legend.draw(figure, scale=_bar(scene, per_unit))
    return figure


def _paint(axes: Any, scene: Scene, unit: float) -> None:
    labels = Labels(unit)
    _paint_body(axes, scene, unit, labels)
    _paint_contacts(axes, scene, unit, labels)
    _paint_load(axes, scene, unit, labels)
    _paint_numbers(axes, scene, unit, labels)


def _paint_body(axes: Any, scene: Scene, unit: float, labels: Labels) -> None:
    if scene.curve is not None:
        dashes = "solid" if scene.given else (0, (5, 2.5))
        axes.add_patch(curve_patch(scene.curve, fc=PALE, ec="none", gid="body", zorder=0))
        axes.add_patch(
            curve_patch(scene.curve, fill=False, ec=GREY, lw=0.7, ls=dashes, gid="outline",
                        zorder=2)
        )  # fmt: skip
        labels.avoid(sampled(scene.curve, 24))
        if scene.step is not None:
            style = {"ec": BLUE, "lw": 0.9, "ls": (0, (1, 1.5)), "gid": "motion", "zorder": 2.5}
            axes.add_patch(curve_patch(displaced(scene, scene.curve), fill=False, **style))
            labels.avoid(sampled(displaced(scene, scene.curve), 24))
        return
    middle = np.mean(scene.places, axis=0) if scene.places else scene.origin
    for i, place in enumerate(scene.places):
        axes.plot(*np.array([place, middle]).T, color=GREY, lw=0.5, ls=(0, (5, 2.5)),
                  gid=f"link-{i + 1}", zorder=0.5)  # fmt: skip
        labels.avoid(place + s * (middle - place) for s in np.linspace(0, 1, 24))
    if scene.step is not None:
        ends = displaced(scene, np.array(scene.places))
        for i, (start, end) in enumerate(zip(scene.places, ends, strict=True)):
            if np.linalg.norm(end - start) > unit:
                style = {"fc": BLUE, "ec": "none", "gid": f"motion-{i + 1}", "zorder": 5}
                axes.add_patch(arrow(start, end, 1.5 * unit, **style))
                labels.avoid(start + s * (end - start) for s in np.linspace(0, 1, 12))


def _paint_contacts(axes: Any, scene: Scene, unit: float, labels: Labels) -> None:
    seen: dict[Any, int] = {}
    for i, (contact, p, n) in enumerate(zip(scene.grasp, scene.places, scene.normals, strict=True)):
        t = np.array([-n[1], n[0]])
        half_angle = math.atan(rounded(contact.friction))
        axes.add_patch(
            wedge(p, n, half_angle, CONE, fc=CONE_FILL, ec=CONE_EDGE, lw=0.5,
                  gid=f"cone-{i + 1}", zorder=1)
        )  # fmt: skip
        axes.add_patch(
            curve_patch(np.array([p, p, p + CONE * n, p + CONE * n]), fill=False, ec=CONE_EDGE,
                        lw=0.5, ls=(0, (6, 2, 1, 2)), gid=f"normal-{i + 1}", zorder=1.1)
        )  # fmt: skip
        pad = 0.07 * t
        axes.plot(*np.array([p - pad, p + pad]).T, color=BLACK, lw=1.6, gid=f"pad-{i + 1}",
                  zorder=3, solid_capstyle="butt")  # fmt: skip
        labels.avoid([p + s * pad for s in (-1, 0, 1)])
        if scene.preloads[i] > 0:
            away = p - scene.preloads[i] * n
            style = {"fc": "white", "ec": GREY, "lw": 0.7, "gid": f"preload-{i + 1}", "zorder": 3.5}
            axes.add_patch(arrow(away, p - 3.2 * unit * n * (scene.preloads[i] > 12 * unit),
                                 1.6 * unit, **style))  # fmt: skip
            labels.avoid(away + s * (p - away) for s in np.linspace(0, 1, 24))
        arm = scene.arms[i]
        if arm is not None:
            style = {"fc": BLACK, "ec": "none", "gid": f"force-{i + 1}", "zorder": 5.5}
            axes.add_patch(arrow(p, p + arm, unit, **style))
            labels.avoid(p + s * arm for s in np.linspace(0, 1, 12))
        if scene.found is not None:
            # Marks of contacts at one place stand one behind the other.
            again = seen[contact.point] = seen.get(contact.point, -1) + 1
            place = p - 7.5 * unit * again * n
            axes.add_patch(
                mark(scene.states[i], place, t, 6.0 * unit, ec=BLACK, lw=0.8,
                     gid=f"mark-{i + 1}", zorder=6)
            )  # fmt: skip
            labels.avoid(
                place + 3 * unit * np.array([a, b]) for a in (-1, 0, 1) for b in (-1, 0, 1)
            )


def _paint_load(axes: Any, scene: Scene, unit: float, labels: Labels) -> None:
    o, reach = scene.origin, 3 * unit
    for way in (np.array([reach, 0]), np.array([0, reach])):
        axes.plot(*np.array([o - way, o + way]).T, color=GREY, lw=0.6, zorder=4.5, gid="origin")
    if scene.applied is None:
        return
    around = [o]
    if scene.load is not None:
        style = {"fc": VERMILION, "ec": "none", "gid": "wrench-force", "zorder": 5}
        axes.add_patch(arrow(o, o + scene.load, 1.5 * unit, **style))
        labels.avoid(o + s * scene.load for s in np.linspace(0, 1, 12))
        around = [o + scene.load, o + 0.5 * scene.load, o]
    torque = scene.applied[2]
    if torque:
        style = {"color": VERMILION, "gid": "wrench-torque", "zorder": 5}
        for patch in turning_arrow(o, ARC, 1 if torque > 0 else -1, unit, **style):
            axes.add_patch(patch)
        angles = np.linspace(0, 2 * math.pi, 24)
        labels.avoid(o + ARC * np.array([math.cos(a), math.sin(a)]) for a in angles)
        around.append(o + ARC * np.array([0, 1]))
    if scene.load is not None or torque:
        wanted = [a + 9 * unit * _way(k) for a in around for k in range(8)]
        at = labels.place("w", wanted)
        axes.text(*at, "w", size=FONT, color=VERMILION, ha="center", va="center",
                  style="italic", weight="bold", zorder=7)  # fmt: skip


def _paint_numbers(axes: Any, scene: Scene, unit: float, labels: Labels) -> None:
    """Write the number of every contact outside the object, in its preload's neighbourhood."""
    for i, (p, n) in enumerate(zip(scene.places, scene.normals, strict=True)):
        t = np.array([-n[1], n[0]])
        wanted = [
            p - out * unit * n + side * unit * t
            for side in (0, 9, -9, 13, -13, 18, -18)
            for out in (9, 13, 18, 24)
        ]
        at = labels.place(str(i + 1), wanted)
        axes.text(*at, str(i + 1), size=FONT, ha="center", va="center", zorder=7,
                  gid=f"number-{i + 1}")  # fmt: skip


def _way(k: int) -> Floats:
    return np.array([math.cos(k * math.pi / 4 + 0.4), math.sin(k * math.pi / 4 + 0.4)])


def _bar(scene: Scene, per_unit: float) -> tuple[float, str] | None:
    """Return the length in millimetres of the bar for a round force, and its label."""
    if not scene.reference:
        return None
    largest = rounded(scene.reference)
    force = nice(largest) if largest and math.isfinite(largest) else scene.reference
    share = float(force / scene.reference) / scene.longest
    unit = f" {scene.grasp.units.force}" if scene.grasp.units else ""
    return share * FORCE * per_unit, f"force {number(force)}{unit}"


def _describe(scene: Scene, legend: Legend) -> None:
    """Say in words and keys what is drawn."""
    for line, emphasis in _lines(scene):
        legend.line(line, emphasis)
    for kind, text, shown in _keys(scene):
        if shown:
            legend.key(kind, text)


def _lines(scene: Scene) -> Iterator[tuple[str, bool]]:
    verdict, found = scene.verdict, scene.found
    if verdict is None:
        return
    yield f"w = {vector(verdict.wrench)}", False
    if scene.moved:
        assert scene.applied is not None
        torque = number(scene.applied[2])
        yield f"drawn about the middle of the contacts, torque {torque}", False
    if found is None:
        yield "no equilibrium", True
        return
    factor = "" if scene.step is None else f", drawn × {number(scene.step)}"
    yield f"motion d = {vector(found.motion)}{factor}", False
    pieces = verdict.equilibria
    if len(pieces) > 1:
        yield f"equilibrium {pieces.index(found) + 1} of {len(pieces)}", False
    if not found.unique:
        what = "the motion is" if found.forces_determined else "motion and forces are"
        yield f"{what} not determined: least norm shown", False


def _keys(scene: Scene) -> Iterator[tuple[str, str, bool]]:
    """Yield kind, text, and whether the picture has any."""
    states = {state.rstrip("+-") for state in scene.states}
    yield "cone", "friction cone", bool(scene.places)
    yield "preload", "preload", any(scene.preloads)
    yield "wrench", "applied wrench w", scene.verdict is not None and any(scene.verdict.wrench)
    yield "force", "contact force", any(arm is not None for arm in scene.arms)
    for name in ("stick", "slip", "detached"):
        yield name, name, name in states
    kind = "shift" if scene.curve is None else "motion"
    yield kind, "virtual motion", scene.step is not None
