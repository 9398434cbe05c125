"""Contact modes counted, not listed: faces of a cone by their generators, then by flats.

A contacting-separating mode is a face of the cone ``{d : N d >= 0}``, known by the generators that
it contains. The sliding-sticking modes on it are counted by the theorem of Zaslavsky in its span
(`f_vector_in_cone`). No face of an arrangement is listed.
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul

from arrangement.counts.configuration import pivot_columns
from arrangement.counts.lattice import IntersectionLattice
from arrangement.numbers.exact import IntegerVector, bits, dot
from arrangement.numbers.linear.cones import Cone, generators
from arrangement.planes.planes import Planes


def mode_counts(
    normals: Sequence[IntegerVector], tangents: Sequence[Sequence[IntegerVector]], n: int
) -> tuple[int, int]:
    """Return how many contacting-separating and sliding-sticking modes there are.

    Args:
        normals: m integer rows of length n, one for each contact.
        tangents: for each contact the rows of its tangent planes.

    >>> mode_counts([(1, 0)], [[(0, 1)]], 2)
    (2, 4)
    """
    rays, lines = generators(normals, [], n)
    everything = (1 << len(rays)) - 1
    walls = [sum(1 << j for j, ray in enumerate(rays) if not dot(row, ray)) for row in normals]
    faces = {everything}
    for wall in walls:
        faces |= {face & wall for face in faces}
    total = 0
    for face in faces:
        spanning = [*(rays[j] for j in bits(face)), *lines]
        kept = pivot_columns(list(zip(*spanning, strict=True)), len(spanning)) if spanning else ()
        basis = [spanning[i] for i in kept]
        touching = [wall & face == face for wall in walls]
        slips = [
            [dot(row, x) for x in basis]
            for rows, touches in zip(tangents, touching, strict=True)
            for row in (rows if touches else ())
        ]
        gaps = [
            tuple(dot(row, x) for x in basis)
            for row, touches in zip(normals, touching, strict=True)
            if not touches
        ]
        planes = Planes([row for row in slips if any(row)], dimension=len(basis))
        total += sum(f_vector_in_cone(planes, gaps))
    return len(faces), total


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
        cone_of: dict[int, Cone] = {}
        position: dict[int, int] = {}
        above = []
        for mask, cone in zip(masks[-1], cones, strict=True):
            flats = _covers_in_cone(cone, mask, normals, inequalities)
            cone_of.update(flats)
            above.append(tuple(position.setdefault(flat, len(position)) for flat in flats))
        covers.append(tuple(above))
        if position:
            masks.append(tuple(position))
        cones = [cone_of[flat] for flat in position]
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
    cone_of: dict[int, Cone] = {}
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
            cone_of[flat] = part
            seen |= flat
    return cone_of


def _meets(cone: Cone, inequalities: Sequence[IntegerVector]) -> bool:
    """Return whether a cone, where the inequalities are >= 0, has a point where all are > 0."""
    rays, _ = cone.generators
    return all(any(sum(map(mul, row, ray)) for ray in rays) for row in inequalities)
