"""The grasp that the guide to grasps writes down, read from the guide itself."""

import json
import re
import textwrap
from pathlib import Path

from equilibrium import Grasp
from equilibrium.pictures import write_drawing

PAGE = Path(__file__).parents[1] / "howto" / "own-grasp.rst"

block = re.search(r":caption: box\.json\n\n((?:   .*\n)+)", PAGE.read_text(encoding="utf-8"))
document = json.loads(textwrap.dedent(block[1]))
write_drawing(Grasp.from_dict(document), "own-grasp.svg", "grasp", wrench=(0, 3, 0))
