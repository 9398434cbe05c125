"""Planes as the arrangement lab has them: lines of R^2, or central planes of R^3."""

from __future__ import annotations

from arrangement.arrangement import Arrangement
from arrangement.counts import essentialization
from arrangement.errors import InputError
from arrangement.exact import rational, shown

#: Planes beyond which dragging stutters.
MAX_PLANES = 20
#: Longest numbers that the page reads.
MAX_DIGITS = 1000


def as_shown(arrangement: Arrangement) -> Arrangement:
    """Return planes as the page has them: lines of R^2, or central planes of R^3.

    Raises:
        InputError: there is no such form, or it is too large.
    """
    shown_planes = arrangement
    if arrangement.field is not None:
        raise InputError(
            f"the planes have entries in {arrangement.field!r}, and the lab counts in integers; "
            "`arrangement draw FILE -o page.html` shows central ones, exactly"
        )
    if arrangement.dimension not in (2, 3) or (
        arrangement.dimension == 3 and not arrangement.is_central
    ):
        flat = not arrangement.is_central
        if arrangement.rank > (2 if flat else 3):
            kind = "affine" if flat else "central"
            raise InputError(
                f"{kind} planes of rank {arrangement.rank} in R^{arrangement.dimension}; the lab "
                "takes central planes of rank at most 3 and affine ones of rank at most 2"
            )
        shown_planes = _padded(essentialization(arrangement), 2 if flat else 3)
    if len(shown_planes) > MAX_PLANES:
        raise InputError(f"{len(shown_planes)} planes; the lab takes at most {MAX_PLANES}")
    numbers = (abs(x) for plane in shown_planes.integer_planes for x in plane)
    if max(numbers, default=0) >= 10**MAX_DIGITS:
        raise InputError(f"a number has more digits than {MAX_DIGITS}, which the lab takes at most")
    return shown_planes


def _padded(planes: Arrangement, dimension: int) -> Arrangement:
    zeros = (0,) * (dimension - planes.dimension)
    rows = [(*normal, *zeros) for normal in planes.normals]
    return Arrangement(rows, planes.offsets, dimension=dimension)


def read_start(text: str) -> Arrangement:
    """Return the planes of a link of the page, as it is after ``#``: ``1|3|1,0,0;0,1,0``.

    Raises:
        InputError: no such link.
    """
    version, *parts = text.split("|")
    if version != "1" or len(parts) != 2 or parts[0] not in ("2", "3"):
        raise InputError(
            f"{shown(text)} is not what a link of the lab has after #: 1|dimension|planes"
        )
    rows = [row.split(",") for row in parts[1].split(";") if row]
    for row in rows:
        if len(row) != 3:
            raise InputError(f"plane {shown(','.join(row))} needs three numbers")
    dimension = int(parts[0])
    offsets = [rational(row[2]) for row in rows] if dimension == 2 else None
    return as_shown(Arrangement([row[:dimension] for row in rows], offsets, dimension=dimension))
