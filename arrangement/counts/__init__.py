"""Counting theory: flats, Moebius function, characteristic polynomial, faces by Zaslavsky.

Independent of every enumerator by construction: this package works by spans of normals and
imports nothing but errors, exact numbers and planes. So its counts can certify an enumeration.
"""

from .classes.symmetric import first_whitney_numbers
from .lattice import (
    Flat,
    IntersectionLattice,
    exponents,
    intersection_lattice,
    modular_chain,
    moebius,
    t_vector,
)
from .operations import (
    addition,
    cone,
    deletion,
    essentialization,
    irreducible_factors,
    localization,
    restriction,
    union,
)
from .oriented_matroid import (
    bases,
    chirotope,
    chirotope_string,
    circuits,
    cocircuits,
    covectors,
    dual_chirotope,
    topes,
)
from .points import by_points, points_off
from .whitney import (
    WhitneyNumbers,
    bounded_region_count,
    characteristic_polynomial,
    doubly_indexed_whitney_numbers,
    f_vector,
    fukuda_bound,
    region_count,
    whitney_numbers,
)

__all__ = [
    "Flat",
    "IntersectionLattice",
    "WhitneyNumbers",
    "addition",
    "bases",
    "bounded_region_count",
    "by_points",
    "characteristic_polynomial",
    "chirotope",
    "chirotope_string",
    "circuits",
    "cocircuits",
    "cone",
    "covectors",
    "deletion",
    "doubly_indexed_whitney_numbers",
    "dual_chirotope",
    "essentialization",
    "exponents",
    "f_vector",
    "first_whitney_numbers",
    "fukuda_bound",
    "intersection_lattice",
    "irreducible_factors",
    "localization",
    "modular_chain",
    "moebius",
    "points_off",
    "region_count",
    "restriction",
    "t_vector",
    "topes",
    "union",
    "whitney_numbers",
]
