"""What mutation testing changes, with the tests that are to notice it (see `mutants`).

The table is `mutant_targets.toml`.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Target(NamedTuple):
    """A module, the tests that cover it, fast ones first, and how many mutants to run (0: all)."""

    module: str
    tests: tuple[str, ...]
    sample: int = 0

    @property
    def path(self) -> Path:
        """The file of the module."""
        return ROOT / Path(*self.module.split(".")).with_suffix(".py")


_TABLE: dict[str, dict[str, Any]] = tomllib.loads(
    Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
)


def _tests(words: str) -> Iterator[str]:
    for word in words.split():
        if word in _TABLE["lists"]:
            yield from _tests(_TABLE["lists"][word])
        else:
            file, colons, part = word.partition("::")
            yield f"tests/{file}.py{colons}{part}"


#: Mutants that are run of a module in the second part of the table.
SAMPLE = 12
TARGETS = {
    name: Target(module, tuple(_tests(words)), *sample)
    for name, (module, words, *sample) in _TABLE["targets"].items()
} | {
    module.partition(".")[2]: Target(module, tuple(_tests(words)), SAMPLE)
    for module, words in _TABLE["sampled"].items()
}

#: Packages whose modules decide an answer.
DECIDING = (
    *(f"arrangement.{name}" for name in ("counts", "duals", "enumeration", "numbers", "planes")),
    *(
        f"equilibrium.{name}"
        for name in ["certificate", "core", "decide", "methods", "model", "plane", "wrench_sets"]
    ),
    *(f"proofs_check.{name}" for name in ("routes", "statements", "sweep")),
)
#: Modules of these that are not a target, and why.
EXCEPTIONS: dict[str, str] = _TABLE["exceptions"]
