"""Every isomorphism class of m distinct planes of rank 3, m = 3 to 9, with a representative.

Two arrangements are isomorphic if one becomes the other by relabelling and reorientation, as far as
sign vectors are concerned. The list ships with the package; ``make census`` computes it again, in a
checkout (`tests/census`).
"""

from arrangement.planes.identification import Identification as Identification

from .catalogue import (
    MOST_LINES as MOST_LINES,
    MOST_PLANES as MOST_PLANES,
    PSEUDOLINES as PSEUDOLINES,
    PUBLISHED as PUBLISHED,
    PUBLISHED_SIMPLE as PUBLISHED_SIMPLE,
    census as census,
    lines as lines,
)
from .identify import identify as identify
