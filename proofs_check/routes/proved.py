"""A third route for claims about counts: the program that is proved in Coq."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from arrangement.errors import OutOfReachError
from arrangement.numbers import budget
from arrangement.planes.planes import Planes
from arrangement.planes.proved import proved_f_vector, proved_whitney_numbers


def _tests(planes: Planes) -> int:
    """Return the regions of the first i planes, for i below their number."""
    starts = (Planes(planes.normals[:i]) for i in range(1, len(planes)))
    return 1 + sum(sum(map(abs, proved_whitney_numbers(start))) for start in starts)


def _of_faces(quantity: Callable[[tuple[int, ...]], Any]) -> Callable[[Planes], Any]:
    return lambda planes: quantity(proved_f_vector(planes))


_REGIONS = _of_faces(lambda f: f[-1])
_F_VECTOR = _of_faces(lambda f: f)
_DUAL = _of_faces(lambda f: (f[3], f[2], f[1]))


def _regions_in_print(planes: Planes) -> Any:
    """The number of regions; irrational entries, and tens of millions of regions, are beyond it."""
    if planes.field is not None:
        return NotImplemented
    try:
        with budget.limit(1):  # also in a claim that may take its time
            return sum(map(abs, proved_whitney_numbers(planes)))
    except OutOfReachError:
        return NotImplemented


def _slip_states(contacts: Any) -> tuple[int, int]:
    """The faces of the tangent planes of contacts, and of as many in general position."""
    slips = [row for contact in contacts for row in contact.tangential_wrenches]
    n = len(slips[0])
    curve = [[t**k for k in range(n)] for t in range(len(slips))]
    planes = (Planes(rows, dimension=n) for rows in (slips, curve))
    states, general = (sum(proved_f_vector(planes_set)) for planes_set in planes)
    return states, general


def _of_motions(grasp: Any) -> tuple[int, ...]:
    """Return the f-vector of the planes at which the state of some contact changes."""
    return proved_f_vector(grasp.motion_arrangement())


#: The quantities of claims, by their ids.
COUNTS: Mapping[str, Callable[[Any], Any]] = {
    "great-circle-regions": _REGIONS,
    "state-formula": _F_VECTOR,
    "fukuda-bound": _F_VECTOR,
    "fukuda-bound-attained": _F_VECTOR,
    "bound-not-attained": _F_VECTOR,
    "step-1-square-bound": _REGIONS,
    "euler": _DUAL,
    "dual-edge-and-face-bounds": _DUAL,
    "dual-bipartite-bounds": _DUAL,
    "step-1-time": _tests,
    "step-2-time": _of_faces(lambda f: math.comb(f[-1], 2)),
    "step-3-time": _of_faces(lambda f: (f[3], f[2])),
    "slip-state-counts": _of_faces(lambda f: f[3] + f[2] + (f[2] - f[3] + 2)),
    "different-slip-states": _of_faces(sum),
    "model-faces-without-preload": _of_motions,
    "model-faces-with-preload": _of_motions,
    "model-linear-by-regions": _of_motions,
    "slip-states-in-space": _slip_states,
    "slip-states-of-two-bodies": _slip_states,
    "regions-in-print": _regions_in_print,
    "small-regions-in-print": _regions_in_print,
    "large-regions-in-print": _regions_in_print,
}
