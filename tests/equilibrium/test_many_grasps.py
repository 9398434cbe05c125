"""Many grasps in float arrays: the same answers as one by one, and none from floats alone."""

import functools
from random import Random

import numpy as np
import pytest

from arrangement.errors import InputError, OutOfReachError
from arrangement.numbers.exact import from_floats
from equilibrium import Grasp, ResistedSet, check_grasps, solve
from equilibrium.decide.many_grasps import check as module, equilibria
from equilibrium.decide.many_grasps.questions import Questions, questions
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.errors import GraspError

from . import degenerate

ONE = {
    "points": np.array([[[-1.0, 0], [1, 0]]]),
    "normals": np.array([[[1.0, 0], [-1, 0]]]),
    "friction": 0.5,
    "wrenches": np.zeros((1, 1, 3)),
}


def arrays(grasps):
    """Points, normals and values of grasps as arrays, filled up with NaN."""
    most, size = max(map(len, grasps)), max(g.dimension for g in grasps)
    points, normals = np.full((2, len(grasps), most, size), np.nan)
    values = np.full((3, len(grasps), most), np.nan)
    for i, grasp in enumerate(grasps):
        for j, c in enumerate(grasp):
            points[i, j], normals[i, j] = (list(map(float, x)) for x in (c.point, c.normal))
            values[:, i, j] = float(c.friction), float(c.stiffness), float(c.preload)
    return points, normals, *values


def checked(grasps, wrenches, **options):
    points, normals, friction, stiffness, preload = arrays(grasps)
    loads = np.array([[list(map(float, w)) for w in row] for row in wrenches])
    values = {"stiffness": stiffness, "preload": preload}
    return check_grasps(points, normals, friction, loads, **values, **options), loads


def agree(questions):
    """Every answer is that of `solve`, one by one, also where floats have decided."""
    found, loads = checked([grasp for grasp, _ in questions], [[w] for _, w in questions])
    for i in range(len(questions)):
        expected = solve(found.grasp(i), from_floats(loads[i, 0])).stable
        assert found.resisted[i, 0] == expected, (i, found.screened[i, 0])
    assert (found.screened ^ found.exact).all()
    return found


def mixed(seed):
    """A random or a degenerate question; of these many loads are at the limit."""
    if seed % 3 == 0:
        return random_grasp(3 + seed // 3 % 6, seed), random_wrench(seed)
    question = degenerate.question(seed)
    return question.grasp, question.wrench


def test_grasps_answered_as_one_by_one():
    agree([mixed(seed) for seed in range(12)])


@pytest.mark.slow
def test_many_grasps_answered_as_one_by_one():
    agree([mixed(seed) for seed in range(1000, 1050)])


def test_random_grasps_mostly_screened(monkeypatch):
    monkeypatch.setattr(module, "_exactly", lambda times, task: (task[0], []))
    grasps = [random_grasp(3 + seed % 6, seed) for seed in range(100)]
    found, _ = checked(grasps, [[random_wrench(seed)] for seed in range(100)])
    assert np.count_nonzero(found.screened) >= 98
    assert 20 < np.count_nonzero(found.resisted) < 95


def test_loads_at_the_limit_decided_exactly():
    # The limit of the friction is 1: floats next to it are too near for floats.
    loads = [[0, np.nextafter(1, k), 0] for k in (0, 2)] + [[0, 1, 0], [0, 0.999, 0], [0, 1.001, 0]]
    found = check_grasps(**{**ONE, "wrenches": loads}, preload=1)
    assert found.resisted.tolist() == [[True, False, True, True, False]]
    assert found.exact.tolist() == [[True, True, True, False, False]]
    assert repr(found) == (
        "<CheckedGrasps: 1 grasp, 5 loads each: 3 resisted, 2 screened, 3 exact, 0 undecided>"
    )


def test_loads_near_a_limit_never_screened_wrongly():
    grasps = [random_grasp(4, 27)]
    direction = np.array(list(map(float, random_wrench(27))))
    exact = ResistedSet(checked(grasps, [[direction]])[0].grasp(0))
    (_, end), *_ = exact.along(from_floats(direction)).intervals
    times = [float(end) * (1 + side * 2.0**-k) for k in range(1, 53, 5) for side in (1, -1)]
    found, loads = checked(grasps, [np.outer(times, direction)])
    assert found.resisted[0].tolist() == exact.check(loads[0]).resisted.tolist()
    assert found.screened[0, :2].all()
    assert found.resisted[0, :2].tolist() == [False, True]
    assert found.exact[0, -2:].all()


@functools.cache
def answered():
    """Arrays of random grasps, their loads and answers."""
    grasps = [random_grasp(4, seed) for seed in range(16)]
    found, loads = checked(grasps, [[random_wrench(seed)] for seed in range(16)])
    return arrays(grasps), loads, found


def test_contacts_that_never_press_have_zeros_alone():
    points, one = np.array([[[-1.0, 0], [1, 0], [np.nan, 0]]]), np.ones((1, 3))
    stiffness, preload = np.array([[0.0, 1, 1]]), np.array([[0.0, 0, 1]])
    asked, usable = questions(points, -points, (one, stiffness, preload), np.ones((1, 3)))
    assert usable.all()
    assert asked.friction.tolist() == [[0, 1, 0]]
    assert asked.normal.any(axis=2).tolist() == [[False, True, False]]
    asked, _ = questions(points, -points, (one, 0 * stiffness, one), np.ones((1, 3)))
    assert asked.friction.tolist() == [[1, 1, 0]]


def test_no_equilibrium_is_proved_where_rounding_is_larger(monkeypatch):
    fingers = np.array([[[-1.0, 0], [1, 0], [0, -1], [0, 1]]] * 6)
    loads = np.array([[0, 0.1 * k, 0] for k in range(6)])

    def proved(count):
        points, values = fingers[:, :count], [np.full((6, count), x) for x in (0.5, 1.0, 1.0)]
        asked, _ = questions(points, -points, tuple(values), loads * (5 - count))
        at_rest = equilibria._at_rest(asked, np.zeros((6, count, 1)))
        return equilibria.have_equilibria(asked).any(), at_rest.any()

    assert (proved(3), proved(4)) == ((True, False), (True, True))
    monkeypatch.setattr(Questions, "rounding", 0.01)
    assert not any(proved(3))
    monkeypatch.setattr(Questions, "rounding", 0.1)
    assert not any(proved(4))


@pytest.mark.parametrize("scale", [2.0**-70, 1e-9, 3.0, 1e12])
def test_units_do_not_matter(scale):
    (points, normals, friction, stiffness, preload), loads, first = answered()
    other = check_grasps(
        points * scale,
        normals / scale,
        friction,
        loads * scale * [1, 1, scale],
        preload=preload * scale,
        stiffness=stiffness / scale,
    )
    assert (first.resisted == other.resisted).all()
    assert np.count_nonzero(other.screened) >= 15


@pytest.mark.parametrize("tiny", [5e-324, 1e-250, 1e250])
def test_extreme_numbers_decided_exactly(tiny):
    found = check_grasps(**{**ONE, "wrenches": [[0, tiny, 0]]}, preload=[1, 1])
    assert found.exact.all()
    assert found.resisted.all() == (tiny < 1)


def test_normals_read_as_given_directions():
    points = np.array([[[0.1, 0.2], [0.5, -0.7]]])
    found = check_grasps(points, [[[1.0, 2.0], [-3, 4]]], 0.3, [[0.0, 0, 0]])
    first, second = found.grasp(0)
    assert list(map(float, first.point)) == [0.1, 0.2]
    assert sum(x * x for x in first.normal) == 1
    assert abs(first.normal[1] - 2 * first.normal[0]) < 3e-12
    assert list(map(str, second.normal)) == ["-3/5", "4/5"]


def test_missing_contacts_do_not_count():
    grasp = random_grasp(3, 1)
    points, normals, friction, stiffness, preload = arrays([grasp, random_grasp(8, 1)])
    loads = [[float(x) for x in random_wrench(k)] for k in range(9)]
    both = check_grasps(points, normals, friction, loads, preload=preload, stiffness=stiffness)
    alone, _ = checked([grasp], [loads])
    assert (both.resisted[0] == alone.resisted[0]).all()
    nothing = check_grasps(points[:1] * np.nan, normals[:1], 1, [[0.0, 0, 0], [0, 1, 0]])
    assert nothing.resisted.tolist() == [[True, False]]


def test_empty_arrays_taken():
    for shape in ((0, 3, 2), (0, 0, 3), (2, 0, 2)):
        size = 3 * (shape[2] - 1)
        found = check_grasps(np.zeros(shape), np.zeros(shape), 1, np.ones((2, size)))
        assert found.resisted.tolist() == [[False, False]] * shape[0]
    assert check_grasps(**{**ONE, "wrenches": np.ones((0, 3))}).resisted.shape == (1, 0)


#: Along axes, of rational and of irrational length.
DIRECTIONS = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0.6, 0.8), (0.6, 0, -0.8), (1, 1, 1), (1, 2, 3)


def degenerate_in_space(count, seed):
    """Small integers, parallel normals, coincident points; many loads are at cones' boundaries."""
    source, most = Random(f"degenerate in space {seed}"), 5
    points, normals = np.full((2, count, most, 3), np.nan)
    values, loads = np.full((3, count, most), np.nan), np.zeros((count, 1, 6))
    for i in range(count):
        for j in range(source.randint(1, most)):
            points[i, j] = [source.choice((-1, 0, 1, 0.5)) for _ in range(3)]
            normals[i, j] = [x * source.choice((1, -1)) for x in source.choice(DIRECTIONS)]
            preload = source.choice((0, 1, 2)) if i % 2 else 0
            values[:, i, j] = source.choice((0, 0.5, 1)), source.choice((1, 2)), preload
            if i % 3 == 0:  # opposed by forces on the boundary of their cones
                unit = normals[i, j] / np.linalg.norm(normals[i, j])
                across = np.cross(unit, (0, 0, 1) if unit[2] == 0 else (1, 0, 0))
                rubs = source.choice((0, 1, -1)) * values[0, i, j]
                force = source.choice((0, 1, 2)) * (unit + rubs * across)
                loads[i, 0] -= *force, *np.cross(points[i, j], force)
        if i % 3:
            loads[i, 0] = [source.randint(-2, 2) * source.choice((1, 0)) for _ in range(6)]
    return points, normals, *values, loads


def agree_in_space(points, normals, friction, stiffness, preload, loads):
    """What is screened has the answer of `solve`; the rest is not solved here."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "_exactly", lambda times, task: (task[0], []))
        values = {"stiffness": stiffness, "preload": preload}
        found = check_grasps(points, normals, friction, loads, **values)
    for i in np.flatnonzero(found.screened[:, 0]).tolist():
        verdict = solve(found.grasp(i), from_floats(loads[i, 0]))
        assert not verdict.decided or verdict.stable == found.resisted[i, 0], i
    return found


def random_in_space(seeds):
    grasps = [random_grasp(3 + seed % 6, seed, dimension=3) for seed in seeds]
    loads = [[list(map(float, random_wrench(seed, dimension=3)))] for seed in seeds]
    return *arrays(grasps), np.array(loads)


def test_screened_grasps_in_space_answered_as_one_by_one():
    found = agree_in_space(*random_in_space(range(12)))
    assert np.count_nonzero(found.screened) >= 6
    assert 2 <= np.count_nonzero(found.resisted) <= 6
    found = agree_in_space(*degenerate_in_space(40, 1))
    assert np.count_nonzero(found.screened) >= 20
    assert found.resisted.any()


@pytest.mark.slow
def test_many_screened_grasps_in_space_answered_as_one_by_one():
    agree_in_space(*random_in_space(range(1000, 1040)))
    agree_in_space(*degenerate_in_space(400, 10))


def test_rest_in_space_decided_exactly():
    two = [[[0.0, 0, 1], [0, 0, -1]]]
    loads = [[1.0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1]]
    found = check_grasps(two, np.negative(two), 0.5, loads, preload=1)
    # On both fingers no friction turns about the line between them.
    assert found.resisted.tolist() == [[True, False]]
    assert found.exact.tolist() == [[True, True]]


def test_spatial_normals_of_a_grasp_are_near_the_given_ones():
    points = np.array([[[0.0, 0, 1]]])
    (contact,) = check_grasps(points, [[[1.0, 2, -4]]], 1, np.ones((1, 6))).grasp(0)
    x, y, z = contact.normal
    assert x * x + y * y + z * z == 1
    assert max(abs(y - 2 * x), abs(z + 4 * x)) < 1e-11


def test_limit_of_work_leaves_a_load_undecided(monkeypatch):
    def end(solver, wrenches):
        raise OutOfReachError("undecided: too many steps")

    monkeypatch.setattr(module.Solver, "solve_many", end)
    found = check_grasps(**{**ONE, "wrenches": [[0, 1, 0], [0, 0.5, 0]]}, preload=1)
    assert found.undecided.tolist() == [[True, False]]
    assert found.resisted.tolist() == [[False, True]]
    assert not found.exact.any()


@pytest.mark.usefixtures("scrambled")
def test_processes_give_the_same_answers():
    questions = [mixed(seed) for seed in range(4)]
    grasps, loads = [g for g, _ in questions], [[w] for _, w in questions]
    one, two = (checked(grasps, loads, jobs=jobs)[0] for jobs in (1, 2))
    assert (one.resisted == two.resisted).all()
    assert (one.exact == two.exact).all()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"points": [[-1.0, 0]]}, r"normals is an array \(1, 2, 2\); expected \(1, 2\), as"),
        ({"points": [-1.0, 0]}, r"points is an array \(2,\); expected \(G, m, 2\)"),
        ({"points": [[[[-1.0, 0]]]]}, r"points is an array \(1, 1, 1, 2\); expected"),
        ({"points": [[1.0], [2]]}, r"points is an array \(2, 1\); expected"),
        ({"points": [[["a", "b"]]]}, "points is an array of <U1"),
        ({"points": [[[np.nan, 0.0], [1, 0]]]}, r"points\[0, 0, 0\] is nan"),
        ({"points": np.ma.masked_less(ONE["points"], 0)}, "points has masked entries"),
        ({"normals": ONE["normals"][:, :1]}, r"normals is an array \(1, 1, 2\); expected"),
        ({"normals": ONE["normals"] * 0}, r"normals\[0, 0\] is \[0.0, 0.0\]; expected a direction"),
        ({"normals": ONE["points"] + np.inf}, r"normals\[0, 0, 0\] is inf"),
        ({"friction": -1}, r"friction\[0, 0\] is -1.0; expected a finite number at least 0"),
        ({"friction": [1, 2, 3]}, r"friction is an array \(3,\); expected"),
        ({"stiffness": np.nan}, r"stiffness\[0, 0\] is nan"),
        ({"preload": [[1, np.inf]]}, r"preload\[0, 1\] is inf"),
        ({"wrenches": [0.0, 0, 0]}, r"wrenches is an array \(3,\); expected \(1, w, 3\)"),
        ({"wrenches": np.zeros((2, 1, 3))}, r"wrenches is an array \(2, 1, 3\)"),
        ({"wrenches": [[0, np.nan, 0]]}, r"wrenches\[0, 0, 1\] is nan"),
        ({"wrenches": [[0, 2**53 + 1, 0]]}, "wrenches has 9007199254740993, which floats round"),
        ({"jobs": 0}, "jobs is 0"),
    ],
)
def test_bad_arrays_refused(change, words):
    with pytest.raises((GraspError, InputError), match=words):
        check_grasps(**{**ONE, **change})


def test_spatial_springs_must_be_stiff():
    points = np.array([[[0.0, 0, 1]]])
    with pytest.raises(GraspError, match=r"stiffness\[0, 0\] is 0.0; expected .* above 0 in space"):
        check_grasps(points, -points, 1, np.zeros((1, 6)), stiffness=0)


def test_grasp_of_result_is_exact():
    assert isinstance(check_grasps(**ONE).grasp(-1), Grasp)
