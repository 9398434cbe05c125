"""Expressions in one letter, as ``3/2 - t``, ``2*t`` or ``(1 - t^2)/(1 + t^2)``: read, never run.

They have numbers, the letter, ``+ - * / ^``, parentheses, and ``sin``, ``cos`` and ``tan`` of the
letter in degrees plus quarter turns. ``2t`` is ``2*t``, but not behind a ``/``, as in ``1/2t``.
Powers are whole numbers up to 20.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.errors import InputError

from .exact import rational, shown

_TOKEN = re.compile(
    r"\s*(?:((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]{1,4})?)|([A-Za-z_]+)|(\*\*|[-+*/^()]))"
)
_TURNS = ("sin", "cos", "tan")
_MAX_LENGTH, _MAX_DEPTH, _MAX_POWER, _MAX_BITS = 20_000, 40, 20, 4000


class Expression(NamedTuple):
    """An expression as a tree.

    Attributes:
        kind: "number", "letter", "+", "-", "*", "/", "^", or a function of an angle.
        parts: what it is about: a number, or expressions.
    """

    kind: str
    parts: tuple[Any, ...]

    @property
    def has_letter(self) -> bool:
        """Whether the letter occurs."""
        return self.kind == "letter" or any(
            part.has_letter for part in self.parts if isinstance(part, Expression)
        )

    @property
    def has_turn(self) -> bool:
        """Whether the letter occurs as an angle."""
        return self.kind in _TURNS or any(
            part.has_turn for part in self.parts if isinstance(part, Expression)
        )

    def value(self, letter: Any, turn: tuple[Any, Any] | None = None) -> Any:
        """Return its value.

        Args:
            letter: in place of the letter; a number, or anything with its operations.
            turn: cosine and sine of the letter, where it is an angle; it stands nowhere else then.

        Raises:
            ZeroDivisionError: a divisor is 0.
            InputError: an angle stands where a number is due.
        """
        if self.kind == "number":
            return self.parts[0]
        if self.kind == "letter":
            if turn is not None:
                raise InputError("the letter is an angle; expected sin, cos or tan of it here")
            return letter
        if self.kind in _TURNS:
            cosine, sine = self.parts[0].turned(turn)
            return {"cos": cosine, "sin": sine}[self.kind] if self.kind != "tan" else sine / cosine
        first, *rest = (
            part.value(letter, turn) if isinstance(part, Expression) else part
            for part in self.parts
        )
        return _OPERATIONS[self.kind](first, *rest)

    def turned(self, turn: tuple[Any, Any] | None) -> tuple[Any, Any]:
        """Return cosine and sine of an angle ``+-t`` plus quarter turns.

        Raises:
            InputError: it is another angle.
        """
        if turn is None:
            raise InputError("sin, cos and tan are for a question in which the letter is an angle")
        start, step, bend = (self.value(Fraction(x)) for x in (0, 1, 2))
        quarters, slope = start / 90, step - start
        if bend - step != slope or slope not in (1, -1) or quarters.denominator != 1:
            raise InputError("an angle is t or -t, plus or minus a multiple of 90 degrees")
        cosine, sine = turn[0], turn[1] * int(slope)
        for _ in range(int(quarters) % 4):
            cosine, sine = -sine, cosine
        return cosine, sine


_OPERATIONS: dict[str, Callable[..., Any]] = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: _quotient(x, y),
    "^": lambda x, power: _power(x, power),
}


def _quotient(x: Any, y: Any) -> Any:
    return Fraction(x) / y if isinstance(x, int) else x / y


def _power(x: Any, power: int) -> Any:
    result: Any = Fraction(1)
    for _ in range(power):
        result = _short(result * x)
    return result


def _short(x: Any) -> Any:
    """Return a number; refuse a very long one, which powers make of few characters."""
    if isinstance(x, Fraction) and max(map(int.bit_length, x.as_integer_ratio())) > _MAX_BITS:
        raise InputError(f"an expression has a number of more than {_MAX_BITS} bits; write another")
    return x


def read_expression(text: Any, letter: str, name: str = "number") -> Expression:
    """Read an expression in one letter; numbers are read as `rational` does.

    Raises:
        InputError: it is none; the message has the place.

    >>> read_expression("3/2 - 2t", "t").value(Fraction(1, 4))
    Fraction(1, 1)
    """
    if not isinstance(text, str):
        return Expression("number", (rational(text, name),))
    if len(text) > _MAX_LENGTH:
        raise InputError(f"{name} has {len(text)} characters; at most {_MAX_LENGTH} are read")
    return _Reader(text, letter, name).whole()


class _Reader:
    """Recursive descent, one token at a time."""

    def __init__(self, text: str, letter: str, name: str) -> None:
        self.text, self.letter, self.name = text, letter, name
        self.tokens: list[tuple[str, str]] = []
        place, end = 0, len(text.rstrip())
        while place < end:
            match = _TOKEN.match(text, place)
            if match is None:
                raise self._error(f"has {shown(text[place:end].strip()[:1])}")
            self.tokens.append(
                (("number", "word", "sign")[(match.lastindex or 1) - 1], match[0].strip())
            )
            place = match.end()
        self.depth = 0

    def _error(self, problem: str) -> InputError:
        return InputError(
            f"{self.name} is {shown(self.text)}, which {problem}; expected an expression in "
            f'{self.letter} such as "3/2 - 2*{self.letter}"'
        )

    def whole(self) -> Expression:
        """Return the expression of all tokens."""
        expression = self._sum()
        if self.tokens:
            raise self._error(f"has {shown(self.tokens[0][1])} where it could end")
        return expression

    def _next(self, *signs: str) -> str:
        """Return the next token and pass it, if it is one of some signs; else ""."""
        if self.tokens and self.tokens[0][0] == "sign" and self.tokens[0][1] in signs:
            return self.tokens.pop(0)[1]
        return ""

    def _sum(self) -> Expression:
        self.depth += 1
        if self.depth > _MAX_DEPTH:
            raise self._error("has too many parentheses inside one another")
        zero = Expression("number", (Fraction(0),))
        sign = self._next("+", "-")
        total = self._product()
        if sign == "-":
            total = Expression("-", (zero, total))
        while sign := self._next("+", "-"):
            total = Expression(sign, (total, self._product()))
        self.depth -= 1
        return total

    def _product(self) -> Expression:
        product, last = self._power(), ""
        while self.tokens:
            sign = self._next("*", "/")
            if not sign and not (self.tokens[0][0] == "word" or self.tokens[0][1] == "("):
                break
            if not sign and last == "/":
                raise self._error("has a product without * behind a /")
            product, last = Expression(sign or "*", (product, self._power())), sign
        return product

    def _power(self) -> Expression:
        base = self._atom()
        if self._next("^", "**"):
            kind, token = self.tokens.pop(0) if self.tokens else ("", "nothing")
            if kind != "number" or not token.isdigit() or int(token) > _MAX_POWER:
                raise self._error(
                    f"has the power {token}; one is a whole number up to {_MAX_POWER}"
                )
            return Expression("^", (base, int(token)))
        return base

    def _atom(self) -> Expression:
        if not self.tokens:
            raise self._error("ends too early")
        kind, token = self.tokens.pop(0)
        if kind == "number":
            return Expression("number", (_short(rational(token, self.name)),))
        if kind == "word" and token == self.letter:
            return Expression("letter", ())
        if token in _TURNS and self._next("("):
            angle = self._sum()
            if not self._next(")"):
                raise self._error("has no closing parenthesis")
            return Expression(token, (angle,))
        if token == "(":
            inner = self._sum()
            if not self._next(")"):
                raise self._error("has no closing parenthesis")
            return inner
        raise self._error(f"has {shown(token)}")
