"""Checks of a great-circle arrangement: topology first, then geometry, each failure named.

Nothing of the construction is used: permutations are counted in cycles, Euler's relation is
evaluated, and every sign is computed again from normals and rays.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from arrangement.enumeration.great_circles.incidence import Incidence, Indices
from arrangement.enumeration.sequence import primitive_rows
from arrangement.errors import ArrangementError
from arrangement.numbers.exact import IntegerVector

from .predicates import Integers, integer_array, turns


def check_topology(incidence: Incidence) -> None:
    """Check that the half-edges form a subdivision of the sphere with an antipodal symmetry."""
    if incidence.arc_count == 0:
        _require(incidence.region_count == 1, "without arcs there is one region", 0)
        return
    following, origin, region = incidence.next, incidence.origin, incidence.region
    half_edges = np.arange(len(following), dtype=np.int32)
    seen = np.bincount(following, minlength=len(following))
    _require_all(seen == 1, "each half-edge follows exactly one other: half-edge")
    _require_all(
        origin[following] == origin[half_edges ^ 1], "an arc leads on from its end: half-edge"
    )
    _require_all(region[following] == region, "a boundary stays in one region: half-edge")
    _require_all(
        region[incidence.leader] == np.arange(incidence.region_count),
        "a leader lies on its region: region",
    )
    cycles = _cycle_count(following)
    _require(cycles == incidence.region_count, "each region has one boundary cycle", cycles)
    if incidence.vertex_count:
        _check_vertices(incidence)
    _check_antipodes(incidence)


def _check_vertices(incidence: Incidence) -> None:
    """Check the stars of the vertices, connectedness and Euler's relation."""
    following, origin = incidence.next, incidence.origin
    used = np.unique(origin)
    _require(
        np.array_equal(used, np.arange(incidence.vertex_count)), "each vertex has arcs", len(used)
    )
    twins = np.arange(len(following), dtype=np.int32) ^ 1
    stars = _cycle_count(following[twins])
    _require(stars == incidence.vertex_count, "the arcs around a vertex form one cycle", stars)
    pieces = _components(origin, origin[twins])
    _require(pieces == 1, "the circles are connected", pieces)
    euler = incidence.vertex_count - incidence.arc_count + incidence.region_count
    _require(euler == 2, "V - E + F = 2", euler)


def _check_antipodes(incidence: Incidence) -> None:
    """Check that the antipodal map reverses all boundaries and fixes no region."""
    half_edges = np.arange(len(incidence.next), dtype=np.int32)
    opposite = 2 * incidence.arc_antipode[half_edges >> 1] + 1 - (half_edges & 1)
    reversed_ = incidence.next[opposite[incidence.next]]
    _require_all(reversed_ == opposite, "the antipodal map reverses boundaries: half-edge")
    antipode = incidence.region_antipode
    regions = np.arange(incidence.region_count)
    _require_all(antipode != regions, "no region is its own antipode: region")
    _require_all(antipode[antipode] == regions, "antipodes come in pairs: region")


def check_geometry(
    incidence: Incidence, circle_normals: Sequence[IntegerVector], rays: Integers
) -> None:
    """Check rays, arcs and corners against the normals, exactly.

    ``|det(n, u, v)| <= 24 B^5`` for rays u, v with entries up to ``2 B^2``.
    """
    normals = integer_array(circle_normals, degree_bound=5, factor=24)
    rays = rays.astype(normals.dtype)
    lines = incidence.vertex_count // 2
    _require_all((rays[lines:] == -rays[:lines]).all(axis=1), "antipodal rays are opposite: line")
    _require_all(
        turns((rays[:lines, 0], rays[:lines, 1], rays[:lines, 2])) == 1,
        "the first ray of a line is positive: line",
    )
    _require(_distinct(rays) == len(rays), "all rays are different", _distinct(rays))
    circle = normals[incidence.arc_circle]
    start, end = rays[incidence.origin[0::2]], rays[incidence.origin[1::2]]
    _require_all(_dot(circle, start) == 0, "an arc starts on its circle: arc")
    _require_all(_dot(circle, end) == 0, "an arc ends on its circle: arc")
    if lines == 1:  # rank 2
        return
    _require_all(
        _dot(circle, np.cross(start, end)) > 0,
        "an arc runs counterclockwise for less than half a turn: arc",
    )
    beyond = rays[incidence.origin[incidence.next[incidence.next]]]
    for side, sign in ((0, 1), (1, -1)):
        left = sign * _dot(circle, beyond[side::2]) > 0
        _require_all(left, "a region's boundary turns left at each corner: arc")


def _distinct(rays: Integers) -> int:
    """Return the number of different directions among integer vectors."""
    primitive = primitive_rows(rays)
    if primitive.dtype == object:
        return len({tuple(row) for row in primitive.tolist()})
    ordered = primitive[np.lexsort(primitive.T)]
    return 1 + int((ordered[1:] != ordered[:-1]).any(axis=1).sum())


def _dot(left: Integers, right: Integers) -> Integers:
    products: Integers = (left * right).sum(axis=1)
    return products


def _cycle_count(permutation: Indices) -> int:
    return _components(np.arange(len(permutation)), permutation)


def _components(tails: NDArray[np.integer], heads: NDArray[np.integer]) -> int:
    """Return the number of connected components of a graph on 0, 1, ..., max.

    The roots of trees are hooked to smaller roots beside them, until no edge joins two trees.
    """
    parents = np.arange(int(max(tails.max(), heads.max())) + 1)
    while True:
        one, other = parents[tails], parents[heads]
        if (one == other).all():
            return int((parents == np.arange(len(parents))).sum())
        np.minimum.at(parents, np.maximum(one, other), np.minimum(one, other))
        while (parents[parents] != parents).any():
            parents = parents[parents]


def _require(holds: bool, rule: str, found: int) -> None:
    if not holds:
        raise ArrangementError(f"not a great-circle arrangement: {rule} fails; found {found}")


def _require_all(holds: NDArray[np.bool_], rule: str) -> None:
    bad = np.nonzero(~np.asarray(holds, bool))[0]
    if len(bad):
        raise ArrangementError(
            f"not a great-circle arrangement: {rule} {bad[0]} breaks this rule ({len(bad)} in all)"
        )
