"""The point of least Euclidean norm of a projected polyhedron, exactly.

Wolfe's method with an exact linear program as its oracle. It keeps a corral: affinely independent
vertices and rays whose combination with positive weights is the least point of their affine hull.
Each round the oracle asks for the vertex or ray that leads furthest down from the present point.

Termination: the oracle answers with basic solutions and rays, of which there are finitely many.
A corral determines its least point, and the norm falls strictly from round to round, so no corral
returns. [Wolfe1976], Finding the nearest point in a polytope.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear import programs
from arrangement.numbers.linear.rank import gauss_jordan

Rows: TypeAlias = Sequence[Sequence[Fraction | int]]


@dataclass
class _Atom:
    """A vertex (mass 1) or a ray (mass 0), with its weight in the present combination."""

    vector: RationalVector
    mass: int
    weight: Fraction


def least_point(n: int, inequalities: Rows, equalities: Rows, image: Rows) -> RationalVector:
    """Return the least point of ``{F z + g : z in P}``, for a non-empty polyhedron P in R^n.

    Args:
        inequalities, equalities: the rows of P, constant last, ``>= 0`` and ``= 0``.
        image: the rows of the affine map ``F z + g``, constant last.
    """
    program = programs.Program(n, inequalities, equalities)
    start = program.point()
    assert not isinstance(start, programs.Infeasible)
    corral = [_Atom(_apply(image, start), 1, Fraction(1))]
    while True:
        point = _combination(corral)
        atom = _downhill(program, image, point)
        if atom is None:
            return point
        corral.append(atom)
        _settle(corral)


def _apply(image: Rows, z: RationalVector, constant: int = 1) -> RationalVector:
    return tuple(Fraction(dot(row[:-1], z) + constant * row[-1]) for row in image)


def _combination(corral: list[_Atom]) -> RationalVector:
    size = len(corral[0].vector)
    return tuple(sum((a.weight * a.vector[j] for a in corral), Fraction(0)) for j in range(size))


def _downhill(program: programs.Program, image: Rows, point: RationalVector) -> _Atom | None:
    """Return a vertex or ray that leads down from the point; None if the point is least."""
    objective = [dot(point, column) for column in zip(*(row[:-1] for row in image), strict=True)]
    answer = program.minimize(objective)
    if isinstance(answer, programs.Unbounded):
        return _Atom(_apply(image, answer.ray, 0), 0, Fraction(0))
    assert not isinstance(answer, programs.Infeasible)
    vertex = _apply(image, answer.point)
    if dot(point, vertex) >= dot(point, point):
        return None
    return _Atom(vertex, 1, Fraction(0))


def _settle(corral: list[_Atom]) -> None:
    """Move to the least point of the hull, dropping atoms whose weight reaches zero."""
    while True:
        wanted = _affine_weights(corral)
        if all(weight > 0 for weight in wanted):
            for atom, weight in zip(corral, wanted, strict=True):
                atom.weight = weight
            return
        # An atom that just entered gets a positive weight, so no division by zero happens here.
        step = min(
            atom.weight / (atom.weight - weight)
            for atom, weight in zip(corral, wanted, strict=True)
            if weight <= 0
        )
        for atom, weight in zip(corral, wanted, strict=True):
            atom.weight += step * (weight - atom.weight)
        corral[:] = [atom for atom in corral if atom.weight > 0]


def _affine_weights(corral: list[_Atom]) -> list[Fraction]:
    """Return the weights of the least point of the affine hull (vertices sum to 1)."""
    rows = [
        [*(dot(a.vector, b.vector) for b in corral), Fraction(a.mass), Fraction(0)] for a in corral
    ]
    rows.append([*(Fraction(a.mass) for a in corral), Fraction(0), Fraction(1)])
    reduced, _, scale = gauss_jordan(rows)
    return [Fraction(row[-1], scale) for row in reduced[: len(corral)]]
