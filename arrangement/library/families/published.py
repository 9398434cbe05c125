"""Numbers of regions of named arrangements as they stand in print: data to compare with.

Nothing computes them here, and no engine reads them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from arrangement.arrangement import Arrangement

from .classical import braid, type_b, type_d
from .combinatorial import resonance, threshold, threshold_functions
from .deformations import catalan, ish, linial, semiorder, shi
from .root_systems import coxeter


@dataclass(frozen=True)
class PublishedCount:
    """The number of regions of one arrangement, and where it is printed."""

    family: Callable[..., Arrangement]
    arguments: tuple[Any, ...]
    regions: int
    source: str

    @property
    def label(self) -> str:
        """The call that makes the arrangement."""
        return f"{self.family.__name__}({', '.join(map(repr, self.arguments))})"

    def planes(self) -> Arrangement:
        """Return the arrangement itself."""
        return self.family(*self.arguments)


_HUMPHREYS = "J. Humphreys, Reflection Groups and Coxeter Groups (1990), section 2.11"
_ATHANASIADIS = "[Athanasiadis2004]"
#: Families with a number n, from the first n on.
_SEQUENCES: tuple[tuple[Callable[..., Arrangement], int, str, tuple[int, ...]], ...] = (
    (
        resonance,
        1,
        "OEIS A034997; [BrysiewiczEbleKuehne2023]",
        (2, 6, 32, 370, 11292, 1066044, 347326352, 419172756930),
    ),
    (
        threshold_functions,
        0,
        "OEIS A000609",
        (2, 4, 14, 104, 1882, 94572, 15028134, 8378070864, 17561539552946),
    ),
    (threshold, 1, "OEIS A005840", (1, 2, 8, 46, 332, 2874, 29024)),
    (braid, 1, "OEIS A000142", (1, 2, 6, 24, 120, 720, 5040)),
    (type_b, 1, "OEIS A000165", (2, 8, 48, 384, 3840, 46080)),
    (type_d, 2, "OEIS A002866", (4, 24, 192, 1920, 23040)),
    (shi, 1, "OEIS A000272", (1, 3, 16, 125, 1296, 16807)),
    (ish, 1, "Armstrong and Rhoades (2012), OEIS A000272", (1, 3, 16, 125, 1296, 16807)),
    (catalan, 1, "OEIS A001761", (1, 4, 30, 336, 5040, 95040)),
    (linial, 1, "OEIS A007889", (1, 2, 7, 36, 246, 2104)),
    (semiorder, 1, "OEIS A006531", (1, 3, 19, 183, 2371, 38703)),
)
#: Families with a type, and a number m where it is not 1.
_TYPES: tuple[tuple[Callable[..., Arrangement], str, dict[tuple[Any, ...], int]], ...] = (
    (
        coxeter,
        _HUMPHREYS,
        {
            ("A4",): 120,
            ("B4",): 384,
            ("C4",): 384,
            ("D5",): 1920,
            ("E6",): 51840,
            ("E7",): 2903040,
            ("E8",): 696729600,
            ("F4",): 1152,
            ("G2",): 12,
            ("H3",): 120,
            ("H4",): 14400,
            ("I2(5)",): 10,
            ("I2(7)",): 14,
        },
    ),
    (
        shi,
        _ATHANASIADIS,
        {
            ("A3",): 5**3,
            ("B3",): 7**3,
            ("C3",): 7**3,
            ("D4",): 7**4,
            ("F4",): 13**4,
            ("G2",): 7**2,
            ("E6",): 13**6,
            ("B3", 2): 13**3,
            ("B4", 3): 25**4,
        },
    ),
    (
        catalan,
        _ATHANASIADIS,
        {
            ("A3",): 6 * 7 * 8,
            ("B3",): 8 * 10 * 12,
            ("C3",): 8 * 10 * 12,
            ("D4",): 8 * 10 * 10 * 12,
            ("F4",): 14 * 18 * 20 * 24,
            ("G2",): 8 * 12,
            ("B3", 2): 14 * 16 * 18,
        },
    ),
)


def published_counts() -> Iterator[PublishedCount]:
    """Yield every number, family by family.

    >>> next(entry.regions for entry in published_counts() if entry.label == "coxeter('E8')")
    696729600
    """
    for family, first, source, numbers in _SEQUENCES:
        for n, regions in enumerate(numbers, start=first):
            yield PublishedCount(family, (n,), regions, source)
    for family, source, entries in _TYPES:
        for arguments, regions in entries.items():
            yield PublishedCount(family, arguments, regions, source)
