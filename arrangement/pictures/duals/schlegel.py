"""The dual of rank 4 on paper, and as a model: its Schlegel diagram."""

from __future__ import annotations

from typing import Any

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts import region_count
from arrangement.drawing.colours import Choice, side_colour
from arrangement.drawing.registry import Vector
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.sight import (
    best_view,
    face_normal,
    picture_axes,
    turned,
    unit_vectors,
    view_direction,
    views,
)
from arrangement.duals.schlegel import SchlegelDiagram, schlegel_diagram
from arrangement.errors import extra
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.pictures.parts.coordinates import in_coordinates, symmetry
from arrangement.pictures.parts.names import Labels, RegionLabels, plane_names
from arrangement.pictures.space.cells import centroid

from .graph import FEW, GraphPicture, PlacedGraph
from .solids import unit_lengths


def symmetric_diagram(arrangement: Arrangement, coordinates: str | None) -> SchlegelDiagram:
    """Return the dual with generators of length 1, seen through one of its largest facets.

    Of these it is a most symmetric one, and of those a round one.

    Raises:
        OutOfReachError: more regions than a picture can show.
    """
    budget.check_size(region_count(arrangement), "regions in a picture")
    arrangement, _ = in_coordinates(coordinates, arrangement)
    found = symmetry(arrangement)
    units = unit_vectors([plane[:-1] for plane in arrangement.distinct_planes])

    def fitness(ray: IntegerVector) -> tuple[float, ...]:
        kept = 1 if found is None else int(found.stabilizers(unit_vectors([ray]))[0])
        own = units[[not dot(plane[:-1], ray) for plane in arrangement.distinct_planes]]
        return kept, round(float(np.linalg.eigvalsh(own.T @ own)[1]), 6)

    return schlegel_diagram(arrangement, unit_lengths(arrangement), fitness)


def draw_schlegel(
    arrangement: Arrangement,
    coordinates: str | None,
    seen: tuple[Vector | None, float],
    colour: Choice | None,
    antipodes: str | None,
    labels: Labels | None,
    width: float,
) -> Scene:
    """Draw the Schlegel diagram of planes of rank 4 in R^4; arguments are those of `draw_dual`.

    `seen` are direction and azimuth.
    """
    diagram = symmetric_diagram(arrangement, coordinates)
    direction, azimuth = seen
    towards = _clear(diagram) if direction is None else view_direction(direction)
    places = diagram.places @ picture_axes(turned(towards, azimuth)).T
    signs = tuple(map(tuple, diagram.signs.tolist()))
    scene = Scene(width, width)
    outer = diagram.facets[diagram.outer]
    same = np.ptp(diagram.signs[list(outer)], axis=0) > 0
    planes = plane_names(np.flatnonzero(same).tolist())
    text = f"Schlegel diagram: the dual, seen through its facet of {len(outer)} vertices"
    scene.legend.line(f"{text}, of a ray on the planes {planes}")
    names = RegionLabels(arrangement, labels, most=FEW)
    graph = PlacedGraph(places, signs, diagram.edges)
    GraphPicture(arrangement, graph, scene, names, colour, antipodes).draw()
    return scene


def _clear(diagram: SchlegelDiagram) -> Any:
    """Return a direction from above in which no two vertices are near each other."""
    with extra("figures"):
        from scipy.spatial import KDTree

    def apart(seen: Any) -> list[float]:
        flat = (diagram.places @ picture_axes(way)[:2].T for way in seen)
        return [KDTree(points).query(points, 2)[0][:, 1].min() for points in flat]

    return best_view(views(range(-4, 5), range(-4, 5), range(1, 4), low=0.2, high=0.6), apart)


def schlegel_model(
    arrangement: Arrangement, suffix: str, size: float, explode: float, coordinates: str | None
) -> bytes:
    """Return the cells of the Schlegel diagram as closed parts that stand apart."""
    diagram = symmetric_diagram(arrangement, coordinates)
    whole = diagram.places * (size / np.ptp(diagram.places, axis=0).max())
    parts = []
    for k, cell in enumerate(diagram.cells):
        used = sorted({v for face in cell for v in face})
        number = {v: i for i, v in enumerate(used)}
        points, middle = whole[used], whole[used].mean(axis=0)
        faces = []
        for cycle in cell:
            face = tuple(number[v] for v in cycle)
            outward = face_normal(points[list(face)]) @ (points[face[0]] - middle) > 0
            faces.append(face if outward else face[::-1])
        shift = centroid(points, tuple(faces)) * (explode - 1)
        colours = tuple(side_colour(len(face)) for face in faces)
        parts.append(ClosedSurface(f"cell-{k + 1}", points, tuple(faces), colours, tuple(shift)))
    return model_bytes(parts, suffix, f"Schlegel diagram: {len(parts)} cells")
