"""The methods side by side: which forces each of them accepts, in one plane with the same axes."""

from __future__ import annotations

from collections.abc import Iterable

from arrangement.draw.figure import picture
from arrangement.draw.registry import Exact, Wrench
from arrangement.draw.scene import Scene
from arrangement.progress import watched
from equilibrium.methods.regions import FORCES, METHODS, MOST_FOR_ALL_CHOICES, method_region
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .row import Question
from .slices import draw_parts

#: Short titles that fit above a small panel.
TITLES = {
    "complete": "complete model",
    "cones": "springs and cones only",
    "wrench-space-L1": "wrench space, L1",
    "wrench-space-Linf": "wrench space, L∞",
    "weak": "weakly stable",
    "frictionless": "frictionless stable",
    "linear-compliance": "linear compliance",
    "frictionless-slip": "frictionless slip",
}


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
        methods: keys of `equilibrium.methods.regions.METHODS`; if omitted, all (without the one
            that tries 3^m choices when the contacts are too many for it).
        extent: half the side of each panel, about the origin; if omitted, all borders are shown.
        width: of the figure, in millimetres.

    Raises:
        GraspError: an unknown method or none, too many contacts, an extent that is not above 0.
        MissingExtraError: matplotlib is absent.
    """
    question = Question(wrench, extent)
    regions = {
        name: method_region(name, grasp, FORCES, (0, 0, question.torque))
        for name in watched(_names(grasp, methods), "methods")
    }
    parts = [(TITLES[name], region) for name, region in regions.items()]
    return draw_parts(grasp, parts, question, width, columns=max(1, int(width / 44)))


def _names(grasp: Grasp, methods: Iterable[str] | None) -> list[str]:
    if methods is None:
        few = len(grasp) <= MOST_FOR_ALL_CHOICES
        return [name for name in METHODS if few or name != "frictionless-slip"]
    names = list(methods)
    if not names:
        raise GraspError(f"no method is given; known are {', '.join(METHODS)}")
    return names
