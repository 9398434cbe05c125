"""Claims, evidence and verdicts: what a statement is, how it is checked, what follows.

A claim is a statement about every instance of some domain. Two routes that share no code compute,
for one instance, the quantity that the statement is about; a judge says whether a value of that
quantity is what the statement promises. A verdict is worked out from the records of such checks
and from nothing else: there is no way to set it.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from enum import Enum
from typing import Any

from .errors import ClaimError, UnknownClaimError


class Verdict(Enum):
    """What the evidence says about a statement."""

    HOLDS = "holds"
    HOLDS_UNDER_HYPOTHESIS = "holds under a hypothesis"
    REFUTED = "refuted"


class Kind(Enum):
    """How far evidence reaches.

    PROVED: a proof, each finite part of which the cases check. EXHAUSTIVE: every instance of the
    stated domain. SAMPLED: random instances.
    """

    PROVED = "proved"
    EXHAUSTIVE = "exhaustive"
    SAMPLED = "sampled"


@dataclass(frozen=True)
class Case:
    """One instance on which a claim is checked.

    Attributes:
        label: short text that names it.
        subject: what the routes take.
        document: the instance in file form, so that it can be checked again.
        assumption: what had to be assumed to read the instance at all (a misprint).
    """

    label: str
    subject: Any
    document: Mapping[str, Any] | None = None
    assumption: str = ""


@dataclass(frozen=True)
class Route:
    """A way to compute the quantity of a claim; the name says how."""

    name: str
    compute: Callable[[Any], Any]


@dataclass(frozen=True)
class Failure:
    """What stands in place of a value when a route raised an error."""

    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Hypothesis:
    """A condition on instances under which a statement is true although it fails without."""

    text: str
    covers: Callable[[Any], bool]


@dataclass(frozen=True)
class Claim:
    """A statement and the two routes by which it is checked.

    Attributes:
        id: unique, lower case words with hyphens.
        locator: section, equation, algorithm or table of the paper.
        statement: in own words, never softened.
        hypotheses: under which the statement is made.
        quantity: what both routes compute.
        routes: two; they share no code, and must give equal values.
        cases: the instances, from a random generator that is seeded for this claim.
        judge: whether a value on a subject is what the statement promises.
        kind: of the evidence, and
        over: what the cases are.
        expected: the verdict of the registry; it decides the exit code and nothing else.
        hypothesis: the condition that saves the statement, if there is one.
        search: instances from the smallest upwards, for the smallest counterexample.
        explain: a remark on one checked subject and its value.
        meaning: what the verdict means for the conclusions of the paper.
        rows: whether a report shows every case.
    """

    id: str
    locator: str
    statement: str
    quantity: str
    routes: tuple[Route, Route]
    cases: Callable[[random.Random], Iterable[Case]]
    judge: Callable[[Any, Any], bool]
    kind: Kind
    over: str
    expected: Verdict
    hypotheses: tuple[str, ...] = ()
    hypothesis: Hypothesis | None = None
    search: Callable[[], Iterable[Case]] | None = None
    explain: Callable[[Any, Any], str] | None = None
    meaning: str = ""
    rows: bool = False


@dataclass(frozen=True)
class Record:
    """The check of one case: the values of both routes side by side, and what they mean.

    Attributes:
        holds: the routes agree and the value is what the statement promises.
        covered: the saving hypothesis is true of the case (true when there is none).
    """

    label: str
    values: tuple[Any, Any]
    holds: bool
    covered: bool
    note: str = ""
    assumption: str = ""
    document: Mapping[str, Any] | None = None

    @property
    def agree(self) -> bool:
        """Whether both routes gave a value, and the same one."""
        return _agree(*self.values)


@dataclass(frozen=True)
class Evidence:
    """Everything that was checked for one claim.

    Attributes:
        searched: how many instances the search for the smallest counterexample tried.
        counterexample: the smallest one; None if every case holds.
    """

    kind: Kind
    over: str
    seed: int
    records: tuple[Record, ...]
    searched: int = 0
    counterexample: Record | None = None

    @property
    def disagreement(self) -> Record | None:
        """The first case on which the routes differ or fail: then the check itself is broken."""
        checked = (*self.records, *filter(None, [self.counterexample]))
        return next((record for record in checked if not record.agree), None)

    @property
    def failures(self) -> tuple[Record, ...]:
        """The cases on which the statement is false."""
        return tuple(record for record in self.records if not record.holds)


@dataclass(frozen=True)
class Result:
    """A claim with its evidence, and the time it took. The verdict follows from the evidence."""

    claim: Claim
    evidence: Evidence
    milliseconds: int | None = field(default=None, compare=False)

    @property
    def verdict(self) -> Verdict | None:
        """The verdict, or None when the evidence gives none (see `verdict_of`)."""
        return verdict_of(self.evidence)

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one in the registry."""
        return self.verdict is self.claim.expected


def verdict_of(evidence: Evidence) -> Verdict | None:
    """Work out the verdict.

    None: no case was checked, or the routes disagree somewhere; then nothing follows.
    Refuted: some case fails although the saving hypothesis (if any) covers it.
    Holds under a hypothesis: the failures are all outside the hypothesis and some case is inside
    it, or a case could be read only by an assumption. Holds: no case fails.
    """
    failures = [*evidence.failures, *filter(None, [evidence.counterexample])]
    if not evidence.records or evidence.disagreement is not None:
        return None
    if any(record.covered for record in failures):
        return Verdict.REFUTED
    if failures:
        inside = any(record.covered for record in evidence.records)
        return Verdict.HOLDS_UNDER_HYPOTHESIS if inside else Verdict.REFUTED
    if any(record.assumption for record in evidence.records):
        return Verdict.HOLDS_UNDER_HYPOTHESIS
    return Verdict.HOLDS


def check(claim: Claim, case: Case) -> Record:
    """Run both routes on one case. A route that raises an error has no value to agree on."""
    first, second = (_value(route, case.subject) for route in claim.routes)
    holds = _agree(first, second) and claim.judge(case.subject, first)
    covered = claim.hypothesis is None or claim.hypothesis.covers(case.subject)
    explained = claim.explain is not None and not isinstance(first, Failure)
    note = claim.explain(case.subject, first) if claim.explain and explained else ""
    return Record(case.label, (first, second), holds, covered, note, case.assumption, case.document)


def _value(route: Route, subject: Any) -> Any:
    """Return the value of a route, or its error as a value that agrees with nothing."""
    try:
        return route.compute(subject)
    except Exception as error:
        return Failure(f"{type(error).__name__}: {error}")


def _agree(first: Any, second: Any) -> bool:
    broken = isinstance(first, Failure) or isinstance(second, Failure)
    return not broken and bool(first == second)


def evaluate(
    claim: Claim, seed: int = 0, progress: Callable[[Record], None] | None = None
) -> Result:
    """Check a claim on all its cases, and look for the smallest counterexample.

    The random generator depends on the seed and the id alone, so that claims can run in any
    order, or alone, with the same result.
    """
    started = time.perf_counter()
    generator = random.Random(f"{seed}/{claim.id}")
    records = []
    for case in claim.cases(generator):
        records.append(check(claim, case))
        if progress:
            progress(records[-1])
    searched, smallest = _smallest_failure(claim, progress)
    if smallest is None:
        smallest = next((record for record in records if not record.holds), None)
    evidence = Evidence(claim.kind, claim.over, seed, tuple(records), searched, smallest)
    return Result(claim, evidence, round(1000 * (time.perf_counter() - started)))


def _smallest_failure(
    claim: Claim, progress: Callable[[Record], None] | None
) -> tuple[int, Record | None]:
    """Return how many instances were tried, and the first on which the statement is false.

    The first route alone looks; what it finds is checked by both.
    """
    searched = 0
    for case in claim.search() if claim.search else ():
        searched += 1
        value = _value(claim.routes[0], case.subject)
        if isinstance(value, Failure) or not claim.judge(case.subject, value):
            record = check(claim, case)
            if progress:
                progress(record)
            return searched, record
    return searched, None


class Registry:
    """Claims by id, in order of entry; ids are unique."""

    def __init__(self, claims: Iterable[Claim] = ()) -> None:
        self._claims: dict[str, Claim] = {}
        for claim in claims:
            self.add(claim)

    def add(self, claim: Claim) -> None:
        """Enter a claim.

        Raises:
            ClaimError: another claim has the same id, or the two routes are one.
        """
        if claim.id in self._claims:
            raise ClaimError(f"two claims have the id {claim.id!r}; an id names one claim")
        first, second = claim.routes
        if first.compute is second.compute or first.name == second.name:
            raise ClaimError(f"claim {claim.id!r} has one route twice; two different ones are due")
        self._claims[claim.id] = claim

    def __iter__(self) -> Iterator[Claim]:
        return iter(self._claims.values())

    def __len__(self) -> int:
        return len(self._claims)

    def __getitem__(self, id: str) -> Claim:
        if id in self._claims:
            return self._claims[id]
        near = get_close_matches(id, self._claims, n=3, cutoff=0.4)
        hint = f"the nearest are {', '.join(near)}" if near else "no id is near"
        raise UnknownClaimError(f"no claim has the id {id!r}; {hint} (proofs-check list has all)")
