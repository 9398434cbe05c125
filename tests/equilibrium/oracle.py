"""Brute force: every one of the 4^m contact states, each as one exact linear program.

All 3 + 2m unknowns are kept, no state is ruled out beforehand, and nothing of `equilibrium` but the
contact data is used.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

from arrangement.linprog import Infeasible, feasible_point
from equilibrium import Grasp


def is_stable(grasp: Grasp, wrench: tuple) -> bool:
    return any(True for _ in solutions(grasp, wrench))


def solutions(grasp: Grasp, wrench: tuple) -> Iterator[tuple]:
    """Yield (motion, forces) for each choice of states that has a solution."""
    m = len(grasp)
    for states in product("dpms", repeat=m):
        equal, least = _rows(grasp, wrench, states)
        point = feasible_point(3 + 2 * m, least, equal)
        if not isinstance(point, Infeasible):
            yield point[:3], tuple((point[3 + 2 * i], point[4 + 2 * i]) for i in range(m))


def _rows(grasp: Grasp, wrench: tuple, states: tuple) -> tuple[list, list]:
    m = len(grasp)
    size = 3 + 2 * m
    equal: list[list[Fraction]] = [[Fraction(0)] * size + [Fraction(w)] for w in wrench]
    least: list[list[Fraction]] = []

    def row(**entries: Fraction) -> list[Fraction]:
        filled = [Fraction(0)] * (size + 1)
        for name, entry in entries.items():
            filled[int(name[1:])] += entry
        return filled

    for i, (contact, state) in enumerate(zip(grasp, states, strict=True)):
        (px, py), (nx, ny) = contact.point, contact.normal
        along_n = (nx, ny, px * ny - py * nx)
        along_t = (-ny, nx, px * nx + py * ny)
        n, t, one = 3 + 2 * i, 4 + 2 * i, size
        for axis in range(3):
            equal[axis][n] += along_n[axis]
            equal[axis][t] += along_t[axis]
        mu, k, q = contact.friction, contact.stiffness, contact.preload
        slip = {f"v{j}": along_t[j] for j in range(3)}
        stretch = {f"v{j}": k * along_n[j] for j in range(3)}
        if state == "d":
            equal += [row(**{f"v{n}": 1}), row(**{f"v{t}": 1})]
            least.append(row(**stretch, **{f"v{one}": -q}))
            continue
        equal.append(row(**stretch, **{f"v{n}": 1, f"v{one}": -q}))
        least.append(row(**{f"v{n}": 1}))
        if state == "s":
            equal.append(row(**slip))
            least += [row(**{f"v{n}": mu, f"v{t}": sign}) for sign in (1, -1)]
        else:
            sign = 1 if state == "p" else -1
            least.append(row(**{name: sign * value for name, value in slip.items()}))
            equal.append(row(**{f"v{t}": 1, f"v{n}": sign * mu}))
    return equal, least


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
