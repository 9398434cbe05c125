"""The slip lab, opened in headless Chromium: its answers against the solver and the checker."""

import json
import random
import time
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arrangement import InputError
from arrangement.drawing.scene import curve_points
from equilibrium import Contact, Grasp, ResistedSet, solve
from equilibrium.certificate.checker import check
from equilibrium.certificate.law import law_problem, law_rows
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.instances import paths
from equilibrium.pictures.body import body, frame_of
from equilibrium.pictures.lab.page import lab_page
from equilibrium.plane.states.contact_states import contact_states
from tests.browser import Browser
from tests.instances import is_in_space

NORMALS = [(1, 0), (0, 1), (-1, 0), (0, -1), ("3/5", "4/5"), ("-5/13", "12/13"), ("-3/5", "-4/5")]
Question = tuple[Grasp, list[Fraction]]


def questions(number: int, seed: int, most: int = 4) -> list[Question]:
    """Return grasps on a coarse grid, with twins, planes that coincide, and boundary wrenches."""
    rng = random.Random(seed)

    def contact() -> Contact:
        point = [Fraction(rng.randint(-4, 4), 2) for _ in range(2)]
        friction = rng.choice(["0", "1/2", "1", "1/3"])
        stiffness, preload = rng.choice([1, 2, "1/2"]), rng.choice([0, 0, 1, 2])
        return Contact(point, rng.choice(NORMALS), friction, stiffness, preload)

    found = []
    for _ in range(number):
        contacts = [contact() for _ in range(rng.randint(0, most))]
        if contacts and rng.random() < 0.2:
            contacts.append(contacts[0])
        wrench = [Fraction(rng.randint(-4, 4), rng.choice([1, 2])) for _ in range(3)]
        found.append((Grasp(contacts), wrench if rng.random() < 0.9 else [Fraction(0)] * 3))
    return found


@pytest.fixture
def opened(browser: Browser, tmp_path: Path) -> Browser:
    """Return the browser with the lab of the three contacts with preload, under (0, 1, 0)."""
    browser.show(lab_page(), tmp_path)
    return browser


def texts(wrench: list[Fraction]) -> list[str]:
    return list(map(str, wrench))


def verdict(browser: Browser) -> str:
    """Return what the page says, once it has looked."""
    browser.settled()
    for _ in range(100):
        busy = "return document.querySelector('#verdict.stale, #verdict[aria-busy=true]')"
        if not browser.run(busy):
            break
        time.sleep(0.05)
    return browser.text("verdict")


def question(browser: Browser) -> Question:
    """Return grasp and wrench of the address."""
    _, contacts, wrench, *_ = browser.run("return location.hash.slice(1)").split("|")
    rows = [one.split(",") for one in contacts.split(";") if one]
    return Grasp(Contact(r[:2], r[2:4], *r[4:]) for r in rows), [
        Fraction(x) for x in wrench.split(",")
    ]


def assert_right(browser: Browser) -> None:
    """Check what the page says about its question by the solver."""
    grasp, wrench = question(browser)
    found = solve(grasp, wrench)
    assert verdict(browser).startswith("Resisted" if found.stable else "Not resisted")


def grip(browser: Browser, name: str) -> tuple[float, float]:
    return browser.middle(f"[data-grip='{name}'] .knob")


@pytest.mark.slow
def test_lab_answers_equal_the_solver(opened):
    """A third route to the verdict: it shares nothing with the solver but the form of files."""
    seen = set()
    named = [
        (read_grasp(name), [Fraction(x) for x in w])
        for name in paths()
        if not is_in_space(name)
        for w in WRENCHES
    ]
    for grasp, wrench in [*questions(100, seed=7), *questions(4, 3, most=6), *named]:
        answer: dict[str, Any] = opened.run(
            "return Promise.all([lab.solve(...arguments), lab.equilibria(...arguments)])"
            ".then(([answer, equilibria]) => ({ ...answer, equilibria }))",
            grasp.to_dict(),
            texts(wrench),
        )
        found = Solver(grasp).solve(wrench)
        assert answer["stable"] == found.stable, (grasp, wrench)
        report = check(answer["certificate"], question=(grasp, tuple(wrench)))
        assert report, (report.problem, json.dumps(answer["certificate"]))
        for piece in answer["equilibria"]:
            motion = tuple(map(Fraction, piece["motion"]))
            forces = [tuple(map(Fraction, pair)) for pair in piece["forces"]]
            assert not law_problem(law_rows(grasp), tuple(wrench), motion, forces)
        if all(piece.unique for piece in found.equilibria):
            assert {tuple(map(Fraction, p["motion"])) for p in answer["equilibria"]} == {
                piece.motion for piece in found.equilibria
            }
        seen.add((found.stable, len(found.equilibria) > 1))
    assert {(True, False), (True, True), (False, False)} <= seen


WRENCHES = [
    ("0", "1", "0"),
    ("0", "-1", "0"),
    ("0", "0", "3"),
    ("-3/2", "0", "0"),
    ("0", "1000001/1000000", "0"),
]


def test_it_finds_the_contact_states_that_occur(opened):
    for grasp, _ in questions(20, seed=11, most=3):
        states = opened.run("return lab.states(arguments[0])", grasp.to_dict())
        assert sorted(map(tuple, states)) == sorted(contact_states(grasp))


def _full(piece: dict[str, Any]) -> list[list[str]]:
    return [] if piece["equalities"] else sorted(piece["inequalities"])


def test_its_pieces_of_wrenches_are_those_of_the_resisted_set(opened):
    """As conditions; where they have equalities, those have no one form, and are counted."""
    grasps = [grasp for grasp, _ in questions(20, seed=13)]
    listed = opened.run("return arguments[0].map(lab.pieces)", [g.to_dict() for g in grasps])
    for grasp, pieces in zip(grasps, listed, strict=True):
        expected = [piece.polyhedron.to_dict() for piece in ResistedSet(grasp).polyhedra]
        found, due = (
            sorted((len(one["equalities"]), _full(one)) for one in some)
            for some in (pieces, expected)
        )
        assert found == due


def test_the_border_is_met_exactly(opened):
    opened.put("w-y", "1", "input")
    assert verdict(opened).startswith("Resisted")
    opened.put("w-y", f"{10**30 + 1}/{10**30}", "input")
    assert verdict(opened).startswith("Not resisted")


def test_dragging_by_mouse_and_finger_snaps_to_exact_numbers(opened):
    for name in ("load", "torque", "move-1", "turn-0"):
        before = question(opened)
        x, y = grip(opened, name)
        opened.drag((x, y), (x + 24, y + 31))
        assert_right(opened)
        moved = question(opened)
        assert moved != before, name
        x, y = grip(opened, name)
        opened.fingers([(x, y)], [(x + 10, y - 12)], [(x + 40, y - 44)])
        assert_right(opened)
        assert question(opened) not in (moved, before), name
    assert opened.messages() == []


@pytest.mark.parametrize(
    ("outline", "touches"),
    [
        ([["-1", "-2"], ["1", "-2"], ["1", "3/2"], ["0", "9/4"], ["-1", "3/2"]], "roof"),
        ({"centre": ["0", "1/4"], "radius": "5/3"}, "circle"),
    ],
)
def test_a_contact_slides_along_a_stated_outline(outline, touches, browser, tmp_path):
    """Its normal follows, and both stay exact."""
    form = {**read_grasp("paper-four-contacts-preload-1").to_dict(), "outline": outline}
    browser.show(lab_page(Grasp.from_dict(form), wrench=[0, -1, 0]), tmp_path)
    x, y = grip(browser, "move-0")
    browser.drag((x, y), (x + 40, y - 20))
    grasp, _ = question(browser)
    (px, py), (nx, ny) = grasp.contacts[0].point, grasp.contacts[0].normal
    if touches == "roof":
        assert py == Fraction(9, 4) + Fraction(3, 4) * px
        assert (nx, ny) == (Fraction(3, 5), Fraction(-4, 5))
    else:
        assert px**2 + (py - Fraction(1, 4)) ** 2 == Fraction(25, 9)
        assert (nx, ny) == (-px * 3 / 5, (Fraction(1, 4) - py) * 3 / 5)
    assert_right(browser)
    browser.run("document.getElementById('undo').click()")
    assert question(browser)[0] == Grasp.from_dict(form)
    browser.run("document.getElementById('redo').click()")
    address = browser.run("return location.href")
    browser.open(address)
    assert question(browser)[0] == grasp
    assert browser.count("#grasp .body.stated") == 1


def test_all_can_be_done_with_keys(opened):
    opened.run("document.querySelector('[data-grip=\"move-0\"]').focus()")
    for name, change in [("ArrowUp", "point"), ("[", "normal")]:
        before = question(opened)[0].contacts[0]
        opened.key(name)
        after = question(opened)[0].contacts[0]
        assert getattr(after, change) != getattr(before, change)
        assert_right(opened)
    opened.key("Delete")
    assert len(question(opened)[0]) == 2
    assert_right(opened)
    opened.run("document.getElementById('plane').focus()")
    opened.key("ArrowDown")
    assert question(opened)[1] == [0, Fraction(3, 4), 0]
    opened.run("document.querySelector('[data-grip=\"torque\"]').focus()")
    opened.key("ArrowUp")
    assert question(opened)[1][2] == Fraction(1, 4)
    assert_right(opened)
    assert opened.text("said")


def test_the_address_holds_the_state(opened, tmp_path):
    url = (tmp_path / "page.html").as_uri()
    opened.open(f"{url}#1|0,0,3/5,4/5,1/3,2,1;0,1,0,-1,0,1,0|-1/2,1,1e-3")
    opened.settled()
    grasp, wrench = question(opened)
    assert grasp == Grasp(
        [Contact([0, 0], ["3/5", "4/5"], "1/3", 2, 1), Contact([0, 1], [0, -1], 0)]
    )
    assert wrench == [Fraction(-1, 2), 1, Fraction(1, 1000)]
    assert_right(opened)


def test_a_cell_of_motions_is_shown_on_the_grasp(opened):
    verdict(opened)  # whose words move the discs
    x, y = opened.run(
        "const r = document.getElementById('discs').getBoundingClientRect();"
        "return [r.x + r.width * 0.3, r.y + r.height * 0.35]"
    )
    opened.click_at(x, y)
    said = opened.text("motion-words")
    motion = [Fraction(v) for v in said.partition("(")[2].partition(")")[0].split(", ")]
    grasp, _ = question(opened)
    assert motion[2] > 0
    for i, contact in enumerate(grasp, 1):
        slip = sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        gap = contact.stiffness * sum(
            a * b for a, b in zip(contact.normal_wrench, motion, strict=True)
        )
        state = "detached" if gap >= contact.preload else f"slip{'+' if slip > 0 else '-'}"
        assert f"{i} {state if slip or state == 'detached' else 'stick'}" in said
    assert opened.count("#grasp .ghost .moved") == 1
    under = opened.run(
        "return document.elementFromPoint(arguments[0], arguments[1])"
        ".closest('[data-states]').dataset.states",
        x,
        y,
    )
    assert all(f"{i} {state}" in said for i, state in enumerate(under.split(","), 1))
    lit = opened.count("#discs .cell.lit")
    assert lit >= 1
    told = opened.run(
        "return [...document.querySelectorAll('#grasp .told-states .state')]"
        ".map((element) => element.classList[1])"
    )
    expected = ["slip" if "slip" in state else state for state in under.split(",")]
    assert told == expected
    opened.key("Escape")
    assert "Click" in opened.text("motion-words")


def test_first_screen_shows_question_pictures_and_answer(browser, tmp_path):
    browser.show(lab_page(), tmp_path, 1280, 800)
    verdict(browser)
    assert browser.text("question") == "Does the grasp resist the load (0, 1, 0)?"
    assert browser.run("return document.documentElement.scrollHeight") <= 800
    for name in ("grasp", "answer", "discs", "plane"):
        assert browser.run("return document.getElementById(arguments[0]).clientHeight", name) > 150
    assert browser.count("details[open]") == 0


def test_indicative_outline_is_that_of_still_pictures(opened):
    built_in = [read_grasp(path) for path in paths() if not is_in_space(path)]
    random_ones = [grasp for grasp, _ in questions(60, 44)]
    curves = 0
    for grasp in [*built_in, *random_ones]:
        frame = frame_of(grasp)
        drawn = body(grasp, frame)
        shown = opened.run("return window.lab.outline(arguments[0])", grasp.to_dict())
        if drawn is None:
            assert shown is None, grasp
            continue
        curves += 1
        middle, half = np.array(frame.centre, dtype=float), float(frame.half)
        places = middle + half * curve_points(drawn, 16)
        assert np.array(shown) == pytest.approx(places, abs=1e-6), grasp
    assert curves > 30


def test_index_of_a_force_stands_lower(opened):
    verdict(opened)
    assert opened.texts("#plane tspan") == ["x", "y"]
    assert opened.texts("#load sub") == ["x", "y"]
    assert "x" in opened.texts("#conditions sub")
    script = "return document.getElementById(arguments[0]).textContent.includes('f_')"
    assert not any(opened.run(script, name) for name in ("plane", "load", "conditions"))


@pytest.mark.parametrize(("width", "first"), [(390, "contacts"), (800, "forces")])
def test_codes_of_states_are_at_least_eleven_pixels_high(width, first, browser, tmp_path):
    browser.show(lab_page(read_grasp("paper-four-contacts"), first=first), tmp_path, width, 844)
    verdict(browser)
    sizes = browser.run(
        "return [...document.querySelectorAll('#discs text, #plane .code')]"
        ".map((e) => parseFloat(getComputedStyle(e).fontSize) * e.getScreenCTM().a)"
    )
    assert len(sizes) > 2
    assert min(sizes) >= 11


def test_directions_may_have_decimal_commas(opened):
    opened.run("document.querySelector('#tabs [data-contact]').click()")
    for text in ("3/5, 4/5", "0.6, 0.8", "0,6; 0,8", "0,6 0,8", "(3, 4)"):
        opened.put("c-n", "1, 0", "input")
        opened.put("c-n", text, "input")
        assert opened.count('[aria-invalid="true"]') == 0, text
        grasp, _ = question(opened)
        assert list(map(str, grasp.contacts[0].normal)) == ["3/5", "4/5"], text
    for text in ("0,6, 0,8", "3; 4; 5"):
        opened.put("c-n", text, "input")
        assert opened.count('[aria-invalid="true"]') == 1, text


FILLS = "return [...document.querySelectorAll(arguments[0])].map((one) => one.style.fill)"


def test_the_algorithms_can_be_stepped(opened):
    time.sleep(0.5)
    opened.put("algorithm", "planes")
    for expected, edges in (("2", 1), ("4", 4), ("8", 12)):
        assert opened.run("return document.querySelector('#told b').textContent") == expected
        assert opened.count("#dual .vertex") == int(expected)
        assert opened.count("#dual .edge") == edges
        opened.run("document.getElementById('step').click()")
    fills = set(opened.run(FILLS, "#dual .vertex"))
    assert len(fills) == 8
    assert fills == set(opened.run(FILLS, "#discs .cell"))
    opened.put("algorithm", "states")
    grasp, wrench = question(opened)
    accepted = []
    for _ in contact_states(grasp):
        said = opened.text("told")
        if "✓" in said:
            accepted.append(said)
        else:
            assert "rejected" in said or "contradict" in said or "none obeys" in said
        opened.run("document.getElementById('step').click()")
    assert bool(accepted) == solve(grasp, wrench).stable


def test_a_refuted_load_shows_its_proof(opened):
    opened.put("w-y", "5/4", "input")
    assert verdict(opened).startswith("Not resisted")
    said = opened.run("return document.querySelector('.work').textContent")
    assert "Virtual motion" in said
    assert opened.count("#grasp .ghost") == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "grasp",
    [
        Grasp(),
        Grasp([Contact([0, 0], [0, 1], 0)]),
        Grasp([Contact([10**30, 0], [-1, 0], "1/3", 1, 1), Contact([-(10**30), 0], [1, 0], 1)]),
        Grasp([Contact([1, 0], [-1, 0], "1/2", 1, 1), Contact([1, 0], [-1, 0], "1/2", 1, 1)]),
        Grasp([Contact([Fraction(1, 10**90 + 7), 0], [0, 1], 10**60, 1, Fraction(1, 3))]),
    ],
    ids=["none", "frictionless", "far", "twice", "long"],
)
def test_unusual_grasps_are_shown(grasp, browser, tmp_path):
    browser.show(lab_page(grasp, wrench=[0, -1, 0]), tmp_path)
    assert_right(browser)
    browser.run("document.getElementById('add').click()")
    assert len(question(browser)[0]) == len(grasp) + 1
    assert_right(browser)
    assert browser.messages() == []


@pytest.mark.parametrize("stated", [False, True])
def test_motions_are_too_large_only_where_units_are_stated(stated, browser, tmp_path):
    grasp = read_grasp("paper-three-contacts-preload-1")
    grasp = grasp.with_units("m", "N") if stated else grasp
    browser.show(lab_page(grasp, wrench=[0, "1/2", "1/2"]), tmp_path)
    assert verdict(browser).startswith("Resisted")
    text = browser.run("return document.body.innerText")
    assert ("Beyond small motions" in text) == stated


def test_an_equilibrium_is_shown_while_others_are_still_listed(browser, tmp_path):
    """A ring of eight has more choices of states than can be listed within a second."""
    corners = [("1", "0"), ("4/5", "3/5"), ("0", "1"), ("-3/5", "4/5")]
    places = [[sign * Fraction(x) for x in corner] for corner in corners for sign in (1, -1)]
    ring = Grasp(Contact(place, [-x for x in place], "1/2", 1, 1) for place in places)
    browser.show(lab_page(ring, wrench=[1, 0, 0]), tmp_path)
    while not (shown := browser.text("verdict")).startswith("Resisted"):
        time.sleep(0.05)
    assert "so far" in shown
    assert browser.count("#answer tr") == 9
    browser.put("w-t", "9", "input")
    browser.put("w-x", "0", "input")
    assert verdict(browser).startswith("Not resisted")
    assert_right(browser)
    assert browser.messages() == []


@pytest.mark.parametrize("broken", ["", "delete window.Worker", "window.Worker = BROKEN"])
def test_it_answers_in_a_worker_and_without_one(broken, browser, tmp_path):
    fails = "class { postMessage() { setTimeout(() => this.onerror(), 0); } }"
    ahead = {"source": broken.replace("BROKEN", fails)}
    name = browser.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", ahead)
    try:
        browser.show(lab_page(read_grasp("several-equilibria"), wrench=[-1, 0, 0]), tmp_path)
        assert verdict(browser).startswith("Resisted 2 families of equilibria, exact")
    finally:
        browser.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", name)
    assert any(url.startswith("blob:") for url in browser.requests()) == (not broken)
    assert browser.messages() == []


def test_a_grasp_in_space_is_refused():
    with pytest.raises(InputError, match="in space"):
        lab_page(read_grasp("two-opposed-fingers"))


def test_too_many_contacts_or_digits_are_refused():
    with pytest.raises(InputError, match="9 contacts in the lab; at most 8"):
        lab_page(Grasp([Contact([0, 0], [0, 1], 0)] * 9))
    with pytest.raises(InputError, match="the lab: 1,001 digits of a number on a page"):
        lab_page(wrench=[10**1000, 0, 0])
