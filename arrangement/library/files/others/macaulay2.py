"""Source text of Macaulay2's package HyperplaneArrangements.

Read and written is ``R = QQ[x,y]`` with ``A = arrangement {x, y, x - y}``; read is also
``arrangement matrix {{1,0,1}, {0,1,-1}}``, whose columns are the normals.
"""

from __future__ import annotations

import re

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import rational_planes
from arrangement.numbers import budget
from arrangement.numbers.exact import shown

from .linear_forms import form_text, inside, read_form, split_outside, without_remarks

#: A ring with its name, its coefficients, its variables and options.
_RING = re.compile(r"(?:([\w']+)\s*=\s*)?\b([A-Z]\w*(?:/[0-9]+)?)\s*\[([^\]]*)\]")
_IN_RING = re.compile(r"\}\s*\)?\s*,\s*([\w']+)")
#: Where an arrangement begins.
ARRANGEMENT = re.compile(r"\barrangement\s*(?:\(\s*)?(matrix\s*(?:\(\s*)?(?:(\w+)\s*,\s*)?)?(?=\{)")


def read(text: str) -> Arrangement:
    """Read the first arrangement of a text, in the ring that it names or the last one before it."""
    plain = without_remarks(text, "--")
    found = ARRANGEMENT.search(plain)
    if found is None:
        raise InputError("there is no arrangement {...} outside remarks")
    if re.search(r"\bdual\s*\(?\s*$", plain[: found.start()]):
        raise InputError("the dual of an arrangement is no list of planes; write its planes")
    content = inside(plain, found.end(), "{}")
    rings = _RING.finditer(plain, 0, found.start())
    known = [(ring[1], ring[2], _variables(ring[3])) for ring in rings]
    named = _IN_RING.match(plain, found.end() + len(content) + 1)
    used = set(re.findall(r"[A-Za-z]\w*", "" if found[1] else content))
    fitting = [ring for ring in known if used <= {*ring[2]}]
    of_name = [ring for ring in known if named and ring[0] == named[1]]
    ring = (known[-1:] + fitting + of_name)[-1:]
    if ring:
        _check_ring(ring[0][1])
    if found[1]:
        _check_ring(found[2] or "QQ")
        columns = [split_outside(row.strip()[1:-1]) for row in split_outside(content)]
        if len({len(column) for column in columns}) != 1:
            raise InputError("the rows of the matrix are not of one length")
        return Arrangement([*zip(*columns, strict=True)])
    if not ring:
        raise InputError("there is no ring such as R = QQ[x,y,z]")
    names = ring[0][2]
    rows = [read_form(form, names) for form in split_outside(content)]
    return Arrangement([r[:-1] for r in rows], [-r[-1] for r in rows], dimension=len(names))


def _check_ring(name: str) -> None:
    if name not in ("QQ", "ZZ"):
        raise InputError(f"the coefficients are in {shown(name)}; those in QQ are read")


def _variables(text: str) -> list[str]:
    """Return the names in ``x, y``, ``x_1..x_4`` and ``a..d``, without options behind them."""
    names: list[str] = []
    for part in split_outside(text):
        first, _, last = (word.strip() for word in part.partition(".."))
        ends = re.fullmatch(r"(\w+)_([0-9]{1,6})\.\.\1_([0-9]{1,6})", f"{first}..{last}", re.ASCII)
        if "=>" in part:
            break
        if re.fullmatch(r"\w+", part):
            names.append(part)
        elif len(first) == len(last) == 1:
            names += map(chr, range(ord(first), ord(last) + 1))
        elif ends is None:
            raise InputError(f"the variables are {shown(part)}; write x, y, z or x_1..x_4")
        else:
            budget.keep(int(ends[3]) - int(ends[2]) + 1, "coordinates")
            names += [f"{ends[1]}_{k}" for k in range(int(ends[2]), int(ends[3]) + 1)]
    return names


def write(arrangement: Arrangement) -> str:
    """Write lines that make the arrangement in Macaulay2."""
    names = [f"x_{k}" for k in range(1, arrangement.dimension + 1)]
    forms = ",\n".join(f"    {form_text(p, names)}" for p in rational_planes(arrangement))
    return (
        f'needsPackage "HyperplaneArrangements"\nR = QQ[{",".join(names)}]\n'
        f"A = arrangement({{\n{forms}\n    }}, R)\n"
    )
