"""The complete decision: does a grasp hold a wrench passively, and in which ways.

Model: a motion d and forces with, at every contact, ``c_n = max(0, preload - stiffness N . d)``,
``|c_t| <= friction c_n``, maximum dissipation (``T . d > 0`` gives ``c_t = -friction c_n``,
``T . d < 0`` gives ``+friction c_n``), and ``sum (c_n N + c_t T) + w = 0``. The answer is an
equilibrium, or a tree of virtual motions against which nothing balances the load. All equilibria
are found in another way: each satisfies the conditions of one of `contact_states`, which are
linear; one system for each is solved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import Shown
from arrangement.console.plugins import named
from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector, to_text, vector_text
from equilibrium.certificate.checker import Report, check
from equilibrium.certificate.document import Certificate, refuted_certificate, resisted_certificate
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.range import NO_RANGE, Range, RangeArguments
from equilibrium.plane.contacts import FloatContacts, IntegerContacts
from equilibrium.plane.search.motion_regions import resistance
from equilibrium.plane.search.part_program import Node
from equilibrium.plane.search.state_equilibrium import Solution
from equilibrium.plane.search.units import SearchUnits
from equilibrium.plane.states.contact_states import Codes, state_codes, states_at, states_of_code
from equilibrium.plane.states.equilibrium import Equilibrium, equilibrium_of, maximal
from equilibrium.plane.states.interval_filter import Screen
from equilibrium.plane.states.state_system import States, state_system

from . import NOT_RESISTED, RESISTED
from .robustness import AskedAgain, Solve

if TYPE_CHECKING:
    from .spatial_verdict import SpatialVerdict

#: With more contacts all equilibria are listed only when asked for: their search takes long.
MOST_LISTED = 20


@dataclass(frozen=True)
class Verdict(AskedAgain):
    """The answer for one grasp and wrench, true when resisted, with what is needed to check it.

    Attributes:
        grasp, wrench: the question.
        solution: the equilibrium that the certificate shows; None when there is none.
        within: the range in which equilibria count.
    """

    grasp: Grasp
    wrench: RationalVector
    solution: Solution | None
    _solver: Solver = field(repr=False, compare=False)
    _proof: Node = field(default=None, repr=False, compare=False)
    within: Range = NO_RANGE

    def __repr__(self) -> str:
        wrench = vector_text(self.wrench)
        return f"<Verdict: {self.verdict}, wrench {wrench}, {len(self.grasp)} contacts>"

    @property
    def verdict(self) -> str:
        """The answer in words, "resisted" or "not resisted"."""
        return RESISTED if self.stable else NOT_RESISTED

    @property
    def stable(self) -> bool:
        """Whether at least one equilibrium exists."""
        return self.solution is not None

    def __bool__(self) -> bool:
        """Return whether the wrench is resisted."""
        return self.stable

    @cached_property
    def equilibria(self) -> tuple[Equilibrium, ...]:
        """The maximal pieces of the set of all solutions; empty when unstable.

        Pieces may touch; none lies in another. Of a piece with many solutions, the reported one
        has the least ``|d|^2``, and among those the least ``|c|^2``, both exact. To find all
        takes far longer than the verdict where there are many contacts.
        """
        return () if self.solution is None else self._solver._equilibria(self.wrench)

    @cached_property
    def states(self) -> States:
        """The state of each contact at the motion of `solution`; none when there is none."""
        return () if self.solution is None else states_at(self.grasp, self.solution.motion)

    @cached_property
    def certificate(self) -> Certificate:
        """The proof, checkable without the solver."""
        if self.solution is None:
            return refuted_certificate(self.grasp, self.wrench, self._proof, within=self.within)
        shown = self.solution
        found = shown.motion, shown.forces
        return resisted_certificate(self.grasp, self.wrench, *found, within=self.within)

    def verify(self) -> Report:
        """Check the certificate, and that it answers this question; the report is true if so."""
        question = self.grasp, self.wrench
        return check(self.certificate.to_dict(), question=question, within=self.within)

    def lists_all(self, every: bool | None = None) -> bool:
        """Return whether `to_dict` lists all equilibria."""
        return not self.stable or (len(self.grasp) <= MOST_LISTED if every is None else every)

    def to_dict(self, every: bool | None = None) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals.

        Args:
            every: list all equilibria; False: only the one of the certificate, by states, motion
                and forces, and ``"complete": false``. None: all up to `MOST_LISTED` contacts.
        """
        complete = self.lists_all(every)
        if complete or self.solution is None:
            listed = [piece.to_dict() for piece in self.equilibria]
        else:
            listed = [{"states": list(self.states), **self.solution.to_dict()}]
        document = {
            "verdict": self.verdict,
            "stable": self.stable,
            "equilibria": listed,
            **({} if complete else {"complete": False}),
            **({"warnings": list(self.warnings)} if self.warnings else {}),
            "wrench": [to_text(x) for x in self.wrench],
            **self.within.to_dict(),
            "grasp": self.grasp.to_dict(),
        }
        return self._with_rounding(document)

    @property
    def again(self) -> Solve:
        """What decides other grasps in the same way."""
        return partial(solve, **self.within.bounds)

    def _repr_html_(self) -> str | None:
        """What a notebook shows: every equilibrium with its forces."""
        text: str | None = named("equilibrium.pictures.notebook:verdict_html")(self)
        return text


def solve(
    grasp: Grasp,
    wrench: Iterable[Any],
    *,
    time_limit: float | None = None,
    shorten: bool = False,
    largest_turn: Any = None,
    largest_force: Any = None,
) -> Verdict | SpatialVerdict:
    """Decide exactly whether a grasp resists a wrench; the verdict finds all ways when asked.

    A grasp in space has a `SpatialVerdict`, which may be undecided; see there.

    Args:
        grasp: contacts in the object frame.
        wrench: applied, ``(f_x, f_y, tau)``, the torque about the origin; in space
            ``(f_x, f_y, f_z, tau_x, tau_y, tau_z)``.
        time_limit: in seconds; none by default.
        shorten: look longer for a smaller proof that nothing balances the wrench.
        largest_turn, largest_force: only equilibria count whose rotation (in space the length of
            the rotation vector) and whose normal force at each contact are at most that; exact
            numbers.

    Raises:
        TimeLimitError: the time has passed without an answer.

    The search is in floating point, each answer exact. It always ends: see "Completeness" in the
    documentation of proofs. On random grasps the time is nearly linear in the number of contacts.

    >>> from equilibrium.grasps.files import read_grasp
    >>> solve(read_grasp("paper-three-contacts-preload-1"), [0, 1, 0]).stable
    True
    """
    bounds: RangeArguments = {"largest_turn": largest_turn, "largest_force": largest_force}
    if grasp.dimension == 3:
        from .spatial_verdict import solve_in_space

        return solve_in_space(grasp, wrench, time_limit=time_limit, **bounds)
    return Solver(grasp, **bounds).solve(wrench, time_limit=time_limit, shorten=shorten)


class Solver(Shown):
    """A grasp prepared for many wrenches: what one question computes serves the next.

    Every function about the wrenches that a grasp resists takes a solver in place of the grasp.
    With bounds only equilibria in their range count; see the function `solve`.

    >>> from equilibrium.grasps.files import read_grasp
    >>> solver = Solver(read_grasp("paper-three-contacts-preload-1"))
    >>> [verdict.stable for verdict in solver.solve_many([[0, 1, 0], [0, 2, 0]])]
    [True, False]
    """

    shown_fields = ("grasp",)

    def __init__(self, grasp: Grasp, largest_turn: Any = None, largest_force: Any = None) -> None:
        grasp.require_plane()
        self.grasp, self.within = grasp, Range.of(largest_turn, largest_force)
        self._scaled: dict[Range, IntegerContacts] = {}

    @cached_property
    def _codes(self) -> Codes:
        return state_codes(self.grasp)

    @cached_property
    def screen(self) -> Screen:
        """The systems of all choices of contact states in floating point, with error bounds."""
        return Screen(FloatContacts(self.grasp), self._codes)

    @property
    def states(self) -> tuple[States, ...]:
        """The choices of contact states; see `contact_states`."""
        return tuple(map(states_of_code, self._codes.tolist()))

    def solve(
        self, wrench: Iterable[Any], *, time_limit: float | None = None, shorten: bool = False
    ) -> Verdict:
        """Decide one wrench; see the function `solve`."""
        applied = read_wrench(wrench)
        units = SearchUnits.of(self.grasp, applied)
        # Without preload no number of the contacts depends on the unit of force, with it that is
        # the grasp's own; so all wrenches share them but for the range.
        within = units.range(self.within)
        scaled = self._scaled.get(within)
        if scaled is None:
            scaled = IntegerContacts(units.grasp(self.grasp), within)
            self._scaled = {within: scaled}
        found = resistance(scaled, units.wrench(applied), time_limit, shorten)
        if isinstance(found, Solution):
            found = units.solution_back(found)
            return Verdict(self.grasp, applied, found, self, within=self.within)
        return Verdict(self.grasp, applied, None, self, units.tree_back(found), self.within)

    def solve_many(self, wrenches: Iterable[Iterable[Any]]) -> Iterator[Verdict]:
        """Decide one wrench after the other."""
        return map(self.solve, wrenches)

    def _equilibria(self, wrench: RationalVector) -> tuple[Equilibrium, ...]:
        """Return the maximal pieces of all solutions: every choice of contact states is decided.

        The states at a motion on the border of normal planes may be none of the choices; where
        they hold more of the solutions, theirs is the piece to report.
        """
        possible = self._codes[self.screen.possible(wrench)].tolist()

        def piece_of(states: States) -> Equilibrium | None:
            return equilibrium_of(state_system(self.grasp, states, wrench, within=self.within))

        tried = map(states_of_code, watched(possible, "contact states"))
        pieces = [piece for piece in map(piece_of, tried) if piece]
        known = {piece.states for piece in pieces}
        for piece in pieces:
            states = states_at(self.grasp, piece.motion)
            if states not in known:
                known.add(states)
                further = piece_of(states)
                if further:
                    pieces.append(further)
        return maximal(pieces)


def prepare(grasp: Grasp | Solver) -> Solver:
    """Return the solver of a grasp; a solver is returned as it is."""
    return grasp if isinstance(grasp, Solver) else Solver(grasp)
