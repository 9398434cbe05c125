"""Which wrenches a grasp resists: exact intervals, polygons and polyhedra, and margins.

* `line`: magnitudes along a direction; `plane`: the union of polygons in a plane of wrenches, with
  its `outline`; `space`: the whole set as polyhedra.
* `margin`: factors and preloads; `friction`: the least coefficient; `search_map`: the paper's map;
  `gaps`: where such a map fails; `figure`: the data of the paper's figure.
* below them: `intervals`, `directions`, `cones`, `polyhedron` and `separation`.
"""

from arrangement.polyhedra.polyhedron import Polyhedron as Polyhedron

from .figure import resistance_figure as resistance_figure
from .friction import (
    FrictionBracket as FrictionBracket,
    least_friction as least_friction,
    with_friction as with_friction,
)
from .gaps import Gap as Gap, gaps as gaps
from .line import Magnitudes as Magnitudes, resisted_magnitudes as resisted_magnitudes
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
    resistible_region as resistible_region,
)
from .search_map import SearchMap as SearchMap, search_map as search_map
from .space import Piece as Piece, ResistibleSet as ResistibleSet, resistible_set as resistible_set
