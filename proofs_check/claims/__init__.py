"""The claims of the paper: `claims.toml` has their words, modules the functions that check them.

Each module has a tuple CLAIMS; `registry` collects them in the order of the paper.
"""

from __future__ import annotations

from importlib import import_module

from proofs_check.statements.statement import Registry

from .parts import paper as paper, words

#: Modules of this package.
TOPICS = "counting dual sphere model tables equations methods space others"


def registry() -> Registry:
    """Return a new registry with every claim of the package, in the order of the paper."""
    modules = [import_module(f"{__name__}.{topic}") for topic in TOPICS.split()]
    claims = {claim.id: claim for module in modules for claim in module.CLAIMS}
    return Registry(claims[id] for id in words())
