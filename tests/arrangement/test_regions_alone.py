"""Regions by deletion and restriction are those that engines for all faces list."""

import math
from operator import mul
from random import Random

import numpy as np
import pytest

from arrangement import Arrangement, InputError, OutOfReachError, counts, families
from arrangement.enumeration import choose, deletion_restriction
from arrangement.enumeration.deletion_restriction import TooCloseError, list_regions
from arrangement.enumeration.sequence import FaceSequence
from arrangement.numbers import budget
from arrangement.planes.planes import Planes
from proofs_check.routes.contact_modes import f_vector_in_cone

from .oracle import regions_inside


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


@pytest.mark.parametrize("bound", [5, 1000])
def test_regions_of_more_hyperplanes_than_bits_of_a_word(bound):
    planes = _random(2, 3, 90, bound)
    assert len(planes.distinct) > 64
    listed = list_regions(planes)
    every = planes.faces(engine="great-circles").of_dimension(3)
    found = listed.signs(slice(None))
    assert sorted(map(bytes, found)) == sorted(map(bytes, every.signs))
    points = listed.points(slice(None))[:, :-1]
    assert (np.sign(points @ np.array(planes.normals, int).T) == found).all()


def test_portions_change_nothing(monkeypatch):
    planes, box = _random(4, 4, 9, 2), families.coordinate(4)
    listed = [list_regions(planes).signs(slice(None)), planes.regions(inside=box).signs]
    monkeypatch.setattr(deletion_restriction, "_PORTION", 5)
    monkeypatch.setattr(deletion_restriction, "_PRODUCTS", 50)
    again = [list_regions(planes).signs(slice(None)), planes.regions(inside=box).signs]
    for one, other in zip(listed, again, strict=True):
        assert (one == other).all()


@pytest.mark.parametrize("affine", [False, True])
@pytest.mark.parametrize("rank", range(1, 5))
def test_bound_on_regions_is_attained(rank, affine):
    for m in range(rank, 7):
        planes = families.generic(m, rank, affine=affine)
        assert choose.most_regions(m, rank, not affine) == counts.region_count(planes)
    assert choose.most_regions(50, 45, True) > 1e12


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


def _inside(planes: Arrangement, sides: Arrangement) -> FaceSequence:
    """The regions inside, compared with all regions of both, and with a count by flats."""
    found = planes.regions(inside=sides)
    rows = [*sides.integer_planes, *planes.integer_planes]
    joined = Arrangement([r[:-1] for r in rows], [r[-1] for r in rows])
    every = joined.regions().signs
    expected = every[(every[:, : len(sides)] > 0).all(axis=1), len(sides) :]
    assert sorted(map(bytes, found.signs)) == sorted(map(bytes, expected))
    for region in found:
        assert planes.signs_at(region.witness) == region.signs
        assert set(sides.signs_at(region.witness)) <= {1}
    cone = Planes([(*row[:-1], -row[-1]) for row in planes.integer_planes])
    bounds = [(*row[:-1], -row[-1]) for row in sides.integer_planes]
    upper = (*(0 for _ in range(planes.dimension)), 1)
    assert f_vector_in_cone(cone, [*bounds, upper])[-1] == len(found)
    return found


@pytest.mark.parametrize("bound", [1, 2, 9, 1000])
@pytest.mark.parametrize("d", [1, 2, 3, 4])
def test_regions_inside_are_those_of_all_that_meet_it(d, bound):
    for number in range(8):
        planes = _random(1000 * d + number, d, 1 + number % 6, bound)
        _inside(planes, _random(7 + number // 2, d, 1 + number % 5, bound))


def _low_rank(seed: int) -> tuple[Arrangement, Arrangement]:
    """Planes and sides, often few, central, coincident or of low rank."""
    source = Random(seed)
    d, bound = source.randint(0, 4), source.choice([1, 1, 2, 9])
    basis = [[source.randint(-1, 1) for _ in range(d)] for _ in range(source.randint(1, d + 1))]

    def some(count: int, central: bool) -> Arrangement:
        normals: list[list[int]] = []
        for _ in range(count if any(map(any, basis)) else 0):
            row = [0] * d
            while not any(row):
                weights = [source.randint(-bound, bound) for _ in basis]
                row = [sum(map(mul, weights, x)) for x in zip(*basis, strict=True)]
            normals.append(row)
        offsets = [0 if central else source.randint(-bound, bound) for _ in normals]
        return Arrangement(normals, offsets, dimension=d)

    kind = source.randrange(4)
    return some(source.randint(0, 5), kind < 2), some(
        source.choice([0, 0, 1, 2, 4]), kind in (0, 2)
    )


@pytest.mark.parametrize("seeds", [range(40), pytest.param(range(1000), marks=pytest.mark.slow)])
def test_regions_inside_are_those_tried_one_by_one(seeds):
    for seed in seeds:
        planes, sides = _low_rank(seed)
        found = planes.regions(inside=sides)
        listed = {region.signs for region in found}
        assert listed == regions_inside(planes, sides), seed
        assert len(found) == len(listed)
        for region in found:
            assert planes.signs_at(region.witness) == region.signs
            assert set(sides.signs_at(region.witness)) <= {1}


def test_regions_inside_are_found_where_all_would_be_too_many():
    source = Random(5)
    normals = [[source.randint(-99, 99) for _ in range(6)] for _ in range(60)]
    planes = Arrangement(normals, [source.randint(-99, 99) for _ in normals])
    axes = [[int(i == j) for j in range(6)] for i in range(6)]
    box = Arrangement([*axes, *([-x for x in row] for row in axes)], ["-1/30"] * 12)
    found = planes.regions(inside=box)
    assert found.engine == "deletion-restriction"
    assert 1 < len(found) < 100  # of about 55 million
    cone = Planes([(*row[:-1], -row[-1]) for row in planes.integer_planes])
    bounds = [(*row[:-1], -row[-1]) for row in box.integer_planes]
    assert f_vector_in_cone(cone, [*bounds, (0, 0, 0, 0, 0, 0, 1)])[-1] == len(found)


def test_too_many_regions_inside_are_refused_on_the_way(monkeypatch):
    planes, octant = _random(2, 4, 12, 9), families.coordinate(4)
    assert len(planes.regions(inside=octant)) > 25
    with budget.meter_steps():
        planes.regions(inside=octant)
        assert budget.steps_spent() > deletion_restriction.PROGRAM_STEPS * len(planes)
    monkeypatch.setattr(deletion_restriction, "_MANY", 25)
    monkeypatch.setattr(budget, "FACES", 20)
    with pytest.raises(OutOfReachError, match=r"a list of more than \d+ regions"):
        planes.regions(inside=octant)


def test_regions_inside_a_region_and_inside_nothing():
    lines = Arrangement([[1, 0], [1, 0], [0, 1]], [1, 2, 1])
    square = Arrangement([[1, 0], [1, 0], [0, 1], [0, 1]], [0, 3, 0, 3]).region_at([1, 1])
    assert len(lines.regions(inside=square)) == 6
    assert square.sides.signs_at([1, 1]) == (1, 1, 1, 1)
    between = Arrangement([[1, 0], [-1, 0]], [0, 0])
    assert len(lines.regions(inside=between)) == 0
    assert len(lines.regions(inside=Arrangement([], dimension=2))) == len(lines.regions())
    golden = families.h3()
    octant = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    assert len(golden.regions(inside=octant)) == 15
    for wrong, message in (
        (square.facets[0], "not a region"),
        (7, "give planes"),
        (golden, "R\\^3"),
    ):
        with pytest.raises(InputError, match=message):
            lines.regions(inside=wrong)


@pytest.mark.parametrize("n", [2, 3, 4, 5])
def test_shi_regions_in_a_chamber_have_published_numbers(n):
    """Catalan numbers in the dominant chamber (Shi 1997); in all chambers, every region once."""
    braid, shi = families.braid(n), families.shi(n)
    dominant = braid.region_at(range(n, 0, -1))
    assert len(shi.regions(inside=dominant)) == math.comb(2 * n, n) // (n + 1)
    if n < 5:
        inside = [len(shi.regions(inside=chamber)) for chamber in braid.regions()]
        assert sum(inside) == shi.region_count() == (n + 1) ** (n - 1)


def test_witnesses_inside_stay_inside_though_planes_are_central():
    cross = Arrangement([[1, 0], [0, 1]])
    box = Arrangement([[1, 0], [-1, 0], [0, 1], [0, -1]], ["-1/9"] * 4)
    assert all(set(box.signs_at(r.witness)) == {1} for r in cross.regions(inside=box))


def test_regions_of_a_layer_of_neurons_have_known_numbers():
    neurons = families.generic(12, 4, affine=True)
    assert (len(neurons.regions()), len(neurons.bounded_regions())) == (794, 330)  # C(11, 4)
    assert neurons.region_count() == sum(math.comb(12, i) for i in range(5))
