"""The answers to many grasps in float arrays: in floats with bounds of errors, else exact."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from arrangement.console.number_form import ReprMixin, counted
from arrangement.console.plugins import method_code
from arrangement.console.progress import watched
from arrangement.console.workers import part_numbers, run_parts
from arrangement.errors import OutOfReachError
from arrangement.hints import hints_on_arguments
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, from_floats
from arrangement.numbers.float_filter import Booleans, Floats
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.floats import from_float_data
from equilibrium.model.contact import VALUES
from equilibrium.model.grasp import Grasp

from .arrays import Arrays, near_floats, read_arrays
from .equilibria import have_equilibria
from .questions import ANGLE, questions
from .refutations import are_outside_cones, have_no_equilibria

#: Numbers in the matrices of questions that are screened at once.
_NUMBERS = 2**18
#: Cones of motions of a question that is not resisted, first few: an open one may have a solution.
_NODES = 200, 1500
#: Arrays of answers, by the names of `CheckedGrasps`.
ANSWERS = ("resisted", "screened", "exact", "undecided")
#: Where grasps are exactly: themselves, or in float arrays.
Source: TypeAlias = list[Grasp] | Arrays
#: A grasp by its number, and its open loads by theirs.
_Task: TypeAlias = tuple[int, Grasp | Arrays, list[tuple[int, RationalVector]]]


@dataclass(frozen=True, eq=False, repr=False)
class CheckedGrasps(ReprMixin):
    """The answers to up to w loads on each of G grasps, arrays (G, w) of truth values.

    Each question is screened, exact or undecided.

    Attributes:
        asked: where there is a load; all answers are false elsewhere.
        resisted: whether the load is proved to be resisted.
        screened: decided in floats, by a bound on their errors.
        exact: decided by `equilibrium.solve`, because floats were inconclusive.
        undecided: neither; not resisted then says nothing.
    """

    asked: Booleans
    resisted: Booleans
    screened: Booleans
    exact: Booleans
    undecided: Booleans
    _source: Source = field(repr=False)

    def __repr__(self) -> str:
        return f"<CheckedGrasps: {self.summary}>"

    @property
    def summary(self) -> str:
        """How many grasps and loads there are, and how many of each answer."""
        counts = ", ".join(f"{np.count_nonzero(getattr(self, name))} {name}" for name in ANSWERS)
        grasps, loads = self.resisted.shape
        many = f"{counted(loads, 'load')} each"
        if not self.asked.all():
            many = counted(int(np.count_nonzero(self.asked)), "load")
        return f"{counted(grasps, 'grasp')}, {many}: {counts}"

    def grasp(self, number: int) -> Grasp:
        """Return one of the grasps exactly, as the answers are about it; `solve` proves them."""
        return exact_grasp(self._source, range(len(self.resisted))[number])

    def closure_friction(self, tolerance: Any = Fraction(1, 1000)) -> Floats:
        """Return the least friction for force closure of each grasp, (G, 2): below, enough.

        It is a label of grasps in data sets: the same coefficient at all contacts, in space on
        round cones. Each end has a proof: see `equilibrium.methods.closure_friction`.

        Args:
            tolerance: the wanted length of each bracket.

        Returns:
            Floats rounded outwards: without closure up to the first, with it from the second on.
            Both are inf where no coefficient is enough, and the second where none was found.
        """
        grasps = list(map(self.grasp, range(len(self.resisted))))
        brackets: Floats = method_code("CheckedGrasps.closure_friction")(grasps, tolerance)
        return brackets


@hints_on_arguments({})
def check_grasps(
    points: Any,
    normals: Any,
    friction: Any,
    wrenches: Any,
    *,
    preload: Any = 0,
    stiffness: Any = 1,
    adhesion: Any = 0,
    jobs: int = 1,
    dask: str | None = None,
) -> CheckedGrasps:
    """Decide which of many grasps in float arrays resist their loads.

    The answers are about the binary fractions that the floats are, and about normals divided by
    their lengths: in place of one of irrational length stands a rational unit vector within 10^-12
    of it (tangent of the angle), see `CheckedGrasps.grasp`.

    "Resisted" and "not resisted" are proved in floats with a bound on their errors where that is
    possible: an equilibrium exists near one that was found, or virtual motions refute all, in space
    one for all motions. The rest is decided by `equilibrium.solve`, and all questions with
    adhesion.

    Args:
        points: (G, m, 2), in space (G, m, 3), of one grasp without G, contact points. A contact
            whose coordinates are all NaN is missing, whatever its other numbers are: so grasps may
            have different numbers of contacts.
        normals: like points, directions into the object, of any length but 0.
        friction, preload, stiffness, adhesion: (G, m), or what NumPy broadcasts to it: a number,
            one for each contact (m,), or one for each grasp (G, 1).
        wrenches: (G, w, 3), in space (G, w, 6), or (w, 3) and (w, 6) for the same loads on all.
        jobs: processes of this machine.
        dask: address of a Dask scheduler whose workers decide.

    Raises:
        GraspError: arrays of wrong shapes, of other than real numbers, or with numbers out of
            range.

    Complexity: about a millisecond for a screened question on three to eight contacts.

    >>> import numpy as np
    >>> points = np.array([[[-1, 0], [1, 0], [np.nan, np.nan]], [[-1, 0], [1, 0], [0, -1]]])
    >>> loads = [[0, -0.9, 0], [0, -1.1, 0]]
    >>> check_grasps(points, -points, 0.5, loads, preload=1).resisted.tolist()
    [[True, False], [True, True]]
    """
    data = friction, stiffness, preload, adhesion
    values = dict(zip(VALUES, data, strict=True))
    arrays = read_arrays(points, normals, values, wrenches)
    return check_as_written(arrays, None, jobs=jobs, dask=dask)


def check_as_written(
    source: Source,
    loads: Sequence[Sequence[RationalVector]] | None,
    *,
    jobs: int = 1,
    dask: str | None = None,
) -> CheckedGrasps:
    """Decide which grasps resist their loads, all in exact numbers that floats may round.

    As in `check_grasps`, the bounds on errors of floats include that of rounding to them.

    Args:
        source: grasps, or the arrays of `read_arrays`.
        loads: those of each grasp, which may be of different numbers; None: those of the arrays.
    """
    arrays: Any = source
    rounded = False
    if isinstance(source, list):
        arrays, rounded = near_floats(source, loads or [])
    elif loads is not None:
        empty = [Grasp()] * len(loads)
        (*_, wrenches), rounded = near_floats(empty, loads, source[0].shape[2])
        arrays = *source[:-1], wrenches
    shape = arrays[-1].shape[:2]
    screened, resisted, exact, undecided = (np.zeros(shape, dtype=bool) for _ in range(4))
    asked: Booleans = np.all(~np.isnan(arrays[-1]), axis=2)
    part_numbers(shape[0], (1, 1), jobs)
    # Those of as many contacts together: arrays are small then.
    present = ~np.isnan(arrays[0][..., 0])
    order = np.argsort(np.count_nonzero(present, axis=1), kind="stable")
    size = max(1, _NUMBERS // ((3 + present.shape[1]) ** 2 * max(shape[1], 1)))
    rows_of_batches = (order[k : k + size] for k in range(0, len(order), size))
    batches = [(rows, rounded, _part(arrays, rows)) for rows in rows_of_batches]
    parts = run_parts(_screened, None, batches, jobs, dask)
    for rows, holds, decided in watched(parts, "batches of grasps", len(batches)):
        resisted[rows], screened[rows] = holds, decided
    left = asked & ~screened
    tasks: list[_Task] = [
        (
            i,
            source[i] if isinstance(source, list) else _part(source, [i]),
            [
                (k, loads[i][k] if loads else from_floats(arrays[-1][i, k].tolist()))
                for k in np.flatnonzero(left[i]).tolist()
            ],
        )
        for i in np.flatnonzero(left.any(axis=1)).tolist()
    ]
    results = run_parts(_exactly, budget.times(), tasks, jobs, dask)
    for number, answers in watched(results, "grasps", len(tasks)):
        for load, answer in answers:
            (undecided if answer is None else exact)[number, load] = True
            resisted[number, load] = bool(answer)
    return CheckedGrasps(asked, resisted, screened, exact, undecided, source)


def _part(arrays: Arrays, rows: Any) -> Arrays:
    """Return the arrays of some grasps, with the contacts that there are in front."""
    missing = np.isnan(arrays[0][rows, :, 0])
    most = np.count_nonzero(~missing, axis=1).max(initial=0)
    at = np.asarray(rows)[:, None], np.argsort(missing, axis=1, kind="stable")[:, :most]
    return *(x[at] for x in arrays[:-1]), arrays[-1][rows]


def _screened(_: None, batch: tuple[Any, bool, Arrays]) -> tuple[Any, Booleans, Booleans]:
    """Return which questions on some grasps are resisted, as far as floats prove it, or not."""
    rows, rounded, (points, normals, *values, wrenches) = batch
    count, loads, size = wrenches.shape
    resisted, decided = (np.zeros(count * loads, dtype=bool) for _ in range(2))
    if points.shape[1] and loads:
        friction, stiffness, preload, adhesion = (np.repeat(x, loads, axis=0) for x in values)
        asked, usable = questions(
            np.repeat(points, loads, axis=0),
            np.repeat(normals, loads, axis=0),
            (friction, stiffness, preload),
            wrenches.reshape(-1, size),
            rounded,
        )
        # The wrench of adhesion is not known in floats exactly, as loads are.
        left = np.flatnonzero(usable & ~(adhesion > 0).any(axis=1))
        decided[left] = are_outside_cones(asked[left])
        left = left[~decided[left]]
        resisted[left] = have_equilibria(asked[left])
        for nodes in _NODES if size == 3 else ():
            left = left[~resisted[left]]
            refuted, motions = have_no_equilibria(asked[left], nodes)
            decided[left] = refuted
            left = left[~refuted]
            resisted[left] = have_equilibria(asked[left], motions[~refuted])
    shape = count, loads
    return rows, resisted.reshape(shape), (decided | resisted).reshape(shape)


def _exactly(times: float, task: _Task) -> tuple[int, list[tuple[int, bool | None]]]:
    """Return the number of a grasp, and its open loads with their answers; None: undecided."""
    number, source, loads = task
    grasp = source if isinstance(source, Grasp) else exact_grasp(source, 0)
    if not len(grasp):
        return number, [(k, not any(load)) for k, load in loads]
    answers: list[tuple[int, bool | None]] = []
    solver = Solver(grasp)
    with budget.limit(times):
        for k, load in loads:
            try:
                verdict = next(solver.solve_many([load]))
                answers.append((k, verdict.stable if verdict.decided else None))
            except OutOfReachError:
                answers.append((k, None))
    return number, answers


def exact_grasp(source: Source, number: int) -> Grasp:
    """Return one of the grasps; of arrays with a rational unit vector in place of each normal."""
    if isinstance(source, list):
        return source[number]
    rows = ~np.isnan(source[0][number, :, 0])
    points, normals, *values = (x[number, rows].tolist() for x in source[:-1])
    return from_float_data(
        points,
        normals,
        **dict(zip(VALUES, values, strict=True)),
        tolerance=0,
        angle_tolerance=ANGLE,
        as_given=True,
    ).grasp
