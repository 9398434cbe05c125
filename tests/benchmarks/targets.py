"""Measured times and their targets: ``run.py --only targets``.

Times are medians of CPU seconds; those of commands include the start. Of two targets the second is
for the largest time. Work that fails misses its target. Ten minutes on two idle cores.
"""

import json
import math
import statistics
from collections.abc import Iterable
from fractions import Fraction
from random import Random

from graspjob import BORDER, VERDICTS
from grasps import run, shown
from peers import ours
from pictures import seconds

from equilibrium import Contact, Grasp
from equilibrium.grasps.inputs import random_grasp
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.textbook import arch, stack

REFUTED = VERDICTS[False]
#: Contacts, the targets of median and largest time; for grasps in space, and how many grasps.
NEAR_LIMIT = ((20, 0.02, 0.25), (50, 0.025, 0.6), (100, 0.08, 0.6), (1000, 0.3, 2.0))
IN_SPACE = ((8, 0.2, 20), (12, 0.9, 8))
DOWN, IN_THREE = ["--wrench", "0", "-1", "0"], ["--wrench", "0", "0", "-1", "0", "0", "0"]
#: Jobs of `job.py`, their numbers, what they do, the target in seconds.
JOBS = (
    ("loads_in_the_plane", 1000, "1000 loads on 8 contacts in the plane", 2.0),
    ("loads_in_space", 1000, "1000 loads on 4 contacts in space", 4.0),
    ("loads_as_arrays", 10_000, "10,000 loads on 8 contacts as arrays", 5.0),
    ("grasps_in_the_plane", 10_000, "10,000 grasps of 3 to 8 contacts as arrays", 10.0),
    ("grasps_in_the_plane_alone", 100, "100 of these one by one", 10.0),
    ("grasps_in_space", 200, "200 grasps in space of 3 to 8 contacts as arrays", 1.0),
    ("grasps_in_space_alone", 200, "the same one by one", 30.0),
)
#: The same for jobs that report the microseconds of one item.
MEDIANS = (
    ("measured_limits", 12, "`resisted` in space from float data, a direction", 1.0),
    ("inscribed_types", 50, "inscribability of a class of nine planes", 0.03),
)
LIMIT = 300
DIGITS = 300


def target_table() -> None:
    print("\nMeasured times and targets: median (largest)", flush=True)
    for m, *targets in NEAR_LIMIT:
        seeds = [BORDER + seed for seed in range(12 if m < 1000 else 8) if seed % 4 >= 2]
        _line(f"close to the limit, {m} contacts", _refuted(run("ours", m, seeds, LIMIT)), *targets)
    for m, target, count in IN_SPACE:
        listed = run("ours", m, range(count), LIMIT, "spacejob.py")
        _line(f"not resisted in space, {m} contacts", _refuted(listed), target)
    for program, text, given, target in _commands():
        _line(text, [seconds(program, options, document) for options, document in given], target)
    for name, number, text, target in JOBS:
        found = ours(name, number, LIMIT)
        _line(text, [] if found.absent else [found.first], target)
    for name, number, text, target in MEDIANS:
        found = ours(name, number, LIMIT)
        _line(text, [] if found.absent else [found.count / 1e6], target)
    found = ours("foretold", 9, LIMIT)
    print(f"  resonance 9: forecast of {found.count:,} steps", flush=True)


def _refuted(listed: list[dict[str, object]]) -> list[float]:
    return [float(str(one["seconds"])) for one in listed if one["verdict"] == REFUTED]


def _line(text: str, times: Iterable[float], *targets: float) -> None:
    found = sorted(times) or [math.inf]
    median, goal = statistics.median(found), " ".join(map(shown, targets))
    late = median > targets[0] or found[-1] > targets[-1] > targets[0]
    print(
        f"  {text:<46} {shown(median):>9} ({shown(found[-1]):>8})  target {goal:<16}"
        f" {'missed' if late else 'met'}",
        flush=True,
    )


def _commands() -> Iterable[tuple[str, str, list[tuple[list[str], str]], float]]:
    """Yield a program, what it does, its options with documents, and the target in seconds."""
    three = _text(read_grasp("paper-three-contacts-preload-1"))
    yield (
        "equilibrium",
        "`solve` on three contacts, its start included",
        [(["solve", *DOWN], three)] * 3,
        0.25,
    )
    fingers = _text(read_grasp("three-fingers-on-a-ball"))
    yield (
        "equilibrium",
        "`resisted` in space, three fingers",
        [(["resisted", *IN_THREE], fingers)] * 3,
        0.4,
    )
    bodies = (("arch of 5 stones", arch(), 2, 5), ("tower of 50 blocks", stack(blocks=50), 2, 2))
    for name, (assembly, weights), target, further in bodies:
        document = json.dumps(assembly.to_dict(weights))
        push = ["--along", assembly.names[-1], "1", "0", "0"]
        yield "equilibrium", f"`solve`, {name}", [(["solve"], document)] * 3, target
        yield (
            "equilibrium",
            f"`resisted --along`, {name}",
            [(["resisted", *push], document)] * 3,
            further,
        )
    long = [_text(long_grasp(4, seed)) for seed in range(1, 4)]
    for name, words in (
        ("margin", ["resisted", *DOWN, "--margin"]),
        ("compare", ["solve", *DOWN, "--methods"]),
    ):
        given = [([*words, "--limit", "4"], document) for document in long]
        yield "equilibrium", f"`{name}`, 4 contacts, {DIGITS} digits", given, 1.0


def _text(grasp: Grasp) -> str:
    return json.dumps(grasp.to_dict())


def long_grasp(contacts: int, seed: int) -> Grasp:
    """Return a random grasp whose numbers are decimals of so many digits."""
    source = Random(f"long {seed}")

    def near(value: Fraction, digits: int = DIGITS) -> Fraction:
        size = 10**digits
        return Fraction(round(value * size) + source.randrange(size // 1000), size)

    def turned(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        t = near(y / (1 + x) if x != -1 else Fraction(100), DIGITS // 2)
        return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)

    return Grasp(
        Contact(
            tuple(map(near, contact.point)),
            turned(*contact.normal),
            near(contact.friction),
            near(contact.stiffness),
            contact.preload and near(contact.preload),
        )
        for contact in random_grasp(contacts, seed)
    )
