"""Configuration of the documentation; it builds and reads without a network."""

import contextlib
import re
import runpy
import shutil
import sys
from pathlib import Path

import matplotlib as mpl

import arrangement
from arrangement.console.progress import Bar

project = "slipstates"
author = "The slipstates authors"
copyright = "2026, the slipstates authors"
version = release = arrangement.__version__

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "sphinx-mathjax-offline",
    "sphinx_copybutton",
    "handouts",
    "pagetools",
]
exclude_patterns = ["_build", "_generated", "templates"]
templates_path = ["templates"]
default_role = "code"
highlight_language = "python"
nitpicky = False
# Quotes and dots, no dashes: options of commands stand in sentences.
smartquotes_action = "qe"
# What is made of the lessons, directives of these pages, and what figures share.
sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parent / "figures")]
# The bibliography is a list to cite from; a docstring may use a word that several classes have as
# the name of an attribute.
suppress_warnings = ["ref.citation", "ref.python"]

# matplotlib gives each kind of figure a method `set`, in markup of its own.
autodoc_default_options = {"ignore-module-all": True, "exclude-members": "set"}
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
# Types that say how a value is written on a command line, in words of Python.
autodoc_type_aliases = {
    "Graph": "networkx.Graph | str",
    "TextKind": "str | None",
    "Length": "float | str | None",
    "LegendPlace": "str | None",
    "Type": "int | str | networkx.Graph",
}
maximum_signature_line_length = 72
toc_object_entries_show_parents = "hide"
napoleon_use_ivar = True

# What is copied is what is typed: no prompts, no output.
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True
copybutton_line_continuation_character = "\\"

html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css", "print.css"]
html_title = f"slipstates {release}"
html_copy_source = False
html_show_sphinx = False


def escape_mathematics(app, what, name, obj, options, lines):
    """Keep |x| and a * b in docstrings as they are written: they are not markup there."""
    for number, line in enumerate(lines):
        if not line.lstrip().startswith((">>>", "...")):
            _, bullet, text = re.split(r"^(\s*[*-] |)", line, maxsplit=1)
            parts = re.split(r"(`+[^`]*`+)", text)
            parts[::2] = [re.sub(r"(?<!\\)([|*])", r"\\\1", part) for part in parts[::2]]
            lines[number] = bullet + "".join(parts)


def keep_colons(app, what, name, obj, options, lines):
    """Start texts of properties with a comment: Napoleon takes words before a colon for a type."""
    if what == "property":
        lines[:0] = ["..", ""]


def make_figures(app):
    """Run each script of figures/ in the folder _generated, unless what it made is up to date.

    The script NAME.py makes files whose names start with NAME. A script that fails, or makes no
    such file, ends the build. Modules that start with an underscore are what scripts share. A page
    NAME.rst and files in a folder NAME are what the script may read. Interactive pages are copied
    to the folder pages of the site, where links open them.
    """
    source = Path(app.srcdir)
    folder = source / "_generated"
    folder.mkdir(exist_ok=True)
    shared = [*source.glob("figures/_*.py")]
    for package in ("drawing", "pictures"):
        shared += source.parent.glob(f"*/{package}/**/*.py")
    newest = max((path.stat().st_mtime for path in shared), default=0.0)
    due = []
    for script in sorted(source.glob("figures/[!_]*.py")):
        stamp = folder / f".{script.stem}"
        read = [script, *source.rglob(f"{script.stem}.rst"), *source.glob(f"{script.stem}/*.*")]
        changed = max(newest, *(path.stat().st_mtime for path in read))
        if not stamp.exists() or stamp.stat().st_mtime <= changed:
            due.append((script, stamp))
    bar = Bar(len(due), "scripts of pictures")
    for done, (script, stamp) in enumerate(due):
        bar.update(done, script.name)
        with contextlib.chdir(folder), mpl.rc_context():
            runpy.run_path(str(script), run_name="__main__")
        if not any(folder.glob(f"{script.stem}*.*")):
            raise RuntimeError(f"{script} made no file {script.stem}*")
        stamp.touch()
    bar.close()
    pages = Path(app.outdir) / "pages"
    pages.mkdir(parents=True, exist_ok=True)
    for page in folder.glob("*.html"):
        shutil.copy(page, pages)
    for page in folder.glob("*/index.html"):  # with the files that it links to
        shutil.copytree(page.parent, pages / page.parent.name, dirs_exist_ok=True)


def drop_bundles(app, error):
    """Remove the bundles of MathJax that no page loads: more than half of its files."""
    folder, loaded = Path(app.outdir) / "_static" / "mathjax", Path(app.config.mathjax_path).name
    for bundle in folder.glob("*.js") if (folder / loaded).exists() else ():
        if bundle.name != loaded:
            bundle.unlink()


def setup(app):
    app.connect("builder-inited", make_figures)
    app.connect("build-finished", drop_bundles)
    app.connect("autodoc-process-docstring", escape_mathematics, priority=400)
    app.connect("autodoc-process-docstring", keep_colons, priority=450)
