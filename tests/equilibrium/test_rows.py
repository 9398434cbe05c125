"""Contacts as rows in R^n."""

from fractions import Fraction

import numpy as np
import pytest

from equilibrium import read_grasp
from equilibrium.core.contacts import FloatContacts
from equilibrium.model.rows import ContactRows


@pytest.mark.parametrize(
    ("name", "n", "tangents"),
    [("paper-three-contacts", 3, 1), ("two-opposed-fingers", 6, 2)],
)
def test_rows_of_a_grasp_are_its_wrenches(name, n, tangents):
    grasp = read_grasp(name)
    rows = ContactRows.of_grasp(grasp)
    assert (rows.n, rows.tangents, len(rows)) == (n, tangents, len(grasp))
    for row, contact in zip(rows, grasp, strict=True):
        assert row.normal_wrench == contact.normal_wrench
        assert row.tangential_wrenches == contact.tangential_wrenches
        assert len(row.tangential_wrenches) == tangents


def test_floats_of_rows_have_their_shapes():
    floats = FloatContacts(ContactRows.of_grasp(read_grasp("two-opposed-fingers")))
    m = len(floats.rows)
    assert floats.normal.shape == (m, 6)
    assert floats.tangents.shape == (m, 2, 6)
    assert floats.arms(2.0).tolist() == [1, 1, 1, 2, 2, 2]
    assert np.array_equal(floats.spring[:, 0], floats.preload)


def test_no_rows_have_no_numbers():
    floats = FloatContacts(ContactRows((), (), (False, False, True) * 2, 1))
    assert floats.normal.shape == (0, 6)
    assert floats.length == Fraction(1)
