"""Claims of others: how many regions named arrangements have, as printed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from random import Random

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.library.families.simplicial import printed_vectors, simplicial, simplicial_entries
from arrangement.library.published import PublishedCount, published_counts
from proofs_check.statements.statement import Case, Claim, Route, exhaustive

#: More regions take longer than a second.
_MOST_COUNTED = 10**6
#: More planes take longer than minutes.
_LARGEST = 256
#: More regions are not enumerated.
_MOST_REGIONS = 2000

_BY_FLATS = Route("|chi(-1)| of the characteristic polynomial", counts.region_count)


@cache
def _entries() -> Mapping[Arrangement, PublishedCount]:
    """The entries by their planes; equal planes of two families have the same number."""
    made = ((entry.planes(), entry) for entry in published_counts())
    return {planes: entry for planes, entry in made if len(planes) <= _LARGEST}


def _in_print(planes: Arrangement) -> int:
    return _entries()[planes].regions


def _cases(wanted: Callable[[Arrangement], bool]) -> Iterator[Case]:
    for planes, entry in _entries().items():
        if wanted(planes):
            yield Case(f"{entry.label}: {entry.source}", planes, planes.to_dict())


def _printed(rng: Random) -> Iterator[Case]:
    return _cases(lambda planes: _in_print(planes) <= _MOST_COUNTED)


def _small(rng: Random) -> Iterator[Case]:
    return _cases(lambda planes: _in_print(planes) <= _MOST_REGIONS)


def _large(rng: Random) -> Iterator[Case]:
    return _cases(lambda planes: _in_print(planes) > _MOST_COUNTED)


def _as_printed(planes: Arrangement, regions: int) -> bool:
    return regions == _in_print(planes)


#: The vectors t and r: how many vertices lie on k planes, and how many planes have k vertices.
_Vectors = tuple[dict[int, int], dict[int, int]]


@cache
def _catalogue() -> Mapping[Arrangement, tuple[int, int]]:
    return {simplicial(*entry): entry for entry in simplicial_entries()}


def _vectors(vertices: Iterable[Sequence[int]]) -> _Vectors:
    listed = list(vertices)
    on_planes = Counter(plane for vertex in listed for plane in vertex)
    return dict(Counter(map(len, listed))), dict(Counter(on_planes.values()))


def _by_lattice(planes: Arrangement) -> _Vectors:
    return _vectors(flat.planes for flat in counts.intersection_lattice(planes).flats[2])


def _by_great_circles(planes: Arrangement) -> _Vectors:
    incidence = planes.sphere().incidence
    if 3 * incidence.region_count != 2 * incidence.arc_count:
        return {}, {}  # not simplicial
    return _vectors(incidence.circles_at(v).tolist() for v in range(incidence.vertex_count // 2))


def _vectors_in_print(planes: Arrangement) -> _Vectors:
    return printed_vectors(*_catalogue()[planes])


def _entries_of_catalogue(rng: Random) -> Iterator[Case]:
    for planes, entry in _catalogue().items():
        yield Case(f"A{entry}", planes, planes.to_dict())


CLAIMS = (
    Claim(
        id="simplicial-catalogue",
        locator="the sources of the families",
        statement="The known simplicial arrangements of rank 3 have the printed numbers of "
        "vertices on k planes, and of planes with k vertices.",
        quantity="vectors t and r",
        routes=(
            Route("the flats of the lattice", _by_lattice),
            Route(
                "the vertices of the great circles, where all regions are triangles",
                _by_great_circles,
            ),
        ),
        judge=lambda planes, vectors: vectors == _vectors_in_print(planes),
        sources=exhaustive("all known entries", _entries_of_catalogue),
        meaning="They are simplicial: the catalogue and the five found after it, 119 in all.",
    ),
    Claim(
        id="regions-in-print",
        formula=r"|\chi(-1)| = \text{the number in print}",
        locator="the sources of the families",
        statement="Resonance, threshold, reflection, Shi, Ish, Catalan, Linial, semiorder, "
        "graphical, bigraphical, signed graphical, separation and discriminantal arrangements have "
        "the numbers of regions that are printed for them.",
        quantity="number of regions",
        routes=(_BY_FLATS, Route("the number in print", _in_print)),
        judge=_as_printed,
        sources=exhaustive(f"the numbers in print up to {_MOST_COUNTED:,}", _printed),
        meaning="Counts of this package agree with those of others.",
    ),
    Claim(
        id="small-regions-in-print",
        formula=r"|\chi(-1)| = |\{R : R \text{ is a region}\}| \le 2000",
        locator="the sources of the families",
        statement="Those of them with up to 2,000 regions have as many regions as can be listed.",
        quantity="number of regions",
        routes=(
            _BY_FLATS,
            Route("enumeration of all regions", lambda planes: len(planes.regions())),
        ),
        judge=_as_printed,
        sources=exhaustive(f"the numbers in print up to {_MOST_REGIONS}", _small),
    ),
    Claim(
        id="large-regions-in-print",
        locator="the sources of the families",
        statement="Those of them with over a million regions have the numbers of regions that are "
        "printed for them.",
        quantity="number of regions",
        routes=(_BY_FLATS, Route("the number in print", _in_print)),
        judge=_as_printed,
        sources=exhaustive(
            f"the numbers in print over {_MOST_COUNTED:,}, of up to {_LARGEST} planes", _large
        ),
        meaning="About a minute; checked only when it is named, or with --large.",
        large=True,
    ),
)
