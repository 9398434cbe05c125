"""Pieces of lines inside and outside of convex polygons, and what unions of segments cut out."""

import json
from fractions import Fraction
from itertools import combinations, pairwise

import pytest
from hypothesis import assume, given, settings, strategies as st
from sympy import sqrt

from arrangement import Arrangement, InputError, families, read_arrangement
from arrangement.pictures.lines import draw_lines
from arrangement.planes.polygon import convex_polygon

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
GRID = st.tuples(st.integers(-3, 3), st.integers(-3, 3))


def side(line, p):
    a, b, c = line
    return (v := a * p[0] + b * p[1] - c) and (1 if v > 0 else -1)


def through(p, q):
    a, b = p[1] - q[1], q[0] - p[0]
    return a, b, a * p[0] + b * p[1]


def crossing(one, two):
    (a, b, c), (d, e, f) = one, two
    det = a * e - b * d
    return det and (Fraction(c * e - b * f, det), Fraction(a * f - c * d, det))


def hull(points):
    """Corners in order, by gift wrapping in integers; none of them between two others."""
    points, corners = sorted(set(points)), []
    if len(points) < 3 or not any(side(through(*points[:2]), p) for p in points):
        return []
    here = points[0]
    while not corners or here != corners[0]:
        corners.append(here)
        best = next(p for p in points if p != here)
        for p in points:
            turn = side(through(here, best), p)
            far = abs(p[0] - here[0]) + abs(p[1] - here[1])
            if turn < 0 or (not turn and far > abs(best[0] - here[0]) + abs(best[1] - here[1])):
                best = p
        here = best
    return corners


def split(corners, lines):
    """Return the cells of a polygon as corners, by cutting with one line after the other."""
    cells = [[tuple(map(Fraction, p)) for p in corners]]
    for line in lines:
        cut = []
        for cell in cells:
            sides = [side(line, p) for p in cell]
            if not {1, -1} <= set(sides):
                cut.append(cell)
                continue
            halves = {1: [], -1: []}
            for p, q, s, t in zip(
                cell, cell[1:] + cell[:1], sides, sides[1:] + sides[:1], strict=True
            ):
                for way in halves:
                    if s in (way, 0):
                        halves[way].append(p)
                    if s * t < 0:
                        halves[way].append(crossing(line, through(p, q)))
            cut += halves.values()
        cells = cut
    return cells


def edges_of(cell):
    turns = zip(cell[-1:] + cell[:-1], cell, cell[1:] + cell[:1], strict=True)
    return sum(side(through(p, q), r) != 0 for p, q, r in turns)


def expected(corners, lines, cells):
    """Return vertices, edges and cells at the three places, by brute force but for cells inside."""
    lines = {row if row > (0, 0) else tuple(-x for x in row) for row in map(scaled, lines)}
    walls = [through(p, q) for p, q in pairwise([*corners, corners[0]])]
    points = {p for one, two in combinations(lines, 2) if (p := crossing(one, two))}
    place = {p: min(side(wall, p) for wall in walls) for p in points}
    border = {tuple(map(Fraction, p)) for p in corners}
    inner = outer = 0
    for line in lines:
        met = {
            p
            for wall in walls
            if (p := crossing(line, wall)) and min(side(w, p) for w in walls) == 0
        }
        border |= met
        on = [place[p] for p in points if side(line, p) == 0]
        crosses = {side(line, p) for p in corners} >= {1, -1}
        inner += crosses * (1 + on.count(1))
        outer += on.count(-1) + (2 if met else 1)
    vertices, edges = len(points | border), inner + outer + len(border)
    touched = any(side(line, p) == 0 for p in border for line in lines)
    components = 1 if touched or not lines else 2
    faces = 1 + components + edges - vertices - bool(lines)
    on = [*place.values()]
    return (
        (on.count(1), inner, cells),
        (len(border), len(border), 0),
        (on.count(-1), outer, faces - cells),
    )


def scaled(line):
    first = Fraction(next(x for x in line if x))
    return tuple(x / first for x in line)


@st.composite
def cut_polygons(draw):
    corners = hull(draw(st.lists(GRID, min_size=3, max_size=7)))
    assume(corners)
    pairs = draw(st.lists(st.tuples(GRID | st.sampled_from(corners), GRID), max_size=7))
    return corners, [through(p, q) for p, q in pairs if p != q]


class TestPolygon:
    @given(cut_polygons())
    @settings(max_examples=200)
    def test_pieces_are_those_of_brute_force(self, drawn):
        corners, lines = drawn
        planes = Arrangement([x[:2] for x in lines], [x[2] for x in lines], dimension=2)
        cut = planes.pieces(corners)
        cells = split(corners, lines)
        assert tuple(tuple(part[:3]) for part in cut) == expected(corners, lines, len(cells))
        assert cut.inside.bounded_cells == len(cells)
        sides = [*map(edges_of, cells)]
        assert cut.inside.cells_by_edges == {k: sides.count(k) for k in sorted({*sides})}
        if planes.rank == 2:
            unbounded = 2 * len(planes.distinct)
            assert cut.outside.bounded_cells == cut.outside.cells - unbounded
        regions = sorted(face.signs for face in planes.regions(inside=corners))
        for engine in (None, "any-dimension"):
            faces = planes.faces(inside=corners, engine=engine)
            assert faces.f_vector == tuple(cut.inside[:3])
            assert regions == sorted(face.signs for face in faces.of_dimension(2))

    @given(cut_polygons())
    def test_faces_inside_have_their_point_inside(self, drawn):
        corners, lines = drawn
        planes = Arrangement([x[:2] for x in lines], [x[2] for x in lines], dimension=2)
        sides = convex_polygon(corners)
        faces = [*planes.faces(inside=sides)]
        assert faces
        for face in faces:
            assert {*sides.signs_at(face.witness)} == {1}
            assert planes.face_at(face.witness) == face
            assert planes.face_at(face.witness).dimension == face.dimension

    @given(cut_polygons(), st.permutations(range(7)), st.booleans())
    def test_order_and_sides_of_lines_do_not_matter(self, drawn, order, turned):
        corners, lines = drawn
        other = [lines[k] for k in order if k < len(lines)]
        if turned:
            other = [tuple(-2 * x for x in line) for line in other] + other[:1]
        one, two = (
            Arrangement([x[:2] for x in rows], [x[2] for x in rows], dimension=2)
            for rows in (lines, other)
        )
        assert one.pieces(corners) == two.pieces(corners[::-1])

    def test_lines_along_sides_and_at_corners_only_touch(self):
        lines = Arrangement([[1, 0], [1, 1], [1, -1], [1, 0]], [0, 0, 2, 5])
        cut = lines.pieces(SQUARE)
        assert tuple(cut.inside[:4]) == (0, 0, 1, 1)
        assert tuple(cut.boundary[:2]) == (4, 4)
        assert cut.inside.cells_by_edges == {4: 1}

    def test_pieces_of_a_half_plane_are_counted(self):
        cut = Arrangement([[1, 0], [1, 1]], [0, 0]).pieces(Arrangement([[0, 1]], [-1]))
        assert tuple(cut.inside[:4]) == (1, 4, 4, 1)
        assert cut.inside.cells_by_edges == {3: 1}
        assert tuple(cut.outside[:4]) == (0, 2, 3, 0)

    def test_faces_inside_of_a_cube_in_space(self):
        planes = Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, 1]], [0, 0, 5])
        cube = Arrangement(
            [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]], [-1] * 6
        )
        assert planes.faces(inside=cube).f_vector == (0, 1, 4, 4)

    def test_wrong_polygons_are_refused(self):
        lines = Arrangement([[1, 0]])
        for corners, text in (
            ([(0, 0), (1, 0)], "three or more"),
            ([(0, 0), (1, 0), (2, 0)], "convex"),
            ([(0, 0), (2, 0), (1, 1), (2, 2), (0, 2)], "convex"),
            ([(0, 0), (2, 2), (2, 0), (0, 2)], "convex"),
            ([(0, 0), (1, 0), (0, 0)], "again"),
            ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], "R\\^2"),
            (Arrangement([[1, 0], [-1, 0]], [1, 1]), "positive side"),
            (Arrangement([[1, 0, 0]]), "not lines of R\\^2"),
            (5, "inside is 5"),
        ):
            with pytest.raises(InputError, match=text):
                lines.pieces(corners)
        with pytest.raises(InputError, match="not lines of R\\^2"):
            Arrangement([[1, 0, 0]]).pieces(SQUARE)


class TestFamilies:
    def test_diagonals_have_the_published_cells(self):
        """OEIS A007678 and A217745 from n = 3 on; A217746, bounded ones outside."""
        cuts = [families.diagonals(n).pieces(families.polygon(n)) for n in range(3, 13)]
        inside = [1, 4, 11, 24, 50, 80, 154, 220, 375, 444]
        outside = [1, 4, 10, 18, 35, 64, 117, 190, 330, 492]
        assert [cut.inside.cells for cut in cuts] == inside
        assert [cut.outside.cells for cut in cuts] == outside
        assert [cut.outside.bounded_cells for cut in cuts] == [0] * 4 + [7, 24, 63, 120, 242, 384]

    @pytest.mark.parametrize("n", [4, 5, 6, 7, 8, 9, 10, 12, 16])
    def test_pieces_of_diagonals_add_up_to_the_regions_of_their_lines(self, n):
        """Without the sides, which no line crosses, a cell on each side of one is one region."""
        lines = families.diagonals(n)
        cut = lines.pieces(families.polygon(n))
        assert lines.region_count() == cut.inside.cells + cut.outside.cells - n

    def test_lines_of_all_pairs_have_the_published_regions(self):
        """OEIS A345025 from n = 3 on: the lines of sides and diagonals of a regular n-gon."""
        every = [
            len(families.polygon(n).regions()) if n == 3 else
            len(Arrangement(
                [*families.polygon(n).normals, *families.diagonals(n).normals],
                [*families.polygon(n).offsets, *families.diagonals(n).offsets],
            ).regions())
            for n in (3, 4, 5, 6, 8)
        ]  # fmt: skip
        assert every == [7, 16, 36, 72, 232]

    def test_complete_bipartite_has_the_published_cells(self):
        """OEIS A306302 from 1 on."""
        rectangles = [[(0, 0), (1, 0), (1, n), (0, n)] for n in range(1, 7)]
        cuts = [families.complete_bipartite(n + 2).pieces(r) for n, r in enumerate(rectangles)]
        assert [cut.inside.cells for cut in cuts] == [4, 16, 46, 104, 214, 380]

    def test_points_take_irrational_coordinates(self):
        triangle = [(0, 0), (2, 0), (1, sqrt(3))]
        lines = families.lines_through([*triangle, (1, sqrt(3) / 3)])
        assert lines.f_vector == families.lines_through([(0, 0), (3, 0), (0, 3), (1, 1)]).f_vector
        assert lines.pieces(triangle).inside.cells == 6
        assert families.bisectors(triangle).has_common_point
        assert not families.bisectors([*triangle[:2], (1, 2)]).is_central

    def test_wrong_parameters_are_refused(self):
        for make, value in (
            (families.polygon, 2), (families.polygon, "1"), (families.polygon, None),
            (families.diagonals, 2), (families.diagonals, "6"), (families.complete_bipartite, 0),
        ):  # fmt: skip
            with pytest.raises(InputError):
                make(value)


class TestCommand:
    @pytest.fixture
    def files(self, tmp_path, run):
        lines, hexagon = tmp_path / "lines.json", tmp_path / "hexagon.json"
        run("make diagonals --n 6 -o", lines)
        run("make polygon --corners 6 -o", hexagon)
        return lines, hexagon

    def test_count_prints_inside_and_outside(self, files, run):
        text = run("count {} --inside", *files)
        assert "inside: cells           24\n" in text
        assert "outside: bounded cells  0\n" in text
        made = run.json("count {} --inside", *files)
        assert made["inside"]["cells_by_edges"] == {"3": 18, "4": 6}
        assert made["boundary"]["edges"] == 6

    def test_faces_prints_those_inside(self, files, run):
        assert len(run("faces {} --inside {} --dimension 2", *files).splitlines()) == 24

    def test_polygon_file_is_read_as_its_sides(self, tmp_path, run):
        path = tmp_path / "square.json"
        document = {"schema_version": 1, "polygon": [["0", "0"], ["2", "0"], ["2", "2"], [0, 2]]}
        path.write_text(json.dumps(document))
        sides = read_arrangement(path)
        assert sides == convex_polygon(SQUARE)
        assert read_arrangement(sides.to_dict()) == sides
        assert run.json("convert {} --to json", path)["lost"] == ""
        diagonals = {"schema_version": 1, "planes": [[1, 1], [1, -1]], "offsets": [2, 0]}
        (tmp_path / "lines.json").write_text(json.dumps(diagonals))
        printed = run("count {} --inside", tmp_path / "lines.json", path)
        assert "inside: cells           4\n" in printed

    def test_polygon_file_has_numbers_of_a_field(self):
        root3 = {"minimal_polynomial": ["-3", "0", "1"], "interval": ["1", "2"]}
        corners = [["0", "0"], ["2", "0"], ["1", ["0", "1"]]]
        document = {"schema_version": 1, "polygon": corners, "field": root3}
        sides = read_arrangement(document)
        assert sides == convex_polygon([(0, 0), (2, 0), (1, sqrt(3))])
        assert read_arrangement(sides.to_dict()) == sides

    def test_unbounded_inside_is_named(self, files, run):
        assert "inside                  unbounded" in run("count {} --inside", files[0], "x = 0")
        assert "unbounded" not in run("count {} --inside", *files)

    def test_wrong_files_are_refused(self, files, refused):
        refused("count {} --inside braid-a3", files[0])
        refused("faces {} --inside {} --bounded", *files)
        for polygon in ([["0", "0"]], "0,0", [[0, 0], [1, 0], [2, 0]], [[0], [1], [2]]):
            with pytest.raises(InputError):
                read_arrangement({"schema_version": 1, "polygon": polygon})


class TestPicture:
    @pytest.mark.parametrize("n", [4, 5, 6])
    def test_lines_are_whole_inside_and_pale_outside(self, n):
        lines = families.diagonals(n)
        scene = draw_lines.scene(lines, inside=families.polygon(n), labels="none")
        drawn = [item.name for item in scene.items if item.name]
        for kind, count in (("line", len(lines)), ("outside", len(lines)), ("border", n)):
            assert sum(name.startswith(kind) for name in drawn) == count
        cells = lines.pieces(families.polygon(n)).inside.cells
        assert sum(name.startswith("region") for name in drawn) == cells
        assert f"{cells} cells inside; lines are pale outside" in dict(scene.legend.lines)

    def test_parts_inside_end_at_the_polygon(self):
        lines = Arrangement([[1, 0], [1, 0], [0, 1]], [1, 3, 0])
        scene = draw_lines.scene(lines, inside=SQUARE)
        (inner,) = (item for item in scene.items if item.name.startswith("line-"))
        page = scene.maps[0]
        ends = sorted(tuple(round(x, 6) for x in page.back(p)) for p in inner.points)
        assert (inner.name, ends) == ("line-1", [(1, 0), (1, 2)])
        assert [item.name for item in scene.items].count("border") == 4

    def test_choices_that_do_not_go_with_it_are_refused(self):
        lines = families.diagonals(4)
        for options in ({"faces": "all"}, {"projective": True}, {"coordinates": "symmetric"}):
            with pytest.raises(InputError):
                draw_lines.scene(lines, inside=SQUARE, **options)
        with pytest.raises(InputError, match="positive side"):
            draw_lines.scene(lines, inside=Arrangement([[1, 0], [-1, 0]], [1, 1]))

    def test_half_plane_is_shown_with_the_crossings(self):
        half = Arrangement([[0, 1]], [0])
        scene = draw_lines.scene(families.diagonals(6), inside=half, labels="none")
        assert sum(item.name.startswith("region-") for item in scene.items) == 18

    def test_command_reads_the_polygon(self, tmp_path, run, refused):
        polygon = tmp_path / "square.json"
        families.polygon(4).save(polygon)
        families.diagonals(4).save(tmp_path / "lines.json")
        path = tmp_path / "square.svg"
        command = ["draw", str(tmp_path / "lines.json"), "--view", "lines", "-o", str(path)]
        run(*command, "--inside", polygon)
        assert 'id="outside-1"' in path.read_text()
        assert "cannot read" in refused(*command, "--inside", tmp_path / "none.json")

    def test_irrational_lines_are_drawn(self):
        lines = families.diagonals(5)
        scene = draw_lines.scene(lines)
        assert sum(item.name.startswith("line-") for item in scene.items) == 5
