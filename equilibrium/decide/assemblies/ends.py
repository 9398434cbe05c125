"""What gives at an end of the resisted magnitudes: which contacts slip or lift off there.

The equilibria at the end are those of all choices of contact states that have one there; each is a
polyhedron. A contact *slips* if it is at its friction limit in all of them, and *lifts off* if it
has no force in any; a pad *tips* if one of its outermost points has all of its force. It gives at
the end if that is not so in all equilibria just inside. A choice of states has equilibria for an
interval of magnitudes, and what holds for all of one magnitude inside holds for all of its
magnitudes: slacks are concave. So the equilibria just inside are those of the choices whose
interval goes on there. Where a single magnitude is resisted nothing is inside: what holds in all
equilibria there is reported, and a contact without force as such, for it need not have had any.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import JsonMixin
from arrangement.numbers import budget
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.intervals import Interval
from equilibrium.core.contact_law import LinearQuestion
from equilibrium.core.contact_program import ContactProgram
from equilibrium.model.effort import Effort
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import Subject, no_load

from .magnitudes import StateTree, complete_programs, part_questions

#: The places of the points of each contact: one, of a pad several, from one end to the other.
Groups: TypeAlias = Sequence[Sequence[int]]
#: Nodes and steps for one end: what takes more is not reported.
_NODES, _STEPS = 200, 5_000_000


@dataclass(frozen=True)
class Giving(JsonMixin):
    """What gives at an end, by numbers of contacts from 1.

    Attributes:
        slips: those that reach their friction limit.
        lifts_off: those that lose their force.
        tips: pads whose force reaches their edge.
        unloaded: where a single magnitude is resisted, those that have no force there.
    """

    json_fields = ("slips", "lifts_off", "tips", "unloaded")

    slips: tuple[int, ...] = ()
    lifts_off: tuple[int, ...] = ()
    tips: tuple[int, ...] = ()
    unloaded: tuple[int, ...] = ()

    def __bool__(self) -> bool:
        """Return whether anything was established."""
        return any((self.slips, self.lifts_off, self.tips, self.unloaded))

    @property
    def words(self) -> str:
        """All that gives, such as "slips at contact 2; contact 1 lifts off"."""
        parts = [f"slips at {listed_contacts(self.slips)}"] if self.slips else []
        if self.lifts_off:
            verb = "lift" if len(self.lifts_off) > 1 else "lifts"
            parts.append(f"{listed_contacts(self.lifts_off)} {verb} off")
        if self.tips:
            pads = "pads" if len(self.tips) > 1 else "pad"
            parts.append(f"the force leaves the {pads} of {listed_contacts(self.tips)}")
        if self.unloaded:
            parts.append(f"no force at {listed_contacts(self.unloaded)}")
        return "; ".join(parts)


def listed_contacts(numbers: Iterable[int]) -> str:
    """Return numbers of contacts in words: "contact 2", "contacts 1, 3"."""
    listed = sorted({*numbers})
    return f"contact{'s' * (len(listed) > 1)} {', '.join(map(str, listed))}"


class _PartQuestion(NamedTuple):
    """What is asked about one part.

    Attributes:
        numbers: of its contacts in the whole, from 1.
    """

    question: LinearQuestion
    groups: Groups
    numbers: Sequence[int]


def ends_of(
    subject: Subject,
    base: Any,
    along: Any,
    intervals: Iterable[Interval],
    max_displacement: Fraction | None = None,
    **preloads: Any,
) -> tuple[tuple[Giving | None, Giving | None], ...]:
    """Return what gives at both ends of each interval of magnitudes.

    Args:
        base, along: wrenches on a grasp in the plane, or on the bodies.
        intervals: the t >= 0 with ``base + t along`` resisted.
        preloads: `preload_slope` and `chosen`, see `LinearQuestion`: what t adds to preloads.

    Returns:
        None where an interval starts at 0 or is unbounded, and where nothing is established; of a
        single magnitude the second of the pair alone answers.
    """
    changes = {"max_displacement": max_displacement, **preloads}
    parts = list(_parts(subject, base, along, changes))

    def at(end: Fraction, way: int) -> Giving | None:
        return _together((x, what_gives(x.question, x.groups, end, way)) for x in parts)

    return tuple(
        (at(low, -1) if low and low != high else None, None if high is None else at(high, 1))
        for low, high in intervals
    )


def _parts(
    subject: Subject, base: Any, along: Any, changes: dict[str, Any]
) -> Iterator[_PartQuestion]:
    for part, question in part_questions(subject, base, along, **changes):
        if isinstance(subject, Grasp):
            places = [dot(c.tangential_wrench[:2], c.point) for c in subject]  # along a pad
            groups = [sorted(points, key=places.__getitem__) for points in subject.groups]
            yield _PartQuestion(question, groups, subject.contact_numbers)
        elif part is not None:
            numbers = [i + 1 for i in part.contacts]
            yield _PartQuestion(question, [[k] for k in range(len(numbers))], numbers)


def _together(given: Iterable[tuple[_PartQuestion, Giving | None]]) -> Giving | None:
    """Return what gives in parts, by the numbers of contacts in the whole; None if nothing does."""
    numbers: dict[str, list[int]] = {name: [] for name in Giving.json_fields}
    for part, giving in given:
        for name, listed in numbers.items() if giving else ():
            listed += [part.numbers[k - 1] for k in getattr(giving, name)]
    return Giving(**{name: tuple(sorted(listed)) for name, listed in numbers.items()}) or None


def what_gives(question: LinearQuestion, groups: Groups, end: Fraction, way: int) -> Giving | None:
    """Return what gives at an end of the magnitudes of a question; None if nothing is established.

    Args:
        groups: by contacts, places in the rows of the question.
        way: 1 at an upper end, -1 at a lower one.
    """
    tree = _tree(question.at(end))
    at_end, inside = [], []
    try:
        for program in complete_programs(tree):
            at_end.append(program)
            whole = ContactProgram(question, program.states, tree.effort)
            low, high = (x.t for x in whole.ends())
            last, first = (high, low) if way > 0 else (low, high)
            if last != end:
                return None  # The end is not one of this question: of another part.
            if first != end:
                inside.append(whole)
        if not at_end:
            return None
        after, before = _given(at_end, groups), _given(inside, groups) if inside else None
    except TimeoutError:
        return None
    if before is None:
        return replace(after, lifts_off=(), unloaded=after.lifts_off) or None
    gone = {*after.lifts_off}
    giving = Giving(
        tuple(k for k in after.slips if k not in {*before.slips, *before.lifts_off}),
        tuple(k for k in after.lifts_off if k not in before.lifts_off),
        tuple(k for k in after.tips if k not in before.tips and k not in gone),
    )
    return giving or None


def limits_of(subject: Subject, load: Any) -> Giving | None:
    """Return which contacts are at a limit in all equilibria of one load; None if none or unknown.

    Those at their friction limit slip; those without force are unloaded.
    """
    parts = list(_parts(subject, load, no_load(subject), {}))
    try:
        programs = [list(complete_programs(_tree(part.question))) for part in parts]
        if not all(programs):
            return None
        given = (_given(own, part.groups) for own, part in zip(programs, parts, strict=True))
        limits = [Giving(x.slips, unloaded=x.lifts_off) for x in given]
    except TimeoutError:
        return None
    return _together(zip(parts, limits, strict=True))


def _tree(question: LinearQuestion) -> StateTree:
    return StateTree(question, Effort.usual(_STEPS), _NODES * budget.times())


def _given(sets: Sequence[ContactProgram], groups: Groups) -> Giving:
    """Return which contacts slip, have no force, or have it at an edge, in all equilibria."""
    points = range(len(sets[0].states))
    unloaded = [[program.is_unloaded(i) for i in points] for program in sets]
    resting = [
        [a or program.is_at_limit(i) for i, a in enumerate(row)]
        for program, row in zip(sets, unloaded, strict=True)
    ]
    never, always = ([*map(all, zip(*rows, strict=True))] for rows in (unloaded, resting))
    return given_at(groups, never, always)


def given_at(groups: Groups, is_unloaded: Sequence[bool], slips_at: Sequence[bool]) -> Giving:
    """Return what gives of contacts whose points have no force, or friction at its limit."""
    slips, lifts, tips = [], [], []
    for number, points in enumerate(groups, 1):
        loaded = [i for i in points if not is_unloaded[i]]
        if not loaded:
            lifts.append(number)
        elif all(slips_at[i] for i in loaded):
            slips.append(number)
        if len(points) > 1 and len(loaded) == 1 and loaded[0] in (points[0], points[-1]):
            tips.append(number)
    return Giving(tuple(slips), tuple(lifts), tuple(tips))
