"""The checker of trees against a second, naive evaluation, brute force, and changed documents."""

from __future__ import annotations

import ast
import inspect
import json
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import product
from operator import mul
from random import Random
from typing import Any

import jsonschema
import pytest

from arrangement.errors import InputError
from arrangement.numbers.exact import vector_text
from equilibrium import CertificateError, Contact, Grasp, Solution
from equilibrium.certificate import (
    assemblies,
    checker,
    contact_rule,
    enclosure,
    law,
    leaf_rule,
    reading,
    report,
    robust,
    tree,
)
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import Certificate, certificate, resisted_certificate
from equilibrium.certificate.report import Report
from equilibrium.certificate.tree import MAX_DEPTH
from equilibrium.grasps.schemas import certificate_schema
from proofs_check.routes.oracle import Touch
from tests.schemas import validator

from . import judge, oracle, trees
from .degenerate import question
from .mutations import mutants

#: Seeds of `degenerate.question` of two and three contacts, by verdict.
REFUTED = (1, 29, 41, 80, 81, 104, 112, 117, 133, 136, 168, 169, 180, 188, 193)
RESISTED = (0, 4, 5, 8, 9, 17, 21, 25)
TREES = range(3)


def refuted(seed: int, tree: int) -> dict[str, Any]:
    """Return a certificate of at most 60 nodes; seeds of trees prefer other splits."""
    asked = question(seed)
    for other in range(tree, 100, len(TREES)):
        try:
            found = trees.refutation(asked.grasp, asked.wrench, 100 * seed + other, 60)
        except trees.TooLarge:
            continue
        return certificate("not resisted", asked.grasp, asked.wrench, tree=found).to_dict()
    raise AssertionError(f"no small tree for the question of seed {seed}")


def resisted(seed: int) -> dict[str, Any]:
    asked = question(seed)
    found = next(oracle.solutions(asked.grasp, asked.wrench))
    held = Solution(found.motion, found.forces)
    return resisted_certificate(asked.grasp, asked.wrench, held).to_dict()


@pytest.fixture(scope="module")
def documents() -> list[dict[str, Any]]:
    listed = [refuted(seed, tree) for seed in REFUTED for tree in TREES]
    return [*listed, *map(resisted, RESISTED)]


@cache
def is_stable(grasp: Grasp, wrench: tuple[Fraction, ...]) -> bool:
    return oracle.is_stable(grasp, wrench)


def report_of(document: Any) -> Report | None:
    """Return the report, or None for a document that is not a certificate."""
    try:
        return check(document)
    except InputError:
        return None


def agree(document: Any, where: Any = None) -> str:
    """Check that checker and judge agree on a document, and both with brute force."""
    report = report_of(document)
    if report is None:
        return "malformed"
    assert bool(report) == judge.is_proof(document), (where, report)
    if report and report.kind == "not resisted":
        assert not is_stable(*judge.statement(document)), where
    return "accepted" if report else "refused"


def nodes(value: Any, path: tuple = ("tree",)) -> Iterator[tuple[tuple, Any]]:
    """Yield all nodes of a tree with their paths."""
    yield path, value
    if isinstance(value, dict):
        for key in ("orthants", "children", "attachment", "slip"):
            below = value.get(key, ())
            for name in below if isinstance(below, dict) else range(len(below)):
                yield from nodes(below[name], (*path, key, name))


LEAF = ["0", "0", "0"]
ONE = Grasp([Contact((0, 0), (0, 1), "1/2", 1, 1)])
HALVED = {"edge": [0, 1], "children": [LEAF, LEAF]}
ORTHANTS = {"orthants": [LEAF] * 8}
ATTACHMENT = {"contact": 0, "attachment": {"detached": LEAF, "attached": LEAF}}
SLIP = {"contact": 0, "slip": {"stick": LEAF, "slip+": LEAF, "slip-": LEAF}}


def with_tree(tree: Any) -> dict[str, Any]:
    document = certificate("not resisted", ONE, (Fraction(1),) * 3, tree=None).to_dict()
    return {**document, "tree": tree}


def below(outer: dict[str, Any], inner: Any) -> dict[str, Any]:
    """Put a node in the place of all leaves of a split."""
    return {
        key: [inner] * len(value)
        if key in ("orthants", "children")
        else dict.fromkeys(value, inner)
        if isinstance(value, dict)
        else value
        for key, value in outer.items()
    }


@pytest.mark.parametrize(
    "tree",
    [LEAF, ORTHANTS, below(ORTHANTS, HALVED), ATTACHMENT, below(ORTHANTS, ATTACHMENT)]
    + [{"contact": 0, "attachment": {"detached": LEAF, "attached": SLIP}}]
    + [{"virtual_motion": LEAF, "multipliers": m} for m in ({}, {"0": ["0"]}, {"0": ["0", "1"]})],
)
def test_a_wrong_proof_of_readable_form_is_a_report(tree):
    report = check(with_tree(tree))
    assert not report
    assert report.problem.startswith("tree")
    assert report.to_dict()["problem"] == report.problem
    assert not check(with_tree(tree), (ONE, (Fraction(1),) * 3))


@pytest.mark.parametrize(
    ("tree", "words"),
    [
        (None, "tree is null|tree is None"),
        ("1", "tree is '1'"),
        ([], "tree has 0 entries; expected 3"),
        (["0", "0"], "tree has 2 entries"),
        (["0", "0", 0.5], "float"),
        (["0", "0", "1e30000"], "not an exact number"),
        (["0", "0", "1/0"], "divides by zero"),
        (["0", "0", True], "Boolean"),
        (["0", "0", None], r"tree\[2\]"),
        ({}, "an object with one"),
        ({"node": LEAF}, "an object with one"),
        ({**ORTHANTS, "children": []}, "unknown key 'children'"),
        ({"orthants": [LEAF] * 7}, "tree.orthants has 7 entries"),
        ({"orthants": {}}, "tree.orthants is an object"),
        (below(ORTHANTS, ORTHANTS), r"tree.orthants\[0\]: orthants cut the half space"),
        (HALVED, "tree: orthants cut the half space, an edge"),
        (below(ORTHANTS, {"edge": [0, 1]}), 'no key "children"'),
        (below(ORTHANTS, {**HALVED, "children": [LEAF] * 3}), "has 3 entries; expected 2"),
        (below(ORTHANTS, {**HALVED, "edge": [1, 1]}), "two generators"),
        (below(ORTHANTS, {**HALVED, "edge": [1, 4]}), "0 to 3"),
        (below(ORTHANTS, {**HALVED, "edge": [-1, 2]}), "0 to 3"),
        (below(ORTHANTS, {**HALVED, "edge": ["1", 2]}), "0 to 3"),
        (below(ORTHANTS, {**HALVED, "edge": [True, 2]}), "0 to 3"),
        (below(ORTHANTS, {**HALVED, "edge": [0, 1, 2]}), "3 entries; expected 2"),
        (below(ORTHANTS, {**HALVED, "at": ["1"]}), "1 entries; expected 2"),
        (below(ORTHANTS, {**HALVED, "at": ["0", "1"]}), "above 0"),
        (below(ORTHANTS, {**HALVED, "at": ["1", "-1"]}), "above 0"),
        (below(ORTHANTS, {**HALVED, "at": ["1/2", "1"]}), "integers"),
        (below(ORTHANTS, {**HALVED, "at": ["1", "1/3"]}), "integers"),
        ({**ATTACHMENT, "contact": 1}, "0 to 0"),
        ({**ATTACHMENT, "contact": -1}, "0 to 0"),
        ({**ATTACHMENT, "contact": "0"}, "0 to 0"),
        ({"attachment": ATTACHMENT["attachment"]}, 'no key "contact"'),
        ({**ATTACHMENT, **SLIP}, "unknown key"),
        ({"contact": 0, "attachment": {"detached": LEAF}}, 'no key "attached"'),
        ({"contact": 0, "attachment": [LEAF, LEAF]}, "tree.attachment is a list"),
        (SLIP, "contact 1 is not attached here"),
        (below(ATTACHMENT, ATTACHMENT), "contact 1 is not undecided here"),
        (below(ATTACHMENT, SLIP), "contact 1 is not attached here"),
        ({"virtual_motion": LEAF}, 'no key "multipliers"'),
        ({"virtual_motion": ["0"], "multipliers": {}}, "tree.virtual_motion has 1 entries"),
        ({"virtual_motion": LEAF, "multipliers": []}, "by contacts"),
        ({"virtual_motion": LEAF, "multipliers": {"1": ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {"00": ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {"-1": ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {"9" * 50: ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {"²": ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {0: ["0"]}}, "not a contact"),
        ({"virtual_motion": LEAF, "multipliers": {"0": []}}, "0 entries; expected 2"),
        ({"virtual_motion": LEAF, "multipliers": {"0": ["0"] * 3}}, "3 entries; expected 2"),
        ({"virtual_motion": LEAF, "multipliers": {"0": "0"}}, "expected a list"),
        ({"virtual_motion": LEAF, "multipliers": {"0": 0}}, "expected a list"),
    ],
)
def test_what_is_no_tree_is_one_clear_error(tree, words):
    with pytest.raises(InputError, match=words) as caught:
        check(with_tree(tree))
    assert "\n" not in str(caught.value)


def random_splits(source: Random, depth: int, in_cone: bool = False) -> Any:
    """Return a tree whose leaves are all alike; its cuts have common divisors."""
    if not depth:
        return LEAF
    if not in_cone:
        return {"orthants": [random_splits(source, depth - 1, True) for _ in range(8)]}
    if source.random() < 0.3:
        return LEAF
    edge = {"edge": source.sample(range(4), 2)}
    if source.random() < 0.7:
        edge["at"] = [str(source.choice((1, 2, 3, 4, 6))) for _ in range(2)]
    return {**edge, "children": [random_splits(source, depth - 1, True) for _ in range(2)]}


def test_regions_are_those_of_the_definition(monkeypatch):
    """Each generator, and spring and slip there, computed step by step and at once."""
    places = []
    monkeypatch.setattr(
        leaf_rule.TreeQuestion, "leaf_problem", lambda _, leaf, place: places.append(place.region)
    )
    for seed in range(20):
        document = with_tree(random_splits(Random(f"splits {seed}"), 6))
        places.clear()
        assert check(document)
        asked = leaf_rule.TreeQuestion.of(*judge.statement(document))
        due = list(judge.leaves(document["tree"]))
        for generators, (_, region, _) in zip(places, due, strict=True):
            assert [list(generator.vector) for generator in generators] == region
            for vector, springs, slips in generators:
                assert springs == (sum(map(mul, asked.contacts[0].spring, vector)),)
                assert slips == (sum(map(mul, asked.contacts[0].wrenches[1], vector)),)


def test_load_on_a_grasp_without_contacts_is_refuted_by_any_motion_with_it() -> None:
    proof = certificate(
        "not resisted", Grasp(), (Fraction(1), Fraction(0), Fraction(0)), tree=["1", "0", "0"]
    )
    assert proof.verify()
    orthants = {"orthants": [["1", "0", "0"]] * 8}
    tree = {**proof.to_dict(), "tree": orthants}
    assert check(tree)
    assert not check({**tree, "tree": ["0", "1", "0"]})


def random_leaf(source: Random) -> tuple[Any, ...]:
    """Return contact, wrench, leaf, region and states with small numbers, often on a bound."""
    normal = source.choice([(1, 0), (0, 1), (0, -1), (-1, 0), ("3/5", "4/5"), ("4/5", "-3/5")])
    numbers = source.choice((0, 1, "1/2")), source.choice((1, 1, 2)), source.choice((0, 1, 2))
    grasp = Grasp([Contact((source.randint(-1, 1), source.randint(-1, 1)), normal, *numbers)])
    leaf: Any = [str(source.randint(-2, 2)) for _ in range(3)]
    if source.random() < 0.6:
        given = [source.choice(("0", "1", "2", "1/2", "-1/2", "-1", "1/5")) for _ in range(2)]
        given = given[: source.randint(1, 2)]
        leaf = {"virtual_motion": leaf, "multipliers": {"0": given}}
    wrench = tuple(Fraction(source.randint(-2, 2), source.choice((1, 2))) for _ in range(3))
    state = source.choice(["", "", "detached", "attached", "stick", "slip+", "slip-"])
    region = judge.half_space()
    if source.random() < 0.8:
        axes = [judge.axis(j, source.choice((1, -1))) for j in (1, 2, 3)]
        region = [judge.ORIGIN, *axes]
        for _ in range(source.randint(0, 4)):
            j, k = source.sample(range(4), 2)
            region[j] = [x + y for x, y in zip(region[j], region[k], strict=True)]
    return grasp, wrench, leaf, region, {0: state} if state else {}


def leaf_holds(
    grasp: Grasp, wrench: Any, leaf: Any, region: Any, states: Any, most: Fraction | None = None
) -> bool:
    """Return whether the checker accepts a leaf."""
    asked = leaf_rule.TreeQuestion.of(grasp, wrench, max_displacement=most)
    generators = [asked.generator(tuple(map(int, vector))) for vector in region]
    node = reading.read_node(leaf, "leaf", len(grasp), asked.form)
    return not asked.leaf_problem(node, reading.Place("leaf", 0, generators, states))


@pytest.mark.parametrize(
    ("cases", "kinds"), [(800, 20), pytest.param(2000, 22, marks=pytest.mark.slow)]
)
def test_the_bounds_of_a_leaf_are_exact(cases, kinds):
    source, found = Random("leaves"), Counter()
    for _ in range(cases):
        asked = random_leaf(source)
        holds = leaf_holds(*asked)
        assert holds == judge.leaf_holds(*asked), asked
        found[holds, len(asked[3]), asked[4].get(0, "")] += 1
    assert len(found) >= kinds


def test_one_sided_slip_region_has_one_friction():
    """Under a load that does much work, one contact whose slips are given, at unit springs."""
    grasp, found = Grasp([Contact((0, 0), (0, 1), 1, 1, 1)]), Counter()
    slips = [tuple(side * x for x in row) for row in ((1, 2), (0, 1), (-1, 1)) for side in (1, -1)]
    states = ("", "detached", "attached", "stick", "slip+", "slip-")
    for state, ends, x, *given in product(states, slips, (1, -1), (-1, 0, 2), (-1, 0, 1)):
        region = [[Fraction(1), Fraction(-s), Fraction(0), Fraction(0)] for s in ends * 2]
        leaf = {"virtual_motion": [str(x), "1", "0"], "multipliers": {"0": list(map(str, given))}}
        load = (Fraction(9 * x), Fraction(9), Fraction(0))
        asked = grasp, load, leaf, region, {0: state} if state else {}
        holds = leaf_holds(*asked)
        assert holds == judge.leaf_holds(*asked), asked
        found[holds] += 1
    assert min(found.values()) > 100
    # Without multipliers, where one end has no spring force.
    region = [judge.ORIGIN, judge.axis(1, 1), judge.axis(1, -1), judge.axis(1, 1)]
    load = (Fraction(0), Fraction(-1, 2), Fraction(0))
    asked = grasp, load, ["0", "1", "0"], region, dict[int, str]()
    assert leaf_holds(*asked)
    assert judge.leaf_holds(*asked)
    # One that is undecided takes nothing where its spring would pull; another gives slip its work.
    both = Grasp([*grasp, Contact((0, 0), (0, -1), 1, 1, 1)])
    leaf = {"virtual_motion": ["0", "-2", "0"], "multipliers": {"1": ["0", "1"]}}
    region = [[Fraction(x) for x in row] for row in ((1, -2, 2, 0), *[(1, 3, 0, 0)] * 3)]
    asked = both, load, leaf, region, {1: "stick"}
    assert not leaf_holds(*asked)
    assert not judge.leaf_holds(*asked)


#: Two contacts at the origin, pressed up by 3 and 1, the second with friction 2, and a load. On a
#: virtual motion their factors are 1 and -1, and where both are attached they do ``3 - 1``.
PRESSED = Grasp([Contact((0, 0), (0, 1), 0, 1, 3), Contact((0, 0), (0, 1), 2, 1, 1)])
PRESSED_LOAD, SIDEWAYS = (Fraction(0), Fraction(-1), Fraction(0)), ["1", "1", "0"]


@pytest.mark.parametrize(
    ("state", "side", "given", "holds"),
    [
        ("attached", 0, {"0": ["1"], "1": ["-1"]}, True),
        # What is left out is not kappa e where some motions detach the contact, attached or not.
        ("attached", 0, {"0": ["1"]}, False),
        ("attached", 0, {"1": ["-1"]}, False),
        ("attached", 0, {}, False),
        ("stick", 0, {}, False),
        ("slip+", 0, {}, False),
        ("", 0, {}, False),
        # Where all motions press it, it is, whatever its state.
        ("attached", -1, {}, True),
        ("stick", -1, {"1": ["-1"]}, True),
        ("slip-", -1, {"1": ["-1"]}, True),
        ("", -1, {}, True),
        ("detached", -1, {}, False),
        # 0 is not left out there.
        ("attached", -1, {"0": ["0"]}, False),
        ("attached", -1, {"1": ["0"]}, False),
        ("", -1, {"0": ["0"]}, False),
        # On the other side the second one does at least -1 where it presses, and then 0.
        ("attached", 1, {}, False),
        ("", 1, {"0": ["1"]}, False),
    ],
)
def test_contact_without_multipliers_does_what_its_region_says(state, side, given, holds):
    region = [judge.ORIGIN, *(judge.axis(j, 1) for j in (1, 2, 3))] if side else judge.half_space()
    if side:
        region[2] = judge.axis(2, side)
    leaf = {"virtual_motion": SIDEWAYS, "multipliers": given}
    asked = PRESSED, PRESSED_LOAD, leaf, region, dict.fromkeys(range(2), state) if state else {}
    assert leaf_holds(*asked) == judge.leaf_holds(*asked) == holds


def test_constant_force_counts_without_multipliers():
    """A contact without stiffness is pressed by 3 at all motions, with the factor 1, or -1."""
    for friction, load, holds in ((0, -2, True), (0, -3, False), (2, 4, True), (2, 3, False)):
        grasp = Grasp([Contact((0, 0), (0, 1), friction, 0, 3)])
        for state in ("", "attached", "stick"):
            wrench = (Fraction(0), Fraction(load), Fraction(0))
            asked = grasp, wrench, SIDEWAYS, judge.half_space(), {0: state} if state else {}
            assert leaf_holds(*asked) == judge.leaf_holds(*asked) == holds


@pytest.mark.parametrize(
    ("most", "used", "moved", "holds"),
    [
        # A displacement costs D times its size of the work 1/3 of the load, and gives what it is.
        ("1/4", {"0": ["0", "-1"]}, (1, 1), True),
        ("1/3", {"0": ["0", "-1"]}, (1, 1), False),
        ("1/4", {"0": ["0", "-1"]}, (1, -1), False),
        ("1/4", {"0": ["0", "1"]}, (1, -1), True),
        ("1/4", {"0": ["1", "0"]}, (2, 1), True),
        ("1/4", {"0": ["1", "0"]}, (2, -1), False),
        ("1/7", {"0": ["1", "-1"]}, (1, 1), True),
        ("1/6", {"0": ["1", "-1"]}, (1, 1), False),
        ("1/7", {"0": ["0", "-1"], "1": ["0", "-1"]}, (1, 1), True),
        ("1/6", {"0": ["0", "-1"], "1": ["0", "-1"]}, (1, 1), False),
        # Lever arms of both contacts: 1 to the right, 1 to the left.
        ("1/4", {"1": ["1", "0"]}, (3, 1), False),
        ("1/4", {"1": ["-1", "0"]}, (3, 1), True),
        ("1/4", {"0": ["0", "0"]}, (1, 1), True),
        (None, {"0": ["0", "0"]}, (1, 1), False),
    ],
)
def test_leaf_pays_for_bounded_displacements(most, used, moved, holds):
    """Two detached contacts on a floor; a load that works 1/3 on the virtual motion."""
    contacts = Grasp([Contact((x, 0), (0, 1), 0, 1, 0) for x in (1, -1)])
    leaf = {"virtual_motion": ["0", "1", "0"], "multipliers": {}, "displacements": used}
    load = (Fraction(0), Fraction(1, 3), Fraction(0))
    region = [judge.ORIGIN, *[judge.axis(*moved)] * 3]
    bound = None if most is None else Fraction(most)
    states = dict.fromkeys(range(2), "detached")
    assert leaf_holds(contacts, load, leaf, region, states, bound) == holds


@pytest.mark.parametrize(
    ("point", "most", "motion", "words"),
    [
        ((2, 0), "1/2", (0, "-1/2", 0), ""),
        ((2, 0), "1/2", ("1/2", 0, 0), ""),
        (
            (2, 0),
            "1/2",
            ("-2/3", 0, 0),
            "its point moves by 2/3, and at most 1/2 counts",
        ),
        ((2, 0), "1/2", (0, "-3/2", "1/2"), ""),
        ((2, 0), "1/2", (0, "-3/2", "1/4"), "contact 1: its point moves by -1,"),
        ((2, 0, 0), 1, (0, 0, 1, 9, 1, 0), ""),
        ((2, 0, 0), 1, (0, 0, 1, 9, 2, 0), "contact 1: its point moves by -3"),
        ((0, 0, 0), 1, (1, -1, 1, 9, 9, 9), ""),
        ((0, 0, 0), 1, (1, "-5/4", 1, 0, 0, 0), "contact 1: its point moves by"),
    ],
)
def test_equilibrium_moves_no_point_further_than_counts(point, most, motion, words):
    normal = (0, 1) if len(point) == 2 else (0, 0, 1)
    grasp = Grasp([Contact(point, normal, 1)])
    problem = law.displacement_problem(
        law.law_rows(grasp), tuple(map(Fraction, motion)), Fraction(most)
    )
    assert bool(problem) == bool(words)
    assert words in problem
    assert not law.displacement_problem(law.law_rows(grasp), tuple(map(Fraction, motion)), None)


@pytest.mark.parametrize(
    ("leaf", "words"),
    [
        (["0", "-3/2", "0"], "tree: at generator (1, 0, 0, 0) the work of load and contacts is -3"),
        (
            LEAF,
            "tree: at generator (1, 0, 0, 0) the work of load and contacts is 0, and must be",
        ),
        (
            {"virtual_motion": ["0", "1/2", "0"], "multipliers": {"0": ["2/3"]}},
            "tree: contact 1, undecided: alpha = 2/3, h = 0, kappa = 1/2: alpha is larger",
        ),
        (
            {"virtual_motion": ["0", "1/2", "0"], "multipliers": {"0": ["1/2"]}},
            "tree: at generator (0, 0, 1, 0) the work of load and contacts is -1/2",
        ),
    ],
)
def test_the_inequality_that_fails_is_named_with_its_numbers(leaf, words):
    """One contact below, spring 1 - y; the load (0, 1, 0) lifts."""
    document = certificate(
        "not resisted", ONE, (Fraction(0), Fraction(1), Fraction(0)), tree=leaf
    ).to_dict()
    assert check(document).problem.startswith(words)


@pytest.mark.parametrize(
    ("leaf", "words"),
    [
        (["0", "-1/2", "0"], "the work of load and contacts is -1, and"),
        ({"virtual_motion": ["0", "1/2", "0"], "multipliers": {"0": ["2/3"]}}, "kappa = 1/2:"),
    ],
)
def test_named_numbers_have_the_right_units(leaf, words):
    """Stiffness and friction with denominators: the checker counts in thirtieths here."""
    grasp = Grasp([Contact((0, 0), (0, 1), "1/5", "1/3", 1)])
    document = certificate(
        "not resisted", grasp, (Fraction(0), Fraction(1), Fraction(0)), tree=leaf
    ).to_dict()
    assert words in check(document).problem


def test_form_is_checked_behind_a_leaf_that_fails():
    tree = {"contact": 0, "attachment": {"detached": LEAF, "attached": ["0"]}}
    with pytest.raises(InputError, match=r"tree\.attachment\.attached"):
        check(with_tree(tree))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"schema_version": 1}, "schema_version is 1; 3 and 4 are read here"),
        ({"schema_version": True}, "schema_version is True"),
        ({"schema_version": 3.0}, "schema_version is 3.0"),
        ({"schema_version": 5}, "schema_version is 5"),
        ({"certificate": "maybe"}, "expected one of resisted, not resisted"),
        ({"certificate": ["resisted"]}, "expected one of resisted, not resisted"),
        ({"certificate": "resisted"}, "tree"),
        ({"digest": "0"}, "unknown key 'digest'"),
        ({"wrench": ["0", "0"]}, "wrench has 2 entries"),
        ({"wrench": "000"}, "wrench is"),
        ({"grasp": {}}, "schema_version"),
        ({"grasp": 5}, "the grasp is 5; expected"),
        ({"pyramid": 4}, "a pyramid is for a grasp in space"),
        ({"certificate": "unstable", "schema_version": 1}, "old certificate.*equilibrium solve"),
        ({"certificate": "stable", "schema_version": 1}, "old certificate.*equilibrium solve"),
    ],
)
def test_what_is_no_certificate_is_one_clear_error(change, words):
    with pytest.raises(InputError, match=words):
        check({**with_tree(LEAF), **change})
    with pytest.raises(InputError, match="expected an object"):
        check([with_tree(LEAF)])


def test_version_3_is_read_by_the_same_rule():
    for seed in REFUTED[:4]:
        for version, (_, _, document) in product((3, 4), mutants(refuted(seed, 0), 12, seed)):
            if document.get("schema_version") == 4:
                try:
                    expected = bool(check(document))
                except InputError:
                    continue
                assert bool(check({**document, "schema_version": version})) == expected
    # It left out multipliers of attached contacts, which are not assumed.
    attached = {"contact": 0, "attachment": {"detached": LEAF, "attached": SIDEWAYS}}
    proof = certificate("not resisted", PRESSED, PRESSED_LOAD, tree=attached).to_dict()
    problem = check(proof).problem
    assert "equilibrium solve" not in problem
    old = check({**proof, "schema_version": 3}).problem
    assert old.startswith(f"{problem}; version 3 left more multipliers out")
    assert "make a new certificate with `equilibrium solve`" in old


def test_deep_documents_end_with_an_error():
    deep: Any = LEAF
    for _ in range(10_000):
        deep = {"edge": [0, 1], "children": [deep, LEAF]}
    with pytest.raises(CertificateError, match=f"more than {MAX_DEPTH} splits in a row"):
        check(with_tree({"orthants": [deep] * 8}))
    while isinstance(deep, dict):  # from above: freeing it from within would recurse
        deep = deep["children"][0]


def test_the_deepest_tree_that_is_read_can_be_written_and_read():
    tree: Any = LEAF
    for _ in range(MAX_DEPTH - 1):
        tree = {"edge": [0, 1], "children": [tree, LEAF]}
    document = with_tree(below(ORTHANTS, LEAF))
    document["tree"]["orthants"][0] = tree
    assert not check(Certificate(json.dumps(document)).to_dict())
    document["tree"]["orthants"][0] = {"edge": [0, 1], "children": [tree, LEAF]}
    with pytest.raises(CertificateError, match="splits in a row"):
        check(document)


@pytest.mark.parametrize("place", ["tree", "wrench", "friction", "multiplier"])
def test_ten_million_digits_are_refused_at_once(place):
    digits = "7" * 10**7
    document = with_tree(LEAF)
    if place == "tree":
        document["tree"] = ["0", "0", digits]
    elif place == "multiplier":
        document["tree"] = {"virtual_motion": LEAF, "multipliers": {"0": [digits]}}
    elif place == "wrench":
        document["wrench"][0] = digits
    else:
        document["grasp"]["contacts"][0]["friction"] = digits
    with pytest.raises(InputError, match="10,000,000 characters"):
        check(document)


@pytest.mark.parametrize(
    ("motion", "forces", "words"),
    [
        (("0", "-1", "0"), [("2", "1")], ""),
        (("0", "-1", "0"), [("2", "3/2")], "contact 1: friction 3/2 of at most 1"),
        (("0", "-1", "0"), [("1", "1/2")], "normal force 1, its spring gives 2"),
        (("1", "-1", "0"), [("2", "1")], ""),
        (("-1", "-1", "0"), [("2", "1")], "contact 1: friction 1 of at most 1 while it slips by 1"),
        (("-1", "-1", "0"), [("2", "-1")], r"the forces add up to \(2, 0, 0\), not 0"),
        (("0", "0", "0"), [("1", "0")], r"the forces add up to \(1, -1, 0\), not 0"),
    ],
)
def test_the_law_is_named_where_it_fails(motion, forces, words):
    """One contact at the origin, normal upwards, tangent to the left: spring 1 - y, slip -x."""
    wrench = (Fraction(1), Fraction(-2), Fraction(0))
    numbers = [tuple(map(Fraction, pair)) for pair in forces]
    found = Solution(tuple(map(Fraction, motion)), tuple(numbers))
    report = resisted_certificate(ONE, wrench, found).verify()
    assert bool(report) == (not words)
    assert re.search(words, report.problem)


@pytest.mark.parametrize(
    ("motion", "forces", "words"),
    [
        (["0", "0"], [["1", "0"]], "motion has 2 entries"),
        (["0", "0", 0.5], [["1", "0"]], "float"),
        (["0", "0", "0"], [], "forces has 0 entries; expected 1"),
        (["0", "0", "0"], [["1"]], r"forces\[0\] has 1 entries"),
        (["0", "0", "0"], [["1", "x"]], r"forces\[0\]\[1\]"),
        ("000", [["1", "0"]], "motion is '000'"),
    ],
)
def test_what_is_no_equilibrium_is_one_clear_error(motion, forces, words):
    document = resisted_certificate(ONE, (Fraction(0),) * 3, Solution((), ())).to_dict()
    with pytest.raises(InputError, match=words):
        check({**document, "motion": motion, "forces": forces})


@pytest.mark.parametrize(
    "module",
    [assemblies, checker, contact_rule, enclosure, law, leaf_rule, reading, report, robust, tree],
)
def test_the_checker_sees_no_solver_no_numpy_and_no_floats(module):
    tree = ast.parse(inspect.getsource(module))
    imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    imported |= {
        a.name for node in ast.walk(tree) if isinstance(node, ast.Import) for a in node.names
    }
    standard = {"__future__", "math", "re", "typing", "fractions", "itertools", "dataclasses"}
    values = {
        "arrangement.numbers.exact",
        "arrangement.library.files.json_files",
        "equilibrium.model.grasp",
    }
    values |= {"equilibrium.model.contact", "arrangement.console.number_form"}
    values |= {"equilibrium.model.errors", "equilibrium.model.contact", "collections.abc"}
    values |= {f"equilibrium.model.{name}" for name in ("assembly", "displacement", "solution")}
    values |= {"arrangement.numbers.linear.rank", "equilibrium.model.subject"}
    values |= {"assemblies", "enclosure", "law", "leaf_rule", "reading", "report", "robust"}
    values |= {"contact_rule", "parameter", "tree", "uncertain"}
    assert imported <= standard | values
    for node in ast.walk(tree):
        assert not (isinstance(node, ast.Constant) and isinstance(node.value, float))
        assert not (isinstance(node, ast.Name) and node.id == "float")


def test_certificates_hold_and_the_judge_agrees(documents):
    assert [agree(document) for document in documents] == ["accepted"] * len(documents)
    kinds = Counter(
        key
        for document in documents
        for _, node in nodes(document.get("tree"))
        for key in node or ()
    )
    for key in ("orthants", "edge", "at", "attachment", "slip", "multipliers"):
        assert kinds[key] > 15, key


def test_the_report_counts_leaves_and_has_a_json_form(documents):
    for document in documents:
        report, kind = check(document), document["certificate"]
        listed = nodes(document["tree"]) if kind == "not resisted" else ()
        assert report.leaves == sum(_is_leaf(node) for _, node in listed)
        said = {"valid": True, "certificate": kind, "leaves": report.leaves, "compared": False}
        question = {key: document[key] for key in ("wrench", "grasp")}
        assert report.to_dict() == said | question


def _is_leaf(node: Any) -> bool:
    return isinstance(node, list) or "virtual_motion" in node


def test_no_motion_in_a_leaf_balances_the_load(documents):
    """Behind the rows, the law itself: at random motions of a leaf the forces cannot balance."""
    source, tried = Random("motions"), 0
    for document in documents[: len(REFUTED) * len(TREES) : 2]:
        grasp, wrench = judge.statement(document)
        touches = oracle.asked(grasp, wrench).touches
        for leaf, region, states in judge.leaves(document["tree"]):
            virtual = [
                Fraction(x) for x in (leaf if isinstance(leaf, list) else leaf["virtual_motion"])
            ]
            for _ in range(3):
                weights = [source.choice((0, 1, source.randint(1, 50))) for _ in region]
                scale, *motion = (
                    sum(w * g[j] for w, g in zip(weights, region, strict=True)) for j in range(4)
                )
                if not scale:
                    continue
                motion = [x / scale for x in motion]
                if all(_may_be(touches[i], motion, state) for i, state in states.items()):
                    tried += 1
                    assert judge.work_at_motion(grasp, wrench, virtual, motion) > 0
    assert tried > 300


def _may_be(touch: Touch, motion: list[Fraction], state: str) -> bool:
    force, slip = judge.spring_and_slip(touch, [Fraction(1), *motion])
    # At rest friction may point either way, which is what the leaf of "stick" is for.
    slips = {"stick": slip == 0, "slip+": slip > 0, "slip-": slip < 0}
    return force < 0 if state == "detached" else force >= 0 and slips.get(state, True)


@pytest.mark.slow
def test_changes_of_every_kind(documents):
    """Numbers, indices and names; nodes moved, dropped, exchanged and given twice."""
    found = Counter()
    for seed, document in enumerate(documents):
        for path, change, mutant in mutants(document, 15, seed):
            found[agree(mutant, (path, change))] += 1
    assert min(found[kind] for kind in ("accepted", "refused", "malformed")) > 50


def test_no_tree_for_a_resisted_question_is_accepted(documents):
    """The trees of other questions, put under questions that are resisted."""
    tried = 0
    for seed in RESISTED:
        asked = question(seed)
        for document in documents[: len(REFUTED) * len(TREES)]:
            tree = document["tree"]
            report = report_of(
                certificate("not resisted", asked.grasp, asked.wrench, tree=tree).to_dict()
            )
            tried += report is not None
            assert not report
    assert tried > 100


@pytest.mark.slow
def test_the_published_schema_is_as_strict_as_the_checker(documents):
    schema = certificate_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    published = validator(schema)
    assert all(published.is_valid(document) for document in documents[::4])
    found = Counter()
    for seed, document in enumerate(documents[::6]):
        for path, change, mutant in mutants(document, 10, seed):
            try:
                check(mutant)
                readable, seen = True, True
            except InputError as error:
                # JSON Schema takes the float 2.0 for an integer.
                unseen = _BEYOND.search(str(error)) or change == "float"
                readable, seen = False, not unseen
            found[readable] += 1
            if seen:
                assert published.is_valid(mutant) == readable, (path, change)
    assert min(found.values()) > 15


#: Errors that no schema can see: they are about the region, the contact, or the length of a normal.
_BEYOND = re.compile(
    r"orthants cut|is not (attached|undecided) here|there are|not a contact|length is not exactly"
    r"|forces has|integers above 0|coordinates|is in (the plane|space)|wrench has|has \d+ entries"
)


def test_another_question_is_refused(documents):
    for document in (documents[0], documents[-1]):
        grasp, wrench = judge.statement(document)
        assert check(document, question=(grasp, wrench))
        report = check(document)
        assert (report.grasp, report.wrench, report.compared) == (grasp, wrench, False)
        assert len(report.question) == 1 + len(grasp)
        assert report.question[0] == f"wrench {vector_text(wrench)}"
        assert report.question[-1].startswith(f"contact {len(grasp)} ")
        other = grasp, (*wrench[:2], wrench[2] + 1)
        for asked, bounds, words in (
            ((grasp, wrench), (4, None), "it is about other cones of friction"),
            ((grasp, wrench), (None, Fraction(1)), "it is about other displacements"),
            ((grasp, wrench), (4, Fraction(1)), "it is about other cones of friction"),
            (other, (4, Fraction(1)), "it is about another wrench"),
        ):
            assert check(document, asked, *bounds).problem.startswith(words)
        hair = Fraction(1, 10**50)
        softer = [
            replace(c, friction=c.friction + hair) if not i else c for i, c in enumerate(grasp)
        ]
        moved = [replace(c, point=(c.point[0], c.point[1] + 1)) for c in grasp]
        place = vector_text(next(iter(grasp)).point)
        for other, words in (
            ((grasp, (*wrench[:2], wrench[2] + 1)), "another wrench: it is ("),
            ((grasp, (*wrench[:2], wrench[2] + hair)), "(1/1" + 50 * "0" + " apart)"),
            ((Grasp(), wrench), f"{len(grasp)} contacts in 2 dimensions; expected one with 0"),
            ((Grasp(moved), wrench), f"another grasp: point of contact 1 is {place}; exp"),
            (
                (Grasp(softer), wrench),
                f"another grasp: friction of contact 1 is {next(iter(grasp)).friction}",
            ),
        ):
            report = check(document, question=other)
            assert (bool(report), report.compared) == (False, True)
            assert words in report.problem
