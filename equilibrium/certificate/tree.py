"""The one walk through a tree: where each node stands, and whether its children cover its place.

A node cuts a region of motions, or distinguishes the states of one contact. What the leaves prove
is in `equilibrium.certificate.leaf_rule`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from typing import Any

from arrangement.numbers.exact import RationalVector, without_denominators
from equilibrium.model.errors import CertificateError
from equilibrium.model.solution import Leaf

from .contact_rule import SlipFace, State, state_text, turn
from .law import outward
from .leaf_rule import Generator, TreeQuestion
from .reading import STATES, Place, Split, read_node
from .report import Report

#: Splits in a row; readers of JSON stop at some 1000 objects inside one another.
MAX_DEPTH = 300


def tree_report(tree: Any, question: TreeQuestion) -> Report:
    """Check all leaves of a tree.

    After the first that fails the rest is read, as its form may be wrong.
    """
    leaves, problem = 0, ""
    for leaf, place in placed_leaves(tree, question):
        leaves += 1
        problem = problem or question.leaf_problem(leaf, place)
    return Report("not resisted", problem, leaves)


def placed_leaves(tree: Any, question: TreeQuestion) -> Iterator[tuple[Leaf, Place]]:
    """Yield the leaves of a tree with their places, in the order of the document.

    Raises:
        CertificateError: what stands in a place is not a node, or a split that does not fit there.
    """
    waiting = [(tree, Place("tree", 0, question.root, {}))]
    while waiting:
        content, place = waiting.pop()
        node = read_node(content, place.path, len(question.contacts), question.form)
        if isinstance(node, Split):
            waiting += reversed(_children(node, place, question.edges))
        else:
            yield node, place


def _children(
    split: Split, place: Place, edges: Sequence[RationalVector]
) -> list[tuple[Any, Place]]:
    """Return the children of a node with their places; refuse a split that does not cover."""
    path, depth, region, states = place
    if depth == MAX_DEPTH:
        raise CertificateError(f"{path[:60]}...: more than {MAX_DEPTH} splits in a row")
    parts: list[tuple[Sequence[Generator], Mapping[int, State]]]
    if split.kind in ("directions", "faces"):
        slips = slip_states(split, states, path, edges)
        parts = [(region, {**states, split.at[0]: state}) for state in slips]
    elif split.kind in STATES:
        contact, due = split.at[0], "attached" if split.kind == "slip" else "undecided"
        if states.get(contact, "undecided") != due:
            raise CertificateError(f"{path}: contact {contact + 1} is not {due} here")
        parts = [(region, {**states, contact: name}) for name in STATES[split.kind]]
    elif (split.kind == "edge") != (len(region) == 4):
        raise CertificateError(f"{path}: orthants cut the half space, an edge one of their cones")
    else:
        cut = cut_edge(region, *split.at) if split.kind == "edge" else orthants(region)
        parts = [(cone, states) for cone in cut]
    pairs = zip(split.children, parts, strict=True)
    return [(child, Place(name, depth + 1, *part)) for (name, child), part in pairs]


def orthants(half_space: Sequence[Generator]) -> list[list[Generator]]:
    """Return the eight cones of e_0 and +-e_1, +-e_2, +-e_3, which cover the half space."""
    corners = product(half_space[1:3], half_space[3:5], half_space[5:7])
    return [[half_space[0], *corner] for corner in corners]


def cut_edge(region: Sequence[Generator], j: int, k: int, p: int, q: int) -> list[list[Generator]]:
    """Return the two cones that a point ``p g_j + q g_k`` of an edge cuts a cone into."""
    pairs = zip(region[j], region[k], strict=True)
    sums = [[p * x + q * y for x, y in zip(*pair, strict=True)] for pair in pairs]
    common = math.gcd(*sums[0])
    middle = Generator(*(tuple(x // common for x in row) for row in sums))
    return [[*region[:old], middle, *region[old + 1 :]] for old in (j, k)]


def slip_states(
    split: Split, states: Mapping[int, State], path: str, edges: Sequence[RationalVector]
) -> list[State]:
    """Return the states that a split by directions distinguishes; refuse what does not cover.

    Raises:
        CertificateError: the contact is not attached, or directions are not in order.
    """
    contact = split.at[0]
    state = states.get(contact, "undecided")
    if (split.kind == "faces") != bool(edges):
        raise CertificateError(f"{path}: faces are for pyramids, directions for round cones")
    if edges:
        faces: list[State] = ["stick", *slip_faces(edges)]
        if state != "attached" or len(split.children) != len(faces):
            raise CertificateError(
                f"{path}: the faces of an attached contact have {len(faces)} children, and contact "
                f"{contact + 1} is {state_text(state)} here"
            )
        return faces
    ends: list[Any] = [tuple(without_denominators(row)) for row in split.directions]
    if isinstance(state, tuple) and not isinstance(state, SlipFace):
        around, sticks = [state[0], *ends, state[1]], list[State]()
        good = len(ends) == 1
    else:
        if state != "attached":
            raise CertificateError(f"{path}: contact {contact + 1} is not attached here")
        around, sticks = [*ends, *ends[:1]], ["stick"]
        # Each is less than half a turn from the one before, so three or more, that turn once.
        good = sum(y < 0 <= z for (_, y), (_, z) in pairwise(around)) == 1
    if not good or any(turn(u, v) <= 0 for u, v in pairwise(around)):
        raise CertificateError(
            f"{path}: directions go round once, counter-clockwise and each less than half a turn "
            "from the one before, or one cuts a sector"
        )
    return [*sticks, *pairwise(around)]


def slip_faces(edges: Sequence[RationalVector]) -> list[State]:
    """Return slip along the normal of each side, and between that and the next."""
    normals = outward(edges)
    faces: list[State] = []
    for j, normal in enumerate(normals):
        k = (j + 1) % len(edges)
        faces.append(SlipFace((normal,), (edges[j], edges[k])))
        faces.append(SlipFace((normal, normals[k]), (edges[k],)))
    return faces
