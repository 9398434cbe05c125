"""Counting theory: flats, Moebius function, characteristic polynomial, faces by Zaslavsky.

Independent of every enumerator by construction: this package works by spans of normals and
imports nothing but errors, exact numbers and planes. So its counts can certify an enumeration.
"""

from .lattice import Flat, IntersectionLattice, intersection_lattice, moebius
from .operations import cone, deletion, essentialization, localization, restriction
from .oriented_matroid import chirotope, cocircuits, covectors, topes
from .points import by_points, points_off
from .symmetric import first_whitney_numbers
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
    "bounded_region_count",
    "by_points",
    "characteristic_polynomial",
    "chirotope",
    "cocircuits",
    "cone",
    "covectors",
    "deletion",
    "doubly_indexed_whitney_numbers",
    "essentialization",
    "f_vector",
    "first_whitney_numbers",
    "fukuda_bound",
    "intersection_lattice",
    "localization",
    "moebius",
    "points_off",
    "region_count",
    "restriction",
    "topes",
    "whitney_numbers",
]
