"""The visible and the hidden half of a great-circle arrangement, cut exactly at the limb.

The plane of the limb joins the arrangement as one more plane, so that the exact engine itself
does the cutting. Floats begin when arcs become curves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import product

import numpy as np
import numpy.typing as npt

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import Colouring, DrawnRegion, Painter, colouring
from arrangement.drawing.scene.items import LIGHT
from arrangement.enumeration.great_circles import SphereArrangement, sphere_arrangement
from arrangement.enumeration.great_circles.signs import unpack
from arrangement.errors import InputError
from arrangement.numbers.exact import IntegerVector, primitive, shown
from arrangement.numbers.real_entries import real_vector
from arrangement.planes.planes import Planes

Floats = npt.NDArray[np.float64]
#: Circles beyond which a picture of one column shows nothing.
MAX_CIRCLES = 60
#: The unit vector towards the light, in the axes of a picture: the same for balls and solids.
TO_LIGHT = np.array([*LIGHT, (1 - LIGHT[0] ** 2 - LIGHT[1] ** 2) ** 0.5])


class Globe:
    """A central arrangement in R^3 seen from a direction, in the orthographic projection.

    Attributes:
        whole: the arrangement on the sphere.
        cut: the same with the limb as one more plane, the last one.
        direction: the primitive integer direction towards the viewer.
        axes: (3, 3); the unit vectors right, up and towards the viewer.
    """

    def __init__(self, arrangement: Arrangement, direction: Sequence[object] | None = None) -> None:
        self.whole = sphere_arrangement(arrangement)
        if self.whole.circle_count > MAX_CIRCLES:
            raise InputError(
                f"{self.whole.circle_count} great circles; a picture shows at most {MAX_CIRCLES}"
            )
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
        classes = self.whole.arrangement.distinct
        return colouring(colour, antipodes, self.regions, pairs, classes)

    @cached_property
    def limb(self) -> int:
        """The circle of the limb."""
        return int(self.cut.plane_circle[-1])


def _region_signs(sphere: SphereArrangement) -> list[tuple[int, ...]]:
    """Return the sign vectors of all regions."""
    positive = sphere.packed_region_signs
    signs = unpack(positive, ~positive, len(sphere.arrangement))
    return [tuple(row) for row in signs.tolist()]


def view_direction(direction: Sequence[object]) -> IntegerVector:
    """Return the direction towards the viewer as a primitive integer vector, or refuse it."""
    vector = primitive(real_vector(direction, "direction"))
    if len(vector) != 3 or not any(vector):
        raise InputError(f"the direction is {shown(vector)}; give three numbers that are not all 0")
    return vector


def clear_direction(
    lines: Sequence[IntegerVector], also: Callable[[Floats], Floats] | None = None
) -> IntegerVector:
    """Return a direction from above that is as far as can be from orthogonal to all `lines`.

    With the normals of planes as lines no plane is seen edge-on; with the rays as well, no ray
    is near the limb. `also` takes unit vectors and returns more numbers to be kept from 0.
    """
    views = [v for v in product(range(1, 8), range(-7, 8), range(1, 7)) if primitive(v) == v]
    units = unit_vectors(views)
    score = np.abs(units @ unit_vectors([*lines, (0, 0, 1)]).T).min(axis=1)
    # A line alone is not seen from straight ahead.
    score = np.minimum(score, 1.2 - score)
    if also is not None:
        score = np.minimum(score, also(units))
    high = (units[:, 2] > 0.25) & (units[:, 2] < 0.75)
    return views[int(np.argmax(np.round(np.where(high, score, -1.0), 9)))]


def best_direction(
    arrangement: Planes, score: Callable[[Floats], Floats], preferred: Sequence[IntegerVector] = ()
) -> IntegerVector:
    """Return the direction with the highest score of its unit vector, on the fewest planes.

    One of the preferred directions is taken if hardly any other is better.
    """
    views = [v for v in product(range(-7, 8), repeat=3) if any(v) and primitive(v) == v]
    scores = np.round(score(unit_vectors(views)), 6)
    at_these = score(unit_vectors(preferred)).round(3)
    if at_these.max(initial=0.0) > 0.98 * scores.max():
        return preferred[int(np.argmax(at_these))]
    best = [views[k] for k in np.flatnonzero(scores == scores.max())]
    return max(best, key=lambda v: sum(arrangement.signs_at(v)))


def picture_axes(direction: IntegerVector) -> Floats:
    """Return the unit vectors right, up and towards the viewer, (3, 3); z is up in the picture."""
    ahead = unit_vectors([direction])[0]
    upright = direction[0] or direction[1]
    right = np.cross([0.0, 0.0, 1.0], ahead) if upright else np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(ahead, right), ahead])


def unit_vectors(vectors: Sequence[IntegerVector]) -> Floats:
    """Return unit vectors; integers of any length are divided before they become floats."""
    scaled = np.array([[float(x / max(map(abs, v))) for x in v] for v in vectors]).reshape(-1, 3)
    unit: Floats = scaled / np.linalg.norm(scaled, axis=1, keepdims=True)
    return unit
