"""Physics engines beside exact slip loads: ``run.py --only simulators``.

Each engine takes the sixty scenes of `equilibrium.scenes.benchmark` and three loads of each. A load
grows slowly in one of two ways: together with the preloads, so that the exact motion keeps its
direction and an engine that follows it stays at the equilibrium of the law; or after the preloads.
Then it is held. What the damping of the object carries at the end, as a share of the load, is the
measure: an object at rest leaves nothing to it.

An object *creeps* when this share is the same for a small and a large load. It *slips* at a load
whose share is larger by `Rule.share` than that of a quarter of the load. The slip load is found by
bisection. A load that is exactly resisted without end is tried at `NEVER` times the usual force.

A new engine is one function: it takes a scene, which load, its magnitude, whether the preloads grow
with it, and settings, and returns velocities of the object near the end, (x, y, turn) or
(x, y, z, three turns).
"""

from __future__ import annotations

import csv
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from arrangement.console.progress import watched
from equilibrium.scenes import FREQUENCY, EngineScene, benchmark

#: Bisections of twice the exact slip load, and the largest load tried where there is none.
STEPS, NEVER = 8, 16
#: The load grows in so many steps.
PARTS = 50


@dataclass(frozen=True)
class Rule:
    """When a load slips.

    Attributes:
        share: damping carries this much more of it than of a quarter of it.
        ramp: seconds over which a load grows; it is held for twice as long, and the last quarter of
            that is looked at.
        damping: of the object, times that of the scene.
    """

    share: float = 1 / 100
    ramp: float = 20 / FREQUENCY
    damping: float = 1


#: The first is the one measured with; the others show how much it matters.
RULES = {
    "as measured": Rule(),
    "a share of 1/50": Rule(share=1 / 50),
    "a share of 1/200": Rule(share=1 / 200),
    "twice the time": Rule(ramp=40 / FREQUENCY),
    "twice the damping": Rule(damping=2),
    "half the damping": Rule(damping=1 / 2),
}


@dataclass(frozen=True)
class Setting:
    """An engine with its settings."""

    engine: str
    name: str
    run: Callable[..., np.ndarray]
    options: dict[str, Any]


def mujoco_run(
    scene: EngineScene, load: int, t: float, together: bool, rule: Rule, **options: Any
) -> np.ndarray:
    """Run a scene in MuJoCo: cone, impratio, noslip iterations, time step."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(scene.mjcf())
    option = model.opt
    option.cone = getattr(mujoco.mjtCone, f"mjCONE_{options['cone'].upper()}")
    option.impratio = options.get("impratio", 1)
    option.noslip_iterations = options.get("noslip", 0)
    option.timestep = options.get("step", 2e-3)
    data = mujoco.MjData(model)
    moves = 3 if scene.grasp.dimension == 2 else 6
    places = 3 if moves == 3 else 7
    springs, steps = model.qpos_spring[places:].copy(), round(rule.ramp / option.timestep)
    model.dof_damping[:moves] *= rule.damping
    if not together:
        mujoco.mj_step(model, data, nstep=steps)
    for part in range(1, PARTS + 1):
        data.ctrl[load] = t * part / PARTS
        if together:
            model.qpos_spring[places:] = springs * part / PARTS
        mujoco.mj_step(model, data, nstep=steps // PARTS)
    mujoco.mj_step(model, data, nstep=steps * 3 // 2)
    before = data.qpos.copy()
    mujoco.mj_step(model, data, nstep=steps // 2)
    moved = np.zeros(moves)
    mujoco.mj_differentiatePos(model, whole := np.zeros(model.nv), 1, before, data.qpos)
    moved[:] = whole[:moves]
    return moved / (steps // 2 * option.timestep)


def pymunk_run(
    scene: EngineScene, load: int, t: float, together: bool, rule: Rule, **options: Any
) -> np.ndarray:
    """Run a scene in the plane in pymunk: iterations, time step."""
    import pymunk

    space = pymunk.Space()
    space.iterations = options["iterations"]
    space.collision_slop = scene.size * 1e-6
    body = pymunk.Body(scene.mass, scene.mass * scene.size**2)
    centre = scene.centre[:2]
    body.position, origin = tuple(centre), tuple(-centre)
    space.add(body)
    fingers = []
    for i, (pad, given) in enumerate(zip(scene.pads, scene.fingers, strict=True)):
        alone = pymunk.ShapeFilter(categories=1 << i, mask=1 << i)
        normal, middle = np.array(given["axis"][:2]), np.array(pad["centre"][:2]) - centre
        along = np.array([-normal[1], normal[0]]) * pad["halves"][0]
        across = normal * pad["halves"][2]
        corners = [middle + s * along + r * across for s, r in ((1, 1), (1, -1), (-1, -1), (-1, 1))]
        flat = pymunk.Poly(body, [tuple(x) for x in corners])
        flat.friction, flat.filter = 1.0, alone
        finger = pymunk.Body(given["mass"], float("inf"))
        start = np.array(given["centre"][:2])
        finger.position = tuple(start)
        ball = pymunk.Circle(finger, given["radius"])
        ball.friction, ball.filter = given["friction"], alone
        ends = [tuple(start + s * normal * scene.size) for s in (-1, 1)]
        groove = pymunk.GrooveJoint(space.static_body, finger, *ends, (0, 0))
        space.add(flat, finger, ball, groove)
        fingers.append((finger, given, normal, start))
    wrench, damping = [t * float(x) for x in scene.directions[load]], rule.damping * scene.damping
    step, steps = options["step"], round(rule.ramp / options["step"])

    def advance(number: int, share: float, pressed: float) -> None:
        for _ in range(number):
            for finger, given, normal, start in fingers:
                out = float(np.dot(finger.position - start, normal))
                force = given["preload"] * pressed - given["stiffness"] * out
                force -= given["damping"] * float(np.dot(finger.velocity, normal))
                finger.force = tuple(force * normal)
            x, y = body.velocity_at_local_point(origin)
            push = np.array(wrench[:2]) * share - damping * np.array([x, y])
            # Forces act at the origin; pymunk takes them at the centre of mass.
            body.force = tuple(push)
            turn = wrench[2] * share - damping * scene.size**2 * body.angular_velocity
            lever = np.array(body.local_to_world(origin)) - body.position
            body.torque = turn + float(lever[0] * push[1] - lever[1] * push[0])
            space.step(step)

    if not together:
        advance(steps, 0, 1)
    for part in range(1, PARTS + 1):
        advance(steps // PARTS, part / PARTS, part / PARTS if together else 1)
    advance(steps * 3 // 2, 1, 1)
    place = lambda: np.array([*body.local_to_world(origin), body.angle])  # noqa: E731
    before = place()
    advance(steps // 2, 1, 1)
    return (place() - before) / (steps // 2 * step)


def settings() -> Iterator[Setting]:
    """Yield what is measured; an engine that is not installed is left out, and said."""
    for cone in ("elliptic", "pyramidal"):
        for options in (
            {"impratio": 1},
            {"impratio": 10},
            {"impratio": 100},
            {"impratio": 10, "noslip": 10},
            {"impratio": 10, "step": 5e-4},
        ):
            words = ", ".join(f"{key} {value:g}" for key, value in options.items())
            yield Setting("mujoco", f"{cone}, {words}", mujoco_run, {"cone": cone, **options})
    for iterations in (10, 50):
        options = {"iterations": iterations, "step": 2e-3}
        yield Setting("pymunk", f"{iterations} iterations", pymunk_run, options)


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
    for name, scene in islice(benchmark(), 0, None, every):
        for load, (known, _) in enumerate(scene.loads()):
            end = exact_end(known)
            if end is not None and end < 1e-6 * scene.force:
                continue  # No load at all is resisted, so there is none to compare with.
            for setting in settings():
                if setting.engine == "pymunk" and scene.grasp.dimension == 3:
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
