"""Plants small faults in the code, one at a time, and lists those that no test notices.

    python tests/mutants.py                   all targets
    python tests/mutants.py checker law       some of them
    python tests/mutants.py --seed 5          another sample of the targets that are sampled
    python tests/mutants.py --jobs 1          one target at a time
    python tests/mutants.py law --first 20    from the 20th fault on

A fault changes one comparison, constant, sign, "and" or "or" of the syntax tree, drops a condition
or an entry, or takes one function or end of an interval for its opposite. The tests of its target
run in a process of their own, to the first that fails, or takes more than `LIMIT`: it has noticed
the fault. First the code of functions is exchanged after all is imported, and tests that noticed
faults nearby run first; what survives, or is no code of a function, is there from the import on.
Exit 1 if faults survive that are not among `EQUIVALENT`, or one of those is noticed or is no fault.
"""

from __future__ import annotations

import argparse
import ast
import copy
import gc
import importlib
import importlib.abc
import importlib.util
import os
import resource
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import chain
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.sharedctypes import RawArray
from pathlib import Path
from random import Random
from types import CodeType, FunctionType
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
#: Seconds of processor time after which a test has noticed a fault. No test takes half of it.
LIMIT = 10
#: Bytes that they may take: without its limit on depth the checker would follow any document.
MEMORY = 4 * 2**30


class Target(NamedTuple):
    """A module, the tests that cover it, fast ones first, and how many faults to plant (0: all)."""

    module: str
    tests: tuple[str, ...]
    sample: int = 0

    @property
    def path(self) -> Path:
        """The file of the module."""
        return ROOT / Path(*self.module.split(".")).with_suffix(".py")


CHECKER = ("tests/equilibrium/test_checker.py",)
PLANES = "tests/equilibrium/test_space.py::TestPlanes"
PYRAMIDS = "tests/equilibrium/test_space.py::TestPyramids"
SOLVER = ("tests/equilibrium/test_verdict.py",)
SEARCH = ("tests/equilibrium/test_leaves.py", "tests/equilibrium/test_resistance.py")
SPACE = ("tests/equilibrium/test_space_checker.py", "tests/equilibrium/test_space.py")
MODULAR = ("tests/arrangement/test_counts_symmetric.py", "tests/arrangement/test_number_field.py")
CIRCLES = (
    "tests/arrangement/test_great_circles_exactness.py",
    "tests/arrangement/test_number_field.py",
)
ENCLOSURES = SPACE[0], "tests/equilibrium/test_space.py::TestChecker"
LOADS = tuple(
    f"tests/equilibrium/test_space.py::Test{name}" for name in ("KnownLoads", "Brackets", "Borders")
)
ROBUST = (
    "tests/equilibrium/test_robust_arithmetic.py",
    "tests/equilibrium/test_robust_checker.py",
)
FINAL = tuple(
    f"tests/arrangement/test_identify.py::test_{name}"
    for name in (
        "pappus_has_coordinates_and_non_pappus_a_proof_that_it_has_none",
        "a_changed_proof_is_refused",
        "forged_proofs_are_refused_though_their_products_cancel",
        "no_type_with_coordinates_has_a_proof_that_it_has_none",
        "three_comparisons_of_signs_that_are_none_of_vectors_prove_it",
        "comparisons_are_those_that_signs_of_vectors_force",
    )
)
TARGETS = {
    "checker": Target("equilibrium.certificate.checker", (*CHECKER, PLANES, PYRAMIDS)),
    "law": Target("equilibrium.certificate.law", (*CHECKER, SPACE[0])),
    "reading": Target("equilibrium.certificate.reading", CHECKER),
    "space": Target("equilibrium.certificate.space", SPACE),
    "enclosure": Target("equilibrium.certificate.enclosure", ENCLOSURES),
    "robust": Target("equilibrium.certificate.robust", ROBUST),
    "plane": Target("equilibrium.model.plane", (PLANES,)),
    "loads": Target("equilibrium.wrench_sets.spatial", LOADS),
    "final": Target("arrangement.library.census.final_polynomials", FINAL),
    "proofs": Target("arrangement.library.census.workshop.proofs", FINAL),
    "modular": Target("arrangement.counts.modular", MODULAR),
    "lowrank": Target("arrangement.counts.low_rank", ("tests/arrangement/test_counts.py",)),
    "field": Target(
        "arrangement.numbers.number_field", ("tests/arrangement/test_number_field.py",)
    ),
    "circles": Target("arrangement.enumeration.great_circles.predicates", CIRCLES),
    "crossings": Target("arrangement.enumeration.great_circles.crossings", CIRCLES),
    "predicates": Target(
        "arrangement.enumeration.affine_space.predicates",
        ("tests/arrangement/test_affine_space.py",),
        24,
    ),
    "states": Target("equilibrium.plane.states.state_system", SOLVER, 12),
    "elimination": Target("arrangement.numbers.linear.rank", SOLVER, 12),
    "pieces": Target("equilibrium.plane.states.equilibrium", SOLVER, 12),
    "leaves": Target("equilibrium.plane.search.virtual_motions", SEARCH, 12),
    "guess": Target("equilibrium.plane.search.state_equilibrium", SEARCH, 12),
    "splits": Target("equilibrium.plane.search.state_splits", SEARCH, 12),
    "program": Target("equilibrium.plane.search.part_program", SEARCH, 12),
    "part": Target("equilibrium.plane.search.part_guess", SEARCH, 12),
    "oracle": Target("proofs_check.routes.oracle", ("tests/proofs_check/test_oracle.py",), 12),
}

#: Faults that change no answer: for each target lines of code, and below each line its faults and
#: the reason, with " | " between. "(2)" is the second fault of this kind in the line.
EQUIVALENT = """
[checker]
MAX_DEPTH = 300
    300 -> 301 | 300 -> 299 | a limit that was chosen; the tests follow it
if given is None and (state == "detached" or (state is None and max(e) <= 0)):
    LtE -> Lt | 0 -> -1 | where max(e) is 0, kappa max(0, e) is 0 as well
    dropped: state is None and max(e) <= 0 | where max(e) <= 0, kappa max(0, e) is 0 as well
elif kappa < 0:
    Lt -> LtE | 0 -> 1 | kappa is an integer, and kappa = 0 adds 0
contact, due = split.at[0], "attached" if split.kind == "slip" else "undecided"
    0 -> -1 | the tuple has one entry
corners = product(region[1:3], region[3:5], region[5:7])
    7 -> 8 | the half space has seven generators
[leaves]
spring = product(generators.reshape(-1, 4), contacts.spring.T).reshape(count, 4, m)
    1 -> 2 | numpy takes any negative length as the one to work out
slip = product(generators[:, :, 1:].reshape(-1, 3), contacts.tangent.T).reshape(count, 4, m)
    1 -> 2 | numpy takes any negative length as the one to work out
[guess]
if not size[best] > 1e-9 * np.linalg.norm(tangents[best]) * (spare[best] + 1e-9):
    Add -> Sub | a threshold in floating point that was chosen; the rank is then found exactly
spare = 1.0 - np.abs(np.array(guess.shares)[sticking]) / (_SHARES + 1)
    1 -> 2 | a share in floating point that orders contacts; any order is then solved exactly
_COARSE = 16
    16 -> 17 | 16 -> 15 | how finely guessed motions are rounded was chosen
point = [0] * size
    0 -> 1 | 0 -> -1 | every entry is set below before it is read
[space]
if isinstance(state, tuple) and not isinstance(state, SlipFace):
    dropped: not isinstance(state, SlipFace) | faces are states of pyramids, which return before
if square < 0:
    Lt -> LtE | where the square is 0 both bounds ask for room >= 0
contact, ends = split.at[0], list(split.directions)
    0 -> -1 | the tuple has one entry
if isinstance(state, tuple) and not (turn(state[0], b) >= 0 and turn(b, state[1]) >= 0):
    GtE -> Gt | GtE -> Gt (2) | along an end the product with its unit vector is the length
return "" if room >= 0 or room * room * size <= friction**2 * -square else _LARGE
    GtE -> Gt | 0 -> 1 | rooms of 0 obey the second bound; in (0, 1) there is no integer
[plane]
height = heights.pop() if heights else Fraction(0)
    0 -> 1 | 0 -> -1 | a grasp without contacts is one in the plane
[loads]
_NODES = 400
    400 -> 401 | 400 -> 399 | how large a tree may be was chosen
if t == high and start is not None and high - start > near:
    Gt -> GtE | how near an edge is enough was chosen
    dropped: start is not None | the tree ends before the end that is resisted
if t == low and end is not None and end - low > near:
    Gt -> GtE | how near an edge is enough was chosen
    dropped: end is not None | the tree ends before the end that is resisted
if slope > 0:
    Gt -> GtE | the slope is not 0 here
unit = max((c.preload for c in grasp), default=Fraction(0)) or Fraction(1)
    0 -> 1 | 0 -> -1 | a grasp without contacts is one in the plane
return tuple((a, b) for a, b in pairs if a.resisted < a.refused and b.refused < b.resisted)
    And -> Or | dropped: a.resisted < a.refused | yes and no alternate from border to border
    dropped: b.refused < b.resisted | yes and no alternate from border to border
    Lt -> LtE | Lt -> LtE (2) | the two ends of a border have different verdicts
if undecided and end - start <= max(enough, (high - low) / _SHARP):
    dropped: undecided | without them the part is the whole
[enclosure]
if square.low <= 0:
    0 -> 1 | slips below 2^-96 are refused too: fewer enclosures hold
Interval(interval(m - r).low, interval(m + r).high)
    low -> high | high -> low | any box serves into which the map takes it
0 if self.low < 0 < self.high else low * low >> _BITS, -(-high * high >> _BITS)
    Lt -> LtE | Lt -> LtE (2) | 0 -> 1 (2) | 0 -> -1 (2) | squares of 0, 1 and -1 are 0 rounded down
return Interval(_ONE * _ONE // (math.isqrt(high) + 1), _ONE * _ONE // math.isqrt(low) + 1)
    1 -> 2 | 1 -> 2 (2) | the interval is wider by a unit
[proofs]
right[-1] = 1
    1 -> 2 | weights are found up to a factor
used = np.flatnonzero(np.abs(found.x) > _TINY)
    Gt -> GtE | a bound in floating point that was chosen; weights are then found exactly
elif third == 0 and smaller < larger:
    Lt -> LtE | the two differ
[final]
swaps = sum(x > y for x, y in itertools.combinations(bracket, 2))
    Gt -> GtE | the three are distinct
    Gt -> Lt | each product has two brackets, and the sign of both changes
[modular]
_INT64_BITS, _DOUBLE_BITS = 63, 53
    53 -> 52 | integers are taken where doubles would do
bound: int = isqrt(prod(squares[: self.rank])) + 1
    1 -> 2 | a larger bound
squares = sorted((sum(_size(x) ** 2 for x in row) for row in self._vectors), reverse=True)
    2 -> 3 | a larger bound
for coordinate in images[1:]:
    1 -> 0 | where the first coordinate is 0, it is put in its own place
if len(values) < 32:
    Lt -> LtE | 32 -> 33 | 32 -> 31 | where the recursion ends was chosen
prime = nextprime(self.hadamard_bound) if self.hadamard_bound < largest else largest
    Lt -> LtE | what lies beyond the largest is not taken
while prime < largest and not self._has_image(prime):
    Lt -> LtE | dropped: prime < largest | what is not below the largest is not taken
while prod(primes) <= self.hadamard_bound:
    LtE -> Lt | the bound is above every minor
radix = 1
    1 -> 2 | labels are ranked sooner by a bit
size = prime if place else 2
    2 -> 3 | labels are ranked sooner
if radix * size >= 1 << (_INT64_BITS - self.index_bits):
    GtE -> Gt | labels are below the radix
    1 -> 0 | labels are ranked sooner
labels = labels * size + coordinate
    Add -> Sub | as different for different coordinates
columns = forms.transpose(2, 0, 1).reshape(-1, rank)
    1 -> 2 | numpy takes any negative length as the one to work out
return _modulo(images, prime).reshape(-1, count, self.count)
    1 -> 2 | numpy takes any negative length as the one to work out
if rank * prime**2 < 1 << _DOUBLE_BITS:  # then sums of doubles are exact
    Lt -> LtE | no multiple of an odd square is a power of two
    1 -> 0 | 2 -> 3 | integers are taken where doubles would do
values = _modulo((vectors[base][:, None, :] @ forms)[:, 0, :], prime)
    0 -> -1 | this axis has length 1
[circles]
VERTICAL = 2.0**1000
    1000 -> 999 | any number beyond all slopes will do
exact_in_int64 = factor * largest(rows) ** degree_bound < 2**63
    Lt -> LtE | no multiple of 3 is a power of two
array[...] = np.array(rows, dtype=array.dtype).reshape(-1, 3)
    1 -> 2 | numpy takes any negative length as the one to work out
if len(undecided[0]):
    0 -> -1 | there are as many indices of each axis
backward: Booleans = denominators < 0  # it is the first coordinate that is not 0
    Lt -> LtE | 0 -> 1 | they are integers, and where they are 0 this is set below
backward.ravel()[vertical] = numerators.take(vertical) * upper < 0
    Lt -> LtE | 0 -> 1 | integers, 0 for a circle with itself alone, whose turn is not read
self._absolute[...], self._least[...] = 1, 0
    1 -> 2 | any size above 0 leaves all to exact numbers
    0 -> 1 | 0 -> -1 | sizes are 2 or more, so all is left to exact numbers
slopes = np.nan_to_num(super().slopes(block)[0], posinf=VERTICAL, neginf=-VERTICAL)
    minus dropped | what is only a proposal may be wrong
minor(self._absolute, (here, there), 1),
    1 -> 2 | larger sizes leave more to exact numbers
    1 -> 0 | near 0 the products are alike, and minors take 4 of the 8 roundings
_determinants([self._absolute[at] for at in circles], sign=1),
    1 -> 2 | larger sizes leave more to exact numbers
lambda at: minor(self.normals, (here[at[0], 0], at[1]), -1),
    0 -> -1 | this axis has length 1
return slopes, turns((component(0), component(1), component(2))) < 0
    Lt -> LtE | 0 -> 1 | a turn is 0 for a circle with itself alone, and is not read
[lowrank]
MAX_RANK = 4
    4 -> 3 | the lattice then counts rank 4, more slowly
_CHUNK = 1 << 19
    1 -> 2 | 1 -> 0 | 19 -> 20 | 19 -> 18 | how many entries are taken at once was chosen
_INT64_MAX = 2**63 - 1
    1 -> 2 | bounds are even
step = max(1, _CHUNK // max(1, columns))
    1 -> 2 | FloorDiv -> Mult | max -> min (2) | how many entries are taken at once was chosen
    1 -> 2 (2) | 1 -> 0 (2) | there are two columns or more
_ask(f"the flats of rank 2 of {m:,} planes", config, m * m / 2, 130 * m * m)
    130 -> 131 | 130 -> 129 | how many bytes a pair takes was estimated
return [columns[order[:, k]] * a[:, :1] - at_pivot * a[:, k, None] for k in range(1, rank)]
    1 -> 0 | one more coordinate, which is 0
alternating = sum((-1) ** (rank - 1 - j) * value for j, value in enumerate(row))
    Sub -> Add | Sub -> Add (2) | as even or odd
if parts[0].dtype == object:
    0 -> 1 | 0 -> -1 | all are of one type
    Eq -> NotEq | either way keys are equal exactly for proportional coordinates
return np.array(rows, dtype=np.int64 if bound <= _INT64_MAX else object)
    LtE -> Lt | bounds are even
return _keep(_flats_only(_concatenate(groups), m), lambda g: g.first > g.row)
    Gt -> GtE | a plane is in no group of its own row
counted = group.first > lines.first[group.row]
    Gt -> GtE | a plane of the line is in no group beside it
[field]
_BITS = 128
    128 -> 129 | 128 -> 127 | how many bits are tried first was chosen; `_SMALLEST` follows
_LARGEST = 2**200
    Pow -> Mult | 2 -> 3 | 2 -> 1 | 200 -> 201 | 200 -> 199 | beyond floats integers are taken
_SMALLEST = 2.0 ** (64 - _BITS)
    64 -> 65 | 64 -> 63 | any bits well beyond 53 will do
self._rising = value_at(integers, self._high) > 0
    Gt -> GtE | an irreducible polynomial is not 0 at a rational number
if high <= start or (low < start and value_at(monic, high) < 0):
    dropped: high <= start | LtE -> Lt | up to there it is below 0, beyond the smaller root
    dropped: low < start | Lt -> LtE | above the smaller root it is below 0 for no larger one
    Lt -> LtE (2) | an irreducible polynomial is not 0 at a rational number
self._low, self._high = Fraction(0), Fraction(1 - integers[0])
    0 -> 1 | 0 -> -1 | 1 -> 2 | 1 -> 0 | square roots of d >= 2 are between 1 and d, the others < -1
if self.degree == 2:
    2 -> 1 | the count of roots is right for degree 2 as well
bits *= 2
    2 -> 3 | more bits are taken where needed
j, bits = j + 1, bits + 1
    1 -> 2 (2) | 1 -> 0 (2) | Add -> Sub (2) | more bits are taken where needed
if (value_at(self.minimal_polynomial, middle) > 0) == self._rising:
    Gt -> GtE | an irreducible polynomial is not 0 at a rational number
if type(other) is int and not other:
    Is -> IsNot | the difference from any 0 has the same sign
    dropped: type(other) is int | the difference from any 0 has the same sign
return self.sign() < 0
    Lt -> LtE | 0 -> 1 | a sign is 1 or -1
return difference.sign() < 0
    Lt -> LtE | 0 -> 1 | a sign is 1 or -1
return self if self.sign() > 0 else -self
    Gt -> GtE | 0 -> -1 | a sign is 1 or -1
if p == q == 1:
    1 -> 0 | the sum of fractions serves for integers as well
def interval(self, bits: int = 10) -> tuple[Fraction, Fraction]:
    10 -> 11 | 10 -> 9 | how short an interval is if nothing is asked was chosen
while (self._high - self._low) * (1 << bits) > 1:
    1 -> 2 (2) | the interval is half as long
    Gt -> GtE | the interval is half as long at most
while len(rows) < self.degree - 1:
    Lt -> LtE | 1 -> 0 | Sub -> Add | one more power, which no product has
found = [0] * (2 * n - 1)
    Sub -> Add | more 0
    2 -> 3 | more 0
    1 -> 0 | one more 0
if divisor != 1:
    1 -> 0 | what is divided by 1 stays
if len(coefficients) == 2:
    2 -> 1 | the equations serve for degree 2 as well
return 1, math.isqrt(-lower[0]) + 1
    1 -> 2 | 1 -> 2 (2) | a larger bound
j, bits = 0, 64
    64 -> 65 | 64 -> 63 | more bits are taken where needed
_MORE_BITS = 64
    64 -> 65 | 64 -> 63 | any number of spare bits will do
more = bits + 4 + n.bit_length() + n * self._largest[1].bit_length()
    4 -> 5 | 4 -> 3 | Add -> Sub (2) | Add -> Sub (3) | the bound of roots has bits to spare
total, _ = self.enclosed(coefficients, 0)
    0 -> 1 | one bit more
return 1 if total > 0 else -1
    Gt -> GtE | 0 -> 1 | 0 -> -1 | the total is above its error, which is 2 or more
return 1 if value > 0 else -1
    Gt -> GtE | the value is above its error
error, k = 2 * sum(map(abs, coefficients)), _BITS
    Mult -> Add | 2 -> 3 | 2 -> 1 | powers are within 1, so the sum of sizes would do
if abs(total) >> bits > error:
    Gt -> GtE | the error has a factor of 2 to spare
k *= 2
    2 -> 3 | more bits are taken where needed
if abs(value) > (len(products) + 6) * _UNIT * sum(map(abs, products)):
    6 -> 7 | 6 -> 5 | four units of the error are spare
    Mult -> Add | Mult -> Add (2) | integers decide then
return self.made((a, -b) if norm > 0 else (-a, b), abs(norm))
    Gt -> GtE | 0 -> -1 | the norm is an integer, and that of 0 alone is 0
return tuple(p if abs(p) >= _SMALLEST else math.inf for p in powers)
    GtE -> Gt | the bits hold for the bound itself, and integers decide without them
sign = ("-" if c < 0 else "") if not text else " - " if c < 0 else " + "
    Lt -> LtE | Lt -> LtE (2) | c is not 0 here
return self.made(self._reduced(whole + [0] * (self.degree - len(whole))), scale)
    Sub -> Add | what is beyond the degree is 0
self._roots[prime] = int(-found[0].TC()) % prime if found else None
    0 -> -1 | any root will do
bound = 2 * max(integer_nthroot(abs(c), n - k)[0] + 1 for k, c in enumerate(lower) if c)
    2 -> 3 | a larger bound
    1 -> 2 | a larger bound
if n == 2:
    2 -> 1 | what serves for other degrees serves for this one
if denominator != 1:
    1 -> 0 | what is divided by 1 stays
return self.sign() > 0 if type(other) is int and not other else not self <= other
    dropped: type(other) is int | Is -> IsNot | the difference from any 0 has the same sign
    Gt -> GtE | 0 -> -1 | a sign is 1 or -1
powers = [p / one if abs(p) < _LARGEST * one else math.inf for p in self._scaled(_BITS)]
    Lt -> LtE | beyond floats integers are taken
return self if self.denominator == 1 else AlgebraicNumber(self.field, self.coefficients, 1)
    1 -> 0 | a copy
[law]
return number_text(value, digits=30, longest=60)
    30 -> 31 | 30 -> 29 | 60 -> 61 | 60 -> 59 | how long numbers of messages are was chosen
[robust]
_FINEST = 1 << MOST_CUTS
    1 -> 2 | any common multiple of all denominators will do
self.number = 2 * n + 2
    2 -> 3 | 2 -> 3 (2) | parts more, which are 0
units = [tuple(Fraction(j == k) for j in range(n)) for k in range(n * (bounds.length > 0))]
    Mult -> Add | one part more, which is 0 and then set to another number
    Gt -> GtE | 0 -> -1 | without such a bound these parts are 0
if all(e.high <= 0 for e in springs):
    LtE -> Lt | 0 -> -1 | a spring force of at most 0 has work 0 below as well
one, other = across[0], across[0].negative()
    0 -> -1 | 0 -> -1 (2) | in the plane there is one tangent
rubs = [one] * any(s.high >= 0 for (s,) in slips)
    0 -> -1 | stricter by a unit
rubs += [other] * any(s.low <= 0 for (s,) in slips)
    0 -> 1 | stricter by a unit
if e.low >= 0:
    GtE -> Gt | 0 -> 1 | 0 -> -1 | for a spring force around 0 both bounds hold
work = min(least, 0) * max(e.high, 0) >> _BITS
    0 -> 1 | 0 -> -1 (2) | of this, what is above 0 is not counted
    0 -> -1 | 0 -> 1 (2) | stricter by a unit
if least <= 0:
    0 -> 1 | the tangent is then above 1
tangent = max(-(-(side.size << _BITS) // forth.low) for forth, side in parts) + (1 << 40)
    1 -> 2 | 40 -> 41 | a larger bound
    1 -> 0 | 40 -> 39 | the tangent of exact slips is that of v, whatever length v has
if tangent > _ONE:
    Gt -> GtE | up to which tangent it is tried was chosen
rest = max(-still.low, 0) * tangent * tangent // 2 + turn.size * tangent * uneven
    0 -> 1 | a larger bound
    0 -> -1 | half a unit, and the terms added below have more to spare
rest = -(-rest >> 2 * _BITS) + (_length(x.size for x in b) >> 90) + 1
    1 -> 2 | 90 -> 89 | a larger bound
if not low or before <= 0:
    dropped: not low | low -> high | where each entry may be 0, what is before is at most 0
    LtE -> Lt | 0 -> -1 | the cosine is then 0: the whole, or a bound below 0 that needs none
    0 -> 1 | a larger bound
steepest = max(steepest, -(-(work << _BITS) // (low if work > 0 else high)))
    Gt -> GtE | 0 over any length is 0
    0 -> 1 | 0 -> -1 | over high it is a bound too, as v . s_j is at least the cosine times high
low = math.isqrt(sum(max(abs(x.centre) - x.radius, 0) ** 2 for x in slip))
    0 -> 1 | 0 -> -1 | the root of x^2 + 1 is x rounded down; where x is 0 see below
if steepest > 0:
    Gt -> GtE | 0 -> -1 | 0 over the cosine is 0, or replaced by the whole
for k in range(0, len(forces), each or 1)
    1 -> 2 | without forces the range is empty
for end in ranges[k][::-1][:1] if half and not k else ranges[k]:
    1 -> 2 (2) | of two ends every second, backwards, is the last alone
if self.closed and any(dot(way, load) <= 0 for _, load, _ in corners):
    0 -> 1 | stricter by a unit
if self.rest and None in here:
    dropped: self.rest | of motions no corner is None
return all(x > 0 or x == 0 == share for x, (share, *_) in zip(work, corners, strict=True))
    0 -> 1 | stricter by a unit
if not problem and not box.holds(virtual, ranges):
    dropped: not problem | another leaf that does not hold is named
"""


def _reasons(target: str) -> dict[tuple[str, str], str]:
    """Return the entries of `EQUIVALENT` for a target, by line of code and fault."""
    found, text = dict[tuple[str, str], str](), ""
    for line in EQUIVALENT.partition(f"\n[{target}]\n")[2].partition("\n[")[0].splitlines():
        if line.startswith("    "):
            *changes, reason = line.strip().split(" | ")
            found |= {(text, change): reason for change in changes}
        else:
            text = line
    return found


_COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Add,
    ast.FloorDiv: ast.Mult,
    ast.Div: ast.Mult,
    ast.Pow: ast.Mult,
}
#: Names of functions, methods and ends of intervals that are easily taken for one another.
_NAMES = {"max": "min", "any": "all", "low": "high", "floor": "ceil"}
_NAMES |= {other: name for name, other in _NAMES.items()}


#: Texts of messages, and annotations of types.
_SILENT = (ast.JoinedStr, ast.AnnAssign, ast.arg, ast.Raise)


class Fault(NamedTuple):
    """A fault of a source text: the line, its text, what is changed, the changed tree."""

    line: int
    text: str
    change: str
    plant: Callable[[], ast.Module]


def faults(source: str) -> Iterator[Fault]:
    """Yield every fault of a source text."""
    tree, lines, seen = ast.parse(source), source.splitlines(), Counter[tuple[int, str]]()
    nodes = list(ast.walk(tree))
    silent = [getattr(n, "annotation", None) or n for n in nodes if isinstance(n, _SILENT)]
    skipped = {id(n) for top in silent for n in ast.walk(top)}
    for place, node in enumerate(nodes):
        if id(node) in skipped:
            continue
        for change, alter in chain(_alterations(node), _omissions(node)):

            def plant(place: int = place, alter: Any = alter) -> ast.Module:
                changed = copy.deepcopy(tree)
                alter(list(ast.walk(changed))[place])
                return ast.fix_missing_locations(changed)

            line = getattr(node, "lineno", 0)
            seen[line, change] += 1
            again = f" ({seen[line, change]})" if seen[line, change] > 1 else ""
            yield Fault(line, lines[line - 1].strip(), change + again, plant)


def _alterations(node: ast.AST) -> Iterator[tuple[str, Any]]:
    """Yield what can be changed in one node: a name, and a function that does it."""
    if isinstance(node, ast.Compare):
        for i, old in enumerate(node.ops):
            for new in _COMPARISONS[type(old)]:
                yield f"{type(old).__name__} -> {new.__name__}", _setter("ops", i, new())
    elif isinstance(node, ast.BoolOp):
        new_op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield f"{type(node.op).__name__} -> {type(new_op).__name__}", _setter("op", None, new_op)
    elif isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        new = _OPERATORS[type(node.op)]
        yield f"{type(node.op).__name__} -> {new.__name__}", _setter("op", None, new())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "minus dropped", _setter("op", None, ast.UAdd())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield "not dropped", _setter("operand", None, ast.UnaryOp(ast.Not(), node.operand))
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        for value in (node.value + 1, node.value - 1):
            yield f"{node.value} -> {value}", _setter("value", None, value)


def _omissions(node: ast.AST) -> Iterator[tuple[str, Any]]:
    """Yield the same for what can be left out, or taken for its opposite."""
    if isinstance(node, (ast.BoolOp, ast.List)):
        field = "values" if isinstance(node, ast.BoolOp) else "elts"
        values = getattr(node, field)
        for i, value in enumerate(values if len(values) > 1 else ()):
            yield f"dropped: {ast.unparse(value)}", _remover(field, i)
    field = {ast.Name: "id", ast.Attribute: "attr"}.get(type(node), "")
    name = getattr(node, field, "")
    if name in _NAMES and isinstance(node.ctx, ast.Load):
        yield f"{name} -> {_NAMES[name]}", _setter(field, None, _NAMES[name])


def _setter(field: str, index: int | None, value: Any) -> Any:
    def alter(node: Any) -> None:
        if index is None:
            setattr(node, field, value)
        else:
            getattr(node, field)[index] = value

    return alter


def _remover(field: str, index: int) -> Any:
    def alter(node: Any) -> None:
        values = getattr(node, field)
        del values[index]
        if isinstance(node, ast.BoolOp) and len(values) == 1:
            values *= 2  # "x and x" is x

    return alter


class _Planted(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Loads one module from a changed tree."""

    def __init__(self, target: Target, tree: ast.Module) -> None:
        self.target, self.code = target, compile(tree, str(target.path), "exec")

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        if name != self.target.module:
            return None
        return importlib.util.spec_from_loader(name, self, origin=str(self.target.path))

    def exec_module(self, module: Any) -> None:
        module.__file__ = str(self.target.path)
        exec(self.code, module.__dict__)  # noqa: S102


def survives(target: Target, fault: Fault) -> bool:
    """Run the tests of a target with a fault from the import on, in a process of their own."""

    def run() -> int:
        sys.meta_path.insert(0, _Planted(target, fault.plant()))
        # Now, for pytest itself would load a module that is called something_test.
        importlib.import_module(target.module)
        return _tests(target, _Confined())

    return _in_child(run) == 0


def _in_child(run: Callable[[], int]) -> int:
    """Return what a function returns in a quiet process of its own: a number below 255."""
    if not (child := os.fork()):
        status = 255
        try:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            for stream in (1, 2):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
            _Confined().pytest_runtest_logstart()
            status = run()
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def _tests(target: Target, plugin: Any) -> int:
    import pytest

    options = ["-x", "-q", "-s", "--tb=no", "-p", "no:cacheprovider", "-W", "ignore"]
    return int(pytest.main([*options, "--hypothesis-profile=mutants", *target.tests], [plugin]))


class _Confined:
    """Ends the process when a test takes too long."""

    def pytest_runtest_logstart(self) -> None:
        """Count from here."""
        seconds, most = (
            int(time.process_time()) + 1 + LIMIT,
            resource.getrlimit(resource.RLIMIT_CPU),
        )
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, most[1]))


class _InPlace(_Confined):
    """Runs the tests with one fault after the other, in children of a process that has them all."""

    def __init__(self, target: Target, listed: Sequence[Fault], asked: Connection) -> None:
        self.target, self.listed, self.asked = target, listed, asked
        self.lines, self.costs = dict[Any, list[int]](), dict[Any, float]()

    def pytest_runtestloop(self, session: Any) -> bool:
        """Answer for each number of a fault whether a test notices it; -1 is none."""
        # Its children are confined; it plants as many faults as there are.
        most = resource.getrlimit(resource.RLIMIT_CPU)[1]
        resource.setrlimit(resource.RLIMIT_CPU, (most, most))
        path, module = str(self.target.path), self.target.module
        code = _codes(compile(self.target.path.read_text(), path, "exec"))
        functions = [
            f for f in gc.get_objects() if type(f) is FunctionType and f.__module__ == module
        ]
        gc.freeze()
        for number in iter(self.asked.recv, None):
            changed, items = code, list(session.items)
            line = self.listed[number].line if number >= 0 else 0
            if number >= 0:
                changed = _codes(compile(self.listed[number].plant(), path, "exec"))
            # First those that noticed a fault nearby, and quick ones: a line is worth 0.05 s.
            far = {x: min([abs(y - line) for y in self.lines.get(x, [100])]) for x in items}
            items.sort(key=lambda x: 0.05 * far[x] + self.costs.get(x, 0))
            costs = RawArray("d", len(items))

            def run(items: Any = items, changed: Any = changed, costs: Any = costs) -> int:
                for f in functions:
                    key = f.__code__.co_qualname, f.__code__.co_firstlineno
                    if key in changed and changed[key] != code[key]:
                        f.__code__ = changed[key]
                for k, (one, after) in enumerate(zip(items, [*items[1:], None], strict=True), 1):
                    start = time.process_time()
                    session.config.hook.pytest_runtest_protocol(item=one, nextitem=after)
                    costs[k - 1] = time.process_time() - start
                    if session.testsfailed:
                        return min(k, 254)
                return 0

            status = _in_child(run) if number < 0 or changed != code else 0
            if number < 0:
                self.costs = dict(zip(items, costs, strict=True))
            elif 0 < status < 255:
                self.lines.setdefault(items[status - 1], []).append(line)
            self.asked.send(status != 0)
        return True


def _codes(code: CodeType) -> dict[tuple[str, int], CodeType]:
    """Return the code of all functions."""
    inner = [x for x in code.co_consts if isinstance(x, CodeType)]
    found = {(x.co_qualname, x.co_firstlineno): x for x in inner}
    return found | {key: x for one in inner for key, x in _codes(one).items()}


def _preload() -> None:
    """Import what the tests need from outside once, before processes are forked."""
    for name in ("jsonschema", "networkx", "numpy", "pytest", "scipy.optimize", "sympy"):
        importlib.import_module(name)
    from hypothesis import HealthCheck, Phase, settings

    settings.register_profile(  # That of tests/conftest.py, and what failed is not made smaller.
        "mutants",
        derandomize=True,
        deadline=None,
        database=None,
        suppress_health_check=[HealthCheck.too_slow],
        phases=[Phase.explicit, Phase.generate],
    )


def plant(name: str, seed: int, first: int = 1) -> int:
    """Plant the faults of a target and print those that survive; return how many should not."""
    target, reasons, start = TARGETS[name], _reasons(name), time.monotonic()
    listed = list(faults(target.path.read_text(encoding="utf-8")))
    wrong = set(reasons) - {(fault.text, fault.change) for fault in listed}
    if target.sample:
        listed = Random(f"mutants {seed}").sample(listed, min(target.sample, len(listed)))
    fork, alike, alive = get_context("fork"), 0, 0
    here, there = fork.Pipe()
    worker = fork.Process(
        target=_in_child, args=(lambda: _tests(target, _InPlace(target, listed, there)),)
    )
    worker.start()
    there.close()  # Else nothing would be heard of a worker that ends.

    def noticed(number: int) -> bool:
        here.send(number)
        return bool(here.recv())

    if noticed(-1):
        raise SystemExit(f"the tests of {name} fail without a fault, or take too long")
    for number, fault in enumerate(listed[first - 1 :], first - 1):
        known = (fault.text, fault.change) in reasons
        if noticed(number):
            wrong |= {(fault.text, fault.change)} if known else set()
        elif known:
            alike += 1
        elif survives(target, fault):
            alive += 1
            print(f"  {name} {number + 1}, line {fault.line}: {fault.text}")
            print(f"    {fault.change}: SURVIVES", flush=True)
    here.send(None)
    worker.join()
    for text, change in sorted(wrong):
        print(f"  {name}: {text}\n    {change}: does not survive, and is among EQUIVALENT")
    counts = f"{len(listed) - first + 1} faults, {alike} change nothing, {alive} survive"
    print(f"{name}: {counts}, {time.monotonic() - start:.0f} s", flush=True)
    return alive + len(wrong)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; return 1 if a fault survives that is not known to change nothing, or one does not."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=", ".join(TARGETS))
    parser.add_argument("--seed", type=int, default=0, help="of the samples")
    parser.add_argument("--jobs", type=int, default=2, help="targets at a time")
    parser.add_argument("--first", type=int, default=1, help="begin with this one of each list")
    given = parser.parse_args(arguments)
    for name in given.targets:
        if name not in TARGETS:
            parser.error(f"{name!r} is no target; known are {', '.join(TARGETS)}")
    os.chdir(ROOT)
    sys.path.insert(0, str(ROOT))
    _preload()
    with ThreadPoolExecutor(given.jobs) as pool:
        names = given.targets or list(TARGETS)
        wrong = list(pool.map(lambda name: plant(name, given.seed, given.first), names))
    return 1 if any(wrong) else 0


if __name__ == "__main__":
    raise SystemExit(main())
