"""The exercises of the slip lab, solved by script, refused when wrong; and files of own ones."""

import json
from pathlib import Path
from typing import Any

import pytest

from equilibrium.certificate.checker import check
from equilibrium.pictures.lab.page import lab_page, read_start, slip_exercises
from tests.arrangement.test_lab import checked
from tests.browser import Browser

EXERCISES = {exercise["name"]: exercise for exercise in slip_exercises()}
THREE = "-1,0,1,0,1/2,1,{0};0,-1,0,1,1/2,1,{0};1,0,-1,0,1/2,1,{0}"
SQUARE = "{0},1,0,0,1,1;{1},0,1,0,1,1;{2},-1,0,0,1,1;{3},0,-1,0,1,1|0,0,1/2"


def loads(*loads: str) -> Any:
    """Return links with the contacts of an exercise and other loads."""
    return lambda start: [f"{start.rpartition('|')[0]}|{load}" for load in loads]


#: For each exercise links that solve it, and links that do not, with a word of the reason.
SOLVED = {
    "Hold by squeezing": lambda _: [f"1|{THREE.format(q)}|0,1,0" for q in ("1", "3/2")],
    "The greatest push": loads("0,1,0"),
    "Let one go": loads("0,1,0", "0,0,1"),
    "All slip, and it holds": loads("0,0,3"),
    "Two equilibria": loads("-1,0,0", "-1/2,0,0"),
    "A gap along a ray": loads("-3/2,0,0"),
    "A solution in the wrong cell": loads("2,0,2"),
    "No contact may let go": loads("-1,0,0", "1,0,0"),
    "Cones are not enough": loads("0,0,3"),
    "Three planes through a line": lambda _: [
        "1|-1,1,0,1,1/2,1,1;0,-1,0,1,1/2,1,1;1,0,0,1,1/2,1,1|0,1,0"
    ],
    "Without friction": lambda _: ["1|" + SQUARE.format("-1,1/2", "-1/2,-1", "1,-1/2", "1/2,1")],
}
REFUSED = {
    "Hold by squeezing": lambda start: [
        (start, "does not resist"),
        (f"1|{THREE.format('1')}|0,1/2,0", "load"),
        (f"1|{THREE.format('1').replace('1/2', '1')}|0,1,0", "friction"),
        (f"1|{THREE.format('1').rpartition(';')[0]}|0,1,0", "3 contacts"),
    ],
    "The greatest push": lambda start: [
        (f"{start.rpartition('|')[0]}|{load}", why)
        for load, why in [
            ("0,3/4,0", "A larger"),
            (f"0,{10**30 + 1}/{10**30},0", "does not resist"),
            (f"0,{10**30 - 1}/{10**30},0", "A larger"),
            ("0,-1,0", "direction"),
            ("1/9,1,0", "direction"),
        ]
    ],
    "Let one go": lambda start: [(start, "stick")],
    "All slip, and it holds": lambda start: [(start, "stick")],
    "Two equilibria": lambda start: [(start, "0 equilibria")],
    "A gap along a ray": lambda start: [
        (start, "resists"),
        (f"{start.rpartition('|')[0]}|-2,0,0", "resists"),
        (f"{start.rpartition('|')[0]}|0,0,0", "direction"),
    ],
    "A solution in the wrong cell": lambda start: [
        (start, "model this load is resisted"),
        (f"{start.rpartition('|')[0]}|0,0,3", "model this load is not resisted"),
        ("1|1,1,-1,0,1,1,1|2,0,2", "2 contacts"),
    ],
    "No contact may let go": lambda start: [(start, "model this load is resisted")],
    "Cones are not enough": lambda start: [(start, "model this load is resisted")],
    "One motion is enough": lambda start: [(start, "Choose")],
    "Three planes through a line": lambda start: [(start, "8 regions")],
    "Without friction": lambda start: [
        (start, "does not resist"),
        ("1|" + SQUARE.format("-1,-1/2", "1/2,-1", "1,1/2", "-1/2,1"), "does not resist"),
        (start.replace("1,0,0,1,1;", "1,0,1,1,1;", 1), "friction"),
    ],
}

#: A worker that fails as soon as it is asked.
BROKEN = "window.Worker = class { postMessage() { setTimeout(() => this.onerror(), 0); } }"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("lab") / "lab.html"
    path.write_text(lab_page(), encoding="utf-8")
    return path


def begin(browser: Browser, page: Path, name: str) -> None:
    browser.open(page)
    browser.settled()
    browser.put("exercise", list(EXERCISES).index(name))


def answer(browser: Browser, link: str) -> str:
    """Change the page to a link, press check, and return what it says."""
    browser.run("location.hash = arguments[0]", link)
    browser.settled()
    assert not browser.text("problem")
    return checked(browser)


def test_there_are_twelve():
    assert len(EXERCISES) == 12
    assert set(REFUSED) == set(SOLVED) | {"One motion is enough"} == set(EXERCISES)
    for exercise in EXERCISES.values():
        assert len(exercise["hints"]) >= 3


@pytest.mark.slow
@pytest.mark.parametrize("name", EXERCISES)
def test_each_is_solved_by_an_answer_and_refuses_wrong_ones(name, page, browser):
    start = EXERCISES[name]["start"]
    begin(browser, page, name)
    for link, why in REFUSED[name](start):
        said = answer(browser, link)
        assert said.startswith("✗"), (link, said)
        assert why in said
    assert browser.text("exercise-done")[0] == "0"
    for link in SOLVED.get(name, lambda _: [])(start):
        said = answer(browser, link)
        assert said.startswith("✓"), (link, said)
    if name in SOLVED:
        assert browser.text("exercise-done")[0] == "1"
    assert browser.messages() == []


def test_a_refuting_motion_is_one_that_the_checker_takes(page, browser):
    name = "One motion is enough"
    begin(browser, page, name)
    grasp, wrench = read_start(EXERCISES[name]["start"])
    assert browser.run("return document.querySelector('.work')") is None
    said = {}
    for motion in ("1, -1, 1", "0, 0, 1", "0, 0, -1", "1, 0, 0", "-1, 1, 1", "0, 1, 1", "-3, 3, 1"):
        browser.put("motion", motion, "input")
        said[motion] = checked(browser)
    proof = {"schema_version": 4, "certificate": "not resisted", "grasp": grasp.to_dict()}
    for motion, text in said.items():
        document = {**proof, "wrench": list(map(str, wrench)), "tree": motion.split(", ")}
        assert text.startswith("✓") == bool(check(document)), (motion, text)
    assert any(text.startswith("✓") for text in said.values())
    assert any("takes work away" in text for text in said.values())


def test_page_stays_responsive_while_checking(page, browser):
    begin(browser, page, "A gap along a ray")
    waits = (
        "const said = document.getElementById('exercise-said');"
        "document.getElementById('exercise-check').click(); const first = said.textContent;"
    )
    changed = "document.getElementById('add').click(); return first;"
    assert browser.run(waits + changed) == "Checking …"
    browser.settled()
    assert browser.text("exercise-said").startswith("Not checked to the end")
    browser.run(waits)
    link = f"{EXERCISES['A gap along a ray']['start'].rpartition('|')[0]}|-3/2,0,0"
    assert answer(browser, link).startswith("✓")
    assert browser.messages() == []


@pytest.mark.parametrize("broken", ["delete window.Worker", BROKEN])
def test_it_checks_where_no_worker_runs(broken, page, browser):
    command = "Page.addScriptToEvaluateOnNewDocument"
    name = browser.driver.execute_cdp_cmd(command, {"source": broken})
    try:
        begin(browser, page, "The greatest push")
    finally:
        browser.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", name)
    start = EXERCISES["The greatest push"]["start"]
    for link, said in (*REFUSED["The greatest push"](start)[:2], (loads("0,1,0")(start)[0], "✓")):
        assert said in answer(browser, link)


def test_hints_come_one_by_one(page, browser):
    begin(browser, page, "Let one go")
    for expected in (0, 1, 2, 3, 3):
        assert browser.count("#exercise-hints li") == (expected)
        browser.run("document.getElementById('exercise-hint').click()")
    assert browser.run("return document.getElementById('exercise-hint').disabled")


OWN = {
    "schema_version": 1,
    "exercises": [
        {
            "name": "<b>Mine</b>",
            "task": "Make it resist.",
            "start": f"1|{THREE.format('0')}|0,1,0",
            "goal": {"resisted": True},
        }
    ],
}


def test_a_lecturer_brings_own_exercises(browser, tmp_path, run):
    path, source = tmp_path / "lab.html", tmp_path / "own.json"
    source.write_text(json.dumps(OWN), encoding="utf-8")
    run("lab -o {} --exercises", path, source)
    browser.open(path)
    browser.put("exercise", 0)
    assert "<b>Mine</b>" in browser.text("exercise")
    assert answer(browser, f"1|{THREE.format('1')}|0,1,0").startswith("✓")
    assert browser.messages() == []
