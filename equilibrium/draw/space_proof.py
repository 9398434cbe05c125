"""The proof that a wrench is not resisted, in space: each virtual motion as a screw."""

from __future__ import annotations

from arrangement.draw.legend import Key, Legend
from arrangement.draw.registry import Wrench
from arrangement.draw.scene import Scene
from equilibrium.certificate.spatial_leaves import spatial_leaves
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
    leaves = list(spatial_leaves(grasp, verdict.certificate.to_dict()["tree"], verdict.within))
    if not leaves:
        raise GraspError(
            "contacts and wrench lie in one plane, and so does the proof; draw the planar grasp"
        )
    shown = leaves[:_SHOWN]
    towards = clear_side(SolidGrasp(grasp, wrench=verdict.wrench))
    panel = min(width / len(shown), _PANEL)
    solids = [SolidGrasp(grasp, motion, (), verdict.wrench, virtual=True) for _, motion, _ in shown]
    panels = [drawn_in_space(solid, towards, panel, "") for solid in solids]
    scene = Scene(panel * len(panels), max(part.paper[1] for part in panels))
    for k, part in enumerate(panels):
        keys = part.legend.keys
        part.legend = Legend(keys=[] if k else [*keys[:-1], Key(*keys[-1][:2], _LAMBDA)])
        scene.place(part, k * scene.width / len(panels), (scene.height - part.height) / 2)
    for k, (solid, (states, motion, _)) in enumerate(zip(solids, shown, strict=True), 1):
        work = sum(a * b for a, b in zip(motion, verdict.wrench, strict=True))
        against = ", ".join(f"{i + 1} {text}" for i, text in sorted(states.items()))
        scene.legend.line(
            f"{k} of {len(leaves)}: {against or 'whatever the contacts do'}; λ is "
            f"{screw_text(solid)}; the load does work {number(work)}"
        )
    return scene
