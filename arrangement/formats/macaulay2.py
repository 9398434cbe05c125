"""Source text of Macaulay2's package HyperplaneArrangements.

Read and written is ``R = QQ[x,y]`` with ``A = arrangement {x, y, x - y}``; read is also
``arrangement matrix {{1,0,1}, {0,1,-1}}``, whose columns are the normals.
"""

from __future__ import annotations

import re

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.exact import shown

from .documents import MAX_DIMENSION
from .form import rational_planes
from .linear_forms import form_text, inside, read_form, split_outside, without_remarks

_RING = re.compile(r"\b([A-Z]\w*(?:/[0-9]+)?)\s*\[([^\]]*)\]")
#: Where an arrangement begins.
ARRANGEMENT = re.compile(r"\barrangement\s*(?:\(\s*)?(matrix\s*(?:\(\s*)?(?:(\w+)\s*,\s*)?)?(?=\{)")


def read(text: str) -> Arrangement:
    """Read the first arrangement of a text."""
    plain = without_remarks(text, "--")
    found = ARRANGEMENT.search(plain)
    if found is None:
        raise InputError("there is no arrangement {...} outside remarks")
    content = inside(plain, found.end(), "{}")
    if found[1]:
        _check_ring(found[2] or "QQ")
        columns = [split_outside(row.strip()[1:-1]) for row in split_outside(content)]
        if len({len(column) for column in columns}) != 1:
            raise InputError("the rows of the matrix are not of one length")
        return Arrangement([*zip(*columns, strict=True)])
    ring = _RING.search(plain)
    if ring is None:
        raise InputError("there is no ring such as R = QQ[x,y,z]")
    _check_ring(ring[1])
    names = [name for part in ring[2].split(",") for name in _variables(part.strip())]
    rows = [read_form(form, names) for form in split_outside(content)]
    return Arrangement([r[:-1] for r in rows], [-r[-1] for r in rows], dimension=len(names))


def _check_ring(name: str) -> None:
    if name not in ("QQ", "ZZ"):
        raise InputError(f"the coefficients are in {shown(name)}; those in QQ are read")


def _variables(part: str) -> list[str]:
    """Return the names in ``x``, ``x_1..x_4`` or ``a..d``."""
    first, _, last = (word.strip() for word in part.partition(".."))
    if not last:
        return [first]
    if len(first) == len(last) == 1 and ord(last) - ord(first) < MAX_DIMENSION:
        return [chr(code) for code in range(ord(first), ord(last) + 1)]
    ends = re.fullmatch(r"(\w+)_([0-9]{1,6})\.\.\1_([0-9]{1,6})", f"{first}..{last}", re.ASCII)
    if ends is None or int(ends[3]) - int(ends[2]) >= MAX_DIMENSION:
        raise InputError(f"the variables are {shown(part)}; write x, y, z or x_1..x_4")
    return [f"{ends[1]}_{k}" for k in range(int(ends[2]), int(ends[3]) + 1)]


def write(arrangement: Arrangement) -> str:
    """Write lines that make the arrangement in Macaulay2."""
    names = [f"x_{k}" for k in range(1, arrangement.dimension + 1)]
    forms = ",\n".join(f"    {form_text(p, names)}" for p in rational_planes(arrangement))
    return (
        f'needsPackage "HyperplaneArrangements"\nR = QQ[{",".join(names)}]\n'
        f"A = arrangement({{\n{forms}\n    }}, R)\n"
    )
