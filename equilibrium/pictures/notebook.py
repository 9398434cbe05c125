"""What a notebook shows: a grasp as its picture, a verdict as a table of exact forces.

Tables are plain HTML without scripts, for which no extra is needed.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from html import escape

from arrangement.drawing.output import svg_text
from arrangement.numbers.exact import number_text, to_text
from equilibrium.decide.verdict import Verdict
from equilibrium.model.grasp import Grasp
from equilibrium.plane.search.state_equilibrium import Solution
from equilibrium.plane.states.equilibrium import Equilibrium
from equilibrium.plane.states.state_system import States

from .grasp.grasp import draw_grasp

#: How many equilibria are listed, and how long an exact number may be before it is rounded.
MOST_PIECES, LONGEST = 8, 24


def verdict_html(verdict: Verdict) -> str:
    """Return the answer as HTML: state, normal and tangential force of each contact.

    Contacts are numbered from 1, as in pictures. Of many contacts only the equilibrium that was
    found is shown. A number too long for a cell is rounded, with a
    sign that says so; its exact value is in the title of the cell.
    """
    stated = verdict.grasp.units
    units = f"<p>{escape(str(stated))}</p>" if stated else ""
    applied = f"w = {_vector(verdict.wrench)}"
    if verdict.doubt:
        units += f"<p><b>{escape(verdict.doubt)}</b>; as it was rounded:</p>"
    if not verdict.stable:
        return (
            f"<div>{units}<p><b>not resisted</b> under {applied}: there is no equilibrium</p></div>"
        )
    if not verdict.lists_all():
        assert verdict.solution is not None
        table = _table(verdict.states, verdict.solution)
        note = "one equilibrium, and there may be others"
        return f"<div>{units}<p><b>resisted</b> under {applied}: {note}</p>{table}</div>"
    equilibria = verdict.equilibria
    number = len(equilibria)
    heading = f"<b>resisted</b> under {applied}: {number} " + (
        "equilibrium" if number == 1 else "equilibria"
    )
    tables = "".join(
        _table(piece.states, piece, _freedom(piece)) for piece in equilibria[:MOST_PIECES]
    )
    more = f"<p>and {number - MOST_PIECES} more</p>" if number > MOST_PIECES else ""
    return f"<div>{units}<p>{heading}</p>{tables}{more}</div>"


def grasp_svg(grasp: Grasp) -> str | None:
    """Return the view grasp as SVG text; None without matplotlib."""
    return svg_text(lambda: draw_grasp(grasp))


def _table(states: States, found: Equilibrium | Solution, freedom: str = "") -> str:
    head = "<tr><th>contact</th><th>state</th><th>c<sub>n</sub></th><th>c<sub>t</sub></th></tr>"
    rows = "".join(
        f"<tr><td>{i}</td><td>{escape(state)}</td><td>{_number(c_n)}</td><td>{_number(c_t)}</td></tr>"
        for i, (state, (c_n, c_t)) in enumerate(zip(states, found.forces, strict=True), 1)
    )
    caption = f"d = {_vector(found.motion)}{freedom}"
    return f"<table><caption>{caption}</caption><thead>{head}</thead><tbody>{rows}</tbody></table>"


def _freedom(piece: Equilibrium) -> str:
    if piece.unique:
        return ""
    what = "the motion is" if piece.forces_determined else "motion and forces are"
    return f" ({what} not determined: least norm)"


def _vector(values: Iterable[Fraction]) -> str:
    return f"({', '.join(map(_number, values))})"


def _number(value: Fraction) -> str:
    """Return an exact number, or a rounded one with its exact value as a title."""
    text = to_text(value)
    if len(text) <= LONGEST:
        return escape(text)
    exact = text if len(text) <= 400 else f"{text[:400]}…"
    return f'<span title="{escape(exact, quote=True)}">{number_text(value, longest=LONGEST)}</span>'
