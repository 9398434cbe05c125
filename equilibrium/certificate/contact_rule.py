"""What one contact may do on a virtual motion: steps 2 and 3 of `certificate.leaf_rule`.

The state of a contact says in which directions it may slip. Its factor kappa follows from the
greatest product of a vector with unit vectors in these directions, and they bound its multipliers.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

from arrangement.numbers.exact import RationalVector, dot

from .law import short

#: A sector from u to v, counter-clockwise by less than half a turn.
Sector: TypeAlias = tuple[RationalVector, RationalVector]


class SlipFace(NamedTuple):
    """Slip in the cone of one or two directions, with friction between some edges of a pyramid."""

    ends: tuple[RationalVector, ...]
    edges: tuple[RationalVector, ...]


State: TypeAlias = str | Sector | SlipFace
#: The directions of slip of the states with a sign, of one tangent.
_SIGNS: dict[str, tuple[RationalVector, ...]] = {
    "slip+": ((Fraction(1),),),
    "slip-": ((Fraction(-1),),),
}
_LARGE = "alpha is larger than what the contact does on the virtual motion"


def broken_multipliers(state: State, alpha: Any, h: Sequence[Any], *, is_below: bool) -> str:
    """Return which condition of step 3 the multipliers of a contact break, or nothing.

    Args:
        is_below: whether alpha is at most kappa.
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
    if isinstance(state, SlipFace):
        return state.ends
    return _SIGNS.get(state, ()) if isinstance(state, str) else state


def with_sign(state: State, slips: Sequence[int]) -> State:
    """Return the state of a contact with its slip where it slips one way in a whole region."""
    if slips and state in ("undecided", "attached"):
        if all(s > 0 for s in slips):
            return "slip+"
        if all(s < 0 for s in slips):
            return "slip-"
    return state


def greatest_product(b: Sequence[int], state: State, edges: Sequence[Sequence[Any]]) -> Any:
    """Return the greatest product of b with directions of slip, of a cone that is not round."""
    if len(b) == 1:
        return -b[0] if state == "slip-" else b[0] if state == "slip+" else abs(b[0])
    return max(dot(edge, b) for edge in (state.edges if isinstance(state, SlipFace) else edges))


def within_room(room: Any, b: Sequence[int], friction: Fraction, state: State) -> bool:
    """Return whether mu times the greatest product of b with directions of slip is at most room.

    Args:
        room: ``a - alpha``, in the unit of b.
        state: of a contact with a round cone.
    """
    (x, y), size = b, 1
    square = x * x + y * y
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


def state_text(state: State) -> str:
    """Return a state for a message."""
    if isinstance(state, str):
        return state
    ends = (f"({', '.join(map(short, end))})" for end in getattr(state, "ends", state))
    return f"slip between {' and '.join(ends)}"


def turn(left: Sequence[Any], right: Sequence[Any]) -> Any:
    """Return a positive number where right is less than half a turn counter-clockwise of left."""
    return left[0] * right[1] - left[1] * right[0]
