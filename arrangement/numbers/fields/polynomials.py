"""Polynomials that define a number field: what is refused, and what is made of their coefficients.

Coefficients stand from the constant term up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from arrangement.errors import InputError
from arrangement.numbers.exact import RationalVector, shown, to_text

#: Largest degree of a field: a product takes as many steps as its square.
MAX_DEGREE = 16
#: Of a coefficient of a minimal polynomial.
MAX_DIGITS = 100


def checked_ends(given: RationalVector, ends: RationalVector) -> tuple[Fraction, Fraction]:
    """Return the ends of the interval, if it isolates a root of an irreducible polynomial."""
    n = len(given) - 1
    text = shown([to_text(x) for x in given])
    if not 2 <= n <= MAX_DEGREE or not given[-1]:
        raise InputError(
            f"the minimal polynomial is {text}; its coefficients stand from the constant term up, "
            f"the last one is not 0, and its degree is 2 to {MAX_DEGREE}"
        )
    if any(max(abs(x.numerator), x.denominator) >= 10**MAX_DIGITS for x in given):
        raise InputError(
            f"the minimal polynomial is {text}; its coefficients may have up to {MAX_DIGITS} digits"
        )
    if len(ends) != 2 or ends[0] >= ends[1]:
        raise InputError(
            f"the interval is {shown([to_text(x) for x in ends])}; give its two ends, the lower "
            "one first"
        )
    polynomial = None
    if n == 2:
        square = (given[1] ** 2 - 4 * given[0] * given[2]) / given[2] ** 2
        irreducible = square < 0 or any(
            math.isqrt(x) ** 2 != x for x in (square.numerator, square.denominator)
        )
    else:
        polynomial = to_polynomial(given)
        irreducible = polynomial.is_irreducible
    if not irreducible:
        raise InputError(
            f"the minimal polynomial {text} is reducible over Q; give the factor that has the root"
        )
    low, high = ends
    if n == 2:
        middle = -given[1] / given[2] / 2
        outside = [value_at(given, x) * given[2] > 0 for x in ends]
        both = all(outside) and low < middle < high and square > 0
        roots = outside[0] != outside[1] or 2 * both
        real = square > 0
    else:
        assert polynomial is not None
        roots = polynomial.count_roots(to_rational(low), to_rational(high))
        real = polynomial.count_roots() > 0
    if int(roots) != 1:
        none = "no real root there" if real else "no real root at all, so no real embedding"
        raise InputError(
            f"the minimal polynomial {text} has {int(roots) or none} "
            f"{'roots ' if roots else ''}between {to_text(low)} and {to_text(high)}; give an "
            "interval with exactly one"
        )
    return low, high


def integral_multiple(monic: Sequence[Fraction]) -> int:
    """Return a positive integer that makes roots algebraic integers, the least if it is small."""
    n, enough = len(monic) - 1, math.lcm(*(x.denominator for x in monic))
    for scale in range(1, min(enough, 1000)):
        if all((x * scale ** (n - k)).denominator == 1 for k, x in enumerate(monic)):
            return scale
    return enough


def square_part(number: int) -> int:
    """Return the largest s with s^2 dividing a positive number; 1 for numbers beyond factoring."""
    if number.bit_length() > 100:
        return 1
    from flint import fmpz

    return math.prod(int(p) ** (power // 2) for p, power in fmpz(number).factor())


def value_at(polynomial: Sequence[Fraction | int], x: Fraction) -> Fraction:
    """Return the value of a polynomial at a rational number."""
    found = Fraction(0)
    for c in reversed(polynomial):
        found = found * x + c
    return found


def to_rational(value: Fraction) -> Any:
    """Return a fraction as a number of SymPy."""
    import sympy

    return sympy.Rational(value.numerator, value.denominator)


def to_polynomial(coefficients: Sequence[Fraction | int]) -> Any:
    """Return a SymPy polynomial from its coefficients, from the constant term up."""
    import sympy

    terms = [to_rational(Fraction(c)) for c in reversed(coefficients)]
    return sympy.Poly(terms, sympy.Symbol("x"), domain=sympy.QQ)
