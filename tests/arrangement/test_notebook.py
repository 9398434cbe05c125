"""What notebooks show of an arrangement: a picture where there is one, else a table."""

import html
import sys
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from arrangement import Arrangement, families, read_arrangement
from arrangement.console.number_form import ReprMixin

AFFINE = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])


@pytest.mark.parametrize(
    "planes",
    [
        read_arrangement("four-generic-planes"),
        read_arrangement("pencil"),
        AFFINE,
        AFFINE.cone(),
        read_arrangement("parallel-planes-affine"),
        Arrangement([[1], [1]], [0, 2]),
        Arrangement([], dimension=3),
        Arrangement([], dimension=0),
        families.braid(5),
        families.braid(6),
        Arrangement([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], [0, 0, 0, 1]),
    ],
    ids=repr,
)
def test_every_rank_shows_a_picture_and_its_counts(planes):
    picture = planes._repr_svg_()
    assert ET.fromstring(picture).tag.endswith("svg")
    image, table = ET.fromstring(planes._repr_html_())
    assert image.get("src").startswith("data:image/svg+xml;base64,")
    if planes.dimension <= 4:
        cells = [cell.text for cell in table.iter("td")]
        assert cells[-len(planes.f_vector) :] == [str(number) for number in planes.f_vector]


def test_many_planes_show_a_table_without_faces():
    page = Arrangement([[1, k, k * k] for k in range(70)])._repr_html_()
    assert "<img" not in page
    assert "70 (70 distinct), central" in page
    assert "faces" not in page


def test_without_the_library_there_is_a_table(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    planes = read_arrangement("four-generic-planes")
    assert planes._repr_svg_() is None
    assert f"<td>{planes.f_vector[3]}</td>" in (planes._repr_html_() or "")


@pytest.mark.parametrize(
    ("row", "text"),
    [
        ((1, Fraction(1, 3)), "(1, 1/3)"),
        (tuple(range(5)), "5 entries"),
        ((True, "a<b"), "(yes, a<b)"),
        ((), ""),
    ],
)
def test_a_value_shows_its_fields_in_one_line_and_in_a_table(row, text):
    @dataclass(frozen=True, repr=False)
    class Some(ReprMixin):
        some_row: tuple[Any, ...]
        then: Callable[[], None] = print

    line, table = repr(Some(row)), Some(row)._repr_html_()
    assert line == (f"<Some: some row {text}>" if text else "<Some>")
    assert "then" not in table
    assert (html.escape(text) if len(row) < 5 else "(0, 1, 2, 3, 4)") in table
    assert len(repr(Some(("x" * 999,)))) < 110
