"""Several bodies: textbook questions, brute force, planar verdicts, forged certificates, files."""

import copy
import functools
import inspect
import itertools
import json
import math
import random
from dataclasses import replace
from fractions import Fraction
from importlib.resources import files

import pytest

from arrangement import InputError, OutOfReachError
from arrangement.planes import proved
from equilibrium import (
    Assembly,
    BodyContact,
    CertificateError,
    Circle,
    Contact,
    EquilibriumError,
    GraspError,
    Polygon,
    RigidBody,
    compare,
    read_assembly,
    solve,
    verify,
)
from equilibrium.certificate.checker import check
from equilibrium.certificate.law import joint_rows, law_problem
from equilibrium.core.cones import LineCones
from equilibrium.core.contacts import FloatContacts
from equilibrium.core.tree import SpatialSearch
from equilibrium.decide.assemblies.parts import parts_of
from equilibrium.decide.assemblies.rigid import rigid_forces
from equilibrium.grasps.inputs import random_grasp
from equilibrium.grasps.schemas import assembly_certificate_schema, assembly_schema
from equilibrium.grasps.textbook import TEXTBOOK, arch, cylinders, ladder, stack, wedge
from equilibrium.model.effort import Effort
from equilibrium.pictures.assemblies import draw_assembly
from proofs_check import instances
from proofs_check.routes.bodies import resisted
from tests.drawn import elements
from tests.schemas import validator

from .random_assemblies import random_question

CASES = json.loads(files(instances).joinpath("bodies.json").read_text(encoding="utf-8"))["cases"]
QUESTIONS = [
    pytest.param(case, question, id=f"{case['name']}-{k}")
    for case in CASES
    for k, question in enumerate(case["questions"])
]


def contact(a, b, point, normal=(0, 1), friction="1/2", preload=0):
    return BodyContact(a, b, Contact(point, normal, friction, preload=preload))


#: Two blocks on a table.
STACK = Assembly(
    ["lower", "upper"],
    [
        contact("lower", None, [-2, 0]),
        contact("lower", None, [2, 0]),
        contact("upper", "lower", [-1, 1], friction="1/4"),
        contact("upper", "lower", [1, 1], friction="1/4"),
    ],
)
WEIGHTS = {"lower": [0, -2, 0], "upper": [0, -1, 0]}
#: A wedge between a wall and a block: one part of two bodies.
WEDGE = next(case for case in CASES if case["name"] == "wedge-under-a-block")


def asked(case, question):
    document = {"bodies": case["bodies"], "contacts": question["contacts"]}
    return Assembly.from_dict(document), question["wrench"]


@functools.cache
def _answered(name, k):
    case = next(case for case in CASES if case["name"] == name)
    return solve(*asked(case, case["questions"][k]))


def answered(case, question):
    """The verdict on a textbook question."""
    return _answered(case["name"], case["questions"].index(question))


@functools.cache
def random_verdict(seed):
    """The verdict on a random question."""
    document, wrenches = random_question(seed)
    return solve(Assembly.from_dict(document), wrenches)


class TestTextbook:
    @pytest.mark.parametrize(("case", "question"), QUESTIONS)
    def test_verdict_is_that_by_hand(self, case, question):
        verdict = answered(case, question)
        assert verdict.verdict == ("resisted" if question["resisted"] else "not resisted")
        report = verdict.verify()
        assert report
        assert report.compared
        schema = validator(assembly_certificate_schema())
        assert schema.is_valid(verdict.proof)

    @pytest.mark.parametrize(
        ("case", "question"), [param for param in QUESTIONS if "example" in param.values[1]]
    )
    def test_example_obeys_the_law(self, case, question):
        assembly, wrenches = asked(case, question)
        moved = tuple(map(Fraction, question["example"]["motion"]))
        forces = [tuple(map(Fraction, row)) for row in question["example"]["forces"]]
        loads = assembly.read_wrenches(wrenches)
        load = tuple(x for name in assembly.names for x in loads[name])
        assert law_problem(joint_rows(assembly), load, moved, forces) == ""


class TestBruteForce:
    def agree(self, verdict, seed, most=4):
        document, wrenches = random_question(seed, most)
        assert verdict.verdict == ("not resisted", "resisted")[resisted(document, wrenches)], seed
        assert verdict.verify(), seed

    @pytest.mark.parametrize("seeds", [range(10 * k, 10 * k + 10) for k in range(3)], ids=str)
    def test_random_assemblies_agree(self, seeds):
        for seed in seeds:
            self.agree(random_verdict(seed), seed)

    @pytest.mark.slow
    @pytest.mark.parametrize("seeds", [range(100 * k, 100 * k + 100) for k in range(2)], ids=str)
    def test_many_random_assemblies_agree(self, seeds):
        for seed in seeds:
            self.agree(random_verdict(1000 + seed), 1000 + seed)

    @pytest.mark.slow
    def test_larger_random_assemblies_agree(self):
        for seed in range(10_000, 10_012):
            document, wrenches = random_question(seed, 6)
            self.agree(solve(Assembly.from_dict(document), wrenches), seed, 6)


class TestDisplacement:
    def test_bound_is_that_of_the_softest_contact(self):
        """Each foot of the lower block bears 3/2."""
        for bound, verdict in (("3/2", "resisted"), ("1499/1000", "not resisted")):
            found = solve(STACK, WEIGHTS, max_displacement=bound)
            assert found.verdict == verdict
            assert found.verify()
            assert found.proof["max_displacement"] == bound
            schema = validator(assembly_certificate_schema())
            assert schema.is_valid(found.proof)
            assert not check(found.proof, (STACK, found.wrenches))
        assert "among displacements of contacts up to 3/2" in str(
            solve(STACK, WEIGHTS, max_displacement="3/2").lines()
        )

    def test_cycle_has_proofs_with_displacements(self):
        assembly, wrenches = asked(WEDGE, WEDGE["questions"][4])
        found = solve(assembly, wrenches, max_displacement="1/4")
        assert found.verdict == "not resisted"
        assert "displacements" in json.dumps(found.proof)
        assert not check({**found.proof, "max_displacement": "1000"})
        unbounded = {key: x for key, x in found.proof.items() if key != "max_displacement"}
        assert not check(unbounded)
        much = solve(assembly, wrenches, max_displacement=10)
        assert much.verdict == "resisted"
        assert not check({**much.proof, "max_displacement": "1/100"})

    def agree(self, seeds, most):
        for seed in seeds:
            document, wrenches = random_question(seed, most)
            bound = Fraction(random.Random(seed).randint(0, 6), 4)
            verdict = solve(Assembly.from_dict(document), wrenches, max_displacement=bound)
            yes = resisted(document, wrenches, bound)
            assert verdict.verdict == ("not resisted", "resisted")[yes], seed
            assert verdict.verify(), seed

    def test_random_assemblies_agree(self):
        self.agree(range(16), 3)

    @pytest.mark.slow
    def test_many_random_assemblies_agree(self):
        self.agree(range(5000, 5030), 3)


class TestPlane:
    def questions(self, count):
        rng = random.Random(41)
        for seed in range(count):
            grasp = random_grasp(2 + seed % 5, seed)
            yield grasp, [Fraction(rng.randint(-4, 4), 4) for _ in range(3)]

    def agrees(self, grasp, wrench, body_turned):
        alone = solve(grasp, wrench).verdict
        one = Assembly.of_grasp(grasp)
        assert solve(one, {"object": wrench}).verdict == alone
        # Another body touches nothing, or is held by so much that it does not move.
        held = [
            contact("frame", None, place, normal, friction=1000, preload=10**6)
            for place, normal in (([9, 0], [-1, 0]), ([-9, 0], [1, 0]), ([0, 9], [0, -1]))
        ]
        touching = [
            BodyContact("object", "frame", c).reversed if body_turned else
            BodyContact("object", "frame", c)
            for c in grasp
        ]  # fmt: skip
        both = Assembly(["object", "frame"], touching + held)
        loads = {"object": wrench, "frame": [-x for x in wrench]}
        assert solve(both, loads).verdict == alone

    def test_one_body_is_the_planar_question(self):
        for k, (grasp, wrench) in enumerate(self.questions(6)):
            self.agrees(grasp, wrench, k % 2)

    @pytest.mark.slow
    def test_one_body_is_the_planar_question_many_times(self):
        for k, (grasp, wrench) in enumerate(self.questions(30)):
            self.agrees(grasp, wrench, k % 2)


class TestRows:
    def test_exchanged_bodies_have_the_same_rows(self):
        for seed in range(20):
            assembly = Assembly.from_dict(random_question(seed)[0])
            turned = [c if c.body_b is None else c.reversed for c in assembly.contacts]
            assert Assembly(assembly.names, turned).rows == assembly.rows

    def test_forces_on_two_bodies_are_opposite(self):
        rows = STACK.rows
        assert rows.n == 6
        assert rows[0].normal_wrench == (0, 1, -2, 0, 0, 0)
        assert rows[2].normal_wrench == (0, -1, 1, 0, 1, -1)
        assert rows[2].tangential_wrenches == ((1, 0, -1, -1, 0, 1),)


class TestParts:
    def test_stack_has_one_part_for_each_body(self):
        parts, floating = parts_of(STACK, STACK.read_wrenches(WEIGHTS))
        assert [(part.root, part.bodies, part.contacts) for part in parts] == [
            (None, ("lower",), (0, 1)),
            ("lower", ("upper",), (2, 3)),
        ]
        assert parts[0].wrenches == {"lower": (0, -3, 0)}
        assert parts[0].hanging == {"lower": ("lower", "upper")}
        assert not floating

    def test_cycle_with_the_ground_is_one_part(self):
        assembly, wrenches = asked(WEDGE, WEDGE["questions"][0])
        parts, _ = parts_of(assembly, assembly.read_wrenches(wrenches))
        assert [part.bodies for part in parts] == [("wedge", "block")]

    def test_tower_is_decided_block_by_block(self):
        names = [f"block {k}" for k in range(10)]
        contacts = [
            contact(name, names[k - 1] if k else None, [x, k])
            for k, name in enumerate(names)
            for x in (-1, 1)
        ]
        tower = Assembly(names, contacts)
        assert solve(tower, dict.fromkeys(names, (0, -1, 0)))
        pushed = {**dict.fromkeys(names, (0, -1, 0)), names[-1]: (1, -1, -10)}
        assert solve(tower, pushed).verdict == "not resisted"

    def test_part_that_hangs_on_a_cycle_moves_with_it(self):
        """A block on the block over the wedge: its load is that of the block below."""
        case, question = WEDGE, WEDGE["questions"][0]
        assembly, wrenches = asked(case, question)
        top = [contact("top", "block", [x, 20]) for x in (-1, 1)]
        more = Assembly([*assembly.names, "top"], [*assembly.contacts, *top])
        loads = assembly.read_wrenches(wrenches)
        x, y, torque = loads["block"]
        moved = {**loads, "block": (x, y + 1, torque), "top": (0, -1, 0)}
        assert solve(more, moved).verdict == answered(case, question).verdict == "resisted"
        assembly, wrenches = asked(case, case["questions"][1])
        more = Assembly([*assembly.names, "top"], [*assembly.contacts, *top])
        loads = assembly.read_wrenches(wrenches)
        x, y, torque = loads["block"]
        moved = {**loads, "block": (x, y + 1, torque), "top": (0, -1, 0)}
        verdict = solve(more, moved)
        assert verdict.verdict == "not resisted"
        assert verdict.verify()


class TestCommonMotion:
    PAIR = Assembly(["a", "b"], [contact("a", "b", [x, 0], preload=1) for x in (-1, 1)])

    def test_load_that_does_not_balance_is_refused_by_one_leaf(self):
        verdict = solve(self.PAIR, {"a": [0, -1, 0]})
        assert verdict.verdict == "not resisted"
        assert verdict.reason.startswith("the load does not balance as a whole")
        assert verdict.verify().leaves == 1

    def test_load_that_balances_is_resisted(self):
        assert solve(self.PAIR, {"a": [0, -1, 0], "b": [0, 1, 0]})

    def test_body_that_touches_nothing_bears_nothing(self):
        assert solve(Assembly(["a"]), {})
        assert solve(Assembly(["a"]), {"a": [0, 0, 1]}).verdict == "not resisted"
        assert solve(Assembly([]), {})


class TestLimits:
    def test_few_nodes_leave_it_undecided(self):
        books = next(case for case in CASES if case["name"] == "books-between-walls")
        assembly, wrenches = asked(books, books["questions"][2])
        verdict = solve(assembly, wrenches, nodes=2)
        assert verdict.verdict == "undecided"
        assert "2 nodes" in verdict.reason
        assert verdict.certificate is None
        with pytest.raises(EquilibriumError, match="undecided"):
            bool(verdict)

    def test_steps_of_a_relaxation_grow_with_the_bodies(self):
        """So that the limit of steps ends searches for many bodies as soon as for one in space."""
        spent = []
        for voussoirs in (2, 4):
            made, _ = arch(voussoirs=voussoirs)
            effort = Effort()
            how = [Fraction(0)] * made.rows.n, lambda _: False, effort
            SpatialSearch(FloatContacts(made.rows), *how, cones=LineCones()).count_program()
            spent.append(effort.spent)
        assert spent == [10_000 + 6 * 1000, 10_000 + 10 * 1000 * 2]

    def test_too_many_contacts_are_refused(self):
        row = STACK.to_dict()["contacts"][0]
        with pytest.raises(OutOfReachError, match="contacts"):
            Assembly.from_dict({**STACK.to_dict(), "contacts": [row] * 5000})

    def test_time_limit_leaves_it_undecided(self):
        verdict = solve(*asked(WEDGE, WEDGE["questions"][1]), time_limit=1e-9)
        assert verdict.verdict == "undecided"
        assert "time limit" in verdict.reason


class TestForged:
    """A number of a certificate changed: refused, or still a proof of the question in it."""

    def forgeries(self):
        rng = random.Random(7)
        proofs = [answered(*param.values).proof for param in QUESTIONS]
        while True:
            for proof in proofs:
                forged = copy.deepcopy(proof)
                part = (
                    ("assembly", "wrench") if rng.random() < 0.3 else ("tree", "motion", "forces")
                )
                if change(forged, part, rng):
                    yield forged

    def refused(self, count):
        found = 0
        for forged in self.forgeries():
            if not verify(forged):
                found += 1
            else:
                # What is accepted is true.
                known = Assembly.from_dict(forged["assembly"])
                assert solve(known, forged["wrench"]).verdict == forged["certificate"], forged
            if found == count:
                return

    @pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
    def test_proof_of_the_other_side_of_a_border_is_refused(self, case):
        verdicts = [answered(case, question) for question in case["questions"]]
        for one, other in itertools.permutations(verdicts, 2):
            if one.verdict != other.verdict:
                question = {key: other.proof[key] for key in ("assembly", "wrench")}
                try:
                    assert not verify({**one.proof, **question})
                except CertificateError:
                    assert len(one.assembly) != len(other.assembly)

    def test_forged_certificates_are_refused(self):
        self.refused(8)

    @pytest.mark.slow
    def test_forged_certificates_are_refused_many_times(self):
        self.refused(25)

    def test_yes_turned_into_no_is_no_certificate(self):
        proof = solve(STACK, WEIGHTS).proof
        with pytest.raises(ValueError, match="tree"):
            verify({**proof, "certificate": "not resisted"})

    def test_part_has_all_its_contacts(self):
        proof = solve(STACK, {**WEIGHTS, "upper": [1, -1, -1]}).proof
        assert proof["tree"]["part"] == ["upper"]
        assert verify(proof)
        for change in ({"contacts": [2]}, {"contacts": [2, 3, 3]}, {"part": ["lower"]}):
            report = verify({**proof, "tree": {**proof["tree"], **change}})
            assert "contacts of the part" in report.problem or "pair" in report.problem
        with pytest.raises(CertificateError, match="names of bodies"):
            verify({**proof, "tree": {**proof["tree"], "part": ["middle"]}})

    def test_part_that_touches_two_bodies_is_refused(self):
        three = Assembly(
            ["a", "b", "c"],
            [contact("a", "b", [0, 0]), contact("a", "c", [1, 0]), contact("b", None, [0, -1])],
        )
        proof = solve(three, {"a": [0, 1, 0]}).proof
        forged = {**proof, "tree": {"part": ["a"], "contacts": [0, 1], "tree": ["0", "1", "0"]}}
        assert "more than one pair" in verify(forged).problem

    def test_alpha_below_zero_is_refused_where_a_contact_may_detach(self):
        """Two contacts at one place: a negative alpha would cancel what the other depends on."""
        pair = Assembly(["a"], [contact("a", None, [0, 0], preload=q) for q in (0, 1)])
        wrench = {"a": [0, "-1/2", 0]}
        assert solve(pair, wrench)
        proof = solve(pair, {"a": [0, 1, 0]}).proof
        leaf = {"virtual_motion": {"a": [0, 1, 0]}, "multipliers": {"0": [-1, 0], "1": [1, 0]}}
        forged = {**proof, "wrench": wrench, "tree": leaf}
        assert "alpha must be at least 0" in verify(forged).problem

    @pytest.mark.parametrize(("state", "sign"), [("slip+", 1), ("slip-", -1)])
    def test_multiplier_of_a_slip_has_a_sign(self, state, sign):
        proof = solve(STACK, {"lower": [0, 9, 0]}).proof
        leaf = {"virtual_motion": {"lower": [0, 1, 0], "upper": [0, 1, 0]}}
        states = dict.fromkeys(("stick", "slip+", "slip-"), leaf)
        for h, words in ((sign, "h has the wrong sign"), (-sign, "is not 0"), (0, "")):
            states[state] = {**leaf, "multipliers": {"0": [0, h]}}
            slips = {"contact": 0, "slip": states}
            tree = {"contact": 0, "attachment": {"detached": leaf, "attached": slips}}
            problem = verify({**proof, "tree": tree}).problem
            assert words in problem if words else not problem

    def test_split_that_does_not_fit_is_refused(self):
        proof = solve(STACK, {"lower": [0, 9, 0]}).proof
        leaf = {"virtual_motion": {"lower": [0, 1, 0], "upper": [0, 1, 0]}}
        slips = {"contact": 0, "slip": dict.fromkeys(("stick", "slip+", "slip-"), leaf)}
        again = {"contact": 0, "attachment": dict.fromkeys(("detached", "attached"), leaf)}
        twice = {"contact": 0, "attachment": {"detached": leaf, "attached": again}}
        for tree, words in ((slips, "is not attached"), (twice, "is not undecided")):
            with pytest.raises(CertificateError, match=words):
                verify({**proof, "tree": tree})

    def test_question_of_a_certificate_is_compared(self):
        proof = solve(STACK, WEIGHTS).proof
        other = STACK.read_wrenches({"upper": [0, -1, 0]})
        assert "another" in check(proof, (STACK, other)).problem


def change(document, parts, rng):
    """Change one number in some parts of a certificate; False if there is none."""
    kept = ("edge", "at", "contact", "part", "contacts", "normal", "schema_version", "bodies")
    places = []

    def walk(value, parent, key):
        if isinstance(value, dict):
            for name, child in value.items():
                # Contacts of an assembly have numbers, those of a proof are numbers.
                if name not in kept or (isinstance(child, list) and isinstance(child[0], dict)):
                    walk(child, value, name)
        elif isinstance(value, list):
            for k, child in enumerate(value):
                walk(child, value, k)
        elif isinstance(value, str) and key != "name" and "body" not in str(key):
            places.append((parent, key))

    for name in parts:
        if name in document:
            walk(document[name], document, name)
    if not places:
        return False
    parent, key = rng.choice(places)
    old = Fraction(parent[key])
    values = [-old, old + 1, old - 1, 2 * old, old + Fraction(1, 10**9)]
    new = rng.choice(values)
    if key in ("friction", "preload", "stiffness"):
        new = abs(new) or Fraction(1, 7)
    parent[key] = str(new)
    return new != old


class TestModel:
    def test_document_round_trips(self, tmp_path):
        bodies = [
            RigidBody("a", Polygon([[0, 0], [1, 0], [0, 1]])),
            RigidBody("b", Circle([0, 0], 1)),
        ]
        assembly = Assembly(bodies, [contact("a", "b", [0, 0], preload="1/3")])
        document = assembly.to_dict()
        validator(assembly_schema()).validate(document)
        assert Assembly.from_dict(document).to_dict() == document
        assembly.save(tmp_path / "a.json", {"a": [0, 1, 0]})
        assert read_assembly(tmp_path / "a.json") == assembly
        written = json.loads((tmp_path / "a.json").read_text("utf-8"))
        validator(assembly_schema()).validate(written)
        assert written["wrench"]["b"] == ["0", "0", "0"]

    @pytest.mark.parametrize(
        ("bodies", "contacts", "words"),
        [
            (["a", "a"], [], "twice"),
            ([""], [], "characters"),
            ([" a"], [], "spaces"),
            ([3], [], "name of a body is 3"),
            (["a"], [contact("a", "b", [0, 0])], "one of the bodies"),
            (["a"], ["contact"], "expected BodyContact"),
        ],
    )
    def test_bad_assemblies_are_refused(self, bodies, contacts, words):
        with pytest.raises(GraspError, match=words):
            Assembly(bodies, contacts)

    @pytest.mark.parametrize(
        ("changes", "words"),
        [
            ({"bodies": "a"}, "expected a list"),
            ({"bodies": [{"name": "lower", "mass": 1}]}, "unknown key 'mass'"),
            ({"contacts": [{}]}, 'no key "body_a"'),
            ({"contacts": [{"body_a": None, "body_b": "lower"}]}, "body_a is None"),
            ({"contacts": [3]}, "expected an object"),
            ({"schema_version": 2}, "reads 1"),
            ({"masses": []}, "unknown key"),
        ],
    )
    def test_bad_documents_are_refused(self, changes, words):
        with pytest.raises(ValueError, match=words):
            Assembly.from_dict({**STACK.to_dict(), **changes})
        assert not validator(assembly_schema()).is_valid({**STACK.to_dict(), **changes})

    def test_contact_with_itself_or_in_space_is_refused(self):
        with pytest.raises(GraspError, match="two bodies"):
            contact("a", "a", [0, 0])
        with pytest.raises(GraspError, match="in the plane"):
            BodyContact("a", None, Contact([0, 0, 0], [0, 0, 1], 1))
        with pytest.raises(GraspError, match="is the ground"):
            assert contact("a", None, [0, 0]).reversed

    @pytest.mark.parametrize(
        ("wrenches", "words"),
        [
            ({"middle": [0, 0, 0]}, "one of the bodies lower, upper"),
            ({"upper": [0, 0]}, "has 2 entries; expected three"),
            ([0, 0, 0], "expected a mapping"),
            ({"upper": [0.5, 0, 0]}, "float"),
        ],
    )
    def test_bad_wrenches_are_refused(self, wrenches, words):
        with pytest.raises(ValueError, match=words):
            solve(STACK, wrenches)

    def test_options_of_one_body_are_refused(self):
        for options in ({"pyramid": 4}, {"shorten": True}):
            with pytest.raises(GraspError, match="an assembly takes no"):
                solve(STACK, WEIGHTS, **options)


class TestVerdict:
    def test_what_it_shows(self):
        verdict = solve(STACK, WEIGHTS)
        assert repr(verdict) == "<Verdict: resisted, <Assembly: 2 bodies, 4 contacts>>"
        assert verdict.motions == {"lower": (0, Fraction(-3, 2), 0), "upper": (0, -2, 0)}
        assert verdict.states == ("stick",) * 4
        assert verdict.to_dict()["wrench"] == {"lower": ["0", "-2", "0"], "upper": ["0", "-1", "0"]}
        assert json.loads(verdict.certificate.text)["motion"]["upper"] == ["0", "-2", "0"]
        assert verify(verdict.proof)

    def test_least_displacement_shown_for_free_slip(self):
        verdict = solve(STACK, {**WEIGHTS, "upper": ["1/4", -1, "-3/8"]})
        assert verdict.motions["upper"] == (0, -2, Fraction(-7, 64))

    def test_part_that_gives_way_is_named(self):
        verdict = solve(STACK, {**WEIGHTS, "upper": ["1/3", -1, "-1/2"]})
        assert verdict.reason == "the contacts of upper with lower cannot balance the load"
        assert not verdict.forces
        assert verdict.to_dict()["reason"] == verdict.reason


class TestEquilibria:
    def test_one_body_has_those_of_the_planar_grasp(self):
        rng, held = random.Random(3), 0
        for seed in range(9):
            grasp = random_grasp(2 + seed % 3, seed).with_preload(seed % 3 and 1)
            wrench = [Fraction(rng.randint(-2, 2), 2) for _ in range(3)]
            verdict = solve(grasp, wrench)
            parts = solve(Assembly.of_grasp(grasp), {"object": wrench}).equilibria
            listed = [(one.states, one.unique) for part in parts for one in part]
            due = [(one.states, one.forces_determined) for one in verdict.equilibria]
            assert sorted(listed) == sorted(due)
            held += bool(due)
        assert held

    def test_parts_of_a_stack_are_apart(self):
        parts = solve(STACK, WEIGHTS).equilibria
        assert [[(one.contacts, one.states) for one in part] for part in parts] == [
            [((0, 1), ("stick", "stick"))],
            [((2, 3), ("stick", "stick"))],
        ]
        assert not parts[0][0].unique
        assert not solve(STACK, {"upper": [1, 0, 0]}).equilibria

    def test_smooth_cycle_has_one_equilibrium(self):
        ((one,),) = solve(*ladder()).equilibria
        assert one.unique
        assert one.states == ("slip+", "attached", "detached", "slip-")
        assert one.forces == solve(*ladder()).forces

    def test_equilibria_that_are_not_known_say_why(self):
        verdict = solve(STACK, {"lower": (0, -1, 0), "upper": (0, -1, 0)})
        assert verdict.verdict == "resisted"
        verdict.__dict__["_all_equilibria"] = "too many choices"
        assert verdict.lines(True) == [
            *verdict.lines(), "all equilibria: undecided, too many choices"
        ]  # fmt: skip
        assert "too many choices" in str(verdict.to_dict(True)["equilibria"])
        assert "equilibria" not in verdict.to_dict()
        refused = replace(verdict, solution=None, verdict="not resisted")
        assert "equilibria" not in refused.to_dict(True)


class TestRigid:
    BOOKS = next(case for case in CASES if case["name"] == "books-between-walls")

    def test_books_hold_rigidly_and_not_by_springs(self):
        verdict = solve(*asked(self.BOOKS, self.BOOKS["questions"][0]))
        assert verdict.verdict == "not resisted"
        assert verdict.balances_rigidly
        assert verdict.lines()[1].startswith("rigid bodies would hold")

    def test_methods_for_rigid_bodies_disagree_with_springs(self):
        assembly, wrenches = asked(self.BOOKS, self.BOOKS["questions"][0])
        found = compare(assembly, wrenches)
        assert [answer.accepts for answer in found.answers] == [False, True, False]
        assert found.disagreeing == ("weak",)
        assert found.to_dict()["wrench"]["left"] == ["0", "-1", "-1/2"]
        assert not compare(assembly, wrenches, methods=["weak"])
        for options in ({"methods": ["strong"]}, {"pyramid": 4}):
            with pytest.raises(GraspError):
                compare(assembly, wrenches, **options)

    def test_what_no_forces_balance_fails_rigidly(self):
        verdict = solve(*asked(WEDGE, WEDGE["questions"][1]))
        assert verdict.verdict == "not resisted"
        assert not verdict.balances_rigidly
        assert len(verdict.lines()) == 1

    def test_resisted_wrenches_are_balanced_rigidly(self):
        for seed in range(30):
            verdict = random_verdict(seed)
            forces = rigid_forces(verdict.assembly, verdict.wrenches)
            assert verdict.verdict != "resisted" or forces is not None
            for row, (normal, rubbed) in zip(verdict.assembly.rows, forces or (), strict=False):
                assert normal >= 0
                assert abs(rubbed) <= row.friction * normal


class TestCommand:
    @pytest.fixture(name="stack")
    def stack_file(self, tmp_path):
        path = tmp_path / "stack.json"
        STACK.save(path, WEIGHTS)
        return str(path)

    def test_solve_and_verify(self, stack, tmp_path, run):
        proof = str(tmp_path / "proof.json")
        head, *rows = run("solve {} --certificate", stack, proof).splitlines()[-5:]
        assert head.split() == ["bodies", "state", "normal", "tangential"]
        assert rows[2] == "    contact 3  upper on lower       stick  1/2     0"
        assert "not compared with an assembly" in run("verify", proof)
        assert verify(solve(STACK, WEIGHTS))
        assert verify(solve(STACK, WEIGHTS).certificate)
        run("verify {} --grasp", proof, stack)
        run("verify {} --json", proof)

    def test_wrenches_of_the_file_are_replaced(self, stack, tmp_path, run, refused):
        proof = str(tmp_path / "proof.json")
        pushed = ["--on", "upper", "1/3", "-1", "-1/2"]
        answer = run.json("solve", stack, *pushed, "--certificate", proof, code=1)
        assert answer["verdict"] == "not resisted"
        assert answer["wrench"]["lower"] == ["0", "-2", "0"]
        run("verify {} --grasp", proof, stack, code=1)
        error = refused("verify {} --grasp {} --wrench 0 0 1", proof, stack)
        assert "--wrench is for one body" in error

    @pytest.mark.parametrize("limit", [0, -1, float("nan")])
    def test_time_limit_that_is_not_positive_is_refused(self, limit):
        with pytest.raises(InputError, match="limit"):
            solve(STACK, {}, time_limit=limit)

    @pytest.mark.parametrize("wrench", [["0", "-1", "0"], ["0,-1,0"], ["0 -1 0"]])
    def test_names_with_spaces_stay_whole(self, wrench, tmp_path, run):
        path = str(tmp_path / "stack.json")
        run("make stack -o", path)
        assert "block 2 moves by (0, -3/2, 0)" in run("solve {} --on", path, "block 2", *wrench)

    @pytest.mark.parametrize(
        ("options", "words"),
        [
            ("--wrench 0 0 1", "--wrench is for one body"),
            ("--on middle 0 0 1", "one of the bodies"),
            ("--on upper 0 x 1", "'x'"),
            ("--on upper 0 0 1 --on upper 0 0 1", "twice"),
            ("--shorten", "--shorten is for one body"),
            ("--as-printed signs", "--as-printed is for one body"),
        ],
    )
    def test_bad_options_are_refused(self, stack, options, words, refused):
        assert words in refused(f"solve {{}} {options}", stack)

    def test_wrenches_are_asked_for(self, tmp_path, refused):
        path = tmp_path / "bare.json"
        STACK.save(path)
        assert "--on BODY" in refused("solve", path)

    def test_displacements_are_bounded_and_verified(self, stack, tmp_path, run):
        proof = str(tmp_path / "proof.json")
        bound = ["--max-displacement", "1"]
        run("solve", stack, *bound, "--certificate", proof, code=1)
        run("verify {} --grasp", proof, stack, *bound)
        assert "other displacements" in run("verify {} --grasp", proof, stack, code=1)
        printed = run("resisted {} --margin --tolerance 1/8", stack, *bound, code=1)
        assert "by a factor in [0, 2/3]" in printed

    def test_all_equilibria_are_listed(self, stack, run):
        assert "contacts 3, 4: 1 family of equilibria" in run("solve {} --all", stack)
        listed = run.json("solve {} --all", stack)["equilibria"]
        assert [part[0]["contacts"] for part in listed] == [[0, 1], [2, 3]]
        run("solve {} --all --on upper 1 0 0", stack, code=1)

    def test_methods_are_compared(self, stack, run, refused):
        lines = run("solve {} --methods", stack).splitlines()
        assert [line.split()[0] for line in lines] == ["yes", "yes", "yes"]
        run("solve {} --methods weak --on upper 1 0 0", stack, code=1)
        refused("solve {} --methods --certificate a.json", stack)

    def test_each_body_has_a_wrench_of_its_own(self, stack, run):
        both = ["--on", "lower", "0", "0", "0", "--on", "upper", "0", "-2", "0"]
        wrench = run.json("solve", stack, *both)["wrench"]
        assert wrench == {"lower": ["0", "0", "0"], "upper": ["0", "-2", "0"]}

    def test_force_closure_is_of_grasps(self, stack, refused):
        error = refused("info {} --force-closure", stack)
        assert "is an assembly of several bodies; expected a grasp" in error

    def test_verified_checker_takes_an_assembly(self, stack, tmp_path, run, monkeypatch):
        proof, program = str(tmp_path / "proof.json"), tmp_path / "proved-checker"
        run("solve {} --certificate", stack, proof)
        program.write_text('#!/bin/sh\necho "accepted: resisted"\n')
        program.chmod(0o755)
        monkeypatch.setattr(proved, "program", lambda: str(program))
        answer, wrench, *_ = run("verify {} --verified --grasp", proof, stack).splitlines()
        assert answer == "valid: resisted (by the verified checker)"
        assert wrench == "wrench on lower (0, -2, 0)"
        other = str(tmp_path / "other.json")
        STACK.save(other, {"upper": [0, -1, 0]})
        assert "another assembly" in run("verify {} --verified --grasp", proof, other, code=1)


class TestPicture:
    def scene(self, subject):
        return draw_assembly.scene(subject)

    def count(self, subject):
        return elements(self.scene(subject))

    def test_bodies_contacts_and_forces_are_drawn(self):
        found = self.count(solve(STACK, WEIGHTS))
        # Each contact force acts on its body, those between the blocks on both.
        assert (found["pad"], found["mark"], found["force"], found["wrench"]) == (4, 4, 6, 2)

    def test_assembly_alone_has_no_forces(self):
        found = self.count(STACK)
        assert found["pad"] == 4
        assert not found["force"] + found["wrench"] + found["mark"] + found["motion"]

    def test_displaced_outlines_are_drawn(self):
        blocks = [
            RigidBody("lower", Polygon([[-2, 0], [2, 0], [2, 1], [-2, 1]])),
            RigidBody("upper", Circle([0, 2], 1)),
        ]
        found = self.count(solve(Assembly(blocks, STACK.contacts), WEIGHTS))
        assert (found["body"], found["motion"]) == (2, 2)

    def test_reason_of_a_no_is_in_the_legend(self):
        made = self.scene(solve(STACK, {"upper": [1, 0, 0]}))
        assert any("not resisted" in line for line, _ in made.legend.lines)

    def test_torque_is_an_arc(self):
        assert self.count(solve(STACK, {"lower": [0, 0, 1]}))["torque"]

    def test_nothing_is_drawn_of_nothing(self):
        assert not self.count(Assembly([]))["body"]

    def test_command_draws_files(self, tmp_path, run, refused):
        path = tmp_path / "stack.json"
        STACK.save(path, WEIGHTS)
        run("draw {} -o", path, tmp_path / "a.svg")
        text = (tmp_path / "a.svg").read_text(encoding="utf-8")
        assert "name-2" in text
        for options, words in (
            (["--wrench", "0", "0", "1"], "--wrench is for one body"),
            (["--view", "proof"], "expected one of assembly"),
        ):
            assert words in refused("draw", path, *options, "-o", tmp_path / "b.svg")
        assert "expected one of" in refused("draw {} -o", path, tmp_path / "b.html")


class TestTextbookMakers:
    @pytest.mark.parametrize("name", TEXTBOOK)
    def test_made_by_command_as_by_function(self, name, tmp_path, run):
        assembly, wrenches = TEXTBOOK[name]()
        path = tmp_path / "a.json"
        run("make {} -o", name, path)
        assert read_assembly(path) == assembly
        written = json.loads(path.read_text("utf-8"))
        validator(assembly_schema()).validate(written)
        assert written == assembly.to_dict(wrenches)
        assert run.json("make", name) == written
        assert solve(assembly, wrenches)

    @pytest.mark.parametrize(("name", "case"), [("wedge", 1), ("cylinders", 2), ("ladder", 3)])
    def test_usual_contacts_are_those_of_the_textbook_case(self, name, case):
        """At the border: a billionth less friction anywhere is not resisted."""
        known, _ = asked(CASES[case], CASES[case]["questions"][0])
        made, _ = TEXTBOOK[name]()
        values = [
            [(c.contact.normal, c.contact.friction) for c in a.contacts] for a in (known, made)
        ]
        assert sorted(values[0]) == sorted(values[1])
        less = "1/9", "1/3", "3/8", "1/4"
        for option, usual in inspect.signature(TEXTBOOK[name]).parameters.items():
            if usual.default in less and option != "half_tangent":
                below = Fraction(usual.default) - Fraction(1, 10**9)
                assert not solve(*TEXTBOOK[name](**{option: below})), option

    def test_arch_has_joints_at_even_angles(self):
        made, _ = arch(voussoirs=6)
        assert len(made.contacts) == 14
        normals = [c.contact.normal for c in made.contacts[::2]]
        assert normals[0] == (0, 1)
        assert normals[3] == (1, 0)
        assert normals[1][1] == -normals[5][1]
        for k, (x, y) in enumerate(normals[:6]):
            angle = math.atan2(x, y)
            assert abs(angle - math.pi * k / 6) < 0.01

    @pytest.mark.parametrize(
        ("made", "options", "words"),
        [
            (stack, {"blocks": 0}, "from 1 to 200"),
            (arch, {"voussoirs": 1}, "from 2 to 200"),
            (arch, {"inner": 5}, "inner < outer"),
            (wedge, {"half_tangent": 1}, "below 1"),
            (cylinders, {"half_tangent": "1/4"}, "0.268"),
            (ladder, {"friction": -1}, "at least 0"),
        ],
    )
    def test_bad_numbers_are_refused(self, made, options, words):
        with pytest.raises(GraspError, match=words):
            made(**options)


def test_default_stiffness_written_in_certificates_only():
    assembly = Assembly(["a", "b"], [BodyContact("a", "b", Contact((0, 0), (0, 1), "1/2"))])
    turned = assembly.contacts[0].reversed
    assert "stiffness" not in assembly.to_dict()["contacts"][0]
    assert "stiffness" not in turned.to_dict()
    proof = solve(assembly, {}).certificate.to_dict()
    assert proof["assembly"]["contacts"][0]["stiffness"] == "1"
