"""Linear automorphisms of a configuration of vectors, found by search and verified exactly.

With V the matrix whose rows are the vectors, ``G = V (V^T V)^-1 V^T`` is the projection onto the
columns of V. An invertible linear map takes every vector i to plus or minus vector p(i) exactly
when ``G[p(i), p(j)] = e_i e_j G[i, j]`` for signs e: both say that the signed permutation keeps the
space of columns. So V and every other basis have the same automorphisms, and G, an exact rational
matrix, is all that has to be compared. The images of r independent vectors determine the map.

Maps that scale vectors by other factors than plus or minus one are not looked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arrangement.counts.configuration import Configuration
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import largest, shown, work_factor
from arrangement.numbers.real import field_of
from arrangement.numbers.symbolic import exact_matrix, matrix_entries

if TYPE_CHECKING:
    from sympy.polys.matrices import DomainMatrix

    from arrangement.numbers.fields import NumberField

Permutations = NDArray[np.intp]
_Integers = NDArray[np.int64]
#: Partial images that a search may try; then a count goes on with the automorphisms found.
SEARCH_STEPS = 50_000


class Automorphisms:
    """The search for automorphisms of one configuration; infinity, if any, stays fixed.

    Args:
        config: its vectors, infinity last, are what is permuted.
    """

    def __init__(self, config: Configuration) -> None:
        infinity = [] if config.infinity is None else [config.infinity]
        rows = [*config.vectors, *infinity]
        self.size = len(rows)
        budget.check_cost(
            f"the symmetries of {self.size:,} planes of rank {config.rank}",
            "leave out planes",
            steps=(2 * self.size**2 + 20 * config.rank**2) * config.rank * work_factor(rows),
            bytes=60 * self.size**2,
        )
        matrix = exact_matrix(rows, config.rank)
        self._products = _numbered_products(matrix, field_of(x for row in rows for x in row))
        order = _connected_order(self._products, first=-len(infinity) % self.size)
        independent = matrix.extract(order, range(config.rank)).transpose().rref_den()[2]
        self._base = [order[i] for i in independent]
        self._fixed = len(infinity)
        generator = np.random.default_rng(0)
        self._factors = generator.integers(1, 2**62, config.rank) * 2 + 1
        weights = generator.integers(0, 2**62, int(np.abs(self._products).max()) + 1)
        self._kinds = weights[np.abs(self._products)].sum(axis=1)
        identity = [(plane, 1) for plane in self._base]
        self._keys = [self._key(identity[:depth]) for depth in range(config.rank + 1)]
        self._sorted = [np.sort(key) for key in self._keys]

    def generators(self, steps: int = SEARCH_STEPS) -> Permutations:
        """Return permutations that generate the group, or a part of it when the steps are used."""
        self._steps_left = steps
        permutations: list[Permutations] = []
        for level in range(len(self._base) - 1, self._fixed - 1, -1):
            tried = self._orbit(permutations, self._base[level])
            for plane in np.flatnonzero(self._keys[0] == self._keys[0][self._base[level]]):
                if tried[plane]:
                    continue
                if self._steps_left <= 0:
                    return self._stack(permutations)
                image = self._search([], level, int(plane))
                if image is None:
                    tried |= self._orbit(permutations, int(plane))
                else:
                    permutations.append(image)
                    tried |= self._orbit(permutations, self._base[level])
        return self._stack(permutations)

    def orbits(self, generators: Permutations) -> int:
        """Return the number of orbits of the vectors, infinity left out."""
        left = set(range(self.size - self._fixed))
        count = 0
        while left:
            left -= set(np.flatnonzero(self._orbit(list(generators), min(left))).tolist())
            count += 1
        return count

    def check_permutations(self, permutations: Sequence[Sequence[int]]) -> Permutations:
        """Return given permutations of the vectors, or refuse one that is not an automorphism."""
        checked = []
        for number, perm in enumerate(permutations):
            image = np.array([*perm, *range(len(perm), self.size)], dtype=np.intp)
            moved = self._products[np.ix_(image, image)]
            if not _equal_up_to_signs(moved, self._products):
                raise InputError(
                    f"symmetry[{number}] takes distinct planes to {shown(list(perm))}, which is "
                    "not an automorphism: no linear map takes each plane's normal to plus or minus "
                    "that of its image; leave it out, or leave out symmetry to have it found"
                )
            checked.append(image)
        return self._stack(checked)

    def _stack(self, generators: list[Permutations]) -> Permutations:
        return np.array(generators, dtype=np.intp).reshape(len(generators), self.size)

    def _orbit(self, generators: list[Permutations], plane: int) -> NDArray[np.bool_]:
        """Return which vectors the permutations can take one vector to."""
        reached = np.zeros(self.size, dtype=np.bool_)
        reached[plane] = True
        known = 0
        while known != (known := int(reached.sum())):
            for image in generators:
                reached[image[reached]] = True
        return reached

    def _products_with(
        self, path: Sequence[tuple[int, int]], rows: slice | NDArray[np.intp] = slice(None)
    ) -> _Integers:
        """Return the products of vectors with those of a path, times their signs."""
        columns = [plane for plane, _ in path]
        signs = np.array([sign for _, sign in path], dtype=np.int64)
        products: _Integers = self._products[rows][:, columns] * signs
        return products

    def _key(self, path: Sequence[tuple[int, int]]) -> _Integers:
        """Return a number for each vector, by its kind and its products with the path."""
        sums = self._products_with(path) @ self._factors[: len(path)]
        key: _Integers = np.abs(sums) ^ self._kinds
        return key

    def _search(self, path: list[tuple[int, int]], level: int, plane: int) -> Permutations | None:
        """Return an automorphism that fixes the base before `level` and takes it to `plane`."""
        depth = len(path)
        key = self._key(path)
        self._steps_left -= 1
        if not np.array_equal(np.sort(key), self._sorted[depth]) or self._steps_left <= 0:
            return None
        if depth == len(self._base):
            return self._complete(path, key)
        for step in self._steps(path, level, plane, key):
            path.append(step)
            image = self._search(path, level, plane)
            path.pop()
            if image is not None:
                return image
        return None

    def _steps(
        self, path: list[tuple[int, int]], level: int, plane: int, key: _Integers
    ) -> Iterator[tuple[int, int]]:
        """Yield images with signs of the next vector of the base that keep all products."""
        depth = len(path)
        source = self._base[depth]
        if depth > level:
            planes = np.flatnonzero(key == self._keys[depth][source])
        else:
            planes = np.array([source if depth < level else plane])
        products = self._products_with(path, planes)
        wanted = self._products[source, self._base[:depth]]
        for sign in (1, -1)[: 2 if path else 1]:
            for place in np.flatnonzero((products * sign == wanted).all(axis=1)):
                yield int(planes[place]), sign

    def _complete(self, path: list[tuple[int, int]], key: _Integers) -> Permutations | None:
        """Return the permutation that takes the base to the path, if it is an automorphism.

        The columns of G at the base span its columns, and those at the path lie among them. If a
        signed permutation of rows takes the first to the second, it keeps the space of columns.
        """
        image = np.empty(self.size, dtype=np.intp)
        image[np.argsort(self._keys[-1], kind="stable")] = np.argsort(key, kind="stable")
        moved = self._products_with(path, image)
        here = self._products[:, self._base]
        same = (moved == here).all(axis=1) | (moved == -here).all(axis=1)
        return image if same.all() else None


def _connected_order(products: _Integers, first: int) -> list[int]:
    """Return all vectors, each next to some earlier one of its component.

    Then each vector of the base but the first of a component has a product with an earlier one
    that is not 0, and a map that fixes the base up to signs fixes every vector up to its sign.
    """
    order: dict[int, None] = {}
    for start in (first, *range(len(products))):
        waiting = [start]
        while waiting:
            vector = waiting.pop()
            if vector not in order:
                order[vector] = None
                waiting.extend(np.flatnonzero(products[vector])[::-1].tolist())
    return list(order)


def _numbered_products(matrix: DomainMatrix, field: NumberField | None) -> _Integers:
    """Return G with its entries numbered: 0 stays 0, opposite entries have opposite numbers."""
    inverse, _ = (matrix.transpose() * matrix).inv_den()
    rows, middle = (
        np.array(matrix_entries(part.to_list(), field), dtype=object) for part in (matrix, inverse)
    )
    products = rows @ middle @ rows.T
    if largest([products.flat]) < 2**62:
        products = products.astype(np.int64)
    sizes, numbers = np.unique(np.abs(products), return_inverse=True)
    numbers = numbers.reshape(products.shape) + (sizes[0] != 0)
    signed: _Integers = np.where(products < 0, -numbers, numbers).astype(np.int64)
    return signed


def _equal_up_to_signs(left: _Integers, right: _Integers) -> bool:
    """Return whether ``left[i, j] = e_i e_j right[i, j]`` for some signs e."""
    if not np.array_equal(np.abs(left), np.abs(right)):
        return False
    signs = np.zeros(len(left), dtype=np.int64)
    relation = np.sign(left) * np.sign(right)
    for first in range(len(left)):
        if signs[first] == 0:
            signs[first] = 1
            waiting = [first]
            while waiting:
                row = waiting.pop()
                new = (relation[row] != 0) & (signs == 0)
                signs[new] = signs[row] * relation[row, new]
                waiting.extend(np.flatnonzero(new).tolist())
    return bool(((relation == 0) | (relation == signs[:, None] * signs)).all())
