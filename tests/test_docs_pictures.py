"""Pictures of dark pages: the SVG in dark colours, and both pictures on a page."""

import importlib
import sys
from types import SimpleNamespace

import pytest

from tests.docpages import ROOT

nodes = pytest.importorskip("docutils.nodes")
pytest.importorskip("sphinx")


@pytest.fixture(scope="module")
def dark_pictures():
    sys.path.insert(0, str(ROOT / "docs"))
    try:
        return importlib.import_module("pagetools.dark_pictures")
    finally:
        sys.path.remove(str(ROOT / "docs"))


def test_dark_picture_exchanges_black_and_white(dark_pictures):
    sheet = '<svg width="1"><path style="fill: #ffffff; stroke: #000000"/>'
    dark = dark_pictures.darken(f'{sheet}<g style="fill: #000000">')
    assert dark.startswith('<svg fill="#')
    assert "#000000" not in dark
    assert "#ffffff" not in dark


def test_seam_keeps_the_colour_of_its_shape(dark_pictures):
    dark = dark_pictures.darken('<path style="fill: #fdf0c0; stroke: #fdf0c0"/>')
    colours = [part.split(";")[0].strip('"/>') for part in dark.split(": ")[1:]]
    assert len(set(colours)) == 1


@pytest.mark.parametrize("linked", [False, True])
def test_page_holds_both_pictures_and_a_link_one(dark_pictures, linked):
    image = nodes.image(uri="_generated/a.svg", classes=[], candidates={"*": "_generated/a.svg"})
    tree = nodes.section("", nodes.reference("", "", image) if linked else image)
    files = []
    images = SimpleNamespace(add_file=lambda name, uri: files.append((name, uri)))
    app = SimpleNamespace(
        builder=SimpleNamespace(format="html"), env=SimpleNamespace(images=images)
    )
    dark_pictures.show_both(app, tree, "page")
    light, dark = tree.findall(nodes.image)
    assert (light["uri"], light["classes"]) == ("_generated/a.svg", ["only-light"])
    assert (dark["uri"], dark["classes"]) == ("_generated/dark/a.svg", ["only-dark"])
    assert [len(parent.children) for parent in tree.findall(nodes.reference)] == [1, 1] * linked
    assert files == [("page", "_generated/dark/a.svg")]


def test_a_picture_as_drawn_stays_alone(dark_pictures):
    image = nodes.image(uri="_generated/a.svg", classes=["as-drawn"])
    tree = nodes.section("", image)
    dark_pictures.show_both(SimpleNamespace(builder=SimpleNamespace(format="html")), tree, "page")
    assert list(tree.findall(nodes.image)) == [image]
