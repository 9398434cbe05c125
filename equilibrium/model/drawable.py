"""The method `Grasp.draw`; the stub beside this file has the options of each view.

It is written by ``python -m tests.draw_stubs`` from the views, for editors and type checkers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from arrangement.console.plugins import method_code
from arrangement.hints import hints_on_arguments

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing


class DrawableGrasp:
    """What can be drawn."""

    __slots__ = ()

    @hints_on_arguments({})
    def draw(self, view: str | None = None, **options: Any) -> Drawing:
        """Draw a picture as a figure of matplotlib (the extra ``figures``), which writes TikZ, too.

        Args:
            view: "grasp", "resist", "slice", "polar", "compare", "methods", "proof" or
                "wrench-set"; if omitted, the first.
            options: those of the view, such as ``wrench``; ``ax`` to draw into axes of yours.

        Raises:
            InputError: an unknown view or option, or a grasp that the view cannot show.
            MissingExtraError: matplotlib is absent.
        """
        made: Drawing = method_code("Grasp.draw").of(self).draw(self, view, **options)
        return made
