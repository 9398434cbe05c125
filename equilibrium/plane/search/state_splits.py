"""The motions of one region decided exactly, by splits on the states of contacts.

Each part (a region, with the states of some contacts fixed) is decided by a linear program. Where
that finds a motion with balanced forces, these obey the law at all contacts with a state. If they
obey it at the others too, this is an equilibrium; if not, a contact where they do not gets a state.
So the splits end.
"""

from __future__ import annotations

from collections.abc import Sequence

from arrangement.numbers.exact import IntegerVector, RationalVector
from equilibrium.core.contacts import IntegerContacts
from equilibrium.model.effort import Effort
from equilibrium.model.solution import Solution

from .part_guess import decide
from .part_program import Cut, Node, PartProgram, RegionRows, States


class TooManyParts(Exception):
    """The splits have not ended within the number allowed."""


class StateSplits:
    """The decision for one region.

    Args:
        generators: of the region: four, or the seven of the half space.
        limit: of the number of programs.
        effort: that is left.
    """

    def __init__(
        self,
        contacts: IntegerContacts,
        wrench: RationalVector,
        generators: Sequence[IntegerVector],
        limit: float,
        effort: Effort | None = None,
    ) -> None:
        self.region = RegionRows(contacts, wrench, generators)
        self.left, self.effort = limit, effort or Effort()

    def decide(self) -> Node | Solution:
        """Return a proof that the region holds no equilibrium, or one that it holds.

        Raises:
            TooManyParts: the limit is reached.
            TimeoutError: no effort is left.
        """
        return self._decide({}, ())

    def _decide(self, states: States, cuts: Sequence[Cut]) -> Node | Solution:
        self.left -= 1
        if self.left < 0:
            raise TooManyParts
        program = PartProgram(self.region, states, cuts)
        found = decide(program, self.effort)
        contact = program.worst(found) if isinstance(found, Solution) else found
        if not isinstance(contact, int):
            return found
        cuts, names = program.binding, ("stick", "slip+", "slip-")
        if contact in states:
            return self._children(states, cuts, contact, "slip", names)
        # Whether the direction of slip matters and is not known.
        slides = not self.region.known[contact] and self.region.contacts.friction[contact]
        if self.region.mixed[contact] or not slides:
            return self._children(states, cuts, contact, "attachment", ("attached", "detached"))
        slip = self._children({**states, contact: "attached"}, cuts, contact, "slip", names)
        if isinstance(slip, Solution):
            return slip
        detached = self._decide({**states, contact: "detached"}, cuts)
        if isinstance(detached, Solution):
            return detached
        return {"contact": contact, "attachment": {"detached": detached, "attached": slip}}

    def _children(
        self,
        states: States,
        cuts: Sequence[Cut],
        contact: int,
        kind: str,
        names: tuple[str, ...],
    ) -> Node | Solution:
        parts = {}
        for name in names:
            part = self._decide({**states, contact: name}, cuts)
            if isinstance(part, Solution):
                return part
            parts[name] = part
        return {"contact": contact, kind: parts}
