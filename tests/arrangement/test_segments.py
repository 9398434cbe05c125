"""Segments of the plane: the drawing that they make, against brute force over rationals."""

import json
from collections import Counter
from fractions import Fraction
from itertools import combinations, pairwise

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from sympy import sqrt

from arrangement import Arrangement, InputError, Segments, families, read_arrangement, read_segments
from arrangement.pictures.segments import draw_segments
from tests.arrangement.test_pieces import crossing, side, through

POINTS = st.tuples(st.integers(0, 4), st.integers(0, 4))
SEGMENTS = st.lists(st.tuples(POINTS, POINTS).filter(lambda pair: pair[0] != pair[1]), max_size=8)


def between(p, segment):
    (a, b), (c, d) = segment
    return min(a, c) <= p[0] <= max(a, c) and min(b, d) <= p[1] <= max(b, d)


def drawing(segments):
    """Return the graph of the union: its vertices and edges."""
    lines = [through(*pair) for pair in segments]
    points = {tuple(map(Fraction, p)) for pair in segments for p in pair}
    for (i, one), (j, two) in combinations(enumerate(lines), 2):
        p = crossing(one, two)
        if p and between(p, segments[i]) and between(p, segments[j]):
            points.add(p)
    graph = nx.Graph()
    for line, pair in zip(lines, segments, strict=True):
        graph.add_edges_from(
            pairwise(sorted(p for p in points if side(line, p) == 0 and between(p, pair)))
        )
    return graph


def faces(graph):
    """Return the lengths of the boundaries of the faces, walked with the face on the left."""

    def direction(p, q):  # grows with the angle of the way from p to q
        x, y = q[0] - p[0], q[1] - p[1]
        upper = y > 0 or (y == 0 and x > 0)
        share = x / (abs(x) + abs(y))
        return (0, -share) if upper else (1, share)

    around = {p: sorted(graph[p], key=lambda q, p=p: direction(p, q)) for p in graph}
    ways = {(p, q) for p in graph for q in graph[p]}
    walks = []
    while ways:
        start = way = min(ways)
        walk = []
        while True:
            ways.discard(way)
            walk.append(way)
            p, q = way
            ring = around[q]
            way = (q, ring[ring.index(p) - 1])
            if way == start:
                break
        walks.append(walk)
    return walks


def turned(walk):
    """Twice the area that a walk goes around, counter-clockwise."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in walk)


class TestCounts:
    @settings(max_examples=200)
    @given(SEGMENTS)
    def test_pieces_are_those_of_brute_force(self, segments):
        made = Segments(segments).pieces()
        graph = drawing(segments)
        assert (made.vertices, made.edges) == (len(graph), graph.number_of_edges())
        parts = nx.number_connected_components(graph)
        assert made.cells == 1 + parts + made.edges - made.vertices
        assert made.bounded_cells == made.cells - 1
        walks = faces(graph)
        if parts == 1:
            inner = [walk for walk in walks if turned(walk) > 0]
            assert made.cells_by_edges == dict(sorted(Counter(map(len, inner)).items()))
        else:  # boundaries of parts within cells count with these
            assert sum(k * n for k, n in made.cells_by_edges.items()) <= 2 * made.edges

    @given(SEGMENTS, st.randoms(use_true_random=False))
    def test_order_and_ends_do_not_matter(self, segments, random):
        other = [pair[::-1] for pair in segments] + segments[:1]
        random.shuffle(other)
        assert Segments(segments).pieces() == Segments(other).pieces()

    def test_complete_bipartite_drawings_have_the_published_faces(self):
        """OEIS A290131 from n = 1 on."""
        drawings = [
            Segments([((0, i), (1, j)) for i in range(n) for j in range(n)]) for n in range(1, 8)
        ]
        assert [x.pieces().bounded_cells for x in drawings] == [0, 2, 12, 40, 96, 204, 368]
        assert drawings[2].lines == families.complete_bipartite(3)

    def test_sides_and_diagonals_have_the_published_faces(self):
        """OEIS A007678: the complete graph on a regular polygon."""
        for n, cells in ((3, 1), (4, 4), (5, 11), (6, 24)):
            corners = [v.witness for v in families.polygon(n).vertices()]
            corners = [p for p in corners if min(families.polygon(n).signs_at(p)) >= 0]
            assert len(corners) == n
            assert Segments(combinations(corners, 2)).pieces().bounded_cells == cells

    def test_dangling_edges_count_twice_and_islands_are_cells(self):
        square = [((0, 0), (4, 0)), ((4, 0), (4, 4)), ((4, 4), (0, 4)), ((0, 4), (0, 0))]
        inner = [((1, 1), (2, 1)), ((2, 1), (1, 2)), ((1, 2), (1, 1))]
        pieces = Segments([*square, *inner, ((0, 0), (1, "1/2"))]).pieces()
        assert tuple(pieces) == (8, 8, 3, 2, {3: 1, 9: 1})

    def test_overlapping_and_touching_segments_are_one_line(self):
        pieces = Segments([((0, 0), (2, 0)), ((1, 0), (3, 0)), ((3, 0), (5, 0))]).pieces()
        assert tuple(pieces) == (5, 4, 1, 0, {})

    def test_irrational_ends_are_exact(self):
        triangle = [(0, 0), (2, 0), (1, sqrt(3))]
        middles = [(1, 0), ("3/2", sqrt(3) / 2), ("1/2", sqrt(3) / 2)]
        sides = [*combinations(triangle, 2)]
        medians = list(zip(triangle, middles[1:] + middles[:1], strict=True))
        assert tuple(Segments([*sides, *medians]).pieces())[:4] == (7, 12, 7, 6)

    def test_what_is_no_segment_is_refused(self):
        for ends in (
            [((0, 0), (0, 0))], [((0, 0), (1,))], [((0, 0, 0), (1, 0, 0))], [((0, 0),)],
            [((0, 0.5), (1, 0))], "ab", 5, [5],
        ):  # fmt: skip
            with pytest.raises(InputError):
                Segments(ends)
        assert len(Segments([])) == 0
        assert tuple(Segments([]).pieces()) == (0, 0, 1, 0, {})


class TestFiles:
    @given(SEGMENTS)
    def test_documents_come_back(self, segments):
        made = Segments(segments)
        assert read_segments(made.to_dict()) == made
        assert hash(read_segments(made.to_dict())) == hash(made)

    def test_documents_of_a_field_come_back(self):
        made = Segments([((0, 0), (1, sqrt(2))), ((sqrt(2), "1/2"), (1, 1))])
        document = json.loads(json.dumps(made.to_dict()))
        assert read_segments(document) == made
        assert repr(made) == "<Segments: 2 in R^2>"

    def test_each_reader_refuses_the_documents_of_the_other(self):
        segments = Segments([((0, 0), (1, 1))])
        with pytest.raises(InputError, match="holds segments"):
            read_arrangement(segments.to_dict())
        with pytest.raises(InputError, match="read_arrangement takes it"):
            read_segments(Arrangement([[1, 0]]).to_dict())
        for pairs in ("0", [["0", "0"]], [[["0", "0"], ["1", 0.5]]], [[["0", "0"]]]):
            with pytest.raises(InputError):
                read_segments({"schema_version": 1, "segments": pairs})


class TestCommand:
    @pytest.fixture
    def path(self, tmp_path):
        path = tmp_path / "segments.json"
        cross = Segments([((0, 0), (2, 2)), ((0, 2), (2, 0)), ((0, 0), (2, 0))])
        path.write_text(json.dumps(cross.to_dict()))
        return path

    def test_count_prints_the_pieces(self, path, run):
        lines = [line.split() for line in run("count", path).splitlines()]
        assert ["vertices", "5"] in lines
        assert ["bounded", "cells", "1"] in lines
        assert run.json("count", path)["edges"] == 5

    def test_what_is_for_arrangements_is_refused(self, path, tmp_path, refused):
        for words in (
            ["faces {}"],
            ["draw {} --view lines -o", tmp_path / "x.svg"],
            ["draw {} --labels none -o", tmp_path / "x.svg"],
        ):
            refused(words[0], path, *words[1:])
        for option in ("forecast", "inside P", "primes 5", "store F", "time-limit 9", "verified"):
            error = refused(f"count {{}} --{option}", path)
            assert f"--{option.split()[0]} is for arrangements" in error
        assert not (tmp_path / "x.svg").exists()

    def test_draw_writes_a_picture(self, path, tmp_path, run):
        run("draw {} -o", path, tmp_path / "x.svg")
        text = (tmp_path / "x.svg").read_text()
        assert all(f'id="edge-{k}"' in text for k in (1, 2, 3))
        assert 'id="cell-1"' in text
        assert 'id="cell-2"' not in text


def test_picture_has_every_cell_and_vertex():
    segments = Segments([((0, i), (1, j)) for i in range(3) for j in range(3)])
    scene = draw_segments.scene(segments)
    names = Counter(item.name.split("-")[0] for item in scene.items)
    assert (names["cell"], names["edge"], names["vertex"]) == (12, 9, 13)
    assert "13 vertices, 24 edges, 12 bounded cells" in dict(scene.legend.lines)
    with pytest.raises(InputError, match="no segments"):
        draw_segments.scene(Segments([]))
    assert segments.draw(width=60).scene.items


#: Two segments, the second with a name.
NAMED = {
    "schema_version": 1,
    "names": ["", "ell"],
    "segments": [[["0", "0"], ["2", "2"]], [["0", "2"], ["2", "0"]]],
}


class TestNames:
    def test_names_of_files_are_kept(self, tmp_path):
        path = tmp_path / "segments.json"
        path.write_text(json.dumps(NAMED), encoding="utf-8")
        segments = read_segments(path)
        assert segments.names == ("", "ell")
        assert segments.to_dict() == NAMED
        assert segments.lines.names == ("", "ell")
        assert segments.named({1: "m"}).names == ("m", "")

    def test_picture_has_names_and_colours(self, tmp_path, run):
        path = tmp_path / "segments.json"
        path.write_text(json.dumps(NAMED), encoding="utf-8")
        segments = read_segments(path)
        scene = draw_segments.scene(segments, colours="ell=#ff0000:dashed")
        styles = {item.name: item.style for item in scene.items}
        assert styles["edge-1"]["ec"] == "black"
        assert styles["edge-2"]["ec"] == "#ff0000"
        assert styles["edge-2"]["ls"] != "-"
        texts = [item for item in scene.items if getattr(item, "text", "") == "ell"]
        (middle,) = [np.mean(x.points, axis=0) for x in scene.items if x.name == "edge-2"]
        assert np.hypot(*(np.array(texts[0].place) - middle)) == pytest.approx(5)
        words = ["draw", str(path), "--names", "1=m", "--colours", "m=blue", "-o"]
        run(*words, tmp_path / "x.svg")
        with pytest.raises(InputError, match="there are segments 1 to 2"):
            draw_segments.scene(segments, colours={3: "red"})
        with pytest.raises(InputError, match="1 names and 2 segments"):
            Segments(segments.ends, ["a"])
