"""Exact numbers: how rationals come in, how they go out, and primitive integer vectors.

Inside the package a number is a :class:`fractions.Fraction` or a Python integer. Everything
from outside passes through :func:`rational`, which never turns a float into a rational
silently and never evaluates text.
"""

from __future__ import annotations

import math
import numbers
import re
import reprlib
from collections.abc import Callable, Iterable, Sequence
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal, Inexact
from fractions import Fraction
from functools import reduce
from itertools import chain, islice, starmap
from operator import mul
from typing import Any, TypeAlias

from arrangement.errors import InputError
from arrangement.numbers import budget

IntegerVector: TypeAlias = tuple[int, ...]
RationalVector: TypeAlias = tuple[Fraction, ...]
#: What :func:`rational` accepts (sympy, numpy and flint numbers are recognised by their interface).
Rational: TypeAlias = int | Fraction | str | numbers.Rational | Any

#: Digits that int() and str() convert; they refuse more than 4300, which FLINT does not.
_DIGITS = 2000
#: Bits of a long integer.
_LONG = 300
#: Bits from which on FLINT's divisors are faster: eight times at 300,000.
_VERY_LONG = 8000

#: Texts of up to this many characters int() reads as we do, if they are all of `_INT_LETTERS`.
_MAX_INT_LETTERS = 18
_INT_LETTERS = frozenset("-0123456789")
_INTEGER_OR_RATIO = re.compile(r"([+-]?[0-9]+)(?:/([0-9]+))?")
_DECIMAL = re.compile(r"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?:[eE]([+-]?[0-9]{1,4}))?")


def rational(value: Rational, name: str = "number") -> Fraction:
    """Return `value` as an exact rational, or refuse it.

    Accepted: ``int``, ``Fraction``, sympy ``Rational``, numpy integers, flint and gmpy rationals,
    and text such as ``"7/3"``, ``"-0.25"`` or ``"-1e-3"`` (ASCII digits, an exponent of at most
    four digits, at most 100000 characters). Refused: floats, Booleans, NaN, everything else. A
    function of `arrangement.numbers.functions` is returned as it is.

    Raises:
        InputError: the message has `name`, the value, the rule and the remedy.

    >>> rational("7/3"), rational("-0.25"), rational(5)
    (Fraction(7, 3), Fraction(-1, 4), Fraction(5, 1))
    """
    if isinstance(value, str):
        return _from_text(value, name)
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):
        raise InputError(f"{name} is the Boolean {value}; write 0 or 1 if a number is meant")
    if isinstance(value, Fraction):
        return value
    if isinstance(value, int):
        return Fraction(value)
    if isinstance(value, numbers.Rational):
        return Fraction(int(value.numerator), int(value.denominator))
    if isinstance(value, numbers.Real):
        example = float(value) if math.isfinite(value) else -0.25
        raise InputError(
            f"{name} is the float {shown(float(value))}, expected an exact number; write each "
            f'float as a string such as "7/3" or "{example}"'
            + budget.by_caller(
                ", or convert on purpose with arrangement.from_floats(values), each array alone; "
                "equilibrium.inputs.from_float_data(points, normals, friction).grasp takes floats",
                "",
            )
        )
    numerator, denominator = (getattr(value, k, None) for k in ("numerator", "denominator"))
    if isinstance(numerator, int) and isinstance(denominator, int):  # sympy's PythonMPQ
        return Fraction(numerator, denominator)
    if hasattr(value, "p") and hasattr(value, "q"):  # python-flint's fmpq
        return Fraction(int(value.p), int(value.q))
    # Arrays, which have lengths, are not numbers.
    if hasattr(value, "__index__") and not hasattr(value, "__len__"):  # fmpz, mpz
        return Fraction(value.__index__())
    if value is not None and numerator is value:  # see `arrangement.numbers.functions`
        return value  # type: ignore[return-value]
    remedy = budget.by_caller("an integer, a Fraction, a sympy Rational", "an integer")
    kind = type(value).__name__
    what = budget.by_caller(f"{shown(value)} of type {kind}", "not a number")
    raise InputError(f'{name} is {what}; give {remedy} or a string such as "7/3"')


def _from_text(text: str, name: str) -> Fraction:
    """Parse a rational from text with two fixed patterns; nothing is ever evaluated."""
    if len(text) > budget.MAX_SIZES["characters of a number"]:
        budget.check_size(len(text), "characters of a number", f"{name} is {shown(text)}")
    ratio = _INTEGER_OR_RATIO.fullmatch(text)
    if ratio is not None:
        if not ratio[2]:
            return Fraction(integer(ratio[1]))
        denominator = integer(ratio[2])
        if denominator == 0:
            raise InputError(f"{name} is {shown(text)}, which divides by zero")
        return Fraction(integer(ratio[1]), denominator)
    decimal = _DECIMAL.fullmatch(text)
    if decimal is not None:
        whole, _, decimals = decimal[1].partition(".")
        power = int(decimal[2] or 0) - len(decimals)
        digits = integer(whole + decimals)
        return Fraction(digits * 10**power) if power > 0 else Fraction(digits, 10**-power)
    if _DECIMAL.fullmatch(point := text.replace(",", ".", 1)) and "," in text:
        raise InputError(
            f"{name} is {shown(text)}, which is not an exact number; decimals have a point: {point}"
        )
    raise InputError(
        f'{name} is {shown(text)}, which is not an exact number; write "7/3", "-0.25", "1e-3" or '
        '"12" (exponents of at most four digits, no spaces, no expressions)'
    )


def integer(text: str) -> int:
    """Return the integer of a sign and decimal digits; int() refuses very long ones."""
    if len(text) <= _DIGITS:
        return int(text)
    from flint import fmpz

    return int(fmpz(text.removeprefix("+")))


class _Short(reprlib.Repr):
    """A representation of bounded length and depth that never fails on huge numbers."""

    def repr_int(self, x: int, level: int) -> str:
        return to_text(x)

    def repr_Fraction(self, x: Fraction, level: int) -> str:
        return to_text(x)


_short = _Short()
_short.maxlevel = 2
_short.maxstring = _short.maxlong = _short.maxother = 60


def shown(value: object) -> str:
    """Return a short form of a rejected value for an error message, however large or deep."""
    text = _short.repr(value)
    return text if len(text) <= 60 else f"{text[:40]}...{text[-10:]}"


def sign_text(signs: Sequence[int], minus: str = "-") -> str:
    """Return a sign vector as text.

    >>> sign_text((1, 0, -1))
    '+0-'
    """
    return "".join("+" if sign > 0 else minus if sign < 0 else "0" for sign in signs)


def from_floats(values: Any, *, name: str = "value to convert") -> Any:
    """Convert binary floats to the rationals that they are, exactly and on purpose.

    Args:
        values: a number, or a sequence or array of any depth. Integers and rationals pass
            through.

    Returns:
        A `Fraction`, or nested tuples of them in the shape of `values`.

    Raises:
        InputError: for NaN or an infinite value, a masked entry, a complex number; it has `name`.

    >>> from_floats([0.5, 0.1])
    (Fraction(1, 2), Fraction(3602879701896397, 36028797018963968))
    >>> from arrangement import Arrangement
    >>> str(Arrangement(from_floats([[0.5, 1.0]]), from_floats([0.25]))[0])
    '2*x + 4*y = 1'
    """
    if hasattr(values, "filled") and values.count() < values.size:  # masked arrays of numpy
        raise InputError(f"{name} has masked entries; leave them out, or fill them with numbers")
    if hasattr(values, "tolist"):  # numpy arrays and scalars
        values = values.tolist()
    if isinstance(values, numbers.Real) and not isinstance(values, numbers.Rational):
        try:
            return Fraction(*values.as_integer_ratio())  # type: ignore[attr-defined]
        except (OverflowError, ValueError):
            raise InputError(f"{name} is {values}; only finite floats can be converted") from None
    if isinstance(values, Iterable) and not isinstance(values, (str, bytes)):
        return tuple(from_floats(value, name=name) for value in values)
    return rational(values, name)


def from_float(value: Any, name: str) -> Fraction:
    """Return one number as `from_floats` does; refuse sequences."""
    fraction = from_floats(value, name=name)
    if isinstance(fraction, tuple):
        raise InputError(f"{name} is {shown(value)}; give one number")
    return Fraction(fraction)


def rational_vector(
    values: Any, name: str = "vector", read: Callable[[Any, str], Any] = rational
) -> RationalVector:
    """Return a sequence of accepted numbers as a tuple of `Fraction`; errors name the entry.

    Args:
        read: what takes an entry and its name to a number.
    """
    if callable(getattr(values, "flat", None)):  # SymPy's matrices
        values = values.flat()
    scalar = isinstance(values, (str, bytes)) or not getattr(values, "ndim", 1)
    if scalar or not isinstance(values, Iterable):
        raise InputError(f"{name} is {shown(values)}; give a sequence of exact numbers")
    values = list(values)
    try:
        return tuple([read(value, name) for value in values])
    except InputError:
        # Names of entries take as long as reading them: only where one is wrong.
        return tuple(read(value, entry_name(name, i)) for i, value in enumerate(values))


def entry_name(name: str, index: int) -> str:
    """Return what an entry is called: by its index in a variable, else by its number.

    >>> entry_name("points[2]", 0), entry_name("normal 3", 0)
    ('points[2][0]', 'entry 1 of normal 3')
    """
    return f"entry {index + 1} of {name}" if " " in name else f"{name}[{index}]"


def plain_rows(rows: Sequence[Any]) -> list[IntegerVector] | None:
    """Return rows of integers, given as such or as short texts; None if there is anything else.

    This is most of what is read, and twenty times as fast as `rational_vector`.
    """
    if not set(map(type, rows)) <= {list, tuple}:
        return None
    flat = list(chain.from_iterable(rows))
    kinds = set(map(type, flat))
    if not kinds <= {int, str}:
        return None
    if kinds == {int}:
        return list(map(tuple, rows))
    texts = [x for x in flat if type(x) is str]
    if (
        max(map(len, texts), default=0) > _MAX_INT_LETTERS
        or not set("".join(texts)) <= _INT_LETTERS
    ):
        return None
    try:
        numbers = map(int, flat)
        return [tuple(islice(numbers, len(row))) for row in rows]
    except ValueError:  # a sign alone or in the middle, or nothing
        return None


def primitive(vector: Sequence[Fraction | int]) -> IntegerVector:
    """Return the positive multiple of a rational vector with coprime integer entries.

    The direction is kept, so ``v`` and ``-v`` stay different; the zero vector stays zero.

    >>> primitive([Fraction(1, 2), Fraction(-1, 3), 0])
    (3, -2, 0)
    """
    return reduced(without_denominators(vector))


def without_denominators(vector: Sequence[Fraction | int]) -> Sequence[int]:
    """Return a rational vector times the least common denominator of its entries."""
    if set(map(type, vector)) <= {int}:
        return vector  # type: ignore[return-value]
    scale = math.lcm(*(x.denominator for x in vector))
    return [x.numerator * (scale // x.denominator) for x in vector]


def over_unit(vector: Sequence[Fraction | int]) -> tuple[list[int], int]:
    """Return integers and their least common denominator."""
    unit = math.lcm(*(x.denominator for x in vector))
    return [x.numerator * (unit // x.denominator) for x in vector], unit


def integers_over(vector: Sequence[Fraction | int], unit: int) -> IntegerVector:
    """Return a vector times a common denominator."""
    return tuple([x.numerator * (unit // x.denominator) for x in vector])


def reduced(vector: Sequence[int]) -> IntegerVector:
    """Divide an integer vector by the greatest common divisor of its entries.

    Of algebraic integers it is the positive multiple whose first nonzero entry is rational, again
    with integer coefficients that have no common divisor: one vector for each direction.
    """
    try:
        divisor = math.gcd(*vector)
    except TypeError:  # an entry is irrational
        return _reduced_in_field(vector)
    return tuple(vector) if divisor <= 1 else tuple([x // divisor for x in vector])


def all_reduced(rows: Sequence[Sequence[int]]) -> list[IntegerVector]:
    """Return `reduced` of each row."""
    size = largest(rows)
    if size == math.inf:
        return list(map(reduced, rows))
    divisors = starmap(common_divisor if size > 2**_VERY_LONG else math.gcd, rows)
    return [
        tuple(row) if divisor <= 1 else tuple([x // divisor for x in row])
        for row, divisor in zip(rows, divisors, strict=True)
    ]


def common_divisor(*values: int) -> int:
    """Return the greatest common divisor of integers that may be very long."""
    if max(value.bit_length() for value in values) <= _VERY_LONG:
        return math.gcd(*values)
    from flint import fmpz

    return int(reduce(fmpz.gcd, map(fmpz, values)))


def common_multiple(*values: int) -> int:
    """Return the least common multiple of positive integers that may be very long."""
    if max(value.bit_length() for value in values) <= _VERY_LONG:
        return math.lcm(*values)
    return reduce(lambda a, b: a // common_divisor(a, b) * b, values)


def are_integers(vector: Iterable[Any]) -> bool:
    """Return whether all entries are integers, of Python or numpy; else some are irrational."""
    # A list takes half the time of a generator, in the inner loops of others.
    return all([isinstance(x, int) or hasattr(x, "__index__") for x in vector])  # noqa: C419


def _reduced_in_field(vector: Sequence[Any]) -> tuple[Any, ...]:
    first = next(x for x in vector if x)
    if not isinstance(first, int):
        inverse = 1 / abs(first)
        vector = [x * inverse for x in vector]
    scale = common_multiple(*(x.denominator for x in vector))
    whole = [x.numerator * (scale // x.denominator) for x in vector]
    divisor = common_divisor(*(x if isinstance(x, int) else x.content for x in whole))
    return tuple(x // divisor for x in whole)


def unoriented(vector: Sequence[int]) -> IntegerVector:
    """Return the coprime multiple whose first nonzero entry is positive: one name for a line.

    >>> unoriented([0, -4, 6])
    (0, 2, -3)
    """
    return one_way(reduced(vector))


def one_way(vector: IntegerVector) -> IntegerVector:
    """Return the vector or its negative: the one whose first nonzero entry is positive."""
    return tuple([-x for x in vector]) if vector < (0,) * len(vector) else vector


def largest(rows: Iterable[Iterable[int]]) -> float:
    """Return the largest size of an entry; infinity, beyond every bound, if one is irrational."""
    entries = list(chain.from_iterable(rows))
    if set(map(type, entries)) != {int} and not are_integers(entries):
        return math.inf
    return max(max(entries, default=0), -min(entries, default=0))


def work_factor(rows: Iterable[Iterable[Any]], long: float = 1) -> float:
    """Return how many times as long products of these numbers take as those of machine words.

    Args:
        long: how much longer than a product it takes where numbers have more than 500 bits; of
            numbers of a field of degree c, c^3 times that.
    """
    entries = list(chain.from_iterable(rows))
    bits, degree = max(map(bit_size, entries), default=0), 1
    if not are_integers(entries):
        bits, degree = max(bits, 60), max(len(getattr(x, "coefficients", "1")) for x in entries)
    more = (long * degree**3 - 1) * max(0.0, bits / 500 - 1) ** 1.6
    return 1.0 if bits <= 20 else 3 + (bits / 500) ** 1.6 + more


def bit_size(x: Any) -> int:
    """Return the bits of the longest integer in an exact number."""
    if isinstance(x, int):
        return x.bit_length()
    parts = getattr(x, "coefficients", None) or (x.numerator,)  # of a field, or a fraction
    return max([int(part).bit_length() for part in (*parts, x.denominator)])


def fast_integers(rows: Sequence[Sequence[int]]) -> list[list[Any]]:
    """Return rows of integers of one kind, FLINT's where some are long; both kinds mix.

    A step of elimination, ``(p a - q b) // d``, takes as long with both kinds at 200 bits; with 500
    bits Python's integers take 3 times as long as FLINT's, with 1000 bits 4 times, with 4000 bits
    7. FLINT's are none of Python's numbers: `int` must come before a `Fraction` is made of them.
    """
    size = largest(rows)
    if not isinstance(size, int) or size.bit_length() < _LONG:
        return [list(row) for row in rows]
    from flint import fmpz

    return [[fmpz(x) for x in row] for row in rows]


def fraction(x: Any) -> Any:
    """Return an integer as a `Fraction`, and any other exact number as it is."""
    return Fraction(x) if isinstance(x, int) else x


def quotient(x: Any, y: Any) -> Any:
    """Return x / y of exact numbers; of two integers as a `Fraction`."""
    return Fraction(x, y) if isinstance(x, int) and isinstance(y, int) else x / y


def bits(mask: int) -> tuple[int, ...]:
    """Return the positions of the ones of a mask, increasing.

    >>> bits(0b1101)
    (0, 2, 3)
    """
    places = []
    while mask:
        lowest = mask & -mask
        places.append(lowest.bit_length() - 1)
        mask ^= lowest
    return tuple(places)


def to_text(value: Fraction | int) -> str:
    """Return the canonical text of a rational of any size: ``"7/3"``, ``"2"``, ``"-1/2"``."""
    numerator = _integer_text(value.numerator)
    return (
        numerator if value.denominator == 1 else f"{numerator}/{_integer_text(value.denominator)}"
    )


def number_text(value: Fraction | int, digits: int = 6, longest: int = 12) -> str:
    """Return a rational of any size for people: exact if that is short, else a decimal number.

    A decimal number is the nearest one with a given number of digits; the sign ≈ says where it is
    rounded.

    >>> number_text(Fraction(-1, 3)), number_text(Fraction(40579, 5242880)), number_text(10**40)
    ('-1/3', '≈0.00773983', '1e+40')
    """
    if not isinstance(value, (int, Fraction)):  # an irrational number of a field
        return f"≈{_decimal(value.near(4 * digits + 8), digits)[0]}"
    size = value.numerator.bit_length() + value.denominator.bit_length()
    if size <= 4 * longest and len(text := to_text(value)) <= longest:
        return text
    near, rounded = _decimal(value, digits)
    return "≈" * rounded + near


def common_digits(low: Fraction | int, high: Fraction | int, digits: int = 6) -> str | None:
    """Return the decimal number, of most digits, to which both ends are rounded; None if none is.

    >>> common_digits(Fraction(40579, 524288), Fraction(81159, 1048576))
    '0.0774'
    """
    for fewer in range(digits, 0, -1):
        (one, _), (other, _) = _decimal(low, fewer), _decimal(high, fewer)
        if one == other:
            return one
    return None


def _decimal(value: Fraction | int, digits: int) -> tuple[str, bool]:
    """Return the nearest decimal number with this many digits, and whether it differs."""
    context = Context(prec=digits, Emin=MIN_EMIN, Emax=MAX_EMAX)
    near = context.divide(Decimal(value.numerator), Decimal(value.denominator))
    mantissa, e, power = f"{near:g}".partition("e")
    if "." in mantissa:
        mantissa = mantissa.rstrip("0").rstrip(".")
    return mantissa + e + power, bool(context.flags[Inexact])


def vector_text(values: Iterable[Fraction | int]) -> str:
    """Return a vector with short numbers: ``"(1, -1/2, 0)"``."""
    return f"({', '.join(number_text(x) for x in values)})"


def sum_text(
    terms: Iterable[tuple[Any, str]], times: str = "*", factor: Callable[[Any], str] = to_text
) -> str:
    """Return a sum of numbers times names; terms with 0 are left out.

    Args:
        terms: a number and its name, which is empty for a constant.
        times: between a number and its name.
        factor: makes the text of a positive number.

    >>> sum_text([(-2, "x"), (0, "y"), (1, "z"), (Fraction(1, 2), "")])
    '-2*x + z + 1/2'
    """
    text = ""
    for number, name in terms:
        if number:
            sign = ("-" if number < 0 else "") if not text else " - " if number < 0 else " + "
            size = "" if name and abs(number) == 1 else factor(abs(number)) + times * bool(name)
            text += sign + size + name
    return text


def sum_of_powers(
    terms: Iterable[tuple[int, Any]],
    letter: str = "a",
    times: str = "*",
    factor: Callable[[Any], str] = to_text,
) -> str:
    """Return numbers times powers of a letter, given by their exponents, as `sum_text` does.

    >>> sum_of_powers([(2, 3), (1, Fraction(-1, 2)), (0, 1)])
    '3*a^2 - 1/2*a + 1'
    """
    powers = ((number, letter * bool(k) + f"^{k}" * (k > 1)) for k, number in terms)
    return sum_text(powers, times, factor) or "0"


def _integer_text(value: int) -> str:
    """Return the decimal digits of an integer; str() refuses very long ones."""
    if value.bit_length() <= _DIGITS:
        return str(value)
    from flint import fmpz

    return str(fmpz(value))


def simplest_between(low: Fraction, high: Fraction) -> Fraction:
    """Return the rational of least denominator in a closed interval (then of least size).

    >>> simplest_between(Fraction(31, 100), Fraction(34, 100))
    Fraction(1, 3)
    """
    if low > high:
        raise InputError(f"the interval from {shown(low)} to {shown(high)} is empty")
    if low <= 0 <= high:
        return Fraction(0)
    if high < 0:
        return -simplest_between(-high, -low)
    whole = -(-low.numerator // low.denominator)
    if whole <= high:
        return Fraction(whole)
    floor = low.numerator // low.denominator
    return floor + 1 / simplest_between(1 / (high - floor), 1 / (low - floor))


def exact_root(square: Fraction | int) -> Fraction | None:
    """Return the square root of a number, at least 0, where it is rational; else None.

    >>> exact_root(Fraction(4, 9)), exact_root(2)
    (Fraction(2, 3), None)
    """
    top, bottom = math.isqrt(square.numerator), math.isqrt(square.denominator)
    is_exact = (top * top, bottom * bottom) == (square.numerator, square.denominator)
    return Fraction(top, bottom) if is_exact else None


def sign(value: Any) -> int:
    """Return -1, 0 or 1."""
    side: int = (value > 0) - (value < 0)
    return side


def dot(left: Sequence[Any], right: Sequence[Any]) -> Any:
    """Return the scalar product of two exact vectors of equal length."""
    if len(left) != len(right):
        raise ValueError(f"the vectors have {len(left)} and {len(right)} entries")
    return sum(map(mul, left, right))
