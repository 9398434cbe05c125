"""The page of resisted forces: the slip lab, opened at its map in headless Chromium."""

import time
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from arrangement.console.number_form import LABEL
from equilibrium import Grasp, read_grasp, solve
from equilibrium.certificate.leaves import parts, works
from equilibrium.grasps.inputs import random_grasp
from equilibrium.pictures import proof_page, resist_page
from tests.browser import Browser

PAPER = (
    "paper-three-contacts",
    "paper-three-contacts-preload-1",
    "paper-four-contacts",
    "paper-four-contacts-preload-1",
)

Opened = Callable[..., Grasp]


def settled(browser: Browser) -> None:
    """Wait until verdict and map are those of the load."""
    browser.settled()
    for _ in range(1000):
        if not browser.run(
            "return document.querySelector('#verdict[aria-busy=true], #plane.stale')"
        ):
            break
        time.sleep(0.02)
    browser.settled()


@pytest.fixture
def opened(browser: Browser, tmp_path: Path) -> Opened:
    """Return a function that writes the page of a grasp and opens it."""

    def open_page(source: str | Grasp, width: int = 1280, **options: Any) -> Grasp:
        grasp = read_grasp(source) if isinstance(source, str) else source
        browser.show(resist_page(grasp, **options), tmp_path, width)
        settled(browser)
        return grasp

    return open_page


def drawn_at(browser: Browser, x: float, y: float) -> bool:
    """Return whether a piece is drawn at a force, whose place two numbers on the axes tell."""
    drawn: bool = browser.run(
        """
        const view = document.getElementById("plane");
        const ticks = [...view.querySelectorAll(".tick")]
          .filter((t) => /^[−0-9.]+$/.test(t.textContent));
        const at = (anchor, name, shift) => ticks
          .filter((t) => t.getAttribute("text-anchor") === anchor)
          .map((t) => [Number(t.textContent.replace("−", "-")), t.getAttribute(name) - shift]);
        const line = (list) => {
          const [p, q] = [list[0], list.at(-1)];
          return (v) => p[1] + ((v - p[0]) * (q[1] - p[1])) / (q[0] - p[0]);
        };
        const x = line(at("middle", "x", 0))(arguments[0]);
        const y = line(at("start", "y", 2))(arguments[1]);
        const there = new DOMPoint(x, y).matrixTransform(view.getScreenCTM());
        return document.elementsFromPoint(there.x, there.y)
          .some((element) => element.classList.contains("piece"));
        """,
        x,
        y,
    )
    return drawn


@pytest.mark.parametrize("name", PAPER)
def test_the_picture_agrees_with_the_solver(name, browser, opened):
    """A piece is drawn at a place exactly when the force there is resisted."""
    grasp = opened(name)
    for torque in ("0", "1/2"):
        if torque != "0":
            browser.put("w-t", torque, "input")
            settled(browser)
        for x, y in product((-1.37, 0.31, 1.57), (-1.46, 0.23, 1.34)):
            wrench = [Fraction(str(x)), Fraction(str(y)), Fraction(torque)]
            assert drawn_at(browser, x, y) == solve(grasp, wrench).stable, wrench
    assert browser.messages() == []


def test_the_exact_conditions_of_the_marked_piece_are_told(browser, opened):
    opened("paper-three-contacts-preload-1", wrench=["1/10", -1, 0])
    states, *told = browser.text("conditions").splitlines()
    assert states == "states: stick, stick, stick"
    assert "2 fx + 1 ≥ 0" in told
    browser.put("w-y", "1000001/1000000", "input")
    settled(browser)
    assert browser.run("return document.getElementById('conditions-box').hidden")
    assert not browser.count("#plane .held-piece")


def test_the_slider_of_the_torque_turns_the_load(browser, opened):
    grasp = opened("paper-three-contacts-preload-1")
    for torque in ("1.25", "-2"):
        browser.put("s-t", torque, "input")
        settled(browser)
        assert browser.run("return document.getElementById('w-t').value") == str(Fraction(torque))
        stable = solve(grasp, [0, 0, Fraction(torque)]).stable
        assert browser.text("verdict").startswith("Resisted" if stable else "Not resisted")


@pytest.mark.parametrize("width", [390, 800, 1280])
def test_the_map_stands_first_and_large(width, browser, opened):
    opened("paper-three-contacts-preload-1", width)
    assert browser.run("return document.documentElement.scrollWidth") <= width
    map_, *others = browser.run(
        "return ['forces', 'grasp', 'motions'].map((name) => {"
        "const r = document.querySelector(`figure.${name}`).getBoundingClientRect();"
        "return [r.x, r.y, r.width]; })"
    )
    for other in others:
        assert map_[2] >= other[2]
        assert (map_[0], map_[1]) <= (other[0], other[1]) or map_[1] < other[1]


BELOW = [c for c in random_grasp(150, 7) if c.normal[1] > 0]
GRASP, WRENCH = Grasp(BELOW[:8]).with_preload(1), (8, 320, 24)
PATHS = "[...document.querySelectorAll('#map-0 .part')]"


@pytest.fixture
def opened_proof(browser: Browser, tmp_path: Path) -> Browser:
    browser.show(proof_page(GRASP, wrench=WRENCH), tmp_path)
    return browser


def expected(index: int) -> tuple[str, list[str]]:
    """What the page must say of a part: its sentence, and the works of the contacts."""
    verdict = solve(GRASP, WRENCH)
    found = list(parts(verdict.certificate.to_dict()))
    part = found[index]
    done = works(GRASP, verdict.wrench, [part])
    load, least, total = map(LABEL.number, (done.load, done.least, done.load + done.least))
    rows = [
        "no force in this part" if factor is None else f"at least {LABEL.number(factor)} c"
        for factor in done.factors
    ]
    motion = LABEL.vector(part.leaf.motion)
    words = (
        f"Part {index + 1} of {len(found)}. The virtual motion λ = {motion} ",
        f"the load does work {load}, the contacts at least {least}: together at least {total}, ",
    )
    return "|".join(words), rows


def assert_shown(browser: Browser, index: int) -> None:
    words, rows = expected(index)
    said = browser.text("said")
    assert all(word in said for word in words.split("|")), (words, said)
    assert browser.texts("#works td:last-child") == rows


def middle(browser: Browser, k: int) -> tuple[int, float, float]:
    """The part of a region of the first map, and a place of the window where its number stands."""
    found: Any = browser.run(
        f"const path = {PATHS}[arguments[0]], box = path.getBoundingClientRect();"
        "return [Number(path.dataset.part), box.x + box.width / 2, box.y + box.height / 2]", k
    )  # fmt: skip
    part, x, y = found
    return int(part), x, y


def test_the_region_under_the_pointer_is_told_until_it_leaves(opened_proof):
    first = opened_proof.text("said")
    seen = set()
    for k in range(opened_proof.run(f"return {PATHS}.length")):
        part, x, y = middle(opened_proof, k)
        opened_proof.pointer("mouseMoved", x, y)
        assert_shown(opened_proof, part)
        seen.add(opened_proof.text("said"))
    assert len(seen) > 2
    opened_proof.pointer("mouseMoved", 5, 5)
    assert opened_proof.text("said") == first


def test_a_tap_keeps_a_region(opened_proof):
    part, x, y = middle(opened_proof, 1)
    opened_proof.fingers([(x, y)])
    opened_proof.click_at(x, y)
    opened_proof.pointer("mouseMoved", 5, 5)
    assert_shown(opened_proof, part)


def test_keyboard_reaches_all_regions_and_parts(opened_proof):
    assert opened_proof.count('.part[tabindex="0"]') == 2
    opened_proof.run("document.querySelector('#map-0 .part[tabindex=\"0\"]').focus()")
    for _ in range(2):
        opened_proof.key("ArrowRight")
        held = "return Number(document.activeElement.dataset.part)"
        assert_shown(opened_proof, opened_proof.run(held))
    for index in range(opened_proof.count("#part option")):
        opened_proof.put("part", index)
        assert_shown(opened_proof, index)


def test_page_shows_question_and_reads_answers_aloud(opened_proof):
    assert opened_proof.run("return document.getElementById('said').getAttribute('aria-live')")
    question = opened_proof.run("return document.getElementById('question').innerText").splitlines()
    assert question[0] == "wrench (8, 320, 24)"
    assert [line[10:] for line in question[1:]] == [contact.words for contact in GRASP]
