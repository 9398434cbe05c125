"""What gives at an end of the resisted magnitudes: contacts that slip or lift off, and pads."""

from fractions import Fraction

import pytest
from hypothesis import assume, given

from equilibrium import Assembly, BodyContact, Contact, Grasp, ResistedSet, read_grasp, solve
from equilibrium.decide.assemblies import ends
from equilibrium.decide.assemblies.ends import Giving
from equilibrium.decide.solver import Solver
from equilibrium.grasps.textbook import stack
from equilibrium.pictures.assemblies import draw_assembly
from equilibrium.pictures.grasp import draw_grasp
from equilibrium.wrench_sets.line import limit_words

from .strategies import directions, pinches

WEIGHT = (0, -1, 0)
#: Feet of a block of weight 1 with its middle above 0.
FEET = [Contact([x, 0], [0, 1], "1/2") for x in (-1, 1)]


def pushed(height):
    """Return a push to the right at a height."""
    return (1, 0, -height)


class TestBlock:
    @pytest.mark.parametrize("bodies", [False, True])
    @pytest.mark.parametrize(
        ("height", "end", "gives", "words"),
        [
            (1, "1/2", Giving(slips=(1, 2)), "slips at contacts 1, 2"),
            (3, "1/3", Giving(lifts_off=(1,)), "contact 1 lifts off"),
            (2, "1/2", Giving((2,), (1,)), "slips at contact 2; contact 1 lifts off"),
        ],
    )
    def test_slides_or_tips_or_both(self, height, end, gives, words, bodies):
        grasp, push, weight = Grasp(FEET), pushed(height), WEIGHT
        if bodies:
            grasp = Assembly.of_grasp(grasp)
            push, weight = {"object": push}, {"object": weight}
        resisted = ResistedSet(grasp)
        found = resisted.along(push, weight)
        assert found.intervals == ((0, Fraction(end)),)
        ((start, last),) = resisted.what_gives(found)
        assert start is None
        assert (last, last.words) == (gives, words)

    def test_lower_ends_have_their_own(self):
        """A push to the left of 1 acts: the push to the right has to take half of it."""
        resisted = ResistedSet(Grasp(FEET))
        found = resisted.along(pushed(0), (-1, -1, 0))
        assert found.intervals == ((Fraction(1, 2), Fraction(3, 2)),)
        assert resisted.what_gives(found) == ((Giving((1, 2)), Giving((1, 2))),)

    def test_slips_before_the_end_do_not_give_there(self):
        """The fingers of the paper slip from the start; at the end the third one lets go."""
        resisted = ResistedSet(read_grasp("paper-three-contacts-preload-1"))
        assert resisted.what_gives(resisted.along([0, 1, 0])) == ((None, Giving(lifts_off=(2,))),)

    def test_unbounded_end_gives_nothing_and_0_alone_has_no_forces(self):
        resisted = ResistedSet(read_grasp("paper-three-contacts"))
        assert resisted.what_gives(resisted.along([0, -1, 0])) == ((None, None),)
        found = resisted.what_gives(resisted.along([0, 1, 0]))
        assert found == ((None, Giving(unloaded=(1, 2, 3))),)
        assert found[0][1].words == "no force at contacts 1, 2, 3"

    def test_0_alone_at_the_friction_limit(self):
        resisted = ResistedSet(Grasp(FEET))
        found = resisted.along(pushed(0), ("1/2", -1, 0))
        assert found.intervals == ((Fraction(0), Fraction(0)),)
        assert resisted.what_gives(found) == ((None, Giving((1, 2))),)

    def test_smooth_contacts_do_not_slip(self):
        wall = Contact([-2, 1], [1, 0], 0, preload=1)
        resisted = ResistedSet(Grasp([*FEET, wall]))
        found = resisted.along(pushed(1), WEIGHT)
        (pair,) = resisted.what_gives(found)
        assert 3 not in pair[1].slips

    def test_an_end_of_too_many_states_is_not_reported(self, monkeypatch):
        monkeypatch.setattr(ends, "_NODES", 1)
        resisted = ResistedSet(Grasp(FEET))
        assert resisted.what_gives(resisted.along(pushed(1), WEIGHT)) == ((None, None),)


#: A pad of three points, whose middle comes first.
PLACES, SHARES = (0, -1, 1), ("1/2", "1/4", "1/4")


class TestPad:
    def test_force_leaves_the_pad(self):
        pad = [Contact([x, 0], [0, 1], "1/2", share=s) for x, s in zip(PLACES, SHARES, strict=True)]
        resisted = ResistedSet(Grasp(pad))
        found = resisted.along((0, 0, 1), WEIGHT)
        assert found.intervals == ((0, 1),)
        ((_, last),) = resisted.what_gives(found)
        assert last == Giving(tips=(1,))
        assert last.words == "the force leaves the pad of contact 1"

    def test_pad_slips_as_a_whole(self):
        halves = [Contact([x, 0], [0, 1], "1/2", share="1/2") for x in (-1, 1)]
        resisted = ResistedSet(Grasp(halves))
        ((_, last),) = resisted.what_gives(resisted.along(pushed(0), WEIGHT))
        assert last.words == "slips at contact 1"


class TestAssemblies:
    def test_contacts_have_their_numbers_in_the_whole(self):
        assembly, weights = stack(blocks=2)
        resisted = ResistedSet(assembly)
        upper = resisted.along({"block 2": [1, 0, "-3/2"]}, weights)
        assert resisted.what_gives(upper) == ((None, Giving((3, 4))),)
        lower = resisted.along({"block 1": [1, 0, 0]}, weights)
        assert resisted.what_gives(lower) == ((None, Giving((1, 2))),)

    def test_parts_that_end_together_are_both_named(self):
        feet = [BodyContact(name, None, foot) for name in "ab" for foot in FEET]
        resisted = ResistedSet(Assembly(["a", "b"], feet))
        weights = dict.fromkeys("ab", WEIGHT)
        found = resisted.along({"a": pushed(1), "b": pushed(3)}, weights)
        assert resisted.what_gives(found) == ((None, Giving(lifts_off=(3,))),)
        found = resisted.along(dict.fromkeys("ab", pushed(1)), weights)
        assert resisted.what_gives(found) == ((None, Giving((1, 2, 3, 4))),)


@given(pinches().map(lambda grasp: grasp.with_preload(1)), directions)
def test_what_gives_is_so_in_every_equilibrium_at_the_end(grasp, wrench):
    region = ResistedSet(grasp)
    found = region.along(wrench)
    pairs = zip(found.intervals, region.what_gives(found), strict=True)
    both = [x for interval, pair in pairs for x in zip(interval, pair, strict=True)]
    assume(any(gives for _, gives in both))
    for end, gives in both:
        if gives is None:
            continue
        equilibria = solve(grasp, [end * x for x in wrench]).equilibria
        assert equilibria
        for equilibrium in equilibria:
            for k in gives.lifts_off:
                assert equilibrium.forces[k - 1][0] == 0
            for k in gives.slips:
                normal, tangential = equilibrium.forces[k - 1]
                assert abs(tangential) == grasp.contacts[k - 1].friction * normal
                assert grasp.contacts[k - 1].friction


class TestPreloads:
    @pytest.mark.parametrize("bodies", [False, True])
    def test_too_little_preload_slips(self, bodies):
        grasp, load = read_grasp("paper-four-contacts"), (0, 1, 0)
        if bodies:
            grasp, load = Assembly.of_grasp(grasp), {"object": load}
        resisted = ResistedSet(grasp)
        found = resisted.margin(load).preloads
        assert found.intervals == ((Fraction(1, 2), None),)
        assert resisted.what_gives(found) == ((Giving((1, 2, 3, 4)), None),)

    def test_of_chosen_contacts_and_one_load(self, run):
        asked = "resisted paper-three-contacts --wrench 0 1 0 --margin --contacts 1 3"
        line = "resisted with a preload of contacts 1, 3 in [1, oo)\n  at 1: slips at contacts 1, 3"
        assert line in run(asked, code=1)
        document = run.json(f"{asked} --also 0 3 0", code=1)
        assert document["preload"]["gives"] == [[None, None]]


class TestInSpace:
    @pytest.mark.parametrize(
        ("push", "end", "gives"),
        [
            ((1, 0, 0, 0, -1, 0), 1, Giving(slips=(1, 2, 3, 4))),
            ((1, 0, 0, 0, 3, 0), "1/2", Giving(lifts_off=(1, 2))),
        ],
    )
    def test_box_slides_or_tips(self, push, end, gives):
        resisted = ResistedSet(read_grasp("box-on-a-table"))
        found = resisted.along(push, (0, 0, -2, 0, 0, 0))
        (border,) = found.borders
        assert (border.resisted, border.exact) == (Fraction(end), True)
        assert found.what_gives() == (gives,)

    def test_what_is_read_off_one_equilibrium_is_called_so(self, run):
        asked = ["resisted", "two-opposed-fingers", "--wrench", *"011000"]
        line = "  in an equilibrium at 4587/6487: slips at contacts 1, 2"
        assert line in run(*asked).splitlines()
        gives = {"slips": [1, 2], "lifts_off": [], "tips": [], "unloaded": []}
        assert run.json(*asked)["gives"] == [gives]

    def test_at_0_nothing_is_read_off(self):
        found = ResistedSet(read_grasp("box-on-a-table")).along((0, 0, 1, 0, 0, 0))
        assert found.zero_only
        assert found.what_gives() == (None,)


class TestPictures:
    def test_legend_states_what_gives_at_the_limit_of_the_load(self):
        grasp = read_grasp("paper-four-contacts-preload-1")
        scene = draw_grasp.scene(grasp, wrench=(0, 1, 0))
        line = "up to 2 times the load: slips at contacts 1, 2, 3, 4"
        assert line in [text for text, _ in scene.legend.lines]

    def test_legend_of_bodies(self):
        """A book of weight 1/2 between walls that press with 1 each."""
        walls = [Contact([x, 0], [-x, 0], "1/2", preload=1) for x in (-1, 1)]
        book = Assembly(["book"], [BodyContact("book", None, wall) for wall in walls])
        scene = draw_assembly.scene(solve(book, {"book": [0, "-1/2", 0]}))
        line = "up to 2 times the load: slips at contacts 1, 2"
        assert line in [text for text, _ in scene.legend.lines]

    def test_no_words_where_nothing_is_established(self):
        many = Grasp(Contact([x, 0], [0, 1], 1) for x in range(13))
        assert limit_words(Solver(many), (0, -1, 0)) == []
        assert limit_words(Solver(Grasp(FEET)), (0, 0, 0)) == []
        assert limit_words(Solver(Grasp(FEET)), (0, 1, 0)) == []


def test_contact_without_force_inside_does_not_slip_at_the_end(tmp_path, run):
    """Contact 1 has no force below 20/307, and there in some equilibria alone."""
    path = tmp_path / "grasp.csv"
    path.write_text(
        "x,y,nx,ny,mu,k,q,adhesion\n-3,3,3/5,4/5,1/2,2,0,0\n-1,1,3/5,4/5,1/2,0,1,1\n"
        "-1,0,-4/5,3/5,1/4,1,1,1\n"
    )
    assert "  at 20/307: slips at contact 3\n" in run("resisted {} --wrench -2 -2 -1", path)
