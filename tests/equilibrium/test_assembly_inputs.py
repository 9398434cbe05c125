"""Assemblies from tables and touching polygons; their weights, modes and description."""

import json
import math
import random
from fractions import Fraction

import pytest

from equilibrium import (
    Assembly,
    BodyContact,
    Circle,
    Contact,
    ContactModes,
    GraspError,
    RigidBody,
    read_assembly,
    solve,
)
from equilibrium.grasps.inputs.csv_file import read_bodies
from equilibrium.grasps.schemas import assembly_schema
from equilibrium.grasps.textbook import stack, wedge
from tests.schemas import validator

TABLE = """body_a,body_b,x,y,angle,mu,q
lower,,-2,0,90,1/2,1
lower,ground,2,0,90,1/2,1
upper,lower,-1,1,90,1/4,0
upper,lower,1,1,90,1/4,0
"""
FLOOR = [[-9, -1], [9, -1], [9, 0], [-9, 0]]


def box(x, y, width=2, height=1):
    x, y, width, height = map(Fraction, (x, y, width, height))
    return [[x, y], [x + width, y], [x + width, y + height], [x, y + height]]


def test_decimals_of_an_assembly_are_read(tmp_path, run):
    contacts = [
        {"body_a": "box", "body_b": None, "point": [x, 0.5], "normal": [0, 1], "friction": 0.5}
        for x in (-0.5, 0.5)
    ]
    document = {"schema_version": 1, "bodies": ["box"], "contacts": contacts}
    path = tmp_path / "box.json"
    path.write_text(json.dumps(document | {"wrench": {"box": [0, -1.5, 0.25]}}))
    assert run("solve {}", path).startswith("resisted: ")
    contacts[1]["body_b"] = "floor"
    path.write_text(json.dumps(document))
    run("solve {} --on box 0 -1 0", path, code=2)
    assert "expected one of the bodies box, or null for the ground" in run.err


def touches(assembly):
    return [(c.body_a, c.body_b, *c.contact.point, *c.contact.normal) for c in assembly.contacts]


class TestTable:
    def test_rows_are_contacts(self, tmp_path):
        path = tmp_path / "stack.csv"
        path.write_text(TABLE, encoding="utf-8")
        assembly = read_assembly(path)
        assert assembly.names == ("lower", "upper")
        assert touches(assembly)[1:3] == [
            ("lower", None, 2, 0, 0, 1),
            ("upper", "lower", -1, 1, 0, 1),
        ]
        assert [c.contact.preload for c in assembly.contacts] == [1, 1, 0, 0]

    def test_commands_read_it(self, tmp_path, run):
        path, out = str(tmp_path / "stack.csv"), str(tmp_path / "stack.json")
        (tmp_path / "stack.csv").write_text(TABLE, encoding="utf-8")
        run("solve {} --on upper 0 -1 0", path)
        run("make csv {} --units m N -o", path, out)
        assert read_assembly(out) == read_assembly(path)
        assert str(read_assembly(out).units) == "lengths in m, forces in N, torques in N m"
        assert "100" in run("info {} --modes --count", path)

    def test_rounded_normals_are_reported(self, tmp_path, run):
        path = tmp_path / "stack.csv"
        path.write_text(TABLE.replace(",90,", ",50,"), encoding="utf-8")
        with pytest.raises(GraspError, match="make csv"):
            read_assembly(path)
        run("solve {} --on upper 0 -1 0", path, code=None)
        assert "rounded" in run.err
        assert not read_bodies(path)[1].exact

    @pytest.mark.parametrize(
        ("text", "words"),
        [
            (TABLE.replace("body_b,", "").replace("lower,,", "lower,"), "body_b is missing"),
            (TABLE.replace("upper,lower", "upper,upper"), "expected two bodies"),
            (TABLE.replace("upper,lower", ",lower"), "line 4: body_a is '', the ground"),
            (TABLE.replace("-2,0,90", "x,0,90"), "line 2"),
        ],
    )
    def test_bad_tables_are_refused(self, text, words, tmp_path, refused):
        path = tmp_path / "stack.csv"
        path.write_text(text, encoding="utf-8")
        assert words in refused("solve {} --on upper 0 -1 0", path)

    @pytest.mark.parametrize("ground", ["ground", "Ground", "fixed", "world", ""])
    def test_ground_is_fixed_as_second_body_and_refused_as_first(self, ground, tmp_path):
        path = tmp_path / "box.csv"
        path.write_text(f"body_a,body_b,x,y,nx,ny,mu\nbox,{ground},0,0,0,1,1\n", encoding="utf-8")
        assembly = read_assembly(path)
        assert (assembly.names, assembly.contacts[0].body_b) == (("box",), None)
        path.write_text(f"body_a,body_b,x,y,nx,ny,mu\n{ground},box,0,0,0,1,1\n", encoding="utf-8")
        with pytest.raises(GraspError, match=r"line 2: body_a is .*, the ground; exchange it"):
            read_assembly(path)

    def test_table_of_a_grasp_is_not_one(self, tmp_path):
        path = tmp_path / "grasp.csv"
        path.write_text("x,y,angle,mu\n0,0,90,1\n", encoding="utf-8")
        with pytest.raises(GraspError, match="body_a"):
            read_assembly(path)


class TestWeight:
    def test_weight_acts_in_the_centroid(self):
        triangle = RigidBody.from_dict(
            {"name": "t", "outline": [[0, 0], [3, 0], [0, 3]], "weight": 2}
        )
        disk = RigidBody("d", Circle([5, 1], 1), Fraction(3))
        own = RigidBody("o", weight=Fraction(1), centre=(7, 0))
        assembly = Assembly([triangle, disk, own, "none"])
        assert assembly.weights == {
            "t": (0, -2, -2), "d": (0, -3, -15), "o": (0, -1, -7), "none": (0, 0, 0)
        }  # fmt: skip
        validator(assembly_schema()).validate(assembly.to_dict())
        assert Assembly.from_dict(assembly.to_dict()).weights == assembly.weights

    def test_files_without_wrench_have_the_weights(self, tmp_path, run):
        made = Assembly.from_polygons({"a": box(0, 0)}, "1/2", ground=[FLOOR], density=1)
        made.save(tmp_path / "a.json")
        assert "a moves by (0, -1, 0)" in run("solve", tmp_path / "a.json")
        push = ["--along", "a", "1", "0", "-1/2"]
        assert (
            run("resisted", tmp_path / "a.json", *push)
            == "resisted for t in [0, 1]\n  at 1: slips at contacts 1, 2\n"
        )

    def test_certificate_has_no_weights(self):
        made = Assembly.from_polygons({"a": box(0, 0)}, "1/2", ground=[FLOOR], density=1)
        verdict = solve(made, made.weights)
        assert verdict.proof["assembly"]["bodies"] == [{"name": "a"}]
        assert verdict.verify()

    def test_weight_without_place_is_refused(self):
        with pytest.raises(GraspError, match="neither centre nor outline"):
            RigidBody("a", weight=Fraction(1))
        for outline in ([[0, 0], [1, 1], [2, 2]], {"segments": [[[0, 0], [1, 1]]]}):
            with pytest.raises(GraspError, match="a: the outline has no area"):
                RigidBody.from_dict({"name": "a", "outline": outline, "weight": 1})


class TestPolygons:
    def test_corners_of_a_straight_edge_are_merged(self):
        plain = Assembly.from_polygons({"a": box(0, 0)}, "1/2", ground=[FLOOR], density=1)
        more = box(0, 0)
        more[1:1] = [(Fraction(k, 3), 0) for k in (1, 2)]
        floor = [*FLOOR[:3], (Fraction(1, 2), 0), (0, 0), *FLOOR[3:]]
        for corners in (more, more[::-1]):
            for ground in (FLOOR, floor):
                made = Assembly.from_polygons({"a": corners}, "1/2", ground=[ground], density=1)
                assert {c.contact for c in made.contacts} == {c.contact for c in plain.contacts}
                assert made.weights == plain.weights

    def test_edges_in_common_have_two_contacts(self):
        made = Assembly.from_polygons({"a": box(0, 0), "b": box(1, 1)[::-1]}, 1, ground=[FLOOR])
        assert not any(map(any, made.weights.values()))
        assert sorted(touches(made), key=str) == sorted(
            [
                ("a", None, 0, 0, 0, 1),
                ("a", None, 2, 0, 0, 1),
                ("a", "b", 1, 1, 0, -1),
                ("a", "b", 2, 1, 0, -1),
            ],
            key=str,
        )

    def test_corner_on_an_edge_has_one(self):
        ladder = {"ladder": [[0, 0], [3, 4], ["29/10", 4]]}
        made = Assembly.from_polygons(ladder, 1, ground=[FLOOR, box(3, 0, 2, 5)])
        assert touches(made) == [("ladder", None, 0, 0, 0, 1), ("ladder", None, 3, 4, -1, 0)]

    def test_edge_of_one_meets_a_corner_of_the_other(self):
        tent = [[0, 0], [1, -1], [2, 0]]
        made = Assembly.from_polygons({"a": box(0, 0), "b": [[1, 0], [2, -1], [0, -1]]}, 1)
        assert touches(made) == [("a", "b", 1, 0, 0, 1)]
        assert Assembly.from_polygons({"a": box(0, 0), "b": tent}, 1).contacts[0].body_b == "b"

    def test_corners_that_meet_are_no_contact(self):
        assert not Assembly.from_polygons({"a": box(0, 0), "b": box(2, 1)}, 1).contacts

    @pytest.mark.parametrize(
        "other",
        [
            box(1, 0),
            box(0, 0),
            box("1/2", "1/4", 1, "1/2"),
            box(-1, -1, 4, 3),
            box("1/2", -1, 1, 3),
            box("3/2", 0),
            box(0, "1/2", 2, 1),
            # The middle of no edge is in the other polygon.
            [["19/10", "1/5"], [10, "3/20"], [10, "1/4"]],
            [["1/10", "1/5"], [-10, "1/4"], [-10, "3/20"]],
            [["1/5", "1/10"], ["3/20", -10], ["1/4", -10]],
            [["1/5", "9/10"], ["1/4", 10], ["3/20", 10]],
            # A notch with the box in it, but for a corner.
            [[-1, -1], [4, -1], [4, 2], [2, 2], [2, "1/2"], ["7/4", 0], [0, 0], [0, 2], [-1, 2]],
        ],
    )
    def test_overlaps_are_refused(self, other):
        with pytest.raises(GraspError, match="a and b overlap"):
            Assembly.from_polygons({"a": box(0, 0), "b": other}, 1)

    def test_small_boxes_touch(self):
        boxes = {name: box(x, 0, "1/4", "1/4") for name, x in (("a", 0), ("b", "1/4"))}
        assert len(Assembly.from_polygons(boxes, 1).contacts) == 2
        with pytest.raises(GraspError, match="a and b overlap"):
            Assembly.from_polygons({**boxes, "b": boxes["a"]}, 1)

    def test_overlap_with_the_ground_is_named(self):
        with pytest.raises(GraspError, match="a and the ground overlap"):
            Assembly.from_polygons({"a": box(0, "-1/2")}, 1, ground=[FLOOR])

    def test_box_in_an_arm_of_another_polygon_overlaps(self):
        # The ray from the box to the right leaves one arm and crosses the other one.
        arms = [[0, 0], [10, 0], [10, 5], [8, 5], [8, 2], [4, 2], [4, 5], [0, 5]]
        with pytest.raises(GraspError, match="a and b overlap"):
            Assembly.from_polygons({"a": box(1, 3), "b": arms}, 1)
        assert not Assembly.from_polygons({"a": box(5, 3), "b": arms}, 1).contacts

    def test_values_are_those_of_all_contacts(self):
        values = {"stiffness": 2, "preload": 3}
        for given, stiffness, preload in (({}, 1, 0), (values, 2, 3)):
            made = Assembly.from_polygons({"a": box(0, 0)}, "1/2", ground=[FLOOR], **given)
            rows = {
                (c.contact.friction, c.contact.stiffness, c.contact.preload) for c in made.contacts
            }
            assert rows == {(Fraction(1, 2), stiffness, preload)}

    def test_box_in_a_notch_touches_on_three_sides(self):
        notch = [[-1, -1], [4, -1], [4, 2], [2, 2], [2, 0], [0, 0], [0, 2], [-1, 2]]
        made = Assembly.from_polygons({"a": box(0, 0), "b": notch}, 1)
        assert sorted(touches(made), key=str) == sorted(
            [
                ("a", "b", 0, 0, 0, 1),
                ("a", "b", 2, 0, 0, 1),
                ("a", "b", 0, 0, 1, 0),
                ("a", "b", 0, 1, 1, 0),
                ("a", "b", 2, 0, -1, 0),
                ("a", "b", 2, 1, -1, 0),
            ],
            key=str,
        )

    def test_polygons_around_a_common_axis_are_apart(self):
        made = Assembly.from_polygons({"a": box(0, 0), "b": box(0, 2), "c": box(3, 0)}, 1)
        assert not made.contacts
        # Its box meets that of a.
        corner = [[4, 0], [4, 2], [1, 2]]
        assert not Assembly.from_polygons({"a": box(0, 0), "b": corner}, 1).contacts

    def test_normal_of_irrational_length_needs_a_tolerance(self):
        halves = {"a": [[0, 0], [1, 0], [1, 1]], "b": [[0, 0], [1, 1], [0, 1]]}
        with pytest.raises(GraspError, match="angle_tolerance"):
            Assembly.from_polygons(halves, 1)
        made = Assembly.from_polygons(halves, 1, angle_tolerance="1/100")
        assert all(abs(math.hypot(*c.contact.normal) - 1) < 1e-12 for c in made.contacts)

    def test_crossing_outline_is_refused(self):
        with pytest.raises(GraspError, match="a: edges"):
            Assembly.from_polygons({"a": [[0, 0], [1, 1], [1, 0], [0, 1]]}, 1)

    def test_textbook_outlines_touch_at_the_textbook_contacts(self):
        made, _ = stack(blocks=3)
        outlines = {body.name: body.outline.corners for body in made.bodies}
        again = Assembly.from_polygons(outlines, "1/2", ground=[FLOOR])
        rows = [
            c if c.body_b is None or c.body_a > c.body_b else c.reversed for c in again.contacts
        ]
        assert {(c.body_a, c.body_b, c.contact.point, c.contact.normal) for c in rows} == {
            (c.body_a, c.body_b, c.contact.point, c.contact.normal) for c in made.contacts
        }

    def test_random_walls_of_bricks_stand(self):
        """Bricks in courses, each moved by half: their weights are resisted."""
        rng = random.Random(1)
        for _ in range(3):
            shift = Fraction(rng.randint(1, 3), 4)
            bricks = {f"{x} {y}": box(2 * x + y * shift, y) for y in range(2) for x in range(2)}
            made = Assembly.from_polygons(bricks, "1/2", ground=[FLOOR], density=1)
            assert solve(made, made.weights, nodes=300).verdict != "not resisted"


class TestModes:
    def test_modes_of_a_stack_are_the_product(self):
        one, two = (ContactModes.of_grasp(stack(blocks=k)[0]) for k in (1, 2))
        assert two.sliding_sticking_count == one.sliding_sticking_count**2
        assert len(two.contacting_separating) == len(one.contacting_separating) ** 2
        assert two.n == 6

    def test_document_of_an_assembly_has_its_modes(self, tmp_path, run):
        assembly, loads = wedge()
        modes = ContactModes.from_dict(assembly.to_dict(loads))
        assert modes.normals == ContactModes.of_grasp(assembly).normals
        assembly.save(tmp_path / "a.json", loads)
        counts = run.json("info {} --modes --count", tmp_path / "a.json")
        assert counts["sliding_sticking"] == modes.sliding_sticking_count

    def test_info_describes_bodies_and_contacts(self, tmp_path, run, refused):
        assembly, loads = stack()
        assembly.save(tmp_path / "a.json", loads)
        text = run("info", tmp_path / "a.json")
        assert "block 2  wrench (0, -1, 0)" in text
        assert "rank             2 of 4 tangential hyperplanes in R^6" in text
        assembly.save(tmp_path / "bare.json")
        assert "wrench" not in run.json("info", tmp_path / "bare.json")
        refused("info {} --force-closure", tmp_path / "a.json")


def test_many_contacts_are_counted(tmp_path, run):
    rows = [BodyContact("a", None, Contact((x, 0), (0, 1), 1)) for x in range(25)]
    Assembly(["a"], rows).save(tmp_path / "a.json")
    assert "... and 5 contacts more" in run("info", tmp_path / "a.json")
