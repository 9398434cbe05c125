"""Make a notebook of each lesson and run it: python docs/notebooks.py FOLDER.

Sphinx writes the lessons as Markdown, and their code becomes cells: a Python session ends a cell
where it shows a result, a terminal session becomes commands of the shell, a file is written by its
cell. An answer is a heading of its own that starts folded. A cell that fails, or whose output is
not what the lesson shows, ends the program.
"""

import doctest
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

import nbformat
from docutils import nodes
from nbclient import NotebookClient
from sphinx.application import Sphinx
from traitlets.config import Config

DOCS = Path(__file__).resolve().parent
SETTINGS = {
    "extensions": ["sphinx_markdown_builder", "pagetools.synonyms", "pagetools.thumbnails"],
    "default_role": "code",
    # What only the build of the pages knows: the reference.
    "exclude_patterns": ["_build", "_generated", "templates", "api", "commands*", "gallery.rst"],
    "suppress_warnings": ["toc", "ref"],
}
_FENCE = re.compile(r"(?ms)^```(pycon|console|python file=\S+)\n(.*?)^```$")
_ANSWER = re.compile(r"(?m)^\*\*(\d+)\.\*\* ?")
_IMAGE = re.compile(r"\]\(_generated/([\w.-]+)\)")
_BESIDE = re.compile(r"\]\(([\w-]+)\.md")
_PAGE = re.compile(r"\]\(\.\./([\w/-]+)\.md")
_CHECKER, _FLAGS = doctest.OutputChecker(), doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
_new = nbformat.v4


def prepare(app, tree, name):
    """Make a paragraph of the caption of a figure; name a file beside its language."""
    for entry in list(tree.findall(nodes.citation)):  # of the bibliography, which is not a notebook
        entry.parent.remove(entry)
    for caption in list(tree.findall(nodes.caption)):
        if isinstance(caption.parent, nodes.figure):
            caption.replace_self(nodes.paragraph("", "", *caption.children))
        else:
            (block,) = caption.parent.findall(nodes.literal_block)
            block["language"] = f"python file={caption.astext()}"
            caption.parent.replace_self(block)


def write_markdown():
    """Return the pages of lessons and gallery as Markdown, by folder and name."""
    with tempfile.TemporaryDirectory() as work:
        app = Sphinx(
            DOCS,
            None,
            work,
            f"{work}/trees",
            "markdown",
            SETTINGS,
            status=None,
            warningiserror=True,
        )
        app.connect("doctree-resolved", prepare)
        app.build()
        if app.statuscode:
            raise SystemExit("the warnings above must go; pictures are made by: make docs")
        folders = (Path(work, name) for name in ("lessons", "gallery"))
        return {
            folder.name: {page.stem: page.read_text("utf-8") for page in sorted(folder.iterdir())}
            for folder in folders
        }


def code_cell(source, shown="", tags=()):
    """Return a cell; what the lesson shows of its output stays with it until it has run."""
    metadata = {"shown": shown, **({"tags": list(tags)} if tags else {})}
    return _new.new_code_cell(source.rstrip("\n"), metadata=metadata)


def code_cells(kind, body):
    """Yield the cells of one block."""
    if kind == "console":
        pairs = re.findall(r"(?ms)^\$ ((?:[^\n]*\\\n)*[^\n]*)\n(.*?)(?=^\$ |\Z)", body)
        lines = "\n".join(["%%bash --no-raise-error", *(command for command, _ in pairs)])
        yield code_cell(lines, "".join(shown for _, shown in pairs))
    elif kind == "pycon":
        source = ""
        for example in doctest.DocTestParser().get_examples(body):
            source += example.source
            if example.exc_msg:
                shown = re.sub(r"^[\w.]*\.(?=\w+:)", "", example.exc_msg)
                yield code_cell(source, shown, ["raises-exception"])
            elif example.want:
                yield code_cell(source, example.want)
            source = "" if example.want else source
        if source:
            yield code_cell(source)
    else:
        name = kind.removeprefix("python file=")
        yield code_cell(f"%%writefile {name}\n{body}", f"Writing {name}\n")


def output(cell):
    """Return what a cell printed, its result, or its error."""
    texts = []
    for out in cell.outputs:
        if out.output_type == "error":
            texts.append(f"{out.ename}: {out.evalue}\n")
        else:
            texts.append(out.text if "text" in out else out.data["text/plain"] + "\n")
    return "".join(texts)


def compare(name, made):
    """Compare the outputs of a notebook that has run with those of the lesson."""
    for cell in made.cells:
        shown = cell.metadata.pop("shown", None)
        if shown is not None and not _CHECKER.check_output(shown, output(cell), _FLAGS):
            raise SystemExit(f"{name}:\n{cell.source}\nshown:\n{shown}\noutput:\n{output(cell)}")


def text_cells(text):
    """Yield the cells of text: one, or one more for each answer, folded."""
    first, *answers = _ANSWER.split(text)
    if first.strip():
        yield _new.new_markdown_cell(first.strip())
    for number, answer in zip(answers[::2], answers[1::2], strict=True):
        heading = _new.new_markdown_cell(f"### Answer {number}")
        heading.metadata["jp-MarkdownHeadingCollapsed"] = True
        yield from (heading, _new.new_markdown_cell(answer.strip()))


def notebook(text):
    """Return the notebook of a page in Markdown."""
    text = _IMAGE.sub(r"](images/\1)", text)
    text = _BESIDE.sub(r"](\1.ipynb", text)
    text = _PAGE.sub(r"](../html/\1.html", text)
    cells, at = [], 0
    for block in _FENCE.finditer(text):
        cells += [*text_cells(text[at : block.start()]), *code_cells(block[1], block[2])]
        at = block.end()
    cells += text_cells(text[at:])
    for number, cell in enumerate(cells):
        cell["id"] = f"cell-{number}"
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return _new.new_notebook(cells=cells, metadata={"kernelspec": kernel})


def execute(made):
    """Run a notebook in a folder of its own."""
    os.environ["COLUMNS"] = "80"
    with tempfile.TemporaryDirectory() as desk:
        # Sockets that are files, which nobody else can read.
        sockets = {"transport": "ipc", "ip": f"{desk}/kernel"}
        NotebookClient(
            made,
            config=Config({"KernelManager": sockets}),
            kernel_name="python3",
            timeout=600,
            resources={"metadata": {"path": desk}},
            record_timing=False,
            coalesce_streams=True,
        ).execute()


def main(folder):
    """Write and run the notebooks of the lessons."""
    (folder / "images").mkdir(parents=True, exist_ok=True)
    os.environ["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    for name, text in write_markdown()["lessons"].items():
        for image in _IMAGE.findall(text):
            shutil.copy(DOCS / "_generated" / image, folder / "images")
        made = notebook(text)
        execute(made)
        compare(name, made)
        nbformat.write(made, folder / f"{name}.ipynb")
        print(f"{name}: {len(made.cells)} cells")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
