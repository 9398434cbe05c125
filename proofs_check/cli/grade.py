"""The commands of a course: answers graded, and numbers in print compared with computed ones."""

from __future__ import annotations

import argparse
import shutil
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict

from arrangement.console import terminal
from proofs_check.course.exercise import FORMS, Exercise, grade, load_exercises
from proofs_check.course.printed_table import Row, check_table, value_text
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


_WORDS = {True: "agree", False: "differ", None: "not computed"}


def run_table(arguments: argparse.Namespace) -> int:
    """Print each row of a table with both values; exit 1 if two differ.

    Rows of one quantity that print different numbers are in conflict, computed or not.
    """
    total: Counter[str] = Counter()
    first: dict[tuple[str, str], Row] = {}
    for row in check_table(arguments.table):
        other = first.setdefault((row.arrangement, row.quantity), row)
        verdict = "conflict" if row.printed != other.printed else _WORDS[row.agrees]
        total[verdict] += 1
        if arguments.json:
            terminal.print_json({**asdict(row), "verdict": verdict})
        else:
            note = f", line {other.line} prints {value_text(other.printed)}"
            print(f"{verdict:<12}  {_line(row)}{note if verdict == 'conflict' else ''}")
    if not arguments.json:
        print(", ".join(f"{number} {verdict}" for verdict, number in total.items()))
    return terminal.NO if total["differ"] or total["conflict"] else terminal.YES


def _line(row: Row) -> str:
    what = f"{row.arrangement}, {row.quantity}: printed {value_text(row.printed)}"
    found = row.reason if row.computed is None else f"computed {value_text(row.computed)}"
    return f"{what}, {found}"
