"""Random degenerate arrangements: engine, brute force, general engine and theorem agree."""

from __future__ import annotations

import random

import pytest

from arrangement import Arrangement
from arrangement.counts import f_vector
from arrangement.enumeration.great_circles import sphere_arrangement
from tests.arrangement.oracle import covectors


def degenerate(generator: random.Random) -> list[tuple[int, ...]]:
    """Return up to 14 normals with entries in {-2..2}: pencils and coincident planes abound."""
    entries = generator.choice([(-1, 0, 1), (-2, -1, 0, 1, 2), (0, 1), (0, 0, 1, -2)])
    normals = [tuple(generator.choices(entries, k=3)) for _ in range(generator.randint(0, 14))]
    return [normal for normal in normals if any(normal)]


def check_all(normals: list[tuple[int, ...]]) -> None:
    planes = Arrangement(normals, dimension=3)
    sphere_arrangement(planes).validate()
    faces = planes.faces(engine="great-circles")
    assert faces.f_vector == f_vector(planes), normals
    levels = tuple(set(map(tuple, faces.of_dimension(k).signs.tolist())) for k in range(4))
    assert levels == covectors(normals), normals


@pytest.mark.parametrize("seed", range(4))
def test_random_degenerate_arrangements_have_the_faces_of_brute_force_and_theorem(seed):
    generator = random.Random(seed)
    for _ in range(40):
        check_all(degenerate(generator))


@pytest.mark.campaign
@pytest.mark.parametrize("seed", range(100, 104))
def test_thousands_of_random_degenerate_arrangements(seed):
    generator = random.Random(seed)
    for _ in range(1000):
        check_all(degenerate(generator))


@pytest.mark.parametrize("seed", range(20))
def test_witnesses_and_faces_agree_with_the_general_engine(seed):
    normals = degenerate(random.Random(1000 + seed))
    planes = Arrangement(normals, dimension=3)
    found = planes.faces(engine="great-circles")
    for face in found:
        assert planes.signs_at(face.witness) == face.signs
    expected = {(face.signs, face.dimension) for face in planes.faces(engine="any-dimension")}
    assert {(face.signs, face.dimension) for face in found} == expected
