"""A wrong enumerator or solver is caught: some claim loses its verdict."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from random import Random
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

from arrangement.enumeration import choose
from arrangement.enumeration.sequence import Level
from arrangement.planes.planes import Planes
from equilibrium import Contact, Grasp, read_grasp
from equilibrium.methods.compare import predict as right
from proofs_check import ClaimVerdict, evaluate, registry
from proofs_check.claims import dual, methods, model, others, space, tables
from proofs_check.routes import oracle
from proofs_check.statements.statement import Route

#: The signs of the faces of dimension 0, 1, ..., d, and points of them.
Levels = list[tuple[NDArray[np.int8], NDArray[Any]]]

#: Quick claims on arrangements; each was as expected before the bug.
QUICK = ("great-circle-regions", "state-formula", "fukuda-bound", "euler", "hamming-edges")


def dropped_region(levels: Levels) -> None:
    signs, points = levels[-1]
    levels[-1] = signs[1:], points[1:]


def flipped_sign(levels: Levels) -> None:
    levels[-1][0][0, 0] *= -1


def merged_ray(levels: Levels) -> None:
    signs, points = levels[1]
    if len(signs) >= 2:
        signs[1][signs[1] != signs[0]] = 0
        levels[1] = signs[1:], points[1:]


def plant(bug: Callable[[Levels], None], monkeypatch: pytest.MonkeyPatch) -> None:
    """Change what every engine lists."""

    def wrong(right: Callable[[Planes], tuple[Level, ...]], planes: Planes) -> tuple[Level, ...]:
        whole = slice(None)
        levels = [(level.signs(whole).copy(), level.points(whole)) for level in right(planes)]
        bug(levels)
        return tuple(
            Level(len(signs), signs.__getitem__, points.__getitem__) for signs, points in levels
        )

    for name, engine in choose.ENGINES.items():
        planted = replace(engine, list_faces=partial(wrong, engine.list_faces))
        monkeypatch.setitem(choose.ENGINES, name, planted)


def unexpected(*ids: str) -> Iterator[str]:
    known = registry()
    return (id for id in ids if not evaluate(known[id]).as_expected)


@pytest.mark.slow
def test_without_a_bug_all_are_as_expected():
    assert list(unexpected(*QUICK)) == []


@pytest.mark.slow
@pytest.mark.parametrize("bug", [dropped_region, flipped_sign, merged_ray])
def test_a_wrong_enumerator_is_caught(bug, monkeypatch):
    plant(bug, monkeypatch)
    dual._faces_graph.cache_clear()
    try:
        caught = any(unexpected(*QUICK))
    finally:
        dual._faces_graph.cache_clear()
    assert caught


def test_a_solver_that_always_says_no_is_caught(monkeypatch):
    class Never:
        stable = False
        equilibria = ()

        def verify(self):
            return True

    monkeypatch.setattr(tables.Solver, "solve", lambda *_: Never())
    assert list(unexpected("table-three-contacts", "vertical-limits")) == [
        "table-three-contacts",
        "vertical-limits",
    ]


def test_a_substitution_that_ignores_the_cone_is_not_enough(monkeypatch):
    monkeypatch.setattr(oracle, "violations", lambda question, motion, forces: ("balance",))
    assert list(unexpected("table-three-contacts")) == ["table-three-contacts"]


def test_a_changed_printed_number_is_caught():
    cases = registry()["table-three-contacts"].cases(Random(0))
    row = next(case.subject for case in cases if case.label.startswith("w=(0,1,0) P=1"))
    assert tables._by_substitution(row) == tables._solved(row) == "Yes, numbers fit"
    for i in range(3):
        for j in range(2):
            forces = [list(force) for force in row.forces]
            forces[i][j] += Fraction(1, 10**30)
            wrong = replace(row, forces=tuple(map(tuple, forces)))
            assert tables._by_substitution(wrong) == "Yes, numbers do not fit"
            assert tables._solved(wrong) == "Yes, numbers do not fit"


@pytest.mark.parametrize("id", ["regions-in-print", "small-regions-in-print"])
def test_wrong_number_in_print_refutes(id, monkeypatch):
    known = registry()[id]
    (source,) = known.sources
    few = replace(known, sources=(replace(source, cases=lambda _: list(source.cases(_))[:20]),))
    assert evaluate(few).verdict is ClaimVerdict.HOLDS
    monkeypatch.setattr(others, "_in_print", lambda planes: 7)
    assert evaluate(few).verdict is ClaimVerdict.REFUTED
    wrong = Route("wrong", lambda planes: len(planes.regions()) + 1)
    assert evaluate(replace(few, routes=(wrong, few.routes[1]))).verdict is None


def test_wrong_verdict_in_space_has_no_certificate(monkeypatch):
    known = registry()["planar-verdicts-embed"]
    right = space.solve

    def wrong(grasp, wrench, **options):
        verdict = right(grasp, wrench, **options)
        answer = not verdict.stable
        return SimpleNamespace(stable=answer, verify=verdict.verify, proof=verdict.proof)

    monkeypatch.setattr(space, "solve", wrong)
    assert evaluate(known).verdict is None


def test_planar_verdict_that_does_not_embed_refutes(monkeypatch):
    right = space._in_space
    monkeypatch.setattr(space, "_in_space", lambda q: (right(q)[0], (0, 1, 0, 0, 0, 9)))
    assert evaluate(registry()["planar-verdicts-embed"]).verdict is ClaimVerdict.REFUTED


IDS = (
    "model-faces-without-preload",
    "model-faces-with-preload",
    "model-linear-by-regions",
    "model-states",
)


@pytest.mark.parametrize("id", IDS)
def test_the_theorem_holds_on_another_seed(id):
    assert evaluate(registry()[id], seed=1).verdict is ClaimVerdict.HOLDS


@given(st.integers(1, 40))
def test_without_preload_the_maximum_adds_up_to_the_closed_form(m):
    assert sum(model.most_faces(m, preload=False)) == 16 * m * m - 8 * m + 3


@given(st.integers(3, 40))
def test_with_preload_regions_are_whitney_numbers_added_up(m):
    """1 + planes + lines + points, the origin with the Moebius number of m generic planes."""
    f = model.most_faces(m, preload=True)
    origin = (m - 1) * (m - 2) // 2
    assert f[3] == 1 + 2 * m + m * (2 * m - 1) + (f[0] - 1) + origin


@given(st.integers(0, 10**6), st.integers(1, 2), st.booleans())
def test_states_are_counted_alike_by_faces_and_by_elimination(seed, m, preload):
    grasp = model._random_grasp(Random(seed), m, preload=preload)
    by_faces, by_elimination = registry()["model-states"].routes
    assert by_faces.compute(grasp) == by_elimination.compute(grasp)


def test_one_contact_has_four_states():
    grasp = Grasp([Contact((0, 0), (0, 1), 1, 1, 1)])
    assert model._by_elimination(grasp) == (6, 4)


def test_the_grasps_of_the_paper_are_not_in_general_position():
    assert not model.in_general_position(read_grasp("paper-four-contacts-preload-1"))


def test_a_dropped_region_is_caught(monkeypatch):
    plant(dropped_region, monkeypatch)
    assert evaluate(registry()["model-faces-with-preload"]).verdict is None


#: Those on one grasp and wrench, which the paper compares methods on.
OF_METHODS = [claim.id for claim in methods.CLAIMS if claim.id.startswith("method-")]


@pytest.mark.parametrize("id", [claim.id for claim in methods.CLAIMS])
def test_each_verdict_is_the_expected_one(id):
    assert evaluate(registry()[id]).as_expected


@pytest.mark.parametrize("id", OF_METHODS)
@pytest.mark.parametrize("wrench", [(0, 0, 0), (1, 0, 0), (0, "1/3", "-1/2"), (-1, 2, 1)])
def test_both_routes_agree_on_other_wrenches(id, wrench):
    asked = next(iter(registry()[id].cases(Random(0)))).subject
    question = replace(asked.question, wrench=tuple(map(Fraction, wrench)))
    other = replace(asked, question=question)
    assert methods._by_packages(other) == methods._by_elimination(other)


@pytest.mark.parametrize("friction", ["1", "101/100"])
def test_cones_need_friction_above_one(friction):
    asked = next(iter(registry()["method-cones-only"].cases(Random(0)))).subject
    rows = tuple((*row[:4], Fraction(friction), *row[5:]) for row in asked.question.contacts)
    turned = replace(asked, question=replace(asked.question, contacts=rows))
    assert methods._by_elimination(turned)[0] is (Fraction(friction) > 1)


def test_a_method_that_says_the_opposite_is_caught(monkeypatch):
    monkeypatch.setattr(methods, "predict", lambda *question: not right(*question))
    assert all(evaluate(registry()[id]).verdict is None for id in OF_METHODS[::2])


def test_a_statement_turned_round_is_refuted():
    claim = registry()["method-frictionless-slip-up"]
    wrong = replace(claim, judge=lambda asked, found: found == (True, True))
    assert evaluate(wrong).verdict is ClaimVerdict.REFUTED
