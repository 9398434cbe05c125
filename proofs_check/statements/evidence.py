"""Evidence and verdicts: how a claim is checked, and what follows.

A verdict is worked out from the records of checks and from nothing else: there is no way to set it.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from random import Random
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.hints import hints_on_arguments
from arrangement.numbers import budget
from proofs_check.errors import OwnClaimError

from .statement import Case, Claim, ClaimVerdict, Kind, Route, Strength, check_claim

#: What can come out of one instance. "outside": nothing is said of it; "excused": the statement
#: fails, and the saving hypothesis excludes the instance; "broken": the check itself failed.
OUTCOMES = ("holds", "fails", "excused", "broken", "outside")


@dataclass(frozen=True)
class Failure:
    """What stands in place of a value when a route raised an error."""

    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, repr=False)
class Record(ReprMixin):
    """The check of one case: the values of all routes side by side, and what they mean.

    Attributes:
        holds: the routes agree and the value is what the statement promises.
        covered: the saving hypothesis is true of the case (true when there is none).
    """

    label: str
    values: tuple[Any, ...]
    holds: bool
    covered: bool
    note: str = ""
    assumption: str = ""
    document: Mapping[str, Any] | None = None

    @property
    def agree(self) -> bool:
        """Whether every route that reaches the case gave a value, and all the same one."""
        return _agree(self.values)

    @property
    def outcome(self) -> str:
        """One of `OUTCOMES`."""
        if not self.agree:
            return "broken"
        if self.holds:
            return "holds" if self.covered else "outside"
        return "fails" if self.covered else "excused"


@dataclass(frozen=True, repr=False)
class Part(ReprMixin):
    """What was checked from one source.

    Attributes:
        checked, failures, passed_over, foreign: numbers of instances; those skipped are outside
            the hypotheses, foreign ones out of the domain.
    """

    kind: Kind
    over: str
    checked: int
    failures: int
    passed_over: int
    foreign: int


@dataclass(frozen=True, repr=False)
class Evidence(ReprMixin):
    """Everything that was checked for one claim.

    Attributes:
        parts: what came from each source, in numbers.
        searched: how many instances the search for the smallest counterexample tried.
        counterexample: the smallest one; None if every case holds.
    """

    seed: int
    parts: tuple[Part, ...]
    records: tuple[Record, ...]
    searched: int = 0
    counterexample: Record | None = None

    @property
    def disagreement(self) -> Record | None:
        """A case on which the routes differ or fail: then the check itself is broken."""
        return next((record for record in self.checked if not record.agree), None)

    @property
    def checked(self) -> tuple[Record, ...]:
        """The smallest counterexample, if there is one, and all cases."""
        return (*filter(None, [self.counterexample]), *self.records)

    @property
    def failures(self) -> tuple[Record, ...]:
        """The cases on which the statement is false."""
        return tuple(record for record in self.records if not record.holds)


@dataclass(frozen=True, repr=False)
class Result(ReprMixin):
    """A claim with its evidence, and the time it took. The verdict follows from the evidence."""

    repr_fields = ("verdict", "tried", "evidence", "claim")
    claim: Claim
    evidence: Evidence
    milliseconds: int | None = field(default=None, compare=False)

    @property
    def verdict(self) -> ClaimVerdict | None:
        """The verdict, or None when the evidence gives none (see `verdict_from`)."""
        return verdict_of(self.evidence)

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one in the registry."""
        return self.verdict is self.claim.expected

    @property
    def strength(self) -> Strength | None:
        """What the verdict is worth (see `strength_from`)."""
        return strength_from(self.verdict, self.claim.kind)

    @property
    def tried(self) -> int:
        """On how many cases the statement is true, those outside of an added hypothesis aside."""
        return sum(record.outcome == "holds" for record in self.evidence.records)

    @property
    def added_hypotheses(self) -> tuple[str, ...]:
        """What had to be added to the statement, for without it the statement is not confirmed."""
        if self.verdict is not ClaimVerdict.HOLDS_UNDER_HYPOTHESIS:
            return ()
        records = self.evidence.records
        excused = any(record.outcome == "excused" for record in self.evidence.checked)
        saving = [self.claim.hypothesis.text] if excused and self.claim.hypothesis else []
        return (*saving, *sorted({record.assumption for record in records if record.assumption}))


def verdict_of(evidence: Evidence) -> ClaimVerdict | None:
    """Work out the verdict of the records and the counterexample (see `verdict_from`)."""
    if not evidence.records:
        return None
    outcomes = Counter(record.outcome for record in evidence.checked)
    return verdict_from(outcomes, any(record.assumption for record in evidence.records))


def verdict_from(outcomes: Mapping[str, int], assumed: bool = False) -> ClaimVerdict | None:
    """Work out the verdict from how often each of `OUTCOMES` came out.

    None: nothing was checked that the statement is about, or the implementations disagree
    somewhere; then nothing follows. Refuted: some case fails although the saving hypothesis (if
    any) covers it. Holds under a hypothesis: the failures are all outside the hypothesis and some
    case is inside it, or a case could be read only by an assumption. Holds: no case fails.
    """
    holds, fails, excused, broken = (outcomes.get(name, 0) for name in OUTCOMES[:4])
    if broken or not holds + fails + excused:
        return None
    if fails or not holds:
        return ClaimVerdict.REFUTED
    return ClaimVerdict.HOLDS_UNDER_HYPOTHESIS if excused or assumed else ClaimVerdict.HOLDS


def strength_from(verdict: ClaimVerdict | None, kind: Kind) -> Strength | None:
    """Work out what a verdict is worth from how far its evidence reaches.

    One counterexample refutes, wherever it comes from; all else is as strong as the weakest source.
    """
    if verdict is None:
        return None
    if verdict is ClaimVerdict.REFUTED:
        return Strength.REFUTED
    stronger = {Kind.PROVED: Strength.PROVED, Kind.EXHAUSTIVE: Strength.ALL_CASES}
    return stronger.get(kind, Strength.SAMPLED)


def check(claim: Claim, case: Case) -> Record:
    """Run all routes on one case. A route that raises an error has no value to agree on."""
    values = tuple(_value(route, case.subject) for route in claim.routes)
    covered = claim.hypothesis is None or claim.hypothesis.covers(case.subject)
    holds = _agree(values) and claim.judge(case.subject, values[0])
    note = ""
    if broken := [value for value in values if isinstance(value, Failure)]:
        note = str(broken[0])
    elif not _agree(values):
        note = "the implementations disagree"
    elif claim.explain:
        note = claim.explain(case.subject, values[0])
    return Record(case.label, values, holds, covered, note, case.assumption, case.document)


def _value(route: Route, subject: Any) -> Any:
    """Return the value of a route, or its error as a value that agrees with nothing."""
    try:
        return route.compute(subject)
    except OwnClaimError:
        raise
    except Exception as error:
        where = "".join(f" ({note})" for note in getattr(error, "__notes__", ()) if note)
        return Failure(f"{type(error).__name__}: {error}{where}")


def _agree(values: tuple[Any, ...]) -> bool:
    """The first value is the one that is judged; a later one may be NotImplemented."""
    answers = [value for value in values if value is not NotImplemented]
    broken = values[0] is NotImplemented or any(isinstance(x, Failure) for x in answers)
    return not broken and all(bool(value == answers[0]) for value in answers[1:])


@hints_on_arguments({"samples": "dataclasses.replace(claim, samples=...)"})
def evaluate(claim: Claim, seed: int = 0, progress: Callable[[int], None] | None = None) -> Result:
    """Check a claim on all its cases, and look for the smallest counterexample.

    The random generator depends on seed and id alone: the order of claims changes no result.

    Args:
        claim: what is checked.
        seed: of the random instances.
        progress: called with the number of cases so far.

    Raises:
        OwnClaimError: what is not a claim.
    """
    check_claim(claim)
    if claim.large and budget.times() < math.inf:
        with budget.limit(math.inf):
            return evaluate(claim, seed, progress)
    started = time.perf_counter()
    generator = Random(f"{seed}/{claim.id}")
    records: list[Record] = []
    parts: list[Part] = []
    failing: list[tuple[Case, Record]] = []
    seen = 0
    for source in claim.all_sources(seed):
        first, passed_over, foreign, failures = len(records), 0, 0, len(failing)
        for case in source.cases(generator):
            seen += 1
            if progress:
                progress(seen)
            if not claim.includes(case.subject):
                outside = not claim.has_within(case.subject)
                foreign, passed_over = foreign + outside, passed_over + (not outside)
                continue
            records.append(check(claim, case))
            if not records[-1].holds:
                failing.append((case, records[-1]))
        counted = (len(records) - first, len(failing) - failures, passed_over, foreign)
        parts.append(Part(source.kind, source.over, *counted))
    searched, smallest = _smallest_failure(claim, failing)
    evidence = Evidence(seed, tuple(parts), tuple(records), searched, smallest)
    return Result(claim, evidence, round(1000 * (time.perf_counter() - started)))


def _smallest_failure(
    claim: Claim, failing: list[tuple[Case, Record]]
) -> tuple[int, Record | None]:
    """Return how many more instances were tried, and the smallest one that fails.

    In a search the first route alone looks; what it finds is checked by all. Errors of a route
    come first, for with one of them nothing else follows.
    """
    searched = 0
    for searched, case in enumerate(claim.search() if claim.search else (), 1):
        value = _value(claim.routes[0], case.subject)
        unusable = isinstance(value, Failure) or value is NotImplemented
        if unusable or not claim.judge(case.subject, value):
            return searched, check(claim, case)
    if failing and claim.smaller:
        agree = all(record.agree for _, record in failing)

        def fails(subject: Any) -> bool:
            if not claim.includes(subject):
                return False
            record = check(claim, Case("", subject))
            return record.agree == agree and not record.holds

        start = [case for case, record in failing if record.agree == agree]
        case, searched = claim.smaller(start, fails)
        return searched, check(claim, case)
    return searched, failing[0][1] if failing else None
