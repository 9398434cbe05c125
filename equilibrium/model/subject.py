"""What a question is about, a grasp or an assembly, as its contacts and their rows alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TypeAlias

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.rank import difference

from .assembly import SIZE, Assembly
from .contact import Contact
from .errors import GraspError
from .grasp import Grasp
from .labels import DataError
from .rows import ContactRows

Subject: TypeAlias = Grasp | Assembly


def contacts_of(subject: Subject) -> tuple[Contact, ...]:
    """Return the contacts, without their bodies; a pad is one."""
    if isinstance(subject, Assembly):
        return tuple(one.contact for one in subject.contacts)
    return subject.joined().contacts


def points_of(subject: Subject) -> tuple[Contact, ...]:
    """Return the contacts, without their bodies; each point of a pad is one."""
    return contacts_of(subject) if isinstance(subject, Assembly) else subject.contacts


def with_contacts(subject: Subject, contacts: Iterable[Contact]) -> Subject:
    """Return the same bodies with other contacts in the places of their own; no data error."""
    if isinstance(subject, Assembly):
        pairs = zip(subject.contacts, contacts, strict=True)
        touching = [replace(old, contact=new) for old, new in pairs]
        return Assembly(subject.bodies, touching, subject.units)
    return replace(subject.spread(contacts), units=subject.units)


def known_error(subject: Subject) -> DataError:
    """Return the error of the data that were rounded.

    Raises:
        GraspError: none were.
    """
    if subject.data_error is None:
        raise GraspError("the numbers were not rounded: there is no data_error")
    return subject.data_error


def rows_of(subject: Subject) -> ContactRows:
    """Return the rows of the law."""
    return subject.rows if isinstance(subject, Assembly) else ContactRows.of_grasp(subject)


def seen_by(subject: Subject, i: int, motion: Sequence[Fraction]) -> RationalVector:
    """Return a motion as contact i sees it: in an assembly that of body_a relative to body_b."""
    if not isinstance(subject, Assembly):
        return tuple(motion)
    one, names = subject.contacts[i], subject.names

    def of(name: str) -> Sequence[Fraction]:
        start = SIZE * names.index(name)
        return motion[start : start + SIZE]

    own = tuple(of(one.body_a))
    return own if one.body_b is None else difference(own, tuple(of(one.body_b)))
