"""Grasps at corners of bounds that may have another verdict."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import islice
from random import Random
from typing import TYPE_CHECKING

from arrangement.numbers.exact import RationalVector, dot, sign
from equilibrium.certificate.uncertain import Bounds
from equilibrium.core.contact_law import spring_force
from equilibrium.model.contact import VALUES, Contact, wrench_at
from equilibrium.model.solution import leaves_of
from equilibrium.model.subject import Subject, contacts_of, seen_by, with_contacts
from equilibrium.model.unit_normal import unit_normal

from . import NOT_RESISTED, RESISTED
from .nearby import Decide

if TYPE_CHECKING:
    from .verdict import Verdict

#: Virtual motions of one proof that are tried.
MAX_MOTIONS_PER_PROOF = 3
#: Random grasps that are tried inside of the bounds.
MAX_INNER_GRASPS = 4
#: Proofs of loads that are larger by these shares give virtual motions of a resisted one.
LARGER_LOAD_SHARES = (Fraction(1, 100), Fraction(1))


def moved(contact: Contact, signs: Iterable[float], bounds: Bounds) -> Contact:
    """Return a contact within bounds: shares from -1 to 1 of each turn, coordinate and value."""
    n, shares = contact.dimension, [Fraction(x).limit_denominator(64) for x in signs]
    normal, turns = contact.normal, shares[: n - 1]
    if bounds.angle and any(turns):
        # In space the two turns together are at most sqrt(2).
        reach = bounds.angle * (Fraction(49, 50) if n == 2 else Fraction(69, 100))
        across = [dot(turns, column) for column in zip(*contact.tangents, strict=True)]
        wanted = [x + reach * y for x, y in zip(normal, across, strict=True)]
        normal = unit_normal(wanted, bounds.angle / 60).normal
    place = [x + s * bounds.length for x, s in zip(contact.point, shares[n - 1 :], strict=False)]
    values = {
        name: getattr(contact, name) * (1 + s * getattr(bounds, name))
        for name, s in zip(VALUES, shares[2 * n - 1 :], strict=True)
    }
    return Contact(place, normal, **values, stiffness_given=contact.stiffness_given)


def corners(verdict: Verdict, bounds: Bounds, decide: Decide) -> Iterator[Subject]:
    """Yield grasps, or assemblies, within bounds that may turn a verdict.

    First those where friction, stiffness and preload all are least and adhesion largest, or the
    other way round; then those where each contact does the most on a virtual motion (for a no the
    least): the load itself, and those of proofs for this load and larger ones; at last some inside.
    None comes twice.
    """
    known = {verdict.subject}
    for shares in _shares(verdict, decide):
        pairs = zip(contacts_of(verdict.subject), shares, strict=True)
        subject = with_contacts(verdict.subject, (moved(c, row, bounds) for c, row in pairs))
        if subject not in known:
            known.add(subject)
            yield subject


def _shares(verdict: Verdict, decide: Decide) -> Iterator[list[list[float]]]:
    """Yield the shares for `moved` of all contacts, of which a pad is one."""
    subject, most = verdict.subject, 1 if verdict.verdict == RESISTED else -1
    contacts = contacts_of(subject)
    dimension = contacts[0].dimension if contacts else 2
    turns, values = 2 * dimension - 1, len(VALUES) - 1
    for end in (-most, most):
        yield [[0.0] * turns + [end] * values + [-end] for _ in contacts]
    motion = verdict.solution.motion if verdict.solution else (Fraction(0),) * len(verdict.load)
    for virtual in _virtual_motions(verdict, decide):
        yield [
            _working(contact, seen_by(subject, i, virtual), seen_by(subject, i, motion), most)
            for i, contact in enumerate(contacts)
        ]
    source = Random("robust")
    for _ in range(MAX_INNER_GRASPS):
        yield [
            [
                source.uniform(-1, 1) if k < turns + values or c.adhesion else 0.0
                for k in range(turns + values + 1)
            ]
            for c in contacts
        ]


def _virtual_motions(verdict: Verdict, decide: Decide) -> Iterator[RationalVector]:
    """Yield virtual motions on which the load does work."""
    loads = [verdict.load]
    if verdict.verdict == RESISTED:
        yield verdict.load
        loads = [tuple(x * (1 + more) for x in verdict.load) for more in LARGER_LOAD_SHARES]
    for load in loads:
        proof = verdict if load == verdict.load else decide(verdict.subject, load)
        if proof is not None and proof.verdict == NOT_RESISTED:
            # Proofs in a plane, and about one body of several, have fewer numbers.
            motions = (x.motion for x in leaves_of(proof.tree) if len(x.motion) == len(load))
            yield from islice(motions, MAX_MOTIONS_PER_PROOF)


def _working(
    contact: Contact, virtual: Sequence[Fraction], motion: Sequence[Fraction], most: int
) -> list[float]:
    """Return the signs for `moved` where a contact does the most work, or the least (-1).

    Each sign is that of the change of the work ``(e (N - mu u T) - adhesion N) virtual`` by it,
    with the spring force e and the direction u of friction at the motion.
    """
    d = contact.dimension
    slips = [dot(row, virtual) for row in contact.tangential_wrenches]
    along, size = dot(contact.normal_wrench, virtual), sum(map(abs, slips))
    ways = [Fraction(x) / size if size else Fraction(0) for x in slips]
    spring = max(spring_force(contact, motion), Fraction(0))
    work = along - contact.friction * dot(ways, slips)
    # Without adhesion all forces are proportional to e.
    pressing, stuck = (spring, contact.adhesion) if contact.adhesion else (Fraction(1), Fraction(0))
    rubbing = pressing * contact.friction
    turns = [
        (pressing - stuck) * slip + rubbing * way * along
        for slip, way in zip(slips, ways, strict=True)
    ]
    force = contact.force([pressing - stuck, *(-rubbing * way for way in ways)])
    axes = (tuple(Fraction(j == k) for j in range(d)) for k in range(d))
    shifts = [dot(wrench_at(axis, force)[d:], virtual[d:]) for axis in axes]
    pressed = -work * dot(contact.normal_wrench, motion)
    return [most * sign(x) for x in (*turns, *shifts, -size * spring, pressed, work, -along)]
