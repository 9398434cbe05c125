"""Whitney numbers of large arrangements, in parts that are files: resumed, shared, spread.

The flats of a rank are split in parts by a hash of what stands for their class; the lower half of
the ranks, which has few, is one part each. A file holds what comes up from one part, split for the
rank after. So a part needs its share of every file of the rank before and nothing else, every class
has one part, and it does not matter which process makes which file, or how often all are stopped.

A folder has the file ``plan.json`` and a folder for each rank. Files appear whole or not at all, so
machines may share a folder of a network without locks; the journal of SQLite, which sweeps use,
does not work there. The files that others made of the same arrangement can be copied to it. What is
in them has a checksum over the plan, the rank, the part and the numbers, so that those of other
planes, parts or ranks are refused; the checksum is not a signature.
"""

from __future__ import annotations

import io
import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from arrangement.console import workers
from arrangement.console.progress import note, watched
from arrangement.console.writing import reason, write_bytes_atomically
from arrangement.counts.configuration import Configuration, configuration
from arrangement.errors import InputError, OutOfTimeError, WaitingError
from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import shown
from arrangement.numbers.real import field_of, written
from arrangement.planes.planes import Planes

from .automorphisms import Automorphisms
from .symmetric import MANY, Classes, Flats, classes

#: Parts of a rank in the upper half. More take less memory each; fewer see more repeats at once.
_PARTS = 64
#: Each part looks into every file of the rank before, which takes longer than counting few flats.
_PARTS_OF_FEW = 8
_MANY_BASES = 50_000
#: A division into more would look for more files than flats.
_MAX_PARTS = 100_000
#: A rank with fewer flats is done in this process.
_FEW = 20_000
_LAYOUT = 2
_FACTOR = np.uint64(0xD6E8FEB86659FD93)
#: Bytes that one byte of an archive can stand for: 1,032 by the format of its compression.
_MAX_EXPANSION = 1100
#: Arrays of a file: what is added up, with how many flats come up to which parts of the rank after,
#: and these flats, for each of the parts.
_SUMS = ("residues", "counts")
_FLATS = ("bases", "members", "images", "values")


def first_whitney_numbers_in_parts(
    arrangement: Planes,
    folder: str | Path,
    *,
    parts: int | None = None,
    jobs: int = 1,
    shard: tuple[int, int] = (1, 1),
    dask: str | None = None,
    time_limit: float | None = None,
) -> tuple[int, ...]:
    """Return what `counts.first_whitney_numbers` does; what is done is kept in a folder.

    Args:
        folder: made when there is none; one with parts of the same arrangement is gone on with.
        parts: of each rank in the upper half, in a new folder; by default 64, and 8 where few
            hyperplanes of low rank have few flats.
        jobs: processes on this machine.
        shard: (i, n): of each rank only every n-th part, beginning with the i-th.
        dask: address of a scheduler; its workers must see the folder under the same path.
        time_limit: in seconds.

    Raises:
        InputError: a bad argument, a folder of other planes or a damaged one, workers that die.
        UnfinishedError: parts of others are missing (`WaitingError`), or the time is over
            (`OutOfTimeError`); its `known` has the numbers that are final.
        MissingExtraError: `dask` is given and not installed.
    """
    deadline = Deadline(time_limit)
    root = str(Path(folder).absolute())
    config = configuration(arrangement)
    if parts is None:
        bases = math.comb(len(config.vectors), max(config.rank - 1, 0))
        parts = _PARTS if bases > _MANY_BASES else max(_PARTS_OF_FEW, shard[1])
    if parts > _MAX_PARTS:
        raise InputError(f"parts is {shown(parts)}; expected at most {_MAX_PARTS:,}")
    if not workers.part_numbers(parts, shard, jobs):
        raise InputError(f"parts is {shown(parts)} and shard {shard}; give a part to each shard")
    _prepare(Path(root), config, parts)
    made = _read_plan(root)

    def residues() -> Iterator[NDArray[np.int64]]:
        flats = 1
        for rank in range(1, made.classes.rank):
            parts = made.parts(rank)
            missing = _missing(root, rank, parts)
            due = workers.part_numbers(parts, shard, jobs) if parts > 1 else range(1)
            todo = [part for part in due if part in missing]
            done = workers.run_parts(
                _run, (root, rank), todo, *((jobs, dask) if flats > _FEW else ())
            )
            for _ in watched(done, f"parts of rank {rank}", len(todo)):
                deadline.check()
            if missing := _missing(root, rank, parts):
                raise _MissingPartsError(
                    f"{parts - len(missing)} of the {parts} parts of rank {rank}"
                )
            files = [_read(root, rank, part) for part in range(parts)]
            flats = sum(int(file["counts"][1].sum()) for file in files)
            yield np.sum([file["residues"] for file in files], axis=0)

    known: list[int] = []
    try:
        with budget.limit(math.inf):  # what is done is kept
            for rank, number in enumerate(made.classes.from_residues(residues())):
                note(f"rank {rank}: Whitney number {number}")
                known.append(number)
    except TimeoutError:
        raise OutOfTimeError(
            f"{deadline}: {_final(known)}; run the same command again to go on",
            tuple(known),
        ) from None
    except _MissingPartsError as error:
        raise WaitingError(
            f"{folder} has {error}, and {_final(known)}; when the other shards are done and their "
            "files are there too, run the same command again",
            tuple(known),
        ) from None
    return tuple(known)


class _MissingPartsError(Exception):
    """Report how many parts there are."""


def _final(known: list[int]) -> str:
    return f"the first Whitney numbers {', '.join(map(str, known))} are final"


def _prepare(root: Path, config: Configuration, parts: int) -> None:
    """Write the plan of a new folder; refuse a folder that has another."""
    plan = root / "plan.json"
    vectors = [list(map(written, v)) for v in config.vectors]
    infinity = config.infinity and list(map(written, config.infinity))
    record: dict[str, Any] = {"layout": _LAYOUT, "rank": config.rank}
    if field := field_of(x for vector in config.vectors for x in vector):
        record["field"] = field.to_dict()
    record |= {"vectors": vectors, "infinity": infinity}
    if not config.rank:
        raise InputError("there are no planes to count in parts")
    search = Automorphisms(config)
    try:
        if not plan.exists():
            for rank in range(1, config.rank):
                _place(str(root), rank, 0).parent.mkdir(parents=True, exist_ok=True)
            record |= {"parts": parts, "generators": search.generators().tolist()}
            content = json.dumps(record)
            write_bytes_atomically(plan, content.encode())
        document = json.loads(plan.read_bytes())
    except (OSError, ValueError) as error:
        raise InputError(f"cannot use the folder {root}: {reason(error)}; name another") from None
    if isinstance(document, dict) and document.get("layout") != _LAYOUT:
        raise InputError(
            f"{plan} has layout {shown(document.get('layout'))}; expected {_LAYOUT}, with "
            "checksums. Name another folder: what another version wrote cannot be checked"
        )
    if not isinstance(document, dict) or any(document.get(key) != record[key] for key in record):
        raise InputError(f"{root} has parts of other planes; name another folder")
    try:  # a file may come from anywhere
        search.check_permutations(document["generators"])
        if type(document["parts"]) is not int or not 1 <= document["parts"] <= _MAX_PARTS:
            raise ValueError(document["parts"])
    except (KeyError, TypeError, ValueError, IndexError):
        raise InputError(
            f"{plan} has other parts or symmetries than planes can have; name another folder"
        ) from None


@dataclass(frozen=True)
class _Plan:
    classes: Classes
    most: int
    plan: bytes

    def parts(self, rank: int) -> int:
        """Return how many parts the flats below a rank have."""
        return self.most if 2 * rank > self.classes.rank else 1


def _read_plan(root: str) -> _Plan:
    """Read the plan of a folder."""
    return _parse_plan((Path(root) / "plan.json").read_bytes())


@lru_cache(maxsize=1)
def _parse_plan(content: bytes) -> _Plan:
    """Parse a plan; the last one is cached, as a process works on many parts of it."""
    plan = json.loads(content)
    field = None
    if "field" in plan:
        from arrangement.numbers.fields import NumberField

        field = NumberField(*plan["field"].values())

    def vector(entries: list[Any]) -> tuple[Any, ...]:
        return tuple(
            field.number(list(map(Fraction, x))) if field and isinstance(x, list) else int(x)
            for x in entries
        )

    vectors = tuple(map(vector, plan["vectors"]))
    infinity = plan["infinity"] and vector(plan["infinity"])
    config = Configuration(vectors, infinity, plan["rank"])
    size = len(vectors) + (infinity is not None)
    generators = np.array(plan["generators"], dtype=np.intp).reshape(-1, size)
    digest = sha256(json.dumps(plan, sort_keys=True).encode()).digest()
    return _Plan(classes(config, generators, Deadline()), plan["parts"], digest)


def _run(plan: tuple[str, int], part: int) -> None:
    """Make the file of one part of a rank."""
    root, rank = plan
    made = _read_plan(root)
    with budget.limit(math.inf):
        higher, residues = made.classes.above(_flats_before(root, rank, part), rank)
    bucket = np.empty(0, dtype=np.uint64)
    if len(higher):
        factors = np.cumprod(np.full(higher.images.shape[1], _FACTOR))
        parts = np.uint64(made.parts(rank + 1))
        bucket = ((higher.images * factors).sum(axis=1) >> np.uint64(32)) % parts
    numbers, sizes = np.unique(bucket, return_counts=True)
    content: dict[str, Any] = {
        "residues": np.asarray(residues),
        "counts": np.array([numbers, sizes], dtype=np.int64),
    }
    content |= _checksum(made.plan, rank, part, content)
    for number in numbers:
        inside = bucket == number
        flats = {
            f"bases-{number}": higher.bases[inside].astype(np.int32),
            f"members-{number}": higher.members[inside],
            f"images-{number}": higher.images[inside],
            f"values-{number}": higher.values[:, inside].astype(np.uint32),
        }
        content |= flats | _checksum(made.plan, rank, part, flats)
    stream = io.BytesIO()
    np.savez_compressed(stream, **content)
    write_bytes_atomically(_place(root, rank, part), stream.getvalue())


def _flats_before(root: str, rank: int, part: int) -> Flats:
    """Return the flats of the rank before, one of each class of this part."""
    made = _read_plan(root)
    if rank == 1:
        return made.classes.bottom()
    gathered, waiting = [made.classes.bottom()[:0]], 0
    for number in range(made.parts(rank - 1)):
        if arrays := _read(root, rank - 1, number, part):
            bases, members, images, values = (arrays[f"{name}-{part}"] for name in _FLATS)
            flats = Flats(bases.astype(np.int64), members, images, values.astype(np.int64))
            gathered = [*gathered, flats] if len(gathered[0]) else [flats]
            waiting += len(flats)
            if waiting > MANY:
                gathered, waiting = [made.classes.merge(Flats.concatenate(gathered))], 0
    together = Flats.concatenate(gathered)
    return made.classes.merge(together) if len(together) else together


def _place(root: str, rank: int, part: int) -> Path:
    return Path(root) / f"rank-{rank:02}" / f"part-{part:02}.npz"


def _missing(root: str, rank: int, parts: int) -> set[int]:
    return {part for part in range(parts) if not _place(root, rank, part).exists()}


def _checksum(
    plan: bytes, rank: int, part: int, arrays: Mapping[str, NDArray[Any]]
) -> dict[str, NDArray[np.uint8]]:
    """Return the SHA-256 of some arrays of a file, under a name of its own."""
    digest = sha256(plan)
    for name, array in arrays.items():
        digest.update(repr((rank, part, name, array.dtype.str, array.shape)).encode())
        digest.update(array.tobytes())
    return {f"checksum-{min(arrays)}": np.frombuffer(digest.digest(), dtype=np.uint8)}


def _array(file: ZipFile, name: str, most: float) -> NDArray[Any]:
    """Return an array of an archive; refuse one whose header has more bytes than can be there."""
    with file.open(f"{name}.npy") as stream:
        npy.read_magic(stream)
        shape, _, dtype = npy.read_array_header_1_0(stream)
        if math.prod(shape) * dtype.itemsize > most:
            raise ValueError(f"its {name} have the shape {shown(shape)}, which is not in it")
        stream.seek(0)
        array: NDArray[Any] = npy.read_array(stream, allow_pickle=False)
        return array


def _read(root: str, rank: int, part: int, above: int | None = None) -> dict[str, NDArray[Any]]:
    """Return what is added up of a file, or the flats that come up to a part of the rank after."""
    place, plan = _place(root, rank, part), _read_plan(root).plan

    def checked(file: ZipFile, *names: str) -> dict[str, NDArray[Any]]:
        arrays = {name: _array(file, name, most) for name in names}
        ((name, checksum),) = _checksum(plan, rank, part, arrays).items()
        if not np.array_equal(_array(file, name, most), checksum):
            raise ValueError(f"it is not part {part} of rank {rank} of these planes, as written")
        return arrays

    try:
        most = _MAX_EXPANSION * place.stat().st_size
        if above is not None and above not in _parts_above(root, plan, rank, part):
            return {}
        with ZipFile(place) as file:
            names = _SUMS if above is None else tuple(f"{name}-{above}" for name in _FLATS)
            return checked(file, *names)
    except (AttributeError, KeyError, TypeError):
        why = "it is not part of a count"
    except Exception as error:
        # zipfile, its decompressors and the parser of NumPy's headers raise errors of many kinds.
        why = reason(error) or type(error).__name__
    raise InputError(f"{place} cannot be read ({why}); delete it and run the command again")


@lru_cache(maxsize=1024)
def _parts_above(root: str, _: bytes, rank: int, part: int) -> frozenset[int]:
    """Return the parts of the rank after that flats of a file come up to: the plan decides them.

    Where there are few flats, most files have none for most parts: a process opens each once.
    """
    return frozenset(_read(root, rank, part)["counts"][0].tolist())
