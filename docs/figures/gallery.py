"""Every picture of the gallery, made by the very command that the page shows beside it.

Of a picture in SVG that the page offers as TikZ too, the command makes this as well.
"""

import re
import shlex
from pathlib import Path

import arrangement.cli
import equilibrium.cli

MAIN = {"arrangement": arrangement.cli.main, "equilibrium": equilibrium.cli.main}
TEXT = (Path(__file__).parents[1] / "gallery.rst").read_text(encoding="utf-8")

for command in re.findall(r"^ *\$ (\w+ (?:draw|lab) (?:.*\\\n)*.*)$", TEXT, re.MULTILINE):
    name, *words = shlex.split(command.replace("\\\n", " "))
    made = words[-1]
    for path in (made, *{made.replace(".svg", ".tex")} - {made}):
        if path in TEXT and MAIN[name]([*words[:-1], path]):
            raise RuntimeError(f"the gallery shows a command that fails: {command}")
