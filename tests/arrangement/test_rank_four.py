"""Pictures of planes of rank 4, and of the graph and poset of regions in every rank."""

import json
from collections import Counter
from itertools import combinations, pairwise

import numpy as np
import pytest

from arrangement import Arrangement, InputError
from arrangement.counts import f_vector
from arrangement.counts.operations import addition, restriction
from arrangement.drawing.labels import sign_text
from arrangement.drawing.output import own_settings
from arrangement.drawing.scene import Label
from arrangement.drawing.tikz import tikz
from arrangement.duals.schlegel import schlegel_diagram
from arrangement.errors import OutOfReachError
from arrangement.library.families import catalan, coxeter, generic, random_integer, shi
from arrangement.numbers.exact import dot
from arrangement.pictures import DRAWINGS, draw_poset
from arrangement.pictures.coordinates import in_space, orbits
from arrangement.pictures.dual import dual_model, symmetric_diagram
from arrangement.pictures.planes import cut_out
from tests.drawn import elements

COINCIDENT = Arrangement(
    [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [-2, 0, 0, 0], [0, 0, 0, 1], [1, 1, 1, 1]]
)
#: Times a plane, in coordinates that hide it.
IN_R6 = Arrangement(
    [[1, 0, 0, 0, 1, 2], [0, 1, 0, 0, 1, 0], [0, 0, 1, 0, 0, 3], [0, 0, 0, 1, 2, 1],
     [1, 1, 1, 1, 4, 6]]
)  # fmt: skip
FOUR = {
    "A4": coxeter("A4"),
    "five generic": generic(5, 4),
    "coincident": COINCIDENT,
    "in R^6": IN_R6,
}
EVERY = pytest.mark.parametrize("planes", FOUR.values(), ids=FOUR)


def scene(planes, view, **options):
    with own_settings():
        return DRAWINGS.of(planes)._scene(planes, view, None, options)


@EVERY
def test_regions_and_facets_are_those_counted_in_every_format(planes):
    *_, facets, regions = f_vector(planes)
    for view in ("graph", "poset"):
        made = scene(planes, view)
        found = elements(made)
        assert (found["vertex"], found["edge"]) == (regions, facets)
        crossed = Counter(x.name.split("-")[1] for x in made.items if x.name.startswith("edge"))
        assert {int(k) - 1 for k in crossed} == set(planes.firsts)
        text = tikz(made)
        assert text.count("% vertex-") == regions
        assert text.count("% edge-") == facets


@EVERY
def test_a_schlegel_diagram_divides_its_outer_cell(planes):
    """All vertices are inside it, the cells fill it, and no two edges cross in space."""
    planes = in_space(planes, 4)
    diagram = symmetric_diagram(planes, None)
    places = diagram.places / np.abs(diagram.places).max()
    _, rays, sheets, facets, regions = f_vector(planes)
    assert (len(diagram.vertices), len(diagram.edges)) == (regions, facets)
    assert (len(diagram.polygons), len(diagram.facets)) == (sheets, rays)

    def volume(polygons):
        """Of a convex solid, from the middle of its corners."""
        corners = places[sorted({v for cycle in polygons for v in cycle})]
        middle, total = corners.mean(axis=0), 0.0
        for cycle in polygons:
            a, *rest = places[list(cycle)] - middle
            total += abs(sum(a @ np.cross(b, c) for b, c in pairwise(rest))) / 6
        return total

    outer = set(diagram.facets[diagram.outer])
    walls = [cycle for cycle in diagram.polygons if outer.issuperset(cycle)]
    for cycle in walls:
        a, b, c = places[list(cycle[:3])]
        heights = (places - a) @ np.cross(b - a, c - a)
        assert min(heights.max(), -heights.min()) < 1e-9
    assert sum(map(volume, diagram.cells)) == pytest.approx(volume(walls), rel=1e-6)
    ends = places[[edge[:2] for edge in diagram.edges]]
    pairs = np.array(
        [
            (one, other)
            for one, other in combinations(range(len(ends)), 2)
            if not {*diagram.edges[one][:2]} & {*diagram.edges[other][:2]}
        ]
    )
    assert apart(*ends[pairs[:, 0]].swapaxes(0, 1), *ends[pairs[:, 1]].swapaxes(0, 1)).min() > 1e-7


def apart(a, b, c, d):
    """Return how far segments of space, (n, 3) each, are apart where their lines do not pass by."""
    across = np.cross(b - a, d - c)
    skew = (across * across).sum(axis=1) > 1e-14
    a, b, c, d, across = (rows[skew] for rows in (a, b, c, d, across))
    s, t, gap = np.linalg.solve(np.stack([b - a, c - d, across], axis=2), (c - a)[..., None]).T[0]
    inside = (np.minimum(s, t) > -1e-9) & (np.maximum(s, t) < 1 + 1e-9)
    return np.where(inside, np.abs(gap) * np.linalg.norm(across, axis=1), 1.0)


@EVERY
def test_the_point_of_view_is_beyond_one_facet_exactly(planes):
    if planes.dimension > 4:
        planes = Arrangement([row[:4] for row in planes.integer_planes])
    diagram = schlegel_diagram(planes)
    *point, scale = diagram.point
    for k, normal in enumerate(diagram.normals):
        top = max(dot(normal, vertex) for vertex in diagram.vertices)
        on = {v for v, vertex in enumerate(diagram.vertices) if dot(normal, vertex) == top}
        assert on == set(diagram.facets[k])
        assert (dot(normal, point) > scale * top) == (k == diagram.outer)


@EVERY
def test_a_section_cuts_the_regions_that_it_meets(planes):
    """Signs and faces are those of the restriction to the hyperplane, added as one more plane."""
    flat, equation = cut_out(planes, None, None)
    given = restriction(addition(planes, equation[:-1], equation[-1]), len(planes))
    assert f_vector(flat)[-1] == f_vector(given)[-1]
    assert {f.signs for f in flat.regions()} <= {f.signs for f in planes.regions()}
    assert flat.distinct == planes.distinct
    assert scene(planes, "section").legend.captions[0].startswith("section by ")


def test_a_section_is_where_it_is_asked_for_or_refused():
    planes = generic(5, 4)
    _, equation = cut_out(planes, ["1", "0", "1/2", "0", "3"], None)
    assert equation == (2, 0, 1, 0, 6)
    for wrong, said in (
        ([1, 2], "give 4 coefficients"),
        ([0, 0, 0, 0, 1], "not all 0"),
        ([*planes.integer_planes[2][:4], 1], "plane 3 does not meet"),
    ):
        with pytest.raises(InputError, match=said):
            cut_out(planes, wrong, None)
    with pytest.raises(InputError, match="not of the space"):
        cut_out(IN_R6, [1, 0, 0, 0, 0, 0, 1], None)


@pytest.mark.parametrize(
    "planes", [shi("A2"), catalan("A2"), shi("A3"), random_integer(6, 5, seed=1)]
)
def test_graph_and_poset_show_every_rank(planes):
    *_, facets, regions = f_vector(planes)
    for view in ("graph", "poset"):
        found = elements(scene(planes, view))
        assert (found["vertex"], found["edge"]) == (regions, facets)


def test_the_graph_of_lines_is_a_tiling_whose_edges_do_not_cross():
    made = scene(catalan("A2"), "graph")
    edges = [np.column_stack([x.points, [0, 0]]) for x in made.items if x.name.startswith("edge")]
    pairs = [
        pair for pair in combinations(edges, 2)
        if len({tuple(p) for p in np.round(np.concatenate(pair), 6)}) == 4
    ]  # fmt: skip
    first, second = np.array(pairs).transpose(1, 2, 0, 3)
    assert (apart(*first, *second) == 1.0).all()


@pytest.mark.parametrize(
    ("base", "signs"), [(None, (1, 1, 1, 1)), ("3", None), ("+-+-", (1, -1, 1, -1))]
)
def test_a_poset_rises_from_its_base_by_one_plane_at_a_time(base, signs):
    planes = generic(4, 4)
    with own_settings():
        made = draw_poset.scene(planes, bottom=base)
    assert made.legend.lines[0][0].endswith(sign_text(signs or planes.regions()[2].signs))
    left = [x for x in made.items if isinstance(x, Label) and x.place[0] < 5]
    counts = [x.text for x in sorted(left, key=lambda x: x.place[1])]
    assert "".join(counts) == "14641"
    places = {
        x.name: np.reshape(x.points, (-1, 2)).mean(axis=0)[1]
        for x in made.items
        if x.name.startswith("vertex")
    }
    rises = [abs(x.points[1][1] - x.points[0][1]) for x in made.items if x.name.startswith("edge")]
    assert rises == pytest.approx([np.ptp(list(places.values())) / 4] * len(rises), rel=0.02)


def test_orbits_and_models_of_rank_four():
    regions = [face.signs for face in coxeter("D4").regions()]
    assert set(orbits(coxeter("D4"), regions)) == {0}
    keys = [key.text for key in scene(coxeter("A4"), "graph", colour="orbits").legend.keys]
    assert "orbit of 120" in keys
    content = dual_model(coxeter("A4"), ".glb")
    length = int.from_bytes(content[12:16], "little")
    document = json.loads(content[20 : 20 + length])
    assert len(document["nodes"]) == 1 + 30 - 1


def test_too_large_to_draw_refused_before_listing():
    for view in ("graph", "poset"):
        with pytest.raises(OutOfReachError, match="regions in a picture"):
            scene(generic(25, 4), view)
    assert next(iter(DRAWINGS.of(coxeter("A4")).views)) == "graph"
    assert next(iter(DRAWINGS.of(coxeter("A5")).views)) == "lattice"
    assert set(DRAWINGS.views) == set(DRAWINGS.of(coxeter("A4")).views)
