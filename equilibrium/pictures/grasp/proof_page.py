"""An interactive page: the proof that a grasp does not resist a wrench, part by part.

All numbers are written here; the page only places and shows them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import pale, plane_colour
from arrangement.drawing.pages.html_page import BASE_SCRIPT, BASE_STYLE, Template, floats, one_page
from arrangement.drawing.registry import Exact
from arrangement.drawing.scene.curves import flattened
from arrangement.drawing.scene.places import pole
from arrangement.drawing.scene.scene import area
from arrangement.numbers.exact import RationalVector, sign, to_text
from equilibrium.certificate.leaves import ClosedPart, works
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.style import SKETCH_SCRIPT, SKETCH_STYLE, Wrench

from .layout import Layout, shift_at
from .proof_maps import MAP, TURNS, ProofMaps, proof_maps, summary_lines

_OWN = "equilibrium.pictures.grasp"
SCRIPTS: tuple[Template, ...] = (BASE_SCRIPT, SKETCH_SCRIPT, (_OWN, "proof.js"))
#: Half width and half height of a number in a region, where a map fills [-1, 1].
_LABEL = np.array([0.05, 0.06])


def proof_page(
    grasp: Grasp, *, wrench: Wrench, rotation: Exact | None = None, title: str | None = None
) -> str:
    """Build a self-contained HTML page: why a wrench is not resisted.

    The two maps of `draw_proof`. For the region under the pointer, or the one that has the focus,
    the page draws the virtual motion on the grasp and states its inequality: the work of the load,
    the least work of each contact as a factor of its normal force, and that of all together. It
    states the question, as the certificate has it.

    Args:
        grasp: contacts.
        wrench: one that is not resisted.
        rotation: the angle r of the rotations shown (linearised), above 0, where it matters; if
            omitted, about the largest one at which a preloaded spring still touches, and no
            boundary.
        title: a heading; if omitted, the wrench.

    Raises:
        GraspError: the wrench is resisted, or a rotation that is not above 0.
    """
    maps = proof_maps(grasp, wrench, rotation)
    heading = (
        f"Why w = {LABEL.vector(maps.verdict.wrench)} is not resisted" if title is None else title
    )
    shapes = sorted(maps.shapes, key=lambda shape: -area(shape.corners))
    places = {id(part): i for i, part in enumerate(maps.parts)}
    largest = next(iter(maps.ranks))
    force = _directions([maps.verdict.wrench[:2]])[0]
    data = {
        "title": heading,
        "summary": "; ".join(summary_lines(maps, len(maps.ranks))),
        "load": {"force": force, "turn": sign(maps.verdict.wrench[2])},
        "stuck": any(maps.verdict.grasp.adhesion_wrench),
        "colours": [pale(plane_colour(i), 0.35) for i in range(len(maps.ranks))],
        "maps": [
            {
                "title": f"centres of {name} motions",
                "shapes": [
                    {"part": places[id(shape.part)], **_outline(shape.corners)}
                    for shape in shapes
                    if shape.sense == sense
                ],
            }
            for sense, name in TURNS.items()
        ],
        "first": next((places[id(s.part)] for s in shapes if s.part.leaf.motion == largest), 0),
        "half": MAP,
        "question": maps.verdict.verify().question,
        "motions": [_motion(maps, motion) for motion in maps.ranks],
        "parts": [_part(maps, part) for part in maps.parts],
        **_grasp_data(grasp),
    }
    styles: list[Template] = [BASE_STYLE, SKETCH_STYLE, (_OWN, "proof.css")]
    return one_page(heading, (_OWN, "proof.html"), styles, SCRIPTS, data, ["theme", "print"])


def _outline(corners: Any) -> dict[str, Any]:
    import shapely

    label = {}
    if len(corners) > 2:
        shape = shapely.Polygon(corners)
        place = pole(shape, _LABEL)
        if shape.contains(shapely.box(*(place - _LABEL), *(place + _LABEL))):
            label["label"] = floats(place)
    return {"corners": floats(corners), **label}


def _motion(maps: ProofMaps, motion: RationalVector) -> dict[str, Any]:
    """Return a virtual motion: in words, by its centre, and at the contacts."""
    x, y, r = motion
    shifts = [shift_at(motion, contact.point) for contact in maps.verdict.grasp]
    centre = None
    if r:
        point = (-y / r, x / r)
        words = f"turns the object {TURNS[sign(r)]} about {LABEL.vector(point)}"
        place = maps.window.paper(point)
        centre = floats(MAP * place) if abs(place).max() <= 1 else None
    else:
        words = f"moves the object along {LABEL.vector((x, y))}"
    return {
        "text": LABEL.vector(motion),
        "exact": f"({', '.join(map(to_text, motion))})",
        "words": words,
        "turn": sign(r),
        "centre": centre,
        "shifts": _directions(shifts),
    }


def _part(maps: ProofMaps, part: ClosedPart) -> dict[str, Any]:
    """Return a part: its motions, and the numbers of its inequality."""
    done = works(maps.verdict.grasp, maps.verdict.wrench, [part], maps.verdict.max_displacement)
    total = done.load + done.least
    return {
        "motion": maps.ranks[part.leaf.motion],
        "cone": [f"({', '.join(map(to_text, generator))})" for generator in part.region],
        "states": [
            f"{maps.verdict.grasp.point_names[i]} {state}" for i, state in part.states.items()
        ],
        "works": [LABEL.number(value) for value in (done.load, done.least, total)],
        "exact": [to_text(value) for value in (done.load, done.least, total)],
        "factors": [None if factor is None else LABEL.number(factor) for factor in done.factors],
    }


def _directions(vectors: Sequence[RationalVector]) -> Any:
    """Return vectors as floats, the largest component of all being 1 or -1."""
    largest = max((abs(x) for vector in vectors for x in vector), default=Fraction(0)) or 1
    return floats([[x / largest for x in vector] for vector in vectors])


def _grasp_data(grasp: Grasp) -> dict[str, Any]:
    """Return the contacts and the outline in paper coordinates, for ``sketch.js``."""
    layout = Layout(grasp)
    frame, curve = layout.frame, layout.curve
    return {
        "contacts": [
            {
                "place": floats(place),
                "normal": [float(x) for x in contact.normal],
                "cone": floats(rim),
                "preload": float(contact.preload),
            }
            for contact, place, rim in zip(grasp, layout.places, layout.cones, strict=True)
        ],
        "stated": layout.given,
        "outline": None if curve is None else floats(flattened(curve, 16)),
        "origin": floats(np.clip(frame.paper((Fraction(0),) * 2), -1.5, 1.5)),
        "centre": [float(x) for x in frame.centre],
        "size": float(frame.half),
    }
