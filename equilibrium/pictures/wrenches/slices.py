"""The figure in three parts of [HaasHeger2018]: wrench-space slice, no preload, preload 1."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact, Wrench
from arrangement.drawing.scene.scene import Scene
from arrangement.numbers.exact import rational
from equilibrium.methods import METHODS
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.keys import symbol
from equilibrium.pictures.space.space_slice import slice_in_space
from equilibrium.pictures.style import SHADE, number, wrench_text
from equilibrium.wrench_sets import Region, resisted_region

from .row import PlaneQuestion, explain_borders, row_of_panels
from .window import joint_window


@picture
def draw_slice(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    preload: Exact | None = None,
    extent: Exact | None = None,
    axes: str = "",
    directions: int = 16,
    width: float = 180.0,
) -> Scene:
    """Draw the resisted forces three times in the same plane, with the same axes.

    (a) The slice of the Grasp Wrench Space with normal forces that sum to at most 1: it knows
    neither springs nor preload. (b) The exact set without preload. (c) The same with the grasp's
    own preloads or, where it has none or one is given, with one preload at every contact. The
    border is drawn only where resistance ends; what reaches the edge has no end, and fades.

    In space, one picture: the wrenches along directions of a plane of two coordinates, as far as
    they are proved to be resisted, with both ends of each bracket of a border; thick where the
    magnitudes that were tried stayed undecided, up to the edge if no proof was found beyond.
    Shaded outside is all that the proofs found refute: each refutes a convex part of the plane.

    Args:
        grasp: contacts.
        wrench: marked in every part; the plane has its torque.
        preload: at every contact of part (c); if omitted, the grasp's own preloads, or 1 where it
            has none.
        extent: half the side of each part, about the origin; if omitted, all borders are shown.
        axes: in space, two of fx, fy, fz, tx, ty, tz; "fx,fy" if omitted.
        directions: how many, in space.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    if grasp.dimension == 3:
        if not (wrench is preload is extent is None):
            raise GraspError("wrench, preload and extent are for slices in the plane")
        return slice_in_space(grasp, axes or "fx,fy", directions, min(width, 88.0))
    if axes:
        raise GraspError("axes are for grasps in space; leave them out")
    question = PlaneQuestion(wrench, extent)
    given = None if preload is None else rational(preload, "preload")
    parts = slices(grasp, question.torque, given)
    return draw_parts(grasp, parts, question, width)


def draw_parts(
    grasp: Grasp,
    parts: Sequence[tuple[str, Region]],
    question: PlaneQuestion,
    width: float,
    columns: int | None = None,
) -> Scene:
    """Return panels of one window with a region each, in one colour."""
    marked, fades = question.marked, question.half is None
    found = [region for _, region in parts]
    window = joint_window(found, marked, question.half)
    scene, panels = row_of_panels(len(parts), window, width, grasp, columns)
    legend = scene.legend
    if any(region.polygons for region in found):
        legend.key(symbol(SHADE), f"resisted forces at torque {number(question.torque)}")
    else:
        legend.line(f"nothing is resisted at torque {number(question.torque)}")
    explain_borders(legend, found, fades)
    if question.wrench is not None:
        legend.key(symbol("wrench-points"), f"{wrench_text(question.wrench, grasp.units)}: yes, no")
    for panel, (title, region) in zip(panels, parts, strict=True):
        panel.title(title)
        panel.region(region, by_states=False)
        if fades:
            panel.fade()
        for point in marked:
            panel.wrench(point, region.contains(point))
    return scene


def slices(grasp: Grasp, torque: Fraction, preload: Fraction | None) -> list[tuple[str, Region]]:
    """Return title and region of the three parts."""
    origin = (0, 0, torque)
    own = {contact.preload for contact in grasp}
    if preload is None and len(own) > 1:
        title, loaded = "(c) the preloads of the grasp", grasp
    else:
        chosen = (max(own, default=0) or 1) if preload is None else preload
        title, loaded = f"(c) preload {number(chosen)}", grasp.with_preload(chosen)
    return [
        ("(a) Grasp Wrench Space, L1", METHODS["wrench-space-L1"].region(grasp, origin=origin)),
        ("(b) no preload", resisted_region(grasp.with_preload(0), origin=origin)),
        (title, resisted_region(loaded, origin=origin)),
    ]
