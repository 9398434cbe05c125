"""The law of a contact in floats, on arrays: of one question or of many at once, for every search.

Its exact form, by contact states, is in `equilibrium.core.contact_law`. At a motion d contacts have
the spring forces ``e = q - k N . d`` and the slips ``s = T . d``. A normal force of 1 with friction
a share u of its limit is the wrench ``N + mu u T``, so balance is

    w + sum max(0, e) (N + mu u T) = 0   with   u = -s / |s|, or any |u| <= 1 where s = 0.

On a virtual motion v this wrench does the work ``N . v + mu u . T v``, at least
``kappa = N . v - mu |T v|``. Cones that are not round have another support in place of the length.
Adhesion is a part of the load w. Integers take the edges of cones along one tangent from here, too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple, Self, TypeAlias

import numpy as np

from arrangement.numbers.float_filter import Booleans, Floats

#: Identity matrices by their size, of integers, which go with floats and with decimals.
_UNITS = [np.eye(size, dtype=int) for size in range(3)]
#: Slips (..., m, t) and eps to shares of friction limits, and minus how they change (..., m, t, t).
Smooth: TypeAlias = Callable[[Floats, Any], tuple[Floats, Floats]]


def products(rows: Floats, motion: Floats) -> Floats:
    """Return the scalar products of rows (..., n) of each question with its motion."""
    if motion.ndim == 1:
        alone: Floats = rows @ motion
        return alone
    flat = len(rows), math.prod(rows.shape[1:-1]), rows.shape[-1]
    return (rows.reshape(flat) @ motion[..., None]).reshape(rows.shape[:-1])


def norms(slips: Floats) -> Floats:
    """Return the lengths of vectors along the tangents, which have moderate numbers."""
    lengths: Floats = np.sqrt((slips * slips).sum(axis=-1))
    return lengths


def cone_edges(normal: Floats, tangents: Floats, friction: Floats) -> tuple[Floats, Floats]:
    """Return the wrenches of normal forces of 1 at contacts that slip +, and at those that slip -.

    They are the edges of a friction cone along one tangent. The least work on a virtual motion is
    that of an edge which the directions of slip allow.
    """
    limits = friction[..., None]
    return _with_friction(normal, tangents, -limits), _with_friction(normal, tangents, limits)


def _with_friction(normal: Floats, tangents: Floats, friction: Floats) -> Floats:
    """Return the wrenches of normal forces of 1 with friction (..., m, t)."""
    wrenches: Floats = normal + np.einsum("...t,...tn->...n", friction, tangents)
    return wrenches


class Batch:
    """Arrays of many questions, or of many regions; an index takes some of these."""

    def __getitem__(self, rows: Any) -> Self:
        part = object.__new__(type(self))
        for name, value in vars(self).items():
            setattr(part, name, value[rows] if isinstance(value, np.ndarray | Batch) else value)
        return part


class FloatLaw:
    """The numbers of m contacts in R^n with t tangents, of one question or of many, and their law.

    Attributes:
        normal: N, (..., m, n); tangents: T, (..., m, t, n).
        friction, stiffness, preload: (..., m).
    """

    normal: Floats
    tangents: Floats
    friction: Floats
    stiffness: Floats
    preload: Floats

    def __init__(self, *numbers: Floats) -> None:
        self.normal, self.tangents, self.friction, self.stiffness, self.preload = numbers

    def in_units(self, arms: Floats, force: float, step: float) -> tuple[Floats, ...]:
        """Return the numbers in other units: of motions `step` times `arms`, and of forces."""
        return (
            self.normal * arms,
            self.tangents * arms,
            self.friction,
            self.stiffness * step / force,
            self.preload / force,
        )

    @cached_property
    def spring(self) -> Floats:
        """The rows ``(q, -k N)`` (..., m, n + 1): forces of springs, at motions with a 1 first."""
        springs = -self.stiffness[..., None] * self.normal
        return np.concatenate([self.preload[..., None], springs], axis=-1)

    def spring_forces(self, motion: Floats) -> Floats:
        """Return ``q - k N . d`` (..., m) at motions (..., n); below 0 contacts are detached."""
        forces: Floats = self.preload - self.stiffness * products(self.normal, motion)
        return forces

    def spring_forces_at(self, generators: Floats) -> Floats:
        """Return ``q d_0 - k N . d`` (..., g, m) at homogeneous motions (..., g, n + 1)."""
        forces: Floats = generators @ self.spring.swapaxes(-1, -2)
        return forces

    def slips(self, motion: Floats) -> Floats:
        """Return ``T . d`` (..., m, t) at motions (..., n)."""
        return products(self.tangents, motion)

    def unit_wrenches(self, shares: Floats, at: Any = ...) -> Floats:
        """Return ``N + mu u T`` of shares of friction limits (..., m, t).

        Args:
            at: an index, of the contacts that the shares are of; all by default.
        """
        limits = self.friction[at][..., None] * shares
        return _with_friction(self.normal[at], self.tangents[at], limits)

    @cached_property
    def edges(self) -> tuple[Floats, Floats]:
        """See `cone_edges`."""
        return cone_edges(self.normal, self.tangents, self.friction)

    def least_works(self, virtual: Floats, most: Floats) -> Floats:
        """Return kappa (..., m), the least works of normal forces of 1 on virtual motions.

        Args:
            most: that friction does, as shares of its limit, (..., m): `norms` of the slips, or the
                support of other cones.
        """
        kappa: Floats = products(self.normal, virtual) - self.friction * most
        return kappa


class Balance(NamedTuple):
    """Forces and their balance at motions (..., n), of one question or of many at once.

    Attributes:
        smooth: friction, see `Cones.smooth`.
        load: (..., n), as all wrenches weighed with numbers for their entries.
        normal: N as a wrench, (..., m, n); pulls: friction times T, (..., m, t, n).
        spring: stiffness times N, (..., m, n); tangents: T, (..., m, t, n).
        preload: (..., m, 1).
        hardness: stiffness, or 1 where that is 0, (..., m, 1).
    """

    smooth: Smooth
    load: Floats
    normal: Floats
    pulls: Floats
    spring: Floats
    tangents: Floats
    preload: Floats
    hardness: Floats

    @classmethod
    def of(cls, contacts: FloatLaw, load: Floats, smooth: Smooth, weights: Any = 1) -> Balance:
        """Return the balance of contacts under a load."""
        c, stiffness = contacts, contacts.stiffness[..., None]
        return cls(
            smooth,
            load * weights,
            c.normal * weights,
            c.friction[..., None, None] * c.tangents * weights,
            stiffness * c.normal,
            c.tangents,
            c.preload[..., None],
            np.where(stiffness > 0, stiffness, 1),
        )

    def take(self, rows: Any) -> Balance:
        """Return the balance of some of the questions."""
        return Balance(self.smooth, *(numbers[rows] for numbers in self[1:]))

    def _at(self, motion: Floats) -> tuple[Floats, Floats]:
        """Return forces of springs (..., m, 1) and slips (..., m, t)."""
        column = motion[..., None]
        slips = (_flat(self.tangents) @ column).reshape(self.tangents.shape[:-1])
        return self.preload - self.spring @ column, slips

    def forces(self, motion: Floats, eps: Any) -> tuple[Floats, Floats, Floats]:
        """Return forces of springs (..., m, 1), and what `smooth` returns.

        Args:
            eps: a number; of many questions (..., 1, 1).
        """
        force, slips = self._at(motion)
        return force, *self.smooth(slips, eps)

    def smoothed(self, motion: Floats, eps: Any) -> tuple[Floats, Callable[[], Floats]]:
        """Return the sum of all wrenches (..., n), and what returns its derivative (..., n, n).

        Forces of springs bend to 0 where they would pull.
        """
        force, share, change = self.forces(motion, eps)
        soft = eps * self.hardness
        root = np.sqrt(force * force + soft * soft)
        return self._sum((force + root) / 2, lambda: (1 + force / root) / 2, share, change)

    def in_states(
        self, motion: Floats, on: Booleans, slides: Booleans, held: Any = 0
    ) -> tuple[Floats, Floats, Floats, Callable[[], Floats]]:
        """Return forces of springs (..., m), shares of friction, and what `smoothed` returns.

        Args:
            on: which contacts touch, (..., m); slides: which slip.
            held: shares of friction limits of the others, (..., m, t).
        """
        force, slips = self._at(motion)
        slides = slides[..., None]
        share, change = smooth_slip(
            slips, np.where(slides & (slips != 0).any(-1, keepdims=True), 0, 1)
        )
        share = np.where(slides, share, held)
        turns = np.where(slides[..., None], change, 0) if slips.shape[-1] > 1 else None
        touching = on[..., None]
        total, derivative = self._sum(np.where(touching, force, 0), lambda: touching, share, turns)
        return force[..., 0], share, total, derivative

    def _sum(
        self,
        normal: Floats,
        touching: Callable[[], Any],
        share: Floats,
        change: Floats | None,
    ) -> tuple[Floats, Callable[[], Floats]]:
        """Return the sum of all wrenches, and what returns its derivative.

        Args:
            normal: forces, (..., m, 1); touching: how they change with those of springs.
            change: minus the derivative of the shares by slips, (..., m, t, t); None for 0.
        """
        arms = (self.normal + (share[..., None, :] @ self.pulls)[..., 0, :]).swapaxes(-1, -2)

        def derivative() -> Floats:
            jacobian: Floats = arms @ (touching() * self.spring)
            if change is not None:
                turned = (normal[..., None] * change) @ self.tangents
                jacobian += _flat(self.pulls).swapaxes(-1, -2) @ _flat(turned)
            return -jacobian

        return self.load + (arms @ normal)[..., 0], derivative


def _flat(rows: Floats) -> Floats:
    """Return the rows of all tangents (..., m, t, n) below each other, (..., m t, n)."""
    *rest, m, t, n = rows.shape
    return rows.reshape(*rest, m * t, n)


def smooth_slip(slip: Floats, eps: Any) -> tuple[Floats, Floats]:
    """Return ``-s / sqrt(|s|^2 + eps^2)`` for slips s (..., m, t), and minus how it changes."""
    squares = slip * slip
    if slip.shape[-1] == 2:
        squares = squares[..., :1] + squares[..., 1:]
    root = np.sqrt(squares + eps * eps)
    share = -slip / root
    change = _UNITS[slip.shape[-1]] - share[..., None] * share[..., None, :]
    return share, change / root[..., None]
