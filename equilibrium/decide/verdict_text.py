"""The text of a verdict: equilibria, or a short proof that a wrench is not resisted."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import counted, near, number, vector
from arrangement.numbers.exact import dot
from equilibrium.certificate.leaves import parts, spatial_leaves, works
from equilibrium.certificate.reading import read_plane
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import pyramid_words
from equilibrium.model.displacement import STIFFNESS_ASSUMED, displacement_words, has_unit
from equilibrium.model.errors import UndecidedError
from equilibrium.model.labels import equilibria_words, force_lines
from equilibrium.model.solution import PadForce, numbering_words

if TYPE_CHECKING:
    from equilibrium.certificate.leaves import ClosedPart
    from equilibrium.model.grasp import Grasp
    from equilibrium.model.solution import Solution
    from equilibrium.plane.states.equilibrium import Equilibrium

    from .verdict import Verdict

#: Longer proofs are only counted.
_MOST = 3
_UNFELT = "that no attached contact feels"
#: Why rigid bodies hold, and springs do not.
_SQUEEZED = "forces in the friction cones balance the wrenches, and no displacement gives them"


def with_rounding(verdict: Verdict, lines: list[str]) -> tuple[list[str], bool | None]:
    """Return the lines of an answer, with what is known of rounded data; and yes, no or neither.

    What is not proved for all data within the rounding error comes first.
    """
    yes, known = verdict.stable if verdict.decided else None, verdict.rounding
    if known is None:
        return lines, yes
    if known.proved or not verdict.decided:
        return [*lines, *known.lines()], yes
    stated = [*known.lines(), f"for the data as rounded: {lines[0]}", *lines[1:]]
    return stated, yes if known.turned is None else None


def verdict_lines(
    verdict: Verdict, every: bool | None = None, path: str | None = None
) -> Iterator[str]:
    """Yield the answer, its equilibria or the proof that there is none, and warnings.

    Args:
        every: see `Verdict.to_dict`.
        path: where the certificate was written, if it was.
    """
    if isinstance(verdict.subject, Assembly):
        yield from _body_lines(verdict, every)
        return
    about = pyramid_words(verdict.pyramid, before=", with ")
    about += displacement_words(verdict.max_displacement)
    solution = verdict.solution
    if not verdict.decided:
        yield f"undecided{about}: {verdict.reason}; no equilibrium and no proof was found"
        yield f"best motion found: {verdict.residual:.2g} of the largest force is left over"
    elif solution is None:
        yield from _refusal(verdict, about, path)
    elif verdict.lists_all(every):
        yield from piece_lines(verdict.equilibria, verdict.grasp, verdict.max_displacement)
    else:
        how = (
            "the equilibrium found is below; there may be others, and --all lists them"
            if verdict.grasp.dimension == 2
            else "an exact equilibrium"
            if solution.box is None
            else "exactly one equilibrium lies in a box of intervals"
        )
        yield f"resisted{about}: {how}"
        if solution.box is not None and solution.box.idle:
            yield f"  (but for motions {_UNFELT}, as a turn about the line of two)"
        yield from _equilibrium_lines(verdict.grasp, solution, verdict.states)
    if path and verdict.grasp.has_pads:
        yield numbering_words(verdict.grasp.groups)
    yield from verdict.warnings
    says_motion = solution is not None or verdict.max_displacement is not None
    if says_motion and not has_unit(verdict.grasp):
        yield STIFFNESS_ASSUMED


def piece_lines(
    pieces: Sequence[Equilibrium], grasp: Grasp, max_displacement: Fraction | None = None
) -> Iterator[str]:
    """Yield what is said of all equilibria in the plane."""
    about = displacement_words(max_displacement)
    if not pieces:
        yield f"not resisted{about}: no contact state admits an equilibrium"
        return
    yield f"resisted{about}: {equilibria_words(pieces)}"
    for piece in pieces:
        freedom = "(of least norm; neither motion nor forces need be determined)"
        if piece.forces_determined:
            freedom = "(of least norm; the forces are determined, the motion is not)"
        more = "" if piece.unique else f"  {freedom}"
        yield from _equilibrium_lines(grasp, piece, piece.states, more)


def _equilibrium_lines(
    grasp: Grasp, equilibrium: Equilibrium | Solution, states: Iterable[str], freedom: str = ""
) -> Iterator[str]:
    rounded = getattr(equilibrium, "box", None) is not None
    shown = _floats if rounded else vector
    yield f"  motion {shown(equilibrium.motion)}{freedom}"
    named, rows = list(states), []
    for i, (points, group) in enumerate(zip(grasp.parts, grasp.groups, strict=True), 1):
        kinds = named[group.start : group.stop]
        # A pad is one contact: the sum of the forces of its points, and where it acts.
        whole = PadForce.of(points, equilibrium.forces[group.start : group.stop])
        at = f" at {shown(whole.at)}" if len(points) > 1 and whole.at else ""
        at += f", torque {shown((whole.torsion,))}" if at and whole.torsion else ""
        moves = any(dot(row, equilibrium.motion) for c in points for row in c.tangential_wrenches)
        still = all(kind.startswith("slip") for kind in kinds) and not moves
        why = "  (not slipping: at the edge of its cone)" if still else ""
        state = kinds[0] if len({*kinds}) == 1 else " ".join(kinds)
        stuck = sum(c.adhesion for c in points)
        more = f"  adhesion {number(stuck)}" if stuck else ""
        normal, *friction = whole.force
        across = shown(friction) if len(friction) > 1 else shown(friction)[1:-1]
        cells = f"contact {i}", state, shown((normal,))[1:-1], across
        rows.append((cells, f"{at}{more}{why}"))
    yield from force_lines(rows, grasp.units)


def _refusal(verdict: Verdict, about: str, path: str | None) -> Iterator[str]:
    if verdict.grasp.dimension == 2:
        yield from piece_lines((), verdict.grasp, verdict.max_displacement)
        yield from _proof_lines(verdict, path)
        return
    leaves, names = verdict.verify().leaves, verdict.grasp.point_names
    where = " in the plane of the contacts" if read_plane(verdict.proof["tree"]) else ""
    yield f"not resisted{about}: proof{where} with {counted(leaves, 'leaf', 'leaves')}"
    for leaf in spatial_leaves(verdict.proof) if leaves <= _MOST else ():
        states = ", ".join(f"{names[i]} {words}" for i, words in sorted(leaf.states.items()))
        yield f"  {states or 'for all contact forces'}:"
        yield f"    on the virtual motion {vector(leaf.motion)} the load does work"
        work = number(dot(verdict.wrench, leaf.motion))
        yield f"    {work}, and all contacts together at least {number(leaf.least)}"


def _proof_lines(verdict: Verdict, path: str | None) -> Iterator[str]:
    """Yield the cases of the proof of a "no" if they are few, else the number of its leaves."""
    closed = list(parts(verdict.proof))
    names = verdict.grasp.point_names
    cases = _cases(closed, names)
    if not 0 < len(cases) <= _MOST:
        where = f", in {path}" if path else "; --certificate OUT.json writes it"
        yield f"proof: {counted(len(closed), 'leaf', 'leaves')}{where}"
        return
    about = displacement_words(verdict.max_displacement)
    loads = "the load and adhesion do" if any(verdict.grasp.adhesion_wrench) else "the load does"
    yield f"proof{about}: no contact forces in the friction cones balance the load"
    for where, together in cases.items():
        done = works(verdict.grasp, verdict.wrench, together, verdict.max_displacement)
        yield (
            f"  {where}on the virtual motion {vector(together[0].leaf.motion)} {loads} work "
            f"{number(done.load)}, the contacts at least {number(done.least)}"
        )
        for i, factor in enumerate(done.factors):
            work = "none" if factor is None else f"{number(factor)} of its normal force"
            yield f"    least work at {names[i]}: {work}"


def _cases(closed: list[ClosedPart], names: Sequence[str]) -> dict[str, list[ClosedPart]]:
    """Return the parts by conditions in words; none if they cannot be told in signs and states.

    Orthants with one virtual motion are one case if they fill the part with their common signs.
    """
    groups: dict[Any, list[ClosedPart]] = {}
    for part in closed:
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
        words += [f"{names[i]} {state}" for i, state in states]
        cases[f"{', '.join(words)}: " if words else ""] = together
    return cases


def _body_lines(verdict: Verdict, every: bool | None) -> Iterator[str]:
    """Yield the answer for an assembly: the reason, or motions and forces."""
    within = displacement_words(verdict.max_displacement)
    if verdict.solution is None:
        proof = within
        if verdict.decided:
            proof += f"; proof with {counted(verdict.verify().leaves, 'leaf', 'leaves')}"
        yield f"{verdict.verdict}: {verdict.reason}{proof}"
        if verdict.decided and verdict.balances_rigidly:
            yield f"rigid bodies would hold: {_SQUEEZED}"
        return
    yield f"resisted{within}: an exact equilibrium"
    yield from (f"  {name} moves by {vector(moved)}" for name, moved in verdict.motions.items())
    joints, rows = verdict.assembly.contacts, []
    triples = zip(joints, verdict.states, verdict.forces, strict=True)
    for i, (c, state, force) in enumerate(triples, 1):
        stuck = c.contact.adhesion
        cells = f"contact {i}", c.pair, state, *map(number, force)
        rows.append((cells, f"  adhesion {number(stuck)}" if stuck else ""))
    yield from force_lines(rows, verdict.assembly.units, "bodies")
    try:
        families = verdict.equilibria if every else ()
    except UndecidedError as unknown:
        yield f"all equilibria: undecided, {unknown}"
        return
    for part in families:
        numbers = ", ".join(str(i + 1) for i in part[0].contacts)
        many = counted(len(part), "family", "families")
        yield f"  contacts {numbers}: {many} of equilibria"
        for piece in part:
            forces = "unique" if piece.unique else "not unique"
            yield f"    {' '.join(piece.states)}  (contact forces {forces})"


def _floats(numbers: Iterable[Fraction]) -> str:
    return f"({', '.join(map(near, numbers))})"
