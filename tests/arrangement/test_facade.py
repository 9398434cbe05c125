"""The methods of `Arrangement`, and what answers names that it does not have."""

import difflib
import io

import numpy as np
import pytest

from arrangement import Arrangement, InputError, census, counts, read_arrangement

BRAID = read_arrangement("braid-a3")
LINES = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])


@pytest.mark.parametrize("planes", [BRAID, LINES, Arrangement([], dimension=2)])
def test_enumeration_and_zaslavsky_agree(planes):
    assert planes.region_count() == len(planes.regions()) == len(planes.chambers())
    assert planes.bounded_region_count() == len(planes.bounded_regions())
    assert len(planes.vertices()) == planes.f_vector[0]
    signs = planes.sign_vectors()
    assert signs.shape == (sum(planes.faces().f_vector), len(planes))
    assert {tuple(map(int, row)) for row in signs} == {face.signs for face in planes.faces()}


def test_covectors_are_sign_vectors_of_faces():
    signs = {tuple(map(int, row)) for row in BRAID.sign_vectors()}
    assert BRAID.covectors() == signs
    assert BRAID.topes() == {row for row in signs if all(row)}
    assert BRAID.cocircuits() == {face.signs for face in BRAID.faces(1 + 3 - BRAID.rank)}


def test_arrangement_is_a_sequence_of_hyperplanes():
    assert [*map(str, LINES)] == ["x = 0", "y = 0", "x + y = 1"]
    assert LINES[-1].normal == (1, 1)
    assert LINES[-1].offset == 1
    assert repr(LINES[0]) == "<Hyperplane: x = 0>"
    assert LINES[1:] == Arrangement([[0, 1], [1, 1]], [0, 1])
    assert LINES[:0] == Arrangement([], dimension=2)
    with pytest.raises(IndexError):
        LINES[3]


def test_hyperplanes_are_added_and_united():
    assert Arrangement([[1, 0], [0, 1]]).addition([1, 1], 1) == LINES
    assert LINES[:2].union(LINES[1:]) == LINES[:2] | LINES[1:] == LINES
    with pytest.raises(InputError, match="no union"):
        LINES.union(BRAID)
    with pytest.raises(TypeError):
        LINES | 1


@pytest.mark.parametrize(
    ("planes", "point", "dimension"),
    [
        (BRAID, (0, 0, 0), 0),
        (LINES, None, None),
        (Arrangement([[1, 0, 0], [1, 1, 0]], [1, 2]), (1, 1, 0), 1),
        (Arrangement([], dimension=2), (0, 0), 2),
    ],
)
def test_center_is_the_face_on_all_hyperplanes(planes, point, dimension):
    face = planes.center()
    if point is None:
        assert face is None
    else:
        assert face.witness == point
        assert face.dimension == dimension
        assert not any(planes.sign_vector(face.witness))
    assert planes.is_essential == (planes.rank == planes.dimension)


def test_operations_are_those_of_counts():
    assert LINES.deletion(0) == counts.deletion(LINES, [0])
    assert LINES.restriction(0, 1) == counts.restriction(LINES, [0, 1])
    assert LINES.localization(2) == counts.localization(LINES, [2])
    assert LINES.cone().is_central
    assert LINES.cone().characteristic_polynomial() == counts.characteristic_polynomial(
        counts.cone(LINES)
    )
    assert BRAID.identify().names == census.identify(BRAID).names
    assert len(BRAID.dual().vertices) == BRAID.region_count()


def test_a_saved_arrangement_is_read_back(tmp_path):
    LINES.save(tmp_path / "lines.json")
    assert read_arrangement(tmp_path / "lines.json") == LINES


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("n_regions", "region_count()"),
        ("plot", "draw()"),
        ("chi", "characteristic_polynomial()"),
        ("region", "regions"),
    ],
)
def test_missing_attributes_name_the_nearest(name, hint):
    with pytest.raises(AttributeError, match=rf"no attribute '{name}'; use .*") as error:
        getattr(BRAID, name)
    assert hint in str(error.value)


def test_private_names_get_no_hint(monkeypatch):
    """And no search for one, of which every `copy.copy` would pay."""
    monkeypatch.setattr(difflib, "get_close_matches", lambda *_: pytest.fail("searched"))
    with pytest.raises(AttributeError, match=r"'_ipython_display_'$"):
        BRAID._ipython_display_  # noqa: B018
    assert not hasattr(BRAID, "__array_interface__")
    assert np.array([BRAID], dtype=object).shape[0] == 1


def test_an_error_inside_a_property_is_reported_as_it_is():
    class Broken(Arrangement):
        @property
        def answer(self) -> int:
            return None.nothing  # type: ignore[attr-defined, no-any-return]

    with pytest.raises(AttributeError, match="'NoneType' object has no attribute 'nothing'"):
        Broken([[1]]).answer  # noqa: B018


def test_several_views_are_drawn_as_panels():
    pytest.importorskip("matplotlib")
    made = BRAID.draw("sphere,graph")
    made.savefig(written := io.StringIO(), format="svg")
    assert 'id="panel-2-' in written.getvalue()
    with pytest.raises(InputError, match="did you mean dual"):
        BRAID.draw("sphere,dula")
    with pytest.raises(InputError, match="ax takes one view"):
        BRAID.draw("sphere,graph", ax=made)
