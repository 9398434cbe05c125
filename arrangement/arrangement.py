"""The facade: planes together with their faces, counts and great circles."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from . import completeness
from .enumeration.choose import enumerate_faces
from .enumeration.great_circles import SphereArrangement, sphere_arrangement
from .enumeration.sequence import FaceSequence
from .planes import Face, Planes
from .plugins import display


class Arrangement(Planes):
    """Finitely many planes ``n_i . x = b_i`` in R^d, and the faces into which they cut it.

    Each plane keeps its own orientation and its place in the input. It is stored as the positive
    multiple with coprime integer entries, so that equal planes compare equal: ``[2, 0, 0]`` and
    ``[1, 0, 0]`` give equal arrangements, ``[-1, 0, 0]`` does not (its sides are exchanged).

    Args:
        normals: m vectors of length d, exact numbers (see `arrangement.rational`).
        offsets: m exact numbers; if omitted, all planes pass through the origin.
        dimension: d; needed only when there are no planes.
        axes: names of the coordinates where these mean something; see `Planes`.

    Raises:
        InputError: a float, a zero normal (named by its index), or lengths that differ.

    >>> three = Arrangement([[1, 0, 0], [0, 1, 0], ["1/2", "1/3", 1]])
    >>> three.f_vector
    (1, 6, 12, 8)
    """

    def iter_faces(self, dimension: int | None = None) -> Iterator[Face]:
        """Yield every face (of one dimension, if given) with an exact witness, as `faces` does."""
        return iter(self.faces(dimension))

    def faces(self, dimension: int | None = None, *, engine: str | None = None) -> FaceSequence:
        """Return every face, or those of one dimension, lowest dimension first.

        Args:
            dimension: 0 to d.
            engine: one of `arrangement.enumeration.choose.ENGINES`, which says what each can do;
                if omitted, the best one for these planes.

        Raises:
            InputError: no such dimension or engine, or an engine that cannot do these planes.
        """
        found = self._faces if engine is None else enumerate_faces(self, engine)
        return found if dimension is None else found.of_dimension(dimension)

    @cached_property
    def _faces(self) -> FaceSequence:
        return enumerate_faces(self)

    def regions(self) -> FaceSequence:
        """Return the faces of full dimension: the cells that no plane meets."""
        return self.faces(self.dimension)

    @property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of dimension 0, 1, ..., d, by enumeration."""
        return self._faces.f_vector

    def sphere(self) -> SphereArrangement:
        """Return the great circles of a central arrangement in R^3, with their full incidence."""
        return sphere_arrangement(self)

    def certify_complete(self) -> completeness.CompletenessEvidence:
        """Compare `faces` with Zaslavsky's theorem, face by face and in number."""
        return completeness.certify_complete(self, self.faces())

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the great circles, where there are any."""
        return display("arrangement-svg", self)

    def _repr_html_(self) -> str | None:
        """Return what a notebook shows where there is no picture: a table of counts."""
        return display("arrangement-html", self)
