"""Rigid bodies in place of springs: contact forces in the friction cones that balance the wrenches.

The test is one linear program, as in most programs for stacks and arches. Its forces need not come
from any displacement: rigid bodies may be squeezed between others at no cost. So it is necessary
for an equilibrium with springs and not sufficient. Where it fails, no contact forces in the
friction cones balance the wrenches.
"""

from __future__ import annotations

from arrangement.numbers.exact import RationalVector
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
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
    question = LinearQuestion(assembly.rows, load)
    solution = ContactProgram(question, ("loose",) * len(assembly.contacts)).solution()
    return None if solution is None else solution.forces
