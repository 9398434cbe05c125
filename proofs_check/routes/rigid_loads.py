"""Second implementations for statements of other papers, by elimination and determinants.

No motion of frictionless contacts; the motion of a rigid object that starts from rest; bounds on
wrenches from linear springs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations, product

from .oracle import Interval, Question, Row, Touch, dot, interval_of, project

_ZERO = Fraction(0)


def immobile(normal_wrenches: Iterable[Row]) -> bool:
    """Return whether no motion but 0 has all ``N . d >= 0``: each coordinate is eliminated."""
    rows = [(*wrench, _ZERO) for wrench in normal_wrenches]
    n = len(rows[0]) - 1
    units = (tuple(Fraction(int(i == j)) for i in range(n)) for j in range(n))
    moves = ((*(s * x for x in unit), Fraction(-1)) for unit in units for s in (1, -1))
    return all(project([], [*rows, move], keep=-1) is None for move in moves)


def classes(question: Question) -> tuple[bool, bool]:
    """Return whether a load is strongly stable, and does positive work in no virtual motion."""
    work = [(*t.normal, _ZERO) for t in question.touches]
    gains = project([], [*work, (*question.wrench, Fraction(-1))], keep=-1) is not None
    return _rests(question), not gains


def _rests(question: Question) -> bool:
    """Some solution of the motion that starts from rest has no acceleration, and none has one."""
    rests = False
    for signs in product(("open", "stick", "+", "-"), repeat=len(question.contacts)):
        for axis in range(3):
            interval = _acceleration(question, signs, axis)
            if interval is None:  # no motion has these signs, whatever the axis
                break
            if interval != (_ZERO, _ZERO):
                return False
            rests = True
    return rests


def _acceleration(question: Question, signs: Sequence[str], axis: int) -> Interval | None:
    """Return the values of one coordinate of the acceleration, with unit mass and inertia."""
    m = len(question.contacts)
    size = 3 + 2 * m + 1
    unit = [tuple(Fraction(int(i == j)) for i in range(size)) for j in range(size)]
    balance = [
        [-Fraction(int(i == k)) for i in range(3)] + [_ZERO] * (2 * m) + [question.wrench[k]]
        for k in range(3)
    ]
    equalities: list[Row] = []
    inequalities: list[Row] = []
    for i, (touch, sign) in enumerate(zip(question.touches, signs, strict=True)):
        push, pull = unit[3 + 2 * i], unit[4 + 2 * i]
        normal, slip = ((*row, *[_ZERO] * (size - 3)) for row in (touch.normal, touch.tangential))
        for k in range(3):
            balance[k][3 + 2 * i], balance[k][4 + 2 * i] = touch.normal[k], touch.tangential[k]
        if sign == "open":
            equalities += [push, pull]
            inequalities.append(normal)
            continue
        equalities.append(normal)
        inequalities.append(push)
        limit = tuple(touch.friction * x for x in push)
        if sign == "stick":
            equalities.append(slip)
            inequalities += [_sum(limit, pull, s) for s in (1, -1)]
        else:
            way = 1 if sign == "+" else -1
            inequalities.append(tuple(way * x for x in slip))
            equalities.append(_sum(pull, limit, way))
    rows = project([*equalities, *map(tuple, balance)], inequalities, keep=axis)
    return None if rows is None else interval_of(rows, axis)


def _sum(left: Row, right: Row, factor: int) -> Row:
    return tuple(a + factor * b for a, b in zip(left, right, strict=True))


def within_bound(touches: Sequence[Touch], states: Sequence[str], size: Fraction) -> bool:
    """Return whether a squared wrench size is within the robustness bound of some states.

    By cofactors and principal minors; at rest there is no friction.
    """
    springs: list[tuple[Fraction, Row]] = []
    distances = []
    for touch, state in zip(touches, states, strict=True):
        if state == "detached":
            if touch.preload:
                return False
            continue
        springs.append((touch.stiffness, touch.normal))
        share = Fraction(1)
        if state == "stick":
            springs.append((touch.stiffness, touch.tangential))
            share = touch.friction**2 / (1 + touch.friction**2)
        distances.append(touch.preload**2 * share)
    stiff, squared = (
        [[sum((k**p * v[i] * v[j] for k, v in springs), _ZERO) for j in range(3)] for i in range(3)]
        for p in (1, 2)
    )
    volume = _minor(stiff, (0, 1, 2))
    if not volume:
        return False
    cofactors = [[_cofactor(stiff, i, j) for j in range(3)] for i in range(3)]
    gain = _product(cofactors, _product(squared, cofactors))
    room = [
        [min(distances) * int(i == j) * volume**2 - size * gain[i][j] for j in range(3)]
        for i in range(3)
    ]
    chosen = (rows for k in (1, 2, 3) for rows in combinations(range(3), k))
    return all(_minor(room, rows) >= 0 for rows in chosen)


_Square = Sequence[Sequence[Fraction]]


def _product(left: _Square, right: _Square) -> list[list[Fraction]]:
    return [[dot(row, column) for column in zip(*right, strict=True)] for row in left]


def _minor(rows: _Square, chosen: Sequence[int]) -> Fraction:
    """Return a principal minor, by its first row."""
    if len(chosen) == 1:
        return rows[chosen[0]][chosen[0]]
    if len(chosen) == 2:
        i, j = chosen
        return rows[i][i] * rows[j][j] - rows[i][j] * rows[j][i]
    return sum((rows[0][j] * _cofactor(rows, 0, j) for j in range(3)), _ZERO)


def _cofactor(rows: _Square, i: int, j: int) -> Fraction:
    a, b = ((i + 1) % 3, (i + 2) % 3)
    c, d = ((j + 1) % 3, (j + 2) % 3)
    return rows[a][c] * rows[b][d] - rows[a][d] * rows[b][c]
