"""Sweeps: whatever happens on the way, the result is that of an undisturbed run."""

import json
import sqlite3
import sys
from contextlib import closing
from hashlib import sha256
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from arrangement.console import workers
from arrangement.errors import WorkerError
from proofs_check import registry
from proofs_check.errors import SweepError
from proofs_check.statements.evidence import verdict_from
from proofs_check.sweep import report as sweepreport, store
from proofs_check.sweep.sweep import (
    Plan,
    Total,
    about,
    instance,
    merge,
    plan_sweep,
    run_chunk,
    sweep,
    target,
    total,
)

CLAIM = "step-1-square-bound"


def small_plan(samples: int = 60, chunk: int = 7, seed: int = 0) -> Plan:
    return plan_sweep(CLAIM, (1, 4), samples, seed, chunk)


def report(path: Path) -> str:
    with store.read(str(path)) as opened:
        return json.dumps(sweepreport.record(opened))


@pytest.mark.usefixtures("scrambled")
def test_two_processes_find_what_one_finds(tmp_path):
    one, two = tmp_path / "one.sqlite", tmp_path / "two.sqlite"
    sweep(small_plan(30), str(one))
    sweep(small_plan(30), str(two), jobs=2)
    assert report(one) == report(two)


def test_a_sweep_over_types_takes_each_of_them_once(tmp_path, run):
    plan = plan_sweep("state-formula", (3, 6), None, chunk=9)
    sums = total(run_chunk(plan, number) for number in range(plan.chunks))
    assert {m: sum(row) for m, row in sums.counts.items()} == {3: 1, 4: 2, 5: 4, 6: 17}
    assert sums.outcomes["holds"] == 7  # the simple ones; the others are outside
    assert sums.outcomes["outside"] == 17
    every = plan_sweep("euler", (3, 9), None)
    assert every.samples == 1 + 2 + 4 + 17 + 143 + 4890 + 460_779
    assert [len(instance(every, k).distinct) for k in (0, 1, 5056, 5057, every.samples - 1)] == [
        *(3, 4, 8, 9, 9)
    ]
    record = ["sweep", "euler", "--classes", "3..5", "--store", str(tmp_path / "s.sqlite")]
    out = run(*record)
    assert "7 all isomorphism classes of 3 to 5 distinct planes of rank 3: 7 that hold" in out


@pytest.mark.parametrize(
    ("expected", "counts", "remarked"),
    [
        ("holds", [5, 0, 0, 0, 0], False),
        ("refuted", [5, 0, 0, 0, 0], True),
        ("refuted", [3, 0, 2, 0, 0], True),
        ("refuted", [3, 2, 0, 0, 0], False),
        ("holds", [3, 2, 0, 0, 0], False),
        ("refuted", [0, 0, 0, 0, 5], False),
    ],
)
def test_expected_verdict_named_where_samples_may_miss_it(expected, counts, remarked):
    claim = {"record": {"expected": expected}, "domain": "arrangements", "unit": "planes"}
    sums = Total(chunks=1, counts={3: counts})
    found = verdict_from(sums.outcomes)
    text = sweepreport._evidence(Plan(CLAIM, "", 3, 3, 5, 0), claim, sums, found)
    assert text.startswith("5 samples: random arrangements with 3 planes, seed 0: ")
    assert ("on other instances" in text) == remarked
    assert sweepreport._table("planes", sums)["rows"] == [[3, *counts]]


def test_shards_merged_are_the_whole(tmp_path):
    whole = tmp_path / "whole.sqlite"
    sweep(small_plan(), str(whole))
    parts = [str(tmp_path / f"{i}.sqlite") for i in (1, 2, 3)]
    for i, part in enumerate(parts, 1):
        sweep(small_plan(), part, shard=(i, 3))
    merged = tmp_path / "merged.sqlite"
    assert merge(str(merged), parts[:2]) == 6
    assert '"complete": false' in report(merged)
    assert merge(str(merged), parts) == 3
    assert report(merged) == report(whole)


@given(st.integers(1, 30), st.integers(1, 30), st.randoms(use_true_random=False))
def test_neither_the_size_nor_the_order_of_chunks_matters(first, second, rng):
    found = []
    for size in (first, second):
        plan = small_plan(30, size)
        chunks = [run_chunk(plan, number) for number in range(plan.chunks)]
        rng.shuffle(chunks)
        sums = total(chunks)
        found.append((sums.counts, sums.smallest, sums.samples))
    assert found[0] == found[1]
    assert found[0][2] == 30


def test_progress_counts_instances_and_begins_with_what_is_there(tmp_path):
    path = str(tmp_path / "s.sqlite")
    sweep(small_plan(), path, shard=(2, 3))
    seen: list[tuple[int, int]] = []
    sweep(small_plan(), path, progress=lambda done, due: seen.append((done, due)))
    assert seen[0] == (21, 60)
    assert seen[-1] == (60, 60)
    assert seen == sorted(seen)
    assert len(seen) == 7


def test_chunk_counts_once(tmp_path):
    plan = small_plan()
    path = str(tmp_path / "s.sqlite")
    chunk = run_chunk(plan, 0)
    with store.create(path, plan, about(target(CLAIM))) as opened:
        assert opened.add(chunk) is True
        assert opened.add(chunk) is False
        other = store.Chunk(0, {"counts": {}, "smallest": {}}, chunk.environment, 1)
        with pytest.raises(SweepError, match="another result already"):
            opened.add(other)
        with pytest.raises(SweepError, match=f"chunk 0 of part has another result than .* {path}"):
            opened.add(other, "part")
        assert [c.number for c in opened.chunks()] == [0]


def test_the_counts_are_those_of_the_instances_one_by_one(tmp_path):
    plan = small_plan(40, 9)
    sweep(plan, str(tmp_path / "s.sqlite"))
    with store.read(str(tmp_path / "s.sqlite")) as opened:
        sums = total(opened.chunks())
    # The statement: at most m^2 regions. It fails for one plane, which has two.
    planes = [instance(plan, k) for k in range(40)]
    assert sums.outcomes["fails"] == 0
    refuted = sum(p.faces().f_vector[3] > len(p) ** 2 for p in planes)
    assert sums.outcomes["excused"] == refuted == 10
    assert sums.samples == 40
    assert len(sums.smallest["excused"]["instance"]["planes"]) == 1


@pytest.mark.parametrize("id", [claim.id for claim in registry() if claim.domain])
def test_swept_claims_have_values_on_random_instances(id):
    chosen = target(id)
    low = max(chosen.domain.least, 2 if chosen.domain.unit == "contacts" else 3)
    plan = plan_sweep(id, (low, low + (chosen.domain.unit == "planes")), 6, 1, 6)
    sums = total([run_chunk(plan, 0)])
    assert sums.outcomes["broken"] == 0
    found = verdict_from(sums.outcomes)
    assert sweepreport.consistent(found, registry()[id].expected)


def test_false_claim_on_random_instances_shrunk(tmp_path, run):
    path = own_file(tmp_path, 'return planes.rank == 3 or "low rank"')
    plan = ["--elements", "3..5", "--samples", "300", "--store", str(tmp_path / "s.sqlite")]
    assert ": refuted\n" in run("sweep", path, *plan, code=1)
    with store.read(str(tmp_path / "s.sqlite")) as opened:
        (result,) = sweepreport.record(opened)["results"]
    assert len(result["counterexample"]["instance"]["planes"]) == 3
    run("report", tmp_path / "s.sqlite", code=1)


def own_file(folder: Path, *lines: str) -> str:
    body = "\n".join(f"    {line}" for line in lines)
    path = folder / "mine.py"
    path.write_text(
        "import os, pathlib\nfrom proofs_check import claim\n"
        "MARK = pathlib.Path(__file__).with_suffix('.mark')\n"
        f'@claim("s", of="central")\ndef mine(planes):\n{body}\n',
        encoding="utf-8",
    )
    return str(path)


def test_a_file_that_changed_does_not_continue_a_sweep(tmp_path):
    path = own_file(tmp_path, "return True")
    place = str(tmp_path / "s.sqlite")
    old = plan_sweep(path, (3, 4), 20, 0, 5)
    sweep(old, place)
    own_file(tmp_path, "return not False")
    with pytest.raises(SweepError, match="has changed"):
        sweep(old, place)
    with pytest.raises(SweepError, match="another sweep"):
        sweep(plan_sweep(path, (3, 4), 20, 0, 5), place)


def test_a_changed_import_does_not_continue_a_sweep(tmp_path):
    path, place = own_file(tmp_path, "return True"), str(tmp_path / "s.sqlite")
    alone = plan_sweep(path, (3, 4), 20, 0, 5)
    assert alone.digest == sha256(Path(path).read_bytes()).hexdigest()
    helper = tmp_path / "helper.py"
    helper.write_text("ANSWER = 1\n", encoding="utf-8")
    with Path(path).open("a", encoding="utf-8") as file:
        file.write("from helper import ANSWER\n")
    old = plan_sweep(path, (3, 4), 20, 0, 5)
    sweep(old, place, shard=(1, 2))
    helper.write_text("ANSWER = 2\n", encoding="utf-8")
    with pytest.raises(SweepError, match="has changed"):
        sweep(old, place, shard=(2, 2))
    with pytest.raises(SweepError, match=r"another sweep \(helper.py has changed since\)"):
        sweep(plan_sweep(path, (3, 4), 20, 0, 5), place, shard=(2, 2))
    other = str(tmp_path / "other.sqlite")
    sweep(plan_sweep(path, (3, 4), 20, 1, 5), other)
    mistake = rf"{other} belongs to another sweep than {place} \(helper.py differs, seed 1, not 0\)"
    with pytest.raises(SweepError, match=mistake):
        merge(place, [other])


def test_what_was_finished_already_is_reported(tmp_path, run):
    words = ["sweep", CLAIM, "--elements", "3..4", "--samples", "10", "--chunk", "5"]
    words += ["--store", str(tmp_path / "s.sqlite")]
    first = run(*words, "--shard", "1/2")
    assert "already" not in first
    again = "shard 1/2 was finished already: 1 chunk in the store, none new\n"
    assert run(*words, "--shard", "1/2") == again + first
    assert "already" not in run(*words)
    assert run(*words).startswith("the sweep was finished already: 2 chunks in")


def test_sweep_of_a_changed_file_runs_the_new_claim(tmp_path):
    for number, (body, outcome) in enumerate((("return True", "holds"), ("return False", "fails"))):
        path, place = own_file(tmp_path, body), str(tmp_path / f"{number}.sqlite")
        sweep(plan_sweep(path, (3, 4), 10, 0, 5), place)
        with store.read(place) as opened:
            assert total(opened.chunks()).outcomes[outcome] == 10


def test_a_worker_that_dies_takes_nothing_with_it(tmp_path):
    path = own_file(
        tmp_path,
        "if len(planes) == 4 and not MARK.exists():",
        "    MARK.touch()",
        "    os.kill(os.getpid(), 9)",
        "return True",
    )
    plan = plan_sweep(path, (3, 4), 24, 0, 3)
    sweep(plan, str(tmp_path / "s.sqlite"), jobs=2)
    assert (tmp_path / "mine.mark").exists()
    with store.read(str(tmp_path / "s.sqlite")) as opened:
        assert total(opened.chunks()).outcomes["holds"] == 24


def test_workers_that_always_die_end_the_sweep_with_a_message(tmp_path, monkeypatch):
    monkeypatch.setattr(workers, "_MOST_DEATHS", 0)
    path = own_file(tmp_path, "os.kill(os.getpid(), 9)")
    with pytest.raises(WorkerError, match="workers died"):
        sweep(plan_sweep(path, (3, 4), 4, 0, 1), str(tmp_path / "s.sqlite"), jobs=2)


def test_files_that_are_no_stores_are_refused(tmp_path):
    text, other = tmp_path / "a.txt", tmp_path / "other.sqlite"
    text.write_text("something else " * 100, encoding="utf-8")
    with closing(sqlite3.connect(other)) as connection, connection:
        connection.execute("CREATE TABLE mine (x)")
    for path in (text, other):
        before = path.read_bytes()
        for use in (store.read, lambda p: store.create(p, small_plan(), {})):
            with pytest.raises(SweepError):
                use(str(path))
        assert path.read_bytes() == before
    plan = small_plan()
    sweep(plan, str(tmp_path / "s.sqlite"))
    with pytest.raises(SweepError, match="another sweep"):
        sweep(small_plan(seed=1), str(tmp_path / "s.sqlite"))


def test_status_says_how_far_it_is(tmp_path, run):
    path = str(tmp_path / "s.sqlite")
    options = ["--elements", "2..3", "--samples", "20", "--chunk", "5", "--store", path]
    run("sweep", CLAIM, *options, "--shard", "1/2")
    found = run.json("sweep --store {} --status", path, code=1)
    assert (found["chunks"], found["chunks_due"], found["samples"]) == (2, 4, 10)
    run("sweep", CLAIM, *options)
    assert "20 of 20" in run("sweep --store {} --status", path)


@pytest.mark.parametrize("missing", ["joblib", "distributed"])
def test_without_the_extra_the_message_names_it(tmp_path, monkeypatch, refused, missing):
    monkeypatch.setitem(sys.modules, missing, None)
    options = ["--elements", "2..3", "--samples", "9", "--store", str(tmp_path / "s.sqlite")]
    error = refused("sweep", CLAIM, *options, "--dask", "tcp://127.0.0.1:1")
    assert "pip install dask distributed joblib" in error


def test_classes_of_a_claim_on_lines_are_refused_with_the_remedy(tmp_path):
    path = tmp_path / "lines.py"
    path.write_text(
        "from proofs_check import claim\n\n"
        '@claim("A claim.", of="affine(d=2)")\n'
        "def few(lines):\n    return True\n"
    )
    with pytest.raises(SweepError, match=r"--classes is 3\.\.8 for .*run with --classes"):
        plan_sweep(str(path), (3, 8), None)
