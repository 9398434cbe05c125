"""The decision in space: a tree of contact states, and equilibria near where it does not close.

With pyramids for round cones the law is piecewise linear: with all states decided the relaxation of
a node is the law, and exact programs decide what floats leave open, so the search ends.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import chain
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Solution
from equilibrium.plane.contacts import FloatContacts, nearest

from .cones import NARROW, Node, OpenSplit, Pyramids, RoundCones, finished, split_of
from .equilibria import proposals
from .exact_parts import ExactParts, PyramidParts
from .leaves import Leaves
from .memory import Memory, OpenTree
from .plane import decide_in_plane
from .relaxation import Point, Ray, Relaxation
from .states import SpatialContinuation, States, rubbing_states, smooth_states

#: Nodes of a tree, by default, and random starts of the first search.
NODES, _STARTS = 4000, 3
#: Nodes tried before exact programs, and before random starts; who asks for few gets neither.
_FEW, _MORE = 20, 120
#: After how many nodes without a leaf, at first, an equilibrium is looked for near a relaxation.
_PATIENCE = 6
#: Relative size below which a relaxation obeys the law.
OBEYS = 1e-7
#: The same for trying its states, and normal forces that count as none.
_ALMOST, _LOOSE = 1e-3, 1e-6
#: Contacts this close to the law (in shares of the load) are not split; sectors of less than this
#: sine of their angle are split last.
_NOTHING, _THIN = 1e-9, 0.3
#: The sharpness of contacts for a search that starts near an equilibrium.
_NEAR = 1e-3
#: Equilibria of loads that differ by one over this of all forces are near each other.
_CLOSE = 8
#: Larger frictions are huge.
_EVEN = 100.0
#: Steps of a program and of a proposal, and for each contact of them; of a sharpness of a path.
_PROGRAM, _EACH, _PROPOSAL, _PROPOSED, _PATH = 10_000, 1000, 20_000, 5000, 40_000
#: States that are not split further.
_DECIDED = ("detached", "stick")
#: Exact programs of more contacts take seconds, and are asked last.
_SMALL = 6


@dataclass(frozen=True)
class Open:
    """Neither was proved.

    Attributes:
        reason: in words.
        residual: of the motion that is closest to an equilibrium, as a share of the forces.
    """

    reason: str
    residual: float


class SpatialSearch:
    """The search for one question.

    Args:
        cones: of friction.
        accept: whether a proposal is proved to be an equilibrium.
        effort: that is left.
        nodes: of a tree, at most.
        max_displacement: how far contact points may move, if bounded; `accept` knows it, too.
        memory: of other loads on the grasp, with the same cones and bound.
    """

    def __init__(
        self,
        contacts: FloatContacts,
        wrench: RationalVector,
        accept: Callable[[Solution], bool],
        effort: Effort | None = None,
        nodes: int = NODES,
        max_displacement: Fraction | None = None,
        cones: RoundCones | Pyramids | None = None,
        memory: Memory | None = None,
    ) -> None:
        self.memory = memory or Memory()
        self.max_displacement, self.cones = max_displacement, cones or RoundCones()
        self.contacts, self.wrench = contacts, wrench
        self.root: Node = ("undecided",) * len(contacts.grasp)
        self.accept, self.effort, self.nodes = accept, effort or Effort(), nodes
        self.relaxation = Relaxation(contacts, wrench, self.cones, max_displacement)
        self.leaves = Leaves(contacts, wrench, self.cones, max_displacement)
        if self.effort.seconds is not None:
            self.relaxation.settings.time_limit = max(0.01, self.effort.remaining)
        self.smooth = SpatialContinuation(contacts, wrench, self.cones)
        #: The last as given; before it one of smaller frictions, if some are huge.
        self.searches = [self.smooth]
        if contacts.friction.max(initial=0.0) > _EVEN:
            less = copy.copy(contacts)
            less.friction = np.minimum(contacts.friction, _EVEN)
            self.searches.insert(0, SpatialContinuation(less, wrench, self.cones))
        self.tried: set[object] = set()
        #: Whether exact programs are tried where floats end; other ways are tried before.
        self.exactly = False
        self.exact: ExactParts | PyramidParts
        if isinstance(self.cones, Pyramids):
            how = self.effort, self.cones, max_displacement
            self.exact = PyramidParts(contacts, wrench, *how)
        else:
            self.exact = ExactParts(contacts, wrench, self.effort, max_displacement)
        #: States that an equilibrium was looked for in, the latest last.
        self.states: list[States] = []
        self.residual = 1.0
        #: Nodes since the last leaf, and how many of them are borne.
        self.idle, self.patience = 0, max(_PATIENCE, 2 * len(contacts.grasp))

    def decide(self) -> Solution | Any | Open:
        """Return an accepted equilibrium, a tree that refutes all, or what is open."""
        with np.errstate(all="ignore"):
            try:
                found = self._decide()
                if isinstance(found, Open):
                    found = self._exact_equilibrium() or found
                if isinstance(found, Solution) and any(found.motion):
                    motion = np.array([nearest(x) for x in found.motion])
                    self.memory.hold(self.smooth.load, motion)
                return found
            except TimeoutError as late:
                return Open(str(late), self.residual)

    def close(self, tree: OpenTree, nodes: int) -> Solution | Any | Open:
        """Return what a tree with given splits leads to, with this many further nodes."""
        with np.errstate(all="ignore"):
            self.exactly = True
            return self.go_on(tree, tree.nodes + len(tree.waiting) + nodes)

    def _decide(self) -> Solution | Any | Open:
        root = self.root
        ray = self.relaxation.inner_ray(["loose"] * len(root), 0.0)
        leaf = ray and self.leaves.leaf(root, ray)
        leaf = leaf or self._leaf(root, self.relaxation.solve(root))
        if leaf is not None:
            return leaf
        smooth = self.smooth
        motion = self.memory.near(smooth.load, smooth.arms, smooth.size / _CLOSE)
        near = None if motion is None else self._near(motion, _NEAR)
        if near is not None:
            return near
        few, tree = self.nodes <= _FEW, OpenTree(root)
        if self.memory.promises(root, self.leaves):
            found = self.go_on(tree, _FEW)
            if not isinstance(found, Open):
                return found
        for i, motion in enumerate(self.smooth.starts(0 if few else _STARTS)):
            near = self._near(motion, 1.0)
            if near is not None:
                return near
            if not i:
                found = self.go_on(tree, min(_FEW, self.nodes))
                if isinstance(found, Open) and isinstance(self.cones, RoundCones):
                    grasp = self.contacts.grasp
                    question = grasp, self.wrench, self.effort, self.max_displacement
                    found = decide_in_plane(*question) or found
                if isinstance(found, Open):
                    found = self._exact_equilibrium() or found
                if few or not isinstance(found, Open):
                    return found
                found = self.go_on(tree, min(_MORE, self.nodes))
                if not isinstance(found, Open):
                    return found
                self.exactly = True
        again = tree.holes or tree.hopeless
        return self.go_on(OpenTree(root) if again else tree, self.nodes)

    def _exact_equilibrium(self) -> Solution | None:
        """Return an equilibrium of states looked at since this was asked last, found exactly."""
        asked, self.states = self.states, []
        for states in reversed(asked):
            if states.kind in self.tried:
                continue
            self.tried.add(states.kind)
            found = self.exact.equilibrium(states)
            if found is not None and self.accept(found):
                return found
        return None

    def _near(self, motion: Floats, sharpness: float) -> Solution | None:
        """Return an equilibrium that the smoothed balance leads to."""
        for smooth in self.searches:
            for end, eps in smooth.path(motion, sharpness):
                self.effort.check(_PATH)
                if isinstance(self.exact, PyramidParts):
                    found = self._smooth_pyramids(self.exact, end, eps)
                else:
                    states = smooth_states(smooth.contacts, end, eps)
                    found = self._equilibrium(end, states)
                    found = found or self._rubbing(end, states.forces, states.slipping)
                if found is not None:
                    return found
        self.residual = min(self.residual, self.smooth.reached / (self.smooth.size or 1.0))
        return None

    def _equilibrium(self, motion: Floats, states: States) -> Solution | None:
        """Return an accepted equilibrium of given states near a motion."""
        self.states.append(states)
        self.effort.check(_PROPOSAL + _PROPOSED * len(self.contacts.grasp))
        for found in proposals(self.contacts, self.wrench, motion, states, self.tried):
            if self.accept(found):
                return found
        return None

    def _smooth_pyramids(self, exact: PyramidParts, end: Floats, eps: float) -> Solution | None:
        """Return an equilibrium of the states of pyramids at a motion of the smooth balance."""
        c = self.contacts
        normal = np.maximum(0.0, c.spring[:, 0] + c.spring[:, 1:] @ end)
        return self._of(exact, exact.near(normal, exact.cones.directions(c.tangents @ end, eps)))

    def _of(self, exact: PyramidParts, states: Node) -> Solution | None:
        """Return the equilibrium of decided states, asked for once."""
        found = None if states in self.tried else exact.holds(states)
        self.tried.add(states)
        return found if found is not None and self.accept(found) else None

    def _near_point(self, found: Point) -> Solution | None:
        """Return an equilibrium with the states of a relaxation that nearly obeys the law."""
        normal = found.forces[:, 0]
        normal = np.where(normal * np.maximum(1.0, self.contacts.friction) > _LOOSE, normal, 0.0)
        if isinstance(self.exact, PyramidParts):
            slips = self.relaxation.tangents @ found.motion
            still = self.relaxation.stiffness * np.hypot(*slips.T) <= _LOOSE
            return self._of(
                self.exact, self.exact.near(normal, np.where(still[:, None], 0.0, slips))
            )
        limits = np.maximum(self.contacts.friction * normal, 1e-12)
        round_ = States(self.contacts, normal, found.forces[:, 1:] / limits[:, None])
        motion = found.motion * self.relaxation.scale
        near = self._equilibrium(motion, round_)
        forces = found.forces * self.relaxation.force
        return near or self._rubbing(motion, forces, round_.slipping)

    def _rubbing(self, motion: Floats, forces: Floats, slipping: list[bool]) -> Solution | None:
        """Return an equilibrium where contacts of huge friction slip that seem to stick."""
        size = self.relaxation.force
        found = rubbing_states(self.contacts, motion, forces, slipping, size)
        return self._equilibrium(*found) if found else None

    def _leaf(self, states: Node, found: Ray | Point | None) -> Any | None:
        """Return a leaf where a relaxation has no solution, or where its program failed."""
        if isinstance(found, Point):
            return None
        leaf = found and self.leaves.leaf(states, found)
        if leaf is None:
            inner = self.relaxation.inner_ray(states)
            leaf = inner and self.leaves.leaf(states, inner)
        if leaf is not None:
            self.memory.add(self.leaves.found[states], self.leaves)
        return leaf

    def go_on(self, tree: OpenTree, most: int) -> Solution | Any | Open:
        """Go on with a search, depth first; nodes that other loads show are not counted."""
        self.idle, self.patience = 0, max(_PATIENCE, 2 * len(self.contacts.grasp))
        while tree.waiting and not tree.hopeless:
            nodes = tree.nodes
            if nodes >= most:
                return Open(f"after {nodes} nodes the tree is not closed", self.residual)
            if self.effort.passed:
                raise TimeoutError(f"{self.effort}, {nodes} nodes, {tree.leaves} of them closed")
            states, parent, position = tree.waiting.pop()
            found = self.memory.at(states, self.leaves)
            if found is None:
                self.count_program()
                tree.nodes, self.idle = nodes + 1, self.idle + 1
                tree.pairs += sum(self.cones.sine(x) < NARROW for x in states) > 1
                found = self._node(states)
                if isinstance(found, OpenSplit):
                    found = self.memory.split(states) or found
            if isinstance(found, Solution):
                return found
            if isinstance(found, OpenSplit):
                tree.splits[states] = found
                parent[position] = found.node
                parts = enumerate(found.parts)
                tree.waiting += reversed([(x, found.children, k) for k, x in parts])
            elif found is not None:
                parent[position], self.idle, tree.leaves = found, 0, tree.leaves + 1
            else:
                # Further on there may be an equilibrium.
                tree.holes += 1
        if tree.holes or tree.waiting:
            return Open("a relaxation neither closes nor splits further", self.residual)
        self.memory.keep(tree.splits, self.leaves.found)
        return finished(tree.top[0])

    def count_program(self) -> None:
        """Count the steps of one relaxation."""
        self.effort.check(_PROGRAM + _EACH * len(self.contacts.grasp))

    def _node(self, states: Node) -> Solution | Any | OpenSplit | None:
        """Return an equilibrium, a leaf, a cut, or None where there is none of them."""
        found = self.relaxation.solve(states)
        leaf = self._leaf(states, found)
        if leaf is not None:
            return leaf
        # Where floats end, or lead nowhere for long, exact programs are asked.
        if isinstance(found, Point) and not (self.exactly and self.idle >= self.patience):
            answer = self._equilibrium_or_cut(states, found)
            if answer is not None:
                return answer
        soon = self.exactly and (len(states) <= _SMALL or self.idle >= self.patience)
        split = None if soon else self.any_split(states, found)
        if split is not None or not self.exactly:
            return split
        exact = self.exact.part(states, self._towards(found))
        if not isinstance(exact, Solution):
            return exact
        point = self._point(exact)
        near = exact if self.accept(exact) else self._exact_equilibrium()
        return near or self._equilibrium_or_cut(states, point) or self.any_split(states, point)

    def _point(self, found: Solution) -> Point:
        """Return a solution in scaled units."""
        numbers = np.array([nearest(x) for x in chain(found.motion, *found.forces)])
        forces = numbers[6:].reshape(-1, 3) / self.relaxation.force
        return Point(numbers[:6] / self.relaxation.scale, forces)

    def _equilibrium_or_cut(self, states: Node, found: Point) -> Solution | OpenSplit | None:
        """Return an equilibrium near a point of a relaxation, or a cut where it fails the law."""
        values = self.relaxation.violations(states, found)
        worst = float(values.max(initial=0.0))
        obeys = worst <= OBEYS
        near = self._near_point(found) if worst <= _ALMOST else None
        if near is None and (obeys or self.idle >= self.patience):
            self.idle, self.patience = 0, 2 * self.patience if not obeys else self.patience
            near = self._near(found.motion * self.relaxation.scale, _NEAR)
        return near or (None if obeys else self.split(states, values, found))

    def _towards(self, found: Ray | Point | None) -> Floats:
        """Return for each contact the direction of friction in which its cone matters."""
        if isinstance(found, Point):
            return found.forces[:, 1:]
        if found is None:
            return np.zeros((len(self.contacts.grasp), 2))
        towards: Floats = -(self.contacts.tangents @ found.virtual)
        return towards

    def split(self, states: Node, values: Floats, found: Point) -> OpenSplit | None:
        """Return the node that splits the contact furthest from the law, its children and parts."""
        order = [int(i) for i in np.argsort(-values) if values[i] > _NOTHING]
        order = [i for i in order if self._splits(states, i)]
        # Of narrow sectors more is learnt when all others are decided.
        order.sort(key=lambda i: self.cones.sine(states[i]) < _THIN)
        for i in order:
            slip = self.relaxation.tangents[i] @ found.motion
            split = self._parts(states, i, slip)
            if split is not None:
                return split
        return None

    def _splits(self, states: Node, i: int) -> bool:
        """Return whether a contact is not decided: one without friction does not slip."""
        return states[i] != "attached" or bool(self.contacts.grasp.contacts[i].friction)

    def any_split(self, states: Node, found: Ray | Point | None) -> OpenSplit | None:
        """Return a split of the contact that is decided least; of a ray, with the least room."""
        room = found.room[:, 0] if isinstance(found, Ray) else np.zeros(len(states))
        towards = self._towards(found)
        kinds = {"undecided": 0, "attached": 1}

        def least(i: int) -> tuple[float, ...]:
            return kinds.get(str(states[i]), 2), -self.cones.sine(states[i]), room[i]

        for i in sorted(filter(partial(self._splits, states), range(len(states))), key=least):
            slip = -towards[i] if towards[i].any() else np.array([1.0, 0.0])
            split = self._parts(states, i, slip)
            if split is not None:
                return split
        return None

    def _parts(self, states: Node, i: int, slip: Floats) -> OpenSplit | None:
        """Return the split of one contact; None if its sector is too narrow."""
        if states[i] != "undecided":
            return None if states[i] in _DECIDED else self.cones.slips(states, i, slip)
        children: list[Any] = [None, None]
        node = {"contact": i, "attachment": children}
        return split_of(node, children, states, i, ["detached", "attached"])
