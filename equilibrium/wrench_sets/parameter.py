"""For which values of a parameter a load is resisted, proved for whole intervals at once.

Each question that is decided at one value has a proof; its numbers, or the solution of the same
contact states as a function of the letter, are checked for an interval around the value by
`equilibrium.certificate.parameter`. A comparison without one answer parts the interval at its
roots. What is left between proofs is asked again, beside them and in its middle, until it is no
wider than a tolerance. So nothing is sampled: each value is in an interval with a proof, or in a
gap that is named.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from arrangement.console.number_form import ReprMixin
from arrangement.console.plugins import method_code
from arrangement.hints import hints_on_arguments
from arrangement.library.files.json_files import Source
from arrangement.numbers.exact import rational, shown, simplest_between, to_text
from arrangement.numbers.functions import Domain, Function, Span
from arrangement.numbers.linear.programs import Optimal, minimize
from equilibrium.certificate.leaf_rule import TreeQuestion
from equilibrium.certificate.parameter import (
    ParameterReport,
    check_parameter,
    decided_problem,
    form_of,
    function_rows,
    parameter_entry,
    parameter_problem,
    question_entry,
)
from equilibrium.certificate.reading import SCHEMA_VERSION, Place
from equilibrium.certificate.tree import placed_leaves
from equilibrium.core.contact_law import ContactState, LinearQuestion, State
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contacts import IntegerContacts
from equilibrium.decide.assemblies.ends import Giving, limits_of
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.parameter import read_parametric
from equilibrium.model.errors import GraspError
from equilibrium.model.parameter import ParametricQuestion, interval
from equilibrium.model.rows import ContactRow, ContactRows
from equilibrium.model.solution import Leaf, Solution, with_leaves
from equilibrium.model.synonyms import ARGUMENTS
from equilibrium.plane.search.motion_regions import HALF_SPACE
from equilibrium.plane.search.region_states import StateSplits, TooManyParts

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing

#: The largest gap between proofs, if none is given.
TOLERANCE = Fraction(1, 10**6)
#: Questions that are asked at most.
_MOST_QUESTIONS = 200
#: The keys of a proof in a certificate.
_PROOF = ("motion", "forces", "tree")
#: Programs for a proof by states alone.
_MOST_PROGRAMS = 100


class Piece(NamedTuple):
    """An interval of values with one proof.

    Attributes:
        verdict: "resisted" or "not resisted".
        proof: "motion" and "forces", or "tree".
    """

    span: Span
    verdict: str
    proof: Mapping[str, Any]


class Gap(NamedTuple):
    """Values between two proofs of which none is about; of an exact end both are equal."""

    low: Fraction
    high: Fraction


class End(NamedTuple):
    """An end of a resisted interval.

    Attributes:
        value: which is resisted.
        is_low: whether the interval begins there.
        gap: the values beside it of which nothing is proved; both ends are equal if there are none.
        gives: contacts at their friction limit, or without force, in all equilibria there, if that
            is known.
    """

    value: Fraction
    is_low: bool
    gap: Gap
    gives: Giving | None


@dataclass(frozen=True, repr=False)
class ResistedValues(ReprMixin):
    """The answers for all values of a parameter.

    Attributes:
        family: the questions.
        between: the values asked about.
        pieces: intervals with proofs, in order.
        gaps: what is not proved, in order; each is no wider than the tolerance, unless
            `complete` is false.
        complete: whether no gap is wider than the tolerance.
        tolerance: of an angle, that of the tangent of its half.
    """

    family: ParametricQuestion
    between: Span
    pieces: tuple[Piece, ...]
    gaps: tuple[Gap, ...]
    complete: bool = True
    tolerance: Fraction = TOLERANCE
    repr_fields = ("resisted", "not_resisted", "gaps")

    @property
    def resisted(self) -> tuple[Span, ...]:
        """The intervals of values at which the load is proved to be resisted."""
        return self._joined("resisted")

    @property
    def not_resisted(self) -> tuple[Span, ...]:
        """The intervals of values at which it is proved that nothing balances the load."""
        return self._joined("not resisted")

    def _joined(self, verdict: str) -> tuple[Span, ...]:
        joined: list[Span] = []
        for span in (piece.span for piece in self.pieces if piece.verdict == verdict):
            both = joined[-1].joined(span) if joined else None
            joined[-1 if both else len(joined) :] = [both or span]
        return tuple(joined)

    def verdict_at(self, value: Any) -> str:
        """Return what is proved at a value, or "undecided"."""
        asked = rational(value, "the value")
        return next((p.verdict for p in self.pieces if asked in p.span), "undecided")

    @cached_property
    def certificates(self) -> tuple[dict[str, Any], ...]:
        """The certificate of each piece, as `equilibrium.verify` takes it."""
        return tuple(
            {
                "schema_version": SCHEMA_VERSION,
                "certificate": piece.verdict,
                "parameter": parameter_entry(self.family.letter, piece.span),
                **question_entry(self.family),
                **piece.proof,
            }
            for piece in self.pieces
        )

    def verify(self) -> list[ParameterReport]:
        """Check all certificates again."""
        return [check_parameter(document) for document in self.certificates]

    @cached_property
    def ends(self) -> tuple[End, ...]:
        """The ends inside the values asked about, of resisted intervals, in order."""
        ends = []
        for span in self.resisted:
            for value, is_low in ((span.low, True), (span.high, False)):
                if value not in (self.between.low, self.between.high):
                    beside = (gap for gap in self.gaps if value in gap)
                    gap = next(beside, Gap(value, value))
                    ends.append(End(value, is_low, gap, limits_of(*self.family.at(value))))
        return tuple(ends)

    def draw(self, **options: Any) -> Drawing:
        """Draw the verdict along the letter, and the object where resistance ends.

        Args:
            options: width, in millimetres.
        """
        drawing: Drawing = method_code("ResistedValues.draw")(self, **options)
        return drawing

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""

        def forms(spans: Iterable[Span]) -> list[Any]:
            entries = (parameter_entry(self.family.letter, span) for span in spans)
            return [{key: x for key, x in one.items() if key != "letter"} for one in entries]

        of = f"tan({self.family.letter}/2)" if self.family.is_angle else self.family.letter
        return {
            "parameter": parameter_entry(self.family.letter, self.between),
            "values_of": of,
            "resisted": forms(self.resisted),
            "not_resisted": forms(self.not_resisted),
            "undecided": [{"from": to_text(a), "to": to_text(b)} for a, b in self.gaps],
            "ends": [
                {"value": to_text(end.value), "gives": end.gives and end.gives.to_dict()}
                for end in self.ends
            ],
            "complete": self.complete,
            **question_entry(self.family),
            "certificates": list(self.certificates),
        }


@hints_on_arguments(ARGUMENTS)
def resisted_values(
    source: Source | ParametricQuestion,
    low: Any,
    high: Any,
    *,
    letter: str = "t",
    wrench: Any = None,
    tolerance: Any = TOLERANCE,
) -> ResistedValues:
    """Return for which values of a letter a question has an equilibrium.

    Args:
        source: a document or a table whose numbers may be expressions in the letter, see
            `equilibrium.grasps.inputs.parameter.read_parametric`.
        low, high: the values asked about; of an angle in degrees.
        letter: its name.
        wrench: on the grasp, or on the bodies of an assembly, in place of that of the source.
        tolerance: the largest width of what may be left unproved between two proofs.

    Returns:
        Intervals with a proof each, and the gaps between them.

    Raises:
        InputError: expressions that cannot be read, or numbers out of range at some value.

    Complexity: each proof is checked with polynomials, whose degree is some ten times that of the
    data at most. Source: `docs/proofs.rst`, "All values of a parameter".

    >>> ladder = {"schema_version": 1, "contacts": [
    ...     {"point": ["0", "0"], "normal": ["0", "1"], "friction": "t"},
    ...     {"point": ["4", "3"], "normal": ["-1", "0"], "friction": "0"}],
    ...     "wrench": ["0", "-1", "-2"]}
    >>> answer = resisted_values(ladder, 0, 1)
    >>> [str(span) for span in answer.resisted], answer.gaps
    (['[2/3, 1]'], ())
    """
    is_read = isinstance(source, ParametricQuestion)
    family: Any = source if is_read else read_parametric(source, letter, wrench)  # type: ignore[arg-type]
    asked = interval(low, high)
    return proved_values(family, Span(*map(family.value, (asked.low, asked.high))), tolerance)


def proved_values(
    family: ParametricQuestion, between: Span, tolerance: Any = TOLERANCE
) -> ResistedValues:
    """Return what `resisted_values` does, for an interval that may be open; of an angle of u."""
    width = rational(tolerance, "tolerance")
    if width <= 0:
        raise GraspError(f"tolerance is {shown(tolerance)}; it must be above 0")
    return _Search(family, between, width).answer()


class _Search:
    """Asks at values of gaps, until each is narrow."""

    def __init__(self, family: ParametricQuestion, between: Span, tolerance: Fraction) -> None:
        self.family, self.between, self.tolerance = family, between, tolerance
        self.pieces: list[Piece] = []
        self.asked: dict[Fraction, str] = {}
        #: Ends of gaps near which a value was asked.
        self.near: set[Fraction] = set()
        family.check(between)

    def answer(self) -> ResistedValues:
        """Return the answer."""
        while len(self.asked) < _MOST_QUESTIONS and (value := self._next_value()):
            self._ask(*value)
        gaps = tuple(Gap(gap.low, gap.high) for gap in self._gaps())
        complete = all(gap.high - gap.low <= self.tolerance for gap in gaps)
        merged: list[Piece] = []
        for piece in self.pieces:
            while merged and (both := self._union(merged[-1], piece)):
                merged.pop()
                piece = both
            merged.append(piece)
        known = tuple(merged), gaps, complete, self.tolerance
        return ResistedValues(self.family, self.between, *known)

    def _union(self, one: Piece, other: Piece) -> Piece | None:
        """Return one piece in place of two neighbours, if one of their proofs holds for both."""
        span = one.span.joined(other.span)
        if one.verdict != other.verdict or span is None:
            return None
        for piece in (other, one):
            if not parameter_problem(self.family, span, piece.proof)[1]:
                return piece._replace(span=span)
        return None

    def _gaps(self) -> list[Span]:
        """Return the intervals of values without a proof, in order."""
        return self.between.without(piece.span for piece in self.pieces)

    def _next_value(self) -> tuple[Fraction, Span] | None:
        """Return a value to ask at and the gap that it is in; None if there is none left.

        That is an end that belongs to a gap, then near an end, once, and then inside.
        """
        for gap in sorted(self._gaps(), key=lambda gap: gap.low - gap.high):
            width = gap.high - gap.low
            values = [x for x, has in ((gap.low, gap.has_low), (gap.high, gap.has_high)) if has]
            if width > self.tolerance:
                near = min(self.tolerance / 2, width / 4)
                for end, way in ((gap.high, -1), (gap.low, 1)):
                    if end not in self.near:
                        beside = sorted((end + way * near / 2, end + way * near))
                        values.append(simplest_between(*beside))
            if width > self.tolerance / (8 if self._is_between_equals(gap) else 1):
                places = (gap.low + width * Fraction(k, 8) for k in (4, 2, 6, 1, 3, 5, 7))
                values += [simplest_between(x - width / 20, x + width / 20) for x in places]
            for value in values:
                if value not in self.asked:
                    return value, gap
        return None

    def _is_between_equals(self, gap: Span) -> bool:
        """Return whether no end of the resisted values is in a gap, as far as it can be seen."""
        below = {p.verdict for p in self.pieces if gap.low == p.span.high}
        above = {p.verdict for p in self.pieces if gap.high == p.span.low}
        return len(below | above) == 1

    def _ask(self, value: Fraction, gap: Span) -> None:
        """Decide at a value, and add what its proof proves."""
        verdict: Any = solve(*self.family.at(value))
        self.asked[value] = verdict.verdict
        if verdict.verdict == "undecided":
            return
        best: Piece | None = None
        for proof in self._proofs(value, gap, verdict):
            span = self._reach(proof, value, gap)
            if span is None:
                continue
            if best is None or span.high - span.low > best.span.high - best.span.low:
                best = Piece(span, verdict.verdict, proof)
            if (span.low, span.high) == (gap.low, gap.high):
                break
        # A single value inside would part the gap for nothing.
        if best and (best.span.low < best.span.high or value in (gap.low, gap.high)):
            self.pieces.append(best)
            self.pieces.sort(key=lambda piece: (piece.span.low, piece.span.high))
            if min(value - gap.low, gap.high - value) <= self.tolerance:
                self.near |= {best.span.low, best.span.high}

    def _proofs(self, value: Fraction, gap: Span, verdict: Any) -> Iterator[Mapping[str, Any]]:
        """Yield proofs that hold at a value, those first that may hold far from it."""
        family, carrier = self.family, _Carrier(self.family, value)
        if verdict.solution is not None:
            for slips in (False, True):
                carried = carrier.equilibrium(verdict.solution, slips_at_limit=slips)
                if carried is not None:
                    yield carried
        elif (by_states := self._tree_by_states(value, verdict.tree)) is not None:
            is_narrow = gap.high - gap.low <= self.tolerance
            # Of an assembly leaves are rounded, and so near their conditions.
            for room in (1, 0) if is_narrow else (0,) if family.names is None else (-1, 0):
                yield {"tree": carrier.tree(by_states, room)}
        yield {key: verdict.proof[key] for key in _PROOF if key in verdict.proof}

    def _tree_by_states(self, value: Fraction, tree: Any) -> Any:
        """Return a proof at a value by states alone, if there is one that is not too long."""
        if self.family.names is not None:
            return None if isinstance(tree, dict) and "part" in tree else tree
        grasp: Any
        grasp, wrench = self.family.at(value)
        rows = ContactRows.of_grasp(grasp)
        question = IntegerContacts(rows), rows.total_load(wrench)
        try:
            return StateSplits(*question, HALF_SPACE, _MOST_PROGRAMS).decide()
        except TooManyParts:
            return None

    def _reach(self, proof: Mapping[str, Any], value: Fraction, gap: Span) -> Span | None:
        """Return the interval around a value, or on one side of it, where a proof holds."""
        domain = Domain(gap, value, self.tolerance / 8, self.family.letter)
        try:
            return None if decided_problem(self.family, domain, proof)[1] else domain.span
        except ZeroDivisionError:
            return None


class _Everywhere(Domain):
    """Of functions as such: what is 0 at a value alone is not 0."""

    def decide(self, polynomial: Any, wanted: set[int]) -> bool:
        """Return whether a polynomial is 0, or is not."""
        return (0 in wanted) != bool(polynomial)


class _Carrier:
    """Proofs at a value, with functions of the letter in place of their numbers."""

    def __init__(self, family: ParametricQuestion, value: Fraction) -> None:
        self.family, self.value = family, value
        self.domain = Domain(Span(value, value), letter=family.letter)
        self.zero: Any = Function.constant(0, _Everywhere(self.domain.span, letter=family.letter))

    @cached_property
    def question(self) -> LinearQuestion:
        """The question in functions of the letter that have no answers for single values."""

        def functions(row: Iterable[Any]) -> tuple[Any, ...]:
            return tuple(self.zero + x for x in row)

        rows = tuple(
            ContactRow(functions(along), (functions(across),), *functions(values))
            for (along, across), *values in function_rows(self.family, self.domain)
        )
        load = functions(self.family.load(self.domain))
        return LinearQuestion(ContactRows(rows, (), (False,) * len(load), 1), load)

    def equilibrium(self, solution: Solution, *, slips_at_limit: bool) -> Mapping[str, Any] | None:
        """Return motion and forces of the same contact states.

        Unknowns that balance and states leave open keep their values.

        Args:
            slips_at_limit: whether contacts that stick with friction at its limit may slip.
        """
        question, d, states = self.question, solution.motion, list[State]()
        known = [*d]
        row: Any
        for row, (normal, friction) in zip(question.rows, solution.forces, strict=True):
            slip = self._sum(row.tangential_wrenches[0], d)
            limit = row.friction.at(self.value) * normal
            if not normal:
                states.append("detached")
            elif not limit or slip or (abs(friction) == limit and slips_at_limit):
                share = (friction > 0) - (friction < 0)
                states.append(ContactState("attached", share=(share,)))
            else:
                states.append("stick")
                known.append(friction)
        program = ContactProgram(question, tuple(states))
        lines = [[self.zero + x for x in row] for row in program.equations]
        solved = self._solved([lines], known)
        if solved is None:
            return None
        at = program.values(solved)
        return {
            "motion": self._motion(solved[: len(d)]),
            "forces": [[(self.zero + at.of(x)).text() for x in pair] for pair in program.forces],
        }

    def tree(self, tree: Any, room: int) -> Any:
        """Return a tree by states alone.

        Args:
            room: of the leaves at the value: 1 for most room, -1 for least, 0 for those of the
                tree. A leaf with most room holds on both sides of the value, but less far than the
                one given.
        """
        rows, load = function_rows(self.family, self.domain), self.family.load(self.domain)
        form = form_of(self.family, lambda number, _: Fraction(number))
        carried = {
            id(leaf): self._leaf(room, leaf, place)
            for leaf, place in placed_leaves(tree, TreeQuestion(rows, load, form))
        }
        return with_leaves(tree, lambda leaf: carried[id(leaf)])

    def _leaf(self, room: int, leaf: Leaf, place: Place) -> Any:
        """Return a leaf of a tree.

        It solves linear equations. What depends on the displacement cancels. As far as they are
        independent, there follow what holds at the value: multipliers are 0, or as large as
        possible, and a contact does not slip on the virtual motion.
        """
        zero, question = self.zero, self.question
        n, m = len(leaf.motion), len(question.rows)
        size = n + 2 * m

        def equation(terms: Sequence[Any], k: int = 0, factor: int = 0) -> list[Any]:
            row = [*terms, *[zero] * (size + 1 - len(terms))]
            row[k] += factor
            return row

        values, balance = [*leaf.motion], [equation([]) for _ in leaf.motion]
        conditions, slips = list[list[Any]](), list[list[Any]]()
        decided, pushes = list[bool](), [zero] * (2 * m)
        for i in range(m):
            state = str(place.states.get(i, "undecided"))
            spring, slip = question.symbols["spring", i], question.symbols["slip", i, 0]
            k = n + 2 * i
            pushes[2 * i] = spring.get(-1, zero)
            for j, line in enumerate(balance[:n]):
                line[k], line[k + 1] = spring.get(j, zero), slip.get(j, zero)
            if state in ("undecided", "detached"):
                conditions.append(equation([], k, 1))
            sign = {"slip+": 1, "slip-": -1}.get(state, 0)
            if sign:
                conditions.append(equation([], k + 1, -sign))
            elif state != "stick":
                balance.append(equation([], k + 1, 1))
            for wrench in question.unit_wrenches(i, state) if state != "detached" else ():
                conditions.append(equation([zero + x for x in wrench], k, -1))
            if not sign and not question.is_smooth(i):
                slips.append(equation([slip.get(j, zero) for j in range(n)]))
            decided.append(bool(place.region) and state not in ("undecided", "detached"))
            values += leaf.multipliers.get(i, (Fraction(0), Fraction(0)))
        if room:
            work = question.rows.total_load(question.load)
            values = self._with_room(conditions, balance, equation([*work, *pushes]), room)
        zeros = [equation([], k, 1) for k in range(n, size) if not values[k]]
        tight = [row for row in (*conditions, *slips) if not self._sum(row, values)]
        solved = self._solved([balance, zeros, tight], values)
        assert solved is not None  # Nothing is constant in these equations.
        pairs = [solved[n + 2 * i : n + 2 * i + 2] for i in range(m)]
        multipliers = {
            str(i): [x.text() for x in pair]
            for i, pair in enumerate(pairs)
            if decided[i] or any(x.top for x in pair)
        }
        motion = self._motion(solved[:n])
        is_short = isinstance(motion, list) and not multipliers
        return motion if is_short else {"virtual_motion": motion, "multipliers": multipliers}

    def _sum(self, row: Sequence[Any], values: Sequence[Fraction]) -> Fraction:
        """Return the sum of a row without its constant, with these unknowns, at the value."""
        pairs = zip(row, values, strict=False)
        return sum((x.at(self.value) * y for x, y in pairs), Fraction(0))

    def _with_room(
        self,
        conditions: Sequence[Sequence[Any]],
        equations: Sequence[Sequence[Any]],
        work: Sequence[Any],
        room: int,
    ) -> list[Fraction]:
        """Return unknowns with which the work is 1, and conditions are far above 0 or near it.

        Args:
            room: 1: each condition is above 0 that is so for some unknowns; rows are homogeneous,
                so it may be 1. -1: their sum is the least.
        """
        size, count = len(work) - 1, len(conditions)

        def row(terms: Sequence[Any], slack: int = -1, constant: int = 0) -> list[Fraction]:
            slacks = [Fraction(-(k == slack)) for k in range(count)]
            return [*(x.at(self.value) for x in terms[:size]), *slacks, Fraction(constant)]

        bounds = [
            [Fraction(sign * (j == size + k)) for j in range(size + count)] + [Fraction(sign < 0)]
            for k in range(count)
            for sign in ((1, -1) if room > 0 else (1,))
        ]
        found = minimize(
            [*[Fraction(0)] * size, *[Fraction(-room)] * count],
            [*(row(terms, k) for k, terms in enumerate(conditions)), *bounds],
            [*map(row, equations), row(work, constant=-1)],
        )
        assert isinstance(found, Optimal)  # There is the leaf of the tree.
        return list(found.point[:size])

    def _motion(self, motion: Sequence[Any]) -> Any:
        texts, names = [x.text() for x in motion], self.family.names
        if names is None:
            return texts
        return {x: texts[3 * k : 3 * k + 3] for k, x in enumerate(names)}

    def _solved(
        self, blocks: Sequence[Sequence[list[Any]]], values: Sequence[Fraction]
    ) -> list[Any] | None:
        """Solve linear equations ``row . x + constant = 0``, block by block, by elimination.

        Unknowns without a pivot keep their values. Pivots are chosen by their sizes at the value,
        and equations that follow there from those before them are left out.
        """

        def less(line: list[Any], other: list[Any], j: int) -> list[Any]:
            return (
                [x - line[j] * y for x, y in zip(line, other, strict=True)] if line[j].top else line
            )

        def largest(line: list[Any]) -> Fraction:
            sizes = (abs(x.at(self.value)) for x in line[:-1])
            return max(sizes, default=Fraction(0))

        pivots: list[tuple[int, list[Any]]] = []
        for block in blocks:
            rest = list(block)
            for j, other in pivots:
                rest = [less(line, other, j) for line in rest]
            while rest:
                line = rest.pop(max(range(len(rest)), key=lambda k: largest(rest[k])))
                if not (size := largest(line)):
                    if any(other[-1].at(self.value) for other in (line, *rest)):
                        return None
                    break
                j = next(k for k, x in enumerate(line) if abs(x.at(self.value)) == size)
                line = [x / line[j] if x.top else x for x in line]
                rest = [less(other, line, j) for other in rest]
                pivots = [(k, less(other, line, j)) for k, other in pivots] + [(j, line)]
        known: list[Any] = [self.zero + x for x in values]
        chosen = {j for j, _ in pivots}
        for j, line in pivots:
            terms = (x * values[k] for k, x in enumerate(line[:-1]) if k not in chosen and x.top)
            known[j] = sum(terms, line[-1]) * -1
        return known
