"""Certificates: valid ones pass, and every change is refused, by digest and by mathematics."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
import sympy
from hypothesis import assume, given, settings, strategies as st

from arrangement.errors import InputError
from equilibrium import Contact, Grasp, check, read_grasp, solve
from equilibrium.certificate.regions_checker import digest

from .strategies import grasps, wrenches

STABLE = solve(read_grasp("paper-three-contacts-preload-1"), (0, 1, 0)).certificate.to_dict()
UNSTABLE = solve(read_grasp("paper-three-contacts-preload-1"), (0, "1.1", 0)).certificate.to_dict()


TEXTS = ("digest", "certificate", "schema_version")


def numbers(value: Any, path: tuple = ()) -> Iterator[tuple]:
    """Yield the paths of all numbers of a document (signs and names of conditions are none)."""
    if isinstance(value, dict):
        for key, entry in value.items():
            if key not in TEXTS:
                yield from numbers(entry, (*path, key))
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            yield from numbers(entry, (*path, i))
    elif isinstance(value, int) or (not set(value) - set("-/0123456789") and value[-1:] >= "0"):
        yield path


def at(document: Any, path: tuple) -> Any:
    for key in path:
        document = document[key]
    return document


def changed(document: dict, path: tuple, value: Any, redigest: bool = False) -> dict:
    mutated = copy.deepcopy(document)
    at(mutated, path[:-1])[path[-1]] = value
    if redigest:
        mutated["digest"] = digest(mutated)
    return mutated


def refused(document: dict) -> bool:
    try:
        return not check(document)
    except InputError:
        return True


def shifted(value: Any) -> Any:
    return value + 1 if isinstance(value, int) else str(Fraction(value) + Fraction(1, 7))


@pytest.mark.parametrize("document", [STABLE, UNSTABLE], ids=["stable", "unstable"])
def test_unchanged_certificate_is_valid(document):
    assert check(document)


@pytest.mark.parametrize("document", [STABLE, UNSTABLE], ids=["stable", "unstable"])
def test_any_one_changed_number_is_refused(document):
    paths = list(numbers(document))
    assert len(paths) > 20
    for path in paths:
        assert refused(changed(document, path, shifted(at(document, path)))), path


@pytest.mark.parametrize("key", ["inequalities", "equalities"])
def test_any_changed_multiplier_is_refused_by_mathematics(key):
    combined = {s: r for s, r in UNSTABLE["branches"].items() if isinstance(r, dict)}
    assert len(combined) > 10
    for states, reason in combined.items():
        for j, value in enumerate(reason[key]):
            path = ("branches", states, key, j)
            report = check(changed(UNSTABLE, path, shifted(value), redigest=True))
            assert not report.valid
            assert report.lines[-1].name == f"branch {states}"


@pytest.mark.parametrize("rationals_only", [False, True])
def test_a_name_is_accepted_exactly_when_that_condition_fails(rationals_only):
    named = {s: r for s, r in UNSTABLE["branches"].items() if isinstance(r, str)}
    kinds = ["normal", "slip", "friction-", "friction+"]
    names = [f"{kind} {i}" for kind in kinds for i in range(3)]
    accepted = 0
    for states in named:
        system = conditions(states)
        for name in names:
            document = changed(UNSTABLE, ("branches", states), name, redigest=True)
            valid = bool(check(document, rationals_only=rationals_only))
            assert valid == (system.get(name, 0) < 0), (states, name)
            accepted += valid
    assert accepted >= len(named)


def conditions(letters: str) -> dict[str, Fraction]:
    """Return the values of the conditions at the only solution, by SymPy."""
    grasp = read_grasp("paper-three-contacts-preload-1")
    x, y, r, *forces = symbols = sympy.symbols("x y r c0:3")
    balance, rows, values = [0, sympy.Rational("1.1"), 0], [], {}
    for i, (c, letter) in enumerate(zip(grasp, letters, strict=True)):
        move = [sum(a * b for a, b in zip(v, (x, y, r), strict=True))
                for v in (c.normal_wrench, c.tangential_wrench)]  # fmt: skip
        force = c.preload - c.stiffness * move[0]
        if letter == "d":
            values[f"normal {i}"] = -force
            rows.append(forces[i])
            continue
        values[f"normal {i}"] = force
        side = {"+": 1, "-": -1, "0": 0}[letter]
        if letter == "0":
            rows.append(move[1])
            values[f"friction- {i}"] = c.friction * force - forces[i]
            values[f"friction+ {i}"] = c.friction * force + forces[i]
        else:
            rows.append(forces[i] + side * c.friction * force)
            values[f"slip {i}"] = side * move[1]
        for axis in range(3):
            balance[axis] += force * c.normal_wrench[axis] + forces[i] * c.tangential_wrench[axis]
    (solution,) = sympy.linsolve([*balance, *rows], symbols)
    at = dict(zip(symbols, solution, strict=True))
    return {name: sympy.sympify(v).subs(at) for name, v in values.items()}


@settings(max_examples=25)
@given(grasps(), wrenches, st.data())
def test_changed_multiplier_of_a_random_proof_is_refused_by_mathematics(grasp, wrench, data):
    document = solve(grasp, wrench).certificate.to_dict()
    if document["certificate"] == "stable":
        return
    paths = [path for path in numbers(document) if path[0] == "branches"]
    assume(paths)
    path = data.draw(st.sampled_from(paths))
    assert refused(changed(document, path, shifted(at(document, path)), redigest=True))


def test_changed_region_is_refused_by_mathematics():
    for i, (signs, *point) in enumerate(UNSTABLE["regions"]):
        for j, sign in enumerate(signs):
            other = signs[:j] + {"+": "-", "-": "+"}[sign] + signs[j + 1 :]
            report = check(changed(UNSTABLE, ("regions", i), [other, *point], redigest=True))
            assert not report.valid
            assert report.lines[-1].name == "regions"


@pytest.mark.parametrize("rationals_only", [False, True])
@pytest.mark.parametrize("scale", [0, -1])
def test_a_point_needs_a_positive_scale(scale, rationals_only):
    for i, (signs, *point) in enumerate(UNSTABLE["regions"]):
        entry = [signs, *(scale * x for x in point)]
        document = changed(UNSTABLE, ("regions", i), entry, redigest=True)
        assert not check(document, rationals_only=rationals_only)


def test_a_point_on_a_plane_is_refused():
    """The origin lies on all tangential planes, whatever signs are claimed there."""
    for i, (signs, *_) in enumerate(UNSTABLE["regions"]):
        report = check(changed(UNSTABLE, ("regions", i), [signs, 0, 0, 0, 1], redigest=True))
        assert [line.name for line in report.lines if not line.holds] == ["regions"]


def test_removed_repeated_and_invented_entries_are_refused_by_mathematics():
    regions, branches = UNSTABLE["regions"], UNSTABLE["branches"]
    for i in range(len(regions)):
        assert refused(changed(UNSTABLE, ("regions",), regions[:i] + regions[i + 1 :], True))
        assert refused(changed(UNSTABLE, ("regions",), [*regions, regions[i]], True))
    for states in branches:
        fewer = {s: reason for s, reason in branches.items() if s != states}
        report = check(changed(UNSTABLE, ("branches",), fewer, redigest=True))
        assert report.lines[-1].problem == f"the states {states} are not refuted"
    invented = {**branches, "ddd": "normal 0"}
    assert "ddd" not in branches
    assert refused(changed(UNSTABLE, ("branches",), invented, redigest=True))


@pytest.mark.parametrize(
    "name", ["", "normal", "normal 3", "normal 00", "normal -1", "pull 0", "slip x"]
)
def test_an_unknown_condition_is_refused(name):
    states = next(s for s, reason in UNSTABLE["branches"].items() if isinstance(reason, str))
    assert refused(changed(UNSTABLE, ("branches", states), name, redigest=True))


@settings(max_examples=30, deadline=None)
@given(grasps(), wrenches)
def test_rationals_alone_come_to_the_same_answer(grasp, wrench):
    document = solve(grasp, wrench).certificate.to_dict()
    assert check(document, rationals_only=True)
    assert check(document)


@pytest.mark.parametrize(("i", "j"), [(0, 1), (1, 2), (0, 2)])
def test_swapped_contacts_are_refused_by_mathematics(i, j):
    for document in (STABLE, UNSTABLE):
        contacts = list(document["grasp"]["contacts"])
        contacts[i], contacts[j] = contacts[j], contacts[i]
        assert refused(changed(document, ("grasp", "contacts"), contacts, redigest=True))


@pytest.mark.parametrize(
    ("path", "value", "line"),
    [
        (("forces", 0, 0), "2", "balance"),
        (("motion", 1), "1/2", "spring"),
        (("motion",), ["0", "2", "0"], None),
        (("grasp", "contacts", 0, "friction"), "1/4", "cone"),
        (("wrench", 1), "2", "balance"),
    ],
)
def test_each_stable_condition_is_named_when_it_fails(path, value, line):
    report = check(changed(STABLE, path, value, redigest=True))
    failed = [entry.name for entry in report.lines if not entry.holds]
    assert failed == [] if line is None else line in failed


def test_friction_along_the_motion_fails_the_dissipation_line():
    grasp = Grasp([Contact((0, 0), (0, 1), 1, 1, 1)])
    verdict = solve(grasp, (1, -1, 0))
    assert verdict.stable
    document = verdict.certificate.to_dict()
    report = check(changed(document, ("motion", 0), "-1", redigest=True))
    assert document["forces"] == [["1", "1"]]
    assert [line.name for line in report.lines if not line.holds] == ["dissipation"]


def test_certificate_of_another_question_is_refused():
    verdict = solve(read_grasp("paper-three-contacts"), (0, -1, 0))
    document = verdict.certificate.to_dict()
    assert check(document, question=(verdict.grasp, verdict.wrench))
    assert not check(document, question=(verdict.grasp, (Fraction(0),) * 3))


def test_empty_condition_takes_no_multiplier():
    document = solve(Grasp(), (0, 0, 1)).certificate.to_dict()
    assert check(document)
    assert refused(changed(document, ("branches", "", "equalities", 0), "1", redigest=True))


@pytest.mark.parametrize(
    "change",
    [
        {"schema_version": 2},
        {"schema_version": True},
        {"certificate": "maybe"},
        {"certificate": ["stable"]},
        {"extra": 1},
    ],
)
def test_unreadable_form_is_an_input_error(change):
    with pytest.raises(InputError):
        check({**STABLE, **change})


@pytest.mark.parametrize("value", [0.5, "1e9", "__import__('os')", None, True, "1/0"])
def test_wrong_number_with_a_right_digest_is_an_input_error(value):
    with pytest.raises(InputError):
        check(changed(STABLE, ("motion", 0), value, redigest=True))
