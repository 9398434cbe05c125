"""The stack that the guide to several bodies writes down, read from the guide itself."""

import json
import re
import textwrap
from pathlib import Path

from equilibrium import Assembly, solve
from equilibrium.pictures import OF_ASSEMBLIES

PAGE = Path(__file__).parents[1] / "howto" / "several-bodies.rst"

block = re.search(r":caption: stack\.json\n\n((?:   .*\n)+)", PAGE.read_text(encoding="utf-8"))
document = json.loads(textwrap.dedent(block[1]))
wrenches = {**document["wrench"], "upper": ["1/5", -1, "-3/10"]}
OF_ASSEMBLIES.write(solve(Assembly.from_dict(document), wrenches), "several-bodies.svg")
