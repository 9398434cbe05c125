"""The gallery shows every view and every model, each with its command."""

import re
import shlex

import pytest

from arrangement import read_arrangement
from arrangement.drawing.registry import Drawings
from arrangement.pictures import DRAWINGS as OF_PLANES
from arrangement.pictures.views import drawings_of
from equilibrium.pictures import DRAWINGS as OF_GRASPS
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


PROGRAMS = [("arrangement", OF_PLANES), ("equilibrium", OF_GRASPS)]
MODELS = (".stl", ".glb", ".obj")


def drawn(words: list[str]) -> str:
    """Return the view that a command of `arrangement` draws if it names none."""
    if words[0] == "equilibrium" or not words[-1].endswith((".svg", ".pdf", ".png", ".tex")):
        return ""
    return next(iter(drawings_of(read_arrangement(words[2])).views))


@pytest.mark.parametrize(("program", "drawings"), PROGRAMS)
def test_every_view_is_shown(program: str, drawings: Drawings) -> None:
    first = next(iter(drawings.views))
    found = {
        option(words, "--view", drawn(words) or first) for words in SHOWN
        if words[0] == program and not words[-1].endswith(MODELS)
    }  # fmt: skip
    assert found == set(drawings.views)


@pytest.mark.parametrize(("program", "drawings"), PROGRAMS)
def test_every_model_is_shown(program: str, drawings: Drawings) -> None:
    first = next(iter(drawings.models))
    models = [words for words in SHOWN if words[0] == program and words[-1].endswith(MODELS)]
    assert {option(words, "--model", first) for words in models} == set(drawings.models)


def test_every_picture_that_a_command_makes_is_on_the_page() -> None:
    made = {option(words, "-o", "") for words in SHOWN}
    shown = set(re.findall(r"(?:_generated|<pages)/(gallery-[\w.-]+)", TEXT))
    tikz = {path for path in shown if path.endswith(".tex")}
    set_in_latex = {path.replace(".tex", "-tikz.png") for path in tikz}
    assert made == shown - tikz - set_in_latex
    assert set_in_latex <= shown
    assert {path.replace(".tex", ".svg") for path in tikz} <= made


@pytest.mark.parametrize(("program", "drawings"), PROGRAMS)
def test_every_view_is_shown_as_tikz_too(program: str, drawings: Drawings) -> None:
    first = next(iter(drawings.views))
    offered = {
        option(words, "--view", drawn(words) or first) for words in SHOWN
        if words[0] == program and f"{words[-1].removesuffix('.svg')}.tex>" in TEXT
    }  # fmt: skip
    assert offered == set(drawings.views)


def test_pages_open_in_the_browser() -> None:
    """A browser keeps what a link of the role `download` points to as a file."""
    pages = [path for path in (option(words, "-o", "") for words in SHOWN) if ".html" in path]
    assert pages
    assert all(f"<pages/{path}>`__" in TEXT for path in pages)
