"""What holds of both labs: they fit, need nothing from outside, and keep texts as texts."""

from collections.abc import Callable

import pytest

from arrangement.cli import main as arrangement_main
from arrangement.library.files.table import read_arrangement
from arrangement.pictures.lab.lines import lab_page as lines_page
from equilibrium.cli.program import main
from equilibrium.grasps.files import read_grasp
from equilibrium.pictures.lab.page import lab_page

PAGES: dict[str, Callable[..., str]] = {"slip": lab_page, "lines": lines_page}


@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", PAGES)
def test_it_fits_and_needs_nothing_from_outside(name, width, browser, tmp_path):
    path = tmp_path / "lab.html"
    path.write_text(PAGES[name](), encoding="utf-8")
    browser.open(path, width, 900)
    browser.settled()
    assert browser.run("return document.documentElement.scrollWidth") <= width
    assert browser.messages() == []
    assert browser.outside() == []
    assert path.stat().st_size < 400_000


@pytest.mark.parametrize("name", PAGES)
def test_text_of_a_title_stays_text(name, browser, tmp_path):
    title = "</script><script>document.title = 'gone'</script>"
    path = tmp_path / "lab.html"
    path.write_text(PAGES[name](title=title), encoding="utf-8")
    browser.open(path)
    assert browser.run("return document.title") == title


def test_the_commands_write_them(tmp_path):
    path = tmp_path / "lab.html"
    command = ["lab", "several-equilibria", "-o", str(path), "--wrench", "0,-1,0", "--title", "A"]
    for run, arguments, expected in [
        (main, ["lab", "-o", str(path)], lab_page()),
        (main, command, lab_page(read_grasp("several-equilibria"), wrench=[0, -1, 0], title="A")),
        (arrangement_main, ["lab", "-o", str(path)], lines_page()),
        (
            arrangement_main,
            ["lab", "reflection-b3", "-o", str(path), "--title", "A"],
            lines_page(read_arrangement("reflection-b3"), title="A"),
        ),
    ]:
        assert run(arguments) == 0
        assert path.read_text(encoding="utf-8") == expected
