"""What can be swept: every claim with a domain of random instances, by its name.

Claims on the printed tables have none, because their cases are the rows and nothing else.
"""

from __future__ import annotations

from typing import Any

from proofs_check.claims import registry
from proofs_check.errors import SweepError
from proofs_check.own_claims.claim_file import load
from proofs_check.reports.report import claim_record
from proofs_check.statements.statement import Claim, Domain


def split(name: str) -> tuple[str | None, str]:
    """Return the file (None for the registry) and the id ("" for the only claim of a file)."""
    if name.endswith(".py"):
        return name, ""
    file, found, id = name.rpartition(".py:")
    return (f"{file}.py", id) if found else (None, name)


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
    claims = {claim.id: claim for claim in load(file)}
    if not id and len(claims) == 1:
        (id,) = claims
    if id not in claims:
        raise SweepError(f"{file} has the claims {', '.join(claims)}; name one as {file}:ID")
    if claims[id].domain is None:
        raise SweepError(f"{id} is about a list of instances; a sweep draws random ones")
    return claims[id]


def domain_of(claim: Claim) -> Domain:
    """Return the domain of a claim that can be swept."""
    assert claim.domain is not None
    return claim.domain


def about(claim: Claim) -> dict[str, Any]:
    """Return what a report has to know of a claim, for the store of a sweep."""
    domain = domain_of(claim)
    found = {"record": claim_record(claim), "domain": domain.text, "unit": domain.unit}
    return found | ({"many_types": claim.many_types.name} if claim.many_types else {})
