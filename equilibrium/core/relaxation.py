"""The convex relaxation of a node of the tree in space, solved as a conic program in floats.

Unknowns are the motion and a force at each contact. The law, by the state of a contact, is read off
`equilibrium.core.contact_law`, but for round cones of friction, which are not linear.

Where nothing satisfies it together with balance, the dual ray has a virtual motion and multipliers:
a leaf. Otherwise its solution says which contact to split.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np

from arrangement.errors import extra
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.core.contacts import FloatContacts, nearest

from .cones import Cones, RoundCones, State, lengths
from .contact_law import LinearQuestion
from .continuation import Continuation
from .float_law import FloatLaw

with extra("space"):
    import clarabel

#: Steps of an iteration of friction limits; walls of 85 bricks take 8.
_MAX_LIMIT_STEPS = 25
#: Change of a limit, as a share of the load, at which the limits are a fixed point.
_FIXED_LIMIT = 1e-7
#: The first limit of every contact, as a multiple of the load.
_FIRST_LIMIT = 10.0
#: The weighted motion is what forces leave of the load: with more they do not balance it.
_UNBALANCED = 1e-5
#: Error that ends the program of given limits.
_LIMIT_PROGRAM_ERROR = 1e-11
#: Weight of the square of the motion beside the energy of springs: it decides what balance leaves.
_ENERGY_MOTION_WEIGHT = 1e-9
#: Weight of the square of the motion beside the forces, in scaled units.
_MOTION_WEIGHT = 1e-3
#: Where no ray has more room than minus this, there is none.
_ROOM_ERROR = 1e-6
#: Frictions above this, or stiffnesses further apart, are uneven.
_EVEN_RATIO = 100.0
#: Whether a contact touches is asked before how it slips, by this factor.
_LIFT_WEIGHT = 3.0
#: Motions of a grasp have up to so many coordinates, those of several bodies more.
_MAX_GRASP = 6
#: Programs of unlike shapes that are kept to be changed in place, each of some 100 kB.
_MAX_LAYOUTS = 256
#: Shapes of programs that all grasps share, each of some 5 kB.
_MAX_SHARED_LAYOUTS = 1024
#: Rows of contacts in states that are kept, each of some 3 kB.
_MAX_BLOCKS = 4096
_CLARABEL_CONES = {
    "zero": clarabel.ZeroConeT,
    "plus": clarabel.NonnegativeConeT,
    "round": clarabel.SecondOrderConeT,
}


class Ray(NamedTuple):
    """A dual ray: there is no solution.

    Attributes:
        virtual: (n,) virtual motion.
        multipliers: (m, 2 f), alpha and h, then those of bounded displacements; f is one more
            than the tangents.
        room: (m, 2 f), how far each multiplier may be changed.
        sizes: (m, 2 f), of the multipliers beside the virtual motion.
    """

    virtual: Floats
    multipliers: Floats
    room: Floats
    sizes: Floats


class Point(NamedTuple):
    """A solution of the relaxation, in scaled units: motion (n,) and forces (m, f)."""

    motion: Floats
    forces: Floats


class _ConeShape(NamedTuple):
    """What blocks have in common whose programs differ in numbers alone.

    Attributes:
        size: how many rows, and how many unknown forces.
        rows, columns: of coefficients, in a table with balance above the rows of the block and the
            motion left of the forces.
        cones: of the rows, with their sizes.
        cost: of the normal force.
    """

    size: tuple[int, int]
    rows: tuple[int, ...]
    columns: tuple[int, ...]
    cones: tuple[tuple[str, int], ...]
    cost: float


class _Block(NamedTuple):
    """The rows of one contact in one state: minus what they give, and `right`, is in the cones.

    Attributes:
        shape: its number.
        data: coefficients, in the order of the shape.
        forces: (f, unknown forces), shares of these in all forces.
        dual: (2 f, rows), what multipliers of the rows are of alpha, h and displacements.
        room: (rows,), where there has to be room in a leaf.
        ends: (k, tangents), unit vectors at the ends of the directions of slip.
    """

    shape: int
    data: Floats
    forces: Floats
    right: Floats
    dual: Floats
    room: Floats
    ends: Floats


class Columns(NamedTuple):
    """A sparse matrix by columns, what Clarabel reads of SciPy's, which is slow to load."""

    data: Floats
    indices: Any
    indptr: Any
    shape: tuple[int, int]
    has_canonical_format: bool = True

    @classmethod
    def of(cls, table: Floats) -> Columns:
        """Return a matrix without its zeros."""
        column, row = np.nonzero(table.T)
        counts = np.bincount(column, minlength=table.shape[1])
        return cls(table[row, column], row, np.append(0, np.cumsum(counts)), table.shape)

    def table(self) -> Floats:
        """Return the matrix with its zeros."""
        table = np.zeros(self.shape)
        column = np.repeat(np.arange(self.shape[1]), np.diff(self.indptr))
        table[self.indices, column] = self.data
        return table


class _ConeLayout:
    """Programs that differ in numbers alone, of blocks of certain shapes.

    Attributes:
        starts: where the rows of each block begin, and the last ends; those of balance come first.
        order: of the coefficients, block after block, by columns.
        solver: of the last one, to be changed in place.
    """

    def __init__(self, n: int, *shapes: _ConeShape) -> None:
        sizes = np.cumsum([(n, n), *(shape.size for shape in shapes)], axis=0)
        self.starts, firsts = sizes.T.tolist()
        self.shape = self.starts[-1], firsts[-1]
        places = [np.array([shape.rows, shape.columns]).T for shape in shapes]
        moved = [x + (x >= n) * (begin - n) for x, begin in zip(places, sizes, strict=False)]
        row, column = np.concatenate([np.empty((0, 2), dtype=int), *moved]).T
        self.order = np.lexsort((row, column))
        self.indices = row[self.order]
        self.pointer = np.append(0, np.cumsum(np.bincount(column, minlength=firsts[-1])))
        cones = (cone for shape in shapes for cone in shape.cones)
        self.kinds = [clarabel.ZeroConeT(n), *(_CLARABEL_CONES[kind](k) for kind, k in cones)]
        self.cost = np.zeros(firsts[-1])
        for first, shape in zip(firsts, shapes, strict=False):
            self.cost[first : first + 1] = shape.cost
        self.solver: Any = None


_cone_layout = lru_cache(_MAX_SHARED_LAYOUTS)(_ConeLayout)


class _ConeProgram(NamedTuple):
    """The program of one node.

    Attributes:
        order: contacts in the order of their blocks: like ones come together.
    """

    order: list[int]
    blocks: list[_Block]
    layout: _ConeLayout
    matrix: Columns
    right: Floats

    @property
    def parts(self) -> Iterator[tuple[int, _Block, int, int]]:
        """Contacts, their blocks, and where their rows begin and end."""
        starts = self.layout.starts
        return zip(self.order, self.blocks, starts, starts[1:], strict=False)


class Programs:
    """The rows and layouts of the programs of one grasp, which loads share.

    Attributes:
        block: the rows of a contact in a state, by the units of stiffness and preload and the
            largest displacement.
        layout: of a program, by the numbers of its shapes, and the time limit of its solver.
    """

    def __init__(self, contacts: FloatContacts, cones: Cones, is_bounded: bool) -> None:
        c, arms = contacts, contacts.arms(1 / contacts.length)
        self._cones, self._n = cones, c.rows.n
        self._frames = np.concatenate([c.normal[:, None], c.tangents], axis=1) * arms
        springs = FloatLaw(*c.in_units(arms, 1.0, 1.0)).spring
        # Its loads do not matter, and displacements are counted in the largest one.
        self._question = LinearQuestion(
            c.rows,
            (Fraction(0),) * c.rows.n,
            max_displacement=Fraction(1) if is_bounded else None,
            keeps_normal=True,
        )
        m, f, n = self._frames.shape
        #: Which coordinates of a motion each contact acts on.
        self._acts = (self._frames != 0).any(axis=1) | (n <= _MAX_GRASP)
        #: Springs, slips and displacements as symbols, and their values, those of a constant last.
        self._symbols = [
            [("spring", i), *(("slip", i, j) for j in range(f - 1))]
            + [("displacement", i, j) for j in range(f)]
            for i in range(m)
        ]
        self._values = np.zeros((m, 2 * f + 1, n + 1))
        self._values[:, 0] = np.roll(springs, -1, axis=1)
        self._values[:, 1:-1, :n] = np.concatenate([self._frames[:, 1:], self._frames], axis=1)
        self._numbers: dict[_ConeShape, int] = {}
        self.block = lru_cache(_MAX_BLOCKS)(self._new_block)
        self.layout = lru_cache(_MAX_LAYOUTS)(self._new_layout)

    def _conditions(self, i: int, state: State) -> tuple[Floats, Floats, int, int]:
        """Return the law of a contact in a state as numbers.

        Returns:
            Forces by those that are unknown; conditions, by these and by symbols, -1 last; of the
            conditions how many are equations, these come first, and how many are a round cone.
        """
        friction, f = self._question.rows[i].friction, self._frames.shape[1]
        law = self._question.law(i, self._cones.in_conditions(friction, state))
        count = len(law.unknowns)
        in_round = isinstance(self._cones, RoundCones) and count == f
        # A cone allows no pull: beside it that is not a condition of its own.
        least = [x.terms for x in law.least if count < f or x.terms != {law.unknowns[0]: 1}]
        rows = [*law.forces, *(x.terms for x in law.equal), *least]
        at = {key: k for k, key in enumerate((*law.unknowns, *self._symbols[i], -1))}
        table = np.zeros((len(rows) + f * in_round, len(at)))
        for row, terms in enumerate(rows):
            for key, x in terms.items():
                table[row, at[key]] = nearest(x)
        forces, table = table[:f, :count], table[f:]
        if in_round:
            table[-f:, :f] = forces * [[nearest(friction)], *[[1.0]] * (f - 1)]
        return forces, table, len(law.equal), f * in_round

    def _new_block(
        self, i: int, state: State, hardness: float, pressure: float, most: float
    ) -> _Block:
        forces, table, equations, in_round = self._conditions(i, state)
        frame, acts, plain = self._frames[i], self._acts[i], len(table) - in_round
        (f, n), count = frame.shape, forces.shape[1]
        ends = np.array(self._cones.ends(state), dtype=float).reshape(-1, f - 1)
        if len(ends):
            # Directions of slip have integers of any size.
            ends /= lengths(ends)[:, None]
            moved = ~table[:, :count].any(axis=1)
            table[moved] /= np.abs(table[moved]).max(axis=1, keepdims=True)
        values = self._values[i].copy()
        values[0] *= [*[hardness] * n, pressure]
        values[-1, -1] = most
        given = table[:, count:] @ values
        # Inside a leaf there is room in a round cone, else where forces alone obey a condition.
        room = np.zeros(len(table))
        room[plain : plain + 1] = 1.0
        if not in_round:
            room[equations:] = ~table[equations:, count:].any(axis=1)
        # Balance above the conditions, the motion left of the forces.
        whole = np.zeros((n + len(table), n + count))
        whole[:n, n:] = (forces.T @ frame).T
        whole[n:, :n], whole[n:, n:] = given[:, :n], table[:, :count]
        # Some zeros are kept, with which the shapes of all contacts are alike; but a contact of
        # many bodies acts on two of them.
        kept = whole != 0
        kept[:n, n:] |= acts[:, None]
        kept[n:, :n] = np.outer(kept[n:, :n].any(axis=1), acts)
        rows, columns = np.nonzero(kept)
        cones = ("zero", equations), ("plus", plain - equations), ("round", in_round)
        shape = _ConeShape(
            (len(table), count),
            tuple(rows.tolist()),
            tuple(columns.tolist()),
            tuple((kind, size) for kind, size in cones if size),
            float(state in ("undecided", "loose")),
        )
        return _Block(
            self._numbers.setdefault(shape, len(self._numbers)),
            -whole[kept],
            forces,
            given[:, n],
            -table[:, count:-1].T,
            room,
            ends,
        )

    def _new_layout(self, shapes: tuple[int, ...], _: float) -> _ConeLayout:
        # Layouts have no numbers of a grasp, so all grasps share them.
        listed = list(self._numbers)
        return copy(_cone_layout(self._n, *[listed[k] for k in shapes]))


class Relaxation(FloatLaw):
    """All relaxations of one question, in scaled units.

    Attributes:
        scale: of the coordinates of a motion.
        smooth: the smoothed balance.
    """

    @np.errstate(all="ignore")  # what is beyond floats is infinite here, and proves nothing
    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        cones: Cones,
        max_displacement: Fraction | None = None,
        programs: Programs | None = None,
    ) -> None:
        c, smooth = contacts, Continuation(contacts, wrench, cones)
        self.contacts, self.m, self.cones = c, len(c.rows), cones
        self.n, self.frame = c.rows.n, 1 + c.rows.tangents
        self.arms = c.arms(1 / c.length)
        self.smooth = smooth
        self.force, self.step = smooth.size or 1.0, float(smooth.scale[0])
        self.scale = self.step * self.arms
        self.load = smooth.load * self.arms / self.force
        super().__init__(*c.in_units(self.arms, self.force, self.step))
        most = max_displacement
        self.most = 0.0 if most is None else nearest(most) / self.step
        self.settings = _settings()
        # Refined steps take a third of the time, and matter only where sizes are far apart.
        spread = self.stiffness.max(initial=0.0) / self.stiffness.min(initial=np.inf)
        uneven = max(spread, c.friction.max(initial=0.0)) > _EVEN_RATIO
        self.settings.iterative_refinement_enable = bool(uneven)
        self._programs = programs or Programs(c, cones, most is not None)
        pressure = 1 / self.force if c.preload.any() else 0.0
        self._units = float(self.step / self.force), float(pressure), float(self.most)

    def _program(self, states: Sequence[State]) -> _ConeProgram:
        block, units = self._programs.block, self._units
        every = [block(i, state, *units) for i, state in enumerate(states)]
        order = sorted(range(self.m), key=lambda i: every[i].shape)
        blocks = [every[i] for i in order]
        shapes = tuple([block.shape for block in blocks])
        layout = self._programs.layout(shapes, self.settings.time_limit)
        data = np.concatenate([block.data for block in blocks] or [np.zeros(0)])[layout.order]
        right = np.concatenate([self.load, *(block.right for block in blocks)])
        matrix = Columns(data, layout.indices, layout.pointer, layout.shape)
        return _ConeProgram(order, blocks, layout, matrix, right)

    def solve(self, states: Sequence[State]) -> Ray | Point | None:
        """Return a ray or a point for one node; None where the program solver fails."""
        program = self._program(states)
        layout, matrix, right = program.layout, program.matrix, program.right
        if layout.solver is None:
            squares = _squares(matrix.shape[1], self.n)
            question = squares, layout.cost, matrix, right, layout.kinds, self.settings
            layout.solver = clarabel.DefaultSolver(*question)
        else:
            layout.solver.update(A=matrix.data, b=right)
        solved = layout.solver.solve()
        status = str(solved.status)
        if status in ("PrimalInfeasible", "AlmostPrimalInfeasible"):
            return self._ray(states, program, np.array(solved.z))
        if status not in ("Solved", "AlmostSolved"):
            return None
        return self._point(program, np.array(solved.x))

    def first(self, states: Sequence[State], change: Floats) -> tuple[float, Point] | None:
        """Return the least share of a change of the load, up to 1, with a point, if any has one."""
        node = self._program(states)
        matrix, right = node.matrix, node.right
        rows, n = matrix.shape
        data: list[Any] = [matrix.data, -change * self.arms / self.force, [-1.0, 1.0]]
        index = [matrix.indices, np.arange(self.n), [rows, rows + 1]]
        pointer = np.append(matrix.indptr, matrix.indptr[-1] + self.n + 2)
        whole = Columns(np.concatenate(data), np.concatenate(index), pointer, (rows + 2, n + 1))
        ends, kinds = (
            np.append(right, [0.0, 1.0]),
            [*node.layout.kinds, clarabel.NonnegativeConeT(2)],
        )
        program = _squares(n + 1, self.n, 0.0), np.append(np.zeros(n), 1.0), whole, ends, kinds
        solved = clarabel.DefaultSolver(*program, self.settings).solve()
        if str(solved.status) not in ("Solved", "AlmostSolved"):
            return None
        return float(solved.x[-1]), self._point(node, np.array(solved.x))

    def _point(self, program: _ConeProgram, solution: Floats) -> Point:
        """Return the motion, and all forces of each contact, of the unknowns."""
        forces, j = np.zeros((self.m, self.frame)), self.n
        for i, block in zip(program.order, program.blocks, strict=True):
            start, j = j, j + block.forces.shape[1]
            forces[i] = block.forces @ solution[start:j]
        return Point(solution[: self.n], forces)

    def _ray(self, states: Sequence[State], program: _ConeProgram, dual: Floats) -> Ray:
        """Read a virtual motion and multipliers off a dual ray, in the units of the grasp."""
        virtual, f = -dual[: self.n], self.frame
        multipliers, room = np.zeros((2, self.m, 2 * f))
        for i, block, start, end in program.parts:
            multipliers[i] = block.dual @ dual[start:end]
        slips = self.slips(virtual)
        most = self.cones.support(slips)
        for i, block in zip(program.order, program.blocks, strict=True):
            if len(block.ends):
                most[i] = self.cones.largest(states[i], slips[i].tolist())
                room[i, 1:f] = min((-block.ends @ multipliers[i, 1:f]).tolist())
        alphas = multipliers[:, 0].tolist()
        slacks = (self.least_works(virtual, most) - multipliers[:, 0]).tolist()
        for i, (state, alpha, slack) in enumerate(zip(states, alphas, slacks, strict=True)):
            room[i, 0] = alpha if state == "detached" else slack
            if state == "undecided":
                room[i, 0] = min(alpha, slack)
            elif state == "stick":
                room[i, 1:f] = np.inf
        room[:, f:] = np.inf
        sizes = np.abs(multipliers) / max(float(np.abs(virtual).max()), 1e-300)
        units = np.array([1.0, *[self.force / self.step] * (2 * f - 1)])
        return Ray(virtual * self.arms, multipliers * units, room, sizes)

    def inner_ray(self, states: Sequence[State], room: float = 1.0) -> Ray | None:
        """Return the ray with the most work, and room in the cones, if any has some.

        Unknowns are the multipliers of all rows and the room, of which `room` is a part in cones.
        Of states that are all loose it needs no springs, and sees loads tiny beside preloads.
        """
        program = self._program(states)
        matrix, right = program.matrix, program.right
        right = right / (np.abs(right).max() or 1.0)
        rows, columns = matrix.shape
        inside = np.zeros(rows)
        for _, block, start, end in program.parts:
            inside[start:end] = room * block.room
        last = np.append(np.zeros(rows), 1.0)
        n = self.n
        bounds = np.eye(rows + 1)[[*range(n), rows]]
        table = np.concatenate(
            [
                np.column_stack([matrix.table().T, np.zeros(columns)]),
                [np.append(right, 1.0)],
                bounds,
                -bounds[:n],
                np.column_stack([-np.eye(rows)[n:], inside[n:]]),
            ]
        )
        ends = np.concatenate([np.zeros(columns + 1), np.ones(2 * n + 1), np.zeros(rows - n)])
        kept = [clarabel.ZeroConeT(columns), clarabel.NonnegativeConeT(2 * n + 2)]
        free, k = [], columns + 2 * n + 2
        for kind in program.layout.kinds[1:]:
            # Multipliers of equations are free.
            free += [*range(k, k + kind.dim)] if isinstance(kind, clarabel.ZeroConeT) else []
            kept += [] if isinstance(kind, clarabel.ZeroConeT) else [kind]
            k += kind.dim
        table, ends = np.delete(table, free, axis=0), np.delete(ends, free)
        question = (_squares(rows + 1, n, 0.0), -last, Columns.of(table), ends, kept)
        rays = np.array(clarabel.DefaultSolver(*question, self.settings).solve().x)
        return self._ray(states, program, rays[:-1]) if rays[-1] > -_ROOM_ERROR else None

    def at_fixed_limits(self) -> Point | None:
        """Return a fixed point of Tresca friction, if it is reached.

        With a limit g of the friction of each contact in place of mu c_n, the equilibria are the
        least points of a convex energy,

            sum x^2 / (2 k) + sum g |T . d| - w . d   with   x >= q - k N . d,  x >= 0,

        whose x are the normal forces; they give the next limits, g = mu x. A fixed point obeys
        Coulomb's law. The steps need not converge: this proposes, and proves nothing. It is for
        friction along lines, and springs of positive stiffness.

        Source: J. Haslinger, I. Hlavacek, J. Necas, Numerical methods for unilateral problems in
        solid mechanics, Handbook of Numerical Analysis IV (1996), section 10.
        """
        m, n, k = self.m, self.n, self.stiffness
        if not m or not (k > 0).all():
            return None
        slip, unit, none = self.tangents[:, 0], np.eye(m), np.zeros((m, m))
        # Unknowns: the motion, the normal forces x, and s >= |T . d|.
        rows = np.block(
            [
                [self.spring[:, 1:], -unit, none],
                [np.zeros((m, n)), -unit, none],
                [slip, none, -unit],
                [-slip, none, -unit],
            ]
        )
        right = np.concatenate([-self.preload, np.zeros(3 * m)])
        squares = Columns.of(np.diag([*[_ENERGY_MOTION_WEIGHT] * n, *(1 / k), *[0.0] * m]))
        settings = _settings()
        settings.tol_feas = settings.tol_gap_abs = settings.tol_gap_rel = _LIMIT_PROGRAM_ERROR
        limit, solver = np.full(m, _FIRST_LIMIT), None
        for _ in range(_MAX_LIMIT_STEPS):
            cost = np.concatenate([-self.load, np.zeros(m), limit])
            if solver is None:
                cones = [clarabel.NonnegativeConeT(4 * m)]
                question = squares, cost, Columns.of(rows), right, cones, settings
                solver = clarabel.DefaultSolver(*question)
            else:
                solver.update(q=cost)
            solved = solver.solve()
            if str(solved.status) not in ("Solved", "AlmostSolved"):
                return None
            unknowns, multipliers = np.array(solved.x), np.array(solved.z)
            if np.abs(unknowns[:n]).max() * _ENERGY_MOTION_WEIGHT > _UNBALANCED:
                return None
            normal = np.maximum(0.0, unknowns[n : n + m])
            last, limit = limit, self.friction * normal
            if np.abs(limit - last).max() <= _FIXED_LIMIT:
                friction = multipliers[3 * m :] - multipliers[2 * m : 3 * m]
                return Point(unknowns[:n], np.column_stack([normal, friction]))
        return None

    def violations(self, states: Sequence[State], point: Point) -> Floats:
        """Return how far each contact is from the law: the change of force that it would take."""
        d, f = point
        slip = self.slips(d)
        missed = self.cones.misses(self.friction * f[:, 0], f[:, 1:], slip)
        # Without a spring no motion changes a force, and what is missed is all there is.
        soft = np.where(self.stiffness > 0, self.stiffness * lengths(slip), missed)
        rubs = np.minimum(soft, missed)
        lifts = f[:, 0] - np.maximum(0.0, self.spring_forces(d))
        open_ = np.array([state not in ("detached", "stick") for state in states], dtype=bool)
        first = np.array([state == "undecided" for state in states], dtype=bool)
        values: Floats = np.where(open_, rubs + np.where(first, _LIFT_WEIGHT * lifts, 0.0), 0.0)
        return values


def _settings() -> Any:
    settings = clarabel.DefaultSettings()
    settings.verbose = settings.presolve_enable = False
    settings.max_threads = 1
    return settings


@cache
def _squares(size: int, n: int, weight: float = _MOTION_WEIGHT) -> Columns:
    """Return the weights of squares: small motions are preferred."""
    return Columns.of(np.diag([weight] * n + [0.0] * (size - n)))
