"""The resisted wrenches of a plane as a picture, piece by piece."""

from __future__ import annotations

from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact, Wrench
from arrangement.drawing.scene.scene import Legend, Scene
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.keys import symbol
from equilibrium.pictures.style import FILLS, SYMBOLS, number, wrench_text
from equilibrium.plane.states.state_system import States
from equilibrium.wrench_sets import Region, resisted_region

from .panel import fill_of
from .row import PlaneQuestion, explain_borders, row_of_panels
from .window import joint_window


@picture
def draw_resist(
    grasp: Grasp, *, wrench: Wrench | None = None, extent: Exact | None = None, width: float = 88.0
) -> Scene:
    """Draw which forces are resisted, at zero torque or at the torque of a wrench.

    Every polygon is exact and stands for one choice of contact states: its colour tells how many
    contacts stick, hatching that some contact is detached; where there is room, one character for
    each contact tells its state. Polygons may overlap (several equilibria exist); smaller ones lie
    on top. Lines that no polygon holds are drawn wide. The black border is drawn only where
    resistance ends. What reaches the edge of the picture has no end, and fades.

    Args:
        grasp: contacts.
        wrench: marked: a disc when it is resisted, a cross when not; the plane has its torque.
        extent: half the side of the picture, about the origin; then nothing fades, as what
            reaches the edge may end beyond; if omitted, the whole border is shown.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    question = PlaneQuestion(wrench, extent)
    half, torque = question.half, question.torque
    region = resisted_region(grasp, origin=(0, 0, torque))
    window = joint_window([region], question.marked, half, pieces=True)
    scene, (panel,) = row_of_panels(1, window, width, grasp)
    unit = f" {grasp.units.torque}" if grasp.units else ""
    panel.title(f"resisted forces at torque {number(torque)}{unit}")
    states = panel.region(region)
    _describe(grasp, region, states, question, scene.legend)
    if half is None:
        panel.fade()
    for point in question.marked:
        panel.wrench(point, region.contains(point))
    return scene


def _describe(
    grasp: Grasp, region: Region, states: list[States], question: PlaneQuestion, legend: Legend
) -> None:
    applied = question.wrench
    if not region.polygons:
        legend.line("nothing in this plane is resisted")
    if applied is not None:
        held = region.contains(applied[:2])
        legend.key(symbol("resisted" if held else "refused"), wrench_text(applied, grasp.units))
    counts = sorted({min(s.count("stick"), len(FILLS) - 1) for s in states})
    for count in counts:
        example = next(s for s in states if min(s.count("stick"), len(FILLS) - 1) == count)
        more = any(s.count("stick") > count for s in states) and count == len(FILLS) - 1
        legend.key(symbol(fill_of(example)), f"{count}{' or more' if more else ''} stick")
    if any("detached" in p.states for p in region.polygons if p.polyhedron.dimension == 2):
        legend.key(symbol("#ffffff hatched"), "some detached")
    explain_borders(legend, [region], question.half is None)
    if states and len(grasp):
        found = [s for s in SYMBOLS if any(s in x for x in states)]
        shown = ", ".join(f"{SYMBOLS[s]} {s.replace('-', '−')}" for s in found)
        which = "contact 1" if len(grasp) == 1 else f"contacts 1 to {len(grasp)}"
        legend.line(f"{which}: {shown}")
