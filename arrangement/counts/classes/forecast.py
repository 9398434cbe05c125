"""How long a count by classes of flats will take, from a sample of the flats of each rank.

Ranks with few classes are done; of others a random sample is. Each half of a sample leads to some
classes of the next rank. If it were by chance whether a class comes up, their number would be the
product of what the halves found, divided by what both found: capture and recapture. Classes with
many flats below come up more often than others, so that numbers come out too small, the more so
the further a rank is from the last one that was done.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from arrangement.console.progress import watched
from arrangement.counts.configuration import configuration
from arrangement.planes.planes import Planes

from .automorphisms import Automorphisms
from .symmetric import Flats, classes

#: Classes in a sample.
SAMPLE = 2000


@dataclass(frozen=True)
class RankForecast:
    """What the flats of one rank will take.

    Attributes:
        rank: of the flats.
        classes: of them; those above which are looked for.
        exact: whether they were all counted.
        seconds: of one processor, for all flats above them.
        megabytes: of memory, for one flat of each class.
    """

    rank: int
    classes: int
    exact: bool
    seconds: float
    megabytes: float


def forecast(arrangement: Planes, sample: int = SAMPLE) -> Iterator[RankForecast]:
    """Yield what each rank will take in `first_whitney_numbers`, as soon as it is measured.

    Source: for the number of classes, G. Seber, The Estimation of Animal Abundance (1982),
    chapter 3 (Petersen's method).

    >>> from arrangement.library import families
    >>> [(entry.rank, entry.exact) for entry in forecast(families.resonance(5))]
    [(0, True), (1, True), (2, True), (3, True)]
    """
    config = configuration(arrangement)
    made = classes(config, Automorphisms(config).generators(), math.inf)
    generator = np.random.default_rng(0)
    flats, number, exact = made.bottom(), 1.0, True
    for rank in watched(range(1, made.rank), "ranks"):
        chosen = flats
        if len(flats) > sample:
            chosen = flats[generator.permutation(len(flats))[:sample]]
        began = time.process_time()
        halves = [made.above(chosen[k::2], rank)[0] for k in (0, 1)]
        seconds = (time.process_time() - began) / len(chosen) * number
        yield RankForecast(rank - 1, round(number), exact, seconds, number * _bytes(flats) / 2**20)
        if rank == made.rank - 1:
            return
        flats = made.merged(Flats.joined([half for half in halves if len(half)]))
        exact = exact and len(chosen) == number
        both = sum(map(len, halves)) - len(flats)
        number = len(flats) if exact else math.prod(map(len, halves)) / max(1, both)


def _bytes(flats: Flats) -> float:
    arrays = (flats.bases, flats.members, flats.images, flats.values)
    return sum(array.nbytes for array in arrays) / len(flats)
