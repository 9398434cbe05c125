"""Slides of the lectures: of each file course/NAME.toml the page course/NAME-slides.html.

A slide has one claim as its title, one figure, steps that appear one by one, and notes for the
lecturer. The title slide, and the sheets, take course, lecturer and date from course/course.toml.
"""

import re
import tomllib
from html import escape
from pathlib import Path

#: Words that a slide may have, its title included.
MOST_WORDS = 30
_FIELDS = {"claim", "figure", "alt", "steps", "say", "ask"}


def course(source):
    """Return what the small file says of the course."""
    path = Path(source) / "course" / "course.toml"
    return tomllib.loads(path.read_text("utf-8")) if path.exists() else {}


def checked(slide, name):
    """Return a slide of a file, or end the build with what it lacks."""
    if not slide.keys() >= _FIELDS:
        raise ValueError(f"{name}: {slide} lacks {sorted(_FIELDS - slide.keys())}")
    words = re.sub(r"\$[^$]*\$", "x", " ".join([slide["claim"], *slide["steps"]])).split()
    if len(words) > MOST_WORDS:
        raise ValueError(f"{name}: {slide['claim']!r} has {len(words)} words; at most {MOST_WORDS}")
    return slide


def write_talks(app, picture, formula, template, script):
    """Write the slides of all lectures.

    Args:
        picture: returns an image as HTML, of a path and its description.
        formula: returns TeX as MathML.
        template: of a page.
    """

    def text(source):
        parts = re.split(r"\$([^$]*)\$", source)
        parts[::2] = map(escape, parts[::2])
        parts[1::2] = [formula(part, "inline") for part in parts[1::2]]
        return "".join(parts)

    about = course(app.srcdir)
    for path in sorted(Path(app.srcdir).glob("course/lecture-*.toml")):
        talk = tomllib.loads(path.read_text("utf-8"))
        slides = [checked(slide, path.name) for slide in talk["slides"]]
        made = [
            {
                **{name: text(slide[name]) for name in ("claim", "say", "ask")},
                "steps": list(map(text, slide["steps"])),
                "figure": picture(slide["figure"], slide["alt"]),
                "wide": slide.get("wide", False),
            }
            for slide in slides
        ]
        page = template.render(
            title=talk["title"],
            lines=[about.get(name, "") for name in ("course", "lecturer", "date")],
            course=about.get("course", ""),
            page=talk["page"],
            slides=made,
            script=script,
        )
        target = Path(app.outdir) / "course" / f"{path.stem}-slides.html"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(page, "utf-8")
