"""A grasp in space as a picture, and the proof that a wrench is not resisted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLACK, GREY, PALE
from arrangement.drawing.registry import Vector
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.labels import Labels
from arrangement.drawing.scene.places import near
from arrangement.drawing.scene.scene import AROUND, Key, Legend, Scene
from arrangement.drawing.solids.depth_tree import SolidSheet
from arrangement.drawing.solids.sight import (
    best_view,
    picture_axes,
    turned,
    unit,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.drawing.solids.surface import Patch, rounded
from arrangement.numbers.exact import IntegerVector
from equilibrium.certificate.leaves import spatial_leaves
from equilibrium.decide import NOT_RESISTED
from equilibrium.decide.solver import solve
from equilibrium.model.displacement import NOT_SMALL, displacement_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.style import (
    CONE_EDGE,
    CONE_FILL,
    Wrench,
    explain_grasp,
    explain_scale,
    name_wrench,
    nice_near,
    symbol,
)

from .solid_grasp import INKS, SolidGrasp

#: Of faces of the body that look at the viewer: what is inside shines through.
_GLASS = PALE + "70"
#: Edges of a stated body, of the hull of the contacts, and what is behind either.
_STATED: dict[str, Any] = {"ec": BLACK, "lw": 0.7, "role": "edge"}
_INDICATED = {**_STATED, "ls": (0, (5, 2.5))}
_HIDDEN: dict[str, Any] = {"ec": GREY, "lw": 0.5, "ls": (0, (3, 2.5)), "role": "hidden"}
_DASHES: dict[str, Any] = {"axis": (0, (6, 2, 1, 2)), "link": (0, (5, 2.5))}


def solved_in_space(
    grasp: Grasp, wrench: Wrench | None, max_displacement: Any = None
) -> tuple[SolidGrasp, str]:
    """Return the pieces of a grasp, with the equilibrium under a wrench, and what is said of it."""
    if wrench is None:
        return SolidGrasp(grasp), ""
    verdict = solve(grasp, wrench, max_displacement=max_displacement)
    found = verdict.solution
    if found is None:
        answer = verdict.verdict + displacement_words(verdict.max_displacement)
        note = "; ".join(filter(None, (answer, verdict.doubt)))
        return SolidGrasp(grasp, wrench=verdict.wrench), note
    pairs = zip(grasp, found.forces, strict=True)
    forces = [contact.total_force(shares) for contact, shares in pairs]
    note = "; ".join(filter(None, (NOT_SMALL if verdict.warnings else "", verdict.doubt)))
    return SolidGrasp(grasp, list(found.motion), forces, verdict.wrench), note


def drawn_in_space(
    solid: SolidGrasp, direction: Vector | None, azimuth: float, width: float, note: str
) -> Scene:
    """Return the picture; see `equilibrium.pictures.grasp.grasp.draw_grasp`.

    Elements: ``body-3``, ``cone-1-4``, ``force-2-17`` and so on: kind, contact, piece.

    Args:
        note: what is said of the answer, if anything.
    """
    towards = clear_side(solid) if direction is None else view_direction(direction)
    return _SpatialGraspPicture(solid, turned(towards, azimuth), width, note).scene


def clear_side(solid: SolidGrasp) -> IntegerVector:
    """Return a direction from above from which normals and forces are seen from the side."""
    ways = [*solid.normals, *(a.end - a.start for a in solid.arrows() if not a.headless)]
    along = unit(np.reshape(ways or np.zeros((1, 3)), (-1, 3)))

    def score(seen: Sequence[IntegerVector]) -> Floats:
        units = unit_vectors(seen)
        found: Floats = 0.02 * units[:, 0] - (np.abs(units @ along.T) ** 4).mean(axis=1)
        return found

    found = views((-9, -7, -4, 4, 7, 9), (-9, -7, -4), (4, 6))
    return best_view([v for v in found if abs(v[0]) != abs(v[1])], score)


class _SpatialGraspPicture(SolidSheet):
    """Puts the pieces on a scene, back to front."""

    def __init__(self, solid: SolidGrasp, towards: IntegerVector, width: float, note: str) -> None:
        self.solid, self.stated = solid, solid.body[2]
        nodes = solid.tree(np.array(towards, float))
        held = [rounded(p.corners) for node in nodes for p in node.patches]
        content = np.concatenate([np.zeros((1, 3)), *held]) @ picture_axes(towards).T
        super().__init__(towards, width, (content, AROUND), tallest=None)
        self.count, self.labels = 0, Labels(self.scene)
        for z, patches in self.layers(nodes, 1):
            for patch in patches:
                self._patch(patch, z)
        self._pads()
        self._numbers()
        self._describe(note)

    def _patch(self, patch: Patch, z: float) -> None:
        self.count += 1
        kind, gid = patch.name.partition("-")[0], f"{patch.name}-{self.count}"
        corners = self.at_exact(patch.corners)
        ahead = self.faces(patch)
        edges = [self.at_exact(edge) for edge in patch.edges]
        self.labels.avoid(*edges)
        if kind == "body":
            if ahead:
                self.scene.polygon(corners, fc=_GLASS, ec="none", zorder=z, gid=gid, role="region")
            style = _HIDDEN if not ahead else _STATED if self.stated else _INDICATED
            for edge in edges:
                self.scene.line(edge, zorder=z, gid=gid, capstyle="round", **style)
            return
        if kind == "cone":
            self.scene.polygon(corners, fc=CONE_FILL, ec="none", zorder=z, gid=gid, role="region")
        elif len(corners) > 2:
            ink = INKS[kind]
            fill = "#ffffff" if kind == "preload" else ink
            self.scene.polygon(
                corners, fc=fill, ec=ink, lw=0.3, joinstyle="round", zorder=z, gid=gid, role="arrow"
            )
        ink, wide = INKS.get(kind, CONE_EDGE), 0.5 if kind in ("cone", "normal") else 1.2
        wide = {"preload": 0.7, "axis": 0.8, "link": 0.5}.get(kind, wide)
        dashes = _DASHES.get(patch.name, "solid")
        for edge in edges:
            self.scene.line(edge, ec=ink, lw=wide, ls=dashes, zorder=z, gid=gid, role="arrow")

    def _pads(self) -> None:
        """Mark the contact points by small discs in the tangent planes."""
        for i, (p, c) in enumerate(zip(self.solid.places, self.solid.grasp, strict=True), 1):
            first, second = (np.array([float(x) for x in t]) for t in c.tangents)
            turns = np.linspace(0, 2 * math.pi, 20, endpoint=False)[:, None]
            disc = self.at(p + 0.035 * (np.cos(turns) * first + np.sin(turns) * second))
            look: dict[str, Any] = {"fc": BLACK, "ec": BLACK, "lw": 0.8, "role": "point"}
            self.scene.polygon(disc, zorder=3, gid=f"pad-{i}", **look)

    def _numbers(self) -> None:
        """Write the numbers of the contacts, those at one point together, and name the wrench."""
        labels = self.labels
        for k, members, text in self.solid.groups:
            out = -(self.axes @ self.solid.normals[members].sum(axis=0))[:2]
            labels.write(text, near(self.at(self.solid.places[k]), out), gid=f"number-{k + 1}")
        for arrow in self.solid.arrows():
            if arrow.name == "wrench-force" or (
                arrow.name == "wrench-torque"
                and not arrow.headless
                and not any(self.solid.wrench[:3])
            ):
                name_wrench(labels, [self.at(arrow.end)])

    def _describe(self, note: str) -> None:
        solid, legend = self.solid, self.scene.legend
        if note:
            legend.line(note, True)
        explain_grasp(legend, solid.grasp, solid.wrench, any(map(any, solid.forces)))
        if solid.largest_force:
            force = nice_near(Fraction(solid.largest_force))
            explain_scale(legend, solid.grasp, force, float(force) * solid.force_scale * self.scale)
        if solid.motion and solid.screw is None:
            legend.line(motion_text(solid))
        elif solid.motion:
            legend.key(symbol("shift"), motion_text(solid))


def motion_text(solid: SolidGrasp) -> str:
    """Return what the arrows of the motion show."""
    if solid.screw is None:
        return "no motion"
    return f"motion, and the slips of the contacts: {screw_text(solid)}"


def screw_text(solid: SolidGrasp) -> str:
    """Return the motion in words: a turn about an axis with its pitch, or a shift."""
    screw = solid.screw
    if screw is None or screw.pitch is None:
        return "a translation" if screw else "no motion"
    unit = f" {solid.grasp.units.length}" if solid.grasp.units else ""
    far = " about an axis outside the picture" if solid.axis_is_far else ""
    pitch = f"{screw.pitch:.3g}".replace("-", "−")
    return f"a rotation{far}" + (f", pitch {pitch}{unit} a radian" if screw.pitch else "")


#: This many leaves are shown, side by side.
_SHOWN = 3
#: The largest width of each, in millimetres.
_PANEL = 88.0
_LAMBDA = "virtual motion λ: its axis, and how it moves the contacts"


def proof_in_space(grasp: Grasp, wrench: Wrench, width: float) -> Scene:
    """Return the picture; see `equilibrium.pictures.grasp.proof.draw_proof`.

    Raises:
        GraspError: the wrench is resisted, or that is undecided.
    """
    verdict = solve(grasp, wrench)
    if verdict.verdict != NOT_RESISTED:
        raise GraspError(
            f"the wrench is {verdict.verdict}, so there is no proof that it is not; draw the grasp"
        )
    leaves = list(spatial_leaves(verdict.proof))
    if not leaves:
        raise GraspError(
            "contacts and wrench lie in one plane, and so does the proof; draw the planar grasp"
        )
    shown = leaves[:_SHOWN]
    towards = clear_side(SolidGrasp(grasp, wrench=verdict.wrench))
    panel = min(width / len(shown), _PANEL)
    solids = [SolidGrasp(grasp, motion, (), verdict.wrench, virtual=True) for _, motion, _ in shown]
    panels = [drawn_in_space(solid, towards, 0.0, panel, "") for solid in solids]
    scene = Scene(panel * len(panels), max(part.paper[1] for part in panels))
    for k, part in enumerate(panels):
        keys = part.legend.keys
        part.legend = Legend(keys=[] if k else [*keys[:-1], Key(*keys[-1][:2], _LAMBDA)])
        scene.place(part, k * scene.width / len(panels), (scene.height - part.height) / 2)
    for k, (solid, (states, motion, _)) in enumerate(zip(solids, shown, strict=True), 1):
        work = sum(a * b for a, b in zip(motion, verdict.wrench, strict=True))
        against = ", ".join(f"{i + 1} {text}" for i, text in sorted(states.items()))
        scene.legend.line(
            f"{k} of {len(leaves)}: {against or 'all contact states'}; λ is "
            f"{screw_text(solid)}; the load does work {LABEL.number(work)}"
        )
    return scene
