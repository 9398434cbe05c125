"""The gallery shows every view and every model, each with its command."""

import re
import shlex
from collections.abc import Mapping

import pytest

from arrangement.draw import DRAWINGS as OF_PLANES
from equilibrium.draw import DRAWINGS as OF_GRASPS
from tests.docpages import ROOT, blocks, commands

TEXT = (ROOT / "docs" / "gallery.rst").read_text(encoding="utf-8")
SHOWN = [
    shlex.split(command)
    for block in blocks(TEXT)
    if block.argument == "console"
    for _, command, _ in commands(block)
]


def option(words: list[str], name: str, default: str) -> str:
    return words[words.index(name) + 1] if name in words else default


@pytest.mark.parametrize(
    ("program", "views"), [("arrangement", OF_PLANES.views), ("equilibrium", OF_GRASPS.views)]
)
def test_every_view_is_shown(program: str, views: Mapping[str, str]) -> None:
    first = next(iter(views))
    assert {option(words, "--view", first) for words in SHOWN if words[0] == program} == set(views)


def test_every_model_is_shown() -> None:
    models = [words for words in SHOWN if words[-1].endswith((".stl", ".glb", ".obj"))]
    assert {option(words, "--model", "dual") for words in models} == set(OF_PLANES.models)


def test_every_picture_that_a_command_makes_is_on_the_page() -> None:
    made = {option(words, "-o", "") for words in SHOWN}
    assert made == set(re.findall(r"_generated/(gallery-[\w.-]+)", TEXT))
