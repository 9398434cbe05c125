"""One HTML file that holds all it needs: it asks for nothing from outside and needs no server."""

from __future__ import annotations

import base64
import hashlib
import html
import json
from collections.abc import Iterable, Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

#: A package and the name of a file in its folder ``templates``, or in a folder there.
Template: TypeAlias = tuple[str, str]

_OWN = "arrangement.drawing.pages"
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
    return framed(
        title,
        f"{_HEAD.format(listed) if listed else ''}{whole}\n"
        "<noscript><p>This page needs JavaScript; all of it is in this file.</p></noscript>\n"
        f'<script type="application/json" id="data">{embedded(data)}</script>',
        styles,
        scripts,
        worker="".join(map(_text, worker)),
    )


def framed(
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


def embedded(data: Mapping[str, Any]) -> str:
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
    (found,) = folder.rglob(name)
    return found


def _text(template: Template) -> str:
    return place(template).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return f"sha256-{base64.b64encode(digest).decode('ascii')}"
