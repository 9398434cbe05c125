"""Source text of SageMath: ``H.<x,y> = HyperplaneArrangements(QQ)`` and ``A = H(x, y, x + y - 1)``.

Read are also hyperplanes as ``[(1, 0), 2]`` (normal, constant) and ``[2, 1, 0]`` (constant first),
lists of hyperplanes, ``x | y``, sessions with prompts, and what Sage prints, such as
``Arrangement <y | x>`` or ``(Hyperplane x + 0*y + 1, ...)``. A constant c means ``n . x + c = 0``.
"""

from __future__ import annotations

import re
from typing import Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import rational_planes
from arrangement.numbers.exact import rational, shown

from .linear_forms import form_text, inside, read_form, split_outside, without_remarks

#: Nested lists of texts.
_Item: TypeAlias = "str | list[_Item]"
#: Of lists in lists: all hyperplanes, one of them, its normal.
_DEPTH = 3
_OPTION = re.compile(r"\s*\w+\s*=")
#: What a text in this language has.
SAGE = re.compile(r"HyperplaneArrangements\(|[\[(]Hyperplane ")
_SPACE = re.compile(
    r"\b(\w+)(?:\.<([\w\s,]+)>)?\s*=\s*(?:Ordered)?HyperplaneArrangements\(\s*(\w+(?:\([^()]*\))?)\s*(?:,\s*([^\n]*))?\)"
)


def read(text: str) -> Arrangement:
    """Read the first arrangement of a text."""
    plain = re.sub(r"(?m)^\s*(?:sage:|\.\.\.\.:)", "", without_remarks(text, "#"))
    space = _SPACE.search(plain)
    if space is None:
        items, names = _printed(plain)
    elif space[3] in ("QQ", "ZZ"):
        names = re.findall(r"\w+", space[2] or "") or _names(space[4] or "")
        items = _items(plain[space.end() :], space[1])
    else:
        raise InputError(f"the field is {shown(space[3])}; entries over QQ are read")
    rows = [_plane(item, names) for item in items]
    offsets = [-row[-1] for row in rows]
    return Arrangement([row[:-1] for row in rows], offsets, dimension=len(names))


def _printed(text: str) -> tuple[list[_Item], list[str]]:
    """Return the hyperplanes that Sage printed, each with all variables, and the variables."""
    found: list[_Item] = re.findall(r"\bHyperplane ([^,()\[\]\n]+)", text)
    if not found:
        raise InputError(
            "there is no line such as H.<x,y> = HyperplaneArrangements(QQ), and A = H(x, y - 1)"
        )
    return found, re.findall(r"[A-Za-z]\w*", str(found[0]))


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
        given = split_outside(inside(text, call.end() - 1, "()"))
        items = [_nested(part) for part in given if not _OPTION.match(part)]
        first = items[0] if items else ""
        is_list = isinstance(first, list) and not (
            all(isinstance(x, str) and _is_number(x) for x in first)
            or (len(first) == 2 and isinstance(first[0], list) and isinstance(first[1], str))
        )
        return first if len(items) == 1 and is_list else items  # type: ignore[return-value]
    joined = re.search(r"<([^<>]+)>|(?:=|^)([^=<>()\n;]*\|[^=<>()\n;]*)", text, re.MULTILINE)
    if joined is not None:
        return [part.strip() for part in (joined[1] or joined[2]).split("|")]
    return _printed(text)[0]


def _nested(text: str, depth: int = 0) -> _Item:
    if depth > _DEPTH:
        raise InputError(f"{shown(text)} is nested too deeply; no hyperplane needs that")
    if text[:1] in ("(", "["):
        content = inside(text, 0, "()" if text[0] == "(" else "[]")
        if len(content) + 2 == len(text):
            if text[0] == "(" and "," not in content:
                return content
            return [_nested(part, depth + 1) for part in split_outside(content)]
    return text


def _is_number(text: str) -> bool:
    return re.fullmatch(r"-?\s*[0-9]+(?:/[0-9]+)?", text) is not None


def _plane(item: _Item, names: list[str]) -> list[Any]:
    """Return the normal and the constant."""
    if isinstance(item, str):
        return [*read_form(item, names)]
    if len(item) == 2 and isinstance(item[0], list):
        numbers = [*item[0], item[1]]
    else:
        numbers = [*item[1:], *item[:1]]
    if len(numbers) != len(names) + 1:
        raise InputError(f"the hyperplane {shown(item)} is not one in {', '.join(names)}")
    return [rational(x.replace(" ", ""), "an entry") if isinstance(x, str) else x for x in numbers]


def write(arrangement: Arrangement) -> str:
    """Write lines that make the arrangement in Sage."""
    d = arrangement.dimension
    names = ["x", "y", "z"][:d] if d <= 3 else [f"x{k}" for k in range(1, d + 1)]
    forms = "".join(f"    {form_text(p, names)},\n" for p in rational_planes(arrangement))
    return f"H.<{','.join(names)}> = HyperplaneArrangements(QQ)\nA = H(\n{forms})\n"


def loses(arrangement: Arrangement) -> str:
    """Say what Sage changes when it runs the text."""
    if len(arrangement.distinct) < len(arrangement):
        return "Sage sorts the planes, and keeps one of those that coincide"
    return "Sage sorts the planes"
