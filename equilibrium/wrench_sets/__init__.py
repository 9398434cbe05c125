"""Which wrenches a grasp resists: exact intervals, polygons and polyhedra, and margins.

* `line`: magnitudes along a direction; `plane`: the union of polygons in a plane of wrenches, with
  its `outline`; `space`: the whole set as polyhedra.
* `margin`: factors and preloads; `friction`: the least coefficient; `search_map`: the paper's map;
  `gaps`: where such a map fails.
* below them: `images` of one choice of contact states, `directions` in a plane.
"""

from arrangement.numbers.linear.polyhedron import Polyhedron

from .friction import FrictionBracket, least_friction
from .line import Gap, Magnitudes, gaps, resisted_magnitudes
from .margin import Margin, Preloads, margin, sufficient_preloads
from .outline import Outline, Segment
from .plane import Region, polygon_cycle, resisted_region
from .search_map import SearchMap, search_map
from .space import Piece, ResistedSet, resisted_set

__all__ = [
    "FrictionBracket",
    "Gap",
    "Magnitudes",
    "Margin",
    "Outline",
    "Piece",
    "Polyhedron",
    "Preloads",
    "Region",
    "ResistedSet",
    "SearchMap",
    "Segment",
    "gaps",
    "least_friction",
    "margin",
    "polygon_cycle",
    "resisted_magnitudes",
    "resisted_region",
    "resisted_set",
    "search_map",
    "sufficient_preloads",
]
