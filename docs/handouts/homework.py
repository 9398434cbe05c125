"""Sheets of homework: exercises of several lessons, with points, as course/course.toml lists them.

The HTML pages are those of the sheets of lessons; here are the choice of exercises, and TeX.
"""

from docutils import nodes
from docutils.core import publish_from_doctree
from docutils.utils import new_document

from arrangement.console.number_form import counted

_SETTINGS = {
    "documentclass": "article",
    "documentoptions": "11pt,a4paper",
    "use_latex_toc": False,
    "section_numbering": False,
    "output_encoding": "unicode",
    "syntax_highlight": "none",
    "warning_stream": False,
    "literal_block_env": "lstlisting",
    "latex_preamble": r"""\usepackage{amssymb,listings}
\lstset{basicstyle=\ttfamily\footnotesize,breaklines=true}
\setlength{\parskip}{0.5em}
\setlength{\parindent}{0pt}""",
    "use_latex_citations": True,
    "legacy_column_widths": False,
}


def homework(sheet, lessons):
    """Return the exercises of a sheet, numbered from 1, each with the place that it comes from.

    Args:
        sheet: of course.toml, with the lesson, number and points of each exercise.
        lessons: exercises of each lesson by number.
    """
    chosen = []
    for number, (lesson, exercise, points) in enumerate(sheet["exercises"], 1):
        if exercise not in lessons[lesson]:
            raise ValueError(f"{sheet['name']}: {lesson} has no exercise {exercise}")
        own = lessons[lesson][exercise]
        place = f"lesson {own['lesson']}, exercise {exercise}"
        chosen.append({**own, "number": number, "points": points, "place": place})
    return chosen


def tex(sheet, about, chosen, solved):
    """Return a sheet, or its solutions, as a LaTeX document."""
    document = new_document(sheet["name"])
    kind = "solutions" if solved else ""
    document += nodes.title("", ", ".join(filter(None, [sheet["title"], kind])))
    total = sum(one["points"] for one in chosen)
    due = sheet["due"] and f"due {sheet['due']}"
    words = [about.get("course"), about.get("lecturer"), due, counted(total, "point")]
    document += nodes.paragraph("", ", ".join(filter(None, words)))
    if not solved:
        document += nodes.raw("", "Name: \\hrulefill", format="latex")
    for one in chosen:
        head = f"Exercise {one['number']} ({counted(one['points'], 'point')}; {one['place']})"
        document += nodes.paragraph("", "", nodes.strong("", head))
        document += [node.deepcopy() for node in one["question"]]
        if solved:
            document += nodes.paragraph("", "", nodes.emphasis("", "Answer."))
            document += [node.deepcopy() for node in one["answer"]]
    for image in document.findall(nodes.image):
        raise ValueError(
            f"{sheet['name']}: a sheet in TeX takes no picture, such as {image['uri']}"
        )
    # Links lead to pages that are not at hand.
    for link in list(document.findall(nodes.reference)):
        link.replace_self(link.children)
    return publish_from_doctree(document, writer="latex", settings_overrides=_SETTINGS)
