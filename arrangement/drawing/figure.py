"""Views as functions that return figures of matplotlib, and several figures as panels of one."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, ParamSpec, Protocol, overload

from arrangement.errors import InputError

from .output import check_renamed, require_matplotlib
from .scene.layout import composed, laid_out
from .scene.scene import Scene, checked_width

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .path_artist import Drawing, Room

P = ParamSpec("P")


#: What holds for every view: said once, and added to the docstrings.
_WIDTH = "    width: of the figure, in millimetres.\n"
_AX = """    ax: axes, a figure or subfigure of matplotlib to draw into. The picture takes the room
        that is there and has no legend; each element is an artist with its name as ``gid``.
"""
_ABSENT = "    MissingExtraError: matplotlib is absent.\n"


class DrawingView(Protocol[P]):
    """A view as a function: it returns the figure in which it has drawn."""

    scene: Callable[..., Scene]

    @overload
    def __call__(self, *args: P.args, **options: P.kwargs) -> Drawing: ...
    @overload
    def __call__(self, subject: Any, /, *, ax: Room, **options: Any) -> Figure: ...


def picture(least: float = 40.0) -> Callable[[Callable[P, Scene]], DrawingView[P]]:
    """Return a decorator: a view draws its scene, with its legend, as a matplotlib figure.

    The scene stays within reach, for other writers: ``draw_sphere.scene``. Every view has a width,
    which is checked here.

    Args:
        least: the least width, in millimetres.
    """

    def decorate(view: Callable[P, Scene]) -> DrawingView[P]:
        @functools.wraps(view)
        def scene(*args: P.args, **options: P.kwargs) -> Scene:
            check_renamed(options, view.__annotations__)
            if "width" in options:
                options["width"] = checked_width(options["width"], least)
            return view(*args, **options)

        @functools.wraps(view)
        def draw(*args: Any, ax: Room | None = None, **options: Any) -> Figure:
            if ax is None:
                return drawing(scene(*args, **options))
            require_matplotlib()
            from .path_artist import into

            return into(
                ax, lambda width: laid_out(scene(*args, **{"width": width, **options}), "none")
            )

        text = inspect.cleandoc(view.__doc__ or "")  # Python 3.13 takes the indent away itself
        if "    width:" not in text:
            text = text.replace("\nRaises:", f"{_WIDTH}\nRaises:")
        text = text.replace("\nRaises:", f"{_AX}\nRaises:")
        draw.__doc__ = f"{text}\n{_ABSENT}"
        draw.__annotations__ = {**view.__annotations__, "return": "Drawing"}
        draw.scene = scene  # type: ignore[attr-defined]
        made: Any = draw
        return made  # type: ignore[no-any-return]

    return decorate


def drawing(scene: Scene) -> Drawing:
    """Return a picture with its legend as a figure.

    Raises:
        MissingExtraError: matplotlib is absent.
    """
    require_matplotlib()
    from .path_artist import Drawing

    return Drawing(scene)


def compose(
    figures: Iterable[Figure], columns: int = 2, titles: Sequence[str] | None = None
) -> Drawing:
    """Set figures beside each other, row by row, as panels of one figure with one legend.

    Panels keep their sizes; two of 88 mm fill a page of 180 mm. What all legends say is said once;
    what belongs to one panel, such as its captions, stands below it. Names of elements begin with
    the panel, as in ``panel-2-region-3``.

    Args:
        figures: that a view of either package has drawn.
        columns: how many panels stand side by side.
        titles: above the panels; if omitted, (a), (b), ...; empty texts for none.

    Raises:
        InputError: there are none, or others; bad columns or titles.
        MissingExtraError: matplotlib is absent.
    """
    scenes = [getattr(figure, "scene", None) for figure in figures]
    if not scenes or not all(isinstance(scene, Scene) for scene in scenes):
        raise InputError("compose takes figures that a view has drawn, without ax; give some")
    return drawing(composed([scene for scene in scenes if scene], columns, titles))
