"""Verdicts on random grasps, ours beside a mixed-integer program, brute force and Siconos.

    run.py --only grasps                      10, 20, 50, 100 and 1000 contacts
    run.py --only grasps --contacts 10,20     fewer
    run.py --only grasps --grasps 8           8 grasps of each size instead of 16 or 32

Ours is a verdict with its proof; Siconos and the mixed-integer program give floats and none.
"""

import itertools
import json
import math
import shutil
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from graspjob import BORDER, MILP_SECONDS, PATCHES, VERDICTS

HERE = Path(__file__).resolve().parent
Found = dict[str, Any]
#: By number of contacts: how many grasps for us, and for the mixed-integer program.
COUNT = {1000: 16, **dict.fromkeys((3, 4, 5), 16)}
PEER = {10: 16, 20: 8, 50: 4}
#: Up to how many contacts all equilibria are listed, which is cubic with preload.
LISTED = 50
BRUTE = (3, 4, 5)
#: Wall seconds for all grasps of one size; who needs more is stopped, and what is done counts.
LIMIT = 240


def grasp_tables(contacts: Sequence[int], limit: float = LIMIT, count: int = 0) -> None:
    print("\nVerdicts with proofs on random grasps: medians of CPU time (largest)", flush=True)
    heading()
    found = {m: _own_lines(m, _seeds(m, count), limit) for m in contacts}
    growth(found)
    for added, where in ((PATCHES, "any wrench"), (BORDER, "just beyond the boundary")):
        print(f"\nTen patches of contacts on one side, {where}")
        heading()
        for m in contacts:
            one_side = [added + seed for seed in range(count or 32) if seed % 4 >= 2]
            _own_lines(m, one_side[: 8 if m >= 1000 else None], 2 * limit)
    print("\nOther programs on the same grasps (no proof), and times ours")
    for m in contacts:
        if m in PEER:
            seeds = [
                one["seed"]
                for verdict in VERDICTS.values()
                for one in [x for x in found[m] if x["verdict"] == verdict][: PEER[m] // 2]
            ]
            against(f"mixed-integer program, m = {m}", found[m], run("milp", m, seeds, 2 * limit))
        if m <= LISTED:
            seeds = _seeds(m, count)
            against(f"Siconos, Lemke's method, m = {m}", found[m], siconos(m, seeds))
            listed = run("pieces", m, seeds[:8], limit / 4)
            against(f"ours with all equilibria, m = {m}", found[m], listed)
    for m in BRUTE:
        seeds = _seeds(m)
        mine = run("ours", m, seeds, limit)
        against(f"brute force, 4^m states, exact, m = {m}", mine, run("brute", m, seeds, limit))


def _seeds(contacts: int, count: int = 0) -> Sequence[int]:
    return range(count or COUNT.get(contacts, 32))


def run(
    job: str, contacts: int | str, seeds: Iterable[int], limit: float, script: str = "graspjob.py"
) -> list[Found]:
    """Run a job of a script in a process of its own; return what it printed in time."""
    listed = [str(seed) for seed in seeds]
    command = [sys.executable, str(HERE / script), job, str(contacts), *listed]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
        output, problem = done.stdout, done.stderr if done.returncode else ""
    except subprocess.TimeoutExpired as stopped:
        partial = stopped.stdout or ""
        output = partial if isinstance(partial, str) else partial.decode()
        output = output[: output.rfind("\n") + 1]  # the last line may be cut
        problem = f"stopped after {limit:.0f} s, {output.count(chr(10))} of {len(listed)} done"
    if problem:
        print(f"  {job}, m = {contacts}: {problem.strip().splitlines()[-1]}", flush=True)
    # HiGHS writes lines of its own among ours.
    return [json.loads(line) for line in output.splitlines() if line.startswith("{")]


def siconos(contacts: int, seeds: Sequence[int]) -> list[Found]:
    """Run Siconos on the same grasps, in whichever interpreter has it."""
    found = []
    for question in run("contacts_in_floats", contacts, seeds, LIMIT):
        python = next(filter(_has_siconos, (sys.executable, shutil.which("python3"), SYSTEM)), None)
        if python is None:
            print("  Siconos: absent (Debian: python3-siconos)")
            return []
        done = subprocess.run(
            [python, str(HERE / "lcp.py")],
            input=json.dumps(question),
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode:
            print(f"  Siconos does not run here: {done.stderr.strip().splitlines()[-1]}")
            return []
        answer = json.loads(done.stdout.splitlines()[-1])
        solved = not answer["info"] and answer["error"] < 1e-6
        found.append({**answer, "seed": question["seed"], "verdict": VERDICTS[solved]})
    return found


SYSTEM = "/usr/bin/python3"
_PROBED: dict[str, bool] = {}


def _has_siconos(python: str | None) -> bool:
    if python is None:
        return False
    if python not in _PROBED:
        command = [python, "-c", "import siconos.numerics"]
        try:
            done = subprocess.run(command, capture_output=True, check=False)
            _PROBED[python] = done.returncode == 0
        except OSError:
            _PROBED[python] = False
    return _PROBED[python]


def heading() -> None:
    print(
        f"{'m':>4} {'verdict':<12} {'grasps':>6} {'verdict, proof':>20} {'second wrench':>13}"
        f" {'check':>18} {'proof':>18} {'leaves':>11} {'digits':>6}"
    )


def _own_lines(m: int, seeds: Iterable[int], limit: float) -> list[Found]:
    """Measure ours, print a line for each verdict, and return what was found."""
    listed = run("ours", m, seeds, limit)
    for verdict in VERDICTS.values():
        if chosen := [one for one in listed if one["verdict"] == verdict]:
            again = [one["second"] for one in chosen if one["second"] is not None]
            print(
                f"{m:>4} {verdict:<12} {len(chosen):>6} {spread(chosen, 'seconds', shown):>20}"
                f" {shown(statistics.median(again)) if again else '-':>13}"
                f" {spread(chosen, 'check', shown):>18} {spread(chosen, 'bytes', kilobytes):>18}"
                f" {spread(chosen, 'leaves', str):>11}"
                f" {statistics.median(one['digits'] for one in chosen):>6g}",
                flush=True,
            )
    if bad := [one["seed"] for one in listed if not one["valid"]]:
        print(f"  REFUSED: the proofs of seeds {bad}")
    return listed


def spread(chosen: list[Found], key: str, form: Callable[[Any], str]) -> str:
    """Return the median (the largest)."""
    values = [one[key] for one in chosen]
    return f"{form(statistics.median_low(values))} ({form(max(values))})" if values else "-"


def growth(found: dict[int, list[Found]]) -> None:
    """Print by which power of m the medians grow."""
    for verdict in VERDICTS.values():
        points = [
            (m, statistics.median(times))
            for m, listed in found.items()
            if (times := [one["seconds"] for one in listed if one["verdict"] == verdict])
        ]
        pairs = [*itertools.pairwise(points), (points[0], points[-1])] if len(points) > 2 else []
        steps = [
            f"m^{math.log(b / a) / math.log(n / m):.2f} from {m} to {n}" for (m, a), (n, b) in pairs
        ]
        if steps:
            print(f"  growth, {verdict}: {'; '.join(steps)}")


def against(name: str, mine: list[Found], other: list[Found]) -> None:
    """Print a peer's medians beside ours on the same seeds, by our verdict, and its mistakes."""
    own = {one["seed"]: one for one in mine}
    for verdict in VERDICTS.values():
        pairs = [
            (own[one["seed"]], one)
            for one in other
            if one["seed"] in own and own[one["seed"]]["verdict"] == verdict
        ]
        if not pairs:
            continue
        theirs = [one["seconds"] for _, one in pairs]
        ours = statistics.median(one["seconds"] for one, _ in pairs)
        opposite = VERDICTS[verdict != VERDICTS[True]]
        wrong = [b["seed"] for _, b in pairs if b["verdict"] == opposite]
        silent = sum(b["verdict"] not in (verdict, opposite) for _, b in pairs)
        note = f"  none within {MILP_SECONDS} s: {silent}" if silent else ""
        note += f"  WRONG: seeds {wrong}" if wrong else ""
        median = statistics.median(theirs)
        print(
            f"  {name:<42} {verdict:<12} {len(pairs):>3} {shown(median):>9}"
            f" ({shown(max(theirs)):>9}) {median / ours:>9.3g} times ours{note}",
            flush=True,
        )


def shown(value: float) -> str:
    """Return a time with three digits."""
    return f"{1000 * value:.3g} ms" if value < 1 else f"{value:.3g} s"


def kilobytes(value: float) -> str:
    return f"{value / 1000:.1f} kB"
