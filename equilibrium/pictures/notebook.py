"""What a notebook shows: grasps and verdicts as pictures, with a table of exact forces.

Tables are plain HTML without scripts, for which no extra is needed.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from fractions import Fraction
from html import escape
from typing import TYPE_CHECKING

from arrangement.console.number_form import Form, counted
from arrangement.drawing.output import image, svg_text
from arrangement.drawing.views import drawing
from arrangement.numbers import budget
from arrangement.numbers.exact import to_text
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Solution
from equilibrium.plane.states.equilibrium import Equilibrium

from .grasp import draw_grasp, verdict_scene

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing

#: How many equilibria are listed, and how long an exact number may be before it is rounded.
MOST_PIECES, LONGEST = 8, 24
_CELL = Form(longest=LONGEST)


def verdict_svg(verdict: Verdict) -> str | None:
    """Return bodies, wrenches and an equilibrium as SVG text; None without matplotlib.

    None as well of too many contacts, and of numbers beyond floats.
    """

    def made() -> Drawing:
        if not isinstance(verdict.subject, Assembly):
            budget.check_size(len(verdict.grasp), "contacts in a picture")
        return drawing(verdict_scene(verdict))

    with suppress(OverflowError):
        return svg_text(made)
    return None


def verdict_html(verdict: Verdict) -> str:
    """Return the answer as HTML: the picture, and the table of `verdict_table`."""
    return f"<div>{image(verdict_svg(verdict), 'the grasp')}{verdict_table(verdict)}</div>"


def verdict_table(verdict: Verdict) -> str:
    """Return the answer as HTML: state, normal and tangential force of each contact.

    Contacts are numbered from 1, as in pictures. Of many contacts, and in space, only the
    equilibrium that was found is shown. A number too long for a cell is rounded, with a sign that
    says so; its exact value is in the title of the cell.
    """
    stated = verdict.grasp.units
    head = f"<p>{escape(str(stated))}</p>" if stated else ""
    if verdict.doubt:
        head += f"<p><b>{escape(verdict.doubt)}</b>; for the data as rounded:</p>"
    tables = ""
    names = [name.removeprefix("contact ") for name in verdict.grasp.point_names]
    if not verdict.decided:
        note = escape(verdict.reason)
    elif verdict.solution is None:
        note = "there is no equilibrium"
    elif verdict.lists_all():
        equilibria = verdict.equilibria
        note = counted(len(equilibria), "equilibrium", "equilibria")
        tables = "".join(_table(names, x.states, x, _freedom(x)) for x in equilibria[:MOST_PIECES])
        more = len(equilibria) - MOST_PIECES
        tables += f"<p>and {more} more</p>" if more > 0 else ""
    else:
        note = "one equilibrium, and there may be others"
        if verdict.solution.box is not None:
            note = "exactly one equilibrium lies in a box around this one"
        tables = _table(names, verdict.states, verdict.solution)
    pull = verdict.grasp.adhesion_wrench
    stuck = f" and the adhesion {_vector(pull)}" if any(pull) else ""
    answer = f"<b>{verdict.verdict}</b> under w = {_vector(verdict.wrench)}{stuck}: {note}"
    return f"<div>{head}<p>{answer}</p>{tables}</div>"


def grasp_svg(grasp: Grasp) -> str | None:
    """Return the view grasp as SVG text; None without matplotlib."""
    return svg_text(lambda: draw_grasp(grasp))


def _table(
    names: Iterable[str],
    states: Iterable[str],
    equilibrium: Equilibrium | Solution,
    freedom: str = "",
) -> str:
    head = "<tr><th>contact</th><th>state</th><th>c<sub>n</sub></th><th>c<sub>t</sub></th></tr>"
    rows = "".join(
        f"<tr><td>{name}</td><td>{escape(state)}</td><td>{_number(c_n)}</td>"
        f"<td>{', '.join(map(_number, c_t))}</td></tr>"
        for name, state, (c_n, *c_t) in zip(names, states, equilibrium.forces, strict=True)
    )
    caption = f"d = {_vector(equilibrium.motion)}{freedom}"
    return f"<table><caption>{caption}</caption><thead>{head}</thead><tbody>{rows}</tbody></table>"


def _freedom(piece: Equilibrium) -> str:
    if piece.unique:
        return ""
    what = "the motion is" if piece.forces_determined else "motion and forces are"
    return f" ({what} not unique; the minimum-norm solution is shown)"


def _vector(values: Iterable[Fraction]) -> str:
    return f"({', '.join(map(_number, values))})"


def _number(value: Fraction) -> str:
    """Return an exact number, or a rounded one with its exact value as a title."""
    text = to_text(value)
    if len(text) <= LONGEST:
        return escape(text)
    exact = text if len(text) <= 400 else f"{text[:400]}…"
    return f'<span title="{escape(exact, quote=True)}">{_CELL.number(value)}</span>'
