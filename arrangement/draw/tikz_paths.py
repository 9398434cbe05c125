"""Points, numbers and paths in the syntax of TikZ."""

from __future__ import annotations

from .items import Box, Path, Place


def outline(item: Path) -> str:
    """Return the path of a line or a shape."""
    if item.kind == "circle":
        return disc(item.points, item.radius)
    if item.kind == "curve":
        start, *rest = map(point, item.points)
        pieces = [start]
        for p, q, end in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
            straight = {p, q} <= {start, end}
            pieces.append(f"-- {end}" if straight else f".. controls {p} and {q} .. {end}")
            start = end
        return " ".join(pieces)
    return " -- ".join([*map(point, item.points), *["cycle"] * (item.kind == "polygon")])


def clip_path(clip: Box | tuple[Place, float]) -> str:
    """Return the box or disc to which an item is cut."""
    if len(clip) == 2:
        return disc(*clip)
    left, low, right, high = clip
    return f"{point((left, low))} rectangle {point((right, high))}"


def disc(centre: Place, radius: float) -> str:
    """Return a circle."""
    return f"{point(centre)} circle[radius={number(radius)}]"


def cut(shape: str) -> str:
    """Return the command that cuts what follows to a path."""
    return rf"\clip {shape};"


def point(place: Place) -> str:
    """Return a point of the picture."""
    return f"({number(place[0])},{number(place[1])})"


def number(value: float, digits: int = 2) -> str:
    """Return a number with few digits, and no negative zero."""
    return f"{round(float(value), digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")
