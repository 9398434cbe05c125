"""A command prints the same, byte for byte, whether the clock is fast or slow.

Pages of the documentation are read on a clock that is both; see `tests.test_docs`.
"""

import contextlib
import io
import itertools
import json
import math
import os
import shlex
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest

from arrangement.numbers import deadline
from equilibrium.grasps.inputs import from_float_data, random_grasp
from tests.docpages import ENTRIES

CLOCKS = ("monotonic", "perf_counter", "process_time", "thread_time")
#: How much faster the clock is.
FACTORS = (100.0, 0.01)
#: One of each kind of question, which are quick.
COMMANDS = """
arrangement count shi-a2-affine
arrangement count braid-a3 --json
arrangement count shi-a2-affine --forecast
arrangement count braid-a3 --forecast --json
arrangement faces braid-a3 --json
arrangement identify braid-a3
arrangement make resonance --n 30
equilibrium solve paper-three-contacts-preload-1 --wrench 0 1 0
equilibrium solve paper-four-contacts-preload-1 --wrench 0 -1 0 --json
equilibrium resisted paper-four-contacts-preload-1 --wrench 0 1 0
equilibrium resisted paper-three-contacts-preload-1 --wrench 0 1 0 --margin
equilibrium solve paper-three-contacts-preload-1 --wrench 0 1 0 --methods
equilibrium info box-1-wall --modes
equilibrium info box-1-wall --modes --count --json
equilibrium resisted paper-three-contacts-preload-1
proofs-check try "bounded_regions <= regions" --of "linial(n=3..4)"
proofs-check try "bounded_regions == 1" --of "linial(n=3..5)"
equilibrium solve paper-three-contacts-preload-1 --wrench 0 1/2 1/2
equilibrium solve SOFT.json --wrench 1 0 -1 0 0 1/2
equilibrium solve peg-in-a-hole --wrench 0 0 -3/2 0 0 0 --json
equilibrium solve peg-in-a-hole --wrench 0 0 -1 0 0 1 --cone pyramid:6
equilibrium resisted paper-three-contacts-preload-1 --slice fx fy --json
equilibrium solve DISC.json --wrench 1 -2 0 --json
equilibrium solve paper-three-contacts-preload-1 --wrench 0 1/2 0 --robust degrees=1/10 friction=5%
equilibrium resisted two-opposed-fingers --wrench 0 3/5 4/5 0 0 0
""".strip().splitlines()


def warped(real: Callable[[], float], factors: Sequence[float]) -> Callable[[], float]:
    """Return a clock that goes faster by the next of the factors from each reading to the next."""
    now = last = real()
    speeds = itertools.cycle(factors)

    def read() -> float:
        nonlocal now, last
        reading = real()
        now += next(speeds) * (reading - last)
        last = reading
        return now

    return read


def set_clock(patch: pytest.MonkeyPatch, *factors: float) -> None:
    """Let every clock of this process go faster by a factor, or by each of several in turn."""
    for name in CLOCKS:
        patch.setattr(time, name, warped(getattr(time, name), factors))
    patch.setattr(deadline, "clock", time.monotonic)


def in_a_copy(factor: float, target: Path, function: Callable[[], Any]) -> Any:
    """Return what a function returns in a copy of this process, where a clock goes so fast."""
    child = os.fork()
    if not child:
        code = 70
        try:
            set_clock(pytest.MonkeyPatch(), factor)
            target.write_text(json.dumps(function()))
            code = 0
        finally:
            os._exit(code)
    _, status = os.waitpid(child, 0)
    assert status == 0
    return json.loads(target.read_text())


def answered(words: list[str]) -> tuple[int, str]:
    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(io.StringIO()):
        try:
            code = ENTRIES[words[0]](words[1:])
        except SystemExit as stop:
            code = int(stop.code or 0)
    return code, output.getvalue()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A grasp whose equilibria are not small motions, and a disc with rounded data.

    What takes long to import is there before this process is copied.
    """
    for command in ("arrangement count braid-a3", "proofs-check list"):
        answered(command.split())
    angles = map(math.radians, (0, 72, 144, 216, 300))
    around = [(math.cos(angle), math.sin(angle)) for angle in angles]
    points, normals = [[0.03 * x, 0.03 * y] for x, y in around], [[-x, -y] for x, y in around]
    made = tmp_path_factory.mktemp("clock")
    grasps = {
        "SOFT": random_grasp(4, 2, dimension=3).with_units("m", "N"),
        "DISC": from_float_data(points, normals, 0.0).grasp,
    }
    for stem, grasp in grasps.items():
        (made / f"{stem}.json").write_text(json.dumps(grasp.to_dict()))
    return made


def test_clock_goes_by_each_factor_from_reading_to_reading():
    clock = warped(iter([10.0, 11.0, 12.0, 13.0, 15.0]).__next__, (100.0, 0.25))
    assert [clock() for _ in range(4)] == [110.0, 110.25, 210.25, 210.75]


@pytest.mark.parametrize("command", COMMANDS)
def test_command_prints_the_same_with_any_clock(command, folder, tmp_path, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.setenv("COLUMNS", "80")
    fast, slow = (
        in_a_copy(factor, tmp_path / "answer", lambda: answered(shlex.split(command)))
        for factor in FACTORS
    )
    assert fast == slow
    assert fast[0] in (0, 1, 3) or "--n 30" in command
