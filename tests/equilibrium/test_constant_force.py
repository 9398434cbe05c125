"""Contacts of constant force (stiffness 0): in rounded data, and between bodies."""

from fractions import Fraction as F
from itertools import product
from random import Random

import pytest

from equilibrium import Assembly, BodyContact, Contact, Grasp, ResistedSet, solve
from equilibrium.certificate.checker import check
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.grasps.inputs.csv_file import parse_csv

HEADER = "x,y,nx,ny,mu,q,stiffness\n"
#: Fingers of constant force, with normals that have no exact length; the last one has a spring.
SQUEEZED = HEADER + "-1,0,3,1,0.5,1,0\n1,0,-3,-1,0.5,1,0\n0,-1,1,2,0.5,1,2\n"
_STATES = "detached", "stick", "slip+", "slip-"
_NORMALS = (1, 0), (0, 1), (-1, 0), (0, -1), (F(3, 5), F(4, 5)), (F(-4, 5), F(-3, 5))


@pytest.mark.parametrize(
    ("table", "wrench"),
    [(HEADER + "0,0,1,1,0.5,1,0\n", (0, 0, 0)), (SQUEEZED, (0, 0, 0)), (SQUEEZED, (-1, -1, 0))],
)
def test_rounded_constant_force_is_decided(table, wrench, tmp_path, run):
    grasp = parse_csv(table).grasp
    verdict = solve(grasp, wrench)
    assert verdict.verdict == solve(Grasp(grasp.contacts), wrench).verdict
    assert verdict.answer.startswith(verdict.to_dict()["verdict"])
    assert (wrench in ResistedSet(grasp)) == verdict.stable
    path = tmp_path / "a.csv"
    path.write_text(table)
    words = [str(path), "--wrench", *map(str, wrench)]
    run("solve", *words, code=1 - verdict.stable)
    run("info", *words, code=None)
    assert "internal" not in run.err


def test_proof_for_all_of_a_constant_force_is_refused():
    held = Grasp([Contact((x, 0), (-x, 0), "1/2", preload=2) for x in (-1, 1)])
    document = solve(held, (0, "-1/2", 0)).robust(friction="5%").certificate.to_dict()
    assert check(document)
    document["grasp"]["contacts"][0]["stiffness"] = "0"
    assert "contact 0: it has no spring" in check(document).problem


def test_contact_without_stiffness_and_preload_is_detached():
    grasp = Grasp([Contact((0, 0), (0, 1), 1), Contact((0, 1), (0, -1), 1, 0, 0)])
    found = solve(grasp, (1, -1, 0)).equilibria
    assert [one.states[1] for one in found] == ["detached"] * len(found)
    assert len(found) == 1


def between_bodies(seed):
    """Return an assembly, most of whose contacts have constant forces, and wrenches."""
    source = Random(seed)
    names = ["a", "b"][: 1 + seed % 3]
    contacts = []
    for _ in range(source.randint(1, 4)):
        body = source.choice(names)
        other = source.choice([None, *(x for x in names if x != body)])
        place = source.randint(-2, 2), source.randint(-2, 2)
        values = source.choice([0, F(1, 2), 1]), source.choice([0, 0, 0, 1]), source.choice([0, 1])
        contacts.append(BodyContact(body, other, Contact(place, source.choice(_NORMALS), *values)))
    assembly = Assembly(names, contacts)
    load = [F(0)] * (3 * len(names))
    # What the contacts press at rest, with a share of friction.
    for row in assembly.rows:
        rub = row.friction * row.preload * F(source.randint(-3, 3), 4 - seed % 2)
        pairs = zip(load, row.normal_wrench, row.tangential_wrenches[0], strict=True)
        load = [x - row.preload * n - rub * t for x, n, t in pairs]
    return assembly, {name: load[3 * k : 3 * k + 3] for k, name in enumerate(names)}


@pytest.mark.parametrize("seed", range(24))
def test_constant_forces_between_bodies_decided_as_by_all_states(seed):
    assembly, wrenches = between_bodies(seed)
    load = [x for wrench in wrenches.values() for x in wrench]
    question = LinearQuestion(assembly.rows, tuple(load), (F(0),) * len(load))
    choices = product(_STATES, repeat=len(assembly))
    expected = any(ContactProgram(question, states).feasible for states in choices)
    verdict = solve(assembly, wrenches)
    assert verdict.verify()
    assert verdict.stable == expected
    if any(load):
        ends = ResistedSet(assembly).along(wrenches).intervals
        assert any(low <= 1 and (high is None or high >= 1) for low, high in ends) == expected
