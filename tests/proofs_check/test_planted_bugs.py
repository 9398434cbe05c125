"""A wrong enumerator or solver is caught: some claim loses its verdict."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from random import Random
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from arrangement.enumeration import choose
from arrangement.enumeration.sequence import Level
from arrangement.planes.planes import Planes
from proofs_check import evaluate, registry
from proofs_check.claims import dual, tables
from proofs_check.routes import oracle

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


def unexpected(*ids: str) -> list[str]:
    known = registry()
    return [id for id in ids if not evaluate(known[id]).as_expected]


@pytest.mark.campaign
def test_without_a_bug_all_are_as_expected():
    assert unexpected(*QUICK) == []


@pytest.mark.campaign
@pytest.mark.parametrize("bug", [dropped_region, flipped_sign, merged_ray])
def test_a_wrong_enumerator_is_caught(bug, monkeypatch):
    plant(bug, monkeypatch)
    dual._faces_graph.cache_clear()
    try:
        caught = unexpected(*QUICK)
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
    assert unexpected("table-three-contacts", "vertical-limits") == [
        "table-three-contacts",
        "vertical-limits",
    ]


def test_a_substitution_that_ignores_the_cone_is_not_enough(monkeypatch):
    monkeypatch.setattr(oracle, "violations", lambda question, motion, forces: ("balance",))
    assert unexpected("table-three-contacts") == ["table-three-contacts"]


def test_a_changed_printed_number_is_caught():
    cases = registry()["table-three-contacts"].cases(Random(0))
    row = next(case.subject for case in cases if case.label.startswith("w=(0,1,0) P=1"))
    assert tables._substituted(row) == tables._solved(row) == "Yes, numbers fit"
    for i in range(3):
        for j in range(2):
            forces = [list(force) for force in row.forces]
            forces[i][j] += Fraction(1, 10**30)
            wrong = replace(row, forces=tuple(map(tuple, forces)))
            assert tables._substituted(wrong) == "Yes, numbers do not fit"
            assert tables._solved(wrong) == "Yes, numbers do not fit"
