"""Claims on the number of slip states: regions, bounds, and the published row of counts."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import partial
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
    proved_on_types,
    random_arrangement,
    simple_arrangement,
    smallest_arrangements,
)
from proofs_check.instances.domains import domain
from proofs_check.instances.paper_tables import STATE_COUNTS
from proofs_check.routes.many_types import f_vectors
from proofs_check.statements.statement import (
    Case,
    Claim,
    Hypothesis,
    ManyTypes,
    Route,
    Verdict,
    View,
    exhaustive,
    proved,
    sampled,
)

ENUMERATION = "enumeration of all faces"
THEOREM = "Zaslavsky's theorem on the intersection lattice"


def _states_enumerated(planes: Arrangement) -> int:
    return len({face.signs for face in planes.faces()})


def _states_counted(planes: Arrangement) -> int:
    return sum(counts.f_vector(planes))


def _published_predicted(planes: Arrangement) -> int:
    """Regions V, facets E, and E - V + 2 cycles, from the theorem alone."""
    _, _, edges, vertices = counts.f_vector(planes)
    return vertices + edges + (edges - vertices + 2)


def _general_position(rng: random.Random) -> Iterator[Case]:
    for m in STATE_COUNTS:
        yield arrangement_case(simple_arrangement(rng, m), f"m = {m}")


def _simple_types(rng: random.Random) -> Iterator[Case]:
    yield from census_cases(TYPES, simple=True)
    yield from (arrangement_case(simple_arrangement(rng, m)) for m in range(8, 16))


def _region_maximum(planes: Arrangement, regions: int) -> bool:
    """At most m^2 - m + 2, with equality exactly for distinct planes in general position."""
    m = len(planes)
    simple = planes.is_simple and len(planes.distinct) == m
    return regions <= m * m - m + 2 and (regions == m * m - m + 2) == simple


def _region_maxima(signs: Signs, n: int) -> Booleans:
    regions, most = f_vectors(signs, n)[:, 2], n * n - n + 2
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


def _below_bound(planes: Arrangement, f: tuple[int, ...]) -> bool:
    return all(number <= bound for number, bound in zip(f, _bound(planes), strict=True))


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


_COLUMNS = exhaustive(
    "the 8 printed columns, one arrangement in general position each", _general_position
)
_on_f_vectors = partial(
    Claim,
    quantity="f-vector",
    routes=(
        Route(ENUMERATION, lambda planes: planes.f_vector),
        Route(THEOREM, counts.f_vector),
    ),
)

CLAIMS = (
    Claim(
        id="great-circle-regions",
        views=(
            View(
                "sphere",
                "Four great circles in general position: 14 regions, half of them in front.",
                instance=Arrangement([(1, 1, 1), (1, 1, -1), (1, -1, 1), (-1, 1, 1)]).to_dict(),
            ),
        ),
        formula=r"f_3 \le m^2 - m + 2",
        proof=("Great circles", "Regions"),
        domain=domain("central"),
        locator="Section IV-A",
        statement="m great circles cut the sphere into at most m^2 - m + 2 regions, with equality "
        "exactly when no two coincide and no three pass through one point.",
        quantity="number of regions",
        routes=(
            Route(
                "great circles: arcs traced around regions",
                lambda planes: sphere_arrangement(planes).region_count,
            ),
            Route("|chi(-1)| of the characteristic polynomial", counts.region_count),
        ),
        judge=_region_maximum,
        many_types=ManyTypes("regions composed from cocircuits and counted", _region_maxima),
        sources=proved_on_types(12, per_count=4),
        meaning="The quadratic bound on slip states rests on this.",
    ),
    Claim(
        id="slip-state-counts",
        formula=r"\text{listed}(m) = 4m^2 - 4m + 2, \quad m = 2, \ldots, 9",
        locator="Table II",
        statement="For m = 2, ..., 9 contacts in general position the published Steps 1 to 3 list "
        "10, 26, 50, 82, 122, 170, 226, 290 slip states.",
        hypotheses=("the m tangential planes are in general position",),
        quantity="number of states listed, repeats counted",
        routes=(
            Route(
                "Steps 1 to 3 as published, run",
                lambda planes: len(published_enumeration(planes).states),
            ),
            Route("V + E + (E - V + 2) from Zaslavsky's theorem", _published_predicted),
        ),
        judge=lambda planes, listed: listed == STATE_COUNTS[len(planes)],
        sources=_COLUMNS,
        explain=_explain_published,
        meaning="The printed row is what the published steps list. It is 4m^2 - 4m + 2.",
        rows=True,
    ),
    Claim(
        id="different-slip-states",
        formula=r"f_0 + f_1 + f_2 + f_3 = 4m^2 - 4m + 2",
        locator="Table II; Section IV-A",
        statement="The printed numbers are the numbers of different slip states that rigid motion "
        "allows for m = 2, ..., 9 contacts in general position.",
        hypotheses=("the m tangential planes are in general position",),
        quantity="number of different sign vectors",
        routes=(Route(ENUMERATION, _states_enumerated), Route(THEOREM, _states_counted)),
        judge=lambda planes, states: states == STATE_COUNTS[len(planes)],
        sources=_COLUMNS,
        expected=Verdict.REFUTED,
        search=lambda: smallest_arrangements(range(2, 4), distinct=True),
        explain=_explain_count,
        meaning="There are 4m^2 - 4m + 3 for m >= 3: the all-stick state is missing from the "
        "printed count. The order of growth stays.",
        rows=True,
    ),
    _on_f_vectors(
        id="state-formula",
        formula=r"(f_0, f_1, f_2, f_3) = (1, m(m-1), 2m(m-1), m^2 - m + 2)",
        proof=("Great circles", "All faces"),
        domain=domain("simple"),
        locator="Section IV-A",
        statement="m >= 3 planes through the origin of R^3 in general position have "
        "4m^2 - 4m + 3 slip states: 1 origin, m(m-1) rays, 2m(m-1) facets, m^2 - m + 2 regions.",
        hypotheses=("m >= 3", "general position"),
        judge=lambda planes, f: f == _general_f(len(planes)),
        sources=proved(
            "checked on all 18 simple types of 3 to 7 planes; beside them one sample for each "
            "m = 8, ..., 15",
            _simple_types,
        ),
        meaning="The number of slip states is quadratic in the number of contacts, as stated.",
    ),
    _on_f_vectors(
        id="fukuda-bound",
        formula=r"f_k \le \binom{n}{d-k} \sum_{i=0}^{k} \binom{n-d+k}{i}",
        proof=("Hyperplanes in any dimension", "Faces"),
        domain=domain("affine"),
        locator="Eq. 11",
        statement="n planes in R^d have at most C(n, d-k) * sum_{i<=k} C(n-d+k, i) faces of "
        "dimension k.",
        judge=_below_bound,
        sources=proved(
            "checked on central and affine arrangements in R^1 to R^4, degenerate ones included",
            _bound_cases,
        ),
    ),
    _on_f_vectors(
        id="fukuda-bound-attained",
        formula=r"f_k = \binom{n}{d-k} \sum_{i=0}^{k} \binom{n-d+k}{i}",
        domain=domain("simple-affine"),
        locator="Eq. 11",
        statement="Affine arrangements in general position attain the bound for every k.",
        hypotheses=("affine", "general position"),
        judge=lambda planes, f: f == _bound(planes),
        sources=sampled(
            "one simple affine arrangement for each d = 1, ..., 4 and m up to 8, 8, 7, 6",
            _simple_affine,
        ),
    ),
    _on_f_vectors(
        id="bound-not-attained",
        formula=r"\sum_k f_k \lt \sum_{k=0}^{3} \binom{m}{3-k} \sum_{i=0}^{k} \binom{m-3+k}{i}",
        proof=("Great circles", "All faces"),
        domain=domain("central"),
        locator="Section IV-A, after Eq. 11",
        statement="The upper bound is not attained by the tangential planes of m contacts.",
        hypotheses=("the planes pass through the origin of R^3",),
        judge=lambda planes, f: sum(f) < sum(_bound(planes)),
        sources=proved_on_types(10),
        expected=Verdict.HOLDS_UNDER_HYPOTHESIS,
        hypothesis=Hypothesis("m >= 4", lambda planes: len(planes) >= 4),
        search=lambda: smallest_arrangements(range(1, 4), 1),
        meaning="Independent planes, of which there are at most three here, attain the bound.",
    ),
    Claim(
        id="step-1-square-bound",
        formula=r"f_3 \le m^2",
        proof=("Great circles", "Regions"),
        domain=domain("central"),
        locator="Section IV-B, running time of Step 1",
        statement="After Step 1 there are at most m^2 states.",
        quantity="number of regions",
        routes=(
            Route(ENUMERATION, lambda planes: planes.f_vector[3]),
            Route("|chi(-1)| of the characteristic polynomial", counts.region_count),
        ),
        judge=lambda planes, regions: regions <= len(planes) ** 2,
        sources=proved_on_types(12),
        expected=Verdict.HOLDS_UNDER_HYPOTHESIS,
        hypothesis=Hypothesis("m >= 2", lambda planes: len(planes) >= 2),
        search=lambda: smallest_arrangements(range(1, 4), 1),
        meaning="One contact has two slip states in Step 1. The order of growth stays.",
    ),
)


def _general_f(m: int) -> tuple[int, ...]:
    """The closed form of the f-vector in general position, m >= 3."""
    return (1, m * (m - 1), 2 * m * (m - 1), m * m - m + 2)
