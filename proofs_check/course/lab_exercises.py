"""The exercises of the two labs, graded as the labs check them; an answer is a link of the page.

The pages check by themselves, in JavaScript. Here the solver and the enumerators decide.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any
from urllib.parse import unquote

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.json_files import read_document
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot, primitive, rational_vector, shown
from arrangement.numbers.linear.intervals import Interval, holds
from arrangement.numbers.linear.rank import cross
from arrangement.pictures.lab import lines
from equilibrium.certificate.checker import check
from equilibrium.certificate.reading import SCHEMA_VERSION
from equilibrium.decide.solver import solve
from equilibrium.methods.compare import predict
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.lab import page
from equilibrium.wrench_sets.resisted_set import ResistedSet

#: The words for the exercises that come with a lab.
BUILT_IN = ("slip-lab", "arrangement-lab")
#: What a judge returns: True, or what is wrong.
Judged = bool | str


def read_link(answer: Any) -> tuple[str, Any]:
    """Return what a link of a lab has after ``#``, and the motion that comes with it, if one does.

    Raises:
        InputError: no text, and no object with a text "link" and three numbers "motion".
    """
    motion = None
    if isinstance(answer, Mapping) and set(answer) == {"link", "motion"}:
        motion = rational_vector(answer["motion"], "the motion")
        answer = answer["link"]
    if not isinstance(answer, str):
        raise InputError(f"the answer is {shown(answer)}; expected a link of the lab")
    return unquote(answer.rpartition("#")[2]), motion


def lab_judges(source: str) -> dict[str, tuple[str, Callable[[Any], Judged]]]:
    """Return the exercises of a lab: by its name the task of each, and a function that judges.

    Args:
        source: a word of `BUILT_IN`, or a JSON file such as the editor of a lab saves.

    Raises:
        InputError: the file holds no exercises of either lab, or two of one name.
    """
    if _is_of_lines(source):
        exercises, judge = lines.line_exercises(_path(source)), _judge_lines
    else:
        exercises, judge = page.slip_exercises(_path(source)), _judge_slip
    named = {
        exercise["name"]: (exercise["task"], _refusing(judge, exercise)) for exercise in exercises
    }
    if len(named) < len(exercises):
        raise InputError(f"{source} has two exercises of one name; expected different names")
    return named


def _path(source: str) -> str | None:
    return None if source in BUILT_IN else source


def _is_of_lines(source: str) -> bool:
    """Return whether exercises are of the arrangement lab: by what they ask for."""
    if source in BUILT_IN:
        return source == "arrangement-lab"
    listed = read_document(source, ("exercises",))["exercises"]
    goals = (
        [exercise.get("goal") for exercise in listed if isinstance(exercise, dict)]
        if listed
        else []
    )
    return any(isinstance(goal, dict) and set(goal) & set(lines.GOALS) for goal in goals)


def _refusing(judge: Callable[[Any, Any], Judged], exercise: Any) -> Callable[[Any], Judged]:
    """Return the judge of an exercise; a link that cannot be read is a wrong answer."""

    def judgement(answer: Any) -> Judged:
        try:
            return judge(exercise, answer)
        except InputError as error:
            return str(error)

    return judgement


def _judge_slip(exercise: Mapping[str, Any], answer: tuple[str, Any]) -> Judged:
    start, (grasp, wrench) = page.read_start(exercise["start"]), page.read_start(answer[0])
    budget.check_size(len(grasp), "contacts in the lab")
    moved = _change_problem(exercise["fixed"], start, (grasp, wrench))
    if moved:
        return moved
    [(kind, value)] = exercise["goal"].items()
    return _SLIP_GOALS[kind](value, grasp, wrench, answer[1])


_SAME: Mapping[str, Callable[[Contact], Any]] = {
    "number": lambda contact: None,
    "points": lambda contact: contact.point,
    "normals": lambda contact: contact.normal,
    "friction": lambda contact: contact.friction,
    "stiffness": lambda contact: contact.stiffness,
    "preload": lambda contact: contact.preload,
    "contacts": lambda contact: contact,
}


def _change_problem(fixed: list[str], start: tuple[Grasp, Any], now: tuple[Grasp, Any]) -> str:
    """Return what was changed though it has to stay, or an empty text."""
    (before, load), (grasp, wrench) = start, now
    for name in fixed:
        if name == "wrench" and wrench != load:
            return "the load has to stay as it was"
        if name == "direction" and (any(cross(load, wrench)) or dot(load, wrench) <= 0):
            return "the load has to keep its direction"
        if name not in _SAME:
            continue
        if len(grasp) != len(before):
            return f"{len(grasp)} contacts; expected {len(before)}"
        for i, (one, other) in enumerate(zip(grasp, before, strict=True), 1):
            if _SAME[name](one) != _SAME[name](other):
                return f"contact {i} has to keep its {name}"
    return ""


def _judge_resisted(wanted: bool, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    resists = bool(solve(grasp, wrench))
    return resists is wanted or f"the grasp {'resists' if resists else 'does not resist'} this load"


def _equilibria(least: int, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    count = len(solve(grasp, wrench).equilibria)
    return count >= least or f"{count} equilibria; expected {least} or more"


def _states(wanted: list[str], grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    solutions = [piece.states for piece in solve(grasp, wrench).equilibria]
    right = any(
        len(states) == len(wanted)
        and all(w in (s, "any") for w, s in zip(wanted, states, strict=True))
        for states in solutions
    )
    listed = "; or ".join(", ".join(states) for states in solutions)
    return right or (
        f"the states are {listed}" if listed else "the grasp does not resist this load"
    )


def _gap(_: bool, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    if not any(wrench):
        return "the load is 0, so there is no ray"
    intervals = _resisted_multiples(grasp, wrench)
    if holds(intervals, Fraction(1)):
        return "the grasp resists this load"
    weaker = any(high is not None and high < 1 for _, high in intervals)
    stronger = any(low is not None and low > 1 for low, _ in intervals)
    return (weaker and stronger) or f"no {'stronger' if weaker else 'weaker'} load is resisted"


def _resisted_multiples(grasp: Grasp, wrench: Any) -> tuple[Interval, ...]:
    """Return the multiples of a load that a planar grasp resists."""
    resisted: Any = ResistedSet(grasp).along(wrench)
    intervals: tuple[Interval, ...] = resisted.intervals
    return intervals


def _border(_: bool, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    intervals = _resisted_multiples(grasp, wrench) if any(wrench) else ()
    return bool(intervals and intervals[-1][1] == 1) or "this is not the greatest load of its ray"


def _method(goal: Mapping[str, Any], grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    right, other = bool(solve(grasp, wrench)), predict(goal["name"], grasp, wrench)
    predictions = ["unstable", "stable"]
    words = f"the full model predicts {predictions[right]}, the method {predictions[bool(other)]}"
    return (other is goal["says"] and other is not right) or words


def _refutes(_: bool, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    if motion is None or len(motion) != 3:
        return 'there is no motion; expected {"link": "...", "motion": [x, y, r]}'
    document = {
        "schema_version": SCHEMA_VERSION,
        "certificate": "not resisted",
        "grasp": grasp.to_dict(),
    }
    report = check({**document, "wrench": list(map(str, wrench)), "tree": list(map(str, motion))})
    return bool(report) or report.problem


def _regions(count: int, grasp: Grasp, wrench: Any, motion: Any) -> Judged:
    number = grasp.tangential_arrangement().region_count()
    return number == count or f"{number} regions; expected {count}"


_SLIP_GOALS: Mapping[str, Callable[[Any, Grasp, Any, Any], Judged]] = {
    "resisted": _judge_resisted,
    "equilibria": _equilibria,
    "states": _states,
    "gap": _gap,
    "border": _border,
    "method": _method,
    "refutes": _refutes,
    "regions": _regions,
}


def _judge_lines(exercise: Mapping[str, Any], answer: tuple[str, Any]) -> Judged:
    start, planes = lines.read_start(exercise["start"]), lines.read_start(answer[0])
    for k in map(int, exercise["fixed"]):
        stays = len(planes) >= k and planes.integer_planes[k - 1] == start.integer_planes[k - 1]
        if not stays:
            return f"line {k} has to stay as it starts"
    [(kind, value)] = exercise["goal"].items()
    if kind == "counts":
        return _counts(value, planes)
    return _meeting(value if kind == "meet" else value["meet"], planes) or True


def _counts(wanted: Mapping[str, Any], planes: Arrangement) -> Judged:
    for name, value in wanted.items():
        number = _COUNTS[name](planes)
        if number != value:
            return f"{name.replace('_', ' ')}: {shown(number)}; expected {shown(value)}"
    return True


def _tally(numbers: Mapping[int, int]) -> dict[str, int]:
    return {str(k): count for k, count in numbers.items()}


def _triangles(planes: Arrangement) -> int:
    """Return how many regions of the projective plane, or bounded ones, have three sides."""
    if planes.dimension == 3:
        return planes.p_vector.get(3, 0) // 2 if planes.rank == 3 else 0
    return planes.bounded_p_vector.get(3, 0)


def _class_name(planes: Arrangement) -> str | None:
    """Return the isomorphism class as the lab names it; of more than six planes none."""
    identified = planes.identify()
    named = identified.type is not None and identified.planes <= lines.NAMED_PLANES
    return f"{identified.planes}.{identified.type}" if named else None


_COUNTS: Mapping[str, Callable[[Arrangement], Any]] = {
    "planes": len,
    "distinct_planes": lambda planes: len(planes.distinct),
    "dimension": lambda planes: planes.dimension,
    "rank": lambda planes: planes.rank,
    "f_vector": lambda planes: list(planes.f_vector),
    "regions": lambda planes: planes.region_count(),
    "bounded_regions": lambda planes: planes.bounded_region_count(),
    "characteristic_polynomial": lambda planes: [
        int(x) for x in planes.characteristic_polynomial().all_coeffs()
    ],
    "t_vector": lambda planes: _tally(planes.t_vector()),
    "p_vector": lambda planes: _tally(planes.p_vector),
    "simple": lambda planes: planes.is_simple,
    "simplicial": lambda planes: planes.is_simplicial,
    "triangles": _triangles,
    "type": _class_name,
}


def _meeting(lists: list[list[int]], planes: Arrangement) -> str:
    """Return why lists of lines do not meet in one point each, different points; "" if they do."""
    rows = [_homogeneous(row, planes.dimension) for row in planes.integer_planes]
    used = {k for concurrent in lists for k in concurrent}
    if missing := [k for k in sorted(used) if k > len(rows)]:
        return f"there is no line {missing[0]}"
    if len({_up_to_sign(rows[k - 1]) for k in used}) < len(used):
        return "two lines coincide"
    points = set()
    for concurrent in lists:
        point = _up_to_sign(cross(rows[concurrent[0] - 1], rows[concurrent[1] - 1]))
        if any(dot(rows[k - 1], point) for k in concurrent[2:]):
            return f"lines {', '.join(map(str, concurrent))} do not go through one point"
        points.add(point)
    return "two of the points coincide" if len(points) < len(lists) else ""


def _homogeneous(row: IntegerVector, dimension: int) -> IntegerVector:
    return row[:3] if dimension == 3 else (row[0], row[1], -row[2])


def _up_to_sign(row: Any) -> IntegerVector:
    vector = primitive(row)
    return max(vector, tuple(-x for x in vector))
