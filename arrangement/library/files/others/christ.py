"""Tobias Christ's files of simple arrangements of lines, and of points.

Each entry is a chirotope as Finschi and Fukuda write it, with coordinates below. These are lines
``a b c`` for ``ax + by + c = 0``, one each, and the line at infinity is the last element of the
chirotope; or points ``x y x y ...`` on one line. The chirotope decides: signs of normals are
changed to fit, and coordinates that do not fit are refused.
Source: https://geometry.inf.ethz.ch/christt/linearr/
"""

from __future__ import annotations

import itertools
from fractions import Fraction

from arrangement.arrangement import Arrangement
from arrangement.counts import chirotope
from arrangement.errors import InputError
from arrangement.numbers.exact import rational, shown

from .chirotope import is_chirotope, signs_of, size_of
from .matrix import numbers


def split(text: str) -> list[str]:
    """Return each chirotope with the lines below it."""
    blocks: list[list[str]] = []
    for line in filter(str.strip, text.splitlines()):
        if is_chirotope(line):
            blocks.append([line.strip()])
        elif not blocks:
            raise InputError(f"the first line is {shown(line)}; expected a chirotope")
        else:
            blocks[-1].append(line)
    return list(map("\n".join, blocks))


def recognises(text: str) -> bool:
    """Whether a text begins with a chirotope and something else below."""
    head = [line for line in text[:2000].splitlines()[:10] if line.strip()]
    return len(head) > 1 and is_chirotope(head[0]) and not is_chirotope(head[1])


def read(block: str) -> Arrangement:
    """Return lines of the plane, or the planes whose normals are points (x, y, 1)."""
    text, *lines = block.splitlines()
    n = size_of(text)
    rows = [[rational(x, "a coordinate") for x in numbers(line)] for line in lines]
    is_lines = [len(row) for row in rows] == [3] * (n - 1)
    if is_lines:
        vectors = [*rows, [Fraction(0), Fraction(0), Fraction(1)]]
    elif [len(row) for row in rows] == [2 * n]:
        vectors = [[*pair, Fraction(1)] for pair in zip(rows[0][::2], rows[0][1::2], strict=True)]
    else:
        raise InputError(
            f"below the chirotope {shown(text)} of {n} elements there are {len(rows)} lines of "
            f"numbers; expected {n - 1} lines a b c, or {n} points x y on one line"
        )
    sides = _sides(list(chirotope(Arrangement(vectors)).values()), signs_of(text).tolist(), n)
    if sides is None:
        raise InputError(f"the coordinates below {shown(text)} have another chirotope")
    turned = [[side * x for x in row] for side, row in zip(sides, vectors, strict=True)]
    if not is_lines:
        return Arrangement(turned)
    return Arrangement(
        [[sides[-1] * x for x in row[:2]] for row in turned[:-1]],
        [-sides[-1] * row[2] for row in turned[:-1]],
    )


def _sides(ours: list[int], theirs: list[int], n: int) -> list[int] | None:
    """Return signs of the elements that carry one chirotope to another, up to a common sign."""
    # An equation over GF(2) a basis: bits of its elements, of the common sign, of the quotient.
    equations: dict[int, int] = {}
    for row, mine, other in zip(itertools.combinations(range(n), 3), ours, theirs, strict=True):
        if bool(mine) != bool(other):
            return None
        equation = sum(1 << k + 2 for k in row) | 2 | (mine != other) if mine else 0
        while equation > 1 and equation.bit_length() in equations:
            equation ^= equations[equation.bit_length()]
        if equation == 1:
            return None
        equations[equation.bit_length()] = equation
    found = 0
    for length, equation in sorted(equations.items()):
        if length > 1 and ((equation & found).bit_count() + equation) % 2:
            found |= 1 << length - 1
    return [-1 if found >> k + 2 & 1 else 1 for k in range(n)]
