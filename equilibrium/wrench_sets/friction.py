"""The least friction coefficient of chosen contacts that resists a wrench: an exact bracket.

In the coefficient the equations are not linear, and more friction is not always better, so plain
bisection would be wrong. Instead a whole range of coefficients is refuted at once: let every
slipping contact have its own coefficient anywhere in the range, and every sticking one the largest.
That is a linear program for each choice of contact states; if all are infeasible, no coefficient of
the range resists the wrench. Ranges that are not refuted are halved, the lower half first; one
without an upper end is cut at twice its lower end. For any coefficient cones are half-planes, in
which friction takes a normal force.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import JsonMixin
from arrangement.console.progress import watched
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, rational, shown, simplest_between
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.decide.assemblies.magnitudes import surviving_states
from equilibrium.decide.solver import Solver, prepare
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, chosen_contacts
from equilibrium.model.subject import points_of, rows_of
from equilibrium.plane.states.contact_states import contact_states

#: Coefficients above this one are tried all at once only.
_LARGEST = 2**20
#: Of the bracket, if none is stated.
TOLERANCE = Fraction(1, 2**20)
#: Least width of the bracket: each halving takes one more search with longer numbers.
_LEAST_WIDTH = Fraction(1, 2**100)


@dataclass(frozen=True, repr=False)
class FrictionBracket(JsonMixin):
    """Where the least sufficient coefficient lies.

    Attributes:
        low: no coefficient below this one resists the wrench (proved).
        high: this one does (an exact verdict), and where possible it is the simplest fraction of
            the last range; None when none was found, see `impossible`: if that is not proved,
            nothing is known of those above `low`.
        contacts: numbers, from 1, of those that have the coefficient; the others keep their own.
        impossible: whether it is proved that no coefficient at all resists the wrench.
    """

    json_fields = ("low", "high", "width", "impossible", "contacts")

    wrench: RationalVector | Wrenches
    low: Fraction | None
    high: Fraction | None
    contacts: tuple[int, ...] = ()

    @property
    def impossible(self) -> bool:
        """Whether no coefficient resists the wrench; proved."""
        return self.low is None

    @property
    def width(self) -> Fraction | None:
        """The length of the bracket; 0 when the least coefficient is exactly `high`."""
        return None if self.low is None or self.high is None else self.high - self.low


def least_friction(
    grasp: Grasp | Solver,
    wrench: Any,
    tolerance: Any = TOLERANCE,
    contacts: Iterable[int] | None = None,
) -> FrictionBracket:
    """Bracket the least coefficient that makes a wrench resisted; see `Margin.friction`.

    Complexity: one exact linear program for each choice of contact states and each range that is
    looked at; after the first few ranges few states are left. Without any program where 0 is
    enough.

    >>> from equilibrium import read_grasp
    >>> found = least_friction(read_grasp("paper-four-contacts-preload-1"), [0, 2, 0], "1/1000")
    >>> found.low < Fraction(1, 2) <= found.high
    True
    """
    goal = rational(tolerance, "tolerance")
    if goal < _LEAST_WIDTH:
        raise GraspError(f"tolerance is {shown(goal)}; it must be at least 2^-100")
    solver = prepare(grasp)
    if contacts is None:
        chosen = rough_contacts(solver.grasp)
    else:
        chosen = chosen_contacts(contacts, len(solver.grasp.contact_numbers))
        if not chosen:
            raise GraspError("contacts are []; expected at least one number, or leave them out")
    load = solver.read(wrench)
    low, high = _Search(solver, load, goal, chosen).bracket()
    return FrictionBracket(load, low, high, chosen)


def rough_contacts(grasp: Grasp | Assembly) -> tuple[int, ...]:
    """Return the numbers, from 1, of the contacts that have friction."""
    points, groups = points_of(grasp), enumerate(grasp.groups, 1)
    return tuple(k for k, group in groups if any(points[i].friction for i in group))


class _Search:
    """The state of one search, from small coefficients to large ones."""

    def __init__(self, solver: Solver, load: Any, width: Fraction, chosen: tuple[int, ...]) -> None:
        self.subject, self.bound = solver.grasp, solver.max_displacement
        self.load, self.width, self.chosen = load, width, chosen
        self.places = self.subject.points_of(chosen)

    def bracket(self) -> tuple[Fraction | None, Fraction | None]:
        """Look at ranges, the lowest first, until one holds a sufficient coefficient.

        Returns:
            `low` and `high` of the answer.
        """
        if self.resists(Fraction(0)):
            return Fraction(0), Fraction(0)
        first_open, open_count = None, 0
        ranges: list[tuple[Fraction, Fraction | None, Any]] = [(Fraction(0), None, None)]
        while ranges:
            low, high, states = ranges.pop()
            if low == _LARGEST and first_open is not None:
                break
            alive = self.possible(states, low, high)
            if not alive:
                continue
            if low < _LARGEST and (high is None or high - low > self.width):
                middle = max(2 * low, Fraction(1)) if high is None else (low + high) / 2
                ranges += [(middle, high, alive), (low, middle, alive)]
                continue
            if first_open is None:
                first_open = low
            if high is None:
                break
            open_count += 1
            budget.check_size(
                open_count, "open ranges of friction coefficients", f"tolerance {shown(self.width)}"
            )
            if self.resists(high):
                simple = simplest_between(low, high)
                return first_open, simple if self.resists(simple) else high
        return first_open, None

    def possible(self, states: list[Any] | None, low: Fraction, high: Fraction | None) -> list[Any]:
        """Return states that the relaxation over a range does not refute; none if all are refuted.

        Of a grasp they are all such choices of contact states; of an assembly one choice for each
        part, the first in its tree.

        Args:
            states: those of a wider range; None for all.
        """
        if isinstance(self.subject, Assembly):
            known = states[0] if states else ()
            question = self.subject, self.load, (low, high), known, self.places, self.bound
            survivors = surviving_states(*question)
            return [] if survivors is None else [survivors]
        limits: Any = {"frictions": (low, high), "max_displacement": self.bound}
        ranged = LinearQuestion(rows_of(self.subject), self.load, chosen=self.places, **limits)
        listed = contact_states(self.subject) if states is None else states
        tried = watched(listed, "contact states")
        return [choice for choice in tried if ContactProgram(ranged, choice).feasible]

    def resists(self, coefficient: Fraction) -> bool:
        """Return whether the load is resisted at one coefficient; not if that is undecided."""
        changed = self.subject.with_friction(coefficient, self.chosen)
        verdict = Solver(changed, self.bound).solve(self.load)
        return verdict.decided and verdict.stable
