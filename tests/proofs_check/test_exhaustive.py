"""Claims that say they cover every type do, and a type that breaks a claim is found."""

from dataclasses import replace
from random import Random

import pytest
from hypothesis import given, strategies as st

import arrangement.library.census
from arrangement import Arrangement
from arrangement.enumeration.paper_steps import published_enumeration
from arrangement.library.census import PUBLISHED, PUBLISHED_SIMPLE, census
from proofs_check import ClaimVerdict, Kind, evaluate, registry
from proofs_check.claims import counting as steps, others as types
from proofs_check.instances.arrangements import census_cases, simple_arrangement
from proofs_check.routes.dual_graph import from_covectors
from proofs_check.statements.statement import Source

#: Text in `over` -> the types it promises.
PROMISED = {
    "all 167 isomorphism classes of 3 to 7 distinct planes": range(3, 8),
    "all 24 isomorphism classes of 3 to 6 distinct planes": range(3, 7),
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
        sources=(Source(Kind.EXHAUSTIVE, "types", lambda rng: census_cases(range(6, 8))),),
    )
    result = evaluate(claim)
    assert result.verdict is ClaimVerdict.REFUTED
    assert [record.label for record in result.evidence.failures] == ["m = 7, type 101 of 143"]


@pytest.mark.parametrize("m", [1, 2, 3, 4])
def test_step_1_tests_the_regions_of_all_beginnings(m):
    planes = simple_arrangement(Random(m), m)
    starts = (Arrangement(planes.normals[:i]) for i in range(1, m))
    found = [1, *(len(published_enumeration(start).regions) for start in starts)]
    assert steps._tests_by_signs(planes) == sum(found)


def test_the_counts_grow_about_as_stated():
    cases = [case.subject for case in steps._counted_cases(Random(0))][-3:]
    for id, power in {"step-1-time": 3, "step-2-time": 4, "step-3-time": 6}.items():
        claim = registry()[id]
        notes = [claim.explain(planes, None) for planes in cases]
        exponents = [float(note.split("^")[1].split(" ")[0]) for note in notes]
        assert all(power - 1 < exponent < power + 1 for exponent in exponents)
        assert abs(exponents[-1] - power) < 0.6


@pytest.mark.slow
@pytest.mark.parametrize("id", ["step-1-time", "step-2-time", "step-3-time", "census-types"])
def test_each_holds(id):
    assert evaluate(registry()[id], seed=2).verdict is ClaimVerdict.HOLDS


@given(st.integers(0, 16), st.randoms(use_true_random=False))
def test_the_code_does_not_see_labels_and_sides(index, rng):
    normals = [list(map(int, n)) for n in arrangement.library.census.census(6)[index].normals]
    rng.shuffle(normals)
    turned = [rng.choice((1, -1)) for _ in normals]
    changed = Arrangement([[s * x for x in n] for s, n in zip(turned, normals, strict=True)])
    plain = Arrangement(arrangement.library.census.census(6)[index].normals)
    assert types._code(from_covectors(changed)) == types._code(from_covectors(plain))


@pytest.mark.slow
@pytest.mark.parametrize("change", [lambda found: found[1:], lambda found: (*found[1:], found[1])])
def test_a_missing_or_repeated_type_is_caught(change, monkeypatch):
    right = arrangement.library.census.census

    def wrong(planes):
        found = right(planes)
        return change(found) if planes == 6 else found

    monkeypatch.setattr(types, "census", wrong)
    assert evaluate(registry()["census-types"]).verdict is ClaimVerdict.REFUTED
