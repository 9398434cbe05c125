"""Whether a verdict holds for all grasps, or assemblies, near the one that was asked about.

For bounds that a user gives there are three answers: it holds, proved (`equilibrium.certificate.
robust`); a grasp within the bounds for which it does not, with a proof of its own; undecided. For
data that were converted (their `data_error`) the error of the data is such a bound. Where that is
not proved some data within the error are asked about, and what turns the verdict is shown.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

from arrangement.errors import OutOfReachError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector
from equilibrium.certificate.uncertain import Bounds
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.effort import Effort
from equilibrium.model.errors import GraspError, TimeLimitError
from equilibrium.model.subject import Subject, contacts_of, known_error, with_contacts
from equilibrium.model.unit_normal import unit_normal

from . import RESISTED
from .corners import corners
from .meeting import meeting
from .nearby import DEPENDS, FAILS, HOLDS, OPEN, Decide, Robustness, WithinError
from .proofs_for_all import NO_DEADLINE, proof_for_all, standing_proof

if TYPE_CHECKING:
    from .verdict import Verdict

#: Other roundings of the data that are decided.
MAX_ROUNDINGS = 4
#: Steps for each other grasp that is decided.
STEPS_PER_GRASP = 30_000_000
#: Grasps that are decided on the way to one with another verdict.
_MAX_GRASPS_BETWEEN = 12
#: Where so small a share of the way still turns the verdict, its limit is at the data: no share
#: is the nearest, and each smaller one is slower to decide.
_SMALL_SHARE = Fraction(1, 8**4)
#: Smaller bounds that a proof is tried for, each a quarter of the last.
_MAX_SMALLER_BOUNDS = 3
#: Seconds that one grasp is given at least.
_MIN_SECONDS = 0.01


def _nearest(
    verdict: Verdict, turned: Verdict, bounds: Bounds, deadline: Deadline = NO_DEADLINE
) -> dict[str, Any]:
    """Return a verdict like `turned` of a grasp near, on the straight way between the two grasps.

    A share of the way that turns the verdict, and one that does not, are brought together: by
    factors of 8 as long as all turn it, down to a small share, then by halves. With the verdict
    come the largest changes of a coordinate, an entry of a normal and the values, and a proof for
    smaller bounds, if found.
    """
    ends, effort = (verdict.subject, turned.subject), effort_within(deadline)
    decide = _decider(verdict, deadline, effort)
    low, high = Fraction(0), Fraction(1)
    for _ in range(_MAX_GRASPS_BETWEEN):
        if effort.passed or 4 * low > 3 * high or (not low and high <= _SMALL_SHARE):
            break
        share = (low + high) / 2 if low else high / 8
        other = decide(_between(*ends, share), verdict.load)
        if other is not None and other.verdict == turned.verdict:
            turned, high = other, share
        else:
            low = share
    change = dict.fromkeys(("point", "normal", *VALUES), Fraction(0))
    for old, new in zip(*map(contacts_of, (verdict.subject, turned.subject)), strict=True):
        for name in change:
            one, two = (getattr(c, name) for c in (old, new))
            pairs = [(one, two)] if name in VALUES else zip(one, two, strict=True)
            change[name] = max(change[name], *(abs(x - y) for x, y in pairs))
    tries = _MAX_SMALLER_BOUNDS if _may_be_proved(verdict) and _fits_floats(verdict) else 0
    smaller = (bounds.times(high / 2 / 4**k) for k in range(tries))
    proofs = (proof_for_all(verdict, inner, deadline) for inner in smaller)
    return {"turned": turned, "change": change, "inner": next(filter(None, proofs), None)}


def _between(one: Subject, two: Subject, share: Fraction) -> Subject:
    """Return what is on the way from one grasp, or assembly, to another of as many contacts."""

    def mixed(x: Sequence[Fraction], y: Sequence[Fraction]) -> RationalVector:
        return tuple(a + share * (b - a) for a, b in zip(x, y, strict=True))

    contacts = []
    for old, new in zip(contacts_of(one), contacts_of(two), strict=True):
        normal = old.normal
        if far := max(abs(x - y) for x, y in zip(old.normal, new.normal, strict=True)):
            normal = unit_normal(mixed(old.normal, new.normal), share * far / 1000).normal
        values = mixed(*([getattr(c, name) for name in VALUES] for c in (old, new)))
        place, is_stated = mixed(old.point, new.point), old.stiffness_given
        named: Any = dict(zip(VALUES, values, strict=True))
        contacts.append(Contact(place, normal, **named, stiffness_given=is_stated))
    return with_contacts(one, contacts)


def within_error(verdict: Verdict, deadline: Deadline = NO_DEADLINE) -> WithinError:
    """Decide converted data again: prove the verdict for all, or decide `others`.

    Raises:
        GraspError: the data were not converted.
    """
    bounds, every = _error_bounds(verdict.subject)
    if every and verdict.verdict != OPEN and _may_be_proved(verdict) and _fits_floats(verdict):
        proof = proof_for_all(verdict, bounds, deadline)
        if proof is not None:
            return WithinError(verdict=verdict.verdict, certificate=proof)
    asked, left, reason = 0, 0, ""
    decide = _decider(verdict, deadline)
    for subject in others(verdict, deadline):
        if deadline.passed:
            reason = str(deadline)
            break
        asked += 1
        other = decide(subject, verdict.load)
        if other is None:
            left += 1
        elif verdict.verdict not in (OPEN, other.verdict):
            turned = _nearest(verdict, other, bounds, deadline)
            return WithinError(verdict=DEPENDS, asked=asked, open=left, **turned)
    return WithinError(verdict=verdict.verdict, asked=asked, open=left, reason=reason)


def others(verdict: Verdict, deadline: Deadline = NO_DEADLINE) -> Iterator[Subject]:
    """Yield data within the error: other roundings, and what is most against a verdict.

    A no is about data whose incidences hold, so what breaks them does not speak against it, unless
    the data were taken as given; what has one more incidence, with the load, does.

    Raises:
        GraspError: the data were not converted.
    """
    for seed in range(MAX_ROUNDINGS):
        yield other_rounding(verdict.subject, seed)
    yield from met_within_error(verdict, deadline)
    as_given = known_error(verdict.subject).as_given
    if _fits_floats(verdict) and (verdict.verdict == RESISTED or as_given):
        bounds, _ = _error_bounds(verdict.subject)
        yield from corners(verdict, bounds, _decider(verdict, deadline))


def met_within_error(verdict: Verdict, deadline: Deadline = NO_DEADLINE) -> Iterator[Subject]:
    """Yield data within the error that resist the load of a no by one more incidence, if found.

    Raises:
        GraspError: the data were not converted.
    """
    subject = meeting(verdict, _decider(verdict, deadline)) if _fits_floats(verdict) else None
    if subject is not None:
        yield subject


def _error_bounds(subject: Subject) -> tuple[Bounds, bool]:
    """Return bounds of the error of data, and whether they have all data within it."""
    error, contacts = known_error(subject), contacts_of(subject)
    wanted = {"degrees": error.angle * 113 * 180 / 355}
    for name in VALUES:
        stated = [x for c in contacts if (x := getattr(c, name))]
        wanted[name] = error.value / min(stated, default=1)
    most = {name: Fraction(45 if name == "degrees" else "99/100") for name in wanted}
    bounds = {name: min(x, most[name]) for name, x in wanted.items()}
    return Bounds(length=error.length, **bounds), bounds == wanted


def effort_within(deadline: Deadline) -> Effort:
    """Return the effort for one grasp, within a time limit."""
    if deadline.seconds is None:
        return Effort(STEPS_PER_GRASP)
    return Effort(STEPS_PER_GRASP, max(deadline.remaining, _MIN_SECONDS))


def _decider(verdict: Verdict, deadline: Deadline, effort: Effort | None = None) -> Decide:
    """Return what decides other data in the same way, with an effort for all or one for each."""

    def decide(subject: Subject, load: RationalVector) -> Verdict | None:
        try:
            other = verdict.again(subject, load, effort or effort_within(deadline))
        except (OutOfReachError, TimeLimitError):
            return None
        return None if other.verdict == OPEN else other

    return decide


def robust(verdict: Verdict, bounds: Bounds, deadline: Deadline = NO_DEADLINE) -> Robustness:
    """Decide, if possible, whether a verdict holds for all grasps within bounds.

    Raises:
        GraspError: the verdict is about bounded displacements, or about pyramids, or a contact has
            a constant force, or numbers are too large or small for the search in floats.
    """
    if not _may_be_proved(verdict):
        raise GraspError(
            "whether a verdict holds for all grasps is decided for displacements of any size, "
            "and in space for round cones; leave max_displacement and pyramid out"
        )
    if not all(contact.stiffness for contact in contacts_of(verdict.subject)):
        raise GraspError(
            "whether a verdict holds for all grasps is decided for springs, and a contact has "
            "stiffness 0; give it a small one, or leave the bounds out"
        )
    if not _fits_floats(verdict):
        raise GraspError(
            "whether a verdict holds for all grasps is searched in floats, and the size of load, "
            "points, friction, stiffness, preload, motion or forces is not between 1e-38 and 1e38; "
            "take other units"
        )
    name, answer = verdict.verdict, partial(Robustness, verdict=verdict.verdict, bounds=bounds)
    if name == OPEN:
        return answer(answer=OPEN)
    # The second is about bounds that leave a load at its limit, such as those of preloads 0.
    proof = proof_for_all(verdict, bounds, deadline) or standing_proof(verdict, bounds, verdict)
    if proof is not None:
        return answer(answer=HOLDS, certificate=proof)
    decide = _decider(verdict, deadline)
    for other in corners(verdict, bounds, decide):
        turned = decide(other, verdict.load)
        if turned is not None and turned.verdict != name:
            return answer(answer=FAILS, **_nearest(verdict, turned, bounds, deadline))
        # At the limit: what the weakest grasp balances without room, all of them may.
        if turned and (proof := standing_proof(verdict, bounds, turned)):
            return answer(answer=HOLDS, certificate=proof)
        if deadline.passed:
            return answer(answer=OPEN, reason=str(deadline))
    return answer(answer=OPEN)


def _may_be_proved(verdict: Verdict) -> bool:
    """Return whether there are proofs for all data about such a question."""
    return verdict.max_displacement is None and verdict.pyramid is None


def _fits_floats(verdict: Verdict) -> bool:
    """Return whether products of some numbers of the question and its solution fit floats."""
    contacts = contacts_of(verdict.subject)
    columns = [verdict.load, [x for c in contacts for x in c.point]]
    columns += [[getattr(c, name) for c in contacts] for name in VALUES]
    columns += [[1 / c.stiffness] for c in contacts if c.stiffness]
    if verdict.solution is not None:
        columns += [verdict.solution.motion, [x for f in verdict.solution.forces for x in f]]
    sizes = [max(map(abs, column), default=0) for column in columns]
    return all(1 <= size * 2**128 <= 2**256 for size in sizes if size)
