"""Pictures of dark pages: each generated SVG a second time, in the colours of the dark theme.

A picture of the class `as-drawn` stays as it is.
"""

import functools
import re
from pathlib import Path

from docutils import nodes

from arrangement.drawing.colours import VERMILION
from arrangement.drawing.themes import dark_colour

FOLDER = "_generated"
_STYLE = re.compile(r'<(\w+)([^<>]*?)style="([^"]*)"')
_COLOUR = re.compile(r"\b(fill|stroke): (#[0-9a-f]{6})")
_dark = functools.cache(dark_colour)


def _darkened(element):
    """Return the start of an element with the colours of its style exchanged.

    Style on a group belongs to letters, and vermilion is a colour of ink. A stroke of the colour of
    its shape is not a line.
    """
    tag, between, style = element.groups()
    colours = dict(_COLOUR.findall(style))
    is_seam = colours.get("fill") == colours.get("stroke")

    def exchange(found):
        is_ink = tag in ("g", "text") or found[2] == VERMILION
        is_line = is_ink or (found[1] == "stroke" and not is_seam)
        return f"{found[1]}: {_dark(found[2], is_line=is_line)}"

    return f'<{tag}{between}style="{_COLOUR.sub(exchange, style)}"'


def darken(svg):
    """Return a picture of matplotlib in the dark theme; what has no colour is black there."""
    ink = _dark("#000000", is_line=True)
    return _STYLE.sub(_darkened, svg).replace("<svg ", f'<svg fill="{ink}" ', 1)


def write_dark(app):
    """Write the dark picture of each light one, unless it is there and newer."""
    folder = Path(app.srcdir) / FOLDER
    (folder / "dark").mkdir(exist_ok=True)
    for light in folder.glob("*.svg"):
        dark = folder / "dark" / light.name
        if not dark.exists() or dark.stat().st_mtime <= light.stat().st_mtime:
            dark.write_text(darken(light.read_text("utf-8")), "utf-8")


def show_both(app, tree, name):
    """Put the dark picture beside the light one; the theme of the page shows one of them."""
    if app.builder.format != "html":
        return
    for light in list(tree.findall(nodes.image)):
        folder, _, file = light["uri"].rpartition("/")
        if folder != FOLDER or not file.endswith(".svg") or "as-drawn" in light["classes"]:
            continue
        # A link holds one picture.
        frame = light.parent if isinstance(light.parent, nodes.reference) else light
        second = frame.deepcopy()
        dark = next(second.findall(nodes.image))
        dark["uri"] = f"{folder}/dark/{file}"
        dark["candidates"] = {"*": dark["uri"]}
        light["classes"].append("only-light")
        dark["classes"].append("only-dark")
        frame.parent.insert(frame.parent.index(frame) + 1, second)
        app.env.images.add_file(name, dark["uri"])


def setup(app):
    app.connect("builder-inited", write_dark, priority=900)  # after the pictures
    app.connect("doctree-resolved", show_both, priority=900)  # after slides and sheets
