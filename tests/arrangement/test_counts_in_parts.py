"""Counts in parts: however they are stopped, shared or spread, the numbers are the same."""

import io
import json
import os
import shutil
import zipfile
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arrangement import Arrangement, InputError, cli, counts, families
from arrangement.counts.configuration import configuration
from arrangement.counts.orbits import in_parts as counts_in_parts, symmetric
from arrangement.counts.orbits.symmetric import forecast
from arrangement.errors import OutOfTimeError, UnfinishedError
from arrangement.numbers import deadline
from tests.archives import mutants

RESONANCE = families.resonance(5)
NUMBERS = (1, -31, 375, -2130, 5270, -3485)


in_parts = partial(counts_in_parts.first_whitney_numbers_in_parts, parts=3)


def files(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*.npz"))}


@pytest.mark.parametrize(
    "planes",
    [
        RESONANCE,
        families.shi("B3"),
        families.threshold_functions(3),
        families.random_integer(8, 5, seed=1),
        families.random_degenerate(8, 4, seed=2, affine=True),
        families.h3(),
        families.regular(14),
        families.random_integer(66, 3, seed=3),
        families.coordinate(1),
        Arrangement([[1], [1], [2]], [0, 1, 2]),
    ],
    ids=str,
)
def test_parts_give_the_numbers_of_the_whole(planes, tmp_path):
    assert in_parts(planes, tmp_path) == counts.first_whitney_numbers(planes)


def test_files_without_flats_for_a_part_are_not_opened_for_it(tmp_path, monkeypatch):
    opened = []

    def archive(place: Path) -> zipfile.ZipFile:
        opened.append(place)
        return zipfile.ZipFile(place)

    monkeypatch.setattr(counts_in_parts, "ZipFile", archive)
    assert in_parts(RESONANCE, tmp_path, parts=32) == NUMBERS
    assert len(opened) < 4 * len(set(opened))


def test_folder_made_again_counts_its_new_planes_where_times_are_coarse(tmp_path, monkeypatch):
    """Some file systems keep seconds alone, so that a new file has the time of the old one."""
    real = Path.stat

    def coarse(path: Path, **options: Any) -> Any:
        found = real(path, **options)
        return os.stat_result((*tuple(found)[:7], 0, 0, 0))

    monkeypatch.setattr(Path, "stat", coarse)
    for planes in (RESONANCE, families.threshold_functions(4), families.generic(9, 5)):
        assert in_parts(planes, tmp_path / "same") == counts.first_whitney_numbers(planes)
        shutil.rmtree(tmp_path / "same")


def test_folder_made_anew_counts_its_new_planes(tmp_path):
    folder = tmp_path / "parts"
    for planes in (families.braid(4), families.type_b(3), families.generic(6, 4)):
        assert in_parts(planes, folder) == counts.first_whitney_numbers(planes)
        shutil.rmtree(folder)


def test_flats_are_merged_in_portions_too(tmp_path, monkeypatch):
    monkeypatch.setattr(counts_in_parts, "MANY", 2)
    monkeypatch.setattr(symmetric, "MANY", 2)
    monkeypatch.setattr(symmetric, "_CHUNK", 100)
    assert in_parts(RESONANCE, tmp_path) == NUMBERS


def test_a_count_that_was_stopped_goes_on(tmp_path, monkeypatch):
    monkeypatch.setattr(deadline, "clock", iter(range(1000)).__next__)
    with pytest.raises(
        OutOfTimeError, match=r"^time limit of 0.5 s: .* run the same command again"
    ) as caught:
        in_parts(RESONANCE, tmp_path / "stopped", time_limit=0.5)
    assert caught.value.known == (1,)
    kept = files(tmp_path / "stopped")
    assert kept
    assert in_parts(RESONANCE, tmp_path / "stopped") == NUMBERS
    in_parts(RESONANCE, tmp_path / "whole")
    assert kept.items() <= files(tmp_path / "stopped").items()
    assert files(tmp_path / "stopped") == files(tmp_path / "whole")


def test_shards_do_their_parts_and_wait_for_others(tmp_path):
    unfinished = []
    for turn in range(8):
        try:
            found = in_parts(RESONANCE, tmp_path, shard=(1 + turn % 2, 2))
        except UnfinishedError as error:
            unfinished.append(error)
        else:
            assert found == NUMBERS
            break
    assert len(unfinished) >= 2
    for error in unfinished:
        assert NUMBERS[: len(error.known)] == error.known
        assert "of the 3 parts of rank" in str(error)


def test_every_shard_does_the_ranks_of_one_part(tmp_path):
    with pytest.raises(UnfinishedError) as caught:
        in_parts(RESONANCE, tmp_path, shard=(2, 2))
    assert caught.value.known == NUMBERS[:3]
    for parts in (1, 2):
        assert in_parts(RESONANCE, tmp_path / str(parts), parts=parts) == NUMBERS


def test_processes_give_the_same_files(tmp_path, monkeypatch):
    monkeypatch.setattr(counts_in_parts, "_FEW", 10)
    planes = families.threshold_functions(3)
    assert in_parts(planes, tmp_path / "two", jobs=2) == counts.first_whitney_numbers(planes)
    in_parts(planes, tmp_path / "one")
    assert files(tmp_path / "two") == files(tmp_path / "one")


def test_what_cannot_be_used_is_refused(tmp_path):
    in_parts(families.braid(4), tmp_path)
    with pytest.raises(InputError, match="has parts of other planes"):
        in_parts(RESONANCE, tmp_path)
    with pytest.raises(InputError, match="jobs is 0"):
        in_parts(RESONANCE, tmp_path, jobs=0)
    with pytest.raises(InputError, match="shard is 3/2"):
        in_parts(RESONANCE, tmp_path, shard=(3, 2))
    with pytest.raises(InputError, match="positive number"):
        in_parts(RESONANCE, tmp_path, time_limit=0)
    with pytest.raises(InputError, match="parts is 0"):
        in_parts(RESONANCE, tmp_path, parts=0)
    with pytest.raises(InputError, match="parts is 1000000000; expected at most 100,000"):
        in_parts(RESONANCE, tmp_path, parts=10**9)
    with pytest.raises(InputError, match="no planes"):
        in_parts(Arrangement([], dimension=2), tmp_path / "new")
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot use the folder"):
        in_parts(RESONANCE, tmp_path / "file")


@pytest.mark.parametrize("generators", [[[1, 0, 2, 3, 4, 5]], [[9]], [["a"]], 3, None])
def test_symmetries_of_a_plan_are_checked(tmp_path, generators):
    in_parts(families.braid(4), tmp_path)
    plan = tmp_path / "plan.json"
    plan.write_text(json.dumps(json.loads(plan.read_text()) | {"generators": generators}))
    with pytest.raises(InputError, match="other parts or symmetries"):
        in_parts(families.braid(4), tmp_path)


@pytest.mark.parametrize(
    "plan", ["[]", "3", {"layout": 1}, *({"parts": x} for x in (0, "3", 1.5, True, 10**9))]
)
def test_a_plan_of_another_kind_is_refused(tmp_path, plan):
    in_parts(families.braid(4), tmp_path)
    place = tmp_path / "plan.json"
    known = json.loads(place.read_text())
    assert known["layout"] == 2
    place.write_text(plan if isinstance(plan, str) else json.dumps(known | plan))
    with pytest.raises(InputError, match=r"other planes|other parts|has layout 1; expected 2"):
        in_parts(families.braid(4), tmp_path)


@pytest.mark.parametrize("damage", [b"", b"PK", b"no archive"])
def test_a_damaged_part_is_named(tmp_path, damage):
    in_parts(RESONANCE, tmp_path)
    part = tmp_path / "rank-04" / "part-01.npz"
    part.write_bytes(damage)
    with pytest.raises(InputError, match=r"part-01.npz cannot be read .*delete it"):
        in_parts(RESONANCE, tmp_path)
    part.unlink()
    np.savez(part, other=np.zeros(2))
    with pytest.raises(InputError, match="not part of a count"):
        in_parts(RESONANCE, tmp_path)
    part.unlink()
    assert in_parts(RESONANCE, tmp_path) == NUMBERS


@pytest.mark.parametrize("count", [8, pytest.param(2000, marks=pytest.mark.slow)])
def test_damaged_archives_are_named(count, tmp_path):
    in_parts(RESONANCE, tmp_path)
    part = tmp_path / "rank-04" / "part-01.npz"
    for number, content in enumerate(mutants(part.read_bytes(), count, 2)):
        part.write_bytes(content)
        try:  # what only other ranks need, or nobody, may be damaged
            assert in_parts(RESONANCE, tmp_path) == NUMBERS, number
        except InputError as error:
            assert "part-01.npz cannot be read (" in str(error)  # noqa: PT017


def refused(folder: Path, place: str = "") -> None:
    with pytest.raises(InputError, match=rf"{place}.* cannot be read .*delete it") as error:
        in_parts(RESONANCE, folder)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("source", ["rank-04/part-02", "rank-03/part-01", "other/rank-04/part-01"])
def test_another_part_in_its_place_is_refused(tmp_path, source):
    other = families.threshold_functions(4)
    assert other.rank == RESONANCE.rank
    in_parts(other, tmp_path / "other")
    in_parts(RESONANCE, tmp_path)
    place = tmp_path / "rank-04" / "part-01.npz"
    place.write_bytes((tmp_path / f"{source}.npz").read_bytes())
    refused(tmp_path, "part-01.npz")
    place.unlink()
    assert in_parts(RESONANCE, tmp_path) == NUMBERS


def test_parts_of_another_division_are_refused(tmp_path):
    in_parts(RESONANCE, tmp_path)
    plan = tmp_path / "plan.json"
    plan.write_text(json.dumps(json.loads(plan.read_text()) | {"parts": 2}))
    refused(tmp_path)


def changed(array: np.ndarray, value: Any) -> np.ndarray:
    """Return an array with another first entry, or another array."""
    if not isinstance(value, int) or not array.size:
        return np.asarray(value)
    new = array.copy()
    new.flat[0] += np.asarray(value).astype(array.dtype)
    return new


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    folder = tmp_path_factory.mktemp("store")
    in_parts(RESONANCE, folder)
    return folder


ABSENT = object()
VALUES = [1, 0.5, None, "x", b"", np.zeros((2, 2)), np.zeros(0), ABSENT]


@pytest.mark.parametrize("value", VALUES, ids=[*map(repr, VALUES[:-1]), "absent"])
def test_no_changed_array_is_believed(store, tmp_path, value):
    shutil.copytree(store, tmp_path, dirs_exist_ok=True)
    for rank, part in ((2, 0), (4, 1)):
        place = tmp_path / f"rank-0{rank}" / f"part-0{part}.npz"
        with np.load(place) as file:
            arrays = dict(file)
        for name in arrays:
            content = {key: array for key, array in arrays.items() if key != name}
            if value is not ABSENT:
                content[name] = changed(arrays[name], value)
            for later in tmp_path.glob(f"rank-0{rank + 1}/*"):
                later.unlink()
            place.unlink()
            np.savez(place, **content)
            refused(tmp_path, place.name)
        place.unlink()
    assert in_parts(RESONANCE, tmp_path) == NUMBERS


@pytest.mark.parametrize("shape", [(10**13,), (10**9, 10**9), (10**25,), (0, 10**25)])
def test_a_part_with_less_than_its_header_says_is_named(store, tmp_path, shape):
    """It would be refused for want of memory, and its name would be unknown."""
    shutil.copytree(store, tmp_path, dirs_exist_ok=True)
    place = tmp_path / "rank-04" / "part-01.npz"
    stream = io.BytesIO()
    header = {"descr": "<i8", "fortran_order": False, "shape": shape}
    np.lib.format.write_array_header_1_0(stream, header)
    with zipfile.ZipFile(place) as old:
        content = {name: old.read(name) for name in old.namelist()}
    with zipfile.ZipFile(place, "w") as new:
        for name, data in (content | {"residues.npy": stream.getvalue()}).items():
            new.writestr(name, data)
    refused(tmp_path, place.name)
    place.write_bytes(stream.getvalue())
    refused(tmp_path, place.name)


def test_a_forecast_of_few_flats_counts_them():
    for planes in (RESONANCE, families.shi("B3")):
        ranks = list(forecast(planes))
        assert all(entry.exact for entry in ranks)
        assert [entry.rank for entry in ranks] == list(range(configuration(planes).rank - 1))


def test_a_forecast_of_many_flats_is_near():
    planes = families.random_integer(14, 6, bound=9, seed=1)  # without symmetry a class is a flat
    flats = counts.whitney_numbers(planes).second
    for entry in forecast(planes, sample=60):
        assert entry.exact == (entry.rank < 3)
        assert flats[entry.rank] / 2 < entry.classes < 2 * flats[entry.rank]


def run(*words: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, Any, str]:
    code = cli.main(["count", *words])
    printed = capsys.readouterr()
    return code, printed.out, printed.err


def test_the_command_counts_in_parts(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(deadline, "clock", iter(range(1000)).__next__)
    path, store = tmp_path / "r.json", str(tmp_path / "store")
    path.write_text(json.dumps(RESONANCE.to_dict()))
    code, out, err = run(str(path), "--store", store, "--time-limit", "1/2", capsys=capsys)
    assert (code, out) == (2, "")
    assert "Whitney numbers 1 are final; run the same command again" in err
    code, out, err = run(str(path), "--store", store, capsys=capsys)
    assert code == 0
    assert ["regions", "11292"] in [line.split() for line in out.splitlines()]
    assert "rank 3: Whitney number -2130" in err
    code, out, _ = run(str(path), "--forecast", "--json", capsys=capsys)
    assert code == 0
    assert json.loads(out)["ranks"][0]["classes"] == 1
    code, out, err = run(str(path), "--shard", "1/2", capsys=capsys)
    assert code == 2
    assert "need --store" in err
    shard = (str(path), "--store", str(tmp_path / "other"), "--shard", "1/2")
    code, out, _ = run(*shard, capsys=capsys)
    assert code == 0
    assert out.startswith("shard 1/2 is done: ")
    assert "when the other shards are done" in out
    code, out, _ = run(*shard, "--json", capsys=capsys)
    assert code == 0
    assert json.loads(out) == {"first_whitney_numbers": [1, -31, 375], "complete": False}
