"""Pictures of instances, the line of progress, and the commit that a record names."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from typing import Any

import pytest

from arrangement import Arrangement
from arrangement.library.families import generic
from equilibrium.grasps.files import read_grasp
from proofs_check.reports.page import pictures
from proofs_check.reports.report import commit


def drawn(instance: dict[str, Any] | None) -> list[str]:
    """Return the names of the elements of each picture of a counterexample."""
    counterexample = {"instance": instance} if instance else None
    result = {"id": "some-id", "counterexample": counterexample}
    names = []
    for svg, _ in pictures(result):
        ET.fromstring(svg.replace("xlink:", ""))
        found = re.findall(r' id="([^"]*)"', svg)
        assert all(name.startswith("some-id-0-") for name in found)
        names.append(" ".join(name.removeprefix("some-id-0-") for name in found))
    return names


def test_planes_are_drawn_with_their_dual():
    for planes in (generic(5), Arrangement([[3, -4, 6], [10**40, 1, 0], [0, 0, -1]])):
        (names,) = drawn(dict(planes.to_dict()))
        edges = re.findall(r"edge-\d+", names)
        assert len(edges) == planes.f_vector[2]


def test_a_grasp_is_drawn_with_its_equilibrium_or_the_proof_that_there_is_none():
    document = dict(read_grasp("paper-three-contacts").to_dict())
    (alone,) = drawn(document)
    assert "cone-3" in alone
    assert "force-" not in alone
    (held,) = drawn({**document, "wrench": ["0", "-1", "0"]})
    assert "force-2" in held
    (refused,) = drawn({**document, "wrench": ["0", "1", "0"]})
    assert "1-region-0" in refused
    assert "force-2" not in refused


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_the_commit_is_that_of_the_checkout_itself_and_of_no_other(tmp_path, monkeypatch):
    monkeypatch.delenv("GIT_DIR", raising=False)

    def git(*arguments):
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
