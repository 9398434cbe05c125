"""Whether a verdict holds for all grasps near the one that was asked about.

For bounds that a user gives there are three answers: it holds, proved (`equilibrium.certificate.
robust`); a grasp within the bounds for which it does not, with a proof of its own; undecided. For
data that were converted (`Grasp.data_error`) the error of the data is such a bound. Where that is
not proved some grasps within the error are asked about, and what turns the verdict is shown.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import Any

from arrangement.console.number_form import ReprMixin, near
from arrangement.errors import OutOfReachError
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector, number_text, to_text
from equilibrium.certificate.document import Certificate
from equilibrium.certificate.robust import read_bounds
from equilibrium.certificate.uncertain import Bounds
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.effort import Effort
from equilibrium.model.errors import GraspError, TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal

from . import RESISTED, UNDECIDED
from .corners import corners
from .proofs_for_all import NO_DEADLINE, proof_for_all, standing_proof

HOLDS = "holds"
FAILS = "does not hold"
OPEN = UNDECIDED
DEPENDS = "depends on the rounding"
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


@dataclass(frozen=True, repr=False, kw_only=True)
class _OtherGrasps(ReprMixin):
    """What became of a verdict when other grasps were asked about.

    Attributes:
        verdict: that of the grasp itself, or "depends on the rounding".
        turned: the verdict on a grasp asked about, if it is another one, and how far that grasp is:
            `change`, see `_nearest`.
        inner: where it is, a proof of the verdict for all grasps within smaller bounds, if found.
        certificate: of the verdict for all grasps asked about, if it holds.
        reason: why the search ended early, if the time limit was over; else empty.
    """

    verdict: str
    reason: str = ""
    turned: Any = field(default=None, repr=False)
    change: dict[str, Fraction] = field(default_factory=dict, repr=False)
    inner: Certificate | None = field(default=None, repr=False)
    certificate: Certificate | None = field(default=None, repr=False)

    def _turned_document(self, name: str) -> dict[str, Any]:
        """Return the JSON form of a verdict that is another one, under a name; empty without."""
        if self.turned is None:
            return {}
        sizes = {key: to_text(x) for key, x in self.change.items()}
        proof = {} if self.inner is None else {"holds_within": self.inner.to_dict()}
        return {name: self.turned.to_dict(), "change": sizes} | proof

    def _turned_lines(self) -> Iterator[str]:
        for i, c in enumerate(self.turned.grasp.joined(), 1):
            point, normal = (", ".join(number_text(x, 10) for x in v) for v in (c.point, c.normal))
            friction = number_text(c.friction)
            yield f"    contact {i}  point ({point})  normal ({normal})  friction {friction}"
        sizes = ", ".join(f"{k} by {near(x, 2)}" for k, x in self.change.items() if x)
        yield f"    largest changes of one number: {sizes}"
        yield "    found by search: a smaller change may turn it, too"
        yield from (f"    {line}" for line in self.turned.warnings)
        if self.inner is not None:
            document = self.inner.to_dict()
            yield f"{document['certificate']} for all {read_bounds(document)}: proved"


@dataclass(frozen=True, repr=False, kw_only=True)
class Robustness(_OtherGrasps):
    """Whether a verdict holds within bounds; true when that is proved.

    Attributes:
        answer: "holds", "does not hold" or "undecided".
        bounds: of the grasps looked at.
    """

    repr_fields = ("answer", "verdict", "bounds")

    answer: str
    bounds: Bounds

    def __bool__(self) -> bool:
        return self.answer == HOLDS

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        document: dict[str, Any] = {"answer": self.answer, "bounds": self.bounds.to_dict()}
        if self.certificate is not None:
            document["certificate"] = self.certificate.to_dict()
        if self.reason:
            document["reason"] = self.reason
        return document | self._turned_document("counterexample")

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.answer == HOLDS:
            yield f"{self.verdict} for all {self.bounds}: proved"
        elif self.turned is None:
            reason = self.reason or "no proof and no counterexample was found"
            yield f"for all {self.bounds}: undecided; {reason}"
        else:
            yield f"not for all {self.bounds}: {self.turned.verdict} for"
            yield from self._turned_lines()


@dataclass(frozen=True, repr=False, kw_only=True)
class WithinError(_OtherGrasps):
    """What became of a verdict when grasps within the error of the data were asked about.

    Where it is proved for all of them, friction and preload that are 0 stay 0, and none was asked.

    Attributes:
        asked: how many others were asked about; `open`: how many of them were undecided.
    """

    repr_fields = ("verdict", "asked", "open", "proved")

    asked: int = 0
    open: int = 0

    @property
    def proved(self) -> bool:
        """Whether the verdict is proved for all grasps within the error."""
        return self.certificate is not None

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        document: dict[str, Any] = {"verdict": self.verdict, "proved": self.proved}
        document |= {"asked": self.asked, "undecided": self.open}
        if self.reason:
            document["reason"] = self.reason
        return document | self._turned_document("turned")

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.proved:
            yield f"{self.verdict} for all grasps within the rounding error: proved"
            return
        if self.turned is None:
            left = f", {self.open} of them undecided" if self.open else ""
            late = f"; {self.reason}" if self.reason else ""
            same = f"{self.asked} other grasps within the rounding error: no other verdict"
            yield f"{same}{left}{late}"
            return
        yield f"{DEPENDS}: {self.turned.verdict} for, within the error of the data,"
        yield from self._turned_lines()


def _nearest(
    found: Any, turned: Any, bounds: Bounds, deadline: Deadline = NO_DEADLINE
) -> dict[str, Any]:
    """Return a verdict like `turned` of a grasp near, on the straight way between the two grasps.

    A share of the way that turns the verdict, and one that does not, are brought together: by
    factors of 8 as long as all turn it, down to a small share, then by halves. With the verdict
    come the largest changes of a coordinate, an entry of a normal and the values, and a proof for
    smaller bounds, if found.
    """
    ends, effort = (found.grasp, turned.grasp), effort_within(deadline)
    low, high = Fraction(0), Fraction(1)
    for _ in range(_MAX_GRASPS_BETWEEN):
        if effort.passed or 4 * low > 3 * high or (not low and high <= _SMALL_SHARE):
            break
        share = (low + high) / 2 if low else high / 8
        other = _soon(found, effort, _between(*ends, share), found.wrench)
        if other is not None and other.verdict == turned.verdict:
            turned, high = other, share
        else:
            low = share
    change = dict.fromkeys(("point", "normal", *VALUES), Fraction(0))
    for old, new in zip(found.grasp.joined(), turned.grasp.joined(), strict=True):
        for name in change:
            one, two = (getattr(c, name) for c in (old, new))
            pairs = [(one, two)] if name in VALUES else zip(one, two, strict=True)
            change[name] = max(change[name], *(abs(x - y) for x, y in pairs))
    return {"turned": turned, "change": change, "inner": _inner(found, bounds, high, deadline)}


def _inner(found: Any, bounds: Bounds, share: Fraction, deadline: Deadline) -> Certificate | None:
    """Return a proof for bounds below a share of the given ones, if one is found."""
    for k in range(_MAX_SMALLER_BOUNDS if _may_be_proved(found) and _fits_floats(found) else 0):
        proof = proof_for_all(found, bounds.times(share / 2 / 4**k), deadline)
        if proof is not None:
            return proof
    return None


def _between(one: Grasp, two: Grasp, share: Fraction) -> Grasp:
    """Return a grasp on the way from one to another of as many contacts."""

    def mixed(x: RationalVector, y: RationalVector) -> RationalVector:
        return tuple(a + share * (b - a) for a, b in zip(x, y, strict=True))

    contacts = []
    for old, new in zip(one.joined(), two.joined(), strict=True):
        normal = old.normal
        if far := max(abs(x - y) for x, y in zip(old.normal, new.normal, strict=True)):
            normal = unit_normal(mixed(old.normal, new.normal), share * far / 1000).normal
        pairs = ([getattr(c, name) for c in (old, new)] for name in VALUES)
        values = {k: x + share * (y - x) for k, (x, y) in zip(VALUES, pairs, strict=True)}
        place, given = mixed(old.point, new.point), old.stiffness_given
        contacts.append(Contact(place, normal, **values, stiffness_given=given))
    return one.spread(contacts)


def within_error(found: Any, deadline: Deadline = NO_DEADLINE) -> WithinError:
    """Decide a converted grasp again: prove the verdict for all, or decide `others`.

    Raises:
        GraspError: the grasp was not converted.
    """
    bounds, every = _error_bounds(found.grasp)
    if every and found.verdict != OPEN and _may_be_proved(found) and _fits_floats(found):
        proof = proof_for_all(found, bounds, deadline)
        if proof is not None:
            return WithinError(verdict=found.verdict, certificate=proof)
    asked, left, reason = 0, 0, ""
    for grasp in others(found, deadline):
        if deadline.passed:
            reason = str(deadline)
            break
        asked += 1
        other = _soon(found, effort_within(deadline), grasp, found.wrench)
        if other is None:
            left += 1
        elif found.verdict not in (OPEN, other.verdict):
            turned = _nearest(found, other, bounds, deadline)
            return WithinError(verdict=DEPENDS, asked=asked, open=left, **turned)
    return WithinError(verdict=found.verdict, asked=asked, open=left, reason=reason)


def others(found: Any, deadline: Deadline = NO_DEADLINE) -> Iterator[Grasp]:
    """Yield grasps within the error of data: other roundings, and what is most against a yes.

    A no is about data whose incidences hold, so what breaks them does not speak against it, unless
    the data were taken as given.

    Raises:
        GraspError: the grasp was not converted.
    """
    for seed in range(MAX_ROUNDINGS):
        yield other_rounding(found.grasp, seed)
    against = found.verdict == RESISTED or found.grasp.data_error.as_given
    if against and _fits_floats(found):
        bounds, _ = _error_bounds(found.grasp)

        def decide(*asked: Any) -> Any:
            return _soon(found, effort_within(deadline), *asked)

        yield from corners(found, bounds, decide)


def _error_bounds(grasp: Grasp) -> tuple[Bounds, bool]:
    """Return bounds of the error of data, and whether they have all grasps within it."""
    error = grasp.data_error
    if error is None:
        raise GraspError("the grasp was not rounded: it has no data_error")
    whole = grasp.joined()
    least = {name: min((x for c in whole if (x := getattr(c, name))), default=1) for name in VALUES}
    wanted = {"degrees": error.angle * 113 * 180 / 355, "length": error.length}
    wanted |= {name: error.value / x for name, x in least.items()}
    given = {
        name: min(x, Fraction(45 if name == "degrees" else "99/100")) for name, x in wanted.items()
    }
    given["length"] = error.length
    return Bounds(**given), given == wanted


def effort_within(deadline: Deadline) -> Effort:
    """Return the effort for one grasp, within a time limit."""
    if deadline.seconds is None:
        return Effort(STEPS_PER_GRASP)
    return Effort(STEPS_PER_GRASP, max(deadline.remaining, _MIN_SECONDS))


def _soon(asked: Any, effort: Effort, grasp: Grasp, wrench: RationalVector) -> Any:
    """Return a verdict that is decided with the effort that is left; else None."""
    try:
        found = asked.again(grasp, wrench, effort)
    except (OutOfReachError, TimeLimitError):
        return None
    return None if found.verdict == OPEN else found


def robust(found: Any, bounds: Bounds, deadline: Deadline = NO_DEADLINE) -> Robustness:
    """Decide, if possible, whether a verdict holds for all grasps within bounds.

    Raises:
        GraspError: the verdict is about bounded displacements, or about pyramids, or a contact has
            a constant force, or numbers are too large or small for the search in floats.
    """
    if not _may_be_proved(found):
        raise GraspError(
            "whether a verdict holds for all grasps is decided for displacements of any size, "
            "and in space for round cones; leave max_displacement and pyramid out"
        )
    if not all(contact.stiffness for contact in found.grasp):
        raise GraspError(
            "whether a verdict holds for all grasps is decided for springs, and a contact has "
            "stiffness 0; give it a small one, or leave the bounds out"
        )
    if not _fits_floats(found):
        raise GraspError(
            "whether a verdict holds for all grasps is searched in floats, and the size of load, "
            "points, friction, stiffness, preload, motion or forces is not between 1e-38 and 1e38; "
            "take other units"
        )
    name, answer = found.verdict, partial(Robustness, verdict=found.verdict, bounds=bounds)
    if name == OPEN:
        return answer(answer=OPEN)
    if proof := proof_for_all(found, bounds, deadline):
        return answer(answer=HOLDS, certificate=proof)

    def decide(grasp: Grasp, wrench: RationalVector) -> Any:
        return _soon(found, effort_within(deadline), grasp, wrench)

    # Bounds that leave a load at its limit, such as those of preloads that are 0.
    if proof := standing_proof(found, bounds, found):
        return answer(answer=HOLDS, certificate=proof)
    for other in corners(found, bounds, decide):
        turned = decide(other, found.wrench)
        if turned is not None and turned.verdict != name:
            return answer(answer=FAILS, **_nearest(found, turned, bounds, deadline))
        # At the limit: what the weakest grasp balances without room, all of them may.
        if turned and (proof := standing_proof(found, bounds, turned)):
            return answer(answer=HOLDS, certificate=proof)
        if deadline.passed:
            return answer(answer=OPEN, reason=str(deadline))
    return answer(answer=OPEN)


def _may_be_proved(found: Any) -> bool:
    """Return whether there are proofs for all grasps about such a question."""
    return found.max_displacement is None and found.pyramid is None


def _fits_floats(found: Any) -> bool:
    """Return whether products of some numbers of the question and its solution fit floats."""
    columns = [found.wrench, [x for c in found.grasp for x in c.point]]
    columns += [[getattr(c, name) for c in found.grasp] for name in VALUES]
    columns += [[1 / c.stiffness] for c in found.grasp if c.stiffness]
    if found.solution is not None:
        columns += [found.solution.motion, [x for f in found.solution.forces for x in f]]
    sizes = [max(map(abs, column), default=0) for column in columns]
    return all(1 <= size * 2**128 <= 2**256 for size in sizes if size)
