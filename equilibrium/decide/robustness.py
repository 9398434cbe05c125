"""Whether a verdict holds for all grasps near the one that was asked about.

For bounds that a user gives there are three answers: it holds, proved (`equilibrium.certificate.
robust`); a grasp within the bounds for which it does not, with a proof of its own; undecided. For
data that were converted (`Grasp.data_error`) some grasps within the error of the data are asked
about, and what turns the verdict is shown.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import islice
from random import Random
from typing import Any, TypeAlias

import numpy as np

from arrangement.console.number_form import Shown
from arrangement.numbers.exact import RationalVector, dot, to_text
from arrangement.numbers.linear.rank import cross
from equilibrium.certificate.robust import Bounds, Steady, refuted_within, resisted_within
from equilibrium.grasps.inputs.incidences import other_rounding
from equilibrium.model.contact import VALUES, Contact
from equilibrium.model.errors import GraspError, TimeLimitError
from equilibrium.model.grasp import Grasp
from equilibrium.model.unit_normal import unit_normal

from . import NOT_RESISTED, RESISTED, UNDECIDED

#: A function of grasp, wrench and time_limit that returns a verdict.
Solve: TypeAlias = Callable[..., Any]

HOLDS, FAILS, OPEN = "holds", "does not hold", UNDECIDED
DEPENDS = "depends on the rounding"
#: Other roundings and random grasps that are asked about.
_ROUNDINGS, _RANDOM = 4, 4
#: For each of them.
_SECONDS = 3.0
#: Grasps that are tried on the way to one that turns a verdict.
_STEPS = 12
#: Virtual motions of one proof that are tried as a way to turn it.
_LEAVES = 3


@dataclass(frozen=True, repr=False)
class Robustness(Shown):
    """Whether a verdict holds within bounds; true when that is proved.

    Attributes:
        answer: "holds", "does not hold" or "undecided".
        verdict: that of the grasp itself.
        bounds: of the grasps looked at.
        counterexample: the verdict on a grasp within the bounds, if it is another one, and how far
            that grasp is: `change`, see `_nearest`.
        proof: what `refuted_within` (a tree) or `resisted_within` (a `Steady`) checks.
    """

    shown_fields = ("answer", "verdict", "bounds")

    answer: str
    verdict: str
    bounds: Bounds
    counterexample: Any = field(default=None, repr=False)
    change: dict[str, Fraction] = field(default_factory=dict, repr=False)
    proof: Any = field(default=None, repr=False)

    def __bool__(self) -> bool:
        return self.answer == HOLDS

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        names = ("degrees", "length", "friction", "stiffness", "preload")
        document: dict[str, Any] = {
            "answer": self.answer,
            "bounds": {name: to_text(getattr(self.bounds, name)) for name in names},
        }
        if self.counterexample is not None:
            document["counterexample"] = self.counterexample.to_dict()
            document["change"] = {name: to_text(x) for name, x in self.change.items()}
        return document

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.answer == HOLDS:
            yield f"{self.verdict} for all {self.bounds}: proved"
        elif self.counterexample is None:
            yield f"for all {self.bounds}: undecided; no proof and no counterexample was found"
        else:
            yield f"not for all {self.bounds}: {self.counterexample.verdict} for"
            yield from _change_lines(self.counterexample.grasp, self.change)


@dataclass(frozen=True, repr=False)
class WithinError(Shown):
    """What became of a verdict when grasps within the error of the data were asked about.

    Attributes:
        verdict: that of the grasp itself, or "depends on the rounding".
        asked: how many others were asked about; `open`: how many of them were undecided.
        turned: a verdict that is another one, if any, of the nearest such grasp found.
        change: how far that grasp is, see `_nearest`.
    """

    shown_fields = ("verdict", "asked", "open")

    verdict: str
    asked: int
    open: int
    turned: Any = field(default=None, repr=False)
    change: dict[str, Fraction] = field(default_factory=dict, repr=False)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        document = {"verdict": self.verdict, "asked": self.asked, "undecided": self.open}
        if self.turned is None:
            return document
        change = {name: to_text(x) for name, x in self.change.items()}
        return document | {"turned": self.turned.to_dict(), "change": change}

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.turned is None:
            left = f", {self.open} of them undecided" if self.open else ""
            yield f"{self.asked} other roundings of the data: no other verdict{left}"
            return
        yield f"{DEPENDS}: {self.turned.verdict} for, within the error of the data,"
        yield from _change_lines(self.turned.grasp, self.change)


def _change_lines(grasp: Grasp, change: dict[str, Fraction]) -> Iterator[str]:
    for i, c in enumerate(grasp, 1):
        point, normal = (", ".join(f"≈{float(x):.10g}" for x in v) for v in (c.point, c.normal))
        friction = f"≈{float(c.friction):.6g}"
        yield f"    contact {i}  point ({point})  normal ({normal})  friction {friction}"
    sizes = ", ".join(f"{k} by ≈{float(x):.2g}" for k, x in change.items() if k != "kept" and x)
    least = f"; ≈{float(change['kept']):.2g} times as much does not turn the verdict"
    yield f"    changed by up to: {sizes}{least if change['kept'] else ''}"


def _nearest(found: Any, turned: Any, solve: Solve) -> tuple[Any, dict[str, Fraction]]:
    """Return a verdict like `turned` of a grasp near, on the straight way between the two grasps.

    A share of the way that turns the verdict, and one that does not, are brought together: by
    factors of 8 as long as all turn it, then by halves. With the verdict come the largest changes
    of a coordinate, an entry of a normal and the values, and "kept": this share of the change does
    not turn the verdict (0: none is known).
    """
    ends, deadline = (found.grasp, turned.grasp), time.monotonic() + _SECONDS
    low, high = Fraction(0), Fraction(1)
    for _ in range(_STEPS):
        share = (low + high) / 2 if low else high / 8
        grasp = _between(*ends, share)
        other = _in_time(solve, grasp, found.wrench)
        if other is not None and other.verdict == turned.verdict:
            turned, high = other, share
        else:
            low = share
        if time.monotonic() > deadline or 4 * low > 3 * high:
            break
    change = dict.fromkeys(("point", "normal", *VALUES), Fraction(0))
    for old, new in zip(found.grasp, turned.grasp, strict=True):
        for name in change:
            one, two = (getattr(c, name) for c in (old, new))
            pairs = [(one, two)] if name in VALUES else zip(one, two, strict=True)
            change[name] = max(change[name], *(abs(x - y) for x, y in pairs))
    return turned, change | {"kept": low / high}


def _between(one: Grasp, two: Grasp, share: Fraction) -> Grasp:
    """Return a grasp on the way from one to another of as many contacts."""

    def mixed(x: RationalVector, y: RationalVector) -> RationalVector:
        return tuple(a + share * (b - a) for a, b in zip(x, y, strict=True))

    contacts = []
    for old, new in zip(one, two, strict=True):
        normal = old.normal
        if far := max(abs(x - y) for x, y in zip(old.normal, new.normal, strict=True)):
            normal = unit_normal(mixed(old.normal, new.normal), share * far / 1000).normal
        pairs = ([getattr(c, name) for c in (old, new)] for name in VALUES)
        values = {k: x + share * (y - x) for k, (x, y) in zip(VALUES, pairs, strict=True)}
        contacts.append(Contact(mixed(old.point, new.point), normal, **values))
    return Grasp(contacts)


class AskedAgain:
    """What verdicts in the plane and in space say of other grasps."""

    grasp: Grasp
    verdict: Any

    @property
    def again(self) -> Solve:
        """What decides other grasps in the same way."""
        raise NotImplementedError

    @cached_property
    def rounding(self) -> WithinError | None:
        """What other grasps within the error of converted data say; None of exact data."""
        return None if self.grasp.data_error is None else within_error(self, self.again)

    @property
    def answer(self) -> str:
        """The verdict, or "depends on the rounding" where the data were converted."""
        return self.verdict if self.rounding is None else self.rounding.verdict

    @property
    def doubt(self) -> str:
        """What is added to a verdict that depends on the rounding; else empty."""
        if self.rounding is None or self.rounding.turned is None:
            return ""
        return f"{DEPENDS}: {self.rounding.turned.verdict} for others within the error of the data"

    def _with_rounding(self, document: dict[str, Any]) -> dict[str, Any]:
        """Return a JSON form with the answer in place of the verdict."""
        more = {} if self.rounding is None else {"within_error": self.rounding.to_dict()}
        return document | {"verdict": self.answer} | more

    def robust(self, **bounds: Any) -> Robustness:
        """Say whether this holds for all grasps within bounds: proved, refuted or undecided.

        Args:
            bounds: of `Bounds`: degrees, length, friction, stiffness, preload.
        """
        return robust(self, Bounds(**bounds), self.again)

    def within_error(self) -> WithinError:
        """Ask about other grasps within the error of the data that this one was converted from.

        Raises:
            GraspError: it was not converted.
        """
        return within_error(self, self.again) if self.rounding is None else self.rounding


def within_error(found: Any, solve: Solve) -> WithinError:
    """Ask again about a converted grasp: the grasps of `others`.

    Raises:
        GraspError: the grasp was not converted.
    """
    asked = left = 0
    for grasp in others(found, solve):
        asked += 1
        other = _in_time(solve, grasp, found.wrench)
        if other is None:
            left += 1
        elif found.verdict not in (OPEN, other.verdict):
            return WithinError(DEPENDS, asked, left, *_nearest(found, other, solve))
    return WithinError(found.verdict, asked, left)


def others(found: Any, solve: Solve) -> Iterator[Grasp]:
    """Yield grasps within the error of data: other roundings, and the change most against a yes.

    A no is about data whose incidences hold, so what breaks them does not speak against it, unless
    the data were taken as given.

    Raises:
        GraspError: the grasp was not converted.
    """
    for seed in range(_ROUNDINGS):
        yield other_rounding(found.grasp, seed)
    error = found.grasp.data_error
    if found.verdict != NOT_RESISTED or error.as_given:
        yield from _against(found, error.length, error.angle, Fraction(0), solve)


def _in_time(solve: Solve, grasp: Grasp, wrench: RationalVector) -> Any:
    """Return a verdict that is decided soon; else None."""
    try:
        found = solve(grasp, wrench, time_limit=_SECONDS)
    except TimeLimitError:
        return None
    return None if found.verdict == OPEN else found


def robust(found: Any, bounds: Bounds, solve: Solve) -> Robustness:
    """Decide, if possible, whether a verdict holds for all grasps within bounds.

    Raises:
        GraspError: the verdict is about a range of motions and forces.
    """
    if found.within:
        raise GraspError(
            f"the verdict is {found.verdict}{found.within}; whether one holds for all grasps is "
            "decided without a largest turn or force"
        )
    name, grasp, wrench = found.verdict, found.grasp, found.wrench
    if name == RESISTED:
        steady = _steady(found)
        if steady is not None and not resisted_within(grasp, wrench, steady, bounds):
            return Robustness(HOLDS, name, bounds, proof=steady)
    elif name == NOT_RESISTED:
        for tree in _trees(found, bounds, solve):
            if not refuted_within(grasp, wrench, tree, bounds):
                return Robustness(HOLDS, name, bounds, proof=tree)
    else:
        return Robustness(OPEN, name, bounds)
    others = _against(found, bounds.length, bounds.angle, bounds.friction, solve)
    for other in (*others, *(_drawn(grasp, bounds, seed) for seed in range(_RANDOM))):
        turned = _in_time(solve, other, wrench)
        if turned is not None and turned.verdict != name:
            return Robustness(FAILS, name, bounds, *_nearest(found, turned, solve))
    return Robustness(OPEN, name, bounds)


def _trees(found: Any, bounds: Bounds, solve: Solve) -> Iterator[Any]:
    """Yield trees that may hold for all: of the grasp itself, and of ones that hold more."""
    yield found.certificate.to_dict()["tree"]
    for factor in (1, 2, 4, 8):
        more = [
            replace(c, friction=c.friction * (1 + factor * bounds.friction) + factor * bounds.angle)
            for c in found.grasp
        ]
        other = _in_time(solve, Grasp(more), found.wrench)
        if other is None or other.verdict != NOT_RESISTED:
            return
        yield other.certificate.to_dict()["tree"]


def _steady(found: Any) -> Steady | None:
    """Return what may show that the equilibrium of a verdict stays; None where none is tried."""
    grasp, n = found.grasp, len(found.wrench)
    motion = np.array(found.solution.motion, float)
    frames = [np.array([c.normal_wrench, *c.tangential_wrenches], float) for c in grasp]
    left, limits = np.array(found.wrench, float), []
    slopes, pillars, sticking = np.zeros((n, n)), [], []
    basis = np.zeros((0, n))
    for i, (c, rows, state) in enumerate(zip(grasp, frames, found.states, strict=True)):
        stiffness, friction = float(c.stiffness), float(c.friction)
        force = float(c.preload) - stiffness * rows[0] @ motion
        limits.append(force * friction)
        if state == "detached":
            continue
        along, slip = rows[0], rows[1:] @ motion
        if state != "stick":
            size = np.linalg.norm(slip)
            if not size:
                return None
            unit = slip / size
            along = rows[0] - friction * unit @ rows[1:]
            bent = (np.eye(len(slip)) - np.outer(unit, unit)) / size
            slopes -= force * friction * rows[1:].T @ bent @ rows[1:]
        left += force * along
        slopes -= stiffness * np.outer(along, rows[0])
        if state != "stick":
            continue
        for j, row in enumerate(rows[1:]):
            sticking.append((i, j))
            if len(basis) < n and np.linalg.svd([*basis, row])[1][-1] > 1e-9 * np.linalg.norm(row):
                basis = np.array([*basis, row])
                pillars.append((i, j))
    # Of the friction forces of sticking contacts, those that are the least shares of their limits.
    shares: list[RationalVector | None] = [
        None if state == "detached" else () for state in found.states
    ]
    if sticking:
        columns = np.array([limits[i] * frames[i][1 + j] for i, j in sticking]).T
        least = np.linalg.lstsq(columns, -left, rcond=None)[0]
        for (i, _), x in zip(sticking, least.tolist(), strict=True):
            share = shares[i] or ()
            shares[i] = (*share, Fraction(x).limit_denominator(2**40))
            c = grasp.contacts[i]
            eased = float(c.stiffness * c.friction) * frames[i][0]
            slopes -= x * np.outer(frames[i][len(share) + 1], eased)
    whole = np.block([[slopes, basis.T], [basis, np.zeros((len(basis), len(basis)))]])
    try:
        inverse = np.linalg.inv(whole)
    except np.linalg.LinAlgError:
        return None
    centre = (*map(_rational, motion), *[Fraction(0)] * len(pillars))
    matrix = tuple(tuple(map(_rational, row)) for row in inverse)
    return Steady(tuple(shares), tuple(pillars), centre, matrix)


def _rational(x: float) -> Fraction:
    return Fraction(float(x))


def _against(
    found: Any, length: Fraction, angle: Fraction, friction: Fraction, solve: Solve
) -> Iterator[Grasp]:
    """Yield grasps at the corner of bounds that is most against a verdict, for some motions.

    On a virtual motion contacts do at least ``lambda . N - friction |lambda . T|`` times their
    normal forces. Each contact is changed so that this is more, against a yes, or less.
    """
    yes = found.verdict == RESISTED
    motions: list[RationalVector] = []
    if found.solution is not None:
        motions.append(tuple(map(Fraction, found.solution.motion)))
        loads = [tuple(x * (1 + more) for x in found.wrench) for more in (Fraction(1, 100), 1)]
        proofs = [_in_time(solve, found.grasp, load) for load in loads]
    else:
        proofs = [found]
    for proof in proofs:
        if proof is not None and proof.verdict == NOT_RESISTED:
            leaves = _leaves(proof.certificate.to_dict()["tree"], len(found.wrench))
            motions += islice(leaves, _LEAVES)
    for motion in motions:
        if any(motion):
            sign = 1 if yes else -1
            yield Grasp(_corner(c, motion, sign, length, angle, friction) for c in found.grasp)


def _leaves(node: Any, n: int) -> Iterator[RationalVector]:
    """Yield the virtual motions of a tree, of n numbers each."""
    if isinstance(node, list) and len(node) == n and not isinstance(node[0], (dict, list)):
        yield tuple(map(Fraction, node))
    elif isinstance(node, dict) and "virtual_motion" in node:
        yield tuple(map(Fraction, node["virtual_motion"]))
    elif isinstance(node, (dict, list)):
        for child in node.values() if isinstance(node, dict) else node:
            yield from _leaves(child, n)


def _corner(
    c: Contact,
    motion: RationalVector,
    sign: int,
    length: Fraction,
    angle: Fraction,
    friction: Fraction,
) -> Contact:
    slips = [sign * dot(row, motion) for row in c.tangential_wrenches]
    turned, place = c.normal, c.point
    largest = max(map(abs, slips))
    if angle and largest:
        shares = [Fraction(x / largest).limit_denominator(100) for x in slips]
        turn = angle * Fraction(9, 10)
        if len(shares) == 2:
            turn /= Fraction(3, 2) if all(shares) else 1
        away = [dot(shares, column) for column in zip(*c.tangents, strict=True)]
        wanted = [x + turn * y for x, y in zip(c.normal, away, strict=True)]
        turned = unit_normal(wanted, angle / 20).normal
    if length:
        omega = motion[3:] if c.dimension == 3 else (Fraction(0), Fraction(0), motion[2])
        grows = cross((*c.normal, *[Fraction(0)] * (3 - c.dimension)), omega)
        place = tuple(
            x + sign * length * ((g > 0) - (g < 0)) for x, g in zip(place, grows, strict=False)
        )
    return Contact(place, turned, c.friction * (1 - sign * friction), c.stiffness, c.preload)


def _drawn(grasp: Grasp, bounds: Bounds, seed: int) -> Grasp:
    """Return a random grasp within bounds, the same for the same seed."""
    source = Random(f"robust {seed}")

    def share() -> Fraction:
        return Fraction(source.randint(-8, 8), 8)

    found = []
    for c in grasp:
        normal = c.normal
        if bounds.angle:
            turns = [share() * bounds.angle * Fraction(3, 5) for _ in c.tangents]
            across = [dot(turns, column) for column in zip(*c.tangents, strict=True)]
            wanted = [x + y for x, y in zip(normal, across, strict=True)]
            normal = unit_normal(wanted, bounds.angle / 20).normal
        place = [x + share() * bounds.length for x in c.point]
        values = [
            getattr(c, name) * (1 + share() * getattr(bounds, name))
            for name in ("friction", "stiffness", "preload")
        ]
        found.append(Contact(place, normal, *values))
    return Grasp(found)
