"""Numbers of regions of named arrangements as they stand in print: data to compare with.

Nothing computes them here, and no engine reads them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.library.families.classical import coxeter
from arrangement.library.families.points import resonance, threshold, threshold_functions

from .families.classical import braid, type_b, type_d
from .families.deformations import catalan, ish, ish_b, linial, semiorder, shi
from .families.graphs import bigraphical, graphical, signed_graphical
from .families.points import discriminantal, separations


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
        made, words = self.family, [*map(repr, self.arguments)]
        if isinstance(made, partial):
            words += [f"{name}={value!r}" for name, value in made.keywords.items()]
            made = made.func
        return f"{made.__name__}({', '.join(words)})"

    def planes(self) -> Arrangement:
        """Return the arrangement itself."""
        return self.family(*self.arguments)


_HUMPHREYS = "J. Humphreys, Reflection Groups and Coxeter Groups (1990), section 2.11"
_ATHANASIADIS = "[Athanasiadis2004]"
_BIGRAPHICAL = "[HopkinsPerkinson2016]"
_SPANNED = partial(discriminantal, affine=True)
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
    (ish_b, 1, "[TranTsujie2025]", (3, 25, 343, 6561)),
)
#: Families with other arguments: a type and a number m where it is not 1, a graph, a polytope.
_OTHERS: tuple[tuple[Callable[..., Arrangement], str, dict[tuple[Any, ...], int]], ...] = (
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
    (
        graphical,
        "R. Stanley, Discrete Mathematics 5 (1973): acyclic orientations",
        {("1-2,2-3,3-4,1-4",): 14, ("1-2,2-3,3-4,1-4,1-3",): 18},
    ),
    (bigraphical, _BIGRAPHICAL, {("1-2,2-3,1-3",): 19, ("1-2,2-3,3-4,1-4",): 65}),
    (shi, _BIGRAPHICAL, {("1-2,2-3,3-4",): 27, ("1-3,2-3,3-4", 2): 125}),
    (semiorder, _BIGRAPHICAL, {("1-2,2-3,3-4",): 27}),
    (
        semiorder,
        "Sage's reference manual, hyperplane_arrangements.bigraphical",
        {("1-2,2-3,3-4,1-4",): 59},
    ),
    (
        signed_graphical,
        "T. Zaslavsky, American Mathematical Monthly 88 (1981)",
        {
            ("1-2,1-3,2-3,1+2,1+3,2+3",): 24,
            ("1-2,1-3,2-3,1+2,1+3,2+3,1",): 32,
            ("1-2,1-3,2-3,1+2,1+3,2+3,1,2",): 40,
        },
    ),
    (
        separations,
        "OEIS A027649",
        {
            ("cross-polytope", 2): 14,
            ("cross-polytope", 3): 46,
            ("cross-polytope", 4): 146,
            ("cross-polytope", 5): 454,
            ("demicube", 4): 146,
        },
    ),
    (separations, "[BrysiewiczEbleKuehne2023]", {("demicube", 5): 3756}),
    (separations, "[Cover1965]: points on a conic", {("permutohedron", 3): 32}),
    (discriminantal, "[ManinSchechtman1989]", {(4, 3): 24, (5, 4): 120, (6, 5): 720}),
    (
        _SPANNED,
        "OEIS A055503",
        {(3, 2): 7, (4, 2): 18, (5, 2): 41, (6, 2): 85, (7, 2): 162, (8, 2): 287},
    ),
    (_SPANNED, "[BrysiewiczEbleKuehne2023]", {(6, 4): 600}),
)


def published_counts() -> Iterator[PublishedCount]:
    """Yield every number, family by family.

    >>> next(entry.regions for entry in published_counts() if entry.label == "coxeter('E8')")
    696729600
    """
    for family, first, source, numbers in _SEQUENCES:
        for n, regions in enumerate(numbers, start=first):
            yield PublishedCount(family, (n,), regions, source)
    for family, source, entries in _OTHERS:
        for arguments, regions in entries.items():
            yield PublishedCount(family, arguments, regions, source)
