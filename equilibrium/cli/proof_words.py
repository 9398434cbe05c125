"""A verdict on a grasp in space, and a short proof that a wrench is not resisted, in words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import DIGITS, counted, number, vector
from arrangement.numbers.exact import RationalVector, dot
from equilibrium.certificate.leaves import SpatialLeaf, spatial_leaves
from equilibrium.certificate.reading import read_plane
from equilibrium.model.contact import pyramid_words

if TYPE_CHECKING:
    from equilibrium.certificate.leaves import ClosedPart
    from equilibrium.decide.spatial_verdict import SpatialVerdict
    from equilibrium.decide.verdict import Verdict


#: Longer proofs are only counted.
_MOST = 3


def proof_lines(verdict: Verdict, path: str | None = None) -> Iterator[str]:
    """Yield the cases of the proof of a "no" if they are few, else the number of its leaves.

    Args:
        path: where the certificate was written, if it was.
    """
    from equilibrium.certificate.leaves import parts, works

    found = list(parts(verdict.certificate.to_dict()))
    cases = _cases(found)
    if not 0 < len(cases) <= _MOST:
        where = f", in {path}" if path else "; --certificate OUT.json writes it"
        yield f"proof: {len(found)} leaves{where}"
        return
    yield f"proof{verdict.within}: whatever the contacts do, no forces balance"
    for where, together in cases.items():
        done = works(verdict.grasp, verdict.wrench, together, verdict.within)
        yield (
            f"  {where}on the virtual motion {vector(together[0].leaf.motion)} the load does work "
            f"{number(done.load)}, the contacts at least {number(done.least)}"
        )
        for i, factor in enumerate(done.factors, 1):
            work = "none" if factor is None else f"at least {number(factor)} times its normal force"
            yield f"    contact {i}  {work}"


def _cases(found: list[ClosedPart]) -> dict[str, list[ClosedPart]]:
    """Return the parts by conditions in words; none if they cannot be told in signs and states.

    Orthants with one virtual motion are one case if they fill the part with their common signs.
    """
    groups: dict[Any, list[ClosedPart]] = {}
    for part in found:
        if any(sum(map(abs, g)) > 1 for g in part.region):
            return {}
        groups.setdefault((part.leaf.motion, *part.states.items()), []).append(part)
    cases = {}
    for (_, *states), together in groups.items():
        words = []
        for axis, name in enumerate("xyr", 1):
            signs = {sum(g[axis] for g in part.region) for part in together} - {0}
            words += [f"{name} {'>=' if max(signs) > 0 else '<='} 0"] if len(signs) == 1 else []
        if len(together) != (1 if len(together[0].region) == 7 else 2 ** (3 - len(words))):
            return {}
        words += [f"contact {i + 1} {state}" for i, state in states]
        cases[f"{', '.join(words)}: " if words else ""] = together
    return cases


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
