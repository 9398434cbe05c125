"""What editors and type checkers know of the options of views."""

import subprocess
import sys

import pytest

from tests.draw_stubs import ROOT, STUBS, stub

TYPED = """
from arrangement import Arrangement
from equilibrium import Grasp

lines = Arrangement([[1, 0], [0, 1]])
reveal_type(lines.draw("lines", projective=True, width=90))
reveal_type(lines.draw("sphere,dual", camera=(1, 2, 3)))
reveal_type(Grasp().draw(wrench=[0, 1, 0]))
lines.draw("lattice", colours="sides")
lines.draw("lines", projective="yes")
Grasp().draw("proof")
Grasp().draw("grasp", load=[0, 1, 0])
"""


@pytest.mark.parametrize("path", STUBS)
def test_stubs_are_those_of_the_views(path):
    """If not: ``python -m tests.draw_stubs``."""
    assert (ROOT / path).read_text(encoding="utf-8") == stub(*STUBS[path])


def test_a_type_checker_knows_the_options(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "typed.py").write_text(TYPED)
    words = [sys.executable, "-m", "mypy", "--no-error-summary", str(tmp_path / "typed.py")]
    run = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    kinds = [line.split(": ", 2)[1:] for line in run.stdout.splitlines()]
    shown = [text for kind, text in kinds if kind == "note" and "Revealed" in text]
    assert shown == ['Revealed type is "arrangement.drawing.path_artist.Drawing"'] * 3
    wrong = {line.split(":")[1] for line in run.stdout.splitlines() if ": error: " in line}
    assert wrong == {"9", "10", "12"}, run.stdout
