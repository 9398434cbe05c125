"""Brute force that can afford five contacts: each of the 4^m contact states, decided exactly.

It shares no code with `equilibrium` and knows nothing of arrangements: no state is ruled out
beforehand. With the states fixed, the unknowns are the motion and one tangential force for each
sticking contact; the equalities are solved by elimination on integers, and where they leave
freedom, the inequalities on what is left go to an exact linear program. Either answer of it is
verified by substitution: a point, or multipliers that combine the inequalities to ``0 > 0``.
"""

import math
import operator
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from arrangement.numbers.linear import programs
from equilibrium import Contact, Grasp

#: Coefficients, and the constant last.
Row = list[int]
Vector = tuple[Fraction, ...]
STATES = ("detached", "slip+", "slip-", "stick")


@dataclass(frozen=True)
class Solution:
    """One solution of the conditions of one choice of states."""

    states: tuple[str, ...]
    motion: Vector
    forces: tuple[tuple[Fraction, Fraction], ...]


def solutions(
    grasp: Grasp, wrench: Sequence[Fraction], bound: Fraction | int | None = None
) -> Iterator[Solution]:
    """Yield one solution for each choice of states that has any.

    With a bound, only motions whose three components are at most that large count.
    """
    for states, equal, least, column in _systems(grasp, wrench, bound):
        point = _point(equal, least, len(equal[0]) - 1)
        if point is not None:
            yield _solution(grasp, states, point, column)


def is_stable(
    grasp: Grasp, wrench: Sequence[Fraction], bound: Fraction | int | None = None
) -> bool:
    return any(True for _ in solutions(grasp, wrench, bound))


def intervals(
    grasp: Grasp, direction: Sequence[Fraction], base: Sequence[Fraction] = (0, 0, 0)
) -> list[tuple[Fraction, Fraction | None]]:
    """Return, for each choice of states that allows any, the t >= 0 with base + t direction.

    The ends come from exact linear programs; None where there is no end.
    """
    found = []
    for _, equal, least, _ in _systems(grasp, base, direction=direction):
        objective = [0] * (len(equal[0]) - 2) + [1]
        rows = [*least, [*objective, 0]]
        low = programs.minimize(objective, rows, equal)
        if not isinstance(low, programs.Infeasible):
            high = programs.minimize([-x for x in objective], rows, equal)
            found.append((low.value, None if isinstance(high, programs.Unbounded) else -high.value))
    return found


def merged(
    parts: list[tuple[Fraction, Fraction | None]],
) -> tuple[tuple[Fraction, Fraction | None], ...]:
    """The union of closed intervals [a, b] with a given; b None means no end."""
    out: list[tuple[Fraction, Fraction | None]] = []
    for low, high in sorted(parts, key=lambda part: part[0]):
        if out and (out[-1][1] is None or low <= out[-1][1]):
            if out[-1][1] is not None and (high is None or high > out[-1][1]):
                out[-1] = (out[-1][0], high)
        else:
            out.append((low, high))
    return tuple(out)


def satisfies(grasp: Grasp, wrench: tuple, motion: tuple, forces: tuple) -> bool:
    """Return whether the four conditions hold, straight from their definition."""
    total = [Fraction(w) for w in wrench]
    for contact, (c_n, c_t) in zip(grasp, forces, strict=True):
        (px, py), (nx, ny) = contact.point, contact.normal
        fx, fy = c_n * nx - c_t * ny, c_n * ny + c_t * nx
        total = [total[0] + fx, total[1] + fy, total[2] + px * fy - py * fx]
        x, y, r = motion
        vx, vy = x - r * py, y + r * px  # the velocity of the contact point
        spring = max(Fraction(0), contact.preload - contact.stiffness * (vx * nx + vy * ny))
        slip, limit = -vx * ny + vy * nx, contact.friction * c_n
        if c_n != spring or abs(c_t) > limit:
            return False
        if slip and c_t != (-limit if slip > 0 else limit):
            return False
    return not any(total)


def _systems(
    grasp: Grasp,
    wrench: Sequence[Fraction],
    bound: Fraction | int | None = None,
    direction: Sequence[Fraction] | None = None,
) -> Iterator[tuple[tuple[str, ...], list[Row], list[Row], dict[int, int]]]:
    """Yield states, rows ``= 0``, rows ``>= 0``, and the column of each sticking contact's force.

    With a direction the last unknown is its factor t, and the wrench is ``wrench + t direction``.
    """
    tables, applied, along = _tables(grasp, wrench, direction or (0, 0, 0))
    box = [] if bound is None else _box(Fraction(bound))
    for states in product(STATES, repeat=len(tables)):
        parts = [table[state] for table, state in zip(tables, states, strict=True)]
        sticks = [i for i, state in enumerate(states) if state == "stick"]
        column = {i: 3 + j for j, i in enumerate(sticks)}
        n = 3 + len(sticks) + (direction is not None)
        equal = [[0] * n + [w] for w in applied]
        for row, w in zip(equal, along, strict=True):
            row[n - 1] += w
        least = [_wide(row, n) for row in box]
        for i, part in enumerate(parts):
            place = column.get(i)
            least += [_wide(row, n, place) for row in part.least]
            for row, more in zip(equal, part.balance, strict=True):
                _add(row, more, place)
        equal += [_wide(parts[i].slip, n) for i in sticks]
        yield states, equal, least, column


@dataclass(frozen=True)
class _Part:
    """What one contact adds in one state: rows over (x, y, r, its tangential force, 1)."""

    least: list[Row]
    balance: list[Row]
    slip: Row


def _tables(
    grasp: Grasp, wrench: Sequence[Fraction], direction: Sequence[Fraction]
) -> tuple[list[dict[str, _Part]], Row, Row]:
    """Return the parts of each contact by state, and both wrenches, all in integers."""
    raw = [{state: _raw(contact, state) for state in STATES} for contact in grasp]
    weights = [part[1][axis] for table in raw for part in table.values() for axis in range(3)]
    scale = math.lcm(
        *(Fraction(x).denominator for row in weights for x in row),
        *(Fraction(w).denominator for w in (*wrench, *direction)),
    )
    tables = [
        {
            state: _Part(
                [_whole(row) for row in least],
                [[int(scale * x) for x in row] for row in balance],
                _whole(slip),
            )
            for state, (least, balance, slip) in table.items()
        }
        for table in raw
    ]
    return tables, [int(scale * w) for w in wrench], [int(scale * w) for w in direction]


def _raw(contact: Contact, state: str) -> tuple[list[Vector], list[Vector], Vector]:
    """Return inequalities, shares of the balances, and the slip of a contact, in fractions."""
    (px, py), (nx, ny) = contact.point, contact.normal
    mu, k, zero = contact.friction, contact.stiffness, Fraction(0)
    # A point at (px, py) moves by (x - r py, y + r px); the tangent is (-ny, nx).
    gap = (k * nx, k * ny, k * (ny * px - nx * py), zero, -contact.preload)
    slip = (-ny, nx, nx * px + ny * py, zero, zero)
    normal = tuple(-g for g in gap)
    if state == "detached":
        return [gap], [(zero,) * 5] * 3, slip
    if state == "stick":
        rub: Vector = (zero, zero, zero, Fraction(1), zero)
        least = [
            normal,
            *(tuple(mu * a + s * b for a, b in zip(normal, rub, strict=True)) for s in (1, -1)),
        ]
    else:
        sign = 1 if state == "slip+" else -1
        rub = tuple(-sign * mu * a for a in normal)
        least = [normal, tuple(sign * a for a in slip)]
    fx = tuple(a * nx - b * ny for a, b in zip(normal, rub, strict=True))
    fy = tuple(a * ny + b * nx for a, b in zip(normal, rub, strict=True))
    return least, [fx, fy, tuple(px * b - py * a for a, b in zip(fx, fy, strict=True))], slip


def _solution(
    grasp: Grasp, states: tuple[str, ...], point: Vector, column: dict[int, int]
) -> Solution:
    """Return motion and forces of a point."""
    x, y, r = point[:3]
    forces = []
    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        (px, py), (nx, ny) = contact.point, contact.normal
        gap = (x - r * py) * nx + (y + r * px) * ny
        normal = Fraction(0)
        if state != "detached":
            normal = contact.preload - contact.stiffness * gap
        limit = contact.friction * normal
        friction = {"slip+": -limit, "slip-": limit, "detached": Fraction(0)}
        forces.append((normal, point[column[i]] if state == "stick" else friction[state]))
    return Solution(states, point[:3], tuple(forces))


def _wide(row: Row, n: int, place: int | None = None) -> Row:
    """Return a row over (x, y, r, one tangential force, 1) as a row over all n unknowns."""
    wide = [0] * (n + 1)
    _add(wide, row, place)
    return wide


def _add(wide: Row, row: Row, place: int | None) -> None:
    for target, source in ((0, 0), (1, 1), (2, 2), (-1, 4)):
        wide[target] += row[source]
    if place is not None:
        wide[place] += row[3]


def _box(bound: Fraction) -> list[Row]:
    rows = []
    for j in range(3):
        for sign in (1, -1):
            row = [Fraction(0)] * 4 + [bound]
            row[j] = Fraction(sign)
            rows.append(_whole(row))
    return rows


def _whole(row: Sequence[Fraction]) -> Row:
    """Return a positive multiple of the row in coprime integers."""
    scale = math.lcm(*(x.denominator for x in row))
    whole = [x.numerator * (scale // x.denominator) for x in row]
    divisor = math.gcd(*whole) or 1
    return [x // divisor for x in whole]


def _at(row: Sequence[Fraction | int], point: Sequence[Fraction]) -> Fraction:
    return sum((a * x for a, x in zip(row, point, strict=False)), Fraction(row[-1]))


def _point(equal: list[Row], least: list[Row], n: int) -> Vector | None:
    """Return a point of ``equal = 0``, ``least >= 0``, or None if there is none."""
    rows, pivots = _eliminated(equal)
    if n in pivots:
        return None
    spare = [j for j in range(n) if j not in pivots]
    # Every unknown as a row over the spare unknowns.
    express: list[list[Fraction]] = [[Fraction(0)] * (len(spare) + 1) for _ in range(n)]
    for place, j in enumerate(spare):
        express[j][place] = Fraction(1)
    for row, j in zip(rows, pivots, strict=False):
        express[j] = [Fraction(-row[s], row[j]) for s in (*spare, n)]
    if not spare:
        return _only(express, least)
    reduced = []
    for row in least:
        total = [Fraction(0)] * len(spare) + [Fraction(row[-1])]
        for a, e in zip(row, express, strict=False):
            if a:
                total = [t + a * x for t, x in zip(total, e, strict=True)]
        reduced.append(total)
    inner = _feasible(reduced, len(spare))
    return None if inner is None else tuple(_at(e, inner) for e in express)


def _only(express: list[list[Fraction]], least: list[Row]) -> Vector | None:
    """Return the one point if it satisfies the inequalities."""
    common = math.lcm(*(x.denominator for (x,) in express))
    whole = [x.numerator * (common // x.denominator) for (x,) in express] + [common]
    if any(sum(map(operator.mul, row, whole)) < 0 for row in least):
        return None
    return tuple(x for (x,) in express)


def _eliminated(matrix: list[Row]) -> tuple[list[Row], list[int]]:
    """Return rows with one pivot each, zero in all other rows, and the pivot columns."""
    rows = [list(row) for row in matrix]
    pivots: list[int] = []
    for column in range(len(rows[0])):
        done = len(pivots)
        found = next((i for i in range(done, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[done], rows[found] = rows[found], rows[done]
        top, pivot = rows[done], rows[done][column]
        for i, row in enumerate(rows):
            factor = row[column]
            if i != done and factor:
                mixed = [pivot * a - factor * b for a, b in zip(row, top, strict=True)]
                divisor = math.gcd(*mixed) or 1
                rows[i] = [a // divisor for a in mixed]
        pivots.append(column)
    return rows, pivots


def _feasible(least: list[list[Fraction]], k: int) -> Vector | None:
    """Return t with ``a . t + b >= 0`` for all rows (a, b), or None; verified either way."""
    found = programs.feasible_point(k, least)
    if isinstance(found, programs.Infeasible):
        weights = found.inequality_multipliers
        assert min(weights) >= 0
        columns = zip(*least, strict=True)
        *sums, last = (sum(map(operator.mul, weights, column)) for column in columns)
        assert not any(sums)
        assert last < 0
        return None
    assert all(_at(row, found) >= 0 for row in least)
    return found
