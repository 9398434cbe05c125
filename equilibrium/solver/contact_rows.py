"""The law of one contact, for everything on the solver's side; the checker has its own.

A row has the coefficients of the motion ``d = (x, y, r)`` and the constant last.
"""

from __future__ import annotations

from arrangement.exact import RationalVector
from equilibrium.model.grasp import Contact

#: The sign of the friction force of a slipping contact: against its motion along the tangent.
DIRECTION = {"slip+": -1, "slip-": 1}


def normal_force_row(contact: Contact) -> RationalVector:
    """Return the row of the normal force of a touching contact, ``preload - stiffness N . d``."""
    return (*(-contact.stiffness * x for x in contact.normal_wrench), contact.preload)


def friction_edges(contact: Contact) -> tuple[RationalVector, RationalVector]:
    """Return the edges of the friction cone, ``N + friction T`` and ``N - friction T``."""
    return _edge(contact, 1), _edge(contact, -1)


def slip_edge(contact: Contact, state: str) -> RationalVector:
    """Return the wrench of a unit normal force with the friction of a slipping contact."""
    return _edge(contact, DIRECTION[state])


def _edge(contact: Contact, side: int) -> RationalVector:
    pull = side * contact.friction
    pairs = zip(contact.normal_wrench, contact.tangential_wrench, strict=True)
    return tuple(along + pull * across for along, across in pairs)
