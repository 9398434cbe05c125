"""Arrangements as values: validated, canonical, immutable, in input order."""

import copy
import pickle
from fractions import Fraction

import pytest
import sympy
from hypothesis import given, strategies as st

from arrangement import Arrangement, InputError, counts, read_arrangement

from .oracle import rank
from .strategies import RATIONALS, arrangements


def test_positive_multiples_are_equal_and_opposite_ones_are_not():
    assert Arrangement([[2, 0, 0]]) == Arrangement([["1/3", 0, 0]])
    assert hash(Arrangement([[2, 0, 0]])) == hash(Arrangement([["1/3", 0, 0]]))
    assert Arrangement([[1, 0, 0]]) != Arrangement([[-1, 0, 0]])
    assert Arrangement([[2, 0]], [3]) == Arrangement([["2/3", 0]], [1])
    assert Arrangement([[1, 0]], [0]) == Arrangement([[1, 0]])
    assert Arrangement([[1, 0], [0, 1]]) != Arrangement([[0, 1], [1, 0]])
    assert Arrangement([], dimension=2) != Arrangement([], dimension=3)


@pytest.mark.ground_types
def test_sympy_numbers_and_text_give_the_same_planes():
    half = sympy.Rational(1, 2)
    assert Arrangement([[half, sympy.Integer(1)]], [half]) == Arrangement([["1/2", 1]], ["0.5"])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([[1, 0], [0, 0]],), r"normal 2 is the zero vector"),
        (([[0.5, 0]],), "from_floats"),
        (([[1, 0], [1]],), r"normal 2 has 1 entries"),
        (([[1, 0]], [1, 2]), "1 normals and 2 offsets"),
        (([[1, 0]], [None]), r"offsets\[0\]"),
        (([[1, "x"]],), r"entry 2 of normal 1"),
        (([[True, 0]],), "Boolean"),
        ((["12"],), r"normal 1"),
        (("12",), "vectors"),
        ((5,), "vectors"),
        (([5],), r"normal 1"),
        (([],), "dimension"),
        (([[]],), "dimension"),
    ],
)
def test_bad_planes_are_refused_with_their_place(arguments, message):
    with pytest.raises(InputError, match=message):
        Arrangement(*arguments)


@pytest.mark.parametrize(
    ("call", "wrong"),
    [
        (lambda value: Arrangement([], dimension=value), [-1, True, 2.0, "3", "x", Fraction(1, 2)]),
        (lambda value: Arrangement([[1, 0]], dimension=value), [3]),
        (Arrangement([[1, 0, 0]]).faces, [-1, 4, True, "2", 1.0]),
        (Arrangement([[1, 0]]).signs_at, [[1], [1, 2, 3], [0.5, 0], "12x", None]),
    ],
)
def test_dimensions_and_points_of_the_wrong_kind_are_refused(call, wrong):
    for value in wrong:
        with pytest.raises(InputError, match=r"dimension|point"):
            call(value)


def test_a_common_point_may_be_anywhere():
    assert Arrangement([[1, 0], [0, 1], [1, 1]], [1, 2, 3]).has_common_point
    assert not Arrangement([[1, 0], [0, 1], [1, 1]], [1, 2, 4]).has_common_point
    assert not Arrangement([[1, 0], [1, 0]], [0, 1]).has_common_point
    assert Arrangement([], dimension=2).has_common_point


def test_one_plane_is_not_called_planes():
    assert repr(Arrangement([[1, 2]])).startswith("<Arrangement: 1 plane (1 distinct) in R^2")


def test_equality_as_sets():
    planes = Arrangement([[1, 2], [0, 1]], [1, 0])
    same = Arrangement([[0, -3], [2, 4], [1, 2]], [0, 2, 1])
    assert planes.has_same_planes(same)
    assert planes != same
    assert not planes.has_same_planes(Arrangement([[1, 2], [0, 1]], [-1, 0]))
    assert not planes.has_same_planes(Arrangement([[1, 2], [0, 1], [1, 1]], [1, 0, 0]))
    none = [Arrangement([], dimension=d) for d in (1, 2)]
    assert not none[0].has_same_planes(none[1])


def test_a_point_has_one_region():
    point = Arrangement([], dimension=0)
    assert {point.faces(engine=name).f_vector for name in ("great-circles", "any-dimension")} == {
        (1,)
    }
    assert point.certify_complete()
    [region] = point.bounded_regions()
    assert region == point.region_at([])
    assert region.vertices == ((),)
    assert region.volume == 1
    assert region.f_vector == (1,)
    assert list(point.region_graph().edges) == []
    assert point.p_vector == {0: 1}
    assert counts.by_points(point) == counts.characteristic_polynomial(point)
    with pytest.raises(InputError, match="dimension"):
        Arrangement([[]], dimension=0)


def test_classes_keep_input_order_and_orientation():
    planes = Arrangement([[0, 1], [1, 0], [0, -2], [3, 0], [0, 1]], [1, 0, -2, 0, 2])
    assert planes.distinct == ((0, 2), (1, 3), (4,))
    assert planes.class_of == (0, 1, 0, 1, 2)
    assert planes.orientation == (1, 1, -1, 1, 1)


def test_arrangements_cannot_be_changed():
    planes = Arrangement([[1, 0]])
    for name in ("normals", "integer_planes", "dimension", "offsets"):
        with pytest.raises((AttributeError, TypeError)):
            setattr(planes, name, 5)
    face = planes.faces()[0]
    with pytest.raises(AttributeError):
        face.dimension = 5


def test_copies_are_equal():
    planes = Arrangement([[1, 0], [1, 1]], [0, 1])
    assert copy.copy(planes) == copy.deepcopy(planes) == planes
    assert pickle.loads(pickle.dumps(planes)) == planes


@pytest.mark.parametrize(
    ("normals", "offsets", "simple"),
    [
        ([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], None, True),
        ([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0]], None, False),
        ([[1, 0, 0], [0, 1, 0], [2, 0, 0]], None, True),  # the distinct planes are meant
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0]], None, False),
        ([[1, 0], [0, 1], [1, 1]], [0, 0, 1], True),
        ([[1, 0], [0, 1], [1, 1]], [1, 1, 2], False),  # three lines in one point
        ([[1, 0], [1, 0]], [0, 1], False),  # parallel
        ([[1], [1]], [0, 1], True),
    ],
)
def test_simple_means_general_position_of_the_distinct_planes(normals, offsets, simple):
    assert Arrangement(normals, offsets).is_simple is simple


@given(arrangements())
def test_rank_is_that_of_the_normals(planes):
    assert planes.rank == rank(planes.normals)


@given(arrangements())
def test_the_file_form_reads_back(planes):
    assert read_arrangement(planes.to_dict()) == planes


@given(st.data(), arrangements(planes=(1, 5)))
def test_signs_at_a_point_are_those_of_the_definition(data, planes):
    size = planes.dimension
    point = data.draw(st.lists(RATIONALS, min_size=size, max_size=size))
    values = [
        sum(a * x for a, x in zip(normal, point, strict=True)) - offset
        for normal, offset in zip(planes.normals, planes.offsets, strict=True)
    ]
    assert planes.signs_at(point) == tuple((v > 0) - (v < 0) for v in values)
