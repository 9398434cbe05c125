"""Completeness certificates: true lists pass, every damaged list is refused."""

from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given, strategies as st

from arrangement import Arrangement, Face, counts
from arrangement.counts.completeness import certify_complete

from .strategies import arrangements


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
