"""Counts by the program that is proved in Coq (`proofs_check/formal`): a route of its own.

It gets planes as text and counts by recursion, one plane at a time; nothing of the counts and the
enumerators here takes part.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from arrangement.console import progress
from arrangement.console.number_form import sign_text
from arrangement.console.proved_program import ask_proved
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import to_text

from .faces import Face
from .planes import Planes


def proved_f_vector(planes: Planes) -> tuple[int, ...]:
    """Return the numbers of faces of dimension 0, ..., d, counted by the proved program.

    Raises:
        InputError: the program is not built, or entries are irrational.
        OutOfReachError: it would take too long; the forecast is that of planes in general position.
    """
    _forecast(planes, deepest=planes.rank)
    return _numbers("--faces", planes, planes.dimension)[::-1]


def proved_whitney_numbers(planes: Planes) -> tuple[int, ...]:
    """Return the coefficients of t^d, ..., t^(d - rank) in the characteristic polynomial.

    Their absolute values add up to the number of regions; that is the theorem.
    """
    _forecast(planes, deepest=0)
    return _numbers("--polynomial", planes, planes.rank)


def proved_complete(planes: Planes, faces: Iterable[Face]) -> bool:
    """Return whether these are all faces, each once and with a point that has its signs.

    Raises:
        InputError: as `proved_f_vector`; or a witness in another space.
    """
    _forecast(planes, deepest=planes.rank)
    listed = [[sign_text(face.signs), list(map(to_text, face.witness))] for face in faces]
    document = {"certificate": "all faces", "planes": _document(planes), "faces": listed}
    text = json.dumps({"schema_version": 1, **document})
    return ask_proved("-", text=text) == ("accepted", "all faces")


def _numbers(option: str, planes: Planes, last: int) -> tuple[int, ...]:
    _, rest = ask_proved(option, "-", text=json.dumps(_document(planes)))
    numbers = [int(word) for word in rest.split()][: last + 1]
    return (*numbers, *[0] * (last + 1 - len(numbers)))


def _document(planes: Planes) -> dict[str, Any]:
    if planes.field is not None:
        raise InputError(
            f"the entries are in {planes.field!r}, and the proved program counts rational planes; "
            "omit --proved"
        )
    rows = [list(map(to_text, plane)) for plane in planes.integer_planes]
    return {
        "schema_version": 1,
        "dimension": planes.dimension,
        "planes": [row[:-1] for row in rows],
        "offsets": [row[-1] for row in rows],
    }


def _forecast(planes: Planes, deepest: int) -> None:
    """Refuse what takes too long; say how long the rest takes at most, where it is long."""
    m, rank, central = len(planes), planes.rank, planes.has_common_point
    entries = (x for plane in planes.integer_planes for x in plane if isinstance(x, int))
    bits = max((x.bit_length() for x in entries), default=0)
    faces = 0.0
    for k in range(deepest + 1):
        others, r = m - k, rank - k
        regions = (
            2 * sum(budget.choose(others - 1, i) for i in range(r)) if central and r else
            sum(budget.choose(others, i) for i in range(r + 1))
        )  # fmt: skip
        faces += budget.choose(m, k) * regions
    # Measured: 10 microseconds a face for 100 planes of rank 3, less for fewer or deeper ones.
    seconds = faces * (1 + 0.1 * m) * (1 + bits * rank / 500) * 1e-6
    budget.ask(f"counting {budget.about(faces)} faces by the proved program", told=seconds)
    if seconds > 1:
        progress.note(
            f"the proved program counts at most {budget.about(faces)} faces; it takes up to "
            f"{budget.about(seconds)} seconds"
        )
