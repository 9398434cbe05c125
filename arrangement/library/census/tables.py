"""What the census says as a whole: numbers of types by regions and by points, and its checks."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256

import numpy as np

from arrangement.console.progress import watched
from arrangement.library.census.catalogue import (
    MOST_PLANES,
    PUBLISHED,
    census,
    chirotopes,
    normals,
    place_keys,
    places,
    without_coordinates,
)
from arrangement.library.census.chirotopes import extended, extensions, t_vectors, triples
from arrangement.library.census.final_polynomials import (
    OrderedProducts,
    proved_no_coordinates,
    proves_no_coordinates,
)
from arrangement.numbers import budget
from arrangement.planes.proved import proved_f_vectors

#: Types that are worked on together.
_TOGETHER = 5000


@dataclass(frozen=True)
class Table:
    """The isomorphism classes of m distinct planes of rank 3, counted.

    Attributes:
        types, simple, simplicial: how many there are.
        by_regions: numbers of types by number of regions.
        by_points: the same by numbers of points on 2, 3, ... planes: the t-vector from t2 on,
            without zeros at its end.
        digest: SHA-256 of all normals, in order, one signed byte an entry.
    """

    types: int
    simple: int
    simplicial: int
    by_regions: dict[int, int]
    by_points: dict[tuple[int, ...], int]
    digest: str


def table(planes: int) -> Table:
    """Count the classes of a given number of planes, 3 to 9; those of nine take half a minute."""
    rows = normals(planes)
    parts = watched(list(budget.chunks(len(rows), _TOGETHER)), "parts of the types")
    points = np.concatenate([t_vectors(chirotopes(planes, part), planes) for part in parts])
    lines = np.arange(planes + 1)
    regions = 2 + 2 * (points * (lines - 1))[:, 2:].sum(1)
    facets = 2 * points @ lines
    t_vector = Counter(np.trim_zeros(row, "b")[2:] for row in map(tuple, points.tolist()))
    return Table(
        types=len(rows),
        simple=int((points[:, 3:] == 0).all(1).sum()),
        simplicial=int((2 * facets == 3 * regions).sum()),
        by_regions=dict(sorted(Counter(regions.tolist()).items())),
        by_points=dict(sorted(t_vector.items(), reverse=True)),
        digest=sha256(rows.astype(np.int8).tobytes()).hexdigest(),
    )


def compare_counts(planes: int, chosen: Sequence[int] | None = None) -> tuple[int, int]:
    """Count rays, facets and regions of types by the program that is proved in Coq, and compare.

    What it is compared with are the numbers that follow from the signs of triples of planes.

    Args:
        planes: of the types, 3 to 9.
        chosen: their places in the list; if omitted, all.

    Returns:
        How many types were counted, those with irrational coordinates left out, and for how many
        all three numbers are the same.

    Raises:
        InputError: the program is not built.

    """
    listed, rows = census(planes), normals(planes)
    places = np.arange(len(rows)) if chosen is None else np.array(chosen, dtype=np.intp)
    places = places[rows[places].any((1, 2))]
    lines, alike = np.arange(planes + 1), 0
    parts = [places[part] for part in budget.chunks(len(places), _TOGETHER)]
    for part in watched(parts, f"parts of {_TOGETHER:,} types"):
        points = t_vectors(chirotopes(planes, part), planes)
        facets = 2 * points @ lines
        rays = 2 * points.sum(1)
        expected = np.stack([np.ones_like(rays), rays, facets, 2 - rays + facets], axis=1)
        counted = proved_f_vectors(listed[k] for k in part.tolist())
        alike += int((np.array(counted) == expected).all(1).sum())
    return len(places), alike


@dataclass(frozen=True)
class Check:
    """What a check of the list of nine planes found.

    Attributes:
        different: the types are in strict order of their codes: no two are the same.
        proofs: proofs that hold, each for another type without coordinates.
        parents: isomorphism classes of eight planes that were extended without coordinates.
        extensions: in how many ways.
        listed: how many of these are types of the list.
        without: how many are types without coordinates.
    """

    different: bool
    proofs: int
    parents: int
    extensions: int
    listed: int
    without: int

    @property
    def holds(self) -> bool:
        """Nothing speaks against the list."""
        return self.different and self.listed + self.without == self.extensions


def check(sample: int, seed: int = 0, *, order: bool = True, proved: bool = False) -> Check:
    """Check the list of nine planes by a route without coordinates, on a sample.

    Args:
        sample: isomorphism classes of eight planes to extend, 0 to 4890.
        seed: of their choice.
        order: check the order of the whole list too, which takes two minutes.
        proved: let the program that is proved in Coq check the proofs.

    Raises:
        InputError: `proved`, and the program is not built.
    """
    keys = _without_coordinates(proved)
    signs = chirotopes(MOST_PLANES - 1)
    chosen = np.random.default_rng(seed).permutation(len(signs))[:sample]
    total = listed = without = 0
    for parent in watched(chosen, "isomorphism classes of eight planes"):
        added = extensions(signs[parent], MOST_PLANES - 1)
        larger = extended(signs[parent], added, MOST_PLANES - 1)
        known = places(larger) >= 0
        total, listed = total + len(larger), listed + int(known.sum())
        if not known.all():
            without += sum(row in keys for row in map(tuple, place_keys(larger[~known]).tolist()))
    return Check(_in_order() if order else True, len(keys), sample, total, listed, without)


def _without_coordinates(proved: bool) -> set[tuple[int, ...]]:
    """Return the keys of the types that are shown to have no coordinates."""
    names = [tuple(row) for row in triples(MOST_PLANES).tolist()]

    def holds(signs: list[int], proof: Sequence[OrderedProducts]) -> bool:
        if proved:
            return proved_no_coordinates(signs, proof)
        return proves_no_coordinates(dict(zip(names, signs, strict=True)), proof)

    shown = [signs for signs, proof in without_coordinates() if holds(signs.tolist(), proof)]
    return set(map(tuple, place_keys(np.array(shown)).tolist()))


def _in_order() -> bool:
    last: tuple[int, ...] = ()
    for part in watched(
        list(budget.chunks(PUBLISHED[MOST_PLANES], _TOGETHER)), "parts of the list"
    ):
        for row in map(tuple, place_keys(chirotopes(MOST_PLANES, part)).tolist()):
            if row <= last:
                return False
            last = row
    return True
