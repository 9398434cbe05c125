"""The contact states that rigid motion and springs allow, from the planes in the space of motions.

A motion d fixes the state of each contact: detached when ``stiffness N . d >= preload`` (no normal
force), else slip+, slip- or stick by the sign of ``T . d``. Not all 4^m choices occur, and not all
that occur are needed. Let F be the intersection of the tangential planes through d, and Y a region
of the arrangement restricted to F whose closure holds d. Each ``T_i . d`` has on Y the sign that it
has at d. A contact whose normal plane passes through d has no force at d, whatever its state on Y.
So every equilibrium at d satisfies the closed conditions of the states on Y, and the states on
these regions are enough: those of all cells, of the facets in tangential planes, of the edges in
two of them, and of d = 0. They are O(m^2) without preload, O(m^3) with.
"""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement import Arrangement
from arrangement.enumeration.choose import most_faces
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector
from equilibrium.model.grasp import Grasp

State: TypeAlias = Literal["detached", "slip+", "slip-", "stick"]
States: TypeAlias = tuple[State, ...]

#: Rows of contact states as numbers: the sign of ``T . d``, or `DETACHED`.
Codes: TypeAlias = npt.NDArray[np.int8]

DETACHED = 2
#: This many planes are counted first, if there are more.
_PLANES_COUNTED_FIRST = 16
STATE_OF_CODE: dict[int, State] = {1: "slip+", 0: "stick", -1: "slip-", DETACHED: "detached"}


def states_of_code(row: list[int]) -> States:
    """Return the names of a row of codes."""
    return tuple(STATE_OF_CODE[code] for code in row)


def contact_states(grasp: Grasp) -> tuple[States, ...]:
    """Return choices of contact states that together admit every equilibrium, without repeats."""
    return tuple(map(states_of_code, state_codes(grasp).tolist()))


def state_codes(grasp: Grasp) -> Codes:
    """Return the same as an array (choices, contacts)."""
    planes = grasp.motion_arrangement()
    tangential = sorted({planes.firsts[label] for label in planes.class_of[: len(grasp)]})
    parts = []
    number = most_faces(len(planes.distinct), planes.rank, planes.is_central)
    if budget.excess(bytes=24 * number * len(grasp)) > 1:
        _count(planes, len(grasp))
    for least, dimension in enumerate((3, 2, 1)):
        signs = planes.faces(dimension).signs
        parts.append(_codes(signs[(signs[:, tangential] == 0).sum(axis=1) >= least], grasp))
    codes = np.concatenate(parts)
    if grasp.tangential_arrangement().rank == 3:
        at_rest = planes.signs_at((0, 0, 0))
        codes = np.concatenate([codes, _codes(np.array([at_rest], dtype=np.int8), grasp)])
    codes = _distinct(codes)
    codes.setflags(write=False)
    return codes


def _count(planes: Arrangement, contacts: int) -> None:
    """Refuse more faces than the memory holds.

    More planes have more faces, so that some of them decide, and all are counted only if they may
    do.
    """
    from arrangement import counts

    for step in (27, 9, 3, 1):
        chosen = planes.firsts[::step]
        if step > 1 and len(chosen) < _PLANES_COUNTED_FIRST:
            continue
        normals, offsets = [planes.normals[i] for i in chosen], [planes.offsets[i] for i in chosen]
        part = Arrangement(normals, offsets, dimension=3)
        number: int = sum(counts.f_vector(part)[1:])
        if budget.excess(bytes=24 * number * contacts) > 1:
            many = number * step**2  # as many lines cross; there may be more
            budget.check_cost(
                f"{'about ' * (step > 1)}{many:,} choices of states of {contacts} contacts",
                "decide one load (solve)",
                bytes=24 * many * contacts,
            )


def states_at(grasp: Grasp, motion: RationalVector) -> States:
    """Return the contact states of a motion."""
    signs = np.array([grasp.motion_arrangement().signs_at(motion)], dtype=np.int8)
    return states_of_code(_codes(signs, grasp)[0].tolist())


def _codes(signs: Codes, grasp: Grasp) -> Codes:
    """Return the codes of rows of signs over the planes of ``Grasp.motion_arrangement``.

    A contact of constant force is never detached, or always, where that force is 0.
    """
    m, springs = len(grasp), np.array([bool(c.stiffness) for c in grasp], dtype=bool)
    idle = np.array([not (c.stiffness or c.preload) for c in grasp], dtype=bool)
    loose = (signs[:, m:] >= 0) & springs | idle
    codes: Codes = np.where(loose, np.int8(DETACHED), signs[:, :m])
    return codes


def _distinct(codes: Codes) -> Codes:
    """Return the rows without repeats, in a fixed order."""
    # Two bits for each code; whole words are sorted faster than rows.
    bits = np.concatenate([codes > 0, codes & 1 == 0], axis=1)
    packed = np.packbits(bits, axis=1)
    words = np.zeros((len(codes), -(-packed.shape[1] // 8)), dtype=np.uint64)
    words.view(np.uint8)[:, : packed.shape[1]] = packed
    order = np.lexsort(words.T) if words.size else np.arange(len(codes))
    first = np.ones(len(codes), dtype=bool)
    first[1:] = np.any(words[order[1:]] != words[order[:-1]], axis=1)
    return codes[order[first]]
