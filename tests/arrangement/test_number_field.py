"""Numbers of one real field against SymPy's, and planes that have them as entries."""

import copy
import itertools
import json
import pickle
import random
import sys
from fractions import Fraction
from operator import add, mul, sub, truediv
from typing import Any

import pytest
import sympy
from sympy import CRootOf, GoldenRatio, Rational, cos, pi, sqrt
from sympy.abc import x

from arrangement import (
    Arrangement,
    InputError,
    NumberField,
    OutOfReachError,
    counts,
    read_arrangement,
)
from arrangement.errors import OutOfTimeError
from arrangement.library import families
from arrangement.numbers import budget, deadline, fields
from arrangement.numbers.exact import number_text
from arrangement.numbers.symbolic import to_sympy

GOLDEN = NumberField([-1, -1, 1], [1, 2])
FIELDS = {
    "sqrt 5": GOLDEN,
    "cos(2 pi / 7)": NumberField([-1, -4, 4, 8], ["1/2", 1]),
    "the third root of 2": NumberField([-2, 0, 0, 1], [1, 2]),
    "a root with larger conjugates": NumberField([1, -9, 0, 0, 3], [0, 1]),
    "2 cos(2 pi / 11)": NumberField([1, 3, -3, -4, 1, 1], [1, 2]),
}


def drawn(field: NumberField, source: random.Random) -> Any:
    return field.number(
        [Fraction(source.randint(-9, 9), source.randint(1, 4)) for _ in range(field.degree)]
    )


@pytest.mark.parametrize("name", FIELDS)
def test_arithmetic_agrees_with_the_algebraic_fields_of_sympy(name):
    field, source = FIELDS[name], random.Random(1)
    domain = field.domain

    def sympys(value):
        parts = getattr(value, "rational_coefficients", lambda: [Fraction(value)])()
        return domain([sympy.QQ(c.numerator, c.denominator) for c in reversed(parts)])

    for _ in range(60):
        a, b = drawn(field, source), drawn(field, source)
        for operation in (add, sub, mul, truediv):
            if operation is not truediv or b:
                assert sympys(operation(a, b)) == operation(sympys(a), sympys(b))


@pytest.mark.parametrize("name", FIELDS)
def test_signs_and_floats_agree_with_sympy(name):
    field, source = FIELDS[name], random.Random(2)
    for _ in range(10):
        a = drawn(field, source)
        exact = to_sympy(a).evalf(30)
        assert (a > 0) == (exact > 0)
        assert float(a) == pytest.approx(float(exact), rel=1e-14)


def test_a_number_a_hair_beside_0_has_its_sign():
    a, b, g = 1, 1, GOLDEN.generator
    for k in range(2, 400):  # quotients of Fibonacci numbers on both sides of the golden ratio
        a, b = a + b, a
        assert (2 * a - b - b * g > 0) == (k % 2 == 0)
        assert GOLDEN.sign((2 * a - b, -b)) == (-1) ** k


@pytest.mark.parametrize("bits", [20, 40, 50, 60, 63, 70, 130])
def test_powers_too_small_for_their_bits_have_exact_signs(bits):
    """Sums c + k a^2 beside 0, for a generator a hair below 1 / 2^bits."""
    field = NumberField([-1, 2**bits, 0, 1], [0, 1])
    low, high = (end**2 for end in field.interval(1000))
    for c in (1, 3, 7 << 20, 10**12):
        for k in range(int(c / high) - 1, int(c / high) + 3):
            assert (k * low > c) == (k * high > c) == (field.number([-c, 0, k]) > 0)


@pytest.mark.parametrize("name", FIELDS)
def test_numbers_behave_as_rational_ones_do(name):
    field, a = FIELDS[name], FIELDS[name].generator
    assert [a < a, a > a, a <= a, a >= a] == [False, False, True, True]
    half = Fraction(1, 2)
    assert [a - half < a < a + half, a > a - 2, a + 2 > a, a < a - half] == [True] * 3 + [False]
    assert (a**0, a**1, a**3) == (1, a, a * a * a)
    assert ((a / 6).numerator, (a / 6 + 1).numerator) == (a, a + 6)
    assert [a > 1000, a < 1000, 2 * a / 2 == a] == [False, True, True]
    assert 3 - a == -(a - 3)
    assert [a == a / 2, field == 3, a == "a"] == [False] * 3
    near, x = float(a), 0.375
    found = (a + x, x + a, a - x, x - a, a * x, x * a, a / x, x / a)
    exact = (near + x, near + x, near - x, x - near, near * x, near * x, near / x, x / near)
    assert found == pytest.approx(exact, rel=1e-15)
    for b in (a / 3, a - 5, 7 * a + 1, 10**30 * a):
        assert abs(b) <= b.size() == -(-b.numerator.size() // b.denominator)
        assert b.bit_length() == int(abs(to_sympy(b))).bit_length()


def test_numbers_of_two_fields_are_not_taken_together():
    a, b = GOLDEN.generator, NumberField([-2, 0, 1], [1, 2]).generator
    same = NumberField([-5, 0, 1], [2, 3]).generator
    assert (a + same, a * same, a == b) == (2 * a, 5, False)
    for operation in (add, mul):
        with pytest.raises(InputError, match="two different fields"):
            operation(a, b)


@pytest.mark.parametrize("name", FIELDS)
def test_residues_are_those_of_sums_and_products(name):
    field = FIELDS[name]
    for prime in sympy.primerange(5, 200):
        root = field.root_modulo(prime)
        if root is not None:
            assert sum(c * root**k for k, c in enumerate(field.minimal_polynomial)) % prime == 0
            a = field.generator
            b, c = 2 * a + 3, (a - 4) / 2
            x, y, product = (z.residue(prime, root) for z in (b, c, b * c + a))
            assert (x, 2 * y % prime) == ((2 * root + 3) % prime, (root - 4) % prime)
            assert product == (x * y + root) % prime


def test_numbers_are_written_as_sums_of_powers():
    field = FIELDS["the third root of 2"]
    for parts, text in {
        (1, -1, Fraction(1, 2)): "1 - a + 1/2*a^2",
        (0, -1, 1): "-a + a^2",
        (-2, 0, -3): "-2 - 3*a^2",
        (0, 2, 0): "2*a",
        (1, 1, -1): "1 + a - a^2",
        (Fraction(1, 2), 0, Fraction(-1, 3)): "1/2 - 1/3*a^2",
    }.items():
        assert repr(field.number(parts)) == text


def test_one_rounding_has_the_error_of_floats():
    assert sys.float_info.epsilon == 2 * fields._UNIT


#: Coefficients from the constant term up, an interval, its root, and the interval of its generator.
ROOTS = [
    ([-2, 0, 1], [-2, -1], -(2**0.5), [1, 2]),
    ([-2, 0, 1], [-2, 1], -(2**0.5), [1, 2]),
    ([-2, 0, 1], [-2, 0], -(2**0.5), [1, 2]),
    ([-2, 0, 1], [-1, 2], 2**0.5, [1, 2]),
    ([-2, 0, 1], [-1, "1.42"], 2**0.5, [1, 2]),
    ([-2, 0, 1], [-2, "1.4"], -(2**0.5), [1, 2]),
    ([-1, -1, 1], [-1, 1], (1 - 5**0.5) / 2, [2, 3]),
    ([-1, -1, 1], [0, 9], (1 + 5**0.5) / 2, [2, 3]),
    ([-2, 0, 0, 1], [1, "1.26"], 2 ** (1 / 3), [1, 2]),
    ([1, -3, 0, 1], ["0.3", "0.348"], 0.34729635533386066, [0, 1]),
    ([1, -3, 0, 1], [1, 2], 1.532088886237956, [1, 2]),
    ([7, -7, 0, 1], [1, "1.5"], 1.3568958678922094, [1, "3/2"]),
    ([7, -7, 0, 1], ["1.5", 2], 1.6920214716300959, ["3/2", 2]),
    ([-1000, -100, -10, 1], [0, 20], 18.392867552141612, [18, 19]),
    ([-(10**30) - 1, 0, 0, 0, 0, 1], [0, 10**7], 10.0**6, [10**6, 10**6 + 1]),
    ([-1, 0, -1000, 1], [0, 2000], 1000.000001, [1000, 1001]),
    ([-(10**36) - 1, 0, 0, 1], [10**12 - Fraction(1, 3), 10**13], 1e12, [10**12, 10**12 + 1]),
    ([-7, -3, -1, 1], [0, 9], 2.8828818426698817, [2, 3]),
]


@pytest.mark.parametrize(("polynomial", "interval", "root", "ends"), ROOTS)
def test_the_root_is_the_one_in_the_interval(polynomial, interval, root, ends):
    field = NumberField(polynomial, interval)
    assert float(field.root) == pytest.approx(root, rel=1e-15)
    fresh = NumberField(polynomial, interval)
    assert fresh.isolating_interval() == tuple(map(Fraction, ends))
    low, high = field.interval(300)
    assert high - low <= Fraction(1, 2**300)
    powers = [Fraction(low) ** k for k in range(field.degree)]
    assert all(abs(p * 2**99 - q) <= 1 for p, q in zip(powers, field._scale(99), strict=True))
    roots = sympy.Poly([*reversed(field.minimal_polynomial)], x)
    assert field.index == roots.count_roots(None, Rational(low))
    sizes = [abs(x) for x in roots.nroots()]
    for k in range(field.degree):
        unit = [int(j == k) for j in range(field.degree)]
        assert field.size([100 * j for j in unit]) >= 100 * max(size**k for size in sizes)
        assert field.float_powers[k] == pytest.approx(float(field.generator) ** k, rel=1e-15)


def test_fields_of_other_roots_differ():
    fields = [NumberField(polynomial, interval) for polynomial, interval, *_ in ROOTS[9:13]]
    for one in fields:
        for other in fields:
            assert (one == other) == (one is other)


@pytest.mark.parametrize(
    ("polynomial", "interval", "message"),
    [
        ([1, 0, 1], [0, 1], "no real embedding"),
        ([-2, 0, 1], [2, 3], "no real root there"),
        ([-2, 0, 1], [-2, 2], "2 roots"),
        ([-(10**100), 0, 0, 1], [0, 10**40], "up to 100 digits"),
        ([-2, 10**60 + 7, 0, 10**60], [0, 1], "an algebraic integer is .* up to 100 digits"),
        ([-1, 10**99 + 1, 10**60 + 9], [0, 1], "an algebraic integer is .* up to 100 digits"),
        ([-4, 0, 1], [1, 3], "reducible"),
        ([2, -3, 1, 0, 0], [1, 3], "the last one is not 0"),
        ([-2, 1], [1, 3], "degree"),
        ([-2, *[0] * 16, 1], [1, 2], "2 to 16"),
        ([-2, 0, 1], [2, 1], "lower one first"),
        ([-2, 0, 1.0], [1, 2], "float"),
    ],
)
def test_what_is_no_real_field_is_refused(polynomial, interval, message):
    with pytest.raises(InputError, match=message):
        NumberField(polynomial, interval)


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        (pi, "pi is not known to be algebraic"),
        (sqrt(-2), "not real"),
        (sqrt(2) * 1.5, "float"),
        (2 ** Rational(1, 17), "degree 17"),
        (CRootOf(x**5 + x + 3, 1), "not real"),
        (1.5, "float"),
    ],
)
def test_entries_outside_real_fields_are_refused(entry, message):
    with pytest.raises(InputError, match=message):
        Arrangement([[entry, 1]])


def test_entries_of_two_fields_are_refused():
    two, three = (NumberField([-n, 0, 1], [1, 2]).root for n in (2, 3))
    for rows in ([[two, three]], [[two, 1], [three, 1]], [[two, sqrt(3)]]):
        with pytest.raises(InputError, match=r"two different fields|not in the field"):
            Arrangement(rows)


def test_equal_planes_are_equal_however_they_are_written():
    g = GOLDEN.root
    planes = Arrangement([[1, g], [1, 0]])
    assert planes == Arrangement([[GoldenRatio - 1, 1], [2, 0]])
    assert planes == Arrangement([[2 * g, 2 * g * g], [g, 0]])
    assert planes == Arrangement([[2, 1 + sqrt(5)], [sqrt(5), 0]])
    assert planes != Arrangement([[-1, -g], [1, 0]])
    assert hash(planes) == hash(Arrangement([[2, 1 + sqrt(5)], [1, 0]]))
    assert Arrangement([[g, 2 * g]]) == Arrangement([[1, 2]])
    assert Arrangement([[g, -1], [-1, g - 1]]).class_of == (0, 0)


@pytest.mark.parametrize(
    "planes",
    [
        families.h3(),
        Arrangement([[cos(2 * pi / 7), 1], [1, 0]], [0, cos(pi / 7)]),
        Arrangement([[sqrt(2) + sqrt(3), 1], [sqrt(6), 1]]),
    ],
)
def test_files_and_pickles_give_the_planes_back(planes):
    assert read_arrangement(json.loads(json.dumps(planes.to_dict()))) == planes
    assert pickle.loads(pickle.dumps(planes)) == planes


#: Factors of discriminants: a prime, and numbers about 100 bits, the bound of factoring.
_LONG = (10**31 + 33, *(2**bits + 1 for bits in (98, 99, 100, 101)), 2**99 - 1, 2**100 - 3)


@pytest.mark.parametrize(
    ("polynomial", "interval"),
    [
        *(([-(k * n), 0, 1], [0, k * n]) for n in _LONG for k in (1, 2, 4, 9, 4**30)),
        *(([-n, m, 1], [0, n]) for n in _LONG for m in (1, 2)),
        *(([-n, 0, "1/3"], [-n, 0]) for n in _LONG),
        ([1 - 10**100, 0, 1], [0, 10**51]),
        ([-(10**31 + 33), 0, 0, 1], [0, 10**31]),
        ([-2, 10**30 + 7, 0, 10**30], [0, 1]),
        ([2 - 10**99, 0, 0, 1], [0, 10**34]),
    ],
)
def test_fields_of_long_polynomials_are_copied_and_read_back(polynomial, interval):
    field = NumberField(polynomial, interval)
    planes = Arrangement([[1, field.root], [0, 1]])
    for copied in (pickle.loads(pickle.dumps(field)), copy.deepcopy(field)):
        assert copied == field
        assert copied.minimal_polynomial == field.minimal_polynomial
    for same in (
        pickle.loads(pickle.dumps(planes)),
        copy.deepcopy(planes),
        read_arrangement(json.loads(json.dumps(planes.to_dict()))),
    ):
        assert same == planes
        assert same.to_dict() == planes.to_dict()


@pytest.mark.parametrize("n", _LONG)
def test_long_quadratic_fields_have_no_factor_4(n):
    one, four = (NumberField([-k * n, 0, 1], [0, k * n]) for k in (1, 4))
    assert one == four
    assert 2 * one.root == four.root


def random_planes(seed: int, *, affine: bool) -> Arrangement:
    source = random.Random(seed)
    g = GOLDEN.root

    def number() -> Any:
        return source.choice([0, 0, 1, -1, 2, g, -g, 1 - g, g + 1])

    rows = [[number() for _ in range(3)] for _ in range(7)]
    rows = [row for row in rows if any(row)]
    return Arrangement(rows, [number() if affine else 0 for _ in rows])


@pytest.mark.parametrize("affine", [False, True])
@pytest.mark.parametrize("seed", range(2))
def test_all_engines_and_counts_agree(seed, affine):
    planes = random_planes(seed, affine=affine)
    faces = planes.faces()
    assert planes.certify_complete()
    every = planes.faces(engine="any-dimension")
    assert {face.signs for face in every} == {face.signs for face in faces}
    lattice = counts.intersection_lattice(planes)
    assert tuple(abs(sum(row)) for row in [lattice.whitney_row(0)]) == (faces.f_vector[-1],)
    assert (
        counts.first_whitney_numbers(planes, symmetry=[])[-1]
        == (counts.first_whitney_numbers(planes)[-1])
    )


def test_regions_over_a_field_can_be_asked():
    g = GOLDEN.root
    triangle = Arrangement([[1, 0], [0, 1], [1, g]], [0, 0, g]).region_at(["1/3", "1/3"])
    assert triangle.vertices == ((0, 0), (g, 0), (0, 1))
    assert triangle.volume == g / 2


def test_the_command_names_the_field(tmp_path, run):
    path = tmp_path / "h3.json"
    run("make h3 -o", path)
    assert "a^2 - 5 = 0" in run("count", path)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize(
    "root",
    [sqrt(2), sqrt(5), 2 * cos(2 * pi / 7), 2 ** Rational(1, 3)],
    ids=["sqrt 2", "sqrt 5", "cos(2 pi / 7)", "third root of 2"],
)
def test_engines_agree_over_fields_and_with_the_signs_of_sympy(root, seed):
    source = random.Random(seed)
    largest = source.choice([1, 3, 10**9])  # from degenerate planes to sums beyond int64

    def number():
        return source.randint(-largest, largest) + source.randint(-1, 1) * root

    d = source.choice([2, 3, 3, 4])
    rows = [[number() for _ in range(d)] for _ in range(6)]
    rows.append([x + y for x, y in zip(*rows[:2], strict=True)])
    affine = seed % 2
    offsets = [affine * number() for _ in rows]
    kept = [(row, b) for row, b in zip(rows, offsets, strict=True) if any(row)]
    planes = Arrangement([row for row, _ in kept], [b for _, b in kept])
    assert planes.certify_complete()
    every = planes.faces(engine="any-dimension")
    assert {face.signs for face in planes.faces()} == {face.signs for face in every}
    assert counts.f_vector(planes) == every.f_vector
    near = [[sympy.N(x, 200) for x in (*row, b)] for row, b in kept]
    for face in source.sample(list(every), min(20, len(every))):
        point = [*(sympy.N(to_sympy(x), 200) for x in face.witness), -1]
        for row, sign in zip(near, face.signs, strict=True):
            value = sum(map(mul, row, point))
            assert sign == (0 if abs(value) < Rational(1, 10**120) else sympy.sign(value))


def _long_rows(planes: int) -> list[list[Any]]:
    """Planes of R^3 over Q(sqrt 5) with coefficients of up to 3,000 digits."""
    source, field = random.Random(3), NumberField([-5, 0, 1], [2, 3])

    def number() -> Any:
        digits = (source.choice((0, source.randint(0, 2999), 2999)) for _ in range(2))
        return field.number([Fraction(source.randint(1, 9), 10**n) for n in digits])

    return [[number() for _ in range(3)] for _ in range(planes)]


def test_long_numbers_of_a_field_are_refused_by_a_forecast(monkeypatch):
    rows = _long_rows(9)
    planes = Arrangement(rows)
    assert Arrangement(planes.normals).integer_planes == planes.integer_planes
    with pytest.raises(OutOfReachError, match=r"minors of 9 planes, of up to .* round"):
        counts.region_count(planes)
    with budget.limit(0.1), pytest.raises(OutOfReachError, match=r"faces of .* steps; leave out"):
        planes.regions()
    monkeypatch.setattr(budget, "STEPS", 20_000)
    with pytest.raises(OutOfReachError, match=r"25 numbers of up to \d+ bits"):
        Arrangement(rows)


def test_time_limit_of_a_count_in_low_rank_is_kept(monkeypatch):
    monkeypatch.setattr(deadline, "clock", itertools.count().__next__)
    field = NumberField([-5, 0, 1], [2, 3])
    rows = [[field.number([3**k, 5**j]) for k in (7, 90, j)] for j in range(2, 9)]
    for planes in (Arrangement(rows), families.random_integer(30, 4, bound=10**30, seed=3)):
        with pytest.raises(OutOfTimeError, match=r"limit of 0.5 s: .* numbers 1 are final"):
            counts.first_whitney_numbers(planes, time_limit=0.5)


@pytest.mark.parametrize(("power", "text"), [(400, "≈2.23607e+400"), (-400, "≈2.23607e-400")])
def test_irrational_numbers_beyond_floats_are_printed(power, text):
    root = NumberField([-5, 0, 1], [2, 3]).root
    assert number_text(root * Fraction(10) ** power) == text
