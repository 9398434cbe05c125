"""The law of contacts, evaluated at a motion and forces; and the proofs of force closure.

Written a second time on purpose, from the contact data alone: the checker must not inherit a
mistake of the solver.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.numbers.exact import RationalVector, number_text, over_unit, primitive, quotient
from arrangement.numbers.linear.rank import rank
from equilibrium.model.assembly import SIZE, Assembly
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import Subject


class LawRow(NamedTuple):
    """A contact of a grasp or of an assembly as the checker sees it, in R^n.

    Attributes:
        wrenches: of unit forces along the normal and the tangents.
    """

    wrenches: tuple[RationalVector, ...]
    friction: Fraction
    stiffness: Fraction
    preload: Fraction
    adhesion: Fraction


def law_rows(contacts: Iterable[Contact]) -> list[LawRow]:
    """Return the rows of the contacts of a grasp."""
    return [LawRow(frame(c), c.friction, c.stiffness, c.preload, c.adhesion) for c in contacts]


def joint_rows(assembly: Assembly) -> list[LawRow]:
    """Return the rows of the contacts of an assembly in R^(3b)."""
    joints = assembly.contacts
    bodies = [(joint.body_a, joint.body_b) for joint in joints]
    return lifted_rows(law_rows(joint.contact for joint in joints), bodies, assembly.names)


def lifted_rows(
    rows: Sequence[LawRow], bodies: Sequence[tuple[str, str | None]], names: Sequence[str]
) -> list[LawRow]:
    """Return rows of contacts, each in the numbers of its body_a, in those of all bodies."""
    place = {name: SIZE * k for k, name in enumerate(names)}

    def lifted(wrench: RationalVector, pair: tuple[str, str | None]) -> RationalVector:
        row = [Fraction(0)] * (SIZE * len(place))
        for sign, name in zip((1, -1), pair, strict=True):
            if name is not None:
                row[place[name] : place[name] + SIZE] = [sign * x for x in wrench]
        return tuple(row)

    return [
        row._replace(wrenches=tuple(lifted(wrench, pair) for wrench in row.wrenches))
        for row, pair in zip(rows, bodies, strict=True)
    ]


def rows_of(subject: Subject) -> list[LawRow]:
    """Return the rows of the contacts of a grasp or an assembly."""
    return joint_rows(subject) if isinstance(subject, Assembly) else law_rows(subject)


def applied(rows: Iterable[LawRow], wrench: RationalVector) -> RationalVector:
    """Return a wrench with the adhesion of all contacts, which pulls against their normals."""
    for row in rows:
        if row.adhesion:
            pairs = zip(wrench, row.wrenches[0], strict=True)
            wrench = tuple(w - row.adhesion * x for w, x in pairs)
    return wrench


def frame(contact: Contact) -> tuple[RationalVector, ...]:
    """Return the wrenches of unit forces along the normal and the tangents: one, in space two."""
    if contact.dimension == 2:
        (x, y), (nx, ny) = contact.point, contact.normal
        return (nx, ny, x * ny - y * nx), (-ny, nx, x * nx + y * ny)
    along = contact.normal, contact.tangent, _cross(contact.normal, contact.tangent)
    return tuple((*force, *_cross(contact.point, force)) for force in along)


def _cross(left: RationalVector, right: RationalVector) -> RationalVector:
    # In integers, see `_dot`.
    ((a, b, c), unit), ((x, y, z), scale) = over_unit(left), over_unit(right)
    size = unit * scale
    return tuple(quotient(k, size) for k in (b * z - c * y, c * x - a * z, a * y - b * x))


def law_problem(
    rows: Sequence[LawRow],
    wrench: RationalVector,
    motion: RationalVector,
    forces: Sequence[RationalVector],
    edges: Sequence[RationalVector] = (),
) -> str:
    """Return what is wrong with a motion and forces (normal, tangential); empty if they obey.

    Spring ``c_n = max(0, q - k N . d)``, cone ``|c_t| <= mu c_n``, dissipation: where s = T d is
    not 0, ``c_t = -mu c_n s / |s|``, balance ``sum ((c_n - adhesion) N + c_t T) + w = 0``.

    Args:
        edges: of friction pyramids; none for cones, in space round ones.
    """
    pushes: list[Fraction] = []
    along_axes: list[RationalVector] = []
    for i, (contact, (normal, *friction)) in enumerate(zip(rows, forces, strict=True), 1):
        along, *slip = (_dot(row, motion) for row in contact.wrenches)
        spring = max(Fraction(0), contact.preload - contact.stiffness * along)
        if normal != spring:
            return f"contact {i}: normal force {short(normal)}, its spring gives {short(spring)}"
        limit = contact.friction * normal
        inside = _in_cone(friction, limit, edges)
        if not inside or not _does_most(friction, slip, limit, edges):
            problem = f"contact {i}: friction {_shown(friction)} of at most {short(limit)}"
            return problem + f" while it slips by {_shown(slip)}" * inside
        pushes += normal, *friction
        along_axes += contact.wrenches
    columns = zip(*along_axes, strict=True) if along_axes else ([] for _ in wrench)
    loads = zip(applied(rows, wrench), columns, strict=True)
    total = [w + _dot(pushes, column) for w, column in loads]
    return f"the forces add up to {_shown(total)}, not 0" if any(total) else ""


def _in_cone(
    friction: Sequence[Fraction], limit: Fraction, edges: Sequence[RationalVector]
) -> bool:
    """Return whether a friction force is in the disc, in the plane an interval, or polygon."""
    if not edges:
        return _dot(friction, friction) <= limit * limit
    sides = zip(outward(edges), edges, strict=True)
    return all(_dot(normal, friction) <= limit * _dot(normal, edge) for normal, edge in sides)


def outward(edges: Sequence[RationalVector]) -> list[RationalVector]:
    """Return for each edge the outward normal of the side of the polygon that starts there."""
    nexts = (*edges[1:], edges[0])
    return [(a + c, b + d) for (a, b), (c, d) in zip(edges, nexts, strict=True)]


def _does_most(
    friction: Sequence[Fraction],
    slip: Sequence[Fraction],
    limit: Fraction,
    edges: Sequence[RationalVector],
) -> bool:
    """Return whether no friction force of the cone does less work on a slip.

    In the disc, in the plane an interval, that is ``-limit |s|``, done by one force alone; by all
    where there is no slip.
    """
    work = _dot(friction, slip)
    if edges:
        return work == -limit * max(_dot(edge, slip) for edge in edges)
    return work <= 0 and work * work == limit * limit * _dot(slip, slip)


def displacement_problem(
    rows: Sequence[LawRow], motion: RationalVector, max_displacement: Fraction | None
) -> str:
    """Return which contact point moves further than the largest displacement, or nothing."""
    for i, contact in enumerate(rows if max_displacement is not None else (), 1):
        for row in contact.wrenches:
            if abs(_dot(row, motion)) > max_displacement:  # type: ignore[operator]
                moved, most = short(_dot(row, motion)), short(max_displacement)  # type: ignore[arg-type]
                return f"contact {i}: its point moves by {moved}, and at most {most} counts"
    return ""


def displacement_work(
    max_displacement: Fraction | None, displacements: Mapping[int, Sequence[Any]]
) -> tuple[str, Fraction]:
    """Return what is wrong with the multipliers of a leaf for the largest displacement, and a sum.

    Contact points move by at most D, so ``|u| D - u N . d >= 0`` for any multiplier u and each row
    N or T of a contact. A leaf may subtract such terms, after which its work must be above 0:
    ``u N . d`` joins its linear form in the motion d, and its constant, for ``d_0 = 1``, becomes
    smaller by the sum of all ``|u| D``.

    Returns:
        The problem, empty if there is none, and that sum.
    """
    if displacements and max_displacement is None:
        return "the question has no largest displacement", Fraction(0)
    total = sum((abs(u) for row in displacements.values() for u in row), Fraction(0))
    return "", total * (max_displacement or 0)


def closure_problem(grasp: Grasp, forces: Sequence[RationalVector]) -> str:
    """Return why forces (normal, along the tangents) do not show force closure; empty if they do.

    They balance each other, each strictly inside its cone, and the wrenches of their contacts span
    all: then 0 is in the relative interior of the sum of the cones, a convex cone, which is the
    space that it spans.

    Args:
        forces: at each contact; all numbers are 0 at a contact that is not needed.
    """
    rows = law_rows(grasp)
    if [len(force) for force in forces] != [len(row.wrenches) for row in rows]:
        return "there is not one force with all its components for each contact"
    total = [Fraction(0)] * grasp.wrench_size
    spanned: list[RationalVector] = []
    for i, (row, force) in enumerate(zip(rows, forces, strict=True), 1):
        if not any(force):
            continue
        normal, *friction = force
        limit = row.friction * normal
        inside = _dot(friction, friction) < limit * limit if limit else not any(friction)
        if normal <= 0 or not inside:
            return f"contact {i}: the force is not strictly inside its cone"
        spanned += row.wrenches if row.friction else row.wrenches[:1]
        for size, wrench in zip(force, row.wrenches, strict=True):
            total = [x + size * w for x, w in zip(total, wrench, strict=True)]
    if any(total):
        return f"the forces add up to {_shown(total)}, not 0"
    axes = rank([primitive(wrench) for wrench in spanned])
    return "" if axes == len(total) else f"their wrenches span {axes} of {len(total)} axes"


def escape_problem(grasp: Grasp, motion: RationalVector) -> str:
    """Return why a motion does not show that there is no force closure; empty if it does.

    It is not 0, and no force inside any cone does negative work on it, so no forces balance the
    wrench that has its numbers.
    """
    if len(motion) != grasp.wrench_size or not any(motion):
        return f"not a motion other than 0 with {grasp.wrench_size} numbers"
    for i, row in enumerate(law_rows(grasp), 1):
        along, *across = (_dot(wrench, motion) for wrench in row.wrenches)
        if along < 0 or along**2 < row.friction**2 * _dot(across, across):
            return f"contact {i}: a force inside its cone opposes the motion"
    return ""


def short(value: Fraction | int) -> str:
    """Return a number for a message."""
    is_rational = isinstance(value, (int, Fraction))
    return number_text(value, digits=30, longest=60) if is_rational else str(value)


def _shown(values: Sequence[Fraction]) -> str:
    """Return one number, or more in parentheses, for a message."""
    return short(*values) if len(values) == 1 else f"({', '.join(map(short, values))})"


def _dot(left: Sequence[Fraction], right: Sequence[Fraction]) -> Fraction:
    # In integers: to reduce each product and each sum takes several times as long.
    (one, unit), (other, scale) = over_unit(left), over_unit(right)
    total: Fraction = quotient(sum(a * b for a, b in zip(one, other, strict=True)), unit * scale)
    return total
