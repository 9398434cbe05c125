"""Grasps in space: known answers, the planar ones among them, and what proofs of them are worth."""

import itertools
import json
import math
import re
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from itertools import product
from operator import attrgetter
from random import Random
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import linprog

from arrangement.errors import InputError
from arrangement.numbers import budget, deadline
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium import Grasp, Solution, Verdict, read_grasp, solve, unit_normal
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import certificate, resisted_certificate
from equilibrium.core.cones import RoundCones
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.exact_parts import ExactParts
from equilibrium.core.leaves import Leaves, cancelled
from equilibrium.core.relaxation import Relaxation
from equilibrium.core.tree import SpatialSearch
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import random_grasp, random_wrench, read_any
from equilibrium.grasps.schemas import certificate_schema
from equilibrium.model.contact import Contact, pyramid_edges
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.rows import ContactRows
from equilibrium.plane.coplanar import decide_in_plane
from equilibrium.wrench_sets import along_in_space
from equilibrium.wrench_sets.along_in_space import (
    Border,
    KnownLoads,
    KnownMagnitudes,
    _bracket,
    _closer,
    _same,
    blends,
    spatial_magnitudes,
)
from tests.schemas import validator

from . import degenerate, rare, sectors

HAIR = 1 + Fraction(1, 10**6)
FINGERS, FEET = read_grasp("two-opposed-fingers"), read_grasp("box-on-a-table")
PYTHAGORAS = [(1, 0), ("3/5", "4/5"), ("-5/13", "12/13"), ("8/17", "-15/17")]


def verdict(grasp, wrench):
    found = solve(grasp, wrench)
    if found.decided:
        assert found.verify(), found.verify().problem
    return found.verdict


def across(x, y):
    """A force on the opposed fingers across their line, of the size that they just resist."""
    return 0, Fraction(x), Fraction(y), 0, 0, 0


def on_the_table(x, y, up=0):
    """A force at the table on a box of weight 2, of the size that its feet just resist."""
    x, y = Fraction(x), Fraction(y)
    return x, y, -2 + up, y, -x, 0


class TestBorders:
    @pytest.mark.parametrize("direction", PYTHAGORAS)
    def test_opposed_fingers_hold_twice_friction_times_preload(self, direction):
        assert verdict(FINGERS, across(*direction)) == "resisted"
        beyond = [HAIR * x for x in across(*direction)]
        assert verdict(FINGERS, beyond) == "not resisted"

    def test_opposed_fingers_hold_no_torque_about_their_line(self):
        assert verdict(FINGERS, (0, 0, 0, Fraction(1, 10**9), 0, 0)) == "not resisted"
        assert verdict(FINGERS, (0, 0, 0, 0, "1/2", 0)) == "resisted"

    @pytest.mark.parametrize("direction", PYTHAGORAS)
    def test_feet_hold_friction_times_weight(self, direction):
        assert verdict(FEET, on_the_table(*direction)) == "resisted"
        x, y = (HAIR * Fraction(z) for z in direction)
        assert verdict(FEET, on_the_table(x, y)) == "not resisted"

    def test_feet_hold_nothing_upwards(self):
        assert verdict(FEET, on_the_table(0, 0, 2)) == "resisted"
        assert verdict(FEET, on_the_table(0, 0, 2 + Fraction(1, 10**9))) == "not resisted"

    def test_limits_are_brackets_of_two_proofs(self):
        (border,) = spatial_magnitudes(FINGERS, across("3/5", "4/5"), width="1/100").borders
        assert border.resisted == 1 < border.refused <= Fraction(100, 99)


class TestKnownLeaves:
    def searched(self):
        """A search that stays open after few nodes."""
        contacts, load = (
            FloatContacts(ContactRows.of_grasp(random_grasp(8, 18, dimension=3))),
            random_wrench(18, dimension=3, bound=1),
        )
        search = SpatialSearch(contacts, load, lambda _: False, nodes=120)
        search.decide()
        return search

    def test_leaf_closes_its_states_and_their_parts(self):
        search = self.searched()
        assert len(search.leaves.found) > 20
        for states, leaf in search.leaves.found.copy().items():
            assert any(
                search.leaves.holds(states, other)
                for other in search.memory._known.closing(states, search.leaves.floats)
            )
            part = tuple("detached" if x == "undecided" else x for x in states)
            assert search.leaves.holds(part, leaf)

    def test_leaf_uses_no_slip_of_sticking_contact(self):
        search, tried = self.searched(), 0
        for states, leaf in search.leaves.found.copy().items():
            for i, row in leaf.multipliers.items():
                if any(row[1:]):
                    whole = (*states[:i], "attached", *states[i + 1 :])
                    assert not search.leaves.holds(whole, leaf)
                    tried += 1
        assert tried > 20

    def test_numbers_beyond_floats_are_no_fault(self):
        fingers = read_grasp("three-fingers-on-a-ball")
        preloads = [10**320 * k for k in (1, 2, 3)]
        grasp = Grasp(replace(c, preload=q) for c, q in zip(fingers, preloads, strict=True))
        verdict = solve(grasp, random_wrench(1, dimension=3), nodes=10)
        assert verdict.verdict == "undecided" or verdict.verify()


@pytest.mark.parametrize(
    ("columns", "values"),
    [
        ([(1, 0), (0, 1), (1, 1)], [5, 7, 3]),
        ([(-2, 0), (0, 3), (1, 1), (4, -5)], [5, 7, 3, -2]),
        ([(1, 1), (2, 2), (0, 1)], [1, 5, 0]),
    ],
)
def test_changed_multiples_of_columns_cancel(columns, values):
    found, scale = cancelled(columns, values, 2)
    assert scale > 0
    assert all(dot(row, found) == 0 for row in zip(*columns, strict=True))
    assert any(found)


def test_leaves_count_loads_and_preloads_in_the_same_unit():
    contacts = [
        Contact([k, 0, 0], [0, 0, 1], 1, preload=p) for k, p in enumerate(("1/2", "5/3", 0))
    ]
    load = tuple(map(Fraction, (0, "1/7", 0, 0, 2, 0)))
    leaves = Leaves(FloatContacts(ContactRows.of_grasp(Grasp(contacts))), load, RoundCones())
    assert [Fraction(each.preload, leaves.unit) for each in leaves.each] == [
        contact.preload for contact in contacts
    ]
    assert tuple(Fraction(x, leaves.unit) for x in leaves.load) == load


@pytest.mark.parametrize(
    ("nodes", "near", "share", "splits", "stuck"),
    [
        (3, 0.001, 0, 1, False),
        (4, 0.001, 0.5, 2, False),
        (60, 0.001, 0.5, 2, True),
        (60, 0.6, 0.5, 2, False),  # near enough
    ],
)
def test_reach_of_a_load_twice_too_large_is_its_half(nodes, near, share, splits, stuck):
    load = tuple(2 * x for x in across("3/5", "4/5"))
    found = Solver(FINGERS).reach(load, (Fraction(0),) * 6, nodes, near)
    assert abs(found.share - share) < 1e-6
    assert (len(found.tree.splits), found.stuck) == (splits, stuck)


def test_exact_program_of_bounded_displacements_has_a_proof():
    """The preloads of two contacts alone cannot be undone within the bound."""
    contacts = [
        Contact([0, 0, 0], [0, 0, 1], "1/2", preload=1),
        Contact([1, 0, 0], [0, 0, 1], 1, stiffness=2, preload="1/3"),
    ]
    grasp, load, bound = Grasp(contacts), (Fraction(0),) * 6, Fraction(1, 100)
    floats = FloatContacts(ContactRows.of_grasp(grasp))
    leaf = ExactParts(floats, load, Effort(), bound).part(["undecided"] * 2, np.zeros((2, 2)))
    assert leaf.multipliers.keys() == leaf.displacements.keys()
    assert check(certificate("not resisted", grasp, load, None, bound, tree=leaf).to_dict())


@pytest.mark.parametrize(
    ("room", "b", "state", "below"),
    [
        (5, (6, 8), "undecided", True),  # friction 1/2 times 10
        (4, (6, 8), "undecided", False),
        (-5, (6, 8), "undecided", False),
        (0, (0, 0), "undecided", True),
        (-1, (0, 0), "undecided", False),
        (5, (6, 8), ((1, 0), (0, 1)), True),
        (4, (6, 8), ((1, 0), (0, 1)), False),
        (4, (-6, 8), ((1, 0), (0, 1)), True),  # the largest is at an end, and not 10
        (3, (-6, 8), ((1, 0), (0, 1)), False),
        (-3, (-6, -8), ((1, 0), (0, 1)), True),
        (-4, (-6, -8), ((1, 0), (0, 1)), False),
    ],
)
def test_bound_of_friction_is_the_largest_product_in_a_sector(room, b, state, below):
    assert RoundCones().below(room, Fraction(1, 2), b, state) == below


class TestKnownLoads:
    def known(self, grasp, along):
        return KnownMagnitudes(KnownLoads(grasp, 100), tuple(map(Fraction, along)), (0,) * 6)

    def test_tree_refutes_magnitudes_between_its_edges(self):
        known = self.known(FINGERS, across("3/5", "4/5"))
        assert known.verdict(Fraction(2)) == "not resisted"
        low, high = known.refuting(Fraction(2))
        assert (1 <= low < 2, high) == (True, None)
        tree = solve(FINGERS, [2 * x for x in known.along]).certificate.to_dict()
        for t, valid in ((low, False), (low + Fraction(1, 10**9), True), (10**9, True)):
            wrench = [str(t * x) for x in known.along]
            assert bool(check({**tree, "wrench": wrench})) == valid

    def test_between_equilibria_that_blend_there_are_equilibria(self):
        loads = [on_the_table("1/8", 0), on_the_table(0, "1/4"), on_the_table("1/16", "1/8", 1)]
        one, *others = [solve(FEET, load) for load in loads]
        for other in others:
            share, (a, b) = Fraction(1, 3), (one.solution, other.solution)
            assert blends(FEET, a.motion, b.motion)
            middle = [mixed(share, *pair) for pair in zip(a.forces, b.forces, strict=True)]
            load = mixed(share, one.wrench, other.wrench)
            found = Solution(mixed(share, a.motion, b.motion), tuple(middle))
            assert resisted_certificate(FEET, load, found).verify()

    def test_contacts_that_do_something_else_do_not_blend(self):
        rows = [(1, 0, -1), (2, 0, -1), (-1, 0, -1), (0, 1, -1), (0, 0, -1), (0, 1, 1)]
        motions = [(*map(Fraction, v), *[Fraction(0)] * 3) for v in rows]
        slip, further, *others = motions
        assert blends(FEET, slip, further)
        assert not any(blends(FEET, slip, other) for other in others)
        tilted = (*slip[:3], Fraction(3), Fraction(0), Fraction(0))
        assert not blends(FEET, slip, tilted)
        x, y, _ = FEET.contacts[
            0
        ].point  # About which it turns as well: the other feet slip elsewhere.
        turning = (1 + y, -x, *slip[2:5], Fraction(1))
        assert [_same(contact, slip, turning) for contact in FEET] == [True, False, False, False]
        assert not blends(FEET, slip, turning)
        held, asked = {1: slip, 3: further, 2: slip, 4: tilted, 0: slip}, []

        def ask(wrench):
            asked.append(wrench[1])
            motion = held.get(wrench[1])
            solution = motion and SimpleNamespace(motion=motion, box=None)
            return SimpleNamespace(verdict="resisted" if motion else "open", solution=solution)

        loads = SimpleNamespace(grasp=FEET, trees=[], solve=ask, scales=False)
        known = KnownMagnitudes(loads, across(1, 0), (0,) * 6)
        assert {known.verdict(Fraction(t)) for t in (1, 3, 2, 4, 0)} == {"resisted"}
        assert asked == [1, 3, 4, 0]  # What is between 1 and 3 is known.
        halves = [Fraction(k, 2) for k in (1, 3, 5, 7)]
        assert [known.verdict(t) for t in halves] == ["resisted"] * 3 + ["open"]
        assert asked[4:] == [Fraction(7, 2)]

    def test_magnitudes_are_refuted_where_all_works_are_above_0(self):
        known = self.known(FINGERS, (1, 0, 0, 0, 0, 0))
        for works, due in [
            ([(1, -2)], (2, None)),
            ([(1, -2), (1, -1)], (2, None)),
            ([(-2, 6)], (None, 3)),
            ([(Fraction(-1, 2), 1)], (None, 2)),
            ([(1, -2), (-1, 3), (1, -1), (-1, 4), (0, 1)], (2, 3)),
            ([(1, -1), (1, -2), (-1, 4), (-1, 3)], (2, 3)),
            ([(1, -3), (-1, 3)], None),
            ([(1, -4), (-1, 3)], None),
            ([(1, -1), (0, 0)], None),
            ([(0, -1)], None),
            ([(0, 1)], (None, None)),
        ]:
            rows = tuple(((Fraction(slope), *[0] * 5), Fraction(rest)) for slope, rest in works)
            assert known._range(rows) == due
        known.refuted = [(None, 1), (2, 3)]
        found = [known.refuting(t) for t in (0, 1, 2, Fraction(5, 2), 3)]
        assert found == [(None, 1), None, None, (2, 3), None]

    def test_the_range_of_each_new_proof_is_remembered(self):
        works = [(((1,) * 6, -low), ((-1,) * 6, high)) for low, high in ((0, 2), (3, 5))]
        trees = []

        def ask(wrench):
            trees.append(works[len(trees)])
            return SimpleNamespace(verdict="not resisted", solution=None)

        loads = SimpleNamespace(grasp=FINGERS, trees=trees, solve=ask, scales=False)
        known = KnownMagnitudes(loads, (1, *[0] * 5), (0,) * 6)
        assert [known.verdict(t) for t in (1, 4)] == ["not resisted"] * 2
        assert known.refuted == [(0, 2), (3, 5)]

    def test_without_preload_one_verdict_is_that_of_all_multiples(self):
        for base, bounds, asked in [
            ((0,) * 6, {}, {(0, 0, -1, 0, 0, 0)}),
            ((0, 0, -1, 0, 0, 0), {}, {(0, 0, -3, 0, 0, 0), (0, 0, -5, 0, 0, 0)}),
            ((0,) * 6, {"max_displacement": 1}, {(0, 0, -2, 0, 0, 0), (0, 0, -4, 0, 0, 0)}),
        ]:
            loads = KnownLoads(FEET.with_preload(0), 100, **bounds)
            known = KnownMagnitudes(loads, (0, 0, -1, 0, 0, 0), base)
            found = [known.verdict(Fraction(t)) for t in (2, 4)]
            direct = [
                solve(loads.grasp, (0, 0, base[2] - t, 0, 0, 0), **bounds).verdict for t in (2, 4)
            ]
            assert (found, set(loads._verdicts)) == (direct, asked)
        one, *others = FEET.with_preload(0)
        assert not KnownLoads(Grasp([replace(one, preload=1), *others]), 100).scales
        known = KnownMagnitudes(KnownLoads(FEET.with_preload(0), 100), across(1, 0), (0,) * 6)
        assert [known.verdict(Fraction(t)) for t in (1, 0)] == ["not resisted", "resisted"]

    @pytest.mark.parametrize("box", [None, object()])
    def test_between_exact_equilibria_alone_nothing_is_asked(self, box):
        rest, asked = solve(FEET, (0,) * 6).solution, []

        def ask(wrench):
            asked.append(wrench[1])
            return SimpleNamespace(verdict="resisted", solution=replace(rest, box=box))

        loads = SimpleNamespace(grasp=FEET, trees=[], solve=ask, scales=False)
        known = KnownMagnitudes(loads, across(1, 0), (0,) * 6)
        assert [known.verdict(Fraction(t)) for t in (1, 3, 2)] == ["resisted"] * 3
        assert asked == ([1, 3] if box is None else [1, 3, 2])

    def test_contacts_same_on_one_side_of_the_spring(self):
        contact = Contact((0, 0, 0), (0, 0, 1), 1, 1, 1, (1, 0, 0))
        for one, other, same in [
            ((1, 0, 0), (2, 0, 0), True),
            ((1, 0, 0), (-1, 0, 0), False),
            ((1, 2, 0), (-1, -2, 0), False),
            ((0, 1, 0), (0, 2, 0), True),
            ((0, -1, 0), (0, -2, 0), True),
            ((0, 1, 0), (0, -2, 0), False),
            ((0, 0, 0), (1, 0, 0), False),
            ((0, 0, 0), (0, 0, 0), True),
            ((1, 0, 0), (0, 1, 0), False),
            ((1, 1, 0), (1, 0, 0), False),
            ((1, 0, 1), (2, 0, 0), True),
            ((1, 0, 1), (-1, 0, 2), True),
            ((1, 0, 2), (1, 0, 0), False),
        ]:
            both = [(*map(Fraction, motion), 0, 0, 0) for motion in (one, other)]
            assert _same(contact, *both) == _same(contact, *both[::-1]) == same


def answers(low, high, border="not resisted"):
    """Return verdicts that are "resisted" below one magnitude, and not above another."""
    low, high = Fraction(low), Fraction(high)
    return lambda t: "resisted" if t < low else border if t <= high else "not resisted"


def turned(rule):
    """Return the same verdicts with yes and no exchanged."""
    no = {"resisted": "not resisted", "not resisted": "resisted"}
    return lambda t: no.get(rule(t), rule(t))


def bracket_of(rule, low, high, tree):
    """Return the bracket of given verdicts and one tree, and the magnitudes that were asked for."""
    tried, edges = [], [x and Fraction(x) for x in tree]
    known = SimpleNamespace(
        verdict=lambda t: tried.append(t) or rule(t),
        refuting=lambda t: edges if tree and rule(t) == "not resisted" else None,
    )
    return _bracket(known, border_of(rule, low, high), Fraction(1, 1000)), tried


def border_of(rule, low, high):
    """Return the bracket of two magnitudes whose given verdicts differ."""
    ends = Fraction(low), Fraction(high)
    return Border(*ends if rule(ends[0]) == "resisted" else ends[::-1])


@pytest.fixture
def solved(monkeypatch):
    """Return the list of nodes whose programs are solved."""
    states, ask = [], Relaxation.solve
    monkeypatch.setattr(
        Relaxation, "solve", lambda self, node: states.append(node) or ask(self, node)
    )
    return states


class TestManyLoads:
    """A solver follows the trees of earlier loads, and answers as one that knows none."""

    @pytest.mark.parametrize("pyramid", [None, 4])
    def test_answers_are_those_of_each_load_alone(self, pyramid):
        grasp = random_grasp(4, 5, dimension=3)
        first, second = (random_wrench(k, dimension=3, bound=1) for k in (3, 4))
        loads = [mixed(Fraction(k, 3), first, second) for k in range(4)]
        found = list(Solver(grasp, pyramid=pyramid).solve_many(loads))
        assert [v.verdict for v in found] == [
            solve(grasp, load, pyramid=pyramid).verdict for load in loads
        ]
        assert {v.verdict for v in found} == {"resisted", "not resisted"}
        assert all(v.verify() for v in found)

    def test_programs_are_solved_only_where_a_leaf_no_longer_refutes(self, solved):
        grasp, load = random_grasp(4, 5, dimension=3), random_wrench(3, dimension=3, bound=1)
        solver, counts = Solver(grasp), []
        for share in (1, 1 + Fraction(1, 10**6), 0):
            found = solver.solve(tuple(share * x for x in load))
            counts.append((found.verdict, len(solved)))
            solved.clear()
        (one, many), near, (held, _) = counts
        assert (one, near, held) == ("not resisted", (one, 1), "resisted")
        assert many > 20


class TestBrackets:
    """Given verdicts: brackets hold the boundary and query no more than they need."""

    @pytest.mark.parametrize(
        ("rule", "low", "high", "tree", "ends", "asked"),
        [
            (answers("4/3", "4/3"), 1, 2, (), "333/250 4/3", 7),
            (answers("4/3", "4/3"), 1, 2, ("4/3", None), "533/400 891/668", 6),
            (turned(answers("7/5", "7/5")), 1, 2, (None, "7/5"), "753/538 276/197", 7),
            (answers("66/47", "66/47"), 1, 2, ("66/47", 3), "73/52 184/131", 6),
            (turned(answers("75/47", "75/47")), 1, 2, ("1/2", "75/47"), "209/131 91/57", 6),
            (answers("1.4999", "1.4999"), 1, 2, ("1.4999", None), "502/335 3/2", 6),
            (turned(answers("1.5001", "1.5001")), 1, 2, (None, "1.5001"), "3/2 737/491", 7),
            (answers("6/5", "13/10", "undecided"), 1, 2, (), "7/6 17/13 6/5 5/4 9/7", 9),
            (turned(answers("6/5", "5/4", "undecided")), 1, 2, (), "13/11 14/11 6/5 5/4", 9),
            (answers(1, 1, "resisted"), 1, 2, (), "1 1335/1334", 6),
            (answers("63/38", "63/38", "resisted"), "63/38", 2, (), "63/38 73/44", 5),
            (answers(2, 2), 1, 2, (), "999/500 2", 5),
            (answers(0, 0, "resisted"), 0, 1, (), "0 1/1022677257", 34),
        ],
    )
    def test_a_bracket_of_given_verdicts(self, rule, low, high, tree, ends, asked):
        found, tried = bracket_of(rule, low, high, tree)
        assert (rule(found.resisted), rule(found.refused)) == ("resisted", "not resisted")
        two = sorted((found.resisted, found.refused))
        assert " ".join(map(str, (*two, *found.undecided))) == ends
        assert len(tried) == asked

    @pytest.mark.parametrize(
        ("rule", "tree"),
        [
            (answers("1.499625", "3/2", "undecided"), ("1.499625", None)),
            (turned(answers("3/2", "1.500375", "undecided")), (None, "1.500375")),
        ],
    )
    def test_what_a_later_proof_refutes_is_not_left_undecided(self, rule, tree):
        found, tried = bracket_of(rule, 1, 2, tree)
        assert tried[0] == found.refused == Fraction(3, 2)
        assert (rule(found.refused), found.undecided) == ("undecided", ())

    @pytest.mark.parametrize("up", [True, False])
    @pytest.mark.parametrize(
        ("edge", "closes", "stuck", "left", "asked", "opens"),
        [
            ("4/3", True, False, "1/600", 2, False),
            ("1.35", True, False, "1/40", 8, True),
            ("1.35", False, False, "1/20", 9, True),
            (2, True, False, "5/6", 4, True),
            ("1.35", True, True, "1/40", 8, False),
        ],
    )
    def test_ends_move_to_the_edge_of_floats(
        self, edge, closes, stuck, left, asked, opens, up, refused
    ):
        """Of equilibria only up to the boundary 4/3, and of trees where they close."""
        tried, border = [], "4/3"

        def mirrored(t):
            return Fraction(t) if up else 3 - Fraction(t)

        def verdict(t, **how):
            tried.append(how)
            held = answers(border, border)(mirrored(t))
            tree = "nodes" not in how and (closes or "tree" not in how)
            return held if held == "resisted" or tree else "undecided"

        known = SimpleNamespace(
            scales=False,
            verdict=verdict,
            refuting=lambda t: None,
            reach=lambda refused, held, near: (
                float((refused - mirrored(edge)) / (refused - held)),
                7,
                stuck,
            ),
        )
        found = _closer(known, Border(mirrored(1), mirrored(2)), Fraction(1, 1000))
        assert answers(border, border)(mirrored(found.resisted)) == "resisted"
        assert answers(border, border)(mirrored(found.refused)) == "not resisted"
        low, high = found.ends
        assert bool(found.undecided) == opens
        assert all(low < t < high for t in found.undecided)
        assert high - low <= Fraction(left)
        assert len(tried) <= asked

    def test_boundaries_lie_between_sampled_magnitudes(self, monkeypatch):
        """Resisted up to 1/2 and from 3 to 5; of 64 and beyond nothing is found."""
        tried = []
        monkeypatch.setattr(along_in_space, "_closer", lambda known, border, width: border)

        def ask(wrench):
            tried.append(wrench[1])
            held = wrench[1] <= Fraction(1, 2) or 3 <= wrench[1] <= 5
            answer = "undecided" if wrench[1] >= 64 else "resisted" if held else "not resisted"
            loads.trees.extend([()] * (answer == "not resisted"))
            return SimpleNamespace(verdict=answer, solution=None)

        one, other = FINGERS
        soft, hard = replace(one, preload=Fraction(0)), replace(other, preload=Fraction(2))
        for grasp, unit in ((Grasp([soft, hard]), 2), (Grasp([soft]), 1)):
            loads = SimpleNamespace(
                grasp=grasp, trees=[], solve=ask, scales=False, max_displacement=None
            )
            tried.clear()
            found = spatial_magnitudes(grasp, across(1, 0), loads=loads)
            powers = [unit * Fraction(2) ** k for k in range(-6, 9)]
            assert [t for t, _ in found.samples] == [0, *powers]
            order = [0, 15, 7, 3, 11, 1, 5, 9, 13, 2, 4, 6, 8, 10, 12, 14]
            assert tried[:16] == [found.samples[k][0] for k in order]
            assert found.verdict == "resisted"
        rows = [(b.resisted, b.refused) for b in found.borders]
        due = "1/2 703127/1406253|3 1000001/333334|5 1463416/292683"
        assert "|".join(f"{x} {y}" for x, y in rows) == due
        assert found.gaps == (found.borders[:2],)
        less = spatial_magnitudes(grasp, across(1, 0), width="1/100", loads=loads, every=5)
        assert [t for t, _ in less.samples] == [0, Fraction(1, 64), Fraction(1, 2), 16]
        for last in ("undecided", "not resisted"):
            samples = ((Fraction(0), "not resisted"), (Fraction(1), last))
            assert replace(found, samples=samples).verdict == last
        with pytest.raises(GraspError, match="direction is zero"):
            spatial_magnitudes(grasp, [0] * 6)
        for width in (0, -1, Fraction(1, 2**101)):
            with pytest.raises(GraspError, match=r"width is .*; it must be at least 2\^-100"):
                spatial_magnitudes(grasp, across(1, 0), width=width)
        written = found.to_dict()
        assert (written["direction"][1], written["base"]) == ("1", ["0"] * 6)
        assert written["borders"][1] == {
            "resisted": "3",
            "not_resisted": "1000001/333334",
            "undecided": [],
            "exact": False,
        }
        assert written["samples"][1] == {"t": "1/64", "verdict": "resisted"}


def mixed(share, one, other):
    return tuple(share * x + (1 - share) * y for x, y in zip(one, other, strict=True))


def decided(kind, seeds):
    """Return how many questions of a kind have a proof that the checker accepts."""
    found = [solve(*rare.question(kind, seed)) for seed in seeds]
    assert all(answer.verify() for answer in found if answer.decided)
    return sum(answer.decided for answer in found)


@pytest.mark.parametrize("kind", rare.KINDS)
def test_questions_that_are_not_in_general_position_are_decided(kind):
    assert decided(kind, range(3)) == 3


@pytest.mark.parametrize(
    ("kind", "seed"),
    [
        *(("no friction", seed) for seed in (1, 2, 14)),
        *(("some friction", seed) for seed in (5, 8, 13, 24, 39)),
        *(("line", seed) for seed in (17, 30)),
        *(("box", seed) for seed in (9, 15, 20)),
        *(("common point", seed) for seed in (1, 25, 35)),
        ("huge friction", 9),
        # Floats miss the forces; decimals do not.
        *(("huge friction", seed) for seed in (41, 51, 97)),
        # What presses by 10^-12 of the load and slips by as little seems to stick.
        *(("huge friction", seed) for seed in (112, 140, 145, 191, 197)),
        *(("unequal stiffness", seed) for seed in (22, 94)),
    ],
)
def test_what_floats_leave_open_is_decided(kind, seed):
    assert decided(kind, [seed]) == 1


#: Contacts, seed and load close to the limit: motions are far, or directions of slip known to 1e-3.
NEAR_LIMITS = [
    (5, 31, "-213/512 759/512 281/1024 -39/1024 -417/512 135/1024"),
    (6, 17, "-2027/8192 -13717/32768 1831/2048 7697/16384 -6655/8192 14181/32768"),
    (5, 36, "-1643/16384 -3175/4096 14137/8192 19855/16384 30949/16384 -11195/16384"),
    (6, 22, "12727/8192 1699/4096 -14049/8192 -1437/4096 829/8192 -2541/8192"),
    (7, 178, "43/64 17/32 -41/32 19/64 15/8 -75/64"),
]


@pytest.mark.parametrize(
    ("contacts", "seed", "load"),
    [pytest.param(*x, marks=[pytest.mark.slow] * (i > 0)) for i, x in enumerate(NEAR_LIMITS)],
)
def test_loads_just_beyond_the_limit_are_decided(contacts, seed, load):
    assert verdict(random_grasp(contacts, seed, dimension=3), load.split()) == "not resisted"


@pytest.mark.parametrize("load", [(2, 1), pytest.param((4, -1), marks=pytest.mark.slow)])
def test_a_load_on_the_border_is_given_up_early(load, solved):
    """All friction goes along z only of infinite slips; less of the load has an equilibrium."""
    place, size = load
    grasp = read_any("paper-three-contacts-in-space").grasp
    border = [Fraction(0)] * 6
    border[place] = Fraction(size)
    near = [1 - Fraction(1, 10**6), 1 + Fraction(1, 10**6)]
    found = [solve(grasp, [share * x for x in border]).verdict for share in near]
    assert found == ["resisted", "not resisted"]
    solved.clear()
    assert solve(grasp, border).verdict == "undecided"
    # Without end, pairs of sectors of slips would come to thousands.
    assert len(solved) < 400


#: Of fifteen, those left open.
OPEN = {"box": 1}


@pytest.mark.slow
@pytest.mark.parametrize("kind", rare.KINDS)
def test_most_degenerate_problems_decided(kind):
    assert decided(kind, range(3, 18)) >= 15 - OPEN.get(kind, 0)


def test_frictionless_load_resisted_by_normals_alone():
    for seed in range(40, 60):
        grasp, wrench = rare.question("no friction", seed)
        rows = [(*(c.normal_wrench[j] for c in grasp), w) for j, w in enumerate(wrench)]
        m = len(grasp)
        signs = [[int(i == j) for j in range(m + 1)] for i in range(m)]
        balanced = not isinstance(feasible_point(m, signs, rows), Infeasible)
        assert solve(grasp, wrench).stable == balanced, seed


class TestPlanes:
    @pytest.mark.parametrize(
        "seed",
        [
            *(1, 3, 6, 7, 8, 9, 17, 19, 20, 32, 36),
            *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(1000, 1040, 5)),
        ],
    )
    def test_in_any_plane_of_space_they_answer_as_in_the_plane(self, seed):
        flat = degenerate.question(seed)
        found = solve(*rare.question("plane", seed))
        assert found.stable == Solver(flat.grasp).solve(flat.wrench).stable
        assert found.verify()

    def proof(self):
        grasp, wrench = in_a_plane()
        tree = decide_in_plane(grasp, wrench, Effort())
        return certificate("not resisted", grasp, wrench, tree=tree).to_dict()

    def test_one_contact_holds_a_push_along_its_normal(self):
        table = Grasp([Contact([0, 0, 0], [0, 0, 1], 1)])
        for push, held in ((-1, True), (1, False)):
            found = decide_in_plane(table, (0, 0, Fraction(push), 0, 0, 0), Effort())
            assert isinstance(found, Solution) == held

    def test_planar_proof_accepted_with_its_planes(self):
        proof = self.proof()
        assert check(proof)
        assert validator(certificate_schema()).is_valid(proof)

    @pytest.mark.parametrize(
        ("change", "words"),
        [
            (lambda d: d["tree"]["plane"].reverse(), "not above 0|must be"),
            (lambda d: d["tree"]["plane"][0].__setitem__(0, "2"), "length 1"),
            (lambda d: d["wrench"].__setitem__(2, "1"), "load does not lie"),
            (lambda d: d["wrench"].__setitem__(3, "1"), "load does not lie"),
            (lambda d: d["wrench"].__setitem__(4, "1"), "load does not lie"),
            (lambda d: d["grasp"]["contacts"][0]["point"].__setitem__(2, "1"), "contacts do not"),
            (lambda d: d["grasp"]["contacts"][0].update(normal=["0", "0", "1"]), "contacts do not"),
        ],
    )
    def test_a_proof_of_another_plane_is_refused(self, change, words):
        proof = self.proof()
        change(proof)
        report = check(proof)
        assert not report
        assert re.search(words, report.problem)

    def test_a_planar_proof_is_none_for_pyramids(self):
        with pytest.raises(InputError, match="round cones"):
            check({**self.proof(), "pyramid": 4})

    def test_contacts_out_of_the_plane_are_left_to_the_tree(self):
        grasp, wrench = in_a_plane()
        above = Contact((0, 0, 1), (1, 0, 0), 1)
        assert decide_in_plane(Grasp([*grasp, above]), wrench, Effort()) is None


def in_a_plane():
    """Return three contacts in the plane z = 0, and a load that they just do not hold."""
    grasp = read_grasp("paper-three-contacts-preload-1").in_space()
    return grasp, tuple(map(Fraction, (0, 1 + Fraction(1, 10**30), 0, 0, 0, 0)))


def leaf_at(node, contacts, motion):
    """Return the virtual motion of a leaf whose states a motion obeys."""
    while isinstance(node, dict) and "contact" in node:
        i = node["contact"]
        normal, spring, slip = contacts[i](motion)
        if "attachment" in node:
            node = node["attachment"]["attached" if spring > 0 else "detached"]
        else:
            ends, children = node["directions"], node["children"]
            if len(children) == len(ends) + 1 and len(ends) > 1:
                pairs = list(zip(ends, ends[1:] + ends[:1], strict=True))
                inside = [k for k, pair in enumerate(pairs) if within(pair, slip)]
                node = children[1 + inside[0]]
            else:
                (end,) = ends
                node = children[0 if end[0] * slip[1] - end[1] * slip[0] <= 0 else 1]
        del normal
    return node if isinstance(node, list) else node["virtual_motion"]


def within(pair, slip):
    (a, b), (c, d) = ([float(Fraction(x)) for x in end] for end in pair)
    x, y = slip
    return a * y - b * x >= 0 and x * d - y * c >= 0


def at(contact):
    """Return a function of the motion: normal wrench, spring force, slip."""
    normal = [float(x) for x in contact.normal_wrench]
    tangents = [[float(x) for x in row] for row in contact.tangential_wrenches]
    stiffness, preload = float(contact.stiffness), float(contact.preload)

    def measured(motion):
        along = sum(x * y for x, y in zip(normal, motion, strict=True))
        slip = [sum(x * y for x, y in zip(row, motion, strict=True)) for row in tangents]
        return normal, preload - stiffness * along, slip

    return measured


def floats_of_directions(node):
    if isinstance(node, dict):
        return {
            key: [[float(Fraction(x)) for x in end] for end in value]
            if key == "directions"
            else floats_of_directions(value)
            for key, value in node.items()
        }
    return [floats_of_directions(x) for x in node] if isinstance(node, list) else node


@pytest.mark.parametrize(("contacts", "seed"), [(3, 16), (3, 20), (4, 18), (4, 0)])
def test_leaf_of_any_motion_refutes_balance(contacts, seed):
    grasp = random_grasp(contacts, seed, dimension=3)
    wrench = random_wrench(seed, dimension=3, bound=1)
    found = solve(grasp, wrench)
    assert found.verdict == "not resisted"
    tree = floats_of_directions(found.certificate.to_dict()["tree"])
    places, source = [at(contact) for contact in grasp], Random(seed)
    for _ in range(200):
        motion = [source.gauss(0, 1) * 10 ** source.uniform(-2, 2) for _ in range(6)]
        total = [float(w) for w in wrench]
        for contact, place in zip(grasp, places, strict=True):
            normal, spring, slip = place(motion)
            force = max(0.0, spring)
            size = math.hypot(*slip)
            rows = [normal, *([float(x) for x in row] for row in contact.tangential_wrenches)]
            factors = [force, *(-float(contact.friction) * force * s / size for s in slip)]
            for factor, row in zip(factors, rows, strict=True):
                total = [t + factor * x for t, x in zip(total, row, strict=True)]
        virtual = [float(Fraction(x)) for x in leaf_at(tree, places, motion)]
        assert sum(x * y for x, y in zip(virtual, total, strict=True)) > 0


class TestChecker:
    tree = solve(FINGERS, [HAIR * x for x in across(1, 0)]).certificate.to_dict()
    # Its equilibrium has no rational numbers.
    grasp = random_grasp(6, 2, dimension=3)
    box = solve(grasp, random_wrench(2, dimension=3, bound=1)).certificate.to_dict()

    def test_a_leaf_of_a_wider_cone_is_refused_with_its_path(self):
        grasp = self.tree["grasp"]
        contacts = [{**c, "friction": "51/100"} for c in grasp["contacts"]]
        report = check({**self.tree, "grasp": {**grasp, "contacts": contacts}})
        assert not report
        assert report.problem.startswith("tree.attachment")

    @pytest.mark.parametrize(
        ("node", "words"),
        [
            ({"contact": 0, "directions": [[1, 0], [0, 1]], "children": [[]] * 3}, "not attached"),
            ({"orthants": [[0] * 6] * 8}, "one of the keys virtual_motion, attachment, directions"),
            ([0, 0, 0], "tree has 3 entries"),
            (3, "tree is 3; expected a list"),
        ],
    )
    def test_what_is_no_tree_in_space_is_one_clear_error(self, node, words):
        with pytest.raises(InputError, match=words):
            check({**self.tree, "tree": node})

    def test_an_enclosure_holds_and_its_variations_do_not(self):
        assert check(self.box)
        given = self.box["enclosure"]
        slips = given["friction"].index("slip")
        changes = [
            {"radius": ["0"] * 6},
            {"radius": ["1e-60"] * 6},
            {"radius": ["1"] * 6},
            {"centre": [str(2 * Fraction(x)) for x in given["centre"]]},
            {"inverse": [["0"] * 6] * 6},
            {"friction": ["detached"] * len(given["friction"])},
            {
                "friction": [
                    ["1", "1"] if i == slips else x for i, x in enumerate(given["friction"])
                ]
            },
        ]
        for change in changes:
            report = check({**self.box, "enclosure": {**given, **change}})
            assert not report, change
        with pytest.raises(InputError, match="enclosure"):
            check({**self.tree, "certificate": "resisted", "enclosure": given})
        with pytest.raises(InputError, match=r"a pyramid .* needs no enclosure"):
            check({**self.box, "pyramid": 4})

    def test_two_contacts_enclosed_up_to_rotation(self):
        grasp = random_grasp(2, 1, dimension=3)
        found = solve(grasp, balanced(Random(1), grasp))
        document = found.certificate.to_dict()
        given, third = document["enclosure"], random_grasp(3, 1, dimension=3).to_dict()
        (turn,) = given["idle"]
        assert check(document)
        felt = {
            **document["grasp"],
            "contacts": [*document["grasp"]["contacts"], *third["contacts"]],
        }
        changes = [
            {"enclosure": {**given, "idle": []}},
            {"enclosure": {**given, "idle": [["1", *turn[1:]]]}},
            {"enclosure": {**given, "idle": [[*turn[:6], "1000"]]}},
            {
                "wrench": [
                    str(Fraction(x) + Fraction(y))
                    for x, y in zip(document["wrench"], turn[:6], strict=True)
                ]
            },
            {
                "grasp": felt,
                "enclosure": {**given, "friction": [*given["friction"], *["slip"] * 3]},
            },
        ]
        for change in changes:
            assert not check({**document, **change}), change


class TestAnswers:
    def test_an_undecided_verdict_is_neither_yes_nor_no(self):
        found = solve(read_grasp("peg-in-a-hole"), (0, 0, "-3/2", 0, 0, 0), nodes=1)
        assert (found.verdict, found.certificate) == ("undecided", None)
        names = ("stable", "equilibria", "proof")
        for question in (bool, Verdict.verify, *map(attrgetter, names)):
            with pytest.raises(UndecidedError, match="after 1 nodes"):
                question(found)
        assert found.to_dict()["verdict"] == "undecided"

    def test_exit_codes_and_words(self, run, monkeypatch):
        options = ["solve", "peg-in-a-hole", "--wrench", "0", "0", "-3/2", "0", "0", "0"]
        with monkeypatch.context() as patch:
            patch.setattr(deadline, "clock", itertools.count().__next__)
            document = run.json(*options, "--time-limit", "1/10", code=3)
            assert document["verdict"] == "undecided"
            assert document["reason"].startswith("time limit of 0.1 s")
            assert run(*options, "--time-limit", "1/10", code=3).startswith(
                "undecided: time limit of 0.1 s"
            )
        with monkeypatch.context() as patch:
            patch.setitem(STEPS, 3, 100_000)
            assert run(*options, code=3).startswith("undecided: limit of 100,000 steps")
        with monkeypatch.context() as patch:
            patch.setattr(budget, "COMMAND_STEPS", 30_000)
            assert run(*options, code=3).startswith("undecided: limit of 60,000 steps")
        run(*options, code=1)
        assert "resisted" in run("solve two-opposed-fingers --weight 1")
        run("solve two-opposed-fingers --weight 2", code=1)

    @pytest.mark.parametrize("length", [0, 3, 5, 7])
    def test_a_wrench_of_the_wrong_length_names_the_right_one(self, length):
        with pytest.raises(GraspError, match="takes 6: f_x, f_y, f_z, tau_x, tau_y and tau_z"):
            solve(FINGERS, [0] * length)


class TestModel:
    def test_dimensions_are_not_mixed(self):
        plane = Contact((0, 0), (1, 0), 1)
        with pytest.raises(GraspError, match=r"contacts\[2\] is in the plane"):
            Grasp([*FINGERS, plane])
        with pytest.raises(GraspError, match="point has 3 coordinates and normal has 2"):
            Contact((0, 0, 0), (1, 0), 1)

    def test_normals_are_exact_or_rounded_with_the_error_reported(self):
        with pytest.raises(GraspError, match="unit_normal"):
            Contact((0, 0, 0), (1, 1, 1), 1)
        contact = {"point": [0, 0, 0], "normal": [1, 1, 1], "friction": 1}
        found = read_any({"schema_version": 1, "contacts": [contact]}, round_normals=True)
        assert 0 < found.angle_errors[0] <= Fraction(1, 10**6)

    @pytest.mark.parametrize("seed", range(40))
    def test_unit_normals_are_unit_and_near(self, seed):
        source = Random(seed)
        wanted = [source.randint(-9, 9) / 7 for _ in range(3)] if seed else [2, -3, 6]
        found, error = unit_normal(wanted, Fraction(1, 10**5))
        assert sum(x * x for x in found) == 1
        exact = [Fraction(x) for x in wanted]
        cosine, square = dot(found, exact), dot(exact, exact)
        assert cosine > 0
        assert square - cosine**2 <= (error * cosine) ** 2
        assert error <= Fraction(1, 10**5)
        if not seed:
            assert (found, error) == ((Fraction(2, 7), Fraction(-3, 7), Fraction(6, 7)), 0)

    def test_unit_normal_within_a_tiny_tolerance(self):
        found, error = unit_normal([1, 1, 1], Fraction(1, 10**30))
        assert dot(found, found) == 1
        assert 0 < error <= Fraction(1, 10**30)

    @pytest.mark.parametrize("normal", [(0, 0, 1), (0, 0, -1), (1, 0, 0), ("3/5", 0, "-4/5")])
    def test_tangents_and_normal_are_a_right_handed_frame(self, normal):
        contact = Contact((0, 0, 0), normal, 1)
        (a, b, c), (x, y, z) = contact.tangents
        assert (b * z - c * y, c * x - a * z, a * y - b * x) == contact.normal
        assert contact == Contact((0, 0, 0), normal, 1, tangent=contact.tangent)


def states_of_pyramid(contact, edges):
    """Yield for each state its rows (motion, force, constant): equalities, then inequalities."""
    normal = contact.normal_wrench
    one, other = contact.tangential_wrenches
    k, q, mu = (float(x) for x in (contact.stiffness, contact.preload, contact.friction))
    gap = np.array([k * float(x) for x in normal])
    along = np.array([[float(x) for x in row] for row in (one, other)])
    none = np.zeros(6)
    sides = [np.add(edge, edges[(j + 1) % len(edges)]) for j, edge in enumerate(edges)]
    spring = (gap, (1, 0, 0), -q)
    cone = [(none, (mu * side @ edge, *-side), 0) for side, edge in zip(sides, edges, strict=True)]
    attached = [*cone, (none, (1, 0, 0), 0)]
    yield [(none, row, 0) for row in np.eye(3)], [(gap, (0, 0, 0), -q)]
    yield [spring, *((row, (0, 0, 0), 0) for row in along)], attached
    for j, side in enumerate(sides):
        across = np.array([-side[1], side[0]])
        face = (none, (mu * side @ edges[j], *side), 0)
        yield (
            [spring, (across @ along, (0, 0, 0), 0), face],
            [*attached, (side @ along, (0, 0, 0), 0)],
        )
        before, edge = sides[j - 1], edges[j]
        turned = [np.array([-before[1], before[0]]), np.array([side[1], -side[0]])]
        corner = [(none, (mu * edge[i], *np.eye(2)[i]), 0) for i in range(2)]
        yield [spring, *corner], [*attached, *((t @ along, (0, 0, 0), 0) for t in turned)]


def resisted_by_all_states(grasp, wrench, edges):
    """Decide by a linear program for each choice of states, in floats."""
    m, size = len(grasp), 6 + 3 * len(grasp)
    balance = np.zeros((6, size))
    for i, contact in enumerate(grasp):
        for j, row in enumerate((contact.normal_wrench, *contact.tangential_wrenches)):
            balance[:, 6 + 3 * i + j] = [float(x) for x in row]
    load = [-float(w) for w in wrench]
    for choice in product(*(list(states_of_pyramid(contact, edges)) for contact in grasp)):
        rows = [[], []]
        for i, parts in enumerate(choice):
            for kind, part in zip(rows, parts, strict=True):
                for motion, force, constant in part:
                    row = np.zeros(size + 1)
                    row[:6], row[6 + 3 * i : 9 + 3 * i], row[-1] = motion, force, constant
                    kind.append(row)
        equal, least = map(np.array, rows)
        found = linprog(
            np.zeros(size),
            A_ub=-least[:, :-1],
            b_ub=least[:, -1],
            A_eq=np.concatenate([balance, equal[:, :-1]]),
            b_eq=np.concatenate([load, -equal[:, -1]]),
            bounds=(None, None),
        )
        if found.status == 0:
            return True
    return bool(m == 0 and not any(wrench))


def loaded(source, grasp):
    """Return a load that forces of about the right size balance, off by a little or by a lot."""
    wrench = tuple(Fraction(source.randint(-8, 8), source.choice((8, 200))) for _ in range(6))
    for contact in grasp:
        normal = Fraction(source.randint(0, 32), 16)
        limit = int(32 * contact.friction * normal)
        friction = [Fraction(source.randint(-limit, limit), 45) for _ in range(2)]
        wrench = degenerate.less(wrench, contact, normal, *friction)
    return tuple(Fraction(round(64 * w), 64) if len(grasp) > 2 else w for w in wrench)


def balanced(source, grasp):
    """Return a load that forces inside the cones balance; with preload not far from it."""
    wrench = (Fraction(0),) * 6
    for contact in grasp:
        size = contact.preload or Fraction(source.randint(0, 4), 2)
        normal = size * Fraction(source.randint(8, 20), 16)
        share = [Fraction(source.randint(-9, 9), 11) for _ in range(2)]
        friction = (x * contact.friction * normal for x in share)
        wrench = degenerate.less(wrench, contact, normal, *friction)
    return wrench


def agrees_with_sectors(contacts, seeds, load):
    """Compare verdicts with those of brute force over sectors; return the three numbers."""
    found = Counter()
    for seed in seeds:
        grasp = random_grasp(contacts, seed, dimension=3)
        wrench = load(Random(seed), grasp)
        answer = solve(grasp, wrench)
        found[answer.verdict] += 1
        if answer.decided:
            assert answer.verify(), seed
            assert answer.stable == sectors.resisted(grasp, wrench), seed
    return found


FEW_SECTORS = [(2, range(6), balanced), (3, range(2), loaded)]
MANY_SECTORS = [
    *((2, range(100, 120), balanced), (2, range(230, 235), loaded)),
    *((3, range(100, 103), balanced), (3, range(124, 127), loaded)),
]


@pytest.mark.parametrize(
    ("asked", "least", "undecided"),
    [(FEW_SECTORS, 1, 0), pytest.param(MANY_SECTORS, 3, 2, marks=pytest.mark.slow)],
    ids=["few", "many"],
)
def test_verdicts_on_round_cones_are_those_of_narrow_sectors(asked, least, undecided):
    found = sum((agrees_with_sectors(*one) for one in asked), Counter())
    assert min(found["resisted"], found["not resisted"]) >= least
    assert found["undecided"] <= undecided


def agrees_with_all_states(contacts, seeds):
    """Compare pyramids with four edges with all their states; return how many are resisted."""
    edges = np.array([[float(x) for x in edge] for edge in pyramid_edges(4)])
    resisted = 0
    for seed in seeds:
        grasp = random_grasp(contacts, seed, dimension=3)
        wrench = loaded(Random(seed), grasp)
        found = solve(grasp, wrench, pyramid=4)
        assert found.verify(), found.verify().problem
        assert found.stable == resisted_by_all_states(grasp, wrench, edges), seed
        resisted += found.stable
    return resisted


MANY = [(2, range(100, 108)), (3, range(2))]


@pytest.mark.parametrize(
    ("m", "seeds"),
    [(2, range(4)), *(pytest.param(*row, marks=pytest.mark.slow) for row in MANY)],
)
def test_verdicts_on_pyramids_are_those_of_all_states(m, seeds):
    # No load of these on two contacts is resisted.
    assert (agrees_with_all_states(m, seeds) > 0) == (m == 3)


class TestPyramids:
    @pytest.mark.parametrize("slanted", [False, True])
    def test_six_contacts_on_a_ball_that_hold_a_load_are_decided(self, slanted):
        normals = [tuple(s * int(j == k) for j in range(3)) for k in range(3) for s in (1, -1)]
        if slanted:
            thirds = [(1, 2, 2), (2, -2, 1), (-2, -1, 2)]
            normals = [(Fraction(3, 5), Fraction(4, 5), 0), (Fraction(-4, 5), Fraction(3, 5), 0)]
            normals += [tuple(Fraction(x, 3) for x in n) for n in thirds]
            normals.append((Fraction(2, 7), Fraction(3, 7), Fraction(-6, 7)))
        ball = Grasp(Contact([-x for x in n], n, "1/2", 1, 1) for n in normals)
        loads = [(0, 0, -1, 0, 0, 0), ("1/2", "1/3", 1, 0, "1/5", 0), (1, 2, 3, "1/2", -1, 1)]
        for load in loads:
            for edges in (4, 6, 8):
                found = solve(ball, load, pyramid=edges)
                assert found.stable
                assert found.verify()

    def test_pyramid_equals_round_cone_along_edges_only(self):
        for size, held in ((1, True), (HAIR, False)):
            along = solve(FINGERS, [size * x for x in across(1, 0)], pyramid=4)
            between = [size * x / Fraction(7, 5) for x in across("3/5", "4/5")]
            assert (along.stable, solve(FINGERS, between, pyramid=4).stable) == (held,) * 2
            assert along.verify()

    def test_edges_on_circle_in_order(self):
        for count in (4, 6, 8, 30, 64):
            edges = pyramid_edges(count)
            assert all(x * x + y * y == 1 for x, y in edges)
            turns = zip(edges, (*edges[1:], edges[0]), strict=True)
            assert all(a * d - b * c > 0 for (a, b), (c, d) in turns)
            assert [(-x, -y) for x, y in edges[: count // 2]] == list(edges[count // 2 :])
        for count in (5, 2, 66, 4.0):
            with pytest.raises(GraspError, match="even number from 4"):
                pyramid_edges(count)

    def test_the_command_takes_a_pyramid(self, run):
        options = ["solve", "two-opposed-fingers", "--wrench", "0", "3/5", "4/5", "0", "0", "0"]
        run(*options)
        printed = run(*options, "--cone", "pyramid:4", code=1)
        assert "not resisted, with friction pyramids of 4 edges" in printed

    def test_a_proof_for_a_pyramid_is_none_for_the_round_cone(self):
        found = solve(FINGERS, across("3/5", "4/5"), pyramid=4)
        document = found.certificate.to_dict()
        assert check(document)
        assert found.verify()
        question = found.grasp, found.wrench
        assert not check(document, question)
        assert check(document, question, pyramid=4)
        assert not check(document, question, pyramid=6)
        del document["pyramid"]
        assert not check(document, question, pyramid=4)
        assert not check(document)


@pytest.mark.parametrize(("cone", "seconds"), [("round", "1/10"), ("pyramid:8", "9")])
def test_time_limit_holds_inside_long_programs(cone, seconds, tmp_path, run, monkeypatch):
    contacts = [c for c in random_grasp(200, 1, dimension=3) if c.point[2] > 0]
    path = tmp_path / "many.json"
    path.write_text(json.dumps(Grasp(contacts).to_dict()))
    load = ["--wrench", "1", "0", "-1", "0", "0", "1", "--time-limit", seconds, "--cone", cone]
    # Each look at the clock takes a second: with pyramids the tenth is inside a program.
    monkeypatch.setattr(deadline, "clock", itertools.count().__next__)
    assert ": time limit of " in run("solve", path, *load, code=3)
