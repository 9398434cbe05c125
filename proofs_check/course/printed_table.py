"""Numbers in print, row by row against what is computed here.

A table is a CSV file with the columns ``arrangement``, ``quantity`` and ``printed``, in any order;
others, such as ``source``, are ignored. The arrangement is

* a built-in name or a file, in any format that is read;
* a member of a family with its parameters, ``near-pencil m=7``, or several of them,
  ``catalan(n=2..5)``, with a printed value for each;
* ``lines n=7`` or ``pseudolines n=7``: all of them, for numbers of types.

The quantity is a name or an expression of claims in one line (`own_claims.one_line`), such as
``bounded_p_vector`` or ``chi(2)``. Types of lines are counted in the census, isomorphism classes of
pseudolines by extending chirotopes, without coordinates.
"""

from __future__ import annotations

import ast
import csv
import inspect
import io
import operator
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

import numpy as np

from arrangement import read_arrangement
from arrangement.arrangement import Arrangement
from arrangement.counts.whitney import why_none_is_bounded
from arrangement.errors import ArrangementError, InputError, OutOfReachError, refusal
from arrangement.library.census import MOST_LINES, MOST_PLANES, census
from arrangement.library.census.catalogue import line_count
from arrangement.library.census.chirotopes import Signs, canonical, extended, extensions
from arrangement.library.families import FAMILIES
from arrangement.library.files.json_files import read_text
from arrangement.numbers.exact import integer, shown
from proofs_check.instances.families import is_family, read_family
from proofs_check.own_claims.language import read
from proofs_check.own_claims.one_line import value_of
from proofs_check.own_claims.quantities import QUANTITIES

_COLUMNS = ("arrangement", "quantity", "printed")
_GROUPING = re.compile(r"(?<=[0-9])[,'_\u2009\u202f](?=[0-9]{3})")
_PAIR = re.compile(r"[a-z]?_?([0-9]{1,6})[=:]([0-9]{1,9})", re.ASCII)
#: The letter of a polynomial, and not that of t2=3.
_VARIABLE = re.compile(r"(?<![a-z])t(?![a-z0-9_])")
_TRUTH = {"yes": 1, "true": 1, "no": 0, "false": 0}
#: Pseudolines whose types are counted: 4,890 types in a minute, and 135 simple ones in a second.
MOST_PSEUDOLINES = 8

#: A number, or numbers by place or by name.
Value = int | Fraction | tuple[Any, ...] | dict[int, int]


class NotComputed(Exception):
    """The value is beyond what is computed here."""


@dataclass(frozen=True)
class Row:
    """A row of a table, with the value computed; None with a reason where there is none.

    A value that may be meant otherwise, such as 0 bounded regions, has a reason too.

    Attributes:
        mistake: why the row cannot be read, if it cannot: it has no values then.
    """

    line: int
    arrangement: str
    quantity: str
    printed: Value | None
    computed: Value | None
    reason: str = ""
    mistake: str = ""

    @property
    def agrees(self) -> bool | None:
        """Whether both values are the same; None where nothing was computed."""
        return None if self.computed is None else self.printed == self.computed


def check_table(source: str) -> Iterator[Row]:
    """Yield the rows of a CSV file, each with the value computed, or with what is wrong in it.

    Raises:
        InputError: it is not a CSV file, or has not the columns.
    """
    text, name = read_text(source)
    lines = csv.reader(io.StringIO(text), strict=True, skipinitialspace=True)
    try:
        columns = [column.strip().lower() for column in next(lines, [])]
        missing = [column for column in _COLUMNS if column not in columns]
        if missing:
            expected = ", ".join(_COLUMNS)
            raise InputError(
                f"{name} has no column {missing[0]}; expected a first line with {expected}"
            )
        for cells in lines:
            if cells and not cells[0].startswith("#"):
                row = dict(zip(columns, map(str.strip, cells), strict=False))
                try:
                    yield _row(row, lines.line_num)
                except ArrangementError as error:
                    subject, quantity = (row.get(column, "") for column in _COLUMNS[:2])
                    yield Row(lines.line_num, subject, quantity, None, None, mistake=str(error))
    except csv.Error as error:
        raise InputError(f"{name}, line {lines.line_num}: {error}") from None


def _row(cells: Mapping[str, str], line: int) -> Row:
    if any(not cells.get(column) for column in _COLUMNS):
        raise InputError(f"a row needs {', '.join(_COLUMNS)}")
    subject, quantity, text = (cells[column] for column in _COLUMNS)
    named = re.sub("[ -]", "_", quantity.lower())
    named = {"planes": "m"}.get(named, named)
    kind, _, rest = subject.partition(" ")
    quantity = named if named in (*QUANTITIES, *_OF_ALL.get(kind, ())) else quantity
    result: Value | None = None
    over, reason = None, ""
    try:
        if kind in _OF_ALL:
            if quantity not in _OF_ALL[kind]:
                raise refusal(f"the quantity is {shown(quantity)}", quantity, _OF_ALL[kind])
            result = _OF_ALL[kind][quantity](_number(rest))
        else:
            over, result = _of_arrangements(subject, quantity)
    except (NotComputed, OutOfReachError) as error:
        reason = str(error)
    printed = _read_printed(text, quantity, result)
    if quantity == "bounded_regions" and printed != result and isinstance(over, Arrangement):
        reason = why_none_is_bounded(over)
    return Row(line, subject, quantity, printed, result, reason)


def _of_arrangements(subject: str, quantity: str) -> tuple[Arrangement | None, Value]:
    """Return the value for an arrangement, and the arrangement; or the values for several."""
    kind, _, rest = subject.partition(" ")
    if kind in FAMILIES and rest and not rest.startswith("("):
        subject = f"{kind}({', '.join(rest.split())})"
    elif kind in FAMILIES and not rest and inspect.signature(FAMILIES[kind]).parameters:
        return _compute(quantity, read_arrangement(subject), {})
    if not is_family(subject):
        return _compute(quantity, read_arrangement(subject), {})
    members = [case.subject for case in read_family(subject).cases()]
    values = [_compute(quantity, member.planes, member.parameters) for member in members]
    return values[0] if len(values) == 1 else (None, tuple(value for _, value in values))


def _compute(
    quantity: str, planes: Arrangement, parameters: Mapping[str, Any]
) -> tuple[Arrangement, Value]:
    integers = {name: value for name, value in parameters.items() if type(value) is int}
    value = value_of(read(quantity, integers), planes, integers)
    if isinstance(value, Mapping):
        return planes, {k: number for k, number in value.items() if number}
    return planes, tuple(value) if isinstance(value, (list, tuple)) else value


def _read_printed(text: str, quantity: str, computed: Value | None) -> Value:
    """Read ``41,693,377``, ``1 14 36 24``, ``t2=3 t3=4``, or ``t**2 - 3*t + 2``."""
    if _VARIABLE.search(text) and quantity == "polynomial":
        return _coefficients(read(text.replace("^", "**"), ["t"]))
    words = _GROUPING.sub("", text).replace(";", " ").split()
    pairs = list(map(_PAIR.fullmatch, words))
    value: Value
    if words and all(pairs):
        numbers = {int(pair[1]): int(pair[2]) for pair in pairs if pair}
        value = {k: number for k, number in sorted(numbers.items()) if number}
    elif words and all(re.fullmatch(r"-?[0-9]+", w, re.ASCII) or w in _TRUTH for w in words):
        value = tuple(_TRUTH[word] if word in _TRUTH else integer(word) for word in words)
    else:
        how = "t2=3 t3=4" if isinstance(computed, dict) else "integers"
        raise InputError(f"the printed value is {shown(text)}; write {how}")
    if isinstance(computed, (tuple, dict)):
        if type(value) is not type(computed):
            how = "write t2=3 t3=4" if isinstance(computed, dict) else "write integers"
            raise InputError(f"{quantity} is {shown(text)}; {how}")
    elif isinstance(value, tuple) and len(value) == 1:
        return int(value[0])
    elif computed is not None:
        raise InputError(f"{quantity} is {shown(text)}; write one number")
    return value


def _coefficients(node: ast.expr) -> tuple[int, ...]:
    """Return the coefficients of a polynomial in t, the highest first, of a text that was read."""
    from sympy import ZZ, Poly, Symbol

    t = Symbol("t")
    arithmetic = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul}

    def value(part: ast.expr) -> Any:
        match part:
            case ast.Name(id="t"):
                return Poly(t, t, domain=ZZ)
            case ast.Constant(value=int(number)):
                return Poly(number, t, domain=ZZ)
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return -value(inner)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in arithmetic:
                return arithmetic[type(op)](value(left), value(right))
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))) if (
                0 <= power <= 99
            ):
                return value(left) ** power
        raise InputError(
            f"{ast.unparse(part)} is not a polynomial in t; write t**2 - 3*t + 2, or t*(t - 1)"
        )

    return tuple(map(int, value(node).all_coeffs()))


def _number(rest: str) -> int:
    match = re.fullmatch(r"n=([0-9]{1,3})", rest.strip(), re.ASCII)
    if match is None:
        raise InputError(f"how many is {shown(rest)}; write lines n=7")
    return int(match[1])


def _in_census(n: int) -> int:
    if not 3 <= n <= MOST_PLANES:
        raise NotComputed(f"the census has 3 to {MOST_PLANES} planes")
    return n


def _affine(n: int, *, simple: bool = False) -> int:
    if not 1 <= n <= MOST_LINES:
        raise NotComputed(f"the census has 1 to {MOST_LINES} lines of the affine plane")
    return line_count(n, simple=simple)


@lru_cache
def _pseudolines(n: int, simple: bool) -> Signs:
    """Return a chirotope of each class of n pseudolines, by extending those of n - 1."""
    if not 3 <= n <= MOST_PSEUDOLINES:
        raise NotComputed(f"isomorphism classes of 3 to {MOST_PSEUDOLINES} pseudolines are counted")
    if n == 3:
        return np.ones((1, 1), dtype=np.int8)
    parts = []
    for signs in _pseudolines(n - 1, simple):
        new = extensions(signs, n - 1)
        parts.append(extended(signs, new[(new != 0).all(1)] if simple else new, n - 1))
    everything = np.concatenate(parts)
    _, first = np.unique(canonical(everything, n).codes, axis=0, return_index=True)
    return everything[first]


_OF_ALL: Mapping[str, Mapping[str, Callable[[int], Value]]] = {
    "lines": {
        "types": lambda n: len(census(_in_census(n))),
        "simple_types": lambda n: len(census(_in_census(n), simple=True)),
        "affine_types": _affine,
        "affine_simple_types": partial(_affine, simple=True),
    },
    "pseudolines": {
        "types": lambda n: len(_pseudolines(n, False)),
        "simple_types": lambda n: len(_pseudolines(n, True)),
    },
}


def value_text(value: Value | None, quantity: str) -> str:
    """Return a value of a quantity as it is written in tables."""
    if isinstance(value, dict):
        letter = quantity.removeprefix("bounded_")[:1]
        return " ".join(f"{letter}{k}={number}" for k, number in value.items())
    if isinstance(value, tuple):
        return " ".join(value_text(x, quantity).replace(",", "") for x in value)
    return f"{value:,}" if isinstance(value, int) else str(value)
