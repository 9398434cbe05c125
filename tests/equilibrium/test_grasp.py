"""Contacts, grasps and unit normals: conventions, validation, identity."""

import json
import re
from fractions import Fraction

import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement.errors import InputError
from equilibrium import Contact, Grasp, GraspError, read_grasp, solve, unit_normal
from equilibrium.cli.solve import AS_PRINTED
from equilibrium.decide.as_printed import OPTIONS
from equilibrium.grasps.inputs.documents import read_any
from equilibrium.grasps.instances import paths
from equilibrium.model import grasp as model
from equilibrium.model.grasp import read_wrench, wrench_of
from equilibrium.model.labels import Units
from equilibrium.model.outline import Mesh, Polygon
from equilibrium.wrench_sets.line import resisted_magnitudes

from .strategies import contacts, grasps, wrenches


def test_tangent_left_of_normal_torque_counterclockwise():
    contact = Contact((-1, 1), (1, 0), "1/2")
    assert contact.tangent == (0, 1)
    assert contact.normal_wrench == (1, 0, -1)
    assert contact.tangential_wrench == (0, 1, -1)


@given(contacts, st.tuples(*[st.integers(-3, 3)] * 3))
def test_wrench_times_motion_is_contact_displacement(contact, motion):
    x, y, r = motion
    moved = (x - r * contact.point[1], y + r * contact.point[0])
    for wrench, along in (
        (contact.normal_wrench, contact.normal),
        (contact.tangential_wrench, contact.tangent),
    ):
        assert sum(a * b for a, b in zip(wrench, motion, strict=True)) == sum(
            a * b for a, b in zip(moved, along, strict=True)
        )


def test_equal_contacts_are_equal_whatever_the_number_type():
    texts = Contact(("1/2", "0"), ("0.6", "0.8"), "0.5", "1", "0")
    others = Contact((sympy.Rational(1, 2), 0), (Fraction(3, 5), Fraction(4, 5)), Fraction(1, 2))
    assert texts == others
    assert hash(texts) == hash(others)
    assert Grasp([texts]) == Grasp([others])
    assert len({Grasp([texts]), Grasp([others])}) == 1


def test_values_are_frozen():
    contact = Contact((0, 0), (1, 0), 0)
    with pytest.raises(AttributeError):
        contact.friction = Fraction(1)


@given(grasps(4))
def test_file_form_round_trip(grasp):
    assert Grasp.from_dict(grasp.to_dict()) == grasp


FLAT, DEEP = Contact((1, 2), (0, 1), 1, 2, 3), Contact((1, 2, 3), (0, 0, 1), 1)
SQUARE, SOLID = (
    Polygon([(0, 0), (1, 0), (1, 1)]),
    Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]),
)


class TestValues:
    """What a grasp takes, keeps and refuses."""

    @pytest.mark.parametrize(
        ("contacts", "outline", "words"),
        [
            ([FLAT, DEEP, FLAT], None, "contacts[1] is in space, and contacts[0] in the plane;"),
            ([FLAT, FLAT, DEEP], None, "contacts[2] is in space, and contacts[0] in the plane;"),
            ([DEEP, FLAT], None, "contacts[1] is in the plane, and contacts[0] in space;"),
            ([DEEP], SQUARE, "the outline is in the plane, and contacts[0] in space;"),
            ([FLAT, FLAT], SOLID, "the outline is in space, and contacts[0] in the plane;"),
            ([FLAT], "a square", "outline is 'a square'; give"),
        ],
    )
    def test_all_of_it_is_in_the_plane_or_in_space(self, contacts, outline, words):
        with pytest.raises(GraspError, match=re.escape(words)):
            Grasp(contacts, outline=outline)

    def test_labels_are_kept_and_others_refused(self):
        units = Units("mm", "N")
        grasp = Grasp([FLAT], units, SQUARE)
        assert (grasp.units, grasp.outline, grasp.dimension) == (units, SQUARE, 2)
        assert Grasp([DEEP], outline=SOLID).dimension == 3
        assert Grasp().dimension == 2
        with pytest.raises(GraspError, match="units is 'mm'; give"):
            Grasp([FLAT], "mm")

    def test_motion_planes_are_no_slip_and_zero_spring(self):
        (tangential, normal) = Grasp([FLAT]).motion_arrangement().integer_planes
        assert tangential == (-1, 0, 2, 0)
        assert normal == (0, 2, 2, 3)

    def test_force_acts_at_the_origin_by_default(self):
        assert wrench_of((1, 2)) == (1, 2, 0)
        assert wrench_of((1, 2), (3, 5)) == (1, 2, 1)
        assert wrench_of((1, 2, 3), dimension=3) == (1, 2, 3, 0, 0, 0)
        assert wrench_of((1, 2, 3), (1, 0, 0), 3) == (1, 2, 3, 0, -3, 2)

    @pytest.mark.parametrize("length", [0, 2, 4, 5, 7])
    def test_a_wrench_of_the_wrong_length_names_the_right_one(self, length):
        end = r" \(decimals have a point\)$" if length > 3 else "$"
        with pytest.raises(GraspError, match=f"in the plane takes 3: f_x, f_y and tau{end}"):
            read_wrench([0] * length)
        with pytest.raises(GraspError, match=r"in space takes 6: f_x, f_y, f_z, tau_x, tau_y and"):
            read_wrench([0] * length, 3)

    @pytest.mark.parametrize("version", [True, "1", 0, 2, 1.0])
    def test_another_version_of_the_file_is_refused(self, version):
        with pytest.raises(GraspError, match="this version reads 1"):
            Grasp.from_dict({"schema_version": version, "contacts": []})

    def test_a_file_has_a_line_for_each_entry(self, tmp_path):
        Grasp([FLAT]).save(tmp_path / "grasp.json")
        lines = (tmp_path / "grasp.json").read_text().splitlines(keepends=True)
        assert lines[1] == ' "schema_version": 1,\n'
        assert lines[-1] == "}\n"

    def test_notebook_shows_grasps_in_the_plane_and_in_space(self, monkeypatch):
        monkeypatch.setattr(model, "method_code", lambda _: len)
        assert [Grasp([contact])._repr_svg_() for contact in (FLAT, DEEP)] == [1, 1]


def test_normal_that_is_not_unit_names_the_remedy():
    for normal in ((1, 1), (0, 0), ("0.6", "0.80000000000000000001")):
        with pytest.raises(GraspError, match=r"unit_normal\(direction, tolerance\)"):
            Contact((0, 0), normal, 1)


@pytest.mark.parametrize(
    ("direction", "normal"),
    [
        *((axis, axis) for axis in ((1, 0), (0, 1), (-1, 0), (0, -1))),
        ((0, 2.5), (0, 1)),
        *(((x, y), (Fraction(x, 5), Fraction(y, 5))) for x in (-3, 3) for y in (-4, 4)),
    ],
)
def test_rational_lengths_are_exact_in_every_quadrant(direction, normal):
    assert unit_normal(direction) == (normal, 0)


@given(
    st.tuples(*[st.floats(-1e6, 1e6).filter(lambda x: x == 0 or abs(x) > 1e-6)] * 2).filter(any),
    st.sampled_from([Fraction(1), Fraction(1, 100), Fraction(1, 10**12)]),
)
def test_unit_normal_is_unit_and_within_the_tolerance(direction, tolerance):
    normal, error = unit_normal(direction, tolerance)
    assert normal[0] ** 2 + normal[1] ** 2 == 1
    wanted = tuple(map(Fraction, direction))
    sine = wanted[0] * normal[1] - wanted[1] * normal[0]
    cosine = wanted[0] * normal[0] + wanted[1] * normal[1]
    assert cosine > 0
    assert error * cosine == sine
    assert abs(error) <= tolerance


@pytest.mark.parametrize(
    ("direction", "tolerance"),
    [((0, 0), "1/10"), ((1,), "1/10"), ((1, 1), 0), ((1, 1), 2), ((float("nan"), 1), "1/10")],
)
def test_unit_normal_refuses(direction, tolerance):
    with pytest.raises(InputError):
        unit_normal(direction, tolerance)


def test_repr_of_public_objects_is_one_short_line():
    grasp = read_grasp("paper-three-contacts-preload-1")
    held, lost = (solve(grasp, [0, pull, 0]) for pull in (1, 5))
    shown = (grasp, grasp.contacts[0], held, lost, held.solution, *held.equilibria)
    for text in map(repr, (*shown, held.certificate, lost.certificate, lost.verify())):
        assert len(text) <= 100
        assert "\n" not in text
        assert "Fraction" not in text
    assert "not resisted" in repr(lost)


def test_decimals_in_a_grasp_file_are_exact(tmp_path):
    path = tmp_path / "measured.json"
    contact = {"point": [0, 0.02], "normal": [0, 1], "friction": "1/2"}
    path.write_text(json.dumps({"schema_version": 1, "contacts": [contact]}), encoding="utf-8")
    assert read_grasp(path).contacts[0].point == (0, Fraction(1, 50))
    assert read_any(path).grasp.contacts[0].point == (0, Fraction(1, 50))


def test_a_saved_grasp_is_read_back(tmp_path):
    grasp = read_grasp("paper-three-contacts-preload-1").with_units("mm", "N")
    grasp.save(tmp_path / "grasp.json")
    found = read_grasp(tmp_path / "grasp.json")
    assert found == grasp
    assert found.units == grasp.units


@pytest.mark.parametrize("name", paths())
def test_every_built_in_grasp_reads_and_describes_itself(name):
    assert len(read_grasp(name)) > 0
    description = json.loads(paths()[name].read_bytes())["description"]
    assert ("preload 1" in description) == any(c.preload == 1 for c in read_grasp(name))
    assert ("no preload" in description) <= all(c.preload == 0 for c in read_grasp(name))


def test_resistance_is_interrupted_and_goes_on():
    found = resisted_magnitudes(read_grasp("interrupted-resistance"), (0, 1, 0))
    assert found.intervals == ((0, Fraction(5, 2)), (4, None))


def test_friction_along_slip_in_printed_algorithm_only():
    question = read_grasp("friction-along-slip"), (0, 0, 1)
    assert not solve(*question).stable
    (found,) = solve(*question, as_printed=["cell-check", "detachment"]).equilibria
    pushed = [
        sum(a * b for a, b in zip(contact.tangential_wrench, found.motion, strict=True))
        * tangential
        for contact, (_, tangential) in zip(question[0], found.forces, strict=True)
    ]
    assert max(pushed) > 0


def test_one_contact_has_to_let_go():
    question = read_grasp("one-contact-lets-go"), (-1, 0, 0)
    assert all(piece.states[1] == "detached" for piece in solve(*question).equilibria)
    assert solve(*question).stable
    assert not solve(*question, as_printed=["detachment"]).stable


def test_all_contacts_stick_in_the_only_equilibrium():
    (found,) = solve(read_grasp("all-contacts-stick"), (0, 0, 0)).equilibria
    assert found.unique
    assert found.motion == (0, 0, 0)
    assert found.states == ("stick",) * 3


def test_the_normals_of_the_offset_grasp_meet_in_no_point():
    rows = [contact.normal_wrench for contact in read_grasp("offset-three-contacts")]
    (a, b, c), (d, e, f), (g, h, i) = rows
    assert a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) != 0


THREE = read_grasp("paper-three-contacts")
FOUR = read_grasp("paper-four-contacts")


@given(grasps(), wrenches)
def test_no_option_is_the_complete_model(grasp, wrench):
    assert solve(grasp, wrench, as_printed=()).equilibria == solve(grasp, wrench).equilibria


def verdicts(grasp, wrench, option):
    return solve(grasp, wrench).stable, solve(grasp, wrench, as_printed=[option]).stable


LOADED = THREE.with_preload(1)


@pytest.mark.parametrize(
    ("grasp", "wrench", "option"),
    [
        (FOUR, (0, 0, 3), "detachment"),
        (FOUR, (0, 0, -3), "detachment"),
        (LOADED, (0, 1, 0), "preload"),
        (LOADED, (0, 1, 0), "signs"),
        (LOADED, (0, -1, 0), "all-stick"),
    ],
)
def test_a_row_of_the_tables_is_lost(grasp, wrench, option):
    assert verdicts(grasp, wrench, option) == (True, False)


def test_without_the_cell_check_an_unstable_grasp_passes():
    assert verdicts(read_grasp("unchecked-cell"), (2, 0, 2), "cell-check") == (False, True)


@pytest.mark.parametrize(
    ("motion", "stable"),
    [
        # Contacts 0 and 1 stick, 2 and 3 slip; forces chosen inside the cones.
        ((Fraction(0), Fraction(1, 4), Fraction(1, 4)), (True, False)),
        # All slip, and no choice of forces without slip balances the same load.
        ((Fraction(-1, 2), Fraction(-1, 2), Fraction(1, 4)), (True, True)),
    ],
)
def test_without_merging_coincident_planes_facets_are_lost(motion, stable):
    grasp = FOUR.with_preload(1)
    forces = []
    for contact in grasp:
        gap = sum(a * b for a, b in zip(contact.normal_wrench, motion, strict=True))
        slip = sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        normal = max(contact.preload - gap, Fraction(0))
        forces.append((normal, Fraction(0) if slip == 0 else -normal / 2 * (1 if slip > 0 else -1)))
    wrench = [
        -sum(
            n * c.normal_wrench[axis] + t * c.tangential_wrench[axis]
            for c, (n, t) in zip(grasp, forces, strict=True)
        )
        for axis in range(3)
    ]
    assert verdicts(grasp, wrench, "coincident-planes") == stable


def test_stopping_at_the_first_solution_misses_the_second():
    question = read_grasp("several-equilibria"), (-1, 0, 0)
    assert len({piece.forces[0][0] for piece in solve(*question).equilibria}) == 2
    assert len(solve(*question, as_printed=["single-solution"]).equilibria) == 1


@given(grasps(), wrenches)
def test_as_printed_options_are_monotone(grasp, wrench):
    stable = solve(grasp, wrench).stable
    for option in ("detachment", "all-stick", "coincident-planes"):
        assert solve(grasp, wrench, as_printed=[option]).stable <= stable
    assert stable <= solve(grasp, wrench, as_printed=["cell-check"]).stable


@given(grasps(), wrenches)
def test_options_combine_in_any_order(grasp, wrench):
    forward = solve(grasp, wrench, as_printed=list(OPTIONS))
    assert forward == solve(grasp, wrench, as_printed=list(OPTIONS)[::-1])
    assert forward.options == tuple(OPTIONS)


def test_unknown_option_is_refused():
    with pytest.raises(GraspError, match="cell-check"):
        solve(THREE, (0, 0, 0), as_printed=["cellcheck"])


def test_command_line_knows_every_option():
    assert tuple(OPTIONS) == AS_PRINTED


@pytest.mark.parametrize("key", ["stiffness", "preload", "friction", "tangent"])
def test_null_is_not_a_value_of_a_contact(key):
    entry = {"point": ["0", "-1"], "normal": ["0", "1"], "friction": "1/2", key: None}
    with pytest.raises(GraspError, match=rf"contacts\[0\].*{key}"):
        Grasp.from_dict({"schema_version": 1, "contacts": [entry]})
