"""Every command that can take long says on a terminal how far it is, and never on stdout."""

import json
from pathlib import Path

import pytest

from arrangement.console import progress
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import random_grasp

from .test_wrench_sets_cli import WITH_UNITS

LONG = WITH_UNITS | {"solve": ("--wrench", "-1", "0", "0")}
del LONG["wrench-space"]  # answers at once
ALONE = {"gaps": ("--tries", "2"), "survey": ("--number", "2")}


def arguments(command: str, tmp_path: Path) -> list[str]:
    if command in ALONE:
        return [command, *ALONE[command], "--json"]
    path = tmp_path / "grasp.json"
    path.write_text(json.dumps(random_grasp(3, seed=1).to_dict()))
    return [command, str(path), *LONG[command], "--json"]


@pytest.mark.parametrize("command", [*LONG, *ALONE])
def test_the_line_is_on_stderr_of_a_terminal_only(command, tmp_path, capsys, monkeypatch):
    words = arguments(command, tmp_path)
    main(words)
    piped = capsys.readouterr()
    assert piped.err == ""
    monkeypatch.setattr(progress, "on_terminal", lambda: True)
    monkeypatch.setattr(progress, "_PATIENCE", 0.0)
    main(words)
    seen = capsys.readouterr()
    assert seen.out == piped.out
    assert "left" in seen.err
    assert seen.err.endswith("\r\x1b[K")
