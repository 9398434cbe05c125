"""Fields of real numbers, for irrational entries: the public names."""

from .algebraic_number import AlgebraicNumber as AlgebraicNumber, Real as Real
from .number_field import NumberField as NumberField
from .polynomials import MAX_DEGREE as MAX_DEGREE
from .sympy_numbers import ValuesInField as ValuesInField
