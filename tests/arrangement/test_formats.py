"""Formats of others: each is read back as it was written, and read as the others write it."""

import itertools
import json
import re
from pathlib import Path

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, strategies as st

from arrangement import (
    Arrangement,
    InputError,
    Segments,
    census,
    counts,
    read_arrangement,
    read_segments,
)
from arrangement.library.census import identify
from arrangement.library.files.table import FORMATS, Entries, read_polygon, text_in_format
from arrangement.planes.equation_text import is_equation

CENTRAL = Arrangement([[1, 0, 0], [0, 1, 0], [2, -3, 5], [-4, 6, -10], ["1/2", "1/3", -1]])
AFFINE = Arrangement([[1, 0], [0, -1], [1, 1], [2, "-1/2"]], [0, "3/2", -4, 7])
FIVE = Arrangement([[1, 0, 0, 0, -1], [0, 1, 0, 0, 0]], [0, 1])
NONE = Arrangement([], dimension=3)
READ_BACK = ("json", "matrix", "polymake", "oscar", "sage", "macaulay2")


def one(name: str, text: str) -> Arrangement:
    (form,) = [next(form for form in FORMATS.values() if form.recognises(text))]
    assert form.name == name
    return Entries(form, text, "the text").only()


@pytest.mark.parametrize(
    ("planes", "name"),
    [
        (planes, name)
        for planes in (CENTRAL, AFFINE, FIVE, NONE)
        for name in READ_BACK
        # An empty matrix has no length; OSCAR's format has no offsets.
        if (len(planes) or name not in ("matrix", "oscar"))
        and (planes.is_central or name != "oscar")
    ],
    ids=str,
)
def test_what_is_written_is_read_back(planes, name, tmp_path):
    path = tmp_path / "planes"
    path.write_text(text_in_format(planes, FORMATS[name]), encoding="utf-8")
    assert read_arrangement(path) == planes


@pytest.mark.parametrize("planes", [AFFINE, FIVE], ids=str)
def test_offsets_refused_for_oscar(planes):
    with pytest.raises(InputError, match="no offsets"):
        text_in_format(planes, FORMATS["oscar"])


def opposite(text: str) -> str:
    return text.translate(str.maketrans("+-", "-+"))


entries = st.integers(-3, 3)
normals = st.tuples(entries, entries, entries).filter(any)


@given(st.lists(normals, min_size=3, max_size=7), st.sampled_from(["chirotope", "topcom"]))
def test_a_chirotope_gets_coordinates_of_that_chirotope(rows, name):
    planes = Arrangement(rows)
    if planes.rank < 3:
        with pytest.raises(InputError, match="chirotopes of rank 3"):
            text_in_format(planes, FORMATS[name])
        return
    found = one(name, text_in_format(planes, FORMATS[name])).chirotope_string()
    assert planes.chirotope_string() in (found, opposite(found))


def test_reverse_lexicographic_order_has_the_last_element_last():
    planes = census.census(6)[7]
    fewer = Arrangement(planes.normals[:5])
    assert planes.chirotope_string().startswith(fewer.chirotope_string())
    values = counts.chirotope(planes)
    assert planes.chirotope_string("lexicographic") == "".join("0+-"[v] for v in values.values())
    assert len(AFFINE.chirotope_string()) == 10


#: In the forms of the manuals: SageMath (hyperplane arrangements), Macaulay2
#: (HyperplaneArrangements, MRDI), polymake (schema data.json; sparse rows as braid_arrangement has
#: them), TOPCOM (chirotopes), and Christ's page.
SAMPLES = {
    "a session of Sage": (
        "sage",
        "sage: H.<u,v> = HyperplaneArrangements(QQ)\n"
        "sage: A = H([(1, 0), 2], [(1, -3), 0],  # normal, constant\n....:       [5, 0, 1]); A\n"
        "Arrangement <u + 2 | v + 5 | u - 3*v>\n",
        Arrangement([[1, 0], [1, -3], [0, 1]], [-2, 0, -5]),
    ),
    "what Sage prints": (
        "sage",
        "H = HyperplaneArrangements(QQ, ('u', 'v'))\nArrangement <2*u - 3/4*v + 1 | v/2 - u>\n",
        Arrangement([[2, "-3/4"], [-1, "1/2"]], [-1, 0]),
    ),
    "what Sage prints, alone": (
        "sage",
        "Arrangement <y | x - y | x + y + 1>\n",
        Arrangement([[0, 1], [1, -1], [1, 1]], [0, 0, -1]),
    ),
    "what Sage prints in four dimensions": (
        "sage",
        "Arrangement <t2 - t3 | t0 - t1 | 2*t10 - 1/2>\n",
        Arrangement([[0, 0, 1, -1, 0], [1, -1, 0, 0, 0], [0, 0, 0, 0, 2]], [0, 0, "1/2"]),
    ),
    "forms that are zero": (
        "equations",
        "x - y\n2x + 3*z - 1 # a remark\n",
        Arrangement([[1, -1, 0], [2, 0, 3]], [0, 1]),
    ),
    "joined in Sage": (
        "sage",
        "H.<u,v> = HyperplaneArrangements(QQ)\nbox = u | v | u - 2 | v - 2\n",
        Arrangement([[1, 0], [0, 1], [1, 0], [0, 1]], [0, 0, 2, 2]),
    ),
    "joined in a session of Sage": (
        "sage",
        "sage: H.<u,v> = HyperplaneArrangements(QQ)\nsage: box = u | v | u-2;  box\n"
        "Arrangement <v | u - 2 | u>\n",
        Arrangement([[1, 0], [0, 1], [1, 0]], [0, 0, 2]),
    ),
    "names and options of Sage": (
        "sage",
        "L = OrderedHyperplaneArrangements(QQ, names='uvw')\nu, v, w = L.gens()\n"
        "A = L(((u-1), (v), u - w), backend='normaliz')\n",
        Arrangement([[1, 0, 0], [0, 1, 0], [1, 0, -1]], [1, 0, 0]),
    ),
    "a file that Sage loads": (
        "sage",
        'print "Loaded"\n\nH.<k1_1, k1_2> = HyperplaneArrangements(QQ)\nA=H([\nk1_2,\n'
        "2*k1_1 - k1_2\n])",
        Arrangement([[0, 1], [2, -1]]),
    ),
    "a list of forms in Sage": (
        "sage",
        "H.<u,v> = HyperplaneArrangements(QQ)\nA = H([u, v, u + v])\n",
        Arrangement([[1, 0], [0, 1], [1, 1]]),
    ),
    "forms of Macaulay2": (
        "macaulay2",
        "R = QQ[a..c]; -- three\nA = arrangement {a, b-c, 2*a+3*c}\n",
        Arrangement([[1, 0, 0], [0, 1, -1], [2, 0, 3]]),
    ),
    "a matrix of Macaulay2": (
        "macaulay2",
        "A = arrangement(matrix {{1,0,1,2}, {0,1,1,-5}}, R)",
        Arrangement([[1, 0], [0, 1], [1, 1], [2, -5]]),
    ),
    "the ring that is named": (
        "macaulay2",
        "S = QQ[x, y, Degrees => {2:1}, Heft => {1}]\nR = QQ[x, y, z]\n"
        "A = arrangement ({x, -(3/2)*x + (1/3)*y - 1}, S)\n",
        Arrangement([[1, 0], ["-3/2", "1/3"]], [0, 1]),
    ),
    "the ring that has the variables": (
        "macaulay2",
        "R = QQ[w,x]; S = QQ[y,z];\nA = arrangement{w, x, w-x}",
        Arrangement([[1, 0], [0, 1], [1, -1]]),
    ),
    "numbered variables": (
        "macaulay2",
        "R = QQ[x_1 .. x_3]\narrangement({x_1 - x_2, x_2 - x_3, x_3 - 1}, R)",
        Arrangement([[1, -1, 0], [0, 1, -1], [0, 0, 1]], [0, 0, 1]),
    ),
    "sparse rows of polymake": (
        "polymake",
        '{"HYPERPLANES": [{"0": "1", "2": "-1"}, {"1": "3/2", "2": "1"}, {"cols": 3}], "_ns": '
        '{"polymake": ["https://polymake.org", "4.6"]}, "N_HYPERPLANES": 2, "_id": "planes", '
        '"_type": "fan::HyperplaneArrangement<Rational>"}',
        Arrangement([[1, 0, -1], [0, "3/2", 1]]),
    ),
    "a matrix of OSCAR": (
        "oscar",
        '{"_ns":{"Oscar":["https://github.com/oscar-system/Oscar.jl","1.4.0"]},"_type":{"name":'
        '"MatElem","params":"a-b"},"data":[["1//2","0"],["3","-4"]],"_refs":{"a-b":{"_type":{'
        '"name":"MatSpace","params":{"_type":"QQField"}},"data":{"ncols":"2","nrows":"2"}}}}',
        Arrangement([["1/2", 0], [3, -4]]),
    ),
    "a matrix as Sage prints it": (
        "matrix",
        "[   1    0 -1/2]\n[   0    3    1]\n",
        Arrangement([[1, 0, "-1/2"], [0, 3, 1]]),
    ),
    "a list of lists": (
        "matrix",
        "[[1,0,0],[0,1,0], (1,1,-2)]",
        Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, -2]]),
    ),
    "commas, remarks, decimals": (
        "matrix",
        "# x, y\n1,0.25\n-2e1, 1  # the second\n",
        Arrangement([[1, "1/4"], [-20, 1]]),
    ),
    "a chirotope of TOPCOM": (
        "topcom",
        "3,3:\n+\n",
        Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]),
    ),
}


@pytest.mark.parametrize(("name", "text", "planes"), SAMPLES.values(), ids=SAMPLES.keys())
def test_what_others_write_is_read(name, text, planes):
    assert one(name, text) == planes


#: What other programs wrote, and the number of regions that they found.
OTHERS = {
    "affine.hyar": ("polymake", 10),
    "sparse.hyar": ("polymake", 30),
    "session.m2": ("macaulay2", 36),
    "written.m2": ("macaulay2", 15),
    "hyperplanes.sage": ("sage", 16),
    "symmetric.tc": ("topcom", 24),
}


@pytest.mark.parametrize(("name", "form", "regions"), [(k, *v) for k, v in OTHERS.items()])
def test_files_of_others_have_the_regions_that_they_say(name, form, regions):
    text = (Path(__file__).parent / "others" / name).read_text(encoding="utf-8")
    found = one(form, text)
    assert counts.region_count(found) == regions
    if form == "polymake":
        said = json.loads(text)
        assert len(found) == said["N_HYPERPLANES"]
        assert regions == said["CHAMBER_DECOMPOSITION"]["N_MAXIMAL_CONES"]
    if form == "topcom":
        given = read_arrangement("braid-a3").chirotope_string("lexicographic")
        assert given == found.chirotope_string("lexicographic") == text.split()[1]


def test_lists_of_finschi_are_read():
    """Columns are bases, read downwards; lines have names."""
    listed = list(census.census(5))
    triples = sorted(itertools.combinations("12345", 3), key=lambda row: row[::-1])
    heads = "".join(f"{'':12}{''.join(digits)}\n" for digits in zip(*triples, strict=True))
    lines = [f"IC(5,3, {k}) = {a.chirotope_string()}" for k, a in enumerate(listed, 1)]
    found = Entries(FORMATS["chirotope"], heads + "\n".join(lines), "the list")
    assert FORMATS["chirotope"].recognises(heads + "\n".join(lines))
    assert [identify(found[k]).type for k in (1, 2, 3, 4)] == [identify(a).type for a in listed]
    assert len(found) == 4


REFUSED = {
    "another field": ("H.<x> = HyperplaneArrangements(GF(5))\nA = H(x)", r"GF\(5\)"),
    "code": ("H.<x> = HyperplaneArrangements(QQ)\nA = H(exit())", "has 'exit'"),
    "a product": ("H.<x,y> = HyperplaneArrangements(QQ)\nA = H(x*y)", "not a linear form"),
    "an unknown variable": ("H.<x> = HyperplaneArrangements(QQ)\nA = H(x, y)", "has 'y'"),
    "division by zero": ("H.<x> = HyperplaneArrangements(QQ)\nA = H(3/0*x)", "zero"),
    "nesting": (f"H.<x> = HyperplaneArrangements(QQ)\nA = H({'[' * 9999}x)", "never closed"),
    "deep lists": (
        f"H.<x> = HyperplaneArrangements(QQ)\nA = H({'[' * 9999}x{']' * 9999})",
        "too deeply",
    ),
    "no ring": ("A = arrangement {x, y}", "no ring"),
    "a finite field": ("R = ZZ/7[x]\nA = arrangement {x}", "ZZ/7"),
    "endless variables": ("R = QQ[x_1..x_999999]\nA = arrangement {x_1}", "999,999 coordinates"),
    "ragged columns": ("A = arrangement matrix {{1,0},{1}}", "one length"),
    "a fan": (
        '{"_ns": {"polymake": []}, "_type": "fan::PolyhedralFan<Rational>"}',
        "PolyhedralFan",
    ),
    "floats of polymake": (
        '{"_ns": {"polymake": []}, "_type": "fan::HyperplaneArrangement<Rational>", '
        '"HYPERPLANES": [[0.5, 1]]}',
        "float",
    ),
    "a support": (
        '{"_ns": {"polymake": []}, "_type": "fan::HyperplaneArrangement<Rational>", '
        '"HYPERPLANES": [["1", "1"]], "SUPPORT": {"INPUT_RAYS": [["1", "0"]]}}',
        "SUPPORT",
    ),
    "not a matrix": ('{"_ns": {"Oscar": []}, "_type": "QQField"}', "not a matrix"),
    "the dual": ("R = QQ[x,y]\nA = dual arrangement {x,y,x-y}", "the dual"),
    "the ring of a matrix": ("R = ZZ/7[x,y]\nA = arrangement(matrix {{1,0},{0,1}}, R)", "ZZ/7"),
    "rank 4": ("5,4:+++++", "rank 3"),
    "a list of rank 4": (f"IC(7,4,1) = {'+' * 35}", "rank 4"),
    "an empty row": (
        '{"_ns": {"polymake": []}, "_type": "fan::HyperplaneArrangement<Rational>", '
        '"HYPERPLANES": [[]], "SUPPORT": {"INEQUALITIES": [["1"]]}}',
        "without entries",
    ),
    "a list in a list": (
        '{"_ns": {"polymake": []}, "_type": "fan::HyperplaneArrangement<Rational>", '
        '"HYPERPLANES": [["1", ["1"]]]}',
        "normal 1",
    ),
    "prose": ("Lines in the plane", "in none of the formats"),
    "a word": ("hello", "in none of the formats"),
    "a decimal alone": ("1e5 x", "in none of the formats"),
    "a script of polymake": (
        'use application "fan";\nmy $H = new HyperplaneArrangement(HYPERPLANES=>[[1,0]]);\n',
        'write save\\(\\$H, "FILE.hyar"\\);',
    ),
    "a name of Sage": ("A = hyperplane_arrangements.Shi(4)", "arrangement make shi makes such"),
    "a wrong length": ("++-+-", "C\\(n, 3\\)"),
    "a loop": ("+000", "element 4"),
    "two bars": ("1 0 | 2 3\n0 1 | 1\n", "several offsets"),
    "several": ("+++-\n++++\n", "there are 2 arrangements; choose one"),
    "other coordinates": ("+++0\n1 0 0\n0 1 0\n1 1 -3\n", "another chirotope"),
    "too few lines": ("+++-\n1 0 0\n0 1 0\n", "expected 3 lines"),
}


@pytest.mark.parametrize(("text", "message"), REFUSED.values(), ids=REFUSED.keys())
def test_what_is_wrong_is_refused(text, message, tmp_path):
    path = tmp_path / "wrong"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message) as caught:
        read_arrangement(path)
    assert len(str(caught.value)) < 600


def test_signs_without_coordinates_are_refused():
    with pytest.raises(InputError, match="no planes have these signs"):
        one("chirotope", "++++++++-+")
    # Pappus's theorem puts the last three points on one line.
    line, other = [(0, 0, 1), (1, 0, 1), (4, 0, 1)], [(0, 1, 1), (2, 1, 1), (3, 1, 1)]
    points = [*line, *other]
    for i, j in ((0, 1), (0, 2), (1, 2)):
        crossed = np.cross(np.cross(line[i], other[j]), np.cross(line[j], other[i]))
        points.append(tuple(crossed.tolist()))
    text = Arrangement(points).chirotope_string()
    assert text[-1] == "0"
    assert one("chirotope", text).chirotope_string() in (text, opposite(text))
    with pytest.raises(InputError, match=r"no (coordinates were found|planes have)"):
        one("chirotope", text[:-1] + "+")


def lines_of_christ(planes: Arrangement, sides: list[int]) -> str:
    """Return an entry of Christ's files, with the signs of some equations changed."""
    rows = zip(planes.normals, planes.offsets, sides, strict=True)
    equations = [f"{s * n[0]} {s * n[1]} {-s * b}" for n, b, s in rows]
    return "\n".join([planes.chirotope_string(), *equations, ""])


@given(st.lists(st.sampled_from([1, -1]), min_size=4, max_size=4), st.booleans())
def test_lines_of_christ_get_the_signs_that_the_chirotope_says(sides, turned):
    text = lines_of_christ(AFFINE, sides)
    if turned:
        text = opposite(text[:10]) + text[10:]
    found = one("christ", text)
    assert found.has_same_planes(AFFINE)
    assert found.chirotope_string() in (text[:10], opposite(text[:10]))


def test_points_of_christ_are_normals():
    found = one("christ", "+++-\n0 0 1 0 0 1 5 5\n".replace("+++-", "++++"))
    assert identify(found).f_vector == (1, 12, 24, 14)
    assert found.chirotope_string() in ("++++", "----")


def test_graphs_have_the_numbers_of_the_arrangement():
    planes = read_arrangement("braid-a3")
    graph = nx.parse_graphml(text_in_format(planes, FORMATS["graphml"]))
    assert (len(graph), graph.number_of_edges()) == (24, 36)
    lattice = nx.parse_graphml(text_in_format(planes, FORMATS["lattice-graphml"]))
    assert sorted(rank for _, rank in lattice.nodes(data="rank")).count(2) == 7
    off = text_in_format(planes, FORMATS["off"]).splitlines()
    assert off[:2] == ["OFF", "24 14 36"]
    assert len({*off[2:26]}) == 24
    assert sum(int(row.split()[0]) for row in off[26:]) == 2 * 36
    dot = text_in_format(AFFINE, FORMATS["dot"])
    assert dot.startswith("graph {")
    assert dot.count(" -- ") == AFFINE.f_vector[-2]
    assert len(re.findall(r"^  [0-9]+ \[", dot, re.M)) == AFFINE.f_vector[-1]
    flats = text_in_format(AFFINE, FORMATS["lattice-dot"])
    assert flats.count("->") == 4 + 2 * 6


def test_convert_goes_by_endings_and_says_what_is_lost(tmp_path, run):
    for ending in (".hyar", ".mrdi", ".sage", ".m2", ".txt", ".json"):
        path = str(tmp_path / f"planes{ending}")
        run("convert braid-a3 -o", path)
        assert read_arrangement(path) == read_arrangement("braid-a3")
    out, err = run("convert braid-a3 --to chirotope"), run.err
    assert out == read_arrangement("braid-a3").chirotope_string() + "\n"
    assert "no coordinates" in err
    assert run.json("convert braid-a3 --to chirotope")["text"] == out
    assert run.json("convert braid-a3 -o", tmp_path / "x.sage")["lost"] == "Sage sorts the planes"
    run("convert paper-three-contacts --to matrix")
    assert "lost in matrix: contacts of the file" in run.err


def test_a_file_of_several_is_listed_and_one_converted(tmp_path, run):
    path = tmp_path / "lines"
    other = Arrangement([[1, 0], [0, 1], [1, 1], [2, -1]], [0, 0, 1, 1])
    path.write_text(
        lines_of_christ(AFFINE, [1] * 4) + lines_of_christ(other, [1] * 4), encoding="utf-8"
    )
    rows = [json.loads(line) for line in run("list {} --from christ --json", path).splitlines()]
    assert [row["number"] for row in rows] == [1, 2]
    assert rows[0]["type"].startswith(f"5.{identify(counts.cone(AFFINE)).type} with line ")
    taken = str(tmp_path / "two.json")
    run("convert {} --from christ --number 2 -o", path, taken)
    assert read_arrangement(taken) == other
    assert run("convert {} --from christ --number 2 --to matrix", path).splitlines()[0] == "1 0 | 0"


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("2*x - y + 1 = 0", [(2, -1, -1)]),
        ("# two\nx = 3/2 y ; 0.5 y = 1 - x", [(2, -3, 0), (2, 1, 2)]),
        ("x1 + x10 = 2 x2\n0 = x2", [(1, -2, 1, 0), (0, -1, 0, 0)]),
        ("z = 1 + x", [(-1, 0, 1, 1)]),
    ],
)
def test_equations_are_read_and_come_back(text, rows, tmp_path):
    path = tmp_path / "a.eqn"
    path.write_text(text)
    found = read_arrangement(path)
    assert list(found.integer_planes) == rows
    path.write_text(FORMATS["equations"].write(found))
    if found.dimension <= 3:
        assert read_arrangement(path) == found


@pytest.mark.parametrize(
    "text", ["x*y = 1", "x = = 2", "2 = 3", "x^2 = 1", "2x+ = 1", "sin(x) = 0", "= x", "2*3*x = 1",
             "x = x", "x + -y = 1", "1/0 x = 1", "2* = x", "x y = 5", "__import__('os') = x",
             "word", "x = 1e3", "x = 1e-3", "2E4y = x", "y = nan", "x = -Inf"],
)  # fmt: skip
def test_what_is_no_linear_equation_is_refused(text, tmp_path):
    path = tmp_path / "a.eqn"
    path.write_text(f"x + y = 1\n{text}\n")
    with pytest.raises(InputError):
        read_arrangement(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x + y = sqrt(2)", r"near '\(2\)'; irrational numbers .* key \"field\""),
        ("x = sqrt(2)*y", "irrational numbers are written in JSON"),
        (
            "# a circle\nx^2 + y^2 = 1",
            "is not linear in rational numbers near .*; write such",
        ),
        ("sin(x) = y\ny = 1", "'sin\\(x\\) = y' is not linear"),
        ("x = 0 red\ny = 0 blue", "near '0 red'"),
        ("2x+3y<=6\nx>=0", "near '<'; write .*, with = alone; .* --inside"),
    ],
)
def test_file_with_equality_signs_is_answered_as_equations(text, message, tmp_path):
    path = tmp_path / "a.txt"
    path.write_text(text)
    with pytest.raises(InputError, match=f"read as equations: .*{message}"):
        read_arrangement(path)


def test_two_equality_signs_are_one(tmp_path):
    (tmp_path / "a.txt").write_text("x + y == 1\nx == 0\n")
    assert read_arrangement(tmp_path / "a.txt") == Arrangement([[1, 1], [1, 0]], [1, 0])


def test_lines_of_equations_are_recognized():
    equations = ["x = 1", "word = 2 x1", "2*word = 1", "x1 - 1/2 y", "ell: x = 1", "ell: x"]
    others = [
        "2 = 3",
        "a b: x",
        "x = = 2",
        "sin(x) = 0",
        "1 2",
        "1",
        "2e5",
        "x y",
        "word",
        "x + word",
    ]
    assert [line for line in [*equations, *others] if is_equation(line)] == equations


@pytest.mark.parametrize(
    "text", ["x = 0; x + y = 1", "x=0, x+y=1", "x = 0\nx + y = 1", "x, x + y - 1", "x; x+y-1"]
)
def test_equations_stand_in_place_of_a_path(text, run):
    assert read_arrangement(text) == Arrangement([[1, 0], [1, 1]], [0, 1])
    assert "planes           2\n" in run("count", text)


@pytest.mark.parametrize("text", ["[[1, 0], [1, 1]]", "((1,0),(1,1))", "[(2, 0), (1/2, 1/2)]"])
def test_normals_stand_in_place_of_a_path(text):
    assert read_arrangement(text) == Arrangement([[1, 0], [1, 1]])


def test_names_of_equations_are_names_of_planes(tmp_path):
    (tmp_path / "a.txt").write_text("ell: x = 0\nx + y = 1\nm : y = 0\n")
    for lines in (
        read_arrangement(tmp_path / "a.txt"),
        read_arrangement("ell: x = 0; x + y = 1; m: y = 0"),
        Arrangement.from_equations(["ell: x = 0", "x + y = 1", "m: y = 0"]),
    ):
        assert lines == Arrangement([[1, 0], [1, 1], [0, 1]], [0, 1, 0])
        assert lines.names == ("ell", "", "m")


def test_file_named_as_an_equation_is_read(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("y=2").write_text("x = 1")
    assert read_arrangement("y=2") == Arrangement([[1, 0]], [1])
    with pytest.raises(InputError, match="cannot read 'n=3"):
        read_arrangement("n=3.json")


def test_texts_as_normals_are_referred_to_equations():
    for text in ("x = 0; y = 0", ["x = 0", "y = 0"]):
        with pytest.raises(InputError, match="from_equations"):
            Arrangement(text)


@pytest.mark.parametrize(
    "text",
    [
        "0,0; 4,0; 0,4",
        "0,0 4,0 0,4",
        "(0,0), (4,0), (0,4)",
        "[[0, 0], [4, 0], [0, 4]]",
        " 0 ,0;4,0;0,4; ",
    ],
)
def test_corners_stand_in_place_of_a_polygon(text):
    triangle = Arrangement([[0, 1], [-1, -1], [1, 0]], [0, -4, 0])
    assert read_polygon(text) == triangle
    with pytest.raises(InputError, match=r"cannot read|normal 1 is the zero vector"):
        read_arrangement(text)


@pytest.mark.parametrize("text", ["0,0/4,0/0,4", "0,0;4;0,4", "1,2", "0,0;1,1;2,2"])
def test_what_is_not_corners_is_refused(text):
    with pytest.raises(InputError, match=r"0,0; 4,0; 0,4|three or more corners|convex"):
        read_polygon(text)


def test_table_of_points_is_a_polygon(tmp_path):
    path = tmp_path / "square.csv"
    path.write_text("# corners\nX, Y\n0,0\n1/2,0\n1/2,0.5\n0,0.5\n")
    assert len(read_arrangement(path).bounded_regions()) == 1
    path.write_text("x,y\n0,0\n1,0,3\n")
    with pytest.raises(InputError, match="'1,0,3' is not x,y"):
        read_arrangement(path)


def test_table_of_ends_has_segments(tmp_path):
    path = tmp_path / "segments.csv"
    path.write_text("x1;y1;x2;y2\n0;0;4;4\n0;4;4;0\n")
    assert read_segments(path) == Segments([((0, 0), (4, 4)), ((0, 4), (4, 0))])
    with pytest.raises(InputError, match="holds segments"):
        read_arrangement(path)


@pytest.mark.parametrize(
    ("text", "equations", "names"),
    [
        ("a,b,c\n1,0,2\n1,1,-1/2\n", "x = 2; x + y = -1/2", []),
        ("name;a;b;c\nfloor;0;1;0\n", "0*x + y = 0", ["floor"]),
        ("A,B,C,D\n0,0,1,3\n", "0*x + 0*y + z = 3", []),
    ],
)
def test_tables_of_coefficients_are_lines_and_planes(text, equations, names, tmp_path):
    path = tmp_path / "lines.csv"
    path.write_text(text)
    read, expected = read_arrangement(path), read_arrangement(equations)
    assert read.integer_planes == expected.integer_planes
    assert list(read.names) == names


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name,a,b,c,color\nl,1,0,2,red\n", "first line, 'name,a,b,c,color', is not one that is"),
        ("1,5;0,5\n0,5;2,5\n", "'1,5;0,5' has commas and semicolons; write decimals with a point"),
        ("a;b;c\n1,5;0;2\n", "'1,5,0,2' is not a,b,c"),
    ],
)
def test_tables_of_planes_that_are_not_read_as_meant_are_refused(text, message, tmp_path):
    path = tmp_path / "lines.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_arrangement(path)
