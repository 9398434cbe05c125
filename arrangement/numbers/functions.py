"""Rational functions of one letter on an interval, compared where one answer holds for all of it.

A `Function` is added, multiplied, divided and compared like a number. A comparison has an answer if
it is the same for every value of the letter in the interval, and raises `Undecided` otherwise. So a
computation that ends shows its result for every value at once: all its decisions have the same
answers. With a `Domain` around a value, comparisons narrow the interval to where they have the
answer that they have at the value: a computation then shows how far its result reaches.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from typing import TypeAlias

from flint import fmpq, fmpq_poly
from flint.utils.flint_exceptions import DomainError

from arrangement.errors import InputError

from .exact import sign, simplest_between, sum_of_powers, to_text

#: What a function is combined with.
Operand: TypeAlias = "Function | Fraction | int"


@dataclass(frozen=True)
class Span:
    """An interval of values, of positive length or one value.

    Attributes:
        low, high: its ends.
        has_low, has_high: whether the ends belong to it.
    """

    low: Fraction
    high: Fraction
    has_low: bool = True
    has_high: bool = True

    def __contains__(self, value: Fraction) -> bool:
        if value in (self.low, self.high):
            return self.has_low if value == self.low else self.has_high
        return self.low < value < self.high

    def joined(self, other: Span) -> Span | None:
        """Return this and the next interval as one; None if there is something between them."""
        if self.high != other.low or not (self.has_high or other.has_low):
            return None
        return Span(self.low, other.high, self.has_low, other.has_high)

    def around(self, part: Span) -> list[Span]:
        """Return what is below a part of this, and what is above it, if there is anything."""
        below = Span(self.low, part.low, self.has_low, not part.has_low)
        above = Span(part.high, self.high, not part.has_high, self.has_high)
        return [x for x in (below, above) if x.low < x.high or (x.has_low and x.has_high)]

    def without(self, parts: Iterable[Span]) -> list[Span]:
        """Return what disjoint parts of this, in order, leave of it."""
        left = [self]
        for part in parts:
            left[-1:] = left[-1].around(part)  # what is above a part is last
        return left

    def __str__(self) -> str:
        ends = f"{to_text(self.low)}, {to_text(self.high)}"
        return f"{'[' if self.has_low else '('}{ends}{']' if self.has_high else ')'}"


class Undecided(ArithmeticError):
    """A comparison with more than one answer on an interval."""


#: Of numerators and denominators.
_MAX_DEGREE = 1000
#: How near to a root an interval is cut, if nothing else is asked.
_WIDTH = Fraction(1, 10**9)
#: Roots with larger denominators are no ends of intervals.
_LONG = 10**9


class Domain:
    """The interval on which functions are compared.

    Args:
        span: the interval.
        value: in it; where it is given, comparisons narrow the interval around it, else they raise
            `Undecided`.
        width: how near to roots that are irrational, or long, the interval is cut.
        letter: its name in texts.
    """

    def __init__(
        self,
        span: Span,
        value: Fraction | None = None,
        width: Fraction = _WIDTH,
        letter: str = "t",
    ) -> None:
        self.span, self.value, self.width, self.letter = span, value, width, letter

    def decide(self, polynomial: fmpq_poly, wanted: set[int]) -> bool:
        """Return whether all signs of a polynomial are among those wanted.

        Raises:
            Undecided: some are and some are not, and no value is given.
        """
        signs, roots = signs_on(polynomial, self.span)
        if signs <= wanted:
            return True
        if not signs & wanted:
            return False
        if self.value is None:
            text = polynomial_text(polynomial, self.letter)
            raise Undecided(f"{text} has more than one sign in {self.span}")
        answer = sign(polynomial(_rational(self.value))) in wanted
        self._narrow(polynomial, roots, lambda x: (x in wanted) == answer)
        return answer

    def _narrow(
        self,
        polynomial: fmpq_poly,
        roots: Sequence[tuple[Fraction, Fraction]],
        is_alike: Callable[[int], bool],
    ) -> None:
        """Cut the interval to where the signs are alike, around the value or beside it."""
        assert self.value is not None
        exact = {_fraction(root) for root, _ in polynomial.roots()}
        narrow = []
        for low, high in roots:
            known = next((root for root in exact if low <= root <= high), None)
            pair = (low, high) if known is None else (known, known)
            while pair[0] < self.value < pair[1] or pair[1] - pair[0] > self.width:
                pair = _narrow(polynomial, pair, (pair[1] - pair[0]) / 2)
            narrow.append(pair)
        ends = [self._end(polynomial, narrow, is_alike, way) for way in (-1, 1)]
        (low, has_low), (high, has_high) = ends
        self.span = Span(low, high, has_low, has_high)

    def _end(
        self,
        polynomial: fmpq_poly,
        roots: Sequence[tuple[Fraction, Fraction]],
        is_alike: Callable[[int], bool],
        way: int,
    ) -> tuple[Fraction, bool]:
        """Return how far signs are alike from the value on, up (1) or down (-1)."""
        assert self.value is not None
        last = self.span.high if way > 0 else self.span.low
        has_last = self.span.has_high if way > 0 else self.span.has_low
        # Where the last root, or the value, ends; and up to where all is alike.
        place, reached = self.value, (self.value, True)
        for pair in roots if way > 0 else roots[::-1]:
            near, far = pair[::way]
            if (near - self.value) * way < 0:
                continue
            if near != self.value:
                if not is_alike(sign(polynomial(_rational((place + near) / 2)))):
                    return reached
                is_short = near == far and near.denominator <= _LONG
                if not is_alike(0):
                    return (near, False) if is_short else (self._before(near), True)
                reached = (near, True) if is_short else (self._before(near), True)
            place = far
        if place == last:
            return reached
        if not is_alike(sign(polynomial(_rational((place + last) / 2)))):
            return reached
        return last, has_last

    def _before(self, root: Fraction) -> Fraction:
        """Return a short number between the value and a root, near the root."""
        assert self.value is not None
        beside = root + min(self.width, abs(self.value - root)) * (1 if self.value > root else -1)
        return simplest_between(*sorted((root, beside)))


class Function:
    """A rational function of one letter on an interval; frozen.

    Args:
        top, below: numerator and denominator; the second has no root in the interval.
        domain: the interval, or how functions are compared on it.
    """

    __slots__ = ("below", "domain", "top")
    #: Of exact numbers in general: a function is no fraction of integers.
    denominator = 1

    def __init__(self, top: fmpq_poly, below: fmpq_poly, domain: Domain) -> None:
        if max(top.degree(), below.degree()) > _MAX_DEGREE:
            raise InputError(f"an expression has a degree above {_MAX_DEGREE}; write a simpler one")
        if below.degree() > 0:
            common = top.gcd(below)
            if common.degree() > 0:
                top, below = top // common, below // common
        leading = below.leading_coefficient()
        if leading != 1:
            top, below = top / leading, below / leading
        self.top, self.below, self.domain = top, below, domain

    @classmethod
    def letter(cls, domain: Domain) -> Function:
        """Return the function whose value is the letter."""
        return cls(fmpq_poly([0, 1]), fmpq_poly([1]), domain)

    @classmethod
    def constant(cls, value: Fraction | int, domain: Domain) -> Function:
        """Return a constant function."""
        return cls(fmpq_poly([_rational(value)]), fmpq_poly([1]), domain)

    @property
    def numerator(self) -> Function:
        """The function itself, see `denominator`."""
        return self

    def at(self, value: Fraction) -> Fraction:
        """Return its value at a value of the letter."""
        x = _rational(value)
        return _fraction(self.top(x) / self.below(x))

    def _other(self, value: Operand) -> Function:
        return value if isinstance(value, Function) else self.constant(value, self.domain)

    def __add__(self, value: Operand) -> Function:
        other = self._other(value)
        top = self.top * other.below + other.top * self.below
        return Function(top, self.below * other.below, self.domain)

    __radd__ = __add__

    def __neg__(self) -> Function:
        return Function(-self.top, self.below, self.domain)

    def __sub__(self, value: Operand) -> Function:
        return self + -self._other(value)

    def __rsub__(self, value: Operand) -> Function:
        return self._other(value) + -self

    def __mul__(self, value: Operand) -> Function:
        other = self._other(value)
        return Function(self.top * other.top, self.below * other.below, self.domain)

    __rmul__ = __mul__

    def __truediv__(self, value: Operand) -> Function:
        """Divide by what is 0 nowhere on the interval.

        Raises:
            ZeroDivisionError: it is 0 everywhere.
            Undecided: it is 0 somewhere.
        """
        other = self._other(value)
        if not other:
            raise ZeroDivisionError(f"{other} is 0")
        return Function(self.top * other.below, self.below * other.top, self.domain)

    def __floordiv__(self, value: int) -> Function:
        """Divide by a constant, as integers are divided where nothing remains."""
        return self / value

    def __rtruediv__(self, value: Operand) -> Function:
        return self._other(value) / self

    def __abs__(self) -> Function:
        return self if self >= 0 else -self

    def signs(self) -> set[int]:
        """Return the signs that it takes on the interval."""
        return signs_on(self._product, self.domain.span)[0]

    @property
    def _product(self) -> fmpq_poly:
        # Below is 0 nowhere, so the product has the sign of the quotient.
        return self.top * self.below

    def _all(self, wanted: set[int]) -> bool:
        return self.domain.decide(self._product, wanted)

    def __bool__(self) -> bool:
        return self._all({1, -1})

    def __lt__(self, value: Operand) -> bool:
        return (self - value)._all({-1})

    def __gt__(self, value: Operand) -> bool:
        return (self - value)._all({1})

    def __le__(self, value: Operand) -> bool:
        return (self - value)._all({0, -1})

    def __ge__(self, value: Operand) -> bool:
        return (self - value)._all({0, 1})

    def __eq__(self, value: object) -> bool:
        if not isinstance(value, (Function, Fraction, int)):
            return NotImplemented
        return (self - value)._all({0})

    def __hash__(self) -> int:
        # Different functions may be equal on the interval, so each is compared with all.
        return 0

    def text(self) -> str:
        """Return the function as text that `read_expression` takes."""
        letter = self.domain.letter
        top = polynomial_text(self.top, letter)
        if not self.below.degree():
            return top
        return f"({top})/({polynomial_text(self.below, letter)})"

    def __repr__(self) -> str:
        return self.text()


def polynomial_text(polynomial: fmpq_poly, letter: str) -> str:
    """Return a polynomial as text, from the highest power."""
    terms = reversed(list(enumerate(map(_fraction, polynomial.coeffs()))))
    return sum_of_powers(terms, letter)


def signs_on(polynomial: fmpq_poly, span: Span) -> tuple[set[int], list[tuple[Fraction, Fraction]]]:
    """Return the signs that a polynomial takes on an interval, and intervals with one root each.

    The roots are those of odd and even multiplicity, ends of the interval included, by Descartes'
    rule for Bernstein coefficients and bisection.
    """
    low, high = _rational(span.low), _rational(span.high)
    if not polynomial or span.low == span.high:
        return {sign(polynomial(low)) if polynomial else 0}, []
    roots = list(_roots(polynomial // polynomial.gcd(polynomial.derivative()), low, high))
    ends = [(x, x) for x, is_in in ((low, span.has_low), (high, span.has_high)) if is_in]
    at_ends = [pair for pair in ends if polynomial(pair[0]) == 0]
    signs = {sign(polynomial(x)) for x, _ in ends}
    signs |= {0} if roots else set()
    # Between two roots, or a root and an end, there is one sign.
    cuts = [low, *(x for pair in roots for x in pair), high]
    signs |= {sign(polynomial((x + y) / 2)) for x, y in list(pairwise(cuts))[::2]}
    intervals = sorted([*roots, *at_ends])
    return signs, [(_fraction(x), _fraction(y)) for x, y in intervals]


def _roots(squarefree: fmpq_poly, low: fmpq, high: fmpq) -> Iterator[tuple[fmpq, fmpq]]:
    """Yield intervals inside (low, high) with one root each, in order."""
    if squarefree.degree() < 1:
        return
    changes = _changes(_bernstein(squarefree, low, high))
    if not changes:
        return
    middle = (low + high) / 2
    if changes == 1 and squarefree(low) != 0 != squarefree(high):
        if squarefree.degree() == 1:
            root = -squarefree[0] / squarefree[1]
            yield root, root
        else:
            yield low, high
        return
    yield from _roots(squarefree, low, middle)
    if squarefree(middle) == 0:
        yield middle, middle
    yield from _roots(squarefree, middle, high)


def _narrow(
    polynomial: fmpq_poly, pair: tuple[Fraction, Fraction], width: Fraction
) -> tuple[Fraction, Fraction]:
    """Return an interval around the one root in another, up to a width."""
    simple = polynomial // polynomial.gcd(polynomial.derivative())
    low, high = map(_rational, pair)
    while _fraction(high - low) > width:
        middle = (low + high) / 2
        below = sign(simple(middle)) == sign(simple(low))
        low, high = (middle, high) if below else (low, middle)
    return _fraction(low), _fraction(high)


def _bernstein(polynomial: fmpq_poly, low: fmpq, high: fmpq) -> list[fmpq]:
    """Return the coefficients of a polynomial in Bernstein's basis of an interval."""
    moved = polynomial(fmpq_poly([low, high - low]))
    n = moved.degree()
    row = [moved[k] / math.comb(n, k) for k in range(n + 1)]
    # Sums of binomial coefficients times them, by repeated sums of neighbours.
    for step in range(n):
        for k in range(n, step, -1):
            row[k] += row[k - 1]
    return row


def _changes(row: Sequence[fmpq]) -> int:
    """Return how often the sign changes in a row, zeros left out."""
    signs = [sign(x) for x in row if x != 0]
    return sum(x != y for x, y in pairwise(signs))


def _rational(value: Fraction | int) -> fmpq:
    return fmpq(value.numerator, value.denominator)


def _fraction(value: fmpq) -> Fraction:
    return Fraction(int(value.p), int(value.q))


def square_root(square: Function) -> Function | None:
    """Return the function above 0 of which this is the square; None if it is not rational.

    Raises:
        Undecided: it is 0 somewhere on the interval.
    """
    try:
        root = Function(square.top.sqrt(), square.below.sqrt(), square.domain)
    except DomainError:
        return None
    return abs(root) if root else root
