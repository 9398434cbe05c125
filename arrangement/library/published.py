"""Numbers of regions of named arrangements as they stand in print: data to compare with.

They are in the file ``published.toml``. Nothing computes them here, and no engine reads them.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

from arrangement.arrangement import Arrangement

from . import families


@dataclass(frozen=True)
class PublishedCount:
    """The number of regions of one member of a family, and where it is printed."""

    family: str
    arguments: tuple[Any, ...]
    regions: int
    source: str
    options: tuple[tuple[str, Any], ...] = ()

    @property
    def label(self) -> str:
        """The call that makes the arrangement."""
        words = [*map(repr, self.arguments), *(f"{k}={v!r}" for k, v in self.options)]
        return f"{self.family}({', '.join(words)})"

    def planes(self) -> Arrangement:
        """Return the arrangement itself."""
        made: Arrangement = getattr(families, self.family)(*self.arguments, **dict(self.options))
        return made


def published_counts() -> Iterator[PublishedCount]:
    """Yield every number, family by family.

    >>> next(entry.regions for entry in published_counts() if entry.label == "coxeter('E8')")
    696729600
    """
    text = files(__package__).joinpath("published.toml").read_text(encoding="utf-8")
    for entry in tomllib.loads(text)["counts"]:
        numbered = enumerate(entry.get("numbers", ()), entry.get("first", 0))
        options = tuple(entry.get("options", {}).items())
        for arguments, regions in entry.get("rows", [([n], regions) for n, regions in numbered]):
            yield PublishedCount(
                entry["family"], tuple(arguments), regions, entry["source"], options
            )
