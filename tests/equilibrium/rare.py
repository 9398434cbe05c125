"""Seeded questions (grasp, wrench) in space that are not in general position, by kind.

Contacts in one plane, huge friction, stiffness of all sizes, no friction or some without, contacts
on a floor, on a line, on a box, in one point, or with normals that meet in one.
"""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

from equilibrium import Contact, Grasp
from equilibrium.grasps.inputs.random import random_grasp

from . import degenerate

Vector = tuple[Fraction, ...]
AXES = [tuple(Fraction(s * (j == k)) for j in range(3)) for k in range(3) for s in (1, -1)]
SLANTED = [(Fraction(3, 5), Fraction(4, 5), Fraction(0)), (Fraction(2, 3),) * 2 + (Fraction(1, 3),)]
#: Quaternions of rotations with rational entries.
TURNS = [(1, 0, 0, 0), (1, 1, 0, 0), (1, 1, 1, 1), (2, 1, 0, 0), (2, 1, 2, 0), (3, 1, 2, 5)]


def question(kind: str, seed: int) -> tuple[Grasp, Vector]:
    """Return the question of a seed."""
    source = Random(f"exotic {kind} {seed}")
    if kind == "plane":
        return _plane(source, seed)
    grasp = KINDS[kind](source, 2 + seed % 3)
    return grasp, source.choice([_free, _zero, _cones, _cones, _near, _near])(source, grasp)


def turned(
    grasp: Grasp, wrench: Vector, turn: tuple[int, ...], step: Vector
) -> tuple[Grasp, Vector]:
    """Return a question in space after a rotation and a translation."""
    a, b, c, d = turn
    size = a * a + b * b + c * c + d * d
    rows = [
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    ]

    def rotated(v: Vector) -> Vector:
        return tuple(
            sum((x * y for x, y in zip(row, v, strict=True)), Fraction(0)) / size for row in rows
        )

    contacts = [
        Contact(
            [x + y for x, y in zip(rotated(c.point), step, strict=True)],
            rotated(c.normal),
            c.friction,
            c.stiffness,
            c.preload,
        )
        for c in grasp
    ]
    force, torque = rotated(wrench[:3]), rotated(wrench[3:])
    (p, q, r), (x, y, z) = step, force
    moment = (q * z - r * y, r * x - p * z, p * y - q * x)
    return Grasp(contacts), (*force, *(s + t for s, t in zip(torque, moment, strict=True)))


def _plane(source: Random, seed: int) -> tuple[Grasp, Vector]:
    flat = degenerate.question(seed)
    x, y, torque = flat.wrench
    zero = Fraction(0)
    step = tuple(Fraction(source.randint(-2, 2), 2) for _ in range(3))
    wrench = (x, y, zero, zero, zero, torque)
    return turned(flat.grasp.in_space(), wrench, source.choice([TURNS[0], *TURNS]), step)


def _zero(_: Random, __: Grasp) -> Vector:
    return (Fraction(0),) * 6


def _free(source: Random, _: Grasp) -> Vector:
    return tuple(Fraction(source.randint(-4, 4), 2) for _ in range(6))


def _cones(source: Random, grasp: Grasp) -> Vector:
    """Return the negative of a sum of simple forces in the cones, their boundaries included."""
    total = _zero(source, grasp)
    for contact in grasp:
        push = Fraction(source.randint(0, 2))
        share = source.choice([(0, 0), (1, 0), (0, -1), ("3/5", "-4/5"), ("1/2", "1/2")])
        total = _with_forces(total, contact, push, [Fraction(x) for x in share])
    return total


def _near(source: Random, grasp: Grasp) -> Vector:
    """Return what forces inside the cones balance, of the size of the preloads if there are any."""
    total = _zero(source, grasp)
    for contact in grasp:
        push = (contact.preload or 1) * Fraction(source.randint(0, 24), 16)
        share = [Fraction(source.randint(-11, 11), 16) for _ in range(2)]
        total = _with_forces(total, contact, push, share)
    return total


def _with_forces(total: Vector, contact: Contact, push: Fraction, share: list[Fraction]) -> Vector:
    # A huge friction is not made use of.
    friction = (x * push * min(contact.friction, Fraction(1)) for x in share)
    return degenerate.less(total, contact, push, *friction)


def _values(source: Random) -> dict[str, Fraction]:
    return {
        "friction": source.choice([Fraction(0), Fraction(1, 2), Fraction(1, 2), Fraction(1)]),
        "stiffness": Fraction(source.choice([1, 1, 2])),
        "preload": Fraction(source.choice([0, 0, 1])),
    }


def _around(source: Random, m: int) -> Grasp:
    return random_grasp(m, source.randrange(10**6), dimension=3)


def _changed(source: Random, m: int, **values: Callable[[Contact], Fraction]) -> Grasp:
    """Return a random grasp, or one on a coarse grid, with other values."""
    grasp = source.choice([_around, _grid])(source, m)
    return Grasp(replace(c, **{name: value(c) for name, value in values.items()}) for c in grasp)


def _grid(source: Random, m: int) -> Grasp:
    points = [tuple(Fraction(source.randint(-1, 1)) for _ in range(3)) for _ in range(m)]
    return Grasp(Contact(p, source.choice([*AXES, *SLANTED]), **_values(source)) for p in points)


def _huge_friction(source: Random, m: int) -> Grasp:
    sizes = [1, 10, 10**3, 10**6, 10**12]
    return _changed(source, m, friction=lambda c: (c.friction or 1) * source.choice(sizes))


def _unequal_stiffness(source: Random, m: int) -> Grasp:
    return _changed(
        source, m, stiffness=lambda c: c.stiffness * Fraction(10) ** source.randint(-3, 3)
    )


def _no_friction(source: Random, m: int) -> Grasp:
    return _changed(source, m, friction=lambda _: Fraction(0))


def _some_friction(source: Random, m: int) -> Grasp:
    return _changed(source, m, friction=lambda c: c.friction * source.randint(0, 1))


def _floor(source: Random, m: int) -> Grasp:
    return Grasp(
        Contact([source.randint(-1, 1), source.randint(-1, 1), 0], AXES[4], **_values(source))
        for _ in range(m)
    )


def _line(source: Random, m: int) -> Grasp:
    """Points of the x axis, or of a slanted line; normals along axes, or some other one."""
    along = source.choice([(1, 0, 0), (1, 2, 2)])
    return Grasp(
        Contact(
            [source.randint(-2, 2) * x for x in along],
            source.choice([*AXES, *SLANTED]),
            **_values(source),
        )
        for _ in range(m)
    )


def _box(source: Random, m: int) -> Grasp:
    """Points on the faces of a cube, at its corners or in the middle of edges and faces too."""
    contacts = []
    for _ in range(m + 1):
        axis, side = source.randrange(3), source.choice((1, -1))
        point = [source.randint(-1, 1) for _ in range(3)]
        point[axis] = side
        normal = [-side * int(j == axis) for j in range(3)]
        contacts.append(Contact(point, normal, **_values(source)))
    return Grasp(contacts)


def _one_point(source: Random, m: int) -> Grasp:
    point = [source.randint(-1, 1) for _ in range(3)]
    return Grasp(
        Contact(point, source.choice([*AXES, *SLANTED]), **_values(source)) for _ in range(m)
    )


def _common_point(source: Random, m: int) -> Grasp:
    """Normals to one point, as of contacts on a ball."""
    grasp = _around(source, m)
    contacts = []
    for contact in grasp:
        distance = source.choice([HALF, Fraction(1)])
        point = [-distance * x for x in contact.normal]
        contacts.append(Contact(point, contact.normal, **_values(source)))
    return Grasp(contacts)


HALF = Fraction(1, 2)
KINDS: dict[str, Callable[[Random, int], Grasp]] = {
    "plane": lambda source, m: degenerate.question(source.randrange(10**6)).grasp.in_space(),
    "huge friction": _huge_friction,
    "unequal stiffness": _unequal_stiffness,
    "no friction": _no_friction,
    "some friction": _some_friction,
    "floor": _floor,
    "line": _line,
    "box": _box,
    "one point": _one_point,
    "common point": _common_point,
}
