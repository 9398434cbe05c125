"""Exercises: every form of an answer, right and wrong; files of lecturers and of students."""

import csv
import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement
from equilibrium import Grasp, read_grasp, solve
from equilibrium.certificate.checker import check
from proofs_check import exercise
from proofs_check.course.exercise import FORMS
from proofs_check.errors import OwnClaimError

GRASP = read_grasp("opposed-contacts")
YES = solve(GRASP, (1, 0, 0)).certificate.to_dict()
NO = solve(GRASP, (0, 0, 1)).certificate.to_dict()

#: The form of an answer: what is read of a good one, and texts that refuse bad ones.
READ: dict[str, tuple[Any, Any, dict[Any, str]]] = {
    "number": ("7/3", Fraction(7, 3), {0.5: "the float 0.5", "x": "x", True: "Boolean"}),
    "numbers": ([1, "1/2"], (1, Fraction(1, 2)), {"12": "sequence", 3: "sequence"}),
    "states": (["+-", ["slip+", "stick"]], {("+", "-"), ("slip+", "stick")}, {"+-": "list"}),
    "certificate": (NO, NO, {"proof": "JSON object", "{}": "JSON object"}),
    "grasp": (GRASP.to_dict(), GRASP, {"opposed-contacts": "JSON object"}),
    "planes": (
        {"schema_version": 1, "planes": [["1", "0"]]},
        Arrangement([[1, 0]]),
        {"coordinate-planes": "JSON object"},
    ),
    "link": ("file:///lab.html#1%7C2%7C", ("1|2|", None), {7: "a link of the lab"}),
}


def asked(of: str, judge: Callable[[Any], Any]) -> Any:
    return exercise("?", of=of, id="q")(judge)


def test_every_form_has_a_case():
    assert READ.keys() == FORMS.keys()


@pytest.mark.parametrize("of", READ)
def test_an_answer_is_read_or_refused_with_a_reason(of):
    good, value, bad = READ[of]
    assert asked(of, lambda given: given == value).mark(good).mistake == ""
    assert asked(of, lambda given: given != value).mark(good).mistake == "wrong"
    for answer, reason in bad.items():
        assert reason in asked(of, lambda given: True).mark(answer).mistake


def test_a_state_has_signs_or_words():
    assert "is not a state" in asked("states", lambda given: True).mark([["stick"], 3]).mistake


def test_a_certificate_is_judged_by_its_proof_and_its_question():
    def judge(document):
        return check(document, (GRASP, (Fraction(0), Fraction(0), Fraction(1))))

    question = asked("certificate", judge)
    assert question.mark(NO).mistake == ""
    assert question.mark(YES).mistake.startswith("it is about another wrench: it is (")
    assert "work" in question.mark({**NO, "tree": ["0", "0", "1"]}).mistake
    assert "tree" in question.mark({**NO, "tree": 3}).mistake


def test_a_fault_of_the_lecturer_is_no_mistake_of_a_student():
    with pytest.raises(OwnClaimError, match="q raised ZeroDivisionError"):
        asked("number", lambda given: given / 0).mark(1)
    with pytest.raises(OwnClaimError, match="q returned None"):
        asked("number", lambda given: None).mark(1)
    for part in ((1, "half"), (-1, "less"), (0, ""), (0.5, "half"), (True, "all")):
        with pytest.raises(OwnClaimError, match="a pair of points below 1"):
            asked("number", lambda given, part=part: part).mark(1)
    for wrong in ({"of": "essay"}, {"points": -1}, {"points": True}):
        with pytest.raises(OwnClaimError, match=next(iter(wrong))):
            exercise("?", **wrong)
    for name, words in (("Q 1", "is not an id"), ("q" * 81, "longer than 80 characters")):
        with pytest.raises(OwnClaimError, match=words):
            exercise("?", id=name)(lambda given: True)


LECTURE = """
from proofs_check import exercise
@exercise("One?", points=2)
def one(answer):
    return answer == 1
@exercise("Where?", of="grasp", points=3)
def somewhere(grasp: "Grasp"):
    return len(grasp) > 1 or f"only {len(grasp)} contacts"
"""


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "lecture.py").write_text(LECTURE, encoding="utf-8")
    return tmp_path


def hand_in(**answers: Any) -> str:
    document = {"schema_version": 1, "answers": answers}
    Path("mine.json").write_text(json.dumps(document), encoding="utf-8")
    return "mine.json"


def test_points_are_for_right_answers(desk, run):
    graded = run("grade lecture.py", hand_in(one=1, somewhere=GRASP.to_dict()))
    assert graded.split()[-4:] == ["5", "of", "5", "points"]
    command = ["grade", "lecture.py", hand_in(one="1", somewhere=Grasp().to_dict()), "--json"]
    found = json.loads(run(*command, code=1))
    assert (found["points"], found["most"]) == (2, 5)
    assert [one["mistake"] for one in found["exercises"]] == ["", "only 0 contacts"]
    assert run("grade lecture.py", hand_in(), code=1).count("no answer") == 2


def test_without_answers_the_questions_are_listed(desk, run):
    assert "One? Answer: number" in run("grade lecture.py")
    assert run.json("grade lecture.py")["exercises"][1]["of"] == "grasp"


def test_a_class_is_marked_whatever_one_of_it_hands_in(desk, run, refused):
    sloppy = """@exercise("Minus one?", points=3)
def sign(answer):
    return (Fraction(3, 2), "the sign") if 2 / answer == 2 else answer == -1"""
    text = f"from fractions import Fraction\n{LECTURE}{sloppy}"
    (desk / "lecture.py").write_text(text, encoding="utf-8")
    folder = desk / "class"
    folder.mkdir()
    for name, answers in {
        "=ada": '{"one": 1, "sign": -1, "somewhere": ' + json.dumps(GRASP.to_dict()) + "}",
        "bob": '{"one": -1.5, "sign": 1, "some-where": 3}',
        "cy": '{"one": ',
        "dan": '{"one": 1, "sign": 0}',
    }.items():
        document = f'{{"schema_version": 1, "answers": {answers}}}'
        (folder / f"{name}.json").write_text(document, encoding="utf-8")
    assert "sign 3/2 of 3" in run("grade lecture.py class -o points.csv", code=2)
    head, *rows = csv.reader((desk / "points.csv").read_text(encoding="utf-8").splitlines())
    assert head == ["name", "one", "somewhere", "sign", "total", "error"]
    assert rows[:2] == [["'=ada", "2", "3", "3", "8", ""], ["bob", "0", "0", "1.5", "1.5", ""]]
    assert [row[:5] for row in rows[2:]] == [["cy", *[""] * 4], ["dan", *[""] * 4]]
    assert "JSON" in rows[2][5]
    assert "ZeroDivisionError" in rows[3][5]
    ada, bob, *_ = map(json.loads, run("grade lecture.py class --json", code=2).splitlines())
    assert (ada["points"], bob["points"]) == (8, "3/2")
    assert "'some-where' is not an exercise" in bob["exercises"][1]["mistake"]
    (folder / "cy.json").unlink()
    (folder / "dan.json").unlink()
    run("grade lecture.py class", code=1)
    refused("grade lecture.py class/bob.json -o x.csv")
    (desk / "empty").mkdir()
    refused("grade lecture.py empty")
