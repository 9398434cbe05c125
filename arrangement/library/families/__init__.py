"""Named arrangements, each with its source and its known counts.

The counts in the docstrings are statements of the literature. No function uses them; the tests
compare them with what `arrangement.counts` and the enumerators find.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from arrangement.arrangement import Arrangement

from .classical import (
    braid as braid,
    coordinate as coordinate,
    coxeter as coxeter,
    generic as generic,
    h3 as h3,
    h4 as h4,
    near_pencil as near_pencil,
    pencil as pencil,
    perles as perles,
    type_b as type_b,
    type_d as type_d,
)
from .deformations import (
    catalan as catalan,
    ish as ish,
    ish_b as ish_b,
    linial as linial,
    semiorder as semiorder,
    shi as shi,
)
from .graphs import (
    bigraphical as bigraphical,
    graphical as graphical,
    signed_graphical as signed_graphical,
)
from .points import (
    bisectors as bisectors,
    complete_bipartite as complete_bipartite,
    diagonals as diagonals,
    discriminantal as discriminantal,
    lines_through as lines_through,
    polygon as polygon,
    resonance as resonance,
    separations as separations,
    threshold as threshold,
    threshold_functions as threshold_functions,
)
from .randoms import (
    random_degenerate as random_degenerate,
    random_integer as random_integer,
    random_sphere as random_sphere,
)
from .simplicial import (
    regular as regular,
    simplicial as simplicial,
    simplicial_entries as simplicial_entries,
)

#: By their names on the command line, in the order in which they are listed.
FAMILIES: Mapping[str, Callable[..., Arrangement]] = {
    made.__name__.replace("_", "-"): made
    for made in (
        *(generic, pencil, near_pencil, coordinate, braid, type_b, type_d, coxeter),
        *(h3, h4, perles, regular, shi, catalan, linial, semiorder, ish, ish_b),
        *(graphical, bigraphical, signed_graphical, resonance, threshold, threshold_functions),
        *(
            separations,
            discriminantal,
            lines_through,
            bisectors,
            polygon,
            diagonals,
            complete_bipartite,
            random_integer,
            random_degenerate,
            random_sphere,
            simplicial,
        ),
    )
}

__all__ = [*sorted(made.__name__ for made in FAMILIES.values()), "simplicial_entries"]
