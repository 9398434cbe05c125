"""The directive public-names: a table of names of a package, then each name with its docstring.

Each line of its content is a public name of the package in the argument. Of a module, its own
functions and classes are shown in the same way. The argument `equilibrium` and the line `solve`
make the target `equilibrium.solve`.
"""

import collections
import importlib
import inspect
import sys
import types

from sphinx.util.docutils import SphinxDirective


def own(module, package):
    """Return the functions and classes that belong to a module, by name.

    What is a public name of the package too is left out: it has its place already.
    """
    names = [name for name in dir(module) if not name.startswith("_")]
    values = {name: getattr(module, name) for name in names}
    return {
        name: value
        for name, value in values.items()
        if (inspect.isclass(value) or inspect.isroutine(value))
        and value.__module__.startswith(module.__name__)
        and value is not getattr(package, name, None)
    }


def _directive(path, value):
    """Return the lines that document one function or class."""
    if isinstance(value, type) and issubclass(value, Exception):
        return [f".. autoexception:: {path}", "   :show-inheritance:", ""]
    if isinstance(value, type):
        return [f".. autoclass:: {path}", "   :members:", ""]
    return [f".. autofunction:: {path}", ""]


def listing(package, members):
    """Return reStructuredText: a table of names, then the names one by one."""
    values = {f"{package}.{name}": value for name, value in members.items()}
    modules = [path for path, value in values.items() if isinstance(value, types.ModuleType)]
    lines = []
    if plain := [path for path in values if path not in modules]:
        lines += [".. autosummary::", "", *(f"   ~{path}" for path in plain), ""]
    for path in plain:
        lines += _directive(path, values[path])
    for path in modules:
        summary = inspect.getdoc(values[path]).partition("\n\n")[0].replace("\n", " ")
        lines += [f".. py:module:: {path}", "", ".. py:currentmodule:: None", ""]
        lines += [f"**Module** `{path}`. {summary}", ""]
        lines += listing(path, own(values[path], sys.modules[package]))
    return lines


class PublicNames(SphinxDirective):
    has_content = True
    required_arguments = 1

    def run(self):
        (package,) = self.arguments
        module = importlib.import_module(package)
        members = {name: getattr(module, name) for name in "\n".join(self.content).split()}
        return self.parse_text_to_nodes("\n".join(listing(package, members)))


def leave_out_fields(app, what, name, value, skip, options):
    """Leave out the fields of a named tuple, which its docstring documents."""
    return True if isinstance(value, type(collections.namedtuple("One", "x").x)) else None


def setup(app):
    app.setup_extension("sphinx.ext.autosummary")
    app.add_directive("public-names", PublicNames)
    app.connect("autodoc-skip-member", leave_out_fields)
