"""The values of a parameter as a picture: the verdict along the letter, and the object at ends."""

from __future__ import annotations

from fractions import Fraction

from arrangement.console.number_form import LABEL
from arrangement.drawing.scene import FONT, POINTS, Scene
from arrangement.drawing.views import Exact, picture
from arrangement.numbers.exact import rational, shown
from equilibrium.decide.solver import solve
from equilibrium.model.errors import GraspError
from equilibrium.wrench_sets.parameter import ResistedValues

from .grasp import verdict_scene
from .style import FILLS, symbol

#: In points: of the bar, what is beside, below and above it, and between the objects.
_THICK = 4.0 * POINTS
_SIDE = 6.0 * POINTS
_BELOW = 8.0 * POINTS
_ABOVE = 7.0 * POINTS
_GAP = 4.0 * POINTS
_RESISTED = FILLS[0]
_NOT_RESISTED = "#e3e3e3"
_UNDECIDED = "#ffffff"


@picture(60.0)
def draw_values(
    answer: ResistedValues, *, value: Exact | None = None, width: float = 120.0
) -> Scene:
    """Draw for which values of a letter a load is resisted, and the object where that ends.

    The bar shows what is proved along the letter, of an angle in degrees. Above it are the object
    and an equilibrium at the first and the last end of the resisted values, or at the ends of the
    values asked about. A movie (.gif, .mp4) shows the object for one value after the other.

    Args:
        answer: of `resisted_values`.
        value: the one at which the object is shown; of an angle, of the tangent of its half.
    """
    ends = [end.value for end in answer.ends] or [answer.between.low, answer.between.high]
    values = [x for x in sorted({ends[0], ends[-1]}) if answer.verdict_at(x) != "undecided"]
    if value is not None:
        values = [rational(value, "value")]
        if values[0] not in answer.between:
            raise GraspError(f"value is {shown(value)}; expected one in {answer.between}")
    verdicts = [solve(*answer.family.at(value)) for value in values]
    scenes = [verdict_scene(verdict, (width - _GAP / POINTS) / 2) for verdict in verdicts]
    tall = max((scene.height for scene in scenes), default=0.0)
    whole = Scene(width, (_BELOW + _THICK + _ABOVE + tall) / POINTS)
    bar = _Bar(whole, answer)
    for mark in dict.fromkeys([answer.between.low, *values, answer.between.high]):
        whole.write((bar.place(mark), _BELOW - 1.6 * POINTS), _value_text(answer, mark), va="top")
    for i, (shown_at, scene) in enumerate(zip(values, scenes, strict=True)):
        middle = (whole.width - scene.width) / 2
        x = middle if len(scenes) == 1 else i * (scene.width + _GAP)
        head = f"{answer.family.letter} = {_value_text(answer, shown_at)}"
        _explain_once(whole, scene, head)
        whole.place(scene, x, _BELOW + _THICK + _ABOVE)
        x += scene.width / 2
        whole.text((x, _BELOW + _THICK + 4.0 * POINTS), head, FONT)
        leader = [(x, _BELOW + _THICK + 2.2 * POINTS), (bar.place(shown_at), _BELOW + _THICK)]
        whole.line(leader, ec="#888888", lw=0.5)
    for end in answer.ends:
        if end.gives:
            at = _value_text(answer, end.value)
            whole.legend.line(f"in all equilibria at {at}: {end.gives.words}")
    return whole


def _explain_once(whole: Scene, scene: Scene, head: str) -> None:
    """Move the lines of an object's legend, under a heading, and drop the keys that are there."""
    for text, emphasis in scene.legend.lines:
        whole.legend.line(f"{head}: {text}", emphasis)
    scene.legend.lines = []
    known = {key.text for key in whole.legend.keys}
    scene.legend.keys = [key for key in scene.legend.keys if key.text not in known]


class _Bar:
    """The verdicts along the letter."""

    def __init__(self, scene: Scene, answer: ResistedValues) -> None:
        self.scene, self.answer = scene, answer
        between = answer.between
        self._add(between.low, between.high, _UNDECIDED, "between")
        for name, fill, spans in (
            ("not resisted", _NOT_RESISTED, answer.not_resisted),
            ("resisted", _RESISTED, answer.resisted),
        ):
            for i, span in enumerate(spans, 1):
                self._add(span.low, span.high, fill, f"{name.replace(' ', '-')}-{i}")
            if spans:
                scene.legend.key(symbol(fill), f"{name}, proved")
        if any(gap.high - gap.low > answer.tolerance for gap in answer.gaps):
            scene.legend.key(symbol(_UNDECIDED), "undecided")

    def place(self, value: Fraction) -> float:
        """Return where a value is."""
        between = self.answer.between
        low, at, high = (_letter(self.answer, x) for x in (between.low, value, between.high))
        return _SIDE + (self.scene.width - 2 * _SIDE) * (at - low) / ((high - low) or 1.0)

    def _add(self, low: Fraction, high: Fraction, fill: str, name: str) -> None:
        left = self.place(low)
        right = max(self.place(high), left + 0.8)  # A single value is seen, too.
        top = _BELOW + _THICK
        corners = [(left, _BELOW), (right, _BELOW), (right, top), (left, top)]
        self.scene.polygon(corners, fc=fill, ec="#444444", lw=0.5, gid=name)


def _letter(answer: ResistedValues, value: Fraction) -> float:
    return answer.family.degrees(value) if answer.family.is_angle else float(value)


def _value_text(answer: ResistedValues, value: Fraction) -> str:
    is_angle = answer.family.is_angle
    return f"{_letter(answer, value):.4g}°" if is_angle else LABEL.number(value)
