"""The facade's choice of engines, each engine against the others, and the sequence of faces."""

import gc
import random
import weakref
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from arrangement import Arrangement, Face, InputError, counts, read_arrangement
from arrangement.counts import completeness
from arrangement.counts.completeness import certify_complete
from arrangement.enumeration.choose import ENGINES, enumerate_faces
from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.enumeration.sequence import FaceSequence
from arrangement.planes.planes import Planes

from . import oracle
from .strategies import arrangements

FOUR = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])


def degenerate(
    generator: random.Random, dimension: int, rank: int, largest: int, affine: bool
) -> Planes:
    """Return up to 7 planes of at most this rank, or 14: coincident and parallel ones abound."""
    span = [generator.choices((-2, -1, 0, 1, 2), k=dimension) for _ in range(rank)]
    entries = range(-largest, largest + 1)
    normals = []
    for _ in range(generator.randint(0, 14 if dimension == 3 and not affine else 7)):
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
    ("dimension", "affine", "trials"),
    [
        *((n, affine, 40) for n in (1, 2, 3) for affine in (False, True)),
        *(
            pytest.param(n, affine, 24, marks=pytest.mark.slow)
            for n in (4, 5)
            for affine in (False, True)
        ),
        pytest.param(3, False, 100, marks=pytest.mark.slow),
    ],
)
def test_all_engines_list_the_same_faces(dimension, affine, trials):
    generator = random.Random(10 * dimension + affine)
    used = set()
    for trial in range(trials):
        rank = 1 + trial % dimension
        planes = degenerate(generator, dimension, rank, generator.choice((1, 2, 9)), affine)
        if dimension == 3 and not affine:
            sphere_arrangement(Arrangement(planes.normals, dimension=3)).validate()
        expected = enumerate_faces(planes, "any-dimension")
        for name, engine in ENGINES.items():
            if engine.ranks(planes):
                used.add(name)
                same_faces(enumerate_faces(planes, name), expected, planes)
    assert used == set(ENGINES) or dimension < 3


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
    assert planes.faces().f_vector == counts.f_vector(planes)


def test_an_engine_that_is_unknown_or_cannot_is_refused():
    with pytest.raises(
        InputError, match="expected one of great-circles, affine-space, any-dimension"
    ):
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
        assert level == FOUR.faces(k) == tuple(FOUR.iter_faces(k))
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


SignVectors = set[tuple[int, ...]]


def sign_vectors(planes: Arrangement) -> SignVectors:
    return {face.signs for face in planes.faces()}


@settings(max_examples=30)
@given(
    arrangements(dimensions=(1, 3), planes=(0, 5)) | arrangements(dimensions=(4, 5), planes=(0, 5))
)
def test_sign_vectors_are_those_of_brute_force(planes):
    assert sign_vectors(planes) == oracle.sign_vectors(planes)


HUGE = 10**30


@given(arrangements(dimensions=(1, 4), planes=(0, 6)))
def test_the_enumeration_is_certified(planes):
    evidence = planes.certify_complete()
    assert evidence.complete
    assert bool(evidence)
    assert evidence.problems == ()
    assert evidence.enumerated == evidence.theorem == counts.f_vector(planes)


@given(arrangements(dimensions=(1, 3), planes=(1, 5)), st.data())
def test_one_face_missing_is_noticed(planes, data):
    faces = planes.faces()
    gone = data.draw(st.integers(0, len(faces) - 1))
    evidence = certify_complete(planes, faces[:gone] + faces[gone + 1 :])
    assert not evidence.complete
    assert f"of dimension {faces[gone].dimension}" in evidence.problems[0]


@given(arrangements(dimensions=(1, 3), planes=(1, 5)), st.data())
def test_one_face_twice_in_place_of_another_is_noticed(planes, data):
    regions = [i for i, face in enumerate(planes.faces()) if face.dimension == planes.dimension]
    gone, again = data.draw(st.permutations(regions))[:2]
    faces = list(planes.faces())
    faces[gone] = faces[again]
    assert "is listed twice" in certify_complete(planes, faces).problems[0]


@given(arrangements(dimensions=(1, 3), planes=(1, 5)), st.data())
def test_a_flipped_sign_is_noticed(planes, data):
    faces = list(planes.faces())
    chosen = data.draw(st.integers(0, len(faces) - 1))
    plane = data.draw(st.integers(0, len(planes) - 1))
    signs = list(faces[chosen].signs)
    signs[plane] = 1 if signs[plane] < 1 else -1
    faces[chosen] = replace(faces[chosen], signs=tuple(signs))
    assert "with other signs" in certify_complete(planes, faces).problems[0]


SQUARE = Arrangement([[1, 0], [0, 1]])
CORNER = Face((1, 1), 2, (Fraction(1), Fraction(1)), SQUARE)


@pytest.mark.parametrize(
    ("face", "message"),
    [
        (replace(CORNER, dimension=1), "has dimension 2, not 1"),
        (replace(CORNER, witness=(Fraction(1),)), "1 coordinates"),
        (replace(CORNER, witness=(Fraction(1), Fraction(0))), "other signs"),
    ],
)
def test_a_wrong_face_says_what_is_wrong(face, message):
    faces = [face if f.signs == (1, 1) else f for f in SQUARE.faces()]
    evidence = certify_complete(SQUARE, faces)
    assert not evidence
    assert any(message in problem for problem in evidence.problems)


def test_twenty_problems_are_named():
    wrong = [replace(CORNER, dimension=k % 2) for k in range(30)]
    problems = certify_complete(SQUARE, wrong).problems
    assert len(problems) == 20
    assert all("has dimension 2" in problem for problem in problems)


def test_verified_program_used_only_on_request(monkeypatch):
    asked = []
    monkeypatch.setattr(completeness, "proved_f_vector", counts.f_vector)
    monkeypatch.setattr(completeness, "proved_complete", lambda _, faces: asked.append(len(faces)))
    faces = SQUARE.faces()
    for listed, proved in ((faces[1:], True), (faces, False), (faces, True)):
        assert not asked
        problems = certify_complete(SQUARE, iter(listed), proved=proved).problems
        assert len(problems) == (len(listed) < 9 or proved)
    assert problems == ("the verified program refuses the list",)
    assert asked == [9]


def test_faces_of_huge_planes_are_checked_exactly():
    huge = 10**30
    planes = Arrangement([[huge, 1, 0], [huge, 0, 1], [huge + 1, 1, 0], [1, huge, -1]])
    assert planes.certify_complete()
    # the witness misses the third plane by one in 10^30, and claims to be on it
    line = Face((0, 0, 0, -1), 1, (Fraction(1), Fraction(-huge), Fraction(-huge)), planes)
    wrong = [line if f.signs[:2] == (0, 0) and f.dimension == 1 else f for f in planes.faces()]
    assert any("other signs" in problem for problem in certify_complete(planes, wrong).problems)


def test_a_product_that_would_wrap_around_in_64_bits_is_no_zero():
    planes = Arrangement([[2**40, 1], [0, 1]])
    # 2^40 * 2^24 is zero modulo 2^64, so this point only seems to be on the first plane
    claimed = Face((0, 0), 0, (Fraction(2**24), Fraction(0)), planes)
    faces = [claimed if face.dimension == 0 else face for face in planes.faces()]
    assert "other signs" in certify_complete(planes, faces).problems[0]
