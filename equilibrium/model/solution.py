"""What a search ends with: an equilibrium, exact or enclosed in a box; a proof; or neither.

Forces are those of points; `PadForce` is that of a pad.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import JsonMixin, counted
from arrangement.numbers.exact import RationalVector, dot, primitive, to_text, vector_text
from arrangement.numbers.linear.rank import cross, difference

from .contact import Contact


class Enclosure(NamedTuple):
    """A box that holds exactly one equilibrium in space, whose numbers are not rational.

    The unknowns, six numbers in all, are the coefficients of a motion in `basis` and the forces of
    `pillars`. The test of Krawczyk shows that the balance has one solution in the box, see
    `equilibrium.certificate.enclosure`.

    Attributes:
        basis: motions; that of the equilibrium is a combination of them.
        friction: for each contact None where it is detached, () where it slips, and where it sticks
            its friction force over ``mu c_n``, without the forces of pillars.
        pillars: (contact, 0 or 1): active tangents of sticking contacts, whose force is unknown.
        centre, radius: of the six intervals of the unknowns.
        inverse: (6, 6), near the inverse of the derivative of the balance in the centre.
        idle: null-space motions v, which do no work at any loaded contact, such as a turn about
            the line of two; each is followed by the value of ``v . d``.
    """

    basis: tuple[RationalVector, ...]
    friction: tuple[RationalVector | None, ...]
    pillars: tuple[tuple[int, int], ...]
    centre: RationalVector
    radius: RationalVector
    inverse: tuple[RationalVector, ...]
    idle: tuple[RationalVector, ...] = ()


@dataclass(frozen=True)
class Solution(JsonMixin):
    """One equilibrium.

    Attributes:
        motion: three numbers, in space six.
        forces: at each contact the normal force and one along each tangent: one, in space two. Its
            adhesion acts besides.
        box: what holds it if its numbers are not rational; motion and forces are then near floats.
    """

    json_fields = ("motion", "forces")

    motion: RationalVector
    forces: tuple[RationalVector, ...]
    box: Enclosure | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        return (
            f"<Solution: motion {vector_text(self.motion)}, {counted(len(self.forces), 'force')}>"
        )


@dataclass(frozen=True)
class PadForce:
    """The force of a pad: the sum of those of its points, and where it acts.

    Attributes:
        force: along the normal and the tangents.
        at: the place of the pad where the normal forces have no moment; none where it is detached.
        torsion: in space, the torque of friction about the normal there.
    """

    force: RationalVector
    at: RationalVector
    torsion: Fraction

    @classmethod
    def of(cls, points: Sequence[Contact], forces: Sequence[RationalVector]) -> PadForce:
        """Return the force of a pad whose points press like this."""
        force = tuple(sum(column, Fraction(0)) for column in zip(*forces, strict=True))
        if not force[0]:
            return cls(force, (), Fraction(0))
        columns = zip(*(c.point for c in points), strict=True)
        at = tuple(Fraction(dot([f[0] for f in forces], x)) / force[0] for x in columns)
        torsion = Fraction(0)
        if len(at) == 3:
            pairs = zip(points, forces, strict=True)
            rubs = ((c, c.force((Fraction(0), *f[1:]))) for c, f in pairs)
            torques = (cross(difference(c.point, at), rub) for c, rub in rubs)
            torsion = sum((Fraction(dot(points[0].normal, x)) for x in torques), torsion)
        return cls(force, at, torsion)

    def to_dict(self, form: Any = to_text) -> dict[str, Any]:
        """Return a JSON form.

        Args:
            form: of a number.
        """
        document: dict[str, Any] = {"force": list(map(form, self.force))}
        if self.at:
            document["at"] = list(map(form, self.at))
        if len(self.at) == 3:
            document["torsion"] = form(self.torsion)
        return document


def numbering_words(groups: Sequence[range], taker: str = "the certificate") -> str:
    """Return how an answer about points numbers them as contacts; empty without pads.

    Args:
        taker: the answer.
    """
    if all(len(group) == 1 for group in groups):
        return ""
    places = (
        f"contact {k} is {g.start + 1}" + (f" to {g.stop}" if len(g) > 1 else "")
        for k, g in enumerate(groups, 1)
    )
    return f"{taker} is about points, which it numbers as contacts: {', '.join(places)}"


def pad_entries(
    groups: Sequence[range],
    contacts: Sequence[Contact],
    forces: Sequence[RationalVector],
    form: Any = to_text,
) -> dict[str, Any]:
    """Return the JSON form of the forces of pads, by the key "pads"; nothing where there is none.

    Args:
        form: of a number.
    """
    entries = [
        {
            "contact": k,
            "points": list(group),
            **PadForce.of(
                contacts[group.start : group.stop], forces[group.start : group.stop]
            ).to_dict(form),
        }
        for k, group in enumerate(groups, 1)
        if len(group) > 1
    ]
    return {"pads": entries} if entries else {}


@dataclass(frozen=True)
class Open:
    """Neither was proved.

    Attributes:
        reason: in words.
        residual: of the motion that is closest to an equilibrium, as a share of the forces.
    """

    reason: str
    residual: float


@dataclass(frozen=True)
class Refutation:
    """There is no equilibrium.

    Attributes:
        tree: the proof; None where all choices of contact states have shown it.
        reason: of an assembly, which part cannot balance the load.
    """

    tree: Tree | None
    reason: str = ""


@dataclass(frozen=True)
class Leaf:
    """A virtual motion, and (alpha, h) of some contacts, see `equilibrium.certificate.leaf_rule`.

    All numbers are exact.

    Attributes:
        displacements: numbers for the normal and the tangents of some contacts.
    """

    motion: tuple[Any, ...]
    multipliers: Mapping[int, Sequence[Any]]
    displacements: Mapping[int, Sequence[Any]] = field(default_factory=dict)

    @property
    def numbers(self) -> tuple[Any, ...]:
        """All of its numbers."""
        return tuple(chain(self.motion, *self.multipliers.values(), *self.displacements.values()))

    def with_numbers(self, numbers: Iterable[Any]) -> Leaf:
        """Return the leaf with other numbers, in the order of `numbers`."""
        left = iter(numbers)
        motion = tuple(next(left) for _ in self.motion)
        rows = (
            {i: tuple(next(left) for _ in row) for i, row in rows_of.items()}
            for rows_of in (self.multipliers, self.displacements)
        )
        return Leaf(motion, *rows)

    def at(self, contacts: Sequence[int]) -> Leaf:
        """Return the leaf with the numbers of these contacts in place of 0, 1, ..."""
        every = self.multipliers, self.displacements
        return Leaf(self.motion, *({contacts[i]: x for i, x in rows.items()} for rows in every))

    def primitive(self) -> Leaf:
        """Return the leaf times what makes its numbers integers without a common divisor."""
        return self.with_numbers(primitive(self.numbers))


#: The tree of virtual motions that refutes all, with such leaves in the form of certificates.
Tree: TypeAlias = dict[str, Any] | list[Any] | Leaf


def leaves_of(tree: Any) -> Iterator[Leaf]:
    """Yield the leaves of a tree."""
    if isinstance(tree, Leaf):
        yield tree
    elif isinstance(tree, dict | list):
        for child in tree.values() if isinstance(tree, dict) else tree:
            yield from leaves_of(child)


def with_leaves(tree: Any, change: Callable[[Leaf], Leaf]) -> Any:
    """Return a tree with changed leaves."""
    if isinstance(tree, Leaf):
        return change(tree)
    if isinstance(tree, list):
        return [with_leaves(child, change) for child in tree]
    if isinstance(tree, dict):
        return {key: with_leaves(child, change) for key, child in tree.items()}
    return tree


#: An equilibrium, the proof that there is none, or neither.
Outcome: TypeAlias = Solution | Tree | Open
