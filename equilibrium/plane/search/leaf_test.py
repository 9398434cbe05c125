"""Whether virtual motions close regions of motions, exactly, many regions at once.

With ``a = lambda . N``, ``b = lambda . T``, the contacts' least work for the spring force e is
``kappa e``: kappa = a - mu b where the contact surely slips +, a + mu b where it slips -, else
a - mu |b|. Where e changes sign in the region it is 0, or ``kappa max(0, e)`` for kappa < 0. A
virtual motion closes a region if at each generator the work of the load and all these add up to a
positive number, or to 0 or more at motions without end (d_0 = 0).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from arrangement.numbers.exact import IntegerVector, RationalVector, primitive
from equilibrium.plane.contacts import IntegerContacts, product, whole


def closed(
    contacts: IntegerContacts,
    wrench: RationalVector,
    regions: Sequence[Sequence[IntegerVector]],
    motions: Sequence[Sequence[int]],
) -> list[bool]:
    """Return for each region whether the virtual motion beside it closes it."""
    count, m = len(regions), len(contacts)
    generators = whole(regions, (count, 4, 4))
    chosen = whole(motions, (count, 3))
    spring = product(generators.reshape(-1, 4), contacts.spring.T).reshape(count, 4, m)
    slip = product(generators[:, :, 1:].reshape(-1, 3), contacts.tangent.T).reshape(count, 4, m)
    along = product(chosen, contacts.normal.T)
    across = product(chosen, contacts.tangent.T) * contacts.friction
    along = along * contacts.friction_unit
    sliding = np.where((slip > 0).all(axis=1), 1, 0) - np.where((slip < 0).all(axis=1), 1, 0)
    kappa = along - np.where(sliding == 0, np.abs(across), sliding * across)
    low, high = spring.min(axis=1, initial=0), spring.max(axis=1, initial=0)
    mixed = (low < 0) & (high > 0)
    kappa = np.where((high <= 0) | (mixed & (kappa > 0)), 0, kappa)
    terms = kappa[:, None, :] * np.where(spring > 0, spring, 0)
    unit = contacts.common_unit
    load = primitive([*wrench, 1])
    work = terms.astype(object).dot(contacts.shares) * load[3]
    work = work + (chosen.dot(whole([load[:3]], (3,))) * unit)[:, None] * generators[:, :, 0]
    passed = np.where(generators[:, :, 0] > 0, work > 0, work >= 0)
    return [bool(x) for x in passed.all(axis=1)]
