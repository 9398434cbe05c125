"""Pictures: what is drawn is what was computed, labels keep apart, files repeat."""

import re
from dataclasses import replace
from fractions import Fraction
from typing import Any

import matplotlib.path
import numpy as np
import pytest
from hypothesis import example, given

from arrangement.drawing.layout import lay_out
from arrangement.drawing.scene import Label, Scene, curve_points, measure
from equilibrium import Circle, Contact, Grasp, Polygon, read_grasp, solve
from equilibrium.grasps.inputs import random_grasp, star_outline
from equilibrium.methods import METHODS, resistance_figure
from equilibrium.methods.compare import compare
from equilibrium.methods.registry import WITH_REGION
from equilibrium.pictures import (
    draw_compare,
    draw_grasp,
    draw_methods,
    draw_polar,
    draw_proof,
    draw_resist,
    draw_slice,
)
from equilibrium.pictures.body import body, frame_of
from equilibrium.pictures.forces import slices
from equilibrium.pictures.grasp import GraspLayout
from equilibrium.pictures.proof import proof_page
from equilibrium.pictures.style import nice
from equilibrium.wrench_sets.search_map import search_map
from equilibrium.wrench_sets.slice import resisted_region
from tests.drawn import offences

from .strategies import grasps, wrenches

THREE, FOUR = read_grasp("paper-three-contacts"), read_grasp("paper-four-contacts")
FAR = 10**30
COINCIDENT = read_grasp("coincident-contacts")
HUGE = Grasp(
    [Contact((FAR - 1, 0), (1, 0), "1/2", 1, 1), Contact((FAR + 1, 0), (-1, 0), "1/2", 1, 1)]
)
CORNERS = ((-1, -1), (1, -1), (1, 2), (-1, 2))
#: Grasps and wrenches of the paper's two tables, and degenerate ones.
QUESTIONS: list[tuple[Grasp, tuple[Any, ...]]] = [
    (THREE, (0, -1, 0)),
    (THREE, (0, 1, 0)),
    (THREE.with_preload(1), (0, 1, 0)),
    (THREE.with_preload(1), (0, "11/10", 0)),
    (FOUR, (0, 0, 3)),
    (FOUR.with_preload(1), (0, 2, 0)),
    (FOUR.with_preload(1), (0, 0, -3)),
    (random_grasp(6, 3), ("1/2", -1, "1/3")),
    (COINCIDENT, (0, "-1/2", 0)),
    (HUGE, (0, "1/2", FAR // 2)),
    (Grasp([Contact((0, 0), (0, 1), 0)]), (0, -1, 0)),
    (Grasp([]), (0, 0, 0)),
]


def named(scene: Scene) -> dict[str, Any]:
    return {item.name: item for item in scene.items}


def count(scene: Scene, kind: str) -> int:
    return sum(item.name.startswith(kind) for item in scene.items)


def texts(scene: Scene) -> list[str]:
    return [item.text for item in lay_out(scene).items if isinstance(item, Label)]


@pytest.mark.parametrize(("grasp", "wrench"), QUESTIONS)
def test_every_contact_has_its_elements(grasp, wrench):
    verdict = solve(grasp, wrench)
    figure = draw_grasp.scene(grasp, wrench=wrench)
    assert count(figure, "cone-") == count(figure, "pad-") == count(figure, "number-") == len(grasp)
    assert count(figure, "preload-") == sum(c.preload > 0 for c in grasp)
    assert any("no equilibrium" in text for text in texts(figure)) is not verdict.stable
    forces = verdict.equilibria[0].forces if verdict.stable else ()
    assert count(figure, "mark-") == len(forces)
    assert count(figure, "force-") == sum(any(pair) for pair in forces)
    assert count(figure, "wrench-force") == any(Fraction(x) for x in wrench[:2])


def test_forces_are_drawn_to_one_scale_in_their_directions():
    """Table I, row (0, 1, 0) with preload 1: f1 = (1, -1/2), f3 = (1, 1/2), f2 = 0."""
    found = named(draw_grasp.scene(THREE.with_preload(1), wrench=(0, 1, 0)))
    corners = {name: found[name].points for name in ("force-1", "force-3", "wrench-force")}
    arms = {name: points[3] - (points[0] + points[6]) / 2 for name, points in corners.items()}
    unit = np.linalg.norm(arms["wrench-force"])
    np.testing.assert_allclose(arms["force-1"] / unit, (1, -0.5), atol=1e-9)
    np.testing.assert_allclose(arms["force-3"] / unit, (-1, -0.5), atol=1e-9)
    assert "force-2" not in found


@pytest.mark.parametrize(
    ("grasp", "wrench", "expected"),
    [
        (THREE, (0, -1, 0), ["detached", "stick", "detached"]),
        (THREE.with_preload(1), (0, 1, 0), ["slip", "detached", "slip"]),
        (FOUR.with_preload(1), (0, 0, 3), ["slip"] * 4),
        (FOUR.with_preload(1), (0, 2, 0), ["stick"] * 4),
    ],
)
def test_marks_tell_the_states_of_the_motion_by_shape(grasp, wrench, expected):
    """The tables of the paper give the motions: (0, -1, 0), (0, 1, 0), (0, -1/4, 1/4) and 0."""
    drawn = named(draw_grasp.scene(grasp, wrench=wrench))
    marks = [drawn[f"mark-{i + 1}"] for i in range(len(expected))]
    corners = {3: "slip", 4: "stick"}
    assert expected == [
        "detached" if mark.kind == "circle" else corners[len(mark.points)] for mark in marks
    ]


def test_slipping_marks_point_where_the_object_slips():
    """Under (0, 1, 0) the object moves up, along +t at contact 1 and along -t at contact 3."""
    found = named(draw_grasp.scene(THREE.with_preload(1), wrench=(0, 1, 0)))
    for name in ("mark-1", "mark-3"):
        tip, *base = found[name].points[:3]
        assert all(tip[1] > corner[1] for corner in base)


def test_a_given_outline_is_drawn_through_its_corners():
    drawn = named(draw_grasp.scene(THREE, outline=CORNERS))
    places = [drawn[f"pad-{i}"].points.mean(axis=0) for i in (1, 2, 3)]
    points = np.array([[*map(float, c.point), 1.0] for c in THREE])
    onto = np.linalg.solve(points, np.array(places))
    for corner in CORNERS:
        gaps = np.linalg.norm(drawn["outline"].points - np.array([*corner, 1.0]) @ onto, axis=1)
        assert min(gaps) < 1e-9


def test_stated_and_given_outline_drawn_alike():
    stated = named(draw_grasp.scene(THREE.with_outline(Polygon(CORNERS))))["outline"]
    given = named(draw_grasp.scene(THREE, outline=CORNERS))["outline"]
    assert np.array_equal(stated.points, given.points)


@pytest.mark.parametrize("outline", [Polygon(CORNERS), Circle((0, 0), 1)])
def test_the_outline_of_a_grasp_is_drawn_without_dashes(outline):
    own = THREE.with_outline(outline)
    drawn = named(draw_grasp.scene(own))["outline"]
    assert drawn.style["ls"] == "solid"
    assert re.search('"stated": ?true', proof_page(own, wrench=(0, 1, 0)))


@pytest.mark.parametrize("seed", range(8))
def test_cones_stay_inside_the_outline(seed):
    grasp = random_grasp(5, seed)
    grasp = grasp.with_friction(2).with_outline(star_outline(grasp))
    items = named(draw_grasp.scene(grasp))
    inside = matplotlib.path.Path(curve_points(items["outline"].points))
    for i in range(len(grasp)):
        cone = items[f"cone-{i + 1}"]
        points = cone.points if cone.kind == "polygon" else curve_points(cone.points)
        # A point of the edge itself may be rounded to the other side.
        points = 0.99 * points[1:] + 0.01 * points.mean(axis=0)
        assert inside.contains_points(points).all()


@pytest.mark.parametrize(
    ("grasp", "wrench"),
    [
        (THREE, (0, 0, 1)),
        (FOUR, (0, 0, 3)),
        (FOUR.with_preload(1), (0, 0, -3)),
        *((random_grasp(6, seed), ("1/2", -1, "1/3")) for seed in (1, 2, 3)),
    ],
)
def test_wrench_label_outside_the_torque_arc(grasp, wrench):
    scene = draw_grasp.scene(grasp, wrench=wrench)
    ends = curve_points(named(scene)["wrench-torque"].points)
    middle = (ends.min(axis=0) + ends.max(axis=0)) / 2
    name = next(item for item in scene.items if getattr(item, "text", "") == "w")
    assert np.linalg.norm(name.place - middle) > 0.95 * np.ptp(ends[:, 1]) / 2


def test_units_stand_with_the_wrench_and_legends_are_short():
    grasp = THREE.with_units("cm", "N").with_preload(1)
    assert "w = (0, 1/2) N, 0 N cm" in texts(draw_grasp.scene(grasp, wrench=(0, "1/2", 0)))
    for grasp in (THREE, FOUR):
        for loaded in (grasp, grasp.with_preload(1)):
            scene = lay_out(draw_grasp.scene(loaded, wrench=(0, 0, "1/2")))
            keys = [item.place[1] for item in scene.items if hasattr(item, "text")]
            lowest = [y for y in keys if y < scene.height / 6]
            assert lowest
            assert curve_points(named(scene)["body"].points)[:, 1].min() > max(lowest)


def test_a_slice_keeps_the_preloads_of_the_grasp():
    first, *others = THREE
    own = replace(THREE, contacts=(replace(first, preload=2), *others))
    for grasp, options, title in (
        (THREE, {}, "(c) preload 1"),
        (THREE.with_preload(3), {}, "(c) preload 3"),
        (own, {}, "(c) the preloads of the grasp"),
        (own, {"preload": 1}, "(c) preload 1"),
    ):
        assert title in texts(draw_slice.scene(grasp, **options))
    (*_, (_, region)) = slices(own, Fraction(0), None)
    assert region.polygons == resisted_region(own).polygons


def test_one_equilibrium_of_many_contacts_reported():
    grasp = random_grasp(24, 4)
    verdict = solve(grasp, (0, "-1/2", 0))
    assert verdict.solution is not None
    layout = GraspLayout(grasp, verdict)
    assert layout.equilibrium is verdict.solution
    said = texts(draw_grasp.scene(grasp, wrench=(0, "-1/2", 0)))
    assert "the equilibrium found; there may be others" in said
    assert "there may be others" in verdict._repr_html_()


@pytest.mark.parametrize("grasp", [THREE, FOUR, COINCIDENT, HUGE, random_grasp(5, 2)])
def test_indicative_outlines_touch_every_contact(grasp):
    frame = frame_of(grasp)
    curve = body(grasp, frame)
    assert curve is not None
    fine = curve_points(curve, 400)
    for contact in grasp:
        place = frame.paper(contact.point)
        normal = np.array([float(x) for x in contact.normal])
        near = fine[np.linalg.norm(fine - place, axis=1) < 0.02] - place
        assert len(near)
        if len({c.normal for c in grasp if c.point == contact.point}) == 1:
            assert np.abs(near @ normal).max() < 0.005


@pytest.mark.parametrize("seed", range(12))
def test_indicative_outlines_have_the_object_on_the_inner_side(seed):
    """A curve run counter-clockwise has its inside on the left, where the normals point."""
    grasp = random_grasp(6, seed)
    curve = body(grasp, frame_of(grasp))
    assert curve is not None
    fine = curve_points(curve)
    after = np.roll(fine, -1, axis=0)
    assert np.sum(fine[:, 0] * after[:, 1] - fine[:, 1] * after[:, 0]) > 0


LOADED, FREE = THREE.with_preload(1), read_grasp("interrupted-resistance")
LABELLED: list[tuple[Any, Grasp, dict[str, Any]]] = [
    *((draw_grasp, grasp, {"wrench": wrench}) for grasp, wrench in QUESTIONS),
    (draw_grasp, FREE, {"wrench": ("1/2", -1, "1/4")}),
    (draw_resist, FREE, {"wrench": (0, 0, 0)}),
    (draw_resist, read_grasp("friction-along-slip"), {"wrench": ("1/2", -1, "1/4")}),
    (draw_resist, LOADED, {"wrench": (0, 1, 0)}),
    (draw_resist, LOADED, {"wrench": (0, -(10**6), 0)}),
    (draw_resist, COINCIDENT, {}),
    (draw_slice, THREE, {}),
    (draw_slice, FOUR, {"wrench": (0, 2, 0)}),
    (draw_polar, LOADED, {"rays": 36}),
    (draw_compare, LOADED, {"wrench": (0, 1, 0)}),
    (draw_compare, FOUR, {"methods": ["complete", "weak"], "width": 88.0}),
    (draw_methods, LOADED, {"wrenches": [(0, k, "-1/2") for k in range(6)]}),
    (draw_proof, THREE, {"wrench": (0, 0, 5)}),
    (draw_proof, THREE, {"wrench": (0, 1, 0)}),
    (draw_proof, LOADED, {"wrench": (1, "11/10", 0)}),
    (draw_proof, FOUR, {"wrench": (0, 1, 0), "width": 150.0}),
    (draw_proof, read_grasp("hanging-picture"), {"wrench": (0, 3, 0)}),
]


@pytest.mark.parametrize(("view", "grasp", "options"), LABELLED)
def test_labels_keep_apart_on_the_sheet_and_off_lines(view, grasp, options):
    found = offences(lay_out(view.scene(grasp, **options)))
    assert [text for text in found if not text.endswith(" on axis")] == []


def test_lines_of_resisted_forces_tell_their_states():
    scene = draw_resist.scene(read_grasp("single-contact"))
    assert [item.text for item in scene.items if item.name == "code-1"] == ["●"]
    assert scene.legend.keys[0].text == "1 stick"


@pytest.mark.parametrize(
    "grasp", [THREE, THREE.with_preload(1), FOUR, FOUR.with_preload(1), COINCIDENT, HUGE, Grasp([])]
)
def test_region_elements_are_the_exact_pieces_and_borders(grasp):
    region = resisted_region(grasp)
    drawn = named(draw_resist.scene(grasp))
    outline = region.outline
    for kind, items in (
        ("polygon", region.polygons),
        ("border", outline.border),
        ("whisker", outline.whiskers),
        ("point", outline.points),
    ):
        assert {x for x in drawn if x.startswith(kind)} == {
            f"{kind}-{i}" for i in range(1, len(items) + 1)
        }


@given(grasp=grasps(), wrench=wrenches)
@example(grasp=Grasp([Contact((0, 0), (0, 1), 0)]), wrench=(0, 1, 0))
def test_the_whole_finite_border_lies_in_the_picture(grasp, wrench):
    region = resisted_region(grasp, origin=(0, 0, wrench[2]))
    items = named(draw_resist.scene(grasp, wrench=wrench))
    mark = items["wrench"]
    assert (mark.sign == "o") is region.contains([Fraction(x) for x in wrench[:2]])
    left, low, right, high = next(item.clip for item in items.values() if item.clip is not None)
    middle, half = np.array([left + right, low + high]) / 2, (right - left) / 2
    assert np.abs((mark.place - middle) / half).max() < 1
    for i, segment in enumerate(region.outline.border, 1):
        ends = (items[f"border-{i}"].points - middle) / half
        for place, own in ((ends[0], segment.start), (ends[1], segment.end)):
            at_edge = np.isclose(np.abs(place).max(), 1, atol=1e-9)
            assert at_edge is np.bool_(own is None)


def test_the_three_parts_are_the_data_of_the_paper_figure():
    data = resistance_figure(THREE)
    drawn = draw_slice.scene(THREE)
    for part, key in ((2, "no_preload"), (3, "preload_1")):
        assert count(drawn, f"{part}-polygon-") == len(data[key]["polygons"])
        assert count(drawn, f"{part}-border-") == len(data[key]["outline"]["border"])
    assert count(drawn, "1-border-") == len(data["grasp_wrench_space"]["corners"])


def test_polar_marks_are_the_entries_of_the_map():
    grasp = read_grasp("interrupted-resistance")
    options: dict[str, Any] = {"rays": 24, "tolerance": "1/100", "extent": 4}
    scene = draw_polar.scene(grasp, **options)
    found = search_map(grasp, 24, "1/100", 4000)
    assert found.disagreements
    items = named(scene)
    rim = items["rim"]
    for i, entry in enumerate(found.entries):
        mark = items[f"direction-{i + 1}"]
        assert mark.sign == ("o" if entry.agrees else "x")
        reach = 1.0 if entry.found is None else min(float(entry.found) / 4, 1.0)
        distance = np.linalg.norm(mark.place - rim.points) / rim.radius
        np.testing.assert_allclose(distance, reach, atol=1e-9)
        assert count(scene, f"claimed-{i + 1}-") == len(entry.wrongly_claimed)


def test_comparison_has_a_panel_for_each_method_with_its_region():
    figure = draw_compare.scene(FOUR.with_preload(1), wrench=(0, 2, 0))
    for i, method in enumerate(WITH_REGION, 1):
        region = METHODS[method].region(FOUR.with_preload(1))
        assert count(figure, f"{i}-polygon-") == len(region.polygons)
        assert count(figure, f"{i}-border-") == len(region.outline.border)
        assert (named(figure)[f"{i}-wrench"].sign == "o") is region.contains((0, 2))


def test_methods_and_wrenches_are_a_table_of_the_comparisons():
    loads = [(0, 1, 0), (0, -1, 0), (0, "11/10", 0)]
    grasp = THREE.with_preload(1)
    drawn = named(draw_methods.scene(grasp, wrenches=loads))
    markers = {True: "o", False: "x", None: "_"}
    for j, load in enumerate(loads):
        answer = compare(grasp, load)
        for i, entry in enumerate(answer.answers):
            assert drawn[f"cell-{i + 1}-{j + 1}"].sign == markers[entry.accepts]
            assert (f"differs-{i + 1}-{j + 1}" in drawn) == (entry.method in answer.disagreeing)


@pytest.mark.parametrize("value", [1.0, 1.9, 2.0, 4.999, 5.0, 9.99, 0.002, 3e7])
def test_round_steps_are_one_two_or_five(value):
    step = nice(value)
    assert value / 2.5 - 1e-12 <= step <= value * (1 + 1e-9)
    assert str(step.numerator * 1000 // step.denominator).rstrip("0") in ("1", "2", "5")


def test_far_origin_transferred_exactly():
    """A force at the origin has the torque -p x f about p: 10^30 / 2 is taken away exactly."""
    figure = draw_grasp.scene(HUGE, wrench=(0, "1/2", FAR // 2))
    assert "about the middle of the contacts, torque 0" in " ".join(texts(figure))
    assert count(figure, "wrench-torque") == 0


FAINT, VAST = Fraction(1, 10**30), Fraction(10) ** 400
EXTREME = Grasp(
    [
        Contact((VAST, 0), (1, 0), VAST, 1, FAINT),
        Contact((VAST + 1, 1), (-1, 0), FAINT, 10**40, VAST),
        Contact((VAST, VAST), (0, 1), 0, 1, 1),
    ]
)


@pytest.mark.parametrize(
    ("view", "options"),
    [
        *((draw_grasp, {"wrench": w}) for w in ((0, 0, 0), (FAINT, 0, VAST), (VAST, 1, 0))),
        (draw_resist, {}),
        (draw_polar, {"rays": 3}),
    ],
)
def test_forces_and_places_of_any_size_can_be_drawn(view, options):
    sheet = lay_out(view.scene(EXTREME, **options))
    assert all(measure(x.text, x.size)[0] < 2000 for x in sheet.items if isinstance(x, Label))
