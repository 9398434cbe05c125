"""The census of types: published numbers, distinctness, nothing outside, resumption."""

from __future__ import annotations

import itertools
import json

import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, InputError
from arrangement.library.census import MOST_PLANES, PUBLISHED, PUBLISHED_SIMPLE, catalogue, census
from arrangement.library.census.making import generate


@pytest.mark.parametrize("planes", range(3, MOST_PLANES + 1))
def test_numbers_of_types_are_the_published_ones(planes: int) -> None:
    assert len(census(planes)) == PUBLISHED[planes]
    assert len(census(planes, simple=True)) == PUBLISHED_SIMPLE[planes]


@pytest.mark.parametrize("planes", range(3, 8))
def test_representatives_are_distinct_planes_of_rank_three(planes: int) -> None:
    for arrangement in census(planes):
        assert arrangement.is_central
        assert arrangement.rank == 3
        assert len(arrangement.distinct) == len(arrangement) == planes


@pytest.mark.parametrize("planes", range(3, 8))
def test_no_two_representatives_have_one_type(planes: int) -> None:
    forms = {generate.canonical_form(arrangement) for arrangement in census(planes)}
    assert len(forms) == PUBLISHED[planes]


def test_the_generator_makes_the_shipped_list_again() -> None:
    made = json.loads(generate.generate(6))["types"]
    shipped = catalogue._document()["types"]
    assert made == {planes: shipped[planes] for planes in made}
    assert list(made) == ["3", "4", "5", "6"]


def brute_force_form(arrangement: Arrangement) -> tuple[tuple[int, ...], ...]:
    """The least sorted list of regions over all relabellings and exchanges of sides.

    It suffices to reorient so that some region becomes all +.
    """
    regions = [face.signs for face in arrangement.regions()]
    planes = range(len(arrangement))
    return min(
        tuple(sorted(tuple(base[i] * signs[i] for i in order) for signs in regions))
        for base in regions
        for order in itertools.permutations(planes)
    )


@pytest.mark.parametrize("planes", [3, 4, 5])
def test_canonical_graphs_and_brute_force_tell_the_same_types_apart(planes: int) -> None:
    forms = {brute_force_form(arrangement) for arrangement in census(planes)}
    assert len(forms) == PUBLISHED[planes]


entries = st.integers(-4, 4)
normals = st.tuples(entries, entries, entries).filter(any)


@settings(max_examples=60)
@given(st.lists(normals, min_size=3, max_size=7))
def test_no_arrangement_has_a_type_outside_the_census(rows: list[tuple[int, int, int]]) -> None:
    arrangement = Arrangement(rows)
    firsts = [rows[members[0]] for members in arrangement.distinct]
    if arrangement.rank < 3:
        return
    known = {generate.canonical_form(a) for a in census(len(firsts))}
    assert generate.canonical_form(Arrangement(firsts)) in known


@settings(max_examples=30)
@given(st.data())
def test_relabelling_and_reorienting_keep_the_canonical_form(data: st.DataObject) -> None:
    arrangement = data.draw(st.sampled_from(census(6)))
    order = data.draw(st.permutations(range(6)))
    sides = data.draw(st.lists(st.sampled_from([1, -1]), min_size=6, max_size=6))
    moved = [
        [side * x for x in arrangement.normals[i]] for i, side in zip(order, sides, strict=True)
    ]
    assert generate.canonical_form(Arrangement(moved)) == generate.canonical_form(arrangement)


def test_an_interrupted_run_goes_on_and_gives_the_same_list(tmp_path, monkeypatch) -> None:
    whole = generate.generate(5)
    progress = tmp_path / "progress.jsonl"
    extended = generate._extended
    calls = []

    def interrupted(rows):
        calls.append(rows)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return extended(rows)

    monkeypatch.setattr(generate, "_extended", interrupted)
    with pytest.raises(KeyboardInterrupt):
        generate.generate(5, progress)
    with progress.open("a") as stream:
        stream.write('[["cut off')
    assert generate.generate(5, progress) == whole
    assert len(calls) == 4  # two done before, one interrupted and done again


@pytest.mark.parametrize("planes", [2, MOST_PLANES + 1, 5.0, "5", True])
def test_numbers_outside_the_census_are_refused(planes: object) -> None:
    with pytest.raises(InputError, match="3 to 9"):
        census(planes)  # type: ignore[arg-type]
