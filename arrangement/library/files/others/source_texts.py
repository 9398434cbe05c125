"""Source texts of SageMath, and of Macaulay2's package HyperplaneArrangements.

Sage: ``H.<x,y> = HyperplaneArrangements(QQ)`` and ``A = H(x, y, x + y - 1)``.
Read are also hyperplanes as ``[(1, 0), 2]`` (normal, constant) and ``[2, 1, 0]`` (constant first),
lists of hyperplanes, ``x | y``, sessions with prompts, and what Sage prints, such as
``Arrangement <y | x>`` or ``(Hyperplane x + 0*y + 1, ...)``. A constant c means ``n . x + c = 0``.

Macaulay2: ``R = QQ[x,y]`` with ``A = arrangement {x, y, x - y}``; read is also
``arrangement matrix {{1,0,1}, {0,1,-1}}``, whose columns are the normals.

Nothing is evaluated: a form such as ``3*x + 2*y - 5/2*z - 7`` is a sum of numbers, variables, and
numbers times variables.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import rational_planes
from arrangement.numbers import budget
from arrangement.numbers.exact import rational, shown, sum_text
from arrangement.planes.equation_text import SHORT, named_coordinates, terms_of

#: Steps for a comma or bracket.
_MARK = 20


def read_form(text: str, names: Sequence[str]) -> list[Fraction | int]:
    """Return the coefficients of the named variables, and the constant last."""
    row: list[Fraction | int] = [0] * (len(names) + 1)

    def refused(_: str) -> str:
        return f"{shown(text)} is not a linear form such as 3*x + 2*y - 7 in {', '.join(names)}"

    for name, number in terms_of(text, refused):
        if name and name not in names:
            raise InputError(
                f"{shown(text)} has {shown(name)}; the variables are {', '.join(names)}"
            )
        row[names.index(name) if name else -1] += number
    return row


def form_text(plane: Sequence[int], names: Sequence[str]) -> str:
    """Return ``n . x - b`` of the plane (n, b)."""
    return sum_text(zip((*plane[:-1], -plane[-1]), (*names, ""), strict=True))


def inside(text: str, start: int, pair: str) -> str:
    """Return what stands between the bracket at `start` and the one that closes it."""
    end = text.find(pair[1], start)
    if end >= 0 and text.find(pair[0], start + 1, end) < 0:  # as in most
        return text[start + 1 : end]
    depth = 0
    for mark in re.compile(f"[{re.escape(pair)}]").finditer(text, start):
        depth += 1 if mark[0] == pair[0] else -1
        if not depth:
            return text[start + 1 : mark.start()]
    raise InputError(f"a bracket {pair[0]} is never closed")


def split_outside(text: str) -> list[str]:
    """Split a text at the commas that stand in no bracket; a last empty part is left out."""
    plain = _BRACKETS.search(text) is None  # as most are
    parts, depth, begun = text.split(",")[:-1] if plain else [], 0, 0
    for mark in () if plain else _MARKS.finditer(text):
        depth += (mark[0] in "([{") - (mark[0] in ")]}")
        if mark[0] == "," and not depth:
            parts.append(text[begun : mark.start()])
            begun = mark.end()
    parts.append(text.rpartition(",")[2] if plain else text[begun:])
    return [part.strip() for part in (parts if parts[-1].strip() else parts[:-1])]


_MARKS, _BRACKETS = re.compile(r"[][(){},]"), re.compile(r"[][(){}]")
#: Nested lists of texts.
_Item: TypeAlias = "str | list[_Item]"
#: Of lists in lists: all hyperplanes, one of them, its normal.
_DEPTH = 3
_OPTION = re.compile(r"\s*\w+\s*=")
#: What a text in this language has.
SAGE = re.compile(
    r"HyperplaneArrangements\(|\bhyperplane_arrangements\.|[\[(]Hyperplane |\bArrangement <"
)
#: One of its named arrangements.
_NAMED = re.compile(r"\bhyperplane_arrangements\.(\w+)")
_JOINED = re.compile(r"\bArrangement <([^<>]*)>")
_SPACE = re.compile(
    r"\b(\w+)(?:\.<([\w\s,]+)>)?\s*=\s*(?:Ordered)?HyperplaneArrangements\(\s*(\w+(?:\([^()]*\))?)\s*(?:,\s*([^\n]*))?\)"
)


def read_sage(text: str) -> Arrangement:
    """Read the first arrangement of a text."""
    plain = re.sub(r"(?m)^\s*(?:sage:|\.\.\.\.:)", "", re.sub("#.*", "", text))
    marks = len(_MARKS.findall(plain))
    budget.check_cost(
        f"a text of Sage with {marks:,} commas and brackets",
        "write the planes as JSON, or one row of numbers for each",
        steps=_MARK * marks,
    )
    space = _SPACE.search(plain)
    if space is None:
        items, names = _read_printed(plain)
    elif space[3] in ("QQ", "ZZ"):
        names = re.findall(r"\w+", space[2] or "") or _names(space[4] or "")
        items = _items(plain[space.end() :], space[1])
    else:
        raise InputError(f"the field is {shown(space[3])}; entries over QQ are read")
    rows = [_plane(item, names) for item in items]
    offsets = [-row[-1] for row in rows]
    return Arrangement([row[:-1] for row in rows], offsets, dimension=len(names))


def _read_printed(text: str) -> tuple[list[_Item], list[str]]:
    """Return the hyperplanes that Sage printed, and the variables.

    ``Hyperplane x + 0*y + 1`` has all of them; of ``Arrangement <y | x - y>`` they are those that
    occur, in the order of `named_coordinates`.
    """
    forms: list[_Item] = re.findall(r"\bHyperplane ([^,()\[\]\n]+)", text)
    if not forms and (joined := _JOINED.search(text)):
        return [*map(str.strip, joined[1].split("|"))], named_coordinates(
            re.findall(r"[A-Za-z]\w*", joined[1])
        )
    if named := _NAMED.search(text):
        raise InputError(
            f"{named[0]}(...) is not run; arrangement make {named[1].lower()} makes such "
            "arrangements, and arrangement list --families has all"
        )
    if not forms:
        raise InputError(
            "there is no line such as H.<x,y> = HyperplaneArrangements(QQ), and A = H(x, y - 1)"
        )
    return forms, re.findall(r"[A-Za-z]\w*", str(forms[0]))


def _names(text: str) -> list[str]:
    """Return the names in ``('x', 'y')``, ``'x,y'`` or ``names='xyz'``."""
    quoted = re.findall(r"['\"]([\w\s,]*)['\"]", text)
    if len(quoted) == 1 and "," not in text:
        return re.findall(r"[A-Za-z][0-9_]*", quoted[0])
    return re.findall(r"\w+", ",".join(quoted))


def _items(text: str, space: str) -> list[_Item]:
    """Return the hyperplanes that the first arrangement of a text consists of."""
    call = re.search(rf"\b{re.escape(space)}\s*\(", text)
    if call is not None:
        arguments = split_outside(inside(text, call.end() - 1, "()"))
        items = [_read_nested(part) for part in arguments if not _OPTION.match(part)]
        first = items[0] if items else ""
        is_list = isinstance(first, list) and not (
            all(isinstance(x, str) and re.fullmatch(r"-?\s*[0-9]+(?:/[0-9]+)?", x) for x in first)
            or (len(first) == 2 and isinstance(first[0], list) and isinstance(first[1], str))
        )
        return first if len(items) == 1 and is_list else items  # type: ignore[return-value]
    joined = re.search(r"<([^<>]+)>|(?:=|^)([^=<>()\n;]*\|[^=<>()\n;]*)", text, re.MULTILINE)
    if joined is not None:
        return [part.strip() for part in (joined[1] or joined[2]).split("|")]
    return _read_printed(text)[0]


def _read_nested(text: str, depth: int = 0) -> _Item:
    if depth > _DEPTH:
        raise InputError(f"{shown(text)} is nested too deeply; no hyperplane needs that")
    if text[:1] in ("(", "["):
        content = inside(text, 0, "()" if text[0] == "(" else "[]")
        if len(content) + 2 == len(text):
            if text[0] == "(" and "," not in content:
                return content
            return [_read_nested(part, depth + 1) for part in split_outside(content)]
    return text


def _plane(item: _Item, names: list[str]) -> list[Any]:
    if isinstance(item, str):
        return [*read_form(item, names)]
    if len(item) == 2 and isinstance(item[0], list):
        numbers = [*item[0], item[1]]
    else:
        numbers = [*item[1:], *item[:1]]
    if len(numbers) != len(names) + 1:
        raise InputError(f"the hyperplane {shown(item)} is not one in {', '.join(names)}")
    return [_entry(x) if isinstance(x, str) else x for x in numbers]


def _entry(text: str) -> Fraction | int:
    plain = text.replace(" ", "")
    short = len(plain) < SHORT and plain.isascii() and plain.removeprefix("-").isdigit()
    return int(plain) if short else rational(plain, "an entry")


def write_sage(arrangement: Arrangement) -> str:
    """Write lines that make the arrangement in Sage."""
    d = arrangement.dimension
    names = ["x", "y", "z"][:d] if d <= 3 else [f"x{k}" for k in range(1, d + 1)]
    forms = "".join(f"    {form_text(p, names)},\n" for p in rational_planes(arrangement))
    return f"H.<{','.join(names)}> = HyperplaneArrangements(QQ)\nA = H(\n{forms})\n"


def loses_in_sage(arrangement: Arrangement) -> str:
    """Report what Sage changes when it runs the text."""
    if len(arrangement.distinct) < len(arrangement):
        return "Sage sorts the planes, and keeps one of those that coincide"
    return "Sage sorts the planes"


#: A ring with its name, its coefficients, its variables and options.
_RING = re.compile(r"(?:([\w']+)\s*=\s*)?\b([A-Z]\w*(?:/[0-9]+)?)\s*\[([^\]]*)\]")
_IN_RING = re.compile(r"\}\s*\)?\s*,\s*([\w']+)")
#: Where an arrangement begins.
ARRANGEMENT = re.compile(r"\barrangement\s*(?:\(\s*)?(matrix\s*(?:\(\s*)?(?:(\w+)\s*,\s*)?)?(?=\{)")


def read_macaulay2(text: str) -> Arrangement:
    """Read the first arrangement of a text, in the ring that it names or the last one before it."""
    plain = re.sub("--.*", "", text)
    match = ARRANGEMENT.search(plain)
    if match is None:
        raise InputError("there is no arrangement {...} outside remarks")
    if re.search(r"\bdual\s*\(?\s*$", plain[: match.start()]):
        raise InputError("the dual of an arrangement is not a list of planes; write its planes")
    content = inside(plain, match.end(), "{}")
    rings = _RING.finditer(plain, 0, match.start())
    known = [(ring[1], ring[2], _variables(ring[3])) for ring in rings]
    named = _IN_RING.match(plain, match.end() + len(content) + 1)
    used = set(re.findall(r"[A-Za-z]\w*", "" if match[1] else content))
    fitting = [ring for ring in known if used <= {*ring[2]}]
    of_name = [ring for ring in known if named and ring[0] == named[1]]
    ring = (known[-1:] + fitting + of_name)[-1:]
    if ring:
        _check_ring(ring[0][1])
    if match[1]:
        _check_ring(match[2] or "QQ")
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
            budget.check_size(int(ends[3]) - int(ends[2]) + 1, "coordinates")
            names += [f"{ends[1]}_{k}" for k in range(int(ends[2]), int(ends[3]) + 1)]
    return names


def write_macaulay2(arrangement: Arrangement) -> str:
    """Write lines that make the arrangement in Macaulay2."""
    names = [f"x_{k}" for k in range(1, arrangement.dimension + 1)]
    forms = ",\n".join(f"    {form_text(p, names)}" for p in rational_planes(arrangement))
    return (
        f'needsPackage "HyperplaneArrangements"\nR = QQ[{",".join(names)}]\n'
        f"A = arrangement({{\n{forms}\n    }}, R)\n"
    )
