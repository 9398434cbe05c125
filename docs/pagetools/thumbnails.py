"""The directive thumbnails: the first picture of each page of a folder, with a link to the page.

Its argument is the folder; each line of its content is the name of a page there. The pages become
a table of contents too.
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
            lines += [f"   .. figure:: {shown}", f"      :alt: {alt}"]
            lines += [f"      :target: {folder}/{name}.html", ""]
            lines += [f"      :doc:`{title} <{folder}/{name}>`", ""]
        lines += [".. toctree::", "   :hidden:", "", *(f"   {folder}/{name}" for name in names)]
        return self.parse_text_to_nodes("\n".join(lines))


def setup(app):
    app.add_directive("thumbnails", Thumbnails)
