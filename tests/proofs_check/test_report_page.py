"""The report of verdicts in a browser: it fits, asks for nothing, can be searched and filtered."""

from pathlib import Path

import pytest

from proofs_check import evaluate, registry
from proofs_check.reports import report
from proofs_check.reports.page import html_page

IDS = ("single-solution", "step-1-square-bound", "fukuda-bound", "method-linear-compliance")
VISIBLE = "return [...document.querySelectorAll('article')].filter(c => !c.hidden).map(c => c.id)"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("report") / "verdicts.html"
    results = [report.result_record(evaluate(registry()[id])) for id in IDS]
    path.write_text(html_page(report.json_record(results, 0, "A paper")), encoding="utf-8")
    return path


@pytest.mark.parametrize(("width", "theme"), [(390, "dark"), (1280, "light")])
def test_the_page_fits_its_window_and_asks_for_nothing(browser, page, width, theme):
    browser.open(page, width, 900)
    browser.run("document.documentElement.dataset.theme = arguments[0]", theme)
    assert browser.run("return document.documentElement.scrollWidth") == width
    paper = browser.run("return getComputedStyle(document.body).backgroundColor")
    assert (paper == "rgb(255, 255, 255)") == (theme == "light")
    assert browser.count("svg path") > 50
    assert browser.run("return document.querySelector('math msub') !== null")
    assert browser.messages() == []
    assert browser.outside() == []


def test_search_and_filters_leave_what_was_asked_for(browser, page):
    browser.open(page)
    assert browser.run(VISIBLE) == [*IDS]
    browser.run(
        "const box = document.getElementById('search'); box.value = 'PLANES in R^d';"
        "box.dispatchEvent(new Event('input'))"
    )
    assert browser.run(VISIBLE) == ["fukuda-bound"]
    browser.run(
        "const box = document.getElementById('search'); box.value = '';"
        "box.dispatchEvent(new Event('input'));"
        "document.querySelector('.controls [data-verdict=\"proved\"]').click()"
    )
    assert browser.run(VISIBLE) == ["single-solution", "method-linear-compliance"]
    shown = "return [...document.querySelectorAll('h2.section')].filter(h => !h.hidden).length"
    assert browser.run(shown) == 2
    assert browser.text("shown") == "2 of 4"


def test_the_page_is_complete_without_its_script(browser, page):
    bare = page.with_name("bare.html")
    text = page.read_text(encoding="utf-8")
    head, _, rest = text.rpartition("<script>")
    bare.write_text(head + rest.partition("</script>")[2], encoding="utf-8")
    browser.open(bare)
    assert browser.run(VISIBLE) == [*IDS]
    hidden = "return document.querySelector('.controls').getBoundingClientRect().height"
    assert browser.run(hidden) == 0
