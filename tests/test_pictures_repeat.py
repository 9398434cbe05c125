"""Pictures repeat byte for byte, whatever the order in which Python hashes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from arrangement.draw import DRAWINGS as OF_PLANES
from arrangement.io import files
from equilibrium.draw import DRAWINGS as OF_GRASPS

#: Draws the views of one instance in all formats and prints a digest of each file.
SCRIPT = """
import hashlib, pathlib, sys
from arrangement import InputError, read_arrangement
from arrangement.draw import DRAWINGS as planes
from equilibrium import read_grasp
from equilibrium.draw import DRAWINGS as grasps
NEEDED = {"methods": {"wrenches": [(0, 2, 0), (1, -1, 0)]}, "proof": {"wrench": (0, -1, 0)}}
name, views, target = sys.argv[1], sys.argv[2].split(","), pathlib.Path(sys.argv[3])
for drawings, read in ((planes, read_arrangement), (grasps, read_grasp)):
    for view in drawings.views.keys() & set(views):
        for suffix in (".svg", ".pdf", ".png", ".tex"):
            try:
                drawings.write(read(name), target / f"a{suffix}", view, **NEEDED.get(view, {}))
            except InputError:
                continue
            digest = hashlib.sha256((target / f"a{suffix}").read_bytes()).hexdigest()
            print(view, suffix, digest)
"""
VIEWS = [*OF_PLANES.views, *OF_GRASPS.views]


def digests(name: str, views: list[str], seed: str, folder: Path) -> list[str]:
    """Return a line for each picture that there is, drawn with a seed of hashes."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT, name, ",".join(views), str(folder)],
        env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return sorted(done.stdout.splitlines())


def test_pictures_do_not_depend_on_hashes(tmp_path: Path) -> None:
    views = ["sphere", "resist"]
    one, other = (digests("paper-three-contacts", views, seed, tmp_path) for seed in ("1", "2"))
    assert len(one) == 8
    assert one == other


@pytest.mark.campaign
@pytest.mark.parametrize("name", files.instances())
def test_all_pictures_of_all_instances_repeat(name: str, tmp_path: Path) -> None:
    one, other = (digests(name, VIEWS, seed, tmp_path) for seed in ("3", "4"))
    assert one
    assert one == other
