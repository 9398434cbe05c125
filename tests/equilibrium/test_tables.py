"""Both result tables of [HaasHeger2018], typed from the paper: verdicts, forces, motions."""

from __future__ import annotations

from fractions import Fraction

import pytest

from equilibrium import read_grasp, solve

from .oracle import satisfies

THREE = "paper-three-contacts"
FOUR = "paper-four-contacts"
# The last motion of the four-contact table is printed as (0, 0.0.25, -0.25); 0.25 is meant.
ROWS = [
    (THREE, "0 0 0", 0, "0 0, 0 0, 0 0", "0 0 0"),
    (THREE, "0 0 0", 1, "1 -0.5, 1 0, 1 0.5", "0 0 0"),
    (THREE, "0 -1 0", 0, "0 0, 1 0, 0 0", "0 -1 0"),
    (THREE, "0 -2 0", 0, "0 0, 2 0, 0 0", "0 -2 0"),
    (THREE, "0 1 0", 0, None, None),
    (THREE, "0 1 0", 1, "1 -0.5, 0 0, 1 0.5", "0 1 0"),
    (THREE, "0 1.1 0", 1, None, None),
    (FOUR, "0 0 0", 0, "0 0, 0 0, 0 0, 0 0", "0 0 0"),
    (FOUR, "0 0 0", 1, "1 0, 1 0, 1 0, 1 0", "0 0 0"),
    (FOUR, "0 2 0", 0, None, None),
    (FOUR, "0 -2 0", 0, None, None),
    (FOUR, "0 2 0", 1, "1 -0.5, 1 -0.5, 1 0.5, 1 0.5", "0 0 0"),
    (FOUR, "0 -2 0", 1, "1 0.5, 1 0.5, 1 -0.5, 1 -0.5", "0 0 0"),
    (FOUR, "0 0 3", 0, "1 0.5, 0 0, 1 0.5, 0 0", "0 -1 1"),
    (FOUR, "0 0 -3", 0, "0 0, 1 -0.5, 0 0, 1 -0.5", "0 1 -1"),
    (FOUR, "0 0 3", 1, "1.25 0.625, 0.75 0.375, 1.25 0.625, 0.75 0.375", "0 -0.25 0.25"),
    (FOUR, "0 0 -3", 1, "0.75 -0.375, 1.25 -0.625, 0.75 -0.375, 1.25 -0.625", "0 0.25 -0.25"),
]


def numbers(text: str) -> tuple[Fraction, ...]:
    return tuple(Fraction(word) for word in text.split())


@pytest.mark.parametrize(("name", "wrench", "preload", "forces", "motion"), ROWS)
def test_row_reads_as_printed(name, wrench, preload, forces, motion):
    grasp = read_grasp(name).with_preload(preload)
    verdict = solve(grasp, numbers(wrench))
    assert verdict.stable == (forces is not None)
    assert verdict.verify()
    if forces is not None:
        printed = tuple(numbers(pair) for pair in forces.split(","))
        assert satisfies(grasp, numbers(wrench), numbers(motion), printed)
        assert any(piece.contains(numbers(motion), printed) for piece in verdict.equilibria)


def test_named_preload_variants_are_the_same_grasps():
    for name in (THREE, FOUR):
        assert read_grasp(f"{name}-preload-1") == read_grasp(name).with_preload(1)
