"""What claims in one line, fits and printed tables can name: quantities of an arrangement."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement import counts
from arrangement.arrangement import Arrangement
from proofs_check.instances.pseudolines import Pseudolines

Planes: TypeAlias = Arrangement | Pseudolines


def _whitney(planes: Planes) -> tuple[int, ...]:
    """Return the coefficients of chi, without the zeros below the rank."""
    if isinstance(planes, Pseudolines):
        return planes.whitney_numbers
    return counts.first_whitney_numbers(planes)


def _polynomial(planes: Planes) -> tuple[int, ...]:
    numbers = _whitney(planes)
    return (*numbers, *(0 for _ in range(planes.dimension + 1 - len(numbers))))


def _chi(planes: Planes, t: int | Fraction) -> int | Fraction:
    whole: int | Fraction = 0
    for coefficient in _polynomial(planes):
        whole = whole * t + coefficient
    return whole


def _number(value: Any) -> int | Fraction:
    """Return a rational number of SymPy as one of Python."""
    return Fraction(int(value.p), int(value.q)) if value.q != 1 else int(value)


def _cells(planes: Planes, k: int) -> int:
    """Return the number of vertices, edges or faces (k = 0, 1, 2) of a division of a surface."""
    if planes.dimension == 2:
        return QUANTITIES["f_vector"](planes)[k]  # type: ignore[no-any-return]
    if planes.dimension == 3 and planes.is_central and planes.rank == 3:
        return QUANTITIES["f_vector"](planes)[k + 1]  # type: ignore[no-any-return]
    raise ValueError(
        "V, E and F are of lines in the plane, or of great circles on the sphere, that is planes "
        "of rank 3 through the origin; f_vector has the faces of others"
    )


#: By name, how each is computed.
QUANTITIES: Mapping[str, Callable[[Any], Any]] = {
    "m": lambda planes: len(planes.distinct),
    "rank": lambda planes: planes.rank,
    "regions": lambda planes: sum(map(abs, _whitney(planes))),
    "bounded_regions": lambda planes: (
        abs(sum(_whitney(planes))) * (planes.rank == planes.dimension)
    ),
    "relatively_bounded_regions": lambda planes: abs(sum(_whitney(planes))),
    "polynomial": _polynomial,
    "f_vector": lambda planes: (
        planes.f_vector if isinstance(planes, Pseudolines) else counts.f_vector(planes)
    ),
    "p_vector": lambda planes: planes.p_vector,
    "bounded_p_vector": lambda planes: planes.bounded_p_vector,
    "t_vector": lambda planes: (
        planes.t_vector if isinstance(planes, Pseudolines) else counts.t_vector(planes)
    ),
    "level_vector": lambda planes: (
        {3: sum(map(abs, planes.whitney_numbers))}
        if isinstance(planes, Pseudolines)
        else counts.level_vector(planes)
    ),
    "nbc_sets": lambda planes: tuple(map(len, counts.nbc_sets(planes))),
    "central": lambda planes: planes.is_central,
    "simple": lambda planes: planes.is_simple,
    "simplicial": lambda planes: planes.is_simplicial,
    "n": lambda planes: len(planes.distinct),
    "V": lambda planes: _cells(planes, 0),
    "E": lambda planes: _cells(planes, 1),
    "F": lambda planes: _cells(planes, 2),
}
#: The quantities that are no numbers.
TRUTH_VALUES = frozenset({"central", "simple", "simplicial"})
VECTORS = frozenset({"polynomial", "f_vector", "nbc_sets"})
MAPPINGS = ("p_vector", "bounded_p_vector", "t_vector", "level_vector")
#: Functions of an arrangement and numbers, as they are written.
FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "chi(t)": _chi,
    "tutte(x, y)": lambda planes, x, y: _number(counts.tutte_polynomial(planes).eval((x, y))),
    "points_off(q)": counts.points_off,
}
