"""The slip lab: one interactive page in which a grasp is changed and answers follow at once.

The page decides by itself, in rational numbers: it is a third route to the verdict and shares
nothing with the solver here but the form of files. Its proofs are certificates that
`equilibrium.certificate.checker` accepts.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from arrangement.drawing.pages.html_page import Template
from arrangement.drawing.registry import Wrench
from arrangement.errors import InputError
from arrangement.pictures.lab.page import LINEAR, RATIONAL, lab
from equilibrium.decide.verdict import solve
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.inputs.documents import question_document
from equilibrium.model.grasp import Grasp

from .exercises import slip_exercises

#: Contacts beyond which the answers of the page take more than about a second.
MAX_CONTACTS = 8
#: Names, built-in grasps and wrenches that the page offers.
_EXAMPLES: tuple[tuple[str, str, tuple[int | str, ...]], ...] = (
    ("Three contacts, preload 1", "paper-three-contacts-preload-1", (0, 1, 0)),
    ("Three contacts, no preload", "paper-three-contacts", (0, 1, 0)),
    (
        "Just too much: 1 + 10⁻³⁰",
        "paper-three-contacts-preload-1",
        (0, f"{10**30 + 1}/{10**30}", 0),
    ),
    ("Four contacts", "paper-four-contacts", (0, -1, 0)),
    ("Four contacts, preload 1, torque 3", "paper-four-contacts-preload-1", (0, 0, 3)),
    ("All contacts stick", "all-contacts-stick", (0, 0, 0)),
    ("Several equilibria", "several-equilibria", (-1, 0, 0)),
    ("One contact lets go", "one-contact-lets-go", (-1, 0, 0)),
    ("A push that works, fails, works", "interrupted-push", ("-3/2", 0, 0)),
    ("A solution in the wrong cell", "unchecked-cell", (2, 0, 2)),
    ("Contacts at one place", "coincident-contacts", (0, -1, 0)),
    ("Opposed contacts without friction", "frictionless-opposed-contacts", (0, -1, 0)),
)
_OWN, _DRAW = "equilibrium.pictures.lab", "equilibrium.pictures.pages"
_DECIDES = (
    *("background", "law", "model", "check", "guide", "solve", "motions", "forces", "methods"),
    "questions",
)
#: What decides: it needs no page.
DECIDES: tuple[Template, ...] = (
    RATIONAL,
    LINEAR,
    (_DRAW, "resisted.js"),
    *((_OWN, f"{name}.js") for name in _DECIDES),
)
_VIEWS = ("grasp_view", "motion_view", "map_view", "answer", "steps")
_SHOWS = ("state", *_VIEWS, "fields", "controls", "judge", "lab")
SCRIPTS: tuple[Template, ...] = (
    *((_DRAW, f"{name}.js") for name in ("sketch", "plane")),
    *((_OWN, f"{name}.js") for name in _SHOWS),
)


def lab_page(
    grasp: Grasp | None = None,
    *,
    wrench: Wrench | None = None,
    title: str | None = None,
    exercises: str | Path | None = None,
    first: str = "contacts",
) -> str:
    """Return one HTML page, complete in itself: contacts and load to drag, with exact answers.

    Args:
        grasp: at first, up to `MAX_CONTACTS` contacts; if omitted, three contacts with preload.
        wrench: at first; if omitted, a push along (0, 1).
        title: a heading.
        exercises: a JSON file with exercises; if omitted, the twelve that come with the lab.
        first: what stands first: "contacts", or "forces", the map of those that are resisted.

    Raises:
        InputError: a grasp in space, too many contacts or digits, no wrench, or no exercises in
            the file.
    """
    grasp = read_grasp(_EXAMPLES[0][1]) if grasp is None else grasp
    grasp.require_plane()
    if len(grasp) > MAX_CONTACTS:
        raise InputError(f"{len(grasp)} contacts; the lab takes at most {MAX_CONTACTS}")
    heading = "The slip lab" if title is None else title
    applied = _EXAMPLES[0][2] if wrench is None else wrench
    question = question_document(grasp, applied, "the lab")
    summary = "Drag contacts, normals and the load; every answer is exact."
    if grasp.data_error is not None:
        doubt = solve(grasp, applied).doubt or "other roundings of the first load say the same"
        summary += f" The data of this grasp were rounded: {doubt}."
    data: dict[str, Any] = {
        "title": heading,
        "summary": summary,
        "most": MAX_CONTACTS,
        "first": first,
        **question,
        "examples": [
            {"name": name, **question_document(read_grasp(source), load, "the lab")}
            for name, source, load in _EXAMPLES
        ],
        "axes": [
            f"{name} ({grasp.units.force})" if grasp.units else name for name in ("f_x", "f_y")
        ],
        # What the scripts of the still pages find when they start; the page fills it in.
        "contacts": [],
        "outline": None,
        "origin": [0, 0],
        "exercises": slip_exercises(exercises),
    }
    styles = [(_DRAW, "sketch.css"), (_DRAW, "plane.css"), (_OWN, "lab.css")]
    return lab(heading, (_OWN, "lab.html"), styles, SCRIPTS, data, DECIDES)
