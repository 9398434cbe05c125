"""Claims on the two result tables, every printed verdict, force and motion, and their text."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import product

from equilibrium.decide.solver import Solver
from equilibrium.wrench_sets.line import resisted_magnitudes
from proofs_check.instances import printed
from proofs_check.instances.grasps import grasp_case, grasp_of, paper_question
from proofs_check.routes import oracle
from proofs_check.routes.oracle import Question, Row
from proofs_check.statements.statement import Case

from .stated import stated

TINY = Fraction(1, 10**30)


@dataclass(frozen=True)
class TableRow:
    """A printed row in numbers."""

    question: Question
    stable: bool
    forces: tuple[Row, ...] = ()
    motion: Row = ()


def _rows(
    contacts: Iterable[Sequence[int]], rows: Iterable[printed.PrintedRow], _rng: random.Random
) -> Iterator[Case]:
    listed = tuple(contacts)
    for row in rows:
        cells = (row.wrench, *row.forces, *([row.motion] if row.motion else []))
        readings = [printed.read_vector(cell) for cell in cells]
        wrench, *forces = [numbers for numbers, _ in readings]
        motion = forces.pop() if row.motion else ()
        question = paper_question(listed, wrench, row.preload)
        subject = TableRow(question, row.stable == "Yes", tuple(forces), motion)
        label = f"w={row.wrench.replace(' ', '')} P={row.preload} {row.stable}"
        assumed = "; ".join(text for _, text in readings if text)
        yield Case(label, subject, question.to_dict(), assumed)


def _by_substitution(row: TableRow) -> str:
    if not oracle.stable(row.question):
        return "No"
    fits = row.motion and not oracle.violations(row.question, row.motion, row.forces)
    return "Yes, numbers fit" if fits else "Yes, numbers do not fit"


def _solved(row: TableRow) -> str:
    verdict = Solver(grasp_of(row.question)).solve(row.question.wrench)
    if not verdict.verify():
        return "the certificate is not valid"
    if not verdict.stable:
        return "No"
    fits = row.motion and any(p.contains(row.motion, row.forces) for p in verdict.equilibria)
    return "Yes, numbers fit" if fits else "Yes, numbers do not fit"


def _explain_row(row: TableRow, _value: str) -> str:
    if not row.motion:
        return ""
    broken = oracle.violations(row.question, row.motion, row.forces)
    if broken:
        return f"printed numbers break: {', '.join(broken)}"
    *forces, motion = (f"({','.join(map(str, values))})" for values in (*row.forces, row.motion))
    return f"f = {' '.join(forces)}, d = {motion}"


@dataclass(frozen=True)
class Probes:
    """A question with factors t, and the printed statement on t times its wrench."""

    question: Question
    factors: tuple[Fraction, ...]
    holds: tuple[bool, ...]


def _ray(
    contacts: Iterable[Sequence[int]], preload: int, low: Fraction | None, high: Fraction
) -> Case:
    """Return the statement that exactly the forces (0, t, 0) with low <= t <= high are held."""
    ends = [high] if low is None else [low, high]
    near = (end + tiny for end in ends for tiny in (-TINY, 0, TINY))
    ordered = tuple(sorted({*map(Fraction, (-(10**6), -1, 0, 1)), *near}))
    held = tuple((low is None or low <= t) and t <= high for t in ordered)
    question = paper_question(contacts, (0, 1, 0), preload)
    name = "three" if len(question.contacts) == 3 else "four"
    label = f"{name} contacts, P = {preload}, w = (0, t, 0)"
    return Case(label, Probes(question, ordered, held), question.to_dict())


def _rays(_rng: random.Random) -> Iterator[Case]:
    yield _ray(printed.THREE_CONTACT_GRASP, 0, None, Fraction(0))
    yield _ray(printed.THREE_CONTACT_GRASP, 1, None, Fraction(1))
    yield _ray(printed.FOUR_CONTACT_GRASP, 0, Fraction(0), Fraction(0))
    yield _ray(printed.FOUR_CONTACT_GRASP, 1, Fraction(-2), Fraction(2))


def _held_exactly(probes: Probes) -> tuple[bool, ...]:
    intervals = oracle.resisted(probes.question)
    return tuple(
        any((a is None or a <= t) and (b is None or t <= b) for a, b in intervals)
        for t in probes.factors
    )


def _held_solved(probes: Probes) -> tuple[bool, ...]:
    grasp = grasp_of(probes.question)
    return tuple(
        Solver(grasp).solve([t * x for x in probes.question.wrench]).stable for t in probes.factors
    )


def _downward(_rng: random.Random) -> Iterator[Case]:
    zero = Fraction(0)
    for force in map(Fraction, ("0", "-1/3", "-1", "-2", "-17", "-1000000")):
        question = paper_question(printed.THREE_CONTACT_GRASP, (zero, force, zero), 0)
        none = (zero, zero)
        row = TableRow(question, True, (none, (-force, zero), none), (zero, force, zero))
        yield Case(f"w = (0, {force}, 0)", row, question.to_dict())


def _four_contacts(_rng: random.Random) -> Iterator[Case]:
    for mu, preload in product(
        map(Fraction, ("0", "1/10", "1/2", "1", "3/2", "2", "20")), (0, 1, 3)
    ):
        question = paper_question(printed.FOUR_CONTACT_GRASP, (0, 1, 0), preload, mu)
        yield grasp_case(question, f"friction {mu}, preload {preload}")


def _up_to_four_friction(question: Question, held: tuple[oracle.Interval, ...]) -> bool:
    mu, preload = question.contacts[0][4], question.contacts[0][6]
    return held == ((-4 * mu * preload, 4 * mu * preload),)


def _held_both_ways(question: Question) -> tuple[oracle.Interval, ...]:
    grasp = grasp_of(question)
    down = [-x for x in question.wrench]
    up, below = (resisted_magnitudes(grasp, w).intervals for w in (question.wrench, down))
    turned = [(b and -b, a and -a) for a, b in below]
    return oracle.union([*turned, *up])


_table = partial(
    stated,
    judge=lambda row, value: value == ("Yes, numbers fit" if row.stable else "No"),
)

CLAIMS = (
    _table(
        "table-three-contacts",
        substitution=_by_substitution,
        solver=_solved,
        explain=_explain_row,
        cases=partial(_rows, printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
    ),
    _table(
        "table-four-contacts",
        substitution=_by_substitution,
        solver=_solved,
        explain=_explain_row,
        cases=partial(_rows, printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS),
    ),
    _table("downward-forces", substitution=_by_substitution, solver=_solved, cases=_downward),
    stated(
        "vertical-limits",
        elimination=_held_exactly,
        solver=_held_solved,
        judge=lambda probes, held: held == probes.holds,
        cases=_rays,
    ),
    stated(
        "vertical-limit-every-friction",
        elimination=oracle.resisted,
        solver=_held_both_ways,
        judge=_up_to_four_friction,
        cases=_four_contacts,
    ),
)
