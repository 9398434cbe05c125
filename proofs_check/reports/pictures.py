"""Small pictures of instances as SVG text: great circles in a disk, contacts on a plane.

Views only, with floats rounded to a tenth of a pixel; no library, no script, nothing from outside.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from arrangement.exact import rational
from arrangement.linear import cross

_RADIUS = 90.0
_BOX = 200
_STEPS = 48
_OPEN = f'<svg viewBox="0 0 {_BOX} {_BOX}" width="{_BOX}" height="{_BOX}" role="img" aria-label='


def picture(document: Mapping[str, Any] | None) -> str:
    """Return a picture of an instance in file form, or "" where there is none.

    Central planes in R^3 are drawn as great circles: the front half of the sphere, as seen from
    the direction (3, -4, 6). A grasp is drawn as its contacts, each with a stroke that comes from
    outside along the normal.
    """
    if document is None:
        return ""
    if document.get("contacts"):
        return _grasp(document["contacts"])
    planes = document.get("planes")
    if planes and len(planes[0]) == 3 and "offsets" not in document:
        return _circles(planes)
    return ""


def _circles(rows: Sequence[Sequence[str]]) -> str:
    parts = [f'<circle cx="100" cy="100" r="{_RADIUS:.0f}" fill="#f4f4f4" stroke="#999"/>']
    for row in rows:
        points = _front_half([_number(x) for x in row])
        line = " ".join(f"{_text(x)},{_text(y)}" for x, y in points)
        parts.append(f'<polyline points="{line}" fill="none" stroke="#1b4f8a" stroke-width="1.5"/>')
    return f'{_OPEN}"{len(rows)} great circles">{"".join(parts)}</svg>'


def _front_half(normal: Sequence[float]) -> list[tuple[float, float]]:
    """Return points along the half of a great circle that faces the viewer."""
    n = _unit(normal)
    ahead = _unit((3.0, -4.0, 6.0))
    right = _unit(cross((0.0, 0.0, 1.0), ahead))
    up = cross(ahead, right)
    ahead_of = sum(x * y for x, y in zip(n, ahead, strict=True))
    flat = [a - ahead_of * b for a, b in zip(ahead, n, strict=True)]
    middle = _unit(flat) if math.hypot(*flat) > 1e-9 else right
    side = cross(n, middle)
    angles = [math.pi * (k / _STEPS - 0.5) for k in range(_STEPS + 1)]
    points = [
        [math.cos(a) * m + math.sin(a) * s for m, s in zip(middle, side, strict=True)]
        for a in angles
    ]
    return [
        (
            100 + _RADIUS * sum(p * q for p, q in zip(point, right, strict=True)),
            100 - _RADIUS * sum(p * q for p, q in zip(point, up, strict=True)),
        )
        for point in points
    ]


def _grasp(contacts: Sequence[Mapping[str, Any]]) -> str:
    points = [[_number(x) for x in contact["point"]] for contact in contacts]
    reach = max([1.0, *(abs(x) for point in points for x in point)]) * 1.6
    scale = _RADIUS / reach
    parts = [
        '<path d="M10,100H190M100,10V190" stroke="#ccc"/>',
    ]
    for contact, (x, y) in zip(contacts, points, strict=True):
        a, b = (_number(v) for v in contact["normal"])
        left, top = 100 + scale * x, 100 - scale * y
        ends = f'x2="{_text(left - 22 * a)}" y2="{_text(top + 22 * b)}"'
        start = f'x1="{_text(left)}" y1="{_text(top)}"'
        parts.append(f'<line {start} {ends} stroke="#1b4f8a" stroke-width="2"/>')
        parts.append(f'<circle cx="{_text(left)}" cy="{_text(top)}" r="4" fill="#b3261e"/>')
    return f'{_OPEN}"{len(contacts)} contacts">{"".join(parts)}</svg>'


def _number(text: Any) -> float:
    """Return a float near an exact number of any size, scaled into the range of floats."""
    value = rational(text)
    try:
        return float(value)
    except OverflowError:
        return math.copysign(1e300, value)


def _unit(v: Sequence[float]) -> tuple[float, ...]:
    largest = max(abs(x) for x in v)
    scaled = [x / largest for x in v]
    length = math.hypot(*scaled)
    return tuple(x / length for x in scaled)


def _text(x: float) -> str:
    return f"{round(x, 1) + 0.0:.1f}"
