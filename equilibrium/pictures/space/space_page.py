"""A grasp in space as an interactive page and as a 3D-printable model."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from arrangement.console.number_form import LABEL
from arrangement.drawing.colours import BLACK
from arrangement.drawing.output import millimetres
from arrangement.drawing.pages.solid_page import PageFace, SolidPage, page_face
from arrangement.drawing.registry import Vector
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.pieces import Arrow, head_of, open_edges
from arrangement.drawing.solids.sight import picture_axes, view_direction
from arrangement.drawing.solids.surface import Patch, rounded
from arrangement.errors import InputError
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.parts.style import CONE_EDGE, CONE_FILL, Wrench, wrench_text

from .solid_grasp import INKS, SolidGrasp
from .space_grasp import clear_side, motion_text, solved_in_space

_BODY = "#dfe6ea" + "60"
#: Radius of the shafts of arrows in a model.
_SHAFT = 0.008
_TELLS = ("cone", "normal", "preload", "force", "slip")


def grasp_page(
    grasp: Grasp,
    *,
    wrench: Wrench | None = None,
    camera: Vector | None = None,
    title: str | None = None,
) -> str:
    """Build a self-contained HTML page: a grasp in space, to rotate.

    Body, contacts, friction cones and preloads; with a wrench, forces and motion of an equilibrium.
    Under the pointer a cone or an arrow shows its contact in exact numbers.

    Args:
        grasp: contacts, in space.
        wrench: applied, six numbers; if omitted, none acts and nothing is solved.
        camera: exact vector to the viewer at first; if omitted, as for the picture.
        title: a heading; if omitted, the number of contacts.
    """
    solid, note = solved_in_space(grasp, wrench)
    towards = clear_side(solid) if camera is None else view_direction(camera)
    tree = solid.tree()
    number_of = grasp.size_words
    facts = [note or None, wrench_text(solid.wrench, grasp.units) if any(solid.wrench) else None]
    facts.append(motion_text(solid) if solid.motion else None)
    legend = [(CONE_EDGE, "friction cone")]
    legend += [(INKS["force"], "contact force")] * any(map(any, solid.forces))
    legend += [(INKS["wrench"], "applied wrench")] * any(solid.wrench)
    legend += [(INKS["slip"], "axis of the motion, and slips")] * (solid.screw is not None)
    reach = max(
        (float(np.linalg.norm(rounded(p.corners), axis=1).max()) for n in tree for p in n.patches),
        default=1.0,
    )
    return SolidPage(
        title if title is not None else f"A grasp in space, {number_of}",
        "; ".join(filter(None, facts)),
        str(grasp.units) if grasp.units else number_of,
        picture_axes(towards),
        reach,
        [node.drawn_as(_face) for node in tree],
        [(name.capitalize(), _told(solid, i)) for i, name in enumerate(grasp.point_names)],
        legend,
        marks=[
            (solid.places[k] - 0.12 * solid.normals[members].mean(axis=0), text)
            for k, members, text in solid.groups
        ],
    ).text()


def _face(patch: Patch) -> PageFace:
    kind, _, contact = patch.name.partition("-")
    fill = _BODY if kind == "body" else CONE_FILL if kind == "cone" else INKS.get(kind, CONE_EDGE)
    number, faint = int(contact) - 1 if kind in _TELLS else -1, kind == "link"
    ink = BLACK if kind == "body" else INKS.get(kind, CONE_EDGE)
    return page_face(patch, fill, number, sheet=True, faint=faint, ink=ink)


def _told(solid: SolidGrasp, i: int) -> list[tuple[str, str]]:
    """Return what the page says of a contact."""
    contact = solid.grasp.contacts[i]
    facts = [("point", LABEL.vector(contact.point)), ("normal", LABEL.vector(contact.normal))]
    facts += [(name, LABEL.number(getattr(contact, name))) for name in contact.stated]
    if solid.forces:
        force = ", ".join(f"{float(x):.4g}" for x in solid.forces[i])
        facts.append(("force", f"({force})"))
    return facts


def grasp_model(
    grasp: Grasp, suffix: str, *, wrench: Wrench | None = None, size: float = 100.0
) -> bytes:
    """Build a grasp in space as a model: body, cones and arrows, one part each.

    With a wrench, the forces and the motion of an equilibrium. In GLB and OBJ each part has a name,
    such as ``force-2``, and in GLB the body shines through. A body that is not closed is left out.

    Args:
        grasp: contacts, in space.
        suffix: ``.stl``, ``.glb`` or ``.obj``.
        wrench: applied, six numbers; if omitted, none acts and nothing is solved.
        size: the longest side of the bounding box, in millimetres.

    Raises:
        InputError: a grasp without contacts.
    """
    solid, _ = solved_in_space(grasp, wrench)
    half = millimetres(size, "size") / 2
    points, faces, _ = solid.body
    closed = bool(faces) and not any(open_edges(faces))
    parts = [_part("body", [(points, faces)], _BODY, half)] if closed else []
    for i, apex, rim in solid.cones:
        if len(rim) > 1:
            k = len(rim)
            sides = [(0, 1 + (j + 1) % k, 1 + j) for j in range(k)]
            cone = np.vstack([apex, rim]), [*sides, tuple(range(1, k + 1))]
            parts.append(_part(f"cone-{i}", [cone], CONE_FILL, half))
    solids: dict[str, list[Any]] = {}
    for arrow in solid.arrows():
        solids.setdefault(arrow.name, []).extend(_solids(arrow))
    parts += [_part(name, s, INKS[name.partition("-")[0]], half) for name, s in solids.items()]
    if not parts:
        raise InputError("the grasp has no contacts and no body, so there is no model of it")
    return model_bytes(parts, suffix, f"a grasp in space, {grasp.size_words}")


def _part(
    name: str, solids: Iterable[tuple[Floats, Sequence[tuple[int, ...]]]], colour: str, half: float
) -> ClosedSurface:
    """Return several closed surfaces as one part."""
    points: list[Floats] = []
    faces: list[tuple[int, ...]] = []
    count = 0
    for own, cycles in solids:
        faces += [tuple(k + count for k in cycle) for cycle in cycles]
        points.append(own)
        count += len(own)
    return ClosedSurface(name, half * np.concatenate(points), tuple(faces), (colour,) * len(faces))


def _solids(arrow: Arrow) -> list[tuple[Floats, list[tuple[int, ...]]]]:
    """Return the shaft of an arrow as a prism, and its head as a pyramid."""
    tip, ring = head_of(arrow)
    k, neck = len(ring), ring.mean(axis=0)
    thin = (ring - neck) * (_SHAFT / float(np.linalg.norm(ring[0] - neck)))
    end = arrow.end if arrow.headless else neck
    base, top = tuple(range(k - 1, -1, -1)), tuple(range(k, 2 * k))
    sides = [(j, (j + 1) % k, k + (j + 1) % k, k + j) for j in range(k)]
    found = [(np.vstack([arrow.start + thin, end + thin]), [base, top, *sides])]
    if not arrow.headless:
        slopes = [(0, 1 + j, 1 + (j + 1) % k) for j in range(k)]
        found.append((np.vstack([tip, ring]), [*slopes, tuple(range(k, 0, -1))]))
    return found
