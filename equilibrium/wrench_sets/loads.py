"""Many loads on one grasp: float arrays in, arrays of answers out, each of them proved.

All resisted wrenches are polyhedra, found exactly once. A load is screened against their facets in
floats, with the error bound of `float_filter`: a sum of four products, of a rounded and an exact
number each. Loads within this bound of a boundary are decided in fractions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.console.number_form import ReprMixin, counted
from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, from_floats
from arrangement.numbers.float_filter import SMALLEST, Booleans, Floats, error_bound, scale_rows
from equilibrium.decide.many_grasps.arrays import exact_floats
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .polyhedra import Piece

if TYPE_CHECKING:
    from .resisted_set import ResistedSet

#: Of a sum of four products: a rounded factor, the product, three sums.
_ERROR = error_bound(1 + 1 + 3)
#: Numbers of one array at once.
_NUMBERS = 500_000


@dataclass(frozen=True, eq=False, repr=False)
class CheckedLoads(ReprMixin):
    """The answers to n loads, for one exact grasp.

    Attributes:
        grasp: if it was converted from float data, the one that they were rounded to.
        resisted: (n,), whether each load is resisted.
        proved: (n,), true for all: by the bound on the errors of floats, or in fractions.
        near_border: (n,), which were decided in fractions, because floats were inconclusive.
    """

    grasp: Grasp
    resisted: Booleans
    proved: Booleans
    near_border: Booleans

    def __repr__(self) -> str:
        resisted, near = (np.count_nonzero(x) for x in (self.resisted, self.near_border))
        return (
            f"<CheckedLoads: {counted(len(self.resisted), 'load')}, {resisted} resisted, "
            f"{near} decided in fractions>"
        )


def check_loads(whole: ResistedSet, wrenches: Any) -> CheckedLoads:
    """Decide many loads on one planar grasp; see `ResistedSet.check`."""
    loads = _loads(wrenches)
    return _Facets(whole.grasp, whole.polyhedra).check(loads)


def _loads(wrenches: Any) -> Floats:
    """Return loads as floats that have their values exactly."""
    remedy = "ask `ResistedSet.solve_many`"
    loads = exact_floats(wrenches, "wrenches", "(n, 3) numbers", remedy)
    if loads.ndim != 2 or loads.shape[1] != 3 or not np.isfinite(loads).all():
        raise GraspError(
            f"wrenches is an array {loads.shape}; give (n, 3) finite numbers (f_x, f_y, tau)"
        )
    return loads


class _Facets:
    """The facets of all pieces: rows (F, 4) in floats, those of a piece from `starts` on.

    `usable` are the pieces whose rows floats can hold.
    """

    def __init__(self, grasp: Grasp, pieces: Sequence[Piece]) -> None:
        self.grasp, self.shapes = grasp, [piece.polyhedron for piece in pieces]
        rows: list[IntegerVector] = []
        starts = []
        for shape in self.shapes:
            starts.append(len(rows))
            # The last one holds everywhere: a piece may have no facets.
            rows += [*shape.inequalities, *shape.equalities]
            rows += [tuple(-x for x in row) for row in shape.equalities] + [(0, 0, 0, 1)]
        floats, usable = scale_rows(rows)
        self.rows, self.starts = floats.reshape(-1, 4), np.array(starts, dtype=np.intp)
        self.usable = np.logical_and.reduceat(usable, self.starts) if starts else usable

    def check(self, loads: Floats) -> CheckedLoads:
        """Return the answers to loads (n, 3)."""
        resisted = np.zeros(len(loads), dtype=bool)
        near_border = resisted.copy()
        size = max(1, _NUMBERS // (len(self.rows) + 1))
        starts = range(0, len(loads) if self.shapes else 0, size)
        for part in watched([slice(k, k + size) for k in starts], "batches of loads"):
            resisted[part], near_border[part] = self._part(loads[part])
        return CheckedLoads(self.grasp, resisted, np.ones_like(resisted), near_border)

    def _part(self, loads: Floats) -> tuple[Booleans, Booleans]:
        tiny, huge = (np.abs(loads) < SMALLEST) & (loads != 0), np.abs(loads) > 1 / SMALLEST
        extreme = (tiny | huge).any(axis=1)
        near = np.where(extreme[:, None], 0.0, loads)
        least = np.minimum.reduceat(self.rows[:, :3] @ near.T + self.rows[:, 3:], self.starts)
        # Entries of the rows are below 1, so the four products add up to less than this.
        errors = 4 * _ERROR * np.maximum(np.abs(near).max(axis=1), 1.0)
        errors[extreme] = np.inf
        inside: Booleans = (least >= errors) & self.usable[:, None]
        possible = (least >= -errors) | ~self.usable[:, None]
        resisted: Booleans = np.any(inside, axis=0)
        near_border: Booleans = np.any(possible, axis=0) & ~resisted
        for n in np.flatnonzero(near_border).tolist():
            wrench, open_ones = from_floats(loads[n]), np.flatnonzero(possible[:, n]).tolist()
            resisted[n] = any(self.shapes[j].contains(wrench) for j in open_ones)
        return resisted, near_border
