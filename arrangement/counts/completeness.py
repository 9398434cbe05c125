"""Completeness of an enumeration, certified by Zaslavsky's theorem.

If every listed face exists, no face is listed twice, and there are as many as the theorem says,
then none is missing. The count comes from `arrangement.counts`, which shares no code with any
enumerator; each face's existence is its own witness.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.linear.rank import rank
from arrangement.planes.faces import Face
from arrangement.planes.planes import Planes
from arrangement.planes.proved import proved_complete, proved_f_vector

from . import f_vector

_MAX_PROBLEMS = 20


@dataclass(frozen=True, repr=False)
class CompletenessEvidence(ReprMixin):
    """What an enumeration was compared with, and what is wrong with it.

    Attributes:
        enumerated: numbers of listed faces of dimension 0, ..., d.
        theorem: the same numbers by Zaslavsky's theorem over all restrictions.
        problems: what failed, in words (the first 20); empty if and only if the list is complete
            and correct.
    """

    enumerated: tuple[int, ...]
    theorem: tuple[int, ...]
    problems: tuple[str, ...]

    @property
    def complete(self) -> bool:
        """Whether the list has every face exactly once, and nothing else."""
        return not self.problems

    def __bool__(self) -> bool:
        return self.complete


def certify_complete(
    arrangement: Planes, faces: Iterable[Face], *, proved: bool = False
) -> CompletenessEvidence:
    """Check that a list of faces is the whole list, each face once.

    For every face: its witness has its signs, and its dimension is d minus the rank of the
    planes through it. Together: no sign vector twice, and the f-vector of the theorem.

    Args:
        arrangement: any arrangement.
        faces: the list to check, whoever made it.
        proved: let the program that is proved in Coq (`make formal`) count the faces and check
            the list too.

    Complexity: O(m d) exact operations for each face, and the count (`counts.f_vector`).

    >>> from arrangement import Arrangement
    >>> planes = Arrangement([[1, 0], [0, 1], [1, 1]])
    >>> evidence = certify_complete(planes, planes.faces())
    >>> evidence.complete, evidence.theorem
    (True, (1, 6, 6))
    """
    theorem = proved_f_vector(arrangement) if proved else f_vector(arrangement)
    faces = list(faces) if proved else faces
    problems: list[str] = []
    counted = [0] * (arrangement.dimension + 1)
    ranks: dict[tuple[int, ...], int] = {}
    seen: set[tuple[int, ...]] = set()
    for face in faces:
        problem = _problem(arrangement, face, ranks)
        if problem is None and face.signs in seen:
            problem = "is listed twice"
        seen.add(face.signs)
        if problem is None:
            counted[face.dimension] += 1
        else:
            problems.append(f"face {face.signs} {problem}")
    for k, (here, there) in enumerate(zip(counted, theorem, strict=True)):
        if here != there:
            problems.append(f"{here} faces of dimension {k} hold; there are {there}")
    if proved and not problems and not proved_complete(arrangement, faces):
        problems.append("the verified program refuses the list")
    return CompletenessEvidence(tuple(counted), theorem, tuple(problems[:_MAX_PROBLEMS]))


def _problem(arrangement: Planes, face: Face, ranks: dict[tuple[int, ...], int]) -> str | None:
    """Return what is wrong with one face, or None."""
    if len(face.witness) != arrangement.dimension:
        return f"has a witness with {len(face.witness)} coordinates"
    signs = arrangement.signs_at(face.witness)
    if signs != face.signs:
        return f"has a witness {tuple(map(str, face.witness))} with other signs"
    zero = tuple(i for i, sign in enumerate(signs) if sign == 0)
    if zero not in ranks:
        ranks[zero] = rank([arrangement.integer_planes[i][:-1] for i in zero])
    dimension = arrangement.dimension - ranks[zero]
    if face.dimension != dimension:
        return f"has dimension {dimension}, not {face.dimension}"
    return None
