"""The numbers of the paper, character by character as printed in its tables.

[HaasHeger2018], the three tables. Nothing here is computed or corrected. A cell that is not a
vector of numbers is a misprint; `read_vector` says so and returns the reading that is assumed.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

#: Table II: number of contacts -> printed number of slip states.
STATE_COUNTS = {2: 10, 3: 26, 4: 50, 5: 82, 6: 122, 7: 170, 8: 226, 9: 290}

_NUMBER = re.compile(r"-?[0-9]+(?:\.[0-9]+)?")


@dataclass(frozen=True)
class PrintedRow:
    """One row of a result table: wrench, preload, verdict, forces (normal, tangential), motion."""

    wrench: str
    preload: str
    stable: str
    forces: tuple[str, ...] = ()
    motion: str = ""


_THREE = """
(0, 0, 0)   | 0 | Yes | (0,0) (0,0) (0,0)       | (0,0,0)
(0, 0, 0)   | 1 | Yes | (1,-0.5) (1,0) (1,0.5)  | (0,0,0)
(0, -1, 0)  | 0 | Yes | (0,0) (1,0) (0,0)       | (0,-1,0)
(0, -2, 0)  | 0 | Yes | (0,0) (2,0) (0,0)       | (0,-2,0)
(0, 1, 0)   | 0 | No
(0, 1, 0)   | 1 | Yes | (1,-0.5) (0,0) (1,0.5)  | (0,1,0)
(0, 1.1, 0) | 1 | No
"""

_FOUR = """
(0, 0, 0)  | 0 | Yes | (0,0) (0,0) (0,0) (0,0)                         | (0,0,0)
(0, 0, 0)  | 1 | Yes | (1,0) (1,0) (1,0) (1,0)                         | (0,0,0)
(0, 2, 0)  | 0 | No
(0, -2, 0) | 0 | No
(0, 2, 0)  | 1 | Yes | (1,-0.5) (1,-0.5) (1,0.5) (1,0.5)               | (0,0,0)
(0, -2, 0) | 1 | Yes | (1,0.5) (1,0.5) (1,-0.5) (1,-0.5)               | (0,0,0)
(0, 0,3)   | 0 | Yes | (1,0.5) (0,0) (1,0.5) (0,0)                     | (0,-1,1)
(0, 0,-3)  | 0 | Yes | (0,0) (1,-0.5) (0,0) (1,-0.5)                   | (0,1,-1)
(0, 0,3)   | 1 | Yes | (1.25,0.625) (0.75,0.375) (1.25,0.625) (0.75,0.375) | (0,-0.25,0.25)
(0, 0,-3)  | 1 | Yes | (0.75,-0.375) (1.25,-0.625) (0.75,-0.375) (1.25,-0.625) | (0,0.0.25,-0.25)
"""


def _rows(table: str) -> tuple[PrintedRow, ...]:
    rows = []
    for line in table.strip().splitlines():
        wrench, preload, stable, *rest = [cell.strip() for cell in line.split("|")]
        forces, motion = (tuple(rest[0].split()), rest[1]) if rest else ((), "")
        rows.append(PrintedRow(wrench, preload, stable, forces, motion))
    return tuple(rows)


THREE_CONTACTS = _rows(_THREE)
FOUR_CONTACTS = _rows(_FOUR)


def read_vector(cell: str) -> tuple[tuple[Fraction, ...], str]:
    """Return the numbers of a printed vector, and the assumption it took to read it (or "").

    >>> read_vector("(0,0.0.25,-0.25)")[1]
    '(0,0.0.25,-0.25) is a misprint of (0,0.25,-0.25)'
    """
    parts = [part.strip() for part in cell.strip("()").split(",")]
    readings = [part if _NUMBER.fullmatch(part) else _last_number(part) for part in parts]
    numbers = tuple(Fraction(part) for part in readings)
    if readings == parts:
        return numbers, ""
    return numbers, f"{cell} is a misprint of ({','.join(readings)})"


def _last_number(text: str) -> str:
    """Return the longest number at the end of a text with a point too many."""
    match = re.search(r"-?[0-9]+\.[0-9]+$", text)
    if match is None:
        raise ValueError(f"{text!r} cannot be read as a number")
    return match[0]


#: The grasps of the figures in numbers: (point x, point y, normal x, normal y) of each contact.
#: The paper draws them and prints none of these; with friction 1/2 (printed) and stiffness 1 they
#: give the printed forces and motions.
THREE_CONTACT_GRASP = ((-1, 0, 1, 0), (0, -1, 0, 1), (1, 0, -1, 0))
FOUR_CONTACT_GRASP = ((-1, 1, 1, 0), (-1, -1, 1, 0), (1, -1, -1, 0), (1, 1, -1, 0))
FRICTION = Fraction(1, 2)

#: Table II: the printed computation times in seconds, on a 2.80 GHz Core i7.
STATE_TIMES = dict(
    zip(STATE_COUNTS, ("0.006", "0.02", "0.09", "0.42", "1.5", "4.8", "13.8", "35.7"), strict=True)
)
