"""The grasp as a picture: object, contacts, friction cones, preload, wrench, forces, motion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.scene.curves import flattened, ring
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import Labels
from arrangement.drawing.scene.places import near
from arrangement.drawing.scene.scene import AROUND, Legend, Scene, arrow, fitted, turning_arrow
from arrangement.drawing.views import Corner, Exact, Vector, picture
from equilibrium.decide.solver import Solver
from equilibrium.model.displacement import NOT_SMALL, displacement_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Solution
from equilibrium.wrench_sets.margin import limit_words

from .layout import ARC, FORCE, Layout, displaced
from .space_grasp import drawn_in_space, solved_in_space
from .style import (
    CONE_EDGE,
    CONE_FILL,
    Wrench,
    explain_grasp,
    explain_scale,
    mark,
    name_wrench,
    nice_near,
    symbol,
)


@picture(20.0)
def draw_grasp(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    outline: Iterable[Corner] | None = None,
    equilibrium: int = 1,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    max_displacement: Exact | None = None,
    width: float = 88.0,
) -> Scene:
    """Draw contacts with friction cones and preloads; with a wrench, the equilibrium too.

    Forces are those on the object; all arrows of forces have one scale, which the bar states. The
    mark of a contact shows by shape its state at the motion drawn. The virtual motion is drawn as
    the displaced outline (of a grasp without outline, as arrows at the contacts), to first order,
    by a factor that is stated. The outline is that of the grasp; where none is stated, it is dashed
    and only indicative (see `body`), and where no simple curve passes through the contacts, dashed
    lines join them.
    Where the origin of the frame is far from the contacts, the wrench is carried to their middle.

    A grasp in space is drawn from a direction. Hidden edges of its body are dashed, what is behind
    or inside the body shines through; without a mesh as outline, dashed lines show the hull of the
    contacts. The motion is drawn as a turn about an axis with its pitch, and as slips of contacts.

    Args:
        grasp: contacts; none, coincident ones and coordinates of any size are possible.
        wrench: applied (f_x, f_y, tau), the torque about the origin, or six numbers in space; if
            omitted, none acts and nothing is solved.
        outline: corners of the object, exact, instead of the outline of the grasp, in the plane.
        equilibrium: which of the equilibria found (see `solve`), from 1, in the plane.
        camera: exact vector to the viewer, in space; if omitted, one from above that sees forces
            from the side.
        azimuth: degrees by which the viewer moves to the right, in space.
        max_displacement: exact; only equilibria up to it count, see `solve`.

    Raises:
        GraspError: a bad outline, or no such equilibrium.
    """
    if grasp.dimension == 3:
        if outline is not None or equilibrium != 1:
            raise GraspError("outline and equilibrium are for grasps in the plane; leave them out")
        solid, note = solved_in_space(grasp, wrench, max_displacement)
        return drawn_in_space(solid, camera, azimuth, width, note)
    if camera is not None or azimuth:
        raise GraspError("camera, azimuth, .gif and .mp4 are for grasps in space; leave them out")
    if wrench is None and equilibrium != 1:
        raise GraspError("without a wrench nothing is solved; give one with the equilibrium")
    solver = Solver(grasp, max_displacement)
    verdict = None if wrench is None else solver.solve(wrench)
    scene = drawn(Layout(grasp, verdict, outline, equilibrium), width)
    for line in () if verdict is None else limit_words(solver, verdict.wrench):
        scene.legend.line(line)
    return scene


def _content(layout: Layout) -> Floats:
    """Return points whose box holds all that is drawn but labels."""
    held = [np.array([layout.origin])]
    if layout.curve is not None:
        held.append(flattened(layout.curve))
        if layout.step is not None:
            held.append(displaced(layout, held[-1]))
    held += layout.cones
    for p, n, preload, arm in zip(
        layout.places, layout.normals, layout.preloads, layout.arms, strict=True
    ):
        t = 0.1 * np.array([-n[1], n[0]])
        held.append(np.array([p - max(preload, 0.1) * n, p - t, p + t]))
        held.append(np.array([p if arm is None else p + arm]))
    if layout.load is not None:
        held.append(np.array([layout.origin + layout.load]))
    if layout.applied is not None and layout.applied[2]:
        held.append(layout.origin + ARC * 1.3 * np.array([[1, 1], [-1, -1]]))
    if not layout.places:
        held.append(np.array([[-1.0, -1.0], [1.0, 1.0]]))
    return np.concatenate(held)


def drawn(layout: Layout, width: float, tallest: float | None = None) -> Scene:
    """Return the picture; see `fitted` for its size."""
    scene, scale, shift = fitted(width, (_content(layout), AROUND), tallest=tallest)
    _describe(layout, scene.legend, scale)
    picture = GraspPicture(layout, scene, scale, shift)
    picture.body()
    picture.contacts()
    picture.wrench()
    picture.letter()
    picture.numbers()
    return scene


class GraspPicture:
    """Puts a layout on a scene: a place p on paper at ``scale * p + shift``."""

    def __init__(self, layout: Layout, scene: Scene, scale: float, shift: Floats) -> None:
        self.layout, self.scene, self.scale, self.shift = layout, scene, scale, shift
        self.labels = Labels(scene)
        self.places = [self.at(place) for place in layout.places]
        self.ends: list[Floats] = []

    def at(self, places: Any) -> Floats:
        """Return places on paper in points of the scene."""
        points: Floats = self.scale * np.asarray(places) + self.shift
        return points

    def body(self) -> None:
        """Draw the outline, or links between the contacts, as they are and displaced."""
        layout, scene = self.layout, self.scene
        if layout.curve is not None:
            dashes = "solid" if layout.given else (0, (5, 2.5))
            curve = self.at(layout.curve)
            scene.curve(curve, fc=PALE, ec="none", gid="body", zorder=0)
            scene.curve(curve, fill=False, ec=GREY, lw=0.7, ls=dashes, gid="outline", zorder=2)
            self.labels.avoid(flattened(curve))
            if layout.step is not None:
                moved = self.at(displaced(layout, layout.curve))
                style = {"lw": 0.9, "ls": (0, (1, 1.5)), "gid": "motion", "role": "arrow"}
                scene.curve(moved, fill=False, ec=BLUE, zorder=2.5, **style)
                self.labels.avoid(flattened(moved))
            return
        middle = self.at(np.mean(layout.places, axis=0) if layout.places else layout.origin)
        for i, place in enumerate(self.places):
            scene.line(
                [place, middle], ec=GREY, lw=0.5, ls=(0, (5, 2.5)), gid=f"link-{i + 1}", zorder=0.5
            )
            self.labels.avoid([place, middle])
        if layout.step is not None:
            ends = self.at(displaced(layout, np.array(layout.places)))
            for i, (start, end) in enumerate(zip(self.places, ends, strict=True)):
                if np.linalg.norm(end - start) > 1:
                    self.labels.avoid(
                        arrow(
                            scene, start, end, fc=BLUE, ec="none", gid=f"motion-{i + 1}", zorder=5
                        )
                    )

    def contacts(self) -> None:
        """Draw cones, pads, preloads, forces and the marks of the states."""
        layout, scene, labels = self.layout, self.scene, self.labels
        seen: dict[Any, int] = {}
        for i, (contact, p, n) in enumerate(
            zip(layout.grasp, self.places, layout.normals, strict=True)
        ):
            t = np.array([-n[1], n[0]])
            rim = self.at(np.vstack([layout.places[i], layout.cones[i]]))
            style = {"fc": CONE_FILL, "ec": CONE_EDGE, "lw": 0.5, "gid": f"cone-{i + 1}"}
            scene.polygon(rim, zorder=1, **style)
            look: dict[str, Any] = {"ec": CONE_EDGE, "lw": 0.5, "ls": (0, (6, 2, 1, 2))}
            scene.line([p, rim[len(rim) // 2]], gid=f"normal-{i + 1}", zorder=1.1, **look)
            pad = 0.07 * self.scale * t
            look = {"ec": BLACK, "lw": 1.6, "capstyle": "butt", "role": "point"}
            scene.line([p - pad, p + pad], gid=f"pad-{i + 1}", zorder=3, **look)
            labels.avoid([*rim, p], [p, rim[len(rim) // 2]], [p - pad, p + pad])
            preload, arm = layout.preloads[i] * self.scale, layout.arms[i]
            if preload > 0:
                away = p - preload * n
                tip = p - 3.2 * n * (preload > 12)
                look = {"ec": GREY, "lw": 0.7, "gid": f"preload-{i + 1}", "zorder": 3.5}
                edge = arrow(scene, away, tip, 1.6, fc="white", **look)
                labels.avoid(edge)
            if arm is not None:
                look = {"fc": BLACK, "ec": "none", "gid": f"force-{i + 1}", "zorder": 5.5}
                edge = arrow(scene, p, p + self.scale * arm, 1.0, **look)
                labels.avoid(edge)
            if layout.states:
                # Marks of contacts at one place stand one behind the other.
                again = seen[contact.point] = seen.get(contact.point, -1) + 1
                place = p - 7.5 * again * n
                mark(scene, layout.states[i], place, t, gid=f"mark-{i + 1}", zorder=6)
                labels.avoid(ring(place, 4.0, 13), place + np.array([[-4, 0], [4, 0]]))

    def wrench(self) -> None:
        """Draw the origin and the applied wrench."""
        layout, scene, labels = self.layout, self.scene, self.labels
        o = self.at(layout.origin)
        for way in (np.array([3, 0]), np.array([0, 3])):
            scene.line([o - way, o + way], ec=GREY, lw=0.6, zorder=4.5, gid="origin")
        if layout.applied is None:
            return
        if layout.load is not None:
            load = self.scale * layout.load
            style: dict[str, Any] = {"fc": VERMILION, "ec": "none", "gid": "wrench-force"}
            labels.avoid(arrow(scene, o, o + load, zorder=5, **style))
            self.ends = [o + load, o + 0.5 * load, o]
        torque, reach = layout.applied[2], ARC * self.scale
        if torque:
            turn = 1 if torque > 0 else -1
            turning_arrow(scene, o, reach, turn, color=VERMILION, gid="wrench-torque", zorder=5)
            labels.avoid(ring(o, reach, 25), o + reach * np.array([[-1, 0], [1, 0]]))
            self.ends += [o + reach * np.array(way) for way in ((0, 1), (0, -1), (1, 0), (-1, 0))]

    def letter(self) -> None:
        """Write w beside the wrench, never inside the arc of its torque."""
        if self.ends and self.layout.applied is not None:
            clear = ARC * self.scale + 7 if self.layout.applied[2] else 0.0
            name_wrench(self.labels, self.ends, (self.at(self.layout.origin), clear))

    def numbers(self) -> None:
        """Write the number of every contact outside the object, near its preload."""
        grasp, frame = self.layout.grasp, self.layout.frame
        for i, (group, contact) in enumerate(zip(grasp.groups, grasp.joined(), strict=True), 1):
            place, away = self.at(frame.paper(contact.point)), -self.layout.normals[group.start]
            self.labels.write(str(i), near(place, away), gid=f"number-{i}")


def _describe(layout: Layout, legend: Legend, scale: float) -> None:
    """Describe in words and keys what is drawn, and the scale of forces."""
    for line, emphasis in _lines(layout):
        legend.line(line, emphasis)
    applied = () if layout.verdict is None else layout.verdict.wrench
    explain_grasp(legend, layout.grasp, applied, any(arm is not None for arm in layout.arms))
    states = {state.rstrip("+-") for state in layout.states}
    for name in ("stick", "slip", "detached"):
        if name in states:
            legend.key(symbol(name), name)
    if layout.found is not None and layout.step is not None:
        text = (
            f"motion (x, y, r) = {LABEL.vector(layout.found.motion)} × {LABEL.number(layout.step)}"
        )
        legend.key(symbol("shift" if layout.curve is None else "motion"), text)
    if layout.reference:
        force = nice_near(layout.reference)
        share = float(force / layout.reference) / layout.longest
        explain_scale(legend, layout.grasp, force, share * FORCE * scale)


def _lines(layout: Layout) -> Iterator[tuple[str, bool]]:
    verdict, found = layout.verdict, layout.found
    if verdict is None or not layout.by_model:
        return
    if layout.moved:
        assert layout.applied is not None
        torque = LABEL.number(layout.applied[2])
        yield f"w drawn about the middle of the contacts, torque {torque}", False
    if found is not None and layout.step is None:
        yield "no motion", False
    if verdict.warnings:
        yield NOT_SMALL, True
    if verdict.doubt:
        yield verdict.doubt, True
    if found is None:
        yield f"no equilibrium{displacement_words(verdict.max_displacement)}", True
    elif isinstance(found, Solution):
        yield "the equilibrium found; there may be others", False
    else:
        notes = []
        if len(verdict.equilibria) > 1:
            place = verdict.equilibria.index(found) + 1
            notes.append(f"equilibrium {place} of {len(verdict.equilibria)}")
        if not found.unique:
            what = "motion" if found.forces_determined else "motion and forces"
            notes.append(f"{what} not determined: least norm shown")
        if notes:
            yield "; ".join(notes), False
