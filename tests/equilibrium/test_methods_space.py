"""The other methods in space: hulls against scipy, proofs of round cones by substitution."""

import json
from fractions import Fraction

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from arrangement.numbers.exact import dot
from equilibrium.cli.program import main
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.methods.compare import compare
from equilibrium.methods.friction_cones.form_closure import form_closure
from equilibrium.methods.friction_cones.grasp_wrench_space import GraspWrenchSpace
from equilibrium.methods.friction_cones.round_cones import round_cones
from equilibrium.methods.registry import DECIDING_IN_SPACE
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.wrenches.methods import draw_methods
from equilibrium.plane.contact_rows import friction_edges

LOADS = [(0, 1, 0), (1, 1, 0), (-3, 7, 1), (0, -5, 2)]


def on_a_table(x, y, z):
    return (x, y, z, 0, 0, 0)


@pytest.mark.parametrize("name", ["three-fingers-on-a-ball", "box-held-by-four"])
def test_the_exact_hull_has_the_radius_of_scipys(name):
    grasp = read_grasp(name)
    edges = [edge for contact in grasp for edge in friction_edges(contact)]
    hull = ConvexHull(np.array([[0] * 6, *edges], dtype=float))
    assert GraspWrenchSpace(grasp).epsilon == pytest.approx(min(-hull.equations[:, -1]))


def test_torques_over_a_length_change_the_radius_alone():
    grasp = read_grasp("box-held-by-four")
    one, other = GraspWrenchSpace(grasp), GraspWrenchSpace(grasp, length=Fraction(1, 10))
    assert one.force_closure
    assert other.force_closure
    assert one.epsilon_squared != other.epsilon_squared


@pytest.mark.parametrize("name", ["paper-three-contacts", "paper-four-contacts"])
@pytest.mark.parametrize("wrench", LOADS)
def test_planar_grasps_answer_as_in_the_plane(name, wrench):
    grasp, (x, y, torque) = read_grasp(name), wrench
    flat, solid = compare(grasp, wrench), compare(grasp.in_space(), (x, y, 0, 0, 0, torque))
    assert tuple(answer.method for answer in solid.answers) == DECIDING_IN_SPACE
    for key in ("complete", "wrench-space", "weak", "frictionless"):
        assert solid[key].accepts is flat[key].accepts


def test_a_round_cone_holds_what_its_pyramid_lets_go():
    table = read_grasp("box-on-a-table")
    assert len({contact.friction for contact in table}) == 1
    push = table.contacts[0].friction * Fraction(7, 10)
    found = compare(table, on_a_table(push, push, -1))
    assert found["weak"].accepts is True
    assert found["wrench-space"].accepts is False
    beyond = table.contacts[0].friction * Fraction(71, 100)
    assert compare(table, on_a_table(beyond, beyond, -1))["weak"].accepts is False


@pytest.mark.parametrize("seed", range(8))
def test_both_answers_of_round_cones_are_proofs(seed):
    grasp = random_grasp(4, seed=seed, dimension=3)
    load = tuple(map(Fraction, (1, -2, 1, 0, 1, 1)))
    found = round_cones(grasp, load)
    assert found.accepts is not None
    if found.accepts:
        total = list(load)
        for contact, force in zip(grasp, found.forces, strict=True):
            normal, *friction = force
            assert normal >= 0
            assert sum(x * x for x in friction) <= (contact.friction * normal) ** 2
            rows = (contact.normal_wrench, *contact.tangential_wrenches)
            for factor, row in zip(force, rows, strict=True):
                total = [a + factor * b for a, b in zip(total, row, strict=True)]
        assert not any(total)
    else:
        motion = found.separating_motion
        assert dot(load, motion) > 0
        for contact in grasp:
            push = dot(contact.normal_wrench, motion)
            slip = sum(dot(row, motion) ** 2 for row in contact.tangential_wrenches)
            assert push >= 0
            assert push**2 >= contact.friction**2 * slip


def test_form_closure_in_space_takes_seven_contacts():
    """Twelve fingers off the middles of the sides of a box stop every turn; six of them do not."""
    contacts = []
    for axis in range(3):
        for side in (1, -1):
            for shift in (1, -1):
                point, normal = [Fraction(0)] * 3, [0] * 3
                point[axis], normal[axis] = Fraction(side), -side
                point[(axis + 1) % 3] = Fraction(shift, 2)
                contacts.append(Contact(point, normal, 0))
    closed = form_closure(Grasp(contacts))
    assert closed.accepts is True
    for row in zip(*(c.normal_wrench for c in contacts), strict=True):
        assert dot(row, closed.multipliers) == 0
    free = form_closure(Grasp(contacts[:6]))
    assert free.accepts is None
    assert all(dot(c.normal_wrench, free.free_motion) >= 0 for c in contacts[:6])


def test_the_command_takes_a_grasp_in_space(capsys):
    load = ["--wrench", "0", "0", "0", "1", "0", "0"]
    assert main(["compare", "two-opposed-fingers", *load, "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["stable"] is False
    assert [entry["method"] for entry in found["methods"]] == list(DECIDING_IN_SPACE)


def test_pyramids_are_for_all_methods_with_friction(capsys):
    between = ["--wrench", "0", "7/10", "7/10", "0", "0", "0"]
    assert main(["compare", "two-opposed-fingers", *between]) == 0
    capsys.readouterr()
    assert main(["compare", "two-opposed-fingers", *between, "--cone", "pyramid:4", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["pyramid"], found["stable"]) == (4, False)
    fingers, load = read_grasp("two-opposed-fingers"), (0, "7/10", "7/10", 0, 0, 0)
    assert compare(fingers, load, pyramid=16).stable
    assert compare(fingers, load, pyramid=16)["weak"].accepts
    for name, options in (("two-opposed-fingers", between), ("paper-three-contacts", "123")):
        edges = "pyramid:7" if options == between else "pyramid:8"
        wrench = between if options == between else ["--wrench", "0", "1", "0"]
        assert main(["compare", name, *wrench, "--cone", edges]) == 2
        assert capsys.readouterr().err.count("\n") == 1


def test_the_wrench_space_in_space_has_a_radius_and_no_slice(capsys):
    assert main(["wrench-space", "box-held-by-four", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["epsilon_squared"], found["pyramid"]) == ("4/25", 4)
    assert not {"volume", "slice"} & set(found)
    for options in (["--torque", "1"], ["--cone", "pyramid:6"]):
        assert main(["wrench-space", "box-held-by-four", *options]) == 2
        assert capsys.readouterr().err.count("\n") == 1


def test_the_table_of_methods_is_drawn_in_space_too():
    questions = [(0, 1, 0, 0, 0, 0), (0, 0, 0, 1, 0, 0)]
    scene = draw_methods.scene(read_grasp("two-opposed-fingers"), wrenches=questions)
    cells = {item.name for item in scene.items if item.name.startswith("cell")}
    assert len(cells) == 2 * len(DECIDING_IN_SPACE)
