"""Rigid bodies in place of springs: forces in the friction cones that balance, and nothing else.

This is the linear program of most programs for stacks and arches. It may squeeze bodies for free,
so it says yes where springs say no; where it says no, no contact forces balance the wrenches.
"""

from __future__ import annotations

from fractions import Fraction

from arrangement.numbers.exact import RationalVector
from equilibrium.core.contact_program import ContactProgram, LinearQuestion
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
    load = tuple(x for name in assembly.names for x in wrenches[name])
    question = LinearQuestion(assembly.rows, load, (Fraction(0),) * len(load))
    found = ContactProgram(question, ("loose",) * len(assembly.contacts)).solution()
    return None if found is None else found.forces
