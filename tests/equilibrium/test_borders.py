"""Brackets only shrink: every step of the searches in space, in the plane and of assemblies."""

import random
from fractions import Fraction
from types import SimpleNamespace

import pytest
from hypothesis import given, strategies as st

from equilibrium import Contact, Grasp, ResistedSet, solve
from equilibrium.model.errors import EquilibriumError
from equilibrium.wrench_sets import friction, search_map
from equilibrium.wrench_sets.along_in_space import (
    Border,
    KnownMagnitudes,
    _closer,
    spatial_magnitudes,
)

NORMALS = [(1, 0, 0), (0, -1, 0), (0, 0, 1), (Fraction(3, 5), Fraction(4, 5), 0)]
ANSWERS = st.sampled_from(["resisted", "not resisted", "undecided"])
#: One contact of much friction: with the force along its normal, off its line, 0 alone.
STEEP = Grasp([Contact(["1/3", -1, 0], [1, 0, 0], 1000000, preload=1)])


@pytest.fixture
def steps(monkeypatch):
    """Return the list of steps of brackets in space: before, after, magnitude, answer."""
    found, shrunk = [], Border.shrunk

    def recorded(border, t, answer):
        found.append((border, shrunk(border, t, answer), t, answer))
        return found[-1][1]

    monkeypatch.setattr(Border, "shrunk", recorded)
    return found


def check_step(old, new, t, answer):
    """Nothing changes but by a magnitude inside, and then the end that it is an answer for."""
    low, high = old.ends
    if not low < t < high:
        assert new == old
        return
    assert new.resisted == (t if answer == "resisted" else old.resisted)
    assert new.refused == (t if answer == "not resisted" else old.refused)
    assert low <= new.ends[0] < new.ends[1] <= high
    assert all(new.ends[0] < x < new.ends[1] for x in new.undecided)


def steep_grasp(seed):
    """Return a grasp in space of one or two contacts with friction up to 10^6, and a load."""
    pick = random.Random(seed)
    contacts = [
        Contact(
            [Fraction(pick.randint(-9, 9), 3) for _ in range(3)],
            pick.choice(NORMALS),
            pick.choice([1, 1000, 10**5, pick.randint(1, 10**6)]),
            preload=pick.choice([0, 1, Fraction(1, 2)]),
        )
        for _ in range(pick.choice([1, 1, 1, 2]))
    ]
    return Grasp(contacts), [pick.choice([0, 1, -1, Fraction(2, 3)]) for _ in range(5)] + [1]


class TestSteps:
    @given(st.booleans(), st.lists(st.tuples(st.fractions(-1, 2), ANSWERS), max_size=8))
    def test_every_step_shrinks_or_changes_nothing(self, up, tries):
        border = Border(Fraction(not up), Fraction(up))
        for t, answer in tries:
            new = border.shrunk(t, answer)
            check_step(border, new, t, answer)
            border = new

    def test_one_magnitude_is_not_both(self):
        with pytest.raises(EquilibriumError, match="1/3 is proved to be resisted and not to be"):
            Border(Fraction(1, 3), Fraction(1, 3))

    @pytest.mark.parametrize("share", [-0.01, 1 + 1e-9, 1.5])
    @pytest.mark.parametrize("up", [True, False])
    def test_an_edge_of_floats_beyond_an_end_moves_no_end_outwards(self, steps, share, up):
        """All but the resisted end is refuted; the edge is beyond one of the ends."""
        asked = []
        known = SimpleNamespace(
            scales=False,
            reach=lambda refused, held, near: (share, None, False),
            verdict=lambda t, **how: asked.append(t) or "not resisted",
            refuting=lambda t: None,
        )
        border = Border(Fraction(not up), Fraction(up))
        found = _closer(known, border, Fraction(1, 1000))
        assert found.resisted == border.resisted
        assert all(0 < t < 1 for t in asked)
        for step in steps:
            check_step(*step)


class TestInSpace:
    @pytest.mark.parametrize("seed", range(24))
    def test_every_step_and_both_ends(self, seed, steps):
        self.check(seed, steps)

    @pytest.mark.slow
    @pytest.mark.parametrize("seed", range(100, 400))
    def test_every_step_and_both_ends_of_many(self, seed, steps):
        self.check(seed, steps)

    def check(self, seed, steps):
        grasp, load = steep_grasp(seed)
        found = spatial_magnitudes(grasp, load, nodes=60)
        for step in steps:
            check_step(*step)
        for border in found.borders:
            for t, answer in [(border.resisted, "resisted"), (border.refused, "not resisted")]:
                assert solve(grasp, [t * x for x in load]).verdict == answer
            if border.exact:
                t = border.resisted + (border.refused - border.resisted) / 10**9
                assert solve(grasp, [t * x for x in load]).verdict == "not resisted"

    def test_a_steep_contact_resists_0_alone(self, steps):
        found = spatial_magnitudes(STEEP, [1, 0, 0, 0, 0, 0])
        (border,) = found.borders
        assert border.resisted == 0 < border.refused
        assert found.zero_only
        assert border.exact
        assert found.to_dict()["zero_only"]
        for step in steps:
            check_step(*step)

    def test_an_exact_boundary_is_called_so(self, run):
        grasp = "two-opposed-fingers"
        printed = run("resisted {} --wrench 0 1 0 0 0 0", grasp)
        assert "resisted, then not: the boundary is 1 exactly\n" in printed
        assert "the boundary is 0.7071" in run("resisted {} --wrench 0 1 1 0 0 0", grasp)

    def test_resisted_at_0_only_is_printed(self, tmp_path, run):
        path = tmp_path / "contact.csv"
        path.write_text("x,y,z,nx,ny,nz,mu,q\n1/3,-1,0,1,0,0,1000000,1\n")
        out = run("resisted {} --wrench 1 0 0 0 0 0", path)
        assert out.splitlines()[1:] == ["resisted at 0 only"]

    @pytest.mark.parametrize(
        ("parts", "low", "high", "refuted"),
        [
            ([(0, None)], 0, None, True),
            ([(None, 2), (1, None)], 0, None, True),
            ([(0, 1), (1, None)], 0, None, False),  # 1 itself is in neither
            ([(0, 1), (1, 3), ("1/2", 2)], 0, 3, True),
            ([(1, 3)], 0, 2, False),
            ([(1, 3)], 1, 3, True),
            ([(0, 3)], 0, None, False),
            ([], 0, 1, False),
        ],
    )
    def test_what_open_parts_refute_together(self, parts, low, high, refuted):
        ends = [tuple(None if x is None else Fraction(x) for x in part) for part in parts]
        known = SimpleNamespace(scales=False, refuted=ends)
        args = Fraction(low), None if high is None else Fraction(high)
        assert KnownMagnitudes.refutes_between(known, *args) == refuted


class TestInThePlaneAndOfAssemblies:
    def test_the_search_of_the_paper_asks_inside_its_last_ends(self, monkeypatch):
        asked, holds = [], search_map.holds
        monkeypatch.setattr(
            search_map, "holds", lambda parts, t: asked.append((t, holds(parts, t))) or asked[-1][1]
        )
        parts = [(Fraction(0), Fraction(1, 3)), (Fraction(2), Fraction(3))]
        answer = search_map.binary_search(parts, Fraction(1, 1000), Fraction(16))
        assert asked.pop(0) == (16, False)
        border = Border(Fraction(0), Fraction(16))
        for t, held in asked:
            new = border.shrunk(t, "resisted" if held else "not resisted")
            assert new != border
            check_step(border, new, t, "resisted" if held else "not resisted")
            border = new
        assert border.resisted == answer
        assert border.width <= Fraction(1, 1000)

    @pytest.mark.parametrize("of_bodies", [False, True])
    def test_ranges_of_friction_are_halves_of_earlier_ones(self, monkeypatch, of_bodies):
        from equilibrium import Assembly, BodyContact

        feet = [Contact([x, 0], [0, 1], "1/2") for x in (-1, 1)]
        load, kind = [1, -3, 0], friction._Search
        grasp = Grasp(feet)
        if of_bodies:
            grasp = Assembly(["block"], [BodyContact("block", None, foot) for foot in feet])
            load = {"block": load}
        ranges, possible = [], kind.possible

        def recorded(search, states, low, high):
            ranges.append((low, high))
            return possible(search, states, low, high)

        monkeypatch.setattr(kind, "possible", recorded)
        coarse, fine = (ResistedSet(grasp).margin(load).friction(x) for x in ("1/4", "1/64"))
        assert coarse.low <= fine.low <= Fraction(1, 3) <= fine.high <= coarse.high
        whole = [(0, None), (64, None), *((low, 2 * low or 1) for low in (0, 1, 2, 4, 8, 16, 32))]
        for k, (low, high) in enumerate(ranges):
            halves = [(low, 2 * high - low), (2 * low - high, high)] if high else []
            assert (low, high) in whole or any(half in ranges[:k] for half in halves)
