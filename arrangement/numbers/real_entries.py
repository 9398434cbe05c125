"""Entries of planes and points: rational numbers, and irrational ones of one real field.

SymPy's numbers are taken apart down to what SymPy alone knows, such as ``sqrt(5)`` or
``cos(2*pi/7)``; these get a field through their minimal polynomials, and the rest is arithmetic of
`number_field`. Nothing is evaluated in floats but to tell the roots of a polynomial apart, between
which rational numbers lie.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast

from arrangement.errors import InputError

from .exact import quotient, rational, rational_vector, shown
from .number_field import AlgebraicNumber, NumberField, Real, field_of
from .polynomials import MAX_DEGREE

if TYPE_CHECKING:
    import sympy

#: Digits to which SymPy's numbers are placed between rational ends.
_DIGITS = 60


def entry(value: Any, name: str) -> Any:
    """Return a number as `exact.rational` does; one of a field, and SymPy's, as they are."""
    if isinstance(value, AlgebraicNumber) or _is_irrational(value):
        return value
    return rational(value, name)


def real_vector(values: Any, name: str, field: NumberField | None = None) -> tuple[Any, ...]:
    """Return a vector of exact numbers; those of SymPy in `field` if there is one."""
    return in_one_field([rational_vector(values, name, entry)], field)[0]


def in_one_field(
    rows: Iterable[Sequence[Any]], field: NumberField | None = None
) -> list[tuple[Any, ...]]:
    """Return rows of what `entry` gives, with SymPy's irrational numbers as those of one field.

    Args:
        field: one that has all numbers; if omitted, that of the other entries, or one that all of
            them generate.

    Raises:
        InputError: a number that is not real and algebraic; numbers of two different fields; a
            field of a degree above `MAX_DEGREE`.
    """
    listed = list(map(tuple, rows))
    irrational = [x for row in listed for x in row if not isinstance(x, (int, Fraction))]
    known = field_of(x for x in irrational if isinstance(x, AlgebraicNumber)) or field
    of_sympy = [x for x in irrational if not isinstance(x, AlgebraicNumber)]
    if not of_sympy:
        return listed
    values = _Values(known, of_sympy)
    return [tuple(values.of(x) if _is_irrational(x) else x for x in row) for row in listed]


def _is_irrational(value: Any) -> bool:
    """Return whether a value is a number of SymPy, but none of its rationals and floats."""
    if isinstance(value, (int, Fraction, str)) or not getattr(value, "is_number", False):
        return False
    return not getattr(value, "is_Rational", True) and not getattr(value, "is_Float", True)


class _Values:
    """The values of SymPy's numbers in one field."""

    def __init__(self, field: NumberField | None, numbers: Sequence[sympy.Expr]) -> None:
        import sympy

        self._field = field
        self._known: dict[sympy.Expr, Real] = {}
        atoms = sorted(
            {atom for number in numbers for atom in _atoms(number)},
            key=lambda atom: (-_minimal_polynomial(atom).degree(), sympy.default_sort_key(atom)),
        )
        for i, atom in enumerate(atoms):
            found = self._root(atom)
            if found is not None:
                self._known[atom] = found
            elif field is None:
                self._enlarge(atoms[: i + 1])
            else:
                raise InputError(
                    f"{shown(atom)} is not in the field {field!r} of the other numbers; give all "
                    "of them as numbers of one field that has both, or as SymPy numbers"
                )

    def of(self, number: sympy.Expr) -> Real:
        """Return the value of a number, from those of its atoms."""
        found = self._known.get(number)
        if found is None:
            found = self._known[number] = self._computed(number)
        return found

    def _computed(self, number: Any) -> Real:
        found: Any
        if number.is_Rational:
            return Fraction(int(number.p), int(number.q))
        if number.is_Pow:
            base = self.of(number.base)
            if not base:
                raise InputError(f"{shown(number)} divides by zero")
            found = 1
            for _ in range(abs(int(number.exp))):
                found = found * base
            found = found if number.exp > 0 else quotient(1, found)
        else:
            found = 0 if number.is_Add else 1
            for part in number.args:
                found = found + self.of(part) if number.is_Add else found * self.of(part)
        return cast("Real", found)

    def _root(self, atom: sympy.Expr) -> Real | None:
        """Return an atom as a number of the present field, if it is one."""
        import sympy

        polynomial = _minimal_polynomial(atom)
        low, high = _isolated(atom, polynomial)
        if self._field is None:
            self._field = NumberField(_coefficients(polynomial), (low, high))
            return self._field.root
        if self._field.degree % polynomial.degree():
            return None
        domain = self._field.domain
        factors = sympy.Poly(polynomial, domain=domain).factor_list()[1]
        for factor, _ in factors:
            if factor.degree() == 1:
                top, rest = factor.rep.to_list()
                root = self._field.of_domain(-rest / top)
                if low < root < high:
                    return root
        return None

    def _enlarge(self, atoms: Sequence[sympy.Expr]) -> None:
        """Take a field that is generated by a sum of multiples of all these atoms."""
        assert self._field is not None
        largest = self._field.degree * _minimal_polynomial(atoms[-1]).degree()
        for multiple in range(1, largest * largest):
            total = sum(multiple**i * atom for i, atom in enumerate(atoms))
            self._field = None
            self._root(total)
            found = {atom: self._root(atom) for atom in atoms}
            if None not in found.values():
                self._known.update(found)
                return
        raise AssertionError("some sum of multiples generates the field")


def _atoms(number: sympy.Expr) -> Iterable[sympy.Expr]:
    """Yield what sums, products and integer powers make a number of."""
    if number.is_Add or number.is_Mul or (number.is_Pow and number.exp.is_Integer):
        for part in number.args if not number.is_Pow else number.args[:1]:
            yield from _atoms(part)
    elif not number.is_Rational:
        yield number


def _minimal_polynomial(number: Any) -> sympy.Poly:
    """Return the minimal polynomial over Q of a real algebraic number."""
    import sympy
    from sympy.polys.polyerrors import NotAlgebraic

    if number.has(sympy.Float):
        raise InputError(
            f"{shown(number)} has a float, which is not exact; write Rational(1, 10) for 0.1"
        )
    try:
        found = sympy.minimal_polynomial(number, sympy.Symbol("x"), polys=True)
    except (NotAlgebraic, NotImplementedError):
        raise InputError(
            f"{shown(number)} is not known to be algebraic; give numbers such as sqrt(5), "
            "cos(2*pi/7) or CRootOf"
        ) from None
    if found.degree() > MAX_DEGREE:
        raise InputError(
            f"the entries generate a field of degree {found.degree()} or more, with "
            f"{shown(number)}; at most {MAX_DEGREE} is possible"
        )
    if number.is_real is False or not found.count_roots():
        raise InputError(f"{shown(number)} is not real; give real algebraic numbers")
    return found


def _isolated(number: Any, polynomial: sympy.Poly) -> tuple[Fraction, Fraction]:
    """Return rational ends between which the number is the only root of its polynomial."""
    import sympy

    value = sympy.Rational(number.evalf(_DIGITS))
    if not value.is_real:
        raise InputError(f"{shown(number)} is not real; give real algebraic numbers")
    for power in (8, 16, 32, 64):
        width = sympy.Rational(1, 2**power)
        if polynomial.count_roots(value - width, value + width) == 1:
            low, high = value - width, value + width
            return Fraction(int(low.p), int(low.q)), Fraction(int(high.p), int(high.q))
    raise InputError(f"{shown(number)} is too near to its conjugates; give a field with a root")


def _coefficients(polynomial: sympy.Poly) -> list[Fraction]:
    return [Fraction(int(c.p), int(c.q)) for c in reversed(polynomial.all_coeffs())]
