"""Lines of the plane: what is drawn is what is counted, and every region lies where it is drawn."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from arrangement import Arrangement
from arrangement.counts import bounded_region_count, f_vector
from arrangement.drawing.scene.labels import HAIR
from arrangement.drawing.scene.layout import laid_out
from arrangement.drawing.scene.scene import Label, Scene, area
from arrangement.library.files.table import read_arrangement
from arrangement.pictures import draw_gnomonic, draw_lines
from arrangement.pictures.diagrams.line_charts import LinesChart
from tests.drawn import elements

from .strategies import arrangements

LESSON = Arrangement([[0, 1], [-4, -3], [4, -3]], [0, -12, -12])
LINES = {
    "generic": read_arrangement("generic-lines-affine"),
    "shi": read_arrangement("shi-a2-affine"),
    "lesson": LESSON,
    "none": Arrangement([], dimension=2),
    "one": Arrangement([[1, 2]], [3]),
    "coincident": Arrangement([[1, 2], [2, 4], [-1, -2], [1, 0]], [3, 6, -3, 0]),
    "parallel": Arrangement([[1, 2]] * 4, [0, 1, 5, 6]),
    "two parallel": Arrangement([[1, 0], [1, 0], [0, 1]], [0, 1, 0]),
    "central": Arrangement([[1, 0], [0, 1], [1, 1], [1, -1], [2, 1]]),
    "one point": Arrangement([[1, 0], [0, 1], [1, 1]], [1, 1, 2]),
    "nearly parallel": Arrangement([[1, 0], [0, 1], [1, 1], [1000, 1001]], [0, 0, 1, 7]),
    "huge": Arrangement([[1, 0], [0, 1], [10**30, 1]], [0, 10**40, 1]),
}


def scene_of(planes: Arrangement, **options: Any) -> Scene:
    found: Scene = laid_out(draw_lines.scene(planes, **options))
    return found


def written(scene: Scene) -> list[str]:
    return [item.text.replace(HAIR, "") for item in scene.items if isinstance(item, Label)]


@pytest.mark.parametrize("name", LINES)
@pytest.mark.parametrize("projective", [False, True])
def test_regions_and_lines_are_those_that_are_counted(name: str, projective: bool) -> None:
    planes = LINES[name]
    found = elements(scene_of(planes, projective=projective, faces="all", sides=True))
    vertices, edges, regions = f_vector(planes)
    assert (found["region"], found["vertex"]) == (regions, vertices)
    assert found["front"] + found["line"] == (edges if projective else len(planes.distinct))


def bounded(planes: Arrangement) -> int:
    """Count the bounded regions by Zaslavsky's second theorem; below rank 2 all have no end."""
    return bounded_region_count(planes) if planes.rank == 2 else 0


@settings(max_examples=40, deadline=None)
@given(arrangements(dimensions=(2, 2), planes=(0, 6)))
def test_regions_fill_the_window_and_have_the_signs_of_their_middles(planes: Arrangement) -> None:
    chart = LinesChart(planes)
    assert len(chart.bounded) == bounded(planes)
    assert (len(chart.vertices), len(chart.edges), len(chart.regions)) == f_vector(planes)
    cone = chart.globe.whole.arrangement
    total = 0.0
    for region, signs in chart.regions.items():
        outline = chart.outline(region)
        total += area(outline)
        middle = [Fraction(float(x)) for x in outline.mean(axis=0)]
        assert cone.signs_at([*middle, 1]) == signs
    width, height = chart.half
    assert total == pytest.approx(float(4 * width * height))
    for vertex in chart.vertices:
        assert (np.abs(chart.vertex(vertex)) < [float(x) for x in chart.half]).all()


def test_all_nineteen_faces_of_three_lines_have_their_labels() -> None:
    for projective in (False, True):
        found = written(scene_of(LESSON, faces="all", projective=projective))
        signs = ["".join("−0+"[s + 1] for s in face.signs) for face in LESSON.faces()]
        assert len(signs) == 19
        assert sorted(text for text in found if text in signs) == sorted(signs)


def test_a_line_has_one_name_in_the_window_and_two_in_the_projective_plane() -> None:
    assert [written(scene_of(LESSON)).count(str(k)) for k in (1, 2, 3)] == [1, 1, 1]
    whole = written(scene_of(LESSON, projective=True))
    assert [whole.count(str(k)) for k in (1, 2, 3)] == [2, 2, 2]


@pytest.mark.parametrize("normal", [(0, 1), (1, 0), (1, 1), (-1, 2), (-3, -1), (5, -7)])
@pytest.mark.parametrize("view", [draw_lines, draw_gnomonic])
def test_numbers_at_a_common_point_of_the_rim_have_the_order_of_their_lines(
    normal: tuple[int, int], view: Any
) -> None:
    a, b = normal
    rows, offsets = [normal, normal, normal, (-b, a)], [-1, 0, 1, 0]
    if view is draw_lines:
        scene = view.scene(Arrangement(rows, offsets), projective=True, labels="none")
    else:
        cone = Arrangement([(*row, -c) for row, c in zip(rows, offsets, strict=True)])
        scene = view.scene(cone, direction=(0, 0, 1), labels="none", coordinates="given")
    numbers = [item for item in scene.items if isinstance(item, Label) and item.text in "123"]
    middle = np.array(np.mean([item.place for item in numbers], axis=0))
    for side in (1, -1):
        along = side * np.array([-b, a])
        here = [x for x in numbers if np.subtract(x.place, middle) @ along > 0]
        assert [x.text for x in sorted(here, key=lambda x: np.dot(normal, x.place))] == [
            "1",
            "2",
            "3",
        ]


def test_parallel_classes_have_dots_at_infinity() -> None:
    found = elements(scene_of(LINES["shi"], projective=True))
    assert found["infinity"] == 6
    assert "infinity" not in elements(scene_of(LESSON, projective=True))


@pytest.mark.parametrize("projective", [False, True])
def test_arrows_point_to_the_positive_sides(projective: bool) -> None:
    """The tip of an arrow is where its line alone has the sign +."""
    for k in range(3):
        normal, offset = LESSON.normals[k], LESSON.offsets[k]
        one, turned = (
            scene_of(Arrangement([[s * x for x in normal]], [s * offset]), sides=True,
                     projective=projective)
            for s in (1, -1)
        )  # fmt: skip
        for scene in (one, turned):
            arrow = [i for i in scene.items if i.name == "side-0"][-1]
            plus = next(i for i in scene.items if isinstance(i, Label) and i.text == "+")
            minus = next(i for i in scene.items if isinstance(i, Label) and i.text == "−")
            line = next(i for i in scene.items if i.name.startswith(("line", "front")))
            way = np.array(plus.place) - np.array(minus.place)
            tip = arrow.points.mean(axis=0)  # type: ignore[attr-defined]
            start = line.points[0]  # type: ignore[attr-defined]
            ends = line.points[-1] - start  # type: ignore[attr-defined]
            normal_on_paper = np.array([-ends[1], ends[0]])
            assert ((tip - start) @ normal_on_paper) * (way @ normal_on_paper) > 0


def test_the_legend_counts_bounded_and_unbounded_regions() -> None:
    found = written(scene_of(LINES["shi"]))
    assert {"4 bounded regions", "12 unbounded"} <= set(found)


def test_what_has_no_room_is_counted() -> None:
    found = written(scene_of(LINES["shi"], faces="all", width=40))
    assert any(text.startswith("no room for some labels: ") for text in found)


def test_the_key_of_the_projective_plane_has_the_colours_of_its_regions() -> None:
    """Parts that meet across the rim are one region, with the sides of both."""
    planes = read_arrangement("shi-a2-affine")
    made = draw_lines.scene(planes, projective=True, colour="sides")
    assert [text for _, _, text in made.legend.keys[:2]] == ["3 sides", "4 sides"]
