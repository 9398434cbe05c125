"""SymPy in and out: equations of planes, matrices and points, with both of its ground types."""

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from sympy import Eq, I, Integer, Rational, pi, sin, sqrt
from sympy.abc import a, x, y, z

from arrangement import Arrangement, InputError, read_arrangement
from arrangement.counts import essentialization, localization, restriction
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.numbers.symbolic import to_sympy
from arrangement.planes.planes import Planes

from .strategies import arrangements

SPACE = (x, y, z)


def test_equations_keep_their_order_and_their_sides():
    planes = Arrangement.from_equations([Eq(x, y), y - z, 2 * x + 3 * z - 1], SPACE)
    assert isinstance(planes, Arrangement)
    assert planes.integer_planes == ((1, -1, 0, 0), (0, 1, -1, 0), (2, 0, 3, 1))
    assert planes.signs_at((1, 0, 0)) == (1, 0, 1)
    assert Planes.from_equations([Eq(y / 3, x / 2)]).integer_planes == ((-3, 2, 0),)


def test_coordinates_default_to_symbols_by_name():
    assert Arrangement.from_equations([z - a]) == Arrangement([[-1, 1]])
    assert Arrangement.from_equations([z - a], (z, a)) == Arrangement([[1, -1]])


@given(arrangements())
def test_equations_return_the_same_planes(planes):
    names = sympy.symbols(f"t:{planes.dimension}", positive=True)
    for symbols in (names, names[::-1]):
        assert Arrangement.from_equations(planes.equations(symbols), symbols) == planes


def test_default_symbols_sort_as_they_are_counted():
    planes = Arrangement([[*range(1, 13)]], [5])
    assert Arrangement.from_equations(planes.equations()) == planes
    assert Arrangement([[1, 0], [2, -3]], [0, 1]).equations() == (
        Eq(x, 0, evaluate=False),
        Eq(2 * x - 3 * y, 1),
    )


@pytest.mark.parametrize(
    ("equation", "message"),
    [
        ("x = y", "text beside SymPy's equations"),
        (a * x - 1, r"the term a\*x: a is not one of the symbols"),
        (x - a, r"the term -a: a is not one of the symbols"),
        (0.5 * x - y, r"the term 0\.5\*x: a float is not exact"),
        (sqrt(-2) * x, r"the term sqrt\(2\)\*I\*x: the coefficient sqrt\(2\)\*I is not a real"),
        (pi + x, "the term pi: the coefficient pi is not a real algebraic number"),
        (x + I, "the term I: "),
        (x * y + z, r"the term x\*y, which is not linear"),
        (x**2 - y, r"the term x\*\*2, which is not linear"),
        (sin(x) + y, r"the term sin\(x\), which is not linear"),
        (x / y - 1, "the term x/y, which is not linear"),
        (Eq(x, x), "true everywhere or nowhere"),
        (True, "true everywhere or nowhere"),
        (Integer(5), "none of the symbols"),
        (x < y, "not an equation"),
        (5, "not an equation"),
        (None, "not an equation"),
    ],
)
def test_irrational_equations_refused_with_the_term(equation, message):
    with pytest.raises(InputError, match=rf"equations\[1\] .*{message}"):
        Arrangement.from_equations([x, equation], SPACE)


@pytest.mark.parametrize(
    ("symbols", "message"),
    [
        ("xyz", "symbols is 'xyz'"),
        ((x, "y", z), r"symbols\[1\] is 'y'"),
        ((x, y, x), r"symbols\[2\] is x again"),
        ((x, y), "2 symbols are given for 3"),
        (3, "symbols is 3"),
    ],
)
def test_bad_symbols_are_refused(symbols, message):
    planes = Arrangement([[1, 2, 3]])
    with pytest.raises(InputError, match=message):
        planes.equations(symbols)


def test_equations_as_text_are_read_as_in_files(tmp_path):
    lines = ["x=0", "2*x - 1/2 y + 1", "y = 3"]
    path = tmp_path / "lines.eqn"
    path.write_text("\n".join(lines), encoding="utf-8")
    planes = Arrangement.from_equations(lines)
    assert planes == read_arrangement(path)
    assert planes.integer_planes == ((1, 0, 0), (4, -1, -2), (0, 1, 3))
    assert Arrangement.from_equations(["x = 0"]).dimension == 2
    assert Arrangement.from_equations(["x = z"], (x, y, z)) == Arrangement([[1, 0, -1]])
    assert Arrangement.from_equations(["x10 - x2"]) == Arrangement([[-1, 1]])


@pytest.mark.parametrize("text", ["__import__('os').abort()", "x**2", "x*y", "", "x ==0", "x = w"])
def test_text_that_is_no_equation_is_refused(text):
    with pytest.raises(InputError):
        Arrangement.from_equations([text], (x, y, z))


def test_equations_that_are_no_sequence_are_refused():
    for equations in (x - y, 5):
        with pytest.raises(InputError, match="give a sequence of equations"):
            Arrangement.from_equations(equations)


def test_matrices_of_sympy_are_read_by_rows():
    rows = sympy.Matrix([[1, Rational(1, 2)], [0, 1]])
    expected = Arrangement([[1, "1/2"], [0, 1]], [1, "2/3"])
    offsets = sympy.Matrix([1, Rational(2, 3)])
    assert Arrangement(rows, offsets) == expected
    assert Arrangement(sympy.ImmutableMatrix(rows), offsets.T) == expected
    assert Arrangement(rows.tolist(), list(offsets)) == expected
    with pytest.raises(InputError, match=r"entry 1 of normal 1 is the float"):
        Arrangement(rows / 2.0)


def test_the_matrix_has_the_planes_as_rows_over_the_integers():
    planes = Arrangement([["1/2", 1], [0, 3]], [1, 2])
    assert planes.matrix.domain == sympy.ZZ
    assert planes.matrix.to_Matrix() == sympy.Matrix([[1, 2, 2], [0, 3, 2]])
    assert planes.matrix is planes.matrix
    assert Arrangement([], dimension=2).matrix.shape == (0, 3)


def test_points_are_columns_that_give_the_signs_back():
    planes = Arrangement([[1, 2, 0], [0, 1, 3], [1, 1, 1]], [1, 0, "1/7"])
    for face in planes.faces():
        point = face.point()
        assert point.shape == (3, 1)
        assert planes.signs_at(point) == face.signs
        values = planes.matrix.to_Matrix() * sympy.Matrix([*point, -1])
        assert tuple(sympy.sign(value) for value in values) == face.signs


def test_numbers_vectors_and_lists_of_vectors_go_to_sympy():
    assert to_sympy(Fraction(3, 2)) == Rational(3, 2)
    assert to_sympy(10**40) == Integer(10**40)
    cube = dual_polyhedron(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    corners = to_sympy(cube.vertices)
    assert len(corners) == 8
    assert sum(corners, sympy.zeros(3, 1)) == sympy.zeros(3, 1)


@given(arrangements())
def test_closed_forms_return_python_numbers(planes):
    """Elements of SymPy's domains stay inside, whichever ground types it uses."""
    made = [essentialization(planes)] if len(planes) else []
    for i in range(len(planes)):
        made.append(localization(planes, [i, i]))
        if planes.dimension > 1:
            made.append(restriction(planes, i))
    numbers = [n for new in made for plane in new.integer_planes for n in plane]
    assert all(type(n) is int for n in numbers)
