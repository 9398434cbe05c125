"""The course: its lectures have their time, name what is there, and its homework can be done."""

import re

import pytest

from equilibrium import read_grasp, solve
from proofs_check import registry
from proofs_check.course.exercise import grade, load_exercises
from tests.docpages import ROOT

COURSE = ROOT / "docs" / "course"
SYLLABI = {"two-lectures": 2, "four-lectures": 4, "eight-lectures": 8}
ANSWERS = {
    "wrench": ([0, -2, -6], [0, -2, 6]),
    "unit-vector": (["697/985", "696/985"], ["3/5", "4/5"]),
    "all-stick": ([1, 0, 0], [0, 0, 1]),
    "missing-signs": (["+++-", "---+"], ["+++-"]),
    "orders": (24, 26),
    "few-regions": tuple(
        {
            "schema_version": 1,
            "planes": [["1", "0", "0"], ["0", "1", "0"], ["1", "1", "0"], last, ["0", "0", "1"]],
        }
        for last in (["1", "2", "0"], ["1", "2", "3"])
    ),
    "let-go": ([0, 1, 0], [0, -1, 0]),
    "too-much": tuple(
        solve(read_grasp("paper-three-contacts-preload-1"), (0, pull, 0)).certificate.to_dict()
        for pull in (2, 3)
    ),
    "top-push": ("1/2", "1/3"),
}


@pytest.mark.parametrize("name", SYLLABI)
def test_each_lecture_takes_ninety_minutes(name):
    text = (COURSE / f"{name}.rst").read_text(encoding="utf-8")
    lectures = re.split(r"(?m)^Lecture \d+: ", text)[1:]
    minutes = [[int(m) for m in re.findall(r"(?m)^   \* - (\d+)$", one)] for one in lectures]
    assert [sum(one) for one in minutes] == [90] * SYLLABI[name]
    for part in ("*Aims.*", "*Material:*", "*Homework.*"):
        assert all(part in one for one in lectures)


@pytest.mark.parametrize("name", SYLLABI)
def test_syllabus_names_existing_items(name):
    text = " ".join((COURSE / f"{name}.rst").read_text(encoding="utf-8").split())
    lessons = {path.stem for path in (ROOT / "docs" / "lessons").glob("*.rst")}
    linked = set(re.findall(r"<\.\./lessons/([\w-]+)-(?:slides|exercises)\.html>", text))
    assert linked
    assert linked <= lessons
    claims = [
        claim
        for part in re.findall(r"\*Claims\.\*(.*?)(?:\.$|: |; | Lecture |$)", text)
        for claim in re.findall(r"`(?:proofs-check list )?([\w-]+)`", part)
    ]
    assert claims
    assert set(claims) <= {claim.id for claim in registry()}


def test_homework_points_for_right_answers_only():
    exercises = load_exercises(str(COURSE / "homework.py"))
    assert list(exercises) == list(ANSWERS)
    for which, share in ((0, 1), (1, 0)):
        answers = {id: pair[which] for id, pair in ANSWERS.items()}
        marks = grade(exercises, {"schema_version": 1, "answers": answers})
        assert [mark.points for mark in marks.values()] == [
            share * one.points for one in exercises.values()
        ], which
