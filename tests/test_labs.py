"""What holds of every page, and of both labs: the slip lab and the lab of lines."""

import json
import re
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import partial
from importlib.resources import files
from typing import Any, NamedTuple

import pytest

from arrangement import Arrangement, read_arrangement
from arrangement.cli import main as arrangement_main
from arrangement.console.plugins import InlinePage
from arrangement.pictures import arrangement_page, cells_page
from arrangement.pictures.lab import widget
from arrangement.pictures.lab.lines import (
    lab_page as lines_page,
    line_exercises,
    read_start as read_lines,
)
from equilibrium import Grasp, read_grasp
from equilibrium.cli.program import main
from equilibrium.grasps.inputs import random_grasp
from equilibrium.pictures import proof_page, resist_page
from equilibrium.pictures.lab.page import lab_page, read_start as read_slip, slip_exercises
from equilibrium.pictures.space_grasp import grasp_page
from equilibrium.pictures.wrench_set import wrench_set_page
from tests.arrangement.test_lab import checked, fact, shown
from tests.browser import Browser
from tests.equilibrium.test_lab import question, verdict

ONE_SIDE = Grasp([c for c in random_grasp(150, 7) if c.normal[1] > 0][:50]).with_preload(1)
PAGES: dict[str, Callable[..., str]] = {
    "slip": lab_page,
    "lines": lines_page,
    "resist": partial(resist_page, read_grasp("paper-four-contacts-preload-1")),
    "arrangement": partial(arrangement_page, read_arrangement("nine-generic-planes")),
    "cells": partial(cells_page, read_arrangement("parallel-planes-affine")),
    "proof": partial(proof_page, ONE_SIDE, wrench=(50, 2000, 150)),
    "grasp in space": partial(grasp_page, read_grasp("wedge"), wrench=(0, 0, -1, 0, 0, 0)),
    "wrench set": partial(wrench_set_page, read_grasp("paper-three-contacts")),
}


@pytest.mark.parametrize("name", PAGES)
def test_page_fits_repeats_and_is_self_contained(name, browser, tmp_path):
    title = "</script><script>document.title = 'gone'</script><b>&amp;"
    page = PAGES[name](title=title)
    assert page == PAGES[name](title=title)
    assert len(page.encode()) < 400_000
    browser.show(page, tmp_path, 390, 900)
    for width in (390, 800, 1280):
        browser.resize(width, 900)
        browser.settled()
        assert browser.run("return document.documentElement.scrollWidth") <= width
        assert browser.messages() == []
        assert browser.outside() == []
    assert browser.run("return document.title") == title
    browser.run("const image = new Image(); image.src = 'http://127.0.0.1:9/x.png'")
    browser.settled()
    assert any("Content Security Policy" in message for message in browser.messages())


def test_the_commands_write_them(tmp_path):
    path = tmp_path / "lab.html"
    three = ["draw", "paper-three-contacts", "--title", "A", "--wrench", "0", "1", "0", "-o"]
    for run, arguments, expected in [
        (main, ["lab", "-o"], lab_page()),
        (
            main,
            ["lab", "several-equilibria", "--wrench", "0,-1,0", "--title", "A", "-o"],
            lab_page(read_grasp("several-equilibria"), wrench=[0, -1, 0], title="A"),
        ),
        (
            main,
            [*three[:-1], "--view", "resist", "-o"],
            resist_page(read_grasp("paper-three-contacts"), wrench=[0, 1, 0], title="A"),
        ),
        (
            main,
            [*three[:-1], "--view", "proof", "-o"],
            proof_page(read_grasp("paper-three-contacts"), wrench=[0, 1, 0], title="A"),
        ),
        (arrangement_main, ["lab", "-o"], lines_page()),
        (
            arrangement_main,
            ["lab", "reflection-b3", "--title", "A", "-o"],
            lines_page(read_arrangement("reflection-b3"), title="A"),
        ),
        (
            arrangement_main,
            ["draw", "nine-generic-planes", "--title", "A", "-o"],
            arrangement_page(read_arrangement("nine-generic-planes"), title="A"),
        ),
    ]:
        assert run([*arguments, str(path)]) == 0
        assert path.read_text(encoding="utf-8") == expected


def open_file(browser: Browser, text: str) -> None:
    """Choose a file with a text."""
    browser.run(
        "const files = new DataTransfer(); files.items.add(new File([arguments[0]], 'a.json'));"
        "const box = document.getElementById('file'); box.files = files.files;"
        "box.dispatchEvent(new Event('change'))",
        text,
    )
    browser.settled()


class Lab(NamedTuple):
    """A lab: what it shows at first, and what is wrong with addresses, files and fields."""

    page: Callable[..., str]
    main: Callable[[list[str]], int]
    #: What the page shows, as an object; whether it shows the answer to what it opens with.
    state: Callable[[Browser], Any]
    answers: Callable[[Browser], bool]
    #: A part of the JSON that its command prints.
    answer: tuple[str, Any]
    #: A field of a number; values that it does not take, each typed after others.
    field: str
    refused: list[tuple[list[tuple[str, str]], str]]
    addresses: list[tuple[str, str]]
    files: list[tuple[str, str]]
    #: A document, and what it shows in a notebook.
    document: Arrangement | Grasp
    said: Callable[[Browser], bool]


LABS = {
    "slip": Lab(
        lab_page,
        main,
        lambda browser: question(browser)[0],
        lambda browser: verdict(browser).startswith("Resisted"),
        ("stable", True),
        "c-x",
        [
            ([("c-friction", "-1")], "friction"),
            ([("c-stiffness", "0")], "stiffness"),
            ([("c-n", "1, 1")], "3/5"),
        ],
        [
            ("2|0,0,1,0,1,1,0|0,0,0", "version 2"),
            ("1|0,0,1,1,1,1,0|0,0,0", "length 1"),
            ("1|<b>,0,1,0,1,1,0|0,0,0", "point"),
            ("1|0,0,1,0,1,1,0", "whole"),
            ("1||0,0", "three numbers"),
            ("1|" + ";".join(["0,0,1,0,1,1,0"] * 9) + "|0,0,0", "9 contacts"),
        ],
        [
            ("{", "JSON"),
            ('{"planes": []}', "not a grasp"),
            ('{"schema_version": 1, "contacts": [{"point": [0.5, 0]}]}', "point"),
            ('{"schema_version": 1, "contacts": [], "outline": [["0", "0"]]}', "outline"),
        ],
        read_grasp("several-equilibria"),
        lambda browser: bool(verdict(browser)),
    ),
    "lines": Lab(
        lines_page,
        arrangement_main,
        shown,
        lambda browser: fact(browser, "f-vector") == "(1, 20, 40, 22)",
        ("f_vector", [1, 20, 40, 22]),
        "row-a",
        [([("row-c", "0"), ("row-b", "0")], "zeros")],
        [
            ("2|3|1,0,0", "version 2"),
            ("1|4|1,0,0", "whole"),
            ("1|3|1,0", "three numbers"),
            ("1|3|<b>,0,1", "three numbers"),
            ("1|2|0,0,1", "zeros"),
            ("1|3|" + ";".join(["1,0,0"] * (20 + 1)), "21 planes"),
            ("%E0%A4%A", "Not taken"),
        ],
        [
            ("{", "JSON"),
            ('{"contacts": []}', "not an arrangement"),
            ('{"schema_version": 1, "planes": [["1", "0", "0", "1"]]}', "two entries"),
            ('{"schema_version": 1, "planes": [["0.5", 0.5, "0"]]}', "plane 1"),
            ('{"schema_version": 1, "planes": [["1", "0", "0"]], "offsets": ["1"]}', "origin"),
        ],
        read_arrangement("braid-a3"),
        lambda browser: fact(browser, "type") == "6.3, braid arrangement A₃",
    ),
}


@pytest.fixture(params=LABS.values(), ids=LABS)
def lab(request):
    return request.param


@pytest.fixture
def opened(lab, browser, tmp_path):
    browser.show(lab.page(), tmp_path)
    return browser


def test_what_is_no_number_is_marked_and_changes_nothing(lab, opened):
    before = lab.state(opened)
    for text in ["1/0", "abc", "", "0x1", "1e", "--1", ".", "1.5/2", "-"]:
        opened.put(lab.field, text, "input")
        assert opened.count('[aria-invalid="true"]') == 1
        assert "3/4" in opened.text("problem")
        assert lab.state(opened) == before
    opened.put(lab.field, "-1e-3", "input")
    assert opened.count('[aria-invalid="true"]') == 0
    exact = json.dumps(lab.state(opened).to_dict())
    assert '"-1/1000"' in exact or '["-1", "1000", "-1000"]' in exact


def test_a_decimal_comma_is_read_as_a_point(lab, opened):
    found = []
    for text in ("-0,75", "-0.75"):
        opened.put(lab.field, text, "input")
        assert opened.count('[aria-invalid="true"]') == 0
        found.append(lab.state(opened))
        opened.put(lab.field, "1", "input")
    assert found[0] == found[1] != lab.state(opened)
    opened.put(lab.field, "1,2,3", "input")
    assert opened.count('[aria-invalid="true"]') == 1


def test_numbers_out_of_range_are_refused(lab, opened):
    for (*before, last), why in lab.refused:
        for field, text in before:
            opened.put(field, text, "input")
        kept = lab.state(opened)
        opened.put(*last, "input")
        assert why in opened.text("problem")
        assert lab.state(opened) == kept


def test_a_wrong_address_is_explained_and_the_page_still_works(lab, opened, tmp_path):
    opened.open(f"{(tmp_path / 'page.html').as_uri()}#{lab.addresses[0][0]}")
    opened.settled()
    for address, why in lab.addresses:
        shows(opened, address)
        assert why in opened.text("problem")
        assert lab.answers(opened)
        assert opened.messages() == []


def test_a_file_that_is_none_is_explained(lab, opened):
    before = lab.state(opened)
    for text, why in lab.files:
        open_file(opened, text)
        assert why in opened.text("problem")
        assert lab.state(opened) == before
    open_file(opened, json.dumps(lab.document.to_dict()))
    assert lab.state(opened) == lab.document
    assert not opened.text("problem")


def test_its_command_line_repeats_the_answer(lab, opened, tmp_path, capsys):
    opened.run("document.getElementById('copy-command').click()")
    command = opened.text("kept")
    document, _, rest = command.removeprefix("echo '").partition("' | ")
    path = tmp_path / "given.json"
    path.write_text(document)
    words = [str(path) if word == "-" else word for word in rest.split()[1:]]
    assert lab.main([*words, "--json"]) == 0
    key, value = lab.answer
    assert json.loads(capsys.readouterr().out)[key] == value


def test_a_notebook_shows_it_in_a_frame(lab, browser, tmp_path):
    cell = InlinePage(lab.page(lab.document))._repr_html_()
    browser.show(f"<!DOCTYPE html><title>N</title>{cell}", tmp_path)
    browser.driver.switch_to.frame(0)
    try:
        assert lab.said(browser)
        browser.run("document.getElementById('add').click()")
        browser.settled()
        assert lab.said(browser) or lab.page is lines_page
    finally:
        browser.driver.switch_to.default_content()
    assert browser.messages() == []
    assert browser.outside() == []


#: A notebook: the script of the widget with a model that keeps what it is given.
NOTEBOOK = """<!DOCTYPE html><meta charset="utf-8"><title>N</title><div id="cell"></div>
<script type="application/json" id="page">{page}</script><script>{script}
const page = JSON.parse(document.getElementById("page").textContent);
widget.render({{ el: document.getElementById("cell"), model: {{
  get: () => page, set: (name, value) => {{ window.got = [name, value]; }}, save_changes() {{}},
}} }});</script>"""


def test_a_widget_gives_its_state_back(lab, browser, tmp_path):
    script = files("arrangement.pictures.lab").joinpath("templates", "widget.js")
    text = json.dumps(lab.page(lab.document)).replace("<", "\\u003c")
    code = script.read_text("utf-8").replace("export default", "const widget =")
    browser.show(NOTEBOOK.format(page=text, script=code), tmp_path)
    browser.driver.switch_to.frame(0)
    try:
        browser.settled()
        browser.run("document.getElementById('add').click()")
        browser.settled()
    finally:
        browser.driver.switch_to.default_content()
    name, state = browser.run("return window.got")
    shown = (read_lines if lab.page is lines_page else read_slip)(state)
    number = len(shown) if lab.page is lines_page else len(shown[0])
    assert (name, number) == ("state", len(lab.document) + 1)


def test_lab_without_anywidget_is_a_page(lab, monkeypatch):
    monkeypatch.setitem(sys.modules, "anywidget", None)
    widget._widget.cache_clear()
    assert isinstance(lab.document.lab(), InlinePage)
    widget._widget.cache_clear()


def test_attributes_of_a_widget_follow_its_state(monkeypatch):
    pytest.importorskip("anywidget")
    lab = read_grasp("opposed-contacts").lab()
    assert (lab.grasp, lab.wrench) == (read_grasp("opposed-contacts"), (0, 1, 0))
    lab.state = "1|0,0,1,0,1/2,1,0|0,-3,1/2"
    assert (len(lab.grasp), lab.wrench) == (1, (0, -3, Fraction(1, 2)))
    lines = Arrangement([[1, 0], [0, 1]], [0, 1]).lab()
    lines.state = "1|2|1,0,2"
    assert lines.arrangement == Arrangement([[1, 0]], [2])
    with pytest.raises(AttributeError):
        _ = lines.grasp


class Written(NamedTuple):
    """An exercise of the editor: a start, a state that solves it, what is asked and has to stay."""

    lab: str
    start: str
    solution: str
    asked: tuple[str, ...]
    fixed: tuple[str, ...]
    goal: Any


PUSH = "1|-1,0,1,0,1/2,1,{0};0,-1,0,1,1/2,1,{0};1,0,-1,0,1/2,1,{0}|0,1,0"
GRASP = PUSH.format(0), PUSH.format(1)
LINES = "1|3|1,0,0;0,1,0;0,0,1;1,1,1", "1|3|1,0,0;0,1,0;1,1,0;0,0,1"
WRITTEN = [
    Written("slip", *GRASP, ("whether",), ("wrench", "points"), {"resisted": True}),
    Written("slip", *GRASP, ("how many",), (), {"equilibria": 1}),
    Written("slip", *GRASP, ("these states",), (), {"states": ["slip+", "detached", "slip-"]}),
    Written("slip", *GRASP, ("the largest",), ("direction",), {"border": True}),
    Written(
        *("slip", *GRASP, ("the opposite is predicted by the paper",), ()),
        {"method": {"name": "printed", "says": False}},
    ),
    Written("lines", *LINES, ("regions",), ("1", "2"), {"counts": {"regions": 12}}),
    Written(
        *("lines", *LINES, ("t vector", "simplicial", "type"), ()),
        {"counts": {"t_vector": {"2": 3, "3": 1}, "simplicial": True, "type": "4.1"}},
    ),
    Written("lines", *LINES, ("lines that meet",), ("1",), {"meet": [[1, 2, 3]]}),
]


def written(browser: Browser, asked: tuple[str, ...], fixed: tuple[str, ...]) -> str:
    """Fill in the editor, put the exercise into the list, and return what the page says."""
    said: str = browser.driver.execute_async_script(
        "const [asked, fixed, done] = arguments; const at = (id) => document.getElementById(id);"
        "at('own-asked').querySelectorAll('label').forEach((label) => { label.firstChild.checked ="
        " asked.some((words) => label.textContent.trim().startsWith(words)); });"
        "at('own-fixed').querySelectorAll('input').forEach((box) => {"
        " box.checked = fixed.includes(box.value); });"
        "at('own-name').value = '<b>Mine</b>'; at('own-task').value = 'Solve it.';"
        "at('own-hints').value = 'one\\n\\n two'; at('own-put').click();"
        "const look = () => { const said = at('own-said').textContent;"
        "if (said.startsWith('Computing')) setTimeout(look, 5); else done(said); }; look();",
        *(asked, fixed),
    )
    return said


def shows(browser: Browser, link: str) -> None:
    browser.run("location.hash = arguments[0]", link)
    browser.settled()


@pytest.mark.parametrize("one", WRITTEN, ids=lambda one: "-".join(one.asked))
def test_editor_output_is_read_and_solved_by_its_solution(one, browser, tmp_path):
    browser.show(LABS_OF[one.lab](), tmp_path)
    shows(browser, one.start)
    browser.run("document.getElementById('own-start').click()")
    assert written(browser, one.asked, ()).startswith("✗ Not taken: ")
    shows(browser, one.solution)
    assert written(browser, (), ()) == "✗ Not taken: choose what is asked"
    for _ in range(2):  # the second takes the place of the first
        assert written(browser, one.asked, one.fixed).startswith("✓")
    text = browser.driver.execute_async_script(
        "const [done] = arguments; const made = URL.createObjectURL;"
        "URL.createObjectURL = (blob) => { blob.text().then(done); return made.call(URL, blob); };"
        "document.getElementById('own-save').click();"
    )
    path = tmp_path / "own.json"
    path.write_text(text, encoding="utf-8")
    (read,) = (slip_exercises if one.lab == "slip" else line_exercises)(path)
    assert (read["start"], read["goal"], read["hints"]) == (one.start, one.goal, ["one", "two"])
    assert sorted(read["fixed"]) == sorted(one.fixed)
    browser.show(LABS_OF[one.lab](exercises=path), tmp_path)
    browser.put("exercise", 0)
    assert checked(browser).startswith("✗ Not yet")
    shows(browser, one.solution)
    assert checked(browser).startswith("✓ Solved")
    browser.run("document.getElementById('own-remove').click()")
    assert browser.count("#exercise option") == 1
    assert browser.messages() == []


LABS_OF: dict[str, Callable[..., str]] = {"slip": lab_page, "lines": lines_page}
#: Text, and graphics that tell something, with what lies behind. Names a page lacks are left out.
TEXT = {
    "ink": ["paper", "panel", "accent-soft", "body", *(f"sides-{k}" for k in range(2, 8))],
    "soft": ["paper", "panel"],
    "yes": ["paper", "panel", "yes-soft"],
    "no": ["paper", "panel", "no-soft"],
}
GRAPHICS = {
    **{
        name: ["paper", "panel", "body"]
        for name in ("ink", "soft", "accent", "load", "move", "cone")
    },
    "focus": ["paper", "panel", "accent-soft"],
    "no": ["paper", "panel"],
}


def themes(page: str) -> dict[str, dict[str, str]]:
    """Return the colours of the light theme, of the dark one, and of the system's dark one."""
    style = re.sub(r"/\*.*?\*/", "", page[page.index("<style>") : page.index("</style>")])
    selectors = {
        "light": ":root",
        "dark": ':root[data-theme="dark"]',
        "system": ':root:not([data-theme="light"])',
    }
    own = {
        name: dict(re.findall(r"--([\w-]+):\s*(#[0-9a-f]{6})", "".join(blocks)))
        for name, selector in selectors.items()
        if (blocks := re.findall(rf"(?<![\w,]){re.escape(selector)} {{(.*?)}}", style, re.S))
    }
    return {name: {**own["light"], **found} for name, found in own.items()}


def contrast(one: str, other: str) -> float:
    def luminance(colour: str) -> float:
        shares = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
        r, g, b = (x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in shares)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    low, high = sorted(map(luminance, (one, other)))
    return (high + 0.05) / (low + 0.05)


def test_black_on_white_is_21_and_a_known_grey_is_just_enough():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#767676", "#ffffff") == pytest.approx(4.54, abs=0.01)


@pytest.mark.parametrize("name", LABS_OF)
def test_text_and_graphics_stand_out_in_both_themes(name):
    page = LABS_OF[name]()
    found = themes(page)
    assert set(found) == {"light", "dark", "system"}
    assert found["dark"] == found["system"]
    assert found["dark"]["paper"] != found["light"]["paper"]
    weak = [
        (theme, front, behind, round(contrast(colours[front], colours[behind]), 2))
        for theme, colours in found.items()
        for pairs, least in ((TEXT, 4.5), (GRAPHICS, 3))
        for front, backs in pairs.items()
        for behind in backs
        if front in colours and behind in colours
        if contrast(colours[front], colours[behind]) < least
    ]
    assert weak == []
    used = set(re.findall(r"[ {;]color:\s*var\(--([\w-]+)\)", page))
    assert used <= set(TEXT), "text in a colour that is not compared"
