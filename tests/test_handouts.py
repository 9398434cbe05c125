"""Exercise sheets and solutions are made of a lesson, slides of a file of their own."""

import base64
import functools
import importlib
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.browser import Browser
from tests.docpages import ROOT
from tests.latex import compiled, page_count

sphinx = pytest.importorskip("sphinx.application")

LESSON = r"""
1 A lesson
==========

What it is about, and why.

Definition
----------

A formula ends this sentence:

.. math:: Z = \Big\{ \sum_i \lambda_i n_i \Big\} .

In the lab
----------

Drag `three lines <../pages/gallery-lab.html#1%7C3>`__ there.

Exercises
---------

1. *(by hand)* What is :math:`1 + 1`?
2. *(computer)* And twice that?

Answers
-------

**1.** Two, of course.

>>> 1 + 1
2

**2.** Four, as a rule.

.. figure:: dot.svg
   :alt: a dot

   A picture of <one> dot.
"""


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[..., Path]]:
    """Build the pages of one lesson, and of a course, each text once; return their folder."""

    @functools.cache
    def made(lesson: str, course: str = "") -> Path:
        work = tmp_path_factory.mktemp("handouts")
        lessons = work / "docs" / "lessons"
        lessons.mkdir(parents=True)
        (work / "docs" / "index.rst").write_text("Index\n=====\n\n.. toctree::\n\n   lessons/one\n")
        (lessons / "dot.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
        (lessons / "one.rst").write_text(lesson, encoding="utf-8")
        (work / "docs" / "course").mkdir()
        (work / "docs" / "course" / "course.toml").write_text(course, encoding="utf-8")
        sphinx.Sphinx(
            str(work / "docs"),
            None,
            str(work / "html"),
            str(work / "trees"),
            "html",
            {"extensions": ["handouts"], "html_theme": "basic", "html_math_renderer": "mathjax"},
            status=None,
            warning=None,
        ).build()
        return work / "html" / "lessons"

    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(ROOT / "docs")
        yield made


def words(page: Path) -> str:
    """Return the text of a page without its markup."""
    body = page.read_text(encoding="utf-8").partition("<body>")[2].partition("<script>")[0]
    return " ".join(re.sub(r"<[^>]*>", "", body).split())


def test_sheet_has_no_answers_and_solutions_have_all(build):
    made = build(LESSON)
    asked, solved = words(made / "one-exercises.html"), words(made / "one-solutions.html")
    for question in ("And twice that?", "1+1"):
        assert question in asked.replace("&#x0002B;", "+")
    for answer in ("Two", "Four", ">>>"):
        assert answer not in asked
    order = ["What is", "Two, of course.", "And twice", "Four, as a rule."]
    assert sorted(order, key=solved.index) == order


def test_handouts_are_self_contained(build):
    made = build(LESSON)
    for kind in ("exercises", "solutions"):
        text = (made / f"one-{kind}.html").read_text(encoding="utf-8")
        assert re.findall(r'(?:src|link [^>]*href)="(?!data:)', text) == []
        assert "<math " in text
    picture, *_ = re.findall(r"data:image/svg\+xml;base64,([^\"]+)", text)
    assert base64.b64decode(picture).startswith(b"<svg")


def test_formulas_become_mathml_with_brackets_that_fit(build):
    build(LESSON)
    made = importlib.import_module("handouts").mathml(r"\Big\{ \lambda \Big\}", "inline")
    assert made.startswith("<math ")
    assert "Big" not in made


@pytest.mark.parametrize(
    ("text", "markup"),
    [
        ("(-1)", '<mo form="prefix">&#x02212;'),
        ("x = -1", '<mo form="prefix">&#x02212;'),
        ("x - 1", "<mi>x</mi><mo>&#x02212;"),
        ("(x) - 1", "</mo><mo>&#x02212;"),
        ("1/2", '<mo lspace="0" rspace="0">&#x0002F;'),
        ("|x| y", '<mi>x</mi><mo lspace="0" rspace="0" stretchy="false">&#x0007C;'),
    ],
)
def test_signs_slashes_and_bars_have_the_space_of_tex(build, text, markup):
    build(LESSON)
    assert markup in importlib.import_module("handouts").mathml(text, "inline")


def test_the_page_of_the_lesson_links_sheets_and_folds_the_answers(build):
    made = build(LESSON)
    page = (made / "one.html").read_text(encoding="utf-8")
    linked = re.findall(r'href="(one-\w+\.html)"', page)
    assert sorted(linked) == ["one-exercises.html", "one-solutions.html"]
    assert all((made / name).is_file() for name in linked)
    assert page.count("<details") == page.count("</details>") == 2


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("**2.** Four, as a rule.", ""),
        ("2. *(computer)*", "And"),
        (r":math:`1 + 1`", r":math:`\nosuch`"),
    ],
)
def test_lesson_without_answer_ends_the_build(build, old, new):
    assert old in LESSON
    with pytest.raises(Exception, match=r"answers|latex2mathml"):
        build(LESSON.replace(old, new))


HOMEWORK = """
course = "A course"
[[homework]]
name = "sheet"
title = "A sheet"
due = "2 May"
exercises = [["one", 2, 3], ["one", 1, 1]]
"""


def test_homework_has_exercises_points_and_a_due_date(build):
    made = build(LESSON.replace(".. figure:: dot.svg\n   :alt: a dot", "A quotation:"), HOMEWORK)
    pages = made.parent / "course"
    text = words(pages / "sheet-exercises.html")
    order = ["A course", "due 2 May", "A sheet", "Exercise 1 (____ of 3 points)", "And twice that?"]
    order += ["Exercise 2 (____ of 1 point)", "What is"]
    assert sorted(order, key=text.index) == order
    assert "Four, as a rule." in words(pages / "sheet-solutions.html")
    asked, solved = (
        (pages / f"sheet-{kind}.tex").read_text("utf-8") for kind in ("exercises", "solutions")
    )
    parts = ("due 2 May, 4 points", "Exercise 1 (3 points; lesson 1, exercise 2)", "$1 + 1$")
    for part in parts:
        assert part in asked
        assert part in solved
    assert ">>> 1 + 1\n2\n" in solved
    assert "Two" not in asked


@pytest.mark.parametrize(
    ("old", "new", "match"),
    [('["one", 1, 1]', '["one", 3, 1]', "one has no exercise 3"), ("x", "x", "takes no picture")],
)
def test_homework_that_is_not_there_ends_the_build(build, old, new, match):
    with pytest.raises(Exception, match=match):
        build(LESSON, HOMEWORK.replace(old, new))


def test_homework_is_compiled(latex, build):
    made = build(LESSON.replace(".. figure:: dot.svg\n   :alt: a dot", "A quotation:"), HOMEWORK)
    for kind in ("exercises", "solutions"):
        assert page_count(compiled(made.parent / "course" / f"sheet-{kind}.tex")) == 1


@pytest.fixture
def media(browser: Browser) -> Iterator[Callable[[str, str], None]]:
    """Show pages on a medium in a colour scheme."""

    def show(medium: str, scheme: str) -> None:
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        emulated = {"media": medium, "features": features}
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", emulated)

    yield show
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {})


@pytest.mark.parametrize(
    ("medium", "scheme", "theme"),
    [("screen", "light", "light"), ("screen", "dark", "dark"), ("print", "dark", "light")],
)
def test_handouts_are_dark_on_dark_screens_alone(
    build, talks, browser, media, medium, scheme, theme
):
    media(medium, scheme)
    paper = {"light": "rgb(255, 255, 255)", "dark": "rgb(20, 20, 20)"}
    browser.open(build(LESSON) / "one-solutions.html")
    assert (
        browser.run("return getComputedStyle(document.documentElement).backgroundColor")
        == (paper[theme])
    )
    assert browser.run(
        "return [...document.images].filter((i) => i.offsetParent).map((i) => i.className)"
    ) == [f"only-{theme}"]
    browser.open(talks / "course" / f"{LECTURE}-slides.html")
    slide = "return getComputedStyle(document.querySelector('.slide')).backgroundColor"
    assert browser.run(slide) == paper[theme]


def test_sheets_are_printed(build, browser: Browser):
    made = build(LESSON)
    importlib.import_module("handouts.pdf").main(made.parent)
    assert sorted(page.stem for page in made.glob("*.pdf")) == ["one-exercises", "one-solutions"]


TALKS = sorted((ROOT / "docs" / "slides").glob("*.toml"))
LECTURE = next(path.stem for path in TALKS if path.stem.startswith("lecture-"))


def test_each_lesson_has_slides():
    lessons = {path.stem for path in (ROOT / "docs" / "lessons").glob("*.rst")}
    assert lessons == {path.stem for path in TALKS if not path.stem.startswith("lecture-")}


@pytest.fixture(scope="module")
def talks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write all slides, with an empty picture for each figure; return the site."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(ROOT / "docs")
        handouts = importlib.import_module("handouts")
        app = SimpleNamespace(srcdir=ROOT / "docs", outdir=tmp_path_factory.mktemp("talks"))
        handouts.write_slides(
            app,
            lambda name, alt: f'<img alt="{alt}" title="{name}">',
            handouts.mathml,
            handouts._PAGES.get_template("slides.html"),
            (ROOT / "docs" / "handouts" / "slides.js").read_text(encoding="utf-8"),
        )
    return Path(app.outdir)


@pytest.mark.parametrize("source", TALKS, ids=lambda path: path.stem)
def test_figures_of_slides_are_drawn_by_commands_or_scripts(source, talks):
    talk = importlib.import_module("handouts.slides").talks(ROOT / "docs")
    slides = next(made["slides"] for name, made in talk if name == source.stem)
    assert len(slides) >= 6
    scripts = [p.read_text(encoding="utf-8") for p in (ROOT / "docs" / "figures").glob("*.py")]
    for slide in slides:
        name = slide["figure"]
        if "command" in slide:
            program, verb, item, *options = slide["command"]
            assert (program, verb) in {("arrangement", "draw"), ("equilibrium", "draw")}
            assert not item.startswith("-")
            size = options[options.index("--font-size") + 1]
            assert int(size.removesuffix("pt")) >= 16
        else:
            drawn = (f"{name}.svg", f"def {name.split('-', 2)[-1]}()")
            assert any(part in text for text in scripts for part in drawn), name


@pytest.mark.parametrize("source", TALKS, ids=lambda path: path.stem)
def test_labs_and_pages_of_slides_are_linked(source, talks):
    lecture = source.stem.startswith("lecture-")
    page = talks / ("course" if lecture else "lessons") / f"{source.stem}-slides.html"
    text = page.read_text(encoding="utf-8")
    back = {name.removesuffix(".html") for name in re.findall(r'href="([\w-]+\.html)"', text)}
    assert back == {"two-lectures" if lecture else source.stem}
    for lab in re.findall(r'href="\.\./pages/([\w-]+)\.html#', text):
        assert lab in {"gallery-lab", "gallery-arrangement-lab"}


@pytest.mark.parametrize("wrong", [{"claim": "word " * 31}, {"steps": None}])
def test_slide_without_its_parts_or_with_too_many_words_ends_the_build(wrong, talks):
    good = {"claim": "A", "figure": "f", "alt": "a", "steps": ["b $x + y$"], "say": "s", "ask": "?"}
    talk = importlib.import_module("handouts.slides")
    assert talk.checked(good, "one") == good
    with pytest.raises(ValueError, match=r"at most 30|lacks"):
        talk.checked({k: v for k, v in {**good, **wrong}.items() if v}, "one")


def test_steps_of_a_slide_appear_one_by_one(talks, browser: Browser):
    browser.open(talks / "course" / f"{LECTURE}-slides.html")
    browser.settled()
    browser.key("ArrowRight")
    hidden = [browser.count(".now .later")]
    for _ in range(3):
        browser.key("ArrowRight")
        hidden.append(browser.count(".now .later"))
    assert hidden == [3, 2, 1, 0]
    browser.key("ArrowRight")
    browser.key("ArrowLeft")
    assert browser.count(".now .later") == 0
    browser.key("n")
    assert browser.count(".now .notes dt") == 2
    assert browser.messages() == []


def test_keys_turn_the_slides(talks, browser: Browser):
    browser.open(talks / "course" / f"{LECTURE}-slides.html")
    browser.settled()
    here = "return [...document.querySelectorAll('.slide')].findIndex((s) => s.matches('.now'))"
    last = browser.count(".slide") - 1
    for key, at in (("ArrowRight", 1), ("Home", 0), ("ArrowLeft", 0), ("End", last)):
        browser.key(key)
        assert browser.run(here) == at
    browser.run("location.hash = '#2'")
    browser.settled()
    assert browser.run(here) == 1
    assert browser.messages() == []


@pytest.mark.parametrize("source", TALKS, ids=lambda path: path.stem)
def test_slides_fit_on_the_screen(source, talks, browser: Browser):
    folder = "course" if source.stem.startswith("lecture-") else "lessons"
    browser.open(talks / folder / f"{source.stem}-slides.html", 1280, 720)
    browser.settled()
    over = browser.run(
        "return [...document.querySelectorAll('.slide')].map((slide) => {"
        "slide.style.display = 'block'; const body = slide.querySelector('.body');"
        "const over = body ? Math.max(body.scrollHeight - body.clientHeight,"
        " body.scrollWidth - body.clientWidth) : 0;"
        "slide.style.display = ''; return over; })"
    )
    assert max(over) <= 1, over
    assert browser.messages() == []
