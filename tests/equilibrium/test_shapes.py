"""Shapes that touch: contacts that follow from discs, spheres, polygons, walls; textbook cases."""

import json
import math
import random
import re
from fractions import Fraction
from itertools import accumulate, combinations, pairwise, product

import pytest

from arrangement.errors import InputError
from arrangement.numbers.expressions import read_expression
from arrangement.numbers.functions import Domain, Span
from equilibrium import (
    Circle,
    Contact,
    Grasp,
    ResistedSet,
    read_grasp,
    resisted_values,
    solve,
    verify,
)
from equilibrium.grasps.inputs import read_shapes
from equilibrium.grasps.inputs.documents import read_assembly
from equilibrium.grasps.inputs.shapes_letter import WORDS, shapes_with_letter
from equilibrium.grasps.schemas import assembly_schema, grasp_schema, shapes_schema
from equilibrium.model.assembly import Assembly, BodyContact, RigidBody
from equilibrium.model.outline import Segments, Sphere, read_outline
from equilibrium.model.parameter import ParametricQuestion, deep
from tests.schemas import validator

SCHEMA = validator(shapes_schema())
#: Rational unit vectors.
UNITS = [
    (sx * x, sy * y)
    for a, b, c in ((3, 4, 5), (5, 12, 13), (8, 15, 17), (0, 1, 1))
    for x, y in ((Fraction(a, c), Fraction(b, c)), (Fraction(b, c), Fraction(a, c)))
    for sx in (1, -1)
    for sy in (1, -1)
]


SPATIAL = [
    tuple(Fraction(s * x, 3) for s, x in zip(sides, sizes, strict=True))
    for sizes in ((1, 2, 2), (2, 1, 2), (2, 2, 1))
    for sides in product((1, -1), repeat=3)
]


def ball(centre, radius):
    return {"sphere": {"centre": list(map(str, centre)), "radius": str(radius)}}


def disc(name, x, y, radius, **more):
    circle = {"centre": [str(x), str(y)], "radius": str(radius)}
    return {"name": name, "circle": circle, **{key: str(value) for key, value in more.items()}}


def walls(*points, name="ground"):
    segments = [[list(map(str, a)), list(map(str, b))] for a, b in pairwise(points)]
    return {"name": name, "segments": segments}


def document(bodies, ground=(), friction="0", **more):
    known = {"schema_version": 1, "bodies": bodies, "ground": list(ground), "friction": friction}
    return known | more


def forces(read):
    """The normal forces of the equilibrium under the weights."""
    wrenches = read.subject.weights if read.wrenches is None else read.wrenches
    verdict = solve(read.subject, wrenches)
    assert verdict.verify()
    return verdict.verdict, [share[0] for share in verdict.forces]


class TestTextbookCases:
    def test_three_spheres_in_a_box(self):
        """Radii 4, 6, 5, weights 15, 40, 20, width 18: 80 at the wall, 100 between the lower two.

        Source: a usual exercise of engineering mechanics, "three cylinders are piled up in a
        rectangular channel" of width 18 cm; the forces are 20 * 11 / 8.4853, 60 / 0.6 and 80.
        """
        bodies = [
            disc("A", 4, 4, 4, weight=15),
            disc("B", 12, 10, 6, weight=40),
            disc("C", 5, "18.4853", 5, weight=20),
        ]
        box = walls((0, 26), (0, 0), (18, 0), (18, 26))
        read = read_shapes(document(bodies, [box], gap="1/1000"))
        verdict, (lower, wall, floor, upper, *_) = forces(read)
        assert verdict == "resisted"
        assert (lower, wall, floor) == (100, 80, 75)
        assert abs(upper - 220 / Fraction("8.4852813742")) < Fraction(1, 10**4)
        assert [name for name, x in zip("ABC", read.found.moves, strict=True) if x] == ["C"]
        assert read.remarks[0].startswith("within the gap, not exactly: 1 of 6 contacts")

    @pytest.mark.parametrize(("weight", "verdict"), [("3/4", True), ("0.7499999", False)])
    def test_tube_with_two_balls_tips(self, weight, verdict):
        """A tube of radius R around two balls of radius r and weight w tips below 2 w (1 - r / R).

        Source: perplexus.info, problem 3245, "it tips over if U (2 r - w) > T (r + t)": balls whose
        diameters have the sum w = 2 here, U = 1, inner radius r = 8/5, thickness t = 0.
        """
        tube = walls(("-1.6", 0), ("-1.6", 5), name="tube")
        tube["segments"] += walls(("1.6", 0), ("1.6", 5))["segments"]
        tube |= {"weight": weight, "centre": ["0", "5/2"]}
        balls = [disc("low", "-0.6", 1, 1, weight=1), disc("high", "0.6", "2.6", 1, weight=1)]
        read = read_shapes(document([tube, *balls], [walls((-4, 0), (4, 0))]))
        assert read.remarks == []
        assert (forces(read)[0] == "resisted") is verdict

    @pytest.mark.parametrize(
        ("tension", "cosine", "verdict"),
        [("25/13", "3/5", True), ("1.9231", "3/5", False), ("1", "0.6001", False)],
    )
    def test_spool_on_its_thread(self, tension, cosine, verdict):
        """The thread that leaves the hub downwards stops the spool where it points at the contact.

        The angle to the floor has the cosine r / R, and friction mu holds up to a tension of
        mu W / (cos + mu sin). Source: Berkeley physics demonstrations, "static equilibrium of a
        spool": sin(theta) = R1 / R2 from the vertical.
        """
        c = Fraction(cosine)
        s = Fraction(4, 5) if c == Fraction(3, 5) else (1 - c * c) / Fraction("0.8")
        thread = {
            "body_a": "spool",
            "point": ["12/5", "16/5"],
            "body_b": None,
            "to": [str(Fraction(12, 5) + 8 * c), str(Fraction(16, 5) + 8 * s)],
            "tension": tension,
            "stiffness": "0",
        }
        read = read_shapes(
            document(
                [disc("spool", 0, 5, 5, weight=5)],
                [walls((-8, 0), (8, 0))],
                "1/3",
                threads=[thread],
            )
        )
        assert (forces(read)[0] == "resisted") is verdict

    def test_cylinder_in_a_corner(self):
        """Friction mu at wall and floor holds a couple of mu (1 + mu) / (1 + mu^2) W r.

        The floor bears n and the wall mu n with n + mu^2 n = W, both with friction at its limit.
        """
        corner = walls((0, 3), (0, 0), (3, 0))
        read = read_shapes(document([disc("cylinder", 1, 1, 1, weight=1)], [corner], "1/3"))
        along = ResistedSet(read.subject).along({"cylinder": [0, 0, 1]}, read.subject.weights)
        assert along.intervals == ((0, Fraction(2, 5)),)

    def test_ball_on_three_balls(self):
        """Each of the lower ones bears W / (3 cos), with cos = sqrt(2/3) to the vertical."""
        base = [("1.154700538", "0"), ("-0.577350269", "1"), ("-0.577350269", "-1")]
        balls = [{"sphere": {"centre": [x, y, "0"], "radius": "1"}} for x, y in base]
        top = {"sphere": {"centre": ["0", "0", "1.632993162"], "radius": "1"}}
        known = {"schema_version": 1, "body": top, "ground": balls, "friction": "0", "gap": "1e-6"}
        SCHEMA.validate(known)
        grasp = read_shapes(known).subject
        assert isinstance(grasp.outline, Sphere)
        verdict = solve(grasp, [0, 0, -1, 0, 0, 0])
        assert verdict.stable
        assert verdict.verify()
        due = 1 / (3 * (2 / 3) ** 0.5)
        assert all(abs(float(share[0]) - due) < 1e-5 for share in verdict.forces)


def expected(scene):
    """Contacts of a scene by a second computation: nearest points of clamped segments, exactly.

    Returns bodies, point and normal of each, with the normal into the first body.
    """
    found = set()
    discs = {row["name"]: row["circle"] for row in scene["bodies"]}
    discs = {
        name: ([Fraction(x) for x in c["centre"]], Fraction(c["radius"]))
        for name, c in discs.items()
    }
    for (one, (c, r)), (other, (d, s)) in combinations(discs.items(), 2):
        square = sum((x - y) ** 2 for x, y in zip(c, d, strict=True))
        if square == (r + s) ** 2:
            normal = tuple((x - y) / (r + s) for x, y in zip(c, d, strict=True))
            point = tuple((s * x + r * y) / (r + s) for x, y in zip(c, d, strict=True))
            found.add((one, other, point, normal))
    for row in scene["ground"]:
        for name, (c, r) in discs.items():
            for a, b in [[[Fraction(x) for x in end] for end in pair] for pair in row["segments"]]:
                along = [y - x for x, y in zip(a, b, strict=True)]
                share = sum(u * (x - y) for u, x, y in zip(along, c, a, strict=True))
                share = min(max(share / sum(u * u for u in along), Fraction(0)), Fraction(1))
                foot = tuple(x + share * u for x, u in zip(a, along, strict=True))
                if sum((x - y) ** 2 for x, y in zip(c, foot, strict=True)) == r * r:
                    normal = tuple((x - y) / r for x, y in zip(c, foot, strict=True))
                    found.add((name, None, foot, normal))
    return found


def random_scene(source):
    """Discs one on the other, with walls that touch them inside or at an end, without overlap."""
    friction = Fraction(source.randint(0, 10), 10)
    while True:
        bodies, lines, centre, radius = [], [], (Fraction(0), Fraction(0)), Fraction(0)
        for k in range(source.randint(1, 4)):
            n, more = source.choice(UNITS), Fraction(source.randint(1, 8), source.randint(2, 6))
            step = radius + more if k else Fraction(0)
            centre = tuple(x + step * y for x, y in zip(centre, n, strict=True))
            radius = more
            weight = source.randint(0, 5)
            bodies.append(disc("abcd"[k], *centre, radius, weight=weight))
            for _ in range(source.randint(0, 2)):
                x, y = source.choice(UNITS)
                left, right = source.randint(0, 3), source.randint(1, 3)
                foot = (centre[0] - radius * x, centre[1] - radius * y)
                ends = [
                    (foot[0] + t * y, foot[1] - t * x)
                    for t in (-Fraction(left, 2), Fraction(right))
                ]
                lines += walls(*ends)["segments"]
        ground = [{"name": "ground", "segments": lines}] if lines else []
        scene = document(bodies, ground, str(friction))
        try:
            return scene, read_shapes(scene)
        except InputError:
            continue  # shapes overlap


def moved_a_little(scene, source, bound):
    """The scene with decimals: each centre off by at most a bound in each coordinate."""
    rows = []
    for row in scene["bodies"]:
        centre = [Fraction(x) + bound * source.randint(-8, 8) / 8 for x in row["circle"]["centre"]]
        rows.append(
            row | {"circle": row["circle"] | {"centre": [f"{float(x):.9f}" for x in centre]}}
        )
    return scene | {"bodies": rows}


def distance(one, other):
    """How far apart points and normals of two contacts are; far, if they are of other bodies."""
    if (one.body_a, one.body_b) != (other.body_a, other.body_b):
        return Fraction(100)
    pairs = zip(
        (*one.contact.point, *one.contact.normal),
        (*other.contact.point, *other.contact.normal),
        strict=True,
    )
    return max(abs(x - y) for x, y in pairs)


class TestRandomScenes:
    def test_contacts_are_those_of_a_second_computation(self):
        source = random.Random(55)
        for _ in range(500):
            scene, read = random_scene(source)
            made = {
                (c.body_a, c.body_b, c.contact.point, c.contact.normal)
                for c in read.subject.contacts
            }
            assert len(made) == len(read.subject.contacts)
            assert made == expected(scene)
            assert read.remarks == []

    def test_decimals_keep_contacts_and_incidences(self):
        """Lines of force meet both centres and arms of friction are radii, exactly."""
        source, bound = random.Random(56), Fraction(1, 10**5)
        rounded = 0
        for _ in range(300):
            scene, exact = random_scene(source)
            near = moved_a_little(scene, source, bound)
            read = read_shapes(near, gap=6 * bound)
            rounded += bool(read.remarks)
            assert not any(read.found.misses)
            radii = {body.name: body.outline.radius for body in read.subject.bodies}
            left = list(exact.subject.contacts)
            for new in read.subject.contacts:
                old = min(left, key=lambda old, new=new: distance(old, new))
                left.remove(old)
                assert distance(old, new) < 100 * bound
                (x, y), n = new.contact.point, new.contact.normal
                for name in filter(None, (new.body_a, new.body_b)):
                    c = read.found.centres[name]
                    assert (x - c[0]) * n[1] == (y - c[1]) * n[0]
                c, r = read.found.centres[new.body_a], radii[new.body_a]
                assert (x - c[0], y - c[1]) == (-r * n[0], -r * n[1])
            assert not left
        assert rounded > 200

    def test_verdicts_are_those_of_contacts_by_hand(self):
        source, seen, bound = random.Random(57), set(), Fraction(1, 10**7)
        for _ in range(200):
            scene, read = random_scene(source)
            bodies = [RigidBody(row["name"]) for row in scene["bodies"]]
            contacts = [
                BodyContact(a, b, Contact(point, normal, scene["friction"]))
                for a, b, point, normal in expected(scene)
            ]
            weights = read.subject.weights
            verdict = solve(Assembly(bodies, contacts), weights).verdict
            assert solve(read.subject, weights).verdict == verdict
            near = read_shapes(moved_a_little(scene, source, bound), gap=6 * bound).subject
            assert solve(near, near.weights).verdict == verdict
            seen.add(verdict)
        assert seen >= {"resisted", "not resisted"}

    def test_spheres_touch_planes_and_spheres(self):
        """A sphere among others at known places; decimals keep the normals through its centre."""
        source, bound, made = random.Random(58), Fraction(1, 10**6), 0
        for _ in range(300):
            centre = [Fraction(source.randint(-9, 9), 4) for _ in range(3)]
            radius, ground, due = Fraction(source.randint(1, 9), 3), [], set()
            for n in source.sample(SPATIAL, source.randint(1, 4)):
                foot = [c - radius * x for c, x in zip(centre, n, strict=True)]
                due.add((tuple(foot), n))
                if source.random() < 0.5:
                    length = source.randint(1, 5)
                    normal = [str(length * x) for x in n]
                    ground.append({"plane": {"point": list(map(str, foot)), "normal": normal}})
                else:
                    reach = Fraction(source.randint(1, 9), 4)
                    place = [c - (radius + reach) * x for c, x in zip(centre, n, strict=True)]
                    ground.append(ball(place, reach))
            known = {"schema_version": 1, "friction": "1/2", "ground": ground}
            read = read_shapes(known | {"body": ball(centre, radius)})
            made += 1
            assert {(c.point, c.normal) for c in read.subject} == due
            near = [x + bound * source.randint(-4, 4) for x in centre]
            again = read_shapes(known | {"body": ball(near, radius)}, gap=8 * bound).subject
            assert len(again) == len(due)
            for c in again:
                assert all(
                    x - p == radius * n for x, p, n in zip(near, c.point, c.normal, strict=True)
                )
                error = min(
                    max(abs(x - y) for x, y in zip(c.normal, n, strict=True)) for _, n in due
                )
                assert error < 100 * bound
        assert made == 300


class TestPlaces:
    def test_rings_and_rows_of_equal_discs_meet_all_centres(self):
        ring = [(2, 0), (1, "1.7320508"), (-1, "1.7320508")]
        ring += [(-2, 0), (-1, "-1.7320508"), (1, "-1.7320508")]
        rows = [(2 * i + j, Fraction("1.7320508") * j) for j in range(4) for i in range(4 - j)]
        for places in (ring, [*ring, (0, 0)], rows):
            discs = [disc(f"d{k}", *place, 1) for k, place in enumerate(places)]
            found = read_shapes(document(discs), gap="1e-6").found
            assert not any(found.misses)
            assert list(found.centres) == [entry["name"] for entry in discs]
            assert max(found.moves) < Fraction(1, 10**4)

    def test_centres_that_no_rounding_joins_are_reported(self):
        """Six unequal discs around a seventh: twelve lines fix more than seven centres."""
        radii = [1.0, 1.1, 0.9, 1.05, 0.95]

        def angles(last):
            """The angles at the hub, of radius 1, between neighbours on the rim."""
            rim = [*radii, last]
            for r, s in zip(rim, rim[1:] + rim[:1], strict=True):
                a, b, c = 1 + r, 1 + s, r + s
                yield math.acos((a * a + b * b - c * c) / (2 * a * b))

        low, high = 0.1, 3.0
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if sum(angles(middle)) < 2 * math.pi else (low, middle)
        turns = [0.0, *accumulate(angles(low))]
        discs = [disc("hub", 0, 0, 1)] + [
            disc(f"d{k}", f"{(1 + r) * cosine:.9f}", f"{(1 + r) * sine:.9f}", f"{r:.9f}")
            for k, r in enumerate([*radii, low])
            for cosine, sine in [(math.cos(turns[k]), math.sin(turns[k]))]
        ]
        read = read_shapes(document(discs), gap="1e-6")
        assert len(read.found.contacts) == 12
        assert 0 < max(read.found.misses) < Fraction(1, 10**5)
        assert read.remarks[-1].startswith("line of force beside the second centre: 1 of 12")


class TestShapes:
    def test_corners_count_where_no_edge_is_nearer(self):
        post = {"polygon": [["-1", "-2"], ["1", "-2"], ["1", "-1"], ["-1", "-1"]]}
        on_corner = disc("d", "1.6", "-0.2", 1)
        on_edge = disc("d", "0.9", 0, 1)
        for body, normal in ((on_corner, ("3/5", "4/5")), (on_edge, (0, 1))):
            read = read_shapes(document([body], [post]))
            assert [c.contact.normal for c in read.subject.contacts] == [
                tuple(map(Fraction, normal))
            ]

    def test_polygon_on_disc_and_on_wall(self):
        block = {"name": "block", "polygon": [["-1", "2"], ["1", "2"], ["1", "3"], ["-1", "3"]]}
        shelf = walls((1, 1), (1, 5))
        read = read_shapes(document([block], [disc("roller", 0, 1, 1), shelf], "1/2"))
        assert {(c.contact.point, c.contact.normal) for c in read.subject.contacts} == {
            ((0, 2), (0, 1)), ((1, 3), (-1, 0)), ((1, 2), (-1, 0))
        }  # fmt: skip
        assert all(c.body_a == "block" for c in read.subject.contacts)

    def test_sphere_on_planes_and_spheres(self):
        plane = {"plane": {"point": ["0", "0", "-2"], "normal": ["0", "0", "3"]}}
        side = {"plane": {"point": ["0", "0", "-1"], "normal": ["2", "1", "2"]}}
        ball = {"sphere": {"centre": ["0", "0", "1/2"], "radius": "1"}}
        post = {"sphere": {"centre": ["3/2", "0", "5/2"], "radius": "3/2"}}
        known = {"schema_version": 1, "body": ball, "ground": [plane, side, post], "friction": "1"}
        contacts = read_shapes(known).subject.contacts
        assert [c.normal for c in contacts] == [
            tuple(Fraction(x, 3) for x in (2, 1, 2)), (Fraction(-3, 5), 0, Fraction(-4, 5))
        ]  # fmt: skip

    def test_pairs_and_densities_and_forces(self):
        block = {"name": "block", "polygon": [["1", "0"], ["3", "0"], ["3", "2"], ["1", "2"]]}
        block |= {"density": "2", "force": ["1", "0"]}
        known = document(
            [disc("ball", 0, 1, 1, weight=3), block],
            [walls((-4, 0), (4, 0), name="floor")],
            "1/2",
            pairs=[
                {"shapes": ["floor", "ball"], "friction": "1/4", "preload": "1"},
                {"shapes": ["ball", "floor"], "preload": "2"},
            ],
            wrench={"ball": ["0", "0", "1"]},
        )
        SCHEMA.validate(known)
        read = read_shapes(known)
        assert [(c.pair, c.contact.friction, c.contact.preload) for c in read.subject.contacts] == [
            ("ball on block", Fraction(1, 2), 0),
            ("ball on the ground", Fraction(1, 4), 2),
            ("block on the ground", Fraction(1, 2), 0),
            ("block on the ground", Fraction(1, 2), 0),
        ]
        assert read.wrenches == {"ball": (0, -3, 1), "block": (1, -8, -17)}

    def test_thread_between_bodies_pulls_both(self):
        ends = {"point": ["0", "1"], "to": ["4", "4"], "tension": "5", "stiffness": "2"}
        thread = {"body_a": "low", "body_b": "high", **ends}
        read = read_shapes(
            document([disc("low", 0, 0, 1), disc("high", 4, 5, 1)], threads=[thread])
        )
        (pull,) = read.subject.contacts
        assert pull.contact == Contact([0, 1], ["4/5", "3/5"], 0, 2, 5)
        assert pull.contact.thread == (4, 4)
        assert read_shapes(document([disc("low", 0, 0, 1)], threads=[
            {**thread, "body_b": None, "to": ["1", "2"]}
        ])).remarks[0].startswith("direction rounded, in radians: threads[0]")  # fmt: skip

    @pytest.mark.parametrize(
        ("changes", "words"),
        [
            ({"bodies": [disc("a", 0, "0.9", 1)]}, "a and ground overlap"),
            ({"bodies": [disc("a", 0, 1, 1), disc("b", "1.5", 1, 1)]}, "a and b overlap"),
            ({"bodies": [disc("a", 0, 1, 0)]}, "must be above 0"),
            ({"bodies": [{"circle": {"centre": [0, 1], "radius": 1}}]}, "give each body a name"),
            ({"bodies": [disc("a", 0, 1, 1), disc("a", 9, 1, 1)]}, "there twice"),
            ({"bodies": [disc("ground", 0, 1, 1)]}, "the name 'ground' of a body"),
            ({"bodies": [{"name": "a"}]}, "has 0 forms"),
            ({"bodies": [disc("a", 0, 1, 1) | {"polygon": []}]}, "has 2 forms"),
            ({"bodies": [disc("a", 0, 1, 1, density=1)]}, "of no polygon"),
            ({"bodies": [{"name": "a", "sphere": {"centre": [0, 1], "radius": 1}}]}, "expected 3"),
            ({"gap": "-1"}, "at least 0"),
            ({"gap": "1"}, "below the least radius"),
            ({"friction": None}, "friction"),
            ({"pairs": [{"shapes": ["a", "c"]}]}, "expected two of the shapes a, ground"),
            ({"pairs": [{"shapes": ["a"]}]}, "expected 2"),
            ({"threads": [{"body_a": "a", "body_b": "c", "point": [0, 0], "to": [1, 0]}]}, "null"),
            (
                {"threads": [{"body_a": [], "body_b": None, "point": [0, 0], "to": [1, 0]}]},
                "a body",
            ),
            ({"threads": [{"body_a": "a", "body_b": None, "point": [0, 0], "to": [0, 0]}]}, "two"),
            ({"wrench": {"c": [0, 0, 0]}}, "unknown key"),
            ({"ground": [walls((0, 0), (0, 0))]}, "two ends that differ"),
            ({"ground": [{"plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}}]}, "in space"),
            ({"ground": [{"plane": {"point": [0, 0, 0], "normal": [0, 0, 0]}}]}, "is 0"),
            ({"contacts": []}, "unknown key"),
        ],
    )
    def test_damaged_documents_are_refused(self, changes, words, tmp_path, run):
        known = document([disc("a", 0, 1, 1)], [walls((-4, 0), (4, 0))]) | changes
        path = tmp_path / "shapes.json"
        path.write_text(json.dumps(known), encoding="utf-8")
        out, err = run("make shapes", path, code=2), run.err
        assert not out
        assert words in err
        assert err.count("\n") == 1

    def test_walls_that_cross_are_refused(self):
        tube = walls((0, -1), (0, 1), name="tube")
        with pytest.raises(InputError, match="crosses"):
            read_shapes(document([tube], [walls((-4, 0), (4, 0))]))


TABLE = """body,x,y,radius,x2,y2,weight
# two discs and a block on the floor
ball,0,1,1,,,2
,-4,0,,9,0,
block,3,0,,,,5
block,5,0,,,,
block,5,2,,,,
block,3,2,,,,
disc,2,1,1,,,1
,9,0,,9,3,
"""


class TestFiles:
    def test_table_means_its_document(self, tmp_path):
        path = tmp_path / "shapes.csv"
        path.write_text(TABLE, encoding="utf-8")
        block = {"name": "block", "polygon": [[3, 0], [5, 0], [5, 2], [3, 2]], "weight": 5}
        known = document(
            [disc("ball", 0, 1, 1, weight=2), block, disc("disc", 2, 1, 1, weight=1)],
            [walls((-4, 0), (9, 0), (9, 3))],
        )
        SCHEMA.validate(known)
        made, read = read_shapes(known), read_shapes(path, friction=0)
        assert made.to_dict()["contacts"] == read.to_dict()["contacts"]
        assert made.to_dict()["bodies"] == read.to_dict()["bodies"]
        with pytest.raises(InputError, match="there is no friction of ball and"):
            read_shapes(path)

    def test_table_in_space_is_a_grasp(self, tmp_path):
        path = tmp_path / "ball.csv"
        text = "body,x [cm],y [cm],z [cm],radius [cm],normal_x,normal_y,normal_z,weight [N]\n"
        path.write_text(text + "ball,0,0,1,1,,,,\n,0,0,0,,0,0,1,\n", encoding="utf-8")
        grasp = read_shapes(path, friction="1/2").subject
        assert grasp == Grasp([Contact([0, 0, 0], [0, 0, 1], "1/2")])
        assert str(grasp.units) == "lengths in cm, forces in N, torques in N cm"

    @pytest.mark.parametrize(
        ("old", "new", "words"),
        [
            ("ball,0,1,1,,,2", "ball,0,1,1,3,,2", "line 3 has the entries radius, x2"),
            ("radius", "size", "the column 'size' is unknown"),
            ("body,", "x,", "there twice"),
            ("ball,0,1,1,,,2", "ball,,1,1,,,2", "not an exact number"),
            ("disc,2", "ball,20", "there twice"),
            ("weight", "weight [N],y [cm]", "there twice"),
        ],
    )
    def test_damaged_tables_are_refused(self, old, new, words, tmp_path, refused):
        path = tmp_path / "shapes.csv"
        path.write_text(TABLE.replace(old, new, 1), encoding="utf-8")
        assert words in refused("make shapes {} --friction 1", path)

    def test_made_files_are_read_back(self, tmp_path, run):
        path, made = tmp_path / "shapes.json", tmp_path / "made.json"
        thread = {"body_a": "a", "body_b": None, "point": ["1", "1"], "to": ["4", "5"]}
        scene = document([disc("a", 0, 1, 1, weight=1)], [walls((-4, 0), (4, 0))], threads=[thread])
        path.write_text(json.dumps(scene), encoding="utf-8")
        run("make shapes {} -o", path, made)
        assert not run.err
        written = json.loads(made.read_text(encoding="utf-8"))
        validator(assembly_schema()).validate(written)
        assembly = read_assembly(made)
        assert assembly.to_dict() == written
        assert assembly.ground == (Segments([[(-4, 0), (4, 0)]]),)
        assert assembly.contacts[1].contact.thread == (4, 5)
        verdict = solve(assembly, assembly.weights)
        assert verify(verdict)
        assert "thread" not in verdict.certificate.text
        assert "ground" not in verdict.proof["assembly"]

    def test_grasp_of_one_body_keeps_circle_and_thread(self, tmp_path):
        body = {"circle": {"centre": ["0", "0"], "radius": "1"}}
        thread = {"point": ["0", "1"], "to": ["0", "3"], "tension": "2"}
        ground = [walls((-4, -1), (4, -1))]
        known = {"schema_version": 1, "body": body, "ground": ground, "friction": "1/2"}
        grasp = read_shapes(known | {"threads": [thread]}).subject
        assert grasp.outline == Circle([0, 0], 1)
        validator(grasp_schema()).validate(grasp.to_dict())
        again = Grasp.from_dict(grasp.to_dict())
        assert again.to_dict() == grasp.to_dict()
        grasp.save(tmp_path / "grasp.json")
        assert read_grasp(tmp_path / "grasp.json").contacts[1].thread == (0, 3)
        with pytest.raises(InputError, match="has a thread"):
            grasp.with_outline(None).save(tmp_path / "grasp.csv")

    def test_outlines_round_trip(self):
        for outline in (Sphere([0, 1, 2], 3), Segments([[(0, 0), (1, 0)]])):
            assert read_outline(outline.to_dict()) == outline
        with pytest.raises(InputError, match="in the plane"):
            RigidBody("a", Sphere([0, 0, 0], 1))

    def test_pictures_show_walls_and_threads(self, tmp_path, run):
        thread = {"body_a": "a", "body_b": None, "point": ["1", "1"], "to": ["4", "5"]}
        scene = document(
            [disc("a", 0, 1, 1, weight=1)], [walls((-99, 0), (99, 0))], threads=[thread]
        )
        read_shapes(scene).subject.save(tmp_path / "a.json")
        run("draw {} -o", tmp_path / "a.json", tmp_path / "a.svg")
        text = (tmp_path / "a.svg").read_text(encoding="utf-8")
        assert 'id="thread-2"' in text
        assert 'id="outline-ground-1"' in text
        assert 'id="pad-1"' in text


STEP = "10*t^2/(1+t^2)"
WHEEL = document(
    [disc("wheel", 0, 5, 5, weight=4)],
    [
        walls((-9, 0), (2, 0), name="floor"),
        {
            "name": "step",
            "polygon": [["10*t/(1+t^2)", 0], [9, 0], [9, STEP], ["10*t/(1+t^2)", STEP]],
        },
    ],
    "1",
    threads=[
        {
            "body_a": "wheel",
            "point": [0, 5],
            "body_b": None,
            "to": [12, 5],
            "tension": 3,
            "stiffness": 0,
        }
    ],
)
COSINE, SINE = "(1-t^2)/(1+t^2)", "2*t/(1+t^2)"
#: Two balls in a tube, and a disc on a slope; a block on the ground.
TUBE = document(
    [
        {"name": "tube", "weight": "t", "centre": [0, 2]}
        | {"segments": [[[f"{s}1{s}{COSINE}", y] for y in (0, 5)] for s in "-+"]},
        disc("low", f"-{COSINE}", 1, 1, weight=1),
        disc("high", COSINE, f"1+2*{SINE}", 1, weight="2*t"),
    ],
    [walls((-4, 0), (4, 0))],
    pairs=[{"shapes": ["low", "high"], "friction": "t/9"}],
)
SLOPE = document(
    [
        disc("disc", f"-3*({SINE})", f"3*({COSINE})", 3, weight=1),
        {"name": "block", "polygon": [[9, "-t"], [10, "-t"], [10, 0], [9, 0]], "weight": "t"},
    ],
    [
        walls((f"-9*({COSINE})", f"-9*({SINE})"), (f"9*({COSINE})", f"9*({SINE})")),
        walls((8, "-t"), (11, "-t"), name="shelf"),
    ],
    "1/2",
)


class TestLetter:
    @pytest.mark.parametrize(
        ("known", "low", "high"),
        [(WHEEL, "1/4", "1/2"), (TUBE, "1/3", "4/5"), (SLOPE, "1/9", "1/3")],
    )
    def test_formulas_are_the_contacts_at_each_value(self, known, low, high):
        made, remarks = shapes_with_letter(known, f"t={low}..{high}")
        assert remarks == []
        question = ParametricQuestion(made, "t")
        for k in range(1, 40):
            value = Fraction(low) + (Fraction(high) - Fraction(low)) * Fraction(k, 40)

            def at(x, _, value=value):
                return str(read_expression(x, "t").value(value))

            read = read_shapes(deep(known, at, plain=WORDS))
            assert question.at(value) == (read.subject, read.subject.weights)
            assert len(read.subject.contacts) > 2

    def test_the_lowest_step_that_stops_a_wheel(self, tmp_path, run):
        """A pull F at the axle lifts a wheel of weight W over an edge at tan(angle) < F / W.

        Source: any textbook of statics, the roller and the step.
        """
        path, made = tmp_path / "wheel.json", tmp_path / "made.json"
        path.write_text(json.dumps(WHEEL), encoding="utf-8")
        words = ["make", "shapes", str(path), "--parameter", "t=1/4..1/2", "-o", str(made)]
        run(*words)
        values = resisted_values(made, "1/4", "1/2")
        (span,) = values.resisted
        assert (span.low, span.high) == (Fraction(1, 3), Fraction(1, 2))
        assert values.verify()

    def test_smooth_tube_has_few_proofs(self):
        """It stands up to a radius of 8/5, see `test_tube_with_two_balls_tips`."""
        bodies = [TUBE["bodies"][0] | {"weight": "3/4"}, *TUBE["bodies"][1:]]
        known = TUBE | {"bodies": [*bodies[:2], bodies[2] | {"weight": 1}], "pairs": []}
        made, _ = shapes_with_letter(known, "t=1/3..4/5")
        values = resisted_values(made, "1/3", "4/5")
        assert [str(span) for span in values.resisted] == ["[1/2, 4/5]"]
        assert [str(span) for span in values.not_resisted] == ["[1/3, 1/2)"]
        assert len(values.pieces) <= 4
        assert all(values.verify())

    def test_value_without_a_proof_is_named(self):
        known = document(
            [disc("a", 0, 1, 1), disc("b", "2+(t^2-2)^2", 1, 1)], [walls((-9, 0), (9, 0))]
        )
        made, (remark,) = shapes_with_letter(known | {"friction": "t"}, "t=1..2")
        assert len(made["contacts"]) == 2
        low, high = map(Fraction, re.fullmatch(r".* in .(\S+), (\S+).", remark).groups())
        assert 0 < high - low < Fraction(1, 10**11)
        assert low**2 < 2 < high**2

    def test_contact_that_goes_on_to_another_shape_is_refused(self):
        """It has as many contacts on both sides of an irrational value."""
        ground = [walls((0, 0), (2, 0), name="left"), walls((2, 0), (9, 0), name="right")]
        known = document([disc("a", "t^2", 1, 1)], ground)
        assert len(shapes_with_letter(known, "t=1..7/5")[0]["contacts"]) == 1
        with pytest.raises(InputError, match="contacts are others than for t"):
            shapes_with_letter(known, "t=1..9/5")

    def test_polygon_whose_centroid_moves(self):
        corners = [[0, 0], ["3+t", 0], [0, 3]]
        body = {"name": "a", "polygon": corners, "weight": "t"}
        made, _ = shapes_with_letter(document([body], [walls((-9, 0), (9, 0))]), "t=0..1")
        question = ParametricQuestion(made, "t")
        span = Span(Fraction(0), Fraction(1))
        assert (
            [x.at(Fraction(1, 2)) for x in question.load(Domain(span))]
            == [question.at("1/2")[1]["a"][k] for k in range(3)]
            == [0, Fraction(-1, 2), Fraction(-7, 12)]
        )

    @pytest.mark.parametrize(
        ("changes", "parameter", "words"),
        [
            ({"gap": "1"}, "t=0..1", "neither wrench nor gap"),
            ({"bodies": [disc("a", 0, "1+(t-10/7)^2", 1)]}, "t=1..2", "contacts are others"),
            ({"bodies": [disc("a", 0, "cos(t)", 1)]}, "t=1..2", "has an angle"),
            # The second disc touches at t = 13/9 alone, and at an irrational value.
            ({"bodies": [disc("a", 0, 1, 1), disc("b", "2+(t-13/9)^2", 1, 1)]}, "t=1..2", "13/9"),
            ({"bodies": [disc("a", 0, "t", 1)]}, "t=2..1", "expected low below high"),
            # They are apart at t = 2, which is looked at first.
            ({"bodies": [disc("a", 0, 1, 1), disc("b", "t", "3/4", "3/4")]}, "t=1..3",
             "^for t = 3/2: a and b overlap: the centre .* is nearer than 7/4"),
            ({"friction": "1/t"}, "t=0..1", "for t = 0 a number divides by 0"),
            ({"friction": "t-1/2"}, "t=0..1", "below 0 for some values"),
            ({"bodies": [disc("a", 0, "t", "t")]}, "t=0..1", "for t = 0: .*radius"),
            ({"bodies": [disc("a", 0, 1, 1, density="t")]}, "t=1..2", "of no polygon"),
            ({"bodies": [disc("a", 0, 1, 1, weight="t") | {"force": [0, "t"]}]}, "t=1..2", "force"),
            ({"threads": [{"body_a": "a", "body_b": None, "point": [0, 0], "to": ["t", 1]}]},
             "t=1..2", "length of the normal"),
            ({}, "t=1", "expected a letter and its ends"),
        ],
    )  # fmt: skip
    def test_what_has_no_formula_is_refused(self, changes, parameter, words):
        known = document([disc("a", 0, 1, 1)], [walls((-4, 0), (4, 0))]) | changes
        with pytest.raises(InputError, match=words):
            shapes_with_letter(known, parameter)
