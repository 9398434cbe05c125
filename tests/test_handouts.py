"""Slides, exercise sheets and solutions are made of a lesson, one file each."""

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

sphinx = pytest.importorskip("sphinx.application")

FILLED = "\n\n".join(
    f"**Word {number}.** {'A definition stands on slides as it is. ' * 4}" for number in range(12)
)
LESSON = rf"""
1 A lesson
==========

What it is about, and why.

Definition
----------

{FILLED}

A formula ends this sentence:

.. math:: Z = \Big\{{ \sum_i \lambda_i n_i \Big\}} .

The first sentence stands on the slide. The second is only said.

*Proof.* It has two sentences. Both stand there. ∎

Here a **word** is defined. Its second sentence stands there too.

*One way.* It is a case. No end mark follows it.

**Theorem.** *It holds.*

*One way.* It is half a proof. The other half comes.

The other way is last. It ends. ∎

.. figure:: dot.svg
   :alt: a dot

   A picture of <one> dot.

.. |dot| image:: dot.svg
   :width: 48%
   :alt: the dot again

|dot| |dot|

What comes after two pictures stands apart from them.

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
"""


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], Path]]:
    """Build the pages of one lesson, each text once; return their folder."""

    @functools.cache
    def made(lesson: str) -> Path:
        work = tmp_path_factory.mktemp("handouts")
        lessons = work / "docs" / "lessons"
        lessons.mkdir(parents=True)
        (work / "docs" / "index.rst").write_text("Index\n=====\n\n.. toctree::\n\n   lessons/one\n")
        (lessons / "dot.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>')
        (lessons / "one.rst").write_text(lesson, encoding="utf-8")
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
    for kind in ("slides", "exercises", "solutions"):
        text = (made / f"one-{kind}.html").read_text(encoding="utf-8")
        assert re.findall(r'(?:src|link [^>]*href)="(?!data:|\.\./pages/)', text) == []
        assert "<math " in text
        assert "\\Big" not in text
    picture, *_ = re.findall(
        r"data:image/svg\+xml;base64,([^\"]+)", (made / "one-slides.html").read_text()
    )
    assert base64.b64decode(picture).startswith(b"<svg")


def test_slides_have_proofs_and_lab_but_no_answers(build):
    text = (build(LESSON) / "one-slides.html").read_text(encoding="utf-8")
    shown = re.sub(r"(?s)<template>.*?</template>", "", text)
    assert "The first sentence stands" in shown
    assert "The second is only said." in text
    assert "The second is only said." not in shown
    for whole in ("Both stand there.", "stands there too.", "The other half comes.", "It ends."):
        assert whole in shown
    assert "No end mark follows it." not in shown
    (lab,) = (one for one in shown.split("<section") if "<iframe" in one)
    assert '<iframe src="../pages/gallery-lab.html#1%7C3"' in lab
    assert ">three lines</a> there." in lab
    assert "And twice that?" in shown
    assert "Two, of course." not in text


def test_pictures_beside_each_other_are_a_block_of_their_own(build):
    text = (build(LESSON) / "one-slides.html").read_text(encoding="utf-8")
    (block,) = (one for one in text.split('<div class="block">') if "the dot again" in one)
    assert block.count("<img") == 2
    assert "stands apart" not in block
    assert "stands apart" in text


def test_the_page_of_the_lesson_links_them_and_folds_the_answers(build):
    made = build(LESSON)
    page = (made / "one.html").read_text(encoding="utf-8")
    linked = re.findall(r'href="(one-\w+\.html)"', page)
    assert sorted(linked) == ["one-exercises.html", "one-slides.html", "one-solutions.html"]
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


def test_no_slide_is_too_long_and_each_is_a_printed_page(build, browser: Browser):
    made = build(LESSON)
    browser.open(made / "one-slides.html")
    browser.settled()
    slides = browser.count(".slide")
    assert slides > 5  # one for each section and the lab: the definitions do not fit on one
    assert browser.count(".slide.now") == 1
    over = browser.run(
        "return [...document.querySelectorAll('.slide')].map((slide) => {"
        "slide.style.display = 'block'; const body = slide.querySelector('.body');"
        "const over = body.scrollHeight - body.clientHeight;"
        "slide.style.display = ''; return over; })"
    )
    assert max(over) <= 1, over
    importlib.import_module("handouts.pdf").main(made.parent)
    assert sorted(page.stem for page in made.glob("*.pdf")) == [
        *("one-exercises", "one-slides", "one-solutions"),
    ]
    pdf = (made / "one-slides.pdf").read_bytes()
    assert len(re.findall(rb"/Type\s*/Page\b", pdf)) == slides - browser.count(".slide.lab")
    assert {
        tuple(map(float, box.split())) for box in re.findall(rb"/MediaBox\s*\[([^\]]+)", pdf)
    } == {(0, 0, 960, 540)}


def test_keys_turn_the_slides_and_show_the_notes(build, browser: Browser):
    browser.open(build(LESSON) / "one-slides.html")
    browser.settled()
    here = "return [...document.querySelectorAll('.slide')].findIndex((s) => s.matches('.now'))"
    last = browser.count(".slide") - 1
    for key, at in (
        ("ArrowRight", 1),
        ("ArrowLeft", 0),
        ("ArrowLeft", 0),
        ("End", last),
        ("ArrowRight", last),
    ):
        browser.key(key)
        assert browser.run(here) == at
    browser.run("location.hash = '#2'")
    browser.settled()
    assert browser.run(here) == 1
    browser.key("n")
    noted = [text for text in browser.texts(".notes") if "only said" in text]
    assert len(noted) == 1
    assert browser.messages() == []


TALKS = sorted((ROOT / "docs" / "course").glob("lecture-*.toml"))


@pytest.fixture(scope="module")
def talks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write the slides of the lectures, with an empty picture for each figure."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(ROOT / "docs")
        handouts = importlib.import_module("handouts")
        app = SimpleNamespace(srcdir=ROOT / "docs", outdir=tmp_path_factory.mktemp("talks"))
        handouts.write_talks(
            app,
            lambda name, alt: f'<img alt="{alt}" title="{name}">',
            handouts.mathml,
            handouts._PAGES.get_template("talk.html"),
            handouts._script(),
        )
    return Path(app.outdir) / "course"


@pytest.mark.parametrize("source", TALKS, ids=lambda path: path.stem)
def test_figures_of_a_lecture_are_made_by_its_scripts(source, talks):
    text = (talks / f"{source.stem}-slides.html").read_text(encoding="utf-8")
    named = re.findall(r'title="(lecture-\d)-([\w-]+)"', text)
    assert len(named) >= 8
    for script, name in named:
        code = (ROOT / "docs" / "figures" / f"{script}.py").read_text(encoding="utf-8")
        assert f"{script}-{name}.svg" in code or f"def {name}()" in code


@pytest.mark.parametrize("wrong", [{"claim": "word " * 31}, {"steps": None}])
def test_slide_without_its_parts_or_with_too_many_words_ends_the_build(wrong, talks):
    good = {"claim": "A", "figure": "f", "alt": "a", "steps": ["b $x + y$"], "say": "s", "ask": "?"}
    talk = importlib.import_module("handouts.talks")
    assert talk.checked(good, "one") == good
    with pytest.raises(ValueError, match=r"at most 30|lacks"):
        talk.checked({k: v for k, v in {**good, **wrong}.items() if v}, "one")


def test_steps_of_a_slide_appear_one_by_one(talks, browser: Browser):
    browser.open(talks / f"{TALKS[0].stem}-slides.html")
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
