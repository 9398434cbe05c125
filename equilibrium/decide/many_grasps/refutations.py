"""Proofs in floats that many questions have no equilibrium: trees of virtual motions.

As in `equilibrium.plane.search.motion_regions` the homogeneous motions ``(d_0, d)``, d_0 >= 0, are
cut into simplicial cones, here of generators that are integers in floats: a cut at a sum of two
generators is exact. A cone is closed by a virtual motion lambda: at each generator the work of the
load and of all that the contacts may do, no matter what, is at least 0, and above 0 where d_0 > 0.
The least work of a contact with spring force e is ``kappa e``, kappa = ``lambda . N - mu |lambda .
T|`` (without the absolute value where all generators slip one way), ``min(kappa, 0) max(e, 0)``
where the contact may detach, and 0 where it does everywhere. Each number is taken at the worst end
of its error.

Lambda is the nearest point to 0 of a tetrahedron of possible sums of wrenches, which changes until
it works or has 0 inside, as in the algorithm of Gilbert, Johnson and Keerthi.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np

from arrangement.numbers.float_filter import Booleans, Floats
from equilibrium.core.float_law import Batch, norms, products

from .questions import Questions

#: Spring forces at once.
_NUMBERS = 2**18
_MAX_STEPS = 7
#: Corners that come to the hull of the wrenches of a question.
_MAX_HULL_STEPS = 60
#: A hull as near to 0 is thought to have it inside.
_LEAST_SQUARE = 1e-12
#: Sums of integers up to this size are exact.
_LARGEST = 2.0**50
_ORTHANTS = np.array([np.diag([1.0, *signs]) for signs in product((1.0, -1.0), repeat=3)])
#: Pairs of three old corners.
_PAIRS = np.array([[0, 0, 1], [1, 2, 2]])


@np.errstate(all="ignore")  # what is not finite proves nothing
def are_outside_cones(questions: Questions) -> Booleans:
    """Return which loads no forces in the friction cones balance, as far as it was proved.

    The virtual motion is the point nearest to 0 of the convex hull of the load and of the forces
    ``N + mu T^T u``, ``|u| <= 1``, found as [Wolfe1976] does: the load and the contacts do at least
    its square as work. Where the hull has 0 in it there is none.
    """
    q, k = questions, questions.load.shape[1]
    proved, rows = np.zeros(len(q), dtype=bool), np.flatnonzero(np.any(q.load, axis=1))
    q = q[rows]
    corners, shares = np.zeros((len(q), k + 2, k)), np.zeros((len(q), k + 2))
    size = np.linalg.norm(q.load, axis=1)
    corners[:, 0], shares[:, 0] = q.load / size[:, None], 1.0
    for _ in range(_MAX_HULL_STEPS):
        if not len(rows):
            break
        motion = (shares[:, None] @ corners)[:, 0]
        works, least = _works_against_cones(q, motion)
        proved[rows[works]] = True
        square = (motion * motion).sum(axis=1)
        nearer = square - (least * motion).sum(axis=1) > 1e-6 * square
        going = np.flatnonzero(~works & nearer & (square > _LEAST_SQUARE))
        rows, q, corners, shares = rows[going], q[going], corners[going], shares[going]
        corners[np.arange(len(rows)), (shares == 0).argmax(axis=1)] = least[going]
        _nearest_in_hull(corners, shares)
    return proved


def _works_against_cones(q: Questions, motion: Floats) -> tuple[Booleans, Floats]:
    """Return where load and contacts surely do work, and the wrench (n, k) that does the least."""
    slips, far = q.slips(motion), products(q.reach, np.abs(motion))
    length = norms(slips)
    scale = 1 / np.sqrt(1 + q.friction * q.friction)
    work = np.where(q.present, q.least_works(motion, length) * scale, np.inf)
    doubt = (1 + 1.5 * q.friction) * (q.tilt + 2 * q.rounding) * far * scale
    load = products(q.load[:, None], motion)[:, 0]
    sure = load > 20 * q.unit * products(np.abs(q.load)[:, None], np.abs(motion))[:, 0]
    works: Booleans = sure & np.all(work >= doubt, axis=1)
    i = np.arange(len(work)), work.argmin(axis=1)
    least = q.unit_wrenches(-slips[i] / np.where(length[i] > 0, length[i], 1.0)[:, None], i)
    size = np.linalg.norm(q.load, axis=1)
    from_load = load / size < work[i]
    return works, np.where(from_load[:, None], q.load / size[:, None], least * scale[i][:, None])


def _nearest_in_hull(corners: Floats, shares: Floats) -> None:
    """Change the shares (n, c) of corners (n, c, k) to those of the point nearest to 0.

    The last corner has the share 0 yet, as the free places, which are 0.
    """
    count = shares.shape[1]
    used = np.any(corners, axis=2)
    rows = np.arange(len(shares))
    for _ in range(count):
        if not len(rows):
            break
        inside, old = used[rows], shares[rows]
        products = corners[rows] @ corners[rows].transpose(0, 2, 1) + 1e-13 * np.eye(count)
        products += np.where(inside, 0.0, 1.0)[:, None] * np.eye(count)
        new = np.linalg.solve(products, inside[..., None] * 1.0)[..., 0]
        new = np.where(inside, new / new.sum(axis=1, keepdims=True), 0.0)
        bad = inside & (new <= 1e-12)
        steps = np.where(bad, old / np.where(bad & (old > new), old - new, 1.0), 1.0)
        step = steps.min(axis=1, keepdims=True)
        moved = old + step * (new - old)
        leaving = bad & (steps <= step)
        moved[leaving] = 0.0
        used[rows] &= ~leaving
        corners[rows] *= used[rows][..., None]
        shares[rows] = moved / moved.sum(axis=1, keepdims=True)
        rows = rows[bad.any(axis=1)]


@np.errstate(all="ignore")  # what is not finite proves nothing
def have_no_equilibria(questions: Questions, max_nodes: int) -> tuple[Booleans, Floats]:
    """Return for which questions it was proved that there is no equilibrium.

    Args:
        max_nodes: cones of one question.

    Returns:
        That, and for the others a motion (n, 3) in a cone that was left open.
    """
    n = len(questions)
    inside, failed, counts = np.zeros((n, 3)), np.zeros(n, dtype=bool), np.zeros(n, dtype=np.intp)
    batch = max(1, _NUMBERS // (4 * questions.normal.shape[1]))
    open_: Any = np.zeros(
        (n, 8), [("owner", np.intp), ("cone", float, (4, 4)), ("motion", float, 3)]
    )
    open_["owner"], open_["cone"] = np.arange(n)[:, None], _ORTHANTS
    loads = questions.load[:, None]
    open_["motion"] = np.where(loads.any(axis=2, keepdims=True), loads, 1.0)
    open_ = open_.ravel()
    while len(open_):
        # The last ones first: few are waiting then.
        waiting, cut = open_[:-batch], open_[-batch:]
        counts += np.bincount(cut["owner"], minlength=n)
        closed, cut["motion"] = _Cones(questions[cut["owner"]], cut["cone"]).closed(cut["motion"])
        cut = cut[~closed]
        owners, cones = cut["owner"], cut["cone"]
        middles = (cones / np.linalg.norm(cones, axis=2, keepdims=True)).sum(axis=1)
        inside[owners] = middles[:, 1:] / np.maximum(middles[:, :1], 1e-3)
        halves = np.tile(cut, (2, 1))
        halves["cone"] = _halves(cones)
        long = np.abs(halves["cone"]).max(axis=(0, 2, 3)) > _LARGEST
        failed[owners[(counts[owners] > max_nodes) | long]] = True
        open_ = np.concatenate([waiting, halves.ravel()])
        open_ = open_[~failed[open_["owner"]]]
    return ~failed, inside


def _halves(cones: Floats) -> Floats:
    """Return both halves (2, n, 4, 4) of cones, cut across the widest angle of two generators."""
    rows, sizes = np.arange(len(cones)), np.linalg.norm(cones, axis=2)
    cosines = cones @ cones.transpose(0, 2, 1) / (sizes[:, :, None] * sizes[:, None, :])
    cosines[:, np.arange(4), np.arange(4)] = 2.0
    j, k = np.divmod(cosines.reshape(len(cones), 16).argmin(axis=1), 4)
    # Powers of two bring both to about the same length.
    powers = np.rint(np.log2(sizes[rows, k] / sizes[rows, j]))
    left, right = np.exp2(np.maximum(powers, 0)), np.exp2(np.maximum(-powers, 0))
    middle = left[:, None] * cones[rows, j] + right[:, None] * cones[rows, k]
    halves = np.stack([cones, cones])
    halves[0, rows, j] = halves[1, rows, k] = middle
    return halves


class _Cones(Batch):
    """Cones of motions, each with its question, and what the contacts do at the generators.

    Attributes:
        low, high: (n, 4, m), bounds of spring forces.
        on: (n, m), which contacts press everywhere.
        slip: (n, m), 1 or -1 where contacts slip one way everywhere, else 0.
        scale: (n, 4), about one over the size of the wrenches at a generator.
    """

    def __init__(self, q: Questions, cones: Floats) -> None:
        self.q, spread, tangents = q, q.tilt[..., None] * q.reach, q.tangents[:, :, 0]
        self.start, motions = cones[:, :, 0], cones[:, :, 1:]
        sizes, slips = np.abs(motions), motions @ tangents.transpose(0, 2, 1)
        # What is exactly 0 stays so.
        unsure, error = (
            sizes @ (spread + q.rounding * np.abs(row)).transpose(0, 2, 1)
            for row in (tangents, q.normal)
        )
        force = q.spring_forces_at(cones)
        error = q.stiffness[:, None] * error
        error += q.rounding * (self.start[..., None] * q.preload[:, None])
        self.low, self.high = force - error, force + error
        self.on: Booleans = np.all(self.low >= 0, axis=1)
        self.slip = (slips > unsure).all(axis=1) * 1.0 - (slips < -unsure).all(axis=1)
        self.pressed = np.maximum(self.high, 0.0)
        self.scale = 1 / (
            self.start * np.abs(q.load).max(axis=1)[:, None] + self.pressed.sum(axis=2) + 1e-300
        )

    def closed(self, motion: Floats) -> tuple[Booleans, Floats]:
        """Return for which cones a virtual motion was found, and the last ones that were tried.

        Args:
            motion: (n, 3), the first to try.
        """
        n = len(motion)
        outside, last, rows, cones = np.zeros(n, dtype=bool), motion.copy(), np.arange(n), self
        corners = np.full((n, 3, 3), np.nan)
        for _ in range(_MAX_STEPS):
            motion = motion / np.abs(motion).max(axis=1, keepdims=True)
            motion[~(np.abs(motion) > 2.0**-60)] = 0.0
            last[rows] = motion
            works, least = cones.works(motion)
            outside[rows[works]] = True
            motion, kept = _nearest_point(corners, least)
            reached = np.einsum("nki,ni->nk", kept, motion)
            going = ~works & ~(reached <= 1e-14).any(axis=1) & np.isfinite(motion).all(axis=1)
            rows, corners, motion = rows[going], kept[going], motion[going]
            if not len(rows):
                break
            cones = cones[going]
        return outside, last

    def works(self, motion: Floats) -> tuple[Booleans, Floats]:
        """Return which virtual motions close, and a sum of wrenches with the least work."""
        m = self.on.shape[1]
        q, slip = self.q, self.q.slips(motion)[..., 0]
        side = np.where(self.slip != 0, self.slip, np.sign(slip))
        kappa = q.least_works(motion, side * slip)
        weights = self.pressed * (self.on | (kappa < 0))[:, None]
        # At infinity something must press: the load does not count there.
        idle = (self.start == 0) & (weights @ np.ones(m) == 0)
        i, j = np.nonzero(idle)
        if len(i):
            values = np.where(self.pressed[i, j] > 0, kappa[i] * self.pressed[i, j], np.inf)
            k = values.argmin(axis=1)
            weights[i, j, k] = self.pressed[i, j, k]
            idle[i, j] = self.pressed[i, j, k] == 0
        load = products(q.load[:, None], motion)
        work = ((weights @ kappa[..., None])[..., 0] + self.start * load) * self.scale
        work[idle] = np.inf
        rows, j = np.arange(len(work)), work.argmin(axis=1)
        works = work[rows, j] >= 0
        near = np.flatnonzero(works)
        works[near] = self[near].hold(kappa[near], motion[near])
        edges = q.unit_wrenches(-side[..., None])
        sums = (weights[rows, j][:, None] @ edges)[:, 0] + self.start[rows, j][:, None] * q.load
        return works, sums * self.scale[rows, j][:, None]

    def hold(self, kappa: Floats, motion: Floats) -> Booleans:
        """Return where the least work at each generator is surely as it has to be.

        Args:
            kappa: (n, m), the support of the contacts as computed.
        """
        q, size = self.q, np.abs(motion)
        rubs = q.friction[..., None]
        doubt = (1 + rubs) * q.tilt[..., None] * q.reach
        doubt = doubt + q.rounding * (np.abs(q.normal) + rubs * np.abs(q.tangents[:, :, 0]))
        low = kappa - products(doubt, size)
        pressing = np.minimum(low[:, None] * self.low, low[:, None] * self.high)
        loose = np.minimum(low, 0.0)[:, None] * self.pressed
        terms = np.where(self.on[:, None], pressing, loose)
        total = terms.sum(axis=2) + self.start * products(q.load[:, None], motion)
        sizes = np.abs(terms).sum(axis=2) + self.start * products(np.abs(q.load)[:, None], size)
        total -= (terms.shape[2] + 10) * q.unit * sizes
        holds: Booleans = np.all(np.where(self.start > 0, total > 0, total >= 0), axis=1)
        return holds


def _nearest_point(corners: Floats, new: Floats) -> tuple[Floats, Floats]:
    """Return the point nearest to 0 of the sides of tetrahedra at a new corner.

    Args:
        corners: (n, 3, 3), the old ones, NaN where there are fewer.

    Returns:
        The point, and the corners of its side, NaN for the others.
    """
    edges = np.nan_to_num(corners - new[:, None])
    gram = edges @ edges.transpose(0, 2, 1)
    aims = -np.einsum("nki,ni->nk", edges, new)
    sizes = gram[:, [0, 1, 2], [0, 1, 2]]
    i, j = _PAIRS
    a, b, c = sizes[:, i], gram[:, i, j], sizes[:, j]
    # Of the new corner alone, and with one or two others.
    shares = np.zeros((len(new), 7, 3))
    shares[:, [1, 2, 3], [0, 1, 2]] = aims / sizes
    shares[:, [4, 5, 6], i] = (aims[:, i] * c - aims[:, j] * b) / (a * c - b * b)
    shares[:, [4, 5, 6], j] = (aims[:, j] * a - aims[:, i] * b) / (a * c - b * b)
    inside = (shares >= 0).all(axis=2) & (shares.sum(axis=2) < 1)
    nearer = np.where(inside, (shares * aims[:, None]).sum(axis=2), -np.inf)
    share = shares[np.arange(len(new)), nearer.argmax(axis=1)]
    point = new + np.einsum("nk,nki->ni", share, edges)
    kept = np.where((share > 0)[..., None], corners, np.nan)
    # There is room for the new one: a side has three corners.
    free = np.isnan(kept[..., 0]).argmax(axis=1)
    kept[np.arange(len(new)), free] = new
    return point, kept
