"""Textbook assemblies with exact angles: each returns an assembly and the wrenches of its weights.

An angle is given by the tangent q of its half: its cosine ``(1 - q^2) / (1 + q^2)`` and its sine
``2 q / (1 + q^2)`` are rational then. The angle itself has the tangent ``2 q / (1 - q^2)``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Annotated, TypeAlias

from arrangement.console.options.signature import Syntax
from arrangement.console.options.values import rational_argument
from arrangement.numbers.exact import Rational, RationalVector, rational, shown
from equilibrium.model.assembly import Assembly, BodyContact, RigidBody, Wrenches
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle, Polygon, Segments
from equilibrium.model.unit_normal import of_half_tangent, unit_normal

from .inputs.touching import Shape, touching

#: An exact number, on a command line too.
Number: TypeAlias = Annotated[Rational, Syntax(rational_argument, "Q")]

#: Joints of an arch are this close to even angles: the tangent of the error.
_EVEN = "1/1000"
_MAX_BODIES = 200


def stack(
    *, blocks: int = 2, friction: Number = "1/2", weight: Number = 1, push: Number = 0
) -> tuple[Assembly, Wrenches]:
    """Return blocks of width 2 and height 1 on each other, the topmost pushed to the right.

    Args:
        blocks: how many.
        friction: of all contacts.
        weight: of each block.
        push: on the topmost block, in its middle.

    >>> from equilibrium import solve
    >>> [solve(*stack(blocks=3, push=push)).verdict for push in ("1/2", "3/5")]
    ['resisted', 'not resisted']
    """
    _check_count(blocks, "blocks", 1)
    load, side = rational(weight, "weight"), rational(push, "push")
    bodies, contacts = list[RigidBody](), list[BodyContact]()
    wrenches: Wrenches = {}
    for k in range(blocks):
        name, below = f"block {k + 1}", f"block {k}" if k else None
        bodies.append(RigidBody(name, Polygon([(-1, k), (1, k), (1, k + 1), (-1, k + 1)])))
        contacts += _contacts(name, below, [(-1, k), (1, k)], (0, 1), friction)
        wrenches[name] = (Fraction(0), -load, Fraction(0))
    wrenches[name] = (side, -load, -side * (blocks - Fraction(1, 2)))
    return Assembly(bodies, contacts), wrenches


def arch(
    *,
    voussoirs: int = 5,
    friction: Number = "1/2",
    inner: Number = 4,
    outer: Number = 5,
    weight: Number = 1,
) -> tuple[Assembly, Wrenches]:
    """Return a round arch of voussoirs with radial joints, two contacts each.

    Args:
        voussoirs: how many; the joints are at even angles, up to a thousandth.
        friction: of all contacts.
        inner, outer: radii.
        weight: of each voussoir, in the mean of its corners.
    """
    _check_count(voussoirs, "voussoirs", 2)
    radii = [rational(inner, "inner"), rational(outer, "outer")]
    if not 0 < radii[0] < radii[1]:
        raise GraspError(
            f"the radii are {shown(radii[0])} and {shown(radii[1])}; expected 0 < inner < outer"
        )
    load = rational(weight, "weight")
    joints = [_joint(k, voussoirs) for k in range(voussoirs + 1)]
    bodies, contacts = list[RigidBody](), list[BodyContact]()
    wrenches: Wrenches = {}
    for k in range(voussoirs):
        name, before = f"voussoir {k + 1}", f"voussoir {k}" if k else None
        left, right = (joints[j] for j in (k, k + 1))
        corners = [
            tuple(r * x for x in ray)
            for ray, pair in ((left, radii), (right, radii[::-1]))
            for r in pair
        ]
        bodies.append(RigidBody(name, Polygon(corners)))
        contacts += _contacts(name, before, corners[:2], (left[1], -left[0]), friction)
        middle = sum((x for x, _ in corners), Fraction(0)) / 4
        wrenches[name] = (Fraction(0), -load, -load * middle)
    # The corners go round: those of the last joint come from outside.
    contacts += _contacts(name, None, corners[:1:-1], (-right[1], right[0]), friction)
    return Assembly(bodies, contacts), wrenches


def wall(
    *,
    courses: int = 4,
    bricks: int = 4,
    friction: Number = "1/2",
    overhang: bool = False,
    density: Number = 2,
) -> tuple[Assembly, Wrenches]:
    """Return a wall of bricks of width 1 and height 1/2 on the ground, in running bond.

    Args:
        courses: how many.
        bricks: in a course.
        friction: of all contacts.
        overhang: whether every other course hangs over by half a brick; else it has half bricks at
            its ends.
        density: weight by area.

    >>> from equilibrium import solve
    >>> solve(*wall(courses=3, bricks=2, friction="1/10")).verdict
    'resisted'
    """
    _check_count(courses, "courses", 1)
    _check_count(bricks, "bricks", 1)
    _check_count(courses * bricks, "bricks in all", 1)
    height, bodies = Fraction(1, 2), dict[str, list[tuple[Fraction, Fraction]]]()
    for k in range(courses):
        shift = Fraction(k % 2, 2)
        joints = [shift + j for j in range(bricks + 1)]
        if shift and not overhang:
            joints = [Fraction(0), *joints[:-1], Fraction(bricks)]
        low, high = k * height, (k + 1) * height
        for j, (left, right) in enumerate(pairwise(joints), 1):
            corners = [(left, low), (right, low), (right, high), (left, high)]
            bodies[f"brick {k + 1}.{j}"] = corners
    ground = [(-1, -1), (bricks + 1, -1), (bricks + 1, 0), (-1, 0)]
    made = Assembly.from_polygons(bodies, friction=friction, ground=[ground], density=density)
    return made, made.weights


def wedge(
    *,
    half_tangent: Number = "1/3",
    friction: Number = "1/3",
    ground: Number = "1/3",
    weight: Number = 1,
) -> tuple[Assembly, Wrenches]:
    """Return a wedge between the ground and a block that a smooth vertical wall guides.

    It locks itself if its angle is at most the sum of the friction angles of its two faces.

    Args:
        half_tangent: tangent of half the angle of the wedge, above 0 and below 1.
        friction: between wedge and block.
        ground: friction between wedge and ground.
        weight: of the block.

    >>> from equilibrium import solve
    >>> [solve(*wedge(ground=ground)).verdict for ground in ("1/3", "33/100")]
    ['resisted', 'not resisted']
    """
    load, (c, s) = rational(weight, "weight"), _angle(half_tangent, Fraction(0))
    face = [(2 * c, 2 * s), (4 * c, 4 * s)]
    top = 4 * s + 2
    bodies = [
        RigidBody("wedge", Polygon([(0, 0), (4 * c, 0), face[1]])),
        RigidBody("block", Polygon([(0, 0), face[1], (4 * c, top), (0, top)])),
    ]
    contacts = _contacts("wedge", None, [(c, 0), (4 * c, 0)], (0, 1), ground)
    contacts += _contacts("block", "wedge", face, (-s, c), friction)
    contacts += _contacts("block", None, [(0, top / 2), (0, top)], (1, 0), 0)
    wrenches: Wrenches = {"wedge": (Fraction(0),) * 3, "block": (Fraction(0), -load, -2 * c * load)}
    return Assembly(bodies, contacts), wrenches


def cylinders(
    *,
    half_tangent: Number = "1/3",
    friction: Number = "1/3",
    ground: Number = "1/9",
    weight: Number = 1,
) -> tuple[Assembly, Wrenches]:
    """Return a cylinder on two equal ones that do not touch each other.

    It needs a friction of tan(a / 2) between cylinders, and a third of that on the ground, for the
    angle a between the contact normals and the vertical.

    Args:
        half_tangent: tan(a / 2), from 0.268 (the lower ones touch) to below 1.
        friction: between cylinders.
        ground: friction on the ground.
        weight: of each.

    >>> from equilibrium import solve
    >>> [solve(*cylinders(ground=ground)).verdict for ground in ("1/9", "1/10")]
    ['resisted', 'not resisted']
    """
    load, (c, s) = rational(weight, "weight"), _angle(half_tangent, Fraction(1, 2))
    one, none = Fraction(1), Fraction(0)
    centres = {"top": (none, 1 + 2 * c), "left": (-2 * s, one), "right": (2 * s, one)}
    circles = {name: Circle(place, 1) for name, place in centres.items()}
    floor = Segments([[(-4, 0), (4, 0)]])
    contacts = touching(
        [*map(Shape, circles, circles.values()), Shape("floor", floor, False)],
        lambda _, other: {"friction": ground if other == "floor" else friction},
    )
    bodies = [RigidBody(name, circle, load) for name, circle in circles.items()]
    made = contacts.assembly(bodies, [floor])
    return made, made.weights


def ladder(
    *,
    friction: Number = "3/8",
    face: Number = 0,
    block: Number = "1/4",
    weight: Number = 8,
    block_weight: Number = 12,
) -> tuple[Assembly, Wrenches]:
    """Return a ladder of rise 4 and run 3 that leans on a block on the ground.

    Args:
        friction: of the foot of the ladder.
        face: friction between ladder and block.
        block: friction between block and ground.
        weight: of the ladder, in its middle.
        block_weight: of the block, in its middle.

    >>> from equilibrium import solve
    >>> [solve(*ladder(block_weight=weight)).verdict for weight in (12, "119/10")]
    ['resisted', 'not resisted']
    """
    loads = rational(weight, "weight"), rational(block_weight, "block_weight")
    bodies = [
        RigidBody("ladder", Polygon([(0, 0), (3, 4), ("29/10", 4)])),
        RigidBody("block", Polygon([(3, 0), (5, 0), (5, 5), (3, 5)])),
    ]
    contacts = [
        BodyContact("ladder", None, Contact((0, 0), (0, 1), friction)),
        BodyContact("ladder", "block", Contact((3, 4), (-1, 0), face)),
        *_contacts("block", None, [(3, 0), (5, 0)], (0, 1), block),
    ]
    places = Fraction(3, 2), Fraction(4)
    pairs = zip(("ladder", "block"), loads, places, strict=True)
    return Assembly(bodies, contacts), {n: (Fraction(0), -w, -w * x) for n, w, x in pairs}


def ramp(
    *,
    half_tangent: Number = "1/3",
    friction: Number = "3/4",
    ground: Number = "1/2",
    weight: Number = 1,
    push: Number = 0,
) -> tuple[Assembly, Wrenches]:
    """Return a block on a ramp that lies on the ground.

    The block slides if the tangent of the angle is above the friction; a push on it, level and
    towards the ramp, is borne by the friction on the ground, which carries both weights.

    Args:
        half_tangent: tangent of half the angle of the ramp, above 0 and below 1.
        friction: between block and ramp.
        ground: friction between ramp and ground.
        weight: of the block and of the ramp, each.
        push: on the block, in the middle of its contacts.

    >>> from equilibrium import solve
    >>> [solve(*ramp(friction=friction)).verdict for friction in ("3/4", "74/100")]
    ['resisted', 'not resisted']
    >>> [solve(*ramp(push=push)).verdict for push in (1, "11/10")]
    ['resisted', 'not resisted']
    """
    load, side = rational(weight, "weight"), rational(push, "push")
    c, s = _angle(half_tangent, Fraction(0))
    foot, top = [(2 * c, 2 * s), (4 * c, 4 * s)], [(4 * c - s, 4 * s + c), (2 * c - s, 2 * s + c)]
    bodies = [
        RigidBody("ramp", Polygon([(0, 0), (6 * c, 0), (6 * c, 6 * s)])),
        RigidBody("block", Polygon([*foot, *top])),
    ]
    contacts = _contacts("ramp", None, [(0, 0), (6 * c, 0)], (0, 1), ground)
    contacts += _contacts("block", "ramp", foot, (-s, c), friction)
    none = Fraction(0)
    wrenches: Wrenches = {
        "ramp": (none, -load, -4 * c * load),
        "block": (side, -load, -(3 * c - s / 2) * load - 3 * s * side),
    }
    return Assembly(bodies, contacts), wrenches


def tongs(
    *, friction: Number = "1/2", squeeze: Number = 1, weight: Number = 1
) -> tuple[Assembly, Wrenches]:
    """Return two jaws of tongs that squeeze and lift a block; nothing touches the ground.

    The block slips out if twice the squeeze times the friction is less than its weight.

    Args:
        friction: between jaws and block.
        squeeze: force on either jaw, towards the block.
        weight: of the block; either jaw is held up by half of it, in its middle.

    >>> from equilibrium import solve
    >>> [solve(*tongs(squeeze=squeeze)).verdict for squeeze in (1, "99/100")]
    ['resisted', 'not resisted']
    """
    load, force = rational(weight, "weight"), rational(squeeze, "squeeze")
    bodies = [RigidBody("block", Polygon([(-1, 0), (1, 0), (1, 2), (-1, 2)]))]
    contacts = list[BodyContact]()
    wrenches: Wrenches = {"block": (Fraction(0), -load, Fraction(0))}
    for name, side in (("left", -1), ("right", 1)):
        corners = [(side, 0), (2 * side, 0), (2 * side, 2), (side, 2)]
        bodies.append(RigidBody(name, Polygon(corners)))
        contacts += _contacts("block", name, [(side, 0), (side, 2)], (-side, 0), friction)
        # The force acts at half of the height.
        wrenches[name] = (-side * force, load / 2, side * (force + Fraction(3, 4) * load))
    return Assembly(bodies, contacts), wrenches


#: All of them, by name.
TEXTBOOK = {
    made.__name__: made for made in (stack, wall, arch, ramp, wedge, cylinders, ladder, tongs)
}


def _contacts(
    name: str,
    other: str | None,
    places: Iterable[Sequence[Rational]],
    normal: Sequence[Rational],
    friction: Rational,
) -> list[BodyContact]:
    """Return contacts with one normal, which points into the first body."""
    return [BodyContact(name, other, Contact(place, normal, friction)) for place in places]


def _joint(k: int, count: int) -> RationalVector:
    """Return the unit vector of a joint, from the left springing; both sides mirror each other."""
    if 2 * k == count:
        return (Fraction(0), Fraction(1))
    if 2 * k > count:
        x, y = _joint(count - k, count)
        return (-x, y)
    angle = math.pi * k / count
    return unit_normal((-math.cos(angle), math.sin(angle) if k else 0.0), _EVEN).normal


def _angle(half_tangent: Rational, least: Fraction) -> tuple[Fraction, Fraction]:
    """Return cosine and sine of an angle below a right one whose sine is above a least one."""
    q = rational(half_tangent, "half_tangent")
    if not 0 < q < 1 or of_half_tangent(q)[1] < least:
        due = "above 0 and below 1" if not least else "from 0.268 to below 1"
        raise GraspError(f"half_tangent is {shown(q)}; expected a number {due}")
    return of_half_tangent(q)


def _check_count(count: int, name: str, least: int) -> None:
    if type(count) is not int or not least <= count <= _MAX_BODIES:
        raise GraspError(
            f"{name} is {shown(count)}; expected a whole number from {least} to {_MAX_BODIES}"
        )
