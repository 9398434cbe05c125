"""The claims of the paper: `claims.toml` has their words, modules the functions that check them.

Each module has a tuple CLAIMS; `registry` collects them in the order of the paper. The words are
read without them, so that listing claims is quick.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from importlib.resources import files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from proofs_check.statements.statement import Registry

#: Modules of this package.
TOPICS = "counting dual sphere model tables equations methods space others"


def registry() -> Registry:
    """Return a new registry with every claim of the package, in the order of the paper."""
    from proofs_check.statements.statement import Registry

    modules = [import_module(f"{__name__}.{topic}") for topic in TOPICS.split()]
    claims = {claim.id: claim for module in modules for claim in module.CLAIMS}
    return Registry(claims[id] for _, id, _ in entries())


def paper() -> dict[str, str]:
    """Return title and source of the paper that the claims are about."""
    return {"title": plain(_document()["title"]), "about": plain(_document()["source"])}


def entries() -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Yield the heading, the id and what `claims.toml` has of each claim, in the paper's order."""
    for number, title in _document()["sections"].items():
        heading = title if number == "beyond" else f"{number}. {title}"
        for id, said in _document()[number].items():
            yield heading, id, said


def plain(text: str) -> str:
    """Return a text with single spaces."""
    return " ".join(text.split())


@cache
def _document() -> dict[str, Any]:
    return tomllib.loads(files(__package__).joinpath("claims.toml").read_text(encoding="utf-8"))
