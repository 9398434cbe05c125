"""Contact modes counted, not listed: faces of a cone by their generators, then by flats.

A contacting-separating mode is a face of the cone ``{d : N d >= 0}``, known by the generators that
it contains. The sliding-sticking modes on it are counted by the theorem of Zaslavsky in its span
(`arrangement.counts.in_cone`). No face of an arrangement is listed.
"""

from __future__ import annotations

from collections.abc import Sequence

from arrangement.counts.configuration import pivot_columns
from arrangement.counts.in_cone import f_vector_in_cone
from arrangement.numbers.exact import IntegerVector, bits, dot
from arrangement.numbers.linear.cones import generators
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
