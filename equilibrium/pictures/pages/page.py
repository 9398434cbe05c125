"""An interactive page: which forces a grasp resists, and what its contacts do under the pointer.

Motion, forces, wrench and preloads grow together. So the exact set for one preload serves for
every factor above 0: a condition ``a . w + d >= 0`` becomes ``a . w + d p >= 0``. The page finds
all pieces by itself, with the modules of the slip lab, and decides with exact numbers; floats
place things on the screen.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import counted
from arrangement.drawing.pages.html_page import BASE_SCRIPT, BASE_STYLE, POLYGON, Template, one_page
from arrangement.drawing.registry import Wrench
from arrangement.drawing.scene.labels import flattened
from arrangement.errors import InputError
from arrangement.numbers.exact import to_text
from arrangement.pictures.lab.page import FIELDS, LINEAR, RATIONAL
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.pictures.grasp.layout import layout_of

#: Contacts beyond which the pieces are too many for a page.
MAX_CONTACTS = 8
_OWN, _LAB = "equilibrium.pictures.pages", "equilibrium.pictures.lab"
_MODULES = ("resisted", "sketch", "plane", "graspview", "resist", "resist_controls")
SCRIPTS: tuple[Template, ...] = (
    BASE_SCRIPT,
    POLYGON,
    RATIONAL,
    LINEAR,
    FIELDS,
    *((_LAB, f"{name}.js") for name in ("background", "law", "model", "motions", "forces")),
    *((_OWN, f"{name}.js") for name in _MODULES),
)


def resist_page(grasp: Grasp, *, wrench: Wrench | None = None, title: str | None = None) -> str:
    """Return one HTML page, complete in itself: the resisted forces of a grasp.

    The plane of forces shows every piece (one choice of contact states) at a torque and a preload
    that can be changed. For the force under the pointer the page tells whether it is resisted,
    with which states, and with which forces and motion where the states fix them.

    Args:
        grasp: up to `MAX_CONTACTS` contacts.
        wrench: chosen at first; if omitted, none is, and the torque is 0.
        title: a heading; if omitted, the number of contacts.

    Raises:
        InputError: too many contacts, or no wrench.
        OverflowError: a number is beyond floats.
    """
    if len(grasp) > MAX_CONTACTS:
        raise InputError(f"{len(grasp)} contacts; a page shows at most {MAX_CONTACTS}")
    applied = None if wrench is None else read_wrench(wrench)
    sum(map(float, applied or ()))  # OverflowError: beyond floats there is no place in the picture
    number = counted(len(grasp), "contact")
    heading = title if title is not None else f"Forces that {number} resist"
    axes = ["f_x", "f_y"]
    data = {
        "title": heading,
        "summary": _summary(grasp),
        "grasp": grasp.to_dict(),
        "torque": to_text(applied[2]) if applied else "0",
        "force": [to_text(x) for x in applied[:2]] if applied else None,
        "axes": [f"{axis} ({grasp.units.force})" for axis in axes] if grasp.units else axes,
        "most": MAX_CONTACTS,
        **_preloads(grasp),
        **grasp_data(grasp),
    }
    names = ("sketch", "plane", "resist")
    styles = [BASE_STYLE, *((_OWN, f"{name}.css") for name in names)]
    buttons = ["home", "theme", "print"]
    return one_page(heading, (_OWN, "resist.html"), styles, SCRIPTS, data, buttons)


def _summary(grasp: Grasp) -> str:
    frictions = sorted({contact.friction for contact in grasp})
    stated = f" friction {', '.join(map(to_text, frictions))};" if frictions else ""
    preloads = sorted({contact.preload for contact in grasp})
    loaded = f" preload {', '.join(map(to_text, preloads))}" if preloads else ""
    return f"{counted(len(grasp), 'contact')};{stated}{loaded}"


def _preloads(grasp: Grasp) -> dict[str, Any]:
    """Return which preloads are shown: none, equal ones, and the grasp's own if they differ."""
    preloads = {contact.preload for contact in grasp} or {Fraction(0)}
    if len(preloads) > 1:
        kinds = ["none", "uniform", "own"]
        return {"kinds": kinds, "kind": "own", "factor": "1", "preload_reach": 3.0}
    uniform = next(iter(preloads))
    reach = 1.5 * float(uniform) or 3.0
    shown = {"kind": "uniform", "factor": to_text(uniform), "preload_reach": reach}
    return {"kinds": ["none", "uniform"], **shown}


def grasp_data(grasp: Grasp) -> dict[str, Any]:
    """Return the contacts and the outline in paper coordinates, for ``sketch.js``."""
    layout = layout_of(grasp, None, None, 1)
    frame, curve = layout.frame, layout.curve
    return {
        "contacts": [
            {
                "place": floats(place),
                "normal": [float(x) for x in contact.normal],
                "cone": [floats(point) for point in rim],
                "preload": float(contact.preload),
            }
            for contact, place, rim in zip(grasp, layout.places, layout.cones, strict=True)
        ],
        "stated": layout.given,
        "outline": None if curve is None else [floats(p) for p in flattened(curve, 16)],
        "origin": floats(np.clip(frame.paper((Fraction(0),) * 2), -1.5, 1.5)),
        "centre": [float(x) for x in frame.centre],
        "size": float(frame.size),
    }


def floats(point: Any) -> list[float]:
    """Return coordinates on paper, short."""
    return [round(float(x), 5) + 0.0 for x in point]
