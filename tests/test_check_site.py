"""The check of the documentation site finds what a reader without a network would miss."""

from pathlib import Path

import pytest

from tests.browser import Browser
from tests.check_site import check_page

DOT = "data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw=="


@pytest.fixture
def site(tmp_path: Path) -> Path:
    (tmp_path / "site").mkdir()
    return tmp_path / "site"


def check(browser: Browser, site: Path, body: str) -> list[str]:
    page = site / "page.html"
    page.write_text(
        f'<!DOCTYPE html><link rel="icon" href="data:,"><title>t</title>{body}', encoding="utf-8"
    )
    return check_page(browser, page, site)


def test_a_page_that_holds_all_it_needs_is_right(browser, site):
    (site / "own.js").write_text("document.title = 'own';", encoding="utf-8")
    body = f'<img src="{DOT}"><script src="own.js"></script>'
    assert check(browser, site, body) == []


@pytest.mark.parametrize(
    ("body", "complaint"),
    [
        ('<img src="http://127.0.0.1:9/x.png">', "request to http://127.0.0.1:9/x.png"),
        ('<script src="https://127.0.0.1:9/x.js"></script>', "request to https://127.0.0.1:9/x.js"),
        ("<script>fetch('http://127.0.0.1:9/').catch(() => 0)</script>", "request to http:"),
        ("<script>new WebSocket('ws://127.0.0.1:9/')</script>", "request to ws:"),
        ('<img src="../beside.png">', "request to file:"),
        ('<img src="absent.png">', "a picture is missing: absent.png"),
        ("<script>throw new Error('broken')</script>", "console:"),
        ("<script>console.warn('odd')</script>", "console:"),
        (r'<span class="math">\(x^2\)</span>', "mathematics is not typeset"),
    ],
)
def test_each_defect_is_found(body, complaint, browser, site):
    assert any(text.startswith(complaint) for text in check(browser, site, body))
