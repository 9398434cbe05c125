"""The least force at a point that a grasp does not resist, over all directions."""

from fractions import Fraction
from random import Random

import pytest

from equilibrium import Contact, Grasp, GraspError, ResistedSet, solve
from equilibrium.wrench_sets import BestDirection

F = Fraction
#: A block of weight 65 on a slope of tangent 3/4 with friction 5/12, and a point over the slope.
UP = ("-3/5", "4/5")
BLOCK = Grasp([Contact([4 * k, 3 * k], UP, "5/12") for k in (0, 1)])
POINT = (F(17, 10), F(19, 10))
WEIGHT = (0, -65, -65 * POINT[0])


def test_least_forces_on_a_block_on_a_slope():
    """W sin(slope + friction angle) up, W sin(slope - friction angle) to hold, by hand."""
    best = ResistedSet(BLOCK).best_direction(WEIGHT, POINT)
    assert best.size == 65 * F(56, 65)
    assert best.moving == (56 * F(33, 65), 56 * F(56, 65))
    assert best.holding == (16 * F(63, 65), 16 * F(16, 65))
    assert best.degrees == pytest.approx(59.4897, abs=1e-4)

    def verdict(force):
        torque = POINT[0] * force[1] - POINT[1] * force[0]
        load = [a + b for a, b in zip(WEIGHT, (*force, torque), strict=True)]
        return solve(BLOCK, load)

    assert verdict(best.moving).stable
    assert verdict(best.holding).stable
    assert not verdict((0, 0)).stable
    refuted = verdict(best.beyond)
    assert refuted.verdict == "not resisted"
    assert refuted.verify()


def test_no_load_at_the_tip_of_a_cone_is_moved_by_the_least_force():
    """Without preloads and weight, resistance ends at once beside the friction cone."""
    best = ResistedSet(BLOCK).best_direction((0, 0, 0), POINT)
    assert (best.moving, best.holding) == ((0, 0), None)
    assert best.beyond is not None


def random_set(seed):
    source = Random(f"best direction {seed}")
    normals = [("1", "0"), ("0", "1"), ("-1", "0"), ("0", "-1"), ("3/5", "4/5"), ("-4/5", "3/5")]
    contacts = [
        Contact(
            [source.randint(-2, 2) for _ in range(2)],
            source.choice(normals),
            F(source.randint(0, 3), 3),
            preload=source.randint(0, 2),
        )
        for _ in range(source.randint(1, 4))
    ]
    base = [source.randint(-2, 2) for _ in range(3)]
    return ResistedSet(Grasp(contacts)), base, [source.randint(-2, 2) for _ in range(2)]


def test_every_direction_ends_no_earlier():
    """Against magnitudes along many directions: each ends where resistance does, or later."""
    found = []
    for seed in range(60):
        resisted, base, point = random_set(seed)
        best = resisted.best_direction(base, point)
        region = resisted.slice((1, 0, -point[1]), (0, 1, point[0]), base)
        found.append(best.moving is not None and bool(best.size_squared))
        if best.moving is None:
            assert best.beyond is None
        else:
            assert not region.contains(best.beyond)
            away = [x - y for x, y in zip(best.beyond, best.moving, strict=True)]
            assert sum(x * x for x in away) <= F(1, 10**6) * (best.size_squared or 1)
            assert not best.size_squared or region.contains(best.moving)
        least = best.size_squared
        for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-5, 12), (-1, -2), (7, -3)):
            for low, high in region.along((x, y)):
                if high is not None and low < high:
                    assert least is not None
                    assert high**2 * (x * x + y * y) >= least
                if best.holding is not None:
                    assert low**2 * (x * x + y * y) >= sum(h * h for h in best.holding)
        assert (best.holding is None) == (region.contains((0, 0)) or not region.polygons)
    assert 15 < sum(found) < 60


def test_best_direction_of_what_is_no_question():
    resisted = ResistedSet(BLOCK)
    with pytest.raises(GraspError, match="point has 3 coordinates; expected 2"):
        resisted.best_direction(0, (0, 0, 0))
    without = ResistedSet(Grasp([Contact([0, 0], [0, 1], 0)])).best_direction([0, 1, 0])
    assert isinstance(without, BestDirection)
    assert (without.moving, without.beyond, without.degrees) == (None, None, None)
    assert without.holding == (0, -1)


def test_best_direction_on_the_command_line(tmp_path, run, refused):
    """A block of 60 on a slope of 20 degrees with friction 0.3: 60 sin(20 + 16.7 degrees)."""
    table = tmp_path / "slope.csv"
    table.write_text("x,y,angle,mu\n0,0,110,0.3\n3.7587704831,1.3680805733,110,0.3\n")
    place = ["1.7", "0.95"]
    line = ["resisted", str(table), "--weight", "60", "--at", *place, "--best-direction", *place]
    out = run(*line)
    assert "that holds it:\n  ≈3.45463 at 3.301 degrees from the x axis" in out
    assert "as it grows:\n  ≈35.8569 at 36.7 degrees from the x axis" in out
    assert "(0, 0)" in run(*line[:2], "--best-direction", "0", "0", "--base", "0", "-1", "0")
    error = refused(*line[:2], "--best-direction", "0", "0", "--smallest")
    assert "--smallest goes with --smallest, not with --best-direction" in error
    assert "--margin goes with a load" in refused(*line, "--margin")
