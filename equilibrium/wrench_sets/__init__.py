"""Which wrenches a grasp resists: exact intervals, polygons and polyhedra, and margins.

* `resisted_set`: the class `ResistedSet`, whose methods the other modules compute.
* `line`: magnitudes along a direction, factors and preloads; `slice`: the union of polygons in a
  plane of wrenches, with its `outline`; `polyhedra`: the whole set.
* `loads`: arrays of loads on one grasp.
* `any_direction`: the smallest wrench that is not resisted, and the least force at a point.
* `friction`: the least coefficient; `search_map`: the paper's map.
* `parameter`: values of a letter in the data; `sufficient_friction`: the least friction of named
  contacts by it, both with certificates.
* `along_in_space`: brackets of magnitudes of grasps in space.
* `text`: all of these as lines for people.
"""

from arrangement.numbers.linear.polyhedron import Polyhedron as Polyhedron

from .any_direction import (
    BestDirection as BestDirection,
    SmallestUnresisted as SmallestUnresisted,
)
from .friction import FrictionBracket as FrictionBracket
from .line import Magnitudes as Magnitudes, Margin as Margin, Preloads as Preloads
from .loads import CheckedLoads as CheckedLoads
from .outline import Outline as Outline, Segment as Segment
from .polyhedra import Piece as Piece
from .resisted_set import ResistedSet as ResistedSet
from .search_map import SearchMap as SearchMap
from .slice import Region as Region, polygon_cycle as polygon_cycle
