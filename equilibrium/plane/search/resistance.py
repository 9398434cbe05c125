"""Whether anything balances a load: an equilibrium, or a proof that there is none."""

from __future__ import annotations

import json
import math
import time

from arrangement.numbers.exact import RationalVector
from equilibrium.model.errors import TimeLimitError
from equilibrium.plane.contacts import IntegerContacts

from .continuation import find_equilibrium
from .motion_regions import HALF_SPACE, MotionRegions
from .part_program import Node
from .state_equilibrium import Solution
from .state_splits import StateSplits, TooManyParts

#: Other searches that may find a smaller proof: rounds and turn, see `MotionRegions`.
_SEARCHES = ((3, 1.0), (10, 1.0), (8, 0.5), (8, 2.0))
#: Up to how many contacts, and with how many programs, states alone are tried for a smaller proof.
_FEW, _PARTS = 12, 100


def resistance(
    contacts: IntegerContacts,
    wrench: RationalVector,
    time_limit: float | None = None,
    shorten: bool = False,
) -> Solution | Node:
    """Return an equilibrium, or the tree that proves that there is none; always one of the two.

    Args:
        time_limit: in seconds.
        shorten: try for a smaller tree, within the time.

    Raises:
        TimeLimitError: the time has passed.
    """
    deadline = math.inf if time_limit is None else time.monotonic() + time_limit
    regions = MotionRegions(contacts, wrench, deadline)
    leaf = regions.half_space()
    if leaf is not None:
        return leaf
    found = find_equilibrium(contacts, wrench) or regions.search()
    if isinstance(found, Solution) or not shorten:
        return found
    return min(
        (found, *_others(contacts, wrench, deadline)), key=lambda tree: len(json.dumps(tree))
    )


def _others(contacts: IntegerContacts, wrench: RationalVector, deadline: float) -> list[Node]:
    """Return other proofs of the same, as many as there is time for."""
    trees = []
    try:
        if len(contacts) <= _FEW:
            trees.append(StateSplits(contacts, wrench, HALF_SPACE, _PARTS, deadline).decide())
    except TooManyParts:
        pass
    try:
        for rounds, turn in _SEARCHES:
            trees.append(MotionRegions(contacts, wrench, deadline, rounds, turn).search())
    except TimeLimitError:
        pass
    return trees
