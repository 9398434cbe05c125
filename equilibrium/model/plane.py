"""Questions in space whose contacts and load lie in one plane: the same question in the plane."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.rank import cross

from .contact import Contact, wrench_at
from .errors import GraspError
from .grasp import Grasp


def in_plane(
    grasp: Grasp, wrench: RationalVector, axes: Sequence[RationalVector]
) -> tuple[Grasp, RationalVector]:
    """Return the planar grasp and wrench, in coordinates along two axes of space.

    Args:
        axes: at a right angle to one another, of length 1.

    Raises:
        GraspError: the axes are not, or a contact or the load is not in one plane along them.
    """
    u, v = axes
    if (dot(u, u), dot(v, v), dot(u, v)) != (1, 1, 0):
        raise GraspError("the axes of the plane are not of length 1 and at a right angle")
    normal = cross(u, v)
    heights = {dot(normal, contact.point) for contact in grasp}
    if len(heights) > 1 or any(dot(normal, contact.normal) for contact in grasp):
        raise GraspError("the contacts do not lie in one plane along the axes")
    height = heights.pop() if heights else Fraction(0)
    # The load about the point of the plane that is next to the origin.
    force = wrench[:3]
    moved = wrench_at(tuple(height * x for x in normal), force)
    torque = tuple(x - y for x, y in zip(wrench[3:], moved[3:], strict=True))
    if dot(normal, force) or dot(torque, u) or dot(torque, v):
        raise GraspError("the load does not lie in the plane of the contacts")
    flat = Grasp(
        Contact(
            (dot(u, c.point), dot(v, c.point)),
            (dot(u, c.normal), dot(v, c.normal)),
            c.friction,
            c.stiffness,
            c.preload,
        )
        for c in grasp
    )
    return flat, (dot(u, force), dot(v, force), dot(normal, torque))
