"""Grasps from polygons, circles, float data, CSV files and at random."""

import io
import json
import math
import re
from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import assume, given, settings, strategies as st

from arrangement.cli import main as arrangement_main
from arrangement.errors import InputError
from equilibrium import Circle, Grasp, GraspError, Polygon, read_grasp
from equilibrium.grasps.inputs import (
    OnEdge,
    from_float_data,
    from_polygon,
    on_circle,
    random_grasp,
    random_wrench,
    read_csv,
    read_float_data,
    read_polygon,
    simplest_between,
    snapped,
    star_outline,
)
from equilibrium.grasps.inputs.csv_file import parse_csv, table_text, tangential_arrangement
from equilibrium.grasps.inputs.documents import read_any
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.labels import DataError
from equilibrium.scenes import EngineScene, document_text

from .strategies import grasps

TRIANGLE = [(0, 0), (4, 0), (0, 3)]
HEADER = "x,y,normal_x,normal_y,friction"


class TestSnapping:
    @given(st.fractions(max_denominator=200), st.fractions(0, 1, max_denominator=50))
    @settings(max_examples=50)
    def test_simplest_is_inside_and_of_least_denominator(self, low, width):
        found = simplest_between(low, low + width)
        assert low <= found <= low + width
        for d in range(1, found.denominator):
            assert math.ceil(low * d) > (low + width) * d

    @given(st.floats(-1e6, 1e6))
    def test_error_is_exact_and_within_the_tolerance(self, x):
        found, error = snapped(x, Fraction(1, 1000))
        assert found - error == Fraction(x)
        assert abs(error) <= Fraction(1, 1000)

    def test_tolerance_zero_keeps_the_binary_value(self):
        assert snapped(0.1, 0) == (Fraction(0.1), 0)


class TestFloatData:
    def test_numbers_normals_and_errors(self):
        found = from_float_data([[0.1, -1.0]], [[1.0, 1.0]], [0.3], preload=2.0)
        (contact,) = found.grasp.contacts
        assert contact.point == (Fraction(1, 10), -1)
        assert (contact.friction, contact.preload) == (Fraction(3, 10), 2)
        assert 0 < abs(found.angle_errors[0]) <= Fraction(1, 10**6)
        assert found.point_errors == (abs(Fraction(1, 10) - Fraction(0.1)),)
        assert found.value_error == abs(Fraction(3, 10) - Fraction(0.3))
        assert not found.exact


FLOATS = {
    "schema_version": 1,
    "points": [[-0.1, 0], [0.30000000000000004, 1e-3]],
    "normals": [[2.5, 0], [-0.7, 0.7]],
    "friction": [0.3, 0.5],
    "preload": 1,
}
FLOAT_CSV = f"{HEADER},preload\n-0.1,0,2.5,0,0.3,1\n0.30000000000000004,1e-3,-7e-1,.7,1/2,1\n"


class TestFloatFiles:
    def test_both_forms_are_read_alike(self, tmp_path, run):
        (tmp_path / "data.json").write_text(json.dumps(FLOATS))
        (tmp_path / "data.CSV").write_text(FLOAT_CSV)
        one = read_float_data(tmp_path / "data.json")
        assert one.grasp == read_float_data(tmp_path / "data.CSV").grasp
        assert [c.point for c in one.grasp] == [
            (Fraction(-1, 10), 0),
            (Fraction(3, 10), Fraction(1, 1000)),
        ]
        assert [c.friction for c in one.grasp] == [Fraction(3, 10), Fraction(1, 2)]
        written = Grasp.from_dict(
            json.loads(run("make floats {} --units m N", tmp_path / "data.json"))
        )
        assert (written, written.units.length) == (one.grasp, "m")
        assert run.err.startswith("rounded: ")
        assert "values by" in run.err

    def test_errors_are_those_of_the_function(self, tmp_path, run):
        path = tmp_path / "data.json"
        path.write_text(json.dumps(FLOATS))
        document = run.json("make floats {} --tolerance 1/100", path)
        found = from_float_data(
            FLOATS["points"], FLOATS["normals"], [0.3, 0.5], preload=1, tolerance="1/100"
        )
        assert (document, run.err) == (found.to_dict(), "")
        assert found.point_errors[1] == Fraction(1e-3)


class TestPolygon:
    @pytest.mark.parametrize("vertices", [TRIANGLE, TRIANGLE[::-1]])
    def test_normals_point_inward_in_both_orientations(self, vertices):
        found = from_polygon(vertices, [(2, 0), (0, 1), (2, "3/2")], 1)
        assert [c.normal for c in found.grasp] == [
            (0, 1),
            (1, 0),
            (Fraction(-3, 5), Fraction(-4, 5)),
        ]
        assert found.exact

    def test_an_edge_and_a_parameter_name_a_point(self):
        found = from_polygon(TRIANGLE, [OnEdge(0, "1/4"), OnEdge(2, 1)], ["1/2", 1], preload=[0, 2])
        assert [c.point for c in found.grasp] == [(1, 0), (0, 0)]
        assert [c.normal for c in found.grasp] == [(0, 1), (1, 0)]
        assert [c.preload for c in found.grasp] == [0, 2]

    def test_an_irrational_edge_reports_its_angle(self):
        found = from_polygon([(0, 0), (1, 0), (0, 1)], [OnEdge(1, "1/2")], 1)
        (contact,) = found.grasp.contacts
        x, y = contact.normal
        assert x * x + y * y == 1
        # The tangent of the angle from (-1, -1) to (x, y), by its definition.
        assert found.angle_errors == ((x - y) / (-x - y),)
        assert 0 < abs(found.angle_errors[0]) <= Fraction(1, 10**6)

    @pytest.mark.parametrize(
        ("vertices", "word"),
        [
            ([(0, 0), (1, 0)], "three corners"),
            ([(0, 0), (2, 2), (2, 0), (0, 2)], "meet"),  # a bow tie
            ([(0, 0), (2, 0), (1, 0)], "on one line"),  # no area
            ([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)], "meet"),  # a corner touches an edge
            ([(0, 0), (0, 0), (1, 0), (0, 1)], "meet"),  # a corner twice
            ([(0, 0), (1, 0), (0, 0.5)], "float"),
            ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], "coordinates"),
        ],
    )
    def test_bad_polygons_are_refused(self, vertices, word):
        with pytest.raises(InputError, match=word):
            from_polygon(vertices, [], 1)

    @pytest.mark.parametrize(
        ("place", "word"),
        [
            ((0, 0), "corner"),
            ((1, 1), "not on the boundary"),
            ((5, 0), "not on the boundary"),
            (OnEdge(3, 0), "edges are 0 to 2"),
            (OnEdge(0, 2), "from 0 to 1"),
            ((1,), "coordinates"),
        ],
    )
    def test_bad_places_are_refused(self, place, word):
        with pytest.raises(InputError, match=word):
            from_polygon(TRIANGLE, [place], 1)

    def test_place_where_the_boundary_is_straight_is_no_corner(self):
        bent = [(0, 0), (1, 0), (2, 0), (0, 2)]
        assert from_polygon(bent, [(1, 0)], 1).grasp.contacts[0].normal == (0, 1)
        with pytest.raises(InputError, match="corner 2"):
            from_polygon(bent, [(2, 0)], 1)

    @given(st.integers(0, 2), st.fractions("1/20", "19/20", max_denominator=20))
    def test_edge_and_coordinates_say_the_same(self, edge, at):
        by_edge = from_polygon(TRIANGLE, [OnEdge(edge, at)], 1)
        point = by_edge.grasp.contacts[0].point
        assert from_polygon(TRIANGLE, [point], 1) == by_edge

    def test_document(self):
        document = {
            "schema_version": 1,
            "polygon": [["0", "0"], ["4", "0"], ["0", "3"]],
            "places": [
                {"edge": 1, "at": "1/2", "friction": "1/2"},
                {"point": ["2", "0"], "friction": 1, "preload": "1"},
            ],
        }
        found = read_polygon(document)
        assert [c.point for c in found.grasp] == [(2, Fraction(3, 2)), (2, 0)]
        assert [c.preload for c in found.grasp] == [0, 1]
        document["places"][0]["at_"] = "1"
        with pytest.raises(InputError, match="at_"):
            read_polygon(document)


class TestCircle:
    @given(st.lists(st.floats(-720, 720), min_size=1, max_size=5), st.integers(1, 5))
    def test_points_lie_on_the_circle_exactly(self, angles, radius):
        found = on_circle(angles, 1, radius=radius, centre=(2, -1))
        for contact, angle in zip(found.grasp, angles, strict=True):
            away = [contact.point[0] - 2, contact.point[1] + 1]
            assert away[0] ** 2 + away[1] ** 2 == radius**2
            assert [-radius * n for n in contact.normal] == away
            wanted = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
            assert math.dist([float(x) / radius for x in away], wanted) < 2e-6

    def test_quarter_turns_are_exact(self):
        found = on_circle(4, 1)
        assert [c.point for c in found.grasp] == [(1, 0), (0, 1), (-1, 0), (0, -1)]
        assert found.exact

    def test_a_radius_must_be_positive(self):
        with pytest.raises(GraspError, match="radius"):
            on_circle(3, 1, radius=0)
        with pytest.raises(InputError, match=r"angle 1 is inf; only finite"):
            on_circle([math.inf], 1)


class TestRandom:
    @pytest.mark.parametrize("m", [0, 1, 5, 20])
    def test_contacts_surround_the_origin_with_inward_normals(self, m):
        for seed in range(4):
            grasp = random_grasp(m, seed)
            assert len(grasp) == m
            for c in grasp:
                square = c.point[0] ** 2 + c.point[1] ** 2
                assert Fraction(1, 4) <= square <= Fraction(9, 4)
                inward = -(c.point[0] * c.normal[0] + c.point[1] * c.normal[1])
                assert inward > 0
                assert 2 * inward**2 >= square  # at most 45 degrees from the centre

    def test_half_of_the_seeds_have_preload(self):
        loaded = [all(c.preload > 0 for c in random_grasp(3, seed)) for seed in range(10)]
        free = [all(c.preload == 0 for c in random_grasp(3, seed)) for seed in range(10)]
        assert sum(loaded) == sum(free) == 5
        assert random_grasp(3, 0, preload=True).contacts[0].preload > 0

    def test_seeds_differ_and_repeat(self):
        assert len({random_grasp(3, seed) for seed in range(20)}) == 20
        assert len({random_wrench(seed) for seed in range(20)}) == 20
        assert random_wrench(5) == random_wrench(5)
        quadrants = {tuple(x > 0 for x in c.point) for c in random_grasp(40, 1)}
        assert len(quadrants) == 4


class TestCsv:
    def test_columns_in_any_order(self, tmp_path):
        path = tmp_path / "grasp.csv"
        path.write_text(
            "preload,friction,normal_y,normal_x,y,x\n1, 1/2 ,0,2,0.5,-1\n0,.25,5,12,0,0\n",
            encoding="utf-8-sig",
        )
        found = read_csv(path)
        first, second = found.grasp.contacts
        assert first.point == (-1, Fraction(1, 2))
        assert (first.normal, first.preload, first.stiffness) == ((1, 0), 1, 1)
        assert second.normal == (Fraction(12, 13), Fraction(5, 13))
        assert found.exact

    @pytest.mark.parametrize("separator", [",", ";", "\t"])
    def test_short_names_other_separators_and_remarks(self, separator):
        rows = ["# measured on Monday", "x,y,nx,ny,mu,q,k", "", "0,1/2,0,-1,0.5,1,2e1", "  # end"]
        found = parse_csv("\n".join(rows).replace(",", separator))
        plain = "x,y,normal_x,normal_y,friction,preload,stiffness\n0,1/2,0,-1,1/2,1,20\n"
        assert found.grasp == parse_csv(plain).grasp

    def test_with_a_third_coordinate_the_grasp_is_in_space(self, tmp_path):
        table = "x,y,z,nx,ny,nz,mu\n0,0,0.5,0,3,4,0.5\n"
        found = parse_csv(table).grasp
        assert found.contacts[0].point == (0, 0, Fraction(1, 2))
        assert found.contacts[0].normal == (0, Fraction(3, 5), Fraction(4, 5))
        (tmp_path / "data.csv").write_text(table)
        measured = {"points": [[0, 0, 0.5]], "normals": [[0.0, 3, 4]], "friction": 0.5}
        assert read_float_data(tmp_path / "data.csv").grasp == found
        assert read_float_data({"schema_version": 1, **measured}).grasp == found

    def test_contact_near_the_origin_is_read_beside_others(self, tmp_path):
        table = written(tmp_path, "a.csv", "x,y,nx,ny,mu\n1e-7,0,1,0,0.5\n1,0,-1,0,0.5\n")
        assert [c.point for c in read_float_data(table).grasp] == [(0, 0), (1, 0)]


class TestOutlines:
    def test_polygons_and_circles_are_the_outlines(self):
        corners = ((0, 0), (4, 0), (0, 3))
        assert from_polygon(corners, [OnEdge(0, "1/2")], 1).grasp.outline == Polygon(corners)
        assert on_circle(3, 1, radius=2, centre=(1, 0)).grasp.outline == Circle((1, 0), 2)

    @given(st.integers(1, 12), st.integers(0, 10**6))
    def test_star_outline_touches_every_contact(self, number, seed):
        grasp = random_grasp(number, seed)
        outline = star_outline(grasp)
        assume(outline is not None)
        corners = outline.corners
        turns = zip(corners, [*corners[1:], corners[0]], strict=True)
        assert all(a[0] * b[1] > a[1] * b[0] for a, b in turns)
        edges = set(zip(corners[::2], corners[1::2], strict=True))
        assert len(edges) == len(grasp)
        for contact in grasp:
            assert any(
                tuple((x + y) / 2 for x, y in zip(a, b, strict=True)) == contact.point
                and sum((y - x) * n for x, y, n in zip(a, b, contact.normal, strict=True)) == 0
                for a, b in edges
            )

    def test_the_command_takes_one_for_csv_files(self, tmp_path, run):
        path = tmp_path / "a.csv"
        path.write_text("x,y,normal_x,normal_y,friction\n-1,0,1,0,0.5\n", encoding="utf-8")
        corners = ["-1,-1", "1,-1", "0,3/2"]
        found = json.loads(run("make csv {} --outline", path, *corners))
        assert found["outline"] == [["-1", "-1"], ["1", "-1"], ["0", "3/2"]]
        first, second = run.json("make circle --angles 0 100 --friction 1")["angle_errors"]
        assert first == "0" != second
        outline = json.loads(run("make random --contacts 4 --seed 3"))["outline"]
        assert outline == star_outline(random_grasp(4, 3)).to_dict()


def test_tables_are_their_tangential_planes_for_arrangements(capsys, monkeypatch):
    header = "x,y,nx,ny,mu\n"
    three = header + "-1,0,2,0,1/2\n0,-1,0,1,1/2\n1,0,-1,0,1/2\n"
    planes = read_grasp("paper-three-contacts").tangential_arrangement()
    assert tangential_arrangement(three) == planes
    assert tangential_arrangement("x,y\n1,2\n") is None
    quoted = '"x","y","normal_x","normal_y","friction"\n0,0,0,1,1\n'
    assert tangential_arrangement(quoted) == tangential_arrangement(quoted.replace('"', ""))
    with pytest.raises(GraspError, match="without an exact length"):
        tangential_arrangement(header + "0,0,1,1,1\n")
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(three.encode())))
    assert arrangement_main(["count", "-", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["planes"] == 3


@pytest.mark.parametrize("known", [False, True])
def test_conversions_know_whether_the_stiffness_was_given(known, tmp_path):
    one = {"stiffness": 1} if known else {}
    entry = {"point": [0.5, 0], "normal": [0, 1], "friction": 0.5, **one}
    place = {"edge": 0, "at": "1/2", "friction": "1/2", **one}
    corners = [["0", "0"], ["1", "0"], ["0", "1"]]
    table = tmp_path / "grasp.csv"
    table.write_text(f"x,y,nx,ny,mu{',k' * known}\n0.5,0,0.3,1,0.5{',1' * known}\n")
    path = tmp_path / "grasp.json"
    for made in (
        from_float_data([[0.5, 0]], [[0.3, 1]], 0.5, **one),
        read_float_data({"schema_version": 1, "contacts": [entry]}),
        read_float_data(table),
        read_csv(table),
        from_polygon(corners, [OnEdge(0, "1/2")], "1/2", **one),
        read_polygon({"schema_version": 1, "polygon": corners, "places": [place]}),
        on_circle(1, "1/2", **one),
    ):
        made.grasp.save(path)
        for grasp in (made.grasp, read_grasp(path), other_rounding_of(made.grasp)):
            assert [c.stiffness_given for c in grasp] == [known]


def other_rounding_of(grasp):
    """Return a grasp within the error of data, with all values kept."""
    exact = replace(
        grasp, data_error=DataError(Fraction(1, 10**6), Fraction(1, 10**6), Fraction(0))
    )
    return other_rounding(exact, 0)


def test_commands_take_tables_and_round_normals_on_demand(run, tmp_path):
    table, slanted = tmp_path / "grasp.csv", tmp_path / "grasp.json"
    table.write_text("x;y;nx;ny;mu;k;q\n-1;0;2;0;.5;1;1\n0;-1;0;1;1/2;1;1\n1;0;-1;0;1/2;1;1\n")
    document = read_grasp("paper-three-contacts-preload-1").to_dict()
    document["contacts"][0]["normal"] = ["3", "1e-9"]
    slanted.write_text(json.dumps(document))
    out = run.json("solve {} --wrench 0,1,0", table)
    assert out == run.json("solve paper-three-contacts-preload-1 --wrench 0,1,0")
    run("lab {} -o", table, tmp_path / "lab.html")
    run("solve {} --wrench 0,0,0 --round-normals", slanted, code=None)
    assert "rounded: points by 0, normals by 3.3e-10 radians" in run.err
    run("make circle --angles 1 --friction 1 --radius 1e4000")
    assert re.search(r"rounded: points by \S+e\+39\d\d, normals", run.err)


@pytest.mark.parametrize("name", ["points", "normals", "friction", "stiffness", "preload"])
def test_numbers_beyond_floats_are_no_float_data(name):
    given = {"points": [[1, 0]], "normals": [[1, 0]], "friction": 1}
    given[name] = [["1e9999", 0]] if name in ("points", "normals") else "1e9999"
    with pytest.raises(
        GraspError, match=rf"{name}.* is 1e\+9999; expected a number up to 1\.79e308"
    ):
        from_float_data(**given)


def test_tiny_tolerances_are_no_obstacle():
    found = from_float_data([[0.1, 0]], [[1, 0]], 0.5, tolerance="1e-9999")
    assert found.grasp.contacts[0].point[0] == Fraction(0.1)


CONTACTS = read_grasp("paper-three-contacts-preload-1").to_dict()["contacts"]
SCENE = EngineScene(read_grasp("paper-three-contacts-preload-1"), [[0, 1, 0]])


def test_bare_list_of_contacts_is_a_grasp(tmp_path):
    path = tmp_path / "a.json"
    path.write_text(json.dumps(CONTACTS))
    assert read_grasp(path) == read_any(path).grasp == read_grasp("paper-three-contacts-preload-1")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            '<?xml version="1.0"?>\n<!-- -->\n<robot name="a"/>',
            "is a URDF model. Expected a grasp: a .csv file",
        ),
        (SCENE.mjcf(), "is an MJCF model of MuJoCo"),
        ("<html>", "is an HTML page. Expected a grasp"),
        (document_text(SCENE.document()), "is a scene of `equilibrium draw --model scene`"),
        ('[{"point": ["1", "0"]}]', 'contacts\\[0\\] has no keys "normal", "friction"'),
        ("[[1, 0]]", "holds a list; a document is a JSON object"),
        ('{"points": [[1, 0]], "normals": [[1, 0]]}', "equilibrium make floats FILE -o GRASP.json"),
        ('[{"normal": [0.5, 1]}]', 'contacts\\[0\\] has no keys "point", "friction"'),
    ],
)
def test_other_file_is_named(tmp_path, text, message):
    path = tmp_path / "a.json"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_grasp(path)


def test_contacts_in_floats_are_snapped(tmp_path):
    path = tmp_path / "a.json"
    floats = [
        {key: [float(Fraction(x)) for x in c[key]] for key in ("point", "normal")}
        | {"friction": float(Fraction(c["friction"])), "preload": 1.0}
        for c in CONTACTS
    ]
    path.write_text(json.dumps(floats))
    found = read_float_data(path).grasp
    assert found.contacts == read_grasp("paper-three-contacts-preload-1").contacts
    path.write_text(json.dumps({"schema_version": 1, "contacts": floats}))
    assert read_float_data(path).grasp == found


PLAIN = "x,y,normal_x,normal_y,friction,preload\n-3/2,0,1,0,1/2,1\n3/2,0,-1,0,1/2,1\n"
FINGERS = parse_csv(PLAIN).grasp


@pytest.mark.parametrize(
    "head",
    [
        "x [m],y [m],normal [deg],mu,preload [N]",
        "x (m), y (m), normal (deg), friction, Q [N]",
        "x_m,y_m,angle_deg,cof,force_N",
        "x in m,y in m,angle in deg,mu,q in N",
        "pos_x [m],pos_y [m],theta [°],Coefficient of friction [-],Normal force [N]",
        '"x [m]","y [m]","angle","mu","preload [N]"',
    ],
)
def test_csv_heads_may_have_units_and_usual_names(head):
    found = parse_csv(f"{head}\n-1.5,0,0,0.5,1\n1.5,0,180,0.5,1\n").grasp
    assert found == FINGERS.with_units("m", "N")


@pytest.mark.parametrize("separator", [";", "\t"])
def test_csv_numbers_may_have_decimal_commas(separator):
    lines = ["x,y,n_x,n_y,mu,q", "-1_5,0,1,0,0_5,1", "1_5,0,-1,0,_5,1"]
    head, *rows = (line.replace(",", separator) for line in lines)
    assert parse_csv("\n".join([head, *(row.replace("_", ",") for row in rows)])).grasp == FINGERS


@pytest.mark.parametrize(
    ("head", "message"),
    [
        ("x [mm],y [m],angle,mu,q", r"'y \[m\]' is in m, others in mm; nothing is converted"),
        ("x,y,angle [rad],mu,q", "is in rad; expected degrees"),
        ("x,y,angle,friction (deg),q", "of a friction angle its tangent"),
        ("x,y,angle,friction angle (deg),q", "write friction, its tangent"),
        ("x,y,angle,mu [rad],q", "of a friction angle its tangent"),
        ("x [m],y [m],angle,mu,k [N/mm]", None),
        ("x,y,angle,rubbing,q", "the column friction is missing; write it for 'rubbing'"),
        ("x,y,angle,frict,q", "the column friction is missing; write it for 'frict'"),
        ("x,y,angle,mu,preloads", "'preloads' is unknown; did you mean preload"),
    ],
)
def test_csv_heads_that_do_not_fit_are_named(head, message):
    text = f"{head}\n-1.5,0,0,0.5,1\n"
    if message is None:
        made = parse_csv(text)
        assert made.grasp.units is None
        assert made.remarks[-1].startswith("only the unit of length is stated, m, so answers have")
        assert parse_csv(PLAIN).remarks == ()
        head, message = f"{head},q [N]", "expected N/m, as the others"
        text = f"{head}\n-1.5,0,0,0.5,1,1\n"
    with pytest.raises(GraspError, match=message):
        parse_csv(text)


def test_csv_columns_may_be_separated_by_spaces(tmp_path):
    text = PLAIN.replace(",", "  ")
    assert parse_csv(text).grasp == FINGERS
    assert read_grasp(written(tmp_path, "grasp.txt", text)) == FINGERS


def test_csv_faults_are_named_at_once():
    head, *rows = PLAIN.splitlines()
    for bad, starts in (
        (["a,0,1,0,1/2,1", "0,0,1,0,1/2,b"], ["line 4: x is 'a'", "5: preload is 'b'"]),
        (["0,0,0,0,1,1", "0,0,1,0,-1,1"], ["line 4: direction is (0, 0)", "5: friction is -1"]),
    ):
        with pytest.raises(GraspError) as refused:
            parse_csv("\n".join([head, *rows, *bad]))
        faults = str(refused.value).split("; line ")
        assert len(faults) == len(starts)
        assert all(map(str.startswith, faults, starts))
    with pytest.raises(GraspError, match=r"; line 7: x is .*; 4 more such$"):
        parse_csv("\n".join([head, *["a,0,1,0,1/2,1"] * 2, rows[0], *["a,0,1,0,1/2,1"] * 7]))
    with pytest.raises(GraspError, match="since the first line has numbers alone; put a line of"):
        parse_csv("\n".join(rows))


def test_faults_of_contacts_are_named_at_once():
    contact = {"point": [0, 0], "normal": [0, 1], "friction": 1}
    contacts = [contact, contact | {"colour": 1}, {"point": [0, 0]}]
    with pytest.raises(InputError, match=r"contacts\[1\] has the unknown.*; contacts\[2\] has no"):
        Grasp.from_dict({"schema_version": 1, "contacts": contacts})
    contacts = [contact | {"friction": -1}, contact, contact | {"point": [0]}]
    with pytest.raises(InputError, match=r"contacts\[0\]: friction is -1.*; contacts\[2\]: "):
        Grasp.from_dict({"schema_version": 1, "contacts": contacts})


@pytest.mark.parametrize("name", ["grasp.csv", "grasp.txt", "grasp.tsv"])
def test_read_grasp_reads_tables(tmp_path, name):
    path = written(tmp_path, name, PLAIN)
    assert read_grasp(path) == read_grasp(str(path)) == FINGERS


@given(grasps(max_contacts=4))
def test_a_grasp_saved_as_a_table_is_read_back(grasp):
    assert parse_csv(table_text(grasp)).grasp == grasp
    stated = grasp.with_units("mm", "N")
    assert parse_csv(table_text(stated)).grasp == stated


def test_a_table_refuses_what_it_has_no_place_for(tmp_path):
    FINGERS.save(tmp_path / "a.csv")
    assert read_grasp(tmp_path / "a.csv") == FINGERS
    first, second = FINGERS
    for grasp, lost in (
        (FINGERS.with_outline(Circle([0, 0], 1)), "an outline"),
        (replace(FINGERS, data_error=DataError(*[Fraction(1, 9)] * 3)), "bounds on errors"),
        (Grasp([replace(first, share=Fraction(1, 2))] * 2), "a pad"),
        (Grasp([first, replace(second, friction=0, thread=(2, 0))]), "a thread"),
    ):
        with pytest.raises(GraspError, match=f"the grasp has {lost}, "):
            grasp.save(tmp_path / "b.csv")
    with pytest.raises(GraspError, match=r"ends in '\.dat'; expected \.json or \.csv"):
        FINGERS.save(tmp_path / "c.dat")
    assert [*tmp_path.iterdir()] == [tmp_path / "a.csv"]


def test_csv_takes_angles_in_degrees():
    text = "x,y,angle,friction\n-1,0,0,0.5\n1,0,180,0.5\n0,-1,90,0.5\n0,1,-60,0.5\n"
    found = parse_csv(text)
    assert [contact.normal for contact in found.grasp][:3] == [(1, 0), (-1, 0), (0, 1)]
    x, y = map(float, found.grasp.contacts[3].normal)
    assert (x, y) == pytest.approx((0.5, -(0.75**0.5)), abs=1e-6)
    with pytest.raises(GraspError, match="angle and normal_x"):
        parse_csv("x,y,angle,normal_x,normal_y,friction\n0,0,0,1,0,1\n")
    with pytest.raises(GraspError, match="line 2: angle"):
        parse_csv("x,y,angle,friction\n0,0,east,1\n")


def written(tmp_path, name, content):
    path = tmp_path / name
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    return path


def test_decimals_of_json_are_read_as_those_of_a_table(tmp_path, run):
    contacts = [
        {"point": [-0.1, 1e-1], "normal": [2.0, 0.0], "friction": 0.3, "preload": 1.25},
        {"point": [0.1, 0], "normal": [-0.6, -0.8], "friction": 0.3, "preload": 0},
    ]
    lines = ["x,y,nx,ny,mu,q", "-0.1,0.1,2,0,0.3,1.25", "0.1,0,-0.6,-0.8,0.3,0"]
    table = read_csv(written(tmp_path, "a.csv", "\n".join(lines)))
    for content in (contacts, {"schema_version": 1, "contacts": contacts}):
        found = read_any(written(tmp_path, "a.json", content))
        assert found.grasp == table.grasp
        assert found.exact
        run("solve {} --wrench 0 0 0", tmp_path / "a.json", code=None)
    assert found.grasp.contacts[1].normal == (Fraction(-3, 5), Fraction(-4, 5))
    assert not any(c.stiffness_given for c in found.grasp)
    with pytest.raises(InputError, match="characters of a number"):
        read_any(written(tmp_path, "a.json", '[{"point": [1e999999, 0], "normal": [1, 0]}]'))


def test_contacts_as_an_engine_prints_them(tmp_path):
    usual = [{"point": [-1, 0], "normal": [1, 0], "friction": "1/2", "preload": 2}]
    for entry in (
        {"position": [-1, 0], "normal": [1, 0], "force": 2, "friction": 0.5},
        {"position": [-1.0, 0], "normal": [3.0, 0], "force": [2.0, 7.0], "friction": 0.5},
        {"position": [-1, 0], "angle": 360, "force": [2, -1], "friction": "1/2"},
    ):
        path = written(tmp_path, "a.json", [entry])
        assert read_any(path).grasp == Grasp.from_dict({"schema_version": 1, "contacts": usual})
        assert read_float_data(path).grasp.contacts == read_any(path).grasp.contacts
    table = written(tmp_path, "a.csv", "px,py,nx,ny,force,mu\n-1,0,1,0,2,1/2\n")
    assert read_csv(table).grasp == read_any(path).grasp
    for wrong, message in (
        ({"position": [0, 0], "point": [0, 0], "normal": [1, 0]}, "position and point; keep one"),
        ({"point": [0, 0], "angle": 0, "normal": [1, 0]}, "angle and normal; keep one"),
        ({"point": [0, 0], "normal": [1, 0], "force": [1, 2, 3]}, "force has 3 numbers"),
        ({"point": [0, 0], "normal": [1, 0], "friction": 1, "force": [-1, 0]}, "preload is -1"),
    ):
        with pytest.raises(InputError, match=message):
            read_any(written(tmp_path, "a.json", [wrong]))


def test_pad_bears_a_turn_as_an_even_patch_does(tmp_path):
    """A segment of half width r has the second moment k r^2 / 3, a disc k r^2 / 4 a diameter."""
    flat = {"point": [0, 0], "normal": [0, 1], "friction": 1, "stiffness": 5, "preload": 3}
    deep = {**flat, "point": [0, 0, 0], "normal": [0, 0, 1]}
    for entry, moment in ((flat, Fraction(1, 3)), (deep, Fraction(1, 4))):
        found = read_any(written(tmp_path, "a.json", [{**entry, "pad": "1/2"}]))
        assert sum(c.stiffness for c in found.grasp) == 5
        assert sum(c.preload for c in found.grasp) == 3
        for axis in range(len(entry["point"]) - 1):
            turn = sum(c.stiffness * c.point[axis] ** 2 for c in found.grasp)
            assert turn == 5 * moment / 4
        (remark,) = found.remarks
        assert "evenly pressed flat pad of radius 1/2" in remark
        assert len(found.grasp) == len(found.to_dict()["grasp"]["contacts"])
    table = written(tmp_path, "a.csv", "x,y,nx,ny,mu,pad\n0,0,0,1,1,1\n4,0,0,1,1,0\n")
    assert len(read_csv(table).grasp) == 4
    with pytest.raises(InputError, match="pad of contact 1 is -1"):
        read_any(written(tmp_path, "a.json", [{**flat, "pad": -1}]))


def test_adhesion_pulls_besides_every_load(tmp_path, run, refused):
    """A suction cup below holds a load up to its pull; its friction is that of its preload."""
    entry = {"point": [0, 0], "normal": [0, 1], "friction": "1/2"}
    path = str(written(tmp_path, "a.json", [{**entry, "adhesion": 2}]))
    assert read_any(path).grasp.adhesion_wrench == (0, -2, 0)
    for force, code in ((2, 0), (3, 1), (-5, 0)):
        run("solve {} --wrench 0 {} 0", path, force, code=code)
        assert "adhesion pulls against the normal of contact" in run.err
    assert run("resisted {} --wrench 0 1 0", path).startswith("resisted for t in [0, 2]\n")
    document = run.json("info {} --wrench 0 1 0", path)
    assert document["intervals"] == [["0", "2"]]
    for words in (["resisted", path], ["draw", path, "-o", str(tmp_path / "a.svg")]):
        run(*words)
    assert "adhesion" in refused("lab {} -o", path, tmp_path / "a.html")
    table = written(tmp_path, "a.csv", "x,y,nx,ny,mu,adhesion\n1,0,0,1,0.5,2\n")
    assert read_csv(table).grasp.adhesion_wrench == (0, -2, -2)


def test_report_of_data_and_a_load(tmp_path, run, refused):
    path = str(written(tmp_path, "a.csv", "x,y,angle,mu,q\n-1,0,0,0.5,1\n1,0,180,0.5,1\n"))
    page = tmp_path / "report.html"
    out = run("info {} --weight 1/2 -o", path, page)
    for line in (
        "stiffness        1 (default)",
        "units            not stated",
        "force closure    yes",
        "form closure     no",
        "load             (0, -1/2, 0)",
        "verdict          resisted: 1 ",
        "margin           resisted when scaled by a factor in [0, 2]",
        "least preload    1/2",
    ):
        assert line in out
    text = page.read_text(encoding="utf-8")
    assert text.count("data:image/svg+xml;base64,") == 1
    assert "resisted when scaled by a factor in [0, 2]" in text
    document = run.json("info {} --wrench 0 5 0", path, code=1)
    assert document["verdict"] == "not resisted"
    assert document["least_preload"] == "5"
    for words in (["--modes"], ["--force-closure"]):
        error = refused("info", path, *words, "-o", page)
        assert "--output goes with the report, not with --" in error
