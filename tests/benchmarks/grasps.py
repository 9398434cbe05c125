"""Verdicts on random grasps, ours beside a mixed-integer program, brute force and Siconos.

    run.py --only grasps                      10, 20 and 50 contacts
    run.py --only grasps --contacts 10,20     fewer
    run.py --only grasps --grasps 32          32 grasps of each size instead of 8 to 32
    run.py --only grasps --hundred            one grasp of 100 contacts too, ours alone

Ours is a verdict with its proof; Siconos and the mixed-integer program give floats and none.
"""

from __future__ import annotations

import itertools
import json
import math
import shutil
import statistics
import subprocess
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from graspjob import MILP_SECONDS, ROUNDED

HERE = Path(__file__).resolve().parent
Found = dict[str, Any]
#: By number of contacts: the seeds for us, and how many of them for the mixed-integer program.
#: Those of 50 contacts are chosen so that two of each verdict are there, with and without preload.
SEEDS: dict[int, Sequence[int]] = {
    **dict.fromkeys((3, 4, 5), range(16)),
    10: range(32),
    20: range(24),
    50: (0, 6, 1, 2, 3, 14, 15, 31),
}
PEER = {10: 16, 20: 8, 50: 2}
BRUTE = (3, 4, 5)
#: Wall seconds for all grasps of one size; who needs more is stopped, and what is done counts.
LIMIT = 240


def grasp_tables(
    contacts: Sequence[int], limit: float = LIMIT, count: int = 0, hundred: bool = False
) -> None:
    print(
        "\nVerdicts with proofs on random grasps: medians of processor time (largest)", flush=True
    )
    found = {m: run("ours", m, _seeds(m, count), limit) for m in contacts}
    own_table(found)
    growth(found)
    rounded = {
        m: run("ours", m, [ROUNDED + seed for seed in _seeds(m, count)], limit)
        for m in contacts
        if m <= 20
    }
    if rounded:
        print("\nThe same with rounded numbers (planes of at most 5 digits)")
        own_table(rounded)
    print("\nOther programs on the same grasps (no proof), and times ours")
    for m in contacts:
        seeds = _seeds(m)[: PEER.get(m, 8)]
        against(f"mixed-integer program, m = {m}", found[m], run("milp", m, seeds, 2 * limit))
        against(f"Siconos, Lemke's method, m = {m}", found[m], siconos(m, _seeds(m, count)))
        against(f"ours with all equilibria, m = {m}", found[m], run("pieces", m, seeds, limit / 4))
    for m in BRUTE:
        seeds = _seeds(m)
        mine = run("ours", m, seeds, limit)
        against(f"brute force, 4^m states, exact, m = {m}", mine, run("brute", m, seeds, limit))
    if hundred:
        print("\n100 contacts: all around without and with preload; then pulled away from one side")
        for seed in (0, 1, 6, 7):
            own_table({100: run("ours", 100, [seed], 4 * limit)})


def _seeds(contacts: int, count: int = 0) -> Sequence[int]:
    return range(count) if count else SEEDS.get(contacts, range(8))


def run(job: str, contacts: int, seeds: Iterable[int], limit: float) -> list[Found]:
    """Run a job of `graspjob.py` in a process of its own; return what it printed in time."""
    listed = [str(seed) for seed in seeds]
    command = [sys.executable, str(HERE / "graspjob.py"), job, str(contacts), *listed]
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
        found.append({**answer, "seed": question["seed"], "verdict": _VERDICTS[solved]})
    return found


SYSTEM = "/usr/bin/python3"
NONE = (math.nan, math.nan)
_VERDICTS = {True: "stable", False: "unstable"}
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


def own_table(found: dict[int, list[Found]]) -> None:
    """Print ours by size, verdict and preload."""
    print(
        f"{'m':>4} {'verdict':<9} {'preload':<8} {'grasps':>6} {'verdict, proof':>22}"
        f" {'check':>9} {'check/ours':>10} {'2nd/1st':>8} {'decided':>8} {'proof':>9}"
    )
    for m, listed in found.items():
        for verdict in ("stable", "unstable"):
            for preload in (False, True, None):
                chosen = select(listed, verdict, preload)
                if chosen:
                    _own_line(m, verdict, {False: "no", True: "yes", None: "both"}[preload], chosen)
        if bad := [one["seed"] for one in listed if not one["valid"]]:
            print(f"  REFUSED: the proofs of seeds {bad}")


def _own_line(m: int, verdict: str, preload: str, chosen: list[Found]) -> None:
    seconds = [one["seconds"] for one in chosen]
    ratio = statistics.median(one["check"] / one["seconds"] for one in chosen)
    again = [
        (one["second"] / one["seconds"], one["second_decide"] / one["decide"])
        for one in chosen
        if one["second"] is not None
    ]
    second, decided = (f"{statistics.median(x):.2f}" for x in zip(*(again or [NONE]), strict=True))
    size = statistics.median(one["bytes"] for one in chosen) / 1000
    print(
        f"{m:>4} {verdict:<9} {preload:<8} {len(chosen):>6}"
        f" {shown(statistics.median(seconds)):>10} ({shown(max(seconds)):>9})"
        f" {shown(statistics.median(one['check'] for one in chosen)):>9} {ratio:>10.2f}"
        f" {second:>8} {decided:>8} {size:>6.0f} kB",
        flush=True,
    )


def select(listed: list[Found], verdict: str, preload: bool | None) -> list[Found]:
    return [
        one
        for one in listed
        if one["verdict"] == verdict and preload in (None, bool(one["seed"] % 2))
    ]


def growth(found: dict[int, list[Found]]) -> None:
    """Print by which power of m the medians grow; unstable is the complete enumeration."""
    for preload in (False, True):
        for verdict in ("stable", "unstable"):
            points = [
                (m, statistics.median(one["seconds"] for one in chosen))
                for m, listed in found.items()
                if (chosen := select(listed, verdict, preload))
            ]
            if len(points) > 1:
                steps = [
                    f"m^{math.log(b / a) / math.log(n / m):.2f} from {m} to {n}"
                    for (m, a), (n, b) in itertools.pairwise(points)
                ]
                (m, a), (n, b) = points[0], points[-1]
                if len(points) > 2:
                    overall = math.log(b / a) / math.log(n / m)
                    steps.append(f"m^{overall:.2f} from {m} to {n}")
                name = "with preload" if preload else "without preload"
                print(f"  growth, {verdict}, {name}: {'; '.join(steps)}")


def against(name: str, mine: list[Found], other: list[Found]) -> None:
    """Print a peer's medians beside ours on the same seeds, by our verdict, and its mistakes."""
    own = {one["seed"]: one for one in mine}
    for verdict in ("stable", "unstable"):
        pairs = [
            (own[one["seed"]], one)
            for one in other
            if one["seed"] in own and own[one["seed"]]["verdict"] == verdict
        ]
        if not pairs:
            continue
        theirs = [one["seconds"] for _, one in pairs]
        ours = statistics.median(one["seconds"] for one, _ in pairs)
        opposite = _VERDICTS[verdict != "stable"]
        wrong = [b["seed"] for _, b in pairs if b["verdict"] == opposite]
        silent = sum(b["verdict"] not in (verdict, opposite) for _, b in pairs)
        note = f"  none within {MILP_SECONDS} s: {silent}" if silent else ""
        note += f"  WRONG: seeds {wrong}" if wrong else ""
        median = statistics.median(theirs)
        print(
            f"  {name:<42} {verdict:<9} {len(pairs):>3} {shown(median):>9}"
            f" ({shown(max(theirs)):>9}) {median / ours:>9.3g} times ours{note}",
            flush=True,
        )


def shown(value: float) -> str:
    """Return a time with three digits."""
    return f"{1000 * value:.3g} ms" if value < 1 else f"{value:.3g} s"
