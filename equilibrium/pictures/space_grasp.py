"""A grasp in space as a picture, a page and a model, and proofs about it as pictures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import count
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

from .body import frame_of
from .solid_pieces import (
    Arrow,
    Cycle,
    Solid,
    arc,
    arrow_pieces,
    arrow_solids,
    ball,
    circle,
    convex_hull,
    drawn_edges,
    flat,
    merge_faces,
    open_edges,
    prism,
    segment,
)
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

#: Of pieces by the first word of their names: colours and widths of lines, and what fills faces.
INKS = {
    "body": BLACK,
    "cone": CONE_EDGE,
    "normal": CONE_EDGE,
    "force": BLACK,
    "wrench": VERMILION,
    "slip": BLUE,
    "axis": BLUE,
    "preload": GREY,
    "link": GREY,
}
_WIDTHS = {"cone": 0.5, "normal": 0.5, "link": 0.5, "preload": 0.7, "axis": 0.8}
_FILLS = {**INKS, "body": "#dfe6ea60", "cone": CONE_FILL}
#: Of pieces by their whole names.
_DASHES: dict[str, Any] = {"axis": (0, (6, 2, 1, 2)), "link": (0, (5, 2.5))}


@dataclass(frozen=True)
class Screw:
    """A motion as a turn about an axis and a shift along it.

    Attributes:
        axis: unit vector; of a pure shift, its direction.
        point: on the axis, nearest to the origin; None for a shift.
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
        if not any(exact):
            return None
        largest = max(map(abs, exact))
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
        places, normals: (m, 3); the contact points, and inward.
        screw: of the motion, in the coordinates of the grasp; None if nothing moves.
        force_scale: by what forces are multiplied: the largest one has the length `FORCE`.
    """

    grasp: Grasp
    motion: Sequence[float | Fraction] = ()
    forces: Sequence[Sequence[float | Fraction]] = ()
    wrench: RationalVector = ()
    virtual: bool = False

    def __post_init__(self) -> None:
        self.frame = frame_of(self.grasp, self.grasp.outline)
        self.places = np.array([self.frame.paper(c.point) for c in self.grasp]).reshape(-1, 3)
        self.normals = np.array([c.normal for c in self.grasp], float).reshape(-1, 3)
        self.screw = Screw.of(self.motion)
        sizes = [math.hypot(*map(float, f)) for f in (*self.forces, self.wrench[:3])]
        self.largest_force = max(*sizes, *(float(c.preload) for c in self.grasp), 0.0)
        self.force_scale = FORCE / self.largest_force if self.largest_force else 0.0

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
    def body(self) -> tuple[Floats, list[Cycle], bool]:
        """Points and faces, counter-clockwise from outside, and whether it is the stated outline.

        Without an outline, or beyond 1500 facets, it is the convex hull, if that has a volume.
        """
        outline = self.grasp.outline
        if isinstance(outline, Sphere):
            middle = self.frame.paper(outline.centre)
            return (*ball(middle, float(outline.radius / self.frame.half)), True)
        if not isinstance(outline, Mesh):
            return (*convex_hull(self.places), False)
        points = np.array([self.frame.paper(p) for p in outline.vertices])
        if len(outline.faces) > _MOST_FACETS:
            return (*convex_hull(points), False)
        faces = [tuple(face) for face in outline.faces]
        if faces and volume(points, faces) < 0:
            faces = [face[::-1] for face in faces]
        return points, merge_faces(points, faces), True

    @cached_property
    def slips(self) -> Floats:
        """(m, 3); how each contact point slips or moves, the longest `MOVED` long."""
        v, omega = (np.array(part, float) for part in (self.motion[:3], self.motion[3:]))
        points = np.array([c.point for c in self.grasp], float).reshape(-1, 3)
        moved = v + np.cross(omega, points)
        inward = np.einsum("ij,ij->i", moved, self.normals)[:, None] * self.normals
        slips: Floats = moved if self.virtual else moved - inward
        sizes = np.linalg.norm(slips, axis=1)
        slips[sizes < 1e-9 * np.linalg.norm(moved, axis=1)] = 0
        largest = float(np.linalg.norm(slips, axis=1).max(initial=0.0))
        return slips * (MOVED / largest if largest else 0.0)

    @cached_property
    def arrows(self) -> list[Arrow]:
        """Preloads, forces, the wrench, slips, and the axis of the motion."""
        arrows = []
        for i, (c, p, n) in enumerate(zip(self.grasp, self.places, self.normals, strict=True), 1):
            if preload := float(c.preload) * self.force_scale:
                arrows.append(Arrow(f"preload-{i}", p - max(preload, 0.12) * n, p))
        forces = np.array(self.forces, float) * self.force_scale
        arrows += self._at_contacts("force", forces)
        origin = self.frame.paper((Fraction(0),) * 3)
        if np.abs(origin).max() <= 2:
            force, torque = (np.array(part, float) for part in (self.wrench[:3], self.wrench[3:]))
            if force.any():
                arrows.append(Arrow("wrench-force", origin, origin + force * self.force_scale))
            if torque.any():
                arrows += arc("wrench-torque", origin, unit(torque), 0.25, 0.0, 0.75)
        if self.screw is not None:
            arrows += [*self._at_contacts("slip", self.slips), *self._axis(self.screw)]
        return arrows

    def _at_contacts(self, kind: str, arms: Floats) -> Iterator[Arrow]:
        for i, (place, arm) in enumerate(zip(self.places, arms, strict=False), 1):
            if arm.any():
                yield Arrow(f"{kind}-{i}", place, place + arm)

    def _axis(self, screw: Screw) -> Iterator[Arrow]:
        """Yield a shift, or the axis of a turn and a helix around it, unless it is far."""
        axis, size = screw.axis, float(self.frame.half)
        if screw.point is None or screw.pitch is None:
            yield Arrow("axis", -0.5 * MOVED * axis, 0.5 * MOVED * axis)
            return
        middle = np.array([float(c / self.frame.half) for c in self.frame.centre])
        point = screw.point / size - middle
        point = point - (point @ axis) * axis
        if float(np.linalg.norm(point)) > FAR:
            return
        yield Arrow("axis", point - 1.3 * axis, point + 1.3 * axis, headless=True)
        rise = 2 * math.pi * screw.pitch / size
        turns = min(0.75 if abs(rise) < 1e-9 else _TURNS, 1.6 / max(abs(rise), 1e-9))
        yield from arc("axis-turn", point, axis, _HELIX, rise, turns)

    @property
    def axis_is_far(self) -> bool:
        """Whether the motion is a turn about an axis that is outside the picture."""
        return self.screw is not None and not any(self._axis(self.screw))

    @cached_property
    def cones(self) -> list[tuple[str, Floats, Floats]]:
        """Name, apex and rim of each friction cone; if too thin, of the normal and its end."""
        cones = []
        for i, (c, p, n) in enumerate(zip(self.grasp, self.places, self.normals, strict=True), 1):
            angle = math.atan(float(c.friction))
            ring = math.sin(angle) * circle(c.tangents, _SIDES)
            rim: Floats = p + CONE * (math.cos(angle) * n + ring)
            cones.append((f"cone-{i}", p, rim) if angle > _THIN else (f"normal-{i}", p, rim[:1]))
        return cones

    def tree(self, towards: Floats | None = None) -> list[Node[Patch]]:
        """Return all pieces in an order for painting; they may be cut.

        Args:
            towards: the viewer, see `drawn_edges`.
        """
        points, faces, _ = self.body
        drawn, pieces = drawn_edges(points, faces, towards), []
        for face in faces:
            shown = [(points[a], points[b]) for a, b in cycle_edges(face) if (a, b) in drawn]
            pieces += flat(points[list(face)], "body", shown)
        if not faces and len(self.places) > 1:
            middle = self.places.mean(axis=0)
            pieces += [p for place in self.places for p in segment(place, middle, "link")]
        for name, apex, rim in self.cones:
            if len(rim) == 1:
                pieces += segment(apex, rim[0], name)
                continue
            for p, q in cycle_edges(list(rim)):
                pieces += flat([apex, p, q], name, [(p, q)])
        return depth_tree([*pieces, *(p for arrow in self.arrows for p in arrow_pieces(arrow))])


#: Of faces of the body that look at the viewer: what is inside shines through.
_GLASS = PALE + "70"
#: Edges of a stated body, of the hull of the contacts, and what is behind either.
_STATED: dict[str, Any] = {"ec": BLACK, "lw": 0.7, "role": "edge"}
_INDICATED = {**_STATED, "ls": (0, (5, 2.5))}
_HIDDEN: dict[str, Any] = {"ec": GREY, "lw": 0.5, "ls": (0, (3, 2.5)), "role": "hidden"}


def _corners(tree: Iterable[Node[Patch]]) -> Floats:
    return float_points(p for node in tree for patch in node.patches for p in patch.corners)


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
    directions = [*solid.normals, *(a.end - a.start for a in solid.arrows if not a.headless)]
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
        self.solid, tree = solid, solid.tree(np.array(towards, float))
        content = np.vstack([np.zeros((1, 3)), _corners(tree)]) @ picture_axes(towards).T
        super().__init__(towards, width, (content, AROUND), tallest=None)
        self.labels, numbers = Labels(self.scene), count(1)
        middle, half = np.array(solid.frame.centre, float), float(solid.frame.half)
        self.scene.maps.append(PageMap(place=lambda p: self.at((p - middle) / half), size=3))
        for z, patches in self.layers(tree, 1):
            for patch in patches:
                self._patch(patch, {"zorder": z, "gid": f"{patch.name}-{next(numbers)}"})
        for i, (p, c) in enumerate(zip(solid.places, solid.grasp, strict=True), 1):
            # A small disc in the tangent plane.
            disc = self.at(p + 0.035 * circle(c.tangents, 20))
            look: dict[str, Any] = {"fc": BLACK, "ec": BLACK, "lw": 0.8, "role": "point"}
            self.scene.polygon(disc, zorder=3, gid=f"pad-{i}", **look)
        for k, members, text in solid.groups:
            out = -(self.axes @ solid.normals[members].sum(axis=0))[:2]
            self.labels.write(text, near(self.at(solid.places[k]), out), gid=f"number-{k + 1}")
        heads = [a.end for a in solid.arrows if a.name.startswith("wrench") and not a.headless]
        if heads:
            name_wrench(self.labels, [self.at(heads[0])])
        self._describe(note)

    def _patch(self, patch: Patch, place: dict[str, Any]) -> None:
        """Draw a piece; its lines are those of a body, or have the look of its kind."""
        kind, corners, ahead = (
            patch.name.partition("-")[0],
            self.at_exact(patch.corners),
            self.faces(patch),
        )
        ink, style = INKS[kind], {"ec": INKS[kind], "lw": _WIDTHS.get(kind, 1.2)}
        style |= {"ls": _DASHES.get(patch.name, "solid"), "role": "arrow"}
        if kind == "body":
            stated = _STATED if self.solid.body[2] else _INDICATED
            style = {**(stated if ahead else _HIDDEN), "capstyle": "round"}
        if kind == "cone" or (kind == "body" and ahead):
            fill = CONE_FILL if kind == "cone" else _GLASS
            self.scene.polygon(corners, fc=fill, ec="none", role="region", **place)
        elif kind != "body" and len(corners) > 2:
            look = {"ec": ink, "lw": 0.3, "joinstyle": "round", "role": "arrow"}
            self.scene.polygon(corners, fc="#ffffff" if kind == "preload" else ink, **look, **place)
        for edge in map(self.at_exact, patch.edges):
            self.labels.avoid(edge)
            self.scene.line(edge, **style, **place)

    def _describe(self, note: str) -> None:
        solid, legend = self.solid, self.scene.legend
        if note:
            legend.line(note, True)
        explain_grasp(legend, solid.grasp, solid.wrench, any(map(any, solid.forces)))
        if solid.largest_force:
            force = nice_near(Fraction(solid.largest_force))
            length = float(force) * solid.force_scale * self.scale
            explain_scale(legend, solid.grasp.units, force, length)
        if solid.screw is not None:
            legend.key(symbol("shift"), motion_text(solid))
        elif solid.motion:
            legend.line(motion_text(solid))


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
    tree, number_of = solid.tree(), grasp.size_words
    facts = [note, wrench_text(solid.wrench, grasp.units) if any(solid.wrench) else ""]
    facts.append(motion_text(solid) if solid.motion else "")
    legend = [(CONE_EDGE, "friction cone")]
    legend += [(INKS["force"], "contact force")] * any(map(any, solid.forces))
    legend += [(INKS["wrench"], "applied wrench")] * any(solid.wrench)
    legend += [(INKS["slip"], "axis of the motion, and slips")] * (solid.screw is not None)
    return SolidPage(
        title if title is not None else f"A grasp in space, {number_of}",
        "; ".join(filter(None, facts)),
        str(grasp.units) if grasp.units else number_of,
        picture_axes(towards),
        float(np.linalg.norm(_corners(tree), axis=1).max(initial=0.0)) or 1.0,
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
    number = int(contact) - 1 if contact.isdigit() else -1
    look: dict[str, Any] = {"sheet": True, "faint": kind == "link", "ink": INKS[kind]}
    return page_face(patch, _FILLS[kind], number, **look)


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
    parts: dict[str, list[Solid]] = {"body": [(points, faces)]} if closed else {}
    for name, apex, rim in solid.cones:
        if len(rim) > 1:
            parts[name] = [prism(np.broadcast_to(apex, rim.shape), rim)]
    for arrow in solid.arrows:
        parts.setdefault(arrow.name, []).extend(arrow_solids(arrow))
    if not parts:
        raise InputError("the grasp has no contacts and no body, so there is no model of it")
    surfaces = [_surface(name, solids, half) for name, solids in parts.items()]
    return model_bytes(surfaces, suffix, f"a grasp in space, {grasp.size_words}")


def _surface(name: str, solids: Sequence[Solid], half: float) -> ClosedSurface:
    """Return several solids as one part of a model."""
    faces: list[Cycle] = []
    count = 0
    for points, cycles in solids:
        faces += [tuple(k + count for k in cycle) for cycle in cycles]
        count += len(points)
    colours = (_FILLS[name.partition("-")[0]],) * len(faces)
    corners = half * np.concatenate([points for points, _ in solids])
    return ClosedSurface(name, corners, tuple(faces), colours)
