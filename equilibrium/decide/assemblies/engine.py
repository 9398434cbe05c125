"""The decision for an assembly: each part apart, proofs and equilibria put together.

A part of one body is a planar question. The others are searched like a grasp in space, with linear
cones: with all states decided a node is an exact program, so the search ends unless a limit does.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector, vector_text
from equilibrium.core.contact_law import states_of
from equilibrium.core.contacts import FloatContacts
from equilibrium.decide.engines import Engine, PlanarEngine, tree_search
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.effort import Effort
from equilibrium.model.errors import TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Leaf, Open, Refutation, Solution, Tree
from equilibrium.model.subject import LoadCase, by_body, flat

from .magnitudes import PartEquilibrium, part_equilibria
from .parts import AssemblyPart, parts_of, with_root_as_ground

#: Up to this many contacts the equilibrium of least norm of a body is looked for.
_FEW = 4
_FLOATS = "the load does not balance as a whole"
#: The motion of a body at rest.
_STILL: RationalVector = (Fraction(0),) * SIZE


class AssemblyEngine(Engine):
    """The search for the parts of an assembly, one after the other."""

    def __init__(self, assembly: Assembly, max_displacement: Fraction | None = None) -> None:
        self.assembly, self.max_displacement = assembly, max_displacement

    def outcome(
        self, load: RationalVector, effort: Effort, *, nodes: int | None = None, **_: Any
    ) -> Solution | Refutation | Open:
        """Search until a part refutes all, or a limit is reached."""
        parts, floating = parts_of(self.assembly, by_body(self.assembly, load))
        for bodies, total in floating:
            if any(total):
                # No contact notices the common motion.
                leaf = Leaf(flat(self.assembly, dict.fromkeys(bodies, total)), {})
                sum_ = f"the wrenches on {_listed(bodies)} add up to {vector_text(total)}"
                return Refutation(
                    leaf, f"{_FLOATS}: {sum_}, and no contact with the ground takes that"
                )
        solutions, open_ = {}, []
        # Parts of one body are decided soonest.
        for part in sorted(parts, key=lambda part: len(part.bodies)):
            if len(part.bodies) > 1:
                outcome = self._of_bodies(part, effort, nodes)
            else:
                outcome = self._of_one_body(part, effort)
            if isinstance(outcome, Solution):
                solutions[part.bodies] = outcome
            elif isinstance(outcome, Open):
                open_.append(f"{_named(part)}: {outcome.reason}")
            else:
                return outcome
        if open_:
            return Open("; ".join(open_), 0.0)
        return self._joined([(part, solutions[part.bodies]) for part in parts])

    def _of_one_body(self, part: AssemblyPart, effort: Effort) -> Solution | Refutation | Open:
        """Return what the planar search ends with."""
        (name,) = part.bodies
        inside, load = with_root_as_ground(self.assembly, part), part.wrenches[name]
        grasp = Grasp(c.contact for c in inside.contacts)
        engine = PlanarEngine(grasp, self.max_displacement)
        try:
            outcome = engine.outcome(load, effort)
        except (OutOfReachError, TimeLimitError) as late:
            return Open(str(late).removeprefix("undecided: "), 0.0)
        if isinstance(outcome, Refutation):
            place = {"part": list(part.hanging[name]), "contacts": list(part.contacts)}
            return _refuted(part, {**place, "tree": outcome.tree})
        if len(grasp) > _FEW:
            return outcome
        # Where a contact slips freely the least motion is the one to show.
        least = engine.choices.equilibria(load)[0]
        return Solution(least.motion, least.forces)

    def _of_bodies(
        self, part: AssemblyPart, effort: Effort, nodes: int | None
    ) -> Solution | Refutation | Open:
        """Return what the search in R^(3b) ends with."""
        from equilibrium.core.cones import LineCones

        inside = with_root_as_ground(self.assembly, part)
        case = LoadCase(inside, flat(inside, part.wrenches), self.max_displacement)
        contacts = FloatContacts(inside.rows)
        outcome = tree_search(case, contacts, effort, nodes, cones=LineCones()).decide()
        if isinstance(outcome, Solution | Open):
            return outcome
        return _refuted(part, _lifted(outcome, part, self.assembly))

    def _joined(self, solved: Iterable[tuple[AssemblyPart, Solution]]) -> Solution:
        """Return the equilibrium of equilibria of the parts, those nearer to the ground first."""
        motions: Wrenches = dict.fromkeys(self.assembly.names, _STILL)
        forces: dict[int, RationalVector] = {}
        for part, solution in solved:
            held = motions[part.root] if part.root is not None else _STILL
            for k, name in enumerate(part.bodies):
                moved = solution.motion[SIZE * k : SIZE * (k + 1)]
                motions[name] = tuple(x + y for x, y in zip(held, moved, strict=True))
            forces |= zip(part.contacts, solution.forces, strict=True)
        listed = tuple(forces[i] for i in range(len(self.assembly.contacts)))
        return Solution(flat(self.assembly, motions), listed)

    def states(self, solution: Solution) -> tuple[str, ...]:
        """Return the state of each contact in an equilibrium."""
        return states_of(self.assembly.rows, solution.motion, solution.forces)

    def equilibria(self, load: RationalVector) -> tuple[tuple[PartEquilibrium, ...], ...]:
        """Return all equilibria of each part; those of different parts combine freely."""
        wrenches = by_body(self.assembly, load)
        return part_equilibria(self.assembly, wrenches, self.max_displacement)


def _refuted(part: AssemblyPart, tree: Tree) -> Refutation:
    return Refutation(tree, f"{_named(part)} cannot balance the load")


def _lifted(node: Any, part: AssemblyPart, assembly: Assembly) -> Tree:
    """Return a tree about a part as one about the assembly: what hangs on a body moves with it."""
    if not isinstance(node, Leaf):
        kind = "attachment" if "attachment" in node else "slip"
        children = {name: _lifted(child, part, assembly) for name, child in node[kind].items()}
        return {"contact": part.contacts[node["contact"]], kind: children}
    moved: dict[str, RationalVector] = {}
    for k, name in enumerate(part.bodies):
        moved |= dict.fromkeys(part.hanging[name], node.motion[SIZE * k : SIZE * (k + 1)])
    return Leaf(flat(assembly, moved), node.multipliers, node.displacements).at(part.contacts)


def _named(part: AssemblyPart) -> str:
    return f"the contacts of {_listed(part.bodies)} with {part.root or 'the ground'}"


def _listed(names: tuple[str, ...]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
