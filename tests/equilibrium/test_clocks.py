"""No answer depends on a clock: the same bytes on a slow, a fast and a busy machine."""

import json
import math
import time
from itertools import count

import pytest

from arrangement.numbers import deadline
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import from_float_data, random_grasp

THREE = "paper-three-contacts-preload-1"
QUESTIONS = [
    ["solve", THREE, "--wrench", "0", "1/2", "1/2"],
    ["solve", "SOFT", "--wrench", "1", "0", "-1", "0", "0", "1/2"],
    ["solve", "peg-in-a-hole", "--wrench", "0", "0", "-3/2", "0", "0", "0", "--json"],
    ["solve", "peg-in-a-hole", "--wrench", "0", "0", "-1", "0", "0", "1", "--cone", "pyramid:6"],
    ["resisted", THREE, "--wrench", "0", "1", "0", "--margin"],
    ["resisted", THREE, "--slice", "fx", "fy", "--json"],
    ["info", "box-1-wall", "--modes", "--count"],
    ["solve", "DISC", "--wrench", "1", "-2", "0", "--json"],
    ["solve", THREE, "--wrench", "0", "1/2", "0", "--robust", "degrees=1/10", "friction=5%"],
    ["resisted", "two-opposed-fingers", "--wrench", "0", "3/5", "4/5", "0", "0", "0"],
]
REAL = time.perf_counter
#: A second for each look, and clocks that go a hundred times as fast and as slow.
CLOCKS = {
    "steps": count().__next__,
    "fast": lambda: 100 * REAL(),
    "slow": lambda: REAL() / 100,
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Return a grasp whose equilibria are not small motions, and a disc with rounded data."""
    around = [
        (math.cos(math.radians(a)), math.sin(math.radians(a))) for a in (0, 72, 144, 216, 300)
    ]
    points, normals = [[0.03 * x, 0.03 * y] for x, y in around], [[-x, -y] for x, y in around]
    grasps = {
        "SOFT": random_grasp(4, 2, dimension=3),
        "DISC": from_float_data(points, normals, 0.0).grasp,
    }
    folder = tmp_path_factory.mktemp("clocks")
    for name, grasp in grasps.items():
        (folder / name).with_suffix(".json").write_text(json.dumps(grasp.to_dict()))
    return {name: str((folder / name).with_suffix(".json")) for name in grasps}


@pytest.mark.parametrize("words", QUESTIONS, ids=lambda words: f"{words[0]}-{words[1]}"[:30])
def test_clocks_change_no_byte(words, files, capsys, monkeypatch):
    asked, answers = [files.get(word, word) for word in words], {}
    for name, clock in {"usual": REAL, **CLOCKS}.items():
        with monkeypatch.context() as patch:
            patch.setattr(deadline, "clock", clock)
            for each in ("process_time", "perf_counter", "monotonic"):
                patch.setattr(time, each, clock)
            answers[name] = main(asked), capsys.readouterr().out
    assert len(set(answers.values())) == 1, answers
    assert answers["usual"][0] in (0, 1, 3)
