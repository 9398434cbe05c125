"""An interactive page: which forces a grasp resists. It is the slip lab, opened at its map."""

from __future__ import annotations

from arrangement.console.number_form import counted
from arrangement.console.plugins import named
from arrangement.drawing.registry import Wrench
from equilibrium.model.grasp import Grasp, read_wrench


def resist_page(grasp: Grasp, *, wrench: Wrench | None = None, title: str | None = None) -> str:
    """Return one HTML page, complete in itself: the resisted forces of a grasp.

    The plane of forces, at the torque of the load, shows every piece (one choice of contact
    states). The load can be dragged there, and the contacts beside it: the page tells whether the
    load is resisted, with which states, forces and motions, or proves that it is not.

    Args:
        grasp: as many contacts as the lab takes.
        wrench: at first; if omitted, none.
        title: a heading; if omitted, the number of contacts.

    Raises:
        InputError: a grasp in space, too many contacts or digits, or no wrench.
        OverflowError: the wrench is beyond floats.
    """
    if title is None:
        title = f"Forces that {counted(len(grasp), 'contact')} resist"
    load = read_wrench((0, 0, 0) if wrench is None else wrench)
    sum(map(float, load))  # OverflowError: beyond floats there is no place in the picture
    # The lab lies above the views.
    page: str = named("equilibrium.pictures.lab.page:lab_page")(
        grasp, wrench=load, title=title, first="forces"
    )
    return page
