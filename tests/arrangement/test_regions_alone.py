"""Regions by deletion and restriction are those that engines for all faces list."""

from random import Random

import numpy as np
import pytest

from arrangement import Arrangement, OutOfReachError, counts, families
from arrangement.enumeration import choose
from arrangement.enumeration.deletion_restriction import TooCloseError, list_regions
from arrangement.enumeration.sequence import FaceSequence


def _random(number: int, d: int, m: int, bound: int) -> Arrangement:
    source = Random(number)

    def row(n: int) -> list[int]:
        return [source.randint(-bound, bound) for _ in range(n)]

    normals = [found if any(found := row(d)) else [1] * d for _ in range(m)]
    return Arrangement(normals, row(m) if number % 2 else None)


def _check(planes: Arrangement) -> None:
    level = list_regions(planes)
    found = FaceSequence(planes, [level], "deletion-restriction", planes.dimension)
    every = planes.faces(engine="any-dimension").of_dimension(planes.dimension)
    assert sorted(map(bytes, found.signs)) == sorted(map(bytes, every.signs))
    rows = np.array(planes.integer_planes, object)
    points = found.points.astype(object)
    values = points[:, :-1] @ rows[:, :-1].T - points[:, -1:] * rows[:, -1]
    assert (np.sign(values).astype(int) == found.signs).all()


@pytest.mark.parametrize("bound", [1, 2, 1000, 10**30])
@pytest.mark.parametrize("d", [2, 3, 4, 5])
def test_regions_alone_are_those_of_all_faces(d, bound):
    for number in range(6):
        planes = _random(100 * d + number, d, 3 + number, bound)
        if planes.rank > 1 + planes.is_central:
            _check(planes)


@pytest.mark.parametrize(
    "planes",
    [
        families.braid(5),
        families.coxeter("D4"),
        families.shi("A3"),
        families.near_pencil(7, 4),
        Arrangement([[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 0, 1], [-2, 0, 0, -4], [1, 1, 0, 1]]),
    ],
    ids=repr,
)
def test_degenerate_planes_have_all_their_regions(planes):
    _check(planes)


@pytest.mark.parametrize("affine", [False, True])
@pytest.mark.parametrize("rank", range(1, 5))
def test_bound_on_regions_is_attained(rank, affine):
    for m in range(rank, 7):
        planes = families.generic(m, rank, affine=affine)
        assert choose.most_regions(m, rank, not affine) == counts.region_count(planes)


def test_regions_of_many_planes_are_listed_alone():
    planes = _random(8, 6, 20, 1000)
    regions = planes.regions()
    assert regions.engine == planes.faces(6).engine == "deletion-restriction"
    assert len(regions) == len(set(map(bytes, regions.signs))) == planes.region_count() == 33328
    assert regions[7].signs == planes.signs_at(regions[7].witness)
    with pytest.raises(OutOfReachError, match=r"regions of .*count them"):
        _random(9, 9, 200, 1000).regions()


def test_planes_too_close_for_floats_are_left_to_exact_engines(monkeypatch):
    close = [[10**20 + k, k**2, k**3, k**4, 1] for k in range(8)]
    with pytest.raises(TooCloseError):
        list_regions(Arrangement(close))
    monkeypatch.setattr(choose, "_FEW", 0)
    regions = Arrangement(close).regions()
    assert regions.engine == "any-dimension"
    assert len(regions) == counts.region_count(Arrangement(close))
