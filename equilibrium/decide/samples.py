"""Sample grasps at corners of bounds, in floats."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product
from random import Random

import numpy as np

from arrangement.numbers.exact import dot
from arrangement.numbers.float_filter import Floats
from equilibrium.certificate.uncertain import Bounds
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal

#: How many, fewer of many contacts.
_MOST = 64


def moved(contact: Contact, signs: Iterable[float], bounds: Bounds) -> Contact:
    """Return a contact within bounds: shares from -1 to 1 of each turn, coordinate and value."""
    n, shares = contact.dimension, [Fraction(x).limit_denominator(64) for x in signs]
    normal, turns = contact.normal, shares[: n - 1]
    if bounds.angle and any(turns):
        # In space the two turns together are at most sqrt(2).
        reach = bounds.angle * (Fraction(49, 50) if n == 2 else Fraction(69, 100))
        across = [dot(turns, column) for column in zip(*contact.tangents, strict=True)]
        wanted = [x + reach * y for x, y in zip(normal, across, strict=True)]
        normal = unit_normal(wanted, bounds.angle / 60).normal
    place = [x + s * bounds.length for x, s in zip(contact.point, shares[n - 1 :], strict=False)]
    values = (
        getattr(contact, name) * (1 + s * getattr(bounds, name))
        for name, s in zip(VALUES, shares[2 * n - 1 :], strict=True)
    )
    return Contact(place, normal, *values)


class Samples:
    """Contacts of a grasp at corners of bounds.

    Attributes:
        signs: (samples, numbers of a contact), shares for `moved`.
        normal, tangent: wrenches along them, (contacts, samples, [tangents,] n).
        friction, stiffness, preload: (contacts, samples).
    """

    def __init__(self, grasp: Grasp, bounds: Bounds) -> None:
        self.grasp, self.bounds, self.d = grasp, bounds, grasp.dimension
        m = len(grasp)
        sizes = [*[bounds.angle] * (self.d - 1), *[bounds.length] * self.d]
        sizes += [getattr(bounds, name) for name in VALUES]
        free = [k for k, size in enumerate(sizes) if size]
        most = min(_MOST, 20000 // (m + 1) + 1)
        if 2 ** len(free) <= most:
            rows = list(product((1, -1), repeat=len(free)))
        else:
            source = Random("samples")
            rows = [tuple(source.choice((1, -1)) for _ in free) for _ in range(most)]
        self.signs = np.zeros((len(rows), len(sizes)))
        self.signs[:, free] = np.array(rows, float).reshape(len(rows), len(free))
        self.normal, self.tangent = self._wrenches()
        self.friction, self.stiffness, self.preload = (
            np.array([[float(getattr(c, name))] for c in grasp]).reshape(m, 1)
            * (1 + float(getattr(bounds, name)) * self.signs[:, k])
            for k, name in enumerate(VALUES, 2 * self.d - 1)
        )

    def _wrenches(self) -> tuple[Floats, Floats]:
        """Return wrenches along the normals and tangents of all samples."""
        d, m = self.d, len(self.grasp)
        axes = np.array([[c.normal, *c.tangents] for c in self.grasp], float).reshape(m, 1, d, d)
        points = np.array([c.point for c in self.grasp], float).reshape(m, 1, 1, d)
        turns = self.signs[:, : d - 1] * float(self.bounds.angle) * (1 if d == 2 else 0.7)
        angles = np.linalg.norm(turns, axis=1)[:, None]
        shares = turns / np.where(angles > 0, angles, 1)
        ahead, across = axes[:, :, 0], np.einsum("vk,mckd->mvd", shares, axes[:, :, 1:])
        sine, lost = np.sin(angles), 1 - np.cos(angles)
        bent = shares[:, :, None] * (sine * ahead + lost * across)[:, :, None]
        axes = np.concatenate(
            [((1 - lost) * ahead + sine * across)[:, :, None], axes[:, :, 1:] - bent], 2
        )
        points = points + self.signs[:, None, d - 1 : 2 * d - 1] * float(self.bounds.length)
        if d == 2:
            torques = points[..., :1] * axes[..., 1:] - points[..., 1:] * axes[..., :1]
        else:
            torques = np.cross(points, axes)
        wrenches = np.concatenate([axes, torques], axis=-1)
        return wrenches[:, :, 0], wrenches[:, :, 1:]

    def grasp_at(self, shares: Iterable[Iterable[float]]) -> Grasp:
        """Return the grasp with these shares for `moved`."""
        return Grasp(moved(c, row, self.bounds) for c, row in zip(self.grasp, shares, strict=True))
