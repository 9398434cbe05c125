"""Open the pages of a built documentation site in headless Chromium, as a reader without a network.

Every page must load, keep its console clean, ask for nothing outside of the site, show all its
pictures, and typeset its mathematics. The search page must find something.

Run: ``python tests/check_site.py docs/_build/html``; exit code 1 when something is wrong.
"""

import sys
from pathlib import Path
from urllib.parse import quote

# Run as a script, this file finds its own folder only.
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from tests.browser import MISSING, Browser, left_out, programs, running

#: Waits for MathJax; then tells what a reader would miss.
_LOOK = """
const done = arguments[0];
const ready = window.MathJax?.startup?.promise ?? Promise.resolve();
ready.then(() => {
  const wrong = [...document.images].filter((image) => image.complete && !image.naturalWidth)
    .map((image) => `a picture is missing: ${image.getAttribute("src")}`);
  for (const text of document.querySelectorAll(".math")) {
    if (!text.querySelector("mjx-container, .MathJax")) {
      wrong.push(`mathematics is not typeset: ${text.textContent.slice(0, 60)}`);
    }
  }
  if (document.querySelector("mjx-merror")) wrong.push("MathJax reports an error");
  done(wrong);
});
"""


def check_page(browser: Browser, page: Path, site: Path) -> list[str]:
    """Return what is wrong with one page."""
    browser.open(page)
    wrong: list[str] = browser.driver.execute_async_script(_LOOK)
    wrong += [f"console: {message}" for message in browser.messages()]
    wrong += [f"request to {url}" for url in browser.outside(site)]
    return wrong


#: Words of the field, each a synonym of a word that these pages use.
WORDS = (
    "arrangement", "chamber", "covector", "tope", "cocircuit", "force closure", "Farkas",
    "contact mode",
)  # fmt: skip


def check_search(browser: Browser, site: Path) -> list[str]:
    """Return what is wrong with the search page."""
    return [wrong for word in WORDS for wrong in check_search_for(browser, site, word)]


def check_search_for(browser: Browser, site: Path, word: str) -> list[str]:
    browser.open(f"{(site / 'search.html').resolve().as_uri()}?q={quote(word)}")
    found = browser.driver.execute_async_script(
        "const done = arguments[0]; let left = 100;"
        "const look = () => { const n = document.querySelectorAll('#search-results li').length;"
        "if (n || !left) done(n); else { left -= 1; setTimeout(look, 100); } }; look();"
    )
    outside = [f"request to {url}" for url in browser.outside(site)]
    return outside if found else [*outside, f"the search does not find {word!r}"]


def check_site(site: Path) -> dict[str, list[str]]:
    """Return what is wrong, page by page, without listings of code and what needs a network."""
    pages = sorted(
        page
        for page in site.rglob("*.html")
        if not {"_modules", "lite"} & set(page.relative_to(site).parts)
    )
    if not pages:
        return {str(site): ["there are no pages; build the site first"]}
    with running() as browser:
        found = {str(page.relative_to(site)): check_page(browser, page, site) for page in pages}
        if (site / "search.html").exists():
            found["search.html"] += check_search(browser, site)
    print(f"{len(pages)} pages opened in Chromium")
    return {page: wrong for page, wrong in found.items() if wrong}


def main(arguments: list[str]) -> int:
    """Check the site in the folder that the first argument names."""
    reason = left_out()
    if reason:
        print(reason)
        return 0
    if programs() is None:
        print(f"error: {MISSING}", file=sys.stderr)
        return 1
    found = check_site(Path(arguments[0]))
    for page, wrong in found.items():
        for text in wrong:
            print(f"{page}: {text}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
