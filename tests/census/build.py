"""The types of one more pseudoline: without coordinates, and vectors for them.

A vector v extends an arrangement to a given one-element extension when ``v . r`` has the wanted
sign for each ray r = a_i x a_j. All vectors of the box are tried together, the smallest first.

*Types.* Every isomorphism class of eight planes is extended by a pseudoline in every way
(`extensions`), and what results is distinguished by codes (`codes`). No coordinates are used, so
the isomorphism classes of oriented matroids are complete, whether they have coordinates or not.

*Vectors.* A small vector with the signs of an extension gives the type coordinates. In round 0
the arrangements of the list are extended. What is left over needs other coordinates of the eight
planes; later rounds take them from isomorphism classes of nine planes that have some, less one
plane.

*Proofs.* A type for which no vectors turn up is shown to have none (`final_polynomials`), or it is
the one of `families.perles`, which has no rational ones. The builder ends when this is settled for
each type.

What is done is kept in a folder. Neither interruptions nor the number of processes change what
is built.
"""

from __future__ import annotations

import io
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.console import workers
from arrangement.console.progress import note, watched
from arrangement.console.writing import reason, write_bytes_atomically
from arrangement.errors import InputError
from arrangement.library.census.catalogue import MOST_PLANES, exact_chirotope, normals
from arrangement.library.census.chirotopes import (
    Integers,
    Signs,
    canonical,
    chirotope_of,
    extended,
    extensions,
    pairs,
    regions,
    relabelling,
    triples,
)
from arrangement.library.census.final_polynomials import OrderedProducts
from arrangement.library.families import perles

from .proofs import final_polynomial

#: Products are sums of three integers; float32 gives them exactly below this.
_EXACT_IN_FLOAT32 = 2**24


@lru_cache(maxsize=2)
def box(size: int) -> Integers:
    """Return the primitive vectors with entries up to `size`, up to sign, smallest first."""
    entries = np.arange(-size, size + 1)
    vectors = np.stack(np.meshgrid(entries, entries, entries, indexing="ij"), -1).reshape(-1, 3)
    vectors = vectors[np.gcd.reduce(vectors, axis=1) == 1]
    first = vectors[np.arange(len(vectors)), (vectors != 0).argmax(1)]
    vectors = vectors[first > 0]
    sizes = np.abs(vectors)
    ordered: Integers = vectors[np.lexsort((*vectors.T[::-1], sizes.sum(1), sizes.max(1)))]
    return ordered


def keys(localizations: Signs) -> Integers:
    """Return an integer for each row of at most 39 signs, equal for a row and its negative."""
    first = localizations[np.arange(len(localizations)), (localizations != 0).argmax(1)]
    powers = 3 ** np.arange(localizations.shape[1], dtype=np.int64)
    result: Integers = (localizations * first[:, None]).astype(np.int64) @ powers
    return result


def smallest_vectors(normals: Integers, wanted: Integers, size: int) -> NDArray[np.intp]:
    """Return the place in `box(size)` of the first vector with each wanted key, or -1."""
    available, first = np.unique(keys(_localizations(normals, box(size))), return_index=True)
    place = np.searchsorted(available, wanted).clip(max=len(available) - 1)
    return np.where(available[place] == wanted, first[place], -1)


def _localizations(normals: Integers, vectors: Integers) -> Signs:
    """Return the signs of det(a_i, a_j, v) for the pairs i < j and all vectors v, (V, pairs)."""
    i, j = pairs(len(normals)).T
    rays = np.cross(normals[i], normals[j])
    if 3 * int(np.abs(rays).max()) * int(np.abs(vectors).max()) >= _EXACT_IN_FLOAT32:
        return np.sign(vectors @ rays.T).astype(np.int8)
    return np.sign(vectors.astype(np.float32) @ rays.T.astype(np.float32)).astype(np.int8)


Arrays: TypeAlias = dict[str, NDArray[Any]]
#: The chirotope of a type without vectors, and the proof that it has none, once it is found.
_Proof: TypeAlias = tuple[Signs, tuple[OrderedProducts, ...] | None]

#: The largest entry of a vector that is tried.
_SIZE = 12
#: Arrangements that one part of the work extends.
_PART = 30
#: Types with one plane more from which an arrangement takes other coordinates, in round 1.
_SAMPLE = 5
#: Proofs are looked for when so few types have no vectors.
_FEW = 400
#: In place of a parent: the vectors extend no arrangement of the list; there are none yet, or
#: none at all.
_OTHER, _OPEN, _NEVER = -1, -2, -3


class _Workload(NamedTuple):
    """What the parts of the work have in common: n planes are extended."""

    folder: str
    n: int
    round: int = 0

    def file(self, name: str) -> Path:
        return Path(self.folder) / f"{name}.npz"


class _Extensions(NamedTuple):
    """All extensions: the number of the type of each, the arrangement, and the key of its signs."""

    types: NDArray[np.intp]
    parents: NDArray[np.intp]
    keys: Integers


class _Found(NamedTuple):
    """Coordinates of every type, and which arrangement of the list they extend."""

    normals: NDArray[np.int8]
    parents: NDArray[np.intp]


def build(folder: str, jobs: int = 1, planes: int = 9) -> Arrays:
    """Return the arrays of the list of types, as `catalogue` has them.

    Args:
        folder: keeps what is done; an interrupted run goes on from there.
        jobs: processes.
        planes: 4 to 9.

    Raises:
        InputError: the folder cannot be written, or there is no such number of processes.
    """
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"cannot make the folder {folder}: {reason(error)}") from None
    plan = _Workload(folder, planes - 1)
    every = _every_extension(plan, jobs)
    size = int(every.types.max()) + 1
    found = _Found(np.zeros((size, planes, 3), dtype=np.int8), np.full(size, _OPEN))
    proofs: dict[int, _Proof] = {}
    while (found.parents == _OPEN).any():
        _realize(plan, every, found, jobs)
        left = np.flatnonzero(found.parents == _OPEN).tolist()
        new = [number for number in left if number not in proofs] if len(left) <= _FEW else []
        for number in watched(new, "types without vectors"):
            signs, proof = proofs[number] = _proof(plan, every, number)
            if proof:
                found.parents[number] = _NEVER
            elif planes == MOST_PLANES and _same(signs, exact_chirotope(perles())):
                found.parents[number] = _OTHER  # its normals stay 0
        note(f"round {plan.round}: {np.sum(found.parents == _OPEN)} of {size} types are open")
        plan = plan._replace(round=plan.round + 1)
    return _arrays(
        plan, found, [proofs[k] for k in np.flatnonzero(found.parents == _NEVER).tolist()]
    )


def _every_extension(plan: _Workload, jobs: int) -> _Extensions:
    """Extend all arrangements in parts, which are kept, and number the types by their codes."""
    total = -(-len(normals(plan.n)) // _PART)
    pending = [
        k for k in workers.part_numbers(total, (1, 1), jobs) if not plan.file(f"types-{k}").exists()
    ]
    done = workers.run_parts(_extended, plan, pending, jobs)
    for number, part in watched(done, "parts of the types", len(pending)):
        _write(plan.file(f"types-{number}"), part)
    whole = _joined([_read(plan.file(f"types-{k}")) for k in range(total)])
    columns = np.column_stack([whole["regions"], whole["codes"]])
    order = np.lexsort(columns.T[::-1])
    new = (columns[order[1:]] != columns[order[:-1]]).any(1)
    types = np.empty(len(order), dtype=np.intp)
    types[order] = np.concatenate([[0], np.cumsum(new)])
    return _Extensions(types, whole["parents"], whole["keys"])


def _extended(plan: _Workload, number: int) -> tuple[int, Arrays]:
    """Return the number of a part, and regions, codes, arrangements and keys of its extensions."""
    signs = chirotope_of(normals(plan.n))
    parents = range(number * _PART, min((number + 1) * _PART, len(signs)))
    added = [extensions(signs[k], plan.n) for k in parents]
    pairs = zip(parents, added, strict=True)
    larger = np.concatenate([extended(signs[k], new, plan.n) for k, new in pairs])
    return number, {
        "regions": regions(larger, plan.n + 1),
        "codes": canonical(larger, plan.n + 1).codes,
        "parents": np.repeat(parents, [len(new) for new in added]),
        "keys": keys(np.concatenate(added)),
    }


def _realize(plan: _Workload, every: _Extensions, found: _Found, jobs: int) -> None:
    """Find vectors for types that have none, in one round, unless an earlier run has."""
    file = plan.file(f"round-{plan.round}")
    if not file.exists():
        todo = _todo(plan, every, found)
        _write(plan.file("todo"), todo)
        parts = range(-(-len(todo["parents"]) // _PART))
        done = workers.run_parts(_tried, plan, parts, jobs)
        whole = _joined(list(watched(done, f"parts of round {plan.round}", len(parts))))
        order = np.lexsort((whole["parents"], whole["places"], whole["types"]))
        _, first = np.unique(whole["types"][order], return_index=True)
        _write(file, {name: array[order[first]] for name, array in whole.items()})
    kept = _read(file)
    found.normals[kept["types"]] = kept["normals"]
    found.parents[kept["types"]] = _OTHER if plan.round else kept["parents"]


def _todo(plan: _Workload, every: _Extensions, found: _Found) -> Arrays:
    """Return the extensions whose types have no vectors, by arrangement, with what may help."""
    rows = np.flatnonzero(found.parents[every.types] == _OPEN)
    parents, starts = np.unique(every.parents[rows], return_index=True)
    samples = np.zeros((len(parents), _SAMPLE * plan.round, plan.n + 1, 3), dtype=np.int8)
    for row, parent in zip(samples, parents, strict=True) if plan.round else ():
        low, high = np.searchsorted(every.parents, [parent, parent + 1])
        types = np.unique(every.types[low:high])
        types = types[(found.parents[types] > _OPEN) & (found.parents[types] != parent)]
        chosen = np.random.default_rng((plan.round, parent)).permutation(types)[: len(row)]
        row[: len(chosen)] = found.normals[chosen]
    return {
        "parents": parents,
        "starts": np.append(starts, len(rows)),
        "types": every.types[rows],
        "keys": every.keys[rows],
        "samples": samples,
    }


def _tried(plan: _Workload, number: int) -> Arrays:
    """Return types, arrangements, normals, and places of the new ones in the box, for one part."""
    todo, listed, vectors = _read(plan.file("todo")), normals(plan.n).astype(np.int64), box(_SIZE)
    results = []
    for k in range(number * _PART, min((number + 1) * _PART, len(todo["parents"]))):
        parent, rows = todo["parents"][k], slice(*todo["starts"][k : k + 2])
        bases = listed[parent][None]
        if plan.round:
            bases = _with_other_coordinates(bases, todo["samples"][k].astype(np.int64))
        places = np.stack([smallest_vectors(basis, todo["keys"][rows], _SIZE) for basis in bases])
        places[places < 0] = len(vectors)
        best, least = places.argmin(0), places.min(0)
        hit = least < len(vectors)
        last = vectors[least[hit]][:, None]
        results.append(
            {
                "types": todo["types"][rows][hit],
                "parents": np.full(hit.sum(), parent),
                "places": least[hit],
                "normals": np.concatenate([bases[best[hit]], last], axis=1).astype(np.int8),
            }
        )
    return _joined(results)


def _with_other_coordinates(basis: Integers, larger: Integers) -> Integers:
    """Return a basis, and others with its signs, from larger arrangements less one plane."""
    n = basis.shape[1]
    larger = larger[larger.any((1, 2))]
    less = np.concatenate([basis, *(np.delete(larger, k, axis=1) for k in range(n))])
    theirs, mine = (canonical(chirotope_of(rows), n) for rows in (less, basis))
    order, sides = relabelling(theirs, mine)
    moved = np.take_along_axis(less, order[..., None], axis=1) * sides[..., None]
    alike: Integers = moved[(theirs.codes == mine.codes).all(1)]
    return alike


def _proof(plan: _Workload, every: _Extensions, number: int) -> _Proof:
    """Return the chirotope of a type, and the proof that it has no vectors, if there is one."""
    row = np.flatnonzero(every.types == number)[0]
    signs = chirotope_of(normals(plan.n)[every.parents[row]])
    added = extensions(signs, plan.n)
    larger = extended(signs, added[keys(added) == every.keys[row]], plan.n)[0]
    named = zip(map(tuple, triples(plan.n + 1).tolist()), larger.tolist(), strict=True)
    return larger, final_polynomial(dict(named), plan.n + 1)


def _same(one: Signs, other: Signs) -> bool:
    codes = canonical(np.stack([one, other]), MOST_PLANES).codes
    return bool((codes[0] == codes[1]).all())


def _arrays(plan: _Workload, found: _Found, proofs: list[_Proof]) -> Arrays:
    """Return each type as a vector added to a parent: one of the list, or of those kept here."""
    has = found.parents > _OPEN
    every, parents = found.normals[has], found.parents[has]
    other = parents == _OTHER
    bases, index = np.unique(every[other, :-1], axis=0, return_inverse=True)
    parents[other] = len(normals(plan.n)) + index.reshape(-1)
    steps = [
        (number, *step.relation, *step[1:])
        for number, (_, proof) in enumerate(proofs)
        for step in proof or ()
    ]
    return {
        "parents": parents.astype(np.uint16),
        "vectors": every[:, -1],
        "bases": bases,
        "without": np.array([signs for signs, _ in proofs], dtype=np.int8),
        "proofs": np.array(steps, dtype=np.int32).reshape(-1, 9),
    }


def _joined(parts: list[Arrays]) -> Arrays:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _read(file: Path) -> Arrays:
    with np.load(file) as arrays:
        return dict(arrays)


def _write(file: Path, arrays: Arrays) -> None:
    stream = io.BytesIO()
    np.savez(stream, **arrays)  # type: ignore[arg-type]
    write_bytes_atomically(file, stream.getvalue())
