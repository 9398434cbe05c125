"""Make a JupyterLite site of lessons and gallery: python docs/lite.py docs/_build/html.

It lies in the folder `lite` of the site, whose pages then link to it. The notebooks are made as in
`notebooks.py`. In a browser they run in Pyodide, with the wheel
of this checkout. Pyodide and its wheels come from its own server; python-flint, trimesh and
latex2mathml from PyPI. A browser has no shell: cells of commands call the programs in Python.

Pyodide's wheel of numpy is on no package index, so the notebooks are not run in it here. Those of
`RUN` are run in CPython instead, without python-flint, without processes and without a shell.
"""

import base64
import mimetypes
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import nbformat
from notebooks import DOCS, code_cell, compare, execute, notebook, write_markdown

#: The first cell of a notebook: what it needs, and commands without a shell.
START = """\
%pip install -q slipstates[figures,space,mesh,report,search]"""
COMMANDS = r'''import contextlib, importlib, io, pathlib, shlex, shutil, sys
from IPython.core.magic import register_cell_magic

def called(words, code):
    match words:
        case ["arrangement" | "equilibrium" | "proofs-check" as name, *words]:
            try:
                code = importlib.import_module(f"{name.replace('-', '_')}.cli").main(words)
            except SystemExit as left:
                code = left.code
        case ["echo", "$?"]:
            print(code)
        case ["cat", name]:
            print(pathlib.Path(name).read_text("utf-8"), end="")
        case ["mkdir", name]:
            pathlib.Path(name).mkdir()
        case ["cp", source, target]:
            shutil.copy(source, target)
        case [_, *_]:
            print(f"not in a browser: {shlex.join(words)}")
    return code

@register_cell_magic
def bash(line, cell):
    """Call the programs of the package; there is no shell in a browser."""
    code = 0
    for command in cell.replace("\\\n", " ").splitlines():
        words, target = shlex.split(command, comments=True), None
        if ">" in words:
            words, target = words[: words.index(">")], words[-1]
        text = io.StringIO() if target else sys.stdout
        with contextlib.redirect_stdout(text):
            code = called(words, code)
        if target:
            pathlib.Path(target).write_text(text.getvalue(), "utf-8")'''

#: Pages that are run as in a browser, and what stands for the first cell.
RUN = ("02-a-contact-is-a-plane", "04-counting", "09-certificates", "sphere")
BLOCKED = """\
import subprocess, sys
sys.modules["flint"] = None
def refused(*arguments, **options):
    raise OSError("a browser starts no processes")
subprocess.Popen.__init__ = refused"""


def with_start(made):
    """Return a notebook that begins with what a browser needs."""
    cells = [code_cell(START), code_cell(COMMANDS)]
    cells[1].metadata["jupyter"] = {"source_hidden": True}
    for number, cell in enumerate(cells):
        cell["id"] = f"start-{number}"
    made.cells[:0] = cells
    return made


def in_browser(made):
    """Put the pictures into a notebook, since JupyterLite shows few SVG files; name its kernel."""

    def data(found):
        content = (DOCS / "_generated" / found[1]).read_bytes()
        kind, _ = mimetypes.guess_type(found[1])
        return f"](data:{kind};base64,{base64.b64encode(content).decode()})"

    for cell in made.cells:
        cell.metadata.pop("shown", None)
        if cell.cell_type == "markdown":
            cell.source = re.sub(r"\]\(images/([\w.-]+)\)", data, cell.source)
    made.metadata.kernelspec = {
        "name": "python", "display_name": "Python (Pyodide)", "language": "python",
    }  # fmt: skip
    return made


def run(name, made):
    """Run a notebook as in a browser, and compare its outputs with those of the page."""
    made.cells[0].source = BLOCKED
    for cell in made.cells[:2]:
        cell.metadata.pop("shown")
    execute(made)
    compare(name, made)
    print(f"{name}: {len(made.cells)} cells run without python-flint, processes and a shell")


def link(page):
    """Link the notebook of a page on it."""
    text = page.read_text("utf-8")
    target = f"../lite/notebooks/index.html?path={page.stem}.ipynb"
    if target in text:
        return
    new = f'<a href="{target}">Run in the browser</a>'
    if '<p class="handouts">' in text:
        text = re.sub(r'(<p class="handouts">.*?)</p>', rf"\1 · {new}</p>", text, count=1)
    else:
        text = text.replace("</h1>", f'</h1>\n<p class="handouts">{new}</p>', 1)
    page.write_text(text, "utf-8")


def main(html):
    """Write the notebooks and the wheel, make the site of them, and link it."""
    pages = write_markdown()
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        (work / "files").mkdir()
        for stem, text in (pages["lessons"] | pages["gallery"]).items():
            if stem in RUN:
                run(stem, with_start(notebook(text)))
            made = in_browser(with_start(notebook(text)))
            nbformat.write(made, work / "files" / f"{stem}.ipynb")
        wheel = ("wheel", "--quiet", "--no-deps", "--wheel-dir", work / "pypi", DOCS.parent)
        subprocess.run([sys.executable, "-m", "pip", *wheel], check=True)
        site = ("--lite-dir", work, "--contents", work / "files", "--output-dir", html / "lite")
        build = (sys.executable, "-m", "jupyterlite_core.app", "build", *site)
        subprocess.run(build, cwd=work, check=True)  # it leaves a database where it runs
    for folder, texts in pages.items():
        for stem in texts:
            link(html / folder / f"{stem}.html")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
