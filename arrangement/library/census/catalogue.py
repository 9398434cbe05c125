"""The shipped list of types, read and checked on reading."""

from __future__ import annotations

import json
from functools import lru_cache
from importlib.resources import files
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.exact import shown

#: The largest number of planes in the shipped list.
MOST_PLANES = 8
#: Published numbers of types, all and simple ([FinschiFukuda2002]; all realisable for m <= 8).
PUBLISHED = {3: 1, 4: 2, 5: 4, 6: 17, 7: 143, 8: 4890}
PUBLISHED_SIMPLE = {3: 1, 4: 1, 5: 1, 6: 4, 7: 11, 8: 135}


@lru_cache(maxsize=1)
def _document() -> dict[str, Any]:
    text = files(__package__).joinpath("types.json").read_text(encoding="utf-8")
    document: dict[str, Any] = json.loads(text)
    return document


def normals(planes: int) -> list[list[list[int]]]:
    """Return the rows of normals of every type of so many planes, as they are in the list."""
    listed: list[list[list[int]]] = _document()["types"][str(planes)]
    return listed


@lru_cache(maxsize=2 * MOST_PLANES)
def census(planes: int, *, simple: bool = False) -> tuple[Arrangement, ...]:
    """Return one arrangement of each combinatorial type of `planes` distinct planes of rank 3.

    Types are up to relabelling of planes and exchange of their sides. All are central, in R^3,
    with small integer normals. Complete: the numbers are the published ones, 1, 2, 4, 17, 143,
    4890 for 3 to 8 planes (1, 1, 1, 4, 11, 135 simple), and no two have the same type.

    Args:
        planes: 3 to 8.
        simple: only the types in general position.

    Raises:
        InputError: another number of planes.

    Source: the counts, [FinschiFukuda2002]; the representatives, `generate`.

    >>> [len(census(m)) for m in (3, 4, 5, 6, 7)]
    [1, 2, 4, 17, 143]
    """
    if type(planes) is not int or not 3 <= planes <= MOST_PLANES:
        raise InputError(f"planes is {shown(planes)}; the census has types of 3 to {MOST_PLANES}")
    listed = map(Arrangement, normals(planes))
    if not simple:
        return tuple(listed)
    return tuple(arrangement for arrangement in listed if arrangement.is_simple)
