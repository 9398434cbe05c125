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

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, TypeAlias, TypeVar

import numpy as np

from arrangement.console.number_form import JsonMixin, ReprMixin
from arrangement.console.progress import watched
from arrangement.enumeration.fan import Fan
from arrangement.errors import InputError, OutOfTimeError
from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import IntegerVector, primitive, rational_vector
from equilibrium.model.assembly import Assembly
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows

Contacts: TypeAlias = tuple[int, ...]
#: For each contact the sign of its slip along each tangent, all 0 where it sticks; None where it
#: separates.
Slips: TypeAlias = tuple[tuple[int, ...] | None, ...]
S = TypeVar("S")


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
        rows = grasp.rows if isinstance(grasp, Assembly) else ContactRows.of_grasp(grasp)
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
        found = iter(signs[m:])
        return tuple(
            None if separates else tuple(next(found) for _ in rows)
            for separates, rows in zip(signs[:m], self.tangents, strict=True)
        )


def _modes(fan: Fan) -> Iterator[tuple[tuple[int, ...], int, IntegerVector]]:
    for signs, dimension, motion in zip(fan.signs, fan.dimensions, fan.points, strict=True):
        yield tuple(signs.tolist()), int(dimension), tuple(motion.tolist())
