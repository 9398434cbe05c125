"""Methods against wrenches: who accepts what, as a table to look at."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from arrangement.draw.output import require_matplotlib
from equilibrium.methods.compare import Comparison, compare
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench

from .compare import TITLES
from .legend import Legend
from .shapes import text_size
from .style import BLACK, FONT, GREY, bare, new_figure, points, vector

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_WRENCHES = 24
ALL_TITLES = {
    **TITLES,
    "printed": "the paper as printed",
    "wrench-space": "wrench space, unbounded",
    "form-closure": "form closure",
    "strong": "strongly stable",
}
_ROW, _SIDE, _TINT = 4.6, 3.0, "#f3c9a5"


def draw_methods(grasp: Grasp, *, wrenches: Iterable[Iterable[Any]], width: float = 88.0) -> Figure:
    """Draw the verdict of every method on several wrenches, one column for each.

    A disc: the method accepts; a cross: it refuses; a dash: it says nothing about one wrench.
    A shaded field: it disagrees with the complete model, which is the first row.

    Args:
        grasp: contacts.
        wrenches: at least one, at most `MAX_WRENCHES`.
        width: of the figure, in millimetres.

    Raises:
        GraspError: no wrench, or too many.
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    questions = [read_wrench(wrench) for wrench in wrenches]
    if not 1 <= len(questions) <= MAX_WRENCHES:
        raise GraspError(f"{len(questions)} wrenches; give 1 to {MAX_WRENCHES}")
    answers = [compare(grasp, wrench) for wrench in questions]
    names = [answer.method for answer in answers[0].answers]
    legend = Legend(width)
    legend.key("accepted", "accepts")
    legend.key("refusal", "refuses")
    if any(entry.accepts is None for answer in answers for entry in answer.answers):
        legend.key("silence", "says nothing")
    if any(answer.disagreeing for answer in answers):
        legend.key(_TINT, "not as the complete model")
    heads = [vector(wrench) for wrench in questions]
    above = max(_wide(head) for head in heads) + 3.0
    height = above + _ROW * len(names) + 2.0
    figure = new_figure(width, height + legend.height)
    share = height / (height + legend.height)
    axes = figure.add_axes((0.0, 1 - share, 1.0, share))
    bare(axes, (0.0, 0.0), (width, height))
    _paint(axes, [ALL_TITLES[name] for name in names], heads, answers, height - above)
    legend.draw(figure)
    return figure


def _paint(
    axes: Any,
    titles: Sequence[str],
    heads: Sequence[str],
    answers: Sequence[Comparison],
    top: float,
) -> None:
    from matplotlib.patches import Rectangle

    width = axes.get_xlim()[1]
    left = _SIDE + max(map(_wide, titles)) + 2.0
    column = min((width - left - _SIDE) / len(heads), 12.0)
    for i, title in enumerate(titles):
        y = top - (i + 0.5) * _ROW
        weight = "bold" if i == 0 else "normal"
        axes.text(_SIDE, y, title, size=FONT, va="center_baseline", weight=weight)
        for j, answer in enumerate(answers):
            entry, x = answer.answers[i], left + (j + 0.5) * column
            if entry.method in answer.disagreeing:
                axes.add_patch(
                    Rectangle((x - column / 2, y - _ROW / 2), column, _ROW, fc=_TINT, ec="none",
                              gid=f"differs-{i}-{j}")
                )  # fmt: skip
            _verdict(axes, x, y, entry.accepts, f"cell-{i}-{j}")
    for j, head in enumerate(heads):
        axes.text(left + (j + 0.5) * column, top + 1.5, head, size=FONT, rotation=90,
                  ha="center", va="bottom")  # fmt: skip
    right = left + column * len(heads)
    for i in (0, 1, len(titles)):
        y = top - i * _ROW
        axes.plot([_SIDE, right], [y, y], color=GREY, lw=0.6 if i != 1 else 0.3)


def _verdict(axes: Any, x: float, y: float, accepts: bool | None, gid: str) -> None:
    style: dict[str, Any] = {"color": BLACK, "gid": gid, "zorder": 3}
    if accepts is None:
        axes.plot([x - 0.8, x + 0.8], [y, y], lw=0.8, **style)
    elif accepts:
        axes.plot([x], [y], "o", ms=4.5, **style)
    else:
        axes.plot([x], [y], "x", ms=4, mew=1.0, **style)


def _wide(text: str) -> float:
    return text_size(text, 1 / points(1.0))[0]
