"""The data of the paper's three-part figure: what two models resist, in one plane of wrenches."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from arrangement.numbers.exact import to_text
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.plane import FORCES, resisted_region


def resistance_figure(
    grasp: Grasp, spans: Sequence[Iterable[Any]] = FORCES, origin: Iterable[Any] = (0, 0, 0)
) -> dict[str, Any]:
    """Return the wrench-space slice, and the resisted wrenches without preload and with preload 1.

    Returns:
        A JSON form. ``grasp_wrench_space``: the corners, counter-clockwise, of the slice of the
        space with normal forces that sum to at most 1; ``no_preload`` and ``preload_1``: as
        `Region.to_dict`, where the border is drawn only where resistance ends.

    Source: [HaasHeger2018], the figure with parts (a), (b), (c).
    """
    frame, start = [tuple(span) for span in spans], tuple(origin)
    corners = GraspWrenchSpace(grasp, "L1").slice(start, *frame)
    slice_of_space = {"norm": "L1", "corners": [[to_text(x) for x in p] for p in corners]}
    unloaded, loaded = (
        resisted_region(grasp.with_preload(preload), frame, start) for preload in (0, 1)
    )
    return {
        "grasp_wrench_space": slice_of_space,
        "no_preload": unloaded.to_dict(),
        "preload_1": loaded.to_dict(),
    }
