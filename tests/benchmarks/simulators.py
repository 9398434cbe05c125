"""Physics engines beside exact slip loads: ``run.py --only simulators``.

Each engine takes the sixty scenes of `equilibrium.scenes.benchmark` and three loads of each. A load
grows slowly in one of two ways: together with the preloads, so that the exact motion keeps its
direction and an engine that follows it stays at the equilibrium of the law; or after the preloads.
Then it is held. What the damping of the object carries at the end, as a share of the load, is the
measure: an object at rest leaves nothing to it.

An object *creeps* when this share is the same for a small and a large load. It *slips* at a load
whose share is larger by `Rule.share` than that of a quarter of the load. The slip load is found by
bisection. A load that is exactly resisted without end is tried at `NEVER` times the usual force.
"""

from __future__ import annotations

import csv
import statistics
import time
from collections.abc import Iterator
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from engines import Rule, Setting, settings

from arrangement.console.progress import watched
from equilibrium.scenes import FREQUENCY, EngineScene, benchmark

#: Bisections of twice the exact slip load, and the largest load tried where there is none.
STEPS, NEVER = 8, 16

#: The first is the one measured with; the others show how much it matters.
RULES = {
    "as measured": Rule(),
    "a share of 1/50": Rule(share=1 / 50),
    "a share of 1/200": Rule(share=1 / 200),
    "twice the time": Rule(ramp=40 / FREQUENCY),
    "twice the damping": Rule(damping=2),
    "half the damping": Rule(damping=1 / 2),
}


def carried(
    scene: EngineScene,
    load: int,
    t: float,
    setting: Setting,
    together: bool,
    rule: Rule = RULES["as measured"],
) -> float:
    """Return the share of a load that the damping of the object carries."""
    half, lever = scene.grasp.dimension, np.ones(3 if scene.grasp.dimension == 2 else 6)
    lever[half:] = scene.size
    moved = setting.run(scene, load, t, together, rule, **setting.options) * lever
    wrench = np.array([float(x) for x in scene.directions[load]]) / lever
    return float(rule.damping * scene.damping * np.linalg.norm(moved) / np.linalg.norm(t * wrench))


def slips(
    scene: EngineScene, load: int, t: float, setting: Setting, together: bool, rule: Rule
) -> bool:
    """Return whether a load slips, as the head of this file says."""
    large, small = (carried(scene, load, x, setting, together, rule) for x in (t, t / 4))
    return not large - small <= rule.share


def exact_end(known: dict[str, Any]) -> float | None:
    """Return the first end of what is exactly resisted; None where there is none."""
    if "resisted" in known:
        end = known["resisted"][0][1] if known["resisted"] else "0"
    else:
        end = known["borders"][0]["resisted"] if known["borders"] else None
    return None if end is None else float(Fraction(end))


def slip_load(scene: EngineScene, load: int, end: float | None, *how: Any) -> float | None:
    """Return the slip load of an engine; None where it holds all that is tried."""
    low, high = 0.0, 2 * end if end else NEVER * scene.force
    if not slips(scene, load, high, *how):
        return None
    for _ in range(STEPS):
        middle = (low + high) / 2
        low, high = (low, middle) if slips(scene, load, middle, *how) else (middle, high)
    return (low + high) / 2


def measure(every: int = 1) -> Iterator[dict[str, Any]]:
    """Yield a row for each scene, load, setting and start.

    Args:
        every: only each such scene.
    """
    for k, (name, scene) in enumerate(islice(benchmark(), 0, None, every)):
        for load, (known, _) in enumerate(scene.loads()):
            end = exact_end(known)
            if end is not None and end < 1e-6 * scene.force:
                continue  # No load at all is resisted, so there is none to compare with.
            for setting in settings():
                if k % setting.sample or scene.grasp.dimension not in setting.dimensions:
                    continue
                for together in (True, False):
                    how, began = (setting, together, RULES["as measured"]), time.process_time()
                    slip = slip_load(scene, load, end, *how)
                    seconds = time.process_time() - began
                    half = end / 2 if end else scene.force
                    yield {
                        "scene": name,
                        "load": load + 1,
                        "exact": "never" if end is None else f"{end:.6g}",
                        "engine": setting.engine,
                        "setting": setting.name,
                        "start": "together" if together else "preload first",
                        "slip": "none" if slip is None else f"{slip:.6g}",
                        "creep": f"{carried(scene, load, half, *how):.2g}",
                        "seconds": f"{seconds:.2f}",
                    }


def summary(rows: list[dict[str, Any]]) -> Iterator[list[str]]:
    """Yield a line of the table for each setting and start, below its heading."""
    yield [
        "engine",
        "setting",
        "start",
        "loads",
        "slip / exact: median",
        "5 % to 95 %",
        "within 3 %",
        "holds twice the exact load",
        "slips though exactly never",
        "creep",
        "seconds",
    ]
    kinds = dict.fromkeys((r["engine"], r["setting"], r["start"]) for r in rows)
    for kind in kinds:
        own = [r for r in rows if (r["engine"], r["setting"], r["start"]) == kind]
        ending = [r for r in own if r["exact"] != "never"]
        held = [r for r in ending if r["slip"] == "none"]
        ratios = sorted(float(r["slip"]) / float(r["exact"]) for r in ending if r["slip"] != "none")
        low, high = (ratios[round(share * (len(ratios) - 1))] for share in (0.05, 0.95))
        never = [r for r in own if r["exact"] == "never"]
        yield [
            *kind,
            str(len(ending)),
            f"{statistics.median(ratios):.3f}",
            f"{low:.2f} to {high:.2f}",
            f"{sum(abs(x - 1) < 0.03 for x in ratios)} of {len(ending)}",
            str(len(held)),
            f"{sum(r['slip'] != 'none' for r in never)} of {len(never)}",
            f"{statistics.median(float(r['creep']) for r in own):.1g}",
            f"{statistics.median(float(r['seconds']) for r in own):.2g}",
        ]


def rule_lines() -> Iterator[str]:
    """Yield how slip loads change with the rule: on every tenth scene, with the first settings."""
    chosen = {setting.engine: setting for setting in settings()}
    found: dict[str, list[float]] = {}
    for _, scene in islice(benchmark(), 0, None, 10):
        for load, (known, _) in enumerate(scene.loads()):
            end = exact_end(known)
            if end is None or end < 1e-6 * scene.force:
                continue
            for name, rule in RULES.items():
                slip = slip_load(scene, load, end, chosen["mujoco"], True, rule)
                found.setdefault(name, []).append((slip or 2 * end) / end)
    base = found["as measured"]
    for name, ratios in found.items():
        changes = sorted(abs(a - b) for a, b in zip(ratios, base, strict=True))
        middle, change = statistics.median(ratios), statistics.median(changes)
        yield f"{name}: median {middle:.3f}; changed by {change:.3f}, at most {changes[-1]:.3f}"


def simulator_table(every: int = 1, folder: str | None = None) -> None:
    """Measure, print the table, and write all rows and the table as CSV files if asked."""
    print("\nSlip loads of physics engines beside the exact ones", flush=True)
    for engine in ("mujoco", "pymunk"):
        try:
            print(f"  {engine} {version(engine)}")
        except PackageNotFoundError:
            print("  one is not installed: pip install -e '.[simulators]'")
            return
    rows = list(watched(measure(every), "slip loads"))
    lines = list(summary(rows))
    for line in lines:
        print("  " + " | ".join(line))
    print("  How much the rule matters, of slip loads as shares of the exact ones:")
    for line in rule_lines():
        print(f"    {line}", flush=True)
    if folder is not None:
        for name, table in (
            ("slip-loads", [list(rows[0]), *(list(r.values()) for r in rows)]),
            ("slip-table", lines),
        ):
            with (Path(folder) / f"{name}.csv").open("w", newline="", encoding="utf-8") as stream:
                csv.writer(stream, lineterminator="\n").writerows(table)
