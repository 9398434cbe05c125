"""The numbers of types in the catalogue of Finschi and Fukuda: IC(n, 3, k).

Signs of triples are written in reverse lexicographic order (123, 124, 134, 234, 125, ...), and
texts compared with ``- < + < 0``. The representative of a type is the largest text that relabelling
and reorientation give it, and type k the k-th when representatives rise. The isomorphism classes of
pseudolines are counted, so some numbers of nine elements belong to no planes.

Source: [FinschiFukuda2002]; the order, L. Finschi, Homepage of Oriented Matroids, glossary,
"RevLex-Index".
"""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from .chirotopes import Integers, Signs, alternating, pairs

_FILE = "finschi_fukuda.npz"
#: 0, 1 and -1 as digits.
_DIGITS = np.array([2, 1, 0])


def number(planes: int, place: int) -> int:
    """Return k of IC(planes, 3, k) for ``census(planes)[place]``, 3 to 9 planes."""
    return int(_numbers(planes)[place])


@lru_cache
def _numbers(planes: int) -> NDArray[np.int32]:
    with files(__package__).joinpath(_FILE).open("rb") as stream, np.load(stream) as arrays:
        numbers: NDArray[np.int32] = arrays[f"of_{planes}"]
        return numbers


def texts(words: Integers) -> list[str]:
    """Return representatives as the catalogue prints them."""
    return [
        "".join(_digits(int(x), size * (size - 1) // 2) for size, x in enumerate(row, 2))
        for row in words
    ]


def _digits(word: int, length: int) -> str:
    return "".join("-+0"[word // 3**k % 3] for k in reversed(range(length)))


def representatives(signs: Signs, n: int) -> Integers:
    """Return the representatives of chirotopes (N, C(n, 3)): for each last element one word."""
    chi = alternating(signs, n)
    i, j = pairs(n).T
    most = (chi[:, i, j] == 0).sum(2).max(1)
    words = np.empty((len(signs), n - 2), dtype=np.int64)
    for lines in np.unique(most):
        rows = np.flatnonzero(most == lines)
        words[rows] = _largest(chi[rows], int(lines))
    return words


def _largest(chi: Signs, most: int) -> Integers:
    """Return the representatives of chirotopes in which at most `most` lines share a point.

    The search is breadth first. A partial relabelling is a sequence of elements, each with a sign.
    Every step extends all of them by every other element, and keeps for each chirotope those whose
    text is the largest so far.
    """
    total, n = len(chi), chi.shape[-1]
    of, order, sides = _first_point(chi, most)
    words = [np.full(total, 3 ** (k * (k - 1) // 2) - 1) for k in range(2, most)]
    for size in range(most, n):
        first, second = np.array(sorted(combinations(range(size), 2), key=lambda p: p[::-1])).T
        powers = 3 ** np.arange(len(first) - 1, -1, -1, dtype=np.int64)
        choice, element = np.nonzero((order[:, :, None] != np.arange(n)).all(1))
        of, order, sides = of[choice], order[choice], sides[choice]
        index = (order[:, first] * n + order[:, second]) * n + (element + of * n**3)[:, None]
        row = chi.take(index) * sides[:, first] * sides[:, second]
        side = np.take_along_axis(row, (row != 0).argmax(1)[:, None], 1)  # its first sign is +
        word = _DIGITS.take(row * side) @ powers
        best = np.zeros(total, dtype=np.int64)
        np.maximum.at(best, of, word)
        words.append(best)
        kept = word == best[of]
        of, order = of[kept], np.column_stack([order, element])[kept]
        sides = np.hstack([sides, side])[kept]
    return np.stack(words, 1)


def _first_point(chi: Signs, most: int) -> tuple[NDArray[np.intp], NDArray[np.intp], Signs]:
    """Order the lines through one point first, for every such point, with signs +.

    As 0 is the largest digit of a word, the largest word begins with the lines through a point that
    is on most lines. Next come the signs of pairs of these lines with a line that misses the point.
    They agree for all such lines, up to a common sign. A rotation of the order, in either
    direction, makes all of them +.
    """
    n = chi.shape[-1]
    i, j = pairs(n).T
    through = chi[:, i, j] == 0
    of, pair = np.nonzero(through.sum(2) == most)
    on = np.nonzero(through[of, pair])[1].reshape(-1, most)
    first = (on[:, 0] == i[pair]) & (on[:, 1] == j[pair])  # each point once
    of, on = of[first], on[first]
    outside = (chi[of, on[:, 0], on[:, 1]] != 0).argmax(1)
    around = chi[of[:, None, None], on[:, :, None], on[:, None, :], outside[:, None, None]]
    sides = around[:, 0].copy()
    sides[:, 0] = 1
    turned = np.argsort(((around * sides[:, :, None] * sides[:, None, :]) > 0).sum(1), axis=1)
    on, sides = (np.take_along_axis(x, turned, 1) for x in (on, sides))
    choices = []
    for _ in range(2 * most):
        on, sides = np.roll(on, -1, 1), np.roll(sides, -1, 1)
        sides[:, -1] *= -1
        choices += [(on, sides), (on[:, ::-1], sides[:, ::-1])]
    orders, turns = (np.concatenate(x) for x in zip(*choices, strict=True))
    return np.tile(of, 4 * most), orders, turns
