"""Physics engines beside exact slip loads: ``run.py --only simulators``.

Each engine takes the sixty scenes of `equilibrium.scenes.benchmark` and three loads of each. A load
grows slowly in one of two ways: together with the preloads, so that the exact motion keeps its
direction and an engine that follows it stays at the equilibrium of the law; or after the preloads,
when the object has settled under them. Then it is held. The share of the load that damping carries
is the measure: an object at rest leaves nothing to it.

An object *creeps* by its share at a quarter of the exact slip load. It *slips* at a load whose
share stays larger than that by `Rule.share`, or goes far. The slip load is found by bisection. A
load that is exactly resisted without end is tried at `NEVER` times the usual force.

Preloads that grow slowly without a load have *not settled* while damping carries more than `REST`
of the usual force: no slip load is asked for then.
"""

from __future__ import annotations

import csv
import math
import statistics
import time
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from itertools import islice, product
from pathlib import Path
from typing import Any

import numpy as np
from engines import Advance, Setting, settings

from arrangement.console.progress import watched
from equilibrium.scenes import FREQUENCY, MOTION, EngineScene, benchmark

#: Bisections of twice the exact slip load, and the largest load tried where there is none.
STEPS, NEVER = 8, 16
#: A load grows in so many parts.
PARTS = 50
#: What is carried beyond is not creep.
MOST_CREEP = 1 / 10
#: Settled: damping carries at most this share of the usual force.
REST = 1 / 100
#: An object that goes so many times as far as its usual motion while nothing grows, slips; where
#: there is no exact slip load, in proportion to the load.
FAR = 10
#: Seconds of which the mean speed is taken.
WINDOW = 10 / FREQUENCY


@dataclass(frozen=True)
class Rule:
    """When a load slips.

    Attributes:
        share: damping carries this much more of it than of a quarter of the exact slip load.
        ramp: seconds over which a load grows.
        windows: of time, for which the object may go on.
        damping: of the object, times that of the scene.
    """

    share: float = 1 / 100
    ramp: float = 20 / FREQUENCY
    windows: int = 10
    damping: float = 1


#: The first is the one measured with; the others show how much it matters.
RULES = {
    "as measured": Rule(),
    "a share of 1/50": Rule(share=1 / 50),
    "a share of 1/200": Rule(share=1 / 200),
    "twice the ramp": Rule(ramp=40 / FREQUENCY),
    "half the time": Rule(windows=5),
    "twice the time": Rule(windows=20),
    "twice the damping": Rule(damping=2),
    "half the damping": Rule(damping=1 / 2),
}


class Trial:
    """One run of an engine: a scene under a load.

    Attributes:
        place: of the object, away from its start; turns times the size of the scene.
    """

    def __init__(self, scene: EngineScene, load: int, setting: Setting, rule: Rule) -> None:
        self.scene, self.rule = scene, rule
        self.damping = rule.damping * scene.damping
        self.lever = np.ones(len(scene.directions[load]))
        self.lever[scene.grasp.dimension :] = scene.size
        wrench = np.array([float(x) for x in scene.directions[load]])
        self.force = float(np.linalg.norm(wrench / self.lever))
        self.advance: Advance = setting.make(scene, load, self.damping, **setting.options)
        self.place = 0 * self.lever

    def grow(self, t: float, pressing: bool) -> None:
        """Let a load grow slowly, and the preloads if they are not there yet."""
        for part in np.arange(1, PARTS + 1) / PARTS:
            pressed = part if pressing else 1
            self.place = self.advance(self.rule.ramp / PARTS, part * t, pressed) * self.lever

    def wait(self, t: float, force: float, most: float, far: float = FAR) -> float:
        """Run until damping carries at most this share of a force; return the last such share.

        It is infinite where the object goes so many times as far as its usual motion.
        """
        share, begin = self.damping / force, self.place
        for _ in range(self.rule.windows):
            place = self.place
            self.place = self.advance(WINDOW, t, 1) * self.lever
            carried = share * float(np.linalg.norm(self.place - place)) / WINDOW
            if np.linalg.norm(self.place - begin) > far * MOTION * self.scene.size:
                return math.inf
            if carried <= most:
                break
        return carried

    def settles(self, force: float) -> bool:
        """Let the preloads grow; return whether damping comes to carry little of a force."""
        self.grow(0, True)
        return self.wait(0, force, REST) <= REST

    def carried(self, t: float, together: bool, most: float, far: float) -> float:
        """Return the share of a load that damping carries, as soon as it is at most that."""
        if not together:
            self.settles(self.scene.force)
        self.grow(t, together)
        return self.wait(t, t * self.force, most, far)


def exact_end(known: dict[str, Any]) -> float | None:
    """Return the first end of what is exactly resisted; None where there is none."""
    if "resisted" in known:
        end = known["resisted"][0][1] if known["resisted"] else "0"
    else:
        end = known["borders"][0]["resisted"] if known["borders"] else None
    return None if end is None else float(Fraction(end))


def slip_load(
    scene: EngineScene,
    load: int,
    end: float | None,
    setting: Setting,
    together: bool,
    rule: Rule = RULES["as measured"],
) -> tuple[float | None, float]:
    """Return the slip load of an engine, None where it holds all that is tried; and its creep."""

    def carried(t: float, most: float) -> float:
        trial = Trial(scene, load, setting, rule)
        far = 1 if end else max(1, t * trial.force / scene.force)
        return trial.carried(t, together, most, FAR * far)

    low, high = 0.0, 2 * end if end else NEVER * scene.force
    creep = carried(end / 4 if end else high / 4, 0)
    most = min(creep + rule.share, MOST_CREEP)
    if carried(high, most) <= most:
        return None, creep
    for _ in range(STEPS):
        middle = (low + high) / 2
        low, high = (low, middle) if carried(middle, most) > most else (middle, high)
    return (low + high) / 2, creep


def comparable(scene: EngineScene) -> Iterator[tuple[int, float | None]]:
    """Yield loads and their exact slip loads; not those of which nothing at all is resisted."""
    for load, known in enumerate(scene.loads()):
        end = exact_end(known)
        if end is None or end >= 1e-6 * scene.force:
            yield load, end


def measure(every: int = 1) -> Iterator[dict[str, Any]]:
    """Yield a row for each scene, load, setting and start.

    Args:
        every: only each such scene.
    """
    for k, (name, scene) in enumerate(islice(benchmark(), 0, None, every)):
        loads = list(comparable(scene))
        for setting in settings():
            if k % setting.sample or scene.grasp.dimension not in setting.dimensions:
                continue
            settles = Trial(scene, 0, setting, RULES["as measured"]).settles(scene.force)
            for together, (load, end) in product((True, False), loads):
                slip, creep, began = "not settled", "", time.process_time()
                if settles:
                    found, share = slip_load(scene, load, end, setting, together)
                    slip, creep = "none" if found is None else f"{found:.6g}", f"{share:.2g}"
                yield {
                    "scene": name,
                    "load": load + 1,
                    "exact": "never" if end is None else f"{end:.6g}",
                    "engine": setting.engine,
                    "setting": setting.name,
                    "start": "together" if together else "preload first",
                    "slip": slip,
                    "creep": creep,
                    "seconds": f"{time.process_time() - began:.2f}",
                }


def summary(rows: list[dict[str, Any]]) -> Iterator[list[str]]:
    """Yield a line of the table for each setting and start, below its heading."""
    yield [
        "engine",
        "setting",
        "start",
        "not settled",
        "loads that end",
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
        mine = [r for r in rows if (r["engine"], r["setting"], r["start"]) == kind]
        own = [r for r in mine if r["slip"] != "not settled"]
        ending = [r for r in own if r["exact"] != "never"]
        held = [r for r in ending if r["slip"] == "none"]
        ratios = sorted(float(r["slip"]) / float(r["exact"]) for r in ending if r["slip"] != "none")
        ends = [ratios[round(share * (len(ratios) - 1))] for share in (0.05, 0.95) if ratios]
        never = [r for r in own if r["exact"] == "never"]
        yield [
            *kind,
            f"{len(mine) - len(own)} of {len(mine)}",
            str(len(ending)),
            f"{statistics.median(ratios):.3f}" if ratios else "",
            " to ".join(f"{x:.2f}" for x in ends),
            f"{sum(abs(x - 1) < 0.03 for x in ratios)} of {len(ending)}",
            str(len(held)),
            f"{sum(r['slip'] != 'none' for r in never)} of {len(never)}",
            *(
                f"{statistics.median(float(r[key]) for r in own):.2g}" if own else ""
                for key in ("creep", "seconds")
            ),
        ]


def rule_lines() -> Iterator[str]:
    """Yield how slip loads change with the rule: each fifteenth scene, elliptic, impratio 100."""
    setting = next(s for s in settings() if s.options.get("impratio") == 100)
    found: dict[str, list[float]] = {}
    for _, scene in islice(benchmark(), 0, None, 15):
        for load, end in comparable(scene):
            for name, rule in RULES.items() if end else ():
                slip, _ = slip_load(scene, load, end, setting, True, rule)
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
