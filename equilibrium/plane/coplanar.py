"""Questions in space that lie in one plane, decided there.

Out of the plane no loaded contact slips (see "Contacts in one plane" in the documentation of proofs
in space), so the verdict is that of the plane, where all are decided.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import RationalVector, dot, to_text
from arrangement.numbers.linear.rank import cross, difference
from equilibrium.core.contacts import IntegerContacts
from equilibrium.model.displacement import along_tangents
from equilibrium.model.effort import Effort
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, in_plane
from equilibrium.model.solution import Solution
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.units import SearchUnits


def decide_in_plane(
    grasp: Grasp, wrench: RationalVector, effort: Effort, max_displacement: Fraction | None = None
) -> Solution | dict[str, Any] | None:
    """Return an equilibrium or a proof, or None if no plane with rational axes has the question.

    Args:
        wrench: of the load, and of the adhesion of the contacts.

    With a largest displacement only where each contact has a tangent in the plane: then its
    displacements are those of space.

    Raises:
        TimeoutError: no effort is left.
    """
    axes = _axes(grasp, wrench)
    try:
        flat, load = in_plane(grasp, wrench, axes)
    except GraspError:
        return None
    if max_displacement is not None and not along_tangents(grasp, axes):
        return None
    units = SearchUnits.of(flat, load)
    scaled = IntegerContacts(units.rows(flat), units.displacement(max_displacement))
    outcome = resistance(scaled, units.wrench(load), effort)
    if not isinstance(outcome, Solution):
        return {
            "plane": [list(map(to_text, axis)) for axis in axes],
            "tree": units.tree_back(outcome),
        }
    return _lifted(grasp, flat, axes, units.solution_back(outcome))


def _axes(grasp: Grasp, wrench: RationalVector) -> tuple[RationalVector, RationalVector]:
    """Return the first normal, and the axis at a right angle to it in the plane, if it is rational.

    Whether the question lies in that plane is not looked at.
    """
    force = wrench[:3]
    if not len(grasp):
        return (Fraction(1), *[Fraction(0)] * 2), (Fraction(0), Fraction(1), Fraction(0))
    first = grasp.contacts[0]
    u, place = first.normal, first.point
    inside = [c.normal for c in grasp] + [difference(c.point, place) for c in grasp] + [force]
    across = [cross(u, x) for x in inside] + [difference(wrench[3:], cross(place, force))]
    normal = next((x for x in across if any(x)), first.tangent)
    size = dot(normal, normal)
    length = Fraction(math.isqrt(size.numerator), math.isqrt(size.denominator))
    return u, cross(tuple(x / length for x in normal), u)


def _lifted(
    grasp: Grasp, flat: Grasp, axes: Sequence[RationalVector], plane_solution: Solution
) -> Solution:
    """Return an equilibrium of the plane in space."""
    u, v = axes
    normal = cross(u, v)
    x, y, turn = plane_solution.motion
    # A turn about the axis through the origin moves its points along the plane alone.
    motion = (*(x * a + y * b for a, b in zip(u, v, strict=True)), *(turn * c for c in normal))
    forces = []
    for contact, planar, (pressed, rubbed) in zip(grasp, flat, plane_solution.forces, strict=True):
        a, b = planar.tangent
        pull = tuple(rubbed * (a * s + b * t) for s, t in zip(u, v, strict=True))
        forces.append((pressed, *(dot(pull, tangent) for tangent in contact.tangents)))
    return Solution(motion, tuple(forces))
