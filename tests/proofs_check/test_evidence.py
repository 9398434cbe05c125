"""Evidence in numbers: what is counted, what is searched, and which verdict follows."""

import math
from dataclasses import dataclass, replace
from itertools import product
from typing import Any
from unittest.mock import ANY

import pytest

from arrangement.numbers import budget
from proofs_check import (
    Case,
    Claim,
    ClaimError,
    ClaimVerdict,
    Evidence,
    Hypothesis,
    Kind,
    Record,
    Registry,
    Route,
    Source,
    evaluate,
)
from proofs_check.errors import OwnClaimError
from proofs_check.statements.evidence import OUTCOMES, Failure, Part, check, verdict_from
from proofs_check.statements.statement import Domain


def numbers(low: int, high: int) -> list[Case]:
    return [Case(f"n = {n}", n, {"n": n}) for n in range(low, high)]


def claim(**changes: Any) -> Claim:
    """A claim on squares of 0 to 9: they are below 30; every attribute can be changed."""
    base = Claim(
        id="squares",
        locator="Section 0",
        statement="n^2 is below 30.",
        quantity="n^2",
        routes=(Route("product", lambda n: n * n), Route("sum", lambda n: sum([n] * n))),
        judge=lambda n, square: square < 30,
        sources=(
            Source(Kind.PROVED, "to 4", lambda rng: numbers(0, 5)),
            Source(Kind.EXHAUSTIVE, "to 9", lambda rng: numbers(5, 10)),
        ),
    )
    return replace(base, **changes)


def test_verdict_of_counts():
    for holds, fails, excused, broken in product((0, 1, 5), repeat=4):
        outcomes = dict(zip(OUTCOMES, (holds, fails, excused, broken, 7), strict=True))
        found = [verdict_from(outcomes), verdict_from(outcomes, assumed=True)]
        if broken or not (holds or fails or excused):
            assert found == [None, None]
        elif fails or holds == 0:
            assert found == [ClaimVerdict.REFUTED] * 2
        elif excused:
            assert found == [ClaimVerdict.HOLDS_UNDER_HYPOTHESIS] * 2
        else:
            assert found == [ClaimVerdict.HOLDS, ClaimVerdict.HOLDS_UNDER_HYPOTHESIS]


@pytest.mark.parametrize(
    ("values", "agree"),
    [
        ((1,), True),
        ((1, 1, 1), True),
        ((1, 2, 1), False),
        ((1, 1, 2), False),
        ((1, NotImplemented), True),
        ((1, NotImplemented, 2), False),
        ((NotImplemented, 1), False),
        ((Failure("x"),), False),
        ((1, Failure("x")), False),
        ((ANY, Failure("x")), False),
        ((math.nan,), True),
    ],
)
def test_routes_agree_or_the_check_is_broken(values, agree):
    for holds, covered in product((False, True), repeat=2):
        record = Record("", values, holds, covered)
        kinds = {
            (True, True): "holds",
            (True, False): "outside",
            (False, True): "fails",
            (False, False): "excused",
        }
        assert record.agree is agree
        assert record.outcome == (kinds[holds, covered] if agree else "broken")


def test_sources_are_counted_apart():
    seen: list[int] = []
    some = claim(within=lambda n: n not in (1, 8), applies=lambda n: n not in (3, 4, 8))
    evidence = evaluate(some, 3, seen.append).evidence
    assert evidence.parts == (
        Part(Kind.PROVED, "to 4", 2, 0, 2, 1),
        Part(Kind.EXHAUSTIVE, "to 9", 4, 3, 0, 1),
    )
    assert seen == list(range(1, 11))
    parts = evaluate(replace(some, judge=lambda n, square: n in (0, 7))).evidence.parts
    assert [(part.checked, part.failures) for part in parts] == [(2, 1), (4, 3)]
    assert [record.label for record in evidence.records] == [f"n = {n}" for n in (0, 2, 5, 6, 7, 9)]
    assert [record.label for record in evidence.failures] == ["n = 6", "n = 7", "n = 9"]
    assert (evidence.seed, evidence.searched) == (3, 0)
    assert Evidence(3, (), ()).searched == 0
    assert evidence.counterexample == evidence.failures[0]


def test_a_result_is_as_expected_or_not():
    assert evaluate(claim(expected=ClaimVerdict.REFUTED)).as_expected
    result = evaluate(claim())
    assert not result.as_expected
    assert 0 <= result.milliseconds < 900
    assert result.evidence.seed == 0


def test_one_assumption_is_enough_for_a_hypothesis():
    cases = [Case("2", 2), Case("3", 3, assumption="3 is meant")]
    some = claim(sources=(Source(Kind.EXHAUSTIVE, "two", lambda rng: cases),))
    assert evaluate(some).verdict is ClaimVerdict.HOLDS_UNDER_HYPOTHESIS


def test_the_first_disagreement_is_that_of_the_counterexample():
    right, wrong = Record("a", (1, 1), True, True), Record("b", (1, 2), True, True)
    assert Evidence(0, (), (right,)).disagreement is None
    assert Evidence(0, (), (right, wrong)).disagreement is wrong
    other = replace(wrong, label="c")
    assert Evidence(0, (), (right, wrong), 1, other).disagreement is other
    assert Evidence(0, (), (wrong, other), 1, right).disagreement is wrong


def test_a_check_notes_what_went_wrong_first():
    def fail(n: int) -> int:
        error = ValueError("bad")
        error.add_note("here")
        raise error

    product_, other = claim().routes
    failing = Route("fails", fail)
    explained = claim(explain=lambda n, square: f"{square} of {n}")
    case = Case("five", 5, assumption="a")
    assert check(explained, case) == Record("five", (25, 25), True, True, "25 of 5", "a")
    assert check(claim(), case).note == ""
    beyond = Route("beyond", lambda n: NotImplemented)
    record = check(replace(explained, routes=(product_, beyond)), case)
    assert (record.note, record.holds) == ("25 of 5", True)
    differing = Route("other", lambda n: n + 1)
    record = check(replace(explained, routes=(product_, differing)), case)
    assert (record.note, record.holds) == ("the implementations disagree", False)
    record = check(replace(explained, routes=(product_, failing, other)), case)
    assert (record.note, record.holds) == ("ValueError: bad (here)", False)
    later = Route("fails, too", lambda n: 1 // 0)
    assert check(claim(routes=(failing, later)), case).note == "ValueError: bad (here)"
    for hypothesis in (
        Hypothesis("n = 5", lambda n: n == 5),
        Hypothesis("n = 6", lambda n: n == 6),
    ):
        assert check(claim(hypothesis=hypothesis), case).covered is (hypothesis.text == "n = 5")


def test_errors_of_own_claims_are_no_values():
    def fail(n: int) -> int:
        raise OwnClaimError("wrong file")

    with pytest.raises(OwnClaimError, match="wrong file"):
        evaluate(claim(routes=(Route("fails", fail),)))


@pytest.mark.parametrize(
    ("search", "searched", "label"),
    [
        (range(9), 7, "n = 6"),
        (range(4), 4, "n = 6"),
        (range(7, 9), 1, "n = 7"),
        ((), 0, "n = 6"),
    ],
)
def test_a_search_ends_at_its_first_counterexample(search, searched, label):
    some = claim(search=lambda: [Case(f"n = {n}", n) for n in search])
    evidence = evaluate(some).evidence
    assert (evidence.searched, evidence.counterexample.label) == (searched, label)
    assert evaluate(replace(some, judge=lambda n, square: True)).evidence.counterexample is None


@pytest.mark.parametrize("value", [NotImplemented, None])
def test_a_search_ends_where_the_first_route_has_no_value(value):
    def compute(n: int) -> Any:
        return value.missing if value is None and n == 2 else value if n == 2 else n * n

    routes = (Route("first", compute), claim().routes[1])
    found = evaluate(claim(routes=routes, sources=(), search=lambda: numbers(0, 9))).evidence
    assert (found.searched, found.counterexample.label) == (3, "n = 2")
    assert found.disagreement is found.counterexample


@pytest.mark.parametrize("wrong", [None, 7])
def test_a_failure_is_made_smaller_among_those_of_its_kind(wrong):
    tested: list[list[Any]] = []

    def smaller(cases: list[Case], fails: Any) -> tuple[Case, int]:
        tested.append([case.subject for case in cases])
        tested.append([n for n in range(12) if fails(n)])
        return cases[-1], 12

    routes = (claim().routes[0], Route("other", lambda n: n * n + (n == wrong)))
    some = claim(routes=routes, smaller=smaller, within=lambda n: n != 10)
    evidence = evaluate(some).evidence
    assert evidence.searched == 12
    if wrong is None:
        assert tested == [[6, 7, 8, 9], [6, 7, 8, 9, 11]]
        assert evidence.counterexample.label == "n = 9"
    else:
        assert tested == [[7], [7]]
        assert evidence.disagreement.label == "n = 7"


def test_where_nothing_fails_nothing_is_made_smaller():
    some = claim(judge=lambda n, square: True, smaller=lambda cases, fails: (cases[0], 1))
    assert evaluate(some).evidence.counterexample is None


def test_a_large_claim_has_no_budget():
    def compute(n: int) -> bool:
        return budget.times() == math.inf

    for large in (False, True):
        some = claim(large=large, routes=(Route("budget", compute),), judge=lambda n, free: free)
        verdict = ClaimVerdict.HOLDS if large else ClaimVerdict.REFUTED
        assert evaluate(some).verdict is verdict


@dataclass(frozen=True)
class Drawn:
    size: int
    number: float

    def to_dict(self) -> dict[str, Any]:
        return {"size": self.size}


DOMAIN = Domain(
    "some", "some things", "planes", 2, lambda rng, n: Drawn(n, rng.random()), bool, most=5
)


def test_random_instances_depend_on_seed_id_and_number():
    some = claim(domain=DOMAIN, samples=7, sizes=(2, 4), sources=())
    (source,) = some.all_sources(1)
    cases = list(source.cases(None))
    assert source.kind is Kind.SAMPLED
    assert source.over == "7 random some things with 2 to 4 planes"
    assert [case.label for case in cases] == [f"sample {k}" for k in range(7)]
    assert [case.subject.size for case in cases] == [2, 3, 4, 2, 3, 4, 2]
    assert cases[3].document == {"size": 2}
    assert some.draw(1, 3, (2, 4)) == cases[3].subject
    others = [
        some.draw(2, 3, (2, 4)),
        some.draw(1, 6, (2, 4)),
        replace(some, id="b").draw(1, 3, (2, 4)),
    ]
    assert cases[3].subject not in others
    (source,) = replace(some, sizes=(3, 3)).all_sources(1)
    assert source.over == "7 random some things with 3 planes"
    with pytest.raises(OwnClaimError, match="not about random instances"):
        claim().draw(0, 0, (2, 3))


@pytest.mark.parametrize(
    ("low", "high", "good"),
    [(2, 5, True), (3, 3, True), (1, 5, False), (2, 6, False), (4, 3, False)],
)
def test_a_domain_names_its_sizes(low, high, good):
    words = "some things need at least 2 and at most 5, smaller number first"
    assert DOMAIN.mistake(low, high) == ("" if good else words)
    assert replace(DOMAIN, most=None).mistake(2, 999) == ""


def test_a_claim_is_as_strong_as_its_weakest_source():
    sampled = {"domain": DOMAIN, "samples": 3, "sizes": (2, 3)}
    assert claim().kind is Kind.EXHAUSTIVE
    assert claim(sources=claim().sources[:1]).kind is Kind.PROVED
    assert claim(**sampled).kind is Kind.SAMPLED
    assert claim(sources=()).kind is Kind.SAMPLED
    assert claim().over == "to 4; to 9"
    assert claim(**sampled).over == "to 4; to 9; random some things"
    for some in (claim(domain=DOMAIN), claim(samples=3)):
        assert some.over == "to 4; to 9"
        assert len(list(some.all_sources(0))) == 2
    assert claim().sizes == (0, 0)


def test_a_registry_has_each_claim_once():
    first, second = claim(), claim(id="others")
    known = Registry([first, second])
    assert (known.ids, len(known), list(known)) == (("squares", "others"), 2, [first, second])
    assert known["others"] is second
    assert replace(second, routes=(first.routes[0], Route("other", abs)))(7) == 49
    for routes in (
        (first.routes[0], replace(first.routes[1], name="product")),
        (first.routes[0], replace(first.routes[0], name="again")),
    ):
        with pytest.raises(ClaimError, match="one route twice"):
            Registry([claim(routes=routes)])
    with pytest.raises(ClaimError, match="no id is near"):
        known["zzzz"]
    with pytest.raises(ClaimError, match="the nearest are squares"):
        known["square"]
