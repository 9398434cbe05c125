"""Whitney numbers of the first kind by Weisner's theorem, over orbits of flats.

For a flat X let |X| be the number of distinct planes through it. Summed over the planes through X,
Weisner's theorem says ``|X| mu(X) = - sum of mu(Y) (|X| - |Y|)`` over the flats Y that X covers. So
the sum of mu over a rank follows from the rank below, and of the flats that symmetries take to each
other one is enough. The page on proofs has the argument, and why classes that are finer than orbits
are right together: what each holds may then be a fraction, and is kept modulo primes.

Every plane has a height, and a set the sum of those of its planes. Steps go from a set to the
lowest of its images under a list of permutations, until none is lower (`Images`). Sets that end at
the same image lie in one orbit, and nothing else is asked; but the fewer images an orbit has, the
better. Heights that vary at random have many valleys. So those are taken that permutations change
least: on each orbit of planes the slowest wave of a walk in which every generator takes a step.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import comb, prod

import numpy as np
from numpy.typing import NDArray

from arrangement.console.progress import watched
from arrangement.counts.configuration import Configuration, configuration, flats_foreseen
from arrangement.counts.modular import Integers, ModularVectors
from arrangement.counts.operations import localization, restriction
from arrangement.counts.orbits.automorphisms import Automorphisms, Permutations
from arrangement.counts.whitney import first_whitney_numbers
from arrangement.errors import InputError, OutOfTimeError
from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import shown
from arrangement.numbers.packing import Bits, Words, group_rows, pack, unpack
from arrangement.planes.planes import Planes

#: Sets that go down together.
_BATCH = 1 << 12
#: Permutations that are tried in each step.
_ELEMENTS = 40
#: Steps of the walk after which the slowest wave is left.
_ROUNDS = 300
#: Pairs of a flat and a plane that are worked on at once.
_CHUNK = 1 << 19
#: Bytes of the planes in flats at once.
_COVERED = 1 << 25
#: Steps for a pair of a flat and a plane, and for a flat that comes up.
_PAIR, _COVER = 5, 8
#: The same for the planes through a flat, and for those that the others cut out on it: measured.
_PART = 60_000
#: Flats that are put together at once.
MANY = 1 << 20
#: Flats are distinguished by class where the planes have at most 1 / 8 as many orbits as planes.
_PLANES_IN_AN_ORBIT = 8
#: Classes in a sample.
SAMPLE = 2000


class Images:
    """Low images under a group of permutations.

    Args:
        generators: of the group; each takes vector i to entry i.
    """

    def __init__(self, generators: Permutations) -> None:
        # a vector more, of height 0, that nothing moves: it fills up small sets
        size = generators.shape[1]
        moves = np.vstack([np.arange(size), *_products(generators, _ELEMENTS)])
        self._moves = np.column_stack([moves, np.full(len(moves), size)])
        self._heights = np.append(_heights(generators), 0)[self._moves].T.copy()

    def low(self, sets: Bits) -> Words:
        """Return an image of each set (a row), packed, that no permutation of the list lowers."""
        images = pack(sets)
        if len(self._moves) > 1:
            order = sets.sum(axis=1).argsort(kind="stable")
            for part in budget.chunks(len(sets), _BATCH):
                images[order[part]] = pack(self._lower(sets[order[part]]))
        return images

    def steps(self, sets: Bits) -> float:
        """Return about how many steps their images take."""
        return np.count_nonzero(sets) * len(self._moves) / 20

    def _lower(self, sets: Bits) -> Bits:
        """Return images of sets of about the same size."""
        count, size = sets.shape
        sizes = sets.sum(axis=1)
        names, vectors = np.nonzero(sets)
        members = np.full((sizes.max(), count), size)
        members[np.arange(len(names)) - (sizes.cumsum() - sizes)[names], names] = vectors
        result = np.zeros((count, size + 1), dtype=np.bool_)
        names = np.arange(count)
        while len(names):
            heights = np.zeros((len(names), len(self._moves)), dtype=np.int64)
            for member in members:
                heights += self._heights[member]
            lowest = heights.argmin(axis=1)
            goes = lowest > 0
            result[names[~goes], members[:, ~goes]] = True
            names, members = names[goes], self._moves[lowest[goes], members[:, goes]]
        return result[:, :size]


def _heights(generators: Permutations) -> Integers:
    """Return heights of the vectors, the highest four times the lowest at most."""
    size = generators.shape[1]
    steps = np.concatenate([[np.arange(size)], generators, generators.argsort(axis=1)])
    orbit = np.arange(size)
    while ((lower := orbit[steps].min(axis=0)) < orbit).any():
        orbit = lower
    number = np.bincount(orbit)[orbit]
    wave = np.random.default_rng(0).random((size,))
    for _ in range(_ROUNDS):
        wave = len(steps) * wave + wave[steps].sum(axis=0)
        wave -= np.bincount(orbit, wave)[orbit] / number
        top = np.zeros(size)
        np.maximum.at(top, orbit, np.abs(wave))
        wave /= np.maximum(top, 1)[orbit]
    heights: Integers = (2.0 ** (60 - size.bit_length() - wave)).astype(np.int64)
    return heights


def _products(generators: Permutations, count: int) -> Permutations:
    """Return the generators and random products of them, the same every time."""
    if not len(generators):
        return generators
    random = np.random.default_rng(0)
    products = list(generators)
    state = [*generators] * (1 + 10 // len(generators))
    identity = np.arange(generators.shape[1])
    known = {identity.tobytes(), *(g.tobytes() for g in generators)}
    for step in range(20 * count):
        i, j = random.choice(len(state), 2, replace=False)
        state[i] = state[i][state[j]] if random.integers(2) else state[j][state[i]]
        if step > 60 and state[i].tobytes() not in known:
            known.add(state[i].tobytes())
            products.append(state[i])
        if len(products) >= count:
            break
    return np.array(products)


@dataclass(frozen=True)
class Flats:
    """Flats of one rank, one of each class.

    Attributes:
        bases: independent vectors of each flat.
        members: the vectors of each flat, packed.
        images: what stands for the class of each flat, packed.
        values: what each class adds to the sum of mu over the rank, a row for each modulus.
    """

    bases: Integers
    members: Words
    images: Words
    values: Integers

    def __len__(self) -> int:
        return len(self.bases)

    @classmethod
    def concatenate(cls, parts: Sequence[Flats]) -> Flats:
        """Return the flats of all parts."""
        return cls(
            np.concatenate([part.bases for part in parts]),
            np.concatenate([part.members for part in parts]),
            np.concatenate([part.images for part in parts]),
            np.concatenate([part.values for part in parts], axis=1),
        )

    def __getitem__(self, part: slice | NDArray[np.intp]) -> Flats:
        return Flats(self.bases[part], self.members[part], self.images[part], self.values[:, part])


def first_numbers(
    arrangement: Planes,
    config: Configuration,
    symmetry: Sequence[Sequence[int]] | None,
    deadline: Deadline,
) -> tuple[int, ...]:
    """Return the first Whitney numbers of `config`; arguments: `counts.first_whitney_numbers`."""
    automorphisms = Automorphisms(config)
    if symmetry is None:
        generators = automorphisms.generators()
    else:
        generators = automorphisms.check_permutations(_of_classes(arrangement, symmetry))
    numbers: list[int] = []
    try:
        with budget.limit(budget.times() if deadline.seconds is None else math.inf):
            for number in classes(config, generators, deadline).numbers():
                numbers.append(number)
    except TimeoutError:
        known = ", ".join(map(str, numbers))
        raise OutOfTimeError(
            f"{deadline}: the first Whitney numbers {known} are final; give more time for the "
            "others",
            tuple(numbers),
        ) from None
    return tuple(numbers)


def _of_classes(planes: Planes, symmetry: Sequence[Sequence[int]]) -> list[list[int]]:
    """Return permutations of planes as permutations of the classes of coincident planes."""
    masks = []
    for number, permutation in enumerate(symmetry):
        try:
            each_once = sorted(permutation) == list(range(len(planes)))
        except TypeError:
            each_once = False
        if not each_once:
            raise InputError(
                f"symmetry[{number}] is {shown(permutation)}; give the images of the planes 0 to "
                f"{len(planes) - 1}, each once"
            )
        image = [planes.class_of[permutation[first]] for first in planes.firsts]
        if any(image[planes.class_of[i]] != planes.class_of[j] for i, j in enumerate(permutation)):
            raise InputError(
                f"symmetry[{number}] takes coincident planes to planes that do not coincide; "
                "give a permutation that keeps them together"
            )
        masks.append(image)
    return masks


class Classes:
    """The flats of a configuration, rank by rank.

    Args:
        images: what distinguishes flats.
        deadline: looked at before each part of a rank.
        moduli: primes; their product exceeds what is reconstructed from its residues.
    """

    def __init__(
        self, config: Configuration, images: Images, deadline: Deadline, moduli: Sequence[int]
    ) -> None:
        self._planes, self.rank = len(config.vectors), config.rank
        self._central = config.infinity is None
        rows = [*config.vectors, *([] if config.infinity is None else [config.infinity])]
        self._vectors, self._images, self._deadline = (
            ModularVectors(rows, config.rank),
            images,
            deadline,
        )
        self._moduli = moduli
        #: Counted so far.
        self.steps = 0.0
        self._modulus = np.array(self._moduli)[:, None]
        self._inverses = np.array(
            [[0, *(pow(k, -1, q) for k in range(1, self._planes + 1))] for q in self._moduli]
        )

    def numbers(self) -> Iterator[int]:
        """Yield the Whitney numbers of the first kind; `TimeoutError` ends them at the deadline."""
        flats = self.bottom()

        def residues() -> Iterator[Integers]:
            nonlocal flats
            for rank in range(1, self.rank):
                flats, sums = self.above(flats, rank)
                yield sums

        yield from self.from_residues(residues())

    def from_residues(self, residues: Iterable[Integers]) -> Iterator[int]:
        """Yield the Whitney numbers, given the residues of those of rank 1, 2, ...

        The top of a central arrangement follows, because all numbers together are chi(1) = 0.
        """
        from sympy.ntheory.modular import crt

        total = 1
        yield total
        for rank, sums in enumerate(residues, start=1):
            size = int(crt(self._moduli, ((-1) ** rank * sums % self._modulus[:, 0]).tolist())[0])
            total += (-1) ** rank * size
            yield (-1) ** rank * size
        if self._central:
            yield -total

    def levels(self) -> Iterator[Flats]:
        """Yield one flat of each class, rank by rank, but for the top of a central arrangement."""
        flats = self.bottom()
        yield flats
        for rank in range(1, self.rank):
            flats, _ = self.above(flats, rank, keep=True)
            yield flats

    def bottom(self) -> Flats:
        """Return the whole space."""
        empty = pack(np.zeros((1, self._vectors.count), dtype=np.bool_))
        return Flats(np.zeros((1, 0), np.int64), empty, empty, np.ones_like(self._modulus))

    def above(self, flats: Flats, rank: int, *, keep: bool = False) -> tuple[Flats, Integers]:
        """Return one flat of each class above flats of the rank before, and residues.

        The residues, one for each modulus, are what the flats below add to the Whitney number of
        the rank. Flats of the last rank have none above them and are left out, unless to be kept.
        """
        keep = keep or rank < self.rank - 1
        parts, waiting, residues = [], 0, np.zeros(len(self._moduli), dtype=np.int64)
        count = self._vectors.count
        step = max(1, min(_CHUNK // count, _COVERED // count**2))
        ranks = range(rank - 1, self.rank - 1 if rank > 2 else rank)
        ahead = sum(flats_foreseen(self._planes, k, rank - 1, len(flats)) for k in ranks)
        pairs = ahead * count
        budget.check_cost(
            f"what covers {len(flats):,} orbits of flats of rank {rank - 1}, and so on",
            "leave out planes, or count in parts (--store FOLDER)",
            long_steps=pairs * self.rank / 2,
        )
        pieces = [flats[i : i + step] for i in range(0, len(flats), step)]
        for done, piece in enumerate(watched(pieces, f"parts of rank {rank}", len(pieces))):
            self._deadline.check()
            members = unpack(piece.members, self._vectors.count)
            covers = self._vectors.covers(piece.bases, members)
            if not self._central:
                covers = covers.without(self._planes)
            sizes = members.sum(axis=1)[covers.below] + covers.added
            values = piece.values[:, covers.below] * -covers.added % self._modulus
            values = values * self._inverses[:, sizes] % self._modulus
            residues = (residues + values.sum(axis=1)) % self._modulus[:, 0]
            self._count(_PAIR * members.size)
            if keep:
                above = members[covers.below]
                above[covers.cover, covers.member] = True
                bases = np.column_stack([piece.bases[covers.below], covers.plane])
                self._count(len(above) * _COVER + self._images.steps(above))
                images = self._images.low(above)
                parts.append(self.merge(Flats(bases, pack(above), images, values)))
                if done == min(2, len(pieces) - 1):
                    higher, share = Flats.concatenate(parts), (done + 1) / len(pieces)
                    numbers = (higher.bases, higher.members, higher.images, higher.values)
                    budget.check_cost(
                        f"{budget.about(len(higher) / share)} orbits of flats of rank {rank}",
                        "leave out planes, or count in parts (--store FOLDER)",
                        bytes=3 * sum(x.nbytes for x in numbers) / share,
                    )
                waiting += len(parts[-1])
                if waiting > MANY:
                    parts, waiting = [self.merge(Flats.concatenate(parts))], 0
        return (self.merge(Flats.concatenate(parts)) if parts else flats[:0]), residues

    def _count(self, steps: float) -> None:
        self.steps += steps
        budget.spend(steps)

    def merge(self, flats: Flats) -> Flats:
        """Return one flat of each class, with the sum of the values of all."""
        order, start = group_rows(flats.images)
        first = np.flatnonzero(start)
        values = np.add.reduceat(flats.values[:, order], first, axis=1) % self._modulus
        kept = order[first]
        return Flats(flats.bases[kept], flats.members[kept], flats.images[kept], values)


def classes(config: Configuration, generators: Permutations, deadline: Deadline) -> Classes:
    """Return the classes under some automorphisms, with moduli for the Whitney numbers."""
    # their sizes are at most binomial coefficients
    moduli = moduli_above(max(comb(len(config.vectors), rank) for rank in range(config.rank)))
    return Classes(config, Images(generators), deadline, moduli)


def moduli_above(bound: int, below: int = 1 << 31) -> list[int]:
    """Return the largest primes below 2^31, or less, with a product above the bound."""
    from sympy import prevprime

    moduli: list[int] = []
    while prod(moduli) <= bound:
        moduli.append(int(prevprime(moduli[-1] if moduli else below)))
    return moduli


def flats_and_faces(
    planes: Planes, config: Configuration, *, faces: bool, below: int = 1 << 31
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Return the numbers of flats of rank 0, 1, ..., and the numbers of faces in them.

    A class P holds a part of its orbit, which need not be known: what it adds to the sum of mu is
    m(P) (see the page on proofs), and mu is the same on an orbit, so it holds ``m(P) / mu(X)``
    flats, for X its representative. Added up over an orbit this is the number of its flats. Times
    the number of regions that the other planes cut out on X, it is the number of faces in them.

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
    for rank, flats in enumerate(Classes(config, Images(generators), Deadline(), moduli).levels()):
        residues = [[0] * len(moduli), [0] * len(moduli)]
        sets = unpack(flats.members, automorphisms.size)
        for place, members in enumerate(watched(sets, f"classes of rank {rank}")):
            budget.spend((1 + faces) * _PART)
            chosen = [planes.firsts[i] for i in np.flatnonzero(members)]
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


@dataclass(frozen=True)
class RankForecast:
    """What the flats of one rank will take.

    Attributes:
        rank: of the flats.
        classes: of them; those above which are looked for.
        exact: whether they were all counted.
        steps: for all flats above them; see `arrangement.numbers.budget`.
        megabytes: of memory, for one flat of each class.
    """

    rank: int
    classes: int
    exact: bool
    steps: int
    megabytes: float


def forecast(arrangement: Planes, sample: int = SAMPLE) -> Iterator[RankForecast]:
    """Yield what each rank will take in `first_whitney_numbers`, as soon as it is known.

    Ranks with few classes are done; of others a random sample is. Each half of a sample leads to
    some classes of the next rank. If it were by chance whether a class comes up, their number would
    be the product of what the halves found, divided by what both found: capture and recapture.
    Classes with many flats below come up more often than others, so that numbers come out too
    small, the more so the further a rank is from the last one that was done.

    Source: for the number of classes, G. Seber, The Estimation of Animal Abundance (1982),
    chapter 3 (Petersen's method).

    >>> from arrangement.library import families
    >>> [(entry.rank, entry.exact) for entry in forecast(families.resonance(5))]
    [(0, True), (1, True), (2, True), (3, True)]
    """
    config = configuration(arrangement)
    made = classes(config, Automorphisms(config).generators(), Deadline())
    generator = np.random.default_rng(0)
    flats, number, exact = made.bottom(), 1.0, True
    for rank in watched(range(1, made.rank), "ranks"):
        chosen = flats
        if len(flats) > sample:
            chosen = flats[generator.permutation(len(flats))[:sample]]
        before = made.steps
        halves = [made.above(chosen[k::2], rank)[0] for k in (0, 1)]
        steps = (made.steps - before) / len(chosen) * number
        yield RankForecast(
            rank - 1, round(number), exact, round(steps), number * _bytes(flats) / 2**20
        )
        if rank == made.rank - 1:
            return
        flats = made.merge(Flats.concatenate([half for half in halves if len(half)]))
        exact = exact and len(chosen) == number
        both = sum(map(len, halves)) - len(flats)
        number = len(flats) if exact else math.prod(map(len, halves)) / max(1, both)


def _bytes(flats: Flats) -> float:
    arrays = (flats.bases, flats.members, flats.images, flats.values)
    return sum(array.nbytes for array in arrays) / len(flats)
