"""Supersolvable arrangements: a chain of modular flats, and why it makes chi a product.

A flat X is modular when rank(X) + rank(Y) = rank(X meet Y) + rank(X join Y) for every flat Y. In a
geometric lattice a flat of rank r - 1 is modular exactly when every flat of rank 2 has a plane in
common with it; and with any chain of modular flats there is one through each modular flat of rank
r - 1, because meets of modular flats are modular. So the chain is found from the top, and no choice
is ever taken back.
"""

from __future__ import annotations

import itertools

from arrangement.errors import InputError
from arrangement.planes import Planes

from .lattice import Flat, IntersectionLattice, intersection_lattice


def modular_chain(arrangement: Planes) -> tuple[Flat, ...] | None:
    """Return modular flats of rank 0, 1, ..., r, each above the one before; None if there are none.

    With one the arrangement is supersolvable, and chi(t) = t^(d - r) (t - e_1) ... (t - e_r), where
    e_k counts the distinct planes that flat k has and flat k - 1 has not: see `exponents`.

    Raises:
        InputError: if the arrangement is not central.

    Source: R. Stanley, Supersolvable lattices, Algebra Universalis 2 (1972); A. Bjoerner,
    P. Edelman, G. Ziegler, Hyperplane arrangements with a lattice of regions, Discrete and
    Computational Geometry 5 (1990), theorem 4.3.

    >>> from arrangement import families
    >>> [flat.planes for flat in modular_chain(families.braid(3))]
    [(), (0,), (0, 1, 2)]
    """
    chain = _chain(arrangement)
    if chain is None:
        return None
    lattice, masks = chain
    return tuple(
        flats[level.index(mask)]
        for flats, level, mask in zip(lattice.flats, lattice.masks, masks, strict=True)
    )


def exponents(arrangement: Planes) -> tuple[int, ...] | None:
    """Return the positive roots of chi that a modular chain explains, in its order; None without.

    Raises:
        InputError: if the arrangement is not central.

    >>> from arrangement import families
    >>> exponents(families.type_b(3)), exponents(families.generic(4))
    ((1, 3, 5), None)
    """
    chain = _chain(arrangement)
    if chain is None:
        return None
    sizes = [mask.bit_count() for mask in chain[1]]
    return tuple(high - low for low, high in itertools.pairwise(sizes))


def _chain(arrangement: Planes) -> tuple[IntersectionLattice, list[int]] | None:
    """Return the lattice and a modular chain, flats as bits of the classes of planes."""
    if not arrangement.is_central:
        raise InputError("the arrangement is not central; ask for its cone")
    lattice = intersection_lattice(arrangement)
    chain = [lattice.masks[-1][0]]
    pencils = lattice.masks[2] if len(lattice.masks) > 2 else ()
    for level in reversed(lattice.masks[:-1]):
        top = chain[0]
        pencils = tuple(pencil for pencil in pencils if not pencil & ~top)
        below = (flat for flat in level if not flat & ~top)
        found = next((flat for flat in below if all(flat & pencil for pencil in pencils)), None)
        if found is None:
            return None
        chain.insert(0, found)
    return lattice, chain
