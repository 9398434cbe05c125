"""Pictures of instances, the line of progress, and the commit that a record names."""

from __future__ import annotations

import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from arrangement import Arrangement
from arrangement.library.families import generic
from equilibrium.io.files import read_grasp
from proofs_check.reports.environment import commit
from proofs_check.reports.pictures import picture


def test_planes_are_drawn_as_curves_inside_the_disk() -> None:
    for planes in (generic(5), Arrangement([[3, -4, 6], [10**40, 1, 0], [0, 0, -1]])):
        tree = ET.fromstring(picture(planes.to_dict()))
        lines = [entry for entry in tree if entry.tag == "polyline"]
        assert len(lines) == len(planes)
        for line in lines:
            points = [tuple(map(float, p.split(","))) for p in line.attrib["points"].split()]
            distances = [(x - 100) ** 2 + (y - 100) ** 2 for x, y in points]
            assert max(distances) < 90.2**2
            # A half great circle begins and ends on the rim, at opposite points.
            assert min(distances[0], distances[-1]) > 89.8**2
            assert abs(points[0][0] + points[-1][0] - 200) < 0.3


def test_a_grasp_is_drawn_with_every_contact_and_other_things_are_not_drawn() -> None:
    grasp = read_grasp("paper-four-contacts")
    tree = ET.fromstring(picture(grasp.to_dict()))
    assert len([entry for entry in tree if entry.tag == "circle"]) == 4
    assert picture(None) == ""
    assert picture(generic(3, affine=True).to_dict()) == ""
    assert picture(generic(3, 4).to_dict()) == ""
    assert picture({"something": 1}) == ""


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_the_commit_is_that_of_the_checkout_itself_and_of_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("GIT_DIR", raising=False)

    def git(*arguments: str) -> str:
        who = ["-c", "user.name=n", "-c", "user.email=e@example.org"]
        done = subprocess.run(
            ["git", "-C", str(tmp_path), *who, *arguments],
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.strip()

    assert commit(tmp_path) is None
    git("init", "-q")
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "f").write_text("1", encoding="utf-8")
    git("add", ".")
    git("commit", "-q", "-m", "m")
    assert commit(tmp_path) == git("rev-parse", "HEAD")
    assert commit(tmp_path / "inside") is None
    (tmp_path / "inside" / "f").write_text("2", encoding="utf-8")
    assert commit(tmp_path) == f"{git('rev-parse', 'HEAD')}+changes"
