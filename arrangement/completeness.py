"""Completeness of an enumeration, certified by Zaslavsky's theorem.

If every listed face exists, no face is listed twice, and there are as many as the theorem says,
then none is missing. The count comes from `arrangement.counts`, which shares no code with any
enumerator; each face's existence is its own witness.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .counts import f_vector, region_count
from .exact import IntegerVector, primitive
from .float_filter import SMALLEST, certain, error_bound, scaled
from .linear import rank
from .planes import Face, Planes

_MAX_PROBLEMS = 20
_BATCH = 4096


@dataclass(frozen=True)
class CompletenessEvidence:
    """What an enumeration was compared with, and what is wrong with it.

    Attributes:
        enumerated: numbers of listed faces of dimension 0, ..., d.
        theorem: the same numbers by Zaslavsky's theorem over all restrictions.
        problems: what failed, in words (the first 20); empty if and only if the list is complete
            and correct.
    """

    enumerated: tuple[int, ...]
    theorem: tuple[int, ...]
    problems: tuple[str, ...]

    @property
    def complete(self) -> bool:
        """Whether the list has every face exactly once, and nothing else."""
        return not self.problems

    def __bool__(self) -> bool:
        return self.complete


def certify_complete(arrangement: Planes, faces: Iterable[Face]) -> CompletenessEvidence:
    """Check that a list of faces is the whole list, each face once.

    For every face: its witness has its signs, and its dimension is d minus the rank of the
    planes through it. Together: no sign vector twice, and the f-vector of the theorem.

    Args:
        arrangement: any arrangement.
        faces: the list to check, whoever made it.

    Complexity: O(m d) exact operations for each face, and the count (`counts.f_vector`).

    >>> from arrangement import Arrangement
    >>> planes = Arrangement([[1, 0], [0, 1], [1, 1]])
    >>> evidence = certify_complete(planes, planes.faces())
    >>> evidence.complete, evidence.theorem
    (True, (1, 6, 6))
    """
    listed = tuple(faces)
    theorem = f_vector(arrangement)
    problems: list[str] = []
    counted = [0] * (arrangement.dimension + 1)
    ranks: dict[tuple[int, ...], int] = {}
    seen: set[tuple[int, ...]] = set()
    for start in range(0, len(listed), _BATCH):
        batch = listed[start : start + _BATCH]
        for face, signs in zip(batch, _signs_at_witnesses(arrangement, batch), strict=True):
            problem = _problem(arrangement, face, signs, ranks)
            if problem is None and face.signs in seen:
                problem = "is listed twice"
            seen.add(face.signs)
            if problem is None:
                counted[face.dimension] += 1
            else:
                problems.append(f"face {face.signs} {problem}")
    for k, (here, there) in enumerate(zip(counted, theorem, strict=True)):
        if here != there:
            problems.append(f"{here} faces of dimension {k} hold; there are {there}")
    return CompletenessEvidence(tuple(counted), theorem, tuple(problems[:_MAX_PROBLEMS]))


def regions_problem(
    arrangement: Planes,
    signs: npt.NDArray[np.int8],
    points: Sequence[Sequence[int]],
    *,
    rationals_only: bool = False,
) -> str:
    """Return what is wrong with a list of all regions, in words; empty if it is complete.

    Args:
        arrangement: in R^d.
        signs: one row over the input planes for each region.
        points: one for each, as d + 1 integers ``(X, W)`` with W > 0 for the point ``X / W``.
        rationals_only: do without floats. Otherwise a sign is found in floating point where a
            bound of its error allows, and in integers elsewhere.

    Every point has the signs of its row, none of them 0; no row comes twice; and there are as many
    as Zaslavsky's theorem says (`counts.region_count`).
    """
    if signs.shape != (len(points), len(arrangement)):
        return f"{len(points)} points and signs of the shape {signs.shape} do not fit"
    if any(len(point) != arrangement.dimension + 1 or point[-1] <= 0 for point in points):
        return "a witness has too few or too many coordinates, or no positive denominator"
    if not np.all(signs):
        return "a region has a sign 0"
    wrong = _first_wrong(arrangement, signs, points, rationals_only)
    if wrong is not None:
        return f"region {wrong} has a witness with other signs"
    distinct = len({row.tobytes() for row in signs})
    if distinct < len(signs):
        return f"{len(signs) - distinct} regions are listed twice"
    due = region_count(arrangement)
    return "" if distinct == due else f"{distinct} regions hold; there are {due}"


def _first_wrong(
    arrangement: Planes,
    signs: npt.NDArray[np.int8],
    points: Sequence[Sequence[int]],
    rationals_only: bool,
) -> int | None:
    """Return the first point whose signs are not those of its row."""
    planes = arrangement.integer_planes
    surely = np.zeros(signs.shape, dtype=bool)
    if not rationals_only and planes and points:
        surely = _surely(planes, signs, points)
    for i in np.flatnonzero(~surely.all(axis=1)).tolist():
        *place, scale = points[i]
        for j in np.flatnonzero(~surely[i]).tolist():
            *normal, offset = planes[j]
            value = sum(a * b for a, b in zip(normal, place, strict=True)) - offset * scale
            if (value > 0) - (value < 0) != signs[i, j]:
                return int(i)
    return None


def _surely(
    planes: Sequence[IntegerVector],
    signs: npt.NDArray[np.int8],
    points: Sequence[Sequence[int]],
) -> npt.NDArray[np.bool_]:
    """Return where the sign at a point is proven to be the given one, in floating point.

    Each of the d + 1 products has two rounded factors, its own rounding and d sums. Coordinates
    are integers, so that no product of them underflows.
    """
    coefficients, usable = scaled(planes)
    try:
        coordinates = np.array(points, dtype=np.float64)
    except OverflowError:
        return np.zeros(signs.shape, dtype=bool)
    coordinates[:, -1] *= -1
    sizes = np.abs(coordinates) @ np.abs(coefficients).T
    values = coordinates @ coefficients.T
    found = certain(values, sizes, error_bound(3 + coordinates.shape[1] - 1))
    found &= (values > 0) == (signs > 0)
    found &= usable & np.all(np.abs(coordinates) < 1 / SMALLEST, axis=1, keepdims=True)
    return found


def _problem(
    arrangement: Planes,
    face: Face,
    signs: tuple[int, ...] | None,
    ranks: dict[tuple[int, ...], int],
) -> str | None:
    """Return what is wrong with one face, given the signs at its witness, or None."""
    if signs is None:
        return f"has a witness with {len(face.witness)} coordinates"
    if signs != face.signs:
        return f"has a witness {tuple(map(str, face.witness))} with other signs"
    zero = tuple(i for i, sign in enumerate(signs) if sign == 0)
    if zero not in ranks:
        ranks[zero] = rank([arrangement.integer_planes[i][:-1] for i in zero])
    dimension = arrangement.dimension - ranks[zero]
    if face.dimension != dimension:
        return f"has dimension {dimension}, not {face.dimension}"
    return None


def _signs_at_witnesses(arrangement: Planes, faces: Sequence[Face]) -> list[tuple[int, ...] | None]:
    """Return the sign vector at every witness, or None for one with too few or many coordinates.

    Exact: a sum of d + 1 products of integers, in int64 when its bound fits, else in Python's.
    """
    d = arrangement.dimension
    fitting = [len(face.witness) == d for face in faces]
    points = [
        primitive((*face.witness, -1)) for face, fits in zip(faces, fitting, strict=True) if fits
    ]
    planes = arrangement.integer_planes
    if not points or not planes:
        return [() if fits else None for fits in fitting]
    bound = (d + 1) * _largest(points) * _largest(planes)
    kind = np.int64 if bound < 2**63 else object
    values = np.array(points, dtype=kind) @ np.array(planes, dtype=kind).T
    found = map(tuple, ((values > 0).astype(int) - (values < 0)).tolist())
    return [next(found) if fits else None for fits in fitting]


def _largest(rows: Iterable[Sequence[int]]) -> int:
    """Return the largest absolute value of an entry."""
    return max(abs(x) for row in rows for x in row)
