"""The claims of the paper: `claims.toml` has their words, modules the functions that check them.

A claim is in the module that its `topic` names, in the tuple CLAIMS. The words are read without
these modules, so that listing claims is quick, and a claim is made when it is asked for.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache, partial
from importlib import import_module
from importlib.resources import files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from proofs_check.statements.statement import Claim, Registry


def registry() -> Registry:
    """Return a new registry with every claim of the package, in the order of the paper."""
    from proofs_check.statements.statement import Registry

    return Registry(later={id: partial(_claim, id) for id in entries()})


def _claim(id: str) -> Claim:
    _, words = entries()[id]
    claims: tuple[Claim, ...] = import_module(f"{__name__}.{words['topic']}").CLAIMS
    return next(claim for claim in claims if claim.id == id)


def paper() -> dict[str, str]:
    """Return title and source of the paper that the claims are about."""
    return {"title": plain(_document()["title"]), "about": plain(_document()["source"])}


@cache
def entries() -> Mapping[str, tuple[str, dict[str, Any]]]:
    """Return the heading and the words of each claim, by its id, in the paper's order."""
    return {
        id: (heading, {**words, "section": heading})
        for number, title in _document()["sections"].items()
        for heading in [title if number == "beyond" else f"{number}. {title}"]
        for id, words in _document()[number].items()
    }


def plain(text: str) -> str:
    """Return a text with single spaces."""
    return " ".join(text.split())


@cache
def _document() -> dict[str, Any]:
    return tomllib.loads(files(__package__).joinpath("claims.toml").read_text(encoding="utf-8"))
