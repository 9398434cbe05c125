"""Conversion keeps incidences, and verdicts are asked again within errors and bounds."""

import itertools
import json
import math
import time
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

from arrangement.numbers import deadline
from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, GraspError, read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.uncertain import Bounds
from equilibrium.decide import robustness
from equilibrium.decide.corners import moved
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import from_float_data, read_csv
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.labels import AS_ROUNDED, DataError
from equilibrium.wrench_sets.line import ends_within_error, resisted_magnitudes

from .converted_grasps import SHAPES, converted, original
from .test_robust_checker import SPATIAL

#: Of searches in space, so that undecided questions end.
NODES = 1000
#: Angles of contacts on a circle, in degrees: no symmetry helps.
ANGLES = [160, 290, 50]


def on_round(radius=0.03, friction=0.0, **options):
    out = [(math.cos(math.radians(a)), math.sin(math.radians(a))) for a in ANGLES]
    points = [[radius * x, radius * y] for x, y in out]
    return from_float_data(points, [[-x, -y] for x, y in out], friction, **options)


def kinds(found):
    return {incidence.kind: incidence for incidence in found.kept}


class TestKept:
    @pytest.mark.parametrize("radius", [0.03, 30.0])
    def test_contacts_on_a_circle_stay_there(self, radius):
        found = on_round(radius)
        circle = kinds(found)["round"]
        assert (circle.contacts, circle.at) == ((0, 1, 2), (0, 0))
        for contact in found.grasp:
            assert contact.point == tuple(-circle.radius * x for x in contact.normal)
        assert max(found.point_errors) <= Fraction(1, 10**6)

    def test_frictionless_disc_rotates_unless_as_given(self):
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

    def test_other_roundings_stay_within_the_error(self):
        found = on_round(preload=[1.0] * 3)
        others = [other_rounding(found.grasp, seed) for seed in range(3)]
        assert len({*others, found.grasp}) == 4
        for other in others:
            assert not solve(other.with_preload(0), (1, 0, 1))
            for old, new in zip(found.grasp, other, strict=True):
                pairs = zip(old.point, new.point, strict=True)
                assert max(abs(x - y) for x, y in pairs) <= Fraction(1, 10**6)


def test_the_error_of_the_data_goes_along_in_files(tmp_path, run):
    path = tmp_path / "disc.json"
    path.write_text(json.dumps(on_round().grasp.to_dict()))
    assert read_grasp(path).data_error.length == Fraction(1, 10**6)
    printed = run("solve {} --wrench 0 0 1", path, code=1)
    assert "not proved for all within the rounding error (4 oth" in printed
    document = run.json("solve {} --wrench 1 -2 0", path, code=3)
    assert document["verdict"] == "depends on the rounding"
    assert document["within_error"]["turned"]["verdict"] == "not resisted"


@pytest.mark.parametrize(
    ("command", "code", "words"),
    [
        (["solve", "--wrench", "0", "0", "1", "--methods"], 3, "depends on the rounding"),
        (
            ["resisted", "--wrench", "0", "0", "1", "--margin", "--tolerance", "1/4"],
            3,
            "yes, for the data as rounded; it depends on",
        ),
        (
            ["resisted", "--slice", "fx", "fy"],
            0,
            "for the data as rounded; not proved for all",
        ),
    ],
)
def test_answers_about_converted_data_say_so(tmp_path, run, command, code, words):
    path = tmp_path / "loose.json"
    path.write_text(json.dumps(on_round(as_given=True).grasp.to_dict()))
    assert words in run(command[0], path, *command[1:], code=code)


def test_what_breaks_incidences_makes_nothing_resisted():
    disc = Solver(on_round().grasp)
    ends = ends_within_error(disc, resisted_magnitudes(disc, (1, -2, "1/100")))
    assert ends.asked > 8
    assert ends.ends == ((0, 0), (0, 0))


JAWS = "paper-four-contacts-preload-1"


def two_pads(*, friction="1/2"):
    """Two pads of two points on each side of an object, 20 N on each point."""
    places = [(x, y) for x in (-1, 1) for y in (-1, 1)]
    return Grasp(
        Contact([Fraction(x, 50), Fraction(y, 100)], [-x, 0], friction, 10000, 20)
        for x, y in places
    )


def floor(*, wall=False, space=False):
    """A box of side 2 on a floor, in the plane at a wall on its right, too."""
    if space:
        corners = itertools.product((-1, 1), repeat=2)
        return Grasp(Contact([*corner, 0], [0, 0, 1], "1/2", 1000) for corner in corners)
    places = [((-1, -1), (0, 1)), ((1, -1), (0, 1))]
    places += [((1, "-1/2"), (-1, 0)), ((1, "1/2"), (-1, 0))] * wall
    return Grasp(Contact(*place, "1/2", 1000) for place in places)


#: Grasps of every day, and the load at the friction limit.
EVERY_DAY = {
    "jaws": (read_grasp(JAWS), (0, 2, 0)),
    "pads": (two_pads(), (0, -40, 0)),
    "pinch": (Grasp([Contact([x, 0], [-x, 0], "1/2", 1, 1) for x in (-1, 1)]), (0, 1, 0)),
    "pinch in space": (read_grasp("two-opposed-fingers"), (0, 0, -1, 0, 0, 0)),
    "fingers in space": (read_grasp("three-fingers-on-a-ball"), (0, 0, -1, 0, 0, 0)),
}


class TestRobust:
    grasp = read_grasp("paper-three-contacts-preload-1")

    @pytest.mark.parametrize("name", EVERY_DAY)
    @pytest.mark.parametrize("share", ["1/20", "1/2", "4/5"])
    def test_everyday_grasps_hold_within_tolerance(self, name, share):
        grasp, most = EVERY_DAY[name]
        wrench = tuple(Fraction(share) * Fraction(x) for x in most)
        found = solve(grasp, wrench).robust(degrees="1/2", friction="10%")
        assert found.answer == "holds"
        report = check(found.certificate.to_dict(), question=(grasp, wrench))
        assert report
        assert (report.kind, report.bounds) == ("resisted", found.bounds)

    @pytest.mark.parametrize("name", ["jaws", "pads"])
    def test_loads_at_the_limit_of_the_least_friction_hold(self, name):
        grasp, most = EVERY_DAY[name]
        for share, answer in ((Fraction(9, 10), "holds"), (Fraction(901, 1000), "does not hold")):
            wrench = tuple(share * x for x in most)
            found = solve(grasp, wrench).robust(friction="10%")
            assert found.answer == answer
        assert (
            solve(grasp, [Fraction(9, 10) * x for x in most])
            .robust(friction="10%")
            .certificate.verify()
        )

    def test_nearest_change_is_small_where_the_limit_is_at_the_data(self):
        """Every share of the way turns the verdict; the search stops at a small one."""
        found = solve(*EVERY_DAY["pinch"]).robust(friction="1/100")
        assert found.answer == "does not hold"
        assert found.change["friction"] == Fraction(1, 200 * 8**4)

    @pytest.mark.parametrize(
        ("grasp", "wrench"),
        [(floor(), (5, -10, 0)), (floor(space=True), (3, 4, -10, 0, 0, 0))],
        ids=["plane", "space"],
    )
    def test_load_at_its_limit_holds_within_bounds_that_leave_it_there(self, grasp, wrench):
        """A share of the preload 0 is 0, so that no other grasp is within the bounds."""
        found = solve(grasp, wrench).robust(preload="10%")
        assert found.answer == "holds"
        assert found.certificate.verify()
        assert solve(grasp, [x * Fraction(1001, 1000) for x in wrench]).verdict == "resisted"
        assert solve(grasp, [*wrench[:1], 5, *wrench[2:]]).verdict == "not resisted"

    @pytest.mark.parametrize("degrees", [1, "1/2", "1/4", "1/10"])
    def test_jaws_hold_a_twentieth_of_their_limit_within_degrees(self, degrees):
        assert solve(read_grasp(JAWS), (0, "1/10", 0)).robust(degrees=degrees)

    @pytest.mark.parametrize("push", ["1/4", "5/2"])
    def test_boxes_on_a_floor_hold_within_tolerance(self, push):
        assert solve(floor(), (push, -10, 0)).robust(degrees="1/2", friction="10%")
        assert solve(floor(wall=True), ("1/4", -10, 0)).robust(degrees="1/2", friction="10%")

    @pytest.mark.parametrize(
        ("weight", "bounds", "answer"),
        [
            (35, {"friction": "10%"}, "holds"),
            *((weight, {"friction": "10%"}, "does not hold") for weight in (37, 38, 39)),
            (44, {"friction": "10%"}, "does not hold"),
            (38, {"degrees": "1/2"}, "holds"),
            (38, {"preload": "10%"}, "does not hold"),
        ],
    )
    def test_pads_near_their_limit_are_decided(self, weight, bounds, answer):
        found = solve(two_pads(), (0, -weight, 0)).robust(**bounds)
        assert found.answer == answer
        if answer != "holds":
            assert found.turned.verify()
            for old, new in zip(two_pads(), found.turned.grasp, strict=True):
                assert abs(new.friction - old.friction) <= old.friction / 10
            # Which changes turn it is known, and the one found is at most a third larger.
            name, per_weight = ("friction", 80) if "friction" in bounds else ("preload", 2)
            due = abs(Fraction(weight, per_weight) - getattr(next(iter(two_pads())), name))
            assert due <= found.change[name] <= Fraction(4, 3) * due
            # Of the way to 1/20: 1/8 and 9/16 turn nothing, 25/32 does, and 43/64 is near enough.
            assert weight != 37 or found.change[name] == Fraction(25, 32) / 20

    @pytest.mark.parametrize(
        ("wrench", "bounds"),
        [
            ((0, "-1/2", 0), {"degrees": "1/2", "friction": "5%"}),
            (("1/8", -1, "1/8"), {"degrees": "1/2", "stiffness": "2%", "preload": "2%"}),
            ((0, -1, 0), {"degrees": 2, "friction": "10%"}),
            ((0, "-1/2", 0), {"degrees": 0}),
            ((0, "-1/2", 0), {"stiffness": "50%", "length": "1/50"}),
        ],
    )
    def test_a_yes_is_proved_for_all(self, wrench, bounds):
        found = solve(self.grasp, wrench).robust(**bounds)
        assert found
        report = check(found.certificate.to_dict(), question=(self.grasp, wrench))
        assert report
        assert (report.kind, report.bounds) == ("resisted", Bounds(**bounds))

    def test_a_no_is_proved_for_all(self):
        grasp = Grasp([Contact([0, -1], [0, 1], "1/2"), Contact([1, -1], [0, 1], "1/2")])
        found = solve(grasp, (0, 1, 0)).robust(degrees=2, friction="5%", length="1/100")
        assert found
        assert found.certificate.verify().kind == "not resisted"

    @pytest.mark.parametrize(
        ("name", "wrench", "degrees", "inner"),
        [("paper-three-contacts-preload-1", (0, 1, 0), 1, False), (JAWS, (0, "99/50", 0), 2, True)],
    )
    def test_near_the_border_a_grasp_within_the_bounds_refutes(self, name, wrench, degrees, inner):
        grasp = read_grasp(name)
        verdict = solve(grasp, wrench)
        found = verdict.robust(degrees=degrees, friction="5%")
        assert found.answer == "does not hold"
        other = found.turned
        assert other.verdict != verdict.verdict
        assert other.verify()
        for old, new in zip(grasp, other.grasp, strict=True):
            assert dot(old.normal, new.normal) >= math.cos(math.radians(degrees))
            assert abs(new.friction - old.friction) <= old.friction / 20
        assert (found.inner is not None) == inner
        if inner:
            report = check(found.to_dict()["holds_within"], question=(grasp, wrench))
            assert report.kind == verdict.verdict
            assert 0 < report.bounds.degrees < degrees
            assert list(found.lines())[-1] == f"resisted for all {report.bounds}: proved"

    def test_a_grasp_that_refutes_by_large_motions_alone_says_so(self):
        found = solve(self.grasp.with_units("m", "N"), (0, 2, 1)).robust(degrees=1)
        assert any("every equilibrium moves" in line for line in found.lines())

    @pytest.mark.parametrize("name", EVERY_DAY)
    def test_random_grasps_within_bounds_do_not_contradict_a_proof(self, name):
        grasp, most = EVERY_DAY[name]
        wrench, source = tuple(Fraction(x) / 2 for x in most), Random(name)
        found = solve(grasp, wrench).robust(degrees=1, friction="5%", stiffness="20%")
        assert found
        for k in range(6):
            ends = [lambda: source.choice([-1, 1]), lambda: source.uniform(-1, 1)][k % 2]
            shares = [[ends() for _ in range(2 * grasp.dimension + 3)] for _ in grasp]
            pairs = zip(grasp, shares, strict=True)
            other = Grasp(moved(c, row, found.bounds) for c, row in pairs)
            assert solve(other, wrench, nodes=NODES).verdict != "not resisted"

    def test_spatial_rest_proved_within_two_degrees(self):
        verdict = solve(read_grasp("three-fingers-on-a-ball"), (0, 0, "-1/2", 0, 0, 0))
        assert verdict.robust(degrees=2, friction="5%")

    def test_in_space_a_yes_and_a_no_are_proved_for_all(self):
        for turn in (0, "1/10"):
            verdict = solve(Grasp(SPATIAL), (0, 0, "1/10", 0, 0, turn))
            assert verdict.robust(friction="5%", degrees="1/100").answer == "holds"
        table = Grasp(Contact([x, y, 0], [0, 0, 1], 1) for x in (-1, 1) for y in (-1, 1))
        lifted = solve(table, (0, 0, 1, 0, 0, 0)).robust(degrees=5, friction="10%", length="1/10")
        assert lifted.answer == "holds"
        assert lifted.certificate.verify().kind == "not resisted"

    def test_without_contacts_both_answers_are_proved(self):
        for wrench, kind in (((0, 1, 0), "not resisted"), ((0, 0, 0), "resisted")):
            assert solve(Grasp(), wrench).robust(degrees=1).certificate.verify().kind == kind

    def test_bounded_or_pyramid_verdict_not_robust(self):
        pyramids = solve(Grasp(SPATIAL), (0, 0, 1, 0, 0, 0), pyramid=4)
        for verdict in (pyramids, solve(self.grasp, (0, 1, 0), max_displacement=1)):
            with pytest.raises(GraspError, match="leave max_displacement and pyramid out"):
                verdict.robust(friction="1%")

    @pytest.mark.parametrize(
        ("dimension", "change"),
        [
            (2, {"preload": 10**300}),
            (3, {"preload": 10**300}),
            (2, {"point": 10**60}),
            (2, {"stiffness": "1e-400"}),
        ],
    )
    def test_numbers_beyond_floats_are_refused_and_no_proof_is_tried(self, dimension, change):
        wanted = {"point": 1, "friction": "1/2", "preload": 0, **change}
        size = wanted.pop("point")
        around = [c.point[:dimension] for c in SPATIAL]
        grasp = Grasp(Contact([size * x for x in p], [-x for x in p], **wanted) for p in around)
        load = (0, 1, *[0] * (3 * dimension - 5))
        with pytest.raises(GraspError, match="other units"):
            solve(grasp, load).robust(degrees=1)
        error = DataError(*[Fraction(1, 10**6)] * 3)
        found = solve(replace(grasp, data_error=error), load).within_error()
        assert (found.verdict, found.asked, found.proved) == ("resisted", 4, False)

    def test_error_of_data_is_a_bound_for_which_a_verdict_is_proved(self):
        pads, load = two_pads(), (0, -20, 0)
        error = DataError(*[Fraction(1, 10**6)] * 3)
        found = solve(replace(pads, data_error=error), load).within_error()
        assert list(found.lines()) == ["resisted for all data within the rounding error: proved"]
        bounds = check(found.certificate.to_dict(), question=(pads, load)).bounds
        assert bounds == robustness._error_bounds(replace(pads, data_error=error))[0]
        assert (bounds.length, bounds.friction) == (error.length, 2 * error.value)
        assert bounds.preload == error.value / 20
        assert bounds.angle == error.angle
        mixed = Grasp(Contact([x, 0], [0, 1], Fraction(1, x)) for x in (2, 4))
        bounds, every = robustness._error_bounds(replace(mixed, data_error=error))
        assert (bounds.friction, bounds.preload, every) == (4 * error.value, error.value, True)
        # Friction of 1/2 with an error of 1/2 may be 0, which no bounds have.
        for wide in ({"value": Fraction(1, 2)}, {"angle": Fraction(1)}):
            data = replace(pads, data_error=replace(error, **wide))
            bounds, every = robustness._error_bounds(data)
            assert not every
            assert (bounds.degrees == 45) == ("angle" in wide)

    @pytest.mark.parametrize("scale", [Fraction(1, 10**9), 10**9])
    def test_answers_do_not_change_with_units(self, scale):
        grasp = Grasp(
            Contact(
                [scale * x for x in c.point], c.normal, c.friction, c.stiffness / scale, c.preload
            )
            for c in two_pads()
        )
        assert solve(grasp, (0, -20, 0)).robust(degrees="1/2", friction="10%")

    def test_the_proof_is_written_and_read_back(self, tmp_path, run):
        proof = str(tmp_path / "proof.json")
        asked = ["--wrench", "0", "1/2", "0"]
        wanted = ["--robust", "degrees=1/2", "friction=5%"]
        assert "proof for all" in run("solve", JAWS, *asked, *wanted, "--certificate", proof)
        printed = run("verify {} --grasp", proof, JAWS, *asked)
        assert "for all normals within 0.5 degrees, friction within" in printed
        assert run.json("verify", proof)["bounds"]["degrees"] == "1/2"

    def test_the_time_limit_ends_the_search(self, run, monkeypatch):
        now = itertools.count()
        monkeypatch.setattr(deadline, "clock", lambda: next(now))
        asked = ["solve", JAWS, "--wrench", "0", "39/20", "0", "--robust", "degrees=1"]
        assert "undecided; time limit of 2 s" in run(*asked, "--time-limit", "2", code=3)

    def test_the_time_limit_ends_questions_within_the_error_of_data(
        self, run, monkeypatch, tmp_path
    ):
        path = tmp_path / "disc.json"
        path.write_text(json.dumps(on_round().grasp.to_dict()))
        asked = ["solve", str(path), "--wrench", "0", "0", "1", "--time-limit"]
        found = run.json(*asked, "9", code=1)["within_error"]
        assert found["asked"] == 4
        assert "reason" not in found
        now = itertools.count()
        monkeypatch.setattr(deadline, "clock", lambda: next(now))
        late = solve(read_grasp(path), (0, 0, 1), time_limit=10**6)
        next_look = next(now)
        now = itertools.count(next_look + 10**6)
        assert late.answer == f"not resisted {AS_ROUNDED}"
        assert late.within_error().asked == 0
        assert late.within_error().reason == "time limit of 1e+06 s"
        lines = list(late.within_error().lines())
        assert lines[0].endswith("(0 others tried; time limit of 1e+06 s)")
        assert late.to_dict()["within_error"]["reason"] == "time limit of 1e+06 s"

    @pytest.mark.parametrize("pace", [Fraction(1, 100), 100])
    def test_answers_do_not_depend_on_the_clock(self, pace, monkeypatch):
        start = time.monotonic()
        monkeypatch.setattr(time, "process_time", lambda: (time.monotonic() - start) * float(pace))
        monkeypatch.setattr(deadline, "clock", time.process_time)
        answers = [
            solve(read_grasp(JAWS), (0, load, 0)).robust(degrees=1, friction="10%").answer
            for load in ("1/10", "19/10", "39/20")
        ]
        assert answers == ["holds", "does not hold", "does not hold"]


def became(shape, seed):
    """Return what became of a verdict: that of the exact original, or that it is not known."""
    grasp, wrench = original(shape, seed)
    due = solve(grasp, wrench, nodes=NODES).verdict
    conversion = converted(grasp, seed)
    assert max(conversion.point_errors) <= Fraction(1, 10**6)
    found = solve(conversion.grasp, wrench, nodes=NODES)
    if found.verdict == due:
        return "same"
    if "undecided" in (found.verdict, due):
        return "undecided"
    return found.within_error().verdict


@pytest.mark.parametrize(
    ("shape", "seeds", "undecided"),
    [
        *((shape, range(4), 0) for shape in SHAPES[:4]),
        *(pytest.param(shape, range(8, 14), 1, marks=pytest.mark.slow) for shape in SHAPES),
    ],
)
def test_converted_grasps_have_the_verdict_of_their_originals(shape, seeds, undecided):
    counts = {"same": 0, "depends on the rounding": 0, "undecided": 0}
    for seed in seeds:
        counts[became(shape, seed)] += 1
    assert counts["undecided"] <= undecided, counts
