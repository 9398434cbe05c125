"""The slip lab: one interactive page in which a grasp is changed and answers follow at once.

The page decides by itself, in rational numbers: it is a third route to the verdict and shares
nothing with the solver here but the form of files. Its proofs are certificates that
`equilibrium.certificate.checker` accepts.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any, get_args

from arrangement.console.number_form import counted
from arrangement.drawing.pages import Template, own
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from arrangement.pictures.lab.page import LINEAR, RATIONAL, VECTORS, lab, read_exercises
from arrangement.pictures.lab.widget import lab_widget
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.documents import question_document, read_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.pictures.style import SKETCH_SCRIPT, SKETCH_STYLE, Wrench
from equilibrium.plane.states.contact_states import State


def resist_page(grasp: Grasp, *, wrench: Wrench | None = None, title: str | None = None) -> str:
    """Build a self-contained HTML page: the resisted forces of a grasp.

    The plane of forces, at the torque of the load, shows every piece (one choice of contact
    states). The load can be dragged there, and the contacts beside it: the page shows whether the
    load is resisted, with which states, forces and motions, or proves that it is not.

    Args:
        grasp: as many contacts as the lab takes.
        wrench: at first; if omitted, none.
        title: a heading; if omitted, the number of contacts.

    Raises:
        InputError: a grasp in space, too many contacts or digits, or no wrench.
        OverflowError: the wrench is beyond floats.
    """
    if title is None:
        title = f"Forces that {counted(len(grasp), 'contact')} resist"
    load = read_wrench((0, 0, 0) if wrench is None else wrench)
    sum(map(float, load))  # OverflowError: beyond floats there is no place in the picture
    return lab_page(grasp, wrench=load, title=title, first="forces")


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
_OWN = "equilibrium.pictures.lab"
_DECIDES = (
    *("background", "law", "model", "check", "guide", "solve", "motions", "forces", "methods"),
    "questions",
)
#: What decides: it needs no page.
DECIDES: tuple[Template, ...] = (
    RATIONAL,
    VECTORS,
    LINEAR,
    *((_OWN, f"{name}.js") for name in ("resisted", *_DECIDES)),
)
_VIEWS = ("grasp_view", "motion_view", "map_view", "answer", "steps")
_SHOWS = ("state", *_VIEWS, "fields", "controls", "judge", "lab")
SCRIPTS: tuple[Template, ...] = (
    SKETCH_SCRIPT,
    *map(own, ("dual.js", "ball.js")),
    ("arrangement.pictures.lab", "circles.js"),
    *((_OWN, f"{name}.js") for name in ("plane", *_SHOWS)),
)


def lab_page(
    grasp: Grasp | None = None,
    *,
    wrench: Wrench | None = None,
    title: str | None = None,
    exercises: str | Path | None = None,
    first: str = "contacts",
) -> str:
    """Build a self-contained HTML page: contacts and load to drag, with exact answers.

    Args:
        grasp: at first, up to eight contacts; if omitted, three contacts with preload.
        wrench: at first; if omitted, a push along (0, 1).
        title: a heading.
        exercises: a JSON file with exercises; if omitted, the twelve that come with the lab.
        first: what stands first: "contacts", or "forces", the map of those that are resisted.

    Raises:
        InputError: a grasp in space, a constant force, adhesion, too many contacts or digits, no
            wrench, or no exercises in the file.
    """
    grasp = read_grasp(_EXAMPLES[0][1]) if grasp is None else grasp
    grasp.require_plane()
    if not all(contact.stiffness for contact in grasp):
        raise GraspError("a contact has stiffness 0; in the lab it must be above 0")
    if any(contact.adhesion for contact in grasp):
        raise GraspError("a contact has adhesion; the lab knows none, leave it out")
    budget.check_size(len(grasp), "contacts in the lab")
    heading = "The slip lab" if title is None else title
    applied = _EXAMPLES[0][2] if wrench is None else wrench
    question = question_document(grasp.without_pads(), applied, "the lab")
    for entry in question["grasp"]["contacts"]:
        entry.pop("thread", None)  # the lab draws no thread
    summary = "Drag contacts, normals and the load; every answer is exact."
    if grasp.has_pads:
        summary += " Here each point of a pad is a contact of its own."
    if grasp.data_error is not None:
        rounding = solve(grasp, applied).within_error().words
        summary += f" The data of this grasp were rounded; under the first load: {rounding}."
    data: dict[str, Any] = {
        "title": heading,
        "summary": summary,
        "most": budget.max_size("contacts in the lab"),
        "first": first,
        **question,
        "examples": [
            {"name": name, **question_document(read_grasp(source), load, "the lab")}
            for name, source, load in _EXAMPLES
        ],
        "axes": [
            f"{name} ({grasp.units.force})" if grasp.units else name for name in ("f_x", "f_y")
        ],
        "units": grasp.units is not None,
        # What the scripts of the still pages find when they start; the page fills it in.
        "contacts": [],
        "outline": None,
        "origin": [0, 0],
        "exercises": slip_exercises(exercises),
        "own": exercises is not None,
    }
    styles = [SKETCH_STYLE, (_OWN, "plane.css"), (_OWN, "lab.css")]
    return lab(heading, (_OWN, "lab.html"), styles, SCRIPTS, data, DECIDES)


def lab_in_notebook(grasp: Grasp) -> Any:
    """Return the page as `Grasp.lab` does."""

    def start(state: str) -> tuple[Grasp, Any]:
        return read_start(state) if state else (grasp, read_wrench(_EXAMPLES[0][2]))

    reads = {"grasp": lambda state: start(state)[0], "wrench": lambda state: start(state)[1]}
    return lab_widget(lab_page(grasp), reads)


#: What an exercise may ask to stay as it starts.
FIXED = (
    *("number", "points", "normals", "friction", "stiffness", "preload", "contacts"),
    *("wrench", "direction"),
)
#: Methods that the page compares with.
METHODS = ("printed", "cones", "wrench-space")


def slip_exercises(path: str | Path | None = None) -> list[dict[str, Any]]:
    """Return the exercises of a file, or those that come with the lab.

    Raises:
        InputError: the file holds no exercises; the message says which, and why.
    """
    own = files(__package__).joinpath("exercises.json")
    return read_exercises(own if path is None else path, GOALS, FIXED, read_start)


def read_start(text: str) -> tuple[Grasp, Any]:
    """Return grasp and wrench of a link of the page, as it is after ``#``.

    Raises:
        InputError: no such link, or its numbers are out of range.
    """
    version, *parts = text.split("|")
    if version != "1" or len(parts) not in (2, 3):
        raise InputError(
            f"{shown(text)} is not what a link of the lab has after #: 1|contacts|wrench"
        )
    contacts = []
    for entry in filter(None, parts[0].split(";")):
        numbers = entry.split(",")
        if len(numbers) != 7:
            raise InputError(
                f"contact {shown(entry)} needs seven numbers, with commas between them"
            )
        friction, stiffness, preload = numbers[4:]
        contacts.append(Contact(numbers[:2], numbers[2:4], friction, stiffness, preload))
    return Grasp(contacts), read_wrench(parts[1].split(","))


def _goal(words: str, holds: Callable[[Any], bool]) -> Callable[[Any], None]:
    """Return a check of what an exercise may ask for, said in words."""

    def checked(value: Any) -> None:
        if not holds(value):
            raise InputError(f"{shown(value)} must be {words}")

    return checked


_STATES = (*get_args(State), "any")
_yes_or_no = _goal("true or false", lambda value: type(value) is bool)
_true = _goal("true", lambda value: value is True)
_above_zero = _goal("an integer above 0", lambda value: type(value) is int and value > 0)


def _method(value: Any) -> None:
    if not isinstance(value, dict) or set(value) != {"name", "says"}:
        raise InputError(f'{shown(value)} must be an object with "name" and "says"')
    if value["name"] not in METHODS:
        raise InputError(f"method {shown(value['name'])}; expected one of {', '.join(METHODS)}")
    _yes_or_no(value["says"])


GOALS = {
    "resisted": _yes_or_no,
    "equilibria": _above_zero,
    "states": _goal(
        f"a list of {', '.join(_STATES)}",
        lambda value: isinstance(value, list) and all(state in _STATES for state in value),
    ),
    "gap": _true,
    "border": _true,
    "method": _method,
    "refutes": _true,
    "regions": _above_zero,
}
