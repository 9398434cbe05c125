"""The census of types: published numbers, distinctness, proofs of having no coordinates."""

import itertools
import json

import numpy as np
import pytest
import sympy

from arrangement import Arrangement, InputError, cli, families
from arrangement.library.census import (
    MOST_PLANES,
    PSEUDOLINES,
    PUBLISHED,
    PUBLISHED_SIMPLE,
    catalogue,
    census,
    identify,
)
from arrangement.library.census.chirotopes import (
    canonical,
    chirotope_of,
    regions,
    t_vectors,
    triples,
)
from arrangement.library.census.final_polynomials import proves_no_coordinates
from arrangement.library.census.tables import check, table
from tests.census import __main__ as workshop, build, generate


@pytest.mark.parametrize("planes", range(3, MOST_PLANES + 1))
def test_numbers_of_types_are_the_published_ones(planes):
    assert len(census(planes)) == PUBLISHED[planes]
    assert len(census(planes, simple=True)) == PUBLISHED_SIMPLE[planes]


def test_the_generator_makes_the_shipped_list_again():
    made = json.loads(generate.generate(6))["types"]
    shipped = catalogue._document()["types"]
    assert made == {planes: shipped[planes] for planes in made}
    assert list(made) == ["3", "4", "5", "6"]


def test_an_interrupted_run_goes_on_and_gives_the_same_list(tmp_path, monkeypatch):
    whole = generate.generate(5)
    progress = tmp_path / "progress.jsonl"
    extended = generate._extended
    calls = []

    def interrupted(rows):
        calls.append(rows)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return extended(rows)

    monkeypatch.setattr(generate, "_extended", interrupted)
    with pytest.raises(KeyboardInterrupt):
        generate.generate(5, progress)
    with progress.open("a") as stream:
        stream.write('[["cut off')
    assert generate.generate(5, progress) == whole
    assert len(calls) == 4  # two done before, one interrupted and done again


@pytest.mark.parametrize("planes", [2, MOST_PLANES + 1, 5.0, "5", True])
def test_numbers_outside_the_census_are_refused(planes):
    with pytest.raises(InputError, match="3 to 9"):
        census(planes)


def test_types_of_nine_planes_are_made_when_asked_for():
    types = census(9)
    assert len(types) == PUBLISHED[9]
    assert len(census(9, simple=True)) == PUBLISHED_SIMPLE[9]
    for planes in (types[0], types[-1], *types[1000:1003]):
        assert isinstance(planes, Arrangement)
        assert len(planes.distinct) == 9
        assert planes.rank == 3
    assert census(9, simple=True)[0].is_simple
    assert not types[-PUBLISHED_SIMPLE[9] - 1].is_simple
    with pytest.raises(IndexError):
        types[PUBLISHED[9]]


def test_realizable_and_other_types_add_up():
    proofs = catalogue.without_coordinates()
    assert len(census(9)) + len(proofs) == PSEUDOLINES
    signs = np.array([signs for signs, _ in proofs])
    assert len(np.unique(canonical(signs, 9).codes, axis=0)) == len(proofs)
    assert (catalogue.places(signs[::40]) == -1).all()
    names = list(map(tuple, triples(9).tolist()))
    for row, proof in proofs[::5]:
        assert proves_no_coordinates(dict(zip(names, row.tolist(), strict=True)), proof)


def test_perles_type_has_no_rational_normals():
    (place,) = np.flatnonzero(~catalogue.normals(9).any((1, 2)))
    planes = families.perles()
    assert census(9)[place] == planes
    assert (identify(planes).type, identify(planes).names) == (place + 1, ("Perles",))
    x, y, z = sympy.symbols("x y z")
    forced = [
        (0, 1, 0),
        (1, 0, x),
        (1, 1, 1),
        (1, y, 0),
        (0, 1, 1),
        (1, 0, 0),
        (1, 1, 0),
        (1, z, 1),
    ]
    rows = [*forced, (0, 0, 1)]
    zero = triples(9)[catalogue.exact_chirotope(planes) == 0].tolist()
    equations = [sympy.Matrix([rows[k] for k in three]).det() for three in zero]
    assert sympy.groebner(equations, y, z, x).exprs[-1] == x**2 + x - 1


def test_every_type_stands_where_its_code_is_looked_for():
    places = np.linspace(0, PUBLISHED[9] - 1, 60).astype(int)
    assert (catalogue.places(chirotope_of(catalogue.normals(9)[places])) == places).all()


@pytest.mark.slow
def test_extensions_without_coordinates_are_all_in_the_list():
    found = check(3, order=False)
    assert found.holds
    assert (found.proofs, found.parents) == (PSEUDOLINES - PUBLISHED[9], 3)


@pytest.mark.parametrize("planes", [5, 6])
def test_regions_by_points_are_those_that_are_enumerated(planes):
    signs = chirotope_of(catalogue.normals(planes))
    assert regions(signs, planes).tolist() == [a.faces().f_vector[3] for a in census(planes)]
    points = t_vectors(signs, planes).sum(1)
    assert (2 * points).tolist() == [a.faces().f_vector[1] for a in census(planes)]


def test_the_table_of_seven_planes():
    found = table(7)
    assert (found.types, found.simple, found.simplicial) == (143, 11, 2)
    assert sum(found.by_regions.values()) == sum(found.by_points.values()) == 143
    assert found.by_regions[44] == found.by_points[21,] == 11
    assert found.by_points[6, 0, 0, 0, 1] == 1  # the near-pencil


def same(one: build.Arrays, other: build.Arrays) -> bool:
    return all(one[name].tobytes() == other[name].tobytes() for name in one)


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> build.Arrays:
    """Seven planes from so small a box that some need other coordinates of six."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "_SIZE", 4)
        return build.build(str(tmp_path_factory.mktemp("built")), planes=7)


def test_the_builder_finds_all_types_of_seven_planes(built):
    bases = np.concatenate([catalogue.normals(6), built["bases"]])[built["parents"]]
    signs = chirotope_of(np.concatenate([bases, built["vectors"][:, None]], axis=1))
    rows = np.column_stack([regions(signs, 7), canonical(signs, 7).codes]).tolist()
    assert len(rows) == PUBLISHED[7]
    assert all(one < other for one, other in itertools.pairwise(rows))
    assert len(built["bases"]) > 0
    assert len(built["without"]) == 0


def test_an_interrupted_build_goes_on_and_gives_the_same(built, tmp_path, monkeypatch):
    monkeypatch.setattr(build, "_SIZE", 4)
    monkeypatch.setattr(build, "_PART", 5)  # parts do not matter
    extended, calls = build._extended, []

    def interrupted(plan, number):
        calls.append(number)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return extended(plan, number)

    monkeypatch.setattr(build, "_extended", interrupted)
    with pytest.raises(KeyboardInterrupt):
        build.build(str(tmp_path), planes=7)
    assert same(build.build(str(tmp_path), planes=7), built)
    assert calls == [0, 1, 2, 2, 3]  # two done before, one interrupted and done again


def test_the_commands_of_the_census(capsys, tmp_path):
    assert cli.main(["list", "--classes", "6"]) == 0
    assert "17 (published 17)" in capsys.readouterr().out


def test_the_workshop_makes_both_lists(capsys, tmp_path):
    file, text = tmp_path / "six.npz", tmp_path / "five.json"
    assert workshop.main(["6", "-o", str(file)]) == 0
    assert capsys.readouterr().out == "17 types, 0 more without coordinates\n"
    with np.load(file) as arrays:
        assert len(arrays["parents"]) == 17
    assert workshop.main(["5", "-o", str(text)]) == 0
    assert json.loads(text.read_text())["types"]["5"] == catalogue.normals(5).tolist()
    assert workshop.main(["4", "--numbers", "-o", str(file)]) == 0
    with np.load(file) as arrays:
        assert sorted(arrays["of_4"].tolist()) == [1, 2]
    assert workshop.main(["3", "-o", str(file)]) == 2
