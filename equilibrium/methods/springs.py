"""Linear compliance, and the same with frictionless slip: forces as linear rows in the motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from typing import Any, TypeAlias

from arrangement.numbers import budget
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    dot,
    primitive,
    rational,
    rational_vector,
)
from arrangement.numbers.linear.cones import generators
from arrangement.numbers.linear.polyhedron import Polyhedron, from_generators
from arrangement.numbers.linear.programs import some_point
from equilibrium.core.contact_rows import (
    Pair,
    balance_rows,
    cone_rows,
    negated,
    normal_force_row,
    unit_row,
    value,
)
from equilibrium.methods.method import Accepting, Decide, Method, Outcome, cut
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

#: The point zero as a homogeneous point; also the condition that a homogeneous point is one.
APEX: IntegerVector = (0, 0, 0, 1)
#: Normal and tangential force of each contact.
Forces: TypeAlias = tuple[RationalVector, ...]


def forces_at(pairs: Sequence[Pair], motion: RationalVector) -> Forces:
    """Return the forces at a motion."""
    return tuple((value(normal, motion), value(tangential, motion)) for normal, tangential in pairs)


def force_rows(contact: Contact, pair: Pair) -> list[RationalVector]:
    """Return ``c_n >= 0`` and ``|c_t| <= friction c_n`` as rows."""
    return [pair[0], *cone_rows(contact.friction, *pair)]


def balanced_wrenches(
    grasp: Grasp, pairs: Sequence[Pair], rows: Iterable[RationalVector]
) -> Polyhedron | None:
    """Return the wrenches that forces linear in the motion balance, under conditions on it."""
    rays, lines = generators([APEX, *map(primitive, rows)], [], 4)
    if not any(ray[3] for ray in rays):
        return None
    balance, unit = balance_rows(grasp, pairs, (Fraction(0),) * 3)

    def images(motions: Iterable[IntegerVector]) -> list[IntegerVector]:
        balanced = (([-dot(row, d) for row in balance], unit * d[3]) for d in motions)
        return [primitive([*wrench, h]) for wrench, h in balanced if h or any(wrench)]

    return from_generators(images(rays), images(lines), 3)


def springs_of(
    grasp: Grasp, factor: Any = 1, rest_friction: Iterable[Any] | None = None
) -> list[Pair]:
    """Return the normal and the tangential spring of each contact as rows in the motion.

    Args:
        factor: stiffness of a tangential spring over that of the normal one; above 0.
        rest_friction: the tangential forces at d = 0, one for each contact; none if omitted.
    """
    times = rational(factor, "factor")
    rest = [0] * len(grasp) if rest_friction is None else rest_friction
    forces = rational_vector(rest, "rest_friction")
    return [
        (normal_force_row(c), (*(-times * c.stiffness * x for x in c.tangential_wrench), t))
        for c, t in zip(grasp, forces, strict=True)
    ]


def usual_springs(grasp: Grasp) -> tuple[list[Pair], str]:
    """Return the springs that a comparison takes, with a remark.

    Tangential ones are as stiff as the normal ones, and at rest they balance the preloads where
    friction can.
    """
    rest = balancing_friction(grasp)
    if rest is None:
        remark = "no friction at rest, as none would balance the preloads"
    elif any(rest):
        remark = "friction at rest balances the preloads"
    else:
        remark = "no friction at rest"
    return springs_of(grasp, 1, rest), remark


def balancing_friction(grasp: Grasp) -> RationalVector | None:
    """Return tangential forces that balance the preloads at d = 0, if the cones allow it.

    Where several do, one corner of the set is returned. A grasp that was closed with its preloads
    and stood still has such forces; None says that no such grasp exists.

    >>> from equilibrium import read_grasp
    >>> [str(x) for x in balancing_friction(read_grasp("paper-three-contacts-preload-1"))]
    ['-1/2', '0', '1/2']
    """
    m = len(grasp)
    limits = [contact.friction * contact.preload for contact in grasp]
    cones = [
        (*(side * x for x in unit_row(i, m)[:-1]), limit)
        for i, limit in enumerate(limits)
        for side in (1, -1)
    ]
    at_rest = [((*[Fraction(0)] * m, c.preload), unit_row(i, m)) for i, c in enumerate(grasp)]
    balance, _ = balance_rows(grasp, at_rest, (Fraction(0),) * 3, m)
    if all(row[-1] == 0 for row in balance):
        return (Fraction(0),) * m
    return some_point(m, cones, balance)


def _with_usual_springs(decide: Callable[[Grasp, RationalVector, list[Pair]], Accepting]) -> Decide:
    def outcome(grasp: Grasp, wrench: RationalVector) -> Outcome:
        springs, remark = usual_springs(grasp)
        return decide(grasp, wrench, springs).accepts, remark

    return outcome


@dataclass(frozen=True)
class ComplianceVerdict(Accepting):
    """Whether the forces of the springs lie inside the cones.

    Attributes:
        accepts: they exist and do.
        motion: a motion that balances; None if the springs cannot (two contact points or more
            always can).
        forces: normal and tangential force of each contact, the same for all such motions.
        outside: the contacts whose force is outside the cone.
    """

    accepts: bool
    motion: RationalVector | None
    forces: Forces | None
    outside: tuple[int, ...]


def linear_compliance(
    grasp: Grasp, wrench: RationalVector, springs: list[Pair] | None = None
) -> ComplianceVerdict:
    """Decide by linear springs in both directions, exactly.

    Every contact has a linear spring in the normal and one in the tangential direction, both
    working both ways; the motion that balances a wrench solves one linear system, which determines
    all forces. The method accepts when these forces happen to lie inside the friction cones.
    Contacts neither slip nor let go, so a spring that leaves its cone makes the method refuse,
    right or wrong ([Bicchi1993], [Bicchi1994], [Bicchi1995], [Cutkosky1989]).

    Args:
        grasp: normal stiffness and preload are those of the contacts.
        wrench: applied.
        springs: of `springs_of`; those without a factor, and without friction at rest, if omitted.
    """
    springs = springs or springs_of(grasp)
    motion = some_point(3, [], balance_rows(grasp, springs, wrench)[0])
    if motion is None:
        return ComplianceVerdict(False, None, None, ())
    forces = forces_at(springs, motion)
    outside = tuple(
        i
        for i, (contact, (c_n, c_t)) in enumerate(zip(grasp, forces, strict=True))
        if c_n < 0 or abs(c_t) > contact.friction * c_n
    )
    return ComplianceVerdict(not outside, motion, forces, outside)


@cut
def _compliance_region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    springs, _ = usual_springs(grasp)
    pairs = zip(grasp, springs, strict=True)
    rows = [row for contact, pair in pairs for row in force_rows(contact, pair)]
    yield balanced_wrenches(grasp, springs, rows)


LINEAR_COMPLIANCE = Method(
    "linear-compliance",
    "linear compliance (Bicchi 1993-95; Cutkosky, Kao 1989)",
    "linear compliance",
    _with_usual_springs(linear_compliance),
    _compliance_region,
)


_ZERO: RationalVector = (Fraction(0),) * 4
#: What `frictionless_slip` lets a contact do.
STATES = ("stick", "slip", "detached")
#: Contact states; forces and conditions that are linear in the motion and what else is unknown.
Choice: TypeAlias = tuple[tuple[str, ...], Sequence[Pair], Sequence[RationalVector]]


@dataclass(frozen=True)
class StatesVerdict(Accepting):
    """Whether some choice of contact states has legal forces that balance a wrench.

    Attributes:
        accepts: one does.
        states, motion, forces: of the first that does; else None.
        tried: how many choices were looked at, all when the method refuses.
    """

    accepts: bool
    states: tuple[str, ...] | None
    motion: RationalVector | None
    forces: Forces | None
    tried: int


def frictionless_slip(
    grasp: Grasp, wrench: RationalVector, springs: list[Pair] | None = None
) -> StatesVerdict:
    """Decide by trying all 3^m choices of states, each exactly.

    Each contact is in one of three states ([Prattichizzo1997]). Stick: linear springs in both
    directions, the force inside the cone. Slip: the normal spring alone, no friction force at all.
    Detached: no force, where the normal spring would pull. Every choice of states gives one linear
    system in the motion; the method accepts when some choice has a legal solution.

    Args:
        grasp, wrench, springs: as in `linear_compliance`.

    Raises:
        OutOfReachError: too many contacts.
    """
    budget.check_size(len(grasp), "contacts with a choice of three states")
    tried = 0
    for tried, (states, pairs, rows) in enumerate(_choices(grasp, springs or springs_of(grasp)), 1):
        motion = some_point(3, rows, balance_rows(grasp, pairs, wrench)[0])
        if motion is not None:
            return StatesVerdict(True, states, motion, forces_at(pairs, motion), tried)
    return StatesVerdict(False, None, None, None, tried)


def _choices(grasp: Grasp, springs: list[Pair]) -> Iterator[Choice]:
    for states in product(STATES, repeat=len(grasp)):
        pairs, rows = list[Pair](), list[RationalVector]()
        for contact, state, (normal, tangential) in zip(grasp, states, springs, strict=True):
            if state == "detached":
                pairs.append((_ZERO, _ZERO))
                rows.append(negated(normal))
            elif state == "slip":
                pairs.append((normal, _ZERO))
                rows.append(normal)
            else:
                pairs.append((normal, tangential))
                rows += force_rows(contact, pairs[-1])
        yield states, pairs, rows


def check_states(grasp: Grasp) -> None:
    """Refuse more contacts than can have all choices of three states."""
    budget.check_cost(
        f"three states of each of {len(grasp)} contacts", steps=10_000 * budget.power(3, len(grasp))
    )


def _decide_frictionless(grasp: Grasp, wrench: RationalVector) -> Outcome:
    check_states(grasp)
    return _with_usual_springs(frictionless_slip)(grasp, wrench)


@cut
def _frictionless_region(grasp: Grasp) -> Iterator[Polyhedron | None]:
    check_states(grasp)
    springs, _ = usual_springs(grasp)
    for _, pairs, rows in _choices(grasp, springs):
        yield balanced_wrenches(grasp, pairs, rows)


FRICTIONLESS_SLIP = Method(
    "frictionless-slip",
    "stick, frictionless slip, detached (Prattichizzo 1997)",
    "frictionless slip",
    _decide_frictionless,
    _frictionless_region,
)
