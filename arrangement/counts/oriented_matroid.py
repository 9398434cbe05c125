"""Oriented-matroid data of an arrangement, from determinants of its normals.

Signs are over the input planes in input order, as everywhere. The oriented matroid of an affine
arrangement is that of its `cone`: it has one element more, the plane at infinity, which is the last
one. So every function below has a sign more there than `Arrangement.sign_vectors`, whose rows are
the covectors with a + at infinity, without it. Nothing here uses an enumerator: cocircuits are read
off the chirotope, and covectors are their compositions.
Source: A. Bjoerner, M. Las Vergnas, B. Sturmfels, N. White, G. Ziegler, Oriented Matroids
(2nd ed. 1999), sections 3.5 and 3.7.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations

from arrangement.counts.configuration import pivot_columns
from arrangement.counts.operations import cone
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import shown, sign, sign_text
from arrangement.numbers.linear.rank import determinant
from arrangement.planes.planes import Planes

SignVector = tuple[int, ...]
#: In which order bases are listed.
ORDERS = ("reverse-lexicographic", "lexicographic")
#: A sign vector as two masks: the planes with sign +, the planes with sign -.
_Masks = tuple[int, int]


def chirotope(arrangement: Planes) -> Mapping[tuple[int, ...], int]:
    """Return the sign of the determinant of every r normals, r the rank, in increasing order.

    Defined up to one common sign: if r < d, the determinants are those of the pivot columns.
    An affine arrangement has the chirotope of its `cone`, with the plane at infinity last.

    Complexity: C(m, r) determinants.

    >>> from arrangement import Arrangement
    >>> dict(chirotope(Arrangement([[1, 0], [0, 1], [1, 1]])))
    {(0, 1): 1, (0, 2): 1, (1, 2): -1}
    """
    central = _central(arrangement)
    normals = [plane[:-1] for plane in central.integer_planes]
    columns = pivot_columns(normals, central.dimension)
    rows = [[normal[j] for j in columns] for normal in normals]
    number = budget.choose(len(rows), len(columns))
    budget.check_cost(
        f"{budget.about(number)} determinants of {len(columns)} of {len(rows):,} normals",
        "take fewer planes",
        steps=4 * number * max(1, len(columns)) ** 3,
        bytes=number * 200,
    )
    return {
        chosen: sign(determinant([rows[i] for i in chosen]))
        for chosen in combinations(range(len(rows)), len(columns))
    }


def _central(arrangement: Planes) -> Planes:
    """Return a central arrangement itself, and of an affine one the cone."""
    return arrangement if arrangement.is_central else cone(arrangement)


def chirotope_string(arrangement: Planes, order: str = "reverse-lexicographic") -> str:
    """Return the chirotope as a text of ``+``, ``-`` and ``0``, one for each r planes.

    In reverse lexicographic order (123, 124, 134, 234, 125, ...), as Finschi and Fukuda have it, or
    lexicographic (123, 124, 125, ...), as TOPCOM and polymake have it. Of an affine arrangement it
    is that of its `cone`, with the plane at infinity last.

    Source: [FinschiFukuda2002].

    Raises:
        InputError: another order.

    >>> from arrangement import Arrangement
    >>> chirotope_string(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [1, 2, 3]]))
    '++-++-++-+'
    """
    if order not in ORDERS:
        raise InputError(f"the order is {shown(order)}; expected one of {' and '.join(ORDERS)}")
    values = chirotope(arrangement)
    rows = sorted(values, key=lambda row: row[::-1]) if order == ORDERS[0] else values
    return sign_text([values[row] for row in rows])


def cocircuits(arrangement: Planes) -> frozenset[SignVector]:
    """Return the cocircuits: the sign vectors of the rays, nonzero and of least support.

    For every r - 1 independent planes S, the sign at plane e is chi(S, e). For an affine
    arrangement these are the cocircuits of its cone, whose last sign is that of z.

    >>> from arrangement import Arrangement
    >>> sorted(cocircuits(Arrangement([[1, 0], [0, 1]])))
    [(-1, 0), (0, -1), (0, 1), (1, 0)]
    """
    central = _central(arrangement)
    return frozenset(_as_signs(masks, len(central)) for masks in _cocircuit_masks(central))


def circuits(arrangement: Planes) -> frozenset[SignVector]:
    """Return the circuits: the signs of the linear dependencies of least support.

    Of any r + 1 normals that span a space of dimension r, the only dependency has at e the sign of
    the determinant without e, in turn positive and negative. For an affine arrangement these are
    the circuits of its cone. The supports are the circuits of the matroid.

    Complexity: C(m, r + 1) times r, and the determinants of `chirotope`.

    >>> from arrangement import Arrangement
    >>> sorted(circuits(Arrangement([[1, 0], [0, 1], [1, 1]])))
    [(-1, -1, 1), (1, 1, -1)]
    """
    central = _central(arrangement)
    chi = chirotope(central)
    signed: set[SignVector] = set()
    for chosen in combinations(range(len(central)), len(next(iter(chi))) + 1):
        vector = [0] * len(central)
        for k, plane in enumerate(chosen):
            vector[plane] = (-1) ** k * chi[chosen[:k] + chosen[k + 1 :]]
        if any(vector):
            signed |= {tuple(vector), tuple(-x for x in vector)}
    return frozenset(signed)


def bases(arrangement: Planes) -> tuple[tuple[int, ...], ...]:
    """Return the bases of the matroid: the sets of r planes with independent normals.

    For an affine arrangement these are the bases of its cone. A basis of the dual is what a basis
    leaves over. Minors are arrangements: `deletion`, and for contraction `restriction`.

    >>> from arrangement import Arrangement
    >>> bases(Arrangement([[1, 0], [0, 1], [2, 0]]))
    ((0, 1), (1, 2))
    """
    return tuple(chosen for chosen, value in chirotope(arrangement).items() if value)


def dual_chirotope(arrangement: Planes) -> Mapping[tuple[int, ...], int]:
    """Return the chirotope of the dual oriented matroid, whose cocircuits are the `circuits`.

    Of the planes outside a basis B it is the sign of B, times that of the permutation that puts
    them behind B. Defined up to one common sign. An affine arrangement has that of its cone.

    >>> from arrangement import Arrangement
    >>> dual_chirotope(Arrangement([[1, 0], [0, 1], [1, 1]]))
    {(2,): 1, (1,): -1, (0,): -1}
    """
    everything = set(range(len(_central(arrangement))))
    dual = {}
    for chosen, value in chirotope(arrangement).items():
        moved = sum(plane - k for k, plane in enumerate(chosen))
        dual[tuple(sorted(everything.difference(chosen)))] = (-1) ** moved * value
    return dual


def covectors(arrangement: Planes) -> frozenset[SignVector]:
    """Return the covectors: the compositions of cocircuits, 0 included.

    Of a central arrangement these are the sign vectors of all faces. An affine one has the
    covectors of its cone: its faces have the last sign 1, those opposite to them -1, and those at
    infinity 0.

    Complexity: (covectors) times (cocircuits).

    >>> from arrangement import Arrangement
    >>> from collections import Counter
    >>> lines = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
    >>> Counter(vector[-1] for vector in covectors(lines)) == {1: 19, -1: 19, 0: 13}
    True
    """
    central = _central(arrangement)
    composed = _compositions(_cocircuit_masks(central))
    return frozenset(_as_signs(masks, len(central)) for masks in composed)


def topes(arrangement: Planes) -> frozenset[SignVector]:
    """Return the topes: the covectors without zeros, of an affine arrangement those of its cone.

    >>> from arrangement import Arrangement
    >>> sorted(topes(Arrangement([[1, 0], [0, 1]])))
    [(-1, -1), (-1, 1), (1, -1), (1, 1)]
    """
    return frozenset(vector for vector in covectors(arrangement) if all(vector))


def _cocircuit_masks(central: Planes) -> set[_Masks]:
    chi = chirotope(central)
    size = len(central)
    rank = len(next(iter(chi)))
    masks: set[_Masks] = set()
    if rank == 0:
        return masks
    for chosen in combinations(range(size), rank - 1):
        plus = minus = 0
        for plane in range(size):
            value = _sign_with(chi, chosen, plane)
            plus |= (value > 0) << plane
            minus |= (value < 0) << plane
        if plus or minus:
            masks |= {(plus, minus), (minus, plus)}
    return masks


def _sign_with(chi: Mapping[tuple[int, ...], int], chosen: tuple[int, ...], plane: int) -> int:
    """Return chi(S, e): the sign changes with each element of S that e has to pass."""
    if plane in chosen:
        return 0
    value = chi[tuple(sorted((*chosen, plane)))]
    return -value if sum(other > plane for other in chosen) % 2 else value


def _compositions(generators: set[_Masks]) -> set[_Masks]:
    """Return all compositions of sign vectors, the zero vector included."""
    composed: set[_Masks] = {(0, 0)}
    waiting = [(0, 0)]
    while waiting:
        plus, minus = waiting.pop()
        free = ~(plus | minus)
        for more_plus, more_minus in generators:
            new = (plus | (more_plus & free), minus | (more_minus & free))
            if new not in composed:
                composed.add(new)
                waiting.append(new)
    return composed


def _as_signs(masks: _Masks, size: int) -> SignVector:
    """Return a sign vector as a tuple of -1, 0, 1."""
    plus, minus = masks
    return tuple((plus >> i & 1) - (minus >> i & 1) for i in range(size))
