"""Every picture of the gallery, made by the very command that the page shows beside it."""

import re
import shlex
from pathlib import Path

import arrangement.cli
import equilibrium.cli.program

MAIN = {"arrangement": arrangement.cli.main, "equilibrium": equilibrium.cli.program}
PAGE = Path(__file__).parents[1] / "gallery.rst"

found = re.findall(
    r"^ *\$ (\w+ draw (?:.*\\\n)*.*)$", PAGE.read_text(encoding="utf-8"), re.MULTILINE
)
for command in found:
    name, *words = shlex.split(command.replace("\\\n", " "))
    if MAIN[name](words):
        raise RuntimeError(f"the gallery shows a command that fails: {command}")
