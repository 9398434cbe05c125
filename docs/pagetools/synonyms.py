"""The directive synonyms: the names of other programs, or words of a course, and the names here.

Its argument is a table, ``arrangement.synonyms:ARRANGEMENT``: for each heading words with names.
"""

import importlib

from sphinx.util.docutils import SphinxDirective


def rows(place):
    """Return the table of a place ``module:name``."""
    module, _, name = place.partition(":")
    return getattr(importlib.import_module(module), name)


class Synonyms(SphinxDirective):
    required_arguments = 1

    def run(self):
        lines = []
        for heading, words in rows(self.arguments[0]).items():
            lines += [f".. rubric:: {heading}", "", ".. list-table::", "   :header-rows: 1"]
            lines += ["   :widths: 40 60", "", "   * - name or term", "     - slipstates"]
            code = "``" if all(word.isidentifier() for word in words) else ""
            for word, name in words.items():
                lines += [f"   * - {code}{word}{code}", f"     - ``{name}``"]
            lines.append("")
        return self.parse_text_to_nodes("\n".join(lines))


def setup(app):
    app.add_directive("synonyms", Synonyms)
