"""The claims of the paper, one module for each topic; `registry` collects them."""

from __future__ import annotations

from importlib import import_module

from proofs_check.statement import Registry

#: Modules of this package in the order of the report; each has a tuple CLAIMS.
TOPICS: tuple[str, ...] = (
    "counting",
    "dual",
    "steps",
    "types",
    "sphere",
    "model",
    "tables",
    "equations",
    "directions",
    "methods",
    "certificates",
    "families",
)


def registry() -> Registry:
    """Return a new registry with every claim of the package."""
    modules = [import_module(f"{__name__}.{topic}") for topic in TOPICS]
    return Registry(claim for module in modules for claim in module.CLAIMS)
