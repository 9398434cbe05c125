"""The outline of the object: the one that is stated, else a smooth curve through the contacts.

Unless the grasp or the caller states an outline, it is only indicative: a curve that passes through
every contact point with the tangent that the normal asks for. Where the contacts can belong to a
convex object, the curve is convex or nearly so; otherwise it goes round the contacts in angular
order. If that curve crosses itself, there is none.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import numpy as np

from arrangement.drawing.scene import Floats, PageMap, arc, curve_points
from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.rank import cycle_edges, difference
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Circle, Outline


@dataclass(frozen=True)
class Frame:
    """Paper coordinates: exact points, moved and scaled so that a square or cube fills [-1, 1].

    The subtraction and division are exact, so coordinates of any size lose nothing.

    Attributes:
        centre, half: exact middle and half side.
    """

    centre: RationalVector
    half: Fraction

    def paper(self, point: Iterable[Fraction]) -> Floats:
        """Return a point on paper."""
        pairs = zip(point, self.centre, strict=True)
        return np.array([float((x - c) / self.half) for x, c in pairs])

    def page_map(self, scale: float, shift: Floats) -> PageMap:
        """Return where points of the plane are, if a place p on paper is at ``scale * p + shift``.

        In numbers beyond floats they have none.
        """
        try:
            unit = scale / float(self.half)
            x, y = (float(s) - unit * float(c) for s, c in zip(shift, self.centre, strict=True))
        except (OverflowError, ZeroDivisionError):
            return PageMap()
        return PageMap(unit, (x, y))


def frame_of(grasp: Grasp, outline: Outline | None = None) -> Frame:
    """Return the frame in which contacts and outline fill [-1, 1] in the longer direction."""
    places = [contact.point for contact in grasp]
    return frame_around([*places, *(outline.extremes if outline else ())], grasp.dimension)


def frame_around(points: Sequence[RationalVector], dimension: int = 2) -> Frame:
    """Return the frame in which points fill [-1, 1] in the longer direction."""
    if not points:
        return Frame((Fraction(0),) * dimension, Fraction(1))
    centre, half = middle_of(points)
    return Frame(centre, half or Fraction(1))


def middle_of(points: Sequence[RationalVector]) -> tuple[RationalVector, Fraction]:
    """Return the middle of the box around points, and half of its longest side."""
    lows, highs = ([end(column) for column in zip(*points, strict=True)] for end in (min, max))
    half = max(high - low for low, high in zip(lows, highs, strict=True)) / 2
    return tuple((low + high) / 2 for low, high in zip(lows, highs, strict=True)), half


def stated_body(outline: Outline, frame: Frame) -> Floats:
    """Return a stated outline as cubic control points (3k + 1, 2)."""
    if isinstance(outline, Circle):
        radius = float(outline.radius / frame.half)
        return arc(frame.paper(outline.centre), radius, 0.0, 2 * math.pi)
    return closed_line([frame.paper(corner) for corner in outline.extremes])


def closed_line(places: Sequence[Floats]) -> Floats:
    """Return straight lines through places and back as cubic control points (3k + 1, 2)."""
    return _joined([(p, p, q, q) for p, q in cycle_edges(places)])


def body(grasp: Grasp, frame: Frame) -> Floats | None:
    """Return an indicative outline as cubic control points (3k + 1, 2), or None."""
    distinct = dict.fromkeys((c.point, c.normal) for c in grasp)
    stops = [
        (frame.paper(point), np.array([float(normal[1]), -float(normal[0])]))
        for point, normal in distinct
    ]
    if not stops:
        return None
    # Whether no contact lies behind the tangent line of another (exact).
    if all(dot(n, difference(q, p)) >= 0 for p, n in distinct for q, _ in distinct):
        return _convex(stops)
    middle = np.mean([p for p, _ in stops], axis=0)
    for centre in (middle, frame.paper((Fraction(0),) * 2)):
        if np.abs(centre).max() <= 2 and (curve := _around(stops, centre)) is not None:
            return curve
    return None


_Stop = tuple[Floats, Floats]
_Piece = tuple[Floats, Floats, Floats, Floats]


def _convex(stops: Sequence[_Stop]) -> Floats:
    """Join contacts in the order of their tangent directions, counter-clockwise."""
    order = sorted(stops, key=lambda s: (round(_angle(s[1]), 9), float(s[0] @ s[1])))
    pieces: list[_Piece] = []
    for (p, u), (q, v) in cycle_edges(order):
        turn = (_angle(v) - _angle(u)) % (2 * math.pi)
        if min(turn, 2 * math.pi - turn) < 1e-9:
            turn = 2 * math.pi if float((q - p) @ u) <= 0 else 0.0
        between = _filled(p, u, q, turn) if turn > math.pi - 1e-9 else []
        chain = [(p, u), *between, (q, v)]
        pieces += [_bend(*a, *b) for a, b in pairwise(chain)]
    return _joined(pieces)


def _filled(p: Floats, u: Floats, q: Floats, turn: float) -> list[_Stop]:
    """Return further stops where the outline turns by half a turn or more."""
    half = _turned(u, turn / 2)
    outward = np.array([half[1], -half[0]])
    middle, reach = (p + q) / 2, max(float(np.linalg.norm(q - p)), 1.0) / 2
    if turn < 1.15 * math.pi:
        return [(middle + reach * outward, half)]
    # A circle that touches the tangent lines of both ends.
    normal = np.array([-u[1], u[0]])
    centre = middle + outward * (reach - float(normal @ (middle - p))) / float(normal @ outward)
    number = math.ceil(turn / (0.5 * math.pi) - 1e-9) - 1
    tangents = [_turned(u, turn * (j + 1) / (number + 1)) for j in range(number)]
    return [(centre + reach * np.array([w[1], -w[0]]), w) for w in tangents]


def _bend(p: Floats, u: Floats, q: Floats, v: Floats) -> _Piece:
    """Return a cubic from p along u to q along v, that of a circle where one fits."""
    chord = float(np.linalg.norm(q - p))
    sine = float(u[0] * v[1] - u[1] * v[0])
    turn = abs(math.atan2(sine, float(u @ v)))
    if turn < 1e-9 or abs(sine) < 1e-9:
        before = after = chord / 3
    else:
        away = q - p
        before = float(away[0] * v[1] - away[1] * v[0]) / sine
        after = float(u[0] * away[1] - u[1] * away[0]) / sine
        share = 4 / 3 * math.tan(turn / 4) / math.tan(turn / 2)
        before, after = (min(max(share * arm, 0.0), 0.9 * chord) for arm in (before, after))
    return p, p + before * u, q - after * v, q


def _around(stops: Sequence[_Stop], centre: Floats) -> Floats | None:
    """Join contacts in angular order around a centre; None when the curve crosses itself."""
    order = sorted(stops, key=lambda s: (round(_angle(s[0] - centre), 9), _angle(s[1])))
    pieces = []
    for (p, u), (q, v) in cycle_edges(order):
        arm = 0.38 * float(np.linalg.norm(q - p))
        pieces.append((p, p + arm * u, q - arm * v, q))
    curve = _joined(pieces)
    return None if len(stops) < 3 or _crosses(curve_points(curve, 12)) else curve


def _crosses(points: Floats) -> bool:
    """Return whether a closed polygon crosses itself or runs clockwise."""
    ends = np.roll(points, -1, axis=0)
    if float(np.sum(points[:, 0] * ends[:, 1] - points[:, 1] * ends[:, 0])) <= 0:
        return True

    def sides(a: Floats, b: Floats, c: Floats) -> Floats:
        edge, away = (b - a)[:, None], c[None] - a[:, None]
        areas: Floats = edge[..., 0] * away[..., 1] - edge[..., 1] * away[..., 0]
        return areas

    apart = sides(points, ends, points) * sides(points, ends, ends) < -1e-18
    return bool((apart & apart.T).any())


def free_lengths(outline: Floats, start: Floats, angles: Floats) -> Floats:
    """Return how far one can go inside a closed polygon from a point of it, in some directions.

    0 where the outside begins at once.
    """
    ends, near = np.roll(outline, -1, axis=0), 1e-3
    directions = np.stack([np.cos(angles), np.sin(angles)], axis=1)[:, None]
    along, away = ends - outline, outline - start
    across = directions[..., 0] * along[:, 1] - directions[..., 1] * along[:, 0]
    across = np.where(np.abs(across) < 1e-12, 1e-12, across)
    length = (away[:, 0] * along[:, 1] - away[:, 1] * along[:, 0]) / across
    at = (away[:, 0] * directions[..., 1] - away[:, 1] * directions[..., 0]) / across
    hits = (length > 2 * near) & (at >= 0) & (at <= 1)
    free = np.where(hits, length, np.inf).min(axis=1)
    # Whether a point just ahead is inside: by the edges above and below it.
    x, y = np.moveaxis(start + near * directions, -1, 0)
    crossed = (outline[:, 1] > y) != (ends[:, 1] > y)
    slope = along[:, 0] / np.where(along[:, 1] == 0, 1, along[:, 1])
    right = crossed & (x < outline[:, 0] + (y - outline[:, 1]) * slope)
    lengths: Floats = np.where(right.sum(axis=1) % 2 == 1, free, 0.0)
    return lengths


def _joined(pieces: Sequence[_Piece]) -> Floats:
    return np.array([pieces[0][0], *(x for piece in pieces for x in piece[1:])])


def _angle(vector: Floats) -> float:
    return math.atan2(vector[1], vector[0]) % (2 * math.pi)


def _turned(vector: Floats, angle: float) -> Floats:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])
