"""The store of a sweep: one SQLite file that survives every way of being interrupted.

Work is split in numbered chunks. The result of a chunk is written in one transaction under its
number, so that a chunk is there whole or not at all, and never twice. The file is in WAL mode:
others can read it while it is being written.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proofs_check.errors import DamagedStoreError, SweepError

#: Marks the file as a store of this kind ("SLPS"), and its layout.
APPLICATION = 0x534C5053
LAYOUT = 1
_TABLES = (
    "CREATE TABLE plan (record TEXT NOT NULL, claim TEXT NOT NULL)",
    "CREATE TABLE environments (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE)",
    "CREATE TABLE chunks (number INTEGER PRIMARY KEY, environment INTEGER NOT NULL, "
    "milliseconds INTEGER NOT NULL, result TEXT NOT NULL)",
    f"PRAGMA application_id = {APPLICATION}",
    f"PRAGMA user_version = {LAYOUT}",
)


_CHUNKS = (
    "SELECT number, result, record, milliseconds FROM chunks "
    "JOIN environments ON environments.id = chunks.environment"
)


@dataclass(frozen=True)
class Chunk:
    """The result of one chunk, with what it was found and how long it took."""

    number: int
    result: Mapping[str, Any]
    environment: Mapping[str, Any]
    milliseconds: int


def _chunk(row: tuple[int, str, str, int]) -> Chunk:
    number, result, environment, milliseconds = row
    return Chunk(number, json.loads(result), json.loads(environment), milliseconds)


class Store:
    """An open store; close it, or use it in a ``with`` statement."""

    def __init__(self, path: str, connection: sqlite3.Connection) -> None:
        self.path = path
        self._connection = connection

    def __enter__(self) -> Store:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the file."""
        self._connection.close()

    @property
    def plan(self) -> dict[str, Any]:
        """The record of the plan that the chunks belong to."""
        return self._document("record")

    @property
    def claim(self) -> dict[str, Any]:
        """What the claim says, so that a report needs nothing but the store."""
        return self._document("claim")

    def _document(self, column: str) -> dict[str, Any]:
        remedy = "nothing of it can be saved without its plan; begin a new store"
        with self._undamaged(remedy):
            (text,) = self._connection.execute(f"SELECT {column} FROM plan").fetchone()
            found: dict[str, Any] = json.loads(text)
        return found

    @contextmanager
    def _undamaged(self, remedy: str = "") -> Iterator[None]:
        """Say that the file is damaged, and what to do, when what is in it cannot be read."""
        remedy = remedy or (
            f"proofs-check merge NEW.sqlite {self.path} saves what can be read, and a sweep with "
            "--store NEW.sqlite does the rest"
        )
        try:
            yield
        except (sqlite3.Error, ValueError, TypeError) as error:
            raise DamagedStoreError(f"{self.path} is damaged ({error}); {remedy}") from None

    def numbers(self) -> set[int]:
        """Return the numbers of the chunks that are there."""
        with self._undamaged():
            return {row[0] for row in self._connection.execute("SELECT number FROM chunks")}

    def chunks(self) -> Iterator[Chunk]:
        """Yield every chunk in order of number, as of one moment.

        Raises:
            DamagedStoreError: some cannot be read.
        """
        with self._undamaged():
            for row in self._connection.execute(f"{_CHUNKS} ORDER BY number"):
                yield _chunk(row)

    def readable(self, due: int) -> Iterator[Chunk]:
        """Yield the chunks that can be read, of the first `due` ones, each on its own."""
        for number in range(due):
            with suppress(sqlite3.Error, ValueError, TypeError):
                query = self._connection.execute(f"{_CHUNKS} WHERE number = ?", (number,))
                yield from map(_chunk, query.fetchall())

    def add(self, chunk: Chunk) -> bool:
        """Write a chunk, whole and safely on the disk; return whether it was new.

        Raises:
            SweepError: another result is there under this number, or the file cannot be written.
        """
        result, environment = _text(chunk.result), _text(chunk.environment)
        try:
            with self._connection as transaction:
                transaction.execute("BEGIN IMMEDIATE")
                old = transaction.execute(
                    "SELECT result FROM chunks WHERE number = ?", (chunk.number,)
                ).fetchone()
                if old is not None:
                    self._compare(chunk.number, old[0], result)
                    return False
                transaction.execute(
                    "INSERT OR IGNORE INTO environments (record) VALUES (?)", (environment,)
                )
                transaction.execute(
                    "INSERT INTO chunks SELECT ?, id, ?, ? FROM environments WHERE record = ?",
                    (chunk.number, chunk.milliseconds, result, environment),
                )
        except sqlite3.Error as error:
            raise SweepError(f"cannot write {self.path}: {error}") from None
        return True

    def _compare(self, number: int, old: str, new: str) -> None:
        if old != new:
            raise SweepError(
                f"chunk {number} of {self.path} has another result already; the same chunk gives "
                "the same result, unless the program or a library changed: begin a new store"
            )


def create(path: str, plan: Mapping[str, Any], claim: Mapping[str, Any]) -> Store:
    """Open the store of a plan for writing; make it when there is none.

    Args:
        plan: must equal that of an existing store.
        claim: what the claim says, kept in a new store.

    Raises:
        SweepError: the file is no store, belongs to another plan, or cannot be written.
    """
    if path in ("", ":memory:"):
        raise SweepError(f"the store is {path!r}, which is no file; name one")
    with _opened(path, path) as connection:
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            _checked(path, connection)
        connection.execute("PRAGMA journal_mode = WAL")
        connection.execute("PRAGMA synchronous = FULL")
        _fill(connection, plan, claim)
        store = _checked(path, connection)
        _compare_plans(path, store.plan, plan)
        return store


def read(path: str) -> Store:
    """Open an existing store for reading, also while it is being written.

    Raises:
        SweepError: there is no such file, or it is no store.
    """
    if not Path(path).is_file():
        raise SweepError(f"there is no store {path}; proofs-check sweep makes one")
    with _opened(path, f"{Path(path).resolve().as_uri()}?mode=ro") as connection:
        return _checked(path, connection)


@contextmanager
def _opened(path: str, place: str) -> Iterator[sqlite3.Connection]:
    """Connect to a file; close it when what is done with it fails."""
    try:
        connection = sqlite3.connect(place, timeout=60, isolation_level=None, uri=place != path)
    except sqlite3.Error as error:
        raise SweepError(f"cannot open {path}: {error}") from None
    try:
        yield connection
    except BaseException as error:
        connection.close()
        if isinstance(error, sqlite3.Error):
            raise SweepError(f"cannot use {path} as a store: {error}") from None
        raise


def _fill(
    connection: sqlite3.Connection, plan: Mapping[str, Any], claim: Mapping[str, Any]
) -> None:
    """Make the tables of a new file, all in one transaction."""
    with connection:
        connection.execute("BEGIN IMMEDIATE")
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            return
        for statement in _TABLES:
            connection.execute(statement)
        connection.execute("INSERT INTO plan VALUES (?, ?)", (_text(plan), _text(claim)))


def _checked(path: str, connection: sqlite3.Connection) -> Store:
    application = connection.execute("PRAGMA application_id").fetchone()[0]
    layout = connection.execute("PRAGMA user_version").fetchone()[0]
    if application != APPLICATION or layout != LAYOUT:
        raise SweepError(
            f"{path} is not a store of a sweep (or of another version); name another file"
        )
    return Store(path, connection)


def _compare_plans(path: str, old: Mapping[str, Any], new: Mapping[str, Any]) -> None:
    different = [key for key in new if old.get(key) != new[key]]
    if different:
        listed = ", ".join(f"{key} {old.get(key)!r}, not {new[key]!r}" for key in different)
        raise SweepError(f"{path} belongs to another sweep ({listed}); name another --store")


def _text(record: Mapping[str, Any]) -> str:
    return json.dumps(record, sort_keys=True, separators=(",", ":"))
