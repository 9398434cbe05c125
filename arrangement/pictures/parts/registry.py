"""All that can be drawn of an arrangement, a line each, and which planes each view shows."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Concatenate, ParamSpec

from arrangement.arrangement import Arrangement
from arrangement.drawing.registry import ViewEntry
from arrangement.drawing.scene.scene import Scene
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.planes.planes import Planes

from .essential import caption, in_space

P = ParamSpec("P")


@dataclass(frozen=True)
class Ranks:
    """Which planes a view shows: those of ranks from `least` to `most`, or only central ones."""

    most: float = math.inf
    central: bool = False
    least: int = 0

    def __call__(self, planes: Planes) -> bool:
        """Return whether it shows planes."""
        in_range = self.least <= planes.rank <= self.most
        return in_range and (planes.is_central or not self.central)


_ALL = Ranks()
#: Where each view is, and which planes it shows.
VIEWS: Mapping[str, ViewEntry] = {
    "sphere": ViewEntry("sphere.sphere:draw_sphere", Ranks(3, central=True)),
    "planes": ViewEntry("space.planes:draw_planes", Ranks(3)),
    "cells": ViewEntry("space.cells:draw_cells", Ranks(3)),
    "lines": ViewEntry("diagrams.lines:draw_lines", Ranks(2)),
    "stereographic": ViewEntry("sphere.stereographic:draw_stereographic", Ranks(3, central=True)),
    "gnomonic": ViewEntry("sphere.gnomonic:draw_gnomonic", Ranks(3, central=True)),
    "dual": ViewEntry("duals.dual:draw_dual", Ranks(4, central=True)),
    "section": ViewEntry("space.planes:draw_section", Ranks(4, central=True, least=4)),
    "graph": ViewEntry("duals.graph:draw_graph", _ALL),
    "poset": ViewEntry("duals.poset:draw_poset", _ALL),
    "lattice": ViewEntry("diagrams.lattice:draw_lattice", _ALL),
}
MODELS: Mapping[str, ViewEntry] = {
    "dual": ViewEntry("duals.dual:dual_model", Ranks(4, central=True)),
    "cells": ViewEntry("space.cells:cells_model", Ranks(3)),
}
PAGES: Mapping[str, ViewEntry] = {
    "arrangement": ViewEntry("lab.arrangement_page:arrangement_page", Ranks(3, central=True)),
    "cells": ViewEntry("space.cells:cells_page", Ranks(3)),
}


def fits(view: str, planes: Planes) -> bool:
    """Return whether a view or page can show planes."""
    return {**PAGES, **VIEWS}[view].shows(planes)


def space(view: str, planes: Planes) -> int:
    """Return the dimension of the space in which a view draws planes."""
    flat = view == "lines" or (view == "graph" and not planes.is_central)
    return max(2 if flat else 3, planes.rank)


def suited(views: Mapping[str, ViewEntry], planes: Planes) -> dict[str, ViewEntry]:
    """Return views in the order in which they suit planes, those that cannot show them last."""

    first = "sphere" if planes.is_central else "cells"
    if planes.rank <= 2 and planes.dimension != 3:
        first = "lines"
    elif planes.rank > 3:
        first = "dual" if fits("dual", planes) else "lattice"

    def rank(name: str) -> tuple[bool, bool]:
        return not views[name].shows(planes), name != first

    return {name: views[name] for name in sorted(views, key=rank)}


def shown_as(
    name: str,
) -> Callable[
    [Callable[Concatenate[Arrangement, P], Scene]], Callable[Concatenate[Arrangement, P], Scene]
]:
    """Return a decorator: the view `name` draws planes of any space, with a caption.

    Raises:
        InputError: the view cannot show the planes; others that can are named.
    """

    def decorate(
        view: Callable[Concatenate[Arrangement, P], Scene],
    ) -> Callable[Concatenate[Arrangement, P], Scene]:
        @functools.wraps(view)
        def draw(arrangement: Arrangement, /, *args: P.args, **options: P.kwargs) -> Scene:
            scene = view(brought(arrangement, name), *args, **options)
            if text := caption(arrangement, space(name, arrangement)):
                scene.legend.captions.append(text)
            return scene

        return draw

    return decorate


def brought(arrangement: Arrangement, view: str) -> Arrangement:
    """Return planes in the space of a view.

    Raises:
        InputError: the view cannot show them.
    """
    budget.check_size(len(arrangement), "planes in a picture")
    if not fits(view, arrangement):
        shown: Any = {**PAGES, **VIEWS}[view].shows
        kind = "central" if arrangement.is_central else "affine"
        others = [name for name in VIEWS if fits(name, arrangement)]
        raise InputError(
            f"{view} shows {'central ' * shown.central}planes of rank "
            f"{'at most ' * (not shown.least)}{shown.most}; these are {kind}, of rank "
            f"{arrangement.rank} in R^{arrangement.dimension}: "
            f"for them there are {', '.join(others)}"
        )
    return in_space(arrangement, space(view, arrangement))
