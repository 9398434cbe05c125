"""The distribution slipstates has three packages, and this module says where things are.

arrangement     hyperplane arrangements: Arrangement, read_arrangement, families, census
equilibrium     frictional grasps: Contact, Grasp, solve, ResistedSet, read_grasp, verify
proofs_check    claims: claim, family, evaluate, registry

The commands are ``arrangement``, ``equilibrium`` and ``proofs-check``. ``help(arrangement)`` and so
on list the names of a package; a name that is asked of this module is answered with its package.
"""

from __future__ import annotations

import sys

import arrangement as arrangement
import equilibrium as equilibrium
import proofs_check as proofs_check
from arrangement import __version__ as __version__
from arrangement.console.plugins import to_importer

__all__ = ["arrangement", "equilibrium", "proofs_check"]


def __getattr__(name: str) -> object:
    for package in (arrangement, equilibrium, proofs_check):
        if name in dir(package):
            where = package.__name__
            text = f"{name} is in {where}: from {where} import {name}"
            break
    else:
        text = (
            f"module 'slipstates' has no attribute {name!r}; help(slipstates) says where things are"
        )
    raise to_importer(AttributeError(text, name=name), sys._getframe(1))


if __name__ == "__main__":
    print(__doc__)
