"""Weak, strong and frictionless stability of a load ([Pang2000]).

Rigid bodies: no springs and no preload. The classes come from the motion that starts from rest.
With a mass matrix M, the accelerations a and contact forces satisfy ``M a = w + sum (c_n N + c_t
T)``, ``0 <= c_n``, ``N . a >= 0``, ``c_n (N . a) = 0``, and Coulomb's law on T . a (maximum
dissipation). A load is

- *weakly stable* when some solution has a = 0: forces inside the cones balance it (one program);
- *strongly stable* when it is weakly stable and every solution has a = 0;
- *frictionless stable* when normal forces alone balance it (one program). By Farkas' lemma this
  is the same as ``w . a <= 0`` for every a with all ``N . a >= 0``: no permitted virtual motion
  gains work.

Along a solution with a != 0 the load does positive work: ``a . M a = w . a - sum mu c_n |T . a|``,
so a frictionless stable load is strongly stable for every friction, as Pang and Trinkle show. The
paper describes strong stability by non-positive virtual work; read for the load alone, that is the
frictionless class, so here it is decided from the definition.

Strong stability asks for a != 0, so the signs of all ``N . a`` and ``T . a`` are fixed first: the
faces of 2m planes through the origin, each one exact linear program. It depends on M.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.exact import RationalVector, rational, rational_vector
from arrangement.linprog import Infeasible, Row, feasible_point, minimize
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Contact, Grasp, read_wrench

from .grasp_wrench_space import GraspWrenchSpace


@dataclass(frozen=True)
class LoadStability:
    """The classes of a load.

    Attributes:
        weak, strong, frictionless: each class, as defined in this module.
        acceleration: of a weakly stable load that is not strongly stable: one that may start.
        virtual_motion: of a load that is not frictionless stable: a motion with ``w . d = 1`` and
            all ``N . d >= 0``.
    """

    weak: bool
    strong: bool
    frictionless: bool
    acceleration: RationalVector | None
    virtual_motion: RationalVector | None


def weak_strong(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    mass: Any = 1,
    inertia: Any = 1,
    centre: Iterable[Any] = (0, 0),
) -> LoadStability:
    """Classify a load exactly.

    Args:
        grasp: points, normals and friction count.
        wrench: applied.
        mass, inertia: above 0; the inertia is about the centre of mass.
        centre: of mass, in the object frame.
    """
    load = read_wrench(wrench)
    matrix = mass_matrix(mass, inertia, centre)
    without = Grasp(Contact(c.point, c.normal, 0) for c in grasp)
    frictionless = GraspWrenchSpace(without).verdict(load)
    weak = frictionless.accepts or GraspWrenchSpace(grasp).verdict(load).accepts
    moving = None
    if weak and not frictionless.accepts:
        moving = starting_acceleration(grasp, load, matrix)
    return LoadStability(
        weak,
        weak and moving is None,
        frictionless.accepts,
        moving,
        frictionless.separating_motion,
    )


def mass_matrix(mass: Any, inertia: Any, centre: Iterable[Any]) -> tuple[RationalVector, ...]:
    """Return the mass matrix about the origin of the frame.

    Raises:
        GraspError: a mass or inertia that is not above 0, or a centre without two coordinates.
    """
    m, i = rational(mass, "mass"), rational(inertia, "inertia")
    place = rational_vector(centre, "centre")
    if m <= 0 or i <= 0:
        raise GraspError(f"mass is {m} and inertia {i}; both must be above 0")
    if len(place) != 2:
        raise GraspError(f"centre has {len(place)} coordinates; give two")
    x, y = place
    zero = Fraction(0)
    return ((m, zero, -m * y), (zero, m, m * x), (-m * y, m * x, i + m * (x * x + y * y)))


def starting_acceleration(
    grasp: Grasp, load: RationalVector, matrix: Sequence[RationalVector]
) -> RationalVector | None:
    """Return a nonzero acceleration with which the load may move the object, or None."""
    planes = Arrangement(
        [c.normal_wrench for c in grasp] + [c.tangential_wrench for c in grasp], dimension=3
    )
    m = len(grasp)
    seen: set[tuple[tuple[int, int], ...]] = set()
    for face in planes.faces():
        signs = tuple(zip(face.signs[:m], face.signs[m:], strict=True))
        if any(normal < 0 for normal, _ in signs):
            continue
        # Where the contact opens, its slip does not matter.
        label = tuple((normal, 0 if normal else slip) for normal, slip in signs)
        if label in seen:
            continue
        seen.add(label)
        found = _nonzero_solution(*_system(grasp, load, matrix, label))
        if found is not None:
            return found
    return None


def _system(
    grasp: Grasp,
    load: RationalVector,
    matrix: Sequence[RationalVector],
    label: tuple[tuple[int, int], ...],
) -> tuple[int, list[Row], list[Row]]:
    """Return the closed linear conditions of one choice of signs, over a, all c_n and all c_t."""
    m = len(grasp)
    n = 3 + 2 * m
    inequalities: list[Row] = []
    equalities: list[Row] = [
        [
            *(-x for x in matrix[k]),
            *(c.normal_wrench[k] for c in grasp),
            *(c.tangential_wrench[k] for c in grasp),
            load[k],
        ]
        for k in range(3)
    ]
    for i, (contact, (normal, slip)) in enumerate(zip(grasp, label, strict=True)):
        push, friction = 3 + i, 3 + m + i
        along = dict(enumerate(contact.normal_wrench))
        across = dict(enumerate(contact.tangential_wrench))
        mu = contact.friction
        if normal > 0:
            inequalities.append(_row(n, along))
            equalities += [_row(n, {push: 1}), _row(n, {friction: 1})]
            continue
        inequalities.append(_row(n, {push: 1}))
        equalities.append(_row(n, along))
        if slip:
            inequalities.append(_row(n, {k: slip * x for k, x in across.items()}))
            equalities.append(_row(n, {friction: 1, push: slip * mu}))
        else:
            equalities.append(_row(n, across))
            inequalities += [_row(n, {push: mu, friction: side}) for side in (1, -1)]
    return n, inequalities, equalities


def _nonzero_solution(
    n: int, inequalities: list[Row], equalities: list[Row]
) -> RationalVector | None:
    """Return the first three entries of a solution in which they are not all zero, if any."""
    point = feasible_point(n, inequalities, equalities)
    if isinstance(point, Infeasible):
        return None
    if any(point[:3]):
        return point[:3]
    for objective in _directions(n):
        answer = minimize(objective, inequalities, equalities)
        assert not isinstance(answer, Infeasible)
        found = answer.point
        if hasattr(answer, "ray"):
            found = tuple(x + y for x, y in zip(found, answer.ray, strict=True))
        if any(found[:3]):
            return found[:3]
    return None


def _directions(n: int) -> Iterator[list[int]]:
    for axis in range(3):
        for side in (1, -1):
            yield [side * int(j == axis) for j in range(n)]


def _row(n: int, entries: dict[int, Any]) -> list[Fraction]:
    """Return a homogeneous row."""
    return [Fraction(entries.get(j, 0)) for j in range(n + 1)]
