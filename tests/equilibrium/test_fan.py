"""Faces inside a cone: listed by cutting fans, counted from flats, and taken from all faces."""

from collections.abc import Sequence
from random import Random

import numpy as np
import pytest

from arrangement import Arrangement
from equilibrium.modes import Fan
from proofs_check.routes.contact_modes import f_vector_in_cone

Row = tuple[int, ...]


def inside(inequalities: Sequence[Row], planes: Sequence[Row], n: int) -> Fan:
    fan = Fan.space(n)
    for row in inequalities:
        fan = fan.cut(row, (0, 1))
    for row in planes:
        fan = fan.cut(row)
    return fan


def rows(rng: Random, number: int, n: int, size: int = 2) -> list[Row]:
    """Small entries: coincident planes, low rank, common lines."""
    drawn = (tuple(rng.randint(-size, size) for _ in range(n)) for _ in range(20 * number))
    return [row for row in drawn if any(row)][:number]


def faces(fan: Fan) -> list[tuple[Row, int]]:
    return sorted(zip(map(tuple, fan.signs.tolist()), fan.dimensions.tolist(), strict=True))


@pytest.mark.parametrize("seed", range(60))
def test_inner_faces_are_those_on_the_right_sides(seed):
    rng = Random(seed)
    n = rng.randint(1, 4)
    bounds, planes = rows(rng, rng.randint(0, 4), n), rows(rng, rng.randint(0, 5), n)
    fan = inside(bounds, planes, n)
    every = Arrangement([*bounds, *planes], dimension=n).faces()
    assert faces(fan) == sorted(
        (face.signs, face.dimension)
        for face in every
        if min(face.signs[: len(bounds)], default=0) >= 0
    )


@pytest.mark.parametrize("seed", range(20))
def test_witnesses_have_signs_and_closed_faces_are_fans(seed):
    rng = Random(seed)
    n = rng.randint(1, 4)
    bounds, planes = rows(rng, 3, n), rows(rng, 3, n)
    fan = inside(bounds, planes, n)
    normals = np.array([*bounds, *planes])
    assert (np.sign(fan.points @ normals.T) == fan.signs).all()
    of = fan.boundary_and(len(fan) - 1)
    below = [
        face
        for face in faces(fan)
        if all(s in (0, t) for s, t in zip(face[0], fan.signs[-1].tolist(), strict=True))
    ]
    assert faces(of) == below


@pytest.mark.parametrize("seed", range(40))
def test_flats_count_what_is_listed_in_the_open_cone(seed):
    rng = Random(seed)
    n = rng.randint(1, 5)
    bounds, planes = rows(rng, rng.randint(0, 4), n), rows(rng, rng.randint(0, 6), n)
    fan = inside(bounds, planes, n)
    strictly = (fan.signs[:, : len(bounds)] == 1).all(axis=1)
    listed = np.bincount(fan.dimensions[strictly], minlength=n + 1)
    assert f_vector_in_cone(Arrangement(planes, dimension=n), bounds) == tuple(listed)


def test_numbers_beyond_64_bits_change_nothing():
    large = 10**25
    bounds, planes = [(1, 0, 0), (0, 1, 1)], [(1, -1, 2), (3, 1, -1), (0, 1, -2)]
    fan = inside(bounds, planes, 3)
    scaled = inside([tuple(large * x for x in r) for r in bounds], planes, 3)
    # The map (x, y, z) -> (large x, y, z) turns the second family of planes into the first.
    sheared = inside(
        [(large * a, b, c) for a, b, c in bounds], [(large * a, b, c) for a, b, c in planes], 3
    )
    assert faces(fan) == faces(scaled) == faces(sheared)
    assert (
        np.sign(sheared.points @ np.array([(large, -1, 2)], object).T)[:, 0] == sheared.signs[:, 2]
    ).all()


def test_sums_of_products_just_beyond_64_bits_keep_their_sign():
    """Each product is below 2^62, and the sum of three is above 2^63."""
    ray = np.array([[1_861_605_171] * 3])
    one = np.array([[True]]), np.zeros((1, 0), np.int8), np.array([1], np.int8)
    fan = Fan(ray, np.zeros((0, 3), np.int64), *one)
    assert fan.cut((2**31,) * 3).signs.tolist() == [[1]]


def test_rays_moved_along_a_line_are_exact_just_beyond_64_bits():
    """A ray (V, V, V, -V) goes to (2 V, 2 V, 2 V, -6 V), times 2^30 on the way."""
    ray, line = np.array([[1, 1, 1, -1]]) * 1_932_735_283, np.ones((1, 4), np.int64)
    one = np.array([[True]]), np.zeros((1, 0), np.int8), np.array([2], np.int8)
    assert Fan(ray, line, *one).cut((2**30,) * 4).rays[0].tolist() == [1, 1, 1, -3]


def test_a_plane_that_contains_everything_has_the_sign_zero():
    line = Fan.space(2).cut((1, 0), (0,))
    assert faces(line) == [((0,), 1)]
    assert faces(line.cut((2, 0)).cut((0, 0))) == [((0, 0, 0), 1)]
    assert len(line.cut((1, 0), (1, -1))) == 0
