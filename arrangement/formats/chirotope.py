"""Chirotopes of rank 3 as texts of ``+``, ``-``, ``0``; on reading they get coordinates.

`chirotope` has the bases in reverse lexicographic order, as the database of Finschi and Fukuda
([FinschiFukuda2002]): one text a line. `topcom` has ``n,r:`` before them and lexicographic order,
as TOPCOM and polymake.
"""

from __future__ import annotations

import re
from math import comb

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts.oriented_matroid import ORDERS, chirotope_string
from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.library.census.chirotopes import Signs, triples

from .form import Format, Makers
from .realise import realise

_TEXT = re.compile(r"[-+0]+")
_TOPCOM = re.compile(r"\s*([0-9]{1,4})\s*,\s*([0-9]{1,4})\s*:([-+0\s]*)", re.ASCII)
#: Elements of a chirotope that is read.
MOST_ELEMENTS = 12


def size_of(text: str) -> int:
    """Return the number of elements of a chirotope of rank 3."""
    n = next((n for n in range(3, MOST_ELEMENTS + 1) if comb(n, 3) == len(text)), None)
    if n is None:
        raise InputError(
            f"the chirotope {shown(text)} has {len(text)} signs; of rank 3 and up to "
            f"{MOST_ELEMENTS} elements it has C(n, 3): 1, 4, 10, 20, 35, 56, 84, ..."
        )
    return n


def signs_of(text: str, order: str = ORDERS[0]) -> Signs:
    """Return the signs of a chirotope of rank 3 in lexicographic order."""
    rows = triples(size_of(text))
    written = np.array(["-0+".index(letter) - 1 for letter in text], dtype=np.int8)
    if order == ORDERS[0]:
        signs = np.empty_like(written)
        signs[np.lexsort(rows.T)] = written
        return signs
    return written


def is_chirotope(line: str) -> bool:
    """Whether a line consists of signs alone."""
    return _TEXT.fullmatch(line.strip()) is not None and bool(set(line) & {"+", "-"})


def _recognises(text: str) -> bool:
    lines = [line for line in text.splitlines() if line.strip()]
    return bool(lines) and all(map(is_chirotope, lines))


def _arrangement(text: str, order: str) -> Arrangement:
    return Arrangement(realise(signs_of(text, order), size_of(text)))


def _entries(text: str) -> Makers:
    return [lambda line=line: _arrangement(line, ORDERS[0]) for line in text.split()]  # type: ignore[misc]


def _topcom_entries(text: str) -> Makers:
    found = _TOPCOM.fullmatch(text)
    if found is None:
        raise InputError("a chirotope of TOPCOM is n,r: and the signs +, -, 0")
    signs = "".join(found[3].split())
    if int(found[2]) != 3 or comb(int(found[1]), 3) != len(signs):
        raise InputError(
            f"the chirotope is of {found[1]} elements of rank {found[2]} and has {len(signs)} "
            "signs; rank 3 with C(n, 3) signs is read"
        )
    return [lambda: _arrangement(signs, ORDERS[1])]


def _checked(arrangement: Arrangement) -> Arrangement:
    rank = arrangement.rank + (not arrangement.is_central)
    if rank != 3:
        raise InputError(f"the rank is {rank}; chirotopes of rank 3 are written")
    return arrangement


def _write(arrangement: Arrangement) -> str:
    return chirotope_string(_checked(arrangement)) + "\n"


def _write_topcom(arrangement: Arrangement) -> str:
    n = len(_checked(arrangement)) + (not arrangement.is_central)
    return f"{n},3:\n{chirotope_string(arrangement, ORDERS[1])}\n"


def _loses(arrangement: Arrangement) -> str:
    lost = "a chirotope holds no coordinates; read back it has others of the same type"
    return lost if arrangement.is_central else f"{lost}, and the plane at infinity as its last one"


FORMAT = Format(
    "chirotope",
    "chirotopes as Finschi and Fukuda write them",
    (".chi",),
    recognises=_recognises,
    entries=_entries,
    write=_write,
    loses=_loses,
)
TOPCOM = Format(
    "topcom",
    "chirotopes as TOPCOM and polymake write them",
    recognises=lambda text: _TOPCOM.fullmatch(text) is not None,
    entries=_topcom_entries,
    write=_write_topcom,
    loses=_loses,
)
