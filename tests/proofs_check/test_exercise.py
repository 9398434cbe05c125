"""Exercises: every form of an answer, right and wrong; files of lecturers and of students."""

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement
from arrangement.errors import InputError
from equilibrium import Grasp, check, read_grasp, solve
from proofs_check import exercise
from proofs_check.cli.program import main
from proofs_check.course.exercise import FORMS, grade, load_exercises
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
}


def asked(of: str, judge: Callable[[Any], Any]) -> Any:
    return exercise("?", of=of, id="q")(judge)


def test_every_form_has_a_case():
    assert READ.keys() == FORMS.keys()


@pytest.mark.parametrize("of", READ)
def test_an_answer_is_read_or_refused_with_a_reason(of):
    good, value, bad = READ[of]
    assert asked(of, lambda given: given == value).mistake(good) == ""
    assert asked(of, lambda given: given != value).mistake(good) == "wrong"
    for answer, reason in bad.items():
        assert reason in asked(of, lambda given: True).mistake(answer)


def test_a_state_has_signs_or_words():
    assert "is no state" in asked("states", lambda given: True).mistake([["stick"], 3])


def test_a_certificate_is_judged_by_its_proof_and_its_question():
    def judge(document):
        return check(document, (GRASP, (Fraction(0), Fraction(0), Fraction(1))))

    question = asked("certificate", judge)
    assert question.mistake(NO) == ""
    assert question.mistake(YES).startswith("it is about another wrench: it is (")
    assert "work" in question.mistake({**NO, "tree": ["0", "0", "1"]})
    assert "tree" in question.mistake({**NO, "tree": 3})


def test_a_fault_of_the_lecturer_is_no_mistake_of_a_student():
    with pytest.raises(OwnClaimError, match="q raised ZeroDivisionError"):
        asked("number", lambda given: given / 0).mistake(1)
    with pytest.raises(OwnClaimError, match="q returned None"):
        asked("number", lambda given: None).mistake(1)
    for wrong in ({"of": "essay"}, {"points": -1}, {"points": True}):
        with pytest.raises(OwnClaimError, match=next(iter(wrong))):
            exercise("?", **wrong)
    with pytest.raises(OwnClaimError, match="is not an id"):
        exercise("?", id="Q 1")(lambda given: True)


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


def test_points_are_for_right_answers(desk, capsys):
    assert main(["grade", "lecture.py", hand_in(one=1, somewhere=GRASP.to_dict())]) == 0
    assert capsys.readouterr().out.split()[-4:] == ["5", "of", "5", "points"]
    command = ["grade", "lecture.py", hand_in(one="1", somewhere=Grasp().to_dict()), "--json"]
    assert main(command) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["points"], found["most"]) == (2, 5)
    assert [one["mistake"] for one in found["exercises"]] == ["", "only 0 contacts"]
    assert main(["grade", "lecture.py", hand_in()]) == 1
    assert capsys.readouterr().out.count("no answer") == 2


def test_without_answers_the_questions_are_listed(desk, capsys):
    assert main(["grade", "lecture.py"]) == 0
    assert "One? Answer: number" in capsys.readouterr().out
    assert main(["grade", "lecture.py", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["exercises"][1]["of"] == "grasp"


def test_answers_to_nothing_and_other_files_are_refused(desk, capsys):
    with pytest.raises(InputError, match="two"):
        grade(load_exercises("lecture.py"), {"schema_version": 1, "answers": {"two": 2}})
    for bad in ("[]", '{"schema_version": 1, "answers": []}', "print(1)"):
        Path("bad.json").write_text(bad, encoding="utf-8")
        assert main(["grade", "lecture.py", "bad.json"]) == 2
    Path("empty.py").write_text("x = 1", encoding="utf-8")
    assert main(["grade", "empty.py"]) == 2
    assert "has no exercises" in capsys.readouterr().err
    twice = LECTURE + LECTURE.replace("def one", "def uno").replace("points=2", 'id="one"')
    Path("twice.py").write_text(twice.replace("def somewhere", "def there"), encoding="utf-8")
    assert main(["grade", "twice.py"]) == 2
    assert "two exercises with one id" in capsys.readouterr().err
