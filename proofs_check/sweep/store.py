"""The plan of a sweep, and its store: one SQLite file that survives every interruption.

Work is split in numbered chunks. The result of a chunk is written in one transaction under its
number, so that a chunk is there whole or not at all, and never twice. The file is in WAL mode:
others can read it while it is being written.

The plan and each chunk have a checksum. It finds what something else changed in the file; who
works out new checksums as well is not found.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from hashlib import sha256
from pathlib import Path
from typing import Any

from proofs_check.errors import DamagedStoreError, SweepError

#: Instances in a chunk, unless another number is given.
CHUNK = 200
#: Most samples of one sweep.
MOST = 10**9


@dataclass(frozen=True)
class Plan:
    """What a sweep is to do. Equal plans give equal results.

    Attributes:
        claim: its id.
        digest: SHA-256 of the file of an own claim, "" for the registry.
        low, high: smallest and largest number of planes (or contacts).
        samples: number of instances.
        seed: of all of them.
        chunk: instances in one chunk.
        types: the instances are all types of the census, not random ones.
        source: the name under which the claim is found here: ID, or FILE.py:ID.
    """

    claim: str
    digest: str
    low: int
    high: int
    samples: int
    seed: int
    chunk: int = CHUNK
    types: bool = False
    source: str = field(default="", compare=False)

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return -(-self.samples // self.chunk)

    def indices(self, number: int) -> range:
        """Return the numbers of the instances of one chunk."""
        start = number * self.chunk
        return range(start, min(start + self.chunk, self.samples))

    def record(self) -> dict[str, Any]:
        """Return the plan for JSON; where the claim is found is not part of it."""
        entries = asdict(self)
        del entries["source"]
        if not self.types:
            del entries["types"]
        return entries

    @classmethod
    def from_record(cls, record: Mapping[str, Any]) -> Plan:
        """Return the plan that has a record.

        Raises:
            TypeError, ValueError: no plan has it.
        """
        plan = cls(**record)
        if not all(isinstance(getattr(plan, name), str) for name in ("claim", "digest")):
            raise ValueError("its plan names no claim")
        numbers = (plan.samples, plan.chunk, plan.low, plan.high, plan.seed)
        if not all(type(n) is int for n in numbers) or min(numbers[:2]) < 1:
            raise ValueError("its plan has no number of samples")
        return plan


#: Marks the file as a store of this kind ("SLPS"), and its layout.
APPLICATION = 0x534C5053
LAYOUT = 2
_TABLES = (
    "CREATE TABLE plan (record TEXT NOT NULL, claim TEXT NOT NULL, checksum TEXT NOT NULL)",
    "CREATE TABLE environments (id INTEGER PRIMARY KEY, record TEXT NOT NULL UNIQUE)",
    "CREATE TABLE chunks (number INTEGER PRIMARY KEY, environment INTEGER NOT NULL, "
    "milliseconds INTEGER NOT NULL, result TEXT NOT NULL, checksum TEXT NOT NULL)",
    f"PRAGMA application_id = {APPLICATION}",
    f"PRAGMA user_version = {LAYOUT}",
)
#: Blobs can be read whatever is in them.
_CHUNKS = (
    "SELECT CASE typeof(number) WHEN 'integer' THEN number ELSE -1 END, "
    "CAST(milliseconds AS BLOB), CAST(record AS BLOB), CAST(result AS BLOB), "
    "CAST(checksum AS BLOB) "
    "FROM chunks LEFT JOIN environments ON environments.id = chunks.environment"
)
#: Primary codes of the errors that a journal which cannot be made or written causes.
_UNOPENED = (sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_READONLY)
#: Bytes of a cell; SQLite refuses larger ones without reading them.
_MAX_CELL = 1 << 26
#: Where the table cannot be read in order, this many numbers are looked up one by one.
_LOOKED_UP = 1_000_000
#: Damaged chunks that a message names.
_NAMED = 8


@dataclass(frozen=True)
class Chunk:
    """The result of one chunk, with what it was found and how long it took."""

    number: int
    result: Mapping[str, Any]
    environment: Mapping[str, Any]
    milliseconds: int

    def of(self, plan: Plan) -> bool:
        """Return whether it has a number of the plan, and counts the instances of this number."""
        rows = self.result["counts"].values()
        samples = sum(map(sum, rows))
        return 0 <= self.number < plan.chunks and samples == len(plan.indices(self.number))


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
    def plan(self) -> Plan:
        """The plan that the chunks belong to."""
        with self._reporting_damage():
            return Plan.from_record(json.loads(self._plan()[0]))

    @property
    def claim(self) -> dict[str, Any]:
        """What the claim says, so that a report needs nothing but the store."""
        with self._reporting_damage():
            record: dict[str, Any] = json.loads(self._plan()[1])
        return record

    def _plan(self) -> tuple[bytes, bytes]:
        """Return the texts of the plan and of what the claim says."""
        columns = ", ".join(f"CAST({name} AS BLOB)" for name in ("record", "claim", "checksum"))
        rows = self._connection.execute(f"SELECT {columns} FROM plan").fetchall()
        if len(rows) != 1:
            raise ValueError(f"it has {len(rows)} plans, not one")
        *texts, checksum = rows[0]
        if checksum != _checksum(*texts).encode():
            raise ValueError("its plan is not as a sweep wrote it")
        record, claim = texts
        return record, claim

    @contextmanager
    def _reporting_damage(self) -> Iterator[None]:
        """Report a damaged plan when it cannot be read."""
        try:
            yield
        except (sqlite3.Error, ValueError, TypeError) as error:
            remedy = "Nothing of it can be saved without its plan; begin a new store"
            raise DamagedStoreError(f"{self.path} is damaged ({error})", remedy) from None

    def chunks(self) -> Iterator[Chunk]:
        """Yield every intact chunk in order of number, as of one moment.

        Raises:
            DamagedStoreError: at the end, if there are others.
        """
        plan, last = self.plan, -1
        damaged, errors = list[int](), list[sqlite3.Error]()
        for number, *cells in self._rows(plan.chunks, errors):
            chunk = _chunk(plan, number, *cells)
            if chunk and number > last:
                last = number
                yield chunk
            else:
                damaged.append(number)
        if damaged or errors:
            what = [f"{_numbers_text(damaged)} not as written"] if damaged else []
            remedy = (
                f"proofs-check sweep --store NEW.sqlite --merge {self.path} saves the others, "
                "and a sweep with --store NEW.sqlite computes the rest"
            )
            text = ", ".join([*map(str, errors), *what])
            raise DamagedStoreError(f"{self.path} is damaged ({text})", remedy)

    def _rows(self, due: int, errors: list[sqlite3.Error]) -> Iterator[tuple[Any, ...]]:
        """Yield the rows of all chunks; of one that cannot be read, the number and None."""
        last = -1
        try:
            for row in self._connection.execute(f"{_CHUNKS} ORDER BY number"):
                last = row[0]
                yield row
        except sqlite3.Error as error:
            errors.append(error)
            for number in range(last + 1, min(due, last + 1 + _LOOKED_UP)):
                try:
                    yield from self._connection.execute(f"{_CHUNKS} WHERE number = ?", (number,))
                except sqlite3.Error:
                    yield number, None

    def add(self, chunk: Chunk, part: str = "") -> bool:
        """Write a chunk, whole and safely on the disk; return whether it was new.

        Args:
            chunk: what is written.
            part: the store that it is from, if it is merged.

        Raises:
            SweepError: another result is there under this number, or the file cannot be written.
        """
        result, environment = _text(chunk.result), _text(chunk.environment)
        cells = (chunk.milliseconds, environment, result)
        checksum = _checksum(_text(self.plan.record()), chunk.number, *cells)
        try:
            with self._connection as transaction:
                transaction.execute("BEGIN IMMEDIATE")
                old = transaction.execute(
                    "SELECT result FROM chunks WHERE number = ?", (chunk.number,)
                ).fetchone()
                if old is not None:
                    self._compare(chunk.number, old[0], result, part)
                    return False
                transaction.execute(
                    "INSERT OR IGNORE INTO environments (record) VALUES (?)", (environment,)
                )
                transaction.execute(
                    "INSERT INTO chunks SELECT ?, id, ?, ?, ? FROM environments WHERE record = ?",
                    (chunk.number, chunk.milliseconds, result, checksum, environment),
                )
        except sqlite3.Error as error:
            raise SweepError(f"cannot write {self.path}: {error}") from None
        return True

    def _compare(self, number: int, old: str, new: str, part: str) -> None:
        if old != new:
            mistake = (
                f"chunk {number} of {part} has another result than that of {self.path}"
                if part
                else f"chunk {number} of {self.path} has another result already"
            )
            raise SweepError(
                f"{mistake}; the same chunk gives the same result, unless the program or a library "
                "changed: begin a new store"
            )


def create(path: str, plan: Plan, claim: Mapping[str, Any], part: str = "") -> Store:
    """Open the store of a plan for writing; make it when there is none.

    Args:
        plan: must equal that of an existing store.
        claim: what the claim says, kept in a new store.
        part: the store that plan and claim are from, if it is merged.

    Raises:
        SweepError: the file is not a store, belongs to another plan, or cannot be written.
    """
    if path in ("", ":memory:"):
        raise SweepError(f"the store is {path!r}, which is not a file; name one")
    with _connect(path, path) as connection:
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            _checked_store(path, connection)
        connection.execute("PRAGMA journal_mode = WAL")
        connection.execute("PRAGMA synchronous = FULL")
        _fill(connection, plan, claim)
        store = _checked_store(path, connection)
        if differences := _differences(store, plan, claim, merged=bool(part)):
            which = f"{part or path} belongs to another sweep" + (f" than {path}" if part else "")
            raise SweepError(f"{which} ({', '.join(differences)}); name another --store")
        return store


def read(path: str) -> Store:
    """Open an existing store for reading, also while it is being written, or on read-only media.

    Raises:
        SweepError: there is no such file, or it is not a store.
    """
    if not Path(path).is_file():
        raise SweepError(f"there is no store {path}; proofs-check sweep makes one")
    place = f"{Path(path).resolve().as_uri()}?mode=ro"
    try:
        with _connect(path, place) as connection:
            return _checked_store(path, connection)
    except _UnopenedError:
        # No journal can be made beside it. Without one nobody writes, and it is whole as it is.
        journal = Path(f"{path}-wal")
        if journal.is_file() and journal.stat().st_size:
            raise SweepError(
                f"{path} has a journal that cannot be read here; copy both to a disk that can be "
                "written"
            ) from None
    with _connect(path, f"{place}&immutable=1") as connection:
        return _checked_store(path, connection)


class _UnopenedError(SweepError):
    """The file is there, and SQLite cannot open it or its journal."""


@contextmanager
def _connect(path: str, place: str) -> Iterator[sqlite3.Connection]:
    """Connect to a file; close it when what is done with it fails."""
    try:
        connection = sqlite3.connect(place, timeout=60, isolation_level=None, uri=place != path)
    except sqlite3.Error as error:
        raise SweepError(f"cannot open {path}: {error}") from None
    connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _MAX_CELL)
    try:
        yield connection
    except BaseException as error:
        connection.close()
        if isinstance(error, sqlite3.Error):
            unopened = getattr(error, "sqlite_errorcode", 0) & 0xFF in _UNOPENED
            kind = _UnopenedError if unopened else SweepError
            raise kind(f"cannot use {path} as a store: {error}") from None
        raise


def _fill(connection: sqlite3.Connection, plan: Plan, claim: Mapping[str, Any]) -> None:
    """Make the tables of a new file, all in one transaction."""
    with connection:
        connection.execute("BEGIN IMMEDIATE")
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            return
        for statement in _TABLES:
            connection.execute(statement)
        texts = (_text(plan.record()), _text(claim))
        connection.execute("INSERT INTO plan VALUES (?, ?, ?)", (*texts, _checksum(*texts)))


def _checked_store(path: str, connection: sqlite3.Connection) -> Store:
    application = connection.execute("PRAGMA application_id").fetchone()[0]
    layout = connection.execute("PRAGMA user_version").fetchone()[0]
    if application != APPLICATION:
        raise SweepError(f"{path} is not a store of a sweep; name another file")
    if layout != LAYOUT:
        raise SweepError(
            f"{path} has layout {layout}; expected {LAYOUT}, with a checksum for each chunk. "
            "Begin a new store: what another version wrote cannot be checked"
        )
    return Store(path, connection)


def _differences(store: Store, plan: Plan, claim: Mapping[str, Any], *, merged: bool) -> list[str]:
    """Return in words what of a plan differs from that of a store; of one that is merged, first."""
    plans = (store.plan.record(), plan.record())
    files = (store.claim.get("files", {}), claim.get("files", {}))
    if merged:
        plans, files = plans[::-1], files[::-1]
    (one, other), differences = plans, list[str]()
    for key in {**one, **other}:
        if one.get(key) == other.get(key):
            continue
        if key != "digest":
            differences.append(f"{key} {one.get(key)!r}, not {other.get(key)!r}")
            continue
        names = {**files[0], **files[1]}
        changed = [name for name in names if files[0].get(name) != files[1].get(name)]
        what = ", ".join(changed) or "the file of the claim, or one that it imports,"
        differences.append(f"{what} {'differs' if merged else 'has changed since'}")
    return differences


def _text(record: Mapping[str, Any]) -> str:
    return json.dumps(record, sort_keys=True, separators=(",", ":"))


def _checksum(*cells: str | int | bytes) -> str:
    """Return the SHA-256 of cells of a row in hexadecimal; no cell has a line break."""
    texts = (cell if isinstance(cell, bytes) else str(cell).encode() for cell in cells)
    return sha256(b"\n".join(texts)).hexdigest()


def _chunk(plan: Plan, number: int, *cells: Any) -> Chunk | None:
    """Return the chunk in a row, or None if it is not one that a sweep wrote."""
    *texts, checksum = cells
    if None in cells or checksum != _checksum(_text(plan.record()), number, *texts).encode():
        return None
    milliseconds, environment, result = map(json.loads, texts)
    chunk = Chunk(number, result, environment, milliseconds)
    try:
        return chunk if chunk.of(plan) else None
    except (AttributeError, KeyError, TypeError):
        return None


def _numbers_text(numbers: list[int]) -> str:
    shown = ", ".join(map(str, numbers[:_NAMED]))
    more = f" and {len(numbers) - _NAMED} more" if len(numbers) > _NAMED else ""
    return f"{'chunk' if len(numbers) == 1 else 'chunks'} {shown}{more}"
