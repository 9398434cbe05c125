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
from itertools import product
from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import vector
from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector, primitive, rational, shown
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from arrangement.numbers.linear.programs import Infeasible, Unbounded, minimize, some_point
from equilibrium.core.contact_rows import (
    balance_rows,
    cone_rows,
    friction_edges,
    negated,
    sum_row,
    unit_row,
)
from equilibrium.methods.method import BODIES, PLANE, SPACE, Method, Outcome, cut
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.contact import pyramid_words
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.outline import coordinates

from .grasp_wrench_space import GraspWrenchSpace
from .round_cones import round_cones


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

    def __bool__(self) -> bool:
        raise GraspError("a load has three classes; ask for .weak, .strong or .frictionless")


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
    grasp.require_plane()
    load = read_wrench(wrench)
    matrix = mass_matrix(mass, inertia, centre)
    frictionless = GraspWrenchSpace(grasp.with_friction(0)).verdict(load)
    held, moving = bool(frictionless), None
    weak = held or bool(GraspWrenchSpace(grasp).verdict(load))
    if weak and not held:
        moving = _starting_acceleration(grasp, load, matrix)
    return LoadStability(
        weak, weak and moving is None, held, moving, frictionless.separating_motion
    )


def mass_matrix(mass: Any, inertia: Any, centre: Iterable[Any]) -> tuple[RationalVector, ...]:
    """Return the mass matrix about the origin of the frame.

    Raises:
        GraspError: a mass or inertia that is not above 0, or a centre without two coordinates.
    """
    m, i = rational(mass, "mass"), rational(inertia, "inertia")
    if m <= 0 or i <= 0:
        raise GraspError(f"mass is {shown(m)} and inertia {shown(i)}; both must be above 0")
    x, y = coordinates(centre, "centre", 2)
    zero = Fraction(0)
    return ((m, zero, -m * y), (zero, m, m * x), (-m * y, m * x, i + m * (x * x + y * y)))


def _starting_acceleration(
    grasp: Grasp, load: RationalVector, matrix: Sequence[RationalVector]
) -> RationalVector | None:
    """Return a nonzero acceleration with which the load may move the object, or None."""
    planes = Arrangement(
        [c.normal_wrench for c in grasp] + [c.tangential_wrench for c in grasp], dimension=3
    )
    signs = planes.faces().signs
    normals, slips = np.hsplit(signs[(signs[:, : len(grasp)] >= 0).all(axis=1)], 2)
    # Where a contact opens, its slip does not matter.
    labels = np.stack([normals, slips * (normals == 0)], axis=2)
    _, first = np.unique(labels, axis=0, return_index=True)
    distinct = watched(labels[np.sort(first)], "faces")
    systems = (_system(grasp, load, matrix, label.tolist()) for label in distinct)
    solutions = (_nonzero_solution(*system) for system in systems)
    return next((motion for motion in solutions if motion is not None), None)


def _system(
    grasp: Grasp,
    load: RationalVector,
    matrix: Sequence[RationalVector],
    label: Sequence[Sequence[int]],
) -> tuple[int, list[RationalVector], list[RationalVector]]:
    """Return the closed linear conditions of one choice of signs, over a, all c_n and all c_t."""
    m = len(grasp)
    n = 3 + 2 * m
    pairs = [(unit_row(3 + i, n), unit_row(3 + m + i, n)) for i in range(m)]
    forces, unit = balance_rows(grasp, pairs, load, n)
    inertia = ((*row, *[Fraction(0)] * (n - 2)) for row in matrix)
    equalities = [sum_row(a, b, -unit) for a, b in zip(forces, inertia, strict=True)]
    inequalities: list[RationalVector] = []
    for contact, (push, friction), (normal, slip) in zip(grasp, pairs, label, strict=True):
        opening, sliding = (
            (*wrench, *[Fraction(0)] * (n - 2))
            for wrench in (contact.normal_wrench, contact.tangential_wrench)
        )
        if normal > 0:
            inequalities.append(opening)
            equalities += [push, friction]
            continue
        inequalities.append(push)
        equalities.append(opening)
        if slip:
            inequalities.append(tuple(slip * x for x in sliding))
            equalities.append(sum_row(friction, push, slip * contact.friction))
        else:
            equalities.append(sliding)
            inequalities += cone_rows(contact.friction, push, friction)
    return n, inequalities, equalities


def _nonzero_solution(
    n: int, inequalities: list[RationalVector], equalities: list[RationalVector]
) -> RationalVector | None:
    """Return the first three entries of a solution in which they are not all zero, if any."""
    point = some_point(n, inequalities, equalities)
    if point is None:
        return None
    if any(point[:3]):
        return point[:3]
    for axis, side in product(range(3), (1, -1)):
        answer = minimize([side * x for x in unit_row(axis, n)[:-1]], inequalities, equalities)
        assert not isinstance(answer, Infeasible)
        end = answer.point
        if isinstance(answer, Unbounded):
            end = sum_row(end, answer.ray, 1)
        if any(end[:3]):
            return end[:3]
    return None


def _decide_weak(
    subject: Grasp | Assembly, load: RationalVector | Wrenches, pyramid: int | None = None
) -> Outcome:
    if isinstance(subject, Assembly):
        held = _balances(subject, load)
        return held, f"rigid bodies: {'' if held else 'no '}forces inside the cones balance"
    if subject.dimension == 2:
        return GraspWrenchSpace(subject).verdict(load).accepts, "forces inside the cones exist"
    if pyramid is None:
        verdict = round_cones(subject, load)
        return verdict.accepts, verdict.words
    held = bool(GraspWrenchSpace(subject, pyramid=pyramid).verdict(load))
    return held, f"{'' if held else 'no '}forces inside {pyramid_words(pyramid)}"


def _balances(assembly: Assembly, wrenches: Any) -> bool:
    from equilibrium.decide.assemblies.rigid import rigid_forces

    return rigid_forces(assembly, wrenches) is not None


def _decide_strong(grasp: Grasp, wrench: RationalVector) -> Outcome:
    stability = weak_strong(grasp, wrench)
    if stability.acceleration is None:
        return stability.strong, "unit mass and inertia about the origin"
    return False, f"may start with acceleration {vector(stability.acceleration)}"


def _decide_frictionless(
    subject: Grasp | Assembly, load: RationalVector | Wrenches, pyramid: int | None = None
) -> Outcome:
    del pyramid
    smooth = subject.with_friction(0)
    if isinstance(smooth, Assembly):
        return _balances(smooth, load), "rigid bodies: normal forces alone"
    return GraspWrenchSpace(smooth).verdict(load).accepts, "normal forces alone"


def _balanced(grasp: Grasp, forces: Iterable[RationalVector]) -> Iterator[Polyhedron | None]:
    """Yield the cone of the wrenches that combinations of forces, and adhesion, balance."""
    rays = [(*primitive(negated(force)), 0) for force in forces]
    apex = primitive((*negated(grasp.adhesion_wrench), Fraction(1)))
    yield from_generators([apex, *rays], (), 3)


WEAK = Method(
    "weak",
    "weakly stable (Pang, Trinkle 2000)",
    "weakly stable",
    _decide_weak,
    cut(lambda grasp: _balanced(grasp, (edge for c in grasp for edge in friction_edges(c)))),
    (PLANE, SPACE, BODIES),
)
STRONG = Method("strong", "strongly stable (Pang, Trinkle 2000)", "strongly stable", _decide_strong)
FRICTIONLESS = Method(
    "frictionless",
    "frictionless stable (Pang, Trinkle 2000)",
    "frictionless stable",
    _decide_frictionless,
    cut(lambda grasp: _balanced(grasp, (c.normal_wrench for c in grasp))),
    (PLANE, SPACE, BODIES),
)
