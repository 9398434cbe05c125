"""Times of pictures and pages as a user waits for them: whole commands, start to file."""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from arrangement.library.families import random_integer
from equilibrium.grasps.inputs import random_grasp
from equilibrium.grasps.inputs.documents import read_grasp

#: The default target of a command, in CPU seconds.
AIM = 3.0
#: Seconds by the clock that a command has.
LIMIT = 300


def picture_table() -> None:
    """Print the CPU time of each command, over three random inputs."""
    print("\nPictures and pages: whole commands")
    print(f"  {'':<52} median slowest target")
    grasp = ("equilibrium", "contacts", lambda m, seed: random_grasp(m, seed).to_dict())
    loaded = (
        "equilibrium", "preloaded contacts",
        lambda m, seed: random_grasp(m, seed).with_preload(1).to_dict(),
    )  # fmt: skip
    planes = ("arrangement", "planes", lambda m, seed: random_integer(m, 3, seed=seed).to_dict())
    walls = ("equilibrium", "walls", lambda m, _: read_grasp(f"box-{m}-walls").to_dict())
    ball = read_grasp("three-fingers-on-a-ball").to_dict()
    fingers = ("equilibrium", "fingers", lambda *_: ball)
    for (program, things, make), size, options, target in (
        (grasp, 30, ["--wrench", "0", "-1", "0", "-o", "a.svg"], AIM),
        (grasp, 12, ["--view", "resist", "-o", "a.svg"], 1.5),
        (grasp, 8, ["-o", "a.html"], AIM),
        (loaded, 6, ["--view", "wrench-set", "-o", "a.svg"], 1.5),
        (walls, 3, ["--view", "slice", "-o", "a.svg"], AIM),
        (walls, 4, ["--view", "slice", "-o", "a.svg"], 5.0),
        (fingers, 3, ["--view", "slice", "-o", "a.svg"], 1.5),
        (planes, 30, ["--view", "dual", "-o", "a.svg"], 1.5),
    ):
        times = sorted(
            seconds(program, ["draw", *options], json.dumps(make(size, seed)))
            for seed in range(1, 4)
        )
        answer = "met" if times[1] <= target else "missed"
        view = "page" if options[-1] == "a.html" else "grasp"
        if "--view" in options:
            view = options[1]
        what = f"{program} draw, {view}, {size} {things}"
        print(f"  {what:<52} {times[1]:.2f} s {times[-1]:.2f} s {target:g} s {answer}", flush=True)


def seconds(program: str, words: list[str], document: str) -> float:
    """Return the CPU time of a command on a document, infinite where it fails.

    The answer "no" is not a failure.
    """
    name, *options = words
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "given.json").write_text(document, encoding="utf-8")
        command = [sys.executable, "-m", program, name, "given.json", *options]
        # As of an installed program, modules are compiled once.
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": ""}
        before = os.times()
        try:
            done = subprocess.run(
                command,
                cwd=folder,
                env=environment,
                capture_output=True,
                timeout=LIMIT,
                check=False,
            )
            problem = done.stderr.decode() if done.returncode not in (0, 1) else ""
        except subprocess.TimeoutExpired as late:
            problem = str(late)
        after = os.times()
        if problem:
            print(f"  {program} {name}: {problem.strip().splitlines()[-1]}", flush=True)
            return math.inf
    passed = zip(before[2:4], after[2:4], strict=True)
    return sum(end - start for start, end in passed)


if __name__ == "__main__":
    picture_table()
