"""The Schlegel diagram of a dual of rank 4, as a model."""

from __future__ import annotations

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.counts import region_count
from arrangement.drawing.colours import side_colour
from arrangement.drawing.solids.meshes import ClosedSurface, model_bytes
from arrangement.drawing.solids.sight import (
    face_normal,
    unit_vectors,
)
from arrangement.duals.schlegel import SchlegelDiagram, schlegel_diagram
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot
from arrangement.pictures.parts.coordinates import in_coordinates, symmetry
from arrangement.pictures.space.cells import centroid

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
