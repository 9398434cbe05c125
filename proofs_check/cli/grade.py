"""The command that grades answers to the exercises of a course."""

from __future__ import annotations

import argparse
import shutil
from collections.abc import Mapping

from arrangement.console import terminal
from proofs_check.course.exercise import FORMS, Exercise, grade, load_exercises
from proofs_check.reports import text


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade a file of answers; without one, list the questions."""
    exercises = load_exercises(arguments.exercises)
    if arguments.answers is None:
        return _list(exercises, arguments.json)
    mistakes = grade(exercises, arguments.answers)
    points = {id: 0 if mistakes[id] else one.points for id, one in exercises.items()}
    got, most = sum(points.values()), sum(one.points for one in exercises.values())
    if arguments.json:
        found = [{"id": id, "points": points[id], "mistake": mistakes[id]} for id in mistakes]
        terminal.print_json({"exercises": found, "points": got, "most": most})
    else:
        _table(
            [
                *(
                    (id, f"{points[id]} of {one.points}", mistakes[id] or "right")
                    for id, one in exercises.items()
                ),
                ("total", f"{got} of {most}", "points"),
            ]
        )
    return terminal.NO if any(mistakes.values()) else terminal.YES


def _list(exercises: Mapping[str, Exercise], as_json: bool) -> int:
    if as_json:
        asked = [
            {"id": id, "points": one.points, "of": one.of, "question": one.question}
            for id, one in exercises.items()
        ]
        terminal.print_json({"exercises": asked})
    else:
        _table(
            [
                (id, f"{one.points} p", f"{one.question} Answer: {one.of}, {FORMS[one.of][1]}.")
                for id, one in exercises.items()
            ]
        )
    return terminal.YES


def _table(rows: list[tuple[str, str, str]]) -> None:
    print("\n".join(text.table(rows, shutil.get_terminal_size().columns)))
