"""Claims of others: how many regions named arrangements have, as printed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from random import Random

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.library.families.published import PublishedCount, published_counts
from proofs_check.statement import Case, Claim, Route, exhaustive

#: More planes take longer than a few seconds; `make bench` counts them.
_MOST_PLANES = 128
#: More regions are not enumerated.
_MOST_REGIONS = 2000

_BY_FLATS = Route("|chi(-1)| of the characteristic polynomial", counts.region_count)


@cache
def _entries() -> Mapping[Arrangement, PublishedCount]:
    """The entries by their planes; equal planes of two families have the same number."""
    made = ((entry.planes(), entry) for entry in published_counts())
    return {planes: entry for planes, entry in made if len(planes) <= _MOST_PLANES}


def _in_print(planes: Arrangement) -> int:
    return _entries()[planes].regions


def _printed(rng: Random) -> Iterator[Case]:
    for planes, entry in _entries().items():
        yield Case(f"{entry.label}: {entry.source}", planes, planes.to_dict())


def _small(rng: Random) -> Iterator[Case]:
    return (case for case in _printed(rng) if _in_print(case.subject) <= _MOST_REGIONS)


def _as_printed(planes: Arrangement, regions: int) -> bool:
    return regions == _in_print(planes)


CLAIMS = (
    Claim(
        id="regions-in-print",
        formula=r"|\chi(-1)| = \text{the number in print}",
        locator="the sources of the families",
        statement="Resonance, threshold, reflection, Shi, Ish, Catalan, Linial and semiorder "
        "arrangements have the numbers of regions that are printed for them.",
        quantity="number of regions",
        routes=(_BY_FLATS, Route("the number in print", _in_print)),
        judge=_as_printed,
        sources=exhaustive(f"the numbers in print of up to {_MOST_PLANES} planes", _printed),
        meaning="Counts of this package agree with those of others, up to 8,378,070,864 regions.",
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
)
