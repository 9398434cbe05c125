"""The decision in space: a tree of contact states, and equilibria near where it does not close."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.model.range import NO_RANGE, Range
from equilibrium.plane.contacts import SpatialContacts, nearest

from .balance import SpatialContinuation
from .enclosures import Enclosed
from .equilibria import Proposal, SpatialSolution, proposals
from .exact_parts import ExactParts
from .leaves import exact_leaf
from .plane import decide_in_plane
from .relaxation import Point, Ray, Relaxation, Sector, State
from .states import States, smooth_states

#: Nodes of a tree, if not told otherwise, and random starts of the first search.
NODES, _STARTS = 4000, 3
#: Nodes of a tree that is tried before the random starts; whoever asks for no more gets none.
_FEW = 20
#: After how many nodes without a leaf, at first, an equilibrium is looked for near a relaxation.
_PATIENCE = 6
#: Relative size below which a relaxation obeys the law.
_OBEYS = 1e-7
#: The same for trying its states, and normal forces that count as none.
_ALMOST, _LOOSE = 1e-3, 1e-6
#: Sectors are cut down to this sine of their angle; directions are multiples of one over these.
_NARROW, _COARSE, _DIRECTIONS = 1e-4, 8, 64
#: Contacts this close to the law (in shares of the load) are not split; sectors of less than this
#: sine of their angle are split last.
_NOTHING, _THIN = 1e-9, 0.3
#: The sharpness of contacts for a search that starts near an equilibrium.
_NEAR = 1e-3
#: Parts that stay open before the search ends.
_HOLES = 8


@dataclass(frozen=True)
class Open:
    """Neither was proved.

    Attributes:
        reason: in words.
        residual: of the motion that is closest to an equilibrium, as a share of the forces.
    """

    reason: str
    residual: float


class _OpenSplit(NamedTuple):
    """A node that splits one contact, its children still open, and their states."""

    node: Any
    children: list[Any]
    parts: list[tuple[State, ...]]


class SpatialSearch:
    """The search for one question.

    Args:
        accept: whether a proposal is proved to be an equilibrium.
        deadline: of `time.monotonic`.
        nodes: of a tree, at most.
        within: the range in which equilibria count; `accept` knows it, too.
    """

    def __init__(
        self,
        contacts: SpatialContacts,
        wrench: RationalVector,
        accept: Callable[[Proposal], bool],
        deadline: float = math.inf,
        nodes: int = NODES,
        within: Range = NO_RANGE,
    ) -> None:
        self.within = within
        self.contacts, self.wrench = contacts, wrench
        self.accept, self.deadline, self.nodes = accept, deadline, nodes
        self.relaxation = Relaxation(contacts, wrench, within)
        if math.isfinite(deadline):
            self.relaxation.settings.time_limit = max(0.01, deadline - time.monotonic())
        self.smooth = SpatialContinuation(contacts, wrench)
        self.tried: set[object] = set()
        #: Whether exact programs are tried where floats end; other ways are tried before.
        self.exactly = False
        self.exact = ExactParts(contacts, wrench, deadline)
        #: States that an equilibrium was looked for in, the latest last.
        self.states: list[States] = []
        self.residual = 1.0
        #: Nodes since the last leaf, and how many of them are borne.
        self.idle, self.patience = 0, _PATIENCE

    def decide(self) -> Proposal | Any | Open:
        """Return an accepted equilibrium, a tree that refutes all, or what is open."""
        with np.errstate(all="ignore"):
            try:
                found = self._decide()
                if isinstance(found, Open):
                    return self._exact_equilibrium() or found
                return found
            except TimeoutError as late:
                return Open(str(late), self.residual)

    def _decide(self) -> Proposal | Any | Open:
        root: tuple[State, ...] = ("undecided",) * len(self.contacts.grasp)
        ray = self.relaxation.cone_ray()
        leaf = ray and exact_leaf(self.contacts, self.wrench, root, ray)
        leaf = leaf or self._leaf(root, self.relaxation.solve(root))
        if leaf is not None:
            return leaf
        few = self.nodes <= _FEW
        for i, motion in enumerate(self.smooth.starts(0 if few else _STARTS)):
            near = self._near(motion, 1.0)
            if near is not None:
                return near
            if not i:
                found = self._tree(root, min(_FEW, self.nodes))
                if isinstance(found, Open):
                    question = self.contacts.grasp, self.wrench, self.deadline, self.within
                    found = decide_in_plane(*question) or found
                if isinstance(found, Open):
                    found = self._exact_equilibrium() or found
                if few or not isinstance(found, Open):
                    return found
                self.exactly = True
        return self._tree(root, self.nodes)

    def _exact_equilibrium(self) -> Proposal | None:
        """Return an equilibrium of states looked at since this was asked last, found exactly."""
        asked, self.states = self.states, []
        for states in reversed(asked):
            if ("exact", states.key) in self.tried:
                continue
            self.tried.add(("exact", states.key))
            found = self.exact.equilibrium(states)
            if found is not None and self.accept(found):
                return found
        return None

    def _near(self, motion: Floats, sharpness: float) -> Proposal | None:
        """Return an equilibrium that the smoothed balance leads to."""
        for end, eps in self.smooth.path(motion, sharpness):
            if time.monotonic() > self.deadline:
                break
            found = self._equilibrium(end, smooth_states(self.contacts, end, eps))
            if found is not None:
                return found
        self.residual = min(self.residual, self.smooth.reached / (self.smooth.size or 1.0))
        return None

    def _equilibrium(self, motion: Floats, states: States) -> Proposal | None:
        """Return an accepted equilibrium of given states near a motion."""
        self.states.append(states)
        for found in proposals(self.contacts, self.wrench, motion, states, self.tried):
            if self.accept(found):
                return found
        return None

    def _near_point(self, found: Point) -> Proposal | None:
        """Return an equilibrium with the states of a relaxation that nearly obeys the law."""
        normal = found.forces[:, 0]
        normal = np.where(normal * np.maximum(1.0, self.contacts.friction) > _LOOSE, normal, 0.0)
        limits = np.maximum(self.contacts.friction * normal, 1e-12)
        states = States(self.contacts, normal, found.forces[:, 1:] / limits[:, None])
        return self._equilibrium(found.motion * self.relaxation.scale, states)

    def _leaf(self, states: tuple[State, ...], found: Ray | Point | None) -> Any | None:
        """Return a leaf where a relaxation has no solution, or where its program failed."""
        if isinstance(found, Point):
            return None
        leaf = found and exact_leaf(self.contacts, self.wrench, states, found, self.within)
        if leaf is None:
            inner = self.relaxation.inner_ray(states)
            leaf = inner and exact_leaf(self.contacts, self.wrench, states, inner)
        return leaf

    def _tree(self, root: tuple[State, ...], most: int) -> Proposal | Any | Open:
        """Search depth first; a node is filled in when all below it are closed."""
        top: list[Any] = [None]
        waiting: list[tuple[tuple[State, ...], list[Any], int]] = [(root, top, 0)]
        nodes, leaves, holes = 0, 0, 0
        self.idle, self.patience = 0, _PATIENCE
        while waiting and holes < _HOLES:
            if nodes == most:
                return Open(f"after {nodes} nodes the tree is not closed", self.residual)
            if time.monotonic() > self.deadline:
                raise TimeoutError(f"the time is over after {nodes} nodes, {leaves} of them closed")
            states, parent, position = waiting.pop()
            nodes, self.idle = nodes + 1, self.idle + 1
            found = self._node(states)
            if isinstance(found, (SpatialSolution, Enclosed)):
                return found
            if isinstance(found, _OpenSplit):
                parent[position] = found.node
                waiting += reversed([(x, found.children, k) for k, x in enumerate(found.parts)])
            elif found is not None:
                parent[position], self.idle, leaves = found, 0, leaves + 1
            else:
                # Further on there may be an equilibrium.
                holes += 1
        if holes:
            return Open("a relaxation neither closes nor splits further", self.residual)
        return _finished(top[0])

    def _node(self, states: tuple[State, ...]) -> Proposal | Any | _OpenSplit | None:
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
        if not self.exactly:
            return self._any_split(states)
        exact = self.exact.part(states, self._towards(found))
        if not isinstance(exact, SpatialSolution):
            return exact
        point = self._point(exact)
        near = exact if self.accept(exact) else self._exact_equilibrium()
        return near or self._equilibrium_or_cut(states, point) or self._any_split(states)

    def _point(self, found: SpatialSolution) -> Point:
        """Return a solution in scaled units."""
        numbers = np.array([nearest(x) for x in chain(found.motion, *found.forces)])
        forces = numbers[6:].reshape(-1, 3) / self.relaxation.force
        return Point(numbers[:6] / self.relaxation.scale, forces)

    def _equilibrium_or_cut(
        self, states: tuple[State, ...], found: Point
    ) -> Proposal | _OpenSplit | None:
        """Return an equilibrium near a point of a relaxation, or a cut where it fails the law."""
        values = self.relaxation.violations(states, found)
        worst = float(values.max(initial=0.0))
        obeys = worst <= _OBEYS
        near = self._near_point(found) if worst <= _ALMOST else None
        if near is None and (obeys or self.idle >= self.patience):
            self.idle, self.patience = 0, 2 * self.patience if not obeys else self.patience
            near = self._near(found.motion * self.relaxation.scale, _NEAR)
        return near or (None if obeys else self._split(states, values, found))

    def _towards(self, found: Ray | Point | None) -> Floats:
        """Return for each contact the direction of friction in which its cone matters."""
        if isinstance(found, Point):
            return found.forces[:, 1:]
        if found is None:
            return np.zeros((len(self.contacts.grasp), 2))
        towards: Floats = -(self.contacts.tangents @ found.virtual)
        return towards

    def _split(self, states: tuple[State, ...], values: Floats, found: Point) -> _OpenSplit | None:
        """Return the node that splits the contact furthest from the law, its children and parts."""
        order = [int(i) for i in np.argsort(-values) if values[i] > _NOTHING]
        order = [i for i in order if self._splits(states, i)]
        # Of narrow sectors more is learnt when all others are decided.
        order.sort(key=lambda i: _sine(states[i]) < _THIN)
        for i in order:
            slip = self.relaxation.tangents[i] @ found.motion
            split = _parts(states, i, slip)
            if split is not None:
                return split
        return None

    def _splits(self, states: tuple[State, ...], i: int) -> bool:
        """Return whether a contact is not decided: one without friction does not slip."""
        return states[i] != "attached" or bool(self.contacts.grasp.contacts[i].friction)

    def _any_split(self, states: tuple[State, ...]) -> _OpenSplit | None:
        """Return a split of the contact that is decided least."""
        for kind in ("undecided", "attached"):
            for i, state in enumerate(states):
                if state == kind and self._splits(states, i):
                    return _parts(states, i, np.array([1.0, 0.0]))
        sectors = [(_sine(state), i) for i, state in enumerate(states) if isinstance(state, tuple)]
        return _parts(states, max(sectors)[1], np.array([1.0, 0.0])) if sectors else None


def _parts(states: tuple[State, ...], i: int, slip: Floats) -> _OpenSplit | None:
    """Return the node that splits one contact; None if its sector is too narrow."""
    state = states[i]
    parts: list[State]
    if state == "undecided":
        parts = ["detached", "attached"]
        children: list[Any] = [None, None]
        node: Any = {"contact": i, "attachment": children}
    elif state == "attached":
        ends = [_turned(slip, turn, _COARSE) for turn in (-60, 60, 180)]
        parts = ["stick", *((ends[k - 1], ends[k]) for k in (1, 2, 0))]
        children = [None] * 4
        node = {"contact": i, "directions": ends, "children": children}
    elif isinstance(state, tuple):
        middle = _middle(state)
        if middle is None:
            return None
        parts = [(state[0], middle), (middle, state[1])]
        children = [None, None]
        node = {"contact": i, "directions": [middle], "children": children}
    else:
        return None
    return _OpenSplit(node, children, [(*states[:i], part, *states[i + 1 :]) for part in parts])


def _turned(direction: Floats, degrees: float, size: int) -> tuple[int, int]:
    """Return integers near a direction, turned."""
    angle = math.atan2(direction[1], direction[0]) + math.radians(degrees)
    return round(size * math.cos(angle)), round(size * math.sin(angle))


def _sine(sector: State) -> float:
    """Return the sine of the angle of a sector, 1 for wide ones and other states."""
    if isinstance(sector, str):
        return 1.0
    (p, q), (u, v) = sector
    return (p * v - q * u) / math.hypot(p, q) / math.hypot(u, v) if p * u + q * v > 0 else 1.0


def _middle(sector: Sector) -> tuple[int, int] | None:
    """Return integers near the middle of a sector; None if it is narrow."""
    sine, ((p, q), (u, v)) = _sine(sector), sector
    if sine < _NARROW:
        return None
    one, other = math.hypot(p, q), math.hypot(u, v)
    x, y = p / one + u / other, q / one + v / other
    scale = (_COARSE if sine == 1.0 else _DIRECTIONS / sine) / math.hypot(x, y)
    return round(x * scale), round(y * scale)


def _finished(node: Any) -> Any:
    """Return a tree in the form of certificates."""
    if isinstance(node, dict) and "attachment" in node:
        detached, attached = map(_finished, node["attachment"])
        return {**node, "attachment": {"detached": detached, "attached": attached}}
    if isinstance(node, dict) and "directions" in node:
        directions = [list(direction) for direction in node["directions"]]
        children = [_finished(child) for child in node["children"]]
        return {**node, "directions": directions, "children": children}
    return node
