"""All classes of nine planes at once: dual graphs from chirotopes, against single ones."""

import numpy as np
import pytest

from arrangement.duals.inscribed.report import inscribability
from arrangement.library.census import PUBLISHED, catalogue, census
from proofs_check.routes import many_types
from proofs_check.routes.dual_graph import from_covectors, minimum_cycle_lengths
from proofs_check.sweep.sweep import EACH, _at_once, plan_sweep, run_chunk, target


@pytest.mark.parametrize("planes", [3, 4, 5, 6])
def test_faces_composed_from_cocircuits_are_those_enumerated(planes):
    found = many_types.f_vectors(catalogue.chirotopes(planes), planes)
    listed = [a.faces().f_vector[1:] for a in census(planes)]
    assert [tuple(row) for row in found.tolist()] == listed


def test_euler_holds_for_a_sample_of_nine():
    places = np.linspace(0, PUBLISHED[9] - 1, 200).astype(int)
    rays, facets, regions = many_types.f_vectors(catalogue.chirotopes(9, places), 9).T
    assert (rays - facets + regions == 2).all()


def test_faces_are_a_minimum_cycle_basis_as_by_horton():
    held = many_types.cycle_bases_are_faces(catalogue.chirotopes(5), 5)
    for planes, minimum in zip(census(5), held.tolist(), strict=True):
        graph = from_covectors(planes)
        lengths = sorted(map(len, graph.faces))[:-1]
        assert minimum == (list(minimum_cycle_lengths(graph)) == lengths)


def test_a_face_that_is_longer_than_the_cycles_around_it_is_seen(monkeypatch):
    enclosed = many_types._ways

    def longer(*arguments):
        lengths, crossed = enclosed(*arguments)
        return np.where(lengths > 0, lengths + 2, 0), crossed

    signs = catalogue.chirotopes(7)
    monkeypatch.setattr(many_types, "_ways", longer)
    assert (many_types.cycle_bases_are_faces(signs, 7) == signs.all(1)).all()


@pytest.mark.parametrize(
    ("edges", "exist"),
    [
        ([(0, 1), (0, 2), (3, 1), (3, 2)], False),  # a square: 1/2 on every edge, and no less
        ([(a, b) for a in (0, 3, 5) for b in (1, 2, 4)], True),
        ([(a, b) for a in (0, 3, 5, 6) for b in (1, 2, 4)], False),
    ],
)
def test_weights_below_one_half_on_small_graphs(edges, exist):
    assert many_types.edges_have_weights(edges) == exist


@pytest.mark.parametrize("claim", ["cycle-basis-faces", "great-circle-regions"])
def test_a_sweep_over_nine_planes_decides_many_types_at_once(claim):
    plan = plan_sweep(claim, (8, 9), None, chunk=40)
    number = (
        PUBLISHED[8] // 40
    )  # the last isomorphism classes of eight planes are left out, for their time
    later = run_chunk(plan, number + 1).result["counts"]
    assert later == {"9": [40, 0, 0, 0, 0]}
    assert not any(index % EACH == 0 for index in plan.indices(number + 1))


def test_classes_of_nine_planes_alone_are_decided_at_once():
    claim = "great-circle-regions"
    every = plan_sweep(claim, (9, 9), None)
    assert _at_once(every, target(claim), range(2)).keys() == {0, 1}
    for name, plan in (
        (claim, plan_sweep(claim, (9, 9), 10)),
        (claim, plan_sweep(claim, (8, 8), None)),
        ("euler", plan_sweep("euler", (9, 9), None)),
    ):
        assert _at_once(plan, target(name), range(2)) == {}


def test_a_type_that_both_routes_find_otherwise_breaks_the_sweep(monkeypatch):
    from proofs_check.sweep import sweep

    monkeypatch.setattr(
        sweep, "_at_once", lambda plan, claim, indices: dict.fromkeys(indices, False)
    )
    found = run_chunk(plan_sweep("great-circle-regions", (9, 9), None, chunk=3), 1).result
    assert found["counts"] == {"9": [0, 0, 0, 3, 0]}


@pytest.mark.slow
def test_sample_of_nine_planes_with_weights_decided():
    """Of types that have weights some cutset may still be too light; each answer is verified."""
    chosen = np.random.default_rng(9).permutation(PUBLISHED[9])[:100]
    weighty = chosen[many_types.have_weights(catalogue.chirotopes(9, chosen), 9)]
    assert len(weighty) > 40
    for k in weighty[:40].tolist():
        inscribability(census(9)[k]).certificate.verify()
