"""HTML files that hold all they need: they ask for nothing from outside and need no server.

On the page of a `SolidPage` convex pieces in space turn, in an exact order of painting for every
direction. The pieces hang on a tree of planes (see `depth_tree`): what is beyond a plane is painted
first.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from arrangement.drawing.scene import Floats
from arrangement.drawing.solids.depth_tree import Node
from arrangement.drawing.solids.sight import unit
from arrangement.drawing.solids.surface import Patch, float_points

#: A package and the name of a file in its folder ``templates``, or in a folder there.
Template: TypeAlias = tuple[str, str]

_OWN = "arrangement.drawing"
BASE_STYLE: Template = (_OWN, "base.css")
#: A banner, and cards with a tone for the strength of an answer: pages of verdicts.
CARD_STYLE: Template = (_OWN, "cards.css")
BASE_SCRIPT: Template = (_OWN, "base.js")
#: Cuts polygons.
POLYGON: Template = (_OWN, "polygon.js")

_HEAD = """<header>
  <h1 id="title"></h1>
  <p id="summary"></p>
  <div class="row screen">
{}
  </div>
</header>
"""
_BUTTONS = {
    "spin": ' aria-pressed="false">turn slowly',
    "home": ">first view",
    "theme": ">colours: auto",
    "print": ">print",
}


def own(name: str) -> Template:
    """Return a template of this package."""
    return _OWN, name


def one_page(
    title: str,
    body: Template,
    styles: Iterable[Template],
    scripts: Iterable[Template],
    data: Mapping[str, Any],
    buttons: Iterable[str] = (),
    worker: Iterable[Template] = (),
    parts: Iterable[Template] = (),
) -> str:
    """Return a complete HTML page.

    The page allows the browser to run its own scripts and to load nothing else. Texts from files
    reach the page as JSON only, in which nothing can end the element that holds it.

    Args:
        title: of the window.
        body, styles, scripts: templates; the scripts run as one, in strict mode.
        data: what the script finds, as JSON, in the element ``data``.
        buttons: of a head above the body, keys of `_BUTTONS`; without any the body has its own.
        worker: templates; a script of their own, ``decides``, before the other, which a worker can
            run as well.
        parts: templates; ``<!-- NAME -->`` in the body stands for ``NAME.html``.
    """
    whole = _text(body)
    for part in parts:
        whole = whole.replace(f"<!-- {part[1].removesuffix('.html')} -->", _text(part).rstrip())
    listed = "\n".join(f'    <button id="{name}"{_BUTTONS[name]}</button>' for name in buttons)
    return html_document(
        title,
        f"{_HEAD.format(listed) if listed else ''}{whole}\n"
        "<noscript><p>This page needs JavaScript; all of it is in this file.</p></noscript>\n"
        f'<script type="application/json" id="data">{json_for_html(data)}</script>',
        styles,
        scripts,
        worker="".join(map(_text, worker)),
    )


def html_document(
    title: str,
    body: str,
    styles: Iterable[Template],
    scripts: Iterable[Template],
    policy: str = "",
    worker: str = "",
) -> str:
    """Return a complete HTML page with a body that is HTML already.

    Args:
        title: of the window.
        body: in which every text is escaped.
        styles, scripts: templates; the scripts run as one, in strict mode, after the body.
        policy: what the page may do besides.
        worker: a script that a worker can run as well, as for `one_page`.
    """
    style = "".join(map(_text, styles))
    script = '"use strict";\n(() => {\n' + "".join(map(_text, scripts)) + "})();\n"
    allowed = f"'{_hash(script)}'"
    if worker:
        worker = f'"use strict";\n{worker}'
        allowed += f" '{_hash(worker)}'; worker-src blob:"
        body += f'\n<script id="decides">{worker}</script>'
    policy = (
        f"default-src 'none'; img-src data:; style-src '{_hash(style)}'; "
        f"script-src {allowed}; base-uri 'none'; form-action 'none'{policy}"
    )
    return "\n".join(
        [
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            '<link rel="icon" href="data:,">',
            f"<title>{html.escape(title)}</title>",
            f"<style>{style}</style>\n</head>\n<body>\n{body}",
            f"<script>{script}</script>\n</body>\n</html>\n",
        ]
    )


def json_for_html(data: Mapping[str, Any]) -> str:
    """Return JSON that may stand in an HTML element: ASCII, without ``<``, ``>`` and ``&``."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return text


def floats(array: Any, digits: int = 5) -> Any:
    """Return numbers as nested lists of floats with so many digits, and no negative zero."""
    return (np.round(np.asarray(array, dtype=float), digits) + 0.0).tolist()


def place(template: Template) -> Path:
    """Return the file of a template."""
    package, name = template
    folder = Path(str(files(package).joinpath("templates")))
    (path,) = folder.rglob(name)
    return path


def _text(template: Template) -> str:
    return place(template).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return f"sha256-{base64.b64encode(digest).decode('ascii')}"


SOLID_SCRIPTS = (BASE_SCRIPT, *map(own, ("dual.js", "ball.js", "turning.js", "solid.js")))


@dataclass(frozen=True)
class PageFace:
    """A convex polygon, segment or point.

    Attributes:
        corners: (k, 3).
        fill: ``#rrggbb``, or ``#rrggbbaa`` to shine through.
        normal: outward; None for segments and points.
        edges: (e, 2, 3); the lines drawn.
        piece: the number of its description, or -1.
        middle: (3,) of the solid that it moves with, if it does.
        sheet: whether both sides are seen.
        faint: whether the lines are thin and grey.
        ink: of the lines, instead of black.
    """

    corners: Floats
    fill: str
    normal: Floats | None
    edges: Floats
    piece: int = -1
    middle: Floats | None = None
    sheet: bool = False
    faint: bool = False
    ink: str = ""


def page_face(patch: Patch, fill: str, piece: int, **style: Any) -> PageFace:
    """Return an exact piece as a face of a page."""
    edges = np.array([float_points(edge) for edge in patch.edges]).reshape(-1, 2, 3)
    normal = np.array(patch.row[:3], dtype=float) if any(patch.row) else None
    return PageFace(float_points(patch.corners), fill, normal, edges, piece, **style)


@dataclass
class SolidPage:
    """What a page shows.

    Attributes:
        title, summary, counts: texts.
        axes: (3, 3); the first view: right, up, towards the viewer.
        radius: of a ball around everything.
        tree: of faces; the first node is the root.
        pieces: name and facts of each piece.
        legend: colours with texts.
        frame: segments (k, 2, 3) behind everything.
        marks: texts at points, before everything.
        apart: how far solids stand apart at first, 1 for in place; 0 if they cannot.
    """

    title: str
    summary: str
    counts: str
    axes: Floats
    radius: float
    tree: Sequence[Node[PageFace]]
    pieces: list[tuple[str, list[tuple[str, str]]]]
    legend: list[tuple[str, str]]
    frame: Any = ()
    marks: Sequence[tuple[Any, str]] = ()
    apart: float = 0.0

    def text(self) -> str:
        """Return the page."""
        same = ("title", "summary", "counts", "legend", "apart")
        data = {key: getattr(self, key) for key in same} | {
            "axes": floats(self.axes),
            "radius": round(self.radius, 6),
            "nodes": [
                {"row": floats(node.row[:3]), "faces": list(map(_face, node.patches))}
                | {"front": node.front, "back": node.back}
                for node in self.tree
            ],
            "pieces": [{"name": name, "facts": facts} for name, facts in self.pieces],
            "frame": floats(self.frame),
            "marks": [{"at": floats(at), "text": text} for at, text in self.marks],
        }
        styles, tools = [BASE_STYLE, own("solid.css")], ["spin", "home", "theme", "print"]
        return one_page(self.title, own("solid.html"), styles, SOLID_SCRIPTS, data, tools)


def _face(face: PageFace) -> dict[str, Any]:
    data: dict[str, Any] = {
        "at": floats(face.corners),
        "fill": face.fill,
        "edges": floats(face.edges),
        "piece": face.piece if face.piece >= 0 else None,
    }
    if face.normal is not None and face.normal.any():
        data["normal"] = floats(unit(face.normal))
    if face.middle is not None:
        data["middle"] = floats(face.middle)
    return data | {
        key: getattr(face, key) for key in ("sheet", "faint", "ink") if getattr(face, key)
    }
