"""Claims on the number of slip states, and on the running times of Steps 1 to 3.

A verdict that rests on a clock would change with the machine. The stated bounds of the steps are on
numbers of operations, and these can be counted exactly; how they grow is shown beside the bound.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.enumeration.paper_steps import published_enumeration
from arrangement.library.census.chirotopes import Signs
from arrangement.numbers.float_filter import Booleans
from proofs_check.instances.arrangements import (
    TYPES,
    arrangement_case,
    census_cases,
    random_arrangement,
    simple_arrangement,
    smallest_arrangements,
    types_and_samples,
)
from proofs_check.instances.printed import STATE_COUNTS
from proofs_check.routes.many_types import f_vectors
from proofs_check.statements.statement import Case

from .stated import at_most, stated


def _states_counted(planes: Arrangement) -> int:
    return sum(counts.f_vector(planes))


def _published_predicted(planes: Arrangement) -> int:
    """Regions V, facets E, and E - V + 2 cycles, from the theorem alone."""
    _, _, edges, vertices = counts.f_vector(planes)
    return vertices + edges + (edges - vertices + 2)


def _in_general_position(*counts: int) -> Callable[[random.Random], Iterator[Case]]:
    """Return what yields one arrangement in general position for each number of planes."""
    return lambda rng: (arrangement_case(simple_arrangement(rng, m), f"m = {m}") for m in counts)


def _simple_types(rng: random.Random) -> Iterator[Case]:
    yield from census_cases(TYPES, simple=True)
    yield from (arrangement_case(simple_arrangement(rng, m)) for m in range(8, 16))


def _region_maximum(planes: Arrangement, regions: int) -> bool:
    """At most m^2 - m + 2, with equality exactly for distinct planes in general position."""
    most = _most_regions(len(planes))
    simple = planes.is_simple and len(planes.distinct) == len(planes)
    return regions <= most and (regions == most) == simple


def _region_maxima(signs: Signs, n: int) -> Booleans:
    regions, most = f_vectors(signs, n)[:, 2], _most_regions(n)
    below: Booleans = (regions <= most) & ((regions == most) == signs.all(1))
    return below


#: Dimension -> most planes of the samples.
_MOST_PLANES = {1: 8, 2: 8, 3: 7, 4: 6}


def _bound_cases(rng: random.Random) -> Iterator[Case]:
    for d, most in _MOST_PLANES.items():
        for m in range(1, most + 1):
            for size in (1, 2, 9):
                for affine in (False, True):
                    planes = random_arrangement(rng, m, d, size, affine=affine)
                    yield arrangement_case(planes, f"d = {d}, {planes!r}")


def _simple_affine(rng: random.Random) -> Iterator[Case]:
    for d, most in _MOST_PLANES.items():
        for m in range(2, most + 1):
            planes = simple_arrangement(rng, m, d, affine=True)
            yield arrangement_case(planes, f"d = {d}, m = {m}, simple affine")


def _bound(planes: Arrangement) -> tuple[int, ...]:
    d, m = planes.dimension, len(planes)
    return tuple(counts.fukuda_bound(m, d, k) for k in range(d + 1))


def _explain_count(planes: Arrangement, states: Any) -> str:
    m, printed = len(planes), STATE_COUNTS.get(len(planes))
    if states == printed:
        return ""
    if m == 2:
        return f"printed {printed}: the steps list the one line twice, once for each cycle"
    return f"printed {printed}: the steps leave out the origin, where all contacts stick"


def _explain_published(planes: Arrangement, listed: Any) -> str:
    printed = STATE_COUNTS[len(planes)]
    true = _states_counted(planes)
    return f"printed {printed}; different states of rigid motion: {true}"


def _general_f(m: int) -> tuple[int, ...]:
    """Return the closed form of the f-vector in general position, m >= 3."""
    return (1, m * (m - 1), 2 * m * (m - 1), _most_regions(m))


def _counted_cases(rng: random.Random) -> Iterator[Case]:
    yield from types_and_samples(10)(rng)
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


def _graph_traced(planes: Arrangement) -> tuple[int, int]:
    sphere = sphere_arrangement(planes)
    return sphere.region_count, sphere.arc_count


def _growth(count: Callable[[int], int]) -> Callable[[Arrangement, object], str]:
    """Show the exponent between m / 2 and m planes in general position, from closed forms."""

    def explain(planes: Arrangement, _: object) -> str:
        m = len(planes)
        if m < 8 or not planes.is_simple:
            return ""
        exponent = math.log2(count(m) / count(m // 2))
        return f"grows like m^{exponent:.2f} from {m // 2} to {m} planes in general position"

    return explain


def _most_regions(m: int) -> int:
    return m * m - m + 2


def _work(m: int) -> int:
    """E^3 + V E^2 log2 V, rounded down, for planes in general position."""
    v, e = _most_regions(m), 2 * m * (m - 1)
    return e**3 + v * e * e * v.bit_length()


def _enumerated(planes: Arrangement) -> tuple[int, ...]:
    return planes.faces().f_vector


CLAIMS = (
    stated(
        "great-circle-regions",
        circles=lambda planes: sphere_arrangement(planes).region_count,
        chi=counts.region_count,
        judge=_region_maximum,
        many_types=_region_maxima,
        cases=types_and_samples(12, per_count=4),
    ),
    stated(
        "slip-state-counts",
        steps=lambda planes: len(published_enumeration(planes).states),
        theorem=_published_predicted,
        judge=lambda planes, listed: listed == STATE_COUNTS[len(planes)],
        cases=_in_general_position(*STATE_COUNTS),
        explain=_explain_published,
    ),
    stated(
        "different-slip-states",
        enumeration=lambda planes: len({face.signs for face in planes.faces()}),
        theorem=_states_counted,
        judge=lambda planes, states: states == STATE_COUNTS[len(planes)],
        cases=_in_general_position(*STATE_COUNTS),
        search=lambda: smallest_arrangements(range(2, 4), distinct=True),
        explain=_explain_count,
    ),
    stated(
        "state-formula",
        enumeration=_enumerated,
        theorem=counts.f_vector,
        judge=lambda planes, f: f == _general_f(len(planes)),
        cases=_simple_types,
    ),
    stated(
        "fukuda-bound",
        enumeration=_enumerated,
        theorem=counts.f_vector,
        judge=lambda planes, f: at_most(f, _bound(planes)),
        cases=_bound_cases,
    ),
    stated(
        "fukuda-bound-attained",
        enumeration=_enumerated,
        theorem=counts.f_vector,
        judge=lambda planes, f: f == _bound(planes),
        cases=_simple_affine,
    ),
    stated(
        "bound-not-attained",
        enumeration=_enumerated,
        theorem=counts.f_vector,
        judge=lambda planes, f: sum(f) < sum(_bound(planes)),
        cases=types_and_samples(10),
        covers=lambda planes: len(planes) >= 4,
        search=lambda: smallest_arrangements(range(1, 4), 1),
    ),
    stated(
        "step-1-square-bound",
        enumeration=lambda planes: planes.faces().f_vector[3],
        chi=counts.region_count,
        judge=lambda planes, regions: regions <= len(planes) ** 2,
        cases=types_and_samples(12),
        covers=lambda planes: len(planes) >= 2,
        search=lambda: smallest_arrangements(range(1, 4), 1),
    ),
    stated(
        "step-1-time",
        regions=_tests_by_signs,
        chi=_tests_by_theorem,
        judge=lambda planes, tests: tests <= len(planes) ** 3,
        cases=_counted_cases,
        explain=_growth(lambda m: 1 + sum(map(_most_regions, range(1, m)))),
    ),
    stated(
        "step-2-time",
        regions=lambda planes: sum(1 for _ in combinations(_signs(planes), 2)),
        chi=lambda planes: math.comb(counts.region_count(planes), 2),
        judge=lambda planes, pairs: pairs <= len(planes) ** 4,
        cases=_counted_cases,
        explain=_growth(lambda m: math.comb(_most_regions(m), 2)),
    ),
    stated(
        "step-3-time",
        circles=_graph_traced,
        theorem=lambda planes: counts.f_vector(planes)[3:1:-1],
        judge=lambda planes, found: (
            found[0] <= _most_regions(len(planes)) and found[1] <= 2 * len(planes) ** 2
        ),
        cases=_counted_cases,
        explain=_growth(_work),
    ),
)
