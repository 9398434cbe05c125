"""The answers to many grasps in float arrays: in floats with bounds of errors, else exact."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from arrangement.console.number_form import ReprMixin, counted
from arrangement.console.progress import watched
from arrangement.console.workers import done, due
from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.numbers.exact import from_floats
from arrangement.numbers.float_filter import Booleans
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.floats import from_float_data
from equilibrium.model.grasp import Grasp

from .arrays import Arrays, read_arrays
from .equilibria import have_equilibria
from .questions import ANGLES, questions
from .refutations import have_no_equilibria

#: Numbers in the matrices of questions that are screened at once.
_NUMBERS = 2**18
#: Cones of motions of a question that is not resisted, first few: an open one may have a solution.
_NODES = 200, 1500


@dataclass(frozen=True, eq=False, repr=False)
class CheckedGrasps(ReprMixin):
    """The answers to w loads on each of G grasps, arrays (G, w) of truth values.

    Each question is screened, exact or undecided.

    Attributes:
        resisted: whether the load is proved to be resisted.
        screened: decided in floats, by a bound on their errors.
        exact: decided by `equilibrium.solve`, because floats were inconclusive.
        undecided: neither; not resisted then says nothing.
    """

    resisted: Booleans
    screened: Booleans
    exact: Booleans
    undecided: Booleans
    _arrays: Arrays = field(repr=False)

    def __repr__(self) -> str:
        names = "resisted", "screened", "exact", "undecided"
        counts = ", ".join(f"{np.count_nonzero(getattr(self, name))} {name}" for name in names)
        grasps, loads = self.resisted.shape
        return (
            f"<CheckedGrasps: {counted(grasps, 'grasp')}, {counted(loads, 'load')} each: {counts}>"
        )

    def grasp(self, number: int) -> Grasp:
        """Return one of the grasps exactly, as the answers are about it; `solve` proves them."""
        return _grasp(self._arrays, range(len(self.resisted))[number])


def check_grasps(
    points: Any,
    normals: Any,
    friction: Any,
    wrenches: Any,
    *,
    preload: Any = 0,
    stiffness: Any = 1,
    jobs: int = 1,
) -> CheckedGrasps:
    """Decide which of many grasps in float arrays resist their loads.

    The answers are about the binary fractions that the floats are, and about normals divided by
    their lengths: in place of one of irrational length stands a rational unit vector, in the plane
    within 10^-12, in space within 10^-6 of it (tangent of the angle), see `CheckedGrasps.grasp`.

    In the plane "resisted" and "not resisted" are proved in floats with a bound on their errors
    where that is possible: an equilibrium exists near one that was found, or virtual motions refute
    all. The rest, and in space every question, is decided by `equilibrium.solve`.

    Args:
        points: (G, m, 2), in space (G, m, 3), contact points. A contact whose coordinates are all
            NaN is missing, whatever its other numbers are: so grasps may have different numbers
            of contacts.
        normals: like points, directions into the object, of any length but 0.
        friction, preload, stiffness: (G, m), or what NumPy broadcasts to it: a number, one for
            each contact (m,), or one for each grasp (G, 1).
        wrenches: (G, w, 3), in space (G, w, 6), or (w, 3) and (w, 6) for the same loads on all.
        jobs: processes of this machine for what is decided exactly.

    Raises:
        GraspError: arrays of wrong shapes, of other than real numbers, or with numbers out of
            range.

    Complexity: about two milliseconds for a screened question on three to eight contacts.

    >>> import numpy as np
    >>> points = np.array([[[-1, 0], [1, 0], [np.nan, np.nan]], [[-1, 0], [1, 0], [0, -1]]])
    >>> loads = [[0, -0.9, 0], [0, -1.1, 0]]
    >>> check_grasps(points, -points, 0.5, loads, preload=1).resisted.tolist()
    [[True, False], [True, True]]
    """
    arrays = read_arrays(points, normals, friction, stiffness, preload, wrenches)
    shape = arrays[-1].shape[:2]
    resisted, decided = (np.zeros(shape, dtype=bool).reshape(-1) for _ in range(2))
    due(len(resisted), (1, 1), jobs)
    most, dimension = arrays[0].shape[1:]
    if dimension == 2 and most:
        size = max(1, _NUMBERS // (3 + most) ** 2)
        starts = range(0, len(resisted), size)
        # Those of as many contacts together: arrays are small then.
        contacts = np.count_nonzero(~np.isnan(arrays[0][..., 0]), axis=1)
        order = np.argsort(np.repeat(contacts, shape[1]), kind="stable")
        for part in watched([order[k : k + size] for k in starts], "batches of questions"):
            resisted[part], decided[part] = _screened(arrays, part)
    screened, held = decided.reshape(shape), resisted.reshape(shape)
    exact, undecided = np.zeros(shape, dtype=bool), np.zeros(shape, dtype=bool)
    plan = arrays, screened, budget.times()
    rest = np.flatnonzero(~screened.all(axis=1)).tolist()
    for number, answers in watched(done(_exactly, plan, rest, jobs), "grasps", len(rest)):
        for load, answer in answers:
            (undecided if answer is None else exact)[number, load] = True
            held[number, load] = bool(answer)
    return CheckedGrasps(held, screened, exact, undecided, arrays)


def _screened(arrays: Arrays, numbers: Any) -> tuple[Booleans, Booleans]:
    """Return which questions are resisted, as far as floats prove it, and which are decided."""
    points, normals, *values, wrenches = arrays
    grasp, load = np.divmod(numbers, wrenches.shape[1])
    missing = np.isnan(points[grasp, :, 0])
    most = max(1, np.count_nonzero(~missing, axis=1).max())
    at = grasp[:, None], np.argsort(missing, axis=1, kind="stable")[:, :most]
    friction, stiffness, preload = (x[at] for x in values)
    asked, usable = questions(
        points[at], normals[at], (friction, stiffness, preload), wrenches[grasp, load]
    )
    resisted, decided = np.zeros(len(numbers), dtype=bool), np.zeros(len(numbers), dtype=bool)
    rows = np.flatnonzero(usable)
    resisted[rows] = have_equilibria(asked.take(rows))
    for nodes in _NODES:
        rows = rows[~resisted[rows]]
        refuted, motions = have_no_equilibria(asked.take(rows), nodes)
        decided[rows] = refuted
        rows = rows[~refuted]
        resisted[rows] = have_equilibria(asked.take(rows), motions[~refuted])
    return resisted, decided | resisted


def _exactly(
    plan: tuple[Arrays, Booleans, float], number: int
) -> tuple[int, list[tuple[int, bool | None]]]:
    """Return the number of a grasp, and its open loads with their answers; None: undecided."""
    arrays, screened, times = plan
    loads = arrays[-1][number]
    answers: list[tuple[int, bool | None]] = []
    if np.isnan(arrays[0][number]).all():
        return number, [
            (k, not any(load)) for k, load in enumerate(loads) if not screened[number, k]
        ]
    solver = Solver(_grasp(arrays, number))
    with budget.limit(times):
        for load in np.flatnonzero(~screened[number]).tolist():
            try:
                wrench = from_floats(loads[load])
                verdict = next(solver.solve_many([wrench]))
                answers.append((load, verdict.stable if verdict.decided else None))
            except OutOfReachError:
                answers.append((load, None))
    return number, answers


def _grasp(arrays: Arrays, number: int) -> Grasp:
    rows = ~np.isnan(arrays[0][number, :, 0])
    points, normals, friction, stiffness, preload = (x[number, rows].tolist() for x in arrays[:5])
    angle = ANGLES[arrays[0].shape[2]]
    return from_float_data(
        points,
        normals,
        friction,
        stiffness=stiffness,
        preload=preload,
        tolerance=0,
        angle_tolerance=angle,
        as_given=True,
    ).grasp
