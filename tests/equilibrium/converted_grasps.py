"""Exact grasps of common shapes, and the float data that a simulator or a table would give."""

from fractions import Fraction
from random import Random
from typing import Any

from arrangement.numbers.exact import RationalVector, dot
from arrangement.numbers.linear.rank import cross
from equilibrium import Contact, Grasp, unit_normal
from equilibrium.grasps.inputs import Conversion, from_float_data

SHAPES = ("circle", "ellipse", "polygon", "box", "box in space", "ball")
#: The unit of length, metres or millimetres, of objects of some three centimetres.
UNITS = (Fraction(1, 1000), Fraction(1))


def original(shape: str, seed: int) -> tuple[Grasp, RationalVector]:
    """Return an exact grasp of a shape, and a load."""
    source = Random(f"{shape} {seed}")
    unit = UNITS[seed % 2]
    friction = source.choice([Fraction(0), Fraction(0), Fraction(1, 5), Fraction(1, 2)])
    preload = source.choice([Fraction(0), Fraction(1)])
    places = _PLACES[shape](source)
    n = len(places[0][0])
    shift = [source.choice([0, 0, source.randint(-20, 20)]) for _ in range(n)]
    grasp = Grasp(
        Contact(
            [unit * (x + s) for x, s in zip(p, shift, strict=True)], normal, friction, 1, preload
        )
        for p, normal in places
    )
    force = [Fraction(source.randint(-20, 20), 20) for _ in range(n)]
    turns = [
        Fraction(source.choice([0, source.randint(-20, 20)]), 2) for _ in range(1 if n == 2 else 3)
    ]
    kind = source.randrange(4)
    if kind == 0:
        force = [Fraction(0)] * n
    at = [Fraction(x) for x in shift]
    if kind == 1:  # through the centre
        turns = [Fraction(0)] * len(turns)
    arm = cross((*at, *[Fraction(0)] * (3 - n)), (*force, *[Fraction(0)] * (3 - n)))
    arm = arm[2:] if n == 2 else arm
    return grasp, (*force, *(unit * (x + y) for x, y in zip(turns, arm, strict=True)))


def converted(grasp: Grasp, seed: int, **options: Any) -> Conversion:
    """Return the grasp as it comes back from floats; half the seeds have noise of 10^-9."""
    source = Random(f"noise {seed}")
    size = 1e-9 if seed % 4 >= 2 else 0.0

    def noisy(vector: RationalVector) -> list[float]:
        return [float(x) + size * source.uniform(-1, 1) for x in vector]

    return from_float_data(
        [noisy(c.point) for c in grasp],
        [noisy(c.normal) for c in grasp],
        [float(c.friction) for c in grasp],
        preload=[float(c.preload) for c in grasp],
        **options,
    )


def _unit(source: Random) -> RationalVector:
    fine = source.choice([8, 64, 1000])
    u = Fraction(source.randint(-fine, fine), fine)
    x, y = (1 - u * u) / (1 + u * u), 2 * u / (1 + u * u)
    return (x, y) if source.random() < 0.5 else (-x, y)


def _ball_unit(source: Random) -> RationalVector:
    fine = source.choice([4, 16, 100])
    u, v = (Fraction(source.randint(-fine, fine), fine) for _ in range(2))
    square = u * u + v * v
    turned = [(1 - square) / (1 + square), 2 * u / (1 + square), 2 * v / (1 + square)]
    source.shuffle(turned)
    sign = source.choice((1, -1))
    return tuple(sign * x for x in turned)


def _circle(source: Random) -> list[Any]:
    around = [_unit(source) for _ in range(source.randint(3, 8))]
    return [([30 * x for x in out], [-x for x in out]) for out in around]


def _ball(source: Random) -> list[Any]:
    around = [_ball_unit(source) for _ in range(source.randint(4, 7))]
    return [([30 * x for x in out], [-x for x in out]) for out in around]


def _ellipse(source: Random) -> list[Any]:
    a, b = 40, source.choice([20, 25, 39])
    found = []
    for _ in range(source.randint(2, 4)):
        x, y = _unit(source)
        for sign in (1, -1)[: source.randint(1, 2)]:
            normal = unit_normal((-x / a, -sign * y / b), "1/1000000000").normal
            found.append(([a * x, sign * b * y], normal))
    return found


def _polygon(source: Random) -> list[Any]:
    """Return places on a regular-like polygon: edges on tangents of a circle."""
    found = []
    for _ in range(source.randint(3, 5)):
        x, y = _unit(source)
        for _ in range(source.randint(1, 2)):
            along = source.randint(-12, 12)
            found.append(([30 * x - along * y, 30 * y + along * x], [-x, -y]))
    return found


def _box(source: Random) -> list[Any]:
    x, y = source.choice([(Fraction(1), Fraction(0)), _unit(source)])
    found = []
    for c, s, far in ((x, y, 40), (-y, x, 25), (-x, -y, 40), (y, -x, 25)):
        for along in source.sample([-20, -10, 0, 10, 20], source.randint(1, 2)):
            found.append(([far * c - along * s, far * s + along * c], [-c, -s]))
    return found


def _spatial_box(source: Random) -> list[Any]:
    first = source.choice([(Fraction(1), Fraction(0), Fraction(0)), _ball_unit(source)])
    other = Contact([0, 0, 0], first, 0).tangents
    axes = (first, *other)
    found = []
    for j in range(3):
        for sign in (1, -1):
            if source.random() < 0.2:
                continue
            spots = [source.choice([-10, 0, 0, 10]) for _ in range(3)]
            spots[j] = sign * (20, 25, 30)[j]
            point = [dot(spots, column) for column in zip(*axes, strict=True)]
            found.append((point, [-sign * x for x in axes[j]]))
    return found


_PLACES = {
    "circle": _circle,
    "ellipse": _ellipse,
    "polygon": _polygon,
    "box": _box,
    "box in space": _spatial_box,
    "ball": _ball,
}
