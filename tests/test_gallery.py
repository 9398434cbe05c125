"""The gallery shows every view and every model, each with its command."""

import re
import shlex

import pytest

from arrangement import read_arrangement
from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium.pictures import DRAWINGS as OF_GRASPS
from tests.docpages import ROOT, blocks, commands

PAGES = sorted((ROOT / "docs" / "gallery").glob("*.rst"))
TEXT = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
SHOWN = [
    shlex.split(command)
    for block in blocks(TEXT)
    if block.argument == "console"
    for _, command, _ in commands(block)
    if not command.startswith("arrangement make")
]


def option(words: list[str], name: str, default: str) -> str:
    return words[words.index(name) + 1] if name in words else default


PROGRAMS = [("arrangement", OF_PLANES), ("equilibrium", OF_GRASPS)]
MODELS = (".stl", ".glb", ".obj")


def drawn(words: list[str]) -> str:
    """Return the view that a command of `arrangement` draws of built-in planes if it names none."""
    own = words[0] == "equilibrium" or words[2].endswith(".json")
    if own or not words[-1].endswith((".svg", ".pdf", ".png", ".tex")):
        return ""
    return next(iter(OF_PLANES.of(read_arrangement(words[2])).views))


@pytest.mark.parametrize(("program", "drawings"), PROGRAMS)
def test_every_view_and_model_is_shown_and_views_as_tikz_too(program, drawings):
    own = [words for words in SHOWN if words[0] == program]
    models = [words for words in own if words[-1].endswith(MODELS)]
    flat = [words for words in own if words not in models]
    tikz = [words for words in own if f".. tikz:: {words[-1].removesuffix('.svg')}\n" in TEXT]
    first = next(iter(drawings.views))
    for found in (flat, tikz):
        views = (option(w, "--view", drawn(w) or first).split(",") for w in found)
        assert {view for names in views for view in names} == set(drawings.views)
    usual = next(iter(drawings.models))
    assert {option(words, "--model", usual) for words in models} == set(drawings.models)


def test_every_picture_that_a_command_makes_is_on_a_page():
    made = {option(words, "-o", "") for words in SHOWN}
    shown = set(re.findall(r"(?:_generated|<../pages)/(gallery-[\w.-]+)", TEXT))
    tikz = set(re.findall(r"(?m)^\.\. tikz:: (gallery-[\w-]+)$", TEXT))
    assert made == shown
    assert {f"{name}.svg" for name in tikz} <= made


def test_pages_open_in_the_browser():
    """A browser keeps what a link of the role `download` points to as a file."""
    pages = [path for path in (option(words, "-o", "") for words in SHOWN) if ".html" in path]
    assert pages
    assert all(f"<../pages/{path}>`__" in TEXT for path in pages)


def test_thumbnails_lead_to_every_page():
    front = (ROOT / "docs" / "gallery.rst").read_text(encoding="utf-8")
    groups = re.findall(r"(?m)^\.\. thumbnails:: gallery\n\n((?:   .+\n)+)", front)
    names = [name for group in groups for name in group.split()]
    assert sorted(names) == sorted(page.stem for page in PAGES)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_has_a_picture_and_says_how_it_is_made(page):
    text = page.read_text(encoding="utf-8")
    assert re.search(r"figure:: /_generated/\S+\.svg\n(   :(width|class): \S+\n)*   :alt: ", text)
    assert ">>> " in text or "literalinclude" in text or page.stem in ("states", "zonohedra")
