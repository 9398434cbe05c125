"""The exercises of the slip lab: those that come with it, and how a lecturer's own are checked."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any, get_args

from arrangement.errors import InputError
from arrangement.numbers.exact import shown
from arrangement.pictures.lab.exercises import read_exercises
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.plane.states.state_system import State

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
    for one in filter(None, parts[0].split(";")):
        numbers = one.split(",")
        if len(numbers) != 7:
            raise InputError(f"contact {shown(one)} needs seven numbers, with commas between them")
        contacts.append(Contact(numbers[:2], numbers[2:4], *numbers[4:]))
    return Grasp(contacts), read_wrench(parts[1].split(","))


def _yes_or_no(value: Any) -> None:
    if type(value) is not bool:
        raise InputError(f"{shown(value)} must be true or false")


def _true(value: Any) -> None:
    if value is not True:
        raise InputError(f"{shown(value)} must be true")


def _above_zero(value: Any) -> None:
    if type(value) is not int or value < 1:
        raise InputError(f"{shown(value)} must be an integer above 0")


def _states(value: Any) -> None:
    known = (*get_args(State), "any")
    if not isinstance(value, list) or not all(state in known for state in value):
        raise InputError(f"{shown(value)} must be a list of {', '.join(known)}")


def _method(value: Any) -> None:
    if not isinstance(value, dict) or set(value) != {"name", "says"}:
        raise InputError(f'{shown(value)} must be an object with "name" and "says"')
    if value["name"] not in METHODS:
        raise InputError(f"method {shown(value['name'])}; known are {', '.join(METHODS)}")
    _yes_or_no(value["says"])


GOALS = {
    "resisted": _yes_or_no,
    "equilibria": _above_zero,
    "states": _states,
    "gap": _true,
    "border": _true,
    "method": _method,
    "refutes": _true,
    "regions": _above_zero,
}
