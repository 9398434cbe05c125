"""What ``equilibrium resisted`` prints of a load on a grasp in space: samples and boundaries."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING

from arrangement.console.number_form import bracket, counted, number
from equilibrium.model.labels import AS_ROUNDED

from .arguments import show

if TYPE_CHECKING:
    from equilibrium.decide.assemblies.ends import Giving
    from equilibrium.wrench_sets.spatial import SpatialMagnitudes


def show_in_space(arguments: argparse.Namespace, magnitudes: SpatialMagnitudes) -> int:
    """Print the magnitudes tried, and the boundaries between them."""
    yes = {"resisted": True, "not resisted": False}.get(magnitudes.verdict)
    gives = magnitudes.what_gives()
    lines, document = list(_border_lines(magnitudes, gives)), magnitudes.to_dict()
    document["gives"] = [given and given.to_dict() for given in gives]
    if magnitudes.grasp.data_error is not None:
        document["as_rounded"] = True
    if (nearby := magnitudes.within_error()) is not None:
        document["within_error"] = [near.to_dict() for near in nearby]
        for near in nearby:
            lines.append(f"at {number(near.t)}: {near.rounding.words}")
    return show(arguments, document, lines, yes, magnitudes.grasp)


def _border_lines(found: SpatialMagnitudes, gives: Sequence[Giving | None]) -> Iterator[str]:
    runs = [list(run) for _, run in groupby(found.samples, key=itemgetter(1))]
    known = ", ".join(f"{run[0][1]} at {_samples(run)}" for run in runs)
    tried = counted(len(found.samples), "magnitude")
    yield f"{tried} t tried from 0 to {number(found.samples[-1][0])}: {known}"
    doubt = "" if found.grasp.data_error is None else f", {AS_ROUNDED}"
    if found.zero_only:
        yield f"resisted at 0 only{doubt}"
        return
    for border, given in zip(found.borders, gives, strict=True):
        order = "resisted, then not" if border.resisted < border.refused else "not, then resisted"
        place = f"{number(border.resisted)} exactly" if border.exact else bracket(*border.ends)
        line = f"{order}: the boundary is {place}"
        left = len(border.undecided)
        yield line + (f"; {left} undecided between them" if left else "")
        if given is not None:
            yield f"  in an equilibrium at {number(border.resisted)}: {given.words}"
    for a, b in found.gaps:
        yield f"a gap: not resisted from {number(a.refused)} to {number(b.refused)}"
    yield f"other t, between these and beyond, are not covered: the verdict may change there{doubt}"


def _samples(run: Sequence[tuple[Fraction, str]]) -> str:
    """Return which magnitudes of a run of samples there are: "0", "each from 2 to 16"."""
    low, high = run[0][0], run[-1][0]
    return number(low) if low == high else f"each from {number(low)} to {number(high)}"
