"""Which engine lists the faces of which planes: the only entry point to all of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from copy import copy
from dataclasses import dataclass
from math import comb

import numpy as np

from arrangement.errors import InputError, OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import largest, shown, work_factor
from arrangement.planes.planes import Planes

from . import affine_space, any_dimension, deletion_restriction, great_circles
from .sequence import FaceSequence, Level, no_faces

#: Up to so many faces, a list of all of them is as quick as one of the regions alone.
_FEW = 20_000


@dataclass(frozen=True)
class Engine:
    """One way to list all faces.

    Attributes:
        list_faces: from planes to their faces of dimension 0, 1, ..., d.
        ranks: the ranks, of the planes or of the cone over affine ones, that it can do.
        can: the same in words.
        steps, bytes: that a face takes.
        order: it takes as much as m^order faces in any case, for m distinct planes.
        long: how much longer it takes with long numbers, as in `work_factor`.
        affine: how many times the bytes it takes where planes miss the origin.
    """

    list_faces: Callable[[Planes], tuple[Level, ...]]
    ranks: Callable[[Planes], bool]
    can: str
    steps: float
    bytes: float
    long: float
    order: int = 0
    affine: float = 1


def cone_rank(planes: Planes) -> int:
    """Return the rank of the planes, or one more if they are affine."""
    return planes.rank + (not planes.is_central)


#: The fastest comes first. In any dimension: what counts is the rank.
ENGINES = {
    "great-circles": Engine(
        great_circles.list_faces,
        lambda planes: cone_rank(planes) <= 3,
        "rank up to 3, or up to 2 with planes that miss the origin",
        1,
        20,
        4,
        2,
        affine=3,
    ),
    "affine-space": Engine(
        affine_space.list_faces,
        lambda planes: planes.rank == 3 or cone_rank(planes) == 4,
        "rank 3, or 4 if all planes contain the origin",
        10,
        120,
        25,
        2,
    ),
    "any-dimension": Engine(
        any_dimension.list_faces, lambda planes: True, "every rank", 40, 300, 3
    ),
}


def enumerate_faces(
    planes: Planes,
    engine: str | None = None,
    count: Callable[[Planes], Sequence[int]] | None = None,
) -> FaceSequence:
    """Return every face, listed by the fastest engine that can, or by the one that is named.

    Args:
        count: gives their numbers without listing any; asked where a bound is out of reach.

    Raises:
        InputError: no engine of this name, or one that cannot do these planes.
        OutOfReachError: the list takes more than the budget.
    """
    if engine is None:
        engine = next(name for name, known in ENGINES.items() if known.ranks(planes))
    if engine not in ENGINES:
        raise InputError(f"the engine is {shown(engine)}; expected one of {', '.join(ENGINES)}")
    chosen = ENGINES[engine]
    if not chosen.ranks(planes):
        raise InputError(f"the engine {engine} does {chosen.can}; these are {planes!r}")
    check_engine(planes, chosen, count)
    planes = copy(planes)  # planes may keep their faces, so the faces do not keep those planes
    return FaceSequence(planes, chosen.list_faces(planes), engine)


def enumerate_regions(planes: Planes, count: Callable[[Planes], int]) -> FaceSequence | None:
    """Return every region without the faces of lower dimension, None where these come first.

    That is so where a list of all faces is as quick, and where regions are too narrow for floats.

    Args:
        count: gives their number without listing any; asked where a bound is out of reach.

    Raises:
        OutOfReachError: the list takes more than the budget.
    """
    m, central = len(planes.distinct), planes.is_central
    rational = largest(planes.integer_planes) < math.inf
    if cone_rank(planes) < 5 or most_faces(m, planes.rank, central) < _FEW or not rational:
        return None
    restrictions = budget.choose(m + (not central), cone_rank(planes) - 2)
    of_each = cone_rank(planes) + m / 64 + 1  # coordinates of the witness, words of signs
    made = (
        restrictions * deletion_restriction.RESTRICTION_STEPS * work_factor(planes.integer_planes)
    )

    def takes() -> dict[str, float]:
        listed = of_each * regions / (1 + central)  # of central planes the opposites are not
        return {
            "faces": regions,
            "long_steps": made + deletion_restriction.REGION_STEPS * listed,
            "bytes": deletion_restriction.REGION_BYTES * listed,
        }

    regions, many = most_regions(m, planes.rank, central), "up to "
    if budget.excess(**takes()) > 1:
        # else the bound has to do
        with suppress(OutOfReachError, budget.WorkOver), budget.at_most(budget.STEPS):
            regions, many = min(count(planes), 10**300), ""
    what = f"a list of the {many}{budget.about(regions)} regions of {planes!r}"
    budget.check_cost(what, "count them (arrangement count, region_count())", **takes())
    planes = copy(planes)
    try:
        level = deletion_restriction.list_regions(planes)
    except deletion_restriction.TooCloseError:
        return None
    return FaceSequence(planes, [level], "deletion-restriction", planes.dimension)


def enumerate_regions_inside(planes: Planes, sides: Planes) -> FaceSequence:
    """Return the regions that meet the positive side of all of some other planes.

    What is outside is not listed, unless its points are too close for floats, or the planes are
    irrational or have a low rank: then all regions are, and those inside are chosen.

    Raises:
        InputError: planes of another space.
        OutOfReachError: the list takes more than the budget.
    """
    joined = _beside(sides, planes)
    engine, level = "deletion-restriction", no_faces(len(joined), planes.dimension)
    if set(sides.orientation) <= {1}:  # else two sides are one plane with nothing between
        least = 3 if joined.is_central and not len(sides) else 2  # see `list_regions`
        try:
            if joined.rank < least or not largest(joined.integer_planes) < math.inf:
                raise deletion_restriction.TooCloseError
            level = deletion_restriction.list_regions(joined, len(sides.distinct))
        except deletion_restriction.TooCloseError:
            every = enumerate_faces(joined).of_dimension(planes.dimension)
            regions = every.where(np.all(every.signs[:, : len(sides)] > 0, axis=1))
            engine, (level,) = every.engine, regions.levels
    return FaceSequence(copy(planes), [_without(level, len(sides))], engine, planes.dimension)


def enumerate_faces_inside(
    planes: Planes, sides: Planes, engine: str | None = None
) -> FaceSequence:
    """Return the faces, of every dimension, that meet the positive side of all of some planes.

    Those of all planes together are listed, and those inside are chosen.

    Raises:
        InputError, OutOfReachError: as `enumerate_faces` and `enumerate_regions_inside`.
    """
    every = enumerate_faces(_beside(sides, planes), engine)
    inside = every.where(np.all(every.signs[:, : len(sides)] > 0, axis=1))
    levels = [_without(level, len(sides)) for level in inside.levels]
    return FaceSequence(copy(planes), levels, every.engine)


def _beside(sides: Planes, planes: Planes) -> Planes:
    """Return all planes together, the sides first."""
    if sides.dimension != planes.dimension:
        raise InputError(
            f"inside is in R^{sides.dimension} and the planes are in R^{planes.dimension}; give "
            "planes of one space"
        )
    rows = [*sides.integer_planes, *planes.integer_planes]
    return Planes([r[:-1] for r in rows], [r[-1] for r in rows], dimension=planes.dimension)


def _without(level: Level, sides: int) -> Level:
    """Return faces of some sides and planes as those of the planes."""
    return Level(level.count, lambda at: level.signs(at)[:, sides:], level.points, scalable=False)


def most_regions(m: int, rank: int, central: bool) -> float:
    """Return how many regions m planes of a rank have at most: as many as in general position.

    >>> most_regions(4, 3, True), most_regions(3, 3, False)
    (14, 8)
    """
    if rank > 40:
        return budget.power(2, min(m, rank))
    if not central:
        return sum(comb(m, i) for i in range(rank + 1))
    return 2 * sum(comb(m - 1, i) for i in range(rank)) if m else 1


def most_faces(m: int, rank: int, central: bool) -> float:
    """Return how many faces m planes of a rank have at most: as many as in general position.

    Source: R. Buck, American Mathematical Monthly 50 (1943); T. Zaslavsky, Memoirs AMS 154 (1975).

    >>> most_faces(4, 3, True), most_faces(3, 3, False)
    (51, 27)
    """
    if rank > 40:  # beyond 10^12: there are at least 2^rank regions
        return budget.power(2, rank)
    bound = 0
    for k in range(rank + 1):
        left = m - k - central
        regions = sum(comb(left, i) for i in range(rank - k + (not central))) if left >= 0 else 0
        bound += comb(m, k) * (regions * (1 + central) if k < rank or not central else 0)
    return bound + central


def check_engine(
    planes: Planes, engine: Engine, count: Callable[[Planes], Sequence[int]] | None = None
) -> None:
    """Refuse a list that is out of reach, by a bound where that is enough."""
    factor = work_factor(planes.integer_planes, engine.long)
    faces = most_faces(len(planes.distinct), planes.rank, planes.is_central)

    bytes = engine.bytes * (1 if planes.is_central else engine.affine)

    def takes() -> dict[str, float]:
        work = max(faces, len(planes.distinct) ** engine.order)
        steps = work * engine.steps * factor
        return {"faces": faces, "steps": steps, "bytes": work * bytes}

    exact, instead = None, "count them (arrangement count, counts.f_vector)"
    if budget.excess(**takes()) > 1 and count is not None:
        try:
            with budget.at_most(budget.STEPS):
                exact = tuple(count(planes))
            faces = min(sum(exact), 10**300)
        except budget.WorkOver:  # then the bound has to do
            pass
        except OutOfReachError:
            instead = "leave out planes: to count them takes too long as well"
    try:
        many = "" if exact is not None else "up to "
        budget.check_cost(
            f"a list of the {many}{budget.about(faces)} faces of {planes!r}",
            instead,
            **takes(),
        )
    except OutOfReachError as error:
        error.f_vector = exact
        raise
