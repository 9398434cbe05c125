"""The intersection lattice as a Hasse diagram."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.counts import Flat, IntersectionLattice, intersection_lattice
from arrangement.drawing.scene import GAP, POINTS, Floats, Scene, measure
from arrangement.drawing.views import picture
from arrangement.numbers import budget
from arrangement.pictures.coordinates import RAISED
from arrangement.pictures.names import plane_names

_INK = "#882255"


@picture()
def draw_lattice(arrangement: Arrangement, *, width: float = 88.0) -> Scene:
    """Draw the intersections of planes, ordered by reverse inclusion, as a Hasse diagram.

    One row for each rank, the whole space at the bottom; the planes stand in input order, and the
    order of the rows above keeps crossings few. A flat is named by the planes that contain it,
    counted from 1; runs of four and more are shortened. Where the names of a row do not fit even
    in small text they are rotated, and where they still do not fit the row has dots, and a note
    says so. At the left stand the number of flats of the rank and the sum of their Moebius
    values mu(whole space, X): the Whitney numbers. The value of a flat stands under its name.

    Elements: ``flat-2-5`` (rank, position in `IntersectionLattice.flats`) and ``cover-7``.

    Args:
        arrangement: any; for affine planes the diagram is a semilattice.

    Raises:
        InputError: more than 500 flats of one rank.
    """
    lattice = intersection_lattice(arrangement)
    largest = max(map(len, lattice.flats))
    budget.check_size(largest, "flats of one rank in a picture")
    return _HasseDiagram(lattice, width).draw()


@dataclass(frozen=True)
class _RankRow:
    """How the flats of one rank are written: in which size, turned or not, or as dots (size 0).

    `widths` are the shares of the flats in the width of the row.
    """

    names: list[str]
    values: list[str]
    size: float
    turned: bool
    heights: tuple[float, float]
    widths: list[float]

    @property
    def height(self) -> float:
        return sum(self.heights)


class _HasseDiagram:
    def __init__(self, lattice: IntersectionLattice, width: float) -> None:
        self.lattice = lattice
        margins = [self._margin(rank) for rank in range(len(lattice.flats))]
        self.left = max(measure(text, 6.0)[0] for text in margins) + 8.0
        self.right = width * POINTS - 4.0
        self.rows = [self._row(flats) for flats in lattice.flats]
        edges = sum(len(above) for level in lattice.covers for above in level)
        self.gap = min(70.0, max(26.0, 20.0 + 0.5 * edges))
        dots = [str(rank) for rank, row in enumerate(self.rows) if not row.size]
        height = sum(row.height for row in self.rows) + self.gap * (len(self.rows) - 1)
        self.scene = Scene(width, (height + 14.0) / POINTS)
        if dots:
            text = f"dots at rank {', '.join(dots)}: flats without their names"
            self.scene.legend.captions.append(text)
        self.scene.legend.line("under each name: the M\u00f6bius value \u03bc(whole space, flat)")
        self.margins = margins

    def _margin(self, rank: int) -> str:
        flats = self.lattice.flats[rank]
        total = sum(self.lattice.moebius[flat] for flat in flats)
        return f"rank {rank}\n{counted(len(flats), 'flat')}\n\u03a3\u03bc = {_sign_text(total)}"

    def _row(self, flats: tuple[Flat, ...]) -> _RankRow:
        names = [self._name(flat) for flat in flats]
        values = [_sign_text(self.lattice.moebius[flat]) for flat in flats]
        room = self.right - self.left
        for turned in (False, True):
            angle = 90.0 if turned else 0.0
            for size in (7.0, 6.0, 5.0):
                boxes = [measure(name, size, angle) for name in names]
                small = [measure(value, size - 0.5, angle) for value in values]
                widths = [max(w, v) for (w, _), (v, _) in zip(boxes, small, strict=True)]
                gap, most = (2.4 if turned else 5.0), max(widths)
                if (most + gap) * len(flats) <= room:
                    widths = [most] * len(flats)
                elif sum(widths) + gap * len(flats) > room:
                    continue
                heights = (max(h for _, h in boxes), max(h for _, h in small))
                if turned:
                    heights = (heights[0], heights[1] + 2.0)
                free = (room - sum(widths)) / len(flats)
                return _RankRow(names, values, size, turned, heights, [w + free for w in widths])
        return _RankRow(names, [], 0.0, False, (4.0, 0.0), [room / len(flats)] * len(flats))

    def _name(self, flat: Flat) -> str:
        if not flat.rank:
            return "\u211d" + str(flat.dimension).translate(RAISED)
        return plane_names(self.lattice.arrangement, flat.planes)

    def draw(self) -> Scene:
        lattice, scene = self.lattice, self.scene
        orders = layered_orders([len(flats) for flats in lattice.flats], lattice.covers, fixed=2)
        bottom, spans = 8.0, []
        for rank, row in enumerate(self.rows):
            widths = np.array(row.widths)[orders[rank]]
            x = np.empty(len(widths))
            x[orders[rank]] = self.left + np.cumsum(widths) - widths / 2
            look: dict[str, Any] = {"anchor": (0.0, 0.5), "color": "0.25", "multialignment": "left"}
            scene.write((4.0, bottom + row.height / 2), self.margins[rank], 6.0, **look)
            spans.append(self._write_row(rank, x, bottom))
            bottom += row.height + self.gap
        self._covers(spans)
        return scene

    def _write_row(self, rank: int, x: Floats, bottom: float) -> Floats:
        """Write one row; return x, bottom and top (n, 3) of each flat, where covers are tied."""
        row, spans = self.rows[rank], []
        lower = row.heights[1]
        angle = 90.0 if row.turned else 0.0
        dot = min(1.3, 0.4 * row.widths[0])
        for k, at in enumerate(x.tolist()):
            gid = f"flat-{rank}-{k}"
            foot = (at, bottom + lower)
            if not row.size or not self.scene.write(
                foot, row.names[k], row.size, anchor=(0.5, 0.0), rotation=angle, gid=gid
            ):
                self.scene.circle((at, bottom + 2.0), dot, fc="black", zorder=4, gid=gid)
                spans.append((at, bottom + 2.0, bottom + 2.0))
                continue
            if row.values:
                under = foot[1] - GAP - (2.0 if row.turned else 0.1)
                look: dict[str, Any] = {"anchor": (0.5, 1.0), "rotation": angle, "color": _INK}
                self.scene.write((at, under), row.values[k], row.size - 0.5, **look)
            top = foot[1] + measure(row.names[k], row.size, angle)[1]
            spans.append((at, bottom - 2.5, top + 0.8))
        return np.array(spans)

    def _covers(self, spans: list[Floats]) -> None:
        number = 0
        for rank, level in enumerate(self.lattice.covers[:-1]):
            edges = sum(map(len, level))
            style: dict[str, Any] = {"lw": 0.7 if edges < 60 else 0.4 if edges < 300 else 0.2}
            style["ec"] = "0.2" if edges < 60 else "0.4"
            for k, above in enumerate(level):
                for cover in above:
                    ends = [spans[rank][k, [0, 2]], spans[rank + 1][cover, [0, 1]]]
                    self.scene.line(ends, zorder=2, gid=f"cover-{number}", **style)
                    number += 1


def _sign_text(value: int) -> str:
    return f"\u2212{-value}" if value < 0 else str(value)


Covers: TypeAlias = Sequence[Sequence[Sequence[int]]]

#: More edges than this between two layers are not counted for crossings.
_COUNTED = 2500
#: So often layers are sorted by the means of their neighbours, up and down in turn; the order with
#: the fewest crossings is kept (K. Sugiyama, S. Tagawa, M. Toda, IEEE Trans. SMC 11 (1981)).
_SWEEPS = 16


def layered_orders(sizes: Sequence[int], covers: Covers, fixed: int = 0) -> list[list[int]]:
    """Return an order of the nodes of every layer.

    Args:
        sizes: the number of nodes of each layer.
        covers: for each layer and each node, its neighbours in the next layer.
        fixed: this many layers, the first ones, keep their order.
    """
    below = [_lower_covers(covers[k], sizes[k + 1]) for k in range(len(sizes) - 1)]
    orders = [list(range(size)) for size in sizes]
    best, fewest = orders, _crossings(orders, covers)
    for sweep in range(_SWEEPS):
        orders = [list(order) for order in orders]
        if sweep % 2:
            for k in range(len(sizes) - 2, fixed - 1, -1):
                orders[k] = _sort_layer(orders[k], orders[k + 1], covers[k])
        else:
            for k in range(max(1, fixed), len(sizes)):
                orders[k] = _sort_layer(orders[k], orders[k - 1], below[k - 1])
        count = _crossings(orders, covers)
        if count < fewest:
            best, fewest = orders, count
    return best


def _lower_covers(covers: Sequence[Sequence[int]], size: int) -> list[list[int]]:
    below: list[list[int]] = [[] for _ in range(size)]
    for node, above in enumerate(covers):
        for cover in above:
            below[cover].append(node)
    return below


def _sort_layer(
    order: Sequence[int], beside: Sequence[int], neighbours: Sequence[Sequence[int]]
) -> list[int]:
    """Return a layer in the order of the mean places of its neighbours in the layer beside it."""
    place = {node: (k + 0.5) / len(beside) for k, node in enumerate(beside)}
    own = {node: (k + 0.5) / len(order) for k, node in enumerate(order)}

    def mean(node: int) -> float:
        around = [place[other] for other in neighbours[node]]
        return round(sum(around) / len(around), 9) if around else own[node]

    return sorted(order, key=lambda node: (mean(node), own[node]))


def _crossings(orders: Sequence[Sequence[int]], covers: Covers) -> int:
    """Return the number of pairs of edges that cross between neighbouring layers."""
    total = 0
    for k in range(len(orders) - 1):
        low = {node: i for i, node in enumerate(orders[k])}
        high = {node: i for i, node in enumerate(orders[k + 1])}
        edges = [(low[u], high[v]) for u, above in enumerate(covers[k]) for v in above]
        if len(edges) <= _COUNTED:
            a, b = np.array(edges).reshape(-1, 2).T
            total += int(((a[:, None] < a) & (b[:, None] > b)).sum())
    return total
