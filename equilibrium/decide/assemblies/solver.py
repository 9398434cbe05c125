"""The decision for an assembly: each part apart, proofs and equilibria put together.

A part of one body is a planar question. The others are searched like a grasp in space, with linear
cones: with all states decided a node is an exact program, so the search ends unless a limit does.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector, to_text, vector_text
from arrangement.numbers.linear.intervals import Interval
from equilibrium.certificate.assemblies import joint_rows
from equilibrium.certificate.law import displacement_problem, law_problem
from equilibrium.decide import NOT_RESISTED, RESISTED, UNDECIDED
from equilibrium.decide.planar import PlanarEngine
from equilibrium.model.assembly import SIZE, Assembly, Wrenches
from equilibrium.model.displacement import read_displacement
from equilibrium.model.effort import STEPS, Effort
from equilibrium.model.errors import EquilibriumError, TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Open, Solution

from .magnitudes import assembly_magnitudes
from .parts import AssemblyPart, parts_of, with_root_as_ground
from .verdict import AssemblyVerdict

#: Up to this many contacts the equilibrium of least norm of a body is looked for.
_FEW = 4
_FLOATS = "the load does not balance as a whole"


@dataclass(frozen=True)
class AssemblySolver:
    """An assembly for many questions: what `equilibrium.decide.solver.Solver` is of a grasp."""

    grasp: Assembly
    max_displacement: Fraction | None = None

    @property
    def no_wrench(self) -> Wrenches:
        """The wrench 0 on each body."""
        return self.grasp.read_wrenches({})

    def solve(
        self,
        wrenches: Mapping[str, Any],
        *,
        time_limit: float | None = None,
        nodes: int | None = None,
    ) -> AssemblyVerdict:
        """Decide one set of wrenches; see `solve_assembly`."""
        effort = Effort.usual(STEPS[3]) if time_limit is None else Effort(seconds=time_limit)
        verdict = self.decide(wrenches, effort, nodes)
        return verdict if time_limit is None else replace(verdict, _deadline=effort)

    def decide(
        self, wrenches: Mapping[str, Any], effort: Effort, nodes: int | None = None
    ) -> AssemblyVerdict:
        """Decide one set of wrenches with the effort that is left."""
        read, bound = self.grasp.read_wrenches(wrenches), self.max_displacement
        verdict = _decided(self.grasp, read, _Limits(effort, nodes, bound))
        return _checked(replace(verdict, max_displacement=bound, _solver=self))

    def magnitudes(self, base: Wrenches, along: Wrenches) -> tuple[Interval, ...]:
        """Return all t >= 0 with ``base + t along`` resisted."""
        loaded = any(c.contact.preload or c.contact.adhesion for c in self.grasp.contacts)
        if base == self.no_wrench and not loaded and self.max_displacement is None:
            # Without preload and adhesion the law scales: one verdict is that of all t > 0.
            verdict = self.solve(along)
            if verdict.decided:
                return ((Fraction(0), None if verdict else Fraction(0)),)
        return assembly_magnitudes(self.grasp, base, along, max_displacement=self.max_displacement)

    def preloads(
        self, wrenches: Wrenches, contacts: Iterable[int] | None = None
    ) -> tuple[Interval, ...]:
        """Return all preloads of chosen contacts, or of all, with which wrenches are resisted."""
        chosen = None if contacts is None else tuple(contacts)
        return assembly_magnitudes(
            self.grasp.with_preload(0, chosen),
            wrenches,
            self.no_wrench,
            preload_slope=Fraction(1),
            chosen=None if chosen is None else self.grasp.points_of(chosen),
            max_displacement=self.max_displacement,
        )


def solve_assembly(
    assembly: Assembly,
    wrenches: Mapping[str, Any],
    *,
    time_limit: float | None = None,
    nodes: int | None = None,
    max_displacement: Any = None,
) -> AssemblyVerdict:
    """Decide exactly whether an assembly resists a wrench on each body.

    Args:
        wrenches: by the names of bodies, ``(f_x, f_y, tau)``, the torque about the one origin; zero
            for bodies that are left out.
        time_limit: in seconds, by a clock on the wall; undecided when it is over. Other data within
            the rounding error are not asked about then, either.
        nodes: of one tree, at most; see `equilibrium.core.tree`.
        max_displacement: only equilibria count in which no body moves by more than that relative
            to another one along the normal and the tangent of a contact of them.

    Raises:
        GraspError: a wrench on what is no body, or of a wrong length.
        OutOfReachError: that many steps have led to no answer for a part of one body.

    >>> from equilibrium import BodyContact, Contact
    >>> feet = [BodyContact("block", None, Contact([x, 0], [0, 1], "1/2")) for x in (-1, 1)]
    >>> solve_assembly(Assembly(["block"], feet), {"block": [0, -1, 0]}).verdict
    'resisted'
    """
    solver = AssemblySolver(assembly, read_displacement(max_displacement))
    return solver.solve(wrenches, time_limit=time_limit, nodes=nodes)


class _Limits(NamedTuple):
    """What bounds the search for the equilibria of a part, and these themselves."""

    effort: Effort
    nodes: int | None
    max_displacement: Fraction | None


def _decided(assembly: Assembly, wrenches: Wrenches, limits: _Limits) -> AssemblyVerdict:
    parts, floating = parts_of(assembly, wrenches)
    for bodies, total in floating:
        if any(total):
            # No contact notices the common motion.
            leaf = {"virtual_motion": {name: list(map(to_text, total)) for name in bodies}}
            load = f"the wrenches on {_listed(bodies)} add up to {vector_text(total)}"
            reason = f"{_FLOATS}: {load}, and no contact with the ground takes that"
            return AssemblyVerdict(assembly, wrenches, NOT_RESISTED, None, reason, _tree=leaf)
    motions: Wrenches = {name: (Fraction(0),) * SIZE for name in assembly.names}
    forces: dict[int, RationalVector] = {}
    open_: list[str] = []
    found = {}
    # Parts of one body are decided soonest.
    for part in sorted(parts, key=lambda part: len(part.bodies)):
        answer = _decide_part(assembly, part, limits)
        if isinstance(answer, Solution):
            found[part.bodies] = answer
        elif isinstance(answer, str):
            open_.append(f"{_named(part)}: {answer}")
        else:
            reason = f"{_named(part)} cannot balance the load"
            return AssemblyVerdict(assembly, wrenches, NOT_RESISTED, None, reason, _tree=answer)
    if open_:
        return AssemblyVerdict(assembly, wrenches, UNDECIDED, None, "; ".join(open_))
    for part in parts:
        answer = found[part.bodies]
        held = motions[part.root] if part.root is not None else (Fraction(0),) * SIZE
        for k, name in enumerate(part.bodies):
            moved = answer.motion[SIZE * k : SIZE * (k + 1)]
            motions[name] = tuple(x + y for x, y in zip(held, moved, strict=True))
        forces |= zip(part.contacts, answer.forces, strict=True)
    motion = tuple(x for name in assembly.names for x in motions[name])
    solution = Solution(motion, tuple(forces[i] for i in range(len(assembly.contacts))))
    return AssemblyVerdict(assembly, wrenches, RESISTED, solution)


def _decide_part(
    assembly: Assembly, part: AssemblyPart, limits: _Limits
) -> Solution | dict[str, Any] | str:
    """Return an equilibrium of a part, a tree that refutes the assembly, or why it is open."""
    inside = with_root_as_ground(assembly, part)
    if len(part.bodies) > 1:
        return _searched(inside, part, limits)
    (name,) = part.bodies
    grasp, load = Grasp(c.contact for c in inside.contacts), part.wrenches[name]
    engine = PlanarEngine(grasp, limits.max_displacement)
    try:
        outcome = engine.outcome(load, limits.effort)
    except (OutOfReachError, TimeLimitError) as late:
        return str(late).removeprefix("undecided: ")
    if not isinstance(outcome, Solution):
        contacts = list(part.contacts)
        return {"part": list(part.hanging[name]), "contacts": contacts, "tree": outcome}
    if len(grasp) > _FEW:
        return outcome
    # Where a contact slips freely the least motion is the one to show.
    least = engine.choices.equilibria(load)[0]
    return Solution(least.motion, least.forces)


def _searched(
    inside: Assembly, part: AssemblyPart, limits: _Limits
) -> Solution | dict[str, Any] | str:
    """Return what the search in R^(3b) finds for a part of several bodies."""
    from equilibrium.core.cones import LineCones
    from equilibrium.core.contacts import FloatContacts
    from equilibrium.core.tree import SETTINGS, SpatialSearch

    rows, bound = joint_rows(inside), limits.max_displacement
    load = tuple(x for name in part.bodies for x in part.wrenches[name])

    def accept(found: Solution) -> bool:
        far = displacement_problem(rows, found.motion, bound)
        return not (far or law_problem(rows, load, found.motion, found.forces))

    most = SETTINGS.max_nodes if limits.nodes is None else limits.nodes
    total = inside.rows.total_load(load)
    question = FloatContacts(inside.rows), total, accept, limits.effort, most
    search = SpatialSearch(*question, max_displacement=bound, cones=LineCones())
    found = search.decide()
    if isinstance(found, Open):
        return found.reason
    return found if isinstance(found, Solution) else _lifted(found, part)


def _lifted(node: Any, part: AssemblyPart) -> dict[str, Any]:
    """Return a tree about a part as one about the assembly: what hangs on a body moves with it."""
    for kind in ("attachment", "slip"):
        if isinstance(node, dict) and kind in node:
            children = {name: _lifted(child, part) for name, child in node[kind].items()}
            return {"contact": part.contacts[node["contact"]], kind: children}
    virtual, multipliers = node, {}
    if isinstance(node, dict):
        virtual, multipliers = node["virtual_motion"], node["multipliers"]
    moved: dict[str, Any] = {}
    for k, name in enumerate(part.bodies):
        own = virtual[SIZE * k : SIZE * (k + 1)]
        if own != ["0"] * SIZE:
            moved |= dict.fromkeys(part.hanging[name], own)
    leaf: dict[str, Any] = {"virtual_motion": moved}
    if multipliers:
        rows = ((int(i), [*row, "0"][:2]) for i, row in multipliers.items())
        leaf["multipliers"] = {str(part.contacts[i]): row for i, row in rows}
    if isinstance(node, dict) and "displacements" in node:
        pinned = node["displacements"].items()
        leaf["displacements"] = {str(part.contacts[int(i)]): row for i, row in pinned}
    return leaf


def _named(part: AssemblyPart) -> str:
    """Return the contacts of a part in words."""
    return f"the contacts of {_listed(part.bodies)} with {part.root or 'the ground'}"


def _listed(names: tuple[str, ...]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _checked(verdict: AssemblyVerdict) -> AssemblyVerdict:
    """Return a verdict whose proof the checker accepts.

    Raises:
        EquilibriumError: it does not, which is an internal error.
    """
    problem = verdict.verify().problem if verdict.decided else ""
    if problem:
        raise EquilibriumError(
            f"the checker refuses the proof of the verdict on {verdict.assembly!r}: {problem}. "
            "This is an internal error; please report it"
        )
    return verdict
