"""Claims on other methods: as expected, both routes beyond the paper's questions, faults caught."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

from equilibrium.methods.compare import ask as right
from proofs_check import Verdict, evaluate, registry
from proofs_check.claims import methods

IDS = [claim.id for claim in methods.CLAIMS]


@pytest.mark.parametrize("id", IDS)
def test_each_verdict_is_the_expected_one(id):
    assert evaluate(registry()[id]).as_expected


@pytest.mark.parametrize("id", IDS)
@pytest.mark.parametrize("wrench", [(0, 0, 0), (1, 0, 0), (0, "1/3", "-1/2"), (-1, 2, 1)])
def test_both_routes_agree_on_other_wrenches(id, wrench):
    asked = next(iter(registry()[id].cases(Random(0)))).subject
    question = replace(asked.question, wrench=tuple(map(Fraction, wrench)))
    other = replace(asked, question=question)
    assert methods._by_packages(other) == methods._by_elimination(other)


@pytest.mark.parametrize("friction", ["1", "101/100"])
def test_cones_need_friction_above_one(friction):
    asked = next(iter(registry()["method-cones-only"].cases(Random(0)))).subject
    rows = tuple((*row[:4], Fraction(friction), *row[5:]) for row in asked.question.contacts)
    turned = replace(asked, question=replace(asked.question, contacts=rows))
    assert methods._by_elimination(turned)[0] is (Fraction(friction) > 1)


def test_a_method_that_says_the_opposite_is_caught(monkeypatch):
    monkeypatch.setattr(methods, "ask", lambda *question: not right(*question))
    assert all(evaluate(registry()[id]).verdict is None for id in IDS)


def test_a_statement_turned_round_is_refuted():
    claim = registry()["method-frictionless-slip-up"]
    wrong = replace(claim, judge=lambda asked, found: found == (True, True))
    assert evaluate(wrong).verdict is Verdict.REFUTED
