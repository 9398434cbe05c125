"""A wrong enumerator or solver is caught: some claim loses its verdict."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

import arrangement.enumeration.any_dimension
from arrangement.arrangement import Arrangement
from arrangement.planes import Face
from proofs_check import evaluate, registry
from proofs_check.claims import dual, tables
from proofs_check.routes import oracle

Levels = tuple[tuple[Face, ...], ...]

#: Quick claims on arrangements; each was as expected before the bug.
QUICK = ("great-circle-regions", "state-formula", "fukuda-bound", "euler", "hamming-edges")


def dropped_region(levels: Levels) -> Levels:
    return (*levels[:-1], levels[-1][1:])


def flipped_sign(levels: Levels) -> Levels:
    first = levels[-1][0]
    wrong = Face((-first.signs[0], *first.signs[1:]), first.dimension, first.witness)
    return (*levels[:-1], (wrong, *levels[-1][1:]))


def merged_ray(levels: Levels) -> Levels:
    if len(levels[1]) < 2:
        return levels
    one, other, *rest = levels[1]
    both = Face(
        tuple(a if a == b else 0 for a, b in zip(one.signs, other.signs, strict=True)),
        1,
        one.witness,
    )
    return (levels[0], (both, *rest), *levels[2:])


def unexpected(*ids: str) -> list[str]:
    known = registry()
    return [id for id in ids if not evaluate(known[id]).as_expected]


def test_without_a_bug_all_are_as_expected() -> None:
    assert unexpected(*QUICK) == []


@pytest.mark.parametrize("bug", [dropped_region, flipped_sign, merged_ray])
def test_a_wrong_enumerator_is_caught(
    bug: Callable[[Levels], Levels], monkeypatch: pytest.MonkeyPatch
) -> None:
    right = arrangement.enumeration.any_dimension.enumerate_faces

    def wrong(planes: Arrangement) -> Levels:
        return bug(right(planes))

    monkeypatch.setattr(arrangement.enumeration.any_dimension, "enumerate_faces", wrong)
    dual._faces_graph.cache_clear()
    try:
        caught = unexpected(*QUICK)
    finally:
        dual._faces_graph.cache_clear()
    assert caught


def test_a_solver_that_always_says_no_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    class Never:
        stable = False
        equilibria = ()

        def verify(self) -> bool:
            return True

    monkeypatch.setattr(tables, "solve", lambda grasp, wrench: Never())
    assert unexpected("table-three-contacts", "vertical-limits") == [
        "table-three-contacts",
        "vertical-limits",
    ]


def test_a_substitution_that_ignores_the_cone_is_not_enough(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(oracle, "violations", lambda question, motion, forces: ("balance",))
    assert unexpected("table-three-contacts") == ["table-three-contacts"]


def test_a_changed_printed_number_is_caught() -> None:
    (source,) = registry()["table-three-contacts"].sources
    cases = source.cases(Random(0))
    row = next(case.subject for case in cases if case.label.startswith("w=(0,1,0) P=1"))
    assert tables._substituted(row) == tables._solved(row) == "Yes, numbers fit"
    for i in range(3):
        for j in range(2):
            forces = [list(force) for force in row.forces]
            forces[i][j] += Fraction(1, 10**30)
            wrong = replace(row, forces=tuple(map(tuple, forces)))
            assert tables._substituted(wrong) == "Yes, numbers do not fit"
            assert tables._solved(wrong) == "Yes, numbers do not fit"
