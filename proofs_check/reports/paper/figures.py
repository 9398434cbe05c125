"""The seven figures of the paper, made by the package, with what is printed and what differs.

The notation at a contact is drawn here; the other figures are views.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from arrangement.drawing.colours import BLACK, BLUE, GREY, PALE, VERMILION
from arrangement.drawing.layout import panel_sheet
from arrangement.drawing.scene import POINTS, Floats, Place, Scene, arrow, turning_arrow
from arrangement.library.files.table import read_arrangement
from arrangement.pictures.dual import draw_dual
from arrangement.pictures.planes import draw_planes
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.methods.cones import cones
from equilibrium.methods.springs import linear_compliance
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Solution
from equilibrium.pictures.forces import draw_slice
from equilibrium.pictures.grasp import GraspLayout, draw_grasp, drawn

GREEN = "#00735a"
_DASHES = (0, (5, 2.5))
_BODY = ((-1, -1), (1, -1), (1, 0.4), (0.2, 1.1), (-1, 1.1))


class _Sketch:
    """A scene in units of length, of which one is some millimetres."""

    def __init__(self, window: tuple[float, float, float, float], unit: float) -> None:
        left, right, low, high = window
        self.scene = Scene((right - left) * unit, (high - low) * unit)
        self._scale, self._corner = unit * POINTS, np.array([left, low])

    def at(self, place: Place) -> Floats:
        place_on_paper: Floats = (np.array(place) - self._corner) * self._scale
        return place_on_paper

    def polygon(self, corners: Sequence[Place], **style: Any) -> None:
        self.scene.polygon([self.at(corner) for corner in corners], **style)

    def line(self, *places: Place, **style: Any) -> None:
        self.scene.line([self.at(place) for place in places], **{"lw": 0.7, **style})

    def arrow(self, start: Place, way: Place, colour: str) -> None:
        ends = self.at(start), self.at(np.add(start, way))
        arrow(self.scene, *ends, 1.1, fc=colour, ec="none", zorder=5)

    def dot(self, place: Place) -> None:
        self.scene.circle(self.at(place), 1.7, fc=BLACK, ec="none", zorder=6, role="point")

    def text(self, place: Place, text: str, colour: str = BLACK) -> None:
        self.scene.text(self.at(place), text, 8.0, color=colour)

    def body(self) -> None:
        self.polygon(_BODY, fc=PALE, ec=BLACK, lw=0.9, zorder=0, gid="body")
        self.dot((0, 0))


def contact_notation() -> Scene:
    """Return a contact with its frame, forces and cone and the motion; a force with its torque."""
    titles = ["contact frame, friction cone, motion", "torque is force times lever arm"]
    return panel_sheet([_frame(), _torque()], 2, titles)


def _frame() -> Scene:
    sketch = _Sketch((-2.0, 1.9, -1.6, 1.75), 20)
    sketch.body()
    tip, edges = (-1, 0), ((0.35, 0.675), (0.35, -0.675))
    sketch.polygon((tip, *edges), fc=f"{BLUE}24", ec="none", zorder=1, gid="cone")
    for edge in edges:
        sketch.line(tip, edge, ec=BLUE, ls=_DASHES)
    wedge = ((-1.05, 0), (-1.75, 0.16), (-1.75, -0.16))
    sketch.polygon(wedge, fc=GREY, ec="none", zorder=0, gid="finger")
    sketch.arrow(tip, (0.85, 0), BLUE)
    sketch.arrow(tip, (0, 0.85), VERMILION)
    sketch.dot(tip)
    sketch.arrow((0, 0), (0.1, 0.68), GREEN)
    style = {"color": GREEN, "gid": "motion", "zorder": 5}
    turning_arrow(sketch.scene, sketch.at((0, 0)), 0.24 * 20 * POINTS, 1, **style)
    for k, name in enumerate(("$x$", "$y$")):
        way = np.eye(2)[k]
        sketch.arrow((1.15, -1.35), 0.45 * way, BLACK)
        sketch.text(np.array((1.15, -1.35)) + 0.58 * way, name)
    for place, text, colour in (
        ((-0.62, -0.4), "$n,\\; c_n$", BLUE),
        ((-1.3, 0.72), "$t,\\; c_t$", VERMILION),
        ((-1.17, -0.24), "$p$", BLACK),
        ((0.13, -0.38), "$O$", BLACK),
        ((-0.42, 0.84), "$d=(x,y,r)$", GREEN),
        ((-1.6, -0.36), "finger", GREY),
        ((0.66, -0.62), "slope $\\mu$", BLUE),
    ):
        sketch.text(place, text, colour)
    return sketch.scene


def _torque() -> Scene:
    """Return a force at a contact on the slanted side, and the distance of its line from O."""
    sketch = _Sketch((-1.9, 2.4, -1.6, 1.75), 20)
    sketch.body()
    point, force = np.array([0.6, 0.75]), np.array([-0.15, -0.95])
    sketch.line(point - 0.84 * force, point + 2.3 * force, ec=GREY, ls=_DASHES)
    sketch.arrow(point - force, force, GREEN)
    sketch.dot(point)
    torque = point[0] * force[1] - point[1] * force[0]
    foot = torque / (force @ force) * np.array([force[1], -force[0]])
    sketch.line((0, 0), foot, ec=BLACK, lw=1.0)
    for place, text, colour in (
        ((0.44, 0.66), "$p$", BLACK),
        ((0.9, 1.3), "$f$", GREEN),
        ((0.24, 0.13), "$\\ell$", BLACK),
        ((0.13, -0.17), "$O$", BLACK),
        ((1.68, 0.1), "$|p \\times f| = \\ell\\,|f|$", BLACK),
        ((0.85, -1.35), "line of action", GREY),
    ):
        sketch.text(place, text, colour)
    return sketch.scene


#: Widths of two and of three panels on a page of 180 mm.
_HALF, _THIRD = 88.0, 57.0
_SQUARE = ((-1, -1), (1, -1), (1, 1), (-1, 1))
_TALL = ((-1, "-8/5"), (1, "-8/5"), (1, "8/5"), (-1, "8/5"))
_DOWN = (0, -1, 0)


@dataclass(frozen=True)
class PaperPart:
    """A figure or a table.

    Attributes:
        number: in the paper.
        title: what it is about.
        printed: what the paper shows, in our words.
        made: what ours shows.
        differs: where the two are not the same.
        claims: the claims of the registry that it rests on.
    """

    kind: ClassVar[str]
    number: str
    title: str
    printed: str
    made: str
    differs: str
    claims: tuple[str, ...]

    @property
    def name(self) -> str:
        """The name of its files."""
        return f"{self.kind}-{self.number}"


@dataclass(frozen=True)
class PaperFigure(PaperPart):
    """One figure, and what draws it."""

    kind = "figure"
    scene: Callable[[], Scene]


def two_pushes() -> Scene:
    """Return the three-contact grasp pushed up with preload 1, and down without any (Fig. 1)."""
    up, down = (read_grasp(f"paper-three-contacts{end}") for end in ("-preload-1", ""))
    pictures = [
        draw_grasp.scene(grasp, wrench=wrench, outline=_SQUARE, width=_HALF)
        for grasp, wrench in ((up, (0, 1, 0)), (down, _DOWN))
    ]
    return panel_sheet(pictures, 2, ["pushed up, preload 1: resisted", "pushed down: resisted"])


def linear_springs() -> Scene:
    """Return the three-contact grasp at rest, with linear springs, and in the full model."""
    grasp = read_grasp("paper-three-contacts")
    solution = linear_compliance(grasp, solve(grasp, _DOWN).wrench)
    return _method(grasp, solution, _SQUARE, ["linear springs: refused", "full model: resisted"])


def cones_alone() -> Scene:
    """Return the four-contact grasp, friction 2, at rest, with cones alone, in the full model."""
    grasp = read_grasp("paper-four-contacts").with_friction(2)
    solution = cones(grasp, _DOWN)
    return _method(grasp, solution, _TALL, ["cones alone: resisted", "full model: not resisted"])


def _method(grasp: Grasp, solution: Any, outline: Sequence[Any], titles: list[str]) -> Scene:
    """Return a grasp at rest, with the forces of a method, and with those of the full model."""
    verdict = solve(grasp, _DOWN)
    layouts = [
        GraspLayout(grasp, outline=outline),
        GraspLayout(grasp, verdict, outline, of_method=Solution(solution.motion, solution.forces)),
        GraspLayout(grasp, verdict, outline),
    ]
    return panel_sheet([drawn(layout, _THIRD) for layout in layouts], 3, ["at rest", *titles])


def slip_planes() -> Scene:
    """Return the three-contact grasp beside its tangential planes in the space of motions."""
    grasp = read_grasp("paper-three-contacts")
    planes = draw_planes.scene(grasp.tangential_arrangement(), sides=True, width=_HALF)
    object_ = draw_grasp.scene(grasp, outline=_SQUARE, width=_HALF)
    return panel_sheet([object_, planes], 2, ["grasp", "planes of motions d = (x, y, r)"])


def dual_polyhedron() -> Scene:
    """Return four planes in general position, and their great circles beside the dual."""
    planes = read_arrangement("cube-diagonals")
    return draw_dual.scene(planes, width=2 * _HALF)


def force_maps() -> Scene:
    """Return the slice of the wrench space, and the resisted forces without and with preload."""
    return draw_slice.scene(read_grasp("paper-three-contacts"), width=180.0)


FIGURES = (
    PaperFigure(
        "1",
        "One grasp, two pushes",
        "A hand touches an object left, below and right. On the left the object is pushed up, on "
        "the right down; arrows sketch the contact forces that would answer.",
        "Contacts at (-1, 0), (0, -1), (1, 0), friction 1/2: the numbers that Table I implies. "
        "Forces are exact equilibria, each panel to its own scale bar, with states and motion.",
        "The printed arrows are sketches; the figure prints no numbers.",
        ("table-three-contacts", "downward-forces", "vertical-limits"),
        two_pushes,
    ),
    PaperFigure(
        "2",
        "Notation at a contact",
        "One contact with its normal and tangential force components, and the motion of the "
        "object in the object frame.",
        "The same, with the friction cone, and a force as a wrench.",
        "The paper leaves open which way the normal points and which way is positive along the "
        "tangent. Here the normal points into the object, and the tangent is a quarter turn to "
        "the left of it.",
        ("printed-signs",),
        contact_notation,
    ),
    PaperFigure(
        "3",
        "Linear springs refuse too much",
        "The three-contact grasp at rest and pushed down. Tangential springs load the two side "
        "contacts with friction without normal forces, so that their cones are violated.",
        "The same push: the forces of linear springs, a third of the push at each contact, and "
        "those of the full model.",
        "The answer of the full model is added.",
        ("method-linear-compliance", "downward-forces"),
        linear_springs,
    ),
    PaperFigure(
        "4",
        "Cones alone allow too much",
        "A tall object between four contacts in two rows, without preload. A motion that mixes "
        "translation and rotation loads springs, and friction of the loaded contacts is said to "
        "resist any wrench.",
        "The same with friction 2: springs and cones without dissipation find a rotation that "
        "carries the force; the full model has no equilibrium.",
        "With the printed friction 1/2 the argument fails: the normal forces turn the object "
        "back, and friction outweighs them only above 1.",
        ("method-cones-only", "table-four-contacts"),
        cones_alone,
    ),
    PaperFigure(
        "5",
        "A grasp and its planes of slip",
        "A grasp, and the planes of its contacts in the space of motions (x, y, r). Contact 1 "
        "sticks where a translation along y is cancelled by an equal rotation, contact 2 where "
        "y is 0.",
        "The three-contact grasp of Figure 1 and its tangential planes, cut where they meet; an "
        "arrow marks the positive side of each.",
        "Contact 1 sticks on y = r, as printed. For a contact below the middle the plane is "
        "x + r = 0, not y = 0: the printed grasp is another one, or in another frame.",
        ("great-circle-regions",),
        slip_planes,
    ),
    PaperFigure(
        "6",
        "The dual polyhedron",
        "Planes with a dot in seven of their regions, and the polyhedron of all dots, joined "
        "where regions share a facet.",
        "Four planes in general position as great circles, with 14 regions, and their dual, the "
        "zonohedron of the normals: convex by construction.",
        "Dots on the unit sphere do not make the polyhedron convex: for four planes in general "
        "position no choice of dots does.",
        ("sphere-dual-convex", "sphere-hull-edges", "dual-planar-3-connected"),
        dual_polyhedron,
    ),
    PaperFigure(
        "7",
        "Three maps of forces",
        "Forces at torque 0 on the three-contact grasp: (a) a slice of the Grasp Wrench Space, "
        "L1 norm; (b) what is resisted without preload, the lower half plane; (c) with preload "
        "1, its edge raised in the middle.",
        "The same three sets as exact polygons. The boundary is drawn where resistance ends.",
        "The printed maps are found by a binary search in many directions, which is right on "
        "this grasp and errs on others. The roof of (c) runs from (-2, 0) over (0, 1) to (2, 0).",
        ("method-grasp-wrench-space", "vertical-limits", "binary-search"),
        force_maps,
    ),
)
