"""Segments in the plane: what their union has, and what it leaves of the plane."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

from arrangement import synonyms
from arrangement.arrangement import Arrangement
from arrangement.console.plugins import method_code
from arrangement.enumeration.subdivision import Pieces, segment_sheet
from arrangement.errors import InputError
from arrangement.hints import HintsMixin
from arrangement.numbers.arguments import entries
from arrangement.numbers.exact import RationalVector, rational_vector, shown
from arrangement.numbers.real import field_of, written
from arrangement.numbers.symbolic import entry, in_one_field
from arrangement.planes.planes import Names, checked_names
from arrangement.planes.polygon import line_through

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing

_Points: TypeAlias = Iterable[Any]


class Segments(HintsMixin):
    """Finitely many segments in R^2 with exact ends, which may cross, overlap and touch.

    Args:
        ends: for each segment its two different ends, with exact numbers as of `Arrangement`.
        names: of the segments, in their order, "" for none; or by number, from 1 on.

    Raises:
        InputError: a float, or what is not two different points of the plane.

    >>> square = [((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0))]
    >>> drawing = Segments([*square, ((0, 0), (1, 1)), ((1, 0), (0, 1))])
    >>> drawing.pieces()
    Pieces(vertices=5, edges=8, cells=5, bounded_cells=4, cells_by_edges={3: 4})
    """

    ends: tuple[tuple[RationalVector, RationalVector], ...]
    names: tuple[str, ...]
    _synonyms: ClassVar[Mapping[str, str]] = synonyms.SEGMENTS

    def __init__(self, ends: Iterable[_Points], names: Names = ()) -> None:
        pairs = [entries(pair, "ends", "ends") for pair in entries(ends, "segments", "segments")]
        for i, pair in enumerate(pairs):
            if len(pair) != 2:
                raise InputError(f"segments[{i}] is {shown(pair)}; give two points, its ends")
        named = [
            (f"segments[{i}][{k}]", p) for i, pair in enumerate(pairs) for k, p in enumerate(pair)
        ]
        points = in_one_field([rational_vector(p, name, entry) for name, p in named])
        self.ends = tuple(zip(points[::2], points[1::2], strict=True))
        for i, (p, q) in enumerate(self.ends):
            if len(p) != 2 or len(q) != 2 or p == q:
                raise InputError(
                    f"segments[{i}] is {shown(pairs[i])}; give two different points of R^2"
                )

        self.names = checked_names(names, len(self.ends), "segment")

    def __len__(self) -> int:
        return len(self.ends)

    def __eq__(self, other: object) -> bool:
        return self.ends == other.ends if isinstance(other, Segments) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.ends)

    def __repr__(self) -> str:
        return f"<Segments: {len(self)} in R^2>"

    @property
    def lines(self) -> Arrangement:
        """The lines of the segments, in their order, with their names."""
        rows = [line_through(p, q) for p, q in self.ends]
        offsets = [row[2] for row in rows]
        return Arrangement([row[:2] for row in rows], offsets, dimension=2, names=self.names)

    def named(self, names: Names) -> Segments:
        """Return the same segments with other names."""
        return Segments(self.ends, names)

    def pieces(self) -> Pieces:
        """Count the vertices, edges and cells (faces) of the drawing that the segments make.

        Vertices are ends of segments, and points where segments of different lines meet.

        Raises:
            OutOfReachError: it takes more than the budget.
        """
        return segment_sheet(self.ends).all_pieces()

    def draw(self, **options: Any) -> Drawing:
        """Draw the segments as a figure of matplotlib; see `pictures.draw_segments`."""
        made: Drawing = method_code("Segments.draw").draw(self, **options)
        return made

    def to_dict(self) -> dict[str, Any]:
        """Return the file form: ``{"segments": [[p, q], ...]}`` with a field if there is one."""
        document: dict[str, Any] = {"schema_version": 1}
        field = field_of(x for pair in self.ends for p in pair for x in p)
        if field is not None:
            document["field"] = field.to_dict()
        if self.names:
            document["names"] = list(self.names)
        document["segments"] = [[[*map(written, p)] for p in pair] for pair in self.ends]
        return document
