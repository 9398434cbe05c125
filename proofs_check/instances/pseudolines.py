"""Arrangements of pseudolines of up to nine elements: oriented matroids of rank 3, from the census.

Up to eight every type is one of lines, or of planes through the origin; of the 461,053 types of
nine, 274 have no coordinates. An arrangement is known by its chirotope; what an `Arrangement` is
asked for most has the same name here. Faces are those on the sphere, where each pseudoline is a
closed curve.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from random import Random
from typing import Any

import numpy as np

from arrangement.library.census import MOST_PLANES
from arrangement.library.census.catalogue import PUBLISHED, chirotopes, without_coordinates
from arrangement.library.census.chirotopes import Signs, alternating, t_vectors, triples
from arrangement.numbers.exact import sign_text
from proofs_check.errors import OwnClaimError
from proofs_check.routes.many_types import flags
from proofs_check.statements.statement import Case, Domain, Kind, Source, range_text


@dataclass(frozen=True)
class Pseudolines:
    """An arrangement of n pseudolines, no two of them the same, not all through one point.

    Attributes:
        signs: of the triples 123, 124, 125, ..., in lexicographic order.
        n: how many pseudolines there are.
        stretchable: whether lines have this type.
    """

    signs: tuple[int, ...]
    n: int
    stretchable: bool = True

    rank, dimension, is_central = 3, 3, True

    def __len__(self) -> int:
        return self.n

    @property
    def distinct(self) -> range:
        """The numbers of the pseudolines."""
        return range(self.n)

    @property
    def chirotope(self) -> Mapping[tuple[int, ...], int]:
        """The sign of each triple."""
        return dict(zip(map(tuple, triples(self.n).tolist()), self.signs, strict=True))

    @cached_property
    def _array(self) -> Signs:
        return np.array([self.signs], dtype=np.int8)

    @cached_property
    def t_vector(self) -> dict[int, int]:
        """How many points of the projective plane lie on k pseudolines, by k."""
        return {k: int(t) for k, t in enumerate(t_vectors(self._array, self.n)[0]) if t and k > 1}

    @cached_property
    def _facets(self) -> dict[int, set[int]]:
        """The pseudolines that bound each region, by the set of those where it is positive."""
        half_edges = flags(self._array, self.n)
        sides: dict[int, set[int]] = {}
        for edge, line in zip(
            half_edges.edge[0].tolist(), half_edges.element.tolist(), strict=True
        ):
            for region in (edge, edge | 1 << line):
                sides.setdefault(region, set()).add(line)
        return sides

    def regions(self) -> list[tuple[int, ...]]:
        """Return the sign vectors of the regions of the sphere."""
        return [
            tuple(1 if mask >> k & 1 else -1 for k in range(self.n))
            for mask in sorted(self._facets)
        ]

    def bounded_regions(self) -> tuple[()]:
        """Return none: as of planes through the origin, no region is bounded."""
        return ()

    @property
    def bounded_p_vector(self) -> dict[int, int]:
        """Return none, as `bounded_regions`."""
        return {}

    @property
    def f_vector(self) -> tuple[int, int, int, int]:
        """1, and the numbers of vertices, edges and regions on the sphere."""
        facets = sum(map(len, self._facets.values())) // 2
        return 1, 2 * sum(self.t_vector.values()), facets, len(self._facets)

    @property
    def p_vector(self) -> dict[int, int]:
        """How many regions of the sphere have k sides, by k."""
        return dict(sorted(Counter(map(len, self._facets.values())).items()))

    @property
    def is_simple(self) -> bool:
        """Whether no three meet in a point."""
        return 0 not in self.signs

    @property
    def is_simplicial(self) -> bool:
        """Whether every region is a triangle."""
        return set(self.p_vector) == {3}

    @property
    def whitney_numbers(self) -> tuple[int, int, int, int]:
        """The coefficients of the characteristic polynomial."""
        flats = sum((k - 1) * t for k, t in self.t_vector.items())
        return 1, -self.n, flats, self.n - flats - 1

    def without(self, line: int) -> Pseudolines | None:
        """Return what is left when one is taken away; None if all others meet in a point."""
        if self.n == 3:
            return None
        rest = [k for k in range(self.n) if k != line]
        chi = alternating(self._array, self.n)[0]
        signs = tuple(int(chi[tuple(rest[k] for k in row)]) for row in triples(self.n - 1).tolist())
        return Pseudolines(signs, self.n - 1) if any(signs) else None

    def to_dict(self) -> dict[str, Any]:
        """Return the number of pseudolines and the signs as text, in the order of `signs`."""
        return {"pseudolines": self.n, "chirotope": sign_text(self.signs)}


@lru_cache(maxsize=1)
def not_stretchable() -> tuple[Pseudolines, ...]:
    """Return the isomorphism classes of nine pseudolines that no lines have."""
    return tuple(
        Pseudolines(tuple(map(int, signs)), MOST_PLANES, stretchable=False)
        for signs, _ in without_coordinates()
    )


def types(numbers: Sequence[int]) -> Iterator[Case]:
    """Yield every class of a given number of pseudolines, but for those of `not_stretchable`."""
    for n in numbers:
        for k, signs in enumerate(chirotopes(n).tolist() if n < MOST_PLANES else _nine(), 1):
            lines = Pseudolines(tuple(signs), n)
            yield Case(f"n = {n}, type {k} of {PUBLISHED[n]}", lines, lines.to_dict())


def _nine(together: int = 1000) -> Iterator[list[int]]:
    for start in range(0, PUBLISHED[MOST_PLANES], together):
        yield from chirotopes(MOST_PLANES, slice(start, start + together)).tolist()


def type_sources(low: int, high: int) -> tuple[Source, ...]:
    """Return the sources of all classes of a given size, and of those that no lines have."""
    over = f"every isomorphism class of {range_text(low, high)} pseudolines" + (
        " that lines have" if high == MOST_PLANES else ""
    )
    count = len(not_stretchable())
    special = [
        Case(f"type {k} of {count} without coordinates", lines, lines.to_dict())
        for k, lines in enumerate(not_stretchable(), 1)
    ]
    return (
        Source(Kind.EXHAUSTIVE, over, lambda _: types(range(low, high + 1))),
        Source(
            Kind.EXHAUSTIVE,
            "the isomorphism classes of nine pseudolines that no lines have",
            lambda _: special,
        ),
    )


def _draw(rng: Random, n: int) -> Pseudolines:
    if not 3 <= n <= MOST_PLANES:
        raise OwnClaimError(f"{n} pseudolines are requested; the census has 3 to {MOST_PLANES}")
    others = not_stretchable() if n == MOST_PLANES else ()
    place = rng.randrange(PUBLISHED[n] + len(others))
    if place >= PUBLISHED[n]:
        return others[place - PUBLISHED[n]]
    return Pseudolines(tuple(chirotopes(n, slice(place, place + 1))[0].tolist()), n)


PSEUDOLINES = Domain(
    "pseudolines",
    "arrangements of pseudolines",
    "pseudolines",
    3,
    _draw,
    lambda subject: isinstance(subject, Pseudolines),
    MOST_PLANES,
)
