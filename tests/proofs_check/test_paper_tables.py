"""The printed numbers: complete, and the same grasps as the built-in ones."""

from fractions import Fraction

import pytest

from equilibrium.grasps.files import read_grasp
from proofs_check import evaluate, registry
from proofs_check.instances import printed
from proofs_check.instances.grasps import grasp_of, paper_question


def test_there_are_seven_and_ten_rows_and_eight_counts():
    assert len(printed.THREE_CONTACTS) == 7
    assert len(printed.FOUR_CONTACTS) == 10
    assert sorted(printed.STATE_COUNTS) == list(range(2, 10))


def test_stable_rows_have_a_force_for_each_contact_and_others_have_none():
    for size, rows in ((3, printed.THREE_CONTACTS), (4, printed.FOUR_CONTACTS)):
        for row in rows:
            assert len(row.forces) == (size if row.stable == "Yes" else 0)
            assert bool(row.motion) == (row.stable == "Yes")


def test_only_one_cell_is_a_misprint():
    rows = printed.THREE_CONTACTS + printed.FOUR_CONTACTS
    cells = [c for row in rows for c in (row.wrench, row.motion, *row.forces) if c]
    assert [c for c in cells if printed.read_vector(c)[1]] == ["(0,0.0.25,-0.25)"]


def test_text_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="cannot be read"):
        printed.read_vector("(1,two)")


@pytest.mark.parametrize(
    ("contacts", "preload", "name"),
    [
        (printed.THREE_CONTACT_GRASP, 0, "paper-three-contacts"),
        (printed.THREE_CONTACT_GRASP, 1, "paper-three-contacts-preload-1"),
        (printed.FOUR_CONTACT_GRASP, 0, "paper-four-contacts"),
        (printed.FOUR_CONTACT_GRASP, 1, "paper-four-contacts-preload-1"),
    ],
)
def test_the_grasps_are_the_built_in_ones(contacts, preload, name):
    question = paper_question(contacts, [Fraction(0)] * 3, preload)
    assert grasp_of(question) == read_grasp(name)


@pytest.mark.parametrize("id", ["table-three-contacts", "table-four-contacts"])
def test_every_row_reads_as_printed(id):
    assert evaluate(registry()[id]).as_expected
