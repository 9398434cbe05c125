"""Stores of sweeps: what something else changed in the file is found, named and computed again."""

import io
import json
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, redirect_stderr, redirect_stdout
from itertools import cycle
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given, strategies as st

from proofs_check.cli.program import main
from proofs_check.errors import DamagedStoreError
from proofs_check.sweep import store
from proofs_check.sweep.store import Plan
from proofs_check.sweep.sweep import merge, sweep

from .test_sweep import CLAIM, report, small_plan

PLAN = small_plan(60, 10)
SWEEP = [*("sweep", CLAIM, "--elements", "1..4"), *("--samples", "60", "--chunk", "10")]
COLUMNS = [
    *(("plan", name) for name in ("record", "claim", "checksum")),
    *(("environments", name) for name in ("id", "record")),
    *(("chunks", name) for name in ("number", "environment", "milliseconds", "result", "checksum")),
]
#: Null, other types, other JSON shapes, numbers of any size, what is not a text.
VALUES: list[Any] = [
    *(None, 0, 1, 7, 99, -1, 2.5, 2**62, 1e300, b"", b"\xff\xfe", b"{}", "", "x", "[]", "{}", "3"),
    *("null", '{"counts":{}}', '{"counts":[],"smallest":[]}', "1" * 5000, "[" * 5000),
]


@pytest.mark.parametrize(
    "change",
    [{"claim": 1}, {"samples": 0}, {"samples": 1.0}, {"chunk": 0}, {"low": "3"}, {"seed": None}],
)
def test_record_without_a_plan_is_refused(change):
    least = Plan(claim=CLAIM, digest="", low=0, high=4, samples=1, seed=0, chunk=1)
    assert Plan.from_record(least.record()) == least
    with pytest.raises(ValueError, match="its plan"):
        Plan.from_record(least.record() | change)


def test_chunk_of_a_plan_has_its_number_and_all_its_samples():
    plan = Plan(claim=CLAIM, digest="", low=3, high=4, samples=5, seed=0, chunk=3)
    asked = [(0, 3), (0, 2), (1, 2), (1, 3), (2, 0), (-1, 3)]
    chunks = [store.Chunk(n, {"counts": {"3": [k, 0], "4": [0, 0]}}, {}, 0) for n, k in asked]
    assert [chunk.of(plan) for chunk in chunks] == [True, False, True, False, False, False]


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A complete store, all of it in one file."""
    path = tmp_path_factory.mktemp("whole") / "s.sqlite"
    sweep(PLAN, str(path))
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA journal_mode = DELETE")
    return path


@pytest.fixture
def changed(whole: Path, tmp_path: Path) -> Iterator[Any]:
    """Run SQL on a copy of a complete store."""
    path = tmp_path / "s.sqlite"
    shutil.copy(whole, path)

    def change(*statements: str) -> Path:
        with closing(sqlite3.connect(path)) as connection, connection:
            for statement in statements:
                connection.execute(statement)
        return path

    return change


def run(*words: object) -> tuple[int, str, str]:
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        code = main([str(word) for word in words])
    return code, out.getvalue(), err.getvalue()


def commands(path: Path) -> Iterator[tuple[int, str, str]]:
    """Run each command that reads a store."""
    new = path.with_suffix(".new")
    new.unlink(missing_ok=True)
    yield run("sweep", "--store", path, "--status")
    yield run("report", path)
    yield run("sweep", "--store", new, "--merge", path)
    yield run("sweep", "--store", path, "--merge", path)
    yield run(*SWEEP, "--store", path)


def answers(whole: Path) -> list[str]:
    """Return what the commands print on an undamaged store."""
    path = whole.with_name("good.sqlite")
    shutil.copy(whole, path)
    return [out for _, out, _ in commands(path)]


@pytest.mark.parametrize(
    ("statement", "damaged"),
    [
        ("UPDATE chunks SET number = 99 WHERE number = 3", "chunk 99 not"),
        ("UPDATE chunks SET number = -1 WHERE number = 3", "chunk -1 not"),
        ("UPDATE chunks SET result = replace(result, '3', '7') WHERE number = 4", "chunk 4 not"),
        ("UPDATE chunks SET result = substr(result, 2) WHERE number = 1", "chunk 1 not"),
        ("UPDATE chunks SET result = (SELECT result FROM chunks) WHERE number = 2", "chunk 2 not"),
        ("UPDATE chunks SET milliseconds = 1000000", "chunks 0, 1, 2, 3, 4, 5 not"),
        ("UPDATE environments SET record = '{}'", "chunks 0, 1, 2, 3, 4, 5 not"),
        ("DELETE FROM environments", "chunks 0, 1, 2, 3, 4, 5 not"),
        ("UPDATE plan SET record = replace(record, '60', '50')", "its plan is not"),
        ("UPDATE plan SET claim = replace(claim, 'holds', 'fails')", "its plan is not"),
        ("DELETE FROM plan", "it has 0 plans, not one"),
        ("UPDATE chunks SET result = zeroblob(70000000) WHERE number = 1", "big, chunk 1 not"),
        ("UPDATE plan SET record = zeroblob(70000000)", "string or blob too big"),
        ("DROP TABLE chunks", "no such table: chunks, chunks 0, 1, 2, 3, 4, 5 not"),
    ],
)
def test_every_command_names_what_is_damaged(changed, statement, damaged):
    path = changed(statement)
    for code, out, err in commands(path):
        assert (code, out) == (2, "")
        assert err.startswith(f"error: {path} is damaged (")
        assert damaged in err
        assert err.count("\n") == 1


def test_damage_of_many_chunks_is_told_in_short(tmp_path):
    path = tmp_path / "s.sqlite"
    sweep(small_plan(60, 3), str(path))
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("UPDATE chunks SET result = '{}'")
    assert (
        "(chunks 0, 1, 2, 3, 4, 5, 6, 7 and 12 more not as written)"
        in run("sweep", "--store", path, "--status")[2]
    )


def test_what_is_intact_is_saved_and_the_rest_computed_again(changed, whole, tmp_path):
    path, new = changed("UPDATE chunks SET number = 99 WHERE number = 3"), tmp_path / "new.sqlite"
    with pytest.raises(DamagedStoreError, match=r"--store .*new.sqlite computes the rest"):
        merge(str(new), [str(path)])
    assert run("sweep", "--store", new, "--status")[1].splitlines()[1] == "chunks   5 of 6"
    seen: list[tuple[int, int]] = []
    sweep(PLAN, str(new), progress=lambda done, due: seen.append((done, due)))
    assert seen == [(50, 60), (60, 60)]
    assert report(new) == report(whole)


def test_a_chunk_that_is_gone_is_missing(changed, whole):
    path = changed("DELETE FROM chunks WHERE number = 3")
    assert run("sweep", "--store", path, "--status")[:2][0] == 1
    sweep(PLAN, str(path))
    assert report(path) == report(whole)


def test_good_stores_are_merged_beside_a_damaged_one(changed, whole, tmp_path):
    path, new = changed("UPDATE chunks SET result = '[]' WHERE number = 3"), tmp_path / "new.sqlite"
    code, _, err = run("sweep", "--store", new, "--merge", path, whole)
    assert (code, str(path) in err) == (2, True)
    assert report(new) == report(whole)


def test_counts_outside_the_plan_are_found(changed):
    path = changed()
    with store.read(str(path)) as opened:
        record, (chunk, *_) = opened.plan.record(), opened.chunks()
    for result in (
        *([], {}, {"counts": [], "smallest": {}}, {"counts": {"3": 5}, "smallest": {}}),
        4,
    ):
        cells = (chunk.milliseconds, store._text(chunk.environment), json.dumps(result))
        checksum = store._checksum(store._text(record), 0, *cells)
        with closing(sqlite3.connect(path)) as connection, connection:
            change = "UPDATE chunks SET result = ?, checksum = ? WHERE number = 0"
            connection.execute(change, (cells[2], checksum))
        assert "chunk 0 not as written" in run("sweep", "--store", path, "--status")[2]


def test_a_store_without_checksums_is_refused(changed):
    path = changed("PRAGMA user_version = 1", "ALTER TABLE chunks DROP COLUMN checksum")
    for code, out, err in commands(path):
        assert (code, out) == (2, "")
        assert "has layout 1; expected 2, with a checksum for each chunk. Begin a new store" in err


def test_a_shard_without_chunks_has_nothing_to_do(tmp_path):
    path = tmp_path / "s.sqlite"
    code, out, err = run(*SWEEP, "--store", path, "--shard", "7/9")
    assert (code, out, err) == (0, "shard 7/9 has nothing to do: the sweep has 6 chunks\n", "")
    code, out, _ = run(*SWEEP, "--store", path, "--shard", "7/9", "--json")
    assert (code, json.loads(out)["results"][0]["complete"]) == (0, False)
    assert run("sweep", "--store", path, "--status")[0] == 1


@pytest.mark.parametrize("first", [100, 4096, 8192, 12288])
def test_an_overwritten_store_ends_with_one_error(first, whole, tmp_path):
    path = tmp_path / "s.sqlite"
    content = bytearray(whole.read_bytes())
    content[first : first + 3000] = b"\xff" * len(content[first : first + 3000])
    path.write_bytes(content)
    good = answers(whole)
    for code, out, err in commands(path):
        check(code, out, err, good)


def check(code: int, out: str, err: str, good: list[str]) -> None:
    """Check that a command refuses in one line, or says what is true of the undamaged store."""
    assert code in (0, 1, 2), err
    if code == 2:
        assert (out, err.count("\n"), err[:7]) == ("", 1, "error: "), err
        assert len(err) < 1000, err
    else:
        assert (out in good, err) == (code == 0, ""), out + err


def replaced(path: Path, table: str, column: str, row: int, value: Any) -> bool:
    """Put a value in a cell, in a table that takes any; return whether it is another one."""
    with closing(sqlite3.connect(path)) as connection, connection:
        names = [x[1] for x in connection.execute(f"PRAGMA table_info({table})")]
        rows = [list(x) for x in connection.execute(f"SELECT * FROM {table}")]
        place = names.index(column)
        if isinstance(value, tuple):  # another row's value
            value = rows[value[0] % len(rows)][place]
        old = rows[row % len(rows)][place]
        rows[row % len(rows)][place] = value
        connection.execute(f"DROP TABLE {table}")
        connection.execute(f"CREATE TABLE {table} ({', '.join(names)})")
        marks = ", ".join("?" * len(names))
        connection.executemany(f"INSERT INTO {table} VALUES ({marks})", rows)
    return (type(old), old) != (type(value), value)


def never_believed(whole: Path, place: tuple[str, str], row: int, value: Any) -> None:
    path = whole.with_name("changed.sqlite")
    shutil.copy(whole, path)
    if not replaced(path, *place, row, value):
        return
    codes = []
    for code, out, err in commands(path):
        check(code, out, err, [])
        codes.append(code)
    assert codes == [2] * 5
    path.with_suffix(".new").unlink(missing_ok=True)


@given(
    st.sampled_from(COLUMNS),
    st.integers(0, 5),
    st.sampled_from(VALUES) | st.tuples(st.integers(0, 5)),
)
@example(("chunks", "number"), 0, "")
def test_a_changed_cell_is_never_believed(whole, place, row, value):
    never_believed(whole, place, row, value)


@pytest.mark.slow
@pytest.mark.parametrize("place", COLUMNS, ids=".".join)
def test_no_changed_cell_is_believed(whole, place):
    rows = cycle((0, 3) if place[0] == "chunks" else (0,))
    for row, value in zip(rows, (*VALUES, (0,), (3,)), strict=False):
        never_believed(whole, place, row, value)


def test_a_finished_store_on_read_only_media_is_read(whole, tmp_path, monkeypatch):
    path = tmp_path / "kept.sqlite"
    sweep(PLAN, str(path))
    journal = tmp_path / "kept.sqlite-wal"
    journal.unlink(missing_ok=True)
    journal.mkdir()  # so that no journal can be made, whoever runs the test
    code, status, _ = run("sweep", "--store", path, "--status")
    assert code == 0
    assert "chunks   6 of 6" in status
    assert run("report", path)[1] == run("report", whole)[1]
    assert run(*SWEEP, "--store", path)[:2] == run(*SWEEP, "--store", whole)[:2]
    journal.rmdir()
    journal.write_bytes(b"what another process has written")

    def unopened(path, place):
        raise store._UnopenedError("unable to open database file")

    monkeypatch.setattr(store, "_connect", unopened)
    code, _, err = run("sweep", "--store", path, "--status")
    assert code == 2
    assert "has a journal that cannot be read here; copy both" in err
