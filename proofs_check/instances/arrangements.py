"""Arrangements to check claims on: random ones from a seed, and all small ones in order of size."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from itertools import combinations_with_replacement, product

from arrangement.arrangement import Arrangement
from arrangement.library import census
from arrangement.numbers.exact import primitive
from proofs_check.statements.statement import Case

Vector = tuple[int, ...]
#: The numbers of planes for which every type is checked in a default run.
TYPES = range(3, 8)


def arrangement_case(planes: Arrangement, label: str = "") -> Case:
    """Return an arrangement as a case with its file form."""
    kind = "" if planes.is_central else "affine, "
    text = f"{kind}m = {len(planes)}, rank {planes.rank}"
    return Case(label or text, planes, planes.to_dict())


def random_arrangement(
    rng: random.Random, m: int, d: int = 3, size: int = 9, *, affine: bool = False
) -> Arrangement:
    """Return m planes with entries up to `size`; small sizes make degenerate positions likely."""
    normals: list[Vector] = []
    while len(normals) < m:
        normal = tuple(rng.randint(-size, size) for _ in range(d))
        if any(normal):
            normals.append(normal)
    offsets = [rng.randint(-size, size) for _ in normals] if affine else None
    return Arrangement(normals, offsets, dimension=d)


def simple_arrangement(
    rng: random.Random, m: int, d: int = 3, *, affine: bool = False
) -> Arrangement:
    """Return m different planes in general position."""
    size = 9
    while True:
        planes = random_arrangement(rng, m, d, size, affine=affine)
        if planes.is_simple and len(planes.distinct) == m and (planes.is_central != affine):
            return planes
        size += 3


def mixed_cases(
    rng: random.Random, counts: range, *, per_count: int = 3, rank: int | None = None
) -> Iterator[Case]:
    """Yield central arrangements in R^3: simple ones, and ones with small entries.

    Entries up to 1 or 2 give coincident planes, common lines and low rank often.
    """
    for m in counts:
        arrangements = [simple_arrangement(rng, m)]
        while len(arrangements) < per_count:
            planes = random_arrangement(rng, m, size=1 + len(arrangements) % 2)
            if rank is None or planes.rank == rank:
                arrangements.append(planes)
        for planes in arrangements:
            if rank is None or planes.rank == rank:
                yield arrangement_case(planes)


def census_cases(counts: range, *, simple: bool = False) -> Iterator[Case]:
    """Yield every isomorphism class of m distinct planes of rank 3, for each m.

    The arrangements are new ones each time, so that nothing found for one claim is kept for
    another.
    """
    for m in counts:
        types = census.census(m, simple=simple)
        for k, planes in enumerate(types, 1):
            kind = "simple type" if simple else "type"
            label = f"m = {m}, {kind} {k} of {len(types)}"
            yield arrangement_case(Arrangement(planes.normals), label)


def line_cases(counts: range, *, simple: bool = False) -> Iterator[Case]:
    """Yield every isomorphism class of m different lines of R^2, for each m."""
    for m in counts:
        for k, lines in enumerate(census.lines(m, simple=simple), 1):
            yield arrangement_case(lines, f"m = {m}, {'simple ' * simple}type {k}")


def types_and_samples(
    most: int, per_count: int = 3, counts: range = TYPES
) -> Callable[[random.Random], Iterator[Case]]:
    """Return what yields every type for `counts`, then samples of 1 to `most` planes of all ranks.

    Coincident planes are included.
    """

    def cases(rng: random.Random) -> Iterator[Case]:
        yield from census_cases(counts)
        yield from mixed_cases(rng, range(1, most + 1), per_count=per_count)

    return cases


def smallest_arrangements(
    planes: range, size: int = 2, *, distinct: bool = False, rank: int | None = None
) -> Iterator[Case]:
    """Yield what `smallest_planes` does, as cases."""
    return map(arrangement_case, smallest_planes(planes, size, distinct=distinct, rank=rank))


def smallest_planes(
    planes: range, size: int = 2, *, distinct: bool = False, rank: int | None = None
) -> Iterator[Arrangement]:
    """Yield central arrangements in R^3: few planes first, then small entries first.

    Up to reorientation every arrangement with coprime entries up to `size` comes once.
    """
    for m in planes:
        for bound in range(1, size + 1):
            vectors = _up_to_sign(bound)
            for chosen in combinations_with_replacement(vectors, m):
                if max(max(map(abs, v)) for v in chosen) < bound:
                    continue
                arrangement = Arrangement(chosen)
                if distinct and len(arrangement.distinct) < m:
                    continue
                if rank is None or arrangement.rank == rank:
                    yield arrangement


def _up_to_sign(bound: int) -> list[Vector]:
    """Return the primitive vectors of Z^3 with entries up to `bound`, one of each pair +-v."""
    entries = range(-bound, bound + 1)
    vectors = (v for v in product(entries, repeat=3) if v > (0, 0, 0) and primitive(v) == v)
    return sorted(vectors, key=lambda v: (sum(map(abs, v)), tuple(-x for x in v)))
