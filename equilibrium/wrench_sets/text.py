"""The text of resisted sets: magnitudes, margins, slices and more, as lines for people."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Any, NamedTuple

from arrangement.console.number_form import bracket, counted, number, vector
from arrangement.numbers.exact import RationalVector, dot, number_text
from arrangement.numbers.functions import Span
from arrangement.numbers.linear.intervals import Interval
from equilibrium.decide import undecided
from equilibrium.decide.assemblies.ends import Giving, listed_contacts
from equilibrium.decide.nearby import DEPENDS
from equilibrium.model.errors import UndecidedError
from equilibrium.model.labels import AS_ROUNDED, ROUNDED

from .along_in_space import SpatialMagnitudes
from .any_direction import BestDirection, SmallestUnresisted, angle, root
from .friction import TOLERANCE, rough_contacts
from .line import Magnitudes, Margin, Preloads
from .parameter import ResistedValues
from .resisted_set import ResistedSet
from .search_map import SearchMap
from .slice import Region, polygon_cycle
from .sufficient_friction import SufficientFriction

if TYPE_CHECKING:
    from equilibrium.model.assembly import Assembly
    from equilibrium.model.grasp import Grasp


class Answer(NamedTuple):
    """A result as JSON and as lines, and whether it says yes; None is undecided."""

    document: dict[str, Any]
    lines: Iterable[str]
    yes: bool | None


def intervals_text(intervals: Iterable[Interval]) -> str:
    """Return closed intervals in words, such as "[0, 1] or {3/2} or [2, oo)"."""
    shown = [
        f"{{{number(low)}}}"
        if low is not None and low == high
        else ("(-oo" if low is None else f"[{number(low)}")
        + (", oo)" if high is None else f", {number(high)}]")
        for low, high in intervals
    ]
    return " or ".join(shown) if shown else "no interval"


def _where(intervals: Sequence[Interval], nowhere: str, at: str, among: str) -> str:
    """Return where a number lies, in the words for no number, for a single one and for more."""
    if not intervals:
        return nowhere
    ends = {end for part in intervals for end in part}
    if len(ends) == 1 and (point := ends.pop()) is not None:
        return at.format(number(point))
    return among + intervals_text(intervals)


def resisted_text(intervals: Sequence[Interval]) -> str:
    """Return which magnitudes t are resisted, such as "resisted for t in [0, 1] or [2, oo)"."""
    return _where(intervals, "resisted for no t", "resisted at {} only", "resisted for t in ")


def among_text(intervals: Sequence[Interval], name: str) -> str:
    """Return where a number lies: "a preload in [0, 1]", "a preload of 0 only", "no preload"."""
    return _where(intervals, f"no {name}", f"a {name} of {{}} only", f"a {name} in ")


def factors_text(intervals: Sequence[Interval]) -> str:
    """Return by which factors a load may be scaled."""
    return f"resisted when scaled by {among_text(intervals, 'factor')}"


def along_answer(resisted: ResistedSet, magnitudes: Magnitudes) -> Answer:
    """Return the magnitudes that are resisted, what gives at their ends, and other roundings."""
    gives, ends = end_lines(resisted, magnitudes)
    more, lines, depends = _with_rounding(resisted, magnitudes, resisted_text, ends)
    yes = None if depends else bool(magnitudes.intervals)
    return Answer(magnitudes.to_dict() | gives | more, lines, yes)


def end_lines(
    resisted: ResistedSet, magnitudes: Magnitudes | Preloads
) -> tuple[dict[str, Any], list[str]]:
    """Return what gives at the ends of magnitudes or preloads: JSON form and lines."""
    ends = resisted.what_gives(magnitudes)
    lines = [
        f"  at {number(end)}: {giving.words}"
        for interval, pair in zip(magnitudes.intervals, ends, strict=True)
        for end, giving in zip(interval, pair, strict=True)
        if end is not None and giving is not None
    ]
    return {"gives": [[x and x.to_dict() for x in pair] for pair in ends]}, lines


def _with_rounding(
    resisted: ResistedSet,
    magnitudes: Magnitudes,
    text: Callable[[Sequence[Interval]], str],
    ends: Sequence[str],
) -> tuple[dict[str, Any], list[str], bool]:
    """Return what is known of other roundings as JSON, all lines, and whether others differ.

    Args:
        text: of the magnitudes, or factors.
        ends: what gives there.
    """
    stated = text(magnitudes.intervals)
    if resisted.grasp.data_error is None:
        return {}, [stated, *ends], False
    # A wrench of zero has no direction in which others are compared.
    zero = not isinstance(magnitudes.direction, dict) and not any(magnitudes.direction)
    if zero or (again := resisted.within_error(magnitudes)) is None:
        return {"as_rounded": True}, [f"{stated}, {AS_ROUNDED}", *ends], False
    more = {"as_rounded": True, "within_error": again.to_dict()}
    if again.turned is not None:
        other = f"{text(again.turned)}, for other data within the rounding error"
        return more, [f"{DEPENDS}: {other}", f"{ROUNDED}: {stated}", *ends], True
    tried = f"  tried {again.asked} other data within the error: {_tried_text(again.ends)}"
    return more, [f"{stated}, {AS_ROUNDED}", *ends, *([tried] if again.asked else [])], False


def _tried_text(ends: Sequence[tuple[Any, Any] | None]) -> str:
    """Return what all others tried resist, of the least and greatest value of each end."""
    parts = []
    for low, high in zip(ends[::2], ends[1::2], strict=True):
        start = _between(*low) if low else "-oo"
        point = low == high and low is not None and low[0] == low[1]
        until = "on" if high is None else f"to {_between(*high)}"
        parts.append(f"at {start} only" if point else f"from {start} {until}")
    return f"resisted {' and '.join(parts) or 'for no t'}"


def spatial_answer(magnitudes: SpatialMagnitudes) -> Answer:
    """Return the magnitudes tried in space, and the boundaries between them."""
    yes = {"resisted": True, "not resisted": False}.get(magnitudes.verdict)
    gives = magnitudes.what_gives()
    lines, document = list(_border_lines(magnitudes, gives)), magnitudes.to_dict()
    document["gives"] = [giving and giving.to_dict() for giving in gives]
    if magnitudes.grasp.data_error is not None:
        document["as_rounded"] = True
    if (nearby := magnitudes.within_error()) is not None:
        document["within_error"] = [near.to_dict() for near in nearby]
        for near in nearby:
            lines.append(f"at {number(near.t)}: {near.rounding.words}")
    return Answer(document, lines, yes)


def _border_lines(magnitudes: SpatialMagnitudes, gives: Sequence[Giving | None]) -> Iterator[str]:
    runs = [list(run) for _, run in groupby(magnitudes.samples, key=itemgetter(1))]
    known = ", ".join(f"{run[0][1]} at {_samples(run)}" for run in runs)
    tried = counted(len(magnitudes.samples), "magnitude")
    yield f"{tried} t tried from 0 to {number(magnitudes.samples[-1][0])}: {known}"
    doubt = "" if magnitudes.grasp.data_error is None else f", {AS_ROUNDED}"
    if magnitudes.zero_only:
        yield f"resisted at 0 only{doubt}"
        return
    for border, giving in zip(magnitudes.borders, gives, strict=True):
        order = "resisted, then not" if border.resisted < border.refused else "not, then resisted"
        place = f"{number(border.resisted)} exactly" if border.exact else bracket(*border.ends)
        line = f"{order}: the boundary is {place}"
        left = len(border.undecided)
        yield line + (f"; {left} undecided between them" if left else "")
        if giving is not None:
            yield f"  in an equilibrium at {number(border.resisted)}: {giving.words}"
    for a, b in magnitudes.gaps:
        yield f"a gap: not resisted from {number(a.refused)} to {number(b.refused)}"
    yield f"other t, between these and beyond, are not covered: the verdict may change there{doubt}"


def _samples(run: Sequence[tuple[Fraction, str]]) -> str:
    """Return which magnitudes of a run of samples there are: "0", "each from 2 to 16"."""
    low, high = run[0][0], run[-1][0]
    return number(low) if low == high else f"each from {number(low)} to {number(high)}"


def margin_answer(
    resisted: ResistedSet,
    factors: Margin,
    chosen: Sequence[int] | None = None,
    also: Sequence[Sequence[Fraction]] = (),
    tolerance: Fraction = TOLERANCE,
) -> Answer:
    """Return a margin, with the preload and the friction that resist the wrench.

    Args:
        chosen: numbers of the contacts whose preload and friction these are; None: all.
        also: more wrenches that the preload has to resist.
        tolerance: of the friction.
    """
    grasp = resisted.grasp
    whose, rubbing = "uniform preload", "uniform friction"
    if chosen is not None:
        named = listed_contacts(chosen)
        whose, rubbing = f"preload of {named}", f"friction of {named}"
        rubbing += ", for the load alone" if also else ""
    elif smooth := sorted({*grasp.contact_numbers} - {*rough_contacts(grasp)}):
        rubbing += f" with {listed_contacts(smooth)} smooth"
    doubt = "" if grasp.data_error is None else f", {ROUNDED}"
    remedies, texts = dict[str, Any](), list[str]()
    try:
        loads = [factors.wrench, *also]
        preloads = factors.preloads if chosen is None else resisted.preloads(loads, chosen)
    except UndecidedError as unknown:
        remedies["preload"] = undecided(unknown)
        texts.append(f"resisted with a {whose}: undecided, {unknown}")
    else:
        gives, ends = end_lines(resisted, preloads)
        remedies["preload"] = preloads.to_dict() | gives
        among = among_text(preloads.intervals, whose)
        texts += [f"resisted with {among}{_force(grasp)}{doubt}", *ends]
    try:
        friction = factors.friction(tolerance, chosen)
    except UndecidedError as unknown:
        remedies["friction"] = undecided(unknown)
        texts.append(f"least {rubbing}: undecided, {unknown}")
    else:
        remedies["friction"] = friction.to_dict()
        texts.append(f"least {rubbing}: {_friction(friction.low, friction.high)}{doubt}")
    gives, ends = end_lines(resisted, factors.magnitudes)
    more, scaled, changes = _with_rounding(resisted, factors.magnitudes, factors_text, ends)
    known = None if grasp.data_error is None else resisted.solve(factors.wrench).rounding
    word = "yes" if factors.resisted else "no"
    depends = known is not None and known.turned is not None
    if known is not None and not known.proved:
        word += f", {ROUNDED}; it {known.words}" if depends else f", {AS_ROUNDED}"
    is_open = depends or changes or any("verdict" in remedy for remedy in remedies.values())
    yes = None if is_open else factors.resisted
    lines = [f"resisted: {word}", *scaled, *texts]
    return Answer(factors.to_dict() | gives | more | remedies, lines, yes)


def _smallest_lines(smallest: SmallestUnresisted, unit: str) -> Iterator[str]:
    load = "with the base, " if any(smallest.base) else ""
    square = smallest.size_squared
    if square is None or smallest.wrench is None or smallest.beyond is None:
        yield f"{load}every wrench is resisted, whichever way it points and however large it is"
        return
    if square:
        size, exact = _root_text(square)
        squared = "" if exact else f" (its square is {number(square)})"
        yield f"{load}every wrench smaller than {size}{unit}{squared} is resisted"
        length = f"length {number(smallest.length)} (--torque-length)"
        yield f"  where size^2 = f_x^2 + f_y^2 + (tau / length)^2, {length}"
        yield f"on the boundary: {vector(smallest.wrench)}"
    else:
        yield f"{load}no size is resisted in every direction"
    yield f"not resisted: {vector(smallest.beyond)}"


def _direction_lines(best: BestDirection, unit: str) -> Iterator[str]:
    where = f"at {vector(best.point)}"
    if best.holding is not None:
        yield f"the load alone is not resisted; the least force {where} that holds it:"
        yield f"  {_size_text(best.holding, unit)}"
    if best.moving is None or best.beyond is None:
        yield f"in no direction does resistance end at a force {where}, unless that direction alone"
        yield "  is resisted, between others that are not"
        return
    yield f"the least force {where} at which resistance ends as it grows:"
    yield f"  {_size_text(best.moving, unit)}"
    yield f"not resisted: force {vector(best.beyond)}"


def _size_text(force: RationalVector, unit: str) -> str:
    if not any(force):
        return "0: the load alone is on the boundary, or not resisted"
    size, _ = _root_text(dot(force, force))
    return f"{size}{unit} at {angle(force):.4g} degrees from the x axis: {vector(force)}"


def _root_text(square: Fraction) -> tuple[str, bool]:
    """Return a square root as text, and whether it is exact."""
    size = root(square)
    exact = size**2 == square
    return number(size) if exact else number_text(size, longest=0), exact


def _region_lines(region: Region, _: str) -> Iterator[str]:
    many = counted(len(region.polygons), "polygon")
    yield f"{many} (corners counter-clockwise; then rays, lines)"
    for piece in region.polygons:
        shape = piece.polyhedron
        parts = [_points(polygon_cycle(shape))]
        parts += [f"rays {_points(shape.rays)}"] if shape.rays else []
        parts += [f"lines {_points(shape.lines)}"] if shape.lines else []
        yield f"  {' '.join(piece.states)}: {'; '.join(parts)}"
    outline = region.outline
    for name, segments in (("boundary", outline.border), ("whisker", outline.whiskers)):
        for segment in segments:
            start, end = (
                "unbounded" if x is None else vector(x) for x in (segment.start, segment.end)
            )
            yield f"{name} {start} to {end}, direction {vector(segment.direction)}"
    yield from (f"point {vector(point)}" for point in outline.points)
    for sector in region.unlimited:
        ends = f"from {vector(sector.start)} counter-clockwise to {vector(sector.end)}"
        yield f"unbounded: {'all directions' if sector.whole else ends}"


def _set_lines(whole: ResistedSet, _: str) -> Iterator[str]:
    many = counted(len(whole.polyhedra), "polyhedron", "polyhedra")
    yield f"{many} (conditions a f_x + b f_y + c tau + d >= 0 or = 0)"
    for piece in whole.polyhedra:
        yield f"  {' '.join(piece.states)}"
        yield from (f"    {vector(row)} >= 0" for row in piece.polyhedron.inequalities)
        yield from (f"    {vector(row)} = 0" for row in piece.polyhedron.equalities)


def _search_lines(searched: SearchMap, unit: str) -> Iterator[str]:
    tolerance, limit = (f"{number(x)}{unit}" for x in (searched.tolerance, searched.limit))
    yield (
        f"{counted(len(searched.entries), 'direction')}, tolerance {tolerance}, limit {limit}: the "
        f"search errs in {len(searched.disagreements)}"
    )
    for entry in searched.entries:
        answer = "unbounded" if entry.found is None else f"up to {number(entry.found)}{unit}"
        shown = ", ".join(f"{float(x):+.4f}" for x in entry.direction)
        wrong = "" if entry.agrees else f"; exactly {intervals_text(entry.exact)}"
        yield f"  ({shown})  {answer}{wrong}"


def _friction_lines(answer: SufficientFriction, unit: str) -> Iterator[str]:
    least = _friction(answer.low, answer.high)
    yield f"least friction of {listed_contacts(answer.contacts)}: {least}"
    above = answer.from_1
    if above is None:
        yield from _values_lines(answer.up_to_1, unit)
        return
    yield "no friction f up to 1 is proved to be enough"
    yield from _proved_lines(above, _inverse_text, "f above 1", -1)
    for gap in reversed(above.gaps):
        yield f"undecided for {_inverse_text(Span(*gap, has_low=False, has_high=False))}"
    for end in above.ends:
        if end.gives:
            yield f"  in all equilibria at f = {number(1 / end.value)}: {end.gives.words}"
    yield _proof_count(above)


def _inverse_text(span: Span) -> str:
    """Return the values f of which 1/f is in an interval, as inequalities; 1/f = 0 is none."""
    if not span.low:
        return f"f {'>=' if span.has_high else '>'} {number(1 / span.high)}"
    turned = Span(1 / span.high, 1 / span.low, span.has_high, span.has_low)
    return _inequalities(turned, "f", number)


def _values_lines(answer: ResistedValues, _: str) -> Iterator[str]:
    letter, text = answer.family.letter, partial(_letter_text, answer)
    yield from _proved_lines(answer, lambda span: _inequalities(span, letter, text), "value", 1)
    ends = [end for end in answer.ends if end.gap.high - end.gap.low <= answer.tolerance]
    for gap in answer.gaps:
        if gap not in (end.gap for end in ends):
            yield f"undecided {_gap_text(answer, gap)}"
    for end in ends:
        exact = end.gap.low == end.gap.high
        yield f"the end is {f'{text(end.value)} exactly' if exact else _gap_text(answer, end.gap)}"
        if end.gives:
            yield f"  in all equilibria at {text(end.value)}: {end.gives.words}"
    if answer.family.is_angle:
        yield f"degrees are rounded; certificates are about tan({letter}/2)"
    yield _proof_count(answer)


def _proved_lines(
    answer: ResistedValues, text: Callable[[Span], str], name: str, order: int
) -> Iterator[str]:
    """Yield for which values each verdict is proved, in the order of the values or against it."""
    for verdict, spans in (("resisted", answer.resisted), ("not resisted", answer.not_resisted)):
        yield from (f"{verdict} for {text(span)}" for span in spans[::order])
        if not spans:
            yield f"no {name} is proved to be {verdict}"


def _proof_count(answer: ResistedValues) -> str:
    proofs = counted(len(answer.pieces), "certificate")
    return f"{proofs}, each for all values of an interval; --json has them for `equilibrium verify`"


#: How the lines of a result are written, with the unit of forces, and whether it says yes.
_FORMS: dict[type, tuple[Callable[[Any, str], Iterable[str]], Callable[[Any], bool | None]]] = {
    SmallestUnresisted: (_smallest_lines, lambda x: x.size_squared != 0),
    BestDirection: (_direction_lines, lambda x: x.moving is not None),
    Region: (_region_lines, lambda x: bool(x.polygons)),
    ResistedSet: (_set_lines, lambda x: bool(x.polyhedra)),
    SearchMap: (_search_lines, lambda x: not x.disagreements),
    ResistedValues: (_values_lines, lambda x: bool(x.resisted) or (None if x.gaps else False)),
    SufficientFriction: (
        _friction_lines,
        lambda x: x.high is not None or (False if x.impossible else None),
    ),
}


def answer_of(result: Any, subject: Grasp | None = None) -> Answer:
    """Return a result that stands for itself: its document, its lines and whether it says yes.

    Args:
        subject: whose unit of forces is written.
    """
    lines, says_yes = _FORMS[type(result)]
    unit = "" if subject is None else _force(subject)
    return Answer(result.to_dict(), lines(result, unit), says_yes(result))


def _inequalities(span: Span, letter: str, text: Callable[[Fraction], str]) -> str:
    if span.low == span.high:
        return f"{letter} = {text(span.low)}"
    low, high = ("<=" if has else "<" for has in (span.has_low, span.has_high))
    return f"{text(span.low)} {low} {letter} {high} {text(span.high)}"


def _letter_text(answer: ResistedValues, value: Fraction) -> str:
    if answer.family.is_angle:
        return f"{answer.family.degrees(value):.9g} degrees"
    return number(value)


def _gap_text(answer: ResistedValues, gap: tuple[Fraction, Fraction]) -> str:
    if answer.family.is_angle or gap[1] - gap[0] > answer.tolerance:
        return f"between {_letter_text(answer, gap[0])} and {_letter_text(answer, gap[1])}"
    return f"in {bracket(*gap)}"


def _force(grasp: Grasp | Assembly) -> str:
    """Return what to write after a number that is a force."""
    return f" {grasp.units.force}" if grasp.units else ""


def _between(low: Any, high: Any) -> str:
    return number(high) if low == high else bracket(low, high)


def _friction(low: Fraction | None, high: Fraction | None) -> str:
    if low is None:
        return "none is enough"
    if high is None:
        return f"not below {number(low)}; undecided above"
    return _between(low, high)


def _points(points: Iterable[Iterable[Fraction | int]]) -> str:
    return " ".join(map(vector, points))
