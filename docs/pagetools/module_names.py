"""The directive module-names: the functions and classes of a public module, with their docstrings.

Its argument is a module, ``arrangement.families``. A table of names stands first.
"""

import collections
import importlib
import inspect
from pathlib import Path

from sphinx.util.docutils import SphinxDirective


def own_names(module, package):
    """Return the public functions and classes of a module that its package does not have too."""
    return [
        name
        for name in dir(module)
        if not name.startswith("_")
        and (inspect.isclass(value := getattr(module, name)) or inspect.isroutine(value))
        and value.__module__.startswith(module.__name__)
        and value is not getattr(package, name, None)
    ]


class ModuleNames(SphinxDirective):
    required_arguments = 1

    def run(self):
        (path,) = self.arguments
        above, _, name = path.partition(".")
        package = importlib.import_module(above)
        module = getattr(package, name)
        names = own_names(module, package)
        summary = inspect.getdoc(module).partition("\n\n")[0]
        lines = [f".. py:module:: {path}", "", ".. py:currentmodule:: None", "", summary, ""]
        lines += [".. autosummary::", "   :nosignatures:", ""]
        lines += [*(f"   ~{path}.{name}" for name in names), ""]
        for name in names:
            kind = "class" if inspect.isclass(getattr(module, name)) else "function"
            members = ["   :members:"] if kind == "class" else []
            lines += [f".. auto{kind}:: {path}.{name}", *members, ""]
        return self.parse_text_to_nodes("\n".join(lines))


def drop_old_pages(app):
    """Remove the generated pages of names that no table has any more."""
    listed = "".join(page.read_text("utf-8") for page in Path(app.srcdir, "api").glob("*.rst"))
    for page in Path(app.srcdir, "api", "names").glob("*.rst"):
        if f"~{page.stem}\n" not in listed:
            page.unlink()


def leave_out_fields(app, what, name, value, skip, options):
    """Leave out the fields of a named tuple, which its docstring documents."""
    return True if isinstance(value, type(collections.namedtuple("One", "x").x)) else None


def setup(app):
    app.add_directive("module-names", ModuleNames)
    # Before autosummary writes its pages.
    app.connect("builder-inited", drop_old_pages, priority=100)
    app.connect("autodoc-skip-member", leave_out_fields)
