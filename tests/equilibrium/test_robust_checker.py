"""Proofs for all grasps within bounds: leaves just right and just wrong, and forged proofs."""

import json
from fractions import Fraction
from functools import cache

import pytest

from arrangement.errors import InputError
from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, check, read_grasp, solve
from equilibrium.certificate.robust import Box, corners_of, halves
from equilibrium.certificate.uncertain import Bounds

SPATIAL = [
    Contact(p, [-x for x in p], "1/2", 1, 1) for p in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))
]


@pytest.mark.parametrize(("low", "high"), [(-1, 1), (0, 1), (Fraction(1, 4), Fraction(1, 2))])
def test_halves_meet_in_the_middle(low, high):
    rest, middle = (Fraction(1), Fraction(1)), Fraction(low + high, 2)
    parts = list(halves([rest, (Fraction(low), Fraction(high)), rest], 1))
    assert parts == [[rest, (low, middle), rest], [rest, (middle, high), rest]]
    assert list(corners_of(parts[0])) == [(1, low, 1), (1, middle, 1)]


@pytest.mark.parametrize(
    ("bounds", "motion", "virtual", "most"),
    [
        ({}, (0, 0, 0), (0, 1, 0), 1),
        ({}, (1, "1/2", 0), (0, 1, 0), 0),
        ({}, (1, "-1/2", 0), (2, 1, 0), 0),
        ({}, (-1, "-1/2", 0), (2, 1, 0), 4),
        ({"friction": "1/4"}, (0, 0, 0), (1, 1, 0), "3/8"),
        ({"friction": "1/4"}, (1, 0, 0), (1, 1, 0), "3/8"),
        ({"friction": "1/4"}, (-1, 0, 0), (1, 1, 0), "11/8"),
        ({"preload": "1/4"}, (0, 0, 0), (0, 1, 0), "3/4"),
        ({"preload": "1/4"}, (0, "-1", 0), (0, 1, 0), "11/4"),
        ({"stiffness": "1/4"}, (0, "1/4", 0), (0, 1, 0), "3/8"),
        ({"stiffness": "1/4"}, (0, -1, 0), (0, 1, 0), "5/2"),
        ({"length": "1/8"}, (0, 0, "1/2"), (0, 1, 0), "3/8"),
        ({"length": "1/8"}, (0, 0, 0), (0, 0, 1), "5/16"),
        ({"length": "1/8"}, (0, -1, 0), (0, 0, -1), "-33/16"),
        ({}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, 0, 0), "1/2"),
        ({"friction": "1/4"}, (0, 1, 0, 0, 0, 0), (0, 1, 1, 0, 0, 0), "3/8"),
        ({"preload": "1/4"}, (0, 0, -1, 0, 0, 0), (0, 0, 1, 0, 0, 0), "11/4"),
        ({"stiffness": "1/4"}, (0, 0, -1, 0, 0, 0), (0, 0, 1, 0, 0, 0), "5/2"),
        ({"length": "1/8", "friction": "1/4"}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, -1, 0), "11/64"),
        ({"length": "1/8", "friction": "1/4"}, (1, 0, 0, 0, 0, 0), (1, 0, 1, 0, 1, 0), "11/64"),
    ],
)
def test_a_leaf_holds_just_up_to_the_load_that_its_contact_bears(bounds, motion, virtual, most):
    """One contact at (1/2, 0) or (0, 0, 0), stiffness 2, preload 1, friction 1/2."""
    motion, n = [Fraction(x) for x in motion], len(virtual)
    place = (("1/2", 0), (0, 1)) if n == 3 else ((0, 0, 0), (0, 0, 1))
    grasp = Grasp([Contact(*place, "1/2", 2, 1)])
    for spare, holds in ((Fraction(1, 2**60), True), (Fraction(0), False)):
        # Of length 1 on the virtual motion, which is primitive.
        size = dot(virtual, virtual)
        load = tuple((spare - Fraction(most)) * x / size for x in virtual)
        box = Box(grasp, load, Bounds(**bounds), {"scales": ["1"] * n})
        ranges = [(Fraction(1), Fraction(1)), *((x, x) for x in motion)]
        assert box.holds(virtual, ranges) == holds


UNITS = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]


@pytest.mark.parametrize(
    ("low", "high", "holds"), [(-1, -1, True), (-1, 1, False), (-1, 0, False), (1, 1, False)]
)
@pytest.mark.parametrize("form", [{"centre": ["0"] * 3, "axes": UNITS}, {"forces": []}])
def test_a_leaf_of_a_yes_pulls_back_at_all_corners(low, high, holds, form):
    """Without contacts, the load does work 1 on the virtual motion."""
    form = {"axes": [[]] * 3, "loads": UNITS} | form
    box = Box(Grasp(), (Fraction(1), Fraction(0), Fraction(0)), Bounds(), form)
    ranges = [(Fraction(low), Fraction(high)), *[(Fraction(-1), Fraction(1))] * 2]
    assert box.holds((1, 0, 0), ranges) == holds


@pytest.mark.parametrize(
    ("force", "bounds", "most"),
    [
        ("1/4", {}, "1/8"),
        ("5/8", {}, "1/2"),
        ("5/8", {"friction": "1e-9"}, None),
        ("5/8", {"preload": "1e-9"}, None),
        ("0.625000001", {}, None),
        ("-3/8", {}, "-1/2"),
        ("-0.375000001", {}, None),
        ("1/4", {"length": 1}, "1/8"),
    ],
)
def test_a_leaf_holds_just_up_to_what_friction_at_rest_bears(force, bounds, most):
    """One contact, the normal force 1, friction 1/2; the axis takes 1/8 off the force."""
    form = {"forces": [force], "axes": [["1/8"], ["0"], ["0"]], "loads": UNITS}
    y = [(Fraction(x), Fraction(x)) for x in (-1, 0, 0)]
    for spare, holds in ((Fraction(1, 2**60), most is not None), (Fraction(0), False)):
        wrench = (Fraction(most or 9) + spare, Fraction(0), Fraction(0))
        grasp = Grasp([Contact((0, 0), (0, 1), "1/2", 2, 1)])
        assert Box(grasp, wrench, Bounds(**bounds), form).holds((1, 0, 0), y) == holds


def test_faces_are_those_of_the_half_cube_or_the_cube():
    one, whole_, half = Fraction(1), (Fraction(-1), Fraction(1)), (Fraction(0), Fraction(1))
    wrench, scales = (one, one, one), {"scales": ["1", "2", "1/3"]}
    box = Box(Grasp(), wrench, Bounds(), scales)
    sides = [(k, (x, x)) for k in (1, 2, 3) for x in (-one, one)]
    assert list(box.faces()) == [
        (k, [side if j == k else half if j == 0 else whole_ for j in range(4)])
        for k, side in [(0, (one, one)), *sides]
    ]
    motion, load = box.motion((one, one, -one, one / 2))
    assert [Fraction(x, motion[0]) for x in motion] == [1, 1, -2, Fraction(1, 6)]
    assert (load, motion[0] > 0) == ((), True)
    axes = [["1", "0", "0"], ["0", "2", "0"], ["1", "0", "1/3"]]
    form = {"centre": ["1/2", "0", "0"], "axes": axes, "loads": UNITS}
    box = Box(Grasp(), wrench, Bounds(), form)
    assert list(box.faces()) == [
        (k - 1, [side if j == k - 1 else whole_ for j in range(3)]) for k, side in sides
    ]
    motion, load = box.motion((one, -one, one / 2))
    assert [Fraction(x, motion[0]) for x in motion] == [1, 2, -2, Fraction(1, 6)]
    assert [Fraction(x, load[0]) for x in load] == [1, -1, Fraction(1, 2)]
    assert load[0] < 0 < motion[0]


@cache
def genuine_text(yes):
    """Return a proof for all within a degree and five per cent, and another load."""
    if yes:
        grasp, wrench = read_grasp("paper-three-contacts-preload-1"), (0, "1/2", 0)
    else:
        grasp = Grasp([Contact([0, -1], [0, 1], "1/2"), Contact([1, -1], [0, 1], "1/2")])
        wrench = (0, 1, 0)
    return solve(grasp, wrench).robust(degrees=1, friction="5%").certificate.text


def genuine(yes):
    return json.loads(genuine_text(yes))


def opposite(node):
    if isinstance(node, list):
        return [str(-Fraction(x)) for x in node]
    return {"cut": node["cut"], "children": [opposite(child) for child in node["children"]]}


def halved(k, d):
    return [{"cut": k, "children": d["faces"][:2]}]


def deep(cuts, leaf):
    node = leaf
    for _ in range(cuts):
        node = {"cut": 1, "children": [node, leaf]}
    return node


def flat(rows):
    return [rows[0], rows[0], rows[2]]


@pytest.mark.parametrize("yes", [True, False])
@pytest.mark.parametrize(
    "change",
    [
        lambda d: d | {"wrench": ["9", "9", "9"] if "axes" in d["box"] else ["0", "-1", "0"]},
        lambda d: d | {"bounds": {"degrees": "45", "friction": "1/2"}},
        lambda d: d | {"bounds": {"degrees": "1", "length": "9", "friction": "1/2"}},
        lambda d: d | {"bounds": {"preload": "0.99", "length": "3"}},
        lambda d: d | {"faces": [opposite(node) for node in d["faces"]]},
        lambda d: d | {"faces": [*d["faces"][1:], opposite(d["faces"][0])]},
        lambda d: d | {"faces": [["0", "0", "0"], *d["faces"][1:]]},
        lambda d: d | {"faces": [*d["faces"][:-1], {"cut": 0, "children": [["0", "0", "0"]] * 2}]},
    ],
)  # fmt: skip
def test_a_forged_proof_for_all_is_refused(yes, change):
    proof = genuine(yes)
    genuine_report = check(proof)
    assert genuine_report
    assert genuine_report.leaves == str(proof["faces"]).count("['")
    report = check(change(proof))
    assert not report
    assert "does not hold for all" in report.problem


@pytest.mark.parametrize(
    ("words", "yes", "change"),
    [
        ("do not span", True, lambda d: d["box"].update(axes=flat(d["box"]["axes"]))),
        ("above 0", False, lambda d: d["box"].update(scales=["0", "1", "1"])),
        ("expected 6", True, lambda d: d["faces"].pop()),
        ("expected 7", False, lambda d: d["faces"].pop()),
        ("does not fix", True, lambda d: d.update(faces=halved(0, d) * 6)),
        ("does not fix", True, lambda d: d.update(faces=halved(3, d) * 6)),
        ("does not fix", True, lambda d: d.update(faces=halved(True, d) * 6)),
        ("does not fix", True, lambda d: d["faces"].__setitem__(4, halved(True, d)[0])),
        ("does not fix", True, lambda d: d["faces"].__setitem__(0, halved(-1, d)[0])),
        ("does not fix", True, lambda d: d["faces"].__setitem__(4, halved("1", d)[0])),
        ("box", True, lambda d: d.update(box=5)),
        ("up to 200 times", True, lambda d: d["faces"].__setitem__(4, deep(201, d["faces"][4]))),
        ("unknown key", True, lambda d: d.update(certificate="not resisted")),
        ("unknown key", False, lambda d: d.update(certificate="resisted")),
        ("unknown key", True, lambda d: d.update(pyramid=4)),
        ("degrees is", True, lambda d: d.update(bounds={"degrees": "50"})),
        ("unknown key", True, lambda d: d.update(bounds={"mass": "1"})),
    ],
)  # fmt: skip
def test_what_is_no_proof_for_all_is_one_clear_error(words, yes, change):
    proof = genuine(yes)
    change(proof)
    with pytest.raises(InputError, match=words):
        check(proof)


def test_cells_are_cut_up_to_200_times():
    proof = genuine(True)
    proof["faces"][4] = deep(200, proof["faces"][4])
    assert check(proof)


def test_forces_at_rest_are_within_their_limits():
    pushed = solve(Grasp(SPATIAL), (0, 0, "1/10", 0, 0, 0)).robust(friction="5%")
    proof = pushed.certificate.to_dict()
    assert check(proof)
    for name in ("friction", "preload"):
        assert not check(proof | {"bounds": {name: "0.95"}})
    assert not check(proof | {"wrench": ["0", "0", "1", "0", "0", "0"]})
    forces = [str(Fraction(x) + 1) for x in proof["box"]["forces"]]
    assert not check(proof | {"box": proof["box"] | {"forces": forces}})


@pytest.mark.parametrize("flip", [[0], [1], [0, 1, 2], "zero"])
def test_loads_that_do_not_pull_back_prove_nothing(flip):
    proof = genuine(True)
    loads = proof["box"]["loads"]
    for k in range(3) if flip == "zero" else flip:
        loads[k] = ["0"] * 3 if flip == "zero" else [str(-Fraction(x)) for x in loads[k]]
    assert not check(proof)
