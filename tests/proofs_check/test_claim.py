"""The verdict follows from the evidence, and from nothing else."""

import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import replace
from random import Random

import pytest
from hypothesis import given, settings, strategies as st

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
    registry,
)
from proofs_check.claims.stated import stated
from proofs_check.errors import UnknownClaimError
from proofs_check.statements.evidence import verdict_of


def numbers(last: int) -> list[Case]:
    return [Case(f"n = {n}", n, {"n": n}) for n in range(last + 1)]


def on(cases: Callable[[Random], Iterable[Case]]) -> tuple[Source, ...]:
    return (Source(Kind.EXHAUSTIVE, "n up to 9", cases),)


def claim(**changes: object) -> Claim:
    """A claim on squares; every attribute can be changed."""
    base = Claim(
        id="squares",
        locator="Section 0",
        statement="n^2 is at least n.",
        quantity="n^2",
        routes=(
            Route("multiplication", lambda n: n * n),
            Route("sum of odd numbers", lambda n: sum(range(1, 2 * n, 2))),
        ),
        sources=on(lambda rng: numbers(9)),
        judge=lambda n, square: square >= n,
    )
    return replace(base, **changes)


def test_false_claim_refuted_by_smallest_counterexample():
    false = claim(judge=lambda n, square: square < 20, search=lambda: numbers(20))
    result = evaluate(false)
    assert result.verdict is ClaimVerdict.REFUTED
    assert result.verdict == "refuted"
    assert not result.as_expected
    assert result.evidence.counterexample is not None
    assert result.evidence.counterexample.document == {"n": 5}


def strictly(n: int, square: int) -> bool:
    return square > n


HELD, NARROW = ClaimVerdict.HOLDS_UNDER_HYPOTHESIS, Hypothesis("n >= 2", lambda n: n >= 2)
WIDE, NEVER = Hypothesis("n >= 1", lambda n: n >= 1), Hypothesis("no", lambda n: False)
ASSUMED = Case("n", 3, None, assumption="3 is meant")


@pytest.mark.parametrize(
    ("changes", "verdict"),
    [
        ({}, ClaimVerdict.HOLDS),
        # A search beyond the cases can refute.
        ({"judge": lambda n, _: n < 15, "search": lambda: numbers(20)}, ClaimVerdict.REFUTED),
        # A hypothesis saves only what it covers, and nothing if it covers no case.
        ({"judge": strictly}, ClaimVerdict.REFUTED),
        ({"judge": strictly, "hypothesis": NARROW}, HELD),
        ({"judge": strictly, "hypothesis": WIDE}, ClaimVerdict.REFUTED),
        ({"judge": lambda n, square: False, "hypothesis": NEVER}, ClaimVerdict.REFUTED),
        # A case read by an assumption gives no plain holds.
        ({"sources": on(lambda rng: [ASSUMED])}, HELD),
        ({"sources": on(lambda rng: [])}, None),
    ],
)
def test_the_verdict_follows_from_the_cases(changes, verdict):
    assert evaluate(claim(**changes)).verdict is verdict


def test_routes_that_disagree_give_no_verdict():
    broken = claim(
        routes=(Route("right", lambda n: n * n), Route("wrong", lambda n: n * n + (n == 7)))
    )
    result = evaluate(broken)
    assert result.verdict is None
    assert not result.as_expected
    assert result.evidence.disagreement is not None
    assert result.evidence.disagreement.label == "n = 7"


def test_a_route_that_fails_gives_no_verdict():
    broken = claim(
        routes=(Route("right", lambda n: n * n), Route("fails", lambda n: n * n * n // n))
    )
    result = evaluate(broken)
    assert result.verdict is None
    assert str(result.evidence.records[0].values[1]).startswith("ZeroDivisionError")


records = st.builds(
    Record,
    label=st.just("case"),
    values=st.tuples(st.integers(0, 1), st.integers(0, 1)),
    holds=st.booleans(),
    covered=st.booleans(),
)


@given(st.lists(records, max_size=5), st.none() | records)
@settings(max_examples=60)
def test_holds_needs_evidence_without_failure(checked, extra):
    assert verdict_of(Evidence(0, (), ())) is None
    evidence = Evidence(0, (), tuple(checked), counterexample=extra)
    if verdict_of(evidence) is ClaimVerdict.HOLDS:
        assert checked
        assert all(record.holds and record.agree for record in checked)
        assert extra is None or (extra.holds and extra.agree)


def test_evaluation_depends_on_the_seed_and_the_id_alone():
    def cases(rng):
        return [Case("n", rng.randrange(10**5))]

    values = [
        evaluate(claim(sources=on(cases)), seed).evidence.records[0].values for seed in (1, 1, 2)
    ]
    assert values[0] == values[1] != values[2]
    other = evaluate(claim(id="others", sources=on(cases)), 1).evidence.records[0].values
    assert other != values[0]


def test_ids_are_unique():
    with pytest.raises(ClaimError, match="two claims have the id 'squares'"):
        Registry([claim(), claim()])


def test_one_route_cannot_be_both():
    route = Route("multiplication", lambda n: n * n)
    with pytest.raises(ClaimError, match="one route twice"):
        Registry([claim(routes=(route, route))])


def test_an_unknown_id_names_the_nearest():
    with pytest.raises(UnknownClaimError, match="the nearest are table-four-contacts"):
        registry()["table-for-contact"]


def test_every_claim_says_what_it_states_and_where():
    for entry in registry():
        assert entry.statement.endswith("."), entry.id
        assert entry.locator, entry.id
        assert entry.quantity, entry.id
        assert entry.over, entry.id
        assert entry.expected is not ClaimVerdict.HOLDS_UNDER_HYPOTHESIS or (
            entry.hypothesis or entry.id == "table-four-contacts"
        ), entry.id


def test_claims_of_the_paper_are_made_when_asked_for():
    program = (
        "import sys; from proofs_check import registry; registry()['table-three-contacts']\n"
        "loaded = {n[20:] for n in sys.modules if n.startswith('proofs_check.claims.')}\n"
        "assert loaded == {'tables', 'stated'}, loaded\n"
        "assert 'networkx' not in sys.modules"
    )
    run = subprocess.run([sys.executable, "-c", program], timeout=60, check=False)
    assert run.returncode == 0
    assert len(Registry(registry())) == len(registry().ids)


@pytest.mark.parametrize("words", [{"solver"}, {"elimination", "solver", "other"}])
def test_words_of_implementations_are_those_of_the_text(words):
    with pytest.raises(ValueError, match="expected elimination, solver"):
        stated("single-solution", cases=numbers, judge=strictly, **dict.fromkeys(words, abs))


def test_place_in_the_paper_names_its_claims():
    with pytest.raises(
        UnknownClaimError, match="the nearest are fukuda-bound, fukuda-bound-attain"
    ):
        registry()["eq.11"]
