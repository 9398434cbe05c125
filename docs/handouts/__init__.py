"""An exercise sheet and solutions of each lesson, made from the lesson by Sphinx, and its slides.

Homework of several lessons, with points and a due date, is listed in course/course.toml.

Beside the page NAME.html of a lesson stand NAME-exercises.html, NAME-solutions.html and, where
there is a file slides/NAME.toml, NAME-slides.html. Each is one file with its pictures and MathML in
it, which needs no network. A lesson has a section Exercises with one numbered list, and a section
Answers in which each answer starts with its number in bold; on the page of the lesson the answers
are folded.
"""

import base64
import copy
import mimetypes
import re
from html import escape
from pathlib import Path
from urllib.parse import unquote

from docutils import nodes
from jinja2 import Environment, FileSystemLoader, StrictUndefined
from latex2mathml.converter import convert
from pagetools.dark_pictures import darken
from sphinx.highlighting import PygmentsBridge

from .homework import homework, tex
from .slides import course, write_slides

KINDS = {"slides": "Slides", "exercises": "Exercise sheet", "solutions": "Solutions"}
#: The dark style of code of the theme.
_DARK_CODE = "native"
#: Of each lesson that was read, its exercises by number.
_EXERCISES = {}
#: A sign after an operator that closes no bracket: without a form, a browser sets it as a binary
#: operator, with space on both sides.
_SIGN = re.compile(
    r"(<mo[^>]*>(?!&#x00029;|\]|&#x0007[CD];)[^<]*</mo>)<mo>(?=&#x(?:02212|02213|000B1);)"
)
#: A slash, or a bar of an absolute value: TeX puts no space around them.
_TIGHT = re.compile("<mo(?=[^>]*>&#x000(?:2F|7C);</mo>)")
_PAGES = Environment(
    loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined
)


def title(section):
    """Return the title of a section."""
    return section.next_node(nodes.title).astext()


def sections(tree):
    """Return the sections of a lesson by their titles."""
    whole = next(tree.findall(nodes.section))
    return {title(one): one for one in whole.children if isinstance(one, nodes.section)}


def answers(section):
    """Return the parts of each answer by its number; the first part has the number no more."""
    found = {}
    for part in section.children[1:]:
        if part.children and isinstance(number := part.children[0], nodes.strong):
            part.remove(number)
            found[int(number.astext().rstrip("."))] = parts = []
        parts.append(part)
    return found


def exercises(section):
    """Return the parts of each exercise by its number."""
    lists = section.findall(nodes.enumerated_list)
    items = [item for one in lists if one.parent is section for item in one.children]
    return {number: item.children for number, item in enumerate(items, 1)}


def fold_answers(section):
    """Fold each answer, and unfold them all for the printer."""
    folded = []
    for number, parts in answers(section).items():
        start = f'<details class="answer"><summary>Answer {number}</summary>'
        folded.append(nodes.raw("", start, format="html"))
        folded += [*parts, nodes.raw("", "</details>", format="html")]
    section[1:] = folded


def mathml(text, display):
    """Return a formula as MathML; brackets in it have the size that they need."""
    made = convert(re.sub(r"\\[bB]igg?[lr]?(?![a-zA-Z])", "", text), display=display)
    if "\\" in made:
        raise ValueError(f"latex2mathml does not know a part of {text}")
    made = _SIGN.sub(r'\1<mo form="prefix">', made)
    return _TIGHT.sub('<mo lspace="0" rspace="0"', made)


def inline(tree, source):
    """Put formulas as MathML and pictures as data into a tree; the width of a picture stays."""
    for node in [*tree.findall(nodes.math), *tree.findall(nodes.math_block)]:
        display = "block" if isinstance(node, nodes.math_block) else "inline"
        text = node.astext()
        made = nodes.raw("", mathml(text, display), format="html", formula=text)
        wrapped = "math-wrapper" in node.parent.get("classes", ())  # by the theme
        (node.parent if wrapped else node).replace_self(made)
    for node in list(tree.findall(nodes.image)):
        shown = f'style="width: {node["width"]}"' if "width" in node else ""
        text = picture(source / unquote(node["uri"]), node["alt"], shown)
        node.replace_self(nodes.raw("", text, format="html"))


def picture(path, alt, shown=""):
    """Return an image with its data as HTML; of an SVG a second one, for dark screens."""
    kind, _ = mimetypes.guess_type(path.name)
    data = path.read_bytes()
    themes = {"": data}
    if path.suffix == ".svg":
        themes = {"only-light": data, "only-dark": darken(data.decode()).encode()}
    return "".join(
        f'<img class="{theme}" src="data:{kind};base64,{base64.b64encode(image).decode()}"'
        f' alt="{escape(alt)}" {shown}>'
        for theme, image in themes.items()
    )


def write_sheets(app, name, heading, chosen, **about):
    """Write a sheet and its solutions.

    Args:
        name: of the pages, without -exercises.html and -solutions.html.
        heading: of both.
        chosen: exercises, each with its "number", its "points", and its "question" and "answer" as
            lists of nodes.
        about: what the template shows besides, such as the day on which the sheet is due.
    """

    def html(parts):
        holder = nodes.container("", *(part.deepcopy() for part in parts))
        inline(holder, Path(app.srcdir))
        return app.builder.render_partial(holder)["fragment"]

    dark = PygmentsBridge("html", _DARK_CODE).get_stylesheet()
    style = app.builder.highlighter.get_stylesheet()
    style += f"\n@media screen and (prefers-color-scheme: dark) {{\n{dark}\n}}"
    sheets = {"course": "", "date": "", "due": "", **course(app.srcdir), **about}
    asked = [{**one, "question": html(one["question"]), "answer": ""} for one in chosen]
    solved = [
        {**one, "answer": html(full["answer"])} for one, full in zip(asked, chosen, strict=True)
    ]
    for kind, shown in (("exercises", asked), ("solutions", solved)):
        path = Path(app.outdir) / f"{name}-{kind}.html"
        path.parent.mkdir(parents=True, exist_ok=True)
        page = _PAGES.get_template("sheet.html")
        given = {"title": heading, "style": style, "kind": KINDS[kind], "exercises": shown}
        path.write_text(page.render(sheets | given), "utf-8")


def exercises_of(tree, name, points):
    """Return the exercises of a lesson, with their answers, by number."""
    found = sections(tree)
    asked, answered = exercises(found["Exercises"]), answers(found["Answers"])
    if list(asked) != list(answered):
        raise ValueError(f"{name}: exercises {list(asked)}, but answers {list(answered)}")
    lesson, _, _ = title(next(tree.findall(nodes.section))).partition(" ")
    about = {"lesson": lesson, "points": points}
    return {
        number: {**about, "number": number, "question": parts, "answer": answered[number]}
        for number, parts in asked.items()
    }


def hand_out(app, tree, name):
    """Write what belongs to a lesson, link it on the page of the lesson, and fold the answers."""
    if app.builder.format != "html" or not name.startswith("lessons/"):
        return
    own = copy.deepcopy(tree)
    found = exercises_of(own, name, course(app.srcdir).get("points", 0))
    number, _, rest = title(next(own.findall(nodes.section))).partition(" ")
    write_sheets(app, name, f"Lesson {number}: {rest}", found.values())
    _EXERCISES[name.rpartition("/")[2]] = found
    stem = name.rpartition("/")[2]
    kinds = dict(KINDS)
    if not (Path(app.srcdir) / "slides" / f"{stem}.toml").exists():
        del kinds["slides"]
    links = " · ".join(f'<a href="{stem}-{kind}.html">{text}</a>' for kind, text in kinds.items())
    whole = next(tree.findall(nodes.section))
    whole.insert(1, nodes.raw("", f'<p class="handouts">{links}</p>', format="html"))
    fold_answers(sections(tree)["Answers"])


def write_homework(app, error):
    """Write each sheet of homework, its solutions, and both as TeX."""
    # Where no page of a lesson was written, the sheets are there already.
    if app.builder.format != "html" or error is not None or not _EXERCISES:
        return
    for sheet in course(app.srcdir).get("homework", ()):
        for lesson in {lesson for lesson, *_ in sheet["exercises"]} - _EXERCISES.keys():
            app.env.get_and_resolve_doctree(f"lessons/{lesson}", app.builder)
        chosen = homework(sheet, _EXERCISES)
        name = f"course/{sheet['name']}"
        write_sheets(app, name, sheet["title"], chosen, due=sheet["due"])
        for kind in ("exercises", "solutions"):
            text = tex(sheet, course(app.srcdir), chosen, kind == "solutions")
            Path(app.outdir, f"{name}-{kind}.tex").write_text(text, "utf-8")


def write_all_slides(app, error):
    """Write the slides of lectures and lessons, when the figures are there."""
    if app.builder.format == "html" and error is None:
        figures = Path(app.srcdir) / "_generated"
        write_slides(
            app,
            lambda name, alt: picture(figures / f"{name}.svg", alt),
            mathml,
            _PAGES.get_template("slides.html"),
            (Path(__file__).parent / "slides.js").read_text("utf-8"),
        )


_UNFOLD = """addEventListener("beforeprint", () => {
  for (const answer of document.querySelectorAll("details.answer")) answer.open = true;
});"""


def setup(app):
    app.add_js_file(None, body=_UNFOLD)
    app.connect("doctree-resolved", hand_out)
    app.connect("build-finished", write_all_slides)
    app.connect("build-finished", write_homework)
