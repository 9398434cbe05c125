"""Claims that say they cover every type do, and a type that breaks a claim is found."""

from dataclasses import replace
from random import Random

import pytest

from arrangement.arrangement import Arrangement
from arrangement.library.census import PUBLISHED, PUBLISHED_SIMPLE, census
from proofs_check import Kind, Verdict, evaluate, registry
from proofs_check.instances.arrangements import census_cases
from proofs_check.statements.statement import exhaustive

#: Text in `over` -> the types it promises.
PROMISED = {
    "all 167 types of 3 to 7 distinct planes": range(3, 8),
    "all 24 types of 3 to 6 distinct planes": range(3, 7),
}
ON_TYPES = [
    (claim.id, counts)
    for claim in registry()
    for text, counts in PROMISED.items()
    if text in claim.over
]


def test_the_combinatorial_claims_run_over_the_types():
    assert {id for id, _ in ON_TYPES} >= {
        "great-circle-regions",
        "euler",
        "dual-edge-and-face-bounds",
        "dual-bipartite-bounds",
        "dual-planar-3-connected",
        "hamming-edges",
        "cycle-basis-faces",
    }


@pytest.mark.parametrize(("id", "counts"), ON_TYPES)
def test_a_claim_on_every_type_has_each_of_them_as_a_case(id, counts):
    claim = registry()[id]
    cases = {case.subject for case in claim.cases(Random(0))}
    for m in counts:
        types = set(census(m))
        assert len(types) == PUBLISHED[m]
        assert types <= cases
    assert claim.kind is not Kind.SAMPLED


@pytest.mark.parametrize("m", [3, 4, 5, 6])
def test_cases_name_each_type_once(m):
    labels = [case.label for case in census_cases(range(m, m + 1))]
    assert len(set(labels)) == PUBLISHED[m]
    simple = list(census_cases(range(m, m + 1), simple=True))
    assert len(simple) == PUBLISHED_SIMPLE[m]
    assert all(case.subject.is_simple for case in simple)


def test_a_claim_that_fails_on_one_type_alone_is_refuted_by_it():
    special = Arrangement(census(7)[100].normals)
    claim = replace(
        registry()["great-circle-regions"],
        judge=lambda planes, regions: planes != special,
        sources=exhaustive("types", lambda rng: census_cases(range(6, 8))),
    )
    result = evaluate(claim)
    assert result.verdict is Verdict.REFUTED
    assert [record.label for record in result.evidence.failures] == ["m = 7, type 101 of 143"]
