"""The assemblies that the guide to round bodies writes down, read from the guide itself."""

import json
import re
import textwrap
from pathlib import Path

from equilibrium import inputs, solve
from equilibrium.pictures import OF_ASSEMBLIES

PAGE = Path(__file__).parents[1] / "howto" / "round-bodies.rst"

for name in ("box", "tube", "spool"):
    pattern = rf":caption: {name}\.json\n\n((?:   .*\n|\n)+)"
    block = re.search(pattern, PAGE.read_text(encoding="utf-8"))
    made = inputs.read_shapes(json.loads(textwrap.dedent(block[1]), parse_float=str)).subject
    OF_ASSEMBLIES.write(solve(made, made.weights), f"round-bodies-{name}.svg")
