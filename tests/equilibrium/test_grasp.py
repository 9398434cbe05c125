"""Contacts, grasps and unit normals: conventions, validation, identity."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement.errors import InputError
from equilibrium import Contact, Grasp, GraspError, read_grasp, solve, unit_normal

from .strategies import contacts, grasps


def test_tangent_is_the_normal_turned_left_and_torque_is_counter_clockwise():
    contact = Contact((-1, 1), (1, 0), "1/2")
    assert contact.tangent == (0, 1)
    assert contact.normal_wrench == (1, 0, -1)
    assert contact.tangential_wrench == (0, 1, -1)


@given(contacts, st.tuples(*[st.integers(-3, 3)] * 3))
def test_wrench_times_motion_is_the_displacement_of_the_contact_point(contact, motion):
    x, y, r = motion
    moved = (x - r * contact.point[1], y + r * contact.point[0])
    for wrench, along in (
        (contact.normal_wrench, contact.normal),
        (contact.tangential_wrench, contact.tangent),
    ):
        assert sum(a * b for a, b in zip(wrench, motion, strict=True)) == sum(
            a * b for a, b in zip(moved, along, strict=True)
        )


def test_equal_contacts_are_equal_whatever_the_number_type():
    texts = Contact(("1/2", "0"), ("0.6", "0.8"), "0.5", "1", "0")
    others = Contact((sympy.Rational(1, 2), 0), (Fraction(3, 5), Fraction(4, 5)), Fraction(1, 2))
    assert texts == others
    assert hash(texts) == hash(others)
    assert Grasp([texts]) == Grasp([others])
    assert len({Grasp([texts]), Grasp([others])}) == 1


def test_values_are_frozen():
    contact = Contact((0, 0), (1, 0), 0)
    with pytest.raises(AttributeError):
        contact.friction = Fraction(1)


@given(grasps(4))
def test_file_form_round_trip(grasp):
    assert Grasp.from_dict(grasp.to_dict()) == grasp


def test_normal_that_is_not_unit_names_the_remedy():
    for normal in ((1, 1), (0, 0), ("0.6", "0.80000000000000000001")):
        with pytest.raises(GraspError, match=r"unit_normal\(direction, tolerance\)"):
            Contact((0, 0), normal, 1)


@pytest.mark.parametrize(
    ("direction", "normal"),
    [
        *((axis, axis) for axis in ((1, 0), (0, 1), (-1, 0), (0, -1))),
        ((0, 2.5), (0, 1)),
        *(((x, y), (Fraction(x, 5), Fraction(y, 5))) for x in (-3, 3) for y in (-4, 4)),
    ],
)
def test_rational_lengths_are_exact_in_every_quadrant(direction, normal):
    assert unit_normal(direction) == (normal, 0)


@given(
    st.tuples(*[st.floats(-1e6, 1e6).filter(lambda x: x == 0 or abs(x) > 1e-6)] * 2).filter(any),
    st.sampled_from([Fraction(1), Fraction(1, 100), Fraction(1, 10**12)]),
)
def test_unit_normal_is_unit_and_within_the_tolerance(direction, tolerance):
    normal, error = unit_normal(direction, tolerance)
    assert normal[0] ** 2 + normal[1] ** 2 == 1
    wanted = tuple(map(Fraction, direction))
    sine = wanted[0] * normal[1] - wanted[1] * normal[0]
    cosine = wanted[0] * normal[0] + wanted[1] * normal[1]
    assert cosine > 0
    assert error * cosine == sine
    assert abs(error) <= tolerance


@pytest.mark.parametrize(
    ("direction", "tolerance"),
    [((0, 0), "1/10"), ((1,), "1/10"), ((1, 1), 0), ((1, 1), 2), ((float("nan"), 1), "1/10")],
)
def test_unit_normal_refuses(direction, tolerance):
    with pytest.raises(InputError):
        unit_normal(direction, tolerance)


def test_public_objects_are_one_line_of_at_most_a_hundred_characters():
    grasp = read_grasp("paper-three-contacts-preload-1")
    held, lost = (solve(grasp, [0, pull, 0]) for pull in (1, 5))
    shown = (grasp, grasp.contacts[0], held, lost, held.solution, *held.equilibria)
    for text in map(repr, (*shown, held.certificate, lost.certificate, lost.verify())):
        assert len(text) <= 100
        assert "\n" not in text
        assert "Fraction" not in text
    assert "not resisted" in repr(lost)


def test_a_saved_grasp_is_read_back(tmp_path):
    grasp = read_grasp("paper-three-contacts-preload-1").with_units("mm", "N")
    grasp.save(tmp_path / "grasp.json")
    found = read_grasp(tmp_path / "grasp.json")
    assert found == grasp
    assert found.units == grasp.units
