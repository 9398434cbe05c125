"""The decision in space: a tree of contact states, and equilibria near where it does not close.

With pyramids for round cones the law is piecewise linear: with all states decided the relaxation of
a node is the law, and exact programs decide what floats leave open, so the search ends.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from heapq import heappop, heappush
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.core.contacts import FloatContacts, nearest
from equilibrium.core.continuation import SHARPNESS_NEAR
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Open, Outcome, Solution, Tree

from .cones import NARROW_SINE, Cones, Node, OpenSplit, RoundCones, finished, split_of
from .equilibria import EquilibriumSearch
from .leaves import Leaves
from .memory import Memory, OpenTree
from .relaxation import Point, Programs, Ray, Relaxation


@dataclass(frozen=True)
class TreeSettings:
    """What bounds and steers the search in a tree of contact states."""

    #: Nodes of a tree, unless the caller gives another number.
    max_nodes: int = 4000
    #: Nodes tried before exact programs; with no more in all, neither they nor random starts come.
    first_nodes: int = 20
    #: Nodes tried before random starts, which cost as much as many nodes.
    nodes_before_random_starts: int = 120
    #: Random motions that the first search for an equilibrium starts from.
    random_starts: int = 3
    #: Nodes without a leaf after which, at first, an equilibrium is looked for near a relaxation.
    min_patience: int = 6
    #: The same for each contact, if that is more: with many contacts leaves lie deeper.
    patience_per_contact: int = 2
    #: Violations, as shares of the load, up to which a relaxation obeys the law.
    law_tolerance: float = 1e-7
    #: Violations up to which the states of a relaxation are tried.
    almost_lawful: float = 1e-3
    #: Contacts with less of a violation are not split: there is nothing to learn from them.
    min_violation_split: float = 1e-9
    #: Sectors with a smaller sine of their angle are split last: more is learnt of wide ones.
    thin_sector_sine: float = 0.3
    #: With more coordinates of motions, of several bodies, Tresca friction comes first.
    largest_grasp: int = 6
    #: An equilibrium of another load is near if the loads differ by this share of all forces.
    near_load_share: float = 1 / 8
    #: With more contacts exact programs take seconds, and come last.
    max_contacts_exact_first: int = 6
    #: Where all sectors have smaller sines, or motions in scaled units are larger, the error of a
    #: float program may hide that a node is infeasible.
    imprecise_sector_sine: float = 1e-3
    imprecise_motion: float = 300.0
    #: Steps that are counted for one relaxation, see `Effort`.
    relaxation_steps: int = 10_000
    #: The same for each contact of it, where motions have six numbers; more or less for others.
    relaxation_steps_per_contact: int = 1000


SETTINGS = TreeSettings()


class Reach(NamedTuple):
    """How near the loads that are resisted come to one that is not, in floats.

    Attributes:
        share: of the way from the load that is not resisted to the other one.
        tree: the nodes that were split; the open ones reach less far.
        stuck: whether the node that reaches furthest is split no further.
    """

    share: float
    tree: OpenTree
    stuck: bool


class SpatialSearch:
    """The search for one question.

    Args:
        accept: whether a proposal is proved to be an equilibrium.
        effort: that is left.
        nodes: of a tree, at most.
        max_displacement: how far contact points may move, if bounded; `accept` knows it, too.
        cones: of friction.
        memory: of other loads on the grasp, with the same cones and bound.
        in_plane: what decides the question where it lies in one plane; None where it does not.
    """

    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        accept: Callable[[Solution], bool],
        effort: Effort | None = None,
        nodes: int | None = None,
        max_displacement: Fraction | None = None,
        cones: Cones | None = None,
        memory: Memory | None = None,
        in_plane: Callable[[], Outcome | None] | None = None,
    ) -> None:
        self.in_plane = in_plane
        self.contacts, self.wrench, self.accept = contacts, wrench, accept
        self.effort = effort or Effort()
        self.max_nodes = SETTINGS.max_nodes if nodes is None else nodes
        self.max_displacement, self.cones = max_displacement, cones or RoundCones()
        self.memory = memory or Memory()
        self.root: Node = ("undecided",) * len(contacts.rows)
        self.memory.programs = self.memory.programs or Programs(
            contacts, self.cones, max_displacement is not None
        )
        self.relaxation = Relaxation(
            contacts, wrench, self.cones, max_displacement, self.memory.programs
        )
        self.leaves = Leaves(contacts, wrench, self.cones, max_displacement)
        if self.effort.seconds is not None:
            self.relaxation.settings.time_limit = max(0.01, self.effort.remaining)
        self.splits = Splits(self.relaxation)
        question = wrench, accept, self.effort, max_displacement
        self.equilibria = EquilibriumSearch(self.relaxation, *question)
        #: Whether exact programs are tried where floats end; other ways are tried before.
        self.exactly = False
        #: Whether exact programs replace float ones where these are imprecise.
        self.avoids_imprecise = False
        self._reset_patience()

    def decide(self) -> Outcome:
        """Return an accepted equilibrium, a tree that refutes all, or what is open."""
        outcome: Outcome = self._open("")
        with np.errstate(all="ignore"):
            try:
                for reached in self._steps():
                    outcome = reached or outcome
                    if not isinstance(outcome, Open):
                        break
            except TimeoutError as late:
                return self._open(str(late))
            if isinstance(outcome, Solution) and any(outcome.motion):
                motion = np.array([nearest(x) for x in outcome.motion])
                self.memory.hold(self.equilibria.smooth.load, motion)
        return outcome

    def close(self, tree: OpenTree, nodes: int) -> Outcome:
        """Return what a tree with given splits leads to, with this many further nodes."""
        with np.errstate(all="ignore"):
            self.exactly = True
            return self._search(tree, tree.nodes + len(tree.waiting) + nodes)

    def reach(self, change: Floats, nodes: int, near: float) -> Reach:
        """Return how near resisted loads come to this one, as far as relaxations show.

        The load is an unknown of the relaxations, between two given ones. The node that reaches
        furthest is split, again and again, so where relaxations come close to the law the boundary
        is near. It shows where to ask, and a tree whose open nodes a proof there has to close.

        Args:
            change: of the load to one that is resisted.
            nodes: whose programs are solved, at most.
            near: the search ends where it is as near to the load that is resisted.
        """
        relaxation, tree = self.relaxation, OpenTree(self.root)
        furthest: list[tuple[float, int, Any, Any]] = []
        closed = []
        count = 0

        def ask(states: Node, parent: list[Any], position: int) -> None:
            nonlocal count
            count += 1
            self.count_program()
            first = relaxation.first(states, change)
            place = states, parent, position
            if first is None:
                closed.append(place)
            else:
                heappush(furthest, (first[0], count, first[1], place))

        stuck = False
        ask(*tree.waiting.pop())
        while furthest and count < nodes and furthest[0][0] < 1 - near:
            _, _, point, (states, parent, position) = furthest[0]
            values = relaxation.violations(states, point)
            split = None
            if values.max(initial=0.0) > SETTINGS.law_tolerance:
                split = self.splits.of_worst_contact(states, values, point)
                split = split or self.splits.of_any_contact(states, point)
            if split is None:
                stuck = True
                break
            heappop(furthest)
            tree.splits[states], parent[position] = split, split.node
            for k, part in enumerate(split.parts):
                ask(part, split.children, k)
        tree.waiting = [*closed, *(place for *_, place in furthest)]
        if not furthest:
            return Reach(1.0, tree, stuck)
        share, _, point, _ = furthest[0]
        # There may be an equilibrium near.
        self.memory.hold(
            self.equilibria.smooth.load + share * change, point.motion * relaxation.scale
        )
        return Reach(share, tree, stuck)

    def count_program(self) -> None:
        """Count the steps of one relaxation."""
        rows = self.contacts.rows
        each = SETTINGS.relaxation_steps_per_contact * rows.n / 6
        self.effort.check(SETTINGS.relaxation_steps + each * len(rows))

    def _steps(self) -> Iterator[Outcome | None]:
        """Yield what each step leads to, if anything, from the cheapest to the dearest."""
        smooth, first = self.equilibria.smooth, SETTINGS.first_nodes
        # A proof without any split, first of what holds whatever the contacts do.
        ray = self.relaxation.inner_ray(["loose"] * len(self.root), 0.0)
        yield ray and self.leaves.leaf(self.root, ray)
        yield self._leaf(self.root, self.relaxation.solve(self.root))
        # An equilibrium near one of another load on the grasp.
        motion = self.memory.near(smooth.load, smooth.arms, smooth.size * SETTINGS.near_load_share)
        if motion is not None:
            yield self.equilibria.near_motion(motion, SHARPNESS_NEAR)
        if self.contacts.rows.n > SETTINGS.largest_grasp:
            yield self._near_fixed_limits()
        tree = OpenTree(self.root)
        if self.memory.promises(self.root, self.leaves):
            yield self._search(tree, first)
        few = self.max_nodes <= first
        starts = smooth.starts(0 if few else SETTINGS.random_starts)
        yield self.equilibria.near_motion(next(starts), 1.0)
        yield self._search(tree, min(first, self.max_nodes))
        if self.in_plane:
            yield self.in_plane()
        yield self.equilibria.in_visited_states()
        if not few:
            yield self._search(tree, min(SETTINGS.nodes_before_random_starts, self.max_nodes))
            self.exactly = True
            for motion in starts:
                yield self.equilibria.near_motion(motion, 1.0)
            # A tree with nodes that cannot be split begins again; if the new one has such nodes,
            # too, the next avoids imprecise float programs.
            tree = OpenTree(self.root) if tree.holes or tree.hopeless else tree
            yield self._search(tree, self.max_nodes)
            if tree.holes or tree.hopeless:
                self.avoids_imprecise = True
                yield self._search(OpenTree(self.root), self.max_nodes)
            yield self.equilibria.in_visited_states()

    def _near_fixed_limits(self) -> Solution | None:
        """Return an equilibrium with the states at a fixed point of Tresca friction, or nearly."""
        near = self.equilibria.at_fixed_limits()
        if not isinstance(near, tuple):
            return near
        outcome = self._search(OpenTree(near), SETTINGS.first_nodes)
        return outcome if isinstance(outcome, Solution) else None

    def _search(self, tree: OpenTree, max_nodes: int) -> Outcome:
        """Search depth first; nodes that other loads show are not counted."""
        self._reset_patience()
        while tree.waiting and not tree.hopeless:
            if tree.nodes >= max_nodes:
                return self._open(f"after {tree.nodes} nodes the tree is not closed")
            if self.effort.passed:
                raise TimeoutError(
                    f"{self.effort}, {tree.nodes} nodes, {tree.leaves} of them closed"
                )
            states, parent, position = tree.waiting.pop()
            part = self.memory.at(states, self.leaves)
            if part is None:
                part = self._new_node(tree, states)
            if isinstance(part, Solution):
                return part
            if isinstance(part, OpenSplit):
                tree.splits[states] = part
                parent[position] = part.node
                children = enumerate(part.parts)
                tree.waiting += reversed([(x, part.children, k) for k, x in children])
            elif part is not None:
                parent[position], self.idle, tree.leaves = part, 0, tree.leaves + 1
            else:
                # Further on there may be an equilibrium.
                tree.holes += 1
        if tree.holes or tree.waiting:
            return self._open("a relaxation neither closes nor splits further")
        self.memory.keep(tree.splits, self.leaves.found)
        proof: Tree = finished(tree.top[0])
        return proof

    def _open(self, reason: str) -> Open:
        return Open(reason, self.equilibria.residual)

    def _reset_patience(self) -> None:
        """Count the nodes since the last leaf anew, and how many of them are borne."""
        each = SETTINGS.patience_per_contact * len(self.contacts.rows)
        self.idle, self.patience = 0, max(SETTINGS.min_patience, each)

    @property
    def is_impatient(self) -> bool:
        """Whether too many nodes have led to no leaf."""
        return self.idle >= self.patience

    def _new_node(self, tree: OpenTree, states: Node) -> Solution | Tree | OpenSplit | None:
        """Decide a node that no other load has shown; split it as another load did, if at all."""
        self.count_program()
        self.idle += 1
        tree.nodes += 1
        tree.pairs += sum(self.cones.sine(x) < NARROW_SINE for x in states) > 1
        part = self._node(states)
        return (self.memory.split(states) or part) if isinstance(part, OpenSplit) else part

    def _node(self, states: Node) -> Solution | Tree | OpenSplit | None:
        """Return an equilibrium, a leaf, a cut, or None where there is none of them."""
        relaxed = self.relaxation.solve(states)
        leaf = self._leaf(states, relaxed)
        if leaf is not None:
            return leaf
        # Where floats end, are imprecise, or lead nowhere for long, exact programs are used.
        imprecise = self.avoids_imprecise and self._is_imprecise(states, relaxed)
        hard = imprecise or (self.exactly and self.is_impatient)
        if isinstance(relaxed, Point) and not hard:
            part = self._equilibrium_or_cut(states, relaxed)
            if part is not None:
                return part
        is_decided = not any(x in ("undecided", "attached") for x in states)
        cheap = is_decided if imprecise else len(states) <= SETTINGS.max_contacts_exact_first
        exact_first = self.exactly and (cheap or self.is_impatient)
        split = None if exact_first else self.splits.of_any_contact(states, relaxed)
        if split is not None or not self.exactly:
            return split
        return self._exact_node(states, relaxed)

    def _is_imprecise(self, states: Node, relaxed: Ray | Point | None) -> bool:
        """Return whether the error of a float solution may hide that a node is infeasible."""
        if not isinstance(relaxed, Point):
            return False
        widest = max((self.cones.sine(x) for x in states if not isinstance(x, str)), default=1.0)
        far = float(np.abs(relaxed.motion).max())
        return widest < SETTINGS.imprecise_sector_sine or far > SETTINGS.imprecise_motion

    def _exact_node(
        self, states: Node, relaxed: Ray | Point | None
    ) -> Solution | Tree | OpenSplit | None:
        """Decide a node by exact programs, or split it where their point fails the law."""
        exact = self.equilibria.exact.part(states, self.splits.towards(relaxed))
        if not isinstance(exact, Solution):
            return exact
        near = exact if self.accept(exact) else self.equilibria.in_visited_states()
        point = self._point(exact)
        part = near or self._equilibrium_or_cut(states, point)
        return part or self.splits.of_any_contact(states, point)

    def _point(self, solution: Solution) -> Point:
        """Return a solution in the units of relaxations."""
        numbers = np.array([nearest(x) for x in chain(solution.motion, *solution.forces)])
        n = self.contacts.rows.n
        forces = numbers[n:].reshape(len(solution.forces), -1) / self.relaxation.force
        return Point(numbers[:n] / self.relaxation.scale, forces)

    def _leaf(self, states: Node, relaxed: Ray | Point | None) -> Tree | None:
        """Return a leaf where a relaxation has no solution, or where its program failed."""
        if isinstance(relaxed, Point):
            return None
        leaf = relaxed and self.leaves.leaf(states, relaxed)
        if leaf is None:
            inner = self.relaxation.inner_ray(states)
            leaf = inner and self.leaves.leaf(states, inner)
        if leaf is not None:
            self.memory.add(self.leaves.found[states], self.leaves)
        return leaf

    def _equilibrium_or_cut(self, states: Node, point: Point) -> Solution | OpenSplit | None:
        """Return an equilibrium near a point of a relaxation, or a cut where it fails the law."""
        violations = self.relaxation.violations(states, point)
        worst = float(violations.max(initial=0.0))
        is_lawful = worst <= SETTINGS.law_tolerance
        near = None
        if worst <= SETTINGS.almost_lawful:
            near = self.equilibria.with_states_of(point)
        if near is None and (is_lawful or self.is_impatient):
            self.idle, self.patience = 0, self.patience * (1 if is_lawful else 2)
            motion = point.motion * self.relaxation.scale
            near = self.equilibria.near_motion(motion, SHARPNESS_NEAR)
        if near is not None or is_lawful:
            return near
        return self.splits.of_worst_contact(states, violations, point)


class Splits:
    """Which contact of a node is split, and into which states."""

    def __init__(self, relaxation: Relaxation) -> None:
        self.relaxation, self.cones = relaxation, relaxation.cones
        self.contacts = relaxation.contacts

    def of_worst_contact(self, states: Node, violations: Floats, point: Point) -> OpenSplit | None:
        """Return the split of the contact furthest from the law, with one part around its slip."""
        least = SETTINGS.min_violation_split
        order = [int(i) for i in np.argsort(-violations) if violations[i] > least]
        order = [i for i in order if self._is_open(states, i)]
        order.sort(key=lambda i: self.cones.sine(states[i]) < SETTINGS.thin_sector_sine)
        return self._first(states, order, lambda i: self.relaxation.tangents[i] @ point.motion)

    def of_any_contact(self, states: Node, relaxed: Ray | Point | None) -> OpenSplit | None:
        """Return the split of the contact that is decided least; of a ray, with the least room."""
        room = relaxed.room[:, 0] if isinstance(relaxed, Ray) else np.zeros(len(states))
        towards = self.towards(relaxed)
        ranks = {"undecided": 0, "attached": 1}

        def decidedness(i: int) -> tuple[float, ...]:
            return ranks.get(str(states[i]), 2), -self.cones.sine(states[i]), room[i]

        order = filter(partial(self._is_open, states), range(len(states)))
        return self._first(
            states,
            sorted(order, key=decidedness),
            lambda i: -towards[i] if towards[i].any() else np.eye(self.contacts.rows.tangents)[0],
        )

    def towards(self, relaxed: Ray | Point | None) -> Floats:
        """Return for each contact the direction of friction in which its cone matters."""
        if isinstance(relaxed, Point):
            return relaxed.forces[:, 1:]
        if relaxed is None:
            return np.zeros((len(self.contacts.rows), self.contacts.rows.tangents))
        towards: Floats = -(self.contacts.tangents @ relaxed.virtual)
        return towards

    def _is_open(self, states: Node, i: int) -> bool:
        """Return whether a contact is not decided: one without friction does not slip."""
        return states[i] != "attached" or bool(self.contacts.rows[i].friction)

    def _first(
        self, states: Node, order: list[int], slip_of: Callable[[int], Floats]
    ) -> OpenSplit | None:
        """Return the split of the first contact that has one: sectors may be too narrow."""
        splits = (self._of_contact(states, i, slip_of(i)) for i in order)
        return next((split for split in splits if split is not None), None)

    def _of_contact(self, states: Node, i: int, slip: Floats) -> OpenSplit | None:
        if states[i] != "undecided":
            is_decided = states[i] in ("detached", "stick")
            return None if is_decided else self.cones.slips(states, i, slip)
        children: list[Any] = [None, None]
        node = {"contact": i, "attachment": children}
        return split_of(node, children, states, i, ["detached", "attached"])
