"""Methods against wrenches: who accepts what, as a table to look at."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import GREY
from arrangement.drawing.figure import picture
from arrangement.drawing.registry import Wrench
from arrangement.drawing.scene.scene import POINTS, Scene, measure
from arrangement.numbers import budget
from equilibrium.methods import METHODS, Comparison, compare
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.pictures.parts.panel import explain_error
from equilibrium.pictures.parts.style import MARKS, symbol

_ROW, _SIDE, _TINT = 4.6 * POINTS, 3.0 * POINTS, "#f3c9a5"
_ANSWERS = {True: "accepted", False: "refusal", None: "silence"}


@picture(20.0)
def draw_methods(grasp: Grasp, *, wrenches: Iterable[Wrench], width: float = 88.0) -> Scene:
    """Draw the verdict of every method on several wrenches, one column for each.

    A disc: the method accepts; a cross: it refuses; a dash: it says nothing about one wrench.
    A shaded field: it disagrees with the complete model, which is the first row.

    Args:
        grasp: contacts.
        wrenches: at least one, at most 24.

    Raises:
        GraspError: no wrench, or too many.
    """
    questions = [read_wrench(wrench, grasp.dimension) for wrench in wrenches]
    if not questions:
        raise GraspError("there is no wrench; give at least one")
    budget.keep(len(questions), "wrenches in a picture")
    answers = [compare(grasp, wrench) for wrench in questions]
    names = [answer.method for answer in answers[0].answers]
    heads = [LABEL.vector(wrench) for wrench in questions]
    above = max(measure(head)[0] for head in heads) + 3.0 * POINTS
    height = above + _ROW * len(names) + 2.0 * POINTS
    scene = Scene(width, height / POINTS)
    _paint(scene, [METHODS[name].label for name in names], heads, answers, height - above)
    legend = scene.legend
    explain_error(legend, grasp)
    legend.key(symbol("accepted"), "accepts")
    legend.key(symbol("refusal"), "refuses")
    if any(entry.accepts is None for answer in answers for entry in answer.answers):
        legend.key(symbol("silence"), "says nothing")
    if any(answer.disagreeing for answer in answers):
        legend.key(symbol(_TINT), "not as the complete model")
    return scene


def _paint(
    scene: Scene,
    titles: Sequence[str],
    heads: Sequence[str],
    answers: Sequence[Comparison],
    top: float,
) -> None:
    left = _SIDE + max(measure(title)[0] for title in titles) + 2.0 * POINTS
    column = min((scene.width - left - _SIDE) / len(heads), 12.0 * POINTS)
    for i, title in enumerate(titles):
        y = top - (i + 0.5) * _ROW
        weight = "bold" if i == 0 else "normal"
        scene.text((_SIDE, y), title, ha="left", va="center_baseline", weight=weight)
        for j, answer in enumerate(answers):
            entry, x = answer.answers[i], left + (j + 0.5) * column
            if entry.method in answer.disagreeing:
                corners = [
                    (x + a * column / 2, y + b * _ROW / 2)
                    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
                ]
                scene.polygon(corners, fc=_TINT, ec="none", gid=f"differs-{i + 1}-{j + 1}")
            sign, size, style = MARKS[_ANSWERS[entry.accepts]]
            scene.mark((x, y), sign, size, zorder=3, gid=f"cell-{i + 1}-{j + 1}", **style)
    for j, head in enumerate(heads):
        place = left + (j + 0.5) * column, top + 1.5 * POINTS
        scene.text(place, head, rotation=90, va="bottom")
    right = left + column * len(heads)
    for i in (0, 1, len(titles)):
        y = top - i * _ROW
        scene.line([(_SIDE, y), (right, y)], ec=GREY, lw=0.6 if i != 1 else 0.3, zorder=2)
