"""The visible and the hidden half of a great-circle arrangement, cut exactly at the limb.

The plane of the limb joins the arrangement as one more plane, so that the exact engine itself
does the cutting. Floats begin when arcs become curves.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property, partial

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import Choice, Colouring, DrawnRegion, colouring
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.sight import (
    Score,
    best_view,
    picture_axes,
    turned,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.enumeration.great_circles.signs import PackedSigns, unpack
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector
from arrangement.pictures.parts.coordinates import orbits
from arrangement.planes.planes import Planes


class Globe:
    """A central arrangement in R^3 seen from a direction, in the orthographic projection.

    Attributes:
        whole: the arrangement on the sphere.
        cut: the same with the limb as one more plane, the last one.
        direction: the primitive integer direction towards the viewer.
        axes: (3, 3); the unit vectors right, up and towards the viewer.
    """

    def __init__(
        self,
        arrangement: Arrangement,
        direction: Sequence[object] | None = None,
        azimuth: float = 0.0,
    ) -> None:
        budget.check_size(len(arrangement.distinct), "great circles in a picture")
        self.whole = sphere_arrangement(arrangement)
        if direction is not None:
            self.direction = view_direction(direction)
        else:
            self.direction = clear_direction(*self.lines())
        self.direction = turned(self.direction, azimuth)
        self.cut = sphere_arrangement(Arrangement([*arrangement.normals, self.direction]))
        self.axes = picture_axes(self.direction)

    def lines(self) -> tuple[list[IntegerVector], list[float]]:
        """Return what is to stay off the limb, normals and rays, and how many times nearer it may.

        A ray on three planes or more is to stay away farthest.
        """
        whole = self.whole
        count = [len(whole.incidence.circles_at(v)) for v in range(whole.vertex_count)]
        many = max(count, default=2) > 2
        times = [2.0 * many or 1.0] * whole.circle_count
        times += [3.0 if many and k == 2 else 1.0 for k in count]
        return [*whole.circle_normals, *map(whole.ray, range(whole.vertex_count))], times

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
        return tuple(map(DrawnRegion, region_signs(self.whole), degrees))

    @cached_property
    def front(self) -> dict[int, DrawnRegion]:
        """The regions of `cut` on the near side, each with the region of which it is a part."""
        sides = {region.signs: region for region in self.regions}
        cut = enumerate(region_signs(self.cut))
        return {piece: sides[signs[:-1]] for piece, signs in cut if signs[-1] > 0}

    def colouring(self, colour: Choice | None) -> Colouring:
        """Return how the regions are coloured; see `colours.colouring`."""
        beside = self.whole.incidence.region[: 2 * self.whole.arc_count].tolist()
        pairs = list(zip(beside[::2], beside[1::2], strict=True))
        planes, signs = self.whole.arrangement, [region.signs for region in self.regions]
        found = partial(orbits, planes, signs)
        return colouring(colour, self.regions, pairs, planes.firsts, found)

    @cached_property
    def limb(self) -> int:
        """The circle of the limb."""
        return int(self.cut.plane_circle[-1])


def region_signs(sphere: SphereArrangement) -> list[tuple[int, ...]]:
    """Return the sign vectors of all regions."""
    positive = sphere.packed_region_signs
    return sign_vectors(sphere, (positive, ~positive))


def sign_vectors(
    sphere: SphereArrangement, packed: tuple[PackedSigns, PackedSigns]
) -> list[tuple[int, ...]]:
    """Return sign vectors, given where they are + and where they are -."""
    return [tuple(row) for row in unpack(*packed, len(sphere.arrangement)).tolist()]


def clear_direction(
    lines: Sequence[IntegerVector], times: Sequence[float] = (), also: Score | None = None
) -> IntegerVector:
    """Return a direction from above that is as far as can be from orthogonal to all `lines`.

    With the normals of planes as lines no plane is seen edge-on; with the rays as well, no ray
    is near the limb. A line may be `times` as near as others; `also` returns more numbers to be
    kept from 0.
    """
    units = unit_vectors([*lines, (0, 0, 1)])

    def score(seen: Sequence[IntegerVector]) -> Floats:
        least = (np.abs(unit_vectors(seen) @ units.T) * [*(times or [1.0] * len(lines)), 1.0]).min(
            axis=1
        )
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
