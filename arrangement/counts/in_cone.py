"""Faces inside an open cone, counted from the flats that meet it."""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul

from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.linear.cones import Cone
from arrangement.planes.planes import Planes

from .lattice import IntersectionLattice


def f_vector_in_cone(planes: Planes, inequalities: Sequence[IntegerVector]) -> tuple[int, ...]:
    """Return (f_0, ..., f_d), the faces of central planes inside ``{x : a . x > 0}``.

    Planes cut an open convex set K in as many regions as the sum of |mu(X)| over the flats X that
    meet K. [Zaslavsky1977] The flats in an interval between two that meet K all do, so mu is that
    of all planes; and the faces in a flat X are the regions of the planes in X. Whether a flat
    meets the cone is read off the generators of their intersection.

    Args:
        planes: central; coincident ones count once.
        inequalities: integer rows a; with none the cone is the whole space.

    >>> from arrangement import Arrangement
    >>> f_vector_in_cone(Arrangement([[1, -1], [1, 1]]), [(1, 0), (0, 1)])
    (0, 1, 2)
    """
    cone = Cone(planes.dimension)
    for row in inequalities:
        cone.cut(row, keep_positive=True)
    missing = planes.dimension + 1
    if not _meets(cone, inequalities):
        return (0,) * missing
    normals = [plane[:-1] for plane in planes.distinct_planes]
    masks: list[tuple[int, ...]] = [(0,)]
    covers: list[tuple[tuple[int, ...], ...]] = []
    cones = [cone]
    while cones:
        found: dict[int, Cone] = {}
        position: dict[int, int] = {}
        above = []
        for mask, cone in zip(masks[-1], cones, strict=True):
            flats = _covers_in_cone(cone, mask, normals, inequalities)
            found.update(flats)
            above.append(tuple(position.setdefault(flat, len(position)) for flat in flats))
        covers.append(tuple(above))
        if position:
            masks.append(tuple(position))
        cones = [found[flat] for flat in position]
    rows = IntersectionLattice(planes, tuple(masks), tuple(covers)).whitney_matrix
    sums = [sum(row) for row in rows]
    return (0,) * (missing - len(sums)) + tuple(reversed(sums))


def _covers_in_cone(
    cone: Cone, mask: int, normals: Sequence[IntegerVector], inequalities: Sequence[IntegerVector]
) -> dict[int, Cone]:
    """Return the flats one rank above that meet the cone, with their parts of it.

    Such a part is open in its flat, so its generators span it and determine which planes contain
    it.
    """
    found: dict[int, Cone] = {}
    seen = mask
    for i, normal in enumerate(normals):
        if seen >> i & 1:
            continue
        part = cone.copy()
        part.cut(normal, keep_positive=False)
        if _meets(part, inequalities):
            rays, lines = part.generators
            flat = sum(
                1 << j
                for j, other in enumerate(normals)
                if not any(sum(map(mul, other, x)) for x in (*rays, *lines))
            )
            found[flat] = part
            seen |= flat
    return found


def _meets(cone: Cone, inequalities: Sequence[IntegerVector]) -> bool:
    """Return whether a cone, where the inequalities are >= 0, has a point where all are > 0."""
    rays, _ = cone.generators
    return all(any(sum(map(mul, row, ray)) for ray in rays) for row in inequalities)
