"""Pictures repeat byte for byte, whatever the order in which Python hashes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence

import pytest

from arrangement.draw import DRAWINGS as OF_PLANES
from arrangement.draw.output import PICTURES
from equilibrium.draw import DRAWINGS as OF_GRASPS
from tests.instances import PLANAR

#: Draws views of one instance in some formats and prints a digest of each file.
SCRIPT = """
import hashlib, importlib, inspect, sys
from arrangement import InputError, read_arrangement
from arrangement.draw import DRAWINGS as planes
from arrangement.draw.figure import figure
from arrangement.draw.output import own_settings, picture_bytes
from arrangement.draw.tikz import tikz
from equilibrium import read_grasp
from equilibrium.draw import DRAWINGS as grasps
NEEDED = {"methods": {"wrenches": [(0, 2, 0), (1, -1, 0)]}, "proof": {"wrench": (0, -1, 0)}}
name, views, ends = sys.argv[1], sys.argv[2].split(","), sys.argv[3].split(",")
for drawings, read in ((planes, read_arrangement), (grasps, read_grasp)):
    for view in drawings.views.keys() & set(views):
        module, _, function = drawings.views[view].partition(":")
        draw = getattr(importlib.import_module(f"{drawings.package}.{module}"), function)
        with own_settings():
            try:
                scene = inspect.unwrap(draw)(read(name), **NEEDED.get(view, {}))
            except InputError:
                continue
            contents = {".tex": tikz(scene).encode()}
        contents |= {end: picture_bytes(end, lambda: figure(scene)) for end in ends}
        for end, content in contents.items():
            print(view, end, hashlib.sha256(content).hexdigest())
"""
VIEWS = [*OF_PLANES.views, *OF_GRASPS.views]
#: Drawn in all formats. Writers read scenes alone, so a scene that is the same in SVG and TikZ is
#: the same in all; the rest is drawn in these two.
WHOLE = {"braid-a3", "shi-a2-affine", "paper-three-contacts-preload-1"}


def digests(name: str, views: list[str], seed: str, ends: Sequence[str] = PICTURES) -> list[str]:
    """Return a line for each picture that there is, drawn with a seed of hashes."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT, name, ",".join(views), ",".join(ends)],
        env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return sorted(done.stdout.splitlines())


def test_pictures_do_not_depend_on_hashes() -> None:
    one, other = (digests("paper-three-contacts", ["resist"], seed) for seed in ("1", "2"))
    assert len(one) == 4
    assert one == other


@pytest.mark.campaign
@pytest.mark.parametrize("name", PLANAR)
def test_all_pictures_of_all_instances_repeat(name: str) -> None:
    ends = PICTURES if name in WHOLE else (".svg",)
    one, other = (digests(name, VIEWS, seed, ends) for seed in ("3", "4"))
    assert one
    assert one == other
