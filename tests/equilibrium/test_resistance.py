"""The search for an equilibrium or a proof that there is none: one of the two, always true."""

import json
import re
from collections.abc import Iterator
from fractions import Fraction
from itertools import count, product
from random import Random
from typing import Any

import pytest

from arrangement.errors import OutOfReachError
from arrangement.numbers import budget, deadline
from equilibrium import Contact, Grasp, TimeLimitError, read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import certificate
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contacts import IntegerContacts
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import Leaf, Solution
from equilibrium.plane.search.motion_regions import HALF_SPACE, MotionRegions
from equilibrium.plane.search.region_states import StateSplits, TooManyParts
from equilibrium.plane.search.state_equilibrium import Guess, exact_equilibrium, find_equilibrium
from equilibrium.plane.search.units import SearchUnits
from equilibrium.wrench_sets.line import resisted_magnitudes

from . import oracle
from .degenerate import question

Wrench = tuple[Fraction, ...]
PAPER = read_grasp("paper-three-contacts-preload-1")


def pulled_apart(contacts: int, seed: int) -> Grasp:
    """Return contacts on one side of the object."""
    listed = [c for c in random_grasp(8 * contacts, seed) if c.point[0] > abs(c.point[1])]
    return Grasp(listed[:contacts])


def leaves(tree: Any) -> Iterator[Any]:
    """Yield the leaves of a tree."""
    if isinstance(tree, list) or "virtual_motion" in tree:
        yield tree
        return
    children = tree.get("orthants") or tree.get("children")
    if children is None:
        children = (tree.get("attachment") or tree["slip"]).values()
    for child in children:
        yield from leaves(child)


def assert_true(grasp: Grasp, wrench: Wrench, found: Any) -> bool:
    """Check an answer without the solver; return whether it is an equilibrium."""
    if isinstance(found, Solution):
        assert oracle.satisfies(grasp, wrench, found.motion, found.forces)
        return True
    report = check(
        certificate("not resisted", grasp, wrench, tree=found).to_dict(), (grasp, wrench)
    )
    assert report, report.problem
    return False


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(0, 80, 8))
def test_regions_alone_and_states_alone_give_the_same_answer(seed):
    asked = question(seed)
    contacts, wrench = IntegerContacts(ContactRows.of_grasp(asked.grasp)), tuple(asked.wrench)
    answers = [
        assert_true(asked.grasp, wrench, MotionRegions(contacts, wrench).search()),
        assert_true(asked.grasp, wrench, StateSplits(contacts, wrench, HALF_SPACE, 10**4).decide()),
    ]
    assert answers == [oracle.is_stable(asked.grasp, wrench)] * 2


@pytest.mark.slow
@pytest.mark.parametrize("contacts", [6, 20, 50])
def test_proofs_for_contacts_on_one_side_are_small(contacts):
    counts = []
    for seed in range(4):
        grasp, wrench = pulled_apart(contacts, seed), random_wrench(seed, bound=20)
        verdict = solve(grasp, wrench)
        assert verdict.verify()
        if not verdict.stable:
            counts.append(verdict.verify().leaves)
    assert counts
    assert sorted(counts)[len(counts) // 2] < 120


def test_continuation_finds_nearly_all_equilibria():
    found = 0
    for seed in range(30):
        grasp, wrench = random_grasp(12, seed), random_wrench(seed)
        equilibrium = find_equilibrium(IntegerContacts(ContactRows.of_grasp(grasp)), wrench)
        if equilibrium is not None:
            assert oracle.satisfies(grasp, wrench, equilibrium.motion, equilibrium.forces)
            found += 1
    assert found >= 28


def test_more_contacts_stick_than_the_balance_needs():
    grasp = random_grasp(60, seed=1)
    equilibrium = find_equilibrium(
        IntegerContacts(ContactRows.of_grasp(grasp)), (Fraction(1, 10),) * 3
    )
    assert equilibrium is not None
    assert not any(equilibrium.motion)
    assert oracle.satisfies(grasp, (Fraction(1, 10),) * 3, equilibrium.motion, equilibrium.forces)


@pytest.mark.parametrize("power", [3, 6, 30, 300])
@pytest.mark.parametrize("direction", [(0, 1, 0), (0, -1, 0), (1, 0, 0)])
def test_few_leaves_beyond_the_paper_boundary(power, direction):
    end = resisted_magnitudes(PAPER, direction).intervals[-1][1]
    if end is None:
        assert solve(PAPER, [10**power * x for x in direction]).stable
        return
    assert solve(PAPER, [end * x for x in direction]).stable
    beyond = end + Fraction(1, 10**power)
    verdict = solve(PAPER, [beyond * x for x in direction])
    assert not verdict.stable
    report = verdict.verify()
    assert report
    assert report.leaves <= 12


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 7])
def test_any_distance_beyond_the_boundary_decided(seed):
    near = [c for c in random_grasp(80, seed) if c.point[0] > 0]
    grasp = Grasp([c for c in near if 3 * c.point[0] ** 2 > c.point[1] ** 2][:10])
    end = resisted_magnitudes(grasp, random_wrench(seed + 100)).intervals[-1][1]
    assert end
    for power in (3, 30):
        factor = end * (1 + Fraction(1, 10**power))
        verdict = solve(grasp, [factor * x for x in random_wrench(seed + 100)])
        assert not verdict.stable
        assert verdict.verify()
        assert verdict.verify().leaves < 400
        if power == 3:
            text = json.dumps(verdict.certificate.to_dict()["tree"])
            sizes = sorted(map(len, re.findall(r"\d+", text)))
            assert sizes[len(sizes) * 99 // 100] <= 12


@pytest.mark.parametrize("power", [3, 30, 300])
def test_beyond_the_border_of_two_jaws_no_contact_adds_a_leaf(power):
    heights = [Fraction(2 * k - 49, 49) for k in range(50)]
    rows = [((-side, y), (side, 0)) for side in (1, -1) for y in heights]
    share = Fraction(4, 100)
    grasp = Grasp([Contact(*row, Fraction(1, 2), share, share) for row in rows])
    verdict = solve(grasp, (Fraction(0), 2 + Fraction(1, 10**power), Fraction(0)))
    assert not verdict.stable
    assert verdict.verify().leaves == 8


@pytest.mark.parametrize("kind", ["none", "frictionless", "one point", "coincident", "parallel"])
def test_degenerate_grasps(kind):
    one = Contact([1, 0], [-1, 0], "1/2", 1, 1)
    grasp = {
        "none": Grasp(),
        "frictionless": Grasp([Contact([1, 0], [-1, 0], 0), Contact([-1, 0], [1, 0], 0)]),
        "one point": Grasp([one, Contact([1, 0], ["-3/5", "4/5"], 1)]),
        "coincident": Grasp([one, one, one]),
        "parallel": Grasp([Contact([x, 0], [0, 1], 0, 1, x) for x in range(3)]),
    }[kind]
    for wrench in ((0, 0, 0), (1, 0, 0), (0, -1, 0), (-3, 0, 0), (0, 0, 1), ("1/7", -2, -2)):
        applied = tuple(map(Fraction, wrench))
        verdict = solve(grasp, applied)
        assert verdict.verify()
        assert verdict.stable == oracle.is_stable(grasp, applied)


def test_a_shortened_proof_holds():
    grasp, wrench = pulled_apart(8, 1), (Fraction(5), Fraction(3), Fraction(1))
    plain, short = (solve(grasp, wrench, shorten=shorten) for shorten in (False, True))
    assert plain.verify()
    assert short.verify()
    assert len(short.certificate.text) <= len(plain.certificate.text)


def test_time_limit_ends_search(monkeypatch):
    grasp, wrench = hard()
    monkeypatch.setattr(deadline, "clock", count().__next__)
    with pytest.raises(TimeLimitError, match=r"^undecided: time limit of 0.1 s; give more time"):
        Solver(grasp).solve(wrench, time_limit=0.1)
    assert not solve(grasp, wrench).stable


def test_an_effort_is_over_when_more_than_its_steps_are_taken():
    effort = Effort(1000)
    effort.check(400)
    effort.check(600)
    assert not effort.passed
    assert str(effort) == "no time limit"
    with pytest.raises(TimeoutError, match="limit of 1,000 steps"):
        effort.check()
    assert effort.passed
    with budget.limit(3):
        assert Effort.usual(5).steps == 15


def test_limit_of_work_ends_search(monkeypatch):
    grasp, wrench = hard()
    monkeypatch.setitem(STEPS, 2, 20_000)
    for times in (1, 2):
        words = f"undecided: limit of {20 * times},000 steps; with arrangement.limit({2 * times})"
        with pytest.raises(OutOfReachError, match=re.escape(words)), budget.limit(times):
            solve(grasp, wrench)
    with budget.limit(1000):
        assert not solve(grasp, wrench).stable


def hard() -> tuple[Grasp, Wrench]:
    """Return a question that no single virtual motion answers."""
    for seed in range(100):
        grasp, wrench = pulled_apart(10, seed), random_wrench(seed, bound=20)
        verdict = solve(grasp, wrench)
        if not verdict.stable and verdict.verify().leaves > 8:
            return grasp, wrench
    raise AssertionError("every question has a small answer")


def equilibrium_near(grasp, wrench, guess):
    question = LinearQuestion(ContactRows.of_grasp(grasp), tuple(map(Fraction, wrench)))
    return exact_equilibrium(IntegerContacts(ContactRows.of_grasp(grasp)), question, guess)


@pytest.mark.parametrize("axis", range(3))
def test_what_the_balance_leaves_open_of_a_motion_is_guessed(axis):
    point, normal = [((0, 0), (1, 0)), ((0, 0), (0, 1)), ((1, 0), (0, 1))][axis]
    motion = tuple(32 * (j == axis) for j in range(3))
    grasp = Grasp([Contact(point, normal, 1, 1, 1)])
    found = equilibrium_near(grasp, (0, 0, 0), Guess((False,), (False,), (0,), motion))
    assert found == Solution(tuple(Fraction(x, 16) for x in motion), ((Fraction(0),) * 2,))


def test_what_the_balance_leaves_open_of_a_force_is_none():
    """Contact 1 sticks at the origin; contact 2 slips, and pushes along the plane of contact 1."""
    grasp = Grasp([Contact((0, 0), (0, 1), 1, 1, 1), Contact((1, 0), ("3/5", "4/5"), "4/3", 1, 1)])
    guess = Guess((True, True), (True, False), (0, -(2**14)), (0, 0, 8))
    found = equilibrium_near(grasp, (-1, -1, 0), guess)
    assert found is not None
    assert found.motion == (0, 0, Fraction(1, 2))
    assert found.forces == ((1, 0), (Fraction(3, 5), Fraction(-4, 5)))


def test_a_contact_that_pushes_all_over_a_region_needs_no_state():
    """The spring lifts with 1 or more where y <= 0, and the load takes 1/2 of it."""
    contacts = IntegerContacts(ContactRows.of_grasp(Grasp([Contact((0, 0), (0, 1), 0, 1, 1)])))
    wrench = (Fraction(0), Fraction(-1, 2), Fraction(0))
    region = [(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, -1, 0), (0, 0, 0, 1)]
    leaf = StateSplits(contacts, wrench, region, 1).decide()
    assert isinstance(leaf, Leaf)
    assert not leaf.multipliers
    with pytest.raises(TooManyParts):
        StateSplits(contacts, wrench, region, 0).decide()
    found = StateSplits(contacts, wrench, HALF_SPACE, 10).decide()
    assert isinstance(found, Solution)
    assert found.motion == (0, Fraction(1, 2), 0)


def test_many_contacts_with_huge_numbers_are_refused():
    grasp = random_grasp(90, 0).with_preload(10**300)
    regions = MotionRegions(
        IntegerContacts(ContactRows.of_grasp(grasp)), (Fraction(10**300), Fraction(0), Fraction(0))
    )
    with pytest.raises(OutOfReachError, match="exact programs for 90 contacts"):
        regions.search()


def huge_and_tiny(seed: int) -> tuple[Grasp, Wrench]:
    """Return contacts in one point, with numbers that no float takes in."""
    source = Random(seed)
    normals = [(0, 1), (1, 0), (Fraction(3, 5), Fraction(4, 5)), (-1, 0), (0, -1)]
    normals += [(Fraction(-3, 5), Fraction(4, 5)), (Fraction(-5, 13), Fraction(12, 13))]
    numbers = [0, 1, Fraction(1, 2), 10**80, 10**70, Fraction(1, 10**70)]

    def contact() -> Contact:
        return Contact(
            (0, 1),
            source.choice(normals),
            friction=source.choice(numbers),
            preload=source.choice(numbers),
            stiffness=source.choice(numbers[1:]),
        )

    grasp = Grasp(contact() for _ in range(12))
    return grasp, tuple(Fraction(source.choice([0, 1, -1, 10**70, -(10**70)])) for _ in range(3))


@pytest.mark.parametrize("seed", range(9))
def test_huge_beside_tiny_numbers_are_decided_soon(seed):
    grasp, wrench = huge_and_tiny(seed)
    found = solve(grasp, wrench)
    assert found.verify()


def in_one_point(wrench):
    """Return twelve contacts in one point, every other one with a huge preload, and a load."""
    normals = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    for size, x, y in ((5, 3, 4), (13, 5, 12)):
        turned = product((y, -y), (x, -x))
        normals += [(Fraction(b, size), Fraction(a, size)) for a, b in turned]
    contacts = [
        Contact((0, 0), normal, Fraction(1, 2), 1, 10**70 * (k % 2))
        for k, normal in enumerate(normals)
    ]
    grasp, load = Grasp(contacts), tuple(map(Fraction, wrench))
    units = SearchUnits.of(grasp, load)
    return IntegerContacts(units.rows(grasp)), units.wrench(load)


def test_contacts_that_press_bear_what_floats_leave_open():
    """Those without preload press nothing at rest, though sharp contacts do at first."""
    assert find_equilibrium(*in_one_point((1, 2, 0))).motion == (0, 0, 0)


def test_tiny_load_refuted_without_search():
    assert MotionRegions(*in_one_point((1, 2, 3))).half_space() == Leaf((0, 0, 1), {})
