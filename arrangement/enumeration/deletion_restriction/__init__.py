"""Regions alone, by deletion and restriction: no face of lower dimension is listed.

Hyperplanes are added one by one. A new one, H, cuts exactly those regions of the others that have a
region of the restriction to H in their closure, and these have the same signs at the others. So the
regions of the restriction, listed first in the same way, say which regions are cut in two, and
every other region is on one side of H. Of a central arrangement only the half on the positive
side of the first hyperplane is listed; of an affine one that is all, if infinity comes first. So
may the regions be listed that are on the positive side of several hyperplanes, the first ones: a
linear program has a point there or none, in each restriction.

1. Downwards, all restrictions of one dimension are made at once (`restrictions`), to rank 2.
2. There each arrangement is sorted around the origin, all with one sort.
3. Upwards, step j of a dimension adds hyperplane j of all its arrangements. The regions that it
   cuts are found by one sort of sign vectors, with the number of the arrangement before each.

**Exactness.** Restrictions are integral, so the number of regions listed is exact whatever floats
do: m on one side of the first of m lines of rank 2, and beyond that

    regions of A = regions of A without H + regions of the restriction to H.

Witnesses are floats, hence rational numbers. In the end each sign of each witness is compared with
a bound on the rounding error, and the sign vectors are seen to be distinct: then they are regions,
and all of them. Inside several hyperplanes the same holds from the first one on that is no side; in
rank 2 all points are compared before those outside are left out. Where floats do not suffice
(`TooCloseError`), the caller lists all faces instead.
Sums are formed in one order, elementwise, so that witnesses are the same on every machine.

Source: T. Zaslavsky, Facing up to arrangements, Memoirs AMS 154 (1975), for the counts; B. Sleumer,
Output-sensitive cell enumeration in hyperplane arrangements, Nordic J. Comput. 6 (1999), for lists
of regions alone.
Complexity: at most C(m, r - 2) restrictions to rank 2 for m hyperplanes of rank r, and by the
equation above fewer than R regions of all restrictions to one dimension, for R in the end. So
O(m R r^2) numbers, in O(m r) calls of NumPy and more only for portions of a fixed size; memory
O(R (r + m / 64)).
"""

from .half_regions import TooCloseError as TooCloseError
from .listing import (
    REGION_BYTES as REGION_BYTES,
    REGION_STEPS as REGION_STEPS,
    RESTRICTION_STEPS as RESTRICTION_STEPS,
    list_regions as list_regions,
)
