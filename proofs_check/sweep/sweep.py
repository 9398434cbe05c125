"""Sweeps: one claim on very many instances, in numbered chunks that can be done anywhere.

Instances are random, or the isomorphism classes of the census, one after another. Random instance
number k depends on the seed, the claim and k alone. So neither the number of workers, nor
the order of the chunks, nor any interruption can change what a sweep finds. Every claim with a
domain can be swept, by its name; claims on the printed tables have none, because their cases are
the rows and nothing else.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from arrangement.arrangement import Arrangement
from arrangement.console import workers
from arrangement.library.census import MOST_PLANES, PUBLISHED, census
from arrangement.library.census.catalogue import chirotopes
from arrangement.numbers.exact import shown
from proofs_check.claims import registry
from proofs_check.errors import DamagedStoreError, SweepError
from proofs_check.instances.domains import count, size
from proofs_check.own_claims.claim_file import claims_named, file_digest, file_digests, split
from proofs_check.reports.report import claim_record, environment, plain
from proofs_check.statements.evidence import OUTCOMES, check
from proofs_check.statements.statement import Case, Claim, Domain
from proofs_check.sweep import store
from proofs_check.sweep.store import CHUNK, MOST, Chunk, Plan


def target(name: str) -> Claim:
    """Return the claim that a name means: an id of the registry, FILE.py, or FILE.py:ID.

    Raises:
        SweepError: a claim that has no random instances, or an id that the file does not have.
        UnknownClaimError: no claim of the registry has this id.
        OwnClaimError: the file cannot be run.
    """
    file, id = split(name)
    if file is None:
        claim = registry()[id]
        if claim.domain is None:
            known = ", ".join(entry.id for entry in registry() if entry.domain)
            raise SweepError(
                f"{id} speaks of {claim.over}, not of random instances; these can be swept: {known}"
            )
        return claim
    claim, *others = claims_named(name)
    if others:
        known = ", ".join(one.id for one in (claim, *others))
        raise SweepError(f"{file} has the claims {known}; name one as {file}:ID")
    if claim.domain is None:
        raise SweepError(f"{claim.id} is about a list of instances; a sweep draws random ones")
    return claim


def domain_of(claim: Claim) -> Domain:
    """Return the domain of a claim that can be swept."""
    assert claim.domain is not None
    return claim.domain


def about(claim: Claim) -> dict[str, Any]:
    """Return what a report has to know of a claim, for the store of a sweep."""
    domain = domain_of(claim)
    record = {"record": claim_record(claim), "domain": domain.text, "unit": domain.unit}
    if claim.file:
        record["files"] = file_digests(claim.file)
    return record | ({"many_types": claim.many_types.name} if claim.many_types else {})


#: Of types that are decided many at once, one in this many is checked by the claim's routes too.
EACH = 10_000
#: Outcomes of which the smallest instance is kept.
_KEPT = ("fails", "excused", "broken")


def plan_sweep(
    source: str,
    planes: tuple[int, int],
    samples: int | None,
    seed: int = 0,
    chunk: int = CHUNK,
) -> Plan:
    """Return the plan for a claim.

    Args:
        source: an id of the registry, FILE.py, or FILE.py:ID.
        planes: smallest and largest number of planes or contacts; random instance k has
            ``low + k mod (high - low + 1)`` of them.
        samples: how many random instances; if None, every type of the census is one.
        seed, chunk: see `Plan`.

    Raises:
        SweepError: a number out of range, or a claim that cannot be swept.
    """
    chosen = target(source)
    domain = domain_of(chosen)
    low, high = planes
    if mistake := domain.mistake(low, high):
        raise SweepError(f"planes is {low}..{high}; {mistake}")
    if samples is None:
        if domain.unit != "planes" or low < 3 or high > MOST_PLANES:
            raise SweepError(
                f"--classes is {low}..{high} for {domain.text}; expected 3..{MOST_PLANES}, for a "
                "claim on planes through the origin of R^3. Others: run with --classes, or sweep "
                "with --elements and --samples"
            )
        samples, types = sum(PUBLISHED[m] for m in range(low, high + 1)), True
    else:
        types = False
    for name, value, most in (("samples", samples, MOST), ("chunk", chunk, samples)):
        if not 1 <= value <= max(most, CHUNK):
            raise SweepError(f"{name} is {shown(value)}; give 1 to {max(most, CHUNK)}")
    file, _ = split(source)
    digest = file_digest(file) if file else ""
    name = f"{Path(file).resolve()}:{chosen.id}" if file else chosen.id
    return Plan(chosen.id, digest, low, high, samples, seed, chunk, types, name)


def instance(plan: Plan, index: int) -> Any:
    """Return the instance with a number."""
    if not plan.types:
        return _target(plan).draw(plan.seed, index, (plan.low, plan.high))
    planes = plan.low
    while index >= PUBLISHED[planes]:
        index, planes = index - PUBLISHED[planes], planes + 1
    return Arrangement(census(planes)[index].normals)


def _at_once(plan: Plan, claim: Claim, indices: range) -> dict[int, bool]:
    """Return on which of these classes of nine planes the claim holds, if decided at once."""
    if not plan.types or claim.many_types is None or plan.high < MOST_PLANES:
        return {}
    first = plan.samples - PUBLISHED[MOST_PLANES]
    nine = range(max(indices.start, first), indices.stop)
    if not nine:
        return {}
    signs = chirotopes(MOST_PLANES, slice(nine.start - first, nine.stop - first))
    return dict(zip(nine, claim.many_types.holds(signs, MOST_PLANES).tolist(), strict=True))


@lru_cache(maxsize=4)
def _claim_of(source: str, digest: str) -> Claim:
    """Return the claim of a source; one with another digest is another claim."""
    return target(source)


def _target(plan: Plan) -> Claim:
    file, _ = split(plan.source)
    if file is not None and file_digest(file) != plan.digest:
        raise SweepError(
            f"{file}, or a file that it imports from its folder, has changed since the sweep "
            "began; begin a new store"
        )
    return _claim_of(plan.source, plan.digest)


def run_chunk(plan: Plan, number: int) -> Chunk:
    """Check the instances of one chunk: counts for each number of planes, smallest failures."""
    started = time.perf_counter()
    claim = _target(plan)
    counts: dict[str, list[int]] = {}
    smallest: dict[str, dict[str, Any]] = {}
    at_once = _at_once(plan, claim, plan.indices(number))
    for index in plan.indices(number):
        held = at_once.get(index)
        if held is not None and index % EACH and (held or "fails" in smallest):
            row = counts.setdefault(str(MOST_PLANES), [0] * len(OUTCOMES))
            row[OUTCOMES.index("holds" if held else "fails")] += 1
            continue
        subject = instance(plan, index)
        row = counts.setdefault(str(count(subject)), [0] * len(OUTCOMES))
        if (plan.types and not domain_of(claim).contains(subject)) or not claim.includes(subject):
            row[OUTCOMES.index("outside")] += 1
            continue
        record = check(claim, Case(f"sample {index}", subject, subject.to_dict()))
        outcome = record.outcome if held in (None, record.holds) else "broken"
        row[OUTCOMES.index(outcome)] += 1
        if outcome in _KEPT:
            entry = {
                "key": [*size(subject)[:-1], index],
                "index": index,
                "values": [plain(value) for value in record.values],
                "note": record.note,
                "instance": record.document,
            }
            _keep(smallest, outcome, entry)
    took = round(1000 * (time.perf_counter() - started))
    return Chunk(number, {"counts": counts, "smallest": smallest}, environment(), took)


def _keep(smallest: dict[str, dict[str, Any]], kind: str, entry: dict[str, Any]) -> None:
    if kind not in smallest or entry["key"] < smallest[kind]["key"]:
        smallest[kind] = entry


@dataclass
class Total:
    """What the chunks of a store say together.

    Attributes:
        counts: for each number of planes, how often each of `OUTCOMES` came out.
        smallest: for "fails", "excused" and "broken", the smallest instance.
        environments: every one that took part, each once.
    """

    chunks: int = 0
    milliseconds: int = 0
    counts: dict[int, list[int]] = field(default_factory=dict)
    smallest: dict[str, dict[str, Any]] = field(default_factory=dict)
    environments: list[dict[str, Any]] = field(default_factory=list)

    @property
    def outcomes(self) -> dict[str, int]:
        """How often each of `OUTCOMES` came out."""
        return {
            kind: sum(row[k] for row in self.counts.values()) for k, kind in enumerate(OUTCOMES)
        }

    @property
    def samples(self) -> int:
        """The number of instances that were drawn."""
        return sum(map(sum, self.counts.values()))


def total(chunks: Iterable[Chunk]) -> Total:
    """Add chunks up; their order does not matter."""
    sums = Total()
    for chunk in chunks:
        sums.chunks += 1
        sums.milliseconds += chunk.milliseconds
        for planes, row in chunk.result["counts"].items():
            old = sums.counts.get(int(planes), [0] * len(OUTCOMES))
            sums.counts[int(planes)] = [a + b for a, b in zip(old, row, strict=True)]
        for kind, entry in chunk.result["smallest"].items():
            _keep(sums.smallest, kind, entry)
        if chunk.environment not in sums.environments:
            sums.environments.append(dict(chunk.environment))
    sums.counts = dict(sorted(sums.counts.items()))
    sums.environments.sort(key=repr)
    return sums


class ShardWork(NamedTuple):
    """How many chunks a shard has, and how many of them were not there before."""

    due: int
    new: int


def sweep(
    plan: Plan,
    path: str,
    *,
    jobs: int = 1,
    shard: tuple[int, int] = (1, 1),
    dask: str | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> ShardWork:
    """Do the chunks that the store does not have yet; each is kept as soon as it is done.

    Args:
        path: of the store; made when there is none.
        jobs: processes on this machine.
        shard: (i, n): only every n-th chunk, beginning with the i-th.
        dask: address of a scheduler, instead of processes on this machine.
        progress: called with the numbers of instances done and due.

    Raises:
        SweepError: a store of another plan, or a damaged one.
        InputError: a bad argument, workers that keep dying.
        MissingExtraError: `dask` is given and not installed.
    """
    due = workers.part_numbers(plan.chunks, shard, jobs)
    claim = about(_target(plan))
    if _has(path, plan, due):  # it may be on read-only media
        return ShardWork(len(due), 0)
    with store.create(path, plan, claim) as opened:
        there = {chunk.number for chunk in opened.chunks()}
        pending = [number for number in due if number not in there]
        samples = sum(len(plan.indices(number)) for number in due)
        done = samples - sum(len(plan.indices(number)) for number in pending)
        if progress:
            progress(done, samples)
        for chunk in workers.run_parts(run_chunk, plan, pending, jobs, dask):
            opened.add(chunk)
            done += len(plan.indices(chunk.number))
            if progress:
                progress(done, samples)
    return ShardWork(len(due), len(pending))


def _has(path: str, plan: Plan, due: Iterable[int]) -> bool:
    """Return whether a store of the plan has all chunks of a shard."""
    if not Path(path).is_file() or not Path(path).stat().st_size:
        return False
    with store.read(path) as opened:
        return opened.plan == plan and {*due} <= {chunk.number for chunk in opened.chunks()}


def merge(path: str, parts: Iterable[str]) -> int:
    """Put the chunks of stores of one plan into one store; return how many were new.

    Of a damaged store, the chunks that are intact are taken before it is refused.

    Raises:
        SweepError: the stores belong to different plans, or disagree on a chunk.
        DamagedStoreError: some store is damaged.
    """
    new, damage = 0, list[str]()
    for place, part in enumerate(parts):
        with (
            store.read(part) as source,
            store.create(path, source.plan, source.claim, part) as opened,
        ):
            if not place:
                total(opened.chunks())
            try:
                for chunk in source.chunks():
                    new += opened.add(chunk, part)
            except DamagedStoreError as error:
                damage.append(error.damage)
    if damage:
        raise DamagedStoreError(
            "; ".join(damage),
            f"The others are in {path}; a sweep with --store {path} computes the rest",
        )
    return new
