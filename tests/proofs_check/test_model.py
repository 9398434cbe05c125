"""The numbers of our own theorem, against formulas of another form and against small grasps."""

from random import Random

import pytest
from hypothesis import given, settings, strategies as st

from equilibrium.grasps.files import read_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check import Verdict, evaluate, registry
from proofs_check.claims import model
from tests.proofs_check.test_planted_bugs import dropped_region, plant

IDS = (
    "model-faces-without-preload",
    "model-faces-with-preload",
    "model-linear-by-regions",
    "model-states",
)


@pytest.mark.parametrize("id", IDS)
def test_the_theorem_holds_on_another_seed(id):
    assert evaluate(registry()[id], seed=1).verdict is Verdict.HOLDS


@given(st.integers(1, 40))
def test_without_preload_the_maximum_adds_up_to_the_closed_form(m):
    assert sum(model.most_faces(m, preload=False)) == 16 * m * m - 8 * m + 3


@given(st.integers(3, 40))
def test_with_preload_regions_are_whitney_numbers_added_up(m):
    """1 + planes + lines + points, the origin with the Moebius number of m generic planes."""
    f = model.most_faces(m, preload=True)
    origin = (m - 1) * (m - 2) // 2
    assert f[3] == 1 + 2 * m + m * (2 * m - 1) + (f[0] - 1) + origin


@given(st.integers(1, 40))
def test_with_preload_the_maximum_has_the_euler_number_of_space(m):
    f = model.most_faces(m, preload=True)
    assert f[0] - f[1] + f[2] - f[3] == -1


@pytest.mark.parametrize("m", [20, 40])
def test_growth_is_quadratic_without_preload_and_cubic_with(m):
    ratios = [
        sum(model.most_faces(2 * m, preload=preload)) / sum(model.most_faces(m, preload=preload))
        for preload in (False, True)
    ]
    assert 3.9 < ratios[0] < 4.1
    assert 7.9 < ratios[1] < 8.1


@given(st.integers(0, 10**6), st.integers(1, 2), st.booleans())
@settings(max_examples=15)
def test_states_are_counted_alike_by_faces_and_by_elimination(seed, m, preload):
    grasp = model._random_grasp(Random(seed), m, preload=preload)
    assert model._states_of_faces(grasp) == model._by_elimination(grasp)[1]


def test_one_contact_has_four_states():
    grasp = Grasp([Contact((0, 0), (0, 1), 1, 1, 1)])
    assert model._by_elimination(grasp) == (6, 4)


def test_the_grasps_of_the_paper_are_not_in_general_position():
    assert not model.in_general_position(read_grasp("paper-four-contacts-preload-1"))


def test_a_dropped_region_is_caught(monkeypatch):
    plant(dropped_region, monkeypatch)
    assert evaluate(registry()["model-faces-with-preload"]).verdict is None
