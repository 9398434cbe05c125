"""The directives thumbnails and tikz: the pictures of the gallery.

Of thumbnails, the argument is a folder, and each line of the content is the name of a page there.
Shown is the first picture of each page, without its legend where that was drawn, with a link to the
page. The pages become a table of contents too.

The argument of tikz is the name of a picture that is there in TikZ too. Shown is what LaTeX makes
of it, where that is installed, and a link to the file.
"""

import re
from pathlib import Path

from sphinx.util.docutils import SphinxDirective

_FIGURE = re.compile(
    r"figure:: (/_generated/\S+)\n(?:   :(?:width|class): .*\n)*   :alt: (.*(?:\n {6,}.*)*)"
)


class Thumbnails(SphinxDirective):
    has_content = True
    required_arguments = 1

    def run(self):
        (folder,) = self.arguments
        names = "\n".join(self.content).split()
        lines = [".. container:: thumbnails", ""]
        for name in names:
            path = Path(self.env.srcdir, folder, f"{name}.rst")
            self.env.note_dependency(str(path))
            text = path.read_text("utf-8")
            title = text.partition("\n")[0]
            shown, alt = _FIGURE.search(text).groups()
            alt = " ".join(alt.split())
            for drawn in (name, Path(shown).stem.removeprefix(f"{folder}-")):
                small = f"/_generated/{folder}-thumbnail-{drawn}.svg"
                if Path(f"{self.env.srcdir}{small}").exists():
                    shown = small
                    break
            lines += [f"   .. figure:: {shown}", f"      :alt: {alt}"]
            lines += [f"      :target: {folder}/{name}.html", ""]
            lines += [f"      :doc:`{title} <{folder}/{name}>`", ""]
        lines += [".. toctree::", "   :hidden:", "", *(f"   {folder}/{name}" for name in names)]
        return self.parse_text_to_nodes("\n".join(lines))


class TikZ(SphinxDirective):
    required_arguments = 1

    def run(self):
        (name,) = self.arguments
        link = f"In LaTeX: :download:`{name}.tex </_generated/{name}.tex>`"
        lines = [link]
        if Path(self.env.srcdir, "_generated", f"{name}-tikz.png").exists():
            lines = [f".. figure:: /_generated/{name}-tikz.png", "   :width: 60%"]
            lines += ["   :alt: The same picture as LaTeX sets it.", "", f"   {link}"]
        return self.parse_text_to_nodes("\n".join(lines))


def setup(app):
    app.add_directive("tikz", TikZ)
    app.add_directive("thumbnails", Thumbnails)
