"""Many loads on one grasp: float arrays in, arrays of answers out, each of them proved.

All resisted wrenches are polyhedra, found exactly once. A load is screened against their facets in
floats, with the error bound of `float_filter`: a sum of four products, of a rounded and an exact
number each. Loads within this bound of a boundary are decided in fractions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from arrangement.console.number_form import ReprMixin, counted
from arrangement.console.progress import watched
from arrangement.numbers.exact import from_floats
from arrangement.numbers.float_filter import SMALLEST, Booleans, error_bound, scale_rows
from equilibrium.decide.many_grasps.arrays import exact_floats
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .separation import both_ways

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
    remedy = "ask `ResistedSet.solve_many`"
    loads = exact_floats(wrenches, "wrenches", "(n, 3) numbers", remedy)
    if loads.ndim != 2 or loads.shape[1] != 3 or not np.isfinite(loads).all():
        raise GraspError(
            f"wrenches is an array {loads.shape}; give (n, 3) finite numbers (f_x, f_y, tau)"
        )
    shapes = [piece.polyhedron for piece in whole.polyhedra]
    # The last one holds everywhere: a piece may have no facets.
    groups = [[*both_ways(x.inequalities, x.equalities), (0, 0, 0, 1)] for x in shapes]
    rows, usable = scale_rows([row for group in groups for row in group])
    starts = np.cumsum([0, *map(len, groups)])[:-1]
    # What floats cannot hold has no values, so that no comparison with them is certain.
    rows[~usable] = np.nan
    sizes = np.abs(loads)
    extreme = ((sizes < SMALLEST) & (sizes > 0)) | (sizes > 1 / SMALLEST)
    resisted, near_border = np.zeros((2, len(loads)), dtype=bool)
    size = max(1, _NUMBERS // (len(rows) + 1))
    parts = [slice(k, k + size) for k in range(0, len(loads) if shapes else 0, size)]
    for part in watched(parts, "batches of loads"):
        near = np.where(extreme[part], np.nan, loads[part])
        least = np.minimum.reduceat(rows[:, :3] @ near.T + rows[:, 3:], starts)
        # Entries of the rows are below 1, so the four products add up to less than this.
        errors = 4 * _ERROR * np.maximum(sizes[part].max(axis=1), 1.0)
        resisted[part] = (least >= errors).any(axis=0)
        possible = ~(least < -errors)
        near_border[part] = possible.any(axis=0) & ~resisted[part]
        for n in np.flatnonzero(near_border[part]).tolist():
            wrench, open_ones = from_floats(loads[part][n]), np.flatnonzero(possible[:, n])
            resisted[part.start + n] = any(shapes[j].contains(wrench) for j in open_ones)
    return CheckedLoads(whole.grasp, resisted, np.ones_like(resisted), near_border)
