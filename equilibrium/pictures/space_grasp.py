"""A grasp in space as a picture, a page and a model, and proofs about it as pictures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.labels import Labels, near
from arrangement.drawing.pages import PageFace, SolidPage, page_face
from arrangement.drawing.scene import AROUND, Floats, Key, Legend, PageMap, Scene, millimetres
from arrangement.drawing.solids.depth_tree import Node, SolidSheet, depth_tree
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes, volume
from arrangement.drawing.solids.sight import (
    best_view,
    picture_axes,
    turn_view,
    unit,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.drawing.solids.surface import Patch, float_points
from arrangement.drawing.views import Vector
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from arrangement.numbers.linear.rank import cross, cycle_edges
from equilibrium.certificate.leaves import spatial_leaves
from equilibrium.decide import NOT_RESISTED
from equilibrium.decide.solver import solve
from equilibrium.decide.verdict import Verdict
from equilibrium.model.displacement import NOT_SMALL, displacement_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Mesh, Sphere
from equilibrium.pictures.solid_pieces import (
    Arrow,
    arc,
    arrow_pieces,
    convex_hull,
    drawn_edges,
    flat,
    head_of,
    merge_faces,
    open_edges,
    segment,
)

from .body import Frame, frame_of
from .style import (
    CONE_EDGE,
    CONE_FILL,
    Wrench,
    explain_grasp,
    explain_scale,
    name_wrench,
    nice_near,
    symbol,
    wrench_text,
)

#: Lengths, where body and contacts fill [-1, 1]: cones, the largest force, slip and motion.
CONE, FORCE, MOVED = 0.3, 0.6, 0.3
#: Sides of a cone; at a smaller angle it is drawn as a line, in radians.
_SIDES, _THIN = 16, 1e-4
#: An axis farther than this from the middle is not drawn.
FAR = 1.8
#: Radius of the helix of a motion, and most turns of it.
_HELIX, _TURNS = 0.14, 2.0
#: Meshes of more facets are drawn as their convex hull.
_MOST_FACETS = 1500

#: Colours by the first word of a piece's name.
INKS = {
    "force": BLACK,
    "wrench": VERMILION,
    "slip": BLUE,
    "axis": BLUE,
    "preload": GREY,
    "link": GREY,
}


@dataclass(frozen=True)
class Screw:
    """A motion as a turn about an axis and a shift along it.

    Attributes:
        axis: unit vector; of a pure shift, its direction.
        point: on the axis, nearest to the middle of the picture; None for a shift.
        pitch: shift along the axis for each radian; None for a shift.
    """

    axis: Floats
    point: Floats | None
    pitch: float | None

    @classmethod
    def of(cls, motion: Sequence[float | Fraction]) -> Screw | None:
        """Return the screw of a motion ``(v, omega)``; None if it is 0. Lengths as in the grasp.

        >>> Screw.of((0, 0, 2, 0, 0, 1)).pitch
        2.0
        """
        exact = [Fraction(x) for x in motion]
        largest = max(map(abs, exact))
        if not largest:
            return None
        v, omega = (tuple(x / largest for x in part) for part in (exact[:3], exact[3:]))
        square = dot(omega, omega)
        if square < Fraction(1, 10**18):
            return cls(unit_vectors([v])[0], None, None)
        point = np.array([float(x / square) for x in cross(omega, v)])
        return cls(unit_vectors([omega])[0], point, float(dot(v, omega) / square))


@dataclass
class SolidGrasp:
    """What is drawn of a grasp in space.

    Attributes:
        grasp: contacts.
        motion: a motion (v, omega) to be shown, if there is one.
        forces: contact forces to be shown, none if there are none.
        wrench: applied, if one is shown.
        virtual: show how the motion moves the contact points, not how they slip.
    """

    grasp: Grasp
    motion: Sequence[float | Fraction] = ()
    forces: Sequence[Sequence[float | Fraction]] = ()
    wrench: RationalVector = ()
    virtual: bool = False
    frame: Frame = field(init=False)

    def __post_init__(self) -> None:
        self.frame = frame_of(self.grasp, self.grasp.outline)

    @cached_property
    def places(self) -> Floats:
        """(m, 3); the contact points."""
        return np.array([self.frame.paper(c.point) for c in self.grasp]).reshape(-1, 3)

    @cached_property
    def normals(self) -> Floats:
        """(m, 3); inward."""
        return np.array([[float(x) for x in c.normal] for c in self.grasp]).reshape(-1, 3)

    @property
    def groups(self) -> Iterator[tuple[int, list[int], str]]:
        """Yield the contacts at one place, a pad in its middle.

        The first point among `places`, the first points of all, and their numbers as a text.
        """
        contacts: dict[object, list[int]] = {}
        for i, contact in enumerate(self.grasp.joined()):
            contacts.setdefault(contact.point, []).append(i)
        for members in contacts.values():
            firsts = [self.grasp.groups[i].start for i in members]
            yield firsts[0], firsts, ", ".join(str(i + 1) for i in members)

    @cached_property
    def body(self) -> tuple[Floats, list[tuple[int, ...]], bool]:
        """Points and faces, counter-clockwise from outside, and whether it is the stated outline.

        Without an outline, or beyond 1500 facets, it is the convex hull, if that has a volume.
        """
        outline = self.grasp.outline
        if isinstance(outline, Sphere):
            return (
                *_ball(self.frame.paper(outline.centre), float(outline.radius / self.frame.half)),
                True,
            )
        if not isinstance(outline, Mesh):
            return (*convex_hull(self.places), False)
        points = np.array([self.frame.paper(p) for p in outline.vertices])
        faces = [tuple(face) for face in outline.faces]
        if faces and volume(points, faces) < 0:
            faces = [face[::-1] for face in faces]
        if len(outline.faces) > _MOST_FACETS:
            return (*convex_hull(points), False)
        return points, merge_faces(points, faces), True

    @cached_property
    def largest_force(self) -> float:
        """The largest contact force, preload or applied force; 0 without any."""
        sizes = [math.hypot(*map(float, f)) for f in self.forces]
        sizes += [math.hypot(*map(float, self.wrench[:3]))] if self.wrench else []
        sizes += [float(c.preload) for c in self.grasp]
        return max(sizes, default=0.0)

    @property
    def force_scale(self) -> float:
        """By what forces are multiplied: the largest one has the length `FORCE`."""
        return FORCE / self.largest_force if self.largest_force else 0.0

    @cached_property
    def screw(self) -> Screw | None:
        """The screw of the motion, in the coordinates of the grasp."""
        return Screw.of(self.motion) if self.motion else None

    @cached_property
    def slips(self) -> Floats:
        """(m, 3); how each contact point slips or moves, the longest `MOVED` long."""
        v, omega = (np.array(part, float) for part in (self.motion[:3], self.motion[3:]))
        points = np.array([[float(x) for x in c.point] for c in self.grasp]).reshape(-1, 3)
        moved = v + np.cross(omega, points)
        inward = np.einsum("ij,ij->i", moved, self.normals)[:, None] * self.normals
        slips = moved if self.virtual else moved - inward
        sizes = np.linalg.norm(slips, axis=1)
        slips[sizes < 1e-9 * np.linalg.norm(moved, axis=1)] = 0
        largest = float(np.linalg.norm(slips, axis=1).max(initial=0.0))
        scaled: Floats = slips * (MOVED / largest if largest else 0.0)
        return scaled

    def arrows(self) -> Iterator[Arrow]:
        """Yield the arrows: preloads, the wrench, forces, slips, the axis of the motion."""
        for i, (p, n) in enumerate(zip(self.places, self.normals, strict=True), 1):
            preload = float(self.grasp.contacts[i - 1].preload) * self.force_scale
            if preload:
                yield Arrow(f"preload-{i}", p - max(preload, 0.12) * n, p)
        for i, force in enumerate(self.forces, 1):
            arm = np.array([float(x) for x in force]) * self.force_scale
            if arm.any():
                yield Arrow(f"force-{i}", self.places[i - 1], self.places[i - 1] + arm)
        yield from self._wrench()
        if self.motion:
            for i, slip in enumerate(self.slips, 1):
                if slip.any():
                    yield Arrow(f"slip-{i}", self.places[i - 1], self.places[i - 1] + slip)
            yield from self._axis()

    def _wrench(self) -> Iterator[Arrow]:
        """Yield the applied force at the origin, and the torque as an arc around its axis."""
        origin = self.frame.paper((Fraction(0),) * 3)
        if np.abs(origin).max() > 2:
            return
        force, torque = (np.array(part, float) for part in (self.wrench[:3], self.wrench[3:]))
        if force.any():
            yield Arrow("wrench-force", origin, origin + force * self.force_scale)
        if torque.any():
            yield from arc("wrench-torque", origin, unit(torque), 0.25, 0.0, 0.75)

    @property
    def axis_is_far(self) -> bool:
        """Whether the motion is a turn about an axis that is outside the picture."""
        turns = self.screw is not None and self.screw.point is not None
        return turns and not any(arrow.name == "axis" for arrow in self._axis())

    def _axis(self) -> Iterator[Arrow]:
        if self.screw is None:
            return
        axis = self.screw.axis
        if self.screw.point is None or self.screw.pitch is None:
            yield Arrow("axis", -0.5 * MOVED * axis, 0.5 * MOVED * axis)
            return
        size = float(self.frame.half)
        point = self.screw.point / size - np.array(
            [float(c / self.frame.half) for c in self.frame.centre]
        )
        point = point - (point @ axis) * axis
        if float(np.linalg.norm(point)) > FAR:
            return
        yield Arrow("axis", point - 1.3 * axis, point + 1.3 * axis, headless=True)
        rise = 2 * math.pi * self.screw.pitch / size
        turns = min(0.75 if abs(rise) < 1e-9 else _TURNS, 1.6 / max(abs(rise), 1e-9))
        yield from arc("axis-turn", point, axis, _HELIX, rise, turns)

    @property
    def cones(self) -> Iterator[tuple[int, Floats, Floats]]:
        """Yield number, apex and rim of each friction cone; of one too thin the rim is a point."""
        for i, (c, p, n) in enumerate(zip(self.grasp, self.places, self.normals, strict=True), 1):
            angle = math.atan(float(c.friction))
            across, other = (np.array([float(x) for x in t]) for t in c.tangents)
            turns = np.linspace(0, 2 * math.pi, _SIDES, endpoint=False)[:, None]
            ring = np.cos(turns) * across + np.sin(turns) * other
            rim = p + CONE * (math.cos(angle) * n + math.sin(angle) * ring)
            yield i, p, rim if angle > _THIN else rim[:1]

    def patches(self, towards: Floats | None = None) -> list[Patch]:
        """Return all pieces.

        Args:
            towards: the viewer, see `drawn_edges`.
        """
        points, faces, _ = self.body
        drawn, pieces = drawn_edges(points, faces, towards), []
        for face in faces:
            shown = [(points[a], points[b]) for a, b in cycle_edges(face) if (a, b) in drawn]
            pieces += flat([points[a] for a in face], "body", shown)
        if not faces and len(self.places) > 1:
            middle = self.places.mean(axis=0)
            pieces += [p for place in self.places for p in segment(place, middle, "link")]
        for i, apex, rim in self.cones:
            if len(rim) == 1:
                pieces += segment(apex, rim[0], f"normal-{i}")
                continue
            for p, q in zip(rim, np.roll(rim, -1, axis=0), strict=True):
                pieces += flat([apex, p, q], f"cone-{i}", [(p, q)])
        for arrow in self.arrows():
            pieces += arrow_pieces(arrow)
        return pieces

    def tree(self, towards: Floats | None = None) -> list[Node[Patch]]:
        """Return the pieces in an order for painting; they may be cut."""
        return depth_tree(self.patches(towards))


#: Of faces of the body that look at the viewer: what is inside shines through.
_GLASS = PALE + "70"
#: Edges of a stated body, of the hull of the contacts, and what is behind either.
_STATED: dict[str, Any] = {"ec": BLACK, "lw": 0.7, "role": "edge"}
_INDICATED = {**_STATED, "ls": (0, (5, 2.5))}
_HIDDEN: dict[str, Any] = {"ec": GREY, "lw": 0.5, "ls": (0, (3, 2.5)), "role": "hidden"}
_DASHES: dict[str, Any] = {"axis": (0, (6, 2, 1, 2)), "link": (0, (5, 2.5))}


def _ball(centre: Floats, radius: float) -> tuple[Floats, list[tuple[int, ...]]]:
    """Return points and faces of a sphere, so fine that pictures show its silhouette alone."""
    rings, around = 24, 48
    heights, turns = (np.linspace(0, part * np.pi, n + 1) for part, n in ((1, rings), (2, around)))
    points = [
        centre + radius * np.array([np.sin(h) * np.cos(a), np.sin(h) * np.sin(a), -np.cos(h)])
        for h in heights[1:-1]
        for a in turns[:-1]
    ]
    low, high = len(points), len(points) + 1
    points += [centre + np.array([0, 0, side * radius]) for side in (-1, 1)]
    faces: list[tuple[int, ...]] = []
    for j in range(around):
        k, last = (j + 1) % around, (rings - 2) * around
        faces += [(low, k, j), (high, last + j, last + k)]
        for start in range(0, last, around):
            faces.append((start + j, start + k, start + around + k, start + around + j))
    return np.array(points), faces


def solved_in_space(
    grasp: Grasp, wrench: Wrench | None, max_displacement: Any = None
) -> tuple[SolidGrasp, str]:
    """Return the pieces of a grasp, with the equilibrium under a wrench, and what is said of it."""
    if wrench is None:
        return SolidGrasp(grasp), ""
    return decided_in_space(solve(grasp, wrench, max_displacement=max_displacement))


def decided_in_space(verdict: Verdict) -> tuple[SolidGrasp, str]:
    """Return the pieces of a grasp with the equilibrium of a verdict, and what is said of it."""
    grasp, solution = verdict.grasp, verdict.solution
    if solution is None:
        answer = verdict.verdict + displacement_words(verdict.max_displacement)
        note = "; ".join(filter(None, (answer, verdict.doubt)))
        return SolidGrasp(grasp, wrench=verdict.wrench), note
    pairs = zip(grasp, solution.forces, strict=True)
    forces = [contact.total_force(shares) for contact, shares in pairs]
    note = "; ".join(filter(None, (NOT_SMALL if verdict.warnings else "", verdict.doubt)))
    return SolidGrasp(grasp, list(solution.motion), forces, verdict.wrench), note


def drawn_in_space(
    solid: SolidGrasp, direction: Vector | None, azimuth: float, width: float, note: str
) -> Scene:
    """Return the picture; see `equilibrium.pictures.grasp.draw_grasp`.

    Elements: ``body-3``, ``cone-1-4``, ``force-2-17`` and so on: kind, contact, piece.

    Args:
        note: what is said of the answer, if anything.
    """
    towards = clear_side(solid) if direction is None else view_direction(direction)
    return _SpatialGraspPicture(solid, turn_view(towards, azimuth), width, note).scene


def clear_side(solid: SolidGrasp) -> IntegerVector:
    """Return a direction from above from which normals and forces are seen from the side."""
    directions = [*solid.normals, *(a.end - a.start for a in solid.arrows() if not a.headless)]
    along = unit(np.reshape(directions or np.zeros((1, 3)), (-1, 3)))

    def score(seen: Sequence[IntegerVector]) -> Floats:
        units = unit_vectors(seen)
        scores: Floats = 0.02 * units[:, 0] - (np.abs(units @ along.T) ** 4).mean(axis=1)
        return scores

    candidates = views((-9, -7, -4, 4, 7, 9), (-9, -7, -4), (4, 6))
    return best_view([v for v in candidates if abs(v[0]) != abs(v[1])], score)


class _SpatialGraspPicture(SolidSheet):
    """Puts the pieces on a scene, back to front."""

    def __init__(self, solid: SolidGrasp, towards: IntegerVector, width: float, note: str) -> None:
        self.solid, self.stated = solid, solid.body[2]
        nodes = solid.tree(np.array(towards, float))
        held = [float_points(p.corners) for node in nodes for p in node.patches]
        content = np.concatenate([np.zeros((1, 3)), *held]) @ picture_axes(towards).T
        super().__init__(towards, width, (content, AROUND), tallest=None)
        self.count, self.labels = 0, Labels(self.scene)
        middle, half = np.array([float(x) for x in solid.frame.centre]), float(solid.frame.half)
        self.scene.maps.append(PageMap(place=lambda p: self.at((p - middle) / half), size=3))
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
            explain_scale(
                legend, solid.grasp.units, force, float(force) * solid.force_scale * self.scale
            )
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
    if not screw.pitch:
        return f"a rotation{far}"
    return f"a screw motion{far}, pitch {pitch}{unit} per radian"


#: This many leaves are shown, side by side.
_SHOWN = 3
#: The largest width of each, in millimetres.
_PANEL = 88.0
_LAMBDA = "virtual motion λ: its axis, and how it moves the contacts"


def proof_in_space(grasp: Grasp, wrench: Wrench, width: float) -> Scene:
    """Return the picture; see `equilibrium.pictures.proof.draw_proof`.

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


_BODY = "#dfe6ea" + "60"
#: Radius of the shafts of arrows in a model.
_SHAFT = 0.008
_TELLS = ("cone", "normal", "preload", "force", "slip")


def grasp_page(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    camera: Vector | None = None,
    title: str | None = None,
) -> str:
    """Build a self-contained HTML page: a grasp in space, to rotate.

    Body, contacts, friction cones and preloads; with a wrench, forces and motion of an equilibrium.
    Under the pointer a cone or an arrow shows its contact in exact numbers.

    Args:
        grasp: contacts, in space.
        wrench: applied, six numbers; if omitted, none acts and nothing is solved.
        camera: exact vector to the viewer at first; if omitted, as for the picture.
        title: a heading; if omitted, the number of contacts.
    """
    solid, note = solved_in_space(grasp, wrench)
    towards = clear_side(solid) if camera is None else view_direction(camera)
    tree = solid.tree()
    number_of = grasp.size_words
    facts = [note or None, wrench_text(solid.wrench, grasp.units) if any(solid.wrench) else None]
    facts.append(motion_text(solid) if solid.motion else None)
    legend = [(CONE_EDGE, "friction cone")]
    legend += [(INKS["force"], "contact force")] * any(map(any, solid.forces))
    legend += [(INKS["wrench"], "applied wrench")] * any(solid.wrench)
    legend += [(INKS["slip"], "axis of the motion, and slips")] * (solid.screw is not None)
    reach = max(
        (
            float(np.linalg.norm(float_points(p.corners), axis=1).max())
            for n in tree
            for p in n.patches
        ),
        default=1.0,
    )
    return SolidPage(
        title if title is not None else f"A grasp in space, {number_of}",
        "; ".join(filter(None, facts)),
        str(grasp.units) if grasp.units else number_of,
        picture_axes(towards),
        reach,
        [node.map_patches(_face) for node in tree],
        [(name.capitalize(), _contact_facts(solid, i)) for i, name in enumerate(grasp.point_names)],
        legend,
        marks=[
            (solid.places[k] - 0.12 * solid.normals[members].mean(axis=0), text)
            for k, members, text in solid.groups
        ],
    ).text()


def _face(patch: Patch) -> PageFace:
    kind, _, contact = patch.name.partition("-")
    fill = _BODY if kind == "body" else CONE_FILL if kind == "cone" else INKS.get(kind, CONE_EDGE)
    number, faint = int(contact) - 1 if kind in _TELLS else -1, kind == "link"
    ink = BLACK if kind == "body" else INKS.get(kind, CONE_EDGE)
    return page_face(patch, fill, number, sheet=True, faint=faint, ink=ink)


def _contact_facts(solid: SolidGrasp, i: int) -> list[tuple[str, str]]:
    """Return what the page says of a contact."""
    contact = solid.grasp.contacts[i]
    facts = [("point", LABEL.vector(contact.point)), ("normal", LABEL.vector(contact.normal))]
    facts += [(name, LABEL.number(getattr(contact, name))) for name in contact.stated]
    if solid.forces:
        force = ", ".join(f"{float(x):.4g}" for x in solid.forces[i])
        facts.append(("force", f"({force})"))
    return facts


def grasp_model(
    grasp: Grasp, suffix: str, *, wrench: Wrench | None = None, size: float = 100.0
) -> bytes:
    """Build a grasp in space as a model: body, cones and arrows, one part each.

    With a wrench, the forces and the motion of an equilibrium. In GLB and OBJ each part has a name,
    such as ``force-2``, and in GLB the body shines through. A body that is not closed is left out.

    Args:
        grasp: contacts, in space.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        wrench: applied, six numbers; if omitted, none acts and nothing is solved.
        size: the longest side of the bounding box, in millimetres.

    Raises:
        InputError: a grasp without contacts.
    """
    solid, _ = solved_in_space(grasp, wrench)
    half = millimetres(size, "size") / 2
    points, faces, _ = solid.body
    closed = bool(faces) and not any(open_edges(faces))
    parts = [_part("body", [(points, faces)], _BODY, half)] if closed else []
    solids: dict[str, list[Any]] = {
        f"cone-{i}": [_prism(np.broadcast_to(apex, rim.shape), rim)]
        for i, apex, rim in solid.cones
        if len(rim) > 1
    }
    for arrow in solid.arrows():
        solids.setdefault(arrow.name, []).extend(_solids(arrow))
    for name, pieces in solids.items():
        colour = INKS.get(name.partition("-")[0], CONE_FILL)
        parts.append(_part(name, pieces, colour, half))
    if not parts:
        raise InputError("the grasp has no contacts and no body, so there is no model of it")
    return model_bytes(parts, suffix, f"a grasp in space, {grasp.size_words}")


def _part(
    name: str, solids: Iterable[tuple[Floats, Sequence[tuple[int, ...]]]], colour: str, half: float
) -> ClosedSurface:
    """Return several closed surfaces as one part."""
    points: list[Floats] = []
    faces: list[tuple[int, ...]] = []
    count = 0
    for own, cycles in solids:
        faces += [tuple(k + count for k in cycle) for cycle in cycles]
        points.append(own)
        count += len(own)
    return ClosedSurface(name, half * np.concatenate(points), tuple(faces), (colour,) * len(faces))


def _prism(base: Floats, top: Floats) -> tuple[Floats, list[tuple[int, ...]]]:
    """Return the solid between two rings, of which one may be the apex of a pyramid, repeated.

    Seen from the top both go counter-clockwise.
    """
    k = len(base)
    sides = [(j, (j + 1) % k, k + (j + 1) % k, k + j) for j in range(k)]
    faces = [tuple(range(k - 1, -1, -1)), tuple(range(k, 2 * k)), *sides]
    return np.vstack([base, top]), faces


def _solids(arrow: Arrow) -> Iterator[tuple[Floats, list[tuple[int, ...]]]]:
    """Yield the shaft of an arrow, unless the head is longer, and its head."""
    tip, ring = head_of(arrow)
    neck = ring.mean(axis=0)
    thin = (ring - neck) * (_SHAFT / float(np.linalg.norm(ring[0] - neck)))
    end = arrow.end if arrow.headless else neck
    if float((end - arrow.start) @ (arrow.end - arrow.start)) > 0:
        yield _prism(arrow.start + thin, end + thin)
    if not arrow.headless:
        yield _prism(ring, np.broadcast_to(tip, ring.shape))
