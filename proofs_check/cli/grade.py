"""The command grade: answers to exercises."""

from __future__ import annotations

import argparse
import shutil
from collections.abc import Iterable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

from arrangement.console import terminal
from arrangement.console.number_form import number
from arrangement.console.writing import write_text_atomically
from arrangement.errors import InputError
from proofs_check.course.exercise import (
    FORMS,
    ClassList,
    Exercise,
    GradedAnswer,
    grade,
    grade_folder,
    load_exercises,
)
from proofs_check.reports import text

#: The mistake of a student without a file.
_NOTHING = "nothing handed in"


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade a file of answers, or a folder of them; without one, list the questions."""
    exercises = load_exercises(arguments.exercises)
    if arguments.answers is None:
        return _list(exercises, arguments.json)
    if Path(arguments.answers).is_dir():
        return _class(exercises, grade_folder(exercises, Path(arguments.answers)), arguments)
    for option, value in (("-o", arguments.output), ("--students", arguments.students)):
        if value:
            raise InputError(f"{option} is for a folder; {arguments.answers} is one file")
    marks = grade(exercises, arguments.answers)
    got, most = _total(marks)
    if arguments.json:
        terminal.print_json({"exercises": _documents(marks), "points": _json(got), "most": most})
    else:
        rows = [
            (id, _of(mark.points, mark.most), mark.mistake or "right") for id, mark in marks.items()
        ]
        _table([*rows, ("total", _of(got, most), "points")])
    return _code(marks)


def _class(
    exercises: Mapping[str, Exercise],
    marks_by_file: Mapping[str, dict[str, GradedAnswer] | InputError],
    arguments: argparse.Namespace,
) -> int:
    """Print the points of a class, a line a student, and write them as CSV.

    Raises:
        InputError: a file could not be marked; this is said after all others are.
    """
    students = arguments.students
    rows = ClassList.read(students, marks_by_file) if students else ClassList.of(marks_by_file)
    nothing = {
        id: GradedAnswer(Fraction(), exercise.points, _NOTHING)
        for id, exercise in exercises.items()
    }
    marked = {row[0]: marks_by_file.get(row[0], nothing) for row in rows.rows}
    if arguments.output:
        columns = [*exercises, "total", "error"]
        results = {name: _results(marks, exercises) for name, marks in marked.items()}
        write_text_atomically(arguments.output, rows.table(columns, results))
    for name, marks in marked.items() if arguments.json else ():
        if isinstance(marks, InputError):
            terminal.print_json({"name": name, "error": str(marks)})
        else:
            got, most = _total(marks)
            document = {"exercises": _documents(marks), "points": _json(got), "most": most}
            terminal.print_json({"name": name, **document})
    if not arguments.json:
        _table([(name, *_line_of_class(marks)) for name, marks in marked.items()])
    right = [marks for marks in marked.values() if not isinstance(marks, InputError)]
    if lost := len(marked) - len(right):
        raise InputError(
            f"{lost} of {len(marked)} files could not be marked; their lines give the reason"
        )
    return max(map(_code, right))


def _results(marks: dict[str, GradedAnswer] | InputError, ids: Iterable[str]) -> list[str]:
    """Return points, their sum and an error; decimals, since a spreadsheet takes 3/2 for a day."""
    if isinstance(marks, InputError):
        return [*("" for _ in ids), "", str(marks)]
    points = [mark.points for mark in marks.values()]
    empty = all(mark.mistake is _NOTHING for mark in marks.values())
    return [*(f"{float(x):g}" for x in (*points, sum(points))), _NOTHING if empty else ""]


def _line_of_class(marks: dict[str, GradedAnswer] | InputError) -> tuple[str, str]:
    if isinstance(marks, InputError):
        return "not marked", str(marks)
    if all(mark.mistake is _NOTHING for mark in marks.values()):
        return _of(*_total(marks)), _NOTHING
    wrong = [
        f"{id} {number(mark.points)} of {mark.most}" for id, mark in marks.items() if mark.mistake
    ]
    return _of(*_total(marks)), ", ".join(wrong) or "all right"


def _total(marks: Mapping[str, GradedAnswer]) -> tuple[Fraction, int]:
    every = marks.values()
    return sum((mark.points for mark in every), Fraction()), sum(mark.most for mark in every)


def _code(marks: Mapping[str, GradedAnswer]) -> int:
    return terminal.NO if any(mark.mistake for mark in marks.values()) else terminal.YES


def _of(points: Fraction, most: int) -> str:
    return f"{number(points)} of {most}"


def _documents(marks: Mapping[str, GradedAnswer]) -> list[dict[str, Any]]:
    return [
        {"id": id, "points": _json(mark.points), "mistake": mark.mistake}
        for id, mark in marks.items()
    ]


def _json(points: Fraction) -> int | str:
    return points.numerator if points.denominator == 1 else str(points)


def _list(exercises: Mapping[str, Exercise], as_json: bool) -> int:
    if as_json:
        names = ("id", "points", "of", "question")
        asked = [
            {name: getattr(exercise, name) for name in names} for exercise in exercises.values()
        ]
        terminal.print_json({"exercises": asked})
    else:
        _table(
            [
                (
                    id,
                    f"{exercise.points} p",
                    f"{exercise.question} Answer: {exercise.of}, {FORMS[exercise.of][1]}.",
                )
                for id, exercise in exercises.items()
            ]
        )
        first = next(iter(exercises))
        print(f'Hand in a file {{"schema_version": 1, "answers": {{"{first}": ..., ...}}}}.')
    return terminal.YES


def _table(rows: list[tuple[str, str, str]]) -> None:
    print("\n".join(text.table(rows, shutil.get_terminal_size().columns)))
