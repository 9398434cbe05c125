"""Counting theory: flats, Moebius function, characteristic polynomial, faces by Zaslavsky.

Independent of every enumerator by construction: this package works by spans of normals and
imports nothing but errors, exact numbers and planes. So its counts can certify an enumeration.
"""

from .lattice import (
    Flat as Flat,
    IntersectionLattice as IntersectionLattice,
    intersection_lattice as intersection_lattice,
    modular_chain as modular_chain,
    moebius as moebius,
    supersolvable_exponents as supersolvable_exponents,
    t_vector as t_vector,
)
from .operations import (
    addition as addition,
    cone as cone,
    deletion as deletion,
    essentialization as essentialization,
    irreducible_factors as irreducible_factors,
    localization as localization,
    restriction as restriction,
    union as union,
)
from .oriented_matroid import (
    bases as bases,
    chirotope as chirotope,
    chirotope_string as chirotope_string,
    circuits as circuits,
    cocircuits as cocircuits,
    covectors as covectors,
    dual_chirotope as dual_chirotope,
    topes as topes,
)
from .points import (
    QuasiPolynomial as QuasiPolynomial,
    by_points as by_points,
    characteristic_quasi_polynomial as characteristic_quasi_polynomial,
    points_off as points_off,
)
from .tutte import nbc_sets as nbc_sets, tutte_polynomial as tutte_polynomial
from .whitney import (
    WhitneyNumbers as WhitneyNumbers,
    bounded_region_count as bounded_region_count,
    characteristic_polynomial as characteristic_polynomial,
    doubly_indexed_whitney_numbers as doubly_indexed_whitney_numbers,
    f_vector as f_vector,
    first_whitney_numbers as first_whitney_numbers,
    fukuda_bound as fukuda_bound,
    level_vector as level_vector,
    region_count as region_count,
    whitney_numbers as whitney_numbers,
)
