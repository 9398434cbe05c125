"""The three tables of the paper, computed, each printed cell above the computed one."""

from __future__ import annotations

import platform
import time
import tomllib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from importlib.resources import files
from pathlib import Path
from typing import Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import BLACK, BLUE, GREY
from arrangement.drawing.scene import FONT, POINTS, Scene, measure, wrap_lines
from arrangement.enumeration.paper_steps import published_enumeration
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.random import random_grasp
from proofs_check.instances import printed
from proofs_check.instances.grasps import grasp_of, paper_question

from .figures import PaperPart

#: Width of a table on paper, in millimetres.
_WIDTH = 180.0
#: Who says a row of a table.
PRINTED, COMPUTED, MEASURED = "printed", "computed", "measured"
_COLOURS = {PRINTED: BLACK, COMPUTED: BLUE, MEASURED: GREY}


@dataclass(frozen=True)
class TableLine:
    """One line: who says it, its cells, and whether a line is drawn above it."""

    by: str
    cells: tuple[str, ...]
    first: bool = True


@dataclass(frozen=True)
class TableContent:
    """The head, the rows and a note below them."""

    head: tuple[str, ...]
    rows: tuple[TableLine, ...]
    note: str = ""


@dataclass(frozen=True)
class PaperTable(PaperPart):
    """One table, and what computes it from measured times."""

    kind = "table"
    content: Callable[[Times], TableContent]


@dataclass(frozen=True)
class Times:
    """Seconds that Steps 1 to 3 and the enumeration of all faces took, by number of contacts."""

    machine: str
    steps: dict[int, float]
    enumeration: dict[int, float]


def stored_times() -> Times:
    """Return the times that stand beside this module, with the machine on which they were taken."""
    text = files(__package__).joinpath("times.toml").read_text(encoding="utf-8")
    known = tomllib.loads(text)
    steps, faces = (dict(zip(known["contacts"], known[k], strict=True)) for k in ("steps", "faces"))
    return Times(known["machine"], steps, faces)


def measured_times(contacts: Iterable[int] = printed.STATE_COUNTS) -> Times:
    """Measure both on this machine, once each, on grasps with random contacts."""
    listed = tuple(contacts)
    _seconds(_run_steps, 2)  # what is loaded at the first call is not the time of an algorithm
    _seconds(_list_faces, 2)
    steps, faces = ({m: _seconds(run, m) for m in listed} for run in (_run_steps, _list_faces))
    return Times(_machine(), steps, faces)


def _machine() -> str:
    """Return the name of the processor and the version of Python."""
    name = platform.processor() or platform.machine()
    cores = Path("/proc/cpuinfo")
    lines = cores.read_text(encoding="utf-8").splitlines() if cores.exists() else []
    named = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{named[0] if named else name}, Python {platform.python_version()}"


def _planes(m: int) -> Arrangement:
    return random_grasp(m, seed=1).tangential_arrangement()


def _run_steps(planes: Arrangement) -> int:
    return len(published_enumeration(planes).states)


def _list_faces(planes: Arrangement) -> int:
    return len(list(planes.faces()))


def _seconds(run: Callable[[Arrangement], int], m: int) -> float:
    planes = _planes(m)
    start = time.perf_counter()
    run(planes)
    return time.perf_counter() - start


def _state_table(times: Times) -> TableContent:
    """Return Table II: numbers of slip states, and times."""
    columns = printed.STATE_COUNTS

    def row(by: str, name: str, values: Iterable[Any], first: bool = True) -> TableLine:
        return TableLine(by, (name, *map(str, values)), first)

    def measured(seconds: dict[int, float]) -> list[str]:
        return [f"{seconds[m]:.2g}" for m in columns]

    every = [_planes(m) for m in columns]
    return TableContent(
        ("m", *map(str, columns)),
        (
            row(PRINTED, "number of slip states", columns.values()),
            row(COMPUTED, "Steps 1 to 3, as listed", map(_run_steps, every), False),
            row(COMPUTED, "different states, origin included", map(_list_faces, every), False),
            row(PRINTED, "time (s)", printed.STATE_TIMES.values()),
            row(MEASURED, "Steps 1 to 3 (s)", measured(times.steps), False),
            row(MEASURED, "all faces, this package (s)", measured(times.enumeration), False),
        ),
        "Printed times: 2.80 GHz Core i7. Measured times, one run each, depend on the machine: "
        f"{times.machine}.",
    )


Grasps: TypeAlias = tuple[tuple[int, int, int, int], ...]


def _result_table(contacts: Grasps, rows: Iterable[printed.PrintedRow], _: Times) -> TableContent:
    """Return Table I or III: verdict, forces and motion of each wrench and preload."""
    forces = [f"$f_{k}$" for k in range(1, len(contacts) + 1)]
    lines = []
    for row in rows:
        wrench, preload = printed.read_vector(row.wrench)[0], Fraction(row.preload)
        verdict = solve(grasp_of(paper_question(contacts, wrench, preload)), wrench)
        shown = [row.wrench.replace(" ", ""), row.preload]
        blank = ("",) * (len(contacts) + 1)
        cells = (*row.forces, row.motion) if row.motion else blank
        lines.append(TableLine(PRINTED, (*shown, "printed", row.stable, *cells, "")))
        numbers, remark = blank, _remark(row, verdict)
        if verdict.stable:
            first = verdict.equilibria[0]
            numbers = tuple(map(_vector, (*first.forces, first.motion)))
        stable = "Yes" if verdict.stable else "No"
        lines.append(TableLine(COMPUTED, ("", "", "computed", stable, *numbers, remark), False))
    head = ("w", "P", "", "stable", *forces, "d", "printed numbers")
    note = "Computed: the equilibrium of least motion, then of least forces; exact."
    return TableContent(head, tuple(lines), note)


def _remark(row: printed.PrintedRow, verdict: Any) -> str:
    """Return how the printed numbers stand to all equilibria."""
    if (row.stable == "Yes") != verdict.stable:
        return "differ"
    if not row.motion:
        return "agree"
    *forces, motion = (printed.read_vector(cell) for cell in (*row.forces, row.motion))
    numbers = motion[0], [force[0] for force in forces]
    holding = [family for family in verdict.equilibria if family.contains(*numbers)]
    if not holding:
        return "differ"
    same = numbers == (holding[0].motion, list(holding[0].forces))
    misprint = ", one misprint" * any(text for _, text in (*forces, motion))
    return f"{'agree' if same else 'a solution, too'}{misprint}"


def _vector(values: Sequence[Fraction]) -> str:
    """Return numbers as the paper prints them, as decimals where these are exact."""
    texts = (f"{float(x):g}" for x in values)
    exact = (t if Fraction(t) == x else str(x) for t, x in zip(texts, values, strict=True))
    return f"({','.join(exact)})"


def table_scene(content: TableContent) -> Scene:
    """Return a table as a picture as wide as a page."""
    room = _WIDTH * POINTS
    size = next(x for x in (FONT, 6.5, 6.0, 5.5, 5.0, 4.5, 4.0) if sum(_widths(content, x)) <= room)
    widths, row = _widths(content, size), 1.75 * size
    note = wrap_lines(content.note, room - 12, size) if content.note else []
    height = row * (len(content.rows) + 1 + len(note)) + 8
    scene = Scene(_WIDTH, height / POINTS)
    gap = (room - sum(widths)) / (len(widths) + 1)

    def write(y: float, cells: Iterable[str], **style: Any) -> None:
        x = gap
        for width, text in zip(widths, cells, strict=True):
            if text:
                at = (x + width / 2, y - row / 2)
                scene.text(at, text, size, va="center_baseline", **style)
            x += width + gap

    y = height - 2.0
    write(y, content.head, weight="bold")
    for line in content.rows:
        y -= row
        if line.first:
            scene.line([(0, y), (room, y)], ec=GREY, lw=0.4, role="line")
        write(y, line.cells, color=_COLOURS[line.by])
    y -= row
    scene.line([(0, y), (room, y)], ec=GREY, lw=0.8, role="line")
    for text in note:
        scene.text((gap, y - row / 2), text, size, ha="left", va="center_baseline", color=GREY)
        y -= row
    return scene


def _widths(content: TableContent, size: float) -> list[float]:
    rows = [content.head, *(row.cells for row in content.rows)]
    columns = zip(*rows, strict=True)
    return [max(measure(text or " ", size)[0] for text in column) + 5 for column in columns]


TABLES = (
    PaperTable(
        "I",
        "Three contacts: verdicts, forces and motions",
        "Seven wrenches and preloads on the grasp of Figure 1.",
        "The exact solution of the full model, with the contacts that the printed numbers imply.",
        "Every printed number is right.",
        ("table-three-contacts", "downward-forces", "vertical-limits"),
        partial(_result_table, printed.THREE_CONTACT_GRASP, printed.THREE_CONTACTS),
    ),
    PaperTable(
        "II",
        "Number of slip states and time",
        "Slip states of grasps with m random contacts, and the time to enumerate them.",
        "Steps 1 to 3 as published, run on random contacts, and the enumeration of all faces.",
        "The steps list what is printed. Different states are one more for m > 2, as the origin, "
        "where all contacts stick, is missing; at m = 2 one state is listed twice.",
        ("slip-state-counts", "different-slip-states"),
        _state_table,
    ),
    PaperTable(
        "III",
        "Four contacts: verdicts, forces and motions",
        "Ten wrenches and preloads on the grasp of Figure 4.",
        "The exact solution of the full model, with the contacts that the printed numbers imply.",
        "Every printed number is right, if the one with two points in the last row is 0.25.",
        ("table-four-contacts", "vertical-limits"),
        partial(_result_table, printed.FOUR_CONTACT_GRASP, printed.FOUR_CONTACTS),
    ),
)
