"""The table of all verdicts, the survey of disagreements, and their commands."""

import importlib
import json
from pkgutil import iter_modules

import pytest

from equilibrium import GraspError, methods, solve, solve_literal
from equilibrium.cli.program import main
from equilibrium.grasps.files import read_grasp
from equilibrium.methods.compare import ask, compare
from equilibrium.methods.contact_laws.frictionless_slip import frictionless_slip
from equilibrium.methods.friction_cones.weak_strong import weak_strong
from equilibrium.methods.method import Method
from equilibrium.methods.registry import DECIDING, METHODS
from equilibrium.methods.survey import OTHERS, shrunk, size, smallest_examples, survey
from equilibrium.wrench_sets.margin import margin


def test_an_answer_that_is_neither_yes_nor_no_has_no_truth_value():
    grasp = read_grasp("paper-three-contacts")
    found = compare(grasp, (0, 1, 0))
    assert not found
    assert not found["complete"]
    assert found["weak"]
    with pytest.raises(GraspError, match="neither yes nor no"):
        bool(found["form-closure"])
    with pytest.raises(GraspError, match="weak"):
        bool(weak_strong(grasp, (0, 1, 0)))


@pytest.mark.parametrize(
    ("name", "preload", "wrench", "stable", "disagreeing"),
    [
        # Without preload nothing holds an upward force; cones and closure methods say otherwise.
        ("paper-three-contacts", 0, (0, 1, 0), False, {"wrench-space", "weak"}),
        ("paper-three-contacts", 0, (0, -1, 0), True, {"linear-compliance"}),
        (
            "paper-three-contacts",
            1,
            (0, 1, 0),
            True,
            {"printed", "strong", "frictionless", "linear-compliance", "frictionless-slip"},
        ),
        ("paper-three-contacts", 1, (0, "11/10", 0), False, {"wrench-space", "weak"}),
        ("paper-four-contacts", 0, (0, 2, 0), False, {"wrench-space", "weak"}),
    ],
)
def test_rows_of_the_papers_tables(name, preload, wrench, stable, disagreeing):
    found = compare(read_grasp(name).with_preload(preload), wrench)
    assert found.stable is stable
    assert set(found.disagreeing) - {"printed"} == disagreeing - {"printed"}
    assert found["form-closure"].accepts is None
    assert [answer.method for answer in found.answers] == list(DECIDING)


@pytest.mark.parametrize(("wrench", "yes"), [((0, -1, 0), True), ((0, 1, 0), False)])
def test_a_result_is_true_exactly_when_it_says_yes(wrench, yes):
    grasp = read_grasp("paper-three-contacts")
    compared = compare(grasp, wrench)
    for found in (
        solve(grasp, wrench),
        solve_literal(grasp, wrench, ["single-solution"]),
        margin(grasp, wrench),
        frictionless_slip(grasp, wrench),
        compared,
        compared["complete"],
    ):
        assert bool(found) is yes
    for answer in compared.answers:
        if answer.accepts is not None:
            assert bool(answer) is answer.accepts
    assert compared["form-closure"].accepts is None


def test_every_file_of_a_method_is_in_the_table():
    files = (f"{methods.__name__}.{file.name}" for file in iter_modules(methods.__path__))
    values = [value for file in files for value in vars(importlib.import_module(file)).values()]
    written = {id(value) for value in values if isinstance(value, Method)}
    # Two methods with one key would leave one of them out.
    assert {id(method) for method in METHODS.values()} == written


def test_many_contacts_leave_the_exponential_method_out():
    grasp = read_grasp("paper-three-contacts")
    many = type(grasp)([*grasp.contacts] * 3)
    assert ask("frictionless-slip", many, (0, 0, 0)) is None


class TestSurvey:
    def test_every_question_is_counted_once(self):
        found = survey(4, contacts=(2, 3), seed=3)
        assert found.questions == 4
        for count in found.counts.values():
            assert sum(vars(count).values()) == 4
        assert found.to_dict() == survey(4, contacts=(2, 3), seed=3).to_dict()

    def test_methods_that_relax_the_model_never_refuse_wrongly(self):
        counts = survey(8, contacts=(2,)).counts
        for method in ("cones", "wrench-space", "weak"):
            assert counts[method].refuses_wrongly == 0

    def test_examples_disagree_and_cannot_be_made_smaller(self):
        examples = smallest_examples(methods=("frictionless", "wrench-space"), tries=20)
        assert examples
        for example in examples:
            assert ask(example.method, example.grasp, example.wrench) is example.accepts
            assert ask("complete", example.grasp, example.wrench) is not example.accepts
            again = shrunk(example)
            assert size(again.grasp, again.wrench) == size(example.grasp, example.wrench)
        kinds = [(example.method, example.accepts) for example in examples]
        assert len(set(kinds)) == len(kinds)
        # One contact pressed and pushed along its edge holds by friction alone.
        assert len(next(e for e in examples if e.method == "frictionless").grasp) == 1


class TestCommands:
    def test_compare(self, capsys):
        arguments = ["compare", "paper-three-contacts", "--wrench", "0", "-1", "0"]
        assert main([*arguments, "--json"]) == 0
        document = json.loads(capsys.readouterr().out)
        agreeing = {row["method"]: row["agrees"] for row in document["methods"]}
        assert agreeing.pop("linear-compliance") is False
        assert agreeing.pop("form-closure") is None
        assert agreeing.pop("printed") in (True, False)
        assert set(agreeing.values()) == {True}
        assert main(arguments) == 0
        lines = capsys.readouterr().out.splitlines()
        assert [line for line in lines if line.startswith("!") and "linear compliance" in line]

    def test_compare_exits_with_the_verdict_of_the_complete_model(self, capsys):
        arguments = ["compare", "paper-three-contacts", "--wrench", "0", "1", "0"]
        assert main(arguments) == 1
        assert main([*arguments, "--preload", "1"]) == 0
        assert main(["compare", "no-such-grasp", "--wrench", "0", "1", "0"]) == 2
        assert "error" in capsys.readouterr().err

    def test_wrench_space(self, capsys):
        assert main(["wrench-space", "paper-three-contacts", "--json"]) == 0
        document = json.loads(capsys.readouterr().out)
        assert document["force_closure"] is True
        # One row of four integers or rationals for each of the eight triangles of an octahedron.
        assert [len(row) for row in document["facets"]] == [4] * 8
        assert ["0", "1/2"] in document["slice"]["corners"]
        assert main(["wrench-space", "paper-three-contacts", "--norm", "Linf"]) == 0
        assert "volume" in capsys.readouterr().out

    def test_survey(self, capsys):
        arguments = ["survey", "--number", "4", "--contacts", "2", "--json"]
        assert main(arguments) == 0
        document = json.loads(capsys.readouterr().out)
        assert document["questions"] == 4
        assert set(document["methods"]) == set(OTHERS)
