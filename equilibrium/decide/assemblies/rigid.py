"""Rigid bodies in place of springs: forces in the friction cones that balance, and nothing else.

This is the linear program of most programs for stacks and arches. It may squeeze bodies for free,
so it says yes where springs say no; where it says no, no contact forces balance the wrenches.
"""

from __future__ import annotations

from fractions import Fraction

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.programs import Infeasible, Program
from equilibrium.model.assembly import Assembly, Wrenches


def rigid_forces(assembly: Assembly, wrenches: Wrenches) -> tuple[RationalVector, ...] | None:
    """Return (normal, tangential) forces in the cones that balance the wrenches; None if none do.

    Args:
        wrenches: on all bodies, as `Assembly.read_wrenches` returns them.

    >>> from equilibrium.model.assembly import BodyContact
    >>> from equilibrium.model.contact import Contact
    >>> walls = [BodyContact("book", None, Contact([x, 0], [-x, 0], "1/2")) for x in (-1, 1)]
    >>> book = Assembly(["book"], walls)
    >>> [str(normal) for normal, _ in rigid_forces(book, book.read_wrenches({"book": [0, -1, 0]}))]
    ['1', '1']
    """
    rows, size = assembly.rows, 2 * len(assembly.contacts)
    load = [x for name in assembly.names for x in wrenches[name]]
    balance = [[Fraction(0)] * size + [w] for w in load]
    inside: list[RationalVector] = []
    for i, row in enumerate(rows):
        for j, axis in enumerate((row.normal_wrench, *row.tangential_wrenches)):
            for line, x in zip(balance, axis, strict=True):
                line[2 * i + j] = x
        for normal, tangential in ((1, 0), (row.friction, 1), (row.friction, -1)):
            side = [Fraction(0)] * (size + 1)
            side[2 * i : 2 * i + 2] = Fraction(normal), Fraction(tangential)
            inside.append(tuple(side))
    found = Program(size, inside, list(map(tuple, balance))).point()
    if isinstance(found, Infeasible):
        return None
    return tuple(found[k : k + 2] for k in range(0, size, 2))
