"""Stubs of the methods `draw`: an overload for each view with its options, made from the views.

``python -m tests.draw_stubs`` writes them; a test compares them with the views.
"""

import inspect
import typing
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from pathlib import Path
from types import UnionType

from arrangement.drawing.views import Drawings
from arrangement.pictures.views import DRAWINGS as OF_ARRANGEMENTS
from equilibrium.pictures.views import DRAWINGS as OF_GRASPS

ROOT = Path(__file__).resolve().parent.parent
#: The stubs, each with its class and what it draws.
STUBS = {
    "arrangement/planes/drawable.pyi": ("DrawableArrangement", OF_ARRANGEMENTS),
    "equilibrium/model/drawable.pyi": ("DrawableGrasp", OF_GRASPS),
}
#: Of a line of a stub.
_WIDTH = 100
#: Options by name, each with its types, and whether it has to be given.
_Options: typing.TypeAlias = Mapping[str, tuple[Iterable[str], bool]]


class _Stub:
    """What is written: lines, and what they import."""

    def __init__(self) -> None:
        self.imports = {("arrangement.drawing.path_artist", name) for name in ("Drawing", "Room")}
        self.imports |= {("typing", name) for name in ("Literal", "overload")}
        self.lines: list[str] = []

    def text_of(self, hint: object) -> str:
        """Return a type as it is written, and import its names."""
        if hint is ...:
            return "..."
        if isinstance(hint, list):
            return f"[{', '.join(map(self.text_of, hint))}]"
        arguments = typing.get_args(hint)
        if isinstance(hint, UnionType) or typing.get_origin(hint) is typing.Union:
            return " | ".join(map(self.text_of, arguments))
        named: typing.Any = typing.get_origin(hint) or hint
        if named is type(None):
            return "None"
        if named.__module__ != "builtins":
            self.imports.add((named.__module__, named.__name__))
        inside = ", ".join(map(self.text_of, arguments))
        return f"{named.__name__}[{inside}]" if arguments else str(named.__name__)

    def options(self, view: object) -> Iterator[tuple[str, tuple[list[str], bool]]]:
        """Yield the options of a view."""
        function = inspect.unwrap(view)  # type: ignore[arg-type]
        hints = typing.get_type_hints(function)
        for option in inspect.signature(function).parameters.values():
            if option.kind is option.KEYWORD_ONLY:
                hint = hints[option.name]
                union = isinstance(hint, UnionType) or typing.get_origin(hint) is typing.Union
                parts = typing.get_args(hint) if union else [hint]
                yield option.name, ([*map(self.text_of, parts)], option.default is option.empty)

    def overload(self, view: str, options: _Options) -> None:
        """Add an overload for a view."""
        self.lines += ["    @overload", "    def draw(", "        self,", f"        {view},"]
        self.lines += ["        *,"]
        for name, (types, required) in {**options, "ax": (["Room", "None"], False)}.items():
            ordered = sorted(types, key=lambda text: text == "None")
            end = "," if required else " = ...,"
            line = f"        {name}: {' | '.join(ordered)}{end}"
            fits = len(line) <= _WIDTH
            self.lines += [line if fits else line.replace(" | ", "\n        | ")]
        self.lines.append("    ) -> Drawing: ...")

    def text(self, name: str) -> str:
        """Return the stub of a class."""
        ordered = sorted(self.imports, key=lambda x: (x[0].startswith(("arr", "equi")), *x))
        lines, own = [], False
        for module, names in groupby(ordered, key=lambda x: x[0]):
            lines += [""] * (not own and (own := module.startswith(("arr", "equi"))))
            lines.append(f"from {module} import {', '.join(x for _, x in names)}")
        head = ["# Made by `python -m tests.draw_stubs` from the views.", *lines]
        return "\n".join([*head, "", f"class {name}:", *self.lines, ""])


def stub(name: str, drawings: Drawings) -> str:
    """Return the stub of a class with the method `draw`.

    The last overload takes any view, also several, with all that some view takes.
    """
    made, of_all = _Stub(), dict[str, dict[str, None]]()
    for view in drawings.views:
        options = dict(made.options(drawings.function("view", view)))
        made.overload(f'view: Literal["{view}"]', options)
        for option, (types, _) in options.items():
            of_all.setdefault(option, {}).update(dict.fromkeys(types))
    made.overload(
        "view: str | None = ...", {option: (types, False) for option, types in of_all.items()}
    )
    return made.text(name)


if __name__ == "__main__":
    for path, (name, drawings) in STUBS.items():
        (ROOT / path).write_text(stub(name, drawings), encoding="utf-8")
