"""The built-in grasps are what their descriptions say."""

import json
from fractions import Fraction

import pytest

from equilibrium.decide.verdict import solve
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.instances import paths
from equilibrium.methods.contact_laws.printed_model import solve_literal
from equilibrium.wrench_sets import resisted_magnitudes


@pytest.mark.parametrize("name", paths())
def test_every_built_in_grasp_reads_and_describes_itself(name):
    assert len(read_grasp(name)) > 0
    description = json.loads(paths()[name].read_bytes())["description"]
    assert ("preload 1" in description) == any(c.preload == 1 for c in read_grasp(name))
    assert ("no preload" in description) <= all(c.preload == 0 for c in read_grasp(name))


def test_resistance_is_interrupted_and_goes_on():
    found = resisted_magnitudes(read_grasp("interrupted-resistance"), (0, 1, 0))
    assert found.intervals == ((0, Fraction(5, 2)), (4, None))


def test_several_equilibria_have_different_normal_forces():
    verdict = solve(read_grasp("several-equilibria"), (-1, 0, 0))
    assert len({piece.forces[0][0] for piece in verdict.equilibria}) > 1


def test_friction_along_the_slip_is_found_by_the_printed_algorithm_alone():
    question = read_grasp("friction-along-slip"), (0, 0, 1)
    assert not solve(*question).stable
    (found,) = solve_literal(*question, ["cell-check", "detachment"]).equilibria
    pushed = [
        sum(a * b for a, b in zip(contact.tangential_wrench, found.motion, strict=True))
        * tangential
        for contact, (_, tangential) in zip(question[0], found.forces, strict=True)
    ]
    assert max(pushed) > 0


def test_one_contact_has_to_let_go():
    question = read_grasp("one-contact-lets-go"), (-1, 0, 0)
    assert all(piece.states[1] == "detached" for piece in solve(*question).equilibria)
    assert solve(*question).stable
    assert not solve_literal(*question, ["detachment"]).stable


def test_all_contacts_stick_in_the_only_equilibrium():
    (found,) = solve(read_grasp("all-contacts-stick"), (0, 0, 0)).equilibria
    assert found.unique
    assert found.motion == (0, 0, 0)
    assert found.states == ("stick",) * 3


def test_the_normals_of_the_offset_grasp_meet_in_no_point():
    rows = [contact.normal_wrench for contact in read_grasp("offset-three-contacts")]
    (a, b, c), (d, e, f), (g, h, i) = rows
    assert a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) != 0
