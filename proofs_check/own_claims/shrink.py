"""Shrinking: from an instance that fails to a small one that still fails.

Deterministic, with no random choice: planes (or contacts) are left out while the instance still
fails, then planes (one, or all equal ones at once) are replaced by smaller ones while it still
fails. Each accepted step is smaller in a well-founded order, so this ends; a limit on the number
of tries bounds it besides.
A greedy search can stop above the smallest instance, so `smaller_instances` lists what has fewer
planes: every isomorphism class, and every arrangement with entries -1, 0, 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.library.census import census
from arrangement.numbers.exact import IntegerVector, primitive
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check.instances.arrangements import smallest_planes
from proofs_check.instances.domains import contact_numbers, count, size
from proofs_check.instances.pseudolines import Pseudolines
from proofs_check.statements.statement import Case

MOST_TRIES = 4000
#: Small numbers of planes for which all arrangements with entries -1, 0, 1 are tried.
_ALL_SMALL = 4
_AXES = ((1, 0), (0, 1), (-1, 0), (0, -1))


def shrink(subject: Any, fails: Callable[[Any], bool], tries: int = MOST_TRIES) -> tuple[Any, int]:
    """Return a smaller instance that still fails, and how many instances were tried.

    Args:
        subject: an `Arrangement`, `Pseudolines` or a `Grasp` that fails.
        fails: whether an instance belongs to the domain and fails.
        tries: at most this many calls of `fails`.
    """
    tried = 0
    steps = next(made for kind, made in _STEPS.items() if isinstance(subject, kind))
    progress = True
    while progress:
        progress = False
        for candidate in steps(subject):
            if tried >= tries:
                return subject, tried
            tried += 1
            if fails(candidate):
                subject, progress = candidate, True
                break
    return subject, tried


def smallest_case(cases: list[Case], fails: Callable[[Any], bool]) -> tuple[Case, int]:
    """Make the smallest of some failing cases as small as possible; return how many were tried.

    After shrinking, all smaller instances of `smaller_instances` are looked through for one that
    fails.
    """
    start = min(cases, key=lambda case: size(case.subject))
    subject, searched = shrink(start.subject, fails)
    in_space = isinstance(subject, Arrangement) and subject.dimension == 3
    for candidate in smaller_instances(len(subject)) if in_space else ():
        searched += 1
        if fails(candidate):
            subject, more = shrink(candidate, fails)
            searched += more
            break
    unit = "n" if isinstance(subject, Pseudolines) else "m"
    return Case(
        f"{unit} = {count(subject)}, from {start.label}", subject, subject.to_dict()
    ), searched


def smaller_instances(planes: int) -> Iterator[Arrangement]:
    """Yield arrangements in R^3 with fewer planes than given, smallest numbers of planes first.

    For each number: all arrangements with entries -1, 0, 1 (up to 4 planes), then one of each
    isomorphism class of different planes of rank 3 (up to seven planes).
    """
    for m in range(1, planes):
        if m <= _ALL_SMALL:
            yield from smallest_planes(range(m, m + 1), 1)
        if 3 <= m <= 7:
            yield from census(m)


def _arrangement_steps(planes: Arrangement) -> Iterator[Arrangement]:
    rows, d = planes.integer_planes, planes.dimension
    for i in range(len(rows)):
        yield _arrangement([*rows[:i], *rows[i + 1 :]], d)
    for i, row in enumerate(rows):
        for smaller in _smaller_rows(row):
            yield _arrangement([*rows[:i], smaller, *rows[i + 1 :]], d)
    for row in sorted(set(rows)):
        for smaller in _smaller_rows(row) if rows.count(row) > 1 else ():
            yield _arrangement([smaller if other == row else other for other in rows], d)


def _arrangement(rows: Sequence[IntegerVector], d: int) -> Arrangement:
    return Arrangement([row[:-1] for row in rows], [row[-1] for row in rows], dimension=d)


def _weight(row: IntegerVector) -> tuple[Any, ...]:
    """Return the order in which planes get smaller: by entries, then by signs, then by place."""
    entries = tuple(abs(x) for x in row)
    return (max(entries), sum(entries), sum(x < 0 for x in row), tuple(-x for x in row))


def _smaller_rows(row: IntegerVector) -> list[IntegerVector]:
    """Return smaller planes, smallest first: entries -1, 0, 1, and nearer entries."""
    central = row[-1] == 0
    short = product((0, 1, -1), repeat=len(row) - central)
    rows = {(*entry, 0) if central else entry for entry in short} if len(row) <= 5 else set()
    for j, x in enumerate(row):
        for nearer in (0, abs(x), x // 2 if x > 0 else -(-x // 2), x - 1 if x > 0 else x + 1):
            rows.add((*row[:j], nearer, *row[j + 1 :]))
    usable = {primitive(entry) for entry in rows if any(entry[:-1])}
    return sorted((entry for entry in usable if _weight(entry) < _weight(row)), key=_weight)


def _grasp_steps(grasp: Grasp) -> Iterator[Grasp]:
    contacts = grasp.contacts
    for group in grasp.groups:
        yield Grasp([*contacts[: group.start], *contacts[group.stop :]])
    whole = grasp.joined().contacts
    for k, contact in enumerate(whole):
        for smaller in _smaller_contacts(contact):
            yield grasp.spread([*whole[:k], smaller, *whole[k + 1 :]])


def _smaller_contacts(contact: Contact) -> list[Contact]:
    """Return contacts with one of point, normal, friction, stiffness, preload simpler."""
    x, y = contact.point
    points: list[tuple[Fraction | int, ...]] = [*product((0, 1, -1), repeat=2)]
    points += [(nearer, y) for nearer in _nearer(x)] + [(x, nearer) for nearer in _nearer(y)]
    changes: list[dict[str, Any]] = [{"point": point} for point in points]
    changes += [{"normal": axis} for axis in _AXES]
    changes += [{"friction": friction} for friction in (1, 0, Fraction(1, 2))]
    changes += [{"stiffness": 1}, {"preload": 0}, {"preload": 1}]
    contacts = {replace(contact, **change) for change in changes}
    here = _contact_weight(contact)
    return sorted((c for c in contacts if _contact_weight(c) < here), key=_contact_weight)


def _pseudoline_steps(lines: Pseudolines) -> Iterator[Pseudolines]:
    return filter(None, map(lines.without, range(len(lines))))


_STEPS: dict[type, Callable[[Any], Iterator[Any]]] = {
    Arrangement: _arrangement_steps,
    Pseudolines: _pseudoline_steps,
    Grasp: _grasp_steps,
}


def _nearer(value: Fraction) -> tuple[Fraction, ...]:
    towards = Fraction(int(value))
    step = 1 if value > 0 else -1
    return (towards, towards - step) if value else ()


def _contact_weight(contact: Contact) -> tuple[Any, ...]:
    numbers = contact_numbers(contact)
    total = sum(abs(x.numerator) + x.denominator - 1 for x in numbers)
    return (total, sum(x < 0 for x in numbers), tuple(-x for x in numbers))
