"""Contacts on the surface of a mesh, with normals from its facets.

The surface is read in floats (`mesh_files`). It has to be closed and oriented alike everywhere:
else there is no inside to point to. What is nearest is found in floats; the normal of a facet is
the exact one of its three stored corners, then rounded to an exact unit vector as everywhere.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import accumulate
from pathlib import Path
from random import Random
from typing import Any, TypeAlias

import numpy as np

from arrangement.errors import extra
from arrangement.numbers.exact import RationalVector, from_floats, shown, vector_text
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import cross, difference
from arrangement.numbers.packing import group_rows
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Mesh, coordinates

from .conversion import DEFAULT_TOLERANCE, Conversion, contact_values, snapped
from .incidences import converted, rounding
from .mesh_files import FARTHEST, Facets, read_triangles

#: A point is on the surface when it is no farther away than this share of the size.
_ON_SURFACE = 1e-9
#: New points have coordinates within this share of the size, as simple as possible.
_FINE = Fraction(1, 10**6)
#: Where facets meet at a larger angle than this (its cosine), the surface has no normal.
_SHARP = math.cos(math.radians(20))
#: Random contacts that have to face a direction do so within this angle (its cosine).
_FACING = math.cos(math.radians(45))
#: Facets whose nearest places are found together, which takes memory.
_AT_ONCE = 50_000
#: Grasps carry meshes of up to this many facets as their outlines.
_MOST_FACETS = 2000
#: A point on a surface, its change, and a facet there.
_Placed: TypeAlias = tuple[RationalVector, Fraction, int]


@dataclass(frozen=True)
class Surface:
    """A closed, oriented triangle mesh.

    Attributes:
        points: (V, 3), no two equal.
        facets: (F, 3); numbers of points, counter-clockwise seen from outside, no facet without
            area.
        size: the diagonal of the bounding box.
    """

    points: Floats
    facets: Facets
    size: float

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Surface:
        """Read an STL, OBJ, PLY or GLB file.

        Raises:
            InputError: no file, no mesh in it, more facets than the budget has, a surface that is
                not closed, or one that is not oriented alike everywhere.
        """
        points, facets = read_triangles(Path(path))
        points = points + 0.0  # no negative zeros
        order, new = group_rows(np.ascontiguousarray(points).view(np.uint64))
        label = np.empty(len(points), np.intp)
        label[order] = np.cumsum(new) - 1
        facets, points = label[facets], points[order[new]]  # equal points are joined
        facets = facets[(facets != np.roll(facets, -1, axis=1)).all(axis=1)]
        _check_closed(facets, len(points), path)
        whole = cls(points, facets, float(np.linalg.norm(np.ptp(points, axis=0))))
        if np.einsum("ij,ij->", whole.corners[:, 0], whole.outward) < 0:
            facets = facets[:, ::-1]
        areas = np.linalg.norm(whole.outward, axis=1)
        facets = facets[areas > (_ON_SURFACE * whole.size) ** 2]
        if not len(facets):
            raise GraspError(f"no facet of {path} has an area; give the surface of a solid")
        return replace(whole, facets=facets)

    @cached_property
    def corners(self) -> Floats:
        """(F, 3, 3); the corners of each facet."""
        corners: Floats = self.points[self.facets]
        return corners

    @cached_property
    def outward(self) -> Floats:
        """(F, 3); the outward normals of facets, twice their areas long."""
        a, b, c = self.corners.transpose(1, 0, 2)
        return np.cross(b - a, c - a)

    def exact_inward(self, facet: int) -> RationalVector:
        """Return the inward normal of a facet from the stored corners, of any length."""
        a, b, c = from_floats(self.corners[facet])
        return cross(difference(c, a), difference(b, a))

    def outline(self) -> Mesh | None:
        """Return the mesh for pictures; None beyond 2000 facets."""
        if len(self.facets) > _MOST_FACETS:
            return None
        used = np.unique(self.facets)
        number = {old: new for new, old in enumerate(used.tolist())}
        return Mesh(
            [_simple(self.points[i], self.size)[0] for i in used],
            [[number[i] for i in row] for row in self.facets.tolist()],
        )


def on_mesh(
    path: str | os.PathLike[str],
    friction: Any,
    *,
    at: Iterable[Iterable[Any]] = (),
    random: int = 0,
    seed: int = 0,
    facing: Iterable[Any] | None = None,
    smooth: bool = False,
    max_distance: Any = Fraction(1, 20),
    stiffness: Any = None,
    preload: Any = 0,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
    as_given: bool = False,
) -> Conversion:
    """Return contacts at the places of a surface that are nearest to given points, or at random.

    A point on the surface (to 10^-9 of its size) is kept; else its nearest place is taken, rounded
    to simple rationals. The point errors are the changes of the given points. The outline is the
    mesh, up to 2000 facets.

    Args:
        path: an STL, OBJ, PLY or GLB file, of a closed surface; facets without area are left out.
        friction, stiffness, preload: one for all or one for each contact; a stiffness that is
            not given is 1.
        at: points, exact.
        random: how many more places are drawn, evenly over the surface; the same for each seed.
        facing: draw only where the outward normal is within 45 degrees of this direction.
        smooth: take normals that change evenly over each facet, from those around its corners,
            instead of its own.
        max_distance: a point farther away than this share of the size is refused.
        as_given: round each normal on its own; else points move by up to 10^-6 of the size, so that
            what contacts have in common (see `from_float_data`) stays.

    Raises:
        GraspError: no closed surface; a point too far away, or at a sharp edge (over 20 degrees),
            where there is no normal; no place that faces the direction; no contact at all.
    """
    surface = Surface.read(path)
    wanted = [coordinates(point, f"point {i + 1}", 3) for i, point in enumerate(at)]
    chosen = _nearest(surface, wanted, from_floats(max_distance), smooth)
    chosen += _drawn(surface, random, seed, facing)
    if not chosen:
        raise GraspError("no contacts are requested; give points (--at) or a number (--random)")
    points, errors, facets = zip(*chosen, strict=True)
    inward: Sequence[Sequence[float | Fraction]]
    if smooth:
        inward = _smooth_inward(surface, facets, points)
    else:
        inward = [surface.exact_inward(facet) for facet in facets]
    return converted(
        points,
        inward,
        contact_values(len(chosen), friction, stiffness, preload),
        rounding(0, _FINE * Fraction(surface.size), angle_tolerance, as_given),
        outline=surface.outline(),
        point_errors=errors,
    )


def _check_closed(facets: Facets, points: int, name: str | os.PathLike[str]) -> None:
    """Refuse a surface unless each edge has one facet on each side, oriented alike."""
    ahead, back = facets, np.roll(facets, -1, axis=1)
    edges = np.minimum(ahead, back) * points + np.maximum(ahead, back)
    sizes = np.unique(edges, return_counts=True)[1]
    if odd := int((sizes != 2).sum()):
        raise GraspError(
            f"{name} is not watertight: {odd} of its {len(sizes)} edges do not have two facets, so "
            "it has no inside; close the surface first"
        )
    if len(np.unique(ahead * points + back)) < facets.size:
        raise GraspError(
            f"the facets of {name} are not oriented alike: neighbours turn opposite ways, so it "
            "has no inside; orient them first"
        )


def _nearest(
    surface: Surface, wanted: Sequence[RationalVector], max_distance: Fraction, smooth: bool
) -> list[_Placed]:
    """Return for each point its place on the surface."""
    if not wanted:
        return []
    with extra("mesh"):
        from trimesh.triangles import closest_point

    corners, fine = surface.corners, _ON_SURFACE * surface.size
    centres = corners.mean(axis=1)
    reach = np.linalg.norm(corners - centres[:, None], axis=2).max(axis=1)
    nearest: list[_Placed] = []
    for i, point in enumerate(wanted, 1):
        if max(map(abs, point)) > FARTHEST:
            raise GraspError(f"point {i} is beyond 1e60; give a place near the surface")
        here, name = np.array(point, float), f"point {i} {vector_text(point)}"
        away = np.linalg.norm(centres - here, axis=1)
        near = np.flatnonzero(away - reach <= away.min() + fine)
        parts = np.array_split(near, len(near) // _AT_ONCE + 1)
        places = np.concatenate(
            [closest_point(corners[p], np.tile(here, (len(p), 1))) for p in parts]  # type: ignore[no-untyped-call]
        )
        distances = np.linalg.norm(places - here, axis=1)
        least = float(distances.min())
        if least > max_distance * Fraction(surface.size):
            raise GraspError(
                f"{name} is {least:.4g} from the surface, more than {shown(max_distance)} of its "
                f"size {surface.size:.4g}; give a nearer point, or a larger share (--max-distance)"
            )
        ties = near[distances <= least + fine]
        if not smooth:
            _check_smooth(surface.outward[ties], name)
        best = places[distances.argmin()]
        place = _simple(best, surface.size, point) if least > fine else (point, Fraction(0))
        nearest.append((*place, int(ties[0])))
    return nearest


def _check_smooth(normals: Floats, name: str) -> None:
    """Refuse a place at which facets meet at a large angle."""
    units = normals / np.linalg.norm(normals, axis=1)[:, None]
    if (units @ units.T).min() < _SHARP:
        raise GraspError(
            f"{name} is at a sharp edge, where facets meet and there is no one normal; move it "
            "into a facet, or take smooth normals (--smooth)"
        )


def _drawn(surface: Surface, number: int, seed: int, facing: Iterable[Any] | None) -> list[_Placed]:
    """Return random places, evenly spread by area over the facets that may be chosen."""
    if not number:
        if facing is not None:
            raise GraspError("--facing restricts random contacts; add --random")
        return []
    normals = surface.outward
    areas = np.linalg.norm(normals, axis=1)
    chosen = np.arange(len(areas))
    if facing is not None:
        direction = coordinates(facing, "facing", 3)
        if not any(direction):
            raise GraspError("facing is the zero vector; give a direction")
        towards = np.array([x / max(map(abs, direction)) for x in direction], float)
        cosines = normals @ towards / (areas * np.linalg.norm(towards))
        chosen = np.flatnonzero(cosines >= _FACING)
        if not len(chosen):
            raise GraspError(
                f"no facet faces {vector_text(direction)} within 45 degrees; give another direction"
            )
    source = Random(f"mesh {seed}")
    sums = list(accumulate(areas[chosen].tolist()))
    drawn: list[_Placed] = []
    for _ in range(number):
        facet = int(source.choices(chosen, cum_weights=sums)[0])
        a, b = sorted((source.random(), source.random()))
        place = np.array([a, b - a, 1 - b]) @ surface.corners[facet]
        drawn.append((*_simple(place, surface.size), facet))
    return drawn


def _smooth_inward(
    surface: Surface, facets: Sequence[int], places: Sequence[RationalVector]
) -> list[tuple[float, ...]]:
    """Return inward normals between those of the corners, which are means over facets by area."""
    with extra("mesh"):
        from trimesh.triangles import points_to_barycentric

    at_points = np.zeros_like(surface.points)
    for column in surface.facets.T:
        np.add.at(at_points, column, surface.outward)
    lengths = np.linalg.norm(at_points, axis=1)
    at_points /= np.where(lengths > 0, lengths, 1)[:, None]
    chosen, at = np.array(facets), np.array(places, float)
    shares = points_to_barycentric(surface.corners[chosen], at)  # type: ignore[no-untyped-call]
    between = -np.einsum("ij,ijk->ik", shares, at_points[surface.facets[chosen]])
    return [tuple(row) for row in between.tolist()]


def _simple(
    place: Floats, size: float, wanted: RationalVector | None = None
) -> tuple[RationalVector, Fraction]:
    """Return simple rationals near a point, and their largest change from it or a wanted point."""
    point = tuple(snapped(x, _FINE * Fraction(size))[0] for x in place.tolist())
    return point, max(map(abs, difference(point, wanted or from_floats(place))))
