"""The figures of the slides that a command draws: the commands stand in the files of slides."""

import shlex
from pathlib import Path

from handouts.slides import talks

import arrangement.cli
import equilibrium.cli

MAIN = {"arrangement": arrangement.cli.main, "equilibrium": equilibrium.cli.main}


def run(name, *words):
    if MAIN[name](list(words)):
        raise RuntimeError(f"a command of the slides fails: {name} {shlex.join(words)}")


for _, talk in talks(Path(__file__).parents[1]):
    for command in talk.get("make", ()):
        run(*shlex.split(command))
    for slide in talk["slides"]:
        if "command" in slide:
            name, *words = slide["command"]
            run(name, *words, "--output", f"{slide['figure']}.svg")
