"""Which module of the three packages names which other one, whatever the form of the import.

Counted are imports at the top of a module and inside functions; names of a facade whose stub says
where they are (`lazy_names`), for the module where they are; and strings that are the place of a
module or of something in it, such as ``"package.module:function"``. Imports for annotations alone
do not count, nor does the import of a package that any import of its modules brings along.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import chain
from pathlib import Path

import networkx as nx

#: A module, and another one that it names.
Arrow = tuple[str, str]


class ImportGraph:
    """The modules of packages in a folder, and what each of them names."""

    def __init__(self, folder: Path, packages: Iterable[str]) -> None:
        self._paths: dict[str, Path] = {}
        for path in chain.from_iterable((folder / name).rglob("*.py") for name in packages):
            parts = path.relative_to(folder).with_suffix("").parts
            self._paths[".".join(parts).removesuffix(".__init__")] = path
        #: Where the names of facades are.
        self._places: dict[Arrow, str] = {}
        for module, path in self._paths.items():
            if (stub := path.with_suffix(".pyi")).exists():
                for place, name in _named(stub.read_text(encoding="utf-8"), module):
                    self._places[module, name] = self._target(place, name)

    @cached_property
    def arrows(self) -> set[Arrow]:
        """All arrows."""
        texts = {name: path.read_text(encoding="utf-8") for name, path in self._paths.items()}
        return {arrow for name, text in texts.items() for arrow in self.arrows_of(name, text)}

    def arrows_of(self, module: str, text: str) -> set[Arrow]:
        """Return the arrows of a module with a text."""
        is_package = self._paths[module].stem == "__init__"
        package = module if is_package else module.rpartition(".")[0]
        targets = {self._target(place, name) for place, name in _named(text, package)}
        return {(module, target) for target in targets & self._paths.keys() - {module}}

    def _target(self, place: str, name: str) -> str:
        inside = f"{place}.{name}"
        return self._places.get((place, name), inside if inside in self._paths else place)


def circles(pairs: Iterable[Arrow]) -> list[set[str]]:
    """Return modules that name each other in circles, and packages in whose modules they do."""
    graph = nx.DiGraph()
    for module, other in pairs:
        graph.add_edge(module, other)
        ours, theirs = module.split("."), other.split(".")
        together = zip(ours, theirs, strict=False)
        # Where the two lie in different packages of one, these name each other, too.
        apart = next((k for k, (a, b) in enumerate(together, 1) if a != b), None)
        if apart is not None:
            graph.add_edge(".".join(ours[:apart]), ".".join(theirs[:apart]))
    return [part for part in nx.strongly_connected_components(graph) if len(part) > 1]


def _named(text: str, package: str) -> Iterator[Arrow]:
    """Yield what a module names, as a place and a name there, which is empty for all of it."""
    nodes = list(_executed(ast.parse(text)))
    whole = {a.name for node in nodes if isinstance(node, ast.Import) for a in node.names}
    for node in nodes:
        match node:
            case ast.ImportFrom(module=place, names=aliases, level=level):
                above = package.split(".")[: package.count(".") + 2 - level] if level else []
                for alias in aliases:
                    yield ".".join([*above, *([place] if place else [])]), alias.name
            case ast.Import(names=aliases):
                yield from ((alias.name, "") for alias in aliases)
            case ast.Attribute(value=ast.Name(id=place), attr=name) if place in whole:
                yield place, name
            case ast.Constant(value=str(constant)) if ":" in constant:
                place, _, name = constant.partition(":")
                outer = package.split(".")
                yield place, name
                yield from ((".".join([*outer[:k], place]), name) for k in range(1, len(outer) + 1))
            case ast.Constant(value=str(constant)) if "." in constant:
                yield constant, ""


def _executed(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the nodes of a module without those for annotations alone."""
    waiting: list[ast.AST] = [tree]
    while waiting:
        node = waiting.pop()
        match node:
            case ast.If(test=ast.Name(id="TYPE_CHECKING")):
                waiting += node.orelse
            case ast.Load() | ast.Store():  # a third of all nodes, which name nothing
                pass
            case _:
                yield node
                waiting += ast.iter_child_nodes(node)
