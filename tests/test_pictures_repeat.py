"""Pictures repeat byte for byte, whatever the order in which Python hashes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence

import pytest

from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium.pictures import DRAWINGS as OF_GRASPS
from tests.instances import ARRANGEMENTS, PLANAR

#: Draws views of some instances and prints a digest of each file. What the second list names is
#: drawn in all formats: writers read scenes alone, so a scene that is the same in SVG and TikZ is
#: the same in all; the rest is drawn in these two. What the third list names is tried in the other
#: formats as well, in few pixels: every warning is an error.
SCRIPT = """
import hashlib, importlib, inspect, io, sys
from arrangement import InputError, read_arrangement
from arrangement.pictures import DRAWINGS as planes
from arrangement.drawing.figure import figure
from arrangement.drawing.output import PICTURES, own_settings, picture_bytes
from arrangement.drawing.tikz.tikz import tikz
from equilibrium import read_grasp
from equilibrium.pictures import DRAWINGS as grasps
NEEDED = {"methods": {"wrenches": [(0, 2, 0), (1, -1, 0)]}, "proof": {"wrench": (0, -1, 0)}}

def draw(name, drawings, read, view):
    module, _, function = drawings.views[view].partition(":")
    drawing = getattr(importlib.import_module(f"{drawings.package}.{module}"), function)
    with own_settings():
        try:
            scene = drawing.scene(read(name), **NEEDED.get(view, {}))
        except InputError:
            return
        contents = {".tex": tikz(scene).encode()}
        for end in ("pdf", "png") if drawings is planes and name in tried else ():
            figure(scene).savefig(io.BytesIO(), format=end, dpi=40)
    ends = PICTURES if name in whole else (".svg",)
    contents |= {end: picture_bytes(end, lambda: figure(scene)) for end in ends}
    for end, content in contents.items():
        print(name, view, end, hashlib.sha256(content).hexdigest())

names, whole, tried, views = (set(given.split(",")) for given in sys.argv[1:])
for drawings, read in ((planes, read_arrangement), (grasps, read_grasp)):
    for view in drawings.views.keys() & views:
        for name in names:
            draw(name, drawings, read, view)
"""
VIEWS = [*OF_PLANES.views, *OF_GRASPS.views]
WHOLE = ["braid-a3", "shi-a2-affine", "paper-three-contacts-preload-1"]


def digests(names: Sequence[str], tried: Sequence[str], seed: str) -> list[str]:
    """Return a line for each picture that there is, drawn with a seed of hashes."""
    lists = (names, WHOLE, tried, VIEWS)
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT, *map(",".join, lists)],
        env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return sorted(done.stdout.splitlines())


@pytest.mark.campaign
@pytest.mark.parametrize("part", range(4))
def test_all_pictures_of_all_instances_repeat(part: int) -> None:
    names = PLANAR[part::4]
    one, other = digests(names, ARRANGEMENTS, "3"), digests(names, [], "4")
    assert {line.split()[0] for line in one} == set(names)
    assert one == other
