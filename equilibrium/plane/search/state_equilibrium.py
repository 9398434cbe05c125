"""The equilibrium of one choice of contact states, solved exactly from a guess.

Where more contacts stick than the balance needs, their forces are not determined. All but a few
get a rounded share of their friction limit, which is linear in the motion and never too large; the
few whose tangential planes fix the motion carry what is missing.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np

from arrangement.numbers.exact import RationalVector
from arrangement.numbers.float_filter import Floats
from arrangement.numbers.linear.rank import rank
from equilibrium.core.cones import SLIP_SHARE, LineCones
from equilibrium.core.contact_law import ContactState, LinearQuestion, State
from equilibrium.core.contact_program import ContactProgram
from equilibrium.core.contacts import IntegerContacts
from equilibrium.core.continuation import SHARPNESS_NEAR, Continuation
from equilibrium.core.float_law import Balance
from equilibrium.core.states import spanning_rows
from equilibrium.model.solution import Solution

#: Shares of the friction limit are multiples of one over this.
_SHARE_DENOMINATOR = 2**14
#: Rounded motions are multiples of one over this.
_MOTION_DENOMINATOR = 16
#: The least weight of a contact that bears nothing.
_MIN_WEIGHT = 1e-6


@dataclass(frozen=True)
class Guess:
    """What each contact may do.

    Attributes:
        touching: the contacts with a normal force.
        sticking: those among them that do not slip.
        shares: of its friction limit, over `_SHARE_DENOMINATOR`, for each contact;
            exact when it slips.
        motion: over `_MOTION_DENOMINATOR`, rounded.
        weights: which of those that stick bear most, from `_MIN_WEIGHT` to 1.
    """

    touching: tuple[bool, ...]
    sticking: tuple[bool, ...]
    shares: tuple[int, ...]
    motion: tuple[int, ...] = field(compare=False)
    weights: tuple[float, ...] | float = field(default=1.0, compare=False)

    @classmethod
    def near(cls, balance: Balance, motion: Floats, eps: float) -> Guess:
        """Return the likely contact states near a motion of the smooth balance."""
        force, share = (numbers[:, 0] for numbers in balance.forces(motion, eps)[:2])
        touching = force > 0
        sticking = touching & ~(np.abs(share) > SLIP_SHARE)
        shares = np.where(
            sticking, np.rint(share * _SHARE_DENOMINATOR), np.sign(share) * _SHARE_DENOMINATOR
        )
        return cls(
            tuple(touching.tolist()),
            tuple(sticking.tolist()),
            tuple(int(x) for x in np.nan_to_num(shares).tolist()),
            tuple(round(x * _MOTION_DENOMINATOR) for x in np.nan_to_num(motion).tolist()),
            tuple(np.clip(np.nan_to_num(force / force.max(initial=0)), _MIN_WEIGHT, 1).tolist()),
        )


def find_equilibrium(
    contacts: IntegerContacts, wrench: RationalVector, start: Floats | None = None
) -> Solution | None:
    """Return an exact equilibrium, or None where the search finds none.

    Args:
        start: a motion that may be near one; the path then begins with rather sharp contacts.
    """
    search = Continuation(contacts.floats, wrench, LineCones())
    path = search.path(np.zeros(3)) if start is None else search.path(start, SHARPNESS_NEAR)
    question = LinearQuestion(contacts.rows, wrench, max_displacement=contacts.max_displacement)
    tried: set[Guess] = set()
    with np.errstate(all="ignore"):
        for motion, eps in path:
            guess = Guess.near(search.balance, motion, eps)
            if guess not in tried:
                tried.add(guess)
                equilibrium = exact_equilibrium(contacts, question, guess)
                if equilibrium is not None:
                    return equilibrium
    return None


def exact_equilibrium(
    contacts: IntegerContacts, question: LinearQuestion, guess: Guess
) -> Solution | None:
    """Return an equilibrium with the states of a guess, or None."""
    pillars = _pillars(contacts, guess)
    states: list[State] = []
    for i, share in enumerate(guess.shares):
        if not guess.touching[i]:
            states.append("detached")
        elif question.is_smooth(i):
            states.append("attached")
        elif not guess.sticking[i]:
            states.append("slip-" if share > 0 else "slip+")
        elif i in pillars:
            states.append("stick")
        else:
            known = (Fraction(share, _SHARE_DENOMINATOR),)
            states.append(ContactState.of("stick", 1, share=known))
    program = ContactProgram(question, tuple(states))
    # What the equations leave open is taken from the guess.
    near = [Fraction(x, _MOTION_DENOMINATOR) for x in guess.motion]
    return program.admitted(program.completed(near))


def _pillars(contacts: IntegerContacts, guess: Guess) -> list[int]:
    """Return sticking contacts whose tangential wrenches are a basis of all sticking ones'.

    Those are taken that can give most, each across what the ones before it give.
    """
    sticking = np.flatnonzero(guess.sticking)
    spare = 1.0 - np.abs(np.array(guess.shares)[sticking]) / (_SHARE_DENOMINATOR + 1)
    spare *= np.broadcast_to(guess.weights, len(contacts))[sticking]
    floats = contacts.floats
    left = floats.tangent[sticking] * (spare * floats.friction[sticking])[:, None]
    count = rank(contacts.tangent[sticking].tolist())
    chosen: list[int] = sticking[spanning_rows(left, count)].tolist()
    return chosen
