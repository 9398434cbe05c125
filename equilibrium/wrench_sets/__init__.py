"""Which wrenches a grasp resists: exact intervals, polygons and polyhedra, and margins.

* `line`: magnitudes along a direction; `plane`: the union of polygons in a plane of wrenches, with
  its `outline`; `space`: the whole set as polyhedra.
* `loads`: arrays of loads on one grasp.
* `any_direction`: the smallest wrench that is not resisted.
* `margin`: factors and preloads; `friction`: the least coefficient; `search_map`: the paper's map.
* `spatial`: brackets of magnitudes of grasps in space.
"""

from arrangement.numbers.linear.polyhedron import Polyhedron as Polyhedron

from .any_direction import (
    SmallestUnresisted as SmallestUnresisted,
    smallest_unresisted_wrench as smallest_unresisted_wrench,
)
from .friction import FrictionBracket as FrictionBracket, least_friction as least_friction
from .line import (
    Magnitudes as Magnitudes,
    resisted_magnitudes as resisted_magnitudes,
)
from .loads import CheckedLoads as CheckedLoads, check_loads as check_loads
from .margin import (
    Margin as Margin,
    Preloads as Preloads,
    margin as margin,
    sufficient_preloads as sufficient_preloads,
)
from .outline import Outline as Outline, Segment as Segment
from .plane import (
    Region as Region,
    polygon_cycle as polygon_cycle,
    resisted_region as resisted_region,
)
from .search_map import SearchMap as SearchMap, search_map as search_map
from .space import Piece as Piece, ResistedSet as ResistedSet, resisted_set as resisted_set
