"""The model as printed in the paper, each deviation from the full model a switch of its own.

[HaasHeger2018] prints a model and an algorithm that its own result tables do not follow in every
point. Here each point can be switched on alone, to show what it changes. With no option the answer
is that of `solve`. No certificate comes with these answers: they are for comparison.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Any

from arrangement.console.number_form import ReprMixin
from arrangement.console.progress import watched
from arrangement.enumeration.paper_steps import ask_steps, published_enumeration
from arrangement.numbers.exact import RationalVector, to_text
from arrangement.planes.faces import Face
from equilibrium.core.contact_law import ContactState, LinearQuestion, State
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.model.rows import ContactRows
from equilibrium.model.solution import pad_entries
from equilibrium.plane.states.contact_states import DETACHED, States, states_of_code
from equilibrium.plane.states.equilibrium import Equilibrium, equilibrium_of, maximal

#: Each option with what it takes over from the printed text.
OPTIONS = {
    "detachment": "Eqs. 2 and 4 as equalities: no contact may let go",
    "preload": "Eq. 4 as printed carries no preload: every preload counts as 0",
    "signs": "Eqs. 1 and 4 in one frame (outward normals): friction then pulls along the slip",
    "cell-check": "Algorithm 2 never checks that d lies in the slip state's own cell",
    "all-stick": "the enumeration does not list the state in which all contacts stick, d = 0",
    "coincident-planes": "Steps 1 to 3 without merging coincident planes",
    "single-solution": "Algorithm 2 stops at the first solution, as if it were the only one",
}


@dataclass(frozen=True, repr=False)
class PrintedVerdict(ReprMixin):
    """The answer of the model as printed in the paper.

    Attributes:
        grasp, wrench: the question as asked (the option "preload" does not change it).
        options: the deviations that were switched on, in the order of `OPTIONS`.
        equilibria: as in `Verdict`, under the conditions of this reading.
    """

    grasp: Grasp
    wrench: RationalVector
    options: tuple[str, ...]
    equilibria: tuple[Equilibrium, ...]

    @property
    def stable(self) -> bool:
        """Whether this reading finds an equilibrium."""
        return bool(self.equilibria)

    def __bool__(self) -> bool:
        """Return whether this reading finds an equilibrium."""
        return self.stable

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; numbers are strings of rationals."""
        grasp = self.grasp
        return {
            "stable": self.stable,
            "literal": list(self.options),
            "equilibria": [
                piece.to_dict() | pad_entries(grasp.groups, grasp.contacts, piece.forces)
                for piece in self.equilibria
            ],
            "wrench": [to_text(x) for x in self.wrench],
            "grasp": grasp.to_dict(),
        }


def solve_as_printed(
    grasp: Grasp, wrench: Iterable[Any], options: Collection[str] = ()
) -> PrintedVerdict:
    """Decide as the printed text does in the chosen points, and completely in all others.

    Args:
        options: any of the keys of `OPTIONS`.

    Raises:
        GraspError: an unknown option.
    """
    unknown = sorted(set(options) - OPTIONS.keys())
    if unknown:
        raise GraspError(f"as_printed names {unknown[0]!r}; expected any of {', '.join(OPTIONS)}")
    applied = read_wrench(wrench)
    chosen = tuple(name for name in OPTIONS if name in options)
    posed = grasp.with_preload(0) if "preload" in chosen else grasp
    question = LinearQuestion(ContactRows.of_grasp(posed), applied)
    slips = _slips(chosen)
    pieces: list[Equilibrium] = []
    for states in watched(_states(posed, chosen), "contact states"):
        equilibrium = equilibrium_of(question, states, [slips.get(x, x) for x in states])
        if equilibrium is not None:
            pieces.append(equilibrium)
            if "single-solution" in chosen:
                break
    return PrintedVerdict(grasp, applied, chosen, maximal(pieces))


def _slips(options: tuple[str, ...]) -> dict[str, State]:
    """Return what the chosen reading takes slips for: where friction pulls, and in which cell."""
    pull = 1 if "signs" in options else -1
    return {
        name: ContactState(
            "attached", () if "cell-check" in options else ((False, (sign,)),), share=(pull * sign,)
        )
        for name, sign in (("slip+", 1), ("slip-", -1))
    }


def _states(grasp: Grasp, options: tuple[str, ...]) -> tuple[States, ...]:
    """Return the contact states that the chosen reading tries, without repeats."""
    m, tangential = len(grasp), grasp.tangential_arrangement()
    faces = (tangential if "detachment" in options else grasp.motion_arrangement()).faces()
    published: Collection[tuple[int, ...]] | None = None
    if "coincident-planes" in options:
        ask_steps(m)
        # Of distinct planes they list all faces but the origin: "Minimum cycle basis" in the docs.
        if len(tangential.distinct) < m:
            published = frozenset(published_enumeration(tangential).states)
    # The origin; where the tangential planes share a line, the enumeration lists that line.
    origin = "all-stick" not in options or tangential.rank < 3

    def is_listed(face: Face) -> bool:
        """Return whether this enumeration reaches a face, by its tangential signs."""
        slips = face.signs[:m]
        return (published is None or slips in published) if any(slips) else origin

    def states_on(face: Face) -> States:
        """Return the states on a face; without normal planes no contact detaches."""
        pairs = zip(grasp, face.signs[:m], face.signs[m:] or (-1,) * m, strict=True)
        return states_of_code(
            [slip if side < 0 or not c.stiffness else DETACHED for c, slip, side in pairs]
        )

    return tuple(dict.fromkeys(map(states_on, filter(is_listed, faces))))
