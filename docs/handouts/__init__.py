"""An exercise sheet and solutions of each lesson, made from the lesson by Sphinx, and its slides.

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

from .slides import course, write_slides

KINDS = {"slides": "Slides", "exercises": "Exercise sheet", "solutions": "Solutions"}
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
    return made


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
    """Return an image with its data as HTML."""
    kind, _ = mimetypes.guess_type(path.name)
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img src="data:{kind};base64,{data}" alt="{escape(alt)}" {shown}>'


def write(app, tree, name):
    """Write the sheets of a lesson beside its page."""

    def html(parts):
        holder = nodes.container("", *(part.deepcopy() for part in parts))
        return app.builder.render_partial(holder)["fragment"]

    inline(tree, Path(app.srcdir))
    found = sections(tree)
    asked, answered = exercises(found["Exercises"]), answers(found.pop("Answers"))
    if list(asked) != list(answered):
        raise ValueError(f"{name}: exercises {list(asked)}, but answers {list(answered)}")
    lesson = title(next(tree.findall(nodes.section)))
    given = {
        "title": lesson,
        "style": app.builder.highlighter.get_stylesheet(),
    }
    sheets = {"course": "", "date": "", "points": 0, **course(app.srcdir)}
    sheet = [{"number": n, "question": html(parts), "answer": ""} for n, parts in asked.items()]
    solved = [{**one, "answer": html(answered[one["number"]])} for one in sheet]
    page = _PAGES.get_template("sheet.html")
    for kind, shown in (("exercises", sheet), ("solutions", solved)):
        path = Path(app.outdir) / f"{name}-{kind}.html"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(page.render(sheets | given, exercises=shown, kind=KINDS[kind]), "utf-8")


def hand_out(app, tree, name):
    """Write what belongs to a lesson, link it on the page of the lesson, and fold the answers."""
    if app.builder.format != "html" or not name.startswith("lessons/"):
        return
    write(app, copy.deepcopy(tree), name)
    stem = name.rpartition("/")[2]
    kinds = dict(KINDS)
    if not (Path(app.srcdir) / "slides" / f"{stem}.toml").exists():
        del kinds["slides"]
    links = " · ".join(f'<a href="{stem}-{kind}.html">{text}</a>' for kind, text in kinds.items())
    whole = next(tree.findall(nodes.section))
    whole.insert(1, nodes.raw("", f'<p class="handouts">{links}</p>', format="html"))
    fold_answers(sections(tree)["Answers"])


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
