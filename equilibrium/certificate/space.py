"""The checker's part for grasps in space: the leaves of a tree of states.

The cone of friction is round, ``|c_t| <= mu c_n``, and a contact that slips by s = T d has
``c_t = -mu c_n s / |s|``. A leaf stands for states of contacts. With ``a = lambda . N``,
``b = T lambda`` and its multipliers alpha, h, the work of a contact on lambda is at least
``alpha (q - k N . d) + h . T d`` for every motion d and all that the contact may do, if

* ``alpha >= 0`` where it is undecided or detached;
* ``alpha <= a - mu |b|`` unless it is detached; in the sector from u to v only
  ``alpha <= a - mu (x . b)`` for its unit vectors x, the greatest of which is |b| if b is in the
  sector, else at an end: ``u . b / |u|`` or ``v . b / |v|``;
* h = 0 but where it sticks, and in a sector, where ``h . u <= 0`` and ``h . v <= 0``.

Where only displacements of contact points up to D count, numbers of a leaf for the normal and the
tangents of a contact take D times their sizes from the sum, and give what they are times the rows
``N . d`` and ``T . d``, see `equilibrium.certificate.law.displacement_work`.

Without multipliers alpha and h are 0. Where all these together do not depend on d, and are above
minus the work of the load, nothing balances the load. Roots are compared by their squares.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp

from .law import displacement_work, frame, outward, short
from .reading import Leaf, Split

#: A sector from u to v, counter-clockwise by less than half a turn.
Sector: TypeAlias = tuple[RationalVector, RationalVector]


class SlipFace(NamedTuple):
    """Slip in the cone of one or two directions, with friction between some edges of a pyramid."""

    ends: tuple[RationalVector, ...]
    edges: tuple[RationalVector, ...]


State: TypeAlias = str | Sector | SlipFace


class SpatialQuestion:
    """Grasp and wrench in integers, one unit for each kind of sum.

    Attributes:
        edges: of friction pyramids; none for round cones.
    """

    dimension = 3

    def __init__(
        self,
        grasp: Grasp,
        wrench: RationalVector,
        edges: Sequence[RationalVector] = (),
        max_displacement: Fraction | None = None,
    ) -> None:
        self.edges, self.max_displacement = edges, max_displacement
        contacts = list(grasp)
        works = math.lcm(*(x.denominator for x in (*wrench, *(c.preload for c in contacts))))
        self.load = tuple(int(x * works) for x in wrench)
        frames = [[x for row in frame(contact) for x in row] for contact in contacts]
        units = [math.lcm(*(x.denominator for x in row)) for row in frames]
        pairs = list(zip(contacts, units, strict=True))
        motions = math.lcm(*(c.stiffness.denominator * unit for c, unit in pairs))
        self.works, self.motions = works, motions
        self.contacts = [
            _SpatialContact(
                tuple(int(x * unit) for x in row),
                unit,
                int(c.preload * works),
                int(c.stiffness * motions / unit),
                motions // unit,
                c.friction,
            )
            for (c, unit), row in zip(pairs, frames, strict=True)
        ]


class _SpatialContact(NamedTuple):
    """A contact: `wrenches` of normal and tangents one after the other, over `unit`.

    A multiplier alpha adds ``alpha per_work`` to the work and takes ``alpha per_alpha`` times the
    normal wrench away from what depends on the motion; h adds ``h per_h`` times a tangent's.
    """

    wrenches: IntegerVector
    unit: int
    per_work: int
    per_alpha: int
    per_h: int
    friction: Fraction


def split_states(
    split: Split, states: Mapping[int, State], path: str, edges: Sequence[RationalVector]
) -> list[tuple[tuple[str, Any], Mapping[int, State]]]:
    """Return the children of a split by directions with their states; refuse what does not cover.

    Raises:
        CertificateError: the contact is not attached, or directions are not in order.
    """
    contact, ends = split.at[0], list(split.directions)
    state = states.get(contact, "undecided")
    parts: list[State]
    if (split.kind == "faces") != bool(edges):
        raise CertificateError(f"{path}: faces are for pyramids, directions for round cones")
    if edges:
        parts = ["stick", *slip_faces(edges)]
        if state != "attached" or len(split.children) != len(parts):
            raise CertificateError(
                f"{path}: the faces of an attached contact have {len(parts)} children, and contact "
                f"{contact + 1} is {_named(state)} here"
            )
        pairs = zip(split.children, parts, strict=True)
        return [(child, {**states, contact: part}) for child, part in pairs]
    if isinstance(state, tuple) and not isinstance(state, SlipFace):
        around = [state[0], *ends, state[1]]
        parts = list(pairwise(around))
        good = len(ends) == 1
    else:
        if state != "attached":
            raise CertificateError(f"{path}: contact {contact + 1} is not attached here")
        around = [*ends, *ends[:1]]
        parts = ["stick", *pairwise(around)]
        # Each is less than half a turn from the one before, so three or more, that turn once.
        good = sum(y < 0 <= z for (_, y), (_, z) in pairwise(around)) == 1
    if not good or any(turn(u, v) <= 0 for u, v in pairwise(around)):
        raise CertificateError(
            f"{path}: directions go round once, counter-clockwise and each less than half a turn "
            "from the one before, or one cuts a sector"
        )
    return [
        (child, {**states, contact: part})
        for child, part in zip(split.children, parts, strict=True)
    ]


def slip_faces(edges: Sequence[RationalVector]) -> list[State]:
    """Return slip along the normal of each side, and between that and the next."""
    normals, found = outward(edges), list[State]()
    for j, normal in enumerate(normals):
        k = (j + 1) % len(edges)
        found.append(SlipFace((normal,), (edges[j], edges[k])))
        found.append(SlipFace((normal, normals[k]), (edges[k],)))
    return found


def spatial_leaf_problem(
    question: SpatialQuestion, leaf: Leaf, states: Mapping[int, State], path: str
) -> str:
    """Return the inequality of a leaf that fails, or nothing."""
    problem, taken = displacement_work(question.max_displacement, leaf.displacements)
    if problem:
        return f"{path}: {problem}"
    scale = math.lcm(
        *(x.denominator for row in (leaf.motion, *leaf.multipliers.values()) for x in row)
    )
    motion = [int(x * scale) for x in leaf.motion]
    work: Any = dot(question.load, motion) - taken * scale * question.works
    rest: list[Any] = [0] * 6
    for i, contact in enumerate(question.contacts):
        state = states.get(i, "undecided")
        given = leaf.multipliers.get(i)
        alpha, *h = (0, 0, 0) if given is None else (int(x * scale) for x in given)
        row = contact.wrenches
        a, *b = (dot(row[j : j + 6], motion) for j in (0, 6, 12))
        room = a - alpha * contact.unit
        if question.edges:
            broken = _broken_pyramid(state, alpha, h, room, b, contact.friction, question.edges)
        else:
            broken = _broken_bound(state, alpha, h, room, b, contact.friction)
        if broken:
            return f"{path}: contact {i + 1}, {_named(state)}: {broken}"
        if given is not None:
            work += alpha * contact.per_work
            factors = -alpha * contact.per_alpha, h[0] * contact.per_h, h[1] * contact.per_h
            for j in range(6):
                rest[j] += factors[0] * row[j] + factors[1] * row[6 + j] + factors[2] * row[12 + j]
        if i in leaf.displacements:
            pins = [x * scale * contact.per_h for x in leaf.displacements[i]]
            for j in range(6):
                rest[j] += pins[0] * row[j] + pins[1] * row[6 + j] + pins[2] * row[12 + j]
    if any(rest):
        more = " and of the displacements" * bool(leaf.displacements)
        return f"{path}: the sum of -alpha k N + h T{more} is not 0"
    return "" if work > 0 else f"{path}: the work of load and contacts is not above 0"


def _broken_bound(
    state: State, alpha: int, h: Sequence[int], room: Any, b: Sequence[int], friction: Fraction
) -> str:
    """Return which bound of the multipliers of a contact is broken, or nothing.

    Args:
        room: ``a + rho - alpha``, in the unit of b.
    """
    if alpha < 0 and state in ("undecided", "detached"):
        return "alpha must be at least 0"
    if any(h) and state != "stick":
        if not isinstance(state, tuple):
            return "h must be 0"
        if any(dot(h, end) > 0 for end in state):
            return "h has a positive product with an end of the sector"
    if state == "detached":
        return ""
    square, size = dot(b, b), Fraction(1)
    if isinstance(state, tuple) and not (turn(state[0], b) >= 0 and turn(b, state[1]) >= 0):
        # The nearer end: the squares compare as the products do, since both ends are in view.
        along = [(dot(end, b), dot(end, end)) for end in state]
        signed = [(x * abs(x), length) for x, length in along]
        (square, size) = max(signed, key=lambda pair: pair[0] / pair[1])
    if square < 0:
        # alpha may be above a: at most a + mu |x . b|.
        return "" if room >= 0 or room * room * size <= friction**2 * -square else _LARGE
    return "" if room >= 0 and room * room * size >= friction**2 * square else _LARGE


def _broken_pyramid(
    state: State,
    alpha: int,
    h: Sequence[int],
    room: Any,
    b: Sequence[int],
    friction: Fraction,
    edges: Sequence[RationalVector],
) -> str:
    """Return which bound is broken with a pyramid in place of the round cone, or nothing."""
    if alpha < 0 and state in ("undecided", "detached"):
        return "alpha must be at least 0"
    if isinstance(state, SlipFace):
        # Along a normal alone, what h does across it is nothing.
        if any(dot(h, end) > 0 for end in state.ends):
            return "h has a positive product with a direction of slip"
        edges = state.edges
    elif any(h) and state != "stick":
        return "h must be 0"
    most = max(dot(edge, b) for edge in edges)
    return "" if state == "detached" or room >= friction * most else _LARGE


_LARGE = "alpha is larger than what the contact does on the virtual motion"


def _named(state: State) -> str:
    if isinstance(state, str):
        return state
    ends = (f"({', '.join(map(short, end))})" for end in getattr(state, "ends", state))
    return f"slip between {' and '.join(ends)}"


def turn(left: Sequence[Any], right: Sequence[Any]) -> Any:
    """Return a positive number where right is less than half a turn counter-clockwise of left."""
    return left[0] * right[1] - left[1] * right[0]
