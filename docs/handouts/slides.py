"""Slides: of each file slides/NAME.toml the page NAME-slides.html of a lecture or of a lesson.

A slide has one claim as its title, one figure, steps that appear one by one, and notes for the
lecturer. The title slide, and the sheets, take course, lecturer and date from course/course.toml.
The figure is a command that draws it, or the name of a picture that another script makes.
"""

import re
import shlex
import tomllib
from html import escape
from pathlib import Path

#: Words that a slide may have, its title included.
MOST_WORDS = 30
_FIELDS = {"claim", "figure", "alt", "steps", "say", "ask"}
#: How the commands draw, unless they say otherwise: letters of 20 pt on a slide of 339 mm.
_LOOK = {"--legend": "none", "--font-size": "20pt"}
_WIDTH, _WIDE = "174", "300"


def course(source):
    """Return what the small file says of the course."""
    path = Path(source) / "course" / "course.toml"
    return tomllib.loads(path.read_text("utf-8")) if path.exists() else {}


def talks(source):
    """Yield the name and the content of each file of slides, their figures as names of pictures."""
    for path in sorted((Path(source) / "slides").glob("*.toml")):
        talk = tomllib.loads(path.read_text("utf-8"))
        for number, slide in enumerate(talk["slides"], 1):
            checked(slide, path.name)
            if " " in slide["figure"]:
                program, *words = shlex.split(slide["figure"])
                look = {**_LOOK, "--width": _WIDE if slide.get("wide") else _WIDTH}
                left = [part for pair in look.items() if pair[0] not in words for part in pair]
                slide["command"] = (program, "draw", *words, *left)
                slide["figure"] = f"slides-{path.stem}-{number}"
        yield path.stem, talk


def checked(slide, name):
    """Return a slide of a file, or end the build with what it lacks."""
    if not slide.keys() >= _FIELDS:
        raise ValueError(f"{name}: {slide} lacks {sorted(_FIELDS - slide.keys())}")
    words = re.sub(r"\$[^$]*\$", "x", " ".join([slide["claim"], *slide["steps"]])).split()
    if len(words) > MOST_WORDS:
        raise ValueError(f"{name}: {slide['claim']!r} has {len(words)} words; at most {MOST_WORDS}")
    return slide


def write_slides(app, picture, formula, template, script):
    """Write the slides of all lectures and lessons.

    Args:
        picture: returns an image as HTML, of a name and its description.
        formula: returns TeX as MathML.
        template: of a page.
    """

    def text(source):
        parts = re.split(r"\$([^$]*)\$", source)
        parts[::2] = map(escape, parts[::2])
        parts[1::2] = [formula(part, "inline") for part in parts[1::2]]
        return "".join(parts)

    about = course(app.srcdir)
    for name, talk in talks(app.srcdir):
        made = [
            {
                **{part: text(slide[part]) for part in ("claim", "say", "ask")},
                "steps": list(map(text, slide["steps"])),
                "figure": picture(slide["figure"], slide["alt"]),
                "wide": slide.get("wide", False),
                "lab": slide.get("lab", ""),
            }
            for slide in talk["slides"]
        ]
        page = template.render(
            title=talk["title"],
            lines=[about.get(part, "") for part in ("course", "lecturer", "date")],
            course=about.get("course", ""),
            page=talk["page"],
            slides=made,
            script=script,
        )
        folder = "course" if name.startswith("lecture-") else "lessons"
        target = Path(app.outdir) / folder / f"{name}-slides.html"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(page, "utf-8")
