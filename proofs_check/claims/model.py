"""Our own theorem: how many contact states the corrected model has (see docs/proofs)."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, product
from math import comb

from arrangement import counts
from arrangement.linear import determinant
from equilibrium.model.grasp import Contact, Grasp
from proofs_check.routes.fourier_motzkin import Row, project
from proofs_check.statement import Case, Claim, Route, proved

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


def _enumerated(grasp: Grasp) -> Faces:
    return grasp.motion_arrangement().f_vector


def _counted(grasp: Grasp) -> Faces:
    return counts.f_vector(grasp.motion_arrangement())


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
    return all(number <= bound for number, bound in zip(f, most, strict=True))


def _linear(grasp: Grasp, f: Faces) -> bool:
    """At most V points, 3V lines and 3V facets for V regions."""
    return all(f[k] <= comb(3, k) * f[3] for k in range(3))


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


def _grasps(rng: random.Random, most: int, *, preload: bool) -> Iterator[Case]:
    """Yield for each m two grasps in general position and two that need not be."""
    for m in range(1, most + 1):
        generic = 0
        plain = 0
        while generic < 2 or plain < 2:
            grasp = _random_grasp(rng, m, preload=preload)
            if _has_preload(grasp) != preload:
                continue
            if in_general_position(grasp) and generic < 2:
                generic += 1
                yield _case(grasp, "general position")
            elif plain < 2:
                plain += 1
                yield _case(grasp, "as drawn")


def _case(grasp: Grasp, remark: str) -> Case:
    return Case(f"m = {len(grasp)}, {remark}", grasp, grasp.to_dict())


def _states_of_faces(grasp: Grasp) -> int:
    """Different states of the contacts over all faces; the slip of a detached one is no state."""
    m = len(grasp)
    found = set()
    for face in grasp.motion_arrangement().faces():
        pairs = zip(face.signs[:m], face.signs[m:], strict=True)
        found.add(tuple("detached" if side >= 0 else slip for slip, side in pairs))
    return len(found)


def _states_by_elimination(grasp: Grasp) -> int:
    """Of all 4^m choices of states, those with a motion: strict conditions leave room e > 0."""
    options: list[tuple[tuple[list[Row], list[Row]], ...]] = []
    for contact in grasp:
        normal = tuple(contact.stiffness * x for x in contact.normal_wrench)
        gap: Row = (*normal, Fraction(0), -contact.preload)
        slip: Row = (*contact.tangential_wrench, Fraction(0), Fraction(0))
        attached = _with_room(gap, -1)
        options.append(
            (
                ([], [gap]),
                ([], [attached, _with_room(slip, 1)]),
                ([], [attached, _with_room(slip, -1)]),
                ([slip], [attached]),
            )
        )
    return sum(map(_possible, product(*options)))


def _with_room(row: Row, side: int) -> Row:
    """Return ``side * row - e >= 0``."""
    turned = [side * x for x in row]
    return (*turned[:3], Fraction(-1), turned[-1])


def _possible(chosen: tuple[tuple[list[Row], list[Row]], ...]) -> bool:
    """Whether e can be above 0."""
    equalities = [row for pair in chosen for row in pair[0]]
    inequalities = [row for pair in chosen for row in pair[1]]
    limit: Row = tuple(map(Fraction, (0, 0, 0, -1, 1)))
    rows = project(equalities, [*inequalities, limit], keep=3)
    return rows is not None and all(row[4] > 0 for row in rows if row[3] < 0)


def _few_states(grasp: Grasp, states: int) -> bool:
    return states <= sum(most_faces(len(grasp), preload=_has_preload(grasp)))


def _small(rng: random.Random) -> Iterator[Case]:
    for preload in (False, True):
        yield from _grasps(rng, 3, preload=preload)


_ROUTES = (
    Route("enumeration of all faces of 2m planes", _enumerated),
    Route("Zaslavsky's theorem on the intersection lattice", _counted),
)

CLAIMS = (
    Claim(
        id="model-faces-without-preload",
        locator="our theorem, after Section IV-A",
        statement="Without preload the m tangential and m normal planes have at most "
        "16m^2 - 8m + 3 faces: 1 origin, 2m(2m-1) rays, 4m(2m-1) facets, 4m^2 - 2m + 2 regions; "
        "these numbers are reached in general position for m >= 2.",
        hypotheses=("the corrected model", "all preloads are 0"),
        quantity="f-vector",
        routes=_ROUTES,
        judge=_within,
        sources=proved(
            "the numbers of random grasps of 1 to 7 contacts",
            lambda rng: _grasps(rng, 7, preload=False),
        ),
        meaning="The number of states stays quadratic when contacts may let go.",
    ),
    Claim(
        id="model-faces-with-preload",
        locator="our theorem, after Section IV-A",
        statement="With preload the m tangential and m normal planes, m >= 3, have at most "
        "C(2m,3) - C(m,3) + 1 points, C(m,2)(m+2) + (C(2m,2) - C(m,2))(2m-1) lines, "
        "m(2m-2 + sum_{j=m-1}^{2m-2} (1+j)) + m(2m + C(2m-1,2)) facets and "
        "m^2 - m + 2 + sum_{j=m}^{2m-1} (1+j+C(j,2)) regions, and these numbers are reached in "
        "general position.",
        hypotheses=("the corrected model", "for m < 3 the bound of Eq. 11 for 2m planes"),
        quantity="f-vector",
        routes=_ROUTES,
        judge=_within,
        sources=proved(
            "the numbers of random grasps of 1 to 5 contacts",
            lambda rng: _grasps(rng, 5, preload=True),
        ),
        meaning="With preload the number of states is cubic, about 28/3 m^3 at most; the planes of "
        "the paper alone do not describe it.",
    ),
    Claim(
        id="model-linear-by-regions",
        locator="our theorem, after Section IV-A",
        statement="With V regions of the motion there are at most V points, 3V lines and 3V facets "
        "of the 2m planes, with or without preload.",
        hypotheses=("the corrected model",),
        quantity="f-vector",
        routes=_ROUTES,
        judge=_linear,
        sources=proved(
            "the numbers of random grasps of 1 to 5 contacts",
            lambda rng: (
                case for preload in (False, True) for case in _grasps(rng, 5, preload=preload)
            ),
        ),
        meaning="The linear bound by V carries over to the corrected model.",
    ),
    Claim(
        id="model-states",
        locator="our theorem, after Section IV-A",
        statement="The contacts have at most as many states (detached, slip+, slip-, stick for "
        "each) under rigid motions as the maximal numbers of faces add up to.",
        hypotheses=("the corrected model",),
        quantity="number of states that some motion has",
        routes=(
            Route("signs of all faces, repeats dropped", _states_of_faces),
            Route("4^m choices by Fourier-Motzkin elimination", _states_by_elimination),
        ),
        judge=_few_states,
        sources=proved("counted on random grasps of 1 to 3 contacts", _small),
        meaning="Algorithm 2 with detachment is polynomial: quadratic, or cubic with preload.",
    ),
)
