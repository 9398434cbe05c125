"""The interactive page of resisted forces, opened in headless Chromium."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from arrangement import InputError
from equilibrium import solve
from equilibrium.cli.program import main
from equilibrium.grasps.files import read_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.pictures import resist_page
from equilibrium.pictures.pages.page import MAX_CONTACTS
from tests.browser import Browser
from tests.labs import invalid, problem

PAPER = (
    "paper-three-contacts",
    "paper-three-contacts-preload-1",
    "paper-four-contacts",
    "paper-four-contacts-preload-1",
)
MIXED = Grasp(
    [
        Contact([-1, 0], [1, 0], "1/2", 2, 1),
        Contact([0, -1], [0, 1], "1/3", 1, 3),
        Contact([1, "1/2"], [-1, 0], 1, 1, 0),
    ]
)

Opened = Callable[..., Grasp]


def ready(browser: Browser) -> None:
    """Wait until the page has found all pieces."""
    for _ in range(1000):
        if not browser.run("return document.querySelector('#verdict[aria-busy]')"):
            break
        time.sleep(0.02)
    browser.settled()


@pytest.fixture
def opened(browser: Browser, tmp_path: Path) -> Opened:
    """Return a function that writes the page of a grasp and opens it."""

    def open_page(source: str | Grasp, **options: Any) -> Grasp:
        grasp = read_grasp(source) if isinstance(source, str) else source
        path = tmp_path / "page.html"
        path.write_text(resist_page(grasp, **options), encoding="utf-8")
        browser.open(path)
        ready(browser)
        return grasp

    return open_page


def enter(browser: Browser, **fields: object) -> None:
    """Type numbers into the fields of the page."""
    browser.run(
        "for (const [id, text] of Object.entries(arguments[0])) {"
        "const box = document.getElementById(id); box.value = text;"
        "box.dispatchEvent(new Event('input')); }",
        {name.replace("_", "-"): str(value) for name, value in fields.items()},
    )
    browser.settled()


def verdict(browser: Browser) -> str:
    text: str = browser.run("return document.getElementById('verdict').textContent")
    return text


def told(browser: Browser, selector: str) -> list[str]:
    texts: list[str] = browser.run(
        "return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector
    )
    return texts


def facts(browser: Browser) -> dict[str, str]:
    return dict(zip(told(browser, "#facts dt"), told(browser, "#facts dd"), strict=True))


def check_law(grasp: Grasp, wrench: Sequence[Fraction], browser: Browser) -> int:
    """Check what the page says about the chosen states by the law of each contact.

    Returns:
        The number of force components that the page gives.
    """
    fact = facts(browser)
    states = fact["states"].split(", ")
    cells = told(browser, "#forces td")
    rows = [cells[k : k + 4] for k in range(0, len(cells), 4)]
    assert [row[1].split()[-1] for row in rows] == states
    if "motion (x, y, r)" not in fact or "not fixed" in fact["motion (x, y, r)"]:
        return 0
    motion = [Fraction(x) for x in fact["motion (x, y, r)"].strip("()").split(", ")]
    total = list(wrench)
    given = 0
    for contact, state, row in zip(grasp, states, rows, strict=True):
        approach = sum(a * b for a, b in zip(contact.normal_wrench, motion, strict=True))
        slip = sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        normal = max(Fraction(0), contact.preload - contact.stiffness * approach)
        assert row[2] in (str(normal), "…")
        assert state != "detached" or normal == 0
        assert slip == 0 or state != "stick"
        assert slip >= 0 or state != "slip+"
        assert slip <= 0 or state != "slip-"
        if row[3] == "…":
            continue
        given += 1
        tangential = Fraction(row[3])
        assert abs(tangential) <= contact.friction * normal
        if slip and normal:
            assert tangential == -contact.friction * normal * (1 if slip > 0 else -1)
        for k in range(3):
            total[k] += normal * contact.normal_wrench[k]
            total[k] += tangential * contact.tangential_wrench[k]
    if given == len(rows):
        assert total == [0, 0, 0]
    return given


@pytest.mark.parametrize("name", PAPER)
def test_the_page_draws_pieces_and_stays_silent(
    name: str, browser: Browser, opened: Opened
) -> None:
    grasp = opened(name)
    assert len(told(browser, "#plane .piece")) >= 2
    assert len(told(browser, "#grasp .cone")) == len(grasp)
    assert browser.messages() == []
    assert browser.outside() == []


@pytest.mark.campaign
@pytest.mark.parametrize("name", PAPER)
def test_the_verdict_is_that_of_the_solver(name: str, browser: Browser, opened: Opened) -> None:
    grasp = opened(name)
    values = [Fraction(text) for text in ("-2", "-1/3", "0", "1", "5/2")]
    found = set()
    for x, y in product(values, repeat=2):
        enter(browser, force_x=x, force_y=y, torque="1/5" if x == y else 0)
        wrench = [x, y, Fraction(1, 5) if x == y else Fraction(0)]
        stable = solve(grasp, wrench).stable
        assert verdict(browser) == ("Resisted" if stable else "Not resisted")
        found.add(stable)
        if stable:
            check_law(grasp, wrench, browser)
    assert found == {True, False}


def test_known_verdicts_of_the_paper(browser: Browser, opened: Opened) -> None:
    """[HaasHeger2018]: without preload the hand holds pushes from above, none from below."""
    opened("paper-three-contacts")
    enter(browser, force_x=0, force_y=-5)
    assert verdict(browser) == "Resisted"
    enter(browser, force_x=0, force_y=1)
    assert verdict(browser) == "Not resisted"
    enter(browser, preload=1)
    assert verdict(browser) == "Resisted"
    enter(browser, force_y="1000001/1000000")
    assert verdict(browser) == "Not resisted"


def test_every_preload_and_torque_has_the_exact_answer(browser: Browser, opened: Opened) -> None:
    """One exact set serves for all preloads above 0: the page scales it, the solver starts anew."""
    grasp = opened("paper-three-contacts-preload-1")
    for preload, torque, y in product(("0", "1/3", "2"), ("-1/2", "0", "3/2"), ("-7/2", "2/3")):
        enter(browser, preload=preload, torque=torque, force_x="1/4", force_y=y)
        loaded = grasp.with_preload(preload)
        wrench = [Fraction(x) for x in ("1/4", y, torque)]
        assert (verdict(browser) == "Resisted") == solve(loaded, wrench).stable
        if verdict(browser) == "Resisted":
            check_law(loaded, wrench, browser)


def test_different_preloads_are_scaled_together(browser: Browser, opened: Opened) -> None:
    opened(MIXED)
    for factor, y in product(("1", "1/2", "3"), ("-4", "-1", "2/3")):
        enter(browser, preload=factor, force_x="1/7", force_y=y)
        scaled = Grasp(replace(c, preload=c.preload * Fraction(factor)) for c in MIXED)
        wrench = [Fraction("1/7"), Fraction(y), Fraction(0)]
        assert (verdict(browser) == "Resisted") == solve(scaled, wrench).stable
    browser.run(
        "const kind = document.getElementById('preload-kind'); kind.value = 'uniform';"
        "kind.dispatchEvent(new Event('change'))"
    )
    enter(browser, preload=2, force_y="1/2")
    wrench = [Fraction("1/7"), Fraction("1/2"), Fraction(0)]
    assert (verdict(browser) == "Resisted") == solve(MIXED.with_preload(2), wrench).stable


def test_forces_balance_where_the_states_fix_them(browser: Browser, opened: Opened) -> None:
    grasp = opened("paper-three-contacts-preload-1", wrench=[0, "-3/2", 0])
    assert facts(browser)["states"] == "stick, stick, stick"
    assert check_law(grasp, [Fraction(0), Fraction("-3/2"), Fraction(0)], browser) == 3
    assert len(told(browser, "#grasp .force")) == 3
    assert len(told(browser, "#grasp .state.stick")) == 3


def paper_place(browser: Browser, x: float, y: float) -> tuple[float, float]:
    """Return where a force is in the window, read off two numbers on the axes."""
    place = browser.run(
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
        return [there.x, there.y];
        """,
        x,
        y,
    )
    return place[0], place[1]


@pytest.mark.parametrize("name", PAPER)
def test_the_picture_agrees_with_the_solver(name: str, browser: Browser, opened: Opened) -> None:
    """A piece is drawn at a place exactly when the force there is resisted."""
    grasp = opened(name)
    for x, y in product((-1.37, -0.43, 0.31, 1.57), (-1.46, -0.62, 0.23, 0.71, 1.34)):
        px, py = paper_place(browser, x, y)
        drawn = browser.run(
            "return document.elementsFromPoint(arguments[0], arguments[1])"
            ".some((element) => element.classList.contains('piece'))",
            px,
            py,
        )
        assert drawn == solve(grasp, [Fraction(str(x)), Fraction(str(y)), 0]).stable, (x, y)


def test_pointing_at_a_force_tells_its_states(browser: Browser, opened: Opened) -> None:
    grasp = opened("paper-three-contacts-preload-1")
    browser.pointer("mouseMoved", *paper_place(browser, 1.5, -1.1))
    x, y = (Fraction(v) for v in facts(browser)["force (f_x, f_y)"].strip("()").split(", "))
    assert abs(x - Fraction("1.5")) < Fraction("0.1")
    assert verdict(browser) == "Resisted"
    check_law(grasp, [x, y, Fraction(0)], browser)
    assert len(told(browser, "#plane .held-piece")) == 1
    browser.pointer("mouseMoved", *paper_place(browser, 0.5, 3))
    assert verdict(browser) == "Not resisted"
    browser.pointer("mouseMoved", 3, 3)
    assert verdict(browser) == "No force chosen"


def test_a_click_keeps_the_force_and_shows_its_exact_piece(
    browser: Browser, opened: Opened
) -> None:
    opened("paper-three-contacts-preload-1")
    browser.click_at(*paper_place(browser, 0.1, -1))
    browser.pointer("mouseMoved", 3, 3)
    assert verdict(browser) == "Resisted"
    assert re.search(r"2 f_x \+ p ≥ 0", facts(browser)["piece"])
    browser.run("document.getElementById('plane').focus()")
    browser.key("Escape")
    assert verdict(browser) == "No force chosen"


def test_all_choices_of_states_can_be_seen(browser: Browser, opened: Opened) -> None:
    """On the border between pieces each of them is a choice."""
    opened("paper-three-contacts", wrench=[0, -1, 0])
    labels = told(browser, "#choices button")
    assert len(labels) >= 2
    seen = set()
    for k in range(len(labels)):
        browser.run("document.querySelectorAll('#choices button')[arguments[0]].click()", k)
        browser.settled()
        seen.add(facts(browser)["states"])
    assert len(seen) == len(labels)


def test_dragging_moves_and_keys_zoom(browser: Browser, opened: Opened) -> None:
    opened("paper-three-contacts-preload-1")
    html = "return document.getElementById('plane').innerHTML"
    start = browser.run(html)
    x, y = paper_place(browser, 0, 0)
    browser.drag((x, y), (x + 60, y + 20))
    browser.pointer("mouseMoved", 3, 3)
    moved = browser.run(html)
    assert moved != start
    assert paper_place(browser, 0, 0) == pytest.approx((x + 60, y + 20), abs=6)
    assert verdict(browser) == "No force chosen"
    browser.run("document.getElementById('plane').focus()")
    browser.key("+")
    assert browser.run(html) not in (start, moved)
    browser.key("Home")
    assert browser.run(html) == start


def test_two_fingers_zoom_and_a_tap_chooses(browser: Browser, opened: Opened) -> None:
    opened("paper-three-contacts-preload-1")
    x, y = paper_place(browser, 0, 0)
    right = paper_place(browser, 1, 0)
    browser.fingers(
        [(x - 40, y), (x + 40, y)], [(x - 60, y), (x + 60, y)], [(x - 80, y), (x + 80, y)]
    )
    left, wider = paper_place(browser, 0, 0), paper_place(browser, 1, 0)
    assert wider[0] - left[0] > 1.5 * (right[0] - x)
    assert verdict(browser) == "No force chosen"
    browser.fingers([paper_place(browser, 0, -1)])
    assert verdict(browser) == "Resisted"


def test_what_is_no_number_is_marked_and_changes_nothing(browser: Browser, opened: Opened) -> None:
    opened("paper-three-contacts", wrench=[0, -1, 0])
    for text in ("x", "1/0", "1e", "", "--1", "0x1"):
        enter(browser, force_y=text)
        assert invalid(browser) == 1
        assert "3/4" in problem(browser)
        assert facts(browser)["force (f_x, f_y)"] == "(0, -1)"
    enter(browser, force_y="-1/3")
    assert invalid(browser) == 0
    enter(browser, preload="-1")
    assert invalid(browser) == 1
    assert "at least 0" in problem(browser)


def test_text_of_a_title_stays_text(browser: Browser, opened: Opened) -> None:
    title = "</script><script>document.title = 'gone'</script>"
    opened("paper-three-contacts", title=title)
    assert browser.run("return document.title") == title


@pytest.mark.parametrize("width", [390, 1280])
def test_nothing_sticks_out_of_the_window(width: int, browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text(resist_page(MIXED), encoding="utf-8")
    browser.open(path, width=width)
    ready(browser)
    assert browser.run("return document.documentElement.scrollWidth") <= width
    assert browser.messages() == []


@pytest.mark.parametrize(
    "grasp",
    [
        Grasp(),
        Grasp([Contact([0, 0], [0, 1], 0)]),
        Grasp([Contact([10**30, 0], [-1, 0], "1/3", 1, 1), Contact([-(10**30), 0], [1, 0], 1)]),
        Grasp([Contact([1, 0], [-1, 0], "1/2", 1, 1), Contact([1, 0], [-1, 0], "1/2", 1, 1)]),
    ],
    ids=["none", "frictionless", "far", "twice"],
)
def test_unusual_grasps_are_shown(grasp: Grasp, browser: Browser, opened: Opened) -> None:
    opened(grasp)
    for y in ("0", "-1/3"):
        enter(browser, force_x=0, force_y=y)
        stable = solve(grasp, [0, y, 0]).stable
        assert (verdict(browser) == "Resisted") == stable
    assert browser.messages() == []


def test_the_command_writes_the_page(tmp_path: Path) -> None:
    target = tmp_path / "a.html"
    options = ["--view", "resist", "--wrench", "0", "-1", "0", "--title", "Three"]
    assert main(["draw", "paper-three-contacts", "-o", str(target), *options]) == 0
    text = target.read_text(encoding="utf-8")
    assert "<title>Three</title>" in text
    assert len(text) < 300_000
    target.unlink()
    assert main(["draw", "paper-three-contacts", "-o", str(target), "--width", "90"]) == 2
    assert not target.exists()


def test_too_many_contacts_are_refused() -> None:
    contact = Contact([0, 0], [0, 1], 0)
    with pytest.raises(InputError, match="at most"):
        resist_page(Grasp([contact] * (MAX_CONTACTS + 1)))
