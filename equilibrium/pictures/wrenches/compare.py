"""The methods side by side: which forces each of them accepts, in one plane with the same axes."""

from __future__ import annotations

from collections.abc import Iterable

from arrangement.console.progress import watched
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Exact, Wrench
from arrangement.drawing.scene.scene import Scene
from equilibrium.methods.registry import METHODS, WITH_REGION, method_named
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .row import PlaneQuestion
from .slices import draw_parts


@picture
def draw_compare(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    methods: Iterable[str] | None = None,
    extent: Exact | None = None,
    width: float = 180.0,
) -> Scene:
    """Draw the forces that each method accepts, as exact polygons: small multiples in one plane.

    Args:
        grasp: contacts; springs and preload count where a method knows of them.
        wrench: marked in every panel: a disc where the method accepts it, a cross where it does
            not; the plane has its torque.
        methods: keys of `equilibrium.methods.METHODS`; if omitted, all that have a region (without
            those for which the contacts are too many).
        extent: half the side of each panel, about the origin; if omitted, all borders are shown.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an unknown method or none, too many contacts, an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    question = PlaneQuestion(wrench, extent)
    chosen = [method_named(name) for name in _names(grasp, methods)]
    parts = [
        (method.label, method.region(grasp, origin=(0, 0, question.torque)))
        for method in watched(chosen, "methods")
    ]
    return draw_parts(grasp, parts, question, width, columns=max(1, int(width / 44)))


def _names(grasp: Grasp, methods: Iterable[str] | None) -> list[str]:
    if methods is None:
        return [name for name in WITH_REGION if METHODS[name].tries(grasp)]
    names = list(methods)
    if not names:
        raise GraspError(f"no method is given; known are {', '.join(WITH_REGION)}")
    return names
