"""What is added to a picture lands where the model has it: axes in its coordinates, `to_page`."""

from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from arrangement import Arrangement, InputError, read_arrangement
from arrangement.drawing.layout import lay_out
from arrangement.drawing.scene import Item, Mark
from arrangement.library.families import generic, shi
from arrangement.pictures import compose
from arrangement.pictures.dual import unit_lengths
from equilibrium import Contact, Grasp, read_grasp, solve
from equilibrium.grasps.textbook import wedge
from equilibrium.pictures import draw_assembly

pytest.importorskip("matplotlib")
from matplotlib.figure import Figure

LINES = Arrangement([[1, 0], [0, 1], [1, 1], [1, -2]], [0, 0, 0, 1])
GRASP = read_grasp("paper-three-contacts-preload-1")
LOAD = ("1/2", "1/4", 0)


def item(figure: Any, name: str) -> Item:
    """Return an element of a picture with its legend."""
    (found,) = [item for item in lay_out(figure.scene).items if item.name == name]
    return found


def drawn_at(figure: Any, name: str) -> np.ndarray[Any, Any]:
    """Return the middle of an element, in pixels."""
    found: Any = item(figure, name)
    place = found.place if isinstance(found, Mark) else found.points.mean(axis=0)
    return np.asarray(place) * figure.dpi / 72


def added_at(figure: Any, point: Any, panel: int = 1) -> np.ndarray[Any, Any]:
    """Return where matplotlib draws a point that is added, in pixels."""
    return figure.axes[panel - 1].transData.transform([float(Fraction(x)) for x in point])


def crossing(figure: Any, one: str, other: str) -> np.ndarray[Any, Any]:
    """Return where two drawn segments cross, in pixels."""
    (p, q), (r, s) = (item(figure, name).points for name in (one, other))
    share = np.linalg.solve(np.array([q - p, r - s]).T, r - p)[0]
    return (p + share * (q - p)) * figure.dpi / 72


@pytest.mark.parametrize("window", [None, [(-3, -1), (2, 5)]])
def test_lines_have_axes_in_their_coordinates(window):
    figure = LINES.draw("lines", **({} if window is None else {"window": window}))
    for point, lines in (((0, 0), (1, 2)), ((1, 0), (2, 4)), ((0, "-1/2"), (1, 4))):
        found = crossing(figure, *(f"line-{k}" for k in lines))
        assert np.allclose(added_at(figure, point), found, atol=0.01)
        assert figure.to_page(point) == tuple(float(Fraction(x)) for x in point)


def test_added_dot_covers_the_crossing_in_the_file(tmp_path):
    """Red pixels of a dot at (0, 0), in a file in which lines 1 and 2 are green, lie about it."""
    from matplotlib.image import imread

    figure = LINES.draw("lines")
    figure.restyle("region-*", fc="white")
    for k in (1, 2):
        figure.restyle(f"line-{k}", ec="#00ff00")
    figure.axes[0].plot([0], [0], "o", color="red", mec="none", ms=3)
    figure.savefig(tmp_path / "dot.png", dpi=300)
    red, green, blue = np.moveaxis(imread(tmp_path / "dot.png")[..., :3], -1, 0)
    dot = np.argwhere((red > 0.9) & (green < 0.1) & (blue < 0.1))
    lines = (green > 0.9) & (red < 0.1)
    row, column = dot.mean(axis=0)
    assert len(dot) > 50
    assert abs(column - np.bincount(np.argwhere(lines)[:, 1]).argmax()) < 1.5
    assert abs(row - np.bincount(np.argwhere(lines)[:, 0]).argmax()) < 1.5


def test_grasp_has_axes_in_its_coordinates():
    far = Grasp(Contact((x, 1000), (100 - x, 0), 1) for x in (99, 101))
    for grasp in (GRASP, far):
        figure = grasp.draw()
        for i, contact in enumerate(grasp, 1):
            assert np.allclose(added_at(figure, contact.point), drawn_at(figure, f"pad-{i}"))


def test_assembly_has_axes_in_its_coordinates():
    verdict = solve(*wedge())
    figure = draw_assembly(verdict)
    for i, c in enumerate(verdict.assembly.contacts, 1):
        assert np.allclose(added_at(figure, c.contact.point), drawn_at(figure, f"pad-{i}"))


@pytest.mark.parametrize(("view", "panels"), [("resist", 1), ("slice", 3), ("compare", 8)])
def test_each_panel_of_forces_has_its_axes(view, panels):
    figure = GRASP.draw(view, wrench=LOAD)
    assert len(figure.axes) == panels
    for panel in range(1, panels + 1):
        name = "wrench" if panels == 1 else f"{panel}-wrench"
        assert np.allclose(added_at(figure, LOAD[:2], panel), drawn_at(figure, name))
        assert figure.to_page(LOAD[:2], panel) == (0.5, 0.25)


def test_panels_that_are_composed_keep_their_coordinates():
    figure = compose([read_arrangement("braid-a3").draw("lattice"), LINES.draw("lines")])
    found = crossing(figure, "panel-2-line-1", "panel-2-line-2")
    assert np.allclose(added_at(figure, (0, 0), 2), found, atol=0.01)


def test_axes_of_the_user_get_the_coordinates():
    whole = Figure(figsize=(6, 3))
    left, right = whole.subplots(1, 2)
    LINES.draw("lines", ax=left)
    GRASP.draw("grasp", ax=right)
    whole.draw_without_rendering()
    (pad,) = right.findobj(lambda artist: artist.get_gid() == "pad-1")
    place = pad.get_transform().transform(pad.get_path().vertices).mean(axis=0)
    assert np.allclose(right.transData.transform((-1, 0)), place)
    lines = [
        line.get_transform().transform(line.get_path().vertices)
        for k in (1, 2)
        for line in left.findobj(lambda artist, k=k: artist.get_gid() == f"line-{k}")
    ]
    (p, q), (r, s) = lines
    share = np.linalg.solve(np.array([q - p, r - s]).T, r - p)[0]
    assert np.allclose(left.transData.transform((0, 0)), p + share * (q - p), atol=0.01)


@pytest.mark.parametrize("view", ["sphere", "stereographic", "gnomonic"])
@pytest.mark.parametrize("coordinates", ["symmetric", "given"])
def test_points_of_the_sphere_are_on_the_circles_of_their_planes(view, coordinates):
    """Each ray on two planes is placed where drawn arcs of both have their ends."""
    planes = generic(4, 3)
    figure = planes.draw(view, coordinates=coordinates)
    arcs: dict[str, list[Any]] = {}
    for found in lay_out(figure.scene).items:
        kind, _, rest = found.name.partition("-")
        if kind in ("front", "arc"):
            arcs.setdefault(rest.partition("-")[0], []).extend(found.points[[0, -1]])
    seen = 0
    rays = [np.cross(*pair) for pair in combinations(np.array(planes.normals, float), 2)]
    for point in (side * ray for ray in rays for side in (1, -1)):
        on = [
            str(k + 1)
            for k, sign in enumerate(planes.signs_at([int(x) for x in point]))
            if sign == 0
        ]
        place = np.array(figure.to_page(point))
        gaps = [np.linalg.norm(np.array(arcs[k]) - place, axis=1).min() for k in on]
        if min(gaps) < 0.5:
            seen += 1
            assert max(gaps) < 0.5, (point, gaps)
    assert seen >= 6


def corners(figure: Any, kind: str) -> np.ndarray[Any, Any]:
    """Return the corners of all elements of a kind, in points."""
    found = [x.points for x in lay_out(figure.scene).items if x.name.startswith(kind)]
    return np.vstack(found)


SIMPLEX = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], [0, 0, 0, 1])
VERTICES = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


def test_vertices_of_planes_are_corners_of_facets():
    drawn = corners(figure := SIMPLEX.draw("planes"), "facet-")
    for vertex in VERTICES:
        gaps = np.linalg.norm(drawn - figure.to_page(vertex), axis=1)
        assert gaps.min() < 0.05
    assert np.linalg.norm(drawn - figure.to_page(("1/2", "1/3", "1/5")), axis=1).min() > 1


@pytest.mark.parametrize("explode", [1, 1.5, 3])
def test_points_of_cells_move_with_their_cell(explode):
    figure = SIMPLEX.draw("cells", explode=explode, labels="none")
    other = (2, 2, 2)
    seen = 0
    for face in SIMPLEX.regions():
        name = "cell-" + "".join("0+-"[sign] for sign in face.signs)
        items = [x for x in lay_out(figure.scene).items if x.name.startswith(name)]
        for vertex in VERTICES if items else ():
            if face.contains(vertex, closed=True):
                inside = [
                    Fraction(999, 1000) * x + Fraction(1, 1000) * y
                    for x, y in zip(vertex, face.witness, strict=True)
                ]
                gaps = np.linalg.norm(corners(figure, name) - figure.to_page(inside), axis=1)
                seen += gaps.min() < 0.5
    assert figure.to_page(other) != figure.to_page((-2, -2, -2))
    assert seen >= 8


def test_vertices_of_the_dual_are_where_they_are_drawn():
    planes = generic(4, 3)
    figure = planes.draw("dual", coordinates="given")
    dual = planes.dual(unit_lengths(planes))
    for signs, vertex in zip(dual.signs.tolist(), dual.vertices, strict=True):
        number = figure.scene.numbers["".join("0+-"[sign] for sign in signs)]
        middle: Any = item(figure, f"vertex-{number}")
        assert np.allclose(figure.to_page(vertex, 2), middle.points, atol=0.01)
    ray = np.cross(*np.array(planes.normals, float)[:2])
    assert np.isfinite(figure.to_page(ray)).all()


def test_lines_in_other_coordinates_have_places():
    figure = shi("A2").draw("lines")
    for point, lines in (((0, 0), (1, 3)), ((1, 0), (2, 3)), ((0, 1), (1, 4))):
        found = crossing(figure, *(f"line-{k}" for k in lines)) * 72 / figure.dpi
        assert np.allclose(figure.to_page(point), found, atol=0.05)


def test_grasp_in_space_has_places():
    grasp = read_grasp("two-opposed-fingers")
    figure = grasp.draw()
    for i, contact in enumerate(grasp, 1):
        at = np.array(figure.to_page(contact.point)) * figure.dpi / 72
        assert np.allclose(at, drawn_at(figure, f"pad-{i}"), atol=0.01)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: LINES.draw("lines").to_page((1, 2, 3)), "has 3 coordinates; expected 2"),
        (lambda: LINES.draw("lines").to_page((1, 2), 2), "the panel is 2; expected 1 to 1"),
        (lambda: generic(4, 3).draw("lattice").to_page((1, 2, 3)), "have no place"),
        (lambda: generic(4, 3).draw("sphere").to_page((0, 0, 0)), "lies at infinity"),
    ],
)
def test_point_without_a_place_is_refused(make, words):
    with pytest.raises(InputError, match=words):
        make()
