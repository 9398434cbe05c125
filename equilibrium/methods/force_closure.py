"""Force closure: whether forces inside the friction cones can balance every wrench.

In the plane cones have two edges, in space they are round, and both are decided with a proof that
`equilibrium.certificate.law` checks exactly. The wrenches of the contacts have to span space,
and forces have to balance ``w = sum N_i``, the wrench of a unit push along each normal: with these
pushes they are strictly inside the cones. In space a cone program in floats looks for such forces,
or for a motion that shows there are none, and what it finds is made exact; otherwise pyramids
inside and around the cones are tried. What all leave open, close to the boundary, is undecided.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.numbers.exact import RationalVector, dot, primitive, to_text
from arrangement.numbers.linear.rank import cut, unit_vectors
from equilibrium.certificate.law import closure_problem, escape_problem
from equilibrium.methods.springs import Forces
from equilibrium.model.errors import UndecidedError
from equilibrium.model.grasp import Grasp

from .round_cones import ConeVerdict, balanced


@dataclass(frozen=True)
class ForceClosure:
    """Whether every wrench is balanced by forces inside the cones, with a proof either way.

    Attributes:
        accepts: None where it is undecided; only in space, close to the boundary.
        forces: with closure, forces (normal, along the tangents) that balance each other, strictly
            inside all cones of contacts whose wrenches span space.
        free_motion: without closure, a motion d != 0 on which no force inside any cone does
            negative work: ``N . d >= friction |T d|`` for all contacts.
    """

    accepts: bool | None
    forces: Forces | None = None
    free_motion: RationalVector | None = None

    def __bool__(self) -> bool:
        if self.accepts is None:
            raise UndecidedError(
                "force closure is undecided: the grasp is close to its boundary; ask for .accepts, "
                "which is None"
            )
        return self.accepts

    @property
    def words(self) -> str:
        """The answer in a few words."""
        if self.accepts is None:
            return "force closure undecided"
        return f"{'' if self.accepts else 'no '}force closure"

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form: true, false or null, with the numbers of the proof as strings."""
        document: dict[str, Any] = {"force_closure": self.accepts}
        if self.forces is not None:
            document["balanced_forces"] = [list(map(to_text, force)) for force in self.forces]
        if self.free_motion is not None:
            document["free_motion"] = list(map(to_text, self.free_motion))
        return document


def force_closure(grasp: Grasp, *, pyramids: bool = True) -> ForceClosure:
    """Decide force closure with the cones of the grasp, in space round ones.

    Springs, preloads and adhesion play no part: a constant pull changes no cone.

    Args:
        pyramids: whether in space pyramids are tried where the cone program is inconclusive; of
            many contacts that takes long.

    Raises:
        MissingExtraError: in space, where a cone program has to decide and is not installed.

    >>> from equilibrium import read_grasp
    >>> bool(force_closure(read_grasp("three-fingers-on-a-ball")))
    True
    >>> [str(x) for x in force_closure(read_grasp("two-opposed-fingers")).free_motion]
    ['0', '0', '0', '1', '0', '0']
    """
    for proof in _proofs(grasp, pyramids):
        if proof.forces is not None and not closure_problem(grasp, proof.forces):
            return proof
        if proof.free_motion is not None and not escape_problem(grasp, proof.free_motion):
            return proof
    return ForceClosure(None)


def _proofs(grasp: Grasp, pyramids: bool) -> Iterator[ForceClosure]:
    """Yield what may be a proof, from the cheapest on."""
    unfelt = unfelt_motion(grasp)
    if unfelt is not None:
        yield ForceClosure(False, free_motion=unfelt)
        return
    columns = zip(*(contact.normal_wrench for contact in grasp), strict=True)
    load = tuple(sum(column, Fraction(0)) for column in columns)
    try:
        if grasp.dimension == 3:
            from .closure_search import ClosureSearch

            search = ClosureSearch(grasp, load)
            yield ForceClosure(False, free_motion=search.motion())
            yield from (ForceClosure(True, forces) for forces in search.forces())
            yield ForceClosure(False, free_motion=search.boundary_motion())
    except ImportError:
        # Pyramids need no extra, and decide most grasps.
        yield _with_pushes(balanced(grasp, load))
        raise
    if pyramids or grasp.dimension == 2:
        yield _with_pushes(balanced(grasp, load))


def unfelt_motion(grasp: Grasp) -> RationalVector | None:
    """Return a motion on which no force of the contacts does work; None if there is none."""
    basis = unit_vectors(grasp.wrench_size)
    for contact in grasp:
        rubbing = contact.tangential_wrenches if contact.friction else ()
        for wrench in (contact.normal_wrench, *rubbing):
            values = [dot(primitive(wrench), motion) for motion in basis]
            basis = cut(basis, values) if any(values) else basis
    return tuple(map(Fraction, basis[0])) if basis else None


def _with_pushes(verdict: ConeVerdict) -> ForceClosure:
    """Return the closure that a verdict on the sum of unit pushes shows."""
    forces = verdict.forces
    if forces is not None:
        forces = tuple((normal + 1, *friction) for normal, *friction in forces)
    return ForceClosure(verdict.accepts, forces, verdict.separating_motion)
