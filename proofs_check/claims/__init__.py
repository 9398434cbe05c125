"""The claims of the paper, one module for each topic; `registry` collects them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from importlib import import_module
from itertools import chain

from proofs_check.statements.statement import Claim, Registry

#: The paper that the claims are about.
TITLE = (
    "Passive Static Equilibrium with Frictional Contacts and Application to Grasp Stability "
    "Analysis"
)
SOURCE = (
    "M. Haas-Heger, C. Papadimitriou, M. Yannakakis, G. Iyengar, M. Ciocarlie. "
    "Robotics: Science and Systems, 2018"
)
#: Its sections in order; "" stands for what goes beyond it.
SECTIONS: Mapping[str, str] = {
    "II": "Related work",
    "III": "Passive equilibrium formulation",
    "IV": "Number of possible slip states",
    "V": "Complete equilibrium determination",
    "VI": "Results",
    "": "Beyond the paper",
}
#: The section of what a locator names instead of one.
_PLACES = {"Table": "VI", "Eq. 11": "IV", "Eq": "III", "Algorithm 2": "V", "our": "", "the": ""}

#: Modules of this package, in order within a section; each has a tuple CLAIMS.
TOPICS: tuple[str, ...] = (
    "planes.counting",
    "planes.dual",
    "planes.steps",
    "planes.types",
    "planes.sphere",
    "forces.model",
    "forces.tables",
    "forces.equations",
    "forces.directions",
    "forces.methods",
    "forces.certificates",
    "forces.space",
    "planes.families",
    "forces.modes",
)


def section(locator: str) -> str:
    """Return the number of the section of the paper that a locator begins with, or ""."""
    if found := re.match(r"Section ([IV]+)", locator):
        return found[1]
    return next(number for start, number in _PLACES.items() if locator.startswith(start))


def registry() -> Registry:
    """Return a new registry with every claim of the package, in the order of the paper."""
    modules = [import_module(f"{__name__}.{topic}") for topic in TOPICS]
    by_section: dict[str, list[Claim]] = {number: [] for number in SECTIONS}
    for module in modules:
        for claim in module.CLAIMS:
            number = section(claim.locator)
            heading = f"{number}. {SECTIONS[number]}".removeprefix(". ")
            by_section[number].append(replace(claim, section=heading))
    return Registry(chain.from_iterable(by_section.values()))
