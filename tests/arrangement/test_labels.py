"""Labels of pictures: those that may be left out, those that must be written, and their places."""

import numpy as np
import pytest

from arrangement.drawing.labels import (
    Labels,
    Leaders,
    across,
    around,
    beside,
    covering,
    fixed_places,
    inside,
    keep_off,
    near,
    write_if_free,
)
from arrangement.drawing.scene import Label, Path, Scene

SQUARE = np.array([[40.0, 40.0], [100.0, 40.0], [100.0, 100.0], [40.0, 100.0]])
MIDDLE = np.array([70.0, 70.0])


@pytest.fixture
def scene():
    return Scene(60.0, 60.0)


def written(scene):
    return [(item.text, item.size) for item in scene.items if isinstance(item, Label)]


def test_label_stands_at_first_free_place(scene):
    places = fixed_places(np.array([[-5.0, 70.0], [50.0, 70.0], [120.0, 70.0]]))
    off = keep_off([np.array([[50.0, 0.0], [50.0, 170.0]])])
    assert write_if_free(scene, ["a"], (7.0,), places, off=off)
    (box,) = scene.boxes
    assert box[0] < 120 < box[2], "the first is off the sheet, the second on a line"


def test_label_is_left_out_where_nothing_is_free(scene):
    assert write_if_free(scene, ["a"], (7.0,), fixed_places(MIDDLE[None]))
    assert not write_if_free(scene, ["b"], (7.0, 5.0), fixed_places(MIDDLE[None]))
    assert written(scene) == [("a", 7.0)]


def test_every_form_is_tried_before_a_smaller_size(scene):
    narrow = SQUARE * [0.15, 1] + [40, 0]
    assert write_if_free(scene, ["++++", "++\n++"], (7.0, 3.0), inside(scene, narrow * [2.5, 1]))
    assert written(scene)[0][0] == "++\n++"


def test_label_that_must_be_written_covers_least(scene):
    labels = Labels(scene)
    labels.avoid([[0.0, 70.0], [170.0, 70.0]], [[0.0, 71.0], [170.0, 71.0]])
    labels.avoid([[0.0, 100.0], [170.0, 100.0]])
    labels.write("1", fixed_places(np.array([[70.0, 70.0], [70.0, 100.0]])))
    assert scene.items[-1].place == (70.0, 100.0)
    labels.write("2", fixed_places(np.array([[70.0, 100.0], [70.0, 70.0]])))
    assert scene.items[-1].place == (70.0, 70.0), "lines before labels"


def test_places_beside_a_point_keep_their_distance():
    half = np.array([4.0, 2.0])
    for centre in beside(MIDDLE, away=(1.0, 0.0), distance=3.0)(half):
        gap = np.maximum(np.abs(centre - MIDDLE) - half, 0)
        assert 1.5 < np.linalg.norm(gap) <= 6.01
    others = np.array([[78.0, 70.0]])
    assert (beside(MIDDLE, others=others)(half)[:, 0] < 78).all()
    assert (beside(MIDDLE, within=(0, 70, 170, 170))(half)[:, 1] >= 72).all()
    assert np.allclose(around((0.0, -2.0))[0], (0, -1))
    assert len(near(MIDDLE, np.array([1.0, 0.0]))(half)) == 60


def test_places_across_a_segment_are_off_it():
    ends = np.array([[40.0, 40.0], [100.0, 80.0]])
    half = np.array([4.0, 2.0])
    centres = across(ends)(half)
    boxes = np.hstack([centres - half, centres + half])
    assert not covering(keep_off([ends]), boxes).any()


def test_place_inside_is_the_middle_of_what_is_free(scene):
    half = np.array([5.0, 3.0])
    assert np.allclose(inside(scene, SQUARE)(half), [MIDDLE], atol=0.5)
    wall = keep_off([np.array([[60.0, 0.0], [60.0, 170.0]])])
    assert inside(scene, SQUARE, wall)(half)[0, 0] > 75
    assert inside(scene, SQUARE, None, (0, 0, 60, 170))(half)[0, 0] < 55
    assert not len(inside(scene, SQUARE)(np.array([31.0, 3.0])))


def test_leader_ends_in_what_it_names(scene):
    edges = [np.vstack([SQUARE, SQUARE[:1]])]
    assert Leaders(scene, edges, (0, 0, 170, 170), [SQUARE]).write(SQUARE, ["region"], (6.0,))
    line = next(item for item in scene.items if isinstance(item, Path) and item.kind == "line")
    assert np.allclose(line.points[0], MIDDLE, atol=0.5)
    assert not Leaders(scene, edges, (0, 0, 20, 20), [SQUARE]).write(SQUARE, ["region"], (6.0,))
