"""What the colours, lines and signs of a picture mean: entries placed when it is written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from .items import Item


class Key(NamedTuple):
    """A symbol and what it means.

    Attributes:
        symbol: items whose left end, at half their height, is at (0, 0).
        width: of the symbol, in points.
        text: its meaning.
    """

    symbol: Sequence[Item]
    width: float
    text: str


@dataclass
class Legend:
    """The entries, in their order.

    Attributes:
        lines: of text, and whether they are emphatic; emphatic ones stand above the keys.
        keys: symbols with their meanings.
        table: short texts, read column by column.
        captions: what is said of the picture even where it has no legend.
    """

    lines: list[tuple[str, bool]] = field(default_factory=list)
    keys: list[Key] = field(default_factory=list)
    table: list[str] = field(default_factory=list)
    captions: list[str] = field(default_factory=list)

    def line(self, text: str, emphasis: bool = False) -> None:
        """Add a line of text."""
        self.lines.append((text, emphasis))

    def key(self, symbol: Symbol, text: str) -> None:
        """Add a symbol and what it means."""
        self.keys.append(Key(*symbol, text))

    def extend(self, other: Legend) -> None:
        """Add the entries of another one."""
        for name in ("lines", "keys", "table", "captions"):
            getattr(self, name).extend(getattr(other, name))


#: The items and the width of a symbol.
Symbol = tuple[Sequence[Item], float]
