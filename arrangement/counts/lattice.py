"""The lattice of flats, and chains of modular flats in it.

Flats are found upwards by closure of spans: a flat is extended by each plane beside it, and
planes with proportional vectors in the quotient are extended together. This is exact integer
elimination on the normals. No point or face of the arrangement is ever computed.

A flat X is modular when rank(X) + rank(Y) = rank(X meet Y) + rank(X join Y) for every flat Y. In a
geometric lattice a flat of rank r - 1 is modular exactly when every flat of rank 2 has a plane in
common with it; and with any chain of modular flats there is one through each modular flat of rank
r - 1, because meets of modular flats are modular. So the chain is found from the top, and no choice
is ever taken back.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import ClassVar

from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, bits as bits_of, largest, unoriented
from arrangement.planes.planes import Planes

from .configuration import Configuration, configuration, flats_foreseen, indices
from .low_rank import WhitneyMatrix, rank_two_groups


@dataclass(frozen=True, slots=True)
class Flat(ReprMixin):
    """An intersection of planes.

    Attributes:
        planes: indices of all input planes that contain it, increasing; coincident ones included.
        rank: its codimension.
        dimension: of the intersection, as a subset of R^d.
    """

    planes: tuple[int, ...]
    rank: int
    dimension: int


@dataclass(eq=False)
class IntersectionLattice(ReprMixin):
    """All nonempty intersections of planes, ordered by reverse inclusion.

    For a central arrangement a geometric lattice; for an affine one a semilattice, each of whose
    intervals from the bottom (the whole space) is one.

    Attributes:
        flats: the flats of rank 0, 1, ..., each level in order of discovery.
        masks: for each flat, the classes of planes that contain it, as bits.
        covers: for each flat, positions in the next level of the flats that cover it.
    """

    _synonyms: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("draw", "hasse", "hasse_diagram", "plot", "show"), "lattice.arrangement.draw('lattice')"
    )
    repr_fields = ("arrangement",)
    arrangement: Planes
    masks: tuple[tuple[int, ...], ...] = field(repr=False)
    covers: tuple[tuple[tuple[int, ...], ...], ...] = field(repr=False)

    @cached_property
    def flats(self) -> tuple[tuple[Flat, ...], ...]:
        """The flats of rank 0, 1, ...; the first level is the whole space alone."""
        distinct, dimension = self.arrangement.distinct, self.arrangement.dimension
        plain = all(len(members) == 1 for members in distinct)

        def planes(mask: int) -> tuple[int, ...]:
            classes = bits_of(mask)
            return classes if plain else tuple(sorted(p for c in classes for p in distinct[c]))

        return tuple(
            tuple(Flat(planes(mask), rank, dimension - rank) for mask in level)
            for rank, level in enumerate(self.masks)
        )

    @cached_property
    def moebius(self) -> Mapping[Flat, int]:
        """mu(whole space, X) for every flat X.

        By Weisner's theorem only covers are needed: for any plane a that contains X,
        mu(X) is minus the sum of mu(Y) over the flats Y that X covers and a does not contain.
        """
        levels = self._moebius_above(0, 0)
        return {
            flat: values[mask]
            for flats, masks, values in zip(self.flats, self.masks, levels, strict=True)
            for flat, mask in zip(flats, masks, strict=True)
        }

    @cached_property
    def whitney_matrix(self) -> WhitneyMatrix:
        """The sums V[k][j] of |mu(X, Y)| over all flats X <= Y of rank k and j."""
        return tuple(self.whitney_row(k) for k in range(len(self.masks)))

    def whitney_row(self, rank: int) -> tuple[int, ...]:
        """Return one row of `whitney_matrix`; the row of rank 0 is by far the cheapest."""
        row = [0] * len(self.masks)
        for position in watched(range(len(self.masks[rank])), f"flats of rank {rank}"):
            for j, values in enumerate(self._moebius_above(rank, position)):
                row[rank + j] += sum(map(abs, values.values()))
        return tuple(row)

    def closure(self, planes: Iterable[int]) -> Flat | None:
        """Return the intersection of some input planes as a flat, or None if it is empty."""
        wanted = 0
        for plane in indices(self.arrangement, planes):
            wanted |= 1 << self.arrangement.class_of[plane]
        for flats, masks in zip(self.flats, self.masks, strict=True):
            for flat, mask in zip(flats, masks, strict=True):
                if mask & wanted == wanted:
                    return flat
        return None

    def _moebius_above(self, rank: int, position: int) -> list[dict[int, int]]:
        """Return mu(X, Y) by mask, level by level, for the flats Y above the chosen X."""
        bottom = self.masks[rank][position]
        here = {position: 1}
        levels = [{bottom: 1}]
        for level in range(rank, len(self.masks) - 1):
            masks, above = self.masks[level], self.masks[level + 1]
            values: dict[int, int] = {}
            for index, value in here.items():
                for cover in self.covers[level][index]:
                    beside = above[cover] & ~bottom
                    lowest = beside & -beside
                    if not masks[index] & lowest:
                        values[cover] = values.get(cover, 0) - value
            here = values
            levels.append({above[cover]: value for cover, value in here.items()})
        return levels


def intersection_lattice(arrangement: Planes) -> IntersectionLattice:
    """Return every flat of an arrangement, with covers and Moebius function.

    Hypotheses: none; central or affine, any rank, coincident planes allowed.

    Complexity: with m distinct planes in rank r, one elimination step of O(d) integer operations
    for each plane and each flat of rank at most r - 2 (r - 1 if affine). General position has
    C(m, k) flats of rank k.

    Source: R. Stanley, An Introduction to Hyperplane Arrangements (2007), lectures 1 to 3.

    >>> from arrangement import Arrangement
    >>> braid = Arrangement([[1, -1, 0], [1, 0, -1], [0, 1, -1]])
    >>> lattice = intersection_lattice(braid)
    >>> [len(level) for level in lattice.flats]
    [1, 3, 1]
    >>> lattice.moebius[lattice.flats[2][0]]
    2
    """
    config = configuration(arrangement)
    levels = config.rank + (config.infinity is None)
    least = budget.power(2, arrangement.rank)  # those of as many independent planes
    budget.check_cost(
        f"the {budget.about(least)} or more flats of planes of rank {arrangement.rank}",
        "give planes of lower rank",
        bytes=200 * least,
    )
    masks: list[tuple[int, ...]] = [(0,)]
    covers: list[tuple[tuple[int, ...], ...]] = []
    if config.rank == 3:
        masks, covers = _lower_levels_of_rank_three(config)
    quotients = _Quotients.begin(config)
    everything = (1 << len(config.vectors)) - 1
    while len(masks) < levels:
        if len(masks) == config.rank:  # central: the only flat left is the top
            covers.append(((0,),) * len(masks[-1]))
            masks.append((everything,))
        else:
            flats, above = quotients.extend(keep=len(masks) < config.rank - 1)
            masks.append(flats)
            covers.append(above)
    covers.append(((),) * len(masks[-1]))
    return IntersectionLattice(arrangement, tuple(masks), tuple(covers))


def moebius(arrangement: Planes) -> Mapping[Flat, int]:
    """Return mu(whole space, X) for every flat X; see `intersection_lattice`.

    >>> from arrangement import Arrangement
    >>> values = moebius(Arrangement([[1, 0], [0, 1], [1, 1]]))
    >>> sorted(values.values())
    [-1, -1, -1, 1, 2]
    """
    return intersection_lattice(arrangement).moebius


def t_vector(arrangement: Planes) -> Mapping[int, int]:
    """Return how many flats of codimension 2 lie on j distinct planes, by j.

    Of central planes in R^3 these are the points on j lines of the projective plane, of affine
    lines in R^2 the points on j lines.

    Source: B. Gruenbaum, A catalogue of simplicial arrangements in the real projective plane, Ars
    Mathematica Contemporanea 2 (2009).

    >>> from arrangement import families
    >>> t_vector(families.simplicial(6, 1))
    {2: 3, 3: 4}
    """
    levels = intersection_lattice(arrangement).masks
    sizes = Counter(mask.bit_count() for mask in (levels[2] if len(levels) > 2 else ()))
    return dict(sorted(sizes.items()))


@dataclass
class _Quotients:
    """The flats of one level with the vectors of all other planes in the quotient by each.

    `vectors[i]` has, for each class beside flat i, its primitive unoriented vector; class
    `infinity` stands for infinity.

    Attributes:
        top: the rank of all vectors.
        bits: of their entries, many if they are irrational.
        rank: of the level.
    """

    masks: tuple[int, ...]
    vectors: list[dict[int, IntegerVector]]
    infinity: int
    top: int
    bits: float
    rank: int

    @classmethod
    def begin(cls, config: Configuration) -> _Quotients:
        """Start at the bottom."""
        count = len(config.vectors)
        vectors = {i: unoriented(vector) for i, vector in enumerate(config.vectors)}
        if config.infinity is not None:
            vectors[count] = config.infinity
        size = largest(config.vectors)
        bits = size.bit_length() if isinstance(size, int) else 1000
        return cls((0,), [vectors], count, config.rank, bits, 0)

    def extend(self, *, keep: bool) -> tuple[tuple[int, ...], tuple[tuple[int, ...], ...]]:
        """Move up one level; return its flats, and for each old flat the covers among them.

        The quotients by the new flats are worked out only if a further level needs them.
        """
        position: dict[int, int] = {}
        covers: list[tuple[int, ...]] = []
        quotients: list[dict[int, IntegerVector]] = []
        self._check_cost()
        for mask, vectors in zip(self.masks, self.vectors, strict=True):
            groups: dict[IntegerVector, list[int]] = {}
            for plane, vector in vectors.items():
                groups.setdefault(vector, []).append(plane)
            above = []
            for vector, planes in groups.items():
                if planes[-1] == self.infinity:
                    continue
                flat = mask
                for plane in planes:
                    flat |= 1 << plane
                if flat not in position:
                    position[flat] = len(position)
                    if keep:
                        quotients.append(_contract(vectors, vector, set(planes)))
                above.append(position[flat])
            covers.append(tuple(above))
        self.masks, self.vectors, self.rank = tuple(position), quotients, self.rank + 1
        return self.masks, tuple(covers)

    def _check_cost(self) -> None:
        """Refuse what is out of reach, on this level or a later one."""
        planes, known = self.infinity, max(self.rank, 2)
        total: float = len(self.masks)
        if self.rank == 1:  # each is counted as often as planes contain it
            sizes = (Counter(vectors.values()).values() for vectors in self.vectors)
            total = sum(1 / (size + 1) for row in sizes for size in row)
        vectors = steps = bytes = 0.0
        for k in range(self.rank, self.top - 1 if self.rank else 1):
            flats = flats_foreseen(planes, k, known, total)
            kept = flats_foreseen(planes, k + 1, known, total) * (planes - k - 1)
            kept *= k + 2 < self.top
            before, vectors = vectors, kept * (160 + (self.top - k) * self.bits * (k + 1) / 4)
            steps += flats * (planes - k) * 5 + kept * (20 + 0.6 * self.bits)
            bytes = max(bytes, before + vectors + 20 * flats * (planes - k))
        budget.check_cost(
            f"the flats of rank {self.rank + 1} and more of {planes:,} planes",
            "count without the lattice (arrangement count)",
            steps=steps,
            bytes=bytes,
        )


def _contract(
    vectors: dict[int, IntegerVector], by: IntegerVector, planes: set[int]
) -> dict[int, IntegerVector]:
    """Return the vectors of the other planes in the quotient by one vector.

    SymPy's matrices take 2 to 7 times as long: this step is done for every flat, on few vectors.
    """
    j = next(k for k, x in enumerate(by) if x)
    pivot, rest = by[j], by[:j] + by[j + 1 :]
    result = {}
    for plane, vector in vectors.items():
        if plane not in planes:
            factor = vector[j]
            other = vector[:j] + vector[j + 1 :]
            if factor:
                other = tuple([x * pivot - y * factor for x, y in zip(other, rest, strict=True)])
            result[plane] = unoriented(other)
    return result


def _lower_levels_of_rank_three(
    config: Configuration,
) -> tuple[list[tuple[int, ...]], list[tuple[tuple[int, ...], ...]]]:
    """Return the flats of rank 0, 1, 2 and the covers of the first two levels, vectorised."""
    count = len(config.vectors)
    groups = rank_two_groups(config)
    above: list[list[int]] = [[] for _ in range(count)]
    lines: list[int] = []
    for smallest, members in zip(groups.row.tolist(), groups.members(), strict=True):
        mask = 1 << smallest
        above[smallest].append(len(lines))
        for plane in members.tolist():
            mask |= 1 << plane
            above[plane].append(len(lines))
        lines.append(mask)
    atoms = tuple(1 << plane for plane in range(count))
    covers = [(tuple(range(count)),), tuple(map(tuple, above))]
    return [(0,), atoms, tuple(lines)], covers


def modular_chain(arrangement: Planes) -> tuple[Flat, ...] | None:
    """Return modular flats of rank 0, 1, ..., r, each above the one before; None if there are none.

    With one the arrangement is supersolvable, and chi(t) = t^(d - r) (t - e_1) ... (t - e_r), where
    e_k counts the distinct planes that flat k has and flat k - 1 has not: see
    `supersolvable_exponents`.

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


def supersolvable_exponents(arrangement: Planes) -> tuple[int, ...] | None:
    """Return the exponents that a modular chain gives, in its order; None without such a chain.

    They are the positive roots of chi. None says that the arrangement is not supersolvable, and
    nothing more: the mirrors of D4 and F4 are free, and have exponents that no chain gives. Integer
    roots of `characteristic_polynomial` prove neither.

    Raises:
        InputError: if the arrangement is not central.

    >>> from arrangement import families
    >>> supersolvable_exponents(families.type_b(3)), supersolvable_exponents(families.type_d(4))
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
        modular = next((flat for flat in below if all(flat & pencil for pencil in pencils)), None)
        if modular is None:
            return None
        chain.insert(0, modular)
    return lattice, chain
