"""Claims on the two result tables, every printed verdict, force and motion, and their text."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from .parts import *

BRUTE_FORCE = "substitution into the model, and brute force over 4^m states by elimination"
SOLVER = "the solver with its certificate, and its pieces of solutions"
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
        question = paper_question(listed, wrench, Fraction(row.preload))
        subject = TableRow(question, row.stable == "Yes", tuple(forces), motion)
        label = f"w={row.wrench.replace(' ', '')} P={row.preload} {row.stable}"
        assumed = "; ".join(text for _, text in readings if text)
        yield Case(label, subject, question.to_dict(), assumed)


def _substituted(row: TableRow) -> str:
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


def _as_printed(row: TableRow, value: str) -> bool:
    return value == ("Yes, numbers fit" if row.stable else "No")


def _explain_row(row: TableRow, _value: str) -> str:
    if not row.motion:
        return ""
    broken = oracle.violations(row.question, row.motion, row.forces)
    if broken:
        return f"printed numbers break: {', '.join(broken)}"
    forces = " ".join(_vector(force) for force in row.forces)
    return f"f = {forces}, d = {_vector(row.motion)}"


def _vector(values: Iterable[Fraction]) -> str:
    return f"({','.join(str(value) for value in values)})"


@dataclass(frozen=True)
class Probes:
    """A question with factors t, and the printed statement on t times its wrench."""

    question: Question
    factors: tuple[Fraction, ...]
    holds: tuple[bool, ...]


def _ray(
    contacts: Iterable[Sequence[int]], preload: int, low: Fraction | None, high: Fraction
) -> Case:
    """The statement that exactly the forces (0, t, 0) with low <= t <= high are held."""
    ends = [high] if low is None else [low, high]
    near = (end + tiny for end in ends for tiny in (-TINY, 0, TINY))
    ordered = tuple(sorted({*map(Fraction, (-(10**6), -1, 0, 1)), *near}))
    held = tuple((low is None or low <= t) and t <= high for t in ordered)
    question = paper_question(contacts, (Fraction(0), Fraction(1), Fraction(0)), preload)
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


def _shown(
    contacts: Sequence[Sequence[int]], wrench: Sequence[int], preload: int, caption: str
) -> tuple[View, ...]:
    question = paper_question(contacts, list(map(Fraction, wrench)), preload)
    return (View("grasp", caption, {"wrench": wrench}, question.to_dict()),)


def _downward(_rng: random.Random) -> Iterator[Case]:
    zero = Fraction(0)
    for force in map(Fraction, ("0", "-1/3", "-1", "-2", "-17", "-1000000")):
        question = paper_question(printed.THREE_CONTACT_GRASP, (zero, force, zero), 0)
        none = (zero, zero)
        row = TableRow(question, True, (none, (-force, zero), none), (zero, force, zero))
        yield Case(f"w = (0, {force}, 0)", row, question.to_dict())


_ROUTES = (Route(BRUTE_FORCE, _substituted), Route(SOLVER, _solved))
_table = partial(
    stated,
    routes=_ROUTES,
    judge=_as_printed,
    explain=_explain_row,
)

CLAIMS = (
    _table(
        id="table-three-contacts",
        views=_shown(
            printed.THREE_CONTACT_GRASP,
            (0, 1, 0),
            1,
            "The row w = (0, 1, 0), P = 1, with the printed forces and motion.",
        ),
        sources=exhaustive(
            "all 7 printed rows",
            partial(_rows, printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
        ),
    ),
    _table(
        id="table-four-contacts",
        views=_shown(
            printed.FOUR_CONTACT_GRASP,
            (0, 0, 3),
            0,
            "The row w = (0, 0, 3), P = 0: two contacts carry the torque, two have let go.",
        ),
        sources=exhaustive(
            "all 10 printed rows", partial(_rows, printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS)
        ),
    ),
    stated(
        id="downward-forces",
        routes=_ROUTES,
        judge=_as_printed,
        sources=sampled("six magnitudes from 0 to 10^6", _downward),
    ),
    stated(
        id="vertical-limits",
        views=(
            View(
                "slice",
                "The three-contact grasp, forces at torque 0, exact. Upwards nothing is resisted "
                "without preload, and at most 1 with preload 1.",
                instance=paper_question(
                    printed.THREE_CONTACT_GRASP, [Fraction(0)] * 3, 1
                ).to_dict(),
            ),
        ),
        routes=(
            Route("exact set of all t by elimination over 4^m states", _held_exactly),
            Route("the solver at each t", _held_solved),
        ),
        judge=lambda probes, held: held == probes.holds,
        sources=exhaustive("both grasps with both preloads; all t by the first route", _rays),
    ),
)
