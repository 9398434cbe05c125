"""Certificates: valid ones pass, and every change is refused, by digest and by mathematics."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st

from arrangement.errors import InputError
from equilibrium import Contact, Grasp, check, read_grasp, solve
from equilibrium.checker import digest

from .strategies import grasps, wrenches

STABLE = solve(read_grasp("paper-three-contacts-preload-1"), (0, 1, 0)).certificate.to_dict()
UNSTABLE = solve(read_grasp("paper-three-contacts-preload-1"), (0, "1.1", 0)).certificate.to_dict()


def numbers(value: Any, path: tuple = ()) -> Iterator[tuple]:
    """Yield the paths of all numbers of a document (texts of signs and states are none)."""
    if isinstance(value, dict):
        for key, entry in value.items():
            if key not in ("signs", "states", "digest", "certificate", "schema_version"):
                yield from numbers(entry, (*path, key))
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            yield from numbers(entry, (*path, i))
    else:
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
    for i, branch in enumerate(UNSTABLE["branches"]):
        for j, value in enumerate(branch[key]):
            path = ("branches", i, key, j)
            report = check(changed(UNSTABLE, path, shifted(value), redigest=True))
            assert not report.valid
            assert report.lines[-1].name.startswith(f"branch {i} ")


@settings(max_examples=25)
@given(grasps(), wrenches, st.data())
def test_changed_multiplier_of_a_random_proof_is_refused_by_mathematics(grasp, wrench, data):
    document = solve(grasp, wrench).certificate.to_dict()
    if document["certificate"] == "stable":
        return
    paths = [path for path in numbers(document) if path[0] == "branches"]
    path = data.draw(st.sampled_from(paths))
    assert refused(changed(document, path, shifted(at(document, path)), redigest=True))


def test_changed_face_is_refused_by_mathematics():
    for i, face in enumerate(UNSTABLE["faces"]):
        dimension = changed(UNSTABLE, ("faces", i, "dimension"), (face["dimension"] + 1) % 4, True)
        other = {"+": "-", "-": "0", "0": "+"}[face["signs"][0]]
        signs = changed(UNSTABLE, ("faces", i, "signs"), other + face["signs"][1:], True)
        for document in (dimension, signs):
            report = check(document)
            assert not report.valid
            assert report.lines[-1].name == "faces"


def test_removed_or_repeated_entries_are_refused_by_mathematics():
    for key in ("faces", "branches"):
        for i in range(len(UNSTABLE[key])):
            fewer = changed(UNSTABLE, (key,), UNSTABLE[key][:i] + UNSTABLE[key][i + 1 :], True)
            assert refused(fewer)
            more = changed(UNSTABLE, (key,), [*UNSTABLE[key], UNSTABLE[key][i]], True)
            assert refused(more)


def test_invented_branch_is_refused():
    invented = {"states": ["stick"] * 3, "inequalities": ["0"] * 9, "equalities": ["0"] * 6}
    known = [b for b in UNSTABLE["branches"] if b["states"] != invented["states"]]
    assert refused(changed(UNSTABLE, ("branches",), [*known, invented], redigest=True))


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
    assert refused(changed(document, ("branches", 0, "equalities", 0), "1", redigest=True))


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
