"""Numbers in print, row by row against what is computed here.

A table is a CSV file with the columns ``arrangement``, ``quantity`` and ``printed``, in any order;
others, such as ``source``, are ignored. The arrangement is

* a built-in name or a file, in any format that is read;
* a member of a family with its parameters: ``near-pencil m=7``, ``simplicial planes=13 number=2``;
* ``lines n=7`` or ``pseudolines n=7``: all of them, for numbers of types.

Counts of single arrangements are closed forms (`arrangement.counts`). Types of lines are counted in
the census, isomorphism classes of pseudolines by extending chirotopes, without coordinates.
"""

from __future__ import annotations

import csv
import inspect
import io
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np

from arrangement import counts, read_arrangement
from arrangement.arrangement import Arrangement
from arrangement.counts.whitney import why_none_is_bounded
from arrangement.errors import InputError
from arrangement.library.census import MOST_PLANES, census
from arrangement.library.census.chirotopes import (
    Signs,
    canonical,
    chirotope_of,
    extended,
    extensions,
)
from arrangement.library.families import FAMILIES
from arrangement.library.files.json_files import read_text
from arrangement.numbers.exact import integer, shown

_COLUMNS = ("arrangement", "quantity", "printed")
_GROUPING = re.compile(r"(?<=[0-9])[,'_\u2009\u202f](?=[0-9]{3})")
#: Pseudolines whose types are counted: 4,890 types in a minute, and 135 simple ones in a second.
MOST_PSEUDOLINES = 8

#: A number, or numbers by place or by name.
Value = int | tuple[int, ...] | dict[int, int]


class NotComputed(Exception):
    """The value is beyond what is computed here."""


@dataclass(frozen=True)
class Row:
    """A row of a table, with the value computed; None with a reason where there is none.

    A value that may be meant otherwise, such as 0 bounded regions, has a reason too.
    """

    line: int
    arrangement: str
    quantity: str
    printed: Value
    computed: Value | None
    reason: str = ""

    @property
    def agrees(self) -> bool | None:
        """Whether both values are the same; None where nothing was computed."""
        return None if self.computed is None else self.printed == self.computed


def check_table(source: str) -> Iterator[Row]:
    """Yield the rows of a CSV file, each with the value computed.

    Raises:
        InputError: names the line and the rule.
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
                yield _row(dict(zip(columns, map(str.strip, cells), strict=False)), lines.line_num)
    except (csv.Error, InputError) as error:
        raise InputError(f"{name}, line {lines.line_num}: {error}") from None


def _row(cells: Mapping[str, str], line: int) -> Row:
    if any(not cells.get(column) for column in _COLUMNS):
        raise InputError(f"a row needs {', '.join(_COLUMNS)}")
    subject, quantity, text = (cells[column] for column in _COLUMNS)
    quantity = re.sub("[ _]", "-", quantity)
    kind, _, rest = subject.partition(" ")
    known: Mapping[str, Callable[[Any], Value]] = _OF_ALL.get(kind, _OF_ONE)
    if quantity not in known:
        raise InputError(f"the quantity is {shown(quantity)}; expected one of {', '.join(known)}")
    printed, reason = _printed(text, quantity), ""
    try:
        over = _number(rest) if kind in _OF_ALL else _arrangement(kind, rest, subject)
        computed: Value | None = known[quantity](over)
    except NotComputed as error:
        computed, reason = None, str(error)
    if quantity == "bounded-regions" and printed != computed and isinstance(over, Arrangement):
        reason = why_none_is_bounded(over)
    return Row(line, subject, quantity, printed, computed, reason)


def _printed(text: str, quantity: str) -> Value:
    """Read ``41,693,377``, ``1 14 36 24``, or ``t2=3 t3=4``."""
    words = _GROUPING.sub("", text).replace(";", " ").split()
    if quantity == "t-vector":
        pairs = [re.fullmatch(r"t?_?([0-9]{1,6})[=:]([0-9]{1,9})", w, re.ASCII) for w in words]
        found = {int(p[1]): int(p[2]) for p in pairs if p}
        if not words or len(found) != len(words):
            raise InputError(f"the t-vector is {shown(text)}; write t2=3 t3=4")
        return {k: number for k, number in sorted(found.items()) if number}
    if not words or not all(re.fullmatch(r"-?[0-9]+", word, re.ASCII) for word in words):
        raise InputError(f"the printed value is {shown(text)}; write integers")
    numbers = tuple(map(integer, words))
    return numbers if quantity in _VECTORS else _single(numbers, text)


def _single(numbers: tuple[int, ...], text: str) -> int:
    if len(numbers) != 1:
        raise InputError(f"the printed value is {shown(text)}; write one number")
    return numbers[0]


def _arrangement(kind: str, rest: str, subject: str) -> Arrangement:
    if kind not in FAMILIES or (not rest and inspect.signature(FAMILIES[kind]).parameters):
        return read_arrangement(subject)
    values = dict(word.partition("=")[::2] for word in rest.split())
    try:
        bound = inspect.signature(FAMILIES[kind]).bind(
            **{
                k: int(v) if re.fullmatch(r"[0-9]{1,9}", v, re.ASCII) else v
                for k, v in values.items()
            }
        )
    except TypeError as error:
        raise InputError(f"{shown(subject)}: {error}; write {kind} parameter=value ...") from None
    return FAMILIES[kind](*bound.args, **bound.kwargs)


def _number(rest: str) -> int:
    found = re.fullmatch(r"n=([0-9]{1,3})", rest.strip(), re.ASCII)
    if found is None:
        raise InputError(f"how many is {shown(rest)}; write lines n=7")
    return int(found[1])


def _in_census(n: int) -> int:
    if not 3 <= n <= MOST_PLANES:
        raise NotComputed(f"the census has 3 to {MOST_PLANES} planes")
    return n


def _affine_simple(n: int) -> int:
    """Count classes of n lines in general position in the plane: of n + 1, one is at infinity."""
    rows = [planes.normals for planes in census(_in_census(n + 1), simple=True)]
    signs = chirotope_of(np.array(rows, dtype=np.int64))
    return int(canonical(signs, n + 1).orbits.sum())


@lru_cache
def _pseudolines(n: int, simple: bool) -> Signs:
    """Return a chirotope of each class of n pseudolines, by extending those of n - 1."""
    if not 3 <= n <= MOST_PSEUDOLINES:
        raise NotComputed(f"isomorphism classes of 3 to {MOST_PSEUDOLINES} pseudolines are counted")
    if n == 3:
        return np.ones((1, 1), dtype=np.int8)
    found = []
    for signs in _pseudolines(n - 1, simple):
        new = extensions(signs, n - 1)
        found.append(extended(signs, new[(new != 0).all(1)] if simple else new, n - 1))
    everything = np.concatenate(found)
    _, first = np.unique(canonical(everything, n).codes, axis=0, return_index=True)
    return everything[first]


_VECTORS = ("f-vector", "polynomial")
_OF_ONE: Mapping[str, Callable[[Arrangement], Value]] = {
    "planes": lambda planes: len(planes.distinct),
    "rank": lambda planes: planes.rank,
    "regions": counts.region_count,
    "bounded-regions": counts.bounded_region_count,
    "relatively-bounded-regions": partial(counts.bounded_region_count, relative=True),
    "f-vector": counts.f_vector,
    "polynomial": lambda planes: tuple(
        map(int, counts.characteristic_polynomial(planes).all_coeffs())
    ),
    "t-vector": lambda planes: dict(counts.t_vector(planes)),
}
_OF_ALL: Mapping[str, Mapping[str, Callable[[int], Value]]] = {
    "lines": {
        "types": lambda n: len(census(_in_census(n))),
        "simple-types": lambda n: len(census(_in_census(n), simple=True)),
        "affine-simple-types": _affine_simple,
    },
    "pseudolines": {
        "types": lambda n: len(_pseudolines(n, False)),
        "simple-types": lambda n: len(_pseudolines(n, True)),
    },
}


def value_text(value: Value) -> str:
    """Return a value as it is written in tables."""
    if isinstance(value, dict):
        return " ".join(f"t{k}={number}" for k, number in value.items())
    return " ".join(map(str, value)) if isinstance(value, tuple) else f"{value:,}"
