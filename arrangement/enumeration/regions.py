"""Regions together: which are bounded, which are neighbours, how far apart they are.

All of it is read off the sign vectors of the faces; no geometry of a region is worked out.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from arrangement.errors import InputError
from arrangement.numbers.exact import shown
from arrangement.numbers.linear.rank import rank
from arrangement.planes.faces import Face
from arrangement.planes.planes import Planes

from .choose import enumerate_faces
from .sequence import FaceSequence

if TYPE_CHECKING:
    import networkx as nx
    import sympy

#: Entries of a table of regions by directions that are worked out at once.
_BLOCK = 1 << 24


def bounded_regions(
    planes: Planes, regions: FaceSequence, *, relative: bool = False
) -> FaceSequence:
    """Return the regions that contain no ray; with `relative`, none in the span of the normals.

    A region contains a ray exactly when its closure has an extreme one, and these are the rays of
    the planes moved to the origin that have none of its signs reversed.
    """
    lineality = planes.dimension - planes.rank
    if (lineality and not relative) or planes.has_common_point or not len(regions):
        return regions.where(np.full(len(regions), not planes.rank and (relative or not lineality)))
    rays = enumerate_faces(Planes(planes.normals)).of_dimension(1 + lineality)
    return regions.where(~_recede_along(rays, regions))


def numbers_of_facets(
    planes: Planes, faces: FaceSequence, among: FaceSequence | None = None
) -> dict[int, int]:
    """Return how many regions, or some of them, have k facets, by k."""
    chosen = None if among is None else {row.tobytes() for row in among.signs}
    signs = faces.of_dimension(planes.dimension).signs
    pairs = zip(signs, walls(planes, faces), strict=True)
    sizes = Counter(len(x) for row, x in pairs if chosen is None or row.tobytes() in chosen)
    return dict(sorted(sizes.items()))


def levels(planes: Planes, regions: FaceSequence) -> NDArray[np.intp]:
    """Return the level of each region: the dimension of its recession cone.

    That is the closure of a face of the planes moved to the origin, and the largest one that has
    none of the signs of the region reversed.
    """
    levels = np.full(len(regions), planes.dimension - planes.rank)
    moved = enumerate_faces(Planes(planes.normals, dimension=planes.dimension))
    for dimension in range(planes.dimension - planes.rank + 1, planes.dimension + 1):
        levels[_recede_along(moved.of_dimension(dimension), regions)] = dimension
    return levels


def _recede_along(directions: FaceSequence, regions: FaceSequence) -> NDArray[np.bool_]:
    """Return which regions contain, from any of their points on, one of some central faces."""
    columns = directions.signs.astype(np.float32).T
    sizes = np.abs(columns).sum(axis=0)
    rows = max(1, _BLOCK // len(directions))
    # sums of at most m products of signs, which floats hold exactly
    return np.concatenate(
        [
            (regions.signs[start : start + rows] @ columns == sizes).any(axis=1)
            for start in range(0, len(regions), rows)
        ]
    )


def neighbours(planes: Planes, faces: FaceSequence) -> list[tuple[int, int, int]]:
    """Return the two regions beside each facet, by their places, and the class of its planes."""
    if not planes.dimension:
        return []
    regions, facets = faces.of_dimension(planes.dimension), faces.of_dimension(planes.dimension - 1)
    place = {row.tobytes(): i for i, row in enumerate(regions.signs)}
    across = (facets.signs == 0) * np.array(planes.orientation, np.int8)
    pairs = zip(facets.signs - across, facets.signs + across, across, strict=True)
    return [
        (place[below.tobytes()], place[above.tobytes()], planes.class_of[int(here.argmax())])
        for below, above, here in pairs
    ]


def region_graph(planes: Planes, faces: FaceSequence) -> nx.Graph[Face]:
    """Return the graph of all regions; see `Arrangement.region_graph`."""
    import networkx as nx

    regions = faces.of_dimension(planes.dimension)[:]
    graph: nx.Graph[Face] = nx.Graph()
    graph.add_nodes_from(regions)
    graph.add_edges_from(
        (regions[below], regions[above], {"planes": planes.distinct[label]})
        for below, above, label in neighbours(planes, faces)
    )
    return graph


def distances(planes: Planes, regions: FaceSequence, base: Face) -> list[int]:
    """Return for each region how many distinct planes separate it from the base.

    Raises:
        InputError: if the base is not a region of these planes.
    """
    if not isinstance(base, Face) or base.planes != planes or not all(base.signs):
        raise InputError(
            f"the base is {shown(base)}; give a region of these planes, one of `regions()` or "
            "`region_at(point)`"
        )
    first = list(planes.firsts)
    apart = regions.signs[:, first] != np.array(base.signs, np.int8)[first]
    numbers: list[int] = apart.sum(axis=1).tolist()
    return numbers


def poset_of_regions(planes: Planes, faces: FaceSequence, base: Face) -> nx.DiGraph[Face]:
    """Return the Hasse diagram of the regions; see `Arrangement.poset_of_regions`."""
    import networkx as nx

    graph = region_graph(planes, faces)
    ranks = distances(planes, faces.of_dimension(planes.dimension), base)
    poset: nx.DiGraph[Face] = nx.DiGraph()
    poset.add_nodes_from(
        (region, {"rank": level}) for region, level in zip(graph, ranks, strict=True)
    )
    for one, other, across in graph.edges(data=True):
        upwards = poset.nodes[one]["rank"] < poset.nodes[other]["rank"]
        poset.add_edge(*((one, other) if upwards else (other, one)), **across)
    return poset


def distance_enumerator(planes: Planes, regions: FaceSequence, base: Face) -> sympy.Poly:
    """Return the sum of t^distance over all regions."""
    import sympy

    terms = Counter(distances(planes, regions, base))
    return sympy.Poly.from_dict(dict(terms), sympy.Symbol("t"), domain=sympy.ZZ)


def walls(planes: Planes, faces: FaceSequence) -> list[list[int]]:
    """Return for each region the classes of planes that have a facet of it."""
    walls: list[list[int]] = [[] for _ in range(faces.f_vector[-1])]
    for below, above, label in neighbours(planes, faces):
        walls[below].append(label)
        walls[above].append(label)
    return walls


def simplicial_regions(planes: Planes, faces: FaceSequence) -> FaceSequence:
    """Return the regions that are simplices or simplicial cones; see `Face.is_simplicial`.

    With r the rank, these are r independent normals of facets where the planes have a point in
    common, and r + 1 facets of a region that is bounded in the span of the normals elsewhere.
    """
    regions, classes = faces.of_dimension(planes.dimension), walls(planes, faces)
    if planes.has_common_point:
        normals = [plane[:-1] for plane in planes.distinct_planes]
        return regions.where(
            [len(sides) == planes.rank == rank([normals[k] for k in sides]) for sides in classes]
        )
    few = regions.where([len(sides) == planes.rank + 1 for sides in classes])
    return bounded_regions(planes, few, relative=True)
