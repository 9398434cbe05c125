"""The command paper: every figure and table, beside what the paper prints."""

import re
from pathlib import Path

import pytest

from arrangement.errors import InputError
from proofs_check import ClaimVerdict
from proofs_check.claims import registry
from proofs_check.cli.program import main
from proofs_check.instances import printed
from proofs_check.reports.paper import page, tables
from proofs_check.reports.paper.figures import FIGURES
from proofs_check.reports.paper.tables import (
    COMPUTED,
    MEASURED,
    PRINTED,
    TABLES,
    TableContent,
    stored_times,
)
from tests.drawn import offences


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("paper") / "whole"
    assert main(["paper", "-o", str(place)]) == 0
    return place


@pytest.mark.slow
def test_every_figure_and_table_is_a_file_and_on_the_page(folder):
    assert [f.number for f in FIGURES] == list(map(str, range(1, 8)))
    assert [t.number for t in TABLES] == ["I", "II", "III"]
    assert sorted(path.name for path in folder.iterdir()) == sorted(page.file_names())
    text = (folder / page.PAGE).read_text(encoding="utf-8")
    for part in (*FIGURES, *TABLES):
        assert f'<section id="{part.name}">' in text
        assert (folder / f"{part.name}.pdf").read_bytes().startswith(b"%PDF")
        assert "tikzpicture" in (folder / f"{part.name}.tex").read_text(encoding="utf-8")
    assert text.count("<svg") == 7
    assert not re.search(r"""(?:src|href)=['"]?(?:https?:|//)""", text)


def test_claims_on_the_page_have_no_verdict_that_nobody_checked():
    pictures = {figure.name: "<svg></svg>" for figure in FIGURES}
    contents = {table.name: TableContent(("$f_1$", "a < b"), ()) for table in TABLES}
    text = page.paper_page(pictures, contents, {"title": "A <paper>", "about": "us"})
    for part in (*FIGURES, *TABLES):
        words = text.partition(f'<section id="{part.name}">')[2].partition("</section>")[0]
        assert all(f"<code>{id}</code>" in words for id in part.claims)
        assert not any(f"({verdict.value})" in words for verdict in ClaimVerdict)
    assert "<h1>A &lt;paper&gt;</h1>" in text
    assert "<th><i>f</i><sub>1</sub></th><th>a &lt; b</th>" in text


def test_claims_named_on_the_page_are_claims():
    assert {id for part in (*FIGURES, *TABLES) for id in part.claims} <= set(registry().ids)


@pytest.mark.parametrize("table", TABLES[::2], ids=lambda table: table.name)
def test_result_tables_agree_with_print(table):
    rows = table.content(stored_times()).rows
    assert [row.by for row in rows] == [PRINTED, COMPUTED] * (len(rows) // 2)
    for above, below in zip(rows[::2], rows[1::2], strict=True):
        assert above.cells[3] == below.cells[3]
        assert below.cells[-1] in ("agree", "a solution, too", "a solution, too, one misprint")
    assert sum("misprint" in row.cells[-1] for row in rows) == (table.number == "III")


@pytest.mark.parametrize("most", [5, pytest.param(9, marks=pytest.mark.slow)])
def test_state_table_prints_listed_and_different_states(most, monkeypatch):
    columns = range(2, most + 1)
    counts = {m: printed.STATE_COUNTS[m] for m in columns}
    monkeypatch.setattr(printed, "STATE_COUNTS", counts)
    head, rows = (content := TABLES[1].content(stored_times())).head, content.rows
    assert head[1:] == tuple(map(str, columns))
    assert rows[0].cells[1:] == rows[1].cells[1:] == tuple(map(str, counts.values()))
    assert rows[2].cells[1:] == tuple(str(4 * m * m - 4 * m + 3 - 2 * (m == 2)) for m in columns)
    assert [row.by for row in rows[3:]] == [PRINTED, MEASURED, MEASURED]
    assert stored_times().machine in content.note


def test_times_are_measured_when_asked(monkeypatch):
    times = tables.measured_times([2, 3])
    assert times.machine
    assert [*times.steps] == [*times.enumeration] == [2, 3]
    assert all(t > 0 for t in (*times.steps.values(), *times.enumeration.values()))


@pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: figure.name)
def test_no_label_of_a_figure_covers_another(figure):
    from arrangement.drawing.layout import lay_out
    from arrangement.drawing.output import own_settings

    with own_settings():
        assert not offences(lay_out(figure.scene()))


@pytest.mark.slow
def test_a_second_run_writes_the_same_bytes(folder, run):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    document = run.json("paper -o", folder)
    assert document["files"] == page.file_names()
    assert [*document["tables"]] == ["I", "II", "III"]
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_folder_with_other_files_is_refused(tmp_path, refused):
    (tmp_path / "mine.txt").write_text("mine")
    assert "'mine.txt'" in refused("paper -o", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
    assert "is a file" in refused("paper -o", tmp_path / "mine.txt")


def test_a_failure_leaves_the_old_folder(tmp_path, monkeypatch):
    place = tmp_path / "paper"
    place.mkdir()
    (place / page.PAGE).write_text("old")

    def broken(*_: object) -> str:
        raise InputError("no page")

    monkeypatch.setattr(page, "FIGURES", FIGURES[:0])
    monkeypatch.setattr(page, "TABLES", TABLES[:0])
    monkeypatch.setattr(page, "paper_page", broken)
    with pytest.raises(InputError, match="no page"):
        page.write_paper(place, stored_times(), {})
    assert [path.name for path in tmp_path.iterdir()] == ["paper"]
    assert (place / page.PAGE).read_text() == "old"
