"""Parallel planes in quotients, exactly, by arithmetic modulo primes.

Every minor of the vectors is at most H in size, by Hadamard's inequality. Take primes whose product
exceeds H. An integer of size at most H is 0 exactly when it is 0 modulo each of them. Let B be k
vectors that are independent modulo each prime, hence independent, and a and c vectors outside their
span modulo each prime. Then a and c are parallel in the quotient by B exactly when all minors of
order k + 2 of B, a, c vanish, so exactly when a and c are parallel modulo each prime.

A single prime above H is always good enough: ranks modulo it are ranks. Of several primes one may
divide a minor that is not 0; then a dependency shows that the planes do not have, and other primes
are taken for the flats in question.

Entries in a number field Q(a) are reduced modulo primes that divide f(r) for an integer r, with f
the minimal polynomial of a: r stands for a. What is not 0 and becomes 0 has a norm, an integer,
that the prime divides; so the bound is that of norms, the product over all conjugates.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import isqrt, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from arrangement.numbers import budget
from arrangement.numbers.deadline import check_time
from arrangement.numbers.exact import IntegerVector
from arrangement.numbers.real import field_of, residues

Integers = NDArray[np.int64]
#: Sums of this many bits are exact in int64, and in doubles.
_INT64_BITS, _DOUBLE_BITS = 63, 53
#: Steps to a prime; to one that has an image of a field.
_PRIME_STEPS = 1000
_FIELD_PRIME_STEPS = 10_000
#: Bits of a long number whose remainder takes a step.
_BITS_A_STEP = 500


class _BadPrimeError(Exception):
    """A minor that is not 0 vanishes modulo this prime."""


@dataclass(frozen=True)
class Covers:
    """The flats that cover some flats, each as the planes that it has more.

    Attributes:
        below: for each cover, which flat it covers.
        plane: for each cover, one of the new planes.
        added: for each cover, how many new planes there are.
        cover, member: the new planes one by one, as pairs.
    """

    below: Integers
    plane: Integers
    added: Integers
    cover: Integers
    member: Integers

    def without(self, vector: int) -> Covers:
        """Return the covers that do not have one of the vectors."""
        keep = np.ones(len(self.below), dtype=np.bool_)
        keep[self.cover[self.member == vector]] = False
        stays = keep[self.cover]
        number = np.cumsum(keep) - 1
        return Covers(
            self.below[keep],
            self.plane[keep],
            self.added[keep],
            number[self.cover[stays]],
            self.member[stays],
        )


class ModularVectors:
    """Integer vectors of full rank, pairwise independent, seen modulo primes."""

    def __init__(self, vectors: Sequence[IntegerVector], rank: int) -> None:
        self._vectors: Sequence[Sequence[Any]] = vectors
        self._field = field_of(x for row in vectors for x in row)
        self.count, self.rank = len(vectors), rank
        self.index_bits = self.count.bit_length()

    def covers(self, bases: Integers, members: NDArray[np.bool_]) -> Covers:
        """Return the covers of flats of one rank k.

        Args:
            bases: k independent vectors of each flat.
            members: for each flat, which vectors it has.
        """
        for primes in self._prime_sets():
            try:
                labels = self._labels(bases, members, primes)
            except _BadPrimeError:
                continue
            return self._group(labels, members)
        raise AssertionError("there are infinitely many primes")

    @cached_property
    def hadamard_bound(self) -> int:
        """A bound of the size of every minor, or of its norm: a product of lengths of rows."""
        squares = sorted((sum(_size(x) ** 2 for x in row) for row in self._vectors), reverse=True)
        bound: int = isqrt(prod(squares[: self.rank])) + 1
        return bound if self._field is None else bound**self._field.degree

    def _prime_sets(self) -> Iterator[list[int]]:
        """Yield sets of primes whose product exceeds the bound, each set new."""
        from sympy import nextprime, prevprime

        largest = isqrt((1 << _INT64_BITS) // self.rank)
        prime = nextprime(self.hadamard_bound) if self.hadamard_bound < largest else largest
        while prime < largest and not self._has_image(prime):
            prime = nextprime(prime)
        if prime < largest:
            yield [prime]
        bits = self.hadamard_bound.bit_length()
        # Of each prime, the residues of all entries, and the product of all primes so far.
        divisions = (self.count + 1) * bits / _BITS_A_STEP
        of_each = divisions + (_PRIME_STEPS if self._field is None else _FIELD_PRIME_STEPS)
        budget.check_cost(
            f"the minors of {self.count:,} planes, of up to {budget.about(bits)} bits",
            "round the entries",
            steps=bits / largest.bit_length() * of_each,
        )
        prime = largest
        while True:
            primes: list[int] = []
            product = 1
            while product <= self.hadamard_bound:
                check_time()
                prime = prevprime(prime)
                if self._has_image(prime):
                    primes.append(prime)
                    product *= prime
            yield primes

    def _has_image(self, prime: int) -> bool:
        return self._field is None or self._field.root_modulo(prime) is not None

    def _labels(self, bases: Integers, members: NDArray[np.bool_], primes: list[int]) -> Integers:
        """Return labels below 2^(63 - index bits), equal for parallel vectors beside a flat."""
        labels = np.zeros(members.shape, dtype=np.int64)
        radix = 1
        for prime in primes:
            check_time()
            images = self._quotients(bases, prime)
            for place, coordinate in enumerate(_normalise(images, members, prime)):
                size = prime if place else 2
                if radix * size >= 1 << (_INT64_BITS - self.index_bits):
                    labels, radix = _rank(labels), self.count
                labels = labels * size + coordinate
                radix *= size
        return labels

    def _quotients(self, bases: Integers, prime: int) -> Integers:
        """Return coordinates of the quotient by each basis: of each, a row of all vectors."""
        vectors = np.array(residues(self._vectors, prime), dtype=np.int64)
        count, rank = len(bases), self.rank
        forms = np.broadcast_to(np.eye(rank, dtype=np.int64), (count, rank, rank))
        rows = np.arange(count)
        for base in bases.T:
            values = _modulo((vectors[base][:, None, :] @ forms)[:, 0, :], prime)
            pivot = (values != 0).argmax(axis=1)
            # Where it is 0 all forms become 0, and `_normalise` refuses the prime.
            top = values[rows, pivot]
            others = np.arange(forms.shape[2] - 1)
            others = others + (others >= pivot[:, None])
            at_pivot = forms[rows, :, pivot][:, :, None]
            rest = np.take_along_axis(forms, others[:, None, :], axis=2)
            factors = np.take_along_axis(values, others, axis=1)[:, None, :]
            forms = _modulo(rest * top[:, None, None] - at_pivot * factors, prime)
        columns = forms.transpose(2, 0, 1).reshape(-1, rank)
        if rank * prime**2 < 1 << _DOUBLE_BITS:  # then sums of doubles are exact
            images = (columns.astype(np.float64) @ vectors.T.astype(np.float64)).astype(np.int64)
        else:
            images = columns @ vectors.T
        return _modulo(images, prime).reshape(-1, count, self.count)

    def _group(self, labels: Integers, members: NDArray[np.bool_]) -> Covers:
        """Group the vectors beside each flat by equal labels."""
        keys = labels << self.index_bits | np.arange(self.count)
        keys[members] = np.iinfo(np.int64).max
        keys.sort(axis=1)
        row, column = np.nonzero(keys != np.iinfo(np.int64).max)
        keys = keys[row, column]
        member = keys & ((1 << self.index_bits) - 1)
        keys >>= self.index_bits
        start = np.ones(len(keys), dtype=np.bool_)
        start[1:] = (keys[1:] != keys[:-1]) | (row[1:] != row[:-1])
        first = np.flatnonzero(start)
        added = np.diff(np.append(first, len(keys)))
        return Covers(row[first], member[first], added, np.cumsum(start) - 1, member)


def _size(x: Any) -> int:
    return abs(x) if isinstance(x, int) else x.size()


def _normalise(images: Integers, members: NDArray[np.bool_], prime: int) -> Iterator[Integers]:
    """Yield the coordinates of each vector scaled to begin with 1; the first one is 0 or 1."""
    lead = images[0].copy()
    for coordinate in images[1:]:
        np.copyto(lead, coordinate, where=lead == 0)
    if not (lead != 0)[~members].all():
        raise _BadPrimeError
    lead[members] = 1
    factors = _inverses(lead.ravel(), prime).reshape(lead.shape)
    for coordinate in images:
        yield _modulo(coordinate * factors, prime)


def _modulo(numbers: Integers, prime: int) -> Integers:
    """Return residues; dividing by a scalar is vectorised in numpy, its remainder is not."""
    return numbers - numbers // prime * prime


def _inverses(values: Integers, prime: int) -> Integers:
    """Return inverses modulo a prime, by three products for each (Montgomery's trick)."""
    if len(values) < 32:
        return np.array([pow(int(x), -1, prime) for x in values], dtype=np.int64)
    if len(values) % 2:
        values = np.append(values, 1)
        return _inverses(values, prime)[:-1]
    even, odd = values[0::2], values[1::2]
    product = _inverses(_modulo(even * odd, prime), prime)
    inverses = np.empty_like(values)
    inverses[0::2] = _modulo(product * odd, prime)
    inverses[1::2] = _modulo(product * even, prime)
    return inverses


def _rank(labels: Integers) -> Integers:
    """Return the place of each label among the different ones of its row."""
    order = labels.argsort(axis=1)
    ordered = np.take_along_axis(labels, order, axis=1)
    places = np.zeros_like(labels)
    np.cumsum(ordered[:, 1:] != ordered[:, :-1], axis=1, out=places[:, 1:])
    ranks = np.empty_like(labels)
    np.put_along_axis(ranks, order, places, axis=1)
    return ranks
