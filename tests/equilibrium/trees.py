"""Trees for the tests of the checker: plain, slow and exact; leaves are found by linear programs.

Each node is a leaf if the exact program of its rows has a solution. Otherwise it is split: edges at
their middle or at the zero of a spring or slip, contacts by their states, whichever a seed says.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from random import Random
from typing import Any

from arrangement.numbers.exact import primitive, to_text
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium import Grasp

Generator = tuple[int, ...]
SIMPLE = ("stick", "slip+", "slip-")


class TooLarge(Exception):
    """No tree within the limit was found; the question may be a resisted one."""


def refutation(grasp: Grasp, wrench: Sequence[Any], seed: int = 0, limit: int = 400) -> Any:
    """Return a tree; seeds prefer different kinds of splits.

    Raises:
        TooLarge: more than `limit` nodes.
    """
    search = _Search(grasp, [Fraction(w) for w in wrench], Random(f"tree {seed}"), limit)
    axes = [(1, 0, 0, 0)]
    axes += [tuple(s * (j == a) for j in range(4)) for a in (1, 2, 3) for s in (1, -1)]
    return search.node(axes, {}, 0)


class _Search:
    def __init__(
        self, grasp: Grasp, wrench: Sequence[Fraction], source: Random, limit: int
    ) -> None:
        self.wrench, self.source, self.left = wrench, source, limit
        self.by_states = source.random() < 0.5
        self.contacts = []
        for c in grasp:
            (x, y), (nx, ny) = c.point, c.normal
            normal, tangent = [nx, ny, x * ny - y * nx], [-ny, nx, x * nx + y * ny]
            spring = [c.preload, *(-c.stiffness * n for n in normal)]
            self.contacts.append((spring, [Fraction(0), *tangent], normal, tangent, c.friction))

    def node(self, region: list[Generator], states: dict[int, str], depth: int) -> Any:
        self.left -= 1
        if self.left < 0 or depth > 40:
            raise TooLarge
        forced = depth < 3 and self.source.random() < 0.5
        found = None if forced else self.leaf(region, states)
        if found is not None:
            return found
        splits = [self.by_state, self.by_zero, self.by_middle]
        if self.by_states is False:
            splits = [self.by_zero, self.by_state, self.by_middle]
        if self.source.random() < 0.1:
            self.source.shuffle(splits)
        for split in splits:
            parts = split(region, states)
            if parts is not None:
                return parts(depth + 1)
        raise TooLarge

    def leaf(self, region: list[Generator], states: dict[int, str]) -> Any:
        """Return a leaf: an exact linear program in lambda and (alpha, h) of each contact."""
        size = 3 + 2 * len(self.contacts)
        rows: list[Any] = [{j: w * g[0] for j, w in enumerate(self.wrench)} for g in region]
        bounds: list[Any] = []
        written: dict[int, list[int]] = {}
        for i in range(len(self.contacts)):
            state, at = states.get(i, "undecided"), [3 + 2 * i, 4 + 2 * i]
            limits, alphas, slips, is_long = self.contact(i, region, state)
            bounds += [{**virtual, at[0]: a, at[1]: h} for virtual, a, h in limits]
            for row, alpha, slip in zip(rows, alphas, slips, strict=True):
                row.update(zip(at, (alpha, slip), strict=True))
            if is_long:
                written[i] = at if state in SIMPLE else at[:1]
        least = [_wide(row, size, -int(g[0] > 0)) for row, g in zip(rows, region, strict=True)]
        point = feasible_point(size, [*least, *(_wide(row, size, 0) for row in bounds)], [])
        if isinstance(point, Infeasible):
            return None
        motion = [to_text(x) for x in point[:3]]
        if not written:
            return motion
        given = {str(i): [to_text(point[j]) for j in at] for i, at in written.items()}
        return {"virtual_motion": motion, "multipliers": given}

    def contact(self, i: int, region: list[Generator], state: str) -> tuple[Any, ...]:
        """Return bounds (lambda, alpha, h), factors of alpha and h, and whether to write them."""
        spring, slip, normal, tangent, mu = self.contacts[i]
        e, s = ([_dot(row, g) for g in region] for row in (spring, slip))
        none = [Fraction(0)] * len(region)
        mixed = min(e) < 0 < max(e)
        is_long = state in ("detached", *SIMPLE) or (state == "attached" and min(e) < 0)
        is_long = is_long or self.source.random() < 0.2
        if state == "detached":
            return [({}, 1, 0)], e, none, True
        if not is_long and state == "undecided" and max(e) <= 0:
            return [], none, none, False
        signs = {"slip+": [-1], "slip-": [1]}.get(state, [-1, 1])
        if state not in SIMPLE and (min(s) > 0 or max(s) < 0):
            signs = [-1] if min(s) > 0 else [1]
        limits: list[Any] = []
        for sign in signs:
            along = zip(normal, tangent, strict=True)
            limits.append(({j: n + sign * mu * t for j, (n, t) in enumerate(along)}, -1, 0))
        if state == "undecided" and is_long:
            limits.append(({}, 1, 0))
        elif state == "undecided" and mixed:
            limits.append(({}, -1, 0))
            e = [max(x, Fraction(0)) for x in e]
        if state in ("slip+", "slip-"):
            limits.append(({}, 0, -1 if state == "slip+" else 1))
        return limits, e, s if state in SIMPLE else none, is_long

    def by_state(self, region: list[Generator], states: dict[int, str]) -> Any:
        order = list(range(len(self.contacts)))
        self.source.shuffle(order)
        order.sort(key=lambda i: states.get(i) != "attached")
        for i in order:
            if states.get(i) in (None, "attached"):
                kind, names = (
                    ("slip", SIMPLE) if i in states else ("attachment", ("detached", "attached"))
                )
                return lambda depth, i=i, kind=kind, names=names: {
                    "contact": i,
                    kind: {name: self.node(region, {**states, i: name}, depth) for name in names},
                }
        return None

    def by_zero(self, region: list[Generator], states: dict[int, str]) -> Any:
        """Split an edge at the zero of a spring, or else of a slip."""
        if len(region) == 7:
            return lambda depth: {
                "orthants": [
                    self.node([region[0], *corner], states, depth)
                    for corner in product(region[1:3], region[3:5], region[5:7])
                ]
            }
        for part in (0, 1):
            cuts = []
            for contact in self.contacts:
                at = [_dot(contact[part], g) for g in region]
                cuts += [
                    (j, k, primitive((abs(at[k]), abs(at[j]))))
                    for j, k in product(range(4), repeat=2)
                    if at[j] < 0 < at[k]
                ]
            if cuts:
                return self.cut(region, states, *self.source.choice(cuts))
        return None

    def by_middle(self, region: list[Generator], states: dict[int, str]) -> Any:
        if len(region) == 7:
            return self.by_zero(region, states)
        j, k = self.source.sample(range(4), 2)
        return self.cut(region, states, j, k, (1, 1))

    def cut(
        self, region: list[Generator], states: dict[int, str], j: int, k: int, at: Generator
    ) -> Any:
        p, q = at
        middle = primitive([p * x + q * y for x, y in zip(region[j], region[k], strict=True)])

        def parts(depth: int) -> Any:
            weights = {} if at == (1, 1) else {"at": [str(p), str(q)]}
            children = []
            for old in (j, k):
                child = [*region[:old], middle, *region[old + 1 :]]
                children.append(self.node(child, states, depth))
            return {"edge": [j, k], **weights, "children": children}

        return parts


def _wide(row: dict[int, Any], size: int, constant: int) -> list[Any]:
    return [*(row.get(j, 0) for j in range(size)), constant]


def _dot(row: Sequence[Any], vector: Sequence[Any]) -> Fraction:
    return sum((a * x for a, x in zip(row, vector, strict=True)), Fraction(0))
