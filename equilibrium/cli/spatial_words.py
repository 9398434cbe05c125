"""The verdict on a grasp in space, in words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from arrangement.number_form import DIGITS, vector

if TYPE_CHECKING:
    from equilibrium.spatial_verdict import SpatialVerdict


def spatial_lines(found: SpatialVerdict) -> Iterator[str]:
    """Yield the verdict, and the equilibrium or the proof in short."""
    if not found.decided:
        yield f"undecided: neither an equilibrium nor a proof that there is none; {found.reason}"
        yield f"best motion found: {found.residual:.2g} of the largest force is left over"
        return
    if found.solution is None:
        leaves = found.verify().leaves
        yield f"not resisted: proof with {leaves} {'leaf' if leaves == 1 else 'leaves'}"
        return
    from equilibrium.solver.space.equilibria import SpatialSolution

    exact = isinstance(found.solution, SpatialSolution)
    yield "resisted: " + (
        "an exact equilibrium" if exact else "exactly one equilibrium lies in a box of intervals"
    )
    shown: Any = vector if exact else _floats
    yield f"  motion {shown(found.solution.motion)}"
    forces = zip(found.states, found.solution.forces, strict=True)
    for i, (state, force) in enumerate(forces, 1):
        yield f"    contact {i}  {state:<8}  force {shown(force)}"


def _floats(numbers: Any) -> str:
    return f"(≈{', ≈'.join(f'{x:.{DIGITS}g}' for x in numbers)})"
