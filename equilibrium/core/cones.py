"""Cones of friction, round ones and pyramids: conditions on slips and forces, and how slips split.

A contact that slips is in a sector of directions. Round cones have sectors between two integer
directions, as narrow as it takes; a pyramid has a fixed number of them, see `Slip`. Along one
tangent there are two, the signs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.float_filter import Floats

from .contact_law import ContactState, Side, State as LinearState
from .float_law import smooth_slip

#: Integer directions in the frame of the tangents; a sector has two, counter-clockwise.
Direction: TypeAlias = tuple[int, int]
Sector: TypeAlias = tuple[Direction, Direction]


class Slip(NamedTuple):
    """Slip of a pyramid: along one direction, or between two; and the edges friction may use."""

    ends: tuple[RationalVector, ...]
    edges: tuple[RationalVector, ...]


#: "undecided", "detached", "attached", "stick", or directions of slip.
State: TypeAlias = str | Sector | Slip
#: The states of all contacts.
Node: TypeAlias = tuple[State, ...]

#: Sectors with a smaller sine of their angle are not cut.
NARROW_SINE = 1e-4
#: The first directions, and the middle of wide sectors, have integers up to about this.
_WIDE_SECTOR_SIZE = 8
#: Those of other sectors up to about this, over the sine: fine enough to lie inside.
_SECTOR_SIZE = 64
#: Sectors whose unit vectors are remembered.
_CACHED_SECTORS = 4096
#: What floats are off by at most in the least product of a middle direction with a sector's arc.
_MIDDLE_ERROR = Fraction(1, 2**48)
#: From this share of its limit on, smooth friction is that of a slip.
SLIP_SHARE = 0.9999


def lengths(rows: Floats) -> Floats:
    """Return the lengths of vectors along the tangents, one or two."""
    sizes: Floats = np.hypot.reduce(np.abs(rows), axis=-1)
    return sizes


def slip_sides(ends: Sequence[Sequence[Any]]) -> tuple[Side, ...]:
    """Return the conditions that a slip is along a direction, or between two."""
    if len(ends) == 1:
        across = [(True, (-y, x)) for x, y in ends] if len(ends[0]) == 2 else []
        return ((False, tuple(ends[0])), *across)
    (x, y), (v, w) = ends
    return (False, (-y, x)), (False, (w, -v))


class OpenSplit(NamedTuple):
    """A node that splits one contact, its children still open, and their states."""

    node: Any
    children: list[Any]
    parts: list[Node]

    def again(self) -> OpenSplit:
        """Return the same split, with all children open."""
        new: list[Any] = [None] * len(self.children)
        node = {key: new if x is self.children else x for key, x in self.node.items()}
        return OpenSplit(node, new, self.parts)


class RoundCones:
    """``|c_t| <= mu c_n``, and ``c_t = -mu c_n s / |s|`` at a slip s.

    Attributes:
        smooth: of slips, shares of friction limits made smooth, and minus how they change.
    """

    smooth = staticmethod(smooth_slip)

    def in_conditions(
        self, mu: Fraction, state: State, friction: Sequence[Side] = ()
    ) -> LinearState:
        """Return a state in linear conditions; in a sector with the chord that closes its arc.

        Args:
            friction: conditions in place of the round cone, which is not linear.
        """
        if isinstance(state, str):
            return ContactState.of(state, 2, tuple(friction)) if mu else state
        slip = slip_sides(state)
        if not mu:
            return ContactState("attached", slip, share=(0, 0))
        ends = _units(state)
        middle = ends.sum(axis=0) / np.hypot(*ends.sum(axis=0))
        # Along the middle the arc is at least as long as at one of its ends.
        low = Fraction(float((ends @ middle).min())) - _MIDDLE_ERROR
        chord = False, (-mu * low, *(-Fraction(x) for x in middle.tolist()))
        return ContactState("attached", slip, (*friction, chord))

    def support(self, b: Floats) -> Floats:
        """Return the largest products of b (m, 2) with a unit vector."""
        size: Floats = np.hypot(*b.T)
        return size

    def largest(self, state: State, b: Sequence[float]) -> float:
        """Return the largest product of b with a unit vector that the state allows."""
        x, y = b
        if isinstance(state, tuple):
            (p, q), (r, s) = _units(state).tolist()
            if p * y < q * x or x * s < y * r:
                return float(max(p * x + q * y, r * x + s * y))
        return math.hypot(x, y)

    def misses(self, limit: Floats, friction: Floats, slip: Floats) -> Floats:
        """Return how far friction forces (m, 2) are from what slips demand."""
        size = np.hypot(*slip.T)
        miss = friction + (limit / np.maximum(size, 1e-300))[:, None] * slip
        missed: Floats = np.hypot(*miss.T)
        return missed

    def below(self, room: int, mu: Fraction, b: Sequence[int], state: State) -> bool:
        """Return whether ``room >= mu x . b`` for all unit vectors x that the state allows."""
        (s, t), p, q = b, mu.numerator, mu.denominator
        if ends := self.ends(state):
            (x, y), (v, w) = ends
            if not (x * t - y * s >= 0 and s * w - t * v >= 0):
                return all(_above(q * room, p * (x * s + y * t), x * x + y * y) for x, y in ends)
        return room >= 0 and (q * room) ** 2 >= p * p * (s * s + t * t)

    def ends(self, state: State) -> Sequence[Any]:
        """Return the directions at the ends of a slip's sector; none of other states."""
        return state if isinstance(state, tuple) else ()

    def slips(self, states: Node, i: int, slip: Floats) -> OpenSplit | None:
        """Return the split of a contact by its slip, one part around a given one.

        None if its sector is too narrow.
        """
        state, parts = states[i], list[State]()
        sector: Any = self.ends(state)
        if not sector:
            ends = [_turned(slip, turn, _WIDE_SECTOR_SIZE) for turn in (-60, 60, 180)]
            parts = ["stick", *((ends[k - 1], ends[k]) for k in (1, 2, 0))]
        else:
            middle = self._middle(sector)
            if middle is None:
                return None
            ends, parts = [middle], [(sector[0], middle), (middle, sector[1])]
        children: list[Any] = [None] * len(parts)
        node = {"contact": i, "directions": [list(end) for end in ends], "children": children}
        return split_of(node, children, states, i, parts)

    def sine(self, state: State) -> float:
        """Return the sine of the angle of a sector, 1 for wide ones and other states."""
        return _sine(state) if isinstance(state, tuple) else 1.0

    def _middle(self, sector: Any) -> Direction | None:
        """Return integers near the middle of a sector; None if it is narrow."""
        sine = self.sine(sector)
        if sine < NARROW_SINE:
            return None
        x, y = _units(sector).sum(axis=0)
        scale = (_WIDE_SECTOR_SIZE if sine == 1.0 else _SECTOR_SIZE / sine) / math.hypot(x, y)
        return round(x * scale), round(y * scale)


class Pyramids:
    """Friction within ``mu c_n`` times a polygon, where it does most work against the slip.

    A contact that slips does so along the normal of a side of the polygon, with friction anywhere
    on the opposite side, or between two such normals, with friction at the opposite corner.

    Args:
        edges: the corners of the polygon, in the frame of tangents.
    """

    def __init__(self, edges: Sequence[RationalVector]) -> None:
        self.edges, self.all = edges, list[Slip]()
        self.normals = [
            tuple(x + y for x, y in zip(*pair, strict=True))
            for pair in pairwise((*edges, edges[0]))
        ]
        for j, normal in enumerate(self.normals):
            k = (j + 1) % len(edges)
            self.all.append(Slip((normal,), (edges[j], edges[k])))
            self.all.append(Slip((normal, self.normals[k]), (edges[k],)))
        self._corners = np.array(edges, dtype=float)

    def in_conditions(self, mu: Fraction, state: State) -> LinearState:
        """Return a state in linear conditions."""
        if isinstance(state, str):
            if not mu or state == "detached":
                return state
            return ContactState.of(state, len(self.edges[0]), self._inside(mu))
        assert isinstance(state, Slip)
        slip, (corner, *more) = slip_sides(state.ends), state.edges
        if more and mu:
            # On the side of the polygon that is opposite.
            (end,) = state.ends
            opposite = True, (mu * dot(end, corner), *end)
            return ContactState("attached", slip, (*self._inside(mu), opposite))
        return ContactState("attached", slip, share=tuple(-x for x in corner))

    def _inside(self, mu: Fraction) -> tuple[Side, ...]:
        """Return the conditions that friction is in the polygon."""
        return tuple((False, (mu * reach, *inward)) for reach, inward in self._sides)

    @cached_property
    def _sides(self) -> list[tuple[Fraction, RationalVector]]:
        """How far each side of the polygon is from its middle, and minus its normal."""
        pairs = zip(self.normals, self.edges, strict=True)
        return [(dot(normal, edge), tuple(-x for x in normal)) for normal, edge in pairs]

    def support(self, b: Floats) -> Floats:
        """Return the largest products of b (m, t) with an edge."""
        products: Floats = (b @ self._corners.T).max(axis=-1)
        return products

    def largest(self, state: State, b: Sequence[float]) -> float:
        """Return the largest product of b with an edge that the state allows."""
        edges = state.edges if isinstance(state, Slip) else self.edges
        return float(max(dot(edge, b) for edge in edges))

    def misses(self, limit: Floats, friction: Floats, slip: Floats) -> Floats:
        """Return how far friction forces (m, 2) are from what slips demand."""
        most = (slip @ self._corners.T).max(axis=1)
        power = limit * most + (friction * slip).sum(axis=1)
        missed: Floats = power / np.maximum(lengths(slip), 1e-300)
        return missed

    def weights(self, slip: Floats, eps: float) -> Floats:
        """Return how much of each edge is in minus the smooth friction, (m, edges)."""
        work = slip @ self._corners.T / eps
        weights: Floats = np.exp(work - work.max(axis=1, keepdims=True))
        weights /= weights.sum(axis=1, keepdims=True)
        return weights

    def directions(self, slip: Floats, eps: float) -> Floats:
        """Return the slips (m, 2) that the smooth friction shows: to a corner, a side, or none."""
        weights = self.weights(slip, eps)
        pairs = weights + np.roll(weights, -1, axis=1)
        corner, side = weights.argmax(axis=1), pairs.argmax(axis=1)
        normals = np.array(self.normals, dtype=float)
        along_sides = np.where((pairs.max(axis=1) > SLIP_SHARE)[:, None], normals[side], 0.0)
        slips: Floats = np.where(
            (weights.max(axis=1) > SLIP_SHARE)[:, None], self._corners[corner], along_sides
        )
        return slips

    def smooth(self, slip: Floats, eps: Any) -> tuple[Floats, Floats]:
        """Return shares of friction limits (m, 2), made smooth, and minus how they change."""
        weights = self.weights(slip, eps)
        mean = weights @ self._corners
        squares = np.einsum("mk,ki,kj->mij", weights, self._corners, self._corners)
        return -mean, (squares - mean[:, :, None] * mean[:, None, :]) / eps

    def below(self, room: int, mu: Fraction, b: Sequence[int], state: State) -> bool:
        """Return whether ``room >= mu x . b`` for all edges x that the state allows."""
        edges = state.edges if isinstance(state, Slip) else self.edges
        return bool(room >= mu * max(dot(edge, b) for edge in edges))

    def ends(self, state: State) -> Sequence[Any]:
        """Return the directions at the ends of a slip's sector; none of other states."""
        return state.ends if isinstance(state, Slip) else ()

    def slips(self, states: Node, i: int, slip: Floats) -> OpenSplit | None:
        """Return the split of a contact by its slip; None if that is decided."""
        if states[i] != "attached":
            return None
        children: list[Any] = [None] * (1 + len(self.all))
        return split_of(
            {"contact": i, "faces": children}, children, states, i, ["stick", *self.all]
        )

    def sine(self, state: State) -> float:
        """Return 1: no sector is narrow."""
        return 1.0


#: The two slips along one tangent.
_SIGNS = [Slip(((Fraction(x),),), ((Fraction(x),),)) for x in (1, -1)]


class LineCones(Pyramids):
    """Friction along one tangent, ``|c_t| <= mu c_n``: a pyramid of two edges, the signs."""

    smooth = staticmethod(smooth_slip)

    def __init__(self) -> None:
        self.all = list(_SIGNS)
        self.edges = self.normals = [slip.edges[0] for slip in self.all]
        self._corners = np.array(self.edges, dtype=float)

    def below(self, room: int, mu: Fraction, b: Sequence[int], state: State) -> bool:
        """Return whether ``room >= mu x b`` for all signs x that the state allows."""
        most = int(state.edges[0][0]) * b[0] if isinstance(state, Slip) else abs(b[0])
        return mu.denominator * room >= mu.numerator * most

    def directions(self, slip: Floats, eps: float) -> Floats:
        """Return the slips (m, 1) that the smooth friction shows: a sign, or none."""
        ratio, _ = self.smooth(slip, eps)
        slips: Floats = np.where(np.abs(ratio) > SLIP_SHARE, -np.sign(ratio), 0.0)
        return slips

    def slips(self, states: Node, i: int, slip: Floats) -> OpenSplit | None:
        """Return the split of a contact by its slip; None if that is decided."""
        if states[i] != "attached":
            return None
        children: list[Any] = [None] * 3
        node = {"contact": i, "slip": children}
        return split_of(node, children, states, i, ["stick", *self.all])


Cones: TypeAlias = RoundCones | Pyramids
#: The children of splits, by their keys in certificates.
_CHILDREN = {"attachment": ("detached", "attached"), "slip": ("stick", "slip+", "slip-")}


def split_of(
    node: Any, children: list[Any], states: Node, i: int, parts: Sequence[State]
) -> OpenSplit:
    """Return the split of one contact into its parts."""
    return OpenSplit(node, children, [(*states[:i], part, *states[i + 1 :]) for part in parts])


def finished(node: Any) -> Any:
    """Return a tree in the form of certificates."""
    for key, names in _CHILDREN.items():
        if isinstance(node, dict) and key in node:
            return {**node, key: dict(zip(names, map(finished, node[key]), strict=True))}
    for key in ("children", "faces"):
        if isinstance(node, dict) and key in node:
            return {**node, key: list(map(finished, node[key]))}
    return node


@lru_cache(maxsize=_CACHED_SECTORS)
def _units(sector: Sector) -> Floats:
    return np.array([(x / math.hypot(x, y), y / math.hypot(x, y)) for x, y in sector])


@lru_cache(maxsize=_CACHED_SECTORS)
def _sine(sector: Sector) -> float:
    """Return the sine of the angle of a sector, 1 for wide ones."""
    u, v = _units(sector)
    return float(u[0] * v[1] - u[1] * v[0]) if u @ v > 0 else 1.0


def _turned(direction: Floats, degrees: float, size: int) -> Direction:
    """Return integers near a direction, turned."""
    angle = math.atan2(direction[1], direction[0]) + math.radians(degrees)
    return round(size * math.cos(angle)), round(size * math.sin(angle))


def _above(room: int, product: int, square: int) -> bool:
    """Return whether ``room >= product / sqrt(square)``."""
    if room >= 0 >= product:
        return True
    if room < 0 <= product:
        return False
    larger = room * room * square >= product * product
    return larger if room >= 0 else room * room * square <= product * product
