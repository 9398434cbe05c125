"""Contact modes: what rigid contacts can do, from kinematics alone.

A motion d that pushes no contact in has ``N . d >= 0`` at each. A *contacting-separating mode* says
which contacts stay (0) and which separate (+): the face of that cone in which d lies. A
*sliding-sticking mode* says for each contact that stays on which side of its tangent planes
``T . d = 0`` the motion is: the face, inside that of the cone, of these planes. Forces, friction,
stiffness and preload play no part. Source: [HuangChengMason2020].

In the plane a contact has one tangent. In space the two of `Contact.tangents` are taken, and the
number of sliding-sticking modes depends on their choice.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Generic, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from arrangement.console.number_form import JsonMixin, ReprMixin, vector
from arrangement.console.progress import watched
from arrangement.enumeration.sequence import Signs, primitive_rows
from arrangement.errors import InputError, OutOfTimeError
from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.coefficients import Integers, as_integers, for_products, largest_entry
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import IntegerVector, primitive, rational_vector, sign_text
from arrangement.numbers.linear.rank import unit_vectors
from arrangement.numbers.packing import Bits
from equilibrium.model.assembly import Assembly
from equilibrium.model.grasp import Grasp
from equilibrium.model.subject import check_subject, rows_of

Contacts: TypeAlias = tuple[int, ...]
#: For each contact the sign of its slip along each tangent, all 0 where it sticks; None where it
#: separates.
Slips: TypeAlias = tuple[tuple[int, ...] | None, ...]
S = TypeVar("S")


@dataclass(frozen=True, slots=True)
class Fan:
    """The faces of central planes inside a closed cone of R^n, cut by one plane at a time.

    Planes outside the cone cost nothing: where a few planes bound a cone and many cut it, this
    lists the faces inside alone. Each closed face is known by its extreme rays, modulo the lines
    that all faces have in common. A plane that has rays of a face on both sides cuts it in three,
    and its rays on the plane are those of the face there and one on each edge of the face that the
    plane cuts: an edge (a, b) is one of a face exactly when a and b are rays of it, since faces are
    convex.

    Cost: one pass over the faces so far for each plane, in arrays of truth values, faces by rays.
    Numbers are int64 wherever a bound of their size allows, else Python integers.

    >>> quadrant = Fan.space(2).cut((1, 0), (0, 1)).cut((0, 1), (0, 1))
    >>> quadrant.cut((1, -1)).signs.tolist()
    [[0, 0, 0], [1, 0, 1], [0, 1, -1], [1, 1, 0], [1, 1, 1], [1, 1, -1]]

    Attributes:
        rays: (R, n); one point of each ray, modulo the lines.
        lines: (L, n); a basis of the lines that every closed face contains.
        members: (F, R); whether a ray is in a closed face.
        signs: (F, k); the side of each face of each plane that was cut, in their order.
        dimensions: (F); lines included.
    """

    rays: Integers
    lines: Integers
    members: Bits
    signs: Signs
    dimensions: NDArray[np.int8]

    @classmethod
    def space(cls, n: int) -> Fan:
        """Return R^n, which no plane has cut yet: one face."""
        return cls(
            np.zeros((0, n), np.int64),
            np.array(unit_vectors(n), np.int64).reshape(n, n),
            np.zeros((1, 0), bool),
            np.zeros((1, 0), np.int8),
            np.array([n], np.int8),
        )

    def __len__(self) -> int:
        return len(self.members)

    def cut(self, normal: Sequence[int], sides: Collection[int] = (-1, 0, 1)) -> Fan:
        """Return the faces into which a plane cuts these, on the chosen sides of it.

        Args:
            normal: n integers; all zero for a plane that contains every face.
            sides: of -1, 0, 1: (0, 1) leaves a half space, (0,) the plane itself.
        """
        form = as_integers([normal])[0]
        factor = len(form) * largest_entry(form)
        on_lines = for_products(self.lines, factor) @ form
        if on_lines.any():
            return self._cut_lines(form, on_lines, sides)
        return self._cut_rays(for_products(self.rays, factor) @ form, sides)

    def boundary_and(self, face: int) -> Fan:
        """Return one face with all faces of its boundary: again a fan."""
        mine = self.members[face]
        inside = ~self.members[:, ~mine].any(axis=1)
        return Fan(
            self.rays[mine],
            self.lines,
            self.members[np.ix_(inside, mine)],
            self.signs[inside],
            self.dimensions[inside],
        )

    def at(self, chosen: NDArray[np.intp]) -> Fan:
        """Return some of the faces in an order, no longer all of a cone perhaps."""
        return Fan(
            self.rays, self.lines, self.members[chosen], self.signs[chosen], self.dimensions[chosen]
        )

    @property
    def points(self) -> Integers:
        """(F, n); an integer point in each face, the sum of its rays, without common divisor."""
        rays = for_products(self.rays, len(self.rays))
        return primitive_rows(self.members.astype(rays.dtype) @ rays)

    def _cut_lines(self, form: Integers, on_lines: Integers, sides: Collection[int]) -> Fan:
        """Move everything into the plane along one line; its two halves become rays."""
        pivot = int(np.flatnonzero(on_lines)[0])
        line, top = self.lines[pivot], on_lines[pivot]
        if top < 0:
            line, top = -line, -top
        others = np.delete(self.lines, pivot, axis=0)
        rays, lines = (_moved(part, form, line, top) for part in (self.rays, others))
        halves = [(0, [False, False]), (1, [True, False]), (-1, [False, True])]
        kept = [(side, half) for side, half in halves if side in sides]
        count = len(self)
        return Fan(
            np.concatenate([rays, [line, -line]]),
            lines,
            np.concatenate([np.column_stack([self.members, [h] * count]) for _, h in kept]),
            np.concatenate([_with(self.signs, side) for side, _ in kept]),
            np.concatenate([self.dimensions - (side == 0) for side, _ in kept]).astype(np.int8),
        )._without_unused_rays()

    def _cut_rays(self, values: Integers, sides: Collection[int]) -> Fan:
        """Sort the faces by the sides of their rays, and cut those with rays on both sides."""
        above, below = values > 0, values < 0
        high = self.members[:, above].any(axis=1)
        low = self.members[:, below].any(axis=1)
        both = high & low
        side = np.sign(high.astype(np.int8) - low.astype(np.int8))
        whole = ~both & np.isin(side, list(sides))
        edges = self.members[both & (self.members.sum(axis=1) == 2)]
        first, second = np.nonzero(edges)[1].reshape(-1, 2).T
        cut, dimensions = self.members[both], self.dimensions[both]
        on_edges = cut[:, first] & cut[:, second]
        old = {0: ~(above | below), 1: ~below, -1: ~above}
        kept = [s for s in (0, 1, -1) if s in sides]
        none = np.zeros((int(whole.sum()), len(edges)), bool)
        return Fan(
            np.concatenate([self.rays, _crossings(self.rays, values, first, second)]),
            self.lines,
            np.concatenate(
                [
                    np.column_stack([self.members[whole], none]),
                    *[np.column_stack([cut & old[s], on_edges]) for s in kept],
                ]
            ),
            np.concatenate(
                [
                    np.column_stack([self.signs[whole], side[whole]]),
                    *[_with(self.signs[both], s) for s in kept],
                ]
            ),
            np.concatenate([self.dimensions[whole], *[dimensions - np.int8(s == 0) for s in kept]]),
        )._without_unused_rays()

    def _without_unused_rays(self) -> Fan:
        used = self.members.any(axis=0)
        if used.all():
            return self
        return Fan(self.rays[used], self.lines, self.members[:, used], self.signs, self.dimensions)


def _with(signs: Signs, side: int) -> Signs:
    return np.column_stack([signs, np.full(len(signs), side, np.int8)])


def _moved(vectors: Integers, form: Integers, line: Integers, top: int) -> Integers:
    """Return vectors moved along a line into the plane, scaled by positive numbers."""
    size = len(form) * largest_entry(form) * largest_entry(line)
    vectors = for_products(vectors, 2 * size)
    return primitive_rows(top * vectors - (vectors @ form)[:, None] * line)


def _crossings(
    rays: Integers, values: Integers, first: NDArray[np.intp], second: NDArray[np.intp]
) -> Integers:
    """Return the point of the plane on each edge between two rays on different sides of it."""
    rays = for_products(rays, 2 * largest_entry(values))
    left, right = np.abs(values[second])[:, None], np.abs(values[first])[:, None]
    return primitive_rows(left * rays[first] + right * rays[second])


@dataclass(frozen=True, slots=True)
class Mode(JsonMixin, Generic[S]):
    """A contacting-separating or a sliding-sticking mode.

    Attributes:
        signs: contacting-separating: for each contact 0 where it stays, 1 where it separates;
            sliding-sticking: `Slips`.
        dimension: of the cone of its motions.
        motion: one of them, coprime integers ``(x, y, r)``, or ``(v, omega)`` in space; of several
            bodies, of each.
    """

    json_fields = ("signs", "dimension", "motion")

    signs: S
    dimension: int
    motion: IntegerVector


@dataclass(frozen=True, eq=False, repr=False)
class ContactModes(ReprMixin):
    """The modes of rigid contacts, each once, from the smallest dimension up.

    Args:
        normals: m integer rows of length n: contact i does not move in where ``row . d >= 0``.
        tangents: for each contact the rows of its tangent planes, any number of them.
        n: the dimension of motions d: 3 for a body in the plane, 6 in space, more for more bodies.
        deadline: looked at before each cut by a plane.

    Raises:
        TimeLimitError: by any property, the deadline is over.
    """

    repr_fields = ("n", "normals", "tangents")
    normals: tuple[IntegerVector, ...]
    tangents: tuple[tuple[IntegerVector, ...], ...]
    n: int
    deadline: Deadline = Deadline()  # noqa: RUF009

    @classmethod
    def of_grasp(cls, grasp: Grasp | Assembly, *, time_limit: float | None = None) -> ContactModes:
        """Return the modes of the contacts of a grasp, or of an assembly of bodies.

        Args:
            time_limit: in seconds from now.

        >>> from equilibrium import read_grasp
        >>> modes = ContactModes.of_grasp(read_grasp("box-1-wall"))
        >>> len(modes.contacting_separating), modes.sliding_sticking_count
        (10, 196)
        """
        check_subject(grasp)
        rows = rows_of(grasp)
        return cls(
            tuple(primitive(row.normal_wrench) for row in rows),
            tuple(tuple(map(primitive, row.tangential_wrenches)) for row in rows),
            rows.n,
            Deadline(time_limit),
        )

    @classmethod
    def from_dict(
        cls, document: Mapping[str, Any], *, time_limit: float | None = None
    ) -> ContactModes:
        """Return the modes of contacts between bodies of any number.

        Args:
            document: of an assembly in the plane; or the rows of the class, in the plane or in
                space: ``schema_version``, ``normals`` and ``tangents``, see the built-in
                ``box-on-a-box-1-wall``.
            time_limit: in seconds from now.

        Raises:
            InputError: it is neither.
        """
        if "bodies" in document:
            return cls.of_grasp(Assembly.from_dict(document), time_limit=time_limit)
        check_keys(document, ("schema_version", "normals", "tangents"), ("description",), "it")
        normals = check_list(document["normals"], "normals")
        tangents = check_list(document["tangents"], "tangents", len(normals))
        read = [primitive(rational_vector(row, "normals")) for row in normals]
        slips = [
            tuple(
                primitive(rational_vector(row, "tangents")) for row in check_list(pair, "tangents")
            )
            for pair in tangents
        ]
        lengths = {len(row) for row in (*read, *(row for rows in slips for row in rows))}
        if len(lengths) != 1 or 0 in lengths:
            raise InputError(f"rows have the lengths {sorted(lengths)}; give rows of one length")
        return cls(tuple(read), tuple(slips), lengths.pop(), Deadline(time_limit))

    @cached_property
    def contacting_separating(self) -> tuple[Mode[Contacts], ...]:
        """The faces of the cone ``N d >= 0``."""
        return tuple(Mode(*mode) for mode in _modes(self._cone))

    def sliding_sticking(self) -> Iterator[Mode[Slips]]:
        """Yield the sliding-sticking modes, those of one contacting-separating mode together."""
        for fan in self._inside():
            for signs, dimension, motion in _modes(fan):
                yield Mode(self._slips(signs), dimension, motion)

    @property
    def sliding_sticking_count(self) -> int:
        """How many of them there are, without making each."""
        return sum(map(len, self._inside()))

    def to_dict(self, count: bool = False) -> dict[str, Any]:
        """Return a JSON form: all modes, or their numbers."""
        if count:
            return {
                "contacting_separating": len(self.contacting_separating),
                "sliding_sticking": self.sliding_sticking_count,
            }
        return {
            "contacting_separating": [mode.to_dict() for mode in self.contacting_separating],
            "sliding_sticking": [mode.to_dict() for mode in self.sliding_sticking()],
        }

    def lines(self, count: bool = False) -> Iterator[str]:
        """Yield all modes, or their numbers, in lines for people."""
        total = len(self.contacting_separating)
        if count:
            yield f"contacting-separating  {total:>7}"
            yield f"sliding-sticking       {self.sliding_sticking_count:>7}"
            return
        yield f"contacting-separating modes: {total} (c: stays in contact, s: separates)"
        for kept in self.contacting_separating:
            signs = "".join("s" if sign else "c" for sign in kept.signs)
            yield f"  {signs}  dim {kept.dimension}  {_scaled(kept.motion)}"
        yield "sliding-sticking modes (0: no slip, + and -: slip along a tangent)"
        for mode in self.sliding_sticking():
            slips = " ".join("s" if slip is None else sign_text(slip) for slip in mode.signs)
            yield f"  {slips}  dim {mode.dimension}  {_scaled(mode.motion)}"

    @cached_property
    def _cone(self) -> Fan:
        cone = Fan.space(self.n)
        for row in self.normals:
            cone = self._in_time(cone).cut(row, (0, 1))
        return cone.at(np.lexsort((*reversed(cone.signs.T), cone.dimensions)))

    def _in_time(self, fan: Fan) -> Fan:
        if self.deadline.passed:
            raise OutOfTimeError(
                f"{self.deadline}: the modes of {len(self.normals)} contacts are not all known; "
                "give more time, or fewer contacts",
                (),
            )
        return fan

    def _inside(self) -> Iterator[Fan]:
        """Yield the faces inside each face of the cone; their other signs are of its contacts."""
        m = len(self.normals)
        for face, signs in enumerate(watched(self._cone.signs, "faces of the cone")):
            fan = self._cone.boundary_and(face)
            for contact in np.flatnonzero(signs == 0):
                for row in self.tangents[contact]:
                    fan = self._in_time(fan).cut(row)
            inside = fan.at(np.flatnonzero((fan.signs[:, :m] == signs).all(axis=1)))
            yield inside.at(np.lexsort((*reversed(inside.signs.T), inside.dimensions)))

    def _slips(self, signs: Sequence[int]) -> Slips:
        m = len(self.normals)
        rest = iter(signs[m:])
        return tuple(
            None if separates else tuple(next(rest) for _ in rows)
            for separates, rows in zip(signs[:m], self.tangents, strict=True)
        )


def _modes(fan: Fan) -> Iterator[tuple[tuple[int, ...], int, IntegerVector]]:
    for signs, dimension, motion in zip(fan.signs, fan.dimensions, fan.points, strict=True):
        yield tuple(signs.tolist()), int(dimension), tuple(motion.tolist())


def _scaled(motion: Sequence[int]) -> str:
    """Return a motion with its largest entry 1: a mode has its positive multiples, too."""
    largest = max(map(abs, motion)) or 1
    return vector(Fraction(x, largest) for x in motion)
