"""Numbers of flats, and of faces, by classes of flats.

A class P holds a part of its orbit, which need not be known: what it adds to the sum of mu is m(P)
(see the page on proofs), and mu is the same on an orbit, so it holds ``m(P) / mu(X)`` flats, for X
its representative. Added up over an orbit this is the number of its flats. Times the number of
regions that the other planes cut out on X, it is the number of faces in them.
"""

from __future__ import annotations

import math
from math import comb

import numpy as np

from arrangement.console.progress import watched
from arrangement.counts.configuration import Configuration
from arrangement.counts.operations import localization, restriction
from arrangement.planes.planes import Planes

from .automorphisms import Automorphisms
from .images import Images, unpacked
from .symmetric import Classes, first_whitney_numbers, moduli_above

#: Flats are told apart by class where the planes have at most 1 / 8 as many orbits as planes.
_PLANES_IN_AN_ORBIT = 8


def flats_and_faces(
    planes: Planes, config: Configuration, *, faces: bool, below: int = 1 << 31
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Return the numbers of flats of rank 0, 1, ..., and the numbers of faces in them.

    Args:
        config: of the planes.
        faces: whether they are wanted; if not, their numbers are those of the flats.
        below: the primes that are used.

    Returns:
        None if the planes have few symmetries, or none.
    """
    from sympy.ntheory.modular import crt

    automorphisms = Automorphisms(config)
    generators = automorphisms.generators()
    count = len(config.vectors)
    if automorphisms.orbits(generators) * _PLANES_IN_AN_ORBIT > count:
        return None
    # each flat of rank k is met by at most as many regions of the other planes
    regions = [sum(comb(count, i) for i in range(config.rank - k + 1)) for k in range(config.rank)]
    moduli = moduli_above(max(comb(count, k) * number for k, number in enumerate(regions)), below)
    sums = []
    for rank, flats in enumerate(Classes(config, Images(generators), math.inf, moduli).levels()):
        residues = [[0] * len(moduli), [0] * len(moduli)]
        sets = unpacked(flats.members, automorphisms.size)
        for place, members in enumerate(watched(sets, f"classes of rank {rank}")):
            chosen = [planes.distinct[i][0] for i in np.flatnonzero(members)]
            moebius = first_whitney_numbers(localization(planes, chosen))[-1] if rank else 1
            inside = _regions(planes, chosen, rank) if faces else 1
            for j, q in enumerate(moduli):
                if moebius % q == 0:
                    return flats_and_faces(planes, config, faces=faces, below=moduli[-1])
                share = int(flats.values[j, place]) * pow(moebius, -1, q)
                residues[0][j] += share
                residues[1][j] += share * inside
        sums.append([int(crt(moduli, row)[0]) for row in residues])
    if config.infinity is None:
        everything = list(range(len(planes)))
        sums.append([1, _regions(planes, everything, config.rank) if faces else 1])
    flats_of, faces_of = zip(*sums, strict=True)
    return flats_of, faces_of


def _regions(planes: Planes, chosen: list[int], rank: int) -> int:
    """Return the number of regions that planes cut out on the intersection of some of them."""
    if rank == planes.dimension:
        return 1
    return sum(map(abs, first_whitney_numbers(restriction(planes, chosen))))
