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

from .realise import realise

_SIGNS = re.compile(r"[-+0]+")
#: What lists of Finschi have beside signs: the elements of each basis above, a name in each line.
_HEAD = re.compile(r"^[ \t]*[0-9]+[ \t]*$", re.MULTILINE)
_NAME = re.compile(r"^[ \t]*IC\([ 0-9]+,([ 0-9]+),[ 0-9]+\)[ \t]*=", re.MULTILINE)
#: A chirotope as TOPCOM writes it: elements, rank, signs, and perhaps generators of its symmetries.
TOPCOM = re.compile(
    r"\s*([0-9]{1,4})\s*,\s*([0-9]{1,4})\s*:([-+0\s]*)(?:\[[\[\]0-9,\s]*)?", re.ASCII
)
#: Elements of a chirotope that is read.
MOST_ELEMENTS = 12


def size_of(text: str) -> int:
    """Return the number of elements of a chirotope of rank 3."""
    n = next((n for n in range(3, MOST_ELEMENTS + 1) if comb(n, 3) == len(text)), None)
    if _SIGNS.fullmatch(text) is None:
        raise InputError(f"the chirotope {shown(text)} has letters beside +, -, 0")
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
    return _SIGNS.fullmatch(line.strip()) is not None and bool(set(line) & {"+", "-"})


def recognises(text: str) -> bool:
    """Whether a text has chirotopes alone, or is a list of Finschi."""
    lines = _signs_alone(text)
    return bool(lines) and all(map(is_chirotope, lines))


def split(text: str) -> list[str]:
    """Return the chirotopes of a text, one a line."""
    ranks = {int(rank) for rank in _NAME.findall(text)}
    if not ranks <= {3}:
        raise InputError(f"the list has chirotopes of rank {max(ranks)}; those of rank 3 are read")
    return _signs_alone(text)


def _signs_alone(text: str) -> list[str]:
    return _NAME.sub("", _HEAD.sub("", text)).split()


def read(text: str) -> Arrangement:
    """Return an arrangement with these signs, in reverse lexicographic order."""
    return Arrangement(realise(signs_of(text), size_of(text)))


def read_topcom(text: str) -> Arrangement:
    """Return an arrangement with these signs, in lexicographic order."""
    found = TOPCOM.fullmatch(text)
    if found is None:
        raise InputError("a chirotope of TOPCOM is n,r: and the signs +, -, 0")
    signs = "".join(found[3].split())
    if int(found[2]) != 3 or comb(int(found[1]), 3) != len(signs):
        raise InputError(
            f"the chirotope is of {found[1]} elements of rank {found[2]} and has {len(signs)} "
            "signs; rank 3 with C(n, 3) signs is read"
        )
    return Arrangement(realise(signs_of(signs, ORDERS[1]), size_of(signs)))


def _checked(arrangement: Arrangement) -> Arrangement:
    rank = arrangement.rank + (not arrangement.is_central)
    if rank != 3:
        raise InputError(f"the rank is {rank}; chirotopes of rank 3 are written")
    return arrangement


def write(arrangement: Arrangement) -> str:
    """Write the signs in reverse lexicographic order."""
    return chirotope_string(_checked(arrangement)) + "\n"


def write_topcom(arrangement: Arrangement) -> str:
    """Write the signs in lexicographic order."""
    n = len(_checked(arrangement)) + (not arrangement.is_central)
    return f"{n},3:\n{chirotope_string(arrangement, ORDERS[1])}\n"


def loses(arrangement: Arrangement) -> str:
    """Say that coordinates are lost."""
    lost = "a chirotope holds no coordinates; read back it has others of the same type"
    return lost if arrangement.is_central else f"{lost}, and the plane at infinity as its last one"
