"""Running a claim of a user's file: over the census, families and samples, then shrinking."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from arrangement.io.writing import write_text_atomically
from arrangement.library.census import census
from arrangement.planes import Arrangement

from .claim import Verdict
from .errors import OwnClaimError
from .instances.domains import count, document, known_families, size
from .shrink import shrink, smaller_instances
from .user_claim import OwnClaim


@dataclass(frozen=True)
class Part:
    """What was checked from one source.

    Attributes:
        kind: "exhaustive" (the census) or "sampled".
        over: in words.
        checked, passed_over, failures: numbers of instances; those passed over lie outside the
            domain or the hypothesis.
    """

    kind: str
    over: str
    checked: int
    passed_over: int
    failures: int


@dataclass(frozen=True)
class Failure:
    """An instance on which the function did not return True.

    Attributes:
        broken: the function raised an error, so that nothing follows about the statement.
    """

    label: str
    subject: Any
    reason: str
    broken: bool = False

    @property
    def document(self) -> dict[str, Any]:
        """The instance in file form."""
        return document(self.subject)


@dataclass(frozen=True)
class OwnResult:
    """A claim with what was checked.

    Attributes:
        smallest: the smallest failure, after shrinking; None if there was none.
        searched: how many instances the search for it tried.
        milliseconds: that the whole check took.
    """

    claim: OwnClaim
    seed: int
    parts: tuple[Part, ...]
    smallest: Failure | None
    searched: int
    milliseconds: int

    @property
    def checked(self) -> int:
        """The number of instances that were checked."""
        return sum(part.checked for part in self.parts)

    @property
    def verdict(self) -> Verdict | None:
        """The verdict; None when no instance was checked or the function is broken."""
        if self.smallest is not None:
            return None if self.smallest.broken else Verdict.REFUTED
        return Verdict.HOLDS if self.checked else None

    @property
    def as_expected(self) -> bool:
        """Whether the verdict is the one that the file expects."""
        return self.verdict is self.claim.expected


Instances = Iterator[tuple[str, Any]]


def attempt(own: OwnClaim, subject: Any, label: str = "") -> Failure | None:
    """Check one instance; an error in the function is a failure that is marked as broken.

    Raises:
        OwnClaimError: the function returned neither True nor a text.
    """
    try:
        reason = own.reason(subject)
    except OwnClaimError:
        raise
    except Exception as error:
        return Failure(label, subject, f"raised {type(error).__name__}: {error}", True)
    return Failure(label, subject, reason) if reason else None


def sample(own: OwnClaim, seed: int, index: int, low: int, high: int) -> Any:
    """Return the random instance with a number; it depends on seed, id and number alone."""
    rng = Random(f"{seed}/{own.id}/{index}")
    return own.domain.draw(rng, low + index % (high - low + 1))


def run(own: OwnClaim, seed: int = 0, progress: Callable[[int], None] | None = None) -> OwnResult:
    """Check a claim on all its instances and make the smallest failure as small as possible."""
    started = time.perf_counter()
    parts, failures = [], []
    done = 0
    for kind, over, instances in _sources(own, seed):
        numbers = [0, 0, 0]
        for label, subject in instances:
            done += 1
            if progress:
                progress(done)
            if not own.covers(subject):
                numbers[1] += 1
                continue
            numbers[0] += 1
            failure = attempt(own, subject, label)
            if failure is not None:
                numbers[2] += 1
                failures.append(failure)
        parts.append(Part(kind, over, *numbers))
    smallest, searched = _smallest(own, failures)
    took = round(1000 * (time.perf_counter() - started))
    return OwnResult(own, seed, tuple(parts), smallest, searched, took)


def _sources(own: OwnClaim, seed: int) -> Iterator[tuple[str, str, Instances]]:
    if own.census:
        over = f"one arrangement of every combinatorial type of 3 to {own.census} planes"
        yield "exhaustive", over, _types(own.census)
    if own.use_families:
        yield "sampled", "named families", known_families(own.domain)
    if own.samples:
        low, high = own.planes
        over = f"{own.samples} random {own.domain.text} with {low} to {high} {own.domain.unit}"
        yield "sampled", f"{over}, seed {seed}", _samples(own, seed)


def _types(most: int) -> Instances:
    """Yield new arrangements, so that what a claim computes on them is not kept in memory."""
    for m in range(3, most + 1):
        for k, planes in enumerate(census(m)):
            yield f"type {k} of {m} planes", Arrangement(planes.normals)


def _samples(own: OwnClaim, seed: int) -> Instances:
    for index in range(own.samples):
        yield f"sample {index}", sample(own, seed, index, *own.planes)


def _smallest(own: OwnClaim, failures: list[Failure]) -> tuple[Failure | None, int]:
    """Shrink the smallest failure; then look among all smaller instances for one that fails.

    Reasons are preferred to errors: an instance on which the function answers says more.
    """
    if not failures:
        return None, 0
    start = min(failures, key=lambda f: (f.broken, size(f.subject)))

    def fails(subject: Any) -> bool:
        found = attempt(own, subject) if own.covers(subject) else None
        return found is not None and found.broken == start.broken

    subject, searched = shrink(start.subject, fails)
    if own.domain.unit == "planes":
        for candidate in smaller_instances(count(subject)):
            searched += 1
            if fails(candidate):
                subject, more = shrink(candidate, fails)
                searched += more
                break
    label = f"m = {count(subject)}, from {start.label}"
    return attempt(own, subject, label), searched


def save(result: OwnResult, folder: str) -> Path | None:
    """Write the smallest failure as an instance file; return its path, or None without one.

    Commands that read arrangements or grasps read the file. An older one of that name is replaced.
    """
    failure = result.smallest
    if failure is None:
        return None
    text = f"smallest instance found on which {result.claim.id} fails: {failure.reason}"
    content = {**failure.document, "description": text}
    target = Path(folder) / f"{result.claim.id}.json"
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OwnClaimError(f"cannot make the folder {folder}: {error.strerror}") from None
    write_text_atomically(target, json.dumps(content, indent=1) + "\n")
    return target
