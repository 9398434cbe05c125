"""One registry of drawings for each package, and what both do with it: write files, take options.

A view is one function in one file of the package ``draw``, and one line in its registry. Its
options are its keyword-only parameters: names, types and explanations are read from its source, so
that nothing is imported until it is drawn. No module here knows any view.
"""

from __future__ import annotations

import ast
import importlib
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, TypeAlias

from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.io.writing import write_bytes_atomically, write_text_atomically

from .output import MODELS, PAGES, PICTURES, save_figure, svg_text

#: The kinds of options, for signatures; `command` tells how each is written on a command line.
Vector: TypeAlias = Sequence[object]
Exact: TypeAlias = object
Wrench: TypeAlias = Iterable[Any]
Corner: TypeAlias = Iterable[Any]


@dataclass(frozen=True)
class Option:
    """A keyword-only parameter of a view, as its source has it.

    Attributes:
        kind: the annotation without ``| None`` and without `Iterable`.
        many: whether it takes several values.
        text: from the section ``Args`` of the docstring.
    """

    name: str
    kind: str
    many: bool
    required: bool
    text: str


@dataclass(frozen=True)
class Drawings:
    """What a package can draw.

    Attributes:
        package: where the modules are.
        views: of pictures: name -> ``module:function``, ``f(subject, **options) -> Figure``; the
            first one is the default.
        models: likewise, ``f(subject, suffix, **options) -> bytes``.
        pages: likewise, ``f(subject, **options) -> str``.
    """

    package: str
    views: Mapping[str, str]
    models: Mapping[str, str]
    pages: Mapping[str, str]

    def write(
        self,
        subject: Any,
        path: str | os.PathLike[str],
        view: str | None = None,
        model: str | None = None,
        **options: Any,
    ) -> dict[str, str]:
        """Draw into a file, whole or not at all.

        Args:
            subject: an arrangement, or a grasp, that the view can show; see its function.
            path: ``.svg``, ``.pdf`` or ``.png`` for a picture; ``.stl``, ``.glb`` or ``.obj`` for a
                model. STL and OBJ are in millimetres, GLB is in metres as its standard demands;
                ``.html`` for an interactive page.
            view: of a picture or a page; if omitted, the first one.
            model: if omitted, the first one.
            options: those of the function of the view, model or page.

        Returns:
            What was written: ``{"view": name}``, ``{"model": name}`` or ``{"page": name}``.

        Raises:
            InputError: unknown suffix, view, model or option, what the view refuses, no place to
                write.
            MissingExtraError: matplotlib is absent.
        """
        kind, name = self.target(path, view, model)
        draw = self._function(kind, name, options)
        if kind == "view":
            save_figure(path, lambda: draw(subject, **options))
        elif kind == "page":
            write_text_atomically(path, draw(subject, **options))
        else:
            write_bytes_atomically(path, draw(subject, Path(path).suffix.lower(), **options))
        return {kind: name}

    def svg(self, subject: Any, view: str, **options: Any) -> str | None:
        """Return a picture as SVG text; None without matplotlib, or when `write` would refuse."""
        return svg_text(lambda: self._function("view", view, options)(subject, **options))

    def _function(self, kind: str, name: str, options: Mapping[str, Any]) -> Any:
        """Return the function behind a name, if it has these options.

        Raises:
            InputError: an unknown name or option.
        """
        known = getattr(self, f"{kind}s")
        if name not in known:
            raise refusal(f"the {kind} is {shown(name)}", name, known)
        found = self.options(kind, name)
        for option in options:
            if option not in found:
                raise refusal(
                    f"the {kind} {name} has no option {shown(option)}", option, found, "it has"
                )
        for needed in found.values():
            if needed.required and needed.name not in options:
                raise InputError(f"the {kind} {name} needs {needed.name}; give at least one")
        module, _, function = known[name].partition(":")
        return getattr(importlib.import_module(f"{self.package}.{module}"), function)

    def target(
        self, path: str | os.PathLike[str], view: str | None = None, model: str | None = None
    ) -> tuple[str, str]:
        """Return what a path asks for: "view", "model" or "page", and the name of it.

        Raises:
            InputError: unknown suffix or name, or a name that does not go with the suffix.
        """
        suffix = Path(path).suffix.lower()
        kinds = {"view": PICTURES, "model": MODELS if self.models else (), "page": PAGES}
        kind = next((kind for kind, suffixes in kinds.items() if suffix in suffixes), None)
        if kind is None:
            ends = sorted(end for suffixes in kinds.values() for end in suffixes)
            raise InputError(f"the file name ends in {shown(suffix)}; known are {', '.join(ends)}")
        name, other = (model, view) if kind == "model" else (view, model)
        if other is not None:
            wrong = "view" if kind == "model" else "model"
            raise InputError(
                f"a {wrong} was named and the file name ends in {suffix}; a {wrong} needs one of "
                f"{', '.join(kinds[wrong])}"
            )
        known = getattr(self, f"{kind}s")
        name = next(iter(known)) if name is None else name
        if name not in known:
            raise refusal(f"the {kind} is {shown(name)}", name, known)
        return kind, name

    def options(self, kind: str, name: str) -> dict[str, Option]:
        """Return the options of a view, model or page by name."""
        return _options(self.package, *getattr(self, f"{kind}s")[name].split(":"))


@cache
def _options(package: str, module: str, name: str) -> dict[str, Option]:
    tree = ast.parse(files(package).joinpath(f"{module}.py").read_text(encoding="utf-8"))
    found = next(x for x in tree.body if isinstance(x, ast.FunctionDef) and x.name == name)
    texts = _explained(ast.get_docstring(found) or "")
    options = {}
    for argument, default in zip(found.args.kwonlyargs, found.args.kw_defaults, strict=True):
        annotation = argument.annotation
        kind = ast.unparse(annotation).split(" | ")[0] if annotation else "str"
        if many := kind.startswith("Iterable["):
            kind = kind.removeprefix("Iterable[").removesuffix("]")
        text = texts.get(argument.arg, "")
        options[argument.arg] = Option(argument.arg, kind, many, default is None, text)
    return options


def _explained(docstring: str) -> dict[str, str]:
    """Return the explanations of arguments in a docstring."""
    texts: dict[str, str] = {}
    names: list[str] = []
    for line in docstring.partition("Args:\n")[2].partition("\n\n")[0].splitlines():
        if line.startswith("    ") and not line.startswith("     "):
            head, _, line = line.partition(":")
            names = head.strip().split(", ")
        for name in names:
            texts[name] = f"{texts.get(name, '')} {line.strip()}".strip()
    return texts


def refusal(
    mistake: str, value: object, known: Iterable[str], remedy: str = "known are"
) -> InputError:
    """Return the error for a name that does not exist, with the nearest ones that do."""
    names = list(known)
    near = get_close_matches(str(value), names, 3)
    meant = f"did you mean {' or '.join(near)}? " if near else ""
    return InputError(f"{mistake}; {meant}{remedy} {', '.join(names) or 'none'}")
