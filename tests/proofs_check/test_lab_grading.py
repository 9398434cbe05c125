"""Exercises of the labs are graded as the labs check them; a class as a list of students says."""

import csv
import json
from pathlib import Path

import pytest

from arrangement.pictures.lab.lines import line_exercises
from equilibrium.pictures.lab.page import slip_exercises
from proofs_check.course.exercise import load_exercises
from tests.equilibrium.test_lab_exercises import REFUSED, SOLVED

SOLUTIONS = json.loads(
    (Path(__file__).parent.parent / "arrangement" / "lab_solutions.json").read_text("utf-8")
)
SLIP = {one["name"]: one for one in slip_exercises()}
LINES = {one["name"]: one for one in line_exercises()}


@pytest.mark.parametrize("name", SLIP)
def test_slip_exercise_takes_right_links_only(name):
    exercise, start = load_exercises("slip-lab")[name], SLIP[name]["start"]
    for link in SOLVED.get(name, lambda _: [])(start):
        assert exercise.mark(link).mistake == "", link
    for link, _ in REFUSED[name](start):
        assert exercise.mark(link).mistake, link


def test_motion_that_refutes_is_checked_as_a_certificate():
    exercise = load_exercises("slip-lab")["One motion is enough"]
    start = SLIP[exercise.id]["start"]
    right = {"link": start, "motion": ["-3", "3", "1"]}
    marks = [exercise.mark(answer) for answer in (right, {**right, "motion": [0, 0, 1]}, start)]
    assert [mark.points for mark in marks] == [1, 0, 0], [mark.mistake for mark in marks]


@pytest.mark.parametrize("name", LINES)
def test_line_exercise_is_solved_by_its_own_solution_only(name):
    exercise = load_exercises("arrangement-lab")[name]
    assert exercise.mark(f"file:///lab.html#{SOLUTIONS[name]}").mistake == ""
    assert exercise.mark(LINES[name]["start"]).mistake
    other = list(SOLUTIONS).index(name) - 1
    assert exercise.mark(list(SOLUTIONS.values())[other]).mistake


@pytest.mark.parametrize("answer", ["", "1|9", 7, "1|3|1,0", {"link": "1|2|"}])
def test_what_is_no_link_is_a_wrong_answer(answer):
    for lab in ("slip-lab", "arrangement-lab"):
        assert not any(one.mark(answer).points for one in load_exercises(lab).values())


def test_lab_files_are_told_apart_and_refused(tmp_path, monkeypatch, refused):
    monkeypatch.chdir(tmp_path)
    for name, one in (("slip", SLIP["Let one go"]), ("lines", LINES["A near-pencil"])):
        document = {"schema_version": 1, "exercises": [one]}
        Path(f"{name}.json").write_text(json.dumps(document), encoding="utf-8")
        assert list(load_exercises(f"{name}.json")) == [one["name"]]
    Path("twice.json").write_text(
        json.dumps({"schema_version": 1, "exercises": [LINES["A near-pencil"]] * 2}), "utf-8"
    )
    Path("none.json").write_text('{"schema_version": 1, "exercises": []}', encoding="utf-8")
    assert "two exercises of one name" in refused("grade twice.json")
    assert "empty list" in refused("grade none.json")


LECTURE = """from proofs_check import exercise
@exercise('Twice 7?', points=2)
def twice(answer):
    return answer == 14 or (1, "nearly") if answer > 9 else False
"""


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("lecture.py").write_text(LECTURE, encoding="utf-8")
    Path("class").mkdir()
    for name, answer in (("u1", 14), ("u2", 10)):
        text = json.dumps({"schema_version": 1, "answers": {"twice": answer}})
        (Path("class") / f"{name}.json").write_text(text, encoding="utf-8")
    return tmp_path


def test_class_list_decides_rows_and_keeps_its_columns(course, run):
    text = "\ufeffID;Name\nu2;Müller, Bob\nu3;Ada\nu1;Carl\n"
    Path("list.csv").write_text(text, encoding="utf-8")
    words = ["grade", "lecture.py", "class", "--students", "list.csv", "-o", "points.csv"]
    assert [line.split()[0] for line in run(*words, code=1).splitlines()] == ["u2", "u3", "u1"]
    with Path("points.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream, delimiter=";"))
    assert rows == [
        ["ID", "Name", "twice", "total", "error"],
        ["u2", "Müller, Bob", "1", "1", ""],
        ["u3", "Ada", "0", "0", "nothing handed in"],
        ["u1", "Carl", "2", "2", ""],
    ]


@pytest.mark.parametrize("sign", ["=", "+", "-", "@"])
def test_no_cell_of_a_class_list_is_a_formula(sign, course, run):
    text = f"ID,Name\nu1,{sign}SUM(A1)\nu2,a{sign}b\n"
    Path("list.csv").write_text(text, encoding="utf-8")
    run("grade lecture.py class --students list.csv -o p.csv", code=1)
    _, first, second = Path("p.csv").read_text(encoding="utf-8").splitlines()
    assert first.startswith(f"u1,'{sign}SUM(A1),")
    assert second.startswith(f"u2,a{sign}b,")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "has no rows"),
        ("ID\nu1\n", "u2.json is not of a student in"),
        ("ID\nu1\nu1\nu2\n", "has 'u1' twice"),
        ("ID,Name\nu1\nu2,b\n", "line 2 has 1 entries; expected 2"),
    ],
)
def test_class_list_that_does_not_fit_is_refused(text, said, course, refused):
    Path("list.csv").write_text(text, encoding="utf-8")
    assert said in refused("grade lecture.py class --students list.csv")
