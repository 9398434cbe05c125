"""What notebooks show of an arrangement: a picture where there is one, else a table."""

from __future__ import annotations

import sys
from xml.etree import ElementTree as ET

import pytest

from arrangement import Arrangement
from arrangement.io.arrangements import read_arrangement

AFFINE = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])


@pytest.mark.parametrize("name", ["four-generic-planes", "braid-a3", "reflection-b3"])
def test_central_planes_of_rank_three_show_their_circles(name: str) -> None:
    planes = read_arrangement(name)
    picture = planes._repr_svg_()
    assert picture is not None
    assert ET.fromstring(picture).tag.endswith("svg")
    assert planes._repr_html_() is None
    assert planes._repr_svg_() == picture


@pytest.mark.parametrize(
    "planes", [AFFINE, read_arrangement("pencil"), Arrangement([], dimension=3)]
)
def test_others_show_a_table_with_their_counts(planes: Arrangement) -> None:
    assert planes._repr_svg_() is None
    page = planes._repr_html_()
    assert page is not None
    cells = [cell.text for cell in ET.fromstring(page).iter("td")]
    assert cells[-len(planes.f_vector) :] == [str(number) for number in planes.f_vector]


def test_many_planes_show_a_table_without_faces() -> None:
    page = Arrangement([[1, k, k * k] for k in range(70)])._repr_html_()
    assert page is not None
    assert "70 (70 distinct), central" in page
    assert "faces" not in page


def test_without_the_library_there_is_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    planes = read_arrangement("four-generic-planes")
    assert planes._repr_svg_() is None
    assert f"<td>{planes.f_vector[3]}</td>" in (planes._repr_html_() or "")
