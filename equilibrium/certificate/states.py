"""The checker's rule for multipliers, and trees that split the states of contacts alone, in R^n.

A leaf stands for states of contacts, and in `equilibrium.certificate.plane` for a region of motions
too. It has a virtual motion lambda and multipliers alpha, h of some contacts. With
``a = lambda . N`` and ``b = T lambda``, one number or two, the work of a contact on lambda is at
least ``alpha (q - k N . d) + h . T d`` for every motion d and all that the contact may do, if

* ``alpha >= 0`` where it is undecided or detached;
* ``alpha <= kappa`` unless it is detached. Kappa is a less mu times the greatest product of b with
  the unit vectors of directions in which the contact may slip. Where all are possible that is |b|;
  in slip+ it is b and in slip- it is -b; in the sector from u to v it is |b| if b is in the sector,
  else it is at an end: ``u . b / |u|`` or ``v . b / |v|``; in a pyramid it is at an edge;
* h = 0 but where it sticks, and where it slips with ``h . u <= 0`` for the ends u of the
  directions.

Without multipliers alpha and h are 0 here. Where only displacements of contact points up to D
count, numbers of a leaf for the normal and the tangents of a contact take D times their sizes from
the sum, and give what they are times the rows ``N . d`` and ``T . d``, see
`equilibrium.certificate.law.displacement_work`. Where all these together do not depend on d, and
are above minus the work of the load and of all adhesion, nothing balances the load. Roots are
compared by their squares.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import IntegerVector, RationalVector, dot
from equilibrium.model.errors import CertificateError

from .law import LawRow, applied, displacement_work, outward, short
from .reading import Leaf, Place, Split, TreeForm

#: A sector from u to v, counter-clockwise by less than half a turn.
Sector: TypeAlias = tuple[RationalVector, RationalVector]


class SlipFace(NamedTuple):
    """Slip in the cone of one or two directions, with friction between some edges of a pyramid."""

    ends: tuple[RationalVector, ...]
    edges: tuple[RationalVector, ...]


State: TypeAlias = str | Sector | SlipFace
#: The edges of a cone with one tangent.
_LINE: tuple[RationalVector, ...] = ((Fraction(1),), (Fraction(-1),))
#: What the states with a sign say, of one tangent.
_SIGNS = {
    name: SlipFace((end,), (end,)) for name, end in zip(("slip+", "slip-"), _LINE, strict=True)
}


class StateQuestion:
    """Contacts and load in integers, one unit for each kind of sum.

    Attributes:
        edges: of friction pyramids; none for round cones.
    """

    root: Sequence[Any] = ()

    def __init__(
        self,
        rows: Sequence[LawRow],
        load: RationalVector,
        form: TreeForm,
        edges: Sequence[RationalVector] = (),
        max_displacement: Fraction | None = None,
    ) -> None:
        self.form, self.edges, self.max_displacement = form, edges, max_displacement
        load = applied(rows, load)
        works = math.lcm(*(x.denominator for x in (*load, *(c.preload for c in rows))))
        self.load = tuple(whole(load, works))
        units = [math.lcm(*(x.denominator for row in c.wrenches for x in row)) for c in rows]
        pairs = list(zip(rows, units, strict=True))
        motions = math.lcm(*(c.stiffness.denominator * unit for c, unit in pairs))
        self.works = works
        self.contacts = [
            _IntegerContact(
                tuple(tuple(whole(row, unit)) for row in c.wrenches),
                unit,
                int(c.preload * works),
                int(c.stiffness * motions / unit),
                motions // unit,
                c.friction,
            )
            for c, unit in pairs
        ]

    def leaf_problem(self, leaf: Leaf, place: Place) -> str:
        """Return the inequality of a leaf that fails, or nothing."""
        path = place.path
        problem, taken = displacement_work(self.max_displacement, leaf.displacements)
        if problem:
            return f"{path}: {problem}"
        scale = math.lcm(
            *(x.denominator for row in (leaf.motion, *leaf.multipliers.values()) for x in row)
        )
        motion = whole(leaf.motion, scale)
        work: Any = dot(self.load, motion)
        rest: list[Any] = [0] * len(motion)
        cone = _LINE if self.form.tangents == 1 else self.edges
        none = [0] * (self.form.tangents + 1)
        for i, contact in enumerate(self.contacts):
            state, given = place.states.get(i, "undecided"), leaf.multipliers.get(i)
            alpha, *h = none if given is None else whole(given, scale)
            is_below = False
            if state != "detached":
                a, *b = [dot(row, motion) for row in contact.wrenches]
                is_below = _is_below(a - alpha * contact.unit, b, contact.friction, state, cone)
            if broken := broken_multipliers(state, alpha, h, is_below=is_below):
                return f"{path}: contact {i + 1}, {_named(state)}: {broken}"
            if given is None and i not in leaf.displacements:
                continue
            factors: list[Any] = [-alpha * contact.per_alpha, *(x * contact.per_h for x in h)]
            work += alpha * contact.per_work
            if i in leaf.displacements:
                pins = (x * scale * contact.per_h for x in leaf.displacements[i])
                factors = [x + pin for x, pin in zip(factors, pins, strict=True)]
            for factor, row in zip(factors, contact.wrenches, strict=True):
                if factor:
                    rest = [x + factor * y for x, y in zip(rest, row, strict=True)]
        if any(rest):
            more = " and of the displacements" * bool(leaf.displacements)
            return f"{path}: the sum of -alpha k N + h T{more} is not 0"
        is_above = work > taken * scale * self.works
        return "" if is_above else f"{path}: the work of load and contacts is not above 0"


class _IntegerContact(NamedTuple):
    """A contact: `wrenches` of the normal and the tangents, over `unit`.

    A multiplier alpha adds ``alpha per_work`` to the work and takes ``alpha per_alpha`` times the
    normal wrench away from what depends on the motion; h adds ``h per_h`` times a tangent's.
    """

    wrenches: tuple[IntegerVector, ...]
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
    contact, ends = split.at[0], list(map(_whole_direction, split.directions))
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


def broken_multipliers(state: State, alpha: Any, h: Sequence[Any], *, is_below: bool) -> str:
    """Return which condition the multipliers of a contact break, or nothing.

    Args:
        is_below: whether alpha is at most kappa, see above.
    """
    if alpha < 0 and state in ("undecided", "detached"):
        return "alpha must be at least 0"
    if any(h) and state != "stick":
        if not (ends := _slip_ends(state)):
            return "h must be 0"
        if any(dot(h, end) > 0 for end in ends):
            return "h has the wrong sign, a positive product with a direction of slip"
    return "" if is_below or state == "detached" else _LARGE


def _slip_ends(state: State) -> tuple[RationalVector, ...]:
    """Return what generates the directions of slip; nothing where there may be none."""
    slip = _SIGNS.get(state, state) if isinstance(state, str) else state
    return slip.ends if isinstance(slip, SlipFace) else slip if isinstance(slip, tuple) else ()


def _is_below(
    room: Any, b: Sequence[int], friction: Fraction, state: State, edges: Sequence[RationalVector]
) -> bool:
    """Return whether mu times the greatest product of b with directions of slip is at most room.

    Args:
        room: ``a - alpha``, in the unit of b.
        edges: of a cone that is not round.
    """
    if edges:
        slip = _SIGNS.get(state) if isinstance(state, str) else state
        possible = slip.edges if isinstance(slip, SlipFace) else edges
        return bool(room >= friction * max(dot(edge, b) for edge in possible))
    square, size = dot(b, b), 1
    if isinstance(state, tuple) and not (turn(state[0], b) >= 0 and turn(b, state[1]) >= 0):
        # The nearer end: the squares compare as the products do, since both ends are in view.
        along = [(dot(end, b), dot(end, end)) for end in state]
        (square, size), (other, length) = [(x * abs(x), length) for x, length in along]
        if other * size > square * length:
            square, size = other, length
    room *= friction.denominator
    reach = room * room * size - friction.numerator**2 * abs(square)
    # Below 0, alpha may be above a: at most a + mu |x . b|.
    return bool(room >= 0 or reach <= 0) if square < 0 else bool(room >= 0 and reach >= 0)


_LARGE = "alpha is larger than what the contact does on the virtual motion"


def _named(state: State) -> str:
    if isinstance(state, str):
        return state
    ends = (f"({', '.join(map(short, end))})" for end in getattr(state, "ends", state))
    return f"slip between {' and '.join(ends)}"


def whole(row: RationalVector, unit: int) -> list[int]:
    """Return a row times a multiple of its denominators."""
    return [x.numerator * (unit // x.denominator) for x in row]


def _whole_direction(row: RationalVector) -> RationalVector:
    """Return the same direction in integers."""
    unit = math.lcm(*(x.denominator for x in row))
    return tuple(whole(row, unit))  # type: ignore[arg-type]


def turn(left: Sequence[Any], right: Sequence[Any]) -> Any:
    """Return a positive number where right is less than half a turn counter-clockwise of left."""
    return left[0] * right[1] - left[1] * right[0]
