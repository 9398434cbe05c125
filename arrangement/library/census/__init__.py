"""Every combinatorial type of m distinct planes of rank 3, m = 3 to 9, with a representative.

Two arrangements have the same type if one becomes the other by relabelling planes and exchanging
their sides, as far as sign vectors are concerned. The list ships with the package; the `workshop`
beside it, which made it, does not. Up to eight planes `workshop.generate` makes it again, byte for
byte; `extensions` finds the types of oriented matroids once more without coordinates, and tells
them apart by other codes. Of nine planes `workshop.build` finds the types without coordinates, and
then coordinates for each, or a proof that there are none.
"""

from .catalogue import (
    MOST_PLANES as MOST_PLANES,
    PSEUDOLINES as PSEUDOLINES,
    PUBLISHED as PUBLISHED,
    PUBLISHED_SIMPLE as PUBLISHED_SIMPLE,
    census as census,
)
from .identify import Identification as Identification, identify as identify
