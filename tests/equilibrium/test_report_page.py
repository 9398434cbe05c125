"""The report on a grasp as a page: what it says, its certificate, and how it fits a window."""

import base64
import re

import pytest

from equilibrium import verify
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import from_float_data

QUESTIONS = {
    "resisted": ("paper-three-contacts-preload-1", (0, 1, 0)),
    "not resisted": ("interrupted-push", ("-3/2", 0, 0)),
    "in space": ("two-opposed-fingers", (0, 0, -3, 0, 0, 0)),
}


def page_of(tmp_path, *words: str) -> str:
    path = tmp_path / "report.html"
    assert main(["info", *words, "-o", str(path)]) in (0, 1, 3)
    return path.read_text(encoding="utf-8")


@pytest.mark.parametrize("question", QUESTIONS)
def test_certificate_in_the_page_is_accepted(question, tmp_path):
    name, wrench = QUESTIONS[question]
    text = page_of(tmp_path, name, "--wrench", *map(str, wrench))
    link = 'download="certificate.json" href="data:application/json;base64,(.*?)"'
    (data,) = re.findall(link, text)
    path = tmp_path / "certificate.json"
    path.write_bytes(base64.b64decode(data))
    assert verify(path).kind == ("resisted" if question == "resisted" else "not resisted")
    assert ("The load is resisted" in text) is (question == "resisted")
    assert ("The load is not resisted" in text) is (question != "resisted")


def test_factors_are_a_ruler_with_the_ends_in_words(tmp_path):
    text = page_of(tmp_path, "interrupted-push", "--wrench", "-3/2", "0", "0")
    ruler = text.partition('<svg class="factors"')[2].partition("</svg>")[0]
    assert re.findall(r">([^<>]+)</text>", ruler) == ["1: the load", "0", "2/3", "4/3", "∞"]
    assert ruler.count("<rect") == 2
    assert "at 2/3: slips at contact 1" in text


def test_report_without_a_load_has_no_verdict(tmp_path):
    text = page_of(tmp_path, "paper-four-contacts")
    assert "A grasp with 4 contacts" in text
    assert not re.search(r"certificate\.json|class=\"chip\"|<svg class", text)
    assert all(f"<h2>{name}</h2>" in text for name in ("Closure", "Contacts", "Assumptions"))


@pytest.mark.parametrize(
    ("tolerance", "words"),
    [
        ("1/1000000", "The load is resisted"),
        ("1/10", "Depends on the rounding"),
    ],
)
def test_rounded_data_are_said_to_be_rounded(tolerance, words, tmp_path):
    path = tmp_path / "measured.json"
    made = from_float_data(
        [[-0.1, 0.0], [0.1, 0.0], [0.0, -0.1]],
        [[1.0, 0.0], [-1.0, 0.0], [0.05, 0.99]],
        friction=0.5,
        preload=[1.0, 1.0, 0.0],
        tolerance=tolerance,
    )
    made.grasp.save(path)
    text = page_of(tmp_path, str(path), "--wrench", "0", "1/2", "0")
    assert words in text
    assert "for the data as rounded" in text
    assert "The data were rounded to exact numbers" in text


@pytest.mark.parametrize(("width", "theme"), [(390, "dark"), (1280, "light")])
@pytest.mark.parametrize("question", QUESTIONS)
def test_page_fits_its_window_and_asks_for_nothing(question, width, theme, browser, tmp_path):
    name, wrench = QUESTIONS[question]
    browser.show(page_of(tmp_path, name, "--wrench", *map(str, wrench)), tmp_path, width, 900)
    browser.run("document.documentElement.dataset.theme = arguments[0]", theme)
    assert browser.run("return document.documentElement.scrollWidth") == width
    paper = browser.run("return getComputedStyle(document.body).backgroundColor")
    assert (paper == "rgb(255, 255, 255)") == (theme == "light")
    assert browser.run("return document.querySelector('figure img').naturalWidth") > 100
    assert browser.messages() == []
    assert browser.outside() == []
