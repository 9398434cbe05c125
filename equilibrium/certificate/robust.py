"""Proofs of a verdict for all grasps within bounds: nothing balances the load on a closed surface.

The surface is cut into cells, each the hull of its corners. A leaf is a virtual motion lambda on
which load and contacts do work above 0 all over its cell, whatever the grasp is; of the contacts
each is bounded by itself (`uncertain`).

"Not resisted": homogeneous motions ``(y_0, s_1 y_1, ..., s_n y_n)``, ``y_0 >= 0``, with scales s;
the surface is the part of the cube with ``y_0 = 1`` or some ``y_k = +-1``, which each ray meets.

"Resisted": motions ``c + sum y_k a_k`` around a centre, and on the whole surface of the cube
``|y_k| <= 1`` lambda does work above 0 on the loads ``-sum y_k b_k`` as well. What is left over of
all forces is a set that is convex, and changes with the motion without a jump outwards. On the way
from it to these loads nothing is 0 on the surface, so both have one degree there. That of the loads
is 1 or -1, as they are linear and not 0 on the surface: inside there is an equilibrium. The same is
said of friction forces ``f + sum y_k g_k`` of all contacts at rest, none of them above its limit.

``{"schema_version": 3, "certificate": kind, "grasp": ..., "wrench": ..., "bounds": {"degrees":
"1/2", ...}, "box": box, "faces": [nodes]}``. A box is ``{"scales": s}``, or ``{"centre": c, "axes":
[a], "loads": [b]}``, or ``{"forces": f, "axes": [g], "loads": [b]}``; f and g have the tangential
forces of all contacts in a row.
Faces are ``y_0 = 1`` (if there are scales), ``y_1 = -1``, ``y_1 = 1``, ``y_2 = -1``, ... A node is
lambda, or ``{"cut": k, "children": [low, high]}``, which halves the cell along y_k.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import IntegerVector, RationalVector, dot, primitive, rational_vector
from arrangement.numbers.linear.rank import determinant
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp

from .uncertain import BITS, LARGEST, Bounds, Uncertain

#: Halvings of one cell; no coordinate has a larger denominator.
MOST_CUTS = 200
_FINEST = 1 << MOST_CUTS


class Box:
    """What cells and leaves of a proof are about.

    Args:
        form: the "box" of the document.
    """

    def __init__(
        self, grasp: Grasp, wrench: RationalVector, bounds: Bounds, form: Mapping[str, Any]
    ) -> None:
        self.wrench, n = primitive((1, *wrench)), len(wrench)
        self.contacts = [Uncertain(contact, bounds) for contact in grasp]
        self.closed, self.rest = "loads" in form, "forces" in form
        size = len(grasp) * (grasp.dimension - 1) if self.rest else n

        def matrix(name: str, size: int) -> list[RationalVector]:
            rows = enumerate(check_list(form[name], f"box.{name}", n))
            return [_vector(row, size, f"box.{name}[{k}]") for k, row in rows]

        rows: list[tuple[Fraction | int, ...]]
        if self.closed:
            middle, axes = "forces" if self.rest else "centre", matrix("axes", size)
            if not self.rest and not determinant([primitive(row) for row in axes]):
                raise CertificateError("box.axes do not span all motions")
            rows = [(1, *_vector(form[middle], size, f"box.{middle}"))]
            rows += [(0, *row) for row in axes]
            self.loads = _whole([(Fraction(0),) * n, *matrix("loads", n)])
        else:
            scales = (Fraction(1), *_vector(form["scales"], n, "box.scales"))
            if min(scales) <= 0:
                raise CertificateError("box.scales must be above 0")
            rows = [tuple(x * (j == k) for j in range(n + 1)) for k, x in enumerate(scales)]
        self.rows = _whole(rows)
        self.at = cache(self._at)

    def faces(self) -> Iterator[tuple[int, list[RationalVector]]]:
        """Yield the coordinate that a face fixes, and the ranges of all."""
        n, half = len(self.wrench) - 1, not self.closed
        ranges = [(Fraction(0), Fraction(1))] * half + [(Fraction(-1), Fraction(1))] * n
        for k in range(n + half):
            for end in ranges[k][::-1][:1] if half and not k else ranges[k]:
                yield k, [(end, end) if j == k else range_ for j, range_ in enumerate(ranges)]

    def motion(self, y: RationalVector) -> tuple[IntegerVector, IntegerVector]:
        """Return one multiple, the same for all corners, of homogeneous motion and load besides."""
        shares = [int(x * _FINEST) for x in ((Fraction(1),) * self.closed + tuple(y))]
        motion = tuple(dot(shares, column) for column in zip(*self.rows, strict=True))
        if not self.closed:
            return motion, ()
        return motion, tuple(-dot(shares, column) for column in zip(*self.loads, strict=True))

    def _at(self, y: RationalVector) -> tuple[int, IntegerVector, list[Any]]:
        """Return the share of the load, the load besides, and the contacts at a corner."""
        motion, load = self.motion(y)
        if not self.rest:
            return motion[0], load, [contact.corner(motion) for contact in self.contacts]
        unit, *forces = motion
        each = len(forces) // max(len(self.contacts), 1)
        parts = [
            [Fraction(x, unit) for x in forces[k : k + each]]
            for k in range(0, len(forces), each or 1)
        ]
        return 1, load, [c.at_rest(tuple(x)) for c, x in zip(self.contacts, parts, strict=True)]

    def holds(self, virtual: RationalVector, ranges: Sequence[RationalVector]) -> bool:
        """Return whether a leaf holds for all grasps in the cell with these ranges."""
        corners, way = [self.at(y) for y in corners_of(ranges)], primitive(virtual)
        if self.closed and any(dot(way, load) <= 0 for _, load, _ in corners):
            return False
        unit, *wrench = self.wrench
        load = dot(wrench, way) << BITS
        work = [load * share // unit for share, *_ in corners]
        for i, contact in enumerate(self.contacts):
            here = [contacts[i] for *_, contacts in corners]
            if self.rest and None in here:
                return False
            if self.rest:
                more = [contact.rest_work(way, forces) for forces in here]
            else:
                more = contact.works(way, here)
            work = [x + y for x, y in zip(work, more, strict=True)]
        return all(x > 0 or x == 0 == share for x, (share, *_) in zip(work, corners, strict=True))


def _whole(rows: Sequence[Sequence[Fraction | int]]) -> list[list[int]]:
    """Return one positive multiple of all rows in integers."""
    unit = math.lcm(*(x.denominator for row in rows for x in row))
    return [[int(x * unit) for x in row] for row in rows]


def corners_of(ranges: Sequence[RationalVector]) -> Iterator[RationalVector]:
    """Yield the corners of a cell."""
    return product(*map(dict.fromkeys, ranges))


def halves(ranges: Sequence[RationalVector], k: int) -> Iterator[list[RationalVector]]:
    """Yield the two halves of a cell."""
    low, high = ranges[k]
    middle = (low + high) / 2
    for half in ((low, middle), (middle, high)):
        yield [*ranges[:k], half, *ranges[k + 1 :]]


def robust_problem(
    document: Mapping[str, Any], grasp: Grasp, wrench: RationalVector
) -> tuple[str, int]:
    """Return what is wrong with a proof for all grasps within bounds, or nothing; and its leaves.

    Raises:
        InputError: this is no such proof, whatever its numbers are.
    """
    yes = document["certificate"] == "resisted"
    form = document["box"]
    middle = "forces" if isinstance(form, Mapping) and "forces" in form else "centre"
    check_keys(form, (middle, "axes", "loads") if yes else ("scales",), (), "box")
    box = Box(grasp, wrench, read_bounds(document), form)
    faces, n = list(box.faces()), len(wrench)
    nodes = check_list(document["faces"], "faces", len(faces))
    waiting = [
        (node, f"faces[{i}]", 0, fixed, ranges)
        for i, (node, (fixed, ranges)) in enumerate(zip(nodes, faces, strict=True))
    ]
    problem, leaves = "", 0
    while waiting:
        node, path, depth, fixed, ranges = waiting.pop()
        if isinstance(node, (list, tuple)):
            leaves += 1
            virtual = _vector(node, n, path)
            if not problem and not box.holds(virtual, ranges):
                problem = f"{path}: the leaf does not hold for all grasps within the bounds"
            continue
        check_keys(node, ("cut", "children"), (), path)
        k, children = node["cut"], check_list(node["children"], f"{path}.children", 2)
        if type(k) is not int or not 0 <= k < len(ranges) or k == fixed or depth == MOST_CUTS:
            raise CertificateError(
                f"{path}: a cell is cut up to {MOST_CUTS} times, along what it does not fix"
            )
        for i, (child, half) in enumerate(zip(children, halves(ranges, k), strict=True)):
            waiting.append((child, f"{path}.children[{i}]", depth + 1, fixed, half))
    return problem, leaves


def read_bounds(document: Mapping[str, Any]) -> Bounds:
    """Return the bounds of a proof."""
    check_keys(document["bounds"], (), tuple(LARGEST), "bounds")
    return Bounds(**document["bounds"])


def _vector(value: Any, length: int, where: str) -> RationalVector:
    return rational_vector(check_list(value, where, length), where)
