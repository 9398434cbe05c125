"""A pad is one contact for whoever counts contacts; the law is about its points."""

import json
from dataclasses import replace
from fractions import Fraction

import pytest

from arrangement.errors import InputError
from equilibrium import Contact, Grasp, ResistedSet, solve
from equilibrium.certificate.uncertain import Bounds
from equilibrium.decide.corners import corners
from equilibrium.decide.proofs_for_all import proof_for_all
from equilibrium.grasps.inputs import read_any, read_csv
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
from equilibrium.model.assembly import BodyContact
from equilibrium.model.contact import contact_words, joined, spread
from equilibrium.model.solution import PadForce
from equilibrium.pictures import draw_grasp
from equilibrium.pictures.lab.page import lab_page
from equilibrium.pictures.space_grasp import SolidGrasp

HALF = Fraction(1, 2)
#: A pad against a point, and a pad that floats in space.
PINCH = "x,y,nx,ny,mu,q,pad\n-1,0,1,0,0.5,1,0.5\n1,0,-1,0,0.5,1,0\n"
SPACE = "x,y,z,nx,ny,nz,mu,q,pad\n0,0,-1,0,0,1,0.5,2,0.5\n0,0,1,0,0,-1,0.5,2,1\n"


@pytest.fixture
def pinch(tmp_path):
    path = tmp_path / "pinch.csv"
    path.write_text(PINCH)
    return str(path)


class TestOneContact:
    def test_preloads_are_those_of_contacts(self, pinch, run):
        """A preload of 1/2 is too little; so is what [1/2, oo) would have said."""
        grasp = read_csv(pinch).grasp
        resisted = ResistedSet(grasp)
        assert resisted.margin([0, -1, 0]).preloads.intervals == ((1, None),)
        assert resisted.margin([0, -1, 0]).preloads.contacts == (1, 2)
        assert resisted.preloads([[0, -1, 0]]).intervals == ((1, None),)
        assert [sum(c.preload for c in p) for p in grasp.with_preload(3).parts] == [3, 3]
        assert [sum(c.preload for c in p) for p in grasp.with_preload(3, [1]).parts] == [3, 1]
        for p, stable in ((HALF, False), (1, True)):
            assert solve(grasp.with_preload(p), [0, -1, 0]).stable is stable
        load = "--wrench", "0", "-1", "0"
        assert "uniform preload in [1, oo)" in run("resisted", pinch, *load, "--margin")
        run("solve", pinch, *load, "--preload", "1/2", code=1)
        run("solve", pinch, *load, "--preload", "1")

    def test_numbers_are_those_of_contacts(self, pinch, run, refused):
        margin = "resisted", pinch, "--wrench", "0", "-1", "0", "--margin", "--contacts"
        assert "preload of contact 1 in [1, oo)" in run(*margin, "1")
        assert "numbers of contacts from 1 to 2" in refused(*margin, "3")

    def test_candidate_is_the_whole_pad(self, pinch, run):
        out = run("resisted {} --wrench 0 -3/2 0 --candidates", pinch, pinch, code=1)
        assert [line.split()[1] for line in out.splitlines()] == ["1", "2"]
        assert "pad of radius 1/2" in out.splitlines()[0]
        grasp = read_csv(pinch).grasp
        more, _ = ResistedSet(grasp).with_contact(grasp)
        assert more.grasp.groups == (range(3), range(3, 4), range(4, 7))

    def test_info_lists_contacts(self, pinch, run):
        out = run("info", pinch)
        assert out.splitlines()[0] == "contacts         2 (4 points), in the plane"
        assert "normal (1, 0), friction 1/2, stiffness 1, preload 1, pad of radius 1/2" in out
        document = run.json("info", pinch)
        assert [len(c.get("points", [0])) for c in document["contacts"]] == [3, 1]
        assert not document["stiffness_given"]

    def test_force_is_the_sum_and_where_it_acts(self, pinch, run):
        """A torque of 0.1 that the point cannot bear moves the force of the pad."""
        load = "--wrench", "0", "0", "1/4"
        out = run("solve", pinch, *load)
        assert "contact 2" in out
        assert "contact 3" not in out
        document = run.json("solve", pinch, *load)
        for found in document["equilibria"]:
            (pad,) = found["pads"]
            forces = [[Fraction(x) for x in f] for f in found["forces"]]
            assert [Fraction(x) for x in pad["force"]] == [
                sum(x) for x in zip(*forces[:3], strict=True)
            ]
            assert (pad["contact"], pad["points"]) == (1, [0, 1, 2])
        found = solve(read_csv(pinch).grasp, [0, 0, "1/4"])
        grasp, forces = found.grasp, found.solution.forces
        whole = PadForce.of(grasp.parts[0], forces[:3])
        (x, y), (n, t) = whole.at, whole.force
        c, (other_n, other_t) = grasp.contacts[3], forces[3]
        assert x == -1
        # The normal points along x: the torque of the pad is x t - y n.
        torque = other_n * c.normal_wrench[2] + other_t * c.tangential_wrench[2]
        assert x * t - y * n + torque + Fraction(1, 4) == 0

    def test_picture_numbers_contacts(self, pinch):
        names = [item.name for item in draw_grasp.scene(read_csv(pinch).grasp).items]
        assert [x for x in names if x.startswith("number-")] == ["number-1", "number-2"]
        assert [x for x in names if x.startswith("bar-")] == ["bar-1"]
        solid = SolidGrasp(read_csv(pinch).grasp.in_space())
        assert [text for _, _, text in solid.groups] == ["1", "2"]

    def test_normal_force_at_most_1_is_that_of_the_pad(self, pinch):
        """Whatever the length of a pad, it presses with 1 at most, and bears a torque then."""
        grasp = read_csv(pinch).grasp
        for pads, slope in ((grasp, Fraction(1)), (grasp.without_pads(), Fraction(1, 3))):
            space = GraspWrenchSpace(pads, "Linf")
            assert space.verdict([-1, 0, 0]).least_force == slope
        assert GraspWrenchSpace(grasp, "Linf").volume < space.volume

    def test_lab_takes_each_point_as_a_contact(self, pinch):
        page = lab_page(read_csv(pinch).grasp)
        assert "Here each point of a pad is a contact of its own." in page
        assert '"share"' not in page

    def test_modes_say_that_they_are_about_points(self, pinch, run):
        out = run("info {} --modes --count", pinch)
        assert "a mode is about points, which it numbers as contacts: contact 1 is 1 to 3" in out


class TestFile:
    def test_grasp_file_keeps_pads(self, pinch, tmp_path, run):
        path = tmp_path / "made.json"
        run("make csv {} -o", pinch, path)
        made, given = read_any(str(path)), read_csv(pinch)
        assert made.grasp.groups == given.grasp.groups
        assert made.remarks == given.remarks
        assert made.grasp == given.grasp
        assert [c.stiffness_given for c in made.grasp] == [False] * 4
        words = "resisted --wrench 0 -1 0 --preload 2"
        assert run(words, path) == run(words, pinch)

    def test_rounded_pads_stay_flat(self, tmp_path):
        document = {
            "schema_version": 1,
            "contacts": [
                {"point": [0, 0], "normal": [1, 2], "friction": 1, "preload": 1, "pad": 1},
                {"point": [0, 3], "normal": [-1, -2.5], "friction": 1, "preload": 1},
            ],
        }
        path = tmp_path / "a.json"
        path.write_text(json.dumps(document))
        found = read_any(str(path))
        assert found.grasp.groups == (range(3), range(3, 4))
        assert len(found.point_errors) == len(found.angle_errors) == 4
        # The normal is turned by the rounding, and the edge of the pad with it.
        assert abs(found.angle_errors[1]) <= found.point_errors[1] == found.point_errors[0]
        assert not found.exact
        assert {c.normal for c in found.grasp.parts[0]} == {found.grasp.contacts[0].normal}

    def test_certificate_is_about_points(self, pinch, tmp_path, run):
        path = tmp_path / "c.json"
        load = "--wrench", "0", "-2", "0"
        out = run("solve", pinch, *load, "--certificate", path, code=1)
        assert "contact 1 is 1 to 3, contact 2 is 4" in out
        assert "share" not in path.read_text()
        out = run("verify {} --grasp", path, pinch, *load)
        assert "contact 1 is 1 to 3, contact 2 is 4" in out

    @pytest.mark.parametrize(
        ("contacts", "message"),
        [
            ([{"share": "1/2"}], "expected neighbours whose shares add up to 1"),
            ([{"share": "2/3"}, {"share": "2/3"}], "expected neighbours whose shares add up to 1"),
            ([{"share": 0}], "share is 0"),
            ([{"share": "1/2"}, {"share": "1/2", "point": [0, 1]}], "same height"),
            ([{"share": "1/2"}, {"share": "1/2", "friction": 0}], "the same friction"),
        ],
    )
    def test_shares_are_checked(self, contacts, message):
        entry = {"point": [0, 0], "normal": [0, 1], "friction": 1}
        with pytest.raises(InputError, match=message):
            Grasp.from_dict({"schema_version": 1, "contacts": [entry | c for c in contacts]})

    def test_pads_are_of_one_body(self):
        with pytest.raises(InputError, match="share is 1/2; pads are of one body"):
            BodyContact("a", None, Contact([0, 0], [0, 1], 1, share=HALF))


class TestOtherGrasps:
    @pytest.mark.parametrize("table", [PINCH, SPACE])
    def test_pads_move_as_bodies(self, table, tmp_path):
        path = tmp_path / "a.csv"
        path.write_text(table)
        grasp = read_csv(str(path)).grasp
        points = grasp.parts[0]
        assert spread(points, joined(points)) == points
        normal = (*[0] * (grasp.dimension - 2), Fraction(3, 5), Fraction(4, 5))
        moved = Contact([7] * grasp.dimension, normal, 1, 3, 6)
        turned = spread(points, moved)
        assert joined(turned).point == moved.point
        assert sum(c.preload for c in turned) == 6
        for one, other in zip(points, turned, strict=True):
            before, after = (
                sum((x - y) ** 2 for x, y in zip(c.point, joined(p).point, strict=True))
                for c, p in ((one, points), (other, turned))
            )
            assert before == after
            assert sum(n * (x - 7) for n, x in zip(normal, other.point, strict=True)) == 0

    def test_other_roundings_move_whole_pads(self, tmp_path):
        path = tmp_path / "a.csv"
        path.write_text(PINCH.replace("1,0,0.5,1,0.5", "3,1,0.5,1,0.5"))
        found = read_csv(str(path))
        assert not found.exact
        for seed in range(3):
            other = other_rounding(found.grasp, seed)
            assert other.groups == found.grasp.groups
        verdict = solve(found.grasp, [0, "-1/10", 0])
        others = list(corners(verdict, Bounds(degrees=1, preload="5%"), solve))
        assert len(others) > 2
        assert {other.groups for other in others} == {found.grasp.groups}

    def test_proof_for_all_lets_points_turn_with_the_pad(self, pinch):
        """Normals within 1 degree move the edge of a pad of radius 1/2 by 1/2 pi/180."""
        verdict = solve(read_csv(pinch).grasp, [0, "-1/10", 0])
        proof = proof_for_all(verdict, Bounds(degrees=1))
        assert Fraction(proof.to_dict()["bounds"]["length"]) >= HALF * Fraction(314159, 18000000)
        assert proof.verify()
        alone = solve(verdict.grasp.without_pads(), [0, "-1/10", 0])
        assert proof_for_all(alone, Bounds(degrees=1)).to_dict()["bounds"]["length"] == "0"


def test_torsion_of_a_pad_in_space(tmp_path):
    """Five points hold a torque about the normal, reported about the place of the force."""
    path = tmp_path / "a.csv"
    path.write_text(SPACE)
    verdict = solve(read_csv(str(path)).grasp, [0, 0, 0, 0, 0, "1/4"])
    assert verdict.stable
    forces = [
        PadForce.of(points, verdict.solution.forces[group.start : group.stop])
        for points, group in zip(verdict.grasp.parts, verdict.grasp.groups, strict=True)
    ]
    # Normals are opposite, and so are the signs of the torques about z.
    assert float(forces[0].torsion - forces[1].torsion + Fraction(1, 4)) == pytest.approx(0)
    assert [float(x.force[0]) for x in forces] == pytest.approx([2, 2])
    assert len(verdict.to_dict()["pads"]) == 2
    assert "pad of radius 1" in contact_words(verdict.grasp.parts[1])
    assert repr(verdict.grasp) == "<Grasp: 2 contacts (10 points)>"
    assert replace(verdict.grasp, units=None).joined().contacts[1].preload == 2
