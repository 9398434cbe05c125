"""The proof that a wrench is not resisted, in space: each virtual motion as a screw."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from arrangement.draw.legend import Key, Legend
from arrangement.draw.registry import Wrench
from arrangement.draw.scene import Scene
from arrangement.exact import RationalVector, rational
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.spatial_verdict import NOT_RESISTED, solve_in_space

from .solid_grasp import SolidGrasp
from .space_grasp import clear_side, drawn_in_space, screw_text
from .style import number

#: So many leaves are shown, side by side.
_SHOWN = 3
#: The largest width of each, in millimetres.
_PANEL = 88.0
_LAMBDA = "virtual motion λ: its axis, and how it moves the contacts"


def proof_in_space(grasp: Grasp, wrench: Wrench, width: float) -> Scene:
    """Return the picture; see `equilibrium.draw.proof.draw_proof`.

    Raises:
        GraspError: the wrench is resisted, or that is undecided.
    """
    verdict = solve_in_space(grasp, wrench)
    if verdict.verdict != NOT_RESISTED or verdict.certificate is None:
        raise GraspError(
            f"the wrench is {verdict.verdict}, so there is no proof that it is not; draw the grasp"
        )
    leaves = list(_leaves(verdict.certificate.to_dict()["tree"], {}, {}))
    shown = leaves[:_SHOWN]
    towards = clear_side(SolidGrasp(grasp, wrench=verdict.wrench))
    panel = min(width / len(shown), _PANEL)
    solids = [SolidGrasp(grasp, motion, (), verdict.wrench, virtual=True) for _, motion in shown]
    panels = [drawn_in_space(solid, towards, panel, "") for solid in solids]
    scene = Scene(panel * len(panels), max(part.paper[1] for part in panels))
    for k, part in enumerate(panels):
        keys = part.legend.keys
        part.legend = Legend(keys=[] if k else [*keys[:-1], Key(*keys[-1][:2], _LAMBDA)])
        scene.place(part, k * scene.width / len(panels), (scene.height - part.height) / 2)
    for k, (solid, (states, motion)) in enumerate(zip(solids, shown, strict=True), 1):
        work = sum(a * b for a, b in zip(motion, verdict.wrench, strict=True))
        against = ", ".join(f"{i} {text}" for i, text in sorted(states.items()))
        scene.legend.line(
            f"{k} of {len(leaves)}: {against or 'whatever the contacts do'}; λ is "
            f"{screw_text(solid)}; the load does work {number(work)}"
        )
    return scene


def _leaves(
    tree: Any, states: Mapping[int, str], sectors: Mapping[int, tuple[Any, Any]]
) -> Iterator[tuple[Mapping[int, str], RationalVector]]:
    """Yield the leaves: what is assumed of contacts, and the virtual motion."""
    if not isinstance(tree, Mapping) or "virtual_motion" in tree:
        motion = tree["virtual_motion"] if isinstance(tree, Mapping) else tree
        yield states, tuple(rational(x) for x in motion)
        return
    contact = tree["contact"] + 1
    if "attachment" in tree:
        for name, child in tree["attachment"].items():
            yield from _leaves(child, {**states, contact: name}, sectors)
        return
    ends, children = [tuple(end) for end in tree["directions"]], list(tree["children"])
    if contact in sectors:
        ends = [sectors[contact][0], *ends, sectors[contact][1]]
    else:
        ends.append(ends[0])
        yield from _leaves(children.pop(0), {**states, contact: "sticks"}, sectors)
    for sector, child in zip(pairwise(ends), children, strict=True):
        text = f"slips between {sector[0]} and {sector[1]}"
        yield from _leaves(child, {**states, contact: text}, {**sectors, contact: sector})
