"""The facade's choice of engines, each engine against the others, and the sequence of faces."""

import gc
import random
import weakref

import numpy as np
import pytest

from arrangement import Arrangement, InputError, Planes, counts, read_arrangement
from arrangement.enumeration.choose import ENGINES, enumerate_faces
from arrangement.enumeration.sequence import FaceSequence

FOUR = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])


def degenerate(
    generator: random.Random, dimension: int, rank: int, largest: int, affine: bool
) -> Planes:
    """Return up to 7 planes of at most this rank; coincident and parallel ones abound."""
    span = [generator.choices((-2, -1, 0, 1, 2), k=dimension) for _ in range(rank)]
    entries = range(-largest, largest + 1)
    normals = []
    for _ in range(generator.randint(0, 7)):
        factors = generator.choices(entries, k=rank)
        normal = [sum(map(int.__mul__, factors, column)) for column in zip(*span, strict=True)]
        if any(normal):
            normals.append(normal)
    offsets = generator.choices((-1, 0, 1), k=len(normals)) if affine else None
    return Planes(normals, offsets, dimension=dimension)


def same_faces(found: FaceSequence, expected: FaceSequence, planes: Planes) -> None:
    assert found.f_vector == expected.f_vector == counts.f_vector(planes)
    assert len(set(found)) == len(found) == sum(found.f_vector)
    assert {(f.signs, f.dimension) for f in found} == {(f.signs, f.dimension) for f in expected}
    for face in found:
        assert planes.signs_at(face.witness) == face.signs


@pytest.mark.parametrize(
    "dimension", [1, 2, 3, *(pytest.param(n, marks=pytest.mark.campaign) for n in (4, 5))]
)
@pytest.mark.parametrize("affine", [False, True])
def test_all_engines_list_the_same_faces(dimension, affine):
    generator = random.Random(10 * dimension + affine)
    used = set()
    for trial in range(60):
        rank = 1 + trial % dimension
        planes = degenerate(generator, dimension, rank, generator.choice((1, 2, 9)), affine)
        expected = enumerate_faces(planes, "any-dimension")
        for name, engine in ENGINES.items():
            if engine.ranks(planes):
                used.add(name)
                same_faces(enumerate_faces(planes, name), expected, planes)
    assert used == set(ENGINES) or dimension < 3


@pytest.mark.parametrize("offset", [0, 1])
def test_entries_of_forty_digits(offset):
    generator = random.Random(40 + offset)
    large = 10**40
    rows = [[generator.randint(-large, large) for _ in range(3)] for _ in range(5)]
    planes = Planes([*rows, rows[0], [1, 0, 0]], [offset * row[0] for row in rows] + [0, 0])
    same_faces(enumerate_faces(planes), enumerate_faces(planes, "any-dimension"), planes)


def test_more_planes_than_one_word_holds():
    generator = random.Random(70)
    rows = [[generator.randint(-5, 5) for _ in range(2)] + [1] for _ in range(70)]
    planes = Planes(rows)
    assert len(planes.distinct) > 32
    same_faces(enumerate_faces(planes), enumerate_faces(planes, "any-dimension"), planes)


@pytest.mark.parametrize(
    ("planes", "engine"),
    [
        (read_arrangement("braid-a3-in-r4"), "great-circles"),
        (read_arrangement("generic-lines-affine"), "great-circles"),
        (Arrangement([], dimension=5), "great-circles"),
        (Arrangement([[1]], [3]), "great-circles"),
        (FOUR, "great-circles"),
        (Arrangement(FOUR.normals, [0, 0, 0, 1]), "affine-space"),
        (Arrangement(np.eye(4, dtype=int)), "affine-space"),
        (Arrangement(np.eye(4, dtype=int), [0, 0, 0, 1]), "any-dimension"),
        (Arrangement(np.eye(5, dtype=int)), "any-dimension"),
    ],
)
def test_the_rank_chooses_the_engine(planes, engine):
    assert planes.faces().engine == engine
    assert planes.f_vector == counts.f_vector(planes)


def test_an_engine_that_is_unknown_or_cannot_is_refused():
    with pytest.raises(InputError, match="known are great-circles, affine-space, any-dimension"):
        FOUR.faces(engine="fast")
    with pytest.raises(InputError, match="the engine great-circles does rank up to 3"):
        Arrangement(np.eye(4, dtype=int)).faces(engine="great-circles")
    with pytest.raises(InputError, match="the engine affine-space does rank 3, or 4"):
        Arrangement([[1, 0, 0]]).faces(engine="affine-space")


def test_the_sequence_looks_like_a_tuple():
    faces = FOUR.faces()
    listed = tuple(faces)
    assert len(faces) == len(listed) == 51
    assert [faces[i] for i in range(len(faces))] == list(listed)
    assert faces[-1] == listed[-1]
    assert faces[3:40:5] == listed[3:40:5]
    assert faces[::-1] == listed[::-1]
    assert faces[7:7] == ()
    assert listed[9] in faces
    assert faces == listed
    assert faces == FOUR.faces()
    assert faces != listed[1:]
    assert faces != FOUR.faces(2)
    for beyond in (51, -52):
        with pytest.raises(IndexError):
            faces[beyond]


@pytest.mark.parametrize("planes", [FOUR, Arrangement(FOUR.normals, [0, 0, 0, 1])])
def test_the_arrays_of_a_sequence(planes):
    faces = planes.faces()
    assert faces.signs.dtype == faces.dimensions.dtype == np.int8
    assert list(map(tuple, faces.signs.tolist())) == [face.signs for face in faces]
    assert faces.dimensions.tolist() == [face.dimension for face in faces]
    assert faces.dimensions.tolist() == sorted(faces.dimensions.tolist())
    for array in (faces.signs, faces.dimensions):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_faces_of_one_dimension():
    faces = FOUR.faces()
    for k, number in enumerate(FOUR.f_vector):
        level = faces.of_dimension(k)
        assert len(level) == number
        assert level == FOUR.faces(k)
        assert set(level.dimensions.tolist()) == {k}
        assert level.of_dimension(k) == level
    with pytest.raises(InputError, match="faces have dimension 2 to 2"):
        FOUR.faces(2).of_dimension(1)


def test_no_planes_have_one_face():
    empty = Arrangement([], dimension=2)
    assert empty.f_vector == (0, 0, 1)
    assert empty.faces().signs.shape == (1, 0)
    assert empty.faces()[0].witness == (0, 0)
    assert empty.faces(0)[:] == ()
    assert empty.faces(0).signs.shape == (0, 0)


def test_faces_do_not_keep_the_arrangement_alive():
    """Else large arrays would wait for the garbage collector."""
    planes = Arrangement([[1, 2, 3], [4, 5, 6], [7, 8, 0]])
    faces, gone = planes.faces(), weakref.ref(planes)
    gc.disable()
    try:
        del planes
        assert gone() is None
        assert len(faces) == 27
    finally:
        gc.enable()
