"""The range of small motions: only equilibria that keep the bounds count."""

import json
import subprocess
from dataclasses import replace
from fractions import Fraction

import pytest

from arrangement.drawing.pages.html_page import _text
from equilibrium import Contact, Grasp, Solver, check, read_grasp, solve
from equilibrium.certificate.leaves import parts
from equilibrium.cli.program import main
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.range import Range, usual_range
from equilibrium.pictures.lab.page import DECIDES
from equilibrium.plane.search.units import unit_of
from equilibrium.wrench_sets import margin, resisted_magnitudes, resisted_set, sufficient_preloads
from equilibrium.wrench_sets.spatial import spatial_magnitudes

THREE = "paper-three-contacts-preload-1"
#: An equilibrium under it turns by 1 at least.
TURNED = (0, Fraction(1, 2), Fraction(1, 2))


def bounds_of(turn: Fraction, force: Fraction):
    """Return bounds at, below and above the turn and the force of an equilibrium."""
    less, more = Fraction(999, 1000), Fraction(1001, 1000)
    return [(turn, None), (less * turn, None), (more * turn, less * force)]


@pytest.mark.parametrize(("contacts", "seed"), [(2, 4), (3, 1), (3, 6)])
def test_a_verdict_in_a_range_is_that_of_all_equilibria(contacts, seed):
    grasp, wrench = random_grasp(contacts, seed), random_wrench(seed)
    found = solve(grasp, wrench).equilibria
    assert found
    points = [(abs(piece.motion[2]), max(f[0] for f in piece.forces)) for piece in found]
    for turn, force in bounds_of(*points[0]):
        verdict = Solver(grasp, turn, force).solve(wrench)
        wanted = any(
            (turn is None or x <= turn) and (force is None or y <= force) for x, y in points
        )
        assert wanted <= verdict.stable
        if all(piece.unique for piece in found):
            assert verdict.stable == wanted
        assert bool(Solver(grasp, turn, force)._equilibria(verdict.wrench)) == verdict.stable
        assert verdict.verify()
        assert verdict.verify().within == Range(turn, force)


@pytest.mark.parametrize("turn", ["1/10", "99/100", "1"])
def test_the_proof_of_a_range_proves_nothing_without_it(turn):
    grasp = read_grasp(THREE)
    verdict = solve(grasp, TURNED, largest_turn=turn)
    assert verdict.stable == (turn == "1")
    document = verdict.certificate.to_dict()
    assert document["largest_turn"] == turn
    question = grasp, verdict.wrench
    assert check(document, question=question, within=Range.of(turn))
    assert not check(document, question=question)
    assert not check(document, question=question, within=Range.of("1/2"))
    changed = {**document, "largest_turn": "101/100" if not verdict.stable else "99/100"}
    assert not check(changed)
    del changed["largest_turn"]
    assert bool(check(changed)) == verdict.stable


def flat_leaf(**used):
    """Return a certificate with one leaf that uses bounds, on the contacts of the paper."""
    question = solve(read_grasp(THREE), TURNED, largest_turn="1/10", largest_force=5)
    leaf = {"virtual_motion": [0, 0, 0], "multipliers": {}, "range": used}
    return {**question.certificate.to_dict(), "tree": leaf}


def test_forged_multipliers_of_the_range_are_refused():
    assert "v must be" in check(flat_leaf(turn=[1, 2])).problem
    assert "v must be" in check(flat_leaf(turn=[-2, 1])).problem
    assert "rho" in check(flat_leaf(forces={"1": -1})).problem
    # The bound itself costs: the part of the motions inside stays open.
    assert "above 0" in check(flat_leaf(turn=[1, 1])).problem
    assert "above 0" in check(flat_leaf(forces={"0": 1})).problem
    without = flat_leaf(turn=[1, 1])
    del without["largest_turn"]
    assert "no largest turn" in check(without).problem
    without = flat_leaf(forces={"0": 1})
    del without["largest_force"]
    assert "no largest force" in check(without).problem


@pytest.mark.parametrize("name", ["largest_turn", "largest_force"])
def test_regions_across_a_bound_are_closed_with_its_multiplier(name):
    grasp, wrench = random_grasp(20, 0), random_wrench(0)
    motion, forces = (getattr(solve(grasp, wrench).solution, x) for x in ("motion", "forces"))
    most = abs(motion[2]) if name == "largest_turn" else max(force[0] for force in forces)
    verdict = solve(grasp, wrench, **{name: Fraction(round(970 * most), 1000)})
    assert verdict.verdict == "not resisted"
    leaves = [part.leaf for part in parts(verdict.certificate.to_dict())]
    across = [leaf for leaf in leaves if any(leaf.motion) and (leaf.turn or leaf.forces)]
    assert len(across) > len(leaves) / 4
    assert verdict.verify().leaves == len(leaves) < 70


def test_an_equilibrium_beyond_a_bound_is_refused():
    document = solve(read_grasp(THREE), TURNED).certificate.to_dict()
    turn = abs(Fraction(document["motion"][2]))
    force = max(Fraction(pair[0]) for pair in document["forces"])
    for name, value in (("largest_turn", turn), ("largest_force", force)):
        assert check({**document, name: str(value)})
        assert not check({**document, name: str(value * Fraction(999, 1000))})


@pytest.mark.parametrize("value", [None, -1, "-1/2", 0.5, "x"])
def test_a_bound_is_an_exact_number_of_at_least_0(value):
    document = solve(read_grasp(THREE), TURNED).certificate.to_dict()
    with pytest.raises(Exception, match="largest_turn"):
        check({**document, "largest_turn": value})
    if value is not None:
        with pytest.raises(Exception, match="largest_force"):
            solve(read_grasp(THREE), TURNED, largest_force=value)


def test_wrench_sets_hold_what_verdicts_of_the_range_say():
    solver = Solver(read_grasp(THREE), "1/10", 3)
    line = resisted_magnitudes(solver, TURNED)
    everything = resisted_set(solver)
    assert line.intervals == ((0, Fraction(1, 5)),) == everything.along(TURNED)
    assert margin(solver, TURNED).intervals == line.intervals
    for t in (Fraction(1, 5), Fraction(201, 1000), Fraction(1)):
        wrench = [t * w for w in TURNED]
        assert solver.solve(wrench).stable == line.contains(t) == everything.contains(wrench)


def test_preloads_in_a_range_are_those_that_verdicts_accept():
    grasp, wrench = read_grasp("paper-four-contacts"), (0, 2, Fraction(1, 2))
    found = sufficient_preloads(Solver(grasp, "1/4", 4), wrench).intervals
    for p in (Fraction(k, 4) for k in range(25)):
        loaded = Solver(grasp.with_preload(p), "1/4", 4)
        inside = any(low <= p and (high is None or p <= high) for low, high in found)
        assert loaded.solve(wrench).stable == inside
    assert found
    assert found[-1][1] == 4


@pytest.mark.parametrize("seed", [2, 6])
def test_a_verdict_in_space_keeps_the_bounds(seed):
    grasp = random_grasp(4, seed, dimension=3).with_preload(1)
    wrench = random_wrench(seed, dimension=3, bound=1)
    free = solve(grasp, wrench)
    assert free.stable
    turn = sum(float(x) ** 2 for x in free.solution.motion[3:]) ** 0.5
    force = max(float(f[0]) for f in free.solution.forces)
    for scale in ("1/2", "2"):
        for name, value in (("largest_turn", turn), ("largest_force", force)):
            bound = Fraction(scale) * Fraction(value).limit_denominator(1000)
            found = solve(grasp, wrench, **{name: bound})
            assert found.verify() if found.decided else scale == "1/2"
            if scale == "2":
                assert found.stable
            document = found.certificate.to_dict() if found.decided else {}
            if found.decided and not found.stable:
                assert not check({**document, name: str(2 * bound)})
            elif found.decided:
                assert not check({**document, name: str(bound / 1000)})


def test_a_range_in_space_bounds_magnitudes():
    grasp = read_grasp("two-opposed-fingers")
    along = (0, 1, 0, 0, 0, 0)
    most = max(c.preload for c in grasp)
    less = spatial_magnitudes(grasp, along, width="1/100", largest_force=most / 2)
    assert less.verdict == "not resisted"
    assert spatial_magnitudes(grasp, along, width="1/100", largest_force=most).borders


@pytest.mark.parametrize("seed", range(4))
def test_pyramids_have_a_range_too(seed):
    grasp, wrench = random_grasp(3, seed, dimension=3), random_wrench(seed, dimension=3, bound=1)
    free = solve(grasp, wrench, pyramid=4)
    if not free.stable:
        assert solve(grasp, wrench, pyramid=4, largest_force=9).verdict == free.verdict
        return
    turn = sum(x * x for x in free.solution.motion[3:])
    force = max(x for x, *_ in free.solution.forces)
    for largest in ({"largest_turn": turn + 1}, {"largest_force": force}):
        assert solve(grasp, wrench, pyramid=4, **largest).stable
    size = max(map(abs, wrench[:3]))
    none = solve(grasp, wrench, pyramid=4, largest_force=size / 100)
    assert none.verdict == "not resisted"
    assert none.verify()
    assert not check({**none.certificate.to_dict(), "largest_force": str(10 * force)})


def test_in_space_a_line_says_that_no_equilibrium_is_small_only_if_that_is_proved():
    soft = random_grasp(4, 2, dimension=3)
    wrench = random_wrench(2, dimension=3, bound=1)
    hard = Grasp(replace(c, stiffness=1000 * c.stiffness) for c in soft)
    assert solve(hard, wrench).warnings == ()
    found = solve(soft, wrench)
    (line,) = found.warnings
    usual = usual_range(found.wrench, [c.preload for c in soft])
    proved = solve(soft, wrench, **usual.bounds)
    assert ("every equilibrium" in line) == (proved.verdict == "not resisted")
    assert proved.verify()


def test_only_large_motions_have_a_warning(capsys):
    grasp = read_grasp(THREE)
    assert solve(grasp, (0, 1, 0)).warnings == ()
    assert solve(grasp, TURNED, largest_turn=3).warnings == ()
    (line,) = solve(grasp, TURNED).warnings
    assert line.startswith("beyond small motions: every equilibrium")
    arguments = ["solve", THREE, "--wrench", "0", "1/2", "1/2"]
    assert main(arguments) == 0
    assert capsys.readouterr().out.splitlines()[-1] == line
    assert main([*arguments, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["warnings"] == [line]
    assert main([*arguments, "--largest-turn", "1/10"]) == 1
    assert "among turns up to 1/10" in capsys.readouterr().out


def test_a_picture_says_that_motions_are_not_small(tmp_path):
    path = tmp_path / "grasp.svg"
    arguments = ["draw", THREE, "--wrench", "0", "1/2", "1/2", "-o", str(path), "--text", "text"]
    assert main(arguments) == 0
    assert "beyond small motions" in path.read_text()
    assert main([*arguments, "--largest-turn", "1/10"]) == 0
    assert "no equilibrium, among turns up to 1/10" in path.read_text()


def test_a_frictionless_disc_turns_too_far_to_resist_a_torque():
    """Normals that miss the centre by 10^-6 hold a torque by a turn without any meaning."""
    small = Fraction(1, 10**6)
    cosine, sine = (1 - small**2) / (1 + small**2), 2 * small / (1 + small**2)
    normals = [(cosine, sine), (-sine, cosine), (-cosine, sine), (sine, -cosine)]
    disc = Grasp(Contact((-x, -y), n, 0, 1, 1) for (x, y), n in
                 zip([(1, 0), (0, 1), (-1, 0), (0, -1)], normals, strict=True))  # fmt: skip
    wrench = (0, 0, 10 * small)
    free = solve(disc, wrench)
    assert free.stable
    assert free.warnings
    refused = solve(disc, wrench, largest_turn="1/10")
    assert not refused.stable
    assert refused.verify()


def test_the_checker_of_the_page_refuses_a_range():
    text = "\n".join(map(_text, DECIDES))
    document = solve(read_grasp(THREE), TURNED, largest_turn=3).certificate.text
    script = f"{text}\nlet said = ''; try {{ checkDocument({document}); }} catch (e) {{ said = e.message; }} console.log(said);"  # noqa: E501
    done = subprocess.run(["node", "-e", script], capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.fail(done.stderr[-500:])
    assert "knows no range" in done.stdout


@pytest.mark.parametrize(
    ("dimension", "length"),
    [(2, Fraction(3, 100)), (2, Fraction(1000)), (3, Fraction(1, 3)), (3, Fraction(1000))],
)
def test_units_change_no_verdict_and_no_size_of_the_proof(length, dimension):
    for seed in (0, 1, 2, 7):
        grasp = random_grasp(4 if dimension == 2 else 6, seed, dimension=dimension)
        wrench = random_wrench(seed, dimension=dimension, bound=1)
        points = [tuple(length * x for x in c.point) for c in grasp]
        moved = Grasp(
            Contact(p, c.normal, c.friction, 100 * c.stiffness, 10 * c.preload)
            for p, c in zip(points, grasp, strict=True)
        )
        load = [10 * w * (1 if j < dimension else length) for j, w in enumerate(wrench)]
        one, other = solve(grasp, wrench), solve(moved, load)
        assert one.stable == other.stable
        assert 0 <= one.verify().leaves == other.verify().leaves
        assert one.verify()
        assert other.verify()


def test_a_unit_is_the_largest_number_or_a_power_of_two_near_a_long_one():
    for number in (Fraction(1), Fraction(3, 100), Fraction(-7, 5), Fraction(10**9, 7)):
        assert unit_of([number, number / 3]) == abs(number)
        number += Fraction(1, 3**50)
        unit = unit_of([number, number / 3])
        assert 1 <= abs(number) / unit < 2
        assert (
            unit.numerator & (unit.numerator - 1) == 0 == unit.denominator & (unit.denominator - 1)
        )
    assert unit_of([]) == unit_of([Fraction(0)]) == 1
