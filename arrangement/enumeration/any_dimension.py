"""All faces of an arrangement in any dimension, with exact witnesses: the reference engine.

An affine arrangement in R^d is the part ``x_0 > 0`` of a central one in R^(d+1) that has one more
plane, ``x_0 = 0``. So only central arrangements are enumerated, over classes of coincident planes,
by arrays over one level at a time.

1. *Flats.* The intersections of planes are found level by level, each with a basis of its subspace.
   The planes that cut one flat F in the same flat G below it do so by multiples of one linear form
   on F. A vector of F beside G gives their signs on both sides of G: a *rise* from G into F.
2. *Faces.* From a face X in the flat G, each rise from G changes some signs 0 of X, and what
   comes out is a face one dimension up, in F, with X in its boundary. All faces are found so,
   from the smallest flat upwards.
3. *Witnesses.* Two different facets of one face are never both in a smaller face of it. So the
   sum of their witnesses lies inside the face.

Cost: polynomial in the output for fixed d. There are no more flats than faces; each flat is
cut by at most m planes, and every (facet, face) pair is visited once, in arrays: 16 planes in R^6
(289,000 faces) take about a second. Numbers, of a field too, are int64 coefficients wherever a
bound of their size allows, else Python integers: see `arrangement.numbers.coefficients`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers.coefficients import (
    Coefficients,
    Integers,
    for_products,
    largest_entry,
    primitive,
)
from arrangement.numbers.linear.rank import rank, unit_vectors
from arrangement.numbers.packing import Words, group_rows, pack, unpack
from arrangement.planes.planes import Planes

from .sequence import Level, Rows, Signs, no_faces

Indices: TypeAlias = NDArray[np.intp]

_ONE = np.uint64(1)
_PLUS = np.uint64(0x5555_5555_5555_5555)


def list_faces(planes: Planes) -> tuple[Level, ...]:
    """Return the faces of dimension 0, 1, ..., d."""
    first = planes.distinct_planes
    d, m = planes.dimension, len(planes)
    if planes.is_central:
        vectors = [plane[:-1] for plane in first]
        low, n, half = d - planes.rank, d, None
    else:
        vectors = [(-plane[-1], *plane[:-1]) for plane in first] + [unit_vectors(d + 1)[0]]
        low, n, half = d - rank(vectors), d + 1, len(first)
    numbers = Coefficients(vectors)
    levels = central_levels(numbers, numbers.array(vectors, n), half)
    listed = [_as_level(planes, numbers, faces) for faces in levels]
    return (*[no_faces(m, d)] * low, *listed[max(0, -low) :])


@dataclass(frozen=True, slots=True)
class CentralFaces:
    """The faces of one dimension of a central arrangement.

    Attributes:
        words: (F, W); their signs: class k has bit 2k for + and bit 2k + 1 for -.
        flats: (F); the flat that each one spans.
        points: (F, n, c); a point of each.
    """

    words: Words
    flats: Indices
    points: Integers


@dataclass(frozen=True, slots=True)
class _Rises:
    """The pairs of a flat and one above it, each with one of its two sides.

    Attributes:
        lower, upper: (P); the flats.
        words: (P, W); the signs, in the upper flat beside the lower one, of what contains the lower
            one and not the upper one.
        vectors: (P, n, c); from the lower flat to that side.
    """

    lower: Indices
    upper: Indices
    words: Words
    vectors: Integers


def central_levels(
    numbers: Coefficients, vectors: Integers, half: int | None
) -> list[CentralFaces]:
    """Return the faces of a central arrangement by rank, with integral witnesses.

    Args:
        numbers: the field.
        vectors: (m, n, c); pairwise independent normals in R^n.
        half: index of a plane; only the faces not on its negative side are wanted.

    Returns:
        Level j has the faces of dimension ``n - rank + j``.
    """
    positive = _unit_words(len(vectors))
    forbidden = positive[half] << _ONE if half is not None else np.zeros_like(positive[:1]).ravel()
    start = np.zeros((1, positive.shape[1]), np.uint64)
    origin = np.zeros((1, *vectors.shape[1:]), np.int64)
    levels = [CentralFaces(start, np.zeros(1, np.intp), origin)]
    for rises in reversed(_all_rises(numbers, vectors)):
        levels.append(_covers(levels[-1], rises, forbidden))
    return levels


def _covers(faces: CentralFaces, rises: _Rises, forbidden: Words) -> CentralFaces:
    """Return the faces one dimension above the given ones.

    Modulo the smallest flat, every closed face is a pointed cone. One of dimension two or more
    has at least two facets, so every face found here is found from two.
    """
    starts = np.searchsorted(rises.lower, faces.flats)
    counts = np.searchsorted(rises.lower, faces.flats, side="right") - starts
    face = np.repeat(np.arange(len(counts)), counts)
    rise = np.arange(len(face)) + np.repeat(starts - np.cumsum(counts) + counts, counts)
    words = faces.words[face] | rises.words[rise]
    allowed = ~(words & forbidden).any(axis=1)
    face, rise, words = face[allowed], rise[allowed], words[allowed]
    order, new = group_rows(words)
    first = order[new]
    if len(faces.words) == 1 and not faces.words.any():
        points = rises.vectors[rise[first]]
    else:
        second = order[np.flatnonzero(new) + 1]
        assert (words[second] == words[first]).all(), "a face with a single facet"
        points = for_products(faces.points, 2)
        points = points[face[first]] + points[face[second]]
    return CentralFaces(words[first], rises.upper[rise[first]], points)


def _all_rises(numbers: Coefficients, normals: Integers) -> list[_Rises]:
    """Return the rises between flats of neighbouring dimensions, from the whole space downwards."""
    m, n, c = normals.shape
    positive = _unit_words(m)
    bases = numbers.array(unit_vectors(n), n)[None]
    masks = np.zeros((1, positive.shape[1]), np.uint64)
    matrix = numbers.forms(normals)
    levels: list[_Rises] = []
    while True:
        shape = bases.shape[:2]
        joined = bases.reshape(*shape, n * c)
        forms = (for_products(joined, n * c * largest_entry(matrix)) @ matrix).reshape(*shape, m, c)
        flat, plane = np.nonzero(forms.any(axis=(1, 3)))
        if not len(flat):
            return levels
        rows, pivot, sides = numbers.unoriented(forms[flat, :, plane])
        beside = (sides > 0)[:, None]
        first, group = _group(np.column_stack([flat, rows.reshape(len(flat), -1)]))
        shape = (len(first), positive.shape[1])
        words, members = np.zeros(shape, np.uint64), np.zeros(shape, np.uint64)
        np.bitwise_or.at(words, group, np.where(beside, positive[plane], positive[plane] << _ONE))
        np.bitwise_or.at(members, group, positive[plane])
        members |= masks[flat[first]]
        chosen, lower = _group(members)
        upper, vectors_beside = flat[first], bases[flat[first], pivot[first]]
        levels.append(_both_sides(lower, upper, words, vectors_beside))
        masks, kept = members[chosen], first[chosen]
        bases = _cut(numbers, bases[flat[kept]], rows[kept], pivot[kept])


def _both_sides(lower: Indices, upper: Indices, words: Words, vectors: Integers) -> _Rises:
    """Return rises to the sides of these vectors and to the other ones, in the order of `lower`."""
    other = (words & _PLUS) << _ONE | (words >> _ONE) & _PLUS
    lower = np.concatenate([lower, lower])
    order = np.argsort(lower, kind="stable")
    return _Rises(
        lower[order],
        np.concatenate([upper, upper])[order],
        np.concatenate([words, other])[order],
        np.concatenate([vectors, -vectors])[order],
    )


def _cut(numbers: Coefficients, bases: Integers, forms: Integers, pivot: Indices) -> Integers:
    """Return bases of the subspaces, of those with the given bases, at which forms vanish.

    Args:
        bases: (F, k, n, c).
        forms: (F, k, c); the values at the basis vectors, not all 0.
        pivot: (F); where one is not 0, but rational.
    """
    rows, k = np.arange(len(bases)), bases.shape[1]
    others = np.arange(k - 1) + (np.arange(k - 1) >= pivot[:, None])
    factors = numbers.matrices(forms[rows[:, None], others])
    bases = for_products(
        bases, 2 * numbers.degree * max(largest_entry(forms), largest_entry(factors))
    )
    top, base = forms[rows, pivot, 0], bases[rows, pivot]
    left = top[:, None, None, None] * bases[rows[:, None], others]
    return primitive(left - base[:, None] @ factors)


def _as_level(planes: Planes, numbers: Coefficients, faces: CentralFaces) -> Level:
    """Return the faces with signs over the input planes; of a cone, those with x_0 > 0."""
    words, points, classes = faces.words, faces.points, len(planes.distinct)
    if planes.is_central:
        ones = np.broadcast_to(numbers.one, (len(points), 1, numbers.degree))
        points = np.concatenate([points, ones], axis=1)
    else:
        kept = (words & _unit_words(classes + 1)[-1]).any(axis=1)
        words, points = words[kept], np.roll(points[kept], -1, axis=1)
    columns = np.array(planes.class_of, np.intp)
    orientation = np.array(planes.orientation, np.int8)

    def signs(rows: Rows) -> Signs:
        bits = unpack(words[rows], 2 * classes).view(np.int8)
        return (bits[:, 0::2] - bits[:, 1::2])[:, columns] * orientation

    return Level(len(words), signs, lambda rows: numbers.numbers(points[rows]))


def _unit_words(classes: int) -> Words:
    """Return (classes, W); row k has the bit for + of class k alone."""
    return pack(np.eye(2 * classes, dtype=bool)[::2])


def _group(rows: NDArray[Any]) -> tuple[Indices, Indices]:
    """Return the place of one copy of each different row, and for each row which one it is."""
    if rows.dtype == object:
        known: dict[tuple[int, ...], int] = {}
        label = np.array([known.setdefault(tuple(row), len(known)) for row in rows.tolist()])
        return np.unique(label, return_index=True)[1], label
    order, new = group_rows(rows.view(np.uint64))
    label = np.empty(len(rows), np.intp)
    label[order] = np.cumsum(new) - 1
    return order[new], label
