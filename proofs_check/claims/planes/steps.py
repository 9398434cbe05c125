"""Claims on the running times of Steps 1 to 3: operations are counted, nothing is timed.

A verdict that rests on a clock would change with the machine. The stated bounds are on numbers of
operations, and these can be counted exactly; how they grow is shown beside the bound.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from functools import partial
from itertools import combinations

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.enumeration.great_circles import sphere_arrangement
from proofs_check.instances.arrangements import (
    arrangement_case,
    simple_arrangement,
    types_and_samples,
)
from proofs_check.statements.statement import Case, Claim, Route, proved

_OVER = (
    "counted on all 167 types of 3 to 7 distinct planes of rank 3, "
    "samples of 1 to 10 planes of every rank, and 8, 12, 16 planes in general position"
)


def _cases(rng: random.Random) -> Iterator[Case]:
    yield from types_and_samples(rng, range(3, 8), range(1, 11))
    for m in (8, 12, 16):
        yield arrangement_case(simple_arrangement(rng, m), f"m = {m}, general position")


def _signs(planes: Arrangement) -> list[tuple[int, ...]]:
    return [region.signs for region in planes.faces(3)]


def _tests_by_signs(planes: Arrangement) -> int:
    """Step 1 tests each state of i signs against plane i: all beginnings of regions' signs."""
    signs = _signs(planes)
    return sum(len({vector[:i] for vector in signs}) for i in range(len(planes)))


def _tests_by_theorem(planes: Arrangement) -> int:
    """The regions of the first i planes are the states that plane i is tested against."""
    starts = (Arrangement(planes.normals[:i]) for i in range(1, len(planes)))
    return 1 + sum(map(counts.region_count, starts))


def _comparisons_by_pairs(planes: Arrangement) -> int:
    return sum(1 for _ in combinations(_signs(planes), 2))


def _comparisons_by_theorem(planes: Arrangement) -> int:
    return math.comb(counts.region_count(planes), 2)


def _graph_traced(planes: Arrangement) -> tuple[int, int]:
    sphere = sphere_arrangement(planes)
    return sphere.region_count, sphere.arc_count


def _graph_by_theorem(planes: Arrangement) -> tuple[int, int]:
    f = counts.f_vector(planes)
    return f[3], f[2]


def _growth(count: Callable[[int], int]) -> Callable[[Arrangement, object], str]:
    """Show the exponent between m / 2 and m planes in general position, from closed forms."""

    def explain(planes: Arrangement, _: object) -> str:
        m = len(planes)
        if m < 8 or not planes.is_simple:
            return ""
        exponent = math.log2(count(m) / count(m // 2))
        return f"grows like m^{exponent:.2f} from {m // 2} to {m} planes in general position"

    return explain


def _regions(m: int) -> int:
    return m * m - m + 2


def _work(m: int) -> int:
    """E^3 + V E^2 log2 V, rounded down, for planes in general position."""
    v, e = _regions(m), 2 * m * (m - 1)
    return e**3 + v * e * e * v.bit_length()


_step = partial(
    Claim,
    sources=proved(_OVER, _cases),
)

CLAIMS = (
    _step(
        id="step-1-time",
        formula=r"\sum_{i=0}^{m-1} f_3(H_1, \ldots, H_i) \le m^3",
        proof=("Great circles", "Steps 1 to 3"),
        locator="Section IV-B, running time of Step 1",
        statement="Step 1 tests at most m^3 pairs of a state and a plane.",
        hypotheses=("one test counts as one operation",),
        quantity="number of tests",
        routes=(
            Route("beginnings of the enumerated regions' signs", _tests_by_signs),
            Route("1 + sum of |chi(-1)| over the first i planes", _tests_by_theorem),
        ),
        judge=lambda planes, tests: tests <= len(planes) ** 3,
        explain=_growth(lambda m: 1 + sum(map(_regions, range(1, m)))),
        meaning="A test is a linear program with as many rows as planes so far, so the time itself "
        "is one power of m higher unless an old point inside the region is used.",
    ),
    _step(
        id="step-2-time",
        formula=r"\binom{V}{2} \le m^4",
        proof=("Great circles", "Steps 1 to 3"),
        locator="Section IV-B, running time of Step 2",
        statement="Step 2 compares at most m^4 pairs of states.",
        hypotheses=("one comparison counts as one operation",),
        quantity="number of comparisons",
        routes=(
            Route("pairs of enumerated regions, one by one", _comparisons_by_pairs),
            Route("V (V - 1) / 2 with V = |chi(-1)|", _comparisons_by_theorem),
        ),
        judge=lambda planes, pairs: pairs <= len(planes) ** 4,
        explain=_growth(lambda m: math.comb(_regions(m), 2)),
        meaning="A comparison of two states looks at up to m signs.",
    ),
    _step(
        id="step-3-time",
        formula=r"V \le m^2 - m + 2, \quad E \le 2m^2",
        proof=("Great circles", "Steps 1 to 3"),
        locator="Section IV-B, running time of Step 3",
        statement="The graph of Step 3 has V <= m^2 - m + 2 and E <= 2 m^2, so that "
        "E^3 + V E^2 log V is polynomial in m, of order m^6 log m.",
        quantity="(V, E)",
        routes=(
            Route("great circles: regions and arcs traced", _graph_traced),
            Route("Zaslavsky's theorem", _graph_by_theorem),
        ),
        judge=lambda planes, found: (
            found[0] <= _regions(len(planes)) and found[1] <= 2 * len(planes) ** 2
        ),
        explain=_growth(_work),
        meaning="The bound on the minimum cycle basis itself is cited by the paper, not proved "
        "there. The faces can be read off in time linear in E instead.",
    ),
)
