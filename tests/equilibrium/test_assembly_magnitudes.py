"""Magnitudes and margins of assemblies: textbook values, planar grasps, brute force, commands."""

import random
import re
from fractions import Fraction

import pytest

from arrangement import limit
from arrangement.numbers.budget import meter_steps
from equilibrium import (
    Assembly,
    BodyContact,
    Contact,
    EquilibriumError,
    GraspError,
    ResistedSet,
    solve,
)
from equilibrium.core import contact_law
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.decide.assemblies import magnitudes
from equilibrium.grasps.inputs import random_grasp
from equilibrium.grasps.textbook import TEXTBOOK, stack, wedge
from equilibrium.model.errors import UndecidedError
from proofs_check.instances.grasps import textbook_questions
from proofs_check.routes.bodies import resisted

from .random_assemblies import random_question

NEAR = Fraction(1, 10**9)


def known(name, k=0):
    question = next(q for q in textbook_questions() if q.case == f"{name}-{k}")
    return Assembly.from_dict(question.document), question.wrench


class TestTextbook:
    @pytest.mark.parametrize(
        ("push", "end"),
        [
            ({"upper": [1, 0, "-3/2"]}, "1/4"),
            ({"lower": [1, 0, "-1/2"]}, "3/2"),
            ({"upper": [1, 0, "-3/2"], "lower": [1, 0, "-1/2"]}, "1/4"),
            ({"upper": [0, -1, 0]}, None),
        ],
    )
    def test_pushed_block_slides_at_its_friction(self, push, end):
        assembly, weights = known("two-blocks-on-a-table")
        found = ResistedSet(assembly).along(push, weights)
        assert found.intervals == ((0, None if end is None else Fraction(end)),)

    def test_clamped_block_slides_at_its_preload(self):
        jaws = [Contact([x, 0], [-x, 0], "1/2", preload=1) for x in (-1, 1)]
        clamped = Assembly(["block"], [BodyContact("block", None, jaw) for jaw in jaws])
        assert ResistedSet(clamped).along({"block": [0, -1, 0]}).intervals == ((0, 1),)

    def test_books_need_a_preload(self):
        assembly, weights = known("books-between-walls")
        margin = ResistedSet(assembly).margin(weights)
        assert not margin
        assert margin.intervals == ((0, 0),)
        assert margin.preloads.intervals == ((1, None),)
        assert margin.preloads.contacts == tuple(range(1, len(assembly) + 1))

    def test_arch_needs_friction(self):
        assembly, weights = known("arch-of-5")
        friction = ResistedSet(assembly).margin(weights).friction("1/100")
        assert friction.low < 0.30523 < friction.low + Fraction(1, 50)
        assert friction.low <= friction.high <= friction.low + Fraction(1, 100)

    def test_wedge_locks_at_the_sum_of_the_friction_angles(self):
        friction = ResistedSet(wedge()[0]).margin(wedge()[1]).friction("1/64")
        assert friction.high == Fraction(1, 3)

    def test_pushed_tower_is_decided_block_by_block(self):
        assembly, weights = stack(blocks=30)
        found = ResistedSet(assembly).along({"block 30": [1, 0, "-59/2"]}, weights)
        assert found.intervals == ((0, Fraction(1, 2)),)

    def test_set_contains_wrenches(self):
        assembly, weights = stack()
        everything = ResistedSet(assembly)
        assert weights in everything
        assert {**weights, "block 2": [1, -1, "-3/2"]} not in everything
        assert everything.solve(weights).verdict == "resisted"
        assert everything.grasp is assembly


class TestContactProgram:
    def program(self, contacts, states, load, **options):
        rows = Assembly(["a"], [BodyContact("a", None, contact) for contact in contacts]).rows
        pushed = (Fraction(1), Fraction(0), Fraction(0))
        question = LinearQuestion(rows, tuple(map(Fraction, load)), pushed, **options)
        return ContactProgram(question, states)

    def test_ends_say_how_far_contacts_are_from_the_law(self):
        floor = Contact([0, 0], [0, 1], "1/2")
        wall = Contact([-1, 0], [1, 0], 0, 2, 3)
        program = self.program([floor, wall], ("attached", "attached"), (0, -1, 0))
        none = Fraction(0)
        # First it slips away from the wall by 3/2, and friction misses what is there at the last.
        assert program.ends() == [
            (0, [Fraction(1, 2), none], ("slip-", "detached")),
            (Fraction(1, 2), [none, none], ("slip-", "detached")),
        ]
        assert [end.is_lawful for end in program.ends()] == [False, True]
        held = self.program([floor], ("undecided",), (0, -2, 0), max_displacement=none)
        assert held.start() == (0, [6], ("detached",))
        # With any friction a contact that presses may rub, and one that does not may not.
        for load, violation in (((-2, -1, 0), 0), ((-2, 0, 0), 2)):
            rubbing = self.program([floor], ("attached",), load, frictions=(none, None))
            assert rubbing.start().violations == [violation]

    def test_multiples_of_expressions_are_added(self):
        terms = {0: Fraction(1)}
        for factor, found in ((0, {0: 1}), (1, {0: 3, 1: 3}), (2, {0: 7, 1: 9})):
            contact_law.add(terms, {0: Fraction(2), 1: Fraction(3), 2: Fraction(0)}, factor)
            assert terms == found


class TestPlane:
    def questions(self, count):
        rng = random.Random(7)
        for seed in range(count):
            grasp = random_grasp(2 + seed % 4, seed)
            grasp = grasp.with_preload(rng.choice([0, 1])) if seed % 3 else grasp
            yield grasp, *([Fraction(rng.randint(-4, 4), 4) for _ in range(3)] for _ in range(2))

    def agree(self, count, with_friction):
        for k, (grasp, base, direction) in enumerate(self.questions(count)):
            if not any(direction):
                continue
            bound = Fraction(k, 2) if k % 2 else None
            both = (grasp, Assembly.of_grasp(grasp))
            plane, one = (ResistedSet(x, max_displacement=bound) for x in both)
            found = one.along({"object": direction}, {"object": base})
            assert found.intervals == plane.along(direction, base).intervals
            margins = plane.margin(direction), one.margin({"object": direction})
            assert margins[0].intervals == margins[1].intervals
            assert margins[0].preloads.intervals == margins[1].preloads.intervals
            if k >= with_friction:
                continue
            alone, body = (margin.friction("1/8") for margin in margins)
            assert alone.high == body.high
            assert alone.low == body.low

    def test_one_body_has_the_magnitudes_of_the_planar_grasp(self):
        self.agree(2, 1)

    @pytest.mark.slow
    def test_one_body_has_the_magnitudes_of_many_planar_grasps(self):
        self.agree(12, 3)


class TestBruteForce:
    def agree(self, seeds):
        for seed in seeds:
            document, base = random_question(seed, 4)
            rng, names = random.Random(seed), document["bodies"]
            along = {name: [Fraction(rng.randint(-2, 2)) for _ in range(3)] for name in names}
            if not any(map(any, along.values())):
                continue
            found = ResistedSet(Assembly.from_dict(document)).along(along, base).intervals
            ends = [end for part in found for end in part if end is not None]
            tried = {Fraction(0), Fraction(1), Fraction(rng.randint(1, 40), 8), *ends}
            tried |= {end + step for end in ends for step in (NEAR, -NEAR) if end + step >= 0}
            for t in tried:
                load = {
                    name: [
                        Fraction(x) + t * y for x, y in zip(base[name], along[name], strict=True)
                    ]
                    for name in names
                }
                inside = any(low <= t and (high is None or t <= high) for low, high in found)
                assert inside == resisted(document, load), (seed, t)

    def test_random_assemblies_agree(self):
        self.agree(range(15))

    @pytest.mark.slow
    @pytest.mark.parametrize("seeds", [range(k, k + 25) for k in range(1000, 1050, 25)], ids=str)
    def test_many_random_assemblies_agree(self, seeds):
        self.agree(seeds)


class TestLimits:
    def test_floating_bodies_hold_where_their_wrenches_cancel(self):
        pair = Assembly(["a", "b"], [BodyContact("a", "b", Contact((0, 0), (0, 1), 1, preload=1))])
        found = ResistedSet(pair).along({"a": [0, -1, 0]}, {"b": [0, "1/2", 0]})
        assert found.intervals == ((Fraction(1, 2), Fraction(1, 2)),)
        assert not ResistedSet(pair).along({"a": [0, 1, 0]}, {"b": [0, "1/2", 0]}).intervals
        assert ResistedSet(pair).margin({"a": [1, 0, 0]}).friction("1/4").impossible

    def test_zero_direction_is_refused(self):
        with pytest.raises(GraspError, match="zero"):
            ResistedSet(stack()[0]).along({})

    @pytest.mark.parametrize(
        "ask",
        [
            lambda arch, weights: ResistedSet(arch).along({"voussoir 2": [1, 0, 0]}, weights),
            lambda arch, weights: ResistedSet(arch).margin(weights).preloads,
            lambda arch, weights: ResistedSet(arch).margin(weights).friction(),
            lambda arch, weights: solve(arch, weights).equilibria,
        ],
        ids=["along", "preloads", "friction", "equilibria"],
    )
    def test_large_tree_is_undecided_with_its_limit(self, ask, monkeypatch):
        monkeypatch.setattr(magnitudes, "MAX_NODES", 8)
        tree = "the tree of a part with 10 contacts is not closed"
        reason = f"after 16 nodes, {tree}; with arrangement.limit(4) allows more"
        with limit(2), pytest.raises(UndecidedError, match=re.escape(reason)):
            ask(*TEXTBOOK["arch"](voussoirs=4))

    def test_steps_of_a_command_leave_it_undecided(self):
        with meter_steps(1000), pytest.raises(UndecidedError, match="limit of 1,000 steps"):
            ResistedSet(wedge()[0]).along({"wedge": [1, 0, 0]}, wedge()[1])

    @pytest.mark.parametrize(
        "ask",
        [
            lambda found: found.polyhedra,
            lambda found: found.slice(),
            lambda found: found.search(),
            lambda found: found.smallest_outside(),
            lambda found: found.draw(),
            lambda found: found.check([[0, 0, 0]]),
            lambda found: list(found.solve_many([{}])),
        ],
    )
    def test_what_is_of_one_body_is_refused(self, ask):
        with pytest.raises(EquilibriumError, match="no list of resisted wrenches"):
            ask(ResistedSet(stack()[0]))

    def test_cones_are_refused(self):
        with pytest.raises(GraspError, match="an assembly takes no pyramid"):
            ResistedSet(stack()[0], pyramid=4)


PUSHED = "resisted for t in [0, 1/2]\n  at 1/2: slips at contacts 3, 4\n"


class TestCommand:
    @pytest.fixture(name="file")
    def stack_file(self, tmp_path):
        path = tmp_path / "stack.json"
        assembly, weights = stack()
        assembly.save(path, weights)
        return str(path)

    def test_magnitudes_of_a_push(self, file, run):
        assert run("resisted {} --along {} 1 0 -3/2", file, "block 2") == PUSHED
        lighter = ["--on", "block 1", "0", "0", "0", "--on", "block 2", "0", "-1/2", "0"]
        assert run("resisted {} --along {} 1 0 -3/2", file, "block 2", *lighter) == PUSHED.replace(
            "1/2", "1/4"
        ).replace("3, 4", "1, 2, 3, 4")

    def test_margin_has_the_documents_of_a_grasp(self, file, run):
        document = run.json("resisted {} --margin", file)
        assert document["intervals"] == [["0", None]]
        assert document["friction"]["high"] == "0"
        tipped = ["--on", "block 2", "1", "-1", "-3/2"]
        assert "resisted: no" in run("resisted {} --margin", file, *tipped, code=1)

    def test_preload_replaces_that_of_the_file(self, file, run):
        push = ["--along", "block 2", "1", "0", "-3/2"]
        assert run("resisted", file, *push, "--preload", "1") == PUSHED
        assert "block 1 moves by (0, 0, 0)" in run("solve {} --preload 1", file)

    @pytest.mark.parametrize(
        ("command", "lines", "where"),
        [
            (["resisted", "--along", "voussoir 2", "1", "0", "0"], ["undecided: "], None),
            (["resisted", "--margin"], ["uniform preload: undecided, "], "preload"),
            (["solve", "--all"], ["resisted: an exact", "all equilibria: undecided"], "equilibria"),
        ],
    )
    def test_large_part_is_undecided(self, command, lines, where, tmp_path, run):
        path = tmp_path / "arch.json"
        assembly, weights = TEXTBOOK["arch"](voussoirs=4)
        assembly.save(path, weights)
        command = [command[0], str(path), *command[1:], "--limit", "0.004"]
        text = run(*command, code=3)
        assert all(line in text for line in lines)
        assert "the tree of a part with 10 contacts is not closed; --limit 1 allows more" in text
        document = run.json(*command, code=3)
        found = document[where] if where else document
        assert found["verdict"] == "undecided"
        assert found["reason"] in text

    @pytest.mark.parametrize(
        ("options", "words"),
        [
            ([], "--along BODY"),
            (["--along", "block 1", "0", "0", "1", "--margin"], "either --along"),
            (["--along", "block 3", "0", "0", "1"], "one of the bodies"),
            (["--wrench", "0", "0", "1"], "--wrench is for one body"),
            (["--slice", "fx", "fy"], "--slice is for one body"),
            (["--along", "block 1", "0", "0", "1", "--contacts", "1"], "goes with --margin"),
        ],
    )
    def test_bad_options_are_refused(self, file, options, words, refused):
        assert words in refused("resisted", file, *options)
