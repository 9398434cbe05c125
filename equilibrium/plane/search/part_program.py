"""The linear program of one part: a region of motions, with the states of some contacts fixed.

Its variables are the virtual motion and, for contacts with a state, the multipliers of spring and
slip, and of bounded displacements. Either it finds numbers that close the part, or its own
multipliers are a motion with forces that balance the load, and obey the law at all contacts with a
state (Farkas).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive, to_text
from arrangement.numbers.linear import programs
from equilibrium.core.contacts import IntegerContacts, nearest, product
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Solution

#: A node of a proof, as certificates write it.
Node: TypeAlias = Any
States: TypeAlias = dict[int, str]

_ZERO = Fraction(0)
#: The directions of slip that a state allows.
_SLIP_SIGNS = {"slip+": (1,), "slip-": (-1,), "stick": (1, -1), "attached": (1, -1), "detached": ()}
#: Largest entries of rounded multipliers that are tried.
_ROUNDED_SIZES = (1, 2, 3, 4, 5, 7, 10, 20, 50, 100, 1000, 10**4, 10**6, 10**9, 10**12)


class RegionRows:
    """What the load and the contacts do at the generators of a region.

    Args:
        generators: four, or the seven of the half space.
    """

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        generators: Sequence[IntegerVector],
    ) -> None:
        self.contacts, self.wrench, self.generators = contacts, wrench, generators
        rows = np.array(generators, dtype=object)
        self.weight = [int(g[0]) for g in generators]
        self.spring = product(rows, contacts.spring.T)
        self.slip = product(rows[:, 1:], contacts.tangent.T)
        self.along, self.across = contacts.balance
        unit = contacts.common_unit
        self.load = [np.array([w * unit * g for w in wrench], dtype=object) for g in self.weight]
        low, high = self.spring.min(axis=0, initial=0), self.spring.max(axis=0, initial=0)
        self.kept = [int(i) for i in np.flatnonzero(high > 0)]
        self.mixed = (low < 0) & (high > 0)
        self.presses = self.spring > 0
        one, other = (self.slip > 0).all(axis=0), (self.slip < 0).all(axis=0)
        self.known = one.astype(int) - other.astype(int)
        beyond = product(rows, contacts.bounds[0].T)
        #: The rows of bounded displacements that some motions of the region break.
        self.beyond = {
            int(k): beyond[:, k].tolist() for k in np.flatnonzero((beyond < 0).any(axis=0))
        }
        #: Whether contacts without a state have a multiplier of their spring.
        self.whole = len(generators) > 4

    @cached_property
    def floats(self) -> RegionFloats:
        """The same in floating point."""
        return RegionFloats(self)


class RegionFloats:
    """The rows of a region in floating point, its generators with a largest entry of 1."""

    def __init__(self, region: RegionRows) -> None:
        self.contacts, c = region.contacts.floats, region.contacts
        sizes = np.array([max(map(abs, g)) for g in region.generators], dtype=object)[:, None]
        self.generators = (np.array(region.generators, dtype=object) / sizes).astype(float)
        self.weight = self.generators[:, 0]
        self.spring = (region.spring / (sizes * c.spring_unit)).astype(float)
        self.slip = (region.slip / (sizes * c.wrench_unit)).astype(float)
        self.load = np.array([nearest(w) for w in region.wrench])
        self.beyond = {
            k: np.array([x / n for x, n in zip(row, sizes[:, 0], strict=True)], float)
            for k, row in region.beyond.items()
        }


@dataclass(frozen=True, eq=False)
class Cut:
    """One linear upper bound of the work at a generator.

    Attributes:
        generator: its number.
        signs: of the friction of each contact without a state that counts; 0 for all others.
    """

    generator: int
    signs: npt.NDArray[np.intp]


class PartProgram:
    """The linear program of one part; the works are concave, and bounds are added as they show.

    Variables: the virtual motion, alpha of each contact with one, h of each with one, and the
    least work t for each unit of d_0.

    Args:
        cuts: bounds that mattered to a part that contains this one.

    Attributes:
        binding: the bounds that showed a balance.
    """

    def __init__(self, region: RegionRows, states: States, cuts: Iterable[Cut] = ()) -> None:
        self.region, self.states = region, states
        whole = region.whole
        self.springs = [i for i in region.kept if i in states or (whole and region.mixed[i])]
        # A detached contact matters only where its spring could still push.
        self.slips = [i for i in self.springs if states.get(i) in ("stick", "slip+", "slip-")]
        self.is_free = np.zeros(len(region.known), dtype=bool)
        self.is_free[region.kept] = True
        self.is_free[self.springs] = False
        self.sticks = [i for i in self.slips if states[i] == "stick"]
        self.alpha = {i: 3 + n for n, i in enumerate(self.springs)}
        self.h = {i: 3 + len(self.springs) + n for n, i in enumerate(self.slips)}
        used = 3 + len(self.springs) + len(self.slips)
        #: Multipliers of bounded displacements, by their rows.
        self.pins = {k: used + n for n, k in enumerate(region.beyond)}
        self.size = used + len(self.pins) + 1
        self.cuts = [Cut(cut.generator, cut.signs * self.is_free) for cut in cuts]
        self.binding: list[Cut] = []
        #: The motion is bounded.
        self.box = [self._row({k: sign}, 1) for k in range(3) for sign in (1, -1)]
        self.limits: list[tuple[int, int]] = []
        #: Of each limit the column of alpha, and integers: ``unit alpha <= arm . motion``.
        self._most: list[tuple[int, list[int], int]] = []
        self.bounds: list[list[Any]] = []
        for i in self.springs:
            for sign in self._signs(i):
                arm, unit = self._limit(i, sign)
                entries = {**dict(enumerate(arm)), self.alpha[i]: -unit}
                self.bounds.append(self._row(entries))
                self.limits.append((i, sign))
                self._most.append((self.alpha[i], arm, unit))
        for i in self.springs:
            if states.get(i) in (None, "detached"):
                self.bounds.append(self._row({self.alpha[i]: 1}))
        for column in self.pins.values():
            self.bounds.append(self._row({column: 1}))
        for i in self.slips:
            if states[i] != "stick":
                self.bounds.append(self._row({self.h[i]: -1 if states[i] == "slip+" else 1}))

    def _signs(self, i: int) -> tuple[int, ...]:
        signs = _SLIP_SIGNS[self.states.get(i, "attached")]
        known = int(self.region.known[i])
        # A known direction helps where the state leaves it open, as the checker allows.
        return (known,) if known and self.states.get(i) in (None, "attached") else signs

    def _limit(self, i: int, sign: int) -> tuple[list[int], int]:
        """Return integers with ``alpha <= a - sign mu b``: ``unit alpha <= arm . motion``."""
        region = self.region
        arm = list(region.along[i] - sign * region.across[i])
        return arm, region.contacts.common_unit // region.contacts.spring_unit[i]

    def _row(self, entries: dict[int, Any], constant: int = 0) -> list[Any]:
        row: list[Any] = [0] * self.size + [constant]
        for column, x in entries.items():
            row[column] = x
        return row

    def cuts_at(self, along: Any, across: Any) -> list[Cut]:
        """Return for each generator the bound that is exact at a virtual motion.

        Args:
            along, across: the works of a unit normal force and of its largest friction force.
        """
        signs = self.friction_signs(along, across)
        return [Cut(j, np.where(row, signs, 0)) for j, row in enumerate(self.region.presses)]

    def _works(self, motion: Sequence[int]) -> tuple[Any, Any]:
        """Return what `cuts_at` takes, in a common unit."""
        direction, region = np.array(motion, dtype=object), self.region
        return region.along.dot(direction), region.across.dot(direction)

    def friction_signs(self, along: Any, across: Any) -> npt.NDArray[np.intp]:
        """Return the sign of friction with the least work, of each contact that counts."""
        known = self.region.known
        sign = np.where(known == 0, np.where(across >= 0, 1, -1), known)
        counts = self.is_free & (~self.region.mixed | (along < sign * across))
        return np.where(counts, sign, 0)

    def _cut_row(self, cut: Cut) -> list[Any]:
        region, j = self.region, cut.generator
        chosen = np.flatnonzero(cut.signs)
        signs = cut.signs[chosen].astype(object)
        arm = region.along[chosen] - signs[:, None] * region.across[chosen]
        work = region.spring[j, chosen].dot(arm) + region.load[j]
        entries: dict[int, Any] = dict(enumerate(work))
        return self._row({**entries, **self._own_entries(j), self.size - 1: -region.weight[j]})

    def _own_entries(self, j: int) -> dict[int, Any]:
        """Return what the multipliers give to the work at a generator."""
        region, unit = self.region, self.region.contacts.common_unit
        spring_unit, wrench_unit = region.contacts.spring_unit, region.contacts.wrench_unit
        entries: dict[int, Any] = {}
        for i in self.springs:
            entries[self.alpha[i]] = region.spring[j, i] * (unit // spring_unit[i])
        for i in self.slips:
            entries[self.h[i]] = region.slip[j, i] * (unit // wrench_unit[i])
        for k, column in self.pins.items():
            entries[column] = -unit * region.beyond[k][j]
        return entries

    def solve(self, effort: Effort) -> Node | Solution:
        """Return the leaf that closes the part, or what balances the load in it, exactly.

        Raises:
            TimeoutError: no effort is left.
        """
        cuts = self.cuts or self.cuts_at(*self._works(primitive(self.region.wrench)))
        rows = [self._cut_row(cut) for cut in cuts]
        objective = [0] * (self.size - 1) + [-1]
        # So is the work, by what the rows could give: a smaller bound would leave leaves no room.
        largest = max(sum(map(abs, row)) for row in rows)
        self.box.append(self._row({self.size - 1: -1}, largest))
        while True:
            every = [*self.box, *self.bounds, *rows]
            answer = programs.Program(len(objective), every, (), effort).minimize(objective)
            assert isinstance(answer, programs.Optimal)
            point = answer.point
            if point[-1] == 0:
                y = answer.inequality_multipliers[len(self.box) :]
                return self._balanced(cuts, y[len(self.bounds) :], y[: len(self.limits)])
            found = self.cuts_at(*self._works(primitive(point[:3])))
            made = [self._cut_row(cut) for cut in found]
            broken = [j for j, row in enumerate(made) if dot(row[:-1], point) < 0]
            if not broken:
                numbers = [*self.roundings(point[:-1]), primitive(point[:-1])]
                return self.written(next(filter(self.closes, numbers)))
            cuts = [*cuts, *(found[j] for j in broken)]
            rows += [made[j] for j in broken]

    def written(self, tried: Sequence[int]) -> Node:
        """Return the leaf of integers that close the part."""
        motion = [to_text(x) for x in tried[:3]]
        given = {}
        for i, column in self.alpha.items():
            alpha, h = tried[column], tried[self.h[i]] if i in self.h else 0
            # A detached contact without multipliers has these.
            if alpha or h or self.states.get(i) != "detached":
                given[str(i)] = [to_text(alpha), *([to_text(h)] if h else [])]
        if used := {k: tried[column] for k, column in self.pins.items() if tried[column]}:
            return self.region.contacts.bound_leaf(tried[:3], used, given)
        return {"virtual_motion": motion, "multipliers": given} if given else motion

    def roundings(self, numbers: Sequence[Any]) -> Iterator[Sequence[int]]:
        """Yield roundings of multipliers, finer and finer; no alpha above its limit."""
        largest = max(map(abs, numbers[:3])) or max(map(abs, numbers)) or Fraction(1)
        for size in _ROUNDED_SIZES:
            rounded = [round(x * size / largest) for x in numbers]
            for alpha, arm, unit in self._most:
                rounded[alpha] = min(rounded[alpha], dot(arm, rounded[:3]) // unit)
            yield rounded

    def closes(self, numbers: Sequence[int]) -> bool:
        """Return whether a virtual motion, alphas and hs close the part."""
        if any(dot(row[:-2], numbers) < 0 for row in self.bounds):
            return False
        region = self.region
        along, across = self._works(numbers[:3])
        signs = self.friction_signs(along, across)
        least = np.where(signs == 0, 0, along - signs * across)
        load = region.contacts.common_unit * dot(region.wrench, numbers[:3])
        for j, g in enumerate(region.weight):
            work = np.where(region.presses[j], region.spring[j], 0).dot(least)
            work += sum(x * numbers[column] for column, x in self._own_entries(j).items())
            # The load alone is not an integer.
            work = work * load.denominator + load.numerator * g
            if work < 0 or (g and not work):
                return False
        return True

    def violations(self, force: Any, slip: Any, normal: Any, rub: Any, friction: Any) -> Any:
        """Return how much contacts without a final state violate the law.

        Args:
            force, slip: of springs that pull as well, and along tangents, of a motion.
            normal, rub: forces.
        """
        wrong = 4 * abs(normal - np.maximum(force, 0))
        limit = friction * normal
        unlike = np.where(slip > 0, abs(limit + rub), abs(limit - rub))
        return np.where(self._unsettled, wrong + np.where(slip == 0, 0, unlike), 0)

    @cached_property
    def _unsettled(self) -> npt.NDArray[np.bool_]:
        found = np.zeros(len(self.region.known), dtype=bool)
        found[[i for i in self.region.kept if self.states.get(i, "attached") == "attached"]] = True
        return found

    def worst(self, found: Solution) -> int | None:
        """Return the contact at which forces violate the law most, or None."""
        c, (normal, rub) = self.region.contacts, np.array(found.forces, dtype=object).T
        motion = np.array(found.motion, dtype=object)
        force = (c.spring[:, 0] + c.spring[:, 1:].dot(motion)) / c.spring_unit
        friction = np.array([x.friction for x in c.grasp], dtype=object)
        wrong = self.violations(force, c.tangent.dot(motion), normal, rub, friction)
        largest = int(wrong.argmax())
        return largest if wrong[largest] else None

    def _balanced(
        self, cuts: list[Cut], weights: RationalVector, pushes: RationalVector
    ) -> Solution:
        """Return the motion and the forces that the multipliers of the program show."""
        region, contacts = self.region, self.region.contacts
        motion = [_ZERO] * 3
        forces = [[_ZERO, _ZERO] for _ in range(len(contacts))]
        self.binding = [cut for cut, weight in zip(cuts, weights, strict=True) if weight]
        for cut, weight in zip(cuts, weights, strict=True):
            if weight:
                ends = region.generators[cut.generator][1:]
                motion = [x + weight * g for x, g in zip(motion, ends, strict=True)]
                for i in np.flatnonzero(cut.signs).tolist():
                    sign = int(cut.signs[i])
                    spring = Fraction(region.spring[cut.generator, i], contacts.spring_unit[i])
                    force = weight * spring
                    forces[i][0] += force
                    forces[i][1] -= sign * force * contacts.grasp.contacts[i].friction
        for (i, sign), push in zip(self.limits, pushes, strict=True):
            # The rows of the bounds are those of a spring force of one over the spring's unit.
            force = push / contacts.spring_unit[i]
            forces[i][0] += force
            forces[i][1] -= sign * force * contacts.grasp.contacts[i].friction
        return Solution(tuple(motion), tuple((n, t) for n, t in forces))
