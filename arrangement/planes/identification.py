"""The isomorphism class of an arrangement, as `arrangement.library.census` identifies it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from arrangement.hints import HintsMixin


@dataclass(frozen=True)
class Identification(HintsMixin):
    """What is known of an arrangement's isomorphism class.

    Attributes:
        planes: the number m of distinct planes.
        rank: of the normals.
        type: the number of the type within m, from 1 on: type k is ``census(m)[k - 1]``. None
            for other ranks than 3 and beyond the census.
        f_vector: faces of each dimension.
        t_vector: t[k] points (lines through the origin) lie on k distinct planes; rank 3 only.
        automorphisms: how many relabellings with exchanges of sides keep the type, where
            exchanging all sides at once counts as nothing; None where type is.
        is_simple: the planes are in general position.
        is_simplicial: every region has as many facets as the rank.
        names: usual names of the type.
        finschi_fukuda: k, where the type is IC(m, 3, k) in the catalogue of Finschi and Fukuda.
        chirotope: the signs by which that catalogue represents the type, "" where type is None.
        order: plane p of the catalogue's representative is plane ``order[p]`` here.
        sides: and its normal is turned by ``sides[p]``.
        infinity: of planes that miss the origin, such as lines of R^2, which plane of the
            representative is at infinity, the first of its orbit. Their `type`, `names`,
            `finschi_fukuda`, `chirotope`, `order` and `sides` are those of the m + 1 planes of the
            cone, where infinity has the number of planes here.
    """

    planes: int
    rank: int
    type: int | None
    f_vector: tuple[int, ...]
    t_vector: Mapping[int, int]
    automorphisms: int | None
    is_simple: bool
    is_simplicial: bool
    names: tuple[str, ...]
    finschi_fukuda: int | None
    chirotope: str
    order: tuple[int, ...]
    sides: tuple[int, ...]
    infinity: int | None = None

    @property
    def label(self) -> str:
        """The isomorphism class in short, as ``6.13``, or "" where it is not in the census."""
        if self.type is None:
            return ""
        if self.infinity is None:
            return f"{self.planes}.{self.type}"
        if self.rank == 1:
            return f"{self.planes} parallel"
        return f"{self.planes + 1}.{self.type} with line {self.infinity + 1} at infinity"
