"""Many loads on one grasp: float arrays in, arrays of answers out, each of them proved.

All resisted wrenches are polyhedra, found exactly once. A load is screened against their facets in
floats, with the error bound of `float_filter`: a sum of four products, of a rounded and an exact
number each. Loads within this bound of a border are decided in fractions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from arrangement.console.progress import watched
from arrangement.numbers.exact import IntegerVector, from_floats
from arrangement.numbers.float_filter import SMALLEST, Booleans, Floats, error_bound, scaled
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs import from_float_data
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

from .space import ResistedSet, resisted_set

#: Of a sum of four products: a rounded factor, the product, three sums.
_ERROR = error_bound(1 + 1 + 3)
#: Intervals of factors this close belong together.
_JOINED = 1e-9
#: A slope of 0, and what is too far out for a factor.
_TINY, _FAR = 1e-290, 1e200
#: Numbers of one array at once.
_NUMBERS = 500_000


@dataclass(frozen=True, eq=False)
class CheckedLoads:
    """The answers to n loads, for the grasp that the float data were rounded to.

    Attributes:
        grasp: this grasp, exact.
        resisted: (n,), whether each load is resisted.
        margin: (n,), factors in floats: of a resisted load the largest s with t times the load
            resisted for all t in [1, s], `inf` where none is too large; of another one the factor
            of a resisted load nearest to 1, `nan` where there is none.
        proved: (n,), true for all: by the bound on the errors of floats, or in fractions.
        near_border: (n,), which were decided in fractions, because floats could not tell.
    """

    grasp: Grasp
    resisted: Booleans
    margin: Floats
    proved: Booleans
    near_border: Booleans


def check_loads(
    points: Any,
    normals: Any,
    friction: Any,
    wrenches: Any,
    *,
    preload: Any = 0,
    stiffness: Any = 1,
) -> CheckedLoads:
    """Decide many loads on one planar grasp.

    Args:
        points, normals, friction, preload, stiffness: see `from_float_data`.
        wrenches: (n, 3) floats ``(f_x, f_y, tau)``, taken for the binary fractions that they are.

    Raises:
        GraspError: wrong shapes, values out of range, contacts in space.
        OutOfReachError: too many contacts for all resisted wrenches.

    >>> import numpy as np
    >>> normals = np.array([[1, 0], [0, 1], [-1, 0.0]])
    >>> points = -normals
    >>> found = check_loads(points, normals, 0.5, [[0, 0.5, 0], [0, 1, 0], [0, 1.5, 0]], preload=1)
    >>> found.resisted.tolist(), found.margin.tolist()
    ([True, True, False], [2.0, 1.0, 0.6666666666666666])
    """
    grasp = from_float_data(points, normals, friction, stiffness=stiffness, preload=preload).grasp
    grasp.require_plane()
    loads = np.asarray(wrenches, dtype=np.float64)
    if loads.ndim != 2 or loads.shape[1] != 3 or not np.isfinite(loads).all():
        raise GraspError(
            f"wrenches are an array {loads.shape}; give (n, 3) finite numbers (f_x, f_y, tau)"
        )
    solver = Solver(grasp)
    return _Facets(resisted_set(solver)).check(loads)


class _Facets:
    """The facets of all pieces: rows (F, 4) in floats, those of a piece from `starts` on.

    `usable` are the pieces whose rows floats can hold.
    """

    def __init__(self, found: ResistedSet) -> None:
        self.grasp, self.shapes = found.grasp, [piece.polyhedron for piece in found.pieces]
        rows: list[IntegerVector] = []
        starts = []
        for shape in self.shapes:
            starts.append(len(rows))
            # The last one holds everywhere: a piece may have no facets.
            rows += [*shape.inequalities, *shape.equalities]
            rows += [tuple(-x for x in row) for row in shape.equalities] + [(0, 0, 0, 1)]
        floats, usable = scaled(rows)
        self.rows, self.starts = floats.reshape(-1, 4), np.array(starts, dtype=np.intp)
        self.usable = np.logical_and.reduceat(usable, self.starts) if starts else usable

    def check(self, loads: Floats) -> CheckedLoads:
        """Return the answers to loads (n, 3)."""
        resisted, margin = np.zeros(len(loads), dtype=bool), np.full(len(loads), np.nan)
        near_border = resisted.copy()
        size = max(1, _NUMBERS // (len(self.rows) + 1))
        starts = range(0, len(loads) if self.shapes else 0, size)
        for part in watched([slice(k, k + size) for k in starts], "batches of loads"):
            resisted[part], margin[part], near_border[part] = self._part(loads[part])
        return CheckedLoads(self.grasp, resisted, margin, np.ones_like(resisted), near_border)

    def _part(self, loads: Floats) -> tuple[Booleans, Floats, Booleans]:
        slopes = self.rows[:, :3] @ loads.T
        least = np.minimum.reduceat(slopes + self.rows[:, 3:], self.starts)
        # Entries of the rows are below 1, so the four products add up to less than this.
        errors = 4 * _ERROR * np.maximum(np.abs(loads).max(axis=1), 1.0)
        tiny, huge = (np.abs(loads) < SMALLEST) & (loads != 0), np.abs(loads) > 1 / SMALLEST
        errors = np.where((tiny | huge).any(axis=1), np.inf, errors)
        inside: Booleans = (least >= errors) & self.usable[:, None]
        possible = (least >= -errors) | ~self.usable[:, None]
        resisted: Booleans = np.any(inside, axis=0)
        near_border: Booleans = np.any(possible, axis=0) & ~resisted
        for n in np.flatnonzero(near_border).tolist():
            wrench, near = from_floats(loads[n]), np.flatnonzero(possible[:, n]).tolist()
            resisted[n] = any(self.shapes[j].contains(wrench) for j in near)
        return resisted, self._margins(slopes, resisted), near_border

    def _margins(self, slopes: Floats, resisted: Booleans) -> Floats:
        """Return the factors; `slopes` are those of the rows along each load."""
        # Where a slope is 0, the end is far out on the side that says whether the row holds.
        slopes[slopes == 0] = _TINY
        ends = -self.rows[:, 3:] / slopes
        low = np.maximum.reduceat(np.where(slopes > 0, ends, 0.0), self.starts).clip(min=0.0)
        high = np.minimum.reduceat(np.where(slopes < 0, ends, np.inf), self.starts)
        low[low > _FAR] = np.inf
        there = low <= high * (1 + _JOINED)
        high = np.where(there, high, -np.inf)
        reached, before = np.ones(len(resisted)), np.zeros(len(resisted))
        while (reached > before).any():
            before = reached
            joined = low <= reached * (1 + _JOINED)
            reached = np.maximum(np.where(joined, high, 1.0).max(axis=0), reached)
        nearest = np.where(there, np.clip(1.0, low, np.maximum(high, low)), np.inf)
        chosen = np.abs(nearest - 1).argmin(axis=0)
        other = nearest[chosen, np.arange(len(chosen))]
        found: Floats = np.where(resisted, reached, np.where(np.isfinite(other), other, np.nan))
        return found
