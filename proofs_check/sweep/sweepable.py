"""What can be swept: claims of the registry with a domain of random instances, and own claims.

A target checks one instance and says what came out; `SWEEPS` gives each claim of the registry that
speaks of arbitrary instances its domain. Claims on the printed tables are not here, because their
cases are the rows of the tables and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proofs_check import user_claim as own, user_run as ownrun
from proofs_check.claim import Case, Claim, check
from proofs_check.claims import registry
from proofs_check.errors import SweepError
from proofs_check.instances.domains import Domain, count, document, domain
from proofs_check.reports.report import claim_record, plain

#: Claim of the registry -> domain of its random instances.
SWEEPS: dict[str, str] = {
    "great-circle-regions": "central",
    "state-formula": "simple",
    "fukuda-bound": "affine",
    "fukuda-bound-attained": "simple-affine",
    "bound-not-attained": "central",
    "step-1-square-bound": "central",
    "euler": "central",
    "dual-edge-and-face-bounds": "central",
    "dual-bipartite-bounds": "rank-3",
    "dual-planar-3-connected": "central",
    "hamming-edges": "central",
    "cycle-basis-faces": "central",
    "algorithm-2-sound": "question",
    "all-stick-listed": "question",
    "single-solution": "question",
}
#: What can come out of one instance. "outside": the hypotheses of the statement exclude it;
#: "excused": it fails, and the saving hypothesis excludes it; "broken": the check itself failed.
OUTCOMES = ("holds", "fails", "excused", "broken", "outside")


@dataclass(frozen=True)
class Outcome:
    """What came out of one instance, with the values that were found."""

    kind: str
    values: tuple[Any, ...] = ()
    note: str = ""


@dataclass(frozen=True)
class Target:
    """A claim as a sweep sees it.

    Attributes:
        record: what the claim says, for reports.
        saved: whether a hypothesis saves the statement.
    """

    id: str
    record: dict[str, Any]
    domain: Domain
    saved: bool
    check: Callable[[Any], Outcome]

    def about(self) -> dict[str, Any]:
        """Return what a report has to know of the claim, for the store of a sweep."""
        return {
            "record": self.record,
            "domain": self.domain.text,
            "unit": self.domain.unit,
            "saved": self.saved,
        }


def split(name: str) -> tuple[str | None, str]:
    """Return the file (None for the registry) and the id ("" for the only claim of a file)."""
    if name.endswith(".py"):
        return name, ""
    file, found, id = name.rpartition(".py:")
    return (f"{file}.py", id) if found else (None, name)


def target(name: str) -> Target:
    """Return what a name means: an id of the registry, FILE.py, or FILE.py:ID.

    Raises:
        SweepError: a claim that has no random instances, or an id that the file does not have.
        UnknownClaimError: no claim of the registry has this id.
        OwnClaimError: the file cannot be run.
    """
    file, id = split(name)
    if file is not None:
        return _own_target(file, id)
    claim = registry()[id]
    if id not in SWEEPS:
        raise SweepError(
            f"{id} speaks of {claim.over}, not of random instances; "
            f"these can be swept: {', '.join(SWEEPS)}"
        )
    return Target(
        id,
        claim_record(claim),
        domain(SWEEPS[id]),
        claim.hypothesis is not None,
        lambda subject: _checked(claim, subject),
    )


def _checked(claim: Claim, subject: Any) -> Outcome:
    record = check(claim, Case(f"m = {count(subject)}", subject, document(subject)))
    values = tuple(plain(value) for value in record.values)
    if not record.agree:
        return Outcome("broken", values, "the routes disagree")
    if record.holds:
        return Outcome("holds" if record.covered else "outside")
    return Outcome("fails" if record.covered else "excused", values, record.note)


def _own_target(file: str, id: str) -> Target:
    claims = {claim.id: claim for claim in own.load(file)}
    if not id and len(claims) == 1:
        id = next(iter(claims))
    if id not in claims:
        raise SweepError(f"{file} has the claims {', '.join(claims)}; name one as {file}:ID")
    claim = claims[id]
    return Target(
        id,
        _own_record(file, claim),
        claim.domain,
        False,
        lambda subject: _attempted(claim, subject),
    )


def _attempted(claim: own.OwnClaim, subject: Any) -> Outcome:
    if not claim.covers(subject):
        return Outcome("outside")
    failure = ownrun.attempt(claim, subject)
    if failure is None:
        return Outcome("holds")
    return Outcome("broken" if failure.broken else "fails", (), failure.reason)


def _own_record(file: str, claim: own.OwnClaim) -> dict[str, Any]:
    return {
        "id": claim.id,
        "locator": claim.locator or Path(file).name,
        "statement": claim.statement,
        "hypotheses": list(claim.hypotheses),
        "saving_hypothesis": None,
        "quantity": "whether the function of the file returns True",
        "routes": [f"the function {claim.test.__name__}"],
        "expected": claim.expected.value,
        "meaning": "",
    }
