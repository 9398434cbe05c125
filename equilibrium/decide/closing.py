"""Search for proofs of a verdict for all grasps within bounds.

Their form is in `equilibrium.certificate.robust`. In floats, with `Samples`. What is left over of
all forces in a cell is a hull of finitely many vectors then, and its point of least norm is a
virtual motion that closes the cell, or there is none and the cell is halved. The exact test of each
leaf is the checker's.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np

from arrangement.numbers.exact import RationalVector, to_text
from arrangement.numbers.float_filter import Floats
from equilibrium.certificate.robust import Box, corners_of, halves
from equilibrium.certificate.uncertain import Bounds
from equilibrium.model.grasp import Grasp

from . import RESISTED
from .samples import Samples

#: Cells of one search; vectors of a hull.
_CELLS, _STEPS = (24, 200, 3000), 30
#: A cell whose longest edge is shorter, as a share of its face, is given up.
_LEAST = Fraction(1, 2**14)
#: Directions of friction that are told apart in space.
_AROUND = 12
#: Sizes of the box around an equilibrium that are tried, in multiples of what its motion needs;
#: of forces at rest, which soon are above their limits, but take less time.
_FACTORS, _AT_REST = (1.15, 1.6, 2.5, 4.0, 8.0), (1.6, 1.8, 2.0, 2.2, 2.5)
#: The least of them, as a share of the largest force.
_LEAST_REACH = 1e-4


class Closing(Samples):
    """The search for a proof, and for grasps within bounds that speak against it.

    Args:
        found: a decided verdict.
        seconds: of processor time.

    Attributes:
        against: shares for `moved`, one row for each contact, where a cell stayed open.
        ways: virtual motions on which the equilibrium may give in.
    """

    def __init__(self, found: Any, bounds: Bounds, seconds: float) -> None:
        super().__init__(found.grasp, bounds)
        self.found, self.deadline = found, time.process_time() + seconds
        self.against: list[Floats] = []
        self.ways: list[Floats] = []
        self.n = len(found.wrench)
        points = np.array([c.point for c in self.grasp], float).reshape(-1, self.d)
        arm = float(np.ptp(points, axis=0).max(initial=0)) if len(points) else 0.0
        # A power of two, so that rounded virtual motions have short numbers.
        self.arm = 2.0 ** (math.frexp(arm)[1] - 2) if arm else 1.0
        self.units = np.array([1.0] * self.d + [1 / self.arm] * (self.n - self.d))
        self.wrench = np.array(found.wrench, float)

    def weakest(self) -> list[Floats]:
        """Return virtual motions on which an equilibrium may give in."""
        if not self.ways:
            next(self._boxes(), None)
        return self.ways

    def worst(self, virtual: Any) -> Grasp:
        """Return the sample contacts that do the most on a virtual motion at the equilibrium."""
        motion = self.found.solution.motion if self.found.solution else [0] * self.n
        spring = np.maximum(
            self.preload - self.stiffness * (self.normal @ np.array(motion, float)), 0
        )
        rub = np.linalg.norm(self.tangent @ virtual, axis=-1)
        best = ((self.normal @ virtual - self.friction * rub) * spring).argmax(axis=1)
        return self.grasp_at(self.signs[best])

    def proofs(self) -> Iterator[dict[str, Any]]:
        """Yield proofs, as parts of a document: of few cells in any box before many in one."""
        yes = self.found.verdict == RESISTED
        forms = list(self._boxes()) if yes else [{"scales": self._scales()}]
        if not yes and (leaf := self._common()):
            box = Box(self.grasp, self.found.wrench, self.bounds, forms[0])
            faces = [leaf for _ in box.faces()]
            yield {"bounds": self.bounds.to_dict(), "box": _texts(forms[0]), "faces": faces}
        for cells, form in product(_CELLS, forms):
            self.left = cells
            box = Box(self.grasp, self.found.wrench, self.bounds, form)
            faces = list[Any]()
            for fixed, ranges in box.faces():
                faces.append(self._node(box, fixed, ranges))
                if faces[-1] is None:
                    break
            else:
                yield {"bounds": self.bounds.to_dict(), "box": _texts(form), "faces": faces}

    def _node(self, box: Box, fixed: int, ranges: list[RationalVector]) -> Any:
        self.left -= 1
        if self.left < 0 or time.process_time() > self.deadline:
            return None
        pairs = [box.motion(y) for y in corners_of(ranges)]
        motions, loads = (
            np.array([[float(x) for x in row] for row in rows]) for rows in zip(*pairs, strict=True)
        )
        if box.rest:
            tried = iter([(loads * self.units).mean(axis=0)])
        else:
            tried = self._virtual(motions / np.abs(motions).max(), loads)
        for virtual in tried:
            leaf, texts = self._leaf(virtual)
            if box.holds(leaf, ranges):
                return texts
        sizes = [high - low for low, high in ranges]
        fine, k = max(sizes) <= _LEAST or box.rest, sizes.index(max(sizes))
        if self.d == 3 and not fine:
            k = self._steepest(ranges, motions)
        children: list[Any] = []
        for half in halves(ranges, k) if not fine else ():
            children.append(self._node(box, fixed, half))
            if children[-1] is None:
                break
        return {"cut": k, "children": children} if children and children[-1] else None

    def _virtual(self, motions: Floats, loads: Floats) -> Iterator[Floats]:
        """Yield virtual motions that may close a cell, in units; else leave a grasp `against`.

        What is left over at a corner is the load and for each contact one of the vectors ``e F`` of
        all samples and directions of slip. Of the hull of those known so far the point of least
        norm is asked for the vectors that do the least along it.
        """
        from scipy.optimize import nnls  # slow to load, and few verdicts need it

        share, m = motions[:, 0], len(self.grasp)
        spring = self.preload[..., None] * share
        spring = spring - self.stiffness[..., None] * (self.normal @ motions[:, 1:].T)
        # For each contact, sample, corner and direction of slip.
        rub = np.einsum("mvjuk,mvkn->mvjun", self._slips(motions), self.tangent)
        forces = self.normal[:, :, None, None] - self.friction[..., None, None, None] * rub
        forces = forces * self.units
        attached = spring.min(axis=(1, 2), initial=np.inf) >= 0
        forces = forces.transpose(0, 1, 3, 2, 4)
        ways = forces.shape[1] * forces.shape[2]
        spring = np.maximum(spring, 0)
        base = self.wrench * self.units * share[:, None]
        unit = np.abs(base).max() + np.abs(forces).max(initial=0) * spring.max(initial=0) or 1.0
        pull = loads * self.units if loads.size else np.zeros((0, self.n))
        hull, known = list(pull / np.abs(pull).max(initial=1e-300) * unit), len(pull)
        owners: list[Any] = [None] * known
        virtual, weights, each = np.ones(self.n), np.zeros(0), np.arange(m)[:, None]
        corner = np.arange(len(share))
        for step in range(_STEPS):
            work = ((forces @ virtual) * spring[:, :, None]).reshape(m, ways, len(share))
            chosen = work.argmin(axis=1)
            sample, way = np.divmod(chosen, forces.shape[2])
            used = attached[:, None] | (np.take_along_axis(work, chosen[:, None], 1)[:, 0] < 0)
            factor = used * np.take_along_axis(spring, sample[:, None], 1)[:, 0]
            rest = base + np.einsum("mj,mjn->jn", factor, forces[each, sample, way, corner])
            works, square = rest @ virtual, virtual @ virtual
            works[(share == 0) & (np.abs(rest).max(axis=1) < 1e-12 * unit)] = np.inf
            if step and works.min() > 0.3 * square and all(x @ virtual > 0 for x in hull[:known]):
                yield virtual
            due = np.flatnonzero(works < (0.9 * square if step else np.inf))
            due = due[np.argsort(works[due])][:8]
            if not len(due):
                return
            hull += list(rest[due])
            owners += [self.signs[sample[:, j]] for j in due]
            vectors = np.array(hull).T / unit
            try:
                weights, _ = nnls(
                    np.vstack([vectors, np.ones(len(hull))]), np.eye(self.n + 1)[-1], maxiter=1000
                )
            except RuntimeError:
                return
            virtual = vectors @ (weights / weights.sum()) * unit
            if np.linalg.norm(virtual) < 1e-7 * unit:
                break
        pairs = [(w, one) for w, one in zip(weights, owners, strict=True) if one is not None and w]
        if pairs:
            self.against.append(sum(w * one for w, one in pairs) / sum(w for w, _ in pairs))

    def _slips(self, motions: Floats) -> Floats:
        """Return directions of slip, some for each contact, sample and corner of a cell.

        In space that at the corner alone where slips turn little, as in `certificate.uncertain`.
        """
        slips = np.einsum("mvkn,jn->mvjk", self.tangent, motions[:, 1:])
        if self.d == 2:
            low, high = slips.min(axis=(1, 2)), slips.max(axis=(1, 2))
            ends = np.stack([np.where(high < 0, -1.0, 1.0), np.where(low > 0, 1.0, -1.0)], axis=1)
            return np.broadcast_to(ends[:, None, None], (*slips.shape[:3], 2, 1))
        middle = slips.mean(axis=(1, 2))
        size = np.linalg.norm(middle, axis=1)[:, None, None]
        ahead = middle / np.where(size[:, 0] > 0, size[:, 0], 1)
        side = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
        forth, turn = (np.einsum("mvjk,mk->mvj", slips, x) for x in (ahead, side))
        near = (forth > 2 * np.abs(turn)).all(axis=(1, 2)) & (size[:, 0, 0] > 0)
        share = turn / np.where(size > 0, size, 1)
        linear = ahead[:, None, None] + share[..., None] * side[:, None, None]
        if near.all():
            return np.asarray(linear[:, :, :, None])
        angles = np.arctan2(slips[..., 1], slips[..., 0])
        at = np.arctan2(middle[:, 1], middle[:, 0])
        away = np.abs((angles - at[:, None, None] + np.pi) % (2 * np.pi) - np.pi).max(axis=(1, 2))
        moves = np.abs(slips).max(axis=3).min(axis=(1, 2)) > 0
        reach = np.where((away < 1.5) & moves, away, np.pi)
        spread = at[:, None] + reach[:, None] * np.linspace(-1, 1, _AROUND)
        fan = np.stack([np.cos(spread), np.sin(spread)], axis=-1)[:, None, None]
        return np.where(near[:, None, None, None, None], linear[:, :, :, None], fan)

    def _common(self) -> Any:
        """Return a virtual motion on which no contact within bounds does work below 0, if any."""
        from scipy.optimize import linprog  # slow to load, and few verdicts need it

        around = np.arange(2 if self.d == 2 else 2 * _AROUND)
        turn = 2 * np.pi * around / len(around)
        slips = np.stack([np.cos(turn), np.sin(turn)], axis=1)[:, : self.d - 1]
        rub = np.einsum("uk,mvkn->mvun", slips, self.tangent)
        rows = (self.normal[:, :, None] - self.friction[..., None, None] * rub) * self.units
        rows = np.vstack([rows.reshape(-1, self.n), self.wrench * self.units])
        room = np.linalg.norm(rows, axis=1)
        cost = np.append(np.zeros(self.n), -1.0)
        bounds = [(-1, 1)] * self.n + [(0, None)]
        found = linprog(cost, np.column_stack([-rows, room]), np.zeros(len(rows)), bounds=bounds)
        return self._leaf(found.x[:-1])[1] if found.x is not None and found.x[-1] > 1e-6 else None

    def _leaf(self, virtual: Floats) -> tuple[RationalVector, Any]:
        """Return a virtual motion in units as exact numbers near, and as texts."""
        shares = [Fraction(round(2**30 * x), 2**30) for x in virtual / abs(virtual).max()]
        leaf = tuple(x * Fraction(u) for x, u in zip(shares, self.units.tolist(), strict=True))
        return leaf, _texts(leaf)

    def _steepest(self, ranges: list[RationalVector], motions: Floats) -> int:
        """Return the coordinate along which friction turns most in a cell, and springs let go."""
        spring = self.preload.mean(axis=1)[:, None] * motions[:, 0]
        spring = spring - self.stiffness[:, :1] * (self.normal.mean(axis=1) @ motions[:, 1:].T)
        slips = np.einsum("mkn,jn->mjk", self.tangent.mean(axis=1), motions[:, 1:])
        size = np.linalg.norm(slips.mean(axis=1), axis=1) + 1e-12
        mixed = (spring.min(axis=1) < 0) & (spring.max(axis=1) > 0)
        rub = self.friction[:, 0] * np.maximum(spring, 0).mean(axis=1)
        gains = np.full(len(ranges), -1.0)
        longest = max(high - low for low, high in ranges)
        for k, (low, high) in enumerate(ranges):
            if 16 * (high - low) <= longest:
                continue
            up = np.array([x[k] == high for x in corners_of(ranges)])
            turn, lift = (x[:, up].mean(axis=1) - x[:, ~up].mean(axis=1) for x in (slips, spring))
            turned = np.minimum(np.linalg.norm(turn, axis=1) / size, 2)
            gains[k] = rub @ turned + mixed @ np.abs(lift)
        return int(gains.argmax())

    def _scales(self) -> RationalVector:
        """Return sizes of motions at which load and preload matter."""
        stiffness = self.stiffness[:, :1].sum() or 1.0
        size = 3 * float(np.abs(self.wrench * self.units).max()) / stiffness
        loose = self.preload[:, 0] / self.stiffness[:, 0]
        size = max(size, 2 * float(np.median(loose)) if len(loose) else 0.0) or 1.0
        return tuple(Fraction(2) ** (math.frexp(x)[1]) for x in (size * self.units).tolist())

    def _boxes(self) -> Iterator[dict[str, Any]]:
        """Yield boxes around the equilibrium, small to large.

        Along the first axes one of some sticking contacts slips ("pillars"), and pulls back; along
        the others none of these slips, and the loads are the changes of all forces. The others are
        turned so that what samples change at the equilibrium is spread evenly over them.
        """
        if not len(self.grasp):
            return
        if not any(self.found.solution.motion):
            yield from self._rests()
        found, n, units = self.found, self.n, self.units
        centre = np.array(found.solution.motion, float)
        slopes, pillars, bent, changes = np.zeros((n, n)), np.zeros((0, n)), [], []
        for i, (c, state) in enumerate(zip(self.grasp, found.states, strict=True)):
            if state == "detached":
                continue
            across = np.array(c.tangential_wrenches, float)
            normal, stiffness = np.array(c.normal_wrench, float), float(c.stiffness)
            limit = float(c.friction) * (float(c.preload) - stiffness * normal @ centre)
            slip, share = across @ centre, np.zeros(self.d - 1)
            size = float(np.linalg.norm(slip))
            if state != "stick" and size:
                share = -slip / size
                round_ = np.eye(self.d - 1) - np.outer(share, share)
                slopes += limit / size * across.T @ round_ @ across
            elif limit > 0:
                share = np.array(found.solution.forces[i][1:], float) / limit
                for j, row in enumerate(across):
                    longer = np.array([*pillars, row])
                    if len(longer) <= n and np.linalg.svd(longer * units)[1][-1] > 1e-6:
                        pillars = longer
                        bent.append(np.abs((self.tangent[i, :, j] - row) @ centre).max())
            along = normal + (float(c.friction) * share @ across if state != "stick" else 0)
            slopes += stiffness * np.outer(along, normal)
            force = self.normal[i] + self.friction[i][:, None] * np.einsum(
                "k,vkn->vn", share, self.tangent[i]
            )
            spring = self.preload[i] - self.stiffness[i] * (self.normal[i] @ centre)
            whole = spring[:, None] * force
            changes.append(whole - whole.mean(axis=0))
        force = np.abs(self.wrench * units).max() + max(
            float(max(map(abs, f))) for f in found.solution.forces
        )
        count, scaled = len(pillars), pillars * units
        free = np.linalg.svd(scaled)[2][count:] * units if count else np.diag(units)
        axes = np.vstack([(np.linalg.pinv(scaled) * units[:, None]).T, free])
        loads = np.vstack([pillars, free @ slopes.T])
        try:
            ways = np.linalg.inv(loads).T
            spread = np.concatenate([np.zeros((1, n)), *changes]) @ ways[count:].T
            sizes, turned = np.linalg.eigh(spread.T @ spread)
            most = sizes.max(initial=0)
            turned = turned * np.sqrt(np.maximum(sizes, 1e-6 * most) if most > 0 else 1.0)
            axes[count:], loads[count:] = turned.T @ axes[count:], turned.T @ loads[count:]
            ways = np.linalg.inv(loads).T
        except np.linalg.LinAlgError:
            return
        self.ways = [sign * way for way in ways for sign in (1, -1)]
        axes[:count] -= (axes[:count] @ slopes.T @ ways[count:].T) @ axes[count:]
        need = sum((np.abs(change @ ways.T).max(axis=0) for change in changes), np.zeros(n))
        least = _LEAST_REACH * force / np.linalg.norm(loads * units, axis=1)
        pressed = np.linalg.norm(axes[:count] @ slopes.T * units, axis=1)
        thin = 2e-5 * force / np.maximum(pressed, 1e-9)
        for factor in _FACTORS:
            reach = factor * (need + least)
            slim = np.minimum(thin, 1e-4 * reach[count:].min(initial=np.inf))
            reach[:count] = np.maximum(factor * np.array(bent), slim)
            yield {
                "centre": _dyadic(centre),
                "axes": [_dyadic(row) for row in axes * reach[:, None]],
                "loads": [_dyadic(row) for row in loads * reach[:, None]],
            }

    def _rests(self) -> Iterator[dict[str, Any]]:
        """Yield boxes of friction forces around those at rest that are least."""
        m, n, units = len(self.grasp), self.n, self.units
        limits = np.array([float(c.friction * c.preload) for c in self.grasp])
        across = np.array([c.tangential_wrenches for c in self.grasp], float).reshape(m, -1, n)
        rows = (across * limits[:, None, None]).reshape(-1, n) * units
        pressed = sum(float(c.preload) * np.array(c.normal_wrench, float) for c in self.grasp)
        if np.linalg.matrix_rank(rows) < n:
            return
        most = np.repeat(limits, self.d - 1)
        shares = -np.linalg.pinv(rows.T) @ ((pressed + self.wrench) * units)
        parts = shares.reshape(m, -1) * limits[:, None]
        forces = self.preload[..., None] * self.normal
        forces = (forces + np.einsum("mk,mvkn->mvn", parts, self.tangent)) * units
        changes = forces - forces.mean(axis=1)[:, None]
        turned = np.linalg.eigh(np.einsum("mvi,mvj->ij", changes, changes))[1]
        need = np.abs(changes @ turned).max(axis=1).sum(axis=0)
        for factor in _AT_REST:
            reach = factor * (need + _LEAST_REACH * float(most.max()))
            loads = (turned * reach).T
            pulls = (np.linalg.pinv(rows.T) @ loads.T).T * most
            yield {
                "forces": _dyadic(parts.reshape(-1)),
                "axes": [_dyadic(row) for row in -pulls],
                "loads": [_dyadic(row / units) for row in loads],
            }


def _dyadic(row: Floats) -> RationalVector:
    """Return a vector with short numbers near a given one."""
    unit = Fraction(2) ** (math.frexp(float(np.abs(row).max()))[1] - 40)
    return tuple(round(Fraction(x) / unit) * unit for x in row.tolist())


def _texts(content: Any) -> Any:
    if isinstance(content, Fraction):
        return to_text(content)
    if isinstance(content, dict):
        return {name: _texts(x) for name, x in content.items()}
    return [_texts(x) for x in content]
