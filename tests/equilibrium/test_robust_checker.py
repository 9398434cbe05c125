"""Proofs for all grasps within bounds: limits just reached and just passed, and forged proofs."""

import json
import math
from fractions import Fraction
from functools import cache
from random import Random

import pytest

from arrangement.errors import InputError
from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, GraspError, read_grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.robust import Holding, virtual_motion_problem
from equilibrium.certificate.uncertain import Bounds, Uncertain, length, root

SPATIAL = [
    Contact(p, [-x for x in p], "1/2", 1, 1) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))
]
#: A rational turn by just below two degrees; tan 1 degree is 0.017455064...
HALF_TURN = Fraction(17455, 10**6)
NEAR = Bounds(degrees=2, length="1/10", friction="5%", stiffness="10%", preload="20%")


def at_the_bounds(source, c, near=NEAR):
    """Return a contact at the ends of bounds of two degrees, with its tangents turned along."""
    t, axes = source.choice([HALF_TURN, -HALF_TURN, Fraction(0)]), c.tangents
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    way = (1,) if c.dimension == 2 else source.choice([(1, 0), (0, 1), (Fraction(3, 5), "4/5")])
    way = [Fraction(x) for x in way]
    across = [dot(way, column) for column in zip(*axes, strict=True)]
    normal, first = (
        tuple(a * x + b * y + d * z for x, y, z in zip(c.normal, across, axes[0], strict=True))
        for a, b, d in ((cosine, sine, 0), (-sine * way[0], (cosine - 1) * way[0], 1))
    )
    point = [x + source.choice([-1, 1]) * near.length for x in c.point]
    numbers = [
        getattr(c, name) * (1 + source.choice([-1, 1]) * getattr(near, name))
        for name in ("friction", "stiffness", "preload")
    ]
    return Contact(point, normal, *numbers, *([first] if c.dimension == 3 else []))


@pytest.mark.parametrize("dimension", [2, 3])
def test_along_bounds_all_contacts_nearly_tightly(dimension):
    source, n, shares = Random(dimension), 3 * dimension - 3, []
    for _ in range(200):
        point = [source.randint(-3, 3) for _ in range(dimension)]
        normal = source.choice([(0, 1), (Fraction(3, 5), Fraction(4, 5))])
        c = Contact(point, (*normal, 0)[:dimension], "1/2", 2, 1)
        motion = tuple(Fraction(source.randint(-9, 9), 3) for _ in range(n))
        along = Uncertain(c, NEAR).along(motion)
        assert along.normal == dot(c.normal_wrench, motion)
        for _ in range(8):
            other = at_the_bounds(source, c)
            change = abs(dot(other.normal_wrench, motion) - along.normal)
            assert change <= along.normal_error
            moves = [dot(row, motion) for row in other.tangential_wrenches]
            turned = [x - y for x, y in zip(moves, along.tangents, strict=True)]
            assert sum(x * x for x in turned) <= along.tangent_error**2
            assert sum(x * x for x in moves) <= along.slip**2
            shares.append(change / along.normal_error if change else 0)
    assert max(shares) > 0.7


def test_along_is_exact_without_bounds():
    along = Uncertain(SPATIAL[0], Bounds()).along(tuple(map(Fraction, (1, 3, 4, 0, 0, 0))))
    assert (along.normal, along.normal_error, along.tangent_error) == (-1, 0, 0)
    assert 0 <= along.slip - 5 < Fraction(1, 2**59)


@pytest.mark.parametrize("square", [0, 1, 2, Fraction(9, 4), Fraction(1, 10**40), 10**40])
def test_root_is_rounded_up(square):
    found = root(Fraction(square))
    assert square <= found**2 <= square * (1 + Fraction(1, 2**50))
    assert length([Fraction(-3)]) == 3


def test_bounds_have_ends():
    most = {"degrees": 45, "length": 10**9, "friction": "99/100", "preload": "99%"}
    assert Bounds(**most).friction == Fraction(99, 100)
    for name, most_of in most.items():
        past = Fraction(str(most_of).removesuffix("%")) + Fraction(1, 10**6)
        share = ", a share" * (name in ("friction", "preload"))
        with pytest.raises(GraspError, match=f"give a number from 0 to [0-9.]+{share}"):
            Bounds(**{name: f"{past}%" if name == "preload" else past})
        with pytest.raises(GraspError, match=f"{name} is "):
            Bounds(**{name: Fraction(-1, 2)})
    half = Bounds(degrees=3, length=1, friction="5%").times(Fraction(1, 2))
    assert half == Bounds(degrees="3/2", length="1/2", friction="1/40")
    assert str(half).startswith("normals within 1.5 degrees, points within 0.5, friction within")
    assert str(Bounds()) == "no change"
    assert str(Bounds(degrees=1)) == "normals within 1 degree"
    assert 0 <= Bounds(degrees=45).angle - math.pi / 4 < 1e-6
    near = Uncertain(Contact([0, 0], [0, 1], 1), Bounds(friction="5%"))
    assert near.ends("friction") == (Fraction(19, 20), Fraction(21, 20))


def pads(force, bounds, normal=1, energy="1/1000"):
    """Two contacts of preload 1 and friction 1/2 that hold a load of twice a friction force."""
    grasp = Grasp([Contact([-1, 0], [1, 0], "1/2", 1, 1), Contact([1, 0], [-1, 0], "1/2", 1, 1)])
    force, half = Fraction(force), Fraction(1, 2)
    motion = (Fraction(0),) * 3
    wrench = (Fraction(0), -2 * force, Fraction(0))
    forces = [(Fraction(normal), force), (Fraction(normal), -force)]
    # N = (1, 0, 0), T = (0, 1, -1) and N = (-1, 0, 0), T = (0, -1, -1).
    rows = [[(half, 0, 0), (0, half, -half)], [(-half, 0, 0), (0, -half, -half)]]
    correction = [[tuple(map(Fraction, row)) for row in one] for one in rows]
    held = Holding(grasp, wrench, Bounds(**bounds), motion, forces, correction)
    return held.problem((Fraction(1, 10**6),) * 3, Fraction(energy))


@pytest.mark.parametrize(
    ("force", "bounds", "normal", "words"),
    [
        ("0.46", {}, 1, ""),
        ("0.49", {}, 1, "no room"),
        ("0.40", {"friction": "10%"}, 1, ""),
        ("0.44", {"friction": "10%"}, 1, "no room"),
        ("0.1", {"preload": "1%"}, 1, ""),
        ("0.1", {"preload": "5%"}, 1, "energy"),
        ("0.1", {"stiffness": "50%"}, 1, ""),
        ("0.1", {"degrees": "1/100"}, 1, "correction"),
        ("0.1", {"length": "1/100"}, 1, "correction"),
        ("0.1", {}, "1.1", "energy"),
    ],
)
def test_forces_hold_just_up_to_the_friction_cone(force, bounds, normal, words):
    """With an energy A of 1/1000 a spring force may fall by 0.032, and friction by 0.016."""
    problem = pads(force, bounds, normal)
    assert words in problem
    assert bool(words) == bool(problem)


def test_forces_at_the_friction_cone_have_no_room():
    """Springs lose the root and a quarter of the reach, friction grows by the reach."""
    energy, reach = Fraction(1, 1000), Fraction(1, 10**6)
    most = (1 - reach / 4 - root(energy)) / 2 - reach
    assert "no room" in pads(most, {}, energy=energy)
    assert pads(most - Fraction(1, 10**15), {}, energy=energy) == ""


def test_a_small_energy_leaves_all_friction():
    assert pads("0.4999", {}, energy="1/1000000000") == ""
    assert "no room" in pads("0.5", {}, energy="1/1000000000")
    assert "above 0" in pads("0.1", {}, energy=0)


def test_the_energy_is_above_what_is_needed():
    """Each spring force may be off by half of the reach: twice a quarter of its square."""
    assert "energy" in pads("0.1", {}, energy="1.25e-13")
    assert pads("0.1", {}, energy="1.26e-13") == ""


def test_a_load_that_one_unfelt_motion_feels_is_not_balanced():
    grasp = Grasp([Contact([0, 0, 0], [0, 0, 1], "1/2", 1, 1)])
    zeros = (Fraction(0),) * 6
    for torque, words in ((0, ""), (1, "no forces of holding contacts balance it")):
        wrench = tuple(map(Fraction, (0, 0, -1, 0, 0, torque)))
        held = Holding(grasp, wrench, Bounds(), zeros, [(1, 0, 0)], [[zeros] * 3])
        assert words in held.problem((Fraction(2),) * 6, Fraction(1))


@pytest.mark.parametrize(
    ("friction", "bounds", "holds"),
    [("3/4", {}, True), ("3/4", {"friction": "1%"}, False), ("7/10", {"friction": "5%"}, True)],
)
def test_a_virtual_motion_holds_just_up_to_the_friction_cone(friction, bounds, holds):
    grasp, load = (
        Grasp([Contact([0, 0], [0, 1], friction)]),
        (Fraction(0), Fraction(1), Fraction(0)),
    )
    virtual = tuple(map(Fraction, (4, 3, 0)))
    assert (virtual_motion_problem(grasp, load, Bounds(**bounds), virtual) == "") == holds
    assert virtual_motion_problem(grasp, (1, -2, 0), Bounds(), virtual).endswith("no work above 0")
    assert virtual_motion_problem(grasp, load, Bounds(degrees=1, **bounds), virtual)


def at_the_limit(force="0.45", friction="10%", *, motion=(0, 0, 0), **more):
    """Two contacts of friction 1/2 and normal force 1 that hold twice a friction force at rest."""
    grasp = Grasp([Contact([-1, 0], [1, 0], "1/2", 1, 1), Contact([1, 0], [-1, 0], "1/2", 1, 1)])
    force, zeros = Fraction(force), (Fraction(0),) * 3
    forces = [(Fraction(more.pop("normal", 1)), force), (Fraction(1), -force)]
    wrench = (Fraction(0), Fraction(more.pop("load", -2 * force)), Fraction(0))
    moved = tuple(map(Fraction, motion))
    bounds = Bounds(friction=friction, **more)
    held = Holding(grasp, wrench, bounds, moved, forces, [[zeros] * 2] * 2)
    return held.problem(zeros, Fraction(0))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, ""),
        ({"stiffness": "50%"}, ""),
        ({"force": "0.4500001"}, "forces[0]: no room in the friction cone"),
        ({"friction": "10.00001%"}, "no room in the friction cone"),
        ({"motion": (0, "1/1000", 0)}, "no equilibrium"),
        ({"force": "0.3", "motion": ("1/1000", 0, 0)}, "no equilibrium"),
        ({"force": "0.3", "preload": "1/1000"}, "no equilibrium"),
        ({"degrees": "1/1000"}, "balance"),
        ({"length": "1/1000"}, "balance"),
        ({"load": "0.90001"}, "balance"),
        ({"normal": "1.1"}, "balance"),
    ],
)
def test_an_equilibrium_at_rest_needs_no_room(changes, words):
    problem = at_the_limit(**changes)
    assert words in problem
    assert bool(words) == bool(problem)


def test_contacts_that_press_less_than_nothing_are_at_no_rest():
    """Without friction any force along the normal is in the cone, but one that pulls."""
    zeros = (Fraction(0),) * 3
    grasp = Grasp([Contact([0, 0], [0, 1], 0, 1, 1)])
    for motion, force in ((0, 1), (2, -1), (1, 0)):
        asked = (0, -force, 0), Bounds(friction="10%"), (0, motion, 0), [(force, 0)]
        held = Holding(grasp, *asked, [[zeros] * 2])
        assert bool(held.problem(zeros, Fraction(0))) == (force < 0)


@cache
def genuine_text(name):
    """Return a proof for all within half a degree and five per cent."""
    if name == "no":
        grasp = Grasp([Contact([0, -1], [0, 1], "1/2"), Contact([1, -1], [0, 1], "1/2")])
        wrench = (0, 1, 0)
    elif name == "limit":
        grasp, wrench = read_grasp("paper-four-contacts-preload-1"), (0, "9/5", 0)
        return solve(grasp, wrench).robust(friction="10%").certificate.text
    elif name == "space":
        grasp, wrench = read_grasp("two-opposed-fingers"), (0, 0, "-1/2", 0, 0, 0)
    else:
        grasp, wrench = read_grasp("paper-four-contacts-preload-1"), (0, 1, 0)
    return solve(grasp, wrench).robust(degrees="1/2", friction="5%").certificate.text


def genuine(name):
    return json.loads(genuine_text(name))


def scaled(value, share):
    if isinstance(value, list):
        return [scaled(x, share) for x in value]
    return str(Fraction(value) * Fraction(share))


def with_share(key, share):
    return lambda d: d | {key: scaled(d[key], share)}


@pytest.mark.parametrize(
    ("name", "change"),
    [
        *(
            (name, change)
            for name in ("yes", "space")
            for change in (
                with_share("wrench", 3),
                with_share("forces", "9/10"),
                with_share("correction", -1),
                with_share("correction", 0),
                with_share("correction", 3),
                with_share("reach", "9/10"),
                with_share("reach", -1),
                with_share("reach", 100),
                with_share("energy", "9/10"),
                with_share("energy", -1),
                with_share("energy", 10**6),
                lambda d: d | {"motion": ["9"] * len(d["motion"])},
                lambda d: d | {"bounds": {"degrees": "45", "friction": "1/2"}},
                lambda d: d | {"bounds": {"preload": "0.99"}},
                lambda d: d | {"bounds": {"length": "3"}},
            )
        ),
        ("limit", with_share("wrench", "1.0001")),
        ("limit", with_share("forces", "0.9999")),
        ("limit", lambda d: d | {"energy": "1/1000000"}),
        ("limit", lambda d: d | {"reach": ["1/1000000"] * 3}),
        ("limit", lambda d: d | {"motion": ["0", "0", "1/1000000"]}),
        ("limit", lambda d: d | {"bounds": {"friction": "10.0001%"}}),
        ("limit", lambda d: d | {"bounds": {"friction": "10%", "degrees": "1/1000000"}}),
        ("space", lambda d: d | {"wrench": ["0", "0", "-1/2", "1/10", "0", "0"]}),
        ("space", lambda d: d | {"bounds": {"length": "1/1000000"}}),
        ("no", with_share("wrench", -1)),
        ("no", with_share("virtual_motion", -1)),
        ("no", with_share("virtual_motion", 0)),
        ("no", lambda d: d | {"bounds": {"degrees": "45", "friction": "0.99"}}),
    ],
)
def test_a_forged_proof_for_all_is_refused(name, change):
    proof = genuine(name)
    assert check(proof)
    report = check(change(proof))
    assert not report
    assert report.problem


@pytest.mark.parametrize(
    ("words", "name", "change"),
    [
        ("expected 4", "yes", lambda d: d["forces"].pop()),
        ("expected 4", "yes", lambda d: d["correction"].pop()),
        ("expected 2", "yes", lambda d: d["correction"][1].pop()),
        ("expected 3", "yes", lambda d: d["reach"].pop()),
        ("expected 3", "no", lambda d: d["virtual_motion"].pop()),
        ("unknown key", "yes", lambda d: d.update(virtual_motion=["0", "1", "0"])),
        ("unknown key", "yes", lambda d: d.update(certificate="not resisted")),
        ("unknown key", "no", lambda d: d.update(certificate="resisted")),
        ("unknown key", "yes", lambda d: d.update(pyramid=4)),
        ("degrees is", "yes", lambda d: d.update(bounds={"degrees": "50"})),
        ("unknown key", "yes", lambda d: d.update(bounds={"mass": "1"})),
        ("this is an old proof", "yes", lambda d: d.update(box={}, faces=[])),
    ],
)
def test_what_is_no_proof_for_all_is_one_clear_error(words, name, change):
    proof = genuine(name)
    change(proof)
    with pytest.raises(InputError, match=words):
        check(proof)


def test_loose_contacts_need_all_wrenches():
    """Two contacts on the z axis do not bear the torque about it, the others are loose."""
    ends = [Contact([0, 0, -z], [0, 0, z], "1/2", 1, 1) for z in (1, -1)]
    grasp = Grasp([*ends, SPATIAL[0]])
    zero, rows = (Fraction(0),) * 6, [[(Fraction(0),) * 6] * 3] * 3
    forces = [(Fraction(1), Fraction(0), Fraction(0))] * 2 + [(Fraction(0),) * 3]
    held = Holding(grasp, zero, Bounds(), zero, forces, rows)
    assert "do not span" in held.problem((Fraction(1),) * 6, Fraction(1))


def test_frictionless_contacts_hold_by_springs_alone():
    place = [((1, 0), (-1, 0)), ((-1, 0), (1, 0)), ((0, 1), (0, -1)), ((0, -1), (0, 1))]
    frictions = [0, 0, "1/2", "1/2"]
    grasp = Grasp(Contact(*x, mu, 1, 1) for x, mu in zip(place, frictions, strict=True))
    found = solve(grasp, ("1/4", 0, 0)).robust(degrees="1/10", friction="5%")
    proof = found.certificate.to_dict()
    assert [float(row[1]) for row in proof["forces"][:2]] == [0, 0]
    proof["forces"][0][1] = "1/1000000000"
    assert "no room" in check(proof).problem


def one_contact(normal, motion, correction=0, **bounds):
    """A contact at (0, 0) with friction 1/2, stiffness 2 and preload 3."""
    rows = [tuple(map(Fraction, (0, correction, 0))), (Fraction(0),) * 3]
    return Holding(
        Grasp([Contact([0, 0], [0, 1], "1/2", 2, 3)]),
        (Fraction(0),) * 3,
        Bounds(**bounds),
        tuple(map(Fraction, motion)),
        [(Fraction(normal), Fraction(0))],
        [rows],
    )


@pytest.mark.parametrize(
    ("held", "energy"),
    [
        (one_contact(3, (0, 0, 0)), 0),
        (one_contact(1, (0, 0, 0)), Fraction(1, 2)),
        (one_contact(1, (0, 1, 0)), 0),
        (one_contact(2, (0, 0, 0), preload="1/3"), Fraction(1, 2)),
        (one_contact(2, (0, 1, 0), stiffness="1/2"), 1),
        # Of a slip of 1, with a spring force of 3 and a root of 4.
        (one_contact(3, (1, 0, 0)), 7),
        (one_contact(3, (1, 0, 0), friction="1/2"), Fraction(21, 2)),
        # Loose: (3 - 2 y + mu 2 |x|)^2 / 8.
        (one_contact(0, (0, 0, 0)), Fraction(9, 8)),
        (one_contact(0, (1, 1, 0)), Fraction(1, 2)),
        (one_contact(0, (0, 2, 0)), 0),
        # Not loose, as it may be corrected.
        (one_contact(0, (0, 0, 0), correction="1/2"), Fraction(49, 32)),
    ],
)
def test_the_energy_is_the_sum_of_its_terms(held, energy):
    needed, _ = held.energy((Fraction(1),) * 3, Fraction(8))
    assert 0 <= needed - energy < Fraction(1, 2**50)


def test_contacts_on_a_line_have_to_stay_there():
    ends = [Contact([0, 0, -z], [0, 0, z], "1/2", 1, 1) for z in (1, -1)]
    zero, rows = (Fraction(0),) * 6, [[(Fraction(0),) * 6] * 3] * 2
    forces = [(Fraction(1), Fraction(0), Fraction(0))] * 2
    one = (Fraction(1),) * 6
    for length_, words in ((0, "reach"), ("1/1000", "do not span")):
        held = Holding(Grasp(ends), zero, Bounds(length=length_), zero, forces, rows)
        assert words in held.problem(one, Fraction(1))
    turned = (*[Fraction(0)] * 5, Fraction(1))
    held = Holding(Grasp(ends), turned, Bounds(), zero, forces, rows)
    assert "no forces" in held.problem(one, Fraction(1))
