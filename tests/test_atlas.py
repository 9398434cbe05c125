"""The atlas: each page has what it links, and the numbers of its arrangement."""

import re
import sys
from html import unescape
from pathlib import Path

import pytest

from arrangement.library.census.catalogue import PUBLISHED
from arrangement.library.families import simplicial_entries

sys.path.insert(0, str(Path(__file__).parents[1] / "docs/atlas"))
import atlas

del sys.path[0]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("atlas")
    for title in ("A(7, 1)", "Shi arrangement of A2", "Shi arrangement of A3"):
        entry = next(one for one in atlas.entries() if one.title == title)
        atlas.make(entry, made)
    return made


def test_it_has_every_known_arrangement_once():
    names = [entry.name for entry in atlas.entries()]
    types = sum(PUBLISHED[m] for m in range(3, 8))
    assert len(set(names)) == len(names) == len(simplicial_entries()) + types + 3 + 16


@pytest.mark.slow
def test_a_page_links_files_that_are_there(folder):
    pages = list(folder.glob("*.html"))
    assert len(pages) == 3
    for page in pages:
        linked = re.findall(r'(?:href|src)="([^"]+)"', page.read_text())
        assert len(linked) >= 4
        for name in set(linked) - {"index.html"}:
            assert (folder / name).stat().st_size > 1000, name


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("a-7-1", ["(t - 3)^2 (t - 1)", "32 with 3", "simplicial", "families.simplicial(7, 1)"]),
        ("shi-arrangement-of-a2", ["6, 21, 16", "(t - 3)^2", "shi --type A2"]),
        # Parking functions of 4, and of 3 ([Shi1986], [Athanasiadis1996]).
        ("shi-arrangement-of-a3", ["125", "27", "(t - 4)^3"]),
    ],
)
def test_a_page_says_the_numbers_in_print(folder, name, said):
    text = unescape((folder / f"{name}.html").read_text())
    for words in said:
        assert re.search(rf"[>\s]{re.escape(words)}[<\s,]", text), words


def test_an_atlas_of_one_page_has_a_list_of_it(tmp_path, capsys):
    words = [str(tmp_path), "--jobs", "1", "--only"]
    assert atlas.main([*words, "Linial arrangement of A2"]) == 0
    assert capsys.readouterr().out == f"{tmp_path}/index.html\n"
    assert "linial-arrangement-of-a2.html" in (tmp_path / "index.html").read_text()
    with pytest.raises(SystemExit, match="2"):
        atlas.main([*words, "none"])
    assert "no page has 'none' in its title" in capsys.readouterr().err
