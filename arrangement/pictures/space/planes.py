"""The planes of an arrangement in a ball or a cube, cut at their intersections, back to front."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.drawing.colours import chosen, plane_colour
from arrangement.drawing.scene.items import Floats
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.sight import light, lit, turned, view_direction
from arrangement.drawing.views import Exact, Vector, picture
from arrangement.duals.cells import cut_cells, read_signs
from arrangement.pictures.parts.coordinates import (
    AxisNames,
    caption,
    drawn_axes,
    in_coordinates,
    planes_view,
)
from arrangement.pictures.parts.names import Labels, RegionLabels, equation
from arrangement.pictures.space.sections import Equation, cut_out

from .lifted_cells import lifted_cells
from .planes_sheet import DrawnFacet, FacetPainter, PlanesSheet
from .stage import Stage, StagedAxes, clear_sight


@planes_view("planes")
def draw_planes(
    arrangement: Arrangement,
    *,
    body: str = "ball",
    centre: Vector | None = None,
    radius: Exact | None = None,
    camera: Vector | None = None,
    azimuth: float = 0.0,
    lift: Iterable[str] = (),
    colour: str | FacetPainter = "planes",
    labels: Labels | None = None,
    axes: AxisNames | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw the planes of an arrangement in R^3 inside a ball or a cube, cell by cell.

    Every facet is a polygon of its own (``facet-3-plane-1``), cut at the other planes. They are
    painted back to front in an exact order (see `depth_tree`), so that nothing hides wrongly. The
    projection is orthographic. A number beside the body names a plane: k for the k-th, counted
    from 1. For planes that are not central, the body contains all vertices (see `body_around`).

    Args:
        arrangement: of rank at most 3, central or not, coincident planes allowed; in another space
            than R^3 its essentialisation.
        body: "ball" or "cube".
        centre, radius: exact, of the body, instead of one that contains all vertices. For planes
            whose vertices are far apart; what is outside is left out.
        camera: exact vector to the viewer; if omitted, one in which no plane is edge-on.
        azimuth: as for `draw_sphere`.
        lift: sign vectors of cells such as ``"+-+"``, over the input planes. These cells are
            drawn as solids, moved outward.
        colour: "planes" (each its own colour), "shade" (grey by the angle to the light), "none",
            or a function from a `DrawnFacet` to a colour.
        labels: of lifted cells, as for `draw_sphere`.
        axes: names of the axes; True for ``x,y,z``; or "none"; if omitted, there are some
            where the coordinates have a meaning, as x, y, r of the motions of a grasp.
        sides: mark the positive side of each plane by an arrow.
        coordinates: as for `draw_sphere`; "given" if omitted and the body has a given place.

    Raises:
        InputError: another space, too many planes, no such cell, lifted cells that run into
            each other, unknown body or colouring.
    """
    paint = _painter(colour)
    texts = [lift] if isinstance(lift, str) else list(lift)
    raised = [read_signs(arrangement, text) for text in texts]
    names = RegionLabels(arrangement, labels, len(raised))
    if coordinates is None and not (centre is None and radius is None):
        coordinates = "given"
    shown, coordinates = drawn_axes(arrangement, axes, coordinates)
    arrangement, camera = in_coordinates(coordinates, arrangement, camera)
    toward = None if camera is None else view_direction(camera)
    cells = cut_cells(arrangement, body, centre, radius)
    if toward is None:
        toward = clear_sight(cells, raised)
    stage = Stage(cells, turned(toward, azimuth))
    lifted = lifted_cells(stage, raised)
    sheet = PlanesSheet(stage, lifted, paint, width, StagedAxes(stage, shown))
    if sides:
        sheet.mark_sides()
    sheet.number_planes()
    sheet.name_axes()
    sheet.name_cells(names)
    names.explain(sheet.scene.legend, raised)
    return sheet.scene


@picture()
def draw_section(
    arrangement: Arrangement,
    *,
    section: Equation | None = None,
    body: str = "ball",
    camera: Vector | None = None,
    azimuth: float = 0.0,
    lift: Iterable[str] = (),
    colour: str | FacetPainter = "planes",
    labels: Labels | None = None,
    sides: bool = False,
    width: float = 88.0,
    coordinates: str | None = None,
) -> Scene:
    """Draw what central hyperplanes of rank 4 cut out on another one, as planes in R^3.

    A caption has the equation of the hyperplane. Elements and signs are those of planes in R^3.

    Args:
        arrangement: central, of rank 4.
        section: the hyperplane ``a x1 + b x2 + c x3 + d x4 = e`` as ``a,b,c,d,e``; if omitted, one
            with small coefficients that meets lines of intersection not far off.
        body, azimuth, lift, colour, labels, sides: as for `draw_planes`.
        camera: as for `draw_planes`, in orthonormal coordinates of the hyperplane.
        coordinates: as for `draw_sphere`.

    Raises:
        InputError: other planes, a bad hyperplane; or as for `draw_planes`.
    """
    flat, (*normal, offset) = cut_out(arrangement, section, coordinates)
    scene: Scene = draw_planes.scene(
        flat,
        body=body,
        camera=camera,
        azimuth=azimuth,
        lift=lift,
        colour=colour,
        labels=labels,
        sides=sides,
        width=width,
        coordinates="given",
    )
    cut = equation(tuple(normal), offset).replace("-", "\u2212")
    scene.legend.captions.append(f"section by {cut}")
    if text := caption(arrangement, 4):
        scene.legend.captions.append(text)
    return scene


def _painter(colour: str | FacetPainter) -> FacetPainter:
    painters: dict[str, FacetPainter] = {
        "planes": lambda facet: lit(plane_colour(facet.label), _facing(facet), 0.7),
        "shade": lambda facet: lit("#ffffff", _facing(facet), 0.1),
        "none": lambda facet: "#ffffff",
    }
    return chosen(colour, painters)


def _facing(facet: DrawnFacet) -> Floats:
    """Return the normal of a facet on the side of the light."""
    normal = np.array(facet.normal)
    return normal if light(normal) else -normal
