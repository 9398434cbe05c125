"""The visible and the hidden half of a great-circle arrangement, cut exactly at the limb.

The plane of the limb joins the arrangement as one more plane, so that the exact engine itself
does the cutting. Floats begin when arcs become curves.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import Colouring, DrawnRegion, Painter, colouring
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import (
    Score,
    best_view,
    picture_axes,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.enumeration.great_circles.signs import unpack
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector
from arrangement.planes.planes import Planes


class Globe:
    """A central arrangement in R^3 seen from a direction, in the orthographic projection.

    Attributes:
        whole: the arrangement on the sphere.
        cut: the same with the limb as one more plane, the last one.
        direction: the primitive integer direction towards the viewer.
        axes: (3, 3); the unit vectors right, up and towards the viewer.
    """

    def __init__(self, arrangement: Arrangement, direction: Sequence[object] | None = None) -> None:
        budget.keep(len(arrangement.distinct), "great circles in a picture")
        self.whole = sphere_arrangement(arrangement)
        if direction is not None:
            self.direction = view_direction(direction)
        else:
            rays = [self.whole.ray(v) for v in range(self.whole.vertex_count)]
            self.direction = clear_direction([*self.whole.circle_normals, *rays])
        self.cut = sphere_arrangement(Arrangement([*arrangement.normals, self.direction]))
        self.axes = picture_axes(self.direction)

    @cached_property
    def points(self) -> Floats:
        """(V, 3); the vertices of `cut`, in the axes of the picture."""
        rays = [self.cut.ray(v) for v in range(self.cut.vertex_count)]
        return unit_vectors(rays) @ self.axes.T

    @cached_property
    def normals(self) -> Floats:
        """(c, 3); the unit normals of the circles of `cut`, in the axes of the picture."""
        return unit_vectors(self.cut.circle_normals) @ self.axes.T

    @cached_property
    def regions(self) -> tuple[DrawnRegion, ...]:
        """All regions of `whole`, in its order."""
        degrees = self.whole.incidence.region_degree.tolist()
        return tuple(map(DrawnRegion, _region_signs(self.whole), degrees))

    @cached_property
    def front(self) -> dict[int, DrawnRegion]:
        """The regions of `cut` on the near side, each with the region of which it is a part."""
        sides = {region.signs: region for region in self.regions}
        cut = enumerate(_region_signs(self.cut))
        return {piece: sides[signs[:-1]] for piece, signs in cut if signs[-1] > 0}

    def colouring(self, colour: str | Painter | None, antipodes: str | None) -> Colouring:
        """Return how the regions are coloured; see `colours.colouring`."""
        beside = self.whole.incidence.region[: 2 * self.whole.arc_count].tolist()
        pairs = list(zip(beside[::2], beside[1::2], strict=True))
        return colouring(colour, antipodes, self.regions, pairs, self.whole.arrangement.firsts)

    @cached_property
    def limb(self) -> int:
        """The circle of the limb."""
        return int(self.cut.plane_circle[-1])


def _region_signs(sphere: SphereArrangement) -> list[tuple[int, ...]]:
    """Return the sign vectors of all regions."""
    positive = sphere.packed_region_signs
    signs = unpack(positive, ~positive, len(sphere.arrangement))
    return [tuple(row) for row in signs.tolist()]


def clear_direction(lines: Sequence[IntegerVector], also: Score | None = None) -> IntegerVector:
    """Return a direction from above that is as far as can be from orthogonal to all `lines`.

    With the normals of planes as lines no plane is seen edge-on; with the rays as well, no ray
    is near the limb. `also` returns more numbers to be kept from 0.
    """
    units = unit_vectors([*lines, (0, 0, 1)])

    def score(seen: Sequence[IntegerVector]) -> Floats:
        least = np.abs(unit_vectors(seen) @ units.T).min(axis=1)
        # A line alone is not seen from straight ahead.
        least = np.minimum(least, 1.2 - least)
        found: Floats = least if also is None else np.minimum(least, also(seen))
        return found

    return best_view(views(range(1, 8), range(-7, 8), range(1, 7), low=0.25, high=0.75), score)


def far_direction(arrangement: Planes, lines: Floats) -> IntegerVector:
    """Return the direction farthest from orthogonal to unit vectors, on the fewest planes."""
    return best_view(
        views(*[range(-7, 8)] * 3),
        lambda seen: np.abs(unit_vectors(seen) @ lines.T).min(axis=1),
        lambda seen: [sum(arrangement.signs_at(v)) for v in seen],
    )
