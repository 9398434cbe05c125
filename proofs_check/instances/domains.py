"""Domains: which instances a claim is about, how to draw one at random, and known families.

A sweep and a user's own claim name a domain. One draw depends on its random generator and its
number of planes (or contacts) and on nothing else.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import cache, partial
from random import Random
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import refusal
from arrangement.library import families
from arrangement.numbers.exact import shown
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check.errors import UnknownDomainError
from proofs_check.routes.oracle import Question
from proofs_check.statements.statement import Case, Domain

from .arrangements import random_arrangement
from .extremal import extremal, extremal_irrational
from .grasps import grasp_of
from .pseudolines import PSEUDOLINES, Pseudolines

#: What hyperplanes of R^d are called.
_UNITS_OF_DIMENSION = {2: "lines", 3: "planes"}
#: Rational unit normals: along the axes, and of the triangles 3-4-5 and 5-12-13.
_UNITS = tuple(
    (Fraction(a, c), Fraction(b, c))
    for a, b, c in ((1, 0, 1), (0, 1, 1), (3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13))
)
_FRICTIONS = tuple(map(Fraction, ("0", "1/4", "1/2", "1", "2")))


def domain(name: str) -> Domain:
    """Return a domain by name.

    Raises:
        UnknownDomainError: no domain has this name; the message lists those of the documentation.
    """
    if name in DOMAINS:
        return DOMAINS[name]
    if name in _IN_DIMENSIONS:
        raise UnknownDomainError(
            f"the domain {name} has no dimension; write {name}(d=2) for lines of the plane, "
            f"{name}(d=3) for planes of R^3"
        )
    known = [entry for entry in DOMAINS if entry != "question"]
    mistake = f"no domain is called {shown(name)}"
    listed = str(refusal(mistake, name, [*known, "dual"], "there are"))
    raise UnknownDomainError(
        f"{listed}, and families such as catalan(n=2..8), which arrangement make --help lists"
    )


def is_domain(text: str) -> bool:
    """Return whether a text names a domain, with or without its dimension."""
    return text.partition("(")[0] in {name.partition("(")[0] for name in DOMAINS}


def count(subject: Any) -> int:
    """Return the number of planes or contacts of an instance."""
    return len(subject.contacts) if isinstance(subject, Question) else len(subject)


def size(subject: Any) -> tuple[Any, ...]:
    """Return a key that sorts instances: fewer planes first, then smaller numbers."""
    if isinstance(subject, Pseudolines):
        return (len(subject), subject.signs.count(0), subject.signs)
    if isinstance(subject, Arrangement):
        rows = subject.integer_planes
        entries = [abs(x) for row in rows for x in row]
        return (len(rows), max(entries, default=0), sum(entries), rows)
    grasp = grasp_of(subject) if isinstance(subject, Question) else subject
    numbers = [x for c in grasp for x in contact_numbers(c)]
    if isinstance(subject, Question):
        numbers += subject.wrench
    weight = sum(abs(x.numerator) + x.denominator - 1 for x in numbers)
    return (len(grasp), weight, tuple(numbers))


def contact_numbers(contact: Contact) -> tuple[Fraction, ...]:
    """Return the numbers of a contact: point, normal, friction, stiffness, preload."""
    return (
        *contact.point,
        *contact.normal,
        contact.friction,
        contact.stiffness,
        contact.preload,
    )


def known_families(chosen: Domain, *, irrational: bool = False) -> Iterator[Case]:
    """Yield the named instances that belong to a domain.

    Args:
        irrational: those with coefficients in a number field alone; else the rational ones.
    """
    for name, planes in extremal_irrational() if irrational else _families():
        if chosen.contains(planes):
            yield Case(name, planes, planes.to_dict())


@cache
def _families() -> tuple[tuple[str, Arrangement], ...]:
    """Return the families by name; what one claim lists of their faces serves the next."""
    return tuple(_named_arrangements())


def _named_arrangements() -> Iterator[tuple[str, Arrangement]]:
    for m in range(1, 11):
        yield f"generic({m})", families.generic(m)
        yield f"pencil({m})", families.pencil(m)
        if m >= 3:
            yield f"near_pencil({m})", families.near_pencil(m)
    yield "coordinate(3)", families.coordinate(3)
    yield "type_b(3)", families.type_b(3)
    yield "type_d(3)", families.type_d(3)
    for m, number in families.simplicial_entries(rational=True):
        if m <= 13:
            yield f"simplicial({m}, {number})", families.simplicial(m, number)
    yield "threshold(3)", families.threshold(3)
    yield "resonance(3)", families.resonance(3)
    for m in range(2, 8):
        yield f"generic({m}, affine=True)", families.generic(m, affine=True)
        yield f"generic({m}, d=2, affine=True)", families.generic(m, 2, affine=True)
    yield from extremal()
    for make in (families.shi, families.catalan, families.linial, families.semiorder):
        yield f"{make.__name__}(3)", make(3)


def _central(rng: Random, m: int) -> Arrangement:
    """Small entries give coincident planes, common lines and low rank often."""
    return random_arrangement(rng, m, size=rng.choice((1, 2, 9)))


def _belonging(
    name: str, text: str, least: int, contains: Callable[[Any], bool], d: int = 3, **options: Any
) -> Domain:
    """Return a domain that is drawn from by trying, with larger entries each time."""

    def draw(rng: Random, m: int) -> Arrangement:
        reach = rng.choice((1, 2, 9))
        while not contains(planes := random_arrangement(rng, m, d, reach, **options)):
            reach += 1
        return planes

    return Domain(name, text, _UNITS_OF_DIMENSION[d], least, draw, contains)


def _affine(d: int) -> Domain:
    def draw(rng: Random, m: int) -> Arrangement:
        return random_arrangement(rng, m, d, rng.choice((1, 2, 9)), affine=rng.random() < 0.5)

    text = f"arrangements in R^{d}, central or not"
    return Domain(f"affine(d={d})", text, _UNITS_OF_DIMENSION[d], 1, draw, partial(_is_in, d))


def _are_lines(planes: Any) -> bool:
    return _is_in(2, planes) and _is_distinct(planes)


def _are_simple_lines(planes: Any) -> bool:
    """Return whether any two lines meet, and no three in a point, be it the origin."""
    return _are_lines(planes) and planes.is_simple and not (planes.is_central and len(planes) > 2)


def _simple_affine(d: int) -> Domain:
    return _belonging(
        f"simple-affine(d={d})",
        f"affine arrangements in general position in R^{d}",
        2,
        lambda planes: (
            _is_in(d, planes)
            and _is_distinct(planes)
            and not planes.is_central
            and planes.is_simple
        ),
        d,
        affine=True,
    )


def _random_grasp(rng: Random, m: int) -> Grasp:
    return Grasp(_random_contact(rng) for _ in range(m))


def _random_contact(rng: Random) -> Contact:
    a, b = rng.choice(_UNITS)
    return Contact(
        (rng.randint(-3, 3), rng.randint(-3, 3)),
        (a * rng.choice((1, -1)), b * rng.choice((1, -1))),
        rng.choice(_FRICTIONS),
        rng.choice((1, 1, 2)),
        rng.choice((0, 0, 1, 2)),
    )


def _random_question(rng: Random, m: int) -> Question:
    grasp = _random_grasp(rng, m)
    wrench = tuple(Fraction(rng.randint(-3, 3)) for _ in range(3))
    return Question(tuple(contact_numbers(c) for c in grasp), wrench)


def _is_in(d: int, planes: Any) -> bool:
    return isinstance(planes, Arrangement) and planes.dimension == d


def _is_central(planes: Any) -> bool:
    return _is_in(3, planes) and planes.is_central


def _is_rank_3(planes: Any) -> bool:
    return _is_central(planes) and planes.rank == 3


def _is_distinct(planes: Any) -> bool:
    return len(planes.distinct) == len(planes)


#: Domains of hyperplanes in R^d, which are named with their dimension.
_IN_DIMENSIONS: Mapping[str, Callable[[int], Domain]] = {
    "simple-affine": _simple_affine,
    "affine": _affine,
}
_LISTED = (
    Domain("central", "central arrangements in R^3", "planes", 1, _central, _is_central),
    _belonging("rank-3", "central arrangements of rank 3", 3, _is_rank_3),
    _belonging(
        "distinct",
        "central arrangements of different planes, of rank 3",
        3,
        lambda planes: _is_rank_3(planes) and _is_distinct(planes),
    ),
    _belonging(
        "simple",
        "central arrangements in general position in R^3",
        1,
        lambda planes: _is_central(planes) and _is_distinct(planes) and planes.is_simple,
    ),
    *(make(d) for make in _IN_DIMENSIONS.values() for d in _UNITS_OF_DIMENSION),
    _belonging("lines", "different lines of the plane", 1, _are_lines, 2, affine=True),
    _belonging(
        "simple-lines",
        "lines of the plane in general position",
        1,
        _are_simple_lines,
        2,
        affine=True,
    ),
    Domain("grasp", "grasps", "contacts", 1, _random_grasp, lambda x: isinstance(x, Grasp)),
    Domain(
        "question",
        "grasps under a wrench",
        "contacts",
        1,
        _random_question,
        lambda x: isinstance(x, Question),
    ),
    PSEUDOLINES,
)
DOMAINS: Mapping[str, Domain] = {entry.name: entry for entry in _LISTED}
