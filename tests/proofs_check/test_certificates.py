"""The second route on proofs: it counts leaves, and refuses whatever does not hold."""

from copy import deepcopy
from fractions import Fraction
from typing import Any

import pytest

from equilibrium import solve
from proofs_check.claims import space as certificates
from proofs_check.instances.grasps import grasp_of
from proofs_check.routes.leaves import _least, leaf_count
from proofs_check.routes.oracle import Touch

QUESTION = certificates._jaws(6, (Fraction(1), Fraction(-5, 2), Fraction(1)))


def tree() -> Any:
    verdict = solve(grasp_of(QUESTION), QUESTION.wrench)
    assert not verdict.stable
    return verdict.certificate.to_dict()["tree"]


def leaf_places(node: Any) -> list[tuple[list[Any], int]]:
    """Return every list of children with the place of a leaf in it."""
    children = node.get("orthants") or node["children"]
    found: list[tuple[list[Any], int]] = []
    for place, child in enumerate(children):
        found += [(children, place)] if isinstance(child, list) else leaf_places(child)
    return found


def test_the_leaves_of_a_proof_are_counted():
    found = tree()
    assert leaf_count(QUESTION, found) == len(leaf_places(found)) == 12


def test_a_tree_with_a_wrong_leaf_is_refused():
    for number in range(12):
        changed = deepcopy(tree())
        children, place = leaf_places(changed)[number]
        children[place] = [str(-Fraction(x)) for x in children[place]]
        with pytest.raises(ValueError, match="does not close"):
            leaf_count(QUESTION, changed)


def test_a_resisted_load_has_no_proof():
    held = certificates._jaws(6, (Fraction(0), Fraction(1), Fraction(0)))
    with pytest.raises(ValueError, match="does not close"):
        leaf_count(held, tree())


@pytest.mark.parametrize(
    ("preload", "along", "works"),
    [
        ("1/2", "1", ("0", "0")),  # convex in between, where the contact opens at one end
        ("3/2", "1", ("3/2", "1/2")),
        ("1", "1", ("1", "0")),
        ("1/2", "-1/2", ("-1/4", "0")),
    ],
)
def test_work_of_a_contact_is_bounded_between_generators(preload, along, works):
    zero, one = Fraction(0), Fraction(1)
    touch = Touch((one, zero, zero), (zero, one, zero), one, Fraction(preload), zero)
    region = [(one, x, zero, zero) for x in (zero, one)]
    found = _least(touch, (Fraction(along), zero, zero), region)
    assert tuple(map(str, found)) == works


@pytest.mark.parametrize(
    "node",
    [
        {"contact": 0, "attachment": {"detached": ["0", "1", "0"], "attached": ["0", "1", "0"]}},
        {"virtual_motion": ["0", "1", "0"], "multipliers": {}},
        {"edge": [0, 1], "children": [["0", "1", "0"], ["0", "1", "0"]]},
    ],
)
def test_other_nodes_are_refused(node):
    with pytest.raises(ValueError, match="regions alone"):
        leaf_count(QUESTION, node)


def test_an_edge_is_cut_between_two_ends():
    below = [["0", "1", "0"]] * 2
    for change in ({"edge": [1, 1]}, {"edge": [0, 1], "at": ["-1", "2"]}):
        node = {"orthants": [{"children": below, **change}] + [["0", "1", "0"]] * 7}
        with pytest.raises(ValueError, match="between its ends"):
            leaf_count(QUESTION, node)
