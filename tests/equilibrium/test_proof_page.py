"""The interactive page of a proof, in headless Chromium; its numbers are those of `works`."""

from pathlib import Path
from typing import Any

import pytest

from equilibrium import Grasp, solve
from equilibrium.certificate.leaves import parts, works
from equilibrium.grasps.inputs import random_grasp
from equilibrium.pictures import proof_page
from equilibrium.pictures.parts.style import number, vector
from tests.browser import Browser

BELOW = [c for c in random_grasp(150, 7) if c.normal[1] > 0]
GRASP, WRENCH = Grasp(BELOW[:8]).with_preload(1), (8, 320, 24)
PATHS = "[...document.querySelectorAll('#map-0 .part')]"


@pytest.fixture
def opened(browser: Browser, tmp_path: Path) -> Browser:
    path = tmp_path / "proof.html"
    path.write_text(proof_page(GRASP, wrench=WRENCH), encoding="utf-8")
    browser.open(path)
    browser.settled()
    return browser


def said(browser: Browser) -> str:
    text: str = browser.run("return document.getElementById('said').textContent")
    return text


def expected(index: int) -> tuple[str, list[str]]:
    """What the page must say of a part: its sentence, and the works of the contacts."""
    verdict = solve(GRASP, WRENCH)
    found = list(parts(verdict.certificate.to_dict()))
    part = found[index]
    done = works(GRASP, verdict.wrench, [part])
    load, least, total = map(number, (done.load, done.least, done.load + done.least))
    rows = [
        "no force in this part" if factor is None else f"at least {number(factor)} c"
        for factor in done.factors
    ]
    words = (
        f"Part {index + 1} of {len(found)}. The virtual motion λ = {vector(part.leaf.motion)} ",
        f"the load does work {load}, the contacts at least {least}: together at least {total}, ",
    )
    return "|".join(words), rows


def assert_shown(browser: Browser, index: int) -> None:
    words, rows = expected(index)
    assert all(word in said(browser) for word in words.split("|")), (words, said(browser))
    cells = "return [...document.querySelectorAll('#works td:last-child')].map(e => e.textContent)"
    assert browser.run(cells) == rows


def middle(browser: Browser, k: int) -> tuple[int, float, float]:
    """The part of a region of the first map, and a place of the window where its number stands."""
    found: Any = browser.run(
        f"const path = {PATHS}[arguments[0]], box = path.getBoundingClientRect();"
        "return [Number(path.dataset.part), box.x + box.width / 2, box.y + box.height / 2]", k
    )  # fmt: skip
    part, x, y = found
    return int(part), x, y


def test_the_region_under_the_pointer_is_told_until_it_leaves(opened):
    first = said(opened)
    seen = set()
    for k in range(opened.run(f"return {PATHS}.length")):
        part, x, y = middle(opened, k)
        opened.pointer("mouseMoved", x, y)
        opened.settled()
        assert_shown(opened, part)
        seen.add(said(opened))
    assert len(seen) > 2
    opened.pointer("mouseMoved", 5, 5)
    opened.settled()
    assert said(opened) == first


def test_a_tap_keeps_a_region(opened):
    part, x, y = middle(opened, 1)
    opened.fingers([(x, y)])
    opened.click_at(x, y)
    opened.pointer("mouseMoved", 5, 5)
    opened.settled()
    assert_shown(opened, part)


def test_keys_lead_through_the_regions_and_all_parts_can_be_chosen(opened):
    assert opened.run("return document.querySelectorAll('.part[tabindex=\"0\"]').length") == 2
    opened.run("document.querySelector('#map-0 .part[tabindex=\"0\"]').focus()")
    for _ in range(2):
        opened.key("ArrowRight")
        opened.settled()
        held = "return Number(document.activeElement.dataset.part)"
        assert_shown(opened, opened.run(held))
    for index in range(opened.run("return document.querySelectorAll('#part option').length")):
        opened.run(
            "const box = document.getElementById('part'); box.value = arguments[0];"
            "box.dispatchEvent(new Event('change'))",
            index,
        )
        opened.settled()
        assert_shown(opened, index)


def test_it_needs_nothing_from_outside_and_fits_a_phone(opened, tmp_path):
    assert opened.messages() == []
    assert opened.outside() == []
    assert opened.run("return document.getElementById('said').getAttribute('aria-live')")
    question = opened.run("return document.getElementById('question').innerText").splitlines()
    assert question[0] == "wrench (8, 320, 24)"
    assert [line[10:] for line in question[1:]] == [contact.words for contact in GRASP]
    opened.open(tmp_path / "proof.html", 390, 800)
    opened.settled()
    assert opened.run("return document.documentElement.scrollWidth") <= 390
