"""No answer depends on a clock: the same bytes on a slow, a fast and a busy machine."""

import json
import time
from itertools import count

import pytest

from arrangement.numbers import deadline
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import random_grasp

THREE = "paper-three-contacts-preload-1"
QUESTIONS = [
    ["solve", THREE, "--wrench", "0", "1/2", "1/2"],
    ["solve", "SOFT", "--wrench", "1", "0", "-1", "0", "0", "1/2"],
    ["solve", "peg-in-a-hole", "--wrench", "0", "0", "-3/2", "0", "0", "0", "--json"],
    ["solve", "peg-in-a-hole", "--wrench", "0", "0", "-1", "0", "0", "1", "--cone", "pyramid:6"],
    ["margin", THREE, "--wrench", "0", "1", "0"],
    ["region", THREE, "--json"],
    ["modes", "box-1-wall", "--count"],
    ["limit", "two-opposed-fingers", "--direction", "0", "3/5", "4/5", "0", "0", "0"],
]
REAL = time.perf_counter
#: A second for each look, and clocks that go a hundred times as fast and as slow.
CLOCKS = {
    "steps": count().__next__,
    "fast": lambda: 100 * REAL(),
    "slow": lambda: REAL() / 100,
}


@pytest.fixture(scope="module")
def soft(tmp_path_factory):
    """Return a file of a grasp whose equilibria are no small motions."""
    path = tmp_path_factory.mktemp("clocks") / "soft.json"
    path.write_text(json.dumps(random_grasp(4, 2, dimension=3).to_dict()))
    return str(path)


@pytest.mark.parametrize("words", QUESTIONS, ids=lambda words: f"{words[0]}-{words[1]}"[:30])
def test_clocks_change_no_byte(words, soft, capsys, monkeypatch):
    asked, answers = [soft if word == "SOFT" else word for word in words], {}
    for name, clock in {"usual": REAL, **CLOCKS}.items():
        with monkeypatch.context() as patch:
            patch.setattr(deadline, "clock", clock)
            for each in ("process_time", "perf_counter", "monotonic"):
                patch.setattr(time, each, clock)
            answers[name] = main(asked), capsys.readouterr().out
    assert len(set(answers.values())) == 1, answers
    assert answers["usual"][0] in (0, 1)
