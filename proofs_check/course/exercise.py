"""Exercises for a course: a decorated function that gets an answer and returns True or a reason.

The lecturer writes a Python file, the students hand in JSON, and ``proofs-check grade FILE.py
ANSWERS.json`` marks one of them, or a folder of them. A function may compute what is right, or
only check: a certificate proves its verdict whoever wrote it, and a counterexample is one whoever
found it. ::

    from proofs_check import exercise

    @exercise("Give a grasp of two contacts that resists no pull upwards.", of="grasp")
    def no_pull(grasp):
        return len(grasp) == 2 and not solve(grasp, (0, 1, 0)).stable

The lecturer's file is run with all rights, as with ``python FILE.py``. Answers are read, never run.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction
from pathlib import Path
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.errors import InputError
from arrangement.hints import hints_on_arguments
from arrangement.library.files.json_files import (
    Source,
    check_keys,
    check_list,
    kind_of,
    read_document,
    read_text,
)
from arrangement.library.files.table import read_arrangement
from arrangement.numbers.exact import rational, rational_vector, shown
from equilibrium.certificate.checker import check
from equilibrium.certificate.report import Report
from equilibrium.model.grasp import Grasp
from proofs_check.errors import OwnClaimError
from proofs_check.own_claims.claim_file import id_of, line_of, values_in_file

from .lab_exercises import BUILT_IN, lab_judges, read_link


@dataclass(frozen=True, repr=False)
class Exercise(ReprMixin):
    """A question with a check of its answers.

    Attributes:
        id: its key in a file of answers.
        question: in words.
        of: what an answer is, a key of `FORMS`.
        points: for a right answer.
        judge: gets an answer as `FORMS` reads it; returns a Boolean, the report of a checked
            certificate, a text that says what is wrong, or a pair of the points that the answer
            gets and such a text.
    """

    id: str
    question: str
    of: str
    points: int
    judge: Callable[[Any], Any]

    def mark(self, answer: Any) -> GradedAnswer:
        """Return the points of an answer, given as in a file, and what is wrong with it.

        Raises:
            OwnClaimError: the function raised an error, or returned something else.
        """
        try:
            value = FORMS[self.of][0](answer)
        except InputError as error:
            return self._grade(0, str(error))
        try:
            judgement = self.judge(value)
        except Exception as error:
            where = line_of(error, self.judge.__code__.co_filename)
            text = f"{type(error).__name__}: {error}"
            raise OwnClaimError(f"{self.id} raised {text} ({where})") from error
        match judgement:
            case Report():
                return self._grade(0, judgement.problem)
            case bool():
                return self._grade(0, "" if judgement else "wrong")
            case (points, text) if self._is_part(points) and isinstance(text, str) and text:
                return self._grade(Fraction(points), text)
            case str() if judgement:
                return self._grade(0, judgement)
        raise OwnClaimError(
            f"{self.id} returned {shown(judgement)}; return True, False, the report of "
            "`verify`, a text that describes the error, or a pair of points below "
            f"{self.points} and such a text"
        )

    def _is_part(self, points: Any) -> bool:
        return type(points) in (int, Fraction) and 0 <= points < self.points

    def _grade(self, points: Fraction | int, mistake: str) -> GradedAnswer:
        return GradedAnswer(Fraction(points if mistake else self.points), self.points, mistake)


@dataclass(frozen=True)
class GradedAnswer:
    """What one answer gets: points, and what is wrong with it.

    Attributes:
        points: from 0 to `most`.
        most: for a right answer.
        mistake: what is wrong, in words; an empty text if the answer is right.
    """

    points: Fraction
    most: int
    mistake: str


@hints_on_arguments({"answer": "of", "kind": "of", "marks": "points", "text": "question"})
def exercise(
    question: str, *, of: str = "number", points: int = 1, id: str | None = None
) -> Callable[[Callable[[Any], Any]], Exercise]:
    """Make an exercise of a function that gets an answer and returns True or a reason.

    Args:
        question: in words.
        of: what an answer is: "number", "numbers", "states", "certificate", "grasp" or "planes".
        points: for a right answer, at least 0.
        id: if omitted, the name of the function.

    Raises:
        OwnClaimError: an argument out of range.
    """
    if of not in FORMS:
        raise OwnClaimError(f"of is {shown(of)}; give one of {', '.join(FORMS)}")
    if type(points) is not int or points < 0:
        raise OwnClaimError(f"points is {shown(points)}; give an integer, at least 0")

    def decorate(function: Callable[[Any], Any]) -> Exercise:
        return Exercise(id_of(function, id), question, of, points, function)

    return decorate


def load_exercises(path: str) -> dict[str, Exercise]:
    """Return the exercises of a file by id, in its order.

    Args:
        path: of a Python file, which is run; or those of a lab: a JSON file, ``slip-lab`` or
            ``arrangement-lab``. Their ids are their names.

    Raises:
        OwnClaimError: the file cannot be read or run, has no exercises, or two with one id.
        InputError: a JSON file has no exercises of a lab.
    """
    if path in BUILT_IN or path.lower().endswith(".json"):
        return {
            name: Exercise(name, task, "link", 1, judge)
            for name, (task, judge) in lab_judges(path).items()
        }
    if (ending := Path(path).suffix.lower()) not in ("", ".py"):
        raise OwnClaimError(
            f"{path} ends in {ending}; exercises are a Python file, those of a lab a JSON file. "
            "Answers come behind it: grade FILE.py ANSWERS.json"
        )
    exercises = values_in_file(path, Exercise, "exercises; decorate a function with @exercise(...)")
    named = {exercise.id: exercise for exercise in exercises}
    if len(named) < len(exercises):
        raise OwnClaimError(f"{path} has two exercises with one id")
    return named


def grade(exercises: Mapping[str, Exercise], source: Source) -> dict[str, GradedAnswer]:
    """Mark the answers of a file, by the ids of the exercises.

    An answer to what was not asked gets nothing; where an exercise has no answer, its mark says
    which key was meant for it, as far as can be guessed.

    Raises:
        InputError: this is not a file of answers.
    """
    document = read_document(source, ("answers",), floats=float)
    check_keys(document, ("schema_version", "answers"), ("description",), "the file of answers")
    answers = document["answers"]
    if not isinstance(answers, Mapping):
        raise InputError(f"answers is {kind_of(answers)}; give a JSON object, one key an exercise")
    strange = [key for key in answers if key not in exercises]
    return {
        id: exercise.mark(answers[id])
        if id in answers
        else GradedAnswer(Fraction(), exercise.points, _no(id, strange))
        for id, exercise in exercises.items()
    }


def _no(id: str, strange: Sequence[str]) -> str:
    """Return that there is no answer, and the key that was perhaps meant for it."""
    near = get_close_matches(id, strange, 1)
    return (
        f"no answer; {shown(near[0])} is not an exercise, was this one meant?"
        if near
        else "no answer"
    )


def grade_folder(
    exercises: Mapping[str, Exercise], folder: Path
) -> dict[str, dict[str, GradedAnswer] | InputError]:
    """Mark all files of answers (``*.json``) of a folder, by their names without the ending.

    Instead of its marks a file that cannot be read has the error, and so has one on which a check
    failed: neither keeps the others from their marks.

    Raises:
        InputError: the folder has no such file.
    """
    files = sorted(folder.glob("*.json"))
    if not files:
        raise InputError(f"{folder} has no files of answers; their names end with .json")
    graded: dict[str, dict[str, GradedAnswer] | InputError] = {}
    for file in files:
        try:
            graded[file.stem] = grade(exercises, file)
        except InputError as error:
            graded[file.stem] = error
    return graded


def _states(answer: Any) -> frozenset[tuple[str, ...]]:
    """Read a list of states; each is a text of signs, or a list of words."""
    for state in check_list(answer, "the answer"):
        if not isinstance(state, (str, list)) or not all(isinstance(name, str) for name in state):
            raise InputError(f'{shown(state)} is not a state; write "+-0" or ["slip+", "stick"]')
    return frozenset(map(tuple, answer))


def _certificate(answer: Any) -> Mapping[str, Any]:
    """Read a certificate, be it right or wrong."""
    check(_object(answer))
    return _object(answer)


def _object(answer: Any) -> Mapping[str, Any]:
    if not isinstance(answer, Mapping):
        raise InputError(f"the answer is {shown(answer)}; give the JSON object of a file")
    return answer


#: What an answer can be: how it is read, and what it looks like.
FORMS: Mapping[str, tuple[Callable[[Any], Any], str]] = {
    "number": (lambda answer: rational(answer, "the answer"), 'such as 14 or "7/3"'),
    "numbers": (lambda answer: rational_vector(answer, "the answer"), 'such as [0, "1/2"]'),
    "states": (_states, 'a set, such as ["+-0"] or [["slip+", "stick"]]'),
    "certificate": (_certificate, "what `equilibrium solve --certificate` writes"),
    "grasp": (lambda answer: Grasp.from_dict(_object(answer)), "a grasp file"),
    "planes": (lambda answer: read_arrangement(_object(answer)), "an arrangement file"),
    "link": (read_link, "what the button `copy link` of the lab gives"),
}


@dataclass(frozen=True)
class ClassList:
    """The rows of a class.

    Attributes:
        columns: the first line.
        rows: of a student each, whose first entry is the name of the file of answers.
        delimiter: between entries, a comma or a semicolon.
    """

    columns: Sequence[str] = ("name",)
    rows: Sequence[Sequence[str]] = ()
    delimiter: str = ","

    @classmethod
    def of(cls, names: Iterable[str]) -> ClassList:
        """Return the class of all files of a folder."""
        return cls(rows=[[name] for name in names])

    @classmethod
    def read(cls, path: str, names: Iterable[str]) -> ClassList:
        """Return the class of a file.

        Args:
            names: of the files of answers, each of which is of a student.

        Raises:
            InputError: a row is not as long as the first, or a student stands there twice or not.
        """
        text, source = read_text(path)
        text = text.removeprefix("\ufeff")
        first = text.partition("\n")[0]
        delimiter = ";" if first.count(";") > first.count(",") else ","
        lines = csv.reader(io.StringIO(text), delimiter=delimiter)
        table = [[cell.strip() for cell in line] for line in lines if any(map(str.strip, line))]
        columns, *rows = table or [[]]
        if not rows:
            raise InputError(
                f"{source} has no rows; expected a first line with names, and students"
            )
        for number, row in enumerate(rows, 2):
            if len(row) != len(columns):
                raise InputError(
                    f"{source} line {number} has {len(row)} entries; expected {len(columns)}"
                )
        known = [row[0] for row in rows]
        if twice := [name for name in known if known.count(name) > 1]:
            raise InputError(f"{source} has {shown(twice[0])} twice; expected different names")
        if strange := sorted({*names} - {*known}):
            raise InputError(
                f"{strange[0]}.json is not of a student in {source}; expected one of its first "
                "column. Add a row, or rename the file"
            )
        return cls(columns, rows, delimiter)

    def table(self, columns: Sequence[str], results: Mapping[str, Sequence[str]]) -> str:
        """Return the rows with columns of results as CSV."""
        lines = io.StringIO()
        table = csv.writer(lines, delimiter=self.delimiter, lineterminator="\n")
        table.writerow([*self.columns, *columns])
        for row in self.rows:
            table.writerow([*map(_cell, row), *map(_cell, results[row[0]])])
        return lines.getvalue()


def _cell(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(("=", "+", "-", "@")) else text
