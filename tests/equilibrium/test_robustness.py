"""Conversion keeps incidences, and verdicts are asked again within errors and bounds."""

import json
import math
import re
from collections import Counter
from fractions import Fraction
from random import Random

import pytest

from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, solve
from equilibrium.certificate.robust import (
    Bounds,
    _holds,
    ranges_of,
    refuted_within,
    resisted_within,
)
from equilibrium.cli.program import main
from equilibrium.decide.robustness import _steady
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.inputs import from_float_data, read_csv
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.errors import GraspError

from .converted_grasps import SHAPES, converted, original
from .test_checker import ATTACHMENT, HALVED, LEAF, ONE, ORTHANTS, leaf_holds, random_leaf

#: Angles of contacts on a circle, in degrees: no symmetry helps.
ANGLES = [10 + 44 * k for k in range(8)]


def on_round(radius=0.03, friction=0.0, **options):
    out = [(math.cos(math.radians(a)), math.sin(math.radians(a))) for a in ANGLES]
    points = [[radius * x, radius * y] for x, y in out]
    return from_float_data(points, [[-x, -y] for x, y in out], friction, **options)


def code_of(call):
    try:
        return main(call)
    except SystemExit as stopped:
        return stopped.code


def kinds(found):
    return {incidence.kind: incidence for incidence in found.kept}


class TestKept:
    @pytest.mark.parametrize("radius", [0.03, 30.0])
    def test_contacts_on_a_circle_stay_there(self, radius):
        found = on_round(radius)
        circle = kinds(found)["round"]
        assert (circle.contacts, circle.at) == (tuple(range(8)), (0, 0))
        for contact in found.grasp:
            assert contact.point == tuple(-circle.radius * x for x in contact.normal)
        assert max(found.point_errors) <= Fraction(1, 10**6)

    def test_a_frictionless_disc_turns_unless_its_data_are_taken_as_given(self):
        assert not solve(on_round().grasp, (0, 0, 1))
        loose = solve(on_round(as_given=True).grasp, (0, 0, 1))
        assert loose
        assert loose.within_error().verdict == "depends on the rounding"
        assert not loose.within_error().turned

    def test_contacts_on_a_ball_stay_there(self):
        out = [(1, 0, 0), (-0.6, 0.8, 0), (0.1, -0.7, 0.7), (0.3, 0.2, -0.9)]
        unit = [[x / math.hypot(*v) for x in v] for v in out]
        points = [[0.03 * x + 0.01 for x in v] for v in unit]
        found = from_float_data(points, [[-x for x in v] for v in unit], 0.3)
        ball = kinds(found)["round"]
        assert (ball.radius, ball.at) == (Fraction(3, 100), (Fraction(1, 100),) * 3)
        for c in found.grasp:
            assert c.point == tuple(
                a - ball.radius * x for a, x in zip(ball.at, c.normal, strict=True)
            )

    def test_a_turned_box_keeps_sides_and_lines(self):
        c, s = math.cos(0.3), math.sin(0.3)
        places = [((4, 1), (-1, 0)), ((4, -1), (-1, 0)), ((-4, 1), (1, 0)), ((0, 2), (0, -1))]
        points, normals = (
            [[c * x - s * y, s * x + c * y] for x, y in vectors]
            for vectors in zip(*places, strict=True)
        )
        found = from_float_data(points, normals, 0.5)
        one, two, three, four = found.grasp
        assert one.normal == two.normal == tuple(-x for x in three.normal)
        assert dot(one.normal, four.normal) == 0
        assert dot(one.normal, one.point) == dot(one.normal, two.point)
        assert dot(one.tangent, one.point) == dot(one.tangent, three.point)
        assert {"parallel", "level", "line"} <= set(kinds(found))

    def test_as_given_rounds_each_number_alone(self):
        found = on_round(as_given=True)
        assert found.kept == ()
        assert found.grasp.data_error.as_given
        with pytest.raises(GraspError, match="no data_error"):
            other_rounding(read_grasp("paper-three-contacts"), 0)

    def test_exact_tables_do_not_change_and_others_keep_their_centre(self, tmp_path):
        path = tmp_path / "grasp.csv"
        path.write_text("x,y,nx,ny,mu\n1,1,-1,-1,0\n-1,2,1,-2,0\n3,-1,-3,1,0\n")
        found = read_csv(path)
        assert kinds(found)["meet"].at == (0, 0)
        assert not solve(found.grasp, (0, 0, 1))
        loose = read_csv(path, as_given=True)
        assert loose.kept == ()
        assert [c.point for c in loose.grasp] == [(1, 1), (-1, 2), (3, -1)]
        path.write_text("x,y,nx,ny,mu\n3.0000001,4,-3,-4,0\n")
        assert read_csv(path).exact

    def test_other_roundings_keep_incidences_and_stay_within_the_error(self):
        found = on_round(preload=[1.0] * 8)
        others = [other_rounding(found.grasp, seed) for seed in range(3)]
        assert len({*others, found.grasp}) == 4
        for other in others:
            assert not solve(other.with_preload(0), (1, 0, 1))
            for old, new in zip(found.grasp, other, strict=True):
                pairs = zip(old.point, new.point, strict=True)
                assert max(abs(x - y) for x, y in pairs) <= Fraction(1, 10**6)


def test_the_error_of_the_data_goes_along_in_files(tmp_path, capsys):
    path = tmp_path / "disc.json"
    path.write_text(json.dumps(on_round().grasp.to_dict()))
    assert read_grasp(path).data_error.length == Fraction(1, 10**6)
    assert main(["solve", str(path), "--wrench", "0", "0", "1"]) == 1
    assert "no other verdict" in capsys.readouterr().out
    assert main(["solve", str(path), "--wrench", "1", "-2", "0", "--json"]) == 3
    document = json.loads(capsys.readouterr().out)
    assert document["verdict"] == "depends on the rounding"
    assert document["within_error"]["turned"]["verdict"] == "not resisted"


class TestRobust:
    grasp = read_grasp("paper-three-contacts-preload-1")

    def test_a_yes_is_proved_for_all(self):
        found = solve(self.grasp, (0, "1/2", 0)).robust(degrees="1/10", friction="5%")
        assert found
        assert found.answer == "holds"
        beyond = Bounds(degrees=10, friction="5%")
        assert resisted_within(
            self.grasp, solve(self.grasp, (0, "1/2", 0)).wrench, found.proof, beyond
        )

    def test_a_no_is_proved_for_all(self):
        grasp = Grasp([Contact([0, -1], [0, 1], "1/2"), Contact([1, -1], [0, 1], "1/2")])
        verdict = solve(grasp, (0, 1, 0))
        found = verdict.robust(degrees=2, friction="5%", length="1/100")
        assert found
        assert not refuted_within(grasp, verdict.wrench, found.proof, found.bounds)
        assert refuted_within(
            grasp, verdict.wrench, found.proof, Bounds(degrees=45, friction="90%")
        )
        assert refuted_within(grasp, (0, -1, 0), found.proof, found.bounds)

    @pytest.mark.parametrize("wrench", [(0, 1, 0), (0, "21/20", 0)])
    def test_near_the_border_a_grasp_within_the_bounds_refutes(self, wrench):
        verdict = solve(self.grasp, wrench)
        found = verdict.robust(degrees=1, friction="5%")
        assert found.answer == "does not hold"
        other = found.counterexample
        assert other.verdict != verdict.verdict
        assert other.verify()
        for old, new in zip(self.grasp, other.grasp, strict=True):
            assert dot(old.normal, new.normal) >= math.cos(math.radians(1))
            assert abs(new.friction - old.friction) <= old.friction / 20

    @pytest.mark.parametrize("seed", range(5))
    def test_random_grasps_within_bounds_do_not_contradict_a_proof(self, seed):
        from equilibrium.decide.robustness import _drawn
        from equilibrium.grasps.inputs import random_grasp, random_wrench

        verdict = solve(random_grasp(4, seed), random_wrench(seed))
        found = verdict.robust(degrees="1/50", friction="1%", stiffness="1%", preload="1%")
        if found:
            for draw in range(100, 110):
                other = _drawn(verdict.grasp, found.bounds, draw)
                assert solve(other, verdict.wrench).stable == verdict.stable

    def test_in_space_a_yes_is_proved_for_all(self):
        spots = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        grasp = Grasp(Contact(p, [-x for x in p], "1/2", preload=1) for p in spots)
        verdict = solve(grasp, ("1/10", 0, 0, 0, 0, "1/10"))
        assert verdict.robust(degrees="1/10", friction="1%").answer == "holds"

    def test_a_proof_in_one_plane_is_none_for_all(self):
        tree = {"plane": [[1, 0, 0], [0, 1, 0]], "tree": [0, 0, 1]}
        assert "one plane" in refuted_within(Grasp(SPATIAL), (0,) * 6, tree, Bounds())

    @pytest.mark.parametrize(
        ("words", "tree"),
        [
            ("does not hold", LEAF),
            ("orthants.7.: the leaf does not hold", ORTHANTS),
            ("splits of states", HALVED),
            ("splits of states", ATTACHMENT),
            ("orthants.7.: splits of states", {"orthants": [ORTHANTS] * 8}),
            ("orthants.7.: splits of states", {"orthants": [ATTACHMENT] * 8}),
        ],
    )
    def test_a_tree_that_does_not_cover_proves_nothing_for_all(self, words, tree):
        problem = refuted_within(ONE, (Fraction(0), Fraction(1), Fraction(0)), tree, Bounds())
        assert re.search(words, problem)

    def test_bad_bounds_exit_with_two(self, capsys):
        for bound in ("degrees", "degrees=x", "degrees=90", "friction=120%", "mass=1"):
            call = ["solve", "paper-three-contacts", "--wrench", "0", "1", "0", "--robust", bound]
            assert code_of(call) == 2
            assert capsys.readouterr().err.count("\n") == 1


#: A rational turn by just below two degrees; tan 1 degree is 0.017455064...
HALF_TURN = Fraction(17455, 10**6)
NEAR = Bounds(degrees=2, length="1/10", friction="5%", stiffness="10%", preload="20%")


def at_the_bounds(source, c):
    """Return a contact at the ends of the bounds `NEAR`, with its tangents turned along."""
    t, axes = source.choice([HALF_TURN, -HALF_TURN, Fraction(0)]), c.tangents
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    way = (1,) if c.dimension == 2 else source.choice([(1, 0), (0, 1), (Fraction(3, 5), "4/5")])
    way = [Fraction(x) for x in way]
    across = [dot(way, column) for column in zip(*axes, strict=True)]
    normal, first = (
        tuple(a * x + b * y + d * z for x, y, z in zip(c.normal, across, axes[0], strict=True))
        for a, b, d in ((cosine, sine, 0), (-sine * way[0], (cosine - 1) * way[0], 1))
    )
    point = [x + source.choice([-1, 1]) * NEAR.length for x in c.point]
    numbers = [
        x * (1 + source.choice([-1, 1]) * share)
        for x, share in (
            (c.friction, NEAR.friction),
            (c.stiffness, NEAR.stiffness),
            (c.preload, NEAR.preload),
        )
    ]
    return Contact(point, normal, *numbers, *([first] if c.dimension == 3 else []))


@pytest.mark.parametrize("dimension", [2, 3])
def test_ranges_hold_all_contacts_within_bounds(dimension):
    source, unit = Random(dimension), 2**192
    for _ in range(60):
        c = random_leaf(source)[0].contacts[0]
        if dimension == 3:
            c = next(iter(Grasp([c]).in_space()))
            c = Contact((*c.point[:2], source.randint(-1, 1)), c.normal, c.friction, 1, 1)
        ranges, other = ranges_of(c, NEAR), at_the_bounds(source, c)
        rows = (other.normal_wrench, *other.tangential_wrenches)
        values = other.friction, other.stiffness, other.preload
        for one, x in zip([*ranges.rows, ranges[1:]], [*rows, values], strict=True):
            for ends, y in zip(one, x, strict=True):
                assert ends.low <= y * unit <= ends.high


def test_a_leaf_that_holds_for_all_holds_for_each():
    source, found = Random("leaves"), Counter()
    for _ in range(500):
        grasp, wrench, leaf, region, _ = random_leaf(source)
        leaf = leaf["virtual_motion"] if isinstance(leaf, dict) else leaf
        whole = [tuple(map(int, g)) for g in region]
        (c,), motion = grasp, tuple(map(Fraction, leaf))
        due = leaf_holds(grasp, wrench, leaf, region, {})
        exact = _holds([ranges_of(c, Bounds())], wrench, motion, whole)
        assert exact <= due
        found[exact, due] += 1
        if _holds([ranges_of(c, NEAR)], wrench, motion, whole):
            found["near"] += 1
            for _ in range(4):
                other = Grasp([at_the_bounds(source, c)])
                assert leaf_holds(other, wrench, leaf, region, {})
    assert found[False, True] < found[True, True] / 4, found
    assert found["near"] > 30, found


FINGERS = [Contact((1, 0), (-1, 0), "1/2"), Contact((-1, 0), (1, 0), "1/2")]
FINGERS = [Contact(c.point, c.normal, c.friction, 1, 1) for c in FINGERS]
FLOOR, SIDE = (
    Contact((0, -1), (0, 1), "1/4", 1, 1),
    Contact((-1, Fraction(1, 2)), (1, 0), 0, 1, 0),
)
SPATIAL = [
    Contact(p, [-x for x in p], "1/2", 1, 1) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))
]
STAY, HELD = (Fraction(0),), (0, "1/2", 0)


@pytest.mark.parametrize(
    ("words", "contacts", "wrench", "bounds", "change"),
    [
        ("", FINGERS, (0, "3/5", 0), {"friction": "10%"}, {}),
        ("", FINGERS, (0, "19/20", 0), {}, {}),
        ("may slip", FINGERS, (0, "19/20", 0), {"friction": "10%"}, {}),
        ("may slip", FINGERS, (0, "19/20", 0), {"preload": "10%"}, {}),
        ("", FINGERS, (0, "4/5", "1/10"), {"length": "1/100"}, {}),
        ("", FINGERS, ("19/10", 0, 0), {"preload": "1%"}, {}),
        ("contact 2 may let go", FINGERS, ("19/10", 0, 0), {"preload": "10%"}, {}),
        ("contact 2 may let go", FINGERS, ("19/10", 0, 0), {"stiffness": "10%"}, {}),
        ("", [*FINGERS, SIDE], ("1/5", 0, 0), {"preload": "5%"}, {}),
        ("contact 3 may touch", [*FINGERS, SIDE], ("1/5", 0, 0), {"preload": "20%"}, {}),
        ("", [FLOOR, *FINGERS], (1, -1, "-1/4"), {"preload": "1%"}, {}),
        ("", [FLOOR, *FINGERS], (-1, -1, "-1/4"), {"preload": "1%"}, {}),
        ("contact 1 may stick", [FLOOR, *FINGERS], ("13/50", -1, "-1/4"), {"preload": "5%"}, {}),
        ("contact 1 may stick", [FLOOR, *FINGERS], ("-13/50", -1, "1/4"), {"preload": "5%"}, {}),
        ("1 may touch", FINGERS, HELD, {}, {"states": (None, STAY), "pillars": ((1, 0),)}),
        ("above 1", FINGERS, (0, 0, 0), {}, {"states": ((Fraction(-11, 10),), STAY)}),
        ("above 1", FINGERS, (0, 0, 0), {}, {"states": (STAY, (Fraction(11, 10),))}),
        ("known to stick", FINGERS, HELD, {}, {"pillars": ((0, 0),)}),
        ("known to stick", FINGERS, HELD, {}, {"states": (STAY, ())}),
        ("2 may stick", FINGERS, HELD, {}, {"states": (STAY, ()), "pillars": ((0, 0),)}),
        ("no box", FINGERS, HELD, {}, {"inverse": ((Fraction(0),) * 5,) * 5}),
        ("", SPATIAL, ("1/10", 0, "1/10", 0, 0, "1/10"), {"friction": "5%"}, {}),
    ],
)  # fmt: skip
def test_an_equilibrium_of_all_is_refused_for_its_fault(words, contacts, wrench, bounds, change):
    grasp = Grasp(contacts)
    verdict = solve(grasp, wrench)
    given = _steady(verdict)._replace(**change)
    problem = resisted_within(grasp, verdict.wrench, given, Bounds(**bounds))
    assert words in problem
    assert bool(problem) == bool(words)


def check(shape, seed):
    """Return what became of a verdict: that of the exact original, or that it is not known."""
    grasp, wrench = original(shape, seed)
    due = solve(grasp, wrench, time_limit=5).verdict
    conversion = converted(grasp, seed)
    assert max(conversion.point_errors) <= Fraction(1, 10**6)
    found = solve(conversion.grasp, wrench, time_limit=5)
    if found.verdict == due:
        return "same"
    if "undecided" in (found.verdict, due):
        return "undecided"
    return found.within_error().verdict


@pytest.mark.parametrize("shape", SHAPES[:4])
def test_converted_grasps_have_the_verdict_of_their_originals(shape):
    for seed in range(8):
        assert check(shape, seed) in ("same", "depends on the rounding"), (shape, seed)


@pytest.mark.campaign
@pytest.mark.parametrize("shape", SHAPES)
def test_a_thousand_converted_grasps_have_the_verdict_of_their_originals(shape):
    counts = {"same": 0, "depends on the rounding": 0, "undecided": 0}
    for seed in range(167):
        counts[check(shape, seed)] += 1
    print(shape, counts)
    assert counts["undecided"] <= 5, counts
