"""Chirotopes as text, and coordinates for them.

Up to the size of the census they are those of its representative, relabelled and reoriented. Of
more elements one is taken away and put back: where the others stand, its signs are linear
conditions, which an exact linear program decides. Others may have to stand elsewhere for that, so
each element is tried; that none fits proves nothing.

`chirotope` has the bases in reverse lexicographic order, as the database of Finschi and Fukuda
([FinschiFukuda2002]): one text a line. `topcom` has ``n,r:`` before them and lexicographic order,
as TOPCOM and polymake.

`christ` has Tobias Christ's files of simple arrangements of lines, and of points.
Each entry is a chirotope as Finschi and Fukuda write it, with coordinates below. These are lines
``a b c`` for ``ax + by + c = 0``, one each, and the line at infinity is the last element of the
chirotope; or points ``x y x y ...`` on one line. The chirotope decides: signs of normals are
changed to fit, and coordinates that do not fit are refused.
Source: https://geometry.inf.ethz.ch/christt/linearr/
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, islice
from math import comb

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts.oriented_matroid import ORDERS, chirotope, chirotope_string
from arrangement.errors import InputError
from arrangement.library.census.catalogue import MOST_PLANES, normals
from arrangement.library.census.chirotopes import Signs, alternating, triples
from arrangement.library.census.identify import locate_type
from arrangement.numbers.exact import IntegerVector, primitive, rational, shown
from arrangement.numbers.linear.programs import some_point
from arrangement.numbers.linear.rank import determinant

from .matrix import numbers

#: Linear programs that are tried for more elements than the census has.
_TRIES = 200


def realise(signs: Signs, n: int) -> list[IntegerVector]:
    """Return normals whose determinants have these signs, (C(n, 3),) in lexicographic order.

    Elements may be parallel; the signs are meant up to a common one.

    Raises:
        InputError: no normals have these signs, or none were found.
    """
    chi = alternating(signs[None], n)[0]
    if not chi.any():
        raise InputError("all signs are 0; three planes must meet in a point")
    if not chi.any((1, 2)).all():
        loop = int(np.flatnonzero(~chi.any((1, 2)))[0]) + 1
        raise InputError(f"element {loop} is in no basis: its normal would be 0")
    first = (~chi.any(2)).argmax(1)  # the first element that is parallel to each
    firsts = np.unique(first)
    part = chi[np.ix_(firsts, firsts, firsts)][tuple(triples(len(firsts)).T)]
    tried = islice(_attempts(part, len(firsts)), _TRIES)
    placed = next((vectors for vectors in tried if vectors is not None), None)
    if placed is not None:
        where = dict(zip(firsts.tolist(), placed, strict=True))
        result = []
        for element, like in enumerate(first.tolist()):
            i, j = np.argwhere(chi[like])[0]
            side = int(chi[like, i, j] * chi[element, i, j])
            result.append(tuple(side * x for x in where[like]))
        if _signs(result) in (tuple(signs.tolist()), tuple((-signs).tolist())):
            return result
    if len(firsts) <= MOST_PLANES:
        raise InputError(
            "no planes have these signs: they are in no isomorphism class of the census"
        )
    raise InputError(
        f"no coordinates were found for these {len(firsts)} planes; classes of up to {MOST_PLANES} "
        "are in the census. Give a file with coordinates"
    )


def _signs(vectors: list[IntegerVector]) -> tuple[int, ...]:
    values = (determinant([vectors[k] for k in row]) for row in triples(len(vectors)).tolist())
    return tuple((value > 0) - (value < 0) for value in values)


def _attempts(signs: Signs, m: int) -> Iterator[list[IntegerVector] | None]:
    """Yield normals with exactly these signs, or None for each attempt that failed."""
    if not signs.any():
        yield None
        return
    if m <= MOST_PLANES:
        yield _of_census(signs, m)
        return
    chi = alternating(signs[None], m)[0]
    for last in reversed(range(m)):
        others = [k for k in range(m) if k != last]
        part = chi[np.ix_(others, others, others)][tuple(triples(m - 1).T)]
        for vectors in _attempts(part, m - 1):
            vector = (
                None if vectors is None else _put_back(vectors, chi[last][np.ix_(others, others)])
            )
            yield None if vector is None else [*vectors[:last], vector, *vectors[last:]]  # type: ignore[index]


def _of_census(signs: Signs, m: int) -> list[IntegerVector] | None:
    try:
        place, order, sides, _ = locate_type(signs, m)
    except LookupError:
        return None
    if not normals(m)[place].any():
        raise InputError(
            "planes with these signs need sqrt(5): they are `arrangement make perles`, relabelled"
        )
    vectors: list[IntegerVector] = [()] * m
    for element, side, normal in zip(order, sides, normals(m)[place].tolist(), strict=True):
        vectors[element] = tuple(int(side) * x for x in normal)
    common = 1 if _signs(vectors) == tuple(signs.tolist()) else -1
    return [tuple(common * x for x in vector) for vector in vectors]


def _put_back(others: list[IntegerVector], wanted: Signs) -> IntegerVector | None:
    """Return a vector v with the signs `wanted` of det(v, a_i, a_j)."""
    inequalities, equalities = [], []
    for j, second in enumerate(others):
        for i, first in enumerate(others[:j]):
            (a, b, c), (d, e, f) = first, second
            ray = (b * f - c * e, c * d - a * f, a * e - b * d)
            side = int(wanted[i, j])
            if side:
                inequalities.append((*(side * x for x in ray), -1))
            else:
                equalities.append((*ray, 0))
    normal = some_point(3, inequalities, equalities)
    return None if normal is None else primitive(normal)


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
        raise InputError(f"the chirotope {shown(text)} has characters other than +, -, 0")
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
    """Return whether a line consists of signs alone."""
    return _SIGNS.fullmatch(line.strip()) is not None and bool(set(line) & {"+", "-"})


def recognises(text: str) -> bool:
    """Return whether a text has chirotopes alone, or is a list of Finschi."""
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
    match = TOPCOM.fullmatch(text)
    if match is None:
        raise InputError("a chirotope of TOPCOM is n,r: and the signs +, -, 0")
    signs = "".join(match[3].split())
    if int(match[2]) != 3 or comb(int(match[1]), 3) != len(signs):
        raise InputError(
            f"the chirotope is of {match[1]} elements of rank {match[2]} and has {len(signs)} "
            "signs; rank 3 with C(n, 3) signs is read"
        )
    return Arrangement(realise(signs_of(signs, ORDERS[1]), size_of(signs)))


def _check(arrangement: Arrangement) -> Arrangement:
    rank = arrangement.rank + (not arrangement.is_central)
    if rank != 3:
        raise InputError(f"the rank is {rank}; chirotopes of rank 3 are written")
    return arrangement


def write(arrangement: Arrangement) -> str:
    """Write the signs in reverse lexicographic order."""
    return chirotope_string(_check(arrangement)) + "\n"


def write_topcom(arrangement: Arrangement) -> str:
    """Write the signs in lexicographic order."""
    n = len(_check(arrangement)) + (not arrangement.is_central)
    return f"{n},3:\n{chirotope_string(arrangement, ORDERS[1])}\n"


def loses(arrangement: Arrangement) -> str:
    """Report that coordinates are lost."""
    lost = "a chirotope holds no coordinates; read back it has others of the same type"
    return lost if arrangement.is_central else f"{lost}, and the plane at infinity as its last one"


def split_christ(text: str) -> list[str]:
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


def recognises_christ(text: str) -> bool:
    """Return whether a text begins with a chirotope and something else below."""
    head = [line for line in text[:2000].splitlines()[:10] if line.strip()]
    return len(head) > 1 and is_chirotope(head[0]) and not is_chirotope(head[1])


def read_christ(block: str) -> Arrangement:
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
    for row, mine, other in zip(combinations(range(n), 3), ours, theirs, strict=True):
        if bool(mine) != bool(other):
            return None
        equation = sum(1 << k + 2 for k in row) | 2 | (mine != other) if mine else 0
        while equation > 1 and equation.bit_length() in equations:
            equation ^= equations[equation.bit_length()]
        if equation == 1:
            return None
        equations[equation.bit_length()] = equation
    mask = 0
    for length, equation in sorted(equations.items()):
        if length > 1 and ((equation & mask).bit_count() + equation) % 2:
            mask |= 1 << length - 1
    return [-1 if mask >> k + 2 & 1 else 1 for k in range(n)]
