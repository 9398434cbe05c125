"""Claims: what a statement is, what it is checked on, and by which routes.

A claim is a statement about every instance of some domain. Its routes compute for one instance the
quantity that the statement is about, independently, or as a value and its certificate; a judge says
whether a value of that quantity is what the statement promises. A claim of the paper and a claim of
a user are the same thing: the first has two routes, the second may have one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from enum import StrEnum
from itertools import chain
from random import Random
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError, UnknownClaimError

if TYPE_CHECKING:
    from arrangement.library.census.chirotopes import Signs
    from arrangement.numbers.float_filter import Booleans


class ClaimVerdict(StrEnum):
    """What the evidence says about a statement."""

    HOLDS = "holds"
    HOLDS_UNDER_HYPOTHESIS = "holds under a hypothesis"
    REFUTED = "refuted"


class Kind(StrEnum):
    """How far evidence reaches.

    PROVED: a proof, each finite part of which the cases check. EXHAUSTIVE: every instance of the
    stated domain. SAMPLED: random instances.
    """

    PROVED = "proof"
    EXHAUSTIVE = "all cases"
    SAMPLED = "samples"


class Strength(StrEnum):
    """What a verdict is worth: the one word of an answer, in text, JSON, report and picture.

    PROVED: for every instance, by a proof. ALL_CASES: for every instance of a finite domain, each
    of which was checked. SAMPLED: every instance that was tried is as stated, and there are others.
    REFUTED: by a counterexample.
    """

    PROVED = "proved"
    ALL_CASES = "holds in all cases"
    SAMPLED = "no counterexample found"
    REFUTED = "refuted"


def range_text(low: int, high: int) -> str:
    """Return a range of numbers in words: "3 to 5", or "3"."""
    return f"{low} to {high}" if low < high else f"{low}"


@dataclass(frozen=True, repr=False)
class Case(ReprMixin):
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


@dataclass(frozen=True, repr=False)
class Source(ReprMixin):
    """Where cases come from: how far they reach, what they are in words, and the cases."""

    kind: Kind
    over: str
    cases: Callable[[Random], Iterable[Case]]


@dataclass(frozen=True, repr=False)
class Domain(ReprMixin):
    """A set of instances that random ones can be drawn from.

    Attributes:
        name: short, for the command line and for `@claim`.
        text: what it contains, for reports.
        unit: what its instances have a number of.
        least: the smallest number of them that is drawn.
        draw: a random instance with a given number of planes or contacts.
        contains: whether an instance belongs to it.
        most: the largest number of them that is drawn, if there is one.
    """

    name: str
    text: str
    unit: str
    least: int
    draw: Callable[[Random, int], Any]
    contains: Callable[[Any], bool]
    most: int | None = None

    @property
    def has_named_instances(self) -> bool:
        """Whether arrangements of named families may belong to it."""
        return self.unit in ("planes", "lines")

    def mistake(self, low: int, high: int) -> str:
        """Return why there are no instances of this size; "" if there are."""
        if self.least <= low <= high <= (self.most or high):
            return ""
        upto = f" and at most {self.most}" if self.most else ""
        return f"{self.text} need at least {self.least}{upto}, smaller number first"


@dataclass(frozen=True, repr=False)
class Route(ReprMixin):
    """A way to compute the quantity of a claim; the name says how.

    A route beside the first may return NotImplemented: the case is beyond it.
    """

    name: str
    compute: Callable[[Any], Any]


@dataclass(frozen=True, repr=False)
class Hypothesis(ReprMixin):
    """A condition on instances under which a statement is true although it fails without."""

    text: str
    covers: Callable[[Any], bool]


@dataclass(frozen=True, repr=False)
class View(ReprMixin):
    """A picture for the report of a claim, by one of the registered drawings.

    Attributes:
        name: a view of `arrangement.pictures`, or of `equilibrium.pictures` for grasps.
        caption: what it shows.
        options: of the view.
        instance: what is drawn, in file form; if None, the counterexample.
    """

    name: str
    caption: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)
    instance: Mapping[str, Any] | None = None


Smaller = Callable[[list[Case], Callable[[Any], bool]], tuple[Case, int]]


@dataclass(frozen=True)
class ManyTypes:
    """A way to decide a statement on many isomorphism classes at once, from their chirotopes.

    Attributes:
        name: what is done, in words.
        holds: whether the statement is true of each of N classes of n distinct planes of rank 3,
            given the signs (N, C(n, 3)) of their triples, and n.
    """

    name: str
    holds: Callable[[Signs, int], Booleans]


@dataclass(frozen=True, repr=False)
class Claim(ReprMixin):
    """A statement, what it is about, and the routes by which it is checked.

    Attributes:
        id: unique, lower case words with hyphens.
        locator: section, equation, algorithm or table of the paper.
        statement: in own words, never softened.
        hypotheses: under which the statement is made.
        quantity: what all routes compute.
        routes: they must give equal values, and share numbers, model and instances alone; or one
            gives the value, another one reads its certificate.
        sources: of the cases, from a random generator that is seeded for this claim.
        judge: whether a value on a subject is what the statement promises.
        expected: the verdict of the registry; it decides the exit code and nothing else.
        expectation_stated: whether somebody wrote it; else it is "holds" for want of another.
        hypothesis: the condition that saves the statement, if there is one.
        applies: whether the statement speaks of a subject; where it is false, nothing is checked.
        within: whether a subject belongs to the domain; likewise, and it is counted apart.
        domain: of random instances, for sweeps and for samples; None if there are none.
        sizes: smallest and largest number of planes or contacts of the samples.
        samples: the number of random instances that are checked beside the sources.
        search: instances from the smallest upwards, for the smallest counterexample.
        smaller: makes a case on which the claim fails, out of many, as small as possible; gets the
            cases and a test, and returns one case and how many it tried.
        explain: a remark on one checked subject and its value.
        meaning: what the verdict means for the conclusions of the paper.
        rows: whether a report shows every case.
        large: whether it takes so long that it is checked only when it is named or asked for.
        formula: the statement in mathematics, in the part of TeX that `reports.formula` reads.
        section: heading of the paper under which a report lists the claim.
        file: of a user, from which the claim was loaded.
        proof: where its proof is: a section of the page on proofs and the words it begins with.
        theorems: their names, where the proof is one that Coq checked (`formal.theorem`).
        prose: what the theorems leave to the page on proofs.
        views: pictures that show why; if none, a report draws the counterexample.
        many_types: a way to decide it on all isomorphism classes of nine planes, for sweeps.
    """

    id: str
    locator: str
    statement: str
    quantity: str
    routes: tuple[Route, ...]
    judge: Callable[[Any, Any], bool]
    sources: tuple[Source, ...] = ()
    expected: ClaimVerdict = ClaimVerdict.HOLDS
    expectation_stated: bool = True
    hypotheses: tuple[str, ...] = ()
    hypothesis: Hypothesis | None = None
    applies: Callable[[Any], bool] | None = None
    within: Callable[[Any], bool] | None = None
    domain: Domain | None = None
    sizes: tuple[int, int] = (0, 0)
    samples: int = 0
    search: Callable[[], Iterable[Case]] | None = None
    smaller: Smaller | None = None
    explain: Callable[[Any, Any], str] | None = None
    meaning: str = ""
    rows: bool = False
    large: bool = False
    formula: str = ""
    section: str = ""
    file: str = ""
    proof: tuple[str, str] | None = None
    theorems: tuple[str, ...] = ()
    prose: str = ""
    views: tuple[View, ...] = ()
    many_types: ManyTypes | None = None

    def __call__(self, subject: Any) -> Any:
        """Return the value of the first route on an instance."""
        return self.routes[0].compute(subject)

    def includes(self, subject: Any) -> bool:
        """Return whether the statement speaks of a subject."""
        return self.has_within(subject) and (self.applies is None or self.applies(subject))

    def has_within(self, subject: Any) -> bool:
        """Return whether a subject belongs to the domain."""
        return self.within is None or self.within(subject)

    def cases(self, generator: Random) -> Iterator[Case]:
        """Yield the cases of all sources."""
        return chain.from_iterable(source.cases(generator) for source in self.sources)

    def draw(self, seed: int, index: int, sizes: tuple[int, int]) -> Any:
        """Return the random instance with a number: it depends on seed, id and number alone."""
        if self.domain is None:
            raise OwnClaimError(f"{self.id} is not about random instances")
        low, high = sizes
        generator = Random(f"{seed}/{self.id}/{index}")
        return self.domain.draw(generator, low + index % (high - low + 1))

    def all_sources(self, seed: int) -> Iterator[Source]:
        """Yield the sources, and the random instances as one more."""
        yield from self.sources
        if self.domain is not None and self.samples:
            low, high = self.sizes
            over = f"{self.samples} random {self.domain.text} with {range_text(low, high)}"
            drawn = (
                Case(f"sample {k}", subject, subject.to_dict())
                for k in range(self.samples)
                for subject in [self.draw(seed, k, self.sizes)]
            )
            yield Source(Kind.SAMPLED, f"{over} {self.domain.unit}", lambda _: drawn)

    @property
    def kind(self) -> Kind:
        """How far the evidence reaches as a whole: as far as that of the weakest source.

        A domain with random instances has no last size, so isomorphism classes up to a size are
        never all of it; and proofs are of claims of the package alone.
        """
        kinds = [source.kind for source in self.sources]
        if self.samples or any(self.sizes) or (self.file and Kind.PROVED in kinds):
            return Kind.SAMPLED
        return max(kinds, key=list(Kind).index, default=Kind.SAMPLED)

    @property
    def over(self) -> str:
        """What the claim is checked on, in words."""
        texts = [source.over for source in self.sources]
        if self.domain is not None and self.samples:
            texts.append(f"random {self.domain.text}")
        return "; ".join(texts)

    @property
    def domain_text(self) -> str:
        """What the statement is about, in words: its domain, or all that it is checked on."""
        if self.domain is not None and any(self.sizes):
            return f"{self.domain.name}: {self.domain.text}"
        return self.over


class Registry(ReprMixin):
    """Claims by id, in order of entry, in which it is iterated; ids are unique.

    Args:
        claims: to enter first.
        later: what makes the claim of an id when it is asked for, so that a topic loads alone.
    """

    repr_fields = ("ids",)

    def __init__(
        self, claims: Iterable[Claim] = (), later: Mapping[str, Callable[[], Claim]] | None = None
    ) -> None:
        self._claims: dict[str, Callable[[], Claim]] = dict(later or {})
        for claim in claims:
            self.add(claim)

    def add(self, claim: Claim) -> None:
        """Enter a claim.

        Raises:
            OwnClaimError: another claim has the same id, or two routes are one.
        """
        if claim.id in self._claims:
            raise OwnClaimError(f"two claims have the id {shown(claim.id)}; an id names one claim")
        names, ways = ({getattr(r, k) for r in claim.routes} for k in ("name", "compute"))
        if not len(names) == len(ways) == len(claim.routes):
            raise OwnClaimError(
                f"claim {shown(claim.id)} has one route twice; expected different ones"
            )
        self._claims[claim.id] = lambda: claim

    @property
    def ids(self) -> tuple[str, ...]:
        """The ids, in order."""
        return tuple(self._claims)

    def __iter__(self) -> Iterator[Claim]:
        return (make() for make in self._claims.values())

    def __len__(self) -> int:
        return len(self._claims)

    def __getitem__(self, id: str) -> Claim:
        if id in self._claims:
            return self._claims[id]()
        id = str(id)
        place = id.replace(" ", "").lower()
        near = [claim.id for claim in self if claim.locator.replace(" ", "").lower() == place]
        near = near or get_close_matches(id, self._claims, n=3, cutoff=0.4)
        words = {*re.findall(r"[0-9]+|[a-z]{2,}", id.lower())}
        near = near or [
            claim.id for claim in self if words & {*re.findall(r"\w+", claim.locator.lower())}
        ]
        ids = "".join(f", ids are words such as {x}" for x in [*self._claims][:1])
        hint = f"the nearest are {', '.join(near[:4])}" if near else f"no id is near{ids}"
        raise UnknownClaimError(
            f"no claim has the id {shown(id)}; {hint} (proofs-check list has all, and run without "
            "an id checks all; files of claims end in .py, tables of printed numbers in .csv)"
        )


def check_claim(claim: object) -> None:
    """Refuse what is not a claim."""
    if not isinstance(claim, Claim):
        raise OwnClaimError(
            f"the claim is {shown(claim)}; expected a Claim, such as registry()[ID] or a function "
            "under @claim(TEXT). For a text write evaluate(one_line_claim(TEXT)), from "
            "proofs_check.own_claims.one_line, or in a shell: proofs-check try TEXT"
        )
