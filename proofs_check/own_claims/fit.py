"""What a sequence of values is: polynomials and quasi-polynomials, fitted and then checked.

A fit takes the first values that its coefficients need, and is returned only when it meets every
other value, two at least. That is evidence and no proof.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

from arrangement.console.progress import watched
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError
from proofs_check.instances.families import Member, read_family
from proofs_check.statements.evidence import check
from proofs_check.statements.statement import Claim

from .language import read
from .one_line import value_of

#: The largest period that is tried, and the fewest values that a fit must meet without having used.
MOST_PERIOD, LEAST_CHECKED = 6, 2
Number = int | Fraction


@dataclass(frozen=True)
class Fit:
    """A polynomial for each class of the parameter modulo a period.

    Attributes:
        degree: the largest of theirs.
        parts: for each class, the polynomial as Python writes it.
        fitted, checked: for which values of the parameter it was made, and which others it meets.
    """

    period: int
    degree: int
    parts: Mapping[int, str]
    fitted: tuple[int, ...]
    checked: tuple[int, ...]

    def text(self, name: str) -> str:
        """Return it in one line, for a parameter of a name."""
        if self.period == 1:
            return self.parts[0]
        parts = self.parts.items()
        return ", ".join(f"{part} if {name} % {self.period} == {k}" for k, part in parts)


@dataclass(frozen=True)
class FamilyValues:
    """The values of a quantity for the values of the parameter `name` of a family."""

    quantity: str
    family: str
    name: str
    found: Mapping[int, Number]


def values_of_text(text: str, of: str) -> FamilyValues:
    """Return the values of a quantity in the language of one line on the members of a family.

    Raises:
        OwnClaimError: it has no number for a member, or not exactly one parameter varies.
    """
    family = read_family(of)
    node = read(text, family.integers)
    if family.variable is None:
        raise OwnClaimError(f"{family} {_ONE}")
    members = (case.subject for case in watched(family.cases(), "members", len(family)))
    values = ((m.parameters, value_of(node, m.planes, m.parameters)) for m in members)
    return _values(text, str(family), values)


def values_of_claim(claim: Claim) -> FamilyValues:
    """Return the values, on which all routes agree, of a claim about members of a family.

    Raises:
        OwnClaimError: the claim is about something else, its routes disagree, or as before.
    """

    def values() -> Iterable[tuple[Mapping[str, Any], Any]]:
        for case in watched(claim.cases(Random(0)), "members"):
            if not isinstance(case.subject, Member):
                raise OwnClaimError(f"{claim.id} is about {claim.over}; what is fitted {_ONE}")
            if claim.includes(case.subject):
                record = check(claim, case)
                if not record.agree:
                    raise OwnClaimError(f"{claim.id} on {case.label}: {record.note}")
                yield case.subject.parameters, record.values[0]

    return _values(claim.id, claim.over, values())


_ONE = "needs one parameter that varies over integers, such as generic(m=2..9)"


def _values(
    quantity: str, over: str, rows: Iterable[tuple[Mapping[str, Any], Any]]
) -> FamilyValues:
    values: dict[int, Number] = {}
    pairs = list(rows)
    keys = pairs[0][0] if pairs else ()
    varying = [key for key in keys if len({str(parameters[key]) for parameters, _ in pairs}) > 1]
    if len(varying) != 1 or any(type(parameters[varying[0]]) is not int for parameters, _ in pairs):
        raise OwnClaimError(f"{quantity} on {over} {_ONE}")
    (name,) = varying
    for parameters, value in pairs:
        if isinstance(value, bool) or not isinstance(value, Number):
            raise OwnClaimError(
                f"{quantity} is {shown(value)} for {name} = {parameters[name]}, which is not a "
                "number; name a count, such as regions or f_vector[1]"
            )
        values[parameters[name]] = value
    return FamilyValues(quantity, over, name, dict(sorted(values.items())))


def fit(values: Mapping[int, Number], name: str = "n") -> Fit | None:
    """Return the polynomial or quasi-polynomial with the fewest coefficients that values meet.

    For each period up to `MOST_PERIOD` and each class of arguments, the polynomial through all
    values is that through the first d + 1 exactly when its Newton coefficients after those are 0.

    Returns:
        None if every one that meets all values needs so much data that fewer than
        `LEAST_CHECKED`, or none of some class, are left to check it.

    >>> fit({n: n * (n - 1) // 2 + 1 for n in range(2, 9)}).text("n")
    'n**2/2 - n/2 + 1'
    >>> fit({n: n * n // 4 for n in range(1, 9)}).text("n")
    'n**2/4 if n % 2 == 0, n**2/4 - 1/4 if n % 2 == 1'
    >>> fit({n: 2**n for n in range(1, 9)})
    """
    best: Fit | None = None
    for period in range(1, MOST_PERIOD + 1):
        classes = {k: [n for n in values if n % period == k] for k in range(period)}
        if not all(classes.values()):
            break
        newton = {k: _newton([(n, values[n]) for n in ns]) for k, ns in classes.items()}
        degree = max(len(coefficients) - 1 for coefficients in newton.values())
        used = sorted(n for ns in classes.values() for n in ns[: degree + 1])
        checked = tuple(sorted({*values} - {*used}))
        if len(checked) < LEAST_CHECKED or any(len(ns) < degree + 2 for ns in classes.values()):
            continue
        if best is None or len(used) < len(best.fitted):
            parts = {k: _polynomial_text(newton[k], ns, name) for k, ns in classes.items()}
            best = Fit(period, degree, parts, tuple(used), checked)
    return best


def _newton(points: list[tuple[int, Number]]) -> list[Fraction]:
    """Return the coefficients of 1, (x - x_0), (x - x_0)(x - x_1), ..., without zeros at the end.

    One at least, and as many as points unless fewer are enough.
    """
    row = [Fraction(value) for _, value in points]
    coefficients = [row[0]]
    for step in range(1, len(points)):
        row = [
            (b - a) / (points[k + step][0] - points[k][0]) for k, (a, b) in enumerate(pairwise(row))
        ]
        coefficients.append(row[0])
    while len(coefficients) > 1 and not coefficients[-1]:
        coefficients.pop()
    return coefficients


def _polynomial_text(newton: list[Fraction], places: list[int], name: str) -> str:
    """Return a polynomial as SymPy writes it, expanded, or in factors where that is shorter."""
    import sympy

    x = sympy.Symbol(name)
    whole: Any = sympy.Integer(0)
    for coefficient, place in reversed([*zip(newton, places, strict=False)]):
        whole = whole * (x - place) + sympy.Rational(*coefficient.as_integer_ratio())
    forms = (str(sympy.expand(whole)), str(sympy.factor(whole)))
    return min(forms, key=len)
