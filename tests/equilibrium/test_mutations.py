"""A thousand changed certificates: refused, unless they are still true proofs of the same thing.

With the digest kept, every change is refused. With the digest computed anew, what is accepted has
to be true, as decided without the checker.
"""

from __future__ import annotations

from typing import Any

import pytest

from arrangement.errors import InputError
from equilibrium import check, solve
from equilibrium.certificate.regions_checker import digest

from .awkward import question
from .mutations import mutants
from .proofs import is_true_proof, statement

#: Seeds of `awkward.question`, by verdict, of two, three and four contacts.
SEEDS = {"stable": (8, 20, 17, 21, 2, 34), "unstable": (40, 41, 1, 45, 6, 26)}
KEPT, ANEW = 42, 42


def accepted(document: Any, asked: Any = None, rationals_only: bool = False) -> bool:
    try:
        return bool(check(document, question=asked, rationals_only=rationals_only))
    except InputError:
        return False


def certificate(seed: int) -> dict[str, Any]:
    asked = question(seed)
    return solve(asked.grasp, asked.wrench).certificate.to_dict()


DOCUMENTS = [
    pytest.param(certificate(seed), seed, id=f"{kind}-{seed}")
    for kind, seeds in SEEDS.items()
    for seed in seeds
]


@pytest.mark.parametrize(("document", "seed"), DOCUMENTS)
def test_every_change_is_refused_by_the_digest(document, seed):
    assert accepted(document)
    for path, change, changed in mutants(document, KEPT, seed):
        assert not accepted(changed), (path, change)


@pytest.mark.parametrize(("document", "seed"), DOCUMENTS)
def test_what_is_accepted_with_a_new_digest_is_a_true_proof(document, seed):
    content = {key: value for key, value in document.items() if key != "digest"}
    asked = statement(document)
    assert is_true_proof(document)
    for path, change, changed in mutants(content, ANEW, seed):
        changed["digest"] = digest(changed)
        valid = accepted(changed)
        assert accepted(changed, rationals_only=True) == valid, (path, change)
        if valid:
            assert is_true_proof(changed), (path, change)
            assert accepted(changed, asked) == (statement(changed) == asked), (path, change)


def test_documents_are_of_both_verdicts_and_all_sizes():
    found = {(d["certificate"], len(d["grasp"]["contacts"])) for d, _ in map(_values, DOCUMENTS)}
    assert found == {(kind, m) for kind in SEEDS for m in (2, 3, 4)}
    assert len(DOCUMENTS) * (KEPT + ANEW) >= 1000


def _values(parameter: Any) -> Any:
    return parameter.values
