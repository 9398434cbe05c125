"""Which wrenches of a plane a method accepts: exact unions of polygons, to set side by side.

A method accepts a wrench when some motion and forces meet linear conditions. With its case
distinctions fixed, the accepted wrenches are the image of a polyhedron under a linear map. Here
are the methods with few cases; the others have only their verdict on single wrenches.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import product
from math import lcm
from typing import Any

from arrangement.exact import IntegerVector, RationalVector, dot, primitive, shown
from arrangement.linprog import Row
from arrangement.polyhedra.cones import generators
from arrangement.polyhedra.polyhedron import Polyhedron, from_generators
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.wrench_sets.plane import FORCES as FORCES, Region, resistible_region
from equilibrium.wrench_sets.space import Piece, maximal_pieces

from .cones import attached_choices
from .frictionless_slip import STATES, forms_of, legal_rows
from .grasp_wrench_space import GraspWrenchSpace, cone_edges
from .springs import (
    Form,
    balance_rows,
    balancing_friction,
    cone_rows,
    normal_form,
    rest_forces,
    tangential_form,
    tangential_stiffnesses,
)

#: Up to here all 3^m choices of the method with frictionless slip are tried.
MOST_FOR_ALL_CHOICES = 6
_APEX: IntegerVector = (0, 0, 0, 1)


def method_region(
    method: str,
    grasp: Grasp,
    spans: Sequence[Iterable[Any]] = FORCES,
    origin: Iterable[Any] = (0, 0, 0),
) -> Region:
    """Return the wrenches ``origin + a spans[0] + b spans[1]`` that a method accepts.

    Args:
        method: a key of `METHODS`. ``wrench-space-L1`` and ``wrench-space-Linf`` bound the normal
            forces by 1, in sum or each; the conventions of the others are those of `compare`.

    Raises:
        GraspError: an unknown method, too many contacts for it, or parallel spans.

    >>> from equilibrium.io.files import read_grasp
    >>> method_region("weak", read_grasp("paper-three-contacts")).unlimited[0].whole
    True
    """
    if method not in METHODS:
        raise GraspError(f"method is {shown(method)}; known are {', '.join(METHODS)}")
    if method == "complete":
        return resistible_region(grasp, spans, origin)
    frame, start = [read_wrench(span) for span in spans], read_wrench(origin)
    cuts = (shape.cut(start, frame) for shape in METHODS[method](grasp) if shape is not None)
    pieces = maximal_pieces([Piece((), shape) for shape in cuts if shape is not None])
    return Region(start, (frame[0], frame[1]), pieces)


Shapes = Iterator[Polyhedron | None]


def _weak(grasp: Grasp) -> Shapes:
    rays = [(*_opposite(edge), 0) for c in grasp for edge in cone_edges(c)]
    yield from_generators([_APEX, *rays], (), 3)


def _frictionless(grasp: Grasp) -> Shapes:
    rays = [(*_opposite(c.normal_wrench), 0) for c in grasp]
    yield from_generators([_APEX, *rays], (), 3)


def _wrench_space_l1(grasp: Grasp) -> Shapes:
    vertices = GraspWrenchSpace(grasp, "L1").hull.vertices
    yield from_generators([_homogeneous(v) for v in vertices], (), 3)


def _wrench_space_linf(grasp: Grasp) -> Shapes:
    vertices = GraspWrenchSpace(grasp, "Linf").hull.vertices
    yield from_generators([_homogeneous(v) for v in vertices], (), 3)


def _cones(grasp: Grasp) -> Shapes:
    """One polyhedron for each choice of attached contacts, as in `limits.images`.

    In a region the wrench is linear in the motion and the friction forces, whose limits are linear
    in the motion: the extreme wrenches come from extreme motions with extreme friction.
    """
    for attached in attached_choices(grasp):
        rows, touching = [_APEX], []
        for contact, touches in zip(grasp, attached, strict=True):
            form = normal_form(contact)
            rows.append(primitive(form if touches else [-x for x in form]))
            if touches:
                touching.append((form, cone_edges(contact)))
        # Along a line of the region no touching spring changes, so the wrench does not either.
        rays, _ = generators(rows, [], 4)
        images = {image for ray in rays for image in _extreme_wrenches(touching, ray)}
        yield from_generators(images, (), 3)


def _extreme_wrenches(
    touching: Sequence[tuple[Form, tuple[RationalVector, RationalVector]]], motion: IntegerVector
) -> Iterator[IntegerVector]:
    forces = [Fraction(dot(form, motion)) for form, _ in touching]
    for edges in product(*(pair for _, pair in touching)):
        wrench = [
            -sum((f * edge[k] for f, edge in zip(forces, edges, strict=True)), Fraction(0))
            for k in range(3)
        ]
        if any(wrench) or motion[3]:
            yield primitive([*wrench, Fraction(motion[3])])


def _linear_compliance(grasp: Grasp) -> Shapes:
    springs = _springs(grasp)
    rows = [
        row
        for contact, (normal, tangential) in zip(grasp, springs, strict=True)
        for row in cone_rows(contact, normal, tangential)
    ]
    yield _image(grasp, springs, rows)


def _frictionless_slip(grasp: Grasp) -> Shapes:
    if len(grasp) > MOST_FOR_ALL_CHOICES:
        raise GraspError(
            f"{len(grasp)} contacts are too many for 3^m polyhedra; "
            f"at most {MOST_FOR_ALL_CHOICES} are tried"
        )
    springs = _springs(grasp)
    for states in product(STATES, repeat=len(grasp)):
        forms = [forms_of(state, pair) for state, pair in zip(states, springs, strict=True)]
        yield _image(grasp, forms, legal_rows(grasp, states, springs, True))


def _springs(grasp: Grasp) -> list[tuple[Form, Form]]:
    """Return the springs as `compare` takes them: friction at rest balances the preloads."""
    stiffnesses = tangential_stiffnesses(grasp, 1)
    rest = rest_forces(grasp, balancing_friction(grasp))
    triples = zip(grasp, stiffnesses, rest, strict=True)
    return [(normal_form(contact), tangential_form(contact, k, t)) for contact, k, t in triples]


def _image(
    grasp: Grasp, forms: Sequence[tuple[Form, Form]], rows: Iterable[Row]
) -> Polyhedron | None:
    """Return the wrenches that forces linear in the motion balance, under conditions on it."""
    conditions = [primitive([Fraction(x) for x in row]) for row in rows]
    rays, lines = generators([_APEX, *conditions], [], 4)
    if not any(ray[3] for ray in rays):
        return None
    balance = balance_rows(grasp, forms, (Fraction(0),) * 3)
    images = [_mapped(balance, ray) for ray in rays]
    straight = [_mapped(balance, line) for line in lines]
    return from_generators([x for x in images if any(x)], [x for x in straight if any(x)], 3)


def _mapped(balance: Sequence[Row], motion: IntegerVector) -> IntegerVector:
    wrench = [-Fraction(dot(row, motion)) for row in balance]
    return primitive([*wrench, Fraction(motion[3])])


def _opposite(wrench: RationalVector) -> IntegerVector:
    return tuple(-x for x in primitive(wrench))


def _homogeneous(vertex: RationalVector) -> IntegerVector:
    """Return the wrench that a point of a wrench space balances, as a homogeneous point."""
    scale = lcm(*(x.denominator for x in vertex))
    return (*(int(-x * scale) for x in vertex), scale)


#: Every method with an exact region, and how to get its polyhedra.
METHODS: dict[str, Callable[[Grasp], Shapes]] = {
    "complete": lambda _: iter(()),
    "cones": _cones,
    "wrench-space-L1": _wrench_space_l1,
    "wrench-space-Linf": _wrench_space_linf,
    "weak": _weak,
    "frictionless": _frictionless,
    "linear-compliance": _linear_compliance,
    "frictionless-slip": _frictionless_slip,
}
