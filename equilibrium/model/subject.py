"""What a question is about, a grasp or an assembly, as its contacts and their rows alone."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.hints import HintsMixin
from arrangement.numbers.exact import RationalVector, shown, to_text
from arrangement.numbers.linear.rank import difference

from .assembly import SIZE, Assembly
from .contact import Contact
from .errors import GraspError
from .grasp import Grasp
from .labels import DataError
from .rows import ContactRows

Subject: TypeAlias = Grasp | Assembly


def check_subject(value: object) -> None:
    """Refuse what is neither a grasp nor an assembly.

    Raises:
        GraspError: with what makes one of the value.
    """
    if not isinstance(value, (Grasp, Assembly)):
        make = "Grasp(contacts)"
        if isinstance(value, (str, os.PathLike, Mapping)):
            make = f"read_grasp({'document' if isinstance(value, Mapping) else shown(value)})"
        raise GraspError(
            f"the grasp is {shown(value)}; expected a Grasp or an Assembly. Write {make}"
        )


def contacts_of(subject: Subject) -> tuple[Contact, ...]:
    """Return the contacts, without their bodies; a pad is one."""
    if isinstance(subject, Assembly):
        return tuple(entry.contact for entry in subject.contacts)
    return subject.joined().contacts


def points_of(subject: Subject) -> tuple[Contact, ...]:
    """Return the contacts, without their bodies; each point of a pad is one."""
    return contacts_of(subject) if isinstance(subject, Assembly) else subject.contacts


def with_contacts(subject: Subject, contacts: Iterable[Contact]) -> Subject:
    """Return the same bodies with other contacts in the places of their own; no data error."""
    if isinstance(subject, Assembly):
        pairs = zip(subject.contacts, contacts, strict=True)
        touching = [replace(old, contact=new) for old, new in pairs]
        return replace(subject, contacts=tuple(touching), data_error=None)
    return replace(subject.spread(contacts), units=subject.units)


def known_error(subject: Subject) -> DataError:
    """Return the error of the data that were rounded.

    Raises:
        GraspError: none were.
    """
    if subject.data_error is None:
        raise GraspError("the numbers were not rounded: there is no data_error")
    return subject.data_error


def read_load(subject: Subject, wrench: Any) -> RationalVector:
    """Return a wrench, or of an assembly those on its bodies by name, as one vector.

    Raises:
        GraspError: a wrench of the wrong length, or on what is no body.
    """
    if isinstance(subject, Assembly):
        return flat(subject, subject.read_wrenches(wrench))
    return subject.read_wrench(wrench)


def no_load(subject: Subject) -> Any:
    """Return the wrench 0; of an assembly on each body."""
    if isinstance(subject, Assembly):
        return subject.read_wrenches({})
    return (Fraction(0),) * subject.wrench_size


def rows_of(subject: Subject) -> ContactRows:
    """Return the rows of the law."""
    return subject.rows if isinstance(subject, Assembly) else ContactRows.of_grasp(subject)


def seen_by(subject: Subject, i: int, motion: Sequence[Fraction]) -> RationalVector:
    """Return a motion as contact i sees it: in an assembly that of body_a relative to body_b."""
    if not isinstance(subject, Assembly):
        return tuple(motion)
    joint, names = subject.contacts[i], subject.names

    def of(name: str) -> Sequence[Fraction]:
        start = SIZE * names.index(name)
        return motion[start : start + SIZE]

    own = tuple(of(joint.body_a))
    return own if joint.body_b is None else difference(own, tuple(of(joint.body_b)))


def flat(subject: Subject, values: Any) -> RationalVector:
    """Return a motion or load as one vector: of an assembly, of which bodies may be left out."""
    if not isinstance(subject, Assembly):
        return tuple(values)
    rows = (values.get(name, (0,) * SIZE) for name in subject.names)
    return tuple(Fraction(x) for row in rows for x in row)


def by_body(subject: Subject, values: Sequence[Fraction]) -> Any:
    """Return a motion or load by the names of bodies; that of a grasp as it is."""
    if not isinstance(subject, Assembly):
        return tuple(values)
    return {name: tuple(values[SIZE * k : SIZE * (k + 1)]) for k, name in enumerate(subject.names)}


def texts(values: Any) -> Any:
    """Return exact numbers as texts, in rows of any depth and by names."""
    if isinstance(values, Mapping):
        return {name: texts(x) for name, x in values.items()}
    return [texts(x) for x in values] if isinstance(values, list | tuple) else to_text(values)


@dataclass(frozen=True)
class LoadCase:
    """The question that a verdict answers: whether a load is resisted.

    Attributes:
        subject: a grasp or an assembly.
        load: the wrench; of an assembly those on its bodies in a row.
        max_displacement, pyramid: see `equilibrium.solve`.
    """

    subject: Subject
    load: RationalVector
    max_displacement: Fraction | None = None
    pyramid: int | None = None

    @property
    def wrench(self) -> Any:
        """The wrench; of an assembly one for each body, by name."""
        return by_body(self.subject, self.load)


class AboutCaseMixin(HintsMixin):
    """What a result says of its question, `case`."""

    case: LoadCase

    @property
    def grasp(self) -> Any:
        """The contacts that it is about: a `Grasp` or an `Assembly`."""
        return self.case.subject

    @property
    def wrench(self) -> Any:
        """The wrench that it is about; of an assembly one for each body, by name."""
        return self.case.wrench

    @property
    def pyramid(self) -> int | None:
        """In space, edges of the friction pyramids that it is about; None for round cones."""
        return self.case.pyramid

    @property
    def max_displacement(self) -> Fraction | None:
        """How far contact points may move for an equilibrium to count, if bounded.

        Of an assembly relative to each other at a contact.
        """
        return self.case.max_displacement
