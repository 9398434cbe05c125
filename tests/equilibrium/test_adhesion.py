"""Adhesion: a constant pull of a contact against its normal, in the law and all that knows it."""

from __future__ import annotations

import json
import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from arrangement.errors import InputError
from equilibrium import (
    Assembly,
    BodyContact,
    Contact,
    Grasp,
    ResistedSet,
    compare,
    inputs,
    solve,
    solve_many,
)
from equilibrium.certificate.checker import check
from equilibrium.certificate.leaves import parts, spatial_leaves, works
from equilibrium.decide.many_grasps import check_grasps
from equilibrium.grasps.schemas import (
    assembly_certificate_schema,
    assembly_schema,
    certificate_schema,
)
from equilibrium.methods.registry import METHODS
from equilibrium.model.unit_normal import unit_normal
from equilibrium.pictures.grasp import GraspLayout
from equilibrium.pictures.lab.page import lab_page
from equilibrium.scenes import EngineScene
from tests.schemas import validator

NORMALS = {
    2: [(1, 0), (0, 1), (-1, 0), (0, -1), ("3/5", "4/5"), ("-4/5", "3/5")],
    3: [(1, 0, 0), (0, 0, 1), (0, -1, 0), ("1/3", "2/3", "2/3"), ("-3/5", 0, "4/5")],
}
Wrench = tuple[Fraction, ...]
CUPS = "x,y,nx,ny,mu,adhesion\n-1,1,0,-1,0.5,50\n1,1,0,-1,0.5,50\n"
HANGING = Grasp([Contact([x, 1], [0, -1], "1/2", adhesion=50) for x in (-1, 1)])


def random_contact(source: random.Random, dimension: int) -> Contact:
    return Contact(
        [Fraction(source.randint(-6, 6), 2) for _ in range(dimension)],
        source.choice(NORMALS[dimension]),
        source.choice([0, "1/2", 1]),
        source.choice([1, 2]),
        source.choice([0, 1]),
        adhesion=source.choice([1, "3/2", 4]),
    )


def pull(contact: Contact) -> Wrench:
    """The wrench of the adhesion, without the package's own."""
    x, y, *z = contact.point
    a, b, *c = (-contact.adhesion * n for n in contact.normal)
    if not z:
        return a, b, x * b - y * a
    return a, b, c[0], y * c[0] - z[0] * b, z[0] * a - x * c[0], x * b - y * a


def added(*wrenches: Any) -> Wrench:
    return tuple(map(sum, zip(*wrenches, strict=True)))  # type: ignore[arg-type]


def bare(contact: Contact) -> Contact:
    return replace(contact, adhesion=Fraction(0))


def questions(dimension: int, count: int, seed: int) -> Any:
    """Random grasps and loads, with those that mean the same without adhesion."""
    source = random.Random(seed)
    for k in range(count):
        grasp = Grasp(random_contact(source, dimension) for _ in range(source.randint(1, 3)))
        load = tuple(Fraction(source.randint(-6, 6), 2) for _ in range(grasp.wrench_size))
        if k % 2:  # one that contact forces balance
            pressed = [
                c.total_force((k % 3, c.friction / 2, *[0] * (dimension - 2))) for c in grasp
            ]
            ends = (replace(c, normal=c.normal) for c in grasp)
            load = added(*(moment(c, f) for c, f in zip(ends, pressed, strict=True)))
        yield grasp, load, Grasp(map(bare, grasp)), added(load, *map(pull, grasp))


def moment(contact: Contact, force: Wrench) -> Wrench:
    x, y, *z = contact.point
    a, b, *c = (-f for f in force)
    if not z:
        return a, b, x * b - y * a
    return a, b, c[0], y * c[0] - z[0] * b, z[0] * a - x * c[0], x * b - y * a


@pytest.mark.parametrize("dimension", [2, 3])
def test_adhesion_is_a_shift_of_the_load_for_fixed_normals(dimension):
    seen = set()
    for grasp, load, other, total in questions(dimension, 8, 5):
        found = solve(grasp, load)
        assert found.verdict == solve(other, total).verdict
        assert found.verify()
        assert found.wrench == load
        document = found.certificate.to_dict()
        assert not check(document, (other, load))
        assert not check(document, (other, total))
        seen.add(found.verdict)
        assert [a.accepts for a in compare(grasp, load).answers[:7]] == [
            a.accepts for a in compare(other, total).answers[:7]
        ]
    assert seen == {"resisted", "not resisted"}


def test_sets_margins_and_batches_have_adhesion():
    for k, (grasp, load, other, total) in enumerate(questions(2, 4, 3)):
        one, two = ResistedSet(grasp), ResistedSet(other)
        rest = grasp.adhesion_wrench
        assert one.along((1, 2, 0), load).intervals == two.along((1, 2, 0), total).intervals
        if any(load):
            assert one.margin(load).intervals == two.along(load, rest).intervals
        assert one.margin(load).preloads.intervals == two.margin(total).preloads.intervals
        assert one.preloads([load], [1]).intervals == two.preloads([total], [1]).intervals
        wrenches = [load, (0, 0, 0)]
        verdicts = [v.stable for v in solve_many(grasp, wrenches)]
        assert verdicts == [v.stable for v in solve_many(other, [total, rest])]
        if k % 3 == 0:
            assert one.margin(load).friction().high == two.margin(total).friction().high
            assert one.smallest_outside(load).wrench == two.smallest_outside(total).wrench
            assert any(p.polyhedron.contains(load) for p in one.polyhedra) == verdicts[0]
            for key in ("complete", "cones", "weak", "frictionless", "wrench-space-L1"):
                spans = (1, 0, 0), (0, 1, 0)
                regions = (
                    METHODS[key].find_region(g, spans, w)
                    for g, w in ((grasp, load), (other, total))
                )
                assert len({region.contains((0, 0)) for region in regions}) == 1


def test_proofs_in_space_tell_which_loads_they_refute():
    grasp = Grasp([Contact([0, 0, 1], [0, 0, -1], "1/2", adhesion=3)])
    found = solve(grasp, (0, 0, -4, 0, 0, 0))
    assert found.verdict == "not resisted"
    (leaf,) = spatial_leaves(found.proof)
    assert leaf.least + sum(x * y for x, y in zip(leaf.motion, found.wrench, strict=True)) > 0
    (border,) = ResistedSet(grasp).along((0, 0, -1, 0, 0, 0)).borders
    assert border.resisted <= 3 < border.refused < 3.01


def test_assembly_contact_pulls_both_bodies():
    """A cup between two hanging bodies holds the lower one, and pulls at the upper one."""
    above = Contact([0, 2], [0, -1], "1/2", adhesion=5)
    between = Contact([0, 1], [0, -1], "1/2", adhesion=2)
    bodies = Assembly(
        ["upper", "lower"],
        [BodyContact("upper", None, above), BodyContact("lower", "upper", between)],
    )
    for upper, lower, held in ((3, 2, True), (2, 3, False), (4, 2, False)):
        found = solve(bodies, {"upper": (0, -upper, 0), "lower": (0, -lower, 0)})
        assert found.stable is held
        assert found.verify()
    assert "adhesion 5" in "".join(solve(bodies, {"upper": (0, 0, 0)}).lines())
    turned = replace(bodies, contacts=(bodies.contacts[0], bodies.contacts[1].reversed))
    loads = {"upper": (0, -3, 0), "lower": (0, -2, 0)}
    assert solve(turned, loads).stable
    along = ResistedSet(bodies).along({"lower": (0, -1, 0)})
    assert along.intervals == ((0, 2),)
    assert Assembly.from_dict(json.loads(json.dumps(bodies.to_dict()))) == bodies


def test_assemblies_decide_the_shifted_question():
    source = random.Random(2)
    for _ in range(8):
        pairs = [("a", None), ("b", "a"), ("b", None), ("a", "b")][: source.randint(2, 4)]
        joints = [BodyContact(*pair, random_contact(source, 2)) for pair in pairs]
        loads = {
            name: (Fraction(source.randint(-3, 3)), Fraction(-2), Fraction(0)) for name in "ab"
        }
        total = dict(loads)
        for joint in joints:
            total[joint.body_a] = added(total[joint.body_a], pull(joint.contact))
            if joint.body_b:
                back = tuple(-x for x in pull(joint.contact))
                total[joint.body_b] = added(total[joint.body_b], back)
        other = Assembly(["a", "b"], [replace(j, contact=bare(j.contact)) for j in joints])
        found = solve(Assembly(["a", "b"], joints), loads)
        assert found.verdict == solve(other, total).verdict
        assert found.verify()
        assert found.balances_rigidly == solve(other, total).balances_rigidly


def turned(grasp: Grasp, source: random.Random, tangent: Fraction) -> Grasp:
    """A grasp whose normals are turned by up to an angle."""
    contacts = []
    for c in grasp:
        shares = [Fraction(source.choice([-64, -32, 32, 64]), 64) for _ in c.tangents]
        towards = [sum(s * x for s, x in zip(shares, column, strict=True)) * tangent / len(shares)
                   for column in zip(*c.tangents, strict=True)]  # fmt: skip
        wanted = [x + y for x, y in zip(c.normal, towards, strict=True)]
        contacts.append(replace(c, normal=unit_normal(wanted, tangent / 1000).normal, tangent=None))
    return Grasp(contacts)


@pytest.mark.parametrize("grasp", [HANGING, HANGING.in_space()])
def test_adhesion_turns_with_its_normal(grasp):
    """At the limit of two cups a small turn of both loses the load."""

    def load(weight: int) -> Wrench:
        return (0, -weight, 0) if grasp.dimension == 2 else (0, -weight, 0, 0, 0, 0)

    near = solve(grasp, load(99)).robust(degrees=1)
    assert sum("adhesion 50" in line for line in near.lines()) == 2
    assert near.answer == "does not hold"
    assert near.turned.verdict == "not resisted"
    assert near.turned.verify()
    source, unproved = random.Random(1), list[Any]()
    for weight in (80, 101, 110):
        verdict = solve(grasp, load(weight))
        for bounds in ({"degrees": 1}, {"degrees": 1, "adhesion": "5%"}):
            proved = verdict.robust(**bounds)
            if not proved:
                unproved.append((weight, len(bounds), proved.answer))
                continue
            assert check(proved.certificate.to_dict())
            for _ in range(2):
                other = turned(grasp, source, Fraction(17, 1000))
                share = Fraction(source.choice([-1, 1]) * (len(bounds) - 1), 20)
                other = other.with_adhesion(50 * (1 + share))
                assert solve(other, load(weight)).verdict in (verdict.verdict, "undecided")
    assert unproved == [(80, 2, "undecided"), (101, 2, "does not hold")]


def test_changed_adhesion_breaks_a_proof_for_all():
    proof = solve(HANGING, (0, -80, 0)).robust(degrees=1).certificate.to_dict()
    assert check(proof)
    proof["grasp"]["contacts"][0]["adhesion"] = "40"
    assert "correction may be larger" in check(proof).problem
    proof = solve(HANGING, (0, -110, 0)).robust(degrees=1).certificate.to_dict()
    for more, problem in (("60", ""), ("70", "no work above 0")):
        proof["grasp"]["contacts"][0]["adhesion"] = more
        assert problem in check(proof).problem or check(proof)
    assert not check(proof)


def test_rounded_adhesion_is_not_proved_at_its_limit(tmp_path, run):
    path = tmp_path / "a.csv"
    head = "x,y,nx,ny,mu,adhesion,pad\n"
    path.write_text(f"{head}0,1,0.0000009,-1,0.5,10000000,1\n")
    assert "within the rounding error: proved" not in run("solve {} --weight 9999999", path, code=3)


def test_files_certificates_and_the_checker_keep_adhesion(tmp_path, run):
    table = tmp_path / "a.csv"
    table.write_text(CUPS)
    proof = str(tmp_path / "proof.json")
    for kind in ("csv", "floats"):
        made = str(tmp_path / f"{kind}.json")
        run("make {} {} -o", kind, table, made)
        for weight, code in (("100", 0), ("101", 1)):
            load = ["--weight", weight]
            run("solve", made, *load, "--certificate", proof, code=code)
            for path in (str(table), made):
                assert "adhesion 50" in run("verify {} --grasp", proof, path, *load)
            document = json.loads((tmp_path / "proof.json").read_text())
            assert check(document)
            document["grasp"]["contacts"][0]["adhesion"] = "49" if code == 0 else "53"
            assert not check(document)
    other = tmp_path / "b.csv"
    other.write_text(CUPS.replace("50\n", "51\n", 1))
    printed = run("verify {} --grasp {} --weight 101", proof, other, code=1)
    assert "adhesion of contact 1 is 50; expected 51" in printed


def test_enclosure_counts_adhesion():
    """Slip in a direction that is not rational: the box has the pull as a part of the load."""
    one = Contact(["-3/2", "1/2", "1/2"], [-1, 0, 0], 1, 1, 1, adhesion="3/2")
    normal = ["2/7", "3/7", "-6/7"]
    other = Contact(["-1/2", "-3/2", "-1/2"], normal, "1/3", 2, adhesion=4)
    grasp = Grasp([one, other])
    load = ("6/7", "20/21", "-26/21", "10/3", "-1/21", "-4/21")
    found = solve(grasp, load)
    assert found.solution.box
    assert found.verify()
    document = found.certificate.to_dict()
    document["grasp"]["contacts"][0]["adhesion"] = "2"
    assert not check(document)


def test_pad_shares_its_adhesion(tmp_path):
    for text in (
        "x,y,nx,ny,mu,adhesion,pad\n1,2,0.6,0.8,0.5,7,0.5\n",
        "x,y,z,nx,ny,nz,mu,adhesion,pad\n1,2,3,0.6,0.8,0,0.5,7,0.5\n",
    ):
        path = tmp_path / "a.csv"
        path.write_text(text)
        grasp = inputs.read_csv(path).grasp
        assert len(grasp) > 1
        point, normal = (
            ([1, 2], ["3/5", "4/5"]) if len(grasp) == 3 else ([1, 2, 3], ["3/5", "4/5", 0])
        )
        assert grasp.adhesion_wrench == pull(Contact(point, normal, 0, adhesion=7))


def test_places_on_a_polygon_may_have_adhesion():
    square = [[0, 0], [2, 0], [2, 2], [0, 2]]
    place = {"edge": 2, "at": "1/2", "friction": "1/2", "adhesion": 3}
    document = {"schema_version": 1, "polygon": square, "places": [place]}
    assert inputs.read_polygon(document).grasp.adhesion_wrench == (0, 3, 3)


def test_works_of_a_leaf_count_adhesion():
    found = solve(HANGING, (0, -110, 0))
    (part,) = parts(found.proof)
    done = works(HANGING, found.wrench, [part])
    assert done.load == 10 * -part.leaf.motion[1]
    assert done.load + done.least > 0


def test_arrows_of_forces_close_with_the_load():
    verdict = solve(HANGING, (0, -60, 0))
    layout = GraspLayout(HANGING, verdict)
    assert np.allclose(sum(arm for arms in layout.arms for arm in arms) + layout.loads[0].arm, 0)


def test_arrays_of_many_grasps_have_adhesion():
    points = np.array([[[-1.0, 1], [1, 1]]] * 2)
    normals = np.array([[[0.0, -1], [0, -1]]] * 2)
    loads = [[0, -99.0, 0], [0, -101, 0]]
    checked = check_grasps(points, normals, 0.5, loads, adhesion=[[50.0], [51]])
    assert checked.resisted.tolist() == [[True, False], [True, True]]
    assert checked.exact.all()
    assert checked.grasp(0) == HANGING
    with pytest.raises(InputError, match=r"adhesion\[0, 0\] is -1"):
        check_grasps(points, normals, 0.5, loads, adhesion=-1)


@pytest.mark.parametrize("value", [-1, 0.5])
def test_adhesion_is_exact_and_not_negative(value):
    with pytest.raises(InputError, match="adhesion"):
        Contact([0, 0], [0, 1], 0, adhesion=value)


def test_answers_in_a_notebook_and_a_report_name_it(tmp_path, run):
    html = solve(HANGING, (0, -99, 0))._repr_html_()
    assert "under w = (0, -99, 0) and the adhesion (0, 100, 0)" in html
    path = tmp_path / "a.csv"
    path.write_text(CUPS)
    out = run("info {} --weight 99", path)
    for words in ("without adhesion", "1/2     0           adhesion 50", "in [0, 100/99]"):
        assert words in out


def test_grasps_without_adhesion_are_written_as_before():
    contact = Contact([0, 0], [0, 1], 0)
    assert "adhesion" not in contact.to_dict()
    assert "adhesion" not in contact.words
    assert contact != replace(contact, adhesion=Fraction(1))
    stuck = HANGING.with_preload(2).with_friction(1)
    assert stuck.adhesion_wrench == (0, 100, 0)
    assert Grasp.from_dict(stuck.to_dict()) == stuck


def test_schemas_have_adhesion():
    bodies = Assembly.of_grasp(HANGING)
    held = solve(bodies, {"object": (0, -99, 0)})
    proof = solve(HANGING, (0, -110, 0)).robust(degrees=1, adhesion="5%").certificate
    for schema, document in (
        (assembly_schema(), bodies.to_dict()),
        (assembly_certificate_schema(), held.certificate.to_dict()),
        (certificate_schema(), proof.to_dict()),
    ):
        assert "adhesion" in json.dumps(document)
        assert validator(schema).is_valid(document)


def test_what_knows_no_adhesion_refuses_it():
    for made in (lambda: lab_page(HANGING), lambda: EngineScene(HANGING, [[0, 1, 0]])):
        with pytest.raises(InputError, match="adhesion"):
            made()
