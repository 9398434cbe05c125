"""Named arrangements, each with its source and its known counts.

The counts in the docstrings are statements of the literature. No function uses them; the tests
compare them with what `arrangement.counts` and the enumerators find.
"""

from .classical import (
    braid,
    coordinate,
    generic,
    h3,
    h4,
    near_pencil,
    pencil,
    perles,
    type_b,
    type_d,
)
from .combinatorial import resonance, threshold, threshold_functions
from .deformations import catalan, ish, ish_b, linial, semiorder, shi
from .graphs import bigraphical, graphical, signed_graphical
from .points import discriminantal, separations
from .polygons import regular
from .randoms import random_degenerate, random_integer, random_sphere
from .root_systems import coxeter
from .simplicial import simplicial, simplicial_entries

__all__ = [
    "bigraphical",
    "braid",
    "catalan",
    "coordinate",
    "coxeter",
    "discriminantal",
    "generic",
    "graphical",
    "h3",
    "h4",
    "ish",
    "ish_b",
    "linial",
    "near_pencil",
    "pencil",
    "perles",
    "random_degenerate",
    "random_integer",
    "random_sphere",
    "regular",
    "resonance",
    "semiorder",
    "separations",
    "shi",
    "signed_graphical",
    "simplicial",
    "simplicial_entries",
    "threshold",
    "threshold_functions",
    "type_b",
    "type_d",
]
