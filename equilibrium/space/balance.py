"""The search for an equilibrium in space: contacts made smooth, then sharper step by step.

As in the plane (`equilibrium.plane.search.continuation`), with the friction force
``-mu c_n s / sqrt(|s|^2 + eps^2)`` in the tangent plane, or with pyramids a mean of their edges, of
the weights ``exp(e . s / eps)``: balance is an equation in the six unknowns
of the motion, whatever the number of contacts.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from equilibrium.plane.contacts import FloatContacts
from equilibrium.plane.search.continuation import Continuation

from .cones import Cones


class SpatialContinuation(Continuation):
    """The smoothed balance of one question in space."""

    def __init__(self, contacts: FloatContacts, wrench: RationalVector, cones: Cones) -> None:
        super().__init__(contacts, wrench)
        self.cones = cones

    def _balance(self, motion: Floats, eps: float) -> tuple[Floats, Floats]:
        """Return the sum of all wrenches, in units of force, and its derivative."""
        c = self.contacts
        force, touching = self._pressed(motion, eps)
        ratio, change = self.cones.smooth(c.tangents @ motion, eps)
        arm = c.normal + np.einsum("mi,mij->mj", ratio * c.friction[:, None], c.tangents)
        turned = change @ c.tangents
        value = self.load + force @ arm
        jacobian = (arm * touching[:, None]).T @ c.spring[:, 1:]
        jacobian += np.einsum("m,mij,mik->jk", -c.friction * force, c.tangents, turned)
        return value * self.arms, jacobian * self.arms[:, None]

    def starts(self, count: int) -> Iterator[Floats]:
        """Yield motions to start from: none, then small random ones, the same on every run."""
        yield np.zeros(6)
        random = np.random.default_rng(1)
        for _ in range(count):
            yield self.scale * random.normal(size=6)
