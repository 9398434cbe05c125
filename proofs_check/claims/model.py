"""Our own theorem: how many contact states the corrected model has (see docs/proofs)."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain, combinations, product
from math import comb
from typing import Any

from arrangement import counts
from arrangement.numbers.linear.rank import determinant
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check.routes.oracle import Row, project
from proofs_check.statements.statement import Case, Claim

from .stated import at_most, stated

#: Rational unit normals: multiples of 1/5, 1/13 and 1/17, turned and mirrored below.
_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (1, 0, 1))
Faces = tuple[int, ...]


def most_faces(m: int, *, preload: bool) -> Faces:
    """Return the largest possible numbers of points, lines, facets and regions for m contacts."""
    n = 2 * m
    if not preload:
        return (1, n * (n - 1), 2 * n * (n - 1), n * n - n + 2)
    if m < 3:
        return tuple(counts.fukuda_bound(n, 3, k) for k in range(4))
    points = comb(n, 3) - comb(m, 3) + 1
    lines = comb(m, 2) * (m + 2) + (comb(n, 2) - comb(m, 2)) * (n - 1)
    tangential = 2 * (m - 1) + sum(1 + j for j in range(m - 1, n - 1))
    normal = 1 + (n - 1) + comb(n - 1, 2)
    regions = m * m - m + 2 + sum(1 + j + comb(j, 2) for j in range(m, n))
    return (points, lines, m * tangential + m * normal, regions)


def _has_preload(grasp: Grasp) -> bool:
    return any(contact.preload for contact in grasp)


def in_general_position(grasp: Grasp) -> bool:
    """Return whether three planes meet in a point, and four in none but the origin where forced.

    Without preload all planes pass through the origin. With it the tangential ones do.
    """
    rows = [tuple(plane) for plane in grasp.motion_arrangement().integer_planes]
    m = len(grasp)
    if any(determinant([row[:3] for row in three]) == 0 for three in combinations(rows, 3)):
        return False
    if not _has_preload(grasp):
        return True
    fours = (four for four in combinations(range(2 * m), 4) if four[-1] >= m)
    return all(determinant([rows[i] for i in four]) for four in fours)


def _within(grasp: Grasp, f: Faces) -> bool:
    """At most the maximum in every dimension, with equality in general position."""
    most = most_faces(len(grasp), preload=_has_preload(grasp))
    if in_general_position(grasp) and len(grasp) > 1:
        return f == most
    return at_most(f, most)


def _random_grasp(rng: random.Random, m: int, *, preload: bool) -> Grasp:
    contacts = []
    for _ in range(m):
        a, b, c = rng.choice(_TRIPLES)
        x, y = rng.choice(((a, b), (b, a)))
        normal = (Fraction(rng.choice((1, -1)) * x, c), Fraction(rng.choice((1, -1)) * y, c))
        point = (rng.randint(-9, 9), rng.randint(-9, 9))
        held = rng.randint(0, 9) if preload else 0
        contacts.append(Contact(point, normal, 1, rng.randint(1, 5), held))
    return Grasp(contacts)


def _grasps(most: int, preloads: Sequence[bool], rng: random.Random) -> Iterator[Case]:
    """Yield for each m two grasps in general position and two that need not be."""
    for preload, m in product(preloads, range(1, most + 1)):
        wanted = {"general position": 2, "as drawn": 2}
        while any(wanted.values()):
            grasp = _random_grasp(rng, m, preload=preload)
            if _has_preload(grasp) != preload:
                continue
            generic = wanted["general position"] and in_general_position(grasp)
            remark = "general position" if generic else "as drawn"
            if wanted[remark]:
                wanted[remark] -= 1
                yield Case(f"m = {m}, {remark}", grasp, grasp.to_dict())


def _choices_of_faces(grasp: Grasp, closed: bool = False) -> set[tuple[int | str, ...]]:
    """Return the states that faces have: "detached", or "attached" and the slip, of each contact.

    With closed conditions a state goes on to the boundary of its motions.
    """
    m = len(grasp)
    choices: set[tuple[int | str, ...]] = set()
    for face in grasp.motion_arrangement().faces():
        options: list[list[tuple[int | str, ...]]] = []
        for slip, side in zip(face.signs[:m], face.signs[m:], strict=True):
            slips = (0, 1, -1) if closed and not slip else (slip,)
            detached: list[tuple[int | str, ...]] = [("detached",)] if side >= 0 else []
            attached = side < 0 or (closed and not side)
            options.append(detached + [("attached", s) for s in slips if attached])
        choices |= {tuple(chain.from_iterable(chosen)) for chosen in product(*options)}
    return choices


def _nodes_of_faces(closed: bool, grasp: Grasp) -> int:
    paths = _choices_of_faces(grasp, closed)
    return len({path[:k] for path in paths for k in range(len(path) + 1)})


def _by_elimination(grasp: Grasp, closed: bool = False) -> tuple[int, int]:
    """Nodes and ends of the tree of states with a motion: strict conditions leave room e > 0."""
    room = Fraction(0 if closed else -1)

    def within(row: Row, side: int) -> Row:
        """Return ``side * row >= e``."""
        turned = [side * x for x in row]
        return (*turned[:3], room, turned[-1])

    def count_from(i: int, attached: bool, equal: list[Row], rows: list[Row]) -> tuple[int, int]:
        if not _possible(equal, rows):
            return 0, 0
        if i == len(grasp):
            return 1, 1
        contact = grasp.contacts[i]
        normal = tuple(contact.stiffness * x for x in contact.normal_wrench)
        gap: Row = (*normal, Fraction(0), -contact.preload)
        slip: Row = (*contact.tangential_wrench, Fraction(0), Fraction(0))
        if attached:
            ways = [count_from(i + 1, False, equal, [*rows, within(slip, s)]) for s in (1, -1)]
            ways.append(count_from(i + 1, False, [*equal, slip], rows))
        else:
            ways = [count_from(i + 1, False, equal, [*rows, gap])]
            ways.append(count_from(i, True, equal, [*rows, within(gap, -1)]))
        return 1 + sum(nodes for nodes, _ in ways), sum(ends for _, ends in ways)

    return count_from(0, False, [], [])


def _possible(equalities: list[Row], inequalities: list[Row]) -> bool:
    """Return whether e can be above 0."""
    limit: Row = tuple(map(Fraction, (0, 0, 0, -1, 1)))
    rows = project(equalities, [*inequalities, limit], keep=3)
    return rows is not None and all(row[4] > 0 for row in rows if row[3] < 0)


def _depth_by_faces(grasp: Grasp) -> int:
    """Two splits for each contact, times the faces of its 2m planes."""
    return 2 * len(grasp) * sum(counts.f_vector(grasp.motion_arrangement()))


def _equal_contacts(most: int) -> Iterator[Case]:
    for m in range(1, most + 1):
        grasp = Grasp([Contact((0, 0), (0, 1), 1)] * m)
        yield Case(f"m = {m}, all at one point", grasp, grasp.to_dict())


def _state_tree(id: str, *, closed: bool, **checked: Any) -> Claim:
    return stated(
        id,
        faces=partial(_nodes_of_faces, closed),
        elimination=lambda grasp: _by_elimination(grasp, closed)[0],
        judge=lambda grasp, nodes: nodes <= _depth_by_faces(grasp),
        explain=lambda grasp, nodes: f"{nodes} nodes, depth by faces {_depth_by_faces(grasp)}",
        **checked,
    )


_of_faces = partial(
    stated,
    enumeration=lambda grasp: grasp.motion_arrangement().faces().f_vector,
    theorem=lambda grasp: counts.f_vector(grasp.motion_arrangement()),
)

CLAIMS = (
    _of_faces(
        "model-faces-without-preload",
        judge=_within,
        cases=partial(_grasps, 7, (False,)),
    ),
    _of_faces(
        "model-faces-with-preload",
        judge=_within,
        cases=partial(_grasps, 5, (True,)),
    ),
    _of_faces(
        "model-linear-by-regions",
        judge=lambda grasp, f: all(f[k] <= comb(3, k) * f[3] for k in range(3)),
        cases=partial(_grasps, 5, (False, True)),
    ),
    stated(
        "model-states",
        # The slip of a contact that is detached is not a state.
        faces=lambda grasp: len(_choices_of_faces(grasp)),
        elimination=lambda grasp: _by_elimination(grasp)[1],
        judge=lambda grasp, states: (
            states <= sum(most_faces(len(grasp), preload=_has_preload(grasp)))
        ),
        cases=partial(_grasps, 3, (False, True)),
    ),
    _state_tree("state-tree", closed=False, cases=partial(_grasps, 3, (False, True))),
    _state_tree(
        "state-tree-closed",
        closed=True,
        cases=lambda _: _equal_contacts(4),
        search=lambda: _equal_contacts(3),
    ),
)
