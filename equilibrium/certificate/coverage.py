"""Which contact states a proof of instability has to refute, found from the list of cells alone.

For a motion d let F be the intersection of the tangential planes through d, and Y a region of the
arrangement restricted to F whose closure holds d. On Y each ``T_i . d`` has the sign that it has at
d; a contact whose normal plane passes through d has no force there. So an equilibrium at d
satisfies the closed conditions of the states on Y, and the states on all such regions Y are due.

The regions of a restriction follow from those of the whole. A facet in a plane separates two
regions whose signs differ for that plane only, and any two such regions have it between them.
Within the plane the same holds for an edge, with all planes through its line in place of one.
This is the checker's own way; the solver has another.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.exact import sign
from arrangement.linear import rank
from arrangement.planes import Planes

#: Rows of signs, or of contact states: 0 stick, +1 and -1 slip, 2 detached.
Rows: TypeAlias = npt.NDArray[np.int8]
_Hashes: TypeAlias = npt.NDArray[np.uint64]

DETACHED = 2


def due_states(planes: Planes, regions: Rows) -> Rows:
    """Return the contact states to refute, as distinct rows in the order of `sorted_rows`.

    Args:
        planes: the m planes ``T . d = 0``, then the m planes ``stiffness N . d = preload``.
        regions: the signs of all its regions over these planes, each once.

    Two rows are taken as equal when their 64-bit hashes are. A false match, were there one, would
    only ask for one more refutation.
    """
    m = len(planes) // 2
    first = [members[0] for members in planes.distinct]
    tangential = sorted({planes.class_of[i] for i in range(m)})
    over_classes = regions[:, first]
    found = [_states(planes, over_classes)]
    keys = np.random.default_rng(2018).integers(0, 2**64, len(first), dtype=np.uint64)
    hashes = _hashes(over_classes, keys)
    for one in tangential:
        facets, facet_hashes = _between(over_classes, hashes, [one], one, keys)
        found.append(_states(planes, facets))
        for other in (c for c in tangential if c > one):
            through = _through_line(planes, first, one, other)
            edges, _ = _between(facets, facet_hashes, through, other, keys)
            found.append(_states(planes, edges))
    if rank([planes.integer_planes[i][:-1] for i in range(m)]) == 3:
        at_rest = [[-sign(planes.integer_planes[i][-1]) for i in first]]
        found.append(_states(planes, np.array(at_rest, dtype=np.int8)))
    return sorted_rows(np.concatenate(found))


def sorted_rows(rows: Rows) -> Rows:
    """Return rows of contact states without repeats, in lexicographic order."""
    count, m = rows.shape
    if not count or not m:
        return rows[:1]
    packed = np.ascontiguousarray((rows + 2).astype(np.uint8)).view(f"S{m}")
    # No entry is a zero byte, so none is lost at the end of a text.
    distinct = np.unique(packed.reshape(count))
    return (distinct.view(np.uint8).reshape(-1, m) - 2).astype(np.int8)


def _states(planes: Planes, signs: Rows) -> Rows:
    """Return the contact states on faces given by signs over the classes of planes."""
    m = len(planes) // 2
    columns = np.array(planes.class_of, dtype=np.intp)
    oriented = signs[:, columns] * np.array(planes.orientation, dtype=np.int8)
    states: Rows = np.where(oriented[:, m:] >= 0, np.int8(DETACHED), oriented[:, :m])
    return states


def _between(
    rows: Rows, hashes: _Hashes, through: Sequence[int], side: int, keys: _Hashes
) -> tuple[Rows, _Hashes]:
    """Return the faces between two rows on the two sides of a plane that agree elsewhere.

    Args:
        hashes: of the rows.
        through: the classes of planes that hold these faces, `side` among them.

    Returns:
        The faces, with zeros at `through`, and their hashes.
    """
    elsewhere = hashes.copy()
    for column in through:
        elsewhere ^= np.where(rows[:, column] > 0, keys[column], np.uint64(0))
    positive = rows[:, side] > 0
    above, below = np.flatnonzero(positive), np.flatnonzero(~positive)
    order = above[np.isin(elsewhere[above], elsewhere[below])]
    faces = rows[order]
    faces[:, list(through)] = 0
    return faces, elsewhere[order]


def _hashes(rows: Rows, keys: _Hashes) -> _Hashes:
    """Return a hash of each row: of its positive entries."""
    hashes = np.zeros(len(rows), dtype=np.uint64)
    for column, key in enumerate(keys):
        hashes ^= np.where(rows[:, column] > 0, key, np.uint64(0))
    return hashes


def _through_line(planes: Planes, first: Sequence[int], one: int, other: int) -> list[int]:
    """Return the classes that hold the line of two planes through the origin, these included."""
    pair = [planes.integer_planes[first[c]][:-1] for c in (one, other)]
    (a, b, c), (d, e, f) = pair
    x, y, z = b * f - c * e, c * d - a * f, a * e - b * d
    return [
        index
        for index, member in enumerate(first)
        for (p, q, r, offset) in [planes.integer_planes[member]]
        if not offset and not p * x + q * y + r * z
    ]
