"""The verdict on a grasp in space, in words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import DIGITS, counted, number, vector
from arrangement.numbers.exact import RationalVector, dot
from equilibrium.certificate.leaves import SpatialLeaf, spatial_leaves
from equilibrium.certificate.reading import read_plane
from equilibrium.model.pyramid import pyramid_words

if TYPE_CHECKING:
    from equilibrium.decide.spatial_verdict import SpatialVerdict


#: Longer proofs are only counted.
_MOST = 3


def spatial_lines(found: SpatialVerdict) -> Iterator[str]:
    """Yield the verdict, and the equilibrium or the proof in short."""
    cones = pyramid_words(found.pyramid, before=", with ") + str(found.within)
    if not found.decided:
        yield (
            f"undecided{cones}: neither an equilibrium nor a proof that there is none; "
            f"{found.reason}"
        )
        yield f"best motion found: {found.residual:.2g} of the largest force is left over"
        return
    if found.solution is None:
        leaves = found.verify().leaves
        tree = found.certificate.to_dict()["tree"] if found.certificate else []
        where = " in the plane of the contacts" if read_plane(tree) else ""
        yield f"not resisted{cones}: proof{where} with {counted(leaves, 'leaf', 'leaves')}"
        if leaves <= _MOST:
            for leaf in spatial_leaves(found.grasp, tree, found.within):
                yield from _leaf_lines(found.wrench, leaf)
        return
    from equilibrium.space.equilibria import SpatialSolution

    exact = isinstance(found.solution, SpatialSolution)
    yield f"resisted{cones}: " + (
        "an exact equilibrium" if exact else "exactly one equilibrium lies in a box of intervals"
    )
    if not isinstance(found.solution, SpatialSolution) and found.solution.idle:
        yield "  (but for motions that no attached contact feels, as a turn about the line of two)"
    shown: Any = vector if exact else _floats
    yield f"  motion {shown(found.solution.motion)}"
    forces = zip(found.states, found.solution.forces, strict=True)
    for i, (state, force) in enumerate(forces, 1):
        yield f"    contact {i}  {state:<8}  force {shown(force)}"


def _leaf_lines(wrench: RationalVector, leaf: SpatialLeaf) -> Iterator[str]:
    states = ", ".join(f"contact {i + 1} {words}" for i, words in sorted(leaf.states.items()))
    yield f"  {states or 'whatever the contacts do'}:"
    yield f"    on the virtual motion {vector(leaf.motion)} the load does work"
    work = number(dot(wrench, leaf.motion))
    yield f"    {work}, and all contacts together at least {number(leaf.least)}"


def _floats(numbers: Any) -> str:
    return f"(≈{', ≈'.join(f'{x:.{DIGITS}g}' for x in numbers)})"
