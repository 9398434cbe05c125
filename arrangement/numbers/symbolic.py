"""The way to SymPy and back: matrices, equations of planes, points, and entries from outside.

SymPy is imported by the functions, not by the module: it takes half a second, and most commands
do without. Text is never handed to it, because it would run text as code.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import (
    IntegerVector,
    RationalVector,
    rational,
    rational_vector,
    shown,
)
from arrangement.numbers.real import Irrational, field_of

if TYPE_CHECKING:
    import sympy
    from sympy.polys.matrices import DomainMatrix


def exact_matrix(rows: Sequence[Sequence[int]], width: int) -> DomainMatrix:
    """Return integer rows as a matrix over ZZ, whichever ground types SymPy uses.

    Rows with irrational entries become a matrix over SymPy's domain of their field.
    """
    from sympy import QQ, ZZ
    from sympy.polys.matrices import DomainMatrix

    field = field_of(x for row in rows for x in row)
    if field is None:
        return DomainMatrix([[ZZ(x) for x in row] for row in rows], (len(rows), width), ZZ)
    domain = field.domain

    def entry(x: int | Irrational) -> Any:
        parts = x.rational_coefficients() if isinstance(x, Irrational) else [Fraction(x)]
        return domain([QQ(c.numerator, c.denominator) for c in reversed(parts)])

    return DomainMatrix([[entry(x) for x in row] for row in rows], (len(rows), width), domain)


def matrix_entries(rows: Sequence[Sequence[Any]], field: Any) -> list[list[Any]]:
    """Return rows of numbers of SymPy's domain, from an `exact_matrix` or computed from it."""
    if field is None:
        return [[int(x) for x in row] for row in rows]
    return [[field.of_domain(x) for x in row] for row in rows]


def to_sympy(values: Any) -> Any:
    """Convert exact numbers, vectors and lists of vectors to SymPy.

    Args:
        values: an integer or a `Fraction`; a vector of them; or a sequence of vectors, such as
            the vertices of a dual polyhedron or the rays of a great-circle arrangement.

    Returns:
        A SymPy number; an immutable column; or a tuple of columns.

    >>> to_sympy((Fraction(1, 2), 3))
    Matrix([
    [1/2],
    [  3]])
    """
    import sympy

    if isinstance(values, Iterable):
        entries = [to_sympy(value) for value in values]
        flat = all(isinstance(entry, sympy.Expr) for entry in entries)
        return sympy.ImmutableMatrix(len(entries), 1, entries) if flat else tuple(entries)
    if isinstance(values, Irrational):
        polynomial = values.field.minimal_polynomial
        root = (
            sympy.sqrt(-polynomial[0])
            if len(polynomial) == 3
            else sympy.CRootOf(sympy.Poly(polynomial[::-1], sympy.Symbol("x")), values.field.index)
        )
        parts = values.rational_coefficients()
        return sympy.Add(*(to_sympy(c) * root**k for k, c in enumerate(parts)))
    return sympy.Rational(int(values.numerator), int(values.denominator))


def planes_of(
    equations: Iterable[Any], symbols: Iterable[sympy.Symbol] | None
) -> tuple[list[RationalVector], list[Fraction], int]:
    """Return normals, offsets and dimension; see `Arrangement.from_equations`."""
    sides = [_left_side(equation, i) for i, equation in enumerate(equations)]
    if symbols is None:
        from sympy import default_sort_key

        variables = sorted(set().union(*(e.free_symbols for e in sides)), key=default_sort_key)
    else:
        variables = list(entries(symbols, "symbols", "symbols"))
        _check_symbols(variables)
    budget.check_size(len(variables), "coordinates")
    rows = [_coefficients(e, variables, f"equations[{i}]") for i, e in enumerate(sides)]
    return [row[:-1] for row in rows], [-row[-1] for row in rows], len(variables)


def equations_of(
    planes: Sequence[IntegerVector], dimension: int, symbols: Iterable[sympy.Symbol] | None
) -> tuple[sympy.Eq, ...]:
    """Return the equations of integer planes; see `Arrangement.equations`."""
    import sympy

    if symbols is None:
        digits = len(str(dimension))
        names = "xyz" if dimension <= 3 else [f"x{k + 1:0{digits}}" for k in range(dimension)]
        variables = [sympy.Symbol(name) for name in names[:dimension]]
    else:
        variables = list(entries(symbols, "symbols", "symbols"))
        _check_symbols(variables)
    if len(variables) != dimension:
        raise InputError(
            f"{len(variables)} symbols are given for {dimension} coordinates; give one for each"
        )
    return tuple(
        sympy.Eq(
            sympy.Add(*(to_sympy(n) * x for n, x in zip(normal, variables, strict=True))),
            to_sympy(offset),
            evaluate=False,
        )
        for *normal, offset in planes
    )


def _check_symbols(symbols: Sequence[Any]) -> None:
    from sympy import Symbol

    for i, symbol in enumerate(symbols):
        if not isinstance(symbol, Symbol):
            raise InputError(f"symbols[{i}] is {shown(symbol)}; give a SymPy Symbol")
        if symbol in symbols[:i]:
            raise InputError(f"symbols[{i}] is {symbol} again; name each coordinate once")


def _left_side(equation: Any, index: int) -> sympy.Expr:
    """Return the expression that is zero on the plane, left side minus right side."""
    import sympy

    if isinstance(equation, sympy.Equality):
        equation = equation.lhs - equation.rhs
    if isinstance(equation, sympy.Expr):
        return equation
    if isinstance(equation, str):
        rule = "text beside SymPy's equations; give all of them as text, or none"
    elif isinstance(equation, (bool, sympy.logic.boolalg.BooleanAtom)):
        rule = "true everywhere or nowhere, which defines no plane"
    else:
        rule = "not an equation; give Eq(left, right), or an expression that is zero on the plane"
    raise InputError(f"equations[{index}] is {shown(equation)}: {rule}")


def _coefficients(expression: sympy.Expr, symbols: Sequence[sympy.Symbol], name: str) -> Any:
    """Return the coefficients of the symbols and the constant, or name the term that has none."""
    import sympy

    column = {symbol: k for k, symbol in enumerate(symbols)}
    row = [sympy.Integer(0)] * (len(symbols) + 1)
    for term in sympy.Add.make_args(sympy.expand(expression)):
        factor, rest = term.as_independent(*symbols, as_Add=False)
        if rest != 1 and rest not in column:
            raise InputError(f"{name} has the term {shown(term)}, which is not linear in {symbols}")
        if not factor.is_algebraic or not factor.is_real or factor.has(sympy.Float):
            raise InputError(f"{name} has the term {shown(term)}: {_why_not_algebraic(factor)}")
        row[column.get(rest, -1)] += factor
    if not any(row[:-1]):
        raise InputError(f"{name} has none of the symbols {symbols}, so it defines no plane")
    return row


def _why_not_algebraic(factor: sympy.Expr) -> str:
    """Return the rule that a coefficient breaks, and the remedy."""
    import sympy

    if factor.has(sympy.Float):
        return "a float is not exact; write Rational(1, 10) for 0.1"
    if factor.free_symbols:
        names = ", ".join(sorted(map(str, factor.free_symbols)))
        return f"{names} is not one of the symbols; substitute numbers for parameters"
    return f"the coefficient {shown(factor)} is not a real algebraic number"


def entry(value: Any, name: str) -> Any:
    """Return a number as `exact.rational` does; one of a field, and SymPy's, as they are."""
    if isinstance(value, Irrational) or _is_irrational(value):
        return value
    return rational(value, name)


def real_vector(values: Any, name: str, field: Any = None) -> tuple[Any, ...]:
    """Return a vector of exact numbers; those of SymPy in `field` if there is one."""
    return in_one_field([rational_vector(values, name, entry)], field)[0]


def in_one_field(rows: Iterable[Sequence[Any]], field: Any = None) -> list[tuple[Any, ...]]:
    """Return rows of what `entry` gives, with SymPy's irrational numbers as those of one field.

    Args:
        field: one that has all numbers; if omitted, that of the other entries, or one that all of
            them generate.

    Raises:
        InputError: a number that is not real and algebraic; numbers of two different fields; a
            field of a degree above `fields.MAX_DEGREE`.
    """
    listed = list(map(tuple, rows))
    irrational = [x for row in listed for x in row if not isinstance(x, (int, Fraction))]
    if not irrational:
        return listed
    known = field_of(x for x in irrational if isinstance(x, Irrational)) or field
    of_sympy = [x for x in irrational if not isinstance(x, Irrational)]
    if not of_sympy:
        return listed
    from .fields import ValuesInField

    values = ValuesInField(known, of_sympy)
    return [tuple(values.of(x) if _is_irrational(x) else x for x in row) for row in listed]


def _is_irrational(value: Any) -> bool:
    """Return whether a value is a number of SymPy, but none of its rationals and floats."""
    if isinstance(value, (int, Fraction, str)) or not getattr(value, "is_number", False):
        return False
    return not getattr(value, "is_Rational", True) and not getattr(value, "is_Float", True)
